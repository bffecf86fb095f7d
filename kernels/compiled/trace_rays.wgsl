struct type_8 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
    member_4: vec4<f32>,
    member_5: vec4<f32>,
    member_6: array<u32, 4>,
    member_7: vec4<f32>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_27 {
    member: array<f32, 6>,
    member_1: array<u32, 3>,
    member_2: array<u32, 3>,
}

struct type_29 {
    member: array<type_27>,
}

struct type_42 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
}

struct type_43 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_45 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_46 {
    member: type_45,
}

struct type_48 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_53 {
    member: array<type_42>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> nodes: type_19;
@group(0) @binding(2) 
var<storage> triangles: type_23;
@group(0) @binding(3) 
var<storage> attributes: type_29;
@group(0) @binding(4) 
var<storage> surfaces: type_8;
@group(0) @binding(0) 
var<uniform> params: type_46;
@group(0) @binding(5) 
var<storage> rays: type_50;
@group(0) @binding(6) 
var<storage, read_write> hits: type_53;

fn function_() {
    var local: array<u32, 64>;
    var local_1: array<f32, 64>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var phi_248_: bool;
    var phi_258_: u32;
    var phi_261_: bool;
    var phi_272_: u32;
    var phi_402_: f32;
    var phi_410_: f32;
    var phi_418_: f32;
    var phi_2062_: bool;
    var phi_421_: u32;
    var phi_424_: u32;
    var phi_426_: type_42;
    var phi_918_: type_12;
    var phi_921_: type_42;
    var phi_919_: type_12;
    var phi_944_: type_12;
    var phi_1060_: f32;
    var phi_1071_: f32;
    var phi_1082_: f32;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_1099_: bool;
    var phi_1100_: f32;
    var phi_1101_: bool;
    var phi_1120_: f32;
    var phi_1121_: bool;
    var phi_1122_: f32;
    var phi_1123_: bool;
    var phi_1124_: bool;
    var phi_1129_: f32;
    var phi_1130_: bool;
    var phi_1216_: array<f32, 3>;
    var phi_1217_: array<f32, 3>;
    var phi_1218_: array<f32, 3>;
    var phi_1219_: array<f32, 3>;
    var phi_1220_: bool;
    var phi_1221_: array<f32, 3>;
    var phi_1222_: array<f32, 3>;
    var phi_1223_: bool;
    var phi_1224_: bool;
    var phi_1229_: array<f32, 3>;
    var phi_1234_: array<f32, 3>;
    var phi_1433_: f32;
    var phi_1448_: f32;
    var phi_1476_: u32;
    var phi_1486_: u32;
    var phi_1495_: bool;
    var phi_1511_: bool;
    var phi_1512_: bool;
    var phi_1535_: f32;
    var phi_1550_: f32;
    var phi_1578_: u32;
    var phi_1588_: u32;
    var phi_1597_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1695_: bool;
    var phi_1700_: bool;
    var phi_1705_: type_42;
    var phi_1707_: type_42;
    var phi_1709_: bool;
    var phi_1710_: type_42;
    var phi_1712_: bool;
    var phi_1713_: bool;
    var phi_1714_: type_42;
    var phi_1715_: bool;
    var phi_1716_: bool;
    var phi_1717_: bool;
    var phi_1730_: type_42;
    var phi_922_: type_42;
    var phi_2058_: bool;
    var phi_807_: type_43;
    var phi_818_: type_43;
    var phi_829_: type_43;
    var phi_840_: type_43;
    var phi_851_: type_43;
    var phi_873_: u32;
    var phi_891_: u32;
    var phi_909_: u32;
    var phi_2144_: bool;
    var phi_1731_: u32;
    var phi_1732_: u32;
    var phi_427_: type_42;
    var phi_422_: u32;
    var phi_425_: u32;
    var phi_1767_: u32;
    var phi_1768_: u32;
    var phi_1769_: u32;
    var phi_1734_: u32;
    var phi_1736_: u32;
    var phi_1770_: bool;
    var phi_2141_: bool;
    var local_4: bool;
    var phi_2208_: bool;
    var phi_1814_: type_42;
    var local_5: u32;
    var local_6: u32;
    var local_7: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e70 = gid_1;
            let _e73 = arrayLength((&nodes.member));
            let _e82 = arrayLength((&surfaces.member));
            let _e89 = params.member.member;
            let _e93 = (_e70.x + (_e70.y * 2097152u));
            if (_e93 < _e89) {
                if (_e93 < arrayLength((&rays.member))) {
                } else {
                    break;
                }
                let _e99 = rays.member[_e93].member;
                let _e103 = rays.member[_e93].member_1;
                let _e107 = rays.member[_e93].member_2;
                let _e111 = rays.member[_e93].member_3;
                let _e118 = abs(_e107[0]);
                let _e119 = abs(_e107[1]);
                let _e120 = abs(_e107[2]);
                let _e121 = (_e118 > _e119);
                if _e121 {
                    phi_248_ = (_e118 > _e120);
                } else {
                    phi_248_ = (_e119 > _e120);
                }
                let _e125 = phi_248_;
                let _e126 = select(1u, 0u, _e121);
                if _e125 {
                    let _e127 = (_e126 + 1u);
                    phi_258_ = _e127;
                    phi_261_ = select(true, false, (_e127 == 2u));
                } else {
                    phi_258_ = u32();
                    phi_261_ = false;
                }
                let _e131 = phi_258_;
                let _e133 = phi_261_;
                let _e134 = select(true, false, _e125);
                let _e135 = select(_e131, 0u, _e134);
                let _e137 = select(_e133, true, _e134);
                if _e137 {
                    phi_272_ = (_e135 + 1u);
                } else {
                    phi_272_ = 0u;
                }
                let _e140 = phi_272_;
                let _e141 = select(_e131, _e135, _e137);
                let _e142 = select(_e126, select(_e126, 2u, _e134), _e137);
                local_2 = array<f32, 3>(_e107[0], _e107[1], _e107[2]);
                local_3 = array<f32, 3>(_e99[0], _e99[1], _e99[2]);
                let _e145 = (_e142 < 3u);
                if _e145 {
                } else {
                    break;
                }
                let _e147 = local_2[_e142];
                let _e148 = (1f / _e147);
                let _e149 = (_e141 < 3u);
                if _e149 {
                } else {
                    break;
                }
                let _e151 = local_2[_e141];
                let _e152 = (_e151 * _e148);
                let _e153 = (_e140 < 3u);
                if _e153 {
                } else {
                    break;
                }
                let _e155 = local_2[_e140];
                let _e156 = (_e155 * _e148);
                if _e149 {
                } else {
                    break;
                }
                let _e158 = local_3[_e141];
                if _e153 {
                } else {
                    break;
                }
                let _e160 = local_3[_e140];
                if _e145 {
                } else {
                    break;
                }
                let _e162 = local_3[_e142];
                if (0u < _e73) {
                } else {
                    break;
                }
                let _e167 = nodes.member[0u].member_7[0u];
                let _e171 = nodes.member[0u].member_7[1u];
                let _e175 = nodes.member[0u].member_7[2u];
                let _e179 = nodes.member[0u].member_7[3u];
                let _e181 = abs((_e99[0] - _e167));
                let _e183 = abs((_e99[1] - _e171));
                let _e185 = select(_e183, _e181, (_e181 > _e183));
                let _e187 = abs((_e99[2] - _e175));
                let _e191 = ((select(_e187, _e185, (_e185 > _e187)) + _e179) * 0.0000009536743f);
                let _e198 = (_e191 + (abs(_e99[0]) * 0.00000023841858f));
                let _e199 = (_e191 + (abs(_e99[1]) * 0.00000023841858f));
                let _e200 = (_e191 + (abs(_e99[2]) * 0.00000023841858f));
                let _e201 = select(_e119, _e118, _e121);
                let _e203 = select(_e120, _e201, (_e201 > _e120));
                let _e204 = (_e203 * 0.000000000001f);
                let _e205 = (_e99[0] + _e198);
                let _e206 = (_e99[1] + _e199);
                let _e207 = (_e99[2] + _e200);
                let _e208 = (_e99[0] - _e198);
                let _e209 = (_e99[1] - _e199);
                let _e210 = (_e99[2] - _e200);
                if (_e118 > _e204) {
                    phi_402_ = (1f / _e107[0]);
                } else {
                    phi_402_ = (1000000000000f / _e203);
                }
                let _e215 = phi_402_;
                if (_e119 > _e204) {
                    phi_410_ = (1f / _e107[1]);
                } else {
                    phi_410_ = (1000000000000f / _e203);
                }
                let _e220 = phi_410_;
                if (_e120 > _e204) {
                    phi_418_ = (1f / _e107[2]);
                } else {
                    phi_418_ = (1000000000000f / _e203);
                }
                let _e225 = phi_418_;
                local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                local_1 = array<f32, 64>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                phi_2062_ = false;
                phi_421_ = 0u;
                phi_424_ = 0u;
                phi_426_ = type_42(_e111, 4294967295u, 0f, 0f);
                loop {
                    let _e228 = phi_2062_;
                    let _e230 = phi_421_;
                    let _e232 = phi_424_;
                    let _e234 = phi_426_;
                    let _e235 = (_e230 & 15u);
                    let _e237 = (_e230 >> bitcast<u32>(4u));
                    if (_e235 == 0u) {
                        if (_e237 < _e73) {
                        } else {
                            phi_2208_ = true;
                            phi_1814_ = type_42();
                            break;
                        }
                        let _e933 = nodes.member[_e237].member;
                        let _e942 = ((_e933.x - _e205) * _e215);
                        let _e943 = ((_e933.y - _e205) * _e215);
                        let _e944 = ((_e933.z - _e205) * _e215);
                        let _e945 = ((_e933.w - _e205) * _e215);
                        let _e948 = nodes.member[_e237].member_3;
                        let _e957 = ((_e948.x - _e208) * _e215);
                        let _e958 = ((_e948.y - _e208) * _e215);
                        let _e959 = ((_e948.z - _e208) * _e215);
                        let _e960 = ((_e948.w - _e208) * _e215);
                        let _e963 = nodes.member[_e237].member_1;
                        let _e972 = ((_e963.x - _e206) * _e220);
                        let _e973 = ((_e963.y - _e206) * _e220);
                        let _e974 = ((_e963.z - _e206) * _e220);
                        let _e975 = ((_e963.w - _e206) * _e220);
                        let _e978 = nodes.member[_e237].member_4;
                        let _e987 = ((_e978.x - _e209) * _e220);
                        let _e988 = ((_e978.y - _e209) * _e220);
                        let _e989 = ((_e978.z - _e209) * _e220);
                        let _e990 = ((_e978.w - _e209) * _e220);
                        let _e993 = nodes.member[_e237].member_2;
                        let _e1002 = ((_e993.x - _e207) * _e225);
                        let _e1003 = ((_e993.y - _e207) * _e225);
                        let _e1004 = ((_e993.z - _e207) * _e225);
                        let _e1005 = ((_e993.w - _e207) * _e225);
                        let _e1008 = nodes.member[_e237].member_5;
                        let _e1017 = ((_e1008.x - _e210) * _e225);
                        let _e1018 = ((_e1008.y - _e210) * _e225);
                        let _e1019 = ((_e1008.z - _e210) * _e225);
                        let _e1020 = ((_e1008.w - _e210) * _e225);
                        let _e1022 = select(_e957, _e942, (_e942 < _e957));
                        let _e1024 = select(_e958, _e943, (_e943 < _e958));
                        let _e1026 = select(_e959, _e944, (_e944 < _e959));
                        let _e1028 = select(_e960, _e945, (_e945 < _e960));
                        let _e1030 = select(_e987, _e972, (_e972 < _e987));
                        let _e1032 = select(_e988, _e973, (_e973 < _e988));
                        let _e1034 = select(_e989, _e974, (_e974 < _e989));
                        let _e1036 = select(_e990, _e975, (_e975 < _e990));
                        let _e1038 = select(_e1030, _e1022, (_e1022 > _e1030));
                        let _e1040 = select(_e1032, _e1024, (_e1024 > _e1032));
                        let _e1042 = select(_e1034, _e1026, (_e1026 > _e1034));
                        let _e1044 = select(_e1036, _e1028, (_e1028 > _e1036));
                        let _e1046 = select(_e1017, _e1002, (_e1002 < _e1017));
                        let _e1048 = select(_e1018, _e1003, (_e1003 < _e1018));
                        let _e1050 = select(_e1019, _e1004, (_e1004 < _e1019));
                        let _e1052 = select(_e1020, _e1005, (_e1005 < _e1020));
                        let _e1054 = select(_e1046, _e1038, (_e1038 > _e1046));
                        let _e1056 = select(_e1048, _e1040, (_e1040 > _e1048));
                        let _e1058 = select(_e1050, _e1042, (_e1042 > _e1050));
                        let _e1060 = select(_e1052, _e1044, (_e1044 > _e1052));
                        let _e1062 = select(_e103, _e1054, (_e1054 > _e103));
                        let _e1064 = select(_e103, _e1056, (_e1056 > _e103));
                        let _e1066 = select(_e103, _e1058, (_e1058 > _e103));
                        let _e1068 = select(_e103, _e1060, (_e1060 > _e103));
                        let _e1070 = select(_e957, _e942, (_e942 > _e957));
                        let _e1072 = select(_e958, _e943, (_e943 > _e958));
                        let _e1074 = select(_e959, _e944, (_e944 > _e959));
                        let _e1076 = select(_e960, _e945, (_e945 > _e960));
                        let _e1078 = select(_e987, _e972, (_e972 > _e987));
                        let _e1080 = select(_e988, _e973, (_e973 > _e988));
                        let _e1082 = select(_e989, _e974, (_e974 > _e989));
                        let _e1084 = select(_e990, _e975, (_e975 > _e990));
                        let _e1086 = select(_e1078, _e1070, (_e1070 < _e1078));
                        let _e1088 = select(_e1080, _e1072, (_e1072 < _e1080));
                        let _e1090 = select(_e1082, _e1074, (_e1074 < _e1082));
                        let _e1092 = select(_e1084, _e1076, (_e1076 < _e1084));
                        let _e1094 = select(_e1017, _e1002, (_e1002 > _e1017));
                        let _e1096 = select(_e1018, _e1003, (_e1003 > _e1018));
                        let _e1098 = select(_e1019, _e1004, (_e1004 > _e1019));
                        let _e1100 = select(_e1020, _e1005, (_e1005 > _e1020));
                        let _e1102 = select(_e1094, _e1086, (_e1086 < _e1094));
                        let _e1104 = select(_e1096, _e1088, (_e1088 < _e1096));
                        let _e1106 = select(_e1098, _e1090, (_e1090 < _e1098));
                        let _e1108 = select(_e1100, _e1092, (_e1092 < _e1100));
                        let _e1118 = select(340282350000000000000000000000000000000f, _e1062, (_e1062 <= select(_e234.member, _e1102, (_e1102 < _e234.member))));
                        let _e1120 = select(340282350000000000000000000000000000000f, _e1064, (_e1064 <= select(_e234.member, _e1104, (_e1104 < _e234.member))));
                        let _e1122 = select(340282350000000000000000000000000000000f, _e1066, (_e1066 <= select(_e234.member, _e1106, (_e1106 < _e234.member))));
                        let _e1124 = select(340282350000000000000000000000000000000f, _e1068, (_e1068 <= select(_e234.member, _e1108, (_e1108 < _e234.member))));
                        let _e1128 = nodes.member[_e237].member_6[0u];
                        let _e1132 = nodes.member[_e237].member_6[1u];
                        let _e1136 = nodes.member[_e237].member_6[2u];
                        let _e1140 = nodes.member[_e237].member_6[3u];
                        if (_e1120 < _e1118) {
                            phi_807_ = type_43(_e1120, _e1132, _e1118, _e1128);
                        } else {
                            phi_807_ = type_43(_e1118, _e1128, _e1120, _e1132);
                        }
                        let _e1145 = phi_807_;
                        if (_e1124 < _e1122) {
                            phi_818_ = type_43(_e1124, _e1140, _e1122, _e1136);
                        } else {
                            phi_818_ = type_43(_e1122, _e1136, _e1124, _e1140);
                        }
                        let _e1154 = phi_818_;
                        if (_e1154.member < _e1145.member) {
                            phi_829_ = type_43(_e1154.member, _e1154.member_1, _e1145.member, _e1145.member_1);
                        } else {
                            phi_829_ = type_43(_e1145.member, _e1145.member_1, _e1154.member, _e1154.member_1);
                        }
                        let _e1163 = phi_829_;
                        if (_e1154.member_2 < _e1145.member_2) {
                            phi_840_ = type_43(_e1154.member_2, _e1154.member_3, _e1145.member_2, _e1145.member_3);
                        } else {
                            phi_840_ = type_43(_e1145.member_2, _e1145.member_3, _e1154.member_2, _e1154.member_3);
                        }
                        let _e1172 = phi_840_;
                        if (_e1163.member_2 < _e1172.member) {
                            phi_851_ = type_43(_e1163.member_2, _e1163.member_3, _e1172.member, _e1172.member_1);
                        } else {
                            phi_851_ = type_43(_e1172.member, _e1172.member_1, _e1163.member_2, _e1163.member_3);
                        }
                        let _e1181 = phi_851_;
                        if (_e1172.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1187 = (_e232 < 64u);
                            if _e1187 {
                            } else {
                                phi_2208_ = true;
                                phi_1814_ = type_42();
                                break;
                            }
                            local[_e232] = _e1172.member_3;
                            if _e1187 {
                            } else {
                                phi_2208_ = true;
                                phi_1814_ = type_42();
                                break;
                            }
                            local_1[_e232] = _e1172.member_2;
                            phi_873_ = (_e232 + 1u);
                        } else {
                            phi_873_ = _e232;
                        }
                        let _e1192 = phi_873_;
                        if (_e1181.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1194 = (_e1192 < 64u);
                            if _e1194 {
                            } else {
                                phi_2208_ = true;
                                phi_1814_ = type_42();
                                break;
                            }
                            local[_e1192] = _e1181.member_3;
                            if _e1194 {
                            } else {
                                phi_2208_ = true;
                                phi_1814_ = type_42();
                                break;
                            }
                            local_1[_e1192] = _e1181.member_2;
                            phi_891_ = (_e1192 + 1u);
                        } else {
                            phi_891_ = _e1192;
                        }
                        let _e1199 = phi_891_;
                        if (_e1181.member < 340282350000000000000000000000000000000f) {
                            let _e1201 = (_e1199 < 64u);
                            if _e1201 {
                            } else {
                                phi_2208_ = true;
                                phi_1814_ = type_42();
                                break;
                            }
                            local[_e1199] = _e1181.member_1;
                            if _e1201 {
                            } else {
                                phi_2208_ = true;
                                phi_1814_ = type_42();
                                break;
                            }
                            local_1[_e1199] = _e1181.member;
                            phi_909_ = (_e1199 + 1u);
                        } else {
                            phi_909_ = _e1199;
                        }
                        let _e1206 = phi_909_;
                        phi_2144_ = _e228;
                        phi_1731_ = select(0u, _e1163.member_1, (_e1163.member < 340282350000000000000000000000000000000f));
                        phi_1732_ = _e1206;
                        phi_427_ = _e234;
                    } else {
                        phi_918_ = type_12(_e237, (_e237 + _e235));
                        phi_921_ = _e234;
                        loop {
                            let _e242 = phi_918_;
                            let _e244 = phi_921_;
                            local_7 = _e244;
                            if (_e242.member < _e242.member_1) {
                                phi_919_ = type_12((_e242.member + 1u), _e242.member_1);
                                phi_944_ = type_12(1u, _e242.member);
                            } else {
                                phi_919_ = _e242;
                                phi_944_ = type_12(0u, type_12().member_1);
                            }
                            let _e257 = phi_919_;
                            let _e259 = phi_944_;
                            let _e263 = (bitcast<i32>(_e259.member) != 0i);
                            if _e263 {
                                let _e264 = (_e259.member_1 < arrayLength((&triangles.member)));
                                if _e264 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                if _e145 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                let _e268 = triangles.member[_e259.member_1].member[_e142];
                                let _e269 = (_e268 - _e162);
                                if _e145 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                let _e273 = triangles.member[_e259.member_1].member_2[_e142];
                                let _e274 = (_e273 - _e162);
                                if _e145 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                let _e278 = triangles.member[_e259.member_1].member_4[_e142];
                                let _e279 = (_e278 - _e162);
                                if _e149 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                let _e283 = triangles.member[_e259.member_1].member[_e141];
                                let _e286 = ((_e283 - _e158) - (_e152 * _e269));
                                if _e153 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                let _e290 = triangles.member[_e259.member_1].member[_e140];
                                let _e293 = ((_e290 - _e160) - (_e156 * _e269));
                                if _e149 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                let _e297 = triangles.member[_e259.member_1].member_2[_e141];
                                let _e300 = ((_e297 - _e158) - (_e152 * _e274));
                                if _e153 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                let _e304 = triangles.member[_e259.member_1].member_2[_e140];
                                let _e307 = ((_e304 - _e160) - (_e156 * _e274));
                                if _e149 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                let _e311 = triangles.member[_e259.member_1].member_4[_e141];
                                let _e314 = ((_e311 - _e158) - (_e152 * _e279));
                                if _e153 {
                                } else {
                                    phi_2058_ = true;
                                    break;
                                }
                                let _e318 = triangles.member[_e259.member_1].member_4[_e140];
                                let _e321 = ((_e318 - _e160) - (_e156 * _e279));
                                let _e322 = (_e314 * _e307);
                                let _e323 = (_e321 * _e300);
                                if (_e322 != _e323) {
                                    phi_1060_ = (_e322 - _e323);
                                } else {
                                    let _e325 = (_e314 * 4097f);
                                    let _e327 = (_e325 - (_e325 - _e314));
                                    let _e328 = (_e307 * 4097f);
                                    let _e330 = (_e328 - (_e328 - _e307));
                                    let _e331 = (_e314 - _e327);
                                    let _e332 = (_e307 - _e330);
                                    let _e341 = (_e321 * 4097f);
                                    let _e343 = (_e341 - (_e341 - _e321));
                                    let _e344 = (_e300 * 4097f);
                                    let _e346 = (_e344 - (_e344 - _e300));
                                    let _e347 = (_e321 - _e343);
                                    let _e348 = (_e300 - _e346);
                                    phi_1060_ = ((((((_e327 * _e330) - _e322) + (_e327 * _e332)) + (_e331 * _e330)) + (_e331 * _e332)) - (((((_e343 * _e346) - _e323) + (_e343 * _e348)) + (_e347 * _e346)) + (_e347 * _e348)));
                                }
                                let _e360 = phi_1060_;
                                let _e361 = (_e286 * _e321);
                                let _e362 = (_e293 * _e314);
                                if (_e361 != _e362) {
                                    phi_1071_ = (_e361 - _e362);
                                } else {
                                    let _e364 = (_e286 * 4097f);
                                    let _e366 = (_e364 - (_e364 - _e286));
                                    let _e367 = (_e321 * 4097f);
                                    let _e369 = (_e367 - (_e367 - _e321));
                                    let _e370 = (_e286 - _e366);
                                    let _e371 = (_e321 - _e369);
                                    let _e380 = (_e293 * 4097f);
                                    let _e382 = (_e380 - (_e380 - _e293));
                                    let _e383 = (_e314 * 4097f);
                                    let _e385 = (_e383 - (_e383 - _e314));
                                    let _e386 = (_e293 - _e382);
                                    let _e387 = (_e314 - _e385);
                                    phi_1071_ = ((((((_e366 * _e369) - _e361) + (_e366 * _e371)) + (_e370 * _e369)) + (_e370 * _e371)) - (((((_e382 * _e385) - _e362) + (_e382 * _e387)) + (_e386 * _e385)) + (_e386 * _e387)));
                                }
                                let _e399 = phi_1071_;
                                let _e400 = (_e300 * _e293);
                                let _e401 = (_e307 * _e286);
                                if (_e400 != _e401) {
                                    phi_1082_ = (_e400 - _e401);
                                } else {
                                    let _e403 = (_e300 * 4097f);
                                    let _e405 = (_e403 - (_e403 - _e300));
                                    let _e406 = (_e293 * 4097f);
                                    let _e408 = (_e406 - (_e406 - _e293));
                                    let _e409 = (_e300 - _e405);
                                    let _e410 = (_e293 - _e408);
                                    let _e419 = (_e307 * 4097f);
                                    let _e421 = (_e419 - (_e419 - _e307));
                                    let _e422 = (_e286 * 4097f);
                                    let _e424 = (_e422 - (_e422 - _e286));
                                    let _e425 = (_e307 - _e421);
                                    let _e426 = (_e286 - _e424);
                                    phi_1082_ = ((((((_e405 * _e408) - _e400) + (_e405 * _e410)) + (_e409 * _e408)) + (_e409 * _e410)) - (((((_e421 * _e424) - _e401) + (_e421 * _e426)) + (_e425 * _e424)) + (_e425 * _e426)));
                                }
                                let _e438 = phi_1082_;
                                if (_e360 < 0f) {
                                    phi_1100_ = f32();
                                    phi_1101_ = true;
                                } else {
                                    if (_e399 < 0f) {
                                        phi_1098_ = f32();
                                        phi_1099_ = true;
                                    } else {
                                        let _e441 = (_e438 < 0f);
                                        if _e441 {
                                            phi_1097_ = f32();
                                        } else {
                                            phi_1097_ = ((_e360 + _e399) + _e438);
                                        }
                                        let _e445 = phi_1097_;
                                        phi_1098_ = _e445;
                                        phi_1099_ = _e441;
                                    }
                                    let _e447 = phi_1098_;
                                    let _e449 = phi_1099_;
                                    phi_1100_ = _e447;
                                    phi_1101_ = _e449;
                                }
                                let _e451 = phi_1100_;
                                let _e453 = phi_1101_;
                                if _e453 {
                                    if (_e360 > 0f) {
                                        phi_1122_ = f32();
                                        phi_1123_ = true;
                                        phi_1124_ = false;
                                    } else {
                                        let _e455 = (_e399 > 0f);
                                        if _e455 {
                                            phi_1120_ = f32();
                                            phi_1121_ = false;
                                        } else {
                                            phi_1120_ = ((_e360 + _e399) + _e438);
                                            phi_1121_ = select(true, false, (_e438 > 0f));
                                        }
                                        let _e461 = phi_1120_;
                                        let _e463 = phi_1121_;
                                        phi_1122_ = _e461;
                                        phi_1123_ = _e455;
                                        phi_1124_ = _e463;
                                    }
                                    let _e465 = phi_1122_;
                                    let _e467 = phi_1123_;
                                    let _e469 = phi_1124_;
                                    phi_1129_ = _e465;
                                    phi_1130_ = select(_e469, false, _e467);
                                } else {
                                    phi_1129_ = _e451;
                                    phi_1130_ = true;
                                }
                                let _e472 = phi_1129_;
                                let _e474 = phi_1130_;
                                if _e474 {
                                    let _e475 = (_e472 == 0f);
                                    if _e475 {
                                        phi_1218_ = array<f32, 3>();
                                        phi_1219_ = array<f32, 3>();
                                        phi_1220_ = false;
                                    } else {
                                        let _e476 = (_e269 * _e148);
                                        let _e477 = (_e274 * _e148);
                                        let _e478 = (_e279 * _e148);
                                        let _e481 = (1f / ((_e360 + _e399) + _e438));
                                        let _e482 = (_e399 * _e481);
                                        let _e483 = (_e438 * _e481);
                                        let _e489 = ((((_e360 * _e481) * _e476) + (_e482 * _e477)) + (_e483 * _e478));
                                        let _e490 = abs(_e286);
                                        let _e491 = abs(_e300);
                                        let _e493 = select(_e491, _e490, (_e490 > _e491));
                                        let _e494 = abs(_e314);
                                        let _e497 = abs(_e293);
                                        let _e498 = abs(_e307);
                                        let _e500 = select(_e498, _e497, (_e497 > _e498));
                                        let _e501 = abs(_e321);
                                        let _e505 = abs(_e476);
                                        let _e506 = abs(_e477);
                                        let _e508 = select(_e506, _e505, (_e505 > _e506));
                                        let _e509 = abs(_e478);
                                        let _e516 = (((select(_e494, _e493, (_e493 > _e494)) * select(_e501, _e500, (_e500 > _e501))) * select(_e509, _e508, (_e508 > _e509))) <= (abs((_e472 * _e489)) * 256f));
                                        if _e516 {
                                            phi_1216_ = array<f32, 3>(_e489, _e482, _e483);
                                            phi_1217_ = array<f32, 3>();
                                        } else {
                                            let _e518 = (_e314 * 4097f);
                                            let _e520 = (_e518 - (_e518 - _e314));
                                            let _e521 = (_e307 * 4097f);
                                            let _e523 = (_e521 - (_e521 - _e307));
                                            let _e524 = (_e314 - _e520);
                                            let _e525 = (_e307 - _e523);
                                            let _e534 = (_e321 * 4097f);
                                            let _e536 = (_e534 - (_e534 - _e321));
                                            let _e537 = (_e300 * 4097f);
                                            let _e539 = (_e537 - (_e537 - _e300));
                                            let _e540 = (_e321 - _e536);
                                            let _e541 = (_e300 - _e539);
                                            let _e551 = ((_e322 - _e323) + ((((((_e520 * _e523) - _e322) + (_e520 * _e525)) + (_e524 * _e523)) + (_e524 * _e525)) - (((((_e536 * _e539) - _e323) + (_e536 * _e541)) + (_e540 * _e539)) + (_e540 * _e541))));
                                            let _e553 = (_e286 * 4097f);
                                            let _e555 = (_e553 - (_e553 - _e286));
                                            let _e556 = (_e286 - _e555);
                                            let _e565 = (_e293 * 4097f);
                                            let _e567 = (_e565 - (_e565 - _e293));
                                            let _e568 = (_e293 - _e567);
                                            let _e578 = ((_e361 - _e362) + ((((((_e555 * _e536) - _e361) + (_e555 * _e540)) + (_e556 * _e536)) + (_e556 * _e540)) - (((((_e567 * _e520) - _e362) + (_e567 * _e524)) + (_e568 * _e520)) + (_e568 * _e524))));
                                            let _e597 = ((_e400 - _e401) + ((((((_e539 * _e567) - _e400) + (_e539 * _e568)) + (_e541 * _e567)) + (_e541 * _e568)) - (((((_e523 * _e555) - _e401) + (_e523 * _e556)) + (_e525 * _e555)) + (_e525 * _e556))));
                                            let _e600 = (1f / ((_e551 + _e578) + _e597));
                                            let _e601 = (_e578 * _e600);
                                            let _e602 = (_e597 * _e600);
                                            phi_1216_ = array<f32, 3>();
                                            phi_1217_ = array<f32, 3>(((((_e551 * _e600) * _e476) + (_e601 * _e477)) + (_e602 * _e478)), _e601, _e602);
                                        }
                                        let _e612 = phi_1216_;
                                        let _e614 = phi_1217_;
                                        phi_1218_ = _e612;
                                        phi_1219_ = _e614;
                                        phi_1220_ = _e516;
                                    }
                                    let _e616 = phi_1218_;
                                    let _e618 = phi_1219_;
                                    let _e620 = phi_1220_;
                                    phi_1221_ = _e616;
                                    phi_1222_ = _e618;
                                    phi_1223_ = _e475;
                                    phi_1224_ = _e620;
                                } else {
                                    phi_1221_ = array<f32, 3>();
                                    phi_1222_ = array<f32, 3>();
                                    phi_1223_ = true;
                                    phi_1224_ = false;
                                }
                                let _e622 = phi_1221_;
                                let _e624 = phi_1222_;
                                let _e626 = phi_1223_;
                                let _e628 = phi_1224_;
                                if _e626 {
                                    phi_1229_ = array<f32, 3>(-1f, 0f, 0f);
                                } else {
                                    phi_1229_ = _e622;
                                }
                                let _e630 = phi_1229_;
                                if select(_e628, true, _e626) {
                                    phi_1234_ = _e630;
                                } else {
                                    phi_1234_ = _e624;
                                }
                                let _e633 = phi_1234_;
                                if (_e633[0] >= _e103) {
                                    let _e639 = (_e633[0] < _e244.member);
                                    if _e639 {
                                        let _e640 = (_e633[0] >= 0f);
                                        if _e640 {
                                            if _e264 {
                                            } else {
                                                phi_2058_ = true;
                                                break;
                                            }
                                            let _e643 = triangles.member[_e259.member_1].member_3;
                                            if ((_e643 & 1u) == 0u) {
                                                phi_1700_ = true;
                                            } else {
                                                if _e264 {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                let _e648 = triangles.member[_e259.member_1].member_1;
                                                let _e649 = (_e648 * 12u);
                                                if ((256u + _e649) < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 257u) < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 258u) < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                let _e656 = (_e649 + 259u);
                                                if (_e656 < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                let _e659 = surfaces.member[_e656];
                                                if ((_e649 + 260u) < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 261u) < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 262u) < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                let _e666 = (_e649 + 263u);
                                                if (_e666 < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                let _e669 = surfaces.member[_e666];
                                                let _e670 = (_e649 + 264u);
                                                if (_e670 < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                let _e673 = surfaces.member[_e670];
                                                let _e674 = bitcast<f32>(_e673);
                                                let _e675 = (_e649 + 265u);
                                                if (_e675 < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                let _e678 = surfaces.member[_e675];
                                                let _e679 = bitcast<f32>(_e678);
                                                if ((_e649 + 266u) < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 267u) < _e82) {
                                                } else {
                                                    phi_2058_ = true;
                                                    break;
                                                }
                                                if (_e659 == 4294967295u) {
                                                    phi_1695_ = (_e674 < _e679);
                                                } else {
                                                    if (_e259.member_1 < arrayLength((&attributes.member))) {
                                                    } else {
                                                        phi_2058_ = true;
                                                        break;
                                                    }
                                                    let _e687 = ((1f - _e633[1]) - _e633[2]);
                                                    let _e691 = attributes.member[_e259.member_1].member[0u];
                                                    let _e696 = attributes.member[_e259.member_1].member[2u];
                                                    let _e702 = attributes.member[_e259.member_1].member[4u];
                                                    let _e704 = (((_e691 * _e687) + (_e696 * _e633[1])) + (_e702 * _e633[2]));
                                                    let _e708 = attributes.member[_e259.member_1].member[1u];
                                                    let _e713 = attributes.member[_e259.member_1].member[3u];
                                                    let _e719 = attributes.member[_e259.member_1].member[5u];
                                                    let _e721 = (((_e708 * _e687) + (_e713 * _e633[1])) + (_e719 * _e633[2]));
                                                    let _e722 = (_e669 & 65535u);
                                                    let _e724 = (_e669 >> bitcast<u32>(16i));
                                                    let _e727 = ((_e659 >> bitcast<u32>(28u)) & 3u);
                                                    let _e728 = (_e722 - 1u);
                                                    let _e730 = select(1f, 2f, (_e727 == 2u));
                                                    let _e734 = (_e704 - (floor((_e704 / _e730)) * _e730));
                                                    if (_e734 > 1f) {
                                                        phi_1433_ = (_e730 - _e734);
                                                    } else {
                                                        phi_1433_ = _e734;
                                                    }
                                                    let _e738 = phi_1433_;
                                                    if (_e727 == 1u) {
                                                        let _e741 = select(0f, _e704, (_e704 > 0f));
                                                        phi_1448_ = select(1f, _e741, (_e741 < 1f));
                                                    } else {
                                                        phi_1448_ = _e738;
                                                    }
                                                    let _e745 = phi_1448_;
                                                    let _e752 = ((select(0f, _e745, (abs((_e745 - 0.5f)) <= 0.5f)) * f32(_e722)) - 0.5f);
                                                    let _e753 = floor(_e752);
                                                    let _e754 = (_e753 < 0f);
                                                    if _e754 {
                                                        phi_1476_ = 0u;
                                                    } else {
                                                        let _e759 = select(select(u32(_e753), 0u, (_e753 < 0f)), 4294967295u, (_e753 > 4294967000f));
                                                        phi_1476_ = select(_e759, _e728, (_e728 < _e759));
                                                    }
                                                    let _e763 = phi_1476_;
                                                    if _e754 {
                                                        phi_1486_ = 0u;
                                                    } else {
                                                        let _e764 = (_e763 + 1u);
                                                        phi_1486_ = select(_e764, _e728, (_e728 < _e764));
                                                    }
                                                    let _e768 = phi_1486_;
                                                    let _e769 = (_e727 == 0u);
                                                    if _e769 {
                                                        phi_1495_ = select(true, false, _e754);
                                                    } else {
                                                        phi_1495_ = true;
                                                    }
                                                    let _e772 = phi_1495_;
                                                    let _e773 = select(_e728, _e763, _e772);
                                                    if _e769 {
                                                        if _e754 {
                                                            phi_1511_ = true;
                                                        } else {
                                                            phi_1511_ = select(true, false, (_e773 == _e728));
                                                        }
                                                        let _e777 = phi_1511_;
                                                        phi_1512_ = _e777;
                                                    } else {
                                                        phi_1512_ = true;
                                                    }
                                                    let _e779 = phi_1512_;
                                                    let _e780 = select(0u, _e768, _e779);
                                                    let _e781 = (_e752 - _e753);
                                                    let _e784 = ((_e659 >> bitcast<u32>(30u)) & 3u);
                                                    let _e785 = (_e724 - 1u);
                                                    let _e787 = select(1f, 2f, (_e784 == 2u));
                                                    let _e791 = (_e721 - (floor((_e721 / _e787)) * _e787));
                                                    if (_e791 > 1f) {
                                                        phi_1535_ = (_e787 - _e791);
                                                    } else {
                                                        phi_1535_ = _e791;
                                                    }
                                                    let _e795 = phi_1535_;
                                                    if (_e784 == 1u) {
                                                        let _e798 = select(0f, _e721, (_e721 > 0f));
                                                        phi_1550_ = select(1f, _e798, (_e798 < 1f));
                                                    } else {
                                                        phi_1550_ = _e795;
                                                    }
                                                    let _e802 = phi_1550_;
                                                    let _e809 = ((select(0f, _e802, (abs((_e802 - 0.5f)) <= 0.5f)) * f32(_e724)) - 0.5f);
                                                    let _e810 = floor(_e809);
                                                    let _e811 = (_e810 < 0f);
                                                    if _e811 {
                                                        phi_1578_ = 0u;
                                                    } else {
                                                        let _e816 = select(select(u32(_e810), 0u, (_e810 < 0f)), 4294967295u, (_e810 > 4294967000f));
                                                        phi_1578_ = select(_e816, _e785, (_e785 < _e816));
                                                    }
                                                    let _e820 = phi_1578_;
                                                    if _e811 {
                                                        phi_1588_ = 0u;
                                                    } else {
                                                        let _e821 = (_e820 + 1u);
                                                        phi_1588_ = select(_e821, _e785, (_e785 < _e821));
                                                    }
                                                    let _e825 = phi_1588_;
                                                    let _e826 = (_e784 == 0u);
                                                    if _e826 {
                                                        phi_1597_ = select(true, false, _e811);
                                                    } else {
                                                        phi_1597_ = true;
                                                    }
                                                    let _e829 = phi_1597_;
                                                    let _e830 = select(_e785, _e820, _e829);
                                                    if _e826 {
                                                        if _e811 {
                                                            phi_1613_ = true;
                                                        } else {
                                                            phi_1613_ = select(true, false, (_e830 == _e785));
                                                        }
                                                        let _e834 = phi_1613_;
                                                        phi_1614_ = _e834;
                                                    } else {
                                                        phi_1614_ = true;
                                                    }
                                                    let _e836 = phi_1614_;
                                                    let _e838 = (_e809 - _e810);
                                                    let _e839 = (_e659 & 268435455u);
                                                    let _e841 = (_e839 + (_e830 * _e722));
                                                    let _e843 = (_e839 + (select(0u, _e825, _e836) * _e722));
                                                    let _e844 = (_e841 + _e773);
                                                    let _e845 = (_e841 + _e780);
                                                    let _e846 = (_e843 + _e773);
                                                    let _e847 = (_e843 + _e780);
                                                    if (_e844 < _e82) {
                                                    } else {
                                                        phi_2058_ = true;
                                                        break;
                                                    }
                                                    let _e850 = surfaces.member[_e844];
                                                    if (_e845 < _e82) {
                                                    } else {
                                                        phi_2058_ = true;
                                                        break;
                                                    }
                                                    let _e853 = surfaces.member[_e845];
                                                    if (_e846 < _e82) {
                                                    } else {
                                                        phi_2058_ = true;
                                                        break;
                                                    }
                                                    let _e856 = surfaces.member[_e846];
                                                    if (_e847 < _e82) {
                                                    } else {
                                                        phi_2058_ = true;
                                                        break;
                                                    }
                                                    let _e859 = surfaces.member[_e847];
                                                    let _e876 = (1f - _e781);
                                                    phi_1695_ = ((_e674 * (((((f32((_e850 >> bitcast<u32>(24i))) * 0.003921569f) * _e876) + ((f32((_e853 >> bitcast<u32>(24i))) * 0.003921569f) * _e781)) * (1f - _e838)) + ((((f32((_e856 >> bitcast<u32>(24i))) * 0.003921569f) * _e876) + ((f32((_e859 >> bitcast<u32>(24i))) * 0.003921569f) * _e781)) * _e838))) < _e679);
                                                }
                                                let _e891 = phi_1695_;
                                                phi_1700_ = select(true, false, _e891);
                                            }
                                            let _e894 = phi_1700_;
                                            if _e894 {
                                                phi_1705_ = type_42(_e633[0], _e259.member_1, _e633[1], _e633[2]);
                                            } else {
                                                phi_1705_ = type_42();
                                            }
                                            let _e897 = phi_1705_;
                                            phi_1707_ = _e897;
                                            phi_1709_ = select(true, false, _e894);
                                        } else {
                                            phi_1707_ = type_42();
                                            phi_1709_ = false;
                                        }
                                        let _e900 = phi_1707_;
                                        let _e902 = phi_1709_;
                                        phi_1710_ = _e900;
                                        phi_1712_ = select(true, false, _e640);
                                        phi_1713_ = _e902;
                                    } else {
                                        phi_1710_ = type_42();
                                        phi_1712_ = false;
                                        phi_1713_ = false;
                                    }
                                    let _e905 = phi_1710_;
                                    let _e907 = phi_1712_;
                                    let _e909 = phi_1713_;
                                    phi_1714_ = _e905;
                                    phi_1715_ = select(true, false, _e639);
                                    phi_1716_ = _e907;
                                    phi_1717_ = _e909;
                                } else {
                                    phi_1714_ = type_42();
                                    phi_1715_ = true;
                                    phi_1716_ = false;
                                    phi_1717_ = false;
                                }
                                let _e912 = phi_1714_;
                                let _e914 = phi_1715_;
                                let _e916 = phi_1716_;
                                let _e918 = phi_1717_;
                                if select(select(_e918, false, _e914), true, select(_e916, true, _e914)) {
                                    phi_1730_ = _e244;
                                } else {
                                    phi_1730_ = _e912;
                                }
                                let _e923 = phi_1730_;
                                phi_922_ = _e923;
                            } else {
                                phi_922_ = type_42();
                            }
                            let _e925 = phi_922_;
                            continue;
                            continuing {
                                phi_918_ = _e257;
                                phi_921_ = _e925;
                                phi_2058_ = _e228;
                                break if !(_e263);
                            }
                        }
                        let _e928 = phi_2058_;
                        phi_2208_ = _e928;
                        phi_1814_ = type_42();
                        if _e928 {
                            break;
                        }
                        phi_2144_ = _e928;
                        phi_1731_ = 0u;
                        phi_1732_ = _e232;
                        let _e1344 = local_7;
                        phi_427_ = _e1344;
                    }
                    let _e1210 = phi_2144_;
                    let _e1212 = phi_1731_;
                    let _e1214 = phi_1732_;
                    let _e1216 = phi_427_;
                    phi_422_ = _e1212;
                    phi_425_ = _e1214;
                    loop {
                        let _e1218 = phi_422_;
                        let _e1220 = phi_425_;
                        local_5 = _e1218;
                        local_6 = _e1220;
                        let _e1221 = (_e1218 == 0u);
                        local_4 = _e1221;
                        if _e1221 {
                            let _e1222 = (_e1220 > 0u);
                            if _e1222 {
                                let _e1223 = (_e1220 - 1u);
                                let _e1224 = (_e1223 < 64u);
                                if _e1224 {
                                } else {
                                    phi_2141_ = true;
                                    break;
                                }
                                let _e1226 = local_1[_e1223];
                                if (_e1226 <= _e1216.member) {
                                    if _e1224 {
                                    } else {
                                        phi_2141_ = true;
                                        break;
                                    }
                                    let _e1230 = local[_e1223];
                                    phi_1767_ = _e1230;
                                } else {
                                    phi_1767_ = _e1218;
                                }
                                let _e1232 = phi_1767_;
                                phi_1768_ = _e1232;
                                phi_1769_ = _e1223;
                            } else {
                                phi_1768_ = u32();
                                phi_1769_ = u32();
                            }
                            let _e1234 = phi_1768_;
                            let _e1236 = phi_1769_;
                            phi_1734_ = _e1234;
                            phi_1736_ = _e1236;
                            phi_1770_ = _e1222;
                        } else {
                            phi_1734_ = u32();
                            phi_1736_ = u32();
                            phi_1770_ = false;
                        }
                        let _e1238 = phi_1734_;
                        let _e1240 = phi_1736_;
                        let _e1242 = phi_1770_;
                        continue;
                        continuing {
                            phi_422_ = _e1238;
                            phi_425_ = _e1240;
                            phi_2141_ = _e1210;
                            break if !(_e1242);
                        }
                    }
                    let _e1245 = phi_2141_;
                    phi_2208_ = _e1245;
                    phi_1814_ = type_42();
                    if _e1245 {
                        break;
                    }
                    let _e1247 = local_4;
                    continue;
                    continuing {
                        phi_2062_ = _e1245;
                        let _e1267 = local_5;
                        phi_421_ = _e1267;
                        let _e1270 = local_6;
                        phi_424_ = _e1270;
                        phi_426_ = _e1216;
                        phi_2208_ = _e1245;
                        phi_1814_ = _e1216;
                        break if !(select(true, false, _e1247));
                    }
                }
                let _e1251 = phi_2208_;
                let _e1253 = phi_1814_;
                if _e1251 {
                    break;
                }
                if (_e93 < arrayLength((&hits.member))) {
                } else {
                    break;
                }
                hits.member[_e93] = _e1253;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_rays(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
