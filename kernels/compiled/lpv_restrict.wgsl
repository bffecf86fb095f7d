struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_18 {
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
    member_17: vec4<f32>,
}

struct type_19 {
    member: type_18,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_19;
@group(0) @binding(1) 
var<storage> state: type_5;

fn function_() {
    var local: array<f32, 4>;
    var phi_88_: u32;
    var phi_182_: bool;
    var phi_184_: bool;
    var phi_185_: bool;
    var phi_206_: type_11;
    var phi_209_: array<f32, 4>;
    var phi_207_: type_11;
    var phi_232_: type_11;
    var phi_210_: array<f32, 4>;
    var phi_622_: bool;
    var phi_667_: bool;
    var phi_559_: array<f32, 4>;
    var phi_567_: type_11;
    var phi_568_: type_11;
    var phi_591_: type_11;
    var phi_663_: bool;
    var local_1: array<f32, 4>;

    switch bitcast<i32>(0u) {
        default: {
            let _e34 = gid_1;
            let _e36 = arrayLength((&state.member));
            let _e41 = params.member.member_3;
            let _e43 = (_e41.x + 1u);
            let _e45 = (_e41.y + 1u);
            let _e46 = (_e45 * _e43);
            let _e51 = ((_e46 + _e43) + ((_e41.z + 1u) * _e46));
            if (_e41.x > 0u) {
                if (_e43 == 0u) {
                    break;
                }
                phi_88_ = (3u * (_e51 / _e43));
            } else {
                phi_88_ = 0u;
            }
            let _e57 = phi_88_;
            let _e62 = (_e34.x + (_e34.y * 2097152u));
            if (_e62 < (_e57 * _e41.x)) {
                if (_e41.x == 0u) {
                    break;
                }
                let _e66 = (_e62 / _e41.x);
                let _e68 = (_e62 - (_e66 * _e41.x));
                let _e73 = params.member.member_2;
                let _e75 = (_e73.x + 1u);
                let _e78 = ((_e73.y + 1u) * _e75);
                let _e79 = (_e78 + _e75);
                let _e83 = (_e79 + ((_e73.z + 1u) * _e78));
                let _e85 = (_e43 == 0u);
                if _e85 {
                    break;
                }
                let _e86 = (_e51 / _e43);
                if (_e86 == 0u) {
                    break;
                }
                let _e88 = (_e66 / _e86);
                if _e85 {
                    break;
                }
                let _e90 = (_e66 - (_e88 * _e86));
                let _e91 = (_e41.y + 2u);
                let _e94 = (select(_e91, _e90, (_e91 < _e90)) - _e91);
                if (_e45 == 0u) {
                    break;
                }
                let _e96 = (_e94 / _e45);
                let _e98 = (_e94 - (_e96 * _e45));
                if (_e90 >= _e91) {
                    let _e100 = (_e98 < _e41.y);
                    if _e100 {
                        phi_182_ = (_e96 < _e41.z);
                    } else {
                        phi_182_ = bool();
                    }
                    let _e103 = phi_182_;
                    phi_184_ = _e103;
                    phi_185_ = select(true, false, _e100);
                } else {
                    phi_184_ = bool();
                    phi_185_ = true;
                }
                let _e106 = phi_184_;
                let _e108 = phi_185_;
                if select(_e106, false, _e108) {
                    phi_206_ = type_11(0u, 8u);
                    phi_209_ = array<f32, 4>(0f, 0f, 0f, 0f);
                    loop {
                        let _e121 = phi_206_;
                        let _e123 = phi_209_;
                        local_1 = _e123;
                        if (_e121.member < _e121.member_1) {
                            phi_207_ = type_11((_e121.member + 1u), _e121.member_1);
                            phi_232_ = type_11(1u, _e121.member);
                        } else {
                            phi_207_ = _e121;
                            phi_232_ = type_11(0u, type_11().member_1);
                        }
                        let _e136 = phi_207_;
                        let _e138 = phi_232_;
                        let _e142 = (bitcast<i32>(_e138.member) != 0i);
                        if _e142 {
                            let _e153 = (((((_e88 * _e83) + (((_e79 + (2u * _e68)) + ((2u * _e98) * _e75)) + ((2u * _e96) * _e78))) + (_e138.member_1 & 1u)) + (((_e138.member_1 >> bitcast<u32>(1i)) & 1u) * _e75)) + ((_e138.member_1 >> bitcast<u32>(2i)) * _e78));
                            if (_e153 < _e36) {
                            } else {
                                phi_622_ = true;
                                break;
                            }
                            let _e157 = state.member[_e153];
                            let _e158 = ((3u * _e83) + _e153);
                            if (_e158 < _e36) {
                            } else {
                                phi_622_ = true;
                                break;
                            }
                            let _e162 = state.member[_e158];
                            let _e164 = ((_e83 * 6u) + _e153);
                            if (_e164 < _e36) {
                            } else {
                                phi_622_ = true;
                                break;
                            }
                            let _e168 = state.member[_e164];
                            let _e170 = ((_e83 * 9u) + _e153);
                            if (_e170 < _e36) {
                            } else {
                                phi_622_ = true;
                                break;
                            }
                            let _e174 = state.member[_e170];
                            let _e175 = (0f < _e157);
                            let _e177 = (_e157 + (_e162 * 0.8944272f));
                            let _e178 = (_e168 * 0.4472136f);
                            let _e179 = (_e174 * 0.4472136f);
                            let _e180 = (_e177 + _e178);
                            let _e183 = (_e177 - _e178);
                            let _e186 = (_e177 + _e179);
                            let _e189 = (_e177 - _e179);
                            let _e192 = (_e157 + _e162);
                            let _e202 = (_e157 + (_e162 * -0.8944272f));
                            let _e203 = (_e202 + _e178);
                            let _e206 = (_e202 - _e178);
                            let _e209 = (_e202 + _e179);
                            let _e212 = (_e202 - _e179);
                            let _e215 = (_e157 + -(_e162));
                            let _e226 = (_e157 + (_e168 * 0.8944272f));
                            let _e227 = (_e162 * 0.4472136f);
                            let _e228 = (_e226 + _e179);
                            let _e231 = (_e226 - _e179);
                            let _e234 = (_e226 + _e227);
                            let _e237 = (_e226 - _e227);
                            let _e240 = (_e157 + _e168);
                            let _e250 = (_e157 + (_e168 * -0.8944272f));
                            let _e251 = (_e250 + _e179);
                            let _e254 = (_e250 - _e179);
                            let _e257 = (_e250 + _e227);
                            let _e260 = (_e250 - _e227);
                            let _e263 = (_e157 + -(_e168));
                            let _e274 = (_e157 + (_e174 * 0.8944272f));
                            let _e275 = (_e274 + _e227);
                            let _e278 = (_e274 - _e227);
                            let _e281 = (_e274 + _e178);
                            let _e284 = (_e274 - _e178);
                            let _e287 = (_e157 + _e174);
                            let _e297 = (_e157 + (_e174 * -0.8944272f));
                            let _e298 = (_e297 + _e227);
                            let _e301 = (_e297 - _e227);
                            let _e304 = (_e297 + _e178);
                            let _e307 = (_e297 - _e178);
                            let _e310 = (_e157 + -(_e174));
                            let _e325 = select(0f, (((((select(0f, _e192, (0f < _e192)) * 0.4006697f) + (((select(0f, _e180, (0f < _e180)) + select(0f, _e183, (0f < _e183))) + (select(0f, _e186, (0f < _e186)) + select(0f, _e189, (0f < _e189)))) * 0.42343134f)) + ((select(0f, _e215, (0f < _e215)) * 0.4006697f) + (((select(0f, _e203, (0f < _e203)) + select(0f, _e206, (0f < _e206))) + (select(0f, _e209, (0f < _e209)) + select(0f, _e212, (0f < _e212)))) * 0.42343134f))) + (((select(0f, _e240, (0f < _e240)) * 0.4006697f) + (((select(0f, _e228, (0f < _e228)) + select(0f, _e231, (0f < _e231))) + (select(0f, _e234, (0f < _e234)) + select(0f, _e237, (0f < _e237)))) * 0.42343134f)) + ((select(0f, _e263, (0f < _e263)) * 0.4006697f) + (((select(0f, _e251, (0f < _e251)) + select(0f, _e254, (0f < _e254))) + (select(0f, _e257, (0f < _e257)) + select(0f, _e260, (0f < _e260)))) * 0.42343134f)))) + (((select(0f, _e287, (0f < _e287)) * 0.4006697f) + (((select(0f, _e275, (0f < _e275)) + select(0f, _e278, (0f < _e278))) + (select(0f, _e281, (0f < _e281)) + select(0f, _e284, (0f < _e284)))) * 0.42343134f)) + ((select(0f, _e310, (0f < _e310)) * 0.4006697f) + (((select(0f, _e298, (0f < _e298)) + select(0f, _e301, (0f < _e301))) + (select(0f, _e304, (0f < _e304)) + select(0f, _e307, (0f < _e307)))) * 0.42343134f)))), _e175);
                            let _e329 = params.member.member_6;
                            let _e332 = (_e325 / (select(1f, _e157, _e175) * (3f * _e329)));
                            phi_210_ = array<f32, 4>((_e123[0] + _e325), (_e123[1] + (_e162 * _e332)), (_e123[2] + (_e168 * _e332)), (_e123[3] + (_e174 * _e332)));
                        } else {
                            phi_210_ = array<f32, 4>();
                        }
                        let _e346 = phi_210_;
                        continue;
                        continuing {
                            phi_206_ = _e136;
                            phi_209_ = _e346;
                            phi_622_ = false;
                            break if !(_e142);
                        }
                    }
                    let _e349 = phi_622_;
                    if _e349 {
                        break;
                    }
                    phi_667_ = _e349;
                    let _e404 = local_1;
                    phi_559_ = _e404;
                } else {
                    phi_667_ = false;
                    phi_559_ = array<f32, 4>(0f, 0f, 0f, 0f);
                }
                let _e351 = phi_667_;
                let _e353 = phi_559_;
                local = array<f32, 4>(_e353[0], _e353[1], _e353[2], _e353[3]);
                phi_567_ = type_11(0u, 4u);
                loop {
                    let _e360 = phi_567_;
                    if (_e360.member < _e360.member_1) {
                        phi_568_ = type_11((_e360.member + 1u), _e360.member_1);
                        phi_591_ = type_11(1u, _e360.member);
                    } else {
                        phi_568_ = _e360;
                        phi_591_ = type_11(0u, type_11().member_1);
                    }
                    let _e373 = phi_568_;
                    let _e375 = phi_591_;
                    let _e379 = (bitcast<i32>(_e375.member) != 0i);
                    if _e379 {
                        if (_e375.member_1 < 4u) {
                        } else {
                            phi_663_ = true;
                            break;
                        }
                        let _e382 = local[_e375.member_1];
                        let _e384 = ((_e375.member_1 * (3u * _e51)) + ((_e66 * _e43) + _e68));
                        if (_e384 < arrayLength((&out.member))) {
                        } else {
                            phi_663_ = true;
                            break;
                        }
                        out.member[_e384] = _e382;
                    }
                    continue;
                    continuing {
                        phi_567_ = _e373;
                        phi_663_ = _e351;
                        break if !(_e379);
                    }
                }
                let _e390 = phi_663_;
                if _e390 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_restrict(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
