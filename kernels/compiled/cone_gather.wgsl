struct type_9 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
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
var<storage> cells: type_9;
@group(0) @binding(2) 
var<storage> facet_bits: type_9;
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
    var phi_315_: f32;
    var phi_320_: type_13;
    var phi_323_: vec3<f32>;
    var phi_321_: type_13;
    var phi_346_: type_13;
    var phi_484_: f32;
    var phi_492_: f32;
    var phi_505_: f32;
    var phi_506_: vec3<f32>;
    var phi_550_: bool;
    var phi_559_: u32;
    var phi_575_: i32;
    var phi_604_: f32;
    var phi_621_: i32;
    var phi_650_: f32;
    var phi_667_: i32;
    var phi_696_: f32;
    var phi_699_: vec3<f32>;
    var phi_702_: type_41;
    var phi_704_: type_41;
    var phi_706_: type_41;
    var phi_708_: u32;
    var phi_710_: f32;
    var phi_712_: f32;
    var phi_738_: u32;
    var phi_760_: i32;
    var phi_761_: u32;
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_764_: i32;
    var phi_765_: u32;
    var phi_766_: f32;
    var phi_815_: u32;
    var phi_830_: f32;
    var phi_912_: f32;
    var phi_923_: f32;
    var phi_1006_: f32;
    var phi_1017_: f32;
    var phi_1100_: f32;
    var phi_1127_: f32;
    var phi_1128_: f32;
    var phi_1129_: u32;
    var phi_1130_: u32;
    var phi_1131_: u32;
    var phi_1132_: u32;
    var phi_1133_: f32;
    var phi_1134_: f32;
    var phi_1135_: u32;
    var phi_1136_: u32;
    var phi_1137_: u32;
    var phi_1138_: u32;
    var phi_1139_: u32;
    var phi_1140_: u32;
    var phi_1142_: vec4<f32>;
    var phi_1145_: u32;
    var phi_1532_: u32;
    var phi_1544_: vec4<f32>;
    var phi_1398_: vec4<f32>;
    var phi_1401_: vec4<f32>;
    var phi_1403_: u32;
    var phi_1473_: vec4<f32>;
    var phi_1474_: vec4<f32>;
    var phi_1399_: vec4<f32>;
    var phi_1402_: vec4<f32>;
    var phi_1404_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1497_: vec4<f32>;
    var phi_1299_: vec4<f32>;
    var phi_1302_: u32;
    var phi_1300_: vec4<f32>;
    var phi_1303_: u32;
    var phi_1498_: vec4<f32>;
    var phi_1512_: vec4<f32>;
    var phi_1545_: vec4<f32>;
    var phi_1566_: vec4<f32>;
    var phi_1143_: vec4<f32>;
    var phi_1146_: u32;
    var phi_1568_: vec4<f32>;
    var phi_1608_: vec3<f32>;
    var phi_1609_: f32;
    var phi_1610_: f32;
    var phi_1795_: i32;
    var phi_1808_: type_41;
    var phi_1848_: f32;
    var phi_1726_: i32;
    var phi_1739_: type_41;
    var phi_1779_: f32;
    var phi_1850_: type_41;
    var phi_1851_: type_41;
    var phi_1653_: i32;
    var phi_1666_: type_41;
    var phi_1706_: f32;
    var phi_1852_: type_41;
    var phi_1853_: type_41;
    var phi_1854_: type_41;
    var phi_1855_: vec3<f32>;
    var phi_1856_: type_41;
    var phi_1857_: type_41;
    var phi_1858_: type_41;
    var phi_1859_: f32;
    var phi_1860_: f32;
    var phi_700_: vec3<f32>;
    var phi_703_: type_41;
    var phi_705_: type_41;
    var phi_707_: type_41;
    var phi_709_: u32;
    var phi_711_: f32;
    var phi_713_: f32;
    var phi_1862_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var phi_324_: vec3<f32>;
    var phi_1959_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var phi_1903_: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e77 = gid_1;
            let _e90 = params.member.member_9;
            let _e94 = (_e77.x + (_e77.y * 2097152u));
            if (_e94 < _e90) {
                if (_e94 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e100 = surfels.member[_e94].member;
                let _e104 = surfels.member[_e94].member_1;
                let _e108 = surfels.member[_e94].member_2;
                let _e112 = surfels.member[_e94].member_4;
                if (_e104 == 4294967295u) {
                    phi_1903_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e125 = params.member.member;
                    let _e138 = params.member.member_12;
                    let _e142 = (((_e100[0] - _e125.x) / _e125.w) + (_e112[0] * _e138));
                    let _e143 = (((_e100[1] - _e125.y) / _e125.w) + (_e112[1] * _e138));
                    let _e144 = (((_e100[2] - _e125.z) / _e125.w) + (_e112[2] * _e138));
                    let _e148 = bitcast<f32>((1065353216u | (bitcast<u32>(_e108[2]) & 2147483648u)));
                    let _e150 = (-1f / (_e148 + _e108[2]));
                    let _e152 = ((_e108[0] * _e108[1]) * _e150);
                    let _e166 = params.member.member_10;
                    let _e167 = (_e166 == 0u);
                    if _e167 {
                        phi_315_ = 0f;
                    } else {
                        let _e171 = ((_e94 * 1664525u) + 1013904223u);
                        let _e173 = (((_e166 * 1664525u) + 1013904223u) + (_e171 * 1013904223u));
                        let _e175 = (_e171 + (1013904223u * _e173));
                        let _e179 = (1013904223u + (_e175 * (1013904223u + (_e173 * _e175))));
                        phi_315_ = (f32((((_e173 ^ (_e173 >> bitcast<u32>(16i))) + ((_e175 ^ (_e175 >> bitcast<u32>(16i))) * (_e179 ^ (_e179 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                    }
                    let _e196 = phi_315_;
                    let _e199 = params.member.member_7;
                    phi_320_ = type_13(0u, _e199);
                    phi_323_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e202 = phi_320_;
                        let _e204 = phi_323_;
                        local_11 = _e204;
                        local_12 = _e204;
                        local_13 = _e204;
                        if (_e202.member < _e202.member_1) {
                            phi_321_ = type_13((_e202.member + 1u), _e202.member_1);
                            phi_346_ = type_13(1u, _e202.member);
                        } else {
                            phi_321_ = _e202;
                            phi_346_ = type_13(0u, type_13().member_1);
                        }
                        let _e217 = phi_321_;
                        let _e219 = phi_346_;
                        let _e223 = (bitcast<i32>(_e219.member) != 0i);
                        if _e223 {
                            let _e224 = (_e219.member_1 < 16u);
                            if _e224 {
                            } else {
                                phi_1959_ = true;
                                break;
                            }
                            let _e228 = params.member.member_3[_e219.member_1];
                            if _e167 {
                                phi_505_ = 1.4142135f;
                                phi_506_ = vec3<f32>(_e228.x, _e228.y, _e228.z);
                            } else {
                                let _e233 = ((_e94 * 1664525u) + 1013904223u);
                                let _e235 = (((1u + _e219.member_1) * 1664525u) + 1013904223u);
                                let _e237 = (((_e166 * 1664525u) + 1013904223u) + (_e233 * 1013904223u));
                                let _e239 = (_e233 + (_e235 * _e237));
                                let _e241 = (_e235 + (_e237 * _e239));
                                let _e243 = (1013904223u + (_e239 * _e241));
                                let _e249 = (_e239 ^ (_e239 >> bitcast<u32>(16i)));
                                let _e252 = (_e241 ^ (_e241 >> bitcast<u32>(16i)));
                                let _e257 = ((_e237 ^ (_e237 >> bitcast<u32>(16i))) + (_e249 * (_e243 ^ (_e243 >> bitcast<u32>(16i)))));
                                let _e259 = (_e249 + (_e252 * _e257));
                                if _e224 {
                                } else {
                                    phi_1959_ = true;
                                    break;
                                }
                                let _e277 = params.member.member_4[_e219.member_1];
                                let _e282 = (_e277.y + ((_e277.x - _e277.y) * (f32((_e257 >> bitcast<u32>(8i))) * 0.000000059604645f)));
                                let _e287 = ((_e277.z + (_e277.w * (f32((_e259 >> bitcast<u32>(8i))) * 0.000000059604645f))) + _e196);
                                let _e291 = floor(((_e287 * 4f) + 0.5f));
                                let _e297 = ((((6.2831855f * _e287) - (_e291 * 1.5703125f)) - (_e291 * 0.0004837513f)) - (_e291 * 0.0000000754979f));
                                let _e298 = (_e297 * _e297);
                                let _e305 = (_e297 + ((_e297 * _e298) * (-0.16666655f + (_e298 * (0.008332161f + (_e298 * -0.00019515296f))))));
                                let _e314 = ((1f - (0.5f * _e298)) + ((_e298 * _e298) * (0.041666646f + (_e298 * (-0.0013887316f + (_e298 * 0.000024433157f))))));
                                let _e321 = select(0i, select(select(i32(_e291), i32(-2147483648), (_e291 < -2147483600f)), 2147483647i, (_e291 > 2147483500f)), (_e291 == _e291));
                                let _e323 = ((_e321 & 1i) == 0i);
                                let _e324 = select(_e314, _e305, _e323);
                                let _e325 = select(_e305, _e314, _e323);
                                if ((_e321 & 2i) == 0i) {
                                    phi_484_ = _e324;
                                } else {
                                    phi_484_ = -(_e324);
                                }
                                let _e330 = phi_484_;
                                if (((_e321 + 1i) & 2i) == 0i) {
                                    phi_492_ = _e325;
                                } else {
                                    phi_492_ = -(_e325);
                                }
                                let _e336 = phi_492_;
                                let _e337 = (1f - _e282);
                                let _e340 = sqrt(select(0f, _e337, (_e337 > 0f)));
                                phi_505_ = (1f + (f32(((_e252 + (_e257 * _e259)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                                phi_506_ = vec3<f32>((_e340 * _e336), (_e340 * _e330), sqrt(_e282));
                            }
                            let _e351 = phi_505_;
                            let _e353 = phi_506_;
                            let _e356 = params.member.member_11;
                            let _e359 = params.member.member_13;
                            let _e377 = ((((1f + (((_e148 * _e108[0]) * _e108[0]) * _e150)) * _e353.x) + (_e152 * _e353.y)) + (_e108[0] * _e353.z));
                            let _e378 = ((((_e148 * _e152) * _e353.x) + ((_e148 + ((_e108[1] * _e108[1]) * _e150)) * _e353.y)) + (_e108[1] * _e353.z));
                            let _e379 = ((((-(_e148) * _e108[0]) * _e353.x) + (-(_e108[1]) * _e353.y)) + (_e108[2] * _e353.z));
                            let _e382 = params.member.member_1;
                            let _e383 = abs(_e377);
                            let _e384 = abs(_e378);
                            let _e385 = abs(_e379);
                            if (_e383 >= _e384) {
                                phi_550_ = select(true, false, (_e383 >= _e385));
                            } else {
                                phi_550_ = true;
                            }
                            let _e390 = phi_550_;
                            if _e390 {
                                phi_559_ = select(2u, 1u, (_e384 >= _e385));
                            } else {
                                phi_559_ = 0u;
                            }
                            let _e394 = phi_559_;
                            let _e403 = (_e377 < 0f);
                            if _e403 {
                                phi_575_ = (i32(-(floor((0.5f - _e142)))) - 1i);
                            } else {
                                phi_575_ = (i32(floor((_e142 - 0.5f))) + 1i);
                            }
                            let _e407 = phi_575_;
                            if (((_e403 && (_e407 < 0i)) || ((_e377 >= 0f) && (_e407 >= bitcast<i32>(_e382.x)))) || (_e383 < 0.000001f)) {
                                phi_604_ = 340282350000000000000000000000000000000f;
                            } else {
                                phi_604_ = (((f32(_e407) + 0.5f) - _e142) / _e377);
                            }
                            let _e422 = phi_604_;
                            let _e432 = (_e378 < 0f);
                            if _e432 {
                                phi_621_ = (i32(-(floor((0.5f - _e143)))) - 1i);
                            } else {
                                phi_621_ = (i32(floor((_e143 - 0.5f))) + 1i);
                            }
                            let _e436 = phi_621_;
                            if (((_e432 && (_e436 < 0i)) || ((_e378 >= 0f) && (_e436 >= bitcast<i32>(_e382.y)))) || (_e384 < 0.000001f)) {
                                phi_650_ = 340282350000000000000000000000000000000f;
                            } else {
                                phi_650_ = (((f32(_e436) + 0.5f) - _e143) / _e378);
                            }
                            let _e451 = phi_650_;
                            let _e461 = (_e379 < 0f);
                            if _e461 {
                                phi_667_ = (i32(-(floor((0.5f - _e144)))) - 1i);
                            } else {
                                phi_667_ = (i32(floor((_e144 - 0.5f))) + 1i);
                            }
                            let _e465 = phi_667_;
                            if (((_e461 && (_e465 < 0i)) || ((_e379 >= 0f) && (_e465 >= bitcast<i32>(_e382.z)))) || (_e385 < 0.000001f)) {
                                phi_696_ = 340282350000000000000000000000000000000f;
                            } else {
                                phi_696_ = (((f32(_e465) + 0.5f) - _e144) / _e379);
                            }
                            let _e480 = phi_696_;
                            phi_699_ = vec3<f32>(0f, 0f, 0f);
                            phi_702_ = type_41(_e144, _e379, 0u, _e465, _e480);
                            phi_704_ = type_41(_e143, _e378, 0u, _e436, _e451);
                            phi_706_ = type_41(_e142, _e377, 0u, _e407, _e422);
                            phi_708_ = 0u;
                            phi_710_ = 0f;
                            phi_712_ = 1f;
                            loop {
                                let _e483 = phi_699_;
                                let _e485 = phi_702_;
                                let _e487 = phi_704_;
                                let _e489 = phi_706_;
                                let _e491 = phi_708_;
                                let _e493 = phi_710_;
                                let _e495 = phi_712_;
                                local_6 = _e493;
                                local_7 = _e495;
                                local_8 = _e483;
                                local_9 = _e483;
                                local_10 = _e483;
                                if (_e491 < 2048u) {
                                    if ((_e489.member_4 <= _e487.member_4) && (_e489.member_4 <= _e485.member_4)) {
                                        phi_738_ = 0u;
                                    } else {
                                        phi_738_ = select(2u, 1u, (_e487.member_4 <= _e485.member_4));
                                    }
                                    let _e507 = phi_738_;
                                    let _e508 = (_e507 == 0u);
                                    if _e508 {
                                        phi_763_ = _e489.member_4;
                                        phi_764_ = _e489.member_3;
                                        phi_765_ = _e489.member_2;
                                        phi_766_ = _e489.member_1;
                                    } else {
                                        let _e509 = (_e507 == 1u);
                                        if _e509 {
                                            phi_760_ = _e487.member_3;
                                            phi_761_ = _e487.member_2;
                                            phi_762_ = _e487.member_1;
                                        } else {
                                            phi_760_ = _e485.member_3;
                                            phi_761_ = _e485.member_2;
                                            phi_762_ = _e485.member_1;
                                        }
                                        let _e517 = phi_760_;
                                        let _e519 = phi_761_;
                                        let _e521 = phi_762_;
                                        phi_763_ = select(_e485.member_4, _e487.member_4, _e509);
                                        phi_764_ = _e517;
                                        phi_765_ = _e519;
                                        phi_766_ = _e521;
                                    }
                                    let _e527 = phi_763_;
                                    let _e529 = phi_764_;
                                    let _e531 = phi_765_;
                                    let _e533 = phi_766_;
                                    let _e535 = (1f - _e493);
                                    let _e536 = (_e495 * _e535);
                                    let _e538 = ((_e527 >= 340282350000000000000000000000000000000f) || (_e536 < 0.001f));
                                    if _e538 {
                                        phi_1855_ = vec3<f32>();
                                        phi_1856_ = type_41();
                                        phi_1857_ = type_41();
                                        phi_1858_ = type_41();
                                        phi_1859_ = f32();
                                        phi_1860_ = f32();
                                    } else {
                                        let _e545 = (_e533 < 0f);
                                        let _e549 = params.member.member_2[_e531];
                                        let _e550 = (_e531 & 31u);
                                        let _e552 = (1u << bitcast<u32>(_e550));
                                        let _e553 = (_e552 - 1u);
                                        let _e556 = ((_e382.x + _e553) >> bitcast<u32>(_e550));
                                        let _e559 = ((_e382.y + _e553) >> bitcast<u32>(_e550));
                                        let _e562 = ((_e382.z + _e553) >> bitcast<u32>(_e550));
                                        let _e564 = (1f / f32(_e552));
                                        if _e508 {
                                            phi_815_ = _e556;
                                        } else {
                                            phi_815_ = select(_e562, _e559, (_e507 == 1u));
                                        }
                                        let _e568 = phi_815_;
                                        if ((_e529 < 0i) || (_e529 >= bitcast<i32>(_e568))) {
                                            phi_1568_ = vec4<f32>(0f, 0f, 0f, 0f);
                                        } else {
                                            let _e573 = f32(_e529);
                                            if _e508 {
                                                phi_830_ = _e573;
                                            } else {
                                                phi_830_ = (((_e142 + (_e377 * _e527)) * _e564) - 0.5f);
                                            }
                                            let _e577 = phi_830_;
                                            let _e578 = floor(_e577);
                                            let _e580 = i32(_e578);
                                            let _e582 = (bitcast<i32>(_e556) - 1i);
                                            let _e587 = ((_e577 >= -0.5f) && (_e577 <= (f32(_e582) + 0.5f)));
                                            let _e589 = select(0i, _e580, (0i < _e580));
                                            let _e592 = bitcast<u32>(select(_e589, _e582, (_e582 < _e589)));
                                            let _e593 = (_e580 + 1i);
                                            let _e595 = select(0i, _e593, (0i < _e593));
                                            let _e598 = bitcast<u32>(select(_e595, _e582, (_e582 < _e595)));
                                            let _e602 = select(select(0f, (_e577 - _e578), (_e580 < _e582)), 1f, (_e580 < 0i));
                                            let _e604 = (_e592 >> bitcast<u32>(2u));
                                            let _e606 = (_e598 >> bitcast<u32>(2u));
                                            let _e613 = ((_e592 & 1u) | (((_e592 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                            let _e620 = ((_e598 & 1u) | (((_e598 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                            if _e587 {
                                                phi_912_ = (1f - _e602);
                                            } else {
                                                phi_912_ = 0f;
                                            }
                                            let _e623 = phi_912_;
                                            let _e624 = select(0f, _e602, _e587);
                                            let _e625 = (_e507 == 1u);
                                            if _e625 {
                                                phi_923_ = _e573;
                                            } else {
                                                phi_923_ = (((_e143 + (_e378 * _e527)) * _e564) - 0.5f);
                                            }
                                            let _e629 = phi_923_;
                                            let _e631 = floor(_e629);
                                            let _e633 = i32(_e631);
                                            let _e635 = (bitcast<i32>(_e559) - 1i);
                                            let _e640 = ((_e629 >= -0.5f) && (_e629 <= (f32(_e635) + 0.5f)));
                                            let _e642 = select(0i, _e633, (0i < _e633));
                                            let _e645 = bitcast<u32>(select(_e642, _e635, (_e635 < _e642)));
                                            let _e646 = (_e633 + 1i);
                                            let _e648 = select(0i, _e646, (0i < _e646));
                                            let _e651 = bitcast<u32>(select(_e648, _e635, (_e635 < _e648)));
                                            let _e655 = select(select(0f, (_e629 - _e631), (_e633 < _e635)), 1f, (_e633 < 0i));
                                            let _e658 = ((_e645 >> bitcast<u32>(2u)) * _e549.x);
                                            let _e661 = ((_e651 >> bitcast<u32>(2u)) * _e549.x);
                                            let _e670 = (((_e645 & 1u) << bitcast<u32>(1u)) | (((_e645 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                            let _e679 = (((_e651 & 1u) << bitcast<u32>(1u)) | (((_e651 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                            if _e640 {
                                                phi_1006_ = (1f - _e655);
                                            } else {
                                                phi_1006_ = 0f;
                                            }
                                            let _e682 = phi_1006_;
                                            let _e683 = select(0f, _e655, _e640);
                                            let _e684 = (_e507 == 2u);
                                            if _e684 {
                                                phi_1017_ = _e573;
                                            } else {
                                                phi_1017_ = (((_e144 + (_e379 * _e527)) * _e564) - 0.5f);
                                            }
                                            let _e688 = phi_1017_;
                                            let _e690 = floor(_e688);
                                            let _e692 = i32(_e690);
                                            let _e694 = (bitcast<i32>(_e562) - 1i);
                                            let _e699 = ((_e688 >= -0.5f) && (_e688 <= (f32(_e694) + 0.5f)));
                                            let _e701 = select(0i, _e692, (0i < _e692));
                                            let _e704 = bitcast<u32>(select(_e701, _e694, (_e694 < _e701)));
                                            let _e705 = (_e692 + 1i);
                                            let _e707 = select(0i, _e705, (0i < _e705));
                                            let _e710 = bitcast<u32>(select(_e707, _e694, (_e694 < _e707)));
                                            let _e714 = select(select(0f, (_e688 - _e690), (_e692 < _e694)), 1f, (_e692 < 0i));
                                            let _e717 = ((_e704 >> bitcast<u32>(1u)) * _e549.y);
                                            let _e720 = ((_e710 >> bitcast<u32>(1u)) * _e549.y);
                                            let _e723 = ((_e704 & 1u) << bitcast<u32>(2u));
                                            let _e726 = ((_e710 & 1u) << bitcast<u32>(2u));
                                            if _e699 {
                                                phi_1100_ = (1f - _e714);
                                            } else {
                                                phi_1100_ = 0f;
                                            }
                                            let _e729 = phi_1100_;
                                            let _e730 = select(0f, _e714, _e699);
                                            if _e508 {
                                                phi_1127_ = _e730;
                                                phi_1128_ = _e729;
                                                phi_1129_ = _e726;
                                                phi_1130_ = _e723;
                                                phi_1131_ = _e720;
                                                phi_1132_ = _e717;
                                                phi_1133_ = _e683;
                                                phi_1134_ = _e682;
                                                phi_1135_ = _e679;
                                                phi_1136_ = _e670;
                                                phi_1137_ = _e661;
                                                phi_1138_ = _e658;
                                                phi_1139_ = _e613;
                                                phi_1140_ = _e604;
                                            } else {
                                                phi_1127_ = select(_e683, _e624, _e625);
                                                phi_1128_ = select(_e682, _e623, _e625);
                                                phi_1129_ = select(_e679, _e620, _e625);
                                                phi_1130_ = select(_e670, _e613, _e625);
                                                phi_1131_ = select(_e661, _e606, _e625);
                                                phi_1132_ = select(_e658, _e604, _e625);
                                                phi_1133_ = select(_e624, _e730, _e625);
                                                phi_1134_ = select(_e623, _e729, _e625);
                                                phi_1135_ = select(_e620, _e726, _e625);
                                                phi_1136_ = select(_e613, _e723, _e625);
                                                phi_1137_ = select(_e606, _e720, _e625);
                                                phi_1138_ = select(_e604, _e717, _e625);
                                                phi_1139_ = select(_e723, _e670, _e625);
                                                phi_1140_ = select(_e717, _e658, _e625);
                                            }
                                            let _e746 = phi_1127_;
                                            let _e748 = phi_1128_;
                                            let _e750 = phi_1129_;
                                            let _e752 = phi_1130_;
                                            let _e754 = phi_1131_;
                                            let _e756 = phi_1132_;
                                            let _e758 = phi_1133_;
                                            let _e760 = phi_1134_;
                                            let _e762 = phi_1135_;
                                            let _e764 = phi_1136_;
                                            let _e766 = phi_1137_;
                                            let _e768 = phi_1138_;
                                            let _e770 = phi_1139_;
                                            let _e772 = phi_1140_;
                                            phi_1142_ = vec4<f32>(0f, 0f, 0f, 0f);
                                            phi_1145_ = 0u;
                                            loop {
                                                let _e774 = phi_1142_;
                                                let _e776 = phi_1145_;
                                                local_16 = _e774;
                                                let _e777 = (_e776 < 4u);
                                                if _e777 {
                                                    let _e779 = ((_e776 & 1u) == 1u);
                                                    let _e781 = ((_e776 & 2u) == 2u);
                                                    let _e784 = (select(_e760, _e758, _e779) * select(_e748, _e746, _e781));
                                                    let _e790 = (((_e549.z + _e772) + select(_e768, _e766, _e779)) + select(_e756, _e754, _e781));
                                                    let _e795 = (2u * _e790);
                                                    let _e797 = cells.member[_e795];
                                                    let _e799 = (((_e770 | select(_e764, _e762, _e779)) | select(_e752, _e750, _e781)) & 31u);
                                                    if ((_e784 > 0f) && (((_e797 >> bitcast<u32>(_e799)) & 1u) == 1u)) {
                                                        let _e807 = params.member.member_8;
                                                        let _e808 = (_e807 == 1u);
                                                        if (_e531 == 0u) {
                                                            let _e834 = (_e790 * 6u);
                                                            let _e837 = cells.member[(_e795 + 1u)];
                                                            let _e839 = facet_bits.member[_e834];
                                                            let _e842 = ((1u << bitcast<u32>(_e799)) - 1u);
                                                            let _e851 = facet_bits.member[(_e834 + 1u)];
                                                            let _e861 = facet_bits.member[(_e834 + 2u)];
                                                            let _e871 = facet_bits.member[(_e834 + 3u)];
                                                            let _e881 = facet_bits.member[(_e834 + 4u)];
                                                            let _e891 = facet_bits.member[(_e834 + 5u)];
                                                            let _e894 = ((((((_e837 + countOneBits((_e839 & _e842))) + countOneBits((_e851 & _e842))) + countOneBits((_e861 & _e842))) + countOneBits((_e871 & _e842))) + countOneBits((_e881 & _e842))) + countOneBits((_e891 & _e842)));
                                                            let _e898 = (((((((_e839 >> bitcast<u32>(_e799)) & 1u) + ((_e851 >> bitcast<u32>(_e799)) & 1u)) + ((_e861 >> bitcast<u32>(_e799)) & 1u)) + ((_e871 >> bitcast<u32>(_e799)) & 1u)) + ((_e881 >> bitcast<u32>(_e799)) & 1u)) + ((_e891 >> bitcast<u32>(_e799)) & 1u));
                                                            if _e808 {
                                                                phi_1299_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                phi_1302_ = _e894;
                                                                loop {
                                                                    let _e1001 = phi_1299_;
                                                                    let _e1003 = phi_1302_;
                                                                    local_15 = _e1001;
                                                                    let _e1005 = (_e1003 < (_e894 + _e898));
                                                                    if _e1005 {
                                                                        let _e1006 = (2u * _e1003);
                                                                        let _e1009 = radiance.member[_e1006][0u];
                                                                        let _e1012 = radiance.member[_e1006][1u];
                                                                        let _e1015 = radiance.member[_e1006][2u];
                                                                        let _e1016 = (_e1006 + 1u);
                                                                        let _e1019 = radiance.member[_e1016][0u];
                                                                        let _e1022 = radiance.member[_e1016][1u];
                                                                        let _e1025 = radiance.member[_e1016][2u];
                                                                        let _e1034 = facets.member[_e1003].member_2;
                                                                        let _e1043 = sqrt((((_e1034[0] * _e1034[0]) + (_e1034[1] * _e1034[1])) + (_e1034[2] * _e1034[2])));
                                                                        phi_1300_ = vec4<f32>((_e1001.x + (select(_e1019, _e1009, (_e1009 > _e1019)) * _e1043)), (_e1001.y + (select(_e1022, _e1012, (_e1012 > _e1022)) * _e1043)), (_e1001.z + (select(_e1025, _e1015, (_e1015 > _e1025)) * _e1043)), (_e1001.w + _e1043));
                                                                        phi_1303_ = (_e1003 + 1u);
                                                                    } else {
                                                                        phi_1300_ = vec4<f32>();
                                                                        phi_1303_ = u32();
                                                                    }
                                                                    let _e1058 = phi_1300_;
                                                                    let _e1060 = phi_1303_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1299_ = _e1058;
                                                                        phi_1302_ = _e1060;
                                                                        break if !(_e1005);
                                                                    }
                                                                }
                                                                let _e1547 = local_15;
                                                                phi_1498_ = _e1547;
                                                            } else {
                                                                let _e899 = select(1f, -1f, _e545);
                                                                phi_1398_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                phi_1401_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                phi_1403_ = _e894;
                                                                loop {
                                                                    let _e904 = phi_1398_;
                                                                    let _e906 = phi_1401_;
                                                                    let _e908 = phi_1403_;
                                                                    local = _e904;
                                                                    local_1 = _e906;
                                                                    local_2 = _e904;
                                                                    local_3 = _e904;
                                                                    local_4 = _e904;
                                                                    local_5 = _e906;
                                                                    local_14 = _e906;
                                                                    let _e910 = (_e908 < (_e894 + _e898));
                                                                    if _e910 {
                                                                        let _e913 = facets.member[_e908].member_2;
                                                                        let _e922 = -((((select(0f, _e899, _e508) * _e913[0]) + (select(0f, _e899, _e625) * _e913[1])) + (select(0f, _e899, _e684) * _e913[2])));
                                                                        if (_e922 > 0f) {
                                                                            let _e945 = radiance.member[(2u * _e908)];
                                                                            phi_1473_ = _e904;
                                                                            phi_1474_ = vec4<f32>((_e906.x + (_e945.x * _e922)), (_e906.y + (_e945.y * _e922)), (_e906.z + (_e945.z * _e922)), (_e906.w + _e922));
                                                                        } else {
                                                                            let _e927 = radiance.member[((2u * _e908) + 1u)];
                                                                            phi_1473_ = vec4<f32>((_e904.x - (_e927.x * _e922)), (_e904.y - (_e927.y * _e922)), (_e904.z - (_e927.z * _e922)), (_e904.w - _e922));
                                                                            phi_1474_ = _e906;
                                                                        }
                                                                        let _e962 = phi_1473_;
                                                                        let _e964 = phi_1474_;
                                                                        phi_1399_ = _e962;
                                                                        phi_1402_ = _e964;
                                                                        phi_1404_ = (_e908 + 1u);
                                                                    } else {
                                                                        phi_1399_ = vec4<f32>();
                                                                        phi_1402_ = vec4<f32>();
                                                                        phi_1404_ = u32();
                                                                    }
                                                                    let _e967 = phi_1399_;
                                                                    let _e969 = phi_1402_;
                                                                    let _e971 = phi_1404_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1398_ = _e967;
                                                                        phi_1401_ = _e969;
                                                                        phi_1403_ = _e971;
                                                                        break if !(_e910);
                                                                    }
                                                                }
                                                                let _e974 = local;
                                                                let _e977 = local_1;
                                                                if (_e974.w > _e977.w) {
                                                                    let _e980 = (_e974.w - _e977.w);
                                                                    let _e981 = (_e980 / _e974.w);
                                                                    let _e983 = local_2;
                                                                    let _e987 = local_3;
                                                                    let _e991 = local_4;
                                                                    let _e996 = local_5;
                                                                    phi_1497_ = (_e996 + vec4<f32>((_e983.x * _e981), (_e987.y * _e981), (_e991.z * _e981), _e980));
                                                                } else {
                                                                    let _e1540 = local_14;
                                                                    phi_1497_ = _e1540;
                                                                }
                                                                let _e999 = phi_1497_;
                                                                phi_1498_ = _e999;
                                                            }
                                                            let _e1063 = phi_1498_;
                                                            if (_e1063.w > 1f) {
                                                                phi_1512_ = vec4<f32>((_e1063.x / _e1063.w), (_e1063.y / _e1063.w), (_e1063.z / _e1063.w), 1f);
                                                            } else {
                                                                phi_1512_ = _e1063;
                                                            }
                                                            let _e1074 = phi_1512_;
                                                            phi_1545_ = _e1074;
                                                        } else {
                                                            let _e812 = cells.member[(_e795 + 1u)];
                                                            let _e818 = (_e812 + countOneBits((_e797 & ((1u << bitcast<u32>(_e799)) - 1u))));
                                                            if _e808 {
                                                                phi_1532_ = _e818;
                                                            } else {
                                                                phi_1532_ = (((6u * _e818) + (2u * _e507)) + select(0u, 1u, _e545));
                                                            }
                                                            let _e825 = phi_1532_;
                                                            if ((_e531 & 1u) == 1u) {
                                                                let _e831 = odd.member[_e825];
                                                                phi_1544_ = _e831;
                                                            } else {
                                                                let _e829 = even.member[_e825];
                                                                phi_1544_ = _e829;
                                                            }
                                                            let _e833 = phi_1544_;
                                                            phi_1545_ = _e833;
                                                        }
                                                        let _e1076 = phi_1545_;
                                                        phi_1566_ = vec4<f32>((_e774.x + (_e1076.x * _e784)), (_e774.y + (_e1076.y * _e784)), (_e774.z + (_e1076.z * _e784)), (_e774.w + (_e1076.w * _e784)));
                                                    } else {
                                                        phi_1566_ = _e774;
                                                    }
                                                    let _e1095 = phi_1566_;
                                                    phi_1143_ = _e1095;
                                                    phi_1146_ = (_e776 + 1u);
                                                } else {
                                                    phi_1143_ = vec4<f32>();
                                                    phi_1146_ = u32();
                                                }
                                                let _e1098 = phi_1143_;
                                                let _e1100 = phi_1146_;
                                                continue;
                                                continuing {
                                                    phi_1142_ = _e1098;
                                                    phi_1145_ = _e1100;
                                                    break if !(_e777);
                                                }
                                            }
                                            let _e1555 = local_16;
                                            phi_1568_ = _e1555;
                                        }
                                        let _e1103 = phi_1568_;
                                        if (_e1103.w > 0f) {
                                            let _e1110 = select(_e535, _e1103.w, (_e1103.w < _e535));
                                            let _e1115 = ((_e495 * _e1110) / _e1103.w);
                                            phi_1608_ = vec3<f32>((_e483.x + (_e1103.x * _e1115)), (_e483.y + (_e1103.y * _e1115)), (_e483.z + (_e1103.z * _e1115)));
                                            phi_1609_ = (_e493 + _e1110);
                                            phi_1610_ = _e495;
                                        } else {
                                            let _e1106 = (_e507 == _e394);
                                            phi_1608_ = _e483;
                                            phi_1609_ = select(_e493, 0f, _e1106);
                                            phi_1610_ = select(_e495, _e536, _e1106);
                                        }
                                        let _e1128 = phi_1608_;
                                        let _e1130 = phi_1609_;
                                        let _e1132 = phi_1610_;
                                        let _e1133 = (_e356 * _e527);
                                        let _e1135 = ((_e359 * _e138) + ((_e359 * _e353.z) * _e527));
                                        let _e1137 = select(_e1135, _e1133, (_e1133 < _e1135));
                                        let _e1144 = ((bitcast<u32>((select(1f, _e1137, (_e1137 > 1f)) * _e351)) >> bitcast<u32>(23i)) - 127u);
                                        let _e1146 = (_e382.w - 1u);
                                        let _e1148 = select(_e1144, _e1146, (_e1146 < _e1144));
                                        if _e508 {
                                            let _e1299 = (_e489.member_1 < 0f);
                                            if _e1299 {
                                                phi_1653_ = (_e489.member_3 - 1i);
                                            } else {
                                                phi_1653_ = (_e489.member_3 + 1i);
                                            }
                                            let _e1307 = phi_1653_;
                                            let _e1313 = type_41(_e489.member, _e489.member_1, _e489.member_2, _e1307, _e489.member_4);
                                            if ((((_e489.member_3 & 1i) == 0i) == _e1299) && (_e1148 > _e489.member_2)) {
                                                let _e1323 = type_41(_e1313.member, _e1313.member_1, (_e489.member_2 + 1u), _e1313.member_3, _e1313.member_4);
                                                phi_1666_ = type_41(_e1323.member, _e1323.member_1, _e1323.member_2, (_e1307 >> bitcast<u32>(1i)), _e1323.member_4);
                                            } else {
                                                phi_1666_ = _e1313;
                                            }
                                            let _e1333 = phi_1666_;
                                            let _e1335 = (_e1333.member_2 & 31u);
                                            let _e1337 = (1u << bitcast<u32>(_e1335));
                                            if ((((_e1333.member_1 < 0f) && (_e1333.member_3 < 0i)) || ((_e1333.member_1 >= 0f) && (_e1333.member_3 >= bitcast<i32>((((_e382.x + _e1337) - 1u) >> bitcast<u32>(_e1335)))))) || (abs(_e1333.member_1) < 0.000001f)) {
                                                phi_1706_ = 340282350000000000000000000000000000000f;
                                            } else {
                                                phi_1706_ = ((((f32(_e1333.member_3) + 0.5f) * f32(_e1337)) - _e1333.member) / _e1333.member_1);
                                            }
                                            let _e1363 = phi_1706_;
                                            phi_1852_ = _e485;
                                            phi_1853_ = _e487;
                                            phi_1854_ = type_41(_e1333.member, _e1333.member_1, _e1333.member_2, _e1333.member_3, _e1363);
                                        } else {
                                            if (_e507 == 1u) {
                                                let _e1223 = (_e487.member_1 < 0f);
                                                if _e1223 {
                                                    phi_1726_ = (_e487.member_3 - 1i);
                                                } else {
                                                    phi_1726_ = (_e487.member_3 + 1i);
                                                }
                                                let _e1231 = phi_1726_;
                                                let _e1237 = type_41(_e487.member, _e487.member_1, _e487.member_2, _e1231, _e487.member_4);
                                                if ((((_e487.member_3 & 1i) == 0i) == _e1223) && (_e1148 > _e487.member_2)) {
                                                    let _e1247 = type_41(_e1237.member, _e1237.member_1, (_e487.member_2 + 1u), _e1237.member_3, _e1237.member_4);
                                                    phi_1739_ = type_41(_e1247.member, _e1247.member_1, _e1247.member_2, (_e1231 >> bitcast<u32>(1i)), _e1247.member_4);
                                                } else {
                                                    phi_1739_ = _e1237;
                                                }
                                                let _e1257 = phi_1739_;
                                                let _e1259 = (_e1257.member_2 & 31u);
                                                let _e1261 = (1u << bitcast<u32>(_e1259));
                                                if ((((_e1257.member_1 < 0f) && (_e1257.member_3 < 0i)) || ((_e1257.member_1 >= 0f) && (_e1257.member_3 >= bitcast<i32>((((_e382.y + _e1261) - 1u) >> bitcast<u32>(_e1259)))))) || (abs(_e1257.member_1) < 0.000001f)) {
                                                    phi_1779_ = 340282350000000000000000000000000000000f;
                                                } else {
                                                    phi_1779_ = ((((f32(_e1257.member_3) + 0.5f) * f32(_e1261)) - _e1257.member) / _e1257.member_1);
                                                }
                                                let _e1287 = phi_1779_;
                                                phi_1850_ = _e485;
                                                phi_1851_ = type_41(_e1257.member, _e1257.member_1, _e1257.member_2, _e1257.member_3, _e1287);
                                            } else {
                                                let _e1151 = (_e485.member_1 < 0f);
                                                if _e1151 {
                                                    phi_1795_ = (_e485.member_3 - 1i);
                                                } else {
                                                    phi_1795_ = (_e485.member_3 + 1i);
                                                }
                                                let _e1159 = phi_1795_;
                                                let _e1165 = type_41(_e485.member, _e485.member_1, _e485.member_2, _e1159, _e485.member_4);
                                                if ((((_e485.member_3 & 1i) == 0i) == _e1151) && (_e1148 > _e485.member_2)) {
                                                    let _e1175 = type_41(_e1165.member, _e1165.member_1, (_e485.member_2 + 1u), _e1165.member_3, _e1165.member_4);
                                                    phi_1808_ = type_41(_e1175.member, _e1175.member_1, _e1175.member_2, (_e1159 >> bitcast<u32>(1i)), _e1175.member_4);
                                                } else {
                                                    phi_1808_ = _e1165;
                                                }
                                                let _e1185 = phi_1808_;
                                                let _e1187 = (_e1185.member_2 & 31u);
                                                let _e1189 = (1u << bitcast<u32>(_e1187));
                                                if ((((_e1185.member_1 < 0f) && (_e1185.member_3 < 0i)) || ((_e1185.member_1 >= 0f) && (_e1185.member_3 >= bitcast<i32>((((_e382.z + _e1189) - 1u) >> bitcast<u32>(_e1187)))))) || (abs(_e1185.member_1) < 0.000001f)) {
                                                    phi_1848_ = 340282350000000000000000000000000000000f;
                                                } else {
                                                    phi_1848_ = ((((f32(_e1185.member_3) + 0.5f) * f32(_e1189)) - _e1185.member) / _e1185.member_1);
                                                }
                                                let _e1215 = phi_1848_;
                                                phi_1850_ = type_41(_e1185.member, _e1185.member_1, _e1185.member_2, _e1185.member_3, _e1215);
                                                phi_1851_ = _e487;
                                            }
                                            let _e1295 = phi_1850_;
                                            let _e1297 = phi_1851_;
                                            phi_1852_ = _e1295;
                                            phi_1853_ = _e1297;
                                            phi_1854_ = _e489;
                                        }
                                        let _e1371 = phi_1852_;
                                        let _e1373 = phi_1853_;
                                        let _e1375 = phi_1854_;
                                        phi_1855_ = _e1128;
                                        phi_1856_ = _e1371;
                                        phi_1857_ = _e1373;
                                        phi_1858_ = _e1375;
                                        phi_1859_ = _e1130;
                                        phi_1860_ = _e1132;
                                    }
                                    let _e1377 = phi_1855_;
                                    let _e1379 = phi_1856_;
                                    let _e1381 = phi_1857_;
                                    let _e1383 = phi_1858_;
                                    let _e1385 = phi_1859_;
                                    let _e1387 = phi_1860_;
                                    phi_700_ = _e1377;
                                    phi_703_ = _e1379;
                                    phi_705_ = _e1381;
                                    phi_707_ = _e1383;
                                    phi_709_ = (_e491 + 1u);
                                    phi_711_ = _e1385;
                                    phi_713_ = _e1387;
                                    phi_1862_ = select(true, false, _e538);
                                } else {
                                    phi_700_ = vec3<f32>();
                                    phi_703_ = type_41();
                                    phi_705_ = type_41();
                                    phi_707_ = type_41();
                                    phi_709_ = u32();
                                    phi_711_ = f32();
                                    phi_713_ = f32();
                                    phi_1862_ = false;
                                }
                                let _e1390 = phi_700_;
                                let _e1392 = phi_703_;
                                let _e1394 = phi_705_;
                                let _e1396 = phi_707_;
                                let _e1398 = phi_709_;
                                let _e1400 = phi_711_;
                                let _e1402 = phi_713_;
                                let _e1404 = phi_1862_;
                                continue;
                                continuing {
                                    phi_699_ = _e1390;
                                    phi_702_ = _e1392;
                                    phi_704_ = _e1394;
                                    phi_706_ = _e1396;
                                    phi_708_ = _e1398;
                                    phi_710_ = _e1400;
                                    phi_712_ = _e1402;
                                    break if !(_e1404);
                                }
                            }
                            let _e1407 = local_6;
                            let _e1410 = local_7;
                            let _e1411 = (_e1410 * (1f - _e1407));
                            let _e1413 = local_8;
                            let _e1416 = local_9;
                            let _e1419 = local_10;
                            let _e1423 = params.member.member_5;
                            phi_324_ = vec3<f32>((_e204.x + ((_e1413.x + (_e1423.x * _e1411)) * _e228.w)), (_e204.y + ((_e1416.y + (_e1423.y * _e1411)) * _e228.w)), (_e204.z + ((_e1419.z + (_e1423.z * _e1411)) * _e228.w)));
                        } else {
                            phi_324_ = vec3<f32>();
                        }
                        let _e1445 = phi_324_;
                        continue;
                        continuing {
                            phi_320_ = _e217;
                            phi_323_ = _e1445;
                            phi_1959_ = false;
                            break if !(_e223);
                        }
                    }
                    let _e1448 = phi_1959_;
                    if _e1448 {
                        break;
                    }
                    let _e1450 = local_11;
                    let _e1454 = local_12;
                    let _e1458 = local_13;
                    phi_1903_ = vec4<f32>((_e1450.x * 3.1415927f), (_e1454.y * 3.1415927f), (_e1458.z * 3.1415927f), 0f);
                }
                let _e1463 = phi_1903_;
                if (_e94 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e94] = _e1463;
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
