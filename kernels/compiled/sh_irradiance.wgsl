struct type_5 {
    member: array<f32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_16 {
    member: type_15,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_16;
@group(0) @binding(1) 
var<storage> coefs: type_5;
@group(0) @binding(2) 
var<storage> normals: type_5;
@group(0) @binding(3) 
var<storage, read_write> irradiance: type_5;

fn function_() {
    var local: array<f32, 3>;
    var phi_205_: u32;
    var phi_267_: u32;
    var phi_286_: u32;
    var phi_451_: array<f32, 3>;
    var phi_453_: f32;
    var phi_514_: array<f32, 3>;
    var phi_516_: f32;
    var phi_579_: f32;
    var phi_640_: array<f32, 3>;
    var phi_642_: f32;
    var phi_705_: f32;
    var phi_766_: array<f32, 3>;
    var phi_768_: f32;
    var phi_831_: f32;
    var phi_892_: array<f32, 3>;
    var phi_1071_: array<f32, 3>;
    var phi_1184_: array<f32, 3>;
    var phi_1186_: f32;
    var phi_1303_: f32;
    var phi_1418_: array<f32, 3>;
    var phi_1420_: f32;
    var phi_1537_: f32;
    var phi_1652_: array<f32, 3>;
    var phi_1654_: f32;
    var phi_1771_: f32;
    var phi_1886_: array<f32, 3>;
    var phi_2004_: array<f32, 3>;
    var phi_2125_: array<f32, 3>;
    var phi_2240_: f32;
    var phi_2355_: array<f32, 3>;
    var phi_2357_: f32;
    var phi_2474_: f32;
    var phi_2589_: array<f32, 3>;
    var phi_2591_: f32;
    var phi_2708_: f32;
    var phi_2823_: array<f32, 3>;
    var phi_2941_: array<f32, 3>;
    var phi_2942_: f32;
    var phi_2943_: f32;
    var phi_3177_: array<f32, 3>;
    var phi_3179_: f32;
    var phi_3296_: f32;
    var phi_3411_: array<f32, 3>;
    var phi_3413_: f32;
    var phi_3530_: f32;
    var phi_3645_: array<f32, 3>;
    var phi_3763_: array<f32, 3>;
    var phi_3764_: f32;
    var phi_3765_: f32;
    var phi_3886_: array<f32, 3>;
    var phi_4001_: f32;
    var phi_4116_: array<f32, 3>;
    var phi_4118_: f32;
    var phi_4235_: f32;
    var phi_4350_: array<f32, 3>;
    var phi_4468_: array<f32, 3>;
    var phi_4469_: f32;
    var phi_4470_: f32;
    var phi_4704_: array<f32, 3>;
    var phi_4706_: f32;
    var phi_4823_: f32;
    var phi_4938_: array<f32, 3>;
    var phi_5056_: array<f32, 3>;
    var phi_5057_: f32;
    var phi_5058_: f32;
    var phi_5179_: array<f32, 3>;
    var phi_5294_: f32;
    var phi_5409_: array<f32, 3>;
    var phi_5527_: array<f32, 3>;
    var phi_5528_: f32;
    var phi_5529_: f32;
    var phi_5763_: array<f32, 3>;
    var phi_5881_: array<f32, 3>;
    var phi_5882_: f32;
    var phi_5883_: f32;
    var phi_6004_: array<f32, 3>;
    var phi_6118_: array<f32, 3>;
    var phi_6258_: type_13;
    var phi_6259_: type_13;
    var phi_6282_: type_13;
    var phi_6312_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e120 = gid_1;
            let _e123 = arrayLength((&coefs.member));
            let _e125 = arrayLength((&normals.member));
            let _e130 = params.member.member;
            let _e131 = (_e130 / 64u);
            let _e133 = ((_e130 % 64u) > 0u);
            if _e133 {
                phi_205_ = (_e131 + 1u);
            } else {
                phi_205_ = _e131;
            }
            let _e136 = phi_205_;
            let _e137 = (_e136 * 64u);
            let _e141 = (_e120.x + (_e120.y * 2097152u));
            if (_e141 < _e137) {
                let _e144 = ((_e141 / 64u) * 64u);
                let _e148 = params.member.member_2;
                if _e133 {
                    phi_267_ = (_e131 + 1u);
                } else {
                    phi_267_ = _e131;
                }
                let _e153 = phi_267_;
                let _e154 = (select(_e148, 9u, (_e148 > 9u)) + 1u);
                let _e155 = (_e154 * _e154);
                let _e156 = (_e155 / 4u);
                if ((_e155 % 4u) > 0u) {
                    phi_286_ = (_e156 + 1u);
                } else {
                    phi_286_ = _e156;
                }
                let _e161 = phi_286_;
                if (_e141 < _e125) {
                } else {
                    break;
                }
                let _e166 = normals.member[_e141];
                let _e167 = ((_e153 * 64u) + _e141);
                if (_e167 < _e125) {
                } else {
                    break;
                }
                let _e171 = normals.member[_e167];
                let _e173 = ((_e153 * 128u) + _e141);
                if (_e173 < _e125) {
                } else {
                    break;
                }
                let _e177 = normals.member[_e173];
                let _e183 = (((((_e144 / 64u) * _e161) * 64u) + (_e144 % 64u)) + (_e141 - _e144));
                let _e184 = (_e153 * _e161);
                let _e185 = (_e184 * 64u);
                if (_e183 < _e123) {
                } else {
                    break;
                }
                let _e188 = coefs.member[_e183];
                let _e189 = (_e188 * 0.886227f);
                let _e190 = (_e184 * 256u);
                let _e191 = (_e183 + _e190);
                if (_e191 < _e123) {
                } else {
                    break;
                }
                let _e194 = coefs.member[_e191];
                let _e195 = (_e194 * 0.886227f);
                let _e196 = (_e184 * 512u);
                let _e197 = (_e183 + _e196);
                if (_e197 < _e123) {
                } else {
                    break;
                }
                let _e200 = coefs.member[_e197];
                let _e201 = (_e200 * 0.886227f);
                let _e203 = (1u <= _e148);
                if _e203 {
                    let _e205 = (_e177 * 1.0233268f);
                    let _e207 = (_e183 + (_e184 * 128u));
                    if (_e207 < _e123) {
                    } else {
                        break;
                    }
                    let _e210 = coefs.member[_e207];
                    let _e213 = (_e207 + _e190);
                    if (_e213 < _e123) {
                    } else {
                        break;
                    }
                    let _e216 = coefs.member[_e213];
                    let _e219 = (_e207 + _e196);
                    if (_e219 < _e123) {
                    } else {
                        break;
                    }
                    let _e222 = coefs.member[_e219];
                    phi_451_ = array<f32, 3>((_e189 + (_e210 * _e205)), (_e195 + (_e216 * _e205)), (_e201 + (_e222 * _e205)));
                    phi_453_ = (_e177 * 0.48860252f);
                } else {
                    phi_451_ = array<f32, 3>(_e189, _e195, _e201);
                    phi_453_ = 0.2820948f;
                }
                let _e227 = phi_451_;
                let _e229 = phi_453_;
                let _e230 = select(0f, 0.2820948f, _e203);
                let _e231 = (2u <= _e148);
                if _e231 {
                    let _e235 = (((_e177 * 1.9364917f) * _e229) - (1.118034f * _e230));
                    let _e236 = (_e235 * 0.7853982f);
                    let _e239 = ((_e183 + (_e184 * 128u)) + 64u);
                    if (_e239 < _e123) {
                    } else {
                        break;
                    }
                    let _e243 = coefs.member[_e239];
                    let _e247 = (_e239 + _e190);
                    if (_e247 < _e123) {
                    } else {
                        break;
                    }
                    let _e250 = coefs.member[_e247];
                    let _e254 = (_e239 + _e196);
                    if (_e254 < _e123) {
                    } else {
                        break;
                    }
                    let _e257 = coefs.member[_e254];
                    phi_514_ = array<f32, 3>((_e227[0] + (_e243 * _e236)), (_e227[1] + (_e250 * _e236)), (_e227[2] + (_e257 * _e236)));
                    phi_516_ = _e235;
                } else {
                    phi_514_ = _e227;
                    phi_516_ = _e229;
                }
                let _e262 = phi_514_;
                let _e264 = phi_516_;
                let _e265 = select(_e230, _e229, _e231);
                let _e266 = (3u <= _e148);
                if _e266 {
                    phi_579_ = (((_e177 * 1.9720266f) * _e264) - (1.0183501f * _e265));
                } else {
                    phi_579_ = _e264;
                }
                let _e272 = phi_579_;
                let _e273 = select(_e265, _e264, _e266);
                let _e274 = (4u <= _e148);
                if _e274 {
                    let _e278 = (((_e177 * 1.9843135f) * _e272) - (1.0062306f * _e273));
                    let _e279 = (_e278 * -0.1308997f);
                    let _e280 = (_e183 + 320u);
                    if (_e280 < _e123) {
                    } else {
                        break;
                    }
                    let _e284 = coefs.member[_e280];
                    let _e288 = (_e280 + _e190);
                    if (_e288 < _e123) {
                    } else {
                        break;
                    }
                    let _e291 = coefs.member[_e288];
                    let _e295 = (_e280 + _e196);
                    if (_e295 < _e123) {
                    } else {
                        break;
                    }
                    let _e298 = coefs.member[_e295];
                    phi_640_ = array<f32, 3>((_e262[0] + (_e284 * _e279)), (_e262[1] + (_e291 * _e279)), (_e262[2] + (_e298 * _e279)));
                    phi_642_ = _e278;
                } else {
                    phi_640_ = _e262;
                    phi_642_ = _e272;
                }
                let _e303 = phi_640_;
                let _e305 = phi_642_;
                let _e306 = select(_e273, _e272, _e274);
                let _e307 = (5u <= _e148);
                if _e307 {
                    phi_705_ = (((_e177 * 1.9899749f) * _e305) - (1.002853f * _e306));
                } else {
                    phi_705_ = _e305;
                }
                let _e313 = phi_705_;
                let _e314 = select(_e306, _e305, _e307);
                let _e315 = (6u <= _e148);
                if _e315 {
                    let _e319 = (((_e177 * 1.9930434f) * _e313) - (1.001542f * _e314));
                    let _e320 = (_e319 * 0.049087387f);
                    let _e323 = ((_e183 + (_e184 * 128u)) + 640u);
                    if (_e323 < _e123) {
                    } else {
                        break;
                    }
                    let _e327 = coefs.member[_e323];
                    let _e331 = (_e323 + _e190);
                    if (_e331 < _e123) {
                    } else {
                        break;
                    }
                    let _e334 = coefs.member[_e331];
                    let _e338 = (_e323 + _e196);
                    if (_e338 < _e123) {
                    } else {
                        break;
                    }
                    let _e341 = coefs.member[_e338];
                    phi_766_ = array<f32, 3>((_e303[0] + (_e327 * _e320)), (_e303[1] + (_e334 * _e320)), (_e303[2] + (_e341 * _e320)));
                    phi_768_ = _e319;
                } else {
                    phi_766_ = _e303;
                    phi_768_ = _e313;
                }
                let _e346 = phi_766_;
                let _e348 = phi_768_;
                let _e349 = select(_e314, _e313, _e315);
                let _e350 = (7u <= _e148);
                if _e350 {
                    phi_831_ = (((_e177 * 1.9948914f) * _e348) - (1.0009272f * _e349));
                } else {
                    phi_831_ = _e348;
                }
                let _e356 = phi_831_;
                let _e358 = (8u <= _e148);
                if _e358 {
                    let _e363 = ((((_e177 * 1.9960899f) * _e356) - (1.0006008f * select(_e349, _e348, _e350))) * -0.024543693f);
                    let _e364 = (_e183 + 1152u);
                    if (_e364 < _e123) {
                    } else {
                        break;
                    }
                    let _e368 = coefs.member[_e364];
                    let _e372 = (_e364 + _e190);
                    if (_e372 < _e123) {
                    } else {
                        break;
                    }
                    let _e375 = coefs.member[_e372];
                    let _e379 = (_e364 + _e196);
                    if (_e379 < _e123) {
                    } else {
                        break;
                    }
                    let _e382 = coefs.member[_e379];
                    phi_892_ = array<f32, 3>((_e346[0] + (_e368 * _e363)), (_e346[1] + (_e375 * _e363)), (_e346[2] + (_e382 * _e363)));
                } else {
                    phi_892_ = _e346;
                }
                let _e387 = phi_892_;
                if _e203 {
                    if _e203 {
                        let _e388 = (_e166 * 1.0233268f);
                        let _e390 = (_e183 + (_e184 * 192u));
                        if (_e390 < _e123) {
                        } else {
                            break;
                        }
                        let _e394 = coefs.member[_e390];
                        let _e398 = (_e390 + _e190);
                        if (_e398 < _e123) {
                        } else {
                            break;
                        }
                        let _e401 = coefs.member[_e398];
                        let _e405 = (_e390 + _e196);
                        if (_e405 < _e123) {
                        } else {
                            break;
                        }
                        let _e408 = coefs.member[_e405];
                        let _e411 = (_e171 * 1.0233268f);
                        let _e412 = (_e183 + _e185);
                        if (_e412 < _e123) {
                        } else {
                            break;
                        }
                        let _e415 = coefs.member[_e412];
                        let _e418 = (_e412 + _e190);
                        if (_e418 < _e123) {
                        } else {
                            break;
                        }
                        let _e421 = coefs.member[_e418];
                        let _e424 = (_e412 + _e196);
                        if (_e424 < _e123) {
                        } else {
                            break;
                        }
                        let _e427 = coefs.member[_e424];
                        phi_1071_ = array<f32, 3>(((_e387[0] + (_e394 * _e388)) + (_e415 * _e411)), ((_e387[1] + (_e401 * _e388)) + (_e421 * _e411)), ((_e387[2] + (_e408 * _e388)) + (_e427 * _e411)));
                    } else {
                        phi_1071_ = _e387;
                    }
                    let _e432 = phi_1071_;
                    if _e231 {
                        let _e433 = (_e177 * 1.0925485f);
                        let _e435 = ((_e433 * _e166) * 0.7853982f);
                        let _e438 = ((_e183 + (_e184 * 192u)) + 64u);
                        if (_e438 < _e123) {
                        } else {
                            break;
                        }
                        let _e442 = coefs.member[_e438];
                        let _e446 = (_e438 + _e190);
                        if (_e446 < _e123) {
                        } else {
                            break;
                        }
                        let _e449 = coefs.member[_e446];
                        let _e453 = (_e438 + _e196);
                        if (_e453 < _e123) {
                        } else {
                            break;
                        }
                        let _e456 = coefs.member[_e453];
                        let _e460 = ((_e433 * _e171) * 0.7853982f);
                        let _e462 = ((_e183 + _e185) + 64u);
                        if (_e462 < _e123) {
                        } else {
                            break;
                        }
                        let _e465 = coefs.member[_e462];
                        let _e468 = (_e462 + _e190);
                        if (_e468 < _e123) {
                        } else {
                            break;
                        }
                        let _e471 = coefs.member[_e468];
                        let _e474 = (_e462 + _e196);
                        if (_e474 < _e123) {
                        } else {
                            break;
                        }
                        let _e477 = coefs.member[_e474];
                        phi_1184_ = array<f32, 3>(((_e432[0] + (_e442 * _e435)) + (_e465 * _e460)), ((_e432[1] + (_e449 * _e435)) + (_e471 * _e460)), ((_e432[2] + (_e456 * _e435)) + (_e477 * _e460)));
                        phi_1186_ = _e433;
                    } else {
                        phi_1184_ = _e432;
                        phi_1186_ = 0.48860252f;
                    }
                    let _e482 = phi_1184_;
                    let _e484 = phi_1186_;
                    let _e485 = select(0f, 0.48860252f, _e231);
                    if _e266 {
                        phi_1303_ = (((_e177 * 2.09165f) * _e484) - (0.9354144f * _e485));
                    } else {
                        phi_1303_ = _e484;
                    }
                    let _e491 = phi_1303_;
                    let _e492 = select(_e485, _e484, _e266);
                    if _e274 {
                        let _e496 = (((_e177 * 2.04939f) * _e491) - (0.9797959f * _e492));
                        let _e498 = ((_e496 * _e166) * -0.1308997f);
                        let _e500 = ((_e183 + _e185) + 320u);
                        if (_e500 < _e123) {
                        } else {
                            break;
                        }
                        let _e504 = coefs.member[_e500];
                        let _e508 = (_e500 + _e190);
                        if (_e508 < _e123) {
                        } else {
                            break;
                        }
                        let _e511 = coefs.member[_e508];
                        let _e515 = (_e500 + _e196);
                        if (_e515 < _e123) {
                        } else {
                            break;
                        }
                        let _e518 = coefs.member[_e515];
                        let _e522 = ((_e496 * _e171) * -0.1308997f);
                        let _e525 = ((_e183 + (_e184 * 192u)) + 256u);
                        if (_e525 < _e123) {
                        } else {
                            break;
                        }
                        let _e528 = coefs.member[_e525];
                        let _e531 = (_e525 + _e190);
                        if (_e531 < _e123) {
                        } else {
                            break;
                        }
                        let _e534 = coefs.member[_e531];
                        let _e537 = (_e525 + _e196);
                        if (_e537 < _e123) {
                        } else {
                            break;
                        }
                        let _e540 = coefs.member[_e537];
                        phi_1418_ = array<f32, 3>(((_e482[0] + (_e504 * _e498)) + (_e528 * _e522)), ((_e482[1] + (_e511 * _e498)) + (_e534 * _e522)), ((_e482[2] + (_e518 * _e498)) + (_e540 * _e522)));
                        phi_1420_ = _e496;
                    } else {
                        phi_1418_ = _e482;
                        phi_1420_ = _e491;
                    }
                    let _e545 = phi_1418_;
                    let _e547 = phi_1420_;
                    let _e548 = select(_e492, _e491, _e274);
                    if _e307 {
                        phi_1537_ = (((_e177 * 2.0310097f) * _e547) - (0.9910312f * _e548));
                    } else {
                        phi_1537_ = _e547;
                    }
                    let _e554 = phi_1537_;
                    let _e555 = select(_e548, _e547, _e307);
                    if _e315 {
                        let _e559 = (((_e177 * 2.021315f) * _e554) - (0.9952267f * _e555));
                        let _e561 = ((_e559 * _e166) * 0.049087387f);
                        let _e564 = ((_e183 + (_e184 * 192u)) + 640u);
                        if (_e564 < _e123) {
                        } else {
                            break;
                        }
                        let _e568 = coefs.member[_e564];
                        let _e572 = (_e564 + _e190);
                        if (_e572 < _e123) {
                        } else {
                            break;
                        }
                        let _e575 = coefs.member[_e572];
                        let _e579 = (_e564 + _e196);
                        if (_e579 < _e123) {
                        } else {
                            break;
                        }
                        let _e582 = coefs.member[_e579];
                        let _e586 = ((_e559 * _e171) * 0.049087387f);
                        let _e588 = ((_e183 + _e185) + 640u);
                        if (_e588 < _e123) {
                        } else {
                            break;
                        }
                        let _e591 = coefs.member[_e588];
                        let _e594 = (_e588 + _e190);
                        if (_e594 < _e123) {
                        } else {
                            break;
                        }
                        let _e597 = coefs.member[_e594];
                        let _e600 = (_e588 + _e196);
                        if (_e600 < _e123) {
                        } else {
                            break;
                        }
                        let _e603 = coefs.member[_e600];
                        phi_1652_ = array<f32, 3>(((_e545[0] + (_e568 * _e561)) + (_e591 * _e586)), ((_e545[1] + (_e575 * _e561)) + (_e597 * _e586)), ((_e545[2] + (_e582 * _e561)) + (_e603 * _e586)));
                        phi_1654_ = _e559;
                    } else {
                        phi_1652_ = _e545;
                        phi_1654_ = _e554;
                    }
                    let _e608 = phi_1652_;
                    let _e610 = phi_1654_;
                    let _e611 = select(_e555, _e554, _e315);
                    if _e350 {
                        phi_1771_ = (((_e177 * 2.0155644f) * _e610) - (0.9971551f * _e611));
                    } else {
                        phi_1771_ = _e610;
                    }
                    let _e617 = phi_1771_;
                    if _e358 {
                        let _e622 = (((_e177 * 2.0118694f) * _e617) - (0.9981668f * select(_e611, _e610, _e350)));
                        let _e624 = ((_e622 * _e166) * -0.024543693f);
                        let _e626 = ((_e183 + _e185) + 1152u);
                        if (_e626 < _e123) {
                        } else {
                            break;
                        }
                        let _e630 = coefs.member[_e626];
                        let _e634 = (_e626 + _e190);
                        if (_e634 < _e123) {
                        } else {
                            break;
                        }
                        let _e637 = coefs.member[_e634];
                        let _e641 = (_e626 + _e196);
                        if (_e641 < _e123) {
                        } else {
                            break;
                        }
                        let _e644 = coefs.member[_e641];
                        let _e648 = ((_e622 * _e171) * -0.024543693f);
                        let _e651 = ((_e183 + (_e184 * 192u)) + 1088u);
                        if (_e651 < _e123) {
                        } else {
                            break;
                        }
                        let _e654 = coefs.member[_e651];
                        let _e657 = (_e651 + _e190);
                        if (_e657 < _e123) {
                        } else {
                            break;
                        }
                        let _e660 = coefs.member[_e657];
                        let _e663 = (_e651 + _e196);
                        if (_e663 < _e123) {
                        } else {
                            break;
                        }
                        let _e666 = coefs.member[_e663];
                        phi_1886_ = array<f32, 3>(((_e608[0] + (_e630 * _e624)) + (_e654 * _e648)), ((_e608[1] + (_e637 * _e624)) + (_e660 * _e648)), ((_e608[2] + (_e644 * _e624)) + (_e666 * _e648)));
                    } else {
                        phi_1886_ = _e608;
                    }
                    let _e671 = phi_1886_;
                    phi_2004_ = _e671;
                } else {
                    phi_2004_ = _e387;
                }
                let _e673 = phi_2004_;
                if _e231 {
                    let _e676 = ((_e166 * _e166) - (_e171 * _e171));
                    let _e678 = (_e166 * (_e171 + _e171));
                    if _e231 {
                        let _e679 = (_e676 * 0.4290428f);
                        let _e680 = (_e183 + 128u);
                        if (_e680 < _e123) {
                        } else {
                            break;
                        }
                        let _e684 = coefs.member[_e680];
                        let _e688 = (_e680 + _e190);
                        if (_e688 < _e123) {
                        } else {
                            break;
                        }
                        let _e691 = coefs.member[_e688];
                        let _e695 = (_e680 + _e196);
                        if (_e695 < _e123) {
                        } else {
                            break;
                        }
                        let _e698 = coefs.member[_e695];
                        let _e701 = (_e678 * 0.4290428f);
                        let _e702 = (_e183 + 64u);
                        if (_e702 < _e123) {
                        } else {
                            break;
                        }
                        let _e705 = coefs.member[_e702];
                        let _e708 = (_e702 + _e190);
                        if (_e708 < _e123) {
                        } else {
                            break;
                        }
                        let _e711 = coefs.member[_e708];
                        let _e714 = (_e702 + _e196);
                        if (_e714 < _e123) {
                        } else {
                            break;
                        }
                        let _e717 = coefs.member[_e714];
                        phi_2125_ = array<f32, 3>(((_e673[0] + (_e684 * _e679)) + (_e705 * _e701)), ((_e673[1] + (_e691 * _e679)) + (_e711 * _e701)), ((_e673[2] + (_e698 * _e679)) + (_e717 * _e701)));
                    } else {
                        phi_2125_ = _e673;
                    }
                    let _e722 = phi_2125_;
                    if _e266 {
                        phi_2240_ = (_e177 * 1.4453057f);
                    } else {
                        phi_2240_ = 0.54627424f;
                    }
                    let _e725 = phi_2240_;
                    let _e726 = select(0f, 0.54627424f, _e266);
                    if _e274 {
                        let _e730 = (((_e177 * 2.291288f) * _e725) - (0.8660254f * _e726));
                        let _e732 = ((_e730 * _e676) * -0.1308997f);
                        let _e734 = (_e183 + (_e184 * 128u));
                        let _e735 = (_e734 + 320u);
                        if (_e735 < _e123) {
                        } else {
                            break;
                        }
                        let _e739 = coefs.member[_e735];
                        let _e743 = (_e735 + _e190);
                        if (_e743 < _e123) {
                        } else {
                            break;
                        }
                        let _e746 = coefs.member[_e743];
                        let _e750 = (_e735 + _e196);
                        if (_e750 < _e123) {
                        } else {
                            break;
                        }
                        let _e753 = coefs.member[_e750];
                        let _e757 = ((_e730 * _e678) * -0.1308997f);
                        let _e758 = (_e734 + 256u);
                        if (_e758 < _e123) {
                        } else {
                            break;
                        }
                        let _e761 = coefs.member[_e758];
                        let _e764 = (_e758 + _e190);
                        if (_e764 < _e123) {
                        } else {
                            break;
                        }
                        let _e767 = coefs.member[_e764];
                        let _e770 = (_e758 + _e196);
                        if (_e770 < _e123) {
                        } else {
                            break;
                        }
                        let _e773 = coefs.member[_e770];
                        phi_2355_ = array<f32, 3>(((_e722[0] + (_e739 * _e732)) + (_e761 * _e757)), ((_e722[1] + (_e746 * _e732)) + (_e767 * _e757)), ((_e722[2] + (_e753 * _e732)) + (_e773 * _e757)));
                        phi_2357_ = _e730;
                    } else {
                        phi_2355_ = _e722;
                        phi_2357_ = _e725;
                    }
                    let _e778 = phi_2355_;
                    let _e780 = phi_2357_;
                    let _e781 = select(_e726, _e725, _e274);
                    if _e307 {
                        phi_2474_ = (((_e177 * 2.1712406f) * _e780) - (0.9476071f * _e781));
                    } else {
                        phi_2474_ = _e780;
                    }
                    let _e787 = phi_2474_;
                    let _e788 = select(_e781, _e780, _e307);
                    if _e315 {
                        let _e792 = (((_e177 * 2.113942f) * _e787) - (0.9736101f * _e788));
                        let _e794 = ((_e792 * _e676) * 0.049087387f);
                        let _e795 = (_e183 + 704u);
                        if (_e795 < _e123) {
                        } else {
                            break;
                        }
                        let _e799 = coefs.member[_e795];
                        let _e803 = (_e795 + _e190);
                        if (_e803 < _e123) {
                        } else {
                            break;
                        }
                        let _e806 = coefs.member[_e803];
                        let _e810 = (_e795 + _e196);
                        if (_e810 < _e123) {
                        } else {
                            break;
                        }
                        let _e813 = coefs.member[_e810];
                        let _e817 = ((_e792 * _e678) * 0.049087387f);
                        let _e818 = (_e183 + 640u);
                        if (_e818 < _e123) {
                        } else {
                            break;
                        }
                        let _e821 = coefs.member[_e818];
                        let _e824 = (_e818 + _e190);
                        if (_e824 < _e123) {
                        } else {
                            break;
                        }
                        let _e827 = coefs.member[_e824];
                        let _e830 = (_e818 + _e196);
                        if (_e830 < _e123) {
                        } else {
                            break;
                        }
                        let _e833 = coefs.member[_e830];
                        phi_2589_ = array<f32, 3>(((_e778[0] + (_e799 * _e794)) + (_e821 * _e817)), ((_e778[1] + (_e806 * _e794)) + (_e827 * _e817)), ((_e778[2] + (_e813 * _e794)) + (_e833 * _e817)));
                        phi_2591_ = _e792;
                    } else {
                        phi_2589_ = _e778;
                        phi_2591_ = _e787;
                    }
                    let _e838 = phi_2589_;
                    let _e840 = phi_2591_;
                    let _e841 = select(_e788, _e787, _e315);
                    if _e350 {
                        phi_2708_ = (((_e177 * 2.081666f) * _e840) - (0.9847319f * _e841));
                    } else {
                        phi_2708_ = _e840;
                    }
                    let _e847 = phi_2708_;
                    if _e358 {
                        let _e852 = (((_e177 * 2.0615528f) * _e847) - (0.9903379f * select(_e841, _e840, _e350)));
                        let _e854 = ((_e852 * _e676) * -0.024543693f);
                        let _e856 = (_e183 + (_e184 * 128u));
                        let _e857 = (_e856 + 1152u);
                        if (_e857 < _e123) {
                        } else {
                            break;
                        }
                        let _e861 = coefs.member[_e857];
                        let _e865 = (_e857 + _e190);
                        if (_e865 < _e123) {
                        } else {
                            break;
                        }
                        let _e868 = coefs.member[_e865];
                        let _e872 = (_e857 + _e196);
                        if (_e872 < _e123) {
                        } else {
                            break;
                        }
                        let _e875 = coefs.member[_e872];
                        let _e879 = ((_e852 * _e678) * -0.024543693f);
                        let _e880 = (_e856 + 1088u);
                        if (_e880 < _e123) {
                        } else {
                            break;
                        }
                        let _e883 = coefs.member[_e880];
                        let _e886 = (_e880 + _e190);
                        if (_e886 < _e123) {
                        } else {
                            break;
                        }
                        let _e889 = coefs.member[_e886];
                        let _e892 = (_e880 + _e196);
                        if (_e892 < _e123) {
                        } else {
                            break;
                        }
                        let _e895 = coefs.member[_e892];
                        phi_2823_ = array<f32, 3>(((_e838[0] + (_e861 * _e854)) + (_e883 * _e879)), ((_e838[1] + (_e868 * _e854)) + (_e889 * _e879)), ((_e838[2] + (_e875 * _e854)) + (_e895 * _e879)));
                    } else {
                        phi_2823_ = _e838;
                    }
                    let _e900 = phi_2823_;
                    phi_2941_ = _e900;
                    phi_2942_ = _e678;
                    phi_2943_ = _e676;
                } else {
                    phi_2941_ = _e673;
                    phi_2942_ = _e171;
                    phi_2943_ = _e166;
                }
                let _e902 = phi_2941_;
                let _e904 = phi_2942_;
                let _e906 = phi_2943_;
                if _e266 {
                    let _e909 = ((_e166 * _e906) - (_e171 * _e904));
                    let _e912 = ((_e166 * _e904) + (_e171 * _e906));
                    if _e274 {
                        let _e913 = (_e177 * 1.7701309f);
                        let _e915 = ((_e913 * _e909) * -0.1308997f);
                        let _e918 = ((_e183 + (_e184 * 192u)) + 320u);
                        if (_e918 < _e123) {
                        } else {
                            break;
                        }
                        let _e922 = coefs.member[_e918];
                        let _e926 = (_e918 + _e190);
                        if (_e926 < _e123) {
                        } else {
                            break;
                        }
                        let _e929 = coefs.member[_e926];
                        let _e933 = (_e918 + _e196);
                        if (_e933 < _e123) {
                        } else {
                            break;
                        }
                        let _e936 = coefs.member[_e933];
                        let _e940 = ((_e913 * _e912) * -0.1308997f);
                        let _e942 = ((_e183 + _e185) + 256u);
                        if (_e942 < _e123) {
                        } else {
                            break;
                        }
                        let _e945 = coefs.member[_e942];
                        let _e948 = (_e942 + _e190);
                        if (_e948 < _e123) {
                        } else {
                            break;
                        }
                        let _e951 = coefs.member[_e948];
                        let _e954 = (_e942 + _e196);
                        if (_e954 < _e123) {
                        } else {
                            break;
                        }
                        let _e957 = coefs.member[_e954];
                        phi_3177_ = array<f32, 3>(((_e902[0] + (_e922 * _e915)) + (_e945 * _e940)), ((_e902[1] + (_e929 * _e915)) + (_e951 * _e940)), ((_e902[2] + (_e936 * _e915)) + (_e957 * _e940)));
                        phi_3179_ = _e913;
                    } else {
                        phi_3177_ = _e902;
                        phi_3179_ = 0.5900436f;
                    }
                    let _e962 = phi_3177_;
                    let _e964 = phi_3179_;
                    let _e965 = select(0f, 0.5900436f, _e274);
                    if _e307 {
                        phi_3296_ = (((_e177 * 2.4874685f) * _e964) - (0.8291562f * _e965));
                    } else {
                        phi_3296_ = _e964;
                    }
                    let _e971 = phi_3296_;
                    let _e972 = select(_e965, _e964, _e307);
                    if _e315 {
                        let _e976 = (((_e177 * 2.3013682f) * _e971) - (0.9251849f * _e972));
                        let _e978 = ((_e976 * _e909) * 0.049087387f);
                        let _e980 = ((_e183 + _e185) + 704u);
                        if (_e980 < _e123) {
                        } else {
                            break;
                        }
                        let _e984 = coefs.member[_e980];
                        let _e988 = (_e980 + _e190);
                        if (_e988 < _e123) {
                        } else {
                            break;
                        }
                        let _e991 = coefs.member[_e988];
                        let _e995 = (_e980 + _e196);
                        if (_e995 < _e123) {
                        } else {
                            break;
                        }
                        let _e998 = coefs.member[_e995];
                        let _e1002 = ((_e976 * _e912) * 0.049087387f);
                        let _e1005 = ((_e183 + (_e184 * 192u)) + 576u);
                        if (_e1005 < _e123) {
                        } else {
                            break;
                        }
                        let _e1008 = coefs.member[_e1005];
                        let _e1011 = (_e1005 + _e190);
                        if (_e1011 < _e123) {
                        } else {
                            break;
                        }
                        let _e1014 = coefs.member[_e1011];
                        let _e1017 = (_e1005 + _e196);
                        if (_e1017 < _e123) {
                        } else {
                            break;
                        }
                        let _e1020 = coefs.member[_e1017];
                        phi_3411_ = array<f32, 3>(((_e962[0] + (_e984 * _e978)) + (_e1008 * _e1002)), ((_e962[1] + (_e991 * _e978)) + (_e1014 * _e1002)), ((_e962[2] + (_e998 * _e978)) + (_e1020 * _e1002)));
                        phi_3413_ = _e976;
                    } else {
                        phi_3411_ = _e962;
                        phi_3413_ = _e971;
                    }
                    let _e1025 = phi_3411_;
                    let _e1027 = phi_3413_;
                    let _e1028 = select(_e972, _e971, _e315);
                    if _e350 {
                        phi_3530_ = (((_e177 * 2.20794f) * _e1027) - (0.9594032f * _e1028));
                    } else {
                        phi_3530_ = _e1027;
                    }
                    let _e1034 = phi_3530_;
                    if _e358 {
                        let _e1039 = (((_e177 * 2.1532216f) * _e1034) - (0.9752174f * select(_e1028, _e1027, _e350)));
                        let _e1041 = ((_e1039 * _e909) * -0.024543693f);
                        let _e1044 = ((_e183 + (_e184 * 192u)) + 1152u);
                        if (_e1044 < _e123) {
                        } else {
                            break;
                        }
                        let _e1048 = coefs.member[_e1044];
                        let _e1052 = (_e1044 + _e190);
                        if (_e1052 < _e123) {
                        } else {
                            break;
                        }
                        let _e1055 = coefs.member[_e1052];
                        let _e1059 = (_e1044 + _e196);
                        if (_e1059 < _e123) {
                        } else {
                            break;
                        }
                        let _e1062 = coefs.member[_e1059];
                        let _e1066 = ((_e1039 * _e912) * -0.024543693f);
                        let _e1068 = ((_e183 + _e185) + 1088u);
                        if (_e1068 < _e123) {
                        } else {
                            break;
                        }
                        let _e1071 = coefs.member[_e1068];
                        let _e1074 = (_e1068 + _e190);
                        if (_e1074 < _e123) {
                        } else {
                            break;
                        }
                        let _e1077 = coefs.member[_e1074];
                        let _e1080 = (_e1068 + _e196);
                        if (_e1080 < _e123) {
                        } else {
                            break;
                        }
                        let _e1083 = coefs.member[_e1080];
                        phi_3645_ = array<f32, 3>(((_e1025[0] + (_e1048 * _e1041)) + (_e1071 * _e1066)), ((_e1025[1] + (_e1055 * _e1041)) + (_e1077 * _e1066)), ((_e1025[2] + (_e1062 * _e1041)) + (_e1083 * _e1066)));
                    } else {
                        phi_3645_ = _e1025;
                    }
                    let _e1088 = phi_3645_;
                    phi_3763_ = _e1088;
                    phi_3764_ = _e912;
                    phi_3765_ = _e909;
                } else {
                    phi_3763_ = _e902;
                    phi_3764_ = _e904;
                    phi_3765_ = _e906;
                }
                let _e1090 = phi_3763_;
                let _e1092 = phi_3764_;
                let _e1094 = phi_3765_;
                if _e274 {
                    let _e1097 = ((_e166 * _e1094) - (_e171 * _e1092));
                    let _e1100 = ((_e166 * _e1092) + (_e171 * _e1094));
                    if _e274 {
                        let _e1101 = (_e1097 * -0.081921704f);
                        let _e1102 = (_e183 + 384u);
                        if (_e1102 < _e123) {
                        } else {
                            break;
                        }
                        let _e1106 = coefs.member[_e1102];
                        let _e1110 = (_e1102 + _e190);
                        if (_e1110 < _e123) {
                        } else {
                            break;
                        }
                        let _e1113 = coefs.member[_e1110];
                        let _e1117 = (_e1102 + _e196);
                        if (_e1117 < _e123) {
                        } else {
                            break;
                        }
                        let _e1120 = coefs.member[_e1117];
                        let _e1123 = (_e1100 * -0.081921704f);
                        let _e1124 = (_e183 + 256u);
                        if (_e1124 < _e123) {
                        } else {
                            break;
                        }
                        let _e1127 = coefs.member[_e1124];
                        let _e1130 = (_e1124 + _e190);
                        if (_e1130 < _e123) {
                        } else {
                            break;
                        }
                        let _e1133 = coefs.member[_e1130];
                        let _e1136 = (_e1124 + _e196);
                        if (_e1136 < _e123) {
                        } else {
                            break;
                        }
                        let _e1139 = coefs.member[_e1136];
                        phi_3886_ = array<f32, 3>(((_e1090[0] + (_e1106 * _e1101)) + (_e1127 * _e1123)), ((_e1090[1] + (_e1113 * _e1101)) + (_e1133 * _e1123)), ((_e1090[2] + (_e1120 * _e1101)) + (_e1139 * _e1123)));
                    } else {
                        phi_3886_ = _e1090;
                    }
                    let _e1144 = phi_3886_;
                    if _e307 {
                        phi_4001_ = (_e177 * 2.0756624f);
                    } else {
                        phi_4001_ = 0.6258357f;
                    }
                    let _e1147 = phi_4001_;
                    let _e1148 = select(0f, 0.6258357f, _e307);
                    if _e315 {
                        let _e1152 = (((_e177 * 2.6739483f) * _e1147) - (0.8062258f * _e1148));
                        let _e1154 = ((_e1152 * _e1097) * 0.049087387f);
                        let _e1156 = (_e183 + (_e184 * 128u));
                        let _e1157 = (_e1156 + 704u);
                        if (_e1157 < _e123) {
                        } else {
                            break;
                        }
                        let _e1161 = coefs.member[_e1157];
                        let _e1165 = (_e1157 + _e190);
                        if (_e1165 < _e123) {
                        } else {
                            break;
                        }
                        let _e1168 = coefs.member[_e1165];
                        let _e1172 = (_e1157 + _e196);
                        if (_e1172 < _e123) {
                        } else {
                            break;
                        }
                        let _e1175 = coefs.member[_e1172];
                        let _e1179 = ((_e1152 * _e1100) * 0.049087387f);
                        let _e1180 = (_e1156 + 576u);
                        if (_e1180 < _e123) {
                        } else {
                            break;
                        }
                        let _e1183 = coefs.member[_e1180];
                        let _e1186 = (_e1180 + _e190);
                        if (_e1186 < _e123) {
                        } else {
                            break;
                        }
                        let _e1189 = coefs.member[_e1186];
                        let _e1192 = (_e1180 + _e196);
                        if (_e1192 < _e123) {
                        } else {
                            break;
                        }
                        let _e1195 = coefs.member[_e1192];
                        phi_4116_ = array<f32, 3>(((_e1144[0] + (_e1161 * _e1154)) + (_e1183 * _e1179)), ((_e1144[1] + (_e1168 * _e1154)) + (_e1189 * _e1179)), ((_e1144[2] + (_e1175 * _e1154)) + (_e1195 * _e1179)));
                        phi_4118_ = _e1152;
                    } else {
                        phi_4116_ = _e1144;
                        phi_4118_ = _e1147;
                    }
                    let _e1200 = phi_4116_;
                    let _e1202 = phi_4118_;
                    let _e1203 = select(_e1148, _e1147, _e315);
                    if _e350 {
                        phi_4235_ = (((_e177 * 2.4308622f) * _e1202) - (0.90909094f * _e1203));
                    } else {
                        phi_4235_ = _e1202;
                    }
                    let _e1209 = phi_4235_;
                    if _e358 {
                        let _e1214 = (((_e177 * 2.304886f) * _e1209) - (0.9481764f * select(_e1203, _e1202, _e350)));
                        let _e1216 = ((_e1214 * _e1097) * -0.024543693f);
                        let _e1217 = (_e183 + 1216u);
                        if (_e1217 < _e123) {
                        } else {
                            break;
                        }
                        let _e1221 = coefs.member[_e1217];
                        let _e1225 = (_e1217 + _e190);
                        if (_e1225 < _e123) {
                        } else {
                            break;
                        }
                        let _e1228 = coefs.member[_e1225];
                        let _e1232 = (_e1217 + _e196);
                        if (_e1232 < _e123) {
                        } else {
                            break;
                        }
                        let _e1235 = coefs.member[_e1232];
                        let _e1239 = ((_e1214 * _e1100) * -0.024543693f);
                        let _e1240 = (_e183 + 1088u);
                        if (_e1240 < _e123) {
                        } else {
                            break;
                        }
                        let _e1243 = coefs.member[_e1240];
                        let _e1246 = (_e1240 + _e190);
                        if (_e1246 < _e123) {
                        } else {
                            break;
                        }
                        let _e1249 = coefs.member[_e1246];
                        let _e1252 = (_e1240 + _e196);
                        if (_e1252 < _e123) {
                        } else {
                            break;
                        }
                        let _e1255 = coefs.member[_e1252];
                        phi_4350_ = array<f32, 3>(((_e1200[0] + (_e1221 * _e1216)) + (_e1243 * _e1239)), ((_e1200[1] + (_e1228 * _e1216)) + (_e1249 * _e1239)), ((_e1200[2] + (_e1235 * _e1216)) + (_e1255 * _e1239)));
                    } else {
                        phi_4350_ = _e1200;
                    }
                    let _e1260 = phi_4350_;
                    phi_4468_ = _e1260;
                    phi_4469_ = _e1100;
                    phi_4470_ = _e1097;
                } else {
                    phi_4468_ = _e1090;
                    phi_4469_ = _e1092;
                    phi_4470_ = _e1094;
                }
                let _e1262 = phi_4468_;
                let _e1264 = phi_4469_;
                let _e1266 = phi_4470_;
                if _e307 {
                    let _e1269 = ((_e166 * _e1266) - (_e171 * _e1264));
                    let _e1272 = ((_e166 * _e1264) + (_e171 * _e1266));
                    if _e315 {
                        let _e1273 = (_e177 * 2.3666193f);
                        let _e1275 = ((_e1273 * _e1269) * 0.049087387f);
                        let _e1278 = ((_e183 + (_e184 * 192u)) + 704u);
                        if (_e1278 < _e123) {
                        } else {
                            break;
                        }
                        let _e1282 = coefs.member[_e1278];
                        let _e1286 = (_e1278 + _e190);
                        if (_e1286 < _e123) {
                        } else {
                            break;
                        }
                        let _e1289 = coefs.member[_e1286];
                        let _e1293 = (_e1278 + _e196);
                        if (_e1293 < _e123) {
                        } else {
                            break;
                        }
                        let _e1296 = coefs.member[_e1293];
                        let _e1300 = ((_e1273 * _e1272) * 0.049087387f);
                        let _e1302 = ((_e183 + _e185) + 576u);
                        if (_e1302 < _e123) {
                        } else {
                            break;
                        }
                        let _e1305 = coefs.member[_e1302];
                        let _e1308 = (_e1302 + _e190);
                        if (_e1308 < _e123) {
                        } else {
                            break;
                        }
                        let _e1311 = coefs.member[_e1308];
                        let _e1314 = (_e1302 + _e196);
                        if (_e1314 < _e123) {
                        } else {
                            break;
                        }
                        let _e1317 = coefs.member[_e1314];
                        phi_4704_ = array<f32, 3>(((_e1262[0] + (_e1282 * _e1275)) + (_e1305 * _e1300)), ((_e1262[1] + (_e1289 * _e1275)) + (_e1311 * _e1300)), ((_e1262[2] + (_e1296 * _e1275)) + (_e1317 * _e1300)));
                        phi_4706_ = _e1273;
                    } else {
                        phi_4704_ = _e1262;
                        phi_4706_ = 0.6563821f;
                    }
                    let _e1322 = phi_4704_;
                    let _e1324 = phi_4706_;
                    let _e1325 = select(0f, 0.6563821f, _e315);
                    if _e350 {
                        phi_4823_ = (((_e177 * 2.8504386f) * _e1324) - (0.7905694f * _e1325));
                    } else {
                        phi_4823_ = _e1324;
                    }
                    let _e1331 = phi_4823_;
                    if _e358 {
                        let _e1336 = (((_e177 * 2.5570416f) * _e1331) - (0.8970695f * select(_e1325, _e1324, _e350)));
                        let _e1338 = ((_e1336 * _e1269) * -0.024543693f);
                        let _e1340 = ((_e183 + _e185) + 1216u);
                        if (_e1340 < _e123) {
                        } else {
                            break;
                        }
                        let _e1344 = coefs.member[_e1340];
                        let _e1348 = (_e1340 + _e190);
                        if (_e1348 < _e123) {
                        } else {
                            break;
                        }
                        let _e1351 = coefs.member[_e1348];
                        let _e1355 = (_e1340 + _e196);
                        if (_e1355 < _e123) {
                        } else {
                            break;
                        }
                        let _e1358 = coefs.member[_e1355];
                        let _e1362 = ((_e1336 * _e1272) * -0.024543693f);
                        let _e1365 = ((_e183 + (_e184 * 192u)) + 1024u);
                        if (_e1365 < _e123) {
                        } else {
                            break;
                        }
                        let _e1368 = coefs.member[_e1365];
                        let _e1371 = (_e1365 + _e190);
                        if (_e1371 < _e123) {
                        } else {
                            break;
                        }
                        let _e1374 = coefs.member[_e1371];
                        let _e1377 = (_e1365 + _e196);
                        if (_e1377 < _e123) {
                        } else {
                            break;
                        }
                        let _e1380 = coefs.member[_e1377];
                        phi_4938_ = array<f32, 3>(((_e1322[0] + (_e1344 * _e1338)) + (_e1368 * _e1362)), ((_e1322[1] + (_e1351 * _e1338)) + (_e1374 * _e1362)), ((_e1322[2] + (_e1358 * _e1338)) + (_e1380 * _e1362)));
                    } else {
                        phi_4938_ = _e1322;
                    }
                    let _e1385 = phi_4938_;
                    phi_5056_ = _e1385;
                    phi_5057_ = _e1272;
                    phi_5058_ = _e1269;
                } else {
                    phi_5056_ = _e1262;
                    phi_5057_ = _e1264;
                    phi_5058_ = _e1266;
                }
                let _e1387 = phi_5056_;
                let _e1389 = phi_5057_;
                let _e1391 = phi_5058_;
                if _e315 {
                    let _e1394 = ((_e166 * _e1391) - (_e171 * _e1389));
                    let _e1397 = ((_e166 * _e1389) + (_e171 * _e1391));
                    if _e315 {
                        let _e1398 = (_e1394 * 0.033535723f);
                        let _e1399 = (_e183 + 768u);
                        if (_e1399 < _e123) {
                        } else {
                            break;
                        }
                        let _e1403 = coefs.member[_e1399];
                        let _e1407 = (_e1399 + _e190);
                        if (_e1407 < _e123) {
                        } else {
                            break;
                        }
                        let _e1410 = coefs.member[_e1407];
                        let _e1414 = (_e1399 + _e196);
                        if (_e1414 < _e123) {
                        } else {
                            break;
                        }
                        let _e1417 = coefs.member[_e1414];
                        let _e1420 = (_e1397 * 0.033535723f);
                        let _e1421 = (_e183 + 576u);
                        if (_e1421 < _e123) {
                        } else {
                            break;
                        }
                        let _e1424 = coefs.member[_e1421];
                        let _e1427 = (_e1421 + _e190);
                        if (_e1427 < _e123) {
                        } else {
                            break;
                        }
                        let _e1430 = coefs.member[_e1427];
                        let _e1433 = (_e1421 + _e196);
                        if (_e1433 < _e123) {
                        } else {
                            break;
                        }
                        let _e1436 = coefs.member[_e1433];
                        phi_5179_ = array<f32, 3>(((_e1387[0] + (_e1403 * _e1398)) + (_e1424 * _e1420)), ((_e1387[1] + (_e1410 * _e1398)) + (_e1430 * _e1420)), ((_e1387[2] + (_e1417 * _e1398)) + (_e1436 * _e1420)));
                    } else {
                        phi_5179_ = _e1387;
                    }
                    let _e1441 = phi_5179_;
                    if _e350 {
                        phi_5294_ = (_e177 * 2.6459606f);
                    } else {
                        phi_5294_ = 0.6831841f;
                    }
                    let _e1444 = phi_5294_;
                    if _e358 {
                        let _e1449 = (((_e177 * 3.0178044f) * _e1444) - (0.7791937f * select(0f, 0.6831841f, _e350)));
                        let _e1451 = ((_e1449 * _e1394) * -0.024543693f);
                        let _e1453 = (_e183 + (_e184 * 128u));
                        let _e1454 = (_e1453 + 1216u);
                        if (_e1454 < _e123) {
                        } else {
                            break;
                        }
                        let _e1458 = coefs.member[_e1454];
                        let _e1462 = (_e1454 + _e190);
                        if (_e1462 < _e123) {
                        } else {
                            break;
                        }
                        let _e1465 = coefs.member[_e1462];
                        let _e1469 = (_e1454 + _e196);
                        if (_e1469 < _e123) {
                        } else {
                            break;
                        }
                        let _e1472 = coefs.member[_e1469];
                        let _e1476 = ((_e1449 * _e1397) * -0.024543693f);
                        let _e1477 = (_e1453 + 1024u);
                        if (_e1477 < _e123) {
                        } else {
                            break;
                        }
                        let _e1480 = coefs.member[_e1477];
                        let _e1483 = (_e1477 + _e190);
                        if (_e1483 < _e123) {
                        } else {
                            break;
                        }
                        let _e1486 = coefs.member[_e1483];
                        let _e1489 = (_e1477 + _e196);
                        if (_e1489 < _e123) {
                        } else {
                            break;
                        }
                        let _e1492 = coefs.member[_e1489];
                        phi_5409_ = array<f32, 3>(((_e1441[0] + (_e1458 * _e1451)) + (_e1480 * _e1476)), ((_e1441[1] + (_e1465 * _e1451)) + (_e1486 * _e1476)), ((_e1441[2] + (_e1472 * _e1451)) + (_e1492 * _e1476)));
                    } else {
                        phi_5409_ = _e1441;
                    }
                    let _e1497 = phi_5409_;
                    phi_5527_ = _e1497;
                    phi_5528_ = _e1397;
                    phi_5529_ = _e1394;
                } else {
                    phi_5527_ = _e1387;
                    phi_5528_ = _e1389;
                    phi_5529_ = _e1391;
                }
                let _e1499 = phi_5527_;
                let _e1501 = phi_5528_;
                let _e1503 = phi_5529_;
                if _e350 {
                    let _e1506 = ((_e166 * _e1503) - (_e171 * _e1501));
                    let _e1509 = ((_e166 * _e1501) + (_e171 * _e1503));
                    if _e358 {
                        let _e1510 = (_e177 * 2.9157066f);
                        let _e1512 = ((_e1510 * _e1506) * -0.024543693f);
                        let _e1515 = ((_e183 + (_e184 * 192u)) + 1216u);
                        if (_e1515 < _e123) {
                        } else {
                            break;
                        }
                        let _e1519 = coefs.member[_e1515];
                        let _e1523 = (_e1515 + _e190);
                        if (_e1523 < _e123) {
                        } else {
                            break;
                        }
                        let _e1526 = coefs.member[_e1523];
                        let _e1530 = (_e1515 + _e196);
                        if (_e1530 < _e123) {
                        } else {
                            break;
                        }
                        let _e1533 = coefs.member[_e1530];
                        let _e1537 = ((_e1510 * _e1509) * -0.024543693f);
                        let _e1539 = ((_e183 + _e185) + 1024u);
                        if (_e1539 < _e123) {
                        } else {
                            break;
                        }
                        let _e1542 = coefs.member[_e1539];
                        let _e1545 = (_e1539 + _e190);
                        if (_e1545 < _e123) {
                        } else {
                            break;
                        }
                        let _e1548 = coefs.member[_e1545];
                        let _e1551 = (_e1539 + _e196);
                        if (_e1551 < _e123) {
                        } else {
                            break;
                        }
                        let _e1554 = coefs.member[_e1551];
                        phi_5763_ = array<f32, 3>(((_e1499[0] + (_e1519 * _e1512)) + (_e1542 * _e1537)), ((_e1499[1] + (_e1526 * _e1512)) + (_e1548 * _e1537)), ((_e1499[2] + (_e1533 * _e1512)) + (_e1554 * _e1537)));
                    } else {
                        phi_5763_ = _e1499;
                    }
                    let _e1559 = phi_5763_;
                    phi_5881_ = _e1559;
                    phi_5882_ = _e1509;
                    phi_5883_ = _e1506;
                } else {
                    phi_5881_ = _e1499;
                    phi_5882_ = _e1501;
                    phi_5883_ = _e1503;
                }
                let _e1561 = phi_5881_;
                let _e1563 = phi_5882_;
                let _e1565 = phi_5883_;
                if _e358 {
                    if _e358 {
                        let _e1572 = (((_e166 * _e1565) - (_e171 * _e1563)) * -0.017890552f);
                        let _e1573 = (_e183 + 1280u);
                        if (_e1573 < _e123) {
                        } else {
                            break;
                        }
                        let _e1577 = coefs.member[_e1573];
                        let _e1581 = (_e1573 + _e190);
                        if (_e1581 < _e123) {
                        } else {
                            break;
                        }
                        let _e1584 = coefs.member[_e1581];
                        let _e1588 = (_e1573 + _e196);
                        if (_e1588 < _e123) {
                        } else {
                            break;
                        }
                        let _e1591 = coefs.member[_e1588];
                        let _e1594 = (((_e166 * _e1563) + (_e171 * _e1565)) * -0.017890552f);
                        let _e1595 = (_e183 + 1024u);
                        if (_e1595 < _e123) {
                        } else {
                            break;
                        }
                        let _e1598 = coefs.member[_e1595];
                        let _e1601 = (_e1595 + _e190);
                        if (_e1601 < _e123) {
                        } else {
                            break;
                        }
                        let _e1604 = coefs.member[_e1601];
                        let _e1607 = (_e1595 + _e196);
                        if (_e1607 < _e123) {
                        } else {
                            break;
                        }
                        let _e1610 = coefs.member[_e1607];
                        phi_6004_ = array<f32, 3>(((_e1561[0] + (_e1577 * _e1572)) + (_e1598 * _e1594)), ((_e1561[1] + (_e1584 * _e1572)) + (_e1604 * _e1594)), ((_e1561[2] + (_e1591 * _e1572)) + (_e1610 * _e1594)));
                    } else {
                        phi_6004_ = _e1561;
                    }
                    let _e1615 = phi_6004_;
                    phi_6118_ = _e1615;
                } else {
                    phi_6118_ = _e1561;
                }
                let _e1617 = phi_6118_;
                let _e1620 = params.member.member_3;
                local = array<f32, 3>((_e1617[0] * _e1620), (_e1617[1] * _e1620), (_e1617[2] * _e1620));
                phi_6258_ = type_13(0u, 3u);
                loop {
                    let _e1629 = phi_6258_;
                    if (_e1629.member < _e1629.member_1) {
                        phi_6259_ = type_13((_e1629.member + 1u), _e1629.member_1);
                        phi_6282_ = type_13(1u, _e1629.member);
                    } else {
                        phi_6259_ = _e1629;
                        phi_6282_ = type_13(0u, type_13().member_1);
                    }
                    let _e1642 = phi_6259_;
                    let _e1644 = phi_6282_;
                    let _e1648 = (bitcast<i32>(_e1644.member) != 0i);
                    if _e1648 {
                        if (_e1644.member_1 < 3u) {
                        } else {
                            phi_6312_ = true;
                            break;
                        }
                        let _e1651 = local[_e1644.member_1];
                        let _e1653 = ((_e1644.member_1 * _e137) + _e141);
                        if (_e1653 < arrayLength((&irradiance.member))) {
                        } else {
                            phi_6312_ = true;
                            break;
                        }
                        irradiance.member[_e1653] = _e1651;
                    }
                    continue;
                    continuing {
                        phi_6258_ = _e1642;
                        phi_6312_ = false;
                        break if !(_e1648);
                    }
                }
                let _e1659 = phi_6312_;
                if _e1659 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_irradiance(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
