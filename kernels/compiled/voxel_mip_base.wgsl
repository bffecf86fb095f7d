struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_23 {
    member: array<vec4<f32>>,
}

struct type_26 {
    member: vec4<f32>,
    member_1: vec4<u32>,
    member_2: array<vec4<u32>, 10>,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: f32,
    member_8: f32,
    member_9: f32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: vec4<f32>,
    member_16: vec4<f32>,
    member_17: vec4<u32>,
}

struct type_27 {
    member: type_26,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> cells: type_10;
@group(0) @binding(2) 
var<storage> facet_bits: type_10;
@group(0) @binding(3) 
var<storage> facets: type_17;
@group(0) @binding(4) 
var<storage> radiance: type_23;
@group(0) @binding(0) 
var<uniform> params: type_27;
@group(0) @binding(5) 
var<storage> children: type_10;
@group(0) @binding(6) 
var<storage, read_write> out: type_23;

fn function_() {
    var local: array<vec4<f32>, 8>;
    var phi_150_: type_7;
    var phi_153_: u32;
    var phi_151_: type_7;
    var phi_176_: type_7;
    var phi_154_: u32;
    var phi_3541_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_452_: type_7;
    var phi_455_: vec4<f32>;
    var phi_457_: vec4<f32>;
    var phi_453_: type_7;
    var phi_480_: type_7;
    var phi_564_: vec4<f32>;
    var phi_565_: vec4<f32>;
    var phi_456_: vec4<f32>;
    var phi_458_: vec4<f32>;
    var phi_3546_: bool;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var phi_587_: vec4<f32>;
    var local_9: u32;
    var local_10: u32;
    var phi_324_: type_7;
    var phi_327_: vec4<f32>;
    var phi_325_: type_7;
    var phi_350_: type_7;
    var phi_328_: vec4<f32>;
    var phi_3555_: bool;
    var phi_3568_: bool;
    var phi_588_: vec4<f32>;
    var phi_602_: vec4<f32>;
    var local_11: u32;
    var phi_3566_: bool;
    var phi_605_: u32;
    var phi_821_: type_7;
    var phi_824_: vec4<f32>;
    var phi_826_: vec4<f32>;
    var phi_822_: type_7;
    var phi_849_: type_7;
    var phi_933_: vec4<f32>;
    var phi_934_: vec4<f32>;
    var phi_825_: vec4<f32>;
    var phi_827_: vec4<f32>;
    var phi_3562_: bool;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var phi_956_: vec4<f32>;
    var phi_693_: type_7;
    var phi_696_: vec4<f32>;
    var phi_694_: type_7;
    var phi_719_: type_7;
    var phi_697_: vec4<f32>;
    var phi_3571_: bool;
    var phi_3584_: bool;
    var phi_957_: vec4<f32>;
    var phi_971_: vec4<f32>;
    var phi_3582_: bool;
    var phi_974_: u32;
    var phi_1190_: type_7;
    var phi_1193_: vec4<f32>;
    var phi_1195_: vec4<f32>;
    var phi_1191_: type_7;
    var phi_1218_: type_7;
    var phi_1302_: vec4<f32>;
    var phi_1303_: vec4<f32>;
    var phi_1194_: vec4<f32>;
    var phi_1196_: vec4<f32>;
    var phi_3578_: bool;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: vec4<f32>;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var phi_1325_: vec4<f32>;
    var phi_1062_: type_7;
    var phi_1065_: vec4<f32>;
    var phi_1063_: type_7;
    var phi_1088_: type_7;
    var phi_1066_: vec4<f32>;
    var phi_3587_: bool;
    var phi_3600_: bool;
    var phi_1326_: vec4<f32>;
    var phi_1340_: vec4<f32>;
    var phi_3598_: bool;
    var phi_1343_: u32;
    var phi_1559_: type_7;
    var phi_1562_: vec4<f32>;
    var phi_1564_: vec4<f32>;
    var phi_1560_: type_7;
    var phi_1587_: type_7;
    var phi_1671_: vec4<f32>;
    var phi_1672_: vec4<f32>;
    var phi_1563_: vec4<f32>;
    var phi_1565_: vec4<f32>;
    var phi_3594_: bool;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var local_28: vec4<f32>;
    var local_29: vec4<f32>;
    var phi_1694_: vec4<f32>;
    var phi_1431_: type_7;
    var phi_1434_: vec4<f32>;
    var phi_1432_: type_7;
    var phi_1457_: type_7;
    var phi_1435_: vec4<f32>;
    var phi_3603_: bool;
    var phi_3616_: bool;
    var phi_1695_: vec4<f32>;
    var phi_1709_: vec4<f32>;
    var phi_3614_: bool;
    var phi_1712_: u32;
    var phi_1928_: type_7;
    var phi_1931_: vec4<f32>;
    var phi_1933_: vec4<f32>;
    var phi_1929_: type_7;
    var phi_1956_: type_7;
    var phi_2040_: vec4<f32>;
    var phi_2041_: vec4<f32>;
    var phi_1932_: vec4<f32>;
    var phi_1934_: vec4<f32>;
    var phi_3610_: bool;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var phi_2063_: vec4<f32>;
    var phi_1800_: type_7;
    var phi_1803_: vec4<f32>;
    var phi_1801_: type_7;
    var phi_1826_: type_7;
    var phi_1804_: vec4<f32>;
    var phi_3619_: bool;
    var phi_3632_: bool;
    var phi_2064_: vec4<f32>;
    var phi_2078_: vec4<f32>;
    var phi_3630_: bool;
    var phi_2081_: u32;
    var phi_2297_: type_7;
    var phi_2300_: vec4<f32>;
    var phi_2302_: vec4<f32>;
    var phi_2298_: type_7;
    var phi_2325_: type_7;
    var phi_2409_: vec4<f32>;
    var phi_2410_: vec4<f32>;
    var phi_2301_: vec4<f32>;
    var phi_2303_: vec4<f32>;
    var phi_3626_: bool;
    var local_36: vec4<f32>;
    var local_37: vec4<f32>;
    var local_38: vec4<f32>;
    var local_39: vec4<f32>;
    var local_40: vec4<f32>;
    var local_41: vec4<f32>;
    var phi_2432_: vec4<f32>;
    var phi_2169_: type_7;
    var phi_2172_: vec4<f32>;
    var phi_2170_: type_7;
    var phi_2195_: type_7;
    var phi_2173_: vec4<f32>;
    var phi_3635_: bool;
    var phi_3648_: bool;
    var phi_2433_: vec4<f32>;
    var phi_2447_: vec4<f32>;
    var phi_3646_: bool;
    var phi_2450_: u32;
    var phi_2666_: type_7;
    var phi_2669_: vec4<f32>;
    var phi_2671_: vec4<f32>;
    var phi_2667_: type_7;
    var phi_2694_: type_7;
    var phi_2778_: vec4<f32>;
    var phi_2779_: vec4<f32>;
    var phi_2670_: vec4<f32>;
    var phi_2672_: vec4<f32>;
    var phi_3642_: bool;
    var local_42: vec4<f32>;
    var local_43: vec4<f32>;
    var local_44: vec4<f32>;
    var local_45: vec4<f32>;
    var local_46: vec4<f32>;
    var local_47: vec4<f32>;
    var phi_2801_: vec4<f32>;
    var phi_2538_: type_7;
    var phi_2541_: vec4<f32>;
    var phi_2539_: type_7;
    var phi_2564_: type_7;
    var phi_2542_: vec4<f32>;
    var phi_3651_: bool;
    var phi_3664_: bool;
    var phi_2802_: vec4<f32>;
    var phi_2816_: vec4<f32>;
    var phi_3662_: bool;
    var phi_2819_: u32;
    var phi_3035_: type_7;
    var phi_3038_: vec4<f32>;
    var phi_3040_: vec4<f32>;
    var phi_3036_: type_7;
    var phi_3063_: type_7;
    var phi_3147_: vec4<f32>;
    var phi_3148_: vec4<f32>;
    var phi_3039_: vec4<f32>;
    var phi_3041_: vec4<f32>;
    var phi_3658_: bool;
    var local_48: vec4<f32>;
    var local_49: vec4<f32>;
    var local_50: vec4<f32>;
    var local_51: vec4<f32>;
    var local_52: vec4<f32>;
    var local_53: vec4<f32>;
    var phi_3170_: vec4<f32>;
    var phi_2907_: type_7;
    var phi_2910_: vec4<f32>;
    var phi_2908_: type_7;
    var phi_2933_: type_7;
    var phi_2911_: vec4<f32>;
    var phi_3667_: bool;
    var phi_3171_: vec4<f32>;
    var phi_3185_: vec4<f32>;
    var phi_3338_: vec4<f32>;
    var phi_3375_: vec4<f32>;
    var phi_3424_: vec4<f32>;
    var phi_3471_: vec4<f32>;
    var phi_3283_: vec4<f32>;
    var phi_3485_: vec4<f32>;
    var local_54: vec4<f32>;
    var local_55: vec4<f32>;
    var local_56: u32;
    var local_57: vec4<f32>;
    var local_58: vec4<f32>;
    var local_59: vec4<f32>;
    var local_60: vec4<f32>;
    var local_61: vec4<f32>;
    var local_62: vec4<f32>;
    var local_63: vec4<f32>;
    var local_64: vec4<f32>;
    var local_65: vec4<f32>;
    var local_66: vec4<f32>;
    var local_67: vec4<f32>;
    var local_68: vec4<f32>;
    var local_69: vec4<f32>;
    var local_70: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e38 = gid_1;
            let _e40 = arrayLength((&cells.member));
            let _e42 = arrayLength((&facet_bits.member));
            let _e44 = arrayLength((&facets.member));
            let _e46 = arrayLength((&radiance.member));
            let _e53 = params.member.member_12;
            let _e56 = params.member.member_13;
            let _e60 = (_e38.x + (_e38.y * 2097152u));
            if (_e60 < _e56) {
                let _e64 = params.member.member_6;
                if (_e64 == 0u) {
                    break;
                }
                let _e66 = (_e60 / _e64);
                let _e68 = (_e60 - (_e66 * _e64));
                if (_e66 < arrayLength((&children.member))) {
                } else {
                    break;
                }
                let _e72 = children.member[_e66];
                let _e74 = (_e72 >> bitcast<u32>(2i));
                let _e76 = (8u * (_e72 & 3u));
                let _e77 = (2u * _e74);
                if (_e77 < _e40) {
                } else {
                    break;
                }
                let _e81 = cells.member[_e77];
                let _e82 = (_e76 & 31u);
                let _e84 = (_e81 >> bitcast<u32>(_e82));
                let _e85 = (_e74 * 6u);
                let _e86 = (_e77 + 1u);
                if (_e86 < _e40) {
                } else {
                    break;
                }
                let _e90 = cells.member[_e86];
                phi_150_ = type_7(0u, 6u);
                phi_153_ = _e90;
                loop {
                    let _e92 = phi_150_;
                    let _e94 = phi_153_;
                    local_1 = _e94;
                    local_2 = _e94;
                    local_9 = _e94;
                    local_10 = _e94;
                    local_11 = _e94;
                    local_56 = _e94;
                    if (_e92.member < _e92.member_1) {
                        phi_151_ = type_7((_e92.member + 1u), _e92.member_1);
                        phi_176_ = type_7(1u, _e92.member);
                    } else {
                        phi_151_ = _e92;
                        phi_176_ = type_7(0u, type_7().member_1);
                    }
                    let _e107 = phi_151_;
                    let _e109 = phi_176_;
                    let _e113 = (bitcast<i32>(_e109.member) != 0i);
                    if _e113 {
                        let _e114 = (_e85 + _e109.member_1);
                        if (_e114 < _e42) {
                        } else {
                            phi_3541_ = true;
                            break;
                        }
                        let _e118 = facet_bits.member[_e114];
                        phi_154_ = (_e94 + countOneBits((_e118 & ((1u << bitcast<u32>(_e82)) - 1u))));
                    } else {
                        phi_154_ = u32();
                    }
                    let _e126 = phi_154_;
                    continue;
                    continuing {
                        phi_150_ = _e107;
                        phi_153_ = _e126;
                        phi_3541_ = false;
                        break if !(_e113);
                    }
                }
                let _e129 = phi_3541_;
                if _e129 {
                    break;
                }
                let _e131 = (_e68 >> bitcast<u32>(1i));
                let _e133 = ((_e68 & 1u) == 1u);
                let _e134 = select(1f, -1f, _e133);
                let _e135 = (_e131 == 0u);
                let _e136 = select(0f, _e134, _e135);
                let _e138 = select(0f, _e134, (_e131 == 1u));
                let _e139 = (_e131 == 2u);
                let _e140 = select(0f, _e134, _e139);
                local[0u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[1u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[2u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[3u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[4u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[5u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[6u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[7u] = vec4<f32>(0f, 0f, 0f, 0f);
                if ((_e84 & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e154 = facet_bits.member[_e85];
                    let _e158 = (_e85 + 1u);
                    if (_e158 < _e42) {
                    } else {
                        break;
                    }
                    let _e162 = facet_bits.member[_e158];
                    let _e167 = (_e85 + 2u);
                    if (_e167 < _e42) {
                    } else {
                        break;
                    }
                    let _e171 = facet_bits.member[_e167];
                    let _e176 = (_e85 + 3u);
                    if (_e176 < _e42) {
                    } else {
                        break;
                    }
                    let _e180 = facet_bits.member[_e176];
                    let _e185 = (_e85 + 4u);
                    if (_e185 < _e42) {
                    } else {
                        break;
                    }
                    let _e189 = facet_bits.member[_e185];
                    let _e194 = (_e85 + 5u);
                    if (_e194 < _e42) {
                    } else {
                        break;
                    }
                    let _e198 = facet_bits.member[_e194];
                    let _e202 = (((((((_e154 >> bitcast<u32>(_e82)) & 1u) + ((_e162 >> bitcast<u32>(_e82)) & 1u)) + ((_e171 >> bitcast<u32>(_e82)) & 1u)) + ((_e180 >> bitcast<u32>(_e82)) & 1u)) + ((_e189 >> bitcast<u32>(_e82)) & 1u)) + ((_e198 >> bitcast<u32>(_e82)) & 1u));
                    if (_e64 == 1u) {
                        let _e330 = local_9;
                        let _e333 = local_10;
                        phi_324_ = type_7(_e333, (_e330 + _e202));
                        phi_327_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e336 = phi_324_;
                            let _e338 = phi_327_;
                            local_55 = _e338;
                            if (_e336.member < _e336.member_1) {
                                phi_325_ = type_7((_e336.member + 1u), _e336.member_1);
                                phi_350_ = type_7(1u, _e336.member);
                            } else {
                                phi_325_ = _e336;
                                phi_350_ = type_7(0u, type_7().member_1);
                            }
                            let _e351 = phi_325_;
                            let _e353 = phi_350_;
                            let _e357 = (bitcast<i32>(_e353.member) != 0i);
                            if _e357 {
                                let _e358 = (2u * _e353.member_1);
                                if (_e358 < _e46) {
                                } else {
                                    phi_3555_ = true;
                                    break;
                                }
                                let _e363 = radiance.member[_e358][0u];
                                let _e367 = radiance.member[_e358][1u];
                                let _e371 = radiance.member[_e358][2u];
                                let _e372 = (_e358 + 1u);
                                if (_e372 < _e46) {
                                } else {
                                    phi_3555_ = true;
                                    break;
                                }
                                let _e377 = radiance.member[_e372][0u];
                                let _e381 = radiance.member[_e372][1u];
                                let _e385 = radiance.member[_e372][2u];
                                if (_e353.member_1 < _e44) {
                                } else {
                                    phi_3555_ = true;
                                    break;
                                }
                                let _e396 = facets.member[_e353.member_1].member_2;
                                let _e405 = sqrt((((_e396[0] * _e396[0]) + (_e396[1] * _e396[1])) + (_e396[2] * _e396[2])));
                                phi_328_ = vec4<f32>((_e338.x + (select(_e377, _e363, (_e363 > _e377)) * _e405)), (_e338.y + (select(_e381, _e367, (_e367 > _e381)) * _e405)), (_e338.z + (select(_e385, _e371, (_e371 > _e385)) * _e405)), (_e338.w + _e405));
                            } else {
                                phi_328_ = vec4<f32>();
                            }
                            let _e419 = phi_328_;
                            continue;
                            continuing {
                                phi_324_ = _e351;
                                phi_327_ = _e419;
                                phi_3555_ = _e129;
                                break if !(_e357);
                            }
                        }
                        let _e422 = phi_3555_;
                        if _e422 {
                            break;
                        }
                        phi_3568_ = _e422;
                        let _e2731 = local_55;
                        phi_588_ = _e2731;
                    } else {
                        let _e205 = local_1;
                        let _e208 = local_2;
                        phi_452_ = type_7(_e208, (_e205 + _e202));
                        phi_455_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_457_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e211 = phi_452_;
                            let _e213 = phi_455_;
                            let _e215 = phi_457_;
                            local_3 = _e213;
                            local_4 = _e215;
                            local_5 = _e213;
                            local_6 = _e213;
                            local_7 = _e213;
                            local_8 = _e215;
                            local_54 = _e215;
                            if (_e211.member < _e211.member_1) {
                                phi_453_ = type_7((_e211.member + 1u), _e211.member_1);
                                phi_480_ = type_7(1u, _e211.member);
                            } else {
                                phi_453_ = _e211;
                                phi_480_ = type_7(0u, type_7().member_1);
                            }
                            let _e228 = phi_453_;
                            let _e230 = phi_480_;
                            let _e234 = (bitcast<i32>(_e230.member) != 0i);
                            if _e234 {
                                if (_e230.member_1 < _e44) {
                                } else {
                                    phi_3546_ = true;
                                    break;
                                }
                                let _e239 = facets.member[_e230.member_1].member_2;
                                let _e248 = -((((_e136 * _e239[0]) + (_e138 * _e239[1])) + (_e140 * _e239[2])));
                                if (_e248 > 0f) {
                                    let _e271 = (2u * _e230.member_1);
                                    if (_e271 < _e46) {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e275 = radiance.member[_e271];
                                    phi_564_ = _e213;
                                    phi_565_ = vec4<f32>((_e215.x + (_e275.x * _e248)), (_e215.y + (_e275.y * _e248)), (_e215.z + (_e275.z * _e248)), (_e215.w + _e248));
                                } else {
                                    let _e251 = ((2u * _e230.member_1) + 1u);
                                    if (_e251 < _e46) {
                                    } else {
                                        phi_3546_ = true;
                                        break;
                                    }
                                    let _e255 = radiance.member[_e251];
                                    phi_564_ = vec4<f32>((_e213.x - (_e255.x * _e248)), (_e213.y - (_e255.y * _e248)), (_e213.z - (_e255.z * _e248)), (_e213.w - _e248));
                                    phi_565_ = _e215;
                                }
                                let _e292 = phi_564_;
                                let _e294 = phi_565_;
                                phi_456_ = _e292;
                                phi_458_ = _e294;
                            } else {
                                phi_456_ = vec4<f32>();
                                phi_458_ = vec4<f32>();
                            }
                            let _e296 = phi_456_;
                            let _e298 = phi_458_;
                            continue;
                            continuing {
                                phi_452_ = _e228;
                                phi_455_ = _e296;
                                phi_457_ = _e298;
                                phi_3546_ = _e129;
                                break if !(_e234);
                            }
                        }
                        let _e301 = phi_3546_;
                        if _e301 {
                            break;
                        }
                        let _e303 = local_3;
                        let _e306 = local_4;
                        if (_e303.w > _e306.w) {
                            let _e309 = (_e303.w - _e306.w);
                            let _e310 = (_e309 / _e303.w);
                            let _e312 = local_5;
                            let _e316 = local_6;
                            let _e320 = local_7;
                            let _e325 = local_8;
                            phi_587_ = (_e325 + vec4<f32>((_e312.x * _e310), (_e316.y * _e310), (_e320.z * _e310), _e309));
                        } else {
                            let _e2719 = local_54;
                            phi_587_ = _e2719;
                        }
                        let _e328 = phi_587_;
                        phi_3568_ = _e301;
                        phi_588_ = _e328;
                    }
                    let _e424 = phi_3568_;
                    let _e426 = phi_588_;
                    if (_e426.w > 1f) {
                        phi_602_ = vec4<f32>((_e426.x / _e426.w), (_e426.y / _e426.w), (_e426.z / _e426.w), 1f);
                    } else {
                        phi_602_ = _e426;
                    }
                    let _e437 = phi_602_;
                    local[0u] = _e437;
                    let _e439 = local_11;
                    phi_3566_ = _e424;
                    phi_605_ = (_e439 + _e202);
                } else {
                    phi_3566_ = _e129;
                    let _e2737 = local_56;
                    phi_605_ = _e2737;
                }
                let _e442 = phi_3566_;
                let _e444 = phi_605_;
                if (((_e84 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e453 = facet_bits.member[_e85];
                    let _e454 = ((_e76 + 1u) & 31u);
                    let _e458 = (_e85 + 1u);
                    if (_e458 < _e42) {
                    } else {
                        break;
                    }
                    let _e462 = facet_bits.member[_e458];
                    let _e467 = (_e85 + 2u);
                    if (_e467 < _e42) {
                    } else {
                        break;
                    }
                    let _e471 = facet_bits.member[_e467];
                    let _e476 = (_e85 + 3u);
                    if (_e476 < _e42) {
                    } else {
                        break;
                    }
                    let _e480 = facet_bits.member[_e476];
                    let _e485 = (_e85 + 4u);
                    if (_e485 < _e42) {
                    } else {
                        break;
                    }
                    let _e489 = facet_bits.member[_e485];
                    let _e494 = (_e85 + 5u);
                    if (_e494 < _e42) {
                    } else {
                        break;
                    }
                    let _e498 = facet_bits.member[_e494];
                    let _e502 = (((((((_e453 >> bitcast<u32>(_e454)) & 1u) + ((_e462 >> bitcast<u32>(_e454)) & 1u)) + ((_e471 >> bitcast<u32>(_e454)) & 1u)) + ((_e480 >> bitcast<u32>(_e454)) & 1u)) + ((_e489 >> bitcast<u32>(_e454)) & 1u)) + ((_e498 >> bitcast<u32>(_e454)) & 1u));
                    if (_e64 == 1u) {
                        phi_693_ = type_7(_e444, (_e444 + _e502));
                        phi_696_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e628 = phi_693_;
                            let _e630 = phi_696_;
                            local_58 = _e630;
                            if (_e628.member < _e628.member_1) {
                                phi_694_ = type_7((_e628.member + 1u), _e628.member_1);
                                phi_719_ = type_7(1u, _e628.member);
                            } else {
                                phi_694_ = _e628;
                                phi_719_ = type_7(0u, type_7().member_1);
                            }
                            let _e643 = phi_694_;
                            let _e645 = phi_719_;
                            let _e649 = (bitcast<i32>(_e645.member) != 0i);
                            if _e649 {
                                let _e650 = (2u * _e645.member_1);
                                if (_e650 < _e46) {
                                } else {
                                    phi_3571_ = true;
                                    break;
                                }
                                let _e655 = radiance.member[_e650][0u];
                                let _e659 = radiance.member[_e650][1u];
                                let _e663 = radiance.member[_e650][2u];
                                let _e664 = (_e650 + 1u);
                                if (_e664 < _e46) {
                                } else {
                                    phi_3571_ = true;
                                    break;
                                }
                                let _e669 = radiance.member[_e664][0u];
                                let _e673 = radiance.member[_e664][1u];
                                let _e677 = radiance.member[_e664][2u];
                                if (_e645.member_1 < _e44) {
                                } else {
                                    phi_3571_ = true;
                                    break;
                                }
                                let _e688 = facets.member[_e645.member_1].member_2;
                                let _e697 = sqrt((((_e688[0] * _e688[0]) + (_e688[1] * _e688[1])) + (_e688[2] * _e688[2])));
                                phi_697_ = vec4<f32>((_e630.x + (select(_e669, _e655, (_e655 > _e669)) * _e697)), (_e630.y + (select(_e673, _e659, (_e659 > _e673)) * _e697)), (_e630.z + (select(_e677, _e663, (_e663 > _e677)) * _e697)), (_e630.w + _e697));
                            } else {
                                phi_697_ = vec4<f32>();
                            }
                            let _e711 = phi_697_;
                            continue;
                            continuing {
                                phi_693_ = _e643;
                                phi_696_ = _e711;
                                phi_3571_ = _e442;
                                break if !(_e649);
                            }
                        }
                        let _e714 = phi_3571_;
                        if _e714 {
                            break;
                        }
                        phi_3584_ = _e714;
                        let _e2766 = local_58;
                        phi_957_ = _e2766;
                    } else {
                        phi_821_ = type_7(_e444, (_e444 + _e502));
                        phi_824_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_826_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e507 = phi_821_;
                            let _e509 = phi_824_;
                            let _e511 = phi_826_;
                            local_12 = _e509;
                            local_13 = _e511;
                            local_14 = _e509;
                            local_15 = _e509;
                            local_16 = _e509;
                            local_17 = _e511;
                            local_57 = _e511;
                            if (_e507.member < _e507.member_1) {
                                phi_822_ = type_7((_e507.member + 1u), _e507.member_1);
                                phi_849_ = type_7(1u, _e507.member);
                            } else {
                                phi_822_ = _e507;
                                phi_849_ = type_7(0u, type_7().member_1);
                            }
                            let _e524 = phi_822_;
                            let _e526 = phi_849_;
                            let _e530 = (bitcast<i32>(_e526.member) != 0i);
                            if _e530 {
                                if (_e526.member_1 < _e44) {
                                } else {
                                    phi_3562_ = true;
                                    break;
                                }
                                let _e535 = facets.member[_e526.member_1].member_2;
                                let _e544 = -((((_e136 * _e535[0]) + (_e138 * _e535[1])) + (_e140 * _e535[2])));
                                if (_e544 > 0f) {
                                    let _e567 = (2u * _e526.member_1);
                                    if (_e567 < _e46) {
                                    } else {
                                        phi_3562_ = true;
                                        break;
                                    }
                                    let _e571 = radiance.member[_e567];
                                    phi_933_ = _e509;
                                    phi_934_ = vec4<f32>((_e511.x + (_e571.x * _e544)), (_e511.y + (_e571.y * _e544)), (_e511.z + (_e571.z * _e544)), (_e511.w + _e544));
                                } else {
                                    let _e547 = ((2u * _e526.member_1) + 1u);
                                    if (_e547 < _e46) {
                                    } else {
                                        phi_3562_ = true;
                                        break;
                                    }
                                    let _e551 = radiance.member[_e547];
                                    phi_933_ = vec4<f32>((_e509.x - (_e551.x * _e544)), (_e509.y - (_e551.y * _e544)), (_e509.z - (_e551.z * _e544)), (_e509.w - _e544));
                                    phi_934_ = _e511;
                                }
                                let _e588 = phi_933_;
                                let _e590 = phi_934_;
                                phi_825_ = _e588;
                                phi_827_ = _e590;
                            } else {
                                phi_825_ = vec4<f32>();
                                phi_827_ = vec4<f32>();
                            }
                            let _e592 = phi_825_;
                            let _e594 = phi_827_;
                            continue;
                            continuing {
                                phi_821_ = _e524;
                                phi_824_ = _e592;
                                phi_826_ = _e594;
                                phi_3562_ = _e442;
                                break if !(_e530);
                            }
                        }
                        let _e597 = phi_3562_;
                        if _e597 {
                            break;
                        }
                        let _e599 = local_12;
                        let _e602 = local_13;
                        if (_e599.w > _e602.w) {
                            let _e605 = (_e599.w - _e602.w);
                            let _e606 = (_e605 / _e599.w);
                            let _e608 = local_14;
                            let _e612 = local_15;
                            let _e616 = local_16;
                            let _e621 = local_17;
                            phi_956_ = (_e621 + vec4<f32>((_e608.x * _e606), (_e612.y * _e606), (_e616.z * _e606), _e605));
                        } else {
                            let _e2756 = local_57;
                            phi_956_ = _e2756;
                        }
                        let _e624 = phi_956_;
                        phi_3584_ = _e597;
                        phi_957_ = _e624;
                    }
                    let _e716 = phi_3584_;
                    let _e718 = phi_957_;
                    if (_e718.w > 1f) {
                        phi_971_ = vec4<f32>((_e718.x / _e718.w), (_e718.y / _e718.w), (_e718.z / _e718.w), 1f);
                    } else {
                        phi_971_ = _e718;
                    }
                    let _e729 = phi_971_;
                    local[1u] = _e729;
                    phi_3582_ = _e716;
                    phi_974_ = (_e444 + _e502);
                } else {
                    phi_3582_ = _e442;
                    phi_974_ = _e444;
                }
                let _e732 = phi_3582_;
                let _e734 = phi_974_;
                if (((_e84 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e743 = facet_bits.member[_e85];
                    let _e744 = ((_e76 + 2u) & 31u);
                    let _e748 = (_e85 + 1u);
                    if (_e748 < _e42) {
                    } else {
                        break;
                    }
                    let _e752 = facet_bits.member[_e748];
                    let _e757 = (_e85 + 2u);
                    if (_e757 < _e42) {
                    } else {
                        break;
                    }
                    let _e761 = facet_bits.member[_e757];
                    let _e766 = (_e85 + 3u);
                    if (_e766 < _e42) {
                    } else {
                        break;
                    }
                    let _e770 = facet_bits.member[_e766];
                    let _e775 = (_e85 + 4u);
                    if (_e775 < _e42) {
                    } else {
                        break;
                    }
                    let _e779 = facet_bits.member[_e775];
                    let _e784 = (_e85 + 5u);
                    if (_e784 < _e42) {
                    } else {
                        break;
                    }
                    let _e788 = facet_bits.member[_e784];
                    let _e792 = (((((((_e743 >> bitcast<u32>(_e744)) & 1u) + ((_e752 >> bitcast<u32>(_e744)) & 1u)) + ((_e761 >> bitcast<u32>(_e744)) & 1u)) + ((_e770 >> bitcast<u32>(_e744)) & 1u)) + ((_e779 >> bitcast<u32>(_e744)) & 1u)) + ((_e788 >> bitcast<u32>(_e744)) & 1u));
                    if (_e64 == 1u) {
                        phi_1062_ = type_7(_e734, (_e734 + _e792));
                        phi_1065_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e918 = phi_1062_;
                            let _e920 = phi_1065_;
                            local_60 = _e920;
                            if (_e918.member < _e918.member_1) {
                                phi_1063_ = type_7((_e918.member + 1u), _e918.member_1);
                                phi_1088_ = type_7(1u, _e918.member);
                            } else {
                                phi_1063_ = _e918;
                                phi_1088_ = type_7(0u, type_7().member_1);
                            }
                            let _e933 = phi_1063_;
                            let _e935 = phi_1088_;
                            let _e939 = (bitcast<i32>(_e935.member) != 0i);
                            if _e939 {
                                let _e940 = (2u * _e935.member_1);
                                if (_e940 < _e46) {
                                } else {
                                    phi_3587_ = true;
                                    break;
                                }
                                let _e945 = radiance.member[_e940][0u];
                                let _e949 = radiance.member[_e940][1u];
                                let _e953 = radiance.member[_e940][2u];
                                let _e954 = (_e940 + 1u);
                                if (_e954 < _e46) {
                                } else {
                                    phi_3587_ = true;
                                    break;
                                }
                                let _e959 = radiance.member[_e954][0u];
                                let _e963 = radiance.member[_e954][1u];
                                let _e967 = radiance.member[_e954][2u];
                                if (_e935.member_1 < _e44) {
                                } else {
                                    phi_3587_ = true;
                                    break;
                                }
                                let _e978 = facets.member[_e935.member_1].member_2;
                                let _e987 = sqrt((((_e978[0] * _e978[0]) + (_e978[1] * _e978[1])) + (_e978[2] * _e978[2])));
                                phi_1066_ = vec4<f32>((_e920.x + (select(_e959, _e945, (_e945 > _e959)) * _e987)), (_e920.y + (select(_e963, _e949, (_e949 > _e963)) * _e987)), (_e920.z + (select(_e967, _e953, (_e953 > _e967)) * _e987)), (_e920.w + _e987));
                            } else {
                                phi_1066_ = vec4<f32>();
                            }
                            let _e1001 = phi_1066_;
                            continue;
                            continuing {
                                phi_1062_ = _e933;
                                phi_1065_ = _e1001;
                                phi_3587_ = _e732;
                                break if !(_e939);
                            }
                        }
                        let _e1004 = phi_3587_;
                        if _e1004 {
                            break;
                        }
                        phi_3600_ = _e1004;
                        let _e2798 = local_60;
                        phi_1326_ = _e2798;
                    } else {
                        phi_1190_ = type_7(_e734, (_e734 + _e792));
                        phi_1193_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1195_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e797 = phi_1190_;
                            let _e799 = phi_1193_;
                            let _e801 = phi_1195_;
                            local_18 = _e799;
                            local_19 = _e801;
                            local_20 = _e799;
                            local_21 = _e799;
                            local_22 = _e799;
                            local_23 = _e801;
                            local_59 = _e801;
                            if (_e797.member < _e797.member_1) {
                                phi_1191_ = type_7((_e797.member + 1u), _e797.member_1);
                                phi_1218_ = type_7(1u, _e797.member);
                            } else {
                                phi_1191_ = _e797;
                                phi_1218_ = type_7(0u, type_7().member_1);
                            }
                            let _e814 = phi_1191_;
                            let _e816 = phi_1218_;
                            let _e820 = (bitcast<i32>(_e816.member) != 0i);
                            if _e820 {
                                if (_e816.member_1 < _e44) {
                                } else {
                                    phi_3578_ = true;
                                    break;
                                }
                                let _e825 = facets.member[_e816.member_1].member_2;
                                let _e834 = -((((_e136 * _e825[0]) + (_e138 * _e825[1])) + (_e140 * _e825[2])));
                                if (_e834 > 0f) {
                                    let _e857 = (2u * _e816.member_1);
                                    if (_e857 < _e46) {
                                    } else {
                                        phi_3578_ = true;
                                        break;
                                    }
                                    let _e861 = radiance.member[_e857];
                                    phi_1302_ = _e799;
                                    phi_1303_ = vec4<f32>((_e801.x + (_e861.x * _e834)), (_e801.y + (_e861.y * _e834)), (_e801.z + (_e861.z * _e834)), (_e801.w + _e834));
                                } else {
                                    let _e837 = ((2u * _e816.member_1) + 1u);
                                    if (_e837 < _e46) {
                                    } else {
                                        phi_3578_ = true;
                                        break;
                                    }
                                    let _e841 = radiance.member[_e837];
                                    phi_1302_ = vec4<f32>((_e799.x - (_e841.x * _e834)), (_e799.y - (_e841.y * _e834)), (_e799.z - (_e841.z * _e834)), (_e799.w - _e834));
                                    phi_1303_ = _e801;
                                }
                                let _e878 = phi_1302_;
                                let _e880 = phi_1303_;
                                phi_1194_ = _e878;
                                phi_1196_ = _e880;
                            } else {
                                phi_1194_ = vec4<f32>();
                                phi_1196_ = vec4<f32>();
                            }
                            let _e882 = phi_1194_;
                            let _e884 = phi_1196_;
                            continue;
                            continuing {
                                phi_1190_ = _e814;
                                phi_1193_ = _e882;
                                phi_1195_ = _e884;
                                phi_3578_ = _e732;
                                break if !(_e820);
                            }
                        }
                        let _e887 = phi_3578_;
                        if _e887 {
                            break;
                        }
                        let _e889 = local_18;
                        let _e892 = local_19;
                        if (_e889.w > _e892.w) {
                            let _e895 = (_e889.w - _e892.w);
                            let _e896 = (_e895 / _e889.w);
                            let _e898 = local_20;
                            let _e902 = local_21;
                            let _e906 = local_22;
                            let _e911 = local_23;
                            phi_1325_ = (_e911 + vec4<f32>((_e898.x * _e896), (_e902.y * _e896), (_e906.z * _e896), _e895));
                        } else {
                            let _e2788 = local_59;
                            phi_1325_ = _e2788;
                        }
                        let _e914 = phi_1325_;
                        phi_3600_ = _e887;
                        phi_1326_ = _e914;
                    }
                    let _e1006 = phi_3600_;
                    let _e1008 = phi_1326_;
                    if (_e1008.w > 1f) {
                        phi_1340_ = vec4<f32>((_e1008.x / _e1008.w), (_e1008.y / _e1008.w), (_e1008.z / _e1008.w), 1f);
                    } else {
                        phi_1340_ = _e1008;
                    }
                    let _e1019 = phi_1340_;
                    local[2u] = _e1019;
                    phi_3598_ = _e1006;
                    phi_1343_ = (_e734 + _e792);
                } else {
                    phi_3598_ = _e732;
                    phi_1343_ = _e734;
                }
                let _e1022 = phi_3598_;
                let _e1024 = phi_1343_;
                if (((_e84 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e1033 = facet_bits.member[_e85];
                    let _e1034 = ((_e76 + 3u) & 31u);
                    let _e1038 = (_e85 + 1u);
                    if (_e1038 < _e42) {
                    } else {
                        break;
                    }
                    let _e1042 = facet_bits.member[_e1038];
                    let _e1047 = (_e85 + 2u);
                    if (_e1047 < _e42) {
                    } else {
                        break;
                    }
                    let _e1051 = facet_bits.member[_e1047];
                    let _e1056 = (_e85 + 3u);
                    if (_e1056 < _e42) {
                    } else {
                        break;
                    }
                    let _e1060 = facet_bits.member[_e1056];
                    let _e1065 = (_e85 + 4u);
                    if (_e1065 < _e42) {
                    } else {
                        break;
                    }
                    let _e1069 = facet_bits.member[_e1065];
                    let _e1074 = (_e85 + 5u);
                    if (_e1074 < _e42) {
                    } else {
                        break;
                    }
                    let _e1078 = facet_bits.member[_e1074];
                    let _e1082 = (((((((_e1033 >> bitcast<u32>(_e1034)) & 1u) + ((_e1042 >> bitcast<u32>(_e1034)) & 1u)) + ((_e1051 >> bitcast<u32>(_e1034)) & 1u)) + ((_e1060 >> bitcast<u32>(_e1034)) & 1u)) + ((_e1069 >> bitcast<u32>(_e1034)) & 1u)) + ((_e1078 >> bitcast<u32>(_e1034)) & 1u));
                    if (_e64 == 1u) {
                        phi_1431_ = type_7(_e1024, (_e1024 + _e1082));
                        phi_1434_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1208 = phi_1431_;
                            let _e1210 = phi_1434_;
                            local_62 = _e1210;
                            if (_e1208.member < _e1208.member_1) {
                                phi_1432_ = type_7((_e1208.member + 1u), _e1208.member_1);
                                phi_1457_ = type_7(1u, _e1208.member);
                            } else {
                                phi_1432_ = _e1208;
                                phi_1457_ = type_7(0u, type_7().member_1);
                            }
                            let _e1223 = phi_1432_;
                            let _e1225 = phi_1457_;
                            let _e1229 = (bitcast<i32>(_e1225.member) != 0i);
                            if _e1229 {
                                let _e1230 = (2u * _e1225.member_1);
                                if (_e1230 < _e46) {
                                } else {
                                    phi_3603_ = true;
                                    break;
                                }
                                let _e1235 = radiance.member[_e1230][0u];
                                let _e1239 = radiance.member[_e1230][1u];
                                let _e1243 = radiance.member[_e1230][2u];
                                let _e1244 = (_e1230 + 1u);
                                if (_e1244 < _e46) {
                                } else {
                                    phi_3603_ = true;
                                    break;
                                }
                                let _e1249 = radiance.member[_e1244][0u];
                                let _e1253 = radiance.member[_e1244][1u];
                                let _e1257 = radiance.member[_e1244][2u];
                                if (_e1225.member_1 < _e44) {
                                } else {
                                    phi_3603_ = true;
                                    break;
                                }
                                let _e1268 = facets.member[_e1225.member_1].member_2;
                                let _e1277 = sqrt((((_e1268[0] * _e1268[0]) + (_e1268[1] * _e1268[1])) + (_e1268[2] * _e1268[2])));
                                phi_1435_ = vec4<f32>((_e1210.x + (select(_e1249, _e1235, (_e1235 > _e1249)) * _e1277)), (_e1210.y + (select(_e1253, _e1239, (_e1239 > _e1253)) * _e1277)), (_e1210.z + (select(_e1257, _e1243, (_e1243 > _e1257)) * _e1277)), (_e1210.w + _e1277));
                            } else {
                                phi_1435_ = vec4<f32>();
                            }
                            let _e1291 = phi_1435_;
                            continue;
                            continuing {
                                phi_1431_ = _e1223;
                                phi_1434_ = _e1291;
                                phi_3603_ = _e1022;
                                break if !(_e1229);
                            }
                        }
                        let _e1294 = phi_3603_;
                        if _e1294 {
                            break;
                        }
                        phi_3616_ = _e1294;
                        let _e2830 = local_62;
                        phi_1695_ = _e2830;
                    } else {
                        phi_1559_ = type_7(_e1024, (_e1024 + _e1082));
                        phi_1562_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1564_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1087 = phi_1559_;
                            let _e1089 = phi_1562_;
                            let _e1091 = phi_1564_;
                            local_24 = _e1089;
                            local_25 = _e1091;
                            local_26 = _e1089;
                            local_27 = _e1089;
                            local_28 = _e1089;
                            local_29 = _e1091;
                            local_61 = _e1091;
                            if (_e1087.member < _e1087.member_1) {
                                phi_1560_ = type_7((_e1087.member + 1u), _e1087.member_1);
                                phi_1587_ = type_7(1u, _e1087.member);
                            } else {
                                phi_1560_ = _e1087;
                                phi_1587_ = type_7(0u, type_7().member_1);
                            }
                            let _e1104 = phi_1560_;
                            let _e1106 = phi_1587_;
                            let _e1110 = (bitcast<i32>(_e1106.member) != 0i);
                            if _e1110 {
                                if (_e1106.member_1 < _e44) {
                                } else {
                                    phi_3594_ = true;
                                    break;
                                }
                                let _e1115 = facets.member[_e1106.member_1].member_2;
                                let _e1124 = -((((_e136 * _e1115[0]) + (_e138 * _e1115[1])) + (_e140 * _e1115[2])));
                                if (_e1124 > 0f) {
                                    let _e1147 = (2u * _e1106.member_1);
                                    if (_e1147 < _e46) {
                                    } else {
                                        phi_3594_ = true;
                                        break;
                                    }
                                    let _e1151 = radiance.member[_e1147];
                                    phi_1671_ = _e1089;
                                    phi_1672_ = vec4<f32>((_e1091.x + (_e1151.x * _e1124)), (_e1091.y + (_e1151.y * _e1124)), (_e1091.z + (_e1151.z * _e1124)), (_e1091.w + _e1124));
                                } else {
                                    let _e1127 = ((2u * _e1106.member_1) + 1u);
                                    if (_e1127 < _e46) {
                                    } else {
                                        phi_3594_ = true;
                                        break;
                                    }
                                    let _e1131 = radiance.member[_e1127];
                                    phi_1671_ = vec4<f32>((_e1089.x - (_e1131.x * _e1124)), (_e1089.y - (_e1131.y * _e1124)), (_e1089.z - (_e1131.z * _e1124)), (_e1089.w - _e1124));
                                    phi_1672_ = _e1091;
                                }
                                let _e1168 = phi_1671_;
                                let _e1170 = phi_1672_;
                                phi_1563_ = _e1168;
                                phi_1565_ = _e1170;
                            } else {
                                phi_1563_ = vec4<f32>();
                                phi_1565_ = vec4<f32>();
                            }
                            let _e1172 = phi_1563_;
                            let _e1174 = phi_1565_;
                            continue;
                            continuing {
                                phi_1559_ = _e1104;
                                phi_1562_ = _e1172;
                                phi_1564_ = _e1174;
                                phi_3594_ = _e1022;
                                break if !(_e1110);
                            }
                        }
                        let _e1177 = phi_3594_;
                        if _e1177 {
                            break;
                        }
                        let _e1179 = local_24;
                        let _e1182 = local_25;
                        if (_e1179.w > _e1182.w) {
                            let _e1185 = (_e1179.w - _e1182.w);
                            let _e1186 = (_e1185 / _e1179.w);
                            let _e1188 = local_26;
                            let _e1192 = local_27;
                            let _e1196 = local_28;
                            let _e1201 = local_29;
                            phi_1694_ = (_e1201 + vec4<f32>((_e1188.x * _e1186), (_e1192.y * _e1186), (_e1196.z * _e1186), _e1185));
                        } else {
                            let _e2820 = local_61;
                            phi_1694_ = _e2820;
                        }
                        let _e1204 = phi_1694_;
                        phi_3616_ = _e1177;
                        phi_1695_ = _e1204;
                    }
                    let _e1296 = phi_3616_;
                    let _e1298 = phi_1695_;
                    if (_e1298.w > 1f) {
                        phi_1709_ = vec4<f32>((_e1298.x / _e1298.w), (_e1298.y / _e1298.w), (_e1298.z / _e1298.w), 1f);
                    } else {
                        phi_1709_ = _e1298;
                    }
                    let _e1309 = phi_1709_;
                    local[3u] = _e1309;
                    phi_3614_ = _e1296;
                    phi_1712_ = (_e1024 + _e1082);
                } else {
                    phi_3614_ = _e1022;
                    phi_1712_ = _e1024;
                }
                let _e1312 = phi_3614_;
                let _e1314 = phi_1712_;
                if (((_e84 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e1323 = facet_bits.member[_e85];
                    let _e1324 = ((_e76 + 4u) & 31u);
                    let _e1328 = (_e85 + 1u);
                    if (_e1328 < _e42) {
                    } else {
                        break;
                    }
                    let _e1332 = facet_bits.member[_e1328];
                    let _e1337 = (_e85 + 2u);
                    if (_e1337 < _e42) {
                    } else {
                        break;
                    }
                    let _e1341 = facet_bits.member[_e1337];
                    let _e1346 = (_e85 + 3u);
                    if (_e1346 < _e42) {
                    } else {
                        break;
                    }
                    let _e1350 = facet_bits.member[_e1346];
                    let _e1355 = (_e85 + 4u);
                    if (_e1355 < _e42) {
                    } else {
                        break;
                    }
                    let _e1359 = facet_bits.member[_e1355];
                    let _e1364 = (_e85 + 5u);
                    if (_e1364 < _e42) {
                    } else {
                        break;
                    }
                    let _e1368 = facet_bits.member[_e1364];
                    let _e1372 = (((((((_e1323 >> bitcast<u32>(_e1324)) & 1u) + ((_e1332 >> bitcast<u32>(_e1324)) & 1u)) + ((_e1341 >> bitcast<u32>(_e1324)) & 1u)) + ((_e1350 >> bitcast<u32>(_e1324)) & 1u)) + ((_e1359 >> bitcast<u32>(_e1324)) & 1u)) + ((_e1368 >> bitcast<u32>(_e1324)) & 1u));
                    if (_e64 == 1u) {
                        phi_1800_ = type_7(_e1314, (_e1314 + _e1372));
                        phi_1803_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1498 = phi_1800_;
                            let _e1500 = phi_1803_;
                            local_64 = _e1500;
                            if (_e1498.member < _e1498.member_1) {
                                phi_1801_ = type_7((_e1498.member + 1u), _e1498.member_1);
                                phi_1826_ = type_7(1u, _e1498.member);
                            } else {
                                phi_1801_ = _e1498;
                                phi_1826_ = type_7(0u, type_7().member_1);
                            }
                            let _e1513 = phi_1801_;
                            let _e1515 = phi_1826_;
                            let _e1519 = (bitcast<i32>(_e1515.member) != 0i);
                            if _e1519 {
                                let _e1520 = (2u * _e1515.member_1);
                                if (_e1520 < _e46) {
                                } else {
                                    phi_3619_ = true;
                                    break;
                                }
                                let _e1525 = radiance.member[_e1520][0u];
                                let _e1529 = radiance.member[_e1520][1u];
                                let _e1533 = radiance.member[_e1520][2u];
                                let _e1534 = (_e1520 + 1u);
                                if (_e1534 < _e46) {
                                } else {
                                    phi_3619_ = true;
                                    break;
                                }
                                let _e1539 = radiance.member[_e1534][0u];
                                let _e1543 = radiance.member[_e1534][1u];
                                let _e1547 = radiance.member[_e1534][2u];
                                if (_e1515.member_1 < _e44) {
                                } else {
                                    phi_3619_ = true;
                                    break;
                                }
                                let _e1558 = facets.member[_e1515.member_1].member_2;
                                let _e1567 = sqrt((((_e1558[0] * _e1558[0]) + (_e1558[1] * _e1558[1])) + (_e1558[2] * _e1558[2])));
                                phi_1804_ = vec4<f32>((_e1500.x + (select(_e1539, _e1525, (_e1525 > _e1539)) * _e1567)), (_e1500.y + (select(_e1543, _e1529, (_e1529 > _e1543)) * _e1567)), (_e1500.z + (select(_e1547, _e1533, (_e1533 > _e1547)) * _e1567)), (_e1500.w + _e1567));
                            } else {
                                phi_1804_ = vec4<f32>();
                            }
                            let _e1581 = phi_1804_;
                            continue;
                            continuing {
                                phi_1800_ = _e1513;
                                phi_1803_ = _e1581;
                                phi_3619_ = _e1312;
                                break if !(_e1519);
                            }
                        }
                        let _e1584 = phi_3619_;
                        if _e1584 {
                            break;
                        }
                        phi_3632_ = _e1584;
                        let _e2862 = local_64;
                        phi_2064_ = _e2862;
                    } else {
                        phi_1928_ = type_7(_e1314, (_e1314 + _e1372));
                        phi_1931_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1933_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1377 = phi_1928_;
                            let _e1379 = phi_1931_;
                            let _e1381 = phi_1933_;
                            local_30 = _e1379;
                            local_31 = _e1381;
                            local_32 = _e1379;
                            local_33 = _e1379;
                            local_34 = _e1379;
                            local_35 = _e1381;
                            local_63 = _e1381;
                            if (_e1377.member < _e1377.member_1) {
                                phi_1929_ = type_7((_e1377.member + 1u), _e1377.member_1);
                                phi_1956_ = type_7(1u, _e1377.member);
                            } else {
                                phi_1929_ = _e1377;
                                phi_1956_ = type_7(0u, type_7().member_1);
                            }
                            let _e1394 = phi_1929_;
                            let _e1396 = phi_1956_;
                            let _e1400 = (bitcast<i32>(_e1396.member) != 0i);
                            if _e1400 {
                                if (_e1396.member_1 < _e44) {
                                } else {
                                    phi_3610_ = true;
                                    break;
                                }
                                let _e1405 = facets.member[_e1396.member_1].member_2;
                                let _e1414 = -((((_e136 * _e1405[0]) + (_e138 * _e1405[1])) + (_e140 * _e1405[2])));
                                if (_e1414 > 0f) {
                                    let _e1437 = (2u * _e1396.member_1);
                                    if (_e1437 < _e46) {
                                    } else {
                                        phi_3610_ = true;
                                        break;
                                    }
                                    let _e1441 = radiance.member[_e1437];
                                    phi_2040_ = _e1379;
                                    phi_2041_ = vec4<f32>((_e1381.x + (_e1441.x * _e1414)), (_e1381.y + (_e1441.y * _e1414)), (_e1381.z + (_e1441.z * _e1414)), (_e1381.w + _e1414));
                                } else {
                                    let _e1417 = ((2u * _e1396.member_1) + 1u);
                                    if (_e1417 < _e46) {
                                    } else {
                                        phi_3610_ = true;
                                        break;
                                    }
                                    let _e1421 = radiance.member[_e1417];
                                    phi_2040_ = vec4<f32>((_e1379.x - (_e1421.x * _e1414)), (_e1379.y - (_e1421.y * _e1414)), (_e1379.z - (_e1421.z * _e1414)), (_e1379.w - _e1414));
                                    phi_2041_ = _e1381;
                                }
                                let _e1458 = phi_2040_;
                                let _e1460 = phi_2041_;
                                phi_1932_ = _e1458;
                                phi_1934_ = _e1460;
                            } else {
                                phi_1932_ = vec4<f32>();
                                phi_1934_ = vec4<f32>();
                            }
                            let _e1462 = phi_1932_;
                            let _e1464 = phi_1934_;
                            continue;
                            continuing {
                                phi_1928_ = _e1394;
                                phi_1931_ = _e1462;
                                phi_1933_ = _e1464;
                                phi_3610_ = _e1312;
                                break if !(_e1400);
                            }
                        }
                        let _e1467 = phi_3610_;
                        if _e1467 {
                            break;
                        }
                        let _e1469 = local_30;
                        let _e1472 = local_31;
                        if (_e1469.w > _e1472.w) {
                            let _e1475 = (_e1469.w - _e1472.w);
                            let _e1476 = (_e1475 / _e1469.w);
                            let _e1478 = local_32;
                            let _e1482 = local_33;
                            let _e1486 = local_34;
                            let _e1491 = local_35;
                            phi_2063_ = (_e1491 + vec4<f32>((_e1478.x * _e1476), (_e1482.y * _e1476), (_e1486.z * _e1476), _e1475));
                        } else {
                            let _e2852 = local_63;
                            phi_2063_ = _e2852;
                        }
                        let _e1494 = phi_2063_;
                        phi_3632_ = _e1467;
                        phi_2064_ = _e1494;
                    }
                    let _e1586 = phi_3632_;
                    let _e1588 = phi_2064_;
                    if (_e1588.w > 1f) {
                        phi_2078_ = vec4<f32>((_e1588.x / _e1588.w), (_e1588.y / _e1588.w), (_e1588.z / _e1588.w), 1f);
                    } else {
                        phi_2078_ = _e1588;
                    }
                    let _e1599 = phi_2078_;
                    local[4u] = _e1599;
                    phi_3630_ = _e1586;
                    phi_2081_ = (_e1314 + _e1372);
                } else {
                    phi_3630_ = _e1312;
                    phi_2081_ = _e1314;
                }
                let _e1602 = phi_3630_;
                let _e1604 = phi_2081_;
                if (((_e84 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e1613 = facet_bits.member[_e85];
                    let _e1614 = ((_e76 + 5u) & 31u);
                    let _e1618 = (_e85 + 1u);
                    if (_e1618 < _e42) {
                    } else {
                        break;
                    }
                    let _e1622 = facet_bits.member[_e1618];
                    let _e1627 = (_e85 + 2u);
                    if (_e1627 < _e42) {
                    } else {
                        break;
                    }
                    let _e1631 = facet_bits.member[_e1627];
                    let _e1636 = (_e85 + 3u);
                    if (_e1636 < _e42) {
                    } else {
                        break;
                    }
                    let _e1640 = facet_bits.member[_e1636];
                    let _e1645 = (_e85 + 4u);
                    if (_e1645 < _e42) {
                    } else {
                        break;
                    }
                    let _e1649 = facet_bits.member[_e1645];
                    let _e1654 = (_e85 + 5u);
                    if (_e1654 < _e42) {
                    } else {
                        break;
                    }
                    let _e1658 = facet_bits.member[_e1654];
                    let _e1662 = (((((((_e1613 >> bitcast<u32>(_e1614)) & 1u) + ((_e1622 >> bitcast<u32>(_e1614)) & 1u)) + ((_e1631 >> bitcast<u32>(_e1614)) & 1u)) + ((_e1640 >> bitcast<u32>(_e1614)) & 1u)) + ((_e1649 >> bitcast<u32>(_e1614)) & 1u)) + ((_e1658 >> bitcast<u32>(_e1614)) & 1u));
                    if (_e64 == 1u) {
                        phi_2169_ = type_7(_e1604, (_e1604 + _e1662));
                        phi_2172_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1788 = phi_2169_;
                            let _e1790 = phi_2172_;
                            local_66 = _e1790;
                            if (_e1788.member < _e1788.member_1) {
                                phi_2170_ = type_7((_e1788.member + 1u), _e1788.member_1);
                                phi_2195_ = type_7(1u, _e1788.member);
                            } else {
                                phi_2170_ = _e1788;
                                phi_2195_ = type_7(0u, type_7().member_1);
                            }
                            let _e1803 = phi_2170_;
                            let _e1805 = phi_2195_;
                            let _e1809 = (bitcast<i32>(_e1805.member) != 0i);
                            if _e1809 {
                                let _e1810 = (2u * _e1805.member_1);
                                if (_e1810 < _e46) {
                                } else {
                                    phi_3635_ = true;
                                    break;
                                }
                                let _e1815 = radiance.member[_e1810][0u];
                                let _e1819 = radiance.member[_e1810][1u];
                                let _e1823 = radiance.member[_e1810][2u];
                                let _e1824 = (_e1810 + 1u);
                                if (_e1824 < _e46) {
                                } else {
                                    phi_3635_ = true;
                                    break;
                                }
                                let _e1829 = radiance.member[_e1824][0u];
                                let _e1833 = radiance.member[_e1824][1u];
                                let _e1837 = radiance.member[_e1824][2u];
                                if (_e1805.member_1 < _e44) {
                                } else {
                                    phi_3635_ = true;
                                    break;
                                }
                                let _e1848 = facets.member[_e1805.member_1].member_2;
                                let _e1857 = sqrt((((_e1848[0] * _e1848[0]) + (_e1848[1] * _e1848[1])) + (_e1848[2] * _e1848[2])));
                                phi_2173_ = vec4<f32>((_e1790.x + (select(_e1829, _e1815, (_e1815 > _e1829)) * _e1857)), (_e1790.y + (select(_e1833, _e1819, (_e1819 > _e1833)) * _e1857)), (_e1790.z + (select(_e1837, _e1823, (_e1823 > _e1837)) * _e1857)), (_e1790.w + _e1857));
                            } else {
                                phi_2173_ = vec4<f32>();
                            }
                            let _e1871 = phi_2173_;
                            continue;
                            continuing {
                                phi_2169_ = _e1803;
                                phi_2172_ = _e1871;
                                phi_3635_ = _e1602;
                                break if !(_e1809);
                            }
                        }
                        let _e1874 = phi_3635_;
                        if _e1874 {
                            break;
                        }
                        phi_3648_ = _e1874;
                        let _e2894 = local_66;
                        phi_2433_ = _e2894;
                    } else {
                        phi_2297_ = type_7(_e1604, (_e1604 + _e1662));
                        phi_2300_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_2302_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1667 = phi_2297_;
                            let _e1669 = phi_2300_;
                            let _e1671 = phi_2302_;
                            local_36 = _e1669;
                            local_37 = _e1671;
                            local_38 = _e1669;
                            local_39 = _e1669;
                            local_40 = _e1669;
                            local_41 = _e1671;
                            local_65 = _e1671;
                            if (_e1667.member < _e1667.member_1) {
                                phi_2298_ = type_7((_e1667.member + 1u), _e1667.member_1);
                                phi_2325_ = type_7(1u, _e1667.member);
                            } else {
                                phi_2298_ = _e1667;
                                phi_2325_ = type_7(0u, type_7().member_1);
                            }
                            let _e1684 = phi_2298_;
                            let _e1686 = phi_2325_;
                            let _e1690 = (bitcast<i32>(_e1686.member) != 0i);
                            if _e1690 {
                                if (_e1686.member_1 < _e44) {
                                } else {
                                    phi_3626_ = true;
                                    break;
                                }
                                let _e1695 = facets.member[_e1686.member_1].member_2;
                                let _e1704 = -((((_e136 * _e1695[0]) + (_e138 * _e1695[1])) + (_e140 * _e1695[2])));
                                if (_e1704 > 0f) {
                                    let _e1727 = (2u * _e1686.member_1);
                                    if (_e1727 < _e46) {
                                    } else {
                                        phi_3626_ = true;
                                        break;
                                    }
                                    let _e1731 = radiance.member[_e1727];
                                    phi_2409_ = _e1669;
                                    phi_2410_ = vec4<f32>((_e1671.x + (_e1731.x * _e1704)), (_e1671.y + (_e1731.y * _e1704)), (_e1671.z + (_e1731.z * _e1704)), (_e1671.w + _e1704));
                                } else {
                                    let _e1707 = ((2u * _e1686.member_1) + 1u);
                                    if (_e1707 < _e46) {
                                    } else {
                                        phi_3626_ = true;
                                        break;
                                    }
                                    let _e1711 = radiance.member[_e1707];
                                    phi_2409_ = vec4<f32>((_e1669.x - (_e1711.x * _e1704)), (_e1669.y - (_e1711.y * _e1704)), (_e1669.z - (_e1711.z * _e1704)), (_e1669.w - _e1704));
                                    phi_2410_ = _e1671;
                                }
                                let _e1748 = phi_2409_;
                                let _e1750 = phi_2410_;
                                phi_2301_ = _e1748;
                                phi_2303_ = _e1750;
                            } else {
                                phi_2301_ = vec4<f32>();
                                phi_2303_ = vec4<f32>();
                            }
                            let _e1752 = phi_2301_;
                            let _e1754 = phi_2303_;
                            continue;
                            continuing {
                                phi_2297_ = _e1684;
                                phi_2300_ = _e1752;
                                phi_2302_ = _e1754;
                                phi_3626_ = _e1602;
                                break if !(_e1690);
                            }
                        }
                        let _e1757 = phi_3626_;
                        if _e1757 {
                            break;
                        }
                        let _e1759 = local_36;
                        let _e1762 = local_37;
                        if (_e1759.w > _e1762.w) {
                            let _e1765 = (_e1759.w - _e1762.w);
                            let _e1766 = (_e1765 / _e1759.w);
                            let _e1768 = local_38;
                            let _e1772 = local_39;
                            let _e1776 = local_40;
                            let _e1781 = local_41;
                            phi_2432_ = (_e1781 + vec4<f32>((_e1768.x * _e1766), (_e1772.y * _e1766), (_e1776.z * _e1766), _e1765));
                        } else {
                            let _e2884 = local_65;
                            phi_2432_ = _e2884;
                        }
                        let _e1784 = phi_2432_;
                        phi_3648_ = _e1757;
                        phi_2433_ = _e1784;
                    }
                    let _e1876 = phi_3648_;
                    let _e1878 = phi_2433_;
                    if (_e1878.w > 1f) {
                        phi_2447_ = vec4<f32>((_e1878.x / _e1878.w), (_e1878.y / _e1878.w), (_e1878.z / _e1878.w), 1f);
                    } else {
                        phi_2447_ = _e1878;
                    }
                    let _e1889 = phi_2447_;
                    local[5u] = _e1889;
                    phi_3646_ = _e1876;
                    phi_2450_ = (_e1604 + _e1662);
                } else {
                    phi_3646_ = _e1602;
                    phi_2450_ = _e1604;
                }
                let _e1892 = phi_3646_;
                let _e1894 = phi_2450_;
                if (((_e84 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e1903 = facet_bits.member[_e85];
                    let _e1904 = ((_e76 + 6u) & 31u);
                    let _e1908 = (_e85 + 1u);
                    if (_e1908 < _e42) {
                    } else {
                        break;
                    }
                    let _e1912 = facet_bits.member[_e1908];
                    let _e1917 = (_e85 + 2u);
                    if (_e1917 < _e42) {
                    } else {
                        break;
                    }
                    let _e1921 = facet_bits.member[_e1917];
                    let _e1926 = (_e85 + 3u);
                    if (_e1926 < _e42) {
                    } else {
                        break;
                    }
                    let _e1930 = facet_bits.member[_e1926];
                    let _e1935 = (_e85 + 4u);
                    if (_e1935 < _e42) {
                    } else {
                        break;
                    }
                    let _e1939 = facet_bits.member[_e1935];
                    let _e1944 = (_e85 + 5u);
                    if (_e1944 < _e42) {
                    } else {
                        break;
                    }
                    let _e1948 = facet_bits.member[_e1944];
                    let _e1952 = (((((((_e1903 >> bitcast<u32>(_e1904)) & 1u) + ((_e1912 >> bitcast<u32>(_e1904)) & 1u)) + ((_e1921 >> bitcast<u32>(_e1904)) & 1u)) + ((_e1930 >> bitcast<u32>(_e1904)) & 1u)) + ((_e1939 >> bitcast<u32>(_e1904)) & 1u)) + ((_e1948 >> bitcast<u32>(_e1904)) & 1u));
                    if (_e64 == 1u) {
                        phi_2538_ = type_7(_e1894, (_e1894 + _e1952));
                        phi_2541_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e2078 = phi_2538_;
                            let _e2080 = phi_2541_;
                            local_68 = _e2080;
                            if (_e2078.member < _e2078.member_1) {
                                phi_2539_ = type_7((_e2078.member + 1u), _e2078.member_1);
                                phi_2564_ = type_7(1u, _e2078.member);
                            } else {
                                phi_2539_ = _e2078;
                                phi_2564_ = type_7(0u, type_7().member_1);
                            }
                            let _e2093 = phi_2539_;
                            let _e2095 = phi_2564_;
                            let _e2099 = (bitcast<i32>(_e2095.member) != 0i);
                            if _e2099 {
                                let _e2100 = (2u * _e2095.member_1);
                                if (_e2100 < _e46) {
                                } else {
                                    phi_3651_ = true;
                                    break;
                                }
                                let _e2105 = radiance.member[_e2100][0u];
                                let _e2109 = radiance.member[_e2100][1u];
                                let _e2113 = radiance.member[_e2100][2u];
                                let _e2114 = (_e2100 + 1u);
                                if (_e2114 < _e46) {
                                } else {
                                    phi_3651_ = true;
                                    break;
                                }
                                let _e2119 = radiance.member[_e2114][0u];
                                let _e2123 = radiance.member[_e2114][1u];
                                let _e2127 = radiance.member[_e2114][2u];
                                if (_e2095.member_1 < _e44) {
                                } else {
                                    phi_3651_ = true;
                                    break;
                                }
                                let _e2138 = facets.member[_e2095.member_1].member_2;
                                let _e2147 = sqrt((((_e2138[0] * _e2138[0]) + (_e2138[1] * _e2138[1])) + (_e2138[2] * _e2138[2])));
                                phi_2542_ = vec4<f32>((_e2080.x + (select(_e2119, _e2105, (_e2105 > _e2119)) * _e2147)), (_e2080.y + (select(_e2123, _e2109, (_e2109 > _e2123)) * _e2147)), (_e2080.z + (select(_e2127, _e2113, (_e2113 > _e2127)) * _e2147)), (_e2080.w + _e2147));
                            } else {
                                phi_2542_ = vec4<f32>();
                            }
                            let _e2161 = phi_2542_;
                            continue;
                            continuing {
                                phi_2538_ = _e2093;
                                phi_2541_ = _e2161;
                                phi_3651_ = _e1892;
                                break if !(_e2099);
                            }
                        }
                        let _e2164 = phi_3651_;
                        if _e2164 {
                            break;
                        }
                        phi_3664_ = _e2164;
                        let _e2926 = local_68;
                        phi_2802_ = _e2926;
                    } else {
                        phi_2666_ = type_7(_e1894, (_e1894 + _e1952));
                        phi_2669_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_2671_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1957 = phi_2666_;
                            let _e1959 = phi_2669_;
                            let _e1961 = phi_2671_;
                            local_42 = _e1959;
                            local_43 = _e1961;
                            local_44 = _e1959;
                            local_45 = _e1959;
                            local_46 = _e1959;
                            local_47 = _e1961;
                            local_67 = _e1961;
                            if (_e1957.member < _e1957.member_1) {
                                phi_2667_ = type_7((_e1957.member + 1u), _e1957.member_1);
                                phi_2694_ = type_7(1u, _e1957.member);
                            } else {
                                phi_2667_ = _e1957;
                                phi_2694_ = type_7(0u, type_7().member_1);
                            }
                            let _e1974 = phi_2667_;
                            let _e1976 = phi_2694_;
                            let _e1980 = (bitcast<i32>(_e1976.member) != 0i);
                            if _e1980 {
                                if (_e1976.member_1 < _e44) {
                                } else {
                                    phi_3642_ = true;
                                    break;
                                }
                                let _e1985 = facets.member[_e1976.member_1].member_2;
                                let _e1994 = -((((_e136 * _e1985[0]) + (_e138 * _e1985[1])) + (_e140 * _e1985[2])));
                                if (_e1994 > 0f) {
                                    let _e2017 = (2u * _e1976.member_1);
                                    if (_e2017 < _e46) {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e2021 = radiance.member[_e2017];
                                    phi_2778_ = _e1959;
                                    phi_2779_ = vec4<f32>((_e1961.x + (_e2021.x * _e1994)), (_e1961.y + (_e2021.y * _e1994)), (_e1961.z + (_e2021.z * _e1994)), (_e1961.w + _e1994));
                                } else {
                                    let _e1997 = ((2u * _e1976.member_1) + 1u);
                                    if (_e1997 < _e46) {
                                    } else {
                                        phi_3642_ = true;
                                        break;
                                    }
                                    let _e2001 = radiance.member[_e1997];
                                    phi_2778_ = vec4<f32>((_e1959.x - (_e2001.x * _e1994)), (_e1959.y - (_e2001.y * _e1994)), (_e1959.z - (_e2001.z * _e1994)), (_e1959.w - _e1994));
                                    phi_2779_ = _e1961;
                                }
                                let _e2038 = phi_2778_;
                                let _e2040 = phi_2779_;
                                phi_2670_ = _e2038;
                                phi_2672_ = _e2040;
                            } else {
                                phi_2670_ = vec4<f32>();
                                phi_2672_ = vec4<f32>();
                            }
                            let _e2042 = phi_2670_;
                            let _e2044 = phi_2672_;
                            continue;
                            continuing {
                                phi_2666_ = _e1974;
                                phi_2669_ = _e2042;
                                phi_2671_ = _e2044;
                                phi_3642_ = _e1892;
                                break if !(_e1980);
                            }
                        }
                        let _e2047 = phi_3642_;
                        if _e2047 {
                            break;
                        }
                        let _e2049 = local_42;
                        let _e2052 = local_43;
                        if (_e2049.w > _e2052.w) {
                            let _e2055 = (_e2049.w - _e2052.w);
                            let _e2056 = (_e2055 / _e2049.w);
                            let _e2058 = local_44;
                            let _e2062 = local_45;
                            let _e2066 = local_46;
                            let _e2071 = local_47;
                            phi_2801_ = (_e2071 + vec4<f32>((_e2058.x * _e2056), (_e2062.y * _e2056), (_e2066.z * _e2056), _e2055));
                        } else {
                            let _e2916 = local_67;
                            phi_2801_ = _e2916;
                        }
                        let _e2074 = phi_2801_;
                        phi_3664_ = _e2047;
                        phi_2802_ = _e2074;
                    }
                    let _e2166 = phi_3664_;
                    let _e2168 = phi_2802_;
                    if (_e2168.w > 1f) {
                        phi_2816_ = vec4<f32>((_e2168.x / _e2168.w), (_e2168.y / _e2168.w), (_e2168.z / _e2168.w), 1f);
                    } else {
                        phi_2816_ = _e2168;
                    }
                    let _e2179 = phi_2816_;
                    local[6u] = _e2179;
                    phi_3662_ = _e2166;
                    phi_2819_ = (_e1894 + _e1952);
                } else {
                    phi_3662_ = _e1892;
                    phi_2819_ = _e1894;
                }
                let _e2182 = phi_3662_;
                let _e2184 = phi_2819_;
                if (((_e84 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e2193 = facet_bits.member[_e85];
                    let _e2194 = ((_e76 + 7u) & 31u);
                    let _e2198 = (_e85 + 1u);
                    if (_e2198 < _e42) {
                    } else {
                        break;
                    }
                    let _e2202 = facet_bits.member[_e2198];
                    let _e2207 = (_e85 + 2u);
                    if (_e2207 < _e42) {
                    } else {
                        break;
                    }
                    let _e2211 = facet_bits.member[_e2207];
                    let _e2216 = (_e85 + 3u);
                    if (_e2216 < _e42) {
                    } else {
                        break;
                    }
                    let _e2220 = facet_bits.member[_e2216];
                    let _e2225 = (_e85 + 4u);
                    if (_e2225 < _e42) {
                    } else {
                        break;
                    }
                    let _e2229 = facet_bits.member[_e2225];
                    let _e2234 = (_e85 + 5u);
                    if (_e2234 < _e42) {
                    } else {
                        break;
                    }
                    let _e2238 = facet_bits.member[_e2234];
                    let _e2242 = (((((((_e2193 >> bitcast<u32>(_e2194)) & 1u) + ((_e2202 >> bitcast<u32>(_e2194)) & 1u)) + ((_e2211 >> bitcast<u32>(_e2194)) & 1u)) + ((_e2220 >> bitcast<u32>(_e2194)) & 1u)) + ((_e2229 >> bitcast<u32>(_e2194)) & 1u)) + ((_e2238 >> bitcast<u32>(_e2194)) & 1u));
                    if (_e64 == 1u) {
                        phi_2907_ = type_7(_e2184, (_e2184 + _e2242));
                        phi_2910_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e2368 = phi_2907_;
                            let _e2370 = phi_2910_;
                            local_70 = _e2370;
                            if (_e2368.member < _e2368.member_1) {
                                phi_2908_ = type_7((_e2368.member + 1u), _e2368.member_1);
                                phi_2933_ = type_7(1u, _e2368.member);
                            } else {
                                phi_2908_ = _e2368;
                                phi_2933_ = type_7(0u, type_7().member_1);
                            }
                            let _e2383 = phi_2908_;
                            let _e2385 = phi_2933_;
                            let _e2389 = (bitcast<i32>(_e2385.member) != 0i);
                            if _e2389 {
                                let _e2390 = (2u * _e2385.member_1);
                                if (_e2390 < _e46) {
                                } else {
                                    phi_3667_ = true;
                                    break;
                                }
                                let _e2395 = radiance.member[_e2390][0u];
                                let _e2399 = radiance.member[_e2390][1u];
                                let _e2403 = radiance.member[_e2390][2u];
                                let _e2404 = (_e2390 + 1u);
                                if (_e2404 < _e46) {
                                } else {
                                    phi_3667_ = true;
                                    break;
                                }
                                let _e2409 = radiance.member[_e2404][0u];
                                let _e2413 = radiance.member[_e2404][1u];
                                let _e2417 = radiance.member[_e2404][2u];
                                if (_e2385.member_1 < _e44) {
                                } else {
                                    phi_3667_ = true;
                                    break;
                                }
                                let _e2428 = facets.member[_e2385.member_1].member_2;
                                let _e2437 = sqrt((((_e2428[0] * _e2428[0]) + (_e2428[1] * _e2428[1])) + (_e2428[2] * _e2428[2])));
                                phi_2911_ = vec4<f32>((_e2370.x + (select(_e2409, _e2395, (_e2395 > _e2409)) * _e2437)), (_e2370.y + (select(_e2413, _e2399, (_e2399 > _e2413)) * _e2437)), (_e2370.z + (select(_e2417, _e2403, (_e2403 > _e2417)) * _e2437)), (_e2370.w + _e2437));
                            } else {
                                phi_2911_ = vec4<f32>();
                            }
                            let _e2451 = phi_2911_;
                            continue;
                            continuing {
                                phi_2907_ = _e2383;
                                phi_2910_ = _e2451;
                                phi_3667_ = _e2182;
                                break if !(_e2389);
                            }
                        }
                        let _e2454 = phi_3667_;
                        if _e2454 {
                            break;
                        }
                        let _e2957 = local_70;
                        phi_3171_ = _e2957;
                    } else {
                        phi_3035_ = type_7(_e2184, (_e2184 + _e2242));
                        phi_3038_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_3040_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e2247 = phi_3035_;
                            let _e2249 = phi_3038_;
                            let _e2251 = phi_3040_;
                            local_48 = _e2249;
                            local_49 = _e2251;
                            local_50 = _e2249;
                            local_51 = _e2249;
                            local_52 = _e2249;
                            local_53 = _e2251;
                            local_69 = _e2251;
                            if (_e2247.member < _e2247.member_1) {
                                phi_3036_ = type_7((_e2247.member + 1u), _e2247.member_1);
                                phi_3063_ = type_7(1u, _e2247.member);
                            } else {
                                phi_3036_ = _e2247;
                                phi_3063_ = type_7(0u, type_7().member_1);
                            }
                            let _e2264 = phi_3036_;
                            let _e2266 = phi_3063_;
                            let _e2270 = (bitcast<i32>(_e2266.member) != 0i);
                            if _e2270 {
                                if (_e2266.member_1 < _e44) {
                                } else {
                                    phi_3658_ = true;
                                    break;
                                }
                                let _e2275 = facets.member[_e2266.member_1].member_2;
                                let _e2284 = -((((_e136 * _e2275[0]) + (_e138 * _e2275[1])) + (_e140 * _e2275[2])));
                                if (_e2284 > 0f) {
                                    let _e2307 = (2u * _e2266.member_1);
                                    if (_e2307 < _e46) {
                                    } else {
                                        phi_3658_ = true;
                                        break;
                                    }
                                    let _e2311 = radiance.member[_e2307];
                                    phi_3147_ = _e2249;
                                    phi_3148_ = vec4<f32>((_e2251.x + (_e2311.x * _e2284)), (_e2251.y + (_e2311.y * _e2284)), (_e2251.z + (_e2311.z * _e2284)), (_e2251.w + _e2284));
                                } else {
                                    let _e2287 = ((2u * _e2266.member_1) + 1u);
                                    if (_e2287 < _e46) {
                                    } else {
                                        phi_3658_ = true;
                                        break;
                                    }
                                    let _e2291 = radiance.member[_e2287];
                                    phi_3147_ = vec4<f32>((_e2249.x - (_e2291.x * _e2284)), (_e2249.y - (_e2291.y * _e2284)), (_e2249.z - (_e2291.z * _e2284)), (_e2249.w - _e2284));
                                    phi_3148_ = _e2251;
                                }
                                let _e2328 = phi_3147_;
                                let _e2330 = phi_3148_;
                                phi_3039_ = _e2328;
                                phi_3041_ = _e2330;
                            } else {
                                phi_3039_ = vec4<f32>();
                                phi_3041_ = vec4<f32>();
                            }
                            let _e2332 = phi_3039_;
                            let _e2334 = phi_3041_;
                            continue;
                            continuing {
                                phi_3035_ = _e2264;
                                phi_3038_ = _e2332;
                                phi_3040_ = _e2334;
                                phi_3658_ = _e2182;
                                break if !(_e2270);
                            }
                        }
                        let _e2337 = phi_3658_;
                        if _e2337 {
                            break;
                        }
                        let _e2339 = local_48;
                        let _e2342 = local_49;
                        if (_e2339.w > _e2342.w) {
                            let _e2345 = (_e2339.w - _e2342.w);
                            let _e2346 = (_e2345 / _e2339.w);
                            let _e2348 = local_50;
                            let _e2352 = local_51;
                            let _e2356 = local_52;
                            let _e2361 = local_53;
                            phi_3170_ = (_e2361 + vec4<f32>((_e2348.x * _e2346), (_e2352.y * _e2346), (_e2356.z * _e2346), _e2345));
                        } else {
                            let _e2948 = local_69;
                            phi_3170_ = _e2948;
                        }
                        let _e2364 = phi_3170_;
                        phi_3171_ = _e2364;
                    }
                    let _e2456 = phi_3171_;
                    if (_e2456.w > 1f) {
                        phi_3185_ = vec4<f32>((_e2456.x / _e2456.w), (_e2456.y / _e2456.w), (_e2456.z / _e2456.w), 1f);
                    } else {
                        phi_3185_ = _e2456;
                    }
                    let _e2467 = phi_3185_;
                    local[7u] = _e2467;
                }
                if (_e64 == 1u) {
                    let _e2604 = local[0u];
                    let _e2605 = local[1u];
                    let _e2618 = local[2u];
                    let _e2619 = local[3u];
                    let _e2636 = local[4u];
                    let _e2637 = local[5u];
                    let _e2650 = local[6u];
                    let _e2651 = local[7u];
                    let _e2672 = ((((_e2604.x + _e2605.x) + (_e2618.x + _e2619.x)) + ((_e2636.x + _e2637.x) + (_e2650.x + _e2651.x))) * 0.25f);
                    let _e2673 = ((((_e2604.y + _e2605.y) + (_e2618.y + _e2619.y)) + ((_e2636.y + _e2637.y) + (_e2650.y + _e2651.y))) * 0.25f);
                    let _e2674 = ((((_e2604.z + _e2605.z) + (_e2618.z + _e2619.z)) + ((_e2636.z + _e2637.z) + (_e2650.z + _e2651.z))) * 0.25f);
                    let _e2675 = ((((_e2604.w + _e2605.w) + (_e2618.w + _e2619.w)) + ((_e2636.w + _e2637.w) + (_e2650.w + _e2651.w))) * 0.25f);
                    if (_e2675 > 1f) {
                        phi_3283_ = vec4<f32>((_e2672 / _e2675), (_e2673 / _e2675), (_e2674 / _e2675), (_e2675 / _e2675));
                    } else {
                        phi_3283_ = vec4<f32>(_e2672, _e2673, _e2674, _e2675);
                    }
                    let _e2684 = phi_3283_;
                    phi_3485_ = _e2684;
                } else {
                    let _e2471 = (1u << bitcast<u32>((_e131 & 31u)));
                    let _e2472 = select(1u, 2u, _e135);
                    let _e2473 = select(4u, 2u, _e139);
                    let _e2474 = select(0u, _e2471, _e133);
                    let _e2475 = select(_e2471, 0u, _e133);
                    if (_e2474 < 8u) {
                    } else {
                        break;
                    }
                    let _e2478 = local[_e2474];
                    if (_e2475 < 8u) {
                    } else {
                        break;
                    }
                    let _e2481 = local[_e2475];
                    let _e2483 = (1f - _e2478.w);
                    if (_e2481.w <= _e2483) {
                        phi_3338_ = (_e2478 + _e2481);
                    } else {
                        let _e2486 = (_e2483 / _e2481.w);
                        phi_3338_ = (_e2478 + vec4<f32>((_e2481.x * _e2486), (_e2481.y * _e2486), (_e2481.z * _e2486), _e2483));
                    }
                    let _e2497 = phi_3338_;
                    let _e2498 = (_e2472 + _e2474);
                    if (_e2498 < 8u) {
                    } else {
                        break;
                    }
                    let _e2501 = local[_e2498];
                    let _e2502 = (_e2472 + _e2475);
                    if (_e2502 < 8u) {
                    } else {
                        break;
                    }
                    let _e2505 = local[_e2502];
                    let _e2507 = (1f - _e2501.w);
                    if (_e2505.w <= _e2507) {
                        phi_3375_ = (_e2501 + _e2505);
                    } else {
                        let _e2510 = (_e2507 / _e2505.w);
                        phi_3375_ = (_e2501 + vec4<f32>((_e2505.x * _e2510), (_e2505.y * _e2510), (_e2505.z * _e2510), _e2507));
                    }
                    let _e2521 = phi_3375_;
                    let _e2534 = (_e2473 + _e2474);
                    if (_e2534 < 8u) {
                    } else {
                        break;
                    }
                    let _e2537 = local[_e2534];
                    let _e2538 = (_e2473 + _e2475);
                    if (_e2538 < 8u) {
                    } else {
                        break;
                    }
                    let _e2541 = local[_e2538];
                    let _e2543 = (1f - _e2537.w);
                    if (_e2541.w <= _e2543) {
                        phi_3424_ = (_e2537 + _e2541);
                    } else {
                        let _e2546 = (_e2543 / _e2541.w);
                        phi_3424_ = (_e2537 + vec4<f32>((_e2541.x * _e2546), (_e2541.y * _e2546), (_e2541.z * _e2546), _e2543));
                    }
                    let _e2557 = phi_3424_;
                    let _e2566 = (_e2472 + _e2473);
                    let _e2567 = (_e2566 + _e2474);
                    if (_e2567 < 8u) {
                    } else {
                        break;
                    }
                    let _e2570 = local[_e2567];
                    let _e2571 = (_e2566 + _e2475);
                    if (_e2571 < 8u) {
                    } else {
                        break;
                    }
                    let _e2574 = local[_e2571];
                    let _e2576 = (1f - _e2570.w);
                    if (_e2574.w <= _e2576) {
                        phi_3471_ = (_e2570 + _e2574);
                    } else {
                        let _e2579 = (_e2576 / _e2574.w);
                        phi_3471_ = (_e2570 + vec4<f32>((_e2574.x * _e2579), (_e2574.y * _e2579), (_e2574.z * _e2579), _e2576));
                    }
                    let _e2590 = phi_3471_;
                    phi_3485_ = vec4<f32>(((((_e2497.x + _e2521.x) + _e2557.x) + _e2590.x) * 0.25f), ((((_e2497.y + _e2521.y) + _e2557.y) + _e2590.y) * 0.25f), ((((_e2497.z + _e2521.z) + _e2557.z) + _e2590.z) * 0.25f), ((((_e2497.w + _e2521.w) + _e2557.w) + _e2590.w) * 0.25f));
                }
                let _e2686 = phi_3485_;
                let _e2689 = ((_e53 + _e60) + (_e60 - _e60));
                if (_e2689 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e2689] = _e2686;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_mip_base(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
