struct type_8 {
    member: array<u32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
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
var<storage> cells: type_8;
@group(0) @binding(2) 
var<storage> facet_bits: type_8;
@group(0) @binding(3) 
var<storage> facets: type_17;
@group(0) @binding(4) 
var<storage> radiance: type_23;
@group(0) @binding(0) 
var<uniform> params: type_27;
@group(0) @binding(5) 
var<storage> children: type_8;
@group(0) @binding(6) 
var<storage, read_write> out: type_23;

fn function_() {
    var local: array<vec4<f32>, 8>;
    var phi_130_: type_11;
    var phi_133_: u32;
    var phi_131_: type_11;
    var phi_156_: type_11;
    var phi_134_: u32;
    var phi_345_: vec4<f32>;
    var phi_348_: vec4<f32>;
    var phi_350_: u32;
    var local_1: u32;
    var phi_420_: vec4<f32>;
    var phi_421_: vec4<f32>;
    var phi_346_: vec4<f32>;
    var phi_349_: vec4<f32>;
    var phi_351_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_444_: vec4<f32>;
    var phi_267_: vec4<f32>;
    var phi_270_: u32;
    var local_8: u32;
    var phi_268_: vec4<f32>;
    var phi_271_: u32;
    var phi_445_: vec4<f32>;
    var phi_459_: vec4<f32>;
    var local_9: u32;
    var phi_462_: u32;
    var phi_596_: vec4<f32>;
    var phi_599_: vec4<f32>;
    var phi_601_: u32;
    var phi_671_: vec4<f32>;
    var phi_672_: vec4<f32>;
    var phi_597_: vec4<f32>;
    var phi_600_: vec4<f32>;
    var phi_602_: u32;
    var local_10: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var phi_695_: vec4<f32>;
    var phi_518_: vec4<f32>;
    var phi_521_: u32;
    var phi_519_: vec4<f32>;
    var phi_522_: u32;
    var phi_696_: vec4<f32>;
    var phi_710_: vec4<f32>;
    var phi_713_: u32;
    var phi_847_: vec4<f32>;
    var phi_850_: vec4<f32>;
    var phi_852_: u32;
    var phi_922_: vec4<f32>;
    var phi_923_: vec4<f32>;
    var phi_848_: vec4<f32>;
    var phi_851_: vec4<f32>;
    var phi_853_: u32;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: vec4<f32>;
    var local_21: vec4<f32>;
    var phi_946_: vec4<f32>;
    var phi_769_: vec4<f32>;
    var phi_772_: u32;
    var phi_770_: vec4<f32>;
    var phi_773_: u32;
    var phi_947_: vec4<f32>;
    var phi_961_: vec4<f32>;
    var phi_964_: u32;
    var phi_1098_: vec4<f32>;
    var phi_1101_: vec4<f32>;
    var phi_1103_: u32;
    var phi_1173_: vec4<f32>;
    var phi_1174_: vec4<f32>;
    var phi_1099_: vec4<f32>;
    var phi_1102_: vec4<f32>;
    var phi_1104_: u32;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var phi_1197_: vec4<f32>;
    var phi_1020_: vec4<f32>;
    var phi_1023_: u32;
    var phi_1021_: vec4<f32>;
    var phi_1024_: u32;
    var phi_1198_: vec4<f32>;
    var phi_1212_: vec4<f32>;
    var phi_1215_: u32;
    var phi_1349_: vec4<f32>;
    var phi_1352_: vec4<f32>;
    var phi_1354_: u32;
    var phi_1424_: vec4<f32>;
    var phi_1425_: vec4<f32>;
    var phi_1350_: vec4<f32>;
    var phi_1353_: vec4<f32>;
    var phi_1355_: u32;
    var local_28: vec4<f32>;
    var local_29: vec4<f32>;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var phi_1448_: vec4<f32>;
    var phi_1271_: vec4<f32>;
    var phi_1274_: u32;
    var phi_1272_: vec4<f32>;
    var phi_1275_: u32;
    var phi_1449_: vec4<f32>;
    var phi_1463_: vec4<f32>;
    var phi_1466_: u32;
    var phi_1600_: vec4<f32>;
    var phi_1603_: vec4<f32>;
    var phi_1605_: u32;
    var phi_1675_: vec4<f32>;
    var phi_1676_: vec4<f32>;
    var phi_1601_: vec4<f32>;
    var phi_1604_: vec4<f32>;
    var phi_1606_: u32;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var local_36: vec4<f32>;
    var local_37: vec4<f32>;
    var local_38: vec4<f32>;
    var local_39: vec4<f32>;
    var phi_1699_: vec4<f32>;
    var phi_1522_: vec4<f32>;
    var phi_1525_: u32;
    var phi_1523_: vec4<f32>;
    var phi_1526_: u32;
    var phi_1700_: vec4<f32>;
    var phi_1714_: vec4<f32>;
    var phi_1717_: u32;
    var phi_1851_: vec4<f32>;
    var phi_1854_: vec4<f32>;
    var phi_1856_: u32;
    var phi_1926_: vec4<f32>;
    var phi_1927_: vec4<f32>;
    var phi_1852_: vec4<f32>;
    var phi_1855_: vec4<f32>;
    var phi_1857_: u32;
    var local_40: vec4<f32>;
    var local_41: vec4<f32>;
    var local_42: vec4<f32>;
    var local_43: vec4<f32>;
    var local_44: vec4<f32>;
    var local_45: vec4<f32>;
    var phi_1950_: vec4<f32>;
    var phi_1773_: vec4<f32>;
    var phi_1776_: u32;
    var phi_1774_: vec4<f32>;
    var phi_1777_: u32;
    var phi_1951_: vec4<f32>;
    var phi_1965_: vec4<f32>;
    var phi_1968_: u32;
    var phi_2102_: vec4<f32>;
    var phi_2105_: vec4<f32>;
    var phi_2107_: u32;
    var phi_2177_: vec4<f32>;
    var phi_2178_: vec4<f32>;
    var phi_2103_: vec4<f32>;
    var phi_2106_: vec4<f32>;
    var phi_2108_: u32;
    var local_46: vec4<f32>;
    var local_47: vec4<f32>;
    var local_48: vec4<f32>;
    var local_49: vec4<f32>;
    var local_50: vec4<f32>;
    var local_51: vec4<f32>;
    var phi_2201_: vec4<f32>;
    var phi_2024_: vec4<f32>;
    var phi_2027_: u32;
    var phi_2025_: vec4<f32>;
    var phi_2028_: u32;
    var phi_2202_: vec4<f32>;
    var phi_2216_: vec4<f32>;
    var phi_2369_: vec4<f32>;
    var phi_2406_: vec4<f32>;
    var phi_2455_: vec4<f32>;
    var phi_2502_: vec4<f32>;
    var phi_2314_: vec4<f32>;
    var phi_2516_: vec4<f32>;
    var local_52: u32;
    var local_53: vec4<f32>;
    var local_54: u32;
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
                phi_130_ = type_11(0u, 6u);
                phi_133_ = _e75;
                loop {
                    let _e77 = phi_130_;
                    let _e79 = phi_133_;
                    local_52 = _e79;
                    local_1 = _e79;
                    local_54 = _e79;
                    local_8 = _e79;
                    local_9 = _e79;
                    local_56 = _e79;
                    if (_e77.member < _e77.member_1) {
                        phi_131_ = type_11((_e77.member + 1u), _e77.member_1);
                        phi_156_ = type_11(1u, _e77.member);
                    } else {
                        phi_131_ = _e77;
                        phi_156_ = type_11(0u, type_11().member_1);
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
                        phi_267_ = vec4<f32>(0f, 0f, 0f, 0f);
                        let _e2287 = local_54;
                        phi_270_ = _e2287;
                        loop {
                            let _e283 = phi_267_;
                            let _e285 = phi_270_;
                            local_55 = _e283;
                            let _e287 = local_8;
                            let _e289 = (_e285 < (_e287 + _e178));
                            if _e289 {
                                let _e290 = (2u * _e285);
                                let _e294 = radiance.member[_e290][0u];
                                let _e298 = radiance.member[_e290][1u];
                                let _e302 = radiance.member[_e290][2u];
                                let _e303 = (_e290 + 1u);
                                let _e307 = radiance.member[_e303][0u];
                                let _e311 = radiance.member[_e303][1u];
                                let _e315 = radiance.member[_e303][2u];
                                let _e325 = facets.member[_e285].member_2;
                                let _e334 = sqrt((((_e325[0] * _e325[0]) + (_e325[1] * _e325[1])) + (_e325[2] * _e325[2])));
                                phi_268_ = vec4<f32>((_e283.x + (select(_e307, _e294, (_e294 > _e307)) * _e334)), (_e283.y + (select(_e311, _e298, (_e298 > _e311)) * _e334)), (_e283.z + (select(_e315, _e302, (_e302 > _e315)) * _e334)), (_e283.w + _e334));
                                phi_271_ = (_e285 + 1u);
                            } else {
                                phi_268_ = vec4<f32>();
                                phi_271_ = u32();
                            }
                            let _e349 = phi_268_;
                            let _e351 = phi_271_;
                            continue;
                            continuing {
                                phi_267_ = _e349;
                                phi_270_ = _e351;
                                break if !(_e289);
                            }
                        }
                        let _e2293 = local_55;
                        phi_445_ = _e2293;
                    } else {
                        phi_345_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_348_ = vec4<f32>(0f, 0f, 0f, 0f);
                        let _e2268 = local_52;
                        phi_350_ = _e2268;
                        loop {
                            let _e181 = phi_345_;
                            let _e183 = phi_348_;
                            let _e185 = phi_350_;
                            local_2 = _e181;
                            local_3 = _e183;
                            local_4 = _e181;
                            local_5 = _e181;
                            local_6 = _e181;
                            local_7 = _e183;
                            local_53 = _e183;
                            let _e187 = local_1;
                            let _e189 = (_e185 < (_e187 + _e178));
                            if _e189 {
                                let _e193 = facets.member[_e185].member_2;
                                let _e202 = -((((_e118 * _e193[0]) + (_e120 * _e193[1])) + (_e122 * _e193[2])));
                                if (_e202 > 0f) {
                                    let _e227 = radiance.member[(2u * _e185)];
                                    phi_420_ = _e181;
                                    phi_421_ = vec4<f32>((_e183.x + (_e227.x * _e202)), (_e183.y + (_e227.y * _e202)), (_e183.z + (_e227.z * _e202)), (_e183.w + _e202));
                                } else {
                                    let _e208 = radiance.member[((2u * _e185) + 1u)];
                                    phi_420_ = vec4<f32>((_e181.x - (_e208.x * _e202)), (_e181.y - (_e208.y * _e202)), (_e181.z - (_e208.z * _e202)), (_e181.w - _e202));
                                    phi_421_ = _e183;
                                }
                                let _e244 = phi_420_;
                                let _e246 = phi_421_;
                                phi_346_ = _e244;
                                phi_349_ = _e246;
                                phi_351_ = (_e185 + 1u);
                            } else {
                                phi_346_ = vec4<f32>();
                                phi_349_ = vec4<f32>();
                                phi_351_ = u32();
                            }
                            let _e249 = phi_346_;
                            let _e251 = phi_349_;
                            let _e253 = phi_351_;
                            continue;
                            continuing {
                                phi_345_ = _e249;
                                phi_348_ = _e251;
                                phi_350_ = _e253;
                                break if !(_e189);
                            }
                        }
                        let _e256 = local_2;
                        let _e259 = local_3;
                        if (_e256.w > _e259.w) {
                            let _e262 = (_e256.w - _e259.w);
                            let _e263 = (_e262 / _e256.w);
                            let _e265 = local_4;
                            let _e269 = local_5;
                            let _e273 = local_6;
                            let _e278 = local_7;
                            phi_444_ = (_e278 + vec4<f32>((_e265.x * _e263), (_e269.y * _e263), (_e273.z * _e263), _e262));
                        } else {
                            let _e2283 = local_53;
                            phi_444_ = _e2283;
                        }
                        let _e281 = phi_444_;
                        phi_445_ = _e281;
                    }
                    let _e354 = phi_445_;
                    if (_e354.w > 1f) {
                        phi_459_ = vec4<f32>((_e354.x / _e354.w), (_e354.y / _e354.w), (_e354.z / _e354.w), 1f);
                    } else {
                        phi_459_ = _e354;
                    }
                    let _e365 = phi_459_;
                    local[0u] = _e365;
                    let _e367 = local_9;
                    phi_462_ = (_e367 + _e178);
                } else {
                    let _e2298 = local_56;
                    phi_462_ = _e2298;
                }
                let _e370 = phi_462_;
                if (((_e70 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    let _e378 = facet_bits.member[_e71];
                    let _e379 = ((_e63 + 1u) & 31u);
                    let _e386 = facet_bits.member[(_e71 + 1u)];
                    let _e394 = facet_bits.member[(_e71 + 2u)];
                    let _e402 = facet_bits.member[(_e71 + 3u)];
                    let _e410 = facet_bits.member[(_e71 + 4u)];
                    let _e418 = facet_bits.member[(_e71 + 5u)];
                    let _e422 = (((((((_e378 >> bitcast<u32>(_e379)) & 1u) + ((_e386 >> bitcast<u32>(_e379)) & 1u)) + ((_e394 >> bitcast<u32>(_e379)) & 1u)) + ((_e402 >> bitcast<u32>(_e379)) & 1u)) + ((_e410 >> bitcast<u32>(_e379)) & 1u)) + ((_e418 >> bitcast<u32>(_e379)) & 1u));
                    if (_e52 == 1u) {
                        phi_518_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_521_ = _e370;
                        loop {
                            let _e525 = phi_518_;
                            let _e527 = phi_521_;
                            local_58 = _e525;
                            let _e529 = (_e527 < (_e370 + _e422));
                            if _e529 {
                                let _e530 = (2u * _e527);
                                let _e534 = radiance.member[_e530][0u];
                                let _e538 = radiance.member[_e530][1u];
                                let _e542 = radiance.member[_e530][2u];
                                let _e543 = (_e530 + 1u);
                                let _e547 = radiance.member[_e543][0u];
                                let _e551 = radiance.member[_e543][1u];
                                let _e555 = radiance.member[_e543][2u];
                                let _e565 = facets.member[_e527].member_2;
                                let _e574 = sqrt((((_e565[0] * _e565[0]) + (_e565[1] * _e565[1])) + (_e565[2] * _e565[2])));
                                phi_519_ = vec4<f32>((_e525.x + (select(_e547, _e534, (_e534 > _e547)) * _e574)), (_e525.y + (select(_e551, _e538, (_e538 > _e551)) * _e574)), (_e525.z + (select(_e555, _e542, (_e542 > _e555)) * _e574)), (_e525.w + _e574));
                                phi_522_ = (_e527 + 1u);
                            } else {
                                phi_519_ = vec4<f32>();
                                phi_522_ = u32();
                            }
                            let _e589 = phi_519_;
                            let _e591 = phi_522_;
                            continue;
                            continuing {
                                phi_518_ = _e589;
                                phi_521_ = _e591;
                                break if !(_e529);
                            }
                        }
                        let _e2322 = local_58;
                        phi_696_ = _e2322;
                    } else {
                        phi_596_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_599_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_601_ = _e370;
                        loop {
                            let _e425 = phi_596_;
                            let _e427 = phi_599_;
                            let _e429 = phi_601_;
                            local_10 = _e425;
                            local_11 = _e427;
                            local_12 = _e425;
                            local_13 = _e425;
                            local_14 = _e425;
                            local_15 = _e427;
                            local_57 = _e427;
                            let _e431 = (_e429 < (_e370 + _e422));
                            if _e431 {
                                let _e435 = facets.member[_e429].member_2;
                                let _e444 = -((((_e118 * _e435[0]) + (_e120 * _e435[1])) + (_e122 * _e435[2])));
                                if (_e444 > 0f) {
                                    let _e469 = radiance.member[(2u * _e429)];
                                    phi_671_ = _e425;
                                    phi_672_ = vec4<f32>((_e427.x + (_e469.x * _e444)), (_e427.y + (_e469.y * _e444)), (_e427.z + (_e469.z * _e444)), (_e427.w + _e444));
                                } else {
                                    let _e450 = radiance.member[((2u * _e429) + 1u)];
                                    phi_671_ = vec4<f32>((_e425.x - (_e450.x * _e444)), (_e425.y - (_e450.y * _e444)), (_e425.z - (_e450.z * _e444)), (_e425.w - _e444));
                                    phi_672_ = _e427;
                                }
                                let _e486 = phi_671_;
                                let _e488 = phi_672_;
                                phi_597_ = _e486;
                                phi_600_ = _e488;
                                phi_602_ = (_e429 + 1u);
                            } else {
                                phi_597_ = vec4<f32>();
                                phi_600_ = vec4<f32>();
                                phi_602_ = u32();
                            }
                            let _e491 = phi_597_;
                            let _e493 = phi_600_;
                            let _e495 = phi_602_;
                            continue;
                            continuing {
                                phi_596_ = _e491;
                                phi_599_ = _e493;
                                phi_601_ = _e495;
                                break if !(_e431);
                            }
                        }
                        let _e498 = local_10;
                        let _e501 = local_11;
                        if (_e498.w > _e501.w) {
                            let _e504 = (_e498.w - _e501.w);
                            let _e505 = (_e504 / _e498.w);
                            let _e507 = local_12;
                            let _e511 = local_13;
                            let _e515 = local_14;
                            let _e520 = local_15;
                            phi_695_ = (_e520 + vec4<f32>((_e507.x * _e505), (_e511.y * _e505), (_e515.z * _e505), _e504));
                        } else {
                            let _e2315 = local_57;
                            phi_695_ = _e2315;
                        }
                        let _e523 = phi_695_;
                        phi_696_ = _e523;
                    }
                    let _e594 = phi_696_;
                    if (_e594.w > 1f) {
                        phi_710_ = vec4<f32>((_e594.x / _e594.w), (_e594.y / _e594.w), (_e594.z / _e594.w), 1f);
                    } else {
                        phi_710_ = _e594;
                    }
                    let _e605 = phi_710_;
                    local[1u] = _e605;
                    phi_713_ = (_e370 + _e422);
                } else {
                    phi_713_ = _e370;
                }
                let _e608 = phi_713_;
                if (((_e70 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    let _e616 = facet_bits.member[_e71];
                    let _e617 = ((_e63 + 2u) & 31u);
                    let _e624 = facet_bits.member[(_e71 + 1u)];
                    let _e632 = facet_bits.member[(_e71 + 2u)];
                    let _e640 = facet_bits.member[(_e71 + 3u)];
                    let _e648 = facet_bits.member[(_e71 + 4u)];
                    let _e656 = facet_bits.member[(_e71 + 5u)];
                    let _e660 = (((((((_e616 >> bitcast<u32>(_e617)) & 1u) + ((_e624 >> bitcast<u32>(_e617)) & 1u)) + ((_e632 >> bitcast<u32>(_e617)) & 1u)) + ((_e640 >> bitcast<u32>(_e617)) & 1u)) + ((_e648 >> bitcast<u32>(_e617)) & 1u)) + ((_e656 >> bitcast<u32>(_e617)) & 1u));
                    if (_e52 == 1u) {
                        phi_769_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_772_ = _e608;
                        loop {
                            let _e763 = phi_769_;
                            let _e765 = phi_772_;
                            local_60 = _e763;
                            let _e767 = (_e765 < (_e608 + _e660));
                            if _e767 {
                                let _e768 = (2u * _e765);
                                let _e772 = radiance.member[_e768][0u];
                                let _e776 = radiance.member[_e768][1u];
                                let _e780 = radiance.member[_e768][2u];
                                let _e781 = (_e768 + 1u);
                                let _e785 = radiance.member[_e781][0u];
                                let _e789 = radiance.member[_e781][1u];
                                let _e793 = radiance.member[_e781][2u];
                                let _e803 = facets.member[_e765].member_2;
                                let _e812 = sqrt((((_e803[0] * _e803[0]) + (_e803[1] * _e803[1])) + (_e803[2] * _e803[2])));
                                phi_770_ = vec4<f32>((_e763.x + (select(_e785, _e772, (_e772 > _e785)) * _e812)), (_e763.y + (select(_e789, _e776, (_e776 > _e789)) * _e812)), (_e763.z + (select(_e793, _e780, (_e780 > _e793)) * _e812)), (_e763.w + _e812));
                                phi_773_ = (_e765 + 1u);
                            } else {
                                phi_770_ = vec4<f32>();
                                phi_773_ = u32();
                            }
                            let _e827 = phi_770_;
                            let _e829 = phi_773_;
                            continue;
                            continuing {
                                phi_769_ = _e827;
                                phi_772_ = _e829;
                                break if !(_e767);
                            }
                        }
                        let _e2348 = local_60;
                        phi_947_ = _e2348;
                    } else {
                        phi_847_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_850_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_852_ = _e608;
                        loop {
                            let _e663 = phi_847_;
                            let _e665 = phi_850_;
                            let _e667 = phi_852_;
                            local_16 = _e663;
                            local_17 = _e665;
                            local_18 = _e663;
                            local_19 = _e663;
                            local_20 = _e663;
                            local_21 = _e665;
                            local_59 = _e665;
                            let _e669 = (_e667 < (_e608 + _e660));
                            if _e669 {
                                let _e673 = facets.member[_e667].member_2;
                                let _e682 = -((((_e118 * _e673[0]) + (_e120 * _e673[1])) + (_e122 * _e673[2])));
                                if (_e682 > 0f) {
                                    let _e707 = radiance.member[(2u * _e667)];
                                    phi_922_ = _e663;
                                    phi_923_ = vec4<f32>((_e665.x + (_e707.x * _e682)), (_e665.y + (_e707.y * _e682)), (_e665.z + (_e707.z * _e682)), (_e665.w + _e682));
                                } else {
                                    let _e688 = radiance.member[((2u * _e667) + 1u)];
                                    phi_922_ = vec4<f32>((_e663.x - (_e688.x * _e682)), (_e663.y - (_e688.y * _e682)), (_e663.z - (_e688.z * _e682)), (_e663.w - _e682));
                                    phi_923_ = _e665;
                                }
                                let _e724 = phi_922_;
                                let _e726 = phi_923_;
                                phi_848_ = _e724;
                                phi_851_ = _e726;
                                phi_853_ = (_e667 + 1u);
                            } else {
                                phi_848_ = vec4<f32>();
                                phi_851_ = vec4<f32>();
                                phi_853_ = u32();
                            }
                            let _e729 = phi_848_;
                            let _e731 = phi_851_;
                            let _e733 = phi_853_;
                            continue;
                            continuing {
                                phi_847_ = _e729;
                                phi_850_ = _e731;
                                phi_852_ = _e733;
                                break if !(_e669);
                            }
                        }
                        let _e736 = local_16;
                        let _e739 = local_17;
                        if (_e736.w > _e739.w) {
                            let _e742 = (_e736.w - _e739.w);
                            let _e743 = (_e742 / _e736.w);
                            let _e745 = local_18;
                            let _e749 = local_19;
                            let _e753 = local_20;
                            let _e758 = local_21;
                            phi_946_ = (_e758 + vec4<f32>((_e745.x * _e743), (_e749.y * _e743), (_e753.z * _e743), _e742));
                        } else {
                            let _e2341 = local_59;
                            phi_946_ = _e2341;
                        }
                        let _e761 = phi_946_;
                        phi_947_ = _e761;
                    }
                    let _e832 = phi_947_;
                    if (_e832.w > 1f) {
                        phi_961_ = vec4<f32>((_e832.x / _e832.w), (_e832.y / _e832.w), (_e832.z / _e832.w), 1f);
                    } else {
                        phi_961_ = _e832;
                    }
                    let _e843 = phi_961_;
                    local[2u] = _e843;
                    phi_964_ = (_e608 + _e660);
                } else {
                    phi_964_ = _e608;
                }
                let _e846 = phi_964_;
                if (((_e70 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    let _e854 = facet_bits.member[_e71];
                    let _e855 = ((_e63 + 3u) & 31u);
                    let _e862 = facet_bits.member[(_e71 + 1u)];
                    let _e870 = facet_bits.member[(_e71 + 2u)];
                    let _e878 = facet_bits.member[(_e71 + 3u)];
                    let _e886 = facet_bits.member[(_e71 + 4u)];
                    let _e894 = facet_bits.member[(_e71 + 5u)];
                    let _e898 = (((((((_e854 >> bitcast<u32>(_e855)) & 1u) + ((_e862 >> bitcast<u32>(_e855)) & 1u)) + ((_e870 >> bitcast<u32>(_e855)) & 1u)) + ((_e878 >> bitcast<u32>(_e855)) & 1u)) + ((_e886 >> bitcast<u32>(_e855)) & 1u)) + ((_e894 >> bitcast<u32>(_e855)) & 1u));
                    if (_e52 == 1u) {
                        phi_1020_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1023_ = _e846;
                        loop {
                            let _e1001 = phi_1020_;
                            let _e1003 = phi_1023_;
                            local_62 = _e1001;
                            let _e1005 = (_e1003 < (_e846 + _e898));
                            if _e1005 {
                                let _e1006 = (2u * _e1003);
                                let _e1010 = radiance.member[_e1006][0u];
                                let _e1014 = radiance.member[_e1006][1u];
                                let _e1018 = radiance.member[_e1006][2u];
                                let _e1019 = (_e1006 + 1u);
                                let _e1023 = radiance.member[_e1019][0u];
                                let _e1027 = radiance.member[_e1019][1u];
                                let _e1031 = radiance.member[_e1019][2u];
                                let _e1041 = facets.member[_e1003].member_2;
                                let _e1050 = sqrt((((_e1041[0] * _e1041[0]) + (_e1041[1] * _e1041[1])) + (_e1041[2] * _e1041[2])));
                                phi_1021_ = vec4<f32>((_e1001.x + (select(_e1023, _e1010, (_e1010 > _e1023)) * _e1050)), (_e1001.y + (select(_e1027, _e1014, (_e1014 > _e1027)) * _e1050)), (_e1001.z + (select(_e1031, _e1018, (_e1018 > _e1031)) * _e1050)), (_e1001.w + _e1050));
                                phi_1024_ = (_e1003 + 1u);
                            } else {
                                phi_1021_ = vec4<f32>();
                                phi_1024_ = u32();
                            }
                            let _e1065 = phi_1021_;
                            let _e1067 = phi_1024_;
                            continue;
                            continuing {
                                phi_1020_ = _e1065;
                                phi_1023_ = _e1067;
                                break if !(_e1005);
                            }
                        }
                        let _e2374 = local_62;
                        phi_1198_ = _e2374;
                    } else {
                        phi_1098_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1101_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1103_ = _e846;
                        loop {
                            let _e901 = phi_1098_;
                            let _e903 = phi_1101_;
                            let _e905 = phi_1103_;
                            local_22 = _e901;
                            local_23 = _e903;
                            local_24 = _e901;
                            local_25 = _e901;
                            local_26 = _e901;
                            local_27 = _e903;
                            local_61 = _e903;
                            let _e907 = (_e905 < (_e846 + _e898));
                            if _e907 {
                                let _e911 = facets.member[_e905].member_2;
                                let _e920 = -((((_e118 * _e911[0]) + (_e120 * _e911[1])) + (_e122 * _e911[2])));
                                if (_e920 > 0f) {
                                    let _e945 = radiance.member[(2u * _e905)];
                                    phi_1173_ = _e901;
                                    phi_1174_ = vec4<f32>((_e903.x + (_e945.x * _e920)), (_e903.y + (_e945.y * _e920)), (_e903.z + (_e945.z * _e920)), (_e903.w + _e920));
                                } else {
                                    let _e926 = radiance.member[((2u * _e905) + 1u)];
                                    phi_1173_ = vec4<f32>((_e901.x - (_e926.x * _e920)), (_e901.y - (_e926.y * _e920)), (_e901.z - (_e926.z * _e920)), (_e901.w - _e920));
                                    phi_1174_ = _e903;
                                }
                                let _e962 = phi_1173_;
                                let _e964 = phi_1174_;
                                phi_1099_ = _e962;
                                phi_1102_ = _e964;
                                phi_1104_ = (_e905 + 1u);
                            } else {
                                phi_1099_ = vec4<f32>();
                                phi_1102_ = vec4<f32>();
                                phi_1104_ = u32();
                            }
                            let _e967 = phi_1099_;
                            let _e969 = phi_1102_;
                            let _e971 = phi_1104_;
                            continue;
                            continuing {
                                phi_1098_ = _e967;
                                phi_1101_ = _e969;
                                phi_1103_ = _e971;
                                break if !(_e907);
                            }
                        }
                        let _e974 = local_22;
                        let _e977 = local_23;
                        if (_e974.w > _e977.w) {
                            let _e980 = (_e974.w - _e977.w);
                            let _e981 = (_e980 / _e974.w);
                            let _e983 = local_24;
                            let _e987 = local_25;
                            let _e991 = local_26;
                            let _e996 = local_27;
                            phi_1197_ = (_e996 + vec4<f32>((_e983.x * _e981), (_e987.y * _e981), (_e991.z * _e981), _e980));
                        } else {
                            let _e2367 = local_61;
                            phi_1197_ = _e2367;
                        }
                        let _e999 = phi_1197_;
                        phi_1198_ = _e999;
                    }
                    let _e1070 = phi_1198_;
                    if (_e1070.w > 1f) {
                        phi_1212_ = vec4<f32>((_e1070.x / _e1070.w), (_e1070.y / _e1070.w), (_e1070.z / _e1070.w), 1f);
                    } else {
                        phi_1212_ = _e1070;
                    }
                    let _e1081 = phi_1212_;
                    local[3u] = _e1081;
                    phi_1215_ = (_e846 + _e898);
                } else {
                    phi_1215_ = _e846;
                }
                let _e1084 = phi_1215_;
                if (((_e70 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    let _e1092 = facet_bits.member[_e71];
                    let _e1093 = ((_e63 + 4u) & 31u);
                    let _e1100 = facet_bits.member[(_e71 + 1u)];
                    let _e1108 = facet_bits.member[(_e71 + 2u)];
                    let _e1116 = facet_bits.member[(_e71 + 3u)];
                    let _e1124 = facet_bits.member[(_e71 + 4u)];
                    let _e1132 = facet_bits.member[(_e71 + 5u)];
                    let _e1136 = (((((((_e1092 >> bitcast<u32>(_e1093)) & 1u) + ((_e1100 >> bitcast<u32>(_e1093)) & 1u)) + ((_e1108 >> bitcast<u32>(_e1093)) & 1u)) + ((_e1116 >> bitcast<u32>(_e1093)) & 1u)) + ((_e1124 >> bitcast<u32>(_e1093)) & 1u)) + ((_e1132 >> bitcast<u32>(_e1093)) & 1u));
                    if (_e52 == 1u) {
                        phi_1271_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1274_ = _e1084;
                        loop {
                            let _e1239 = phi_1271_;
                            let _e1241 = phi_1274_;
                            local_64 = _e1239;
                            let _e1243 = (_e1241 < (_e1084 + _e1136));
                            if _e1243 {
                                let _e1244 = (2u * _e1241);
                                let _e1248 = radiance.member[_e1244][0u];
                                let _e1252 = radiance.member[_e1244][1u];
                                let _e1256 = radiance.member[_e1244][2u];
                                let _e1257 = (_e1244 + 1u);
                                let _e1261 = radiance.member[_e1257][0u];
                                let _e1265 = radiance.member[_e1257][1u];
                                let _e1269 = radiance.member[_e1257][2u];
                                let _e1279 = facets.member[_e1241].member_2;
                                let _e1288 = sqrt((((_e1279[0] * _e1279[0]) + (_e1279[1] * _e1279[1])) + (_e1279[2] * _e1279[2])));
                                phi_1272_ = vec4<f32>((_e1239.x + (select(_e1261, _e1248, (_e1248 > _e1261)) * _e1288)), (_e1239.y + (select(_e1265, _e1252, (_e1252 > _e1265)) * _e1288)), (_e1239.z + (select(_e1269, _e1256, (_e1256 > _e1269)) * _e1288)), (_e1239.w + _e1288));
                                phi_1275_ = (_e1241 + 1u);
                            } else {
                                phi_1272_ = vec4<f32>();
                                phi_1275_ = u32();
                            }
                            let _e1303 = phi_1272_;
                            let _e1305 = phi_1275_;
                            continue;
                            continuing {
                                phi_1271_ = _e1303;
                                phi_1274_ = _e1305;
                                break if !(_e1243);
                            }
                        }
                        let _e2400 = local_64;
                        phi_1449_ = _e2400;
                    } else {
                        phi_1349_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1352_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1354_ = _e1084;
                        loop {
                            let _e1139 = phi_1349_;
                            let _e1141 = phi_1352_;
                            let _e1143 = phi_1354_;
                            local_28 = _e1139;
                            local_29 = _e1141;
                            local_30 = _e1139;
                            local_31 = _e1139;
                            local_32 = _e1139;
                            local_33 = _e1141;
                            local_63 = _e1141;
                            let _e1145 = (_e1143 < (_e1084 + _e1136));
                            if _e1145 {
                                let _e1149 = facets.member[_e1143].member_2;
                                let _e1158 = -((((_e118 * _e1149[0]) + (_e120 * _e1149[1])) + (_e122 * _e1149[2])));
                                if (_e1158 > 0f) {
                                    let _e1183 = radiance.member[(2u * _e1143)];
                                    phi_1424_ = _e1139;
                                    phi_1425_ = vec4<f32>((_e1141.x + (_e1183.x * _e1158)), (_e1141.y + (_e1183.y * _e1158)), (_e1141.z + (_e1183.z * _e1158)), (_e1141.w + _e1158));
                                } else {
                                    let _e1164 = radiance.member[((2u * _e1143) + 1u)];
                                    phi_1424_ = vec4<f32>((_e1139.x - (_e1164.x * _e1158)), (_e1139.y - (_e1164.y * _e1158)), (_e1139.z - (_e1164.z * _e1158)), (_e1139.w - _e1158));
                                    phi_1425_ = _e1141;
                                }
                                let _e1200 = phi_1424_;
                                let _e1202 = phi_1425_;
                                phi_1350_ = _e1200;
                                phi_1353_ = _e1202;
                                phi_1355_ = (_e1143 + 1u);
                            } else {
                                phi_1350_ = vec4<f32>();
                                phi_1353_ = vec4<f32>();
                                phi_1355_ = u32();
                            }
                            let _e1205 = phi_1350_;
                            let _e1207 = phi_1353_;
                            let _e1209 = phi_1355_;
                            continue;
                            continuing {
                                phi_1349_ = _e1205;
                                phi_1352_ = _e1207;
                                phi_1354_ = _e1209;
                                break if !(_e1145);
                            }
                        }
                        let _e1212 = local_28;
                        let _e1215 = local_29;
                        if (_e1212.w > _e1215.w) {
                            let _e1218 = (_e1212.w - _e1215.w);
                            let _e1219 = (_e1218 / _e1212.w);
                            let _e1221 = local_30;
                            let _e1225 = local_31;
                            let _e1229 = local_32;
                            let _e1234 = local_33;
                            phi_1448_ = (_e1234 + vec4<f32>((_e1221.x * _e1219), (_e1225.y * _e1219), (_e1229.z * _e1219), _e1218));
                        } else {
                            let _e2393 = local_63;
                            phi_1448_ = _e2393;
                        }
                        let _e1237 = phi_1448_;
                        phi_1449_ = _e1237;
                    }
                    let _e1308 = phi_1449_;
                    if (_e1308.w > 1f) {
                        phi_1463_ = vec4<f32>((_e1308.x / _e1308.w), (_e1308.y / _e1308.w), (_e1308.z / _e1308.w), 1f);
                    } else {
                        phi_1463_ = _e1308;
                    }
                    let _e1319 = phi_1463_;
                    local[4u] = _e1319;
                    phi_1466_ = (_e1084 + _e1136);
                } else {
                    phi_1466_ = _e1084;
                }
                let _e1322 = phi_1466_;
                if (((_e70 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    let _e1330 = facet_bits.member[_e71];
                    let _e1331 = ((_e63 + 5u) & 31u);
                    let _e1338 = facet_bits.member[(_e71 + 1u)];
                    let _e1346 = facet_bits.member[(_e71 + 2u)];
                    let _e1354 = facet_bits.member[(_e71 + 3u)];
                    let _e1362 = facet_bits.member[(_e71 + 4u)];
                    let _e1370 = facet_bits.member[(_e71 + 5u)];
                    let _e1374 = (((((((_e1330 >> bitcast<u32>(_e1331)) & 1u) + ((_e1338 >> bitcast<u32>(_e1331)) & 1u)) + ((_e1346 >> bitcast<u32>(_e1331)) & 1u)) + ((_e1354 >> bitcast<u32>(_e1331)) & 1u)) + ((_e1362 >> bitcast<u32>(_e1331)) & 1u)) + ((_e1370 >> bitcast<u32>(_e1331)) & 1u));
                    if (_e52 == 1u) {
                        phi_1522_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1525_ = _e1322;
                        loop {
                            let _e1477 = phi_1522_;
                            let _e1479 = phi_1525_;
                            local_66 = _e1477;
                            let _e1481 = (_e1479 < (_e1322 + _e1374));
                            if _e1481 {
                                let _e1482 = (2u * _e1479);
                                let _e1486 = radiance.member[_e1482][0u];
                                let _e1490 = radiance.member[_e1482][1u];
                                let _e1494 = radiance.member[_e1482][2u];
                                let _e1495 = (_e1482 + 1u);
                                let _e1499 = radiance.member[_e1495][0u];
                                let _e1503 = radiance.member[_e1495][1u];
                                let _e1507 = radiance.member[_e1495][2u];
                                let _e1517 = facets.member[_e1479].member_2;
                                let _e1526 = sqrt((((_e1517[0] * _e1517[0]) + (_e1517[1] * _e1517[1])) + (_e1517[2] * _e1517[2])));
                                phi_1523_ = vec4<f32>((_e1477.x + (select(_e1499, _e1486, (_e1486 > _e1499)) * _e1526)), (_e1477.y + (select(_e1503, _e1490, (_e1490 > _e1503)) * _e1526)), (_e1477.z + (select(_e1507, _e1494, (_e1494 > _e1507)) * _e1526)), (_e1477.w + _e1526));
                                phi_1526_ = (_e1479 + 1u);
                            } else {
                                phi_1523_ = vec4<f32>();
                                phi_1526_ = u32();
                            }
                            let _e1541 = phi_1523_;
                            let _e1543 = phi_1526_;
                            continue;
                            continuing {
                                phi_1522_ = _e1541;
                                phi_1525_ = _e1543;
                                break if !(_e1481);
                            }
                        }
                        let _e2426 = local_66;
                        phi_1700_ = _e2426;
                    } else {
                        phi_1600_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1603_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1605_ = _e1322;
                        loop {
                            let _e1377 = phi_1600_;
                            let _e1379 = phi_1603_;
                            let _e1381 = phi_1605_;
                            local_34 = _e1377;
                            local_35 = _e1379;
                            local_36 = _e1377;
                            local_37 = _e1377;
                            local_38 = _e1377;
                            local_39 = _e1379;
                            local_65 = _e1379;
                            let _e1383 = (_e1381 < (_e1322 + _e1374));
                            if _e1383 {
                                let _e1387 = facets.member[_e1381].member_2;
                                let _e1396 = -((((_e118 * _e1387[0]) + (_e120 * _e1387[1])) + (_e122 * _e1387[2])));
                                if (_e1396 > 0f) {
                                    let _e1421 = radiance.member[(2u * _e1381)];
                                    phi_1675_ = _e1377;
                                    phi_1676_ = vec4<f32>((_e1379.x + (_e1421.x * _e1396)), (_e1379.y + (_e1421.y * _e1396)), (_e1379.z + (_e1421.z * _e1396)), (_e1379.w + _e1396));
                                } else {
                                    let _e1402 = radiance.member[((2u * _e1381) + 1u)];
                                    phi_1675_ = vec4<f32>((_e1377.x - (_e1402.x * _e1396)), (_e1377.y - (_e1402.y * _e1396)), (_e1377.z - (_e1402.z * _e1396)), (_e1377.w - _e1396));
                                    phi_1676_ = _e1379;
                                }
                                let _e1438 = phi_1675_;
                                let _e1440 = phi_1676_;
                                phi_1601_ = _e1438;
                                phi_1604_ = _e1440;
                                phi_1606_ = (_e1381 + 1u);
                            } else {
                                phi_1601_ = vec4<f32>();
                                phi_1604_ = vec4<f32>();
                                phi_1606_ = u32();
                            }
                            let _e1443 = phi_1601_;
                            let _e1445 = phi_1604_;
                            let _e1447 = phi_1606_;
                            continue;
                            continuing {
                                phi_1600_ = _e1443;
                                phi_1603_ = _e1445;
                                phi_1605_ = _e1447;
                                break if !(_e1383);
                            }
                        }
                        let _e1450 = local_34;
                        let _e1453 = local_35;
                        if (_e1450.w > _e1453.w) {
                            let _e1456 = (_e1450.w - _e1453.w);
                            let _e1457 = (_e1456 / _e1450.w);
                            let _e1459 = local_36;
                            let _e1463 = local_37;
                            let _e1467 = local_38;
                            let _e1472 = local_39;
                            phi_1699_ = (_e1472 + vec4<f32>((_e1459.x * _e1457), (_e1463.y * _e1457), (_e1467.z * _e1457), _e1456));
                        } else {
                            let _e2419 = local_65;
                            phi_1699_ = _e2419;
                        }
                        let _e1475 = phi_1699_;
                        phi_1700_ = _e1475;
                    }
                    let _e1546 = phi_1700_;
                    if (_e1546.w > 1f) {
                        phi_1714_ = vec4<f32>((_e1546.x / _e1546.w), (_e1546.y / _e1546.w), (_e1546.z / _e1546.w), 1f);
                    } else {
                        phi_1714_ = _e1546;
                    }
                    let _e1557 = phi_1714_;
                    local[5u] = _e1557;
                    phi_1717_ = (_e1322 + _e1374);
                } else {
                    phi_1717_ = _e1322;
                }
                let _e1560 = phi_1717_;
                if (((_e70 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    let _e1568 = facet_bits.member[_e71];
                    let _e1569 = ((_e63 + 6u) & 31u);
                    let _e1576 = facet_bits.member[(_e71 + 1u)];
                    let _e1584 = facet_bits.member[(_e71 + 2u)];
                    let _e1592 = facet_bits.member[(_e71 + 3u)];
                    let _e1600 = facet_bits.member[(_e71 + 4u)];
                    let _e1608 = facet_bits.member[(_e71 + 5u)];
                    let _e1612 = (((((((_e1568 >> bitcast<u32>(_e1569)) & 1u) + ((_e1576 >> bitcast<u32>(_e1569)) & 1u)) + ((_e1584 >> bitcast<u32>(_e1569)) & 1u)) + ((_e1592 >> bitcast<u32>(_e1569)) & 1u)) + ((_e1600 >> bitcast<u32>(_e1569)) & 1u)) + ((_e1608 >> bitcast<u32>(_e1569)) & 1u));
                    if (_e52 == 1u) {
                        phi_1773_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1776_ = _e1560;
                        loop {
                            let _e1715 = phi_1773_;
                            let _e1717 = phi_1776_;
                            local_68 = _e1715;
                            let _e1719 = (_e1717 < (_e1560 + _e1612));
                            if _e1719 {
                                let _e1720 = (2u * _e1717);
                                let _e1724 = radiance.member[_e1720][0u];
                                let _e1728 = radiance.member[_e1720][1u];
                                let _e1732 = radiance.member[_e1720][2u];
                                let _e1733 = (_e1720 + 1u);
                                let _e1737 = radiance.member[_e1733][0u];
                                let _e1741 = radiance.member[_e1733][1u];
                                let _e1745 = radiance.member[_e1733][2u];
                                let _e1755 = facets.member[_e1717].member_2;
                                let _e1764 = sqrt((((_e1755[0] * _e1755[0]) + (_e1755[1] * _e1755[1])) + (_e1755[2] * _e1755[2])));
                                phi_1774_ = vec4<f32>((_e1715.x + (select(_e1737, _e1724, (_e1724 > _e1737)) * _e1764)), (_e1715.y + (select(_e1741, _e1728, (_e1728 > _e1741)) * _e1764)), (_e1715.z + (select(_e1745, _e1732, (_e1732 > _e1745)) * _e1764)), (_e1715.w + _e1764));
                                phi_1777_ = (_e1717 + 1u);
                            } else {
                                phi_1774_ = vec4<f32>();
                                phi_1777_ = u32();
                            }
                            let _e1779 = phi_1774_;
                            let _e1781 = phi_1777_;
                            continue;
                            continuing {
                                phi_1773_ = _e1779;
                                phi_1776_ = _e1781;
                                break if !(_e1719);
                            }
                        }
                        let _e2452 = local_68;
                        phi_1951_ = _e2452;
                    } else {
                        phi_1851_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1854_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_1856_ = _e1560;
                        loop {
                            let _e1615 = phi_1851_;
                            let _e1617 = phi_1854_;
                            let _e1619 = phi_1856_;
                            local_40 = _e1615;
                            local_41 = _e1617;
                            local_42 = _e1615;
                            local_43 = _e1615;
                            local_44 = _e1615;
                            local_45 = _e1617;
                            local_67 = _e1617;
                            let _e1621 = (_e1619 < (_e1560 + _e1612));
                            if _e1621 {
                                let _e1625 = facets.member[_e1619].member_2;
                                let _e1634 = -((((_e118 * _e1625[0]) + (_e120 * _e1625[1])) + (_e122 * _e1625[2])));
                                if (_e1634 > 0f) {
                                    let _e1659 = radiance.member[(2u * _e1619)];
                                    phi_1926_ = _e1615;
                                    phi_1927_ = vec4<f32>((_e1617.x + (_e1659.x * _e1634)), (_e1617.y + (_e1659.y * _e1634)), (_e1617.z + (_e1659.z * _e1634)), (_e1617.w + _e1634));
                                } else {
                                    let _e1640 = radiance.member[((2u * _e1619) + 1u)];
                                    phi_1926_ = vec4<f32>((_e1615.x - (_e1640.x * _e1634)), (_e1615.y - (_e1640.y * _e1634)), (_e1615.z - (_e1640.z * _e1634)), (_e1615.w - _e1634));
                                    phi_1927_ = _e1617;
                                }
                                let _e1676 = phi_1926_;
                                let _e1678 = phi_1927_;
                                phi_1852_ = _e1676;
                                phi_1855_ = _e1678;
                                phi_1857_ = (_e1619 + 1u);
                            } else {
                                phi_1852_ = vec4<f32>();
                                phi_1855_ = vec4<f32>();
                                phi_1857_ = u32();
                            }
                            let _e1681 = phi_1852_;
                            let _e1683 = phi_1855_;
                            let _e1685 = phi_1857_;
                            continue;
                            continuing {
                                phi_1851_ = _e1681;
                                phi_1854_ = _e1683;
                                phi_1856_ = _e1685;
                                break if !(_e1621);
                            }
                        }
                        let _e1688 = local_40;
                        let _e1691 = local_41;
                        if (_e1688.w > _e1691.w) {
                            let _e1694 = (_e1688.w - _e1691.w);
                            let _e1695 = (_e1694 / _e1688.w);
                            let _e1697 = local_42;
                            let _e1701 = local_43;
                            let _e1705 = local_44;
                            let _e1710 = local_45;
                            phi_1950_ = (_e1710 + vec4<f32>((_e1697.x * _e1695), (_e1701.y * _e1695), (_e1705.z * _e1695), _e1694));
                        } else {
                            let _e2445 = local_67;
                            phi_1950_ = _e2445;
                        }
                        let _e1713 = phi_1950_;
                        phi_1951_ = _e1713;
                    }
                    let _e1784 = phi_1951_;
                    if (_e1784.w > 1f) {
                        phi_1965_ = vec4<f32>((_e1784.x / _e1784.w), (_e1784.y / _e1784.w), (_e1784.z / _e1784.w), 1f);
                    } else {
                        phi_1965_ = _e1784;
                    }
                    let _e1795 = phi_1965_;
                    local[6u] = _e1795;
                    phi_1968_ = (_e1560 + _e1612);
                } else {
                    phi_1968_ = _e1560;
                }
                let _e1798 = phi_1968_;
                if (((_e70 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    let _e1806 = facet_bits.member[_e71];
                    let _e1807 = ((_e63 + 7u) & 31u);
                    let _e1814 = facet_bits.member[(_e71 + 1u)];
                    let _e1822 = facet_bits.member[(_e71 + 2u)];
                    let _e1830 = facet_bits.member[(_e71 + 3u)];
                    let _e1838 = facet_bits.member[(_e71 + 4u)];
                    let _e1846 = facet_bits.member[(_e71 + 5u)];
                    let _e1850 = (((((((_e1806 >> bitcast<u32>(_e1807)) & 1u) + ((_e1814 >> bitcast<u32>(_e1807)) & 1u)) + ((_e1822 >> bitcast<u32>(_e1807)) & 1u)) + ((_e1830 >> bitcast<u32>(_e1807)) & 1u)) + ((_e1838 >> bitcast<u32>(_e1807)) & 1u)) + ((_e1846 >> bitcast<u32>(_e1807)) & 1u));
                    if (_e52 == 1u) {
                        phi_2024_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_2027_ = _e1798;
                        loop {
                            let _e1953 = phi_2024_;
                            let _e1955 = phi_2027_;
                            local_70 = _e1953;
                            let _e1957 = (_e1955 < (_e1798 + _e1850));
                            if _e1957 {
                                let _e1958 = (2u * _e1955);
                                let _e1962 = radiance.member[_e1958][0u];
                                let _e1966 = radiance.member[_e1958][1u];
                                let _e1970 = radiance.member[_e1958][2u];
                                let _e1971 = (_e1958 + 1u);
                                let _e1975 = radiance.member[_e1971][0u];
                                let _e1979 = radiance.member[_e1971][1u];
                                let _e1983 = radiance.member[_e1971][2u];
                                let _e1993 = facets.member[_e1955].member_2;
                                let _e2002 = sqrt((((_e1993[0] * _e1993[0]) + (_e1993[1] * _e1993[1])) + (_e1993[2] * _e1993[2])));
                                phi_2025_ = vec4<f32>((_e1953.x + (select(_e1975, _e1962, (_e1962 > _e1975)) * _e2002)), (_e1953.y + (select(_e1979, _e1966, (_e1966 > _e1979)) * _e2002)), (_e1953.z + (select(_e1983, _e1970, (_e1970 > _e1983)) * _e2002)), (_e1953.w + _e2002));
                                phi_2028_ = (_e1955 + 1u);
                            } else {
                                phi_2025_ = vec4<f32>();
                                phi_2028_ = u32();
                            }
                            let _e2017 = phi_2025_;
                            let _e2019 = phi_2028_;
                            continue;
                            continuing {
                                phi_2024_ = _e2017;
                                phi_2027_ = _e2019;
                                break if !(_e1957);
                            }
                        }
                        let _e2478 = local_70;
                        phi_2202_ = _e2478;
                    } else {
                        phi_2102_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_2105_ = vec4<f32>(0f, 0f, 0f, 0f);
                        phi_2107_ = _e1798;
                        loop {
                            let _e1853 = phi_2102_;
                            let _e1855 = phi_2105_;
                            let _e1857 = phi_2107_;
                            local_46 = _e1853;
                            local_47 = _e1855;
                            local_48 = _e1853;
                            local_49 = _e1853;
                            local_50 = _e1853;
                            local_51 = _e1855;
                            local_69 = _e1855;
                            let _e1859 = (_e1857 < (_e1798 + _e1850));
                            if _e1859 {
                                let _e1863 = facets.member[_e1857].member_2;
                                let _e1872 = -((((_e118 * _e1863[0]) + (_e120 * _e1863[1])) + (_e122 * _e1863[2])));
                                if (_e1872 > 0f) {
                                    let _e1897 = radiance.member[(2u * _e1857)];
                                    phi_2177_ = _e1853;
                                    phi_2178_ = vec4<f32>((_e1855.x + (_e1897.x * _e1872)), (_e1855.y + (_e1897.y * _e1872)), (_e1855.z + (_e1897.z * _e1872)), (_e1855.w + _e1872));
                                } else {
                                    let _e1878 = radiance.member[((2u * _e1857) + 1u)];
                                    phi_2177_ = vec4<f32>((_e1853.x - (_e1878.x * _e1872)), (_e1853.y - (_e1878.y * _e1872)), (_e1853.z - (_e1878.z * _e1872)), (_e1853.w - _e1872));
                                    phi_2178_ = _e1855;
                                }
                                let _e1914 = phi_2177_;
                                let _e1916 = phi_2178_;
                                phi_2103_ = _e1914;
                                phi_2106_ = _e1916;
                                phi_2108_ = (_e1857 + 1u);
                            } else {
                                phi_2103_ = vec4<f32>();
                                phi_2106_ = vec4<f32>();
                                phi_2108_ = u32();
                            }
                            let _e1919 = phi_2103_;
                            let _e1921 = phi_2106_;
                            let _e1923 = phi_2108_;
                            continue;
                            continuing {
                                phi_2102_ = _e1919;
                                phi_2105_ = _e1921;
                                phi_2107_ = _e1923;
                                break if !(_e1859);
                            }
                        }
                        let _e1926 = local_46;
                        let _e1929 = local_47;
                        if (_e1926.w > _e1929.w) {
                            let _e1932 = (_e1926.w - _e1929.w);
                            let _e1933 = (_e1932 / _e1926.w);
                            let _e1935 = local_48;
                            let _e1939 = local_49;
                            let _e1943 = local_50;
                            let _e1948 = local_51;
                            phi_2201_ = (_e1948 + vec4<f32>((_e1935.x * _e1933), (_e1939.y * _e1933), (_e1943.z * _e1933), _e1932));
                        } else {
                            let _e2471 = local_69;
                            phi_2201_ = _e2471;
                        }
                        let _e1951 = phi_2201_;
                        phi_2202_ = _e1951;
                    }
                    let _e2022 = phi_2202_;
                    if (_e2022.w > 1f) {
                        phi_2216_ = vec4<f32>((_e2022.x / _e2022.w), (_e2022.y / _e2022.w), (_e2022.z / _e2022.w), 1f);
                    } else {
                        phi_2216_ = _e2022;
                    }
                    let _e2033 = phi_2216_;
                    local[7u] = _e2033;
                }
                if (_e52 == 1u) {
                    let _e2170 = local[0u];
                    let _e2171 = local[1u];
                    let _e2184 = local[2u];
                    let _e2185 = local[3u];
                    let _e2202 = local[4u];
                    let _e2203 = local[5u];
                    let _e2216 = local[6u];
                    let _e2217 = local[7u];
                    let _e2238 = ((((_e2170.x + _e2171.x) + (_e2184.x + _e2185.x)) + ((_e2202.x + _e2203.x) + (_e2216.x + _e2217.x))) * 0.25f);
                    let _e2239 = ((((_e2170.y + _e2171.y) + (_e2184.y + _e2185.y)) + ((_e2202.y + _e2203.y) + (_e2216.y + _e2217.y))) * 0.25f);
                    let _e2240 = ((((_e2170.z + _e2171.z) + (_e2184.z + _e2185.z)) + ((_e2202.z + _e2203.z) + (_e2216.z + _e2217.z))) * 0.25f);
                    let _e2241 = ((((_e2170.w + _e2171.w) + (_e2184.w + _e2185.w)) + ((_e2202.w + _e2203.w) + (_e2216.w + _e2217.w))) * 0.25f);
                    if (_e2241 > 1f) {
                        phi_2314_ = vec4<f32>((_e2238 / _e2241), (_e2239 / _e2241), (_e2240 / _e2241), (_e2241 / _e2241));
                    } else {
                        phi_2314_ = vec4<f32>(_e2238, _e2239, _e2240, _e2241);
                    }
                    let _e2250 = phi_2314_;
                    phi_2516_ = _e2250;
                } else {
                    let _e2037 = (1u << bitcast<u32>((_e113 & 31u)));
                    let _e2038 = select(1u, 2u, _e117);
                    let _e2039 = select(4u, 2u, _e121);
                    let _e2040 = select(0u, _e2037, _e115);
                    let _e2041 = select(_e2037, 0u, _e115);
                    if (_e2040 < 8u) {
                    } else {
                        break;
                    }
                    let _e2044 = local[_e2040];
                    if (_e2041 < 8u) {
                    } else {
                        break;
                    }
                    let _e2047 = local[_e2041];
                    let _e2049 = (1f - _e2044.w);
                    if (_e2047.w <= _e2049) {
                        phi_2369_ = (_e2044 + _e2047);
                    } else {
                        let _e2052 = (_e2049 / _e2047.w);
                        phi_2369_ = (_e2044 + vec4<f32>((_e2047.x * _e2052), (_e2047.y * _e2052), (_e2047.z * _e2052), _e2049));
                    }
                    let _e2063 = phi_2369_;
                    let _e2064 = (_e2038 + _e2040);
                    if (_e2064 < 8u) {
                    } else {
                        break;
                    }
                    let _e2067 = local[_e2064];
                    let _e2068 = (_e2038 + _e2041);
                    if (_e2068 < 8u) {
                    } else {
                        break;
                    }
                    let _e2071 = local[_e2068];
                    let _e2073 = (1f - _e2067.w);
                    if (_e2071.w <= _e2073) {
                        phi_2406_ = (_e2067 + _e2071);
                    } else {
                        let _e2076 = (_e2073 / _e2071.w);
                        phi_2406_ = (_e2067 + vec4<f32>((_e2071.x * _e2076), (_e2071.y * _e2076), (_e2071.z * _e2076), _e2073));
                    }
                    let _e2087 = phi_2406_;
                    let _e2100 = (_e2039 + _e2040);
                    if (_e2100 < 8u) {
                    } else {
                        break;
                    }
                    let _e2103 = local[_e2100];
                    let _e2104 = (_e2039 + _e2041);
                    if (_e2104 < 8u) {
                    } else {
                        break;
                    }
                    let _e2107 = local[_e2104];
                    let _e2109 = (1f - _e2103.w);
                    if (_e2107.w <= _e2109) {
                        phi_2455_ = (_e2103 + _e2107);
                    } else {
                        let _e2112 = (_e2109 / _e2107.w);
                        phi_2455_ = (_e2103 + vec4<f32>((_e2107.x * _e2112), (_e2107.y * _e2112), (_e2107.z * _e2112), _e2109));
                    }
                    let _e2123 = phi_2455_;
                    let _e2132 = (_e2038 + _e2039);
                    let _e2133 = (_e2132 + _e2040);
                    if (_e2133 < 8u) {
                    } else {
                        break;
                    }
                    let _e2136 = local[_e2133];
                    let _e2137 = (_e2132 + _e2041);
                    if (_e2137 < 8u) {
                    } else {
                        break;
                    }
                    let _e2140 = local[_e2137];
                    let _e2142 = (1f - _e2136.w);
                    if (_e2140.w <= _e2142) {
                        phi_2502_ = (_e2136 + _e2140);
                    } else {
                        let _e2145 = (_e2142 / _e2140.w);
                        phi_2502_ = (_e2136 + vec4<f32>((_e2140.x * _e2145), (_e2140.y * _e2145), (_e2140.z * _e2145), _e2142));
                    }
                    let _e2156 = phi_2502_;
                    phi_2516_ = vec4<f32>(((((_e2063.x + _e2087.x) + _e2123.x) + _e2156.x) * 0.25f), ((((_e2063.y + _e2087.y) + _e2123.y) + _e2156.y) * 0.25f), ((((_e2063.z + _e2087.z) + _e2123.z) + _e2156.z) * 0.25f), ((((_e2063.w + _e2087.w) + _e2123.w) + _e2156.w) * 0.25f));
                }
                let _e2252 = phi_2516_;
                let _e2255 = ((_e41 + _e48) + (_e48 - _e48));
                if (_e2255 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e2255] = _e2252;
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
