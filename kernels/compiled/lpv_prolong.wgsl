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
    var phi_86_: u32;
    var phi_170_: bool;
    var phi_172_: bool;
    var phi_173_: bool;
    var phi_980_: array<f32, 6>;
    var phi_981_: array<f32, 6>;

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
                phi_86_ = (3u * (_e42 / _e34));
            } else {
                phi_86_ = 0u;
            }
            let _e48 = phi_86_;
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
                        phi_170_ = (_e74 < _e32.z);
                    } else {
                        phi_170_ = bool();
                    }
                    let _e81 = phi_170_;
                    phi_172_ = _e81;
                    phi_173_ = select(true, false, _e78);
                } else {
                    phi_172_ = bool();
                    phi_173_ = true;
                }
                let _e84 = phi_172_;
                let _e86 = phi_173_;
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
                        let _e217 = opacity.member[(_e206 - 1u)];
                        let _e220 = opacity.member[_e206];
                        let _e228 = coarse_opacity.member[((_e210 - 1u) + ((_e59 + 1u) / 2u))];
                        let _e239 = (_e59 / 2u);
                        let _e243 = coarse_opacity.member[(((_e174 + _e210) - select(_e166, 0u, _e189)) + _e239)];
                        let _e246 = opacity.member[((_e42 + _e206) - select(0u, _e34, _e189))];
                        let _e250 = ((0.25f * (1f - _e243)) + (_e243 * _e246));
                        let _e262 = coarse_opacity.member[((((2u * _e174) + _e210) - select(_e169, 0u, _e203)) + _e239)];
                        let _e265 = opacity.member[(((2u * _e42) + _e206) - select(0u, _e37, _e203))];
                        let _e269 = ((0.25f * (1f - _e262)) + (_e262 * _e265));
                        let _e270 = f32(_e59);
                        let _e274 = params.member.member_3[0u];
                        let _e281 = select(select(((0.25f * (1f - _e228)) + (_e228 * select(_e220, _e217, (0.5f < f32(_e211))))), 0f, (_e270 < 0.5f)), 0f, (((2f * f32(_e274)) - 1.5f) < _e270));
                        let _e282 = (_e66 * _e174);
                        let _e283 = (_e282 + _e210);
                        let _e285 = (_e170 + (select((select(1u, _e175, (1u < _e175)) - 1u), select(_e181, _e182, (_e182 < _e181)), _e189) * _e166));
                        let _e287 = (_e282 + (_e285 + _e209));
                        let _e288 = (select((select(1u, _e176, (1u < _e176)) - 1u), select(_e195, _e196, (_e196 < _e195)), _e203) * _e169);
                        let _e290 = (_e282 + (_e208 + _e288));
                        let _e292 = (_e282 + (_e285 + _e288));
                        let _e293 = (3u * _e174);
                        let _e294 = (_e283 + _e239);
                        let _e297 = coarse.member[_e294];
                        let _e298 = (1f - _e281);
                        let _e300 = (2u * _e211);
                        let _e305 = coarse.member[((_e294 + _e300) - 1u)];
                        let _e308 = (_e287 + _e239);
                        let _e311 = coarse.member[_e308];
                        let _e317 = coarse.member[((_e308 + _e300) - 1u)];
                        let _e320 = (_e290 + _e239);
                        let _e323 = coarse.member[_e320];
                        let _e329 = coarse.member[((_e320 + _e300) - 1u)];
                        let _e332 = (_e292 + _e239);
                        let _e335 = coarse.member[_e332];
                        let _e341 = coarse.member[((_e332 + _e300) - 1u)];
                        let _e344 = (1f - _e250);
                        let _e351 = (1f - _e269);
                        let _e358 = ((_e293 + _e283) + _e239);
                        let _e361 = coarse.member[_e358];
                        let _e367 = coarse.member[((_e358 + _e300) - 1u)];
                        let _e371 = ((_e293 + _e287) + _e239);
                        let _e374 = coarse.member[_e371];
                        let _e380 = coarse.member[((_e371 + _e300) - 1u)];
                        let _e384 = ((_e293 + _e290) + _e239);
                        let _e387 = coarse.member[_e384];
                        let _e393 = coarse.member[((_e384 + _e300) - 1u)];
                        let _e397 = ((_e293 + _e292) + _e239);
                        let _e400 = coarse.member[_e397];
                        let _e406 = coarse.member[((_e397 + _e300) - 1u)];
                        let _e420 = (_e174 * 6u);
                        let _e422 = ((_e420 + _e283) + _e239);
                        let _e425 = coarse.member[_e422];
                        let _e431 = coarse.member[((_e422 + _e300) - 1u)];
                        let _e435 = ((_e420 + _e287) + _e239);
                        let _e438 = coarse.member[_e435];
                        let _e444 = coarse.member[((_e435 + _e300) - 1u)];
                        let _e448 = ((_e420 + _e290) + _e239);
                        let _e451 = coarse.member[_e448];
                        let _e457 = coarse.member[((_e448 + _e300) - 1u)];
                        let _e461 = ((_e420 + _e292) + _e239);
                        let _e464 = coarse.member[_e461];
                        let _e470 = coarse.member[((_e461 + _e300) - 1u)];
                        let _e484 = (_e174 * 9u);
                        let _e486 = ((_e484 + _e283) + _e239);
                        let _e489 = coarse.member[_e486];
                        let _e495 = coarse.member[((_e486 + _e300) - 1u)];
                        let _e499 = ((_e484 + _e287) + _e239);
                        let _e502 = coarse.member[_e499];
                        let _e508 = coarse.member[((_e499 + _e300) - 1u)];
                        let _e512 = ((_e484 + _e290) + _e239);
                        let _e515 = coarse.member[_e512];
                        let _e521 = coarse.member[((_e512 + _e300) - 1u)];
                        let _e525 = ((_e484 + _e292) + _e239);
                        let _e528 = coarse.member[_e525];
                        let _e534 = coarse.member[((_e525 + _e300) - 1u)];
                        let _e548 = (_e174 * 12u);
                        let _e550 = ((_e548 + _e283) + _e239);
                        let _e553 = coarse.member[_e550];
                        let _e559 = coarse.member[((_e550 + _e300) - 1u)];
                        let _e563 = ((_e548 + _e287) + _e239);
                        let _e566 = coarse.member[_e563];
                        let _e572 = coarse.member[((_e563 + _e300) - 1u)];
                        let _e576 = ((_e548 + _e290) + _e239);
                        let _e579 = coarse.member[_e576];
                        let _e585 = coarse.member[((_e576 + _e300) - 1u)];
                        let _e589 = ((_e548 + _e292) + _e239);
                        let _e592 = coarse.member[_e589];
                        let _e598 = coarse.member[((_e589 + _e300) - 1u)];
                        let _e612 = (_e174 * 15u);
                        let _e614 = ((_e612 + _e283) + _e239);
                        let _e617 = coarse.member[_e614];
                        let _e623 = coarse.member[((_e614 + _e300) - 1u)];
                        let _e627 = ((_e612 + _e287) + _e239);
                        let _e630 = coarse.member[_e627];
                        let _e636 = coarse.member[((_e627 + _e300) - 1u)];
                        let _e640 = ((_e612 + _e290) + _e239);
                        let _e643 = coarse.member[_e640];
                        let _e649 = coarse.member[((_e640 + _e300) - 1u)];
                        let _e653 = ((_e612 + _e292) + _e239);
                        let _e656 = coarse.member[_e653];
                        let _e662 = coarse.member[((_e653 + _e300) - 1u)];
                        phi_980_ = array<f32, 6>((_e99 + (((((((_e297 * _e298) + (_e305 * _e281)) * _e344) + (((_e311 * _e298) + (_e317 * _e281)) * _e250)) * _e351) + (((((_e323 * _e298) + (_e329 * _e281)) * _e344) + (((_e335 * _e298) + (_e341 * _e281)) * _e250)) * _e269)) * _e160)), (_e110 + (((((((_e361 * _e298) + (_e367 * _e281)) * _e344) + (((_e374 * _e298) + (_e380 * _e281)) * _e250)) * _e351) + (((((_e387 * _e298) + (_e393 * _e281)) * _e344) + (((_e400 * _e298) + (_e406 * _e281)) * _e250)) * _e269)) * _e160)), (_e122 + (((((((_e425 * _e298) + (_e431 * _e281)) * _e344) + (((_e438 * _e298) + (_e444 * _e281)) * _e250)) * _e351) + (((((_e451 * _e298) + (_e457 * _e281)) * _e344) + (((_e464 * _e298) + (_e470 * _e281)) * _e250)) * _e269)) * _e160)), (_e134 + (((((((_e489 * _e298) + (_e495 * _e281)) * _e344) + (((_e502 * _e298) + (_e508 * _e281)) * _e250)) * _e351) + (((((_e515 * _e298) + (_e521 * _e281)) * _e344) + (((_e528 * _e298) + (_e534 * _e281)) * _e250)) * _e269)) * _e160)), (_e146 + (((((((_e553 * _e298) + (_e559 * _e281)) * _e344) + (((_e566 * _e298) + (_e572 * _e281)) * _e250)) * _e351) + (((((_e579 * _e298) + (_e585 * _e281)) * _e344) + (((_e592 * _e298) + (_e598 * _e281)) * _e250)) * _e269)) * _e160)), (_e156 + (((((((_e617 * _e298) + (_e623 * _e281)) * _e344) + (((_e630 * _e298) + (_e636 * _e281)) * _e250)) * _e351) + (((((_e643 * _e298) + (_e649 * _e281)) * _e344) + (((_e656 * _e298) + (_e662 * _e281)) * _e250)) * _e269)) * _e160)));
                    } else {
                        phi_980_ = array<f32, 6>(_e99, _e110, _e122, _e134, _e146, _e156);
                    }
                    let _e678 = phi_980_;
                    phi_981_ = _e678;
                } else {
                    phi_981_ = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e680 = phi_981_;
                out.member[_e61] = _e680[0];
                out.member[(_e49 + _e61)] = _e680[1];
                out.member[((_e42 * 6u) + _e61)] = _e680[2];
                out.member[((_e42 * 9u) + _e61)] = _e680[3];
                out.member[((_e42 * 12u) + _e61)] = _e680[4];
                out.member[(_e62 + _e61)] = _e680[5];
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
