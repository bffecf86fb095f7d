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
    var phi_284_: bool;
    var phi_286_: bool;
    var phi_287_: bool;
    var phi_288_: bool;
    var phi_289_: bool;
    var phi_290_: bool;
    var phi_291_: bool;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_379_: bool;
    var phi_381_: bool;
    var phi_382_: bool;
    var phi_383_: bool;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_474_: bool;
    var phi_476_: bool;
    var phi_477_: bool;
    var phi_478_: bool;
    var phi_479_: bool;
    var phi_480_: bool;
    var phi_481_: bool;
    var phi_482_: bool;
    var phi_483_: bool;

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
                    let _e115 = params.member.member_1;
                    let _e116 = floor(_e110);
                    let _e124 = floor(_e111);
                    let _e132 = floor(_e112);
                    let _e143 = (select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < -2147483600f)), 2147483647i, (_e116 > 2147483500f)), (_e116 == _e116)) - _e115.x);
                    let _e144 = (select(0i, select(select(i32(_e124), i32(-2147483648), (_e124 < -2147483600f)), 2147483647i, (_e124 > 2147483500f)), (_e124 == _e124)) - _e115.y);
                    let _e145 = (select(0i, select(select(i32(_e132), i32(-2147483648), (_e132 < -2147483600f)), 2147483647i, (_e132 > 2147483500f)), (_e132 == _e132)) - _e115.z);
                    let _e149 = floor((_e110 - 0.5f));
                    let _e157 = floor((_e111 - 0.5f));
                    let _e165 = floor((_e112 - 0.5f));
                    let _e173 = (select(0i, select(select(i32(_e149), i32(-2147483648), (_e149 < -2147483600f)), 2147483647i, (_e149 > 2147483500f)), (_e149 == _e149)) - _e115.x);
                    let _e174 = (select(0i, select(select(i32(_e157), i32(-2147483648), (_e157 < -2147483600f)), 2147483647i, (_e157 > 2147483500f)), (_e157 == _e157)) - _e115.y);
                    let _e175 = (select(0i, select(select(i32(_e165), i32(-2147483648), (_e165 < -2147483600f)), 2147483647i, (_e165 > 2147483500f)), (_e165 == _e165)) - _e115.z);
                    let _e176 = abs(_e74);
                    let _e181 = floor(((select(16f, _e176, (_e176 < 16f)) * 65536f) + 0.5f));
                    let _e186 = select(select(u32(_e181), 0u, (_e181 < 0f)), 4294967295u, (_e181 > 4294967000f));
                    let _e189 = params.member.member_2;
                    if (_e173 >= 0i) {
                        if (_e144 >= 0i) {
                            if (_e145 >= 0i) {
                                if (_e173 < bitcast<i32>(_e189.x)) {
                                    let _e198 = (_e144 < bitcast<i32>(_e189.y));
                                    if _e198 {
                                        phi_284_ = (_e145 < bitcast<i32>(_e189.z));
                                    } else {
                                        phi_284_ = bool();
                                    }
                                    let _e203 = phi_284_;
                                    phi_286_ = _e203;
                                    phi_287_ = select(true, false, _e198);
                                } else {
                                    phi_286_ = bool();
                                    phi_287_ = true;
                                }
                                let _e206 = phi_286_;
                                let _e208 = phi_287_;
                                phi_288_ = _e206;
                                phi_289_ = _e208;
                            } else {
                                phi_288_ = bool();
                                phi_289_ = true;
                            }
                            let _e210 = phi_288_;
                            let _e212 = phi_289_;
                            phi_290_ = _e210;
                            phi_291_ = _e212;
                        } else {
                            phi_290_ = bool();
                            phi_291_ = true;
                        }
                        let _e214 = phi_290_;
                        let _e216 = phi_291_;
                        phi_292_ = _e214;
                        phi_293_ = _e216;
                    } else {
                        phi_292_ = bool();
                        phi_293_ = true;
                    }
                    let _e218 = phi_292_;
                    let _e220 = phi_293_;
                    if select(_e218, false, _e220) {
                        if (_e186 > 0u) {
                            let _e224 = (_e189.x + 1u);
                            let _e227 = ((_e189.y + 1u) * _e224);
                            let _e236 = ((((_e227 + _e224) + bitcast<u32>(_e173)) + (bitcast<u32>(_e144) * _e224)) + (bitcast<u32>(_e145) * _e227));
                            if (_e236 < _e33) {
                            } else {
                                break;
                            }
                            let _e240 = atomicAdd((&words.member[_e236]), _e186);
                        }
                    }
                    let _e241 = abs(_e75);
                    let _e246 = floor(((select(16f, _e241, (_e241 < 16f)) * 65536f) + 0.5f));
                    let _e251 = select(select(u32(_e246), 0u, (_e246 < 0f)), 4294967295u, (_e246 > 4294967000f));
                    let _e252 = (_e143 >= 0i);
                    if _e252 {
                        if (_e174 >= 0i) {
                            if (_e145 >= 0i) {
                                if (_e143 < bitcast<i32>(_e189.x)) {
                                    let _e260 = (_e174 < bitcast<i32>(_e189.y));
                                    if _e260 {
                                        phi_379_ = (_e145 < bitcast<i32>(_e189.z));
                                    } else {
                                        phi_379_ = bool();
                                    }
                                    let _e265 = phi_379_;
                                    phi_381_ = _e265;
                                    phi_382_ = select(true, false, _e260);
                                } else {
                                    phi_381_ = bool();
                                    phi_382_ = true;
                                }
                                let _e268 = phi_381_;
                                let _e270 = phi_382_;
                                phi_383_ = _e268;
                                phi_384_ = _e270;
                            } else {
                                phi_383_ = bool();
                                phi_384_ = true;
                            }
                            let _e272 = phi_383_;
                            let _e274 = phi_384_;
                            phi_385_ = _e272;
                            phi_386_ = _e274;
                        } else {
                            phi_385_ = bool();
                            phi_386_ = true;
                        }
                        let _e276 = phi_385_;
                        let _e278 = phi_386_;
                        phi_387_ = _e276;
                        phi_388_ = _e278;
                    } else {
                        phi_387_ = bool();
                        phi_388_ = true;
                    }
                    let _e280 = phi_387_;
                    let _e282 = phi_388_;
                    if select(_e280, false, _e282) {
                        if (_e251 > 0u) {
                            let _e286 = (_e189.x + 1u);
                            let _e289 = ((_e189.y + 1u) * _e286);
                            let _e290 = (_e289 + _e286);
                            let _e303 = ((_e290 + ((_e189.z + 1u) * _e289)) + (((_e290 + bitcast<u32>(_e143)) + (bitcast<u32>(_e174) * _e286)) + (bitcast<u32>(_e145) * _e289)));
                            if (_e303 < _e33) {
                            } else {
                                break;
                            }
                            let _e307 = atomicAdd((&words.member[_e303]), _e251);
                        }
                    }
                    let _e308 = abs(_e76);
                    let _e313 = floor(((select(16f, _e308, (_e308 < 16f)) * 65536f) + 0.5f));
                    let _e318 = select(select(u32(_e313), 0u, (_e313 < 0f)), 4294967295u, (_e313 > 4294967000f));
                    if _e252 {
                        if (_e144 >= 0i) {
                            if (_e175 >= 0i) {
                                if (_e143 < bitcast<i32>(_e189.x)) {
                                    let _e326 = (_e144 < bitcast<i32>(_e189.y));
                                    if _e326 {
                                        phi_474_ = (_e175 < bitcast<i32>(_e189.z));
                                    } else {
                                        phi_474_ = bool();
                                    }
                                    let _e331 = phi_474_;
                                    phi_476_ = _e331;
                                    phi_477_ = select(true, false, _e326);
                                } else {
                                    phi_476_ = bool();
                                    phi_477_ = true;
                                }
                                let _e334 = phi_476_;
                                let _e336 = phi_477_;
                                phi_478_ = _e334;
                                phi_479_ = _e336;
                            } else {
                                phi_478_ = bool();
                                phi_479_ = true;
                            }
                            let _e338 = phi_478_;
                            let _e340 = phi_479_;
                            phi_480_ = _e338;
                            phi_481_ = _e340;
                        } else {
                            phi_480_ = bool();
                            phi_481_ = true;
                        }
                        let _e342 = phi_480_;
                        let _e344 = phi_481_;
                        phi_482_ = _e342;
                        phi_483_ = _e344;
                    } else {
                        phi_482_ = bool();
                        phi_483_ = true;
                    }
                    let _e346 = phi_482_;
                    let _e348 = phi_483_;
                    if select(_e346, false, _e348) {
                        if (_e318 > 0u) {
                            let _e352 = (_e189.x + 1u);
                            let _e355 = ((_e189.y + 1u) * _e352);
                            let _e356 = (_e355 + _e352);
                            let _e370 = ((2u * (_e356 + ((_e189.z + 1u) * _e355))) + (((_e356 + bitcast<u32>(_e143)) + (bitcast<u32>(_e144) * _e352)) + (bitcast<u32>(_e175) * _e355)));
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
