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
    var phi_149_: vec3<f32>;
    var phi_156_: vec3<f32>;
    var phi_372_: type_15;
    var phi_375_: f32;
    var phi_377_: array<array<f32, 6>, 3>;
    var phi_373_: type_15;
    var phi_400_: type_15;
    var phi_430_: f32;
    var phi_435_: f32;
    var phi_441_: f32;
    var phi_776_: f32;
    var phi_777_: array<array<f32, 6>, 3>;
    var phi_376_: f32;
    var phi_378_: array<array<f32, 6>, 3>;
    var phi_4999_: bool;
    var local: f32;
    var local_1: f32;
    var phi_783_: f32;
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
    var phi_3178_: bool;
    var phi_3180_: bool;
    var phi_3181_: bool;
    var phi_3182_: bool;
    var phi_3183_: bool;
    var phi_3184_: bool;
    var phi_3185_: bool;
    var phi_3186_: bool;
    var phi_3187_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e55 = gid_1;
            let _e59 = arrayLength((&coefs.member));
            let _e61 = arrayLength((&words.member));
            let _e65 = (_e55.x + (_e55.y * 2097152u));
            let _e68 = params.member.member_5;
            if (_e65 < _e68) {
                let _e70 = (_e65 / 2u);
                if (_e70 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e75 = facets.member[_e70].member_2;
                let _e84 = sqrt((((_e75[0] * _e75[0]) + (_e75[1] * _e75[1])) + (_e75[2] * _e75[2])));
                if (_e84 > 0.000000000001f) {
                    phi_149_ = vec3<f32>((_e75[0] / _e84), (_e75[1] / _e84), (_e75[2] / _e84));
                } else {
                    phi_149_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e91 = phi_149_;
                if ((_e65 & 1u) == 0u) {
                    phi_156_ = _e91;
                } else {
                    phi_156_ = -(_e91);
                }
                let _e96 = phi_156_;
                let _e99 = params.member.member;
                let _e102 = params.member.member_1;
                let _e105 = params.member.member_2;
                let _e109 = facets.member[_e70].member;
                let _e114 = (_e105.x + 1u);
                let _e117 = ((_e105.y + 1u) * _e114);
                let _e118 = (_e117 + _e114);
                let _e122 = (_e118 + ((_e105.z + 1u) * _e117));
                let _e130 = ((_e109[0] - _e99.x) / _e99.w);
                let _e131 = ((_e109[1] - _e99.y) / _e99.w);
                let _e132 = ((_e109[2] - _e99.z) / _e99.w);
                let _e145 = ((_e130 + (_e96.x * 0.5f)) - 0.5f);
                let _e146 = floor(_e145);
                let _e147 = bitcast<i32>(_e105.x);
                let _e148 = (_e147 - 1i);
                let _e156 = (select(0i, select(select(i32(_e146), i32(-2147483648), (_e146 < -2147483600f)), 2147483647i, (_e146 > 2147483500f)), (_e146 == _e146)) - _e102.x);
                let _e158 = select(0i, _e156, (0i < _e156));
                let _e160 = select(_e158, _e148, (_e148 < _e158));
                let _e161 = (_e156 + 1i);
                let _e163 = select(0i, _e161, (0i < _e161));
                let _e165 = select(_e163, _e148, (_e148 < _e163));
                let _e168 = (_e145 - _e146);
                let _e175 = ((_e131 + (_e96.y * 0.5f)) - 0.5f);
                let _e176 = floor(_e175);
                let _e177 = bitcast<i32>(_e105.y);
                let _e178 = (_e177 - 1i);
                let _e186 = (select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < -2147483600f)), 2147483647i, (_e176 > 2147483500f)), (_e176 == _e176)) - _e102.y);
                let _e188 = select(0i, _e186, (0i < _e186));
                let _e190 = select(_e188, _e178, (_e178 < _e188));
                let _e191 = (_e186 + 1i);
                let _e193 = select(0i, _e191, (0i < _e191));
                let _e195 = select(_e193, _e178, (_e178 < _e193));
                let _e198 = (_e175 - _e176);
                let _e205 = ((_e132 + (_e96.z * 0.5f)) - 0.5f);
                let _e206 = floor(_e205);
                let _e207 = bitcast<i32>(_e105.z);
                let _e208 = (_e207 - 1i);
                let _e216 = (select(0i, select(select(i32(_e206), i32(-2147483648), (_e206 < -2147483600f)), 2147483647i, (_e206 > 2147483500f)), (_e206 == _e206)) - _e102.z);
                let _e218 = select(0i, _e216, (0i < _e216));
                let _e220 = select(_e218, _e208, (_e208 < _e218));
                let _e221 = (_e216 + 1i);
                let _e223 = select(0i, _e221, (0i < _e221));
                let _e225 = select(_e223, _e208, (_e208 < _e223));
                let _e228 = (_e205 - _e206);
                phi_372_ = type_15(0u, 8u);
                phi_375_ = 0f;
                phi_377_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                loop {
                    let _e236 = phi_372_;
                    let _e238 = phi_375_;
                    let _e240 = phi_377_;
                    local = _e238;
                    local_1 = _e238;
                    local_2 = _e240;
                    local_3 = _e240;
                    local_4 = _e240;
                    local_5 = _e240;
                    local_6 = _e240;
                    local_7 = _e240;
                    local_8 = _e240;
                    local_9 = _e240;
                    local_10 = _e240;
                    local_11 = _e240;
                    local_12 = _e240;
                    local_13 = _e240;
                    local_14 = _e240;
                    local_15 = _e240;
                    local_16 = _e240;
                    local_17 = _e240;
                    local_18 = _e240;
                    local_19 = _e240;
                    if (_e236.member < _e236.member_1) {
                        phi_373_ = type_15((_e236.member + 1u), _e236.member_1);
                        phi_400_ = type_15(1u, _e236.member);
                    } else {
                        phi_373_ = _e236;
                        phi_400_ = type_15(0u, type_15().member_1);
                    }
                    let _e253 = phi_373_;
                    let _e255 = phi_400_;
                    let _e259 = (bitcast<i32>(_e255.member) != 0i);
                    if _e259 {
                        let _e261 = ((_e255.member_1 & 1u) == 1u);
                        let _e263 = ((_e255.member_1 & 2u) == 2u);
                        let _e265 = ((_e255.member_1 & 4u) == 4u);
                        if _e261 {
                            phi_430_ = _e168;
                        } else {
                            phi_430_ = (1f - _e168);
                        }
                        let _e271 = phi_430_;
                        if _e263 {
                            phi_435_ = _e198;
                        } else {
                            phi_435_ = (1f - _e198);
                        }
                        let _e274 = phi_435_;
                        if _e265 {
                            phi_441_ = _e228;
                        } else {
                            phi_441_ = (1f - _e228);
                        }
                        let _e278 = phi_441_;
                        let _e288 = (((((select((f32((_e160 + _e102.x)) + 0.5f), (f32((_e165 + _e102.x)) + 0.5f), _e261) - _e130) * _e96.x) + ((select((f32((_e190 + _e102.y)) + 0.5f), (f32((_e195 + _e102.y)) + 0.5f), _e263) - _e131) * _e96.y)) + ((select((f32((_e220 + _e102.z)) + 0.5f), (f32((_e225 + _e102.z)) + 0.5f), _e265) - _e132) * _e96.z)) * 2f);
                        let _e290 = select(0f, _e288, (_e288 > 0f));
                        let _e293 = (((_e271 * _e274) * _e278) * select(1f, _e290, (_e290 < 1f)));
                        if (_e293 > 0f) {
                            let _e302 = (((_e118 + select(bitcast<u32>(_e160), bitcast<u32>(_e165), _e261)) + (select(bitcast<u32>(_e190), bitcast<u32>(_e195), _e263) * _e114)) + (select(bitcast<u32>(_e220), bitcast<u32>(_e225), _e265) * _e117));
                            if (_e302 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e307 = coefs.member[_e302];
                            let _e312 = (3u * _e122);
                            let _e313 = (_e312 + _e302);
                            if (_e313 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e317 = coefs.member[_e313];
                            let _e322 = (_e122 * 6u);
                            let _e323 = (_e322 + _e302);
                            if (_e323 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e327 = coefs.member[_e323];
                            let _e332 = (_e122 * 9u);
                            let _e333 = (_e332 + _e302);
                            if (_e333 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e337 = coefs.member[_e333];
                            let _e342 = (_e122 * 12u);
                            let _e343 = (_e342 + _e302);
                            if (_e343 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e347 = coefs.member[_e343];
                            let _e352 = (_e122 * 15u);
                            let _e353 = (_e352 + _e302);
                            if (_e353 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e357 = coefs.member[_e353];
                            let _e363 = (_e122 + _e302);
                            if (_e363 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e367 = coefs.member[_e363];
                            let _e372 = (_e312 + _e363);
                            if (_e372 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e376 = coefs.member[_e372];
                            let _e381 = (_e322 + _e363);
                            if (_e381 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e385 = coefs.member[_e381];
                            let _e390 = (_e332 + _e363);
                            if (_e390 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e394 = coefs.member[_e390];
                            let _e399 = (_e342 + _e363);
                            if (_e399 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e403 = coefs.member[_e399];
                            let _e408 = (_e352 + _e363);
                            if (_e408 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e412 = coefs.member[_e408];
                            let _e419 = ((2u * _e122) + _e302);
                            if (_e419 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e423 = coefs.member[_e419];
                            let _e428 = (_e312 + _e419);
                            if (_e428 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e432 = coefs.member[_e428];
                            let _e437 = (_e322 + _e419);
                            if (_e437 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e441 = coefs.member[_e437];
                            let _e446 = (_e332 + _e419);
                            if (_e446 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e450 = coefs.member[_e446];
                            let _e455 = (_e342 + _e419);
                            if (_e455 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e459 = coefs.member[_e455];
                            let _e464 = (_e352 + _e419);
                            if (_e464 < _e59) {
                            } else {
                                phi_4999_ = true;
                                break;
                            }
                            let _e468 = coefs.member[_e464];
                            phi_776_ = (_e238 + _e293);
                            phi_777_ = array<array<f32, 6>, 3>(array<f32, 6>((_e240[0][0] + (_e307 * _e293)), (_e240[0][1] + (_e317 * _e293)), (_e240[0][2] + (_e327 * _e293)), (_e240[0][3] + (_e337 * _e293)), (_e240[0][4] + (_e347 * _e293)), (_e240[0][5] + (_e357 * _e293))), array<f32, 6>((_e240[1][0] + (_e367 * _e293)), (_e240[1][1] + (_e376 * _e293)), (_e240[1][2] + (_e385 * _e293)), (_e240[1][3] + (_e394 * _e293)), (_e240[1][4] + (_e403 * _e293)), (_e240[1][5] + (_e412 * _e293))), array<f32, 6>((_e240[2][0] + (_e423 * _e293)), (_e240[2][1] + (_e432 * _e293)), (_e240[2][2] + (_e441 * _e293)), (_e240[2][3] + (_e450 * _e293)), (_e240[2][4] + (_e459 * _e293)), (_e240[2][5] + (_e468 * _e293))));
                        } else {
                            phi_776_ = _e238;
                            phi_777_ = _e240;
                        }
                        let _e476 = phi_776_;
                        let _e478 = phi_777_;
                        phi_376_ = _e476;
                        phi_378_ = _e478;
                    } else {
                        phi_376_ = f32();
                        phi_378_ = array<array<f32, 6>, 3>();
                    }
                    let _e480 = phi_376_;
                    let _e482 = phi_378_;
                    continue;
                    continuing {
                        phi_372_ = _e253;
                        phi_375_ = _e480;
                        phi_377_ = _e482;
                        phi_4999_ = false;
                        break if !(_e259);
                    }
                }
                let _e485 = phi_4999_;
                if _e485 {
                    break;
                }
                let _e487 = local;
                if (_e487 > 0f) {
                    let _e490 = local_1;
                    phi_783_ = (1f / _e490);
                } else {
                    phi_783_ = 0f;
                }
                let _e493 = phi_783_;
                let _e495 = local_2;
                let _e500 = local_3;
                let _e505 = local_4;
                let _e510 = local_5;
                let _e515 = local_6;
                let _e520 = local_7;
                let _e525 = local_8;
                let _e530 = local_9;
                let _e535 = local_10;
                let _e540 = local_11;
                let _e545 = local_12;
                let _e550 = local_13;
                let _e555 = local_14;
                let _e560 = local_15;
                let _e565 = local_16;
                let _e570 = local_17;
                let _e575 = local_18;
                let _e580 = local_19;
                let _e585 = ((0.6666667f / _e99.w) / _e99.w);
                let _e586 = -(_e96.x);
                let _e587 = -(_e96.y);
                let _e590 = (_e96.z * -1.0233268f);
                let _e596 = ((((_e96.z * -1.9364917f) * (_e96.z * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                let _e599 = (_e96.x * -1.0233268f);
                let _e602 = (_e96.y * -1.0233268f);
                let _e608 = (((_e586 * _e586) - (_e587 * _e587)) * 0.4290428f);
                let _e610 = (((((((_e495[0][0] * _e493) * 0.886227f) + ((_e505[0][2] * _e493) * _e590)) + ((_e515[0][4] * _e493) * _e596)) + ((_e510[0][3] * _e493) * _e599)) + ((_e500[0][1] * _e493) * _e602)) + ((_e520[0][5] * _e493) * _e608));
                let _e623 = (((((((_e525[1][0] * _e493) * 0.886227f) + ((_e535[1][2] * _e493) * _e590)) + ((_e545[1][4] * _e493) * _e596)) + ((_e540[1][3] * _e493) * _e599)) + ((_e530[1][1] * _e493) * _e602)) + ((_e550[1][5] * _e493) * _e608));
                let _e636 = (((((((_e555[2][0] * _e493) * 0.886227f) + ((_e565[2][2] * _e493) * _e590)) + ((_e575[2][4] * _e493) * _e596)) + ((_e570[2][3] * _e493) * _e599)) + ((_e560[2][1] * _e493) * _e602)) + ((_e580[2][5] * _e493) * _e608));
                let _e645 = facets.member[_e70].member_1;
                let _e648 = params.member.member_13;
                let _e650 = ((_e645 * _e648) * _e648);
                let _e654 = facets.member[_e70].member_4;
                let _e661 = ((_e654[0] * (select(0f, _e610, (_e610 > 0f)) * _e585)) * _e650);
                let _e662 = ((_e654[1] * (select(0f, _e623, (_e623 > 0f)) * _e585)) * _e650);
                let _e663 = ((_e654[2] * (select(0f, _e636, (_e636 > 0f)) * _e585)) * _e650);
                let _e670 = floor((_e130 + (_e96.x * 0.515625f)));
                let _e678 = floor((_e131 + (_e96.y * 0.515625f)));
                let _e686 = floor((_e132 + (_e96.z * 0.515625f)));
                let _e694 = (select(0i, select(select(i32(_e670), i32(-2147483648), (_e670 < -2147483600f)), 2147483647i, (_e670 > 2147483500f)), (_e670 == _e670)) - _e102.x);
                let _e695 = (select(0i, select(select(i32(_e678), i32(-2147483648), (_e678 < -2147483600f)), 2147483647i, (_e678 > 2147483500f)), (_e678 == _e678)) - _e102.y);
                let _e696 = (select(0i, select(select(i32(_e686), i32(-2147483648), (_e686 < -2147483600f)), 2147483647i, (_e686 > 2147483500f)), (_e686 == _e686)) - _e102.z);
                if (_e694 >= 0i) {
                    if (_e695 >= 0i) {
                        if (_e696 >= 0i) {
                            if (_e694 < _e147) {
                                let _e701 = (_e695 < _e177);
                                if _e701 {
                                    phi_3178_ = (_e696 < _e207);
                                } else {
                                    phi_3178_ = bool();
                                }
                                let _e704 = phi_3178_;
                                phi_3180_ = _e704;
                                phi_3181_ = select(true, false, _e701);
                            } else {
                                phi_3180_ = bool();
                                phi_3181_ = true;
                            }
                            let _e707 = phi_3180_;
                            let _e709 = phi_3181_;
                            phi_3182_ = _e707;
                            phi_3183_ = _e709;
                        } else {
                            phi_3182_ = bool();
                            phi_3183_ = true;
                        }
                        let _e711 = phi_3182_;
                        let _e713 = phi_3183_;
                        phi_3184_ = _e711;
                        phi_3185_ = _e713;
                    } else {
                        phi_3184_ = bool();
                        phi_3185_ = true;
                    }
                    let _e715 = phi_3184_;
                    let _e717 = phi_3185_;
                    phi_3186_ = _e715;
                    phi_3187_ = _e717;
                } else {
                    phi_3186_ = bool();
                    phi_3187_ = true;
                }
                let _e719 = phi_3186_;
                let _e721 = phi_3187_;
                if select(_e719, false, _e721) {
                    let _e730 = (((_e118 + bitcast<u32>(_e694)) + (bitcast<u32>(_e695) * _e114)) + (bitcast<u32>(_e696) * _e117));
                    let _e733 = params.member.member_16;
                    if (_e733 <= 1u) {
                        let _e1486 = params.member.member_7;
                        let _e1487 = (_e661 * _e1486);
                        let _e1489 = select(0f, _e1487, (_e1487 > 0f));
                        let _e1491 = select(1073741800f, _e1489, (_e1489 < 1073741800f));
                        let _e1492 = (3u * _e122);
                        let _e1494 = floor((_e1491 + 0.5f));
                        let _e1499 = select(select(u32(_e1494), 0u, (_e1494 < 0f)), 4294967295u, (_e1494 > 4294967000f));
                        if (_e1499 == 0u) {
                        } else {
                            if (_e730 < _e61) {
                            } else {
                                break;
                            }
                            let _e1504 = atomicAdd((&words.member[_e730]), _e1499);
                            if (_e1504 >= (1073741824u - select(_e1499, 1073741824u, (1073741824u < _e1499)))) {
                                let _e1512 = ((_e122 * 12u) * select(1u, _e733, (1u < _e733)));
                                if (_e1512 < _e61) {
                                } else {
                                    break;
                                }
                                let _e1516 = atomicOr((&words.member[_e1512]), 1u);
                            }
                            let _e1517 = (_e1491 * 0.6666667f);
                            let _e1521 = (_e730 + _e1492);
                            let _e1523 = floor(((_e96.x * _e1517) + 0.5f));
                            if (_e1521 < _e61) {
                            } else {
                                break;
                            }
                            let _e1535 = atomicAdd((&words.member[_e1521]), bitcast<u32>(select(0i, select(select(i32(_e1523), i32(-2147483648), (_e1523 < -2147483600f)), 2147483647i, (_e1523 > 2147483500f)), (_e1523 == _e1523))));
                            let _e1537 = (_e730 + (_e122 * 6u));
                            let _e1539 = floor(((_e96.y * _e1517) + 0.5f));
                            if (_e1537 < _e61) {
                            } else {
                                break;
                            }
                            let _e1551 = atomicAdd((&words.member[_e1537]), bitcast<u32>(select(0i, select(select(i32(_e1539), i32(-2147483648), (_e1539 < -2147483600f)), 2147483647i, (_e1539 > 2147483500f)), (_e1539 == _e1539))));
                            let _e1553 = (_e730 + (_e122 * 9u));
                            let _e1555 = floor(((_e96.z * _e1517) + 0.5f));
                            if (_e1553 < _e61) {
                            } else {
                                break;
                            }
                            let _e1567 = atomicAdd((&words.member[_e1553]), bitcast<u32>(select(0i, select(select(i32(_e1555), i32(-2147483648), (_e1555 < -2147483600f)), 2147483647i, (_e1555 > 2147483500f)), (_e1555 == _e1555))));
                        }
                        let _e1568 = (_e662 * _e1486);
                        let _e1570 = select(0f, _e1568, (_e1568 > 0f));
                        let _e1572 = select(1073741800f, _e1570, (_e1570 < 1073741800f));
                        let _e1573 = (_e122 + _e730);
                        let _e1575 = floor((_e1572 + 0.5f));
                        let _e1580 = select(select(u32(_e1575), 0u, (_e1575 < 0f)), 4294967295u, (_e1575 > 4294967000f));
                        if (_e1580 == 0u) {
                        } else {
                            if (_e1573 < _e61) {
                            } else {
                                break;
                            }
                            let _e1585 = atomicAdd((&words.member[_e1573]), _e1580);
                            if (_e1585 >= (1073741824u - select(_e1580, 1073741824u, (1073741824u < _e1580)))) {
                                let _e1593 = ((_e122 * 12u) * select(1u, _e733, (1u < _e733)));
                                if (_e1593 < _e61) {
                                } else {
                                    break;
                                }
                                let _e1597 = atomicOr((&words.member[_e1593]), 1u);
                            }
                            let _e1598 = (_e1572 * 0.6666667f);
                            let _e1602 = (_e1573 + _e1492);
                            let _e1604 = floor(((_e96.x * _e1598) + 0.5f));
                            if (_e1602 < _e61) {
                            } else {
                                break;
                            }
                            let _e1616 = atomicAdd((&words.member[_e1602]), bitcast<u32>(select(0i, select(select(i32(_e1604), i32(-2147483648), (_e1604 < -2147483600f)), 2147483647i, (_e1604 > 2147483500f)), (_e1604 == _e1604))));
                            let _e1618 = (_e1573 + (_e122 * 6u));
                            let _e1620 = floor(((_e96.y * _e1598) + 0.5f));
                            if (_e1618 < _e61) {
                            } else {
                                break;
                            }
                            let _e1632 = atomicAdd((&words.member[_e1618]), bitcast<u32>(select(0i, select(select(i32(_e1620), i32(-2147483648), (_e1620 < -2147483600f)), 2147483647i, (_e1620 > 2147483500f)), (_e1620 == _e1620))));
                            let _e1634 = (_e1573 + (_e122 * 9u));
                            let _e1636 = floor(((_e96.z * _e1598) + 0.5f));
                            if (_e1634 < _e61) {
                            } else {
                                break;
                            }
                            let _e1648 = atomicAdd((&words.member[_e1634]), bitcast<u32>(select(0i, select(select(i32(_e1636), i32(-2147483648), (_e1636 < -2147483600f)), 2147483647i, (_e1636 > 2147483500f)), (_e1636 == _e1636))));
                        }
                        let _e1649 = (_e663 * _e1486);
                        let _e1651 = select(0f, _e1649, (_e1649 > 0f));
                        let _e1653 = select(1073741800f, _e1651, (_e1651 < 1073741800f));
                        let _e1655 = ((2u * _e122) + _e730);
                        let _e1657 = floor((_e1653 + 0.5f));
                        let _e1662 = select(select(u32(_e1657), 0u, (_e1657 < 0f)), 4294967295u, (_e1657 > 4294967000f));
                        if (_e1662 == 0u) {
                        } else {
                            if (_e1655 < _e61) {
                            } else {
                                break;
                            }
                            let _e1667 = atomicAdd((&words.member[_e1655]), _e1662);
                            if (_e1667 >= (1073741824u - select(_e1662, 1073741824u, (1073741824u < _e1662)))) {
                                let _e1675 = ((_e122 * 12u) * select(1u, _e733, (1u < _e733)));
                                if (_e1675 < _e61) {
                                } else {
                                    break;
                                }
                                let _e1679 = atomicOr((&words.member[_e1675]), 1u);
                            }
                            let _e1680 = (_e1653 * 0.6666667f);
                            let _e1684 = (_e1655 + _e1492);
                            let _e1686 = floor(((_e96.x * _e1680) + 0.5f));
                            if (_e1684 < _e61) {
                            } else {
                                break;
                            }
                            let _e1698 = atomicAdd((&words.member[_e1684]), bitcast<u32>(select(0i, select(select(i32(_e1686), i32(-2147483648), (_e1686 < -2147483600f)), 2147483647i, (_e1686 > 2147483500f)), (_e1686 == _e1686))));
                            let _e1700 = (_e1655 + (_e122 * 6u));
                            let _e1702 = floor(((_e96.y * _e1680) + 0.5f));
                            if (_e1700 < _e61) {
                            } else {
                                break;
                            }
                            let _e1714 = atomicAdd((&words.member[_e1700]), bitcast<u32>(select(0i, select(select(i32(_e1702), i32(-2147483648), (_e1702 < -2147483600f)), 2147483647i, (_e1702 > 2147483500f)), (_e1702 == _e1702))));
                            let _e1716 = (_e1655 + (_e122 * 9u));
                            let _e1718 = floor(((_e96.z * _e1680) + 0.5f));
                            if (_e1716 < _e61) {
                            } else {
                                break;
                            }
                            let _e1730 = atomicAdd((&words.member[_e1716]), bitcast<u32>(select(0i, select(select(i32(_e1718), i32(-2147483648), (_e1718 < -2147483600f)), 2147483647i, (_e1718 > 2147483500f)), (_e1718 == _e1718))));
                        }
                    } else {
                        let _e735 = (3u * _e122);
                        let _e736 = (_e122 * 12u);
                        let _e740 = ((select(0u, 1u, (_e96.x < 0f)) * _e736) + _e730);
                        let _e741 = (_e96.x * _e96.x);
                        let _e747 = params.member.member_7;
                        let _e748 = ((_e661 * _e741) * _e747);
                        let _e750 = select(0f, _e748, (_e748 > 0f));
                        let _e752 = select(1073741800f, _e750, (_e750 < 1073741800f));
                        let _e754 = floor((_e752 + 0.5f));
                        let _e759 = select(select(u32(_e754), 0u, (_e754 < 0f)), 4294967295u, (_e754 > 4294967000f));
                        if (_e759 == 0u) {
                        } else {
                            if (_e740 < _e61) {
                            } else {
                                break;
                            }
                            let _e764 = atomicAdd((&words.member[_e740]), _e759);
                            if (_e764 >= (1073741824u - select(_e759, 1073741824u, (1073741824u < _e759)))) {
                                let _e771 = (_e736 * select(1u, _e733, (1u < _e733)));
                                if (_e771 < _e61) {
                                } else {
                                    break;
                                }
                                let _e775 = atomicOr((&words.member[_e771]), 1u);
                            }
                            let _e776 = (_e752 * 0.6666667f);
                            let _e780 = (_e740 + _e735);
                            let _e782 = floor(((_e96.x * _e776) + 0.5f));
                            if (_e780 < _e61) {
                            } else {
                                break;
                            }
                            let _e794 = atomicAdd((&words.member[_e780]), bitcast<u32>(select(0i, select(select(i32(_e782), i32(-2147483648), (_e782 < -2147483600f)), 2147483647i, (_e782 > 2147483500f)), (_e782 == _e782))));
                            let _e796 = (_e740 + (_e122 * 6u));
                            let _e798 = floor(((_e96.y * _e776) + 0.5f));
                            if (_e796 < _e61) {
                            } else {
                                break;
                            }
                            let _e810 = atomicAdd((&words.member[_e796]), bitcast<u32>(select(0i, select(select(i32(_e798), i32(-2147483648), (_e798 < -2147483600f)), 2147483647i, (_e798 > 2147483500f)), (_e798 == _e798))));
                            let _e812 = (_e740 + (_e122 * 9u));
                            let _e814 = floor(((_e96.z * _e776) + 0.5f));
                            if (_e812 < _e61) {
                            } else {
                                break;
                            }
                            let _e826 = atomicAdd((&words.member[_e812]), bitcast<u32>(select(0i, select(select(i32(_e814), i32(-2147483648), (_e814 < -2147483600f)), 2147483647i, (_e814 > 2147483500f)), (_e814 == _e814))));
                        }
                        let _e827 = ((_e662 * _e741) * _e747);
                        let _e829 = select(0f, _e827, (_e827 > 0f));
                        let _e831 = select(1073741800f, _e829, (_e829 < 1073741800f));
                        let _e832 = (_e122 + _e740);
                        let _e834 = floor((_e831 + 0.5f));
                        let _e839 = select(select(u32(_e834), 0u, (_e834 < 0f)), 4294967295u, (_e834 > 4294967000f));
                        if (_e839 == 0u) {
                        } else {
                            if (_e832 < _e61) {
                            } else {
                                break;
                            }
                            let _e844 = atomicAdd((&words.member[_e832]), _e839);
                            if (_e844 >= (1073741824u - select(_e839, 1073741824u, (1073741824u < _e839)))) {
                                let _e851 = (_e736 * select(1u, _e733, (1u < _e733)));
                                if (_e851 < _e61) {
                                } else {
                                    break;
                                }
                                let _e855 = atomicOr((&words.member[_e851]), 1u);
                            }
                            let _e856 = (_e831 * 0.6666667f);
                            let _e860 = (_e832 + _e735);
                            let _e862 = floor(((_e96.x * _e856) + 0.5f));
                            if (_e860 < _e61) {
                            } else {
                                break;
                            }
                            let _e874 = atomicAdd((&words.member[_e860]), bitcast<u32>(select(0i, select(select(i32(_e862), i32(-2147483648), (_e862 < -2147483600f)), 2147483647i, (_e862 > 2147483500f)), (_e862 == _e862))));
                            let _e876 = (_e832 + (_e122 * 6u));
                            let _e878 = floor(((_e96.y * _e856) + 0.5f));
                            if (_e876 < _e61) {
                            } else {
                                break;
                            }
                            let _e890 = atomicAdd((&words.member[_e876]), bitcast<u32>(select(0i, select(select(i32(_e878), i32(-2147483648), (_e878 < -2147483600f)), 2147483647i, (_e878 > 2147483500f)), (_e878 == _e878))));
                            let _e892 = (_e832 + (_e122 * 9u));
                            let _e894 = floor(((_e96.z * _e856) + 0.5f));
                            if (_e892 < _e61) {
                            } else {
                                break;
                            }
                            let _e906 = atomicAdd((&words.member[_e892]), bitcast<u32>(select(0i, select(select(i32(_e894), i32(-2147483648), (_e894 < -2147483600f)), 2147483647i, (_e894 > 2147483500f)), (_e894 == _e894))));
                        }
                        let _e907 = ((_e663 * _e741) * _e747);
                        let _e909 = select(0f, _e907, (_e907 > 0f));
                        let _e911 = select(1073741800f, _e909, (_e909 < 1073741800f));
                        let _e912 = (2u * _e122);
                        let _e913 = (_e912 + _e740);
                        let _e915 = floor((_e911 + 0.5f));
                        let _e920 = select(select(u32(_e915), 0u, (_e915 < 0f)), 4294967295u, (_e915 > 4294967000f));
                        if (_e920 == 0u) {
                        } else {
                            if (_e913 < _e61) {
                            } else {
                                break;
                            }
                            let _e925 = atomicAdd((&words.member[_e913]), _e920);
                            if (_e925 >= (1073741824u - select(_e920, 1073741824u, (1073741824u < _e920)))) {
                                let _e932 = (_e736 * select(1u, _e733, (1u < _e733)));
                                if (_e932 < _e61) {
                                } else {
                                    break;
                                }
                                let _e936 = atomicOr((&words.member[_e932]), 1u);
                            }
                            let _e937 = (_e911 * 0.6666667f);
                            let _e941 = (_e913 + _e735);
                            let _e943 = floor(((_e96.x * _e937) + 0.5f));
                            if (_e941 < _e61) {
                            } else {
                                break;
                            }
                            let _e955 = atomicAdd((&words.member[_e941]), bitcast<u32>(select(0i, select(select(i32(_e943), i32(-2147483648), (_e943 < -2147483600f)), 2147483647i, (_e943 > 2147483500f)), (_e943 == _e943))));
                            let _e957 = (_e913 + (_e122 * 6u));
                            let _e959 = floor(((_e96.y * _e937) + 0.5f));
                            if (_e957 < _e61) {
                            } else {
                                break;
                            }
                            let _e971 = atomicAdd((&words.member[_e957]), bitcast<u32>(select(0i, select(select(i32(_e959), i32(-2147483648), (_e959 < -2147483600f)), 2147483647i, (_e959 > 2147483500f)), (_e959 == _e959))));
                            let _e973 = (_e913 + (_e122 * 9u));
                            let _e975 = floor(((_e96.z * _e937) + 0.5f));
                            if (_e973 < _e61) {
                            } else {
                                break;
                            }
                            let _e987 = atomicAdd((&words.member[_e973]), bitcast<u32>(select(0i, select(select(i32(_e975), i32(-2147483648), (_e975 < -2147483600f)), 2147483647i, (_e975 > 2147483500f)), (_e975 == _e975))));
                        }
                        let _e992 = (((2u + select(0u, 1u, (_e96.y < 0f))) * _e736) + _e730);
                        let _e993 = (_e96.y * _e96.y);
                        let _e997 = ((_e661 * _e993) * _e747);
                        let _e999 = select(0f, _e997, (_e997 > 0f));
                        let _e1001 = select(1073741800f, _e999, (_e999 < 1073741800f));
                        let _e1003 = floor((_e1001 + 0.5f));
                        let _e1008 = select(select(u32(_e1003), 0u, (_e1003 < 0f)), 4294967295u, (_e1003 > 4294967000f));
                        if (_e1008 == 0u) {
                        } else {
                            if (_e992 < _e61) {
                            } else {
                                break;
                            }
                            let _e1013 = atomicAdd((&words.member[_e992]), _e1008);
                            if (_e1013 >= (1073741824u - select(_e1008, 1073741824u, (1073741824u < _e1008)))) {
                                let _e1020 = (_e736 * select(1u, _e733, (1u < _e733)));
                                if (_e1020 < _e61) {
                                } else {
                                    break;
                                }
                                let _e1024 = atomicOr((&words.member[_e1020]), 1u);
                            }
                            let _e1025 = (_e1001 * 0.6666667f);
                            let _e1029 = (_e992 + _e735);
                            let _e1031 = floor(((_e96.x * _e1025) + 0.5f));
                            if (_e1029 < _e61) {
                            } else {
                                break;
                            }
                            let _e1043 = atomicAdd((&words.member[_e1029]), bitcast<u32>(select(0i, select(select(i32(_e1031), i32(-2147483648), (_e1031 < -2147483600f)), 2147483647i, (_e1031 > 2147483500f)), (_e1031 == _e1031))));
                            let _e1045 = (_e992 + (_e122 * 6u));
                            let _e1047 = floor(((_e96.y * _e1025) + 0.5f));
                            if (_e1045 < _e61) {
                            } else {
                                break;
                            }
                            let _e1059 = atomicAdd((&words.member[_e1045]), bitcast<u32>(select(0i, select(select(i32(_e1047), i32(-2147483648), (_e1047 < -2147483600f)), 2147483647i, (_e1047 > 2147483500f)), (_e1047 == _e1047))));
                            let _e1061 = (_e992 + (_e122 * 9u));
                            let _e1063 = floor(((_e96.z * _e1025) + 0.5f));
                            if (_e1061 < _e61) {
                            } else {
                                break;
                            }
                            let _e1075 = atomicAdd((&words.member[_e1061]), bitcast<u32>(select(0i, select(select(i32(_e1063), i32(-2147483648), (_e1063 < -2147483600f)), 2147483647i, (_e1063 > 2147483500f)), (_e1063 == _e1063))));
                        }
                        let _e1076 = ((_e662 * _e993) * _e747);
                        let _e1078 = select(0f, _e1076, (_e1076 > 0f));
                        let _e1080 = select(1073741800f, _e1078, (_e1078 < 1073741800f));
                        let _e1081 = (_e122 + _e992);
                        let _e1083 = floor((_e1080 + 0.5f));
                        let _e1088 = select(select(u32(_e1083), 0u, (_e1083 < 0f)), 4294967295u, (_e1083 > 4294967000f));
                        if (_e1088 == 0u) {
                        } else {
                            if (_e1081 < _e61) {
                            } else {
                                break;
                            }
                            let _e1093 = atomicAdd((&words.member[_e1081]), _e1088);
                            if (_e1093 >= (1073741824u - select(_e1088, 1073741824u, (1073741824u < _e1088)))) {
                                let _e1100 = (_e736 * select(1u, _e733, (1u < _e733)));
                                if (_e1100 < _e61) {
                                } else {
                                    break;
                                }
                                let _e1104 = atomicOr((&words.member[_e1100]), 1u);
                            }
                            let _e1105 = (_e1080 * 0.6666667f);
                            let _e1109 = (_e1081 + _e735);
                            let _e1111 = floor(((_e96.x * _e1105) + 0.5f));
                            if (_e1109 < _e61) {
                            } else {
                                break;
                            }
                            let _e1123 = atomicAdd((&words.member[_e1109]), bitcast<u32>(select(0i, select(select(i32(_e1111), i32(-2147483648), (_e1111 < -2147483600f)), 2147483647i, (_e1111 > 2147483500f)), (_e1111 == _e1111))));
                            let _e1125 = (_e1081 + (_e122 * 6u));
                            let _e1127 = floor(((_e96.y * _e1105) + 0.5f));
                            if (_e1125 < _e61) {
                            } else {
                                break;
                            }
                            let _e1139 = atomicAdd((&words.member[_e1125]), bitcast<u32>(select(0i, select(select(i32(_e1127), i32(-2147483648), (_e1127 < -2147483600f)), 2147483647i, (_e1127 > 2147483500f)), (_e1127 == _e1127))));
                            let _e1141 = (_e1081 + (_e122 * 9u));
                            let _e1143 = floor(((_e96.z * _e1105) + 0.5f));
                            if (_e1141 < _e61) {
                            } else {
                                break;
                            }
                            let _e1155 = atomicAdd((&words.member[_e1141]), bitcast<u32>(select(0i, select(select(i32(_e1143), i32(-2147483648), (_e1143 < -2147483600f)), 2147483647i, (_e1143 > 2147483500f)), (_e1143 == _e1143))));
                        }
                        let _e1156 = ((_e663 * _e993) * _e747);
                        let _e1158 = select(0f, _e1156, (_e1156 > 0f));
                        let _e1160 = select(1073741800f, _e1158, (_e1158 < 1073741800f));
                        let _e1161 = (_e912 + _e992);
                        let _e1163 = floor((_e1160 + 0.5f));
                        let _e1168 = select(select(u32(_e1163), 0u, (_e1163 < 0f)), 4294967295u, (_e1163 > 4294967000f));
                        if (_e1168 == 0u) {
                        } else {
                            if (_e1161 < _e61) {
                            } else {
                                break;
                            }
                            let _e1173 = atomicAdd((&words.member[_e1161]), _e1168);
                            if (_e1173 >= (1073741824u - select(_e1168, 1073741824u, (1073741824u < _e1168)))) {
                                let _e1180 = (_e736 * select(1u, _e733, (1u < _e733)));
                                if (_e1180 < _e61) {
                                } else {
                                    break;
                                }
                                let _e1184 = atomicOr((&words.member[_e1180]), 1u);
                            }
                            let _e1185 = (_e1160 * 0.6666667f);
                            let _e1189 = (_e1161 + _e735);
                            let _e1191 = floor(((_e96.x * _e1185) + 0.5f));
                            if (_e1189 < _e61) {
                            } else {
                                break;
                            }
                            let _e1203 = atomicAdd((&words.member[_e1189]), bitcast<u32>(select(0i, select(select(i32(_e1191), i32(-2147483648), (_e1191 < -2147483600f)), 2147483647i, (_e1191 > 2147483500f)), (_e1191 == _e1191))));
                            let _e1205 = (_e1161 + (_e122 * 6u));
                            let _e1207 = floor(((_e96.y * _e1185) + 0.5f));
                            if (_e1205 < _e61) {
                            } else {
                                break;
                            }
                            let _e1219 = atomicAdd((&words.member[_e1205]), bitcast<u32>(select(0i, select(select(i32(_e1207), i32(-2147483648), (_e1207 < -2147483600f)), 2147483647i, (_e1207 > 2147483500f)), (_e1207 == _e1207))));
                            let _e1221 = (_e1161 + (_e122 * 9u));
                            let _e1223 = floor(((_e96.z * _e1185) + 0.5f));
                            if (_e1221 < _e61) {
                            } else {
                                break;
                            }
                            let _e1235 = atomicAdd((&words.member[_e1221]), bitcast<u32>(select(0i, select(select(i32(_e1223), i32(-2147483648), (_e1223 < -2147483600f)), 2147483647i, (_e1223 > 2147483500f)), (_e1223 == _e1223))));
                        }
                        let _e1240 = (((4u + select(0u, 1u, (_e96.z < 0f))) * _e736) + _e730);
                        let _e1241 = (_e96.z * _e96.z);
                        let _e1245 = ((_e661 * _e1241) * _e747);
                        let _e1247 = select(0f, _e1245, (_e1245 > 0f));
                        let _e1249 = select(1073741800f, _e1247, (_e1247 < 1073741800f));
                        let _e1251 = floor((_e1249 + 0.5f));
                        let _e1256 = select(select(u32(_e1251), 0u, (_e1251 < 0f)), 4294967295u, (_e1251 > 4294967000f));
                        if (_e1256 == 0u) {
                        } else {
                            if (_e1240 < _e61) {
                            } else {
                                break;
                            }
                            let _e1261 = atomicAdd((&words.member[_e1240]), _e1256);
                            if (_e1261 >= (1073741824u - select(_e1256, 1073741824u, (1073741824u < _e1256)))) {
                                let _e1268 = (_e736 * select(1u, _e733, (1u < _e733)));
                                if (_e1268 < _e61) {
                                } else {
                                    break;
                                }
                                let _e1272 = atomicOr((&words.member[_e1268]), 1u);
                            }
                            let _e1273 = (_e1249 * 0.6666667f);
                            let _e1277 = (_e1240 + _e735);
                            let _e1279 = floor(((_e96.x * _e1273) + 0.5f));
                            if (_e1277 < _e61) {
                            } else {
                                break;
                            }
                            let _e1291 = atomicAdd((&words.member[_e1277]), bitcast<u32>(select(0i, select(select(i32(_e1279), i32(-2147483648), (_e1279 < -2147483600f)), 2147483647i, (_e1279 > 2147483500f)), (_e1279 == _e1279))));
                            let _e1293 = (_e1240 + (_e122 * 6u));
                            let _e1295 = floor(((_e96.y * _e1273) + 0.5f));
                            if (_e1293 < _e61) {
                            } else {
                                break;
                            }
                            let _e1307 = atomicAdd((&words.member[_e1293]), bitcast<u32>(select(0i, select(select(i32(_e1295), i32(-2147483648), (_e1295 < -2147483600f)), 2147483647i, (_e1295 > 2147483500f)), (_e1295 == _e1295))));
                            let _e1309 = (_e1240 + (_e122 * 9u));
                            let _e1311 = floor(((_e96.z * _e1273) + 0.5f));
                            if (_e1309 < _e61) {
                            } else {
                                break;
                            }
                            let _e1323 = atomicAdd((&words.member[_e1309]), bitcast<u32>(select(0i, select(select(i32(_e1311), i32(-2147483648), (_e1311 < -2147483600f)), 2147483647i, (_e1311 > 2147483500f)), (_e1311 == _e1311))));
                        }
                        let _e1324 = ((_e662 * _e1241) * _e747);
                        let _e1326 = select(0f, _e1324, (_e1324 > 0f));
                        let _e1328 = select(1073741800f, _e1326, (_e1326 < 1073741800f));
                        let _e1329 = (_e122 + _e1240);
                        let _e1331 = floor((_e1328 + 0.5f));
                        let _e1336 = select(select(u32(_e1331), 0u, (_e1331 < 0f)), 4294967295u, (_e1331 > 4294967000f));
                        if (_e1336 == 0u) {
                        } else {
                            if (_e1329 < _e61) {
                            } else {
                                break;
                            }
                            let _e1341 = atomicAdd((&words.member[_e1329]), _e1336);
                            if (_e1341 >= (1073741824u - select(_e1336, 1073741824u, (1073741824u < _e1336)))) {
                                let _e1348 = (_e736 * select(1u, _e733, (1u < _e733)));
                                if (_e1348 < _e61) {
                                } else {
                                    break;
                                }
                                let _e1352 = atomicOr((&words.member[_e1348]), 1u);
                            }
                            let _e1353 = (_e1328 * 0.6666667f);
                            let _e1357 = (_e1329 + _e735);
                            let _e1359 = floor(((_e96.x * _e1353) + 0.5f));
                            if (_e1357 < _e61) {
                            } else {
                                break;
                            }
                            let _e1371 = atomicAdd((&words.member[_e1357]), bitcast<u32>(select(0i, select(select(i32(_e1359), i32(-2147483648), (_e1359 < -2147483600f)), 2147483647i, (_e1359 > 2147483500f)), (_e1359 == _e1359))));
                            let _e1373 = (_e1329 + (_e122 * 6u));
                            let _e1375 = floor(((_e96.y * _e1353) + 0.5f));
                            if (_e1373 < _e61) {
                            } else {
                                break;
                            }
                            let _e1387 = atomicAdd((&words.member[_e1373]), bitcast<u32>(select(0i, select(select(i32(_e1375), i32(-2147483648), (_e1375 < -2147483600f)), 2147483647i, (_e1375 > 2147483500f)), (_e1375 == _e1375))));
                            let _e1389 = (_e1329 + (_e122 * 9u));
                            let _e1391 = floor(((_e96.z * _e1353) + 0.5f));
                            if (_e1389 < _e61) {
                            } else {
                                break;
                            }
                            let _e1403 = atomicAdd((&words.member[_e1389]), bitcast<u32>(select(0i, select(select(i32(_e1391), i32(-2147483648), (_e1391 < -2147483600f)), 2147483647i, (_e1391 > 2147483500f)), (_e1391 == _e1391))));
                        }
                        let _e1404 = ((_e663 * _e1241) * _e747);
                        let _e1406 = select(0f, _e1404, (_e1404 > 0f));
                        let _e1408 = select(1073741800f, _e1406, (_e1406 < 1073741800f));
                        let _e1409 = (_e912 + _e1240);
                        let _e1411 = floor((_e1408 + 0.5f));
                        let _e1416 = select(select(u32(_e1411), 0u, (_e1411 < 0f)), 4294967295u, (_e1411 > 4294967000f));
                        if (_e1416 == 0u) {
                        } else {
                            if (_e1409 < _e61) {
                            } else {
                                break;
                            }
                            let _e1421 = atomicAdd((&words.member[_e1409]), _e1416);
                            if (_e1421 >= (1073741824u - select(_e1416, 1073741824u, (1073741824u < _e1416)))) {
                                let _e1428 = (_e736 * select(1u, _e733, (1u < _e733)));
                                if (_e1428 < _e61) {
                                } else {
                                    break;
                                }
                                let _e1432 = atomicOr((&words.member[_e1428]), 1u);
                            }
                            let _e1433 = (_e1408 * 0.6666667f);
                            let _e1437 = (_e1409 + _e735);
                            let _e1439 = floor(((_e96.x * _e1433) + 0.5f));
                            if (_e1437 < _e61) {
                            } else {
                                break;
                            }
                            let _e1451 = atomicAdd((&words.member[_e1437]), bitcast<u32>(select(0i, select(select(i32(_e1439), i32(-2147483648), (_e1439 < -2147483600f)), 2147483647i, (_e1439 > 2147483500f)), (_e1439 == _e1439))));
                            let _e1453 = (_e1409 + (_e122 * 6u));
                            let _e1455 = floor(((_e96.y * _e1433) + 0.5f));
                            if (_e1453 < _e61) {
                            } else {
                                break;
                            }
                            let _e1467 = atomicAdd((&words.member[_e1453]), bitcast<u32>(select(0i, select(select(i32(_e1455), i32(-2147483648), (_e1455 < -2147483600f)), 2147483647i, (_e1455 > 2147483500f)), (_e1455 == _e1455))));
                            let _e1469 = (_e1409 + (_e122 * 9u));
                            let _e1471 = floor(((_e96.z * _e1433) + 0.5f));
                            if (_e1469 < _e61) {
                            } else {
                                break;
                            }
                            let _e1483 = atomicAdd((&words.member[_e1469]), bitcast<u32>(select(0i, select(select(i32(_e1471), i32(-2147483648), (_e1471 < -2147483600f)), 2147483647i, (_e1471 > 2147483500f)), (_e1471 == _e1471))));
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
