struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_16 {
    member: type_15,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_16;
@group(0) @binding(1) 
var<storage> directions: type_5;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(3) 
var<storage, read_write> coefs: type_5;

fn function_() {
    var local: array<f32, 12>;
    var phi_86_: u32;
    var phi_105_: u32;
    var phi_169_: u32;
    var phi_193_: u32;
    var phi_194_: u32;
    var phi_211_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_224_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_243_: type_12;
    var phi_246_: f32;
    var phi_244_: type_12;
    var phi_269_: type_12;
    var local_5: u32;
    var phi_247_: f32;
    var local_6: u32;
    var phi_293_: type_12;
    var phi_296_: f32;
    var phi_294_: type_12;
    var phi_319_: type_12;
    var phi_297_: f32;
    var local_7: f32;
    var local_8: f32;
    var phi_331_: f32;
    var phi_334_: u32;
    var phi_335_: u32;
    var phi_352_: bool;
    var local_9: u32;
    var local_10: u32;
    var phi_365_: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_384_: type_12;
    var phi_387_: f32;
    var phi_385_: type_12;
    var phi_410_: type_12;
    var local_13: u32;
    var phi_388_: f32;
    var local_14: u32;
    var phi_434_: type_12;
    var phi_437_: f32;
    var phi_435_: type_12;
    var phi_460_: type_12;
    var phi_438_: f32;
    var local_15: f32;
    var local_16: f32;
    var phi_472_: f32;
    var phi_475_: u32;
    var phi_476_: u32;
    var phi_493_: bool;
    var local_17: u32;
    var local_18: u32;
    var phi_506_: u32;
    var local_19: u32;
    var local_20: u32;
    var phi_525_: type_12;
    var phi_528_: f32;
    var phi_526_: type_12;
    var phi_551_: type_12;
    var local_21: u32;
    var phi_529_: f32;
    var local_22: u32;
    var phi_575_: type_12;
    var phi_578_: f32;
    var phi_576_: type_12;
    var phi_601_: type_12;
    var phi_579_: f32;
    var local_23: f32;
    var local_24: f32;
    var phi_613_: f32;
    var phi_616_: u32;
    var phi_617_: u32;
    var phi_634_: bool;
    var local_25: u32;
    var local_26: u32;
    var phi_647_: u32;
    var local_27: u32;
    var local_28: u32;
    var phi_666_: type_12;
    var phi_669_: f32;
    var phi_667_: type_12;
    var phi_692_: type_12;
    var local_29: u32;
    var phi_670_: f32;
    var local_30: u32;
    var phi_716_: type_12;
    var phi_719_: f32;
    var phi_717_: type_12;
    var phi_742_: type_12;
    var phi_720_: f32;
    var local_31: f32;
    var local_32: f32;
    var phi_754_: f32;
    var phi_760_: type_12;
    var phi_763_: array<f32, 12>;
    var phi_761_: type_12;
    var phi_786_: type_12;
    var phi_825_: f32;
    var phi_832_: type_12;
    var phi_835_: f32;
    var phi_837_: f32;
    var phi_833_: type_12;
    var phi_859_: type_12;
    var phi_836_: f32;
    var local_33: u32;
    var phi_874_: type_12;
    var phi_877_: f32;
    var phi_879_: f32;
    var phi_881_: f32;
    var phi_883_: f32;
    var phi_875_: type_12;
    var phi_905_: type_12;
    var phi_878_: f32;
    var phi_880_: f32;
    var phi_882_: f32;
    var local_34: f32;
    var phi_943_: f32;
    var phi_950_: type_12;
    var phi_953_: f32;
    var phi_955_: f32;
    var phi_951_: type_12;
    var phi_977_: type_12;
    var phi_954_: f32;
    var local_35: u32;
    var phi_992_: type_12;
    var phi_995_: f32;
    var phi_997_: f32;
    var phi_999_: f32;
    var phi_1001_: f32;
    var phi_993_: type_12;
    var phi_1023_: type_12;
    var phi_996_: f32;
    var phi_998_: f32;
    var phi_1000_: f32;
    var local_36: f32;
    var phi_1061_: f32;
    var phi_1068_: type_12;
    var phi_1071_: f32;
    var phi_1073_: f32;
    var phi_1069_: type_12;
    var phi_1095_: type_12;
    var phi_1072_: f32;
    var local_37: u32;
    var phi_1110_: type_12;
    var phi_1113_: f32;
    var phi_1115_: f32;
    var phi_1117_: f32;
    var phi_1119_: f32;
    var phi_1111_: type_12;
    var phi_1141_: type_12;
    var phi_1114_: f32;
    var phi_1116_: f32;
    var phi_1118_: f32;
    var local_38: f32;
    var phi_1179_: f32;
    var phi_1186_: type_12;
    var phi_1189_: f32;
    var phi_1191_: f32;
    var phi_1187_: type_12;
    var phi_1213_: type_12;
    var phi_1190_: f32;
    var local_39: u32;
    var phi_1228_: type_12;
    var phi_1231_: f32;
    var phi_1233_: f32;
    var phi_1235_: f32;
    var phi_1237_: f32;
    var phi_1229_: type_12;
    var phi_1259_: type_12;
    var phi_1232_: f32;
    var phi_1234_: f32;
    var phi_1236_: f32;
    var local_40: f32;
    var phi_764_: array<f32, 12>;
    var local_41: array<f32, 12>;
    var local_42: array<f32, 12>;
    var local_43: array<f32, 12>;
    var local_44: array<f32, 12>;
    var local_45: array<f32, 12>;
    var local_46: array<f32, 12>;
    var local_47: array<f32, 12>;
    var local_48: array<f32, 12>;
    var local_49: array<f32, 12>;
    var local_50: array<f32, 12>;
    var local_51: array<f32, 12>;
    var local_52: array<f32, 12>;
    var phi_1338_: type_12;
    var phi_1339_: type_12;
    var phi_1362_: type_12;
    var phi_1391_: bool;
    var local_53: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var local_57: f32;
    var local_58: f32;
    var local_59: f32;
    var local_60: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = gid_1;
            let _e37 = params.member.member;
            let _e40 = params.member.member_2;
            let _e43 = (_e37 / 64u);
            if ((_e37 % 64u) > 0u) {
                phi_86_ = (_e43 + 1u);
            } else {
                phi_86_ = _e43;
            }
            let _e48 = phi_86_;
            let _e49 = (select(_e40, 9u, (_e40 > 9u)) + 1u);
            let _e50 = (_e49 * _e49);
            let _e51 = (_e50 / 4u);
            let _e53 = ((_e50 % 4u) > 0u);
            if _e53 {
                phi_105_ = (_e51 + 1u);
            } else {
                phi_105_ = _e51;
            }
            let _e56 = phi_105_;
            let _e58 = ((_e48 * _e56) * 64u);
            let _e62 = (_e32.x + (_e32.y * 2097152u));
            if (_e62 < _e58) {
                let _e64 = (_e62 / 64u);
                if _e53 {
                    phi_169_ = (_e51 + 1u);
                } else {
                    phi_169_ = _e51;
                }
                let _e69 = phi_169_;
                if (_e69 == 0u) {
                    break;
                }
                let _e71 = (_e64 / _e69);
                let _e74 = (_e71 * 64u);
                let _e77 = params.member.member_1;
                let _e84 = ((_e64 - (_e71 * _e69)) * 4u);
                phi_193_ = 0u;
                loop {
                    let _e86 = phi_193_;
                    local_1 = _e86;
                    local_3 = _e86;
                    local_4 = _e86;
                    local_5 = _e86;
                    local_6 = _e86;
                    local_33 = _e86;
                    let _e87 = (_e86 + 1u);
                    local_2 = _e87;
                    if ((_e87 * _e87) <= _e84) {
                        let _e90 = (_e86 < 9u);
                        phi_194_ = select(u32(), _e87, _e90);
                        phi_211_ = _e90;
                    } else {
                        phi_194_ = u32();
                        phi_211_ = false;
                    }
                    let _e93 = phi_194_;
                    let _e95 = phi_211_;
                    continue;
                    continuing {
                        phi_193_ = _e93;
                        break if !(_e95);
                    }
                }
                let _e98 = local_1;
                let _e100 = local_2;
                let _e101 = (_e98 * _e100);
                let _e102 = (_e84 < _e101);
                if _e102 {
                    phi_224_ = (_e101 - _e84);
                } else {
                    phi_224_ = (_e84 - _e101);
                }
                let _e106 = phi_224_;
                let _e108 = local_3;
                if (_e108 <= _e40) {
                    let _e111 = local_4;
                    phi_243_ = type_12(1u, (_e106 + 1u));
                    phi_246_ = (f32(((2u * _e111) + 1u)) / select(6.2831855f, 12.566371f, (_e106 == 0u)));
                    loop {
                        let _e121 = phi_243_;
                        let _e123 = phi_246_;
                        local_7 = _e123;
                        if (_e121.member < _e121.member_1) {
                            phi_244_ = type_12((_e121.member + 1u), _e121.member_1);
                            phi_269_ = type_12(1u, _e121.member);
                        } else {
                            phi_244_ = _e121;
                            phi_269_ = type_12(0u, type_12().member_1);
                        }
                        let _e136 = phi_244_;
                        let _e138 = phi_269_;
                        let _e142 = (bitcast<i32>(_e138.member) != 0i);
                        if _e142 {
                            let _e143 = (2u * _e138.member_1);
                            let _e145 = f32((_e143 - 1u));
                            let _e147 = local_5;
                            let _e150 = f32(((_e147 - _e106) + _e143));
                            phi_247_ = (_e123 * ((_e145 * _e145) / (_e150 * (_e150 - 1f))));
                        } else {
                            phi_247_ = f32();
                        }
                        let _e157 = phi_247_;
                        continue;
                        continuing {
                            phi_243_ = _e136;
                            phi_246_ = _e157;
                            break if !(_e142);
                        }
                    }
                    let _e160 = local_6;
                    phi_293_ = type_12(1u, ((_e160 - _e106) + 1u));
                    phi_296_ = 1f;
                    loop {
                        let _e165 = phi_293_;
                        let _e167 = phi_296_;
                        local_8 = _e167;
                        if (_e165.member < _e165.member_1) {
                            phi_294_ = type_12((_e165.member + 1u), _e165.member_1);
                            phi_319_ = type_12(1u, _e165.member);
                        } else {
                            phi_294_ = _e165;
                            phi_319_ = type_12(0u, type_12().member_1);
                        }
                        let _e180 = phi_294_;
                        let _e182 = phi_319_;
                        let _e186 = (bitcast<i32>(_e182.member) != 0i);
                        if _e186 {
                            phi_297_ = (_e167 * f32(_e182.member_1));
                        } else {
                            phi_297_ = f32();
                        }
                        let _e190 = phi_297_;
                        continue;
                        continuing {
                            phi_293_ = _e180;
                            phi_296_ = _e190;
                            break if !(_e186);
                        }
                    }
                    let _e193 = local_7;
                    let _e196 = local_8;
                    phi_331_ = (sqrt(_e193) / _e196);
                } else {
                    phi_331_ = 0f;
                }
                let _e199 = phi_331_;
                let _e200 = (_e84 + 1u);
                phi_334_ = 0u;
                loop {
                    let _e202 = phi_334_;
                    local_9 = _e202;
                    local_11 = _e202;
                    local_12 = _e202;
                    local_13 = _e202;
                    local_14 = _e202;
                    local_35 = _e202;
                    let _e203 = (_e202 + 1u);
                    local_10 = _e203;
                    if ((_e203 * _e203) <= _e200) {
                        let _e206 = (_e202 < 9u);
                        phi_335_ = select(u32(), _e203, _e206);
                        phi_352_ = _e206;
                    } else {
                        phi_335_ = u32();
                        phi_352_ = false;
                    }
                    let _e209 = phi_335_;
                    let _e211 = phi_352_;
                    continue;
                    continuing {
                        phi_334_ = _e209;
                        break if !(_e211);
                    }
                }
                let _e214 = local_9;
                let _e216 = local_10;
                let _e217 = (_e214 * _e216);
                let _e218 = (_e200 < _e217);
                if _e218 {
                    phi_365_ = (_e217 - _e200);
                } else {
                    phi_365_ = (_e200 - _e217);
                }
                let _e222 = phi_365_;
                let _e224 = local_11;
                if (_e224 <= _e40) {
                    let _e227 = local_12;
                    phi_384_ = type_12(1u, (_e222 + 1u));
                    phi_387_ = (f32(((2u * _e227) + 1u)) / select(6.2831855f, 12.566371f, (_e222 == 0u)));
                    loop {
                        let _e237 = phi_384_;
                        let _e239 = phi_387_;
                        local_15 = _e239;
                        if (_e237.member < _e237.member_1) {
                            phi_385_ = type_12((_e237.member + 1u), _e237.member_1);
                            phi_410_ = type_12(1u, _e237.member);
                        } else {
                            phi_385_ = _e237;
                            phi_410_ = type_12(0u, type_12().member_1);
                        }
                        let _e252 = phi_385_;
                        let _e254 = phi_410_;
                        let _e258 = (bitcast<i32>(_e254.member) != 0i);
                        if _e258 {
                            let _e259 = (2u * _e254.member_1);
                            let _e261 = f32((_e259 - 1u));
                            let _e263 = local_13;
                            let _e266 = f32(((_e263 - _e222) + _e259));
                            phi_388_ = (_e239 * ((_e261 * _e261) / (_e266 * (_e266 - 1f))));
                        } else {
                            phi_388_ = f32();
                        }
                        let _e273 = phi_388_;
                        continue;
                        continuing {
                            phi_384_ = _e252;
                            phi_387_ = _e273;
                            break if !(_e258);
                        }
                    }
                    let _e276 = local_14;
                    phi_434_ = type_12(1u, ((_e276 - _e222) + 1u));
                    phi_437_ = 1f;
                    loop {
                        let _e281 = phi_434_;
                        let _e283 = phi_437_;
                        local_16 = _e283;
                        if (_e281.member < _e281.member_1) {
                            phi_435_ = type_12((_e281.member + 1u), _e281.member_1);
                            phi_460_ = type_12(1u, _e281.member);
                        } else {
                            phi_435_ = _e281;
                            phi_460_ = type_12(0u, type_12().member_1);
                        }
                        let _e296 = phi_435_;
                        let _e298 = phi_460_;
                        let _e302 = (bitcast<i32>(_e298.member) != 0i);
                        if _e302 {
                            phi_438_ = (_e283 * f32(_e298.member_1));
                        } else {
                            phi_438_ = f32();
                        }
                        let _e306 = phi_438_;
                        continue;
                        continuing {
                            phi_434_ = _e296;
                            phi_437_ = _e306;
                            break if !(_e302);
                        }
                    }
                    let _e309 = local_15;
                    let _e312 = local_16;
                    phi_472_ = (sqrt(_e309) / _e312);
                } else {
                    phi_472_ = 0f;
                }
                let _e315 = phi_472_;
                let _e316 = (_e84 + 2u);
                phi_475_ = 0u;
                loop {
                    let _e318 = phi_475_;
                    local_17 = _e318;
                    local_19 = _e318;
                    local_20 = _e318;
                    local_21 = _e318;
                    local_22 = _e318;
                    local_37 = _e318;
                    let _e319 = (_e318 + 1u);
                    local_18 = _e319;
                    if ((_e319 * _e319) <= _e316) {
                        let _e322 = (_e318 < 9u);
                        phi_476_ = select(u32(), _e319, _e322);
                        phi_493_ = _e322;
                    } else {
                        phi_476_ = u32();
                        phi_493_ = false;
                    }
                    let _e325 = phi_476_;
                    let _e327 = phi_493_;
                    continue;
                    continuing {
                        phi_475_ = _e325;
                        break if !(_e327);
                    }
                }
                let _e330 = local_17;
                let _e332 = local_18;
                let _e333 = (_e330 * _e332);
                let _e334 = (_e316 < _e333);
                if _e334 {
                    phi_506_ = (_e333 - _e316);
                } else {
                    phi_506_ = (_e316 - _e333);
                }
                let _e338 = phi_506_;
                let _e340 = local_19;
                if (_e340 <= _e40) {
                    let _e343 = local_20;
                    phi_525_ = type_12(1u, (_e338 + 1u));
                    phi_528_ = (f32(((2u * _e343) + 1u)) / select(6.2831855f, 12.566371f, (_e338 == 0u)));
                    loop {
                        let _e353 = phi_525_;
                        let _e355 = phi_528_;
                        local_23 = _e355;
                        if (_e353.member < _e353.member_1) {
                            phi_526_ = type_12((_e353.member + 1u), _e353.member_1);
                            phi_551_ = type_12(1u, _e353.member);
                        } else {
                            phi_526_ = _e353;
                            phi_551_ = type_12(0u, type_12().member_1);
                        }
                        let _e368 = phi_526_;
                        let _e370 = phi_551_;
                        let _e374 = (bitcast<i32>(_e370.member) != 0i);
                        if _e374 {
                            let _e375 = (2u * _e370.member_1);
                            let _e377 = f32((_e375 - 1u));
                            let _e379 = local_21;
                            let _e382 = f32(((_e379 - _e338) + _e375));
                            phi_529_ = (_e355 * ((_e377 * _e377) / (_e382 * (_e382 - 1f))));
                        } else {
                            phi_529_ = f32();
                        }
                        let _e389 = phi_529_;
                        continue;
                        continuing {
                            phi_525_ = _e368;
                            phi_528_ = _e389;
                            break if !(_e374);
                        }
                    }
                    let _e392 = local_22;
                    phi_575_ = type_12(1u, ((_e392 - _e338) + 1u));
                    phi_578_ = 1f;
                    loop {
                        let _e397 = phi_575_;
                        let _e399 = phi_578_;
                        local_24 = _e399;
                        if (_e397.member < _e397.member_1) {
                            phi_576_ = type_12((_e397.member + 1u), _e397.member_1);
                            phi_601_ = type_12(1u, _e397.member);
                        } else {
                            phi_576_ = _e397;
                            phi_601_ = type_12(0u, type_12().member_1);
                        }
                        let _e412 = phi_576_;
                        let _e414 = phi_601_;
                        let _e418 = (bitcast<i32>(_e414.member) != 0i);
                        if _e418 {
                            phi_579_ = (_e399 * f32(_e414.member_1));
                        } else {
                            phi_579_ = f32();
                        }
                        let _e422 = phi_579_;
                        continue;
                        continuing {
                            phi_575_ = _e412;
                            phi_578_ = _e422;
                            break if !(_e418);
                        }
                    }
                    let _e425 = local_23;
                    let _e428 = local_24;
                    phi_613_ = (sqrt(_e425) / _e428);
                } else {
                    phi_613_ = 0f;
                }
                let _e431 = phi_613_;
                let _e432 = (_e84 + 3u);
                phi_616_ = 0u;
                loop {
                    let _e434 = phi_616_;
                    local_25 = _e434;
                    local_27 = _e434;
                    local_28 = _e434;
                    local_29 = _e434;
                    local_30 = _e434;
                    local_39 = _e434;
                    let _e435 = (_e434 + 1u);
                    local_26 = _e435;
                    if ((_e435 * _e435) <= _e432) {
                        let _e438 = (_e434 < 9u);
                        phi_617_ = select(u32(), _e435, _e438);
                        phi_634_ = _e438;
                    } else {
                        phi_617_ = u32();
                        phi_634_ = false;
                    }
                    let _e441 = phi_617_;
                    let _e443 = phi_634_;
                    continue;
                    continuing {
                        phi_616_ = _e441;
                        break if !(_e443);
                    }
                }
                let _e446 = local_25;
                let _e448 = local_26;
                let _e449 = (_e446 * _e448);
                let _e450 = (_e432 < _e449);
                if _e450 {
                    phi_647_ = (_e449 - _e432);
                } else {
                    phi_647_ = (_e432 - _e449);
                }
                let _e454 = phi_647_;
                let _e456 = local_27;
                if (_e456 <= _e40) {
                    let _e459 = local_28;
                    phi_666_ = type_12(1u, (_e454 + 1u));
                    phi_669_ = (f32(((2u * _e459) + 1u)) / select(6.2831855f, 12.566371f, (_e454 == 0u)));
                    loop {
                        let _e469 = phi_666_;
                        let _e471 = phi_669_;
                        local_31 = _e471;
                        if (_e469.member < _e469.member_1) {
                            phi_667_ = type_12((_e469.member + 1u), _e469.member_1);
                            phi_692_ = type_12(1u, _e469.member);
                        } else {
                            phi_667_ = _e469;
                            phi_692_ = type_12(0u, type_12().member_1);
                        }
                        let _e484 = phi_667_;
                        let _e486 = phi_692_;
                        let _e490 = (bitcast<i32>(_e486.member) != 0i);
                        if _e490 {
                            let _e491 = (2u * _e486.member_1);
                            let _e493 = f32((_e491 - 1u));
                            let _e495 = local_29;
                            let _e498 = f32(((_e495 - _e454) + _e491));
                            phi_670_ = (_e471 * ((_e493 * _e493) / (_e498 * (_e498 - 1f))));
                        } else {
                            phi_670_ = f32();
                        }
                        let _e505 = phi_670_;
                        continue;
                        continuing {
                            phi_666_ = _e484;
                            phi_669_ = _e505;
                            break if !(_e490);
                        }
                    }
                    let _e508 = local_30;
                    phi_716_ = type_12(1u, ((_e508 - _e454) + 1u));
                    phi_719_ = 1f;
                    loop {
                        let _e513 = phi_716_;
                        let _e515 = phi_719_;
                        local_32 = _e515;
                        if (_e513.member < _e513.member_1) {
                            phi_717_ = type_12((_e513.member + 1u), _e513.member_1);
                            phi_742_ = type_12(1u, _e513.member);
                        } else {
                            phi_717_ = _e513;
                            phi_742_ = type_12(0u, type_12().member_1);
                        }
                        let _e528 = phi_717_;
                        let _e530 = phi_742_;
                        let _e534 = (bitcast<i32>(_e530.member) != 0i);
                        if _e534 {
                            phi_720_ = (_e515 * f32(_e530.member_1));
                        } else {
                            phi_720_ = f32();
                        }
                        let _e538 = phi_720_;
                        continue;
                        continuing {
                            phi_716_ = _e528;
                            phi_719_ = _e538;
                            break if !(_e534);
                        }
                    }
                    let _e541 = local_31;
                    let _e544 = local_32;
                    phi_754_ = (sqrt(_e541) / _e544);
                } else {
                    phi_754_ = 0f;
                }
                let _e547 = phi_754_;
                phi_760_ = type_12(0u, _e77);
                phi_763_ = array<f32, 12>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e550 = phi_760_;
                    let _e552 = phi_763_;
                    local_41 = _e552;
                    local_42 = _e552;
                    local_43 = _e552;
                    local_44 = _e552;
                    local_45 = _e552;
                    local_46 = _e552;
                    local_47 = _e552;
                    local_48 = _e552;
                    local_49 = _e552;
                    local_50 = _e552;
                    local_51 = _e552;
                    local_52 = _e552;
                    if (_e550.member < _e550.member_1) {
                        phi_761_ = type_12((_e550.member + 1u), _e550.member_1);
                        phi_786_ = type_12(1u, _e550.member);
                    } else {
                        phi_761_ = _e550;
                        phi_786_ = type_12(0u, type_12().member_1);
                    }
                    let _e565 = phi_761_;
                    let _e567 = phi_786_;
                    let _e571 = (bitcast<i32>(_e567.member) != 0i);
                    if _e571 {
                        let _e573 = ((((((_e74 / 64u) * _e77) * 192u) + (_e74 % 64u)) + (_e62 - (_e64 * 64u))) + (_e567.member_1 * 192u));
                        let _e576 = directions.member[_e573];
                        let _e577 = (_e573 + 64u);
                        let _e580 = directions.member[_e577];
                        let _e581 = (_e573 + 128u);
                        let _e584 = directions.member[_e581];
                        let _e587 = radiance.member[_e573];
                        let _e590 = radiance.member[_e577];
                        let _e593 = radiance.member[_e581];
                        let _e594 = select(1f, 0f, _e102);
                        if (_e106 == 0u) {
                            phi_825_ = _e594;
                        } else {
                            phi_825_ = select(_e576, _e580, _e102);
                        }
                        let _e598 = phi_825_;
                        let _e599 = (_e576 + _e576);
                        let _e602 = ((_e576 * _e576) + (_e580 * _e580));
                        phi_832_ = type_12(1u, _e106);
                        phi_835_ = _e598;
                        phi_837_ = _e594;
                        loop {
                            let _e605 = phi_832_;
                            let _e607 = phi_835_;
                            let _e609 = phi_837_;
                            local_53 = _e607;
                            local_54 = _e609;
                            if (_e605.member < _e605.member_1) {
                                phi_833_ = type_12((_e605.member + 1u), _e605.member_1);
                                phi_859_ = type_12(1u, _e605.member);
                            } else {
                                phi_833_ = _e605;
                                phi_859_ = type_12(0u, type_12().member_1);
                            }
                            let _e622 = phi_833_;
                            let _e624 = phi_859_;
                            let _e627 = (bitcast<i32>(_e624.member) != 0i);
                            if _e627 {
                                phi_836_ = ((_e599 * _e607) - (_e602 * _e609));
                            } else {
                                phi_836_ = f32();
                            }
                            let _e632 = phi_836_;
                            continue;
                            continuing {
                                phi_832_ = _e622;
                                phi_835_ = _e632;
                                phi_837_ = _e607;
                                break if !(_e627);
                            }
                        }
                        let _e638 = local_33;
                        phi_874_ = type_12(_e106, _e638);
                        let _e1176 = local_53;
                        phi_877_ = _e1176;
                        phi_879_ = f32(((2u * _e106) + 1u));
                        phi_881_ = 0f;
                        let _e1181 = local_54;
                        phi_883_ = _e1181;
                        loop {
                            let _e641 = phi_874_;
                            let _e643 = phi_877_;
                            let _e645 = phi_879_;
                            let _e647 = phi_881_;
                            let _e649 = phi_883_;
                            local_34 = _e643;
                            if (_e641.member < _e641.member_1) {
                                phi_875_ = type_12((_e641.member + 1u), _e641.member_1);
                                phi_905_ = type_12(1u, _e641.member);
                            } else {
                                phi_875_ = _e641;
                                phi_905_ = type_12(0u, type_12().member_1);
                            }
                            let _e662 = phi_875_;
                            let _e664 = phi_905_;
                            let _e667 = (bitcast<i32>(_e664.member) != 0i);
                            if _e667 {
                                phi_878_ = (((_e584 * _e645) * _e643) - (_e647 * _e649));
                                phi_880_ = (_e645 + 2f);
                                phi_882_ = (_e647 + _e645);
                            } else {
                                phi_878_ = f32();
                                phi_880_ = f32();
                                phi_882_ = f32();
                            }
                            let _e675 = phi_878_;
                            let _e677 = phi_880_;
                            let _e679 = phi_882_;
                            continue;
                            continuing {
                                phi_874_ = _e662;
                                phi_877_ = _e675;
                                phi_879_ = _e677;
                                phi_881_ = _e679;
                                phi_883_ = _e643;
                                break if !(_e667);
                            }
                        }
                        let _e682 = local_34;
                        let _e683 = (_e682 * _e199);
                        let _e693 = select(1f, 0f, _e218);
                        if (_e222 == 0u) {
                            phi_943_ = _e693;
                        } else {
                            phi_943_ = select(_e576, _e580, _e218);
                        }
                        let _e697 = phi_943_;
                        phi_950_ = type_12(1u, _e222);
                        phi_953_ = _e697;
                        phi_955_ = _e693;
                        loop {
                            let _e700 = phi_950_;
                            let _e702 = phi_953_;
                            let _e704 = phi_955_;
                            local_55 = _e702;
                            local_56 = _e704;
                            if (_e700.member < _e700.member_1) {
                                phi_951_ = type_12((_e700.member + 1u), _e700.member_1);
                                phi_977_ = type_12(1u, _e700.member);
                            } else {
                                phi_951_ = _e700;
                                phi_977_ = type_12(0u, type_12().member_1);
                            }
                            let _e717 = phi_951_;
                            let _e719 = phi_977_;
                            let _e722 = (bitcast<i32>(_e719.member) != 0i);
                            if _e722 {
                                phi_954_ = ((_e599 * _e702) - (_e602 * _e704));
                            } else {
                                phi_954_ = f32();
                            }
                            let _e727 = phi_954_;
                            continue;
                            continuing {
                                phi_950_ = _e717;
                                phi_953_ = _e727;
                                phi_955_ = _e702;
                                break if !(_e722);
                            }
                        }
                        let _e733 = local_35;
                        phi_992_ = type_12(_e222, _e733);
                        let _e1199 = local_55;
                        phi_995_ = _e1199;
                        phi_997_ = f32(((2u * _e222) + 1u));
                        phi_999_ = 0f;
                        let _e1204 = local_56;
                        phi_1001_ = _e1204;
                        loop {
                            let _e736 = phi_992_;
                            let _e738 = phi_995_;
                            let _e740 = phi_997_;
                            let _e742 = phi_999_;
                            let _e744 = phi_1001_;
                            local_36 = _e738;
                            if (_e736.member < _e736.member_1) {
                                phi_993_ = type_12((_e736.member + 1u), _e736.member_1);
                                phi_1023_ = type_12(1u, _e736.member);
                            } else {
                                phi_993_ = _e736;
                                phi_1023_ = type_12(0u, type_12().member_1);
                            }
                            let _e757 = phi_993_;
                            let _e759 = phi_1023_;
                            let _e762 = (bitcast<i32>(_e759.member) != 0i);
                            if _e762 {
                                phi_996_ = (((_e584 * _e740) * _e738) - (_e742 * _e744));
                                phi_998_ = (_e740 + 2f);
                                phi_1000_ = (_e742 + _e740);
                            } else {
                                phi_996_ = f32();
                                phi_998_ = f32();
                                phi_1000_ = f32();
                            }
                            let _e770 = phi_996_;
                            let _e772 = phi_998_;
                            let _e774 = phi_1000_;
                            continue;
                            continuing {
                                phi_992_ = _e757;
                                phi_995_ = _e770;
                                phi_997_ = _e772;
                                phi_999_ = _e774;
                                phi_1001_ = _e738;
                                break if !(_e762);
                            }
                        }
                        let _e777 = local_36;
                        let _e778 = (_e777 * _e315);
                        let _e788 = select(1f, 0f, _e334);
                        if (_e338 == 0u) {
                            phi_1061_ = _e788;
                        } else {
                            phi_1061_ = select(_e576, _e580, _e334);
                        }
                        let _e792 = phi_1061_;
                        phi_1068_ = type_12(1u, _e338);
                        phi_1071_ = _e792;
                        phi_1073_ = _e788;
                        loop {
                            let _e795 = phi_1068_;
                            let _e797 = phi_1071_;
                            let _e799 = phi_1073_;
                            local_57 = _e797;
                            local_58 = _e799;
                            if (_e795.member < _e795.member_1) {
                                phi_1069_ = type_12((_e795.member + 1u), _e795.member_1);
                                phi_1095_ = type_12(1u, _e795.member);
                            } else {
                                phi_1069_ = _e795;
                                phi_1095_ = type_12(0u, type_12().member_1);
                            }
                            let _e812 = phi_1069_;
                            let _e814 = phi_1095_;
                            let _e817 = (bitcast<i32>(_e814.member) != 0i);
                            if _e817 {
                                phi_1072_ = ((_e599 * _e797) - (_e602 * _e799));
                            } else {
                                phi_1072_ = f32();
                            }
                            let _e822 = phi_1072_;
                            continue;
                            continuing {
                                phi_1068_ = _e812;
                                phi_1071_ = _e822;
                                phi_1073_ = _e797;
                                break if !(_e817);
                            }
                        }
                        let _e828 = local_37;
                        phi_1110_ = type_12(_e338, _e828);
                        let _e1222 = local_57;
                        phi_1113_ = _e1222;
                        phi_1115_ = f32(((2u * _e338) + 1u));
                        phi_1117_ = 0f;
                        let _e1227 = local_58;
                        phi_1119_ = _e1227;
                        loop {
                            let _e831 = phi_1110_;
                            let _e833 = phi_1113_;
                            let _e835 = phi_1115_;
                            let _e837 = phi_1117_;
                            let _e839 = phi_1119_;
                            local_38 = _e833;
                            if (_e831.member < _e831.member_1) {
                                phi_1111_ = type_12((_e831.member + 1u), _e831.member_1);
                                phi_1141_ = type_12(1u, _e831.member);
                            } else {
                                phi_1111_ = _e831;
                                phi_1141_ = type_12(0u, type_12().member_1);
                            }
                            let _e852 = phi_1111_;
                            let _e854 = phi_1141_;
                            let _e857 = (bitcast<i32>(_e854.member) != 0i);
                            if _e857 {
                                phi_1114_ = (((_e584 * _e835) * _e833) - (_e837 * _e839));
                                phi_1116_ = (_e835 + 2f);
                                phi_1118_ = (_e837 + _e835);
                            } else {
                                phi_1114_ = f32();
                                phi_1116_ = f32();
                                phi_1118_ = f32();
                            }
                            let _e865 = phi_1114_;
                            let _e867 = phi_1116_;
                            let _e869 = phi_1118_;
                            continue;
                            continuing {
                                phi_1110_ = _e852;
                                phi_1113_ = _e865;
                                phi_1115_ = _e867;
                                phi_1117_ = _e869;
                                phi_1119_ = _e833;
                                break if !(_e857);
                            }
                        }
                        let _e872 = local_38;
                        let _e873 = (_e872 * _e431);
                        let _e883 = select(1f, 0f, _e450);
                        if (_e454 == 0u) {
                            phi_1179_ = _e883;
                        } else {
                            phi_1179_ = select(_e576, _e580, _e450);
                        }
                        let _e887 = phi_1179_;
                        phi_1186_ = type_12(1u, _e454);
                        phi_1189_ = _e887;
                        phi_1191_ = _e883;
                        loop {
                            let _e890 = phi_1186_;
                            let _e892 = phi_1189_;
                            let _e894 = phi_1191_;
                            local_59 = _e892;
                            local_60 = _e894;
                            if (_e890.member < _e890.member_1) {
                                phi_1187_ = type_12((_e890.member + 1u), _e890.member_1);
                                phi_1213_ = type_12(1u, _e890.member);
                            } else {
                                phi_1187_ = _e890;
                                phi_1213_ = type_12(0u, type_12().member_1);
                            }
                            let _e907 = phi_1187_;
                            let _e909 = phi_1213_;
                            let _e912 = (bitcast<i32>(_e909.member) != 0i);
                            if _e912 {
                                phi_1190_ = ((_e599 * _e892) - (_e602 * _e894));
                            } else {
                                phi_1190_ = f32();
                            }
                            let _e917 = phi_1190_;
                            continue;
                            continuing {
                                phi_1186_ = _e907;
                                phi_1189_ = _e917;
                                phi_1191_ = _e892;
                                break if !(_e912);
                            }
                        }
                        let _e923 = local_39;
                        phi_1228_ = type_12(_e454, _e923);
                        let _e1245 = local_59;
                        phi_1231_ = _e1245;
                        phi_1233_ = f32(((2u * _e454) + 1u));
                        phi_1235_ = 0f;
                        let _e1250 = local_60;
                        phi_1237_ = _e1250;
                        loop {
                            let _e926 = phi_1228_;
                            let _e928 = phi_1231_;
                            let _e930 = phi_1233_;
                            let _e932 = phi_1235_;
                            let _e934 = phi_1237_;
                            local_40 = _e928;
                            if (_e926.member < _e926.member_1) {
                                phi_1229_ = type_12((_e926.member + 1u), _e926.member_1);
                                phi_1259_ = type_12(1u, _e926.member);
                            } else {
                                phi_1229_ = _e926;
                                phi_1259_ = type_12(0u, type_12().member_1);
                            }
                            let _e947 = phi_1229_;
                            let _e949 = phi_1259_;
                            let _e952 = (bitcast<i32>(_e949.member) != 0i);
                            if _e952 {
                                phi_1232_ = (((_e584 * _e930) * _e928) - (_e932 * _e934));
                                phi_1234_ = (_e930 + 2f);
                                phi_1236_ = (_e932 + _e930);
                            } else {
                                phi_1232_ = f32();
                                phi_1234_ = f32();
                                phi_1236_ = f32();
                            }
                            let _e960 = phi_1232_;
                            let _e962 = phi_1234_;
                            let _e964 = phi_1236_;
                            continue;
                            continuing {
                                phi_1228_ = _e947;
                                phi_1231_ = _e960;
                                phi_1233_ = _e962;
                                phi_1235_ = _e964;
                                phi_1237_ = _e928;
                                break if !(_e952);
                            }
                        }
                        let _e967 = local_40;
                        let _e968 = (_e967 * _e547);
                        phi_764_ = array<f32, 12>((_e552[0] + (_e587 * _e683)), (_e552[1] + (_e587 * _e778)), (_e552[2] + (_e587 * _e873)), (_e552[3] + (_e587 * _e968)), (_e552[4] + (_e590 * _e683)), (_e552[5] + (_e590 * _e778)), (_e552[6] + (_e590 * _e873)), (_e552[7] + (_e590 * _e968)), (_e552[8] + (_e593 * _e683)), (_e552[9] + (_e593 * _e778)), (_e552[10] + (_e593 * _e873)), (_e552[11] + (_e593 * _e968)));
                    } else {
                        phi_764_ = array<f32, 12>();
                    }
                    let _e980 = phi_764_;
                    continue;
                    continuing {
                        phi_760_ = _e565;
                        phi_763_ = _e980;
                        break if !(_e571);
                    }
                }
                let _e984 = params.member.member_3;
                let _e986 = local_41;
                let _e990 = local_42;
                let _e994 = local_43;
                let _e998 = local_44;
                let _e1002 = local_45;
                let _e1006 = local_46;
                let _e1010 = local_47;
                let _e1014 = local_48;
                let _e1018 = local_49;
                let _e1022 = local_50;
                let _e1026 = local_51;
                let _e1030 = local_52;
                local = array<f32, 12>((_e986[0] * _e984), (_e990[1] * _e984), (_e994[2] * _e984), (_e998[3] * _e984), (_e1002[4] * _e984), (_e1006[5] * _e984), (_e1010[6] * _e984), (_e1014[7] * _e984), (_e1018[8] * _e984), (_e1022[9] * _e984), (_e1026[10] * _e984), (_e1030[11] * _e984));
                phi_1338_ = type_12(0u, 12u);
                loop {
                    let _e1035 = phi_1338_;
                    if (_e1035.member < _e1035.member_1) {
                        phi_1339_ = type_12((_e1035.member + 1u), _e1035.member_1);
                        phi_1362_ = type_12(1u, _e1035.member);
                    } else {
                        phi_1339_ = _e1035;
                        phi_1362_ = type_12(0u, type_12().member_1);
                    }
                    let _e1048 = phi_1339_;
                    let _e1050 = phi_1362_;
                    let _e1054 = (bitcast<i32>(_e1050.member) != 0i);
                    if _e1054 {
                        if (_e1050.member_1 < 12u) {
                        } else {
                            phi_1391_ = true;
                            break;
                        }
                        let _e1057 = local[_e1050.member_1];
                        let _e1059 = ((_e1050.member_1 * _e58) + _e62);
                        if (_e1059 < arrayLength((&coefs.member))) {
                        } else {
                            phi_1391_ = true;
                            break;
                        }
                        coefs.member[_e1059] = _e1057;
                    }
                    continue;
                    continuing {
                        phi_1338_ = _e1048;
                        phi_1391_ = false;
                        break if !(_e1054);
                    }
                }
                let _e1065 = phi_1391_;
                if _e1065 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_project_rays(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
