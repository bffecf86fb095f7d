struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_18 {
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

struct type_19 {
    member: type_18,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_19;
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
    var local: array<f32, 6>;
    var phi_94_: u32;
    var phi_178_: bool;
    var phi_180_: bool;
    var phi_181_: bool;
    var phi_988_: array<f32, 6>;
    var phi_989_: array<f32, 6>;
    var phi_999_: type_12;
    var phi_1000_: type_12;
    var phi_1023_: type_12;
    var phi_1052_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = gid_1;
            let _e38 = params.member.member_2;
            let _e40 = (_e38.x + 1u);
            let _e42 = (_e38.y + 1u);
            let _e43 = (_e42 * _e40);
            let _e48 = ((_e43 + _e40) + ((_e38.z + 1u) * _e43));
            if (_e38.x > 0u) {
                if (_e40 == 0u) {
                    break;
                }
                phi_94_ = (3u * (_e48 / _e40));
            } else {
                phi_94_ = 0u;
            }
            let _e54 = phi_94_;
            let _e55 = (3u * _e48);
            let _e59 = (_e33.x + (_e33.y * 2097152u));
            if (_e59 < (_e54 * _e38.x)) {
                if (_e38.x == 0u) {
                    break;
                }
                let _e63 = (_e59 / _e38.x);
                let _e65 = (_e59 - (_e63 * _e38.x));
                let _e67 = ((_e63 * _e40) + _e65);
                let _e68 = (_e48 * 15u);
                let _e69 = (_e40 == 0u);
                if _e69 {
                    break;
                }
                let _e70 = (_e48 / _e40);
                if (_e70 == 0u) {
                    break;
                }
                let _e72 = (_e63 / _e70);
                if _e69 {
                    break;
                }
                let _e74 = (_e63 - (_e72 * _e70));
                let _e75 = (_e38.y + 2u);
                let _e78 = (select(_e75, _e74, (_e75 < _e74)) - _e75);
                if (_e42 == 0u) {
                    break;
                }
                let _e80 = (_e78 / _e42);
                let _e82 = (_e78 - (_e80 * _e42));
                if (_e74 >= _e75) {
                    let _e84 = (_e82 < _e38.y);
                    if _e84 {
                        phi_178_ = (_e80 < _e38.z);
                    } else {
                        phi_178_ = bool();
                    }
                    let _e87 = phi_178_;
                    phi_180_ = _e87;
                    phi_181_ = select(true, false, _e84);
                } else {
                    phi_180_ = bool();
                    phi_181_ = true;
                }
                let _e90 = phi_180_;
                let _e92 = phi_181_;
                if select(_e90, false, _e92) {
                    let _e96 = params.member.member_11;
                    let _e99 = before.member[_e67];
                    let _e101 = (_e68 + _e67);
                    let _e104 = state.member[_e101];
                    let _e105 = ((_e99 * _e96) + _e104);
                    let _e109 = before.member[(_e55 + _e67)];
                    let _e115 = state.member[((_e68 + _e55) + _e67)];
                    let _e116 = ((_e109 * _e96) + _e115);
                    let _e117 = (_e48 * 6u);
                    let _e121 = before.member[(_e117 + _e67)];
                    let _e127 = state.member[((_e68 + _e117) + _e67)];
                    let _e128 = ((_e121 * _e96) + _e127);
                    let _e129 = (_e48 * 9u);
                    let _e133 = before.member[(_e129 + _e67)];
                    let _e139 = state.member[((_e68 + _e129) + _e67)];
                    let _e140 = ((_e133 * _e96) + _e139);
                    let _e141 = (_e48 * 12u);
                    let _e145 = before.member[(_e141 + _e67)];
                    let _e151 = state.member[((_e68 + _e141) + _e67)];
                    let _e152 = ((_e145 * _e96) + _e151);
                    let _e155 = before.member[_e101];
                    let _e161 = state.member[((_e68 + _e68) + _e67)];
                    let _e162 = ((_e155 * _e96) + _e161);
                    let _e166 = params.member.member_12;
                    if (_e166 > 0f) {
                        let _e170 = params.member.member_3;
                        let _e172 = (_e170.x + 1u);
                        let _e175 = ((_e170.y + 1u) * _e172);
                        let _e176 = (_e175 + _e172);
                        let _e180 = (_e176 + ((_e170.z + 1u) * _e175));
                        let _e181 = (_e82 / 2u);
                        let _e182 = (_e80 / 2u);
                        let _e186 = params.member.member_3[1u];
                        let _e187 = (_e181 + 1u);
                        let _e188 = (_e186 - 1u);
                        let _e195 = ((_e82 & 1u) == 1u);
                        let _e200 = params.member.member_3[2u];
                        let _e201 = (_e182 + 1u);
                        let _e202 = (_e200 - 1u);
                        let _e209 = ((_e80 & 1u) == 1u);
                        let _e212 = (_e67 - (_e72 * _e48));
                        let _e214 = (_e176 + (_e181 * _e172));
                        let _e215 = (_e182 * _e175);
                        let _e216 = (_e214 + _e215);
                        let _e217 = (_e65 & 1u);
                        let _e223 = opacity.member[(_e212 - 1u)];
                        let _e226 = opacity.member[_e212];
                        let _e234 = coarse_opacity.member[((_e216 - 1u) + ((_e65 + 1u) / 2u))];
                        let _e245 = (_e65 / 2u);
                        let _e249 = coarse_opacity.member[(((_e180 + _e216) - select(_e172, 0u, _e195)) + _e245)];
                        let _e252 = opacity.member[((_e48 + _e212) - select(0u, _e40, _e195))];
                        let _e256 = ((0.25f * (1f - _e249)) + (_e249 * _e252));
                        let _e268 = coarse_opacity.member[((((2u * _e180) + _e216) - select(_e175, 0u, _e209)) + _e245)];
                        let _e271 = opacity.member[(((2u * _e48) + _e212) - select(0u, _e43, _e209))];
                        let _e275 = ((0.25f * (1f - _e268)) + (_e268 * _e271));
                        let _e276 = f32(_e65);
                        let _e280 = params.member.member_3[0u];
                        let _e287 = select(select(((0.25f * (1f - _e234)) + (_e234 * select(_e226, _e223, (0.5f < f32(_e217))))), 0f, (_e276 < 0.5f)), 0f, (((2f * f32(_e280)) - 1.5f) < _e276));
                        let _e288 = (_e72 * _e180);
                        let _e289 = (_e288 + _e216);
                        let _e291 = (_e176 + (select((select(1u, _e181, (1u < _e181)) - 1u), select(_e187, _e188, (_e188 < _e187)), _e195) * _e172));
                        let _e293 = (_e288 + (_e291 + _e215));
                        let _e294 = (select((select(1u, _e182, (1u < _e182)) - 1u), select(_e201, _e202, (_e202 < _e201)), _e209) * _e175);
                        let _e296 = (_e288 + (_e214 + _e294));
                        let _e298 = (_e288 + (_e291 + _e294));
                        let _e299 = (3u * _e180);
                        let _e300 = (_e289 + _e245);
                        let _e303 = coarse.member[_e300];
                        let _e304 = (1f - _e287);
                        let _e306 = (2u * _e217);
                        let _e311 = coarse.member[((_e300 + _e306) - 1u)];
                        let _e314 = (_e293 + _e245);
                        let _e317 = coarse.member[_e314];
                        let _e323 = coarse.member[((_e314 + _e306) - 1u)];
                        let _e326 = (_e296 + _e245);
                        let _e329 = coarse.member[_e326];
                        let _e335 = coarse.member[((_e326 + _e306) - 1u)];
                        let _e338 = (_e298 + _e245);
                        let _e341 = coarse.member[_e338];
                        let _e347 = coarse.member[((_e338 + _e306) - 1u)];
                        let _e350 = (1f - _e256);
                        let _e357 = (1f - _e275);
                        let _e364 = ((_e299 + _e289) + _e245);
                        let _e367 = coarse.member[_e364];
                        let _e373 = coarse.member[((_e364 + _e306) - 1u)];
                        let _e377 = ((_e299 + _e293) + _e245);
                        let _e380 = coarse.member[_e377];
                        let _e386 = coarse.member[((_e377 + _e306) - 1u)];
                        let _e390 = ((_e299 + _e296) + _e245);
                        let _e393 = coarse.member[_e390];
                        let _e399 = coarse.member[((_e390 + _e306) - 1u)];
                        let _e403 = ((_e299 + _e298) + _e245);
                        let _e406 = coarse.member[_e403];
                        let _e412 = coarse.member[((_e403 + _e306) - 1u)];
                        let _e426 = (_e180 * 6u);
                        let _e428 = ((_e426 + _e289) + _e245);
                        let _e431 = coarse.member[_e428];
                        let _e437 = coarse.member[((_e428 + _e306) - 1u)];
                        let _e441 = ((_e426 + _e293) + _e245);
                        let _e444 = coarse.member[_e441];
                        let _e450 = coarse.member[((_e441 + _e306) - 1u)];
                        let _e454 = ((_e426 + _e296) + _e245);
                        let _e457 = coarse.member[_e454];
                        let _e463 = coarse.member[((_e454 + _e306) - 1u)];
                        let _e467 = ((_e426 + _e298) + _e245);
                        let _e470 = coarse.member[_e467];
                        let _e476 = coarse.member[((_e467 + _e306) - 1u)];
                        let _e490 = (_e180 * 9u);
                        let _e492 = ((_e490 + _e289) + _e245);
                        let _e495 = coarse.member[_e492];
                        let _e501 = coarse.member[((_e492 + _e306) - 1u)];
                        let _e505 = ((_e490 + _e293) + _e245);
                        let _e508 = coarse.member[_e505];
                        let _e514 = coarse.member[((_e505 + _e306) - 1u)];
                        let _e518 = ((_e490 + _e296) + _e245);
                        let _e521 = coarse.member[_e518];
                        let _e527 = coarse.member[((_e518 + _e306) - 1u)];
                        let _e531 = ((_e490 + _e298) + _e245);
                        let _e534 = coarse.member[_e531];
                        let _e540 = coarse.member[((_e531 + _e306) - 1u)];
                        let _e554 = (_e180 * 12u);
                        let _e556 = ((_e554 + _e289) + _e245);
                        let _e559 = coarse.member[_e556];
                        let _e565 = coarse.member[((_e556 + _e306) - 1u)];
                        let _e569 = ((_e554 + _e293) + _e245);
                        let _e572 = coarse.member[_e569];
                        let _e578 = coarse.member[((_e569 + _e306) - 1u)];
                        let _e582 = ((_e554 + _e296) + _e245);
                        let _e585 = coarse.member[_e582];
                        let _e591 = coarse.member[((_e582 + _e306) - 1u)];
                        let _e595 = ((_e554 + _e298) + _e245);
                        let _e598 = coarse.member[_e595];
                        let _e604 = coarse.member[((_e595 + _e306) - 1u)];
                        let _e618 = (_e180 * 15u);
                        let _e620 = ((_e618 + _e289) + _e245);
                        let _e623 = coarse.member[_e620];
                        let _e629 = coarse.member[((_e620 + _e306) - 1u)];
                        let _e633 = ((_e618 + _e293) + _e245);
                        let _e636 = coarse.member[_e633];
                        let _e642 = coarse.member[((_e633 + _e306) - 1u)];
                        let _e646 = ((_e618 + _e296) + _e245);
                        let _e649 = coarse.member[_e646];
                        let _e655 = coarse.member[((_e646 + _e306) - 1u)];
                        let _e659 = ((_e618 + _e298) + _e245);
                        let _e662 = coarse.member[_e659];
                        let _e668 = coarse.member[((_e659 + _e306) - 1u)];
                        phi_988_ = array<f32, 6>((_e105 + (((((((_e303 * _e304) + (_e311 * _e287)) * _e350) + (((_e317 * _e304) + (_e323 * _e287)) * _e256)) * _e357) + (((((_e329 * _e304) + (_e335 * _e287)) * _e350) + (((_e341 * _e304) + (_e347 * _e287)) * _e256)) * _e275)) * _e166)), (_e116 + (((((((_e367 * _e304) + (_e373 * _e287)) * _e350) + (((_e380 * _e304) + (_e386 * _e287)) * _e256)) * _e357) + (((((_e393 * _e304) + (_e399 * _e287)) * _e350) + (((_e406 * _e304) + (_e412 * _e287)) * _e256)) * _e275)) * _e166)), (_e128 + (((((((_e431 * _e304) + (_e437 * _e287)) * _e350) + (((_e444 * _e304) + (_e450 * _e287)) * _e256)) * _e357) + (((((_e457 * _e304) + (_e463 * _e287)) * _e350) + (((_e470 * _e304) + (_e476 * _e287)) * _e256)) * _e275)) * _e166)), (_e140 + (((((((_e495 * _e304) + (_e501 * _e287)) * _e350) + (((_e508 * _e304) + (_e514 * _e287)) * _e256)) * _e357) + (((((_e521 * _e304) + (_e527 * _e287)) * _e350) + (((_e534 * _e304) + (_e540 * _e287)) * _e256)) * _e275)) * _e166)), (_e152 + (((((((_e559 * _e304) + (_e565 * _e287)) * _e350) + (((_e572 * _e304) + (_e578 * _e287)) * _e256)) * _e357) + (((((_e585 * _e304) + (_e591 * _e287)) * _e350) + (((_e598 * _e304) + (_e604 * _e287)) * _e256)) * _e275)) * _e166)), (_e162 + (((((((_e623 * _e304) + (_e629 * _e287)) * _e350) + (((_e636 * _e304) + (_e642 * _e287)) * _e256)) * _e357) + (((((_e649 * _e304) + (_e655 * _e287)) * _e350) + (((_e662 * _e304) + (_e668 * _e287)) * _e256)) * _e275)) * _e166)));
                    } else {
                        phi_988_ = array<f32, 6>(_e105, _e116, _e128, _e140, _e152, _e162);
                    }
                    let _e684 = phi_988_;
                    phi_989_ = _e684;
                } else {
                    phi_989_ = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e686 = phi_989_;
                local = array<f32, 6>(_e686[0], _e686[1], _e686[2], _e686[3], _e686[4], _e686[5]);
                phi_999_ = type_12(0u, 6u);
                loop {
                    let _e695 = phi_999_;
                    if (_e695.member < _e695.member_1) {
                        phi_1000_ = type_12((_e695.member + 1u), _e695.member_1);
                        phi_1023_ = type_12(1u, _e695.member);
                    } else {
                        phi_1000_ = _e695;
                        phi_1023_ = type_12(0u, type_12().member_1);
                    }
                    let _e708 = phi_1000_;
                    let _e710 = phi_1023_;
                    let _e714 = (bitcast<i32>(_e710.member) != 0i);
                    if _e714 {
                        if (_e710.member_1 < 6u) {
                        } else {
                            phi_1052_ = true;
                            break;
                        }
                        let _e717 = local[_e710.member_1];
                        let _e719 = ((_e710.member_1 * _e55) + _e67);
                        if (_e719 < arrayLength((&out.member))) {
                        } else {
                            phi_1052_ = true;
                            break;
                        }
                        out.member[_e719] = _e717;
                    }
                    continue;
                    continuing {
                        phi_999_ = _e708;
                        phi_1052_ = false;
                        break if !(_e714);
                    }
                }
                let _e725 = phi_1052_;
                if _e725 {
                    break;
                }
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
