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
    var phi_316_: f32;
    var phi_321_: type_13;
    var phi_324_: vec3<f32>;
    var phi_322_: type_13;
    var phi_347_: type_13;
    var phi_485_: f32;
    var phi_493_: f32;
    var phi_506_: f32;
    var phi_507_: vec3<f32>;
    var phi_551_: bool;
    var phi_560_: u32;
    var phi_576_: i32;
    var phi_605_: f32;
    var phi_622_: i32;
    var phi_651_: f32;
    var phi_668_: i32;
    var phi_697_: f32;
    var phi_700_: vec3<f32>;
    var phi_703_: type_41;
    var phi_705_: type_41;
    var phi_707_: type_41;
    var phi_709_: u32;
    var phi_711_: f32;
    var phi_713_: f32;
    var phi_739_: u32;
    var phi_761_: i32;
    var phi_762_: u32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_765_: i32;
    var phi_766_: u32;
    var phi_767_: f32;
    var phi_992_: f32;
    var phi_1122_: f32;
    var phi_1128_: vec4<f32>;
    var phi_1131_: u32;
    var phi_1518_: u32;
    var phi_1530_: vec4<f32>;
    var phi_1384_: vec4<f32>;
    var phi_1387_: vec4<f32>;
    var phi_1389_: u32;
    var phi_1459_: vec4<f32>;
    var phi_1460_: vec4<f32>;
    var phi_1385_: vec4<f32>;
    var phi_1388_: vec4<f32>;
    var phi_1390_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1483_: vec4<f32>;
    var phi_1285_: vec4<f32>;
    var phi_1288_: u32;
    var phi_1286_: vec4<f32>;
    var phi_1289_: u32;
    var phi_1484_: vec4<f32>;
    var phi_1498_: vec4<f32>;
    var phi_1531_: vec4<f32>;
    var phi_1552_: vec4<f32>;
    var phi_1129_: vec4<f32>;
    var phi_1132_: u32;
    var phi_1554_: vec4<f32>;
    var phi_1594_: vec3<f32>;
    var phi_1595_: f32;
    var phi_1596_: f32;
    var phi_1781_: i32;
    var phi_1794_: type_41;
    var phi_1834_: f32;
    var phi_1712_: i32;
    var phi_1725_: type_41;
    var phi_1765_: f32;
    var phi_1836_: type_41;
    var phi_1837_: type_41;
    var phi_1639_: i32;
    var phi_1652_: type_41;
    var phi_1692_: f32;
    var phi_1838_: type_41;
    var phi_1839_: type_41;
    var phi_1840_: type_41;
    var phi_1841_: vec3<f32>;
    var phi_1842_: type_41;
    var phi_1843_: type_41;
    var phi_1844_: type_41;
    var phi_1845_: f32;
    var phi_1846_: f32;
    var phi_701_: vec3<f32>;
    var phi_704_: type_41;
    var phi_706_: type_41;
    var phi_708_: type_41;
    var phi_710_: u32;
    var phi_712_: f32;
    var phi_714_: f32;
    var phi_1848_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var phi_325_: vec3<f32>;
    var phi_1945_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var phi_1889_: vec4<f32>;
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
                    phi_1889_ = vec4<f32>(0f, 0f, 0f, 0f);
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
                        phi_316_ = 0f;
                    } else {
                        let _e172 = ((_e95 * 1664525u) + 1013904223u);
                        let _e174 = (((_e167 * 1664525u) + 1013904223u) + (_e172 * 1013904223u));
                        let _e176 = (_e172 + (1013904223u * _e174));
                        let _e180 = (1013904223u + (_e176 * (1013904223u + (_e174 * _e176))));
                        phi_316_ = (f32((((_e174 ^ (_e174 >> bitcast<u32>(16i))) + ((_e176 ^ (_e176 >> bitcast<u32>(16i))) * (_e180 ^ (_e180 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                    }
                    let _e197 = phi_316_;
                    let _e200 = params.member.member_7;
                    phi_321_ = type_13(0u, _e200);
                    phi_324_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e203 = phi_321_;
                        let _e205 = phi_324_;
                        local_11 = _e205;
                        local_12 = _e205;
                        local_13 = _e205;
                        if (_e203.member < _e203.member_1) {
                            phi_322_ = type_13((_e203.member + 1u), _e203.member_1);
                            phi_347_ = type_13(1u, _e203.member);
                        } else {
                            phi_322_ = _e203;
                            phi_347_ = type_13(0u, type_13().member_1);
                        }
                        let _e218 = phi_322_;
                        let _e220 = phi_347_;
                        let _e224 = (bitcast<i32>(_e220.member) != 0i);
                        if _e224 {
                            let _e225 = (_e220.member_1 < 16u);
                            if _e225 {
                            } else {
                                phi_1945_ = true;
                                break;
                            }
                            let _e229 = params.member.member_3[_e220.member_1];
                            if _e168 {
                                phi_506_ = 1.4142135f;
                                phi_507_ = vec3<f32>(_e229.x, _e229.y, _e229.z);
                            } else {
                                let _e234 = ((_e95 * 1664525u) + 1013904223u);
                                let _e236 = (((1u + _e220.member_1) * 1664525u) + 1013904223u);
                                let _e238 = (((_e167 * 1664525u) + 1013904223u) + (_e234 * 1013904223u));
                                let _e240 = (_e234 + (_e236 * _e238));
                                let _e242 = (_e236 + (_e238 * _e240));
                                let _e244 = (1013904223u + (_e240 * _e242));
                                let _e250 = (_e240 ^ (_e240 >> bitcast<u32>(16i)));
                                let _e253 = (_e242 ^ (_e242 >> bitcast<u32>(16i)));
                                let _e258 = ((_e238 ^ (_e238 >> bitcast<u32>(16i))) + (_e250 * (_e244 ^ (_e244 >> bitcast<u32>(16i)))));
                                let _e260 = (_e250 + (_e253 * _e258));
                                if _e225 {
                                } else {
                                    phi_1945_ = true;
                                    break;
                                }
                                let _e278 = params.member.member_4[_e220.member_1];
                                let _e283 = (_e278.y + ((_e278.x - _e278.y) * (f32((_e258 >> bitcast<u32>(8i))) * 0.000000059604645f)));
                                let _e288 = ((_e278.z + (_e278.w * (f32((_e260 >> bitcast<u32>(8i))) * 0.000000059604645f))) + _e197);
                                let _e292 = floor(((_e288 * 4f) + 0.5f));
                                let _e298 = ((((6.2831855f * _e288) - (_e292 * 1.5703125f)) - (_e292 * 0.0004837513f)) - (_e292 * 0.0000000754979f));
                                let _e299 = (_e298 * _e298);
                                let _e306 = (_e298 + ((_e298 * _e299) * (-0.16666655f + (_e299 * (0.008332161f + (_e299 * -0.00019515296f))))));
                                let _e315 = ((1f - (0.5f * _e299)) + ((_e299 * _e299) * (0.041666646f + (_e299 * (-0.0013887316f + (_e299 * 0.000024433157f))))));
                                let _e322 = select(0i, select(select(i32(_e292), i32(-2147483648), (_e292 < -2147483600f)), 2147483647i, (_e292 > 2147483500f)), (_e292 == _e292));
                                let _e324 = ((_e322 & 1i) == 0i);
                                let _e325 = select(_e315, _e306, _e324);
                                let _e326 = select(_e306, _e315, _e324);
                                if ((_e322 & 2i) == 0i) {
                                    phi_485_ = _e325;
                                } else {
                                    phi_485_ = -(_e325);
                                }
                                let _e331 = phi_485_;
                                if (((_e322 + 1i) & 2i) == 0i) {
                                    phi_493_ = _e326;
                                } else {
                                    phi_493_ = -(_e326);
                                }
                                let _e337 = phi_493_;
                                let _e338 = (1f - _e283);
                                let _e341 = sqrt(select(0f, _e338, (_e338 > 0f)));
                                phi_506_ = (1f + (f32(((_e253 + (_e258 * _e260)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                                phi_507_ = vec3<f32>((_e341 * _e337), (_e341 * _e331), sqrt(_e283));
                            }
                            let _e352 = phi_506_;
                            let _e354 = phi_507_;
                            let _e357 = params.member.member_11;
                            let _e360 = params.member.member_13;
                            let _e378 = ((((1f + (((_e149 * _e109[0]) * _e109[0]) * _e151)) * _e354.x) + (_e153 * _e354.y)) + (_e109[0] * _e354.z));
                            let _e379 = ((((_e149 * _e153) * _e354.x) + ((_e149 + ((_e109[1] * _e109[1]) * _e151)) * _e354.y)) + (_e109[1] * _e354.z));
                            let _e380 = ((((-(_e149) * _e109[0]) * _e354.x) + (-(_e109[1]) * _e354.y)) + (_e109[2] * _e354.z));
                            let _e383 = params.member.member_1;
                            let _e384 = abs(_e378);
                            let _e385 = abs(_e379);
                            let _e386 = abs(_e380);
                            if (_e384 >= _e385) {
                                phi_551_ = select(true, false, (_e384 >= _e386));
                            } else {
                                phi_551_ = true;
                            }
                            let _e391 = phi_551_;
                            if _e391 {
                                phi_560_ = select(2u, 1u, (_e385 >= _e386));
                            } else {
                                phi_560_ = 0u;
                            }
                            let _e395 = phi_560_;
                            let _e404 = (_e378 < 0f);
                            if _e404 {
                                phi_576_ = (i32(-(floor((0.5f - _e143)))) - 1i);
                            } else {
                                phi_576_ = (i32(floor((_e143 - 0.5f))) + 1i);
                            }
                            let _e408 = phi_576_;
                            if (((_e404 && (_e408 < 0i)) || ((_e378 >= 0f) && (_e408 >= bitcast<i32>(_e383.x)))) || (_e384 < 0.000001f)) {
                                phi_605_ = 340282350000000000000000000000000000000f;
                            } else {
                                phi_605_ = (((f32(_e408) + 0.5f) - _e143) / _e378);
                            }
                            let _e423 = phi_605_;
                            let _e433 = (_e379 < 0f);
                            if _e433 {
                                phi_622_ = (i32(-(floor((0.5f - _e144)))) - 1i);
                            } else {
                                phi_622_ = (i32(floor((_e144 - 0.5f))) + 1i);
                            }
                            let _e437 = phi_622_;
                            if (((_e433 && (_e437 < 0i)) || ((_e379 >= 0f) && (_e437 >= bitcast<i32>(_e383.y)))) || (_e385 < 0.000001f)) {
                                phi_651_ = 340282350000000000000000000000000000000f;
                            } else {
                                phi_651_ = (((f32(_e437) + 0.5f) - _e144) / _e379);
                            }
                            let _e452 = phi_651_;
                            let _e462 = (_e380 < 0f);
                            if _e462 {
                                phi_668_ = (i32(-(floor((0.5f - _e145)))) - 1i);
                            } else {
                                phi_668_ = (i32(floor((_e145 - 0.5f))) + 1i);
                            }
                            let _e466 = phi_668_;
                            if (((_e462 && (_e466 < 0i)) || ((_e380 >= 0f) && (_e466 >= bitcast<i32>(_e383.z)))) || (_e386 < 0.000001f)) {
                                phi_697_ = 340282350000000000000000000000000000000f;
                            } else {
                                phi_697_ = (((f32(_e466) + 0.5f) - _e145) / _e380);
                            }
                            let _e481 = phi_697_;
                            phi_700_ = vec3<f32>(0f, 0f, 0f);
                            phi_703_ = type_41(_e145, _e380, 0u, _e466, _e481);
                            phi_705_ = type_41(_e144, _e379, 0u, _e437, _e452);
                            phi_707_ = type_41(_e143, _e378, 0u, _e408, _e423);
                            phi_709_ = 0u;
                            phi_711_ = 0f;
                            phi_713_ = 1f;
                            loop {
                                let _e484 = phi_700_;
                                let _e486 = phi_703_;
                                let _e488 = phi_705_;
                                let _e490 = phi_707_;
                                let _e492 = phi_709_;
                                let _e494 = phi_711_;
                                let _e496 = phi_713_;
                                local_6 = _e494;
                                local_7 = _e496;
                                local_8 = _e484;
                                local_9 = _e484;
                                local_10 = _e484;
                                if (_e492 < 2048u) {
                                    if ((_e490.member_4 <= _e488.member_4) && (_e490.member_4 <= _e486.member_4)) {
                                        phi_739_ = 0u;
                                    } else {
                                        phi_739_ = select(2u, 1u, (_e488.member_4 <= _e486.member_4));
                                    }
                                    let _e508 = phi_739_;
                                    let _e509 = (_e508 == 0u);
                                    if _e509 {
                                        phi_764_ = _e490.member_4;
                                        phi_765_ = _e490.member_3;
                                        phi_766_ = _e490.member_2;
                                        phi_767_ = _e490.member_1;
                                    } else {
                                        let _e510 = (_e508 == 1u);
                                        if _e510 {
                                            phi_761_ = _e488.member_3;
                                            phi_762_ = _e488.member_2;
                                            phi_763_ = _e488.member_1;
                                        } else {
                                            phi_761_ = _e486.member_3;
                                            phi_762_ = _e486.member_2;
                                            phi_763_ = _e486.member_1;
                                        }
                                        let _e518 = phi_761_;
                                        let _e520 = phi_762_;
                                        let _e522 = phi_763_;
                                        phi_764_ = select(_e486.member_4, _e488.member_4, _e510);
                                        phi_765_ = _e518;
                                        phi_766_ = _e520;
                                        phi_767_ = _e522;
                                    }
                                    let _e528 = phi_764_;
                                    let _e530 = phi_765_;
                                    let _e532 = phi_766_;
                                    let _e534 = phi_767_;
                                    let _e536 = (1f - _e494);
                                    let _e537 = (_e496 * _e536);
                                    let _e539 = ((_e528 >= 340282350000000000000000000000000000000f) || (_e537 < 0.001f));
                                    if _e539 {
                                        phi_1841_ = vec3<f32>();
                                        phi_1842_ = type_41();
                                        phi_1843_ = type_41();
                                        phi_1844_ = type_41();
                                        phi_1845_ = f32();
                                        phi_1846_ = f32();
                                    } else {
                                        let _e546 = (_e534 < 0f);
                                        let _e550 = params.member.member_2[_e532];
                                        let _e551 = (_e532 & 31u);
                                        let _e553 = (1u << bitcast<u32>(_e551));
                                        let _e554 = (_e553 - 1u);
                                        let _e557 = ((_e383.x + _e554) >> bitcast<u32>(_e551));
                                        let _e560 = ((_e383.y + _e554) >> bitcast<u32>(_e551));
                                        let _e563 = ((_e383.z + _e554) >> bitcast<u32>(_e551));
                                        let _e566 = (_e508 == 2u);
                                        if ((_e530 < 0i) || (_e530 >= bitcast<i32>(select(select(_e560, _e557, _e509), _e563, _e566)))) {
                                            phi_1554_ = vec4<f32>(0f, 0f, 0f, 0f);
                                        } else {
                                            let _e572 = (1f / f32(_e553));
                                            let _e574 = (((_e143 + (_e378 * _e528)) * _e572) - 0.5f);
                                            let _e576 = (((_e144 + (_e379 * _e528)) * _e572) - 0.5f);
                                            let _e578 = (((_e145 + (_e380 * _e528)) * _e572) - 0.5f);
                                            let _e579 = bitcast<u32>(_e530);
                                            let _e604 = select(select(_e578, _e576, _e509), _e574, _e566);
                                            let _e608 = select(select(1u, 2u, _e509), 2u, _e566);
                                            let _e610 = select(select(_e550.y, _e550.x, _e509), 1u, _e566);
                                            let _e611 = select(2u, 1u, _e509);
                                            let _e612 = select(_e611, 0u, _e566);
                                            let _e613 = floor(_e604);
                                            let _e615 = i32(_e613);
                                            let _e617 = (bitcast<i32>(select(select(_e563, _e560, _e509), _e557, _e566)) - 1i);
                                            let _e622 = ((_e604 >= -0.5f) && (_e604 <= (f32(_e617) + 0.5f)));
                                            let _e624 = select(0i, _e615, (0i < _e615));
                                            let _e627 = bitcast<u32>(select(_e624, _e617, (_e617 < _e624)));
                                            let _e628 = (_e615 + 1i);
                                            let _e630 = select(0i, _e628, (0i < _e628));
                                            let _e633 = bitcast<u32>(select(_e630, _e617, (_e617 < _e630)));
                                            let _e637 = select(select(0f, (_e604 - _e613), (_e615 < _e617)), 1f, (_e615 < 0i));
                                            let _e638 = (_e608 & 31u);
                                            let _e646 = (_e612 & 31u);
                                            let _e651 = (_e608 - 1u);
                                            let _e654 = ((_e612 + 3u) & 31u);
                                            if _e622 {
                                                phi_992_ = (1f - _e637);
                                            } else {
                                                phi_992_ = 0f;
                                            }
                                            let _e669 = phi_992_;
                                            let _e672 = select(select(_e574, _e578, _e509), _e576, _e566);
                                            let _e675 = select(_e611, 2u, _e566);
                                            let _e677 = select(select(1u, _e550.y, _e509), _e550.x, _e566);
                                            let _e679 = select(select(0u, 2u, _e509), 1u, _e566);
                                            let _e680 = floor(_e672);
                                            let _e682 = i32(_e680);
                                            let _e684 = (bitcast<i32>(select(select(_e557, _e563, _e509), _e560, _e566)) - 1i);
                                            let _e689 = ((_e672 >= -0.5f) && (_e672 <= (f32(_e684) + 0.5f)));
                                            let _e691 = select(0i, _e682, (0i < _e682));
                                            let _e694 = bitcast<u32>(select(_e691, _e684, (_e684 < _e691)));
                                            let _e695 = (_e682 + 1i);
                                            let _e697 = select(0i, _e695, (0i < _e695));
                                            let _e700 = bitcast<u32>(select(_e697, _e684, (_e684 < _e697)));
                                            let _e704 = select(select(0f, (_e672 - _e680), (_e682 < _e684)), 1f, (_e682 < 0i));
                                            let _e705 = (_e675 & 31u);
                                            let _e713 = (_e679 & 31u);
                                            let _e718 = (_e675 - 1u);
                                            let _e721 = ((_e679 + 3u) & 31u);
                                            if _e689 {
                                                phi_1122_ = (1f - _e704);
                                            } else {
                                                phi_1122_ = 0f;
                                            }
                                            let _e736 = phi_1122_;
                                            phi_1128_ = vec4<f32>(0f, 0f, 0f, 0f);
                                            phi_1131_ = 0u;
                                            loop {
                                                let _e739 = phi_1128_;
                                                let _e741 = phi_1131_;
                                                local_16 = _e739;
                                                let _e742 = (_e741 < 4u);
                                                if _e742 {
                                                    let _e744 = ((_e741 & 1u) == 1u);
                                                    let _e746 = ((_e741 & 2u) == 2u);
                                                    let _e749 = (select(_e669, select(0f, _e637, _e622), _e744) * select(_e736, select(0f, _e704, _e689), _e746));
                                                    let _e755 = (((_e550.z + ((_e579 >> bitcast<u32>((select(2i, 1i, _e566) & 31i))) * select(select(_e550.x, 1u, _e509), _e550.y, _e566))) + select(((_e627 >> bitcast<u32>(_e638)) * _e610), ((_e633 >> bitcast<u32>(_e638)) * _e610), _e744)) + select(((_e694 >> bitcast<u32>(_e705)) * _e677), ((_e700 >> bitcast<u32>(_e705)) * _e677), _e746));
                                                    let _e760 = (2u * _e755);
                                                    let _e762 = cells.member[_e760];
                                                    let _e764 = ((((((_e579 & 1u) << bitcast<u32>((_e508 & 31u))) | (((_e579 >> bitcast<u32>(1i)) & (select(2u, 1u, _e566) - 1u)) << bitcast<u32>(((_e508 + 3u) & 31u)))) | select((((_e627 & 1u) << bitcast<u32>(_e646)) | (((_e627 >> bitcast<u32>(1i)) & _e651) << bitcast<u32>(_e654))), (((_e633 & 1u) << bitcast<u32>(_e646)) | (((_e633 >> bitcast<u32>(1i)) & _e651) << bitcast<u32>(_e654))), _e744)) | select((((_e694 & 1u) << bitcast<u32>(_e713)) | (((_e694 >> bitcast<u32>(1i)) & _e718) << bitcast<u32>(_e721))), (((_e700 & 1u) << bitcast<u32>(_e713)) | (((_e700 >> bitcast<u32>(1i)) & _e718) << bitcast<u32>(_e721))), _e746)) & 31u);
                                                    if ((_e749 > 0f) && (((_e762 >> bitcast<u32>(_e764)) & 1u) == 1u)) {
                                                        let _e772 = params.member.member_8;
                                                        let _e773 = (_e772 == 1u);
                                                        if (_e532 == 0u) {
                                                            let _e799 = (_e755 * 6u);
                                                            let _e802 = cells.member[(_e760 + 1u)];
                                                            let _e804 = facet_bits.member[_e799];
                                                            let _e807 = ((1u << bitcast<u32>(_e764)) - 1u);
                                                            let _e816 = facet_bits.member[(_e799 + 1u)];
                                                            let _e826 = facet_bits.member[(_e799 + 2u)];
                                                            let _e836 = facet_bits.member[(_e799 + 3u)];
                                                            let _e846 = facet_bits.member[(_e799 + 4u)];
                                                            let _e856 = facet_bits.member[(_e799 + 5u)];
                                                            let _e859 = ((((((_e802 + countOneBits((_e804 & _e807))) + countOneBits((_e816 & _e807))) + countOneBits((_e826 & _e807))) + countOneBits((_e836 & _e807))) + countOneBits((_e846 & _e807))) + countOneBits((_e856 & _e807)));
                                                            let _e863 = (((((((_e804 >> bitcast<u32>(_e764)) & 1u) + ((_e816 >> bitcast<u32>(_e764)) & 1u)) + ((_e826 >> bitcast<u32>(_e764)) & 1u)) + ((_e836 >> bitcast<u32>(_e764)) & 1u)) + ((_e846 >> bitcast<u32>(_e764)) & 1u)) + ((_e856 >> bitcast<u32>(_e764)) & 1u));
                                                            if _e773 {
                                                                phi_1285_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                phi_1288_ = _e859;
                                                                loop {
                                                                    let _e967 = phi_1285_;
                                                                    let _e969 = phi_1288_;
                                                                    local_15 = _e967;
                                                                    let _e971 = (_e969 < (_e859 + _e863));
                                                                    if _e971 {
                                                                        let _e972 = (2u * _e969);
                                                                        let _e975 = radiance.member[_e972][0u];
                                                                        let _e978 = radiance.member[_e972][1u];
                                                                        let _e981 = radiance.member[_e972][2u];
                                                                        let _e982 = (_e972 + 1u);
                                                                        let _e985 = radiance.member[_e982][0u];
                                                                        let _e988 = radiance.member[_e982][1u];
                                                                        let _e991 = radiance.member[_e982][2u];
                                                                        let _e1000 = facets.member[_e969].member_2;
                                                                        let _e1009 = sqrt((((_e1000[0] * _e1000[0]) + (_e1000[1] * _e1000[1])) + (_e1000[2] * _e1000[2])));
                                                                        phi_1286_ = vec4<f32>((_e967.x + (select(_e985, _e975, (_e975 > _e985)) * _e1009)), (_e967.y + (select(_e988, _e978, (_e978 > _e988)) * _e1009)), (_e967.z + (select(_e991, _e981, (_e981 > _e991)) * _e1009)), (_e967.w + _e1009));
                                                                        phi_1289_ = (_e969 + 1u);
                                                                    } else {
                                                                        phi_1286_ = vec4<f32>();
                                                                        phi_1289_ = u32();
                                                                    }
                                                                    let _e1024 = phi_1286_;
                                                                    let _e1026 = phi_1289_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1285_ = _e1024;
                                                                        phi_1288_ = _e1026;
                                                                        break if !(_e971);
                                                                    }
                                                                }
                                                                let _e1494 = local_15;
                                                                phi_1484_ = _e1494;
                                                            } else {
                                                                let _e864 = select(1f, -1f, _e546);
                                                                phi_1384_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                phi_1387_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                phi_1389_ = _e859;
                                                                loop {
                                                                    let _e870 = phi_1384_;
                                                                    let _e872 = phi_1387_;
                                                                    let _e874 = phi_1389_;
                                                                    local = _e870;
                                                                    local_1 = _e872;
                                                                    local_2 = _e870;
                                                                    local_3 = _e870;
                                                                    local_4 = _e870;
                                                                    local_5 = _e872;
                                                                    local_14 = _e872;
                                                                    let _e876 = (_e874 < (_e859 + _e863));
                                                                    if _e876 {
                                                                        let _e879 = facets.member[_e874].member_2;
                                                                        let _e888 = -((((select(0f, _e864, _e509) * _e879[0]) + (select(0f, _e864, (_e508 == 1u)) * _e879[1])) + (select(0f, _e864, _e566) * _e879[2])));
                                                                        if (_e888 > 0f) {
                                                                            let _e911 = radiance.member[(2u * _e874)];
                                                                            phi_1459_ = _e870;
                                                                            phi_1460_ = vec4<f32>((_e872.x + (_e911.x * _e888)), (_e872.y + (_e911.y * _e888)), (_e872.z + (_e911.z * _e888)), (_e872.w + _e888));
                                                                        } else {
                                                                            let _e893 = radiance.member[((2u * _e874) + 1u)];
                                                                            phi_1459_ = vec4<f32>((_e870.x - (_e893.x * _e888)), (_e870.y - (_e893.y * _e888)), (_e870.z - (_e893.z * _e888)), (_e870.w - _e888));
                                                                            phi_1460_ = _e872;
                                                                        }
                                                                        let _e928 = phi_1459_;
                                                                        let _e930 = phi_1460_;
                                                                        phi_1385_ = _e928;
                                                                        phi_1388_ = _e930;
                                                                        phi_1390_ = (_e874 + 1u);
                                                                    } else {
                                                                        phi_1385_ = vec4<f32>();
                                                                        phi_1388_ = vec4<f32>();
                                                                        phi_1390_ = u32();
                                                                    }
                                                                    let _e933 = phi_1385_;
                                                                    let _e935 = phi_1388_;
                                                                    let _e937 = phi_1390_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1384_ = _e933;
                                                                        phi_1387_ = _e935;
                                                                        phi_1389_ = _e937;
                                                                        break if !(_e876);
                                                                    }
                                                                }
                                                                let _e940 = local;
                                                                let _e943 = local_1;
                                                                if (_e940.w > _e943.w) {
                                                                    let _e946 = (_e940.w - _e943.w);
                                                                    let _e947 = (_e946 / _e940.w);
                                                                    let _e949 = local_2;
                                                                    let _e953 = local_3;
                                                                    let _e957 = local_4;
                                                                    let _e962 = local_5;
                                                                    phi_1483_ = (_e962 + vec4<f32>((_e949.x * _e947), (_e953.y * _e947), (_e957.z * _e947), _e946));
                                                                } else {
                                                                    let _e1487 = local_14;
                                                                    phi_1483_ = _e1487;
                                                                }
                                                                let _e965 = phi_1483_;
                                                                phi_1484_ = _e965;
                                                            }
                                                            let _e1029 = phi_1484_;
                                                            if (_e1029.w > 1f) {
                                                                phi_1498_ = vec4<f32>((_e1029.x / _e1029.w), (_e1029.y / _e1029.w), (_e1029.z / _e1029.w), 1f);
                                                            } else {
                                                                phi_1498_ = _e1029;
                                                            }
                                                            let _e1040 = phi_1498_;
                                                            phi_1531_ = _e1040;
                                                        } else {
                                                            let _e777 = cells.member[(_e760 + 1u)];
                                                            let _e783 = (_e777 + countOneBits((_e762 & ((1u << bitcast<u32>(_e764)) - 1u))));
                                                            if _e773 {
                                                                phi_1518_ = _e783;
                                                            } else {
                                                                phi_1518_ = (((6u * _e783) + (2u * _e508)) + select(0u, 1u, _e546));
                                                            }
                                                            let _e790 = phi_1518_;
                                                            if ((_e532 & 1u) == 1u) {
                                                                let _e796 = odd.member[_e790];
                                                                phi_1530_ = _e796;
                                                            } else {
                                                                let _e794 = even.member[_e790];
                                                                phi_1530_ = _e794;
                                                            }
                                                            let _e798 = phi_1530_;
                                                            phi_1531_ = _e798;
                                                        }
                                                        let _e1042 = phi_1531_;
                                                        phi_1552_ = vec4<f32>((_e739.x + (_e1042.x * _e749)), (_e739.y + (_e1042.y * _e749)), (_e739.z + (_e1042.z * _e749)), (_e739.w + (_e1042.w * _e749)));
                                                    } else {
                                                        phi_1552_ = _e739;
                                                    }
                                                    let _e1061 = phi_1552_;
                                                    phi_1129_ = _e1061;
                                                    phi_1132_ = (_e741 + 1u);
                                                } else {
                                                    phi_1129_ = vec4<f32>();
                                                    phi_1132_ = u32();
                                                }
                                                let _e1064 = phi_1129_;
                                                let _e1066 = phi_1132_;
                                                continue;
                                                continuing {
                                                    phi_1128_ = _e1064;
                                                    phi_1131_ = _e1066;
                                                    break if !(_e742);
                                                }
                                            }
                                            let _e1502 = local_16;
                                            phi_1554_ = _e1502;
                                        }
                                        let _e1069 = phi_1554_;
                                        if (_e1069.w > 0f) {
                                            let _e1076 = select(_e536, _e1069.w, (_e1069.w < _e536));
                                            let _e1081 = ((_e496 * _e1076) / _e1069.w);
                                            phi_1594_ = vec3<f32>((_e484.x + (_e1069.x * _e1081)), (_e484.y + (_e1069.y * _e1081)), (_e484.z + (_e1069.z * _e1081)));
                                            phi_1595_ = (_e494 + _e1076);
                                            phi_1596_ = _e496;
                                        } else {
                                            let _e1072 = (_e508 == _e395);
                                            phi_1594_ = _e484;
                                            phi_1595_ = select(_e494, 0f, _e1072);
                                            phi_1596_ = select(_e496, _e537, _e1072);
                                        }
                                        let _e1094 = phi_1594_;
                                        let _e1096 = phi_1595_;
                                        let _e1098 = phi_1596_;
                                        let _e1099 = (_e357 * _e528);
                                        let _e1101 = ((_e360 * _e139) + ((_e360 * _e354.z) * _e528));
                                        let _e1103 = select(_e1101, _e1099, (_e1099 < _e1101));
                                        let _e1110 = ((bitcast<u32>((select(1f, _e1103, (_e1103 > 1f)) * _e352)) >> bitcast<u32>(23i)) - 127u);
                                        let _e1112 = (_e383.w - 1u);
                                        let _e1114 = select(_e1110, _e1112, (_e1112 < _e1110));
                                        if _e509 {
                                            let _e1265 = (_e490.member_1 < 0f);
                                            if _e1265 {
                                                phi_1639_ = (_e490.member_3 - 1i);
                                            } else {
                                                phi_1639_ = (_e490.member_3 + 1i);
                                            }
                                            let _e1273 = phi_1639_;
                                            let _e1279 = type_41(_e490.member, _e490.member_1, _e490.member_2, _e1273, _e490.member_4);
                                            if ((((_e490.member_3 & 1i) == 0i) == _e1265) && (_e1114 > _e490.member_2)) {
                                                let _e1289 = type_41(_e1279.member, _e1279.member_1, (_e490.member_2 + 1u), _e1279.member_3, _e1279.member_4);
                                                phi_1652_ = type_41(_e1289.member, _e1289.member_1, _e1289.member_2, (_e1273 >> bitcast<u32>(1i)), _e1289.member_4);
                                            } else {
                                                phi_1652_ = _e1279;
                                            }
                                            let _e1299 = phi_1652_;
                                            let _e1301 = (_e1299.member_2 & 31u);
                                            let _e1303 = (1u << bitcast<u32>(_e1301));
                                            if ((((_e1299.member_1 < 0f) && (_e1299.member_3 < 0i)) || ((_e1299.member_1 >= 0f) && (_e1299.member_3 >= bitcast<i32>((((_e383.x + _e1303) - 1u) >> bitcast<u32>(_e1301)))))) || (abs(_e1299.member_1) < 0.000001f)) {
                                                phi_1692_ = 340282350000000000000000000000000000000f;
                                            } else {
                                                phi_1692_ = ((((f32(_e1299.member_3) + 0.5f) * f32(_e1303)) - _e1299.member) / _e1299.member_1);
                                            }
                                            let _e1329 = phi_1692_;
                                            phi_1838_ = _e486;
                                            phi_1839_ = _e488;
                                            phi_1840_ = type_41(_e1299.member, _e1299.member_1, _e1299.member_2, _e1299.member_3, _e1329);
                                        } else {
                                            if (_e508 == 1u) {
                                                let _e1189 = (_e488.member_1 < 0f);
                                                if _e1189 {
                                                    phi_1712_ = (_e488.member_3 - 1i);
                                                } else {
                                                    phi_1712_ = (_e488.member_3 + 1i);
                                                }
                                                let _e1197 = phi_1712_;
                                                let _e1203 = type_41(_e488.member, _e488.member_1, _e488.member_2, _e1197, _e488.member_4);
                                                if ((((_e488.member_3 & 1i) == 0i) == _e1189) && (_e1114 > _e488.member_2)) {
                                                    let _e1213 = type_41(_e1203.member, _e1203.member_1, (_e488.member_2 + 1u), _e1203.member_3, _e1203.member_4);
                                                    phi_1725_ = type_41(_e1213.member, _e1213.member_1, _e1213.member_2, (_e1197 >> bitcast<u32>(1i)), _e1213.member_4);
                                                } else {
                                                    phi_1725_ = _e1203;
                                                }
                                                let _e1223 = phi_1725_;
                                                let _e1225 = (_e1223.member_2 & 31u);
                                                let _e1227 = (1u << bitcast<u32>(_e1225));
                                                if ((((_e1223.member_1 < 0f) && (_e1223.member_3 < 0i)) || ((_e1223.member_1 >= 0f) && (_e1223.member_3 >= bitcast<i32>((((_e383.y + _e1227) - 1u) >> bitcast<u32>(_e1225)))))) || (abs(_e1223.member_1) < 0.000001f)) {
                                                    phi_1765_ = 340282350000000000000000000000000000000f;
                                                } else {
                                                    phi_1765_ = ((((f32(_e1223.member_3) + 0.5f) * f32(_e1227)) - _e1223.member) / _e1223.member_1);
                                                }
                                                let _e1253 = phi_1765_;
                                                phi_1836_ = _e486;
                                                phi_1837_ = type_41(_e1223.member, _e1223.member_1, _e1223.member_2, _e1223.member_3, _e1253);
                                            } else {
                                                let _e1117 = (_e486.member_1 < 0f);
                                                if _e1117 {
                                                    phi_1781_ = (_e486.member_3 - 1i);
                                                } else {
                                                    phi_1781_ = (_e486.member_3 + 1i);
                                                }
                                                let _e1125 = phi_1781_;
                                                let _e1131 = type_41(_e486.member, _e486.member_1, _e486.member_2, _e1125, _e486.member_4);
                                                if ((((_e486.member_3 & 1i) == 0i) == _e1117) && (_e1114 > _e486.member_2)) {
                                                    let _e1141 = type_41(_e1131.member, _e1131.member_1, (_e486.member_2 + 1u), _e1131.member_3, _e1131.member_4);
                                                    phi_1794_ = type_41(_e1141.member, _e1141.member_1, _e1141.member_2, (_e1125 >> bitcast<u32>(1i)), _e1141.member_4);
                                                } else {
                                                    phi_1794_ = _e1131;
                                                }
                                                let _e1151 = phi_1794_;
                                                let _e1153 = (_e1151.member_2 & 31u);
                                                let _e1155 = (1u << bitcast<u32>(_e1153));
                                                if ((((_e1151.member_1 < 0f) && (_e1151.member_3 < 0i)) || ((_e1151.member_1 >= 0f) && (_e1151.member_3 >= bitcast<i32>((((_e383.z + _e1155) - 1u) >> bitcast<u32>(_e1153)))))) || (abs(_e1151.member_1) < 0.000001f)) {
                                                    phi_1834_ = 340282350000000000000000000000000000000f;
                                                } else {
                                                    phi_1834_ = ((((f32(_e1151.member_3) + 0.5f) * f32(_e1155)) - _e1151.member) / _e1151.member_1);
                                                }
                                                let _e1181 = phi_1834_;
                                                phi_1836_ = type_41(_e1151.member, _e1151.member_1, _e1151.member_2, _e1151.member_3, _e1181);
                                                phi_1837_ = _e488;
                                            }
                                            let _e1261 = phi_1836_;
                                            let _e1263 = phi_1837_;
                                            phi_1838_ = _e1261;
                                            phi_1839_ = _e1263;
                                            phi_1840_ = _e490;
                                        }
                                        let _e1337 = phi_1838_;
                                        let _e1339 = phi_1839_;
                                        let _e1341 = phi_1840_;
                                        phi_1841_ = _e1094;
                                        phi_1842_ = _e1337;
                                        phi_1843_ = _e1339;
                                        phi_1844_ = _e1341;
                                        phi_1845_ = _e1096;
                                        phi_1846_ = _e1098;
                                    }
                                    let _e1343 = phi_1841_;
                                    let _e1345 = phi_1842_;
                                    let _e1347 = phi_1843_;
                                    let _e1349 = phi_1844_;
                                    let _e1351 = phi_1845_;
                                    let _e1353 = phi_1846_;
                                    phi_701_ = _e1343;
                                    phi_704_ = _e1345;
                                    phi_706_ = _e1347;
                                    phi_708_ = _e1349;
                                    phi_710_ = (_e492 + 1u);
                                    phi_712_ = _e1351;
                                    phi_714_ = _e1353;
                                    phi_1848_ = select(true, false, _e539);
                                } else {
                                    phi_701_ = vec3<f32>();
                                    phi_704_ = type_41();
                                    phi_706_ = type_41();
                                    phi_708_ = type_41();
                                    phi_710_ = u32();
                                    phi_712_ = f32();
                                    phi_714_ = f32();
                                    phi_1848_ = false;
                                }
                                let _e1356 = phi_701_;
                                let _e1358 = phi_704_;
                                let _e1360 = phi_706_;
                                let _e1362 = phi_708_;
                                let _e1364 = phi_710_;
                                let _e1366 = phi_712_;
                                let _e1368 = phi_714_;
                                let _e1370 = phi_1848_;
                                continue;
                                continuing {
                                    phi_700_ = _e1356;
                                    phi_703_ = _e1358;
                                    phi_705_ = _e1360;
                                    phi_707_ = _e1362;
                                    phi_709_ = _e1364;
                                    phi_711_ = _e1366;
                                    phi_713_ = _e1368;
                                    break if !(_e1370);
                                }
                            }
                            let _e1373 = local_6;
                            let _e1376 = local_7;
                            let _e1377 = (_e1376 * (1f - _e1373));
                            let _e1379 = local_8;
                            let _e1382 = local_9;
                            let _e1385 = local_10;
                            let _e1389 = params.member.member_5;
                            phi_325_ = vec3<f32>((_e205.x + ((_e1379.x + (_e1389.x * _e1377)) * _e229.w)), (_e205.y + ((_e1382.y + (_e1389.y * _e1377)) * _e229.w)), (_e205.z + ((_e1385.z + (_e1389.z * _e1377)) * _e229.w)));
                        } else {
                            phi_325_ = vec3<f32>();
                        }
                        let _e1411 = phi_325_;
                        continue;
                        continuing {
                            phi_321_ = _e218;
                            phi_324_ = _e1411;
                            phi_1945_ = false;
                            break if !(_e224);
                        }
                    }
                    let _e1414 = phi_1945_;
                    if _e1414 {
                        break;
                    }
                    let _e1416 = local_11;
                    let _e1420 = local_12;
                    let _e1424 = local_13;
                    phi_1889_ = vec4<f32>((_e1416.x * 3.1415927f), (_e1420.y * 3.1415927f), (_e1424.z * 3.1415927f), 0f);
                }
                let _e1429 = phi_1889_;
                if (_e95 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e95] = _e1429;
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
