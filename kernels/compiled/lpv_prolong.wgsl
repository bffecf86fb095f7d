struct type_5 {
    member: array<f32>,
}

struct type_16 {
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

struct type_17 {
    member: type_16,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_17;
@group(0) @binding(1) 
var<storage> before: type_5;
@group(0) @binding(2) 
var<storage> state: type_5;
@group(0) @binding(3) 
var<storage> coarse: type_5;
@group(0) @binding(4) 
var<storage> opacity: type_5;
@group(0) @binding(5) 
var<storage> coarse_opacity: type_5;
@group(0) @binding(6) 
var<storage, read_write> out: type_5;

fn function_() {
    var phi_92_: u32;
    var phi_176_: bool;
    var phi_178_: bool;
    var phi_179_: bool;
    var phi_370_: u32;
    var phi_379_: u32;
    var phi_380_: u32;
    var phi_413_: u32;
    var phi_422_: u32;
    var phi_423_: u32;
    var phi_967_: array<f32, 6>;
    var phi_968_: array<f32, 6>;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = gid_1;
            let _e32 = params.member.member_2;
            let _e34 = (_e32.x + 1u);
            let _e36 = (_e32.y + 1u);
            let _e37 = (_e36 * _e34);
            let _e42 = ((_e37 + _e34) + ((_e32.z + 1u) * _e37));
            if (_e32.x > 0u) {
                if (_e34 == 0u) {
                    break;
                }
                phi_92_ = (3u * (_e42 / _e34));
            } else {
                phi_92_ = 0u;
            }
            let _e48 = phi_92_;
            let _e49 = (3u * _e42);
            let _e53 = (_e29.x + (_e29.y * 2097152u));
            if (_e53 < (_e48 * _e32.x)) {
                if (_e32.x == 0u) {
                    break;
                }
                let _e57 = (_e53 / _e32.x);
                let _e59 = (_e53 - (_e57 * _e32.x));
                let _e61 = ((_e57 * _e34) + _e59);
                let _e62 = (_e42 * 15u);
                let _e63 = (_e34 == 0u);
                if _e63 {
                    break;
                }
                let _e64 = (_e42 / _e34);
                if (_e64 == 0u) {
                    break;
                }
                let _e66 = (_e57 / _e64);
                if _e63 {
                    break;
                }
                let _e68 = (_e57 - (_e66 * _e64));
                let _e69 = (_e32.y + 2u);
                let _e72 = (select(_e69, _e68, (_e69 < _e68)) - _e69);
                if (_e36 == 0u) {
                    break;
                }
                let _e74 = (_e72 / _e36);
                let _e76 = (_e72 - (_e74 * _e36));
                if (_e68 >= _e69) {
                    let _e78 = (_e76 < _e32.y);
                    if _e78 {
                        phi_176_ = (_e74 < _e32.z);
                    } else {
                        phi_176_ = bool();
                    }
                    let _e81 = phi_176_;
                    phi_178_ = _e81;
                    phi_179_ = select(true, false, _e78);
                } else {
                    phi_178_ = bool();
                    phi_179_ = true;
                }
                let _e84 = phi_178_;
                let _e86 = phi_179_;
                if select(_e84, false, _e86) {
                    let _e90 = params.member.member_11;
                    let _e93 = before.member[_e61];
                    let _e94 = (_e62 + _e61);
                    let _e97 = state.member[_e94];
                    let _e98 = fma(_e93, _e90, _e97);
                    let _e102 = before.member[(_e49 + _e61)];
                    let _e107 = state.member[((_e62 + _e49) + _e61)];
                    let _e108 = fma(_e102, _e90, _e107);
                    let _e109 = (_e42 * 6u);
                    let _e113 = before.member[(_e109 + _e61)];
                    let _e118 = state.member[((_e62 + _e109) + _e61)];
                    let _e119 = fma(_e113, _e90, _e118);
                    let _e120 = (_e42 * 9u);
                    let _e124 = before.member[(_e120 + _e61)];
                    let _e129 = state.member[((_e62 + _e120) + _e61)];
                    let _e130 = fma(_e124, _e90, _e129);
                    let _e131 = (_e42 * 12u);
                    let _e135 = before.member[(_e131 + _e61)];
                    let _e140 = state.member[((_e62 + _e131) + _e61)];
                    let _e141 = fma(_e135, _e90, _e140);
                    let _e144 = before.member[_e94];
                    let _e149 = state.member[((_e62 + _e62) + _e61)];
                    let _e150 = fma(_e144, _e90, _e149);
                    let _e154 = params.member.member_12;
                    if (_e154 > 0f) {
                        let _e158 = params.member.member_3;
                        let _e160 = (_e158.x + 1u);
                        let _e163 = ((_e158.y + 1u) * _e160);
                        let _e164 = (_e163 + _e160);
                        let _e168 = (_e164 + ((_e158.z + 1u) * _e163));
                        let _e169 = (_e76 / 2u);
                        let _e170 = (_e74 / 2u);
                        let _e174 = params.member.member_3[1u];
                        let _e175 = (_e169 + 1u);
                        let _e176 = (_e174 - 1u);
                        let _e183 = ((_e76 & 1u) == 1u);
                        let _e188 = params.member.member_3[2u];
                        let _e189 = (_e170 + 1u);
                        let _e190 = (_e188 - 1u);
                        let _e197 = ((_e74 & 1u) == 1u);
                        let _e200 = (_e61 - (_e66 * _e42));
                        let _e202 = (_e164 + (_e169 * _e160));
                        let _e203 = (_e170 * _e163);
                        let _e204 = (_e202 + _e203);
                        let _e205 = (_e59 & 1u);
                        let _e207 = (0.5f < f32(_e205));
                        let _e211 = opacity.member[(_e200 - 1u)];
                        let _e214 = opacity.member[_e200];
                        let _e219 = opacity.member[(_e200 + 1u)];
                        let _e223 = opacity.member[(_e200 - 2u)];
                        let _e231 = coarse_opacity.member[((_e204 - 1u) + ((_e59 + 1u) / 2u))];
                        let _e233 = (0.25f * (1f - _e231));
                        let _e234 = (_e231 * select(_e214, _e211, _e207));
                        if _e183 {
                            phi_370_ = (2u * _e34);
                        } else {
                            phi_370_ = _e34;
                        }
                        let _e243 = phi_370_;
                        if _e183 {
                            phi_380_ = 0u;
                        } else {
                            if (_e76 >= 2u) {
                                phi_379_ = (3u * _e34);
                            } else {
                                phi_379_ = _e34;
                            }
                            let _e247 = phi_379_;
                            phi_380_ = _e247;
                        }
                        let _e249 = phi_380_;
                        let _e252 = (_e59 / 2u);
                        let _e256 = coarse_opacity.member[(((_e168 + _e204) - select(_e160, 0u, _e183)) + _e252)];
                        let _e258 = ((_e42 + _e200) + _e34);
                        let _e262 = opacity.member[(_e258 - _e243)];
                        let _e266 = opacity.member[(_e258 - _e249)];
                        let _e268 = (0.25f * (1f - _e256));
                        let _e269 = (_e256 * _e262);
                        let _e271 = (1f - (_e268 + _e269));
                        let _e274 = (_e268 + (_e269 * (1f - _e266)));
                        if _e197 {
                            phi_413_ = (2u * _e37);
                        } else {
                            phi_413_ = _e37;
                        }
                        let _e278 = phi_413_;
                        if _e197 {
                            phi_423_ = 0u;
                        } else {
                            if (_e74 >= 2u) {
                                phi_422_ = (3u * _e37);
                            } else {
                                phi_422_ = _e37;
                            }
                            let _e282 = phi_422_;
                            phi_423_ = _e282;
                        }
                        let _e284 = phi_423_;
                        let _e291 = coarse_opacity.member[((((2u * _e168) + _e204) - select(_e163, 0u, _e197)) + _e252)];
                        let _e294 = (((2u * _e42) + _e200) + _e37);
                        let _e298 = opacity.member[(_e294 - _e278)];
                        let _e302 = opacity.member[(_e294 - _e284)];
                        let _e304 = (0.25f * (1f - _e291));
                        let _e305 = (_e291 * _e298);
                        let _e307 = (1f - (_e304 + _e305));
                        let _e310 = (_e304 + (_e305 * (1f - _e302)));
                        let _e311 = f32(_e59);
                        let _e315 = params.member.member_3[0u];
                        let _e319 = (_e311 < 0.5f);
                        let _e322 = (((2f * f32(_e315)) - 1.5f) < _e311);
                        let _e323 = select(select((1f - (_e233 + _e234)), 1f, _e319), 1f, _e322);
                        let _e324 = select(select((_e233 + (_e234 * (1f - select(_e223, _e219, _e207)))), 0f, _e319), 0f, _e322);
                        let _e325 = (_e66 * _e168);
                        let _e326 = (_e325 + _e204);
                        let _e328 = (_e164 + (select((select(1u, _e169, (1u < _e169)) - 1u), select(_e175, _e176, (_e176 < _e175)), _e183) * _e160));
                        let _e330 = (_e325 + (_e328 + _e203));
                        let _e331 = (select((select(1u, _e170, (1u < _e170)) - 1u), select(_e189, _e190, (_e190 < _e189)), _e197) * _e163);
                        let _e333 = (_e325 + (_e202 + _e331));
                        let _e335 = (_e325 + (_e328 + _e331));
                        let _e336 = (3u * _e168);
                        let _e337 = (_e326 + _e252);
                        let _e338 = (2u * _e205);
                        let _e343 = coarse.member[((_e337 + _e338) - 1u)];
                        let _e347 = coarse.member[_e337];
                        let _e349 = (_e330 + _e252);
                        let _e354 = coarse.member[((_e349 + _e338) - 1u)];
                        let _e358 = coarse.member[_e349];
                        let _e360 = (_e333 + _e252);
                        let _e365 = coarse.member[((_e360 + _e338) - 1u)];
                        let _e369 = coarse.member[_e360];
                        let _e371 = (_e335 + _e252);
                        let _e376 = coarse.member[((_e371 + _e338) - 1u)];
                        let _e380 = coarse.member[_e371];
                        let _e390 = ((_e336 + _e326) + _e252);
                        let _e395 = coarse.member[((_e390 + _e338) - 1u)];
                        let _e399 = coarse.member[_e390];
                        let _e402 = ((_e336 + _e330) + _e252);
                        let _e407 = coarse.member[((_e402 + _e338) - 1u)];
                        let _e411 = coarse.member[_e402];
                        let _e414 = ((_e336 + _e333) + _e252);
                        let _e419 = coarse.member[((_e414 + _e338) - 1u)];
                        let _e423 = coarse.member[_e414];
                        let _e426 = ((_e336 + _e335) + _e252);
                        let _e431 = coarse.member[((_e426 + _e338) - 1u)];
                        let _e435 = coarse.member[_e426];
                        let _e444 = (_e168 * 6u);
                        let _e446 = ((_e444 + _e326) + _e252);
                        let _e451 = coarse.member[((_e446 + _e338) - 1u)];
                        let _e455 = coarse.member[_e446];
                        let _e458 = ((_e444 + _e330) + _e252);
                        let _e463 = coarse.member[((_e458 + _e338) - 1u)];
                        let _e467 = coarse.member[_e458];
                        let _e470 = ((_e444 + _e333) + _e252);
                        let _e475 = coarse.member[((_e470 + _e338) - 1u)];
                        let _e479 = coarse.member[_e470];
                        let _e482 = ((_e444 + _e335) + _e252);
                        let _e487 = coarse.member[((_e482 + _e338) - 1u)];
                        let _e491 = coarse.member[_e482];
                        let _e500 = (_e168 * 9u);
                        let _e502 = ((_e500 + _e326) + _e252);
                        let _e507 = coarse.member[((_e502 + _e338) - 1u)];
                        let _e511 = coarse.member[_e502];
                        let _e514 = ((_e500 + _e330) + _e252);
                        let _e519 = coarse.member[((_e514 + _e338) - 1u)];
                        let _e523 = coarse.member[_e514];
                        let _e526 = ((_e500 + _e333) + _e252);
                        let _e531 = coarse.member[((_e526 + _e338) - 1u)];
                        let _e535 = coarse.member[_e526];
                        let _e538 = ((_e500 + _e335) + _e252);
                        let _e543 = coarse.member[((_e538 + _e338) - 1u)];
                        let _e547 = coarse.member[_e538];
                        let _e556 = (_e168 * 12u);
                        let _e558 = ((_e556 + _e326) + _e252);
                        let _e563 = coarse.member[((_e558 + _e338) - 1u)];
                        let _e567 = coarse.member[_e558];
                        let _e570 = ((_e556 + _e330) + _e252);
                        let _e575 = coarse.member[((_e570 + _e338) - 1u)];
                        let _e579 = coarse.member[_e570];
                        let _e582 = ((_e556 + _e333) + _e252);
                        let _e587 = coarse.member[((_e582 + _e338) - 1u)];
                        let _e591 = coarse.member[_e582];
                        let _e594 = ((_e556 + _e335) + _e252);
                        let _e599 = coarse.member[((_e594 + _e338) - 1u)];
                        let _e603 = coarse.member[_e594];
                        let _e612 = (_e168 * 15u);
                        let _e614 = ((_e612 + _e326) + _e252);
                        let _e619 = coarse.member[((_e614 + _e338) - 1u)];
                        let _e623 = coarse.member[_e614];
                        let _e626 = ((_e612 + _e330) + _e252);
                        let _e631 = coarse.member[((_e626 + _e338) - 1u)];
                        let _e635 = coarse.member[_e626];
                        let _e638 = ((_e612 + _e333) + _e252);
                        let _e643 = coarse.member[((_e638 + _e338) - 1u)];
                        let _e647 = coarse.member[_e638];
                        let _e650 = ((_e612 + _e335) + _e252);
                        let _e655 = coarse.member[((_e650 + _e338) - 1u)];
                        let _e659 = coarse.member[_e650];
                        phi_967_ = array<f32, 6>(fma(fma(fma(fma(_e347, _e323, (_e343 * _e324)), _e271, (fma(_e358, _e323, (_e354 * _e324)) * _e274)), _e307, (fma(fma(_e369, _e323, (_e365 * _e324)), _e271, (fma(_e380, _e323, (_e376 * _e324)) * _e274)) * _e310)), _e154, _e98), fma(fma(fma(fma(_e399, _e323, (_e395 * _e324)), _e271, (fma(_e411, _e323, (_e407 * _e324)) * _e274)), _e307, (fma(fma(_e423, _e323, (_e419 * _e324)), _e271, (fma(_e435, _e323, (_e431 * _e324)) * _e274)) * _e310)), _e154, _e108), fma(fma(fma(fma(_e455, _e323, (_e451 * _e324)), _e271, (fma(_e467, _e323, (_e463 * _e324)) * _e274)), _e307, (fma(fma(_e479, _e323, (_e475 * _e324)), _e271, (fma(_e491, _e323, (_e487 * _e324)) * _e274)) * _e310)), _e154, _e119), fma(fma(fma(fma(_e511, _e323, (_e507 * _e324)), _e271, (fma(_e523, _e323, (_e519 * _e324)) * _e274)), _e307, (fma(fma(_e535, _e323, (_e531 * _e324)), _e271, (fma(_e547, _e323, (_e543 * _e324)) * _e274)) * _e310)), _e154, _e130), fma(fma(fma(fma(_e567, _e323, (_e563 * _e324)), _e271, (fma(_e579, _e323, (_e575 * _e324)) * _e274)), _e307, (fma(fma(_e591, _e323, (_e587 * _e324)), _e271, (fma(_e603, _e323, (_e599 * _e324)) * _e274)) * _e310)), _e154, _e141), fma(fma(fma(fma(_e623, _e323, (_e619 * _e324)), _e271, (fma(_e635, _e323, (_e631 * _e324)) * _e274)), _e307, (fma(fma(_e647, _e323, (_e643 * _e324)), _e271, (fma(_e659, _e323, (_e655 * _e324)) * _e274)) * _e310)), _e154, _e150));
                    } else {
                        phi_967_ = array<f32, 6>(_e98, _e108, _e119, _e130, _e141, _e150);
                    }
                    let _e670 = phi_967_;
                    phi_968_ = _e670;
                } else {
                    phi_968_ = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e672 = phi_968_;
                out.member[_e61] = _e672[0];
                out.member[(_e49 + _e61)] = _e672[1];
                out.member[((_e42 * 6u) + _e61)] = _e672[2];
                out.member[((_e42 * 9u) + _e61)] = _e672[3];
                out.member[((_e42 * 12u) + _e61)] = _e672[4];
                out.member[(_e62 + _e61)] = _e672[5];
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_prolong(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
