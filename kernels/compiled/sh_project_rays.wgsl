struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_15 {
    member: type_14,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_15;
@group(0) @binding(1) 
var<storage> directions: type_5;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(3) 
var<storage, read_write> coefs: type_5;

fn function_() {
    var phi_87_: u32;
    var phi_106_: u32;
    var phi_170_: u32;
    var phi_194_: u32;
    var phi_195_: u32;
    var phi_212_: bool;
    var local: u32;
    var local_1: u32;
    var phi_225_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_244_: type_12;
    var phi_247_: f32;
    var phi_245_: type_12;
    var phi_270_: type_12;
    var local_4: u32;
    var phi_248_: f32;
    var local_5: u32;
    var phi_294_: type_12;
    var phi_297_: f32;
    var phi_295_: type_12;
    var phi_320_: type_12;
    var phi_298_: f32;
    var local_6: f32;
    var local_7: f32;
    var phi_332_: f32;
    var phi_335_: u32;
    var phi_336_: u32;
    var phi_353_: bool;
    var local_8: u32;
    var local_9: u32;
    var phi_366_: u32;
    var local_10: u32;
    var local_11: u32;
    var phi_385_: type_12;
    var phi_388_: f32;
    var phi_386_: type_12;
    var phi_411_: type_12;
    var local_12: u32;
    var phi_389_: f32;
    var local_13: u32;
    var phi_435_: type_12;
    var phi_438_: f32;
    var phi_436_: type_12;
    var phi_461_: type_12;
    var phi_439_: f32;
    var local_14: f32;
    var local_15: f32;
    var phi_473_: f32;
    var phi_476_: u32;
    var phi_477_: u32;
    var phi_494_: bool;
    var local_16: u32;
    var local_17: u32;
    var phi_507_: u32;
    var local_18: u32;
    var local_19: u32;
    var phi_526_: type_12;
    var phi_529_: f32;
    var phi_527_: type_12;
    var phi_552_: type_12;
    var local_20: u32;
    var phi_530_: f32;
    var local_21: u32;
    var phi_576_: type_12;
    var phi_579_: f32;
    var phi_577_: type_12;
    var phi_602_: type_12;
    var phi_580_: f32;
    var local_22: f32;
    var local_23: f32;
    var phi_614_: f32;
    var phi_617_: u32;
    var phi_618_: u32;
    var phi_635_: bool;
    var local_24: u32;
    var local_25: u32;
    var phi_648_: u32;
    var local_26: u32;
    var local_27: u32;
    var phi_667_: type_12;
    var phi_670_: f32;
    var phi_668_: type_12;
    var phi_693_: type_12;
    var local_28: u32;
    var phi_671_: f32;
    var local_29: u32;
    var phi_717_: type_12;
    var phi_720_: f32;
    var phi_718_: type_12;
    var phi_743_: type_12;
    var phi_721_: f32;
    var local_30: f32;
    var local_31: f32;
    var phi_755_: f32;
    var phi_761_: type_12;
    var phi_764_: array<f32, 12>;
    var phi_762_: type_12;
    var phi_787_: type_12;
    var phi_826_: f32;
    var phi_833_: type_12;
    var phi_836_: f32;
    var phi_838_: f32;
    var phi_834_: type_12;
    var phi_860_: type_12;
    var phi_837_: f32;
    var local_32: u32;
    var phi_875_: type_12;
    var phi_878_: f32;
    var phi_880_: f32;
    var phi_882_: f32;
    var phi_884_: f32;
    var phi_876_: type_12;
    var phi_906_: type_12;
    var phi_879_: f32;
    var phi_881_: f32;
    var phi_883_: f32;
    var local_33: f32;
    var phi_941_: f32;
    var phi_948_: type_12;
    var phi_951_: f32;
    var phi_953_: f32;
    var phi_949_: type_12;
    var phi_975_: type_12;
    var phi_952_: f32;
    var local_34: u32;
    var phi_990_: type_12;
    var phi_993_: f32;
    var phi_995_: f32;
    var phi_997_: f32;
    var phi_999_: f32;
    var phi_991_: type_12;
    var phi_1021_: type_12;
    var phi_994_: f32;
    var phi_996_: f32;
    var phi_998_: f32;
    var local_35: f32;
    var phi_1056_: f32;
    var phi_1063_: type_12;
    var phi_1066_: f32;
    var phi_1068_: f32;
    var phi_1064_: type_12;
    var phi_1090_: type_12;
    var phi_1067_: f32;
    var local_36: u32;
    var phi_1105_: type_12;
    var phi_1108_: f32;
    var phi_1110_: f32;
    var phi_1112_: f32;
    var phi_1114_: f32;
    var phi_1106_: type_12;
    var phi_1136_: type_12;
    var phi_1109_: f32;
    var phi_1111_: f32;
    var phi_1113_: f32;
    var local_37: f32;
    var phi_1171_: f32;
    var phi_1178_: type_12;
    var phi_1181_: f32;
    var phi_1183_: f32;
    var phi_1179_: type_12;
    var phi_1205_: type_12;
    var phi_1182_: f32;
    var local_38: u32;
    var phi_1220_: type_12;
    var phi_1223_: f32;
    var phi_1225_: f32;
    var phi_1227_: f32;
    var phi_1229_: f32;
    var phi_1221_: type_12;
    var phi_1251_: type_12;
    var phi_1224_: f32;
    var phi_1226_: f32;
    var phi_1228_: f32;
    var local_39: f32;
    var phi_765_: array<f32, 12>;
    var local_40: array<f32, 12>;
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
    var local_52: f32;
    var local_53: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var local_57: f32;
    var local_58: f32;
    var local_59: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e37 = gid_1;
            let _e40 = params.member.member;
            let _e43 = params.member.member_2;
            let _e46 = (_e40 / 64u);
            if ((_e40 % 64u) > 0u) {
                phi_87_ = (_e46 + 1u);
            } else {
                phi_87_ = _e46;
            }
            let _e51 = phi_87_;
            let _e52 = (select(_e43, 9u, (_e43 > 9u)) + 1u);
            let _e53 = (_e52 * _e52);
            let _e54 = (_e53 / 4u);
            let _e56 = ((_e53 % 4u) > 0u);
            if _e56 {
                phi_106_ = (_e54 + 1u);
            } else {
                phi_106_ = _e54;
            }
            let _e59 = phi_106_;
            let _e60 = (_e51 * _e59);
            let _e61 = (_e60 * 64u);
            let _e65 = (_e37.x + (_e37.y * 2097152u));
            if (_e65 < _e61) {
                let _e67 = (_e65 / 64u);
                if _e56 {
                    phi_170_ = (_e54 + 1u);
                } else {
                    phi_170_ = _e54;
                }
                let _e72 = phi_170_;
                if (_e72 == 0u) {
                    break;
                }
                let _e74 = (_e67 / _e72);
                let _e77 = (_e74 * 64u);
                let _e80 = params.member.member_1;
                let _e87 = ((_e67 - (_e74 * _e72)) * 4u);
                phi_194_ = 0u;
                loop {
                    let _e89 = phi_194_;
                    local = _e89;
                    local_2 = _e89;
                    local_3 = _e89;
                    local_4 = _e89;
                    local_5 = _e89;
                    local_32 = _e89;
                    let _e90 = (_e89 + 1u);
                    local_1 = _e90;
                    if ((_e90 * _e90) <= _e87) {
                        let _e93 = (_e89 < 9u);
                        phi_195_ = select(u32(), _e90, _e93);
                        phi_212_ = _e93;
                    } else {
                        phi_195_ = u32();
                        phi_212_ = false;
                    }
                    let _e96 = phi_195_;
                    let _e98 = phi_212_;
                    continue;
                    continuing {
                        phi_194_ = _e96;
                        break if !(_e98);
                    }
                }
                let _e101 = local;
                let _e103 = local_1;
                let _e104 = (_e101 * _e103);
                let _e105 = (_e87 < _e104);
                if _e105 {
                    phi_225_ = (_e104 - _e87);
                } else {
                    phi_225_ = (_e87 - _e104);
                }
                let _e109 = phi_225_;
                let _e111 = local_2;
                if (_e111 <= _e43) {
                    let _e114 = local_3;
                    phi_244_ = type_12(1u, (_e109 + 1u));
                    phi_247_ = (f32(((2u * _e114) + 1u)) / select(6.2831855f, 12.566371f, (_e109 == 0u)));
                    loop {
                        let _e124 = phi_244_;
                        let _e126 = phi_247_;
                        local_6 = _e126;
                        if (_e124.member < _e124.member_1) {
                            phi_245_ = type_12((_e124.member + 1u), _e124.member_1);
                            phi_270_ = type_12(1u, _e124.member);
                        } else {
                            phi_245_ = _e124;
                            phi_270_ = type_12(0u, type_12().member_1);
                        }
                        let _e139 = phi_245_;
                        let _e141 = phi_270_;
                        let _e145 = (bitcast<i32>(_e141.member) != 0i);
                        if _e145 {
                            let _e146 = (2u * _e141.member_1);
                            let _e148 = f32((_e146 - 1u));
                            let _e150 = local_4;
                            let _e153 = f32(((_e150 - _e109) + _e146));
                            phi_248_ = (_e126 * ((_e148 * _e148) / (_e153 * (_e153 - 1f))));
                        } else {
                            phi_248_ = f32();
                        }
                        let _e160 = phi_248_;
                        continue;
                        continuing {
                            phi_244_ = _e139;
                            phi_247_ = _e160;
                            break if !(_e145);
                        }
                    }
                    let _e163 = local_5;
                    phi_294_ = type_12(1u, ((_e163 - _e109) + 1u));
                    phi_297_ = 1f;
                    loop {
                        let _e168 = phi_294_;
                        let _e170 = phi_297_;
                        local_7 = _e170;
                        if (_e168.member < _e168.member_1) {
                            phi_295_ = type_12((_e168.member + 1u), _e168.member_1);
                            phi_320_ = type_12(1u, _e168.member);
                        } else {
                            phi_295_ = _e168;
                            phi_320_ = type_12(0u, type_12().member_1);
                        }
                        let _e183 = phi_295_;
                        let _e185 = phi_320_;
                        let _e189 = (bitcast<i32>(_e185.member) != 0i);
                        if _e189 {
                            phi_298_ = (_e170 * f32(_e185.member_1));
                        } else {
                            phi_298_ = f32();
                        }
                        let _e193 = phi_298_;
                        continue;
                        continuing {
                            phi_294_ = _e183;
                            phi_297_ = _e193;
                            break if !(_e189);
                        }
                    }
                    let _e196 = local_6;
                    let _e199 = local_7;
                    phi_332_ = (sqrt(_e196) / _e199);
                } else {
                    phi_332_ = 0f;
                }
                let _e202 = phi_332_;
                let _e203 = (_e87 + 1u);
                phi_335_ = 0u;
                loop {
                    let _e205 = phi_335_;
                    local_8 = _e205;
                    local_10 = _e205;
                    local_11 = _e205;
                    local_12 = _e205;
                    local_13 = _e205;
                    local_34 = _e205;
                    let _e206 = (_e205 + 1u);
                    local_9 = _e206;
                    if ((_e206 * _e206) <= _e203) {
                        let _e209 = (_e205 < 9u);
                        phi_336_ = select(u32(), _e206, _e209);
                        phi_353_ = _e209;
                    } else {
                        phi_336_ = u32();
                        phi_353_ = false;
                    }
                    let _e212 = phi_336_;
                    let _e214 = phi_353_;
                    continue;
                    continuing {
                        phi_335_ = _e212;
                        break if !(_e214);
                    }
                }
                let _e217 = local_8;
                let _e219 = local_9;
                let _e220 = (_e217 * _e219);
                let _e221 = (_e203 < _e220);
                if _e221 {
                    phi_366_ = (_e220 - _e203);
                } else {
                    phi_366_ = (_e203 - _e220);
                }
                let _e225 = phi_366_;
                let _e227 = local_10;
                if (_e227 <= _e43) {
                    let _e230 = local_11;
                    phi_385_ = type_12(1u, (_e225 + 1u));
                    phi_388_ = (f32(((2u * _e230) + 1u)) / select(6.2831855f, 12.566371f, (_e225 == 0u)));
                    loop {
                        let _e240 = phi_385_;
                        let _e242 = phi_388_;
                        local_14 = _e242;
                        if (_e240.member < _e240.member_1) {
                            phi_386_ = type_12((_e240.member + 1u), _e240.member_1);
                            phi_411_ = type_12(1u, _e240.member);
                        } else {
                            phi_386_ = _e240;
                            phi_411_ = type_12(0u, type_12().member_1);
                        }
                        let _e255 = phi_386_;
                        let _e257 = phi_411_;
                        let _e261 = (bitcast<i32>(_e257.member) != 0i);
                        if _e261 {
                            let _e262 = (2u * _e257.member_1);
                            let _e264 = f32((_e262 - 1u));
                            let _e266 = local_12;
                            let _e269 = f32(((_e266 - _e225) + _e262));
                            phi_389_ = (_e242 * ((_e264 * _e264) / (_e269 * (_e269 - 1f))));
                        } else {
                            phi_389_ = f32();
                        }
                        let _e276 = phi_389_;
                        continue;
                        continuing {
                            phi_385_ = _e255;
                            phi_388_ = _e276;
                            break if !(_e261);
                        }
                    }
                    let _e279 = local_13;
                    phi_435_ = type_12(1u, ((_e279 - _e225) + 1u));
                    phi_438_ = 1f;
                    loop {
                        let _e284 = phi_435_;
                        let _e286 = phi_438_;
                        local_15 = _e286;
                        if (_e284.member < _e284.member_1) {
                            phi_436_ = type_12((_e284.member + 1u), _e284.member_1);
                            phi_461_ = type_12(1u, _e284.member);
                        } else {
                            phi_436_ = _e284;
                            phi_461_ = type_12(0u, type_12().member_1);
                        }
                        let _e299 = phi_436_;
                        let _e301 = phi_461_;
                        let _e305 = (bitcast<i32>(_e301.member) != 0i);
                        if _e305 {
                            phi_439_ = (_e286 * f32(_e301.member_1));
                        } else {
                            phi_439_ = f32();
                        }
                        let _e309 = phi_439_;
                        continue;
                        continuing {
                            phi_435_ = _e299;
                            phi_438_ = _e309;
                            break if !(_e305);
                        }
                    }
                    let _e312 = local_14;
                    let _e315 = local_15;
                    phi_473_ = (sqrt(_e312) / _e315);
                } else {
                    phi_473_ = 0f;
                }
                let _e318 = phi_473_;
                let _e319 = (_e87 + 2u);
                phi_476_ = 0u;
                loop {
                    let _e321 = phi_476_;
                    local_16 = _e321;
                    local_18 = _e321;
                    local_19 = _e321;
                    local_20 = _e321;
                    local_21 = _e321;
                    local_36 = _e321;
                    let _e322 = (_e321 + 1u);
                    local_17 = _e322;
                    if ((_e322 * _e322) <= _e319) {
                        let _e325 = (_e321 < 9u);
                        phi_477_ = select(u32(), _e322, _e325);
                        phi_494_ = _e325;
                    } else {
                        phi_477_ = u32();
                        phi_494_ = false;
                    }
                    let _e328 = phi_477_;
                    let _e330 = phi_494_;
                    continue;
                    continuing {
                        phi_476_ = _e328;
                        break if !(_e330);
                    }
                }
                let _e333 = local_16;
                let _e335 = local_17;
                let _e336 = (_e333 * _e335);
                let _e337 = (_e319 < _e336);
                if _e337 {
                    phi_507_ = (_e336 - _e319);
                } else {
                    phi_507_ = (_e319 - _e336);
                }
                let _e341 = phi_507_;
                let _e343 = local_18;
                if (_e343 <= _e43) {
                    let _e346 = local_19;
                    phi_526_ = type_12(1u, (_e341 + 1u));
                    phi_529_ = (f32(((2u * _e346) + 1u)) / select(6.2831855f, 12.566371f, (_e341 == 0u)));
                    loop {
                        let _e356 = phi_526_;
                        let _e358 = phi_529_;
                        local_22 = _e358;
                        if (_e356.member < _e356.member_1) {
                            phi_527_ = type_12((_e356.member + 1u), _e356.member_1);
                            phi_552_ = type_12(1u, _e356.member);
                        } else {
                            phi_527_ = _e356;
                            phi_552_ = type_12(0u, type_12().member_1);
                        }
                        let _e371 = phi_527_;
                        let _e373 = phi_552_;
                        let _e377 = (bitcast<i32>(_e373.member) != 0i);
                        if _e377 {
                            let _e378 = (2u * _e373.member_1);
                            let _e380 = f32((_e378 - 1u));
                            let _e382 = local_20;
                            let _e385 = f32(((_e382 - _e341) + _e378));
                            phi_530_ = (_e358 * ((_e380 * _e380) / (_e385 * (_e385 - 1f))));
                        } else {
                            phi_530_ = f32();
                        }
                        let _e392 = phi_530_;
                        continue;
                        continuing {
                            phi_526_ = _e371;
                            phi_529_ = _e392;
                            break if !(_e377);
                        }
                    }
                    let _e395 = local_21;
                    phi_576_ = type_12(1u, ((_e395 - _e341) + 1u));
                    phi_579_ = 1f;
                    loop {
                        let _e400 = phi_576_;
                        let _e402 = phi_579_;
                        local_23 = _e402;
                        if (_e400.member < _e400.member_1) {
                            phi_577_ = type_12((_e400.member + 1u), _e400.member_1);
                            phi_602_ = type_12(1u, _e400.member);
                        } else {
                            phi_577_ = _e400;
                            phi_602_ = type_12(0u, type_12().member_1);
                        }
                        let _e415 = phi_577_;
                        let _e417 = phi_602_;
                        let _e421 = (bitcast<i32>(_e417.member) != 0i);
                        if _e421 {
                            phi_580_ = (_e402 * f32(_e417.member_1));
                        } else {
                            phi_580_ = f32();
                        }
                        let _e425 = phi_580_;
                        continue;
                        continuing {
                            phi_576_ = _e415;
                            phi_579_ = _e425;
                            break if !(_e421);
                        }
                    }
                    let _e428 = local_22;
                    let _e431 = local_23;
                    phi_614_ = (sqrt(_e428) / _e431);
                } else {
                    phi_614_ = 0f;
                }
                let _e434 = phi_614_;
                let _e435 = (_e87 + 3u);
                phi_617_ = 0u;
                loop {
                    let _e437 = phi_617_;
                    local_24 = _e437;
                    local_26 = _e437;
                    local_27 = _e437;
                    local_28 = _e437;
                    local_29 = _e437;
                    local_38 = _e437;
                    let _e438 = (_e437 + 1u);
                    local_25 = _e438;
                    if ((_e438 * _e438) <= _e435) {
                        let _e441 = (_e437 < 9u);
                        phi_618_ = select(u32(), _e438, _e441);
                        phi_635_ = _e441;
                    } else {
                        phi_618_ = u32();
                        phi_635_ = false;
                    }
                    let _e444 = phi_618_;
                    let _e446 = phi_635_;
                    continue;
                    continuing {
                        phi_617_ = _e444;
                        break if !(_e446);
                    }
                }
                let _e449 = local_24;
                let _e451 = local_25;
                let _e452 = (_e449 * _e451);
                let _e453 = (_e435 < _e452);
                if _e453 {
                    phi_648_ = (_e452 - _e435);
                } else {
                    phi_648_ = (_e435 - _e452);
                }
                let _e457 = phi_648_;
                let _e459 = local_26;
                if (_e459 <= _e43) {
                    let _e462 = local_27;
                    phi_667_ = type_12(1u, (_e457 + 1u));
                    phi_670_ = (f32(((2u * _e462) + 1u)) / select(6.2831855f, 12.566371f, (_e457 == 0u)));
                    loop {
                        let _e472 = phi_667_;
                        let _e474 = phi_670_;
                        local_30 = _e474;
                        if (_e472.member < _e472.member_1) {
                            phi_668_ = type_12((_e472.member + 1u), _e472.member_1);
                            phi_693_ = type_12(1u, _e472.member);
                        } else {
                            phi_668_ = _e472;
                            phi_693_ = type_12(0u, type_12().member_1);
                        }
                        let _e487 = phi_668_;
                        let _e489 = phi_693_;
                        let _e493 = (bitcast<i32>(_e489.member) != 0i);
                        if _e493 {
                            let _e494 = (2u * _e489.member_1);
                            let _e496 = f32((_e494 - 1u));
                            let _e498 = local_28;
                            let _e501 = f32(((_e498 - _e457) + _e494));
                            phi_671_ = (_e474 * ((_e496 * _e496) / (_e501 * (_e501 - 1f))));
                        } else {
                            phi_671_ = f32();
                        }
                        let _e508 = phi_671_;
                        continue;
                        continuing {
                            phi_667_ = _e487;
                            phi_670_ = _e508;
                            break if !(_e493);
                        }
                    }
                    let _e511 = local_29;
                    phi_717_ = type_12(1u, ((_e511 - _e457) + 1u));
                    phi_720_ = 1f;
                    loop {
                        let _e516 = phi_717_;
                        let _e518 = phi_720_;
                        local_31 = _e518;
                        if (_e516.member < _e516.member_1) {
                            phi_718_ = type_12((_e516.member + 1u), _e516.member_1);
                            phi_743_ = type_12(1u, _e516.member);
                        } else {
                            phi_718_ = _e516;
                            phi_743_ = type_12(0u, type_12().member_1);
                        }
                        let _e531 = phi_718_;
                        let _e533 = phi_743_;
                        let _e537 = (bitcast<i32>(_e533.member) != 0i);
                        if _e537 {
                            phi_721_ = (_e518 * f32(_e533.member_1));
                        } else {
                            phi_721_ = f32();
                        }
                        let _e541 = phi_721_;
                        continue;
                        continuing {
                            phi_717_ = _e531;
                            phi_720_ = _e541;
                            break if !(_e537);
                        }
                    }
                    let _e544 = local_30;
                    let _e547 = local_31;
                    phi_755_ = (sqrt(_e544) / _e547);
                } else {
                    phi_755_ = 0f;
                }
                let _e550 = phi_755_;
                phi_761_ = type_12(0u, _e80);
                phi_764_ = array<f32, 12>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e553 = phi_761_;
                    let _e555 = phi_764_;
                    local_40 = _e555;
                    local_41 = _e555;
                    local_42 = _e555;
                    local_43 = _e555;
                    local_44 = _e555;
                    local_45 = _e555;
                    local_46 = _e555;
                    local_47 = _e555;
                    local_48 = _e555;
                    local_49 = _e555;
                    local_50 = _e555;
                    local_51 = _e555;
                    if (_e553.member < _e553.member_1) {
                        phi_762_ = type_12((_e553.member + 1u), _e553.member_1);
                        phi_787_ = type_12(1u, _e553.member);
                    } else {
                        phi_762_ = _e553;
                        phi_787_ = type_12(0u, type_12().member_1);
                    }
                    let _e568 = phi_762_;
                    let _e570 = phi_787_;
                    let _e574 = (bitcast<i32>(_e570.member) != 0i);
                    if _e574 {
                        let _e576 = ((((((_e77 / 64u) * _e80) * 192u) + (_e77 % 64u)) + (_e65 - (_e67 * 64u))) + (_e570.member_1 * 192u));
                        let _e579 = directions.member[_e576];
                        let _e580 = (_e576 + 64u);
                        let _e583 = directions.member[_e580];
                        let _e584 = (_e576 + 128u);
                        let _e587 = directions.member[_e584];
                        let _e590 = radiance.member[_e576];
                        let _e593 = radiance.member[_e580];
                        let _e596 = radiance.member[_e584];
                        let _e597 = select(1f, 0f, _e105);
                        if (_e109 == 0u) {
                            phi_826_ = _e597;
                        } else {
                            phi_826_ = select(_e579, _e583, _e105);
                        }
                        let _e601 = phi_826_;
                        let _e602 = (_e579 + _e579);
                        let _e605 = ((_e579 * _e579) + (_e583 * _e583));
                        phi_833_ = type_12(1u, _e109);
                        phi_836_ = _e601;
                        phi_838_ = _e597;
                        loop {
                            let _e608 = phi_833_;
                            let _e610 = phi_836_;
                            let _e612 = phi_838_;
                            local_52 = _e610;
                            local_53 = _e612;
                            if (_e608.member < _e608.member_1) {
                                phi_834_ = type_12((_e608.member + 1u), _e608.member_1);
                                phi_860_ = type_12(1u, _e608.member);
                            } else {
                                phi_834_ = _e608;
                                phi_860_ = type_12(0u, type_12().member_1);
                            }
                            let _e625 = phi_834_;
                            let _e627 = phi_860_;
                            let _e630 = (bitcast<i32>(_e627.member) != 0i);
                            if _e630 {
                                phi_837_ = fma(_e602, _e610, -((_e605 * _e612)));
                            } else {
                                phi_837_ = f32();
                            }
                            let _e635 = phi_837_;
                            continue;
                            continuing {
                                phi_833_ = _e625;
                                phi_836_ = _e635;
                                phi_838_ = _e610;
                                break if !(_e630);
                            }
                        }
                        let _e641 = local_32;
                        phi_875_ = type_12(_e109, _e641);
                        phi_878_ = f32(((2u * _e109) + 1u));
                        phi_880_ = 0f;
                        let _e1181 = local_52;
                        phi_882_ = _e1181;
                        let _e1184 = local_53;
                        phi_884_ = _e1184;
                        loop {
                            let _e644 = phi_875_;
                            let _e646 = phi_878_;
                            let _e648 = phi_880_;
                            let _e650 = phi_882_;
                            let _e652 = phi_884_;
                            local_33 = _e650;
                            if (_e644.member < _e644.member_1) {
                                phi_876_ = type_12((_e644.member + 1u), _e644.member_1);
                                phi_906_ = type_12(1u, _e644.member);
                            } else {
                                phi_876_ = _e644;
                                phi_906_ = type_12(0u, type_12().member_1);
                            }
                            let _e665 = phi_876_;
                            let _e667 = phi_906_;
                            let _e670 = (bitcast<i32>(_e667.member) != 0i);
                            if _e670 {
                                phi_879_ = (_e646 + 2f);
                                phi_881_ = (_e648 + _e646);
                                phi_883_ = fma((_e587 * _e646), _e650, -((_e648 * _e652)));
                            } else {
                                phi_879_ = f32();
                                phi_881_ = f32();
                                phi_883_ = f32();
                            }
                            let _e678 = phi_879_;
                            let _e680 = phi_881_;
                            let _e682 = phi_883_;
                            continue;
                            continuing {
                                phi_875_ = _e665;
                                phi_878_ = _e678;
                                phi_880_ = _e680;
                                phi_882_ = _e682;
                                phi_884_ = _e650;
                                break if !(_e670);
                            }
                        }
                        let _e685 = local_33;
                        let _e686 = (_e685 * _e202);
                        let _e693 = select(1f, 0f, _e221);
                        if (_e225 == 0u) {
                            phi_941_ = _e693;
                        } else {
                            phi_941_ = select(_e579, _e583, _e221);
                        }
                        let _e697 = phi_941_;
                        phi_948_ = type_12(1u, _e225);
                        phi_951_ = _e697;
                        phi_953_ = _e693;
                        loop {
                            let _e700 = phi_948_;
                            let _e702 = phi_951_;
                            let _e704 = phi_953_;
                            local_54 = _e702;
                            local_55 = _e704;
                            if (_e700.member < _e700.member_1) {
                                phi_949_ = type_12((_e700.member + 1u), _e700.member_1);
                                phi_975_ = type_12(1u, _e700.member);
                            } else {
                                phi_949_ = _e700;
                                phi_975_ = type_12(0u, type_12().member_1);
                            }
                            let _e717 = phi_949_;
                            let _e719 = phi_975_;
                            let _e722 = (bitcast<i32>(_e719.member) != 0i);
                            if _e722 {
                                phi_952_ = fma(_e602, _e702, -((_e605 * _e704)));
                            } else {
                                phi_952_ = f32();
                            }
                            let _e727 = phi_952_;
                            continue;
                            continuing {
                                phi_948_ = _e717;
                                phi_951_ = _e727;
                                phi_953_ = _e702;
                                break if !(_e722);
                            }
                        }
                        let _e733 = local_34;
                        phi_990_ = type_12(_e225, _e733);
                        phi_993_ = f32(((2u * _e225) + 1u));
                        phi_995_ = 0f;
                        let _e1204 = local_54;
                        phi_997_ = _e1204;
                        let _e1207 = local_55;
                        phi_999_ = _e1207;
                        loop {
                            let _e736 = phi_990_;
                            let _e738 = phi_993_;
                            let _e740 = phi_995_;
                            let _e742 = phi_997_;
                            let _e744 = phi_999_;
                            local_35 = _e742;
                            if (_e736.member < _e736.member_1) {
                                phi_991_ = type_12((_e736.member + 1u), _e736.member_1);
                                phi_1021_ = type_12(1u, _e736.member);
                            } else {
                                phi_991_ = _e736;
                                phi_1021_ = type_12(0u, type_12().member_1);
                            }
                            let _e757 = phi_991_;
                            let _e759 = phi_1021_;
                            let _e762 = (bitcast<i32>(_e759.member) != 0i);
                            if _e762 {
                                phi_994_ = (_e738 + 2f);
                                phi_996_ = (_e740 + _e738);
                                phi_998_ = fma((_e587 * _e738), _e742, -((_e740 * _e744)));
                            } else {
                                phi_994_ = f32();
                                phi_996_ = f32();
                                phi_998_ = f32();
                            }
                            let _e770 = phi_994_;
                            let _e772 = phi_996_;
                            let _e774 = phi_998_;
                            continue;
                            continuing {
                                phi_990_ = _e757;
                                phi_993_ = _e770;
                                phi_995_ = _e772;
                                phi_997_ = _e774;
                                phi_999_ = _e742;
                                break if !(_e762);
                            }
                        }
                        let _e777 = local_35;
                        let _e778 = (_e777 * _e318);
                        let _e785 = select(1f, 0f, _e337);
                        if (_e341 == 0u) {
                            phi_1056_ = _e785;
                        } else {
                            phi_1056_ = select(_e579, _e583, _e337);
                        }
                        let _e789 = phi_1056_;
                        phi_1063_ = type_12(1u, _e341);
                        phi_1066_ = _e789;
                        phi_1068_ = _e785;
                        loop {
                            let _e792 = phi_1063_;
                            let _e794 = phi_1066_;
                            let _e796 = phi_1068_;
                            local_56 = _e794;
                            local_57 = _e796;
                            if (_e792.member < _e792.member_1) {
                                phi_1064_ = type_12((_e792.member + 1u), _e792.member_1);
                                phi_1090_ = type_12(1u, _e792.member);
                            } else {
                                phi_1064_ = _e792;
                                phi_1090_ = type_12(0u, type_12().member_1);
                            }
                            let _e809 = phi_1064_;
                            let _e811 = phi_1090_;
                            let _e814 = (bitcast<i32>(_e811.member) != 0i);
                            if _e814 {
                                phi_1067_ = fma(_e602, _e794, -((_e605 * _e796)));
                            } else {
                                phi_1067_ = f32();
                            }
                            let _e819 = phi_1067_;
                            continue;
                            continuing {
                                phi_1063_ = _e809;
                                phi_1066_ = _e819;
                                phi_1068_ = _e794;
                                break if !(_e814);
                            }
                        }
                        let _e825 = local_36;
                        phi_1105_ = type_12(_e341, _e825);
                        phi_1108_ = f32(((2u * _e341) + 1u));
                        phi_1110_ = 0f;
                        let _e1227 = local_56;
                        phi_1112_ = _e1227;
                        let _e1230 = local_57;
                        phi_1114_ = _e1230;
                        loop {
                            let _e828 = phi_1105_;
                            let _e830 = phi_1108_;
                            let _e832 = phi_1110_;
                            let _e834 = phi_1112_;
                            let _e836 = phi_1114_;
                            local_37 = _e834;
                            if (_e828.member < _e828.member_1) {
                                phi_1106_ = type_12((_e828.member + 1u), _e828.member_1);
                                phi_1136_ = type_12(1u, _e828.member);
                            } else {
                                phi_1106_ = _e828;
                                phi_1136_ = type_12(0u, type_12().member_1);
                            }
                            let _e849 = phi_1106_;
                            let _e851 = phi_1136_;
                            let _e854 = (bitcast<i32>(_e851.member) != 0i);
                            if _e854 {
                                phi_1109_ = (_e830 + 2f);
                                phi_1111_ = (_e832 + _e830);
                                phi_1113_ = fma((_e587 * _e830), _e834, -((_e832 * _e836)));
                            } else {
                                phi_1109_ = f32();
                                phi_1111_ = f32();
                                phi_1113_ = f32();
                            }
                            let _e862 = phi_1109_;
                            let _e864 = phi_1111_;
                            let _e866 = phi_1113_;
                            continue;
                            continuing {
                                phi_1105_ = _e849;
                                phi_1108_ = _e862;
                                phi_1110_ = _e864;
                                phi_1112_ = _e866;
                                phi_1114_ = _e834;
                                break if !(_e854);
                            }
                        }
                        let _e869 = local_37;
                        let _e870 = (_e869 * _e434);
                        let _e877 = select(1f, 0f, _e453);
                        if (_e457 == 0u) {
                            phi_1171_ = _e877;
                        } else {
                            phi_1171_ = select(_e579, _e583, _e453);
                        }
                        let _e881 = phi_1171_;
                        phi_1178_ = type_12(1u, _e457);
                        phi_1181_ = _e881;
                        phi_1183_ = _e877;
                        loop {
                            let _e884 = phi_1178_;
                            let _e886 = phi_1181_;
                            let _e888 = phi_1183_;
                            local_58 = _e886;
                            local_59 = _e888;
                            if (_e884.member < _e884.member_1) {
                                phi_1179_ = type_12((_e884.member + 1u), _e884.member_1);
                                phi_1205_ = type_12(1u, _e884.member);
                            } else {
                                phi_1179_ = _e884;
                                phi_1205_ = type_12(0u, type_12().member_1);
                            }
                            let _e901 = phi_1179_;
                            let _e903 = phi_1205_;
                            let _e906 = (bitcast<i32>(_e903.member) != 0i);
                            if _e906 {
                                phi_1182_ = fma(_e602, _e886, -((_e605 * _e888)));
                            } else {
                                phi_1182_ = f32();
                            }
                            let _e911 = phi_1182_;
                            continue;
                            continuing {
                                phi_1178_ = _e901;
                                phi_1181_ = _e911;
                                phi_1183_ = _e886;
                                break if !(_e906);
                            }
                        }
                        let _e917 = local_38;
                        phi_1220_ = type_12(_e457, _e917);
                        phi_1223_ = f32(((2u * _e457) + 1u));
                        phi_1225_ = 0f;
                        let _e1250 = local_58;
                        phi_1227_ = _e1250;
                        let _e1253 = local_59;
                        phi_1229_ = _e1253;
                        loop {
                            let _e920 = phi_1220_;
                            let _e922 = phi_1223_;
                            let _e924 = phi_1225_;
                            let _e926 = phi_1227_;
                            let _e928 = phi_1229_;
                            local_39 = _e926;
                            if (_e920.member < _e920.member_1) {
                                phi_1221_ = type_12((_e920.member + 1u), _e920.member_1);
                                phi_1251_ = type_12(1u, _e920.member);
                            } else {
                                phi_1221_ = _e920;
                                phi_1251_ = type_12(0u, type_12().member_1);
                            }
                            let _e941 = phi_1221_;
                            let _e943 = phi_1251_;
                            let _e946 = (bitcast<i32>(_e943.member) != 0i);
                            if _e946 {
                                phi_1224_ = (_e922 + 2f);
                                phi_1226_ = (_e924 + _e922);
                                phi_1228_ = fma((_e587 * _e922), _e926, -((_e924 * _e928)));
                            } else {
                                phi_1224_ = f32();
                                phi_1226_ = f32();
                                phi_1228_ = f32();
                            }
                            let _e954 = phi_1224_;
                            let _e956 = phi_1226_;
                            let _e958 = phi_1228_;
                            continue;
                            continuing {
                                phi_1220_ = _e941;
                                phi_1223_ = _e954;
                                phi_1225_ = _e956;
                                phi_1227_ = _e958;
                                phi_1229_ = _e926;
                                break if !(_e946);
                            }
                        }
                        let _e961 = local_39;
                        let _e962 = (_e961 * _e550);
                        phi_765_ = array<f32, 12>(fma(_e590, _e686, _e555[0]), fma(_e590, _e778, _e555[1]), fma(_e590, _e870, _e555[2]), fma(_e590, _e962, _e555[3]), fma(_e593, _e686, _e555[4]), fma(_e593, _e778, _e555[5]), fma(_e593, _e870, _e555[6]), fma(_e593, _e962, _e555[7]), fma(_e596, _e686, _e555[8]), fma(_e596, _e778, _e555[9]), fma(_e596, _e870, _e555[10]), fma(_e596, _e962, _e555[11]));
                    } else {
                        phi_765_ = array<f32, 12>();
                    }
                    let _e971 = phi_765_;
                    continue;
                    continuing {
                        phi_761_ = _e568;
                        phi_764_ = _e971;
                        break if !(_e574);
                    }
                }
                let _e975 = params.member.member_3;
                let _e977 = local_40;
                let _e981 = local_41;
                let _e985 = local_42;
                let _e989 = local_43;
                let _e993 = local_44;
                let _e997 = local_45;
                let _e1001 = local_46;
                let _e1005 = local_47;
                let _e1009 = local_48;
                let _e1013 = local_49;
                let _e1017 = local_50;
                let _e1021 = local_51;
                coefs.member[_e65] = (_e977[0] * _e975);
                coefs.member[(_e61 + _e65)] = (_e981[1] * _e975);
                coefs.member[((_e60 * 128u) + _e65)] = (_e985[2] * _e975);
                coefs.member[((_e60 * 192u) + _e65)] = (_e989[3] * _e975);
                coefs.member[((_e60 * 256u) + _e65)] = (_e993[4] * _e975);
                coefs.member[((_e60 * 320u) + _e65)] = (_e997[5] * _e975);
                coefs.member[((_e60 * 384u) + _e65)] = (_e1001[6] * _e975);
                coefs.member[((_e60 * 448u) + _e65)] = (_e1005[7] * _e975);
                coefs.member[((_e60 * 512u) + _e65)] = (_e1009[8] * _e975);
                coefs.member[((_e60 * 576u) + _e65)] = (_e1013[9] * _e975);
                coefs.member[((_e60 * 640u) + _e65)] = (_e1017[10] * _e975);
                coefs.member[((_e60 * 704u) + _e65)] = (_e1021[11] * _e975);
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
