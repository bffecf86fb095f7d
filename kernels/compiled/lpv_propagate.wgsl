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
    var phi_104_: u32;
    var phi_186_: bool;
    var phi_188_: bool;
    var phi_189_: bool;
    var phi_1280_: bool;
    var phi_1186_: array<f32, 11>;
    var phi_1201_: type_11;
    var phi_1202_: type_11;
    var phi_1225_: type_11;
    var phi_1285_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e51 = gid_1;
            let _e56 = params.member.member_2;
            let _e58 = (_e56.x + 1u);
            let _e60 = (_e56.y + 1u);
            let _e61 = (_e60 * _e58);
            let _e66 = ((_e61 + _e58) + ((_e56.z + 1u) * _e61));
            if (_e56.x > 0u) {
                if (_e58 == 0u) {
                    break;
                }
                phi_104_ = (3u * (_e66 / _e58));
            } else {
                phi_104_ = 0u;
            }
            let _e72 = phi_104_;
            let _e73 = (3u * _e66);
            let _e77 = (_e51.x + (_e51.y * 2097152u));
            if (_e77 < (_e72 * _e56.x)) {
                if (_e56.x == 0u) {
                    break;
                }
                let _e81 = (_e77 / _e56.x);
                let _e85 = ((_e81 * _e58) + (_e77 - (_e81 * _e56.x)));
                let _e86 = (_e58 == 0u);
                if _e86 {
                    break;
                }
                let _e87 = (_e66 / _e58);
                if (_e87 == 0u) {
                    break;
                }
                let _e89 = (_e81 / _e87);
                if _e86 {
                    break;
                }
                let _e91 = (_e81 - (_e89 * _e87));
                let _e92 = (_e56.y + 2u);
                let _e95 = (select(_e92, _e91, (_e92 < _e91)) - _e92);
                if (_e60 == 0u) {
                    break;
                }
                let _e97 = (_e95 / _e60);
                if (_e91 >= _e92) {
                    let _e101 = ((_e95 - (_e97 * _e60)) < _e56.y);
                    if _e101 {
                        phi_186_ = (_e97 < _e56.z);
                    } else {
                        phi_186_ = bool();
                    }
                    let _e104 = phi_186_;
                    phi_188_ = _e104;
                    phi_189_ = select(true, false, _e101);
                } else {
                    phi_188_ = bool();
                    phi_189_ = true;
                }
                let _e107 = phi_188_;
                let _e109 = phi_189_;
                if select(_e107, false, _e109) {
                    let _e112 = (_e85 - (_e89 * _e66));
                    let _e115 = opacity.member[_e112];
                    let _e118 = params.member.member_8;
                    let _e120 = (1f - (_e115 * _e118));
                    let _e124 = opacity.member[(_e112 - 1u)];
                    let _e126 = (1f - (_e124 * _e118));
                    let _e127 = (_e66 + _e112);
                    let _e130 = opacity.member[_e127];
                    let _e132 = (1f - (_e130 * _e118));
                    let _e136 = opacity.member[(_e127 - _e58)];
                    let _e138 = (1f - (_e136 * _e118));
                    let _e140 = ((2u * _e66) + _e112);
                    let _e143 = opacity.member[_e140];
                    let _e145 = (1f - (_e143 * _e118));
                    let _e149 = opacity.member[(_e140 - _e61)];
                    let _e151 = (1f - (_e149 * _e118));
                    let _e155 = params.member.member_4[0u];
                    let _e159 = params.member.member_4[1u];
                    let _e163 = params.member.member_4[2u];
                    let _e164 = (_e85 + 1u);
                    let _e168 = state.member[(_e164 + _e73)];
                    let _e169 = (_e66 * 6u);
                    let _e173 = state.member[(_e164 + _e169)];
                    let _e174 = (_e66 * 9u);
                    let _e178 = state.member[(_e164 + _e174)];
                    let _e182 = state.member[_e164];
                    let _e184 = (_e182 + (_e168 * -0.8944272f));
                    let _e185 = (_e173 * 0.4472136f);
                    let _e186 = (_e178 * 0.4472136f);
                    let _e187 = (_e184 + _e185);
                    let _e189 = select(0f, _e187, (0f < _e187));
                    let _e190 = (_e184 - _e185);
                    let _e192 = select(0f, _e190, (0f < _e190));
                    let _e193 = (_e184 + _e186);
                    let _e195 = select(0f, _e193, (0f < _e193));
                    let _e196 = (_e184 - _e186);
                    let _e198 = select(0f, _e196, (0f < _e196));
                    let _e199 = (_e182 + -(_e168));
                    let _e202 = (select(0f, _e199, (0f < _e199)) * 0.4006697f);
                    let _e206 = (((_e189 + _e192) + (_e195 + _e198)) * 0.42343134f);
                    let _e211 = (_e66 * 12u);
                    let _e215 = state.member[(_e164 + _e211)];
                    let _e216 = (_e120 * _e215);
                    let _e228 = (_e85 - 1u);
                    let _e232 = state.member[(_e228 + _e73)];
                    let _e236 = state.member[(_e228 + _e169)];
                    let _e240 = state.member[(_e228 + _e174)];
                    let _e243 = state.member[_e228];
                    let _e245 = (_e243 + (_e232 * 0.8944272f));
                    let _e246 = (_e236 * 0.4472136f);
                    let _e247 = (_e240 * 0.4472136f);
                    let _e248 = (_e245 + _e246);
                    let _e250 = select(0f, _e248, (0f < _e248));
                    let _e251 = (_e245 - _e246);
                    let _e253 = select(0f, _e251, (0f < _e251));
                    let _e254 = (_e245 + _e247);
                    let _e256 = select(0f, _e254, (0f < _e254));
                    let _e257 = (_e245 - _e247);
                    let _e259 = select(0f, _e257, (0f < _e257));
                    let _e260 = (_e243 + _e232);
                    let _e263 = (select(0f, _e260, (0f < _e260)) * 0.4006697f);
                    let _e267 = (((_e250 + _e253) + (_e256 + _e259)) * 0.42343134f);
                    let _e275 = state.member[(_e228 + _e211)];
                    let _e276 = (_e126 * _e275);
                    let _e291 = (_e85 + _e58);
                    let _e295 = state.member[(_e291 + _e73)];
                    let _e299 = state.member[(_e291 + _e169)];
                    let _e303 = state.member[(_e291 + _e174)];
                    let _e307 = state.member[_e291];
                    let _e309 = (_e307 + (_e299 * -0.8944272f));
                    let _e310 = (_e303 * 0.4472136f);
                    let _e311 = (_e295 * 0.4472136f);
                    let _e312 = (_e309 + _e310);
                    let _e314 = select(0f, _e312, (0f < _e312));
                    let _e315 = (_e309 - _e310);
                    let _e317 = select(0f, _e315, (0f < _e315));
                    let _e318 = (_e309 + _e311);
                    let _e320 = select(0f, _e318, (0f < _e318));
                    let _e321 = (_e309 - _e311);
                    let _e323 = select(0f, _e321, (0f < _e321));
                    let _e324 = (_e307 + -(_e299));
                    let _e327 = (select(0f, _e324, (0f < _e324)) * 0.4006697f);
                    let _e331 = (((_e314 + _e317) + (_e320 + _e323)) * 0.42343134f);
                    let _e339 = state.member[(_e291 + _e211)];
                    let _e340 = (_e132 * _e339);
                    let _e355 = (_e85 - _e58);
                    let _e359 = state.member[(_e355 + _e73)];
                    let _e363 = state.member[(_e355 + _e169)];
                    let _e367 = state.member[(_e355 + _e174)];
                    let _e370 = state.member[_e355];
                    let _e372 = (_e370 + (_e363 * 0.8944272f));
                    let _e373 = (_e367 * 0.4472136f);
                    let _e374 = (_e359 * 0.4472136f);
                    let _e375 = (_e372 + _e373);
                    let _e377 = select(0f, _e375, (0f < _e375));
                    let _e378 = (_e372 - _e373);
                    let _e380 = select(0f, _e378, (0f < _e378));
                    let _e381 = (_e372 + _e374);
                    let _e383 = select(0f, _e381, (0f < _e381));
                    let _e384 = (_e372 - _e374);
                    let _e386 = select(0f, _e384, (0f < _e384));
                    let _e387 = (_e370 + _e363);
                    let _e390 = (select(0f, _e387, (0f < _e387)) * 0.4006697f);
                    let _e394 = (((_e377 + _e380) + (_e383 + _e386)) * 0.42343134f);
                    let _e402 = state.member[(_e355 + _e211)];
                    let _e403 = (_e138 * _e402);
                    let _e418 = (_e85 + _e61);
                    let _e422 = state.member[(_e418 + _e73)];
                    let _e426 = state.member[(_e418 + _e169)];
                    let _e430 = state.member[(_e418 + _e174)];
                    let _e434 = state.member[_e418];
                    let _e436 = (_e434 + (_e430 * -0.8944272f));
                    let _e437 = (_e422 * 0.4472136f);
                    let _e438 = (_e426 * 0.4472136f);
                    let _e439 = (_e436 + _e437);
                    let _e441 = select(0f, _e439, (0f < _e439));
                    let _e442 = (_e436 - _e437);
                    let _e444 = select(0f, _e442, (0f < _e442));
                    let _e445 = (_e436 + _e438);
                    let _e447 = select(0f, _e445, (0f < _e445));
                    let _e448 = (_e436 - _e438);
                    let _e450 = select(0f, _e448, (0f < _e448));
                    let _e451 = (_e434 + -(_e430));
                    let _e454 = (select(0f, _e451, (0f < _e451)) * 0.4006697f);
                    let _e458 = (((_e441 + _e444) + (_e447 + _e450)) * 0.42343134f);
                    let _e466 = state.member[(_e418 + _e211)];
                    let _e467 = (_e145 * _e466);
                    let _e482 = (_e85 - _e61);
                    let _e486 = state.member[(_e482 + _e73)];
                    let _e490 = state.member[(_e482 + _e169)];
                    let _e494 = state.member[(_e482 + _e174)];
                    let _e497 = state.member[_e482];
                    let _e499 = (_e497 + (_e494 * 0.8944272f));
                    let _e500 = (_e486 * 0.4472136f);
                    let _e501 = (_e490 * 0.4472136f);
                    let _e502 = (_e499 + _e500);
                    let _e504 = select(0f, _e502, (0f < _e502));
                    let _e505 = (_e499 - _e500);
                    let _e507 = select(0f, _e505, (0f < _e505));
                    let _e508 = (_e499 + _e501);
                    let _e510 = select(0f, _e508, (0f < _e508));
                    let _e511 = (_e499 - _e501);
                    let _e513 = select(0f, _e511, (0f < _e511));
                    let _e514 = (_e497 + _e494);
                    let _e517 = (select(0f, _e514, (0f < _e514)) * 0.4006697f);
                    let _e521 = (((_e504 + _e507) + (_e510 + _e513)) * 0.42343134f);
                    let _e529 = state.member[(_e482 + _e211)];
                    let _e530 = (_e151 * _e529);
                    let _e533 = (((((((_e202 + _e206) * _e120) + ((_e263 + _e267) * _e126)) + ((_e327 + _e331) * _e132)) + ((_e390 + _e394) * _e138)) + ((_e454 + _e458) * _e145)) + ((_e517 + _e521) * _e151));
                    let _e547 = params.member.member_9;
                    let _e551 = params.member.member_4[3u];
                    let _e554 = params.member.member_6;
                    let _e555 = (0.000000000000000001f < _e533);
                    let _e556 = select(0f, _e533, _e555);
                    let _e558 = (1f / select(1f, _e556, _e555));
                    let _e559 = ((((((-((((_e202 * _e155) + (_e206 * _e159)) * _e216)) + (((_e263 * _e155) + (_e267 * _e159)) * _e276)) + ((((_e320 - _e323) * 0.42343134f) * _e163) * _e340)) + ((((_e383 - _e386) * 0.42343134f) * _e163) * _e403)) + ((((_e441 - _e444) * 0.42343134f) * _e163) * _e467)) + ((((_e504 - _e507) * 0.42343134f) * _e163) * _e530)) * _e558);
                    let _e560 = ((((((((((_e189 - _e192) * 0.42343134f) * _e163) * _e216) + ((((_e250 - _e253) * 0.42343134f) * _e163) * _e276)) - (((_e327 * _e155) + (_e331 * _e159)) * _e340)) + (((_e390 * _e155) + (_e394 * _e159)) * _e403)) + ((((_e447 - _e450) * 0.42343134f) * _e163) * _e467)) + ((((_e510 - _e513) * 0.42343134f) * _e163) * _e530)) * _e558);
                    let _e561 = ((((((((((_e195 - _e198) * 0.42343134f) * _e163) * _e216) + ((((_e256 - _e259) * 0.42343134f) * _e163) * _e276)) + ((((_e314 - _e317) * 0.42343134f) * _e163) * _e340)) + ((((_e377 - _e380) * 0.42343134f) * _e163) * _e403)) - (((_e454 * _e155) + (_e458 * _e159)) * _e467)) + (((_e517 * _e155) + (_e521 * _e159)) * _e530)) * _e558);
                    let _e566 = (((_e559 * _e559) + (_e560 * _e560)) + (_e561 * _e561));
                    let _e570 = (1f / sqrt(select(1f, _e566, (1f < _e566))));
                    let _e571 = (_e559 * _e570);
                    let _e572 = (_e560 * _e570);
                    let _e573 = (_e561 * _e570);
                    let _e575 = ((_e566 * _e570) * _e570);
                    let _e576 = sqrt(_e575);
                    if (_e554 != _e554) {
                        phi_1280_ = true;
                    } else {
                        phi_1280_ = (0.33333334f >= _e554);
                    }
                    let _e580 = phi_1280_;
                    let _e581 = select(_e554, 0.33333334f, _e580);
                    let _e584 = (3f * select(_e581, _e576, (_e576 < _e581)));
                    let _e586 = (3f - _e584);
                    let _e588 = (0.31830987f / (_e586 * _e586));
                    let _e591 = (_e576 < select(2f, 0.33333334f, (_e554 > 0.33333334f)));
                    let _e596 = select(((2f - _e584) * _e588), 0.07957747f, _e591);
                    let _e597 = select((_e588 / select(0.33333334f, _e576, (0.33333334f < _e576))), 0.2387324f, _e591);
                    let _e598 = (_e571 * _e597);
                    let _e599 = (_e572 * _e597);
                    let _e600 = (_e573 * _e597);
                    let _e602 = (_e596 + (_e598 * 0.8944272f));
                    let _e603 = (_e599 * 0.4472136f);
                    let _e604 = (_e600 * 0.4472136f);
                    let _e605 = (_e602 + _e603);
                    let _e607 = select(0f, _e605, (0f < _e605));
                    let _e608 = (_e602 - _e603);
                    let _e610 = select(0f, _e608, (0f < _e608));
                    let _e611 = (_e602 + _e604);
                    let _e613 = select(0f, _e611, (0f < _e611));
                    let _e614 = (_e602 - _e604);
                    let _e616 = select(0f, _e614, (0f < _e614));
                    let _e617 = (_e596 + _e598);
                    let _e620 = (select(0f, _e617, (0f < _e617)) * 0.4006697f);
                    let _e624 = (((_e607 + _e610) + (_e613 + _e616)) * 0.42343134f);
                    let _e629 = (_e596 + (_e598 * -0.8944272f));
                    let _e630 = (_e629 + _e603);
                    let _e632 = select(0f, _e630, (0f < _e630));
                    let _e633 = (_e629 - _e603);
                    let _e635 = select(0f, _e633, (0f < _e633));
                    let _e636 = (_e629 + _e604);
                    let _e638 = select(0f, _e636, (0f < _e636));
                    let _e639 = (_e629 - _e604);
                    let _e641 = select(0f, _e639, (0f < _e639));
                    let _e642 = (_e596 + -(_e598));
                    let _e645 = (select(0f, _e642, (0f < _e642)) * 0.4006697f);
                    let _e649 = (((_e632 + _e635) + (_e638 + _e641)) * 0.42343134f);
                    let _e652 = (_e620 + _e624);
                    let _e653 = (_e645 + _e649);
                    let _e662 = (_e596 + (_e599 * 0.8944272f));
                    let _e663 = (_e598 * 0.4472136f);
                    let _e664 = (_e662 + _e604);
                    let _e666 = select(0f, _e664, (0f < _e664));
                    let _e667 = (_e662 - _e604);
                    let _e669 = select(0f, _e667, (0f < _e667));
                    let _e670 = (_e662 + _e663);
                    let _e672 = select(0f, _e670, (0f < _e670));
                    let _e673 = (_e662 - _e663);
                    let _e675 = select(0f, _e673, (0f < _e673));
                    let _e676 = (_e596 + _e599);
                    let _e679 = (select(0f, _e676, (0f < _e676)) * 0.4006697f);
                    let _e683 = (((_e666 + _e669) + (_e672 + _e675)) * 0.42343134f);
                    let _e688 = (_e596 + (_e599 * -0.8944272f));
                    let _e689 = (_e688 + _e604);
                    let _e691 = select(0f, _e689, (0f < _e689));
                    let _e692 = (_e688 - _e604);
                    let _e694 = select(0f, _e692, (0f < _e692));
                    let _e695 = (_e688 + _e663);
                    let _e697 = select(0f, _e695, (0f < _e695));
                    let _e698 = (_e688 - _e663);
                    let _e700 = select(0f, _e698, (0f < _e698));
                    let _e701 = (_e596 + -(_e599));
                    let _e704 = (select(0f, _e701, (0f < _e701)) * 0.4006697f);
                    let _e708 = (((_e691 + _e694) + (_e697 + _e700)) * 0.42343134f);
                    let _e711 = (_e679 + _e683);
                    let _e712 = (_e704 + _e708);
                    let _e725 = (_e596 + (_e600 * 0.8944272f));
                    let _e726 = (_e725 + _e663);
                    let _e728 = select(0f, _e726, (0f < _e726));
                    let _e729 = (_e725 - _e663);
                    let _e731 = select(0f, _e729, (0f < _e729));
                    let _e732 = (_e725 + _e603);
                    let _e734 = select(0f, _e732, (0f < _e732));
                    let _e735 = (_e725 - _e603);
                    let _e737 = select(0f, _e735, (0f < _e735));
                    let _e738 = (_e596 + _e600);
                    let _e741 = (select(0f, _e738, (0f < _e738)) * 0.4006697f);
                    let _e745 = (((_e728 + _e731) + (_e734 + _e737)) * 0.42343134f);
                    let _e750 = (_e596 + (_e600 * -0.8944272f));
                    let _e751 = (_e750 + _e663);
                    let _e753 = select(0f, _e751, (0f < _e751));
                    let _e754 = (_e750 - _e663);
                    let _e756 = select(0f, _e754, (0f < _e754));
                    let _e757 = (_e750 + _e603);
                    let _e759 = select(0f, _e757, (0f < _e757));
                    let _e760 = (_e750 - _e603);
                    let _e762 = select(0f, _e760, (0f < _e760));
                    let _e763 = (_e596 + -(_e600));
                    let _e766 = (select(0f, _e763, (0f < _e763)) * 0.4006697f);
                    let _e770 = (((_e753 + _e756) + (_e759 + _e762)) * 0.42343134f);
                    let _e773 = (_e741 + _e745);
                    let _e774 = (_e766 + _e770);
                    let _e779 = (((0.18936425f * (((_e613 - _e616) + (_e638 - _e641)) + ((_e666 - _e669) + (_e691 - _e694)))) + (_e741 - _e766)) + ((_e745 - _e770) * 0.8944272f));
                    let _e782 = ((((_e620 - _e645) + ((_e624 - _e649) * 0.8944272f)) + (((_e672 - _e675) + (_e697 - _e700)) * 0.18936425f)) + (((_e728 - _e731) + (_e753 - _e756)) * 0.18936425f));
                    let _e785 = ((((((_e607 - _e610) + (_e632 - _e635)) * 0.18936425f) + (_e679 - _e704)) + ((_e683 - _e708) * 0.8944272f)) + (((_e734 - _e737) + (_e759 - _e762)) * 0.18936425f));
                    let _e786 = (_e652 + _e653);
                    let _e787 = (_e711 + _e712);
                    let _e789 = (_e773 + _e774);
                    let _e791 = (1f / ((_e786 + _e787) + _e789));
                    let _e794 = ((_e791 * _e547) + (1f - _e547));
                    let _e806 = (_e556 * _e794);
                    let _e808 = (_e806 * _e597);
                    let _e810 = ((_e556 * _e791) * 0.7329038f);
                    let _e837 = state.member[((_e66 * 15u) + _e85)];
                    let _e843 = state.member[((_e66 * 18u) + _e85)];
                    let _e849 = state.member[((_e66 * 21u) + _e85)];
                    let _e855 = state.member[((_e66 * 24u) + _e85)];
                    let _e861 = state.member[((_e66 * 27u) + _e85)];
                    let _e867 = state.member[((_e66 * 30u) + _e85)];
                    phi_1186_ = array<f32, 11>((_e806 * _e596), (_e571 * _e808), (_e572 * _e808), (_e573 * _e808), select(1f, ((sqrt(((_e575 + 0.0001f) / ((((((_e782 * _e782) + (_e785 * _e785)) + (_e779 * _e779)) * _e794) * _e794) + 0.0001f))) * _e551) + (1f - _e551)), _e555), ((_e556 * 0.2820948f) + _e837), (((_e711 - _e712) * _e810) + _e843), (((_e773 - _e774) * _e810) + _e849), (((_e652 - _e653) * _e810) + _e855), (((((_e789 * _e791) - 0.33333334f) * _e556) * 1.5138805f) + _e861), (((((_e786 - _e787) * _e791) * _e556) * 0.8740393f) + _e867));
                } else {
                    phi_1186_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e871 = phi_1186_;
                local = array<f32, 11>(_e871[0], _e871[1], _e871[2], _e871[3], _e871[4], _e871[5], _e871[6], _e871[7], _e871[8], _e871[9], _e871[10]);
                phi_1201_ = type_11(0u, 11u);
                loop {
                    let _e885 = phi_1201_;
                    if (_e885.member < _e885.member_1) {
                        phi_1202_ = type_11((_e885.member + 1u), _e885.member_1);
                        phi_1225_ = type_11(1u, _e885.member);
                    } else {
                        phi_1202_ = _e885;
                        phi_1225_ = type_11(0u, type_11().member_1);
                    }
                    let _e898 = phi_1202_;
                    let _e900 = phi_1225_;
                    let _e904 = (bitcast<i32>(_e900.member) != 0i);
                    if _e904 {
                        if (_e900.member_1 < 11u) {
                        } else {
                            phi_1285_ = true;
                            break;
                        }
                        let _e907 = local[_e900.member_1];
                        let _e909 = ((_e900.member_1 * _e73) + _e85);
                        if (_e909 < arrayLength((&out.member))) {
                        } else {
                            phi_1285_ = true;
                            break;
                        }
                        out.member[_e909] = _e907;
                    }
                    continue;
                    continuing {
                        phi_1201_ = _e898;
                        phi_1285_ = false;
                        break if !(_e904);
                    }
                }
                let _e915 = phi_1285_;
                if _e915 {
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
