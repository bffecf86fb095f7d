struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
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

struct type_25 {
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

struct type_26 {
    member: type_25,
}

struct type_32 {
    member: array<vec4<f32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_26;
@group(0) @binding(1) 
var<storage> facets: type_18;
@group(0) @binding(2) 
var<storage> coefs: type_5;
@group(0) @binding(3) 
var<storage> direct: type_32;
@group(0) @binding(4) 
var<storage, read_write> out: type_32;

fn function_() {
    var phi_141_: vec3<f32>;
    var phi_148_: vec3<f32>;
    var phi_364_: type_10;
    var phi_367_: f32;
    var phi_369_: array<array<f32, 4>, 3>;
    var phi_365_: type_10;
    var phi_392_: type_10;
    var phi_422_: f32;
    var phi_427_: f32;
    var phi_433_: f32;
    var phi_672_: f32;
    var phi_673_: array<array<f32, 4>, 3>;
    var phi_368_: f32;
    var phi_370_: array<array<f32, 4>, 3>;
    var phi_2900_: bool;
    var local: f32;
    var local_1: f32;
    var phi_679_: f32;
    var local_2: array<array<f32, 4>, 3>;
    var local_3: array<array<f32, 4>, 3>;
    var local_4: array<array<f32, 4>, 3>;
    var local_5: array<array<f32, 4>, 3>;
    var local_6: array<array<f32, 4>, 3>;
    var local_7: array<array<f32, 4>, 3>;
    var local_8: array<array<f32, 4>, 3>;
    var local_9: array<array<f32, 4>, 3>;
    var local_10: array<array<f32, 4>, 3>;
    var local_11: array<array<f32, 4>, 3>;
    var local_12: array<array<f32, 4>, 3>;
    var local_13: array<array<f32, 4>, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e42 = gid_1;
            let _e46 = arrayLength((&coefs.member));
            let _e54 = (_e42.x + (_e42.y * 2097152u));
            let _e55 = (_e54 < arrayLength((&out.member)));
            if _e55 {
                let _e56 = (_e54 / 2u);
                if (_e56 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e61 = facets.member[_e56].member_2;
                let _e70 = sqrt((((_e61[0] * _e61[0]) + (_e61[1] * _e61[1])) + (_e61[2] * _e61[2])));
                if (_e70 > 0.000000000001f) {
                    phi_141_ = vec3<f32>((_e61[0] / _e70), (_e61[1] / _e70), (_e61[2] / _e70));
                } else {
                    phi_141_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e77 = phi_141_;
                if ((_e54 & 1u) == 0u) {
                    phi_148_ = _e77;
                } else {
                    phi_148_ = -(_e77);
                }
                let _e82 = phi_148_;
                let _e85 = params.member.member;
                let _e88 = params.member.member_1;
                let _e91 = params.member.member_2;
                let _e95 = facets.member[_e56].member;
                let _e100 = (_e91.x + 1u);
                let _e103 = ((_e91.y + 1u) * _e100);
                let _e104 = (_e103 + _e100);
                let _e108 = (_e104 + ((_e91.z + 1u) * _e103));
                let _e116 = ((_e95[0] - _e85.x) / _e85.w);
                let _e117 = ((_e95[1] - _e85.y) / _e85.w);
                let _e118 = ((_e95[2] - _e85.z) / _e85.w);
                let _e131 = ((_e116 + (_e82.x * 0.5f)) - 0.5f);
                let _e132 = floor(_e131);
                let _e134 = (bitcast<i32>(_e91.x) - 1i);
                let _e142 = (select(0i, select(select(i32(_e132), i32(-2147483648), (_e132 < -2147483600f)), 2147483647i, (_e132 > 2147483500f)), (_e132 == _e132)) - _e88.x);
                let _e144 = select(0i, _e142, (0i < _e142));
                let _e146 = select(_e144, _e134, (_e134 < _e144));
                let _e147 = (_e142 + 1i);
                let _e149 = select(0i, _e147, (0i < _e147));
                let _e151 = select(_e149, _e134, (_e134 < _e149));
                let _e154 = (_e131 - _e132);
                let _e161 = ((_e117 + (_e82.y * 0.5f)) - 0.5f);
                let _e162 = floor(_e161);
                let _e164 = (bitcast<i32>(_e91.y) - 1i);
                let _e172 = (select(0i, select(select(i32(_e162), i32(-2147483648), (_e162 < -2147483600f)), 2147483647i, (_e162 > 2147483500f)), (_e162 == _e162)) - _e88.y);
                let _e174 = select(0i, _e172, (0i < _e172));
                let _e176 = select(_e174, _e164, (_e164 < _e174));
                let _e177 = (_e172 + 1i);
                let _e179 = select(0i, _e177, (0i < _e177));
                let _e181 = select(_e179, _e164, (_e164 < _e179));
                let _e184 = (_e161 - _e162);
                let _e191 = ((_e118 + (_e82.z * 0.5f)) - 0.5f);
                let _e192 = floor(_e191);
                let _e194 = (bitcast<i32>(_e91.z) - 1i);
                let _e202 = (select(0i, select(select(i32(_e192), i32(-2147483648), (_e192 < -2147483600f)), 2147483647i, (_e192 > 2147483500f)), (_e192 == _e192)) - _e88.z);
                let _e204 = select(0i, _e202, (0i < _e202));
                let _e206 = select(_e204, _e194, (_e194 < _e204));
                let _e207 = (_e202 + 1i);
                let _e209 = select(0i, _e207, (0i < _e207));
                let _e211 = select(_e209, _e194, (_e194 < _e209));
                let _e214 = (_e191 - _e192);
                phi_364_ = type_10(0u, 8u);
                phi_367_ = 0f;
                phi_369_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                loop {
                    let _e222 = phi_364_;
                    let _e224 = phi_367_;
                    let _e226 = phi_369_;
                    local = _e224;
                    local_1 = _e224;
                    local_2 = _e226;
                    local_3 = _e226;
                    local_4 = _e226;
                    local_5 = _e226;
                    local_6 = _e226;
                    local_7 = _e226;
                    local_8 = _e226;
                    local_9 = _e226;
                    local_10 = _e226;
                    local_11 = _e226;
                    local_12 = _e226;
                    local_13 = _e226;
                    if (_e222.member < _e222.member_1) {
                        phi_365_ = type_10((_e222.member + 1u), _e222.member_1);
                        phi_392_ = type_10(1u, _e222.member);
                    } else {
                        phi_365_ = _e222;
                        phi_392_ = type_10(0u, type_10().member_1);
                    }
                    let _e239 = phi_365_;
                    let _e241 = phi_392_;
                    let _e245 = (bitcast<i32>(_e241.member) != 0i);
                    if _e245 {
                        let _e247 = ((_e241.member_1 & 1u) == 1u);
                        let _e249 = ((_e241.member_1 & 2u) == 2u);
                        let _e251 = ((_e241.member_1 & 4u) == 4u);
                        if _e247 {
                            phi_422_ = _e154;
                        } else {
                            phi_422_ = (1f - _e154);
                        }
                        let _e257 = phi_422_;
                        if _e249 {
                            phi_427_ = _e184;
                        } else {
                            phi_427_ = (1f - _e184);
                        }
                        let _e260 = phi_427_;
                        if _e251 {
                            phi_433_ = _e214;
                        } else {
                            phi_433_ = (1f - _e214);
                        }
                        let _e264 = phi_433_;
                        let _e274 = (((((select((f32((_e146 + _e88.x)) + 0.5f), (f32((_e151 + _e88.x)) + 0.5f), _e247) - _e116) * _e82.x) + ((select((f32((_e176 + _e88.y)) + 0.5f), (f32((_e181 + _e88.y)) + 0.5f), _e249) - _e117) * _e82.y)) + ((select((f32((_e206 + _e88.z)) + 0.5f), (f32((_e211 + _e88.z)) + 0.5f), _e251) - _e118) * _e82.z)) * 2f);
                        let _e276 = select(0f, _e274, (_e274 > 0f));
                        let _e279 = (((_e257 * _e260) * _e264) * select(1f, _e276, (_e276 < 1f)));
                        if (_e279 > 0f) {
                            let _e288 = (((_e104 + select(bitcast<u32>(_e146), bitcast<u32>(_e151), _e247)) + (select(bitcast<u32>(_e176), bitcast<u32>(_e181), _e249) * _e100)) + (select(bitcast<u32>(_e206), bitcast<u32>(_e211), _e251) * _e103));
                            if (_e288 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e293 = coefs.member[_e288];
                            let _e298 = (3u * _e108);
                            let _e299 = (_e298 + _e288);
                            if (_e299 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e303 = coefs.member[_e299];
                            let _e308 = (_e108 * 6u);
                            let _e309 = (_e308 + _e288);
                            if (_e309 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e313 = coefs.member[_e309];
                            let _e318 = (_e108 * 9u);
                            let _e319 = (_e318 + _e288);
                            if (_e319 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e323 = coefs.member[_e319];
                            let _e329 = (_e108 + _e288);
                            if (_e329 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e333 = coefs.member[_e329];
                            let _e338 = (_e298 + _e329);
                            if (_e338 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e342 = coefs.member[_e338];
                            let _e347 = (_e308 + _e329);
                            if (_e347 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e351 = coefs.member[_e347];
                            let _e356 = (_e318 + _e329);
                            if (_e356 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e360 = coefs.member[_e356];
                            let _e367 = ((2u * _e108) + _e288);
                            if (_e367 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e371 = coefs.member[_e367];
                            let _e376 = (_e298 + _e367);
                            if (_e376 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e380 = coefs.member[_e376];
                            let _e385 = (_e308 + _e367);
                            if (_e385 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e389 = coefs.member[_e385];
                            let _e394 = (_e318 + _e367);
                            if (_e394 < _e46) {
                            } else {
                                phi_2900_ = true;
                                break;
                            }
                            let _e398 = coefs.member[_e394];
                            phi_672_ = (_e224 + _e279);
                            phi_673_ = array<array<f32, 4>, 3>(array<f32, 4>((_e226[0][0] + (_e293 * _e279)), (_e226[0][1] + (_e303 * _e279)), (_e226[0][2] + (_e313 * _e279)), (_e226[0][3] + (_e323 * _e279))), array<f32, 4>((_e226[1][0] + (_e333 * _e279)), (_e226[1][1] + (_e342 * _e279)), (_e226[1][2] + (_e351 * _e279)), (_e226[1][3] + (_e360 * _e279))), array<f32, 4>((_e226[2][0] + (_e371 * _e279)), (_e226[2][1] + (_e380 * _e279)), (_e226[2][2] + (_e389 * _e279)), (_e226[2][3] + (_e398 * _e279))));
                        } else {
                            phi_672_ = _e224;
                            phi_673_ = _e226;
                        }
                        let _e406 = phi_672_;
                        let _e408 = phi_673_;
                        phi_368_ = _e406;
                        phi_370_ = _e408;
                    } else {
                        phi_368_ = f32();
                        phi_370_ = array<array<f32, 4>, 3>();
                    }
                    let _e410 = phi_368_;
                    let _e412 = phi_370_;
                    continue;
                    continuing {
                        phi_364_ = _e239;
                        phi_367_ = _e410;
                        phi_369_ = _e412;
                        phi_2900_ = false;
                        break if !(_e245);
                    }
                }
                let _e415 = phi_2900_;
                if _e415 {
                    break;
                }
                let _e417 = local;
                if (_e417 > 0f) {
                    let _e420 = local_1;
                    phi_679_ = (1f / _e420);
                } else {
                    phi_679_ = 0f;
                }
                let _e423 = phi_679_;
                let _e425 = local_2;
                let _e430 = local_3;
                let _e435 = local_4;
                let _e440 = local_5;
                let _e445 = local_6;
                let _e450 = local_7;
                let _e455 = local_8;
                let _e460 = local_9;
                let _e465 = local_10;
                let _e470 = local_11;
                let _e475 = local_12;
                let _e480 = local_13;
                let _e485 = ((0.6666667f / _e85.w) / _e85.w);
                let _e487 = (_e82.z * -1.0233268f);
                let _e490 = (_e82.x * -1.0233268f);
                let _e493 = (_e82.y * -1.0233268f);
                let _e495 = (((((_e425[0][0] * _e423) * 0.886227f) + ((_e435[0][2] * _e423) * _e487)) + ((_e440[0][3] * _e423) * _e490)) + ((_e430[0][1] * _e423) * _e493));
                let _e504 = (((((_e445[1][0] * _e423) * 0.886227f) + ((_e455[1][2] * _e423) * _e487)) + ((_e460[1][3] * _e423) * _e490)) + ((_e450[1][1] * _e423) * _e493));
                let _e513 = (((((_e465[2][0] * _e423) * 0.886227f) + ((_e475[2][2] * _e423) * _e487)) + ((_e480[2][3] * _e423) * _e490)) + ((_e470[2][1] * _e423) * _e493));
                let _e521 = params.member.member_17;
                let _e525 = (_e95[0] - _e521.x);
                let _e526 = (_e95[1] - _e521.y);
                let _e527 = (_e95[2] - _e521.z);
                let _e537 = params.member.member_17[3u];
                let _e542 = (2f - (2f * (sqrt((((_e525 * _e525) + (_e526 * _e526)) + (_e527 * _e527))) / select(0.000000000000000000000000000000000000011754944f, _e537, (_e537 > 0.000000000000000000000000000000000000011754944f)))));
                let _e544 = select(0f, _e542, (_e542 > 0f));
                let _e550 = facets.member[_e56].member_4;
                if (_e54 < arrayLength((&direct.member))) {
                } else {
                    break;
                }
                let _e557 = direct.member[_e54];
                let _e567 = (0.31830987f * select(1f, _e544, (_e544 < 1f)));
                if _e55 {
                } else {
                    break;
                }
                out.member[_e54] = vec4<f32>(((_e550[0] * ((select(0f, _e495, (_e495 > 0f)) * _e485) + _e557.x)) * _e567), ((_e550[1] * ((select(0f, _e504, (_e504 > 0f)) * _e485) + _e557.y)) * _e567), ((_e550[2] * ((select(0f, _e513, (_e513 > 0f)) * _e485) + _e557.z)) * _e567), 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_reflect(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
