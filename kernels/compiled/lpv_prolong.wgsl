struct type_5 {
    member: array<f32>,
}

struct type_15 {
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

struct type_16 {
    member: type_15,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_16;
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
    var phi_134_: bool;
    var phi_135_: bool;
    var phi_136_: bool;
    var phi_137_: bool;
    var phi_138_: bool;
    var phi_292_: u32;
    var phi_304_: u32;
    var phi_324_: u32;
    var phi_336_: u32;
    var phi_358_: u32;
    var phi_370_: u32;
    var phi_519_: f32;
    var phi_520_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = gid_1;
            let _e28 = arrayLength((&coarse.member));
            let _e30 = arrayLength((&opacity.member));
            let _e32 = arrayLength((&coarse_opacity.member));
            let _e38 = (_e22.x + (_e22.y * 2097152u));
            let _e39 = (_e38 < arrayLength((&out.member)));
            if _e39 {
                let _e42 = params.member.member_2;
                let _e44 = (_e42.x + 1u);
                let _e47 = ((_e42.y + 1u) * _e44);
                let _e48 = (_e47 + _e44);
                let _e52 = (_e48 + ((_e42.z + 1u) * _e47));
                if (_e52 == 0u) {
                    break;
                }
                let _e54 = (_e38 / _e52);
                let _e56 = (_e38 - (_e54 * _e52));
                let _e59 = (select(_e48, _e56, (_e48 < _e56)) - _e48);
                if (_e47 == 0u) {
                    break;
                }
                let _e61 = (_e59 / _e47);
                let _e63 = (_e59 - (_e61 * _e47));
                if (_e44 == 0u) {
                    break;
                }
                let _e65 = (_e63 / _e44);
                let _e67 = (_e63 - (_e65 * _e44));
                if (_e56 >= _e48) {
                    if (_e67 < _e42.x) {
                        let _e70 = (_e65 < _e42.y);
                        if _e70 {
                            phi_134_ = select(true, false, (_e61 < _e42.z));
                        } else {
                            phi_134_ = false;
                        }
                        let _e74 = phi_134_;
                        phi_135_ = select(true, false, _e70);
                        phi_136_ = _e74;
                    } else {
                        phi_135_ = true;
                        phi_136_ = false;
                    }
                    let _e77 = phi_135_;
                    let _e79 = phi_136_;
                    phi_137_ = _e77;
                    phi_138_ = _e79;
                } else {
                    phi_137_ = true;
                    phi_138_ = false;
                }
                let _e81 = phi_137_;
                let _e83 = phi_138_;
                let _e85 = select(_e67, _e42.x, select(_e83, true, _e81));
                let _e89 = params.member.member_2[0u];
                if (_e85 < _e89) {
                    if (_e38 < arrayLength((&before.member))) {
                    } else {
                        break;
                    }
                    let _e94 = before.member[_e38];
                    let _e97 = params.member.member_11;
                    let _e100 = ((_e52 * 15u) + _e38);
                    if (_e100 < arrayLength((&state.member))) {
                    } else {
                        break;
                    }
                    let _e104 = state.member[_e100];
                    let _e105 = ((_e94 * _e97) + _e104);
                    let _e108 = params.member.member_12;
                    if (_e108 > 0f) {
                        let _e112 = params.member.member_3;
                        let _e114 = (_e112.x + 1u);
                        let _e117 = ((_e112.y + 1u) * _e114);
                        let _e118 = (_e117 + _e114);
                        let _e122 = (_e118 + ((_e112.z + 1u) * _e117));
                        let _e126 = params.member.member_3[0u];
                        let _e130 = params.member.member_3[1u];
                        let _e134 = params.member.member_3[2u];
                        let _e135 = (_e85 / 2u);
                        let _e136 = (_e65 / 2u);
                        let _e137 = (_e61 / 2u);
                        let _e138 = (_e135 + 1u);
                        let _e139 = (_e126 - 1u);
                        let _e146 = ((_e85 & 1u) == 1u);
                        let _e148 = (_e136 + 1u);
                        let _e149 = (_e130 - 1u);
                        let _e156 = ((_e65 & 1u) == 1u);
                        let _e158 = (_e137 + 1u);
                        let _e159 = (_e134 - 1u);
                        let _e166 = ((_e61 & 1u) == 1u);
                        let _e168 = (_e118 + _e135);
                        let _e169 = (_e136 * _e114);
                        let _e170 = (_e168 + _e169);
                        let _e171 = (_e137 * _e117);
                        let _e172 = (_e170 + _e171);
                        if _e146 {
                            phi_292_ = _e172;
                        } else {
                            phi_292_ = (_e172 - 1u);
                        }
                        let _e175 = phi_292_;
                        if (_e175 < _e32) {
                        } else {
                            break;
                        }
                        let _e179 = coarse_opacity.member[_e175];
                        if _e146 {
                            phi_304_ = (_e56 - 1u);
                        } else {
                            phi_304_ = _e56;
                        }
                        let _e182 = phi_304_;
                        if (_e182 < _e30) {
                        } else {
                            break;
                        }
                        let _e186 = opacity.member[_e182];
                        let _e190 = ((0.25f * (1f - _e179)) + (_e179 * _e186));
                        let _e191 = (_e52 + _e56);
                        let _e192 = (_e122 + _e172);
                        if _e156 {
                            phi_324_ = _e192;
                        } else {
                            phi_324_ = (_e192 - _e114);
                        }
                        let _e195 = phi_324_;
                        if (_e195 < _e32) {
                        } else {
                            break;
                        }
                        let _e199 = coarse_opacity.member[_e195];
                        if _e156 {
                            phi_336_ = (_e191 - _e44);
                        } else {
                            phi_336_ = _e191;
                        }
                        let _e202 = phi_336_;
                        if (_e202 < _e30) {
                        } else {
                            break;
                        }
                        let _e206 = opacity.member[_e202];
                        let _e210 = ((0.25f * (1f - _e199)) + (_e199 * _e206));
                        let _e212 = ((2u * _e52) + _e56);
                        let _e214 = ((2u * _e122) + _e172);
                        if _e166 {
                            phi_358_ = _e214;
                        } else {
                            phi_358_ = (_e214 - _e117);
                        }
                        let _e217 = phi_358_;
                        if (_e217 < _e32) {
                        } else {
                            break;
                        }
                        let _e221 = coarse_opacity.member[_e217];
                        if _e166 {
                            phi_370_ = (_e212 - _e47);
                        } else {
                            phi_370_ = _e212;
                        }
                        let _e224 = phi_370_;
                        if (_e224 < _e30) {
                        } else {
                            break;
                        }
                        let _e228 = opacity.member[_e224];
                        let _e232 = ((0.25f * (1f - _e221)) + (_e221 * _e228));
                        let _e233 = (_e54 * _e122);
                        let _e234 = (_e233 + _e172);
                        if (_e234 < _e28) {
                        } else {
                            break;
                        }
                        let _e238 = coarse.member[_e234];
                        let _e239 = (1f - _e190);
                        let _e241 = (_e118 + select((select(1u, _e135, (1u < _e135)) - 1u), select(_e138, _e139, (_e139 < _e138)), _e146));
                        let _e242 = (_e241 + _e169);
                        let _e244 = (_e233 + (_e242 + _e171));
                        if (_e244 < _e28) {
                        } else {
                            break;
                        }
                        let _e248 = coarse.member[_e244];
                        let _e251 = (1f - _e210);
                        let _e253 = (select((select(1u, _e136, (1u < _e136)) - 1u), select(_e148, _e149, (_e149 < _e148)), _e156) * _e114);
                        let _e254 = (_e168 + _e253);
                        let _e256 = (_e233 + (_e254 + _e171));
                        if (_e256 < _e28) {
                        } else {
                            break;
                        }
                        let _e260 = coarse.member[_e256];
                        let _e262 = (_e241 + _e253);
                        let _e264 = (_e233 + (_e262 + _e171));
                        if (_e264 < _e28) {
                        } else {
                            break;
                        }
                        let _e268 = coarse.member[_e264];
                        let _e273 = (select((select(1u, _e137, (1u < _e137)) - 1u), select(_e158, _e159, (_e159 < _e158)), _e166) * _e117);
                        let _e275 = (_e233 + (_e170 + _e273));
                        if (_e275 < _e28) {
                        } else {
                            break;
                        }
                        let _e279 = coarse.member[_e275];
                        let _e282 = (_e233 + (_e242 + _e273));
                        if (_e282 < _e28) {
                        } else {
                            break;
                        }
                        let _e286 = coarse.member[_e282];
                        let _e291 = (_e233 + (_e254 + _e273));
                        if (_e291 < _e28) {
                        } else {
                            break;
                        }
                        let _e295 = coarse.member[_e291];
                        let _e298 = (_e233 + (_e262 + _e273));
                        if (_e298 < _e28) {
                        } else {
                            break;
                        }
                        let _e302 = coarse.member[_e298];
                        phi_519_ = (_e105 + (((((((_e238 * _e239) + (_e248 * _e190)) * _e251) + (((_e260 * _e239) + (_e268 * _e190)) * _e210)) * (1f - _e232)) + (((((_e279 * _e239) + (_e286 * _e190)) * _e251) + (((_e295 * _e239) + (_e302 * _e190)) * _e210)) * _e232)) * _e108));
                    } else {
                        phi_519_ = _e105;
                    }
                    let _e314 = phi_519_;
                    phi_520_ = _e314;
                } else {
                    phi_520_ = 0f;
                }
                let _e316 = phi_520_;
                if _e39 {
                } else {
                    break;
                }
                out.member[_e38] = _e316;
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
