struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_14 {
    member: type_13,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_14;
@group(0) @binding(1) 
var<storage> directions: type_5;
@group(0) @binding(2) 
var<storage, read_write> table: type_5;

fn function_() {
    var local: array<f32, 4>;
    var phi_94_: u32;
    var phi_137_: u32;
    var phi_138_: u32;
    var phi_155_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_168_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_187_: type_11;
    var phi_190_: f32;
    var phi_188_: type_11;
    var phi_213_: type_11;
    var local_5: u32;
    var phi_191_: f32;
    var local_6: u32;
    var phi_237_: type_11;
    var phi_240_: f32;
    var phi_238_: type_11;
    var phi_263_: type_11;
    var phi_241_: f32;
    var local_7: f32;
    var local_8: f32;
    var phi_275_: f32;
    var phi_278_: u32;
    var phi_279_: u32;
    var phi_296_: bool;
    var local_9: u32;
    var local_10: u32;
    var phi_309_: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_328_: type_11;
    var phi_331_: f32;
    var phi_329_: type_11;
    var phi_354_: type_11;
    var local_13: u32;
    var phi_332_: f32;
    var local_14: u32;
    var phi_378_: type_11;
    var phi_381_: f32;
    var phi_379_: type_11;
    var phi_404_: type_11;
    var phi_382_: f32;
    var local_15: f32;
    var local_16: f32;
    var phi_416_: f32;
    var phi_419_: u32;
    var phi_420_: u32;
    var phi_437_: bool;
    var local_17: u32;
    var local_18: u32;
    var phi_450_: u32;
    var local_19: u32;
    var local_20: u32;
    var phi_469_: type_11;
    var phi_472_: f32;
    var phi_470_: type_11;
    var phi_495_: type_11;
    var local_21: u32;
    var phi_473_: f32;
    var local_22: u32;
    var phi_519_: type_11;
    var phi_522_: f32;
    var phi_520_: type_11;
    var phi_545_: type_11;
    var phi_523_: f32;
    var local_23: f32;
    var local_24: f32;
    var phi_557_: f32;
    var phi_560_: u32;
    var phi_561_: u32;
    var phi_578_: bool;
    var local_25: u32;
    var local_26: u32;
    var phi_591_: u32;
    var local_27: u32;
    var local_28: u32;
    var phi_610_: type_11;
    var phi_613_: f32;
    var phi_611_: type_11;
    var phi_636_: type_11;
    var local_29: u32;
    var phi_614_: f32;
    var local_30: u32;
    var phi_660_: type_11;
    var phi_663_: f32;
    var phi_661_: type_11;
    var phi_686_: type_11;
    var phi_664_: f32;
    var local_31: f32;
    var local_32: f32;
    var phi_698_: f32;
    var phi_711_: f32;
    var phi_718_: type_11;
    var phi_721_: f32;
    var phi_723_: f32;
    var phi_719_: type_11;
    var phi_745_: type_11;
    var phi_722_: f32;
    var local_33: u32;
    var phi_760_: type_11;
    var phi_763_: f32;
    var phi_765_: f32;
    var phi_767_: f32;
    var phi_769_: f32;
    var phi_761_: type_11;
    var phi_791_: type_11;
    var phi_764_: f32;
    var phi_766_: f32;
    var phi_768_: f32;
    var local_34: f32;
    var phi_818_: f32;
    var phi_825_: type_11;
    var phi_828_: f32;
    var phi_830_: f32;
    var phi_826_: type_11;
    var phi_852_: type_11;
    var phi_829_: f32;
    var local_35: u32;
    var phi_867_: type_11;
    var phi_870_: f32;
    var phi_872_: f32;
    var phi_874_: f32;
    var phi_876_: f32;
    var phi_868_: type_11;
    var phi_898_: type_11;
    var phi_871_: f32;
    var phi_873_: f32;
    var phi_875_: f32;
    var local_36: f32;
    var phi_925_: f32;
    var phi_932_: type_11;
    var phi_935_: f32;
    var phi_937_: f32;
    var phi_933_: type_11;
    var phi_959_: type_11;
    var phi_936_: f32;
    var local_37: u32;
    var phi_974_: type_11;
    var phi_977_: f32;
    var phi_979_: f32;
    var phi_981_: f32;
    var phi_983_: f32;
    var phi_975_: type_11;
    var phi_1005_: type_11;
    var phi_978_: f32;
    var phi_980_: f32;
    var phi_982_: f32;
    var local_38: f32;
    var phi_1032_: f32;
    var phi_1039_: type_11;
    var phi_1042_: f32;
    var phi_1044_: f32;
    var phi_1040_: type_11;
    var phi_1066_: type_11;
    var phi_1043_: f32;
    var local_39: u32;
    var phi_1081_: type_11;
    var phi_1084_: f32;
    var phi_1086_: f32;
    var phi_1088_: f32;
    var phi_1090_: f32;
    var phi_1082_: type_11;
    var phi_1112_: type_11;
    var phi_1085_: f32;
    var phi_1087_: f32;
    var phi_1089_: f32;
    var local_40: f32;
    var phi_1135_: type_11;
    var phi_1136_: type_11;
    var phi_1159_: type_11;
    var phi_1188_: bool;
    var local_41: f32;
    var local_42: f32;
    var local_43: f32;
    var local_44: f32;
    var local_45: f32;
    var local_46: f32;
    var local_47: f32;
    var local_48: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = gid_1;
            let _e30 = params.member.member_2;
            let _e33 = (select(_e30, 9u, (_e30 > 9u)) + 1u);
            let _e34 = (_e33 * _e33);
            let _e35 = (_e34 / 4u);
            if ((_e34 % 4u) > 0u) {
                phi_94_ = (_e35 + 1u);
            } else {
                phi_94_ = _e35;
            }
            let _e40 = phi_94_;
            let _e43 = params.member.member_1;
            let _e44 = (_e40 * _e43);
            let _e48 = (_e25.x + (_e25.y * 2097152u));
            if (_e48 < _e44) {
                if (_e43 == 0u) {
                    break;
                }
                let _e51 = (_e48 / _e43);
                let _e53 = (_e48 - (_e51 * _e43));
                let _e56 = directions.member[_e53];
                let _e60 = directions.member[(_e43 + _e53)];
                let _e65 = directions.member[((2u * _e43) + _e53)];
                let _e70 = directions.member[((3u * _e43) + _e53)];
                let _e71 = (_e51 * 4u);
                phi_137_ = 0u;
                loop {
                    let _e73 = phi_137_;
                    local_1 = _e73;
                    local_3 = _e73;
                    local_4 = _e73;
                    local_5 = _e73;
                    local_6 = _e73;
                    local_33 = _e73;
                    let _e74 = (_e73 + 1u);
                    local_2 = _e74;
                    if ((_e74 * _e74) <= _e71) {
                        let _e77 = (_e73 < 9u);
                        phi_138_ = select(u32(), _e74, _e77);
                        phi_155_ = _e77;
                    } else {
                        phi_138_ = u32();
                        phi_155_ = false;
                    }
                    let _e80 = phi_138_;
                    let _e82 = phi_155_;
                    continue;
                    continuing {
                        phi_137_ = _e80;
                        break if !(_e82);
                    }
                }
                let _e85 = local_1;
                let _e87 = local_2;
                let _e88 = (_e85 * _e87);
                let _e89 = (_e71 < _e88);
                if _e89 {
                    phi_168_ = (_e88 - _e71);
                } else {
                    phi_168_ = (_e71 - _e88);
                }
                let _e93 = phi_168_;
                let _e95 = local_3;
                if (_e95 <= _e30) {
                    let _e98 = local_4;
                    phi_187_ = type_11(1u, (_e93 + 1u));
                    phi_190_ = (f32(((2u * _e98) + 1u)) / select(6.2831855f, 12.566371f, (_e93 == 0u)));
                    loop {
                        let _e108 = phi_187_;
                        let _e110 = phi_190_;
                        local_7 = _e110;
                        if (_e108.member < _e108.member_1) {
                            phi_188_ = type_11((_e108.member + 1u), _e108.member_1);
                            phi_213_ = type_11(1u, _e108.member);
                        } else {
                            phi_188_ = _e108;
                            phi_213_ = type_11(0u, type_11().member_1);
                        }
                        let _e123 = phi_188_;
                        let _e125 = phi_213_;
                        let _e129 = (bitcast<i32>(_e125.member) != 0i);
                        if _e129 {
                            let _e130 = (2u * _e125.member_1);
                            let _e132 = f32((_e130 - 1u));
                            let _e134 = local_5;
                            let _e137 = f32(((_e134 - _e93) + _e130));
                            phi_191_ = (_e110 * ((_e132 * _e132) / (_e137 * (_e137 - 1f))));
                        } else {
                            phi_191_ = f32();
                        }
                        let _e144 = phi_191_;
                        continue;
                        continuing {
                            phi_187_ = _e123;
                            phi_190_ = _e144;
                            break if !(_e129);
                        }
                    }
                    let _e147 = local_6;
                    phi_237_ = type_11(1u, ((_e147 - _e93) + 1u));
                    phi_240_ = 1f;
                    loop {
                        let _e152 = phi_237_;
                        let _e154 = phi_240_;
                        local_8 = _e154;
                        if (_e152.member < _e152.member_1) {
                            phi_238_ = type_11((_e152.member + 1u), _e152.member_1);
                            phi_263_ = type_11(1u, _e152.member);
                        } else {
                            phi_238_ = _e152;
                            phi_263_ = type_11(0u, type_11().member_1);
                        }
                        let _e167 = phi_238_;
                        let _e169 = phi_263_;
                        let _e173 = (bitcast<i32>(_e169.member) != 0i);
                        if _e173 {
                            phi_241_ = (_e154 * f32(_e169.member_1));
                        } else {
                            phi_241_ = f32();
                        }
                        let _e177 = phi_241_;
                        continue;
                        continuing {
                            phi_237_ = _e167;
                            phi_240_ = _e177;
                            break if !(_e173);
                        }
                    }
                    let _e180 = local_7;
                    let _e183 = local_8;
                    phi_275_ = (sqrt(_e180) / _e183);
                } else {
                    phi_275_ = 0f;
                }
                let _e186 = phi_275_;
                let _e187 = (_e71 + 1u);
                phi_278_ = 0u;
                loop {
                    let _e189 = phi_278_;
                    local_9 = _e189;
                    local_11 = _e189;
                    local_12 = _e189;
                    local_13 = _e189;
                    local_14 = _e189;
                    local_35 = _e189;
                    let _e190 = (_e189 + 1u);
                    local_10 = _e190;
                    if ((_e190 * _e190) <= _e187) {
                        let _e193 = (_e189 < 9u);
                        phi_279_ = select(u32(), _e190, _e193);
                        phi_296_ = _e193;
                    } else {
                        phi_279_ = u32();
                        phi_296_ = false;
                    }
                    let _e196 = phi_279_;
                    let _e198 = phi_296_;
                    continue;
                    continuing {
                        phi_278_ = _e196;
                        break if !(_e198);
                    }
                }
                let _e201 = local_9;
                let _e203 = local_10;
                let _e204 = (_e201 * _e203);
                let _e205 = (_e187 < _e204);
                if _e205 {
                    phi_309_ = (_e204 - _e187);
                } else {
                    phi_309_ = (_e187 - _e204);
                }
                let _e209 = phi_309_;
                let _e211 = local_11;
                if (_e211 <= _e30) {
                    let _e214 = local_12;
                    phi_328_ = type_11(1u, (_e209 + 1u));
                    phi_331_ = (f32(((2u * _e214) + 1u)) / select(6.2831855f, 12.566371f, (_e209 == 0u)));
                    loop {
                        let _e224 = phi_328_;
                        let _e226 = phi_331_;
                        local_15 = _e226;
                        if (_e224.member < _e224.member_1) {
                            phi_329_ = type_11((_e224.member + 1u), _e224.member_1);
                            phi_354_ = type_11(1u, _e224.member);
                        } else {
                            phi_329_ = _e224;
                            phi_354_ = type_11(0u, type_11().member_1);
                        }
                        let _e239 = phi_329_;
                        let _e241 = phi_354_;
                        let _e245 = (bitcast<i32>(_e241.member) != 0i);
                        if _e245 {
                            let _e246 = (2u * _e241.member_1);
                            let _e248 = f32((_e246 - 1u));
                            let _e250 = local_13;
                            let _e253 = f32(((_e250 - _e209) + _e246));
                            phi_332_ = (_e226 * ((_e248 * _e248) / (_e253 * (_e253 - 1f))));
                        } else {
                            phi_332_ = f32();
                        }
                        let _e260 = phi_332_;
                        continue;
                        continuing {
                            phi_328_ = _e239;
                            phi_331_ = _e260;
                            break if !(_e245);
                        }
                    }
                    let _e263 = local_14;
                    phi_378_ = type_11(1u, ((_e263 - _e209) + 1u));
                    phi_381_ = 1f;
                    loop {
                        let _e268 = phi_378_;
                        let _e270 = phi_381_;
                        local_16 = _e270;
                        if (_e268.member < _e268.member_1) {
                            phi_379_ = type_11((_e268.member + 1u), _e268.member_1);
                            phi_404_ = type_11(1u, _e268.member);
                        } else {
                            phi_379_ = _e268;
                            phi_404_ = type_11(0u, type_11().member_1);
                        }
                        let _e283 = phi_379_;
                        let _e285 = phi_404_;
                        let _e289 = (bitcast<i32>(_e285.member) != 0i);
                        if _e289 {
                            phi_382_ = (_e270 * f32(_e285.member_1));
                        } else {
                            phi_382_ = f32();
                        }
                        let _e293 = phi_382_;
                        continue;
                        continuing {
                            phi_378_ = _e283;
                            phi_381_ = _e293;
                            break if !(_e289);
                        }
                    }
                    let _e296 = local_15;
                    let _e299 = local_16;
                    phi_416_ = (sqrt(_e296) / _e299);
                } else {
                    phi_416_ = 0f;
                }
                let _e302 = phi_416_;
                let _e303 = (_e71 + 2u);
                phi_419_ = 0u;
                loop {
                    let _e305 = phi_419_;
                    local_17 = _e305;
                    local_19 = _e305;
                    local_20 = _e305;
                    local_21 = _e305;
                    local_22 = _e305;
                    local_37 = _e305;
                    let _e306 = (_e305 + 1u);
                    local_18 = _e306;
                    if ((_e306 * _e306) <= _e303) {
                        let _e309 = (_e305 < 9u);
                        phi_420_ = select(u32(), _e306, _e309);
                        phi_437_ = _e309;
                    } else {
                        phi_420_ = u32();
                        phi_437_ = false;
                    }
                    let _e312 = phi_420_;
                    let _e314 = phi_437_;
                    continue;
                    continuing {
                        phi_419_ = _e312;
                        break if !(_e314);
                    }
                }
                let _e317 = local_17;
                let _e319 = local_18;
                let _e320 = (_e317 * _e319);
                let _e321 = (_e303 < _e320);
                if _e321 {
                    phi_450_ = (_e320 - _e303);
                } else {
                    phi_450_ = (_e303 - _e320);
                }
                let _e325 = phi_450_;
                let _e327 = local_19;
                if (_e327 <= _e30) {
                    let _e330 = local_20;
                    phi_469_ = type_11(1u, (_e325 + 1u));
                    phi_472_ = (f32(((2u * _e330) + 1u)) / select(6.2831855f, 12.566371f, (_e325 == 0u)));
                    loop {
                        let _e340 = phi_469_;
                        let _e342 = phi_472_;
                        local_23 = _e342;
                        if (_e340.member < _e340.member_1) {
                            phi_470_ = type_11((_e340.member + 1u), _e340.member_1);
                            phi_495_ = type_11(1u, _e340.member);
                        } else {
                            phi_470_ = _e340;
                            phi_495_ = type_11(0u, type_11().member_1);
                        }
                        let _e355 = phi_470_;
                        let _e357 = phi_495_;
                        let _e361 = (bitcast<i32>(_e357.member) != 0i);
                        if _e361 {
                            let _e362 = (2u * _e357.member_1);
                            let _e364 = f32((_e362 - 1u));
                            let _e366 = local_21;
                            let _e369 = f32(((_e366 - _e325) + _e362));
                            phi_473_ = (_e342 * ((_e364 * _e364) / (_e369 * (_e369 - 1f))));
                        } else {
                            phi_473_ = f32();
                        }
                        let _e376 = phi_473_;
                        continue;
                        continuing {
                            phi_469_ = _e355;
                            phi_472_ = _e376;
                            break if !(_e361);
                        }
                    }
                    let _e379 = local_22;
                    phi_519_ = type_11(1u, ((_e379 - _e325) + 1u));
                    phi_522_ = 1f;
                    loop {
                        let _e384 = phi_519_;
                        let _e386 = phi_522_;
                        local_24 = _e386;
                        if (_e384.member < _e384.member_1) {
                            phi_520_ = type_11((_e384.member + 1u), _e384.member_1);
                            phi_545_ = type_11(1u, _e384.member);
                        } else {
                            phi_520_ = _e384;
                            phi_545_ = type_11(0u, type_11().member_1);
                        }
                        let _e399 = phi_520_;
                        let _e401 = phi_545_;
                        let _e405 = (bitcast<i32>(_e401.member) != 0i);
                        if _e405 {
                            phi_523_ = (_e386 * f32(_e401.member_1));
                        } else {
                            phi_523_ = f32();
                        }
                        let _e409 = phi_523_;
                        continue;
                        continuing {
                            phi_519_ = _e399;
                            phi_522_ = _e409;
                            break if !(_e405);
                        }
                    }
                    let _e412 = local_23;
                    let _e415 = local_24;
                    phi_557_ = (sqrt(_e412) / _e415);
                } else {
                    phi_557_ = 0f;
                }
                let _e418 = phi_557_;
                let _e419 = (_e71 + 3u);
                phi_560_ = 0u;
                loop {
                    let _e421 = phi_560_;
                    local_25 = _e421;
                    local_27 = _e421;
                    local_28 = _e421;
                    local_29 = _e421;
                    local_30 = _e421;
                    local_39 = _e421;
                    let _e422 = (_e421 + 1u);
                    local_26 = _e422;
                    if ((_e422 * _e422) <= _e419) {
                        let _e425 = (_e421 < 9u);
                        phi_561_ = select(u32(), _e422, _e425);
                        phi_578_ = _e425;
                    } else {
                        phi_561_ = u32();
                        phi_578_ = false;
                    }
                    let _e428 = phi_561_;
                    let _e430 = phi_578_;
                    continue;
                    continuing {
                        phi_560_ = _e428;
                        break if !(_e430);
                    }
                }
                let _e433 = local_25;
                let _e435 = local_26;
                let _e436 = (_e433 * _e435);
                let _e437 = (_e419 < _e436);
                if _e437 {
                    phi_591_ = (_e436 - _e419);
                } else {
                    phi_591_ = (_e419 - _e436);
                }
                let _e441 = phi_591_;
                let _e443 = local_27;
                if (_e443 <= _e30) {
                    let _e446 = local_28;
                    phi_610_ = type_11(1u, (_e441 + 1u));
                    phi_613_ = (f32(((2u * _e446) + 1u)) / select(6.2831855f, 12.566371f, (_e441 == 0u)));
                    loop {
                        let _e456 = phi_610_;
                        let _e458 = phi_613_;
                        local_31 = _e458;
                        if (_e456.member < _e456.member_1) {
                            phi_611_ = type_11((_e456.member + 1u), _e456.member_1);
                            phi_636_ = type_11(1u, _e456.member);
                        } else {
                            phi_611_ = _e456;
                            phi_636_ = type_11(0u, type_11().member_1);
                        }
                        let _e471 = phi_611_;
                        let _e473 = phi_636_;
                        let _e477 = (bitcast<i32>(_e473.member) != 0i);
                        if _e477 {
                            let _e478 = (2u * _e473.member_1);
                            let _e480 = f32((_e478 - 1u));
                            let _e482 = local_29;
                            let _e485 = f32(((_e482 - _e441) + _e478));
                            phi_614_ = (_e458 * ((_e480 * _e480) / (_e485 * (_e485 - 1f))));
                        } else {
                            phi_614_ = f32();
                        }
                        let _e492 = phi_614_;
                        continue;
                        continuing {
                            phi_610_ = _e471;
                            phi_613_ = _e492;
                            break if !(_e477);
                        }
                    }
                    let _e495 = local_30;
                    phi_660_ = type_11(1u, ((_e495 - _e441) + 1u));
                    phi_663_ = 1f;
                    loop {
                        let _e500 = phi_660_;
                        let _e502 = phi_663_;
                        local_32 = _e502;
                        if (_e500.member < _e500.member_1) {
                            phi_661_ = type_11((_e500.member + 1u), _e500.member_1);
                            phi_686_ = type_11(1u, _e500.member);
                        } else {
                            phi_661_ = _e500;
                            phi_686_ = type_11(0u, type_11().member_1);
                        }
                        let _e515 = phi_661_;
                        let _e517 = phi_686_;
                        let _e521 = (bitcast<i32>(_e517.member) != 0i);
                        if _e521 {
                            phi_664_ = (_e502 * f32(_e517.member_1));
                        } else {
                            phi_664_ = f32();
                        }
                        let _e525 = phi_664_;
                        continue;
                        continuing {
                            phi_660_ = _e515;
                            phi_663_ = _e525;
                            break if !(_e521);
                        }
                    }
                    let _e528 = local_31;
                    let _e531 = local_32;
                    phi_698_ = (sqrt(_e528) / _e531);
                } else {
                    phi_698_ = 0f;
                }
                let _e534 = phi_698_;
                let _e535 = select(1f, 0f, _e89);
                if (_e93 == 0u) {
                    phi_711_ = _e535;
                } else {
                    phi_711_ = select(_e56, _e60, _e89);
                }
                let _e539 = phi_711_;
                let _e540 = (_e56 + _e56);
                let _e543 = ((_e56 * _e56) + (_e60 * _e60));
                phi_718_ = type_11(1u, _e93);
                phi_721_ = _e539;
                phi_723_ = _e535;
                loop {
                    let _e546 = phi_718_;
                    let _e548 = phi_721_;
                    let _e550 = phi_723_;
                    local_41 = _e548;
                    local_42 = _e550;
                    if (_e546.member < _e546.member_1) {
                        phi_719_ = type_11((_e546.member + 1u), _e546.member_1);
                        phi_745_ = type_11(1u, _e546.member);
                    } else {
                        phi_719_ = _e546;
                        phi_745_ = type_11(0u, type_11().member_1);
                    }
                    let _e563 = phi_719_;
                    let _e565 = phi_745_;
                    let _e568 = (bitcast<i32>(_e565.member) != 0i);
                    if _e568 {
                        phi_722_ = ((_e540 * _e548) - (_e543 * _e550));
                    } else {
                        phi_722_ = f32();
                    }
                    let _e573 = phi_722_;
                    continue;
                    continuing {
                        phi_718_ = _e563;
                        phi_721_ = _e573;
                        phi_723_ = _e548;
                        break if !(_e568);
                    }
                }
                let _e579 = local_33;
                phi_760_ = type_11(_e93, _e579);
                let _e1024 = local_41;
                phi_763_ = _e1024;
                phi_765_ = f32(((2u * _e93) + 1u));
                phi_767_ = 0f;
                let _e1029 = local_42;
                phi_769_ = _e1029;
                loop {
                    let _e582 = phi_760_;
                    let _e584 = phi_763_;
                    let _e586 = phi_765_;
                    let _e588 = phi_767_;
                    let _e590 = phi_769_;
                    local_34 = _e584;
                    if (_e582.member < _e582.member_1) {
                        phi_761_ = type_11((_e582.member + 1u), _e582.member_1);
                        phi_791_ = type_11(1u, _e582.member);
                    } else {
                        phi_761_ = _e582;
                        phi_791_ = type_11(0u, type_11().member_1);
                    }
                    let _e603 = phi_761_;
                    let _e605 = phi_791_;
                    let _e608 = (bitcast<i32>(_e605.member) != 0i);
                    if _e608 {
                        phi_764_ = (((_e65 * _e586) * _e584) - (_e588 * _e590));
                        phi_766_ = (_e586 + 2f);
                        phi_768_ = (_e588 + _e586);
                    } else {
                        phi_764_ = f32();
                        phi_766_ = f32();
                        phi_768_ = f32();
                    }
                    let _e616 = phi_764_;
                    let _e618 = phi_766_;
                    let _e620 = phi_768_;
                    continue;
                    continuing {
                        phi_760_ = _e603;
                        phi_763_ = _e616;
                        phi_765_ = _e618;
                        phi_767_ = _e620;
                        phi_769_ = _e584;
                        break if !(_e608);
                    }
                }
                let _e623 = local_34;
                let _e626 = select(1f, 0f, _e205);
                if (_e209 == 0u) {
                    phi_818_ = _e626;
                } else {
                    phi_818_ = select(_e56, _e60, _e205);
                }
                let _e630 = phi_818_;
                phi_825_ = type_11(1u, _e209);
                phi_828_ = _e630;
                phi_830_ = _e626;
                loop {
                    let _e633 = phi_825_;
                    let _e635 = phi_828_;
                    let _e637 = phi_830_;
                    local_43 = _e635;
                    local_44 = _e637;
                    if (_e633.member < _e633.member_1) {
                        phi_826_ = type_11((_e633.member + 1u), _e633.member_1);
                        phi_852_ = type_11(1u, _e633.member);
                    } else {
                        phi_826_ = _e633;
                        phi_852_ = type_11(0u, type_11().member_1);
                    }
                    let _e650 = phi_826_;
                    let _e652 = phi_852_;
                    let _e655 = (bitcast<i32>(_e652.member) != 0i);
                    if _e655 {
                        phi_829_ = ((_e540 * _e635) - (_e543 * _e637));
                    } else {
                        phi_829_ = f32();
                    }
                    let _e660 = phi_829_;
                    continue;
                    continuing {
                        phi_825_ = _e650;
                        phi_828_ = _e660;
                        phi_830_ = _e635;
                        break if !(_e655);
                    }
                }
                let _e666 = local_35;
                phi_867_ = type_11(_e209, _e666);
                let _e1047 = local_43;
                phi_870_ = _e1047;
                phi_872_ = f32(((2u * _e209) + 1u));
                phi_874_ = 0f;
                let _e1052 = local_44;
                phi_876_ = _e1052;
                loop {
                    let _e669 = phi_867_;
                    let _e671 = phi_870_;
                    let _e673 = phi_872_;
                    let _e675 = phi_874_;
                    let _e677 = phi_876_;
                    local_36 = _e671;
                    if (_e669.member < _e669.member_1) {
                        phi_868_ = type_11((_e669.member + 1u), _e669.member_1);
                        phi_898_ = type_11(1u, _e669.member);
                    } else {
                        phi_868_ = _e669;
                        phi_898_ = type_11(0u, type_11().member_1);
                    }
                    let _e690 = phi_868_;
                    let _e692 = phi_898_;
                    let _e695 = (bitcast<i32>(_e692.member) != 0i);
                    if _e695 {
                        phi_871_ = (((_e65 * _e673) * _e671) - (_e675 * _e677));
                        phi_873_ = (_e673 + 2f);
                        phi_875_ = (_e675 + _e673);
                    } else {
                        phi_871_ = f32();
                        phi_873_ = f32();
                        phi_875_ = f32();
                    }
                    let _e703 = phi_871_;
                    let _e705 = phi_873_;
                    let _e707 = phi_875_;
                    continue;
                    continuing {
                        phi_867_ = _e690;
                        phi_870_ = _e703;
                        phi_872_ = _e705;
                        phi_874_ = _e707;
                        phi_876_ = _e671;
                        break if !(_e695);
                    }
                }
                let _e710 = local_36;
                let _e713 = select(1f, 0f, _e321);
                if (_e325 == 0u) {
                    phi_925_ = _e713;
                } else {
                    phi_925_ = select(_e56, _e60, _e321);
                }
                let _e717 = phi_925_;
                phi_932_ = type_11(1u, _e325);
                phi_935_ = _e717;
                phi_937_ = _e713;
                loop {
                    let _e720 = phi_932_;
                    let _e722 = phi_935_;
                    let _e724 = phi_937_;
                    local_45 = _e722;
                    local_46 = _e724;
                    if (_e720.member < _e720.member_1) {
                        phi_933_ = type_11((_e720.member + 1u), _e720.member_1);
                        phi_959_ = type_11(1u, _e720.member);
                    } else {
                        phi_933_ = _e720;
                        phi_959_ = type_11(0u, type_11().member_1);
                    }
                    let _e737 = phi_933_;
                    let _e739 = phi_959_;
                    let _e742 = (bitcast<i32>(_e739.member) != 0i);
                    if _e742 {
                        phi_936_ = ((_e540 * _e722) - (_e543 * _e724));
                    } else {
                        phi_936_ = f32();
                    }
                    let _e747 = phi_936_;
                    continue;
                    continuing {
                        phi_932_ = _e737;
                        phi_935_ = _e747;
                        phi_937_ = _e722;
                        break if !(_e742);
                    }
                }
                let _e753 = local_37;
                phi_974_ = type_11(_e325, _e753);
                let _e1070 = local_45;
                phi_977_ = _e1070;
                phi_979_ = f32(((2u * _e325) + 1u));
                phi_981_ = 0f;
                let _e1075 = local_46;
                phi_983_ = _e1075;
                loop {
                    let _e756 = phi_974_;
                    let _e758 = phi_977_;
                    let _e760 = phi_979_;
                    let _e762 = phi_981_;
                    let _e764 = phi_983_;
                    local_38 = _e758;
                    if (_e756.member < _e756.member_1) {
                        phi_975_ = type_11((_e756.member + 1u), _e756.member_1);
                        phi_1005_ = type_11(1u, _e756.member);
                    } else {
                        phi_975_ = _e756;
                        phi_1005_ = type_11(0u, type_11().member_1);
                    }
                    let _e777 = phi_975_;
                    let _e779 = phi_1005_;
                    let _e782 = (bitcast<i32>(_e779.member) != 0i);
                    if _e782 {
                        phi_978_ = (((_e65 * _e760) * _e758) - (_e762 * _e764));
                        phi_980_ = (_e760 + 2f);
                        phi_982_ = (_e762 + _e760);
                    } else {
                        phi_978_ = f32();
                        phi_980_ = f32();
                        phi_982_ = f32();
                    }
                    let _e790 = phi_978_;
                    let _e792 = phi_980_;
                    let _e794 = phi_982_;
                    continue;
                    continuing {
                        phi_974_ = _e777;
                        phi_977_ = _e790;
                        phi_979_ = _e792;
                        phi_981_ = _e794;
                        phi_983_ = _e758;
                        break if !(_e782);
                    }
                }
                let _e797 = local_38;
                let _e800 = select(1f, 0f, _e437);
                if (_e441 == 0u) {
                    phi_1032_ = _e800;
                } else {
                    phi_1032_ = select(_e56, _e60, _e437);
                }
                let _e804 = phi_1032_;
                phi_1039_ = type_11(1u, _e441);
                phi_1042_ = _e804;
                phi_1044_ = _e800;
                loop {
                    let _e807 = phi_1039_;
                    let _e809 = phi_1042_;
                    let _e811 = phi_1044_;
                    local_47 = _e809;
                    local_48 = _e811;
                    if (_e807.member < _e807.member_1) {
                        phi_1040_ = type_11((_e807.member + 1u), _e807.member_1);
                        phi_1066_ = type_11(1u, _e807.member);
                    } else {
                        phi_1040_ = _e807;
                        phi_1066_ = type_11(0u, type_11().member_1);
                    }
                    let _e824 = phi_1040_;
                    let _e826 = phi_1066_;
                    let _e829 = (bitcast<i32>(_e826.member) != 0i);
                    if _e829 {
                        phi_1043_ = ((_e540 * _e809) - (_e543 * _e811));
                    } else {
                        phi_1043_ = f32();
                    }
                    let _e834 = phi_1043_;
                    continue;
                    continuing {
                        phi_1039_ = _e824;
                        phi_1042_ = _e834;
                        phi_1044_ = _e809;
                        break if !(_e829);
                    }
                }
                let _e840 = local_39;
                phi_1081_ = type_11(_e441, _e840);
                let _e1093 = local_47;
                phi_1084_ = _e1093;
                phi_1086_ = f32(((2u * _e441) + 1u));
                phi_1088_ = 0f;
                let _e1098 = local_48;
                phi_1090_ = _e1098;
                loop {
                    let _e843 = phi_1081_;
                    let _e845 = phi_1084_;
                    let _e847 = phi_1086_;
                    let _e849 = phi_1088_;
                    let _e851 = phi_1090_;
                    local_40 = _e845;
                    if (_e843.member < _e843.member_1) {
                        phi_1082_ = type_11((_e843.member + 1u), _e843.member_1);
                        phi_1112_ = type_11(1u, _e843.member);
                    } else {
                        phi_1082_ = _e843;
                        phi_1112_ = type_11(0u, type_11().member_1);
                    }
                    let _e864 = phi_1082_;
                    let _e866 = phi_1112_;
                    let _e869 = (bitcast<i32>(_e866.member) != 0i);
                    if _e869 {
                        phi_1085_ = (((_e65 * _e847) * _e845) - (_e849 * _e851));
                        phi_1087_ = (_e847 + 2f);
                        phi_1089_ = (_e849 + _e847);
                    } else {
                        phi_1085_ = f32();
                        phi_1087_ = f32();
                        phi_1089_ = f32();
                    }
                    let _e877 = phi_1085_;
                    let _e879 = phi_1087_;
                    let _e881 = phi_1089_;
                    continue;
                    continuing {
                        phi_1081_ = _e864;
                        phi_1084_ = _e877;
                        phi_1086_ = _e879;
                        phi_1088_ = _e881;
                        phi_1090_ = _e845;
                        break if !(_e869);
                    }
                }
                let _e884 = local_40;
                local = array<f32, 4>((_e70 * (_e623 * _e186)), (_e70 * (_e710 * _e302)), (_e70 * (_e797 * _e418)), (_e70 * (_e884 * _e534)));
                phi_1135_ = type_11(0u, 4u);
                loop {
                    let _e889 = phi_1135_;
                    if (_e889.member < _e889.member_1) {
                        phi_1136_ = type_11((_e889.member + 1u), _e889.member_1);
                        phi_1159_ = type_11(1u, _e889.member);
                    } else {
                        phi_1136_ = _e889;
                        phi_1159_ = type_11(0u, type_11().member_1);
                    }
                    let _e902 = phi_1136_;
                    let _e904 = phi_1159_;
                    let _e908 = (bitcast<i32>(_e904.member) != 0i);
                    if _e908 {
                        if (_e904.member_1 < 4u) {
                        } else {
                            phi_1188_ = true;
                            break;
                        }
                        let _e911 = local[_e904.member_1];
                        let _e913 = ((_e904.member_1 * _e44) + _e48);
                        if (_e913 < arrayLength((&table.member))) {
                        } else {
                            phi_1188_ = true;
                            break;
                        }
                        table.member[_e913] = _e911;
                    }
                    continue;
                    continuing {
                        phi_1135_ = _e902;
                        phi_1188_ = false;
                        break if !(_e908);
                    }
                }
                let _e919 = phi_1188_;
                if _e919 {
                    break;
                }
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
