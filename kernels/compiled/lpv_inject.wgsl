struct type_9 {
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

struct type_22 {
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

struct type_23 {
    member: type_22,
}

struct type_29 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_23;
@group(0) @binding(2) 
var<storage, read_write> words: type_29;
@group(0) @binding(1) 
var<storage> texels: type_17;

fn function_() {
    var phi_202_: bool;
    var phi_204_: bool;
    var phi_205_: bool;
    var phi_206_: bool;
    var phi_207_: bool;
    var phi_208_: bool;
    var phi_209_: bool;
    var phi_210_: bool;
    var phi_211_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = gid_1;
            let _e35 = arrayLength((&words.member));
            let _e39 = (_e31.x + (_e31.y * 2097152u));
            let _e42 = params.member.member_5;
            if (_e39 < _e42) {
                if (_e39 < arrayLength((&texels.member))) {
                } else {
                    break;
                }
                let _e48 = texels.member[_e39].member_3;
                if (_e48 == 1u) {
                    let _e53 = texels.member[_e39].member_4;
                    let _e60 = texels.member[_e39].member_6;
                    let _e70 = texels.member[_e39].member;
                    let _e77 = texels.member[_e39].member_2;
                    let _e83 = params.member.member_1;
                    let _e86 = params.member.member;
                    let _e103 = floor((((_e70[0] - _e86.x) / _e86.w) + (_e77[0] * 0.5f)));
                    let _e111 = floor((((_e70[1] - _e86.y) / _e86.w) + (_e77[1] * 0.5f)));
                    let _e119 = floor((((_e70[2] - _e86.z) / _e86.w) + (_e77[2] * 0.5f)));
                    let _e130 = (select(0i, select(select(i32(_e103), i32(-2147483648), (_e103 < -2147483600f)), 2147483647i, (_e103 > 2147483500f)), (_e103 == _e103)) - _e83.x);
                    let _e131 = (select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < -2147483600f)), 2147483647i, (_e111 > 2147483500f)), (_e111 == _e111)) - _e83.y);
                    let _e132 = (select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < -2147483600f)), 2147483647i, (_e119 > 2147483500f)), (_e119 == _e119)) - _e83.z);
                    let _e135 = params.member.member_2;
                    if (_e130 >= 0i) {
                        if (_e131 >= 0i) {
                            if (_e132 >= 0i) {
                                if (_e130 < bitcast<i32>(_e135.x)) {
                                    let _e144 = (_e131 < bitcast<i32>(_e135.y));
                                    if _e144 {
                                        phi_202_ = (_e132 < bitcast<i32>(_e135.z));
                                    } else {
                                        phi_202_ = bool();
                                    }
                                    let _e149 = phi_202_;
                                    phi_204_ = _e149;
                                    phi_205_ = select(true, false, _e144);
                                } else {
                                    phi_204_ = bool();
                                    phi_205_ = true;
                                }
                                let _e152 = phi_204_;
                                let _e154 = phi_205_;
                                phi_206_ = _e152;
                                phi_207_ = _e154;
                            } else {
                                phi_206_ = bool();
                                phi_207_ = true;
                            }
                            let _e156 = phi_206_;
                            let _e158 = phi_207_;
                            phi_208_ = _e156;
                            phi_209_ = _e158;
                        } else {
                            phi_208_ = bool();
                            phi_209_ = true;
                        }
                        let _e160 = phi_208_;
                        let _e162 = phi_209_;
                        phi_210_ = _e160;
                        phi_211_ = _e162;
                    } else {
                        phi_210_ = bool();
                        phi_211_ = true;
                    }
                    let _e164 = phi_210_;
                    let _e166 = phi_211_;
                    if select(_e164, false, _e166) {
                        let _e169 = (_e135.x + 1u);
                        let _e172 = ((_e135.y + 1u) * _e169);
                        let _e173 = (_e172 + _e169);
                        let _e177 = (_e173 + ((_e135.z + 1u) * _e172));
                        let _e185 = (((_e173 + bitcast<u32>(_e130)) + (bitcast<u32>(_e131) * _e169)) + (bitcast<u32>(_e132) * _e172));
                        let _e188 = params.member.member_7;
                        let _e189 = ((_e53[0] * _e60[0]) * _e188);
                        let _e191 = select(0f, _e189, (_e189 > 0f));
                        let _e193 = select(1073741800f, _e191, (_e191 < 1073741800f));
                        let _e194 = (3u * _e177);
                        let _e196 = floor((_e193 + 0.5f));
                        let _e201 = select(select(u32(_e196), 0u, (_e196 < 0f)), 4294967295u, (_e196 > 4294967000f));
                        if (_e201 == 0u) {
                        } else {
                            if (_e185 < _e35) {
                            } else {
                                break;
                            }
                            let _e206 = atomicAdd((&words.member[_e185]), _e201);
                            if (_e206 >= (1073741824u - select(_e201, 1073741824u, (1073741824u < _e201)))) {
                                let _e211 = (_e177 * 12u);
                                if (_e211 < _e35) {
                                } else {
                                    break;
                                }
                                let _e215 = atomicOr((&words.member[_e211]), 1u);
                            }
                            let _e216 = (_e193 * 0.6666667f);
                            let _e220 = (_e185 + _e194);
                            let _e222 = floor(((_e77[0] * _e216) + 0.5f));
                            if (_e220 < _e35) {
                            } else {
                                break;
                            }
                            let _e234 = atomicAdd((&words.member[_e220]), bitcast<u32>(select(0i, select(select(i32(_e222), i32(-2147483648), (_e222 < -2147483600f)), 2147483647i, (_e222 > 2147483500f)), (_e222 == _e222))));
                            let _e236 = (_e185 + (_e177 * 6u));
                            let _e238 = floor(((_e77[1] * _e216) + 0.5f));
                            if (_e236 < _e35) {
                            } else {
                                break;
                            }
                            let _e250 = atomicAdd((&words.member[_e236]), bitcast<u32>(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < -2147483600f)), 2147483647i, (_e238 > 2147483500f)), (_e238 == _e238))));
                            let _e252 = (_e185 + (_e177 * 9u));
                            let _e254 = floor(((_e77[2] * _e216) + 0.5f));
                            if (_e252 < _e35) {
                            } else {
                                break;
                            }
                            let _e266 = atomicAdd((&words.member[_e252]), bitcast<u32>(select(0i, select(select(i32(_e254), i32(-2147483648), (_e254 < -2147483600f)), 2147483647i, (_e254 > 2147483500f)), (_e254 == _e254))));
                        }
                        let _e267 = ((_e53[1] * _e60[1]) * _e188);
                        let _e269 = select(0f, _e267, (_e267 > 0f));
                        let _e271 = select(1073741800f, _e269, (_e269 < 1073741800f));
                        let _e272 = (_e177 + _e185);
                        let _e274 = floor((_e271 + 0.5f));
                        let _e279 = select(select(u32(_e274), 0u, (_e274 < 0f)), 4294967295u, (_e274 > 4294967000f));
                        if (_e279 == 0u) {
                        } else {
                            if (_e272 < _e35) {
                            } else {
                                break;
                            }
                            let _e284 = atomicAdd((&words.member[_e272]), _e279);
                            if (_e284 >= (1073741824u - select(_e279, 1073741824u, (1073741824u < _e279)))) {
                                let _e289 = (_e177 * 12u);
                                if (_e289 < _e35) {
                                } else {
                                    break;
                                }
                                let _e293 = atomicOr((&words.member[_e289]), 1u);
                            }
                            let _e294 = (_e271 * 0.6666667f);
                            let _e298 = (_e272 + _e194);
                            let _e300 = floor(((_e77[0] * _e294) + 0.5f));
                            if (_e298 < _e35) {
                            } else {
                                break;
                            }
                            let _e312 = atomicAdd((&words.member[_e298]), bitcast<u32>(select(0i, select(select(i32(_e300), i32(-2147483648), (_e300 < -2147483600f)), 2147483647i, (_e300 > 2147483500f)), (_e300 == _e300))));
                            let _e314 = (_e272 + (_e177 * 6u));
                            let _e316 = floor(((_e77[1] * _e294) + 0.5f));
                            if (_e314 < _e35) {
                            } else {
                                break;
                            }
                            let _e328 = atomicAdd((&words.member[_e314]), bitcast<u32>(select(0i, select(select(i32(_e316), i32(-2147483648), (_e316 < -2147483600f)), 2147483647i, (_e316 > 2147483500f)), (_e316 == _e316))));
                            let _e330 = (_e272 + (_e177 * 9u));
                            let _e332 = floor(((_e77[2] * _e294) + 0.5f));
                            if (_e330 < _e35) {
                            } else {
                                break;
                            }
                            let _e344 = atomicAdd((&words.member[_e330]), bitcast<u32>(select(0i, select(select(i32(_e332), i32(-2147483648), (_e332 < -2147483600f)), 2147483647i, (_e332 > 2147483500f)), (_e332 == _e332))));
                        }
                        let _e345 = ((_e53[2] * _e60[2]) * _e188);
                        let _e347 = select(0f, _e345, (_e345 > 0f));
                        let _e349 = select(1073741800f, _e347, (_e347 < 1073741800f));
                        let _e351 = ((2u * _e177) + _e185);
                        let _e353 = floor((_e349 + 0.5f));
                        let _e358 = select(select(u32(_e353), 0u, (_e353 < 0f)), 4294967295u, (_e353 > 4294967000f));
                        if (_e358 == 0u) {
                        } else {
                            if (_e351 < _e35) {
                            } else {
                                break;
                            }
                            let _e363 = atomicAdd((&words.member[_e351]), _e358);
                            if (_e363 >= (1073741824u - select(_e358, 1073741824u, (1073741824u < _e358)))) {
                                let _e368 = (_e177 * 12u);
                                if (_e368 < _e35) {
                                } else {
                                    break;
                                }
                                let _e372 = atomicOr((&words.member[_e368]), 1u);
                            }
                            let _e373 = (_e349 * 0.6666667f);
                            let _e377 = (_e351 + _e194);
                            let _e379 = floor(((_e77[0] * _e373) + 0.5f));
                            if (_e377 < _e35) {
                            } else {
                                break;
                            }
                            let _e391 = atomicAdd((&words.member[_e377]), bitcast<u32>(select(0i, select(select(i32(_e379), i32(-2147483648), (_e379 < -2147483600f)), 2147483647i, (_e379 > 2147483500f)), (_e379 == _e379))));
                            let _e393 = (_e351 + (_e177 * 6u));
                            let _e395 = floor(((_e77[1] * _e373) + 0.5f));
                            if (_e393 < _e35) {
                            } else {
                                break;
                            }
                            let _e407 = atomicAdd((&words.member[_e393]), bitcast<u32>(select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < -2147483600f)), 2147483647i, (_e395 > 2147483500f)), (_e395 == _e395))));
                            let _e409 = (_e351 + (_e177 * 9u));
                            let _e411 = floor(((_e77[2] * _e373) + 0.5f));
                            if (_e409 < _e35) {
                            } else {
                                break;
                            }
                            let _e423 = atomicAdd((&words.member[_e409]), bitcast<u32>(select(0i, select(select(i32(_e411), i32(-2147483648), (_e411 < -2147483600f)), 2147483647i, (_e411 > 2147483500f)), (_e411 == _e411))));
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
fn lpv_inject(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
