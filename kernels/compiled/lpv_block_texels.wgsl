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

struct type_31 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_25;
@group(0) @binding(2) 
var<storage, read_write> words: type_31;
@group(0) @binding(1) 
var<storage> texels: type_18;

fn function_() {
    var phi_150_: vec3<f32>;
    var phi_246_: bool;
    var phi_248_: bool;
    var phi_249_: bool;
    var phi_250_: bool;
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_255_: bool;
    var phi_382_: bool;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_518_: bool;
    var phi_520_: bool;
    var phi_521_: bool;
    var phi_522_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_527_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = gid_1;
            let _e33 = arrayLength((&words.member));
            let _e37 = (_e29.x + (_e29.y * 2097152u));
            let _e40 = params.member.member_5;
            if (_e37 < _e40) {
                if (_e37 < arrayLength((&texels.member))) {
                } else {
                    break;
                }
                let _e46 = texels.member[_e37].member_3;
                if (_e46 == 1u) {
                    let _e51 = texels.member[_e37].member_1;
                    let _e55 = params.member.member[3u];
                    let _e57 = ((_e51 / _e55) / _e55);
                    let _e61 = texels.member[_e37].member;
                    let _e68 = texels.member[_e37].member_2;
                    let _e73 = select(16f, _e57, (_e57 < 16f));
                    let _e74 = (_e68[0] * _e73);
                    let _e75 = (_e68[1] * _e73);
                    let _e76 = (_e68[2] * _e73);
                    let _e79 = params.member.member;
                    let _e94 = (((_e74 * _e74) + (_e75 * _e75)) + (_e76 * _e76));
                    if (_e94 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e97 = (1f / sqrt(_e94));
                        phi_150_ = vec3<f32>((_e74 * _e97), (_e75 * _e97), (_e76 * _e97));
                    } else {
                        phi_150_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e103 = phi_150_;
                    let _e110 = (((_e61[0] - _e79.x) / _e79.w) - (_e103.x * 0.015625f));
                    let _e111 = (((_e61[1] - _e79.y) / _e79.w) - (_e103.y * 0.015625f));
                    let _e112 = (((_e61[2] - _e79.z) / _e79.w) - (_e103.z * 0.015625f));
                    let _e114 = abs(_e74);
                    let _e117 = params.member.member_1;
                    let _e118 = floor((_e110 - 0.5f));
                    let _e126 = floor(_e111);
                    let _e134 = floor(_e112);
                    let _e145 = (select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < -2147483600f)), 2147483647i, (_e118 > 2147483500f)), (_e118 == _e118)) - _e117.x);
                    let _e146 = (select(0i, select(select(i32(_e126), i32(-2147483648), (_e126 < -2147483600f)), 2147483647i, (_e126 > 2147483500f)), (_e126 == _e126)) - _e117.y);
                    let _e147 = (select(0i, select(select(i32(_e134), i32(-2147483648), (_e134 < -2147483600f)), 2147483647i, (_e134 > 2147483500f)), (_e134 == _e134)) - _e117.z);
                    let _e152 = floor(((select(16f, _e114, (_e114 < 16f)) * 65536f) + 0.5f));
                    let _e157 = select(select(u32(_e152), 0u, (_e152 < 0f)), 4294967295u, (_e152 > 4294967000f));
                    let _e160 = params.member.member_2;
                    if (_e145 >= 0i) {
                        if (_e146 >= 0i) {
                            if (_e147 >= 0i) {
                                if (_e145 < bitcast<i32>(_e160.x)) {
                                    let _e169 = (_e146 < bitcast<i32>(_e160.y));
                                    if _e169 {
                                        phi_246_ = (_e147 < bitcast<i32>(_e160.z));
                                    } else {
                                        phi_246_ = bool();
                                    }
                                    let _e174 = phi_246_;
                                    phi_248_ = _e174;
                                    phi_249_ = select(true, false, _e169);
                                } else {
                                    phi_248_ = bool();
                                    phi_249_ = true;
                                }
                                let _e177 = phi_248_;
                                let _e179 = phi_249_;
                                phi_250_ = _e177;
                                phi_251_ = _e179;
                            } else {
                                phi_250_ = bool();
                                phi_251_ = true;
                            }
                            let _e181 = phi_250_;
                            let _e183 = phi_251_;
                            phi_252_ = _e181;
                            phi_253_ = _e183;
                        } else {
                            phi_252_ = bool();
                            phi_253_ = true;
                        }
                        let _e185 = phi_252_;
                        let _e187 = phi_253_;
                        phi_254_ = _e185;
                        phi_255_ = _e187;
                    } else {
                        phi_254_ = bool();
                        phi_255_ = true;
                    }
                    let _e189 = phi_254_;
                    let _e191 = phi_255_;
                    if select(_e189, false, _e191) {
                        if (_e157 > 0u) {
                            let _e195 = (_e160.x + 1u);
                            let _e198 = ((_e160.y + 1u) * _e195);
                            let _e207 = ((((_e198 + _e195) + bitcast<u32>(_e145)) + (bitcast<u32>(_e146) * _e195)) + (bitcast<u32>(_e147) * _e198));
                            if (_e207 < _e33) {
                            } else {
                                break;
                            }
                            let _e211 = atomicAdd((&words.member[_e207]), _e157);
                        }
                    }
                    let _e213 = abs(_e75);
                    let _e214 = floor(_e110);
                    let _e222 = floor((_e111 - 0.5f));
                    let _e230 = (select(0i, select(select(i32(_e214), i32(-2147483648), (_e214 < -2147483600f)), 2147483647i, (_e214 > 2147483500f)), (_e214 == _e214)) - _e117.x);
                    let _e231 = (select(0i, select(select(i32(_e222), i32(-2147483648), (_e222 < -2147483600f)), 2147483647i, (_e222 > 2147483500f)), (_e222 == _e222)) - _e117.y);
                    let _e236 = floor(((select(16f, _e213, (_e213 < 16f)) * 65536f) + 0.5f));
                    let _e241 = select(select(u32(_e236), 0u, (_e236 < 0f)), 4294967295u, (_e236 > 4294967000f));
                    let _e242 = (_e230 >= 0i);
                    if _e242 {
                        if (_e231 >= 0i) {
                            if (_e147 >= 0i) {
                                if (_e230 < bitcast<i32>(_e160.x)) {
                                    let _e250 = (_e231 < bitcast<i32>(_e160.y));
                                    if _e250 {
                                        phi_382_ = (_e147 < bitcast<i32>(_e160.z));
                                    } else {
                                        phi_382_ = bool();
                                    }
                                    let _e255 = phi_382_;
                                    phi_384_ = _e255;
                                    phi_385_ = select(true, false, _e250);
                                } else {
                                    phi_384_ = bool();
                                    phi_385_ = true;
                                }
                                let _e258 = phi_384_;
                                let _e260 = phi_385_;
                                phi_386_ = _e258;
                                phi_387_ = _e260;
                            } else {
                                phi_386_ = bool();
                                phi_387_ = true;
                            }
                            let _e262 = phi_386_;
                            let _e264 = phi_387_;
                            phi_388_ = _e262;
                            phi_389_ = _e264;
                        } else {
                            phi_388_ = bool();
                            phi_389_ = true;
                        }
                        let _e266 = phi_388_;
                        let _e268 = phi_389_;
                        phi_390_ = _e266;
                        phi_391_ = _e268;
                    } else {
                        phi_390_ = bool();
                        phi_391_ = true;
                    }
                    let _e270 = phi_390_;
                    let _e272 = phi_391_;
                    if select(_e270, false, _e272) {
                        if (_e241 > 0u) {
                            let _e276 = (_e160.x + 1u);
                            let _e279 = ((_e160.y + 1u) * _e276);
                            let _e280 = (_e279 + _e276);
                            let _e293 = ((_e280 + ((_e160.z + 1u) * _e279)) + (((_e280 + bitcast<u32>(_e230)) + (bitcast<u32>(_e231) * _e276)) + (bitcast<u32>(_e147) * _e279)));
                            if (_e293 < _e33) {
                            } else {
                                break;
                            }
                            let _e297 = atomicAdd((&words.member[_e293]), _e241);
                        }
                    }
                    let _e299 = abs(_e76);
                    let _e300 = floor((_e112 - 0.5f));
                    let _e308 = (select(0i, select(select(i32(_e300), i32(-2147483648), (_e300 < -2147483600f)), 2147483647i, (_e300 > 2147483500f)), (_e300 == _e300)) - _e117.z);
                    let _e313 = floor(((select(16f, _e299, (_e299 < 16f)) * 65536f) + 0.5f));
                    let _e318 = select(select(u32(_e313), 0u, (_e313 < 0f)), 4294967295u, (_e313 > 4294967000f));
                    if _e242 {
                        if (_e146 >= 0i) {
                            if (_e308 >= 0i) {
                                if (_e230 < bitcast<i32>(_e160.x)) {
                                    let _e326 = (_e146 < bitcast<i32>(_e160.y));
                                    if _e326 {
                                        phi_518_ = (_e308 < bitcast<i32>(_e160.z));
                                    } else {
                                        phi_518_ = bool();
                                    }
                                    let _e331 = phi_518_;
                                    phi_520_ = _e331;
                                    phi_521_ = select(true, false, _e326);
                                } else {
                                    phi_520_ = bool();
                                    phi_521_ = true;
                                }
                                let _e334 = phi_520_;
                                let _e336 = phi_521_;
                                phi_522_ = _e334;
                                phi_523_ = _e336;
                            } else {
                                phi_522_ = bool();
                                phi_523_ = true;
                            }
                            let _e338 = phi_522_;
                            let _e340 = phi_523_;
                            phi_524_ = _e338;
                            phi_525_ = _e340;
                        } else {
                            phi_524_ = bool();
                            phi_525_ = true;
                        }
                        let _e342 = phi_524_;
                        let _e344 = phi_525_;
                        phi_526_ = _e342;
                        phi_527_ = _e344;
                    } else {
                        phi_526_ = bool();
                        phi_527_ = true;
                    }
                    let _e346 = phi_526_;
                    let _e348 = phi_527_;
                    if select(_e346, false, _e348) {
                        if (_e318 > 0u) {
                            let _e352 = (_e160.x + 1u);
                            let _e355 = ((_e160.y + 1u) * _e352);
                            let _e356 = (_e355 + _e352);
                            let _e370 = ((2u * (_e356 + ((_e160.z + 1u) * _e355))) + (((_e356 + bitcast<u32>(_e230)) + (bitcast<u32>(_e146) * _e352)) + (bitcast<u32>(_e308) * _e355)));
                            if (_e370 < _e33) {
                            } else {
                                break;
                            }
                            let _e374 = atomicAdd((&words.member[_e370]), _e318);
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
