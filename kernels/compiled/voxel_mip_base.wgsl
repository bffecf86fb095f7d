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
    var phi_130_: type_7;
    var phi_133_: u32;
    var phi_131_: type_7;
    var phi_156_: type_7;
    var phi_134_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_370_: type_7;
    var phi_373_: vec4<f32>;
    var phi_375_: vec4<f32>;
    var phi_371_: type_7;
    var phi_398_: type_7;
    var phi_467_: vec4<f32>;
    var phi_468_: vec4<f32>;
    var phi_374_: vec4<f32>;
    var phi_376_: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var phi_490_: vec4<f32>;
    var local_9: u32;
    var local_10: u32;
    var phi_269_: type_7;
    var phi_272_: vec4<f32>;
    var phi_270_: type_7;
    var phi_295_: type_7;
    var phi_273_: vec4<f32>;
    var phi_491_: vec4<f32>;
    var phi_505_: vec4<f32>;
    var local_11: u32;
    var phi_508_: u32;
    var phi_667_: type_7;
    var phi_670_: vec4<f32>;
    var phi_672_: vec4<f32>;
    var phi_668_: type_7;
    var phi_695_: type_7;
    var phi_764_: vec4<f32>;
    var phi_765_: vec4<f32>;
    var phi_671_: vec4<f32>;
    var phi_673_: vec4<f32>;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var phi_787_: vec4<f32>;
    var phi_566_: type_7;
    var phi_569_: vec4<f32>;
    var phi_567_: type_7;
    var phi_592_: type_7;
    var phi_570_: vec4<f32>;
    var phi_788_: vec4<f32>;
    var phi_802_: vec4<f32>;
    var phi_805_: u32;
    var phi_964_: type_7;
    var phi_967_: vec4<f32>;
    var phi_969_: vec4<f32>;
    var phi_965_: type_7;
    var phi_992_: type_7;
    var phi_1061_: vec4<f32>;
    var phi_1062_: vec4<f32>;
    var phi_968_: vec4<f32>;
    var phi_970_: vec4<f32>;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: vec4<f32>;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var phi_1084_: vec4<f32>;
    var phi_863_: type_7;
    var phi_866_: vec4<f32>;
    var phi_864_: type_7;
    var phi_889_: type_7;
    var phi_867_: vec4<f32>;
    var phi_1085_: vec4<f32>;
    var phi_1099_: vec4<f32>;
    var phi_1102_: u32;
    var phi_1261_: type_7;
    var phi_1264_: vec4<f32>;
    var phi_1266_: vec4<f32>;
    var phi_1262_: type_7;
    var phi_1289_: type_7;
    var phi_1358_: vec4<f32>;
    var phi_1359_: vec4<f32>;
    var phi_1265_: vec4<f32>;
    var phi_1267_: vec4<f32>;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var local_28: vec4<f32>;
    var local_29: vec4<f32>;
    var phi_1381_: vec4<f32>;
    var phi_1160_: type_7;
    var phi_1163_: vec4<f32>;
    var phi_1161_: type_7;
    var phi_1186_: type_7;
    var phi_1164_: vec4<f32>;
    var phi_1382_: vec4<f32>;
    var phi_1396_: vec4<f32>;
    var phi_1399_: u32;
    var phi_1558_: type_7;
    var phi_1561_: vec4<f32>;
    var phi_1563_: vec4<f32>;
    var phi_1559_: type_7;
    var phi_1586_: type_7;
    var phi_1655_: vec4<f32>;
    var phi_1656_: vec4<f32>;
    var phi_1562_: vec4<f32>;
    var phi_1564_: vec4<f32>;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var phi_1678_: vec4<f32>;
    var phi_1457_: type_7;
    var phi_1460_: vec4<f32>;
    var phi_1458_: type_7;
    var phi_1483_: type_7;
    var phi_1461_: vec4<f32>;
    var phi_1679_: vec4<f32>;
    var phi_1693_: vec4<f32>;
    var phi_1696_: u32;
    var phi_1855_: type_7;
    var phi_1858_: vec4<f32>;
    var phi_1860_: vec4<f32>;
    var phi_1856_: type_7;
    var phi_1883_: type_7;
    var phi_1952_: vec4<f32>;
    var phi_1953_: vec4<f32>;
    var phi_1859_: vec4<f32>;
    var phi_1861_: vec4<f32>;
    var local_36: vec4<f32>;
    var local_37: vec4<f32>;
    var local_38: vec4<f32>;
    var local_39: vec4<f32>;
    var local_40: vec4<f32>;
    var local_41: vec4<f32>;
    var phi_1975_: vec4<f32>;
    var phi_1754_: type_7;
    var phi_1757_: vec4<f32>;
    var phi_1755_: type_7;
    var phi_1780_: type_7;
    var phi_1758_: vec4<f32>;
    var phi_1976_: vec4<f32>;
    var phi_1990_: vec4<f32>;
    var phi_1993_: u32;
    var phi_2152_: type_7;
    var phi_2155_: vec4<f32>;
    var phi_2157_: vec4<f32>;
    var phi_2153_: type_7;
    var phi_2180_: type_7;
    var phi_2249_: vec4<f32>;
    var phi_2250_: vec4<f32>;
    var phi_2156_: vec4<f32>;
    var phi_2158_: vec4<f32>;
    var local_42: vec4<f32>;
    var local_43: vec4<f32>;
    var local_44: vec4<f32>;
    var local_45: vec4<f32>;
    var local_46: vec4<f32>;
    var local_47: vec4<f32>;
    var phi_2272_: vec4<f32>;
    var phi_2051_: type_7;
    var phi_2054_: vec4<f32>;
    var phi_2052_: type_7;
    var phi_2077_: type_7;
    var phi_2055_: vec4<f32>;
    var phi_2273_: vec4<f32>;
    var phi_2287_: vec4<f32>;
    var phi_2290_: u32;
    var phi_2449_: type_7;
    var phi_2452_: vec4<f32>;
    var phi_2454_: vec4<f32>;
    var phi_2450_: type_7;
    var phi_2477_: type_7;
    var phi_2546_: vec4<f32>;
    var phi_2547_: vec4<f32>;
    var phi_2453_: vec4<f32>;
    var phi_2455_: vec4<f32>;
    var local_48: vec4<f32>;
    var local_49: vec4<f32>;
    var local_50: vec4<f32>;
    var local_51: vec4<f32>;
    var local_52: vec4<f32>;
    var local_53: vec4<f32>;
    var phi_2569_: vec4<f32>;
    var phi_2348_: type_7;
    var phi_2351_: vec4<f32>;
    var phi_2349_: type_7;
    var phi_2374_: type_7;
    var phi_2352_: vec4<f32>;
    var phi_2570_: vec4<f32>;
    var phi_2584_: vec4<f32>;
    var phi_2737_: vec4<f32>;
    var phi_2774_: vec4<f32>;
    var phi_2823_: vec4<f32>;
    var phi_2870_: vec4<f32>;
    var phi_2682_: vec4<f32>;
    var phi_2884_: vec4<f32>;
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
            let _e36 = gid_1;
            let _e41 = params.member.member_12;
            let _e44 = params.member.member_13;
            let _e48 = (_e36.x + (_e36.y * 2097152u));
            if (_e48 < _e44) {
                let _e52 = params.member.member_6;
                if (_e52 == 0u) {
                    break;
                }
                let _e54 = (_e48 / _e52);
                let _e56 = (_e48 - (_e54 * _e52));
                let _e59 = children.member[_e54];
                let _e61 = (_e59 >> bitcast<u32>(2i));
                let _e63 = (8u * (_e59 & 3u));
                let _e64 = (2u * _e61);
                let _e67 = cells.member[_e64];
                let _e68 = (_e63 & 31u);
                let _e70 = (_e67 >> bitcast<u32>(_e68));
                let _e71 = (_e61 * 6u);
                let _e75 = cells.member[(_e64 + 1u)];
                phi_130_ = type_7(0u, 6u);
                phi_133_ = _e75;
                loop {
                    let _e77 = phi_130_;
                    let _e79 = phi_133_;
                    local_1 = _e79;
                    local_2 = _e79;
                    local_9 = _e79;
                    local_10 = _e79;
                    local_11 = _e79;
                    local_56 = _e79;
                    if (_e77.member < _e77.member_1) {
                        phi_131_ = type_7((_e77.member + 1u), _e77.member_1);
                        phi_156_ = type_7(1u, _e77.member);
                    } else {
                        phi_131_ = _e77;
                        phi_156_ = type_7(0u, type_7().member_1);
                    }
                    let _e92 = phi_131_;
                    let _e94 = phi_156_;
                    let _e98 = (bitcast<i32>(_e94.member) != 0i);
                    if _e98 {
                        let _e102 = facet_bits.member[(_e71 + _e94.member_1)];
                        phi_134_ = (_e79 + countOneBits((_e102 & ((1u << bitcast<u32>(_e68)) - 1u))));
                    } else {
                        phi_134_ = u32();
                    }
                    let _e110 = phi_134_;
                    continue;
                    continuing {
                        phi_130_ = _e92;
                        phi_133_ = _e110;
                        break if !(_e98);
                    }
                }
                let _e113 = (_e56 >> bitcast<u32>(1i));
                let _e115 = ((_e56 & 1u) == 1u);
                let _e116 = select(1f, -1f, _e115);
                let _e117 = (_e113 == 0u);
                let _e118 = select(0f, _e116, _e117);
                let _e120 = select(0f, _e116, (_e113 == 1u));
                let _e121 = (_e113 == 2u);
                let _e122 = select(0f, _e116, _e121);
                local[0u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[1u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[2u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[3u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[4u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[5u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[6u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[7u] = vec4<f32>(0f, 0f, 0f, 0f);
                if ((_e70 & 1u) == 1u) {
                    let _e135 = facet_bits.member[_e71];
                    let _e142 = facet_bits.member[(_e71 + 1u)];
                    let _e150 = facet_bits.member[(_e71 + 2u)];
                    let _e158 = facet_bits.member[(_e71 + 3u)];
                    let _e166 = facet_bits.member[(_e71 + 4u)];
                    let _e174 = facet_bits.member[(_e71 + 5u)];
                    let _e178 = (((((((_e135 >> bitcast<u32>(_e68)) & 1u) + ((_e142 >> bitcast<u32>(_e68)) & 1u)) + ((_e150 >> bitcast<u32>(_e68)) & 1u)) + ((_e158 >> bitcast<u32>(_e68)) & 1u)) + ((_e166 >> bitcast<u32>(_e68)) & 1u)) + ((_e174 >> bitcast<u32>(_e68)) & 1u));
                    if (_e52 == 1u) {
                        let _e301 = local_9;
                        let _e304 = local_10;
                        phi_269_ = type_7(_e304, (_e301 + _e178));
                        phi_272_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e307 = phi_269_;
                            let _e309 = phi_272_;
                            local_55 = _e309;
                            if (_e307.member < _e307.member_1) {
                                phi_270_ = type_7((_e307.member + 1u), _e307.member_1);
                                phi_295_ = type_7(1u, _e307.member);
                            } else {
                                phi_270_ = _e307;
                                phi_295_ = type_7(0u, type_7().member_1);
                            }
                            let _e322 = phi_270_;
                            let _e324 = phi_295_;
                            let _e328 = (bitcast<i32>(_e324.member) != 0i);
                            if _e328 {
                                let _e329 = (2u * _e324.member_1);
                                let _e333 = radiance.member[_e329][0u];
                                let _e337 = radiance.member[_e329][1u];
                                let _e341 = radiance.member[_e329][2u];
                                let _e342 = (_e329 + 1u);
                                let _e346 = radiance.member[_e342][0u];
                                let _e350 = radiance.member[_e342][1u];
                                let _e354 = radiance.member[_e342][2u];
                                let _e364 = facets.member[_e324.member_1].member_2;
                                let _e373 = sqrt((((_e364[0] * _e364[0]) + (_e364[1] * _e364[1])) + (_e364[2] * _e364[2])));
                                phi_273_ = vec4<f32>((_e309.x + (select(_e346, _e333, (_e333 > _e346)) * _e373)), (_e309.y + (select(_e350, _e337, (_e337 > _e350)) * _e373)), (_e309.z + (select(_e354, _e341, (_e341 > _e354)) * _e373)), (_e309.w + _e373));
                            } else {
                                phi_273_ = vec4<f32>();
                            }
                            let _e387 = phi_273_;
                            continue;
                            continuing {
                                phi_269_ = _e322;
                                phi_272_ = _e387;
                                break if !(_e328);
                            }
                        }
                        let _e2553 = local_55;
                        phi_491_ = _e2553;
                    } else {
                        let _e181 = local_1;
                        let _e184 = local_2;
                        phi_370_ = type_7(_e184, (_e181 + _e178));
                        phi_373_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_375_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e187 = phi_370_;
                            let _e189 = phi_373_;
                            let _e191 = phi_375_;
                            local_3 = _e189;
                            local_4 = _e191;
                            local_5 = _e189;
                            local_6 = _e189;
                            local_7 = _e189;
                            local_8 = _e191;
                            local_54 = _e191;
                            if (_e187.member < _e187.member_1) {
                                phi_371_ = type_7((_e187.member + 1u), _e187.member_1);
                                phi_398_ = type_7(1u, _e187.member);
                            } else {
                                phi_371_ = _e187;
                                phi_398_ = type_7(0u, type_7().member_1);
                            }
                            let _e204 = phi_371_;
                            let _e206 = phi_398_;
                            let _e210 = (bitcast<i32>(_e206.member) != 0i);
                            if _e210 {
                                let _e214 = facets.member[_e206.member_1].member_2;
                                let _e223 = -((((_e118 * _e214[0]) + (_e120 * _e214[1])) + (_e122 * _e214[2])));
                                if (_e223 > 0f) {
                                    let _e248 = radiance.member[(2u * _e206.member_1)];
                                    phi_467_ = _e189;
                                    phi_468_ = vec4<f32>((_e191.x + (_e248.x * _e223)), (_e191.y + (_e248.y * _e223)), (_e191.z + (_e248.z * _e223)), (_e191.w + _e223));
                                } else {
                                    let _e229 = radiance.member[((2u * _e206.member_1) + 1u)];
                                    phi_467_ = vec4<f32>((_e189.x - (_e229.x * _e223)), (_e189.y - (_e229.y * _e223)), (_e189.z - (_e229.z * _e223)), (_e189.w - _e223));
                                    phi_468_ = _e191;
                                }
                                let _e265 = phi_467_;
                                let _e267 = phi_468_;
                                phi_374_ = _e265;
                                phi_376_ = _e267;
                            } else {
                                phi_374_ = vec4<f32>();
                                phi_376_ = vec4<f32>();
                            }
                            let _e269 = phi_374_;
                            let _e271 = phi_376_;
                            continue;
                            continuing {
                                phi_370_ = _e204;
                                phi_373_ = _e269;
                                phi_375_ = _e271;
                                break if !(_e210);
                            }
                        }
                        let _e274 = local_3;
                        let _e277 = local_4;
                        if (_e274.w > _e277.w) {
                            let _e280 = (_e274.w - _e277.w);
                            let _e281 = (_e280 / _e274.w);
                            let _e283 = local_5;
                            let _e287 = local_6;
                            let _e291 = local_7;
                            let _e296 = local_8;
                            phi_490_ = (_e296 + vec4<f32>((_e283.x * _e281), (_e287.y * _e281), (_e291.z * _e281), _e280));
                        } else {
                            let _e2543 = local_54;
                            phi_490_ = _e2543;
                        }
                        let _e299 = phi_490_;
                        phi_491_ = _e299;
                    }
                    let _e390 = phi_491_;
                    if (_e390.w > 1f) {
                        phi_505_ = vec4<f32>((_e390.x / _e390.w), (_e390.y / _e390.w), (_e390.z / _e390.w), 1f);
                    } else {
                        phi_505_ = _e390;
                    }
                    let _e401 = phi_505_;
                    local[0u] = _e401;
                    let _e403 = local_11;
                    phi_508_ = (_e403 + _e178);
                } else {
                    let _e2558 = local_56;
                    phi_508_ = _e2558;
                }
                let _e406 = phi_508_;
                if (((_e70 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    let _e414 = facet_bits.member[_e71];
                    let _e415 = ((_e63 + 1u) & 31u);
                    let _e422 = facet_bits.member[(_e71 + 1u)];
                    let _e430 = facet_bits.member[(_e71 + 2u)];
                    let _e438 = facet_bits.member[(_e71 + 3u)];
                    let _e446 = facet_bits.member[(_e71 + 4u)];
                    let _e454 = facet_bits.member[(_e71 + 5u)];
                    let _e458 = (((((((_e414 >> bitcast<u32>(_e415)) & 1u) + ((_e422 >> bitcast<u32>(_e415)) & 1u)) + ((_e430 >> bitcast<u32>(_e415)) & 1u)) + ((_e438 >> bitcast<u32>(_e415)) & 1u)) + ((_e446 >> bitcast<u32>(_e415)) & 1u)) + ((_e454 >> bitcast<u32>(_e415)) & 1u));
                    if (_e52 == 1u) {
                        phi_566_ = type_7(_e406, (_e406 + _e458));
                        phi_569_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e579 = phi_566_;
                            let _e581 = phi_569_;
                            local_58 = _e581;
                            if (_e579.member < _e579.member_1) {
                                phi_567_ = type_7((_e579.member + 1u), _e579.member_1);
                                phi_592_ = type_7(1u, _e579.member);
                            } else {
                                phi_567_ = _e579;
                                phi_592_ = type_7(0u, type_7().member_1);
                            }
                            let _e594 = phi_567_;
                            let _e596 = phi_592_;
                            let _e600 = (bitcast<i32>(_e596.member) != 0i);
                            if _e600 {
                                let _e601 = (2u * _e596.member_1);
                                let _e605 = radiance.member[_e601][0u];
                                let _e609 = radiance.member[_e601][1u];
                                let _e613 = radiance.member[_e601][2u];
                                let _e614 = (_e601 + 1u);
                                let _e618 = radiance.member[_e614][0u];
                                let _e622 = radiance.member[_e614][1u];
                                let _e626 = radiance.member[_e614][2u];
                                let _e636 = facets.member[_e596.member_1].member_2;
                                let _e645 = sqrt((((_e636[0] * _e636[0]) + (_e636[1] * _e636[1])) + (_e636[2] * _e636[2])));
                                phi_570_ = vec4<f32>((_e581.x + (select(_e618, _e605, (_e605 > _e618)) * _e645)), (_e581.y + (select(_e622, _e609, (_e609 > _e622)) * _e645)), (_e581.z + (select(_e626, _e613, (_e613 > _e626)) * _e645)), (_e581.w + _e645));
                            } else {
                                phi_570_ = vec4<f32>();
                            }
                            let _e659 = phi_570_;
                            continue;
                            continuing {
                                phi_566_ = _e594;
                                phi_569_ = _e659;
                                break if !(_e600);
                            }
                        }
                        let _e2584 = local_58;
                        phi_788_ = _e2584;
                    } else {
                        phi_667_ = type_7(_e406, (_e406 + _e458));
                        phi_670_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_672_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e463 = phi_667_;
                            let _e465 = phi_670_;
                            let _e467 = phi_672_;
                            local_12 = _e465;
                            local_13 = _e467;
                            local_14 = _e465;
                            local_15 = _e465;
                            local_16 = _e465;
                            local_17 = _e467;
                            local_57 = _e467;
                            if (_e463.member < _e463.member_1) {
                                phi_668_ = type_7((_e463.member + 1u), _e463.member_1);
                                phi_695_ = type_7(1u, _e463.member);
                            } else {
                                phi_668_ = _e463;
                                phi_695_ = type_7(0u, type_7().member_1);
                            }
                            let _e480 = phi_668_;
                            let _e482 = phi_695_;
                            let _e486 = (bitcast<i32>(_e482.member) != 0i);
                            if _e486 {
                                let _e490 = facets.member[_e482.member_1].member_2;
                                let _e499 = -((((_e118 * _e490[0]) + (_e120 * _e490[1])) + (_e122 * _e490[2])));
                                if (_e499 > 0f) {
                                    let _e524 = radiance.member[(2u * _e482.member_1)];
                                    phi_764_ = _e465;
                                    phi_765_ = vec4<f32>((_e467.x + (_e524.x * _e499)), (_e467.y + (_e524.y * _e499)), (_e467.z + (_e524.z * _e499)), (_e467.w + _e499));
                                } else {
                                    let _e505 = radiance.member[((2u * _e482.member_1) + 1u)];
                                    phi_764_ = vec4<f32>((_e465.x - (_e505.x * _e499)), (_e465.y - (_e505.y * _e499)), (_e465.z - (_e505.z * _e499)), (_e465.w - _e499));
                                    phi_765_ = _e467;
                                }
                                let _e541 = phi_764_;
                                let _e543 = phi_765_;
                                phi_671_ = _e541;
                                phi_673_ = _e543;
                            } else {
                                phi_671_ = vec4<f32>();
                                phi_673_ = vec4<f32>();
                            }
                            let _e545 = phi_671_;
                            let _e547 = phi_673_;
                            continue;
                            continuing {
                                phi_667_ = _e480;
                                phi_670_ = _e545;
                                phi_672_ = _e547;
                                break if !(_e486);
                            }
                        }
                        let _e550 = local_12;
                        let _e553 = local_13;
                        if (_e550.w > _e553.w) {
                            let _e556 = (_e550.w - _e553.w);
                            let _e557 = (_e556 / _e550.w);
                            let _e559 = local_14;
                            let _e563 = local_15;
                            let _e567 = local_16;
                            let _e572 = local_17;
                            phi_787_ = (_e572 + vec4<f32>((_e559.x * _e557), (_e563.y * _e557), (_e567.z * _e557), _e556));
                        } else {
                            let _e2576 = local_57;
                            phi_787_ = _e2576;
                        }
                        let _e575 = phi_787_;
                        phi_788_ = _e575;
                    }
                    let _e662 = phi_788_;
                    if (_e662.w > 1f) {
                        phi_802_ = vec4<f32>((_e662.x / _e662.w), (_e662.y / _e662.w), (_e662.z / _e662.w), 1f);
                    } else {
                        phi_802_ = _e662;
                    }
                    let _e673 = phi_802_;
                    local[1u] = _e673;
                    phi_805_ = (_e406 + _e458);
                } else {
                    phi_805_ = _e406;
                }
                let _e676 = phi_805_;
                if (((_e70 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    let _e684 = facet_bits.member[_e71];
                    let _e685 = ((_e63 + 2u) & 31u);
                    let _e692 = facet_bits.member[(_e71 + 1u)];
                    let _e700 = facet_bits.member[(_e71 + 2u)];
                    let _e708 = facet_bits.member[(_e71 + 3u)];
                    let _e716 = facet_bits.member[(_e71 + 4u)];
                    let _e724 = facet_bits.member[(_e71 + 5u)];
                    let _e728 = (((((((_e684 >> bitcast<u32>(_e685)) & 1u) + ((_e692 >> bitcast<u32>(_e685)) & 1u)) + ((_e700 >> bitcast<u32>(_e685)) & 1u)) + ((_e708 >> bitcast<u32>(_e685)) & 1u)) + ((_e716 >> bitcast<u32>(_e685)) & 1u)) + ((_e724 >> bitcast<u32>(_e685)) & 1u));
                    if (_e52 == 1u) {
                        phi_863_ = type_7(_e676, (_e676 + _e728));
                        phi_866_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e849 = phi_863_;
                            let _e851 = phi_866_;
                            local_60 = _e851;
                            if (_e849.member < _e849.member_1) {
                                phi_864_ = type_7((_e849.member + 1u), _e849.member_1);
                                phi_889_ = type_7(1u, _e849.member);
                            } else {
                                phi_864_ = _e849;
                                phi_889_ = type_7(0u, type_7().member_1);
                            }
                            let _e864 = phi_864_;
                            let _e866 = phi_889_;
                            let _e870 = (bitcast<i32>(_e866.member) != 0i);
                            if _e870 {
                                let _e871 = (2u * _e866.member_1);
                                let _e875 = radiance.member[_e871][0u];
                                let _e879 = radiance.member[_e871][1u];
                                let _e883 = radiance.member[_e871][2u];
                                let _e884 = (_e871 + 1u);
                                let _e888 = radiance.member[_e884][0u];
                                let _e892 = radiance.member[_e884][1u];
                                let _e896 = radiance.member[_e884][2u];
                                let _e906 = facets.member[_e866.member_1].member_2;
                                let _e915 = sqrt((((_e906[0] * _e906[0]) + (_e906[1] * _e906[1])) + (_e906[2] * _e906[2])));
                                phi_867_ = vec4<f32>((_e851.x + (select(_e888, _e875, (_e875 > _e888)) * _e915)), (_e851.y + (select(_e892, _e879, (_e879 > _e892)) * _e915)), (_e851.z + (select(_e896, _e883, (_e883 > _e896)) * _e915)), (_e851.w + _e915));
                            } else {
                                phi_867_ = vec4<f32>();
                            }
                            let _e929 = phi_867_;
                            continue;
                            continuing {
                                phi_863_ = _e864;
                                phi_866_ = _e929;
                                break if !(_e870);
                            }
                        }
                        let _e2612 = local_60;
                        phi_1085_ = _e2612;
                    } else {
                        phi_964_ = type_7(_e676, (_e676 + _e728));
                        phi_967_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_969_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e733 = phi_964_;
                            let _e735 = phi_967_;
                            let _e737 = phi_969_;
                            local_18 = _e735;
                            local_19 = _e737;
                            local_20 = _e735;
                            local_21 = _e735;
                            local_22 = _e735;
                            local_23 = _e737;
                            local_59 = _e737;
                            if (_e733.member < _e733.member_1) {
                                phi_965_ = type_7((_e733.member + 1u), _e733.member_1);
                                phi_992_ = type_7(1u, _e733.member);
                            } else {
                                phi_965_ = _e733;
                                phi_992_ = type_7(0u, type_7().member_1);
                            }
                            let _e750 = phi_965_;
                            let _e752 = phi_992_;
                            let _e756 = (bitcast<i32>(_e752.member) != 0i);
                            if _e756 {
                                let _e760 = facets.member[_e752.member_1].member_2;
                                let _e769 = -((((_e118 * _e760[0]) + (_e120 * _e760[1])) + (_e122 * _e760[2])));
                                if (_e769 > 0f) {
                                    let _e794 = radiance.member[(2u * _e752.member_1)];
                                    phi_1061_ = _e735;
                                    phi_1062_ = vec4<f32>((_e737.x + (_e794.x * _e769)), (_e737.y + (_e794.y * _e769)), (_e737.z + (_e794.z * _e769)), (_e737.w + _e769));
                                } else {
                                    let _e775 = radiance.member[((2u * _e752.member_1) + 1u)];
                                    phi_1061_ = vec4<f32>((_e735.x - (_e775.x * _e769)), (_e735.y - (_e775.y * _e769)), (_e735.z - (_e775.z * _e769)), (_e735.w - _e769));
                                    phi_1062_ = _e737;
                                }
                                let _e811 = phi_1061_;
                                let _e813 = phi_1062_;
                                phi_968_ = _e811;
                                phi_970_ = _e813;
                            } else {
                                phi_968_ = vec4<f32>();
                                phi_970_ = vec4<f32>();
                            }
                            let _e815 = phi_968_;
                            let _e817 = phi_970_;
                            continue;
                            continuing {
                                phi_964_ = _e750;
                                phi_967_ = _e815;
                                phi_969_ = _e817;
                                break if !(_e756);
                            }
                        }
                        let _e820 = local_18;
                        let _e823 = local_19;
                        if (_e820.w > _e823.w) {
                            let _e826 = (_e820.w - _e823.w);
                            let _e827 = (_e826 / _e820.w);
                            let _e829 = local_20;
                            let _e833 = local_21;
                            let _e837 = local_22;
                            let _e842 = local_23;
                            phi_1084_ = (_e842 + vec4<f32>((_e829.x * _e827), (_e833.y * _e827), (_e837.z * _e827), _e826));
                        } else {
                            let _e2604 = local_59;
                            phi_1084_ = _e2604;
                        }
                        let _e845 = phi_1084_;
                        phi_1085_ = _e845;
                    }
                    let _e932 = phi_1085_;
                    if (_e932.w > 1f) {
                        phi_1099_ = vec4<f32>((_e932.x / _e932.w), (_e932.y / _e932.w), (_e932.z / _e932.w), 1f);
                    } else {
                        phi_1099_ = _e932;
                    }
                    let _e943 = phi_1099_;
                    local[2u] = _e943;
                    phi_1102_ = (_e676 + _e728);
                } else {
                    phi_1102_ = _e676;
                }
                let _e946 = phi_1102_;
                if (((_e70 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    let _e954 = facet_bits.member[_e71];
                    let _e955 = ((_e63 + 3u) & 31u);
                    let _e962 = facet_bits.member[(_e71 + 1u)];
                    let _e970 = facet_bits.member[(_e71 + 2u)];
                    let _e978 = facet_bits.member[(_e71 + 3u)];
                    let _e986 = facet_bits.member[(_e71 + 4u)];
                    let _e994 = facet_bits.member[(_e71 + 5u)];
                    let _e998 = (((((((_e954 >> bitcast<u32>(_e955)) & 1u) + ((_e962 >> bitcast<u32>(_e955)) & 1u)) + ((_e970 >> bitcast<u32>(_e955)) & 1u)) + ((_e978 >> bitcast<u32>(_e955)) & 1u)) + ((_e986 >> bitcast<u32>(_e955)) & 1u)) + ((_e994 >> bitcast<u32>(_e955)) & 1u));
                    if (_e52 == 1u) {
                        phi_1160_ = type_7(_e946, (_e946 + _e998));
                        phi_1163_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1119 = phi_1160_;
                            let _e1121 = phi_1163_;
                            local_62 = _e1121;
                            if (_e1119.member < _e1119.member_1) {
                                phi_1161_ = type_7((_e1119.member + 1u), _e1119.member_1);
                                phi_1186_ = type_7(1u, _e1119.member);
                            } else {
                                phi_1161_ = _e1119;
                                phi_1186_ = type_7(0u, type_7().member_1);
                            }
                            let _e1134 = phi_1161_;
                            let _e1136 = phi_1186_;
                            let _e1140 = (bitcast<i32>(_e1136.member) != 0i);
                            if _e1140 {
                                let _e1141 = (2u * _e1136.member_1);
                                let _e1145 = radiance.member[_e1141][0u];
                                let _e1149 = radiance.member[_e1141][1u];
                                let _e1153 = radiance.member[_e1141][2u];
                                let _e1154 = (_e1141 + 1u);
                                let _e1158 = radiance.member[_e1154][0u];
                                let _e1162 = radiance.member[_e1154][1u];
                                let _e1166 = radiance.member[_e1154][2u];
                                let _e1176 = facets.member[_e1136.member_1].member_2;
                                let _e1185 = sqrt((((_e1176[0] * _e1176[0]) + (_e1176[1] * _e1176[1])) + (_e1176[2] * _e1176[2])));
                                phi_1164_ = vec4<f32>((_e1121.x + (select(_e1158, _e1145, (_e1145 > _e1158)) * _e1185)), (_e1121.y + (select(_e1162, _e1149, (_e1149 > _e1162)) * _e1185)), (_e1121.z + (select(_e1166, _e1153, (_e1153 > _e1166)) * _e1185)), (_e1121.w + _e1185));
                            } else {
                                phi_1164_ = vec4<f32>();
                            }
                            let _e1199 = phi_1164_;
                            continue;
                            continuing {
                                phi_1160_ = _e1134;
                                phi_1163_ = _e1199;
                                break if !(_e1140);
                            }
                        }
                        let _e2640 = local_62;
                        phi_1382_ = _e2640;
                    } else {
                        phi_1261_ = type_7(_e946, (_e946 + _e998));
                        phi_1264_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1266_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1003 = phi_1261_;
                            let _e1005 = phi_1264_;
                            let _e1007 = phi_1266_;
                            local_24 = _e1005;
                            local_25 = _e1007;
                            local_26 = _e1005;
                            local_27 = _e1005;
                            local_28 = _e1005;
                            local_29 = _e1007;
                            local_61 = _e1007;
                            if (_e1003.member < _e1003.member_1) {
                                phi_1262_ = type_7((_e1003.member + 1u), _e1003.member_1);
                                phi_1289_ = type_7(1u, _e1003.member);
                            } else {
                                phi_1262_ = _e1003;
                                phi_1289_ = type_7(0u, type_7().member_1);
                            }
                            let _e1020 = phi_1262_;
                            let _e1022 = phi_1289_;
                            let _e1026 = (bitcast<i32>(_e1022.member) != 0i);
                            if _e1026 {
                                let _e1030 = facets.member[_e1022.member_1].member_2;
                                let _e1039 = -((((_e118 * _e1030[0]) + (_e120 * _e1030[1])) + (_e122 * _e1030[2])));
                                if (_e1039 > 0f) {
                                    let _e1064 = radiance.member[(2u * _e1022.member_1)];
                                    phi_1358_ = _e1005;
                                    phi_1359_ = vec4<f32>((_e1007.x + (_e1064.x * _e1039)), (_e1007.y + (_e1064.y * _e1039)), (_e1007.z + (_e1064.z * _e1039)), (_e1007.w + _e1039));
                                } else {
                                    let _e1045 = radiance.member[((2u * _e1022.member_1) + 1u)];
                                    phi_1358_ = vec4<f32>((_e1005.x - (_e1045.x * _e1039)), (_e1005.y - (_e1045.y * _e1039)), (_e1005.z - (_e1045.z * _e1039)), (_e1005.w - _e1039));
                                    phi_1359_ = _e1007;
                                }
                                let _e1081 = phi_1358_;
                                let _e1083 = phi_1359_;
                                phi_1265_ = _e1081;
                                phi_1267_ = _e1083;
                            } else {
                                phi_1265_ = vec4<f32>();
                                phi_1267_ = vec4<f32>();
                            }
                            let _e1085 = phi_1265_;
                            let _e1087 = phi_1267_;
                            continue;
                            continuing {
                                phi_1261_ = _e1020;
                                phi_1264_ = _e1085;
                                phi_1266_ = _e1087;
                                break if !(_e1026);
                            }
                        }
                        let _e1090 = local_24;
                        let _e1093 = local_25;
                        if (_e1090.w > _e1093.w) {
                            let _e1096 = (_e1090.w - _e1093.w);
                            let _e1097 = (_e1096 / _e1090.w);
                            let _e1099 = local_26;
                            let _e1103 = local_27;
                            let _e1107 = local_28;
                            let _e1112 = local_29;
                            phi_1381_ = (_e1112 + vec4<f32>((_e1099.x * _e1097), (_e1103.y * _e1097), (_e1107.z * _e1097), _e1096));
                        } else {
                            let _e2632 = local_61;
                            phi_1381_ = _e2632;
                        }
                        let _e1115 = phi_1381_;
                        phi_1382_ = _e1115;
                    }
                    let _e1202 = phi_1382_;
                    if (_e1202.w > 1f) {
                        phi_1396_ = vec4<f32>((_e1202.x / _e1202.w), (_e1202.y / _e1202.w), (_e1202.z / _e1202.w), 1f);
                    } else {
                        phi_1396_ = _e1202;
                    }
                    let _e1213 = phi_1396_;
                    local[3u] = _e1213;
                    phi_1399_ = (_e946 + _e998);
                } else {
                    phi_1399_ = _e946;
                }
                let _e1216 = phi_1399_;
                if (((_e70 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    let _e1224 = facet_bits.member[_e71];
                    let _e1225 = ((_e63 + 4u) & 31u);
                    let _e1232 = facet_bits.member[(_e71 + 1u)];
                    let _e1240 = facet_bits.member[(_e71 + 2u)];
                    let _e1248 = facet_bits.member[(_e71 + 3u)];
                    let _e1256 = facet_bits.member[(_e71 + 4u)];
                    let _e1264 = facet_bits.member[(_e71 + 5u)];
                    let _e1268 = (((((((_e1224 >> bitcast<u32>(_e1225)) & 1u) + ((_e1232 >> bitcast<u32>(_e1225)) & 1u)) + ((_e1240 >> bitcast<u32>(_e1225)) & 1u)) + ((_e1248 >> bitcast<u32>(_e1225)) & 1u)) + ((_e1256 >> bitcast<u32>(_e1225)) & 1u)) + ((_e1264 >> bitcast<u32>(_e1225)) & 1u));
                    if (_e52 == 1u) {
                        phi_1457_ = type_7(_e1216, (_e1216 + _e1268));
                        phi_1460_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1389 = phi_1457_;
                            let _e1391 = phi_1460_;
                            local_64 = _e1391;
                            if (_e1389.member < _e1389.member_1) {
                                phi_1458_ = type_7((_e1389.member + 1u), _e1389.member_1);
                                phi_1483_ = type_7(1u, _e1389.member);
                            } else {
                                phi_1458_ = _e1389;
                                phi_1483_ = type_7(0u, type_7().member_1);
                            }
                            let _e1404 = phi_1458_;
                            let _e1406 = phi_1483_;
                            let _e1410 = (bitcast<i32>(_e1406.member) != 0i);
                            if _e1410 {
                                let _e1411 = (2u * _e1406.member_1);
                                let _e1415 = radiance.member[_e1411][0u];
                                let _e1419 = radiance.member[_e1411][1u];
                                let _e1423 = radiance.member[_e1411][2u];
                                let _e1424 = (_e1411 + 1u);
                                let _e1428 = radiance.member[_e1424][0u];
                                let _e1432 = radiance.member[_e1424][1u];
                                let _e1436 = radiance.member[_e1424][2u];
                                let _e1446 = facets.member[_e1406.member_1].member_2;
                                let _e1455 = sqrt((((_e1446[0] * _e1446[0]) + (_e1446[1] * _e1446[1])) + (_e1446[2] * _e1446[2])));
                                phi_1461_ = vec4<f32>((_e1391.x + (select(_e1428, _e1415, (_e1415 > _e1428)) * _e1455)), (_e1391.y + (select(_e1432, _e1419, (_e1419 > _e1432)) * _e1455)), (_e1391.z + (select(_e1436, _e1423, (_e1423 > _e1436)) * _e1455)), (_e1391.w + _e1455));
                            } else {
                                phi_1461_ = vec4<f32>();
                            }
                            let _e1469 = phi_1461_;
                            continue;
                            continuing {
                                phi_1457_ = _e1404;
                                phi_1460_ = _e1469;
                                break if !(_e1410);
                            }
                        }
                        let _e2668 = local_64;
                        phi_1679_ = _e2668;
                    } else {
                        phi_1558_ = type_7(_e1216, (_e1216 + _e1268));
                        phi_1561_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1563_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1273 = phi_1558_;
                            let _e1275 = phi_1561_;
                            let _e1277 = phi_1563_;
                            local_30 = _e1275;
                            local_31 = _e1277;
                            local_32 = _e1275;
                            local_33 = _e1275;
                            local_34 = _e1275;
                            local_35 = _e1277;
                            local_63 = _e1277;
                            if (_e1273.member < _e1273.member_1) {
                                phi_1559_ = type_7((_e1273.member + 1u), _e1273.member_1);
                                phi_1586_ = type_7(1u, _e1273.member);
                            } else {
                                phi_1559_ = _e1273;
                                phi_1586_ = type_7(0u, type_7().member_1);
                            }
                            let _e1290 = phi_1559_;
                            let _e1292 = phi_1586_;
                            let _e1296 = (bitcast<i32>(_e1292.member) != 0i);
                            if _e1296 {
                                let _e1300 = facets.member[_e1292.member_1].member_2;
                                let _e1309 = -((((_e118 * _e1300[0]) + (_e120 * _e1300[1])) + (_e122 * _e1300[2])));
                                if (_e1309 > 0f) {
                                    let _e1334 = radiance.member[(2u * _e1292.member_1)];
                                    phi_1655_ = _e1275;
                                    phi_1656_ = vec4<f32>((_e1277.x + (_e1334.x * _e1309)), (_e1277.y + (_e1334.y * _e1309)), (_e1277.z + (_e1334.z * _e1309)), (_e1277.w + _e1309));
                                } else {
                                    let _e1315 = radiance.member[((2u * _e1292.member_1) + 1u)];
                                    phi_1655_ = vec4<f32>((_e1275.x - (_e1315.x * _e1309)), (_e1275.y - (_e1315.y * _e1309)), (_e1275.z - (_e1315.z * _e1309)), (_e1275.w - _e1309));
                                    phi_1656_ = _e1277;
                                }
                                let _e1351 = phi_1655_;
                                let _e1353 = phi_1656_;
                                phi_1562_ = _e1351;
                                phi_1564_ = _e1353;
                            } else {
                                phi_1562_ = vec4<f32>();
                                phi_1564_ = vec4<f32>();
                            }
                            let _e1355 = phi_1562_;
                            let _e1357 = phi_1564_;
                            continue;
                            continuing {
                                phi_1558_ = _e1290;
                                phi_1561_ = _e1355;
                                phi_1563_ = _e1357;
                                break if !(_e1296);
                            }
                        }
                        let _e1360 = local_30;
                        let _e1363 = local_31;
                        if (_e1360.w > _e1363.w) {
                            let _e1366 = (_e1360.w - _e1363.w);
                            let _e1367 = (_e1366 / _e1360.w);
                            let _e1369 = local_32;
                            let _e1373 = local_33;
                            let _e1377 = local_34;
                            let _e1382 = local_35;
                            phi_1678_ = (_e1382 + vec4<f32>((_e1369.x * _e1367), (_e1373.y * _e1367), (_e1377.z * _e1367), _e1366));
                        } else {
                            let _e2660 = local_63;
                            phi_1678_ = _e2660;
                        }
                        let _e1385 = phi_1678_;
                        phi_1679_ = _e1385;
                    }
                    let _e1472 = phi_1679_;
                    if (_e1472.w > 1f) {
                        phi_1693_ = vec4<f32>((_e1472.x / _e1472.w), (_e1472.y / _e1472.w), (_e1472.z / _e1472.w), 1f);
                    } else {
                        phi_1693_ = _e1472;
                    }
                    let _e1483 = phi_1693_;
                    local[4u] = _e1483;
                    phi_1696_ = (_e1216 + _e1268);
                } else {
                    phi_1696_ = _e1216;
                }
                let _e1486 = phi_1696_;
                if (((_e70 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    let _e1494 = facet_bits.member[_e71];
                    let _e1495 = ((_e63 + 5u) & 31u);
                    let _e1502 = facet_bits.member[(_e71 + 1u)];
                    let _e1510 = facet_bits.member[(_e71 + 2u)];
                    let _e1518 = facet_bits.member[(_e71 + 3u)];
                    let _e1526 = facet_bits.member[(_e71 + 4u)];
                    let _e1534 = facet_bits.member[(_e71 + 5u)];
                    let _e1538 = (((((((_e1494 >> bitcast<u32>(_e1495)) & 1u) + ((_e1502 >> bitcast<u32>(_e1495)) & 1u)) + ((_e1510 >> bitcast<u32>(_e1495)) & 1u)) + ((_e1518 >> bitcast<u32>(_e1495)) & 1u)) + ((_e1526 >> bitcast<u32>(_e1495)) & 1u)) + ((_e1534 >> bitcast<u32>(_e1495)) & 1u));
                    if (_e52 == 1u) {
                        phi_1754_ = type_7(_e1486, (_e1486 + _e1538));
                        phi_1757_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1659 = phi_1754_;
                            let _e1661 = phi_1757_;
                            local_66 = _e1661;
                            if (_e1659.member < _e1659.member_1) {
                                phi_1755_ = type_7((_e1659.member + 1u), _e1659.member_1);
                                phi_1780_ = type_7(1u, _e1659.member);
                            } else {
                                phi_1755_ = _e1659;
                                phi_1780_ = type_7(0u, type_7().member_1);
                            }
                            let _e1674 = phi_1755_;
                            let _e1676 = phi_1780_;
                            let _e1680 = (bitcast<i32>(_e1676.member) != 0i);
                            if _e1680 {
                                let _e1681 = (2u * _e1676.member_1);
                                let _e1685 = radiance.member[_e1681][0u];
                                let _e1689 = radiance.member[_e1681][1u];
                                let _e1693 = radiance.member[_e1681][2u];
                                let _e1694 = (_e1681 + 1u);
                                let _e1698 = radiance.member[_e1694][0u];
                                let _e1702 = radiance.member[_e1694][1u];
                                let _e1706 = radiance.member[_e1694][2u];
                                let _e1716 = facets.member[_e1676.member_1].member_2;
                                let _e1725 = sqrt((((_e1716[0] * _e1716[0]) + (_e1716[1] * _e1716[1])) + (_e1716[2] * _e1716[2])));
                                phi_1758_ = vec4<f32>((_e1661.x + (select(_e1698, _e1685, (_e1685 > _e1698)) * _e1725)), (_e1661.y + (select(_e1702, _e1689, (_e1689 > _e1702)) * _e1725)), (_e1661.z + (select(_e1706, _e1693, (_e1693 > _e1706)) * _e1725)), (_e1661.w + _e1725));
                            } else {
                                phi_1758_ = vec4<f32>();
                            }
                            let _e1739 = phi_1758_;
                            continue;
                            continuing {
                                phi_1754_ = _e1674;
                                phi_1757_ = _e1739;
                                break if !(_e1680);
                            }
                        }
                        let _e2696 = local_66;
                        phi_1976_ = _e2696;
                    } else {
                        phi_1855_ = type_7(_e1486, (_e1486 + _e1538));
                        phi_1858_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1860_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1543 = phi_1855_;
                            let _e1545 = phi_1858_;
                            let _e1547 = phi_1860_;
                            local_36 = _e1545;
                            local_37 = _e1547;
                            local_38 = _e1545;
                            local_39 = _e1545;
                            local_40 = _e1545;
                            local_41 = _e1547;
                            local_65 = _e1547;
                            if (_e1543.member < _e1543.member_1) {
                                phi_1856_ = type_7((_e1543.member + 1u), _e1543.member_1);
                                phi_1883_ = type_7(1u, _e1543.member);
                            } else {
                                phi_1856_ = _e1543;
                                phi_1883_ = type_7(0u, type_7().member_1);
                            }
                            let _e1560 = phi_1856_;
                            let _e1562 = phi_1883_;
                            let _e1566 = (bitcast<i32>(_e1562.member) != 0i);
                            if _e1566 {
                                let _e1570 = facets.member[_e1562.member_1].member_2;
                                let _e1579 = -((((_e118 * _e1570[0]) + (_e120 * _e1570[1])) + (_e122 * _e1570[2])));
                                if (_e1579 > 0f) {
                                    let _e1604 = radiance.member[(2u * _e1562.member_1)];
                                    phi_1952_ = _e1545;
                                    phi_1953_ = vec4<f32>((_e1547.x + (_e1604.x * _e1579)), (_e1547.y + (_e1604.y * _e1579)), (_e1547.z + (_e1604.z * _e1579)), (_e1547.w + _e1579));
                                } else {
                                    let _e1585 = radiance.member[((2u * _e1562.member_1) + 1u)];
                                    phi_1952_ = vec4<f32>((_e1545.x - (_e1585.x * _e1579)), (_e1545.y - (_e1585.y * _e1579)), (_e1545.z - (_e1585.z * _e1579)), (_e1545.w - _e1579));
                                    phi_1953_ = _e1547;
                                }
                                let _e1621 = phi_1952_;
                                let _e1623 = phi_1953_;
                                phi_1859_ = _e1621;
                                phi_1861_ = _e1623;
                            } else {
                                phi_1859_ = vec4<f32>();
                                phi_1861_ = vec4<f32>();
                            }
                            let _e1625 = phi_1859_;
                            let _e1627 = phi_1861_;
                            continue;
                            continuing {
                                phi_1855_ = _e1560;
                                phi_1858_ = _e1625;
                                phi_1860_ = _e1627;
                                break if !(_e1566);
                            }
                        }
                        let _e1630 = local_36;
                        let _e1633 = local_37;
                        if (_e1630.w > _e1633.w) {
                            let _e1636 = (_e1630.w - _e1633.w);
                            let _e1637 = (_e1636 / _e1630.w);
                            let _e1639 = local_38;
                            let _e1643 = local_39;
                            let _e1647 = local_40;
                            let _e1652 = local_41;
                            phi_1975_ = (_e1652 + vec4<f32>((_e1639.x * _e1637), (_e1643.y * _e1637), (_e1647.z * _e1637), _e1636));
                        } else {
                            let _e2688 = local_65;
                            phi_1975_ = _e2688;
                        }
                        let _e1655 = phi_1975_;
                        phi_1976_ = _e1655;
                    }
                    let _e1742 = phi_1976_;
                    if (_e1742.w > 1f) {
                        phi_1990_ = vec4<f32>((_e1742.x / _e1742.w), (_e1742.y / _e1742.w), (_e1742.z / _e1742.w), 1f);
                    } else {
                        phi_1990_ = _e1742;
                    }
                    let _e1753 = phi_1990_;
                    local[5u] = _e1753;
                    phi_1993_ = (_e1486 + _e1538);
                } else {
                    phi_1993_ = _e1486;
                }
                let _e1756 = phi_1993_;
                if (((_e70 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    let _e1764 = facet_bits.member[_e71];
                    let _e1765 = ((_e63 + 6u) & 31u);
                    let _e1772 = facet_bits.member[(_e71 + 1u)];
                    let _e1780 = facet_bits.member[(_e71 + 2u)];
                    let _e1788 = facet_bits.member[(_e71 + 3u)];
                    let _e1796 = facet_bits.member[(_e71 + 4u)];
                    let _e1804 = facet_bits.member[(_e71 + 5u)];
                    let _e1808 = (((((((_e1764 >> bitcast<u32>(_e1765)) & 1u) + ((_e1772 >> bitcast<u32>(_e1765)) & 1u)) + ((_e1780 >> bitcast<u32>(_e1765)) & 1u)) + ((_e1788 >> bitcast<u32>(_e1765)) & 1u)) + ((_e1796 >> bitcast<u32>(_e1765)) & 1u)) + ((_e1804 >> bitcast<u32>(_e1765)) & 1u));
                    if (_e52 == 1u) {
                        phi_2051_ = type_7(_e1756, (_e1756 + _e1808));
                        phi_2054_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1929 = phi_2051_;
                            let _e1931 = phi_2054_;
                            local_68 = _e1931;
                            if (_e1929.member < _e1929.member_1) {
                                phi_2052_ = type_7((_e1929.member + 1u), _e1929.member_1);
                                phi_2077_ = type_7(1u, _e1929.member);
                            } else {
                                phi_2052_ = _e1929;
                                phi_2077_ = type_7(0u, type_7().member_1);
                            }
                            let _e1944 = phi_2052_;
                            let _e1946 = phi_2077_;
                            let _e1950 = (bitcast<i32>(_e1946.member) != 0i);
                            if _e1950 {
                                let _e1951 = (2u * _e1946.member_1);
                                let _e1955 = radiance.member[_e1951][0u];
                                let _e1959 = radiance.member[_e1951][1u];
                                let _e1963 = radiance.member[_e1951][2u];
                                let _e1964 = (_e1951 + 1u);
                                let _e1968 = radiance.member[_e1964][0u];
                                let _e1972 = radiance.member[_e1964][1u];
                                let _e1976 = radiance.member[_e1964][2u];
                                let _e1986 = facets.member[_e1946.member_1].member_2;
                                let _e1995 = sqrt((((_e1986[0] * _e1986[0]) + (_e1986[1] * _e1986[1])) + (_e1986[2] * _e1986[2])));
                                phi_2055_ = vec4<f32>((_e1931.x + (select(_e1968, _e1955, (_e1955 > _e1968)) * _e1995)), (_e1931.y + (select(_e1972, _e1959, (_e1959 > _e1972)) * _e1995)), (_e1931.z + (select(_e1976, _e1963, (_e1963 > _e1976)) * _e1995)), (_e1931.w + _e1995));
                            } else {
                                phi_2055_ = vec4<f32>();
                            }
                            let _e2009 = phi_2055_;
                            continue;
                            continuing {
                                phi_2051_ = _e1944;
                                phi_2054_ = _e2009;
                                break if !(_e1950);
                            }
                        }
                        let _e2724 = local_68;
                        phi_2273_ = _e2724;
                    } else {
                        phi_2152_ = type_7(_e1756, (_e1756 + _e1808));
                        phi_2155_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_2157_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e1813 = phi_2152_;
                            let _e1815 = phi_2155_;
                            let _e1817 = phi_2157_;
                            local_42 = _e1815;
                            local_43 = _e1817;
                            local_44 = _e1815;
                            local_45 = _e1815;
                            local_46 = _e1815;
                            local_47 = _e1817;
                            local_67 = _e1817;
                            if (_e1813.member < _e1813.member_1) {
                                phi_2153_ = type_7((_e1813.member + 1u), _e1813.member_1);
                                phi_2180_ = type_7(1u, _e1813.member);
                            } else {
                                phi_2153_ = _e1813;
                                phi_2180_ = type_7(0u, type_7().member_1);
                            }
                            let _e1830 = phi_2153_;
                            let _e1832 = phi_2180_;
                            let _e1836 = (bitcast<i32>(_e1832.member) != 0i);
                            if _e1836 {
                                let _e1840 = facets.member[_e1832.member_1].member_2;
                                let _e1849 = -((((_e118 * _e1840[0]) + (_e120 * _e1840[1])) + (_e122 * _e1840[2])));
                                if (_e1849 > 0f) {
                                    let _e1874 = radiance.member[(2u * _e1832.member_1)];
                                    phi_2249_ = _e1815;
                                    phi_2250_ = vec4<f32>((_e1817.x + (_e1874.x * _e1849)), (_e1817.y + (_e1874.y * _e1849)), (_e1817.z + (_e1874.z * _e1849)), (_e1817.w + _e1849));
                                } else {
                                    let _e1855 = radiance.member[((2u * _e1832.member_1) + 1u)];
                                    phi_2249_ = vec4<f32>((_e1815.x - (_e1855.x * _e1849)), (_e1815.y - (_e1855.y * _e1849)), (_e1815.z - (_e1855.z * _e1849)), (_e1815.w - _e1849));
                                    phi_2250_ = _e1817;
                                }
                                let _e1891 = phi_2249_;
                                let _e1893 = phi_2250_;
                                phi_2156_ = _e1891;
                                phi_2158_ = _e1893;
                            } else {
                                phi_2156_ = vec4<f32>();
                                phi_2158_ = vec4<f32>();
                            }
                            let _e1895 = phi_2156_;
                            let _e1897 = phi_2158_;
                            continue;
                            continuing {
                                phi_2152_ = _e1830;
                                phi_2155_ = _e1895;
                                phi_2157_ = _e1897;
                                break if !(_e1836);
                            }
                        }
                        let _e1900 = local_42;
                        let _e1903 = local_43;
                        if (_e1900.w > _e1903.w) {
                            let _e1906 = (_e1900.w - _e1903.w);
                            let _e1907 = (_e1906 / _e1900.w);
                            let _e1909 = local_44;
                            let _e1913 = local_45;
                            let _e1917 = local_46;
                            let _e1922 = local_47;
                            phi_2272_ = (_e1922 + vec4<f32>((_e1909.x * _e1907), (_e1913.y * _e1907), (_e1917.z * _e1907), _e1906));
                        } else {
                            let _e2716 = local_67;
                            phi_2272_ = _e2716;
                        }
                        let _e1925 = phi_2272_;
                        phi_2273_ = _e1925;
                    }
                    let _e2012 = phi_2273_;
                    if (_e2012.w > 1f) {
                        phi_2287_ = vec4<f32>((_e2012.x / _e2012.w), (_e2012.y / _e2012.w), (_e2012.z / _e2012.w), 1f);
                    } else {
                        phi_2287_ = _e2012;
                    }
                    let _e2023 = phi_2287_;
                    local[6u] = _e2023;
                    phi_2290_ = (_e1756 + _e1808);
                } else {
                    phi_2290_ = _e1756;
                }
                let _e2026 = phi_2290_;
                if (((_e70 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    let _e2034 = facet_bits.member[_e71];
                    let _e2035 = ((_e63 + 7u) & 31u);
                    let _e2042 = facet_bits.member[(_e71 + 1u)];
                    let _e2050 = facet_bits.member[(_e71 + 2u)];
                    let _e2058 = facet_bits.member[(_e71 + 3u)];
                    let _e2066 = facet_bits.member[(_e71 + 4u)];
                    let _e2074 = facet_bits.member[(_e71 + 5u)];
                    let _e2078 = (((((((_e2034 >> bitcast<u32>(_e2035)) & 1u) + ((_e2042 >> bitcast<u32>(_e2035)) & 1u)) + ((_e2050 >> bitcast<u32>(_e2035)) & 1u)) + ((_e2058 >> bitcast<u32>(_e2035)) & 1u)) + ((_e2066 >> bitcast<u32>(_e2035)) & 1u)) + ((_e2074 >> bitcast<u32>(_e2035)) & 1u));
                    if (_e52 == 1u) {
                        phi_2348_ = type_7(_e2026, (_e2026 + _e2078));
                        phi_2351_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e2199 = phi_2348_;
                            let _e2201 = phi_2351_;
                            local_70 = _e2201;
                            if (_e2199.member < _e2199.member_1) {
                                phi_2349_ = type_7((_e2199.member + 1u), _e2199.member_1);
                                phi_2374_ = type_7(1u, _e2199.member);
                            } else {
                                phi_2349_ = _e2199;
                                phi_2374_ = type_7(0u, type_7().member_1);
                            }
                            let _e2214 = phi_2349_;
                            let _e2216 = phi_2374_;
                            let _e2220 = (bitcast<i32>(_e2216.member) != 0i);
                            if _e2220 {
                                let _e2221 = (2u * _e2216.member_1);
                                let _e2225 = radiance.member[_e2221][0u];
                                let _e2229 = radiance.member[_e2221][1u];
                                let _e2233 = radiance.member[_e2221][2u];
                                let _e2234 = (_e2221 + 1u);
                                let _e2238 = radiance.member[_e2234][0u];
                                let _e2242 = radiance.member[_e2234][1u];
                                let _e2246 = radiance.member[_e2234][2u];
                                let _e2256 = facets.member[_e2216.member_1].member_2;
                                let _e2265 = sqrt((((_e2256[0] * _e2256[0]) + (_e2256[1] * _e2256[1])) + (_e2256[2] * _e2256[2])));
                                phi_2352_ = vec4<f32>((_e2201.x + (select(_e2238, _e2225, (_e2225 > _e2238)) * _e2265)), (_e2201.y + (select(_e2242, _e2229, (_e2229 > _e2242)) * _e2265)), (_e2201.z + (select(_e2246, _e2233, (_e2233 > _e2246)) * _e2265)), (_e2201.w + _e2265));
                            } else {
                                phi_2352_ = vec4<f32>();
                            }
                            let _e2279 = phi_2352_;
                            continue;
                            continuing {
                                phi_2348_ = _e2214;
                                phi_2351_ = _e2279;
                                break if !(_e2220);
                            }
                        }
                        let _e2752 = local_70;
                        phi_2570_ = _e2752;
                    } else {
                        phi_2449_ = type_7(_e2026, (_e2026 + _e2078));
                        phi_2452_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_2454_ = vec4<f32>(0f, 0f, 0f, 0f);
                        loop {
                            let _e2083 = phi_2449_;
                            let _e2085 = phi_2452_;
                            let _e2087 = phi_2454_;
                            local_48 = _e2085;
                            local_49 = _e2087;
                            local_50 = _e2085;
                            local_51 = _e2085;
                            local_52 = _e2085;
                            local_53 = _e2087;
                            local_69 = _e2087;
                            if (_e2083.member < _e2083.member_1) {
                                phi_2450_ = type_7((_e2083.member + 1u), _e2083.member_1);
                                phi_2477_ = type_7(1u, _e2083.member);
                            } else {
                                phi_2450_ = _e2083;
                                phi_2477_ = type_7(0u, type_7().member_1);
                            }
                            let _e2100 = phi_2450_;
                            let _e2102 = phi_2477_;
                            let _e2106 = (bitcast<i32>(_e2102.member) != 0i);
                            if _e2106 {
                                let _e2110 = facets.member[_e2102.member_1].member_2;
                                let _e2119 = -((((_e118 * _e2110[0]) + (_e120 * _e2110[1])) + (_e122 * _e2110[2])));
                                if (_e2119 > 0f) {
                                    let _e2144 = radiance.member[(2u * _e2102.member_1)];
                                    phi_2546_ = _e2085;
                                    phi_2547_ = vec4<f32>((_e2087.x + (_e2144.x * _e2119)), (_e2087.y + (_e2144.y * _e2119)), (_e2087.z + (_e2144.z * _e2119)), (_e2087.w + _e2119));
                                } else {
                                    let _e2125 = radiance.member[((2u * _e2102.member_1) + 1u)];
                                    phi_2546_ = vec4<f32>((_e2085.x - (_e2125.x * _e2119)), (_e2085.y - (_e2125.y * _e2119)), (_e2085.z - (_e2125.z * _e2119)), (_e2085.w - _e2119));
                                    phi_2547_ = _e2087;
                                }
                                let _e2161 = phi_2546_;
                                let _e2163 = phi_2547_;
                                phi_2453_ = _e2161;
                                phi_2455_ = _e2163;
                            } else {
                                phi_2453_ = vec4<f32>();
                                phi_2455_ = vec4<f32>();
                            }
                            let _e2165 = phi_2453_;
                            let _e2167 = phi_2455_;
                            continue;
                            continuing {
                                phi_2449_ = _e2100;
                                phi_2452_ = _e2165;
                                phi_2454_ = _e2167;
                                break if !(_e2106);
                            }
                        }
                        let _e2170 = local_48;
                        let _e2173 = local_49;
                        if (_e2170.w > _e2173.w) {
                            let _e2176 = (_e2170.w - _e2173.w);
                            let _e2177 = (_e2176 / _e2170.w);
                            let _e2179 = local_50;
                            let _e2183 = local_51;
                            let _e2187 = local_52;
                            let _e2192 = local_53;
                            phi_2569_ = (_e2192 + vec4<f32>((_e2179.x * _e2177), (_e2183.y * _e2177), (_e2187.z * _e2177), _e2176));
                        } else {
                            let _e2744 = local_69;
                            phi_2569_ = _e2744;
                        }
                        let _e2195 = phi_2569_;
                        phi_2570_ = _e2195;
                    }
                    let _e2282 = phi_2570_;
                    if (_e2282.w > 1f) {
                        phi_2584_ = vec4<f32>((_e2282.x / _e2282.w), (_e2282.y / _e2282.w), (_e2282.z / _e2282.w), 1f);
                    } else {
                        phi_2584_ = _e2282;
                    }
                    let _e2293 = phi_2584_;
                    local[7u] = _e2293;
                }
                if (_e52 == 1u) {
                    let _e2430 = local[0u];
                    let _e2431 = local[1u];
                    let _e2444 = local[2u];
                    let _e2445 = local[3u];
                    let _e2462 = local[4u];
                    let _e2463 = local[5u];
                    let _e2476 = local[6u];
                    let _e2477 = local[7u];
                    let _e2498 = ((((_e2430.x + _e2431.x) + (_e2444.x + _e2445.x)) + ((_e2462.x + _e2463.x) + (_e2476.x + _e2477.x))) * 0.25f);
                    let _e2499 = ((((_e2430.y + _e2431.y) + (_e2444.y + _e2445.y)) + ((_e2462.y + _e2463.y) + (_e2476.y + _e2477.y))) * 0.25f);
                    let _e2500 = ((((_e2430.z + _e2431.z) + (_e2444.z + _e2445.z)) + ((_e2462.z + _e2463.z) + (_e2476.z + _e2477.z))) * 0.25f);
                    let _e2501 = ((((_e2430.w + _e2431.w) + (_e2444.w + _e2445.w)) + ((_e2462.w + _e2463.w) + (_e2476.w + _e2477.w))) * 0.25f);
                    if (_e2501 > 1f) {
                        phi_2682_ = vec4<f32>((_e2498 / _e2501), (_e2499 / _e2501), (_e2500 / _e2501), (_e2501 / _e2501));
                    } else {
                        phi_2682_ = vec4<f32>(_e2498, _e2499, _e2500, _e2501);
                    }
                    let _e2510 = phi_2682_;
                    phi_2884_ = _e2510;
                } else {
                    let _e2297 = (1u << bitcast<u32>((_e113 & 31u)));
                    let _e2298 = select(1u, 2u, _e117);
                    let _e2299 = select(4u, 2u, _e121);
                    let _e2300 = select(0u, _e2297, _e115);
                    let _e2301 = select(_e2297, 0u, _e115);
                    if (_e2300 < 8u) {
                    } else {
                        break;
                    }
                    let _e2304 = local[_e2300];
                    if (_e2301 < 8u) {
                    } else {
                        break;
                    }
                    let _e2307 = local[_e2301];
                    let _e2309 = (1f - _e2304.w);
                    if (_e2307.w <= _e2309) {
                        phi_2737_ = (_e2304 + _e2307);
                    } else {
                        let _e2312 = (_e2309 / _e2307.w);
                        phi_2737_ = (_e2304 + vec4<f32>((_e2307.x * _e2312), (_e2307.y * _e2312), (_e2307.z * _e2312), _e2309));
                    }
                    let _e2323 = phi_2737_;
                    let _e2324 = (_e2298 + _e2300);
                    if (_e2324 < 8u) {
                    } else {
                        break;
                    }
                    let _e2327 = local[_e2324];
                    let _e2328 = (_e2298 + _e2301);
                    if (_e2328 < 8u) {
                    } else {
                        break;
                    }
                    let _e2331 = local[_e2328];
                    let _e2333 = (1f - _e2327.w);
                    if (_e2331.w <= _e2333) {
                        phi_2774_ = (_e2327 + _e2331);
                    } else {
                        let _e2336 = (_e2333 / _e2331.w);
                        phi_2774_ = (_e2327 + vec4<f32>((_e2331.x * _e2336), (_e2331.y * _e2336), (_e2331.z * _e2336), _e2333));
                    }
                    let _e2347 = phi_2774_;
                    let _e2360 = (_e2299 + _e2300);
                    if (_e2360 < 8u) {
                    } else {
                        break;
                    }
                    let _e2363 = local[_e2360];
                    let _e2364 = (_e2299 + _e2301);
                    if (_e2364 < 8u) {
                    } else {
                        break;
                    }
                    let _e2367 = local[_e2364];
                    let _e2369 = (1f - _e2363.w);
                    if (_e2367.w <= _e2369) {
                        phi_2823_ = (_e2363 + _e2367);
                    } else {
                        let _e2372 = (_e2369 / _e2367.w);
                        phi_2823_ = (_e2363 + vec4<f32>((_e2367.x * _e2372), (_e2367.y * _e2372), (_e2367.z * _e2372), _e2369));
                    }
                    let _e2383 = phi_2823_;
                    let _e2392 = (_e2298 + _e2299);
                    let _e2393 = (_e2392 + _e2300);
                    if (_e2393 < 8u) {
                    } else {
                        break;
                    }
                    let _e2396 = local[_e2393];
                    let _e2397 = (_e2392 + _e2301);
                    if (_e2397 < 8u) {
                    } else {
                        break;
                    }
                    let _e2400 = local[_e2397];
                    let _e2402 = (1f - _e2396.w);
                    if (_e2400.w <= _e2402) {
                        phi_2870_ = (_e2396 + _e2400);
                    } else {
                        let _e2405 = (_e2402 / _e2400.w);
                        phi_2870_ = (_e2396 + vec4<f32>((_e2400.x * _e2405), (_e2400.y * _e2405), (_e2400.z * _e2405), _e2402));
                    }
                    let _e2416 = phi_2870_;
                    phi_2884_ = vec4<f32>(((((_e2323.x + _e2347.x) + _e2383.x) + _e2416.x) * 0.25f), ((((_e2323.y + _e2347.y) + _e2383.y) + _e2416.y) * 0.25f), ((((_e2323.z + _e2347.z) + _e2383.z) + _e2416.z) * 0.25f), ((((_e2323.w + _e2347.w) + _e2383.w) + _e2416.w) * 0.25f));
                }
                let _e2512 = phi_2884_;
                let _e2515 = ((_e41 + _e48) + (_e48 - _e48));
                if (_e2515 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e2515] = _e2512;
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
