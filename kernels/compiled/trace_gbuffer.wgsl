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
    var phi_3370_: bool;
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
    var phi_1562_: bool;
    var phi_1587_: u32;
    var phi_1597_: u32;
    var phi_1606_: bool;
    var phi_1622_: bool;
    var phi_1623_: bool;
    var phi_1646_: f32;
    var phi_1661_: f32;
    var phi_1671_: bool;
    var phi_1696_: u32;
    var phi_1706_: u32;
    var phi_1715_: bool;
    var phi_1731_: bool;
    var phi_1732_: bool;
    var phi_1813_: bool;
    var phi_1818_: bool;
    var phi_1823_: type_44;
    var phi_1825_: type_44;
    var phi_1827_: bool;
    var phi_1828_: type_44;
    var phi_1830_: bool;
    var phi_1831_: bool;
    var phi_1832_: type_44;
    var phi_1833_: bool;
    var phi_1834_: bool;
    var phi_1835_: bool;
    var phi_1848_: type_44;
    var phi_1026_: type_44;
    var phi_3366_: bool;
    var phi_911_: type_45;
    var phi_922_: type_45;
    var phi_933_: type_45;
    var phi_944_: type_45;
    var phi_955_: type_45;
    var phi_977_: u32;
    var phi_995_: u32;
    var phi_1013_: u32;
    var phi_3461_: bool;
    var phi_1849_: u32;
    var phi_1850_: u32;
    var phi_531_: type_44;
    var phi_526_: u32;
    var phi_529_: u32;
    var phi_1885_: u32;
    var phi_1886_: u32;
    var phi_1887_: u32;
    var phi_1852_: u32;
    var phi_1854_: u32;
    var phi_1888_: bool;
    var phi_3458_: bool;
    var local_4: bool;
    var phi_3525_: bool;
    var phi_3122_: type_44;
    var phi_1990_: vec3<f32>;
    var phi_1992_: vec3<f32>;
    var phi_1993_: bool;
    var phi_2014_: vec3<f32>;
    var phi_2186_: f32;
    var phi_2201_: f32;
    var phi_2211_: bool;
    var phi_2236_: u32;
    var phi_2246_: u32;
    var phi_2255_: bool;
    var phi_2271_: bool;
    var phi_2272_: bool;
    var phi_2295_: f32;
    var phi_2310_: f32;
    var phi_2320_: bool;
    var phi_2345_: u32;
    var phi_2355_: u32;
    var phi_2364_: bool;
    var phi_2380_: bool;
    var phi_2381_: bool;
    var phi_2604_: type_47;
    var phi_2711_: vec3<f32>;
    var phi_2786_: vec3<f32>;
    var phi_2860_: vec3<f32>;
    var phi_2934_: vec3<f32>;
    var phi_2979_: vec3<f32>;
    var phi_2981_: vec3<f32>;
    var phi_2982_: bool;
    var phi_3003_: vec3<f32>;
    var phi_3033_: array<f32, 3>;
    var phi_3079_: type_48;
    var phi_3092_: type_48;
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
                phi_3370_ = false;
                phi_525_ = 0u;
                phi_528_ = 0u;
                phi_530_ = type_44(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                loop {
                    let _e311 = phi_3370_;
                    let _e313 = phi_525_;
                    let _e315 = phi_528_;
                    let _e317 = phi_530_;
                    let _e318 = (_e313 & 15u);
                    let _e320 = (_e313 >> bitcast<u32>(4u));
                    if (_e318 == 0u) {
                        if (_e320 < _e92) {
                        } else {
                            phi_3525_ = true;
                            phi_3122_ = type_44();
                            break;
                        }
                        let _e1019 = nodes.member[_e320].member;
                        let _e1028 = ((_e1019.x - _e289) * _e299);
                        let _e1029 = ((_e1019.y - _e289) * _e299);
                        let _e1030 = ((_e1019.z - _e289) * _e299);
                        let _e1031 = ((_e1019.w - _e289) * _e299);
                        let _e1034 = nodes.member[_e320].member_3;
                        let _e1043 = ((_e1034.x - _e292) * _e299);
                        let _e1044 = ((_e1034.y - _e292) * _e299);
                        let _e1045 = ((_e1034.z - _e292) * _e299);
                        let _e1046 = ((_e1034.w - _e292) * _e299);
                        let _e1049 = nodes.member[_e320].member_1;
                        let _e1058 = ((_e1049.x - _e290) * _e304);
                        let _e1059 = ((_e1049.y - _e290) * _e304);
                        let _e1060 = ((_e1049.z - _e290) * _e304);
                        let _e1061 = ((_e1049.w - _e290) * _e304);
                        let _e1064 = nodes.member[_e320].member_4;
                        let _e1073 = ((_e1064.x - _e293) * _e304);
                        let _e1074 = ((_e1064.y - _e293) * _e304);
                        let _e1075 = ((_e1064.z - _e293) * _e304);
                        let _e1076 = ((_e1064.w - _e293) * _e304);
                        let _e1079 = nodes.member[_e320].member_2;
                        let _e1088 = ((_e1079.x - _e291) * _e309);
                        let _e1089 = ((_e1079.y - _e291) * _e309);
                        let _e1090 = ((_e1079.z - _e291) * _e309);
                        let _e1091 = ((_e1079.w - _e291) * _e309);
                        let _e1094 = nodes.member[_e320].member_5;
                        let _e1103 = ((_e1094.x - _e294) * _e309);
                        let _e1104 = ((_e1094.y - _e294) * _e309);
                        let _e1105 = ((_e1094.z - _e294) * _e309);
                        let _e1106 = ((_e1094.w - _e294) * _e309);
                        let _e1108 = select(_e1043, _e1028, (_e1028 < _e1043));
                        let _e1110 = select(_e1044, _e1029, (_e1029 < _e1044));
                        let _e1112 = select(_e1045, _e1030, (_e1030 < _e1045));
                        let _e1114 = select(_e1046, _e1031, (_e1031 < _e1046));
                        let _e1116 = select(_e1073, _e1058, (_e1058 < _e1073));
                        let _e1118 = select(_e1074, _e1059, (_e1059 < _e1074));
                        let _e1120 = select(_e1075, _e1060, (_e1060 < _e1075));
                        let _e1122 = select(_e1076, _e1061, (_e1061 < _e1076));
                        let _e1124 = select(_e1116, _e1108, (_e1108 > _e1116));
                        let _e1126 = select(_e1118, _e1110, (_e1110 > _e1118));
                        let _e1128 = select(_e1120, _e1112, (_e1112 > _e1120));
                        let _e1130 = select(_e1122, _e1114, (_e1114 > _e1122));
                        let _e1132 = select(_e1103, _e1088, (_e1088 < _e1103));
                        let _e1134 = select(_e1104, _e1089, (_e1089 < _e1104));
                        let _e1136 = select(_e1105, _e1090, (_e1090 < _e1105));
                        let _e1138 = select(_e1106, _e1091, (_e1091 < _e1106));
                        let _e1140 = select(_e1132, _e1124, (_e1124 > _e1132));
                        let _e1142 = select(_e1134, _e1126, (_e1126 > _e1134));
                        let _e1144 = select(_e1136, _e1128, (_e1128 > _e1136));
                        let _e1146 = select(_e1138, _e1130, (_e1130 > _e1138));
                        let _e1148 = select(0f, _e1140, (_e1140 > 0f));
                        let _e1150 = select(0f, _e1142, (_e1142 > 0f));
                        let _e1152 = select(0f, _e1144, (_e1144 > 0f));
                        let _e1154 = select(0f, _e1146, (_e1146 > 0f));
                        let _e1156 = select(_e1043, _e1028, (_e1028 > _e1043));
                        let _e1158 = select(_e1044, _e1029, (_e1029 > _e1044));
                        let _e1160 = select(_e1045, _e1030, (_e1030 > _e1045));
                        let _e1162 = select(_e1046, _e1031, (_e1031 > _e1046));
                        let _e1164 = select(_e1073, _e1058, (_e1058 > _e1073));
                        let _e1166 = select(_e1074, _e1059, (_e1059 > _e1074));
                        let _e1168 = select(_e1075, _e1060, (_e1060 > _e1075));
                        let _e1170 = select(_e1076, _e1061, (_e1061 > _e1076));
                        let _e1172 = select(_e1164, _e1156, (_e1156 < _e1164));
                        let _e1174 = select(_e1166, _e1158, (_e1158 < _e1166));
                        let _e1176 = select(_e1168, _e1160, (_e1160 < _e1168));
                        let _e1178 = select(_e1170, _e1162, (_e1162 < _e1170));
                        let _e1180 = select(_e1103, _e1088, (_e1088 > _e1103));
                        let _e1182 = select(_e1104, _e1089, (_e1089 > _e1104));
                        let _e1184 = select(_e1105, _e1090, (_e1090 > _e1105));
                        let _e1186 = select(_e1106, _e1091, (_e1091 > _e1106));
                        let _e1188 = select(_e1180, _e1172, (_e1172 < _e1180));
                        let _e1190 = select(_e1182, _e1174, (_e1174 < _e1182));
                        let _e1192 = select(_e1184, _e1176, (_e1176 < _e1184));
                        let _e1194 = select(_e1186, _e1178, (_e1178 < _e1186));
                        let _e1204 = select(340282350000000000000000000000000000000f, _e1148, (_e1148 <= select(_e317.member, _e1188, (_e1188 < _e317.member))));
                        let _e1206 = select(340282350000000000000000000000000000000f, _e1150, (_e1150 <= select(_e317.member, _e1190, (_e1190 < _e317.member))));
                        let _e1208 = select(340282350000000000000000000000000000000f, _e1152, (_e1152 <= select(_e317.member, _e1192, (_e1192 < _e317.member))));
                        let _e1210 = select(340282350000000000000000000000000000000f, _e1154, (_e1154 <= select(_e317.member, _e1194, (_e1194 < _e317.member))));
                        let _e1214 = nodes.member[_e320].member_6[0u];
                        let _e1218 = nodes.member[_e320].member_6[1u];
                        let _e1222 = nodes.member[_e320].member_6[2u];
                        let _e1226 = nodes.member[_e320].member_6[3u];
                        if (_e1206 < _e1204) {
                            phi_911_ = type_45(_e1206, _e1218, _e1204, _e1214);
                        } else {
                            phi_911_ = type_45(_e1204, _e1214, _e1206, _e1218);
                        }
                        let _e1231 = phi_911_;
                        if (_e1210 < _e1208) {
                            phi_922_ = type_45(_e1210, _e1226, _e1208, _e1222);
                        } else {
                            phi_922_ = type_45(_e1208, _e1222, _e1210, _e1226);
                        }
                        let _e1240 = phi_922_;
                        if (_e1240.member < _e1231.member) {
                            phi_933_ = type_45(_e1240.member, _e1240.member_1, _e1231.member, _e1231.member_1);
                        } else {
                            phi_933_ = type_45(_e1231.member, _e1231.member_1, _e1240.member, _e1240.member_1);
                        }
                        let _e1249 = phi_933_;
                        if (_e1240.member_2 < _e1231.member_2) {
                            phi_944_ = type_45(_e1240.member_2, _e1240.member_3, _e1231.member_2, _e1231.member_3);
                        } else {
                            phi_944_ = type_45(_e1231.member_2, _e1231.member_3, _e1240.member_2, _e1240.member_3);
                        }
                        let _e1258 = phi_944_;
                        if (_e1249.member_2 < _e1258.member) {
                            phi_955_ = type_45(_e1249.member_2, _e1249.member_3, _e1258.member, _e1258.member_1);
                        } else {
                            phi_955_ = type_45(_e1258.member, _e1258.member_1, _e1249.member_2, _e1249.member_3);
                        }
                        let _e1267 = phi_955_;
                        if (_e1258.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1273 = (_e315 < 64u);
                            if _e1273 {
                            } else {
                                phi_3525_ = true;
                                phi_3122_ = type_44();
                                break;
                            }
                            local[_e315] = _e1258.member_3;
                            if _e1273 {
                            } else {
                                phi_3525_ = true;
                                phi_3122_ = type_44();
                                break;
                            }
                            local_1[_e315] = _e1258.member_2;
                            phi_977_ = (_e315 + 1u);
                        } else {
                            phi_977_ = _e315;
                        }
                        let _e1278 = phi_977_;
                        if (_e1267.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1280 = (_e1278 < 64u);
                            if _e1280 {
                            } else {
                                phi_3525_ = true;
                                phi_3122_ = type_44();
                                break;
                            }
                            local[_e1278] = _e1267.member_3;
                            if _e1280 {
                            } else {
                                phi_3525_ = true;
                                phi_3122_ = type_44();
                                break;
                            }
                            local_1[_e1278] = _e1267.member_2;
                            phi_995_ = (_e1278 + 1u);
                        } else {
                            phi_995_ = _e1278;
                        }
                        let _e1285 = phi_995_;
                        if (_e1267.member < 340282350000000000000000000000000000000f) {
                            let _e1287 = (_e1285 < 64u);
                            if _e1287 {
                            } else {
                                phi_3525_ = true;
                                phi_3122_ = type_44();
                                break;
                            }
                            local[_e1285] = _e1267.member_1;
                            if _e1287 {
                            } else {
                                phi_3525_ = true;
                                phi_3122_ = type_44();
                                break;
                            }
                            local_1[_e1285] = _e1267.member;
                            phi_1013_ = (_e1285 + 1u);
                        } else {
                            phi_1013_ = _e1285;
                        }
                        let _e1292 = phi_1013_;
                        phi_3461_ = _e311;
                        phi_1849_ = select(0u, _e1249.member_1, (_e1249.member < 340282350000000000000000000000000000000f));
                        phi_1850_ = _e1292;
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
                                    phi_3366_ = true;
                                    break;
                                }
                                if _e229 {
                                } else {
                                    phi_3366_ = true;
                                    break;
                                }
                                let _e351 = triangles.member[_e342.member_1].member[_e226];
                                let _e352 = (_e351 - _e246);
                                if _e229 {
                                } else {
                                    phi_3366_ = true;
                                    break;
                                }
                                let _e356 = triangles.member[_e342.member_1].member_2[_e226];
                                let _e357 = (_e356 - _e246);
                                if _e229 {
                                } else {
                                    phi_3366_ = true;
                                    break;
                                }
                                let _e361 = triangles.member[_e342.member_1].member_4[_e226];
                                let _e362 = (_e361 - _e246);
                                if _e233 {
                                } else {
                                    phi_3366_ = true;
                                    break;
                                }
                                let _e366 = triangles.member[_e342.member_1].member[_e225];
                                let _e369 = ((_e366 - _e242) - (_e236 * _e352));
                                if _e237 {
                                } else {
                                    phi_3366_ = true;
                                    break;
                                }
                                let _e373 = triangles.member[_e342.member_1].member[_e224];
                                let _e376 = ((_e373 - _e244) - (_e240 * _e352));
                                if _e233 {
                                } else {
                                    phi_3366_ = true;
                                    break;
                                }
                                let _e380 = triangles.member[_e342.member_1].member_2[_e225];
                                let _e383 = ((_e380 - _e242) - (_e236 * _e357));
                                if _e237 {
                                } else {
                                    phi_3366_ = true;
                                    break;
                                }
                                let _e387 = triangles.member[_e342.member_1].member_2[_e224];
                                let _e390 = ((_e387 - _e244) - (_e240 * _e357));
                                if _e233 {
                                } else {
                                    phi_3366_ = true;
                                    break;
                                }
                                let _e394 = triangles.member[_e342.member_1].member_4[_e225];
                                let _e397 = ((_e394 - _e242) - (_e236 * _e362));
                                if _e237 {
                                } else {
                                    phi_3366_ = true;
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
                                                phi_3366_ = true;
                                                break;
                                            }
                                            let _e725 = triangles.member[_e342.member_1].member_3;
                                            if ((_e725 & 1u) == 0u) {
                                                phi_1818_ = true;
                                            } else {
                                                if _e347 {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                let _e730 = triangles.member[_e342.member_1].member_1;
                                                let _e731 = (_e730 * 12u);
                                                if ((256u + _e731) < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 257u) < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 258u) < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                let _e738 = (_e731 + 259u);
                                                if (_e738 < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                let _e741 = surfaces.member[_e738];
                                                if ((_e731 + 260u) < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 261u) < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 262u) < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                let _e748 = (_e731 + 263u);
                                                if (_e748 < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                let _e751 = surfaces.member[_e748];
                                                let _e752 = (_e731 + 264u);
                                                if (_e752 < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                let _e755 = surfaces.member[_e752];
                                                let _e756 = bitcast<f32>(_e755);
                                                let _e757 = (_e731 + 265u);
                                                if (_e757 < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                let _e760 = surfaces.member[_e757];
                                                let _e761 = bitcast<f32>(_e760);
                                                if ((_e731 + 266u) < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                if ((_e731 + 267u) < _e101) {
                                                } else {
                                                    phi_3366_ = true;
                                                    break;
                                                }
                                                if (_e741 == 4294967295u) {
                                                    phi_1813_ = (_e756 < _e761);
                                                } else {
                                                    if (_e342.member_1 < _e98) {
                                                    } else {
                                                        phi_3366_ = true;
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
                                                    if (_e827 >= 0f) {
                                                        phi_1562_ = select(true, false, (_e827 <= 1f));
                                                    } else {
                                                        phi_1562_ = true;
                                                    }
                                                    let _e832 = phi_1562_;
                                                    let _e836 = ((select(_e827, 0f, _e832) * f32(_e804)) - 0.5f);
                                                    let _e837 = floor(_e836);
                                                    let _e838 = (_e837 < 0f);
                                                    if _e838 {
                                                        phi_1587_ = 0u;
                                                    } else {
                                                        let _e843 = select(select(u32(_e837), 0u, (_e837 < 0f)), 4294967295u, (_e837 > 4294967000f));
                                                        phi_1587_ = select(_e843, _e810, (_e810 < _e843));
                                                    }
                                                    let _e847 = phi_1587_;
                                                    if _e838 {
                                                        phi_1597_ = 0u;
                                                    } else {
                                                        let _e848 = (_e847 + 1u);
                                                        phi_1597_ = select(_e848, _e810, (_e810 < _e848));
                                                    }
                                                    let _e852 = phi_1597_;
                                                    let _e853 = (_e809 == 0u);
                                                    if _e853 {
                                                        phi_1606_ = select(true, false, _e838);
                                                    } else {
                                                        phi_1606_ = true;
                                                    }
                                                    let _e856 = phi_1606_;
                                                    let _e857 = select(_e810, _e847, _e856);
                                                    if _e853 {
                                                        if _e838 {
                                                            phi_1622_ = true;
                                                        } else {
                                                            phi_1622_ = select(true, false, (_e857 == _e810));
                                                        }
                                                        let _e861 = phi_1622_;
                                                        phi_1623_ = _e861;
                                                    } else {
                                                        phi_1623_ = true;
                                                    }
                                                    let _e863 = phi_1623_;
                                                    let _e864 = select(0u, _e852, _e863);
                                                    let _e865 = (_e836 - _e837);
                                                    let _e868 = ((_e741 >> bitcast<u32>(30u)) & 3u);
                                                    let _e869 = (_e806 - 1u);
                                                    let _e871 = select(1f, 2f, (_e868 == 2u));
                                                    let _e875 = (_e803 - (floor((_e803 / _e871)) * _e871));
                                                    if (_e875 > 1f) {
                                                        phi_1646_ = (_e871 - _e875);
                                                    } else {
                                                        phi_1646_ = _e875;
                                                    }
                                                    let _e879 = phi_1646_;
                                                    if (_e868 == 1u) {
                                                        let _e882 = select(0f, _e803, (_e803 > 0f));
                                                        phi_1661_ = select(1f, _e882, (_e882 < 1f));
                                                    } else {
                                                        phi_1661_ = _e879;
                                                    }
                                                    let _e886 = phi_1661_;
                                                    if (_e886 >= 0f) {
                                                        phi_1671_ = select(true, false, (_e886 <= 1f));
                                                    } else {
                                                        phi_1671_ = true;
                                                    }
                                                    let _e891 = phi_1671_;
                                                    let _e895 = ((select(_e886, 0f, _e891) * f32(_e806)) - 0.5f);
                                                    let _e896 = floor(_e895);
                                                    let _e897 = (_e896 < 0f);
                                                    if _e897 {
                                                        phi_1696_ = 0u;
                                                    } else {
                                                        let _e902 = select(select(u32(_e896), 0u, (_e896 < 0f)), 4294967295u, (_e896 > 4294967000f));
                                                        phi_1696_ = select(_e902, _e869, (_e869 < _e902));
                                                    }
                                                    let _e906 = phi_1696_;
                                                    if _e897 {
                                                        phi_1706_ = 0u;
                                                    } else {
                                                        let _e907 = (_e906 + 1u);
                                                        phi_1706_ = select(_e907, _e869, (_e869 < _e907));
                                                    }
                                                    let _e911 = phi_1706_;
                                                    let _e912 = (_e868 == 0u);
                                                    if _e912 {
                                                        phi_1715_ = select(true, false, _e897);
                                                    } else {
                                                        phi_1715_ = true;
                                                    }
                                                    let _e915 = phi_1715_;
                                                    let _e916 = select(_e869, _e906, _e915);
                                                    if _e912 {
                                                        if _e897 {
                                                            phi_1731_ = true;
                                                        } else {
                                                            phi_1731_ = select(true, false, (_e916 == _e869));
                                                        }
                                                        let _e920 = phi_1731_;
                                                        phi_1732_ = _e920;
                                                    } else {
                                                        phi_1732_ = true;
                                                    }
                                                    let _e922 = phi_1732_;
                                                    let _e924 = (_e895 - _e896);
                                                    let _e925 = (_e741 & 268435455u);
                                                    let _e927 = (_e925 + (_e916 * _e804));
                                                    let _e929 = (_e925 + (select(0u, _e911, _e922) * _e804));
                                                    let _e930 = (_e927 + _e857);
                                                    let _e931 = (_e927 + _e864);
                                                    let _e932 = (_e929 + _e857);
                                                    let _e933 = (_e929 + _e864);
                                                    if (_e930 < _e101) {
                                                    } else {
                                                        phi_3366_ = true;
                                                        break;
                                                    }
                                                    let _e936 = surfaces.member[_e930];
                                                    if (_e931 < _e101) {
                                                    } else {
                                                        phi_3366_ = true;
                                                        break;
                                                    }
                                                    let _e939 = surfaces.member[_e931];
                                                    if (_e932 < _e101) {
                                                    } else {
                                                        phi_3366_ = true;
                                                        break;
                                                    }
                                                    let _e942 = surfaces.member[_e932];
                                                    if (_e933 < _e101) {
                                                    } else {
                                                        phi_3366_ = true;
                                                        break;
                                                    }
                                                    let _e945 = surfaces.member[_e933];
                                                    let _e962 = (1f - _e865);
                                                    phi_1813_ = ((_e756 * (((((f32((_e936 >> bitcast<u32>(24i))) * 0.003921569f) * _e962) + ((f32((_e939 >> bitcast<u32>(24i))) * 0.003921569f) * _e865)) * (1f - _e924)) + ((((f32((_e942 >> bitcast<u32>(24i))) * 0.003921569f) * _e962) + ((f32((_e945 >> bitcast<u32>(24i))) * 0.003921569f) * _e865)) * _e924))) < _e761);
                                                }
                                                let _e977 = phi_1813_;
                                                phi_1818_ = select(true, false, _e977);
                                            }
                                            let _e980 = phi_1818_;
                                            if _e980 {
                                                phi_1823_ = type_44(_e716[0], _e342.member_1, _e716[1], _e716[2]);
                                            } else {
                                                phi_1823_ = type_44();
                                            }
                                            let _e983 = phi_1823_;
                                            phi_1825_ = _e983;
                                            phi_1827_ = select(true, false, _e980);
                                        } else {
                                            phi_1825_ = type_44();
                                            phi_1827_ = false;
                                        }
                                        let _e986 = phi_1825_;
                                        let _e988 = phi_1827_;
                                        phi_1828_ = _e986;
                                        phi_1830_ = select(true, false, _e720);
                                        phi_1831_ = _e988;
                                    } else {
                                        phi_1828_ = type_44();
                                        phi_1830_ = false;
                                        phi_1831_ = false;
                                    }
                                    let _e991 = phi_1828_;
                                    let _e993 = phi_1830_;
                                    let _e995 = phi_1831_;
                                    phi_1832_ = _e991;
                                    phi_1833_ = select(true, false, _e722);
                                    phi_1834_ = _e993;
                                    phi_1835_ = _e995;
                                } else {
                                    phi_1832_ = type_44();
                                    phi_1833_ = true;
                                    phi_1834_ = false;
                                    phi_1835_ = false;
                                }
                                let _e998 = phi_1832_;
                                let _e1000 = phi_1833_;
                                let _e1002 = phi_1834_;
                                let _e1004 = phi_1835_;
                                if select(select(_e1004, false, _e1000), true, select(_e1002, true, _e1000)) {
                                    phi_1848_ = _e327;
                                } else {
                                    phi_1848_ = _e998;
                                }
                                let _e1009 = phi_1848_;
                                phi_1026_ = _e1009;
                            } else {
                                phi_1026_ = type_44();
                            }
                            let _e1011 = phi_1026_;
                            continue;
                            continuing {
                                phi_1022_ = _e340;
                                phi_1025_ = _e1011;
                                phi_3366_ = _e311;
                                break if !(_e346);
                            }
                        }
                        let _e1014 = phi_3366_;
                        phi_3525_ = _e1014;
                        phi_3122_ = type_44();
                        if _e1014 {
                            break;
                        }
                        phi_3461_ = _e1014;
                        phi_1849_ = 0u;
                        phi_1850_ = _e315;
                        let _e2297 = local_7;
                        phi_531_ = _e2297;
                    }
                    let _e1296 = phi_3461_;
                    let _e1298 = phi_1849_;
                    let _e1300 = phi_1850_;
                    let _e1302 = phi_531_;
                    phi_526_ = _e1298;
                    phi_529_ = _e1300;
                    loop {
                        let _e1304 = phi_526_;
                        let _e1306 = phi_529_;
                        local_5 = _e1304;
                        local_6 = _e1306;
                        let _e1307 = (_e1304 == 0u);
                        local_4 = _e1307;
                        if _e1307 {
                            let _e1308 = (_e1306 > 0u);
                            if _e1308 {
                                let _e1309 = (_e1306 - 1u);
                                let _e1310 = (_e1309 < 64u);
                                if _e1310 {
                                } else {
                                    phi_3458_ = true;
                                    break;
                                }
                                let _e1312 = local_1[_e1309];
                                if (_e1312 <= _e1302.member) {
                                    if _e1310 {
                                    } else {
                                        phi_3458_ = true;
                                        break;
                                    }
                                    let _e1316 = local[_e1309];
                                    phi_1885_ = _e1316;
                                } else {
                                    phi_1885_ = _e1304;
                                }
                                let _e1318 = phi_1885_;
                                phi_1886_ = _e1318;
                                phi_1887_ = _e1309;
                            } else {
                                phi_1886_ = u32();
                                phi_1887_ = u32();
                            }
                            let _e1320 = phi_1886_;
                            let _e1322 = phi_1887_;
                            phi_1852_ = _e1320;
                            phi_1854_ = _e1322;
                            phi_1888_ = _e1308;
                        } else {
                            phi_1852_ = u32();
                            phi_1854_ = u32();
                            phi_1888_ = false;
                        }
                        let _e1324 = phi_1852_;
                        let _e1326 = phi_1854_;
                        let _e1328 = phi_1888_;
                        continue;
                        continuing {
                            phi_526_ = _e1324;
                            phi_529_ = _e1326;
                            phi_3458_ = _e1296;
                            break if !(_e1328);
                        }
                    }
                    let _e1331 = phi_3458_;
                    phi_3525_ = _e1331;
                    phi_3122_ = type_44();
                    if _e1331 {
                        break;
                    }
                    let _e1333 = local_4;
                    continue;
                    continuing {
                        phi_3370_ = _e1331;
                        let _e2218 = local_5;
                        phi_525_ = _e2218;
                        let _e2221 = local_6;
                        phi_528_ = _e2221;
                        phi_530_ = _e1302;
                        phi_3525_ = _e1331;
                        phi_3122_ = _e1302;
                        break if !(select(true, false, _e1333));
                    }
                }
                let _e1337 = phi_3525_;
                let _e1339 = phi_3122_;
                if _e1337 {
                    break;
                }
                let _e1341 = (_e1339.member_1 != 4294967295u);
                if _e1341 {
                    if (_e1339.member_1 < _e95) {
                    } else {
                        break;
                    }
                    let _e1345 = triangles.member[_e1339.member_1].member;
                    let _e1351 = triangles.member[_e1339.member_1].member_2;
                    let _e1357 = triangles.member[_e1339.member_1].member_4;
                    let _e1361 = (_e1351[0] - _e1345[0]);
                    let _e1362 = (_e1351[1] - _e1345[1]);
                    let _e1363 = (_e1351[2] - _e1345[2]);
                    let _e1364 = (_e1357[0] - _e1345[0]);
                    let _e1365 = (_e1357[1] - _e1345[1]);
                    let _e1366 = (_e1357[2] - _e1345[2]);
                    let _e1383 = ((_e1362 * _e1366) - (_e1365 * _e1363));
                    let _e1386 = ((_e1363 * _e1364) - (_e1366 * _e1361));
                    let _e1389 = ((_e1361 * _e1365) - (_e1364 * _e1362));
                    let _e1390 = abs(_e1383);
                    let _e1391 = abs(_e1386);
                    let _e1393 = select(_e1391, _e1390, (_e1390 > _e1391));
                    let _e1394 = abs(_e1389);
                    let _e1396 = select(_e1394, _e1393, (_e1393 > _e1394));
                    if (_e1396 > 0.000000000000000000000000000000000000011754944f) {
                        let _e1398 = (_e1396 < 340282350000000000000000000000000000000f);
                        if _e1398 {
                            let _e1399 = (_e1383 / _e1396);
                            let _e1400 = (_e1386 / _e1396);
                            let _e1401 = (_e1389 / _e1396);
                            let _e1407 = sqrt((((_e1399 * _e1399) + (_e1400 * _e1400)) + (_e1401 * _e1401)));
                            phi_1990_ = vec3<f32>((_e1399 / _e1407), (_e1400 / _e1407), (_e1401 / _e1407));
                        } else {
                            phi_1990_ = vec3<f32>();
                        }
                        let _e1413 = phi_1990_;
                        phi_1992_ = _e1413;
                        phi_1993_ = select(true, false, _e1398);
                    } else {
                        phi_1992_ = vec3<f32>();
                        phi_1993_ = true;
                    }
                    let _e1416 = phi_1992_;
                    let _e1418 = phi_1993_;
                    let _e1420 = select(_e1416, vec3<f32>(0f, 1f, 0f), vec3(_e1418));
                    let _e1429 = ((((_e1420.x * _e198.x) + (_e1420.y * _e198.y)) + (_e1420.z * _e198.z)) < 0f);
                    if _e1429 {
                        phi_2014_ = _e1420;
                    } else {
                        phi_2014_ = -(_e1420);
                    }
                    let _e1432 = phi_2014_;
                    if (_e1339.member_1 < _e98) {
                    } else {
                        break;
                    }
                    let _e1436 = triangles.member[_e1339.member_1].member_1;
                    let _e1437 = (_e1436 * 12u);
                    let _e1438 = (256u + _e1437);
                    if (_e1438 < _e101) {
                    } else {
                        break;
                    }
                    let _e1441 = surfaces.member[_e1438];
                    let _e1442 = bitcast<f32>(_e1441);
                    let _e1443 = (_e1437 + 257u);
                    if (_e1443 < _e101) {
                    } else {
                        break;
                    }
                    let _e1446 = surfaces.member[_e1443];
                    let _e1447 = bitcast<f32>(_e1446);
                    let _e1448 = (_e1437 + 258u);
                    if (_e1448 < _e101) {
                    } else {
                        break;
                    }
                    let _e1451 = surfaces.member[_e1448];
                    let _e1452 = bitcast<f32>(_e1451);
                    let _e1453 = (_e1437 + 259u);
                    if (_e1453 < _e101) {
                    } else {
                        break;
                    }
                    let _e1456 = surfaces.member[_e1453];
                    let _e1457 = (_e1437 + 260u);
                    if (_e1457 < _e101) {
                    } else {
                        break;
                    }
                    let _e1460 = surfaces.member[_e1457];
                    let _e1462 = (_e1437 + 261u);
                    if (_e1462 < _e101) {
                    } else {
                        break;
                    }
                    let _e1465 = surfaces.member[_e1462];
                    let _e1467 = (_e1437 + 262u);
                    if (_e1467 < _e101) {
                    } else {
                        break;
                    }
                    let _e1470 = surfaces.member[_e1467];
                    let _e1473 = (_e1437 + 263u);
                    if (_e1473 < _e101) {
                    } else {
                        break;
                    }
                    let _e1476 = surfaces.member[_e1473];
                    let _e1477 = (_e1437 + 264u);
                    if (_e1477 < _e101) {
                    } else {
                        break;
                    }
                    let _e1480 = surfaces.member[_e1477];
                    let _e1481 = bitcast<f32>(_e1480);
                    if ((_e1437 + 265u) < _e101) {
                    } else {
                        break;
                    }
                    if ((_e1437 + 266u) < _e101) {
                    } else {
                        break;
                    }
                    if ((_e1437 + 267u) < _e101) {
                    } else {
                        break;
                    }
                    let _e1489 = ((1f - _e1339.member_2) - _e1339.member_3);
                    let _e1493 = attributes.member[_e1339.member_1].member[0u];
                    let _e1498 = attributes.member[_e1339.member_1].member[2u];
                    let _e1504 = attributes.member[_e1339.member_1].member[4u];
                    let _e1506 = (((_e1493 * _e1489) + (_e1498 * _e1339.member_2)) + (_e1504 * _e1339.member_3));
                    let _e1510 = attributes.member[_e1339.member_1].member[1u];
                    let _e1515 = attributes.member[_e1339.member_1].member[3u];
                    let _e1521 = attributes.member[_e1339.member_1].member[5u];
                    let _e1523 = (((_e1510 * _e1489) + (_e1515 * _e1339.member_2)) + (_e1521 * _e1339.member_3));
                    if (_e1456 == 4294967295u) {
                        phi_2604_ = type_47(vec3<f32>(_e1442, _e1447, _e1452), _e1481);
                    } else {
                        let _e1526 = (_e1476 & 65535u);
                        let _e1528 = (_e1476 >> bitcast<u32>(16i));
                        let _e1531 = ((_e1456 >> bitcast<u32>(28u)) & 3u);
                        let _e1532 = (_e1526 - 1u);
                        let _e1534 = select(1f, 2f, (_e1531 == 2u));
                        let _e1538 = (_e1506 - (floor((_e1506 / _e1534)) * _e1534));
                        if (_e1538 > 1f) {
                            phi_2186_ = (_e1534 - _e1538);
                        } else {
                            phi_2186_ = _e1538;
                        }
                        let _e1542 = phi_2186_;
                        if (_e1531 == 1u) {
                            let _e1545 = select(0f, _e1506, (_e1506 > 0f));
                            phi_2201_ = select(1f, _e1545, (_e1545 < 1f));
                        } else {
                            phi_2201_ = _e1542;
                        }
                        let _e1549 = phi_2201_;
                        if (_e1549 >= 0f) {
                            phi_2211_ = select(true, false, (_e1549 <= 1f));
                        } else {
                            phi_2211_ = true;
                        }
                        let _e1554 = phi_2211_;
                        let _e1558 = ((select(_e1549, 0f, _e1554) * f32(_e1526)) - 0.5f);
                        let _e1559 = floor(_e1558);
                        let _e1560 = (_e1559 < 0f);
                        if _e1560 {
                            phi_2236_ = 0u;
                        } else {
                            let _e1565 = select(select(u32(_e1559), 0u, (_e1559 < 0f)), 4294967295u, (_e1559 > 4294967000f));
                            phi_2236_ = select(_e1565, _e1532, (_e1532 < _e1565));
                        }
                        let _e1569 = phi_2236_;
                        if _e1560 {
                            phi_2246_ = 0u;
                        } else {
                            let _e1570 = (_e1569 + 1u);
                            phi_2246_ = select(_e1570, _e1532, (_e1532 < _e1570));
                        }
                        let _e1574 = phi_2246_;
                        let _e1575 = (_e1531 == 0u);
                        if _e1575 {
                            phi_2255_ = select(true, false, _e1560);
                        } else {
                            phi_2255_ = true;
                        }
                        let _e1578 = phi_2255_;
                        let _e1579 = select(_e1532, _e1569, _e1578);
                        if _e1575 {
                            if _e1560 {
                                phi_2271_ = true;
                            } else {
                                phi_2271_ = select(true, false, (_e1579 == _e1532));
                            }
                            let _e1583 = phi_2271_;
                            phi_2272_ = _e1583;
                        } else {
                            phi_2272_ = true;
                        }
                        let _e1585 = phi_2272_;
                        let _e1586 = select(0u, _e1574, _e1585);
                        let _e1587 = (_e1558 - _e1559);
                        let _e1590 = ((_e1456 >> bitcast<u32>(30u)) & 3u);
                        let _e1591 = (_e1528 - 1u);
                        let _e1593 = select(1f, 2f, (_e1590 == 2u));
                        let _e1597 = (_e1523 - (floor((_e1523 / _e1593)) * _e1593));
                        if (_e1597 > 1f) {
                            phi_2295_ = (_e1593 - _e1597);
                        } else {
                            phi_2295_ = _e1597;
                        }
                        let _e1601 = phi_2295_;
                        if (_e1590 == 1u) {
                            let _e1604 = select(0f, _e1523, (_e1523 > 0f));
                            phi_2310_ = select(1f, _e1604, (_e1604 < 1f));
                        } else {
                            phi_2310_ = _e1601;
                        }
                        let _e1608 = phi_2310_;
                        if (_e1608 >= 0f) {
                            phi_2320_ = select(true, false, (_e1608 <= 1f));
                        } else {
                            phi_2320_ = true;
                        }
                        let _e1613 = phi_2320_;
                        let _e1617 = ((select(_e1608, 0f, _e1613) * f32(_e1528)) - 0.5f);
                        let _e1618 = floor(_e1617);
                        let _e1619 = (_e1618 < 0f);
                        if _e1619 {
                            phi_2345_ = 0u;
                        } else {
                            let _e1624 = select(select(u32(_e1618), 0u, (_e1618 < 0f)), 4294967295u, (_e1618 > 4294967000f));
                            phi_2345_ = select(_e1624, _e1591, (_e1591 < _e1624));
                        }
                        let _e1628 = phi_2345_;
                        if _e1619 {
                            phi_2355_ = 0u;
                        } else {
                            let _e1629 = (_e1628 + 1u);
                            phi_2355_ = select(_e1629, _e1591, (_e1591 < _e1629));
                        }
                        let _e1633 = phi_2355_;
                        let _e1634 = (_e1590 == 0u);
                        if _e1634 {
                            phi_2364_ = select(true, false, _e1619);
                        } else {
                            phi_2364_ = true;
                        }
                        let _e1637 = phi_2364_;
                        let _e1638 = select(_e1591, _e1628, _e1637);
                        if _e1634 {
                            if _e1619 {
                                phi_2380_ = true;
                            } else {
                                phi_2380_ = select(true, false, (_e1638 == _e1591));
                            }
                            let _e1642 = phi_2380_;
                            phi_2381_ = _e1642;
                        } else {
                            phi_2381_ = true;
                        }
                        let _e1644 = phi_2381_;
                        let _e1646 = (_e1617 - _e1618);
                        let _e1647 = (_e1456 & 268435455u);
                        let _e1649 = (_e1647 + (_e1638 * _e1526));
                        let _e1651 = (_e1647 + (select(0u, _e1633, _e1644) * _e1526));
                        let _e1652 = (_e1649 + _e1579);
                        let _e1653 = (_e1649 + _e1586);
                        let _e1654 = (_e1651 + _e1579);
                        let _e1655 = (_e1651 + _e1586);
                        if (_e1652 < _e101) {
                        } else {
                            break;
                        }
                        let _e1658 = surfaces.member[_e1652];
                        if (_e1653 < _e101) {
                        } else {
                            break;
                        }
                        let _e1661 = surfaces.member[_e1653];
                        if (_e1654 < _e101) {
                        } else {
                            break;
                        }
                        let _e1664 = surfaces.member[_e1654];
                        if (_e1655 < _e101) {
                        } else {
                            break;
                        }
                        let _e1667 = surfaces.member[_e1655];
                        let _e1668 = (_e1658 & 255u);
                        if (_e1668 < _e101) {
                        } else {
                            break;
                        }
                        let _e1671 = surfaces.member[_e1668];
                        let _e1675 = ((_e1658 >> bitcast<u32>(8i)) & 255u);
                        if (_e1675 < _e101) {
                        } else {
                            break;
                        }
                        let _e1678 = surfaces.member[_e1675];
                        let _e1682 = ((_e1658 >> bitcast<u32>(16i)) & 255u);
                        if (_e1682 < _e101) {
                        } else {
                            break;
                        }
                        let _e1685 = surfaces.member[_e1682];
                        let _e1687 = (1f - _e1587);
                        let _e1691 = (_e1661 & 255u);
                        if (_e1691 < _e101) {
                        } else {
                            break;
                        }
                        let _e1694 = surfaces.member[_e1691];
                        let _e1698 = ((_e1661 >> bitcast<u32>(8i)) & 255u);
                        if (_e1698 < _e101) {
                        } else {
                            break;
                        }
                        let _e1701 = surfaces.member[_e1698];
                        let _e1705 = ((_e1661 >> bitcast<u32>(16i)) & 255u);
                        if (_e1705 < _e101) {
                        } else {
                            break;
                        }
                        let _e1708 = surfaces.member[_e1705];
                        let _e1716 = (_e1664 & 255u);
                        if (_e1716 < _e101) {
                        } else {
                            break;
                        }
                        let _e1719 = surfaces.member[_e1716];
                        let _e1723 = ((_e1664 >> bitcast<u32>(8i)) & 255u);
                        if (_e1723 < _e101) {
                        } else {
                            break;
                        }
                        let _e1726 = surfaces.member[_e1723];
                        let _e1730 = ((_e1664 >> bitcast<u32>(16i)) & 255u);
                        if (_e1730 < _e101) {
                        } else {
                            break;
                        }
                        let _e1733 = surfaces.member[_e1730];
                        let _e1738 = (_e1667 & 255u);
                        if (_e1738 < _e101) {
                        } else {
                            break;
                        }
                        let _e1741 = surfaces.member[_e1738];
                        let _e1745 = ((_e1667 >> bitcast<u32>(8i)) & 255u);
                        if (_e1745 < _e101) {
                        } else {
                            break;
                        }
                        let _e1748 = surfaces.member[_e1745];
                        let _e1752 = ((_e1667 >> bitcast<u32>(16i)) & 255u);
                        if (_e1752 < _e101) {
                        } else {
                            break;
                        }
                        let _e1755 = surfaces.member[_e1752];
                        let _e1763 = (1f - _e1646);
                        phi_2604_ = type_47(vec3<f32>((_e1442 * ((((bitcast<f32>(_e1671) * _e1687) + (bitcast<f32>(_e1694) * _e1587)) * _e1763) + (((bitcast<f32>(_e1719) * _e1687) + (bitcast<f32>(_e1741) * _e1587)) * _e1646))), (_e1447 * ((((bitcast<f32>(_e1678) * _e1687) + (bitcast<f32>(_e1701) * _e1587)) * _e1763) + (((bitcast<f32>(_e1726) * _e1687) + (bitcast<f32>(_e1748) * _e1587)) * _e1646))), (_e1452 * ((((bitcast<f32>(_e1685) * _e1687) + (bitcast<f32>(_e1708) * _e1587)) * _e1763) + (((bitcast<f32>(_e1733) * _e1687) + (bitcast<f32>(_e1755) * _e1587)) * _e1646)))), (_e1481 * (((((f32((_e1658 >> bitcast<u32>(24i))) * 0.003921569f) * _e1687) + ((f32((_e1661 >> bitcast<u32>(24i))) * 0.003921569f) * _e1587)) * _e1763) + ((((f32((_e1664 >> bitcast<u32>(24i))) * 0.003921569f) * _e1687) + ((f32((_e1667 >> bitcast<u32>(24i))) * 0.003921569f) * _e1587)) * _e1646))));
                    }
                    let _e1806 = phi_2604_;
                    let _e1811 = attributes.member[_e1339.member_1].member_2[0u];
                    let _e1815 = attributes.member[_e1339.member_1].member_2[1u];
                    let _e1820 = attributes.member[_e1339.member_1].member_2[2u];
                    if (((_e1811 | _e1815) | _e1820) == 0u) {
                        phi_2711_ = vec3<f32>(1f, 1f, 1f);
                    } else {
                        let _e1836 = (1f - (f32((_e1811 & 1023u)) * 0.0009775171f));
                        let _e1837 = (1f - (f32(((_e1811 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                        let _e1838 = (1f - (f32(((_e1811 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                        let _e1858 = (1f - (f32((_e1815 & 1023u)) * 0.0009775171f));
                        let _e1859 = (1f - (f32(((_e1815 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                        let _e1860 = (1f - (f32(((_e1815 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                        let _e1883 = (1f - (f32((_e1820 & 1023u)) * 0.0009775171f));
                        let _e1884 = (1f - (f32(((_e1820 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                        let _e1885 = (1f - (f32(((_e1820 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                        phi_2711_ = vec3<f32>(((((_e1836 * _e1836) * _e1489) + ((_e1858 * _e1858) * _e1339.member_2)) + ((_e1883 * _e1883) * _e1339.member_3)), ((((_e1837 * _e1837) * _e1489) + ((_e1859 * _e1859) * _e1339.member_2)) + ((_e1884 * _e1884) * _e1339.member_3)), ((((_e1838 * _e1838) * _e1489) + ((_e1860 * _e1860) * _e1339.member_2)) + ((_e1885 * _e1885) * _e1339.member_3)));
                    }
                    let _e1897 = phi_2711_;
                    let _e1911 = attributes.member[_e1339.member_1].member_1[0u];
                    let _e1921 = (f32((bitcast<i32>((_e1911 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1923 = select(-1f, _e1921, (_e1921 > -1f));
                    let _e1925 = (f32((bitcast<i32>(_e1911) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1927 = select(-1f, _e1925, (_e1925 > -1f));
                    let _e1931 = ((1f - abs(_e1923)) - abs(_e1927));
                    let _e1932 = -(_e1931);
                    let _e1936 = (bitcast<u32>(select(0f, _e1932, (_e1932 > 0f))) & 2147483647u);
                    let _e1941 = (_e1923 - bitcast<f32>((_e1936 | (bitcast<u32>(_e1923) & 2147483648u))));
                    let _e1946 = (_e1927 - bitcast<f32>((_e1936 | (bitcast<u32>(_e1927) & 2147483648u))));
                    let _e1951 = (((_e1941 * _e1941) + (_e1946 * _e1946)) + (_e1931 * _e1931));
                    if (_e1951 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e1954 = (1f / sqrt(_e1951));
                        phi_2786_ = vec3<f32>((_e1941 * _e1954), (_e1946 * _e1954), (_e1931 * _e1954));
                    } else {
                        phi_2786_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e1960 = phi_2786_;
                    let _e1970 = attributes.member[_e1339.member_1].member_1[1u];
                    let _e1980 = (f32((bitcast<i32>((_e1970 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1982 = select(-1f, _e1980, (_e1980 > -1f));
                    let _e1984 = (f32((bitcast<i32>(_e1970) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1986 = select(-1f, _e1984, (_e1984 > -1f));
                    let _e1990 = ((1f - abs(_e1982)) - abs(_e1986));
                    let _e1991 = -(_e1990);
                    let _e1995 = (bitcast<u32>(select(0f, _e1991, (_e1991 > 0f))) & 2147483647u);
                    let _e2000 = (_e1982 - bitcast<f32>((_e1995 | (bitcast<u32>(_e1982) & 2147483648u))));
                    let _e2005 = (_e1986 - bitcast<f32>((_e1995 | (bitcast<u32>(_e1986) & 2147483648u))));
                    let _e2010 = (((_e2000 * _e2000) + (_e2005 * _e2005)) + (_e1990 * _e1990));
                    if (_e2010 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e2013 = (1f / sqrt(_e2010));
                        phi_2860_ = vec3<f32>((_e2000 * _e2013), (_e2005 * _e2013), (_e1990 * _e2013));
                    } else {
                        phi_2860_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e2019 = phi_2860_;
                    let _e2032 = attributes.member[_e1339.member_1].member_1[2u];
                    let _e2042 = (f32((bitcast<i32>((_e2032 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e2044 = select(-1f, _e2042, (_e2042 > -1f));
                    let _e2046 = (f32((bitcast<i32>(_e2032) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e2048 = select(-1f, _e2046, (_e2046 > -1f));
                    let _e2052 = ((1f - abs(_e2044)) - abs(_e2048));
                    let _e2053 = -(_e2052);
                    let _e2057 = (bitcast<u32>(select(0f, _e2053, (_e2053 > 0f))) & 2147483647u);
                    let _e2062 = (_e2044 - bitcast<f32>((_e2057 | (bitcast<u32>(_e2044) & 2147483648u))));
                    let _e2067 = (_e2048 - bitcast<f32>((_e2057 | (bitcast<u32>(_e2048) & 2147483648u))));
                    let _e2072 = (((_e2062 * _e2062) + (_e2067 * _e2067)) + (_e2052 * _e2052));
                    if (_e2072 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e2075 = (1f / sqrt(_e2072));
                        phi_2934_ = vec3<f32>((_e2062 * _e2075), (_e2067 * _e2075), (_e2052 * _e2075));
                    } else {
                        phi_2934_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e2081 = phi_2934_;
                    let _e2088 = (((_e1960.x * _e1489) + (_e2019.x * _e1339.member_2)) + (_e2081.x * _e1339.member_3));
                    let _e2089 = (((_e1960.y * _e1489) + (_e2019.y * _e1339.member_2)) + (_e2081.y * _e1339.member_3));
                    let _e2090 = (((_e1960.z * _e1489) + (_e2019.z * _e1339.member_2)) + (_e2081.z * _e1339.member_3));
                    let _e2091 = abs(_e2088);
                    let _e2092 = abs(_e2089);
                    let _e2094 = select(_e2092, _e2091, (_e2091 > _e2092));
                    let _e2095 = abs(_e2090);
                    let _e2097 = select(_e2095, _e2094, (_e2094 > _e2095));
                    if (_e2097 > 0.000000000000000000000000000000000000011754944f) {
                        let _e2099 = (_e2097 < 340282350000000000000000000000000000000f);
                        if _e2099 {
                            let _e2100 = (_e2088 / _e2097);
                            let _e2101 = (_e2089 / _e2097);
                            let _e2102 = (_e2090 / _e2097);
                            let _e2108 = sqrt((((_e2100 * _e2100) + (_e2101 * _e2101)) + (_e2102 * _e2102)));
                            phi_2979_ = vec3<f32>((_e2100 / _e2108), (_e2101 / _e2108), (_e2102 / _e2108));
                        } else {
                            phi_2979_ = vec3<f32>();
                        }
                        let _e2114 = phi_2979_;
                        phi_2981_ = _e2114;
                        phi_2982_ = select(true, false, _e2099);
                    } else {
                        phi_2981_ = vec3<f32>();
                        phi_2982_ = true;
                    }
                    let _e2117 = phi_2981_;
                    let _e2119 = phi_2982_;
                    let _e2121 = select(_e2117, _e1432, vec3(_e2119));
                    if ((((_e2121.x * _e198.x) + (_e2121.y * _e198.y)) + (_e2121.z * _e198.z)) > 0f) {
                        phi_3003_ = -(_e2121);
                    } else {
                        phi_3003_ = _e2121;
                    }
                    let _e2133 = phi_3003_;
                    if _e1429 {
                        phi_3033_ = array<f32, 3>(bitcast<f32>(_e1460), bitcast<f32>(_e1465), bitcast<f32>(_e1470));
                    } else {
                        phi_3033_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e2153 = phi_3033_;
                    let _e2154 = abs(_e1345[0]);
                    let _e2155 = abs(_e1345[1]);
                    let _e2157 = select(_e2155, _e2154, (_e2154 > _e2155));
                    let _e2158 = abs(_e1345[2]);
                    let _e2162 = abs(_e1361);
                    let _e2163 = abs(_e1362);
                    let _e2165 = select(_e2163, _e2162, (_e2162 > _e2163));
                    let _e2166 = abs(_e1363);
                    let _e2169 = abs(_e1364);
                    let _e2170 = abs(_e1365);
                    let _e2172 = select(_e2170, _e2169, (_e2169 > _e2170));
                    let _e2173 = abs(_e1366);
                    phi_3079_ = type_48(array<f32, 3>(((_e1345[0] + (_e1361 * _e1339.member_2)) + (_e1364 * _e1339.member_3)), ((_e1345[1] + (_e1362 * _e1339.member_2)) + (_e1365 * _e1339.member_3)), ((_e1345[2] + (_e1363 * _e1339.member_2)) + (_e1366 * _e1339.member_3))), _e1339.member_1, array<f32, 3>(_e2133.x, _e2133.y, _e2133.z), (_e1339.member * sqrt((((_e198.x * _e198.x) + (_e198.y * _e198.y)) + (_e198.z * _e198.z)))), array<f32, 3>(_e1432.x, _e1432.y, _e1432.z), select(0u, 1u, _e1429), array<f32, 3>((_e1806.member.x * _e1897.x), (_e1806.member.y * _e1897.y), (_e1806.member.z * _e1897.z)), _e1436, _e2153, ((select(_e2158, _e2157, (_e2157 > _e2158)) * 0.00000047683716f) + ((select(_e2166, _e2165, (_e2165 > _e2166)) + select(_e2173, _e2172, (_e2172 > _e2173))) * 0.0000010728836f)));
                } else {
                    phi_3079_ = type_48(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0f);
                }
                let _e2181 = phi_3079_;
                if _e1341 {
                    phi_3092_ = _e2181;
                } else {
                    let _e2184 = params.member.member_4;
                    phi_3092_ = type_48(_e2181.member, _e2181.member_1, _e2181.member_2, _e2181.member_3, _e2181.member_4, _e2181.member_5, _e2181.member_6, _e2181.member_7, array<f32, 3>(_e2184.x, _e2184.y, _e2184.z), _e2181.member_9);
                }
                let _e2201 = phi_3092_;
                if (_e114 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                surfels.member[_e114] = _e2201;
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
