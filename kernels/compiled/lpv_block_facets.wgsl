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
    var phi_271_: bool;
    var phi_273_: bool;
    var phi_274_: bool;
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_366_: bool;
    var phi_368_: bool;
    var phi_369_: bool;
    var phi_370_: bool;
    var phi_371_: bool;
    var phi_372_: bool;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_461_: bool;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_467_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_470_: bool;

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
                let _e108 = params.member.member_1;
                let _e109 = floor(_e103);
                let _e117 = floor(_e104);
                let _e125 = floor(_e105);
                let _e136 = (select(0i, select(select(i32(_e109), i32(-2147483648), (_e109 < -2147483600f)), 2147483647i, (_e109 > 2147483500f)), (_e109 == _e109)) - _e108.x);
                let _e137 = (select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < -2147483600f)), 2147483647i, (_e117 > 2147483500f)), (_e117 == _e117)) - _e108.y);
                let _e138 = (select(0i, select(select(i32(_e125), i32(-2147483648), (_e125 < -2147483600f)), 2147483647i, (_e125 > 2147483500f)), (_e125 == _e125)) - _e108.z);
                let _e142 = floor((_e103 - 0.5f));
                let _e150 = floor((_e104 - 0.5f));
                let _e158 = floor((_e105 - 0.5f));
                let _e166 = (select(0i, select(select(i32(_e142), i32(-2147483648), (_e142 < -2147483600f)), 2147483647i, (_e142 > 2147483500f)), (_e142 == _e142)) - _e108.x);
                let _e167 = (select(0i, select(select(i32(_e150), i32(-2147483648), (_e150 < -2147483600f)), 2147483647i, (_e150 > 2147483500f)), (_e150 == _e150)) - _e108.y);
                let _e168 = (select(0i, select(select(i32(_e158), i32(-2147483648), (_e158 < -2147483600f)), 2147483647i, (_e158 > 2147483500f)), (_e158 == _e158)) - _e108.z);
                let _e169 = abs(_e67);
                let _e174 = floor(((select(16f, _e169, (_e169 < 16f)) * 65536f) + 0.5f));
                let _e179 = select(select(u32(_e174), 0u, (_e174 < 0f)), 4294967295u, (_e174 > 4294967000f));
                let _e182 = params.member.member_2;
                if (_e166 >= 0i) {
                    if (_e137 >= 0i) {
                        if (_e138 >= 0i) {
                            if (_e166 < bitcast<i32>(_e182.x)) {
                                let _e191 = (_e137 < bitcast<i32>(_e182.y));
                                if _e191 {
                                    phi_271_ = (_e138 < bitcast<i32>(_e182.z));
                                } else {
                                    phi_271_ = bool();
                                }
                                let _e196 = phi_271_;
                                phi_273_ = _e196;
                                phi_274_ = select(true, false, _e191);
                            } else {
                                phi_273_ = bool();
                                phi_274_ = true;
                            }
                            let _e199 = phi_273_;
                            let _e201 = phi_274_;
                            phi_275_ = _e199;
                            phi_276_ = _e201;
                        } else {
                            phi_275_ = bool();
                            phi_276_ = true;
                        }
                        let _e203 = phi_275_;
                        let _e205 = phi_276_;
                        phi_277_ = _e203;
                        phi_278_ = _e205;
                    } else {
                        phi_277_ = bool();
                        phi_278_ = true;
                    }
                    let _e207 = phi_277_;
                    let _e209 = phi_278_;
                    phi_279_ = _e207;
                    phi_280_ = _e209;
                } else {
                    phi_279_ = bool();
                    phi_280_ = true;
                }
                let _e211 = phi_279_;
                let _e213 = phi_280_;
                if select(_e211, false, _e213) {
                    if (_e179 > 0u) {
                        let _e217 = (_e182.x + 1u);
                        let _e220 = ((_e182.y + 1u) * _e217);
                        let _e229 = ((((_e220 + _e217) + bitcast<u32>(_e166)) + (bitcast<u32>(_e137) * _e217)) + (bitcast<u32>(_e138) * _e220));
                        if (_e229 < _e34) {
                        } else {
                            break;
                        }
                        let _e233 = atomicAdd((&words.member[_e229]), _e179);
                    }
                }
                let _e234 = abs(_e68);
                let _e239 = floor(((select(16f, _e234, (_e234 < 16f)) * 65536f) + 0.5f));
                let _e244 = select(select(u32(_e239), 0u, (_e239 < 0f)), 4294967295u, (_e239 > 4294967000f));
                let _e245 = (_e136 >= 0i);
                if _e245 {
                    if (_e167 >= 0i) {
                        if (_e138 >= 0i) {
                            if (_e136 < bitcast<i32>(_e182.x)) {
                                let _e253 = (_e167 < bitcast<i32>(_e182.y));
                                if _e253 {
                                    phi_366_ = (_e138 < bitcast<i32>(_e182.z));
                                } else {
                                    phi_366_ = bool();
                                }
                                let _e258 = phi_366_;
                                phi_368_ = _e258;
                                phi_369_ = select(true, false, _e253);
                            } else {
                                phi_368_ = bool();
                                phi_369_ = true;
                            }
                            let _e261 = phi_368_;
                            let _e263 = phi_369_;
                            phi_370_ = _e261;
                            phi_371_ = _e263;
                        } else {
                            phi_370_ = bool();
                            phi_371_ = true;
                        }
                        let _e265 = phi_370_;
                        let _e267 = phi_371_;
                        phi_372_ = _e265;
                        phi_373_ = _e267;
                    } else {
                        phi_372_ = bool();
                        phi_373_ = true;
                    }
                    let _e269 = phi_372_;
                    let _e271 = phi_373_;
                    phi_374_ = _e269;
                    phi_375_ = _e271;
                } else {
                    phi_374_ = bool();
                    phi_375_ = true;
                }
                let _e273 = phi_374_;
                let _e275 = phi_375_;
                if select(_e273, false, _e275) {
                    if (_e244 > 0u) {
                        let _e279 = (_e182.x + 1u);
                        let _e282 = ((_e182.y + 1u) * _e279);
                        let _e283 = (_e282 + _e279);
                        let _e296 = ((_e283 + ((_e182.z + 1u) * _e282)) + (((_e283 + bitcast<u32>(_e136)) + (bitcast<u32>(_e167) * _e279)) + (bitcast<u32>(_e138) * _e282)));
                        if (_e296 < _e34) {
                        } else {
                            break;
                        }
                        let _e300 = atomicAdd((&words.member[_e296]), _e244);
                    }
                }
                let _e301 = abs(_e69);
                let _e306 = floor(((select(16f, _e301, (_e301 < 16f)) * 65536f) + 0.5f));
                let _e311 = select(select(u32(_e306), 0u, (_e306 < 0f)), 4294967295u, (_e306 > 4294967000f));
                if _e245 {
                    if (_e137 >= 0i) {
                        if (_e168 >= 0i) {
                            if (_e136 < bitcast<i32>(_e182.x)) {
                                let _e319 = (_e137 < bitcast<i32>(_e182.y));
                                if _e319 {
                                    phi_461_ = (_e168 < bitcast<i32>(_e182.z));
                                } else {
                                    phi_461_ = bool();
                                }
                                let _e324 = phi_461_;
                                phi_463_ = _e324;
                                phi_464_ = select(true, false, _e319);
                            } else {
                                phi_463_ = bool();
                                phi_464_ = true;
                            }
                            let _e327 = phi_463_;
                            let _e329 = phi_464_;
                            phi_465_ = _e327;
                            phi_466_ = _e329;
                        } else {
                            phi_465_ = bool();
                            phi_466_ = true;
                        }
                        let _e331 = phi_465_;
                        let _e333 = phi_466_;
                        phi_467_ = _e331;
                        phi_468_ = _e333;
                    } else {
                        phi_467_ = bool();
                        phi_468_ = true;
                    }
                    let _e335 = phi_467_;
                    let _e337 = phi_468_;
                    phi_469_ = _e335;
                    phi_470_ = _e337;
                } else {
                    phi_469_ = bool();
                    phi_470_ = true;
                }
                let _e339 = phi_469_;
                let _e341 = phi_470_;
                if select(_e339, false, _e341) {
                    if (_e311 > 0u) {
                        let _e345 = (_e182.x + 1u);
                        let _e348 = ((_e182.y + 1u) * _e345);
                        let _e349 = (_e348 + _e345);
                        let _e363 = ((2u * (_e349 + ((_e182.z + 1u) * _e348))) + (((_e349 + bitcast<u32>(_e136)) + (bitcast<u32>(_e137) * _e345)) + (bitcast<u32>(_e168) * _e348)));
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
