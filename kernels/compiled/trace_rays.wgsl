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
    var phi_244_: bool;
    var phi_254_: u32;
    var phi_257_: bool;
    var phi_268_: u32;
    var phi_398_: f32;
    var phi_406_: f32;
    var phi_414_: f32;
    var phi_1925_: bool;
    var phi_417_: u32;
    var phi_420_: u32;
    var phi_422_: type_42;
    var phi_914_: type_12;
    var phi_917_: type_42;
    var phi_915_: type_12;
    var phi_940_: type_12;
    var phi_1056_: f32;
    var phi_1067_: f32;
    var phi_1078_: f32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_1095_: bool;
    var phi_1096_: f32;
    var phi_1097_: bool;
    var phi_1116_: f32;
    var phi_1117_: bool;
    var phi_1118_: f32;
    var phi_1119_: bool;
    var phi_1120_: bool;
    var phi_1125_: f32;
    var phi_1126_: bool;
    var phi_1212_: array<f32, 3>;
    var phi_1213_: array<f32, 3>;
    var phi_1214_: array<f32, 3>;
    var phi_1215_: array<f32, 3>;
    var phi_1216_: bool;
    var phi_1217_: array<f32, 3>;
    var phi_1218_: array<f32, 3>;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1225_: array<f32, 3>;
    var phi_1230_: array<f32, 3>;
    var phi_1441_: u32;
    var phi_1447_: u32;
    var phi_1477_: u32;
    var phi_1483_: u32;
    var phi_1558_: bool;
    var phi_1563_: bool;
    var phi_1568_: type_42;
    var phi_1570_: type_42;
    var phi_1572_: bool;
    var phi_1573_: type_42;
    var phi_1575_: bool;
    var phi_1576_: bool;
    var phi_1577_: type_42;
    var phi_1578_: bool;
    var phi_1579_: bool;
    var phi_1580_: bool;
    var phi_1593_: type_42;
    var phi_918_: type_42;
    var phi_1921_: bool;
    var phi_803_: type_43;
    var phi_814_: type_43;
    var phi_825_: type_43;
    var phi_836_: type_43;
    var phi_847_: type_43;
    var phi_869_: u32;
    var phi_887_: u32;
    var phi_905_: u32;
    var phi_1981_: bool;
    var phi_1594_: u32;
    var phi_1595_: u32;
    var phi_423_: type_42;
    var phi_418_: u32;
    var phi_421_: u32;
    var phi_1630_: u32;
    var phi_1631_: u32;
    var phi_1632_: u32;
    var phi_1597_: u32;
    var phi_1599_: u32;
    var phi_1633_: bool;
    var phi_1978_: bool;
    var local_4: bool;
    var phi_2045_: bool;
    var phi_1677_: type_42;
    var local_5: u32;
    var local_6: u32;
    var local_7: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e66 = gid_1;
            let _e69 = arrayLength((&nodes.member));
            let _e78 = arrayLength((&surfaces.member));
            let _e85 = params.member.member;
            let _e89 = (_e66.x + (_e66.y * 2097152u));
            if (_e89 < _e85) {
                if (_e89 < arrayLength((&rays.member))) {
                } else {
                    break;
                }
                let _e95 = rays.member[_e89].member;
                let _e99 = rays.member[_e89].member_1;
                let _e103 = rays.member[_e89].member_2;
                let _e107 = rays.member[_e89].member_3;
                let _e114 = abs(_e103[0]);
                let _e115 = abs(_e103[1]);
                let _e116 = abs(_e103[2]);
                let _e117 = (_e114 > _e115);
                if _e117 {
                    phi_244_ = (_e114 > _e116);
                } else {
                    phi_244_ = (_e115 > _e116);
                }
                let _e121 = phi_244_;
                let _e122 = select(1u, 0u, _e117);
                if _e121 {
                    let _e123 = (_e122 + 1u);
                    phi_254_ = _e123;
                    phi_257_ = select(true, false, (_e123 == 2u));
                } else {
                    phi_254_ = u32();
                    phi_257_ = false;
                }
                let _e127 = phi_254_;
                let _e129 = phi_257_;
                let _e130 = select(true, false, _e121);
                let _e131 = select(_e127, 0u, _e130);
                let _e133 = select(_e129, true, _e130);
                if _e133 {
                    phi_268_ = (_e131 + 1u);
                } else {
                    phi_268_ = 0u;
                }
                let _e136 = phi_268_;
                let _e137 = select(_e127, _e131, _e133);
                let _e138 = select(_e122, select(_e122, 2u, _e130), _e133);
                local_2 = array<f32, 3>(_e103[0], _e103[1], _e103[2]);
                local_3 = array<f32, 3>(_e95[0], _e95[1], _e95[2]);
                let _e141 = (_e138 < 3u);
                if _e141 {
                } else {
                    break;
                }
                let _e143 = local_2[_e138];
                let _e144 = (1f / _e143);
                let _e145 = (_e137 < 3u);
                if _e145 {
                } else {
                    break;
                }
                let _e147 = local_2[_e137];
                let _e148 = (_e147 * _e144);
                let _e149 = (_e136 < 3u);
                if _e149 {
                } else {
                    break;
                }
                let _e151 = local_2[_e136];
                let _e152 = (_e151 * _e144);
                if _e145 {
                } else {
                    break;
                }
                let _e154 = local_3[_e137];
                if _e149 {
                } else {
                    break;
                }
                let _e156 = local_3[_e136];
                if _e141 {
                } else {
                    break;
                }
                let _e158 = local_3[_e138];
                if (0u < _e69) {
                } else {
                    break;
                }
                let _e163 = nodes.member[0u].member_7[0u];
                let _e167 = nodes.member[0u].member_7[1u];
                let _e171 = nodes.member[0u].member_7[2u];
                let _e175 = nodes.member[0u].member_7[3u];
                let _e177 = abs((_e95[0] - _e163));
                let _e179 = abs((_e95[1] - _e167));
                let _e181 = select(_e179, _e177, (_e177 > _e179));
                let _e183 = abs((_e95[2] - _e171));
                let _e187 = ((select(_e183, _e181, (_e181 > _e183)) + _e175) * 0.0000009536743f);
                let _e194 = (_e187 + (abs(_e95[0]) * 0.00000023841858f));
                let _e195 = (_e187 + (abs(_e95[1]) * 0.00000023841858f));
                let _e196 = (_e187 + (abs(_e95[2]) * 0.00000023841858f));
                let _e197 = select(_e115, _e114, _e117);
                let _e199 = select(_e116, _e197, (_e197 > _e116));
                let _e200 = (_e199 * 0.000000000001f);
                let _e201 = (_e95[0] + _e194);
                let _e202 = (_e95[1] + _e195);
                let _e203 = (_e95[2] + _e196);
                let _e204 = (_e95[0] - _e194);
                let _e205 = (_e95[1] - _e195);
                let _e206 = (_e95[2] - _e196);
                if (_e114 > _e200) {
                    phi_398_ = (1f / _e103[0]);
                } else {
                    phi_398_ = (1000000000000f / _e199);
                }
                let _e211 = phi_398_;
                if (_e115 > _e200) {
                    phi_406_ = (1f / _e103[1]);
                } else {
                    phi_406_ = (1000000000000f / _e199);
                }
                let _e216 = phi_406_;
                if (_e116 > _e200) {
                    phi_414_ = (1f / _e103[2]);
                } else {
                    phi_414_ = (1000000000000f / _e199);
                }
                let _e221 = phi_414_;
                local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                local_1 = array<f32, 64>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                phi_1925_ = false;
                phi_417_ = 0u;
                phi_420_ = 0u;
                phi_422_ = type_42(_e107, 4294967295u, 0f, 0f);
                loop {
                    let _e224 = phi_1925_;
                    let _e226 = phi_417_;
                    let _e228 = phi_420_;
                    let _e230 = phi_422_;
                    let _e231 = (_e226 & 15u);
                    let _e233 = (_e226 >> bitcast<u32>(4u));
                    if (_e231 == 0u) {
                        if (_e233 < _e69) {
                        } else {
                            phi_2045_ = true;
                            phi_1677_ = type_42();
                            break;
                        }
                        let _e862 = nodes.member[_e233].member;
                        let _e871 = ((_e862.x - _e201) * _e211);
                        let _e872 = ((_e862.y - _e201) * _e211);
                        let _e873 = ((_e862.z - _e201) * _e211);
                        let _e874 = ((_e862.w - _e201) * _e211);
                        let _e877 = nodes.member[_e233].member_3;
                        let _e886 = ((_e877.x - _e204) * _e211);
                        let _e887 = ((_e877.y - _e204) * _e211);
                        let _e888 = ((_e877.z - _e204) * _e211);
                        let _e889 = ((_e877.w - _e204) * _e211);
                        let _e892 = nodes.member[_e233].member_1;
                        let _e901 = ((_e892.x - _e202) * _e216);
                        let _e902 = ((_e892.y - _e202) * _e216);
                        let _e903 = ((_e892.z - _e202) * _e216);
                        let _e904 = ((_e892.w - _e202) * _e216);
                        let _e907 = nodes.member[_e233].member_4;
                        let _e916 = ((_e907.x - _e205) * _e216);
                        let _e917 = ((_e907.y - _e205) * _e216);
                        let _e918 = ((_e907.z - _e205) * _e216);
                        let _e919 = ((_e907.w - _e205) * _e216);
                        let _e922 = nodes.member[_e233].member_2;
                        let _e931 = ((_e922.x - _e203) * _e221);
                        let _e932 = ((_e922.y - _e203) * _e221);
                        let _e933 = ((_e922.z - _e203) * _e221);
                        let _e934 = ((_e922.w - _e203) * _e221);
                        let _e937 = nodes.member[_e233].member_5;
                        let _e946 = ((_e937.x - _e206) * _e221);
                        let _e947 = ((_e937.y - _e206) * _e221);
                        let _e948 = ((_e937.z - _e206) * _e221);
                        let _e949 = ((_e937.w - _e206) * _e221);
                        let _e951 = select(_e886, _e871, (_e871 < _e886));
                        let _e953 = select(_e887, _e872, (_e872 < _e887));
                        let _e955 = select(_e888, _e873, (_e873 < _e888));
                        let _e957 = select(_e889, _e874, (_e874 < _e889));
                        let _e959 = select(_e916, _e901, (_e901 < _e916));
                        let _e961 = select(_e917, _e902, (_e902 < _e917));
                        let _e963 = select(_e918, _e903, (_e903 < _e918));
                        let _e965 = select(_e919, _e904, (_e904 < _e919));
                        let _e967 = select(_e959, _e951, (_e951 > _e959));
                        let _e969 = select(_e961, _e953, (_e953 > _e961));
                        let _e971 = select(_e963, _e955, (_e955 > _e963));
                        let _e973 = select(_e965, _e957, (_e957 > _e965));
                        let _e975 = select(_e946, _e931, (_e931 < _e946));
                        let _e977 = select(_e947, _e932, (_e932 < _e947));
                        let _e979 = select(_e948, _e933, (_e933 < _e948));
                        let _e981 = select(_e949, _e934, (_e934 < _e949));
                        let _e983 = select(_e975, _e967, (_e967 > _e975));
                        let _e985 = select(_e977, _e969, (_e969 > _e977));
                        let _e987 = select(_e979, _e971, (_e971 > _e979));
                        let _e989 = select(_e981, _e973, (_e973 > _e981));
                        let _e991 = select(_e99, _e983, (_e983 > _e99));
                        let _e993 = select(_e99, _e985, (_e985 > _e99));
                        let _e995 = select(_e99, _e987, (_e987 > _e99));
                        let _e997 = select(_e99, _e989, (_e989 > _e99));
                        let _e999 = select(_e886, _e871, (_e871 > _e886));
                        let _e1001 = select(_e887, _e872, (_e872 > _e887));
                        let _e1003 = select(_e888, _e873, (_e873 > _e888));
                        let _e1005 = select(_e889, _e874, (_e874 > _e889));
                        let _e1007 = select(_e916, _e901, (_e901 > _e916));
                        let _e1009 = select(_e917, _e902, (_e902 > _e917));
                        let _e1011 = select(_e918, _e903, (_e903 > _e918));
                        let _e1013 = select(_e919, _e904, (_e904 > _e919));
                        let _e1015 = select(_e1007, _e999, (_e999 < _e1007));
                        let _e1017 = select(_e1009, _e1001, (_e1001 < _e1009));
                        let _e1019 = select(_e1011, _e1003, (_e1003 < _e1011));
                        let _e1021 = select(_e1013, _e1005, (_e1005 < _e1013));
                        let _e1023 = select(_e946, _e931, (_e931 > _e946));
                        let _e1025 = select(_e947, _e932, (_e932 > _e947));
                        let _e1027 = select(_e948, _e933, (_e933 > _e948));
                        let _e1029 = select(_e949, _e934, (_e934 > _e949));
                        let _e1031 = select(_e1023, _e1015, (_e1015 < _e1023));
                        let _e1033 = select(_e1025, _e1017, (_e1017 < _e1025));
                        let _e1035 = select(_e1027, _e1019, (_e1019 < _e1027));
                        let _e1037 = select(_e1029, _e1021, (_e1021 < _e1029));
                        let _e1047 = select(340282350000000000000000000000000000000f, _e991, (_e991 <= select(_e230.member, _e1031, (_e1031 < _e230.member))));
                        let _e1049 = select(340282350000000000000000000000000000000f, _e993, (_e993 <= select(_e230.member, _e1033, (_e1033 < _e230.member))));
                        let _e1051 = select(340282350000000000000000000000000000000f, _e995, (_e995 <= select(_e230.member, _e1035, (_e1035 < _e230.member))));
                        let _e1053 = select(340282350000000000000000000000000000000f, _e997, (_e997 <= select(_e230.member, _e1037, (_e1037 < _e230.member))));
                        let _e1057 = nodes.member[_e233].member_6[0u];
                        let _e1061 = nodes.member[_e233].member_6[1u];
                        let _e1065 = nodes.member[_e233].member_6[2u];
                        let _e1069 = nodes.member[_e233].member_6[3u];
                        if (_e1049 < _e1047) {
                            phi_803_ = type_43(_e1049, _e1061, _e1047, _e1057);
                        } else {
                            phi_803_ = type_43(_e1047, _e1057, _e1049, _e1061);
                        }
                        let _e1074 = phi_803_;
                        if (_e1053 < _e1051) {
                            phi_814_ = type_43(_e1053, _e1069, _e1051, _e1065);
                        } else {
                            phi_814_ = type_43(_e1051, _e1065, _e1053, _e1069);
                        }
                        let _e1083 = phi_814_;
                        if (_e1083.member < _e1074.member) {
                            phi_825_ = type_43(_e1083.member, _e1083.member_1, _e1074.member, _e1074.member_1);
                        } else {
                            phi_825_ = type_43(_e1074.member, _e1074.member_1, _e1083.member, _e1083.member_1);
                        }
                        let _e1092 = phi_825_;
                        if (_e1083.member_2 < _e1074.member_2) {
                            phi_836_ = type_43(_e1083.member_2, _e1083.member_3, _e1074.member_2, _e1074.member_3);
                        } else {
                            phi_836_ = type_43(_e1074.member_2, _e1074.member_3, _e1083.member_2, _e1083.member_3);
                        }
                        let _e1101 = phi_836_;
                        if (_e1092.member_2 < _e1101.member) {
                            phi_847_ = type_43(_e1092.member_2, _e1092.member_3, _e1101.member, _e1101.member_1);
                        } else {
                            phi_847_ = type_43(_e1101.member, _e1101.member_1, _e1092.member_2, _e1092.member_3);
                        }
                        let _e1110 = phi_847_;
                        if (_e1101.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1116 = (_e228 < 64u);
                            if _e1116 {
                            } else {
                                phi_2045_ = true;
                                phi_1677_ = type_42();
                                break;
                            }
                            local[_e228] = _e1101.member_3;
                            if _e1116 {
                            } else {
                                phi_2045_ = true;
                                phi_1677_ = type_42();
                                break;
                            }
                            local_1[_e228] = _e1101.member_2;
                            phi_869_ = (_e228 + 1u);
                        } else {
                            phi_869_ = _e228;
                        }
                        let _e1121 = phi_869_;
                        if (_e1110.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1123 = (_e1121 < 64u);
                            if _e1123 {
                            } else {
                                phi_2045_ = true;
                                phi_1677_ = type_42();
                                break;
                            }
                            local[_e1121] = _e1110.member_3;
                            if _e1123 {
                            } else {
                                phi_2045_ = true;
                                phi_1677_ = type_42();
                                break;
                            }
                            local_1[_e1121] = _e1110.member_2;
                            phi_887_ = (_e1121 + 1u);
                        } else {
                            phi_887_ = _e1121;
                        }
                        let _e1128 = phi_887_;
                        if (_e1110.member < 340282350000000000000000000000000000000f) {
                            let _e1130 = (_e1128 < 64u);
                            if _e1130 {
                            } else {
                                phi_2045_ = true;
                                phi_1677_ = type_42();
                                break;
                            }
                            local[_e1128] = _e1110.member_1;
                            if _e1130 {
                            } else {
                                phi_2045_ = true;
                                phi_1677_ = type_42();
                                break;
                            }
                            local_1[_e1128] = _e1110.member;
                            phi_905_ = (_e1128 + 1u);
                        } else {
                            phi_905_ = _e1128;
                        }
                        let _e1135 = phi_905_;
                        phi_1981_ = _e224;
                        phi_1594_ = select(0u, _e1092.member_1, (_e1092.member < 340282350000000000000000000000000000000f));
                        phi_1595_ = _e1135;
                        phi_423_ = _e230;
                    } else {
                        phi_914_ = type_12(_e233, (_e233 + _e231));
                        phi_917_ = _e230;
                        loop {
                            let _e238 = phi_914_;
                            let _e240 = phi_917_;
                            local_7 = _e240;
                            if (_e238.member < _e238.member_1) {
                                phi_915_ = type_12((_e238.member + 1u), _e238.member_1);
                                phi_940_ = type_12(1u, _e238.member);
                            } else {
                                phi_915_ = _e238;
                                phi_940_ = type_12(0u, type_12().member_1);
                            }
                            let _e253 = phi_915_;
                            let _e255 = phi_940_;
                            let _e259 = (bitcast<i32>(_e255.member) != 0i);
                            if _e259 {
                                let _e260 = (_e255.member_1 < arrayLength((&triangles.member)));
                                if _e260 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                if _e141 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                let _e264 = triangles.member[_e255.member_1].member[_e138];
                                let _e265 = (_e264 - _e158);
                                if _e141 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                let _e269 = triangles.member[_e255.member_1].member_2[_e138];
                                let _e270 = (_e269 - _e158);
                                if _e141 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                let _e274 = triangles.member[_e255.member_1].member_4[_e138];
                                let _e275 = (_e274 - _e158);
                                if _e145 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                let _e279 = triangles.member[_e255.member_1].member[_e137];
                                let _e282 = ((_e279 - _e154) - (_e148 * _e265));
                                if _e149 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                let _e286 = triangles.member[_e255.member_1].member[_e136];
                                let _e289 = ((_e286 - _e156) - (_e152 * _e265));
                                if _e145 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                let _e293 = triangles.member[_e255.member_1].member_2[_e137];
                                let _e296 = ((_e293 - _e154) - (_e148 * _e270));
                                if _e149 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                let _e300 = triangles.member[_e255.member_1].member_2[_e136];
                                let _e303 = ((_e300 - _e156) - (_e152 * _e270));
                                if _e145 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                let _e307 = triangles.member[_e255.member_1].member_4[_e137];
                                let _e310 = ((_e307 - _e154) - (_e148 * _e275));
                                if _e149 {
                                } else {
                                    phi_1921_ = true;
                                    break;
                                }
                                let _e314 = triangles.member[_e255.member_1].member_4[_e136];
                                let _e317 = ((_e314 - _e156) - (_e152 * _e275));
                                let _e318 = (_e310 * _e303);
                                let _e319 = (_e317 * _e296);
                                if (_e318 != _e319) {
                                    phi_1056_ = (_e318 - _e319);
                                } else {
                                    let _e321 = (_e310 * 4097f);
                                    let _e323 = (_e321 - (_e321 - _e310));
                                    let _e324 = (_e303 * 4097f);
                                    let _e326 = (_e324 - (_e324 - _e303));
                                    let _e327 = (_e310 - _e323);
                                    let _e328 = (_e303 - _e326);
                                    let _e337 = (_e317 * 4097f);
                                    let _e339 = (_e337 - (_e337 - _e317));
                                    let _e340 = (_e296 * 4097f);
                                    let _e342 = (_e340 - (_e340 - _e296));
                                    let _e343 = (_e317 - _e339);
                                    let _e344 = (_e296 - _e342);
                                    phi_1056_ = ((((((_e323 * _e326) - _e318) + (_e323 * _e328)) + (_e327 * _e326)) + (_e327 * _e328)) - (((((_e339 * _e342) - _e319) + (_e339 * _e344)) + (_e343 * _e342)) + (_e343 * _e344)));
                                }
                                let _e356 = phi_1056_;
                                let _e357 = (_e282 * _e317);
                                let _e358 = (_e289 * _e310);
                                if (_e357 != _e358) {
                                    phi_1067_ = (_e357 - _e358);
                                } else {
                                    let _e360 = (_e282 * 4097f);
                                    let _e362 = (_e360 - (_e360 - _e282));
                                    let _e363 = (_e317 * 4097f);
                                    let _e365 = (_e363 - (_e363 - _e317));
                                    let _e366 = (_e282 - _e362);
                                    let _e367 = (_e317 - _e365);
                                    let _e376 = (_e289 * 4097f);
                                    let _e378 = (_e376 - (_e376 - _e289));
                                    let _e379 = (_e310 * 4097f);
                                    let _e381 = (_e379 - (_e379 - _e310));
                                    let _e382 = (_e289 - _e378);
                                    let _e383 = (_e310 - _e381);
                                    phi_1067_ = ((((((_e362 * _e365) - _e357) + (_e362 * _e367)) + (_e366 * _e365)) + (_e366 * _e367)) - (((((_e378 * _e381) - _e358) + (_e378 * _e383)) + (_e382 * _e381)) + (_e382 * _e383)));
                                }
                                let _e395 = phi_1067_;
                                let _e396 = (_e296 * _e289);
                                let _e397 = (_e303 * _e282);
                                if (_e396 != _e397) {
                                    phi_1078_ = (_e396 - _e397);
                                } else {
                                    let _e399 = (_e296 * 4097f);
                                    let _e401 = (_e399 - (_e399 - _e296));
                                    let _e402 = (_e289 * 4097f);
                                    let _e404 = (_e402 - (_e402 - _e289));
                                    let _e405 = (_e296 - _e401);
                                    let _e406 = (_e289 - _e404);
                                    let _e415 = (_e303 * 4097f);
                                    let _e417 = (_e415 - (_e415 - _e303));
                                    let _e418 = (_e282 * 4097f);
                                    let _e420 = (_e418 - (_e418 - _e282));
                                    let _e421 = (_e303 - _e417);
                                    let _e422 = (_e282 - _e420);
                                    phi_1078_ = ((((((_e401 * _e404) - _e396) + (_e401 * _e406)) + (_e405 * _e404)) + (_e405 * _e406)) - (((((_e417 * _e420) - _e397) + (_e417 * _e422)) + (_e421 * _e420)) + (_e421 * _e422)));
                                }
                                let _e434 = phi_1078_;
                                if (_e356 < 0f) {
                                    phi_1096_ = f32();
                                    phi_1097_ = true;
                                } else {
                                    if (_e395 < 0f) {
                                        phi_1094_ = f32();
                                        phi_1095_ = true;
                                    } else {
                                        let _e437 = (_e434 < 0f);
                                        if _e437 {
                                            phi_1093_ = f32();
                                        } else {
                                            phi_1093_ = ((_e356 + _e395) + _e434);
                                        }
                                        let _e441 = phi_1093_;
                                        phi_1094_ = _e441;
                                        phi_1095_ = _e437;
                                    }
                                    let _e443 = phi_1094_;
                                    let _e445 = phi_1095_;
                                    phi_1096_ = _e443;
                                    phi_1097_ = _e445;
                                }
                                let _e447 = phi_1096_;
                                let _e449 = phi_1097_;
                                if _e449 {
                                    if (_e356 > 0f) {
                                        phi_1118_ = f32();
                                        phi_1119_ = true;
                                        phi_1120_ = false;
                                    } else {
                                        let _e451 = (_e395 > 0f);
                                        if _e451 {
                                            phi_1116_ = f32();
                                            phi_1117_ = false;
                                        } else {
                                            phi_1116_ = ((_e356 + _e395) + _e434);
                                            phi_1117_ = select(true, false, (_e434 > 0f));
                                        }
                                        let _e457 = phi_1116_;
                                        let _e459 = phi_1117_;
                                        phi_1118_ = _e457;
                                        phi_1119_ = _e451;
                                        phi_1120_ = _e459;
                                    }
                                    let _e461 = phi_1118_;
                                    let _e463 = phi_1119_;
                                    let _e465 = phi_1120_;
                                    phi_1125_ = _e461;
                                    phi_1126_ = select(_e465, false, _e463);
                                } else {
                                    phi_1125_ = _e447;
                                    phi_1126_ = true;
                                }
                                let _e468 = phi_1125_;
                                let _e470 = phi_1126_;
                                if _e470 {
                                    let _e471 = (_e468 == 0f);
                                    if _e471 {
                                        phi_1214_ = array<f32, 3>();
                                        phi_1215_ = array<f32, 3>();
                                        phi_1216_ = false;
                                    } else {
                                        let _e472 = (_e265 * _e144);
                                        let _e473 = (_e270 * _e144);
                                        let _e474 = (_e275 * _e144);
                                        let _e477 = (1f / ((_e356 + _e395) + _e434));
                                        let _e478 = (_e395 * _e477);
                                        let _e479 = (_e434 * _e477);
                                        let _e485 = ((((_e356 * _e477) * _e472) + (_e478 * _e473)) + (_e479 * _e474));
                                        let _e486 = abs(_e282);
                                        let _e487 = abs(_e296);
                                        let _e489 = select(_e487, _e486, (_e486 > _e487));
                                        let _e490 = abs(_e310);
                                        let _e493 = abs(_e289);
                                        let _e494 = abs(_e303);
                                        let _e496 = select(_e494, _e493, (_e493 > _e494));
                                        let _e497 = abs(_e317);
                                        let _e501 = abs(_e472);
                                        let _e502 = abs(_e473);
                                        let _e504 = select(_e502, _e501, (_e501 > _e502));
                                        let _e505 = abs(_e474);
                                        let _e512 = (((select(_e490, _e489, (_e489 > _e490)) * select(_e497, _e496, (_e496 > _e497))) * select(_e505, _e504, (_e504 > _e505))) <= (abs((_e468 * _e485)) * 256f));
                                        if _e512 {
                                            phi_1212_ = array<f32, 3>(_e485, _e478, _e479);
                                            phi_1213_ = array<f32, 3>();
                                        } else {
                                            let _e514 = (_e310 * 4097f);
                                            let _e516 = (_e514 - (_e514 - _e310));
                                            let _e517 = (_e303 * 4097f);
                                            let _e519 = (_e517 - (_e517 - _e303));
                                            let _e520 = (_e310 - _e516);
                                            let _e521 = (_e303 - _e519);
                                            let _e530 = (_e317 * 4097f);
                                            let _e532 = (_e530 - (_e530 - _e317));
                                            let _e533 = (_e296 * 4097f);
                                            let _e535 = (_e533 - (_e533 - _e296));
                                            let _e536 = (_e317 - _e532);
                                            let _e537 = (_e296 - _e535);
                                            let _e547 = ((_e318 - _e319) + ((((((_e516 * _e519) - _e318) + (_e516 * _e521)) + (_e520 * _e519)) + (_e520 * _e521)) - (((((_e532 * _e535) - _e319) + (_e532 * _e537)) + (_e536 * _e535)) + (_e536 * _e537))));
                                            let _e549 = (_e282 * 4097f);
                                            let _e551 = (_e549 - (_e549 - _e282));
                                            let _e552 = (_e282 - _e551);
                                            let _e561 = (_e289 * 4097f);
                                            let _e563 = (_e561 - (_e561 - _e289));
                                            let _e564 = (_e289 - _e563);
                                            let _e574 = ((_e357 - _e358) + ((((((_e551 * _e532) - _e357) + (_e551 * _e536)) + (_e552 * _e532)) + (_e552 * _e536)) - (((((_e563 * _e516) - _e358) + (_e563 * _e520)) + (_e564 * _e516)) + (_e564 * _e520))));
                                            let _e593 = ((_e396 - _e397) + ((((((_e535 * _e563) - _e396) + (_e535 * _e564)) + (_e537 * _e563)) + (_e537 * _e564)) - (((((_e519 * _e551) - _e397) + (_e519 * _e552)) + (_e521 * _e551)) + (_e521 * _e552))));
                                            let _e596 = (1f / ((_e547 + _e574) + _e593));
                                            let _e597 = (_e574 * _e596);
                                            let _e598 = (_e593 * _e596);
                                            phi_1212_ = array<f32, 3>();
                                            phi_1213_ = array<f32, 3>(((((_e547 * _e596) * _e472) + (_e597 * _e473)) + (_e598 * _e474)), _e597, _e598);
                                        }
                                        let _e608 = phi_1212_;
                                        let _e610 = phi_1213_;
                                        phi_1214_ = _e608;
                                        phi_1215_ = _e610;
                                        phi_1216_ = _e512;
                                    }
                                    let _e612 = phi_1214_;
                                    let _e614 = phi_1215_;
                                    let _e616 = phi_1216_;
                                    phi_1217_ = _e612;
                                    phi_1218_ = _e614;
                                    phi_1219_ = _e471;
                                    phi_1220_ = _e616;
                                } else {
                                    phi_1217_ = array<f32, 3>();
                                    phi_1218_ = array<f32, 3>();
                                    phi_1219_ = true;
                                    phi_1220_ = false;
                                }
                                let _e618 = phi_1217_;
                                let _e620 = phi_1218_;
                                let _e622 = phi_1219_;
                                let _e624 = phi_1220_;
                                if _e622 {
                                    phi_1225_ = array<f32, 3>(-1f, 0f, 0f);
                                } else {
                                    phi_1225_ = _e618;
                                }
                                let _e626 = phi_1225_;
                                if select(_e624, true, _e622) {
                                    phi_1230_ = _e626;
                                } else {
                                    phi_1230_ = _e620;
                                }
                                let _e629 = phi_1230_;
                                if (_e629[0] >= _e99) {
                                    let _e635 = (_e629[0] < _e240.member);
                                    if _e635 {
                                        let _e636 = (_e629[0] >= 0f);
                                        if _e636 {
                                            if _e260 {
                                            } else {
                                                phi_1921_ = true;
                                                break;
                                            }
                                            let _e639 = triangles.member[_e255.member_1].member_3;
                                            if ((_e639 & 1u) == 0u) {
                                                phi_1563_ = true;
                                            } else {
                                                if _e260 {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                let _e644 = triangles.member[_e255.member_1].member_1;
                                                let _e645 = (_e644 * 12u);
                                                if ((256u + _e645) < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                if ((_e645 + 257u) < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                if ((_e645 + 258u) < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                let _e652 = (_e645 + 259u);
                                                if (_e652 < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                let _e655 = surfaces.member[_e652];
                                                if ((_e645 + 260u) < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                if ((_e645 + 261u) < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                if ((_e645 + 262u) < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                let _e662 = (_e645 + 263u);
                                                if (_e662 < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                let _e665 = surfaces.member[_e662];
                                                let _e666 = (_e645 + 264u);
                                                if (_e666 < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                let _e669 = surfaces.member[_e666];
                                                let _e670 = bitcast<f32>(_e669);
                                                let _e671 = (_e645 + 265u);
                                                if (_e671 < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                let _e674 = surfaces.member[_e671];
                                                let _e675 = bitcast<f32>(_e674);
                                                if ((_e645 + 266u) < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                if ((_e645 + 267u) < _e78) {
                                                } else {
                                                    phi_1921_ = true;
                                                    break;
                                                }
                                                if (_e655 == 4294967295u) {
                                                    phi_1558_ = (_e670 < _e675);
                                                } else {
                                                    if (_e255.member_1 < arrayLength((&attributes.member))) {
                                                    } else {
                                                        phi_1921_ = true;
                                                        break;
                                                    }
                                                    let _e683 = ((1f - _e629[1]) - _e629[2]);
                                                    let _e687 = attributes.member[_e255.member_1].member[0u];
                                                    let _e692 = attributes.member[_e255.member_1].member[2u];
                                                    let _e698 = attributes.member[_e255.member_1].member[4u];
                                                    let _e700 = (((_e687 * _e683) + (_e692 * _e629[1])) + (_e698 * _e629[2]));
                                                    let _e704 = attributes.member[_e255.member_1].member[1u];
                                                    let _e709 = attributes.member[_e255.member_1].member[3u];
                                                    let _e715 = attributes.member[_e255.member_1].member[5u];
                                                    let _e717 = (((_e704 * _e683) + (_e709 * _e629[1])) + (_e715 * _e629[2]));
                                                    let _e718 = (_e665 & 65535u);
                                                    let _e720 = (_e665 >> bitcast<u32>(16i));
                                                    let _e722 = (_e700 - floor(_e700));
                                                    let _e727 = ((select(0f, _e722, (_e722 <= 1f)) * f32(_e718)) - 0.5f);
                                                    let _e728 = floor(_e727);
                                                    let _e729 = (_e727 - _e728);
                                                    let _e730 = (_e718 - 1u);
                                                    if (_e728 < 0f) {
                                                        phi_1441_ = _e730;
                                                    } else {
                                                        let _e736 = select(select(u32(_e728), 0u, (_e728 < 0f)), 4294967295u, (_e728 > 4294967000f));
                                                        phi_1441_ = select(_e736, _e730, (_e730 < _e736));
                                                    }
                                                    let _e740 = phi_1441_;
                                                    if (_e740 == _e730) {
                                                        phi_1447_ = 0u;
                                                    } else {
                                                        phi_1447_ = (_e740 + 1u);
                                                    }
                                                    let _e744 = phi_1447_;
                                                    let _e746 = (_e717 - floor(_e717));
                                                    let _e751 = ((select(0f, _e746, (_e746 <= 1f)) * f32(_e720)) - 0.5f);
                                                    let _e752 = floor(_e751);
                                                    let _e753 = (_e751 - _e752);
                                                    let _e754 = (_e720 - 1u);
                                                    if (_e752 < 0f) {
                                                        phi_1477_ = _e754;
                                                    } else {
                                                        let _e760 = select(select(u32(_e752), 0u, (_e752 < 0f)), 4294967295u, (_e752 > 4294967000f));
                                                        phi_1477_ = select(_e760, _e754, (_e754 < _e760));
                                                    }
                                                    let _e764 = phi_1477_;
                                                    if (_e764 == _e754) {
                                                        phi_1483_ = 0u;
                                                    } else {
                                                        phi_1483_ = (_e764 + 1u);
                                                    }
                                                    let _e768 = phi_1483_;
                                                    let _e770 = (_e655 + (_e764 * _e718));
                                                    let _e772 = (_e655 + (_e768 * _e718));
                                                    let _e773 = (_e770 + _e740);
                                                    let _e774 = (_e770 + _e744);
                                                    let _e775 = (_e772 + _e740);
                                                    let _e776 = (_e772 + _e744);
                                                    if (_e773 < _e78) {
                                                    } else {
                                                        phi_1921_ = true;
                                                        break;
                                                    }
                                                    let _e779 = surfaces.member[_e773];
                                                    if (_e774 < _e78) {
                                                    } else {
                                                        phi_1921_ = true;
                                                        break;
                                                    }
                                                    let _e782 = surfaces.member[_e774];
                                                    if (_e775 < _e78) {
                                                    } else {
                                                        phi_1921_ = true;
                                                        break;
                                                    }
                                                    let _e785 = surfaces.member[_e775];
                                                    if (_e776 < _e78) {
                                                    } else {
                                                        phi_1921_ = true;
                                                        break;
                                                    }
                                                    let _e788 = surfaces.member[_e776];
                                                    let _e805 = (1f - _e729);
                                                    phi_1558_ = ((_e670 * (((((f32((_e779 >> bitcast<u32>(24i))) * 0.003921569f) * _e805) + ((f32((_e782 >> bitcast<u32>(24i))) * 0.003921569f) * _e729)) * (1f - _e753)) + ((((f32((_e785 >> bitcast<u32>(24i))) * 0.003921569f) * _e805) + ((f32((_e788 >> bitcast<u32>(24i))) * 0.003921569f) * _e729)) * _e753))) < _e675);
                                                }
                                                let _e820 = phi_1558_;
                                                phi_1563_ = select(true, false, _e820);
                                            }
                                            let _e823 = phi_1563_;
                                            if _e823 {
                                                phi_1568_ = type_42(_e629[0], _e255.member_1, _e629[1], _e629[2]);
                                            } else {
                                                phi_1568_ = type_42();
                                            }
                                            let _e826 = phi_1568_;
                                            phi_1570_ = _e826;
                                            phi_1572_ = select(true, false, _e823);
                                        } else {
                                            phi_1570_ = type_42();
                                            phi_1572_ = false;
                                        }
                                        let _e829 = phi_1570_;
                                        let _e831 = phi_1572_;
                                        phi_1573_ = _e829;
                                        phi_1575_ = select(true, false, _e636);
                                        phi_1576_ = _e831;
                                    } else {
                                        phi_1573_ = type_42();
                                        phi_1575_ = false;
                                        phi_1576_ = false;
                                    }
                                    let _e834 = phi_1573_;
                                    let _e836 = phi_1575_;
                                    let _e838 = phi_1576_;
                                    phi_1577_ = _e834;
                                    phi_1578_ = select(true, false, _e635);
                                    phi_1579_ = _e836;
                                    phi_1580_ = _e838;
                                } else {
                                    phi_1577_ = type_42();
                                    phi_1578_ = true;
                                    phi_1579_ = false;
                                    phi_1580_ = false;
                                }
                                let _e841 = phi_1577_;
                                let _e843 = phi_1578_;
                                let _e845 = phi_1579_;
                                let _e847 = phi_1580_;
                                if select(select(_e847, false, _e843), true, select(_e845, true, _e843)) {
                                    phi_1593_ = _e240;
                                } else {
                                    phi_1593_ = _e841;
                                }
                                let _e852 = phi_1593_;
                                phi_918_ = _e852;
                            } else {
                                phi_918_ = type_42();
                            }
                            let _e854 = phi_918_;
                            continue;
                            continuing {
                                phi_914_ = _e253;
                                phi_917_ = _e854;
                                phi_1921_ = _e224;
                                break if !(_e259);
                            }
                        }
                        let _e857 = phi_1921_;
                        phi_2045_ = _e857;
                        phi_1677_ = type_42();
                        if _e857 {
                            break;
                        }
                        phi_1981_ = _e857;
                        phi_1594_ = 0u;
                        phi_1595_ = _e228;
                        let _e1263 = local_7;
                        phi_423_ = _e1263;
                    }
                    let _e1139 = phi_1981_;
                    let _e1141 = phi_1594_;
                    let _e1143 = phi_1595_;
                    let _e1145 = phi_423_;
                    phi_418_ = _e1141;
                    phi_421_ = _e1143;
                    loop {
                        let _e1147 = phi_418_;
                        let _e1149 = phi_421_;
                        local_5 = _e1147;
                        local_6 = _e1149;
                        let _e1150 = (_e1147 == 0u);
                        local_4 = _e1150;
                        if _e1150 {
                            let _e1151 = (_e1149 > 0u);
                            if _e1151 {
                                let _e1152 = (_e1149 - 1u);
                                let _e1153 = (_e1152 < 64u);
                                if _e1153 {
                                } else {
                                    phi_1978_ = true;
                                    break;
                                }
                                let _e1155 = local_1[_e1152];
                                if (_e1155 <= _e1145.member) {
                                    if _e1153 {
                                    } else {
                                        phi_1978_ = true;
                                        break;
                                    }
                                    let _e1159 = local[_e1152];
                                    phi_1630_ = _e1159;
                                } else {
                                    phi_1630_ = _e1147;
                                }
                                let _e1161 = phi_1630_;
                                phi_1631_ = _e1161;
                                phi_1632_ = _e1152;
                            } else {
                                phi_1631_ = u32();
                                phi_1632_ = u32();
                            }
                            let _e1163 = phi_1631_;
                            let _e1165 = phi_1632_;
                            phi_1597_ = _e1163;
                            phi_1599_ = _e1165;
                            phi_1633_ = _e1151;
                        } else {
                            phi_1597_ = u32();
                            phi_1599_ = u32();
                            phi_1633_ = false;
                        }
                        let _e1167 = phi_1597_;
                        let _e1169 = phi_1599_;
                        let _e1171 = phi_1633_;
                        continue;
                        continuing {
                            phi_418_ = _e1167;
                            phi_421_ = _e1169;
                            phi_1978_ = _e1139;
                            break if !(_e1171);
                        }
                    }
                    let _e1174 = phi_1978_;
                    phi_2045_ = _e1174;
                    phi_1677_ = type_42();
                    if _e1174 {
                        break;
                    }
                    let _e1176 = local_4;
                    continue;
                    continuing {
                        phi_1925_ = _e1174;
                        let _e1196 = local_5;
                        phi_417_ = _e1196;
                        let _e1199 = local_6;
                        phi_420_ = _e1199;
                        phi_422_ = _e1145;
                        phi_2045_ = _e1174;
                        phi_1677_ = _e1145;
                        break if !(select(true, false, _e1176));
                    }
                }
                let _e1180 = phi_2045_;
                let _e1182 = phi_1677_;
                if _e1180 {
                    break;
                }
                if (_e89 < arrayLength((&hits.member))) {
                } else {
                    break;
                }
                hits.member[_e89] = _e1182;
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
