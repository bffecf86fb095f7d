struct type_9 {
    member: array<u32>,
}

struct type_16 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_24 {
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

struct type_25 {
    member: type_24,
}

struct type_32 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_25;
@group(0) @binding(2) 
var<storage, read_write> words: type_32;
@group(0) @binding(1) 
var<storage> texels: type_18;

fn function_() {
    var phi_196_: vec3<f32>;
    var phi_330_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_425_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_520_: bool;
    var phi_522_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_527_: bool;
    var phi_528_: bool;
    var phi_529_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e30 = gid_1;
            let _e34 = arrayLength((&words.member));
            let _e38 = (_e30.x + (_e30.y * 2097152u));
            let _e41 = params.member.member_5;
            if (_e38 < _e41) {
                if (_e38 < arrayLength((&texels.member))) {
                } else {
                    break;
                }
                let _e47 = texels.member[_e38].member_3;
                if (_e47 == 1u) {
                    let _e52 = texels.member[_e38].member_1;
                    let _e56 = params.member.member[3u];
                    let _e58 = ((_e52 / _e56) / _e56);
                    let _e62 = texels.member[_e38].member;
                    let _e69 = texels.member[_e38].member_2;
                    let _e74 = select(16f, _e58, (_e58 < 16f));
                    let _e75 = (_e69[0] * _e74);
                    let _e76 = (_e69[1] * _e74);
                    let _e77 = (_e69[2] * _e74);
                    let _e80 = params.member.member;
                    let _e88 = ((_e62[0] - _e80.x) / _e80.w);
                    let _e89 = ((_e62[1] - _e80.y) / _e80.w);
                    let _e90 = ((_e62[2] - _e80.z) / _e80.w);
                    let _e96 = params.member.member_1[0u];
                    let _e98 = (_e88 - f32(_e96));
                    let _e102 = params.member.member_1[1u];
                    let _e104 = (_e89 - f32(_e102));
                    let _e108 = params.member.member_1[2u];
                    let _e110 = (_e90 - f32(_e108));
                    let _e116 = params.member.member_2[0u];
                    let _e121 = params.member.member_2[1u];
                    let _e126 = params.member.member_2[2u];
                    if ((((((_e98 > -1f) && (_e98 < (f32(_e116) + 1f))) && (_e104 > -1f)) && (_e104 < (f32(_e121) + 1f))) && (_e110 > -1f)) && (_e110 < (f32(_e126) + 1f))) {
                        let _e146 = (((_e75 * _e75) + (_e76 * _e76)) + (_e77 * _e77));
                        if (_e146 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e149 = (1f / sqrt(_e146));
                            phi_196_ = vec3<f32>((_e75 * _e149), (_e76 * _e149), (_e77 * _e149));
                        } else {
                            phi_196_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e155 = phi_196_;
                        let _e162 = (_e88 - (_e155.x * 0.015625f));
                        let _e163 = (_e89 - (_e155.y * 0.015625f));
                        let _e164 = (_e90 - (_e155.z * 0.015625f));
                        let _e165 = params.member.member_1;
                        let _e166 = floor(_e162);
                        let _e174 = floor(_e163);
                        let _e182 = floor(_e164);
                        let _e193 = (select(0i, select(select(i32(_e166), i32(-2147483648), (_e166 < -2147483600f)), 2147483647i, (_e166 > 2147483500f)), (_e166 == _e166)) - _e165.x);
                        let _e194 = (select(0i, select(select(i32(_e174), i32(-2147483648), (_e174 < -2147483600f)), 2147483647i, (_e174 > 2147483500f)), (_e174 == _e174)) - _e165.y);
                        let _e195 = (select(0i, select(select(i32(_e182), i32(-2147483648), (_e182 < -2147483600f)), 2147483647i, (_e182 > 2147483500f)), (_e182 == _e182)) - _e165.z);
                        let _e199 = floor((_e162 - 0.5f));
                        let _e207 = floor((_e163 - 0.5f));
                        let _e215 = floor((_e164 - 0.5f));
                        let _e223 = (select(0i, select(select(i32(_e199), i32(-2147483648), (_e199 < -2147483600f)), 2147483647i, (_e199 > 2147483500f)), (_e199 == _e199)) - _e165.x);
                        let _e224 = (select(0i, select(select(i32(_e207), i32(-2147483648), (_e207 < -2147483600f)), 2147483647i, (_e207 > 2147483500f)), (_e207 == _e207)) - _e165.y);
                        let _e225 = (select(0i, select(select(i32(_e215), i32(-2147483648), (_e215 < -2147483600f)), 2147483647i, (_e215 > 2147483500f)), (_e215 == _e215)) - _e165.z);
                        let _e226 = abs(_e75);
                        let _e231 = floor(((select(16f, _e226, (_e226 < 16f)) * 65536f) + 0.5f));
                        let _e236 = select(select(u32(_e231), 0u, (_e231 < 0f)), 4294967295u, (_e231 > 4294967000f));
                        let _e237 = params.member.member_2;
                        if (_e223 >= 0i) {
                            if (_e194 >= 0i) {
                                if (_e195 >= 0i) {
                                    if (_e223 < bitcast<i32>(_e237.x)) {
                                        let _e246 = (_e194 < bitcast<i32>(_e237.y));
                                        if _e246 {
                                            phi_330_ = (_e195 < bitcast<i32>(_e237.z));
                                        } else {
                                            phi_330_ = bool();
                                        }
                                        let _e251 = phi_330_;
                                        phi_332_ = _e251;
                                        phi_333_ = select(true, false, _e246);
                                    } else {
                                        phi_332_ = bool();
                                        phi_333_ = true;
                                    }
                                    let _e254 = phi_332_;
                                    let _e256 = phi_333_;
                                    phi_334_ = _e254;
                                    phi_335_ = _e256;
                                } else {
                                    phi_334_ = bool();
                                    phi_335_ = true;
                                }
                                let _e258 = phi_334_;
                                let _e260 = phi_335_;
                                phi_336_ = _e258;
                                phi_337_ = _e260;
                            } else {
                                phi_336_ = bool();
                                phi_337_ = true;
                            }
                            let _e262 = phi_336_;
                            let _e264 = phi_337_;
                            phi_338_ = _e262;
                            phi_339_ = _e264;
                        } else {
                            phi_338_ = bool();
                            phi_339_ = true;
                        }
                        let _e266 = phi_338_;
                        let _e268 = phi_339_;
                        if select(_e266, false, _e268) {
                            if (_e236 > 0u) {
                                let _e272 = (_e237.x + 1u);
                                let _e275 = ((_e237.y + 1u) * _e272);
                                let _e284 = ((((_e275 + _e272) + bitcast<u32>(_e223)) + (bitcast<u32>(_e194) * _e272)) + (bitcast<u32>(_e195) * _e275));
                                if (_e284 < _e34) {
                                } else {
                                    break;
                                }
                                let _e288 = atomicAdd((&words.member[_e284]), _e236);
                            }
                        }
                        let _e289 = abs(_e76);
                        let _e294 = floor(((select(16f, _e289, (_e289 < 16f)) * 65536f) + 0.5f));
                        let _e299 = select(select(u32(_e294), 0u, (_e294 < 0f)), 4294967295u, (_e294 > 4294967000f));
                        let _e300 = (_e193 >= 0i);
                        if _e300 {
                            if (_e224 >= 0i) {
                                if (_e195 >= 0i) {
                                    if (_e193 < bitcast<i32>(_e237.x)) {
                                        let _e308 = (_e224 < bitcast<i32>(_e237.y));
                                        if _e308 {
                                            phi_425_ = (_e195 < bitcast<i32>(_e237.z));
                                        } else {
                                            phi_425_ = bool();
                                        }
                                        let _e313 = phi_425_;
                                        phi_427_ = _e313;
                                        phi_428_ = select(true, false, _e308);
                                    } else {
                                        phi_427_ = bool();
                                        phi_428_ = true;
                                    }
                                    let _e316 = phi_427_;
                                    let _e318 = phi_428_;
                                    phi_429_ = _e316;
                                    phi_430_ = _e318;
                                } else {
                                    phi_429_ = bool();
                                    phi_430_ = true;
                                }
                                let _e320 = phi_429_;
                                let _e322 = phi_430_;
                                phi_431_ = _e320;
                                phi_432_ = _e322;
                            } else {
                                phi_431_ = bool();
                                phi_432_ = true;
                            }
                            let _e324 = phi_431_;
                            let _e326 = phi_432_;
                            phi_433_ = _e324;
                            phi_434_ = _e326;
                        } else {
                            phi_433_ = bool();
                            phi_434_ = true;
                        }
                        let _e328 = phi_433_;
                        let _e330 = phi_434_;
                        if select(_e328, false, _e330) {
                            if (_e299 > 0u) {
                                let _e334 = (_e237.x + 1u);
                                let _e337 = ((_e237.y + 1u) * _e334);
                                let _e338 = (_e337 + _e334);
                                let _e351 = ((_e338 + ((_e237.z + 1u) * _e337)) + (((_e338 + bitcast<u32>(_e193)) + (bitcast<u32>(_e224) * _e334)) + (bitcast<u32>(_e195) * _e337)));
                                if (_e351 < _e34) {
                                } else {
                                    break;
                                }
                                let _e355 = atomicAdd((&words.member[_e351]), _e299);
                            }
                        }
                        let _e356 = abs(_e77);
                        let _e361 = floor(((select(16f, _e356, (_e356 < 16f)) * 65536f) + 0.5f));
                        let _e366 = select(select(u32(_e361), 0u, (_e361 < 0f)), 4294967295u, (_e361 > 4294967000f));
                        if _e300 {
                            if (_e194 >= 0i) {
                                if (_e225 >= 0i) {
                                    if (_e193 < bitcast<i32>(_e237.x)) {
                                        let _e374 = (_e194 < bitcast<i32>(_e237.y));
                                        if _e374 {
                                            phi_520_ = (_e225 < bitcast<i32>(_e237.z));
                                        } else {
                                            phi_520_ = bool();
                                        }
                                        let _e379 = phi_520_;
                                        phi_522_ = _e379;
                                        phi_523_ = select(true, false, _e374);
                                    } else {
                                        phi_522_ = bool();
                                        phi_523_ = true;
                                    }
                                    let _e382 = phi_522_;
                                    let _e384 = phi_523_;
                                    phi_524_ = _e382;
                                    phi_525_ = _e384;
                                } else {
                                    phi_524_ = bool();
                                    phi_525_ = true;
                                }
                                let _e386 = phi_524_;
                                let _e388 = phi_525_;
                                phi_526_ = _e386;
                                phi_527_ = _e388;
                            } else {
                                phi_526_ = bool();
                                phi_527_ = true;
                            }
                            let _e390 = phi_526_;
                            let _e392 = phi_527_;
                            phi_528_ = _e390;
                            phi_529_ = _e392;
                        } else {
                            phi_528_ = bool();
                            phi_529_ = true;
                        }
                        let _e394 = phi_528_;
                        let _e396 = phi_529_;
                        if select(_e394, false, _e396) {
                            if (_e366 > 0u) {
                                let _e400 = (_e237.x + 1u);
                                let _e403 = ((_e237.y + 1u) * _e400);
                                let _e404 = (_e403 + _e400);
                                let _e418 = ((2u * (_e404 + ((_e237.z + 1u) * _e403))) + (((_e404 + bitcast<u32>(_e193)) + (bitcast<u32>(_e194) * _e400)) + (bitcast<u32>(_e225) * _e403)));
                                if (_e418 < _e34) {
                                } else {
                                    break;
                                }
                                let _e422 = atomicAdd((&words.member[_e418]), _e366);
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
fn lpv_block_texels(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
