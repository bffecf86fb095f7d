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
    var phi_205_: bool;
    var phi_207_: bool;
    var phi_208_: bool;
    var phi_209_: bool;
    var phi_210_: bool;
    var phi_211_: bool;
    var phi_212_: bool;
    var phi_213_: bool;
    var phi_214_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = gid_1;
            let _e37 = arrayLength((&words.member));
            let _e41 = (_e33.x + (_e33.y * 2097152u));
            let _e44 = params.member.member_5;
            if (_e41 < _e44) {
                if (_e41 < arrayLength((&texels.member))) {
                } else {
                    break;
                }
                let _e50 = texels.member[_e41].member_3;
                if (_e50 == 1u) {
                    let _e55 = texels.member[_e41].member_4;
                    let _e62 = texels.member[_e41].member_6;
                    let _e66 = (_e55[0] * _e62[0]);
                    let _e67 = (_e55[1] * _e62[1]);
                    let _e68 = (_e55[2] * _e62[2]);
                    let _e72 = texels.member[_e41].member;
                    let _e79 = texels.member[_e41].member_2;
                    let _e85 = params.member.member_1;
                    let _e88 = params.member.member;
                    let _e105 = floor((((_e72[0] - _e88.x) / _e88.w) + (_e79[0] * 0.515625f)));
                    let _e113 = floor((((_e72[1] - _e88.y) / _e88.w) + (_e79[1] * 0.515625f)));
                    let _e121 = floor((((_e72[2] - _e88.z) / _e88.w) + (_e79[2] * 0.515625f)));
                    let _e132 = (select(0i, select(select(i32(_e105), i32(-2147483648), (_e105 < -2147483600f)), 2147483647i, (_e105 > 2147483500f)), (_e105 == _e105)) - _e85.x);
                    let _e133 = (select(0i, select(select(i32(_e113), i32(-2147483648), (_e113 < -2147483600f)), 2147483647i, (_e113 > 2147483500f)), (_e113 == _e113)) - _e85.y);
                    let _e134 = (select(0i, select(select(i32(_e121), i32(-2147483648), (_e121 < -2147483600f)), 2147483647i, (_e121 > 2147483500f)), (_e121 == _e121)) - _e85.z);
                    let _e137 = params.member.member_2;
                    if (_e132 >= 0i) {
                        if (_e133 >= 0i) {
                            if (_e134 >= 0i) {
                                if (_e132 < bitcast<i32>(_e137.x)) {
                                    let _e146 = (_e133 < bitcast<i32>(_e137.y));
                                    if _e146 {
                                        phi_205_ = (_e134 < bitcast<i32>(_e137.z));
                                    } else {
                                        phi_205_ = bool();
                                    }
                                    let _e151 = phi_205_;
                                    phi_207_ = _e151;
                                    phi_208_ = select(true, false, _e146);
                                } else {
                                    phi_207_ = bool();
                                    phi_208_ = true;
                                }
                                let _e154 = phi_207_;
                                let _e156 = phi_208_;
                                phi_209_ = _e154;
                                phi_210_ = _e156;
                            } else {
                                phi_209_ = bool();
                                phi_210_ = true;
                            }
                            let _e158 = phi_209_;
                            let _e160 = phi_210_;
                            phi_211_ = _e158;
                            phi_212_ = _e160;
                        } else {
                            phi_211_ = bool();
                            phi_212_ = true;
                        }
                        let _e162 = phi_211_;
                        let _e164 = phi_212_;
                        phi_213_ = _e162;
                        phi_214_ = _e164;
                    } else {
                        phi_213_ = bool();
                        phi_214_ = true;
                    }
                    let _e166 = phi_213_;
                    let _e168 = phi_214_;
                    if select(_e166, false, _e168) {
                        let _e171 = (_e137.x + 1u);
                        let _e174 = ((_e137.y + 1u) * _e171);
                        let _e175 = (_e174 + _e171);
                        let _e179 = (_e175 + ((_e137.z + 1u) * _e174));
                        let _e187 = (((_e175 + bitcast<u32>(_e132)) + (bitcast<u32>(_e133) * _e171)) + (bitcast<u32>(_e134) * _e174));
                        let _e190 = params.member.member_16;
                        if (_e190 <= 1u) {
                            let _e194 = params.member.member_7;
                            let _e195 = (_e66 * _e194);
                            let _e197 = select(0f, _e195, (_e195 > 0f));
                            let _e199 = select(1073741800f, _e197, (_e197 < 1073741800f));
                            let _e200 = (3u * _e179);
                            let _e202 = floor((_e199 + 0.5f));
                            let _e207 = select(select(u32(_e202), 0u, (_e202 < 0f)), 4294967295u, (_e202 > 4294967000f));
                            if (_e207 == 0u) {
                            } else {
                                if (_e187 < _e37) {
                                } else {
                                    break;
                                }
                                let _e212 = atomicAdd((&words.member[_e187]), _e207);
                                if (_e212 >= (1073741824u - select(_e207, 1073741824u, (1073741824u < _e207)))) {
                                    let _e220 = ((_e179 * 12u) * select(1u, _e190, (1u < _e190)));
                                    if (_e220 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e224 = atomicOr((&words.member[_e220]), 1u);
                                }
                                let _e225 = (_e199 * 0.6666667f);
                                let _e229 = (_e187 + _e200);
                                let _e231 = floor(((_e79[0] * _e225) + 0.5f));
                                if (_e229 < _e37) {
                                } else {
                                    break;
                                }
                                let _e243 = atomicAdd((&words.member[_e229]), bitcast<u32>(select(0i, select(select(i32(_e231), i32(-2147483648), (_e231 < -2147483600f)), 2147483647i, (_e231 > 2147483500f)), (_e231 == _e231))));
                                let _e245 = (_e187 + (_e179 * 6u));
                                let _e247 = floor(((_e79[1] * _e225) + 0.5f));
                                if (_e245 < _e37) {
                                } else {
                                    break;
                                }
                                let _e259 = atomicAdd((&words.member[_e245]), bitcast<u32>(select(0i, select(select(i32(_e247), i32(-2147483648), (_e247 < -2147483600f)), 2147483647i, (_e247 > 2147483500f)), (_e247 == _e247))));
                                let _e261 = (_e187 + (_e179 * 9u));
                                let _e263 = floor(((_e79[2] * _e225) + 0.5f));
                                if (_e261 < _e37) {
                                } else {
                                    break;
                                }
                                let _e275 = atomicAdd((&words.member[_e261]), bitcast<u32>(select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < -2147483600f)), 2147483647i, (_e263 > 2147483500f)), (_e263 == _e263))));
                            }
                            let _e276 = (_e67 * _e194);
                            let _e278 = select(0f, _e276, (_e276 > 0f));
                            let _e280 = select(1073741800f, _e278, (_e278 < 1073741800f));
                            let _e281 = (_e179 + _e187);
                            let _e283 = floor((_e280 + 0.5f));
                            let _e288 = select(select(u32(_e283), 0u, (_e283 < 0f)), 4294967295u, (_e283 > 4294967000f));
                            if (_e288 == 0u) {
                            } else {
                                if (_e281 < _e37) {
                                } else {
                                    break;
                                }
                                let _e293 = atomicAdd((&words.member[_e281]), _e288);
                                if (_e293 >= (1073741824u - select(_e288, 1073741824u, (1073741824u < _e288)))) {
                                    let _e301 = ((_e179 * 12u) * select(1u, _e190, (1u < _e190)));
                                    if (_e301 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e305 = atomicOr((&words.member[_e301]), 1u);
                                }
                                let _e306 = (_e280 * 0.6666667f);
                                let _e310 = (_e281 + _e200);
                                let _e312 = floor(((_e79[0] * _e306) + 0.5f));
                                if (_e310 < _e37) {
                                } else {
                                    break;
                                }
                                let _e324 = atomicAdd((&words.member[_e310]), bitcast<u32>(select(0i, select(select(i32(_e312), i32(-2147483648), (_e312 < -2147483600f)), 2147483647i, (_e312 > 2147483500f)), (_e312 == _e312))));
                                let _e326 = (_e281 + (_e179 * 6u));
                                let _e328 = floor(((_e79[1] * _e306) + 0.5f));
                                if (_e326 < _e37) {
                                } else {
                                    break;
                                }
                                let _e340 = atomicAdd((&words.member[_e326]), bitcast<u32>(select(0i, select(select(i32(_e328), i32(-2147483648), (_e328 < -2147483600f)), 2147483647i, (_e328 > 2147483500f)), (_e328 == _e328))));
                                let _e342 = (_e281 + (_e179 * 9u));
                                let _e344 = floor(((_e79[2] * _e306) + 0.5f));
                                if (_e342 < _e37) {
                                } else {
                                    break;
                                }
                                let _e356 = atomicAdd((&words.member[_e342]), bitcast<u32>(select(0i, select(select(i32(_e344), i32(-2147483648), (_e344 < -2147483600f)), 2147483647i, (_e344 > 2147483500f)), (_e344 == _e344))));
                            }
                            let _e357 = (_e68 * _e194);
                            let _e359 = select(0f, _e357, (_e357 > 0f));
                            let _e361 = select(1073741800f, _e359, (_e359 < 1073741800f));
                            let _e363 = ((2u * _e179) + _e187);
                            let _e365 = floor((_e361 + 0.5f));
                            let _e370 = select(select(u32(_e365), 0u, (_e365 < 0f)), 4294967295u, (_e365 > 4294967000f));
                            if (_e370 == 0u) {
                            } else {
                                if (_e363 < _e37) {
                                } else {
                                    break;
                                }
                                let _e375 = atomicAdd((&words.member[_e363]), _e370);
                                if (_e375 >= (1073741824u - select(_e370, 1073741824u, (1073741824u < _e370)))) {
                                    let _e383 = ((_e179 * 12u) * select(1u, _e190, (1u < _e190)));
                                    if (_e383 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e387 = atomicOr((&words.member[_e383]), 1u);
                                }
                                let _e388 = (_e361 * 0.6666667f);
                                let _e392 = (_e363 + _e200);
                                let _e394 = floor(((_e79[0] * _e388) + 0.5f));
                                if (_e392 < _e37) {
                                } else {
                                    break;
                                }
                                let _e406 = atomicAdd((&words.member[_e392]), bitcast<u32>(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < -2147483600f)), 2147483647i, (_e394 > 2147483500f)), (_e394 == _e394))));
                                let _e408 = (_e363 + (_e179 * 6u));
                                let _e410 = floor(((_e79[1] * _e388) + 0.5f));
                                if (_e408 < _e37) {
                                } else {
                                    break;
                                }
                                let _e422 = atomicAdd((&words.member[_e408]), bitcast<u32>(select(0i, select(select(i32(_e410), i32(-2147483648), (_e410 < -2147483600f)), 2147483647i, (_e410 > 2147483500f)), (_e410 == _e410))));
                                let _e424 = (_e363 + (_e179 * 9u));
                                let _e426 = floor(((_e79[2] * _e388) + 0.5f));
                                if (_e424 < _e37) {
                                } else {
                                    break;
                                }
                                let _e438 = atomicAdd((&words.member[_e424]), bitcast<u32>(select(0i, select(select(i32(_e426), i32(-2147483648), (_e426 < -2147483600f)), 2147483647i, (_e426 > 2147483500f)), (_e426 == _e426))));
                            }
                        } else {
                            let _e439 = (3u * _e179);
                            let _e440 = (_e179 * 12u);
                            let _e444 = ((select(0u, 1u, (_e79[0] < 0f)) * _e440) + _e187);
                            let _e445 = (_e79[0] * _e79[0]);
                            let _e451 = params.member.member_7;
                            let _e452 = ((_e66 * _e445) * _e451);
                            let _e454 = select(0f, _e452, (_e452 > 0f));
                            let _e456 = select(1073741800f, _e454, (_e454 < 1073741800f));
                            let _e458 = floor((_e456 + 0.5f));
                            let _e463 = select(select(u32(_e458), 0u, (_e458 < 0f)), 4294967295u, (_e458 > 4294967000f));
                            if (_e463 == 0u) {
                            } else {
                                if (_e444 < _e37) {
                                } else {
                                    break;
                                }
                                let _e468 = atomicAdd((&words.member[_e444]), _e463);
                                if (_e468 >= (1073741824u - select(_e463, 1073741824u, (1073741824u < _e463)))) {
                                    let _e475 = (_e440 * select(1u, _e190, (1u < _e190)));
                                    if (_e475 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e479 = atomicOr((&words.member[_e475]), 1u);
                                }
                                let _e480 = (_e456 * 0.6666667f);
                                let _e484 = (_e444 + _e439);
                                let _e486 = floor(((_e79[0] * _e480) + 0.5f));
                                if (_e484 < _e37) {
                                } else {
                                    break;
                                }
                                let _e498 = atomicAdd((&words.member[_e484]), bitcast<u32>(select(0i, select(select(i32(_e486), i32(-2147483648), (_e486 < -2147483600f)), 2147483647i, (_e486 > 2147483500f)), (_e486 == _e486))));
                                let _e500 = (_e444 + (_e179 * 6u));
                                let _e502 = floor(((_e79[1] * _e480) + 0.5f));
                                if (_e500 < _e37) {
                                } else {
                                    break;
                                }
                                let _e514 = atomicAdd((&words.member[_e500]), bitcast<u32>(select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < -2147483600f)), 2147483647i, (_e502 > 2147483500f)), (_e502 == _e502))));
                                let _e516 = (_e444 + (_e179 * 9u));
                                let _e518 = floor(((_e79[2] * _e480) + 0.5f));
                                if (_e516 < _e37) {
                                } else {
                                    break;
                                }
                                let _e530 = atomicAdd((&words.member[_e516]), bitcast<u32>(select(0i, select(select(i32(_e518), i32(-2147483648), (_e518 < -2147483600f)), 2147483647i, (_e518 > 2147483500f)), (_e518 == _e518))));
                            }
                            let _e531 = ((_e67 * _e445) * _e451);
                            let _e533 = select(0f, _e531, (_e531 > 0f));
                            let _e535 = select(1073741800f, _e533, (_e533 < 1073741800f));
                            let _e536 = (_e179 + _e444);
                            let _e538 = floor((_e535 + 0.5f));
                            let _e543 = select(select(u32(_e538), 0u, (_e538 < 0f)), 4294967295u, (_e538 > 4294967000f));
                            if (_e543 == 0u) {
                            } else {
                                if (_e536 < _e37) {
                                } else {
                                    break;
                                }
                                let _e548 = atomicAdd((&words.member[_e536]), _e543);
                                if (_e548 >= (1073741824u - select(_e543, 1073741824u, (1073741824u < _e543)))) {
                                    let _e555 = (_e440 * select(1u, _e190, (1u < _e190)));
                                    if (_e555 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e559 = atomicOr((&words.member[_e555]), 1u);
                                }
                                let _e560 = (_e535 * 0.6666667f);
                                let _e564 = (_e536 + _e439);
                                let _e566 = floor(((_e79[0] * _e560) + 0.5f));
                                if (_e564 < _e37) {
                                } else {
                                    break;
                                }
                                let _e578 = atomicAdd((&words.member[_e564]), bitcast<u32>(select(0i, select(select(i32(_e566), i32(-2147483648), (_e566 < -2147483600f)), 2147483647i, (_e566 > 2147483500f)), (_e566 == _e566))));
                                let _e580 = (_e536 + (_e179 * 6u));
                                let _e582 = floor(((_e79[1] * _e560) + 0.5f));
                                if (_e580 < _e37) {
                                } else {
                                    break;
                                }
                                let _e594 = atomicAdd((&words.member[_e580]), bitcast<u32>(select(0i, select(select(i32(_e582), i32(-2147483648), (_e582 < -2147483600f)), 2147483647i, (_e582 > 2147483500f)), (_e582 == _e582))));
                                let _e596 = (_e536 + (_e179 * 9u));
                                let _e598 = floor(((_e79[2] * _e560) + 0.5f));
                                if (_e596 < _e37) {
                                } else {
                                    break;
                                }
                                let _e610 = atomicAdd((&words.member[_e596]), bitcast<u32>(select(0i, select(select(i32(_e598), i32(-2147483648), (_e598 < -2147483600f)), 2147483647i, (_e598 > 2147483500f)), (_e598 == _e598))));
                            }
                            let _e611 = ((_e68 * _e445) * _e451);
                            let _e613 = select(0f, _e611, (_e611 > 0f));
                            let _e615 = select(1073741800f, _e613, (_e613 < 1073741800f));
                            let _e616 = (2u * _e179);
                            let _e617 = (_e616 + _e444);
                            let _e619 = floor((_e615 + 0.5f));
                            let _e624 = select(select(u32(_e619), 0u, (_e619 < 0f)), 4294967295u, (_e619 > 4294967000f));
                            if (_e624 == 0u) {
                            } else {
                                if (_e617 < _e37) {
                                } else {
                                    break;
                                }
                                let _e629 = atomicAdd((&words.member[_e617]), _e624);
                                if (_e629 >= (1073741824u - select(_e624, 1073741824u, (1073741824u < _e624)))) {
                                    let _e636 = (_e440 * select(1u, _e190, (1u < _e190)));
                                    if (_e636 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e640 = atomicOr((&words.member[_e636]), 1u);
                                }
                                let _e641 = (_e615 * 0.6666667f);
                                let _e645 = (_e617 + _e439);
                                let _e647 = floor(((_e79[0] * _e641) + 0.5f));
                                if (_e645 < _e37) {
                                } else {
                                    break;
                                }
                                let _e659 = atomicAdd((&words.member[_e645]), bitcast<u32>(select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < -2147483600f)), 2147483647i, (_e647 > 2147483500f)), (_e647 == _e647))));
                                let _e661 = (_e617 + (_e179 * 6u));
                                let _e663 = floor(((_e79[1] * _e641) + 0.5f));
                                if (_e661 < _e37) {
                                } else {
                                    break;
                                }
                                let _e675 = atomicAdd((&words.member[_e661]), bitcast<u32>(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < -2147483600f)), 2147483647i, (_e663 > 2147483500f)), (_e663 == _e663))));
                                let _e677 = (_e617 + (_e179 * 9u));
                                let _e679 = floor(((_e79[2] * _e641) + 0.5f));
                                if (_e677 < _e37) {
                                } else {
                                    break;
                                }
                                let _e691 = atomicAdd((&words.member[_e677]), bitcast<u32>(select(0i, select(select(i32(_e679), i32(-2147483648), (_e679 < -2147483600f)), 2147483647i, (_e679 > 2147483500f)), (_e679 == _e679))));
                            }
                            let _e696 = (((2u + select(0u, 1u, (_e79[1] < 0f))) * _e440) + _e187);
                            let _e697 = (_e79[1] * _e79[1]);
                            let _e701 = ((_e66 * _e697) * _e451);
                            let _e703 = select(0f, _e701, (_e701 > 0f));
                            let _e705 = select(1073741800f, _e703, (_e703 < 1073741800f));
                            let _e707 = floor((_e705 + 0.5f));
                            let _e712 = select(select(u32(_e707), 0u, (_e707 < 0f)), 4294967295u, (_e707 > 4294967000f));
                            if (_e712 == 0u) {
                            } else {
                                if (_e696 < _e37) {
                                } else {
                                    break;
                                }
                                let _e717 = atomicAdd((&words.member[_e696]), _e712);
                                if (_e717 >= (1073741824u - select(_e712, 1073741824u, (1073741824u < _e712)))) {
                                    let _e724 = (_e440 * select(1u, _e190, (1u < _e190)));
                                    if (_e724 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e728 = atomicOr((&words.member[_e724]), 1u);
                                }
                                let _e729 = (_e705 * 0.6666667f);
                                let _e733 = (_e696 + _e439);
                                let _e735 = floor(((_e79[0] * _e729) + 0.5f));
                                if (_e733 < _e37) {
                                } else {
                                    break;
                                }
                                let _e747 = atomicAdd((&words.member[_e733]), bitcast<u32>(select(0i, select(select(i32(_e735), i32(-2147483648), (_e735 < -2147483600f)), 2147483647i, (_e735 > 2147483500f)), (_e735 == _e735))));
                                let _e749 = (_e696 + (_e179 * 6u));
                                let _e751 = floor(((_e79[1] * _e729) + 0.5f));
                                if (_e749 < _e37) {
                                } else {
                                    break;
                                }
                                let _e763 = atomicAdd((&words.member[_e749]), bitcast<u32>(select(0i, select(select(i32(_e751), i32(-2147483648), (_e751 < -2147483600f)), 2147483647i, (_e751 > 2147483500f)), (_e751 == _e751))));
                                let _e765 = (_e696 + (_e179 * 9u));
                                let _e767 = floor(((_e79[2] * _e729) + 0.5f));
                                if (_e765 < _e37) {
                                } else {
                                    break;
                                }
                                let _e779 = atomicAdd((&words.member[_e765]), bitcast<u32>(select(0i, select(select(i32(_e767), i32(-2147483648), (_e767 < -2147483600f)), 2147483647i, (_e767 > 2147483500f)), (_e767 == _e767))));
                            }
                            let _e780 = ((_e67 * _e697) * _e451);
                            let _e782 = select(0f, _e780, (_e780 > 0f));
                            let _e784 = select(1073741800f, _e782, (_e782 < 1073741800f));
                            let _e785 = (_e179 + _e696);
                            let _e787 = floor((_e784 + 0.5f));
                            let _e792 = select(select(u32(_e787), 0u, (_e787 < 0f)), 4294967295u, (_e787 > 4294967000f));
                            if (_e792 == 0u) {
                            } else {
                                if (_e785 < _e37) {
                                } else {
                                    break;
                                }
                                let _e797 = atomicAdd((&words.member[_e785]), _e792);
                                if (_e797 >= (1073741824u - select(_e792, 1073741824u, (1073741824u < _e792)))) {
                                    let _e804 = (_e440 * select(1u, _e190, (1u < _e190)));
                                    if (_e804 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e808 = atomicOr((&words.member[_e804]), 1u);
                                }
                                let _e809 = (_e784 * 0.6666667f);
                                let _e813 = (_e785 + _e439);
                                let _e815 = floor(((_e79[0] * _e809) + 0.5f));
                                if (_e813 < _e37) {
                                } else {
                                    break;
                                }
                                let _e827 = atomicAdd((&words.member[_e813]), bitcast<u32>(select(0i, select(select(i32(_e815), i32(-2147483648), (_e815 < -2147483600f)), 2147483647i, (_e815 > 2147483500f)), (_e815 == _e815))));
                                let _e829 = (_e785 + (_e179 * 6u));
                                let _e831 = floor(((_e79[1] * _e809) + 0.5f));
                                if (_e829 < _e37) {
                                } else {
                                    break;
                                }
                                let _e843 = atomicAdd((&words.member[_e829]), bitcast<u32>(select(0i, select(select(i32(_e831), i32(-2147483648), (_e831 < -2147483600f)), 2147483647i, (_e831 > 2147483500f)), (_e831 == _e831))));
                                let _e845 = (_e785 + (_e179 * 9u));
                                let _e847 = floor(((_e79[2] * _e809) + 0.5f));
                                if (_e845 < _e37) {
                                } else {
                                    break;
                                }
                                let _e859 = atomicAdd((&words.member[_e845]), bitcast<u32>(select(0i, select(select(i32(_e847), i32(-2147483648), (_e847 < -2147483600f)), 2147483647i, (_e847 > 2147483500f)), (_e847 == _e847))));
                            }
                            let _e860 = ((_e68 * _e697) * _e451);
                            let _e862 = select(0f, _e860, (_e860 > 0f));
                            let _e864 = select(1073741800f, _e862, (_e862 < 1073741800f));
                            let _e865 = (_e616 + _e696);
                            let _e867 = floor((_e864 + 0.5f));
                            let _e872 = select(select(u32(_e867), 0u, (_e867 < 0f)), 4294967295u, (_e867 > 4294967000f));
                            if (_e872 == 0u) {
                            } else {
                                if (_e865 < _e37) {
                                } else {
                                    break;
                                }
                                let _e877 = atomicAdd((&words.member[_e865]), _e872);
                                if (_e877 >= (1073741824u - select(_e872, 1073741824u, (1073741824u < _e872)))) {
                                    let _e884 = (_e440 * select(1u, _e190, (1u < _e190)));
                                    if (_e884 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e888 = atomicOr((&words.member[_e884]), 1u);
                                }
                                let _e889 = (_e864 * 0.6666667f);
                                let _e893 = (_e865 + _e439);
                                let _e895 = floor(((_e79[0] * _e889) + 0.5f));
                                if (_e893 < _e37) {
                                } else {
                                    break;
                                }
                                let _e907 = atomicAdd((&words.member[_e893]), bitcast<u32>(select(0i, select(select(i32(_e895), i32(-2147483648), (_e895 < -2147483600f)), 2147483647i, (_e895 > 2147483500f)), (_e895 == _e895))));
                                let _e909 = (_e865 + (_e179 * 6u));
                                let _e911 = floor(((_e79[1] * _e889) + 0.5f));
                                if (_e909 < _e37) {
                                } else {
                                    break;
                                }
                                let _e923 = atomicAdd((&words.member[_e909]), bitcast<u32>(select(0i, select(select(i32(_e911), i32(-2147483648), (_e911 < -2147483600f)), 2147483647i, (_e911 > 2147483500f)), (_e911 == _e911))));
                                let _e925 = (_e865 + (_e179 * 9u));
                                let _e927 = floor(((_e79[2] * _e889) + 0.5f));
                                if (_e925 < _e37) {
                                } else {
                                    break;
                                }
                                let _e939 = atomicAdd((&words.member[_e925]), bitcast<u32>(select(0i, select(select(i32(_e927), i32(-2147483648), (_e927 < -2147483600f)), 2147483647i, (_e927 > 2147483500f)), (_e927 == _e927))));
                            }
                            let _e944 = (((4u + select(0u, 1u, (_e79[2] < 0f))) * _e440) + _e187);
                            let _e945 = (_e79[2] * _e79[2]);
                            let _e949 = ((_e66 * _e945) * _e451);
                            let _e951 = select(0f, _e949, (_e949 > 0f));
                            let _e953 = select(1073741800f, _e951, (_e951 < 1073741800f));
                            let _e955 = floor((_e953 + 0.5f));
                            let _e960 = select(select(u32(_e955), 0u, (_e955 < 0f)), 4294967295u, (_e955 > 4294967000f));
                            if (_e960 == 0u) {
                            } else {
                                if (_e944 < _e37) {
                                } else {
                                    break;
                                }
                                let _e965 = atomicAdd((&words.member[_e944]), _e960);
                                if (_e965 >= (1073741824u - select(_e960, 1073741824u, (1073741824u < _e960)))) {
                                    let _e972 = (_e440 * select(1u, _e190, (1u < _e190)));
                                    if (_e972 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e976 = atomicOr((&words.member[_e972]), 1u);
                                }
                                let _e977 = (_e953 * 0.6666667f);
                                let _e981 = (_e944 + _e439);
                                let _e983 = floor(((_e79[0] * _e977) + 0.5f));
                                if (_e981 < _e37) {
                                } else {
                                    break;
                                }
                                let _e995 = atomicAdd((&words.member[_e981]), bitcast<u32>(select(0i, select(select(i32(_e983), i32(-2147483648), (_e983 < -2147483600f)), 2147483647i, (_e983 > 2147483500f)), (_e983 == _e983))));
                                let _e997 = (_e944 + (_e179 * 6u));
                                let _e999 = floor(((_e79[1] * _e977) + 0.5f));
                                if (_e997 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1011 = atomicAdd((&words.member[_e997]), bitcast<u32>(select(0i, select(select(i32(_e999), i32(-2147483648), (_e999 < -2147483600f)), 2147483647i, (_e999 > 2147483500f)), (_e999 == _e999))));
                                let _e1013 = (_e944 + (_e179 * 9u));
                                let _e1015 = floor(((_e79[2] * _e977) + 0.5f));
                                if (_e1013 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1027 = atomicAdd((&words.member[_e1013]), bitcast<u32>(select(0i, select(select(i32(_e1015), i32(-2147483648), (_e1015 < -2147483600f)), 2147483647i, (_e1015 > 2147483500f)), (_e1015 == _e1015))));
                            }
                            let _e1028 = ((_e67 * _e945) * _e451);
                            let _e1030 = select(0f, _e1028, (_e1028 > 0f));
                            let _e1032 = select(1073741800f, _e1030, (_e1030 < 1073741800f));
                            let _e1033 = (_e179 + _e944);
                            let _e1035 = floor((_e1032 + 0.5f));
                            let _e1040 = select(select(u32(_e1035), 0u, (_e1035 < 0f)), 4294967295u, (_e1035 > 4294967000f));
                            if (_e1040 == 0u) {
                            } else {
                                if (_e1033 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1045 = atomicAdd((&words.member[_e1033]), _e1040);
                                if (_e1045 >= (1073741824u - select(_e1040, 1073741824u, (1073741824u < _e1040)))) {
                                    let _e1052 = (_e440 * select(1u, _e190, (1u < _e190)));
                                    if (_e1052 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e1056 = atomicOr((&words.member[_e1052]), 1u);
                                }
                                let _e1057 = (_e1032 * 0.6666667f);
                                let _e1061 = (_e1033 + _e439);
                                let _e1063 = floor(((_e79[0] * _e1057) + 0.5f));
                                if (_e1061 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1075 = atomicAdd((&words.member[_e1061]), bitcast<u32>(select(0i, select(select(i32(_e1063), i32(-2147483648), (_e1063 < -2147483600f)), 2147483647i, (_e1063 > 2147483500f)), (_e1063 == _e1063))));
                                let _e1077 = (_e1033 + (_e179 * 6u));
                                let _e1079 = floor(((_e79[1] * _e1057) + 0.5f));
                                if (_e1077 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1091 = atomicAdd((&words.member[_e1077]), bitcast<u32>(select(0i, select(select(i32(_e1079), i32(-2147483648), (_e1079 < -2147483600f)), 2147483647i, (_e1079 > 2147483500f)), (_e1079 == _e1079))));
                                let _e1093 = (_e1033 + (_e179 * 9u));
                                let _e1095 = floor(((_e79[2] * _e1057) + 0.5f));
                                if (_e1093 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1107 = atomicAdd((&words.member[_e1093]), bitcast<u32>(select(0i, select(select(i32(_e1095), i32(-2147483648), (_e1095 < -2147483600f)), 2147483647i, (_e1095 > 2147483500f)), (_e1095 == _e1095))));
                            }
                            let _e1108 = ((_e68 * _e945) * _e451);
                            let _e1110 = select(0f, _e1108, (_e1108 > 0f));
                            let _e1112 = select(1073741800f, _e1110, (_e1110 < 1073741800f));
                            let _e1113 = (_e616 + _e944);
                            let _e1115 = floor((_e1112 + 0.5f));
                            let _e1120 = select(select(u32(_e1115), 0u, (_e1115 < 0f)), 4294967295u, (_e1115 > 4294967000f));
                            if (_e1120 == 0u) {
                            } else {
                                if (_e1113 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1125 = atomicAdd((&words.member[_e1113]), _e1120);
                                if (_e1125 >= (1073741824u - select(_e1120, 1073741824u, (1073741824u < _e1120)))) {
                                    let _e1132 = (_e440 * select(1u, _e190, (1u < _e190)));
                                    if (_e1132 < _e37) {
                                    } else {
                                        break;
                                    }
                                    let _e1136 = atomicOr((&words.member[_e1132]), 1u);
                                }
                                let _e1137 = (_e1112 * 0.6666667f);
                                let _e1141 = (_e1113 + _e439);
                                let _e1143 = floor(((_e79[0] * _e1137) + 0.5f));
                                if (_e1141 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1155 = atomicAdd((&words.member[_e1141]), bitcast<u32>(select(0i, select(select(i32(_e1143), i32(-2147483648), (_e1143 < -2147483600f)), 2147483647i, (_e1143 > 2147483500f)), (_e1143 == _e1143))));
                                let _e1157 = (_e1113 + (_e179 * 6u));
                                let _e1159 = floor(((_e79[1] * _e1137) + 0.5f));
                                if (_e1157 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1171 = atomicAdd((&words.member[_e1157]), bitcast<u32>(select(0i, select(select(i32(_e1159), i32(-2147483648), (_e1159 < -2147483600f)), 2147483647i, (_e1159 > 2147483500f)), (_e1159 == _e1159))));
                                let _e1173 = (_e1113 + (_e179 * 9u));
                                let _e1175 = floor(((_e79[2] * _e1137) + 0.5f));
                                if (_e1173 < _e37) {
                                } else {
                                    break;
                                }
                                let _e1187 = atomicAdd((&words.member[_e1173]), bitcast<u32>(select(0i, select(select(i32(_e1175), i32(-2147483648), (_e1175 < -2147483600f)), 2147483647i, (_e1175 > 2147483500f)), (_e1175 == _e1175))));
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
