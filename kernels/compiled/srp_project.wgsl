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
    var phi_89_: u32;
    var phi_107_: u32;
    var phi_125_: u32;
    var phi_187_: u32;
    var phi_205_: u32;
    var phi_223_: u32;
    var phi_259_: type_11;
    var phi_262_: u32;
    var phi_264_: u32;
    var phi_266_: array<f32, 24>;
    var phi_260_: type_11;
    var phi_289_: type_11;
    var phi_263_: u32;
    var phi_265_: u32;
    var phi_267_: array<f32, 24>;
    var phi_565_: bool;
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
    var phi_509_: type_11;
    var phi_510_: type_11;
    var phi_533_: type_11;
    var phi_577_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = gid_1;
            let _e30 = arrayLength((&table.member));
            let _e32 = arrayLength((&light.member));
            let _e37 = params.member.member_3;
            let _e39 = select(_e37, 16u, (_e37 == 0u));
            let _e42 = params.member.member;
            let _e43 = (_e42 / 16u);
            let _e45 = ((_e42 % 16u) > 0u);
            if _e45 {
                phi_89_ = (_e43 + 1u);
            } else {
                phi_89_ = _e43;
            }
            let _e48 = phi_89_;
            let _e51 = params.member.member_2;
            let _e52 = (_e51 / 8u);
            let _e54 = ((_e51 % 8u) > 0u);
            if _e54 {
                phi_107_ = (_e52 + 1u);
            } else {
                phi_107_ = _e52;
            }
            let _e57 = phi_107_;
            let _e60 = params.member.member_1;
            let _e61 = (_e39 == 0u);
            if _e61 {
                break;
            }
            let _e62 = (_e60 / _e39);
            if _e61 {
                break;
            }
            let _e64 = ((_e60 % _e39) > 0u);
            if _e64 {
                phi_125_ = (_e62 + 1u);
            } else {
                phi_125_ = _e62;
            }
            let _e67 = phi_125_;
            let _e68 = (_e48 * _e57);
            let _e71 = params.member.member_6;
            let _e75 = params.member.member_5;
            let _e84 = (_e28.x + (_e28.y * 2097152u));
            if (_e84 < ((_e71 * _e68) * 16u)) {
                let _e87 = (_e84 / 16u);
                let _e88 = (_e87 * 16u);
                let _e89 = (_e84 - _e88);
                if _e45 {
                    phi_187_ = (_e43 + 1u);
                } else {
                    phi_187_ = _e43;
                }
                let _e94 = phi_187_;
                if _e54 {
                    phi_205_ = (_e52 + 1u);
                } else {
                    phi_205_ = _e52;
                }
                let _e97 = phi_205_;
                if _e61 {
                    break;
                }
                if _e61 {
                    break;
                }
                if _e64 {
                    phi_223_ = (_e62 + 1u);
                } else {
                    phi_223_ = _e62;
                }
                let _e100 = phi_223_;
                if (_e97 == 0u) {
                    break;
                }
                let _e102 = (_e87 / _e97);
                if (_e94 == 0u) {
                    break;
                }
                let _e109 = (((_e94 * _e39) * 16u) * _e71);
                let _e113 = ((_e87 - (_e102 * _e97)) * 8u);
                phi_259_ = type_11(0u, _e39);
                phi_262_ = (((_e39 * (((_e113 / 8u) * _e100) + (_e75 + (_e102 / _e94)))) * 8u) + (_e113 % 8u));
                phi_264_ = (((_e102 * _e39) * 16u) + _e89);
                phi_266_ = array<f32, 24>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e124 = phi_259_;
                    let _e126 = phi_262_;
                    let _e128 = phi_264_;
                    let _e130 = phi_266_;
                    local_1 = _e130;
                    local_2 = _e130;
                    local_3 = _e130;
                    local_4 = _e130;
                    local_5 = _e130;
                    local_6 = _e130;
                    local_7 = _e130;
                    local_8 = _e130;
                    local_9 = _e130;
                    local_10 = _e130;
                    local_11 = _e130;
                    local_12 = _e130;
                    local_13 = _e130;
                    local_14 = _e130;
                    local_15 = _e130;
                    local_16 = _e130;
                    local_17 = _e130;
                    local_18 = _e130;
                    local_19 = _e130;
                    local_20 = _e130;
                    local_21 = _e130;
                    local_22 = _e130;
                    local_23 = _e130;
                    local_24 = _e130;
                    if (_e124.member < _e124.member_1) {
                        phi_260_ = type_11((_e124.member + 1u), _e124.member_1);
                        phi_289_ = type_11(1u, _e124.member);
                    } else {
                        phi_260_ = _e124;
                        phi_289_ = type_11(0u, type_11().member_1);
                    }
                    let _e143 = phi_260_;
                    let _e145 = phi_289_;
                    let _e148 = (bitcast<i32>(_e145.member) != 0i);
                    if _e148 {
                        if (_e128 < _e32) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e152 = light.member[_e128];
                        let _e153 = (_e109 + _e128);
                        if (_e153 < _e32) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e157 = light.member[_e153];
                        let _e159 = ((2u * _e109) + _e128);
                        if (_e159 < _e32) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e163 = light.member[_e159];
                        if (_e126 < _e30) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e167 = table.member[_e126];
                        let _e177 = (_e126 + 1u);
                        if (_e177 < _e30) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e181 = table.member[_e177];
                        let _e191 = (_e126 + 2u);
                        if (_e191 < _e30) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e195 = table.member[_e191];
                        let _e205 = (_e126 + 3u);
                        if (_e205 < _e30) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e209 = table.member[_e205];
                        let _e219 = (_e126 + 4u);
                        if (_e219 < _e30) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e223 = table.member[_e219];
                        let _e233 = (_e126 + 5u);
                        if (_e233 < _e30) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e237 = table.member[_e233];
                        let _e247 = (_e126 + 6u);
                        if (_e247 < _e30) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e251 = table.member[_e247];
                        let _e261 = (_e126 + 7u);
                        if (_e261 < _e30) {
                        } else {
                            phi_565_ = true;
                            break;
                        }
                        let _e265 = table.member[_e261];
                        phi_263_ = (_e126 + 8u);
                        phi_265_ = (_e128 + 16u);
                        phi_267_ = array<f32, 24>((_e130[0] + (_e152 * _e167)), (_e130[1] + (_e152 * _e181)), (_e130[2] + (_e152 * _e195)), (_e130[3] + (_e152 * _e209)), (_e130[4] + (_e152 * _e223)), (_e130[5] + (_e152 * _e237)), (_e130[6] + (_e152 * _e251)), (_e130[7] + (_e152 * _e265)), (_e130[8] + (_e157 * _e167)), (_e130[9] + (_e157 * _e181)), (_e130[10] + (_e157 * _e195)), (_e130[11] + (_e157 * _e209)), (_e130[12] + (_e157 * _e223)), (_e130[13] + (_e157 * _e237)), (_e130[14] + (_e157 * _e251)), (_e130[15] + (_e157 * _e265)), (_e130[16] + (_e163 * _e167)), (_e130[17] + (_e163 * _e181)), (_e130[18] + (_e163 * _e195)), (_e130[19] + (_e163 * _e209)), (_e130[20] + (_e163 * _e223)), (_e130[21] + (_e163 * _e237)), (_e130[22] + (_e163 * _e251)), (_e130[23] + (_e163 * _e265)));
                    } else {
                        phi_263_ = u32();
                        phi_265_ = u32();
                        phi_267_ = array<f32, 24>();
                    }
                    let _e279 = phi_263_;
                    let _e281 = phi_265_;
                    let _e283 = phi_267_;
                    continue;
                    continuing {
                        phi_259_ = _e143;
                        phi_262_ = _e279;
                        phi_264_ = _e281;
                        phi_266_ = _e283;
                        phi_565_ = false;
                        break if !(_e148);
                    }
                }
                let _e286 = phi_565_;
                if _e286 {
                    break;
                }
                let _e288 = local_1;
                let _e291 = local_2;
                let _e294 = local_3;
                let _e297 = local_4;
                let _e300 = local_5;
                let _e303 = local_6;
                let _e306 = local_7;
                let _e309 = local_8;
                let _e312 = local_9;
                let _e315 = local_10;
                let _e318 = local_11;
                let _e321 = local_12;
                let _e324 = local_13;
                let _e327 = local_14;
                let _e330 = local_15;
                let _e333 = local_16;
                let _e336 = local_17;
                let _e339 = local_18;
                let _e342 = local_19;
                let _e345 = local_20;
                let _e348 = local_21;
                let _e351 = local_22;
                let _e354 = local_23;
                let _e357 = local_24;
                local = array<f32, 24>(_e288[0], _e291[1], _e294[2], _e297[3], _e300[4], _e303[5], _e306[6], _e309[7], _e312[8], _e315[9], _e318[10], _e321[11], _e324[12], _e327[13], _e330[14], _e333[15], _e336[16], _e339[17], _e342[18], _e345[19], _e348[20], _e351[21], _e354[22], _e357[23]);
                phi_509_ = type_11(0u, 24u);
                loop {
                    let _e361 = phi_509_;
                    if (_e361.member < _e361.member_1) {
                        phi_510_ = type_11((_e361.member + 1u), _e361.member_1);
                        phi_533_ = type_11(1u, _e361.member);
                    } else {
                        phi_510_ = _e361;
                        phi_533_ = type_11(0u, type_11().member_1);
                    }
                    let _e374 = phi_510_;
                    let _e376 = phi_533_;
                    let _e380 = (bitcast<i32>(_e376.member) != 0i);
                    if _e380 {
                        if (_e376.member_1 < 24u) {
                        } else {
                            phi_577_ = true;
                            break;
                        }
                        let _e383 = local[_e376.member_1];
                        let _e385 = ((_e376.member_1 * (((_e67 * _e48) * _e57) * 16u)) + ((((_e75 * _e68) * 16u) + _e88) + _e89));
                        if (_e385 < arrayLength((&partial.member))) {
                        } else {
                            phi_577_ = true;
                            break;
                        }
                        partial.member[_e385] = _e383;
                    }
                    continue;
                    continuing {
                        phi_509_ = _e374;
                        phi_577_ = _e286;
                        break if !(_e380);
                    }
                }
                let _e391 = phi_577_;
                if _e391 {
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
