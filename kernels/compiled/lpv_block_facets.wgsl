struct type_8 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_23 {
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

struct type_24 {
    member: type_23,
}

struct type_30 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_24;
@group(0) @binding(1) 
var<storage> facets: type_17;
@group(0) @binding(2) 
var<storage, read_write> words: type_30;

fn function_() {
    var phi_137_: vec3<f32>;
    var phi_233_: bool;
    var phi_235_: bool;
    var phi_236_: bool;
    var phi_237_: bool;
    var phi_238_: bool;
    var phi_239_: bool;
    var phi_240_: bool;
    var phi_241_: bool;
    var phi_242_: bool;
    var phi_369_: bool;
    var phi_371_: bool;
    var phi_372_: bool;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_505_: bool;
    var phi_507_: bool;
    var phi_508_: bool;
    var phi_509_: bool;
    var phi_510_: bool;
    var phi_511_: bool;
    var phi_512_: bool;
    var phi_513_: bool;
    var phi_514_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e30 = gid_1;
            let _e34 = arrayLength((&words.member));
            let _e38 = (_e30.x + (_e30.y * 2097152u));
            let _e41 = params.member.member_5;
            if (_e38 < _e41) {
                if (_e38 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e46 = params.member.member_13;
                let _e50 = params.member.member[3u];
                let _e51 = (_e46 / _e50);
                let _e55 = facets.member[_e38].member;
                let _e62 = facets.member[_e38].member_2;
                let _e66 = (_e51 * _e51);
                let _e67 = (_e62[0] * _e66);
                let _e68 = (_e62[1] * _e66);
                let _e69 = (_e62[2] * _e66);
                let _e72 = params.member.member;
                let _e87 = (((_e67 * _e67) + (_e68 * _e68)) + (_e69 * _e69));
                if (_e87 >= 0.000000000000000000000000000000000000011754944f) {
                    let _e90 = (1f / sqrt(_e87));
                    phi_137_ = vec3<f32>((_e67 * _e90), (_e68 * _e90), (_e69 * _e90));
                } else {
                    phi_137_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e96 = phi_137_;
                let _e103 = (((_e55[0] - _e72.x) / _e72.w) - (_e96.x * 0.015625f));
                let _e104 = (((_e55[1] - _e72.y) / _e72.w) - (_e96.y * 0.015625f));
                let _e105 = (((_e55[2] - _e72.z) / _e72.w) - (_e96.z * 0.015625f));
                let _e107 = abs(_e67);
                let _e110 = params.member.member_1;
                let _e111 = floor((_e103 - 0.5f));
                let _e119 = floor(_e104);
                let _e127 = floor(_e105);
                let _e138 = (select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < -2147483600f)), 2147483647i, (_e111 > 2147483500f)), (_e111 == _e111)) - _e110.x);
                let _e139 = (select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < -2147483600f)), 2147483647i, (_e119 > 2147483500f)), (_e119 == _e119)) - _e110.y);
                let _e140 = (select(0i, select(select(i32(_e127), i32(-2147483648), (_e127 < -2147483600f)), 2147483647i, (_e127 > 2147483500f)), (_e127 == _e127)) - _e110.z);
                let _e145 = floor(((select(16f, _e107, (_e107 < 16f)) * 65536f) + 0.5f));
                let _e150 = select(select(u32(_e145), 0u, (_e145 < 0f)), 4294967295u, (_e145 > 4294967000f));
                let _e153 = params.member.member_2;
                if (_e138 >= 0i) {
                    if (_e139 >= 0i) {
                        if (_e140 >= 0i) {
                            if (_e138 < bitcast<i32>(_e153.x)) {
                                let _e162 = (_e139 < bitcast<i32>(_e153.y));
                                if _e162 {
                                    phi_233_ = (_e140 < bitcast<i32>(_e153.z));
                                } else {
                                    phi_233_ = bool();
                                }
                                let _e167 = phi_233_;
                                phi_235_ = _e167;
                                phi_236_ = select(true, false, _e162);
                            } else {
                                phi_235_ = bool();
                                phi_236_ = true;
                            }
                            let _e170 = phi_235_;
                            let _e172 = phi_236_;
                            phi_237_ = _e170;
                            phi_238_ = _e172;
                        } else {
                            phi_237_ = bool();
                            phi_238_ = true;
                        }
                        let _e174 = phi_237_;
                        let _e176 = phi_238_;
                        phi_239_ = _e174;
                        phi_240_ = _e176;
                    } else {
                        phi_239_ = bool();
                        phi_240_ = true;
                    }
                    let _e178 = phi_239_;
                    let _e180 = phi_240_;
                    phi_241_ = _e178;
                    phi_242_ = _e180;
                } else {
                    phi_241_ = bool();
                    phi_242_ = true;
                }
                let _e182 = phi_241_;
                let _e184 = phi_242_;
                if select(_e182, false, _e184) {
                    if (_e150 > 0u) {
                        let _e188 = (_e153.x + 1u);
                        let _e191 = ((_e153.y + 1u) * _e188);
                        let _e200 = ((((_e191 + _e188) + bitcast<u32>(_e138)) + (bitcast<u32>(_e139) * _e188)) + (bitcast<u32>(_e140) * _e191));
                        if (_e200 < _e34) {
                        } else {
                            break;
                        }
                        let _e204 = atomicAdd((&words.member[_e200]), _e150);
                    }
                }
                let _e206 = abs(_e68);
                let _e207 = floor(_e103);
                let _e215 = floor((_e104 - 0.5f));
                let _e223 = (select(0i, select(select(i32(_e207), i32(-2147483648), (_e207 < -2147483600f)), 2147483647i, (_e207 > 2147483500f)), (_e207 == _e207)) - _e110.x);
                let _e224 = (select(0i, select(select(i32(_e215), i32(-2147483648), (_e215 < -2147483600f)), 2147483647i, (_e215 > 2147483500f)), (_e215 == _e215)) - _e110.y);
                let _e229 = floor(((select(16f, _e206, (_e206 < 16f)) * 65536f) + 0.5f));
                let _e234 = select(select(u32(_e229), 0u, (_e229 < 0f)), 4294967295u, (_e229 > 4294967000f));
                let _e235 = (_e223 >= 0i);
                if _e235 {
                    if (_e224 >= 0i) {
                        if (_e140 >= 0i) {
                            if (_e223 < bitcast<i32>(_e153.x)) {
                                let _e243 = (_e224 < bitcast<i32>(_e153.y));
                                if _e243 {
                                    phi_369_ = (_e140 < bitcast<i32>(_e153.z));
                                } else {
                                    phi_369_ = bool();
                                }
                                let _e248 = phi_369_;
                                phi_371_ = _e248;
                                phi_372_ = select(true, false, _e243);
                            } else {
                                phi_371_ = bool();
                                phi_372_ = true;
                            }
                            let _e251 = phi_371_;
                            let _e253 = phi_372_;
                            phi_373_ = _e251;
                            phi_374_ = _e253;
                        } else {
                            phi_373_ = bool();
                            phi_374_ = true;
                        }
                        let _e255 = phi_373_;
                        let _e257 = phi_374_;
                        phi_375_ = _e255;
                        phi_376_ = _e257;
                    } else {
                        phi_375_ = bool();
                        phi_376_ = true;
                    }
                    let _e259 = phi_375_;
                    let _e261 = phi_376_;
                    phi_377_ = _e259;
                    phi_378_ = _e261;
                } else {
                    phi_377_ = bool();
                    phi_378_ = true;
                }
                let _e263 = phi_377_;
                let _e265 = phi_378_;
                if select(_e263, false, _e265) {
                    if (_e234 > 0u) {
                        let _e269 = (_e153.x + 1u);
                        let _e272 = ((_e153.y + 1u) * _e269);
                        let _e273 = (_e272 + _e269);
                        let _e286 = ((_e273 + ((_e153.z + 1u) * _e272)) + (((_e273 + bitcast<u32>(_e223)) + (bitcast<u32>(_e224) * _e269)) + (bitcast<u32>(_e140) * _e272)));
                        if (_e286 < _e34) {
                        } else {
                            break;
                        }
                        let _e290 = atomicAdd((&words.member[_e286]), _e234);
                    }
                }
                let _e292 = abs(_e69);
                let _e293 = floor((_e105 - 0.5f));
                let _e301 = (select(0i, select(select(i32(_e293), i32(-2147483648), (_e293 < -2147483600f)), 2147483647i, (_e293 > 2147483500f)), (_e293 == _e293)) - _e110.z);
                let _e306 = floor(((select(16f, _e292, (_e292 < 16f)) * 65536f) + 0.5f));
                let _e311 = select(select(u32(_e306), 0u, (_e306 < 0f)), 4294967295u, (_e306 > 4294967000f));
                if _e235 {
                    if (_e139 >= 0i) {
                        if (_e301 >= 0i) {
                            if (_e223 < bitcast<i32>(_e153.x)) {
                                let _e319 = (_e139 < bitcast<i32>(_e153.y));
                                if _e319 {
                                    phi_505_ = (_e301 < bitcast<i32>(_e153.z));
                                } else {
                                    phi_505_ = bool();
                                }
                                let _e324 = phi_505_;
                                phi_507_ = _e324;
                                phi_508_ = select(true, false, _e319);
                            } else {
                                phi_507_ = bool();
                                phi_508_ = true;
                            }
                            let _e327 = phi_507_;
                            let _e329 = phi_508_;
                            phi_509_ = _e327;
                            phi_510_ = _e329;
                        } else {
                            phi_509_ = bool();
                            phi_510_ = true;
                        }
                        let _e331 = phi_509_;
                        let _e333 = phi_510_;
                        phi_511_ = _e331;
                        phi_512_ = _e333;
                    } else {
                        phi_511_ = bool();
                        phi_512_ = true;
                    }
                    let _e335 = phi_511_;
                    let _e337 = phi_512_;
                    phi_513_ = _e335;
                    phi_514_ = _e337;
                } else {
                    phi_513_ = bool();
                    phi_514_ = true;
                }
                let _e339 = phi_513_;
                let _e341 = phi_514_;
                if select(_e339, false, _e341) {
                    if (_e311 > 0u) {
                        let _e345 = (_e153.x + 1u);
                        let _e348 = ((_e153.y + 1u) * _e345);
                        let _e349 = (_e348 + _e345);
                        let _e363 = ((2u * (_e349 + ((_e153.z + 1u) * _e348))) + (((_e349 + bitcast<u32>(_e223)) + (bitcast<u32>(_e139) * _e345)) + (bitcast<u32>(_e301) * _e348)));
                        if (_e363 < _e34) {
                        } else {
                            break;
                        }
                        let _e367 = atomicAdd((&words.member[_e363]), _e311);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_block_facets(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
