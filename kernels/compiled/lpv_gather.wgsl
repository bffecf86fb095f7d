struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
    member_8: array<f32, 3>,
    member_9: f32,
}

struct type_25 {
    member: array<vec4<f32>>,
}

struct type_30 {
    member: array<vec4<f32>, 4>,
    member_1: array<vec4<i32>, 4>,
    member_2: array<vec4<u32>, 4>,
    member_3: u32,
    member_4: u32,
    member_5: f32,
    member_6: f32,
    member_7: f32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
}

struct type_31 {
    member: type_30,
}

struct type_34 {
    member: array<type_18>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_31;
@group(0) @binding(1) 
var<storage> a: type_5;
@group(0) @binding(2) 
var<storage> b: type_5;
@group(0) @binding(3) 
var<storage> c: type_5;
@group(0) @binding(4) 
var<storage> d: type_5;
@group(0) @binding(5) 
var<storage> surfels: type_34;
@group(0) @binding(6) 
var<storage, read_write> irradiance: type_25;

fn function_() {
    var phi_189_: f32;
    var phi_470_: type_11;
    var phi_473_: f32;
    var phi_475_: array<array<f32, 4>, 3>;
    var phi_471_: type_11;
    var phi_498_: type_11;
    var phi_528_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_775_: f32;
    var phi_776_: array<array<f32, 4>, 3>;
    var phi_474_: f32;
    var phi_476_: array<array<f32, 4>, 3>;
    var phi_11334_: bool;
    var local: f32;
    var local_1: f32;
    var phi_782_: f32;
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
    var phi_11399_: bool;
    var phi_2920_: vec4<f32>;
    var phi_11397_: bool;
    var phi_2922_: vec4<f32>;
    var phi_2980_: f32;
    var phi_3261_: type_11;
    var phi_3264_: f32;
    var phi_3266_: array<array<f32, 4>, 3>;
    var phi_3262_: type_11;
    var phi_3289_: type_11;
    var phi_3319_: f32;
    var phi_3324_: f32;
    var phi_3330_: f32;
    var phi_3566_: f32;
    var phi_3567_: array<array<f32, 4>, 3>;
    var phi_3265_: f32;
    var phi_3267_: array<array<f32, 4>, 3>;
    var phi_11371_: bool;
    var local_14: f32;
    var local_15: f32;
    var phi_3573_: f32;
    var local_16: array<array<f32, 4>, 3>;
    var local_17: array<array<f32, 4>, 3>;
    var local_18: array<array<f32, 4>, 3>;
    var local_19: array<array<f32, 4>, 3>;
    var local_20: array<array<f32, 4>, 3>;
    var local_21: array<array<f32, 4>, 3>;
    var local_22: array<array<f32, 4>, 3>;
    var local_23: array<array<f32, 4>, 3>;
    var local_24: array<array<f32, 4>, 3>;
    var local_25: array<array<f32, 4>, 3>;
    var local_26: array<array<f32, 4>, 3>;
    var local_27: array<array<f32, 4>, 3>;
    var phi_11651_: bool;
    var phi_5711_: vec4<f32>;
    var phi_11650_: bool;
    var phi_5712_: vec4<f32>;
    var phi_11649_: bool;
    var phi_5713_: vec4<f32>;
    var phi_5714_: bool;
    var phi_5771_: f32;
    var phi_6052_: type_11;
    var phi_6055_: f32;
    var phi_6057_: array<array<f32, 4>, 3>;
    var phi_6053_: type_11;
    var phi_6080_: type_11;
    var phi_6110_: f32;
    var phi_6115_: f32;
    var phi_6121_: f32;
    var phi_6357_: f32;
    var phi_6358_: array<array<f32, 4>, 3>;
    var phi_6056_: f32;
    var phi_6058_: array<array<f32, 4>, 3>;
    var phi_11623_: bool;
    var local_28: f32;
    var local_29: f32;
    var phi_6364_: f32;
    var local_30: array<array<f32, 4>, 3>;
    var local_31: array<array<f32, 4>, 3>;
    var local_32: array<array<f32, 4>, 3>;
    var local_33: array<array<f32, 4>, 3>;
    var local_34: array<array<f32, 4>, 3>;
    var local_35: array<array<f32, 4>, 3>;
    var local_36: array<array<f32, 4>, 3>;
    var local_37: array<array<f32, 4>, 3>;
    var local_38: array<array<f32, 4>, 3>;
    var local_39: array<array<f32, 4>, 3>;
    var local_40: array<array<f32, 4>, 3>;
    var local_41: array<array<f32, 4>, 3>;
    var phi_11903_: bool;
    var phi_8502_: vec4<f32>;
    var phi_11902_: bool;
    var phi_8503_: vec4<f32>;
    var phi_11901_: bool;
    var phi_8504_: vec4<f32>;
    var phi_8505_: bool;
    var phi_8562_: f32;
    var phi_8843_: type_11;
    var phi_8846_: f32;
    var phi_8848_: array<array<f32, 4>, 3>;
    var phi_8844_: type_11;
    var phi_8871_: type_11;
    var phi_8901_: f32;
    var phi_8906_: f32;
    var phi_8912_: f32;
    var phi_9148_: f32;
    var phi_9149_: array<array<f32, 4>, 3>;
    var phi_8847_: f32;
    var phi_8849_: array<array<f32, 4>, 3>;
    var phi_11875_: bool;
    var local_42: f32;
    var local_43: f32;
    var phi_9155_: f32;
    var local_44: array<array<f32, 4>, 3>;
    var local_45: array<array<f32, 4>, 3>;
    var local_46: array<array<f32, 4>, 3>;
    var local_47: array<array<f32, 4>, 3>;
    var local_48: array<array<f32, 4>, 3>;
    var local_49: array<array<f32, 4>, 3>;
    var local_50: array<array<f32, 4>, 3>;
    var local_51: array<array<f32, 4>, 3>;
    var local_52: array<array<f32, 4>, 3>;
    var local_53: array<array<f32, 4>, 3>;
    var local_54: array<array<f32, 4>, 3>;
    var local_55: array<array<f32, 4>, 3>;
    var phi_11293_: vec4<f32>;
    var phi_11294_: vec4<f32>;
    var phi_11295_: vec4<f32>;
    var phi_11296_: bool;
    var phi_11305_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e46 = gid_1;
            let _e48 = arrayLength((&a.member));
            let _e50 = arrayLength((&b.member));
            let _e52 = arrayLength((&c.member));
            let _e54 = arrayLength((&d.member));
            let _e62 = (_e46.x + (_e46.y * 2097152u));
            let _e63 = (_e62 < arrayLength((&irradiance.member)));
            if _e63 {
                if (_e62 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e67 = surfels.member[_e62];
                if (_e67.member_1 == 4294967295u) {
                    phi_11305_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e72 = params.member.member_3;
                    let _e73 = (0u >= _e72);
                    if _e73 {
                        phi_11397_ = false;
                        phi_2922_ = vec4<f32>();
                    } else {
                        let _e77 = params.member.member[0u];
                        let _e81 = params.member.member_1[0u];
                        let _e85 = params.member.member_2[0u];
                        if (1u == _e72) {
                            phi_189_ = 0f;
                        } else {
                            let _e97 = params.member.member_5;
                            phi_189_ = _e97;
                        }
                        let _e99 = phi_189_;
                        let _e107 = ((_e67.member[0] - _e77.x) / _e77.w);
                        let _e108 = ((_e67.member[1] - _e77.y) / _e77.w);
                        let _e109 = ((_e67.member[2] - _e77.z) / _e77.w);
                        let _e116 = (_e107 - f32(_e81.x));
                        let _e117 = (_e108 - f32(_e81.y));
                        let _e118 = (_e109 - f32(_e81.z));
                        let _e126 = select(_e118, _e117, (_e117 < _e118));
                        let _e128 = select(_e126, _e116, (_e116 < _e126));
                        let _e129 = (f32(_e85.x) - _e116);
                        let _e130 = (f32(_e85.y) - _e117);
                        let _e131 = (f32(_e85.z) - _e118);
                        let _e133 = select(_e131, _e130, (_e130 < _e131));
                        let _e135 = select(_e133, _e129, (_e129 < _e133));
                        let _e140 = (select(_e135, _e128, (_e128 < _e135)) / select(0.001f, _e99, (_e99 > 0.001f)));
                        let _e142 = select(0f, _e140, (_e140 > 0f));
                        let _e144 = select(1f, _e142, (_e142 < 1f));
                        if (_e144 <= 0f) {
                            phi_11399_ = false;
                            phi_2920_ = vec4<f32>(0f, 0f, 0f, 1f);
                        } else {
                            let _e148 = params.member.member_6;
                            let _e149 = (_e85.x + 1u);
                            let _e151 = ((_e85.y + 1u) * _e149);
                            let _e152 = (_e151 + _e149);
                            let _e155 = (_e152 + ((_e85.z + 1u) * _e151));
                            let _e162 = ((_e107 + (_e67.member_2[0] * _e148)) - 0.5f);
                            let _e163 = floor(_e162);
                            let _e165 = (bitcast<i32>(_e85.x) - 1i);
                            let _e173 = (select(0i, select(select(i32(_e163), i32(-2147483648), (_e163 < -2147483600f)), 2147483647i, (_e163 > 2147483500f)), (_e163 == _e163)) - _e81.x);
                            let _e175 = select(0i, _e173, (0i < _e173));
                            let _e177 = select(_e175, _e165, (_e165 < _e175));
                            let _e178 = (_e173 + 1i);
                            let _e180 = select(0i, _e178, (0i < _e178));
                            let _e182 = select(_e180, _e165, (_e165 < _e180));
                            let _e185 = (_e162 - _e163);
                            let _e192 = ((_e108 + (_e67.member_2[1] * _e148)) - 0.5f);
                            let _e193 = floor(_e192);
                            let _e195 = (bitcast<i32>(_e85.y) - 1i);
                            let _e203 = (select(0i, select(select(i32(_e193), i32(-2147483648), (_e193 < -2147483600f)), 2147483647i, (_e193 > 2147483500f)), (_e193 == _e193)) - _e81.y);
                            let _e205 = select(0i, _e203, (0i < _e203));
                            let _e207 = select(_e205, _e195, (_e195 < _e205));
                            let _e208 = (_e203 + 1i);
                            let _e210 = select(0i, _e208, (0i < _e208));
                            let _e212 = select(_e210, _e195, (_e195 < _e210));
                            let _e215 = (_e192 - _e193);
                            let _e222 = ((_e109 + (_e67.member_2[2] * _e148)) - 0.5f);
                            let _e223 = floor(_e222);
                            let _e225 = (bitcast<i32>(_e85.z) - 1i);
                            let _e233 = (select(0i, select(select(i32(_e223), i32(-2147483648), (_e223 < -2147483600f)), 2147483647i, (_e223 > 2147483500f)), (_e223 == _e223)) - _e81.z);
                            let _e235 = select(0i, _e233, (0i < _e233));
                            let _e237 = select(_e235, _e225, (_e225 < _e235));
                            let _e238 = (_e233 + 1i);
                            let _e240 = select(0i, _e238, (0i < _e238));
                            let _e242 = select(_e240, _e225, (_e225 < _e240));
                            let _e245 = (_e222 - _e223);
                            phi_470_ = type_11(0u, 8u);
                            phi_473_ = 0f;
                            phi_475_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                            loop {
                                let _e253 = phi_470_;
                                let _e255 = phi_473_;
                                let _e257 = phi_475_;
                                local = _e255;
                                local_1 = _e255;
                                local_2 = _e257;
                                local_3 = _e257;
                                local_4 = _e257;
                                local_5 = _e257;
                                local_6 = _e257;
                                local_7 = _e257;
                                local_8 = _e257;
                                local_9 = _e257;
                                local_10 = _e257;
                                local_11 = _e257;
                                local_12 = _e257;
                                local_13 = _e257;
                                if (_e253.member < _e253.member_1) {
                                    phi_471_ = type_11((_e253.member + 1u), _e253.member_1);
                                    phi_498_ = type_11(1u, _e253.member);
                                } else {
                                    phi_471_ = _e253;
                                    phi_498_ = type_11(0u, type_11().member_1);
                                }
                                let _e270 = phi_471_;
                                let _e272 = phi_498_;
                                let _e276 = (bitcast<i32>(_e272.member) != 0i);
                                if _e276 {
                                    let _e278 = ((_e272.member_1 & 1u) == 1u);
                                    let _e280 = ((_e272.member_1 & 2u) == 2u);
                                    let _e282 = ((_e272.member_1 & 4u) == 4u);
                                    if _e278 {
                                        phi_528_ = _e185;
                                    } else {
                                        phi_528_ = (1f - _e185);
                                    }
                                    let _e288 = phi_528_;
                                    if _e280 {
                                        phi_533_ = _e215;
                                    } else {
                                        phi_533_ = (1f - _e215);
                                    }
                                    let _e291 = phi_533_;
                                    if _e282 {
                                        phi_539_ = _e245;
                                    } else {
                                        phi_539_ = (1f - _e245);
                                    }
                                    let _e295 = phi_539_;
                                    let _e305 = (((((select((f32((_e177 + _e81.x)) + 0.5f), (f32((_e182 + _e81.x)) + 0.5f), _e278) - _e107) * _e67.member_2[0]) + ((select((f32((_e207 + _e81.y)) + 0.5f), (f32((_e212 + _e81.y)) + 0.5f), _e280) - _e108) * _e67.member_2[1])) + ((select((f32((_e237 + _e81.z)) + 0.5f), (f32((_e242 + _e81.z)) + 0.5f), _e282) - _e109) * _e67.member_2[2])) * 2f);
                                    let _e307 = select(0f, _e305, (_e305 > 0f));
                                    let _e310 = (((_e288 * _e291) * _e295) * select(1f, _e307, (_e307 < 1f)));
                                    if (_e310 > 0f) {
                                        let _e319 = (((_e152 + select(bitcast<u32>(_e177), bitcast<u32>(_e182), _e278)) + (select(bitcast<u32>(_e207), bitcast<u32>(_e212), _e280) * _e149)) + (select(bitcast<u32>(_e237), bitcast<u32>(_e242), _e282) * _e151));
                                        if (_e319 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e324 = a.member[_e319];
                                        let _e329 = (3u * _e155);
                                        let _e330 = (_e329 + _e319);
                                        if (_e330 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e334 = a.member[_e330];
                                        let _e339 = (_e155 * 6u);
                                        let _e340 = (_e339 + _e319);
                                        if (_e340 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e344 = a.member[_e340];
                                        let _e349 = (_e155 * 9u);
                                        let _e350 = (_e349 + _e319);
                                        if (_e350 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e354 = a.member[_e350];
                                        let _e360 = (_e155 + _e319);
                                        if (_e360 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e364 = a.member[_e360];
                                        let _e369 = (_e329 + _e360);
                                        if (_e369 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e373 = a.member[_e369];
                                        let _e378 = (_e339 + _e360);
                                        if (_e378 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e382 = a.member[_e378];
                                        let _e387 = (_e349 + _e360);
                                        if (_e387 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e391 = a.member[_e387];
                                        let _e398 = ((2u * _e155) + _e319);
                                        if (_e398 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e402 = a.member[_e398];
                                        let _e407 = (_e329 + _e398);
                                        if (_e407 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e411 = a.member[_e407];
                                        let _e416 = (_e339 + _e398);
                                        if (_e416 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e420 = a.member[_e416];
                                        let _e425 = (_e349 + _e398);
                                        if (_e425 < _e48) {
                                        } else {
                                            phi_11334_ = true;
                                            break;
                                        }
                                        let _e429 = a.member[_e425];
                                        phi_775_ = (_e255 + _e310);
                                        phi_776_ = array<array<f32, 4>, 3>(array<f32, 4>((_e257[0][0] + (_e324 * _e310)), (_e257[0][1] + (_e334 * _e310)), (_e257[0][2] + (_e344 * _e310)), (_e257[0][3] + (_e354 * _e310))), array<f32, 4>((_e257[1][0] + (_e364 * _e310)), (_e257[1][1] + (_e373 * _e310)), (_e257[1][2] + (_e382 * _e310)), (_e257[1][3] + (_e391 * _e310))), array<f32, 4>((_e257[2][0] + (_e402 * _e310)), (_e257[2][1] + (_e411 * _e310)), (_e257[2][2] + (_e420 * _e310)), (_e257[2][3] + (_e429 * _e310))));
                                    } else {
                                        phi_775_ = _e255;
                                        phi_776_ = _e257;
                                    }
                                    let _e437 = phi_775_;
                                    let _e439 = phi_776_;
                                    phi_474_ = _e437;
                                    phi_476_ = _e439;
                                } else {
                                    phi_474_ = f32();
                                    phi_476_ = array<array<f32, 4>, 3>();
                                }
                                let _e441 = phi_474_;
                                let _e443 = phi_476_;
                                continue;
                                continuing {
                                    phi_470_ = _e270;
                                    phi_473_ = _e441;
                                    phi_475_ = _e443;
                                    phi_11334_ = false;
                                    break if !(_e276);
                                }
                            }
                            let _e446 = phi_11334_;
                            if _e446 {
                                break;
                            }
                            let _e448 = local;
                            if (_e448 > 0f) {
                                let _e451 = local_1;
                                phi_782_ = (1f / _e451);
                            } else {
                                phi_782_ = 0f;
                            }
                            let _e454 = phi_782_;
                            let _e456 = local_2;
                            let _e461 = local_3;
                            let _e466 = local_4;
                            let _e471 = local_5;
                            let _e476 = local_6;
                            let _e481 = local_7;
                            let _e486 = local_8;
                            let _e491 = local_9;
                            let _e496 = local_10;
                            let _e501 = local_11;
                            let _e506 = local_12;
                            let _e511 = local_13;
                            let _e516 = ((0.6666667f / _e77.w) / _e77.w);
                            let _e518 = (_e67.member_2[2] * -1.0233268f);
                            let _e521 = (_e67.member_2[0] * -1.0233268f);
                            let _e524 = (_e67.member_2[1] * -1.0233268f);
                            let _e526 = (((((_e456[0][0] * _e454) * 0.886227f) + ((_e466[0][2] * _e454) * _e518)) + ((_e471[0][3] * _e454) * _e521)) + ((_e461[0][1] * _e454) * _e524));
                            let _e535 = (((((_e476[1][0] * _e454) * 0.886227f) + ((_e486[1][2] * _e454) * _e518)) + ((_e491[1][3] * _e454) * _e521)) + ((_e481[1][1] * _e454) * _e524));
                            let _e544 = (((((_e496[2][0] * _e454) * 0.886227f) + ((_e506[2][2] * _e454) * _e518)) + ((_e511[2][3] * _e454) * _e521)) + ((_e501[2][1] * _e454) * _e524));
                            phi_11399_ = _e446;
                            phi_2920_ = vec4<f32>(((select(0f, _e526, (_e526 > 0f)) * _e516) * _e144), ((select(0f, _e535, (_e535 > 0f)) * _e516) * _e144), ((select(0f, _e544, (_e544 > 0f)) * _e516) * _e144), (1f - _e144));
                        }
                        let _e556 = phi_11399_;
                        let _e558 = phi_2920_;
                        phi_11397_ = _e556;
                        phi_2922_ = _e558;
                    }
                    let _e560 = phi_11397_;
                    let _e562 = phi_2922_;
                    let _e565 = select(_e562, vec4<f32>(0f, 0f, 0f, 1f), vec4(select(false, true, _e73)));
                    if (1u >= _e72) {
                        phi_11649_ = _e560;
                        phi_5713_ = vec4<f32>();
                        phi_5714_ = true;
                    } else {
                        let _e568 = (_e565.w <= 0f);
                        if _e568 {
                            phi_11650_ = _e560;
                            phi_5712_ = vec4<f32>();
                        } else {
                            let _e572 = params.member.member[1u];
                            let _e576 = params.member.member_1[1u];
                            let _e580 = params.member.member_2[1u];
                            if (2u == _e72) {
                                phi_2980_ = 0f;
                            } else {
                                let _e592 = params.member.member_5;
                                phi_2980_ = _e592;
                            }
                            let _e594 = phi_2980_;
                            let _e602 = ((_e67.member[0] - _e572.x) / _e572.w);
                            let _e603 = ((_e67.member[1] - _e572.y) / _e572.w);
                            let _e604 = ((_e67.member[2] - _e572.z) / _e572.w);
                            let _e611 = (_e602 - f32(_e576.x));
                            let _e612 = (_e603 - f32(_e576.y));
                            let _e613 = (_e604 - f32(_e576.z));
                            let _e621 = select(_e613, _e612, (_e612 < _e613));
                            let _e623 = select(_e621, _e611, (_e611 < _e621));
                            let _e624 = (f32(_e580.x) - _e611);
                            let _e625 = (f32(_e580.y) - _e612);
                            let _e626 = (f32(_e580.z) - _e613);
                            let _e628 = select(_e626, _e625, (_e625 < _e626));
                            let _e630 = select(_e628, _e624, (_e624 < _e628));
                            let _e635 = (select(_e630, _e623, (_e623 < _e630)) / select(0.001f, _e594, (_e594 > 0.001f)));
                            let _e637 = select(0f, _e635, (_e635 > 0f));
                            let _e640 = (_e565.w * select(1f, _e637, (_e637 < 1f)));
                            if (_e640 <= 0f) {
                                phi_11651_ = _e560;
                                phi_5711_ = _e565;
                            } else {
                                let _e647 = params.member.member_6;
                                let _e648 = (_e580.x + 1u);
                                let _e650 = ((_e580.y + 1u) * _e648);
                                let _e651 = (_e650 + _e648);
                                let _e654 = (_e651 + ((_e580.z + 1u) * _e650));
                                let _e661 = ((_e602 + (_e67.member_2[0] * _e647)) - 0.5f);
                                let _e662 = floor(_e661);
                                let _e664 = (bitcast<i32>(_e580.x) - 1i);
                                let _e672 = (select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < -2147483600f)), 2147483647i, (_e662 > 2147483500f)), (_e662 == _e662)) - _e576.x);
                                let _e674 = select(0i, _e672, (0i < _e672));
                                let _e676 = select(_e674, _e664, (_e664 < _e674));
                                let _e677 = (_e672 + 1i);
                                let _e679 = select(0i, _e677, (0i < _e677));
                                let _e681 = select(_e679, _e664, (_e664 < _e679));
                                let _e684 = (_e661 - _e662);
                                let _e691 = ((_e603 + (_e67.member_2[1] * _e647)) - 0.5f);
                                let _e692 = floor(_e691);
                                let _e694 = (bitcast<i32>(_e580.y) - 1i);
                                let _e702 = (select(0i, select(select(i32(_e692), i32(-2147483648), (_e692 < -2147483600f)), 2147483647i, (_e692 > 2147483500f)), (_e692 == _e692)) - _e576.y);
                                let _e704 = select(0i, _e702, (0i < _e702));
                                let _e706 = select(_e704, _e694, (_e694 < _e704));
                                let _e707 = (_e702 + 1i);
                                let _e709 = select(0i, _e707, (0i < _e707));
                                let _e711 = select(_e709, _e694, (_e694 < _e709));
                                let _e714 = (_e691 - _e692);
                                let _e721 = ((_e604 + (_e67.member_2[2] * _e647)) - 0.5f);
                                let _e722 = floor(_e721);
                                let _e724 = (bitcast<i32>(_e580.z) - 1i);
                                let _e732 = (select(0i, select(select(i32(_e722), i32(-2147483648), (_e722 < -2147483600f)), 2147483647i, (_e722 > 2147483500f)), (_e722 == _e722)) - _e576.z);
                                let _e734 = select(0i, _e732, (0i < _e732));
                                let _e736 = select(_e734, _e724, (_e724 < _e734));
                                let _e737 = (_e732 + 1i);
                                let _e739 = select(0i, _e737, (0i < _e737));
                                let _e741 = select(_e739, _e724, (_e724 < _e739));
                                let _e744 = (_e721 - _e722);
                                phi_3261_ = type_11(0u, 8u);
                                phi_3264_ = 0f;
                                phi_3266_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                                loop {
                                    let _e752 = phi_3261_;
                                    let _e754 = phi_3264_;
                                    let _e756 = phi_3266_;
                                    local_14 = _e754;
                                    local_15 = _e754;
                                    local_16 = _e756;
                                    local_17 = _e756;
                                    local_18 = _e756;
                                    local_19 = _e756;
                                    local_20 = _e756;
                                    local_21 = _e756;
                                    local_22 = _e756;
                                    local_23 = _e756;
                                    local_24 = _e756;
                                    local_25 = _e756;
                                    local_26 = _e756;
                                    local_27 = _e756;
                                    if (_e752.member < _e752.member_1) {
                                        phi_3262_ = type_11((_e752.member + 1u), _e752.member_1);
                                        phi_3289_ = type_11(1u, _e752.member);
                                    } else {
                                        phi_3262_ = _e752;
                                        phi_3289_ = type_11(0u, type_11().member_1);
                                    }
                                    let _e769 = phi_3262_;
                                    let _e771 = phi_3289_;
                                    let _e775 = (bitcast<i32>(_e771.member) != 0i);
                                    if _e775 {
                                        let _e777 = ((_e771.member_1 & 1u) == 1u);
                                        let _e779 = ((_e771.member_1 & 2u) == 2u);
                                        let _e781 = ((_e771.member_1 & 4u) == 4u);
                                        if _e777 {
                                            phi_3319_ = _e684;
                                        } else {
                                            phi_3319_ = (1f - _e684);
                                        }
                                        let _e787 = phi_3319_;
                                        if _e779 {
                                            phi_3324_ = _e714;
                                        } else {
                                            phi_3324_ = (1f - _e714);
                                        }
                                        let _e790 = phi_3324_;
                                        if _e781 {
                                            phi_3330_ = _e744;
                                        } else {
                                            phi_3330_ = (1f - _e744);
                                        }
                                        let _e794 = phi_3330_;
                                        let _e804 = (((((select((f32((_e676 + _e576.x)) + 0.5f), (f32((_e681 + _e576.x)) + 0.5f), _e777) - _e602) * _e67.member_2[0]) + ((select((f32((_e706 + _e576.y)) + 0.5f), (f32((_e711 + _e576.y)) + 0.5f), _e779) - _e603) * _e67.member_2[1])) + ((select((f32((_e736 + _e576.z)) + 0.5f), (f32((_e741 + _e576.z)) + 0.5f), _e781) - _e604) * _e67.member_2[2])) * 2f);
                                        let _e806 = select(0f, _e804, (_e804 > 0f));
                                        let _e809 = (((_e787 * _e790) * _e794) * select(1f, _e806, (_e806 < 1f)));
                                        if (_e809 > 0f) {
                                            let _e818 = (((_e651 + select(bitcast<u32>(_e676), bitcast<u32>(_e681), _e777)) + (select(bitcast<u32>(_e706), bitcast<u32>(_e711), _e779) * _e648)) + (select(bitcast<u32>(_e736), bitcast<u32>(_e741), _e781) * _e650));
                                            if (_e818 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e823 = b.member[_e818];
                                            let _e828 = (3u * _e654);
                                            let _e829 = (_e828 + _e818);
                                            if (_e829 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e833 = b.member[_e829];
                                            let _e838 = (_e654 * 6u);
                                            let _e839 = (_e838 + _e818);
                                            if (_e839 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e843 = b.member[_e839];
                                            let _e848 = (_e654 * 9u);
                                            let _e849 = (_e848 + _e818);
                                            if (_e849 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e853 = b.member[_e849];
                                            let _e859 = (_e654 + _e818);
                                            if (_e859 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e863 = b.member[_e859];
                                            let _e868 = (_e828 + _e859);
                                            if (_e868 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e872 = b.member[_e868];
                                            let _e877 = (_e838 + _e859);
                                            if (_e877 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e881 = b.member[_e877];
                                            let _e886 = (_e848 + _e859);
                                            if (_e886 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e890 = b.member[_e886];
                                            let _e897 = ((2u * _e654) + _e818);
                                            if (_e897 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e901 = b.member[_e897];
                                            let _e906 = (_e828 + _e897);
                                            if (_e906 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e910 = b.member[_e906];
                                            let _e915 = (_e838 + _e897);
                                            if (_e915 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e919 = b.member[_e915];
                                            let _e924 = (_e848 + _e897);
                                            if (_e924 < _e50) {
                                            } else {
                                                phi_11371_ = true;
                                                break;
                                            }
                                            let _e928 = b.member[_e924];
                                            phi_3566_ = (_e754 + _e809);
                                            phi_3567_ = array<array<f32, 4>, 3>(array<f32, 4>((_e756[0][0] + (_e823 * _e809)), (_e756[0][1] + (_e833 * _e809)), (_e756[0][2] + (_e843 * _e809)), (_e756[0][3] + (_e853 * _e809))), array<f32, 4>((_e756[1][0] + (_e863 * _e809)), (_e756[1][1] + (_e872 * _e809)), (_e756[1][2] + (_e881 * _e809)), (_e756[1][3] + (_e890 * _e809))), array<f32, 4>((_e756[2][0] + (_e901 * _e809)), (_e756[2][1] + (_e910 * _e809)), (_e756[2][2] + (_e919 * _e809)), (_e756[2][3] + (_e928 * _e809))));
                                        } else {
                                            phi_3566_ = _e754;
                                            phi_3567_ = _e756;
                                        }
                                        let _e936 = phi_3566_;
                                        let _e938 = phi_3567_;
                                        phi_3265_ = _e936;
                                        phi_3267_ = _e938;
                                    } else {
                                        phi_3265_ = f32();
                                        phi_3267_ = array<array<f32, 4>, 3>();
                                    }
                                    let _e940 = phi_3265_;
                                    let _e942 = phi_3267_;
                                    continue;
                                    continuing {
                                        phi_3261_ = _e769;
                                        phi_3264_ = _e940;
                                        phi_3266_ = _e942;
                                        phi_11371_ = _e560;
                                        break if !(_e775);
                                    }
                                }
                                let _e945 = phi_11371_;
                                if _e945 {
                                    break;
                                }
                                let _e947 = local_14;
                                if (_e947 > 0f) {
                                    let _e950 = local_15;
                                    phi_3573_ = (1f / _e950);
                                } else {
                                    phi_3573_ = 0f;
                                }
                                let _e953 = phi_3573_;
                                let _e955 = local_16;
                                let _e960 = local_17;
                                let _e965 = local_18;
                                let _e970 = local_19;
                                let _e975 = local_20;
                                let _e980 = local_21;
                                let _e985 = local_22;
                                let _e990 = local_23;
                                let _e995 = local_24;
                                let _e1000 = local_25;
                                let _e1005 = local_26;
                                let _e1010 = local_27;
                                let _e1015 = ((0.6666667f / _e572.w) / _e572.w);
                                let _e1017 = (_e67.member_2[2] * -1.0233268f);
                                let _e1020 = (_e67.member_2[0] * -1.0233268f);
                                let _e1023 = (_e67.member_2[1] * -1.0233268f);
                                let _e1025 = (((((_e955[0][0] * _e953) * 0.886227f) + ((_e965[0][2] * _e953) * _e1017)) + ((_e970[0][3] * _e953) * _e1020)) + ((_e960[0][1] * _e953) * _e1023));
                                let _e1034 = (((((_e975[1][0] * _e953) * 0.886227f) + ((_e985[1][2] * _e953) * _e1017)) + ((_e990[1][3] * _e953) * _e1020)) + ((_e980[1][1] * _e953) * _e1023));
                                let _e1043 = (((((_e995[2][0] * _e953) * 0.886227f) + ((_e1005[2][2] * _e953) * _e1017)) + ((_e1010[2][3] * _e953) * _e1020)) + ((_e1000[2][1] * _e953) * _e1023));
                                phi_11651_ = _e945;
                                phi_5711_ = vec4<f32>((_e565.x + ((select(0f, _e1025, (_e1025 > 0f)) * _e1015) * _e640)), (_e565.y + ((select(0f, _e1034, (_e1034 > 0f)) * _e1015) * _e640)), (_e565.z + ((select(0f, _e1043, (_e1043 > 0f)) * _e1015) * _e640)), (_e565.w - _e640));
                            }
                            let _e1058 = phi_11651_;
                            let _e1060 = phi_5711_;
                            phi_11650_ = _e1058;
                            phi_5712_ = _e1060;
                        }
                        let _e1062 = phi_11650_;
                        let _e1064 = phi_5712_;
                        phi_11649_ = _e1062;
                        phi_5713_ = _e1064;
                        phi_5714_ = _e568;
                    }
                    let _e1066 = phi_11649_;
                    let _e1068 = phi_5713_;
                    let _e1070 = phi_5714_;
                    let _e1072 = select(_e1068, _e565, vec4(_e1070));
                    if (2u >= _e72) {
                        phi_11901_ = _e1066;
                        phi_8504_ = vec4<f32>();
                        phi_8505_ = true;
                    } else {
                        let _e1075 = (_e1072.w <= 0f);
                        if _e1075 {
                            phi_11902_ = _e1066;
                            phi_8503_ = vec4<f32>();
                        } else {
                            let _e1079 = params.member.member[2u];
                            let _e1083 = params.member.member_1[2u];
                            let _e1087 = params.member.member_2[2u];
                            if (3u == _e72) {
                                phi_5771_ = 0f;
                            } else {
                                let _e1099 = params.member.member_5;
                                phi_5771_ = _e1099;
                            }
                            let _e1101 = phi_5771_;
                            let _e1109 = ((_e67.member[0] - _e1079.x) / _e1079.w);
                            let _e1110 = ((_e67.member[1] - _e1079.y) / _e1079.w);
                            let _e1111 = ((_e67.member[2] - _e1079.z) / _e1079.w);
                            let _e1118 = (_e1109 - f32(_e1083.x));
                            let _e1119 = (_e1110 - f32(_e1083.y));
                            let _e1120 = (_e1111 - f32(_e1083.z));
                            let _e1128 = select(_e1120, _e1119, (_e1119 < _e1120));
                            let _e1130 = select(_e1128, _e1118, (_e1118 < _e1128));
                            let _e1131 = (f32(_e1087.x) - _e1118);
                            let _e1132 = (f32(_e1087.y) - _e1119);
                            let _e1133 = (f32(_e1087.z) - _e1120);
                            let _e1135 = select(_e1133, _e1132, (_e1132 < _e1133));
                            let _e1137 = select(_e1135, _e1131, (_e1131 < _e1135));
                            let _e1142 = (select(_e1137, _e1130, (_e1130 < _e1137)) / select(0.001f, _e1101, (_e1101 > 0.001f)));
                            let _e1144 = select(0f, _e1142, (_e1142 > 0f));
                            let _e1147 = (_e1072.w * select(1f, _e1144, (_e1144 < 1f)));
                            if (_e1147 <= 0f) {
                                phi_11903_ = _e1066;
                                phi_8502_ = _e1072;
                            } else {
                                let _e1154 = params.member.member_6;
                                let _e1155 = (_e1087.x + 1u);
                                let _e1157 = ((_e1087.y + 1u) * _e1155);
                                let _e1158 = (_e1157 + _e1155);
                                let _e1161 = (_e1158 + ((_e1087.z + 1u) * _e1157));
                                let _e1168 = ((_e1109 + (_e67.member_2[0] * _e1154)) - 0.5f);
                                let _e1169 = floor(_e1168);
                                let _e1171 = (bitcast<i32>(_e1087.x) - 1i);
                                let _e1179 = (select(0i, select(select(i32(_e1169), i32(-2147483648), (_e1169 < -2147483600f)), 2147483647i, (_e1169 > 2147483500f)), (_e1169 == _e1169)) - _e1083.x);
                                let _e1181 = select(0i, _e1179, (0i < _e1179));
                                let _e1183 = select(_e1181, _e1171, (_e1171 < _e1181));
                                let _e1184 = (_e1179 + 1i);
                                let _e1186 = select(0i, _e1184, (0i < _e1184));
                                let _e1188 = select(_e1186, _e1171, (_e1171 < _e1186));
                                let _e1191 = (_e1168 - _e1169);
                                let _e1198 = ((_e1110 + (_e67.member_2[1] * _e1154)) - 0.5f);
                                let _e1199 = floor(_e1198);
                                let _e1201 = (bitcast<i32>(_e1087.y) - 1i);
                                let _e1209 = (select(0i, select(select(i32(_e1199), i32(-2147483648), (_e1199 < -2147483600f)), 2147483647i, (_e1199 > 2147483500f)), (_e1199 == _e1199)) - _e1083.y);
                                let _e1211 = select(0i, _e1209, (0i < _e1209));
                                let _e1213 = select(_e1211, _e1201, (_e1201 < _e1211));
                                let _e1214 = (_e1209 + 1i);
                                let _e1216 = select(0i, _e1214, (0i < _e1214));
                                let _e1218 = select(_e1216, _e1201, (_e1201 < _e1216));
                                let _e1221 = (_e1198 - _e1199);
                                let _e1228 = ((_e1111 + (_e67.member_2[2] * _e1154)) - 0.5f);
                                let _e1229 = floor(_e1228);
                                let _e1231 = (bitcast<i32>(_e1087.z) - 1i);
                                let _e1239 = (select(0i, select(select(i32(_e1229), i32(-2147483648), (_e1229 < -2147483600f)), 2147483647i, (_e1229 > 2147483500f)), (_e1229 == _e1229)) - _e1083.z);
                                let _e1241 = select(0i, _e1239, (0i < _e1239));
                                let _e1243 = select(_e1241, _e1231, (_e1231 < _e1241));
                                let _e1244 = (_e1239 + 1i);
                                let _e1246 = select(0i, _e1244, (0i < _e1244));
                                let _e1248 = select(_e1246, _e1231, (_e1231 < _e1246));
                                let _e1251 = (_e1228 - _e1229);
                                phi_6052_ = type_11(0u, 8u);
                                phi_6055_ = 0f;
                                phi_6057_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                                loop {
                                    let _e1259 = phi_6052_;
                                    let _e1261 = phi_6055_;
                                    let _e1263 = phi_6057_;
                                    local_28 = _e1261;
                                    local_29 = _e1261;
                                    local_30 = _e1263;
                                    local_31 = _e1263;
                                    local_32 = _e1263;
                                    local_33 = _e1263;
                                    local_34 = _e1263;
                                    local_35 = _e1263;
                                    local_36 = _e1263;
                                    local_37 = _e1263;
                                    local_38 = _e1263;
                                    local_39 = _e1263;
                                    local_40 = _e1263;
                                    local_41 = _e1263;
                                    if (_e1259.member < _e1259.member_1) {
                                        phi_6053_ = type_11((_e1259.member + 1u), _e1259.member_1);
                                        phi_6080_ = type_11(1u, _e1259.member);
                                    } else {
                                        phi_6053_ = _e1259;
                                        phi_6080_ = type_11(0u, type_11().member_1);
                                    }
                                    let _e1276 = phi_6053_;
                                    let _e1278 = phi_6080_;
                                    let _e1282 = (bitcast<i32>(_e1278.member) != 0i);
                                    if _e1282 {
                                        let _e1284 = ((_e1278.member_1 & 1u) == 1u);
                                        let _e1286 = ((_e1278.member_1 & 2u) == 2u);
                                        let _e1288 = ((_e1278.member_1 & 4u) == 4u);
                                        if _e1284 {
                                            phi_6110_ = _e1191;
                                        } else {
                                            phi_6110_ = (1f - _e1191);
                                        }
                                        let _e1294 = phi_6110_;
                                        if _e1286 {
                                            phi_6115_ = _e1221;
                                        } else {
                                            phi_6115_ = (1f - _e1221);
                                        }
                                        let _e1297 = phi_6115_;
                                        if _e1288 {
                                            phi_6121_ = _e1251;
                                        } else {
                                            phi_6121_ = (1f - _e1251);
                                        }
                                        let _e1301 = phi_6121_;
                                        let _e1311 = (((((select((f32((_e1183 + _e1083.x)) + 0.5f), (f32((_e1188 + _e1083.x)) + 0.5f), _e1284) - _e1109) * _e67.member_2[0]) + ((select((f32((_e1213 + _e1083.y)) + 0.5f), (f32((_e1218 + _e1083.y)) + 0.5f), _e1286) - _e1110) * _e67.member_2[1])) + ((select((f32((_e1243 + _e1083.z)) + 0.5f), (f32((_e1248 + _e1083.z)) + 0.5f), _e1288) - _e1111) * _e67.member_2[2])) * 2f);
                                        let _e1313 = select(0f, _e1311, (_e1311 > 0f));
                                        let _e1316 = (((_e1294 * _e1297) * _e1301) * select(1f, _e1313, (_e1313 < 1f)));
                                        if (_e1316 > 0f) {
                                            let _e1325 = (((_e1158 + select(bitcast<u32>(_e1183), bitcast<u32>(_e1188), _e1284)) + (select(bitcast<u32>(_e1213), bitcast<u32>(_e1218), _e1286) * _e1155)) + (select(bitcast<u32>(_e1243), bitcast<u32>(_e1248), _e1288) * _e1157));
                                            if (_e1325 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1330 = c.member[_e1325];
                                            let _e1335 = (3u * _e1161);
                                            let _e1336 = (_e1335 + _e1325);
                                            if (_e1336 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1340 = c.member[_e1336];
                                            let _e1345 = (_e1161 * 6u);
                                            let _e1346 = (_e1345 + _e1325);
                                            if (_e1346 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1350 = c.member[_e1346];
                                            let _e1355 = (_e1161 * 9u);
                                            let _e1356 = (_e1355 + _e1325);
                                            if (_e1356 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1360 = c.member[_e1356];
                                            let _e1366 = (_e1161 + _e1325);
                                            if (_e1366 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1370 = c.member[_e1366];
                                            let _e1375 = (_e1335 + _e1366);
                                            if (_e1375 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1379 = c.member[_e1375];
                                            let _e1384 = (_e1345 + _e1366);
                                            if (_e1384 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1388 = c.member[_e1384];
                                            let _e1393 = (_e1355 + _e1366);
                                            if (_e1393 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1397 = c.member[_e1393];
                                            let _e1404 = ((2u * _e1161) + _e1325);
                                            if (_e1404 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1408 = c.member[_e1404];
                                            let _e1413 = (_e1335 + _e1404);
                                            if (_e1413 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1417 = c.member[_e1413];
                                            let _e1422 = (_e1345 + _e1404);
                                            if (_e1422 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1426 = c.member[_e1422];
                                            let _e1431 = (_e1355 + _e1404);
                                            if (_e1431 < _e52) {
                                            } else {
                                                phi_11623_ = true;
                                                break;
                                            }
                                            let _e1435 = c.member[_e1431];
                                            phi_6357_ = (_e1261 + _e1316);
                                            phi_6358_ = array<array<f32, 4>, 3>(array<f32, 4>((_e1263[0][0] + (_e1330 * _e1316)), (_e1263[0][1] + (_e1340 * _e1316)), (_e1263[0][2] + (_e1350 * _e1316)), (_e1263[0][3] + (_e1360 * _e1316))), array<f32, 4>((_e1263[1][0] + (_e1370 * _e1316)), (_e1263[1][1] + (_e1379 * _e1316)), (_e1263[1][2] + (_e1388 * _e1316)), (_e1263[1][3] + (_e1397 * _e1316))), array<f32, 4>((_e1263[2][0] + (_e1408 * _e1316)), (_e1263[2][1] + (_e1417 * _e1316)), (_e1263[2][2] + (_e1426 * _e1316)), (_e1263[2][3] + (_e1435 * _e1316))));
                                        } else {
                                            phi_6357_ = _e1261;
                                            phi_6358_ = _e1263;
                                        }
                                        let _e1443 = phi_6357_;
                                        let _e1445 = phi_6358_;
                                        phi_6056_ = _e1443;
                                        phi_6058_ = _e1445;
                                    } else {
                                        phi_6056_ = f32();
                                        phi_6058_ = array<array<f32, 4>, 3>();
                                    }
                                    let _e1447 = phi_6056_;
                                    let _e1449 = phi_6058_;
                                    continue;
                                    continuing {
                                        phi_6052_ = _e1276;
                                        phi_6055_ = _e1447;
                                        phi_6057_ = _e1449;
                                        phi_11623_ = _e1066;
                                        break if !(_e1282);
                                    }
                                }
                                let _e1452 = phi_11623_;
                                if _e1452 {
                                    break;
                                }
                                let _e1454 = local_28;
                                if (_e1454 > 0f) {
                                    let _e1457 = local_29;
                                    phi_6364_ = (1f / _e1457);
                                } else {
                                    phi_6364_ = 0f;
                                }
                                let _e1460 = phi_6364_;
                                let _e1462 = local_30;
                                let _e1467 = local_31;
                                let _e1472 = local_32;
                                let _e1477 = local_33;
                                let _e1482 = local_34;
                                let _e1487 = local_35;
                                let _e1492 = local_36;
                                let _e1497 = local_37;
                                let _e1502 = local_38;
                                let _e1507 = local_39;
                                let _e1512 = local_40;
                                let _e1517 = local_41;
                                let _e1522 = ((0.6666667f / _e1079.w) / _e1079.w);
                                let _e1524 = (_e67.member_2[2] * -1.0233268f);
                                let _e1527 = (_e67.member_2[0] * -1.0233268f);
                                let _e1530 = (_e67.member_2[1] * -1.0233268f);
                                let _e1532 = (((((_e1462[0][0] * _e1460) * 0.886227f) + ((_e1472[0][2] * _e1460) * _e1524)) + ((_e1477[0][3] * _e1460) * _e1527)) + ((_e1467[0][1] * _e1460) * _e1530));
                                let _e1541 = (((((_e1482[1][0] * _e1460) * 0.886227f) + ((_e1492[1][2] * _e1460) * _e1524)) + ((_e1497[1][3] * _e1460) * _e1527)) + ((_e1487[1][1] * _e1460) * _e1530));
                                let _e1550 = (((((_e1502[2][0] * _e1460) * 0.886227f) + ((_e1512[2][2] * _e1460) * _e1524)) + ((_e1517[2][3] * _e1460) * _e1527)) + ((_e1507[2][1] * _e1460) * _e1530));
                                phi_11903_ = _e1452;
                                phi_8502_ = vec4<f32>((_e1072.x + ((select(0f, _e1532, (_e1532 > 0f)) * _e1522) * _e1147)), (_e1072.y + ((select(0f, _e1541, (_e1541 > 0f)) * _e1522) * _e1147)), (_e1072.z + ((select(0f, _e1550, (_e1550 > 0f)) * _e1522) * _e1147)), (_e1072.w - _e1147));
                            }
                            let _e1565 = phi_11903_;
                            let _e1567 = phi_8502_;
                            phi_11902_ = _e1565;
                            phi_8503_ = _e1567;
                        }
                        let _e1569 = phi_11902_;
                        let _e1571 = phi_8503_;
                        phi_11901_ = _e1569;
                        phi_8504_ = _e1571;
                        phi_8505_ = _e1075;
                    }
                    let _e1573 = phi_11901_;
                    let _e1575 = phi_8504_;
                    let _e1577 = phi_8505_;
                    let _e1579 = select(_e1575, _e1072, vec4(_e1577));
                    if (3u >= _e72) {
                        phi_11295_ = vec4<f32>();
                        phi_11296_ = true;
                    } else {
                        let _e1582 = (_e1579.w <= 0f);
                        if _e1582 {
                            phi_11294_ = vec4<f32>();
                        } else {
                            let _e1586 = params.member.member[3u];
                            let _e1590 = params.member.member_1[3u];
                            let _e1594 = params.member.member_2[3u];
                            if (4u == _e72) {
                                phi_8562_ = 0f;
                            } else {
                                let _e1606 = params.member.member_5;
                                phi_8562_ = _e1606;
                            }
                            let _e1608 = phi_8562_;
                            let _e1616 = ((_e67.member[0] - _e1586.x) / _e1586.w);
                            let _e1617 = ((_e67.member[1] - _e1586.y) / _e1586.w);
                            let _e1618 = ((_e67.member[2] - _e1586.z) / _e1586.w);
                            let _e1625 = (_e1616 - f32(_e1590.x));
                            let _e1626 = (_e1617 - f32(_e1590.y));
                            let _e1627 = (_e1618 - f32(_e1590.z));
                            let _e1635 = select(_e1627, _e1626, (_e1626 < _e1627));
                            let _e1637 = select(_e1635, _e1625, (_e1625 < _e1635));
                            let _e1638 = (f32(_e1594.x) - _e1625);
                            let _e1639 = (f32(_e1594.y) - _e1626);
                            let _e1640 = (f32(_e1594.z) - _e1627);
                            let _e1642 = select(_e1640, _e1639, (_e1639 < _e1640));
                            let _e1644 = select(_e1642, _e1638, (_e1638 < _e1642));
                            let _e1649 = (select(_e1644, _e1637, (_e1637 < _e1644)) / select(0.001f, _e1608, (_e1608 > 0.001f)));
                            let _e1651 = select(0f, _e1649, (_e1649 > 0f));
                            let _e1654 = (_e1579.w * select(1f, _e1651, (_e1651 < 1f)));
                            if (_e1654 <= 0f) {
                                phi_11293_ = _e1579;
                            } else {
                                let _e1661 = params.member.member_6;
                                let _e1662 = (_e1594.x + 1u);
                                let _e1664 = ((_e1594.y + 1u) * _e1662);
                                let _e1665 = (_e1664 + _e1662);
                                let _e1668 = (_e1665 + ((_e1594.z + 1u) * _e1664));
                                let _e1675 = ((_e1616 + (_e67.member_2[0] * _e1661)) - 0.5f);
                                let _e1676 = floor(_e1675);
                                let _e1678 = (bitcast<i32>(_e1594.x) - 1i);
                                let _e1686 = (select(0i, select(select(i32(_e1676), i32(-2147483648), (_e1676 < -2147483600f)), 2147483647i, (_e1676 > 2147483500f)), (_e1676 == _e1676)) - _e1590.x);
                                let _e1688 = select(0i, _e1686, (0i < _e1686));
                                let _e1690 = select(_e1688, _e1678, (_e1678 < _e1688));
                                let _e1691 = (_e1686 + 1i);
                                let _e1693 = select(0i, _e1691, (0i < _e1691));
                                let _e1695 = select(_e1693, _e1678, (_e1678 < _e1693));
                                let _e1698 = (_e1675 - _e1676);
                                let _e1705 = ((_e1617 + (_e67.member_2[1] * _e1661)) - 0.5f);
                                let _e1706 = floor(_e1705);
                                let _e1708 = (bitcast<i32>(_e1594.y) - 1i);
                                let _e1716 = (select(0i, select(select(i32(_e1706), i32(-2147483648), (_e1706 < -2147483600f)), 2147483647i, (_e1706 > 2147483500f)), (_e1706 == _e1706)) - _e1590.y);
                                let _e1718 = select(0i, _e1716, (0i < _e1716));
                                let _e1720 = select(_e1718, _e1708, (_e1708 < _e1718));
                                let _e1721 = (_e1716 + 1i);
                                let _e1723 = select(0i, _e1721, (0i < _e1721));
                                let _e1725 = select(_e1723, _e1708, (_e1708 < _e1723));
                                let _e1728 = (_e1705 - _e1706);
                                let _e1735 = ((_e1618 + (_e67.member_2[2] * _e1661)) - 0.5f);
                                let _e1736 = floor(_e1735);
                                let _e1738 = (bitcast<i32>(_e1594.z) - 1i);
                                let _e1746 = (select(0i, select(select(i32(_e1736), i32(-2147483648), (_e1736 < -2147483600f)), 2147483647i, (_e1736 > 2147483500f)), (_e1736 == _e1736)) - _e1590.z);
                                let _e1748 = select(0i, _e1746, (0i < _e1746));
                                let _e1750 = select(_e1748, _e1738, (_e1738 < _e1748));
                                let _e1751 = (_e1746 + 1i);
                                let _e1753 = select(0i, _e1751, (0i < _e1751));
                                let _e1755 = select(_e1753, _e1738, (_e1738 < _e1753));
                                let _e1758 = (_e1735 - _e1736);
                                phi_8843_ = type_11(0u, 8u);
                                phi_8846_ = 0f;
                                phi_8848_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                                loop {
                                    let _e1766 = phi_8843_;
                                    let _e1768 = phi_8846_;
                                    let _e1770 = phi_8848_;
                                    local_42 = _e1768;
                                    local_43 = _e1768;
                                    local_44 = _e1770;
                                    local_45 = _e1770;
                                    local_46 = _e1770;
                                    local_47 = _e1770;
                                    local_48 = _e1770;
                                    local_49 = _e1770;
                                    local_50 = _e1770;
                                    local_51 = _e1770;
                                    local_52 = _e1770;
                                    local_53 = _e1770;
                                    local_54 = _e1770;
                                    local_55 = _e1770;
                                    if (_e1766.member < _e1766.member_1) {
                                        phi_8844_ = type_11((_e1766.member + 1u), _e1766.member_1);
                                        phi_8871_ = type_11(1u, _e1766.member);
                                    } else {
                                        phi_8844_ = _e1766;
                                        phi_8871_ = type_11(0u, type_11().member_1);
                                    }
                                    let _e1783 = phi_8844_;
                                    let _e1785 = phi_8871_;
                                    let _e1789 = (bitcast<i32>(_e1785.member) != 0i);
                                    if _e1789 {
                                        let _e1791 = ((_e1785.member_1 & 1u) == 1u);
                                        let _e1793 = ((_e1785.member_1 & 2u) == 2u);
                                        let _e1795 = ((_e1785.member_1 & 4u) == 4u);
                                        if _e1791 {
                                            phi_8901_ = _e1698;
                                        } else {
                                            phi_8901_ = (1f - _e1698);
                                        }
                                        let _e1801 = phi_8901_;
                                        if _e1793 {
                                            phi_8906_ = _e1728;
                                        } else {
                                            phi_8906_ = (1f - _e1728);
                                        }
                                        let _e1804 = phi_8906_;
                                        if _e1795 {
                                            phi_8912_ = _e1758;
                                        } else {
                                            phi_8912_ = (1f - _e1758);
                                        }
                                        let _e1808 = phi_8912_;
                                        let _e1818 = (((((select((f32((_e1690 + _e1590.x)) + 0.5f), (f32((_e1695 + _e1590.x)) + 0.5f), _e1791) - _e1616) * _e67.member_2[0]) + ((select((f32((_e1720 + _e1590.y)) + 0.5f), (f32((_e1725 + _e1590.y)) + 0.5f), _e1793) - _e1617) * _e67.member_2[1])) + ((select((f32((_e1750 + _e1590.z)) + 0.5f), (f32((_e1755 + _e1590.z)) + 0.5f), _e1795) - _e1618) * _e67.member_2[2])) * 2f);
                                        let _e1820 = select(0f, _e1818, (_e1818 > 0f));
                                        let _e1823 = (((_e1801 * _e1804) * _e1808) * select(1f, _e1820, (_e1820 < 1f)));
                                        if (_e1823 > 0f) {
                                            let _e1832 = (((_e1665 + select(bitcast<u32>(_e1690), bitcast<u32>(_e1695), _e1791)) + (select(bitcast<u32>(_e1720), bitcast<u32>(_e1725), _e1793) * _e1662)) + (select(bitcast<u32>(_e1750), bitcast<u32>(_e1755), _e1795) * _e1664));
                                            if (_e1832 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1837 = d.member[_e1832];
                                            let _e1842 = (3u * _e1668);
                                            let _e1843 = (_e1842 + _e1832);
                                            if (_e1843 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1847 = d.member[_e1843];
                                            let _e1852 = (_e1668 * 6u);
                                            let _e1853 = (_e1852 + _e1832);
                                            if (_e1853 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1857 = d.member[_e1853];
                                            let _e1862 = (_e1668 * 9u);
                                            let _e1863 = (_e1862 + _e1832);
                                            if (_e1863 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1867 = d.member[_e1863];
                                            let _e1873 = (_e1668 + _e1832);
                                            if (_e1873 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1877 = d.member[_e1873];
                                            let _e1882 = (_e1842 + _e1873);
                                            if (_e1882 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1886 = d.member[_e1882];
                                            let _e1891 = (_e1852 + _e1873);
                                            if (_e1891 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1895 = d.member[_e1891];
                                            let _e1900 = (_e1862 + _e1873);
                                            if (_e1900 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1904 = d.member[_e1900];
                                            let _e1911 = ((2u * _e1668) + _e1832);
                                            if (_e1911 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1915 = d.member[_e1911];
                                            let _e1920 = (_e1842 + _e1911);
                                            if (_e1920 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1924 = d.member[_e1920];
                                            let _e1929 = (_e1852 + _e1911);
                                            if (_e1929 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1933 = d.member[_e1929];
                                            let _e1938 = (_e1862 + _e1911);
                                            if (_e1938 < _e54) {
                                            } else {
                                                phi_11875_ = true;
                                                break;
                                            }
                                            let _e1942 = d.member[_e1938];
                                            phi_9148_ = (_e1768 + _e1823);
                                            phi_9149_ = array<array<f32, 4>, 3>(array<f32, 4>((_e1770[0][0] + (_e1837 * _e1823)), (_e1770[0][1] + (_e1847 * _e1823)), (_e1770[0][2] + (_e1857 * _e1823)), (_e1770[0][3] + (_e1867 * _e1823))), array<f32, 4>((_e1770[1][0] + (_e1877 * _e1823)), (_e1770[1][1] + (_e1886 * _e1823)), (_e1770[1][2] + (_e1895 * _e1823)), (_e1770[1][3] + (_e1904 * _e1823))), array<f32, 4>((_e1770[2][0] + (_e1915 * _e1823)), (_e1770[2][1] + (_e1924 * _e1823)), (_e1770[2][2] + (_e1933 * _e1823)), (_e1770[2][3] + (_e1942 * _e1823))));
                                        } else {
                                            phi_9148_ = _e1768;
                                            phi_9149_ = _e1770;
                                        }
                                        let _e1950 = phi_9148_;
                                        let _e1952 = phi_9149_;
                                        phi_8847_ = _e1950;
                                        phi_8849_ = _e1952;
                                    } else {
                                        phi_8847_ = f32();
                                        phi_8849_ = array<array<f32, 4>, 3>();
                                    }
                                    let _e1954 = phi_8847_;
                                    let _e1956 = phi_8849_;
                                    continue;
                                    continuing {
                                        phi_8843_ = _e1783;
                                        phi_8846_ = _e1954;
                                        phi_8848_ = _e1956;
                                        phi_11875_ = _e1573;
                                        break if !(_e1789);
                                    }
                                }
                                let _e1959 = phi_11875_;
                                if _e1959 {
                                    break;
                                }
                                let _e1961 = local_42;
                                if (_e1961 > 0f) {
                                    let _e1964 = local_43;
                                    phi_9155_ = (1f / _e1964);
                                } else {
                                    phi_9155_ = 0f;
                                }
                                let _e1967 = phi_9155_;
                                let _e1969 = local_44;
                                let _e1974 = local_45;
                                let _e1979 = local_46;
                                let _e1984 = local_47;
                                let _e1989 = local_48;
                                let _e1994 = local_49;
                                let _e1999 = local_50;
                                let _e2004 = local_51;
                                let _e2009 = local_52;
                                let _e2014 = local_53;
                                let _e2019 = local_54;
                                let _e2024 = local_55;
                                let _e2029 = ((0.6666667f / _e1586.w) / _e1586.w);
                                let _e2031 = (_e67.member_2[2] * -1.0233268f);
                                let _e2034 = (_e67.member_2[0] * -1.0233268f);
                                let _e2037 = (_e67.member_2[1] * -1.0233268f);
                                let _e2039 = (((((_e1969[0][0] * _e1967) * 0.886227f) + ((_e1979[0][2] * _e1967) * _e2031)) + ((_e1984[0][3] * _e1967) * _e2034)) + ((_e1974[0][1] * _e1967) * _e2037));
                                let _e2048 = (((((_e1989[1][0] * _e1967) * 0.886227f) + ((_e1999[1][2] * _e1967) * _e2031)) + ((_e2004[1][3] * _e1967) * _e2034)) + ((_e1994[1][1] * _e1967) * _e2037));
                                let _e2057 = (((((_e2009[2][0] * _e1967) * 0.886227f) + ((_e2019[2][2] * _e1967) * _e2031)) + ((_e2024[2][3] * _e1967) * _e2034)) + ((_e2014[2][1] * _e1967) * _e2037));
                                phi_11293_ = vec4<f32>((_e1579.x + ((select(0f, _e2039, (_e2039 > 0f)) * _e2029) * _e1654)), (_e1579.y + ((select(0f, _e2048, (_e2048 > 0f)) * _e2029) * _e1654)), (_e1579.z + ((select(0f, _e2057, (_e2057 > 0f)) * _e2029) * _e1654)), f32());
                            }
                            let _e2071 = phi_11293_;
                            phi_11294_ = _e2071;
                        }
                        let _e2073 = phi_11294_;
                        phi_11295_ = _e2073;
                        phi_11296_ = _e1582;
                    }
                    let _e2075 = phi_11295_;
                    let _e2077 = phi_11296_;
                    let _e2079 = select(_e2075, _e1579, vec4(_e2077));
                    phi_11305_ = vec4<f32>(_e2079.x, _e2079.y, _e2079.z, 0f);
                }
                let _e2085 = phi_11305_;
                if _e63 {
                } else {
                    break;
                }
                irradiance.member[_e62] = _e2085;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_gather(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
