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
    var phi_309_: vec3<f32>;
    var phi_311_: vec3<f32>;
    var phi_312_: bool;
    var phi_337_: bool;
    var phi_347_: u32;
    var phi_350_: bool;
    var phi_361_: u32;
    var phi_497_: f32;
    var phi_505_: f32;
    var phi_513_: f32;
    var phi_2954_: bool;
    var phi_516_: u32;
    var phi_519_: u32;
    var phi_521_: type_44;
    var phi_1013_: type_12;
    var phi_1016_: type_44;
    var phi_1014_: type_12;
    var phi_1039_: type_12;
    var phi_1155_: f32;
    var phi_1166_: f32;
    var phi_1177_: f32;
    var phi_1192_: f32;
    var phi_1193_: f32;
    var phi_1194_: bool;
    var phi_1195_: f32;
    var phi_1196_: bool;
    var phi_1215_: f32;
    var phi_1216_: bool;
    var phi_1217_: f32;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1224_: f32;
    var phi_1225_: bool;
    var phi_1311_: array<f32, 3>;
    var phi_1312_: array<f32, 3>;
    var phi_1313_: array<f32, 3>;
    var phi_1314_: array<f32, 3>;
    var phi_1315_: bool;
    var phi_1316_: array<f32, 3>;
    var phi_1317_: array<f32, 3>;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1324_: array<f32, 3>;
    var phi_1329_: array<f32, 3>;
    var phi_1540_: u32;
    var phi_1546_: u32;
    var phi_1576_: u32;
    var phi_1582_: u32;
    var phi_1657_: bool;
    var phi_1662_: bool;
    var phi_1667_: type_44;
    var phi_1669_: type_44;
    var phi_1671_: bool;
    var phi_1672_: type_44;
    var phi_1674_: bool;
    var phi_1675_: bool;
    var phi_1676_: type_44;
    var phi_1677_: bool;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1692_: type_44;
    var phi_1017_: type_44;
    var phi_2950_: bool;
    var phi_902_: type_45;
    var phi_913_: type_45;
    var phi_924_: type_45;
    var phi_935_: type_45;
    var phi_946_: type_45;
    var phi_968_: u32;
    var phi_986_: u32;
    var phi_1004_: u32;
    var phi_3015_: bool;
    var phi_1693_: u32;
    var phi_1694_: u32;
    var phi_522_: type_44;
    var phi_517_: u32;
    var phi_520_: u32;
    var phi_1729_: u32;
    var phi_1730_: u32;
    var phi_1731_: u32;
    var phi_1696_: u32;
    var phi_1698_: u32;
    var phi_1732_: bool;
    var phi_3012_: bool;
    var local_4: bool;
    var phi_3079_: bool;
    var phi_2706_: type_44;
    var phi_1834_: vec3<f32>;
    var phi_1836_: vec3<f32>;
    var phi_1837_: bool;
    var phi_1858_: vec3<f32>;
    var phi_2042_: u32;
    var phi_2048_: u32;
    var phi_2078_: u32;
    var phi_2084_: u32;
    var phi_2301_: type_47;
    var phi_2367_: vec3<f32>;
    var phi_2441_: vec3<f32>;
    var phi_2515_: vec3<f32>;
    var phi_2560_: vec3<f32>;
    var phi_2562_: vec3<f32>;
    var phi_2563_: bool;
    var phi_2584_: vec3<f32>;
    var phi_2617_: array<f32, 3>;
    var phi_2663_: type_48;
    var phi_2676_: type_48;
    var local_5: u32;
    var local_6: u32;
    var local_7: type_44;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = gid_1;
            let _e83 = arrayLength((&nodes.member));
            let _e86 = arrayLength((&triangles.member));
            let _e89 = arrayLength((&attributes.member));
            let _e92 = arrayLength((&surfaces.member));
            let _e97 = params.member.member_5;
            let _e100 = params.member.member_6;
            let _e105 = (_e80.x + (_e80.y * 2097152u));
            if (_e105 < (_e97 * _e100)) {
                if (_e97 == 0u) {
                    break;
                }
                let _e108 = (_e105 / _e97);
                let _e116 = ((f32(((2u * (_e105 - (_e108 * _e97))) + 1u)) / f32(_e97)) - 1f);
                let _e122 = (1f - (f32(((2u * _e108) + 1u)) / f32(_e100)));
                let _e125 = params.member.member_1;
                let _e131 = params.member.member_2;
                let _e143 = params.member.member_3;
                let _e150 = ((_e125.x + (_e131.x * _e116)) + (_e143.x * _e122));
                let _e151 = ((_e125.y + (_e131.y * _e116)) + (_e143.y * _e122));
                let _e152 = ((_e125.z + (_e131.z * _e116)) + (_e143.z * _e122));
                let _e155 = params.member.member;
                let _e159 = abs(_e150);
                let _e160 = abs(_e151);
                let _e162 = select(_e160, _e159, (_e159 > _e160));
                let _e163 = abs(_e152);
                let _e165 = select(_e163, _e162, (_e162 > _e163));
                if (_e165 > 0.000000000000000000000000000000000000011754944f) {
                    let _e167 = (_e165 < 340282350000000000000000000000000000000f);
                    if _e167 {
                        let _e168 = (_e150 / _e165);
                        let _e169 = (_e151 / _e165);
                        let _e170 = (_e152 / _e165);
                        let _e176 = sqrt((((_e168 * _e168) + (_e169 * _e169)) + (_e170 * _e170)));
                        phi_309_ = vec3<f32>((_e168 / _e176), (_e169 / _e176), (_e170 / _e176));
                    } else {
                        phi_309_ = vec3<f32>();
                    }
                    let _e182 = phi_309_;
                    phi_311_ = _e182;
                    phi_312_ = select(true, false, _e167);
                } else {
                    phi_311_ = vec3<f32>();
                    phi_312_ = true;
                }
                let _e185 = phi_311_;
                let _e187 = phi_312_;
                let _e189 = select(_e185, vec3<f32>(0f, 0f, 1f), vec3(_e187));
                let _e191 = abs(_e189.x);
                let _e193 = abs(_e189.y);
                let _e195 = abs(_e189.z);
                let _e196 = (_e191 > _e193);
                if _e196 {
                    phi_337_ = (_e191 > _e195);
                } else {
                    phi_337_ = (_e193 > _e195);
                }
                let _e200 = phi_337_;
                let _e201 = select(1u, 0u, _e196);
                if _e200 {
                    let _e202 = (_e201 + 1u);
                    phi_347_ = _e202;
                    phi_350_ = select(true, false, (_e202 == 2u));
                } else {
                    phi_347_ = u32();
                    phi_350_ = false;
                }
                let _e206 = phi_347_;
                let _e208 = phi_350_;
                let _e209 = select(true, false, _e200);
                let _e210 = select(_e206, 0u, _e209);
                let _e212 = select(_e208, true, _e209);
                if _e212 {
                    phi_361_ = (_e210 + 1u);
                } else {
                    phi_361_ = 0u;
                }
                let _e215 = phi_361_;
                let _e216 = select(_e206, _e210, _e212);
                let _e217 = select(_e201, select(_e201, 2u, _e209), _e212);
                local_2 = array<f32, 3>(_e189.x, _e189.y, _e189.z);
                local_3 = array<f32, 3>(_e155.x, _e155.y, _e155.z);
                let _e220 = (_e217 < 3u);
                if _e220 {
                } else {
                    break;
                }
                let _e222 = local_2[_e217];
                let _e223 = (1f / _e222);
                let _e224 = (_e216 < 3u);
                if _e224 {
                } else {
                    break;
                }
                let _e226 = local_2[_e216];
                let _e227 = (_e226 * _e223);
                let _e228 = (_e215 < 3u);
                if _e228 {
                } else {
                    break;
                }
                let _e230 = local_2[_e215];
                let _e231 = (_e230 * _e223);
                if _e224 {
                } else {
                    break;
                }
                let _e233 = local_3[_e216];
                if _e228 {
                } else {
                    break;
                }
                let _e235 = local_3[_e215];
                if _e220 {
                } else {
                    break;
                }
                let _e237 = local_3[_e217];
                if (0u < _e83) {
                } else {
                    break;
                }
                let _e242 = nodes.member[0u].member_7[0u];
                let _e246 = nodes.member[0u].member_7[1u];
                let _e250 = nodes.member[0u].member_7[2u];
                let _e254 = nodes.member[0u].member_7[3u];
                let _e256 = abs((_e155.x - _e242));
                let _e258 = abs((_e155.y - _e246));
                let _e260 = select(_e258, _e256, (_e256 > _e258));
                let _e262 = abs((_e155.z - _e250));
                let _e266 = ((select(_e262, _e260, (_e260 > _e262)) + _e254) * 0.0000009536743f);
                let _e273 = (_e266 + (abs(_e155.x) * 0.00000023841858f));
                let _e274 = (_e266 + (abs(_e155.y) * 0.00000023841858f));
                let _e275 = (_e266 + (abs(_e155.z) * 0.00000023841858f));
                let _e276 = select(_e193, _e191, _e196);
                let _e278 = select(_e195, _e276, (_e276 > _e195));
                let _e279 = (_e278 * 0.000000000001f);
                let _e280 = (_e155.x + _e273);
                let _e281 = (_e155.y + _e274);
                let _e282 = (_e155.z + _e275);
                let _e283 = (_e155.x - _e273);
                let _e284 = (_e155.y - _e274);
                let _e285 = (_e155.z - _e275);
                if (_e191 > _e279) {
                    phi_497_ = (1f / _e189.x);
                } else {
                    phi_497_ = (1000000000000f / _e278);
                }
                let _e290 = phi_497_;
                if (_e193 > _e279) {
                    phi_505_ = (1f / _e189.y);
                } else {
                    phi_505_ = (1000000000000f / _e278);
                }
                let _e295 = phi_505_;
                if (_e195 > _e279) {
                    phi_513_ = (1f / _e189.z);
                } else {
                    phi_513_ = (1000000000000f / _e278);
                }
                let _e300 = phi_513_;
                local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                local_1 = array<f32, 64>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                phi_2954_ = false;
                phi_516_ = 0u;
                phi_519_ = 0u;
                phi_521_ = type_44(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                loop {
                    let _e302 = phi_2954_;
                    let _e304 = phi_516_;
                    let _e306 = phi_519_;
                    let _e308 = phi_521_;
                    let _e309 = (_e304 & 15u);
                    let _e311 = (_e304 >> bitcast<u32>(4u));
                    if (_e309 == 0u) {
                        if (_e311 < _e83) {
                        } else {
                            phi_3079_ = true;
                            phi_2706_ = type_44();
                            break;
                        }
                        let _e939 = nodes.member[_e311].member;
                        let _e948 = ((_e939.x - _e280) * _e290);
                        let _e949 = ((_e939.y - _e280) * _e290);
                        let _e950 = ((_e939.z - _e280) * _e290);
                        let _e951 = ((_e939.w - _e280) * _e290);
                        let _e954 = nodes.member[_e311].member_3;
                        let _e963 = ((_e954.x - _e283) * _e290);
                        let _e964 = ((_e954.y - _e283) * _e290);
                        let _e965 = ((_e954.z - _e283) * _e290);
                        let _e966 = ((_e954.w - _e283) * _e290);
                        let _e969 = nodes.member[_e311].member_1;
                        let _e978 = ((_e969.x - _e281) * _e295);
                        let _e979 = ((_e969.y - _e281) * _e295);
                        let _e980 = ((_e969.z - _e281) * _e295);
                        let _e981 = ((_e969.w - _e281) * _e295);
                        let _e984 = nodes.member[_e311].member_4;
                        let _e993 = ((_e984.x - _e284) * _e295);
                        let _e994 = ((_e984.y - _e284) * _e295);
                        let _e995 = ((_e984.z - _e284) * _e295);
                        let _e996 = ((_e984.w - _e284) * _e295);
                        let _e999 = nodes.member[_e311].member_2;
                        let _e1008 = ((_e999.x - _e282) * _e300);
                        let _e1009 = ((_e999.y - _e282) * _e300);
                        let _e1010 = ((_e999.z - _e282) * _e300);
                        let _e1011 = ((_e999.w - _e282) * _e300);
                        let _e1014 = nodes.member[_e311].member_5;
                        let _e1023 = ((_e1014.x - _e285) * _e300);
                        let _e1024 = ((_e1014.y - _e285) * _e300);
                        let _e1025 = ((_e1014.z - _e285) * _e300);
                        let _e1026 = ((_e1014.w - _e285) * _e300);
                        let _e1028 = select(_e963, _e948, (_e948 < _e963));
                        let _e1030 = select(_e964, _e949, (_e949 < _e964));
                        let _e1032 = select(_e965, _e950, (_e950 < _e965));
                        let _e1034 = select(_e966, _e951, (_e951 < _e966));
                        let _e1036 = select(_e993, _e978, (_e978 < _e993));
                        let _e1038 = select(_e994, _e979, (_e979 < _e994));
                        let _e1040 = select(_e995, _e980, (_e980 < _e995));
                        let _e1042 = select(_e996, _e981, (_e981 < _e996));
                        let _e1044 = select(_e1036, _e1028, (_e1028 > _e1036));
                        let _e1046 = select(_e1038, _e1030, (_e1030 > _e1038));
                        let _e1048 = select(_e1040, _e1032, (_e1032 > _e1040));
                        let _e1050 = select(_e1042, _e1034, (_e1034 > _e1042));
                        let _e1052 = select(_e1023, _e1008, (_e1008 < _e1023));
                        let _e1054 = select(_e1024, _e1009, (_e1009 < _e1024));
                        let _e1056 = select(_e1025, _e1010, (_e1010 < _e1025));
                        let _e1058 = select(_e1026, _e1011, (_e1011 < _e1026));
                        let _e1060 = select(_e1052, _e1044, (_e1044 > _e1052));
                        let _e1062 = select(_e1054, _e1046, (_e1046 > _e1054));
                        let _e1064 = select(_e1056, _e1048, (_e1048 > _e1056));
                        let _e1066 = select(_e1058, _e1050, (_e1050 > _e1058));
                        let _e1068 = select(0f, _e1060, (_e1060 > 0f));
                        let _e1070 = select(0f, _e1062, (_e1062 > 0f));
                        let _e1072 = select(0f, _e1064, (_e1064 > 0f));
                        let _e1074 = select(0f, _e1066, (_e1066 > 0f));
                        let _e1076 = select(_e963, _e948, (_e948 > _e963));
                        let _e1078 = select(_e964, _e949, (_e949 > _e964));
                        let _e1080 = select(_e965, _e950, (_e950 > _e965));
                        let _e1082 = select(_e966, _e951, (_e951 > _e966));
                        let _e1084 = select(_e993, _e978, (_e978 > _e993));
                        let _e1086 = select(_e994, _e979, (_e979 > _e994));
                        let _e1088 = select(_e995, _e980, (_e980 > _e995));
                        let _e1090 = select(_e996, _e981, (_e981 > _e996));
                        let _e1092 = select(_e1084, _e1076, (_e1076 < _e1084));
                        let _e1094 = select(_e1086, _e1078, (_e1078 < _e1086));
                        let _e1096 = select(_e1088, _e1080, (_e1080 < _e1088));
                        let _e1098 = select(_e1090, _e1082, (_e1082 < _e1090));
                        let _e1100 = select(_e1023, _e1008, (_e1008 > _e1023));
                        let _e1102 = select(_e1024, _e1009, (_e1009 > _e1024));
                        let _e1104 = select(_e1025, _e1010, (_e1010 > _e1025));
                        let _e1106 = select(_e1026, _e1011, (_e1011 > _e1026));
                        let _e1108 = select(_e1100, _e1092, (_e1092 < _e1100));
                        let _e1110 = select(_e1102, _e1094, (_e1094 < _e1102));
                        let _e1112 = select(_e1104, _e1096, (_e1096 < _e1104));
                        let _e1114 = select(_e1106, _e1098, (_e1098 < _e1106));
                        let _e1124 = select(340282350000000000000000000000000000000f, _e1068, (_e1068 <= select(_e308.member, _e1108, (_e1108 < _e308.member))));
                        let _e1126 = select(340282350000000000000000000000000000000f, _e1070, (_e1070 <= select(_e308.member, _e1110, (_e1110 < _e308.member))));
                        let _e1128 = select(340282350000000000000000000000000000000f, _e1072, (_e1072 <= select(_e308.member, _e1112, (_e1112 < _e308.member))));
                        let _e1130 = select(340282350000000000000000000000000000000f, _e1074, (_e1074 <= select(_e308.member, _e1114, (_e1114 < _e308.member))));
                        let _e1134 = nodes.member[_e311].member_6[0u];
                        let _e1138 = nodes.member[_e311].member_6[1u];
                        let _e1142 = nodes.member[_e311].member_6[2u];
                        let _e1146 = nodes.member[_e311].member_6[3u];
                        if (_e1126 < _e1124) {
                            phi_902_ = type_45(_e1126, _e1138, _e1124, _e1134);
                        } else {
                            phi_902_ = type_45(_e1124, _e1134, _e1126, _e1138);
                        }
                        let _e1151 = phi_902_;
                        if (_e1130 < _e1128) {
                            phi_913_ = type_45(_e1130, _e1146, _e1128, _e1142);
                        } else {
                            phi_913_ = type_45(_e1128, _e1142, _e1130, _e1146);
                        }
                        let _e1160 = phi_913_;
                        if (_e1160.member < _e1151.member) {
                            phi_924_ = type_45(_e1160.member, _e1160.member_1, _e1151.member, _e1151.member_1);
                        } else {
                            phi_924_ = type_45(_e1151.member, _e1151.member_1, _e1160.member, _e1160.member_1);
                        }
                        let _e1169 = phi_924_;
                        if (_e1160.member_2 < _e1151.member_2) {
                            phi_935_ = type_45(_e1160.member_2, _e1160.member_3, _e1151.member_2, _e1151.member_3);
                        } else {
                            phi_935_ = type_45(_e1151.member_2, _e1151.member_3, _e1160.member_2, _e1160.member_3);
                        }
                        let _e1178 = phi_935_;
                        if (_e1169.member_2 < _e1178.member) {
                            phi_946_ = type_45(_e1169.member_2, _e1169.member_3, _e1178.member, _e1178.member_1);
                        } else {
                            phi_946_ = type_45(_e1178.member, _e1178.member_1, _e1169.member_2, _e1169.member_3);
                        }
                        let _e1187 = phi_946_;
                        if (_e1178.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1193 = (_e306 < 64u);
                            if _e1193 {
                            } else {
                                phi_3079_ = true;
                                phi_2706_ = type_44();
                                break;
                            }
                            local[_e306] = _e1178.member_3;
                            if _e1193 {
                            } else {
                                phi_3079_ = true;
                                phi_2706_ = type_44();
                                break;
                            }
                            local_1[_e306] = _e1178.member_2;
                            phi_968_ = (_e306 + 1u);
                        } else {
                            phi_968_ = _e306;
                        }
                        let _e1198 = phi_968_;
                        if (_e1187.member_2 < 340282350000000000000000000000000000000f) {
                            let _e1200 = (_e1198 < 64u);
                            if _e1200 {
                            } else {
                                phi_3079_ = true;
                                phi_2706_ = type_44();
                                break;
                            }
                            local[_e1198] = _e1187.member_3;
                            if _e1200 {
                            } else {
                                phi_3079_ = true;
                                phi_2706_ = type_44();
                                break;
                            }
                            local_1[_e1198] = _e1187.member_2;
                            phi_986_ = (_e1198 + 1u);
                        } else {
                            phi_986_ = _e1198;
                        }
                        let _e1205 = phi_986_;
                        if (_e1187.member < 340282350000000000000000000000000000000f) {
                            let _e1207 = (_e1205 < 64u);
                            if _e1207 {
                            } else {
                                phi_3079_ = true;
                                phi_2706_ = type_44();
                                break;
                            }
                            local[_e1205] = _e1187.member_1;
                            if _e1207 {
                            } else {
                                phi_3079_ = true;
                                phi_2706_ = type_44();
                                break;
                            }
                            local_1[_e1205] = _e1187.member;
                            phi_1004_ = (_e1205 + 1u);
                        } else {
                            phi_1004_ = _e1205;
                        }
                        let _e1212 = phi_1004_;
                        phi_3015_ = _e302;
                        phi_1693_ = select(0u, _e1169.member_1, (_e1169.member < 340282350000000000000000000000000000000f));
                        phi_1694_ = _e1212;
                        phi_522_ = _e308;
                    } else {
                        phi_1013_ = type_12(_e311, (_e311 + _e309));
                        phi_1016_ = _e308;
                        loop {
                            let _e316 = phi_1013_;
                            let _e318 = phi_1016_;
                            local_7 = _e318;
                            if (_e316.member < _e316.member_1) {
                                phi_1014_ = type_12((_e316.member + 1u), _e316.member_1);
                                phi_1039_ = type_12(1u, _e316.member);
                            } else {
                                phi_1014_ = _e316;
                                phi_1039_ = type_12(0u, type_12().member_1);
                            }
                            let _e331 = phi_1014_;
                            let _e333 = phi_1039_;
                            let _e337 = (bitcast<i32>(_e333.member) != 0i);
                            if _e337 {
                                let _e338 = (_e333.member_1 < _e86);
                                if _e338 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                if _e220 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                let _e342 = triangles.member[_e333.member_1].member[_e217];
                                let _e343 = (_e342 - _e237);
                                if _e220 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                let _e347 = triangles.member[_e333.member_1].member_2[_e217];
                                let _e348 = (_e347 - _e237);
                                if _e220 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                let _e352 = triangles.member[_e333.member_1].member_4[_e217];
                                let _e353 = (_e352 - _e237);
                                if _e224 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                let _e357 = triangles.member[_e333.member_1].member[_e216];
                                let _e360 = ((_e357 - _e233) - (_e227 * _e343));
                                if _e228 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                let _e364 = triangles.member[_e333.member_1].member[_e215];
                                let _e367 = ((_e364 - _e235) - (_e231 * _e343));
                                if _e224 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                let _e371 = triangles.member[_e333.member_1].member_2[_e216];
                                let _e374 = ((_e371 - _e233) - (_e227 * _e348));
                                if _e228 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                let _e378 = triangles.member[_e333.member_1].member_2[_e215];
                                let _e381 = ((_e378 - _e235) - (_e231 * _e348));
                                if _e224 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                let _e385 = triangles.member[_e333.member_1].member_4[_e216];
                                let _e388 = ((_e385 - _e233) - (_e227 * _e353));
                                if _e228 {
                                } else {
                                    phi_2950_ = true;
                                    break;
                                }
                                let _e392 = triangles.member[_e333.member_1].member_4[_e215];
                                let _e395 = ((_e392 - _e235) - (_e231 * _e353));
                                let _e396 = (_e388 * _e381);
                                let _e397 = (_e395 * _e374);
                                if (_e396 != _e397) {
                                    phi_1155_ = (_e396 - _e397);
                                } else {
                                    let _e399 = (_e388 * 4097f);
                                    let _e401 = (_e399 - (_e399 - _e388));
                                    let _e402 = (_e381 * 4097f);
                                    let _e404 = (_e402 - (_e402 - _e381));
                                    let _e405 = (_e388 - _e401);
                                    let _e406 = (_e381 - _e404);
                                    let _e415 = (_e395 * 4097f);
                                    let _e417 = (_e415 - (_e415 - _e395));
                                    let _e418 = (_e374 * 4097f);
                                    let _e420 = (_e418 - (_e418 - _e374));
                                    let _e421 = (_e395 - _e417);
                                    let _e422 = (_e374 - _e420);
                                    phi_1155_ = ((((((_e401 * _e404) - _e396) + (_e401 * _e406)) + (_e405 * _e404)) + (_e405 * _e406)) - (((((_e417 * _e420) - _e397) + (_e417 * _e422)) + (_e421 * _e420)) + (_e421 * _e422)));
                                }
                                let _e434 = phi_1155_;
                                let _e435 = (_e360 * _e395);
                                let _e436 = (_e367 * _e388);
                                if (_e435 != _e436) {
                                    phi_1166_ = (_e435 - _e436);
                                } else {
                                    let _e438 = (_e360 * 4097f);
                                    let _e440 = (_e438 - (_e438 - _e360));
                                    let _e441 = (_e395 * 4097f);
                                    let _e443 = (_e441 - (_e441 - _e395));
                                    let _e444 = (_e360 - _e440);
                                    let _e445 = (_e395 - _e443);
                                    let _e454 = (_e367 * 4097f);
                                    let _e456 = (_e454 - (_e454 - _e367));
                                    let _e457 = (_e388 * 4097f);
                                    let _e459 = (_e457 - (_e457 - _e388));
                                    let _e460 = (_e367 - _e456);
                                    let _e461 = (_e388 - _e459);
                                    phi_1166_ = ((((((_e440 * _e443) - _e435) + (_e440 * _e445)) + (_e444 * _e443)) + (_e444 * _e445)) - (((((_e456 * _e459) - _e436) + (_e456 * _e461)) + (_e460 * _e459)) + (_e460 * _e461)));
                                }
                                let _e473 = phi_1166_;
                                let _e474 = (_e374 * _e367);
                                let _e475 = (_e381 * _e360);
                                if (_e474 != _e475) {
                                    phi_1177_ = (_e474 - _e475);
                                } else {
                                    let _e477 = (_e374 * 4097f);
                                    let _e479 = (_e477 - (_e477 - _e374));
                                    let _e480 = (_e367 * 4097f);
                                    let _e482 = (_e480 - (_e480 - _e367));
                                    let _e483 = (_e374 - _e479);
                                    let _e484 = (_e367 - _e482);
                                    let _e493 = (_e381 * 4097f);
                                    let _e495 = (_e493 - (_e493 - _e381));
                                    let _e496 = (_e360 * 4097f);
                                    let _e498 = (_e496 - (_e496 - _e360));
                                    let _e499 = (_e381 - _e495);
                                    let _e500 = (_e360 - _e498);
                                    phi_1177_ = ((((((_e479 * _e482) - _e474) + (_e479 * _e484)) + (_e483 * _e482)) + (_e483 * _e484)) - (((((_e495 * _e498) - _e475) + (_e495 * _e500)) + (_e499 * _e498)) + (_e499 * _e500)));
                                }
                                let _e512 = phi_1177_;
                                if (_e434 < 0f) {
                                    phi_1195_ = f32();
                                    phi_1196_ = true;
                                } else {
                                    if (_e473 < 0f) {
                                        phi_1193_ = f32();
                                        phi_1194_ = true;
                                    } else {
                                        let _e515 = (_e512 < 0f);
                                        if _e515 {
                                            phi_1192_ = f32();
                                        } else {
                                            phi_1192_ = ((_e434 + _e473) + _e512);
                                        }
                                        let _e519 = phi_1192_;
                                        phi_1193_ = _e519;
                                        phi_1194_ = _e515;
                                    }
                                    let _e521 = phi_1193_;
                                    let _e523 = phi_1194_;
                                    phi_1195_ = _e521;
                                    phi_1196_ = _e523;
                                }
                                let _e525 = phi_1195_;
                                let _e527 = phi_1196_;
                                if _e527 {
                                    if (_e434 > 0f) {
                                        phi_1217_ = f32();
                                        phi_1218_ = true;
                                        phi_1219_ = false;
                                    } else {
                                        let _e529 = (_e473 > 0f);
                                        if _e529 {
                                            phi_1215_ = f32();
                                            phi_1216_ = false;
                                        } else {
                                            phi_1215_ = ((_e434 + _e473) + _e512);
                                            phi_1216_ = select(true, false, (_e512 > 0f));
                                        }
                                        let _e535 = phi_1215_;
                                        let _e537 = phi_1216_;
                                        phi_1217_ = _e535;
                                        phi_1218_ = _e529;
                                        phi_1219_ = _e537;
                                    }
                                    let _e539 = phi_1217_;
                                    let _e541 = phi_1218_;
                                    let _e543 = phi_1219_;
                                    phi_1224_ = _e539;
                                    phi_1225_ = select(_e543, false, _e541);
                                } else {
                                    phi_1224_ = _e525;
                                    phi_1225_ = true;
                                }
                                let _e546 = phi_1224_;
                                let _e548 = phi_1225_;
                                if _e548 {
                                    let _e549 = (_e546 == 0f);
                                    if _e549 {
                                        phi_1313_ = array<f32, 3>();
                                        phi_1314_ = array<f32, 3>();
                                        phi_1315_ = false;
                                    } else {
                                        let _e550 = (_e343 * _e223);
                                        let _e551 = (_e348 * _e223);
                                        let _e552 = (_e353 * _e223);
                                        let _e555 = (1f / ((_e434 + _e473) + _e512));
                                        let _e556 = (_e473 * _e555);
                                        let _e557 = (_e512 * _e555);
                                        let _e563 = ((((_e434 * _e555) * _e550) + (_e556 * _e551)) + (_e557 * _e552));
                                        let _e564 = abs(_e360);
                                        let _e565 = abs(_e374);
                                        let _e567 = select(_e565, _e564, (_e564 > _e565));
                                        let _e568 = abs(_e388);
                                        let _e571 = abs(_e367);
                                        let _e572 = abs(_e381);
                                        let _e574 = select(_e572, _e571, (_e571 > _e572));
                                        let _e575 = abs(_e395);
                                        let _e579 = abs(_e550);
                                        let _e580 = abs(_e551);
                                        let _e582 = select(_e580, _e579, (_e579 > _e580));
                                        let _e583 = abs(_e552);
                                        let _e590 = (((select(_e568, _e567, (_e567 > _e568)) * select(_e575, _e574, (_e574 > _e575))) * select(_e583, _e582, (_e582 > _e583))) <= (abs((_e546 * _e563)) * 256f));
                                        if _e590 {
                                            phi_1311_ = array<f32, 3>(_e563, _e556, _e557);
                                            phi_1312_ = array<f32, 3>();
                                        } else {
                                            let _e592 = (_e388 * 4097f);
                                            let _e594 = (_e592 - (_e592 - _e388));
                                            let _e595 = (_e381 * 4097f);
                                            let _e597 = (_e595 - (_e595 - _e381));
                                            let _e598 = (_e388 - _e594);
                                            let _e599 = (_e381 - _e597);
                                            let _e608 = (_e395 * 4097f);
                                            let _e610 = (_e608 - (_e608 - _e395));
                                            let _e611 = (_e374 * 4097f);
                                            let _e613 = (_e611 - (_e611 - _e374));
                                            let _e614 = (_e395 - _e610);
                                            let _e615 = (_e374 - _e613);
                                            let _e625 = ((_e396 - _e397) + ((((((_e594 * _e597) - _e396) + (_e594 * _e599)) + (_e598 * _e597)) + (_e598 * _e599)) - (((((_e610 * _e613) - _e397) + (_e610 * _e615)) + (_e614 * _e613)) + (_e614 * _e615))));
                                            let _e627 = (_e360 * 4097f);
                                            let _e629 = (_e627 - (_e627 - _e360));
                                            let _e630 = (_e360 - _e629);
                                            let _e639 = (_e367 * 4097f);
                                            let _e641 = (_e639 - (_e639 - _e367));
                                            let _e642 = (_e367 - _e641);
                                            let _e652 = ((_e435 - _e436) + ((((((_e629 * _e610) - _e435) + (_e629 * _e614)) + (_e630 * _e610)) + (_e630 * _e614)) - (((((_e641 * _e594) - _e436) + (_e641 * _e598)) + (_e642 * _e594)) + (_e642 * _e598))));
                                            let _e671 = ((_e474 - _e475) + ((((((_e613 * _e641) - _e474) + (_e613 * _e642)) + (_e615 * _e641)) + (_e615 * _e642)) - (((((_e597 * _e629) - _e475) + (_e597 * _e630)) + (_e599 * _e629)) + (_e599 * _e630))));
                                            let _e674 = (1f / ((_e625 + _e652) + _e671));
                                            let _e675 = (_e652 * _e674);
                                            let _e676 = (_e671 * _e674);
                                            phi_1311_ = array<f32, 3>();
                                            phi_1312_ = array<f32, 3>(((((_e625 * _e674) * _e550) + (_e675 * _e551)) + (_e676 * _e552)), _e675, _e676);
                                        }
                                        let _e686 = phi_1311_;
                                        let _e688 = phi_1312_;
                                        phi_1313_ = _e686;
                                        phi_1314_ = _e688;
                                        phi_1315_ = _e590;
                                    }
                                    let _e690 = phi_1313_;
                                    let _e692 = phi_1314_;
                                    let _e694 = phi_1315_;
                                    phi_1316_ = _e690;
                                    phi_1317_ = _e692;
                                    phi_1318_ = _e549;
                                    phi_1319_ = _e694;
                                } else {
                                    phi_1316_ = array<f32, 3>();
                                    phi_1317_ = array<f32, 3>();
                                    phi_1318_ = true;
                                    phi_1319_ = false;
                                }
                                let _e696 = phi_1316_;
                                let _e698 = phi_1317_;
                                let _e700 = phi_1318_;
                                let _e702 = phi_1319_;
                                if _e700 {
                                    phi_1324_ = array<f32, 3>(-1f, 0f, 0f);
                                } else {
                                    phi_1324_ = _e696;
                                }
                                let _e704 = phi_1324_;
                                if select(_e702, true, _e700) {
                                    phi_1329_ = _e704;
                                } else {
                                    phi_1329_ = _e698;
                                }
                                let _e707 = phi_1329_;
                                let _e711 = (_e707[0] >= 0f);
                                if _e711 {
                                    let _e713 = (_e707[0] < _e318.member);
                                    if _e713 {
                                        if _e711 {
                                            if _e338 {
                                            } else {
                                                phi_2950_ = true;
                                                break;
                                            }
                                            let _e716 = triangles.member[_e333.member_1].member_3;
                                            if ((_e716 & 1u) == 0u) {
                                                phi_1662_ = true;
                                            } else {
                                                if _e338 {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                let _e721 = triangles.member[_e333.member_1].member_1;
                                                let _e722 = (_e721 * 12u);
                                                if ((256u + _e722) < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                if ((_e722 + 257u) < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                if ((_e722 + 258u) < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                let _e729 = (_e722 + 259u);
                                                if (_e729 < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                let _e732 = surfaces.member[_e729];
                                                if ((_e722 + 260u) < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                if ((_e722 + 261u) < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                if ((_e722 + 262u) < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                let _e739 = (_e722 + 263u);
                                                if (_e739 < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                let _e742 = surfaces.member[_e739];
                                                let _e743 = (_e722 + 264u);
                                                if (_e743 < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                let _e746 = surfaces.member[_e743];
                                                let _e747 = bitcast<f32>(_e746);
                                                let _e748 = (_e722 + 265u);
                                                if (_e748 < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                let _e751 = surfaces.member[_e748];
                                                let _e752 = bitcast<f32>(_e751);
                                                if ((_e722 + 266u) < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                if ((_e722 + 267u) < _e92) {
                                                } else {
                                                    phi_2950_ = true;
                                                    break;
                                                }
                                                if (_e732 == 4294967295u) {
                                                    phi_1657_ = (_e747 < _e752);
                                                } else {
                                                    if (_e333.member_1 < _e89) {
                                                    } else {
                                                        phi_2950_ = true;
                                                        break;
                                                    }
                                                    let _e760 = ((1f - _e707[1]) - _e707[2]);
                                                    let _e764 = attributes.member[_e333.member_1].member[0u];
                                                    let _e769 = attributes.member[_e333.member_1].member[2u];
                                                    let _e775 = attributes.member[_e333.member_1].member[4u];
                                                    let _e777 = (((_e764 * _e760) + (_e769 * _e707[1])) + (_e775 * _e707[2]));
                                                    let _e781 = attributes.member[_e333.member_1].member[1u];
                                                    let _e786 = attributes.member[_e333.member_1].member[3u];
                                                    let _e792 = attributes.member[_e333.member_1].member[5u];
                                                    let _e794 = (((_e781 * _e760) + (_e786 * _e707[1])) + (_e792 * _e707[2]));
                                                    let _e795 = (_e742 & 65535u);
                                                    let _e797 = (_e742 >> bitcast<u32>(16i));
                                                    let _e799 = (_e777 - floor(_e777));
                                                    let _e804 = ((select(0f, _e799, (_e799 <= 1f)) * f32(_e795)) - 0.5f);
                                                    let _e805 = floor(_e804);
                                                    let _e806 = (_e804 - _e805);
                                                    let _e807 = (_e795 - 1u);
                                                    if (_e805 < 0f) {
                                                        phi_1540_ = _e807;
                                                    } else {
                                                        let _e813 = select(select(u32(_e805), 0u, (_e805 < 0f)), 4294967295u, (_e805 > 4294967000f));
                                                        phi_1540_ = select(_e813, _e807, (_e807 < _e813));
                                                    }
                                                    let _e817 = phi_1540_;
                                                    if (_e817 == _e807) {
                                                        phi_1546_ = 0u;
                                                    } else {
                                                        phi_1546_ = (_e817 + 1u);
                                                    }
                                                    let _e821 = phi_1546_;
                                                    let _e823 = (_e794 - floor(_e794));
                                                    let _e828 = ((select(0f, _e823, (_e823 <= 1f)) * f32(_e797)) - 0.5f);
                                                    let _e829 = floor(_e828);
                                                    let _e830 = (_e828 - _e829);
                                                    let _e831 = (_e797 - 1u);
                                                    if (_e829 < 0f) {
                                                        phi_1576_ = _e831;
                                                    } else {
                                                        let _e837 = select(select(u32(_e829), 0u, (_e829 < 0f)), 4294967295u, (_e829 > 4294967000f));
                                                        phi_1576_ = select(_e837, _e831, (_e831 < _e837));
                                                    }
                                                    let _e841 = phi_1576_;
                                                    if (_e841 == _e831) {
                                                        phi_1582_ = 0u;
                                                    } else {
                                                        phi_1582_ = (_e841 + 1u);
                                                    }
                                                    let _e845 = phi_1582_;
                                                    let _e847 = (_e732 + (_e841 * _e795));
                                                    let _e849 = (_e732 + (_e845 * _e795));
                                                    let _e850 = (_e847 + _e817);
                                                    let _e851 = (_e847 + _e821);
                                                    let _e852 = (_e849 + _e817);
                                                    let _e853 = (_e849 + _e821);
                                                    if (_e850 < _e92) {
                                                    } else {
                                                        phi_2950_ = true;
                                                        break;
                                                    }
                                                    let _e856 = surfaces.member[_e850];
                                                    if (_e851 < _e92) {
                                                    } else {
                                                        phi_2950_ = true;
                                                        break;
                                                    }
                                                    let _e859 = surfaces.member[_e851];
                                                    if (_e852 < _e92) {
                                                    } else {
                                                        phi_2950_ = true;
                                                        break;
                                                    }
                                                    let _e862 = surfaces.member[_e852];
                                                    if (_e853 < _e92) {
                                                    } else {
                                                        phi_2950_ = true;
                                                        break;
                                                    }
                                                    let _e865 = surfaces.member[_e853];
                                                    let _e882 = (1f - _e806);
                                                    phi_1657_ = ((_e747 * (((((f32((_e856 >> bitcast<u32>(24i))) * 0.003921569f) * _e882) + ((f32((_e859 >> bitcast<u32>(24i))) * 0.003921569f) * _e806)) * (1f - _e830)) + ((((f32((_e862 >> bitcast<u32>(24i))) * 0.003921569f) * _e882) + ((f32((_e865 >> bitcast<u32>(24i))) * 0.003921569f) * _e806)) * _e830))) < _e752);
                                                }
                                                let _e897 = phi_1657_;
                                                phi_1662_ = select(true, false, _e897);
                                            }
                                            let _e900 = phi_1662_;
                                            if _e900 {
                                                phi_1667_ = type_44(_e707[0], _e333.member_1, _e707[1], _e707[2]);
                                            } else {
                                                phi_1667_ = type_44();
                                            }
                                            let _e903 = phi_1667_;
                                            phi_1669_ = _e903;
                                            phi_1671_ = select(true, false, _e900);
                                        } else {
                                            phi_1669_ = type_44();
                                            phi_1671_ = false;
                                        }
                                        let _e906 = phi_1669_;
                                        let _e908 = phi_1671_;
                                        phi_1672_ = _e906;
                                        phi_1674_ = select(true, false, _e711);
                                        phi_1675_ = _e908;
                                    } else {
                                        phi_1672_ = type_44();
                                        phi_1674_ = false;
                                        phi_1675_ = false;
                                    }
                                    let _e911 = phi_1672_;
                                    let _e913 = phi_1674_;
                                    let _e915 = phi_1675_;
                                    phi_1676_ = _e911;
                                    phi_1677_ = select(true, false, _e713);
                                    phi_1678_ = _e913;
                                    phi_1679_ = _e915;
                                } else {
                                    phi_1676_ = type_44();
                                    phi_1677_ = true;
                                    phi_1678_ = false;
                                    phi_1679_ = false;
                                }
                                let _e918 = phi_1676_;
                                let _e920 = phi_1677_;
                                let _e922 = phi_1678_;
                                let _e924 = phi_1679_;
                                if select(select(_e924, false, _e920), true, select(_e922, true, _e920)) {
                                    phi_1692_ = _e318;
                                } else {
                                    phi_1692_ = _e918;
                                }
                                let _e929 = phi_1692_;
                                phi_1017_ = _e929;
                            } else {
                                phi_1017_ = type_44();
                            }
                            let _e931 = phi_1017_;
                            continue;
                            continuing {
                                phi_1013_ = _e331;
                                phi_1016_ = _e931;
                                phi_2950_ = _e302;
                                break if !(_e337);
                            }
                        }
                        let _e934 = phi_2950_;
                        phi_3079_ = _e934;
                        phi_2706_ = type_44();
                        if _e934 {
                            break;
                        }
                        phi_3015_ = _e934;
                        phi_1693_ = 0u;
                        phi_1694_ = _e306;
                        let _e2040 = local_7;
                        phi_522_ = _e2040;
                    }
                    let _e1216 = phi_3015_;
                    let _e1218 = phi_1693_;
                    let _e1220 = phi_1694_;
                    let _e1222 = phi_522_;
                    phi_517_ = _e1218;
                    phi_520_ = _e1220;
                    loop {
                        let _e1224 = phi_517_;
                        let _e1226 = phi_520_;
                        local_5 = _e1224;
                        local_6 = _e1226;
                        let _e1227 = (_e1224 == 0u);
                        local_4 = _e1227;
                        if _e1227 {
                            let _e1228 = (_e1226 > 0u);
                            if _e1228 {
                                let _e1229 = (_e1226 - 1u);
                                let _e1230 = (_e1229 < 64u);
                                if _e1230 {
                                } else {
                                    phi_3012_ = true;
                                    break;
                                }
                                let _e1232 = local_1[_e1229];
                                if (_e1232 <= _e1222.member) {
                                    if _e1230 {
                                    } else {
                                        phi_3012_ = true;
                                        break;
                                    }
                                    let _e1236 = local[_e1229];
                                    phi_1729_ = _e1236;
                                } else {
                                    phi_1729_ = _e1224;
                                }
                                let _e1238 = phi_1729_;
                                phi_1730_ = _e1238;
                                phi_1731_ = _e1229;
                            } else {
                                phi_1730_ = u32();
                                phi_1731_ = u32();
                            }
                            let _e1240 = phi_1730_;
                            let _e1242 = phi_1731_;
                            phi_1696_ = _e1240;
                            phi_1698_ = _e1242;
                            phi_1732_ = _e1228;
                        } else {
                            phi_1696_ = u32();
                            phi_1698_ = u32();
                            phi_1732_ = false;
                        }
                        let _e1244 = phi_1696_;
                        let _e1246 = phi_1698_;
                        let _e1248 = phi_1732_;
                        continue;
                        continuing {
                            phi_517_ = _e1244;
                            phi_520_ = _e1246;
                            phi_3012_ = _e1216;
                            break if !(_e1248);
                        }
                    }
                    let _e1251 = phi_3012_;
                    phi_3079_ = _e1251;
                    phi_2706_ = type_44();
                    if _e1251 {
                        break;
                    }
                    let _e1253 = local_4;
                    continue;
                    continuing {
                        phi_2954_ = _e1251;
                        let _e1973 = local_5;
                        phi_516_ = _e1973;
                        let _e1976 = local_6;
                        phi_519_ = _e1976;
                        phi_521_ = _e1222;
                        phi_3079_ = _e1251;
                        phi_2706_ = _e1222;
                        break if !(select(true, false, _e1253));
                    }
                }
                let _e1257 = phi_3079_;
                let _e1259 = phi_2706_;
                if _e1257 {
                    break;
                }
                let _e1261 = (_e1259.member_1 != 4294967295u);
                if _e1261 {
                    if (_e1259.member_1 < _e86) {
                    } else {
                        break;
                    }
                    let _e1265 = triangles.member[_e1259.member_1].member;
                    let _e1271 = triangles.member[_e1259.member_1].member_2;
                    let _e1277 = triangles.member[_e1259.member_1].member_4;
                    let _e1281 = (_e1271[0] - _e1265[0]);
                    let _e1282 = (_e1271[1] - _e1265[1]);
                    let _e1283 = (_e1271[2] - _e1265[2]);
                    let _e1284 = (_e1277[0] - _e1265[0]);
                    let _e1285 = (_e1277[1] - _e1265[1]);
                    let _e1286 = (_e1277[2] - _e1265[2]);
                    let _e1303 = ((_e1282 * _e1286) - (_e1285 * _e1283));
                    let _e1306 = ((_e1283 * _e1284) - (_e1286 * _e1281));
                    let _e1309 = ((_e1281 * _e1285) - (_e1284 * _e1282));
                    let _e1310 = abs(_e1303);
                    let _e1311 = abs(_e1306);
                    let _e1313 = select(_e1311, _e1310, (_e1310 > _e1311));
                    let _e1314 = abs(_e1309);
                    let _e1316 = select(_e1314, _e1313, (_e1313 > _e1314));
                    if (_e1316 > 0.000000000000000000000000000000000000011754944f) {
                        let _e1318 = (_e1316 < 340282350000000000000000000000000000000f);
                        if _e1318 {
                            let _e1319 = (_e1303 / _e1316);
                            let _e1320 = (_e1306 / _e1316);
                            let _e1321 = (_e1309 / _e1316);
                            let _e1327 = sqrt((((_e1319 * _e1319) + (_e1320 * _e1320)) + (_e1321 * _e1321)));
                            phi_1834_ = vec3<f32>((_e1319 / _e1327), (_e1320 / _e1327), (_e1321 / _e1327));
                        } else {
                            phi_1834_ = vec3<f32>();
                        }
                        let _e1333 = phi_1834_;
                        phi_1836_ = _e1333;
                        phi_1837_ = select(true, false, _e1318);
                    } else {
                        phi_1836_ = vec3<f32>();
                        phi_1837_ = true;
                    }
                    let _e1336 = phi_1836_;
                    let _e1338 = phi_1837_;
                    let _e1340 = select(_e1336, vec3<f32>(0f, 1f, 0f), vec3(_e1338));
                    let _e1349 = ((((_e1340.x * _e189.x) + (_e1340.y * _e189.y)) + (_e1340.z * _e189.z)) < 0f);
                    if _e1349 {
                        phi_1858_ = _e1340;
                    } else {
                        phi_1858_ = -(_e1340);
                    }
                    let _e1352 = phi_1858_;
                    if (_e1259.member_1 < _e89) {
                    } else {
                        break;
                    }
                    let _e1356 = triangles.member[_e1259.member_1].member_1;
                    let _e1357 = (_e1356 * 12u);
                    let _e1358 = (256u + _e1357);
                    if (_e1358 < _e92) {
                    } else {
                        break;
                    }
                    let _e1361 = surfaces.member[_e1358];
                    let _e1362 = bitcast<f32>(_e1361);
                    let _e1363 = (_e1357 + 257u);
                    if (_e1363 < _e92) {
                    } else {
                        break;
                    }
                    let _e1366 = surfaces.member[_e1363];
                    let _e1367 = bitcast<f32>(_e1366);
                    let _e1368 = (_e1357 + 258u);
                    if (_e1368 < _e92) {
                    } else {
                        break;
                    }
                    let _e1371 = surfaces.member[_e1368];
                    let _e1372 = bitcast<f32>(_e1371);
                    let _e1373 = (_e1357 + 259u);
                    if (_e1373 < _e92) {
                    } else {
                        break;
                    }
                    let _e1376 = surfaces.member[_e1373];
                    let _e1377 = (_e1357 + 260u);
                    if (_e1377 < _e92) {
                    } else {
                        break;
                    }
                    let _e1380 = surfaces.member[_e1377];
                    let _e1382 = (_e1357 + 261u);
                    if (_e1382 < _e92) {
                    } else {
                        break;
                    }
                    let _e1385 = surfaces.member[_e1382];
                    let _e1387 = (_e1357 + 262u);
                    if (_e1387 < _e92) {
                    } else {
                        break;
                    }
                    let _e1390 = surfaces.member[_e1387];
                    let _e1393 = (_e1357 + 263u);
                    if (_e1393 < _e92) {
                    } else {
                        break;
                    }
                    let _e1396 = surfaces.member[_e1393];
                    let _e1397 = (_e1357 + 264u);
                    if (_e1397 < _e92) {
                    } else {
                        break;
                    }
                    let _e1400 = surfaces.member[_e1397];
                    let _e1401 = bitcast<f32>(_e1400);
                    if ((_e1357 + 265u) < _e92) {
                    } else {
                        break;
                    }
                    if ((_e1357 + 266u) < _e92) {
                    } else {
                        break;
                    }
                    if ((_e1357 + 267u) < _e92) {
                    } else {
                        break;
                    }
                    let _e1409 = ((1f - _e1259.member_2) - _e1259.member_3);
                    let _e1413 = attributes.member[_e1259.member_1].member[0u];
                    let _e1418 = attributes.member[_e1259.member_1].member[2u];
                    let _e1424 = attributes.member[_e1259.member_1].member[4u];
                    let _e1426 = (((_e1413 * _e1409) + (_e1418 * _e1259.member_2)) + (_e1424 * _e1259.member_3));
                    let _e1430 = attributes.member[_e1259.member_1].member[1u];
                    let _e1435 = attributes.member[_e1259.member_1].member[3u];
                    let _e1441 = attributes.member[_e1259.member_1].member[5u];
                    let _e1443 = (((_e1430 * _e1409) + (_e1435 * _e1259.member_2)) + (_e1441 * _e1259.member_3));
                    if (_e1376 == 4294967295u) {
                        phi_2301_ = type_47(vec3<f32>(_e1362, _e1367, _e1372), _e1401);
                    } else {
                        let _e1446 = (_e1396 & 65535u);
                        let _e1448 = (_e1396 >> bitcast<u32>(16i));
                        let _e1450 = (_e1426 - floor(_e1426));
                        let _e1455 = ((select(0f, _e1450, (_e1450 <= 1f)) * f32(_e1446)) - 0.5f);
                        let _e1456 = floor(_e1455);
                        let _e1457 = (_e1455 - _e1456);
                        let _e1458 = (_e1446 - 1u);
                        if (_e1456 < 0f) {
                            phi_2042_ = _e1458;
                        } else {
                            let _e1464 = select(select(u32(_e1456), 0u, (_e1456 < 0f)), 4294967295u, (_e1456 > 4294967000f));
                            phi_2042_ = select(_e1464, _e1458, (_e1458 < _e1464));
                        }
                        let _e1468 = phi_2042_;
                        if (_e1468 == _e1458) {
                            phi_2048_ = 0u;
                        } else {
                            phi_2048_ = (_e1468 + 1u);
                        }
                        let _e1472 = phi_2048_;
                        let _e1474 = (_e1443 - floor(_e1443));
                        let _e1479 = ((select(0f, _e1474, (_e1474 <= 1f)) * f32(_e1448)) - 0.5f);
                        let _e1480 = floor(_e1479);
                        let _e1481 = (_e1479 - _e1480);
                        let _e1482 = (_e1448 - 1u);
                        if (_e1480 < 0f) {
                            phi_2078_ = _e1482;
                        } else {
                            let _e1488 = select(select(u32(_e1480), 0u, (_e1480 < 0f)), 4294967295u, (_e1480 > 4294967000f));
                            phi_2078_ = select(_e1488, _e1482, (_e1482 < _e1488));
                        }
                        let _e1492 = phi_2078_;
                        if (_e1492 == _e1482) {
                            phi_2084_ = 0u;
                        } else {
                            phi_2084_ = (_e1492 + 1u);
                        }
                        let _e1496 = phi_2084_;
                        let _e1498 = (_e1376 + (_e1492 * _e1446));
                        let _e1500 = (_e1376 + (_e1496 * _e1446));
                        let _e1501 = (_e1498 + _e1468);
                        let _e1502 = (_e1498 + _e1472);
                        let _e1503 = (_e1500 + _e1468);
                        let _e1504 = (_e1500 + _e1472);
                        if (_e1501 < _e92) {
                        } else {
                            break;
                        }
                        let _e1507 = surfaces.member[_e1501];
                        if (_e1502 < _e92) {
                        } else {
                            break;
                        }
                        let _e1510 = surfaces.member[_e1502];
                        if (_e1503 < _e92) {
                        } else {
                            break;
                        }
                        let _e1513 = surfaces.member[_e1503];
                        if (_e1504 < _e92) {
                        } else {
                            break;
                        }
                        let _e1516 = surfaces.member[_e1504];
                        let _e1517 = (_e1507 & 255u);
                        if (_e1517 < _e92) {
                        } else {
                            break;
                        }
                        let _e1520 = surfaces.member[_e1517];
                        let _e1524 = ((_e1507 >> bitcast<u32>(8i)) & 255u);
                        if (_e1524 < _e92) {
                        } else {
                            break;
                        }
                        let _e1527 = surfaces.member[_e1524];
                        let _e1531 = ((_e1507 >> bitcast<u32>(16i)) & 255u);
                        if (_e1531 < _e92) {
                        } else {
                            break;
                        }
                        let _e1534 = surfaces.member[_e1531];
                        let _e1536 = (1f - _e1457);
                        let _e1540 = (_e1510 & 255u);
                        if (_e1540 < _e92) {
                        } else {
                            break;
                        }
                        let _e1543 = surfaces.member[_e1540];
                        let _e1547 = ((_e1510 >> bitcast<u32>(8i)) & 255u);
                        if (_e1547 < _e92) {
                        } else {
                            break;
                        }
                        let _e1550 = surfaces.member[_e1547];
                        let _e1554 = ((_e1510 >> bitcast<u32>(16i)) & 255u);
                        if (_e1554 < _e92) {
                        } else {
                            break;
                        }
                        let _e1557 = surfaces.member[_e1554];
                        let _e1565 = (_e1513 & 255u);
                        if (_e1565 < _e92) {
                        } else {
                            break;
                        }
                        let _e1568 = surfaces.member[_e1565];
                        let _e1572 = ((_e1513 >> bitcast<u32>(8i)) & 255u);
                        if (_e1572 < _e92) {
                        } else {
                            break;
                        }
                        let _e1575 = surfaces.member[_e1572];
                        let _e1579 = ((_e1513 >> bitcast<u32>(16i)) & 255u);
                        if (_e1579 < _e92) {
                        } else {
                            break;
                        }
                        let _e1582 = surfaces.member[_e1579];
                        let _e1587 = (_e1516 & 255u);
                        if (_e1587 < _e92) {
                        } else {
                            break;
                        }
                        let _e1590 = surfaces.member[_e1587];
                        let _e1594 = ((_e1516 >> bitcast<u32>(8i)) & 255u);
                        if (_e1594 < _e92) {
                        } else {
                            break;
                        }
                        let _e1597 = surfaces.member[_e1594];
                        let _e1601 = ((_e1516 >> bitcast<u32>(16i)) & 255u);
                        if (_e1601 < _e92) {
                        } else {
                            break;
                        }
                        let _e1604 = surfaces.member[_e1601];
                        let _e1612 = (1f - _e1481);
                        phi_2301_ = type_47(vec3<f32>((_e1362 * ((((bitcast<f32>(_e1520) * _e1536) + (bitcast<f32>(_e1543) * _e1457)) * _e1612) + (((bitcast<f32>(_e1568) * _e1536) + (bitcast<f32>(_e1590) * _e1457)) * _e1481))), (_e1367 * ((((bitcast<f32>(_e1527) * _e1536) + (bitcast<f32>(_e1550) * _e1457)) * _e1612) + (((bitcast<f32>(_e1575) * _e1536) + (bitcast<f32>(_e1597) * _e1457)) * _e1481))), (_e1372 * ((((bitcast<f32>(_e1534) * _e1536) + (bitcast<f32>(_e1557) * _e1457)) * _e1612) + (((bitcast<f32>(_e1582) * _e1536) + (bitcast<f32>(_e1604) * _e1457)) * _e1481)))), (_e1401 * (((((f32((_e1507 >> bitcast<u32>(24i))) * 0.003921569f) * _e1536) + ((f32((_e1510 >> bitcast<u32>(24i))) * 0.003921569f) * _e1457)) * _e1612) + ((((f32((_e1513 >> bitcast<u32>(24i))) * 0.003921569f) * _e1536) + ((f32((_e1516 >> bitcast<u32>(24i))) * 0.003921569f) * _e1457)) * _e1481))));
                    }
                    let _e1655 = phi_2301_;
                    let _e1660 = attributes.member[_e1259.member_1].member_1[0u];
                    let _e1670 = (f32((bitcast<i32>((_e1660 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1672 = select(-1f, _e1670, (_e1670 > -1f));
                    let _e1674 = (f32((bitcast<i32>(_e1660) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1676 = select(-1f, _e1674, (_e1674 > -1f));
                    let _e1680 = ((1f - abs(_e1672)) - abs(_e1676));
                    let _e1681 = -(_e1680);
                    let _e1685 = (bitcast<u32>(select(0f, _e1681, (_e1681 > 0f))) & 2147483647u);
                    let _e1690 = (_e1672 - bitcast<f32>((_e1685 | (bitcast<u32>(_e1672) & 2147483648u))));
                    let _e1695 = (_e1676 - bitcast<f32>((_e1685 | (bitcast<u32>(_e1676) & 2147483648u))));
                    let _e1700 = (((_e1690 * _e1690) + (_e1695 * _e1695)) + (_e1680 * _e1680));
                    if (_e1700 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e1703 = (1f / sqrt(_e1700));
                        phi_2367_ = vec3<f32>((_e1690 * _e1703), (_e1695 * _e1703), (_e1680 * _e1703));
                    } else {
                        phi_2367_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e1709 = phi_2367_;
                    let _e1719 = attributes.member[_e1259.member_1].member_1[1u];
                    let _e1729 = (f32((bitcast<i32>((_e1719 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1731 = select(-1f, _e1729, (_e1729 > -1f));
                    let _e1733 = (f32((bitcast<i32>(_e1719) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1735 = select(-1f, _e1733, (_e1733 > -1f));
                    let _e1739 = ((1f - abs(_e1731)) - abs(_e1735));
                    let _e1740 = -(_e1739);
                    let _e1744 = (bitcast<u32>(select(0f, _e1740, (_e1740 > 0f))) & 2147483647u);
                    let _e1749 = (_e1731 - bitcast<f32>((_e1744 | (bitcast<u32>(_e1731) & 2147483648u))));
                    let _e1754 = (_e1735 - bitcast<f32>((_e1744 | (bitcast<u32>(_e1735) & 2147483648u))));
                    let _e1759 = (((_e1749 * _e1749) + (_e1754 * _e1754)) + (_e1739 * _e1739));
                    if (_e1759 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e1762 = (1f / sqrt(_e1759));
                        phi_2441_ = vec3<f32>((_e1749 * _e1762), (_e1754 * _e1762), (_e1739 * _e1762));
                    } else {
                        phi_2441_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e1768 = phi_2441_;
                    let _e1781 = attributes.member[_e1259.member_1].member_1[2u];
                    let _e1791 = (f32((bitcast<i32>((_e1781 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1793 = select(-1f, _e1791, (_e1791 > -1f));
                    let _e1795 = (f32((bitcast<i32>(_e1781) >> bitcast<u32>(16i))) * 0.00003051851f);
                    let _e1797 = select(-1f, _e1795, (_e1795 > -1f));
                    let _e1801 = ((1f - abs(_e1793)) - abs(_e1797));
                    let _e1802 = -(_e1801);
                    let _e1806 = (bitcast<u32>(select(0f, _e1802, (_e1802 > 0f))) & 2147483647u);
                    let _e1811 = (_e1793 - bitcast<f32>((_e1806 | (bitcast<u32>(_e1793) & 2147483648u))));
                    let _e1816 = (_e1797 - bitcast<f32>((_e1806 | (bitcast<u32>(_e1797) & 2147483648u))));
                    let _e1821 = (((_e1811 * _e1811) + (_e1816 * _e1816)) + (_e1801 * _e1801));
                    if (_e1821 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e1824 = (1f / sqrt(_e1821));
                        phi_2515_ = vec3<f32>((_e1811 * _e1824), (_e1816 * _e1824), (_e1801 * _e1824));
                    } else {
                        phi_2515_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e1830 = phi_2515_;
                    let _e1837 = (((_e1709.x * _e1409) + (_e1768.x * _e1259.member_2)) + (_e1830.x * _e1259.member_3));
                    let _e1838 = (((_e1709.y * _e1409) + (_e1768.y * _e1259.member_2)) + (_e1830.y * _e1259.member_3));
                    let _e1839 = (((_e1709.z * _e1409) + (_e1768.z * _e1259.member_2)) + (_e1830.z * _e1259.member_3));
                    let _e1840 = abs(_e1837);
                    let _e1841 = abs(_e1838);
                    let _e1843 = select(_e1841, _e1840, (_e1840 > _e1841));
                    let _e1844 = abs(_e1839);
                    let _e1846 = select(_e1844, _e1843, (_e1843 > _e1844));
                    if (_e1846 > 0.000000000000000000000000000000000000011754944f) {
                        let _e1848 = (_e1846 < 340282350000000000000000000000000000000f);
                        if _e1848 {
                            let _e1849 = (_e1837 / _e1846);
                            let _e1850 = (_e1838 / _e1846);
                            let _e1851 = (_e1839 / _e1846);
                            let _e1857 = sqrt((((_e1849 * _e1849) + (_e1850 * _e1850)) + (_e1851 * _e1851)));
                            phi_2560_ = vec3<f32>((_e1849 / _e1857), (_e1850 / _e1857), (_e1851 / _e1857));
                        } else {
                            phi_2560_ = vec3<f32>();
                        }
                        let _e1863 = phi_2560_;
                        phi_2562_ = _e1863;
                        phi_2563_ = select(true, false, _e1848);
                    } else {
                        phi_2562_ = vec3<f32>();
                        phi_2563_ = true;
                    }
                    let _e1866 = phi_2562_;
                    let _e1868 = phi_2563_;
                    let _e1870 = select(_e1866, _e1352, vec3(_e1868));
                    if ((((_e1870.x * _e189.x) + (_e1870.y * _e189.y)) + (_e1870.z * _e189.z)) > 0f) {
                        phi_2584_ = -(_e1870);
                    } else {
                        phi_2584_ = _e1870;
                    }
                    let _e1882 = phi_2584_;
                    if _e1349 {
                        phi_2617_ = array<f32, 3>(bitcast<f32>(_e1380), bitcast<f32>(_e1385), bitcast<f32>(_e1390));
                    } else {
                        phi_2617_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e1908 = phi_2617_;
                    let _e1909 = abs(_e1265[0]);
                    let _e1910 = abs(_e1265[1]);
                    let _e1912 = select(_e1910, _e1909, (_e1909 > _e1910));
                    let _e1913 = abs(_e1265[2]);
                    let _e1917 = abs(_e1281);
                    let _e1918 = abs(_e1282);
                    let _e1920 = select(_e1918, _e1917, (_e1917 > _e1918));
                    let _e1921 = abs(_e1283);
                    let _e1924 = abs(_e1284);
                    let _e1925 = abs(_e1285);
                    let _e1927 = select(_e1925, _e1924, (_e1924 > _e1925));
                    let _e1928 = abs(_e1286);
                    phi_2663_ = type_48(array<f32, 3>(((_e1265[0] + (_e1281 * _e1259.member_2)) + (_e1284 * _e1259.member_3)), ((_e1265[1] + (_e1282 * _e1259.member_2)) + (_e1285 * _e1259.member_3)), ((_e1265[2] + (_e1283 * _e1259.member_2)) + (_e1286 * _e1259.member_3))), _e1259.member_1, array<f32, 3>(_e1882.x, _e1882.y, _e1882.z), (_e1259.member * sqrt((((_e189.x * _e189.x) + (_e189.y * _e189.y)) + (_e189.z * _e189.z)))), array<f32, 3>(_e1352.x, _e1352.y, _e1352.z), select(0u, 1u, _e1349), array<f32, 3>(_e1655.member.x, _e1655.member.y, _e1655.member.z), _e1356, _e1908, ((select(_e1913, _e1912, (_e1912 > _e1913)) * 0.00000047683716f) + ((select(_e1921, _e1920, (_e1920 > _e1921)) + select(_e1928, _e1927, (_e1927 > _e1928))) * 0.0000010728836f)));
                } else {
                    phi_2663_ = type_48(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0f);
                }
                let _e1936 = phi_2663_;
                if _e1261 {
                    phi_2676_ = _e1936;
                } else {
                    let _e1939 = params.member.member_4;
                    phi_2676_ = type_48(_e1936.member, _e1936.member_1, _e1936.member_2, _e1936.member_3, _e1936.member_4, _e1936.member_5, _e1936.member_6, _e1936.member_7, array<f32, 3>(_e1939.x, _e1939.y, _e1939.z), _e1936.member_9);
                }
                let _e1956 = phi_2676_;
                if (_e105 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                surfels.member[_e105] = _e1956;
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
