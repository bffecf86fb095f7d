struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
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
@group(0) @binding(3) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_17;
@group(0) @binding(1) 
var<storage> state: type_5;
@group(0) @binding(2) 
var<storage> opacity: type_5;

fn function_() {
    var local: array<f32, 11>;
    var phi_106_: u32;
    var phi_188_: bool;
    var phi_190_: bool;
    var phi_191_: bool;
    var phi_1492_: bool;
    var phi_1398_: array<f32, 11>;
    var phi_1413_: type_11;
    var phi_1414_: type_11;
    var phi_1437_: type_11;
    var phi_1497_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e51 = gid_1;
            let _e53 = arrayLength((&state.member));
            let _e55 = arrayLength((&opacity.member));
            let _e60 = params.member.member_2;
            let _e62 = (_e60.x + 1u);
            let _e64 = (_e60.y + 1u);
            let _e65 = (_e64 * _e62);
            let _e70 = ((_e65 + _e62) + ((_e60.z + 1u) * _e65));
            if (_e60.x > 0u) {
                if (_e62 == 0u) {
                    break;
                }
                phi_106_ = (3u * (_e70 / _e62));
            } else {
                phi_106_ = 0u;
            }
            let _e76 = phi_106_;
            let _e77 = (3u * _e70);
            let _e81 = (_e51.x + (_e51.y * 2097152u));
            if (_e81 < (_e76 * _e60.x)) {
                if (_e60.x == 0u) {
                    break;
                }
                let _e85 = (_e81 / _e60.x);
                let _e89 = ((_e85 * _e62) + (_e81 - (_e85 * _e60.x)));
                let _e90 = (_e62 == 0u);
                if _e90 {
                    break;
                }
                let _e91 = (_e70 / _e62);
                if (_e91 == 0u) {
                    break;
                }
                let _e93 = (_e85 / _e91);
                if _e90 {
                    break;
                }
                let _e95 = (_e85 - (_e93 * _e91));
                let _e96 = (_e60.y + 2u);
                let _e99 = (select(_e96, _e95, (_e96 < _e95)) - _e96);
                if (_e64 == 0u) {
                    break;
                }
                let _e101 = (_e99 / _e64);
                if (_e95 >= _e96) {
                    let _e105 = ((_e99 - (_e101 * _e64)) < _e60.y);
                    if _e105 {
                        phi_188_ = (_e101 < _e60.z);
                    } else {
                        phi_188_ = bool();
                    }
                    let _e108 = phi_188_;
                    phi_190_ = _e108;
                    phi_191_ = select(true, false, _e105);
                } else {
                    phi_190_ = bool();
                    phi_191_ = true;
                }
                let _e111 = phi_190_;
                let _e113 = phi_191_;
                if select(_e111, false, _e113) {
                    let _e116 = (_e89 - (_e93 * _e70));
                    if (_e116 < _e55) {
                    } else {
                        break;
                    }
                    let _e120 = opacity.member[_e116];
                    let _e123 = params.member.member_8;
                    let _e125 = (1f - (_e120 * _e123));
                    let _e126 = (_e116 - 1u);
                    if (_e126 < _e55) {
                    } else {
                        break;
                    }
                    let _e130 = opacity.member[_e126];
                    let _e132 = (1f - (_e130 * _e123));
                    let _e133 = (_e70 + _e116);
                    if (_e133 < _e55) {
                    } else {
                        break;
                    }
                    let _e137 = opacity.member[_e133];
                    let _e139 = (1f - (_e137 * _e123));
                    let _e140 = (_e133 - _e62);
                    if (_e140 < _e55) {
                    } else {
                        break;
                    }
                    let _e144 = opacity.member[_e140];
                    let _e146 = (1f - (_e144 * _e123));
                    let _e148 = ((2u * _e70) + _e116);
                    if (_e148 < _e55) {
                    } else {
                        break;
                    }
                    let _e152 = opacity.member[_e148];
                    let _e154 = (1f - (_e152 * _e123));
                    let _e155 = (_e148 - _e65);
                    if (_e155 < _e55) {
                    } else {
                        break;
                    }
                    let _e159 = opacity.member[_e155];
                    let _e161 = (1f - (_e159 * _e123));
                    let _e165 = params.member.member_4[0u];
                    let _e169 = params.member.member_4[1u];
                    let _e173 = params.member.member_4[2u];
                    let _e174 = (_e89 + 1u);
                    let _e175 = (_e174 + _e77);
                    if (_e175 < _e53) {
                    } else {
                        break;
                    }
                    let _e179 = state.member[_e175];
                    let _e180 = (_e70 * 6u);
                    let _e181 = (_e174 + _e180);
                    if (_e181 < _e53) {
                    } else {
                        break;
                    }
                    let _e185 = state.member[_e181];
                    let _e186 = (_e70 * 9u);
                    let _e187 = (_e174 + _e186);
                    if (_e187 < _e53) {
                    } else {
                        break;
                    }
                    let _e191 = state.member[_e187];
                    if (_e174 < _e53) {
                    } else {
                        break;
                    }
                    let _e196 = state.member[_e174];
                    let _e198 = (_e196 + (_e179 * -0.8944272f));
                    let _e199 = (_e185 * 0.4472136f);
                    let _e200 = (_e191 * 0.4472136f);
                    let _e201 = (_e198 + _e199);
                    let _e203 = select(0f, _e201, (0f < _e201));
                    let _e204 = (_e198 - _e199);
                    let _e206 = select(0f, _e204, (0f < _e204));
                    let _e207 = (_e198 + _e200);
                    let _e209 = select(0f, _e207, (0f < _e207));
                    let _e210 = (_e198 - _e200);
                    let _e212 = select(0f, _e210, (0f < _e210));
                    let _e213 = (_e196 + -(_e179));
                    let _e216 = (select(0f, _e213, (0f < _e213)) * 0.4006697f);
                    let _e220 = (((_e203 + _e206) + (_e209 + _e212)) * 0.42343134f);
                    let _e225 = (_e70 * 12u);
                    let _e226 = (_e174 + _e225);
                    if (_e226 < _e53) {
                    } else {
                        break;
                    }
                    let _e230 = state.member[_e226];
                    let _e231 = (_e125 * _e230);
                    let _e243 = (_e89 - 1u);
                    let _e244 = (_e243 + _e77);
                    if (_e244 < _e53) {
                    } else {
                        break;
                    }
                    let _e248 = state.member[_e244];
                    let _e249 = (_e243 + _e180);
                    if (_e249 < _e53) {
                    } else {
                        break;
                    }
                    let _e253 = state.member[_e249];
                    let _e254 = (_e243 + _e186);
                    if (_e254 < _e53) {
                    } else {
                        break;
                    }
                    let _e258 = state.member[_e254];
                    if (_e243 < _e53) {
                    } else {
                        break;
                    }
                    let _e262 = state.member[_e243];
                    let _e264 = (_e262 + (_e248 * 0.8944272f));
                    let _e265 = (_e253 * 0.4472136f);
                    let _e266 = (_e258 * 0.4472136f);
                    let _e267 = (_e264 + _e265);
                    let _e269 = select(0f, _e267, (0f < _e267));
                    let _e270 = (_e264 - _e265);
                    let _e272 = select(0f, _e270, (0f < _e270));
                    let _e273 = (_e264 + _e266);
                    let _e275 = select(0f, _e273, (0f < _e273));
                    let _e276 = (_e264 - _e266);
                    let _e278 = select(0f, _e276, (0f < _e276));
                    let _e279 = (_e262 + _e248);
                    let _e282 = (select(0f, _e279, (0f < _e279)) * 0.4006697f);
                    let _e286 = (((_e269 + _e272) + (_e275 + _e278)) * 0.42343134f);
                    let _e291 = (_e243 + _e225);
                    if (_e291 < _e53) {
                    } else {
                        break;
                    }
                    let _e295 = state.member[_e291];
                    let _e296 = (_e132 * _e295);
                    let _e311 = (_e89 + _e62);
                    let _e312 = (_e311 + _e77);
                    if (_e312 < _e53) {
                    } else {
                        break;
                    }
                    let _e316 = state.member[_e312];
                    let _e317 = (_e311 + _e180);
                    if (_e317 < _e53) {
                    } else {
                        break;
                    }
                    let _e321 = state.member[_e317];
                    let _e322 = (_e311 + _e186);
                    if (_e322 < _e53) {
                    } else {
                        break;
                    }
                    let _e326 = state.member[_e322];
                    if (_e311 < _e53) {
                    } else {
                        break;
                    }
                    let _e331 = state.member[_e311];
                    let _e333 = (_e331 + (_e321 * -0.8944272f));
                    let _e334 = (_e326 * 0.4472136f);
                    let _e335 = (_e316 * 0.4472136f);
                    let _e336 = (_e333 + _e334);
                    let _e338 = select(0f, _e336, (0f < _e336));
                    let _e339 = (_e333 - _e334);
                    let _e341 = select(0f, _e339, (0f < _e339));
                    let _e342 = (_e333 + _e335);
                    let _e344 = select(0f, _e342, (0f < _e342));
                    let _e345 = (_e333 - _e335);
                    let _e347 = select(0f, _e345, (0f < _e345));
                    let _e348 = (_e331 + -(_e321));
                    let _e351 = (select(0f, _e348, (0f < _e348)) * 0.4006697f);
                    let _e355 = (((_e338 + _e341) + (_e344 + _e347)) * 0.42343134f);
                    let _e360 = (_e311 + _e225);
                    if (_e360 < _e53) {
                    } else {
                        break;
                    }
                    let _e364 = state.member[_e360];
                    let _e365 = (_e139 * _e364);
                    let _e380 = (_e89 - _e62);
                    let _e381 = (_e380 + _e77);
                    if (_e381 < _e53) {
                    } else {
                        break;
                    }
                    let _e385 = state.member[_e381];
                    let _e386 = (_e380 + _e180);
                    if (_e386 < _e53) {
                    } else {
                        break;
                    }
                    let _e390 = state.member[_e386];
                    let _e391 = (_e380 + _e186);
                    if (_e391 < _e53) {
                    } else {
                        break;
                    }
                    let _e395 = state.member[_e391];
                    if (_e380 < _e53) {
                    } else {
                        break;
                    }
                    let _e399 = state.member[_e380];
                    let _e401 = (_e399 + (_e390 * 0.8944272f));
                    let _e402 = (_e395 * 0.4472136f);
                    let _e403 = (_e385 * 0.4472136f);
                    let _e404 = (_e401 + _e402);
                    let _e406 = select(0f, _e404, (0f < _e404));
                    let _e407 = (_e401 - _e402);
                    let _e409 = select(0f, _e407, (0f < _e407));
                    let _e410 = (_e401 + _e403);
                    let _e412 = select(0f, _e410, (0f < _e410));
                    let _e413 = (_e401 - _e403);
                    let _e415 = select(0f, _e413, (0f < _e413));
                    let _e416 = (_e399 + _e390);
                    let _e419 = (select(0f, _e416, (0f < _e416)) * 0.4006697f);
                    let _e423 = (((_e406 + _e409) + (_e412 + _e415)) * 0.42343134f);
                    let _e428 = (_e380 + _e225);
                    if (_e428 < _e53) {
                    } else {
                        break;
                    }
                    let _e432 = state.member[_e428];
                    let _e433 = (_e146 * _e432);
                    let _e448 = (_e89 + _e65);
                    let _e449 = (_e448 + _e77);
                    if (_e449 < _e53) {
                    } else {
                        break;
                    }
                    let _e453 = state.member[_e449];
                    let _e454 = (_e448 + _e180);
                    if (_e454 < _e53) {
                    } else {
                        break;
                    }
                    let _e458 = state.member[_e454];
                    let _e459 = (_e448 + _e186);
                    if (_e459 < _e53) {
                    } else {
                        break;
                    }
                    let _e463 = state.member[_e459];
                    if (_e448 < _e53) {
                    } else {
                        break;
                    }
                    let _e468 = state.member[_e448];
                    let _e470 = (_e468 + (_e463 * -0.8944272f));
                    let _e471 = (_e453 * 0.4472136f);
                    let _e472 = (_e458 * 0.4472136f);
                    let _e473 = (_e470 + _e471);
                    let _e475 = select(0f, _e473, (0f < _e473));
                    let _e476 = (_e470 - _e471);
                    let _e478 = select(0f, _e476, (0f < _e476));
                    let _e479 = (_e470 + _e472);
                    let _e481 = select(0f, _e479, (0f < _e479));
                    let _e482 = (_e470 - _e472);
                    let _e484 = select(0f, _e482, (0f < _e482));
                    let _e485 = (_e468 + -(_e463));
                    let _e488 = (select(0f, _e485, (0f < _e485)) * 0.4006697f);
                    let _e492 = (((_e475 + _e478) + (_e481 + _e484)) * 0.42343134f);
                    let _e497 = (_e448 + _e225);
                    if (_e497 < _e53) {
                    } else {
                        break;
                    }
                    let _e501 = state.member[_e497];
                    let _e502 = (_e154 * _e501);
                    let _e517 = (_e89 - _e65);
                    let _e518 = (_e517 + _e77);
                    if (_e518 < _e53) {
                    } else {
                        break;
                    }
                    let _e522 = state.member[_e518];
                    let _e523 = (_e517 + _e180);
                    if (_e523 < _e53) {
                    } else {
                        break;
                    }
                    let _e527 = state.member[_e523];
                    let _e528 = (_e517 + _e186);
                    if (_e528 < _e53) {
                    } else {
                        break;
                    }
                    let _e532 = state.member[_e528];
                    if (_e517 < _e53) {
                    } else {
                        break;
                    }
                    let _e536 = state.member[_e517];
                    let _e538 = (_e536 + (_e532 * 0.8944272f));
                    let _e539 = (_e522 * 0.4472136f);
                    let _e540 = (_e527 * 0.4472136f);
                    let _e541 = (_e538 + _e539);
                    let _e543 = select(0f, _e541, (0f < _e541));
                    let _e544 = (_e538 - _e539);
                    let _e546 = select(0f, _e544, (0f < _e544));
                    let _e547 = (_e538 + _e540);
                    let _e549 = select(0f, _e547, (0f < _e547));
                    let _e550 = (_e538 - _e540);
                    let _e552 = select(0f, _e550, (0f < _e550));
                    let _e553 = (_e536 + _e532);
                    let _e556 = (select(0f, _e553, (0f < _e553)) * 0.4006697f);
                    let _e560 = (((_e543 + _e546) + (_e549 + _e552)) * 0.42343134f);
                    let _e565 = (_e517 + _e225);
                    if (_e565 < _e53) {
                    } else {
                        break;
                    }
                    let _e569 = state.member[_e565];
                    let _e570 = (_e161 * _e569);
                    let _e573 = (((((((_e216 + _e220) * _e125) + ((_e282 + _e286) * _e132)) + ((_e351 + _e355) * _e139)) + ((_e419 + _e423) * _e146)) + ((_e488 + _e492) * _e154)) + ((_e556 + _e560) * _e161));
                    let _e587 = params.member.member_9;
                    let _e591 = params.member.member_4[3u];
                    let _e594 = params.member.member_6;
                    let _e595 = (0.000000000000000001f < _e573);
                    let _e596 = select(0f, _e573, _e595);
                    let _e598 = (1f / select(1f, _e596, _e595));
                    let _e599 = ((((((-((((_e216 * _e165) + (_e220 * _e169)) * _e231)) + (((_e282 * _e165) + (_e286 * _e169)) * _e296)) + ((((_e344 - _e347) * 0.42343134f) * _e173) * _e365)) + ((((_e412 - _e415) * 0.42343134f) * _e173) * _e433)) + ((((_e475 - _e478) * 0.42343134f) * _e173) * _e502)) + ((((_e543 - _e546) * 0.42343134f) * _e173) * _e570)) * _e598);
                    let _e600 = ((((((((((_e203 - _e206) * 0.42343134f) * _e173) * _e231) + ((((_e269 - _e272) * 0.42343134f) * _e173) * _e296)) - (((_e351 * _e165) + (_e355 * _e169)) * _e365)) + (((_e419 * _e165) + (_e423 * _e169)) * _e433)) + ((((_e481 - _e484) * 0.42343134f) * _e173) * _e502)) + ((((_e549 - _e552) * 0.42343134f) * _e173) * _e570)) * _e598);
                    let _e601 = ((((((((((_e209 - _e212) * 0.42343134f) * _e173) * _e231) + ((((_e275 - _e278) * 0.42343134f) * _e173) * _e296)) + ((((_e338 - _e341) * 0.42343134f) * _e173) * _e365)) + ((((_e406 - _e409) * 0.42343134f) * _e173) * _e433)) - (((_e488 * _e165) + (_e492 * _e169)) * _e502)) + (((_e556 * _e165) + (_e560 * _e169)) * _e570)) * _e598);
                    let _e606 = (((_e599 * _e599) + (_e600 * _e600)) + (_e601 * _e601));
                    let _e610 = (1f / sqrt(select(1f, _e606, (1f < _e606))));
                    let _e611 = (_e599 * _e610);
                    let _e612 = (_e600 * _e610);
                    let _e613 = (_e601 * _e610);
                    let _e615 = ((_e606 * _e610) * _e610);
                    let _e616 = sqrt(_e615);
                    if (_e594 != _e594) {
                        phi_1492_ = true;
                    } else {
                        phi_1492_ = (0.33333334f >= _e594);
                    }
                    let _e620 = phi_1492_;
                    let _e621 = select(_e594, 0.33333334f, _e620);
                    let _e624 = (3f * select(_e621, _e616, (_e616 < _e621)));
                    let _e626 = (3f - _e624);
                    let _e628 = (0.31830987f / (_e626 * _e626));
                    let _e631 = (_e616 < select(2f, 0.33333334f, (_e594 > 0.33333334f)));
                    let _e636 = select(((2f - _e624) * _e628), 0.07957747f, _e631);
                    let _e637 = select((_e628 / select(0.33333334f, _e616, (0.33333334f < _e616))), 0.2387324f, _e631);
                    let _e638 = (_e611 * _e637);
                    let _e639 = (_e612 * _e637);
                    let _e640 = (_e613 * _e637);
                    let _e642 = (_e636 + (_e638 * 0.8944272f));
                    let _e643 = (_e639 * 0.4472136f);
                    let _e644 = (_e640 * 0.4472136f);
                    let _e645 = (_e642 + _e643);
                    let _e647 = select(0f, _e645, (0f < _e645));
                    let _e648 = (_e642 - _e643);
                    let _e650 = select(0f, _e648, (0f < _e648));
                    let _e651 = (_e642 + _e644);
                    let _e653 = select(0f, _e651, (0f < _e651));
                    let _e654 = (_e642 - _e644);
                    let _e656 = select(0f, _e654, (0f < _e654));
                    let _e657 = (_e636 + _e638);
                    let _e660 = (select(0f, _e657, (0f < _e657)) * 0.4006697f);
                    let _e664 = (((_e647 + _e650) + (_e653 + _e656)) * 0.42343134f);
                    let _e669 = (_e636 + (_e638 * -0.8944272f));
                    let _e670 = (_e669 + _e643);
                    let _e672 = select(0f, _e670, (0f < _e670));
                    let _e673 = (_e669 - _e643);
                    let _e675 = select(0f, _e673, (0f < _e673));
                    let _e676 = (_e669 + _e644);
                    let _e678 = select(0f, _e676, (0f < _e676));
                    let _e679 = (_e669 - _e644);
                    let _e681 = select(0f, _e679, (0f < _e679));
                    let _e682 = (_e636 + -(_e638));
                    let _e685 = (select(0f, _e682, (0f < _e682)) * 0.4006697f);
                    let _e689 = (((_e672 + _e675) + (_e678 + _e681)) * 0.42343134f);
                    let _e692 = (_e660 + _e664);
                    let _e693 = (_e685 + _e689);
                    let _e702 = (_e636 + (_e639 * 0.8944272f));
                    let _e703 = (_e638 * 0.4472136f);
                    let _e704 = (_e702 + _e644);
                    let _e706 = select(0f, _e704, (0f < _e704));
                    let _e707 = (_e702 - _e644);
                    let _e709 = select(0f, _e707, (0f < _e707));
                    let _e710 = (_e702 + _e703);
                    let _e712 = select(0f, _e710, (0f < _e710));
                    let _e713 = (_e702 - _e703);
                    let _e715 = select(0f, _e713, (0f < _e713));
                    let _e716 = (_e636 + _e639);
                    let _e719 = (select(0f, _e716, (0f < _e716)) * 0.4006697f);
                    let _e723 = (((_e706 + _e709) + (_e712 + _e715)) * 0.42343134f);
                    let _e728 = (_e636 + (_e639 * -0.8944272f));
                    let _e729 = (_e728 + _e644);
                    let _e731 = select(0f, _e729, (0f < _e729));
                    let _e732 = (_e728 - _e644);
                    let _e734 = select(0f, _e732, (0f < _e732));
                    let _e735 = (_e728 + _e703);
                    let _e737 = select(0f, _e735, (0f < _e735));
                    let _e738 = (_e728 - _e703);
                    let _e740 = select(0f, _e738, (0f < _e738));
                    let _e741 = (_e636 + -(_e639));
                    let _e744 = (select(0f, _e741, (0f < _e741)) * 0.4006697f);
                    let _e748 = (((_e731 + _e734) + (_e737 + _e740)) * 0.42343134f);
                    let _e751 = (_e719 + _e723);
                    let _e752 = (_e744 + _e748);
                    let _e765 = (_e636 + (_e640 * 0.8944272f));
                    let _e766 = (_e765 + _e703);
                    let _e768 = select(0f, _e766, (0f < _e766));
                    let _e769 = (_e765 - _e703);
                    let _e771 = select(0f, _e769, (0f < _e769));
                    let _e772 = (_e765 + _e643);
                    let _e774 = select(0f, _e772, (0f < _e772));
                    let _e775 = (_e765 - _e643);
                    let _e777 = select(0f, _e775, (0f < _e775));
                    let _e778 = (_e636 + _e640);
                    let _e781 = (select(0f, _e778, (0f < _e778)) * 0.4006697f);
                    let _e785 = (((_e768 + _e771) + (_e774 + _e777)) * 0.42343134f);
                    let _e790 = (_e636 + (_e640 * -0.8944272f));
                    let _e791 = (_e790 + _e703);
                    let _e793 = select(0f, _e791, (0f < _e791));
                    let _e794 = (_e790 - _e703);
                    let _e796 = select(0f, _e794, (0f < _e794));
                    let _e797 = (_e790 + _e643);
                    let _e799 = select(0f, _e797, (0f < _e797));
                    let _e800 = (_e790 - _e643);
                    let _e802 = select(0f, _e800, (0f < _e800));
                    let _e803 = (_e636 + -(_e640));
                    let _e806 = (select(0f, _e803, (0f < _e803)) * 0.4006697f);
                    let _e810 = (((_e793 + _e796) + (_e799 + _e802)) * 0.42343134f);
                    let _e813 = (_e781 + _e785);
                    let _e814 = (_e806 + _e810);
                    let _e819 = (((0.18936425f * (((_e653 - _e656) + (_e678 - _e681)) + ((_e706 - _e709) + (_e731 - _e734)))) + (_e781 - _e806)) + ((_e785 - _e810) * 0.8944272f));
                    let _e822 = ((((_e660 - _e685) + ((_e664 - _e689) * 0.8944272f)) + (((_e712 - _e715) + (_e737 - _e740)) * 0.18936425f)) + (((_e768 - _e771) + (_e793 - _e796)) * 0.18936425f));
                    let _e825 = ((((((_e647 - _e650) + (_e672 - _e675)) * 0.18936425f) + (_e719 - _e744)) + ((_e723 - _e748) * 0.8944272f)) + (((_e774 - _e777) + (_e799 - _e802)) * 0.18936425f));
                    let _e826 = (_e692 + _e693);
                    let _e827 = (_e751 + _e752);
                    let _e829 = (_e813 + _e814);
                    let _e831 = (1f / ((_e826 + _e827) + _e829));
                    let _e834 = ((_e831 * _e587) + (1f - _e587));
                    let _e846 = (_e596 * _e834);
                    let _e848 = (_e846 * _e637);
                    let _e850 = ((_e596 * _e831) * 0.7329038f);
                    let _e874 = ((_e70 * 15u) + _e89);
                    if (_e874 < _e53) {
                    } else {
                        break;
                    }
                    let _e878 = state.member[_e874];
                    let _e881 = ((_e70 * 18u) + _e89);
                    if (_e881 < _e53) {
                    } else {
                        break;
                    }
                    let _e885 = state.member[_e881];
                    let _e888 = ((_e70 * 21u) + _e89);
                    if (_e888 < _e53) {
                    } else {
                        break;
                    }
                    let _e892 = state.member[_e888];
                    let _e895 = ((_e70 * 24u) + _e89);
                    if (_e895 < _e53) {
                    } else {
                        break;
                    }
                    let _e899 = state.member[_e895];
                    let _e902 = ((_e70 * 27u) + _e89);
                    if (_e902 < _e53) {
                    } else {
                        break;
                    }
                    let _e906 = state.member[_e902];
                    let _e909 = ((_e70 * 30u) + _e89);
                    if (_e909 < _e53) {
                    } else {
                        break;
                    }
                    let _e913 = state.member[_e909];
                    phi_1398_ = array<f32, 11>((_e846 * _e636), (_e611 * _e848), (_e612 * _e848), (_e613 * _e848), select(1f, ((sqrt(((_e615 + 0.0001f) / ((((((_e822 * _e822) + (_e825 * _e825)) + (_e819 * _e819)) * _e834) * _e834) + 0.0001f))) * _e591) + (1f - _e591)), _e595), ((_e596 * 0.2820948f) + _e878), (((_e751 - _e752) * _e850) + _e885), (((_e813 - _e814) * _e850) + _e892), (((_e692 - _e693) * _e850) + _e899), (((((_e829 * _e831) - 0.33333334f) * _e596) * 1.5138805f) + _e906), (((((_e826 - _e827) * _e831) * _e596) * 0.8740393f) + _e913));
                } else {
                    phi_1398_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e917 = phi_1398_;
                local = array<f32, 11>(_e917[0], _e917[1], _e917[2], _e917[3], _e917[4], _e917[5], _e917[6], _e917[7], _e917[8], _e917[9], _e917[10]);
                phi_1413_ = type_11(0u, 11u);
                loop {
                    let _e931 = phi_1413_;
                    if (_e931.member < _e931.member_1) {
                        phi_1414_ = type_11((_e931.member + 1u), _e931.member_1);
                        phi_1437_ = type_11(1u, _e931.member);
                    } else {
                        phi_1414_ = _e931;
                        phi_1437_ = type_11(0u, type_11().member_1);
                    }
                    let _e944 = phi_1414_;
                    let _e946 = phi_1437_;
                    let _e950 = (bitcast<i32>(_e946.member) != 0i);
                    if _e950 {
                        if (_e946.member_1 < 11u) {
                        } else {
                            phi_1497_ = true;
                            break;
                        }
                        let _e953 = local[_e946.member_1];
                        let _e955 = ((_e946.member_1 * _e77) + _e89);
                        if (_e955 < arrayLength((&out.member))) {
                        } else {
                            phi_1497_ = true;
                            break;
                        }
                        out.member[_e955] = _e953;
                    }
                    continue;
                    continuing {
                        phi_1413_ = _e944;
                        phi_1497_ = false;
                        break if !(_e950);
                    }
                }
                let _e961 = phi_1497_;
                if _e961 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_propagate(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
