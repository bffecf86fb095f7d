struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_17 {
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

struct type_18 {
    member: type_17,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(3) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_18;
@group(0) @binding(1) 
var<storage> state: type_5;
@group(0) @binding(2) 
var<storage> opacity: type_5;

fn function_() {
    var local: array<f32, 5>;
    var phi_164_: type_12;
    var phi_167_: f32;
    var phi_169_: f32;
    var phi_171_: f32;
    var phi_173_: f32;
    var phi_175_: f32;
    var phi_165_: type_12;
    var phi_198_: type_12;
    var phi_168_: f32;
    var phi_170_: f32;
    var phi_172_: f32;
    var phi_174_: f32;
    var phi_176_: f32;
    var phi_710_: bool;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: f32;
    var phi_654_: type_12;
    var phi_655_: type_12;
    var phi_678_: type_12;
    var phi_752_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = gid_1;
            let _e34 = arrayLength((&state.member));
            let _e36 = arrayLength((&opacity.member));
            let _e44 = params.member.member_2[1u];
            let _e49 = params.member.member_2[0u];
            let _e55 = (_e32.x + (_e32.y * 2097152u));
            if (_e55 < ((3u * _e44) * _e49)) {
                if (_e49 == 0u) {
                    break;
                }
                let _e59 = (_e55 / _e49);
                let _e61 = (_e55 - (_e59 * _e49));
                let _e62 = params.member.member_2;
                let _e64 = (_e62.x + 1u);
                let _e67 = ((_e62.y + 1u) * _e64);
                let _e68 = (_e67 + _e64);
                let _e72 = (_e68 + ((_e62.z + 1u) * _e67));
                if (_e44 == 0u) {
                    break;
                }
                let _e75 = (_e59 / _e44);
                let _e77 = (_e59 - (_e75 * _e44));
                let _e78 = f32(_e61);
                let _e80 = select(0f, 1f, (_e78 < 0.5f));
                let _e84 = select(0f, 1f, ((f32(_e49) - 1.5f) < _e78));
                let _e86 = select(0f, 1f, (_e77 == 0u));
                let _e89 = select(0f, 1f, ((_e77 + 1u) == _e44));
                let _e93 = params.member.member_2[2u];
                phi_164_ = type_12(0u, _e93);
                phi_167_ = 0f;
                phi_169_ = 0f;
                phi_171_ = 0f;
                phi_173_ = 0f;
                phi_175_ = 0f;
                loop {
                    let _e96 = phi_164_;
                    let _e98 = phi_167_;
                    let _e100 = phi_169_;
                    let _e102 = phi_171_;
                    let _e104 = phi_173_;
                    let _e106 = phi_175_;
                    local_1 = _e104;
                    local_2 = _e102;
                    local_3 = _e100;
                    local_4 = _e98;
                    local_5 = _e106;
                    if (_e96.member < _e96.member_1) {
                        phi_165_ = type_12((_e96.member + 1u), _e96.member_1);
                        phi_198_ = type_12(1u, _e96.member);
                    } else {
                        phi_165_ = _e96;
                        phi_198_ = type_12(0u, type_12().member_1);
                    }
                    let _e119 = phi_165_;
                    let _e121 = phi_198_;
                    let _e125 = (bitcast<i32>(_e121.member) != 0i);
                    if _e125 {
                        let _e130 = (((_e68 + _e61) + (_e77 * _e64)) + (_e121.member_1 * _e67));
                        let _e132 = ((_e75 * _e72) + _e130);
                        let _e134 = select(0f, 1f, (_e121.member_1 == 0u));
                        let _e137 = select(0f, 1f, ((_e121.member_1 + 1u) == _e93));
                        if (_e130 < _e36) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e141 = opacity.member[_e130];
                        let _e144 = params.member.member_8;
                        let _e146 = (_e130 - 1u);
                        if (_e146 < _e36) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e150 = opacity.member[_e146];
                        let _e152 = (_e72 + _e130);
                        if (_e152 < _e36) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e156 = opacity.member[_e152];
                        let _e158 = (_e152 - _e64);
                        if (_e158 < _e36) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e162 = opacity.member[_e158];
                        let _e165 = ((2u * _e72) + _e130);
                        if (_e165 < _e36) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e169 = opacity.member[_e165];
                        let _e171 = (_e165 - _e67);
                        if (_e171 < _e36) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e175 = opacity.member[_e171];
                        let _e177 = (_e132 + (3u * _e72));
                        if (_e177 < _e34) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e181 = state.member[_e177];
                        let _e183 = (_e132 + (_e72 * 6u));
                        if (_e183 < _e34) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e187 = state.member[_e183];
                        let _e189 = (_e132 + (_e72 * 9u));
                        if (_e189 < _e34) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e193 = state.member[_e189];
                        if (_e132 < _e34) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e197 = state.member[_e132];
                        let _e199 = (_e197 + (_e181 * 0.8944272f));
                        let _e200 = (_e187 * 0.4472136f);
                        let _e201 = (_e193 * 0.4472136f);
                        let _e202 = (_e199 + _e200);
                        let _e205 = (_e199 - _e200);
                        let _e208 = (_e199 + _e201);
                        let _e211 = (_e199 - _e201);
                        let _e214 = (_e197 + _e181);
                        let _e224 = (_e197 + (_e181 * -0.8944272f));
                        let _e225 = (_e224 + _e200);
                        let _e228 = (_e224 - _e200);
                        let _e231 = (_e224 + _e201);
                        let _e234 = (_e224 - _e201);
                        let _e237 = (_e197 + -(_e181));
                        let _e245 = ((select(0f, _e214, (0f < _e214)) * 0.4006697f) + (((select(0f, _e202, (0f < _e202)) + select(0f, _e205, (0f < _e205))) + (select(0f, _e208, (0f < _e208)) + select(0f, _e211, (0f < _e211)))) * 0.42343134f));
                        let _e246 = ((select(0f, _e237, (0f < _e237)) * 0.4006697f) + (((select(0f, _e225, (0f < _e225)) + select(0f, _e228, (0f < _e228))) + (select(0f, _e231, (0f < _e231)) + select(0f, _e234, (0f < _e234)))) * 0.42343134f));
                        let _e248 = (_e197 + (_e187 * 0.8944272f));
                        let _e249 = (_e181 * 0.4472136f);
                        let _e250 = (_e248 + _e201);
                        let _e253 = (_e248 - _e201);
                        let _e256 = (_e248 + _e249);
                        let _e259 = (_e248 - _e249);
                        let _e262 = (_e197 + _e187);
                        let _e272 = (_e197 + (_e187 * -0.8944272f));
                        let _e273 = (_e272 + _e201);
                        let _e276 = (_e272 - _e201);
                        let _e279 = (_e272 + _e249);
                        let _e282 = (_e272 - _e249);
                        let _e285 = (_e197 + -(_e187));
                        let _e293 = ((select(0f, _e262, (0f < _e262)) * 0.4006697f) + (((select(0f, _e250, (0f < _e250)) + select(0f, _e253, (0f < _e253))) + (select(0f, _e256, (0f < _e256)) + select(0f, _e259, (0f < _e259)))) * 0.42343134f));
                        let _e294 = ((select(0f, _e285, (0f < _e285)) * 0.4006697f) + (((select(0f, _e273, (0f < _e273)) + select(0f, _e276, (0f < _e276))) + (select(0f, _e279, (0f < _e279)) + select(0f, _e282, (0f < _e282)))) * 0.42343134f));
                        let _e296 = (_e197 + (_e193 * 0.8944272f));
                        let _e297 = (_e296 + _e249);
                        let _e300 = (_e296 - _e249);
                        let _e303 = (_e296 + _e200);
                        let _e306 = (_e296 - _e200);
                        let _e309 = (_e197 + _e193);
                        let _e319 = (_e197 + (_e193 * -0.8944272f));
                        let _e320 = (_e319 + _e249);
                        let _e323 = (_e319 - _e249);
                        let _e326 = (_e319 + _e200);
                        let _e329 = (_e319 - _e200);
                        let _e332 = (_e197 + -(_e193));
                        let _e340 = ((select(0f, _e309, (0f < _e309)) * 0.4006697f) + (((select(0f, _e297, (0f < _e297)) + select(0f, _e300, (0f < _e300))) + (select(0f, _e303, (0f < _e303)) + select(0f, _e306, (0f < _e306)))) * 0.42343134f));
                        let _e341 = ((select(0f, _e332, (0f < _e332)) * 0.4006697f) + (((select(0f, _e320, (0f < _e320)) + select(0f, _e323, (0f < _e323))) + (select(0f, _e326, (0f < _e326)) + select(0f, _e329, (0f < _e329)))) * 0.42343134f));
                        let _e346 = (((_e245 + _e246) + (_e293 + _e294)) + (_e340 + _e341));
                        let _e387 = ((_e72 * 15u) + _e132);
                        if (_e387 < _e34) {
                        } else {
                            phi_710_ = true;
                            break;
                        }
                        let _e391 = state.member[_e387];
                        phi_168_ = select(_e346, _e98, (_e346 < _e98));
                        phi_170_ = ((((((_e100 + ((_e245 * (1f - _e84)) * (_e141 * _e144))) + ((_e246 * (1f - _e80)) * (_e150 * _e144))) + ((_e293 * (1f - _e89)) * (_e156 * _e144))) + ((_e294 * (1f - _e86)) * (_e162 * _e144))) + ((_e340 * (1f - _e137)) * (_e169 * _e144))) + ((_e341 * (1f - _e134)) * (_e175 * _e144)));
                        phi_172_ = ((((((_e102 + (_e245 * _e84)) + (_e246 * _e80)) + (_e293 * _e89)) + (_e294 * _e86)) + (_e340 * _e137)) + (_e341 * _e134));
                        phi_174_ = (_e104 + _e346);
                        phi_176_ = select(_e391, _e106, (_e391 < _e106));
                    } else {
                        phi_168_ = f32();
                        phi_170_ = f32();
                        phi_172_ = f32();
                        phi_174_ = f32();
                        phi_176_ = f32();
                    }
                    let _e395 = phi_168_;
                    let _e397 = phi_170_;
                    let _e399 = phi_172_;
                    let _e401 = phi_174_;
                    let _e403 = phi_176_;
                    continue;
                    continuing {
                        phi_164_ = _e119;
                        phi_167_ = _e395;
                        phi_169_ = _e397;
                        phi_171_ = _e399;
                        phi_173_ = _e401;
                        phi_175_ = _e403;
                        phi_710_ = false;
                        break if !(_e125);
                    }
                }
                let _e406 = phi_710_;
                if _e406 {
                    break;
                }
                let _e408 = local_1;
                let _e410 = local_2;
                let _e412 = local_3;
                let _e414 = local_4;
                let _e416 = local_5;
                local = array<f32, 5>(_e408, _e410, _e412, _e414, _e416);
                phi_654_ = type_12(0u, 5u);
                loop {
                    let _e419 = phi_654_;
                    if (_e419.member < _e419.member_1) {
                        phi_655_ = type_12((_e419.member + 1u), _e419.member_1);
                        phi_678_ = type_12(1u, _e419.member);
                    } else {
                        phi_655_ = _e419;
                        phi_678_ = type_12(0u, type_12().member_1);
                    }
                    let _e432 = phi_655_;
                    let _e434 = phi_678_;
                    let _e438 = (bitcast<i32>(_e434.member) != 0i);
                    if _e438 {
                        if (_e434.member_1 < 5u) {
                        } else {
                            phi_752_ = true;
                            break;
                        }
                        let _e441 = local[_e434.member_1];
                        let _e443 = ((_e434.member_1 * ((3u * _e49) * _e44)) + _e55);
                        if (_e443 < arrayLength((&out.member))) {
                        } else {
                            phi_752_ = true;
                            break;
                        }
                        out.member[_e443] = _e441;
                    }
                    continue;
                    continuing {
                        phi_654_ = _e432;
                        phi_752_ = _e406;
                        break if !(_e438);
                    }
                }
                let _e449 = phi_752_;
                if _e449 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_ledger(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
