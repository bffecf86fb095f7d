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
@group(0) @binding(2) 
var<storage, read_write> words: type_29;
@group(0) @binding(1) 
var<storage> texels: type_17;

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

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = gid_1;
            let _e36 = arrayLength((&words.member));
            let _e40 = (_e32.x + (_e32.y * 2097152u));
            let _e43 = params.member.member_5;
            if (_e40 < _e43) {
                if (_e40 < arrayLength((&texels.member))) {
                } else {
                    break;
                }
                let _e49 = texels.member[_e40].member_3;
                if (_e49 == 1u) {
                    let _e54 = texels.member[_e40].member_4;
                    let _e61 = texels.member[_e40].member_6;
                    let _e65 = (_e54[0] * _e61[0]);
                    let _e66 = (_e54[1] * _e61[1]);
                    let _e67 = (_e54[2] * _e61[2]);
                    let _e71 = texels.member[_e40].member;
                    let _e78 = texels.member[_e40].member_2;
                    let _e84 = params.member.member_1;
                    let _e87 = params.member.member;
                    let _e104 = floor((((_e71[0] - _e87.x) / _e87.w) + (_e78[0] * 0.5f)));
                    let _e112 = floor((((_e71[1] - _e87.y) / _e87.w) + (_e78[1] * 0.5f)));
                    let _e120 = floor((((_e71[2] - _e87.z) / _e87.w) + (_e78[2] * 0.5f)));
                    let _e131 = (select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < -2147483600f)), 2147483647i, (_e104 > 2147483500f)), (_e104 == _e104)) - _e84.x);
                    let _e132 = (select(0i, select(select(i32(_e112), i32(-2147483648), (_e112 < -2147483600f)), 2147483647i, (_e112 > 2147483500f)), (_e112 == _e112)) - _e84.y);
                    let _e133 = (select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < -2147483600f)), 2147483647i, (_e120 > 2147483500f)), (_e120 == _e120)) - _e84.z);
                    let _e136 = params.member.member_2;
                    if (_e131 >= 0i) {
                        if (_e132 >= 0i) {
                            if (_e133 >= 0i) {
                                if (_e131 < bitcast<i32>(_e136.x)) {
                                    let _e145 = (_e132 < bitcast<i32>(_e136.y));
                                    if _e145 {
                                        phi_203_ = (_e133 < bitcast<i32>(_e136.z));
                                    } else {
                                        phi_203_ = bool();
                                    }
                                    let _e150 = phi_203_;
                                    phi_205_ = _e150;
                                    phi_206_ = select(true, false, _e145);
                                } else {
                                    phi_205_ = bool();
                                    phi_206_ = true;
                                }
                                let _e153 = phi_205_;
                                let _e155 = phi_206_;
                                phi_207_ = _e153;
                                phi_208_ = _e155;
                            } else {
                                phi_207_ = bool();
                                phi_208_ = true;
                            }
                            let _e157 = phi_207_;
                            let _e159 = phi_208_;
                            phi_209_ = _e157;
                            phi_210_ = _e159;
                        } else {
                            phi_209_ = bool();
                            phi_210_ = true;
                        }
                        let _e161 = phi_209_;
                        let _e163 = phi_210_;
                        phi_211_ = _e161;
                        phi_212_ = _e163;
                    } else {
                        phi_211_ = bool();
                        phi_212_ = true;
                    }
                    let _e165 = phi_211_;
                    let _e167 = phi_212_;
                    if select(_e165, false, _e167) {
                        let _e170 = (_e136.x + 1u);
                        let _e173 = ((_e136.y + 1u) * _e170);
                        let _e174 = (_e173 + _e170);
                        let _e178 = (_e174 + ((_e136.z + 1u) * _e173));
                        let _e186 = (((_e174 + bitcast<u32>(_e131)) + (bitcast<u32>(_e132) * _e170)) + (bitcast<u32>(_e133) * _e173));
                        let _e189 = params.member.member_16;
                        if (_e189 <= 1u) {
                            let _e193 = params.member.member_7;
                            let _e194 = (_e65 * _e193);
                            let _e196 = select(0f, _e194, (_e194 > 0f));
                            let _e198 = select(1073741800f, _e196, (_e196 < 1073741800f));
                            let _e199 = (3u * _e178);
                            let _e201 = floor((_e198 + 0.5f));
                            let _e206 = select(select(u32(_e201), 0u, (_e201 < 0f)), 4294967295u, (_e201 > 4294967000f));
                            if (_e206 == 0u) {
                            } else {
                                if (_e186 < _e36) {
                                } else {
                                    break;
                                }
                                let _e211 = atomicAdd((&words.member[_e186]), _e206);
                                if (_e211 >= (1073741824u - select(_e206, 1073741824u, (1073741824u < _e206)))) {
                                    let _e219 = ((_e178 * 12u) * select(1u, _e189, (1u < _e189)));
                                    if (_e219 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e223 = atomicOr((&words.member[_e219]), 1u);
                                }
                                let _e224 = (_e198 * 0.6666667f);
                                let _e228 = (_e186 + _e199);
                                let _e230 = floor(((_e78[0] * _e224) + 0.5f));
                                if (_e228 < _e36) {
                                } else {
                                    break;
                                }
                                let _e242 = atomicAdd((&words.member[_e228]), bitcast<u32>(select(0i, select(select(i32(_e230), i32(-2147483648), (_e230 < -2147483600f)), 2147483647i, (_e230 > 2147483500f)), (_e230 == _e230))));
                                let _e244 = (_e186 + (_e178 * 6u));
                                let _e246 = floor(((_e78[1] * _e224) + 0.5f));
                                if (_e244 < _e36) {
                                } else {
                                    break;
                                }
                                let _e258 = atomicAdd((&words.member[_e244]), bitcast<u32>(select(0i, select(select(i32(_e246), i32(-2147483648), (_e246 < -2147483600f)), 2147483647i, (_e246 > 2147483500f)), (_e246 == _e246))));
                                let _e260 = (_e186 + (_e178 * 9u));
                                let _e262 = floor(((_e78[2] * _e224) + 0.5f));
                                if (_e260 < _e36) {
                                } else {
                                    break;
                                }
                                let _e274 = atomicAdd((&words.member[_e260]), bitcast<u32>(select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < -2147483600f)), 2147483647i, (_e262 > 2147483500f)), (_e262 == _e262))));
                            }
                            let _e275 = (_e66 * _e193);
                            let _e277 = select(0f, _e275, (_e275 > 0f));
                            let _e279 = select(1073741800f, _e277, (_e277 < 1073741800f));
                            let _e280 = (_e178 + _e186);
                            let _e282 = floor((_e279 + 0.5f));
                            let _e287 = select(select(u32(_e282), 0u, (_e282 < 0f)), 4294967295u, (_e282 > 4294967000f));
                            if (_e287 == 0u) {
                            } else {
                                if (_e280 < _e36) {
                                } else {
                                    break;
                                }
                                let _e292 = atomicAdd((&words.member[_e280]), _e287);
                                if (_e292 >= (1073741824u - select(_e287, 1073741824u, (1073741824u < _e287)))) {
                                    let _e300 = ((_e178 * 12u) * select(1u, _e189, (1u < _e189)));
                                    if (_e300 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e304 = atomicOr((&words.member[_e300]), 1u);
                                }
                                let _e305 = (_e279 * 0.6666667f);
                                let _e309 = (_e280 + _e199);
                                let _e311 = floor(((_e78[0] * _e305) + 0.5f));
                                if (_e309 < _e36) {
                                } else {
                                    break;
                                }
                                let _e323 = atomicAdd((&words.member[_e309]), bitcast<u32>(select(0i, select(select(i32(_e311), i32(-2147483648), (_e311 < -2147483600f)), 2147483647i, (_e311 > 2147483500f)), (_e311 == _e311))));
                                let _e325 = (_e280 + (_e178 * 6u));
                                let _e327 = floor(((_e78[1] * _e305) + 0.5f));
                                if (_e325 < _e36) {
                                } else {
                                    break;
                                }
                                let _e339 = atomicAdd((&words.member[_e325]), bitcast<u32>(select(0i, select(select(i32(_e327), i32(-2147483648), (_e327 < -2147483600f)), 2147483647i, (_e327 > 2147483500f)), (_e327 == _e327))));
                                let _e341 = (_e280 + (_e178 * 9u));
                                let _e343 = floor(((_e78[2] * _e305) + 0.5f));
                                if (_e341 < _e36) {
                                } else {
                                    break;
                                }
                                let _e355 = atomicAdd((&words.member[_e341]), bitcast<u32>(select(0i, select(select(i32(_e343), i32(-2147483648), (_e343 < -2147483600f)), 2147483647i, (_e343 > 2147483500f)), (_e343 == _e343))));
                            }
                            let _e356 = (_e67 * _e193);
                            let _e358 = select(0f, _e356, (_e356 > 0f));
                            let _e360 = select(1073741800f, _e358, (_e358 < 1073741800f));
                            let _e362 = ((2u * _e178) + _e186);
                            let _e364 = floor((_e360 + 0.5f));
                            let _e369 = select(select(u32(_e364), 0u, (_e364 < 0f)), 4294967295u, (_e364 > 4294967000f));
                            if (_e369 == 0u) {
                            } else {
                                if (_e362 < _e36) {
                                } else {
                                    break;
                                }
                                let _e374 = atomicAdd((&words.member[_e362]), _e369);
                                if (_e374 >= (1073741824u - select(_e369, 1073741824u, (1073741824u < _e369)))) {
                                    let _e382 = ((_e178 * 12u) * select(1u, _e189, (1u < _e189)));
                                    if (_e382 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e386 = atomicOr((&words.member[_e382]), 1u);
                                }
                                let _e387 = (_e360 * 0.6666667f);
                                let _e391 = (_e362 + _e199);
                                let _e393 = floor(((_e78[0] * _e387) + 0.5f));
                                if (_e391 < _e36) {
                                } else {
                                    break;
                                }
                                let _e405 = atomicAdd((&words.member[_e391]), bitcast<u32>(select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < -2147483600f)), 2147483647i, (_e393 > 2147483500f)), (_e393 == _e393))));
                                let _e407 = (_e362 + (_e178 * 6u));
                                let _e409 = floor(((_e78[1] * _e387) + 0.5f));
                                if (_e407 < _e36) {
                                } else {
                                    break;
                                }
                                let _e421 = atomicAdd((&words.member[_e407]), bitcast<u32>(select(0i, select(select(i32(_e409), i32(-2147483648), (_e409 < -2147483600f)), 2147483647i, (_e409 > 2147483500f)), (_e409 == _e409))));
                                let _e423 = (_e362 + (_e178 * 9u));
                                let _e425 = floor(((_e78[2] * _e387) + 0.5f));
                                if (_e423 < _e36) {
                                } else {
                                    break;
                                }
                                let _e437 = atomicAdd((&words.member[_e423]), bitcast<u32>(select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < -2147483600f)), 2147483647i, (_e425 > 2147483500f)), (_e425 == _e425))));
                            }
                        } else {
                            let _e438 = (3u * _e178);
                            let _e439 = (_e178 * 12u);
                            let _e443 = ((select(0u, 1u, (_e78[0] < 0f)) * _e439) + _e186);
                            let _e444 = (_e78[0] * _e78[0]);
                            let _e450 = params.member.member_7;
                            let _e451 = ((_e65 * _e444) * _e450);
                            let _e453 = select(0f, _e451, (_e451 > 0f));
                            let _e455 = select(1073741800f, _e453, (_e453 < 1073741800f));
                            let _e457 = floor((_e455 + 0.5f));
                            let _e462 = select(select(u32(_e457), 0u, (_e457 < 0f)), 4294967295u, (_e457 > 4294967000f));
                            if (_e462 == 0u) {
                            } else {
                                if (_e443 < _e36) {
                                } else {
                                    break;
                                }
                                let _e467 = atomicAdd((&words.member[_e443]), _e462);
                                if (_e467 >= (1073741824u - select(_e462, 1073741824u, (1073741824u < _e462)))) {
                                    let _e474 = (_e439 * select(1u, _e189, (1u < _e189)));
                                    if (_e474 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e478 = atomicOr((&words.member[_e474]), 1u);
                                }
                                let _e479 = (_e455 * 0.6666667f);
                                let _e483 = (_e443 + _e438);
                                let _e485 = floor(((_e78[0] * _e479) + 0.5f));
                                if (_e483 < _e36) {
                                } else {
                                    break;
                                }
                                let _e497 = atomicAdd((&words.member[_e483]), bitcast<u32>(select(0i, select(select(i32(_e485), i32(-2147483648), (_e485 < -2147483600f)), 2147483647i, (_e485 > 2147483500f)), (_e485 == _e485))));
                                let _e499 = (_e443 + (_e178 * 6u));
                                let _e501 = floor(((_e78[1] * _e479) + 0.5f));
                                if (_e499 < _e36) {
                                } else {
                                    break;
                                }
                                let _e513 = atomicAdd((&words.member[_e499]), bitcast<u32>(select(0i, select(select(i32(_e501), i32(-2147483648), (_e501 < -2147483600f)), 2147483647i, (_e501 > 2147483500f)), (_e501 == _e501))));
                                let _e515 = (_e443 + (_e178 * 9u));
                                let _e517 = floor(((_e78[2] * _e479) + 0.5f));
                                if (_e515 < _e36) {
                                } else {
                                    break;
                                }
                                let _e529 = atomicAdd((&words.member[_e515]), bitcast<u32>(select(0i, select(select(i32(_e517), i32(-2147483648), (_e517 < -2147483600f)), 2147483647i, (_e517 > 2147483500f)), (_e517 == _e517))));
                            }
                            let _e530 = ((_e66 * _e444) * _e450);
                            let _e532 = select(0f, _e530, (_e530 > 0f));
                            let _e534 = select(1073741800f, _e532, (_e532 < 1073741800f));
                            let _e535 = (_e178 + _e443);
                            let _e537 = floor((_e534 + 0.5f));
                            let _e542 = select(select(u32(_e537), 0u, (_e537 < 0f)), 4294967295u, (_e537 > 4294967000f));
                            if (_e542 == 0u) {
                            } else {
                                if (_e535 < _e36) {
                                } else {
                                    break;
                                }
                                let _e547 = atomicAdd((&words.member[_e535]), _e542);
                                if (_e547 >= (1073741824u - select(_e542, 1073741824u, (1073741824u < _e542)))) {
                                    let _e554 = (_e439 * select(1u, _e189, (1u < _e189)));
                                    if (_e554 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e558 = atomicOr((&words.member[_e554]), 1u);
                                }
                                let _e559 = (_e534 * 0.6666667f);
                                let _e563 = (_e535 + _e438);
                                let _e565 = floor(((_e78[0] * _e559) + 0.5f));
                                if (_e563 < _e36) {
                                } else {
                                    break;
                                }
                                let _e577 = atomicAdd((&words.member[_e563]), bitcast<u32>(select(0i, select(select(i32(_e565), i32(-2147483648), (_e565 < -2147483600f)), 2147483647i, (_e565 > 2147483500f)), (_e565 == _e565))));
                                let _e579 = (_e535 + (_e178 * 6u));
                                let _e581 = floor(((_e78[1] * _e559) + 0.5f));
                                if (_e579 < _e36) {
                                } else {
                                    break;
                                }
                                let _e593 = atomicAdd((&words.member[_e579]), bitcast<u32>(select(0i, select(select(i32(_e581), i32(-2147483648), (_e581 < -2147483600f)), 2147483647i, (_e581 > 2147483500f)), (_e581 == _e581))));
                                let _e595 = (_e535 + (_e178 * 9u));
                                let _e597 = floor(((_e78[2] * _e559) + 0.5f));
                                if (_e595 < _e36) {
                                } else {
                                    break;
                                }
                                let _e609 = atomicAdd((&words.member[_e595]), bitcast<u32>(select(0i, select(select(i32(_e597), i32(-2147483648), (_e597 < -2147483600f)), 2147483647i, (_e597 > 2147483500f)), (_e597 == _e597))));
                            }
                            let _e610 = ((_e67 * _e444) * _e450);
                            let _e612 = select(0f, _e610, (_e610 > 0f));
                            let _e614 = select(1073741800f, _e612, (_e612 < 1073741800f));
                            let _e615 = (2u * _e178);
                            let _e616 = (_e615 + _e443);
                            let _e618 = floor((_e614 + 0.5f));
                            let _e623 = select(select(u32(_e618), 0u, (_e618 < 0f)), 4294967295u, (_e618 > 4294967000f));
                            if (_e623 == 0u) {
                            } else {
                                if (_e616 < _e36) {
                                } else {
                                    break;
                                }
                                let _e628 = atomicAdd((&words.member[_e616]), _e623);
                                if (_e628 >= (1073741824u - select(_e623, 1073741824u, (1073741824u < _e623)))) {
                                    let _e635 = (_e439 * select(1u, _e189, (1u < _e189)));
                                    if (_e635 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e639 = atomicOr((&words.member[_e635]), 1u);
                                }
                                let _e640 = (_e614 * 0.6666667f);
                                let _e644 = (_e616 + _e438);
                                let _e646 = floor(((_e78[0] * _e640) + 0.5f));
                                if (_e644 < _e36) {
                                } else {
                                    break;
                                }
                                let _e658 = atomicAdd((&words.member[_e644]), bitcast<u32>(select(0i, select(select(i32(_e646), i32(-2147483648), (_e646 < -2147483600f)), 2147483647i, (_e646 > 2147483500f)), (_e646 == _e646))));
                                let _e660 = (_e616 + (_e178 * 6u));
                                let _e662 = floor(((_e78[1] * _e640) + 0.5f));
                                if (_e660 < _e36) {
                                } else {
                                    break;
                                }
                                let _e674 = atomicAdd((&words.member[_e660]), bitcast<u32>(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < -2147483600f)), 2147483647i, (_e662 > 2147483500f)), (_e662 == _e662))));
                                let _e676 = (_e616 + (_e178 * 9u));
                                let _e678 = floor(((_e78[2] * _e640) + 0.5f));
                                if (_e676 < _e36) {
                                } else {
                                    break;
                                }
                                let _e690 = atomicAdd((&words.member[_e676]), bitcast<u32>(select(0i, select(select(i32(_e678), i32(-2147483648), (_e678 < -2147483600f)), 2147483647i, (_e678 > 2147483500f)), (_e678 == _e678))));
                            }
                            let _e695 = (((2u + select(0u, 1u, (_e78[1] < 0f))) * _e439) + _e186);
                            let _e696 = (_e78[1] * _e78[1]);
                            let _e700 = ((_e65 * _e696) * _e450);
                            let _e702 = select(0f, _e700, (_e700 > 0f));
                            let _e704 = select(1073741800f, _e702, (_e702 < 1073741800f));
                            let _e706 = floor((_e704 + 0.5f));
                            let _e711 = select(select(u32(_e706), 0u, (_e706 < 0f)), 4294967295u, (_e706 > 4294967000f));
                            if (_e711 == 0u) {
                            } else {
                                if (_e695 < _e36) {
                                } else {
                                    break;
                                }
                                let _e716 = atomicAdd((&words.member[_e695]), _e711);
                                if (_e716 >= (1073741824u - select(_e711, 1073741824u, (1073741824u < _e711)))) {
                                    let _e723 = (_e439 * select(1u, _e189, (1u < _e189)));
                                    if (_e723 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e727 = atomicOr((&words.member[_e723]), 1u);
                                }
                                let _e728 = (_e704 * 0.6666667f);
                                let _e732 = (_e695 + _e438);
                                let _e734 = floor(((_e78[0] * _e728) + 0.5f));
                                if (_e732 < _e36) {
                                } else {
                                    break;
                                }
                                let _e746 = atomicAdd((&words.member[_e732]), bitcast<u32>(select(0i, select(select(i32(_e734), i32(-2147483648), (_e734 < -2147483600f)), 2147483647i, (_e734 > 2147483500f)), (_e734 == _e734))));
                                let _e748 = (_e695 + (_e178 * 6u));
                                let _e750 = floor(((_e78[1] * _e728) + 0.5f));
                                if (_e748 < _e36) {
                                } else {
                                    break;
                                }
                                let _e762 = atomicAdd((&words.member[_e748]), bitcast<u32>(select(0i, select(select(i32(_e750), i32(-2147483648), (_e750 < -2147483600f)), 2147483647i, (_e750 > 2147483500f)), (_e750 == _e750))));
                                let _e764 = (_e695 + (_e178 * 9u));
                                let _e766 = floor(((_e78[2] * _e728) + 0.5f));
                                if (_e764 < _e36) {
                                } else {
                                    break;
                                }
                                let _e778 = atomicAdd((&words.member[_e764]), bitcast<u32>(select(0i, select(select(i32(_e766), i32(-2147483648), (_e766 < -2147483600f)), 2147483647i, (_e766 > 2147483500f)), (_e766 == _e766))));
                            }
                            let _e779 = ((_e66 * _e696) * _e450);
                            let _e781 = select(0f, _e779, (_e779 > 0f));
                            let _e783 = select(1073741800f, _e781, (_e781 < 1073741800f));
                            let _e784 = (_e178 + _e695);
                            let _e786 = floor((_e783 + 0.5f));
                            let _e791 = select(select(u32(_e786), 0u, (_e786 < 0f)), 4294967295u, (_e786 > 4294967000f));
                            if (_e791 == 0u) {
                            } else {
                                if (_e784 < _e36) {
                                } else {
                                    break;
                                }
                                let _e796 = atomicAdd((&words.member[_e784]), _e791);
                                if (_e796 >= (1073741824u - select(_e791, 1073741824u, (1073741824u < _e791)))) {
                                    let _e803 = (_e439 * select(1u, _e189, (1u < _e189)));
                                    if (_e803 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e807 = atomicOr((&words.member[_e803]), 1u);
                                }
                                let _e808 = (_e783 * 0.6666667f);
                                let _e812 = (_e784 + _e438);
                                let _e814 = floor(((_e78[0] * _e808) + 0.5f));
                                if (_e812 < _e36) {
                                } else {
                                    break;
                                }
                                let _e826 = atomicAdd((&words.member[_e812]), bitcast<u32>(select(0i, select(select(i32(_e814), i32(-2147483648), (_e814 < -2147483600f)), 2147483647i, (_e814 > 2147483500f)), (_e814 == _e814))));
                                let _e828 = (_e784 + (_e178 * 6u));
                                let _e830 = floor(((_e78[1] * _e808) + 0.5f));
                                if (_e828 < _e36) {
                                } else {
                                    break;
                                }
                                let _e842 = atomicAdd((&words.member[_e828]), bitcast<u32>(select(0i, select(select(i32(_e830), i32(-2147483648), (_e830 < -2147483600f)), 2147483647i, (_e830 > 2147483500f)), (_e830 == _e830))));
                                let _e844 = (_e784 + (_e178 * 9u));
                                let _e846 = floor(((_e78[2] * _e808) + 0.5f));
                                if (_e844 < _e36) {
                                } else {
                                    break;
                                }
                                let _e858 = atomicAdd((&words.member[_e844]), bitcast<u32>(select(0i, select(select(i32(_e846), i32(-2147483648), (_e846 < -2147483600f)), 2147483647i, (_e846 > 2147483500f)), (_e846 == _e846))));
                            }
                            let _e859 = ((_e67 * _e696) * _e450);
                            let _e861 = select(0f, _e859, (_e859 > 0f));
                            let _e863 = select(1073741800f, _e861, (_e861 < 1073741800f));
                            let _e864 = (_e615 + _e695);
                            let _e866 = floor((_e863 + 0.5f));
                            let _e871 = select(select(u32(_e866), 0u, (_e866 < 0f)), 4294967295u, (_e866 > 4294967000f));
                            if (_e871 == 0u) {
                            } else {
                                if (_e864 < _e36) {
                                } else {
                                    break;
                                }
                                let _e876 = atomicAdd((&words.member[_e864]), _e871);
                                if (_e876 >= (1073741824u - select(_e871, 1073741824u, (1073741824u < _e871)))) {
                                    let _e883 = (_e439 * select(1u, _e189, (1u < _e189)));
                                    if (_e883 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e887 = atomicOr((&words.member[_e883]), 1u);
                                }
                                let _e888 = (_e863 * 0.6666667f);
                                let _e892 = (_e864 + _e438);
                                let _e894 = floor(((_e78[0] * _e888) + 0.5f));
                                if (_e892 < _e36) {
                                } else {
                                    break;
                                }
                                let _e906 = atomicAdd((&words.member[_e892]), bitcast<u32>(select(0i, select(select(i32(_e894), i32(-2147483648), (_e894 < -2147483600f)), 2147483647i, (_e894 > 2147483500f)), (_e894 == _e894))));
                                let _e908 = (_e864 + (_e178 * 6u));
                                let _e910 = floor(((_e78[1] * _e888) + 0.5f));
                                if (_e908 < _e36) {
                                } else {
                                    break;
                                }
                                let _e922 = atomicAdd((&words.member[_e908]), bitcast<u32>(select(0i, select(select(i32(_e910), i32(-2147483648), (_e910 < -2147483600f)), 2147483647i, (_e910 > 2147483500f)), (_e910 == _e910))));
                                let _e924 = (_e864 + (_e178 * 9u));
                                let _e926 = floor(((_e78[2] * _e888) + 0.5f));
                                if (_e924 < _e36) {
                                } else {
                                    break;
                                }
                                let _e938 = atomicAdd((&words.member[_e924]), bitcast<u32>(select(0i, select(select(i32(_e926), i32(-2147483648), (_e926 < -2147483600f)), 2147483647i, (_e926 > 2147483500f)), (_e926 == _e926))));
                            }
                            let _e943 = (((4u + select(0u, 1u, (_e78[2] < 0f))) * _e439) + _e186);
                            let _e944 = (_e78[2] * _e78[2]);
                            let _e948 = ((_e65 * _e944) * _e450);
                            let _e950 = select(0f, _e948, (_e948 > 0f));
                            let _e952 = select(1073741800f, _e950, (_e950 < 1073741800f));
                            let _e954 = floor((_e952 + 0.5f));
                            let _e959 = select(select(u32(_e954), 0u, (_e954 < 0f)), 4294967295u, (_e954 > 4294967000f));
                            if (_e959 == 0u) {
                            } else {
                                if (_e943 < _e36) {
                                } else {
                                    break;
                                }
                                let _e964 = atomicAdd((&words.member[_e943]), _e959);
                                if (_e964 >= (1073741824u - select(_e959, 1073741824u, (1073741824u < _e959)))) {
                                    let _e971 = (_e439 * select(1u, _e189, (1u < _e189)));
                                    if (_e971 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e975 = atomicOr((&words.member[_e971]), 1u);
                                }
                                let _e976 = (_e952 * 0.6666667f);
                                let _e980 = (_e943 + _e438);
                                let _e982 = floor(((_e78[0] * _e976) + 0.5f));
                                if (_e980 < _e36) {
                                } else {
                                    break;
                                }
                                let _e994 = atomicAdd((&words.member[_e980]), bitcast<u32>(select(0i, select(select(i32(_e982), i32(-2147483648), (_e982 < -2147483600f)), 2147483647i, (_e982 > 2147483500f)), (_e982 == _e982))));
                                let _e996 = (_e943 + (_e178 * 6u));
                                let _e998 = floor(((_e78[1] * _e976) + 0.5f));
                                if (_e996 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1010 = atomicAdd((&words.member[_e996]), bitcast<u32>(select(0i, select(select(i32(_e998), i32(-2147483648), (_e998 < -2147483600f)), 2147483647i, (_e998 > 2147483500f)), (_e998 == _e998))));
                                let _e1012 = (_e943 + (_e178 * 9u));
                                let _e1014 = floor(((_e78[2] * _e976) + 0.5f));
                                if (_e1012 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1026 = atomicAdd((&words.member[_e1012]), bitcast<u32>(select(0i, select(select(i32(_e1014), i32(-2147483648), (_e1014 < -2147483600f)), 2147483647i, (_e1014 > 2147483500f)), (_e1014 == _e1014))));
                            }
                            let _e1027 = ((_e66 * _e944) * _e450);
                            let _e1029 = select(0f, _e1027, (_e1027 > 0f));
                            let _e1031 = select(1073741800f, _e1029, (_e1029 < 1073741800f));
                            let _e1032 = (_e178 + _e943);
                            let _e1034 = floor((_e1031 + 0.5f));
                            let _e1039 = select(select(u32(_e1034), 0u, (_e1034 < 0f)), 4294967295u, (_e1034 > 4294967000f));
                            if (_e1039 == 0u) {
                            } else {
                                if (_e1032 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1044 = atomicAdd((&words.member[_e1032]), _e1039);
                                if (_e1044 >= (1073741824u - select(_e1039, 1073741824u, (1073741824u < _e1039)))) {
                                    let _e1051 = (_e439 * select(1u, _e189, (1u < _e189)));
                                    if (_e1051 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e1055 = atomicOr((&words.member[_e1051]), 1u);
                                }
                                let _e1056 = (_e1031 * 0.6666667f);
                                let _e1060 = (_e1032 + _e438);
                                let _e1062 = floor(((_e78[0] * _e1056) + 0.5f));
                                if (_e1060 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1074 = atomicAdd((&words.member[_e1060]), bitcast<u32>(select(0i, select(select(i32(_e1062), i32(-2147483648), (_e1062 < -2147483600f)), 2147483647i, (_e1062 > 2147483500f)), (_e1062 == _e1062))));
                                let _e1076 = (_e1032 + (_e178 * 6u));
                                let _e1078 = floor(((_e78[1] * _e1056) + 0.5f));
                                if (_e1076 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1090 = atomicAdd((&words.member[_e1076]), bitcast<u32>(select(0i, select(select(i32(_e1078), i32(-2147483648), (_e1078 < -2147483600f)), 2147483647i, (_e1078 > 2147483500f)), (_e1078 == _e1078))));
                                let _e1092 = (_e1032 + (_e178 * 9u));
                                let _e1094 = floor(((_e78[2] * _e1056) + 0.5f));
                                if (_e1092 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1106 = atomicAdd((&words.member[_e1092]), bitcast<u32>(select(0i, select(select(i32(_e1094), i32(-2147483648), (_e1094 < -2147483600f)), 2147483647i, (_e1094 > 2147483500f)), (_e1094 == _e1094))));
                            }
                            let _e1107 = ((_e67 * _e944) * _e450);
                            let _e1109 = select(0f, _e1107, (_e1107 > 0f));
                            let _e1111 = select(1073741800f, _e1109, (_e1109 < 1073741800f));
                            let _e1112 = (_e615 + _e943);
                            let _e1114 = floor((_e1111 + 0.5f));
                            let _e1119 = select(select(u32(_e1114), 0u, (_e1114 < 0f)), 4294967295u, (_e1114 > 4294967000f));
                            if (_e1119 == 0u) {
                            } else {
                                if (_e1112 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1124 = atomicAdd((&words.member[_e1112]), _e1119);
                                if (_e1124 >= (1073741824u - select(_e1119, 1073741824u, (1073741824u < _e1119)))) {
                                    let _e1131 = (_e439 * select(1u, _e189, (1u < _e189)));
                                    if (_e1131 < _e36) {
                                    } else {
                                        break;
                                    }
                                    let _e1135 = atomicOr((&words.member[_e1131]), 1u);
                                }
                                let _e1136 = (_e1111 * 0.6666667f);
                                let _e1140 = (_e1112 + _e438);
                                let _e1142 = floor(((_e78[0] * _e1136) + 0.5f));
                                if (_e1140 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1154 = atomicAdd((&words.member[_e1140]), bitcast<u32>(select(0i, select(select(i32(_e1142), i32(-2147483648), (_e1142 < -2147483600f)), 2147483647i, (_e1142 > 2147483500f)), (_e1142 == _e1142))));
                                let _e1156 = (_e1112 + (_e178 * 6u));
                                let _e1158 = floor(((_e78[1] * _e1136) + 0.5f));
                                if (_e1156 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1170 = atomicAdd((&words.member[_e1156]), bitcast<u32>(select(0i, select(select(i32(_e1158), i32(-2147483648), (_e1158 < -2147483600f)), 2147483647i, (_e1158 > 2147483500f)), (_e1158 == _e1158))));
                                let _e1172 = (_e1112 + (_e178 * 9u));
                                let _e1174 = floor(((_e78[2] * _e1136) + 0.5f));
                                if (_e1172 < _e36) {
                                } else {
                                    break;
                                }
                                let _e1186 = atomicAdd((&words.member[_e1172]), bitcast<u32>(select(0i, select(select(i32(_e1174), i32(-2147483648), (_e1174 < -2147483600f)), 2147483647i, (_e1174 > 2147483500f)), (_e1174 == _e1174))));
                            }
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
