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
    var phi_316_: f32;
    var phi_321_: type_12;
    var phi_324_: vec3<f32>;
    var phi_322_: type_12;
    var phi_347_: type_12;
    var phi_485_: f32;
    var phi_493_: f32;
    var phi_506_: f32;
    var phi_507_: vec3<f32>;
    var phi_551_: bool;
    var phi_560_: u32;
    var phi_578_: i32;
    var phi_592_: bool;
    var phi_623_: i32;
    var phi_637_: bool;
    var phi_668_: i32;
    var phi_682_: bool;
    var phi_733_: vec3<f32>;
    var phi_736_: type_40;
    var phi_738_: u32;
    var phi_740_: u32;
    var phi_742_: f32;
    var phi_744_: f32;
    var phi_746_: type_40;
    var phi_748_: type_40;
    var phi_750_: type_40;
    var phi_1018_: f32;
    var phi_1148_: f32;
    var phi_1154_: vec4<f32>;
    var phi_1157_: u32;
    var phi_1517_: u32;
    var phi_1529_: vec4<f32>;
    var phi_1323_: vec4<f32>;
    var phi_1326_: vec4<f32>;
    var phi_1328_: u32;
    var phi_1324_: vec4<f32>;
    var phi_1327_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_1530_: vec4<f32>;
    var phi_1155_: vec4<f32>;
    var phi_1556_: vec4<f32>;
    var phi_1596_: vec3<f32>;
    var phi_1597_: f32;
    var phi_1598_: f32;
    var phi_1640_: i32;
    var phi_1658_: bool;
    var phi_1679_: u32;
    var phi_1684_: i32;
    var phi_1689_: f32;
    var phi_1696_: u32;
    var phi_1701_: i32;
    var phi_1706_: f32;
    var phi_1713_: u32;
    var phi_1718_: i32;
    var phi_1723_: f32;
    var phi_734_: vec3<f32>;
    var phi_737_: type_40;
    var phi_739_: u32;
    var phi_741_: u32;
    var phi_743_: f32;
    var phi_745_: f32;
    var phi_747_: type_40;
    var phi_749_: type_40;
    var phi_751_: type_40;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var local_11: f32;
    var local_12: f32;
    var local_13: f32;
    var phi_325_: vec3<f32>;
    var phi_1854_: bool;
    var local_14: vec3<f32>;
    var local_15: vec3<f32>;
    var local_16: vec3<f32>;
    var phi_1798_: vec4<f32>;
    var local_17: vec4<f32>;

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
                    phi_1798_ = vec4<f32>(0f, 0f, 0f, 0f);
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
                    phi_321_ = type_12(0u, _e200);
                    phi_324_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e203 = phi_321_;
                        let _e205 = phi_324_;
                        local_14 = _e205;
                        local_15 = _e205;
                        local_16 = _e205;
                        if (_e203.member < _e203.member_1) {
                            phi_322_ = type_12((_e203.member + 1u), _e203.member_1);
                            phi_347_ = type_12(1u, _e203.member);
                        } else {
                            phi_322_ = _e203;
                            phi_347_ = type_12(0u, type_12().member_1);
                        }
                        let _e218 = phi_322_;
                        let _e220 = phi_347_;
                        let _e224 = (bitcast<i32>(_e220.member) != 0i);
                        if _e224 {
                            let _e225 = (_e220.member_1 < 16u);
                            if _e225 {
                            } else {
                                phi_1854_ = true;
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
                                    phi_1854_ = true;
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
                            let _e406 = (_e378 < 0f);
                            if _e406 {
                                phi_578_ = (i32(-(floor((0.5f - _e143)))) - 1i);
                            } else {
                                phi_578_ = (i32(floor((_e143 - 0.5f))) + 1i);
                            }
                            let _e410 = phi_578_;
                            if _e406 {
                                phi_592_ = (_e410 < 0i);
                            } else {
                                phi_592_ = (_e410 >= bitcast<i32>(_e383.x));
                            }
                            let _e415 = phi_592_;
                            let _e422 = select((((f32(_e410) + 0.5f) - _e143) / _e378), 340282350000000000000000000000000000000f, (_e415 || (_e384 < 0.000001f)));
                            let _e431 = (_e379 < 0f);
                            if _e431 {
                                phi_623_ = (i32(-(floor((0.5f - _e144)))) - 1i);
                            } else {
                                phi_623_ = (i32(floor((_e144 - 0.5f))) + 1i);
                            }
                            let _e435 = phi_623_;
                            if _e431 {
                                phi_637_ = (_e435 < 0i);
                            } else {
                                phi_637_ = (_e435 >= bitcast<i32>(_e383.y));
                            }
                            let _e440 = phi_637_;
                            let _e447 = select((((f32(_e435) + 0.5f) - _e144) / _e379), 340282350000000000000000000000000000000f, (_e440 || (_e385 < 0.000001f)));
                            let _e456 = (_e380 < 0f);
                            if _e456 {
                                phi_668_ = (i32(-(floor((0.5f - _e145)))) - 1i);
                            } else {
                                phi_668_ = (i32(floor((_e145 - 0.5f))) + 1i);
                            }
                            let _e460 = phi_668_;
                            if _e456 {
                                phi_682_ = (_e460 < 0i);
                            } else {
                                phi_682_ = (_e460 >= bitcast<i32>(_e383.z));
                            }
                            let _e465 = phi_682_;
                            let _e472 = select((((f32(_e460) + 0.5f) - _e145) / _e380), 340282350000000000000000000000000000000f, (_e465 || (_e386 < 0.000001f)));
                            let _e476 = ((_e422 <= _e447) && (_e422 <= _e472));
                            let _e477 = (_e447 <= _e472);
                            phi_733_ = vec3<f32>(0f, 0f, 0f);
                            phi_736_ = type_40(0u, select(select(_e460, _e435, _e477), _e410, _e476), select(select(_e472, _e447, _e477), _e422, _e476));
                            phi_738_ = select(select(2u, 1u, _e477), 0u, _e476);
                            phi_740_ = 0u;
                            phi_742_ = 0f;
                            phi_744_ = 1f;
                            phi_746_ = type_40(0u, _e460, _e472);
                            phi_748_ = type_40(0u, _e435, _e447);
                            phi_750_ = type_40(0u, _e410, _e422);
                            loop {
                                let _e486 = phi_733_;
                                let _e488 = phi_736_;
                                let _e490 = phi_738_;
                                let _e492 = phi_740_;
                                let _e494 = phi_742_;
                                let _e496 = phi_744_;
                                let _e498 = phi_746_;
                                let _e500 = phi_748_;
                                let _e502 = phi_750_;
                                local_8 = _e486;
                                local_9 = _e486;
                                local_10 = _e486;
                                let _e507 = (1f - _e494);
                                let _e508 = (_e496 * _e507);
                                let _e510 = (((_e492 < 2048u) && (_e488.member_2 < 340282350000000000000000000000000000000f)) && (_e508 >= 0.001f));
                                local_11 = _e508;
                                local_12 = _e508;
                                local_13 = _e508;
                                if _e510 {
                                    let _e512 = (_e490 == 0u);
                                    let _e514 = (_e490 == 2u);
                                    let _e517 = select(select(_e379, _e378, _e512), _e380, _e514);
                                    let _e528 = (_e517 < 0f);
                                    let _e532 = params.member.member_2[_e488.member];
                                    let _e533 = (_e488.member & 31u);
                                    let _e535 = (1u << bitcast<u32>(_e533));
                                    let _e536 = (_e535 - 1u);
                                    let _e539 = ((_e383.x + _e536) >> bitcast<u32>(_e533));
                                    let _e542 = ((_e383.y + _e536) >> bitcast<u32>(_e533));
                                    let _e545 = ((_e383.z + _e536) >> bitcast<u32>(_e533));
                                    if ((_e488.member_1 < 0i) || (_e488.member_1 >= bitcast<i32>(select(select(_e542, _e539, _e512), _e545, _e514)))) {
                                        phi_1556_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    } else {
                                        let _e553 = (1f / f32(_e535));
                                        let _e555 = (((_e143 + (_e378 * _e488.member_2)) * _e553) - 0.5f);
                                        let _e557 = (((_e144 + (_e379 * _e488.member_2)) * _e553) - 0.5f);
                                        let _e559 = (((_e145 + (_e380 * _e488.member_2)) * _e553) - 0.5f);
                                        let _e560 = bitcast<u32>(_e488.member_1);
                                        let _e585 = select(select(_e559, _e557, _e512), _e555, _e514);
                                        let _e589 = select(select(1u, 2u, _e512), 2u, _e514);
                                        let _e591 = select(select(_e532.y, _e532.x, _e512), 1u, _e514);
                                        let _e592 = select(2u, 1u, _e512);
                                        let _e593 = select(_e592, 0u, _e514);
                                        let _e594 = floor(_e585);
                                        let _e596 = i32(_e594);
                                        let _e598 = (bitcast<i32>(select(select(_e545, _e542, _e512), _e539, _e514)) - 1i);
                                        let _e603 = ((_e585 >= -0.5f) && (_e585 <= (f32(_e598) + 0.5f)));
                                        let _e605 = select(0i, _e596, (0i < _e596));
                                        let _e608 = bitcast<u32>(select(_e605, _e598, (_e598 < _e605)));
                                        let _e609 = (_e596 + 1i);
                                        let _e611 = select(0i, _e609, (0i < _e609));
                                        let _e614 = bitcast<u32>(select(_e611, _e598, (_e598 < _e611)));
                                        let _e618 = select(select(0f, (_e585 - _e594), (_e596 < _e598)), 1f, (_e596 < 0i));
                                        let _e619 = (_e589 & 31u);
                                        let _e627 = (_e593 & 31u);
                                        let _e632 = (_e589 - 1u);
                                        let _e635 = ((_e593 + 3u) & 31u);
                                        if _e603 {
                                            phi_1018_ = (1f - _e618);
                                        } else {
                                            phi_1018_ = 0f;
                                        }
                                        let _e650 = phi_1018_;
                                        let _e653 = select(select(_e555, _e559, _e512), _e557, _e514);
                                        let _e656 = select(_e592, 2u, _e514);
                                        let _e658 = select(select(1u, _e532.y, _e512), _e532.x, _e514);
                                        let _e660 = select(select(0u, 2u, _e512), 1u, _e514);
                                        let _e661 = floor(_e653);
                                        let _e663 = i32(_e661);
                                        let _e665 = (bitcast<i32>(select(select(_e539, _e545, _e512), _e542, _e514)) - 1i);
                                        let _e670 = ((_e653 >= -0.5f) && (_e653 <= (f32(_e665) + 0.5f)));
                                        let _e672 = select(0i, _e663, (0i < _e663));
                                        let _e675 = bitcast<u32>(select(_e672, _e665, (_e665 < _e672)));
                                        let _e676 = (_e663 + 1i);
                                        let _e678 = select(0i, _e676, (0i < _e676));
                                        let _e681 = bitcast<u32>(select(_e678, _e665, (_e665 < _e678)));
                                        let _e685 = select(select(0f, (_e653 - _e661), (_e663 < _e665)), 1f, (_e663 < 0i));
                                        let _e686 = (_e656 & 31u);
                                        let _e694 = (_e660 & 31u);
                                        let _e699 = (_e656 - 1u);
                                        let _e702 = ((_e660 + 3u) & 31u);
                                        if _e670 {
                                            phi_1148_ = (1f - _e685);
                                        } else {
                                            phi_1148_ = 0f;
                                        }
                                        let _e717 = phi_1148_;
                                        phi_1154_ = vec4<f32>(0f, 0f, 0f, 0f);
                                        phi_1157_ = 0u;
                                        loop {
                                            let _e720 = phi_1154_;
                                            let _e722 = phi_1157_;
                                            let _e724 = ((_e722 & 1u) == 1u);
                                            let _e726 = ((_e722 & 2u) == 2u);
                                            let _e729 = (select(_e650, select(0f, _e618, _e603), _e724) * select(_e717, select(0f, _e685, _e670), _e726));
                                            let _e735 = (((_e532.z + ((_e560 >> bitcast<u32>((select(2i, 1i, _e514) & 31i))) * select(select(_e532.x, 1u, _e512), _e532.y, _e514))) + select(((_e608 >> bitcast<u32>(_e619)) * _e591), ((_e614 >> bitcast<u32>(_e619)) * _e591), _e724)) + select(((_e675 >> bitcast<u32>(_e686)) * _e658), ((_e681 >> bitcast<u32>(_e686)) * _e658), _e726));
                                            let _e740 = (2u * _e735);
                                            let _e742 = cells.member[_e740];
                                            let _e744 = ((((((_e560 & 1u) << bitcast<u32>((_e490 & 31u))) | (((_e560 >> bitcast<u32>(1i)) & (select(2u, 1u, _e514) - 1u)) << bitcast<u32>(((_e490 + 3u) & 31u)))) | select((((_e608 & 1u) << bitcast<u32>(_e627)) | (((_e608 >> bitcast<u32>(1i)) & _e632) << bitcast<u32>(_e635))), (((_e614 & 1u) << bitcast<u32>(_e627)) | (((_e614 >> bitcast<u32>(1i)) & _e632) << bitcast<u32>(_e635))), _e724)) | select((((_e675 & 1u) << bitcast<u32>(_e694)) | (((_e675 >> bitcast<u32>(1i)) & _e699) << bitcast<u32>(_e702))), (((_e681 & 1u) << bitcast<u32>(_e694)) | (((_e681 >> bitcast<u32>(1i)) & _e699) << bitcast<u32>(_e702))), _e726)) & 31u);
                                            if ((_e729 > 0f) && (((_e742 >> bitcast<u32>(_e744)) & 1u) == 1u)) {
                                                let _e752 = params.member.member_8;
                                                let _e753 = (_e752 == 1u);
                                                if (_e488.member == 0u) {
                                                    let _e779 = (_e735 * 6u);
                                                    let _e782 = cells.member[(_e740 + 1u)];
                                                    let _e784 = facet_bits.member[_e779];
                                                    let _e787 = ((1u << bitcast<u32>(_e744)) - 1u);
                                                    let _e796 = facet_bits.member[(_e779 + 1u)];
                                                    let _e806 = facet_bits.member[(_e779 + 2u)];
                                                    let _e816 = facet_bits.member[(_e779 + 3u)];
                                                    let _e826 = facet_bits.member[(_e779 + 4u)];
                                                    let _e836 = facet_bits.member[(_e779 + 5u)];
                                                    let _e839 = ((((((_e782 + countOneBits((_e784 & _e787))) + countOneBits((_e796 & _e787))) + countOneBits((_e806 & _e787))) + countOneBits((_e816 & _e787))) + countOneBits((_e826 & _e787))) + countOneBits((_e836 & _e787)));
                                                    let _e844 = select(1f, -1f, _e528);
                                                    phi_1323_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                    phi_1326_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                    phi_1328_ = _e839;
                                                    loop {
                                                        let _e850 = phi_1323_;
                                                        let _e852 = phi_1326_;
                                                        let _e854 = phi_1328_;
                                                        let _e857 = facets.member[_e854].member_2;
                                                        let _e861 = (2u * _e854);
                                                        let _e863 = radiance.member[_e861];
                                                        let _e866 = radiance.member[(_e861 + 1u)];
                                                        let _e871 = (((select(0f, _e844, _e512) * _e857[0]) + (select(0f, _e844, (_e490 == 1u)) * _e857[1])) + (select(0f, _e844, _e514) * _e857[2]));
                                                        let _e872 = -(_e871);
                                                        if _e753 {
                                                            let _e924 = sqrt((((_e857[0] * _e857[0]) + (_e857[1] * _e857[1])) + (_e857[2] * _e857[2])));
                                                            phi_1324_ = _e850;
                                                            phi_1327_ = vec4<f32>((_e852.x + (select(_e866.x, _e863.x, (_e863.x > _e866.x)) * _e924)), (_e852.y + (select(_e866.y, _e863.y, (_e863.y > _e866.y)) * _e924)), (_e852.z + (select(_e866.z, _e863.z, (_e863.z > _e866.z)) * _e924)), (_e852.w + _e924));
                                                        } else {
                                                            let _e877 = select(0f, _e872, (_e872 > 0f));
                                                            let _e894 = select(0f, _e871, (_e871 > 0f));
                                                            phi_1324_ = vec4<f32>((_e850.x + (_e866.x * _e894)), (_e850.y + (_e866.y * _e894)), (_e850.z + (_e866.z * _e894)), (_e850.w + _e894));
                                                            phi_1327_ = vec4<f32>((_e852.x + (_e863.x * _e877)), (_e852.y + (_e863.y * _e877)), (_e852.z + (_e863.z * _e877)), (_e852.w + _e877));
                                                        }
                                                        let _e938 = phi_1324_;
                                                        let _e940 = phi_1327_;
                                                        let _e941 = (_e854 + 1u);
                                                        local = _e938;
                                                        local_1 = _e940;
                                                        local_2 = _e938;
                                                        local_3 = _e938;
                                                        local_4 = _e938;
                                                        local_5 = _e940;
                                                        local_6 = _e940;
                                                        local_7 = _e940;
                                                        continue;
                                                        continuing {
                                                            phi_1323_ = _e938;
                                                            phi_1326_ = _e940;
                                                            phi_1328_ = _e941;
                                                            break if !(select(true, false, (_e941 >= (_e839 + (((((((_e784 >> bitcast<u32>(_e744)) & 1u) + ((_e796 >> bitcast<u32>(_e744)) & 1u)) + ((_e806 >> bitcast<u32>(_e744)) & 1u)) + ((_e816 >> bitcast<u32>(_e744)) & 1u)) + ((_e826 >> bitcast<u32>(_e744)) & 1u)) + ((_e836 >> bitcast<u32>(_e744)) & 1u))))));
                                                        }
                                                    }
                                                    let _e947 = local;
                                                    let _e950 = local_1;
                                                    let _e952 = (_e947.w - _e950.w);
                                                    let _e957 = (select(0f, _e952, (_e952 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e947.w, (_e947.w > 0.000000000000000000000000000000000000011754944f)));
                                                    let _e959 = local_2;
                                                    let _e963 = local_3;
                                                    let _e967 = local_4;
                                                    let _e972 = local_5;
                                                    let _e976 = local_6;
                                                    let _e980 = local_7;
                                                    let _e983 = (_e950.w + (_e947.w * _e957));
                                                    let _e986 = (1f / select(1f, _e983, (_e983 > 1f)));
                                                    phi_1530_ = vec4<f32>(((_e972.x + (_e959.x * _e957)) * _e986), ((_e976.y + (_e963.y * _e957)) * _e986), ((_e980.z + (_e967.z * _e957)) * _e986), select(1f, _e983, (_e983 < 1f)));
                                                } else {
                                                    let _e757 = cells.member[(_e740 + 1u)];
                                                    let _e763 = (_e757 + countOneBits((_e742 & ((1u << bitcast<u32>(_e744)) - 1u))));
                                                    if _e753 {
                                                        phi_1517_ = _e763;
                                                    } else {
                                                        phi_1517_ = (((6u * _e763) + (2u * _e490)) + select(0u, 1u, _e528));
                                                    }
                                                    let _e770 = phi_1517_;
                                                    if ((_e488.member & 1u) == 1u) {
                                                        let _e776 = odd.member[_e770];
                                                        phi_1529_ = _e776;
                                                    } else {
                                                        let _e774 = even.member[_e770];
                                                        phi_1529_ = _e774;
                                                    }
                                                    let _e778 = phi_1529_;
                                                    phi_1530_ = _e778;
                                                }
                                                let _e994 = phi_1530_;
                                                phi_1155_ = vec4<f32>((_e720.x + (_e994.x * _e729)), (_e720.y + (_e994.y * _e729)), (_e720.z + (_e994.z * _e729)), (_e720.w + (_e994.w * _e729)));
                                            } else {
                                                phi_1155_ = _e720;
                                            }
                                            let _e1013 = phi_1155_;
                                            let _e1014 = (_e722 + 1u);
                                            local_17 = _e1013;
                                            continue;
                                            continuing {
                                                phi_1154_ = _e1013;
                                                phi_1157_ = _e1014;
                                                break if !(select(true, false, (_e1014 == 4u)));
                                            }
                                        }
                                        let _e1274 = local_17;
                                        phi_1556_ = _e1274;
                                    }
                                    let _e1019 = phi_1556_;
                                    if (_e1019.w > 0f) {
                                        let _e1026 = select(_e507, _e1019.w, (_e1019.w < _e507));
                                        let _e1031 = ((_e496 * _e1026) / _e1019.w);
                                        phi_1596_ = vec3<f32>((_e486.x + (_e1019.x * _e1031)), (_e486.y + (_e1019.y * _e1031)), (_e486.z + (_e1019.z * _e1031)));
                                        phi_1597_ = (_e494 + _e1026);
                                        phi_1598_ = _e496;
                                    } else {
                                        let _e1022 = (_e490 == _e395);
                                        phi_1596_ = _e486;
                                        phi_1597_ = select(_e494, 0f, _e1022);
                                        phi_1598_ = select(_e496, _e508, _e1022);
                                    }
                                    let _e1044 = phi_1596_;
                                    let _e1046 = phi_1597_;
                                    let _e1048 = phi_1598_;
                                    let _e1049 = (_e357 * _e488.member_2);
                                    let _e1051 = ((_e360 * _e139) + ((_e360 * _e354.z) * _e488.member_2));
                                    let _e1053 = select(_e1051, _e1049, (_e1049 < _e1051));
                                    let _e1060 = ((bitcast<u32>((select(1f, _e1053, (_e1053 > 1f)) * _e352)) >> bitcast<u32>(23i)) - 127u);
                                    let _e1062 = (_e383.w - 1u);
                                    let _e1070 = select(0u, 1u, ((((_e488.member_1 & 1i) == 0i) == _e528) && (select(_e1060, _e1062, (_e1062 < _e1060)) > _e488.member)));
                                    if _e528 {
                                        phi_1640_ = (_e488.member_1 - 1i);
                                    } else {
                                        phi_1640_ = (_e488.member_1 + 1i);
                                    }
                                    let _e1074 = phi_1640_;
                                    let _e1075 = (_e488.member + _e1070);
                                    let _e1078 = (_e1074 >> bitcast<u32>((_e1070 & 31u)));
                                    let _e1079 = (_e1075 & 31u);
                                    let _e1081 = (1u << bitcast<u32>(_e1079));
                                    if _e528 {
                                        phi_1658_ = (_e1078 < 0i);
                                    } else {
                                        phi_1658_ = (_e1078 >= bitcast<i32>((((select(select(_e383.y, _e383.x, _e512), _e383.z, _e514) + _e1081) - 1u) >> bitcast<u32>(_e1079))));
                                    }
                                    let _e1090 = phi_1658_;
                                    let _e1100 = select(((((f32(_e1078) + 0.5f) * f32(_e1081)) - select(select(_e144, _e143, _e512), _e145, _e514)) / _e517), 340282350000000000000000000000000000000f, (_e1090 || (abs(_e517) < 0.000001f)));
                                    if _e512 {
                                        phi_1679_ = _e1075;
                                    } else {
                                        phi_1679_ = _e502.member;
                                    }
                                    let _e1103 = phi_1679_;
                                    if _e512 {
                                        phi_1684_ = _e1078;
                                    } else {
                                        phi_1684_ = _e502.member_1;
                                    }
                                    let _e1106 = phi_1684_;
                                    if _e512 {
                                        phi_1689_ = _e1100;
                                    } else {
                                        phi_1689_ = _e502.member_2;
                                    }
                                    let _e1109 = phi_1689_;
                                    let _e1111 = (_e490 == 1u);
                                    if _e1111 {
                                        phi_1696_ = _e1075;
                                    } else {
                                        phi_1696_ = _e500.member;
                                    }
                                    let _e1114 = phi_1696_;
                                    if _e1111 {
                                        phi_1701_ = _e1078;
                                    } else {
                                        phi_1701_ = _e500.member_1;
                                    }
                                    let _e1117 = phi_1701_;
                                    if _e1111 {
                                        phi_1706_ = _e1100;
                                    } else {
                                        phi_1706_ = _e500.member_2;
                                    }
                                    let _e1120 = phi_1706_;
                                    if _e514 {
                                        phi_1713_ = _e1075;
                                    } else {
                                        phi_1713_ = _e498.member;
                                    }
                                    let _e1124 = phi_1713_;
                                    if _e514 {
                                        phi_1718_ = _e1078;
                                    } else {
                                        phi_1718_ = _e498.member_1;
                                    }
                                    let _e1127 = phi_1718_;
                                    if _e514 {
                                        phi_1723_ = _e1100;
                                    } else {
                                        phi_1723_ = _e498.member_2;
                                    }
                                    let _e1130 = phi_1723_;
                                    let _e1134 = ((_e1109 <= _e1120) && (_e1109 <= _e1130));
                                    let _e1135 = (_e1120 <= _e1130);
                                    phi_734_ = _e1044;
                                    phi_737_ = type_40(select(select(_e1124, _e1114, _e1135), _e1103, _e1134), select(select(_e1127, _e1117, _e1135), _e1106, _e1134), select(select(_e1130, _e1120, _e1135), _e1109, _e1134));
                                    phi_739_ = select(select(2u, 1u, _e1135), 0u, _e1134);
                                    phi_741_ = (_e492 + 1u);
                                    phi_743_ = _e1046;
                                    phi_745_ = _e1048;
                                    phi_747_ = type_40(_e1124, _e1127, _e1130);
                                    phi_749_ = type_40(_e1114, _e1117, _e1120);
                                    phi_751_ = type_40(_e1103, _e1106, _e1109);
                                } else {
                                    phi_734_ = vec3<f32>();
                                    phi_737_ = type_40();
                                    phi_739_ = u32();
                                    phi_741_ = u32();
                                    phi_743_ = f32();
                                    phi_745_ = f32();
                                    phi_747_ = type_40();
                                    phi_749_ = type_40();
                                    phi_751_ = type_40();
                                }
                                let _e1146 = phi_734_;
                                let _e1148 = phi_737_;
                                let _e1150 = phi_739_;
                                let _e1152 = phi_741_;
                                let _e1154 = phi_743_;
                                let _e1156 = phi_745_;
                                let _e1158 = phi_747_;
                                let _e1160 = phi_749_;
                                let _e1162 = phi_751_;
                                continue;
                                continuing {
                                    phi_733_ = _e1146;
                                    phi_736_ = _e1148;
                                    phi_738_ = _e1150;
                                    phi_740_ = _e1152;
                                    phi_742_ = _e1154;
                                    phi_744_ = _e1156;
                                    phi_746_ = _e1158;
                                    phi_748_ = _e1160;
                                    phi_750_ = _e1162;
                                    break if !(_e510);
                                }
                            }
                            let _e1165 = local_8;
                            let _e1168 = local_9;
                            let _e1171 = local_10;
                            let _e1175 = params.member.member_5;
                            let _e1180 = local_11;
                            let _e1183 = local_12;
                            let _e1186 = local_13;
                            phi_325_ = vec3<f32>((_e205.x + ((_e1165.x + (_e1175.x * _e1180)) * _e229.w)), (_e205.y + ((_e1168.y + (_e1175.y * _e1183)) * _e229.w)), (_e205.z + ((_e1171.z + (_e1175.z * _e1186)) * _e229.w)));
                        } else {
                            phi_325_ = vec3<f32>();
                        }
                        let _e1203 = phi_325_;
                        continue;
                        continuing {
                            phi_321_ = _e218;
                            phi_324_ = _e1203;
                            phi_1854_ = false;
                            break if !(_e224);
                        }
                    }
                    let _e1206 = phi_1854_;
                    if _e1206 {
                        break;
                    }
                    let _e1208 = local_14;
                    let _e1212 = local_15;
                    let _e1216 = local_16;
                    phi_1798_ = vec4<f32>((_e1208.x * 3.1415927f), (_e1212.y * 3.1415927f), (_e1216.z * 3.1415927f), 0f);
                }
                let _e1221 = phi_1798_;
                if (_e95 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e95] = _e1221;
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
