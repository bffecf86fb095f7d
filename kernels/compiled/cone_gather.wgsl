struct type_8 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
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

struct type_29 {
    member: array<vec4<f32>>,
}

struct type_33 {
    member: array<type_25>,
}

struct type_37 {
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

struct type_38 {
    member: type_37,
}

struct type_40 {
    member: u32,
    member_1: i32,
    member_2: f32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_38;
@group(0) @binding(1) 
var<storage> cells: type_8;
@group(0) @binding(2) 
var<storage> facet_bits: type_8;
@group(0) @binding(3) 
var<storage> facets: type_19;
@group(0) @binding(4) 
var<storage> radiance: type_29;
@group(0) @binding(5) 
var<storage> odd: type_29;
@group(0) @binding(6) 
var<storage> even: type_29;
@group(0) @binding(7) 
var<storage> surfels: type_33;
@group(0) @binding(8) 
var<storage, read_write> out: type_29;

fn function_() {
    var phi_315_: f32;
    var phi_320_: type_12;
    var phi_323_: vec3<f32>;
    var phi_321_: type_12;
    var phi_346_: type_12;
    var phi_484_: f32;
    var phi_492_: f32;
    var phi_505_: f32;
    var phi_506_: vec3<f32>;
    var phi_550_: bool;
    var phi_559_: u32;
    var phi_577_: i32;
    var phi_591_: bool;
    var phi_622_: i32;
    var phi_636_: bool;
    var phi_667_: i32;
    var phi_681_: bool;
    var phi_732_: vec3<f32>;
    var phi_735_: type_40;
    var phi_737_: u32;
    var phi_739_: u32;
    var phi_741_: f32;
    var phi_743_: f32;
    var phi_745_: type_40;
    var phi_747_: type_40;
    var phi_749_: type_40;
    var phi_1017_: f32;
    var phi_1147_: f32;
    var phi_1153_: vec4<f32>;
    var phi_1156_: u32;
    var phi_1506_: u32;
    var phi_1518_: vec4<f32>;
    var phi_1322_: vec4<f32>;
    var phi_1325_: vec4<f32>;
    var phi_1327_: u32;
    var phi_1323_: vec4<f32>;
    var phi_1326_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1472_: vec4<f32>;
    var phi_1486_: vec4<f32>;
    var phi_1519_: vec4<f32>;
    var phi_1154_: vec4<f32>;
    var phi_1545_: vec4<f32>;
    var phi_1585_: vec3<f32>;
    var phi_1586_: f32;
    var phi_1587_: f32;
    var phi_1629_: i32;
    var phi_1647_: bool;
    var phi_1668_: u32;
    var phi_1673_: i32;
    var phi_1678_: f32;
    var phi_1685_: u32;
    var phi_1690_: i32;
    var phi_1695_: f32;
    var phi_1702_: u32;
    var phi_1707_: i32;
    var phi_1712_: f32;
    var phi_733_: vec3<f32>;
    var phi_736_: type_40;
    var phi_738_: u32;
    var phi_740_: u32;
    var phi_742_: f32;
    var phi_744_: f32;
    var phi_746_: type_40;
    var phi_748_: type_40;
    var phi_750_: type_40;
    var local_6: vec3<f32>;
    var local_7: vec3<f32>;
    var local_8: vec3<f32>;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var phi_324_: vec3<f32>;
    var phi_1843_: bool;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: vec3<f32>;
    var phi_1787_: vec4<f32>;
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
                    phi_1787_ = vec4<f32>(0f, 0f, 0f, 0f);
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
                    phi_320_ = type_12(0u, _e199);
                    phi_323_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e202 = phi_320_;
                        let _e204 = phi_323_;
                        local_12 = _e204;
                        local_13 = _e204;
                        local_14 = _e204;
                        if (_e202.member < _e202.member_1) {
                            phi_321_ = type_12((_e202.member + 1u), _e202.member_1);
                            phi_346_ = type_12(1u, _e202.member);
                        } else {
                            phi_321_ = _e202;
                            phi_346_ = type_12(0u, type_12().member_1);
                        }
                        let _e217 = phi_321_;
                        let _e219 = phi_346_;
                        let _e223 = (bitcast<i32>(_e219.member) != 0i);
                        if _e223 {
                            let _e224 = (_e219.member_1 < 16u);
                            if _e224 {
                            } else {
                                phi_1843_ = true;
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
                                    phi_1843_ = true;
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
                            let _e405 = (_e377 < 0f);
                            if _e405 {
                                phi_577_ = (i32(-(floor((0.5f - _e142)))) - 1i);
                            } else {
                                phi_577_ = (i32(floor((_e142 - 0.5f))) + 1i);
                            }
                            let _e409 = phi_577_;
                            if _e405 {
                                phi_591_ = (_e409 < 0i);
                            } else {
                                phi_591_ = (_e409 >= bitcast<i32>(_e382.x));
                            }
                            let _e414 = phi_591_;
                            let _e421 = select((((f32(_e409) + 0.5f) - _e142) / _e377), 340282350000000000000000000000000000000f, (_e414 || (_e383 < 0.000001f)));
                            let _e430 = (_e378 < 0f);
                            if _e430 {
                                phi_622_ = (i32(-(floor((0.5f - _e143)))) - 1i);
                            } else {
                                phi_622_ = (i32(floor((_e143 - 0.5f))) + 1i);
                            }
                            let _e434 = phi_622_;
                            if _e430 {
                                phi_636_ = (_e434 < 0i);
                            } else {
                                phi_636_ = (_e434 >= bitcast<i32>(_e382.y));
                            }
                            let _e439 = phi_636_;
                            let _e446 = select((((f32(_e434) + 0.5f) - _e143) / _e378), 340282350000000000000000000000000000000f, (_e439 || (_e384 < 0.000001f)));
                            let _e455 = (_e379 < 0f);
                            if _e455 {
                                phi_667_ = (i32(-(floor((0.5f - _e144)))) - 1i);
                            } else {
                                phi_667_ = (i32(floor((_e144 - 0.5f))) + 1i);
                            }
                            let _e459 = phi_667_;
                            if _e455 {
                                phi_681_ = (_e459 < 0i);
                            } else {
                                phi_681_ = (_e459 >= bitcast<i32>(_e382.z));
                            }
                            let _e464 = phi_681_;
                            let _e471 = select((((f32(_e459) + 0.5f) - _e144) / _e379), 340282350000000000000000000000000000000f, (_e464 || (_e385 < 0.000001f)));
                            let _e475 = ((_e421 <= _e446) && (_e421 <= _e471));
                            let _e476 = (_e446 <= _e471);
                            phi_732_ = vec3<f32>(0f, 0f, 0f);
                            phi_735_ = type_40(0u, select(select(_e459, _e434, _e476), _e409, _e475), select(select(_e471, _e446, _e476), _e421, _e475));
                            phi_737_ = select(select(2u, 1u, _e476), 0u, _e475);
                            phi_739_ = 0u;
                            phi_741_ = 0f;
                            phi_743_ = 1f;
                            phi_745_ = type_40(0u, _e459, _e471);
                            phi_747_ = type_40(0u, _e434, _e446);
                            phi_749_ = type_40(0u, _e409, _e421);
                            loop {
                                let _e485 = phi_732_;
                                let _e487 = phi_735_;
                                let _e489 = phi_737_;
                                let _e491 = phi_739_;
                                let _e493 = phi_741_;
                                let _e495 = phi_743_;
                                let _e497 = phi_745_;
                                let _e499 = phi_747_;
                                let _e501 = phi_749_;
                                local_6 = _e485;
                                local_7 = _e485;
                                local_8 = _e485;
                                let _e506 = (1f - _e493);
                                let _e507 = (_e495 * _e506);
                                let _e509 = (((_e491 < 2048u) && (_e487.member_2 < 340282350000000000000000000000000000000f)) && (_e507 >= 0.001f));
                                local_9 = _e507;
                                local_10 = _e507;
                                local_11 = _e507;
                                if _e509 {
                                    let _e511 = (_e489 == 0u);
                                    let _e513 = (_e489 == 2u);
                                    let _e516 = select(select(_e378, _e377, _e511), _e379, _e513);
                                    let _e527 = (_e516 < 0f);
                                    let _e531 = params.member.member_2[_e487.member];
                                    let _e532 = (_e487.member & 31u);
                                    let _e534 = (1u << bitcast<u32>(_e532));
                                    let _e535 = (_e534 - 1u);
                                    let _e538 = ((_e382.x + _e535) >> bitcast<u32>(_e532));
                                    let _e541 = ((_e382.y + _e535) >> bitcast<u32>(_e532));
                                    let _e544 = ((_e382.z + _e535) >> bitcast<u32>(_e532));
                                    if ((_e487.member_1 < 0i) || (_e487.member_1 >= bitcast<i32>(select(select(_e541, _e538, _e511), _e544, _e513)))) {
                                        phi_1545_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    } else {
                                        let _e552 = (1f / f32(_e534));
                                        let _e554 = (((_e142 + (_e377 * _e487.member_2)) * _e552) - 0.5f);
                                        let _e556 = (((_e143 + (_e378 * _e487.member_2)) * _e552) - 0.5f);
                                        let _e558 = (((_e144 + (_e379 * _e487.member_2)) * _e552) - 0.5f);
                                        let _e559 = bitcast<u32>(_e487.member_1);
                                        let _e584 = select(select(_e558, _e556, _e511), _e554, _e513);
                                        let _e588 = select(select(1u, 2u, _e511), 2u, _e513);
                                        let _e590 = select(select(_e531.y, _e531.x, _e511), 1u, _e513);
                                        let _e591 = select(2u, 1u, _e511);
                                        let _e592 = select(_e591, 0u, _e513);
                                        let _e593 = floor(_e584);
                                        let _e595 = i32(_e593);
                                        let _e597 = (bitcast<i32>(select(select(_e544, _e541, _e511), _e538, _e513)) - 1i);
                                        let _e602 = ((_e584 >= -0.5f) && (_e584 <= (f32(_e597) + 0.5f)));
                                        let _e604 = select(0i, _e595, (0i < _e595));
                                        let _e607 = bitcast<u32>(select(_e604, _e597, (_e597 < _e604)));
                                        let _e608 = (_e595 + 1i);
                                        let _e610 = select(0i, _e608, (0i < _e608));
                                        let _e613 = bitcast<u32>(select(_e610, _e597, (_e597 < _e610)));
                                        let _e617 = select(select(0f, (_e584 - _e593), (_e595 < _e597)), 1f, (_e595 < 0i));
                                        let _e618 = (_e588 & 31u);
                                        let _e626 = (_e592 & 31u);
                                        let _e631 = (_e588 - 1u);
                                        let _e634 = ((_e592 + 3u) & 31u);
                                        if _e602 {
                                            phi_1017_ = (1f - _e617);
                                        } else {
                                            phi_1017_ = 0f;
                                        }
                                        let _e649 = phi_1017_;
                                        let _e652 = select(select(_e554, _e558, _e511), _e556, _e513);
                                        let _e655 = select(_e591, 2u, _e513);
                                        let _e657 = select(select(1u, _e531.y, _e511), _e531.x, _e513);
                                        let _e659 = select(select(0u, 2u, _e511), 1u, _e513);
                                        let _e660 = floor(_e652);
                                        let _e662 = i32(_e660);
                                        let _e664 = (bitcast<i32>(select(select(_e538, _e544, _e511), _e541, _e513)) - 1i);
                                        let _e669 = ((_e652 >= -0.5f) && (_e652 <= (f32(_e664) + 0.5f)));
                                        let _e671 = select(0i, _e662, (0i < _e662));
                                        let _e674 = bitcast<u32>(select(_e671, _e664, (_e664 < _e671)));
                                        let _e675 = (_e662 + 1i);
                                        let _e677 = select(0i, _e675, (0i < _e675));
                                        let _e680 = bitcast<u32>(select(_e677, _e664, (_e664 < _e677)));
                                        let _e684 = select(select(0f, (_e652 - _e660), (_e662 < _e664)), 1f, (_e662 < 0i));
                                        let _e685 = (_e655 & 31u);
                                        let _e693 = (_e659 & 31u);
                                        let _e698 = (_e655 - 1u);
                                        let _e701 = ((_e659 + 3u) & 31u);
                                        if _e669 {
                                            phi_1147_ = (1f - _e684);
                                        } else {
                                            phi_1147_ = 0f;
                                        }
                                        let _e716 = phi_1147_;
                                        phi_1153_ = vec4<f32>(0f, 0f, 0f, 0f);
                                        phi_1156_ = 0u;
                                        loop {
                                            let _e719 = phi_1153_;
                                            let _e721 = phi_1156_;
                                            let _e723 = ((_e721 & 1u) == 1u);
                                            let _e725 = ((_e721 & 2u) == 2u);
                                            let _e728 = (select(_e649, select(0f, _e617, _e602), _e723) * select(_e716, select(0f, _e684, _e669), _e725));
                                            let _e734 = (((_e531.z + ((_e559 >> bitcast<u32>((select(2i, 1i, _e513) & 31i))) * select(select(_e531.x, 1u, _e511), _e531.y, _e513))) + select(((_e607 >> bitcast<u32>(_e618)) * _e590), ((_e613 >> bitcast<u32>(_e618)) * _e590), _e723)) + select(((_e674 >> bitcast<u32>(_e685)) * _e657), ((_e680 >> bitcast<u32>(_e685)) * _e657), _e725));
                                            let _e739 = (2u * _e734);
                                            let _e741 = cells.member[_e739];
                                            let _e743 = ((((((_e559 & 1u) << bitcast<u32>((_e489 & 31u))) | (((_e559 >> bitcast<u32>(1i)) & (select(2u, 1u, _e513) - 1u)) << bitcast<u32>(((_e489 + 3u) & 31u)))) | select((((_e607 & 1u) << bitcast<u32>(_e626)) | (((_e607 >> bitcast<u32>(1i)) & _e631) << bitcast<u32>(_e634))), (((_e613 & 1u) << bitcast<u32>(_e626)) | (((_e613 >> bitcast<u32>(1i)) & _e631) << bitcast<u32>(_e634))), _e723)) | select((((_e674 & 1u) << bitcast<u32>(_e693)) | (((_e674 >> bitcast<u32>(1i)) & _e698) << bitcast<u32>(_e701))), (((_e680 & 1u) << bitcast<u32>(_e693)) | (((_e680 >> bitcast<u32>(1i)) & _e698) << bitcast<u32>(_e701))), _e725)) & 31u);
                                            if ((_e728 > 0f) && (((_e741 >> bitcast<u32>(_e743)) & 1u) == 1u)) {
                                                let _e751 = params.member.member_8;
                                                let _e752 = (_e751 == 1u);
                                                if (_e487.member == 0u) {
                                                    let _e778 = (_e734 * 6u);
                                                    let _e781 = cells.member[(_e739 + 1u)];
                                                    let _e783 = facet_bits.member[_e778];
                                                    let _e786 = ((1u << bitcast<u32>(_e743)) - 1u);
                                                    let _e795 = facet_bits.member[(_e778 + 1u)];
                                                    let _e805 = facet_bits.member[(_e778 + 2u)];
                                                    let _e815 = facet_bits.member[(_e778 + 3u)];
                                                    let _e825 = facet_bits.member[(_e778 + 4u)];
                                                    let _e835 = facet_bits.member[(_e778 + 5u)];
                                                    let _e838 = ((((((_e781 + countOneBits((_e783 & _e786))) + countOneBits((_e795 & _e786))) + countOneBits((_e805 & _e786))) + countOneBits((_e815 & _e786))) + countOneBits((_e825 & _e786))) + countOneBits((_e835 & _e786)));
                                                    let _e843 = select(1f, -1f, _e527);
                                                    phi_1322_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                    phi_1325_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                    phi_1327_ = _e838;
                                                    loop {
                                                        let _e849 = phi_1322_;
                                                        let _e851 = phi_1325_;
                                                        let _e853 = phi_1327_;
                                                        let _e856 = facets.member[_e853].member_2;
                                                        let _e860 = (2u * _e853);
                                                        let _e862 = radiance.member[_e860];
                                                        let _e865 = radiance.member[(_e860 + 1u)];
                                                        let _e870 = (((select(0f, _e843, _e511) * _e856[0]) + (select(0f, _e843, (_e489 == 1u)) * _e856[1])) + (select(0f, _e843, _e513) * _e856[2]));
                                                        let _e871 = -(_e870);
                                                        if _e752 {
                                                            let _e923 = sqrt((((_e856[0] * _e856[0]) + (_e856[1] * _e856[1])) + (_e856[2] * _e856[2])));
                                                            phi_1323_ = _e849;
                                                            phi_1326_ = vec4<f32>((_e851.x + (select(_e865.x, _e862.x, (_e862.x > _e865.x)) * _e923)), (_e851.y + (select(_e865.y, _e862.y, (_e862.y > _e865.y)) * _e923)), (_e851.z + (select(_e865.z, _e862.z, (_e862.z > _e865.z)) * _e923)), (_e851.w + _e923));
                                                        } else {
                                                            let _e876 = select(0f, _e871, (_e871 > 0f));
                                                            let _e893 = select(0f, _e870, (_e870 > 0f));
                                                            phi_1323_ = vec4<f32>((_e849.x + (_e865.x * _e893)), (_e849.y + (_e865.y * _e893)), (_e849.z + (_e865.z * _e893)), (_e849.w + _e893));
                                                            phi_1326_ = vec4<f32>((_e851.x + (_e862.x * _e876)), (_e851.y + (_e862.y * _e876)), (_e851.z + (_e862.z * _e876)), (_e851.w + _e876));
                                                        }
                                                        let _e937 = phi_1323_;
                                                        let _e939 = phi_1326_;
                                                        let _e940 = (_e853 + 1u);
                                                        local = _e937;
                                                        local_1 = _e939;
                                                        local_2 = _e937;
                                                        local_3 = _e937;
                                                        local_4 = _e937;
                                                        local_5 = _e939;
                                                        local_15 = _e939;
                                                        continue;
                                                        continuing {
                                                            phi_1322_ = _e937;
                                                            phi_1325_ = _e939;
                                                            phi_1327_ = _e940;
                                                            break if !(select(true, false, (_e940 >= (_e838 + (((((((_e783 >> bitcast<u32>(_e743)) & 1u) + ((_e795 >> bitcast<u32>(_e743)) & 1u)) + ((_e805 >> bitcast<u32>(_e743)) & 1u)) + ((_e815 >> bitcast<u32>(_e743)) & 1u)) + ((_e825 >> bitcast<u32>(_e743)) & 1u)) + ((_e835 >> bitcast<u32>(_e743)) & 1u))))));
                                                        }
                                                    }
                                                    let _e946 = local;
                                                    let _e949 = local_1;
                                                    if (_e946.w > _e949.w) {
                                                        let _e952 = (_e946.w - _e949.w);
                                                        let _e953 = (_e952 / _e946.w);
                                                        let _e955 = local_2;
                                                        let _e959 = local_3;
                                                        let _e963 = local_4;
                                                        let _e968 = local_5;
                                                        phi_1472_ = (_e968 + vec4<f32>((_e955.x * _e953), (_e959.y * _e953), (_e963.z * _e953), _e952));
                                                    } else {
                                                        let _e1260 = local_15;
                                                        phi_1472_ = _e1260;
                                                    }
                                                    let _e971 = phi_1472_;
                                                    if (_e971.w > 1f) {
                                                        phi_1486_ = vec4<f32>((_e971.x / _e971.w), (_e971.y / _e971.w), (_e971.z / _e971.w), 1f);
                                                    } else {
                                                        phi_1486_ = _e971;
                                                    }
                                                    let _e982 = phi_1486_;
                                                    phi_1519_ = _e982;
                                                } else {
                                                    let _e756 = cells.member[(_e739 + 1u)];
                                                    let _e762 = (_e756 + countOneBits((_e741 & ((1u << bitcast<u32>(_e743)) - 1u))));
                                                    if _e752 {
                                                        phi_1506_ = _e762;
                                                    } else {
                                                        phi_1506_ = (((6u * _e762) + (2u * _e489)) + select(0u, 1u, _e527));
                                                    }
                                                    let _e769 = phi_1506_;
                                                    if ((_e487.member & 1u) == 1u) {
                                                        let _e775 = odd.member[_e769];
                                                        phi_1518_ = _e775;
                                                    } else {
                                                        let _e773 = even.member[_e769];
                                                        phi_1518_ = _e773;
                                                    }
                                                    let _e777 = phi_1518_;
                                                    phi_1519_ = _e777;
                                                }
                                                let _e984 = phi_1519_;
                                                phi_1154_ = vec4<f32>((_e719.x + (_e984.x * _e728)), (_e719.y + (_e984.y * _e728)), (_e719.z + (_e984.z * _e728)), (_e719.w + (_e984.w * _e728)));
                                            } else {
                                                phi_1154_ = _e719;
                                            }
                                            let _e1003 = phi_1154_;
                                            let _e1004 = (_e721 + 1u);
                                            local_16 = _e1003;
                                            continue;
                                            continuing {
                                                phi_1153_ = _e1003;
                                                phi_1156_ = _e1004;
                                                break if !(select(true, false, (_e1004 == 4u)));
                                            }
                                        }
                                        let _e1266 = local_16;
                                        phi_1545_ = _e1266;
                                    }
                                    let _e1009 = phi_1545_;
                                    if (_e1009.w > 0f) {
                                        let _e1016 = select(_e506, _e1009.w, (_e1009.w < _e506));
                                        let _e1021 = ((_e495 * _e1016) / _e1009.w);
                                        phi_1585_ = vec3<f32>((_e485.x + (_e1009.x * _e1021)), (_e485.y + (_e1009.y * _e1021)), (_e485.z + (_e1009.z * _e1021)));
                                        phi_1586_ = (_e493 + _e1016);
                                        phi_1587_ = _e495;
                                    } else {
                                        let _e1012 = (_e489 == _e394);
                                        phi_1585_ = _e485;
                                        phi_1586_ = select(_e493, 0f, _e1012);
                                        phi_1587_ = select(_e495, _e507, _e1012);
                                    }
                                    let _e1034 = phi_1585_;
                                    let _e1036 = phi_1586_;
                                    let _e1038 = phi_1587_;
                                    let _e1039 = (_e356 * _e487.member_2);
                                    let _e1041 = ((_e359 * _e138) + ((_e359 * _e353.z) * _e487.member_2));
                                    let _e1043 = select(_e1041, _e1039, (_e1039 < _e1041));
                                    let _e1050 = ((bitcast<u32>((select(1f, _e1043, (_e1043 > 1f)) * _e351)) >> bitcast<u32>(23i)) - 127u);
                                    let _e1052 = (_e382.w - 1u);
                                    let _e1060 = select(0u, 1u, ((((_e487.member_1 & 1i) == 0i) == _e527) && (select(_e1050, _e1052, (_e1052 < _e1050)) > _e487.member)));
                                    if _e527 {
                                        phi_1629_ = (_e487.member_1 - 1i);
                                    } else {
                                        phi_1629_ = (_e487.member_1 + 1i);
                                    }
                                    let _e1064 = phi_1629_;
                                    let _e1065 = (_e487.member + _e1060);
                                    let _e1068 = (_e1064 >> bitcast<u32>((_e1060 & 31u)));
                                    let _e1069 = (_e1065 & 31u);
                                    let _e1071 = (1u << bitcast<u32>(_e1069));
                                    if _e527 {
                                        phi_1647_ = (_e1068 < 0i);
                                    } else {
                                        phi_1647_ = (_e1068 >= bitcast<i32>((((select(select(_e382.y, _e382.x, _e511), _e382.z, _e513) + _e1071) - 1u) >> bitcast<u32>(_e1069))));
                                    }
                                    let _e1080 = phi_1647_;
                                    let _e1090 = select(((((f32(_e1068) + 0.5f) * f32(_e1071)) - select(select(_e143, _e142, _e511), _e144, _e513)) / _e516), 340282350000000000000000000000000000000f, (_e1080 || (abs(_e516) < 0.000001f)));
                                    if _e511 {
                                        phi_1668_ = _e1065;
                                    } else {
                                        phi_1668_ = _e501.member;
                                    }
                                    let _e1093 = phi_1668_;
                                    if _e511 {
                                        phi_1673_ = _e1068;
                                    } else {
                                        phi_1673_ = _e501.member_1;
                                    }
                                    let _e1096 = phi_1673_;
                                    if _e511 {
                                        phi_1678_ = _e1090;
                                    } else {
                                        phi_1678_ = _e501.member_2;
                                    }
                                    let _e1099 = phi_1678_;
                                    let _e1101 = (_e489 == 1u);
                                    if _e1101 {
                                        phi_1685_ = _e1065;
                                    } else {
                                        phi_1685_ = _e499.member;
                                    }
                                    let _e1104 = phi_1685_;
                                    if _e1101 {
                                        phi_1690_ = _e1068;
                                    } else {
                                        phi_1690_ = _e499.member_1;
                                    }
                                    let _e1107 = phi_1690_;
                                    if _e1101 {
                                        phi_1695_ = _e1090;
                                    } else {
                                        phi_1695_ = _e499.member_2;
                                    }
                                    let _e1110 = phi_1695_;
                                    if _e513 {
                                        phi_1702_ = _e1065;
                                    } else {
                                        phi_1702_ = _e497.member;
                                    }
                                    let _e1114 = phi_1702_;
                                    if _e513 {
                                        phi_1707_ = _e1068;
                                    } else {
                                        phi_1707_ = _e497.member_1;
                                    }
                                    let _e1117 = phi_1707_;
                                    if _e513 {
                                        phi_1712_ = _e1090;
                                    } else {
                                        phi_1712_ = _e497.member_2;
                                    }
                                    let _e1120 = phi_1712_;
                                    let _e1124 = ((_e1099 <= _e1110) && (_e1099 <= _e1120));
                                    let _e1125 = (_e1110 <= _e1120);
                                    phi_733_ = _e1034;
                                    phi_736_ = type_40(select(select(_e1114, _e1104, _e1125), _e1093, _e1124), select(select(_e1117, _e1107, _e1125), _e1096, _e1124), select(select(_e1120, _e1110, _e1125), _e1099, _e1124));
                                    phi_738_ = select(select(2u, 1u, _e1125), 0u, _e1124);
                                    phi_740_ = (_e491 + 1u);
                                    phi_742_ = _e1036;
                                    phi_744_ = _e1038;
                                    phi_746_ = type_40(_e1114, _e1117, _e1120);
                                    phi_748_ = type_40(_e1104, _e1107, _e1110);
                                    phi_750_ = type_40(_e1093, _e1096, _e1099);
                                } else {
                                    phi_733_ = vec3<f32>();
                                    phi_736_ = type_40();
                                    phi_738_ = u32();
                                    phi_740_ = u32();
                                    phi_742_ = f32();
                                    phi_744_ = f32();
                                    phi_746_ = type_40();
                                    phi_748_ = type_40();
                                    phi_750_ = type_40();
                                }
                                let _e1136 = phi_733_;
                                let _e1138 = phi_736_;
                                let _e1140 = phi_738_;
                                let _e1142 = phi_740_;
                                let _e1144 = phi_742_;
                                let _e1146 = phi_744_;
                                let _e1148 = phi_746_;
                                let _e1150 = phi_748_;
                                let _e1152 = phi_750_;
                                continue;
                                continuing {
                                    phi_732_ = _e1136;
                                    phi_735_ = _e1138;
                                    phi_737_ = _e1140;
                                    phi_739_ = _e1142;
                                    phi_741_ = _e1144;
                                    phi_743_ = _e1146;
                                    phi_745_ = _e1148;
                                    phi_747_ = _e1150;
                                    phi_749_ = _e1152;
                                    break if !(_e509);
                                }
                            }
                            let _e1155 = local_6;
                            let _e1158 = local_7;
                            let _e1161 = local_8;
                            let _e1165 = params.member.member_5;
                            let _e1170 = local_9;
                            let _e1173 = local_10;
                            let _e1176 = local_11;
                            phi_324_ = vec3<f32>((_e204.x + ((_e1155.x + (_e1165.x * _e1170)) * _e228.w)), (_e204.y + ((_e1158.y + (_e1165.y * _e1173)) * _e228.w)), (_e204.z + ((_e1161.z + (_e1165.z * _e1176)) * _e228.w)));
                        } else {
                            phi_324_ = vec3<f32>();
                        }
                        let _e1193 = phi_324_;
                        continue;
                        continuing {
                            phi_320_ = _e217;
                            phi_323_ = _e1193;
                            phi_1843_ = false;
                            break if !(_e223);
                        }
                    }
                    let _e1196 = phi_1843_;
                    if _e1196 {
                        break;
                    }
                    let _e1198 = local_12;
                    let _e1202 = local_13;
                    let _e1206 = local_14;
                    phi_1787_ = vec4<f32>((_e1198.x * 3.1415927f), (_e1202.y * 3.1415927f), (_e1206.z * 3.1415927f), 0f);
                }
                let _e1211 = phi_1787_;
                if (_e94 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e94] = _e1211;
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
