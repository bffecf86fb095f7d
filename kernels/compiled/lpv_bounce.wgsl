struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<i32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
    member_4: vec4<f32>,
    member_5: u32,
    member_6: f32,
    member_7: f32,
    member_8: f32,
    member_9: f32,
    member_10: f32,
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: f32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: vec4<f32>,
}

struct type_30 {
    member: type_29,
}

struct type_37 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_30;
@group(0) @binding(1) 
var<storage> facets: type_23;
@group(0) @binding(2) 
var<storage> coefs: type_5;
@group(0) @binding(3) 
var<storage, read_write> words: type_37;

fn function_() {
    var phi_148_: vec3<f32>;
    var phi_155_: vec3<f32>;
    var phi_371_: type_15;
    var phi_374_: f32;
    var phi_376_: array<array<f32, 6>, 3>;
    var phi_372_: type_15;
    var phi_399_: type_15;
    var phi_429_: f32;
    var phi_434_: f32;
    var phi_440_: f32;
    var phi_775_: f32;
    var phi_776_: array<array<f32, 6>, 3>;
    var phi_375_: f32;
    var phi_377_: array<array<f32, 6>, 3>;
    var phi_4997_: bool;
    var local: f32;
    var local_1: f32;
    var phi_782_: f32;
    var local_2: array<array<f32, 6>, 3>;
    var local_3: array<array<f32, 6>, 3>;
    var local_4: array<array<f32, 6>, 3>;
    var local_5: array<array<f32, 6>, 3>;
    var local_6: array<array<f32, 6>, 3>;
    var local_7: array<array<f32, 6>, 3>;
    var local_8: array<array<f32, 6>, 3>;
    var local_9: array<array<f32, 6>, 3>;
    var local_10: array<array<f32, 6>, 3>;
    var local_11: array<array<f32, 6>, 3>;
    var local_12: array<array<f32, 6>, 3>;
    var local_13: array<array<f32, 6>, 3>;
    var local_14: array<array<f32, 6>, 3>;
    var local_15: array<array<f32, 6>, 3>;
    var local_16: array<array<f32, 6>, 3>;
    var local_17: array<array<f32, 6>, 3>;
    var local_18: array<array<f32, 6>, 3>;
    var local_19: array<array<f32, 6>, 3>;
    var phi_3176_: bool;
    var phi_3178_: bool;
    var phi_3179_: bool;
    var phi_3180_: bool;
    var phi_3181_: bool;
    var phi_3182_: bool;
    var phi_3183_: bool;
    var phi_3184_: bool;
    var phi_3185_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e54 = gid_1;
            let _e58 = arrayLength((&coefs.member));
            let _e60 = arrayLength((&words.member));
            let _e64 = (_e54.x + (_e54.y * 2097152u));
            let _e67 = params.member.member_5;
            if (_e64 < _e67) {
                let _e69 = (_e64 / 2u);
                if (_e69 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e74 = facets.member[_e69].member_2;
                let _e83 = sqrt((((_e74[0] * _e74[0]) + (_e74[1] * _e74[1])) + (_e74[2] * _e74[2])));
                if (_e83 > 0.000000000001f) {
                    phi_148_ = vec3<f32>((_e74[0] / _e83), (_e74[1] / _e83), (_e74[2] / _e83));
                } else {
                    phi_148_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e90 = phi_148_;
                if ((_e64 & 1u) == 0u) {
                    phi_155_ = _e90;
                } else {
                    phi_155_ = -(_e90);
                }
                let _e95 = phi_155_;
                let _e98 = params.member.member;
                let _e101 = params.member.member_1;
                let _e104 = params.member.member_2;
                let _e108 = facets.member[_e69].member;
                let _e113 = (_e104.x + 1u);
                let _e116 = ((_e104.y + 1u) * _e113);
                let _e117 = (_e116 + _e113);
                let _e121 = (_e117 + ((_e104.z + 1u) * _e116));
                let _e129 = ((_e108[0] - _e98.x) / _e98.w);
                let _e130 = ((_e108[1] - _e98.y) / _e98.w);
                let _e131 = ((_e108[2] - _e98.z) / _e98.w);
                let _e138 = (_e129 + (_e95.x * 0.5f));
                let _e139 = (_e130 + (_e95.y * 0.5f));
                let _e140 = (_e131 + (_e95.z * 0.5f));
                let _e144 = (_e138 - 0.5f);
                let _e145 = floor(_e144);
                let _e146 = bitcast<i32>(_e104.x);
                let _e147 = (_e146 - 1i);
                let _e155 = (select(0i, select(select(i32(_e145), i32(-2147483648), (_e145 < -2147483600f)), 2147483647i, (_e145 > 2147483500f)), (_e145 == _e145)) - _e101.x);
                let _e157 = select(0i, _e155, (0i < _e155));
                let _e159 = select(_e157, _e147, (_e147 < _e157));
                let _e160 = (_e155 + 1i);
                let _e162 = select(0i, _e160, (0i < _e160));
                let _e164 = select(_e162, _e147, (_e147 < _e162));
                let _e167 = (_e144 - _e145);
                let _e174 = (_e139 - 0.5f);
                let _e175 = floor(_e174);
                let _e176 = bitcast<i32>(_e104.y);
                let _e177 = (_e176 - 1i);
                let _e185 = (select(0i, select(select(i32(_e175), i32(-2147483648), (_e175 < -2147483600f)), 2147483647i, (_e175 > 2147483500f)), (_e175 == _e175)) - _e101.y);
                let _e187 = select(0i, _e185, (0i < _e185));
                let _e189 = select(_e187, _e177, (_e177 < _e187));
                let _e190 = (_e185 + 1i);
                let _e192 = select(0i, _e190, (0i < _e190));
                let _e194 = select(_e192, _e177, (_e177 < _e192));
                let _e197 = (_e174 - _e175);
                let _e204 = (_e140 - 0.5f);
                let _e205 = floor(_e204);
                let _e206 = bitcast<i32>(_e104.z);
                let _e207 = (_e206 - 1i);
                let _e215 = (select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < -2147483600f)), 2147483647i, (_e205 > 2147483500f)), (_e205 == _e205)) - _e101.z);
                let _e217 = select(0i, _e215, (0i < _e215));
                let _e219 = select(_e217, _e207, (_e207 < _e217));
                let _e220 = (_e215 + 1i);
                let _e222 = select(0i, _e220, (0i < _e220));
                let _e224 = select(_e222, _e207, (_e207 < _e222));
                let _e227 = (_e204 - _e205);
                phi_371_ = type_15(0u, 8u);
                phi_374_ = 0f;
                phi_376_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                loop {
                    let _e235 = phi_371_;
                    let _e237 = phi_374_;
                    let _e239 = phi_376_;
                    local = _e237;
                    local_1 = _e237;
                    local_2 = _e239;
                    local_3 = _e239;
                    local_4 = _e239;
                    local_5 = _e239;
                    local_6 = _e239;
                    local_7 = _e239;
                    local_8 = _e239;
                    local_9 = _e239;
                    local_10 = _e239;
                    local_11 = _e239;
                    local_12 = _e239;
                    local_13 = _e239;
                    local_14 = _e239;
                    local_15 = _e239;
                    local_16 = _e239;
                    local_17 = _e239;
                    local_18 = _e239;
                    local_19 = _e239;
                    if (_e235.member < _e235.member_1) {
                        phi_372_ = type_15((_e235.member + 1u), _e235.member_1);
                        phi_399_ = type_15(1u, _e235.member);
                    } else {
                        phi_372_ = _e235;
                        phi_399_ = type_15(0u, type_15().member_1);
                    }
                    let _e252 = phi_372_;
                    let _e254 = phi_399_;
                    let _e258 = (bitcast<i32>(_e254.member) != 0i);
                    if _e258 {
                        let _e260 = ((_e254.member_1 & 1u) == 1u);
                        let _e262 = ((_e254.member_1 & 2u) == 2u);
                        let _e264 = ((_e254.member_1 & 4u) == 4u);
                        if _e260 {
                            phi_429_ = _e167;
                        } else {
                            phi_429_ = (1f - _e167);
                        }
                        let _e270 = phi_429_;
                        if _e262 {
                            phi_434_ = _e197;
                        } else {
                            phi_434_ = (1f - _e197);
                        }
                        let _e273 = phi_434_;
                        if _e264 {
                            phi_440_ = _e227;
                        } else {
                            phi_440_ = (1f - _e227);
                        }
                        let _e277 = phi_440_;
                        let _e287 = (((((select((f32((_e159 + _e101.x)) + 0.5f), (f32((_e164 + _e101.x)) + 0.5f), _e260) - _e129) * _e95.x) + ((select((f32((_e189 + _e101.y)) + 0.5f), (f32((_e194 + _e101.y)) + 0.5f), _e262) - _e130) * _e95.y)) + ((select((f32((_e219 + _e101.z)) + 0.5f), (f32((_e224 + _e101.z)) + 0.5f), _e264) - _e131) * _e95.z)) * 2f);
                        let _e289 = select(0f, _e287, (_e287 > 0f));
                        let _e292 = (((_e270 * _e273) * _e277) * select(1f, _e289, (_e289 < 1f)));
                        if (_e292 > 0f) {
                            let _e301 = (((_e117 + select(bitcast<u32>(_e159), bitcast<u32>(_e164), _e260)) + (select(bitcast<u32>(_e189), bitcast<u32>(_e194), _e262) * _e113)) + (select(bitcast<u32>(_e219), bitcast<u32>(_e224), _e264) * _e116));
                            if (_e301 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e306 = coefs.member[_e301];
                            let _e311 = (3u * _e121);
                            let _e312 = (_e311 + _e301);
                            if (_e312 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e316 = coefs.member[_e312];
                            let _e321 = (_e121 * 6u);
                            let _e322 = (_e321 + _e301);
                            if (_e322 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e326 = coefs.member[_e322];
                            let _e331 = (_e121 * 9u);
                            let _e332 = (_e331 + _e301);
                            if (_e332 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e336 = coefs.member[_e332];
                            let _e341 = (_e121 * 12u);
                            let _e342 = (_e341 + _e301);
                            if (_e342 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e346 = coefs.member[_e342];
                            let _e351 = (_e121 * 15u);
                            let _e352 = (_e351 + _e301);
                            if (_e352 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e356 = coefs.member[_e352];
                            let _e362 = (_e121 + _e301);
                            if (_e362 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e366 = coefs.member[_e362];
                            let _e371 = (_e311 + _e362);
                            if (_e371 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e375 = coefs.member[_e371];
                            let _e380 = (_e321 + _e362);
                            if (_e380 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e384 = coefs.member[_e380];
                            let _e389 = (_e331 + _e362);
                            if (_e389 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e393 = coefs.member[_e389];
                            let _e398 = (_e341 + _e362);
                            if (_e398 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e402 = coefs.member[_e398];
                            let _e407 = (_e351 + _e362);
                            if (_e407 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e411 = coefs.member[_e407];
                            let _e418 = ((2u * _e121) + _e301);
                            if (_e418 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e422 = coefs.member[_e418];
                            let _e427 = (_e311 + _e418);
                            if (_e427 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e431 = coefs.member[_e427];
                            let _e436 = (_e321 + _e418);
                            if (_e436 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e440 = coefs.member[_e436];
                            let _e445 = (_e331 + _e418);
                            if (_e445 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e449 = coefs.member[_e445];
                            let _e454 = (_e341 + _e418);
                            if (_e454 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e458 = coefs.member[_e454];
                            let _e463 = (_e351 + _e418);
                            if (_e463 < _e58) {
                            } else {
                                phi_4997_ = true;
                                break;
                            }
                            let _e467 = coefs.member[_e463];
                            phi_775_ = (_e237 + _e292);
                            phi_776_ = array<array<f32, 6>, 3>(array<f32, 6>((_e239[0][0] + (_e306 * _e292)), (_e239[0][1] + (_e316 * _e292)), (_e239[0][2] + (_e326 * _e292)), (_e239[0][3] + (_e336 * _e292)), (_e239[0][4] + (_e346 * _e292)), (_e239[0][5] + (_e356 * _e292))), array<f32, 6>((_e239[1][0] + (_e366 * _e292)), (_e239[1][1] + (_e375 * _e292)), (_e239[1][2] + (_e384 * _e292)), (_e239[1][3] + (_e393 * _e292)), (_e239[1][4] + (_e402 * _e292)), (_e239[1][5] + (_e411 * _e292))), array<f32, 6>((_e239[2][0] + (_e422 * _e292)), (_e239[2][1] + (_e431 * _e292)), (_e239[2][2] + (_e440 * _e292)), (_e239[2][3] + (_e449 * _e292)), (_e239[2][4] + (_e458 * _e292)), (_e239[2][5] + (_e467 * _e292))));
                        } else {
                            phi_775_ = _e237;
                            phi_776_ = _e239;
                        }
                        let _e475 = phi_775_;
                        let _e477 = phi_776_;
                        phi_375_ = _e475;
                        phi_377_ = _e477;
                    } else {
                        phi_375_ = f32();
                        phi_377_ = array<array<f32, 6>, 3>();
                    }
                    let _e479 = phi_375_;
                    let _e481 = phi_377_;
                    continue;
                    continuing {
                        phi_371_ = _e252;
                        phi_374_ = _e479;
                        phi_376_ = _e481;
                        phi_4997_ = false;
                        break if !(_e258);
                    }
                }
                let _e484 = phi_4997_;
                if _e484 {
                    break;
                }
                let _e486 = local;
                if (_e486 > 0f) {
                    let _e489 = local_1;
                    phi_782_ = (1f / _e489);
                } else {
                    phi_782_ = 0f;
                }
                let _e492 = phi_782_;
                let _e494 = local_2;
                let _e499 = local_3;
                let _e504 = local_4;
                let _e509 = local_5;
                let _e514 = local_6;
                let _e519 = local_7;
                let _e524 = local_8;
                let _e529 = local_9;
                let _e534 = local_10;
                let _e539 = local_11;
                let _e544 = local_12;
                let _e549 = local_13;
                let _e554 = local_14;
                let _e559 = local_15;
                let _e564 = local_16;
                let _e569 = local_17;
                let _e574 = local_18;
                let _e579 = local_19;
                let _e584 = ((0.6666667f / _e98.w) / _e98.w);
                let _e585 = -(_e95.x);
                let _e586 = -(_e95.y);
                let _e589 = (_e95.z * -1.0233268f);
                let _e595 = ((((_e95.z * -1.9364917f) * (_e95.z * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                let _e598 = (_e95.x * -1.0233268f);
                let _e601 = (_e95.y * -1.0233268f);
                let _e607 = (((_e585 * _e585) - (_e586 * _e586)) * 0.4290428f);
                let _e609 = (((((((_e494[0][0] * _e492) * 0.886227f) + ((_e504[0][2] * _e492) * _e589)) + ((_e514[0][4] * _e492) * _e595)) + ((_e509[0][3] * _e492) * _e598)) + ((_e499[0][1] * _e492) * _e601)) + ((_e519[0][5] * _e492) * _e607));
                let _e622 = (((((((_e524[1][0] * _e492) * 0.886227f) + ((_e534[1][2] * _e492) * _e589)) + ((_e544[1][4] * _e492) * _e595)) + ((_e539[1][3] * _e492) * _e598)) + ((_e529[1][1] * _e492) * _e601)) + ((_e549[1][5] * _e492) * _e607));
                let _e635 = (((((((_e554[2][0] * _e492) * 0.886227f) + ((_e564[2][2] * _e492) * _e589)) + ((_e574[2][4] * _e492) * _e595)) + ((_e569[2][3] * _e492) * _e598)) + ((_e559[2][1] * _e492) * _e601)) + ((_e579[2][5] * _e492) * _e607));
                let _e644 = facets.member[_e69].member_1;
                let _e647 = params.member.member_13;
                let _e649 = ((_e644 * _e647) * _e647);
                let _e653 = facets.member[_e69].member_4;
                let _e660 = ((_e653[0] * (select(0f, _e609, (_e609 > 0f)) * _e584)) * _e649);
                let _e661 = ((_e653[1] * (select(0f, _e622, (_e622 > 0f)) * _e584)) * _e649);
                let _e662 = ((_e653[2] * (select(0f, _e635, (_e635 > 0f)) * _e584)) * _e649);
                let _e663 = floor(_e138);
                let _e671 = floor(_e139);
                let _e679 = floor(_e140);
                let _e687 = (select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < -2147483600f)), 2147483647i, (_e663 > 2147483500f)), (_e663 == _e663)) - _e101.x);
                let _e688 = (select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < -2147483600f)), 2147483647i, (_e671 > 2147483500f)), (_e671 == _e671)) - _e101.y);
                let _e689 = (select(0i, select(select(i32(_e679), i32(-2147483648), (_e679 < -2147483600f)), 2147483647i, (_e679 > 2147483500f)), (_e679 == _e679)) - _e101.z);
                if (_e687 >= 0i) {
                    if (_e688 >= 0i) {
                        if (_e689 >= 0i) {
                            if (_e687 < _e146) {
                                let _e694 = (_e688 < _e176);
                                if _e694 {
                                    phi_3176_ = (_e689 < _e206);
                                } else {
                                    phi_3176_ = bool();
                                }
                                let _e697 = phi_3176_;
                                phi_3178_ = _e697;
                                phi_3179_ = select(true, false, _e694);
                            } else {
                                phi_3178_ = bool();
                                phi_3179_ = true;
                            }
                            let _e700 = phi_3178_;
                            let _e702 = phi_3179_;
                            phi_3180_ = _e700;
                            phi_3181_ = _e702;
                        } else {
                            phi_3180_ = bool();
                            phi_3181_ = true;
                        }
                        let _e704 = phi_3180_;
                        let _e706 = phi_3181_;
                        phi_3182_ = _e704;
                        phi_3183_ = _e706;
                    } else {
                        phi_3182_ = bool();
                        phi_3183_ = true;
                    }
                    let _e708 = phi_3182_;
                    let _e710 = phi_3183_;
                    phi_3184_ = _e708;
                    phi_3185_ = _e710;
                } else {
                    phi_3184_ = bool();
                    phi_3185_ = true;
                }
                let _e712 = phi_3184_;
                let _e714 = phi_3185_;
                if select(_e712, false, _e714) {
                    let _e723 = (((_e117 + bitcast<u32>(_e687)) + (bitcast<u32>(_e688) * _e113)) + (bitcast<u32>(_e689) * _e116));
                    let _e726 = params.member.member_16;
                    if (_e726 <= 1u) {
                        let _e1479 = params.member.member_7;
                        let _e1480 = (_e660 * _e1479);
                        let _e1482 = select(0f, _e1480, (_e1480 > 0f));
                        let _e1484 = select(1073741800f, _e1482, (_e1482 < 1073741800f));
                        let _e1485 = (3u * _e121);
                        let _e1487 = floor((_e1484 + 0.5f));
                        let _e1492 = select(select(u32(_e1487), 0u, (_e1487 < 0f)), 4294967295u, (_e1487 > 4294967000f));
                        if (_e1492 == 0u) {
                        } else {
                            if (_e723 < _e60) {
                            } else {
                                break;
                            }
                            let _e1497 = atomicAdd((&words.member[_e723]), _e1492);
                            if (_e1497 >= (1073741824u - select(_e1492, 1073741824u, (1073741824u < _e1492)))) {
                                let _e1505 = ((_e121 * 12u) * select(1u, _e726, (1u < _e726)));
                                if (_e1505 < _e60) {
                                } else {
                                    break;
                                }
                                let _e1509 = atomicOr((&words.member[_e1505]), 1u);
                            }
                            let _e1510 = (_e1484 * 0.6666667f);
                            let _e1514 = (_e723 + _e1485);
                            let _e1516 = floor(((_e95.x * _e1510) + 0.5f));
                            if (_e1514 < _e60) {
                            } else {
                                break;
                            }
                            let _e1528 = atomicAdd((&words.member[_e1514]), bitcast<u32>(select(0i, select(select(i32(_e1516), i32(-2147483648), (_e1516 < -2147483600f)), 2147483647i, (_e1516 > 2147483500f)), (_e1516 == _e1516))));
                            let _e1530 = (_e723 + (_e121 * 6u));
                            let _e1532 = floor(((_e95.y * _e1510) + 0.5f));
                            if (_e1530 < _e60) {
                            } else {
                                break;
                            }
                            let _e1544 = atomicAdd((&words.member[_e1530]), bitcast<u32>(select(0i, select(select(i32(_e1532), i32(-2147483648), (_e1532 < -2147483600f)), 2147483647i, (_e1532 > 2147483500f)), (_e1532 == _e1532))));
                            let _e1546 = (_e723 + (_e121 * 9u));
                            let _e1548 = floor(((_e95.z * _e1510) + 0.5f));
                            if (_e1546 < _e60) {
                            } else {
                                break;
                            }
                            let _e1560 = atomicAdd((&words.member[_e1546]), bitcast<u32>(select(0i, select(select(i32(_e1548), i32(-2147483648), (_e1548 < -2147483600f)), 2147483647i, (_e1548 > 2147483500f)), (_e1548 == _e1548))));
                        }
                        let _e1561 = (_e661 * _e1479);
                        let _e1563 = select(0f, _e1561, (_e1561 > 0f));
                        let _e1565 = select(1073741800f, _e1563, (_e1563 < 1073741800f));
                        let _e1566 = (_e121 + _e723);
                        let _e1568 = floor((_e1565 + 0.5f));
                        let _e1573 = select(select(u32(_e1568), 0u, (_e1568 < 0f)), 4294967295u, (_e1568 > 4294967000f));
                        if (_e1573 == 0u) {
                        } else {
                            if (_e1566 < _e60) {
                            } else {
                                break;
                            }
                            let _e1578 = atomicAdd((&words.member[_e1566]), _e1573);
                            if (_e1578 >= (1073741824u - select(_e1573, 1073741824u, (1073741824u < _e1573)))) {
                                let _e1586 = ((_e121 * 12u) * select(1u, _e726, (1u < _e726)));
                                if (_e1586 < _e60) {
                                } else {
                                    break;
                                }
                                let _e1590 = atomicOr((&words.member[_e1586]), 1u);
                            }
                            let _e1591 = (_e1565 * 0.6666667f);
                            let _e1595 = (_e1566 + _e1485);
                            let _e1597 = floor(((_e95.x * _e1591) + 0.5f));
                            if (_e1595 < _e60) {
                            } else {
                                break;
                            }
                            let _e1609 = atomicAdd((&words.member[_e1595]), bitcast<u32>(select(0i, select(select(i32(_e1597), i32(-2147483648), (_e1597 < -2147483600f)), 2147483647i, (_e1597 > 2147483500f)), (_e1597 == _e1597))));
                            let _e1611 = (_e1566 + (_e121 * 6u));
                            let _e1613 = floor(((_e95.y * _e1591) + 0.5f));
                            if (_e1611 < _e60) {
                            } else {
                                break;
                            }
                            let _e1625 = atomicAdd((&words.member[_e1611]), bitcast<u32>(select(0i, select(select(i32(_e1613), i32(-2147483648), (_e1613 < -2147483600f)), 2147483647i, (_e1613 > 2147483500f)), (_e1613 == _e1613))));
                            let _e1627 = (_e1566 + (_e121 * 9u));
                            let _e1629 = floor(((_e95.z * _e1591) + 0.5f));
                            if (_e1627 < _e60) {
                            } else {
                                break;
                            }
                            let _e1641 = atomicAdd((&words.member[_e1627]), bitcast<u32>(select(0i, select(select(i32(_e1629), i32(-2147483648), (_e1629 < -2147483600f)), 2147483647i, (_e1629 > 2147483500f)), (_e1629 == _e1629))));
                        }
                        let _e1642 = (_e662 * _e1479);
                        let _e1644 = select(0f, _e1642, (_e1642 > 0f));
                        let _e1646 = select(1073741800f, _e1644, (_e1644 < 1073741800f));
                        let _e1648 = ((2u * _e121) + _e723);
                        let _e1650 = floor((_e1646 + 0.5f));
                        let _e1655 = select(select(u32(_e1650), 0u, (_e1650 < 0f)), 4294967295u, (_e1650 > 4294967000f));
                        if (_e1655 == 0u) {
                        } else {
                            if (_e1648 < _e60) {
                            } else {
                                break;
                            }
                            let _e1660 = atomicAdd((&words.member[_e1648]), _e1655);
                            if (_e1660 >= (1073741824u - select(_e1655, 1073741824u, (1073741824u < _e1655)))) {
                                let _e1668 = ((_e121 * 12u) * select(1u, _e726, (1u < _e726)));
                                if (_e1668 < _e60) {
                                } else {
                                    break;
                                }
                                let _e1672 = atomicOr((&words.member[_e1668]), 1u);
                            }
                            let _e1673 = (_e1646 * 0.6666667f);
                            let _e1677 = (_e1648 + _e1485);
                            let _e1679 = floor(((_e95.x * _e1673) + 0.5f));
                            if (_e1677 < _e60) {
                            } else {
                                break;
                            }
                            let _e1691 = atomicAdd((&words.member[_e1677]), bitcast<u32>(select(0i, select(select(i32(_e1679), i32(-2147483648), (_e1679 < -2147483600f)), 2147483647i, (_e1679 > 2147483500f)), (_e1679 == _e1679))));
                            let _e1693 = (_e1648 + (_e121 * 6u));
                            let _e1695 = floor(((_e95.y * _e1673) + 0.5f));
                            if (_e1693 < _e60) {
                            } else {
                                break;
                            }
                            let _e1707 = atomicAdd((&words.member[_e1693]), bitcast<u32>(select(0i, select(select(i32(_e1695), i32(-2147483648), (_e1695 < -2147483600f)), 2147483647i, (_e1695 > 2147483500f)), (_e1695 == _e1695))));
                            let _e1709 = (_e1648 + (_e121 * 9u));
                            let _e1711 = floor(((_e95.z * _e1673) + 0.5f));
                            if (_e1709 < _e60) {
                            } else {
                                break;
                            }
                            let _e1723 = atomicAdd((&words.member[_e1709]), bitcast<u32>(select(0i, select(select(i32(_e1711), i32(-2147483648), (_e1711 < -2147483600f)), 2147483647i, (_e1711 > 2147483500f)), (_e1711 == _e1711))));
                        }
                    } else {
                        let _e728 = (3u * _e121);
                        let _e729 = (_e121 * 12u);
                        let _e733 = ((select(0u, 1u, (_e95.x < 0f)) * _e729) + _e723);
                        let _e734 = (_e95.x * _e95.x);
                        let _e740 = params.member.member_7;
                        let _e741 = ((_e660 * _e734) * _e740);
                        let _e743 = select(0f, _e741, (_e741 > 0f));
                        let _e745 = select(1073741800f, _e743, (_e743 < 1073741800f));
                        let _e747 = floor((_e745 + 0.5f));
                        let _e752 = select(select(u32(_e747), 0u, (_e747 < 0f)), 4294967295u, (_e747 > 4294967000f));
                        if (_e752 == 0u) {
                        } else {
                            if (_e733 < _e60) {
                            } else {
                                break;
                            }
                            let _e757 = atomicAdd((&words.member[_e733]), _e752);
                            if (_e757 >= (1073741824u - select(_e752, 1073741824u, (1073741824u < _e752)))) {
                                let _e764 = (_e729 * select(1u, _e726, (1u < _e726)));
                                if (_e764 < _e60) {
                                } else {
                                    break;
                                }
                                let _e768 = atomicOr((&words.member[_e764]), 1u);
                            }
                            let _e769 = (_e745 * 0.6666667f);
                            let _e773 = (_e733 + _e728);
                            let _e775 = floor(((_e95.x * _e769) + 0.5f));
                            if (_e773 < _e60) {
                            } else {
                                break;
                            }
                            let _e787 = atomicAdd((&words.member[_e773]), bitcast<u32>(select(0i, select(select(i32(_e775), i32(-2147483648), (_e775 < -2147483600f)), 2147483647i, (_e775 > 2147483500f)), (_e775 == _e775))));
                            let _e789 = (_e733 + (_e121 * 6u));
                            let _e791 = floor(((_e95.y * _e769) + 0.5f));
                            if (_e789 < _e60) {
                            } else {
                                break;
                            }
                            let _e803 = atomicAdd((&words.member[_e789]), bitcast<u32>(select(0i, select(select(i32(_e791), i32(-2147483648), (_e791 < -2147483600f)), 2147483647i, (_e791 > 2147483500f)), (_e791 == _e791))));
                            let _e805 = (_e733 + (_e121 * 9u));
                            let _e807 = floor(((_e95.z * _e769) + 0.5f));
                            if (_e805 < _e60) {
                            } else {
                                break;
                            }
                            let _e819 = atomicAdd((&words.member[_e805]), bitcast<u32>(select(0i, select(select(i32(_e807), i32(-2147483648), (_e807 < -2147483600f)), 2147483647i, (_e807 > 2147483500f)), (_e807 == _e807))));
                        }
                        let _e820 = ((_e661 * _e734) * _e740);
                        let _e822 = select(0f, _e820, (_e820 > 0f));
                        let _e824 = select(1073741800f, _e822, (_e822 < 1073741800f));
                        let _e825 = (_e121 + _e733);
                        let _e827 = floor((_e824 + 0.5f));
                        let _e832 = select(select(u32(_e827), 0u, (_e827 < 0f)), 4294967295u, (_e827 > 4294967000f));
                        if (_e832 == 0u) {
                        } else {
                            if (_e825 < _e60) {
                            } else {
                                break;
                            }
                            let _e837 = atomicAdd((&words.member[_e825]), _e832);
                            if (_e837 >= (1073741824u - select(_e832, 1073741824u, (1073741824u < _e832)))) {
                                let _e844 = (_e729 * select(1u, _e726, (1u < _e726)));
                                if (_e844 < _e60) {
                                } else {
                                    break;
                                }
                                let _e848 = atomicOr((&words.member[_e844]), 1u);
                            }
                            let _e849 = (_e824 * 0.6666667f);
                            let _e853 = (_e825 + _e728);
                            let _e855 = floor(((_e95.x * _e849) + 0.5f));
                            if (_e853 < _e60) {
                            } else {
                                break;
                            }
                            let _e867 = atomicAdd((&words.member[_e853]), bitcast<u32>(select(0i, select(select(i32(_e855), i32(-2147483648), (_e855 < -2147483600f)), 2147483647i, (_e855 > 2147483500f)), (_e855 == _e855))));
                            let _e869 = (_e825 + (_e121 * 6u));
                            let _e871 = floor(((_e95.y * _e849) + 0.5f));
                            if (_e869 < _e60) {
                            } else {
                                break;
                            }
                            let _e883 = atomicAdd((&words.member[_e869]), bitcast<u32>(select(0i, select(select(i32(_e871), i32(-2147483648), (_e871 < -2147483600f)), 2147483647i, (_e871 > 2147483500f)), (_e871 == _e871))));
                            let _e885 = (_e825 + (_e121 * 9u));
                            let _e887 = floor(((_e95.z * _e849) + 0.5f));
                            if (_e885 < _e60) {
                            } else {
                                break;
                            }
                            let _e899 = atomicAdd((&words.member[_e885]), bitcast<u32>(select(0i, select(select(i32(_e887), i32(-2147483648), (_e887 < -2147483600f)), 2147483647i, (_e887 > 2147483500f)), (_e887 == _e887))));
                        }
                        let _e900 = ((_e662 * _e734) * _e740);
                        let _e902 = select(0f, _e900, (_e900 > 0f));
                        let _e904 = select(1073741800f, _e902, (_e902 < 1073741800f));
                        let _e905 = (2u * _e121);
                        let _e906 = (_e905 + _e733);
                        let _e908 = floor((_e904 + 0.5f));
                        let _e913 = select(select(u32(_e908), 0u, (_e908 < 0f)), 4294967295u, (_e908 > 4294967000f));
                        if (_e913 == 0u) {
                        } else {
                            if (_e906 < _e60) {
                            } else {
                                break;
                            }
                            let _e918 = atomicAdd((&words.member[_e906]), _e913);
                            if (_e918 >= (1073741824u - select(_e913, 1073741824u, (1073741824u < _e913)))) {
                                let _e925 = (_e729 * select(1u, _e726, (1u < _e726)));
                                if (_e925 < _e60) {
                                } else {
                                    break;
                                }
                                let _e929 = atomicOr((&words.member[_e925]), 1u);
                            }
                            let _e930 = (_e904 * 0.6666667f);
                            let _e934 = (_e906 + _e728);
                            let _e936 = floor(((_e95.x * _e930) + 0.5f));
                            if (_e934 < _e60) {
                            } else {
                                break;
                            }
                            let _e948 = atomicAdd((&words.member[_e934]), bitcast<u32>(select(0i, select(select(i32(_e936), i32(-2147483648), (_e936 < -2147483600f)), 2147483647i, (_e936 > 2147483500f)), (_e936 == _e936))));
                            let _e950 = (_e906 + (_e121 * 6u));
                            let _e952 = floor(((_e95.y * _e930) + 0.5f));
                            if (_e950 < _e60) {
                            } else {
                                break;
                            }
                            let _e964 = atomicAdd((&words.member[_e950]), bitcast<u32>(select(0i, select(select(i32(_e952), i32(-2147483648), (_e952 < -2147483600f)), 2147483647i, (_e952 > 2147483500f)), (_e952 == _e952))));
                            let _e966 = (_e906 + (_e121 * 9u));
                            let _e968 = floor(((_e95.z * _e930) + 0.5f));
                            if (_e966 < _e60) {
                            } else {
                                break;
                            }
                            let _e980 = atomicAdd((&words.member[_e966]), bitcast<u32>(select(0i, select(select(i32(_e968), i32(-2147483648), (_e968 < -2147483600f)), 2147483647i, (_e968 > 2147483500f)), (_e968 == _e968))));
                        }
                        let _e985 = (((2u + select(0u, 1u, (_e95.y < 0f))) * _e729) + _e723);
                        let _e986 = (_e95.y * _e95.y);
                        let _e990 = ((_e660 * _e986) * _e740);
                        let _e992 = select(0f, _e990, (_e990 > 0f));
                        let _e994 = select(1073741800f, _e992, (_e992 < 1073741800f));
                        let _e996 = floor((_e994 + 0.5f));
                        let _e1001 = select(select(u32(_e996), 0u, (_e996 < 0f)), 4294967295u, (_e996 > 4294967000f));
                        if (_e1001 == 0u) {
                        } else {
                            if (_e985 < _e60) {
                            } else {
                                break;
                            }
                            let _e1006 = atomicAdd((&words.member[_e985]), _e1001);
                            if (_e1006 >= (1073741824u - select(_e1001, 1073741824u, (1073741824u < _e1001)))) {
                                let _e1013 = (_e729 * select(1u, _e726, (1u < _e726)));
                                if (_e1013 < _e60) {
                                } else {
                                    break;
                                }
                                let _e1017 = atomicOr((&words.member[_e1013]), 1u);
                            }
                            let _e1018 = (_e994 * 0.6666667f);
                            let _e1022 = (_e985 + _e728);
                            let _e1024 = floor(((_e95.x * _e1018) + 0.5f));
                            if (_e1022 < _e60) {
                            } else {
                                break;
                            }
                            let _e1036 = atomicAdd((&words.member[_e1022]), bitcast<u32>(select(0i, select(select(i32(_e1024), i32(-2147483648), (_e1024 < -2147483600f)), 2147483647i, (_e1024 > 2147483500f)), (_e1024 == _e1024))));
                            let _e1038 = (_e985 + (_e121 * 6u));
                            let _e1040 = floor(((_e95.y * _e1018) + 0.5f));
                            if (_e1038 < _e60) {
                            } else {
                                break;
                            }
                            let _e1052 = atomicAdd((&words.member[_e1038]), bitcast<u32>(select(0i, select(select(i32(_e1040), i32(-2147483648), (_e1040 < -2147483600f)), 2147483647i, (_e1040 > 2147483500f)), (_e1040 == _e1040))));
                            let _e1054 = (_e985 + (_e121 * 9u));
                            let _e1056 = floor(((_e95.z * _e1018) + 0.5f));
                            if (_e1054 < _e60) {
                            } else {
                                break;
                            }
                            let _e1068 = atomicAdd((&words.member[_e1054]), bitcast<u32>(select(0i, select(select(i32(_e1056), i32(-2147483648), (_e1056 < -2147483600f)), 2147483647i, (_e1056 > 2147483500f)), (_e1056 == _e1056))));
                        }
                        let _e1069 = ((_e661 * _e986) * _e740);
                        let _e1071 = select(0f, _e1069, (_e1069 > 0f));
                        let _e1073 = select(1073741800f, _e1071, (_e1071 < 1073741800f));
                        let _e1074 = (_e121 + _e985);
                        let _e1076 = floor((_e1073 + 0.5f));
                        let _e1081 = select(select(u32(_e1076), 0u, (_e1076 < 0f)), 4294967295u, (_e1076 > 4294967000f));
                        if (_e1081 == 0u) {
                        } else {
                            if (_e1074 < _e60) {
                            } else {
                                break;
                            }
                            let _e1086 = atomicAdd((&words.member[_e1074]), _e1081);
                            if (_e1086 >= (1073741824u - select(_e1081, 1073741824u, (1073741824u < _e1081)))) {
                                let _e1093 = (_e729 * select(1u, _e726, (1u < _e726)));
                                if (_e1093 < _e60) {
                                } else {
                                    break;
                                }
                                let _e1097 = atomicOr((&words.member[_e1093]), 1u);
                            }
                            let _e1098 = (_e1073 * 0.6666667f);
                            let _e1102 = (_e1074 + _e728);
                            let _e1104 = floor(((_e95.x * _e1098) + 0.5f));
                            if (_e1102 < _e60) {
                            } else {
                                break;
                            }
                            let _e1116 = atomicAdd((&words.member[_e1102]), bitcast<u32>(select(0i, select(select(i32(_e1104), i32(-2147483648), (_e1104 < -2147483600f)), 2147483647i, (_e1104 > 2147483500f)), (_e1104 == _e1104))));
                            let _e1118 = (_e1074 + (_e121 * 6u));
                            let _e1120 = floor(((_e95.y * _e1098) + 0.5f));
                            if (_e1118 < _e60) {
                            } else {
                                break;
                            }
                            let _e1132 = atomicAdd((&words.member[_e1118]), bitcast<u32>(select(0i, select(select(i32(_e1120), i32(-2147483648), (_e1120 < -2147483600f)), 2147483647i, (_e1120 > 2147483500f)), (_e1120 == _e1120))));
                            let _e1134 = (_e1074 + (_e121 * 9u));
                            let _e1136 = floor(((_e95.z * _e1098) + 0.5f));
                            if (_e1134 < _e60) {
                            } else {
                                break;
                            }
                            let _e1148 = atomicAdd((&words.member[_e1134]), bitcast<u32>(select(0i, select(select(i32(_e1136), i32(-2147483648), (_e1136 < -2147483600f)), 2147483647i, (_e1136 > 2147483500f)), (_e1136 == _e1136))));
                        }
                        let _e1149 = ((_e662 * _e986) * _e740);
                        let _e1151 = select(0f, _e1149, (_e1149 > 0f));
                        let _e1153 = select(1073741800f, _e1151, (_e1151 < 1073741800f));
                        let _e1154 = (_e905 + _e985);
                        let _e1156 = floor((_e1153 + 0.5f));
                        let _e1161 = select(select(u32(_e1156), 0u, (_e1156 < 0f)), 4294967295u, (_e1156 > 4294967000f));
                        if (_e1161 == 0u) {
                        } else {
                            if (_e1154 < _e60) {
                            } else {
                                break;
                            }
                            let _e1166 = atomicAdd((&words.member[_e1154]), _e1161);
                            if (_e1166 >= (1073741824u - select(_e1161, 1073741824u, (1073741824u < _e1161)))) {
                                let _e1173 = (_e729 * select(1u, _e726, (1u < _e726)));
                                if (_e1173 < _e60) {
                                } else {
                                    break;
                                }
                                let _e1177 = atomicOr((&words.member[_e1173]), 1u);
                            }
                            let _e1178 = (_e1153 * 0.6666667f);
                            let _e1182 = (_e1154 + _e728);
                            let _e1184 = floor(((_e95.x * _e1178) + 0.5f));
                            if (_e1182 < _e60) {
                            } else {
                                break;
                            }
                            let _e1196 = atomicAdd((&words.member[_e1182]), bitcast<u32>(select(0i, select(select(i32(_e1184), i32(-2147483648), (_e1184 < -2147483600f)), 2147483647i, (_e1184 > 2147483500f)), (_e1184 == _e1184))));
                            let _e1198 = (_e1154 + (_e121 * 6u));
                            let _e1200 = floor(((_e95.y * _e1178) + 0.5f));
                            if (_e1198 < _e60) {
                            } else {
                                break;
                            }
                            let _e1212 = atomicAdd((&words.member[_e1198]), bitcast<u32>(select(0i, select(select(i32(_e1200), i32(-2147483648), (_e1200 < -2147483600f)), 2147483647i, (_e1200 > 2147483500f)), (_e1200 == _e1200))));
                            let _e1214 = (_e1154 + (_e121 * 9u));
                            let _e1216 = floor(((_e95.z * _e1178) + 0.5f));
                            if (_e1214 < _e60) {
                            } else {
                                break;
                            }
                            let _e1228 = atomicAdd((&words.member[_e1214]), bitcast<u32>(select(0i, select(select(i32(_e1216), i32(-2147483648), (_e1216 < -2147483600f)), 2147483647i, (_e1216 > 2147483500f)), (_e1216 == _e1216))));
                        }
                        let _e1233 = (((4u + select(0u, 1u, (_e95.z < 0f))) * _e729) + _e723);
                        let _e1234 = (_e95.z * _e95.z);
                        let _e1238 = ((_e660 * _e1234) * _e740);
                        let _e1240 = select(0f, _e1238, (_e1238 > 0f));
                        let _e1242 = select(1073741800f, _e1240, (_e1240 < 1073741800f));
                        let _e1244 = floor((_e1242 + 0.5f));
                        let _e1249 = select(select(u32(_e1244), 0u, (_e1244 < 0f)), 4294967295u, (_e1244 > 4294967000f));
                        if (_e1249 == 0u) {
                        } else {
                            if (_e1233 < _e60) {
                            } else {
                                break;
                            }
                            let _e1254 = atomicAdd((&words.member[_e1233]), _e1249);
                            if (_e1254 >= (1073741824u - select(_e1249, 1073741824u, (1073741824u < _e1249)))) {
                                let _e1261 = (_e729 * select(1u, _e726, (1u < _e726)));
                                if (_e1261 < _e60) {
                                } else {
                                    break;
                                }
                                let _e1265 = atomicOr((&words.member[_e1261]), 1u);
                            }
                            let _e1266 = (_e1242 * 0.6666667f);
                            let _e1270 = (_e1233 + _e728);
                            let _e1272 = floor(((_e95.x * _e1266) + 0.5f));
                            if (_e1270 < _e60) {
                            } else {
                                break;
                            }
                            let _e1284 = atomicAdd((&words.member[_e1270]), bitcast<u32>(select(0i, select(select(i32(_e1272), i32(-2147483648), (_e1272 < -2147483600f)), 2147483647i, (_e1272 > 2147483500f)), (_e1272 == _e1272))));
                            let _e1286 = (_e1233 + (_e121 * 6u));
                            let _e1288 = floor(((_e95.y * _e1266) + 0.5f));
                            if (_e1286 < _e60) {
                            } else {
                                break;
                            }
                            let _e1300 = atomicAdd((&words.member[_e1286]), bitcast<u32>(select(0i, select(select(i32(_e1288), i32(-2147483648), (_e1288 < -2147483600f)), 2147483647i, (_e1288 > 2147483500f)), (_e1288 == _e1288))));
                            let _e1302 = (_e1233 + (_e121 * 9u));
                            let _e1304 = floor(((_e95.z * _e1266) + 0.5f));
                            if (_e1302 < _e60) {
                            } else {
                                break;
                            }
                            let _e1316 = atomicAdd((&words.member[_e1302]), bitcast<u32>(select(0i, select(select(i32(_e1304), i32(-2147483648), (_e1304 < -2147483600f)), 2147483647i, (_e1304 > 2147483500f)), (_e1304 == _e1304))));
                        }
                        let _e1317 = ((_e661 * _e1234) * _e740);
                        let _e1319 = select(0f, _e1317, (_e1317 > 0f));
                        let _e1321 = select(1073741800f, _e1319, (_e1319 < 1073741800f));
                        let _e1322 = (_e121 + _e1233);
                        let _e1324 = floor((_e1321 + 0.5f));
                        let _e1329 = select(select(u32(_e1324), 0u, (_e1324 < 0f)), 4294967295u, (_e1324 > 4294967000f));
                        if (_e1329 == 0u) {
                        } else {
                            if (_e1322 < _e60) {
                            } else {
                                break;
                            }
                            let _e1334 = atomicAdd((&words.member[_e1322]), _e1329);
                            if (_e1334 >= (1073741824u - select(_e1329, 1073741824u, (1073741824u < _e1329)))) {
                                let _e1341 = (_e729 * select(1u, _e726, (1u < _e726)));
                                if (_e1341 < _e60) {
                                } else {
                                    break;
                                }
                                let _e1345 = atomicOr((&words.member[_e1341]), 1u);
                            }
                            let _e1346 = (_e1321 * 0.6666667f);
                            let _e1350 = (_e1322 + _e728);
                            let _e1352 = floor(((_e95.x * _e1346) + 0.5f));
                            if (_e1350 < _e60) {
                            } else {
                                break;
                            }
                            let _e1364 = atomicAdd((&words.member[_e1350]), bitcast<u32>(select(0i, select(select(i32(_e1352), i32(-2147483648), (_e1352 < -2147483600f)), 2147483647i, (_e1352 > 2147483500f)), (_e1352 == _e1352))));
                            let _e1366 = (_e1322 + (_e121 * 6u));
                            let _e1368 = floor(((_e95.y * _e1346) + 0.5f));
                            if (_e1366 < _e60) {
                            } else {
                                break;
                            }
                            let _e1380 = atomicAdd((&words.member[_e1366]), bitcast<u32>(select(0i, select(select(i32(_e1368), i32(-2147483648), (_e1368 < -2147483600f)), 2147483647i, (_e1368 > 2147483500f)), (_e1368 == _e1368))));
                            let _e1382 = (_e1322 + (_e121 * 9u));
                            let _e1384 = floor(((_e95.z * _e1346) + 0.5f));
                            if (_e1382 < _e60) {
                            } else {
                                break;
                            }
                            let _e1396 = atomicAdd((&words.member[_e1382]), bitcast<u32>(select(0i, select(select(i32(_e1384), i32(-2147483648), (_e1384 < -2147483600f)), 2147483647i, (_e1384 > 2147483500f)), (_e1384 == _e1384))));
                        }
                        let _e1397 = ((_e662 * _e1234) * _e740);
                        let _e1399 = select(0f, _e1397, (_e1397 > 0f));
                        let _e1401 = select(1073741800f, _e1399, (_e1399 < 1073741800f));
                        let _e1402 = (_e905 + _e1233);
                        let _e1404 = floor((_e1401 + 0.5f));
                        let _e1409 = select(select(u32(_e1404), 0u, (_e1404 < 0f)), 4294967295u, (_e1404 > 4294967000f));
                        if (_e1409 == 0u) {
                        } else {
                            if (_e1402 < _e60) {
                            } else {
                                break;
                            }
                            let _e1414 = atomicAdd((&words.member[_e1402]), _e1409);
                            if (_e1414 >= (1073741824u - select(_e1409, 1073741824u, (1073741824u < _e1409)))) {
                                let _e1421 = (_e729 * select(1u, _e726, (1u < _e726)));
                                if (_e1421 < _e60) {
                                } else {
                                    break;
                                }
                                let _e1425 = atomicOr((&words.member[_e1421]), 1u);
                            }
                            let _e1426 = (_e1401 * 0.6666667f);
                            let _e1430 = (_e1402 + _e728);
                            let _e1432 = floor(((_e95.x * _e1426) + 0.5f));
                            if (_e1430 < _e60) {
                            } else {
                                break;
                            }
                            let _e1444 = atomicAdd((&words.member[_e1430]), bitcast<u32>(select(0i, select(select(i32(_e1432), i32(-2147483648), (_e1432 < -2147483600f)), 2147483647i, (_e1432 > 2147483500f)), (_e1432 == _e1432))));
                            let _e1446 = (_e1402 + (_e121 * 6u));
                            let _e1448 = floor(((_e95.y * _e1426) + 0.5f));
                            if (_e1446 < _e60) {
                            } else {
                                break;
                            }
                            let _e1460 = atomicAdd((&words.member[_e1446]), bitcast<u32>(select(0i, select(select(i32(_e1448), i32(-2147483648), (_e1448 < -2147483600f)), 2147483647i, (_e1448 > 2147483500f)), (_e1448 == _e1448))));
                            let _e1462 = (_e1402 + (_e121 * 9u));
                            let _e1464 = floor(((_e95.z * _e1426) + 0.5f));
                            if (_e1462 < _e60) {
                            } else {
                                break;
                            }
                            let _e1476 = atomicAdd((&words.member[_e1462]), bitcast<u32>(select(0i, select(select(i32(_e1464), i32(-2147483648), (_e1464 < -2147483600f)), 2147483647i, (_e1464 > 2147483500f)), (_e1464 == _e1464))));
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_bounce(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
