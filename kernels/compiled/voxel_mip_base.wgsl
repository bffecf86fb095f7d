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
    var local: array<vec4<f32>, 8>;
    var phi_129_: type_10;
    var phi_132_: u32;
    var phi_130_: type_10;
    var phi_155_: type_10;
    var phi_133_: u32;
    var phi_263_: vec4<f32>;
    var phi_266_: vec4<f32>;
    var phi_268_: u32;
    var phi_379_: vec4<f32>;
    var phi_380_: vec4<f32>;
    var phi_264_: vec4<f32>;
    var phi_267_: vec4<f32>;
    var local_1: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_408_: vec4<f32>;
    var phi_422_: vec4<f32>;
    var phi_425_: u32;
    var phi_478_: vec4<f32>;
    var phi_481_: vec4<f32>;
    var phi_483_: u32;
    var phi_594_: vec4<f32>;
    var phi_595_: vec4<f32>;
    var phi_479_: vec4<f32>;
    var phi_482_: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;
    var phi_623_: vec4<f32>;
    var phi_637_: vec4<f32>;
    var phi_640_: u32;
    var phi_693_: vec4<f32>;
    var phi_696_: vec4<f32>;
    var phi_698_: u32;
    var phi_809_: vec4<f32>;
    var phi_810_: vec4<f32>;
    var phi_694_: vec4<f32>;
    var phi_697_: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var phi_838_: vec4<f32>;
    var phi_852_: vec4<f32>;
    var phi_855_: u32;
    var phi_908_: vec4<f32>;
    var phi_911_: vec4<f32>;
    var phi_913_: u32;
    var phi_1024_: vec4<f32>;
    var phi_1025_: vec4<f32>;
    var phi_909_: vec4<f32>;
    var phi_912_: vec4<f32>;
    var local_20: vec4<f32>;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var phi_1053_: vec4<f32>;
    var phi_1067_: vec4<f32>;
    var phi_1070_: u32;
    var phi_1123_: vec4<f32>;
    var phi_1126_: vec4<f32>;
    var phi_1128_: u32;
    var phi_1239_: vec4<f32>;
    var phi_1240_: vec4<f32>;
    var phi_1124_: vec4<f32>;
    var phi_1127_: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var local_28: vec4<f32>;
    var local_29: vec4<f32>;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var phi_1268_: vec4<f32>;
    var phi_1282_: vec4<f32>;
    var phi_1285_: u32;
    var phi_1338_: vec4<f32>;
    var phi_1341_: vec4<f32>;
    var phi_1343_: u32;
    var phi_1454_: vec4<f32>;
    var phi_1455_: vec4<f32>;
    var phi_1339_: vec4<f32>;
    var phi_1342_: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var local_36: vec4<f32>;
    var local_37: vec4<f32>;
    var phi_1483_: vec4<f32>;
    var phi_1497_: vec4<f32>;
    var phi_1500_: u32;
    var phi_1553_: vec4<f32>;
    var phi_1556_: vec4<f32>;
    var phi_1558_: u32;
    var phi_1669_: vec4<f32>;
    var phi_1670_: vec4<f32>;
    var phi_1554_: vec4<f32>;
    var phi_1557_: vec4<f32>;
    var local_38: vec4<f32>;
    var local_39: vec4<f32>;
    var local_40: vec4<f32>;
    var local_41: vec4<f32>;
    var local_42: vec4<f32>;
    var local_43: vec4<f32>;
    var phi_1698_: vec4<f32>;
    var phi_1712_: vec4<f32>;
    var phi_1715_: u32;
    var phi_1768_: vec4<f32>;
    var phi_1771_: vec4<f32>;
    var phi_1773_: u32;
    var phi_1884_: vec4<f32>;
    var phi_1885_: vec4<f32>;
    var phi_1769_: vec4<f32>;
    var phi_1772_: vec4<f32>;
    var local_44: vec4<f32>;
    var local_45: vec4<f32>;
    var local_46: vec4<f32>;
    var local_47: vec4<f32>;
    var local_48: vec4<f32>;
    var local_49: vec4<f32>;
    var phi_1913_: vec4<f32>;
    var phi_1927_: vec4<f32>;
    var phi_2080_: vec4<f32>;
    var phi_2117_: vec4<f32>;
    var phi_2166_: vec4<f32>;
    var phi_2213_: vec4<f32>;
    var phi_2025_: vec4<f32>;
    var phi_2227_: vec4<f32>;
    var local_50: u32;
    var local_51: vec4<f32>;
    var local_52: u32;
    var local_53: u32;
    var local_54: vec4<f32>;
    var local_55: u32;
    var local_56: vec4<f32>;
    var local_57: u32;
    var local_58: vec4<f32>;
    var local_59: u32;
    var local_60: vec4<f32>;
    var local_61: u32;
    var local_62: vec4<f32>;
    var local_63: u32;
    var local_64: vec4<f32>;
    var local_65: u32;
    var local_66: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e37 = gid_1;
            let _e42 = params.member.member_12;
            let _e45 = params.member.member_13;
            let _e49 = (_e37.x + (_e37.y * 2097152u));
            if (_e49 < _e45) {
                let _e53 = params.member.member_6;
                if (_e53 == 0u) {
                    break;
                }
                let _e55 = (_e49 / _e53);
                let _e57 = (_e49 - (_e55 * _e53));
                let _e60 = children.member[_e55];
                let _e62 = (_e60 >> bitcast<u32>(2i));
                let _e64 = (8u * (_e60 & 3u));
                let _e65 = (2u * _e62);
                let _e68 = cells.member[_e65];
                let _e69 = (_e64 & 31u);
                let _e71 = (_e68 >> bitcast<u32>(_e69));
                let _e72 = (_e62 * 6u);
                let _e76 = cells.member[(_e65 + 1u)];
                phi_129_ = type_10(0u, 6u);
                phi_132_ = _e76;
                loop {
                    let _e78 = phi_129_;
                    let _e80 = phi_132_;
                    local_50 = _e80;
                    local_1 = _e80;
                    local_53 = _e80;
                    if (_e78.member < _e78.member_1) {
                        phi_130_ = type_10((_e78.member + 1u), _e78.member_1);
                        phi_155_ = type_10(1u, _e78.member);
                    } else {
                        phi_130_ = _e78;
                        phi_155_ = type_10(0u, type_10().member_1);
                    }
                    let _e93 = phi_130_;
                    let _e95 = phi_155_;
                    let _e99 = (bitcast<i32>(_e95.member) != 0i);
                    if _e99 {
                        let _e103 = facet_bits.member[(_e72 + _e95.member_1)];
                        phi_133_ = (_e80 + countOneBits((_e103 & ((1u << bitcast<u32>(_e69)) - 1u))));
                    } else {
                        phi_133_ = u32();
                    }
                    let _e111 = phi_133_;
                    continue;
                    continuing {
                        phi_129_ = _e93;
                        phi_132_ = _e111;
                        break if !(_e99);
                    }
                }
                let _e114 = (_e57 >> bitcast<u32>(1i));
                let _e116 = ((_e57 & 1u) == 1u);
                let _e117 = select(1f, -1f, _e116);
                let _e118 = (_e114 == 0u);
                let _e119 = select(0f, _e117, _e118);
                let _e121 = select(0f, _e117, (_e114 == 1u));
                let _e122 = (_e114 == 2u);
                let _e123 = select(0f, _e117, _e122);
                local[0u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[1u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[2u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[3u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[4u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[5u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[6u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[7u] = vec4<f32>(0f, 0f, 0f, 0f);
                if ((_e71 & 1u) == 1u) {
                    let _e136 = facet_bits.member[_e72];
                    let _e143 = facet_bits.member[(_e72 + 1u)];
                    let _e151 = facet_bits.member[(_e72 + 2u)];
                    let _e159 = facet_bits.member[(_e72 + 3u)];
                    let _e167 = facet_bits.member[(_e72 + 4u)];
                    let _e175 = facet_bits.member[(_e72 + 5u)];
                    phi_263_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_266_ = vec4<f32>(0f, 0f, 0f, 0f);
                    let _e1914 = local_50;
                    phi_268_ = _e1914;
                    loop {
                        let _e182 = phi_263_;
                        let _e184 = phi_266_;
                        let _e186 = phi_268_;
                        let _e190 = facets.member[_e186].member_2;
                        let _e194 = (2u * _e186);
                        let _e197 = radiance.member[_e194];
                        let _e201 = radiance.member[(_e194 + 1u)];
                        let _e207 = -((((_e119 * _e190[0]) + (_e121 * _e190[1])) + (_e123 * _e190[2])));
                        if (_e53 == 1u) {
                            let _e260 = sqrt((((_e190[0] * _e190[0]) + (_e190[1] * _e190[1])) + (_e190[2] * _e190[2])));
                            phi_264_ = _e182;
                            phi_267_ = vec4<f32>((_e184.x + (select(_e201.x, _e197.x, (_e197.x > _e201.x)) * _e260)), (_e184.y + (select(_e201.y, _e197.y, (_e197.y > _e201.y)) * _e260)), (_e184.z + (select(_e201.z, _e197.z, (_e197.z > _e201.z)) * _e260)), (_e184.w + _e260));
                        } else {
                            if (_e207 > 0f) {
                                phi_379_ = _e182;
                                phi_380_ = vec4<f32>((_e184.x + (_e197.x * _e207)), (_e184.y + (_e197.y * _e207)), (_e184.z + (_e197.z * _e207)), (_e184.w + _e207));
                            } else {
                                phi_379_ = vec4<f32>((_e182.x - (_e201.x * _e207)), (_e182.y - (_e201.y * _e207)), (_e182.z - (_e201.z * _e207)), (_e182.w - _e207));
                                phi_380_ = _e184;
                            }
                            let _e240 = phi_379_;
                            let _e242 = phi_380_;
                            phi_264_ = _e240;
                            phi_267_ = _e242;
                        }
                        let _e274 = phi_264_;
                        let _e276 = phi_267_;
                        let _e277 = (_e186 + 1u);
                        let _e279 = local_1;
                        let _e280 = (_e279 + (((((((_e136 >> bitcast<u32>(_e69)) & 1u) + ((_e143 >> bitcast<u32>(_e69)) & 1u)) + ((_e151 >> bitcast<u32>(_e69)) & 1u)) + ((_e159 >> bitcast<u32>(_e69)) & 1u)) + ((_e167 >> bitcast<u32>(_e69)) & 1u)) + ((_e175 >> bitcast<u32>(_e69)) & 1u)));
                        local_2 = _e274;
                        local_3 = _e276;
                        local_4 = _e274;
                        local_5 = _e274;
                        local_6 = _e274;
                        local_7 = _e276;
                        local_51 = _e276;
                        local_52 = _e280;
                        continue;
                        continuing {
                            phi_263_ = _e274;
                            phi_266_ = _e276;
                            phi_268_ = _e277;
                            break if !(select(true, false, (_e277 >= _e280)));
                        }
                    }
                    let _e285 = local_2;
                    let _e288 = local_3;
                    if (_e285.w > _e288.w) {
                        let _e291 = (_e285.w - _e288.w);
                        let _e292 = (_e291 / _e285.w);
                        let _e294 = local_4;
                        let _e298 = local_5;
                        let _e302 = local_6;
                        let _e307 = local_7;
                        phi_408_ = (_e307 + vec4<f32>((_e294.x * _e292), (_e298.y * _e292), (_e302.z * _e292), _e291));
                    } else {
                        let _e1928 = local_51;
                        phi_408_ = _e1928;
                    }
                    let _e310 = phi_408_;
                    if (_e310.w > 1f) {
                        phi_422_ = vec4<f32>((_e310.x / _e310.w), (_e310.y / _e310.w), (_e310.z / _e310.w), 1f);
                    } else {
                        phi_422_ = _e310;
                    }
                    let _e321 = phi_422_;
                    local[0u] = _e321;
                    let _e1932 = local_52;
                    phi_425_ = _e1932;
                } else {
                    let _e1934 = local_53;
                    phi_425_ = _e1934;
                }
                let _e323 = phi_425_;
                if (((_e71 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    let _e331 = facet_bits.member[_e72];
                    let _e332 = ((_e64 + 1u) & 31u);
                    let _e339 = facet_bits.member[(_e72 + 1u)];
                    let _e347 = facet_bits.member[(_e72 + 2u)];
                    let _e355 = facet_bits.member[(_e72 + 3u)];
                    let _e363 = facet_bits.member[(_e72 + 4u)];
                    let _e371 = facet_bits.member[(_e72 + 5u)];
                    phi_478_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_481_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_483_ = _e323;
                    loop {
                        let _e378 = phi_478_;
                        let _e380 = phi_481_;
                        let _e382 = phi_483_;
                        let _e386 = facets.member[_e382].member_2;
                        let _e390 = (2u * _e382);
                        let _e393 = radiance.member[_e390];
                        let _e397 = radiance.member[(_e390 + 1u)];
                        let _e403 = -((((_e119 * _e386[0]) + (_e121 * _e386[1])) + (_e123 * _e386[2])));
                        if (_e53 == 1u) {
                            let _e456 = sqrt((((_e386[0] * _e386[0]) + (_e386[1] * _e386[1])) + (_e386[2] * _e386[2])));
                            phi_479_ = _e378;
                            phi_482_ = vec4<f32>((_e380.x + (select(_e397.x, _e393.x, (_e393.x > _e397.x)) * _e456)), (_e380.y + (select(_e397.y, _e393.y, (_e393.y > _e397.y)) * _e456)), (_e380.z + (select(_e397.z, _e393.z, (_e393.z > _e397.z)) * _e456)), (_e380.w + _e456));
                        } else {
                            if (_e403 > 0f) {
                                phi_594_ = _e378;
                                phi_595_ = vec4<f32>((_e380.x + (_e393.x * _e403)), (_e380.y + (_e393.y * _e403)), (_e380.z + (_e393.z * _e403)), (_e380.w + _e403));
                            } else {
                                phi_594_ = vec4<f32>((_e378.x - (_e397.x * _e403)), (_e378.y - (_e397.y * _e403)), (_e378.z - (_e397.z * _e403)), (_e378.w - _e403));
                                phi_595_ = _e380;
                            }
                            let _e436 = phi_594_;
                            let _e438 = phi_595_;
                            phi_479_ = _e436;
                            phi_482_ = _e438;
                        }
                        let _e470 = phi_479_;
                        let _e472 = phi_482_;
                        let _e473 = (_e382 + 1u);
                        let _e474 = (_e323 + (((((((_e331 >> bitcast<u32>(_e332)) & 1u) + ((_e339 >> bitcast<u32>(_e332)) & 1u)) + ((_e347 >> bitcast<u32>(_e332)) & 1u)) + ((_e355 >> bitcast<u32>(_e332)) & 1u)) + ((_e363 >> bitcast<u32>(_e332)) & 1u)) + ((_e371 >> bitcast<u32>(_e332)) & 1u)));
                        local_8 = _e470;
                        local_9 = _e472;
                        local_10 = _e470;
                        local_11 = _e470;
                        local_12 = _e470;
                        local_13 = _e472;
                        local_54 = _e472;
                        local_55 = _e474;
                        continue;
                        continuing {
                            phi_478_ = _e470;
                            phi_481_ = _e472;
                            phi_483_ = _e473;
                            break if !(select(true, false, (_e473 >= _e474)));
                        }
                    }
                    let _e479 = local_8;
                    let _e482 = local_9;
                    if (_e479.w > _e482.w) {
                        let _e485 = (_e479.w - _e482.w);
                        let _e486 = (_e485 / _e479.w);
                        let _e488 = local_10;
                        let _e492 = local_11;
                        let _e496 = local_12;
                        let _e501 = local_13;
                        phi_623_ = (_e501 + vec4<f32>((_e488.x * _e486), (_e492.y * _e486), (_e496.z * _e486), _e485));
                    } else {
                        let _e1950 = local_54;
                        phi_623_ = _e1950;
                    }
                    let _e504 = phi_623_;
                    if (_e504.w > 1f) {
                        phi_637_ = vec4<f32>((_e504.x / _e504.w), (_e504.y / _e504.w), (_e504.z / _e504.w), 1f);
                    } else {
                        phi_637_ = _e504;
                    }
                    let _e515 = phi_637_;
                    local[1u] = _e515;
                    let _e1954 = local_55;
                    phi_640_ = _e1954;
                } else {
                    phi_640_ = _e323;
                }
                let _e517 = phi_640_;
                if (((_e71 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    let _e525 = facet_bits.member[_e72];
                    let _e526 = ((_e64 + 2u) & 31u);
                    let _e533 = facet_bits.member[(_e72 + 1u)];
                    let _e541 = facet_bits.member[(_e72 + 2u)];
                    let _e549 = facet_bits.member[(_e72 + 3u)];
                    let _e557 = facet_bits.member[(_e72 + 4u)];
                    let _e565 = facet_bits.member[(_e72 + 5u)];
                    phi_693_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_696_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_698_ = _e517;
                    loop {
                        let _e572 = phi_693_;
                        let _e574 = phi_696_;
                        let _e576 = phi_698_;
                        let _e580 = facets.member[_e576].member_2;
                        let _e584 = (2u * _e576);
                        let _e587 = radiance.member[_e584];
                        let _e591 = radiance.member[(_e584 + 1u)];
                        let _e597 = -((((_e119 * _e580[0]) + (_e121 * _e580[1])) + (_e123 * _e580[2])));
                        if (_e53 == 1u) {
                            let _e650 = sqrt((((_e580[0] * _e580[0]) + (_e580[1] * _e580[1])) + (_e580[2] * _e580[2])));
                            phi_694_ = _e572;
                            phi_697_ = vec4<f32>((_e574.x + (select(_e591.x, _e587.x, (_e587.x > _e591.x)) * _e650)), (_e574.y + (select(_e591.y, _e587.y, (_e587.y > _e591.y)) * _e650)), (_e574.z + (select(_e591.z, _e587.z, (_e587.z > _e591.z)) * _e650)), (_e574.w + _e650));
                        } else {
                            if (_e597 > 0f) {
                                phi_809_ = _e572;
                                phi_810_ = vec4<f32>((_e574.x + (_e587.x * _e597)), (_e574.y + (_e587.y * _e597)), (_e574.z + (_e587.z * _e597)), (_e574.w + _e597));
                            } else {
                                phi_809_ = vec4<f32>((_e572.x - (_e591.x * _e597)), (_e572.y - (_e591.y * _e597)), (_e572.z - (_e591.z * _e597)), (_e572.w - _e597));
                                phi_810_ = _e574;
                            }
                            let _e630 = phi_809_;
                            let _e632 = phi_810_;
                            phi_694_ = _e630;
                            phi_697_ = _e632;
                        }
                        let _e664 = phi_694_;
                        let _e666 = phi_697_;
                        let _e667 = (_e576 + 1u);
                        let _e668 = (_e517 + (((((((_e525 >> bitcast<u32>(_e526)) & 1u) + ((_e533 >> bitcast<u32>(_e526)) & 1u)) + ((_e541 >> bitcast<u32>(_e526)) & 1u)) + ((_e549 >> bitcast<u32>(_e526)) & 1u)) + ((_e557 >> bitcast<u32>(_e526)) & 1u)) + ((_e565 >> bitcast<u32>(_e526)) & 1u)));
                        local_14 = _e664;
                        local_15 = _e666;
                        local_16 = _e664;
                        local_17 = _e664;
                        local_18 = _e664;
                        local_19 = _e666;
                        local_56 = _e666;
                        local_57 = _e668;
                        continue;
                        continuing {
                            phi_693_ = _e664;
                            phi_696_ = _e666;
                            phi_698_ = _e667;
                            break if !(select(true, false, (_e667 >= _e668)));
                        }
                    }
                    let _e673 = local_14;
                    let _e676 = local_15;
                    if (_e673.w > _e676.w) {
                        let _e679 = (_e673.w - _e676.w);
                        let _e680 = (_e679 / _e673.w);
                        let _e682 = local_16;
                        let _e686 = local_17;
                        let _e690 = local_18;
                        let _e695 = local_19;
                        phi_838_ = (_e695 + vec4<f32>((_e682.x * _e680), (_e686.y * _e680), (_e690.z * _e680), _e679));
                    } else {
                        let _e1970 = local_56;
                        phi_838_ = _e1970;
                    }
                    let _e698 = phi_838_;
                    if (_e698.w > 1f) {
                        phi_852_ = vec4<f32>((_e698.x / _e698.w), (_e698.y / _e698.w), (_e698.z / _e698.w), 1f);
                    } else {
                        phi_852_ = _e698;
                    }
                    let _e709 = phi_852_;
                    local[2u] = _e709;
                    let _e1974 = local_57;
                    phi_855_ = _e1974;
                } else {
                    phi_855_ = _e517;
                }
                let _e711 = phi_855_;
                if (((_e71 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    let _e719 = facet_bits.member[_e72];
                    let _e720 = ((_e64 + 3u) & 31u);
                    let _e727 = facet_bits.member[(_e72 + 1u)];
                    let _e735 = facet_bits.member[(_e72 + 2u)];
                    let _e743 = facet_bits.member[(_e72 + 3u)];
                    let _e751 = facet_bits.member[(_e72 + 4u)];
                    let _e759 = facet_bits.member[(_e72 + 5u)];
                    phi_908_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_911_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_913_ = _e711;
                    loop {
                        let _e766 = phi_908_;
                        let _e768 = phi_911_;
                        let _e770 = phi_913_;
                        let _e774 = facets.member[_e770].member_2;
                        let _e778 = (2u * _e770);
                        let _e781 = radiance.member[_e778];
                        let _e785 = radiance.member[(_e778 + 1u)];
                        let _e791 = -((((_e119 * _e774[0]) + (_e121 * _e774[1])) + (_e123 * _e774[2])));
                        if (_e53 == 1u) {
                            let _e844 = sqrt((((_e774[0] * _e774[0]) + (_e774[1] * _e774[1])) + (_e774[2] * _e774[2])));
                            phi_909_ = _e766;
                            phi_912_ = vec4<f32>((_e768.x + (select(_e785.x, _e781.x, (_e781.x > _e785.x)) * _e844)), (_e768.y + (select(_e785.y, _e781.y, (_e781.y > _e785.y)) * _e844)), (_e768.z + (select(_e785.z, _e781.z, (_e781.z > _e785.z)) * _e844)), (_e768.w + _e844));
                        } else {
                            if (_e791 > 0f) {
                                phi_1024_ = _e766;
                                phi_1025_ = vec4<f32>((_e768.x + (_e781.x * _e791)), (_e768.y + (_e781.y * _e791)), (_e768.z + (_e781.z * _e791)), (_e768.w + _e791));
                            } else {
                                phi_1024_ = vec4<f32>((_e766.x - (_e785.x * _e791)), (_e766.y - (_e785.y * _e791)), (_e766.z - (_e785.z * _e791)), (_e766.w - _e791));
                                phi_1025_ = _e768;
                            }
                            let _e824 = phi_1024_;
                            let _e826 = phi_1025_;
                            phi_909_ = _e824;
                            phi_912_ = _e826;
                        }
                        let _e858 = phi_909_;
                        let _e860 = phi_912_;
                        let _e861 = (_e770 + 1u);
                        let _e862 = (_e711 + (((((((_e719 >> bitcast<u32>(_e720)) & 1u) + ((_e727 >> bitcast<u32>(_e720)) & 1u)) + ((_e735 >> bitcast<u32>(_e720)) & 1u)) + ((_e743 >> bitcast<u32>(_e720)) & 1u)) + ((_e751 >> bitcast<u32>(_e720)) & 1u)) + ((_e759 >> bitcast<u32>(_e720)) & 1u)));
                        local_20 = _e858;
                        local_21 = _e860;
                        local_22 = _e858;
                        local_23 = _e858;
                        local_24 = _e858;
                        local_25 = _e860;
                        local_58 = _e860;
                        local_59 = _e862;
                        continue;
                        continuing {
                            phi_908_ = _e858;
                            phi_911_ = _e860;
                            phi_913_ = _e861;
                            break if !(select(true, false, (_e861 >= _e862)));
                        }
                    }
                    let _e867 = local_20;
                    let _e870 = local_21;
                    if (_e867.w > _e870.w) {
                        let _e873 = (_e867.w - _e870.w);
                        let _e874 = (_e873 / _e867.w);
                        let _e876 = local_22;
                        let _e880 = local_23;
                        let _e884 = local_24;
                        let _e889 = local_25;
                        phi_1053_ = (_e889 + vec4<f32>((_e876.x * _e874), (_e880.y * _e874), (_e884.z * _e874), _e873));
                    } else {
                        let _e1990 = local_58;
                        phi_1053_ = _e1990;
                    }
                    let _e892 = phi_1053_;
                    if (_e892.w > 1f) {
                        phi_1067_ = vec4<f32>((_e892.x / _e892.w), (_e892.y / _e892.w), (_e892.z / _e892.w), 1f);
                    } else {
                        phi_1067_ = _e892;
                    }
                    let _e903 = phi_1067_;
                    local[3u] = _e903;
                    let _e1994 = local_59;
                    phi_1070_ = _e1994;
                } else {
                    phi_1070_ = _e711;
                }
                let _e905 = phi_1070_;
                if (((_e71 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    let _e913 = facet_bits.member[_e72];
                    let _e914 = ((_e64 + 4u) & 31u);
                    let _e921 = facet_bits.member[(_e72 + 1u)];
                    let _e929 = facet_bits.member[(_e72 + 2u)];
                    let _e937 = facet_bits.member[(_e72 + 3u)];
                    let _e945 = facet_bits.member[(_e72 + 4u)];
                    let _e953 = facet_bits.member[(_e72 + 5u)];
                    phi_1123_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1126_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1128_ = _e905;
                    loop {
                        let _e960 = phi_1123_;
                        let _e962 = phi_1126_;
                        let _e964 = phi_1128_;
                        let _e968 = facets.member[_e964].member_2;
                        let _e972 = (2u * _e964);
                        let _e975 = radiance.member[_e972];
                        let _e979 = radiance.member[(_e972 + 1u)];
                        let _e985 = -((((_e119 * _e968[0]) + (_e121 * _e968[1])) + (_e123 * _e968[2])));
                        if (_e53 == 1u) {
                            let _e1038 = sqrt((((_e968[0] * _e968[0]) + (_e968[1] * _e968[1])) + (_e968[2] * _e968[2])));
                            phi_1124_ = _e960;
                            phi_1127_ = vec4<f32>((_e962.x + (select(_e979.x, _e975.x, (_e975.x > _e979.x)) * _e1038)), (_e962.y + (select(_e979.y, _e975.y, (_e975.y > _e979.y)) * _e1038)), (_e962.z + (select(_e979.z, _e975.z, (_e975.z > _e979.z)) * _e1038)), (_e962.w + _e1038));
                        } else {
                            if (_e985 > 0f) {
                                phi_1239_ = _e960;
                                phi_1240_ = vec4<f32>((_e962.x + (_e975.x * _e985)), (_e962.y + (_e975.y * _e985)), (_e962.z + (_e975.z * _e985)), (_e962.w + _e985));
                            } else {
                                phi_1239_ = vec4<f32>((_e960.x - (_e979.x * _e985)), (_e960.y - (_e979.y * _e985)), (_e960.z - (_e979.z * _e985)), (_e960.w - _e985));
                                phi_1240_ = _e962;
                            }
                            let _e1018 = phi_1239_;
                            let _e1020 = phi_1240_;
                            phi_1124_ = _e1018;
                            phi_1127_ = _e1020;
                        }
                        let _e1052 = phi_1124_;
                        let _e1054 = phi_1127_;
                        let _e1055 = (_e964 + 1u);
                        let _e1056 = (_e905 + (((((((_e913 >> bitcast<u32>(_e914)) & 1u) + ((_e921 >> bitcast<u32>(_e914)) & 1u)) + ((_e929 >> bitcast<u32>(_e914)) & 1u)) + ((_e937 >> bitcast<u32>(_e914)) & 1u)) + ((_e945 >> bitcast<u32>(_e914)) & 1u)) + ((_e953 >> bitcast<u32>(_e914)) & 1u)));
                        local_26 = _e1052;
                        local_27 = _e1054;
                        local_28 = _e1052;
                        local_29 = _e1052;
                        local_30 = _e1052;
                        local_31 = _e1054;
                        local_60 = _e1054;
                        local_61 = _e1056;
                        continue;
                        continuing {
                            phi_1123_ = _e1052;
                            phi_1126_ = _e1054;
                            phi_1128_ = _e1055;
                            break if !(select(true, false, (_e1055 >= _e1056)));
                        }
                    }
                    let _e1061 = local_26;
                    let _e1064 = local_27;
                    if (_e1061.w > _e1064.w) {
                        let _e1067 = (_e1061.w - _e1064.w);
                        let _e1068 = (_e1067 / _e1061.w);
                        let _e1070 = local_28;
                        let _e1074 = local_29;
                        let _e1078 = local_30;
                        let _e1083 = local_31;
                        phi_1268_ = (_e1083 + vec4<f32>((_e1070.x * _e1068), (_e1074.y * _e1068), (_e1078.z * _e1068), _e1067));
                    } else {
                        let _e2010 = local_60;
                        phi_1268_ = _e2010;
                    }
                    let _e1086 = phi_1268_;
                    if (_e1086.w > 1f) {
                        phi_1282_ = vec4<f32>((_e1086.x / _e1086.w), (_e1086.y / _e1086.w), (_e1086.z / _e1086.w), 1f);
                    } else {
                        phi_1282_ = _e1086;
                    }
                    let _e1097 = phi_1282_;
                    local[4u] = _e1097;
                    let _e2014 = local_61;
                    phi_1285_ = _e2014;
                } else {
                    phi_1285_ = _e905;
                }
                let _e1099 = phi_1285_;
                if (((_e71 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    let _e1107 = facet_bits.member[_e72];
                    let _e1108 = ((_e64 + 5u) & 31u);
                    let _e1115 = facet_bits.member[(_e72 + 1u)];
                    let _e1123 = facet_bits.member[(_e72 + 2u)];
                    let _e1131 = facet_bits.member[(_e72 + 3u)];
                    let _e1139 = facet_bits.member[(_e72 + 4u)];
                    let _e1147 = facet_bits.member[(_e72 + 5u)];
                    phi_1338_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1341_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1343_ = _e1099;
                    loop {
                        let _e1154 = phi_1338_;
                        let _e1156 = phi_1341_;
                        let _e1158 = phi_1343_;
                        let _e1162 = facets.member[_e1158].member_2;
                        let _e1166 = (2u * _e1158);
                        let _e1169 = radiance.member[_e1166];
                        let _e1173 = radiance.member[(_e1166 + 1u)];
                        let _e1179 = -((((_e119 * _e1162[0]) + (_e121 * _e1162[1])) + (_e123 * _e1162[2])));
                        if (_e53 == 1u) {
                            let _e1232 = sqrt((((_e1162[0] * _e1162[0]) + (_e1162[1] * _e1162[1])) + (_e1162[2] * _e1162[2])));
                            phi_1339_ = _e1154;
                            phi_1342_ = vec4<f32>((_e1156.x + (select(_e1173.x, _e1169.x, (_e1169.x > _e1173.x)) * _e1232)), (_e1156.y + (select(_e1173.y, _e1169.y, (_e1169.y > _e1173.y)) * _e1232)), (_e1156.z + (select(_e1173.z, _e1169.z, (_e1169.z > _e1173.z)) * _e1232)), (_e1156.w + _e1232));
                        } else {
                            if (_e1179 > 0f) {
                                phi_1454_ = _e1154;
                                phi_1455_ = vec4<f32>((_e1156.x + (_e1169.x * _e1179)), (_e1156.y + (_e1169.y * _e1179)), (_e1156.z + (_e1169.z * _e1179)), (_e1156.w + _e1179));
                            } else {
                                phi_1454_ = vec4<f32>((_e1154.x - (_e1173.x * _e1179)), (_e1154.y - (_e1173.y * _e1179)), (_e1154.z - (_e1173.z * _e1179)), (_e1154.w - _e1179));
                                phi_1455_ = _e1156;
                            }
                            let _e1212 = phi_1454_;
                            let _e1214 = phi_1455_;
                            phi_1339_ = _e1212;
                            phi_1342_ = _e1214;
                        }
                        let _e1246 = phi_1339_;
                        let _e1248 = phi_1342_;
                        let _e1249 = (_e1158 + 1u);
                        let _e1250 = (_e1099 + (((((((_e1107 >> bitcast<u32>(_e1108)) & 1u) + ((_e1115 >> bitcast<u32>(_e1108)) & 1u)) + ((_e1123 >> bitcast<u32>(_e1108)) & 1u)) + ((_e1131 >> bitcast<u32>(_e1108)) & 1u)) + ((_e1139 >> bitcast<u32>(_e1108)) & 1u)) + ((_e1147 >> bitcast<u32>(_e1108)) & 1u)));
                        local_32 = _e1246;
                        local_33 = _e1248;
                        local_34 = _e1246;
                        local_35 = _e1246;
                        local_36 = _e1246;
                        local_37 = _e1248;
                        local_62 = _e1248;
                        local_63 = _e1250;
                        continue;
                        continuing {
                            phi_1338_ = _e1246;
                            phi_1341_ = _e1248;
                            phi_1343_ = _e1249;
                            break if !(select(true, false, (_e1249 >= _e1250)));
                        }
                    }
                    let _e1255 = local_32;
                    let _e1258 = local_33;
                    if (_e1255.w > _e1258.w) {
                        let _e1261 = (_e1255.w - _e1258.w);
                        let _e1262 = (_e1261 / _e1255.w);
                        let _e1264 = local_34;
                        let _e1268 = local_35;
                        let _e1272 = local_36;
                        let _e1277 = local_37;
                        phi_1483_ = (_e1277 + vec4<f32>((_e1264.x * _e1262), (_e1268.y * _e1262), (_e1272.z * _e1262), _e1261));
                    } else {
                        let _e2030 = local_62;
                        phi_1483_ = _e2030;
                    }
                    let _e1280 = phi_1483_;
                    if (_e1280.w > 1f) {
                        phi_1497_ = vec4<f32>((_e1280.x / _e1280.w), (_e1280.y / _e1280.w), (_e1280.z / _e1280.w), 1f);
                    } else {
                        phi_1497_ = _e1280;
                    }
                    let _e1291 = phi_1497_;
                    local[5u] = _e1291;
                    let _e2034 = local_63;
                    phi_1500_ = _e2034;
                } else {
                    phi_1500_ = _e1099;
                }
                let _e1293 = phi_1500_;
                if (((_e71 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    let _e1301 = facet_bits.member[_e72];
                    let _e1302 = ((_e64 + 6u) & 31u);
                    let _e1309 = facet_bits.member[(_e72 + 1u)];
                    let _e1317 = facet_bits.member[(_e72 + 2u)];
                    let _e1325 = facet_bits.member[(_e72 + 3u)];
                    let _e1333 = facet_bits.member[(_e72 + 4u)];
                    let _e1341 = facet_bits.member[(_e72 + 5u)];
                    phi_1553_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1556_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1558_ = _e1293;
                    loop {
                        let _e1348 = phi_1553_;
                        let _e1350 = phi_1556_;
                        let _e1352 = phi_1558_;
                        let _e1356 = facets.member[_e1352].member_2;
                        let _e1360 = (2u * _e1352);
                        let _e1363 = radiance.member[_e1360];
                        let _e1367 = radiance.member[(_e1360 + 1u)];
                        let _e1373 = -((((_e119 * _e1356[0]) + (_e121 * _e1356[1])) + (_e123 * _e1356[2])));
                        if (_e53 == 1u) {
                            let _e1426 = sqrt((((_e1356[0] * _e1356[0]) + (_e1356[1] * _e1356[1])) + (_e1356[2] * _e1356[2])));
                            phi_1554_ = _e1348;
                            phi_1557_ = vec4<f32>((_e1350.x + (select(_e1367.x, _e1363.x, (_e1363.x > _e1367.x)) * _e1426)), (_e1350.y + (select(_e1367.y, _e1363.y, (_e1363.y > _e1367.y)) * _e1426)), (_e1350.z + (select(_e1367.z, _e1363.z, (_e1363.z > _e1367.z)) * _e1426)), (_e1350.w + _e1426));
                        } else {
                            if (_e1373 > 0f) {
                                phi_1669_ = _e1348;
                                phi_1670_ = vec4<f32>((_e1350.x + (_e1363.x * _e1373)), (_e1350.y + (_e1363.y * _e1373)), (_e1350.z + (_e1363.z * _e1373)), (_e1350.w + _e1373));
                            } else {
                                phi_1669_ = vec4<f32>((_e1348.x - (_e1367.x * _e1373)), (_e1348.y - (_e1367.y * _e1373)), (_e1348.z - (_e1367.z * _e1373)), (_e1348.w - _e1373));
                                phi_1670_ = _e1350;
                            }
                            let _e1406 = phi_1669_;
                            let _e1408 = phi_1670_;
                            phi_1554_ = _e1406;
                            phi_1557_ = _e1408;
                        }
                        let _e1440 = phi_1554_;
                        let _e1442 = phi_1557_;
                        let _e1443 = (_e1352 + 1u);
                        let _e1444 = (_e1293 + (((((((_e1301 >> bitcast<u32>(_e1302)) & 1u) + ((_e1309 >> bitcast<u32>(_e1302)) & 1u)) + ((_e1317 >> bitcast<u32>(_e1302)) & 1u)) + ((_e1325 >> bitcast<u32>(_e1302)) & 1u)) + ((_e1333 >> bitcast<u32>(_e1302)) & 1u)) + ((_e1341 >> bitcast<u32>(_e1302)) & 1u)));
                        local_38 = _e1440;
                        local_39 = _e1442;
                        local_40 = _e1440;
                        local_41 = _e1440;
                        local_42 = _e1440;
                        local_43 = _e1442;
                        local_64 = _e1442;
                        local_65 = _e1444;
                        continue;
                        continuing {
                            phi_1553_ = _e1440;
                            phi_1556_ = _e1442;
                            phi_1558_ = _e1443;
                            break if !(select(true, false, (_e1443 >= _e1444)));
                        }
                    }
                    let _e1449 = local_38;
                    let _e1452 = local_39;
                    if (_e1449.w > _e1452.w) {
                        let _e1455 = (_e1449.w - _e1452.w);
                        let _e1456 = (_e1455 / _e1449.w);
                        let _e1458 = local_40;
                        let _e1462 = local_41;
                        let _e1466 = local_42;
                        let _e1471 = local_43;
                        phi_1698_ = (_e1471 + vec4<f32>((_e1458.x * _e1456), (_e1462.y * _e1456), (_e1466.z * _e1456), _e1455));
                    } else {
                        let _e2050 = local_64;
                        phi_1698_ = _e2050;
                    }
                    let _e1474 = phi_1698_;
                    if (_e1474.w > 1f) {
                        phi_1712_ = vec4<f32>((_e1474.x / _e1474.w), (_e1474.y / _e1474.w), (_e1474.z / _e1474.w), 1f);
                    } else {
                        phi_1712_ = _e1474;
                    }
                    let _e1485 = phi_1712_;
                    local[6u] = _e1485;
                    let _e2054 = local_65;
                    phi_1715_ = _e2054;
                } else {
                    phi_1715_ = _e1293;
                }
                let _e1487 = phi_1715_;
                if (((_e71 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    let _e1495 = facet_bits.member[_e72];
                    let _e1496 = ((_e64 + 7u) & 31u);
                    let _e1503 = facet_bits.member[(_e72 + 1u)];
                    let _e1511 = facet_bits.member[(_e72 + 2u)];
                    let _e1519 = facet_bits.member[(_e72 + 3u)];
                    let _e1527 = facet_bits.member[(_e72 + 4u)];
                    let _e1535 = facet_bits.member[(_e72 + 5u)];
                    phi_1768_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1771_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1773_ = _e1487;
                    loop {
                        let _e1542 = phi_1768_;
                        let _e1544 = phi_1771_;
                        let _e1546 = phi_1773_;
                        let _e1550 = facets.member[_e1546].member_2;
                        let _e1554 = (2u * _e1546);
                        let _e1557 = radiance.member[_e1554];
                        let _e1561 = radiance.member[(_e1554 + 1u)];
                        let _e1567 = -((((_e119 * _e1550[0]) + (_e121 * _e1550[1])) + (_e123 * _e1550[2])));
                        if (_e53 == 1u) {
                            let _e1620 = sqrt((((_e1550[0] * _e1550[0]) + (_e1550[1] * _e1550[1])) + (_e1550[2] * _e1550[2])));
                            phi_1769_ = _e1542;
                            phi_1772_ = vec4<f32>((_e1544.x + (select(_e1561.x, _e1557.x, (_e1557.x > _e1561.x)) * _e1620)), (_e1544.y + (select(_e1561.y, _e1557.y, (_e1557.y > _e1561.y)) * _e1620)), (_e1544.z + (select(_e1561.z, _e1557.z, (_e1557.z > _e1561.z)) * _e1620)), (_e1544.w + _e1620));
                        } else {
                            if (_e1567 > 0f) {
                                phi_1884_ = _e1542;
                                phi_1885_ = vec4<f32>((_e1544.x + (_e1557.x * _e1567)), (_e1544.y + (_e1557.y * _e1567)), (_e1544.z + (_e1557.z * _e1567)), (_e1544.w + _e1567));
                            } else {
                                phi_1884_ = vec4<f32>((_e1542.x - (_e1561.x * _e1567)), (_e1542.y - (_e1561.y * _e1567)), (_e1542.z - (_e1561.z * _e1567)), (_e1542.w - _e1567));
                                phi_1885_ = _e1544;
                            }
                            let _e1600 = phi_1884_;
                            let _e1602 = phi_1885_;
                            phi_1769_ = _e1600;
                            phi_1772_ = _e1602;
                        }
                        let _e1634 = phi_1769_;
                        let _e1636 = phi_1772_;
                        let _e1637 = (_e1546 + 1u);
                        local_44 = _e1634;
                        local_45 = _e1636;
                        local_46 = _e1634;
                        local_47 = _e1634;
                        local_48 = _e1634;
                        local_49 = _e1636;
                        local_66 = _e1636;
                        continue;
                        continuing {
                            phi_1768_ = _e1634;
                            phi_1771_ = _e1636;
                            phi_1773_ = _e1637;
                            break if !(select(true, false, (_e1637 >= (_e1487 + (((((((_e1495 >> bitcast<u32>(_e1496)) & 1u) + ((_e1503 >> bitcast<u32>(_e1496)) & 1u)) + ((_e1511 >> bitcast<u32>(_e1496)) & 1u)) + ((_e1519 >> bitcast<u32>(_e1496)) & 1u)) + ((_e1527 >> bitcast<u32>(_e1496)) & 1u)) + ((_e1535 >> bitcast<u32>(_e1496)) & 1u))))));
                        }
                    }
                    let _e1643 = local_44;
                    let _e1646 = local_45;
                    if (_e1643.w > _e1646.w) {
                        let _e1649 = (_e1643.w - _e1646.w);
                        let _e1650 = (_e1649 / _e1643.w);
                        let _e1652 = local_46;
                        let _e1656 = local_47;
                        let _e1660 = local_48;
                        let _e1665 = local_49;
                        phi_1913_ = (_e1665 + vec4<f32>((_e1652.x * _e1650), (_e1656.y * _e1650), (_e1660.z * _e1650), _e1649));
                    } else {
                        let _e2070 = local_66;
                        phi_1913_ = _e2070;
                    }
                    let _e1668 = phi_1913_;
                    if (_e1668.w > 1f) {
                        phi_1927_ = vec4<f32>((_e1668.x / _e1668.w), (_e1668.y / _e1668.w), (_e1668.z / _e1668.w), 1f);
                    } else {
                        phi_1927_ = _e1668;
                    }
                    let _e1679 = phi_1927_;
                    local[7u] = _e1679;
                }
                if (_e53 == 1u) {
                    let _e1816 = local[0u];
                    let _e1817 = local[1u];
                    let _e1830 = local[2u];
                    let _e1831 = local[3u];
                    let _e1848 = local[4u];
                    let _e1849 = local[5u];
                    let _e1862 = local[6u];
                    let _e1863 = local[7u];
                    let _e1884 = ((((_e1816.x + _e1817.x) + (_e1830.x + _e1831.x)) + ((_e1848.x + _e1849.x) + (_e1862.x + _e1863.x))) * 0.25f);
                    let _e1885 = ((((_e1816.y + _e1817.y) + (_e1830.y + _e1831.y)) + ((_e1848.y + _e1849.y) + (_e1862.y + _e1863.y))) * 0.25f);
                    let _e1886 = ((((_e1816.z + _e1817.z) + (_e1830.z + _e1831.z)) + ((_e1848.z + _e1849.z) + (_e1862.z + _e1863.z))) * 0.25f);
                    let _e1887 = ((((_e1816.w + _e1817.w) + (_e1830.w + _e1831.w)) + ((_e1848.w + _e1849.w) + (_e1862.w + _e1863.w))) * 0.25f);
                    if (_e1887 > 1f) {
                        phi_2025_ = vec4<f32>((_e1884 / _e1887), (_e1885 / _e1887), (_e1886 / _e1887), (_e1887 / _e1887));
                    } else {
                        phi_2025_ = vec4<f32>(_e1884, _e1885, _e1886, _e1887);
                    }
                    let _e1896 = phi_2025_;
                    phi_2227_ = _e1896;
                } else {
                    let _e1683 = (1u << bitcast<u32>((_e114 & 31u)));
                    let _e1684 = select(1u, 2u, _e118);
                    let _e1685 = select(4u, 2u, _e122);
                    let _e1686 = select(0u, _e1683, _e116);
                    let _e1687 = select(_e1683, 0u, _e116);
                    if (_e1686 < 8u) {
                    } else {
                        break;
                    }
                    let _e1690 = local[_e1686];
                    if (_e1687 < 8u) {
                    } else {
                        break;
                    }
                    let _e1693 = local[_e1687];
                    let _e1695 = (1f - _e1690.w);
                    if (_e1693.w <= _e1695) {
                        phi_2080_ = (_e1690 + _e1693);
                    } else {
                        let _e1698 = (_e1695 / _e1693.w);
                        phi_2080_ = (_e1690 + vec4<f32>((_e1693.x * _e1698), (_e1693.y * _e1698), (_e1693.z * _e1698), _e1695));
                    }
                    let _e1709 = phi_2080_;
                    let _e1710 = (_e1684 + _e1686);
                    if (_e1710 < 8u) {
                    } else {
                        break;
                    }
                    let _e1713 = local[_e1710];
                    let _e1714 = (_e1684 + _e1687);
                    if (_e1714 < 8u) {
                    } else {
                        break;
                    }
                    let _e1717 = local[_e1714];
                    let _e1719 = (1f - _e1713.w);
                    if (_e1717.w <= _e1719) {
                        phi_2117_ = (_e1713 + _e1717);
                    } else {
                        let _e1722 = (_e1719 / _e1717.w);
                        phi_2117_ = (_e1713 + vec4<f32>((_e1717.x * _e1722), (_e1717.y * _e1722), (_e1717.z * _e1722), _e1719));
                    }
                    let _e1733 = phi_2117_;
                    let _e1746 = (_e1685 + _e1686);
                    if (_e1746 < 8u) {
                    } else {
                        break;
                    }
                    let _e1749 = local[_e1746];
                    let _e1750 = (_e1685 + _e1687);
                    if (_e1750 < 8u) {
                    } else {
                        break;
                    }
                    let _e1753 = local[_e1750];
                    let _e1755 = (1f - _e1749.w);
                    if (_e1753.w <= _e1755) {
                        phi_2166_ = (_e1749 + _e1753);
                    } else {
                        let _e1758 = (_e1755 / _e1753.w);
                        phi_2166_ = (_e1749 + vec4<f32>((_e1753.x * _e1758), (_e1753.y * _e1758), (_e1753.z * _e1758), _e1755));
                    }
                    let _e1769 = phi_2166_;
                    let _e1778 = (_e1684 + _e1685);
                    let _e1779 = (_e1778 + _e1686);
                    if (_e1779 < 8u) {
                    } else {
                        break;
                    }
                    let _e1782 = local[_e1779];
                    let _e1783 = (_e1778 + _e1687);
                    if (_e1783 < 8u) {
                    } else {
                        break;
                    }
                    let _e1786 = local[_e1783];
                    let _e1788 = (1f - _e1782.w);
                    if (_e1786.w <= _e1788) {
                        phi_2213_ = (_e1782 + _e1786);
                    } else {
                        let _e1791 = (_e1788 / _e1786.w);
                        phi_2213_ = (_e1782 + vec4<f32>((_e1786.x * _e1791), (_e1786.y * _e1791), (_e1786.z * _e1791), _e1788));
                    }
                    let _e1802 = phi_2213_;
                    phi_2227_ = vec4<f32>(((((_e1709.x + _e1733.x) + _e1769.x) + _e1802.x) * 0.25f), ((((_e1709.y + _e1733.y) + _e1769.y) + _e1802.y) * 0.25f), ((((_e1709.z + _e1733.z) + _e1769.z) + _e1802.z) * 0.25f), ((((_e1709.w + _e1733.w) + _e1769.w) + _e1802.w) * 0.25f));
                }
                let _e1898 = phi_2227_;
                let _e1901 = ((_e42 + _e49) + (_e49 - _e49));
                if (_e1901 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e1901] = _e1898;
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
