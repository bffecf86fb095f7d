struct type_8 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
    member_4: vec4<f32>,
    member_5: vec4<f32>,
    member_6: array<u32, 4>,
    member_7: vec4<f32>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_28 {
    member: array<f32, 6>,
    member_1: array<u32, 3>,
    member_2: array<u32, 3>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_44 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
}

struct type_45 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_47 {
    member: vec3<f32>,
    member_1: f32,
}

struct type_48 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
    member_8: array<f32, 3>,
    member_9: f32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_53 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
    member_4: vec4<f32>,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
}

struct type_54 {
    member: type_53,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> nodes: type_20;
@group(0) @binding(2) 
var<storage> triangles: type_24;
@group(0) @binding(3) 
var<storage> attributes: type_30;
@group(0) @binding(4) 
var<storage> surfaces: type_8;
@group(0) @binding(0) 
var<uniform> params: type_54;
@group(0) @binding(5) 
var<storage, read_write> surfels: type_50;

fn function_() {
    var local: array<u32, 64>;
    var local_1: array<f32, 64>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var phi_318_: vec3<f32>;
    var phi_320_: vec3<f32>;
    var phi_321_: bool;
    var phi_346_: bool;
    var phi_356_: u32;
    var phi_359_: bool;
    var phi_370_: u32;
    var phi_506_: f32;
    var phi_514_: f32;
    var phi_522_: f32;
    var phi_3342_: bool;
    var phi_525_: u32;
    var phi_528_: u32;
    var phi_530_: type_44;
    var phi_1022_: type_12;
    var phi_1025_: type_44;
    var phi_1023_: type_12;
    var phi_1048_: type_12;
    var phi_1164_: f32;
    var phi_1175_: f32;
    var phi_1186_: f32;
    var phi_1201_: f32;
    var phi_1202_: f32;
    var phi_1203_: bool;
    var phi_1204_: f32;
    var phi_1205_: bool;
    var phi_1224_: f32;
    var phi_1225_: bool;
    var phi_1226_: f32;
    var phi_1227_: bool;
    var phi_1228_: bool;
    var phi_1233_: f32;
    var phi_1234_: bool;
    var phi_1320_: array<f32, 3>;
    var phi_1321_: array<f32, 3>;
    var phi_1322_: array<f32, 3>;
    var phi_1323_: array<f32, 3>;
    var phi_1324_: bool;
    var phi_1325_: array<f32, 3>;
    var phi_1326_: array<f32, 3>;
    var phi_1327_: bool;
    var phi_1328_: bool;
    var phi_1333_: array<f32, 3>;
    var phi_1338_: array<f32, 3>;
    var phi_1537_: f32;
    var phi_1552_: f32;
    var phi_1580_: u32;
    var phi_1590_: u32;
    var phi_1599_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1639_: f32;
    var phi_1654_: f32;
    var phi_1682_: u32;
    var phi_1692_: u32;
    var phi_1701_: bool;
    var phi_1717_: bool;
    var phi_1718_: bool;
    var phi_1799_: bool;
    var phi_1804_: bool;
    var phi_1809_: type_44;
    var phi_1811_: type_44;
    var phi_1813_: bool;
    var phi_1814_: type_44;
    var phi_1816_: bool;
    var phi_1817_: bool;
    var phi_1818_: type_44;
    var phi_1819_: bool;
    var phi_1820_: bool;
    var phi_1821_: bool;
    var phi_1834_: type_44;
    var phi_1026_: type_44;
    var phi_3338_: bool;
    var phi_911_: type_45;
    var phi_922_: type_45;
    var phi_933_: type_45;
    var phi_944_: type_45;
    var phi_955_: type_45;
    var phi_977_: u32;
    var phi_995_: u32;
    var phi_1013_: u32;
    var phi_3429_: bool;
    var phi_1835_: u32;
    var phi_1836_: u32;
    var phi_531_: type_44;
    var phi_526_: u32;
    var phi_529_: u32;
    var phi_1871_: u32;
    var phi_1872_: u32;
    var phi_1873_: u32;
    var phi_1838_: u32;
    var phi_1840_: u32;
    var phi_1874_: bool;
    var phi_3426_: bool;
    var local_4: bool;
    var phi_3493_: bool;
    var phi_3094_: type_44;
    var phi_1976_: vec3<f32>;
    var phi_1978_: vec3<f32>;
    var phi_1979_: bool;
    var phi_2000_: vec3<f32>;
    var phi_2172_: f32;
    var phi_2187_: f32;
    var phi_2215_: u32;
    var phi_2225_: u32;
    var phi_2234_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2274_: f32;
    var phi_2289_: f32;
    var phi_2317_: u32;
    var phi_2327_: u32;
    var phi_2336_: bool;
    var phi_2352_: bool;
    var phi_2353_: bool;
    var phi_2576_: type_47;
    var phi_2683_: vec3<f32>;
    var phi_2758_: vec3<f32>;
    var phi_2832_: vec3<f32>;
    var phi_2906_: vec3<f32>;
    var phi_2951_: vec3<f32>;
    var phi_2953_: vec3<f32>;
    var phi_2954_: bool;
    var phi_2975_: vec3<f32>;
    var phi_3005_: array<f32, 3>;
    var phi_3051_: type_48;
    var phi_3064_: type_48;
    var local_5: u32;
    var local_6: u32;
    var local_7: type_44;

    switch bitcast<i32>(0u) {
        default: {
            let _e89 = gid_1;
            let _e92 = arrayLength((&nodes.member));
            let _e95 = arrayLength((&triangles.member));
            let _e98 = arrayLength((&attributes.member));
            let _e101 = arrayLength((&surfaces.member));
            let _e106 = params.member.member_5;
            let _e109 = params.member.member_6;
            let _e114 = (_e89.x + (_e89.y * 2097152u));
            if (_e114 < (_e106 * _e109)) {
                if (_e106 == 0u) {
                    break;
                }
                let _e117 = (_e114 / _e106);
                let _e125 = ((f32(((2u * (_e114 - (_e117 * _e106))) + 1u)) / f32(_e106)) - 1f);
                let _e131 = (1f - (f32(((2u * _e117) + 1u)) / f32(_e109)));
                let _e134 = params.member.member_1;
                let _e140 = params.member.member_2;
                let _e152 = params.member.member_3;
                let _e159 = ((_e134.x + (_e140.x * _e125)) + (_e152.x * _e131));
                let _e160 = ((_e134.y + (_e140.y * _e125)) + (_e152.y * _e131));
                let _e161 = ((_e134.z + (_e140.z * _e125)) + (_e152.z * _e131));
                let _e164 = params.member.member;
                let _e168 = abs(_e159);
                let _e169 = abs(_e160);
                let _e171 = select(_e169, _e168, (_e168 > _e169));
                let _e172 = abs(_e161);
                let _e174 = select(_e172, _e171, (_e171 > _e172));
                if (_e174 > 0.000000000000000000000000000000000000011754944f) {
                    let _e176 = (_e174 < 340282350000000000000000000000000000000f);
                    if _e176 {
                        let _e177 = (_e159 / _e174);
                        let _e178 = (_e160 / _e174);
                        let _e179 = (_e161 / _e174);
                        let _e185 = sqrt((((_e177 * _e177) + (_e178 * _e178)) + (_e179 * _e179)));
                        phi_318_ = vec3<f32>((_e177 / _e185), (_e178 / _e185), (_e179 / _e185));
                    } else {
                        phi_318_ = vec3<f32>();
                    }
                    let _e191 = phi_318_;
                    phi_320_ = _e191;
                    phi_321_ = select(true, false, _e176);
                } else {
                    phi_320_ = vec3<f32>();
                    phi_321_ = true;
                }
                let _e194 = phi_320_;
                let _e196 = phi_321_;
                let _e198 = select(_e194, vec3<f32>(0f, 0f, 1f), vec3(_e196));
                let _e200 = abs(_e198.x);
                let _e202 = abs(_e198.y);
                let _e204 = abs(_e198.z);
                let _e205 = (_e200 > _e202);
                if _e205 {
                    phi_346_ = (_e200 > _e204);
                } else {
                    phi_346_ = (_e202 > _e204);
                }
                let _e209 = phi_346_;
                let _e210 = select(1u, 0u, _e205);
                if _e209 {
                    let _e211 = (_e210 + 1u);
                    phi_356_ = _e211;
                    phi_359_ = select(true, false, (_e211 == 2u));
                } else {
                    phi_356_ = u32();
                    phi_359_ = false;
                }
                let _e215 = phi_356_;
                let _e217 = phi_359_;
                let _e218 = select(true, false, _e209);
                let _e219 = select(_e215, 0u, _e218);
                let _e221 = select(_e217, true, _e218);
                if _e221 {
                    phi_370_ = (_e219 + 1u);
                } else {
                    phi_370_ = 0u;
                }
                let _e224 = phi_370_;
                let _e225 = select(_e215, _e219, _e221);
                let _e226 = select(_e210, select(_e210, 2u, _e218), _e221);
                local_2 = array<f32, 3>(_e198.x, _e198.y, _e198.z);
                local_3 = array<f32, 3>(_e164.x, _e164.y, _e164.z);
                let _e229 = (_e226 < 3u);
                if _e229 {
                } else {
                    break;
                }
                let _e231 = local_2[_e226];
                let _e232 = (1f / _e231);
                let _e233 = (_e225 < 3u);
                if _e233 {
                } else {
                    break;
                }
                let _e235 = local_2[_e225];
                let _e236 = (_e235 * _e232);
                let _e237 = (_e224 < 3u);
                if _e237 {
                } else {
                    break;
                }
                let _e239 = local_2[_e224];
                let _e240 = (_e239 * _e232);
                if _e233 {
                } else {
                    break;
                }
                let _e242 = local_3[_e225];
                if _e237 {
                } else {
                    break;
                }
                let _e244 = local_3[_e224];
                if _e229 {
                } else {
                    break;
                }
                let _e246 = local_3[_e226];
                if (0u < _e92) {
                } else {
                    break;
                }
                let _e251 = nodes.member[0u].member_7[0u];
                let _e255 = nodes.member[0u].member_7[1u];
                let _e259 = nodes.member[0u].member_7[2u];
                let _e263 = nodes.member[0u].member_7[3u];
                let _e265 = abs((_e164.x - _e251));
                let _e267 = abs((_e164.y - _e255));
                let _e269 = select(_e267, _e265, (_e265 > _e267));
                let _e271 = abs((_e164.z - _e259));
                let _e275 = ((select(_e271, _e269, (_e269 > _e271)) + _e263) * 0.0000009536743f);
                let _e282 = (_e275 + (abs(_e164.x) * 0.00000023841858f));
                let _e283 = (_e275 + (abs(_e164.y) * 0.00000023841858f));
                let _e284 = (_e275 + (abs(_e164.z) * 0.00000023841858f));
                let _e285 = select(_e202, _e200, _e205);
                let _e287 = select(_e204, _e285, (_e285 > _e204));
                let _e288 = (_e287 * 0.000000000001f);
                let _e289 = (_e164.x + _e282);
                let _e290 = (_e164.y + _e283);
                let _e291 = (_e164.z + _e284);
                let _e292 = (_e164.x - _e282);
                let _e293 = (_e164.y - _e283);
                let _e294 = (_e164.z - _e284);
                if (_e200 > _e288) {
                    phi_506_ = (1f / _e198.x);
                } else {
                    phi_506_ = (1000000000000f / _e287);
                }
                let _e299 = phi_506_;
                if (_e202 > _e288) {
                    phi_514_ = (1f / _e198.y);
                } else {
                    phi_514_ = (1000000000000f / _e287);
                }
                let _e304 = phi_514_;
                if (_e204 > _e288) {
                    phi_522_ = (1f / _e198.z);
                } else {
                    phi_522_ = (1000000000000f / _e287);
                }
                let _e309 = phi_522_;
                local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                local_1 = array<f32, 64>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                phi_3342_ = false;
                phi_525_ = 0u;
                phi_528_ = 0u;
                phi_530_ = type_44(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                loop {
                    let _e311 = phi_3342_;
                    let _e313 = phi_525_;
                    let _e315 = phi_528_;
                    let _e317 = phi_530_;
                    let _e318 = (_e313 & 15u);
                    let _e320 = (_e313 >> bitcast<u32>(4u));
                    if (_e318 == 0u) {
                        if (_e320 < _e92) {
                        } else {
                            phi_3493_ = true;
                            phi_3094_ = type_44();
                            break;
                        }
                        let _e1015 = nodes.member[_e320].member;
                        let _e1024 = ((_e1015.x - _e289) * _e299);
                        let _e1025 = ((_e1015.y - _e289) * _e299);
                        let _e1026 = ((_e1015.z - _e289) * _e299);
                        let _e1027 = ((_e1015.w - _e289) * _e299);
                        let _e1030 = nodes.member[_e320].member_3;
                        let _e1039 = ((_e1030.x - _e292) * _e299);
                        let _e1040 = ((_e1030.y - _e292) * _e299);
                        let _e1041 = ((_e1030.z - _e292) * _e299);
                        let _e1042 = ((_e1030.w - _e292) * _e299);
                        let _e1045 = nodes.member[_e320].member_1;
                        let _e1054 = ((_e1045.x - _e290) * _e304);
                        let _e1055 = ((_e1045.y - _e290) * _e304);
                        let _e1056 = ((_e1045.z - _e290) * _e304);
                        let _e1057 = ((_e1045.w - _e290) * _e304);
                        let _e1060 = nodes.member[_e320].member_4;
                        let _e1069 = ((_e1060.x - _e293) * _e304);
                        let _e1070 = ((_e1060.y - _e293) * _e304);
                        let _e1071 = ((_e1060.z - _e293) * _e304);
                        let _e1072 = ((_e1060.w - _e293) * _e304);
                        let _e1075 = nodes.member[_e320].member_2;
                        let _e1084 = ((_e1075.x - _e291) * _e309);
                        let _e1085 = ((_e1075.y - _e291) * _e309);
                        let _e1086 = ((_e1075.z - _e291) * _e309);
                        let _e1087 = ((_e1075.w - _e291) * _e309);
                        let _e1090 = nodes.member[_e320].member_5;
                        let _e1099 = ((_e1090.x - _e294) * _e309);
                        let _e1100 = ((_e1090.y - _e294) * _e309);
                        let _e1101 = ((_e1090.z - _e294) * _e309);
                        let _e1102 = ((_e1090.w - _e294) * _e309);
                        let _e1104 = select(_e1039, _e1024, (_e1024 < _e1039));
                        let _e1106 = select(_e1040, _e1025, (_e1025 < _e1040));
                        let _e1108 = select(_e1041, _e1026, (_e1026 < _e1041));
                        let _e1110 = select(_e1042, _e1027, (_e1027 < _e1042));
                        let _e1112 = select(_e1069, _e1054, (_e1054 < _e1069));
                        let _e1114 = select(_e1070, _e1055, (_e1055 < _e1070));
                        let _e1116 = select(_e1071, _e1056, (_e1056 < _e1071));
                        let _e1118 = select(_e1072, _e1057, (_e1057 < _e1072));
                        let _e1120 = select(_e1112, _e1104, (_e1104 > _e1112));
                        let _e1122 = select(_e1114, _e1106, (_e1106 > _e1114));
                        let _e1124 = select(_e1116, _e1108, (_e1108 > _e1116));
                        let _e1126 = select(_e1118, _e1110, (_e1110 > _e1118));
                        let _e1128 = select(_e1099, _e1084, (_e1084 < _e1099));
                        let _e1130 = select(_e1100, _e1085, (_e1085 < _e1100));
                        let _e1132 = select(_e1101, _e1086, (_e1086 < _e1101));
                        let _e1134 = select(_e1102, _e1087, (_e1087 < _e1102));
                        let _e1136 = select(_e1128, _e1120, (_e1120 > _e1128));
                        let _e1138 = select(_e1130, _e1122, (_e1122 > _e1130));
                        let _e1140 = select(_e1132, _e1124, (_e1124 > _e1132));
                        let _e1142 = select(_e1134, _e1126, (_e1126 > _e1134));
                        let _e1144 = select(0f, _e1136, (_e1136 > 0f));
                        let _e1146 = select(0f, _e1138, (_e1138 > 0f));
                        let _e1148 = select(0f, _e1140, (_e1140 > 0f));
                        let _e1150 = select(0f, _e1142, (_e1142 > 0f));
                        let _e1152 = select(_e1039, _e1024, (_e1024 > _e1039));
                        let _e1154 = select(_e1040, _e1025, (_e1025 > _e1040));
                        let _e1156 = select(_e1041, _e1026, (_e1026 > _e1041));
                        let _e1158 = select(_e1042, _e1027, (_e1027 > _e1042));
                        let _e1160 = select(_e1069, _e1054, (_e1054 > _e1069));
                        let _e1162 = select(_e1070, _e1055, (_e1055 > _e1070));
                        let _e1164 = select(_e1071, _e1056, (_e1056 > _e1071));
                        let _e1166 = select(_e1072, _e1057, (_e1057 > _e1072));
                        let _e1168 = select(_e1160, _e1152, (_e1152 < _e1160));
                        let _e1170 = select(_e1162, _e1154, (_e1154 < _e1162));
                        let _e1172 = select(_e1164, _e1156, (_e1156 < _e1164));
                        let _e1174 = select(_e1166, _e1158, (_e1158 < _e1166));
                        let _e1176 = select(_e1099, _e1084, (_e1084 > _e1099));
                        let _e1178 = select(_e1100, _e1085, (_e1085 > _e1100));
                        let _e1180 = select(_e1101, _e1086, (_e1086 > _e1101));
                        let _e1182 = select(_e1102, _e1087, (_e1087 > _e1102));
                        let _e1184 = select(_e1176, _e1168, (_e1168 < _e1176));
                        let _e1186 = select(_e1178, _e1170, (_e1170 < _e1178));
                        let _e1188 = select(_e1180, _e1172, (_e1172 < _e1180));
                        let _e1190 = select(_e1182, _e1174, (_e1174 < _e1182));
                        let _e1200 = select(340282350000000000000000000000000000000f, _e1144, (_e1144 <= select(_e317.member, _e1184, (_e1184 < _e317.member))));
                        let _e1202 = select(340282350000000000000000000000000000000f, _e1146, (_e1146 <= select(_e317.member, _e1186, (_e1186 < _e317.member))));
                        let _e1204 = select(340282350000000000000000000000000000000f, _e1148, (_e1148 <= select(_e317.member, _e1188, (_e1188 < _e317.member))));
                        let _e1206 = select(340282350000000000000000000000000000000f, _e1150, (_e1150 <= select(_e317.member, _e1190, (_e1190 < _e317.member))));
                        let _e1210 = nodes.member[_e320].member_6[0u];
                        let _e1214 = nodes.member[_e320].member_6[1u];
                        let _e1218 = nodes.member[_e320].member_6[2u];
                        let _e1222 = nodes.member[_e320].member_6[3u];
                        if (_e1202 < _e1200) {
                            phi_911_ = type_45(_e1202, _e1214, _e1200, _e1210);
                        } else {
                            phi_911_ = type_45(_e1200, _e1210, _e1202, _e1214);
                        }
                        let _e1227 = phi_911_;
                        if (_e1206 < _e1204) {
                            phi_922_ = type_45(_e1206, _e1222, _e1204, _e1218);
                        } else {
                            phi_922_ = type_45(_e1204, _e1218, _e1206, _e1222);
                        }
                        let _e1236 = phi_922_;
                        if (_e1236.member < _e1227.member) {
                            phi_933_ = type_45(_e1236.member, _e1236.member_1, _e1227.member, _e1227.member_1);
                        } else {
                            phi_933_ = type_45(_e1227.member, _e1227.member_1, _e1236.member, _e1236.member_1);
                        }
                        let _e1245 = phi_933_;
                        if (_e1236.member_2 < _e1227.member_2) {
                            phi_944_ = type_45(_e1236.member_2, _e1236.member_3, _e1227.member_2, _e1227.member_3);
                        } else {
                            phi_944_ = type_45(_e1227.member_2, _e1227.member_3, _e1236.member_2, _e1236.member_3);
                        }
                        let _e1254 = phi_944_;
                        if (_e1245.member_2 < _e1254.member) {
                            phi_955_ = type_45(_e1245.member_2, _e1245.member_3, _e1254.member, _e1254.member_1);
                        } else {
                            phi_955_ = type_45(_e1254.member, _e1254.member_1, _e1245.member_2, _e1245.member_3);
                        }
                        let _e1263 = phi_955_;
                        if (_e1254.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1269 = (_e315 < 64u);
                            if _e1269 {
                            } else {
                                phi_3493_ = true;
                                phi_3094_ = type_44();
                                break;
                            }
                            local[_e315] = _e1254.member_3;
                            if _e1269 {
                            } else {
                                phi_3493_ = true;
                                phi_3094_ = type_44();
                                break;
                            }
                            local_1[_e315] = _e1254.member_2;
                            phi_977_ = (_e315 + 1u);
                        } else {
                            phi_977_ = _e315;
                        }
                        let _e1274 = phi_977_;
                        if (_e1263.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1276 = (_e1274 < 64u);
                            if _e1276 {
                            } else {
                                phi_3493_ = true;
                                phi_3094_ = type_44();
                                break;
                            }
                            local[_e1274] = _e1263.member_3;
                            if _e1276 {
                            } else {
                                phi_3493_ = true;
                                phi_3094_ = type_44();
                                break;
                            }
                            local_1[_e1274] = _e1263.member_2;
                            phi_995_ = (_e1274 + 1u);
                        } else {
                            phi_995_ = _e1274;
                        }
                        let _e1281 = phi_995_;
                        if (_e1263.member < 340282350000000000000000000000000000000f) {
                            let _e1283 = (_e1281 < 64u);
                            if _e1283 {
                            } else {
                                phi_3493_ = true;
                                phi_3094_ = type_44();
                                break;
                            }
                            local[_e1281] = _e1263.member_1;
                            if _e1283 {
                            } else {
                                phi_3493_ = true;
                                phi_3094_ = type_44();
                                break;
                            }
                            local_1[_e1281] = _e1263.member;
                            phi_1013_ = (_e1281 + 1u);
                        } else {
                            phi_1013_ = _e1281;
                        }
                        let _e1288 = phi_1013_;
                        phi_3429_ = _e311;
                        phi_1835_ = select(0u, _e1245.member_1, (_e1245.member < 340282350000000000000000000000000000000f));
                        phi_1836_ = _e1288;
                        phi_531_ = _e317;
                    } else {
                        phi_1022_ = type_12(_e320, (_e320 + _e318));
                        phi_1025_ = _e317;
                        loop {
                            let _e325 = phi_1022_;
                            let _e327 = phi_1025_;
                            local_7 = _e327;
                            if (_e325.member < _e325.member_1) {
                                phi_1023_ = type_12((_e325.member + 1u), _e325.member_1);
                                phi_1048_ = type_12(1u, _e325.member);
                            } else {
                                phi_1023_ = _e325;
                                phi_1048_ = type_12(0u, type_12().member_1);
                            }
                            let _e340 = phi_1023_;
                            let _e342 = phi_1048_;
                            let _e346 = (bitcast<i32>(_e342.member) != 0i);
                            if _e346 {
                                let _e347 = (_e342.member_1 < _e95);
                                if _e347 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                if _e229 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                let _e351 = triangles.member[_e342.member_1].member[_e226];
                                let _e352 = (_e351 - _e246);
                                if _e229 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                let _e356 = triangles.member[_e342.member_1].member_2[_e226];
                                let _e357 = (_e356 - _e246);
                                if _e229 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                let _e361 = triangles.member[_e342.member_1].member_4[_e226];
                                let _e362 = (_e361 - _e246);
                                if _e233 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                let _e366 = triangles.member[_e342.member_1].member[_e225];
                                let _e369 = ((_e366 - _e242) - (_e236 * _e352));
                                if _e237 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                let _e373 = triangles.member[_e342.member_1].member[_e224];
                                let _e376 = ((_e373 - _e244) - (_e240 * _e352));
                                if _e233 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                let _e380 = triangles.member[_e342.member_1].member_2[_e225];
                                let _e383 = ((_e380 - _e242) - (_e236 * _e357));
                                if _e237 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                let _e387 = triangles.member[_e342.member_1].member_2[_e224];
                                let _e390 = ((_e387 - _e244) - (_e240 * _e357));
                                if _e233 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                let _e394 = triangles.member[_e342.member_1].member_4[_e225];
                                let _e397 = ((_e394 - _e242) - (_e236 * _e362));
                                if _e237 {
                                } else {
                                    phi_3338_ = true;
                                    break;
                                }
                                let _e401 = triangles.member[_e342.member_1].member_4[_e224];
                                let _e404 = ((_e401 - _e244) - (_e240 * _e362));
                                let _e405 = (_e397 * _e390);
                                let _e406 = (_e404 * _e383);
                                if (_e405 != _e406) {
                                    phi_1164_ = (_e405 - _e406);
                                } else {
                                    let _e408 = (_e397 * 4097f);
                                    let _e410 = (_e408 - (_e408 - _e397));
                                    let _e411 = (_e390 * 4097f);
                                    let _e413 = (_e411 - (_e411 - _e390));
                                    let _e414 = (_e397 - _e410);
                                    let _e415 = (_e390 - _e413);
                                    let _e424 = (_e404 * 4097f);
                                    let _e426 = (_e424 - (_e424 - _e404));
                                    let _e427 = (_e383 * 4097f);
                                    let _e429 = (_e427 - (_e427 - _e383));
                                    let _e430 = (_e404 - _e426);
                                    let _e431 = (_e383 - _e429);
                                    phi_1164_ = ((((((_e410 * _e413) - _e405) + (_e410 * _e415)) + (_e414 * _e413)) + (_e414 * _e415)) - (((((_e426 * _e429) - _e406) + (_e426 * _e431)) + (_e430 * _e429)) + (_e430 * _e431)));
                                }
                                let _e443 = phi_1164_;
                                let _e444 = (_e369 * _e404);
                                let _e445 = (_e376 * _e397);
                                if (_e444 != _e445) {
                                    phi_1175_ = (_e444 - _e445);
                                } else {
                                    let _e447 = (_e369 * 4097f);
                                    let _e449 = (_e447 - (_e447 - _e369));
                                    let _e450 = (_e404 * 4097f);
                                    let _e452 = (_e450 - (_e450 - _e404));
                                    let _e453 = (_e369 - _e449);
                                    let _e454 = (_e404 - _e452);
                                    let _e463 = (_e376 * 4097f);
                                    let _e465 = (_e463 - (_e463 - _e376));
                                    let _e466 = (_e397 * 4097f);
                                    let _e468 = (_e466 - (_e466 - _e397));
                                    let _e469 = (_e376 - _e465);
                                    let _e470 = (_e397 - _e468);
                                    phi_1175_ = ((((((_e449 * _e452) - _e444) + (_e449 * _e454)) + (_e453 * _e452)) + (_e453 * _e454)) - (((((_e465 * _e468) - _e445) + (_e465 * _e470)) + (_e469 * _e468)) + (_e469 * _e470)));
                                }
                                let _e482 = phi_1175_;
                                let _e483 = (_e383 * _e376);
                                let _e484 = (_e390 * _e369);
                                if (_e483 != _e484) {
                                    phi_1186_ = (_e483 - _e484);
                                } else {
                                    let _e486 = (_e383 * 4097f);
                                    let _e488 = (_e486 - (_e486 - _e383));
                                    let _e489 = (_e376 * 4097f);
                                    let _e491 = (_e489 - (_e489 - _e376));
                                    let _e492 = (_e383 - _e488);
                                    let _e493 = (_e376 - _e491);
                                    let _e502 = (_e390 * 4097f);
                                    let _e504 = (_e502 - (_e502 - _e390));
                                    let _e505 = (_e369 * 4097f);
                                    let _e507 = (_e505 - (_e505 - _e369));
                                    let _e508 = (_e390 - _e504);
                                    let _e509 = (_e369 - _e507);
                                    phi_1186_ = ((((((_e488 * _e491) - _e483) + (_e488 * _e493)) + (_e492 * _e491)) + (_e492 * _e493)) - (((((_e504 * _e507) - _e484) + (_e504 * _e509)) + (_e508 * _e507)) + (_e508 * _e509)));
                                }
                                let _e521 = phi_1186_;
                                if (_e443 < 0f) {
                                    phi_1204_ = f32();
                                    phi_1205_ = true;
                                } else {
                                    if (_e482 < 0f) {
                                        phi_1202_ = f32();
                                        phi_1203_ = true;
                                    } else {
                                        let _e524 = (_e521 < 0f);
                                        if _e524 {
                                            phi_1201_ = f32();
                                        } else {
                                            phi_1201_ = ((_e443 + _e482) + _e521);
                                        }
                                        let _e528 = phi_1201_;
                                        phi_1202_ = _e528;
                                        phi_1203_ = _e524;
                                    }
                                    let _e530 = phi_1202_;
                                    let _e532 = phi_1203_;
                                    phi_1204_ = _e530;
                                    phi_1205_ = _e532;
                                }
                                let _e534 = phi_1204_;
                                let _e536 = phi_1205_;
                                if _e536 {
                                    if (_e443 > 0f) {
                                        phi_1226_ = f32();
                                        phi_1227_ = true;
                                        phi_1228_ = false;
                                    } else {
                                        let _e538 = (_e482 > 0f);
                                        if _e538 {
                                            phi_1224_ = f32();
                                            phi_1225_ = false;
                                        } else {
                                            phi_1224_ = ((_e443 + _e482) + _e521);
                                            phi_1225_ = select(true, false, (_e521 > 0f));
                                        }
                                        let _e544 = phi_1224_;
                                        let _e546 = phi_1225_;
                                        phi_1226_ = _e544;
                                        phi_1227_ = _e538;
                                        phi_1228_ = _e546;
                                    }
                                    let _e548 = phi_1226_;
                                    let _e550 = phi_1227_;
                                    let _e552 = phi_1228_;
                                    phi_1233_ = _e548;
                                    phi_1234_ = select(_e552, false, _e550);
                                } else {
                                    phi_1233_ = _e534;
                                    phi_1234_ = true;
                                }
                                let _e555 = phi_1233_;
                                let _e557 = phi_1234_;
                                if _e557 {
                                    let _e558 = (_e555 == 0f);
                                    if _e558 {
                                        phi_1322_ = array<f32, 3>();
                                        phi_1323_ = array<f32, 3>();
                                        phi_1324_ = false;
                                    } else {
                                        let _e559 = (_e352 * _e232);
                                        let _e560 = (_e357 * _e232);
                                        let _e561 = (_e362 * _e232);
                                        let _e564 = (1f / ((_e443 + _e482) + _e521));
                                        let _e565 = (_e482 * _e564);
                                        let _e566 = (_e521 * _e564);
                                        let _e572 = ((((_e443 * _e564) * _e559) + (_e565 * _e560)) + (_e566 * _e561));
                                        let _e573 = abs(_e369);
                                        let _e574 = abs(_e383);
                                        let _e576 = select(_e574, _e573, (_e573 > _e574));
                                        let _e577 = abs(_e397);
                                        let _e580 = abs(_e376);
                                        let _e581 = abs(_e390);
                                        let _e583 = select(_e581, _e580, (_e580 > _e581));
                                        let _e584 = abs(_e404);
                                        let _e588 = abs(_e559);
                                        let _e589 = abs(_e560);
                                        let _e591 = select(_e589, _e588, (_e588 > _e589));
                                        let _e592 = abs(_e561);
                                        let _e599 = (((select(_e577, _e576, (_e576 > _e577)) * select(_e584, _e583, (_e583 > _e584))) * select(_e592, _e591, (_e591 > _e592))) <= (abs((_e555 * _e572)) * 256f));
                                        if _e599 {
                                            phi_1320_ = array<f32, 3>(_e572, _e565, _e566);
                                            phi_1321_ = array<f32, 3>();
                                        } else {
                                            let _e601 = (_e397 * 4097f);
                                            let _e603 = (_e601 - (_e601 - _e397));
                                            let _e604 = (_e390 * 4097f);
                                            let _e606 = (_e604 - (_e604 - _e390));
                                            let _e607 = (_e397 - _e603);
                                            let _e608 = (_e390 - _e606);
                                            let _e617 = (_e404 * 4097f);
                                            let _e619 = (_e617 - (_e617 - _e404));
                                            let _e620 = (_e383 * 4097f);
                                            let _e622 = (_e620 - (_e620 - _e383));
                                            let _e623 = (_e404 - _e619);
                                            let _e624 = (_e383 - _e622);
                                            let _e634 = ((_e405 - _e406) + ((((((_e603 * _e606) - _e405) + (_e603 * _e608)) + (_e607 * _e606)) + (_e607 * _e608)) - (((((_e619 * _e622) - _e406) + (_e619 * _e624)) + (_e623 * _e622)) + (_e623 * _e624))));
                                            let _e636 = (_e369 * 4097f);
                                            let _e638 = (_e636 - (_e636 - _e369));
                                            let _e639 = (_e369 - _e638);
                                            let _e648 = (_e376 * 4097f);
                                            let _e650 = (_e648 - (_e648 - _e376));
                                            let _e651 = (_e376 - _e650);
                                            let _e661 = ((_e444 - _e445) + ((((((_e638 * _e619) - _e444) + (_e638 * _e623)) + (_e639 * _e619)) + (_e639 * _e623)) - (((((_e650 * _e603) - _e445) + (_e650 * _e607)) + (_e651 * _e603)) + (_e651 * _e607))));
                                            let _e680 = ((_e483 - _e484) + ((((((_e622 * _e650) - _e483) + (_e622 * _e651)) + (_e624 * _e650)) + (_e624 * _e651)) - (((((_e606 * _e638) - _e484) + (_e606 * _e639)) + (_e608 * _e638)) + (_e608 * _e639))));
                                            let _e683 = (1f / ((_e634 + _e661) + _e680));
                                            let _e684 = (_e661 * _e683);
                                            let _e685 = (_e680 * _e683);
                                            phi_1320_ = array<f32, 3>();
                                            phi_1321_ = array<f32, 3>(((((_e634 * _e683) * _e559) + (_e684 * _e560)) + (_e685 * _e561)), _e684, _e685);
                                        }
                                        let _e695 = phi_1320_;
                                        let _e697 = phi_1321_;
                                        phi_1322_ = _e695;
                                        phi_1323_ = _e697;
                                        phi_1324_ = _e599;
                                    }
                                    let _e699 = phi_1322_;
                                    let _e701 = phi_1323_;
                                    let _e703 = phi_1324_;
                                    phi_1325_ = _e699;
                                    phi_1326_ = _e701;
                                    phi_1327_ = _e558;
                                    phi_1328_ = _e703;
                                } else {
                                    phi_1325_ = array<f32, 3>();
                                    phi_1326_ = array<f32, 3>();
                                    phi_1327_ = true;
                                    phi_1328_ = false;
                                }
                                let _e705 = phi_1325_;
                                let _e707 = phi_1326_;
                                let _e709 = phi_1327_;
                                let _e711 = phi_1328_;
                                if _e709 {
                                    phi_1333_ = array<f32, 3>(-1f, 0f, 0f);
                                } else {
                                    phi_1333_ = _e705;
                                }
                                let _e713 = phi_1333_;
                                if select(_e711, true, _e709) {
                                    phi_1338_ = _e713;
                                } else {
                                    phi_1338_ = _e707;
                                }
                                let _e716 = phi_1338_;
                                let _e720 = (_e716[0] >= 0f);
                                if _e720 {
                                    let _e722 = (_e716[0] < _e327.member);
                                    if _e722 {
                                        if _e720 {
                                            if _e347 {
                                            } else {
                                                phi_3338_ = true;
                                                break;
                                            }
                                            let _e725 = triangles.member[_e342.member_1].member_3;
                                            if ((_e725 & 1u) == 0u) {
                                                phi_1804_ = true;
                                            } else {
                                                if _e347 {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                let _e730 = triangles.member[_e342.member_1].member_1;
                                                let _e731 = (_e730 * 12u);
                                                if ((256u + _e731) < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 257u) < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 258u) < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                let _e738 = (_e731 + 259u);
                                                if (_e738 < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                let _e741 = surfaces.member[_e738];
                                                if ((_e731 + 260u) < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 261u) < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 262u) < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                let _e748 = (_e731 + 263u);
                                                if (_e748 < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                let _e751 = surfaces.member[_e748];
                                                let _e752 = (_e731 + 264u);
                                                if (_e752 < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                let _e755 = surfaces.member[_e752];
                                                let _e756 = bitcast<f32>(_e755);
                                                let _e757 = (_e731 + 265u);
                                                if (_e757 < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                let _e760 = surfaces.member[_e757];
                                                let _e761 = bitcast<f32>(_e760);
                                                if ((_e731 + 266u) < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 267u) < _e101) {
                                                } else {
                                                    phi_3338_ = true;
                                                    break;
                                                }
                                                if (_e741 == 4294967295u) {
                                                    phi_1799_ = (_e756 < _e761);
                                                } else {
                                                    if (_e342.member_1 < _e98) {
                                                    } else {
                                                        phi_3338_ = true;
                                                        break;
                                                    }
                                                    let _e769 = ((1f - _e716[1]) - _e716[2]);
                                                    let _e773 = attributes.member[_e342.member_1].member[0u];
                                                    let _e778 = attributes.member[_e342.member_1].member[2u];
                                                    let _e784 = attributes.member[_e342.member_1].member[4u];
                                                    let _e786 = (((_e773 * _e769) + (_e778 * _e716[1])) + (_e784 * _e716[2]));
                                                    let _e790 = attributes.member[_e342.member_1].member[1u];
                                                    let _e795 = attributes.member[_e342.member_1].member[3u];
                                                    let _e801 = attributes.member[_e342.member_1].member[5u];
                                                    let _e803 = (((_e790 * _e769) + (_e795 * _e716[1])) + (_e801 * _e716[2]));
                                                    let _e804 = (_e751 & 65535u);
                                                    let _e806 = (_e751 >> bitcast<u32>(16i));
                                                    let _e809 = ((_e741 >> bitcast<u32>(28u)) & 3u);
                                                    let _e810 = (_e804 - 1u);
                                                    let _e812 = select(1f, 2f, (_e809 == 2u));
                                                    let _e816 = (_e786 - (floor((_e786 / _e812)) * _e812));
                                                    if (_e816 > 1f) {
                                                        phi_1537_ = (_e812 - _e816);
                                                    } else {
                                                        phi_1537_ = _e816;
                                                    }
                                                    let _e820 = phi_1537_;
                                                    if (_e809 == 1u) {
                                                        let _e823 = select(0f, _e786, (_e786 > 0f));
                                                        phi_1552_ = select(1f, _e823, (_e823 < 1f));
                                                    } else {
                                                        phi_1552_ = _e820;
                                                    }
                                                    let _e827 = phi_1552_;
                                                    let _e834 = ((select(0f, _e827, (abs((_e827 - 0.5f)) <= 0.5f)) * f32(_e804)) - 0.5f);
                                                    let _e835 = floor(_e834);
                                                    let _e836 = (_e835 < 0f);
                                                    if _e836 {
                                                        phi_1580_ = 0u;
                                                    } else {
                                                        let _e841 = select(select(u32(_e835), 0u, (_e835 < 0f)), 4294967295u, (_e835 > 4294967000f));
                                                        phi_1580_ = select(_e841, _e810, (_e810 < _e841));
                                                    }
                                                    let _e845 = phi_1580_;
                                                    if _e836 {
                                                        phi_1590_ = 0u;
                                                    } else {
                                                        let _e846 = (_e845 + 1u);
                                                        phi_1590_ = select(_e846, _e810, (_e810 < _e846));
                                                    }
                                                    let _e850 = phi_1590_;
                                                    let _e851 = (_e809 == 0u);
                                                    if _e851 {
                                                        phi_1599_ = select(true, false, _e836);
                                                    } else {
                                                        phi_1599_ = true;
                                                    }
                                                    let _e854 = phi_1599_;
                                                    let _e855 = select(_e810, _e845, _e854);
                                                    if _e851 {
                                                        if _e836 {
                                                            phi_1615_ = true;
                                                        } else {
                                                            phi_1615_ = select(true, false, (_e855 == _e810));
                                                        }
                                                        let _e859 = phi_1615_;
                                                        phi_1616_ = _e859;
                                                    } else {
                                                        phi_1616_ = true;
                                                    }
                                                    let _e861 = phi_1616_;
                                                    let _e862 = select(0u, _e850, _e861);
                                                    let _e863 = (_e834 - _e835);
                                                    let _e866 = ((_e741 >> bitcast<u32>(30u)) & 3u);
                                                    let _e867 = (_e806 - 1u);
                                                    let _e869 = select(1f, 2f, (_e866 == 2u));
                                                    let _e873 = (_e803 - (floor((_e803 / _e869)) * _e869));
                                                    if (_e873 > 1f) {
                                                        phi_1639_ = (_e869 - _e873);
                                                    } else {
                                                        phi_1639_ = _e873;
                                                    }
                                                    let _e877 = phi_1639_;
                                                    if (_e866 == 1u) {
                                                        let _e880 = select(0f, _e803, (_e803 > 0f));
                                                        phi_1654_ = select(1f, _e880, (_e880 < 1f));
                                                    } else {
                                                        phi_1654_ = _e877;
                                                    }
                                                    let _e884 = phi_1654_;
                                                    let _e891 = ((select(0f, _e884, (abs((_e884 - 0.5f)) <= 0.5f)) * f32(_e806)) - 0.5f);
                                                    let _e892 = floor(_e891);
                                                    let _e893 = (_e892 < 0f);
                                                    if _e893 {
                                                        phi_1682_ = 0u;
                                                    } else {
                                                        let _e898 = select(select(u32(_e892), 0u, (_e892 < 0f)), 4294967295u, (_e892 > 4294967000f));
                                                        phi_1682_ = select(_e898, _e867, (_e867 < _e898));
                                                    }
                                                    let _e902 = phi_1682_;
                                                    if _e893 {
                                                        phi_1692_ = 0u;
                                                    } else {
                                                        let _e903 = (_e902 + 1u);
                                                        phi_1692_ = select(_e903, _e867, (_e867 < _e903));
                                                    }
                                                    let _e907 = phi_1692_;
                                                    let _e908 = (_e866 == 0u);
                                                    if _e908 {
                                                        phi_1701_ = select(true, false, _e893);
                                                    } else {
                                                        phi_1701_ = true;
                                                    }
                                                    let _e911 = phi_1701_;
                                                    let _e912 = select(_e867, _e902, _e911);
                                                    if _e908 {
                                                        if _e893 {
                                                            phi_1717_ = true;
                                                        } else {
                                                            phi_1717_ = select(true, false, (_e912 == _e867));
                                                        }
                                                        let _e916 = phi_1717_;
                                                        phi_1718_ = _e916;
                                                    } else {
                                                        phi_1718_ = true;
                                                    }
                                                    let _e918 = phi_1718_;
                                                    let _e920 = (_e891 - _e892);
                                                    let _e921 = (_e741 & 268435455u);
                                                    let _e923 = (_e921 + (_e912 * _e804));
                                                    let _e925 = (_e921 + (select(0u, _e907, _e918) * _e804));
                                                    let _e926 = (_e923 + _e855);
                                                    let _e927 = (_e923 + _e862);
                                                    let _e928 = (_e925 + _e855);
                                                    let _e929 = (_e925 + _e862);
                                                    if (_e926 < _e101) {
                                                    } else {
                                                        phi_3338_ = true;
                                                        break;
                                                    }
                                                    let _e932 = surfaces.member[_e926];
                                                    if (_e927 < _e101) {
                                                    } else {
                                                        phi_3338_ = true;
                                                        break;
                                                    }
                                                    let _e935 = surfaces.member[_e927];
                                                    if (_e928 < _e101) {
                                                    } else {
                                                        phi_3338_ = true;
                                                        break;
                                                    }
                                                    let _e938 = surfaces.member[_e928];
                                                    if (_e929 < _e101) {
                                                    } else {
                                                        phi_3338_ = true;
                                                        break;
                                                    }
                                                    let _e941 = surfaces.member[_e929];
                                                    let _e958 = (1f - _e863);
                                                    phi_1799_ = ((_e756 * (((((f32((_e932 >> bitcast<u32>(24i))) * 0.003921569f) * _e958) + ((f32((_e935 >> bitcast<u32>(24i))) * 0.003921569f) * _e863)) * (1f - _e920)) + ((((f32((_e938 >> bitcast<u32>(24i))) * 0.003921569f) * _e958) + ((f32((_e941 >> bitcast<u32>(24i))) * 0.003921569f) * _e863)) * _e920))) < _e761);
                                                }
                                                let _e973 = phi_1799_;
                                                phi_1804_ = select(true, false, _e973);
                                            }
                                            let _e976 = phi_1804_;
                                            if _e976 {
                                                phi_1809_ = type_44(_e716[0], _e342.member_1, _e716[1], _e716[2]);
                                            } else {
                                                phi_1809_ = type_44();
                                            }
                                            let _e979 = phi_1809_;
                                            phi_1811_ = _e979;
                                            phi_1813_ = select(true, false, _e976);
                                        } else {
                                            phi_1811_ = type_44();
                                            phi_1813_ = false;
                                        }
                                        let _e982 = phi_1811_;
                                        let _e984 = phi_1813_;
                                        phi_1814_ = _e982;
                                        phi_1816_ = select(true, false, _e720);
                                        phi_1817_ = _e984;
                                    } else {
                                        phi_1814_ = type_44();
                                        phi_1816_ = false;
                                        phi_1817_ = false;
                                    }
                                    let _e987 = phi_1814_;
                                    let _e989 = phi_1816_;
                                    let _e991 = phi_1817_;
                                    phi_1818_ = _e987;
                                    phi_1819_ = select(true, false, _e722);
                                    phi_1820_ = _e989;
                                    phi_1821_ = _e991;
                                } else {
                                    phi_1818_ = type_44();
                                    phi_1819_ = true;
                                    phi_1820_ = false;
                                    phi_1821_ = false;
                                }
                                let _e994 = phi_1818_;
                                let _e996 = phi_1819_;
                                let _e998 = phi_1820_;
                                let _e1000 = phi_1821_;
                                if select(select(_e1000, false, _e996), true, select(_e998, true, _e996)) {
                                    phi_1834_ = _e327;
                                } else {
                                    phi_1834_ = _e994;
                                }
                                let _e1005 = phi_1834_;
                                phi_1026_ = _e1005;
                            } else {
                                phi_1026_ = type_44();
                            }
                            let _e1007 = phi_1026_;
                            continue;
                            continuing {
                                phi_1022_ = _e340;
                                phi_1025_ = _e1007;
                                phi_3338_ = _e311;
                                break if !(_e346);
                            }
                        }
                        let _e1010 = phi_3338_;
                        phi_3493_ = _e1010;
                        phi_3094_ = type_44();
                        if _e1010 {
                            break;
                        }
                        phi_3429_ = _e1010;
                        phi_1835_ = 0u;
                        phi_1836_ = _e315;
                        let _e2287 = local_7;
                        phi_531_ = _e2287;
                    }
                    let _e1292 = phi_3429_;
                    let _e1294 = phi_1835_;
                    let _e1296 = phi_1836_;
                    let _e1298 = phi_531_;
                    phi_526_ = _e1294;
                    phi_529_ = _e1296;
                    loop {
                        let _e1300 = phi_526_;
                        let _e1302 = phi_529_;
                        local_5 = _e1300;
                        local_6 = _e1302;
                        let _e1303 = (_e1300 == 0u);
                        local_4 = _e1303;
                        if _e1303 {
                            let _e1304 = (_e1302 > 0u);
                            if _e1304 {
                                let _e1305 = (_e1302 - 1u);
                                let _e1306 = (_e1305 < 64u);
                                if _e1306 {
                                } else {
                                    phi_3426_ = true;
                                    break;
                                }
                                let _e1308 = local_1[_e1305];
                                if (_e1308 <= _e1298.member) {
                                    if _e1306 {
                                    } else {
                                        phi_3426_ = true;
                                        break;
                                    }
                                    let _e1312 = local[_e1305];
                                    phi_1871_ = _e1312;
                                } else {
                                    phi_1871_ = _e1300;
                                }
                                let _e1314 = phi_1871_;
                                phi_1872_ = _e1314;
                                phi_1873_ = _e1305;
                            } else {
                                phi_1872_ = u32();
                                phi_1873_ = u32();
                            }
                            let _e1316 = phi_1872_;
                            let _e1318 = phi_1873_;
                            phi_1838_ = _e1316;
                            phi_1840_ = _e1318;
                            phi_1874_ = _e1304;
                        } else {
                            phi_1838_ = u32();
                            phi_1840_ = u32();
                            phi_1874_ = false;
                        }
                        let _e1320 = phi_1838_;
                        let _e1322 = phi_1840_;
                        let _e1324 = phi_1874_;
                        continue;
                        continuing {
                            phi_526_ = _e1320;
                            phi_529_ = _e1322;
                            phi_3426_ = _e1292;
                            break if !(_e1324);
                        }
                    }
                    let _e1327 = phi_3426_;
                    phi_3493_ = _e1327;
                    phi_3094_ = type_44();
                    if _e1327 {
                        break;
                    }
                    let _e1329 = local_4;
                    continue;
                    continuing {
                        phi_3342_ = _e1327;
                        let _e2210 = local_5;
                        phi_525_ = _e2210;
                        let _e2213 = local_6;
                        phi_528_ = _e2213;
                        phi_530_ = _e1298;
                        phi_3493_ = _e1327;
                        phi_3094_ = _e1298;
                        break if !(select(true, false, _e1329));
                    }
                }
                let _e1333 = phi_3493_;
                let _e1335 = phi_3094_;
                if _e1333 {
                    break;
                }
                let _e1337 = (_e1335.member_1 != 4294967295u);
                if _e1337 {
                    if (_e1335.member_1 < _e95) {
                    } else {
                        break;
                    }
                    let _e1341 = triangles.member[_e1335.member_1].member;
                    let _e1347 = triangles.member[_e1335.member_1].member_2;
                    let _e1353 = triangles.member[_e1335.member_1].member_4;
                    let _e1357 = (_e1347[0] - _e1341[0]);
                    let _e1358 = (_e1347[1] - _e1341[1]);
                    let _e1359 = (_e1347[2] - _e1341[2]);
                    let _e1360 = (_e1353[0] - _e1341[0]);
                    let _e1361 = (_e1353[1] - _e1341[1]);
                    let _e1362 = (_e1353[2] - _e1341[2]);
                    let _e1379 = ((_e1358 * _e1362) - (_e1361 * _e1359));
                    let _e1382 = ((_e1359 * _e1360) - (_e1362 * _e1357));
                    let _e1385 = ((_e1357 * _e1361) - (_e1360 * _e1358));
                    let _e1386 = abs(_e1379);
                    let _e1387 = abs(_e1382);
                    let _e1389 = select(_e1387, _e1386, (_e1386 > _e1387));
                    let _e1390 = abs(_e1385);
                    let _e1392 = select(_e1390, _e1389, (_e1389 > _e1390));
                    if (_e1392 > 0.000000000000000000000000000000000000011754944f) {
                        let _e1394 = (_e1392 < 340282350000000000000000000000000000000f);
                        if _e1394 {
                            let _e1395 = (_e1379 / _e1392);
                            let _e1396 = (_e1382 / _e1392);
                            let _e1397 = (_e1385 / _e1392);
                            let _e1403 = sqrt((((_e1395 * _e1395) + (_e1396 * _e1396)) + (_e1397 * _e1397)));
                            phi_1976_ = vec3<f32>((_e1395 / _e1403), (_e1396 / _e1403), (_e1397 / _e1403));
                        } else {
                            phi_1976_ = vec3<f32>();
                        }
                        let _e1409 = phi_1976_;
                        phi_1978_ = _e1409;
                        phi_1979_ = select(true, false, _e1394);
                    } else {
                        phi_1978_ = vec3<f32>();
                        phi_1979_ = true;
                    }
                    let _e1412 = phi_1978_;
                    let _e1414 = phi_1979_;
                    let _e1416 = select(_e1412, vec3<f32>(0f, 1f, 0f), vec3(_e1414));
                    let _e1425 = ((((_e1416.x * _e198.x) + (_e1416.y * _e198.y)) + (_e1416.z * _e198.z)) < 0f);
                    if _e1425 {
                        phi_2000_ = _e1416;
                    } else {
                        phi_2000_ = -(_e1416);
                    }
                    let _e1428 = phi_2000_;
                    if (_e1335.member_1 < _e98) {
                    } else {
                        break;
                    }
                    let _e1432 = triangles.member[_e1335.member_1].member_1;
                    let _e1433 = (_e1432 * 12u);
                    let _e1434 = (256u + _e1433);
                    if (_e1434 < _e101) {
                    } else {
                        break;
                    }
                    let _e1437 = surfaces.member[_e1434];
                    let _e1438 = bitcast<f32>(_e1437);
                    let _e1439 = (_e1433 + 257u);
                    if (_e1439 < _e101) {
                    } else {
                        break;
                    }
                    let _e1442 = surfaces.member[_e1439];
                    let _e1443 = bitcast<f32>(_e1442);
                    let _e1444 = (_e1433 + 258u);
                    if (_e1444 < _e101) {
                    } else {
                        break;
                    }
                    let _e1447 = surfaces.member[_e1444];
                    let _e1448 = bitcast<f32>(_e1447);
                    let _e1449 = (_e1433 + 259u);
                    if (_e1449 < _e101) {
                    } else {
                        break;
                    }
                    let _e1452 = surfaces.member[_e1449];
                    let _e1453 = (_e1433 + 260u);
                    if (_e1453 < _e101) {
                    } else {
                        break;
                    }
                    let _e1456 = surfaces.member[_e1453];
                    let _e1458 = (_e1433 + 261u);
                    if (_e1458 < _e101) {
                    } else {
                        break;
                    }
                    let _e1461 = surfaces.member[_e1458];
                    let _e1463 = (_e1433 + 262u);
                    if (_e1463 < _e101) {
                    } else {
                        break;
                    }
                    let _e1466 = surfaces.member[_e1463];
                    let _e1469 = (_e1433 + 263u);
                    if (_e1469 < _e101) {
                    } else {
                        break;
                    }
                    let _e1472 = surfaces.member[_e1469];
                    let _e1473 = (_e1433 + 264u);
                    if (_e1473 < _e101) {
                    } else {
                        break;
                    }
                    let _e1476 = surfaces.member[_e1473];
                    let _e1477 = bitcast<f32>(_e1476);
                    if ((_e1433 + 265u) < _e101) {
                    } else {
                        break;
                    }
                    if ((_e1433 + 266u) < _e101) {
                    } else {
                        break;
                    }
                    if ((_e1433 + 267u) < _e101) {
                    } else {
                        break;
                    }
                    let _e1485 = ((1f - _e1335.member_2) - _e1335.member_3);
                    let _e1489 = attributes.member[_e1335.member_1].member[0u];
                    let _e1494 = attributes.member[_e1335.member_1].member[2u];
                    let _e1500 = attributes.member[_e1335.member_1].member[4u];
                    let _e1502 = (((_e1489 * _e1485) + (_e1494 * _e1335.member_2)) + (_e1500 * _e1335.member_3));
                    let _e1506 = attributes.member[_e1335.member_1].member[1u];
                    let _e1511 = attributes.member[_e1335.member_1].member[3u];
                    let _e1517 = attributes.member[_e1335.member_1].member[5u];
                    let _e1519 = (((_e1506 * _e1485) + (_e1511 * _e1335.member_2)) + (_e1517 * _e1335.member_3));
                    if (_e1452 == 4294967295u) {
                        phi_2576_ = type_47(vec3<f32>(_e1438, _e1443, _e1448), _e1477);
                    } else {
                        let _e1522 = (_e1472 & 65535u);
                        let _e1524 = (_e1472 >> bitcast<u32>(16i));
                        let _e1527 = ((_e1452 >> bitcast<u32>(28u)) & 3u);
                        let _e1528 = (_e1522 - 1u);
                        let _e1530 = select(1f, 2f, (_e1527 == 2u));
                        let _e1534 = (_e1502 - (floor((_e1502 / _e1530)) * _e1530));
                        if (_e1534 > 1f) {
                            phi_2172_ = (_e1530 - _e1534);
                        } else {
                            phi_2172_ = _e1534;
                        }
                        let _e1538 = phi_2172_;
                        if (_e1527 == 1u) {
                            let _e1541 = select(0f, _e1502, (_e1502 > 0f));
                            phi_2187_ = select(1f, _e1541, (_e1541 < 1f));
                        } else {
                            phi_2187_ = _e1538;
                        }
                        let _e1545 = phi_2187_;
                        let _e1552 = ((select(0f, _e1545, (abs((_e1545 - 0.5f)) <= 0.5f)) * f32(_e1522)) - 0.5f);
                        let _e1553 = floor(_e1552);
                        let _e1554 = (_e1553 < 0f);
                        if _e1554 {
                            phi_2215_ = 0u;
                        } else {
                            let _e1559 = select(select(u32(_e1553), 0u, (_e1553 < 0f)), 4294967295u, (_e1553 > 4294967000f));
                            phi_2215_ = select(_e1559, _e1528, (_e1528 < _e1559));
                        }
                        let _e1563 = phi_2215_;
                        if _e1554 {
                            phi_2225_ = 0u;
                        } else {
                            let _e1564 = (_e1563 + 1u);
                            phi_2225_ = select(_e1564, _e1528, (_e1528 < _e1564));
                        }
                        let _e1568 = phi_2225_;
                        let _e1569 = (_e1527 == 0u);
                        if _e1569 {
                            phi_2234_ = select(true, false, _e1554);
                        } else {
                            phi_2234_ = true;
                        }
                        let _e1572 = phi_2234_;
                        let _e1573 = select(_e1528, _e1563, _e1572);
                        if _e1569 {
                            if _e1554 {
                                phi_2250_ = true;
                            } else {
                                phi_2250_ = select(true, false, (_e1573 == _e1528));
                            }
                            let _e1577 = phi_2250_;
                            phi_2251_ = _e1577;
                        } else {
                            phi_2251_ = true;
                        }
                        let _e1579 = phi_2251_;
                        let _e1580 = select(0u, _e1568, _e1579);
                        let _e1581 = (_e1552 - _e1553);
                        let _e1584 = ((_e1452 >> bitcast<u32>(30u)) & 3u);
                        let _e1585 = (_e1524 - 1u);
                        let _e1587 = select(1f, 2f, (_e1584 == 2u));
                        let _e1591 = (_e1519 - (floor((_e1519 / _e1587)) * _e1587));
                        if (_e1591 > 1f) {
                            phi_2274_ = (_e1587 - _e1591);
                        } else {
                            phi_2274_ = _e1591;
                        }
                        let _e1595 = phi_2274_;
                        if (_e1584 == 1u) {
                            let _e1598 = select(0f, _e1519, (_e1519 > 0f));
                            phi_2289_ = select(1f, _e1598, (_e1598 < 1f));
                        } else {
                            phi_2289_ = _e1595;
                        }
                        let _e1602 = phi_2289_;
                        let _e1609 = ((select(0f, _e1602, (abs((_e1602 - 0.5f)) <= 0.5f)) * f32(_e1524)) - 0.5f);
                        let _e1610 = floor(_e1609);
                        let _e1611 = (_e1610 < 0f);
                        if _e1611 {
                            phi_2317_ = 0u;
                        } else {
                            let _e1616 = select(select(u32(_e1610), 0u, (_e1610 < 0f)), 4294967295u, (_e1610 > 4294967000f));
                            phi_2317_ = select(_e1616, _e1585, (_e1585 < _e1616));
                        }
                        let _e1620 = phi_2317_;
                        if _e1611 {
                            phi_2327_ = 0u;
                        } else {
                            let _e1621 = (_e1620 + 1u);
                            phi_2327_ = select(_e1621, _e1585, (_e1585 < _e1621));
                        }
                        let _e1625 = phi_2327_;
                        let _e1626 = (_e1584 == 0u);
                        if _e1626 {
                            phi_2336_ = select(true, false, _e1611);
                        } else {
                            phi_2336_ = true;
                        }
                        let _e1629 = phi_2336_;
                        let _e1630 = select(_e1585, _e1620, _e1629);
                        if _e1626 {
                            if _e1611 {
                                phi_2352_ = true;
                            } else {
                                phi_2352_ = select(true, false, (_e1630 == _e1585));
                            }
                            let _e1634 = phi_2352_;
                            phi_2353_ = _e1634;
                        } else {
                            phi_2353_ = true;
                        }
                        let _e1636 = phi_2353_;
                        let _e1638 = (_e1609 - _e1610);
                        let _e1639 = (_e1452 & 268435455u);
                        let _e1641 = (_e1639 + (_e1630 * _e1522));
                        let _e1643 = (_e1639 + (select(0u, _e1625, _e1636) * _e1522));
                        let _e1644 = (_e1641 + _e1573);
                        let _e1645 = (_e1641 + _e1580);
                        let _e1646 = (_e1643 + _e1573);
                        let _e1647 = (_e1643 + _e1580);
                        if (_e1644 < _e101) {
                        } else {
                            break;
                        }
                        let _e1650 = surfaces.member[_e1644];
                        if (_e1645 < _e101) {
                        } else {
                            break;
                        }
                        let _e1653 = surfaces.member[_e1645];
                        if (_e1646 < _e101) {
                        } else {
                            break;
                        }
                        let _e1656 = surfaces.member[_e1646];
                        if (_e1647 < _e101) {
                        } else {
                            break;
                        }
                        let _e1659 = surfaces.member[_e1647];
                        let _e1660 = (_e1650 & 255u);
                        if (_e1660 < _e101) {
                        } else {
                            break;
                        }
                        let _e1663 = surfaces.member[_e1660];
                        let _e1667 = ((_e1650 >> bitcast<u32>(8i)) & 255u);
                        if (_e1667 < _e101) {
                        } else {
                            break;
                        }
                        let _e1670 = surfaces.member[_e1667];
                        let _e1674 = ((_e1650 >> bitcast<u32>(16i)) & 255u);
                        if (_e1674 < _e101) {
                        } else {
                            break;
                        }
                        let _e1677 = surfaces.member[_e1674];
                        let _e1679 = (1f - _e1581);
                        let _e1683 = (_e1653 & 255u);
                        if (_e1683 < _e101) {
                        } else {
                            break;
                        }
                        let _e1686 = surfaces.member[_e1683];
                        let _e1690 = ((_e1653 >> bitcast<u32>(8i)) & 255u);
                        if (_e1690 < _e101) {
                        } else {
                            break;
                        }
                        let _e1693 = surfaces.member[_e1690];
                        let _e1697 = ((_e1653 >> bitcast<u32>(16i)) & 255u);
                        if (_e1697 < _e101) {
                        } else {
                            break;
                        }
                        let _e1700 = surfaces.member[_e1697];
                        let _e1708 = (_e1656 & 255u);
                        if (_e1708 < _e101) {
                        } else {
                            break;
                        }
                        let _e1711 = surfaces.member[_e1708];
                        let _e1715 = ((_e1656 >> bitcast<u32>(8i)) & 255u);
                        if (_e1715 < _e101) {
                        } else {
                            break;
                        }
                        let _e1718 = surfaces.member[_e1715];
                        let _e1722 = ((_e1656 >> bitcast<u32>(16i)) & 255u);
                        if (_e1722 < _e101) {
                        } else {
                            break;
                        }
                        let _e1725 = surfaces.member[_e1722];
                        let _e1730 = (_e1659 & 255u);
                        if (_e1730 < _e101) {
                        } else {
                            break;
                        }
                        let _e1733 = surfaces.member[_e1730];
                        let _e1737 = ((_e1659 >> bitcast<u32>(8i)) & 255u);
                        if (_e1737 < _e101) {
                        } else {
                            break;
                        }
                        let _e1740 = surfaces.member[_e1737];
                        let _e1744 = ((_e1659 >> bitcast<u32>(16i)) & 255u);
                        if (_e1744 < _e101) {
                        } else {
                            break;
                        }
                        let _e1747 = surfaces.member[_e1744];
                        let _e1755 = (1f - _e1638);
                        phi_2576_ = type_47(vec3<f32>((_e1438 * ((((bitcast<f32>(_e1663) * _e1679) + (bitcast<f32>(_e1686) * _e1581)) * _e1755) + (((bitcast<f32>(_e1711) * _e1679) + (bitcast<f32>(_e1733) * _e1581)) * _e1638))), (_e1443 * ((((bitcast<f32>(_e1670) * _e1679) + (bitcast<f32>(_e1693) * _e1581)) * _e1755) + (((bitcast<f32>(_e1718) * _e1679) + (bitcast<f32>(_e1740) * _e1581)) * _e1638))), (_e1448 * ((((bitcast<f32>(_e1677) * _e1679) + (bitcast<f32>(_e1700) * _e1581)) * _e1755) + (((bitcast<f32>(_e1725) * _e1679) + (bitcast<f32>(_e1747) * _e1581)) * _e1638)))), (_e1477 * (((((f32((_e1650 >> bitcast<u32>(24i))) * 0.003921569f) * _e1679) + ((f32((_e1653 >> bitcast<u32>(24i))) * 0.003921569f) * _e1581)) * _e1755) + ((((f32((_e1656 >> bitcast<u32>(24i))) * 0.003921569f) * _e1679) + ((f32((_e1659 >> bitcast<u32>(24i))) * 0.003921569f) * _e1581)) * _e1638))));
                    }
                    let _e1798 = phi_2576_;
                    let _e1803 = attributes.member[_e1335.member_1].member_2[0u];
                    let _e1807 = attributes.member[_e1335.member_1].member_2[1u];
                    let _e1812 = attributes.member[_e1335.member_1].member_2[2u];
                    if (((_e1803 | _e1807) | _e1812) == 0u) {
                        phi_2683_ = vec3<f32>(1f, 1f, 1f);
                    } else {
                        let _e1828 = (1f - (f32((_e1803 & 1023u)) * 0.0009775171f));
                        let _e1829 = (1f - (f32(((_e1803 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                        let _e1830 = (1f - (f32(((_e1803 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                        let _e1850 = (1f - (f32((_e1807 & 1023u)) * 0.0009775171f));
                        let _e1851 = (1f - (f32(((_e1807 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                        let _e1852 = (1f - (f32(((_e1807 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                        let _e1875 = (1f - (f32((_e1812 & 1023u)) * 0.0009775171f));
                        let _e1876 = (1f - (f32(((_e1812 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                        let _e1877 = (1f - (f32(((_e1812 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                        phi_2683_ = vec3<f32>(((((_e1828 * _e1828) * _e1485) + ((_e1850 * _e1850) * _e1335.member_2)) + ((_e1875 * _e1875) * _e1335.member_3)), ((((_e1829 * _e1829) * _e1485) + ((_e1851 * _e1851) * _e1335.member_2)) + ((_e1876 * _e1876) * _e1335.member_3)), ((((_e1830 * _e1830) * _e1485) + ((_e1852 * _e1852) * _e1335.member_2)) + ((_e1877 * _e1877) * _e1335.member_3)));
                    }
                    let _e1889 = phi_2683_;
                    let _e1903 = attributes.member[_e1335.member_1].member_1[0u];
                    let _e1913 = (f32((bitcast<i32>((_e1903 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1915 = select(-1f, _e1913, (_e1913 > -1f));
                    let _e1917 = (f32((bitcast<i32>(_e1903) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1919 = select(-1f, _e1917, (_e1917 > -1f));
                    let _e1923 = ((1f - abs(_e1915)) - abs(_e1919));
                    let _e1924 = -(_e1923);
                    let _e1928 = (bitcast<u32>(select(0f, _e1924, (_e1924 > 0f))) & 2147483647u);
                    let _e1933 = (_e1915 - bitcast<f32>((_e1928 | (bitcast<u32>(_e1915) & 2147483648u))));
                    let _e1938 = (_e1919 - bitcast<f32>((_e1928 | (bitcast<u32>(_e1919) & 2147483648u))));
                    let _e1943 = (((_e1933 * _e1933) + (_e1938 * _e1938)) + (_e1923 * _e1923));
                    if (_e1943 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e1946 = (1f / sqrt(_e1943));
                        phi_2758_ = vec3<f32>((_e1933 * _e1946), (_e1938 * _e1946), (_e1923 * _e1946));
                    } else {
                        phi_2758_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e1952 = phi_2758_;
                    let _e1962 = attributes.member[_e1335.member_1].member_1[1u];
                    let _e1972 = (f32((bitcast<i32>((_e1962 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1974 = select(-1f, _e1972, (_e1972 > -1f));
                    let _e1976 = (f32((bitcast<i32>(_e1962) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1978 = select(-1f, _e1976, (_e1976 > -1f));
                    let _e1982 = ((1f - abs(_e1974)) - abs(_e1978));
                    let _e1983 = -(_e1982);
                    let _e1987 = (bitcast<u32>(select(0f, _e1983, (_e1983 > 0f))) & 2147483647u);
                    let _e1992 = (_e1974 - bitcast<f32>((_e1987 | (bitcast<u32>(_e1974) & 2147483648u))));
                    let _e1997 = (_e1978 - bitcast<f32>((_e1987 | (bitcast<u32>(_e1978) & 2147483648u))));
                    let _e2002 = (((_e1992 * _e1992) + (_e1997 * _e1997)) + (_e1982 * _e1982));
                    if (_e2002 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e2005 = (1f / sqrt(_e2002));
                        phi_2832_ = vec3<f32>((_e1992 * _e2005), (_e1997 * _e2005), (_e1982 * _e2005));
                    } else {
                        phi_2832_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e2011 = phi_2832_;
                    let _e2024 = attributes.member[_e1335.member_1].member_1[2u];
                    let _e2034 = (f32((bitcast<i32>((_e2024 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e2036 = select(-1f, _e2034, (_e2034 > -1f));
                    let _e2038 = (f32((bitcast<i32>(_e2024) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e2040 = select(-1f, _e2038, (_e2038 > -1f));
                    let _e2044 = ((1f - abs(_e2036)) - abs(_e2040));
                    let _e2045 = -(_e2044);
                    let _e2049 = (bitcast<u32>(select(0f, _e2045, (_e2045 > 0f))) & 2147483647u);
                    let _e2054 = (_e2036 - bitcast<f32>((_e2049 | (bitcast<u32>(_e2036) & 2147483648u))));
                    let _e2059 = (_e2040 - bitcast<f32>((_e2049 | (bitcast<u32>(_e2040) & 2147483648u))));
                    let _e2064 = (((_e2054 * _e2054) + (_e2059 * _e2059)) + (_e2044 * _e2044));
                    if (_e2064 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e2067 = (1f / sqrt(_e2064));
                        phi_2906_ = vec3<f32>((_e2054 * _e2067), (_e2059 * _e2067), (_e2044 * _e2067));
                    } else {
                        phi_2906_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e2073 = phi_2906_;
                    let _e2080 = (((_e1952.x * _e1485) + (_e2011.x * _e1335.member_2)) + (_e2073.x * _e1335.member_3));
                    let _e2081 = (((_e1952.y * _e1485) + (_e2011.y * _e1335.member_2)) + (_e2073.y * _e1335.member_3));
                    let _e2082 = (((_e1952.z * _e1485) + (_e2011.z * _e1335.member_2)) + (_e2073.z * _e1335.member_3));
                    let _e2083 = abs(_e2080);
                    let _e2084 = abs(_e2081);
                    let _e2086 = select(_e2084, _e2083, (_e2083 > _e2084));
                    let _e2087 = abs(_e2082);
                    let _e2089 = select(_e2087, _e2086, (_e2086 > _e2087));
                    if (_e2089 > 0.000000000000000000000000000000000000011754944f) {
                        let _e2091 = (_e2089 < 340282350000000000000000000000000000000f);
                        if _e2091 {
                            let _e2092 = (_e2080 / _e2089);
                            let _e2093 = (_e2081 / _e2089);
                            let _e2094 = (_e2082 / _e2089);
                            let _e2100 = sqrt((((_e2092 * _e2092) + (_e2093 * _e2093)) + (_e2094 * _e2094)));
                            phi_2951_ = vec3<f32>((_e2092 / _e2100), (_e2093 / _e2100), (_e2094 / _e2100));
                        } else {
                            phi_2951_ = vec3<f32>();
                        }
                        let _e2106 = phi_2951_;
                        phi_2953_ = _e2106;
                        phi_2954_ = select(true, false, _e2091);
                    } else {
                        phi_2953_ = vec3<f32>();
                        phi_2954_ = true;
                    }
                    let _e2109 = phi_2953_;
                    let _e2111 = phi_2954_;
                    let _e2113 = select(_e2109, _e1428, vec3(_e2111));
                    if ((((_e2113.x * _e198.x) + (_e2113.y * _e198.y)) + (_e2113.z * _e198.z)) > 0f) {
                        phi_2975_ = -(_e2113);
                    } else {
                        phi_2975_ = _e2113;
                    }
                    let _e2125 = phi_2975_;
                    if _e1425 {
                        phi_3005_ = array<f32, 3>(bitcast<f32>(_e1456), bitcast<f32>(_e1461), bitcast<f32>(_e1466));
                    } else {
                        phi_3005_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e2145 = phi_3005_;
                    let _e2146 = abs(_e1341[0]);
                    let _e2147 = abs(_e1341[1]);
                    let _e2149 = select(_e2147, _e2146, (_e2146 > _e2147));
                    let _e2150 = abs(_e1341[2]);
                    let _e2154 = abs(_e1357);
                    let _e2155 = abs(_e1358);
                    let _e2157 = select(_e2155, _e2154, (_e2154 > _e2155));
                    let _e2158 = abs(_e1359);
                    let _e2161 = abs(_e1360);
                    let _e2162 = abs(_e1361);
                    let _e2164 = select(_e2162, _e2161, (_e2161 > _e2162));
                    let _e2165 = abs(_e1362);
                    phi_3051_ = type_48(array<f32, 3>(((_e1341[0] + (_e1357 * _e1335.member_2)) + (_e1360 * _e1335.member_3)), ((_e1341[1] + (_e1358 * _e1335.member_2)) + (_e1361 * _e1335.member_3)), ((_e1341[2] + (_e1359 * _e1335.member_2)) + (_e1362 * _e1335.member_3))), _e1335.member_1, array<f32, 3>(_e2125.x, _e2125.y, _e2125.z), (_e1335.member * sqrt((((_e198.x * _e198.x) + (_e198.y * _e198.y)) + (_e198.z * _e198.z)))), array<f32, 3>(_e1428.x, _e1428.y, _e1428.z), select(0u, 1u, _e1425), array<f32, 3>((_e1798.member.x * _e1889.x), (_e1798.member.y * _e1889.y), (_e1798.member.z * _e1889.z)), _e1432, _e2145, ((select(_e2150, _e2149, (_e2149 > _e2150)) * 0.00000047683716f) + ((select(_e2158, _e2157, (_e2157 > _e2158)) + select(_e2165, _e2164, (_e2164 > _e2165))) * 0.0000010728836f)));
                } else {
                    phi_3051_ = type_48(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0f);
                }
                let _e2173 = phi_3051_;
                if _e1337 {
                    phi_3064_ = _e2173;
                } else {
                    let _e2176 = params.member.member_4;
                    phi_3064_ = type_48(_e2173.member, _e2173.member_1, _e2173.member_2, _e2173.member_3, _e2173.member_4, _e2173.member_5, _e2173.member_6, _e2173.member_7, array<f32, 3>(_e2176.x, _e2176.y, _e2176.z), _e2173.member_9);
                }
                let _e2193 = phi_3064_;
                if (_e114 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                surfels.member[_e114] = _e2193;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_gbuffer(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
