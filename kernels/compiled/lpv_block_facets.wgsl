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
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: vec4<f32>,
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
@group(0) @binding(1) 
var<storage> facets: type_17;
@group(0) @binding(2) 
var<storage, read_write> words: type_29;

fn function_() {
    var phi_203_: bool;
    var phi_205_: bool;
    var phi_206_: bool;
    var phi_207_: bool;
    var phi_208_: bool;
    var phi_209_: bool;
    var phi_210_: bool;
    var phi_211_: bool;
    var phi_212_: bool;
    var phi_339_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_475_: bool;
    var phi_477_: bool;
    var phi_478_: bool;
    var phi_479_: bool;
    var phi_480_: bool;
    var phi_481_: bool;
    var phi_482_: bool;
    var phi_483_: bool;
    var phi_484_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = gid_1;
            let _e30 = arrayLength((&words.member));
            let _e34 = (_e26.x + (_e26.y * 2097152u));
            let _e37 = params.member.member_5;
            if (_e34 < _e37) {
                if (_e34 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e42 = params.member.member_13;
                let _e46 = params.member.member[3u];
                let _e47 = (_e42 / _e46);
                let _e51 = facets.member[_e34].member;
                let _e58 = facets.member[_e34].member_2;
                let _e62 = (_e47 * _e47);
                let _e68 = params.member.member;
                let _e76 = ((_e51[0] - _e68.x) / _e68.w);
                let _e77 = ((_e51[1] - _e68.y) / _e68.w);
                let _e78 = ((_e51[2] - _e68.z) / _e68.w);
                let _e80 = abs((_e58[0] * _e62));
                let _e83 = params.member.member_1;
                let _e84 = floor((_e76 - 0.5f));
                let _e92 = floor(_e77);
                let _e100 = floor(_e78);
                let _e111 = (select(0i, select(select(i32(_e84), i32(-2147483648), (_e84 < -2147483600f)), 2147483647i, (_e84 > 2147483500f)), (_e84 == _e84)) - _e83.x);
                let _e112 = (select(0i, select(select(i32(_e92), i32(-2147483648), (_e92 < -2147483600f)), 2147483647i, (_e92 > 2147483500f)), (_e92 == _e92)) - _e83.y);
                let _e113 = (select(0i, select(select(i32(_e100), i32(-2147483648), (_e100 < -2147483600f)), 2147483647i, (_e100 > 2147483500f)), (_e100 == _e100)) - _e83.z);
                let _e118 = floor(((select(16f, _e80, (_e80 < 16f)) * 65536f) + 0.5f));
                let _e123 = select(select(u32(_e118), 0u, (_e118 < 0f)), 4294967295u, (_e118 > 4294967000f));
                let _e126 = params.member.member_2;
                if (_e111 >= 0i) {
                    if (_e112 >= 0i) {
                        if (_e113 >= 0i) {
                            if (_e111 < bitcast<i32>(_e126.x)) {
                                let _e135 = (_e112 < bitcast<i32>(_e126.y));
                                if _e135 {
                                    phi_203_ = (_e113 < bitcast<i32>(_e126.z));
                                } else {
                                    phi_203_ = bool();
                                }
                                let _e140 = phi_203_;
                                phi_205_ = _e140;
                                phi_206_ = select(true, false, _e135);
                            } else {
                                phi_205_ = bool();
                                phi_206_ = true;
                            }
                            let _e143 = phi_205_;
                            let _e145 = phi_206_;
                            phi_207_ = _e143;
                            phi_208_ = _e145;
                        } else {
                            phi_207_ = bool();
                            phi_208_ = true;
                        }
                        let _e147 = phi_207_;
                        let _e149 = phi_208_;
                        phi_209_ = _e147;
                        phi_210_ = _e149;
                    } else {
                        phi_209_ = bool();
                        phi_210_ = true;
                    }
                    let _e151 = phi_209_;
                    let _e153 = phi_210_;
                    phi_211_ = _e151;
                    phi_212_ = _e153;
                } else {
                    phi_211_ = bool();
                    phi_212_ = true;
                }
                let _e155 = phi_211_;
                let _e157 = phi_212_;
                if select(_e155, false, _e157) {
                    if (_e123 > 0u) {
                        let _e161 = (_e126.x + 1u);
                        let _e164 = ((_e126.y + 1u) * _e161);
                        let _e173 = ((((_e164 + _e161) + bitcast<u32>(_e111)) + (bitcast<u32>(_e112) * _e161)) + (bitcast<u32>(_e113) * _e164));
                        if (_e173 < _e30) {
                        } else {
                            break;
                        }
                        let _e177 = atomicAdd((&words.member[_e173]), _e123);
                    }
                }
                let _e179 = abs((_e58[1] * _e62));
                let _e180 = floor(_e76);
                let _e188 = floor((_e77 - 0.5f));
                let _e196 = (select(0i, select(select(i32(_e180), i32(-2147483648), (_e180 < -2147483600f)), 2147483647i, (_e180 > 2147483500f)), (_e180 == _e180)) - _e83.x);
                let _e197 = (select(0i, select(select(i32(_e188), i32(-2147483648), (_e188 < -2147483600f)), 2147483647i, (_e188 > 2147483500f)), (_e188 == _e188)) - _e83.y);
                let _e202 = floor(((select(16f, _e179, (_e179 < 16f)) * 65536f) + 0.5f));
                let _e207 = select(select(u32(_e202), 0u, (_e202 < 0f)), 4294967295u, (_e202 > 4294967000f));
                let _e208 = (_e196 >= 0i);
                if _e208 {
                    if (_e197 >= 0i) {
                        if (_e113 >= 0i) {
                            if (_e196 < bitcast<i32>(_e126.x)) {
                                let _e216 = (_e197 < bitcast<i32>(_e126.y));
                                if _e216 {
                                    phi_339_ = (_e113 < bitcast<i32>(_e126.z));
                                } else {
                                    phi_339_ = bool();
                                }
                                let _e221 = phi_339_;
                                phi_341_ = _e221;
                                phi_342_ = select(true, false, _e216);
                            } else {
                                phi_341_ = bool();
                                phi_342_ = true;
                            }
                            let _e224 = phi_341_;
                            let _e226 = phi_342_;
                            phi_343_ = _e224;
                            phi_344_ = _e226;
                        } else {
                            phi_343_ = bool();
                            phi_344_ = true;
                        }
                        let _e228 = phi_343_;
                        let _e230 = phi_344_;
                        phi_345_ = _e228;
                        phi_346_ = _e230;
                    } else {
                        phi_345_ = bool();
                        phi_346_ = true;
                    }
                    let _e232 = phi_345_;
                    let _e234 = phi_346_;
                    phi_347_ = _e232;
                    phi_348_ = _e234;
                } else {
                    phi_347_ = bool();
                    phi_348_ = true;
                }
                let _e236 = phi_347_;
                let _e238 = phi_348_;
                if select(_e236, false, _e238) {
                    if (_e207 > 0u) {
                        let _e242 = (_e126.x + 1u);
                        let _e245 = ((_e126.y + 1u) * _e242);
                        let _e246 = (_e245 + _e242);
                        let _e259 = ((_e246 + ((_e126.z + 1u) * _e245)) + (((_e246 + bitcast<u32>(_e196)) + (bitcast<u32>(_e197) * _e242)) + (bitcast<u32>(_e113) * _e245)));
                        if (_e259 < _e30) {
                        } else {
                            break;
                        }
                        let _e263 = atomicAdd((&words.member[_e259]), _e207);
                    }
                }
                let _e265 = abs((_e58[2] * _e62));
                let _e266 = floor((_e78 - 0.5f));
                let _e274 = (select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < -2147483600f)), 2147483647i, (_e266 > 2147483500f)), (_e266 == _e266)) - _e83.z);
                let _e279 = floor(((select(16f, _e265, (_e265 < 16f)) * 65536f) + 0.5f));
                let _e284 = select(select(u32(_e279), 0u, (_e279 < 0f)), 4294967295u, (_e279 > 4294967000f));
                if _e208 {
                    if (_e112 >= 0i) {
                        if (_e274 >= 0i) {
                            if (_e196 < bitcast<i32>(_e126.x)) {
                                let _e292 = (_e112 < bitcast<i32>(_e126.y));
                                if _e292 {
                                    phi_475_ = (_e274 < bitcast<i32>(_e126.z));
                                } else {
                                    phi_475_ = bool();
                                }
                                let _e297 = phi_475_;
                                phi_477_ = _e297;
                                phi_478_ = select(true, false, _e292);
                            } else {
                                phi_477_ = bool();
                                phi_478_ = true;
                            }
                            let _e300 = phi_477_;
                            let _e302 = phi_478_;
                            phi_479_ = _e300;
                            phi_480_ = _e302;
                        } else {
                            phi_479_ = bool();
                            phi_480_ = true;
                        }
                        let _e304 = phi_479_;
                        let _e306 = phi_480_;
                        phi_481_ = _e304;
                        phi_482_ = _e306;
                    } else {
                        phi_481_ = bool();
                        phi_482_ = true;
                    }
                    let _e308 = phi_481_;
                    let _e310 = phi_482_;
                    phi_483_ = _e308;
                    phi_484_ = _e310;
                } else {
                    phi_483_ = bool();
                    phi_484_ = true;
                }
                let _e312 = phi_483_;
                let _e314 = phi_484_;
                if select(_e312, false, _e314) {
                    if (_e284 > 0u) {
                        let _e318 = (_e126.x + 1u);
                        let _e321 = ((_e126.y + 1u) * _e318);
                        let _e322 = (_e321 + _e318);
                        let _e336 = ((2u * (_e322 + ((_e126.z + 1u) * _e321))) + (((_e322 + bitcast<u32>(_e196)) + (bitcast<u32>(_e112) * _e318)) + (bitcast<u32>(_e274) * _e321)));
                        if (_e336 < _e30) {
                        } else {
                            break;
                        }
                        let _e340 = atomicAdd((&words.member[_e336]), _e284);
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
