struct type_7 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_22 {
    member: array<vec4<f32>>,
}

struct type_25 {
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

struct type_26 {
    member: type_25,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> cells: type_7;
@group(0) @binding(2) 
var<storage> facet_bits: type_7;
@group(0) @binding(3) 
var<storage> facets: type_16;
@group(0) @binding(4) 
var<storage> radiance: type_22;
@group(0) @binding(0) 
var<uniform> params: type_26;
@group(0) @binding(5) 
var<storage> children: type_7;
@group(0) @binding(6) 
var<storage, read_write> out: type_22;

fn function_() {
    var phi_127_: type_10;
    var phi_130_: u32;
    var phi_128_: type_10;
    var phi_153_: type_10;
    var phi_131_: u32;
    var phi_254_: vec4<f32>;
    var phi_257_: vec4<f32>;
    var phi_259_: u32;
    var phi_370_: vec4<f32>;
    var phi_371_: vec4<f32>;
    var phi_255_: vec4<f32>;
    var phi_258_: vec4<f32>;
    var local: u32;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var phi_399_: vec4<f32>;
    var phi_413_: vec4<f32>;
    var phi_416_: array<vec4<f32>, 8>;
    var phi_417_: u32;
    var phi_470_: vec4<f32>;
    var phi_473_: vec4<f32>;
    var phi_475_: u32;
    var phi_586_: vec4<f32>;
    var phi_587_: vec4<f32>;
    var phi_471_: vec4<f32>;
    var phi_474_: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: vec4<f32>;
    var phi_615_: vec4<f32>;
    var phi_629_: vec4<f32>;
    var phi_632_: array<vec4<f32>, 8>;
    var phi_633_: u32;
    var phi_686_: vec4<f32>;
    var phi_689_: vec4<f32>;
    var phi_691_: u32;
    var phi_802_: vec4<f32>;
    var phi_803_: vec4<f32>;
    var phi_687_: vec4<f32>;
    var phi_690_: vec4<f32>;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var phi_831_: vec4<f32>;
    var phi_845_: vec4<f32>;
    var phi_848_: array<vec4<f32>, 8>;
    var phi_849_: u32;
    var phi_902_: vec4<f32>;
    var phi_905_: vec4<f32>;
    var phi_907_: u32;
    var phi_1018_: vec4<f32>;
    var phi_1019_: vec4<f32>;
    var phi_903_: vec4<f32>;
    var phi_906_: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: vec4<f32>;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var local_24: vec4<f32>;
    var phi_1047_: vec4<f32>;
    var phi_1061_: vec4<f32>;
    var phi_1064_: array<vec4<f32>, 8>;
    var phi_1065_: u32;
    var phi_1118_: vec4<f32>;
    var phi_1121_: vec4<f32>;
    var phi_1123_: u32;
    var phi_1234_: vec4<f32>;
    var phi_1235_: vec4<f32>;
    var phi_1119_: vec4<f32>;
    var phi_1122_: vec4<f32>;
    var local_25: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var local_28: vec4<f32>;
    var local_29: vec4<f32>;
    var local_30: vec4<f32>;
    var phi_1263_: vec4<f32>;
    var phi_1277_: vec4<f32>;
    var phi_1280_: array<vec4<f32>, 8>;
    var phi_1281_: u32;
    var phi_1334_: vec4<f32>;
    var phi_1337_: vec4<f32>;
    var phi_1339_: u32;
    var phi_1450_: vec4<f32>;
    var phi_1451_: vec4<f32>;
    var phi_1335_: vec4<f32>;
    var phi_1338_: vec4<f32>;
    var local_31: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var local_36: vec4<f32>;
    var phi_1479_: vec4<f32>;
    var phi_1493_: vec4<f32>;
    var phi_1496_: array<vec4<f32>, 8>;
    var phi_1497_: u32;
    var phi_1550_: vec4<f32>;
    var phi_1553_: vec4<f32>;
    var phi_1555_: u32;
    var phi_1666_: vec4<f32>;
    var phi_1667_: vec4<f32>;
    var phi_1551_: vec4<f32>;
    var phi_1554_: vec4<f32>;
    var local_37: vec4<f32>;
    var local_38: vec4<f32>;
    var local_39: vec4<f32>;
    var local_40: vec4<f32>;
    var local_41: vec4<f32>;
    var local_42: vec4<f32>;
    var phi_1695_: vec4<f32>;
    var phi_1709_: vec4<f32>;
    var phi_1712_: array<vec4<f32>, 8>;
    var phi_1713_: u32;
    var phi_1766_: vec4<f32>;
    var phi_1769_: vec4<f32>;
    var phi_1771_: u32;
    var phi_1882_: vec4<f32>;
    var phi_1883_: vec4<f32>;
    var phi_1767_: vec4<f32>;
    var phi_1770_: vec4<f32>;
    var local_43: vec4<f32>;
    var local_44: vec4<f32>;
    var local_45: vec4<f32>;
    var local_46: vec4<f32>;
    var local_47: vec4<f32>;
    var local_48: vec4<f32>;
    var phi_1911_: vec4<f32>;
    var phi_1925_: vec4<f32>;
    var phi_1927_: array<vec4<f32>, 8>;
    var phi_2033_: vec4<f32>;
    var phi_2085_: vec4<f32>;
    var phi_2111_: vec4<f32>;
    var phi_2163_: vec4<f32>;
    var phi_2188_: vec4<f32>;
    var phi_2253_: vec4<f32>;
    var phi_2274_: vec4<f32>;
    var phi_2327_: vec4<f32>;
    var phi_2016_: vec4<f32>;
    var phi_2341_: vec4<f32>;
    var local_49: u32;
    var local_50: vec4<f32>;
    var local_51: u32;
    var local_52: u32;
    var local_53: vec4<f32>;
    var local_54: u32;
    var local_55: vec4<f32>;
    var local_56: u32;
    var local_57: vec4<f32>;
    var local_58: u32;
    var local_59: vec4<f32>;
    var local_60: u32;
    var local_61: vec4<f32>;
    var local_62: u32;
    var local_63: vec4<f32>;
    var local_64: u32;
    var local_65: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e38 = gid_1;
            let _e43 = params.member.member_12;
            let _e46 = params.member.member_13;
            let _e50 = (_e38.x + (_e38.y * 2097152u));
            if (_e50 < _e46) {
                let _e54 = params.member.member_6;
                if (_e54 == 0u) {
                    break;
                }
                let _e56 = (_e50 / _e54);
                let _e58 = (_e50 - (_e56 * _e54));
                let _e61 = children.member[_e56];
                let _e63 = (_e61 >> bitcast<u32>(2i));
                let _e65 = (8u * (_e61 & 3u));
                let _e66 = (2u * _e63);
                let _e69 = cells.member[_e66];
                let _e70 = (_e65 & 31u);
                let _e72 = (_e69 >> bitcast<u32>(_e70));
                let _e73 = (_e63 * 6u);
                let _e77 = cells.member[(_e66 + 1u)];
                phi_127_ = type_10(0u, 6u);
                phi_130_ = _e77;
                loop {
                    let _e79 = phi_127_;
                    let _e81 = phi_130_;
                    local_49 = _e81;
                    local = _e81;
                    local_52 = _e81;
                    if (_e79.member < _e79.member_1) {
                        phi_128_ = type_10((_e79.member + 1u), _e79.member_1);
                        phi_153_ = type_10(1u, _e79.member);
                    } else {
                        phi_128_ = _e79;
                        phi_153_ = type_10(0u, type_10().member_1);
                    }
                    let _e94 = phi_128_;
                    let _e96 = phi_153_;
                    let _e100 = (bitcast<i32>(_e96.member) != 0i);
                    if _e100 {
                        let _e104 = facet_bits.member[(_e73 + _e96.member_1)];
                        phi_131_ = (_e81 + countOneBits((_e104 & ((1u << bitcast<u32>(_e70)) - 1u))));
                    } else {
                        phi_131_ = u32();
                    }
                    let _e112 = phi_131_;
                    continue;
                    continuing {
                        phi_127_ = _e94;
                        phi_130_ = _e112;
                        break if !(_e100);
                    }
                }
                let _e115 = (_e58 >> bitcast<u32>(1i));
                let _e117 = ((_e58 & 1u) == 1u);
                let _e118 = select(1f, -1f, _e117);
                let _e119 = (_e115 == 0u);
                let _e120 = select(0f, _e118, _e119);
                let _e121 = (_e115 == 1u);
                let _e122 = select(0f, _e118, _e121);
                let _e124 = select(0f, _e118, (_e115 == 2u));
                if ((_e72 & 1u) == 1u) {
                    let _e129 = facet_bits.member[_e73];
                    let _e136 = facet_bits.member[(_e73 + 1u)];
                    let _e144 = facet_bits.member[(_e73 + 2u)];
                    let _e152 = facet_bits.member[(_e73 + 3u)];
                    let _e160 = facet_bits.member[(_e73 + 4u)];
                    let _e168 = facet_bits.member[(_e73 + 5u)];
                    phi_254_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_257_ = vec4<f32>(0f, 0f, 0f, 0f);
                    let _e2056 = local_49;
                    phi_259_ = _e2056;
                    loop {
                        let _e175 = phi_254_;
                        let _e177 = phi_257_;
                        let _e179 = phi_259_;
                        let _e183 = facets.member[_e179].member_2;
                        let _e187 = (2u * _e179);
                        let _e190 = radiance.member[_e187];
                        let _e194 = radiance.member[(_e187 + 1u)];
                        let _e200 = -((((_e120 * _e183[0]) + (_e122 * _e183[1])) + (_e124 * _e183[2])));
                        if (_e54 == 1u) {
                            let _e253 = sqrt((((_e183[0] * _e183[0]) + (_e183[1] * _e183[1])) + (_e183[2] * _e183[2])));
                            phi_255_ = _e175;
                            phi_258_ = vec4<f32>((_e177.x + (select(_e194.x, _e190.x, (_e190.x > _e194.x)) * _e253)), (_e177.y + (select(_e194.y, _e190.y, (_e190.y > _e194.y)) * _e253)), (_e177.z + (select(_e194.z, _e190.z, (_e190.z > _e194.z)) * _e253)), (_e177.w + _e253));
                        } else {
                            if (_e200 > 0f) {
                                phi_370_ = _e175;
                                phi_371_ = vec4<f32>((_e177.x + (_e190.x * _e200)), (_e177.y + (_e190.y * _e200)), (_e177.z + (_e190.z * _e200)), (_e177.w + _e200));
                            } else {
                                phi_370_ = vec4<f32>((_e175.x - (_e194.x * _e200)), (_e175.y - (_e194.y * _e200)), (_e175.z - (_e194.z * _e200)), (_e175.w - _e200));
                                phi_371_ = _e177;
                            }
                            let _e233 = phi_370_;
                            let _e235 = phi_371_;
                            phi_255_ = _e233;
                            phi_258_ = _e235;
                        }
                        let _e267 = phi_255_;
                        let _e269 = phi_258_;
                        let _e270 = (_e179 + 1u);
                        let _e272 = local;
                        let _e273 = (_e272 + (((((((_e129 >> bitcast<u32>(_e70)) & 1u) + ((_e136 >> bitcast<u32>(_e70)) & 1u)) + ((_e144 >> bitcast<u32>(_e70)) & 1u)) + ((_e152 >> bitcast<u32>(_e70)) & 1u)) + ((_e160 >> bitcast<u32>(_e70)) & 1u)) + ((_e168 >> bitcast<u32>(_e70)) & 1u)));
                        local_1 = _e267;
                        local_2 = _e269;
                        local_3 = _e267;
                        local_4 = _e267;
                        local_5 = _e267;
                        local_6 = _e269;
                        local_50 = _e269;
                        local_51 = _e273;
                        continue;
                        continuing {
                            phi_254_ = _e267;
                            phi_257_ = _e269;
                            phi_259_ = _e270;
                            break if !(select(true, false, (_e270 >= _e273)));
                        }
                    }
                    let _e278 = local_1;
                    let _e281 = local_2;
                    if (_e278.w > _e281.w) {
                        let _e284 = (_e278.w - _e281.w);
                        let _e285 = (_e284 / _e278.w);
                        let _e287 = local_3;
                        let _e291 = local_4;
                        let _e295 = local_5;
                        let _e300 = local_6;
                        phi_399_ = (_e300 + vec4<f32>((_e287.x * _e285), (_e291.y * _e285), (_e295.z * _e285), _e284));
                    } else {
                        let _e2070 = local_50;
                        phi_399_ = _e2070;
                    }
                    let _e303 = phi_399_;
                    if (_e303.w > 1f) {
                        phi_413_ = vec4<f32>((_e303.x / _e303.w), (_e303.y / _e303.w), (_e303.z / _e303.w), 1f);
                    } else {
                        phi_413_ = _e303;
                    }
                    let _e314 = phi_413_;
                    phi_416_ = array<vec4<f32>, 8>(_e314, vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                    let _e2075 = local_51;
                    phi_417_ = _e2075;
                } else {
                    phi_416_ = array<vec4<f32>, 8>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                    let _e2077 = local_52;
                    phi_417_ = _e2077;
                }
                let _e317 = phi_416_;
                let _e319 = phi_417_;
                if (((_e72 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    let _e327 = facet_bits.member[_e73];
                    let _e328 = ((_e65 + 1u) & 31u);
                    let _e335 = facet_bits.member[(_e73 + 1u)];
                    let _e343 = facet_bits.member[(_e73 + 2u)];
                    let _e351 = facet_bits.member[(_e73 + 3u)];
                    let _e359 = facet_bits.member[(_e73 + 4u)];
                    let _e367 = facet_bits.member[(_e73 + 5u)];
                    phi_470_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_473_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_475_ = _e319;
                    loop {
                        let _e374 = phi_470_;
                        let _e376 = phi_473_;
                        let _e378 = phi_475_;
                        let _e382 = facets.member[_e378].member_2;
                        let _e386 = (2u * _e378);
                        let _e389 = radiance.member[_e386];
                        let _e393 = radiance.member[(_e386 + 1u)];
                        let _e399 = -((((_e120 * _e382[0]) + (_e122 * _e382[1])) + (_e124 * _e382[2])));
                        if (_e54 == 1u) {
                            let _e452 = sqrt((((_e382[0] * _e382[0]) + (_e382[1] * _e382[1])) + (_e382[2] * _e382[2])));
                            phi_471_ = _e374;
                            phi_474_ = vec4<f32>((_e376.x + (select(_e393.x, _e389.x, (_e389.x > _e393.x)) * _e452)), (_e376.y + (select(_e393.y, _e389.y, (_e389.y > _e393.y)) * _e452)), (_e376.z + (select(_e393.z, _e389.z, (_e389.z > _e393.z)) * _e452)), (_e376.w + _e452));
                        } else {
                            if (_e399 > 0f) {
                                phi_586_ = _e374;
                                phi_587_ = vec4<f32>((_e376.x + (_e389.x * _e399)), (_e376.y + (_e389.y * _e399)), (_e376.z + (_e389.z * _e399)), (_e376.w + _e399));
                            } else {
                                phi_586_ = vec4<f32>((_e374.x - (_e393.x * _e399)), (_e374.y - (_e393.y * _e399)), (_e374.z - (_e393.z * _e399)), (_e374.w - _e399));
                                phi_587_ = _e376;
                            }
                            let _e432 = phi_586_;
                            let _e434 = phi_587_;
                            phi_471_ = _e432;
                            phi_474_ = _e434;
                        }
                        let _e466 = phi_471_;
                        let _e468 = phi_474_;
                        let _e469 = (_e378 + 1u);
                        let _e470 = (_e319 + (((((((_e327 >> bitcast<u32>(_e328)) & 1u) + ((_e335 >> bitcast<u32>(_e328)) & 1u)) + ((_e343 >> bitcast<u32>(_e328)) & 1u)) + ((_e351 >> bitcast<u32>(_e328)) & 1u)) + ((_e359 >> bitcast<u32>(_e328)) & 1u)) + ((_e367 >> bitcast<u32>(_e328)) & 1u)));
                        local_7 = _e466;
                        local_8 = _e468;
                        local_9 = _e466;
                        local_10 = _e466;
                        local_11 = _e466;
                        local_12 = _e468;
                        local_53 = _e468;
                        local_54 = _e470;
                        continue;
                        continuing {
                            phi_470_ = _e466;
                            phi_473_ = _e468;
                            phi_475_ = _e469;
                            break if !(select(true, false, (_e469 >= _e470)));
                        }
                    }
                    let _e475 = local_7;
                    let _e478 = local_8;
                    if (_e475.w > _e478.w) {
                        let _e481 = (_e475.w - _e478.w);
                        let _e482 = (_e481 / _e475.w);
                        let _e484 = local_9;
                        let _e488 = local_10;
                        let _e492 = local_11;
                        let _e497 = local_12;
                        phi_615_ = (_e497 + vec4<f32>((_e484.x * _e482), (_e488.y * _e482), (_e492.z * _e482), _e481));
                    } else {
                        let _e2093 = local_53;
                        phi_615_ = _e2093;
                    }
                    let _e500 = phi_615_;
                    if (_e500.w > 1f) {
                        phi_629_ = vec4<f32>((_e500.x / _e500.w), (_e500.y / _e500.w), (_e500.z / _e500.w), 1f);
                    } else {
                        phi_629_ = _e500;
                    }
                    let _e511 = phi_629_;
                    phi_632_ = array<vec4<f32>, 8>(_e317[0], _e511, _e317[2], _e317[3], _e317[4], _e317[5], _e317[6], _e317[7]);
                    let _e2098 = local_54;
                    phi_633_ = _e2098;
                } else {
                    phi_632_ = _e317;
                    phi_633_ = _e319;
                }
                let _e522 = phi_632_;
                let _e524 = phi_633_;
                if (((_e72 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    let _e532 = facet_bits.member[_e73];
                    let _e533 = ((_e65 + 2u) & 31u);
                    let _e540 = facet_bits.member[(_e73 + 1u)];
                    let _e548 = facet_bits.member[(_e73 + 2u)];
                    let _e556 = facet_bits.member[(_e73 + 3u)];
                    let _e564 = facet_bits.member[(_e73 + 4u)];
                    let _e572 = facet_bits.member[(_e73 + 5u)];
                    phi_686_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_689_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_691_ = _e524;
                    loop {
                        let _e579 = phi_686_;
                        let _e581 = phi_689_;
                        let _e583 = phi_691_;
                        let _e587 = facets.member[_e583].member_2;
                        let _e591 = (2u * _e583);
                        let _e594 = radiance.member[_e591];
                        let _e598 = radiance.member[(_e591 + 1u)];
                        let _e604 = -((((_e120 * _e587[0]) + (_e122 * _e587[1])) + (_e124 * _e587[2])));
                        if (_e54 == 1u) {
                            let _e657 = sqrt((((_e587[0] * _e587[0]) + (_e587[1] * _e587[1])) + (_e587[2] * _e587[2])));
                            phi_687_ = _e579;
                            phi_690_ = vec4<f32>((_e581.x + (select(_e598.x, _e594.x, (_e594.x > _e598.x)) * _e657)), (_e581.y + (select(_e598.y, _e594.y, (_e594.y > _e598.y)) * _e657)), (_e581.z + (select(_e598.z, _e594.z, (_e594.z > _e598.z)) * _e657)), (_e581.w + _e657));
                        } else {
                            if (_e604 > 0f) {
                                phi_802_ = _e579;
                                phi_803_ = vec4<f32>((_e581.x + (_e594.x * _e604)), (_e581.y + (_e594.y * _e604)), (_e581.z + (_e594.z * _e604)), (_e581.w + _e604));
                            } else {
                                phi_802_ = vec4<f32>((_e579.x - (_e598.x * _e604)), (_e579.y - (_e598.y * _e604)), (_e579.z - (_e598.z * _e604)), (_e579.w - _e604));
                                phi_803_ = _e581;
                            }
                            let _e637 = phi_802_;
                            let _e639 = phi_803_;
                            phi_687_ = _e637;
                            phi_690_ = _e639;
                        }
                        let _e671 = phi_687_;
                        let _e673 = phi_690_;
                        let _e674 = (_e583 + 1u);
                        let _e675 = (_e524 + (((((((_e532 >> bitcast<u32>(_e533)) & 1u) + ((_e540 >> bitcast<u32>(_e533)) & 1u)) + ((_e548 >> bitcast<u32>(_e533)) & 1u)) + ((_e556 >> bitcast<u32>(_e533)) & 1u)) + ((_e564 >> bitcast<u32>(_e533)) & 1u)) + ((_e572 >> bitcast<u32>(_e533)) & 1u)));
                        local_13 = _e671;
                        local_14 = _e673;
                        local_15 = _e671;
                        local_16 = _e671;
                        local_17 = _e671;
                        local_18 = _e673;
                        local_55 = _e673;
                        local_56 = _e675;
                        continue;
                        continuing {
                            phi_686_ = _e671;
                            phi_689_ = _e673;
                            phi_691_ = _e674;
                            break if !(select(true, false, (_e674 >= _e675)));
                        }
                    }
                    let _e680 = local_13;
                    let _e683 = local_14;
                    if (_e680.w > _e683.w) {
                        let _e686 = (_e680.w - _e683.w);
                        let _e687 = (_e686 / _e680.w);
                        let _e689 = local_15;
                        let _e693 = local_16;
                        let _e697 = local_17;
                        let _e702 = local_18;
                        phi_831_ = (_e702 + vec4<f32>((_e689.x * _e687), (_e693.y * _e687), (_e697.z * _e687), _e686));
                    } else {
                        let _e2114 = local_55;
                        phi_831_ = _e2114;
                    }
                    let _e705 = phi_831_;
                    if (_e705.w > 1f) {
                        phi_845_ = vec4<f32>((_e705.x / _e705.w), (_e705.y / _e705.w), (_e705.z / _e705.w), 1f);
                    } else {
                        phi_845_ = _e705;
                    }
                    let _e716 = phi_845_;
                    phi_848_ = array<vec4<f32>, 8>(_e522[0], _e522[1], _e716, _e522[3], _e522[4], _e522[5], _e522[6], _e522[7]);
                    let _e2119 = local_56;
                    phi_849_ = _e2119;
                } else {
                    phi_848_ = _e522;
                    phi_849_ = _e524;
                }
                let _e727 = phi_848_;
                let _e729 = phi_849_;
                if (((_e72 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    let _e737 = facet_bits.member[_e73];
                    let _e738 = ((_e65 + 3u) & 31u);
                    let _e745 = facet_bits.member[(_e73 + 1u)];
                    let _e753 = facet_bits.member[(_e73 + 2u)];
                    let _e761 = facet_bits.member[(_e73 + 3u)];
                    let _e769 = facet_bits.member[(_e73 + 4u)];
                    let _e777 = facet_bits.member[(_e73 + 5u)];
                    phi_902_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_905_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_907_ = _e729;
                    loop {
                        let _e784 = phi_902_;
                        let _e786 = phi_905_;
                        let _e788 = phi_907_;
                        let _e792 = facets.member[_e788].member_2;
                        let _e796 = (2u * _e788);
                        let _e799 = radiance.member[_e796];
                        let _e803 = radiance.member[(_e796 + 1u)];
                        let _e809 = -((((_e120 * _e792[0]) + (_e122 * _e792[1])) + (_e124 * _e792[2])));
                        if (_e54 == 1u) {
                            let _e862 = sqrt((((_e792[0] * _e792[0]) + (_e792[1] * _e792[1])) + (_e792[2] * _e792[2])));
                            phi_903_ = _e784;
                            phi_906_ = vec4<f32>((_e786.x + (select(_e803.x, _e799.x, (_e799.x > _e803.x)) * _e862)), (_e786.y + (select(_e803.y, _e799.y, (_e799.y > _e803.y)) * _e862)), (_e786.z + (select(_e803.z, _e799.z, (_e799.z > _e803.z)) * _e862)), (_e786.w + _e862));
                        } else {
                            if (_e809 > 0f) {
                                phi_1018_ = _e784;
                                phi_1019_ = vec4<f32>((_e786.x + (_e799.x * _e809)), (_e786.y + (_e799.y * _e809)), (_e786.z + (_e799.z * _e809)), (_e786.w + _e809));
                            } else {
                                phi_1018_ = vec4<f32>((_e784.x - (_e803.x * _e809)), (_e784.y - (_e803.y * _e809)), (_e784.z - (_e803.z * _e809)), (_e784.w - _e809));
                                phi_1019_ = _e786;
                            }
                            let _e842 = phi_1018_;
                            let _e844 = phi_1019_;
                            phi_903_ = _e842;
                            phi_906_ = _e844;
                        }
                        let _e876 = phi_903_;
                        let _e878 = phi_906_;
                        let _e879 = (_e788 + 1u);
                        let _e880 = (_e729 + (((((((_e737 >> bitcast<u32>(_e738)) & 1u) + ((_e745 >> bitcast<u32>(_e738)) & 1u)) + ((_e753 >> bitcast<u32>(_e738)) & 1u)) + ((_e761 >> bitcast<u32>(_e738)) & 1u)) + ((_e769 >> bitcast<u32>(_e738)) & 1u)) + ((_e777 >> bitcast<u32>(_e738)) & 1u)));
                        local_19 = _e876;
                        local_20 = _e878;
                        local_21 = _e876;
                        local_22 = _e876;
                        local_23 = _e876;
                        local_24 = _e878;
                        local_57 = _e878;
                        local_58 = _e880;
                        continue;
                        continuing {
                            phi_902_ = _e876;
                            phi_905_ = _e878;
                            phi_907_ = _e879;
                            break if !(select(true, false, (_e879 >= _e880)));
                        }
                    }
                    let _e885 = local_19;
                    let _e888 = local_20;
                    if (_e885.w > _e888.w) {
                        let _e891 = (_e885.w - _e888.w);
                        let _e892 = (_e891 / _e885.w);
                        let _e894 = local_21;
                        let _e898 = local_22;
                        let _e902 = local_23;
                        let _e907 = local_24;
                        phi_1047_ = (_e907 + vec4<f32>((_e894.x * _e892), (_e898.y * _e892), (_e902.z * _e892), _e891));
                    } else {
                        let _e2135 = local_57;
                        phi_1047_ = _e2135;
                    }
                    let _e910 = phi_1047_;
                    if (_e910.w > 1f) {
                        phi_1061_ = vec4<f32>((_e910.x / _e910.w), (_e910.y / _e910.w), (_e910.z / _e910.w), 1f);
                    } else {
                        phi_1061_ = _e910;
                    }
                    let _e921 = phi_1061_;
                    phi_1064_ = array<vec4<f32>, 8>(_e727[0], _e727[1], _e727[2], _e921, _e727[4], _e727[5], _e727[6], _e727[7]);
                    let _e2140 = local_58;
                    phi_1065_ = _e2140;
                } else {
                    phi_1064_ = _e727;
                    phi_1065_ = _e729;
                }
                let _e932 = phi_1064_;
                let _e934 = phi_1065_;
                if (((_e72 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    let _e942 = facet_bits.member[_e73];
                    let _e943 = ((_e65 + 4u) & 31u);
                    let _e950 = facet_bits.member[(_e73 + 1u)];
                    let _e958 = facet_bits.member[(_e73 + 2u)];
                    let _e966 = facet_bits.member[(_e73 + 3u)];
                    let _e974 = facet_bits.member[(_e73 + 4u)];
                    let _e982 = facet_bits.member[(_e73 + 5u)];
                    phi_1118_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1121_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1123_ = _e934;
                    loop {
                        let _e989 = phi_1118_;
                        let _e991 = phi_1121_;
                        let _e993 = phi_1123_;
                        let _e997 = facets.member[_e993].member_2;
                        let _e1001 = (2u * _e993);
                        let _e1004 = radiance.member[_e1001];
                        let _e1008 = radiance.member[(_e1001 + 1u)];
                        let _e1014 = -((((_e120 * _e997[0]) + (_e122 * _e997[1])) + (_e124 * _e997[2])));
                        if (_e54 == 1u) {
                            let _e1067 = sqrt((((_e997[0] * _e997[0]) + (_e997[1] * _e997[1])) + (_e997[2] * _e997[2])));
                            phi_1119_ = _e989;
                            phi_1122_ = vec4<f32>((_e991.x + (select(_e1008.x, _e1004.x, (_e1004.x > _e1008.x)) * _e1067)), (_e991.y + (select(_e1008.y, _e1004.y, (_e1004.y > _e1008.y)) * _e1067)), (_e991.z + (select(_e1008.z, _e1004.z, (_e1004.z > _e1008.z)) * _e1067)), (_e991.w + _e1067));
                        } else {
                            if (_e1014 > 0f) {
                                phi_1234_ = _e989;
                                phi_1235_ = vec4<f32>((_e991.x + (_e1004.x * _e1014)), (_e991.y + (_e1004.y * _e1014)), (_e991.z + (_e1004.z * _e1014)), (_e991.w + _e1014));
                            } else {
                                phi_1234_ = vec4<f32>((_e989.x - (_e1008.x * _e1014)), (_e989.y - (_e1008.y * _e1014)), (_e989.z - (_e1008.z * _e1014)), (_e989.w - _e1014));
                                phi_1235_ = _e991;
                            }
                            let _e1047 = phi_1234_;
                            let _e1049 = phi_1235_;
                            phi_1119_ = _e1047;
                            phi_1122_ = _e1049;
                        }
                        let _e1081 = phi_1119_;
                        let _e1083 = phi_1122_;
                        let _e1084 = (_e993 + 1u);
                        let _e1085 = (_e934 + (((((((_e942 >> bitcast<u32>(_e943)) & 1u) + ((_e950 >> bitcast<u32>(_e943)) & 1u)) + ((_e958 >> bitcast<u32>(_e943)) & 1u)) + ((_e966 >> bitcast<u32>(_e943)) & 1u)) + ((_e974 >> bitcast<u32>(_e943)) & 1u)) + ((_e982 >> bitcast<u32>(_e943)) & 1u)));
                        local_25 = _e1081;
                        local_26 = _e1083;
                        local_27 = _e1081;
                        local_28 = _e1081;
                        local_29 = _e1081;
                        local_30 = _e1083;
                        local_59 = _e1083;
                        local_60 = _e1085;
                        continue;
                        continuing {
                            phi_1118_ = _e1081;
                            phi_1121_ = _e1083;
                            phi_1123_ = _e1084;
                            break if !(select(true, false, (_e1084 >= _e1085)));
                        }
                    }
                    let _e1090 = local_25;
                    let _e1093 = local_26;
                    if (_e1090.w > _e1093.w) {
                        let _e1096 = (_e1090.w - _e1093.w);
                        let _e1097 = (_e1096 / _e1090.w);
                        let _e1099 = local_27;
                        let _e1103 = local_28;
                        let _e1107 = local_29;
                        let _e1112 = local_30;
                        phi_1263_ = (_e1112 + vec4<f32>((_e1099.x * _e1097), (_e1103.y * _e1097), (_e1107.z * _e1097), _e1096));
                    } else {
                        let _e2156 = local_59;
                        phi_1263_ = _e2156;
                    }
                    let _e1115 = phi_1263_;
                    if (_e1115.w > 1f) {
                        phi_1277_ = vec4<f32>((_e1115.x / _e1115.w), (_e1115.y / _e1115.w), (_e1115.z / _e1115.w), 1f);
                    } else {
                        phi_1277_ = _e1115;
                    }
                    let _e1126 = phi_1277_;
                    phi_1280_ = array<vec4<f32>, 8>(_e932[0], _e932[1], _e932[2], _e932[3], _e1126, _e932[5], _e932[6], _e932[7]);
                    let _e2161 = local_60;
                    phi_1281_ = _e2161;
                } else {
                    phi_1280_ = _e932;
                    phi_1281_ = _e934;
                }
                let _e1137 = phi_1280_;
                let _e1139 = phi_1281_;
                if (((_e72 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    let _e1147 = facet_bits.member[_e73];
                    let _e1148 = ((_e65 + 5u) & 31u);
                    let _e1155 = facet_bits.member[(_e73 + 1u)];
                    let _e1163 = facet_bits.member[(_e73 + 2u)];
                    let _e1171 = facet_bits.member[(_e73 + 3u)];
                    let _e1179 = facet_bits.member[(_e73 + 4u)];
                    let _e1187 = facet_bits.member[(_e73 + 5u)];
                    phi_1334_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1337_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1339_ = _e1139;
                    loop {
                        let _e1194 = phi_1334_;
                        let _e1196 = phi_1337_;
                        let _e1198 = phi_1339_;
                        let _e1202 = facets.member[_e1198].member_2;
                        let _e1206 = (2u * _e1198);
                        let _e1209 = radiance.member[_e1206];
                        let _e1213 = radiance.member[(_e1206 + 1u)];
                        let _e1219 = -((((_e120 * _e1202[0]) + (_e122 * _e1202[1])) + (_e124 * _e1202[2])));
                        if (_e54 == 1u) {
                            let _e1272 = sqrt((((_e1202[0] * _e1202[0]) + (_e1202[1] * _e1202[1])) + (_e1202[2] * _e1202[2])));
                            phi_1335_ = _e1194;
                            phi_1338_ = vec4<f32>((_e1196.x + (select(_e1213.x, _e1209.x, (_e1209.x > _e1213.x)) * _e1272)), (_e1196.y + (select(_e1213.y, _e1209.y, (_e1209.y > _e1213.y)) * _e1272)), (_e1196.z + (select(_e1213.z, _e1209.z, (_e1209.z > _e1213.z)) * _e1272)), (_e1196.w + _e1272));
                        } else {
                            if (_e1219 > 0f) {
                                phi_1450_ = _e1194;
                                phi_1451_ = vec4<f32>((_e1196.x + (_e1209.x * _e1219)), (_e1196.y + (_e1209.y * _e1219)), (_e1196.z + (_e1209.z * _e1219)), (_e1196.w + _e1219));
                            } else {
                                phi_1450_ = vec4<f32>((_e1194.x - (_e1213.x * _e1219)), (_e1194.y - (_e1213.y * _e1219)), (_e1194.z - (_e1213.z * _e1219)), (_e1194.w - _e1219));
                                phi_1451_ = _e1196;
                            }
                            let _e1252 = phi_1450_;
                            let _e1254 = phi_1451_;
                            phi_1335_ = _e1252;
                            phi_1338_ = _e1254;
                        }
                        let _e1286 = phi_1335_;
                        let _e1288 = phi_1338_;
                        let _e1289 = (_e1198 + 1u);
                        let _e1290 = (_e1139 + (((((((_e1147 >> bitcast<u32>(_e1148)) & 1u) + ((_e1155 >> bitcast<u32>(_e1148)) & 1u)) + ((_e1163 >> bitcast<u32>(_e1148)) & 1u)) + ((_e1171 >> bitcast<u32>(_e1148)) & 1u)) + ((_e1179 >> bitcast<u32>(_e1148)) & 1u)) + ((_e1187 >> bitcast<u32>(_e1148)) & 1u)));
                        local_31 = _e1286;
                        local_32 = _e1288;
                        local_33 = _e1286;
                        local_34 = _e1286;
                        local_35 = _e1286;
                        local_36 = _e1288;
                        local_61 = _e1288;
                        local_62 = _e1290;
                        continue;
                        continuing {
                            phi_1334_ = _e1286;
                            phi_1337_ = _e1288;
                            phi_1339_ = _e1289;
                            break if !(select(true, false, (_e1289 >= _e1290)));
                        }
                    }
                    let _e1295 = local_31;
                    let _e1298 = local_32;
                    if (_e1295.w > _e1298.w) {
                        let _e1301 = (_e1295.w - _e1298.w);
                        let _e1302 = (_e1301 / _e1295.w);
                        let _e1304 = local_33;
                        let _e1308 = local_34;
                        let _e1312 = local_35;
                        let _e1317 = local_36;
                        phi_1479_ = (_e1317 + vec4<f32>((_e1304.x * _e1302), (_e1308.y * _e1302), (_e1312.z * _e1302), _e1301));
                    } else {
                        let _e2177 = local_61;
                        phi_1479_ = _e2177;
                    }
                    let _e1320 = phi_1479_;
                    if (_e1320.w > 1f) {
                        phi_1493_ = vec4<f32>((_e1320.x / _e1320.w), (_e1320.y / _e1320.w), (_e1320.z / _e1320.w), 1f);
                    } else {
                        phi_1493_ = _e1320;
                    }
                    let _e1331 = phi_1493_;
                    phi_1496_ = array<vec4<f32>, 8>(_e1137[0], _e1137[1], _e1137[2], _e1137[3], _e1137[4], _e1331, _e1137[6], _e1137[7]);
                    let _e2182 = local_62;
                    phi_1497_ = _e2182;
                } else {
                    phi_1496_ = _e1137;
                    phi_1497_ = _e1139;
                }
                let _e1342 = phi_1496_;
                let _e1344 = phi_1497_;
                if (((_e72 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    let _e1352 = facet_bits.member[_e73];
                    let _e1353 = ((_e65 + 6u) & 31u);
                    let _e1360 = facet_bits.member[(_e73 + 1u)];
                    let _e1368 = facet_bits.member[(_e73 + 2u)];
                    let _e1376 = facet_bits.member[(_e73 + 3u)];
                    let _e1384 = facet_bits.member[(_e73 + 4u)];
                    let _e1392 = facet_bits.member[(_e73 + 5u)];
                    phi_1550_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1553_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1555_ = _e1344;
                    loop {
                        let _e1399 = phi_1550_;
                        let _e1401 = phi_1553_;
                        let _e1403 = phi_1555_;
                        let _e1407 = facets.member[_e1403].member_2;
                        let _e1411 = (2u * _e1403);
                        let _e1414 = radiance.member[_e1411];
                        let _e1418 = radiance.member[(_e1411 + 1u)];
                        let _e1424 = -((((_e120 * _e1407[0]) + (_e122 * _e1407[1])) + (_e124 * _e1407[2])));
                        if (_e54 == 1u) {
                            let _e1477 = sqrt((((_e1407[0] * _e1407[0]) + (_e1407[1] * _e1407[1])) + (_e1407[2] * _e1407[2])));
                            phi_1551_ = _e1399;
                            phi_1554_ = vec4<f32>((_e1401.x + (select(_e1418.x, _e1414.x, (_e1414.x > _e1418.x)) * _e1477)), (_e1401.y + (select(_e1418.y, _e1414.y, (_e1414.y > _e1418.y)) * _e1477)), (_e1401.z + (select(_e1418.z, _e1414.z, (_e1414.z > _e1418.z)) * _e1477)), (_e1401.w + _e1477));
                        } else {
                            if (_e1424 > 0f) {
                                phi_1666_ = _e1399;
                                phi_1667_ = vec4<f32>((_e1401.x + (_e1414.x * _e1424)), (_e1401.y + (_e1414.y * _e1424)), (_e1401.z + (_e1414.z * _e1424)), (_e1401.w + _e1424));
                            } else {
                                phi_1666_ = vec4<f32>((_e1399.x - (_e1418.x * _e1424)), (_e1399.y - (_e1418.y * _e1424)), (_e1399.z - (_e1418.z * _e1424)), (_e1399.w - _e1424));
                                phi_1667_ = _e1401;
                            }
                            let _e1457 = phi_1666_;
                            let _e1459 = phi_1667_;
                            phi_1551_ = _e1457;
                            phi_1554_ = _e1459;
                        }
                        let _e1491 = phi_1551_;
                        let _e1493 = phi_1554_;
                        let _e1494 = (_e1403 + 1u);
                        let _e1495 = (_e1344 + (((((((_e1352 >> bitcast<u32>(_e1353)) & 1u) + ((_e1360 >> bitcast<u32>(_e1353)) & 1u)) + ((_e1368 >> bitcast<u32>(_e1353)) & 1u)) + ((_e1376 >> bitcast<u32>(_e1353)) & 1u)) + ((_e1384 >> bitcast<u32>(_e1353)) & 1u)) + ((_e1392 >> bitcast<u32>(_e1353)) & 1u)));
                        local_37 = _e1491;
                        local_38 = _e1493;
                        local_39 = _e1491;
                        local_40 = _e1491;
                        local_41 = _e1491;
                        local_42 = _e1493;
                        local_63 = _e1493;
                        local_64 = _e1495;
                        continue;
                        continuing {
                            phi_1550_ = _e1491;
                            phi_1553_ = _e1493;
                            phi_1555_ = _e1494;
                            break if !(select(true, false, (_e1494 >= _e1495)));
                        }
                    }
                    let _e1500 = local_37;
                    let _e1503 = local_38;
                    if (_e1500.w > _e1503.w) {
                        let _e1506 = (_e1500.w - _e1503.w);
                        let _e1507 = (_e1506 / _e1500.w);
                        let _e1509 = local_39;
                        let _e1513 = local_40;
                        let _e1517 = local_41;
                        let _e1522 = local_42;
                        phi_1695_ = (_e1522 + vec4<f32>((_e1509.x * _e1507), (_e1513.y * _e1507), (_e1517.z * _e1507), _e1506));
                    } else {
                        let _e2198 = local_63;
                        phi_1695_ = _e2198;
                    }
                    let _e1525 = phi_1695_;
                    if (_e1525.w > 1f) {
                        phi_1709_ = vec4<f32>((_e1525.x / _e1525.w), (_e1525.y / _e1525.w), (_e1525.z / _e1525.w), 1f);
                    } else {
                        phi_1709_ = _e1525;
                    }
                    let _e1536 = phi_1709_;
                    phi_1712_ = array<vec4<f32>, 8>(_e1342[0], _e1342[1], _e1342[2], _e1342[3], _e1342[4], _e1342[5], _e1536, _e1342[7]);
                    let _e2203 = local_64;
                    phi_1713_ = _e2203;
                } else {
                    phi_1712_ = _e1342;
                    phi_1713_ = _e1344;
                }
                let _e1547 = phi_1712_;
                let _e1549 = phi_1713_;
                if (((_e72 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    let _e1557 = facet_bits.member[_e73];
                    let _e1558 = ((_e65 + 7u) & 31u);
                    let _e1565 = facet_bits.member[(_e73 + 1u)];
                    let _e1573 = facet_bits.member[(_e73 + 2u)];
                    let _e1581 = facet_bits.member[(_e73 + 3u)];
                    let _e1589 = facet_bits.member[(_e73 + 4u)];
                    let _e1597 = facet_bits.member[(_e73 + 5u)];
                    phi_1766_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1769_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1771_ = _e1549;
                    loop {
                        let _e1604 = phi_1766_;
                        let _e1606 = phi_1769_;
                        let _e1608 = phi_1771_;
                        let _e1612 = facets.member[_e1608].member_2;
                        let _e1616 = (2u * _e1608);
                        let _e1619 = radiance.member[_e1616];
                        let _e1623 = radiance.member[(_e1616 + 1u)];
                        let _e1629 = -((((_e120 * _e1612[0]) + (_e122 * _e1612[1])) + (_e124 * _e1612[2])));
                        if (_e54 == 1u) {
                            let _e1682 = sqrt((((_e1612[0] * _e1612[0]) + (_e1612[1] * _e1612[1])) + (_e1612[2] * _e1612[2])));
                            phi_1767_ = _e1604;
                            phi_1770_ = vec4<f32>((_e1606.x + (select(_e1623.x, _e1619.x, (_e1619.x > _e1623.x)) * _e1682)), (_e1606.y + (select(_e1623.y, _e1619.y, (_e1619.y > _e1623.y)) * _e1682)), (_e1606.z + (select(_e1623.z, _e1619.z, (_e1619.z > _e1623.z)) * _e1682)), (_e1606.w + _e1682));
                        } else {
                            if (_e1629 > 0f) {
                                phi_1882_ = _e1604;
                                phi_1883_ = vec4<f32>((_e1606.x + (_e1619.x * _e1629)), (_e1606.y + (_e1619.y * _e1629)), (_e1606.z + (_e1619.z * _e1629)), (_e1606.w + _e1629));
                            } else {
                                phi_1882_ = vec4<f32>((_e1604.x - (_e1623.x * _e1629)), (_e1604.y - (_e1623.y * _e1629)), (_e1604.z - (_e1623.z * _e1629)), (_e1604.w - _e1629));
                                phi_1883_ = _e1606;
                            }
                            let _e1662 = phi_1882_;
                            let _e1664 = phi_1883_;
                            phi_1767_ = _e1662;
                            phi_1770_ = _e1664;
                        }
                        let _e1696 = phi_1767_;
                        let _e1698 = phi_1770_;
                        let _e1699 = (_e1608 + 1u);
                        local_43 = _e1696;
                        local_44 = _e1698;
                        local_45 = _e1696;
                        local_46 = _e1696;
                        local_47 = _e1696;
                        local_48 = _e1698;
                        local_65 = _e1698;
                        continue;
                        continuing {
                            phi_1766_ = _e1696;
                            phi_1769_ = _e1698;
                            phi_1771_ = _e1699;
                            break if !(select(true, false, (_e1699 >= (_e1549 + (((((((_e1557 >> bitcast<u32>(_e1558)) & 1u) + ((_e1565 >> bitcast<u32>(_e1558)) & 1u)) + ((_e1573 >> bitcast<u32>(_e1558)) & 1u)) + ((_e1581 >> bitcast<u32>(_e1558)) & 1u)) + ((_e1589 >> bitcast<u32>(_e1558)) & 1u)) + ((_e1597 >> bitcast<u32>(_e1558)) & 1u))))));
                        }
                    }
                    let _e1705 = local_43;
                    let _e1708 = local_44;
                    if (_e1705.w > _e1708.w) {
                        let _e1711 = (_e1705.w - _e1708.w);
                        let _e1712 = (_e1711 / _e1705.w);
                        let _e1714 = local_45;
                        let _e1718 = local_46;
                        let _e1722 = local_47;
                        let _e1727 = local_48;
                        phi_1911_ = (_e1727 + vec4<f32>((_e1714.x * _e1712), (_e1718.y * _e1712), (_e1722.z * _e1712), _e1711));
                    } else {
                        let _e2219 = local_65;
                        phi_1911_ = _e2219;
                    }
                    let _e1730 = phi_1911_;
                    if (_e1730.w > 1f) {
                        phi_1925_ = vec4<f32>((_e1730.x / _e1730.w), (_e1730.y / _e1730.w), (_e1730.z / _e1730.w), 1f);
                    } else {
                        phi_1925_ = _e1730;
                    }
                    let _e1741 = phi_1925_;
                    phi_1927_ = array<vec4<f32>, 8>(_e1547[0], _e1547[1], _e1547[2], _e1547[3], _e1547[4], _e1547[5], _e1547[6], _e1741);
                } else {
                    phi_1927_ = _e1547;
                }
                let _e1752 = phi_1927_;
                if (_e54 == 1u) {
                    let _e2026 = ((((_e1752[0].x + _e1752[1].x) + (_e1752[2].x + _e1752[3].x)) + ((_e1752[4].x + _e1752[5].x) + (_e1752[6].x + _e1752[7].x))) * 0.25f);
                    let _e2027 = ((((_e1752[0].y + _e1752[1].y) + (_e1752[2].y + _e1752[3].y)) + ((_e1752[4].y + _e1752[5].y) + (_e1752[6].y + _e1752[7].y))) * 0.25f);
                    let _e2028 = ((((_e1752[0].z + _e1752[1].z) + (_e1752[2].z + _e1752[3].z)) + ((_e1752[4].z + _e1752[5].z) + (_e1752[6].z + _e1752[7].z))) * 0.25f);
                    let _e2029 = ((((_e1752[0].w + _e1752[1].w) + (_e1752[2].w + _e1752[3].w)) + ((_e1752[4].w + _e1752[5].w) + (_e1752[6].w + _e1752[7].w))) * 0.25f);
                    if (_e2029 > 1f) {
                        phi_2016_ = vec4<f32>((_e2026 / _e2029), (_e2027 / _e2029), (_e2028 / _e2029), (_e2029 / _e2029));
                    } else {
                        phi_2016_ = vec4<f32>(_e2026, _e2027, _e2028, _e2029);
                    }
                    let _e2038 = phi_2016_;
                    phi_2341_ = _e2038;
                } else {
                    if _e119 {
                        phi_2033_ = _e1752[1];
                    } else {
                        phi_2033_ = select(_e1752[4], _e1752[2], vec4(_e121));
                    }
                    let _e1761 = phi_2033_;
                    if _e117 {
                        let _e1784 = ((1f - _e1761.w) / select(0.000000000000000000000000000000000000011754944f, _e1752[0].w, (_e1752[0].w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1786 = select(1f, _e1784, (_e1784 < 1f));
                        phi_2085_ = (_e1761 + vec4<f32>((_e1752[0].x * _e1786), (_e1752[0].y * _e1786), (_e1752[0].z * _e1786), (_e1752[0].w * _e1786)));
                    } else {
                        let _e1767 = ((1f - _e1752[0].w) / select(0.000000000000000000000000000000000000011754944f, _e1761.w, (_e1761.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1769 = select(1f, _e1767, (_e1767 < 1f));
                        phi_2085_ = (_e1752[0] + vec4<f32>((_e1761.x * _e1769), (_e1761.y * _e1769), (_e1761.z * _e1769), (_e1761.w * _e1769)));
                    }
                    let _e1797 = phi_2085_;
                    let _e1798 = vec4(_e119);
                    let _e1799 = select(_e1752[1], _e1752[2], _e1798);
                    if _e119 {
                        phi_2111_ = _e1752[3];
                    } else {
                        phi_2111_ = select(_e1752[5], _e1752[3], vec4(_e121));
                    }
                    let _e1805 = phi_2111_;
                    if _e117 {
                        let _e1828 = ((1f - _e1805.w) / select(0.000000000000000000000000000000000000011754944f, _e1799.w, (_e1799.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1830 = select(1f, _e1828, (_e1828 < 1f));
                        phi_2163_ = (_e1805 + vec4<f32>((_e1799.x * _e1830), (_e1799.y * _e1830), (_e1799.z * _e1830), (_e1799.w * _e1830)));
                    } else {
                        let _e1811 = ((1f - _e1799.w) / select(0.000000000000000000000000000000000000011754944f, _e1805.w, (_e1805.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1813 = select(1f, _e1811, (_e1811 < 1f));
                        phi_2163_ = (_e1799 + vec4<f32>((_e1805.x * _e1813), (_e1805.y * _e1813), (_e1805.z * _e1813), (_e1805.w * _e1813)));
                    }
                    let _e1841 = phi_2163_;
                    if _e119 {
                        phi_2188_ = _e1752[4];
                    } else {
                        phi_2188_ = select(_e1752[2], _e1752[4], vec4(_e121));
                    }
                    let _e1857 = phi_2188_;
                    let _e1859 = select(_e1752[6], _e1752[5], _e1798);
                    if _e117 {
                        let _e1882 = ((1f - _e1859.w) / select(0.000000000000000000000000000000000000011754944f, _e1857.w, (_e1857.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1884 = select(1f, _e1882, (_e1882 < 1f));
                        phi_2253_ = (_e1859 + vec4<f32>((_e1857.x * _e1884), (_e1857.y * _e1884), (_e1857.z * _e1884), (_e1857.w * _e1884)));
                    } else {
                        let _e1865 = ((1f - _e1857.w) / select(0.000000000000000000000000000000000000011754944f, _e1859.w, (_e1859.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1867 = select(1f, _e1865, (_e1865 < 1f));
                        phi_2253_ = (_e1857 + vec4<f32>((_e1859.x * _e1867), (_e1859.y * _e1867), (_e1859.z * _e1867), (_e1859.w * _e1867)));
                    }
                    let _e1895 = phi_2253_;
                    if _e119 {
                        phi_2274_ = _e1752[6];
                    } else {
                        phi_2274_ = select(_e1752[3], _e1752[5], vec4(_e121));
                    }
                    let _e1907 = phi_2274_;
                    if _e117 {
                        let _e1931 = ((1f - _e1752[7].w) / select(0.000000000000000000000000000000000000011754944f, _e1907.w, (_e1907.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1933 = select(1f, _e1931, (_e1931 < 1f));
                        phi_2327_ = (_e1752[7] + vec4<f32>((_e1907.x * _e1933), (_e1907.y * _e1933), (_e1907.z * _e1933), (_e1907.w * _e1933)));
                    } else {
                        let _e1914 = ((1f - _e1907.w) / select(0.000000000000000000000000000000000000011754944f, _e1752[7].w, (_e1752[7].w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1916 = select(1f, _e1914, (_e1914 < 1f));
                        phi_2327_ = (_e1907 + vec4<f32>((_e1752[7].x * _e1916), (_e1752[7].y * _e1916), (_e1752[7].z * _e1916), (_e1752[7].w * _e1916)));
                    }
                    let _e1944 = phi_2327_;
                    phi_2341_ = vec4<f32>(((((_e1797.x + _e1841.x) + _e1895.x) + _e1944.x) * 0.25f), ((((_e1797.y + _e1841.y) + _e1895.y) + _e1944.y) * 0.25f), ((((_e1797.z + _e1841.z) + _e1895.z) + _e1944.z) * 0.25f), ((((_e1797.w + _e1841.w) + _e1895.w) + _e1944.w) * 0.25f));
                }
                let _e2040 = phi_2341_;
                let _e2043 = ((_e43 + _e50) + (_e50 - _e50));
                if (_e2043 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e2043] = _e2040;
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
