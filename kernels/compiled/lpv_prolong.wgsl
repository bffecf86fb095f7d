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
    var phi_91_: u32;
    var phi_175_: bool;
    var phi_177_: bool;
    var phi_178_: bool;
    var phi_375_: u32;
    var phi_384_: u32;
    var phi_385_: u32;
    var phi_418_: u32;
    var phi_427_: u32;
    var phi_428_: u32;
    var phi_1020_: array<f32, 6>;
    var phi_1021_: array<f32, 6>;

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
                phi_91_ = (3u * (_e42 / _e34));
            } else {
                phi_91_ = 0u;
            }
            let _e48 = phi_91_;
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
                        phi_175_ = (_e74 < _e32.z);
                    } else {
                        phi_175_ = bool();
                    }
                    let _e81 = phi_175_;
                    phi_177_ = _e81;
                    phi_178_ = select(true, false, _e78);
                } else {
                    phi_177_ = bool();
                    phi_178_ = true;
                }
                let _e84 = phi_177_;
                let _e86 = phi_178_;
                if select(_e84, false, _e86) {
                    let _e90 = params.member.member_11;
                    let _e93 = before.member[_e61];
                    let _e95 = (_e62 + _e61);
                    let _e98 = state.member[_e95];
                    let _e99 = ((_e93 * _e90) + _e98);
                    let _e103 = before.member[(_e49 + _e61)];
                    let _e109 = state.member[((_e62 + _e49) + _e61)];
                    let _e110 = ((_e103 * _e90) + _e109);
                    let _e111 = (_e42 * 6u);
                    let _e115 = before.member[(_e111 + _e61)];
                    let _e121 = state.member[((_e62 + _e111) + _e61)];
                    let _e122 = ((_e115 * _e90) + _e121);
                    let _e123 = (_e42 * 9u);
                    let _e127 = before.member[(_e123 + _e61)];
                    let _e133 = state.member[((_e62 + _e123) + _e61)];
                    let _e134 = ((_e127 * _e90) + _e133);
                    let _e135 = (_e42 * 12u);
                    let _e139 = before.member[(_e135 + _e61)];
                    let _e145 = state.member[((_e62 + _e135) + _e61)];
                    let _e146 = ((_e139 * _e90) + _e145);
                    let _e149 = before.member[_e95];
                    let _e155 = state.member[((_e62 + _e62) + _e61)];
                    let _e156 = ((_e149 * _e90) + _e155);
                    let _e160 = params.member.member_12;
                    if (_e160 > 0f) {
                        let _e164 = params.member.member_3;
                        let _e166 = (_e164.x + 1u);
                        let _e169 = ((_e164.y + 1u) * _e166);
                        let _e170 = (_e169 + _e166);
                        let _e174 = (_e170 + ((_e164.z + 1u) * _e169));
                        let _e175 = (_e76 / 2u);
                        let _e176 = (_e74 / 2u);
                        let _e180 = params.member.member_3[1u];
                        let _e181 = (_e175 + 1u);
                        let _e182 = (_e180 - 1u);
                        let _e189 = ((_e76 & 1u) == 1u);
                        let _e194 = params.member.member_3[2u];
                        let _e195 = (_e176 + 1u);
                        let _e196 = (_e194 - 1u);
                        let _e203 = ((_e74 & 1u) == 1u);
                        let _e206 = (_e61 - (_e66 * _e42));
                        let _e208 = (_e170 + (_e175 * _e166));
                        let _e209 = (_e176 * _e169);
                        let _e210 = (_e208 + _e209);
                        let _e211 = (_e59 & 1u);
                        let _e213 = (0.5f < f32(_e211));
                        let _e217 = opacity.member[(_e206 - 1u)];
                        let _e220 = opacity.member[_e206];
                        let _e225 = opacity.member[(_e206 + 1u)];
                        let _e229 = opacity.member[(_e206 - 2u)];
                        let _e237 = coarse_opacity.member[((_e210 - 1u) + ((_e59 + 1u) / 2u))];
                        let _e239 = (0.25f * (1f - _e237));
                        let _e240 = (_e237 * select(_e220, _e217, _e213));
                        if _e189 {
                            phi_375_ = (2u * _e34);
                        } else {
                            phi_375_ = _e34;
                        }
                        let _e249 = phi_375_;
                        if _e189 {
                            phi_385_ = 0u;
                        } else {
                            if (_e76 >= 2u) {
                                phi_384_ = (3u * _e34);
                            } else {
                                phi_384_ = _e34;
                            }
                            let _e253 = phi_384_;
                            phi_385_ = _e253;
                        }
                        let _e255 = phi_385_;
                        let _e258 = (_e59 / 2u);
                        let _e262 = coarse_opacity.member[(((_e174 + _e210) - select(_e166, 0u, _e189)) + _e258)];
                        let _e264 = ((_e42 + _e206) + _e34);
                        let _e268 = opacity.member[(_e264 - _e249)];
                        let _e272 = opacity.member[(_e264 - _e255)];
                        let _e274 = (0.25f * (1f - _e262));
                        let _e275 = (_e262 * _e268);
                        let _e277 = (1f - (_e274 + _e275));
                        let _e280 = (_e274 + (_e275 * (1f - _e272)));
                        if _e203 {
                            phi_418_ = (2u * _e37);
                        } else {
                            phi_418_ = _e37;
                        }
                        let _e284 = phi_418_;
                        if _e203 {
                            phi_428_ = 0u;
                        } else {
                            if (_e74 >= 2u) {
                                phi_427_ = (3u * _e37);
                            } else {
                                phi_427_ = _e37;
                            }
                            let _e288 = phi_427_;
                            phi_428_ = _e288;
                        }
                        let _e290 = phi_428_;
                        let _e297 = coarse_opacity.member[((((2u * _e174) + _e210) - select(_e169, 0u, _e203)) + _e258)];
                        let _e300 = (((2u * _e42) + _e206) + _e37);
                        let _e304 = opacity.member[(_e300 - _e284)];
                        let _e308 = opacity.member[(_e300 - _e290)];
                        let _e310 = (0.25f * (1f - _e297));
                        let _e311 = (_e297 * _e304);
                        let _e313 = (1f - (_e310 + _e311));
                        let _e316 = (_e310 + (_e311 * (1f - _e308)));
                        let _e317 = f32(_e59);
                        let _e321 = params.member.member_3[0u];
                        let _e325 = (_e317 < 0.5f);
                        let _e328 = (((2f * f32(_e321)) - 1.5f) < _e317);
                        let _e329 = select(select((1f - (_e239 + _e240)), 1f, _e325), 1f, _e328);
                        let _e330 = select(select((_e239 + (_e240 * (1f - select(_e229, _e225, _e213)))), 0f, _e325), 0f, _e328);
                        let _e331 = (_e66 * _e174);
                        let _e332 = (_e331 + _e210);
                        let _e334 = (_e170 + (select((select(1u, _e175, (1u < _e175)) - 1u), select(_e181, _e182, (_e182 < _e181)), _e189) * _e166));
                        let _e336 = (_e331 + (_e334 + _e209));
                        let _e337 = (select((select(1u, _e176, (1u < _e176)) - 1u), select(_e195, _e196, (_e196 < _e195)), _e203) * _e169);
                        let _e339 = (_e331 + (_e208 + _e337));
                        let _e341 = (_e331 + (_e334 + _e337));
                        let _e342 = (3u * _e174);
                        let _e343 = (_e332 + _e258);
                        let _e346 = coarse.member[_e343];
                        let _e348 = (2u * _e211);
                        let _e353 = coarse.member[((_e343 + _e348) - 1u)];
                        let _e356 = (_e336 + _e258);
                        let _e359 = coarse.member[_e356];
                        let _e365 = coarse.member[((_e356 + _e348) - 1u)];
                        let _e368 = (_e339 + _e258);
                        let _e371 = coarse.member[_e368];
                        let _e377 = coarse.member[((_e368 + _e348) - 1u)];
                        let _e380 = (_e341 + _e258);
                        let _e383 = coarse.member[_e380];
                        let _e389 = coarse.member[((_e380 + _e348) - 1u)];
                        let _e404 = ((_e342 + _e332) + _e258);
                        let _e407 = coarse.member[_e404];
                        let _e413 = coarse.member[((_e404 + _e348) - 1u)];
                        let _e417 = ((_e342 + _e336) + _e258);
                        let _e420 = coarse.member[_e417];
                        let _e426 = coarse.member[((_e417 + _e348) - 1u)];
                        let _e430 = ((_e342 + _e339) + _e258);
                        let _e433 = coarse.member[_e430];
                        let _e439 = coarse.member[((_e430 + _e348) - 1u)];
                        let _e443 = ((_e342 + _e341) + _e258);
                        let _e446 = coarse.member[_e443];
                        let _e452 = coarse.member[((_e443 + _e348) - 1u)];
                        let _e466 = (_e174 * 6u);
                        let _e468 = ((_e466 + _e332) + _e258);
                        let _e471 = coarse.member[_e468];
                        let _e477 = coarse.member[((_e468 + _e348) - 1u)];
                        let _e481 = ((_e466 + _e336) + _e258);
                        let _e484 = coarse.member[_e481];
                        let _e490 = coarse.member[((_e481 + _e348) - 1u)];
                        let _e494 = ((_e466 + _e339) + _e258);
                        let _e497 = coarse.member[_e494];
                        let _e503 = coarse.member[((_e494 + _e348) - 1u)];
                        let _e507 = ((_e466 + _e341) + _e258);
                        let _e510 = coarse.member[_e507];
                        let _e516 = coarse.member[((_e507 + _e348) - 1u)];
                        let _e530 = (_e174 * 9u);
                        let _e532 = ((_e530 + _e332) + _e258);
                        let _e535 = coarse.member[_e532];
                        let _e541 = coarse.member[((_e532 + _e348) - 1u)];
                        let _e545 = ((_e530 + _e336) + _e258);
                        let _e548 = coarse.member[_e545];
                        let _e554 = coarse.member[((_e545 + _e348) - 1u)];
                        let _e558 = ((_e530 + _e339) + _e258);
                        let _e561 = coarse.member[_e558];
                        let _e567 = coarse.member[((_e558 + _e348) - 1u)];
                        let _e571 = ((_e530 + _e341) + _e258);
                        let _e574 = coarse.member[_e571];
                        let _e580 = coarse.member[((_e571 + _e348) - 1u)];
                        let _e594 = (_e174 * 12u);
                        let _e596 = ((_e594 + _e332) + _e258);
                        let _e599 = coarse.member[_e596];
                        let _e605 = coarse.member[((_e596 + _e348) - 1u)];
                        let _e609 = ((_e594 + _e336) + _e258);
                        let _e612 = coarse.member[_e609];
                        let _e618 = coarse.member[((_e609 + _e348) - 1u)];
                        let _e622 = ((_e594 + _e339) + _e258);
                        let _e625 = coarse.member[_e622];
                        let _e631 = coarse.member[((_e622 + _e348) - 1u)];
                        let _e635 = ((_e594 + _e341) + _e258);
                        let _e638 = coarse.member[_e635];
                        let _e644 = coarse.member[((_e635 + _e348) - 1u)];
                        let _e658 = (_e174 * 15u);
                        let _e660 = ((_e658 + _e332) + _e258);
                        let _e663 = coarse.member[_e660];
                        let _e669 = coarse.member[((_e660 + _e348) - 1u)];
                        let _e673 = ((_e658 + _e336) + _e258);
                        let _e676 = coarse.member[_e673];
                        let _e682 = coarse.member[((_e673 + _e348) - 1u)];
                        let _e686 = ((_e658 + _e339) + _e258);
                        let _e689 = coarse.member[_e686];
                        let _e695 = coarse.member[((_e686 + _e348) - 1u)];
                        let _e699 = ((_e658 + _e341) + _e258);
                        let _e702 = coarse.member[_e699];
                        let _e708 = coarse.member[((_e699 + _e348) - 1u)];
                        phi_1020_ = array<f32, 6>((_e99 + (((((((_e346 * _e329) + (_e353 * _e330)) * _e277) + (((_e359 * _e329) + (_e365 * _e330)) * _e280)) * _e313) + (((((_e371 * _e329) + (_e377 * _e330)) * _e277) + (((_e383 * _e329) + (_e389 * _e330)) * _e280)) * _e316)) * _e160)), (_e110 + (((((((_e407 * _e329) + (_e413 * _e330)) * _e277) + (((_e420 * _e329) + (_e426 * _e330)) * _e280)) * _e313) + (((((_e433 * _e329) + (_e439 * _e330)) * _e277) + (((_e446 * _e329) + (_e452 * _e330)) * _e280)) * _e316)) * _e160)), (_e122 + (((((((_e471 * _e329) + (_e477 * _e330)) * _e277) + (((_e484 * _e329) + (_e490 * _e330)) * _e280)) * _e313) + (((((_e497 * _e329) + (_e503 * _e330)) * _e277) + (((_e510 * _e329) + (_e516 * _e330)) * _e280)) * _e316)) * _e160)), (_e134 + (((((((_e535 * _e329) + (_e541 * _e330)) * _e277) + (((_e548 * _e329) + (_e554 * _e330)) * _e280)) * _e313) + (((((_e561 * _e329) + (_e567 * _e330)) * _e277) + (((_e574 * _e329) + (_e580 * _e330)) * _e280)) * _e316)) * _e160)), (_e146 + (((((((_e599 * _e329) + (_e605 * _e330)) * _e277) + (((_e612 * _e329) + (_e618 * _e330)) * _e280)) * _e313) + (((((_e625 * _e329) + (_e631 * _e330)) * _e277) + (((_e638 * _e329) + (_e644 * _e330)) * _e280)) * _e316)) * _e160)), (_e156 + (((((((_e663 * _e329) + (_e669 * _e330)) * _e277) + (((_e676 * _e329) + (_e682 * _e330)) * _e280)) * _e313) + (((((_e689 * _e329) + (_e695 * _e330)) * _e277) + (((_e702 * _e329) + (_e708 * _e330)) * _e280)) * _e316)) * _e160)));
                    } else {
                        phi_1020_ = array<f32, 6>(_e99, _e110, _e122, _e134, _e146, _e156);
                    }
                    let _e724 = phi_1020_;
                    phi_1021_ = _e724;
                } else {
                    phi_1021_ = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e726 = phi_1021_;
                out.member[_e61] = _e726[0];
                out.member[(_e49 + _e61)] = _e726[1];
                out.member[((_e42 * 6u) + _e61)] = _e726[2];
                out.member[((_e42 * 9u) + _e61)] = _e726[3];
                out.member[((_e42 * 12u) + _e61)] = _e726[4];
                out.member[(_e62 + _e61)] = _e726[5];
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
