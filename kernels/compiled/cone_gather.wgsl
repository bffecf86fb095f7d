struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
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

struct type_30 {
    member: array<vec4<f32>>,
}

struct type_34 {
    member: array<type_26>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<u32>,
    member_2: array<vec4<u32>, 10>,
    member_3: array<vec4<f32>, 16>,
    member_4: array<vec4<f32>, 16>,
    member_5: vec4<f32>,
    member_6: vec4<f32>,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: f32,
}

struct type_39 {
    member: type_38,
}

struct type_41 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: i32,
    member_4: f32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_39;
@group(0) @binding(1) 
var<storage> cells: type_11;
@group(0) @binding(2) 
var<storage> facet_bits: type_11;
@group(0) @binding(3) 
var<storage> facets: type_20;
@group(0) @binding(4) 
var<storage> radiance: type_30;
@group(0) @binding(5) 
var<storage> odd: type_30;
@group(0) @binding(6) 
var<storage> even: type_30;
@group(0) @binding(7) 
var<storage> surfels: type_34;
@group(0) @binding(8) 
var<storage, read_write> out: type_30;

fn function_() {
    var phi_314_: f32;
    var phi_2248_: bool;
    var phi_319_: type_8;
    var phi_322_: vec3<f32>;
    var phi_320_: type_8;
    var phi_345_: type_8;
    var phi_483_: f32;
    var phi_491_: f32;
    var phi_504_: f32;
    var phi_505_: vec3<f32>;
    var phi_549_: bool;
    var phi_558_: u32;
    var phi_590_: i32;
    var phi_604_: bool;
    var phi_621_: f32;
    var phi_622_: f32;
    var phi_623_: bool;
    var phi_660_: i32;
    var phi_674_: bool;
    var phi_691_: f32;
    var phi_692_: f32;
    var phi_693_: bool;
    var phi_730_: i32;
    var phi_744_: bool;
    var phi_761_: f32;
    var phi_762_: f32;
    var phi_763_: bool;
    var phi_771_: type_8;
    var phi_774_: vec3<f32>;
    var phi_776_: type_41;
    var phi_778_: type_41;
    var phi_780_: type_41;
    var phi_782_: f32;
    var phi_784_: f32;
    var phi_772_: type_8;
    var phi_807_: type_8;
    var phi_827_: bool;
    var phi_838_: u32;
    var phi_859_: f32;
    var phi_860_: i32;
    var phi_861_: u32;
    var phi_862_: f32;
    var phi_863_: f32;
    var phi_864_: i32;
    var phi_865_: u32;
    var phi_866_: f32;
    var phi_922_: u32;
    var phi_939_: f32;
    var phi_960_: bool;
    var phi_972_: u32;
    var phi_983_: u32;
    var phi_991_: f32;
    var phi_1030_: f32;
    var phi_1041_: f32;
    var phi_1063_: bool;
    var phi_1075_: u32;
    var phi_1086_: u32;
    var phi_1094_: f32;
    var phi_1133_: f32;
    var phi_1144_: f32;
    var phi_1166_: bool;
    var phi_1178_: u32;
    var phi_1189_: u32;
    var phi_1197_: f32;
    var phi_1236_: f32;
    var phi_1263_: f32;
    var phi_1264_: f32;
    var phi_1265_: u32;
    var phi_1266_: u32;
    var phi_1267_: u32;
    var phi_1268_: u32;
    var phi_1269_: f32;
    var phi_1270_: f32;
    var phi_1271_: u32;
    var phi_1272_: u32;
    var phi_1273_: u32;
    var phi_1274_: u32;
    var phi_1275_: u32;
    var phi_1276_: u32;
    var phi_1279_: type_8;
    var phi_1282_: vec4<f32>;
    var phi_1280_: type_8;
    var phi_1305_: type_8;
    var phi_1740_: u32;
    var phi_1752_: vec4<f32>;
    var phi_1585_: type_8;
    var phi_1588_: vec4<f32>;
    var phi_1590_: vec4<f32>;
    var phi_1586_: type_8;
    var phi_1613_: type_8;
    var phi_1682_: vec4<f32>;
    var phi_1683_: vec4<f32>;
    var phi_1589_: vec4<f32>;
    var phi_1591_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1705_: vec4<f32>;
    var phi_1463_: type_8;
    var phi_1466_: vec4<f32>;
    var phi_1464_: type_8;
    var phi_1489_: type_8;
    var phi_1467_: vec4<f32>;
    var phi_1706_: vec4<f32>;
    var phi_1720_: vec4<f32>;
    var phi_1753_: vec4<f32>;
    var phi_1774_: vec4<f32>;
    var phi_1775_: vec4<f32>;
    var phi_1283_: vec4<f32>;
    var phi_1776_: vec4<f32>;
    var phi_1777_: vec4<f32>;
    var phi_1778_: bool;
    var phi_1822_: vec3<f32>;
    var phi_1823_: f32;
    var phi_1824_: f32;
    var phi_2029_: i32;
    var phi_2044_: type_41;
    var phi_2045_: type_41;
    var phi_2064_: bool;
    var phi_2086_: f32;
    var phi_2087_: f32;
    var phi_2088_: bool;
    var phi_1950_: i32;
    var phi_1965_: type_41;
    var phi_1966_: type_41;
    var phi_1985_: bool;
    var phi_2007_: f32;
    var phi_2008_: f32;
    var phi_2009_: bool;
    var phi_2094_: type_41;
    var phi_2095_: type_41;
    var phi_1867_: i32;
    var phi_1882_: type_41;
    var phi_1883_: type_41;
    var phi_1902_: bool;
    var phi_1924_: f32;
    var phi_1925_: f32;
    var phi_1926_: bool;
    var phi_2096_: type_41;
    var phi_2097_: type_41;
    var phi_2098_: type_41;
    var phi_2099_: vec3<f32>;
    var phi_2100_: type_41;
    var phi_2101_: type_41;
    var phi_2102_: type_41;
    var phi_2103_: f32;
    var phi_2104_: f32;
    var phi_2106_: vec3<f32>;
    var phi_2107_: type_41;
    var phi_2108_: type_41;
    var phi_2109_: type_41;
    var phi_2110_: f32;
    var phi_2111_: f32;
    var phi_2112_: bool;
    var phi_775_: vec3<f32>;
    var phi_777_: type_41;
    var phi_779_: type_41;
    var phi_781_: type_41;
    var phi_783_: f32;
    var phi_785_: f32;
    var phi_2114_: bool;
    var phi_2221_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var phi_2364_: bool;
    var phi_323_: vec3<f32>;
    var phi_2363_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var phi_2160_: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = gid_1;
            let _e91 = params.member.member_9;
            let _e95 = (_e78.x + (_e78.y * 2097152u));
            if (_e95 < _e91) {
                if (_e95 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e101 = surfels.member[_e95].member;
                let _e105 = surfels.member[_e95].member_1;
                let _e109 = surfels.member[_e95].member_2;
                let _e113 = surfels.member[_e95].member_4;
                if (_e105 == 4294967295u) {
                    phi_2160_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e126 = params.member.member;
                    let _e139 = params.member.member_12;
                    let _e143 = (((_e101[0] - _e126.x) / _e126.w) + (_e113[0] * _e139));
                    let _e144 = (((_e101[1] - _e126.y) / _e126.w) + (_e113[1] * _e139));
                    let _e145 = (((_e101[2] - _e126.z) / _e126.w) + (_e113[2] * _e139));
                    let _e149 = bitcast<f32>((1065353216u | (bitcast<u32>(_e109[2]) & 2147483648u)));
                    let _e151 = (-1f / (_e149 + _e109[2]));
                    let _e153 = ((_e109[0] * _e109[1]) * _e151);
                    let _e167 = params.member.member_10;
                    let _e168 = (_e167 == 0u);
                    if _e168 {
                        phi_314_ = 0f;
                    } else {
                        let _e172 = ((_e95 * 1664525u) + 1013904223u);
                        let _e174 = (((_e167 * 1664525u) + 1013904223u) + (_e172 * 1013904223u));
                        let _e176 = (_e172 + (1013904223u * _e174));
                        let _e180 = (1013904223u + (_e176 * (1013904223u + (_e174 * _e176))));
                        phi_314_ = (f32((((_e174 ^ (_e174 >> bitcast<u32>(16i))) + ((_e176 ^ (_e176 >> bitcast<u32>(16i))) * (_e180 ^ (_e180 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                    }
                    let _e197 = phi_314_;
                    let _e200 = params.member.member_7;
                    phi_2248_ = false;
                    phi_319_ = type_8(0u, _e200);
                    phi_322_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e203 = phi_2248_;
                        let _e205 = phi_319_;
                        let _e207 = phi_322_;
                        local_11 = _e207;
                        local_12 = _e207;
                        local_13 = _e207;
                        if (_e205.member < _e205.member_1) {
                            phi_320_ = type_8((_e205.member + 1u), _e205.member_1);
                            phi_345_ = type_8(1u, _e205.member);
                        } else {
                            phi_320_ = _e205;
                            phi_345_ = type_8(0u, type_8().member_1);
                        }
                        let _e220 = phi_320_;
                        let _e222 = phi_345_;
                        let _e226 = (bitcast<i32>(_e222.member) != 0i);
                        if _e226 {
                            let _e227 = (_e222.member_1 < 16u);
                            if _e227 {
                            } else {
                                phi_2363_ = true;
                                break;
                            }
                            let _e231 = params.member.member_3[_e222.member_1];
                            if _e168 {
                                phi_504_ = 1.4142135f;
                                phi_505_ = vec3<f32>(_e231.x, _e231.y, _e231.z);
                            } else {
                                let _e236 = ((_e95 * 1664525u) + 1013904223u);
                                let _e238 = (((1u + _e222.member_1) * 1664525u) + 1013904223u);
                                let _e240 = (((_e167 * 1664525u) + 1013904223u) + (_e236 * 1013904223u));
                                let _e242 = (_e236 + (_e238 * _e240));
                                let _e244 = (_e238 + (_e240 * _e242));
                                let _e246 = (1013904223u + (_e242 * _e244));
                                let _e252 = (_e242 ^ (_e242 >> bitcast<u32>(16i)));
                                let _e255 = (_e244 ^ (_e244 >> bitcast<u32>(16i)));
                                let _e260 = ((_e240 ^ (_e240 >> bitcast<u32>(16i))) + (_e252 * (_e246 ^ (_e246 >> bitcast<u32>(16i)))));
                                let _e262 = (_e252 + (_e255 * _e260));
                                if _e227 {
                                } else {
                                    phi_2363_ = true;
                                    break;
                                }
                                let _e280 = params.member.member_4[_e222.member_1];
                                let _e285 = (_e280.y + ((_e280.x - _e280.y) * (f32((_e260 >> bitcast<u32>(8i))) * 0.000000059604645f)));
                                let _e290 = ((_e280.z + (_e280.w * (f32((_e262 >> bitcast<u32>(8i))) * 0.000000059604645f))) + _e197);
                                let _e294 = floor(((_e290 * 4f) + 0.5f));
                                let _e300 = ((((6.2831855f * _e290) - (_e294 * 1.5703125f)) - (_e294 * 0.0004837513f)) - (_e294 * 0.0000000754979f));
                                let _e301 = (_e300 * _e300);
                                let _e308 = (_e300 + ((_e300 * _e301) * (-0.16666655f + (_e301 * (0.008332161f + (_e301 * -0.00019515296f))))));
                                let _e317 = ((1f - (0.5f * _e301)) + ((_e301 * _e301) * (0.041666646f + (_e301 * (-0.0013887316f + (_e301 * 0.000024433157f))))));
                                let _e324 = select(0i, select(select(i32(_e294), i32(-2147483648), (_e294 < -2147483600f)), 2147483647i, (_e294 > 2147483500f)), (_e294 == _e294));
                                let _e326 = ((_e324 & 1i) == 0i);
                                let _e327 = select(_e317, _e308, _e326);
                                let _e328 = select(_e308, _e317, _e326);
                                if ((_e324 & 2i) == 0i) {
                                    phi_483_ = _e327;
                                } else {
                                    phi_483_ = -(_e327);
                                }
                                let _e333 = phi_483_;
                                if (((_e324 + 1i) & 2i) == 0i) {
                                    phi_491_ = _e328;
                                } else {
                                    phi_491_ = -(_e328);
                                }
                                let _e339 = phi_491_;
                                let _e340 = (1f - _e285);
                                let _e343 = sqrt(select(0f, _e340, (_e340 > 0f)));
                                phi_504_ = (1f + (f32(((_e255 + (_e260 * _e262)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                                phi_505_ = vec3<f32>((_e343 * _e339), (_e343 * _e333), sqrt(_e285));
                            }
                            let _e354 = phi_504_;
                            let _e356 = phi_505_;
                            let _e359 = params.member.member_11;
                            let _e362 = params.member.member_13;
                            let _e380 = ((((1f + (((_e149 * _e109[0]) * _e109[0]) * _e151)) * _e356.x) + (_e153 * _e356.y)) + (_e109[0] * _e356.z));
                            let _e381 = ((((_e149 * _e153) * _e356.x) + ((_e149 + ((_e109[1] * _e109[1]) * _e151)) * _e356.y)) + (_e109[1] * _e356.z));
                            let _e382 = ((((-(_e149) * _e109[0]) * _e356.x) + (-(_e109[1]) * _e356.y)) + (_e109[2] * _e356.z));
                            let _e385 = params.member.member_1;
                            let _e386 = abs(_e380);
                            let _e387 = abs(_e381);
                            let _e388 = abs(_e382);
                            if (_e386 >= _e387) {
                                phi_549_ = select(true, false, (_e386 >= _e388));
                            } else {
                                phi_549_ = true;
                            }
                            let _e393 = phi_549_;
                            if _e393 {
                                phi_558_ = select(2u, 1u, (_e387 >= _e388));
                            } else {
                                phi_558_ = 0u;
                            }
                            let _e397 = phi_558_;
                            let _e400 = floor((_e143 - 0.5f));
                            let _e410 = -(floor((0.5f - _e143)));
                            let _e418 = (_e380 < 0f);
                            if _e418 {
                                phi_590_ = (select(0i, select(select(i32(_e410), i32(-2147483648), (_e410 < -2147483600f)), 2147483647i, (_e410 > 2147483500f)), (_e410 == _e410)) - 1i);
                            } else {
                                phi_590_ = (select(0i, select(select(i32(_e400), i32(-2147483648), (_e400 < -2147483600f)), 2147483647i, (_e400 > 2147483500f)), (_e400 == _e400)) + 1i);
                            }
                            let _e422 = phi_590_;
                            if _e418 {
                                phi_604_ = (_e422 < 0i);
                            } else {
                                phi_604_ = (_e422 >= bitcast<i32>(_e385.x));
                            }
                            let _e427 = phi_604_;
                            if _e427 {
                                phi_622_ = f32();
                                phi_623_ = true;
                            } else {
                                let _e430 = (_e386 < 0.000001f);
                                if _e430 {
                                    phi_621_ = f32();
                                } else {
                                    phi_621_ = (((f32(_e422) + 0.5f) - _e143) / _e380);
                                }
                                let _e434 = phi_621_;
                                phi_622_ = _e434;
                                phi_623_ = _e430;
                            }
                            let _e436 = phi_622_;
                            let _e438 = phi_623_;
                            let _e443 = floor((_e144 - 0.5f));
                            let _e453 = -(floor((0.5f - _e144)));
                            let _e461 = (_e381 < 0f);
                            if _e461 {
                                phi_660_ = (select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < -2147483600f)), 2147483647i, (_e453 > 2147483500f)), (_e453 == _e453)) - 1i);
                            } else {
                                phi_660_ = (select(0i, select(select(i32(_e443), i32(-2147483648), (_e443 < -2147483600f)), 2147483647i, (_e443 > 2147483500f)), (_e443 == _e443)) + 1i);
                            }
                            let _e465 = phi_660_;
                            if _e461 {
                                phi_674_ = (_e465 < 0i);
                            } else {
                                phi_674_ = (_e465 >= bitcast<i32>(_e385.y));
                            }
                            let _e470 = phi_674_;
                            if _e470 {
                                phi_692_ = f32();
                                phi_693_ = true;
                            } else {
                                let _e473 = (_e387 < 0.000001f);
                                if _e473 {
                                    phi_691_ = f32();
                                } else {
                                    phi_691_ = (((f32(_e465) + 0.5f) - _e144) / _e381);
                                }
                                let _e477 = phi_691_;
                                phi_692_ = _e477;
                                phi_693_ = _e473;
                            }
                            let _e479 = phi_692_;
                            let _e481 = phi_693_;
                            let _e486 = floor((_e145 - 0.5f));
                            let _e496 = -(floor((0.5f - _e145)));
                            let _e504 = (_e382 < 0f);
                            if _e504 {
                                phi_730_ = (select(0i, select(select(i32(_e496), i32(-2147483648), (_e496 < -2147483600f)), 2147483647i, (_e496 > 2147483500f)), (_e496 == _e496)) - 1i);
                            } else {
                                phi_730_ = (select(0i, select(select(i32(_e486), i32(-2147483648), (_e486 < -2147483600f)), 2147483647i, (_e486 > 2147483500f)), (_e486 == _e486)) + 1i);
                            }
                            let _e508 = phi_730_;
                            if _e504 {
                                phi_744_ = (_e508 < 0i);
                            } else {
                                phi_744_ = (_e508 >= bitcast<i32>(_e385.z));
                            }
                            let _e513 = phi_744_;
                            if _e513 {
                                phi_762_ = f32();
                                phi_763_ = true;
                            } else {
                                let _e516 = (_e388 < 0.000001f);
                                if _e516 {
                                    phi_761_ = f32();
                                } else {
                                    phi_761_ = (((f32(_e508) + 0.5f) - _e145) / _e382);
                                }
                                let _e520 = phi_761_;
                                phi_762_ = _e520;
                                phi_763_ = _e516;
                            }
                            let _e522 = phi_762_;
                            let _e524 = phi_763_;
                            phi_771_ = type_8(0u, 2048u);
                            phi_774_ = vec3<f32>(0f, 0f, 0f);
                            phi_776_ = type_41(_e145, _e382, 0u, _e508, select(_e522, 340282350000000000000000000000000000000f, _e524));
                            phi_778_ = type_41(_e144, _e381, 0u, _e465, select(_e479, 340282350000000000000000000000000000000f, _e481));
                            phi_780_ = type_41(_e143, _e380, 0u, _e422, select(_e436, 340282350000000000000000000000000000000f, _e438));
                            phi_782_ = 0f;
                            phi_784_ = 1f;
                            loop {
                                let _e528 = phi_771_;
                                let _e530 = phi_774_;
                                let _e532 = phi_776_;
                                let _e534 = phi_778_;
                                let _e536 = phi_780_;
                                let _e538 = phi_782_;
                                let _e540 = phi_784_;
                                local_6 = _e538;
                                local_7 = _e540;
                                local_8 = _e530;
                                local_9 = _e530;
                                local_10 = _e530;
                                if (_e528.member < _e528.member_1) {
                                    phi_772_ = type_8((_e528.member + 1u), _e528.member_1);
                                    phi_807_ = type_8(1u, _e528.member);
                                } else {
                                    phi_772_ = _e528;
                                    phi_807_ = type_8(0u, type_8().member_1);
                                }
                                let _e553 = phi_772_;
                                let _e555 = phi_807_;
                                if (bitcast<i32>(_e555.member) != 0i) {
                                    if (_e536.member_4 <= _e534.member_4) {
                                        phi_827_ = select(true, false, (_e536.member_4 <= _e532.member_4));
                                    } else {
                                        phi_827_ = true;
                                    }
                                    let _e566 = phi_827_;
                                    if _e566 {
                                        phi_838_ = select(2u, 1u, (_e534.member_4 <= _e532.member_4));
                                    } else {
                                        phi_838_ = 0u;
                                    }
                                    let _e571 = phi_838_;
                                    let _e572 = (_e571 == 0u);
                                    if _e572 {
                                        phi_863_ = _e536.member_4;
                                        phi_864_ = _e536.member_3;
                                        phi_865_ = _e536.member_2;
                                        phi_866_ = _e536.member_1;
                                    } else {
                                        if (_e571 == 1u) {
                                            phi_859_ = _e534.member_4;
                                            phi_860_ = _e534.member_3;
                                            phi_861_ = _e534.member_2;
                                            phi_862_ = _e534.member_1;
                                        } else {
                                            phi_859_ = _e532.member_4;
                                            phi_860_ = _e532.member_3;
                                            phi_861_ = _e532.member_2;
                                            phi_862_ = _e532.member_1;
                                        }
                                        let _e582 = phi_859_;
                                        let _e584 = phi_860_;
                                        let _e586 = phi_861_;
                                        let _e588 = phi_862_;
                                        phi_863_ = _e582;
                                        phi_864_ = _e584;
                                        phi_865_ = _e586;
                                        phi_866_ = _e588;
                                    }
                                    let _e593 = phi_863_;
                                    let _e595 = phi_864_;
                                    let _e597 = phi_865_;
                                    let _e599 = phi_866_;
                                    if (_e593 >= 340282350000000000000000000000000000000f) {
                                        phi_2106_ = vec3<f32>();
                                        phi_2107_ = type_41();
                                        phi_2108_ = type_41();
                                        phi_2109_ = type_41();
                                        phi_2110_ = f32();
                                        phi_2111_ = f32();
                                        phi_2112_ = false;
                                    } else {
                                        let _e601 = (1f - _e538);
                                        let _e602 = (_e540 * _e601);
                                        let _e603 = (_e602 < 0.001f);
                                        if _e603 {
                                            phi_2099_ = vec3<f32>();
                                            phi_2100_ = type_41();
                                            phi_2101_ = type_41();
                                            phi_2102_ = type_41();
                                            phi_2103_ = f32();
                                            phi_2104_ = f32();
                                        } else {
                                            let _e610 = (_e599 < 0f);
                                            if (_e597 < 10u) {
                                            } else {
                                                phi_2221_ = true;
                                                break;
                                            }
                                            let _e615 = params.member.member_2[_e597];
                                            let _e616 = (_e597 & 31u);
                                            let _e618 = (1u << bitcast<u32>(_e616));
                                            let _e619 = (_e618 - 1u);
                                            let _e622 = ((_e385.x + _e619) >> bitcast<u32>(_e616));
                                            let _e625 = ((_e385.y + _e619) >> bitcast<u32>(_e616));
                                            let _e628 = ((_e385.z + _e619) >> bitcast<u32>(_e616));
                                            let _e630 = (1f / f32(_e618));
                                            if _e572 {
                                                phi_922_ = _e622;
                                            } else {
                                                phi_922_ = select(_e628, _e625, (_e571 == 1u));
                                            }
                                            let _e634 = phi_922_;
                                            if (_e595 < 0i) {
                                                phi_1777_ = vec4<f32>();
                                                phi_1778_ = true;
                                            } else {
                                                let _e637 = (_e595 >= bitcast<i32>(_e634));
                                                if _e637 {
                                                    phi_1776_ = vec4<f32>();
                                                } else {
                                                    let _e638 = f32(_e595);
                                                    if _e572 {
                                                        phi_939_ = _e638;
                                                    } else {
                                                        phi_939_ = (((_e143 + (_e380 * _e593)) * _e630) - 0.5f);
                                                    }
                                                    let _e642 = phi_939_;
                                                    let _e643 = floor(_e642);
                                                    let _e651 = select(0i, select(select(i32(_e643), i32(-2147483648), (_e643 < -2147483600f)), 2147483647i, (_e643 > 2147483500f)), (_e643 == _e643));
                                                    let _e653 = (bitcast<i32>(_e622) - 1i);
                                                    if (_e642 >= -0.5f) {
                                                        phi_960_ = (_e642 <= (f32(_e653) + 0.5f));
                                                    } else {
                                                        phi_960_ = false;
                                                    }
                                                    let _e659 = phi_960_;
                                                    let _e660 = (_e651 >= 0i);
                                                    let _e661 = (_e651 < _e653);
                                                    if _e660 {
                                                        phi_972_ = bitcast<u32>(select(_e651, _e653, (_e653 < _e651)));
                                                    } else {
                                                        phi_972_ = 0u;
                                                    }
                                                    let _e666 = phi_972_;
                                                    if _e661 {
                                                        let _e667 = (_e651 + 1i);
                                                        phi_983_ = bitcast<u32>(select(0i, _e667, (0i < _e667)));
                                                    } else {
                                                        phi_983_ = 0u;
                                                    }
                                                    let _e672 = phi_983_;
                                                    if _e660 {
                                                        phi_991_ = select(0f, (_e642 - _e643), _e661);
                                                    } else {
                                                        phi_991_ = 1f;
                                                    }
                                                    let _e675 = phi_991_;
                                                    let _e677 = (_e666 >> bitcast<u32>(2u));
                                                    let _e679 = (_e672 >> bitcast<u32>(2u));
                                                    let _e686 = ((_e666 & 1u) | (((_e666 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                                    let _e693 = ((_e672 & 1u) | (((_e672 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                                    if _e659 {
                                                        phi_1030_ = (1f - _e675);
                                                    } else {
                                                        phi_1030_ = 0f;
                                                    }
                                                    let _e696 = phi_1030_;
                                                    let _e697 = select(0f, _e675, _e659);
                                                    let _e698 = (_e571 == 1u);
                                                    if _e698 {
                                                        phi_1041_ = _e638;
                                                    } else {
                                                        phi_1041_ = (((_e144 + (_e381 * _e593)) * _e630) - 0.5f);
                                                    }
                                                    let _e702 = phi_1041_;
                                                    let _e704 = floor(_e702);
                                                    let _e712 = select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < -2147483600f)), 2147483647i, (_e704 > 2147483500f)), (_e704 == _e704));
                                                    let _e714 = (bitcast<i32>(_e625) - 1i);
                                                    if (_e702 >= -0.5f) {
                                                        phi_1063_ = (_e702 <= (f32(_e714) + 0.5f));
                                                    } else {
                                                        phi_1063_ = false;
                                                    }
                                                    let _e720 = phi_1063_;
                                                    let _e721 = (_e712 >= 0i);
                                                    let _e722 = (_e712 < _e714);
                                                    if _e721 {
                                                        phi_1075_ = bitcast<u32>(select(_e712, _e714, (_e714 < _e712)));
                                                    } else {
                                                        phi_1075_ = 0u;
                                                    }
                                                    let _e727 = phi_1075_;
                                                    if _e722 {
                                                        let _e728 = (_e712 + 1i);
                                                        phi_1086_ = bitcast<u32>(select(0i, _e728, (0i < _e728)));
                                                    } else {
                                                        phi_1086_ = 0u;
                                                    }
                                                    let _e733 = phi_1086_;
                                                    if _e721 {
                                                        phi_1094_ = select(0f, (_e702 - _e704), _e722);
                                                    } else {
                                                        phi_1094_ = 1f;
                                                    }
                                                    let _e736 = phi_1094_;
                                                    let _e739 = ((_e727 >> bitcast<u32>(2u)) * _e615.x);
                                                    let _e742 = ((_e733 >> bitcast<u32>(2u)) * _e615.x);
                                                    let _e751 = (((_e727 & 1u) << bitcast<u32>(1u)) | (((_e727 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                                    let _e760 = (((_e733 & 1u) << bitcast<u32>(1u)) | (((_e733 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                                    if _e720 {
                                                        phi_1133_ = (1f - _e736);
                                                    } else {
                                                        phi_1133_ = 0f;
                                                    }
                                                    let _e763 = phi_1133_;
                                                    let _e764 = select(0f, _e736, _e720);
                                                    let _e765 = (_e571 == 2u);
                                                    if _e765 {
                                                        phi_1144_ = _e638;
                                                    } else {
                                                        phi_1144_ = (((_e145 + (_e382 * _e593)) * _e630) - 0.5f);
                                                    }
                                                    let _e769 = phi_1144_;
                                                    let _e771 = floor(_e769);
                                                    let _e779 = select(0i, select(select(i32(_e771), i32(-2147483648), (_e771 < -2147483600f)), 2147483647i, (_e771 > 2147483500f)), (_e771 == _e771));
                                                    let _e781 = (bitcast<i32>(_e628) - 1i);
                                                    if (_e769 >= -0.5f) {
                                                        phi_1166_ = (_e769 <= (f32(_e781) + 0.5f));
                                                    } else {
                                                        phi_1166_ = false;
                                                    }
                                                    let _e787 = phi_1166_;
                                                    let _e788 = (_e779 >= 0i);
                                                    let _e789 = (_e779 < _e781);
                                                    if _e788 {
                                                        phi_1178_ = bitcast<u32>(select(_e779, _e781, (_e781 < _e779)));
                                                    } else {
                                                        phi_1178_ = 0u;
                                                    }
                                                    let _e794 = phi_1178_;
                                                    if _e789 {
                                                        let _e795 = (_e779 + 1i);
                                                        phi_1189_ = bitcast<u32>(select(0i, _e795, (0i < _e795)));
                                                    } else {
                                                        phi_1189_ = 0u;
                                                    }
                                                    let _e800 = phi_1189_;
                                                    if _e788 {
                                                        phi_1197_ = select(0f, (_e769 - _e771), _e789);
                                                    } else {
                                                        phi_1197_ = 1f;
                                                    }
                                                    let _e803 = phi_1197_;
                                                    let _e806 = ((_e794 >> bitcast<u32>(1u)) * _e615.y);
                                                    let _e809 = ((_e800 >> bitcast<u32>(1u)) * _e615.y);
                                                    let _e812 = ((_e794 & 1u) << bitcast<u32>(2u));
                                                    let _e815 = ((_e800 & 1u) << bitcast<u32>(2u));
                                                    if _e787 {
                                                        phi_1236_ = (1f - _e803);
                                                    } else {
                                                        phi_1236_ = 0f;
                                                    }
                                                    let _e818 = phi_1236_;
                                                    let _e819 = select(0f, _e803, _e787);
                                                    if _e572 {
                                                        phi_1263_ = _e819;
                                                        phi_1264_ = _e818;
                                                        phi_1265_ = _e815;
                                                        phi_1266_ = _e812;
                                                        phi_1267_ = _e809;
                                                        phi_1268_ = _e806;
                                                        phi_1269_ = _e764;
                                                        phi_1270_ = _e763;
                                                        phi_1271_ = _e760;
                                                        phi_1272_ = _e751;
                                                        phi_1273_ = _e742;
                                                        phi_1274_ = _e739;
                                                        phi_1275_ = _e686;
                                                        phi_1276_ = _e677;
                                                    } else {
                                                        phi_1263_ = select(_e764, _e697, _e698);
                                                        phi_1264_ = select(_e763, _e696, _e698);
                                                        phi_1265_ = select(_e760, _e693, _e698);
                                                        phi_1266_ = select(_e751, _e686, _e698);
                                                        phi_1267_ = select(_e742, _e679, _e698);
                                                        phi_1268_ = select(_e739, _e677, _e698);
                                                        phi_1269_ = select(_e697, _e819, _e698);
                                                        phi_1270_ = select(_e696, _e818, _e698);
                                                        phi_1271_ = select(_e693, _e815, _e698);
                                                        phi_1272_ = select(_e686, _e812, _e698);
                                                        phi_1273_ = select(_e679, _e809, _e698);
                                                        phi_1274_ = select(_e677, _e806, _e698);
                                                        phi_1275_ = select(_e812, _e751, _e698);
                                                        phi_1276_ = select(_e806, _e739, _e698);
                                                    }
                                                    let _e835 = phi_1263_;
                                                    let _e837 = phi_1264_;
                                                    let _e839 = phi_1265_;
                                                    let _e841 = phi_1266_;
                                                    let _e843 = phi_1267_;
                                                    let _e845 = phi_1268_;
                                                    let _e847 = phi_1269_;
                                                    let _e849 = phi_1270_;
                                                    let _e851 = phi_1271_;
                                                    let _e853 = phi_1272_;
                                                    let _e855 = phi_1273_;
                                                    let _e857 = phi_1274_;
                                                    let _e859 = phi_1275_;
                                                    let _e861 = phi_1276_;
                                                    phi_1279_ = type_8(0u, 4u);
                                                    phi_1282_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                    loop {
                                                        let _e863 = phi_1279_;
                                                        let _e865 = phi_1282_;
                                                        local_16 = _e865;
                                                        if (_e863.member < _e863.member_1) {
                                                            phi_1280_ = type_8((_e863.member + 1u), _e863.member_1);
                                                            phi_1305_ = type_8(1u, _e863.member);
                                                        } else {
                                                            phi_1280_ = _e863;
                                                            phi_1305_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e878 = phi_1280_;
                                                        let _e880 = phi_1305_;
                                                        let _e884 = (bitcast<i32>(_e880.member) != 0i);
                                                        if _e884 {
                                                            let _e886 = ((_e880.member_1 & 1u) == 1u);
                                                            let _e888 = ((_e880.member_1 & 2u) == 2u);
                                                            let _e891 = (select(_e849, _e847, _e886) * select(_e837, _e835, _e888));
                                                            let _e897 = (((_e615.z + _e861) + select(_e857, _e855, _e886)) + select(_e845, _e843, _e888));
                                                            let _e902 = (2u * _e897);
                                                            let _e904 = cells.member[_e902];
                                                            if (_e891 > 0f) {
                                                                let _e906 = (((_e859 | select(_e853, _e851, _e886)) | select(_e841, _e839, _e888)) & 31u);
                                                                if (((_e904 >> bitcast<u32>(_e906)) & 1u) == 1u) {
                                                                    let _e913 = params.member.member_8;
                                                                    let _e914 = (_e913 == 1u);
                                                                    if (_e597 == 0u) {
                                                                        let _e940 = (_e897 * 6u);
                                                                        let _e943 = cells.member[(_e902 + 1u)];
                                                                        let _e945 = facet_bits.member[_e940];
                                                                        let _e948 = ((1u << bitcast<u32>(_e906)) - 1u);
                                                                        let _e957 = facet_bits.member[(_e940 + 1u)];
                                                                        let _e967 = facet_bits.member[(_e940 + 2u)];
                                                                        let _e977 = facet_bits.member[(_e940 + 3u)];
                                                                        let _e987 = facet_bits.member[(_e940 + 4u)];
                                                                        let _e997 = facet_bits.member[(_e940 + 5u)];
                                                                        let _e1000 = ((((((_e943 + countOneBits((_e945 & _e948))) + countOneBits((_e957 & _e948))) + countOneBits((_e967 & _e948))) + countOneBits((_e977 & _e948))) + countOneBits((_e987 & _e948))) + countOneBits((_e997 & _e948)));
                                                                        let _e1004 = (((((((_e945 >> bitcast<u32>(_e906)) & 1u) + ((_e957 >> bitcast<u32>(_e906)) & 1u)) + ((_e967 >> bitcast<u32>(_e906)) & 1u)) + ((_e977 >> bitcast<u32>(_e906)) & 1u)) + ((_e987 >> bitcast<u32>(_e906)) & 1u)) + ((_e997 >> bitcast<u32>(_e906)) & 1u));
                                                                        if _e914 {
                                                                            phi_1463_ = type_8(_e1000, (_e1000 + _e1004));
                                                                            phi_1466_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            loop {
                                                                                let _e1125 = phi_1463_;
                                                                                let _e1127 = phi_1466_;
                                                                                local_15 = _e1127;
                                                                                if (_e1125.member < _e1125.member_1) {
                                                                                    phi_1464_ = type_8((_e1125.member + 1u), _e1125.member_1);
                                                                                    phi_1489_ = type_8(1u, _e1125.member);
                                                                                } else {
                                                                                    phi_1464_ = _e1125;
                                                                                    phi_1489_ = type_8(0u, type_8().member_1);
                                                                                }
                                                                                let _e1140 = phi_1464_;
                                                                                let _e1142 = phi_1489_;
                                                                                let _e1146 = (bitcast<i32>(_e1142.member) != 0i);
                                                                                if _e1146 {
                                                                                    let _e1147 = (2u * _e1142.member_1);
                                                                                    let _e1150 = radiance.member[_e1147][0u];
                                                                                    let _e1153 = radiance.member[_e1147][1u];
                                                                                    let _e1156 = radiance.member[_e1147][2u];
                                                                                    let _e1157 = (_e1147 + 1u);
                                                                                    let _e1160 = radiance.member[_e1157][0u];
                                                                                    let _e1163 = radiance.member[_e1157][1u];
                                                                                    let _e1166 = radiance.member[_e1157][2u];
                                                                                    let _e1175 = facets.member[_e1142.member_1].member_2;
                                                                                    let _e1184 = sqrt((((_e1175[0] * _e1175[0]) + (_e1175[1] * _e1175[1])) + (_e1175[2] * _e1175[2])));
                                                                                    phi_1467_ = vec4<f32>((_e1127.x + (select(_e1160, _e1150, (_e1150 > _e1160)) * _e1184)), (_e1127.y + (select(_e1163, _e1153, (_e1153 > _e1163)) * _e1184)), (_e1127.z + (select(_e1166, _e1156, (_e1156 > _e1166)) * _e1184)), (_e1127.w + _e1184));
                                                                                } else {
                                                                                    phi_1467_ = vec4<f32>();
                                                                                }
                                                                                let _e1198 = phi_1467_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_1463_ = _e1140;
                                                                                    phi_1466_ = _e1198;
                                                                                    break if !(_e1146);
                                                                                }
                                                                            }
                                                                            let _e1751 = local_15;
                                                                            phi_1706_ = _e1751;
                                                                        } else {
                                                                            let _e1005 = select(1f, -1f, _e610);
                                                                            phi_1585_ = type_8(_e1000, (_e1000 + _e1004));
                                                                            phi_1588_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            phi_1590_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            loop {
                                                                                let _e1012 = phi_1585_;
                                                                                let _e1014 = phi_1588_;
                                                                                let _e1016 = phi_1590_;
                                                                                local = _e1014;
                                                                                local_1 = _e1016;
                                                                                local_2 = _e1014;
                                                                                local_3 = _e1014;
                                                                                local_4 = _e1014;
                                                                                local_5 = _e1016;
                                                                                local_14 = _e1016;
                                                                                if (_e1012.member < _e1012.member_1) {
                                                                                    phi_1586_ = type_8((_e1012.member + 1u), _e1012.member_1);
                                                                                    phi_1613_ = type_8(1u, _e1012.member);
                                                                                } else {
                                                                                    phi_1586_ = _e1012;
                                                                                    phi_1613_ = type_8(0u, type_8().member_1);
                                                                                }
                                                                                let _e1029 = phi_1586_;
                                                                                let _e1031 = phi_1613_;
                                                                                let _e1035 = (bitcast<i32>(_e1031.member) != 0i);
                                                                                if _e1035 {
                                                                                    let _e1038 = facets.member[_e1031.member_1].member_2;
                                                                                    let _e1047 = -((((select(0f, _e1005, _e572) * _e1038[0]) + (select(0f, _e1005, _e698) * _e1038[1])) + (select(0f, _e1005, _e765) * _e1038[2])));
                                                                                    if (_e1047 > 0f) {
                                                                                        let _e1070 = radiance.member[(2u * _e1031.member_1)];
                                                                                        phi_1682_ = _e1014;
                                                                                        phi_1683_ = vec4<f32>((_e1016.x + (_e1070.x * _e1047)), (_e1016.y + (_e1070.y * _e1047)), (_e1016.z + (_e1070.z * _e1047)), (_e1016.w + _e1047));
                                                                                    } else {
                                                                                        let _e1052 = radiance.member[((2u * _e1031.member_1) + 1u)];
                                                                                        phi_1682_ = vec4<f32>((_e1014.x - (_e1052.x * _e1047)), (_e1014.y - (_e1052.y * _e1047)), (_e1014.z - (_e1052.z * _e1047)), (_e1014.w - _e1047));
                                                                                        phi_1683_ = _e1016;
                                                                                    }
                                                                                    let _e1087 = phi_1682_;
                                                                                    let _e1089 = phi_1683_;
                                                                                    phi_1589_ = _e1087;
                                                                                    phi_1591_ = _e1089;
                                                                                } else {
                                                                                    phi_1589_ = vec4<f32>();
                                                                                    phi_1591_ = vec4<f32>();
                                                                                }
                                                                                let _e1091 = phi_1589_;
                                                                                let _e1093 = phi_1591_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_1585_ = _e1029;
                                                                                    phi_1588_ = _e1091;
                                                                                    phi_1590_ = _e1093;
                                                                                    break if !(_e1035);
                                                                                }
                                                                            }
                                                                            let _e1096 = local;
                                                                            let _e1099 = local_1;
                                                                            if (_e1096.w > _e1099.w) {
                                                                                let _e1102 = (_e1096.w - _e1099.w);
                                                                                let _e1103 = (_e1102 / _e1096.w);
                                                                                let _e1105 = local_2;
                                                                                let _e1109 = local_3;
                                                                                let _e1113 = local_4;
                                                                                let _e1118 = local_5;
                                                                                phi_1705_ = (_e1118 + vec4<f32>((_e1105.x * _e1103), (_e1109.y * _e1103), (_e1113.z * _e1103), _e1102));
                                                                            } else {
                                                                                let _e1743 = local_14;
                                                                                phi_1705_ = _e1743;
                                                                            }
                                                                            let _e1121 = phi_1705_;
                                                                            phi_1706_ = _e1121;
                                                                        }
                                                                        let _e1201 = phi_1706_;
                                                                        if (_e1201.w > 1f) {
                                                                            phi_1720_ = vec4<f32>((_e1201.x / _e1201.w), (_e1201.y / _e1201.w), (_e1201.z / _e1201.w), 1f);
                                                                        } else {
                                                                            phi_1720_ = _e1201;
                                                                        }
                                                                        let _e1212 = phi_1720_;
                                                                        phi_1753_ = _e1212;
                                                                    } else {
                                                                        let _e918 = cells.member[(_e902 + 1u)];
                                                                        let _e924 = (_e918 + countOneBits((_e904 & ((1u << bitcast<u32>(_e906)) - 1u))));
                                                                        if _e914 {
                                                                            phi_1740_ = _e924;
                                                                        } else {
                                                                            phi_1740_ = (((6u * _e924) + (2u * _e571)) + select(0u, 1u, _e610));
                                                                        }
                                                                        let _e931 = phi_1740_;
                                                                        if ((_e597 & 1u) == 1u) {
                                                                            let _e937 = odd.member[_e931];
                                                                            phi_1752_ = _e937;
                                                                        } else {
                                                                            let _e935 = even.member[_e931];
                                                                            phi_1752_ = _e935;
                                                                        }
                                                                        let _e939 = phi_1752_;
                                                                        phi_1753_ = _e939;
                                                                    }
                                                                    let _e1214 = phi_1753_;
                                                                    phi_1774_ = vec4<f32>((_e865.x + (_e1214.x * _e891)), (_e865.y + (_e1214.y * _e891)), (_e865.z + (_e1214.z * _e891)), (_e865.w + (_e1214.w * _e891)));
                                                                } else {
                                                                    phi_1774_ = _e865;
                                                                }
                                                                let _e1233 = phi_1774_;
                                                                phi_1775_ = _e1233;
                                                            } else {
                                                                phi_1775_ = _e865;
                                                            }
                                                            let _e1235 = phi_1775_;
                                                            phi_1283_ = _e1235;
                                                        } else {
                                                            phi_1283_ = vec4<f32>();
                                                        }
                                                        let _e1237 = phi_1283_;
                                                        continue;
                                                        continuing {
                                                            phi_1279_ = _e878;
                                                            phi_1282_ = _e1237;
                                                            break if !(_e884);
                                                        }
                                                    }
                                                    let _e1759 = local_16;
                                                    phi_1776_ = _e1759;
                                                }
                                                let _e1240 = phi_1776_;
                                                phi_1777_ = _e1240;
                                                phi_1778_ = _e637;
                                            }
                                            let _e1242 = phi_1777_;
                                            let _e1244 = phi_1778_;
                                            let _e1246 = select(_e1242, vec4<f32>(0f, 0f, 0f, 0f), vec4(_e1244));
                                            if (_e1246.w > 0f) {
                                                let _e1253 = select(_e601, _e1246.w, (_e1246.w < _e601));
                                                let _e1258 = ((_e540 * _e1253) / _e1246.w);
                                                phi_1822_ = vec3<f32>((_e530.x + (_e1246.x * _e1258)), (_e530.y + (_e1246.y * _e1258)), (_e530.z + (_e1246.z * _e1258)));
                                                phi_1823_ = (_e538 + _e1253);
                                                phi_1824_ = _e540;
                                            } else {
                                                let _e1249 = (_e571 == _e397);
                                                phi_1822_ = _e530;
                                                phi_1823_ = select(_e538, 0f, _e1249);
                                                phi_1824_ = select(_e540, _e602, _e1249);
                                            }
                                            let _e1271 = phi_1822_;
                                            let _e1273 = phi_1823_;
                                            let _e1275 = phi_1824_;
                                            let _e1276 = (_e359 * _e593);
                                            let _e1278 = ((_e362 * _e139) + ((_e362 * _e356.z) * _e593));
                                            let _e1280 = select(_e1278, _e1276, (_e1276 < _e1278));
                                            let _e1287 = ((bitcast<u32>((select(1f, _e1280, (_e1280 > 1f)) * _e354)) >> bitcast<u32>(23i)) - 127u);
                                            let _e1289 = (_e385.w - 1u);
                                            let _e1291 = select(_e1287, _e1289, (_e1289 < _e1287));
                                            if _e572 {
                                                let _e1452 = (_e536.member_1 < 0f);
                                                if _e1452 {
                                                    phi_1867_ = (_e536.member_3 - 1i);
                                                } else {
                                                    phi_1867_ = (_e536.member_3 + 1i);
                                                }
                                                let _e1460 = phi_1867_;
                                                let _e1466 = type_41(_e536.member, _e536.member_1, _e536.member_2, _e1460, _e536.member_4);
                                                if (((_e536.member_3 & 1i) == 0i) == _e1452) {
                                                    if (_e1291 > _e536.member_2) {
                                                        let _e1475 = type_41(_e1466.member, _e1466.member_1, (_e536.member_2 + 1u), _e1466.member_3, _e1466.member_4);
                                                        phi_1882_ = type_41(_e1475.member, _e1475.member_1, _e1475.member_2, (_e1460 >> bitcast<u32>(1i)), _e1475.member_4);
                                                    } else {
                                                        phi_1882_ = _e1466;
                                                    }
                                                    let _e1485 = phi_1882_;
                                                    phi_1883_ = _e1485;
                                                } else {
                                                    phi_1883_ = _e1466;
                                                }
                                                let _e1487 = phi_1883_;
                                                let _e1489 = (_e1487.member_2 & 31u);
                                                let _e1491 = (1u << bitcast<u32>(_e1489));
                                                if (_e1487.member_1 < 0f) {
                                                    phi_1902_ = (_e1487.member_3 < 0i);
                                                } else {
                                                    phi_1902_ = (_e1487.member_3 >= bitcast<i32>((((_e385.x + _e1491) - 1u) >> bitcast<u32>(_e1489))));
                                                }
                                                let _e1504 = phi_1902_;
                                                if _e1504 {
                                                    phi_1925_ = f32();
                                                    phi_1926_ = true;
                                                } else {
                                                    let _e1511 = (abs(_e1487.member_1) < 0.000001f);
                                                    if _e1511 {
                                                        phi_1924_ = f32();
                                                    } else {
                                                        phi_1924_ = ((((f32(_e1487.member_3) + 0.5f) * f32(_e1491)) - _e1487.member) / _e1487.member_1);
                                                    }
                                                    let _e1516 = phi_1924_;
                                                    phi_1925_ = _e1516;
                                                    phi_1926_ = _e1511;
                                                }
                                                let _e1518 = phi_1925_;
                                                let _e1520 = phi_1926_;
                                                phi_2096_ = _e532;
                                                phi_2097_ = _e534;
                                                phi_2098_ = type_41(_e1487.member, _e1487.member_1, _e1487.member_2, _e1487.member_3, select(_e1518, 340282350000000000000000000000000000000f, _e1520));
                                            } else {
                                                if (_e571 == 1u) {
                                                    let _e1371 = (_e534.member_1 < 0f);
                                                    if _e1371 {
                                                        phi_1950_ = (_e534.member_3 - 1i);
                                                    } else {
                                                        phi_1950_ = (_e534.member_3 + 1i);
                                                    }
                                                    let _e1379 = phi_1950_;
                                                    let _e1385 = type_41(_e534.member, _e534.member_1, _e534.member_2, _e1379, _e534.member_4);
                                                    if (((_e534.member_3 & 1i) == 0i) == _e1371) {
                                                        if (_e1291 > _e534.member_2) {
                                                            let _e1394 = type_41(_e1385.member, _e1385.member_1, (_e534.member_2 + 1u), _e1385.member_3, _e1385.member_4);
                                                            phi_1965_ = type_41(_e1394.member, _e1394.member_1, _e1394.member_2, (_e1379 >> bitcast<u32>(1i)), _e1394.member_4);
                                                        } else {
                                                            phi_1965_ = _e1385;
                                                        }
                                                        let _e1404 = phi_1965_;
                                                        phi_1966_ = _e1404;
                                                    } else {
                                                        phi_1966_ = _e1385;
                                                    }
                                                    let _e1406 = phi_1966_;
                                                    let _e1408 = (_e1406.member_2 & 31u);
                                                    let _e1410 = (1u << bitcast<u32>(_e1408));
                                                    if (_e1406.member_1 < 0f) {
                                                        phi_1985_ = (_e1406.member_3 < 0i);
                                                    } else {
                                                        phi_1985_ = (_e1406.member_3 >= bitcast<i32>((((_e385.y + _e1410) - 1u) >> bitcast<u32>(_e1408))));
                                                    }
                                                    let _e1423 = phi_1985_;
                                                    if _e1423 {
                                                        phi_2008_ = f32();
                                                        phi_2009_ = true;
                                                    } else {
                                                        let _e1430 = (abs(_e1406.member_1) < 0.000001f);
                                                        if _e1430 {
                                                            phi_2007_ = f32();
                                                        } else {
                                                            phi_2007_ = ((((f32(_e1406.member_3) + 0.5f) * f32(_e1410)) - _e1406.member) / _e1406.member_1);
                                                        }
                                                        let _e1435 = phi_2007_;
                                                        phi_2008_ = _e1435;
                                                        phi_2009_ = _e1430;
                                                    }
                                                    let _e1437 = phi_2008_;
                                                    let _e1439 = phi_2009_;
                                                    phi_2094_ = _e532;
                                                    phi_2095_ = type_41(_e1406.member, _e1406.member_1, _e1406.member_2, _e1406.member_3, select(_e1437, 340282350000000000000000000000000000000f, _e1439));
                                                } else {
                                                    let _e1294 = (_e532.member_1 < 0f);
                                                    if _e1294 {
                                                        phi_2029_ = (_e532.member_3 - 1i);
                                                    } else {
                                                        phi_2029_ = (_e532.member_3 + 1i);
                                                    }
                                                    let _e1302 = phi_2029_;
                                                    let _e1308 = type_41(_e532.member, _e532.member_1, _e532.member_2, _e1302, _e532.member_4);
                                                    if (((_e532.member_3 & 1i) == 0i) == _e1294) {
                                                        if (_e1291 > _e532.member_2) {
                                                            let _e1317 = type_41(_e1308.member, _e1308.member_1, (_e532.member_2 + 1u), _e1308.member_3, _e1308.member_4);
                                                            phi_2044_ = type_41(_e1317.member, _e1317.member_1, _e1317.member_2, (_e1302 >> bitcast<u32>(1i)), _e1317.member_4);
                                                        } else {
                                                            phi_2044_ = _e1308;
                                                        }
                                                        let _e1327 = phi_2044_;
                                                        phi_2045_ = _e1327;
                                                    } else {
                                                        phi_2045_ = _e1308;
                                                    }
                                                    let _e1329 = phi_2045_;
                                                    let _e1331 = (_e1329.member_2 & 31u);
                                                    let _e1333 = (1u << bitcast<u32>(_e1331));
                                                    if (_e1329.member_1 < 0f) {
                                                        phi_2064_ = (_e1329.member_3 < 0i);
                                                    } else {
                                                        phi_2064_ = (_e1329.member_3 >= bitcast<i32>((((_e385.z + _e1333) - 1u) >> bitcast<u32>(_e1331))));
                                                    }
                                                    let _e1346 = phi_2064_;
                                                    if _e1346 {
                                                        phi_2087_ = f32();
                                                        phi_2088_ = true;
                                                    } else {
                                                        let _e1353 = (abs(_e1329.member_1) < 0.000001f);
                                                        if _e1353 {
                                                            phi_2086_ = f32();
                                                        } else {
                                                            phi_2086_ = ((((f32(_e1329.member_3) + 0.5f) * f32(_e1333)) - _e1329.member) / _e1329.member_1);
                                                        }
                                                        let _e1358 = phi_2086_;
                                                        phi_2087_ = _e1358;
                                                        phi_2088_ = _e1353;
                                                    }
                                                    let _e1360 = phi_2087_;
                                                    let _e1362 = phi_2088_;
                                                    phi_2094_ = type_41(_e1329.member, _e1329.member_1, _e1329.member_2, _e1329.member_3, select(_e1360, 340282350000000000000000000000000000000f, _e1362));
                                                    phi_2095_ = _e534;
                                                }
                                                let _e1448 = phi_2094_;
                                                let _e1450 = phi_2095_;
                                                phi_2096_ = _e1448;
                                                phi_2097_ = _e1450;
                                                phi_2098_ = _e536;
                                            }
                                            let _e1529 = phi_2096_;
                                            let _e1531 = phi_2097_;
                                            let _e1533 = phi_2098_;
                                            phi_2099_ = _e1271;
                                            phi_2100_ = _e1529;
                                            phi_2101_ = _e1531;
                                            phi_2102_ = _e1533;
                                            phi_2103_ = _e1273;
                                            phi_2104_ = _e1275;
                                        }
                                        let _e1535 = phi_2099_;
                                        let _e1537 = phi_2100_;
                                        let _e1539 = phi_2101_;
                                        let _e1541 = phi_2102_;
                                        let _e1543 = phi_2103_;
                                        let _e1545 = phi_2104_;
                                        phi_2106_ = _e1535;
                                        phi_2107_ = _e1537;
                                        phi_2108_ = _e1539;
                                        phi_2109_ = _e1541;
                                        phi_2110_ = _e1543;
                                        phi_2111_ = _e1545;
                                        phi_2112_ = select(true, false, _e603);
                                    }
                                    let _e1548 = phi_2106_;
                                    let _e1550 = phi_2107_;
                                    let _e1552 = phi_2108_;
                                    let _e1554 = phi_2109_;
                                    let _e1556 = phi_2110_;
                                    let _e1558 = phi_2111_;
                                    let _e1560 = phi_2112_;
                                    phi_775_ = _e1548;
                                    phi_777_ = _e1550;
                                    phi_779_ = _e1552;
                                    phi_781_ = _e1554;
                                    phi_783_ = _e1556;
                                    phi_785_ = _e1558;
                                    phi_2114_ = _e1560;
                                } else {
                                    phi_775_ = vec3<f32>();
                                    phi_777_ = type_41();
                                    phi_779_ = type_41();
                                    phi_781_ = type_41();
                                    phi_783_ = f32();
                                    phi_785_ = f32();
                                    phi_2114_ = false;
                                }
                                let _e1562 = phi_775_;
                                let _e1564 = phi_777_;
                                let _e1566 = phi_779_;
                                let _e1568 = phi_781_;
                                let _e1570 = phi_783_;
                                let _e1572 = phi_785_;
                                let _e1574 = phi_2114_;
                                continue;
                                continuing {
                                    phi_771_ = _e553;
                                    phi_774_ = _e1562;
                                    phi_776_ = _e1564;
                                    phi_778_ = _e1566;
                                    phi_780_ = _e1568;
                                    phi_782_ = _e1570;
                                    phi_784_ = _e1572;
                                    phi_2221_ = _e203;
                                    break if !(_e1574);
                                }
                            }
                            let _e1577 = phi_2221_;
                            phi_2363_ = _e1577;
                            if _e1577 {
                                break;
                            }
                            let _e1579 = local_6;
                            let _e1582 = local_7;
                            let _e1583 = (_e1582 * (1f - _e1579));
                            let _e1585 = local_8;
                            let _e1588 = local_9;
                            let _e1591 = local_10;
                            let _e1595 = params.member.member_5;
                            phi_2364_ = _e1577;
                            phi_323_ = vec3<f32>((_e207.x + ((_e1585.x + (_e1595.x * _e1583)) * _e231.w)), (_e207.y + ((_e1588.y + (_e1595.y * _e1583)) * _e231.w)), (_e207.z + ((_e1591.z + (_e1595.z * _e1583)) * _e231.w)));
                        } else {
                            phi_2364_ = _e203;
                            phi_323_ = vec3<f32>();
                        }
                        let _e1617 = phi_2364_;
                        let _e1619 = phi_323_;
                        continue;
                        continuing {
                            phi_2248_ = _e1617;
                            phi_319_ = _e220;
                            phi_322_ = _e1619;
                            phi_2363_ = _e1617;
                            break if !(_e226);
                        }
                    }
                    let _e1622 = phi_2363_;
                    if _e1622 {
                        break;
                    }
                    let _e1624 = local_11;
                    let _e1628 = local_12;
                    let _e1632 = local_13;
                    phi_2160_ = vec4<f32>((_e1624.x * 3.1415927f), (_e1628.y * 3.1415927f), (_e1632.z * 3.1415927f), 0f);
                }
                let _e1637 = phi_2160_;
                if (_e95 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e95] = _e1637;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn cone_gather(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
