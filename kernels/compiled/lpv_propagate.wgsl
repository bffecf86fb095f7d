struct type_5 {
    member: array<f32>,
}

struct type_14 {
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

struct type_15 {
    member: type_14,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(3) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_15;
@group(0) @binding(1) 
var<storage> state: type_5;
@group(0) @binding(2) 
var<storage> opacity: type_5;

fn function_() {
    var phi_99_: u32;
    var phi_181_: bool;
    var phi_183_: bool;
    var phi_184_: bool;
    var phi_1154_: bool;
    var phi_1078_: array<f32, 11>;

    switch bitcast<i32>(0u) {
        default: {
            let _e50 = gid_1;
            let _e53 = params.member.member_2;
            let _e55 = (_e53.x + 1u);
            let _e57 = (_e53.y + 1u);
            let _e58 = (_e57 * _e55);
            let _e63 = ((_e58 + _e55) + ((_e53.z + 1u) * _e58));
            if (_e53.x > 0u) {
                if (_e55 == 0u) {
                    break;
                }
                phi_99_ = (3u * (_e63 / _e55));
            } else {
                phi_99_ = 0u;
            }
            let _e69 = phi_99_;
            let _e70 = (3u * _e63);
            let _e74 = (_e50.x + (_e50.y * 2097152u));
            if (_e74 < (_e69 * _e53.x)) {
                if (_e53.x == 0u) {
                    break;
                }
                let _e78 = (_e74 / _e53.x);
                let _e82 = ((_e78 * _e55) + (_e74 - (_e78 * _e53.x)));
                let _e83 = (_e55 == 0u);
                if _e83 {
                    break;
                }
                let _e84 = (_e63 / _e55);
                if (_e84 == 0u) {
                    break;
                }
                let _e86 = (_e78 / _e84);
                if _e83 {
                    break;
                }
                let _e88 = (_e78 - (_e86 * _e84));
                let _e89 = (_e53.y + 2u);
                let _e92 = (select(_e89, _e88, (_e89 < _e88)) - _e89);
                if (_e57 == 0u) {
                    break;
                }
                let _e94 = (_e92 / _e57);
                if (_e88 >= _e89) {
                    let _e98 = ((_e92 - (_e94 * _e57)) < _e53.y);
                    if _e98 {
                        phi_181_ = (_e94 < _e53.z);
                    } else {
                        phi_181_ = bool();
                    }
                    let _e101 = phi_181_;
                    phi_183_ = _e101;
                    phi_184_ = select(true, false, _e98);
                } else {
                    phi_183_ = bool();
                    phi_184_ = true;
                }
                let _e104 = phi_183_;
                let _e106 = phi_184_;
                if select(_e104, false, _e106) {
                    let _e109 = (_e82 - (_e86 * _e63));
                    let _e112 = opacity.member[_e109];
                    let _e115 = params.member.member_8;
                    let _e116 = -(_e115);
                    let _e117 = fma(_e112, _e116, 1f);
                    let _e121 = opacity.member[(_e109 - 1u)];
                    let _e122 = fma(_e121, _e116, 1f);
                    let _e123 = (_e63 + _e109);
                    let _e126 = opacity.member[_e123];
                    let _e127 = fma(_e126, _e116, 1f);
                    let _e131 = opacity.member[(_e123 - _e55)];
                    let _e132 = fma(_e131, _e116, 1f);
                    let _e134 = ((2u * _e63) + _e109);
                    let _e137 = opacity.member[_e134];
                    let _e138 = fma(_e137, _e116, 1f);
                    let _e142 = opacity.member[(_e134 - _e58)];
                    let _e143 = fma(_e142, _e116, 1f);
                    let _e147 = params.member.member_4[0u];
                    let _e148 = (_e147 * 0.4006697f);
                    let _e152 = params.member.member_4[1u];
                    let _e153 = (_e152 * 0.42343134f);
                    let _e157 = params.member.member_4[2u];
                    let _e158 = (_e157 * 0.42343134f);
                    let _e159 = (_e82 + 1u);
                    let _e163 = state.member[(_e159 + _e70)];
                    let _e164 = (_e63 * 6u);
                    let _e168 = state.member[(_e159 + _e164)];
                    let _e169 = (_e63 * 9u);
                    let _e173 = state.member[(_e159 + _e169)];
                    let _e174 = -(_e163);
                    let _e177 = state.member[_e159];
                    let _e178 = fma(_e174, 0.8944272f, _e177);
                    let _e179 = fma(_e168, 0.4472136f, _e178);
                    let _e181 = select(0f, _e179, (0f < _e179));
                    let _e182 = fma(_e168, -0.4472136f, _e178);
                    let _e184 = select(0f, _e182, (0f < _e182));
                    let _e185 = fma(_e173, 0.4472136f, _e178);
                    let _e187 = select(0f, _e185, (0f < _e185));
                    let _e188 = fma(_e173, -0.4472136f, _e178);
                    let _e190 = select(0f, _e188, (0f < _e188));
                    let _e191 = (_e177 + _e174);
                    let _e193 = select(0f, _e191, (0f < _e191));
                    let _e196 = ((_e181 + _e184) + (_e187 + _e190));
                    let _e199 = (_e63 * 12u);
                    let _e203 = state.member[(_e159 + _e199)];
                    let _e204 = (_e117 * _e203);
                    let _e212 = (_e204 * _e158);
                    let _e215 = (_e82 - 1u);
                    let _e219 = state.member[(_e215 + _e70)];
                    let _e223 = state.member[(_e215 + _e164)];
                    let _e227 = state.member[(_e215 + _e169)];
                    let _e230 = state.member[_e215];
                    let _e231 = fma(_e219, 0.8944272f, _e230);
                    let _e232 = fma(_e223, 0.4472136f, _e231);
                    let _e234 = select(0f, _e232, (0f < _e232));
                    let _e235 = fma(_e223, -0.4472136f, _e231);
                    let _e237 = select(0f, _e235, (0f < _e235));
                    let _e238 = fma(_e227, 0.4472136f, _e231);
                    let _e240 = select(0f, _e238, (0f < _e238));
                    let _e241 = fma(_e227, -0.4472136f, _e231);
                    let _e243 = select(0f, _e241, (0f < _e241));
                    let _e244 = (_e230 + _e219);
                    let _e246 = select(0f, _e244, (0f < _e244));
                    let _e249 = ((_e234 + _e237) + (_e240 + _e243));
                    let _e255 = state.member[(_e215 + _e199)];
                    let _e256 = (_e122 * _e255);
                    let _e263 = (_e256 * _e158);
                    let _e266 = (_e82 + _e55);
                    let _e270 = state.member[(_e266 + _e70)];
                    let _e274 = state.member[(_e266 + _e164)];
                    let _e278 = state.member[(_e266 + _e169)];
                    let _e279 = -(_e274);
                    let _e282 = state.member[_e266];
                    let _e283 = fma(_e279, 0.8944272f, _e282);
                    let _e284 = fma(_e278, 0.4472136f, _e283);
                    let _e286 = select(0f, _e284, (0f < _e284));
                    let _e287 = fma(_e278, -0.4472136f, _e283);
                    let _e289 = select(0f, _e287, (0f < _e287));
                    let _e290 = fma(_e270, 0.4472136f, _e283);
                    let _e292 = select(0f, _e290, (0f < _e290));
                    let _e293 = fma(_e270, -0.4472136f, _e283);
                    let _e295 = select(0f, _e293, (0f < _e293));
                    let _e296 = (_e282 + _e279);
                    let _e298 = select(0f, _e296, (0f < _e296));
                    let _e301 = ((_e286 + _e289) + (_e292 + _e295));
                    let _e307 = state.member[(_e266 + _e199)];
                    let _e308 = (_e127 * _e307);
                    let _e316 = (_e308 * _e158);
                    let _e319 = (_e82 - _e55);
                    let _e323 = state.member[(_e319 + _e70)];
                    let _e327 = state.member[(_e319 + _e164)];
                    let _e331 = state.member[(_e319 + _e169)];
                    let _e334 = state.member[_e319];
                    let _e335 = fma(_e327, 0.8944272f, _e334);
                    let _e336 = fma(_e331, 0.4472136f, _e335);
                    let _e338 = select(0f, _e336, (0f < _e336));
                    let _e339 = fma(_e331, -0.4472136f, _e335);
                    let _e341 = select(0f, _e339, (0f < _e339));
                    let _e342 = fma(_e323, 0.4472136f, _e335);
                    let _e344 = select(0f, _e342, (0f < _e342));
                    let _e345 = fma(_e323, -0.4472136f, _e335);
                    let _e347 = select(0f, _e345, (0f < _e345));
                    let _e348 = (_e334 + _e327);
                    let _e350 = select(0f, _e348, (0f < _e348));
                    let _e353 = ((_e338 + _e341) + (_e344 + _e347));
                    let _e359 = state.member[(_e319 + _e199)];
                    let _e360 = (_e132 * _e359);
                    let _e367 = (_e360 * _e158);
                    let _e370 = (_e82 + _e58);
                    let _e374 = state.member[(_e370 + _e70)];
                    let _e378 = state.member[(_e370 + _e164)];
                    let _e382 = state.member[(_e370 + _e169)];
                    let _e383 = -(_e382);
                    let _e386 = state.member[_e370];
                    let _e387 = fma(_e383, 0.8944272f, _e386);
                    let _e388 = fma(_e374, 0.4472136f, _e387);
                    let _e390 = select(0f, _e388, (0f < _e388));
                    let _e391 = fma(_e374, -0.4472136f, _e387);
                    let _e393 = select(0f, _e391, (0f < _e391));
                    let _e394 = fma(_e378, 0.4472136f, _e387);
                    let _e396 = select(0f, _e394, (0f < _e394));
                    let _e397 = fma(_e378, -0.4472136f, _e387);
                    let _e399 = select(0f, _e397, (0f < _e397));
                    let _e400 = (_e386 + _e383);
                    let _e402 = select(0f, _e400, (0f < _e400));
                    let _e405 = ((_e390 + _e393) + (_e396 + _e399));
                    let _e411 = state.member[(_e370 + _e199)];
                    let _e412 = (_e138 * _e411);
                    let _e420 = (_e412 * _e158);
                    let _e423 = (_e82 - _e58);
                    let _e427 = state.member[(_e423 + _e70)];
                    let _e431 = state.member[(_e423 + _e164)];
                    let _e435 = state.member[(_e423 + _e169)];
                    let _e438 = state.member[_e423];
                    let _e439 = fma(_e435, 0.8944272f, _e438);
                    let _e440 = fma(_e427, 0.4472136f, _e439);
                    let _e442 = select(0f, _e440, (0f < _e440));
                    let _e443 = fma(_e427, -0.4472136f, _e439);
                    let _e445 = select(0f, _e443, (0f < _e443));
                    let _e446 = fma(_e431, 0.4472136f, _e439);
                    let _e448 = select(0f, _e446, (0f < _e446));
                    let _e449 = fma(_e431, -0.4472136f, _e439);
                    let _e451 = select(0f, _e449, (0f < _e449));
                    let _e452 = (_e438 + _e435);
                    let _e454 = select(0f, _e452, (0f < _e452));
                    let _e457 = ((_e442 + _e445) + (_e448 + _e451));
                    let _e463 = state.member[(_e423 + _e199)];
                    let _e464 = (_e143 * _e463);
                    let _e467 = fma(fma(_e454, 0.4006697f, (_e457 * 0.42343134f)), _e143, fma(fma(_e402, 0.4006697f, (_e405 * 0.42343134f)), _e138, fma(fma(_e350, 0.4006697f, (_e353 * 0.42343134f)), _e132, fma(fma(_e298, 0.4006697f, (_e301 * 0.42343134f)), _e127, fma(fma(_e246, 0.4006697f, (_e249 * 0.42343134f)), _e122, fma(fma(_e193, 0.4006697f, (_e196 * 0.42343134f)), _e117, 0f))))));
                    let _e470 = fma(fma(_e454, _e148, (_e457 * _e153)), _e464, fma(fma(_e402, _e148, (_e405 * _e153)), -(_e412), fma((_e338 - _e341), _e367, fma((_e286 - _e289), _e316, fma((_e240 - _e243), _e263, fma((_e187 - _e190), _e212, 0f))))));
                    let _e471 = (_e464 * _e158);
                    let _e472 = fma((_e442 - _e445), _e471, fma((_e390 - _e393), _e420, fma((_e344 - _e347), _e367, fma((_e292 - _e295), _e316, fma(fma(_e246, _e148, (_e249 * _e153)), _e256, fma(fma(_e193, _e148, (_e196 * _e153)), -(_e204), 0f))))));
                    let _e473 = fma((_e448 - _e451), _e471, fma((_e396 - _e399), _e420, fma(fma(_e350, _e148, (_e353 * _e153)), _e360, fma(fma(_e298, _e148, (_e301 * _e153)), -(_e308), fma((_e234 - _e237), _e263, fma((_e181 - _e184), _e212, 0f))))));
                    let _e476 = params.member.member_9;
                    let _e480 = params.member.member_4[3u];
                    let _e483 = params.member.member_6;
                    let _e484 = (0.000000000000000001f < _e467);
                    let _e485 = select(0f, _e467, _e484);
                    let _e489 = sqrt(fma(_e470, _e470, fma(_e473, _e473, (_e472 * _e472))));
                    let _e490 = select(1f, _e485, _e484);
                    let _e492 = select(_e489, _e490, (_e489 < _e490));
                    let _e494 = (_e489 * (1f / _e492));
                    if (_e483 != _e483) {
                        phi_1154_ = true;
                    } else {
                        phi_1154_ = (0.33333334f >= _e483);
                    }
                    let _e498 = phi_1154_;
                    let _e499 = select(_e483, 0.33333334f, _e498);
                    let _e502 = fma(select(_e499, _e494, (_e494 < _e499)), -3f, 3f);
                    let _e505 = (0.31830987f / ((_e502 * _e502) * _e489));
                    let _e511 = (_e494 < select(2f, 0.33333334f, (_e483 > 0.33333334f)));
                    let _e512 = select(((_e502 - 1f) * (_e505 * _e489)), 0.07957747f, _e511);
                    let _e514 = select(_e505, (0.2387324f / _e492), _e511);
                    let _e515 = (_e472 * _e514);
                    let _e516 = (_e473 * _e514);
                    let _e517 = (_e470 * _e514);
                    let _e518 = fma(_e515, 0.8944272f, _e512);
                    let _e519 = fma(_e516, 0.4472136f, _e518);
                    let _e521 = select(0f, _e519, (0f < _e519));
                    let _e522 = fma(_e516, -0.4472136f, _e518);
                    let _e524 = select(0f, _e522, (0f < _e522));
                    let _e525 = fma(_e517, 0.4472136f, _e518);
                    let _e527 = select(0f, _e525, (0f < _e525));
                    let _e528 = fma(_e517, -0.4472136f, _e518);
                    let _e530 = select(0f, _e528, (0f < _e528));
                    let _e531 = (_e512 + _e515);
                    let _e533 = select(0f, _e531, (0f < _e531));
                    let _e536 = ((_e521 + _e524) + (_e527 + _e530));
                    let _e539 = -(_e515);
                    let _e540 = fma(_e539, 0.8944272f, _e512);
                    let _e541 = fma(_e516, 0.4472136f, _e540);
                    let _e543 = select(0f, _e541, (0f < _e541));
                    let _e544 = fma(_e516, -0.4472136f, _e540);
                    let _e546 = select(0f, _e544, (0f < _e544));
                    let _e547 = fma(_e517, 0.4472136f, _e540);
                    let _e549 = select(0f, _e547, (0f < _e547));
                    let _e550 = fma(_e517, -0.4472136f, _e540);
                    let _e552 = select(0f, _e550, (0f < _e550));
                    let _e553 = (_e512 + _e539);
                    let _e555 = select(0f, _e553, (0f < _e553));
                    let _e558 = ((_e543 + _e546) + (_e549 + _e552));
                    let _e562 = fma(_e533, 0.4006697f, (_e536 * 0.42343134f));
                    let _e564 = fma(_e555, 0.4006697f, (_e558 * 0.42343134f));
                    let _e571 = fma(_e516, 0.8944272f, _e512);
                    let _e572 = fma(_e517, 0.4472136f, _e571);
                    let _e574 = select(0f, _e572, (0f < _e572));
                    let _e575 = fma(_e517, -0.4472136f, _e571);
                    let _e577 = select(0f, _e575, (0f < _e575));
                    let _e578 = fma(_e515, 0.4472136f, _e571);
                    let _e580 = select(0f, _e578, (0f < _e578));
                    let _e581 = fma(_e515, -0.4472136f, _e571);
                    let _e583 = select(0f, _e581, (0f < _e581));
                    let _e584 = (_e512 + _e516);
                    let _e586 = select(0f, _e584, (0f < _e584));
                    let _e589 = ((_e574 + _e577) + (_e580 + _e583));
                    let _e592 = -(_e516);
                    let _e593 = fma(_e592, 0.8944272f, _e512);
                    let _e594 = fma(_e517, 0.4472136f, _e593);
                    let _e596 = select(0f, _e594, (0f < _e594));
                    let _e597 = fma(_e517, -0.4472136f, _e593);
                    let _e599 = select(0f, _e597, (0f < _e597));
                    let _e600 = fma(_e515, 0.4472136f, _e593);
                    let _e602 = select(0f, _e600, (0f < _e600));
                    let _e603 = fma(_e515, -0.4472136f, _e593);
                    let _e605 = select(0f, _e603, (0f < _e603));
                    let _e606 = (_e512 + _e592);
                    let _e608 = select(0f, _e606, (0f < _e606));
                    let _e611 = ((_e596 + _e599) + (_e602 + _e605));
                    let _e615 = fma(_e586, 0.4006697f, (_e589 * 0.42343134f));
                    let _e617 = fma(_e608, 0.4006697f, (_e611 * 0.42343134f));
                    let _e626 = fma(_e517, 0.8944272f, _e512);
                    let _e627 = fma(_e515, 0.4472136f, _e626);
                    let _e629 = select(0f, _e627, (0f < _e627));
                    let _e630 = fma(_e515, -0.4472136f, _e626);
                    let _e632 = select(0f, _e630, (0f < _e630));
                    let _e633 = fma(_e516, 0.4472136f, _e626);
                    let _e635 = select(0f, _e633, (0f < _e633));
                    let _e636 = fma(_e516, -0.4472136f, _e626);
                    let _e638 = select(0f, _e636, (0f < _e636));
                    let _e639 = (_e512 + _e517);
                    let _e641 = select(0f, _e639, (0f < _e639));
                    let _e644 = ((_e629 + _e632) + (_e635 + _e638));
                    let _e647 = -(_e517);
                    let _e648 = fma(_e647, 0.8944272f, _e512);
                    let _e649 = fma(_e515, 0.4472136f, _e648);
                    let _e651 = select(0f, _e649, (0f < _e649));
                    let _e652 = fma(_e515, -0.4472136f, _e648);
                    let _e654 = select(0f, _e652, (0f < _e652));
                    let _e655 = fma(_e516, 0.4472136f, _e648);
                    let _e657 = select(0f, _e655, (0f < _e655));
                    let _e658 = fma(_e516, -0.4472136f, _e648);
                    let _e660 = select(0f, _e658, (0f < _e658));
                    let _e661 = (_e512 + _e647);
                    let _e663 = select(0f, _e661, (0f < _e661));
                    let _e666 = ((_e651 + _e654) + (_e657 + _e660));
                    let _e670 = fma(_e641, 0.4006697f, (_e644 * 0.42343134f));
                    let _e672 = fma(_e663, 0.4006697f, (_e666 * 0.42343134f));
                    let _e681 = (_e562 + _e564);
                    let _e682 = (_e615 + _e617);
                    let _e684 = (_e670 + _e672);
                    let _e685 = ((_e681 + _e682) + _e684);
                    let _e686 = (((fma((_e533 - _e555), 2.1158676f, fma((_e536 - _e558), 2f, 0f)) + ((_e580 - _e583) + (_e602 - _e605))) + ((_e629 - _e632) + (_e651 - _e654))) * 0.18936425f);
                    let _e687 = ((fma((_e586 - _e608), 2.1158676f, fma((_e589 - _e611), 2f, ((_e521 - _e524) + (_e543 - _e546)))) + ((_e635 - _e638) + (_e657 - _e660))) * 0.18936425f);
                    let _e688 = (fma((_e641 - _e663), 2.1158676f, fma((_e644 - _e666), 2f, (((_e527 - _e530) + (_e549 - _e552)) + ((_e574 - _e577) + (_e596 - _e599))))) * 0.18936425f);
                    let _e689 = (_e485 / _e685);
                    let _e691 = fma(_e685, (1f - _e476), _e476);
                    let _e692 = (_e685 * _e685);
                    let _e705 = (_e689 * _e691);
                    let _e706 = (_e705 * _e514);
                    let _e712 = (_e494 < 0.33333334f);
                    let _e713 = (_e689 * 0.7329038f);
                    let _e733 = state.member[((_e63 * 15u) + _e82)];
                    let _e739 = state.member[((_e63 * 18u) + _e82)];
                    let _e745 = state.member[((_e63 * 21u) + _e82)];
                    let _e751 = state.member[((_e63 * 24u) + _e82)];
                    let _e757 = state.member[((_e63 * 27u) + _e82)];
                    let _e763 = state.member[((_e63 * 30u) + _e82)];
                    phi_1078_ = array<f32, 11>((_e705 * _e512), (_e472 * _e706), (_e473 * _e706), (_e470 * _e706), select(1f, fma(sqrt(((fma(_e494, _e494, 0.0001f) * _e692) / fma((fma(_e688, _e688, fma(_e687, _e687, (_e686 * _e686))) * _e691), _e691, (0.0001f * _e692)))), _e480, (1f - _e480)), _e484), ((_e485 * 0.2820948f) + _e733), (((_e615 - _e617) * _e713) + _e739), (((_e670 - _e672) * _e713) + _e745), (((_e562 - _e564) * _e713) + _e751), (select((fma(_e684, _e689, (_e485 * -0.33333334f)) * 1.5138805f), 0f, _e712) + _e757), (select(((_e681 - _e682) * (_e689 * 0.8740393f)), 0f, _e712) + _e763));
                } else {
                    phi_1078_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e767 = phi_1078_;
                out.member[_e82] = _e767[0];
                out.member[(_e70 + _e82)] = _e767[1];
                out.member[((_e63 * 6u) + _e82)] = _e767[2];
                out.member[((_e63 * 9u) + _e82)] = _e767[3];
                out.member[((_e63 * 12u) + _e82)] = _e767[4];
                out.member[((_e63 * 15u) + _e82)] = _e767[5];
                out.member[((_e63 * 18u) + _e82)] = _e767[6];
                out.member[((_e63 * 21u) + _e82)] = _e767[7];
                out.member[((_e63 * 24u) + _e82)] = _e767[8];
                out.member[((_e63 * 27u) + _e82)] = _e767[9];
                out.member[((_e63 * 30u) + _e82)] = _e767[10];
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
