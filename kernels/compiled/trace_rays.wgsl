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
    var phi_2076_: bool;
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
    var phi_1458_: bool;
    var phi_1483_: u32;
    var phi_1493_: u32;
    var phi_1502_: bool;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1542_: f32;
    var phi_1557_: f32;
    var phi_1567_: bool;
    var phi_1592_: u32;
    var phi_1602_: u32;
    var phi_1611_: bool;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1709_: bool;
    var phi_1714_: bool;
    var phi_1719_: type_42;
    var phi_1721_: type_42;
    var phi_1723_: bool;
    var phi_1724_: type_42;
    var phi_1726_: bool;
    var phi_1727_: bool;
    var phi_1728_: type_42;
    var phi_1729_: bool;
    var phi_1730_: bool;
    var phi_1731_: bool;
    var phi_1744_: type_42;
    var phi_922_: type_42;
    var phi_2072_: bool;
    var phi_807_: type_43;
    var phi_818_: type_43;
    var phi_829_: type_43;
    var phi_840_: type_43;
    var phi_851_: type_43;
    var phi_873_: u32;
    var phi_891_: u32;
    var phi_909_: u32;
    var phi_2162_: bool;
    var phi_1745_: u32;
    var phi_1746_: u32;
    var phi_427_: type_42;
    var phi_422_: u32;
    var phi_425_: u32;
    var phi_1781_: u32;
    var phi_1782_: u32;
    var phi_1783_: u32;
    var phi_1748_: u32;
    var phi_1750_: u32;
    var phi_1784_: bool;
    var phi_2159_: bool;
    var local_4: bool;
    var phi_2226_: bool;
    var phi_1828_: type_42;
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
                phi_2076_ = false;
                phi_421_ = 0u;
                phi_424_ = 0u;
                phi_426_ = type_42(_e111, 4294967295u, 0f, 0f);
                loop {
                    let _e228 = phi_2076_;
                    let _e230 = phi_421_;
                    let _e232 = phi_424_;
                    let _e234 = phi_426_;
                    let _e235 = (_e230 & 15u);
                    let _e237 = (_e230 >> bitcast<u32>(4u));
                    if (_e235 == 0u) {
                        if (_e237 < _e73) {
                        } else {
                            phi_2226_ = true;
                            phi_1828_ = type_42();
                            break;
                        }
                        let _e937 = nodes.member[_e237].member;
                        let _e946 = ((_e937.x - _e205) * _e215);
                        let _e947 = ((_e937.y - _e205) * _e215);
                        let _e948 = ((_e937.z - _e205) * _e215);
                        let _e949 = ((_e937.w - _e205) * _e215);
                        let _e952 = nodes.member[_e237].member_3;
                        let _e961 = ((_e952.x - _e208) * _e215);
                        let _e962 = ((_e952.y - _e208) * _e215);
                        let _e963 = ((_e952.z - _e208) * _e215);
                        let _e964 = ((_e952.w - _e208) * _e215);
                        let _e967 = nodes.member[_e237].member_1;
                        let _e976 = ((_e967.x - _e206) * _e220);
                        let _e977 = ((_e967.y - _e206) * _e220);
                        let _e978 = ((_e967.z - _e206) * _e220);
                        let _e979 = ((_e967.w - _e206) * _e220);
                        let _e982 = nodes.member[_e237].member_4;
                        let _e991 = ((_e982.x - _e209) * _e220);
                        let _e992 = ((_e982.y - _e209) * _e220);
                        let _e993 = ((_e982.z - _e209) * _e220);
                        let _e994 = ((_e982.w - _e209) * _e220);
                        let _e997 = nodes.member[_e237].member_2;
                        let _e1006 = ((_e997.x - _e207) * _e225);
                        let _e1007 = ((_e997.y - _e207) * _e225);
                        let _e1008 = ((_e997.z - _e207) * _e225);
                        let _e1009 = ((_e997.w - _e207) * _e225);
                        let _e1012 = nodes.member[_e237].member_5;
                        let _e1021 = ((_e1012.x - _e210) * _e225);
                        let _e1022 = ((_e1012.y - _e210) * _e225);
                        let _e1023 = ((_e1012.z - _e210) * _e225);
                        let _e1024 = ((_e1012.w - _e210) * _e225);
                        let _e1026 = select(_e961, _e946, (_e946 < _e961));
                        let _e1028 = select(_e962, _e947, (_e947 < _e962));
                        let _e1030 = select(_e963, _e948, (_e948 < _e963));
                        let _e1032 = select(_e964, _e949, (_e949 < _e964));
                        let _e1034 = select(_e991, _e976, (_e976 < _e991));
                        let _e1036 = select(_e992, _e977, (_e977 < _e992));
                        let _e1038 = select(_e993, _e978, (_e978 < _e993));
                        let _e1040 = select(_e994, _e979, (_e979 < _e994));
                        let _e1042 = select(_e1034, _e1026, (_e1026 > _e1034));
                        let _e1044 = select(_e1036, _e1028, (_e1028 > _e1036));
                        let _e1046 = select(_e1038, _e1030, (_e1030 > _e1038));
                        let _e1048 = select(_e1040, _e1032, (_e1032 > _e1040));
                        let _e1050 = select(_e1021, _e1006, (_e1006 < _e1021));
                        let _e1052 = select(_e1022, _e1007, (_e1007 < _e1022));
                        let _e1054 = select(_e1023, _e1008, (_e1008 < _e1023));
                        let _e1056 = select(_e1024, _e1009, (_e1009 < _e1024));
                        let _e1058 = select(_e1050, _e1042, (_e1042 > _e1050));
                        let _e1060 = select(_e1052, _e1044, (_e1044 > _e1052));
                        let _e1062 = select(_e1054, _e1046, (_e1046 > _e1054));
                        let _e1064 = select(_e1056, _e1048, (_e1048 > _e1056));
                        let _e1066 = select(_e103, _e1058, (_e1058 > _e103));
                        let _e1068 = select(_e103, _e1060, (_e1060 > _e103));
                        let _e1070 = select(_e103, _e1062, (_e1062 > _e103));
                        let _e1072 = select(_e103, _e1064, (_e1064 > _e103));
                        let _e1074 = select(_e961, _e946, (_e946 > _e961));
                        let _e1076 = select(_e962, _e947, (_e947 > _e962));
                        let _e1078 = select(_e963, _e948, (_e948 > _e963));
                        let _e1080 = select(_e964, _e949, (_e949 > _e964));
                        let _e1082 = select(_e991, _e976, (_e976 > _e991));
                        let _e1084 = select(_e992, _e977, (_e977 > _e992));
                        let _e1086 = select(_e993, _e978, (_e978 > _e993));
                        let _e1088 = select(_e994, _e979, (_e979 > _e994));
                        let _e1090 = select(_e1082, _e1074, (_e1074 < _e1082));
                        let _e1092 = select(_e1084, _e1076, (_e1076 < _e1084));
                        let _e1094 = select(_e1086, _e1078, (_e1078 < _e1086));
                        let _e1096 = select(_e1088, _e1080, (_e1080 < _e1088));
                        let _e1098 = select(_e1021, _e1006, (_e1006 > _e1021));
                        let _e1100 = select(_e1022, _e1007, (_e1007 > _e1022));
                        let _e1102 = select(_e1023, _e1008, (_e1008 > _e1023));
                        let _e1104 = select(_e1024, _e1009, (_e1009 > _e1024));
                        let _e1106 = select(_e1098, _e1090, (_e1090 < _e1098));
                        let _e1108 = select(_e1100, _e1092, (_e1092 < _e1100));
                        let _e1110 = select(_e1102, _e1094, (_e1094 < _e1102));
                        let _e1112 = select(_e1104, _e1096, (_e1096 < _e1104));
                        let _e1122 = select(340282350000000000000000000000000000000f, _e1066, (_e1066 <= select(_e234.member, _e1106, (_e1106 < _e234.member))));
                        let _e1124 = select(340282350000000000000000000000000000000f, _e1068, (_e1068 <= select(_e234.member, _e1108, (_e1108 < _e234.member))));
                        let _e1126 = select(340282350000000000000000000000000000000f, _e1070, (_e1070 <= select(_e234.member, _e1110, (_e1110 < _e234.member))));
                        let _e1128 = select(340282350000000000000000000000000000000f, _e1072, (_e1072 <= select(_e234.member, _e1112, (_e1112 < _e234.member))));
                        let _e1132 = nodes.member[_e237].member_6[0u];
                        let _e1136 = nodes.member[_e237].member_6[1u];
                        let _e1140 = nodes.member[_e237].member_6[2u];
                        let _e1144 = nodes.member[_e237].member_6[3u];
                        if (_e1124 < _e1122) {
                            phi_807_ = type_43(_e1124, _e1136, _e1122, _e1132);
                        } else {
                            phi_807_ = type_43(_e1122, _e1132, _e1124, _e1136);
                        }
                        let _e1149 = phi_807_;
                        if (_e1128 < _e1126) {
                            phi_818_ = type_43(_e1128, _e1144, _e1126, _e1140);
                        } else {
                            phi_818_ = type_43(_e1126, _e1140, _e1128, _e1144);
                        }
                        let _e1158 = phi_818_;
                        if (_e1158.member < _e1149.member) {
                            phi_829_ = type_43(_e1158.member, _e1158.member_1, _e1149.member, _e1149.member_1);
                        } else {
                            phi_829_ = type_43(_e1149.member, _e1149.member_1, _e1158.member, _e1158.member_1);
                        }
                        let _e1167 = phi_829_;
                        if (_e1158.member_2 < _e1149.member_2) {
                            phi_840_ = type_43(_e1158.member_2, _e1158.member_3, _e1149.member_2, _e1149.member_3);
                        } else {
                            phi_840_ = type_43(_e1149.member_2, _e1149.member_3, _e1158.member_2, _e1158.member_3);
                        }
                        let _e1176 = phi_840_;
                        if (_e1167.member_2 < _e1176.member) {
                            phi_851_ = type_43(_e1167.member_2, _e1167.member_3, _e1176.member, _e1176.member_1);
                        } else {
                            phi_851_ = type_43(_e1176.member, _e1176.member_1, _e1167.member_2, _e1167.member_3);
                        }
                        let _e1185 = phi_851_;
                        if (_e1176.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1191 = (_e232 < 64u);
                            if _e1191 {
                            } else {
                                phi_2226_ = true;
                                phi_1828_ = type_42();
                                break;
                            }
                            local[_e232] = _e1176.member_3;
                            if _e1191 {
                            } else {
                                phi_2226_ = true;
                                phi_1828_ = type_42();
                                break;
                            }
                            local_1[_e232] = _e1176.member_2;
                            phi_873_ = (_e232 + 1u);
                        } else {
                            phi_873_ = _e232;
                        }
                        let _e1196 = phi_873_;
                        if (_e1185.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1198 = (_e1196 < 64u);
                            if _e1198 {
                            } else {
                                phi_2226_ = true;
                                phi_1828_ = type_42();
                                break;
                            }
                            local[_e1196] = _e1185.member_3;
                            if _e1198 {
                            } else {
                                phi_2226_ = true;
                                phi_1828_ = type_42();
                                break;
                            }
                            local_1[_e1196] = _e1185.member_2;
                            phi_891_ = (_e1196 + 1u);
                        } else {
                            phi_891_ = _e1196;
                        }
                        let _e1203 = phi_891_;
                        if (_e1185.member < 340282350000000000000000000000000000000f) {
                            let _e1205 = (_e1203 < 64u);
                            if _e1205 {
                            } else {
                                phi_2226_ = true;
                                phi_1828_ = type_42();
                                break;
                            }
                            local[_e1203] = _e1185.member_1;
                            if _e1205 {
                            } else {
                                phi_2226_ = true;
                                phi_1828_ = type_42();
                                break;
                            }
                            local_1[_e1203] = _e1185.member;
                            phi_909_ = (_e1203 + 1u);
                        } else {
                            phi_909_ = _e1203;
                        }
                        let _e1210 = phi_909_;
                        phi_2162_ = _e228;
                        phi_1745_ = select(0u, _e1167.member_1, (_e1167.member < 340282350000000000000000000000000000000f));
                        phi_1746_ = _e1210;
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
                                    phi_2072_ = true;
                                    break;
                                }
                                if _e145 {
                                } else {
                                    phi_2072_ = true;
                                    break;
                                }
                                let _e268 = triangles.member[_e259.member_1].member[_e142];
                                let _e269 = (_e268 - _e162);
                                if _e145 {
                                } else {
                                    phi_2072_ = true;
                                    break;
                                }
                                let _e273 = triangles.member[_e259.member_1].member_2[_e142];
                                let _e274 = (_e273 - _e162);
                                if _e145 {
                                } else {
                                    phi_2072_ = true;
                                    break;
                                }
                                let _e278 = triangles.member[_e259.member_1].member_4[_e142];
                                let _e279 = (_e278 - _e162);
                                if _e149 {
                                } else {
                                    phi_2072_ = true;
                                    break;
                                }
                                let _e283 = triangles.member[_e259.member_1].member[_e141];
                                let _e286 = ((_e283 - _e158) - (_e152 * _e269));
                                if _e153 {
                                } else {
                                    phi_2072_ = true;
                                    break;
                                }
                                let _e290 = triangles.member[_e259.member_1].member[_e140];
                                let _e293 = ((_e290 - _e160) - (_e156 * _e269));
                                if _e149 {
                                } else {
                                    phi_2072_ = true;
                                    break;
                                }
                                let _e297 = triangles.member[_e259.member_1].member_2[_e141];
                                let _e300 = ((_e297 - _e158) - (_e152 * _e274));
                                if _e153 {
                                } else {
                                    phi_2072_ = true;
                                    break;
                                }
                                let _e304 = triangles.member[_e259.member_1].member_2[_e140];
                                let _e307 = ((_e304 - _e160) - (_e156 * _e274));
                                if _e149 {
                                } else {
                                    phi_2072_ = true;
                                    break;
                                }
                                let _e311 = triangles.member[_e259.member_1].member_4[_e141];
                                let _e314 = ((_e311 - _e158) - (_e152 * _e279));
                                if _e153 {
                                } else {
                                    phi_2072_ = true;
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
                                                phi_2072_ = true;
                                                break;
                                            }
                                            let _e643 = triangles.member[_e259.member_1].member_3;
                                            if ((_e643 & 1u) == 0u) {
                                                phi_1714_ = true;
                                            } else {
                                                if _e264 {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                let _e648 = triangles.member[_e259.member_1].member_1;
                                                let _e649 = (_e648 * 12u);
                                                if ((256u + _e649) < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 257u) < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 258u) < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                let _e656 = (_e649 + 259u);
                                                if (_e656 < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                let _e659 = surfaces.member[_e656];
                                                if ((_e649 + 260u) < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 261u) < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 262u) < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                let _e666 = (_e649 + 263u);
                                                if (_e666 < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                let _e669 = surfaces.member[_e666];
                                                let _e670 = (_e649 + 264u);
                                                if (_e670 < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                let _e673 = surfaces.member[_e670];
                                                let _e674 = bitcast<f32>(_e673);
                                                let _e675 = (_e649 + 265u);
                                                if (_e675 < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                let _e678 = surfaces.member[_e675];
                                                let _e679 = bitcast<f32>(_e678);
                                                if ((_e649 + 266u) < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                if ((_e649 + 267u) < _e82) {
                                                } else {
                                                    phi_2072_ = true;
                                                    break;
                                                }
                                                if (_e659 == 4294967295u) {
                                                    phi_1709_ = (_e674 < _e679);
                                                } else {
                                                    if (_e259.member_1 < arrayLength((&attributes.member))) {
                                                    } else {
                                                        phi_2072_ = true;
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
                                                    if (_e745 >= 0f) {
                                                        phi_1458_ = select(true, false, (_e745 <= 1f));
                                                    } else {
                                                        phi_1458_ = true;
                                                    }
                                                    let _e750 = phi_1458_;
                                                    let _e754 = ((select(_e745, 0f, _e750) * f32(_e722)) - 0.5f);
                                                    let _e755 = floor(_e754);
                                                    let _e756 = (_e755 < 0f);
                                                    if _e756 {
                                                        phi_1483_ = 0u;
                                                    } else {
                                                        let _e761 = select(select(u32(_e755), 0u, (_e755 < 0f)), 4294967295u, (_e755 > 4294967000f));
                                                        phi_1483_ = select(_e761, _e728, (_e728 < _e761));
                                                    }
                                                    let _e765 = phi_1483_;
                                                    if _e756 {
                                                        phi_1493_ = 0u;
                                                    } else {
                                                        let _e766 = (_e765 + 1u);
                                                        phi_1493_ = select(_e766, _e728, (_e728 < _e766));
                                                    }
                                                    let _e770 = phi_1493_;
                                                    let _e771 = (_e727 == 0u);
                                                    if _e771 {
                                                        phi_1502_ = select(true, false, _e756);
                                                    } else {
                                                        phi_1502_ = true;
                                                    }
                                                    let _e774 = phi_1502_;
                                                    let _e775 = select(_e728, _e765, _e774);
                                                    if _e771 {
                                                        if _e756 {
                                                            phi_1518_ = true;
                                                        } else {
                                                            phi_1518_ = select(true, false, (_e775 == _e728));
                                                        }
                                                        let _e779 = phi_1518_;
                                                        phi_1519_ = _e779;
                                                    } else {
                                                        phi_1519_ = true;
                                                    }
                                                    let _e781 = phi_1519_;
                                                    let _e782 = select(0u, _e770, _e781);
                                                    let _e783 = (_e754 - _e755);
                                                    let _e786 = ((_e659 >> bitcast<u32>(30u)) & 3u);
                                                    let _e787 = (_e724 - 1u);
                                                    let _e789 = select(1f, 2f, (_e786 == 2u));
                                                    let _e793 = (_e721 - (floor((_e721 / _e789)) * _e789));
                                                    if (_e793 > 1f) {
                                                        phi_1542_ = (_e789 - _e793);
                                                    } else {
                                                        phi_1542_ = _e793;
                                                    }
                                                    let _e797 = phi_1542_;
                                                    if (_e786 == 1u) {
                                                        let _e800 = select(0f, _e721, (_e721 > 0f));
                                                        phi_1557_ = select(1f, _e800, (_e800 < 1f));
                                                    } else {
                                                        phi_1557_ = _e797;
                                                    }
                                                    let _e804 = phi_1557_;
                                                    if (_e804 >= 0f) {
                                                        phi_1567_ = select(true, false, (_e804 <= 1f));
                                                    } else {
                                                        phi_1567_ = true;
                                                    }
                                                    let _e809 = phi_1567_;
                                                    let _e813 = ((select(_e804, 0f, _e809) * f32(_e724)) - 0.5f);
                                                    let _e814 = floor(_e813);
                                                    let _e815 = (_e814 < 0f);
                                                    if _e815 {
                                                        phi_1592_ = 0u;
                                                    } else {
                                                        let _e820 = select(select(u32(_e814), 0u, (_e814 < 0f)), 4294967295u, (_e814 > 4294967000f));
                                                        phi_1592_ = select(_e820, _e787, (_e787 < _e820));
                                                    }
                                                    let _e824 = phi_1592_;
                                                    if _e815 {
                                                        phi_1602_ = 0u;
                                                    } else {
                                                        let _e825 = (_e824 + 1u);
                                                        phi_1602_ = select(_e825, _e787, (_e787 < _e825));
                                                    }
                                                    let _e829 = phi_1602_;
                                                    let _e830 = (_e786 == 0u);
                                                    if _e830 {
                                                        phi_1611_ = select(true, false, _e815);
                                                    } else {
                                                        phi_1611_ = true;
                                                    }
                                                    let _e833 = phi_1611_;
                                                    let _e834 = select(_e787, _e824, _e833);
                                                    if _e830 {
                                                        if _e815 {
                                                            phi_1627_ = true;
                                                        } else {
                                                            phi_1627_ = select(true, false, (_e834 == _e787));
                                                        }
                                                        let _e838 = phi_1627_;
                                                        phi_1628_ = _e838;
                                                    } else {
                                                        phi_1628_ = true;
                                                    }
                                                    let _e840 = phi_1628_;
                                                    let _e842 = (_e813 - _e814);
                                                    let _e843 = (_e659 & 268435455u);
                                                    let _e845 = (_e843 + (_e834 * _e722));
                                                    let _e847 = (_e843 + (select(0u, _e829, _e840) * _e722));
                                                    let _e848 = (_e845 + _e775);
                                                    let _e849 = (_e845 + _e782);
                                                    let _e850 = (_e847 + _e775);
                                                    let _e851 = (_e847 + _e782);
                                                    if (_e848 < _e82) {
                                                    } else {
                                                        phi_2072_ = true;
                                                        break;
                                                    }
                                                    let _e854 = surfaces.member[_e848];
                                                    if (_e849 < _e82) {
                                                    } else {
                                                        phi_2072_ = true;
                                                        break;
                                                    }
                                                    let _e857 = surfaces.member[_e849];
                                                    if (_e850 < _e82) {
                                                    } else {
                                                        phi_2072_ = true;
                                                        break;
                                                    }
                                                    let _e860 = surfaces.member[_e850];
                                                    if (_e851 < _e82) {
                                                    } else {
                                                        phi_2072_ = true;
                                                        break;
                                                    }
                                                    let _e863 = surfaces.member[_e851];
                                                    let _e880 = (1f - _e783);
                                                    phi_1709_ = ((_e674 * (((((f32((_e854 >> bitcast<u32>(24i))) * 0.003921569f) * _e880) + ((f32((_e857 >> bitcast<u32>(24i))) * 0.003921569f) * _e783)) * (1f - _e842)) + ((((f32((_e860 >> bitcast<u32>(24i))) * 0.003921569f) * _e880) + ((f32((_e863 >> bitcast<u32>(24i))) * 0.003921569f) * _e783)) * _e842))) < _e679);
                                                }
                                                let _e895 = phi_1709_;
                                                phi_1714_ = select(true, false, _e895);
                                            }
                                            let _e898 = phi_1714_;
                                            if _e898 {
                                                phi_1719_ = type_42(_e633[0], _e259.member_1, _e633[1], _e633[2]);
                                            } else {
                                                phi_1719_ = type_42();
                                            }
                                            let _e901 = phi_1719_;
                                            phi_1721_ = _e901;
                                            phi_1723_ = select(true, false, _e898);
                                        } else {
                                            phi_1721_ = type_42();
                                            phi_1723_ = false;
                                        }
                                        let _e904 = phi_1721_;
                                        let _e906 = phi_1723_;
                                        phi_1724_ = _e904;
                                        phi_1726_ = select(true, false, _e640);
                                        phi_1727_ = _e906;
                                    } else {
                                        phi_1724_ = type_42();
                                        phi_1726_ = false;
                                        phi_1727_ = false;
                                    }
                                    let _e909 = phi_1724_;
                                    let _e911 = phi_1726_;
                                    let _e913 = phi_1727_;
                                    phi_1728_ = _e909;
                                    phi_1729_ = select(true, false, _e639);
                                    phi_1730_ = _e911;
                                    phi_1731_ = _e913;
                                } else {
                                    phi_1728_ = type_42();
                                    phi_1729_ = true;
                                    phi_1730_ = false;
                                    phi_1731_ = false;
                                }
                                let _e916 = phi_1728_;
                                let _e918 = phi_1729_;
                                let _e920 = phi_1730_;
                                let _e922 = phi_1731_;
                                if select(select(_e922, false, _e918), true, select(_e920, true, _e918)) {
                                    phi_1744_ = _e244;
                                } else {
                                    phi_1744_ = _e916;
                                }
                                let _e927 = phi_1744_;
                                phi_922_ = _e927;
                            } else {
                                phi_922_ = type_42();
                            }
                            let _e929 = phi_922_;
                            continue;
                            continuing {
                                phi_918_ = _e257;
                                phi_921_ = _e929;
                                phi_2072_ = _e228;
                                break if !(_e263);
                            }
                        }
                        let _e932 = phi_2072_;
                        phi_2226_ = _e932;
                        phi_1828_ = type_42();
                        if _e932 {
                            break;
                        }
                        phi_2162_ = _e932;
                        phi_1745_ = 0u;
                        phi_1746_ = _e232;
                        let _e1350 = local_7;
                        phi_427_ = _e1350;
                    }
                    let _e1214 = phi_2162_;
                    let _e1216 = phi_1745_;
                    let _e1218 = phi_1746_;
                    let _e1220 = phi_427_;
                    phi_422_ = _e1216;
                    phi_425_ = _e1218;
                    loop {
                        let _e1222 = phi_422_;
                        let _e1224 = phi_425_;
                        local_5 = _e1222;
                        local_6 = _e1224;
                        let _e1225 = (_e1222 == 0u);
                        local_4 = _e1225;
                        if _e1225 {
                            let _e1226 = (_e1224 > 0u);
                            if _e1226 {
                                let _e1227 = (_e1224 - 1u);
                                let _e1228 = (_e1227 < 64u);
                                if _e1228 {
                                } else {
                                    phi_2159_ = true;
                                    break;
                                }
                                let _e1230 = local_1[_e1227];
                                if (_e1230 <= _e1220.member) {
                                    if _e1228 {
                                    } else {
                                        phi_2159_ = true;
                                        break;
                                    }
                                    let _e1234 = local[_e1227];
                                    phi_1781_ = _e1234;
                                } else {
                                    phi_1781_ = _e1222;
                                }
                                let _e1236 = phi_1781_;
                                phi_1782_ = _e1236;
                                phi_1783_ = _e1227;
                            } else {
                                phi_1782_ = u32();
                                phi_1783_ = u32();
                            }
                            let _e1238 = phi_1782_;
                            let _e1240 = phi_1783_;
                            phi_1748_ = _e1238;
                            phi_1750_ = _e1240;
                            phi_1784_ = _e1226;
                        } else {
                            phi_1748_ = u32();
                            phi_1750_ = u32();
                            phi_1784_ = false;
                        }
                        let _e1242 = phi_1748_;
                        let _e1244 = phi_1750_;
                        let _e1246 = phi_1784_;
                        continue;
                        continuing {
                            phi_422_ = _e1242;
                            phi_425_ = _e1244;
                            phi_2159_ = _e1214;
                            break if !(_e1246);
                        }
                    }
                    let _e1249 = phi_2159_;
                    phi_2226_ = _e1249;
                    phi_1828_ = type_42();
                    if _e1249 {
                        break;
                    }
                    let _e1251 = local_4;
                    continue;
                    continuing {
                        phi_2076_ = _e1249;
                        let _e1271 = local_5;
                        phi_421_ = _e1271;
                        let _e1274 = local_6;
                        phi_424_ = _e1274;
                        phi_426_ = _e1220;
                        phi_2226_ = _e1249;
                        phi_1828_ = _e1220;
                        break if !(select(true, false, _e1251));
                    }
                }
                let _e1255 = phi_2226_;
                let _e1257 = phi_1828_;
                if _e1255 {
                    break;
                }
                if (_e93 < arrayLength((&hits.member))) {
                } else {
                    break;
                }
                hits.member[_e93] = _e1257;
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
