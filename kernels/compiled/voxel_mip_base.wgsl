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

struct type_23 {
    member: array<vec4<f32>>,
}

struct type_27 {
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
    member_16: vec4<u32>,
}

struct type_28 {
    member: type_27,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> cells: type_11;
@group(0) @binding(2) 
var<storage> facet_bits: type_11;
@group(0) @binding(3) 
var<storage> facets: type_20;
@group(0) @binding(4) 
var<storage> radiance: type_23;
@group(0) @binding(0) 
var<uniform> params: type_28;
@group(0) @binding(5) 
var<storage> children: type_11;
@group(0) @binding(6) 
var<storage, read_write> out: type_23;

fn function_() {
    var local: array<vec4<f32>, 8>;
    var phi_151_: type_8;
    var phi_154_: u32;
    var phi_152_: type_8;
    var phi_177_: type_8;
    var phi_155_: u32;
    var phi_3572_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_453_: type_8;
    var phi_456_: vec4<f32>;
    var phi_458_: vec4<f32>;
    var phi_454_: type_8;
    var phi_481_: type_8;
    var phi_565_: vec4<f32>;
    var phi_566_: vec4<f32>;
    var phi_457_: vec4<f32>;
    var phi_459_: vec4<f32>;
    var phi_3577_: bool;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var phi_588_: vec4<f32>;
    var local_9: u32;
    var local_10: u32;
    var phi_325_: type_8;
    var phi_328_: vec4<f32>;
    var phi_326_: type_8;
    var phi_351_: type_8;
    var phi_329_: vec4<f32>;
    var phi_3586_: bool;
    var phi_3600_: bool;
    var phi_589_: vec4<f32>;
    var local_11: u32;
    var phi_3597_: bool;
    var phi_608_: u32;
    var phi_824_: type_8;
    var phi_827_: vec4<f32>;
    var phi_829_: vec4<f32>;
    var phi_825_: type_8;
    var phi_852_: type_8;
    var phi_936_: vec4<f32>;
    var phi_937_: vec4<f32>;
    var phi_828_: vec4<f32>;
    var phi_830_: vec4<f32>;
    var phi_3593_: bool;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var phi_959_: vec4<f32>;
    var phi_696_: type_8;
    var phi_699_: vec4<f32>;
    var phi_697_: type_8;
    var phi_722_: type_8;
    var phi_700_: vec4<f32>;
    var phi_3603_: bool;
    var phi_3617_: bool;
    var phi_960_: vec4<f32>;
    var phi_3614_: bool;
    var phi_981_: u32;
    var phi_1197_: type_8;
    var phi_1200_: vec4<f32>;
    var phi_1202_: vec4<f32>;
    var phi_1198_: type_8;
    var phi_1225_: type_8;
    var phi_1309_: vec4<f32>;
    var phi_1310_: vec4<f32>;
    var phi_1201_: vec4<f32>;
    var phi_1203_: vec4<f32>;
    var phi_3610_: bool;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: vec4<f32>;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var phi_1332_: vec4<f32>;
    var phi_1069_: type_8;
    var phi_1072_: vec4<f32>;
    var phi_1070_: type_8;
    var phi_1095_: type_8;
    var phi_1073_: vec4<f32>;
    var phi_3620_: bool;
    var phi_3634_: bool;
    var phi_1333_: vec4<f32>;
    var phi_3631_: bool;
    var phi_1354_: u32;
    var phi_1570_: type_8;
    var phi_1573_: vec4<f32>;
    var phi_1575_: vec4<f32>;
    var phi_1571_: type_8;
    var phi_1598_: type_8;
    var phi_1682_: vec4<f32>;
    var phi_1683_: vec4<f32>;
    var phi_1574_: vec4<f32>;
    var phi_1576_: vec4<f32>;
    var phi_3627_: bool;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var local_28: vec4<f32>;
    var local_29: vec4<f32>;
    var phi_1705_: vec4<f32>;
    var phi_1442_: type_8;
    var phi_1445_: vec4<f32>;
    var phi_1443_: type_8;
    var phi_1468_: type_8;
    var phi_1446_: vec4<f32>;
    var phi_3637_: bool;
    var phi_3651_: bool;
    var phi_1706_: vec4<f32>;
    var phi_3648_: bool;
    var phi_1727_: u32;
    var phi_1943_: type_8;
    var phi_1946_: vec4<f32>;
    var phi_1948_: vec4<f32>;
    var phi_1944_: type_8;
    var phi_1971_: type_8;
    var phi_2055_: vec4<f32>;
    var phi_2056_: vec4<f32>;
    var phi_1947_: vec4<f32>;
    var phi_1949_: vec4<f32>;
    var phi_3644_: bool;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var phi_2078_: vec4<f32>;
    var phi_1815_: type_8;
    var phi_1818_: vec4<f32>;
    var phi_1816_: type_8;
    var phi_1841_: type_8;
    var phi_1819_: vec4<f32>;
    var phi_3654_: bool;
    var phi_3668_: bool;
    var phi_2079_: vec4<f32>;
    var phi_3665_: bool;
    var phi_2100_: u32;
    var phi_2316_: type_8;
    var phi_2319_: vec4<f32>;
    var phi_2321_: vec4<f32>;
    var phi_2317_: type_8;
    var phi_2344_: type_8;
    var phi_2428_: vec4<f32>;
    var phi_2429_: vec4<f32>;
    var phi_2320_: vec4<f32>;
    var phi_2322_: vec4<f32>;
    var phi_3661_: bool;
    var local_36: vec4<f32>;
    var local_37: vec4<f32>;
    var local_38: vec4<f32>;
    var local_39: vec4<f32>;
    var local_40: vec4<f32>;
    var local_41: vec4<f32>;
    var phi_2451_: vec4<f32>;
    var phi_2188_: type_8;
    var phi_2191_: vec4<f32>;
    var phi_2189_: type_8;
    var phi_2214_: type_8;
    var phi_2192_: vec4<f32>;
    var phi_3671_: bool;
    var phi_3685_: bool;
    var phi_2452_: vec4<f32>;
    var phi_3682_: bool;
    var phi_2473_: u32;
    var phi_2689_: type_8;
    var phi_2692_: vec4<f32>;
    var phi_2694_: vec4<f32>;
    var phi_2690_: type_8;
    var phi_2717_: type_8;
    var phi_2801_: vec4<f32>;
    var phi_2802_: vec4<f32>;
    var phi_2693_: vec4<f32>;
    var phi_2695_: vec4<f32>;
    var phi_3678_: bool;
    var local_42: vec4<f32>;
    var local_43: vec4<f32>;
    var local_44: vec4<f32>;
    var local_45: vec4<f32>;
    var local_46: vec4<f32>;
    var local_47: vec4<f32>;
    var phi_2824_: vec4<f32>;
    var phi_2561_: type_8;
    var phi_2564_: vec4<f32>;
    var phi_2562_: type_8;
    var phi_2587_: type_8;
    var phi_2565_: vec4<f32>;
    var phi_3688_: bool;
    var phi_3702_: bool;
    var phi_2825_: vec4<f32>;
    var phi_3699_: bool;
    var phi_2846_: u32;
    var phi_3062_: type_8;
    var phi_3065_: vec4<f32>;
    var phi_3067_: vec4<f32>;
    var phi_3063_: type_8;
    var phi_3090_: type_8;
    var phi_3174_: vec4<f32>;
    var phi_3175_: vec4<f32>;
    var phi_3066_: vec4<f32>;
    var phi_3068_: vec4<f32>;
    var phi_3695_: bool;
    var local_48: vec4<f32>;
    var local_49: vec4<f32>;
    var local_50: vec4<f32>;
    var local_51: vec4<f32>;
    var local_52: vec4<f32>;
    var local_53: vec4<f32>;
    var phi_3197_: vec4<f32>;
    var phi_2934_: type_8;
    var phi_2937_: vec4<f32>;
    var phi_2935_: type_8;
    var phi_2960_: type_8;
    var phi_2938_: vec4<f32>;
    var phi_3705_: bool;
    var phi_3198_: vec4<f32>;
    var phi_3369_: vec4<f32>;
    var phi_3406_: vec4<f32>;
    var phi_3455_: vec4<f32>;
    var phi_3502_: vec4<f32>;
    var phi_3314_: vec4<f32>;
    var phi_3516_: vec4<f32>;
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
                phi_151_ = type_8(0u, 6u);
                phi_154_ = _e90;
                loop {
                    let _e92 = phi_151_;
                    let _e94 = phi_154_;
                    local_1 = _e94;
                    local_2 = _e94;
                    local_9 = _e94;
                    local_10 = _e94;
                    local_11 = _e94;
                    local_56 = _e94;
                    if (_e92.member < _e92.member_1) {
                        phi_152_ = type_8((_e92.member + 1u), _e92.member_1);
                        phi_177_ = type_8(1u, _e92.member);
                    } else {
                        phi_152_ = _e92;
                        phi_177_ = type_8(0u, type_8().member_1);
                    }
                    let _e107 = phi_152_;
                    let _e109 = phi_177_;
                    let _e113 = (bitcast<i32>(_e109.member) != 0i);
                    if _e113 {
                        let _e114 = (_e85 + _e109.member_1);
                        if (_e114 < _e42) {
                        } else {
                            phi_3572_ = true;
                            break;
                        }
                        let _e118 = facet_bits.member[_e114];
                        phi_155_ = (_e94 + countOneBits((_e118 & ((1u << bitcast<u32>(_e82)) - 1u))));
                    } else {
                        phi_155_ = u32();
                    }
                    let _e126 = phi_155_;
                    continue;
                    continuing {
                        phi_151_ = _e107;
                        phi_154_ = _e126;
                        phi_3572_ = false;
                        break if !(_e113);
                    }
                }
                let _e129 = phi_3572_;
                if _e129 {
                    break;
                }
                let _e131 = ((_e68 & 1u) == 1u);
                let _e132 = select(1f, -1f, _e131);
                let _e134 = (_e68 >> bitcast<u32>(1i));
                let _e135 = (_e134 == 0u);
                let _e136 = select(0f, _e132, _e135);
                let _e138 = select(0f, _e132, (_e134 == 1u));
                let _e139 = (_e134 == 2u);
                let _e140 = select(0f, _e132, _e139);
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
                        phi_325_ = type_8(_e333, (_e330 + _e202));
                        phi_328_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e336 = phi_325_;
                            let _e338 = phi_328_;
                            local_55 = _e338;
                            if (_e336.member < _e336.member_1) {
                                phi_326_ = type_8((_e336.member + 1u), _e336.member_1);
                                phi_351_ = type_8(1u, _e336.member);
                            } else {
                                phi_326_ = _e336;
                                phi_351_ = type_8(0u, type_8().member_1);
                            }
                            let _e351 = phi_326_;
                            let _e353 = phi_351_;
                            let _e357 = (bitcast<i32>(_e353.member) != 0i);
                            if _e357 {
                                let _e358 = (2u * _e353.member_1);
                                if (_e358 < _e46) {
                                } else {
                                    phi_3586_ = true;
                                    break;
                                }
                                let _e363 = radiance.member[_e358][0u];
                                let _e367 = radiance.member[_e358][1u];
                                let _e371 = radiance.member[_e358][2u];
                                let _e372 = (_e358 + 1u);
                                if (_e372 < _e46) {
                                } else {
                                    phi_3586_ = true;
                                    break;
                                }
                                let _e377 = radiance.member[_e372][0u];
                                let _e381 = radiance.member[_e372][1u];
                                let _e385 = radiance.member[_e372][2u];
                                if (_e353.member_1 < _e44) {
                                } else {
                                    phi_3586_ = true;
                                    break;
                                }
                                let _e396 = facets.member[_e353.member_1].member_2;
                                let _e405 = sqrt((((_e396[0] * _e396[0]) + (_e396[1] * _e396[1])) + (_e396[2] * _e396[2])));
                                phi_329_ = vec4<f32>((_e338.x + (select(_e377, _e363, (_e363 > _e377)) * _e405)), (_e338.y + (select(_e381, _e367, (_e367 > _e381)) * _e405)), (_e338.z + (select(_e385, _e371, (_e371 > _e385)) * _e405)), (_e338.w + _e405));
                            } else {
                                phi_329_ = vec4<f32>();
                            }
                            let _e419 = phi_329_;
                            continue;
                            continuing {
                                phi_325_ = _e351;
                                phi_328_ = _e419;
                                phi_3586_ = _e129;
                                break if !(_e357);
                            }
                        }
                        let _e422 = phi_3586_;
                        if _e422 {
                            break;
                        }
                        phi_3600_ = _e422;
                        let _e2723 = local_55;
                        phi_589_ = _e2723;
                    } else {
                        let _e205 = local_1;
                        let _e208 = local_2;
                        phi_453_ = type_8(_e208, (_e205 + _e202));
                        phi_456_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_458_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e211 = phi_453_;
                            let _e213 = phi_456_;
                            let _e215 = phi_458_;
                            local_3 = _e213;
                            local_4 = _e215;
                            local_5 = _e213;
                            local_6 = _e213;
                            local_7 = _e213;
                            local_8 = _e215;
                            local_54 = _e215;
                            if (_e211.member < _e211.member_1) {
                                phi_454_ = type_8((_e211.member + 1u), _e211.member_1);
                                phi_481_ = type_8(1u, _e211.member);
                            } else {
                                phi_454_ = _e211;
                                phi_481_ = type_8(0u, type_8().member_1);
                            }
                            let _e228 = phi_454_;
                            let _e230 = phi_481_;
                            let _e234 = (bitcast<i32>(_e230.member) != 0i);
                            if _e234 {
                                if (_e230.member_1 < _e44) {
                                } else {
                                    phi_3577_ = true;
                                    break;
                                }
                                let _e239 = facets.member[_e230.member_1].member_2;
                                let _e248 = -((((_e136 * _e239[0]) + (_e138 * _e239[1])) + (_e140 * _e239[2])));
                                if (_e248 > 0f) {
                                    let _e271 = (2u * _e230.member_1);
                                    if (_e271 < _e46) {
                                    } else {
                                        phi_3577_ = true;
                                        break;
                                    }
                                    let _e275 = radiance.member[_e271];
                                    phi_565_ = _e213;
                                    phi_566_ = vec4<f32>((_e215.x + (_e275.x * _e248)), (_e215.y + (_e275.y * _e248)), (_e215.z + (_e275.z * _e248)), (_e215.w + _e248));
                                } else {
                                    let _e251 = ((2u * _e230.member_1) + 1u);
                                    if (_e251 < _e46) {
                                    } else {
                                        phi_3577_ = true;
                                        break;
                                    }
                                    let _e255 = radiance.member[_e251];
                                    phi_565_ = vec4<f32>((_e213.x - (_e255.x * _e248)), (_e213.y - (_e255.y * _e248)), (_e213.z - (_e255.z * _e248)), (_e213.w - _e248));
                                    phi_566_ = _e215;
                                }
                                let _e292 = phi_565_;
                                let _e294 = phi_566_;
                                phi_457_ = _e292;
                                phi_459_ = _e294;
                            } else {
                                phi_457_ = vec4<f32>();
                                phi_459_ = vec4<f32>();
                            }
                            let _e296 = phi_457_;
                            let _e298 = phi_459_;
                            continue;
                            continuing {
                                phi_453_ = _e228;
                                phi_456_ = _e296;
                                phi_458_ = _e298;
                                phi_3577_ = _e129;
                                break if !(_e234);
                            }
                        }
                        let _e301 = phi_3577_;
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
                            phi_588_ = (_e325 + vec4<f32>((_e312.x * _e310), (_e316.y * _e310), (_e320.z * _e310), _e309));
                        } else {
                            let _e2711 = local_54;
                            phi_588_ = _e2711;
                        }
                        let _e328 = phi_588_;
                        phi_3600_ = _e301;
                        phi_589_ = _e328;
                    }
                    let _e424 = phi_3600_;
                    let _e426 = phi_589_;
                    local[0u] = (_e426 * (1f / select(1f, _e426.w, (_e426.w > 1f))));
                    let _e434 = local[0u][3u];
                    local[0u][3u] = select(1f, _e434, (_e434 < 1f));
                    let _e438 = local_11;
                    phi_3597_ = _e424;
                    phi_608_ = (_e438 + _e202);
                } else {
                    phi_3597_ = _e129;
                    let _e2728 = local_56;
                    phi_608_ = _e2728;
                }
                let _e441 = phi_3597_;
                let _e443 = phi_608_;
                if (((_e84 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e452 = facet_bits.member[_e85];
                    let _e453 = ((_e76 + 1u) & 31u);
                    let _e457 = (_e85 + 1u);
                    if (_e457 < _e42) {
                    } else {
                        break;
                    }
                    let _e461 = facet_bits.member[_e457];
                    let _e466 = (_e85 + 2u);
                    if (_e466 < _e42) {
                    } else {
                        break;
                    }
                    let _e470 = facet_bits.member[_e466];
                    let _e475 = (_e85 + 3u);
                    if (_e475 < _e42) {
                    } else {
                        break;
                    }
                    let _e479 = facet_bits.member[_e475];
                    let _e484 = (_e85 + 4u);
                    if (_e484 < _e42) {
                    } else {
                        break;
                    }
                    let _e488 = facet_bits.member[_e484];
                    let _e493 = (_e85 + 5u);
                    if (_e493 < _e42) {
                    } else {
                        break;
                    }
                    let _e497 = facet_bits.member[_e493];
                    let _e501 = (((((((_e452 >> bitcast<u32>(_e453)) & 1u) + ((_e461 >> bitcast<u32>(_e453)) & 1u)) + ((_e470 >> bitcast<u32>(_e453)) & 1u)) + ((_e479 >> bitcast<u32>(_e453)) & 1u)) + ((_e488 >> bitcast<u32>(_e453)) & 1u)) + ((_e497 >> bitcast<u32>(_e453)) & 1u));
                    if (_e64 == 1u) {
                        phi_696_ = type_8(_e443, (_e443 + _e501));
                        phi_699_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e627 = phi_696_;
                            let _e629 = phi_699_;
                            local_58 = _e629;
                            if (_e627.member < _e627.member_1) {
                                phi_697_ = type_8((_e627.member + 1u), _e627.member_1);
                                phi_722_ = type_8(1u, _e627.member);
                            } else {
                                phi_697_ = _e627;
                                phi_722_ = type_8(0u, type_8().member_1);
                            }
                            let _e642 = phi_697_;
                            let _e644 = phi_722_;
                            let _e648 = (bitcast<i32>(_e644.member) != 0i);
                            if _e648 {
                                let _e649 = (2u * _e644.member_1);
                                if (_e649 < _e46) {
                                } else {
                                    phi_3603_ = true;
                                    break;
                                }
                                let _e654 = radiance.member[_e649][0u];
                                let _e658 = radiance.member[_e649][1u];
                                let _e662 = radiance.member[_e649][2u];
                                let _e663 = (_e649 + 1u);
                                if (_e663 < _e46) {
                                } else {
                                    phi_3603_ = true;
                                    break;
                                }
                                let _e668 = radiance.member[_e663][0u];
                                let _e672 = radiance.member[_e663][1u];
                                let _e676 = radiance.member[_e663][2u];
                                if (_e644.member_1 < _e44) {
                                } else {
                                    phi_3603_ = true;
                                    break;
                                }
                                let _e687 = facets.member[_e644.member_1].member_2;
                                let _e696 = sqrt((((_e687[0] * _e687[0]) + (_e687[1] * _e687[1])) + (_e687[2] * _e687[2])));
                                phi_700_ = vec4<f32>((_e629.x + (select(_e668, _e654, (_e654 > _e668)) * _e696)), (_e629.y + (select(_e672, _e658, (_e658 > _e672)) * _e696)), (_e629.z + (select(_e676, _e662, (_e662 > _e676)) * _e696)), (_e629.w + _e696));
                            } else {
                                phi_700_ = vec4<f32>();
                            }
                            let _e710 = phi_700_;
                            continue;
                            continuing {
                                phi_696_ = _e642;
                                phi_699_ = _e710;
                                phi_3603_ = _e441;
                                break if !(_e648);
                            }
                        }
                        let _e713 = phi_3603_;
                        if _e713 {
                            break;
                        }
                        phi_3617_ = _e713;
                        let _e2757 = local_58;
                        phi_960_ = _e2757;
                    } else {
                        phi_824_ = type_8(_e443, (_e443 + _e501));
                        phi_827_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_829_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e506 = phi_824_;
                            let _e508 = phi_827_;
                            let _e510 = phi_829_;
                            local_12 = _e508;
                            local_13 = _e510;
                            local_14 = _e508;
                            local_15 = _e508;
                            local_16 = _e508;
                            local_17 = _e510;
                            local_57 = _e510;
                            if (_e506.member < _e506.member_1) {
                                phi_825_ = type_8((_e506.member + 1u), _e506.member_1);
                                phi_852_ = type_8(1u, _e506.member);
                            } else {
                                phi_825_ = _e506;
                                phi_852_ = type_8(0u, type_8().member_1);
                            }
                            let _e523 = phi_825_;
                            let _e525 = phi_852_;
                            let _e529 = (bitcast<i32>(_e525.member) != 0i);
                            if _e529 {
                                if (_e525.member_1 < _e44) {
                                } else {
                                    phi_3593_ = true;
                                    break;
                                }
                                let _e534 = facets.member[_e525.member_1].member_2;
                                let _e543 = -((((_e136 * _e534[0]) + (_e138 * _e534[1])) + (_e140 * _e534[2])));
                                if (_e543 > 0f) {
                                    let _e566 = (2u * _e525.member_1);
                                    if (_e566 < _e46) {
                                    } else {
                                        phi_3593_ = true;
                                        break;
                                    }
                                    let _e570 = radiance.member[_e566];
                                    phi_936_ = _e508;
                                    phi_937_ = vec4<f32>((_e510.x + (_e570.x * _e543)), (_e510.y + (_e570.y * _e543)), (_e510.z + (_e570.z * _e543)), (_e510.w + _e543));
                                } else {
                                    let _e546 = ((2u * _e525.member_1) + 1u);
                                    if (_e546 < _e46) {
                                    } else {
                                        phi_3593_ = true;
                                        break;
                                    }
                                    let _e550 = radiance.member[_e546];
                                    phi_936_ = vec4<f32>((_e508.x - (_e550.x * _e543)), (_e508.y - (_e550.y * _e543)), (_e508.z - (_e550.z * _e543)), (_e508.w - _e543));
                                    phi_937_ = _e510;
                                }
                                let _e587 = phi_936_;
                                let _e589 = phi_937_;
                                phi_828_ = _e587;
                                phi_830_ = _e589;
                            } else {
                                phi_828_ = vec4<f32>();
                                phi_830_ = vec4<f32>();
                            }
                            let _e591 = phi_828_;
                            let _e593 = phi_830_;
                            continue;
                            continuing {
                                phi_824_ = _e523;
                                phi_827_ = _e591;
                                phi_829_ = _e593;
                                phi_3593_ = _e441;
                                break if !(_e529);
                            }
                        }
                        let _e596 = phi_3593_;
                        if _e596 {
                            break;
                        }
                        let _e598 = local_12;
                        let _e601 = local_13;
                        if (_e598.w > _e601.w) {
                            let _e604 = (_e598.w - _e601.w);
                            let _e605 = (_e604 / _e598.w);
                            let _e607 = local_14;
                            let _e611 = local_15;
                            let _e615 = local_16;
                            let _e620 = local_17;
                            phi_959_ = (_e620 + vec4<f32>((_e607.x * _e605), (_e611.y * _e605), (_e615.z * _e605), _e604));
                        } else {
                            let _e2747 = local_57;
                            phi_959_ = _e2747;
                        }
                        let _e623 = phi_959_;
                        phi_3617_ = _e596;
                        phi_960_ = _e623;
                    }
                    let _e715 = phi_3617_;
                    let _e717 = phi_960_;
                    local[1u] = (_e717 * (1f / select(1f, _e717.w, (_e717.w > 1f))));
                    let _e725 = local[1u][3u];
                    local[1u][3u] = select(1f, _e725, (_e725 < 1f));
                    phi_3614_ = _e715;
                    phi_981_ = (_e443 + _e501);
                } else {
                    phi_3614_ = _e441;
                    phi_981_ = _e443;
                }
                let _e730 = phi_3614_;
                let _e732 = phi_981_;
                if (((_e84 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e741 = facet_bits.member[_e85];
                    let _e742 = ((_e76 + 2u) & 31u);
                    let _e746 = (_e85 + 1u);
                    if (_e746 < _e42) {
                    } else {
                        break;
                    }
                    let _e750 = facet_bits.member[_e746];
                    let _e755 = (_e85 + 2u);
                    if (_e755 < _e42) {
                    } else {
                        break;
                    }
                    let _e759 = facet_bits.member[_e755];
                    let _e764 = (_e85 + 3u);
                    if (_e764 < _e42) {
                    } else {
                        break;
                    }
                    let _e768 = facet_bits.member[_e764];
                    let _e773 = (_e85 + 4u);
                    if (_e773 < _e42) {
                    } else {
                        break;
                    }
                    let _e777 = facet_bits.member[_e773];
                    let _e782 = (_e85 + 5u);
                    if (_e782 < _e42) {
                    } else {
                        break;
                    }
                    let _e786 = facet_bits.member[_e782];
                    let _e790 = (((((((_e741 >> bitcast<u32>(_e742)) & 1u) + ((_e750 >> bitcast<u32>(_e742)) & 1u)) + ((_e759 >> bitcast<u32>(_e742)) & 1u)) + ((_e768 >> bitcast<u32>(_e742)) & 1u)) + ((_e777 >> bitcast<u32>(_e742)) & 1u)) + ((_e786 >> bitcast<u32>(_e742)) & 1u));
                    if (_e64 == 1u) {
                        phi_1069_ = type_8(_e732, (_e732 + _e790));
                        phi_1072_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e916 = phi_1069_;
                            let _e918 = phi_1072_;
                            local_60 = _e918;
                            if (_e916.member < _e916.member_1) {
                                phi_1070_ = type_8((_e916.member + 1u), _e916.member_1);
                                phi_1095_ = type_8(1u, _e916.member);
                            } else {
                                phi_1070_ = _e916;
                                phi_1095_ = type_8(0u, type_8().member_1);
                            }
                            let _e931 = phi_1070_;
                            let _e933 = phi_1095_;
                            let _e937 = (bitcast<i32>(_e933.member) != 0i);
                            if _e937 {
                                let _e938 = (2u * _e933.member_1);
                                if (_e938 < _e46) {
                                } else {
                                    phi_3620_ = true;
                                    break;
                                }
                                let _e943 = radiance.member[_e938][0u];
                                let _e947 = radiance.member[_e938][1u];
                                let _e951 = radiance.member[_e938][2u];
                                let _e952 = (_e938 + 1u);
                                if (_e952 < _e46) {
                                } else {
                                    phi_3620_ = true;
                                    break;
                                }
                                let _e957 = radiance.member[_e952][0u];
                                let _e961 = radiance.member[_e952][1u];
                                let _e965 = radiance.member[_e952][2u];
                                if (_e933.member_1 < _e44) {
                                } else {
                                    phi_3620_ = true;
                                    break;
                                }
                                let _e976 = facets.member[_e933.member_1].member_2;
                                let _e985 = sqrt((((_e976[0] * _e976[0]) + (_e976[1] * _e976[1])) + (_e976[2] * _e976[2])));
                                phi_1073_ = vec4<f32>((_e918.x + (select(_e957, _e943, (_e943 > _e957)) * _e985)), (_e918.y + (select(_e961, _e947, (_e947 > _e961)) * _e985)), (_e918.z + (select(_e965, _e951, (_e951 > _e965)) * _e985)), (_e918.w + _e985));
                            } else {
                                phi_1073_ = vec4<f32>();
                            }
                            let _e999 = phi_1073_;
                            continue;
                            continuing {
                                phi_1069_ = _e931;
                                phi_1072_ = _e999;
                                phi_3620_ = _e730;
                                break if !(_e937);
                            }
                        }
                        let _e1002 = phi_3620_;
                        if _e1002 {
                            break;
                        }
                        phi_3634_ = _e1002;
                        let _e2788 = local_60;
                        phi_1333_ = _e2788;
                    } else {
                        phi_1197_ = type_8(_e732, (_e732 + _e790));
                        phi_1200_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1202_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e795 = phi_1197_;
                            let _e797 = phi_1200_;
                            let _e799 = phi_1202_;
                            local_18 = _e797;
                            local_19 = _e799;
                            local_20 = _e797;
                            local_21 = _e797;
                            local_22 = _e797;
                            local_23 = _e799;
                            local_59 = _e799;
                            if (_e795.member < _e795.member_1) {
                                phi_1198_ = type_8((_e795.member + 1u), _e795.member_1);
                                phi_1225_ = type_8(1u, _e795.member);
                            } else {
                                phi_1198_ = _e795;
                                phi_1225_ = type_8(0u, type_8().member_1);
                            }
                            let _e812 = phi_1198_;
                            let _e814 = phi_1225_;
                            let _e818 = (bitcast<i32>(_e814.member) != 0i);
                            if _e818 {
                                if (_e814.member_1 < _e44) {
                                } else {
                                    phi_3610_ = true;
                                    break;
                                }
                                let _e823 = facets.member[_e814.member_1].member_2;
                                let _e832 = -((((_e136 * _e823[0]) + (_e138 * _e823[1])) + (_e140 * _e823[2])));
                                if (_e832 > 0f) {
                                    let _e855 = (2u * _e814.member_1);
                                    if (_e855 < _e46) {
                                    } else {
                                        phi_3610_ = true;
                                        break;
                                    }
                                    let _e859 = radiance.member[_e855];
                                    phi_1309_ = _e797;
                                    phi_1310_ = vec4<f32>((_e799.x + (_e859.x * _e832)), (_e799.y + (_e859.y * _e832)), (_e799.z + (_e859.z * _e832)), (_e799.w + _e832));
                                } else {
                                    let _e835 = ((2u * _e814.member_1) + 1u);
                                    if (_e835 < _e46) {
                                    } else {
                                        phi_3610_ = true;
                                        break;
                                    }
                                    let _e839 = radiance.member[_e835];
                                    phi_1309_ = vec4<f32>((_e797.x - (_e839.x * _e832)), (_e797.y - (_e839.y * _e832)), (_e797.z - (_e839.z * _e832)), (_e797.w - _e832));
                                    phi_1310_ = _e799;
                                }
                                let _e876 = phi_1309_;
                                let _e878 = phi_1310_;
                                phi_1201_ = _e876;
                                phi_1203_ = _e878;
                            } else {
                                phi_1201_ = vec4<f32>();
                                phi_1203_ = vec4<f32>();
                            }
                            let _e880 = phi_1201_;
                            let _e882 = phi_1203_;
                            continue;
                            continuing {
                                phi_1197_ = _e812;
                                phi_1200_ = _e880;
                                phi_1202_ = _e882;
                                phi_3610_ = _e730;
                                break if !(_e818);
                            }
                        }
                        let _e885 = phi_3610_;
                        if _e885 {
                            break;
                        }
                        let _e887 = local_18;
                        let _e890 = local_19;
                        if (_e887.w > _e890.w) {
                            let _e893 = (_e887.w - _e890.w);
                            let _e894 = (_e893 / _e887.w);
                            let _e896 = local_20;
                            let _e900 = local_21;
                            let _e904 = local_22;
                            let _e909 = local_23;
                            phi_1332_ = (_e909 + vec4<f32>((_e896.x * _e894), (_e900.y * _e894), (_e904.z * _e894), _e893));
                        } else {
                            let _e2778 = local_59;
                            phi_1332_ = _e2778;
                        }
                        let _e912 = phi_1332_;
                        phi_3634_ = _e885;
                        phi_1333_ = _e912;
                    }
                    let _e1004 = phi_3634_;
                    let _e1006 = phi_1333_;
                    local[2u] = (_e1006 * (1f / select(1f, _e1006.w, (_e1006.w > 1f))));
                    let _e1014 = local[2u][3u];
                    local[2u][3u] = select(1f, _e1014, (_e1014 < 1f));
                    phi_3631_ = _e1004;
                    phi_1354_ = (_e732 + _e790);
                } else {
                    phi_3631_ = _e730;
                    phi_1354_ = _e732;
                }
                let _e1019 = phi_3631_;
                let _e1021 = phi_1354_;
                if (((_e84 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e1030 = facet_bits.member[_e85];
                    let _e1031 = ((_e76 + 3u) & 31u);
                    let _e1035 = (_e85 + 1u);
                    if (_e1035 < _e42) {
                    } else {
                        break;
                    }
                    let _e1039 = facet_bits.member[_e1035];
                    let _e1044 = (_e85 + 2u);
                    if (_e1044 < _e42) {
                    } else {
                        break;
                    }
                    let _e1048 = facet_bits.member[_e1044];
                    let _e1053 = (_e85 + 3u);
                    if (_e1053 < _e42) {
                    } else {
                        break;
                    }
                    let _e1057 = facet_bits.member[_e1053];
                    let _e1062 = (_e85 + 4u);
                    if (_e1062 < _e42) {
                    } else {
                        break;
                    }
                    let _e1066 = facet_bits.member[_e1062];
                    let _e1071 = (_e85 + 5u);
                    if (_e1071 < _e42) {
                    } else {
                        break;
                    }
                    let _e1075 = facet_bits.member[_e1071];
                    let _e1079 = (((((((_e1030 >> bitcast<u32>(_e1031)) & 1u) + ((_e1039 >> bitcast<u32>(_e1031)) & 1u)) + ((_e1048 >> bitcast<u32>(_e1031)) & 1u)) + ((_e1057 >> bitcast<u32>(_e1031)) & 1u)) + ((_e1066 >> bitcast<u32>(_e1031)) & 1u)) + ((_e1075 >> bitcast<u32>(_e1031)) & 1u));
                    if (_e64 == 1u) {
                        phi_1442_ = type_8(_e1021, (_e1021 + _e1079));
                        phi_1445_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1205 = phi_1442_;
                            let _e1207 = phi_1445_;
                            local_62 = _e1207;
                            if (_e1205.member < _e1205.member_1) {
                                phi_1443_ = type_8((_e1205.member + 1u), _e1205.member_1);
                                phi_1468_ = type_8(1u, _e1205.member);
                            } else {
                                phi_1443_ = _e1205;
                                phi_1468_ = type_8(0u, type_8().member_1);
                            }
                            let _e1220 = phi_1443_;
                            let _e1222 = phi_1468_;
                            let _e1226 = (bitcast<i32>(_e1222.member) != 0i);
                            if _e1226 {
                                let _e1227 = (2u * _e1222.member_1);
                                if (_e1227 < _e46) {
                                } else {
                                    phi_3637_ = true;
                                    break;
                                }
                                let _e1232 = radiance.member[_e1227][0u];
                                let _e1236 = radiance.member[_e1227][1u];
                                let _e1240 = radiance.member[_e1227][2u];
                                let _e1241 = (_e1227 + 1u);
                                if (_e1241 < _e46) {
                                } else {
                                    phi_3637_ = true;
                                    break;
                                }
                                let _e1246 = radiance.member[_e1241][0u];
                                let _e1250 = radiance.member[_e1241][1u];
                                let _e1254 = radiance.member[_e1241][2u];
                                if (_e1222.member_1 < _e44) {
                                } else {
                                    phi_3637_ = true;
                                    break;
                                }
                                let _e1265 = facets.member[_e1222.member_1].member_2;
                                let _e1274 = sqrt((((_e1265[0] * _e1265[0]) + (_e1265[1] * _e1265[1])) + (_e1265[2] * _e1265[2])));
                                phi_1446_ = vec4<f32>((_e1207.x + (select(_e1246, _e1232, (_e1232 > _e1246)) * _e1274)), (_e1207.y + (select(_e1250, _e1236, (_e1236 > _e1250)) * _e1274)), (_e1207.z + (select(_e1254, _e1240, (_e1240 > _e1254)) * _e1274)), (_e1207.w + _e1274));
                            } else {
                                phi_1446_ = vec4<f32>();
                            }
                            let _e1288 = phi_1446_;
                            continue;
                            continuing {
                                phi_1442_ = _e1220;
                                phi_1445_ = _e1288;
                                phi_3637_ = _e1019;
                                break if !(_e1226);
                            }
                        }
                        let _e1291 = phi_3637_;
                        if _e1291 {
                            break;
                        }
                        phi_3651_ = _e1291;
                        let _e2819 = local_62;
                        phi_1706_ = _e2819;
                    } else {
                        phi_1570_ = type_8(_e1021, (_e1021 + _e1079));
                        phi_1573_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1575_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1084 = phi_1570_;
                            let _e1086 = phi_1573_;
                            let _e1088 = phi_1575_;
                            local_24 = _e1086;
                            local_25 = _e1088;
                            local_26 = _e1086;
                            local_27 = _e1086;
                            local_28 = _e1086;
                            local_29 = _e1088;
                            local_61 = _e1088;
                            if (_e1084.member < _e1084.member_1) {
                                phi_1571_ = type_8((_e1084.member + 1u), _e1084.member_1);
                                phi_1598_ = type_8(1u, _e1084.member);
                            } else {
                                phi_1571_ = _e1084;
                                phi_1598_ = type_8(0u, type_8().member_1);
                            }
                            let _e1101 = phi_1571_;
                            let _e1103 = phi_1598_;
                            let _e1107 = (bitcast<i32>(_e1103.member) != 0i);
                            if _e1107 {
                                if (_e1103.member_1 < _e44) {
                                } else {
                                    phi_3627_ = true;
                                    break;
                                }
                                let _e1112 = facets.member[_e1103.member_1].member_2;
                                let _e1121 = -((((_e136 * _e1112[0]) + (_e138 * _e1112[1])) + (_e140 * _e1112[2])));
                                if (_e1121 > 0f) {
                                    let _e1144 = (2u * _e1103.member_1);
                                    if (_e1144 < _e46) {
                                    } else {
                                        phi_3627_ = true;
                                        break;
                                    }
                                    let _e1148 = radiance.member[_e1144];
                                    phi_1682_ = _e1086;
                                    phi_1683_ = vec4<f32>((_e1088.x + (_e1148.x * _e1121)), (_e1088.y + (_e1148.y * _e1121)), (_e1088.z + (_e1148.z * _e1121)), (_e1088.w + _e1121));
                                } else {
                                    let _e1124 = ((2u * _e1103.member_1) + 1u);
                                    if (_e1124 < _e46) {
                                    } else {
                                        phi_3627_ = true;
                                        break;
                                    }
                                    let _e1128 = radiance.member[_e1124];
                                    phi_1682_ = vec4<f32>((_e1086.x - (_e1128.x * _e1121)), (_e1086.y - (_e1128.y * _e1121)), (_e1086.z - (_e1128.z * _e1121)), (_e1086.w - _e1121));
                                    phi_1683_ = _e1088;
                                }
                                let _e1165 = phi_1682_;
                                let _e1167 = phi_1683_;
                                phi_1574_ = _e1165;
                                phi_1576_ = _e1167;
                            } else {
                                phi_1574_ = vec4<f32>();
                                phi_1576_ = vec4<f32>();
                            }
                            let _e1169 = phi_1574_;
                            let _e1171 = phi_1576_;
                            continue;
                            continuing {
                                phi_1570_ = _e1101;
                                phi_1573_ = _e1169;
                                phi_1575_ = _e1171;
                                phi_3627_ = _e1019;
                                break if !(_e1107);
                            }
                        }
                        let _e1174 = phi_3627_;
                        if _e1174 {
                            break;
                        }
                        let _e1176 = local_24;
                        let _e1179 = local_25;
                        if (_e1176.w > _e1179.w) {
                            let _e1182 = (_e1176.w - _e1179.w);
                            let _e1183 = (_e1182 / _e1176.w);
                            let _e1185 = local_26;
                            let _e1189 = local_27;
                            let _e1193 = local_28;
                            let _e1198 = local_29;
                            phi_1705_ = (_e1198 + vec4<f32>((_e1185.x * _e1183), (_e1189.y * _e1183), (_e1193.z * _e1183), _e1182));
                        } else {
                            let _e2809 = local_61;
                            phi_1705_ = _e2809;
                        }
                        let _e1201 = phi_1705_;
                        phi_3651_ = _e1174;
                        phi_1706_ = _e1201;
                    }
                    let _e1293 = phi_3651_;
                    let _e1295 = phi_1706_;
                    local[3u] = (_e1295 * (1f / select(1f, _e1295.w, (_e1295.w > 1f))));
                    let _e1303 = local[3u][3u];
                    local[3u][3u] = select(1f, _e1303, (_e1303 < 1f));
                    phi_3648_ = _e1293;
                    phi_1727_ = (_e1021 + _e1079);
                } else {
                    phi_3648_ = _e1019;
                    phi_1727_ = _e1021;
                }
                let _e1308 = phi_3648_;
                let _e1310 = phi_1727_;
                if (((_e84 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e1319 = facet_bits.member[_e85];
                    let _e1320 = ((_e76 + 4u) & 31u);
                    let _e1324 = (_e85 + 1u);
                    if (_e1324 < _e42) {
                    } else {
                        break;
                    }
                    let _e1328 = facet_bits.member[_e1324];
                    let _e1333 = (_e85 + 2u);
                    if (_e1333 < _e42) {
                    } else {
                        break;
                    }
                    let _e1337 = facet_bits.member[_e1333];
                    let _e1342 = (_e85 + 3u);
                    if (_e1342 < _e42) {
                    } else {
                        break;
                    }
                    let _e1346 = facet_bits.member[_e1342];
                    let _e1351 = (_e85 + 4u);
                    if (_e1351 < _e42) {
                    } else {
                        break;
                    }
                    let _e1355 = facet_bits.member[_e1351];
                    let _e1360 = (_e85 + 5u);
                    if (_e1360 < _e42) {
                    } else {
                        break;
                    }
                    let _e1364 = facet_bits.member[_e1360];
                    let _e1368 = (((((((_e1319 >> bitcast<u32>(_e1320)) & 1u) + ((_e1328 >> bitcast<u32>(_e1320)) & 1u)) + ((_e1337 >> bitcast<u32>(_e1320)) & 1u)) + ((_e1346 >> bitcast<u32>(_e1320)) & 1u)) + ((_e1355 >> bitcast<u32>(_e1320)) & 1u)) + ((_e1364 >> bitcast<u32>(_e1320)) & 1u));
                    if (_e64 == 1u) {
                        phi_1815_ = type_8(_e1310, (_e1310 + _e1368));
                        phi_1818_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1494 = phi_1815_;
                            let _e1496 = phi_1818_;
                            local_64 = _e1496;
                            if (_e1494.member < _e1494.member_1) {
                                phi_1816_ = type_8((_e1494.member + 1u), _e1494.member_1);
                                phi_1841_ = type_8(1u, _e1494.member);
                            } else {
                                phi_1816_ = _e1494;
                                phi_1841_ = type_8(0u, type_8().member_1);
                            }
                            let _e1509 = phi_1816_;
                            let _e1511 = phi_1841_;
                            let _e1515 = (bitcast<i32>(_e1511.member) != 0i);
                            if _e1515 {
                                let _e1516 = (2u * _e1511.member_1);
                                if (_e1516 < _e46) {
                                } else {
                                    phi_3654_ = true;
                                    break;
                                }
                                let _e1521 = radiance.member[_e1516][0u];
                                let _e1525 = radiance.member[_e1516][1u];
                                let _e1529 = radiance.member[_e1516][2u];
                                let _e1530 = (_e1516 + 1u);
                                if (_e1530 < _e46) {
                                } else {
                                    phi_3654_ = true;
                                    break;
                                }
                                let _e1535 = radiance.member[_e1530][0u];
                                let _e1539 = radiance.member[_e1530][1u];
                                let _e1543 = radiance.member[_e1530][2u];
                                if (_e1511.member_1 < _e44) {
                                } else {
                                    phi_3654_ = true;
                                    break;
                                }
                                let _e1554 = facets.member[_e1511.member_1].member_2;
                                let _e1563 = sqrt((((_e1554[0] * _e1554[0]) + (_e1554[1] * _e1554[1])) + (_e1554[2] * _e1554[2])));
                                phi_1819_ = vec4<f32>((_e1496.x + (select(_e1535, _e1521, (_e1521 > _e1535)) * _e1563)), (_e1496.y + (select(_e1539, _e1525, (_e1525 > _e1539)) * _e1563)), (_e1496.z + (select(_e1543, _e1529, (_e1529 > _e1543)) * _e1563)), (_e1496.w + _e1563));
                            } else {
                                phi_1819_ = vec4<f32>();
                            }
                            let _e1577 = phi_1819_;
                            continue;
                            continuing {
                                phi_1815_ = _e1509;
                                phi_1818_ = _e1577;
                                phi_3654_ = _e1308;
                                break if !(_e1515);
                            }
                        }
                        let _e1580 = phi_3654_;
                        if _e1580 {
                            break;
                        }
                        phi_3668_ = _e1580;
                        let _e2850 = local_64;
                        phi_2079_ = _e2850;
                    } else {
                        phi_1943_ = type_8(_e1310, (_e1310 + _e1368));
                        phi_1946_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1948_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1373 = phi_1943_;
                            let _e1375 = phi_1946_;
                            let _e1377 = phi_1948_;
                            local_30 = _e1375;
                            local_31 = _e1377;
                            local_32 = _e1375;
                            local_33 = _e1375;
                            local_34 = _e1375;
                            local_35 = _e1377;
                            local_63 = _e1377;
                            if (_e1373.member < _e1373.member_1) {
                                phi_1944_ = type_8((_e1373.member + 1u), _e1373.member_1);
                                phi_1971_ = type_8(1u, _e1373.member);
                            } else {
                                phi_1944_ = _e1373;
                                phi_1971_ = type_8(0u, type_8().member_1);
                            }
                            let _e1390 = phi_1944_;
                            let _e1392 = phi_1971_;
                            let _e1396 = (bitcast<i32>(_e1392.member) != 0i);
                            if _e1396 {
                                if (_e1392.member_1 < _e44) {
                                } else {
                                    phi_3644_ = true;
                                    break;
                                }
                                let _e1401 = facets.member[_e1392.member_1].member_2;
                                let _e1410 = -((((_e136 * _e1401[0]) + (_e138 * _e1401[1])) + (_e140 * _e1401[2])));
                                if (_e1410 > 0f) {
                                    let _e1433 = (2u * _e1392.member_1);
                                    if (_e1433 < _e46) {
                                    } else {
                                        phi_3644_ = true;
                                        break;
                                    }
                                    let _e1437 = radiance.member[_e1433];
                                    phi_2055_ = _e1375;
                                    phi_2056_ = vec4<f32>((_e1377.x + (_e1437.x * _e1410)), (_e1377.y + (_e1437.y * _e1410)), (_e1377.z + (_e1437.z * _e1410)), (_e1377.w + _e1410));
                                } else {
                                    let _e1413 = ((2u * _e1392.member_1) + 1u);
                                    if (_e1413 < _e46) {
                                    } else {
                                        phi_3644_ = true;
                                        break;
                                    }
                                    let _e1417 = radiance.member[_e1413];
                                    phi_2055_ = vec4<f32>((_e1375.x - (_e1417.x * _e1410)), (_e1375.y - (_e1417.y * _e1410)), (_e1375.z - (_e1417.z * _e1410)), (_e1375.w - _e1410));
                                    phi_2056_ = _e1377;
                                }
                                let _e1454 = phi_2055_;
                                let _e1456 = phi_2056_;
                                phi_1947_ = _e1454;
                                phi_1949_ = _e1456;
                            } else {
                                phi_1947_ = vec4<f32>();
                                phi_1949_ = vec4<f32>();
                            }
                            let _e1458 = phi_1947_;
                            let _e1460 = phi_1949_;
                            continue;
                            continuing {
                                phi_1943_ = _e1390;
                                phi_1946_ = _e1458;
                                phi_1948_ = _e1460;
                                phi_3644_ = _e1308;
                                break if !(_e1396);
                            }
                        }
                        let _e1463 = phi_3644_;
                        if _e1463 {
                            break;
                        }
                        let _e1465 = local_30;
                        let _e1468 = local_31;
                        if (_e1465.w > _e1468.w) {
                            let _e1471 = (_e1465.w - _e1468.w);
                            let _e1472 = (_e1471 / _e1465.w);
                            let _e1474 = local_32;
                            let _e1478 = local_33;
                            let _e1482 = local_34;
                            let _e1487 = local_35;
                            phi_2078_ = (_e1487 + vec4<f32>((_e1474.x * _e1472), (_e1478.y * _e1472), (_e1482.z * _e1472), _e1471));
                        } else {
                            let _e2840 = local_63;
                            phi_2078_ = _e2840;
                        }
                        let _e1490 = phi_2078_;
                        phi_3668_ = _e1463;
                        phi_2079_ = _e1490;
                    }
                    let _e1582 = phi_3668_;
                    let _e1584 = phi_2079_;
                    local[4u] = (_e1584 * (1f / select(1f, _e1584.w, (_e1584.w > 1f))));
                    let _e1592 = local[4u][3u];
                    local[4u][3u] = select(1f, _e1592, (_e1592 < 1f));
                    phi_3665_ = _e1582;
                    phi_2100_ = (_e1310 + _e1368);
                } else {
                    phi_3665_ = _e1308;
                    phi_2100_ = _e1310;
                }
                let _e1597 = phi_3665_;
                let _e1599 = phi_2100_;
                if (((_e84 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e1608 = facet_bits.member[_e85];
                    let _e1609 = ((_e76 + 5u) & 31u);
                    let _e1613 = (_e85 + 1u);
                    if (_e1613 < _e42) {
                    } else {
                        break;
                    }
                    let _e1617 = facet_bits.member[_e1613];
                    let _e1622 = (_e85 + 2u);
                    if (_e1622 < _e42) {
                    } else {
                        break;
                    }
                    let _e1626 = facet_bits.member[_e1622];
                    let _e1631 = (_e85 + 3u);
                    if (_e1631 < _e42) {
                    } else {
                        break;
                    }
                    let _e1635 = facet_bits.member[_e1631];
                    let _e1640 = (_e85 + 4u);
                    if (_e1640 < _e42) {
                    } else {
                        break;
                    }
                    let _e1644 = facet_bits.member[_e1640];
                    let _e1649 = (_e85 + 5u);
                    if (_e1649 < _e42) {
                    } else {
                        break;
                    }
                    let _e1653 = facet_bits.member[_e1649];
                    let _e1657 = (((((((_e1608 >> bitcast<u32>(_e1609)) & 1u) + ((_e1617 >> bitcast<u32>(_e1609)) & 1u)) + ((_e1626 >> bitcast<u32>(_e1609)) & 1u)) + ((_e1635 >> bitcast<u32>(_e1609)) & 1u)) + ((_e1644 >> bitcast<u32>(_e1609)) & 1u)) + ((_e1653 >> bitcast<u32>(_e1609)) & 1u));
                    if (_e64 == 1u) {
                        phi_2188_ = type_8(_e1599, (_e1599 + _e1657));
                        phi_2191_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1783 = phi_2188_;
                            let _e1785 = phi_2191_;
                            local_66 = _e1785;
                            if (_e1783.member < _e1783.member_1) {
                                phi_2189_ = type_8((_e1783.member + 1u), _e1783.member_1);
                                phi_2214_ = type_8(1u, _e1783.member);
                            } else {
                                phi_2189_ = _e1783;
                                phi_2214_ = type_8(0u, type_8().member_1);
                            }
                            let _e1798 = phi_2189_;
                            let _e1800 = phi_2214_;
                            let _e1804 = (bitcast<i32>(_e1800.member) != 0i);
                            if _e1804 {
                                let _e1805 = (2u * _e1800.member_1);
                                if (_e1805 < _e46) {
                                } else {
                                    phi_3671_ = true;
                                    break;
                                }
                                let _e1810 = radiance.member[_e1805][0u];
                                let _e1814 = radiance.member[_e1805][1u];
                                let _e1818 = radiance.member[_e1805][2u];
                                let _e1819 = (_e1805 + 1u);
                                if (_e1819 < _e46) {
                                } else {
                                    phi_3671_ = true;
                                    break;
                                }
                                let _e1824 = radiance.member[_e1819][0u];
                                let _e1828 = radiance.member[_e1819][1u];
                                let _e1832 = radiance.member[_e1819][2u];
                                if (_e1800.member_1 < _e44) {
                                } else {
                                    phi_3671_ = true;
                                    break;
                                }
                                let _e1843 = facets.member[_e1800.member_1].member_2;
                                let _e1852 = sqrt((((_e1843[0] * _e1843[0]) + (_e1843[1] * _e1843[1])) + (_e1843[2] * _e1843[2])));
                                phi_2192_ = vec4<f32>((_e1785.x + (select(_e1824, _e1810, (_e1810 > _e1824)) * _e1852)), (_e1785.y + (select(_e1828, _e1814, (_e1814 > _e1828)) * _e1852)), (_e1785.z + (select(_e1832, _e1818, (_e1818 > _e1832)) * _e1852)), (_e1785.w + _e1852));
                            } else {
                                phi_2192_ = vec4<f32>();
                            }
                            let _e1866 = phi_2192_;
                            continue;
                            continuing {
                                phi_2188_ = _e1798;
                                phi_2191_ = _e1866;
                                phi_3671_ = _e1597;
                                break if !(_e1804);
                            }
                        }
                        let _e1869 = phi_3671_;
                        if _e1869 {
                            break;
                        }
                        phi_3685_ = _e1869;
                        let _e2881 = local_66;
                        phi_2452_ = _e2881;
                    } else {
                        phi_2316_ = type_8(_e1599, (_e1599 + _e1657));
                        phi_2319_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_2321_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1662 = phi_2316_;
                            let _e1664 = phi_2319_;
                            let _e1666 = phi_2321_;
                            local_36 = _e1664;
                            local_37 = _e1666;
                            local_38 = _e1664;
                            local_39 = _e1664;
                            local_40 = _e1664;
                            local_41 = _e1666;
                            local_65 = _e1666;
                            if (_e1662.member < _e1662.member_1) {
                                phi_2317_ = type_8((_e1662.member + 1u), _e1662.member_1);
                                phi_2344_ = type_8(1u, _e1662.member);
                            } else {
                                phi_2317_ = _e1662;
                                phi_2344_ = type_8(0u, type_8().member_1);
                            }
                            let _e1679 = phi_2317_;
                            let _e1681 = phi_2344_;
                            let _e1685 = (bitcast<i32>(_e1681.member) != 0i);
                            if _e1685 {
                                if (_e1681.member_1 < _e44) {
                                } else {
                                    phi_3661_ = true;
                                    break;
                                }
                                let _e1690 = facets.member[_e1681.member_1].member_2;
                                let _e1699 = -((((_e136 * _e1690[0]) + (_e138 * _e1690[1])) + (_e140 * _e1690[2])));
                                if (_e1699 > 0f) {
                                    let _e1722 = (2u * _e1681.member_1);
                                    if (_e1722 < _e46) {
                                    } else {
                                        phi_3661_ = true;
                                        break;
                                    }
                                    let _e1726 = radiance.member[_e1722];
                                    phi_2428_ = _e1664;
                                    phi_2429_ = vec4<f32>((_e1666.x + (_e1726.x * _e1699)), (_e1666.y + (_e1726.y * _e1699)), (_e1666.z + (_e1726.z * _e1699)), (_e1666.w + _e1699));
                                } else {
                                    let _e1702 = ((2u * _e1681.member_1) + 1u);
                                    if (_e1702 < _e46) {
                                    } else {
                                        phi_3661_ = true;
                                        break;
                                    }
                                    let _e1706 = radiance.member[_e1702];
                                    phi_2428_ = vec4<f32>((_e1664.x - (_e1706.x * _e1699)), (_e1664.y - (_e1706.y * _e1699)), (_e1664.z - (_e1706.z * _e1699)), (_e1664.w - _e1699));
                                    phi_2429_ = _e1666;
                                }
                                let _e1743 = phi_2428_;
                                let _e1745 = phi_2429_;
                                phi_2320_ = _e1743;
                                phi_2322_ = _e1745;
                            } else {
                                phi_2320_ = vec4<f32>();
                                phi_2322_ = vec4<f32>();
                            }
                            let _e1747 = phi_2320_;
                            let _e1749 = phi_2322_;
                            continue;
                            continuing {
                                phi_2316_ = _e1679;
                                phi_2319_ = _e1747;
                                phi_2321_ = _e1749;
                                phi_3661_ = _e1597;
                                break if !(_e1685);
                            }
                        }
                        let _e1752 = phi_3661_;
                        if _e1752 {
                            break;
                        }
                        let _e1754 = local_36;
                        let _e1757 = local_37;
                        if (_e1754.w > _e1757.w) {
                            let _e1760 = (_e1754.w - _e1757.w);
                            let _e1761 = (_e1760 / _e1754.w);
                            let _e1763 = local_38;
                            let _e1767 = local_39;
                            let _e1771 = local_40;
                            let _e1776 = local_41;
                            phi_2451_ = (_e1776 + vec4<f32>((_e1763.x * _e1761), (_e1767.y * _e1761), (_e1771.z * _e1761), _e1760));
                        } else {
                            let _e2871 = local_65;
                            phi_2451_ = _e2871;
                        }
                        let _e1779 = phi_2451_;
                        phi_3685_ = _e1752;
                        phi_2452_ = _e1779;
                    }
                    let _e1871 = phi_3685_;
                    let _e1873 = phi_2452_;
                    local[5u] = (_e1873 * (1f / select(1f, _e1873.w, (_e1873.w > 1f))));
                    let _e1881 = local[5u][3u];
                    local[5u][3u] = select(1f, _e1881, (_e1881 < 1f));
                    phi_3682_ = _e1871;
                    phi_2473_ = (_e1599 + _e1657);
                } else {
                    phi_3682_ = _e1597;
                    phi_2473_ = _e1599;
                }
                let _e1886 = phi_3682_;
                let _e1888 = phi_2473_;
                if (((_e84 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e1897 = facet_bits.member[_e85];
                    let _e1898 = ((_e76 + 6u) & 31u);
                    let _e1902 = (_e85 + 1u);
                    if (_e1902 < _e42) {
                    } else {
                        break;
                    }
                    let _e1906 = facet_bits.member[_e1902];
                    let _e1911 = (_e85 + 2u);
                    if (_e1911 < _e42) {
                    } else {
                        break;
                    }
                    let _e1915 = facet_bits.member[_e1911];
                    let _e1920 = (_e85 + 3u);
                    if (_e1920 < _e42) {
                    } else {
                        break;
                    }
                    let _e1924 = facet_bits.member[_e1920];
                    let _e1929 = (_e85 + 4u);
                    if (_e1929 < _e42) {
                    } else {
                        break;
                    }
                    let _e1933 = facet_bits.member[_e1929];
                    let _e1938 = (_e85 + 5u);
                    if (_e1938 < _e42) {
                    } else {
                        break;
                    }
                    let _e1942 = facet_bits.member[_e1938];
                    let _e1946 = (((((((_e1897 >> bitcast<u32>(_e1898)) & 1u) + ((_e1906 >> bitcast<u32>(_e1898)) & 1u)) + ((_e1915 >> bitcast<u32>(_e1898)) & 1u)) + ((_e1924 >> bitcast<u32>(_e1898)) & 1u)) + ((_e1933 >> bitcast<u32>(_e1898)) & 1u)) + ((_e1942 >> bitcast<u32>(_e1898)) & 1u));
                    if (_e64 == 1u) {
                        phi_2561_ = type_8(_e1888, (_e1888 + _e1946));
                        phi_2564_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e2072 = phi_2561_;
                            let _e2074 = phi_2564_;
                            local_68 = _e2074;
                            if (_e2072.member < _e2072.member_1) {
                                phi_2562_ = type_8((_e2072.member + 1u), _e2072.member_1);
                                phi_2587_ = type_8(1u, _e2072.member);
                            } else {
                                phi_2562_ = _e2072;
                                phi_2587_ = type_8(0u, type_8().member_1);
                            }
                            let _e2087 = phi_2562_;
                            let _e2089 = phi_2587_;
                            let _e2093 = (bitcast<i32>(_e2089.member) != 0i);
                            if _e2093 {
                                let _e2094 = (2u * _e2089.member_1);
                                if (_e2094 < _e46) {
                                } else {
                                    phi_3688_ = true;
                                    break;
                                }
                                let _e2099 = radiance.member[_e2094][0u];
                                let _e2103 = radiance.member[_e2094][1u];
                                let _e2107 = radiance.member[_e2094][2u];
                                let _e2108 = (_e2094 + 1u);
                                if (_e2108 < _e46) {
                                } else {
                                    phi_3688_ = true;
                                    break;
                                }
                                let _e2113 = radiance.member[_e2108][0u];
                                let _e2117 = radiance.member[_e2108][1u];
                                let _e2121 = radiance.member[_e2108][2u];
                                if (_e2089.member_1 < _e44) {
                                } else {
                                    phi_3688_ = true;
                                    break;
                                }
                                let _e2132 = facets.member[_e2089.member_1].member_2;
                                let _e2141 = sqrt((((_e2132[0] * _e2132[0]) + (_e2132[1] * _e2132[1])) + (_e2132[2] * _e2132[2])));
                                phi_2565_ = vec4<f32>((_e2074.x + (select(_e2113, _e2099, (_e2099 > _e2113)) * _e2141)), (_e2074.y + (select(_e2117, _e2103, (_e2103 > _e2117)) * _e2141)), (_e2074.z + (select(_e2121, _e2107, (_e2107 > _e2121)) * _e2141)), (_e2074.w + _e2141));
                            } else {
                                phi_2565_ = vec4<f32>();
                            }
                            let _e2155 = phi_2565_;
                            continue;
                            continuing {
                                phi_2561_ = _e2087;
                                phi_2564_ = _e2155;
                                phi_3688_ = _e1886;
                                break if !(_e2093);
                            }
                        }
                        let _e2158 = phi_3688_;
                        if _e2158 {
                            break;
                        }
                        phi_3702_ = _e2158;
                        let _e2912 = local_68;
                        phi_2825_ = _e2912;
                    } else {
                        phi_2689_ = type_8(_e1888, (_e1888 + _e1946));
                        phi_2692_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_2694_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1951 = phi_2689_;
                            let _e1953 = phi_2692_;
                            let _e1955 = phi_2694_;
                            local_42 = _e1953;
                            local_43 = _e1955;
                            local_44 = _e1953;
                            local_45 = _e1953;
                            local_46 = _e1953;
                            local_47 = _e1955;
                            local_67 = _e1955;
                            if (_e1951.member < _e1951.member_1) {
                                phi_2690_ = type_8((_e1951.member + 1u), _e1951.member_1);
                                phi_2717_ = type_8(1u, _e1951.member);
                            } else {
                                phi_2690_ = _e1951;
                                phi_2717_ = type_8(0u, type_8().member_1);
                            }
                            let _e1968 = phi_2690_;
                            let _e1970 = phi_2717_;
                            let _e1974 = (bitcast<i32>(_e1970.member) != 0i);
                            if _e1974 {
                                if (_e1970.member_1 < _e44) {
                                } else {
                                    phi_3678_ = true;
                                    break;
                                }
                                let _e1979 = facets.member[_e1970.member_1].member_2;
                                let _e1988 = -((((_e136 * _e1979[0]) + (_e138 * _e1979[1])) + (_e140 * _e1979[2])));
                                if (_e1988 > 0f) {
                                    let _e2011 = (2u * _e1970.member_1);
                                    if (_e2011 < _e46) {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e2015 = radiance.member[_e2011];
                                    phi_2801_ = _e1953;
                                    phi_2802_ = vec4<f32>((_e1955.x + (_e2015.x * _e1988)), (_e1955.y + (_e2015.y * _e1988)), (_e1955.z + (_e2015.z * _e1988)), (_e1955.w + _e1988));
                                } else {
                                    let _e1991 = ((2u * _e1970.member_1) + 1u);
                                    if (_e1991 < _e46) {
                                    } else {
                                        phi_3678_ = true;
                                        break;
                                    }
                                    let _e1995 = radiance.member[_e1991];
                                    phi_2801_ = vec4<f32>((_e1953.x - (_e1995.x * _e1988)), (_e1953.y - (_e1995.y * _e1988)), (_e1953.z - (_e1995.z * _e1988)), (_e1953.w - _e1988));
                                    phi_2802_ = _e1955;
                                }
                                let _e2032 = phi_2801_;
                                let _e2034 = phi_2802_;
                                phi_2693_ = _e2032;
                                phi_2695_ = _e2034;
                            } else {
                                phi_2693_ = vec4<f32>();
                                phi_2695_ = vec4<f32>();
                            }
                            let _e2036 = phi_2693_;
                            let _e2038 = phi_2695_;
                            continue;
                            continuing {
                                phi_2689_ = _e1968;
                                phi_2692_ = _e2036;
                                phi_2694_ = _e2038;
                                phi_3678_ = _e1886;
                                break if !(_e1974);
                            }
                        }
                        let _e2041 = phi_3678_;
                        if _e2041 {
                            break;
                        }
                        let _e2043 = local_42;
                        let _e2046 = local_43;
                        if (_e2043.w > _e2046.w) {
                            let _e2049 = (_e2043.w - _e2046.w);
                            let _e2050 = (_e2049 / _e2043.w);
                            let _e2052 = local_44;
                            let _e2056 = local_45;
                            let _e2060 = local_46;
                            let _e2065 = local_47;
                            phi_2824_ = (_e2065 + vec4<f32>((_e2052.x * _e2050), (_e2056.y * _e2050), (_e2060.z * _e2050), _e2049));
                        } else {
                            let _e2902 = local_67;
                            phi_2824_ = _e2902;
                        }
                        let _e2068 = phi_2824_;
                        phi_3702_ = _e2041;
                        phi_2825_ = _e2068;
                    }
                    let _e2160 = phi_3702_;
                    let _e2162 = phi_2825_;
                    local[6u] = (_e2162 * (1f / select(1f, _e2162.w, (_e2162.w > 1f))));
                    let _e2170 = local[6u][3u];
                    local[6u][3u] = select(1f, _e2170, (_e2170 < 1f));
                    phi_3699_ = _e2160;
                    phi_2846_ = (_e1888 + _e1946);
                } else {
                    phi_3699_ = _e1886;
                    phi_2846_ = _e1888;
                }
                let _e2175 = phi_3699_;
                let _e2177 = phi_2846_;
                if (((_e84 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    if (_e85 < _e42) {
                    } else {
                        break;
                    }
                    let _e2186 = facet_bits.member[_e85];
                    let _e2187 = ((_e76 + 7u) & 31u);
                    let _e2191 = (_e85 + 1u);
                    if (_e2191 < _e42) {
                    } else {
                        break;
                    }
                    let _e2195 = facet_bits.member[_e2191];
                    let _e2200 = (_e85 + 2u);
                    if (_e2200 < _e42) {
                    } else {
                        break;
                    }
                    let _e2204 = facet_bits.member[_e2200];
                    let _e2209 = (_e85 + 3u);
                    if (_e2209 < _e42) {
                    } else {
                        break;
                    }
                    let _e2213 = facet_bits.member[_e2209];
                    let _e2218 = (_e85 + 4u);
                    if (_e2218 < _e42) {
                    } else {
                        break;
                    }
                    let _e2222 = facet_bits.member[_e2218];
                    let _e2227 = (_e85 + 5u);
                    if (_e2227 < _e42) {
                    } else {
                        break;
                    }
                    let _e2231 = facet_bits.member[_e2227];
                    let _e2235 = (((((((_e2186 >> bitcast<u32>(_e2187)) & 1u) + ((_e2195 >> bitcast<u32>(_e2187)) & 1u)) + ((_e2204 >> bitcast<u32>(_e2187)) & 1u)) + ((_e2213 >> bitcast<u32>(_e2187)) & 1u)) + ((_e2222 >> bitcast<u32>(_e2187)) & 1u)) + ((_e2231 >> bitcast<u32>(_e2187)) & 1u));
                    if (_e64 == 1u) {
                        phi_2934_ = type_8(_e2177, (_e2177 + _e2235));
                        phi_2937_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e2361 = phi_2934_;
                            let _e2363 = phi_2937_;
                            local_70 = _e2363;
                            if (_e2361.member < _e2361.member_1) {
                                phi_2935_ = type_8((_e2361.member + 1u), _e2361.member_1);
                                phi_2960_ = type_8(1u, _e2361.member);
                            } else {
                                phi_2935_ = _e2361;
                                phi_2960_ = type_8(0u, type_8().member_1);
                            }
                            let _e2376 = phi_2935_;
                            let _e2378 = phi_2960_;
                            let _e2382 = (bitcast<i32>(_e2378.member) != 0i);
                            if _e2382 {
                                let _e2383 = (2u * _e2378.member_1);
                                if (_e2383 < _e46) {
                                } else {
                                    phi_3705_ = true;
                                    break;
                                }
                                let _e2388 = radiance.member[_e2383][0u];
                                let _e2392 = radiance.member[_e2383][1u];
                                let _e2396 = radiance.member[_e2383][2u];
                                let _e2397 = (_e2383 + 1u);
                                if (_e2397 < _e46) {
                                } else {
                                    phi_3705_ = true;
                                    break;
                                }
                                let _e2402 = radiance.member[_e2397][0u];
                                let _e2406 = radiance.member[_e2397][1u];
                                let _e2410 = radiance.member[_e2397][2u];
                                if (_e2378.member_1 < _e44) {
                                } else {
                                    phi_3705_ = true;
                                    break;
                                }
                                let _e2421 = facets.member[_e2378.member_1].member_2;
                                let _e2430 = sqrt((((_e2421[0] * _e2421[0]) + (_e2421[1] * _e2421[1])) + (_e2421[2] * _e2421[2])));
                                phi_2938_ = vec4<f32>((_e2363.x + (select(_e2402, _e2388, (_e2388 > _e2402)) * _e2430)), (_e2363.y + (select(_e2406, _e2392, (_e2392 > _e2406)) * _e2430)), (_e2363.z + (select(_e2410, _e2396, (_e2396 > _e2410)) * _e2430)), (_e2363.w + _e2430));
                            } else {
                                phi_2938_ = vec4<f32>();
                            }
                            let _e2444 = phi_2938_;
                            continue;
                            continuing {
                                phi_2934_ = _e2376;
                                phi_2937_ = _e2444;
                                phi_3705_ = _e2175;
                                break if !(_e2382);
                            }
                        }
                        let _e2447 = phi_3705_;
                        if _e2447 {
                            break;
                        }
                        let _e2942 = local_70;
                        phi_3198_ = _e2942;
                    } else {
                        phi_3062_ = type_8(_e2177, (_e2177 + _e2235));
                        phi_3065_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_3067_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e2240 = phi_3062_;
                            let _e2242 = phi_3065_;
                            let _e2244 = phi_3067_;
                            local_48 = _e2242;
                            local_49 = _e2244;
                            local_50 = _e2242;
                            local_51 = _e2242;
                            local_52 = _e2242;
                            local_53 = _e2244;
                            local_69 = _e2244;
                            if (_e2240.member < _e2240.member_1) {
                                phi_3063_ = type_8((_e2240.member + 1u), _e2240.member_1);
                                phi_3090_ = type_8(1u, _e2240.member);
                            } else {
                                phi_3063_ = _e2240;
                                phi_3090_ = type_8(0u, type_8().member_1);
                            }
                            let _e2257 = phi_3063_;
                            let _e2259 = phi_3090_;
                            let _e2263 = (bitcast<i32>(_e2259.member) != 0i);
                            if _e2263 {
                                if (_e2259.member_1 < _e44) {
                                } else {
                                    phi_3695_ = true;
                                    break;
                                }
                                let _e2268 = facets.member[_e2259.member_1].member_2;
                                let _e2277 = -((((_e136 * _e2268[0]) + (_e138 * _e2268[1])) + (_e140 * _e2268[2])));
                                if (_e2277 > 0f) {
                                    let _e2300 = (2u * _e2259.member_1);
                                    if (_e2300 < _e46) {
                                    } else {
                                        phi_3695_ = true;
                                        break;
                                    }
                                    let _e2304 = radiance.member[_e2300];
                                    phi_3174_ = _e2242;
                                    phi_3175_ = vec4<f32>((_e2244.x + (_e2304.x * _e2277)), (_e2244.y + (_e2304.y * _e2277)), (_e2244.z + (_e2304.z * _e2277)), (_e2244.w + _e2277));
                                } else {
                                    let _e2280 = ((2u * _e2259.member_1) + 1u);
                                    if (_e2280 < _e46) {
                                    } else {
                                        phi_3695_ = true;
                                        break;
                                    }
                                    let _e2284 = radiance.member[_e2280];
                                    phi_3174_ = vec4<f32>((_e2242.x - (_e2284.x * _e2277)), (_e2242.y - (_e2284.y * _e2277)), (_e2242.z - (_e2284.z * _e2277)), (_e2242.w - _e2277));
                                    phi_3175_ = _e2244;
                                }
                                let _e2321 = phi_3174_;
                                let _e2323 = phi_3175_;
                                phi_3066_ = _e2321;
                                phi_3068_ = _e2323;
                            } else {
                                phi_3066_ = vec4<f32>();
                                phi_3068_ = vec4<f32>();
                            }
                            let _e2325 = phi_3066_;
                            let _e2327 = phi_3068_;
                            continue;
                            continuing {
                                phi_3062_ = _e2257;
                                phi_3065_ = _e2325;
                                phi_3067_ = _e2327;
                                phi_3695_ = _e2175;
                                break if !(_e2263);
                            }
                        }
                        let _e2330 = phi_3695_;
                        if _e2330 {
                            break;
                        }
                        let _e2332 = local_48;
                        let _e2335 = local_49;
                        if (_e2332.w > _e2335.w) {
                            let _e2338 = (_e2332.w - _e2335.w);
                            let _e2339 = (_e2338 / _e2332.w);
                            let _e2341 = local_50;
                            let _e2345 = local_51;
                            let _e2349 = local_52;
                            let _e2354 = local_53;
                            phi_3197_ = (_e2354 + vec4<f32>((_e2341.x * _e2339), (_e2345.y * _e2339), (_e2349.z * _e2339), _e2338));
                        } else {
                            let _e2933 = local_69;
                            phi_3197_ = _e2933;
                        }
                        let _e2357 = phi_3197_;
                        phi_3198_ = _e2357;
                    }
                    let _e2449 = phi_3198_;
                    local[7u] = (_e2449 * (1f / select(1f, _e2449.w, (_e2449.w > 1f))));
                    let _e2457 = local[7u][3u];
                    local[7u][3u] = select(1f, _e2457, (_e2457 < 1f));
                }
                if (_e64 == 1u) {
                    let _e2596 = local[0u];
                    let _e2597 = local[1u];
                    let _e2610 = local[2u];
                    let _e2611 = local[3u];
                    let _e2628 = local[4u];
                    let _e2629 = local[5u];
                    let _e2642 = local[6u];
                    let _e2643 = local[7u];
                    let _e2664 = ((((_e2596.x + _e2597.x) + (_e2610.x + _e2611.x)) + ((_e2628.x + _e2629.x) + (_e2642.x + _e2643.x))) * 0.25f);
                    let _e2665 = ((((_e2596.y + _e2597.y) + (_e2610.y + _e2611.y)) + ((_e2628.y + _e2629.y) + (_e2642.y + _e2643.y))) * 0.25f);
                    let _e2666 = ((((_e2596.z + _e2597.z) + (_e2610.z + _e2611.z)) + ((_e2628.z + _e2629.z) + (_e2642.z + _e2643.z))) * 0.25f);
                    let _e2667 = ((((_e2596.w + _e2597.w) + (_e2610.w + _e2611.w)) + ((_e2628.w + _e2629.w) + (_e2642.w + _e2643.w))) * 0.25f);
                    if (_e2667 > 1f) {
                        phi_3314_ = vec4<f32>((_e2664 / _e2667), (_e2665 / _e2667), (_e2666 / _e2667), (_e2667 / _e2667));
                    } else {
                        phi_3314_ = vec4<f32>(_e2664, _e2665, _e2666, _e2667);
                    }
                    let _e2676 = phi_3314_;
                    phi_3516_ = _e2676;
                } else {
                    let _e2463 = (1u << bitcast<u32>((_e134 & 31u)));
                    let _e2464 = select(1u, 2u, _e135);
                    let _e2465 = select(4u, 2u, _e139);
                    let _e2466 = select(0u, _e2463, _e131);
                    let _e2467 = select(_e2463, 0u, _e131);
                    if (_e2466 < 8u) {
                    } else {
                        break;
                    }
                    let _e2470 = local[_e2466];
                    if (_e2467 < 8u) {
                    } else {
                        break;
                    }
                    let _e2473 = local[_e2467];
                    let _e2475 = (1f - _e2470.w);
                    if (_e2473.w <= _e2475) {
                        phi_3369_ = (_e2470 + _e2473);
                    } else {
                        let _e2478 = (_e2475 / _e2473.w);
                        phi_3369_ = (_e2470 + vec4<f32>((_e2473.x * _e2478), (_e2473.y * _e2478), (_e2473.z * _e2478), _e2475));
                    }
                    let _e2489 = phi_3369_;
                    let _e2490 = (_e2464 + _e2466);
                    if (_e2490 < 8u) {
                    } else {
                        break;
                    }
                    let _e2493 = local[_e2490];
                    let _e2494 = (_e2464 + _e2467);
                    if (_e2494 < 8u) {
                    } else {
                        break;
                    }
                    let _e2497 = local[_e2494];
                    let _e2499 = (1f - _e2493.w);
                    if (_e2497.w <= _e2499) {
                        phi_3406_ = (_e2493 + _e2497);
                    } else {
                        let _e2502 = (_e2499 / _e2497.w);
                        phi_3406_ = (_e2493 + vec4<f32>((_e2497.x * _e2502), (_e2497.y * _e2502), (_e2497.z * _e2502), _e2499));
                    }
                    let _e2513 = phi_3406_;
                    let _e2526 = (_e2465 + _e2466);
                    if (_e2526 < 8u) {
                    } else {
                        break;
                    }
                    let _e2529 = local[_e2526];
                    let _e2530 = (_e2465 + _e2467);
                    if (_e2530 < 8u) {
                    } else {
                        break;
                    }
                    let _e2533 = local[_e2530];
                    let _e2535 = (1f - _e2529.w);
                    if (_e2533.w <= _e2535) {
                        phi_3455_ = (_e2529 + _e2533);
                    } else {
                        let _e2538 = (_e2535 / _e2533.w);
                        phi_3455_ = (_e2529 + vec4<f32>((_e2533.x * _e2538), (_e2533.y * _e2538), (_e2533.z * _e2538), _e2535));
                    }
                    let _e2549 = phi_3455_;
                    let _e2558 = (_e2464 + _e2465);
                    let _e2559 = (_e2558 + _e2466);
                    if (_e2559 < 8u) {
                    } else {
                        break;
                    }
                    let _e2562 = local[_e2559];
                    let _e2563 = (_e2558 + _e2467);
                    if (_e2563 < 8u) {
                    } else {
                        break;
                    }
                    let _e2566 = local[_e2563];
                    let _e2568 = (1f - _e2562.w);
                    if (_e2566.w <= _e2568) {
                        phi_3502_ = (_e2562 + _e2566);
                    } else {
                        let _e2571 = (_e2568 / _e2566.w);
                        phi_3502_ = (_e2562 + vec4<f32>((_e2566.x * _e2571), (_e2566.y * _e2571), (_e2566.z * _e2571), _e2568));
                    }
                    let _e2582 = phi_3502_;
                    phi_3516_ = vec4<f32>(((((_e2489.x + _e2513.x) + _e2549.x) + _e2582.x) * 0.25f), ((((_e2489.y + _e2513.y) + _e2549.y) + _e2582.y) * 0.25f), ((((_e2489.z + _e2513.z) + _e2549.z) + _e2582.z) * 0.25f), ((((_e2489.w + _e2513.w) + _e2549.w) + _e2582.w) * 0.25f));
                }
                let _e2678 = phi_3516_;
                let _e2681 = ((_e53 + _e60) + (_e60 - _e60));
                if (_e2681 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e2681] = _e2678;
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
