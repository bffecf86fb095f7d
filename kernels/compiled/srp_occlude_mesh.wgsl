struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
}

struct type_22 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
    member_4: vec4<f32>,
    member_5: vec4<f32>,
    member_6: array<u32, 4>,
    member_7: vec4<f32>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_32 {
    member: array<f32, 6>,
    member_1: array<u32, 3>,
    member_2: array<u32, 3>,
}

struct type_34 {
    member: array<type_32>,
}

struct type_44 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
}

struct type_47 {
    member: array<vec4<f32>>,
}

struct type_49 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
}

struct type_50 {
    member: type_49,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> hits: type_11;
@group(0) @binding(0) 
var<uniform> params: type_50;
@group(0) @binding(2) 
var<storage> distances: type_5;
@group(0) @binding(3) 
var<storage> rays: type_47;
@group(0) @binding(4) 
var<storage> nodes: type_24;
@group(0) @binding(5) 
var<storage> triangles: type_28;
@group(0) @binding(6) 
var<storage> attributes: type_34;
@group(0) @binding(7) 
var<storage> surfaces: type_11;
@group(0) @binding(8) 
var<storage, read_write> seen: type_11;

fn function_() {
    var local: array<u32, 64>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var phi_217_: u32;
    var phi_398_: bool;
    var phi_408_: u32;
    var phi_411_: bool;
    var phi_422_: u32;
    var phi_552_: f32;
    var phi_560_: f32;
    var phi_568_: f32;
    var phi_2132_: bool;
    var phi_571_: u32;
    var phi_574_: u32;
    var phi_999_: type_15;
    var phi_1000_: type_15;
    var phi_1023_: type_15;
    var phi_1139_: f32;
    var phi_1150_: f32;
    var phi_1161_: f32;
    var phi_1176_: f32;
    var phi_1177_: f32;
    var phi_1178_: bool;
    var phi_1179_: f32;
    var phi_1180_: bool;
    var phi_1199_: f32;
    var phi_1200_: bool;
    var phi_1201_: f32;
    var phi_1202_: bool;
    var phi_1203_: bool;
    var phi_1208_: f32;
    var phi_1209_: bool;
    var phi_1295_: array<f32, 3>;
    var phi_1296_: array<f32, 3>;
    var phi_1297_: array<f32, 3>;
    var phi_1298_: array<f32, 3>;
    var phi_1299_: bool;
    var phi_1300_: array<f32, 3>;
    var phi_1301_: array<f32, 3>;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1308_: array<f32, 3>;
    var phi_1313_: array<f32, 3>;
    var phi_1511_: f32;
    var phi_1526_: f32;
    var phi_1554_: u32;
    var phi_1564_: u32;
    var phi_1573_: bool;
    var phi_1589_: bool;
    var phi_1590_: bool;
    var phi_1613_: f32;
    var phi_1628_: f32;
    var phi_1656_: u32;
    var phi_1666_: u32;
    var phi_1675_: bool;
    var phi_1691_: bool;
    var phi_1692_: bool;
    var phi_1773_: bool;
    var phi_1778_: bool;
    var phi_1783_: type_44;
    var phi_1785_: type_44;
    var phi_1787_: bool;
    var phi_1788_: type_44;
    var phi_1790_: bool;
    var phi_1791_: bool;
    var phi_1792_: type_44;
    var phi_1793_: bool;
    var phi_1794_: bool;
    var phi_1795_: bool;
    var phi_1808_: type_44;
    var phi_1815_: bool;
    var phi_2128_: bool;
    var phi_1883_: bool;
    var phi_959_: u32;
    var phi_971_: u32;
    var phi_983_: u32;
    var phi_995_: u32;
    var phi_2215_: bool;
    var phi_1820_: u32;
    var phi_1821_: bool;
    var phi_1837_: u32;
    var phi_1838_: u32;
    var phi_572_: u32;
    var phi_575_: u32;
    var phi_1840_: bool;
    var phi_1841_: bool;
    var phi_2213_: bool;
    var phi_1884_: bool;
    var phi_1855_: u32;
    var phi_1856_: u32;
    var phi_1857_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e71 = gid_1;
            let _e77 = arrayLength((&rays.member));
            let _e80 = arrayLength((&nodes.member));
            let _e89 = arrayLength((&surfaces.member));
            let _e94 = params.member.member_6;
            let _e98 = (_e71.x + (_e71.y * 2097152u));
            if (_e98 < _e94) {
                let _e102 = params.member.member_1;
                let _e103 = (_e102 / 16u);
                if ((_e102 % 16u) > 0u) {
                    phi_217_ = (_e103 + 1u);
                } else {
                    phi_217_ = _e103;
                }
                let _e108 = phi_217_;
                let _e109 = (_e98 / 16u);
                let _e112 = params.member.member_3;
                if (_e112 == 0u) {
                    break;
                }
                let _e114 = (_e109 / _e112);
                if (_e108 == 0u) {
                    break;
                }
                let _e116 = (_e114 / _e108);
                let _e122 = ((((_e114 - (_e116 * _e108)) * 16u) + _e98) - (_e109 * 16u));
                let _e126 = (((_e116 * _e112) + _e109) - (_e114 * _e112));
                if (_e98 < arrayLength((&hits.member))) {
                } else {
                    break;
                }
                let _e130 = hits.member[_e98];
                if (_e122 < _e102) {
                    let _e134 = params.member.member_2;
                    if (_e126 < _e134) {
                        if (_e122 < _e77) {
                        } else {
                            break;
                        }
                        let _e139 = rays.member[_e122];
                        let _e146 = params.member.member[0u];
                        let _e156 = ((((_e146.x * _e139.x) + (_e146.y * _e139.y)) + (_e146.z * _e139.z)) + _e146.w);
                        let _e160 = params.member.member[1u];
                        let _e170 = ((((_e160.x * _e139.x) + (_e160.y * _e139.y)) + (_e160.z * _e139.z)) + _e160.w);
                        let _e174 = params.member.member[2u];
                        let _e184 = ((((_e174.x * _e139.x) + (_e174.y * _e139.y)) + (_e174.z * _e139.z)) + _e174.w);
                        let _e185 = (_e102 + _e126);
                        if (_e185 < _e77) {
                        } else {
                            break;
                        }
                        let _e189 = rays.member[_e185];
                        let _e197 = (((_e146.x * _e189.x) + (_e146.y * _e189.y)) + (_e146.z * _e189.z));
                        let _e202 = (((_e160.x * _e189.x) + (_e160.y * _e189.y)) + (_e160.z * _e189.z));
                        let _e207 = (((_e174.x * _e189.x) + (_e174.y * _e189.y)) + (_e174.z * _e189.z));
                        if (_e98 < arrayLength((&distances.member))) {
                        } else {
                            break;
                        }
                        let _e211 = distances.member[_e98];
                        let _e212 = abs(_e197);
                        let _e213 = abs(_e202);
                        let _e214 = abs(_e207);
                        let _e215 = (_e212 > _e213);
                        if _e215 {
                            phi_398_ = (_e212 > _e214);
                        } else {
                            phi_398_ = (_e213 > _e214);
                        }
                        let _e219 = phi_398_;
                        let _e220 = select(1u, 0u, _e215);
                        if _e219 {
                            let _e221 = (_e220 + 1u);
                            phi_408_ = _e221;
                            phi_411_ = select(true, false, (_e221 == 2u));
                        } else {
                            phi_408_ = u32();
                            phi_411_ = false;
                        }
                        let _e225 = phi_408_;
                        let _e227 = phi_411_;
                        let _e228 = select(true, false, _e219);
                        let _e229 = select(_e225, 0u, _e228);
                        let _e231 = select(_e227, true, _e228);
                        if _e231 {
                            phi_422_ = (_e229 + 1u);
                        } else {
                            phi_422_ = 0u;
                        }
                        let _e234 = phi_422_;
                        let _e235 = select(_e225, _e229, _e231);
                        let _e236 = select(_e220, select(_e220, 2u, _e228), _e231);
                        local_1 = array<f32, 3>(_e197, _e202, _e207);
                        local_2 = array<f32, 3>(_e156, _e170, _e184);
                        let _e239 = (_e236 < 3u);
                        if _e239 {
                        } else {
                            break;
                        }
                        let _e241 = local_1[_e236];
                        let _e242 = (1f / _e241);
                        let _e243 = (_e235 < 3u);
                        if _e243 {
                        } else {
                            break;
                        }
                        let _e245 = local_1[_e235];
                        let _e246 = (_e245 * _e242);
                        let _e247 = (_e234 < 3u);
                        if _e247 {
                        } else {
                            break;
                        }
                        let _e249 = local_1[_e234];
                        let _e250 = (_e249 * _e242);
                        if _e243 {
                        } else {
                            break;
                        }
                        let _e252 = local_2[_e235];
                        if _e247 {
                        } else {
                            break;
                        }
                        let _e254 = local_2[_e234];
                        if _e239 {
                        } else {
                            break;
                        }
                        let _e256 = local_2[_e236];
                        if (0u < _e80) {
                        } else {
                            break;
                        }
                        let _e261 = nodes.member[0u].member_7[0u];
                        let _e265 = nodes.member[0u].member_7[1u];
                        let _e269 = nodes.member[0u].member_7[2u];
                        let _e273 = nodes.member[0u].member_7[3u];
                        let _e275 = abs((_e156 - _e261));
                        let _e277 = abs((_e170 - _e265));
                        let _e279 = select(_e277, _e275, (_e275 > _e277));
                        let _e281 = abs((_e184 - _e269));
                        let _e285 = ((select(_e281, _e279, (_e279 > _e281)) + _e273) * 0.0000009536743f);
                        let _e292 = (_e285 + (abs(_e156) * 0.00000023841858f));
                        let _e293 = (_e285 + (abs(_e170) * 0.00000023841858f));
                        let _e294 = (_e285 + (abs(_e184) * 0.00000023841858f));
                        let _e295 = select(_e213, _e212, _e215);
                        let _e297 = select(_e214, _e295, (_e295 > _e214));
                        let _e298 = (_e297 * 0.000000000001f);
                        let _e299 = (_e156 + _e292);
                        let _e300 = (_e170 + _e293);
                        let _e301 = (_e184 + _e294);
                        let _e302 = (_e156 - _e292);
                        let _e303 = (_e170 - _e293);
                        let _e304 = (_e184 - _e294);
                        if (_e212 > _e298) {
                            phi_552_ = (1f / _e197);
                        } else {
                            phi_552_ = (1000000000000f / _e297);
                        }
                        let _e309 = phi_552_;
                        if (_e213 > _e298) {
                            phi_560_ = (1f / _e202);
                        } else {
                            phi_560_ = (1000000000000f / _e297);
                        }
                        let _e314 = phi_560_;
                        if (_e214 > _e298) {
                            phi_568_ = (1f / _e207);
                        } else {
                            phi_568_ = (1000000000000f / _e297);
                        }
                        let _e319 = phi_568_;
                        local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        phi_2132_ = false;
                        phi_571_ = 0u;
                        phi_574_ = 0u;
                        loop {
                            let _e322 = phi_2132_;
                            let _e324 = phi_571_;
                            let _e326 = phi_574_;
                            let _e327 = (_e324 & 15u);
                            let _e329 = (_e324 >> bitcast<u32>(4u));
                            if (_e327 == 0u) {
                                if (_e329 < _e80) {
                                } else {
                                    phi_2213_ = true;
                                    phi_1884_ = bool();
                                    break;
                                }
                                let _e1026 = nodes.member[_e329].member;
                                let _e1035 = ((_e1026.x - _e299) * _e309);
                                let _e1036 = ((_e1026.y - _e299) * _e309);
                                let _e1037 = ((_e1026.z - _e299) * _e309);
                                let _e1038 = ((_e1026.w - _e299) * _e309);
                                let _e1041 = nodes.member[_e329].member_3;
                                let _e1050 = ((_e1041.x - _e302) * _e309);
                                let _e1051 = ((_e1041.y - _e302) * _e309);
                                let _e1052 = ((_e1041.z - _e302) * _e309);
                                let _e1053 = ((_e1041.w - _e302) * _e309);
                                let _e1056 = nodes.member[_e329].member_1;
                                let _e1065 = ((_e1056.x - _e300) * _e314);
                                let _e1066 = ((_e1056.y - _e300) * _e314);
                                let _e1067 = ((_e1056.z - _e300) * _e314);
                                let _e1068 = ((_e1056.w - _e300) * _e314);
                                let _e1071 = nodes.member[_e329].member_4;
                                let _e1080 = ((_e1071.x - _e303) * _e314);
                                let _e1081 = ((_e1071.y - _e303) * _e314);
                                let _e1082 = ((_e1071.z - _e303) * _e314);
                                let _e1083 = ((_e1071.w - _e303) * _e314);
                                let _e1086 = nodes.member[_e329].member_2;
                                let _e1095 = ((_e1086.x - _e301) * _e319);
                                let _e1096 = ((_e1086.y - _e301) * _e319);
                                let _e1097 = ((_e1086.z - _e301) * _e319);
                                let _e1098 = ((_e1086.w - _e301) * _e319);
                                let _e1101 = nodes.member[_e329].member_5;
                                let _e1110 = ((_e1101.x - _e304) * _e319);
                                let _e1111 = ((_e1101.y - _e304) * _e319);
                                let _e1112 = ((_e1101.z - _e304) * _e319);
                                let _e1113 = ((_e1101.w - _e304) * _e319);
                                let _e1115 = select(_e1050, _e1035, (_e1035 < _e1050));
                                let _e1117 = select(_e1051, _e1036, (_e1036 < _e1051));
                                let _e1119 = select(_e1052, _e1037, (_e1037 < _e1052));
                                let _e1121 = select(_e1053, _e1038, (_e1038 < _e1053));
                                let _e1123 = select(_e1080, _e1065, (_e1065 < _e1080));
                                let _e1125 = select(_e1081, _e1066, (_e1066 < _e1081));
                                let _e1127 = select(_e1082, _e1067, (_e1067 < _e1082));
                                let _e1129 = select(_e1083, _e1068, (_e1068 < _e1083));
                                let _e1131 = select(_e1123, _e1115, (_e1115 > _e1123));
                                let _e1133 = select(_e1125, _e1117, (_e1117 > _e1125));
                                let _e1135 = select(_e1127, _e1119, (_e1119 > _e1127));
                                let _e1137 = select(_e1129, _e1121, (_e1121 > _e1129));
                                let _e1139 = select(_e1110, _e1095, (_e1095 < _e1110));
                                let _e1141 = select(_e1111, _e1096, (_e1096 < _e1111));
                                let _e1143 = select(_e1112, _e1097, (_e1097 < _e1112));
                                let _e1145 = select(_e1113, _e1098, (_e1098 < _e1113));
                                let _e1147 = select(_e1139, _e1131, (_e1131 > _e1139));
                                let _e1149 = select(_e1141, _e1133, (_e1133 > _e1141));
                                let _e1151 = select(_e1143, _e1135, (_e1135 > _e1143));
                                let _e1153 = select(_e1145, _e1137, (_e1137 > _e1145));
                                let _e1155 = select(0f, _e1147, (_e1147 > 0f));
                                let _e1157 = select(0f, _e1149, (_e1149 > 0f));
                                let _e1159 = select(0f, _e1151, (_e1151 > 0f));
                                let _e1161 = select(0f, _e1153, (_e1153 > 0f));
                                let _e1163 = select(_e1050, _e1035, (_e1035 > _e1050));
                                let _e1165 = select(_e1051, _e1036, (_e1036 > _e1051));
                                let _e1167 = select(_e1052, _e1037, (_e1037 > _e1052));
                                let _e1169 = select(_e1053, _e1038, (_e1038 > _e1053));
                                let _e1171 = select(_e1080, _e1065, (_e1065 > _e1080));
                                let _e1173 = select(_e1081, _e1066, (_e1066 > _e1081));
                                let _e1175 = select(_e1082, _e1067, (_e1067 > _e1082));
                                let _e1177 = select(_e1083, _e1068, (_e1068 > _e1083));
                                let _e1179 = select(_e1171, _e1163, (_e1163 < _e1171));
                                let _e1181 = select(_e1173, _e1165, (_e1165 < _e1173));
                                let _e1183 = select(_e1175, _e1167, (_e1167 < _e1175));
                                let _e1185 = select(_e1177, _e1169, (_e1169 < _e1177));
                                let _e1187 = select(_e1110, _e1095, (_e1095 > _e1110));
                                let _e1189 = select(_e1111, _e1096, (_e1096 > _e1111));
                                let _e1191 = select(_e1112, _e1097, (_e1097 > _e1112));
                                let _e1193 = select(_e1113, _e1098, (_e1098 > _e1113));
                                let _e1195 = select(_e1187, _e1179, (_e1179 < _e1187));
                                let _e1197 = select(_e1189, _e1181, (_e1181 < _e1189));
                                let _e1199 = select(_e1191, _e1183, (_e1183 < _e1191));
                                let _e1201 = select(_e1193, _e1185, (_e1185 < _e1193));
                                let _e1221 = nodes.member[_e329].member_6[0u];
                                let _e1225 = nodes.member[_e329].member_6[1u];
                                let _e1229 = nodes.member[_e329].member_6[2u];
                                let _e1233 = nodes.member[_e329].member_6[3u];
                                if (select(340282350000000000000000000000000000000f, _e1161, (_e1161 <= select(_e211, _e1201, (_e1201 < _e211)))) < 340282350000000000000000000000000000000f) {
                                    if (_e326 < 64u) {
                                    } else {
                                        phi_2213_ = true;
                                        phi_1884_ = bool();
                                        break;
                                    }
                                    local[_e326] = _e1233;
                                    phi_959_ = (_e326 + 1u);
                                } else {
                                    phi_959_ = _e326;
                                }
                                let _e1239 = phi_959_;
                                if (select(340282350000000000000000000000000000000f, _e1159, (_e1159 <= select(_e211, _e1199, (_e1199 < _e211)))) < 340282350000000000000000000000000000000f) {
                                    if (_e1239 < 64u) {
                                    } else {
                                        phi_2213_ = true;
                                        phi_1884_ = bool();
                                        break;
                                    }
                                    local[_e1239] = _e1229;
                                    phi_971_ = (_e1239 + 1u);
                                } else {
                                    phi_971_ = _e1239;
                                }
                                let _e1245 = phi_971_;
                                if (select(340282350000000000000000000000000000000f, _e1157, (_e1157 <= select(_e211, _e1197, (_e1197 < _e211)))) < 340282350000000000000000000000000000000f) {
                                    if (_e1245 < 64u) {
                                    } else {
                                        phi_2213_ = true;
                                        phi_1884_ = bool();
                                        break;
                                    }
                                    local[_e1245] = _e1225;
                                    phi_983_ = (_e1245 + 1u);
                                } else {
                                    phi_983_ = _e1245;
                                }
                                let _e1251 = phi_983_;
                                if (select(340282350000000000000000000000000000000f, _e1155, (_e1155 <= select(_e211, _e1195, (_e1195 < _e211)))) < 340282350000000000000000000000000000000f) {
                                    if (_e1251 < 64u) {
                                    } else {
                                        phi_2213_ = true;
                                        phi_1884_ = bool();
                                        break;
                                    }
                                    local[_e1251] = _e1221;
                                    phi_995_ = (_e1251 + 1u);
                                } else {
                                    phi_995_ = _e1251;
                                }
                                let _e1257 = phi_995_;
                                phi_2215_ = _e322;
                                phi_1820_ = _e1257;
                                phi_1821_ = true;
                            } else {
                                phi_999_ = type_15(_e329, (_e329 + _e327));
                                loop {
                                    let _e334 = phi_999_;
                                    if (_e334.member < _e334.member_1) {
                                        phi_1000_ = type_15((_e334.member + 1u), _e334.member_1);
                                        phi_1023_ = type_15(1u, _e334.member);
                                    } else {
                                        phi_1000_ = _e334;
                                        phi_1023_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e347 = phi_1000_;
                                    let _e349 = phi_1023_;
                                    let _e353 = (bitcast<i32>(_e349.member) != 0i);
                                    if _e353 {
                                        let _e354 = (_e349.member_1 < arrayLength((&triangles.member)));
                                        if _e354 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        if _e239 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        let _e358 = triangles.member[_e349.member_1].member[_e236];
                                        let _e359 = (_e358 - _e256);
                                        if _e239 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        let _e363 = triangles.member[_e349.member_1].member_2[_e236];
                                        let _e364 = (_e363 - _e256);
                                        if _e239 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        let _e368 = triangles.member[_e349.member_1].member_4[_e236];
                                        let _e369 = (_e368 - _e256);
                                        if _e243 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        let _e373 = triangles.member[_e349.member_1].member[_e235];
                                        let _e376 = ((_e373 - _e252) - (_e246 * _e359));
                                        if _e247 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        let _e380 = triangles.member[_e349.member_1].member[_e234];
                                        let _e383 = ((_e380 - _e254) - (_e250 * _e359));
                                        if _e243 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        let _e387 = triangles.member[_e349.member_1].member_2[_e235];
                                        let _e390 = ((_e387 - _e252) - (_e246 * _e364));
                                        if _e247 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        let _e394 = triangles.member[_e349.member_1].member_2[_e234];
                                        let _e397 = ((_e394 - _e254) - (_e250 * _e364));
                                        if _e243 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        let _e401 = triangles.member[_e349.member_1].member_4[_e235];
                                        let _e404 = ((_e401 - _e252) - (_e246 * _e369));
                                        if _e247 {
                                        } else {
                                            phi_2128_ = true;
                                            phi_1883_ = bool();
                                            break;
                                        }
                                        let _e408 = triangles.member[_e349.member_1].member_4[_e234];
                                        let _e411 = ((_e408 - _e254) - (_e250 * _e369));
                                        let _e412 = (_e404 * _e397);
                                        let _e413 = (_e411 * _e390);
                                        if (_e412 != _e413) {
                                            phi_1139_ = (_e412 - _e413);
                                        } else {
                                            let _e415 = (_e404 * 4097f);
                                            let _e417 = (_e415 - (_e415 - _e404));
                                            let _e418 = (_e397 * 4097f);
                                            let _e420 = (_e418 - (_e418 - _e397));
                                            let _e421 = (_e404 - _e417);
                                            let _e422 = (_e397 - _e420);
                                            let _e431 = (_e411 * 4097f);
                                            let _e433 = (_e431 - (_e431 - _e411));
                                            let _e434 = (_e390 * 4097f);
                                            let _e436 = (_e434 - (_e434 - _e390));
                                            let _e437 = (_e411 - _e433);
                                            let _e438 = (_e390 - _e436);
                                            phi_1139_ = ((((((_e417 * _e420) - _e412) + (_e417 * _e422)) + (_e421 * _e420)) + (_e421 * _e422)) - (((((_e433 * _e436) - _e413) + (_e433 * _e438)) + (_e437 * _e436)) + (_e437 * _e438)));
                                        }
                                        let _e450 = phi_1139_;
                                        let _e451 = (_e376 * _e411);
                                        let _e452 = (_e383 * _e404);
                                        if (_e451 != _e452) {
                                            phi_1150_ = (_e451 - _e452);
                                        } else {
                                            let _e454 = (_e376 * 4097f);
                                            let _e456 = (_e454 - (_e454 - _e376));
                                            let _e457 = (_e411 * 4097f);
                                            let _e459 = (_e457 - (_e457 - _e411));
                                            let _e460 = (_e376 - _e456);
                                            let _e461 = (_e411 - _e459);
                                            let _e470 = (_e383 * 4097f);
                                            let _e472 = (_e470 - (_e470 - _e383));
                                            let _e473 = (_e404 * 4097f);
                                            let _e475 = (_e473 - (_e473 - _e404));
                                            let _e476 = (_e383 - _e472);
                                            let _e477 = (_e404 - _e475);
                                            phi_1150_ = ((((((_e456 * _e459) - _e451) + (_e456 * _e461)) + (_e460 * _e459)) + (_e460 * _e461)) - (((((_e472 * _e475) - _e452) + (_e472 * _e477)) + (_e476 * _e475)) + (_e476 * _e477)));
                                        }
                                        let _e489 = phi_1150_;
                                        let _e490 = (_e390 * _e383);
                                        let _e491 = (_e397 * _e376);
                                        if (_e490 != _e491) {
                                            phi_1161_ = (_e490 - _e491);
                                        } else {
                                            let _e493 = (_e390 * 4097f);
                                            let _e495 = (_e493 - (_e493 - _e390));
                                            let _e496 = (_e383 * 4097f);
                                            let _e498 = (_e496 - (_e496 - _e383));
                                            let _e499 = (_e390 - _e495);
                                            let _e500 = (_e383 - _e498);
                                            let _e509 = (_e397 * 4097f);
                                            let _e511 = (_e509 - (_e509 - _e397));
                                            let _e512 = (_e376 * 4097f);
                                            let _e514 = (_e512 - (_e512 - _e376));
                                            let _e515 = (_e397 - _e511);
                                            let _e516 = (_e376 - _e514);
                                            phi_1161_ = ((((((_e495 * _e498) - _e490) + (_e495 * _e500)) + (_e499 * _e498)) + (_e499 * _e500)) - (((((_e511 * _e514) - _e491) + (_e511 * _e516)) + (_e515 * _e514)) + (_e515 * _e516)));
                                        }
                                        let _e528 = phi_1161_;
                                        if (_e450 < 0f) {
                                            phi_1179_ = f32();
                                            phi_1180_ = true;
                                        } else {
                                            if (_e489 < 0f) {
                                                phi_1177_ = f32();
                                                phi_1178_ = true;
                                            } else {
                                                let _e531 = (_e528 < 0f);
                                                if _e531 {
                                                    phi_1176_ = f32();
                                                } else {
                                                    phi_1176_ = ((_e450 + _e489) + _e528);
                                                }
                                                let _e535 = phi_1176_;
                                                phi_1177_ = _e535;
                                                phi_1178_ = _e531;
                                            }
                                            let _e537 = phi_1177_;
                                            let _e539 = phi_1178_;
                                            phi_1179_ = _e537;
                                            phi_1180_ = _e539;
                                        }
                                        let _e541 = phi_1179_;
                                        let _e543 = phi_1180_;
                                        if _e543 {
                                            if (_e450 > 0f) {
                                                phi_1201_ = f32();
                                                phi_1202_ = true;
                                                phi_1203_ = false;
                                            } else {
                                                let _e545 = (_e489 > 0f);
                                                if _e545 {
                                                    phi_1199_ = f32();
                                                    phi_1200_ = false;
                                                } else {
                                                    phi_1199_ = ((_e450 + _e489) + _e528);
                                                    phi_1200_ = select(true, false, (_e528 > 0f));
                                                }
                                                let _e551 = phi_1199_;
                                                let _e553 = phi_1200_;
                                                phi_1201_ = _e551;
                                                phi_1202_ = _e545;
                                                phi_1203_ = _e553;
                                            }
                                            let _e555 = phi_1201_;
                                            let _e557 = phi_1202_;
                                            let _e559 = phi_1203_;
                                            phi_1208_ = _e555;
                                            phi_1209_ = select(_e559, false, _e557);
                                        } else {
                                            phi_1208_ = _e541;
                                            phi_1209_ = true;
                                        }
                                        let _e562 = phi_1208_;
                                        let _e564 = phi_1209_;
                                        if _e564 {
                                            let _e565 = (_e562 == 0f);
                                            if _e565 {
                                                phi_1297_ = array<f32, 3>();
                                                phi_1298_ = array<f32, 3>();
                                                phi_1299_ = false;
                                            } else {
                                                let _e566 = (_e359 * _e242);
                                                let _e567 = (_e364 * _e242);
                                                let _e568 = (_e369 * _e242);
                                                let _e571 = (1f / ((_e450 + _e489) + _e528));
                                                let _e572 = (_e489 * _e571);
                                                let _e573 = (_e528 * _e571);
                                                let _e579 = ((((_e450 * _e571) * _e566) + (_e572 * _e567)) + (_e573 * _e568));
                                                let _e580 = abs(_e376);
                                                let _e581 = abs(_e390);
                                                let _e583 = select(_e581, _e580, (_e580 > _e581));
                                                let _e584 = abs(_e404);
                                                let _e587 = abs(_e383);
                                                let _e588 = abs(_e397);
                                                let _e590 = select(_e588, _e587, (_e587 > _e588));
                                                let _e591 = abs(_e411);
                                                let _e595 = abs(_e566);
                                                let _e596 = abs(_e567);
                                                let _e598 = select(_e596, _e595, (_e595 > _e596));
                                                let _e599 = abs(_e568);
                                                let _e606 = (((select(_e584, _e583, (_e583 > _e584)) * select(_e591, _e590, (_e590 > _e591))) * select(_e599, _e598, (_e598 > _e599))) <= (abs((_e562 * _e579)) * 256f));
                                                if _e606 {
                                                    phi_1295_ = array<f32, 3>(_e579, _e572, _e573);
                                                    phi_1296_ = array<f32, 3>();
                                                } else {
                                                    let _e608 = (_e404 * 4097f);
                                                    let _e610 = (_e608 - (_e608 - _e404));
                                                    let _e611 = (_e397 * 4097f);
                                                    let _e613 = (_e611 - (_e611 - _e397));
                                                    let _e614 = (_e404 - _e610);
                                                    let _e615 = (_e397 - _e613);
                                                    let _e624 = (_e411 * 4097f);
                                                    let _e626 = (_e624 - (_e624 - _e411));
                                                    let _e627 = (_e390 * 4097f);
                                                    let _e629 = (_e627 - (_e627 - _e390));
                                                    let _e630 = (_e411 - _e626);
                                                    let _e631 = (_e390 - _e629);
                                                    let _e641 = ((_e412 - _e413) + ((((((_e610 * _e613) - _e412) + (_e610 * _e615)) + (_e614 * _e613)) + (_e614 * _e615)) - (((((_e626 * _e629) - _e413) + (_e626 * _e631)) + (_e630 * _e629)) + (_e630 * _e631))));
                                                    let _e643 = (_e376 * 4097f);
                                                    let _e645 = (_e643 - (_e643 - _e376));
                                                    let _e646 = (_e376 - _e645);
                                                    let _e655 = (_e383 * 4097f);
                                                    let _e657 = (_e655 - (_e655 - _e383));
                                                    let _e658 = (_e383 - _e657);
                                                    let _e668 = ((_e451 - _e452) + ((((((_e645 * _e626) - _e451) + (_e645 * _e630)) + (_e646 * _e626)) + (_e646 * _e630)) - (((((_e657 * _e610) - _e452) + (_e657 * _e614)) + (_e658 * _e610)) + (_e658 * _e614))));
                                                    let _e687 = ((_e490 - _e491) + ((((((_e629 * _e657) - _e490) + (_e629 * _e658)) + (_e631 * _e657)) + (_e631 * _e658)) - (((((_e613 * _e645) - _e491) + (_e613 * _e646)) + (_e615 * _e645)) + (_e615 * _e646))));
                                                    let _e690 = (1f / ((_e641 + _e668) + _e687));
                                                    let _e691 = (_e668 * _e690);
                                                    let _e692 = (_e687 * _e690);
                                                    phi_1295_ = array<f32, 3>();
                                                    phi_1296_ = array<f32, 3>(((((_e641 * _e690) * _e566) + (_e691 * _e567)) + (_e692 * _e568)), _e691, _e692);
                                                }
                                                let _e702 = phi_1295_;
                                                let _e704 = phi_1296_;
                                                phi_1297_ = _e702;
                                                phi_1298_ = _e704;
                                                phi_1299_ = _e606;
                                            }
                                            let _e706 = phi_1297_;
                                            let _e708 = phi_1298_;
                                            let _e710 = phi_1299_;
                                            phi_1300_ = _e706;
                                            phi_1301_ = _e708;
                                            phi_1302_ = _e565;
                                            phi_1303_ = _e710;
                                        } else {
                                            phi_1300_ = array<f32, 3>();
                                            phi_1301_ = array<f32, 3>();
                                            phi_1302_ = true;
                                            phi_1303_ = false;
                                        }
                                        let _e712 = phi_1300_;
                                        let _e714 = phi_1301_;
                                        let _e716 = phi_1302_;
                                        let _e718 = phi_1303_;
                                        if _e716 {
                                            phi_1308_ = array<f32, 3>(-1f, 0f, 0f);
                                        } else {
                                            phi_1308_ = _e712;
                                        }
                                        let _e720 = phi_1308_;
                                        if select(_e718, true, _e716) {
                                            phi_1313_ = _e720;
                                        } else {
                                            phi_1313_ = _e714;
                                        }
                                        let _e723 = phi_1313_;
                                        let _e727 = (_e723[0] >= 0f);
                                        if _e727 {
                                            let _e728 = (_e723[0] < _e211);
                                            if _e728 {
                                                if _e727 {
                                                    if _e354 {
                                                    } else {
                                                        phi_2128_ = true;
                                                        phi_1883_ = bool();
                                                        break;
                                                    }
                                                    let _e731 = triangles.member[_e349.member_1].member_3;
                                                    if ((_e731 & 1u) == 0u) {
                                                        phi_1778_ = true;
                                                    } else {
                                                        if _e354 {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        let _e736 = triangles.member[_e349.member_1].member_1;
                                                        let _e737 = (_e736 * 12u);
                                                        if ((256u + _e737) < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        if ((_e737 + 257u) < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        if ((_e737 + 258u) < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        let _e744 = (_e737 + 259u);
                                                        if (_e744 < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        let _e747 = surfaces.member[_e744];
                                                        if ((_e737 + 260u) < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        if ((_e737 + 261u) < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        if ((_e737 + 262u) < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        let _e754 = (_e737 + 263u);
                                                        if (_e754 < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        let _e757 = surfaces.member[_e754];
                                                        let _e758 = (_e737 + 264u);
                                                        if (_e758 < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        let _e761 = surfaces.member[_e758];
                                                        let _e762 = bitcast<f32>(_e761);
                                                        let _e763 = (_e737 + 265u);
                                                        if (_e763 < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        let _e766 = surfaces.member[_e763];
                                                        let _e767 = bitcast<f32>(_e766);
                                                        if ((_e737 + 266u) < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        if ((_e737 + 267u) < _e89) {
                                                        } else {
                                                            phi_2128_ = true;
                                                            phi_1883_ = bool();
                                                            break;
                                                        }
                                                        if (_e747 == 4294967295u) {
                                                            phi_1773_ = (_e762 < _e767);
                                                        } else {
                                                            if (_e349.member_1 < arrayLength((&attributes.member))) {
                                                            } else {
                                                                phi_2128_ = true;
                                                                phi_1883_ = bool();
                                                                break;
                                                            }
                                                            let _e775 = ((1f - _e723[1]) - _e723[2]);
                                                            let _e779 = attributes.member[_e349.member_1].member[0u];
                                                            let _e784 = attributes.member[_e349.member_1].member[2u];
                                                            let _e790 = attributes.member[_e349.member_1].member[4u];
                                                            let _e792 = (((_e779 * _e775) + (_e784 * _e723[1])) + (_e790 * _e723[2]));
                                                            let _e796 = attributes.member[_e349.member_1].member[1u];
                                                            let _e801 = attributes.member[_e349.member_1].member[3u];
                                                            let _e807 = attributes.member[_e349.member_1].member[5u];
                                                            let _e809 = (((_e796 * _e775) + (_e801 * _e723[1])) + (_e807 * _e723[2]));
                                                            let _e810 = (_e757 & 65535u);
                                                            let _e812 = (_e757 >> bitcast<u32>(16i));
                                                            let _e815 = ((_e747 >> bitcast<u32>(28u)) & 3u);
                                                            let _e816 = (_e810 - 1u);
                                                            let _e818 = select(1f, 2f, (_e815 == 2u));
                                                            let _e822 = (_e792 - (floor((_e792 / _e818)) * _e818));
                                                            if (_e822 > 1f) {
                                                                phi_1511_ = (_e818 - _e822);
                                                            } else {
                                                                phi_1511_ = _e822;
                                                            }
                                                            let _e826 = phi_1511_;
                                                            if (_e815 == 1u) {
                                                                let _e829 = select(0f, _e792, (_e792 > 0f));
                                                                phi_1526_ = select(1f, _e829, (_e829 < 1f));
                                                            } else {
                                                                phi_1526_ = _e826;
                                                            }
                                                            let _e833 = phi_1526_;
                                                            let _e840 = ((select(0f, _e833, (abs((_e833 - 0.5f)) <= 0.5f)) * f32(_e810)) - 0.5f);
                                                            let _e841 = floor(_e840);
                                                            let _e842 = (_e841 < 0f);
                                                            if _e842 {
                                                                phi_1554_ = 0u;
                                                            } else {
                                                                let _e847 = select(select(u32(_e841), 0u, (_e841 < 0f)), 4294967295u, (_e841 > 4294967000f));
                                                                phi_1554_ = select(_e847, _e816, (_e816 < _e847));
                                                            }
                                                            let _e851 = phi_1554_;
                                                            if _e842 {
                                                                phi_1564_ = 0u;
                                                            } else {
                                                                let _e852 = (_e851 + 1u);
                                                                phi_1564_ = select(_e852, _e816, (_e816 < _e852));
                                                            }
                                                            let _e856 = phi_1564_;
                                                            let _e857 = (_e815 == 0u);
                                                            if _e857 {
                                                                phi_1573_ = select(true, false, _e842);
                                                            } else {
                                                                phi_1573_ = true;
                                                            }
                                                            let _e860 = phi_1573_;
                                                            let _e861 = select(_e816, _e851, _e860);
                                                            if _e857 {
                                                                if _e842 {
                                                                    phi_1589_ = true;
                                                                } else {
                                                                    phi_1589_ = select(true, false, (_e861 == _e816));
                                                                }
                                                                let _e865 = phi_1589_;
                                                                phi_1590_ = _e865;
                                                            } else {
                                                                phi_1590_ = true;
                                                            }
                                                            let _e867 = phi_1590_;
                                                            let _e868 = select(0u, _e856, _e867);
                                                            let _e869 = (_e840 - _e841);
                                                            let _e872 = ((_e747 >> bitcast<u32>(30u)) & 3u);
                                                            let _e873 = (_e812 - 1u);
                                                            let _e875 = select(1f, 2f, (_e872 == 2u));
                                                            let _e879 = (_e809 - (floor((_e809 / _e875)) * _e875));
                                                            if (_e879 > 1f) {
                                                                phi_1613_ = (_e875 - _e879);
                                                            } else {
                                                                phi_1613_ = _e879;
                                                            }
                                                            let _e883 = phi_1613_;
                                                            if (_e872 == 1u) {
                                                                let _e886 = select(0f, _e809, (_e809 > 0f));
                                                                phi_1628_ = select(1f, _e886, (_e886 < 1f));
                                                            } else {
                                                                phi_1628_ = _e883;
                                                            }
                                                            let _e890 = phi_1628_;
                                                            let _e897 = ((select(0f, _e890, (abs((_e890 - 0.5f)) <= 0.5f)) * f32(_e812)) - 0.5f);
                                                            let _e898 = floor(_e897);
                                                            let _e899 = (_e898 < 0f);
                                                            if _e899 {
                                                                phi_1656_ = 0u;
                                                            } else {
                                                                let _e904 = select(select(u32(_e898), 0u, (_e898 < 0f)), 4294967295u, (_e898 > 4294967000f));
                                                                phi_1656_ = select(_e904, _e873, (_e873 < _e904));
                                                            }
                                                            let _e908 = phi_1656_;
                                                            if _e899 {
                                                                phi_1666_ = 0u;
                                                            } else {
                                                                let _e909 = (_e908 + 1u);
                                                                phi_1666_ = select(_e909, _e873, (_e873 < _e909));
                                                            }
                                                            let _e913 = phi_1666_;
                                                            let _e914 = (_e872 == 0u);
                                                            if _e914 {
                                                                phi_1675_ = select(true, false, _e899);
                                                            } else {
                                                                phi_1675_ = true;
                                                            }
                                                            let _e917 = phi_1675_;
                                                            let _e918 = select(_e873, _e908, _e917);
                                                            if _e914 {
                                                                if _e899 {
                                                                    phi_1691_ = true;
                                                                } else {
                                                                    phi_1691_ = select(true, false, (_e918 == _e873));
                                                                }
                                                                let _e922 = phi_1691_;
                                                                phi_1692_ = _e922;
                                                            } else {
                                                                phi_1692_ = true;
                                                            }
                                                            let _e924 = phi_1692_;
                                                            let _e926 = (_e897 - _e898);
                                                            let _e927 = (_e747 & 268435455u);
                                                            let _e929 = (_e927 + (_e918 * _e810));
                                                            let _e931 = (_e927 + (select(0u, _e913, _e924) * _e810));
                                                            let _e932 = (_e929 + _e861);
                                                            let _e933 = (_e929 + _e868);
                                                            let _e934 = (_e931 + _e861);
                                                            let _e935 = (_e931 + _e868);
                                                            if (_e932 < _e89) {
                                                            } else {
                                                                phi_2128_ = true;
                                                                phi_1883_ = bool();
                                                                break;
                                                            }
                                                            let _e938 = surfaces.member[_e932];
                                                            if (_e933 < _e89) {
                                                            } else {
                                                                phi_2128_ = true;
                                                                phi_1883_ = bool();
                                                                break;
                                                            }
                                                            let _e941 = surfaces.member[_e933];
                                                            if (_e934 < _e89) {
                                                            } else {
                                                                phi_2128_ = true;
                                                                phi_1883_ = bool();
                                                                break;
                                                            }
                                                            let _e944 = surfaces.member[_e934];
                                                            if (_e935 < _e89) {
                                                            } else {
                                                                phi_2128_ = true;
                                                                phi_1883_ = bool();
                                                                break;
                                                            }
                                                            let _e947 = surfaces.member[_e935];
                                                            let _e964 = (1f - _e869);
                                                            phi_1773_ = ((_e762 * (((((f32((_e938 >> bitcast<u32>(24i))) * 0.003921569f) * _e964) + ((f32((_e941 >> bitcast<u32>(24i))) * 0.003921569f) * _e869)) * (1f - _e926)) + ((((f32((_e944 >> bitcast<u32>(24i))) * 0.003921569f) * _e964) + ((f32((_e947 >> bitcast<u32>(24i))) * 0.003921569f) * _e869)) * _e926))) < _e767);
                                                        }
                                                        let _e979 = phi_1773_;
                                                        phi_1778_ = select(true, false, _e979);
                                                    }
                                                    let _e982 = phi_1778_;
                                                    if _e982 {
                                                        phi_1783_ = type_44(_e723[0], _e349.member_1, _e723[1], _e723[2]);
                                                    } else {
                                                        phi_1783_ = type_44();
                                                    }
                                                    let _e985 = phi_1783_;
                                                    phi_1785_ = _e985;
                                                    phi_1787_ = select(true, false, _e982);
                                                } else {
                                                    phi_1785_ = type_44();
                                                    phi_1787_ = false;
                                                }
                                                let _e988 = phi_1785_;
                                                let _e990 = phi_1787_;
                                                phi_1788_ = _e988;
                                                phi_1790_ = select(true, false, _e727);
                                                phi_1791_ = _e990;
                                            } else {
                                                phi_1788_ = type_44();
                                                phi_1790_ = false;
                                                phi_1791_ = false;
                                            }
                                            let _e993 = phi_1788_;
                                            let _e995 = phi_1790_;
                                            let _e997 = phi_1791_;
                                            phi_1792_ = _e993;
                                            phi_1793_ = select(true, false, _e728);
                                            phi_1794_ = _e995;
                                            phi_1795_ = _e997;
                                        } else {
                                            phi_1792_ = type_44();
                                            phi_1793_ = true;
                                            phi_1794_ = false;
                                            phi_1795_ = false;
                                        }
                                        let _e1000 = phi_1792_;
                                        let _e1002 = phi_1793_;
                                        let _e1004 = phi_1794_;
                                        let _e1006 = phi_1795_;
                                        if select(select(_e1006, false, _e1002), true, select(_e1004, true, _e1002)) {
                                            phi_1808_ = type_44(_e211, 4294967295u, 0f, 0f);
                                        } else {
                                            phi_1808_ = _e1000;
                                        }
                                        let _e1011 = phi_1808_;
                                        phi_1815_ = select(true, false, (_e1011.member_1 != 4294967295u));
                                    } else {
                                        phi_1815_ = false;
                                    }
                                    let _e1016 = phi_1815_;
                                    continue;
                                    continuing {
                                        phi_999_ = _e347;
                                        phi_2128_ = _e322;
                                        phi_1883_ = select(true, false, _e353);
                                        break if !(_e1016);
                                    }
                                }
                                let _e1020 = phi_2128_;
                                let _e1022 = phi_1883_;
                                phi_2213_ = _e1020;
                                phi_1884_ = bool();
                                if _e1020 {
                                    break;
                                }
                                phi_2215_ = _e1020;
                                phi_1820_ = _e326;
                                phi_1821_ = _e1022;
                            }
                            let _e1259 = phi_2215_;
                            let _e1261 = phi_1820_;
                            let _e1263 = phi_1821_;
                            if _e1263 {
                                let _e1264 = (_e1261 == 0u);
                                if _e1264 {
                                    phi_1837_ = u32();
                                    phi_1838_ = u32();
                                } else {
                                    let _e1265 = (_e1261 - 1u);
                                    if (_e1265 < 64u) {
                                    } else {
                                        phi_2213_ = true;
                                        phi_1884_ = bool();
                                        break;
                                    }
                                    let _e1268 = local[_e1265];
                                    phi_1837_ = _e1268;
                                    phi_1838_ = _e1265;
                                }
                                let _e1270 = phi_1837_;
                                let _e1272 = phi_1838_;
                                phi_572_ = _e1270;
                                phi_575_ = _e1272;
                                phi_1840_ = select(true, false, _e1264);
                                phi_1841_ = _e1264;
                            } else {
                                phi_572_ = u32();
                                phi_575_ = u32();
                                phi_1840_ = false;
                                phi_1841_ = false;
                            }
                            let _e1275 = phi_572_;
                            let _e1277 = phi_575_;
                            let _e1279 = phi_1840_;
                            let _e1281 = phi_1841_;
                            continue;
                            continuing {
                                phi_2132_ = _e1259;
                                phi_571_ = _e1275;
                                phi_574_ = _e1277;
                                phi_2213_ = _e1259;
                                phi_1884_ = _e1281;
                                break if !(_e1279);
                            }
                        }
                        let _e1284 = phi_2213_;
                        let _e1286 = phi_1884_;
                        if _e1284 {
                            break;
                        }
                        if select(false, true, select(true, false, _e1286)) {
                            let _e1291 = params.member.member_5;
                            phi_1855_ = _e1291;
                        } else {
                            phi_1855_ = _e130;
                        }
                        let _e1293 = phi_1855_;
                        phi_1856_ = _e1293;
                    } else {
                        phi_1856_ = _e130;
                    }
                    let _e1295 = phi_1856_;
                    phi_1857_ = _e1295;
                } else {
                    phi_1857_ = _e130;
                }
                let _e1297 = phi_1857_;
                if (_e98 < arrayLength((&seen.member))) {
                } else {
                    break;
                }
                seen.member[_e98] = _e1297;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_occlude_mesh(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
