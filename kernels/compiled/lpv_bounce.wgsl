struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<u32>,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_29 {
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

struct type_30 {
    member: type_29,
}

struct type_37 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_30;
@group(0) @binding(1) 
var<storage> facets: type_23;
@group(0) @binding(2) 
var<storage> coefs: type_5;
@group(0) @binding(3) 
var<storage, read_write> words: type_37;

fn function_() {
    var phi_143_: vec3<f32>;
    var phi_150_: vec3<f32>;
    var phi_366_: type_11;
    var phi_369_: f32;
    var phi_371_: array<array<f32, 4>, 3>;
    var phi_367_: type_11;
    var phi_394_: type_11;
    var phi_424_: f32;
    var phi_429_: f32;
    var phi_435_: f32;
    var phi_674_: f32;
    var phi_675_: array<array<f32, 4>, 3>;
    var phi_370_: f32;
    var phi_372_: array<array<f32, 4>, 3>;
    var phi_3340_: bool;
    var local: f32;
    var local_1: f32;
    var phi_681_: f32;
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
    var phi_2925_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_2934_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e47 = gid_1;
            let _e51 = arrayLength((&coefs.member));
            let _e53 = arrayLength((&words.member));
            let _e57 = (_e47.x + (_e47.y * 2097152u));
            let _e60 = params.member.member_5;
            if (_e57 < _e60) {
                let _e62 = (_e57 / 2u);
                if (_e62 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e67 = facets.member[_e62].member_2;
                let _e76 = sqrt((((_e67[0] * _e67[0]) + (_e67[1] * _e67[1])) + (_e67[2] * _e67[2])));
                if (_e76 > 0.000000000001f) {
                    phi_143_ = vec3<f32>((_e67[0] / _e76), (_e67[1] / _e76), (_e67[2] / _e76));
                } else {
                    phi_143_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e83 = phi_143_;
                if ((_e57 & 1u) == 0u) {
                    phi_150_ = _e83;
                } else {
                    phi_150_ = -(_e83);
                }
                let _e88 = phi_150_;
                let _e91 = params.member.member;
                let _e94 = params.member.member_1;
                let _e97 = params.member.member_2;
                let _e101 = facets.member[_e62].member;
                let _e106 = (_e97.x + 1u);
                let _e109 = ((_e97.y + 1u) * _e106);
                let _e110 = (_e109 + _e106);
                let _e114 = (_e110 + ((_e97.z + 1u) * _e109));
                let _e122 = ((_e101[0] - _e91.x) / _e91.w);
                let _e123 = ((_e101[1] - _e91.y) / _e91.w);
                let _e124 = ((_e101[2] - _e91.z) / _e91.w);
                let _e131 = (_e122 + (_e88.x * 0.5f));
                let _e132 = (_e123 + (_e88.y * 0.5f));
                let _e133 = (_e124 + (_e88.z * 0.5f));
                let _e137 = (_e131 - 0.5f);
                let _e138 = floor(_e137);
                let _e139 = bitcast<i32>(_e97.x);
                let _e140 = (_e139 - 1i);
                let _e148 = (select(0i, select(select(i32(_e138), i32(-2147483648), (_e138 < -2147483600f)), 2147483647i, (_e138 > 2147483500f)), (_e138 == _e138)) - _e94.x);
                let _e150 = select(0i, _e148, (0i < _e148));
                let _e152 = select(_e150, _e140, (_e140 < _e150));
                let _e153 = (_e148 + 1i);
                let _e155 = select(0i, _e153, (0i < _e153));
                let _e157 = select(_e155, _e140, (_e140 < _e155));
                let _e160 = (_e137 - _e138);
                let _e167 = (_e132 - 0.5f);
                let _e168 = floor(_e167);
                let _e169 = bitcast<i32>(_e97.y);
                let _e170 = (_e169 - 1i);
                let _e178 = (select(0i, select(select(i32(_e168), i32(-2147483648), (_e168 < -2147483600f)), 2147483647i, (_e168 > 2147483500f)), (_e168 == _e168)) - _e94.y);
                let _e180 = select(0i, _e178, (0i < _e178));
                let _e182 = select(_e180, _e170, (_e170 < _e180));
                let _e183 = (_e178 + 1i);
                let _e185 = select(0i, _e183, (0i < _e183));
                let _e187 = select(_e185, _e170, (_e170 < _e185));
                let _e190 = (_e167 - _e168);
                let _e197 = (_e133 - 0.5f);
                let _e198 = floor(_e197);
                let _e199 = bitcast<i32>(_e97.z);
                let _e200 = (_e199 - 1i);
                let _e208 = (select(0i, select(select(i32(_e198), i32(-2147483648), (_e198 < -2147483600f)), 2147483647i, (_e198 > 2147483500f)), (_e198 == _e198)) - _e94.z);
                let _e210 = select(0i, _e208, (0i < _e208));
                let _e212 = select(_e210, _e200, (_e200 < _e210));
                let _e213 = (_e208 + 1i);
                let _e215 = select(0i, _e213, (0i < _e213));
                let _e217 = select(_e215, _e200, (_e200 < _e215));
                let _e220 = (_e197 - _e198);
                phi_366_ = type_11(0u, 8u);
                phi_369_ = 0f;
                phi_371_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                loop {
                    let _e228 = phi_366_;
                    let _e230 = phi_369_;
                    let _e232 = phi_371_;
                    local = _e230;
                    local_1 = _e230;
                    local_2 = _e232;
                    local_3 = _e232;
                    local_4 = _e232;
                    local_5 = _e232;
                    local_6 = _e232;
                    local_7 = _e232;
                    local_8 = _e232;
                    local_9 = _e232;
                    local_10 = _e232;
                    local_11 = _e232;
                    local_12 = _e232;
                    local_13 = _e232;
                    if (_e228.member < _e228.member_1) {
                        phi_367_ = type_11((_e228.member + 1u), _e228.member_1);
                        phi_394_ = type_11(1u, _e228.member);
                    } else {
                        phi_367_ = _e228;
                        phi_394_ = type_11(0u, type_11().member_1);
                    }
                    let _e245 = phi_367_;
                    let _e247 = phi_394_;
                    let _e251 = (bitcast<i32>(_e247.member) != 0i);
                    if _e251 {
                        let _e253 = ((_e247.member_1 & 1u) == 1u);
                        let _e255 = ((_e247.member_1 & 2u) == 2u);
                        let _e257 = ((_e247.member_1 & 4u) == 4u);
                        if _e253 {
                            phi_424_ = _e160;
                        } else {
                            phi_424_ = (1f - _e160);
                        }
                        let _e263 = phi_424_;
                        if _e255 {
                            phi_429_ = _e190;
                        } else {
                            phi_429_ = (1f - _e190);
                        }
                        let _e266 = phi_429_;
                        if _e257 {
                            phi_435_ = _e220;
                        } else {
                            phi_435_ = (1f - _e220);
                        }
                        let _e270 = phi_435_;
                        let _e280 = (((((select((f32((_e152 + _e94.x)) + 0.5f), (f32((_e157 + _e94.x)) + 0.5f), _e253) - _e122) * _e88.x) + ((select((f32((_e182 + _e94.y)) + 0.5f), (f32((_e187 + _e94.y)) + 0.5f), _e255) - _e123) * _e88.y)) + ((select((f32((_e212 + _e94.z)) + 0.5f), (f32((_e217 + _e94.z)) + 0.5f), _e257) - _e124) * _e88.z)) * 2f);
                        let _e282 = select(0f, _e280, (_e280 > 0f));
                        let _e285 = (((_e263 * _e266) * _e270) * select(1f, _e282, (_e282 < 1f)));
                        if (_e285 > 0f) {
                            let _e294 = (((_e110 + select(bitcast<u32>(_e152), bitcast<u32>(_e157), _e253)) + (select(bitcast<u32>(_e182), bitcast<u32>(_e187), _e255) * _e106)) + (select(bitcast<u32>(_e212), bitcast<u32>(_e217), _e257) * _e109));
                            if (_e294 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e299 = coefs.member[_e294];
                            let _e304 = (3u * _e114);
                            let _e305 = (_e304 + _e294);
                            if (_e305 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e309 = coefs.member[_e305];
                            let _e314 = (_e114 * 6u);
                            let _e315 = (_e314 + _e294);
                            if (_e315 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e319 = coefs.member[_e315];
                            let _e324 = (_e114 * 9u);
                            let _e325 = (_e324 + _e294);
                            if (_e325 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e329 = coefs.member[_e325];
                            let _e335 = (_e114 + _e294);
                            if (_e335 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e339 = coefs.member[_e335];
                            let _e344 = (_e304 + _e335);
                            if (_e344 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e348 = coefs.member[_e344];
                            let _e353 = (_e314 + _e335);
                            if (_e353 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e357 = coefs.member[_e353];
                            let _e362 = (_e324 + _e335);
                            if (_e362 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e366 = coefs.member[_e362];
                            let _e373 = ((2u * _e114) + _e294);
                            if (_e373 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e377 = coefs.member[_e373];
                            let _e382 = (_e304 + _e373);
                            if (_e382 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e386 = coefs.member[_e382];
                            let _e391 = (_e314 + _e373);
                            if (_e391 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e395 = coefs.member[_e391];
                            let _e400 = (_e324 + _e373);
                            if (_e400 < _e51) {
                            } else {
                                phi_3340_ = true;
                                break;
                            }
                            let _e404 = coefs.member[_e400];
                            phi_674_ = (_e230 + _e285);
                            phi_675_ = array<array<f32, 4>, 3>(array<f32, 4>((_e232[0][0] + (_e299 * _e285)), (_e232[0][1] + (_e309 * _e285)), (_e232[0][2] + (_e319 * _e285)), (_e232[0][3] + (_e329 * _e285))), array<f32, 4>((_e232[1][0] + (_e339 * _e285)), (_e232[1][1] + (_e348 * _e285)), (_e232[1][2] + (_e357 * _e285)), (_e232[1][3] + (_e366 * _e285))), array<f32, 4>((_e232[2][0] + (_e377 * _e285)), (_e232[2][1] + (_e386 * _e285)), (_e232[2][2] + (_e395 * _e285)), (_e232[2][3] + (_e404 * _e285))));
                        } else {
                            phi_674_ = _e230;
                            phi_675_ = _e232;
                        }
                        let _e412 = phi_674_;
                        let _e414 = phi_675_;
                        phi_370_ = _e412;
                        phi_372_ = _e414;
                    } else {
                        phi_370_ = f32();
                        phi_372_ = array<array<f32, 4>, 3>();
                    }
                    let _e416 = phi_370_;
                    let _e418 = phi_372_;
                    continue;
                    continuing {
                        phi_366_ = _e245;
                        phi_369_ = _e416;
                        phi_371_ = _e418;
                        phi_3340_ = false;
                        break if !(_e251);
                    }
                }
                let _e421 = phi_3340_;
                if _e421 {
                    break;
                }
                let _e423 = local;
                if (_e423 > 0f) {
                    let _e426 = local_1;
                    phi_681_ = (1f / _e426);
                } else {
                    phi_681_ = 0f;
                }
                let _e429 = phi_681_;
                let _e431 = local_2;
                let _e436 = local_3;
                let _e441 = local_4;
                let _e446 = local_5;
                let _e451 = local_6;
                let _e456 = local_7;
                let _e461 = local_8;
                let _e466 = local_9;
                let _e471 = local_10;
                let _e476 = local_11;
                let _e481 = local_12;
                let _e486 = local_13;
                let _e491 = ((0.6666667f / _e91.w) / _e91.w);
                let _e493 = (_e88.z * -1.0233268f);
                let _e496 = (_e88.x * -1.0233268f);
                let _e499 = (_e88.y * -1.0233268f);
                let _e501 = (((((_e431[0][0] * _e429) * 0.886227f) + ((_e441[0][2] * _e429) * _e493)) + ((_e446[0][3] * _e429) * _e496)) + ((_e436[0][1] * _e429) * _e499));
                let _e510 = (((((_e451[1][0] * _e429) * 0.886227f) + ((_e461[1][2] * _e429) * _e493)) + ((_e466[1][3] * _e429) * _e496)) + ((_e456[1][1] * _e429) * _e499));
                let _e519 = (((((_e471[2][0] * _e429) * 0.886227f) + ((_e481[2][2] * _e429) * _e493)) + ((_e486[2][3] * _e429) * _e496)) + ((_e476[2][1] * _e429) * _e499));
                let _e528 = facets.member[_e62].member_1;
                let _e531 = params.member.member_13;
                let _e533 = ((_e528 * _e531) * _e531);
                let _e537 = facets.member[_e62].member_4;
                let _e547 = floor(_e131);
                let _e555 = floor(_e132);
                let _e563 = floor(_e133);
                let _e571 = (select(0i, select(select(i32(_e547), i32(-2147483648), (_e547 < -2147483600f)), 2147483647i, (_e547 > 2147483500f)), (_e547 == _e547)) - _e94.x);
                let _e572 = (select(0i, select(select(i32(_e555), i32(-2147483648), (_e555 < -2147483600f)), 2147483647i, (_e555 > 2147483500f)), (_e555 == _e555)) - _e94.y);
                let _e573 = (select(0i, select(select(i32(_e563), i32(-2147483648), (_e563 < -2147483600f)), 2147483647i, (_e563 > 2147483500f)), (_e563 == _e563)) - _e94.z);
                if (_e571 >= 0i) {
                    if (_e572 >= 0i) {
                        if (_e573 >= 0i) {
                            if (_e571 < _e139) {
                                let _e578 = (_e572 < _e169);
                                if _e578 {
                                    phi_2925_ = (_e573 < _e199);
                                } else {
                                    phi_2925_ = bool();
                                }
                                let _e581 = phi_2925_;
                                phi_2927_ = _e581;
                                phi_2928_ = select(true, false, _e578);
                            } else {
                                phi_2927_ = bool();
                                phi_2928_ = true;
                            }
                            let _e584 = phi_2927_;
                            let _e586 = phi_2928_;
                            phi_2929_ = _e584;
                            phi_2930_ = _e586;
                        } else {
                            phi_2929_ = bool();
                            phi_2930_ = true;
                        }
                        let _e588 = phi_2929_;
                        let _e590 = phi_2930_;
                        phi_2931_ = _e588;
                        phi_2932_ = _e590;
                    } else {
                        phi_2931_ = bool();
                        phi_2932_ = true;
                    }
                    let _e592 = phi_2931_;
                    let _e594 = phi_2932_;
                    phi_2933_ = _e592;
                    phi_2934_ = _e594;
                } else {
                    phi_2933_ = bool();
                    phi_2934_ = true;
                }
                let _e596 = phi_2933_;
                let _e598 = phi_2934_;
                if select(_e596, false, _e598) {
                    let _e607 = (((_e110 + bitcast<u32>(_e571)) + (bitcast<u32>(_e572) * _e106)) + (bitcast<u32>(_e573) * _e109));
                    let _e610 = params.member.member_7;
                    let _e611 = (((_e537[0] * (select(0f, _e501, (_e501 > 0f)) * _e491)) * _e533) * _e610);
                    let _e613 = select(0f, _e611, (_e611 > 0f));
                    let _e615 = select(1073741800f, _e613, (_e613 < 1073741800f));
                    let _e616 = (3u * _e114);
                    let _e618 = floor((_e615 + 0.5f));
                    let _e623 = select(select(u32(_e618), 0u, (_e618 < 0f)), 4294967295u, (_e618 > 4294967000f));
                    if (_e623 == 0u) {
                    } else {
                        if (_e607 < _e53) {
                        } else {
                            break;
                        }
                        let _e628 = atomicAdd((&words.member[_e607]), _e623);
                        if (_e628 >= (1073741824u - select(_e623, 1073741824u, (1073741824u < _e623)))) {
                            let _e633 = (_e114 * 12u);
                            if (_e633 < _e53) {
                            } else {
                                break;
                            }
                            let _e637 = atomicOr((&words.member[_e633]), 1u);
                        }
                        let _e638 = (_e615 * 0.6666667f);
                        let _e642 = (_e607 + _e616);
                        let _e644 = floor(((_e88.x * _e638) + 0.5f));
                        if (_e642 < _e53) {
                        } else {
                            break;
                        }
                        let _e656 = atomicAdd((&words.member[_e642]), bitcast<u32>(select(0i, select(select(i32(_e644), i32(-2147483648), (_e644 < -2147483600f)), 2147483647i, (_e644 > 2147483500f)), (_e644 == _e644))));
                        let _e658 = (_e607 + (_e114 * 6u));
                        let _e660 = floor(((_e88.y * _e638) + 0.5f));
                        if (_e658 < _e53) {
                        } else {
                            break;
                        }
                        let _e672 = atomicAdd((&words.member[_e658]), bitcast<u32>(select(0i, select(select(i32(_e660), i32(-2147483648), (_e660 < -2147483600f)), 2147483647i, (_e660 > 2147483500f)), (_e660 == _e660))));
                        let _e674 = (_e607 + (_e114 * 9u));
                        let _e676 = floor(((_e88.z * _e638) + 0.5f));
                        if (_e674 < _e53) {
                        } else {
                            break;
                        }
                        let _e688 = atomicAdd((&words.member[_e674]), bitcast<u32>(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < -2147483600f)), 2147483647i, (_e676 > 2147483500f)), (_e676 == _e676))));
                    }
                    let _e689 = (((_e537[1] * (select(0f, _e510, (_e510 > 0f)) * _e491)) * _e533) * _e610);
                    let _e691 = select(0f, _e689, (_e689 > 0f));
                    let _e693 = select(1073741800f, _e691, (_e691 < 1073741800f));
                    let _e694 = (_e114 + _e607);
                    let _e696 = floor((_e693 + 0.5f));
                    let _e701 = select(select(u32(_e696), 0u, (_e696 < 0f)), 4294967295u, (_e696 > 4294967000f));
                    if (_e701 == 0u) {
                    } else {
                        if (_e694 < _e53) {
                        } else {
                            break;
                        }
                        let _e706 = atomicAdd((&words.member[_e694]), _e701);
                        if (_e706 >= (1073741824u - select(_e701, 1073741824u, (1073741824u < _e701)))) {
                            let _e711 = (_e114 * 12u);
                            if (_e711 < _e53) {
                            } else {
                                break;
                            }
                            let _e715 = atomicOr((&words.member[_e711]), 1u);
                        }
                        let _e716 = (_e693 * 0.6666667f);
                        let _e720 = (_e694 + _e616);
                        let _e722 = floor(((_e88.x * _e716) + 0.5f));
                        if (_e720 < _e53) {
                        } else {
                            break;
                        }
                        let _e734 = atomicAdd((&words.member[_e720]), bitcast<u32>(select(0i, select(select(i32(_e722), i32(-2147483648), (_e722 < -2147483600f)), 2147483647i, (_e722 > 2147483500f)), (_e722 == _e722))));
                        let _e736 = (_e694 + (_e114 * 6u));
                        let _e738 = floor(((_e88.y * _e716) + 0.5f));
                        if (_e736 < _e53) {
                        } else {
                            break;
                        }
                        let _e750 = atomicAdd((&words.member[_e736]), bitcast<u32>(select(0i, select(select(i32(_e738), i32(-2147483648), (_e738 < -2147483600f)), 2147483647i, (_e738 > 2147483500f)), (_e738 == _e738))));
                        let _e752 = (_e694 + (_e114 * 9u));
                        let _e754 = floor(((_e88.z * _e716) + 0.5f));
                        if (_e752 < _e53) {
                        } else {
                            break;
                        }
                        let _e766 = atomicAdd((&words.member[_e752]), bitcast<u32>(select(0i, select(select(i32(_e754), i32(-2147483648), (_e754 < -2147483600f)), 2147483647i, (_e754 > 2147483500f)), (_e754 == _e754))));
                    }
                    let _e767 = (((_e537[2] * (select(0f, _e519, (_e519 > 0f)) * _e491)) * _e533) * _e610);
                    let _e769 = select(0f, _e767, (_e767 > 0f));
                    let _e771 = select(1073741800f, _e769, (_e769 < 1073741800f));
                    let _e773 = ((2u * _e114) + _e607);
                    let _e775 = floor((_e771 + 0.5f));
                    let _e780 = select(select(u32(_e775), 0u, (_e775 < 0f)), 4294967295u, (_e775 > 4294967000f));
                    if (_e780 == 0u) {
                    } else {
                        if (_e773 < _e53) {
                        } else {
                            break;
                        }
                        let _e785 = atomicAdd((&words.member[_e773]), _e780);
                        if (_e785 >= (1073741824u - select(_e780, 1073741824u, (1073741824u < _e780)))) {
                            let _e790 = (_e114 * 12u);
                            if (_e790 < _e53) {
                            } else {
                                break;
                            }
                            let _e794 = atomicOr((&words.member[_e790]), 1u);
                        }
                        let _e795 = (_e771 * 0.6666667f);
                        let _e799 = (_e773 + _e616);
                        let _e801 = floor(((_e88.x * _e795) + 0.5f));
                        if (_e799 < _e53) {
                        } else {
                            break;
                        }
                        let _e813 = atomicAdd((&words.member[_e799]), bitcast<u32>(select(0i, select(select(i32(_e801), i32(-2147483648), (_e801 < -2147483600f)), 2147483647i, (_e801 > 2147483500f)), (_e801 == _e801))));
                        let _e815 = (_e773 + (_e114 * 6u));
                        let _e817 = floor(((_e88.y * _e795) + 0.5f));
                        if (_e815 < _e53) {
                        } else {
                            break;
                        }
                        let _e829 = atomicAdd((&words.member[_e815]), bitcast<u32>(select(0i, select(select(i32(_e817), i32(-2147483648), (_e817 < -2147483600f)), 2147483647i, (_e817 > 2147483500f)), (_e817 == _e817))));
                        let _e831 = (_e773 + (_e114 * 9u));
                        let _e833 = floor(((_e88.z * _e795) + 0.5f));
                        if (_e831 < _e53) {
                        } else {
                            break;
                        }
                        let _e845 = atomicAdd((&words.member[_e831]), bitcast<u32>(select(0i, select(select(i32(_e833), i32(-2147483648), (_e833 < -2147483600f)), 2147483647i, (_e833 > 2147483500f)), (_e833 == _e833))));
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_bounce(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
