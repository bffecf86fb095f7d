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
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: vec4<f32>,
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
    var phi_145_: vec3<f32>;
    var phi_152_: vec3<f32>;
    var phi_368_: type_10;
    var phi_371_: f32;
    var phi_373_: array<array<f32, 6>, 3>;
    var phi_369_: type_10;
    var phi_396_: type_10;
    var phi_426_: f32;
    var phi_431_: f32;
    var phi_437_: f32;
    var phi_772_: f32;
    var phi_773_: array<array<f32, 6>, 3>;
    var phi_372_: f32;
    var phi_374_: array<array<f32, 6>, 3>;
    var phi_3150_: bool;
    var local: f32;
    var local_1: f32;
    var phi_779_: f32;
    var local_2: array<array<f32, 6>, 3>;
    var local_3: array<array<f32, 6>, 3>;
    var local_4: array<array<f32, 6>, 3>;
    var local_5: array<array<f32, 6>, 3>;
    var local_6: array<array<f32, 6>, 3>;
    var local_7: array<array<f32, 6>, 3>;
    var local_8: array<array<f32, 6>, 3>;
    var local_9: array<array<f32, 6>, 3>;
    var local_10: array<array<f32, 6>, 3>;
    var local_11: array<array<f32, 6>, 3>;
    var local_12: array<array<f32, 6>, 3>;
    var local_13: array<array<f32, 6>, 3>;
    var local_14: array<array<f32, 6>, 3>;
    var local_15: array<array<f32, 6>, 3>;
    var local_16: array<array<f32, 6>, 3>;
    var local_17: array<array<f32, 6>, 3>;
    var local_18: array<array<f32, 6>, 3>;
    var local_19: array<array<f32, 6>, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e49 = gid_1;
            let _e53 = arrayLength((&coefs.member));
            let _e61 = (_e49.x + (_e49.y * 2097152u));
            let _e62 = (_e61 < arrayLength((&out.member)));
            if _e62 {
                let _e63 = (_e61 / 2u);
                if (_e63 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e68 = facets.member[_e63].member_2;
                let _e77 = sqrt((((_e68[0] * _e68[0]) + (_e68[1] * _e68[1])) + (_e68[2] * _e68[2])));
                if (_e77 > 0.000000000001f) {
                    phi_145_ = vec3<f32>((_e68[0] / _e77), (_e68[1] / _e77), (_e68[2] / _e77));
                } else {
                    phi_145_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e84 = phi_145_;
                if ((_e61 & 1u) == 0u) {
                    phi_152_ = _e84;
                } else {
                    phi_152_ = -(_e84);
                }
                let _e89 = phi_152_;
                let _e92 = params.member.member;
                let _e95 = params.member.member_1;
                let _e98 = params.member.member_2;
                let _e102 = facets.member[_e63].member;
                let _e107 = (_e98.x + 1u);
                let _e110 = ((_e98.y + 1u) * _e107);
                let _e111 = (_e110 + _e107);
                let _e115 = (_e111 + ((_e98.z + 1u) * _e110));
                let _e123 = ((_e102[0] - _e92.x) / _e92.w);
                let _e124 = ((_e102[1] - _e92.y) / _e92.w);
                let _e125 = ((_e102[2] - _e92.z) / _e92.w);
                let _e138 = ((_e123 + (_e89.x * 0.5f)) - 0.5f);
                let _e139 = floor(_e138);
                let _e141 = (bitcast<i32>(_e98.x) - 1i);
                let _e149 = (select(0i, select(select(i32(_e139), i32(-2147483648), (_e139 < -2147483600f)), 2147483647i, (_e139 > 2147483500f)), (_e139 == _e139)) - _e95.x);
                let _e151 = select(0i, _e149, (0i < _e149));
                let _e153 = select(_e151, _e141, (_e141 < _e151));
                let _e154 = (_e149 + 1i);
                let _e156 = select(0i, _e154, (0i < _e154));
                let _e158 = select(_e156, _e141, (_e141 < _e156));
                let _e161 = (_e138 - _e139);
                let _e168 = ((_e124 + (_e89.y * 0.5f)) - 0.5f);
                let _e169 = floor(_e168);
                let _e171 = (bitcast<i32>(_e98.y) - 1i);
                let _e179 = (select(0i, select(select(i32(_e169), i32(-2147483648), (_e169 < -2147483600f)), 2147483647i, (_e169 > 2147483500f)), (_e169 == _e169)) - _e95.y);
                let _e181 = select(0i, _e179, (0i < _e179));
                let _e183 = select(_e181, _e171, (_e171 < _e181));
                let _e184 = (_e179 + 1i);
                let _e186 = select(0i, _e184, (0i < _e184));
                let _e188 = select(_e186, _e171, (_e171 < _e186));
                let _e191 = (_e168 - _e169);
                let _e198 = ((_e125 + (_e89.z * 0.5f)) - 0.5f);
                let _e199 = floor(_e198);
                let _e201 = (bitcast<i32>(_e98.z) - 1i);
                let _e209 = (select(0i, select(select(i32(_e199), i32(-2147483648), (_e199 < -2147483600f)), 2147483647i, (_e199 > 2147483500f)), (_e199 == _e199)) - _e95.z);
                let _e211 = select(0i, _e209, (0i < _e209));
                let _e213 = select(_e211, _e201, (_e201 < _e211));
                let _e214 = (_e209 + 1i);
                let _e216 = select(0i, _e214, (0i < _e214));
                let _e218 = select(_e216, _e201, (_e201 < _e216));
                let _e221 = (_e198 - _e199);
                phi_368_ = type_10(0u, 8u);
                phi_371_ = 0f;
                phi_373_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                loop {
                    let _e229 = phi_368_;
                    let _e231 = phi_371_;
                    let _e233 = phi_373_;
                    local = _e231;
                    local_1 = _e231;
                    local_2 = _e233;
                    local_3 = _e233;
                    local_4 = _e233;
                    local_5 = _e233;
                    local_6 = _e233;
                    local_7 = _e233;
                    local_8 = _e233;
                    local_9 = _e233;
                    local_10 = _e233;
                    local_11 = _e233;
                    local_12 = _e233;
                    local_13 = _e233;
                    local_14 = _e233;
                    local_15 = _e233;
                    local_16 = _e233;
                    local_17 = _e233;
                    local_18 = _e233;
                    local_19 = _e233;
                    if (_e229.member < _e229.member_1) {
                        phi_369_ = type_10((_e229.member + 1u), _e229.member_1);
                        phi_396_ = type_10(1u, _e229.member);
                    } else {
                        phi_369_ = _e229;
                        phi_396_ = type_10(0u, type_10().member_1);
                    }
                    let _e246 = phi_369_;
                    let _e248 = phi_396_;
                    let _e252 = (bitcast<i32>(_e248.member) != 0i);
                    if _e252 {
                        let _e254 = ((_e248.member_1 & 1u) == 1u);
                        let _e256 = ((_e248.member_1 & 2u) == 2u);
                        let _e258 = ((_e248.member_1 & 4u) == 4u);
                        if _e254 {
                            phi_426_ = _e161;
                        } else {
                            phi_426_ = (1f - _e161);
                        }
                        let _e264 = phi_426_;
                        if _e256 {
                            phi_431_ = _e191;
                        } else {
                            phi_431_ = (1f - _e191);
                        }
                        let _e267 = phi_431_;
                        if _e258 {
                            phi_437_ = _e221;
                        } else {
                            phi_437_ = (1f - _e221);
                        }
                        let _e271 = phi_437_;
                        let _e281 = (((((select((f32((_e153 + _e95.x)) + 0.5f), (f32((_e158 + _e95.x)) + 0.5f), _e254) - _e123) * _e89.x) + ((select((f32((_e183 + _e95.y)) + 0.5f), (f32((_e188 + _e95.y)) + 0.5f), _e256) - _e124) * _e89.y)) + ((select((f32((_e213 + _e95.z)) + 0.5f), (f32((_e218 + _e95.z)) + 0.5f), _e258) - _e125) * _e89.z)) * 2f);
                        let _e283 = select(0f, _e281, (_e281 > 0f));
                        let _e286 = (((_e264 * _e267) * _e271) * select(1f, _e283, (_e283 < 1f)));
                        if (_e286 > 0f) {
                            let _e295 = (((_e111 + select(bitcast<u32>(_e153), bitcast<u32>(_e158), _e254)) + (select(bitcast<u32>(_e183), bitcast<u32>(_e188), _e256) * _e107)) + (select(bitcast<u32>(_e213), bitcast<u32>(_e218), _e258) * _e110));
                            if (_e295 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e300 = coefs.member[_e295];
                            let _e305 = (3u * _e115);
                            let _e306 = (_e305 + _e295);
                            if (_e306 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e310 = coefs.member[_e306];
                            let _e315 = (_e115 * 6u);
                            let _e316 = (_e315 + _e295);
                            if (_e316 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e320 = coefs.member[_e316];
                            let _e325 = (_e115 * 9u);
                            let _e326 = (_e325 + _e295);
                            if (_e326 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e330 = coefs.member[_e326];
                            let _e335 = (_e115 * 12u);
                            let _e336 = (_e335 + _e295);
                            if (_e336 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e340 = coefs.member[_e336];
                            let _e345 = (_e115 * 15u);
                            let _e346 = (_e345 + _e295);
                            if (_e346 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e350 = coefs.member[_e346];
                            let _e356 = (_e115 + _e295);
                            if (_e356 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e360 = coefs.member[_e356];
                            let _e365 = (_e305 + _e356);
                            if (_e365 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e369 = coefs.member[_e365];
                            let _e374 = (_e315 + _e356);
                            if (_e374 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e378 = coefs.member[_e374];
                            let _e383 = (_e325 + _e356);
                            if (_e383 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e387 = coefs.member[_e383];
                            let _e392 = (_e335 + _e356);
                            if (_e392 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e396 = coefs.member[_e392];
                            let _e401 = (_e345 + _e356);
                            if (_e401 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e405 = coefs.member[_e401];
                            let _e412 = ((2u * _e115) + _e295);
                            if (_e412 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e416 = coefs.member[_e412];
                            let _e421 = (_e305 + _e412);
                            if (_e421 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e425 = coefs.member[_e421];
                            let _e430 = (_e315 + _e412);
                            if (_e430 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e434 = coefs.member[_e430];
                            let _e439 = (_e325 + _e412);
                            if (_e439 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e443 = coefs.member[_e439];
                            let _e448 = (_e335 + _e412);
                            if (_e448 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e452 = coefs.member[_e448];
                            let _e457 = (_e345 + _e412);
                            if (_e457 < _e53) {
                            } else {
                                phi_3150_ = true;
                                break;
                            }
                            let _e461 = coefs.member[_e457];
                            phi_772_ = (_e231 + _e286);
                            phi_773_ = array<array<f32, 6>, 3>(array<f32, 6>((_e233[0][0] + (_e300 * _e286)), (_e233[0][1] + (_e310 * _e286)), (_e233[0][2] + (_e320 * _e286)), (_e233[0][3] + (_e330 * _e286)), (_e233[0][4] + (_e340 * _e286)), (_e233[0][5] + (_e350 * _e286))), array<f32, 6>((_e233[1][0] + (_e360 * _e286)), (_e233[1][1] + (_e369 * _e286)), (_e233[1][2] + (_e378 * _e286)), (_e233[1][3] + (_e387 * _e286)), (_e233[1][4] + (_e396 * _e286)), (_e233[1][5] + (_e405 * _e286))), array<f32, 6>((_e233[2][0] + (_e416 * _e286)), (_e233[2][1] + (_e425 * _e286)), (_e233[2][2] + (_e434 * _e286)), (_e233[2][3] + (_e443 * _e286)), (_e233[2][4] + (_e452 * _e286)), (_e233[2][5] + (_e461 * _e286))));
                        } else {
                            phi_772_ = _e231;
                            phi_773_ = _e233;
                        }
                        let _e469 = phi_772_;
                        let _e471 = phi_773_;
                        phi_372_ = _e469;
                        phi_374_ = _e471;
                    } else {
                        phi_372_ = f32();
                        phi_374_ = array<array<f32, 6>, 3>();
                    }
                    let _e473 = phi_372_;
                    let _e475 = phi_374_;
                    continue;
                    continuing {
                        phi_368_ = _e246;
                        phi_371_ = _e473;
                        phi_373_ = _e475;
                        phi_3150_ = false;
                        break if !(_e252);
                    }
                }
                let _e478 = phi_3150_;
                if _e478 {
                    break;
                }
                let _e480 = local;
                if (_e480 > 0f) {
                    let _e483 = local_1;
                    phi_779_ = (1f / _e483);
                } else {
                    phi_779_ = 0f;
                }
                let _e486 = phi_779_;
                let _e488 = local_2;
                let _e493 = local_3;
                let _e498 = local_4;
                let _e503 = local_5;
                let _e508 = local_6;
                let _e513 = local_7;
                let _e518 = local_8;
                let _e523 = local_9;
                let _e528 = local_10;
                let _e533 = local_11;
                let _e538 = local_12;
                let _e543 = local_13;
                let _e548 = local_14;
                let _e553 = local_15;
                let _e558 = local_16;
                let _e563 = local_17;
                let _e568 = local_18;
                let _e573 = local_19;
                let _e578 = ((0.6666667f / _e92.w) / _e92.w);
                let _e579 = -(_e89.x);
                let _e580 = -(_e89.y);
                let _e583 = (_e89.z * -1.0233268f);
                let _e589 = ((((_e89.z * -1.9364917f) * (_e89.z * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                let _e592 = (_e89.x * -1.0233268f);
                let _e595 = (_e89.y * -1.0233268f);
                let _e601 = (((_e579 * _e579) - (_e580 * _e580)) * 0.4290428f);
                let _e603 = (((((((_e488[0][0] * _e486) * 0.886227f) + ((_e498[0][2] * _e486) * _e583)) + ((_e508[0][4] * _e486) * _e589)) + ((_e503[0][3] * _e486) * _e592)) + ((_e493[0][1] * _e486) * _e595)) + ((_e513[0][5] * _e486) * _e601));
                let _e616 = (((((((_e518[1][0] * _e486) * 0.886227f) + ((_e528[1][2] * _e486) * _e583)) + ((_e538[1][4] * _e486) * _e589)) + ((_e533[1][3] * _e486) * _e592)) + ((_e523[1][1] * _e486) * _e595)) + ((_e543[1][5] * _e486) * _e601));
                let _e629 = (((((((_e548[2][0] * _e486) * 0.886227f) + ((_e558[2][2] * _e486) * _e583)) + ((_e568[2][4] * _e486) * _e589)) + ((_e563[2][3] * _e486) * _e592)) + ((_e553[2][1] * _e486) * _e595)) + ((_e573[2][5] * _e486) * _e601));
                let _e637 = params.member.member_21;
                let _e641 = (_e102[0] - _e637.x);
                let _e642 = (_e102[1] - _e637.y);
                let _e643 = (_e102[2] - _e637.z);
                let _e653 = params.member.member_21[3u];
                let _e658 = (2f - (2f * (sqrt((((_e641 * _e641) + (_e642 * _e642)) + (_e643 * _e643))) / select(0.000000000000000000000000000000000000011754944f, _e653, (_e653 > 0.000000000000000000000000000000000000011754944f)))));
                let _e660 = select(0f, _e658, (_e658 > 0f));
                let _e666 = facets.member[_e63].member_4;
                if (_e61 < arrayLength((&direct.member))) {
                } else {
                    break;
                }
                let _e673 = direct.member[_e61];
                let _e683 = (0.31830987f * select(1f, _e660, (_e660 < 1f)));
                if _e62 {
                } else {
                    break;
                }
                out.member[_e61] = vec4<f32>(((_e666[0] * ((select(0f, _e603, (_e603 > 0f)) * _e578) + _e673.x)) * _e683), ((_e666[1] * ((select(0f, _e616, (_e616 > 0f)) * _e578) + _e673.y)) * _e683), ((_e666[2] * ((select(0f, _e629, (_e629 > 0f)) * _e578) + _e673.z)) * _e683), 0f);
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
