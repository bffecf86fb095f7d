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
    member_17: vec4<f32>,
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
    var local: array<f32, 9>;
    var phi_98_: u32;
    var phi_180_: bool;
    var phi_182_: bool;
    var phi_183_: bool;
    var phi_1314_: array<f32, 9>;
    var phi_1327_: type_11;
    var phi_1328_: type_11;
    var phi_1351_: type_11;
    var phi_1380_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e42 = gid_1;
            let _e44 = arrayLength((&state.member));
            let _e46 = arrayLength((&opacity.member));
            let _e51 = params.member.member_2;
            let _e53 = (_e51.x + 1u);
            let _e55 = (_e51.y + 1u);
            let _e56 = (_e55 * _e53);
            let _e61 = ((_e56 + _e53) + ((_e51.z + 1u) * _e56));
            if (_e51.x > 0u) {
                if (_e53 == 0u) {
                    break;
                }
                phi_98_ = (3u * (_e61 / _e53));
            } else {
                phi_98_ = 0u;
            }
            let _e67 = phi_98_;
            let _e68 = (3u * _e61);
            let _e72 = (_e42.x + (_e42.y * 2097152u));
            if (_e72 < (_e67 * _e51.x)) {
                if (_e51.x == 0u) {
                    break;
                }
                let _e76 = (_e72 / _e51.x);
                let _e80 = ((_e76 * _e53) + (_e72 - (_e76 * _e51.x)));
                let _e81 = (_e53 == 0u);
                if _e81 {
                    break;
                }
                let _e82 = (_e61 / _e53);
                if (_e82 == 0u) {
                    break;
                }
                let _e84 = (_e76 / _e82);
                if _e81 {
                    break;
                }
                let _e86 = (_e76 - (_e84 * _e82));
                let _e87 = (_e51.y + 2u);
                let _e90 = (select(_e87, _e86, (_e87 < _e86)) - _e87);
                if (_e55 == 0u) {
                    break;
                }
                let _e92 = (_e90 / _e55);
                if (_e86 >= _e87) {
                    let _e96 = ((_e90 - (_e92 * _e55)) < _e51.y);
                    if _e96 {
                        phi_180_ = (_e92 < _e51.z);
                    } else {
                        phi_180_ = bool();
                    }
                    let _e99 = phi_180_;
                    phi_182_ = _e99;
                    phi_183_ = select(true, false, _e96);
                } else {
                    phi_182_ = bool();
                    phi_183_ = true;
                }
                let _e102 = phi_182_;
                let _e104 = phi_183_;
                if select(_e102, false, _e104) {
                    let _e107 = (_e80 - (_e84 * _e61));
                    if (_e107 < _e46) {
                    } else {
                        break;
                    }
                    let _e111 = opacity.member[_e107];
                    let _e114 = params.member.member_8;
                    let _e116 = (1f - (_e111 * _e114));
                    let _e117 = (_e107 - 1u);
                    if (_e117 < _e46) {
                    } else {
                        break;
                    }
                    let _e121 = opacity.member[_e117];
                    let _e123 = (1f - (_e121 * _e114));
                    let _e124 = (_e61 + _e107);
                    if (_e124 < _e46) {
                    } else {
                        break;
                    }
                    let _e128 = opacity.member[_e124];
                    let _e130 = (1f - (_e128 * _e114));
                    let _e131 = (_e124 - _e53);
                    if (_e131 < _e46) {
                    } else {
                        break;
                    }
                    let _e135 = opacity.member[_e131];
                    let _e137 = (1f - (_e135 * _e114));
                    let _e139 = ((2u * _e61) + _e107);
                    if (_e139 < _e46) {
                    } else {
                        break;
                    }
                    let _e143 = opacity.member[_e139];
                    let _e145 = (1f - (_e143 * _e114));
                    let _e146 = (_e139 - _e56);
                    if (_e146 < _e46) {
                    } else {
                        break;
                    }
                    let _e150 = opacity.member[_e146];
                    let _e152 = (1f - (_e150 * _e114));
                    let _e156 = params.member.member_4[0u];
                    let _e160 = params.member.member_4[1u];
                    let _e164 = params.member.member_4[2u];
                    let _e165 = (_e80 + 1u);
                    let _e166 = (_e165 + _e68);
                    if (_e166 < _e44) {
                    } else {
                        break;
                    }
                    let _e170 = state.member[_e166];
                    let _e171 = (_e61 * 6u);
                    let _e172 = (_e165 + _e171);
                    if (_e172 < _e44) {
                    } else {
                        break;
                    }
                    let _e176 = state.member[_e172];
                    let _e177 = (_e61 * 9u);
                    let _e178 = (_e165 + _e177);
                    if (_e178 < _e44) {
                    } else {
                        break;
                    }
                    let _e182 = state.member[_e178];
                    if (_e165 < _e44) {
                    } else {
                        break;
                    }
                    let _e187 = state.member[_e165];
                    let _e189 = (_e187 + (_e170 * -0.8944272f));
                    let _e190 = (_e176 * 0.4472136f);
                    let _e191 = (_e182 * 0.4472136f);
                    let _e192 = (_e189 + _e190);
                    let _e194 = select(0f, _e192, (0f < _e192));
                    let _e195 = (_e189 - _e190);
                    let _e197 = select(0f, _e195, (0f < _e195));
                    let _e198 = (_e189 + _e191);
                    let _e200 = select(0f, _e198, (0f < _e198));
                    let _e201 = (_e189 - _e191);
                    let _e203 = select(0f, _e201, (0f < _e201));
                    let _e204 = (_e187 + -(_e170));
                    let _e207 = (select(0f, _e204, (0f < _e204)) * 0.4006697f);
                    let _e211 = (((_e194 + _e197) + (_e200 + _e203)) * 0.42343134f);
                    let _e216 = (_e61 * 12u);
                    let _e217 = (_e165 + _e216);
                    if (_e217 < _e44) {
                    } else {
                        break;
                    }
                    let _e221 = state.member[_e217];
                    let _e222 = (_e116 * _e221);
                    let _e234 = (_e80 - 1u);
                    let _e235 = (_e234 + _e68);
                    if (_e235 < _e44) {
                    } else {
                        break;
                    }
                    let _e239 = state.member[_e235];
                    let _e240 = (_e234 + _e171);
                    if (_e240 < _e44) {
                    } else {
                        break;
                    }
                    let _e244 = state.member[_e240];
                    let _e245 = (_e234 + _e177);
                    if (_e245 < _e44) {
                    } else {
                        break;
                    }
                    let _e249 = state.member[_e245];
                    if (_e234 < _e44) {
                    } else {
                        break;
                    }
                    let _e253 = state.member[_e234];
                    let _e255 = (_e253 + (_e239 * 0.8944272f));
                    let _e256 = (_e244 * 0.4472136f);
                    let _e257 = (_e249 * 0.4472136f);
                    let _e258 = (_e255 + _e256);
                    let _e260 = select(0f, _e258, (0f < _e258));
                    let _e261 = (_e255 - _e256);
                    let _e263 = select(0f, _e261, (0f < _e261));
                    let _e264 = (_e255 + _e257);
                    let _e266 = select(0f, _e264, (0f < _e264));
                    let _e267 = (_e255 - _e257);
                    let _e269 = select(0f, _e267, (0f < _e267));
                    let _e270 = (_e253 + _e239);
                    let _e273 = (select(0f, _e270, (0f < _e270)) * 0.4006697f);
                    let _e277 = (((_e260 + _e263) + (_e266 + _e269)) * 0.42343134f);
                    let _e282 = (_e234 + _e216);
                    if (_e282 < _e44) {
                    } else {
                        break;
                    }
                    let _e286 = state.member[_e282];
                    let _e287 = (_e123 * _e286);
                    let _e302 = (_e80 + _e53);
                    let _e303 = (_e302 + _e68);
                    if (_e303 < _e44) {
                    } else {
                        break;
                    }
                    let _e307 = state.member[_e303];
                    let _e308 = (_e302 + _e171);
                    if (_e308 < _e44) {
                    } else {
                        break;
                    }
                    let _e312 = state.member[_e308];
                    let _e313 = (_e302 + _e177);
                    if (_e313 < _e44) {
                    } else {
                        break;
                    }
                    let _e317 = state.member[_e313];
                    if (_e302 < _e44) {
                    } else {
                        break;
                    }
                    let _e322 = state.member[_e302];
                    let _e324 = (_e322 + (_e312 * -0.8944272f));
                    let _e325 = (_e317 * 0.4472136f);
                    let _e326 = (_e307 * 0.4472136f);
                    let _e327 = (_e324 + _e325);
                    let _e329 = select(0f, _e327, (0f < _e327));
                    let _e330 = (_e324 - _e325);
                    let _e332 = select(0f, _e330, (0f < _e330));
                    let _e333 = (_e324 + _e326);
                    let _e335 = select(0f, _e333, (0f < _e333));
                    let _e336 = (_e324 - _e326);
                    let _e338 = select(0f, _e336, (0f < _e336));
                    let _e339 = (_e322 + -(_e312));
                    let _e342 = (select(0f, _e339, (0f < _e339)) * 0.4006697f);
                    let _e346 = (((_e329 + _e332) + (_e335 + _e338)) * 0.42343134f);
                    let _e351 = (_e302 + _e216);
                    if (_e351 < _e44) {
                    } else {
                        break;
                    }
                    let _e355 = state.member[_e351];
                    let _e356 = (_e130 * _e355);
                    let _e371 = (_e80 - _e53);
                    let _e372 = (_e371 + _e68);
                    if (_e372 < _e44) {
                    } else {
                        break;
                    }
                    let _e376 = state.member[_e372];
                    let _e377 = (_e371 + _e171);
                    if (_e377 < _e44) {
                    } else {
                        break;
                    }
                    let _e381 = state.member[_e377];
                    let _e382 = (_e371 + _e177);
                    if (_e382 < _e44) {
                    } else {
                        break;
                    }
                    let _e386 = state.member[_e382];
                    if (_e371 < _e44) {
                    } else {
                        break;
                    }
                    let _e390 = state.member[_e371];
                    let _e392 = (_e390 + (_e381 * 0.8944272f));
                    let _e393 = (_e386 * 0.4472136f);
                    let _e394 = (_e376 * 0.4472136f);
                    let _e395 = (_e392 + _e393);
                    let _e397 = select(0f, _e395, (0f < _e395));
                    let _e398 = (_e392 - _e393);
                    let _e400 = select(0f, _e398, (0f < _e398));
                    let _e401 = (_e392 + _e394);
                    let _e403 = select(0f, _e401, (0f < _e401));
                    let _e404 = (_e392 - _e394);
                    let _e406 = select(0f, _e404, (0f < _e404));
                    let _e407 = (_e390 + _e381);
                    let _e410 = (select(0f, _e407, (0f < _e407)) * 0.4006697f);
                    let _e414 = (((_e397 + _e400) + (_e403 + _e406)) * 0.42343134f);
                    let _e419 = (_e371 + _e216);
                    if (_e419 < _e44) {
                    } else {
                        break;
                    }
                    let _e423 = state.member[_e419];
                    let _e424 = (_e137 * _e423);
                    let _e439 = (_e80 + _e56);
                    let _e440 = (_e439 + _e68);
                    if (_e440 < _e44) {
                    } else {
                        break;
                    }
                    let _e444 = state.member[_e440];
                    let _e445 = (_e439 + _e171);
                    if (_e445 < _e44) {
                    } else {
                        break;
                    }
                    let _e449 = state.member[_e445];
                    let _e450 = (_e439 + _e177);
                    if (_e450 < _e44) {
                    } else {
                        break;
                    }
                    let _e454 = state.member[_e450];
                    if (_e439 < _e44) {
                    } else {
                        break;
                    }
                    let _e459 = state.member[_e439];
                    let _e461 = (_e459 + (_e454 * -0.8944272f));
                    let _e462 = (_e444 * 0.4472136f);
                    let _e463 = (_e449 * 0.4472136f);
                    let _e464 = (_e461 + _e462);
                    let _e466 = select(0f, _e464, (0f < _e464));
                    let _e467 = (_e461 - _e462);
                    let _e469 = select(0f, _e467, (0f < _e467));
                    let _e470 = (_e461 + _e463);
                    let _e472 = select(0f, _e470, (0f < _e470));
                    let _e473 = (_e461 - _e463);
                    let _e475 = select(0f, _e473, (0f < _e473));
                    let _e476 = (_e459 + -(_e454));
                    let _e479 = (select(0f, _e476, (0f < _e476)) * 0.4006697f);
                    let _e483 = (((_e466 + _e469) + (_e472 + _e475)) * 0.42343134f);
                    let _e488 = (_e439 + _e216);
                    if (_e488 < _e44) {
                    } else {
                        break;
                    }
                    let _e492 = state.member[_e488];
                    let _e493 = (_e145 * _e492);
                    let _e508 = (_e80 - _e56);
                    let _e509 = (_e508 + _e68);
                    if (_e509 < _e44) {
                    } else {
                        break;
                    }
                    let _e513 = state.member[_e509];
                    let _e514 = (_e508 + _e171);
                    if (_e514 < _e44) {
                    } else {
                        break;
                    }
                    let _e518 = state.member[_e514];
                    let _e519 = (_e508 + _e177);
                    if (_e519 < _e44) {
                    } else {
                        break;
                    }
                    let _e523 = state.member[_e519];
                    if (_e508 < _e44) {
                    } else {
                        break;
                    }
                    let _e527 = state.member[_e508];
                    let _e529 = (_e527 + (_e523 * 0.8944272f));
                    let _e530 = (_e513 * 0.4472136f);
                    let _e531 = (_e518 * 0.4472136f);
                    let _e532 = (_e529 + _e530);
                    let _e534 = select(0f, _e532, (0f < _e532));
                    let _e535 = (_e529 - _e530);
                    let _e537 = select(0f, _e535, (0f < _e535));
                    let _e538 = (_e529 + _e531);
                    let _e540 = select(0f, _e538, (0f < _e538));
                    let _e541 = (_e529 - _e531);
                    let _e543 = select(0f, _e541, (0f < _e541));
                    let _e544 = (_e527 + _e523);
                    let _e547 = (select(0f, _e544, (0f < _e544)) * 0.4006697f);
                    let _e551 = (((_e534 + _e537) + (_e540 + _e543)) * 0.42343134f);
                    let _e556 = (_e508 + _e216);
                    if (_e556 < _e44) {
                    } else {
                        break;
                    }
                    let _e560 = state.member[_e556];
                    let _e561 = (_e152 * _e560);
                    let _e564 = (((((((_e207 + _e211) * _e116) + ((_e273 + _e277) * _e123)) + ((_e342 + _e346) * _e130)) + ((_e410 + _e414) * _e137)) + ((_e479 + _e483) * _e145)) + ((_e547 + _e551) * _e152));
                    let _e578 = params.member.member_9;
                    let _e582 = params.member.member_4[3u];
                    let _e585 = params.member.member_6;
                    let _e586 = (0.000000000000000001f < _e564);
                    let _e587 = select(0f, _e564, _e586);
                    let _e589 = (1f / select(1f, _e587, _e586));
                    let _e590 = ((((((-((((_e207 * _e156) + (_e211 * _e160)) * _e222)) + (((_e273 * _e156) + (_e277 * _e160)) * _e287)) + ((((_e335 - _e338) * 0.42343134f) * _e164) * _e356)) + ((((_e403 - _e406) * 0.42343134f) * _e164) * _e424)) + ((((_e466 - _e469) * 0.42343134f) * _e164) * _e493)) + ((((_e534 - _e537) * 0.42343134f) * _e164) * _e561)) * _e589);
                    let _e591 = ((((((((((_e194 - _e197) * 0.42343134f) * _e164) * _e222) + ((((_e260 - _e263) * 0.42343134f) * _e164) * _e287)) - (((_e342 * _e156) + (_e346 * _e160)) * _e356)) + (((_e410 * _e156) + (_e414 * _e160)) * _e424)) + ((((_e472 - _e475) * 0.42343134f) * _e164) * _e493)) + ((((_e540 - _e543) * 0.42343134f) * _e164) * _e561)) * _e589);
                    let _e592 = ((((((((((_e200 - _e203) * 0.42343134f) * _e164) * _e222) + ((((_e266 - _e269) * 0.42343134f) * _e164) * _e287)) + ((((_e329 - _e332) * 0.42343134f) * _e164) * _e356)) + ((((_e397 - _e400) * 0.42343134f) * _e164) * _e424)) - (((_e479 * _e156) + (_e483 * _e160)) * _e493)) + (((_e547 * _e156) + (_e551 * _e160)) * _e561)) * _e589);
                    let _e597 = (((_e590 * _e590) + (_e591 * _e591)) + (_e592 * _e592));
                    let _e601 = (1f / sqrt(select(1f, _e597, (1f < _e597))));
                    let _e602 = (_e590 * _e601);
                    let _e603 = (_e591 * _e601);
                    let _e604 = (_e592 * _e601);
                    let _e607 = (0.2387324f * _e585);
                    let _e608 = (_e602 * _e607);
                    let _e609 = (_e603 * _e607);
                    let _e610 = (_e604 * _e607);
                    let _e612 = (0.07957747f + (_e608 * 0.8944272f));
                    let _e613 = (_e609 * 0.4472136f);
                    let _e614 = (_e610 * 0.4472136f);
                    let _e615 = (_e612 + _e613);
                    let _e617 = select(0f, _e615, (0f < _e615));
                    let _e618 = (_e612 - _e613);
                    let _e620 = select(0f, _e618, (0f < _e618));
                    let _e621 = (_e612 + _e614);
                    let _e623 = select(0f, _e621, (0f < _e621));
                    let _e624 = (_e612 - _e614);
                    let _e626 = select(0f, _e624, (0f < _e624));
                    let _e627 = (0.07957747f + _e608);
                    let _e630 = (select(0f, _e627, (0f < _e627)) * 0.4006697f);
                    let _e634 = (((_e617 + _e620) + (_e623 + _e626)) * 0.42343134f);
                    let _e638 = (0.07957747f + (_e608 * -0.8944272f));
                    let _e639 = (_e638 + _e613);
                    let _e641 = select(0f, _e639, (0f < _e639));
                    let _e642 = (_e638 - _e613);
                    let _e644 = select(0f, _e642, (0f < _e642));
                    let _e645 = (_e638 + _e614);
                    let _e647 = select(0f, _e645, (0f < _e645));
                    let _e648 = (_e638 - _e614);
                    let _e650 = select(0f, _e648, (0f < _e648));
                    let _e651 = (0.07957747f - _e608);
                    let _e654 = (select(0f, _e651, (0f < _e651)) * 0.4006697f);
                    let _e658 = (((_e641 + _e644) + (_e647 + _e650)) * 0.42343134f);
                    let _e661 = (_e630 + _e634);
                    let _e662 = (_e654 + _e658);
                    let _e671 = (0.07957747f + (_e609 * 0.8944272f));
                    let _e672 = (_e608 * 0.4472136f);
                    let _e673 = (_e671 + _e614);
                    let _e675 = select(0f, _e673, (0f < _e673));
                    let _e676 = (_e671 - _e614);
                    let _e678 = select(0f, _e676, (0f < _e676));
                    let _e679 = (_e671 + _e672);
                    let _e681 = select(0f, _e679, (0f < _e679));
                    let _e682 = (_e671 - _e672);
                    let _e684 = select(0f, _e682, (0f < _e682));
                    let _e685 = (0.07957747f + _e609);
                    let _e688 = (select(0f, _e685, (0f < _e685)) * 0.4006697f);
                    let _e692 = (((_e675 + _e678) + (_e681 + _e684)) * 0.42343134f);
                    let _e696 = (0.07957747f + (_e609 * -0.8944272f));
                    let _e697 = (_e696 + _e614);
                    let _e699 = select(0f, _e697, (0f < _e697));
                    let _e700 = (_e696 - _e614);
                    let _e702 = select(0f, _e700, (0f < _e700));
                    let _e703 = (_e696 + _e672);
                    let _e705 = select(0f, _e703, (0f < _e703));
                    let _e706 = (_e696 - _e672);
                    let _e708 = select(0f, _e706, (0f < _e706));
                    let _e709 = (0.07957747f - _e609);
                    let _e712 = (select(0f, _e709, (0f < _e709)) * 0.4006697f);
                    let _e716 = (((_e699 + _e702) + (_e705 + _e708)) * 0.42343134f);
                    let _e719 = (_e688 + _e692);
                    let _e720 = (_e712 + _e716);
                    let _e733 = (0.07957747f + (_e610 * 0.8944272f));
                    let _e734 = (_e733 + _e672);
                    let _e736 = select(0f, _e734, (0f < _e734));
                    let _e737 = (_e733 - _e672);
                    let _e739 = select(0f, _e737, (0f < _e737));
                    let _e740 = (_e733 + _e613);
                    let _e742 = select(0f, _e740, (0f < _e740));
                    let _e743 = (_e733 - _e613);
                    let _e745 = select(0f, _e743, (0f < _e743));
                    let _e746 = (0.07957747f + _e610);
                    let _e749 = (select(0f, _e746, (0f < _e746)) * 0.4006697f);
                    let _e753 = (((_e736 + _e739) + (_e742 + _e745)) * 0.42343134f);
                    let _e757 = (0.07957747f + (_e610 * -0.8944272f));
                    let _e758 = (_e757 + _e672);
                    let _e760 = select(0f, _e758, (0f < _e758));
                    let _e761 = (_e757 - _e672);
                    let _e763 = select(0f, _e761, (0f < _e761));
                    let _e764 = (_e757 + _e613);
                    let _e766 = select(0f, _e764, (0f < _e764));
                    let _e767 = (_e757 - _e613);
                    let _e769 = select(0f, _e767, (0f < _e767));
                    let _e770 = (0.07957747f - _e610);
                    let _e773 = (select(0f, _e770, (0f < _e770)) * 0.4006697f);
                    let _e777 = (((_e760 + _e763) + (_e766 + _e769)) * 0.42343134f);
                    let _e780 = (_e749 + _e753);
                    let _e781 = (_e773 + _e777);
                    let _e786 = (((0.18936425f * (((_e623 - _e626) + (_e647 - _e650)) + ((_e675 - _e678) + (_e699 - _e702)))) + (_e749 - _e773)) + ((_e753 - _e777) * 0.8944272f));
                    let _e789 = ((((_e630 - _e654) + ((_e634 - _e658) * 0.8944272f)) + (((_e681 - _e684) + (_e705 - _e708)) * 0.18936425f)) + (((_e736 - _e739) + (_e760 - _e763)) * 0.18936425f));
                    let _e792 = ((((((_e617 - _e620) + (_e641 - _e644)) * 0.18936425f) + (_e688 - _e712)) + ((_e692 - _e716) * 0.8944272f)) + (((_e742 - _e745) + (_e766 - _e769)) * 0.18936425f));
                    let _e798 = (1f / (((_e661 + _e662) + (_e719 + _e720)) + (_e780 + _e781)));
                    let _e801 = ((_e798 * _e578) + (1f - _e578));
                    let _e813 = (_e587 * _e801);
                    let _e815 = (_e813 * _e607);
                    let _e817 = ((_e587 * _e798) * 0.7329038f);
                    let _e833 = ((_e61 * 15u) + _e80);
                    if (_e833 < _e44) {
                    } else {
                        break;
                    }
                    let _e837 = state.member[_e833];
                    let _e840 = ((_e61 * 18u) + _e80);
                    if (_e840 < _e44) {
                    } else {
                        break;
                    }
                    let _e844 = state.member[_e840];
                    let _e847 = ((_e61 * 21u) + _e80);
                    if (_e847 < _e44) {
                    } else {
                        break;
                    }
                    let _e851 = state.member[_e847];
                    let _e854 = ((_e61 * 24u) + _e80);
                    if (_e854 < _e44) {
                    } else {
                        break;
                    }
                    let _e858 = state.member[_e854];
                    phi_1314_ = array<f32, 9>((_e813 * 0.07957747f), (_e602 * _e815), (_e603 * _e815), (_e604 * _e815), select(1f, ((sqrt(((((_e597 * _e601) * _e601) + 0.0001f) / ((((((_e789 * _e789) + (_e792 * _e792)) + (_e786 * _e786)) * _e801) * _e801) + 0.0001f))) * _e582) + (1f - _e582)), _e586), ((_e587 * 0.2820948f) + _e837), (((_e719 - _e720) * _e817) + _e844), (((_e780 - _e781) * _e817) + _e851), (((_e661 - _e662) * _e817) + _e858));
                } else {
                    phi_1314_ = array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e862 = phi_1314_;
                local = array<f32, 9>(_e862[0], _e862[1], _e862[2], _e862[3], _e862[4], _e862[5], _e862[6], _e862[7], _e862[8]);
                phi_1327_ = type_11(0u, 9u);
                loop {
                    let _e874 = phi_1327_;
                    if (_e874.member < _e874.member_1) {
                        phi_1328_ = type_11((_e874.member + 1u), _e874.member_1);
                        phi_1351_ = type_11(1u, _e874.member);
                    } else {
                        phi_1328_ = _e874;
                        phi_1351_ = type_11(0u, type_11().member_1);
                    }
                    let _e887 = phi_1328_;
                    let _e889 = phi_1351_;
                    let _e893 = (bitcast<i32>(_e889.member) != 0i);
                    if _e893 {
                        if (_e889.member_1 < 9u) {
                        } else {
                            phi_1380_ = true;
                            break;
                        }
                        let _e896 = local[_e889.member_1];
                        let _e898 = ((_e889.member_1 * _e68) + _e80);
                        if (_e898 < arrayLength((&out.member))) {
                        } else {
                            phi_1380_ = true;
                            break;
                        }
                        out.member[_e898] = _e896;
                    }
                    continue;
                    continuing {
                        phi_1327_ = _e887;
                        phi_1380_ = false;
                        break if !(_e893);
                    }
                }
                let _e904 = phi_1380_;
                if _e904 {
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
