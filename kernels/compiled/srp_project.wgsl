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
    member_3: u32,
    member_4: f32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_14 {
    member: type_13,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> table: type_5;
@group(0) @binding(0) 
var<uniform> params: type_14;
@group(0) @binding(2) 
var<storage> light: type_5;
@group(0) @binding(3) 
var<storage, read_write> partial: type_5;

fn function_() {
    var local: array<f32, 24>;
    var phi_88_: u32;
    var phi_106_: u32;
    var phi_124_: u32;
    var phi_186_: u32;
    var phi_204_: u32;
    var phi_222_: u32;
    var phi_258_: type_11;
    var phi_261_: u32;
    var phi_263_: u32;
    var phi_265_: array<f32, 24>;
    var phi_259_: type_11;
    var phi_288_: type_11;
    var phi_262_: u32;
    var phi_264_: u32;
    var phi_266_: array<f32, 24>;
    var phi_549_: bool;
    var local_1: array<f32, 24>;
    var local_2: array<f32, 24>;
    var local_3: array<f32, 24>;
    var local_4: array<f32, 24>;
    var local_5: array<f32, 24>;
    var local_6: array<f32, 24>;
    var local_7: array<f32, 24>;
    var local_8: array<f32, 24>;
    var local_9: array<f32, 24>;
    var local_10: array<f32, 24>;
    var local_11: array<f32, 24>;
    var local_12: array<f32, 24>;
    var local_13: array<f32, 24>;
    var local_14: array<f32, 24>;
    var local_15: array<f32, 24>;
    var local_16: array<f32, 24>;
    var local_17: array<f32, 24>;
    var local_18: array<f32, 24>;
    var local_19: array<f32, 24>;
    var local_20: array<f32, 24>;
    var local_21: array<f32, 24>;
    var local_22: array<f32, 24>;
    var local_23: array<f32, 24>;
    var local_24: array<f32, 24>;
    var phi_493_: type_11;
    var phi_494_: type_11;
    var phi_517_: type_11;
    var phi_561_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = gid_1;
            let _e30 = arrayLength((&table.member));
            let _e35 = params.member.member_3;
            let _e37 = select(_e35, 16u, (_e35 == 0u));
            let _e40 = params.member.member;
            let _e41 = (_e40 / 16u);
            let _e43 = ((_e40 % 16u) > 0u);
            if _e43 {
                phi_88_ = (_e41 + 1u);
            } else {
                phi_88_ = _e41;
            }
            let _e46 = phi_88_;
            let _e49 = params.member.member_2;
            let _e50 = (_e49 / 8u);
            let _e52 = ((_e49 % 8u) > 0u);
            if _e52 {
                phi_106_ = (_e50 + 1u);
            } else {
                phi_106_ = _e50;
            }
            let _e55 = phi_106_;
            let _e58 = params.member.member_1;
            let _e59 = (_e37 == 0u);
            if _e59 {
                break;
            }
            let _e60 = (_e58 / _e37);
            if _e59 {
                break;
            }
            let _e62 = ((_e58 % _e37) > 0u);
            if _e62 {
                phi_124_ = (_e60 + 1u);
            } else {
                phi_124_ = _e60;
            }
            let _e65 = phi_124_;
            let _e66 = (_e46 * _e55);
            let _e69 = params.member.member_6;
            let _e73 = params.member.member_5;
            let _e82 = (_e28.x + (_e28.y * 2097152u));
            if (_e82 < ((_e69 * _e66) * 16u)) {
                let _e85 = (_e82 / 16u);
                let _e86 = (_e85 * 16u);
                let _e87 = (_e82 - _e86);
                if _e43 {
                    phi_186_ = (_e41 + 1u);
                } else {
                    phi_186_ = _e41;
                }
                let _e92 = phi_186_;
                if _e52 {
                    phi_204_ = (_e50 + 1u);
                } else {
                    phi_204_ = _e50;
                }
                let _e95 = phi_204_;
                if _e59 {
                    break;
                }
                if _e59 {
                    break;
                }
                if _e62 {
                    phi_222_ = (_e60 + 1u);
                } else {
                    phi_222_ = _e60;
                }
                let _e98 = phi_222_;
                if (_e95 == 0u) {
                    break;
                }
                let _e100 = (_e85 / _e95);
                if (_e92 == 0u) {
                    break;
                }
                let _e107 = (((_e92 * _e37) * 16u) * _e69);
                let _e111 = ((_e85 - (_e100 * _e95)) * 8u);
                phi_258_ = type_11(0u, _e37);
                phi_261_ = (((_e37 * (((_e111 / 8u) * _e98) + (_e73 + (_e100 / _e92)))) * 8u) + (_e111 % 8u));
                phi_263_ = (((_e100 * _e37) * 16u) + _e87);
                phi_265_ = array<f32, 24>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e122 = phi_258_;
                    let _e124 = phi_261_;
                    let _e126 = phi_263_;
                    let _e128 = phi_265_;
                    local_1 = _e128;
                    local_2 = _e128;
                    local_3 = _e128;
                    local_4 = _e128;
                    local_5 = _e128;
                    local_6 = _e128;
                    local_7 = _e128;
                    local_8 = _e128;
                    local_9 = _e128;
                    local_10 = _e128;
                    local_11 = _e128;
                    local_12 = _e128;
                    local_13 = _e128;
                    local_14 = _e128;
                    local_15 = _e128;
                    local_16 = _e128;
                    local_17 = _e128;
                    local_18 = _e128;
                    local_19 = _e128;
                    local_20 = _e128;
                    local_21 = _e128;
                    local_22 = _e128;
                    local_23 = _e128;
                    local_24 = _e128;
                    if (_e122.member < _e122.member_1) {
                        phi_259_ = type_11((_e122.member + 1u), _e122.member_1);
                        phi_288_ = type_11(1u, _e122.member);
                    } else {
                        phi_259_ = _e122;
                        phi_288_ = type_11(0u, type_11().member_1);
                    }
                    let _e141 = phi_259_;
                    let _e143 = phi_288_;
                    let _e146 = (bitcast<i32>(_e143.member) != 0i);
                    if _e146 {
                        let _e149 = light.member[_e126];
                        let _e153 = light.member[(_e107 + _e126)];
                        let _e158 = light.member[((2u * _e107) + _e126)];
                        if (_e124 < _e30) {
                        } else {
                            phi_549_ = true;
                            break;
                        }
                        let _e162 = table.member[_e124];
                        let _e172 = (_e124 + 1u);
                        if (_e172 < _e30) {
                        } else {
                            phi_549_ = true;
                            break;
                        }
                        let _e176 = table.member[_e172];
                        let _e186 = (_e124 + 2u);
                        if (_e186 < _e30) {
                        } else {
                            phi_549_ = true;
                            break;
                        }
                        let _e190 = table.member[_e186];
                        let _e200 = (_e124 + 3u);
                        if (_e200 < _e30) {
                        } else {
                            phi_549_ = true;
                            break;
                        }
                        let _e204 = table.member[_e200];
                        let _e214 = (_e124 + 4u);
                        if (_e214 < _e30) {
                        } else {
                            phi_549_ = true;
                            break;
                        }
                        let _e218 = table.member[_e214];
                        let _e228 = (_e124 + 5u);
                        if (_e228 < _e30) {
                        } else {
                            phi_549_ = true;
                            break;
                        }
                        let _e232 = table.member[_e228];
                        let _e242 = (_e124 + 6u);
                        if (_e242 < _e30) {
                        } else {
                            phi_549_ = true;
                            break;
                        }
                        let _e246 = table.member[_e242];
                        let _e256 = (_e124 + 7u);
                        if (_e256 < _e30) {
                        } else {
                            phi_549_ = true;
                            break;
                        }
                        let _e260 = table.member[_e256];
                        phi_262_ = (_e124 + 8u);
                        phi_264_ = (_e126 + 16u);
                        phi_266_ = array<f32, 24>((_e128[0] + (_e149 * _e162)), (_e128[1] + (_e149 * _e176)), (_e128[2] + (_e149 * _e190)), (_e128[3] + (_e149 * _e204)), (_e128[4] + (_e149 * _e218)), (_e128[5] + (_e149 * _e232)), (_e128[6] + (_e149 * _e246)), (_e128[7] + (_e149 * _e260)), (_e128[8] + (_e153 * _e162)), (_e128[9] + (_e153 * _e176)), (_e128[10] + (_e153 * _e190)), (_e128[11] + (_e153 * _e204)), (_e128[12] + (_e153 * _e218)), (_e128[13] + (_e153 * _e232)), (_e128[14] + (_e153 * _e246)), (_e128[15] + (_e153 * _e260)), (_e128[16] + (_e158 * _e162)), (_e128[17] + (_e158 * _e176)), (_e128[18] + (_e158 * _e190)), (_e128[19] + (_e158 * _e204)), (_e128[20] + (_e158 * _e218)), (_e128[21] + (_e158 * _e232)), (_e128[22] + (_e158 * _e246)), (_e128[23] + (_e158 * _e260)));
                    } else {
                        phi_262_ = u32();
                        phi_264_ = u32();
                        phi_266_ = array<f32, 24>();
                    }
                    let _e274 = phi_262_;
                    let _e276 = phi_264_;
                    let _e278 = phi_266_;
                    continue;
                    continuing {
                        phi_258_ = _e141;
                        phi_261_ = _e274;
                        phi_263_ = _e276;
                        phi_265_ = _e278;
                        phi_549_ = false;
                        break if !(_e146);
                    }
                }
                let _e281 = phi_549_;
                if _e281 {
                    break;
                }
                let _e283 = local_1;
                let _e286 = local_2;
                let _e289 = local_3;
                let _e292 = local_4;
                let _e295 = local_5;
                let _e298 = local_6;
                let _e301 = local_7;
                let _e304 = local_8;
                let _e307 = local_9;
                let _e310 = local_10;
                let _e313 = local_11;
                let _e316 = local_12;
                let _e319 = local_13;
                let _e322 = local_14;
                let _e325 = local_15;
                let _e328 = local_16;
                let _e331 = local_17;
                let _e334 = local_18;
                let _e337 = local_19;
                let _e340 = local_20;
                let _e343 = local_21;
                let _e346 = local_22;
                let _e349 = local_23;
                let _e352 = local_24;
                local = array<f32, 24>(_e283[0], _e286[1], _e289[2], _e292[3], _e295[4], _e298[5], _e301[6], _e304[7], _e307[8], _e310[9], _e313[10], _e316[11], _e319[12], _e322[13], _e325[14], _e328[15], _e331[16], _e334[17], _e337[18], _e340[19], _e343[20], _e346[21], _e349[22], _e352[23]);
                phi_493_ = type_11(0u, 24u);
                loop {
                    let _e356 = phi_493_;
                    if (_e356.member < _e356.member_1) {
                        phi_494_ = type_11((_e356.member + 1u), _e356.member_1);
                        phi_517_ = type_11(1u, _e356.member);
                    } else {
                        phi_494_ = _e356;
                        phi_517_ = type_11(0u, type_11().member_1);
                    }
                    let _e369 = phi_494_;
                    let _e371 = phi_517_;
                    let _e375 = (bitcast<i32>(_e371.member) != 0i);
                    if _e375 {
                        if (_e371.member_1 < 24u) {
                        } else {
                            phi_561_ = true;
                            break;
                        }
                        let _e378 = local[_e371.member_1];
                        let _e380 = ((_e371.member_1 * (((_e65 * _e46) * _e55) * 16u)) + ((((_e73 * _e66) * 16u) + _e86) + _e87));
                        if (_e380 < arrayLength((&partial.member))) {
                        } else {
                            phi_561_ = true;
                            break;
                        }
                        partial.member[_e380] = _e378;
                    }
                    continue;
                    continuing {
                        phi_493_ = _e369;
                        phi_561_ = _e281;
                        break if !(_e375);
                    }
                }
                let _e386 = phi_561_;
                if _e386 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_project(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
