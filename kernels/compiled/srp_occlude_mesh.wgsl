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
    var phi_213_: u32;
    var phi_394_: bool;
    var phi_404_: u32;
    var phi_407_: bool;
    var phi_418_: u32;
    var phi_548_: f32;
    var phi_556_: f32;
    var phi_564_: f32;
    var phi_1995_: bool;
    var phi_567_: u32;
    var phi_570_: u32;
    var phi_995_: type_15;
    var phi_996_: type_15;
    var phi_1019_: type_15;
    var phi_1135_: f32;
    var phi_1146_: f32;
    var phi_1157_: f32;
    var phi_1172_: f32;
    var phi_1173_: f32;
    var phi_1174_: bool;
    var phi_1175_: f32;
    var phi_1176_: bool;
    var phi_1195_: f32;
    var phi_1196_: bool;
    var phi_1197_: f32;
    var phi_1198_: bool;
    var phi_1199_: bool;
    var phi_1204_: f32;
    var phi_1205_: bool;
    var phi_1291_: array<f32, 3>;
    var phi_1292_: array<f32, 3>;
    var phi_1293_: array<f32, 3>;
    var phi_1294_: array<f32, 3>;
    var phi_1295_: bool;
    var phi_1296_: array<f32, 3>;
    var phi_1297_: array<f32, 3>;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1304_: array<f32, 3>;
    var phi_1309_: array<f32, 3>;
    var phi_1519_: u32;
    var phi_1525_: u32;
    var phi_1555_: u32;
    var phi_1561_: u32;
    var phi_1636_: bool;
    var phi_1641_: bool;
    var phi_1646_: type_44;
    var phi_1648_: type_44;
    var phi_1650_: bool;
    var phi_1651_: type_44;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1655_: type_44;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1658_: bool;
    var phi_1671_: type_44;
    var phi_1678_: bool;
    var phi_1991_: bool;
    var phi_1746_: bool;
    var phi_955_: u32;
    var phi_967_: u32;
    var phi_979_: u32;
    var phi_991_: u32;
    var phi_2052_: bool;
    var phi_1683_: u32;
    var phi_1684_: bool;
    var phi_1700_: u32;
    var phi_1701_: u32;
    var phi_568_: u32;
    var phi_571_: u32;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var phi_2050_: bool;
    var phi_1747_: bool;
    var phi_1718_: u32;
    var phi_1719_: u32;
    var phi_1720_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e67 = gid_1;
            let _e73 = arrayLength((&rays.member));
            let _e76 = arrayLength((&nodes.member));
            let _e85 = arrayLength((&surfaces.member));
            let _e90 = params.member.member_6;
            let _e94 = (_e67.x + (_e67.y * 2097152u));
            if (_e94 < _e90) {
                let _e98 = params.member.member_1;
                let _e99 = (_e98 / 16u);
                if ((_e98 % 16u) > 0u) {
                    phi_213_ = (_e99 + 1u);
                } else {
                    phi_213_ = _e99;
                }
                let _e104 = phi_213_;
                let _e105 = (_e94 / 16u);
                let _e108 = params.member.member_3;
                if (_e108 == 0u) {
                    break;
                }
                let _e110 = (_e105 / _e108);
                if (_e104 == 0u) {
                    break;
                }
                let _e112 = (_e110 / _e104);
                let _e118 = ((((_e110 - (_e112 * _e104)) * 16u) + _e94) - (_e105 * 16u));
                let _e122 = (((_e112 * _e108) + _e105) - (_e110 * _e108));
                if (_e94 < arrayLength((&hits.member))) {
                } else {
                    break;
                }
                let _e126 = hits.member[_e94];
                if (_e118 < _e98) {
                    let _e130 = params.member.member_2;
                    if (_e122 < _e130) {
                        if (_e118 < _e73) {
                        } else {
                            break;
                        }
                        let _e135 = rays.member[_e118];
                        let _e142 = params.member.member[0u];
                        let _e152 = ((((_e142.x * _e135.x) + (_e142.y * _e135.y)) + (_e142.z * _e135.z)) + _e142.w);
                        let _e156 = params.member.member[1u];
                        let _e166 = ((((_e156.x * _e135.x) + (_e156.y * _e135.y)) + (_e156.z * _e135.z)) + _e156.w);
                        let _e170 = params.member.member[2u];
                        let _e180 = ((((_e170.x * _e135.x) + (_e170.y * _e135.y)) + (_e170.z * _e135.z)) + _e170.w);
                        let _e181 = (_e98 + _e122);
                        if (_e181 < _e73) {
                        } else {
                            break;
                        }
                        let _e185 = rays.member[_e181];
                        let _e193 = (((_e142.x * _e185.x) + (_e142.y * _e185.y)) + (_e142.z * _e185.z));
                        let _e198 = (((_e156.x * _e185.x) + (_e156.y * _e185.y)) + (_e156.z * _e185.z));
                        let _e203 = (((_e170.x * _e185.x) + (_e170.y * _e185.y)) + (_e170.z * _e185.z));
                        if (_e94 < arrayLength((&distances.member))) {
                        } else {
                            break;
                        }
                        let _e207 = distances.member[_e94];
                        let _e208 = abs(_e193);
                        let _e209 = abs(_e198);
                        let _e210 = abs(_e203);
                        let _e211 = (_e208 > _e209);
                        if _e211 {
                            phi_394_ = (_e208 > _e210);
                        } else {
                            phi_394_ = (_e209 > _e210);
                        }
                        let _e215 = phi_394_;
                        let _e216 = select(1u, 0u, _e211);
                        if _e215 {
                            let _e217 = (_e216 + 1u);
                            phi_404_ = _e217;
                            phi_407_ = select(true, false, (_e217 == 2u));
                        } else {
                            phi_404_ = u32();
                            phi_407_ = false;
                        }
                        let _e221 = phi_404_;
                        let _e223 = phi_407_;
                        let _e224 = select(true, false, _e215);
                        let _e225 = select(_e221, 0u, _e224);
                        let _e227 = select(_e223, true, _e224);
                        if _e227 {
                            phi_418_ = (_e225 + 1u);
                        } else {
                            phi_418_ = 0u;
                        }
                        let _e230 = phi_418_;
                        let _e231 = select(_e221, _e225, _e227);
                        let _e232 = select(_e216, select(_e216, 2u, _e224), _e227);
                        local_1 = array<f32, 3>(_e193, _e198, _e203);
                        local_2 = array<f32, 3>(_e152, _e166, _e180);
                        let _e235 = (_e232 < 3u);
                        if _e235 {
                        } else {
                            break;
                        }
                        let _e237 = local_1[_e232];
                        let _e238 = (1f / _e237);
                        let _e239 = (_e231 < 3u);
                        if _e239 {
                        } else {
                            break;
                        }
                        let _e241 = local_1[_e231];
                        let _e242 = (_e241 * _e238);
                        let _e243 = (_e230 < 3u);
                        if _e243 {
                        } else {
                            break;
                        }
                        let _e245 = local_1[_e230];
                        let _e246 = (_e245 * _e238);
                        if _e239 {
                        } else {
                            break;
                        }
                        let _e248 = local_2[_e231];
                        if _e243 {
                        } else {
                            break;
                        }
                        let _e250 = local_2[_e230];
                        if _e235 {
                        } else {
                            break;
                        }
                        let _e252 = local_2[_e232];
                        if (0u < _e76) {
                        } else {
                            break;
                        }
                        let _e257 = nodes.member[0u].member_7[0u];
                        let _e261 = nodes.member[0u].member_7[1u];
                        let _e265 = nodes.member[0u].member_7[2u];
                        let _e269 = nodes.member[0u].member_7[3u];
                        let _e271 = abs((_e152 - _e257));
                        let _e273 = abs((_e166 - _e261));
                        let _e275 = select(_e273, _e271, (_e271 > _e273));
                        let _e277 = abs((_e180 - _e265));
                        let _e281 = ((select(_e277, _e275, (_e275 > _e277)) + _e269) * 0.0000009536743f);
                        let _e288 = (_e281 + (abs(_e152) * 0.00000023841858f));
                        let _e289 = (_e281 + (abs(_e166) * 0.00000023841858f));
                        let _e290 = (_e281 + (abs(_e180) * 0.00000023841858f));
                        let _e291 = select(_e209, _e208, _e211);
                        let _e293 = select(_e210, _e291, (_e291 > _e210));
                        let _e294 = (_e293 * 0.000000000001f);
                        let _e295 = (_e152 + _e288);
                        let _e296 = (_e166 + _e289);
                        let _e297 = (_e180 + _e290);
                        let _e298 = (_e152 - _e288);
                        let _e299 = (_e166 - _e289);
                        let _e300 = (_e180 - _e290);
                        if (_e208 > _e294) {
                            phi_548_ = (1f / _e193);
                        } else {
                            phi_548_ = (1000000000000f / _e293);
                        }
                        let _e305 = phi_548_;
                        if (_e209 > _e294) {
                            phi_556_ = (1f / _e198);
                        } else {
                            phi_556_ = (1000000000000f / _e293);
                        }
                        let _e310 = phi_556_;
                        if (_e210 > _e294) {
                            phi_564_ = (1f / _e203);
                        } else {
                            phi_564_ = (1000000000000f / _e293);
                        }
                        let _e315 = phi_564_;
                        local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        phi_1995_ = false;
                        phi_567_ = 0u;
                        phi_570_ = 0u;
                        loop {
                            let _e318 = phi_1995_;
                            let _e320 = phi_567_;
                            let _e322 = phi_570_;
                            let _e323 = (_e320 & 15u);
                            let _e325 = (_e320 >> bitcast<u32>(4u));
                            if (_e323 == 0u) {
                                if (_e325 < _e76) {
                                } else {
                                    phi_2050_ = true;
                                    phi_1747_ = bool();
                                    break;
                                }
                                let _e955 = nodes.member[_e325].member;
                                let _e964 = ((_e955.x - _e295) * _e305);
                                let _e965 = ((_e955.y - _e295) * _e305);
                                let _e966 = ((_e955.z - _e295) * _e305);
                                let _e967 = ((_e955.w - _e295) * _e305);
                                let _e970 = nodes.member[_e325].member_3;
                                let _e979 = ((_e970.x - _e298) * _e305);
                                let _e980 = ((_e970.y - _e298) * _e305);
                                let _e981 = ((_e970.z - _e298) * _e305);
                                let _e982 = ((_e970.w - _e298) * _e305);
                                let _e985 = nodes.member[_e325].member_1;
                                let _e994 = ((_e985.x - _e296) * _e310);
                                let _e995 = ((_e985.y - _e296) * _e310);
                                let _e996 = ((_e985.z - _e296) * _e310);
                                let _e997 = ((_e985.w - _e296) * _e310);
                                let _e1000 = nodes.member[_e325].member_4;
                                let _e1009 = ((_e1000.x - _e299) * _e310);
                                let _e1010 = ((_e1000.y - _e299) * _e310);
                                let _e1011 = ((_e1000.z - _e299) * _e310);
                                let _e1012 = ((_e1000.w - _e299) * _e310);
                                let _e1015 = nodes.member[_e325].member_2;
                                let _e1024 = ((_e1015.x - _e297) * _e315);
                                let _e1025 = ((_e1015.y - _e297) * _e315);
                                let _e1026 = ((_e1015.z - _e297) * _e315);
                                let _e1027 = ((_e1015.w - _e297) * _e315);
                                let _e1030 = nodes.member[_e325].member_5;
                                let _e1039 = ((_e1030.x - _e300) * _e315);
                                let _e1040 = ((_e1030.y - _e300) * _e315);
                                let _e1041 = ((_e1030.z - _e300) * _e315);
                                let _e1042 = ((_e1030.w - _e300) * _e315);
                                let _e1044 = select(_e979, _e964, (_e964 < _e979));
                                let _e1046 = select(_e980, _e965, (_e965 < _e980));
                                let _e1048 = select(_e981, _e966, (_e966 < _e981));
                                let _e1050 = select(_e982, _e967, (_e967 < _e982));
                                let _e1052 = select(_e1009, _e994, (_e994 < _e1009));
                                let _e1054 = select(_e1010, _e995, (_e995 < _e1010));
                                let _e1056 = select(_e1011, _e996, (_e996 < _e1011));
                                let _e1058 = select(_e1012, _e997, (_e997 < _e1012));
                                let _e1060 = select(_e1052, _e1044, (_e1044 > _e1052));
                                let _e1062 = select(_e1054, _e1046, (_e1046 > _e1054));
                                let _e1064 = select(_e1056, _e1048, (_e1048 > _e1056));
                                let _e1066 = select(_e1058, _e1050, (_e1050 > _e1058));
                                let _e1068 = select(_e1039, _e1024, (_e1024 < _e1039));
                                let _e1070 = select(_e1040, _e1025, (_e1025 < _e1040));
                                let _e1072 = select(_e1041, _e1026, (_e1026 < _e1041));
                                let _e1074 = select(_e1042, _e1027, (_e1027 < _e1042));
                                let _e1076 = select(_e1068, _e1060, (_e1060 > _e1068));
                                let _e1078 = select(_e1070, _e1062, (_e1062 > _e1070));
                                let _e1080 = select(_e1072, _e1064, (_e1064 > _e1072));
                                let _e1082 = select(_e1074, _e1066, (_e1066 > _e1074));
                                let _e1084 = select(0f, _e1076, (_e1076 > 0f));
                                let _e1086 = select(0f, _e1078, (_e1078 > 0f));
                                let _e1088 = select(0f, _e1080, (_e1080 > 0f));
                                let _e1090 = select(0f, _e1082, (_e1082 > 0f));
                                let _e1092 = select(_e979, _e964, (_e964 > _e979));
                                let _e1094 = select(_e980, _e965, (_e965 > _e980));
                                let _e1096 = select(_e981, _e966, (_e966 > _e981));
                                let _e1098 = select(_e982, _e967, (_e967 > _e982));
                                let _e1100 = select(_e1009, _e994, (_e994 > _e1009));
                                let _e1102 = select(_e1010, _e995, (_e995 > _e1010));
                                let _e1104 = select(_e1011, _e996, (_e996 > _e1011));
                                let _e1106 = select(_e1012, _e997, (_e997 > _e1012));
                                let _e1108 = select(_e1100, _e1092, (_e1092 < _e1100));
                                let _e1110 = select(_e1102, _e1094, (_e1094 < _e1102));
                                let _e1112 = select(_e1104, _e1096, (_e1096 < _e1104));
                                let _e1114 = select(_e1106, _e1098, (_e1098 < _e1106));
                                let _e1116 = select(_e1039, _e1024, (_e1024 > _e1039));
                                let _e1118 = select(_e1040, _e1025, (_e1025 > _e1040));
                                let _e1120 = select(_e1041, _e1026, (_e1026 > _e1041));
                                let _e1122 = select(_e1042, _e1027, (_e1027 > _e1042));
                                let _e1124 = select(_e1116, _e1108, (_e1108 < _e1116));
                                let _e1126 = select(_e1118, _e1110, (_e1110 < _e1118));
                                let _e1128 = select(_e1120, _e1112, (_e1112 < _e1120));
                                let _e1130 = select(_e1122, _e1114, (_e1114 < _e1122));
                                let _e1150 = nodes.member[_e325].member_6[0u];
                                let _e1154 = nodes.member[_e325].member_6[1u];
                                let _e1158 = nodes.member[_e325].member_6[2u];
                                let _e1162 = nodes.member[_e325].member_6[3u];
                                if (select(340282350000000000000000000000000000000f, _e1090, (_e1090 <= select(_e207, _e1130, (_e1130 < _e207)))) < 340282350000000000000000000000000000000f) {
                                    if (_e322 < 64u) {
                                    } else {
                                        phi_2050_ = true;
                                        phi_1747_ = bool();
                                        break;
                                    }
                                    local[_e322] = _e1162;
                                    phi_955_ = (_e322 + 1u);
                                } else {
                                    phi_955_ = _e322;
                                }
                                let _e1168 = phi_955_;
                                if (select(340282350000000000000000000000000000000f, _e1088, (_e1088 <= select(_e207, _e1128, (_e1128 < _e207)))) < 340282350000000000000000000000000000000f) {
                                    if (_e1168 < 64u) {
                                    } else {
                                        phi_2050_ = true;
                                        phi_1747_ = bool();
                                        break;
                                    }
                                    local[_e1168] = _e1158;
                                    phi_967_ = (_e1168 + 1u);
                                } else {
                                    phi_967_ = _e1168;
                                }
                                let _e1174 = phi_967_;
                                if (select(340282350000000000000000000000000000000f, _e1086, (_e1086 <= select(_e207, _e1126, (_e1126 < _e207)))) < 340282350000000000000000000000000000000f) {
                                    if (_e1174 < 64u) {
                                    } else {
                                        phi_2050_ = true;
                                        phi_1747_ = bool();
                                        break;
                                    }
                                    local[_e1174] = _e1154;
                                    phi_979_ = (_e1174 + 1u);
                                } else {
                                    phi_979_ = _e1174;
                                }
                                let _e1180 = phi_979_;
                                if (select(340282350000000000000000000000000000000f, _e1084, (_e1084 <= select(_e207, _e1124, (_e1124 < _e207)))) < 340282350000000000000000000000000000000f) {
                                    if (_e1180 < 64u) {
                                    } else {
                                        phi_2050_ = true;
                                        phi_1747_ = bool();
                                        break;
                                    }
                                    local[_e1180] = _e1150;
                                    phi_991_ = (_e1180 + 1u);
                                } else {
                                    phi_991_ = _e1180;
                                }
                                let _e1186 = phi_991_;
                                phi_2052_ = _e318;
                                phi_1683_ = _e1186;
                                phi_1684_ = true;
                            } else {
                                phi_995_ = type_15(_e325, (_e325 + _e323));
                                loop {
                                    let _e330 = phi_995_;
                                    if (_e330.member < _e330.member_1) {
                                        phi_996_ = type_15((_e330.member + 1u), _e330.member_1);
                                        phi_1019_ = type_15(1u, _e330.member);
                                    } else {
                                        phi_996_ = _e330;
                                        phi_1019_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e343 = phi_996_;
                                    let _e345 = phi_1019_;
                                    let _e349 = (bitcast<i32>(_e345.member) != 0i);
                                    if _e349 {
                                        let _e350 = (_e345.member_1 < arrayLength((&triangles.member)));
                                        if _e350 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        if _e235 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        let _e354 = triangles.member[_e345.member_1].member[_e232];
                                        let _e355 = (_e354 - _e252);
                                        if _e235 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        let _e359 = triangles.member[_e345.member_1].member_2[_e232];
                                        let _e360 = (_e359 - _e252);
                                        if _e235 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        let _e364 = triangles.member[_e345.member_1].member_4[_e232];
                                        let _e365 = (_e364 - _e252);
                                        if _e239 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        let _e369 = triangles.member[_e345.member_1].member[_e231];
                                        let _e372 = ((_e369 - _e248) - (_e242 * _e355));
                                        if _e243 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        let _e376 = triangles.member[_e345.member_1].member[_e230];
                                        let _e379 = ((_e376 - _e250) - (_e246 * _e355));
                                        if _e239 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        let _e383 = triangles.member[_e345.member_1].member_2[_e231];
                                        let _e386 = ((_e383 - _e248) - (_e242 * _e360));
                                        if _e243 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        let _e390 = triangles.member[_e345.member_1].member_2[_e230];
                                        let _e393 = ((_e390 - _e250) - (_e246 * _e360));
                                        if _e239 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        let _e397 = triangles.member[_e345.member_1].member_4[_e231];
                                        let _e400 = ((_e397 - _e248) - (_e242 * _e365));
                                        if _e243 {
                                        } else {
                                            phi_1991_ = true;
                                            phi_1746_ = bool();
                                            break;
                                        }
                                        let _e404 = triangles.member[_e345.member_1].member_4[_e230];
                                        let _e407 = ((_e404 - _e250) - (_e246 * _e365));
                                        let _e408 = (_e400 * _e393);
                                        let _e409 = (_e407 * _e386);
                                        if (_e408 != _e409) {
                                            phi_1135_ = (_e408 - _e409);
                                        } else {
                                            let _e411 = (_e400 * 4097f);
                                            let _e413 = (_e411 - (_e411 - _e400));
                                            let _e414 = (_e393 * 4097f);
                                            let _e416 = (_e414 - (_e414 - _e393));
                                            let _e417 = (_e400 - _e413);
                                            let _e418 = (_e393 - _e416);
                                            let _e427 = (_e407 * 4097f);
                                            let _e429 = (_e427 - (_e427 - _e407));
                                            let _e430 = (_e386 * 4097f);
                                            let _e432 = (_e430 - (_e430 - _e386));
                                            let _e433 = (_e407 - _e429);
                                            let _e434 = (_e386 - _e432);
                                            phi_1135_ = ((((((_e413 * _e416) - _e408) + (_e413 * _e418)) + (_e417 * _e416)) + (_e417 * _e418)) - (((((_e429 * _e432) - _e409) + (_e429 * _e434)) + (_e433 * _e432)) + (_e433 * _e434)));
                                        }
                                        let _e446 = phi_1135_;
                                        let _e447 = (_e372 * _e407);
                                        let _e448 = (_e379 * _e400);
                                        if (_e447 != _e448) {
                                            phi_1146_ = (_e447 - _e448);
                                        } else {
                                            let _e450 = (_e372 * 4097f);
                                            let _e452 = (_e450 - (_e450 - _e372));
                                            let _e453 = (_e407 * 4097f);
                                            let _e455 = (_e453 - (_e453 - _e407));
                                            let _e456 = (_e372 - _e452);
                                            let _e457 = (_e407 - _e455);
                                            let _e466 = (_e379 * 4097f);
                                            let _e468 = (_e466 - (_e466 - _e379));
                                            let _e469 = (_e400 * 4097f);
                                            let _e471 = (_e469 - (_e469 - _e400));
                                            let _e472 = (_e379 - _e468);
                                            let _e473 = (_e400 - _e471);
                                            phi_1146_ = ((((((_e452 * _e455) - _e447) + (_e452 * _e457)) + (_e456 * _e455)) + (_e456 * _e457)) - (((((_e468 * _e471) - _e448) + (_e468 * _e473)) + (_e472 * _e471)) + (_e472 * _e473)));
                                        }
                                        let _e485 = phi_1146_;
                                        let _e486 = (_e386 * _e379);
                                        let _e487 = (_e393 * _e372);
                                        if (_e486 != _e487) {
                                            phi_1157_ = (_e486 - _e487);
                                        } else {
                                            let _e489 = (_e386 * 4097f);
                                            let _e491 = (_e489 - (_e489 - _e386));
                                            let _e492 = (_e379 * 4097f);
                                            let _e494 = (_e492 - (_e492 - _e379));
                                            let _e495 = (_e386 - _e491);
                                            let _e496 = (_e379 - _e494);
                                            let _e505 = (_e393 * 4097f);
                                            let _e507 = (_e505 - (_e505 - _e393));
                                            let _e508 = (_e372 * 4097f);
                                            let _e510 = (_e508 - (_e508 - _e372));
                                            let _e511 = (_e393 - _e507);
                                            let _e512 = (_e372 - _e510);
                                            phi_1157_ = ((((((_e491 * _e494) - _e486) + (_e491 * _e496)) + (_e495 * _e494)) + (_e495 * _e496)) - (((((_e507 * _e510) - _e487) + (_e507 * _e512)) + (_e511 * _e510)) + (_e511 * _e512)));
                                        }
                                        let _e524 = phi_1157_;
                                        if (_e446 < 0f) {
                                            phi_1175_ = f32();
                                            phi_1176_ = true;
                                        } else {
                                            if (_e485 < 0f) {
                                                phi_1173_ = f32();
                                                phi_1174_ = true;
                                            } else {
                                                let _e527 = (_e524 < 0f);
                                                if _e527 {
                                                    phi_1172_ = f32();
                                                } else {
                                                    phi_1172_ = ((_e446 + _e485) + _e524);
                                                }
                                                let _e531 = phi_1172_;
                                                phi_1173_ = _e531;
                                                phi_1174_ = _e527;
                                            }
                                            let _e533 = phi_1173_;
                                            let _e535 = phi_1174_;
                                            phi_1175_ = _e533;
                                            phi_1176_ = _e535;
                                        }
                                        let _e537 = phi_1175_;
                                        let _e539 = phi_1176_;
                                        if _e539 {
                                            if (_e446 > 0f) {
                                                phi_1197_ = f32();
                                                phi_1198_ = true;
                                                phi_1199_ = false;
                                            } else {
                                                let _e541 = (_e485 > 0f);
                                                if _e541 {
                                                    phi_1195_ = f32();
                                                    phi_1196_ = false;
                                                } else {
                                                    phi_1195_ = ((_e446 + _e485) + _e524);
                                                    phi_1196_ = select(true, false, (_e524 > 0f));
                                                }
                                                let _e547 = phi_1195_;
                                                let _e549 = phi_1196_;
                                                phi_1197_ = _e547;
                                                phi_1198_ = _e541;
                                                phi_1199_ = _e549;
                                            }
                                            let _e551 = phi_1197_;
                                            let _e553 = phi_1198_;
                                            let _e555 = phi_1199_;
                                            phi_1204_ = _e551;
                                            phi_1205_ = select(_e555, false, _e553);
                                        } else {
                                            phi_1204_ = _e537;
                                            phi_1205_ = true;
                                        }
                                        let _e558 = phi_1204_;
                                        let _e560 = phi_1205_;
                                        if _e560 {
                                            let _e561 = (_e558 == 0f);
                                            if _e561 {
                                                phi_1293_ = array<f32, 3>();
                                                phi_1294_ = array<f32, 3>();
                                                phi_1295_ = false;
                                            } else {
                                                let _e562 = (_e355 * _e238);
                                                let _e563 = (_e360 * _e238);
                                                let _e564 = (_e365 * _e238);
                                                let _e567 = (1f / ((_e446 + _e485) + _e524));
                                                let _e568 = (_e485 * _e567);
                                                let _e569 = (_e524 * _e567);
                                                let _e575 = ((((_e446 * _e567) * _e562) + (_e568 * _e563)) + (_e569 * _e564));
                                                let _e576 = abs(_e372);
                                                let _e577 = abs(_e386);
                                                let _e579 = select(_e577, _e576, (_e576 > _e577));
                                                let _e580 = abs(_e400);
                                                let _e583 = abs(_e379);
                                                let _e584 = abs(_e393);
                                                let _e586 = select(_e584, _e583, (_e583 > _e584));
                                                let _e587 = abs(_e407);
                                                let _e591 = abs(_e562);
                                                let _e592 = abs(_e563);
                                                let _e594 = select(_e592, _e591, (_e591 > _e592));
                                                let _e595 = abs(_e564);
                                                let _e602 = (((select(_e580, _e579, (_e579 > _e580)) * select(_e587, _e586, (_e586 > _e587))) * select(_e595, _e594, (_e594 > _e595))) <= (abs((_e558 * _e575)) * 256f));
                                                if _e602 {
                                                    phi_1291_ = array<f32, 3>(_e575, _e568, _e569);
                                                    phi_1292_ = array<f32, 3>();
                                                } else {
                                                    let _e604 = (_e400 * 4097f);
                                                    let _e606 = (_e604 - (_e604 - _e400));
                                                    let _e607 = (_e393 * 4097f);
                                                    let _e609 = (_e607 - (_e607 - _e393));
                                                    let _e610 = (_e400 - _e606);
                                                    let _e611 = (_e393 - _e609);
                                                    let _e620 = (_e407 * 4097f);
                                                    let _e622 = (_e620 - (_e620 - _e407));
                                                    let _e623 = (_e386 * 4097f);
                                                    let _e625 = (_e623 - (_e623 - _e386));
                                                    let _e626 = (_e407 - _e622);
                                                    let _e627 = (_e386 - _e625);
                                                    let _e637 = ((_e408 - _e409) + ((((((_e606 * _e609) - _e408) + (_e606 * _e611)) + (_e610 * _e609)) + (_e610 * _e611)) - (((((_e622 * _e625) - _e409) + (_e622 * _e627)) + (_e626 * _e625)) + (_e626 * _e627))));
                                                    let _e639 = (_e372 * 4097f);
                                                    let _e641 = (_e639 - (_e639 - _e372));
                                                    let _e642 = (_e372 - _e641);
                                                    let _e651 = (_e379 * 4097f);
                                                    let _e653 = (_e651 - (_e651 - _e379));
                                                    let _e654 = (_e379 - _e653);
                                                    let _e664 = ((_e447 - _e448) + ((((((_e641 * _e622) - _e447) + (_e641 * _e626)) + (_e642 * _e622)) + (_e642 * _e626)) - (((((_e653 * _e606) - _e448) + (_e653 * _e610)) + (_e654 * _e606)) + (_e654 * _e610))));
                                                    let _e683 = ((_e486 - _e487) + ((((((_e625 * _e653) - _e486) + (_e625 * _e654)) + (_e627 * _e653)) + (_e627 * _e654)) - (((((_e609 * _e641) - _e487) + (_e609 * _e642)) + (_e611 * _e641)) + (_e611 * _e642))));
                                                    let _e686 = (1f / ((_e637 + _e664) + _e683));
                                                    let _e687 = (_e664 * _e686);
                                                    let _e688 = (_e683 * _e686);
                                                    phi_1291_ = array<f32, 3>();
                                                    phi_1292_ = array<f32, 3>(((((_e637 * _e686) * _e562) + (_e687 * _e563)) + (_e688 * _e564)), _e687, _e688);
                                                }
                                                let _e698 = phi_1291_;
                                                let _e700 = phi_1292_;
                                                phi_1293_ = _e698;
                                                phi_1294_ = _e700;
                                                phi_1295_ = _e602;
                                            }
                                            let _e702 = phi_1293_;
                                            let _e704 = phi_1294_;
                                            let _e706 = phi_1295_;
                                            phi_1296_ = _e702;
                                            phi_1297_ = _e704;
                                            phi_1298_ = _e561;
                                            phi_1299_ = _e706;
                                        } else {
                                            phi_1296_ = array<f32, 3>();
                                            phi_1297_ = array<f32, 3>();
                                            phi_1298_ = true;
                                            phi_1299_ = false;
                                        }
                                        let _e708 = phi_1296_;
                                        let _e710 = phi_1297_;
                                        let _e712 = phi_1298_;
                                        let _e714 = phi_1299_;
                                        if _e712 {
                                            phi_1304_ = array<f32, 3>(-1f, 0f, 0f);
                                        } else {
                                            phi_1304_ = _e708;
                                        }
                                        let _e716 = phi_1304_;
                                        if select(_e714, true, _e712) {
                                            phi_1309_ = _e716;
                                        } else {
                                            phi_1309_ = _e710;
                                        }
                                        let _e719 = phi_1309_;
                                        let _e723 = (_e719[0] >= 0f);
                                        if _e723 {
                                            let _e724 = (_e719[0] < _e207);
                                            if _e724 {
                                                if _e723 {
                                                    if _e350 {
                                                    } else {
                                                        phi_1991_ = true;
                                                        phi_1746_ = bool();
                                                        break;
                                                    }
                                                    let _e727 = triangles.member[_e345.member_1].member_3;
                                                    if ((_e727 & 1u) == 0u) {
                                                        phi_1641_ = true;
                                                    } else {
                                                        if _e350 {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        let _e732 = triangles.member[_e345.member_1].member_1;
                                                        let _e733 = (_e732 * 12u);
                                                        if ((256u + _e733) < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        if ((_e733 + 257u) < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        if ((_e733 + 258u) < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        let _e740 = (_e733 + 259u);
                                                        if (_e740 < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        let _e743 = surfaces.member[_e740];
                                                        if ((_e733 + 260u) < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        if ((_e733 + 261u) < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        if ((_e733 + 262u) < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        let _e750 = (_e733 + 263u);
                                                        if (_e750 < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        let _e753 = surfaces.member[_e750];
                                                        let _e754 = (_e733 + 264u);
                                                        if (_e754 < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        let _e757 = surfaces.member[_e754];
                                                        let _e758 = bitcast<f32>(_e757);
                                                        let _e759 = (_e733 + 265u);
                                                        if (_e759 < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        let _e762 = surfaces.member[_e759];
                                                        let _e763 = bitcast<f32>(_e762);
                                                        if ((_e733 + 266u) < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        if ((_e733 + 267u) < _e85) {
                                                        } else {
                                                            phi_1991_ = true;
                                                            phi_1746_ = bool();
                                                            break;
                                                        }
                                                        if (_e743 == 4294967295u) {
                                                            phi_1636_ = (_e758 < _e763);
                                                        } else {
                                                            if (_e345.member_1 < arrayLength((&attributes.member))) {
                                                            } else {
                                                                phi_1991_ = true;
                                                                phi_1746_ = bool();
                                                                break;
                                                            }
                                                            let _e771 = ((1f - _e719[1]) - _e719[2]);
                                                            let _e775 = attributes.member[_e345.member_1].member[0u];
                                                            let _e780 = attributes.member[_e345.member_1].member[2u];
                                                            let _e786 = attributes.member[_e345.member_1].member[4u];
                                                            let _e788 = (((_e775 * _e771) + (_e780 * _e719[1])) + (_e786 * _e719[2]));
                                                            let _e792 = attributes.member[_e345.member_1].member[1u];
                                                            let _e797 = attributes.member[_e345.member_1].member[3u];
                                                            let _e803 = attributes.member[_e345.member_1].member[5u];
                                                            let _e805 = (((_e792 * _e771) + (_e797 * _e719[1])) + (_e803 * _e719[2]));
                                                            let _e806 = (_e753 & 65535u);
                                                            let _e808 = (_e753 >> bitcast<u32>(16i));
                                                            let _e810 = (_e788 - floor(_e788));
                                                            let _e815 = ((select(0f, _e810, (_e810 <= 1f)) * f32(_e806)) - 0.5f);
                                                            let _e816 = floor(_e815);
                                                            let _e817 = (_e815 - _e816);
                                                            let _e818 = (_e806 - 1u);
                                                            if (_e816 < 0f) {
                                                                phi_1519_ = _e818;
                                                            } else {
                                                                let _e824 = select(select(u32(_e816), 0u, (_e816 < 0f)), 4294967295u, (_e816 > 4294967000f));
                                                                phi_1519_ = select(_e824, _e818, (_e818 < _e824));
                                                            }
                                                            let _e828 = phi_1519_;
                                                            if (_e828 == _e818) {
                                                                phi_1525_ = 0u;
                                                            } else {
                                                                phi_1525_ = (_e828 + 1u);
                                                            }
                                                            let _e832 = phi_1525_;
                                                            let _e834 = (_e805 - floor(_e805));
                                                            let _e839 = ((select(0f, _e834, (_e834 <= 1f)) * f32(_e808)) - 0.5f);
                                                            let _e840 = floor(_e839);
                                                            let _e841 = (_e839 - _e840);
                                                            let _e842 = (_e808 - 1u);
                                                            if (_e840 < 0f) {
                                                                phi_1555_ = _e842;
                                                            } else {
                                                                let _e848 = select(select(u32(_e840), 0u, (_e840 < 0f)), 4294967295u, (_e840 > 4294967000f));
                                                                phi_1555_ = select(_e848, _e842, (_e842 < _e848));
                                                            }
                                                            let _e852 = phi_1555_;
                                                            if (_e852 == _e842) {
                                                                phi_1561_ = 0u;
                                                            } else {
                                                                phi_1561_ = (_e852 + 1u);
                                                            }
                                                            let _e856 = phi_1561_;
                                                            let _e858 = (_e743 + (_e852 * _e806));
                                                            let _e860 = (_e743 + (_e856 * _e806));
                                                            let _e861 = (_e858 + _e828);
                                                            let _e862 = (_e858 + _e832);
                                                            let _e863 = (_e860 + _e828);
                                                            let _e864 = (_e860 + _e832);
                                                            if (_e861 < _e85) {
                                                            } else {
                                                                phi_1991_ = true;
                                                                phi_1746_ = bool();
                                                                break;
                                                            }
                                                            let _e867 = surfaces.member[_e861];
                                                            if (_e862 < _e85) {
                                                            } else {
                                                                phi_1991_ = true;
                                                                phi_1746_ = bool();
                                                                break;
                                                            }
                                                            let _e870 = surfaces.member[_e862];
                                                            if (_e863 < _e85) {
                                                            } else {
                                                                phi_1991_ = true;
                                                                phi_1746_ = bool();
                                                                break;
                                                            }
                                                            let _e873 = surfaces.member[_e863];
                                                            if (_e864 < _e85) {
                                                            } else {
                                                                phi_1991_ = true;
                                                                phi_1746_ = bool();
                                                                break;
                                                            }
                                                            let _e876 = surfaces.member[_e864];
                                                            let _e893 = (1f - _e817);
                                                            phi_1636_ = ((_e758 * (((((f32((_e867 >> bitcast<u32>(24i))) * 0.003921569f) * _e893) + ((f32((_e870 >> bitcast<u32>(24i))) * 0.003921569f) * _e817)) * (1f - _e841)) + ((((f32((_e873 >> bitcast<u32>(24i))) * 0.003921569f) * _e893) + ((f32((_e876 >> bitcast<u32>(24i))) * 0.003921569f) * _e817)) * _e841))) < _e763);
                                                        }
                                                        let _e908 = phi_1636_;
                                                        phi_1641_ = select(true, false, _e908);
                                                    }
                                                    let _e911 = phi_1641_;
                                                    if _e911 {
                                                        phi_1646_ = type_44(_e719[0], _e345.member_1, _e719[1], _e719[2]);
                                                    } else {
                                                        phi_1646_ = type_44();
                                                    }
                                                    let _e914 = phi_1646_;
                                                    phi_1648_ = _e914;
                                                    phi_1650_ = select(true, false, _e911);
                                                } else {
                                                    phi_1648_ = type_44();
                                                    phi_1650_ = false;
                                                }
                                                let _e917 = phi_1648_;
                                                let _e919 = phi_1650_;
                                                phi_1651_ = _e917;
                                                phi_1653_ = select(true, false, _e723);
                                                phi_1654_ = _e919;
                                            } else {
                                                phi_1651_ = type_44();
                                                phi_1653_ = false;
                                                phi_1654_ = false;
                                            }
                                            let _e922 = phi_1651_;
                                            let _e924 = phi_1653_;
                                            let _e926 = phi_1654_;
                                            phi_1655_ = _e922;
                                            phi_1656_ = select(true, false, _e724);
                                            phi_1657_ = _e924;
                                            phi_1658_ = _e926;
                                        } else {
                                            phi_1655_ = type_44();
                                            phi_1656_ = true;
                                            phi_1657_ = false;
                                            phi_1658_ = false;
                                        }
                                        let _e929 = phi_1655_;
                                        let _e931 = phi_1656_;
                                        let _e933 = phi_1657_;
                                        let _e935 = phi_1658_;
                                        if select(select(_e935, false, _e931), true, select(_e933, true, _e931)) {
                                            phi_1671_ = type_44(_e207, 4294967295u, 0f, 0f);
                                        } else {
                                            phi_1671_ = _e929;
                                        }
                                        let _e940 = phi_1671_;
                                        phi_1678_ = select(true, false, (_e940.member_1 != 4294967295u));
                                    } else {
                                        phi_1678_ = false;
                                    }
                                    let _e945 = phi_1678_;
                                    continue;
                                    continuing {
                                        phi_995_ = _e343;
                                        phi_1991_ = _e318;
                                        phi_1746_ = select(true, false, _e349);
                                        break if !(_e945);
                                    }
                                }
                                let _e949 = phi_1991_;
                                let _e951 = phi_1746_;
                                phi_2050_ = _e949;
                                phi_1747_ = bool();
                                if _e949 {
                                    break;
                                }
                                phi_2052_ = _e949;
                                phi_1683_ = _e322;
                                phi_1684_ = _e951;
                            }
                            let _e1188 = phi_2052_;
                            let _e1190 = phi_1683_;
                            let _e1192 = phi_1684_;
                            if _e1192 {
                                let _e1193 = (_e1190 == 0u);
                                if _e1193 {
                                    phi_1700_ = u32();
                                    phi_1701_ = u32();
                                } else {
                                    let _e1194 = (_e1190 - 1u);
                                    if (_e1194 < 64u) {
                                    } else {
                                        phi_2050_ = true;
                                        phi_1747_ = bool();
                                        break;
                                    }
                                    let _e1197 = local[_e1194];
                                    phi_1700_ = _e1197;
                                    phi_1701_ = _e1194;
                                }
                                let _e1199 = phi_1700_;
                                let _e1201 = phi_1701_;
                                phi_568_ = _e1199;
                                phi_571_ = _e1201;
                                phi_1703_ = select(true, false, _e1193);
                                phi_1704_ = _e1193;
                            } else {
                                phi_568_ = u32();
                                phi_571_ = u32();
                                phi_1703_ = false;
                                phi_1704_ = false;
                            }
                            let _e1204 = phi_568_;
                            let _e1206 = phi_571_;
                            let _e1208 = phi_1703_;
                            let _e1210 = phi_1704_;
                            continue;
                            continuing {
                                phi_1995_ = _e1188;
                                phi_567_ = _e1204;
                                phi_570_ = _e1206;
                                phi_2050_ = _e1188;
                                phi_1747_ = _e1210;
                                break if !(_e1208);
                            }
                        }
                        let _e1213 = phi_2050_;
                        let _e1215 = phi_1747_;
                        if _e1213 {
                            break;
                        }
                        if select(false, true, select(true, false, _e1215)) {
                            let _e1220 = params.member.member_5;
                            phi_1718_ = _e1220;
                        } else {
                            phi_1718_ = _e126;
                        }
                        let _e1222 = phi_1718_;
                        phi_1719_ = _e1222;
                    } else {
                        phi_1719_ = _e126;
                    }
                    let _e1224 = phi_1719_;
                    phi_1720_ = _e1224;
                } else {
                    phi_1720_ = _e126;
                }
                let _e1226 = phi_1720_;
                if (_e94 < arrayLength((&seen.member))) {
                } else {
                    break;
                }
                seen.member[_e94] = _e1226;
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
