struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_17 {
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

struct type_18 {
    member: type_17,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_18;
@group(0) @binding(1) 
var<storage> state: type_5;

fn function_() {
    var local: array<f32, 4>;
    var phi_84_: u32;
    var phi_178_: bool;
    var phi_180_: bool;
    var phi_181_: bool;
    var phi_202_: type_10;
    var phi_205_: array<f32, 4>;
    var phi_203_: type_10;
    var phi_228_: type_10;
    var phi_206_: array<f32, 4>;
    var phi_670_: bool;
    var phi_713_: bool;
    var phi_607_: array<f32, 4>;
    var phi_615_: type_10;
    var phi_616_: type_10;
    var phi_639_: type_10;
    var phi_709_: bool;
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
                phi_84_ = (3u * (_e51 / _e43));
            } else {
                phi_84_ = 0u;
            }
            let _e57 = phi_84_;
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
                        phi_178_ = (_e96 < _e41.z);
                    } else {
                        phi_178_ = bool();
                    }
                    let _e103 = phi_178_;
                    phi_180_ = _e103;
                    phi_181_ = select(true, false, _e100);
                } else {
                    phi_180_ = bool();
                    phi_181_ = true;
                }
                let _e106 = phi_180_;
                let _e108 = phi_181_;
                if select(_e106, false, _e108) {
                    phi_202_ = type_10(0u, 8u);
                    phi_205_ = array<f32, 4>(0f, 0f, 0f, 0f);
                    loop {
                        let _e121 = phi_202_;
                        let _e123 = phi_205_;
                        local_1 = _e123;
                        if (_e121.member < _e121.member_1) {
                            phi_203_ = type_10((_e121.member + 1u), _e121.member_1);
                            phi_228_ = type_10(1u, _e121.member);
                        } else {
                            phi_203_ = _e121;
                            phi_228_ = type_10(0u, type_10().member_1);
                        }
                        let _e136 = phi_203_;
                        let _e138 = phi_228_;
                        let _e142 = (bitcast<i32>(_e138.member) != 0i);
                        if _e142 {
                            let _e153 = (((((_e88 * _e83) + (((_e79 + (2u * _e68)) + ((2u * _e98) * _e75)) + ((2u * _e96) * _e78))) + (_e138.member_1 & 1u)) + (((_e138.member_1 >> bitcast<u32>(1i)) & 1u) * _e75)) + ((_e138.member_1 >> bitcast<u32>(2i)) * _e78));
                            if (_e153 < _e36) {
                            } else {
                                phi_670_ = true;
                                break;
                            }
                            let _e157 = state.member[_e153];
                            let _e158 = ((3u * _e83) + _e153);
                            if (_e158 < _e36) {
                            } else {
                                phi_670_ = true;
                                break;
                            }
                            let _e162 = state.member[_e158];
                            let _e164 = ((_e83 * 6u) + _e153);
                            if (_e164 < _e36) {
                            } else {
                                phi_670_ = true;
                                break;
                            }
                            let _e168 = state.member[_e164];
                            let _e170 = ((_e83 * 9u) + _e153);
                            if (_e170 < _e36) {
                            } else {
                                phi_670_ = true;
                                break;
                            }
                            let _e174 = state.member[_e170];
                            let _e176 = (_e157 + (_e162 * 0.8944272f));
                            let _e177 = (_e168 * 0.4472136f);
                            let _e178 = (_e174 * 0.4472136f);
                            let _e179 = (_e176 + _e177);
                            let _e181 = select(0f, _e179, (0f < _e179));
                            let _e182 = (_e176 - _e177);
                            let _e184 = select(0f, _e182, (0f < _e182));
                            let _e185 = (_e176 + _e178);
                            let _e187 = select(0f, _e185, (0f < _e185));
                            let _e188 = (_e176 - _e178);
                            let _e190 = select(0f, _e188, (0f < _e188));
                            let _e191 = (_e157 + _e162);
                            let _e194 = (select(0f, _e191, (0f < _e191)) * 0.4006697f);
                            let _e198 = (((_e181 + _e184) + (_e187 + _e190)) * 0.42343134f);
                            let _e203 = (_e157 + (_e162 * -0.8944272f));
                            let _e204 = (_e203 + _e177);
                            let _e206 = select(0f, _e204, (0f < _e204));
                            let _e207 = (_e203 - _e177);
                            let _e209 = select(0f, _e207, (0f < _e207));
                            let _e210 = (_e203 + _e178);
                            let _e212 = select(0f, _e210, (0f < _e210));
                            let _e213 = (_e203 - _e178);
                            let _e215 = select(0f, _e213, (0f < _e213));
                            let _e216 = (_e157 + -(_e162));
                            let _e219 = (select(0f, _e216, (0f < _e216)) * 0.4006697f);
                            let _e223 = (((_e206 + _e209) + (_e212 + _e215)) * 0.42343134f);
                            let _e236 = (_e157 + (_e168 * 0.8944272f));
                            let _e237 = (_e162 * 0.4472136f);
                            let _e238 = (_e236 + _e178);
                            let _e240 = select(0f, _e238, (0f < _e238));
                            let _e241 = (_e236 - _e178);
                            let _e243 = select(0f, _e241, (0f < _e241));
                            let _e244 = (_e236 + _e237);
                            let _e246 = select(0f, _e244, (0f < _e244));
                            let _e247 = (_e236 - _e237);
                            let _e249 = select(0f, _e247, (0f < _e247));
                            let _e250 = (_e157 + _e168);
                            let _e253 = (select(0f, _e250, (0f < _e250)) * 0.4006697f);
                            let _e257 = (((_e240 + _e243) + (_e246 + _e249)) * 0.42343134f);
                            let _e262 = (_e157 + (_e168 * -0.8944272f));
                            let _e263 = (_e262 + _e178);
                            let _e265 = select(0f, _e263, (0f < _e263));
                            let _e266 = (_e262 - _e178);
                            let _e268 = select(0f, _e266, (0f < _e266));
                            let _e269 = (_e262 + _e237);
                            let _e271 = select(0f, _e269, (0f < _e269));
                            let _e272 = (_e262 - _e237);
                            let _e274 = select(0f, _e272, (0f < _e272));
                            let _e275 = (_e157 + -(_e168));
                            let _e278 = (select(0f, _e275, (0f < _e275)) * 0.4006697f);
                            let _e282 = (((_e265 + _e268) + (_e271 + _e274)) * 0.42343134f);
                            let _e299 = (_e157 + (_e174 * 0.8944272f));
                            let _e300 = (_e299 + _e237);
                            let _e302 = select(0f, _e300, (0f < _e300));
                            let _e303 = (_e299 - _e237);
                            let _e305 = select(0f, _e303, (0f < _e303));
                            let _e306 = (_e299 + _e177);
                            let _e308 = select(0f, _e306, (0f < _e306));
                            let _e309 = (_e299 - _e177);
                            let _e311 = select(0f, _e309, (0f < _e309));
                            let _e312 = (_e157 + _e174);
                            let _e315 = (select(0f, _e312, (0f < _e312)) * 0.4006697f);
                            let _e319 = (((_e302 + _e305) + (_e308 + _e311)) * 0.42343134f);
                            let _e324 = (_e157 + (_e174 * -0.8944272f));
                            let _e325 = (_e324 + _e237);
                            let _e327 = select(0f, _e325, (0f < _e325));
                            let _e328 = (_e324 - _e237);
                            let _e330 = select(0f, _e328, (0f < _e328));
                            let _e331 = (_e324 + _e177);
                            let _e333 = select(0f, _e331, (0f < _e331));
                            let _e334 = (_e324 - _e177);
                            let _e336 = select(0f, _e334, (0f < _e334));
                            let _e337 = (_e157 + -(_e174));
                            let _e340 = (select(0f, _e337, (0f < _e337)) * 0.4006697f);
                            let _e344 = (((_e327 + _e330) + (_e333 + _e336)) * 0.42343134f);
                            let _e366 = ((_e83 * 12u) + _e153);
                            if (_e366 < _e36) {
                            } else {
                                phi_670_ = true;
                                break;
                            }
                            let _e370 = state.member[_e366];
                            phi_206_ = array<f32, 4>((_e123[0] + ((((_e194 + _e198) + (_e219 + _e223)) + ((_e253 + _e257) + (_e278 + _e282))) + ((_e315 + _e319) + (_e340 + _e344)))), (_e123[1] + (((((_e194 - _e219) + ((_e198 - _e223) * 0.8944272f)) + (((_e246 - _e249) + (_e271 - _e274)) * 0.18936425f)) + (((_e302 - _e305) + (_e327 - _e330)) * 0.18936425f)) * _e370)), (_e123[2] + (((((((_e181 - _e184) + (_e206 - _e209)) * 0.18936425f) + (_e253 - _e278)) + ((_e257 - _e282) * 0.8944272f)) + (((_e308 - _e311) + (_e333 - _e336)) * 0.18936425f)) * _e370)), (_e123[3] + ((((0.18936425f * (((_e187 - _e190) + (_e212 - _e215)) + ((_e240 - _e243) + (_e265 - _e268)))) + (_e315 - _e340)) + ((_e319 - _e344) * 0.8944272f)) * _e370)));
                        } else {
                            phi_206_ = array<f32, 4>();
                        }
                        let _e384 = phi_206_;
                        continue;
                        continuing {
                            phi_202_ = _e136;
                            phi_205_ = _e384;
                            phi_670_ = false;
                            break if !(_e142);
                        }
                    }
                    let _e387 = phi_670_;
                    if _e387 {
                        break;
                    }
                    phi_713_ = _e387;
                    let _e442 = local_1;
                    phi_607_ = _e442;
                } else {
                    phi_713_ = false;
                    phi_607_ = array<f32, 4>(0f, 0f, 0f, 0f);
                }
                let _e389 = phi_713_;
                let _e391 = phi_607_;
                local = array<f32, 4>(_e391[0], _e391[1], _e391[2], _e391[3]);
                phi_615_ = type_10(0u, 4u);
                loop {
                    let _e398 = phi_615_;
                    if (_e398.member < _e398.member_1) {
                        phi_616_ = type_10((_e398.member + 1u), _e398.member_1);
                        phi_639_ = type_10(1u, _e398.member);
                    } else {
                        phi_616_ = _e398;
                        phi_639_ = type_10(0u, type_10().member_1);
                    }
                    let _e411 = phi_616_;
                    let _e413 = phi_639_;
                    let _e417 = (bitcast<i32>(_e413.member) != 0i);
                    if _e417 {
                        if (_e413.member_1 < 4u) {
                        } else {
                            phi_709_ = true;
                            break;
                        }
                        let _e420 = local[_e413.member_1];
                        let _e422 = ((_e413.member_1 * (3u * _e51)) + ((_e66 * _e43) + _e68));
                        if (_e422 < arrayLength((&out.member))) {
                        } else {
                            phi_709_ = true;
                            break;
                        }
                        out.member[_e422] = _e420;
                    }
                    continue;
                    continuing {
                        phi_615_ = _e411;
                        phi_709_ = _e389;
                        break if !(_e417);
                    }
                }
                let _e428 = phi_709_;
                if _e428 {
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
