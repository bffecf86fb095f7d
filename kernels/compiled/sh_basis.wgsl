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
    var phi_95_: u32;
    var phi_158_: u32;
    var phi_159_: u32;
    var phi_176_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_189_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_208_: type_11;
    var phi_211_: f32;
    var phi_209_: type_11;
    var phi_234_: type_11;
    var local_5: u32;
    var phi_212_: f32;
    var local_6: u32;
    var phi_258_: type_11;
    var phi_261_: f32;
    var phi_259_: type_11;
    var phi_284_: type_11;
    var phi_262_: f32;
    var local_7: f32;
    var local_8: f32;
    var phi_296_: f32;
    var phi_299_: u32;
    var phi_300_: u32;
    var phi_317_: bool;
    var local_9: u32;
    var local_10: u32;
    var phi_330_: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_349_: type_11;
    var phi_352_: f32;
    var phi_350_: type_11;
    var phi_375_: type_11;
    var local_13: u32;
    var phi_353_: f32;
    var local_14: u32;
    var phi_399_: type_11;
    var phi_402_: f32;
    var phi_400_: type_11;
    var phi_425_: type_11;
    var phi_403_: f32;
    var local_15: f32;
    var local_16: f32;
    var phi_437_: f32;
    var phi_440_: u32;
    var phi_441_: u32;
    var phi_458_: bool;
    var local_17: u32;
    var local_18: u32;
    var phi_471_: u32;
    var local_19: u32;
    var local_20: u32;
    var phi_490_: type_11;
    var phi_493_: f32;
    var phi_491_: type_11;
    var phi_516_: type_11;
    var local_21: u32;
    var phi_494_: f32;
    var local_22: u32;
    var phi_540_: type_11;
    var phi_543_: f32;
    var phi_541_: type_11;
    var phi_566_: type_11;
    var phi_544_: f32;
    var local_23: f32;
    var local_24: f32;
    var phi_578_: f32;
    var phi_581_: u32;
    var phi_582_: u32;
    var phi_599_: bool;
    var local_25: u32;
    var local_26: u32;
    var phi_612_: u32;
    var local_27: u32;
    var local_28: u32;
    var phi_631_: type_11;
    var phi_634_: f32;
    var phi_632_: type_11;
    var phi_657_: type_11;
    var local_29: u32;
    var phi_635_: f32;
    var local_30: u32;
    var phi_681_: type_11;
    var phi_684_: f32;
    var phi_682_: type_11;
    var phi_707_: type_11;
    var phi_685_: f32;
    var local_31: f32;
    var local_32: f32;
    var phi_719_: f32;
    var phi_732_: f32;
    var phi_739_: type_11;
    var phi_742_: f32;
    var phi_744_: f32;
    var phi_740_: type_11;
    var phi_766_: type_11;
    var phi_743_: f32;
    var local_33: u32;
    var phi_781_: type_11;
    var phi_784_: f32;
    var phi_786_: f32;
    var phi_788_: f32;
    var phi_790_: f32;
    var phi_782_: type_11;
    var phi_812_: type_11;
    var phi_785_: f32;
    var phi_787_: f32;
    var phi_789_: f32;
    var local_34: f32;
    var phi_839_: f32;
    var phi_846_: type_11;
    var phi_849_: f32;
    var phi_851_: f32;
    var phi_847_: type_11;
    var phi_873_: type_11;
    var phi_850_: f32;
    var local_35: u32;
    var phi_888_: type_11;
    var phi_891_: f32;
    var phi_893_: f32;
    var phi_895_: f32;
    var phi_897_: f32;
    var phi_889_: type_11;
    var phi_919_: type_11;
    var phi_892_: f32;
    var phi_894_: f32;
    var phi_896_: f32;
    var local_36: f32;
    var phi_946_: f32;
    var phi_953_: type_11;
    var phi_956_: f32;
    var phi_958_: f32;
    var phi_954_: type_11;
    var phi_980_: type_11;
    var phi_957_: f32;
    var local_37: u32;
    var phi_995_: type_11;
    var phi_998_: f32;
    var phi_1000_: f32;
    var phi_1002_: f32;
    var phi_1004_: f32;
    var phi_996_: type_11;
    var phi_1026_: type_11;
    var phi_999_: f32;
    var phi_1001_: f32;
    var phi_1003_: f32;
    var local_38: f32;
    var phi_1053_: f32;
    var phi_1060_: type_11;
    var phi_1063_: f32;
    var phi_1065_: f32;
    var phi_1061_: type_11;
    var phi_1087_: type_11;
    var phi_1064_: f32;
    var local_39: u32;
    var phi_1102_: type_11;
    var phi_1105_: f32;
    var phi_1107_: f32;
    var phi_1109_: f32;
    var phi_1111_: f32;
    var phi_1103_: type_11;
    var phi_1133_: type_11;
    var phi_1106_: f32;
    var phi_1108_: f32;
    var phi_1110_: f32;
    var local_40: f32;
    var phi_1156_: type_11;
    var phi_1157_: type_11;
    var phi_1180_: type_11;
    var phi_1209_: bool;
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
            let _e27 = arrayLength((&directions.member));
            let _e32 = params.member.member_2;
            let _e35 = (select(_e32, 9u, (_e32 > 9u)) + 1u);
            let _e36 = (_e35 * _e35);
            let _e37 = (_e36 / 4u);
            if ((_e36 % 4u) > 0u) {
                phi_95_ = (_e37 + 1u);
            } else {
                phi_95_ = _e37;
            }
            let _e42 = phi_95_;
            let _e45 = params.member.member_1;
            let _e46 = (_e42 * _e45);
            let _e50 = (_e25.x + (_e25.y * 2097152u));
            if (_e50 < _e46) {
                if (_e45 == 0u) {
                    break;
                }
                let _e53 = (_e50 / _e45);
                let _e55 = (_e50 - (_e53 * _e45));
                if (_e55 < _e27) {
                } else {
                    break;
                }
                let _e59 = directions.member[_e55];
                let _e60 = (_e45 + _e55);
                if (_e60 < _e27) {
                } else {
                    break;
                }
                let _e64 = directions.member[_e60];
                let _e66 = ((2u * _e45) + _e55);
                if (_e66 < _e27) {
                } else {
                    break;
                }
                let _e70 = directions.member[_e66];
                let _e72 = ((3u * _e45) + _e55);
                if (_e72 < _e27) {
                } else {
                    break;
                }
                let _e76 = directions.member[_e72];
                let _e77 = (_e53 * 4u);
                phi_158_ = 0u;
                loop {
                    let _e79 = phi_158_;
                    local_1 = _e79;
                    local_3 = _e79;
                    local_4 = _e79;
                    local_5 = _e79;
                    local_6 = _e79;
                    local_33 = _e79;
                    let _e80 = (_e79 + 1u);
                    local_2 = _e80;
                    if ((_e80 * _e80) <= _e77) {
                        let _e83 = (_e79 < 9u);
                        phi_159_ = select(u32(), _e80, _e83);
                        phi_176_ = _e83;
                    } else {
                        phi_159_ = u32();
                        phi_176_ = false;
                    }
                    let _e86 = phi_159_;
                    let _e88 = phi_176_;
                    continue;
                    continuing {
                        phi_158_ = _e86;
                        break if !(_e88);
                    }
                }
                let _e91 = local_1;
                let _e93 = local_2;
                let _e94 = (_e91 * _e93);
                let _e95 = (_e77 < _e94);
                if _e95 {
                    phi_189_ = (_e94 - _e77);
                } else {
                    phi_189_ = (_e77 - _e94);
                }
                let _e99 = phi_189_;
                let _e101 = local_3;
                if (_e101 <= _e32) {
                    let _e104 = local_4;
                    phi_208_ = type_11(1u, (_e99 + 1u));
                    phi_211_ = (f32(((2u * _e104) + 1u)) / select(6.2831855f, 12.566371f, (_e99 == 0u)));
                    loop {
                        let _e114 = phi_208_;
                        let _e116 = phi_211_;
                        local_7 = _e116;
                        if (_e114.member < _e114.member_1) {
                            phi_209_ = type_11((_e114.member + 1u), _e114.member_1);
                            phi_234_ = type_11(1u, _e114.member);
                        } else {
                            phi_209_ = _e114;
                            phi_234_ = type_11(0u, type_11().member_1);
                        }
                        let _e129 = phi_209_;
                        let _e131 = phi_234_;
                        let _e135 = (bitcast<i32>(_e131.member) != 0i);
                        if _e135 {
                            let _e136 = (2u * _e131.member_1);
                            let _e138 = f32((_e136 - 1u));
                            let _e140 = local_5;
                            let _e143 = f32(((_e140 - _e99) + _e136));
                            phi_212_ = (_e116 * ((_e138 * _e138) / (_e143 * (_e143 - 1f))));
                        } else {
                            phi_212_ = f32();
                        }
                        let _e150 = phi_212_;
                        continue;
                        continuing {
                            phi_208_ = _e129;
                            phi_211_ = _e150;
                            break if !(_e135);
                        }
                    }
                    let _e153 = local_6;
                    phi_258_ = type_11(1u, ((_e153 - _e99) + 1u));
                    phi_261_ = 1f;
                    loop {
                        let _e158 = phi_258_;
                        let _e160 = phi_261_;
                        local_8 = _e160;
                        if (_e158.member < _e158.member_1) {
                            phi_259_ = type_11((_e158.member + 1u), _e158.member_1);
                            phi_284_ = type_11(1u, _e158.member);
                        } else {
                            phi_259_ = _e158;
                            phi_284_ = type_11(0u, type_11().member_1);
                        }
                        let _e173 = phi_259_;
                        let _e175 = phi_284_;
                        let _e179 = (bitcast<i32>(_e175.member) != 0i);
                        if _e179 {
                            phi_262_ = (_e160 * f32(_e175.member_1));
                        } else {
                            phi_262_ = f32();
                        }
                        let _e183 = phi_262_;
                        continue;
                        continuing {
                            phi_258_ = _e173;
                            phi_261_ = _e183;
                            break if !(_e179);
                        }
                    }
                    let _e186 = local_7;
                    let _e189 = local_8;
                    phi_296_ = (sqrt(_e186) / _e189);
                } else {
                    phi_296_ = 0f;
                }
                let _e192 = phi_296_;
                let _e193 = (_e77 + 1u);
                phi_299_ = 0u;
                loop {
                    let _e195 = phi_299_;
                    local_9 = _e195;
                    local_11 = _e195;
                    local_12 = _e195;
                    local_13 = _e195;
                    local_14 = _e195;
                    local_35 = _e195;
                    let _e196 = (_e195 + 1u);
                    local_10 = _e196;
                    if ((_e196 * _e196) <= _e193) {
                        let _e199 = (_e195 < 9u);
                        phi_300_ = select(u32(), _e196, _e199);
                        phi_317_ = _e199;
                    } else {
                        phi_300_ = u32();
                        phi_317_ = false;
                    }
                    let _e202 = phi_300_;
                    let _e204 = phi_317_;
                    continue;
                    continuing {
                        phi_299_ = _e202;
                        break if !(_e204);
                    }
                }
                let _e207 = local_9;
                let _e209 = local_10;
                let _e210 = (_e207 * _e209);
                let _e211 = (_e193 < _e210);
                if _e211 {
                    phi_330_ = (_e210 - _e193);
                } else {
                    phi_330_ = (_e193 - _e210);
                }
                let _e215 = phi_330_;
                let _e217 = local_11;
                if (_e217 <= _e32) {
                    let _e220 = local_12;
                    phi_349_ = type_11(1u, (_e215 + 1u));
                    phi_352_ = (f32(((2u * _e220) + 1u)) / select(6.2831855f, 12.566371f, (_e215 == 0u)));
                    loop {
                        let _e230 = phi_349_;
                        let _e232 = phi_352_;
                        local_15 = _e232;
                        if (_e230.member < _e230.member_1) {
                            phi_350_ = type_11((_e230.member + 1u), _e230.member_1);
                            phi_375_ = type_11(1u, _e230.member);
                        } else {
                            phi_350_ = _e230;
                            phi_375_ = type_11(0u, type_11().member_1);
                        }
                        let _e245 = phi_350_;
                        let _e247 = phi_375_;
                        let _e251 = (bitcast<i32>(_e247.member) != 0i);
                        if _e251 {
                            let _e252 = (2u * _e247.member_1);
                            let _e254 = f32((_e252 - 1u));
                            let _e256 = local_13;
                            let _e259 = f32(((_e256 - _e215) + _e252));
                            phi_353_ = (_e232 * ((_e254 * _e254) / (_e259 * (_e259 - 1f))));
                        } else {
                            phi_353_ = f32();
                        }
                        let _e266 = phi_353_;
                        continue;
                        continuing {
                            phi_349_ = _e245;
                            phi_352_ = _e266;
                            break if !(_e251);
                        }
                    }
                    let _e269 = local_14;
                    phi_399_ = type_11(1u, ((_e269 - _e215) + 1u));
                    phi_402_ = 1f;
                    loop {
                        let _e274 = phi_399_;
                        let _e276 = phi_402_;
                        local_16 = _e276;
                        if (_e274.member < _e274.member_1) {
                            phi_400_ = type_11((_e274.member + 1u), _e274.member_1);
                            phi_425_ = type_11(1u, _e274.member);
                        } else {
                            phi_400_ = _e274;
                            phi_425_ = type_11(0u, type_11().member_1);
                        }
                        let _e289 = phi_400_;
                        let _e291 = phi_425_;
                        let _e295 = (bitcast<i32>(_e291.member) != 0i);
                        if _e295 {
                            phi_403_ = (_e276 * f32(_e291.member_1));
                        } else {
                            phi_403_ = f32();
                        }
                        let _e299 = phi_403_;
                        continue;
                        continuing {
                            phi_399_ = _e289;
                            phi_402_ = _e299;
                            break if !(_e295);
                        }
                    }
                    let _e302 = local_15;
                    let _e305 = local_16;
                    phi_437_ = (sqrt(_e302) / _e305);
                } else {
                    phi_437_ = 0f;
                }
                let _e308 = phi_437_;
                let _e309 = (_e77 + 2u);
                phi_440_ = 0u;
                loop {
                    let _e311 = phi_440_;
                    local_17 = _e311;
                    local_19 = _e311;
                    local_20 = _e311;
                    local_21 = _e311;
                    local_22 = _e311;
                    local_37 = _e311;
                    let _e312 = (_e311 + 1u);
                    local_18 = _e312;
                    if ((_e312 * _e312) <= _e309) {
                        let _e315 = (_e311 < 9u);
                        phi_441_ = select(u32(), _e312, _e315);
                        phi_458_ = _e315;
                    } else {
                        phi_441_ = u32();
                        phi_458_ = false;
                    }
                    let _e318 = phi_441_;
                    let _e320 = phi_458_;
                    continue;
                    continuing {
                        phi_440_ = _e318;
                        break if !(_e320);
                    }
                }
                let _e323 = local_17;
                let _e325 = local_18;
                let _e326 = (_e323 * _e325);
                let _e327 = (_e309 < _e326);
                if _e327 {
                    phi_471_ = (_e326 - _e309);
                } else {
                    phi_471_ = (_e309 - _e326);
                }
                let _e331 = phi_471_;
                let _e333 = local_19;
                if (_e333 <= _e32) {
                    let _e336 = local_20;
                    phi_490_ = type_11(1u, (_e331 + 1u));
                    phi_493_ = (f32(((2u * _e336) + 1u)) / select(6.2831855f, 12.566371f, (_e331 == 0u)));
                    loop {
                        let _e346 = phi_490_;
                        let _e348 = phi_493_;
                        local_23 = _e348;
                        if (_e346.member < _e346.member_1) {
                            phi_491_ = type_11((_e346.member + 1u), _e346.member_1);
                            phi_516_ = type_11(1u, _e346.member);
                        } else {
                            phi_491_ = _e346;
                            phi_516_ = type_11(0u, type_11().member_1);
                        }
                        let _e361 = phi_491_;
                        let _e363 = phi_516_;
                        let _e367 = (bitcast<i32>(_e363.member) != 0i);
                        if _e367 {
                            let _e368 = (2u * _e363.member_1);
                            let _e370 = f32((_e368 - 1u));
                            let _e372 = local_21;
                            let _e375 = f32(((_e372 - _e331) + _e368));
                            phi_494_ = (_e348 * ((_e370 * _e370) / (_e375 * (_e375 - 1f))));
                        } else {
                            phi_494_ = f32();
                        }
                        let _e382 = phi_494_;
                        continue;
                        continuing {
                            phi_490_ = _e361;
                            phi_493_ = _e382;
                            break if !(_e367);
                        }
                    }
                    let _e385 = local_22;
                    phi_540_ = type_11(1u, ((_e385 - _e331) + 1u));
                    phi_543_ = 1f;
                    loop {
                        let _e390 = phi_540_;
                        let _e392 = phi_543_;
                        local_24 = _e392;
                        if (_e390.member < _e390.member_1) {
                            phi_541_ = type_11((_e390.member + 1u), _e390.member_1);
                            phi_566_ = type_11(1u, _e390.member);
                        } else {
                            phi_541_ = _e390;
                            phi_566_ = type_11(0u, type_11().member_1);
                        }
                        let _e405 = phi_541_;
                        let _e407 = phi_566_;
                        let _e411 = (bitcast<i32>(_e407.member) != 0i);
                        if _e411 {
                            phi_544_ = (_e392 * f32(_e407.member_1));
                        } else {
                            phi_544_ = f32();
                        }
                        let _e415 = phi_544_;
                        continue;
                        continuing {
                            phi_540_ = _e405;
                            phi_543_ = _e415;
                            break if !(_e411);
                        }
                    }
                    let _e418 = local_23;
                    let _e421 = local_24;
                    phi_578_ = (sqrt(_e418) / _e421);
                } else {
                    phi_578_ = 0f;
                }
                let _e424 = phi_578_;
                let _e425 = (_e77 + 3u);
                phi_581_ = 0u;
                loop {
                    let _e427 = phi_581_;
                    local_25 = _e427;
                    local_27 = _e427;
                    local_28 = _e427;
                    local_29 = _e427;
                    local_30 = _e427;
                    local_39 = _e427;
                    let _e428 = (_e427 + 1u);
                    local_26 = _e428;
                    if ((_e428 * _e428) <= _e425) {
                        let _e431 = (_e427 < 9u);
                        phi_582_ = select(u32(), _e428, _e431);
                        phi_599_ = _e431;
                    } else {
                        phi_582_ = u32();
                        phi_599_ = false;
                    }
                    let _e434 = phi_582_;
                    let _e436 = phi_599_;
                    continue;
                    continuing {
                        phi_581_ = _e434;
                        break if !(_e436);
                    }
                }
                let _e439 = local_25;
                let _e441 = local_26;
                let _e442 = (_e439 * _e441);
                let _e443 = (_e425 < _e442);
                if _e443 {
                    phi_612_ = (_e442 - _e425);
                } else {
                    phi_612_ = (_e425 - _e442);
                }
                let _e447 = phi_612_;
                let _e449 = local_27;
                if (_e449 <= _e32) {
                    let _e452 = local_28;
                    phi_631_ = type_11(1u, (_e447 + 1u));
                    phi_634_ = (f32(((2u * _e452) + 1u)) / select(6.2831855f, 12.566371f, (_e447 == 0u)));
                    loop {
                        let _e462 = phi_631_;
                        let _e464 = phi_634_;
                        local_31 = _e464;
                        if (_e462.member < _e462.member_1) {
                            phi_632_ = type_11((_e462.member + 1u), _e462.member_1);
                            phi_657_ = type_11(1u, _e462.member);
                        } else {
                            phi_632_ = _e462;
                            phi_657_ = type_11(0u, type_11().member_1);
                        }
                        let _e477 = phi_632_;
                        let _e479 = phi_657_;
                        let _e483 = (bitcast<i32>(_e479.member) != 0i);
                        if _e483 {
                            let _e484 = (2u * _e479.member_1);
                            let _e486 = f32((_e484 - 1u));
                            let _e488 = local_29;
                            let _e491 = f32(((_e488 - _e447) + _e484));
                            phi_635_ = (_e464 * ((_e486 * _e486) / (_e491 * (_e491 - 1f))));
                        } else {
                            phi_635_ = f32();
                        }
                        let _e498 = phi_635_;
                        continue;
                        continuing {
                            phi_631_ = _e477;
                            phi_634_ = _e498;
                            break if !(_e483);
                        }
                    }
                    let _e501 = local_30;
                    phi_681_ = type_11(1u, ((_e501 - _e447) + 1u));
                    phi_684_ = 1f;
                    loop {
                        let _e506 = phi_681_;
                        let _e508 = phi_684_;
                        local_32 = _e508;
                        if (_e506.member < _e506.member_1) {
                            phi_682_ = type_11((_e506.member + 1u), _e506.member_1);
                            phi_707_ = type_11(1u, _e506.member);
                        } else {
                            phi_682_ = _e506;
                            phi_707_ = type_11(0u, type_11().member_1);
                        }
                        let _e521 = phi_682_;
                        let _e523 = phi_707_;
                        let _e527 = (bitcast<i32>(_e523.member) != 0i);
                        if _e527 {
                            phi_685_ = (_e508 * f32(_e523.member_1));
                        } else {
                            phi_685_ = f32();
                        }
                        let _e531 = phi_685_;
                        continue;
                        continuing {
                            phi_681_ = _e521;
                            phi_684_ = _e531;
                            break if !(_e527);
                        }
                    }
                    let _e534 = local_31;
                    let _e537 = local_32;
                    phi_719_ = (sqrt(_e534) / _e537);
                } else {
                    phi_719_ = 0f;
                }
                let _e540 = phi_719_;
                let _e541 = select(1f, 0f, _e95);
                if (_e99 == 0u) {
                    phi_732_ = _e541;
                } else {
                    phi_732_ = select(_e59, _e64, _e95);
                }
                let _e545 = phi_732_;
                let _e546 = (_e59 + _e59);
                let _e549 = ((_e59 * _e59) + (_e64 * _e64));
                phi_739_ = type_11(1u, _e99);
                phi_742_ = _e545;
                phi_744_ = _e541;
                loop {
                    let _e552 = phi_739_;
                    let _e554 = phi_742_;
                    let _e556 = phi_744_;
                    local_41 = _e554;
                    local_42 = _e556;
                    if (_e552.member < _e552.member_1) {
                        phi_740_ = type_11((_e552.member + 1u), _e552.member_1);
                        phi_766_ = type_11(1u, _e552.member);
                    } else {
                        phi_740_ = _e552;
                        phi_766_ = type_11(0u, type_11().member_1);
                    }
                    let _e569 = phi_740_;
                    let _e571 = phi_766_;
                    let _e574 = (bitcast<i32>(_e571.member) != 0i);
                    if _e574 {
                        phi_743_ = ((_e546 * _e554) - (_e549 * _e556));
                    } else {
                        phi_743_ = f32();
                    }
                    let _e579 = phi_743_;
                    continue;
                    continuing {
                        phi_739_ = _e569;
                        phi_742_ = _e579;
                        phi_744_ = _e554;
                        break if !(_e574);
                    }
                }
                let _e585 = local_33;
                phi_781_ = type_11(_e99, _e585);
                let _e1030 = local_41;
                phi_784_ = _e1030;
                phi_786_ = f32(((2u * _e99) + 1u));
                phi_788_ = 0f;
                let _e1035 = local_42;
                phi_790_ = _e1035;
                loop {
                    let _e588 = phi_781_;
                    let _e590 = phi_784_;
                    let _e592 = phi_786_;
                    let _e594 = phi_788_;
                    let _e596 = phi_790_;
                    local_34 = _e590;
                    if (_e588.member < _e588.member_1) {
                        phi_782_ = type_11((_e588.member + 1u), _e588.member_1);
                        phi_812_ = type_11(1u, _e588.member);
                    } else {
                        phi_782_ = _e588;
                        phi_812_ = type_11(0u, type_11().member_1);
                    }
                    let _e609 = phi_782_;
                    let _e611 = phi_812_;
                    let _e614 = (bitcast<i32>(_e611.member) != 0i);
                    if _e614 {
                        phi_785_ = (((_e70 * _e592) * _e590) - (_e594 * _e596));
                        phi_787_ = (_e592 + 2f);
                        phi_789_ = (_e594 + _e592);
                    } else {
                        phi_785_ = f32();
                        phi_787_ = f32();
                        phi_789_ = f32();
                    }
                    let _e622 = phi_785_;
                    let _e624 = phi_787_;
                    let _e626 = phi_789_;
                    continue;
                    continuing {
                        phi_781_ = _e609;
                        phi_784_ = _e622;
                        phi_786_ = _e624;
                        phi_788_ = _e626;
                        phi_790_ = _e590;
                        break if !(_e614);
                    }
                }
                let _e629 = local_34;
                let _e632 = select(1f, 0f, _e211);
                if (_e215 == 0u) {
                    phi_839_ = _e632;
                } else {
                    phi_839_ = select(_e59, _e64, _e211);
                }
                let _e636 = phi_839_;
                phi_846_ = type_11(1u, _e215);
                phi_849_ = _e636;
                phi_851_ = _e632;
                loop {
                    let _e639 = phi_846_;
                    let _e641 = phi_849_;
                    let _e643 = phi_851_;
                    local_43 = _e641;
                    local_44 = _e643;
                    if (_e639.member < _e639.member_1) {
                        phi_847_ = type_11((_e639.member + 1u), _e639.member_1);
                        phi_873_ = type_11(1u, _e639.member);
                    } else {
                        phi_847_ = _e639;
                        phi_873_ = type_11(0u, type_11().member_1);
                    }
                    let _e656 = phi_847_;
                    let _e658 = phi_873_;
                    let _e661 = (bitcast<i32>(_e658.member) != 0i);
                    if _e661 {
                        phi_850_ = ((_e546 * _e641) - (_e549 * _e643));
                    } else {
                        phi_850_ = f32();
                    }
                    let _e666 = phi_850_;
                    continue;
                    continuing {
                        phi_846_ = _e656;
                        phi_849_ = _e666;
                        phi_851_ = _e641;
                        break if !(_e661);
                    }
                }
                let _e672 = local_35;
                phi_888_ = type_11(_e215, _e672);
                let _e1053 = local_43;
                phi_891_ = _e1053;
                phi_893_ = f32(((2u * _e215) + 1u));
                phi_895_ = 0f;
                let _e1058 = local_44;
                phi_897_ = _e1058;
                loop {
                    let _e675 = phi_888_;
                    let _e677 = phi_891_;
                    let _e679 = phi_893_;
                    let _e681 = phi_895_;
                    let _e683 = phi_897_;
                    local_36 = _e677;
                    if (_e675.member < _e675.member_1) {
                        phi_889_ = type_11((_e675.member + 1u), _e675.member_1);
                        phi_919_ = type_11(1u, _e675.member);
                    } else {
                        phi_889_ = _e675;
                        phi_919_ = type_11(0u, type_11().member_1);
                    }
                    let _e696 = phi_889_;
                    let _e698 = phi_919_;
                    let _e701 = (bitcast<i32>(_e698.member) != 0i);
                    if _e701 {
                        phi_892_ = (((_e70 * _e679) * _e677) - (_e681 * _e683));
                        phi_894_ = (_e679 + 2f);
                        phi_896_ = (_e681 + _e679);
                    } else {
                        phi_892_ = f32();
                        phi_894_ = f32();
                        phi_896_ = f32();
                    }
                    let _e709 = phi_892_;
                    let _e711 = phi_894_;
                    let _e713 = phi_896_;
                    continue;
                    continuing {
                        phi_888_ = _e696;
                        phi_891_ = _e709;
                        phi_893_ = _e711;
                        phi_895_ = _e713;
                        phi_897_ = _e677;
                        break if !(_e701);
                    }
                }
                let _e716 = local_36;
                let _e719 = select(1f, 0f, _e327);
                if (_e331 == 0u) {
                    phi_946_ = _e719;
                } else {
                    phi_946_ = select(_e59, _e64, _e327);
                }
                let _e723 = phi_946_;
                phi_953_ = type_11(1u, _e331);
                phi_956_ = _e723;
                phi_958_ = _e719;
                loop {
                    let _e726 = phi_953_;
                    let _e728 = phi_956_;
                    let _e730 = phi_958_;
                    local_45 = _e728;
                    local_46 = _e730;
                    if (_e726.member < _e726.member_1) {
                        phi_954_ = type_11((_e726.member + 1u), _e726.member_1);
                        phi_980_ = type_11(1u, _e726.member);
                    } else {
                        phi_954_ = _e726;
                        phi_980_ = type_11(0u, type_11().member_1);
                    }
                    let _e743 = phi_954_;
                    let _e745 = phi_980_;
                    let _e748 = (bitcast<i32>(_e745.member) != 0i);
                    if _e748 {
                        phi_957_ = ((_e546 * _e728) - (_e549 * _e730));
                    } else {
                        phi_957_ = f32();
                    }
                    let _e753 = phi_957_;
                    continue;
                    continuing {
                        phi_953_ = _e743;
                        phi_956_ = _e753;
                        phi_958_ = _e728;
                        break if !(_e748);
                    }
                }
                let _e759 = local_37;
                phi_995_ = type_11(_e331, _e759);
                let _e1076 = local_45;
                phi_998_ = _e1076;
                phi_1000_ = f32(((2u * _e331) + 1u));
                phi_1002_ = 0f;
                let _e1081 = local_46;
                phi_1004_ = _e1081;
                loop {
                    let _e762 = phi_995_;
                    let _e764 = phi_998_;
                    let _e766 = phi_1000_;
                    let _e768 = phi_1002_;
                    let _e770 = phi_1004_;
                    local_38 = _e764;
                    if (_e762.member < _e762.member_1) {
                        phi_996_ = type_11((_e762.member + 1u), _e762.member_1);
                        phi_1026_ = type_11(1u, _e762.member);
                    } else {
                        phi_996_ = _e762;
                        phi_1026_ = type_11(0u, type_11().member_1);
                    }
                    let _e783 = phi_996_;
                    let _e785 = phi_1026_;
                    let _e788 = (bitcast<i32>(_e785.member) != 0i);
                    if _e788 {
                        phi_999_ = (((_e70 * _e766) * _e764) - (_e768 * _e770));
                        phi_1001_ = (_e766 + 2f);
                        phi_1003_ = (_e768 + _e766);
                    } else {
                        phi_999_ = f32();
                        phi_1001_ = f32();
                        phi_1003_ = f32();
                    }
                    let _e796 = phi_999_;
                    let _e798 = phi_1001_;
                    let _e800 = phi_1003_;
                    continue;
                    continuing {
                        phi_995_ = _e783;
                        phi_998_ = _e796;
                        phi_1000_ = _e798;
                        phi_1002_ = _e800;
                        phi_1004_ = _e764;
                        break if !(_e788);
                    }
                }
                let _e803 = local_38;
                let _e806 = select(1f, 0f, _e443);
                if (_e447 == 0u) {
                    phi_1053_ = _e806;
                } else {
                    phi_1053_ = select(_e59, _e64, _e443);
                }
                let _e810 = phi_1053_;
                phi_1060_ = type_11(1u, _e447);
                phi_1063_ = _e810;
                phi_1065_ = _e806;
                loop {
                    let _e813 = phi_1060_;
                    let _e815 = phi_1063_;
                    let _e817 = phi_1065_;
                    local_47 = _e815;
                    local_48 = _e817;
                    if (_e813.member < _e813.member_1) {
                        phi_1061_ = type_11((_e813.member + 1u), _e813.member_1);
                        phi_1087_ = type_11(1u, _e813.member);
                    } else {
                        phi_1061_ = _e813;
                        phi_1087_ = type_11(0u, type_11().member_1);
                    }
                    let _e830 = phi_1061_;
                    let _e832 = phi_1087_;
                    let _e835 = (bitcast<i32>(_e832.member) != 0i);
                    if _e835 {
                        phi_1064_ = ((_e546 * _e815) - (_e549 * _e817));
                    } else {
                        phi_1064_ = f32();
                    }
                    let _e840 = phi_1064_;
                    continue;
                    continuing {
                        phi_1060_ = _e830;
                        phi_1063_ = _e840;
                        phi_1065_ = _e815;
                        break if !(_e835);
                    }
                }
                let _e846 = local_39;
                phi_1102_ = type_11(_e447, _e846);
                let _e1099 = local_47;
                phi_1105_ = _e1099;
                phi_1107_ = f32(((2u * _e447) + 1u));
                phi_1109_ = 0f;
                let _e1104 = local_48;
                phi_1111_ = _e1104;
                loop {
                    let _e849 = phi_1102_;
                    let _e851 = phi_1105_;
                    let _e853 = phi_1107_;
                    let _e855 = phi_1109_;
                    let _e857 = phi_1111_;
                    local_40 = _e851;
                    if (_e849.member < _e849.member_1) {
                        phi_1103_ = type_11((_e849.member + 1u), _e849.member_1);
                        phi_1133_ = type_11(1u, _e849.member);
                    } else {
                        phi_1103_ = _e849;
                        phi_1133_ = type_11(0u, type_11().member_1);
                    }
                    let _e870 = phi_1103_;
                    let _e872 = phi_1133_;
                    let _e875 = (bitcast<i32>(_e872.member) != 0i);
                    if _e875 {
                        phi_1106_ = (((_e70 * _e853) * _e851) - (_e855 * _e857));
                        phi_1108_ = (_e853 + 2f);
                        phi_1110_ = (_e855 + _e853);
                    } else {
                        phi_1106_ = f32();
                        phi_1108_ = f32();
                        phi_1110_ = f32();
                    }
                    let _e883 = phi_1106_;
                    let _e885 = phi_1108_;
                    let _e887 = phi_1110_;
                    continue;
                    continuing {
                        phi_1102_ = _e870;
                        phi_1105_ = _e883;
                        phi_1107_ = _e885;
                        phi_1109_ = _e887;
                        phi_1111_ = _e851;
                        break if !(_e875);
                    }
                }
                let _e890 = local_40;
                local = array<f32, 4>((_e76 * (_e629 * _e192)), (_e76 * (_e716 * _e308)), (_e76 * (_e803 * _e424)), (_e76 * (_e890 * _e540)));
                phi_1156_ = type_11(0u, 4u);
                loop {
                    let _e895 = phi_1156_;
                    if (_e895.member < _e895.member_1) {
                        phi_1157_ = type_11((_e895.member + 1u), _e895.member_1);
                        phi_1180_ = type_11(1u, _e895.member);
                    } else {
                        phi_1157_ = _e895;
                        phi_1180_ = type_11(0u, type_11().member_1);
                    }
                    let _e908 = phi_1157_;
                    let _e910 = phi_1180_;
                    let _e914 = (bitcast<i32>(_e910.member) != 0i);
                    if _e914 {
                        if (_e910.member_1 < 4u) {
                        } else {
                            phi_1209_ = true;
                            break;
                        }
                        let _e917 = local[_e910.member_1];
                        let _e919 = ((_e910.member_1 * _e46) + _e50);
                        if (_e919 < arrayLength((&table.member))) {
                        } else {
                            phi_1209_ = true;
                            break;
                        }
                        table.member[_e919] = _e917;
                    }
                    continue;
                    continuing {
                        phi_1156_ = _e908;
                        phi_1209_ = false;
                        break if !(_e914);
                    }
                }
                let _e925 = phi_1209_;
                if _e925 {
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
