struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_13 {
    member: type_12,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_13;
@group(0) @binding(1) 
var<storage> directions: type_5;
@group(0) @binding(2) 
var<storage, read_write> table: type_5;

fn function_() {
    var phi_88_: u32;
    var phi_131_: u32;
    var phi_132_: u32;
    var phi_149_: bool;
    var local: u32;
    var local_1: u32;
    var phi_162_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_181_: type_10;
    var phi_184_: f32;
    var phi_182_: type_10;
    var phi_207_: type_10;
    var local_4: u32;
    var phi_185_: f32;
    var local_5: u32;
    var phi_231_: type_10;
    var phi_234_: f32;
    var phi_232_: type_10;
    var phi_257_: type_10;
    var phi_235_: f32;
    var local_6: f32;
    var local_7: f32;
    var phi_269_: f32;
    var phi_272_: u32;
    var phi_273_: u32;
    var phi_290_: bool;
    var local_8: u32;
    var local_9: u32;
    var phi_303_: u32;
    var local_10: u32;
    var local_11: u32;
    var phi_322_: type_10;
    var phi_325_: f32;
    var phi_323_: type_10;
    var phi_348_: type_10;
    var local_12: u32;
    var phi_326_: f32;
    var local_13: u32;
    var phi_372_: type_10;
    var phi_375_: f32;
    var phi_373_: type_10;
    var phi_398_: type_10;
    var phi_376_: f32;
    var local_14: f32;
    var local_15: f32;
    var phi_410_: f32;
    var phi_413_: u32;
    var phi_414_: u32;
    var phi_431_: bool;
    var local_16: u32;
    var local_17: u32;
    var phi_444_: u32;
    var local_18: u32;
    var local_19: u32;
    var phi_463_: type_10;
    var phi_466_: f32;
    var phi_464_: type_10;
    var phi_489_: type_10;
    var local_20: u32;
    var phi_467_: f32;
    var local_21: u32;
    var phi_513_: type_10;
    var phi_516_: f32;
    var phi_514_: type_10;
    var phi_539_: type_10;
    var phi_517_: f32;
    var local_22: f32;
    var local_23: f32;
    var phi_551_: f32;
    var phi_554_: u32;
    var phi_555_: u32;
    var phi_572_: bool;
    var local_24: u32;
    var local_25: u32;
    var phi_585_: u32;
    var local_26: u32;
    var local_27: u32;
    var phi_604_: type_10;
    var phi_607_: f32;
    var phi_605_: type_10;
    var phi_630_: type_10;
    var local_28: u32;
    var phi_608_: f32;
    var local_29: u32;
    var phi_654_: type_10;
    var phi_657_: f32;
    var phi_655_: type_10;
    var phi_680_: type_10;
    var phi_658_: f32;
    var local_30: f32;
    var local_31: f32;
    var phi_692_: f32;
    var phi_705_: f32;
    var phi_712_: type_10;
    var phi_715_: f32;
    var phi_717_: f32;
    var phi_713_: type_10;
    var phi_739_: type_10;
    var phi_716_: f32;
    var local_32: u32;
    var phi_754_: type_10;
    var phi_757_: f32;
    var phi_759_: f32;
    var phi_761_: f32;
    var phi_763_: f32;
    var phi_755_: type_10;
    var phi_785_: type_10;
    var phi_758_: f32;
    var phi_760_: f32;
    var phi_762_: f32;
    var local_33: f32;
    var phi_812_: f32;
    var phi_819_: type_10;
    var phi_822_: f32;
    var phi_824_: f32;
    var phi_820_: type_10;
    var phi_846_: type_10;
    var phi_823_: f32;
    var local_34: u32;
    var phi_861_: type_10;
    var phi_864_: f32;
    var phi_866_: f32;
    var phi_868_: f32;
    var phi_870_: f32;
    var phi_862_: type_10;
    var phi_892_: type_10;
    var phi_865_: f32;
    var phi_867_: f32;
    var phi_869_: f32;
    var local_35: f32;
    var phi_919_: f32;
    var phi_926_: type_10;
    var phi_929_: f32;
    var phi_931_: f32;
    var phi_927_: type_10;
    var phi_953_: type_10;
    var phi_930_: f32;
    var local_36: u32;
    var phi_968_: type_10;
    var phi_971_: f32;
    var phi_973_: f32;
    var phi_975_: f32;
    var phi_977_: f32;
    var phi_969_: type_10;
    var phi_999_: type_10;
    var phi_972_: f32;
    var phi_974_: f32;
    var phi_976_: f32;
    var local_37: f32;
    var phi_1026_: f32;
    var phi_1033_: type_10;
    var phi_1036_: f32;
    var phi_1038_: f32;
    var phi_1034_: type_10;
    var phi_1060_: type_10;
    var phi_1037_: f32;
    var local_38: u32;
    var phi_1075_: type_10;
    var phi_1078_: f32;
    var phi_1080_: f32;
    var phi_1082_: f32;
    var phi_1084_: f32;
    var phi_1076_: type_10;
    var phi_1106_: type_10;
    var phi_1079_: f32;
    var phi_1081_: f32;
    var phi_1083_: f32;
    var local_39: f32;
    var local_40: f32;
    var local_41: f32;
    var local_42: f32;
    var local_43: f32;
    var local_44: f32;
    var local_45: f32;
    var local_46: f32;
    var local_47: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = gid_1;
            let _e25 = params.member.member_2;
            let _e28 = (select(_e25, 9u, (_e25 > 9u)) + 1u);
            let _e29 = (_e28 * _e28);
            let _e30 = (_e29 / 4u);
            if ((_e29 % 4u) > 0u) {
                phi_88_ = (_e30 + 1u);
            } else {
                phi_88_ = _e30;
            }
            let _e35 = phi_88_;
            let _e38 = params.member.member_1;
            let _e39 = (_e35 * _e38);
            let _e43 = (_e22.x + (_e22.y * 2097152u));
            if (_e43 < _e39) {
                if (_e38 == 0u) {
                    break;
                }
                let _e46 = (_e43 / _e38);
                let _e48 = (_e43 - (_e46 * _e38));
                let _e51 = directions.member[_e48];
                let _e55 = directions.member[(_e38 + _e48)];
                let _e60 = directions.member[((2u * _e38) + _e48)];
                let _e65 = directions.member[((3u * _e38) + _e48)];
                let _e66 = (_e46 * 4u);
                phi_131_ = 0u;
                loop {
                    let _e68 = phi_131_;
                    local = _e68;
                    local_2 = _e68;
                    local_3 = _e68;
                    local_4 = _e68;
                    local_5 = _e68;
                    local_32 = _e68;
                    let _e69 = (_e68 + 1u);
                    local_1 = _e69;
                    if ((_e69 * _e69) <= _e66) {
                        let _e72 = (_e68 < 9u);
                        phi_132_ = select(u32(), _e69, _e72);
                        phi_149_ = _e72;
                    } else {
                        phi_132_ = u32();
                        phi_149_ = false;
                    }
                    let _e75 = phi_132_;
                    let _e77 = phi_149_;
                    continue;
                    continuing {
                        phi_131_ = _e75;
                        break if !(_e77);
                    }
                }
                let _e80 = local;
                let _e82 = local_1;
                let _e83 = (_e80 * _e82);
                let _e84 = (_e66 < _e83);
                if _e84 {
                    phi_162_ = (_e83 - _e66);
                } else {
                    phi_162_ = (_e66 - _e83);
                }
                let _e88 = phi_162_;
                let _e90 = local_2;
                if (_e90 <= _e25) {
                    let _e93 = local_3;
                    phi_181_ = type_10(1u, (_e88 + 1u));
                    phi_184_ = (f32(((2u * _e93) + 1u)) / select(6.2831855f, 12.566371f, (_e88 == 0u)));
                    loop {
                        let _e103 = phi_181_;
                        let _e105 = phi_184_;
                        local_6 = _e105;
                        if (_e103.member < _e103.member_1) {
                            phi_182_ = type_10((_e103.member + 1u), _e103.member_1);
                            phi_207_ = type_10(1u, _e103.member);
                        } else {
                            phi_182_ = _e103;
                            phi_207_ = type_10(0u, type_10().member_1);
                        }
                        let _e118 = phi_182_;
                        let _e120 = phi_207_;
                        let _e124 = (bitcast<i32>(_e120.member) != 0i);
                        if _e124 {
                            let _e125 = (2u * _e120.member_1);
                            let _e127 = f32((_e125 - 1u));
                            let _e129 = local_4;
                            let _e132 = f32(((_e129 - _e88) + _e125));
                            phi_185_ = (_e105 * ((_e127 * _e127) / (_e132 * (_e132 - 1f))));
                        } else {
                            phi_185_ = f32();
                        }
                        let _e139 = phi_185_;
                        continue;
                        continuing {
                            phi_181_ = _e118;
                            phi_184_ = _e139;
                            break if !(_e124);
                        }
                    }
                    let _e142 = local_5;
                    phi_231_ = type_10(1u, ((_e142 - _e88) + 1u));
                    phi_234_ = 1f;
                    loop {
                        let _e147 = phi_231_;
                        let _e149 = phi_234_;
                        local_7 = _e149;
                        if (_e147.member < _e147.member_1) {
                            phi_232_ = type_10((_e147.member + 1u), _e147.member_1);
                            phi_257_ = type_10(1u, _e147.member);
                        } else {
                            phi_232_ = _e147;
                            phi_257_ = type_10(0u, type_10().member_1);
                        }
                        let _e162 = phi_232_;
                        let _e164 = phi_257_;
                        let _e168 = (bitcast<i32>(_e164.member) != 0i);
                        if _e168 {
                            phi_235_ = (_e149 * f32(_e164.member_1));
                        } else {
                            phi_235_ = f32();
                        }
                        let _e172 = phi_235_;
                        continue;
                        continuing {
                            phi_231_ = _e162;
                            phi_234_ = _e172;
                            break if !(_e168);
                        }
                    }
                    let _e175 = local_6;
                    let _e178 = local_7;
                    phi_269_ = (sqrt(_e175) / _e178);
                } else {
                    phi_269_ = 0f;
                }
                let _e181 = phi_269_;
                let _e182 = (_e66 + 1u);
                phi_272_ = 0u;
                loop {
                    let _e184 = phi_272_;
                    local_8 = _e184;
                    local_10 = _e184;
                    local_11 = _e184;
                    local_12 = _e184;
                    local_13 = _e184;
                    local_34 = _e184;
                    let _e185 = (_e184 + 1u);
                    local_9 = _e185;
                    if ((_e185 * _e185) <= _e182) {
                        let _e188 = (_e184 < 9u);
                        phi_273_ = select(u32(), _e185, _e188);
                        phi_290_ = _e188;
                    } else {
                        phi_273_ = u32();
                        phi_290_ = false;
                    }
                    let _e191 = phi_273_;
                    let _e193 = phi_290_;
                    continue;
                    continuing {
                        phi_272_ = _e191;
                        break if !(_e193);
                    }
                }
                let _e196 = local_8;
                let _e198 = local_9;
                let _e199 = (_e196 * _e198);
                let _e200 = (_e182 < _e199);
                if _e200 {
                    phi_303_ = (_e199 - _e182);
                } else {
                    phi_303_ = (_e182 - _e199);
                }
                let _e204 = phi_303_;
                let _e206 = local_10;
                if (_e206 <= _e25) {
                    let _e209 = local_11;
                    phi_322_ = type_10(1u, (_e204 + 1u));
                    phi_325_ = (f32(((2u * _e209) + 1u)) / select(6.2831855f, 12.566371f, (_e204 == 0u)));
                    loop {
                        let _e219 = phi_322_;
                        let _e221 = phi_325_;
                        local_14 = _e221;
                        if (_e219.member < _e219.member_1) {
                            phi_323_ = type_10((_e219.member + 1u), _e219.member_1);
                            phi_348_ = type_10(1u, _e219.member);
                        } else {
                            phi_323_ = _e219;
                            phi_348_ = type_10(0u, type_10().member_1);
                        }
                        let _e234 = phi_323_;
                        let _e236 = phi_348_;
                        let _e240 = (bitcast<i32>(_e236.member) != 0i);
                        if _e240 {
                            let _e241 = (2u * _e236.member_1);
                            let _e243 = f32((_e241 - 1u));
                            let _e245 = local_12;
                            let _e248 = f32(((_e245 - _e204) + _e241));
                            phi_326_ = (_e221 * ((_e243 * _e243) / (_e248 * (_e248 - 1f))));
                        } else {
                            phi_326_ = f32();
                        }
                        let _e255 = phi_326_;
                        continue;
                        continuing {
                            phi_322_ = _e234;
                            phi_325_ = _e255;
                            break if !(_e240);
                        }
                    }
                    let _e258 = local_13;
                    phi_372_ = type_10(1u, ((_e258 - _e204) + 1u));
                    phi_375_ = 1f;
                    loop {
                        let _e263 = phi_372_;
                        let _e265 = phi_375_;
                        local_15 = _e265;
                        if (_e263.member < _e263.member_1) {
                            phi_373_ = type_10((_e263.member + 1u), _e263.member_1);
                            phi_398_ = type_10(1u, _e263.member);
                        } else {
                            phi_373_ = _e263;
                            phi_398_ = type_10(0u, type_10().member_1);
                        }
                        let _e278 = phi_373_;
                        let _e280 = phi_398_;
                        let _e284 = (bitcast<i32>(_e280.member) != 0i);
                        if _e284 {
                            phi_376_ = (_e265 * f32(_e280.member_1));
                        } else {
                            phi_376_ = f32();
                        }
                        let _e288 = phi_376_;
                        continue;
                        continuing {
                            phi_372_ = _e278;
                            phi_375_ = _e288;
                            break if !(_e284);
                        }
                    }
                    let _e291 = local_14;
                    let _e294 = local_15;
                    phi_410_ = (sqrt(_e291) / _e294);
                } else {
                    phi_410_ = 0f;
                }
                let _e297 = phi_410_;
                let _e298 = (_e66 + 2u);
                phi_413_ = 0u;
                loop {
                    let _e300 = phi_413_;
                    local_16 = _e300;
                    local_18 = _e300;
                    local_19 = _e300;
                    local_20 = _e300;
                    local_21 = _e300;
                    local_36 = _e300;
                    let _e301 = (_e300 + 1u);
                    local_17 = _e301;
                    if ((_e301 * _e301) <= _e298) {
                        let _e304 = (_e300 < 9u);
                        phi_414_ = select(u32(), _e301, _e304);
                        phi_431_ = _e304;
                    } else {
                        phi_414_ = u32();
                        phi_431_ = false;
                    }
                    let _e307 = phi_414_;
                    let _e309 = phi_431_;
                    continue;
                    continuing {
                        phi_413_ = _e307;
                        break if !(_e309);
                    }
                }
                let _e312 = local_16;
                let _e314 = local_17;
                let _e315 = (_e312 * _e314);
                let _e316 = (_e298 < _e315);
                if _e316 {
                    phi_444_ = (_e315 - _e298);
                } else {
                    phi_444_ = (_e298 - _e315);
                }
                let _e320 = phi_444_;
                let _e322 = local_18;
                if (_e322 <= _e25) {
                    let _e325 = local_19;
                    phi_463_ = type_10(1u, (_e320 + 1u));
                    phi_466_ = (f32(((2u * _e325) + 1u)) / select(6.2831855f, 12.566371f, (_e320 == 0u)));
                    loop {
                        let _e335 = phi_463_;
                        let _e337 = phi_466_;
                        local_22 = _e337;
                        if (_e335.member < _e335.member_1) {
                            phi_464_ = type_10((_e335.member + 1u), _e335.member_1);
                            phi_489_ = type_10(1u, _e335.member);
                        } else {
                            phi_464_ = _e335;
                            phi_489_ = type_10(0u, type_10().member_1);
                        }
                        let _e350 = phi_464_;
                        let _e352 = phi_489_;
                        let _e356 = (bitcast<i32>(_e352.member) != 0i);
                        if _e356 {
                            let _e357 = (2u * _e352.member_1);
                            let _e359 = f32((_e357 - 1u));
                            let _e361 = local_20;
                            let _e364 = f32(((_e361 - _e320) + _e357));
                            phi_467_ = (_e337 * ((_e359 * _e359) / (_e364 * (_e364 - 1f))));
                        } else {
                            phi_467_ = f32();
                        }
                        let _e371 = phi_467_;
                        continue;
                        continuing {
                            phi_463_ = _e350;
                            phi_466_ = _e371;
                            break if !(_e356);
                        }
                    }
                    let _e374 = local_21;
                    phi_513_ = type_10(1u, ((_e374 - _e320) + 1u));
                    phi_516_ = 1f;
                    loop {
                        let _e379 = phi_513_;
                        let _e381 = phi_516_;
                        local_23 = _e381;
                        if (_e379.member < _e379.member_1) {
                            phi_514_ = type_10((_e379.member + 1u), _e379.member_1);
                            phi_539_ = type_10(1u, _e379.member);
                        } else {
                            phi_514_ = _e379;
                            phi_539_ = type_10(0u, type_10().member_1);
                        }
                        let _e394 = phi_514_;
                        let _e396 = phi_539_;
                        let _e400 = (bitcast<i32>(_e396.member) != 0i);
                        if _e400 {
                            phi_517_ = (_e381 * f32(_e396.member_1));
                        } else {
                            phi_517_ = f32();
                        }
                        let _e404 = phi_517_;
                        continue;
                        continuing {
                            phi_513_ = _e394;
                            phi_516_ = _e404;
                            break if !(_e400);
                        }
                    }
                    let _e407 = local_22;
                    let _e410 = local_23;
                    phi_551_ = (sqrt(_e407) / _e410);
                } else {
                    phi_551_ = 0f;
                }
                let _e413 = phi_551_;
                let _e414 = (_e66 + 3u);
                phi_554_ = 0u;
                loop {
                    let _e416 = phi_554_;
                    local_24 = _e416;
                    local_26 = _e416;
                    local_27 = _e416;
                    local_28 = _e416;
                    local_29 = _e416;
                    local_38 = _e416;
                    let _e417 = (_e416 + 1u);
                    local_25 = _e417;
                    if ((_e417 * _e417) <= _e414) {
                        let _e420 = (_e416 < 9u);
                        phi_555_ = select(u32(), _e417, _e420);
                        phi_572_ = _e420;
                    } else {
                        phi_555_ = u32();
                        phi_572_ = false;
                    }
                    let _e423 = phi_555_;
                    let _e425 = phi_572_;
                    continue;
                    continuing {
                        phi_554_ = _e423;
                        break if !(_e425);
                    }
                }
                let _e428 = local_24;
                let _e430 = local_25;
                let _e431 = (_e428 * _e430);
                let _e432 = (_e414 < _e431);
                if _e432 {
                    phi_585_ = (_e431 - _e414);
                } else {
                    phi_585_ = (_e414 - _e431);
                }
                let _e436 = phi_585_;
                let _e438 = local_26;
                if (_e438 <= _e25) {
                    let _e441 = local_27;
                    phi_604_ = type_10(1u, (_e436 + 1u));
                    phi_607_ = (f32(((2u * _e441) + 1u)) / select(6.2831855f, 12.566371f, (_e436 == 0u)));
                    loop {
                        let _e451 = phi_604_;
                        let _e453 = phi_607_;
                        local_30 = _e453;
                        if (_e451.member < _e451.member_1) {
                            phi_605_ = type_10((_e451.member + 1u), _e451.member_1);
                            phi_630_ = type_10(1u, _e451.member);
                        } else {
                            phi_605_ = _e451;
                            phi_630_ = type_10(0u, type_10().member_1);
                        }
                        let _e466 = phi_605_;
                        let _e468 = phi_630_;
                        let _e472 = (bitcast<i32>(_e468.member) != 0i);
                        if _e472 {
                            let _e473 = (2u * _e468.member_1);
                            let _e475 = f32((_e473 - 1u));
                            let _e477 = local_28;
                            let _e480 = f32(((_e477 - _e436) + _e473));
                            phi_608_ = (_e453 * ((_e475 * _e475) / (_e480 * (_e480 - 1f))));
                        } else {
                            phi_608_ = f32();
                        }
                        let _e487 = phi_608_;
                        continue;
                        continuing {
                            phi_604_ = _e466;
                            phi_607_ = _e487;
                            break if !(_e472);
                        }
                    }
                    let _e490 = local_29;
                    phi_654_ = type_10(1u, ((_e490 - _e436) + 1u));
                    phi_657_ = 1f;
                    loop {
                        let _e495 = phi_654_;
                        let _e497 = phi_657_;
                        local_31 = _e497;
                        if (_e495.member < _e495.member_1) {
                            phi_655_ = type_10((_e495.member + 1u), _e495.member_1);
                            phi_680_ = type_10(1u, _e495.member);
                        } else {
                            phi_655_ = _e495;
                            phi_680_ = type_10(0u, type_10().member_1);
                        }
                        let _e510 = phi_655_;
                        let _e512 = phi_680_;
                        let _e516 = (bitcast<i32>(_e512.member) != 0i);
                        if _e516 {
                            phi_658_ = (_e497 * f32(_e512.member_1));
                        } else {
                            phi_658_ = f32();
                        }
                        let _e520 = phi_658_;
                        continue;
                        continuing {
                            phi_654_ = _e510;
                            phi_657_ = _e520;
                            break if !(_e516);
                        }
                    }
                    let _e523 = local_30;
                    let _e526 = local_31;
                    phi_692_ = (sqrt(_e523) / _e526);
                } else {
                    phi_692_ = 0f;
                }
                let _e529 = phi_692_;
                let _e530 = select(1f, 0f, _e84);
                if (_e88 == 0u) {
                    phi_705_ = _e530;
                } else {
                    phi_705_ = select(_e51, _e55, _e84);
                }
                let _e534 = phi_705_;
                let _e535 = (_e51 + _e51);
                let _e538 = ((_e51 * _e51) + (_e55 * _e55));
                phi_712_ = type_10(1u, _e88);
                phi_715_ = _e534;
                phi_717_ = _e530;
                loop {
                    let _e541 = phi_712_;
                    let _e543 = phi_715_;
                    let _e545 = phi_717_;
                    local_40 = _e543;
                    local_41 = _e545;
                    if (_e541.member < _e541.member_1) {
                        phi_713_ = type_10((_e541.member + 1u), _e541.member_1);
                        phi_739_ = type_10(1u, _e541.member);
                    } else {
                        phi_713_ = _e541;
                        phi_739_ = type_10(0u, type_10().member_1);
                    }
                    let _e558 = phi_713_;
                    let _e560 = phi_739_;
                    let _e563 = (bitcast<i32>(_e560.member) != 0i);
                    if _e563 {
                        phi_716_ = fma(_e535, _e543, -((_e538 * _e545)));
                    } else {
                        phi_716_ = f32();
                    }
                    let _e568 = phi_716_;
                    continue;
                    continuing {
                        phi_712_ = _e558;
                        phi_715_ = _e568;
                        phi_717_ = _e543;
                        break if !(_e563);
                    }
                }
                let _e574 = local_32;
                phi_754_ = type_10(_e88, _e574);
                phi_757_ = f32(((2u * _e88) + 1u));
                phi_759_ = 0f;
                let _e1001 = local_40;
                phi_761_ = _e1001;
                let _e1004 = local_41;
                phi_763_ = _e1004;
                loop {
                    let _e577 = phi_754_;
                    let _e579 = phi_757_;
                    let _e581 = phi_759_;
                    let _e583 = phi_761_;
                    let _e585 = phi_763_;
                    local_33 = _e583;
                    if (_e577.member < _e577.member_1) {
                        phi_755_ = type_10((_e577.member + 1u), _e577.member_1);
                        phi_785_ = type_10(1u, _e577.member);
                    } else {
                        phi_755_ = _e577;
                        phi_785_ = type_10(0u, type_10().member_1);
                    }
                    let _e598 = phi_755_;
                    let _e600 = phi_785_;
                    let _e603 = (bitcast<i32>(_e600.member) != 0i);
                    if _e603 {
                        phi_758_ = (_e579 + 2f);
                        phi_760_ = (_e581 + _e579);
                        phi_762_ = fma((_e60 * _e579), _e583, -((_e581 * _e585)));
                    } else {
                        phi_758_ = f32();
                        phi_760_ = f32();
                        phi_762_ = f32();
                    }
                    let _e611 = phi_758_;
                    let _e613 = phi_760_;
                    let _e615 = phi_762_;
                    continue;
                    continuing {
                        phi_754_ = _e598;
                        phi_757_ = _e611;
                        phi_759_ = _e613;
                        phi_761_ = _e615;
                        phi_763_ = _e583;
                        break if !(_e603);
                    }
                }
                let _e618 = local_33;
                let _e621 = select(1f, 0f, _e200);
                if (_e204 == 0u) {
                    phi_812_ = _e621;
                } else {
                    phi_812_ = select(_e51, _e55, _e200);
                }
                let _e625 = phi_812_;
                phi_819_ = type_10(1u, _e204);
                phi_822_ = _e625;
                phi_824_ = _e621;
                loop {
                    let _e628 = phi_819_;
                    let _e630 = phi_822_;
                    let _e632 = phi_824_;
                    local_42 = _e630;
                    local_43 = _e632;
                    if (_e628.member < _e628.member_1) {
                        phi_820_ = type_10((_e628.member + 1u), _e628.member_1);
                        phi_846_ = type_10(1u, _e628.member);
                    } else {
                        phi_820_ = _e628;
                        phi_846_ = type_10(0u, type_10().member_1);
                    }
                    let _e645 = phi_820_;
                    let _e647 = phi_846_;
                    let _e650 = (bitcast<i32>(_e647.member) != 0i);
                    if _e650 {
                        phi_823_ = fma(_e535, _e630, -((_e538 * _e632)));
                    } else {
                        phi_823_ = f32();
                    }
                    let _e655 = phi_823_;
                    continue;
                    continuing {
                        phi_819_ = _e645;
                        phi_822_ = _e655;
                        phi_824_ = _e630;
                        break if !(_e650);
                    }
                }
                let _e661 = local_34;
                phi_861_ = type_10(_e204, _e661);
                phi_864_ = f32(((2u * _e204) + 1u));
                phi_866_ = 0f;
                let _e1024 = local_42;
                phi_868_ = _e1024;
                let _e1027 = local_43;
                phi_870_ = _e1027;
                loop {
                    let _e664 = phi_861_;
                    let _e666 = phi_864_;
                    let _e668 = phi_866_;
                    let _e670 = phi_868_;
                    let _e672 = phi_870_;
                    local_35 = _e670;
                    if (_e664.member < _e664.member_1) {
                        phi_862_ = type_10((_e664.member + 1u), _e664.member_1);
                        phi_892_ = type_10(1u, _e664.member);
                    } else {
                        phi_862_ = _e664;
                        phi_892_ = type_10(0u, type_10().member_1);
                    }
                    let _e685 = phi_862_;
                    let _e687 = phi_892_;
                    let _e690 = (bitcast<i32>(_e687.member) != 0i);
                    if _e690 {
                        phi_865_ = (_e666 + 2f);
                        phi_867_ = (_e668 + _e666);
                        phi_869_ = fma((_e60 * _e666), _e670, -((_e668 * _e672)));
                    } else {
                        phi_865_ = f32();
                        phi_867_ = f32();
                        phi_869_ = f32();
                    }
                    let _e698 = phi_865_;
                    let _e700 = phi_867_;
                    let _e702 = phi_869_;
                    continue;
                    continuing {
                        phi_861_ = _e685;
                        phi_864_ = _e698;
                        phi_866_ = _e700;
                        phi_868_ = _e702;
                        phi_870_ = _e670;
                        break if !(_e690);
                    }
                }
                let _e705 = local_35;
                let _e708 = select(1f, 0f, _e316);
                if (_e320 == 0u) {
                    phi_919_ = _e708;
                } else {
                    phi_919_ = select(_e51, _e55, _e316);
                }
                let _e712 = phi_919_;
                phi_926_ = type_10(1u, _e320);
                phi_929_ = _e712;
                phi_931_ = _e708;
                loop {
                    let _e715 = phi_926_;
                    let _e717 = phi_929_;
                    let _e719 = phi_931_;
                    local_44 = _e717;
                    local_45 = _e719;
                    if (_e715.member < _e715.member_1) {
                        phi_927_ = type_10((_e715.member + 1u), _e715.member_1);
                        phi_953_ = type_10(1u, _e715.member);
                    } else {
                        phi_927_ = _e715;
                        phi_953_ = type_10(0u, type_10().member_1);
                    }
                    let _e732 = phi_927_;
                    let _e734 = phi_953_;
                    let _e737 = (bitcast<i32>(_e734.member) != 0i);
                    if _e737 {
                        phi_930_ = fma(_e535, _e717, -((_e538 * _e719)));
                    } else {
                        phi_930_ = f32();
                    }
                    let _e742 = phi_930_;
                    continue;
                    continuing {
                        phi_926_ = _e732;
                        phi_929_ = _e742;
                        phi_931_ = _e717;
                        break if !(_e737);
                    }
                }
                let _e748 = local_36;
                phi_968_ = type_10(_e320, _e748);
                phi_971_ = f32(((2u * _e320) + 1u));
                phi_973_ = 0f;
                let _e1047 = local_44;
                phi_975_ = _e1047;
                let _e1050 = local_45;
                phi_977_ = _e1050;
                loop {
                    let _e751 = phi_968_;
                    let _e753 = phi_971_;
                    let _e755 = phi_973_;
                    let _e757 = phi_975_;
                    let _e759 = phi_977_;
                    local_37 = _e757;
                    if (_e751.member < _e751.member_1) {
                        phi_969_ = type_10((_e751.member + 1u), _e751.member_1);
                        phi_999_ = type_10(1u, _e751.member);
                    } else {
                        phi_969_ = _e751;
                        phi_999_ = type_10(0u, type_10().member_1);
                    }
                    let _e772 = phi_969_;
                    let _e774 = phi_999_;
                    let _e777 = (bitcast<i32>(_e774.member) != 0i);
                    if _e777 {
                        phi_972_ = (_e753 + 2f);
                        phi_974_ = (_e755 + _e753);
                        phi_976_ = fma((_e60 * _e753), _e757, -((_e755 * _e759)));
                    } else {
                        phi_972_ = f32();
                        phi_974_ = f32();
                        phi_976_ = f32();
                    }
                    let _e785 = phi_972_;
                    let _e787 = phi_974_;
                    let _e789 = phi_976_;
                    continue;
                    continuing {
                        phi_968_ = _e772;
                        phi_971_ = _e785;
                        phi_973_ = _e787;
                        phi_975_ = _e789;
                        phi_977_ = _e757;
                        break if !(_e777);
                    }
                }
                let _e792 = local_37;
                let _e795 = select(1f, 0f, _e432);
                if (_e436 == 0u) {
                    phi_1026_ = _e795;
                } else {
                    phi_1026_ = select(_e51, _e55, _e432);
                }
                let _e799 = phi_1026_;
                phi_1033_ = type_10(1u, _e436);
                phi_1036_ = _e799;
                phi_1038_ = _e795;
                loop {
                    let _e802 = phi_1033_;
                    let _e804 = phi_1036_;
                    let _e806 = phi_1038_;
                    local_46 = _e804;
                    local_47 = _e806;
                    if (_e802.member < _e802.member_1) {
                        phi_1034_ = type_10((_e802.member + 1u), _e802.member_1);
                        phi_1060_ = type_10(1u, _e802.member);
                    } else {
                        phi_1034_ = _e802;
                        phi_1060_ = type_10(0u, type_10().member_1);
                    }
                    let _e819 = phi_1034_;
                    let _e821 = phi_1060_;
                    let _e824 = (bitcast<i32>(_e821.member) != 0i);
                    if _e824 {
                        phi_1037_ = fma(_e535, _e804, -((_e538 * _e806)));
                    } else {
                        phi_1037_ = f32();
                    }
                    let _e829 = phi_1037_;
                    continue;
                    continuing {
                        phi_1033_ = _e819;
                        phi_1036_ = _e829;
                        phi_1038_ = _e804;
                        break if !(_e824);
                    }
                }
                let _e835 = local_38;
                phi_1075_ = type_10(_e436, _e835);
                phi_1078_ = f32(((2u * _e436) + 1u));
                phi_1080_ = 0f;
                let _e1070 = local_46;
                phi_1082_ = _e1070;
                let _e1073 = local_47;
                phi_1084_ = _e1073;
                loop {
                    let _e838 = phi_1075_;
                    let _e840 = phi_1078_;
                    let _e842 = phi_1080_;
                    let _e844 = phi_1082_;
                    let _e846 = phi_1084_;
                    local_39 = _e844;
                    if (_e838.member < _e838.member_1) {
                        phi_1076_ = type_10((_e838.member + 1u), _e838.member_1);
                        phi_1106_ = type_10(1u, _e838.member);
                    } else {
                        phi_1076_ = _e838;
                        phi_1106_ = type_10(0u, type_10().member_1);
                    }
                    let _e859 = phi_1076_;
                    let _e861 = phi_1106_;
                    let _e864 = (bitcast<i32>(_e861.member) != 0i);
                    if _e864 {
                        phi_1079_ = (_e840 + 2f);
                        phi_1081_ = (_e842 + _e840);
                        phi_1083_ = fma((_e60 * _e840), _e844, -((_e842 * _e846)));
                    } else {
                        phi_1079_ = f32();
                        phi_1081_ = f32();
                        phi_1083_ = f32();
                    }
                    let _e872 = phi_1079_;
                    let _e874 = phi_1081_;
                    let _e876 = phi_1083_;
                    continue;
                    continuing {
                        phi_1075_ = _e859;
                        phi_1078_ = _e872;
                        phi_1080_ = _e874;
                        phi_1082_ = _e876;
                        phi_1084_ = _e844;
                        break if !(_e864);
                    }
                }
                let _e879 = local_39;
                table.member[_e43] = (_e65 * (_e618 * _e181));
                table.member[(_e39 + _e43)] = (_e65 * (_e705 * _e297));
                table.member[((2u * _e39) + _e43)] = (_e65 * (_e792 * _e413));
                table.member[((3u * _e39) + _e43)] = (_e65 * (_e879 * _e529));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_basis(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
