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
    var phi_88_: u32;
    var phi_107_: u32;
    var phi_171_: u32;
    var phi_195_: u32;
    var phi_196_: u32;
    var phi_213_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_226_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_245_: type_12;
    var phi_248_: f32;
    var phi_246_: type_12;
    var phi_271_: type_12;
    var local_5: u32;
    var phi_249_: f32;
    var local_6: u32;
    var phi_295_: type_12;
    var phi_298_: f32;
    var phi_296_: type_12;
    var phi_321_: type_12;
    var phi_299_: f32;
    var local_7: f32;
    var local_8: f32;
    var phi_333_: f32;
    var phi_336_: u32;
    var phi_337_: u32;
    var phi_354_: bool;
    var local_9: u32;
    var local_10: u32;
    var phi_367_: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_386_: type_12;
    var phi_389_: f32;
    var phi_387_: type_12;
    var phi_412_: type_12;
    var local_13: u32;
    var phi_390_: f32;
    var local_14: u32;
    var phi_436_: type_12;
    var phi_439_: f32;
    var phi_437_: type_12;
    var phi_462_: type_12;
    var phi_440_: f32;
    var local_15: f32;
    var local_16: f32;
    var phi_474_: f32;
    var phi_477_: u32;
    var phi_478_: u32;
    var phi_495_: bool;
    var local_17: u32;
    var local_18: u32;
    var phi_508_: u32;
    var local_19: u32;
    var local_20: u32;
    var phi_527_: type_12;
    var phi_530_: f32;
    var phi_528_: type_12;
    var phi_553_: type_12;
    var local_21: u32;
    var phi_531_: f32;
    var local_22: u32;
    var phi_577_: type_12;
    var phi_580_: f32;
    var phi_578_: type_12;
    var phi_603_: type_12;
    var phi_581_: f32;
    var local_23: f32;
    var local_24: f32;
    var phi_615_: f32;
    var phi_618_: u32;
    var phi_619_: u32;
    var phi_636_: bool;
    var local_25: u32;
    var local_26: u32;
    var phi_649_: u32;
    var local_27: u32;
    var local_28: u32;
    var phi_668_: type_12;
    var phi_671_: f32;
    var phi_669_: type_12;
    var phi_694_: type_12;
    var local_29: u32;
    var phi_672_: f32;
    var local_30: u32;
    var phi_718_: type_12;
    var phi_721_: f32;
    var phi_719_: type_12;
    var phi_744_: type_12;
    var phi_722_: f32;
    var local_31: f32;
    var local_32: f32;
    var phi_756_: f32;
    var phi_762_: type_12;
    var phi_765_: array<f32, 12>;
    var phi_763_: type_12;
    var phi_788_: type_12;
    var phi_857_: f32;
    var phi_864_: type_12;
    var phi_867_: f32;
    var phi_869_: f32;
    var phi_865_: type_12;
    var phi_891_: type_12;
    var phi_868_: f32;
    var local_33: u32;
    var phi_906_: type_12;
    var phi_909_: f32;
    var phi_911_: f32;
    var phi_913_: f32;
    var phi_915_: f32;
    var phi_907_: type_12;
    var phi_937_: type_12;
    var phi_910_: f32;
    var phi_912_: f32;
    var phi_914_: f32;
    var local_34: f32;
    var phi_975_: f32;
    var phi_982_: type_12;
    var phi_985_: f32;
    var phi_987_: f32;
    var phi_983_: type_12;
    var phi_1009_: type_12;
    var phi_986_: f32;
    var local_35: u32;
    var phi_1024_: type_12;
    var phi_1027_: f32;
    var phi_1029_: f32;
    var phi_1031_: f32;
    var phi_1033_: f32;
    var phi_1025_: type_12;
    var phi_1055_: type_12;
    var phi_1028_: f32;
    var phi_1030_: f32;
    var phi_1032_: f32;
    var local_36: f32;
    var phi_1093_: f32;
    var phi_1100_: type_12;
    var phi_1103_: f32;
    var phi_1105_: f32;
    var phi_1101_: type_12;
    var phi_1127_: type_12;
    var phi_1104_: f32;
    var local_37: u32;
    var phi_1142_: type_12;
    var phi_1145_: f32;
    var phi_1147_: f32;
    var phi_1149_: f32;
    var phi_1151_: f32;
    var phi_1143_: type_12;
    var phi_1173_: type_12;
    var phi_1146_: f32;
    var phi_1148_: f32;
    var phi_1150_: f32;
    var local_38: f32;
    var phi_1211_: f32;
    var phi_1218_: type_12;
    var phi_1221_: f32;
    var phi_1223_: f32;
    var phi_1219_: type_12;
    var phi_1245_: type_12;
    var phi_1222_: f32;
    var local_39: u32;
    var phi_1260_: type_12;
    var phi_1263_: f32;
    var phi_1265_: f32;
    var phi_1267_: f32;
    var phi_1269_: f32;
    var phi_1261_: type_12;
    var phi_1291_: type_12;
    var phi_1264_: f32;
    var phi_1266_: f32;
    var phi_1268_: f32;
    var local_40: f32;
    var phi_766_: array<f32, 12>;
    var phi_1425_: bool;
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
    var phi_1370_: type_12;
    var phi_1371_: type_12;
    var phi_1394_: type_12;
    var phi_1518_: bool;
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
            let _e34 = arrayLength((&directions.member));
            let _e36 = arrayLength((&radiance.member));
            let _e41 = params.member.member;
            let _e44 = params.member.member_2;
            let _e47 = (_e41 / 64u);
            if ((_e41 % 64u) > 0u) {
                phi_88_ = (_e47 + 1u);
            } else {
                phi_88_ = _e47;
            }
            let _e52 = phi_88_;
            let _e53 = (select(_e44, 9u, (_e44 > 9u)) + 1u);
            let _e54 = (_e53 * _e53);
            let _e55 = (_e54 / 4u);
            let _e57 = ((_e54 % 4u) > 0u);
            if _e57 {
                phi_107_ = (_e55 + 1u);
            } else {
                phi_107_ = _e55;
            }
            let _e60 = phi_107_;
            let _e62 = ((_e52 * _e60) * 64u);
            let _e66 = (_e32.x + (_e32.y * 2097152u));
            if (_e66 < _e62) {
                let _e68 = (_e66 / 64u);
                if _e57 {
                    phi_171_ = (_e55 + 1u);
                } else {
                    phi_171_ = _e55;
                }
                let _e73 = phi_171_;
                if (_e73 == 0u) {
                    break;
                }
                let _e75 = (_e68 / _e73);
                let _e78 = (_e75 * 64u);
                let _e81 = params.member.member_1;
                let _e88 = ((_e68 - (_e75 * _e73)) * 4u);
                phi_195_ = 0u;
                loop {
                    let _e90 = phi_195_;
                    local_1 = _e90;
                    local_3 = _e90;
                    local_4 = _e90;
                    local_5 = _e90;
                    local_6 = _e90;
                    local_33 = _e90;
                    let _e91 = (_e90 + 1u);
                    local_2 = _e91;
                    if ((_e91 * _e91) <= _e88) {
                        let _e94 = (_e90 < 9u);
                        phi_196_ = select(u32(), _e91, _e94);
                        phi_213_ = _e94;
                    } else {
                        phi_196_ = u32();
                        phi_213_ = false;
                    }
                    let _e97 = phi_196_;
                    let _e99 = phi_213_;
                    continue;
                    continuing {
                        phi_195_ = _e97;
                        break if !(_e99);
                    }
                }
                let _e102 = local_1;
                let _e104 = local_2;
                let _e105 = (_e102 * _e104);
                let _e106 = (_e88 < _e105);
                if _e106 {
                    phi_226_ = (_e105 - _e88);
                } else {
                    phi_226_ = (_e88 - _e105);
                }
                let _e110 = phi_226_;
                let _e112 = local_3;
                if (_e112 <= _e44) {
                    let _e115 = local_4;
                    phi_245_ = type_12(1u, (_e110 + 1u));
                    phi_248_ = (f32(((2u * _e115) + 1u)) / select(6.2831855f, 12.566371f, (_e110 == 0u)));
                    loop {
                        let _e125 = phi_245_;
                        let _e127 = phi_248_;
                        local_7 = _e127;
                        if (_e125.member < _e125.member_1) {
                            phi_246_ = type_12((_e125.member + 1u), _e125.member_1);
                            phi_271_ = type_12(1u, _e125.member);
                        } else {
                            phi_246_ = _e125;
                            phi_271_ = type_12(0u, type_12().member_1);
                        }
                        let _e140 = phi_246_;
                        let _e142 = phi_271_;
                        let _e146 = (bitcast<i32>(_e142.member) != 0i);
                        if _e146 {
                            let _e147 = (2u * _e142.member_1);
                            let _e149 = f32((_e147 - 1u));
                            let _e151 = local_5;
                            let _e154 = f32(((_e151 - _e110) + _e147));
                            phi_249_ = (_e127 * ((_e149 * _e149) / (_e154 * (_e154 - 1f))));
                        } else {
                            phi_249_ = f32();
                        }
                        let _e161 = phi_249_;
                        continue;
                        continuing {
                            phi_245_ = _e140;
                            phi_248_ = _e161;
                            break if !(_e146);
                        }
                    }
                    let _e164 = local_6;
                    phi_295_ = type_12(1u, ((_e164 - _e110) + 1u));
                    phi_298_ = 1f;
                    loop {
                        let _e169 = phi_295_;
                        let _e171 = phi_298_;
                        local_8 = _e171;
                        if (_e169.member < _e169.member_1) {
                            phi_296_ = type_12((_e169.member + 1u), _e169.member_1);
                            phi_321_ = type_12(1u, _e169.member);
                        } else {
                            phi_296_ = _e169;
                            phi_321_ = type_12(0u, type_12().member_1);
                        }
                        let _e184 = phi_296_;
                        let _e186 = phi_321_;
                        let _e190 = (bitcast<i32>(_e186.member) != 0i);
                        if _e190 {
                            phi_299_ = (_e171 * f32(_e186.member_1));
                        } else {
                            phi_299_ = f32();
                        }
                        let _e194 = phi_299_;
                        continue;
                        continuing {
                            phi_295_ = _e184;
                            phi_298_ = _e194;
                            break if !(_e190);
                        }
                    }
                    let _e197 = local_7;
                    let _e200 = local_8;
                    phi_333_ = (sqrt(_e197) / _e200);
                } else {
                    phi_333_ = 0f;
                }
                let _e203 = phi_333_;
                let _e204 = (_e88 + 1u);
                phi_336_ = 0u;
                loop {
                    let _e206 = phi_336_;
                    local_9 = _e206;
                    local_11 = _e206;
                    local_12 = _e206;
                    local_13 = _e206;
                    local_14 = _e206;
                    local_35 = _e206;
                    let _e207 = (_e206 + 1u);
                    local_10 = _e207;
                    if ((_e207 * _e207) <= _e204) {
                        let _e210 = (_e206 < 9u);
                        phi_337_ = select(u32(), _e207, _e210);
                        phi_354_ = _e210;
                    } else {
                        phi_337_ = u32();
                        phi_354_ = false;
                    }
                    let _e213 = phi_337_;
                    let _e215 = phi_354_;
                    continue;
                    continuing {
                        phi_336_ = _e213;
                        break if !(_e215);
                    }
                }
                let _e218 = local_9;
                let _e220 = local_10;
                let _e221 = (_e218 * _e220);
                let _e222 = (_e204 < _e221);
                if _e222 {
                    phi_367_ = (_e221 - _e204);
                } else {
                    phi_367_ = (_e204 - _e221);
                }
                let _e226 = phi_367_;
                let _e228 = local_11;
                if (_e228 <= _e44) {
                    let _e231 = local_12;
                    phi_386_ = type_12(1u, (_e226 + 1u));
                    phi_389_ = (f32(((2u * _e231) + 1u)) / select(6.2831855f, 12.566371f, (_e226 == 0u)));
                    loop {
                        let _e241 = phi_386_;
                        let _e243 = phi_389_;
                        local_15 = _e243;
                        if (_e241.member < _e241.member_1) {
                            phi_387_ = type_12((_e241.member + 1u), _e241.member_1);
                            phi_412_ = type_12(1u, _e241.member);
                        } else {
                            phi_387_ = _e241;
                            phi_412_ = type_12(0u, type_12().member_1);
                        }
                        let _e256 = phi_387_;
                        let _e258 = phi_412_;
                        let _e262 = (bitcast<i32>(_e258.member) != 0i);
                        if _e262 {
                            let _e263 = (2u * _e258.member_1);
                            let _e265 = f32((_e263 - 1u));
                            let _e267 = local_13;
                            let _e270 = f32(((_e267 - _e226) + _e263));
                            phi_390_ = (_e243 * ((_e265 * _e265) / (_e270 * (_e270 - 1f))));
                        } else {
                            phi_390_ = f32();
                        }
                        let _e277 = phi_390_;
                        continue;
                        continuing {
                            phi_386_ = _e256;
                            phi_389_ = _e277;
                            break if !(_e262);
                        }
                    }
                    let _e280 = local_14;
                    phi_436_ = type_12(1u, ((_e280 - _e226) + 1u));
                    phi_439_ = 1f;
                    loop {
                        let _e285 = phi_436_;
                        let _e287 = phi_439_;
                        local_16 = _e287;
                        if (_e285.member < _e285.member_1) {
                            phi_437_ = type_12((_e285.member + 1u), _e285.member_1);
                            phi_462_ = type_12(1u, _e285.member);
                        } else {
                            phi_437_ = _e285;
                            phi_462_ = type_12(0u, type_12().member_1);
                        }
                        let _e300 = phi_437_;
                        let _e302 = phi_462_;
                        let _e306 = (bitcast<i32>(_e302.member) != 0i);
                        if _e306 {
                            phi_440_ = (_e287 * f32(_e302.member_1));
                        } else {
                            phi_440_ = f32();
                        }
                        let _e310 = phi_440_;
                        continue;
                        continuing {
                            phi_436_ = _e300;
                            phi_439_ = _e310;
                            break if !(_e306);
                        }
                    }
                    let _e313 = local_15;
                    let _e316 = local_16;
                    phi_474_ = (sqrt(_e313) / _e316);
                } else {
                    phi_474_ = 0f;
                }
                let _e319 = phi_474_;
                let _e320 = (_e88 + 2u);
                phi_477_ = 0u;
                loop {
                    let _e322 = phi_477_;
                    local_17 = _e322;
                    local_19 = _e322;
                    local_20 = _e322;
                    local_21 = _e322;
                    local_22 = _e322;
                    local_37 = _e322;
                    let _e323 = (_e322 + 1u);
                    local_18 = _e323;
                    if ((_e323 * _e323) <= _e320) {
                        let _e326 = (_e322 < 9u);
                        phi_478_ = select(u32(), _e323, _e326);
                        phi_495_ = _e326;
                    } else {
                        phi_478_ = u32();
                        phi_495_ = false;
                    }
                    let _e329 = phi_478_;
                    let _e331 = phi_495_;
                    continue;
                    continuing {
                        phi_477_ = _e329;
                        break if !(_e331);
                    }
                }
                let _e334 = local_17;
                let _e336 = local_18;
                let _e337 = (_e334 * _e336);
                let _e338 = (_e320 < _e337);
                if _e338 {
                    phi_508_ = (_e337 - _e320);
                } else {
                    phi_508_ = (_e320 - _e337);
                }
                let _e342 = phi_508_;
                let _e344 = local_19;
                if (_e344 <= _e44) {
                    let _e347 = local_20;
                    phi_527_ = type_12(1u, (_e342 + 1u));
                    phi_530_ = (f32(((2u * _e347) + 1u)) / select(6.2831855f, 12.566371f, (_e342 == 0u)));
                    loop {
                        let _e357 = phi_527_;
                        let _e359 = phi_530_;
                        local_23 = _e359;
                        if (_e357.member < _e357.member_1) {
                            phi_528_ = type_12((_e357.member + 1u), _e357.member_1);
                            phi_553_ = type_12(1u, _e357.member);
                        } else {
                            phi_528_ = _e357;
                            phi_553_ = type_12(0u, type_12().member_1);
                        }
                        let _e372 = phi_528_;
                        let _e374 = phi_553_;
                        let _e378 = (bitcast<i32>(_e374.member) != 0i);
                        if _e378 {
                            let _e379 = (2u * _e374.member_1);
                            let _e381 = f32((_e379 - 1u));
                            let _e383 = local_21;
                            let _e386 = f32(((_e383 - _e342) + _e379));
                            phi_531_ = (_e359 * ((_e381 * _e381) / (_e386 * (_e386 - 1f))));
                        } else {
                            phi_531_ = f32();
                        }
                        let _e393 = phi_531_;
                        continue;
                        continuing {
                            phi_527_ = _e372;
                            phi_530_ = _e393;
                            break if !(_e378);
                        }
                    }
                    let _e396 = local_22;
                    phi_577_ = type_12(1u, ((_e396 - _e342) + 1u));
                    phi_580_ = 1f;
                    loop {
                        let _e401 = phi_577_;
                        let _e403 = phi_580_;
                        local_24 = _e403;
                        if (_e401.member < _e401.member_1) {
                            phi_578_ = type_12((_e401.member + 1u), _e401.member_1);
                            phi_603_ = type_12(1u, _e401.member);
                        } else {
                            phi_578_ = _e401;
                            phi_603_ = type_12(0u, type_12().member_1);
                        }
                        let _e416 = phi_578_;
                        let _e418 = phi_603_;
                        let _e422 = (bitcast<i32>(_e418.member) != 0i);
                        if _e422 {
                            phi_581_ = (_e403 * f32(_e418.member_1));
                        } else {
                            phi_581_ = f32();
                        }
                        let _e426 = phi_581_;
                        continue;
                        continuing {
                            phi_577_ = _e416;
                            phi_580_ = _e426;
                            break if !(_e422);
                        }
                    }
                    let _e429 = local_23;
                    let _e432 = local_24;
                    phi_615_ = (sqrt(_e429) / _e432);
                } else {
                    phi_615_ = 0f;
                }
                let _e435 = phi_615_;
                let _e436 = (_e88 + 3u);
                phi_618_ = 0u;
                loop {
                    let _e438 = phi_618_;
                    local_25 = _e438;
                    local_27 = _e438;
                    local_28 = _e438;
                    local_29 = _e438;
                    local_30 = _e438;
                    local_39 = _e438;
                    let _e439 = (_e438 + 1u);
                    local_26 = _e439;
                    if ((_e439 * _e439) <= _e436) {
                        let _e442 = (_e438 < 9u);
                        phi_619_ = select(u32(), _e439, _e442);
                        phi_636_ = _e442;
                    } else {
                        phi_619_ = u32();
                        phi_636_ = false;
                    }
                    let _e445 = phi_619_;
                    let _e447 = phi_636_;
                    continue;
                    continuing {
                        phi_618_ = _e445;
                        break if !(_e447);
                    }
                }
                let _e450 = local_25;
                let _e452 = local_26;
                let _e453 = (_e450 * _e452);
                let _e454 = (_e436 < _e453);
                if _e454 {
                    phi_649_ = (_e453 - _e436);
                } else {
                    phi_649_ = (_e436 - _e453);
                }
                let _e458 = phi_649_;
                let _e460 = local_27;
                if (_e460 <= _e44) {
                    let _e463 = local_28;
                    phi_668_ = type_12(1u, (_e458 + 1u));
                    phi_671_ = (f32(((2u * _e463) + 1u)) / select(6.2831855f, 12.566371f, (_e458 == 0u)));
                    loop {
                        let _e473 = phi_668_;
                        let _e475 = phi_671_;
                        local_31 = _e475;
                        if (_e473.member < _e473.member_1) {
                            phi_669_ = type_12((_e473.member + 1u), _e473.member_1);
                            phi_694_ = type_12(1u, _e473.member);
                        } else {
                            phi_669_ = _e473;
                            phi_694_ = type_12(0u, type_12().member_1);
                        }
                        let _e488 = phi_669_;
                        let _e490 = phi_694_;
                        let _e494 = (bitcast<i32>(_e490.member) != 0i);
                        if _e494 {
                            let _e495 = (2u * _e490.member_1);
                            let _e497 = f32((_e495 - 1u));
                            let _e499 = local_29;
                            let _e502 = f32(((_e499 - _e458) + _e495));
                            phi_672_ = (_e475 * ((_e497 * _e497) / (_e502 * (_e502 - 1f))));
                        } else {
                            phi_672_ = f32();
                        }
                        let _e509 = phi_672_;
                        continue;
                        continuing {
                            phi_668_ = _e488;
                            phi_671_ = _e509;
                            break if !(_e494);
                        }
                    }
                    let _e512 = local_30;
                    phi_718_ = type_12(1u, ((_e512 - _e458) + 1u));
                    phi_721_ = 1f;
                    loop {
                        let _e517 = phi_718_;
                        let _e519 = phi_721_;
                        local_32 = _e519;
                        if (_e517.member < _e517.member_1) {
                            phi_719_ = type_12((_e517.member + 1u), _e517.member_1);
                            phi_744_ = type_12(1u, _e517.member);
                        } else {
                            phi_719_ = _e517;
                            phi_744_ = type_12(0u, type_12().member_1);
                        }
                        let _e532 = phi_719_;
                        let _e534 = phi_744_;
                        let _e538 = (bitcast<i32>(_e534.member) != 0i);
                        if _e538 {
                            phi_722_ = (_e519 * f32(_e534.member_1));
                        } else {
                            phi_722_ = f32();
                        }
                        let _e542 = phi_722_;
                        continue;
                        continuing {
                            phi_718_ = _e532;
                            phi_721_ = _e542;
                            break if !(_e538);
                        }
                    }
                    let _e545 = local_31;
                    let _e548 = local_32;
                    phi_756_ = (sqrt(_e545) / _e548);
                } else {
                    phi_756_ = 0f;
                }
                let _e551 = phi_756_;
                phi_762_ = type_12(0u, _e81);
                phi_765_ = array<f32, 12>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e554 = phi_762_;
                    let _e556 = phi_765_;
                    local_41 = _e556;
                    local_42 = _e556;
                    local_43 = _e556;
                    local_44 = _e556;
                    local_45 = _e556;
                    local_46 = _e556;
                    local_47 = _e556;
                    local_48 = _e556;
                    local_49 = _e556;
                    local_50 = _e556;
                    local_51 = _e556;
                    local_52 = _e556;
                    if (_e554.member < _e554.member_1) {
                        phi_763_ = type_12((_e554.member + 1u), _e554.member_1);
                        phi_788_ = type_12(1u, _e554.member);
                    } else {
                        phi_763_ = _e554;
                        phi_788_ = type_12(0u, type_12().member_1);
                    }
                    let _e569 = phi_763_;
                    let _e571 = phi_788_;
                    let _e575 = (bitcast<i32>(_e571.member) != 0i);
                    if _e575 {
                        let _e577 = ((((((_e78 / 64u) * _e81) * 192u) + (_e78 % 64u)) + (_e66 - (_e68 * 64u))) + (_e571.member_1 * 192u));
                        if (_e577 < _e34) {
                        } else {
                            phi_1425_ = true;
                            break;
                        }
                        let _e581 = directions.member[_e577];
                        let _e582 = (_e577 + 64u);
                        if (_e582 < _e34) {
                        } else {
                            phi_1425_ = true;
                            break;
                        }
                        let _e586 = directions.member[_e582];
                        let _e587 = (_e577 + 128u);
                        if (_e587 < _e34) {
                        } else {
                            phi_1425_ = true;
                            break;
                        }
                        let _e591 = directions.member[_e587];
                        if (_e577 < _e36) {
                        } else {
                            phi_1425_ = true;
                            break;
                        }
                        let _e595 = radiance.member[_e577];
                        if (_e582 < _e36) {
                        } else {
                            phi_1425_ = true;
                            break;
                        }
                        let _e599 = radiance.member[_e582];
                        if (_e587 < _e36) {
                        } else {
                            phi_1425_ = true;
                            break;
                        }
                        let _e603 = radiance.member[_e587];
                        let _e604 = select(1f, 0f, _e106);
                        if (_e110 == 0u) {
                            phi_857_ = _e604;
                        } else {
                            phi_857_ = select(_e581, _e586, _e106);
                        }
                        let _e608 = phi_857_;
                        let _e609 = (_e581 + _e581);
                        let _e612 = ((_e581 * _e581) + (_e586 * _e586));
                        phi_864_ = type_12(1u, _e110);
                        phi_867_ = _e608;
                        phi_869_ = _e604;
                        loop {
                            let _e615 = phi_864_;
                            let _e617 = phi_867_;
                            let _e619 = phi_869_;
                            local_53 = _e617;
                            local_54 = _e619;
                            if (_e615.member < _e615.member_1) {
                                phi_865_ = type_12((_e615.member + 1u), _e615.member_1);
                                phi_891_ = type_12(1u, _e615.member);
                            } else {
                                phi_865_ = _e615;
                                phi_891_ = type_12(0u, type_12().member_1);
                            }
                            let _e632 = phi_865_;
                            let _e634 = phi_891_;
                            let _e637 = (bitcast<i32>(_e634.member) != 0i);
                            if _e637 {
                                phi_868_ = ((_e609 * _e617) - (_e612 * _e619));
                            } else {
                                phi_868_ = f32();
                            }
                            let _e642 = phi_868_;
                            continue;
                            continuing {
                                phi_864_ = _e632;
                                phi_867_ = _e642;
                                phi_869_ = _e617;
                                break if !(_e637);
                            }
                        }
                        let _e648 = local_33;
                        phi_906_ = type_12(_e110, _e648);
                        let _e1188 = local_53;
                        phi_909_ = _e1188;
                        phi_911_ = f32(((2u * _e110) + 1u));
                        phi_913_ = 0f;
                        let _e1193 = local_54;
                        phi_915_ = _e1193;
                        loop {
                            let _e651 = phi_906_;
                            let _e653 = phi_909_;
                            let _e655 = phi_911_;
                            let _e657 = phi_913_;
                            let _e659 = phi_915_;
                            local_34 = _e653;
                            if (_e651.member < _e651.member_1) {
                                phi_907_ = type_12((_e651.member + 1u), _e651.member_1);
                                phi_937_ = type_12(1u, _e651.member);
                            } else {
                                phi_907_ = _e651;
                                phi_937_ = type_12(0u, type_12().member_1);
                            }
                            let _e672 = phi_907_;
                            let _e674 = phi_937_;
                            let _e677 = (bitcast<i32>(_e674.member) != 0i);
                            if _e677 {
                                phi_910_ = (((_e591 * _e655) * _e653) - (_e657 * _e659));
                                phi_912_ = (_e655 + 2f);
                                phi_914_ = (_e657 + _e655);
                            } else {
                                phi_910_ = f32();
                                phi_912_ = f32();
                                phi_914_ = f32();
                            }
                            let _e685 = phi_910_;
                            let _e687 = phi_912_;
                            let _e689 = phi_914_;
                            continue;
                            continuing {
                                phi_906_ = _e672;
                                phi_909_ = _e685;
                                phi_911_ = _e687;
                                phi_913_ = _e689;
                                phi_915_ = _e653;
                                break if !(_e677);
                            }
                        }
                        let _e692 = local_34;
                        let _e693 = (_e692 * _e203);
                        let _e703 = select(1f, 0f, _e222);
                        if (_e226 == 0u) {
                            phi_975_ = _e703;
                        } else {
                            phi_975_ = select(_e581, _e586, _e222);
                        }
                        let _e707 = phi_975_;
                        phi_982_ = type_12(1u, _e226);
                        phi_985_ = _e707;
                        phi_987_ = _e703;
                        loop {
                            let _e710 = phi_982_;
                            let _e712 = phi_985_;
                            let _e714 = phi_987_;
                            local_55 = _e712;
                            local_56 = _e714;
                            if (_e710.member < _e710.member_1) {
                                phi_983_ = type_12((_e710.member + 1u), _e710.member_1);
                                phi_1009_ = type_12(1u, _e710.member);
                            } else {
                                phi_983_ = _e710;
                                phi_1009_ = type_12(0u, type_12().member_1);
                            }
                            let _e727 = phi_983_;
                            let _e729 = phi_1009_;
                            let _e732 = (bitcast<i32>(_e729.member) != 0i);
                            if _e732 {
                                phi_986_ = ((_e609 * _e712) - (_e612 * _e714));
                            } else {
                                phi_986_ = f32();
                            }
                            let _e737 = phi_986_;
                            continue;
                            continuing {
                                phi_982_ = _e727;
                                phi_985_ = _e737;
                                phi_987_ = _e712;
                                break if !(_e732);
                            }
                        }
                        let _e743 = local_35;
                        phi_1024_ = type_12(_e226, _e743);
                        let _e1211 = local_55;
                        phi_1027_ = _e1211;
                        phi_1029_ = f32(((2u * _e226) + 1u));
                        phi_1031_ = 0f;
                        let _e1216 = local_56;
                        phi_1033_ = _e1216;
                        loop {
                            let _e746 = phi_1024_;
                            let _e748 = phi_1027_;
                            let _e750 = phi_1029_;
                            let _e752 = phi_1031_;
                            let _e754 = phi_1033_;
                            local_36 = _e748;
                            if (_e746.member < _e746.member_1) {
                                phi_1025_ = type_12((_e746.member + 1u), _e746.member_1);
                                phi_1055_ = type_12(1u, _e746.member);
                            } else {
                                phi_1025_ = _e746;
                                phi_1055_ = type_12(0u, type_12().member_1);
                            }
                            let _e767 = phi_1025_;
                            let _e769 = phi_1055_;
                            let _e772 = (bitcast<i32>(_e769.member) != 0i);
                            if _e772 {
                                phi_1028_ = (((_e591 * _e750) * _e748) - (_e752 * _e754));
                                phi_1030_ = (_e750 + 2f);
                                phi_1032_ = (_e752 + _e750);
                            } else {
                                phi_1028_ = f32();
                                phi_1030_ = f32();
                                phi_1032_ = f32();
                            }
                            let _e780 = phi_1028_;
                            let _e782 = phi_1030_;
                            let _e784 = phi_1032_;
                            continue;
                            continuing {
                                phi_1024_ = _e767;
                                phi_1027_ = _e780;
                                phi_1029_ = _e782;
                                phi_1031_ = _e784;
                                phi_1033_ = _e748;
                                break if !(_e772);
                            }
                        }
                        let _e787 = local_36;
                        let _e788 = (_e787 * _e319);
                        let _e798 = select(1f, 0f, _e338);
                        if (_e342 == 0u) {
                            phi_1093_ = _e798;
                        } else {
                            phi_1093_ = select(_e581, _e586, _e338);
                        }
                        let _e802 = phi_1093_;
                        phi_1100_ = type_12(1u, _e342);
                        phi_1103_ = _e802;
                        phi_1105_ = _e798;
                        loop {
                            let _e805 = phi_1100_;
                            let _e807 = phi_1103_;
                            let _e809 = phi_1105_;
                            local_57 = _e807;
                            local_58 = _e809;
                            if (_e805.member < _e805.member_1) {
                                phi_1101_ = type_12((_e805.member + 1u), _e805.member_1);
                                phi_1127_ = type_12(1u, _e805.member);
                            } else {
                                phi_1101_ = _e805;
                                phi_1127_ = type_12(0u, type_12().member_1);
                            }
                            let _e822 = phi_1101_;
                            let _e824 = phi_1127_;
                            let _e827 = (bitcast<i32>(_e824.member) != 0i);
                            if _e827 {
                                phi_1104_ = ((_e609 * _e807) - (_e612 * _e809));
                            } else {
                                phi_1104_ = f32();
                            }
                            let _e832 = phi_1104_;
                            continue;
                            continuing {
                                phi_1100_ = _e822;
                                phi_1103_ = _e832;
                                phi_1105_ = _e807;
                                break if !(_e827);
                            }
                        }
                        let _e838 = local_37;
                        phi_1142_ = type_12(_e342, _e838);
                        let _e1234 = local_57;
                        phi_1145_ = _e1234;
                        phi_1147_ = f32(((2u * _e342) + 1u));
                        phi_1149_ = 0f;
                        let _e1239 = local_58;
                        phi_1151_ = _e1239;
                        loop {
                            let _e841 = phi_1142_;
                            let _e843 = phi_1145_;
                            let _e845 = phi_1147_;
                            let _e847 = phi_1149_;
                            let _e849 = phi_1151_;
                            local_38 = _e843;
                            if (_e841.member < _e841.member_1) {
                                phi_1143_ = type_12((_e841.member + 1u), _e841.member_1);
                                phi_1173_ = type_12(1u, _e841.member);
                            } else {
                                phi_1143_ = _e841;
                                phi_1173_ = type_12(0u, type_12().member_1);
                            }
                            let _e862 = phi_1143_;
                            let _e864 = phi_1173_;
                            let _e867 = (bitcast<i32>(_e864.member) != 0i);
                            if _e867 {
                                phi_1146_ = (((_e591 * _e845) * _e843) - (_e847 * _e849));
                                phi_1148_ = (_e845 + 2f);
                                phi_1150_ = (_e847 + _e845);
                            } else {
                                phi_1146_ = f32();
                                phi_1148_ = f32();
                                phi_1150_ = f32();
                            }
                            let _e875 = phi_1146_;
                            let _e877 = phi_1148_;
                            let _e879 = phi_1150_;
                            continue;
                            continuing {
                                phi_1142_ = _e862;
                                phi_1145_ = _e875;
                                phi_1147_ = _e877;
                                phi_1149_ = _e879;
                                phi_1151_ = _e843;
                                break if !(_e867);
                            }
                        }
                        let _e882 = local_38;
                        let _e883 = (_e882 * _e435);
                        let _e893 = select(1f, 0f, _e454);
                        if (_e458 == 0u) {
                            phi_1211_ = _e893;
                        } else {
                            phi_1211_ = select(_e581, _e586, _e454);
                        }
                        let _e897 = phi_1211_;
                        phi_1218_ = type_12(1u, _e458);
                        phi_1221_ = _e897;
                        phi_1223_ = _e893;
                        loop {
                            let _e900 = phi_1218_;
                            let _e902 = phi_1221_;
                            let _e904 = phi_1223_;
                            local_59 = _e902;
                            local_60 = _e904;
                            if (_e900.member < _e900.member_1) {
                                phi_1219_ = type_12((_e900.member + 1u), _e900.member_1);
                                phi_1245_ = type_12(1u, _e900.member);
                            } else {
                                phi_1219_ = _e900;
                                phi_1245_ = type_12(0u, type_12().member_1);
                            }
                            let _e917 = phi_1219_;
                            let _e919 = phi_1245_;
                            let _e922 = (bitcast<i32>(_e919.member) != 0i);
                            if _e922 {
                                phi_1222_ = ((_e609 * _e902) - (_e612 * _e904));
                            } else {
                                phi_1222_ = f32();
                            }
                            let _e927 = phi_1222_;
                            continue;
                            continuing {
                                phi_1218_ = _e917;
                                phi_1221_ = _e927;
                                phi_1223_ = _e902;
                                break if !(_e922);
                            }
                        }
                        let _e933 = local_39;
                        phi_1260_ = type_12(_e458, _e933);
                        let _e1257 = local_59;
                        phi_1263_ = _e1257;
                        phi_1265_ = f32(((2u * _e458) + 1u));
                        phi_1267_ = 0f;
                        let _e1262 = local_60;
                        phi_1269_ = _e1262;
                        loop {
                            let _e936 = phi_1260_;
                            let _e938 = phi_1263_;
                            let _e940 = phi_1265_;
                            let _e942 = phi_1267_;
                            let _e944 = phi_1269_;
                            local_40 = _e938;
                            if (_e936.member < _e936.member_1) {
                                phi_1261_ = type_12((_e936.member + 1u), _e936.member_1);
                                phi_1291_ = type_12(1u, _e936.member);
                            } else {
                                phi_1261_ = _e936;
                                phi_1291_ = type_12(0u, type_12().member_1);
                            }
                            let _e957 = phi_1261_;
                            let _e959 = phi_1291_;
                            let _e962 = (bitcast<i32>(_e959.member) != 0i);
                            if _e962 {
                                phi_1264_ = (((_e591 * _e940) * _e938) - (_e942 * _e944));
                                phi_1266_ = (_e940 + 2f);
                                phi_1268_ = (_e942 + _e940);
                            } else {
                                phi_1264_ = f32();
                                phi_1266_ = f32();
                                phi_1268_ = f32();
                            }
                            let _e970 = phi_1264_;
                            let _e972 = phi_1266_;
                            let _e974 = phi_1268_;
                            continue;
                            continuing {
                                phi_1260_ = _e957;
                                phi_1263_ = _e970;
                                phi_1265_ = _e972;
                                phi_1267_ = _e974;
                                phi_1269_ = _e938;
                                break if !(_e962);
                            }
                        }
                        let _e977 = local_40;
                        let _e978 = (_e977 * _e551);
                        phi_766_ = array<f32, 12>((_e556[0] + (_e595 * _e693)), (_e556[1] + (_e595 * _e788)), (_e556[2] + (_e595 * _e883)), (_e556[3] + (_e595 * _e978)), (_e556[4] + (_e599 * _e693)), (_e556[5] + (_e599 * _e788)), (_e556[6] + (_e599 * _e883)), (_e556[7] + (_e599 * _e978)), (_e556[8] + (_e603 * _e693)), (_e556[9] + (_e603 * _e788)), (_e556[10] + (_e603 * _e883)), (_e556[11] + (_e603 * _e978)));
                    } else {
                        phi_766_ = array<f32, 12>();
                    }
                    let _e990 = phi_766_;
                    continue;
                    continuing {
                        phi_762_ = _e569;
                        phi_765_ = _e990;
                        phi_1425_ = false;
                        break if !(_e575);
                    }
                }
                let _e993 = phi_1425_;
                if _e993 {
                    break;
                }
                let _e996 = params.member.member_3;
                let _e998 = local_41;
                let _e1002 = local_42;
                let _e1006 = local_43;
                let _e1010 = local_44;
                let _e1014 = local_45;
                let _e1018 = local_46;
                let _e1022 = local_47;
                let _e1026 = local_48;
                let _e1030 = local_49;
                let _e1034 = local_50;
                let _e1038 = local_51;
                let _e1042 = local_52;
                local = array<f32, 12>((_e998[0] * _e996), (_e1002[1] * _e996), (_e1006[2] * _e996), (_e1010[3] * _e996), (_e1014[4] * _e996), (_e1018[5] * _e996), (_e1022[6] * _e996), (_e1026[7] * _e996), (_e1030[8] * _e996), (_e1034[9] * _e996), (_e1038[10] * _e996), (_e1042[11] * _e996));
                phi_1370_ = type_12(0u, 12u);
                loop {
                    let _e1047 = phi_1370_;
                    if (_e1047.member < _e1047.member_1) {
                        phi_1371_ = type_12((_e1047.member + 1u), _e1047.member_1);
                        phi_1394_ = type_12(1u, _e1047.member);
                    } else {
                        phi_1371_ = _e1047;
                        phi_1394_ = type_12(0u, type_12().member_1);
                    }
                    let _e1060 = phi_1371_;
                    let _e1062 = phi_1394_;
                    let _e1066 = (bitcast<i32>(_e1062.member) != 0i);
                    if _e1066 {
                        if (_e1062.member_1 < 12u) {
                        } else {
                            phi_1518_ = true;
                            break;
                        }
                        let _e1069 = local[_e1062.member_1];
                        let _e1071 = ((_e1062.member_1 * _e62) + _e66);
                        if (_e1071 < arrayLength((&coefs.member))) {
                        } else {
                            phi_1518_ = true;
                            break;
                        }
                        coefs.member[_e1071] = _e1069;
                    }
                    continue;
                    continuing {
                        phi_1370_ = _e1060;
                        phi_1518_ = _e993;
                        break if !(_e1066);
                    }
                }
                let _e1077 = phi_1518_;
                if _e1077 {
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
