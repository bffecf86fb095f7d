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
    var phi_130_: type_10;
    var phi_133_: u32;
    var phi_131_: type_10;
    var phi_156_: type_10;
    var phi_134_: u32;
    var phi_264_: vec4<f32>;
    var phi_267_: vec4<f32>;
    var phi_269_: u32;
    var phi_380_: vec4<f32>;
    var phi_381_: vec4<f32>;
    var phi_265_: vec4<f32>;
    var phi_268_: vec4<f32>;
    var local_1: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_409_: vec4<f32>;
    var phi_423_: vec4<f32>;
    var phi_426_: u32;
    var phi_479_: vec4<f32>;
    var phi_482_: vec4<f32>;
    var phi_484_: u32;
    var phi_595_: vec4<f32>;
    var phi_596_: vec4<f32>;
    var phi_480_: vec4<f32>;
    var phi_483_: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;
    var phi_624_: vec4<f32>;
    var phi_638_: vec4<f32>;
    var phi_641_: u32;
    var phi_694_: vec4<f32>;
    var phi_697_: vec4<f32>;
    var phi_699_: u32;
    var phi_810_: vec4<f32>;
    var phi_811_: vec4<f32>;
    var phi_695_: vec4<f32>;
    var phi_698_: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var phi_839_: vec4<f32>;
    var phi_853_: vec4<f32>;
    var phi_856_: u32;
    var phi_909_: vec4<f32>;
    var phi_912_: vec4<f32>;
    var phi_914_: u32;
    var phi_1025_: vec4<f32>;
    var phi_1026_: vec4<f32>;
    var phi_910_: vec4<f32>;
    var phi_913_: vec4<f32>;
    var local_20: vec4<f32>;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var phi_1054_: vec4<f32>;
    var phi_1068_: vec4<f32>;
    var phi_1071_: u32;
    var phi_1124_: vec4<f32>;
    var phi_1127_: vec4<f32>;
    var phi_1129_: u32;
    var phi_1240_: vec4<f32>;
    var phi_1241_: vec4<f32>;
    var phi_1125_: vec4<f32>;
    var phi_1128_: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var local_28: vec4<f32>;
    var local_29: vec4<f32>;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var phi_1269_: vec4<f32>;
    var phi_1283_: vec4<f32>;
    var phi_1286_: u32;
    var phi_1339_: vec4<f32>;
    var phi_1342_: vec4<f32>;
    var phi_1344_: u32;
    var phi_1455_: vec4<f32>;
    var phi_1456_: vec4<f32>;
    var phi_1340_: vec4<f32>;
    var phi_1343_: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var local_36: vec4<f32>;
    var local_37: vec4<f32>;
    var phi_1484_: vec4<f32>;
    var phi_1498_: vec4<f32>;
    var phi_1501_: u32;
    var phi_1554_: vec4<f32>;
    var phi_1557_: vec4<f32>;
    var phi_1559_: u32;
    var phi_1670_: vec4<f32>;
    var phi_1671_: vec4<f32>;
    var phi_1555_: vec4<f32>;
    var phi_1558_: vec4<f32>;
    var local_38: vec4<f32>;
    var local_39: vec4<f32>;
    var local_40: vec4<f32>;
    var local_41: vec4<f32>;
    var local_42: vec4<f32>;
    var local_43: vec4<f32>;
    var phi_1699_: vec4<f32>;
    var phi_1713_: vec4<f32>;
    var phi_1716_: u32;
    var phi_1769_: vec4<f32>;
    var phi_1772_: vec4<f32>;
    var phi_1774_: u32;
    var phi_1885_: vec4<f32>;
    var phi_1886_: vec4<f32>;
    var phi_1770_: vec4<f32>;
    var phi_1773_: vec4<f32>;
    var local_44: vec4<f32>;
    var local_45: vec4<f32>;
    var local_46: vec4<f32>;
    var local_47: vec4<f32>;
    var local_48: vec4<f32>;
    var local_49: vec4<f32>;
    var phi_1914_: vec4<f32>;
    var phi_1928_: vec4<f32>;
    var phi_2026_: vec4<f32>;
    var phi_2248_: vec4<f32>;
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
                phi_130_ = type_10(0u, 6u);
                phi_133_ = _e77;
                loop {
                    let _e79 = phi_130_;
                    let _e81 = phi_133_;
                    local_50 = _e81;
                    local_1 = _e81;
                    local_53 = _e81;
                    if (_e79.member < _e79.member_1) {
                        phi_131_ = type_10((_e79.member + 1u), _e79.member_1);
                        phi_156_ = type_10(1u, _e79.member);
                    } else {
                        phi_131_ = _e79;
                        phi_156_ = type_10(0u, type_10().member_1);
                    }
                    let _e94 = phi_131_;
                    let _e96 = phi_156_;
                    let _e100 = (bitcast<i32>(_e96.member) != 0i);
                    if _e100 {
                        let _e104 = facet_bits.member[(_e73 + _e96.member_1)];
                        phi_134_ = (_e81 + countOneBits((_e104 & ((1u << bitcast<u32>(_e70)) - 1u))));
                    } else {
                        phi_134_ = u32();
                    }
                    let _e112 = phi_134_;
                    continue;
                    continuing {
                        phi_130_ = _e94;
                        phi_133_ = _e112;
                        break if !(_e100);
                    }
                }
                let _e115 = (_e58 >> bitcast<u32>(1i));
                let _e117 = ((_e58 & 1u) == 1u);
                let _e118 = select(1f, -1f, _e117);
                let _e119 = (_e115 == 0u);
                let _e120 = select(0f, _e118, _e119);
                let _e122 = select(0f, _e118, (_e115 == 1u));
                let _e123 = (_e115 == 2u);
                let _e124 = select(0f, _e118, _e123);
                local[0u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[1u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[2u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[3u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[4u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[5u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[6u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[7u] = vec4<f32>(0f, 0f, 0f, 0f);
                if ((_e72 & 1u) == 1u) {
                    let _e137 = facet_bits.member[_e73];
                    let _e144 = facet_bits.member[(_e73 + 1u)];
                    let _e152 = facet_bits.member[(_e73 + 2u)];
                    let _e160 = facet_bits.member[(_e73 + 3u)];
                    let _e168 = facet_bits.member[(_e73 + 4u)];
                    let _e176 = facet_bits.member[(_e73 + 5u)];
                    phi_264_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_267_ = vec4<f32>(0f, 0f, 0f, 0f);
                    let _e1923 = local_50;
                    phi_269_ = _e1923;
                    loop {
                        let _e183 = phi_264_;
                        let _e185 = phi_267_;
                        let _e187 = phi_269_;
                        let _e191 = facets.member[_e187].member_2;
                        let _e195 = (2u * _e187);
                        let _e198 = radiance.member[_e195];
                        let _e202 = radiance.member[(_e195 + 1u)];
                        let _e208 = -((((_e120 * _e191[0]) + (_e122 * _e191[1])) + (_e124 * _e191[2])));
                        if (_e54 == 1u) {
                            let _e261 = sqrt((((_e191[0] * _e191[0]) + (_e191[1] * _e191[1])) + (_e191[2] * _e191[2])));
                            phi_265_ = _e183;
                            phi_268_ = vec4<f32>((_e185.x + (select(_e202.x, _e198.x, (_e198.x > _e202.x)) * _e261)), (_e185.y + (select(_e202.y, _e198.y, (_e198.y > _e202.y)) * _e261)), (_e185.z + (select(_e202.z, _e198.z, (_e198.z > _e202.z)) * _e261)), (_e185.w + _e261));
                        } else {
                            if (_e208 > 0f) {
                                phi_380_ = _e183;
                                phi_381_ = vec4<f32>((_e185.x + (_e198.x * _e208)), (_e185.y + (_e198.y * _e208)), (_e185.z + (_e198.z * _e208)), (_e185.w + _e208));
                            } else {
                                phi_380_ = vec4<f32>((_e183.x - (_e202.x * _e208)), (_e183.y - (_e202.y * _e208)), (_e183.z - (_e202.z * _e208)), (_e183.w - _e208));
                                phi_381_ = _e185;
                            }
                            let _e241 = phi_380_;
                            let _e243 = phi_381_;
                            phi_265_ = _e241;
                            phi_268_ = _e243;
                        }
                        let _e275 = phi_265_;
                        let _e277 = phi_268_;
                        let _e278 = (_e187 + 1u);
                        let _e280 = local_1;
                        let _e281 = (_e280 + (((((((_e137 >> bitcast<u32>(_e70)) & 1u) + ((_e144 >> bitcast<u32>(_e70)) & 1u)) + ((_e152 >> bitcast<u32>(_e70)) & 1u)) + ((_e160 >> bitcast<u32>(_e70)) & 1u)) + ((_e168 >> bitcast<u32>(_e70)) & 1u)) + ((_e176 >> bitcast<u32>(_e70)) & 1u)));
                        local_2 = _e275;
                        local_3 = _e277;
                        local_4 = _e275;
                        local_5 = _e275;
                        local_6 = _e275;
                        local_7 = _e277;
                        local_51 = _e277;
                        local_52 = _e281;
                        continue;
                        continuing {
                            phi_264_ = _e275;
                            phi_267_ = _e277;
                            phi_269_ = _e278;
                            break if !(select(true, false, (_e278 >= _e281)));
                        }
                    }
                    let _e286 = local_2;
                    let _e289 = local_3;
                    if (_e286.w > _e289.w) {
                        let _e292 = (_e286.w - _e289.w);
                        let _e293 = (_e292 / _e286.w);
                        let _e295 = local_4;
                        let _e299 = local_5;
                        let _e303 = local_6;
                        let _e308 = local_7;
                        phi_409_ = (_e308 + vec4<f32>((_e295.x * _e293), (_e299.y * _e293), (_e303.z * _e293), _e292));
                    } else {
                        let _e1937 = local_51;
                        phi_409_ = _e1937;
                    }
                    let _e311 = phi_409_;
                    if (_e311.w > 1f) {
                        phi_423_ = vec4<f32>((_e311.x / _e311.w), (_e311.y / _e311.w), (_e311.z / _e311.w), 1f);
                    } else {
                        phi_423_ = _e311;
                    }
                    let _e322 = phi_423_;
                    local[0u] = _e322;
                    let _e1941 = local_52;
                    phi_426_ = _e1941;
                } else {
                    let _e1943 = local_53;
                    phi_426_ = _e1943;
                }
                let _e324 = phi_426_;
                if (((_e72 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    let _e332 = facet_bits.member[_e73];
                    let _e333 = ((_e65 + 1u) & 31u);
                    let _e340 = facet_bits.member[(_e73 + 1u)];
                    let _e348 = facet_bits.member[(_e73 + 2u)];
                    let _e356 = facet_bits.member[(_e73 + 3u)];
                    let _e364 = facet_bits.member[(_e73 + 4u)];
                    let _e372 = facet_bits.member[(_e73 + 5u)];
                    phi_479_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_482_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_484_ = _e324;
                    loop {
                        let _e379 = phi_479_;
                        let _e381 = phi_482_;
                        let _e383 = phi_484_;
                        let _e387 = facets.member[_e383].member_2;
                        let _e391 = (2u * _e383);
                        let _e394 = radiance.member[_e391];
                        let _e398 = radiance.member[(_e391 + 1u)];
                        let _e404 = -((((_e120 * _e387[0]) + (_e122 * _e387[1])) + (_e124 * _e387[2])));
                        if (_e54 == 1u) {
                            let _e457 = sqrt((((_e387[0] * _e387[0]) + (_e387[1] * _e387[1])) + (_e387[2] * _e387[2])));
                            phi_480_ = _e379;
                            phi_483_ = vec4<f32>((_e381.x + (select(_e398.x, _e394.x, (_e394.x > _e398.x)) * _e457)), (_e381.y + (select(_e398.y, _e394.y, (_e394.y > _e398.y)) * _e457)), (_e381.z + (select(_e398.z, _e394.z, (_e394.z > _e398.z)) * _e457)), (_e381.w + _e457));
                        } else {
                            if (_e404 > 0f) {
                                phi_595_ = _e379;
                                phi_596_ = vec4<f32>((_e381.x + (_e394.x * _e404)), (_e381.y + (_e394.y * _e404)), (_e381.z + (_e394.z * _e404)), (_e381.w + _e404));
                            } else {
                                phi_595_ = vec4<f32>((_e379.x - (_e398.x * _e404)), (_e379.y - (_e398.y * _e404)), (_e379.z - (_e398.z * _e404)), (_e379.w - _e404));
                                phi_596_ = _e381;
                            }
                            let _e437 = phi_595_;
                            let _e439 = phi_596_;
                            phi_480_ = _e437;
                            phi_483_ = _e439;
                        }
                        let _e471 = phi_480_;
                        let _e473 = phi_483_;
                        let _e474 = (_e383 + 1u);
                        let _e475 = (_e324 + (((((((_e332 >> bitcast<u32>(_e333)) & 1u) + ((_e340 >> bitcast<u32>(_e333)) & 1u)) + ((_e348 >> bitcast<u32>(_e333)) & 1u)) + ((_e356 >> bitcast<u32>(_e333)) & 1u)) + ((_e364 >> bitcast<u32>(_e333)) & 1u)) + ((_e372 >> bitcast<u32>(_e333)) & 1u)));
                        local_8 = _e471;
                        local_9 = _e473;
                        local_10 = _e471;
                        local_11 = _e471;
                        local_12 = _e471;
                        local_13 = _e473;
                        local_54 = _e473;
                        local_55 = _e475;
                        continue;
                        continuing {
                            phi_479_ = _e471;
                            phi_482_ = _e473;
                            phi_484_ = _e474;
                            break if !(select(true, false, (_e474 >= _e475)));
                        }
                    }
                    let _e480 = local_8;
                    let _e483 = local_9;
                    if (_e480.w > _e483.w) {
                        let _e486 = (_e480.w - _e483.w);
                        let _e487 = (_e486 / _e480.w);
                        let _e489 = local_10;
                        let _e493 = local_11;
                        let _e497 = local_12;
                        let _e502 = local_13;
                        phi_624_ = (_e502 + vec4<f32>((_e489.x * _e487), (_e493.y * _e487), (_e497.z * _e487), _e486));
                    } else {
                        let _e1959 = local_54;
                        phi_624_ = _e1959;
                    }
                    let _e505 = phi_624_;
                    if (_e505.w > 1f) {
                        phi_638_ = vec4<f32>((_e505.x / _e505.w), (_e505.y / _e505.w), (_e505.z / _e505.w), 1f);
                    } else {
                        phi_638_ = _e505;
                    }
                    let _e516 = phi_638_;
                    local[1u] = _e516;
                    let _e1963 = local_55;
                    phi_641_ = _e1963;
                } else {
                    phi_641_ = _e324;
                }
                let _e518 = phi_641_;
                if (((_e72 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    let _e526 = facet_bits.member[_e73];
                    let _e527 = ((_e65 + 2u) & 31u);
                    let _e534 = facet_bits.member[(_e73 + 1u)];
                    let _e542 = facet_bits.member[(_e73 + 2u)];
                    let _e550 = facet_bits.member[(_e73 + 3u)];
                    let _e558 = facet_bits.member[(_e73 + 4u)];
                    let _e566 = facet_bits.member[(_e73 + 5u)];
                    phi_694_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_697_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_699_ = _e518;
                    loop {
                        let _e573 = phi_694_;
                        let _e575 = phi_697_;
                        let _e577 = phi_699_;
                        let _e581 = facets.member[_e577].member_2;
                        let _e585 = (2u * _e577);
                        let _e588 = radiance.member[_e585];
                        let _e592 = radiance.member[(_e585 + 1u)];
                        let _e598 = -((((_e120 * _e581[0]) + (_e122 * _e581[1])) + (_e124 * _e581[2])));
                        if (_e54 == 1u) {
                            let _e651 = sqrt((((_e581[0] * _e581[0]) + (_e581[1] * _e581[1])) + (_e581[2] * _e581[2])));
                            phi_695_ = _e573;
                            phi_698_ = vec4<f32>((_e575.x + (select(_e592.x, _e588.x, (_e588.x > _e592.x)) * _e651)), (_e575.y + (select(_e592.y, _e588.y, (_e588.y > _e592.y)) * _e651)), (_e575.z + (select(_e592.z, _e588.z, (_e588.z > _e592.z)) * _e651)), (_e575.w + _e651));
                        } else {
                            if (_e598 > 0f) {
                                phi_810_ = _e573;
                                phi_811_ = vec4<f32>((_e575.x + (_e588.x * _e598)), (_e575.y + (_e588.y * _e598)), (_e575.z + (_e588.z * _e598)), (_e575.w + _e598));
                            } else {
                                phi_810_ = vec4<f32>((_e573.x - (_e592.x * _e598)), (_e573.y - (_e592.y * _e598)), (_e573.z - (_e592.z * _e598)), (_e573.w - _e598));
                                phi_811_ = _e575;
                            }
                            let _e631 = phi_810_;
                            let _e633 = phi_811_;
                            phi_695_ = _e631;
                            phi_698_ = _e633;
                        }
                        let _e665 = phi_695_;
                        let _e667 = phi_698_;
                        let _e668 = (_e577 + 1u);
                        let _e669 = (_e518 + (((((((_e526 >> bitcast<u32>(_e527)) & 1u) + ((_e534 >> bitcast<u32>(_e527)) & 1u)) + ((_e542 >> bitcast<u32>(_e527)) & 1u)) + ((_e550 >> bitcast<u32>(_e527)) & 1u)) + ((_e558 >> bitcast<u32>(_e527)) & 1u)) + ((_e566 >> bitcast<u32>(_e527)) & 1u)));
                        local_14 = _e665;
                        local_15 = _e667;
                        local_16 = _e665;
                        local_17 = _e665;
                        local_18 = _e665;
                        local_19 = _e667;
                        local_56 = _e667;
                        local_57 = _e669;
                        continue;
                        continuing {
                            phi_694_ = _e665;
                            phi_697_ = _e667;
                            phi_699_ = _e668;
                            break if !(select(true, false, (_e668 >= _e669)));
                        }
                    }
                    let _e674 = local_14;
                    let _e677 = local_15;
                    if (_e674.w > _e677.w) {
                        let _e680 = (_e674.w - _e677.w);
                        let _e681 = (_e680 / _e674.w);
                        let _e683 = local_16;
                        let _e687 = local_17;
                        let _e691 = local_18;
                        let _e696 = local_19;
                        phi_839_ = (_e696 + vec4<f32>((_e683.x * _e681), (_e687.y * _e681), (_e691.z * _e681), _e680));
                    } else {
                        let _e1979 = local_56;
                        phi_839_ = _e1979;
                    }
                    let _e699 = phi_839_;
                    if (_e699.w > 1f) {
                        phi_853_ = vec4<f32>((_e699.x / _e699.w), (_e699.y / _e699.w), (_e699.z / _e699.w), 1f);
                    } else {
                        phi_853_ = _e699;
                    }
                    let _e710 = phi_853_;
                    local[2u] = _e710;
                    let _e1983 = local_57;
                    phi_856_ = _e1983;
                } else {
                    phi_856_ = _e518;
                }
                let _e712 = phi_856_;
                if (((_e72 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    let _e720 = facet_bits.member[_e73];
                    let _e721 = ((_e65 + 3u) & 31u);
                    let _e728 = facet_bits.member[(_e73 + 1u)];
                    let _e736 = facet_bits.member[(_e73 + 2u)];
                    let _e744 = facet_bits.member[(_e73 + 3u)];
                    let _e752 = facet_bits.member[(_e73 + 4u)];
                    let _e760 = facet_bits.member[(_e73 + 5u)];
                    phi_909_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_912_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_914_ = _e712;
                    loop {
                        let _e767 = phi_909_;
                        let _e769 = phi_912_;
                        let _e771 = phi_914_;
                        let _e775 = facets.member[_e771].member_2;
                        let _e779 = (2u * _e771);
                        let _e782 = radiance.member[_e779];
                        let _e786 = radiance.member[(_e779 + 1u)];
                        let _e792 = -((((_e120 * _e775[0]) + (_e122 * _e775[1])) + (_e124 * _e775[2])));
                        if (_e54 == 1u) {
                            let _e845 = sqrt((((_e775[0] * _e775[0]) + (_e775[1] * _e775[1])) + (_e775[2] * _e775[2])));
                            phi_910_ = _e767;
                            phi_913_ = vec4<f32>((_e769.x + (select(_e786.x, _e782.x, (_e782.x > _e786.x)) * _e845)), (_e769.y + (select(_e786.y, _e782.y, (_e782.y > _e786.y)) * _e845)), (_e769.z + (select(_e786.z, _e782.z, (_e782.z > _e786.z)) * _e845)), (_e769.w + _e845));
                        } else {
                            if (_e792 > 0f) {
                                phi_1025_ = _e767;
                                phi_1026_ = vec4<f32>((_e769.x + (_e782.x * _e792)), (_e769.y + (_e782.y * _e792)), (_e769.z + (_e782.z * _e792)), (_e769.w + _e792));
                            } else {
                                phi_1025_ = vec4<f32>((_e767.x - (_e786.x * _e792)), (_e767.y - (_e786.y * _e792)), (_e767.z - (_e786.z * _e792)), (_e767.w - _e792));
                                phi_1026_ = _e769;
                            }
                            let _e825 = phi_1025_;
                            let _e827 = phi_1026_;
                            phi_910_ = _e825;
                            phi_913_ = _e827;
                        }
                        let _e859 = phi_910_;
                        let _e861 = phi_913_;
                        let _e862 = (_e771 + 1u);
                        let _e863 = (_e712 + (((((((_e720 >> bitcast<u32>(_e721)) & 1u) + ((_e728 >> bitcast<u32>(_e721)) & 1u)) + ((_e736 >> bitcast<u32>(_e721)) & 1u)) + ((_e744 >> bitcast<u32>(_e721)) & 1u)) + ((_e752 >> bitcast<u32>(_e721)) & 1u)) + ((_e760 >> bitcast<u32>(_e721)) & 1u)));
                        local_20 = _e859;
                        local_21 = _e861;
                        local_22 = _e859;
                        local_23 = _e859;
                        local_24 = _e859;
                        local_25 = _e861;
                        local_58 = _e861;
                        local_59 = _e863;
                        continue;
                        continuing {
                            phi_909_ = _e859;
                            phi_912_ = _e861;
                            phi_914_ = _e862;
                            break if !(select(true, false, (_e862 >= _e863)));
                        }
                    }
                    let _e868 = local_20;
                    let _e871 = local_21;
                    if (_e868.w > _e871.w) {
                        let _e874 = (_e868.w - _e871.w);
                        let _e875 = (_e874 / _e868.w);
                        let _e877 = local_22;
                        let _e881 = local_23;
                        let _e885 = local_24;
                        let _e890 = local_25;
                        phi_1054_ = (_e890 + vec4<f32>((_e877.x * _e875), (_e881.y * _e875), (_e885.z * _e875), _e874));
                    } else {
                        let _e1999 = local_58;
                        phi_1054_ = _e1999;
                    }
                    let _e893 = phi_1054_;
                    if (_e893.w > 1f) {
                        phi_1068_ = vec4<f32>((_e893.x / _e893.w), (_e893.y / _e893.w), (_e893.z / _e893.w), 1f);
                    } else {
                        phi_1068_ = _e893;
                    }
                    let _e904 = phi_1068_;
                    local[3u] = _e904;
                    let _e2003 = local_59;
                    phi_1071_ = _e2003;
                } else {
                    phi_1071_ = _e712;
                }
                let _e906 = phi_1071_;
                if (((_e72 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    let _e914 = facet_bits.member[_e73];
                    let _e915 = ((_e65 + 4u) & 31u);
                    let _e922 = facet_bits.member[(_e73 + 1u)];
                    let _e930 = facet_bits.member[(_e73 + 2u)];
                    let _e938 = facet_bits.member[(_e73 + 3u)];
                    let _e946 = facet_bits.member[(_e73 + 4u)];
                    let _e954 = facet_bits.member[(_e73 + 5u)];
                    phi_1124_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1127_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1129_ = _e906;
                    loop {
                        let _e961 = phi_1124_;
                        let _e963 = phi_1127_;
                        let _e965 = phi_1129_;
                        let _e969 = facets.member[_e965].member_2;
                        let _e973 = (2u * _e965);
                        let _e976 = radiance.member[_e973];
                        let _e980 = radiance.member[(_e973 + 1u)];
                        let _e986 = -((((_e120 * _e969[0]) + (_e122 * _e969[1])) + (_e124 * _e969[2])));
                        if (_e54 == 1u) {
                            let _e1039 = sqrt((((_e969[0] * _e969[0]) + (_e969[1] * _e969[1])) + (_e969[2] * _e969[2])));
                            phi_1125_ = _e961;
                            phi_1128_ = vec4<f32>((_e963.x + (select(_e980.x, _e976.x, (_e976.x > _e980.x)) * _e1039)), (_e963.y + (select(_e980.y, _e976.y, (_e976.y > _e980.y)) * _e1039)), (_e963.z + (select(_e980.z, _e976.z, (_e976.z > _e980.z)) * _e1039)), (_e963.w + _e1039));
                        } else {
                            if (_e986 > 0f) {
                                phi_1240_ = _e961;
                                phi_1241_ = vec4<f32>((_e963.x + (_e976.x * _e986)), (_e963.y + (_e976.y * _e986)), (_e963.z + (_e976.z * _e986)), (_e963.w + _e986));
                            } else {
                                phi_1240_ = vec4<f32>((_e961.x - (_e980.x * _e986)), (_e961.y - (_e980.y * _e986)), (_e961.z - (_e980.z * _e986)), (_e961.w - _e986));
                                phi_1241_ = _e963;
                            }
                            let _e1019 = phi_1240_;
                            let _e1021 = phi_1241_;
                            phi_1125_ = _e1019;
                            phi_1128_ = _e1021;
                        }
                        let _e1053 = phi_1125_;
                        let _e1055 = phi_1128_;
                        let _e1056 = (_e965 + 1u);
                        let _e1057 = (_e906 + (((((((_e914 >> bitcast<u32>(_e915)) & 1u) + ((_e922 >> bitcast<u32>(_e915)) & 1u)) + ((_e930 >> bitcast<u32>(_e915)) & 1u)) + ((_e938 >> bitcast<u32>(_e915)) & 1u)) + ((_e946 >> bitcast<u32>(_e915)) & 1u)) + ((_e954 >> bitcast<u32>(_e915)) & 1u)));
                        local_26 = _e1053;
                        local_27 = _e1055;
                        local_28 = _e1053;
                        local_29 = _e1053;
                        local_30 = _e1053;
                        local_31 = _e1055;
                        local_60 = _e1055;
                        local_61 = _e1057;
                        continue;
                        continuing {
                            phi_1124_ = _e1053;
                            phi_1127_ = _e1055;
                            phi_1129_ = _e1056;
                            break if !(select(true, false, (_e1056 >= _e1057)));
                        }
                    }
                    let _e1062 = local_26;
                    let _e1065 = local_27;
                    if (_e1062.w > _e1065.w) {
                        let _e1068 = (_e1062.w - _e1065.w);
                        let _e1069 = (_e1068 / _e1062.w);
                        let _e1071 = local_28;
                        let _e1075 = local_29;
                        let _e1079 = local_30;
                        let _e1084 = local_31;
                        phi_1269_ = (_e1084 + vec4<f32>((_e1071.x * _e1069), (_e1075.y * _e1069), (_e1079.z * _e1069), _e1068));
                    } else {
                        let _e2019 = local_60;
                        phi_1269_ = _e2019;
                    }
                    let _e1087 = phi_1269_;
                    if (_e1087.w > 1f) {
                        phi_1283_ = vec4<f32>((_e1087.x / _e1087.w), (_e1087.y / _e1087.w), (_e1087.z / _e1087.w), 1f);
                    } else {
                        phi_1283_ = _e1087;
                    }
                    let _e1098 = phi_1283_;
                    local[4u] = _e1098;
                    let _e2023 = local_61;
                    phi_1286_ = _e2023;
                } else {
                    phi_1286_ = _e906;
                }
                let _e1100 = phi_1286_;
                if (((_e72 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    let _e1108 = facet_bits.member[_e73];
                    let _e1109 = ((_e65 + 5u) & 31u);
                    let _e1116 = facet_bits.member[(_e73 + 1u)];
                    let _e1124 = facet_bits.member[(_e73 + 2u)];
                    let _e1132 = facet_bits.member[(_e73 + 3u)];
                    let _e1140 = facet_bits.member[(_e73 + 4u)];
                    let _e1148 = facet_bits.member[(_e73 + 5u)];
                    phi_1339_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1342_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1344_ = _e1100;
                    loop {
                        let _e1155 = phi_1339_;
                        let _e1157 = phi_1342_;
                        let _e1159 = phi_1344_;
                        let _e1163 = facets.member[_e1159].member_2;
                        let _e1167 = (2u * _e1159);
                        let _e1170 = radiance.member[_e1167];
                        let _e1174 = radiance.member[(_e1167 + 1u)];
                        let _e1180 = -((((_e120 * _e1163[0]) + (_e122 * _e1163[1])) + (_e124 * _e1163[2])));
                        if (_e54 == 1u) {
                            let _e1233 = sqrt((((_e1163[0] * _e1163[0]) + (_e1163[1] * _e1163[1])) + (_e1163[2] * _e1163[2])));
                            phi_1340_ = _e1155;
                            phi_1343_ = vec4<f32>((_e1157.x + (select(_e1174.x, _e1170.x, (_e1170.x > _e1174.x)) * _e1233)), (_e1157.y + (select(_e1174.y, _e1170.y, (_e1170.y > _e1174.y)) * _e1233)), (_e1157.z + (select(_e1174.z, _e1170.z, (_e1170.z > _e1174.z)) * _e1233)), (_e1157.w + _e1233));
                        } else {
                            if (_e1180 > 0f) {
                                phi_1455_ = _e1155;
                                phi_1456_ = vec4<f32>((_e1157.x + (_e1170.x * _e1180)), (_e1157.y + (_e1170.y * _e1180)), (_e1157.z + (_e1170.z * _e1180)), (_e1157.w + _e1180));
                            } else {
                                phi_1455_ = vec4<f32>((_e1155.x - (_e1174.x * _e1180)), (_e1155.y - (_e1174.y * _e1180)), (_e1155.z - (_e1174.z * _e1180)), (_e1155.w - _e1180));
                                phi_1456_ = _e1157;
                            }
                            let _e1213 = phi_1455_;
                            let _e1215 = phi_1456_;
                            phi_1340_ = _e1213;
                            phi_1343_ = _e1215;
                        }
                        let _e1247 = phi_1340_;
                        let _e1249 = phi_1343_;
                        let _e1250 = (_e1159 + 1u);
                        let _e1251 = (_e1100 + (((((((_e1108 >> bitcast<u32>(_e1109)) & 1u) + ((_e1116 >> bitcast<u32>(_e1109)) & 1u)) + ((_e1124 >> bitcast<u32>(_e1109)) & 1u)) + ((_e1132 >> bitcast<u32>(_e1109)) & 1u)) + ((_e1140 >> bitcast<u32>(_e1109)) & 1u)) + ((_e1148 >> bitcast<u32>(_e1109)) & 1u)));
                        local_32 = _e1247;
                        local_33 = _e1249;
                        local_34 = _e1247;
                        local_35 = _e1247;
                        local_36 = _e1247;
                        local_37 = _e1249;
                        local_62 = _e1249;
                        local_63 = _e1251;
                        continue;
                        continuing {
                            phi_1339_ = _e1247;
                            phi_1342_ = _e1249;
                            phi_1344_ = _e1250;
                            break if !(select(true, false, (_e1250 >= _e1251)));
                        }
                    }
                    let _e1256 = local_32;
                    let _e1259 = local_33;
                    if (_e1256.w > _e1259.w) {
                        let _e1262 = (_e1256.w - _e1259.w);
                        let _e1263 = (_e1262 / _e1256.w);
                        let _e1265 = local_34;
                        let _e1269 = local_35;
                        let _e1273 = local_36;
                        let _e1278 = local_37;
                        phi_1484_ = (_e1278 + vec4<f32>((_e1265.x * _e1263), (_e1269.y * _e1263), (_e1273.z * _e1263), _e1262));
                    } else {
                        let _e2039 = local_62;
                        phi_1484_ = _e2039;
                    }
                    let _e1281 = phi_1484_;
                    if (_e1281.w > 1f) {
                        phi_1498_ = vec4<f32>((_e1281.x / _e1281.w), (_e1281.y / _e1281.w), (_e1281.z / _e1281.w), 1f);
                    } else {
                        phi_1498_ = _e1281;
                    }
                    let _e1292 = phi_1498_;
                    local[5u] = _e1292;
                    let _e2043 = local_63;
                    phi_1501_ = _e2043;
                } else {
                    phi_1501_ = _e1100;
                }
                let _e1294 = phi_1501_;
                if (((_e72 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    let _e1302 = facet_bits.member[_e73];
                    let _e1303 = ((_e65 + 6u) & 31u);
                    let _e1310 = facet_bits.member[(_e73 + 1u)];
                    let _e1318 = facet_bits.member[(_e73 + 2u)];
                    let _e1326 = facet_bits.member[(_e73 + 3u)];
                    let _e1334 = facet_bits.member[(_e73 + 4u)];
                    let _e1342 = facet_bits.member[(_e73 + 5u)];
                    phi_1554_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1557_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1559_ = _e1294;
                    loop {
                        let _e1349 = phi_1554_;
                        let _e1351 = phi_1557_;
                        let _e1353 = phi_1559_;
                        let _e1357 = facets.member[_e1353].member_2;
                        let _e1361 = (2u * _e1353);
                        let _e1364 = radiance.member[_e1361];
                        let _e1368 = radiance.member[(_e1361 + 1u)];
                        let _e1374 = -((((_e120 * _e1357[0]) + (_e122 * _e1357[1])) + (_e124 * _e1357[2])));
                        if (_e54 == 1u) {
                            let _e1427 = sqrt((((_e1357[0] * _e1357[0]) + (_e1357[1] * _e1357[1])) + (_e1357[2] * _e1357[2])));
                            phi_1555_ = _e1349;
                            phi_1558_ = vec4<f32>((_e1351.x + (select(_e1368.x, _e1364.x, (_e1364.x > _e1368.x)) * _e1427)), (_e1351.y + (select(_e1368.y, _e1364.y, (_e1364.y > _e1368.y)) * _e1427)), (_e1351.z + (select(_e1368.z, _e1364.z, (_e1364.z > _e1368.z)) * _e1427)), (_e1351.w + _e1427));
                        } else {
                            if (_e1374 > 0f) {
                                phi_1670_ = _e1349;
                                phi_1671_ = vec4<f32>((_e1351.x + (_e1364.x * _e1374)), (_e1351.y + (_e1364.y * _e1374)), (_e1351.z + (_e1364.z * _e1374)), (_e1351.w + _e1374));
                            } else {
                                phi_1670_ = vec4<f32>((_e1349.x - (_e1368.x * _e1374)), (_e1349.y - (_e1368.y * _e1374)), (_e1349.z - (_e1368.z * _e1374)), (_e1349.w - _e1374));
                                phi_1671_ = _e1351;
                            }
                            let _e1407 = phi_1670_;
                            let _e1409 = phi_1671_;
                            phi_1555_ = _e1407;
                            phi_1558_ = _e1409;
                        }
                        let _e1441 = phi_1555_;
                        let _e1443 = phi_1558_;
                        let _e1444 = (_e1353 + 1u);
                        let _e1445 = (_e1294 + (((((((_e1302 >> bitcast<u32>(_e1303)) & 1u) + ((_e1310 >> bitcast<u32>(_e1303)) & 1u)) + ((_e1318 >> bitcast<u32>(_e1303)) & 1u)) + ((_e1326 >> bitcast<u32>(_e1303)) & 1u)) + ((_e1334 >> bitcast<u32>(_e1303)) & 1u)) + ((_e1342 >> bitcast<u32>(_e1303)) & 1u)));
                        local_38 = _e1441;
                        local_39 = _e1443;
                        local_40 = _e1441;
                        local_41 = _e1441;
                        local_42 = _e1441;
                        local_43 = _e1443;
                        local_64 = _e1443;
                        local_65 = _e1445;
                        continue;
                        continuing {
                            phi_1554_ = _e1441;
                            phi_1557_ = _e1443;
                            phi_1559_ = _e1444;
                            break if !(select(true, false, (_e1444 >= _e1445)));
                        }
                    }
                    let _e1450 = local_38;
                    let _e1453 = local_39;
                    if (_e1450.w > _e1453.w) {
                        let _e1456 = (_e1450.w - _e1453.w);
                        let _e1457 = (_e1456 / _e1450.w);
                        let _e1459 = local_40;
                        let _e1463 = local_41;
                        let _e1467 = local_42;
                        let _e1472 = local_43;
                        phi_1699_ = (_e1472 + vec4<f32>((_e1459.x * _e1457), (_e1463.y * _e1457), (_e1467.z * _e1457), _e1456));
                    } else {
                        let _e2059 = local_64;
                        phi_1699_ = _e2059;
                    }
                    let _e1475 = phi_1699_;
                    if (_e1475.w > 1f) {
                        phi_1713_ = vec4<f32>((_e1475.x / _e1475.w), (_e1475.y / _e1475.w), (_e1475.z / _e1475.w), 1f);
                    } else {
                        phi_1713_ = _e1475;
                    }
                    let _e1486 = phi_1713_;
                    local[6u] = _e1486;
                    let _e2063 = local_65;
                    phi_1716_ = _e2063;
                } else {
                    phi_1716_ = _e1294;
                }
                let _e1488 = phi_1716_;
                if (((_e72 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    let _e1496 = facet_bits.member[_e73];
                    let _e1497 = ((_e65 + 7u) & 31u);
                    let _e1504 = facet_bits.member[(_e73 + 1u)];
                    let _e1512 = facet_bits.member[(_e73 + 2u)];
                    let _e1520 = facet_bits.member[(_e73 + 3u)];
                    let _e1528 = facet_bits.member[(_e73 + 4u)];
                    let _e1536 = facet_bits.member[(_e73 + 5u)];
                    phi_1769_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1772_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1774_ = _e1488;
                    loop {
                        let _e1543 = phi_1769_;
                        let _e1545 = phi_1772_;
                        let _e1547 = phi_1774_;
                        let _e1551 = facets.member[_e1547].member_2;
                        let _e1555 = (2u * _e1547);
                        let _e1558 = radiance.member[_e1555];
                        let _e1562 = radiance.member[(_e1555 + 1u)];
                        let _e1568 = -((((_e120 * _e1551[0]) + (_e122 * _e1551[1])) + (_e124 * _e1551[2])));
                        if (_e54 == 1u) {
                            let _e1621 = sqrt((((_e1551[0] * _e1551[0]) + (_e1551[1] * _e1551[1])) + (_e1551[2] * _e1551[2])));
                            phi_1770_ = _e1543;
                            phi_1773_ = vec4<f32>((_e1545.x + (select(_e1562.x, _e1558.x, (_e1558.x > _e1562.x)) * _e1621)), (_e1545.y + (select(_e1562.y, _e1558.y, (_e1558.y > _e1562.y)) * _e1621)), (_e1545.z + (select(_e1562.z, _e1558.z, (_e1558.z > _e1562.z)) * _e1621)), (_e1545.w + _e1621));
                        } else {
                            if (_e1568 > 0f) {
                                phi_1885_ = _e1543;
                                phi_1886_ = vec4<f32>((_e1545.x + (_e1558.x * _e1568)), (_e1545.y + (_e1558.y * _e1568)), (_e1545.z + (_e1558.z * _e1568)), (_e1545.w + _e1568));
                            } else {
                                phi_1885_ = vec4<f32>((_e1543.x - (_e1562.x * _e1568)), (_e1543.y - (_e1562.y * _e1568)), (_e1543.z - (_e1562.z * _e1568)), (_e1543.w - _e1568));
                                phi_1886_ = _e1545;
                            }
                            let _e1601 = phi_1885_;
                            let _e1603 = phi_1886_;
                            phi_1770_ = _e1601;
                            phi_1773_ = _e1603;
                        }
                        let _e1635 = phi_1770_;
                        let _e1637 = phi_1773_;
                        let _e1638 = (_e1547 + 1u);
                        local_44 = _e1635;
                        local_45 = _e1637;
                        local_46 = _e1635;
                        local_47 = _e1635;
                        local_48 = _e1635;
                        local_49 = _e1637;
                        local_66 = _e1637;
                        continue;
                        continuing {
                            phi_1769_ = _e1635;
                            phi_1772_ = _e1637;
                            phi_1774_ = _e1638;
                            break if !(select(true, false, (_e1638 >= (_e1488 + (((((((_e1496 >> bitcast<u32>(_e1497)) & 1u) + ((_e1504 >> bitcast<u32>(_e1497)) & 1u)) + ((_e1512 >> bitcast<u32>(_e1497)) & 1u)) + ((_e1520 >> bitcast<u32>(_e1497)) & 1u)) + ((_e1528 >> bitcast<u32>(_e1497)) & 1u)) + ((_e1536 >> bitcast<u32>(_e1497)) & 1u))))));
                        }
                    }
                    let _e1644 = local_44;
                    let _e1647 = local_45;
                    if (_e1644.w > _e1647.w) {
                        let _e1650 = (_e1644.w - _e1647.w);
                        let _e1651 = (_e1650 / _e1644.w);
                        let _e1653 = local_46;
                        let _e1657 = local_47;
                        let _e1661 = local_48;
                        let _e1666 = local_49;
                        phi_1914_ = (_e1666 + vec4<f32>((_e1653.x * _e1651), (_e1657.y * _e1651), (_e1661.z * _e1651), _e1650));
                    } else {
                        let _e2079 = local_66;
                        phi_1914_ = _e2079;
                    }
                    let _e1669 = phi_1914_;
                    if (_e1669.w > 1f) {
                        phi_1928_ = vec4<f32>((_e1669.x / _e1669.w), (_e1669.y / _e1669.w), (_e1669.z / _e1669.w), 1f);
                    } else {
                        phi_1928_ = _e1669;
                    }
                    let _e1680 = phi_1928_;
                    local[7u] = _e1680;
                }
                if (_e54 == 1u) {
                    let _e1825 = local[0u];
                    let _e1826 = local[1u];
                    let _e1839 = local[2u];
                    let _e1840 = local[3u];
                    let _e1857 = local[4u];
                    let _e1858 = local[5u];
                    let _e1871 = local[6u];
                    let _e1872 = local[7u];
                    let _e1893 = ((((_e1825.x + _e1826.x) + (_e1839.x + _e1840.x)) + ((_e1857.x + _e1858.x) + (_e1871.x + _e1872.x))) * 0.25f);
                    let _e1894 = ((((_e1825.y + _e1826.y) + (_e1839.y + _e1840.y)) + ((_e1857.y + _e1858.y) + (_e1871.y + _e1872.y))) * 0.25f);
                    let _e1895 = ((((_e1825.z + _e1826.z) + (_e1839.z + _e1840.z)) + ((_e1857.z + _e1858.z) + (_e1871.z + _e1872.z))) * 0.25f);
                    let _e1896 = ((((_e1825.w + _e1826.w) + (_e1839.w + _e1840.w)) + ((_e1857.w + _e1858.w) + (_e1871.w + _e1872.w))) * 0.25f);
                    if (_e1896 > 1f) {
                        phi_2026_ = vec4<f32>((_e1893 / _e1896), (_e1894 / _e1896), (_e1895 / _e1896), (_e1896 / _e1896));
                    } else {
                        phi_2026_ = vec4<f32>(_e1893, _e1894, _e1895, _e1896);
                    }
                    let _e1905 = phi_2026_;
                    phi_2248_ = _e1905;
                } else {
                    let _e1684 = (1u << bitcast<u32>((_e115 & 31u)));
                    let _e1685 = select(1u, 2u, _e119);
                    let _e1686 = select(4u, 2u, _e123);
                    let _e1687 = select(0u, _e1684, _e117);
                    let _e1688 = select(_e1684, 0u, _e117);
                    if (_e1687 < 8u) {
                    } else {
                        break;
                    }
                    let _e1691 = local[_e1687];
                    if (_e1688 < 8u) {
                    } else {
                        break;
                    }
                    let _e1694 = local[_e1688];
                    let _e1700 = ((1f - _e1691.w) / select(0.000000000000000000000000000000000000011754944f, _e1694.w, (_e1694.w > 0.000000000000000000000000000000000000011754944f)));
                    let _e1702 = select(1f, _e1700, (_e1700 < 1f));
                    let _e1717 = (_e1685 + _e1687);
                    if (_e1717 < 8u) {
                    } else {
                        break;
                    }
                    let _e1720 = local[_e1717];
                    let _e1721 = (_e1685 + _e1688);
                    if (_e1721 < 8u) {
                    } else {
                        break;
                    }
                    let _e1724 = local[_e1721];
                    let _e1730 = ((1f - _e1720.w) / select(0.000000000000000000000000000000000000011754944f, _e1724.w, (_e1724.w > 0.000000000000000000000000000000000000011754944f)));
                    let _e1732 = select(1f, _e1730, (_e1730 < 1f));
                    let _e1751 = (_e1686 + _e1687);
                    if (_e1751 < 8u) {
                    } else {
                        break;
                    }
                    let _e1754 = local[_e1751];
                    let _e1755 = (_e1686 + _e1688);
                    if (_e1755 < 8u) {
                    } else {
                        break;
                    }
                    let _e1758 = local[_e1755];
                    let _e1764 = ((1f - _e1754.w) / select(0.000000000000000000000000000000000000011754944f, _e1758.w, (_e1758.w > 0.000000000000000000000000000000000000011754944f)));
                    let _e1766 = select(1f, _e1764, (_e1764 < 1f));
                    let _e1785 = (_e1685 + _e1686);
                    let _e1786 = (_e1785 + _e1687);
                    if (_e1786 < 8u) {
                    } else {
                        break;
                    }
                    let _e1789 = local[_e1786];
                    let _e1790 = (_e1785 + _e1688);
                    if (_e1790 < 8u) {
                    } else {
                        break;
                    }
                    let _e1793 = local[_e1790];
                    let _e1799 = ((1f - _e1789.w) / select(0.000000000000000000000000000000000000011754944f, _e1793.w, (_e1793.w > 0.000000000000000000000000000000000000011754944f)));
                    let _e1801 = select(1f, _e1799, (_e1799 < 1f));
                    phi_2248_ = vec4<f32>((((((_e1691.x + (_e1694.x * _e1702)) + (_e1720.x + (_e1724.x * _e1732))) + (_e1754.x + (_e1758.x * _e1766))) + (_e1789.x + (_e1793.x * _e1801))) * 0.25f), (((((_e1691.y + (_e1694.y * _e1702)) + (_e1720.y + (_e1724.y * _e1732))) + (_e1754.y + (_e1758.y * _e1766))) + (_e1789.y + (_e1793.y * _e1801))) * 0.25f), (((((_e1691.z + (_e1694.z * _e1702)) + (_e1720.z + (_e1724.z * _e1732))) + (_e1754.z + (_e1758.z * _e1766))) + (_e1789.z + (_e1793.z * _e1801))) * 0.25f), (((((_e1691.w + (_e1694.w * _e1702)) + (_e1720.w + (_e1724.w * _e1732))) + (_e1754.w + (_e1758.w * _e1766))) + (_e1789.w + (_e1793.w * _e1801))) * 0.25f));
                }
                let _e1907 = phi_2248_;
                let _e1910 = ((_e43 + _e50) + (_e50 - _e50));
                if (_e1910 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e1910] = _e1907;
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
