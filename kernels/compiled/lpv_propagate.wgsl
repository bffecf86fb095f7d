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
    var phi_96_: u32;
    var phi_178_: bool;
    var phi_180_: bool;
    var phi_181_: bool;
    var phi_1254_: bool;
    var phi_1178_: array<f32, 11>;

    switch bitcast<i32>(0u) {
        default: {
            let _e47 = gid_1;
            let _e50 = params.member.member_2;
            let _e52 = (_e50.x + 1u);
            let _e54 = (_e50.y + 1u);
            let _e55 = (_e54 * _e52);
            let _e60 = ((_e55 + _e52) + ((_e50.z + 1u) * _e55));
            if (_e50.x > 0u) {
                if (_e52 == 0u) {
                    break;
                }
                phi_96_ = (3u * (_e60 / _e52));
            } else {
                phi_96_ = 0u;
            }
            let _e66 = phi_96_;
            let _e67 = (3u * _e60);
            let _e71 = (_e47.x + (_e47.y * 2097152u));
            if (_e71 < (_e66 * _e50.x)) {
                if (_e50.x == 0u) {
                    break;
                }
                let _e75 = (_e71 / _e50.x);
                let _e79 = ((_e75 * _e52) + (_e71 - (_e75 * _e50.x)));
                let _e80 = (_e52 == 0u);
                if _e80 {
                    break;
                }
                let _e81 = (_e60 / _e52);
                if (_e81 == 0u) {
                    break;
                }
                let _e83 = (_e75 / _e81);
                if _e80 {
                    break;
                }
                let _e85 = (_e75 - (_e83 * _e81));
                let _e86 = (_e50.y + 2u);
                let _e89 = (select(_e86, _e85, (_e86 < _e85)) - _e86);
                if (_e54 == 0u) {
                    break;
                }
                let _e91 = (_e89 / _e54);
                if (_e85 >= _e86) {
                    let _e95 = ((_e89 - (_e91 * _e54)) < _e50.y);
                    if _e95 {
                        phi_178_ = (_e91 < _e50.z);
                    } else {
                        phi_178_ = bool();
                    }
                    let _e98 = phi_178_;
                    phi_180_ = _e98;
                    phi_181_ = select(true, false, _e95);
                } else {
                    phi_180_ = bool();
                    phi_181_ = true;
                }
                let _e101 = phi_180_;
                let _e103 = phi_181_;
                if select(_e101, false, _e103) {
                    let _e106 = (_e79 - (_e83 * _e60));
                    let _e109 = opacity.member[_e106];
                    let _e112 = params.member.member_8;
                    let _e114 = (1f - (_e109 * _e112));
                    let _e118 = opacity.member[(_e106 - 1u)];
                    let _e120 = (1f - (_e118 * _e112));
                    let _e121 = (_e60 + _e106);
                    let _e124 = opacity.member[_e121];
                    let _e126 = (1f - (_e124 * _e112));
                    let _e130 = opacity.member[(_e121 - _e52)];
                    let _e132 = (1f - (_e130 * _e112));
                    let _e134 = ((2u * _e60) + _e106);
                    let _e137 = opacity.member[_e134];
                    let _e139 = (1f - (_e137 * _e112));
                    let _e143 = opacity.member[(_e134 - _e55)];
                    let _e145 = (1f - (_e143 * _e112));
                    let _e149 = params.member.member_4[0u];
                    let _e153 = params.member.member_4[1u];
                    let _e157 = params.member.member_4[2u];
                    let _e158 = (_e79 + 1u);
                    let _e162 = state.member[(_e158 + _e67)];
                    let _e163 = (_e60 * 6u);
                    let _e167 = state.member[(_e158 + _e163)];
                    let _e168 = (_e60 * 9u);
                    let _e172 = state.member[(_e158 + _e168)];
                    let _e176 = state.member[_e158];
                    let _e178 = (_e176 + (_e162 * -0.8944272f));
                    let _e179 = (_e167 * 0.4472136f);
                    let _e180 = (_e172 * 0.4472136f);
                    let _e181 = (_e178 + _e179);
                    let _e183 = select(0f, _e181, (0f < _e181));
                    let _e184 = (_e178 - _e179);
                    let _e186 = select(0f, _e184, (0f < _e184));
                    let _e187 = (_e178 + _e180);
                    let _e189 = select(0f, _e187, (0f < _e187));
                    let _e190 = (_e178 - _e180);
                    let _e192 = select(0f, _e190, (0f < _e190));
                    let _e193 = (_e176 + -(_e162));
                    let _e196 = (select(0f, _e193, (0f < _e193)) * 0.4006697f);
                    let _e200 = (((_e183 + _e186) + (_e189 + _e192)) * 0.42343134f);
                    let _e205 = (_e60 * 12u);
                    let _e209 = state.member[(_e158 + _e205)];
                    let _e210 = (_e114 * _e209);
                    let _e222 = (_e79 - 1u);
                    let _e226 = state.member[(_e222 + _e67)];
                    let _e230 = state.member[(_e222 + _e163)];
                    let _e234 = state.member[(_e222 + _e168)];
                    let _e237 = state.member[_e222];
                    let _e239 = (_e237 + (_e226 * 0.8944272f));
                    let _e240 = (_e230 * 0.4472136f);
                    let _e241 = (_e234 * 0.4472136f);
                    let _e242 = (_e239 + _e240);
                    let _e244 = select(0f, _e242, (0f < _e242));
                    let _e245 = (_e239 - _e240);
                    let _e247 = select(0f, _e245, (0f < _e245));
                    let _e248 = (_e239 + _e241);
                    let _e250 = select(0f, _e248, (0f < _e248));
                    let _e251 = (_e239 - _e241);
                    let _e253 = select(0f, _e251, (0f < _e251));
                    let _e254 = (_e237 + _e226);
                    let _e257 = (select(0f, _e254, (0f < _e254)) * 0.4006697f);
                    let _e261 = (((_e244 + _e247) + (_e250 + _e253)) * 0.42343134f);
                    let _e269 = state.member[(_e222 + _e205)];
                    let _e270 = (_e120 * _e269);
                    let _e285 = (_e79 + _e52);
                    let _e289 = state.member[(_e285 + _e67)];
                    let _e293 = state.member[(_e285 + _e163)];
                    let _e297 = state.member[(_e285 + _e168)];
                    let _e301 = state.member[_e285];
                    let _e303 = (_e301 + (_e293 * -0.8944272f));
                    let _e304 = (_e297 * 0.4472136f);
                    let _e305 = (_e289 * 0.4472136f);
                    let _e306 = (_e303 + _e304);
                    let _e308 = select(0f, _e306, (0f < _e306));
                    let _e309 = (_e303 - _e304);
                    let _e311 = select(0f, _e309, (0f < _e309));
                    let _e312 = (_e303 + _e305);
                    let _e314 = select(0f, _e312, (0f < _e312));
                    let _e315 = (_e303 - _e305);
                    let _e317 = select(0f, _e315, (0f < _e315));
                    let _e318 = (_e301 + -(_e293));
                    let _e321 = (select(0f, _e318, (0f < _e318)) * 0.4006697f);
                    let _e325 = (((_e308 + _e311) + (_e314 + _e317)) * 0.42343134f);
                    let _e333 = state.member[(_e285 + _e205)];
                    let _e334 = (_e126 * _e333);
                    let _e349 = (_e79 - _e52);
                    let _e353 = state.member[(_e349 + _e67)];
                    let _e357 = state.member[(_e349 + _e163)];
                    let _e361 = state.member[(_e349 + _e168)];
                    let _e364 = state.member[_e349];
                    let _e366 = (_e364 + (_e357 * 0.8944272f));
                    let _e367 = (_e361 * 0.4472136f);
                    let _e368 = (_e353 * 0.4472136f);
                    let _e369 = (_e366 + _e367);
                    let _e371 = select(0f, _e369, (0f < _e369));
                    let _e372 = (_e366 - _e367);
                    let _e374 = select(0f, _e372, (0f < _e372));
                    let _e375 = (_e366 + _e368);
                    let _e377 = select(0f, _e375, (0f < _e375));
                    let _e378 = (_e366 - _e368);
                    let _e380 = select(0f, _e378, (0f < _e378));
                    let _e381 = (_e364 + _e357);
                    let _e384 = (select(0f, _e381, (0f < _e381)) * 0.4006697f);
                    let _e388 = (((_e371 + _e374) + (_e377 + _e380)) * 0.42343134f);
                    let _e396 = state.member[(_e349 + _e205)];
                    let _e397 = (_e132 * _e396);
                    let _e412 = (_e79 + _e55);
                    let _e416 = state.member[(_e412 + _e67)];
                    let _e420 = state.member[(_e412 + _e163)];
                    let _e424 = state.member[(_e412 + _e168)];
                    let _e428 = state.member[_e412];
                    let _e430 = (_e428 + (_e424 * -0.8944272f));
                    let _e431 = (_e416 * 0.4472136f);
                    let _e432 = (_e420 * 0.4472136f);
                    let _e433 = (_e430 + _e431);
                    let _e435 = select(0f, _e433, (0f < _e433));
                    let _e436 = (_e430 - _e431);
                    let _e438 = select(0f, _e436, (0f < _e436));
                    let _e439 = (_e430 + _e432);
                    let _e441 = select(0f, _e439, (0f < _e439));
                    let _e442 = (_e430 - _e432);
                    let _e444 = select(0f, _e442, (0f < _e442));
                    let _e445 = (_e428 + -(_e424));
                    let _e448 = (select(0f, _e445, (0f < _e445)) * 0.4006697f);
                    let _e452 = (((_e435 + _e438) + (_e441 + _e444)) * 0.42343134f);
                    let _e460 = state.member[(_e412 + _e205)];
                    let _e461 = (_e139 * _e460);
                    let _e476 = (_e79 - _e55);
                    let _e480 = state.member[(_e476 + _e67)];
                    let _e484 = state.member[(_e476 + _e163)];
                    let _e488 = state.member[(_e476 + _e168)];
                    let _e491 = state.member[_e476];
                    let _e493 = (_e491 + (_e488 * 0.8944272f));
                    let _e494 = (_e480 * 0.4472136f);
                    let _e495 = (_e484 * 0.4472136f);
                    let _e496 = (_e493 + _e494);
                    let _e498 = select(0f, _e496, (0f < _e496));
                    let _e499 = (_e493 - _e494);
                    let _e501 = select(0f, _e499, (0f < _e499));
                    let _e502 = (_e493 + _e495);
                    let _e504 = select(0f, _e502, (0f < _e502));
                    let _e505 = (_e493 - _e495);
                    let _e507 = select(0f, _e505, (0f < _e505));
                    let _e508 = (_e491 + _e488);
                    let _e511 = (select(0f, _e508, (0f < _e508)) * 0.4006697f);
                    let _e515 = (((_e498 + _e501) + (_e504 + _e507)) * 0.42343134f);
                    let _e523 = state.member[(_e476 + _e205)];
                    let _e524 = (_e145 * _e523);
                    let _e527 = (((((((_e196 + _e200) * _e114) + ((_e257 + _e261) * _e120)) + ((_e321 + _e325) * _e126)) + ((_e384 + _e388) * _e132)) + ((_e448 + _e452) * _e139)) + ((_e511 + _e515) * _e145));
                    let _e541 = params.member.member_9;
                    let _e545 = params.member.member_4[3u];
                    let _e548 = params.member.member_6;
                    let _e549 = (0.000000000000000001f < _e527);
                    let _e550 = select(0f, _e527, _e549);
                    let _e552 = (1f / select(1f, _e550, _e549));
                    let _e553 = ((((((-((((_e196 * _e149) + (_e200 * _e153)) * _e210)) + (((_e257 * _e149) + (_e261 * _e153)) * _e270)) + ((((_e314 - _e317) * 0.42343134f) * _e157) * _e334)) + ((((_e377 - _e380) * 0.42343134f) * _e157) * _e397)) + ((((_e435 - _e438) * 0.42343134f) * _e157) * _e461)) + ((((_e498 - _e501) * 0.42343134f) * _e157) * _e524)) * _e552);
                    let _e554 = ((((((((((_e183 - _e186) * 0.42343134f) * _e157) * _e210) + ((((_e244 - _e247) * 0.42343134f) * _e157) * _e270)) - (((_e321 * _e149) + (_e325 * _e153)) * _e334)) + (((_e384 * _e149) + (_e388 * _e153)) * _e397)) + ((((_e441 - _e444) * 0.42343134f) * _e157) * _e461)) + ((((_e504 - _e507) * 0.42343134f) * _e157) * _e524)) * _e552);
                    let _e555 = ((((((((((_e189 - _e192) * 0.42343134f) * _e157) * _e210) + ((((_e250 - _e253) * 0.42343134f) * _e157) * _e270)) + ((((_e308 - _e311) * 0.42343134f) * _e157) * _e334)) + ((((_e371 - _e374) * 0.42343134f) * _e157) * _e397)) - (((_e448 * _e149) + (_e452 * _e153)) * _e461)) + (((_e511 * _e149) + (_e515 * _e153)) * _e524)) * _e552);
                    let _e560 = (((_e553 * _e553) + (_e554 * _e554)) + (_e555 * _e555));
                    let _e564 = (1f / sqrt(select(1f, _e560, (1f < _e560))));
                    let _e565 = (_e553 * _e564);
                    let _e566 = (_e554 * _e564);
                    let _e567 = (_e555 * _e564);
                    let _e569 = ((_e560 * _e564) * _e564);
                    let _e570 = sqrt(_e569);
                    if (_e548 != _e548) {
                        phi_1254_ = true;
                    } else {
                        phi_1254_ = (0.33333334f >= _e548);
                    }
                    let _e574 = phi_1254_;
                    let _e575 = select(_e548, 0.33333334f, _e574);
                    let _e578 = (3f * select(_e575, _e570, (_e570 < _e575)));
                    let _e580 = (3f - _e578);
                    let _e582 = (0.31830987f / (_e580 * _e580));
                    let _e585 = (_e570 < select(2f, 0.33333334f, (_e548 > 0.33333334f)));
                    let _e590 = select(((2f - _e578) * _e582), 0.07957747f, _e585);
                    let _e591 = select((_e582 / select(0.33333334f, _e570, (0.33333334f < _e570))), 0.2387324f, _e585);
                    let _e592 = (_e565 * _e591);
                    let _e593 = (_e566 * _e591);
                    let _e594 = (_e567 * _e591);
                    let _e596 = (_e590 + (_e592 * 0.8944272f));
                    let _e597 = (_e593 * 0.4472136f);
                    let _e598 = (_e594 * 0.4472136f);
                    let _e599 = (_e596 + _e597);
                    let _e601 = select(0f, _e599, (0f < _e599));
                    let _e602 = (_e596 - _e597);
                    let _e604 = select(0f, _e602, (0f < _e602));
                    let _e605 = (_e596 + _e598);
                    let _e607 = select(0f, _e605, (0f < _e605));
                    let _e608 = (_e596 - _e598);
                    let _e610 = select(0f, _e608, (0f < _e608));
                    let _e611 = (_e590 + _e592);
                    let _e614 = (select(0f, _e611, (0f < _e611)) * 0.4006697f);
                    let _e618 = (((_e601 + _e604) + (_e607 + _e610)) * 0.42343134f);
                    let _e623 = (_e590 + (_e592 * -0.8944272f));
                    let _e624 = (_e623 + _e597);
                    let _e626 = select(0f, _e624, (0f < _e624));
                    let _e627 = (_e623 - _e597);
                    let _e629 = select(0f, _e627, (0f < _e627));
                    let _e630 = (_e623 + _e598);
                    let _e632 = select(0f, _e630, (0f < _e630));
                    let _e633 = (_e623 - _e598);
                    let _e635 = select(0f, _e633, (0f < _e633));
                    let _e636 = (_e590 + -(_e592));
                    let _e639 = (select(0f, _e636, (0f < _e636)) * 0.4006697f);
                    let _e643 = (((_e626 + _e629) + (_e632 + _e635)) * 0.42343134f);
                    let _e646 = (_e614 + _e618);
                    let _e647 = (_e639 + _e643);
                    let _e656 = (_e590 + (_e593 * 0.8944272f));
                    let _e657 = (_e592 * 0.4472136f);
                    let _e658 = (_e656 + _e598);
                    let _e660 = select(0f, _e658, (0f < _e658));
                    let _e661 = (_e656 - _e598);
                    let _e663 = select(0f, _e661, (0f < _e661));
                    let _e664 = (_e656 + _e657);
                    let _e666 = select(0f, _e664, (0f < _e664));
                    let _e667 = (_e656 - _e657);
                    let _e669 = select(0f, _e667, (0f < _e667));
                    let _e670 = (_e590 + _e593);
                    let _e673 = (select(0f, _e670, (0f < _e670)) * 0.4006697f);
                    let _e677 = (((_e660 + _e663) + (_e666 + _e669)) * 0.42343134f);
                    let _e682 = (_e590 + (_e593 * -0.8944272f));
                    let _e683 = (_e682 + _e598);
                    let _e685 = select(0f, _e683, (0f < _e683));
                    let _e686 = (_e682 - _e598);
                    let _e688 = select(0f, _e686, (0f < _e686));
                    let _e689 = (_e682 + _e657);
                    let _e691 = select(0f, _e689, (0f < _e689));
                    let _e692 = (_e682 - _e657);
                    let _e694 = select(0f, _e692, (0f < _e692));
                    let _e695 = (_e590 + -(_e593));
                    let _e698 = (select(0f, _e695, (0f < _e695)) * 0.4006697f);
                    let _e702 = (((_e685 + _e688) + (_e691 + _e694)) * 0.42343134f);
                    let _e705 = (_e673 + _e677);
                    let _e706 = (_e698 + _e702);
                    let _e719 = (_e590 + (_e594 * 0.8944272f));
                    let _e720 = (_e719 + _e657);
                    let _e722 = select(0f, _e720, (0f < _e720));
                    let _e723 = (_e719 - _e657);
                    let _e725 = select(0f, _e723, (0f < _e723));
                    let _e726 = (_e719 + _e597);
                    let _e728 = select(0f, _e726, (0f < _e726));
                    let _e729 = (_e719 - _e597);
                    let _e731 = select(0f, _e729, (0f < _e729));
                    let _e732 = (_e590 + _e594);
                    let _e735 = (select(0f, _e732, (0f < _e732)) * 0.4006697f);
                    let _e739 = (((_e722 + _e725) + (_e728 + _e731)) * 0.42343134f);
                    let _e744 = (_e590 + (_e594 * -0.8944272f));
                    let _e745 = (_e744 + _e657);
                    let _e747 = select(0f, _e745, (0f < _e745));
                    let _e748 = (_e744 - _e657);
                    let _e750 = select(0f, _e748, (0f < _e748));
                    let _e751 = (_e744 + _e597);
                    let _e753 = select(0f, _e751, (0f < _e751));
                    let _e754 = (_e744 - _e597);
                    let _e756 = select(0f, _e754, (0f < _e754));
                    let _e757 = (_e590 + -(_e594));
                    let _e760 = (select(0f, _e757, (0f < _e757)) * 0.4006697f);
                    let _e764 = (((_e747 + _e750) + (_e753 + _e756)) * 0.42343134f);
                    let _e767 = (_e735 + _e739);
                    let _e768 = (_e760 + _e764);
                    let _e773 = (((0.18936425f * (((_e607 - _e610) + (_e632 - _e635)) + ((_e660 - _e663) + (_e685 - _e688)))) + (_e735 - _e760)) + ((_e739 - _e764) * 0.8944272f));
                    let _e776 = ((((_e614 - _e639) + ((_e618 - _e643) * 0.8944272f)) + (((_e666 - _e669) + (_e691 - _e694)) * 0.18936425f)) + (((_e722 - _e725) + (_e747 - _e750)) * 0.18936425f));
                    let _e779 = ((((((_e601 - _e604) + (_e626 - _e629)) * 0.18936425f) + (_e673 - _e698)) + ((_e677 - _e702) * 0.8944272f)) + (((_e728 - _e731) + (_e753 - _e756)) * 0.18936425f));
                    let _e780 = (_e646 + _e647);
                    let _e781 = (_e705 + _e706);
                    let _e783 = (_e767 + _e768);
                    let _e785 = (1f / ((_e780 + _e781) + _e783));
                    let _e788 = ((_e785 * _e541) + (1f - _e541));
                    let _e800 = (_e550 * _e788);
                    let _e802 = (_e800 * _e591);
                    let _e804 = ((_e550 * _e785) * 0.7329038f);
                    let _e831 = state.member[((_e60 * 15u) + _e79)];
                    let _e837 = state.member[((_e60 * 18u) + _e79)];
                    let _e843 = state.member[((_e60 * 21u) + _e79)];
                    let _e849 = state.member[((_e60 * 24u) + _e79)];
                    let _e855 = state.member[((_e60 * 27u) + _e79)];
                    let _e861 = state.member[((_e60 * 30u) + _e79)];
                    phi_1178_ = array<f32, 11>((_e800 * _e590), (_e565 * _e802), (_e566 * _e802), (_e567 * _e802), select(1f, ((sqrt(((_e569 + 0.0001f) / ((((((_e776 * _e776) + (_e779 * _e779)) + (_e773 * _e773)) * _e788) * _e788) + 0.0001f))) * _e545) + (1f - _e545)), _e549), ((_e550 * 0.2820948f) + _e831), (((_e705 - _e706) * _e804) + _e837), (((_e767 - _e768) * _e804) + _e843), (((_e646 - _e647) * _e804) + _e849), (((((_e783 * _e785) - 0.33333334f) * _e550) * 1.5138805f) + _e855), (((((_e780 - _e781) * _e785) * _e550) * 0.8740393f) + _e861));
                } else {
                    phi_1178_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e865 = phi_1178_;
                out.member[_e79] = _e865[0];
                out.member[(_e67 + _e79)] = _e865[1];
                out.member[((_e60 * 6u) + _e79)] = _e865[2];
                out.member[((_e60 * 9u) + _e79)] = _e865[3];
                out.member[((_e60 * 12u) + _e79)] = _e865[4];
                out.member[((_e60 * 15u) + _e79)] = _e865[5];
                out.member[((_e60 * 18u) + _e79)] = _e865[6];
                out.member[((_e60 * 21u) + _e79)] = _e865[7];
                out.member[((_e60 * 24u) + _e79)] = _e865[8];
                out.member[((_e60 * 27u) + _e79)] = _e865[9];
                out.member[((_e60 * 30u) + _e79)] = _e865[10];
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
