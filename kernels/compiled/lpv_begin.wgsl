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
var<storage> source: type_5;
@group(0) @binding(2) 
var<storage> before: type_5;

fn function_() {
    var local: array<f32, 11>;
    var phi_122_: u32;
    var phi_205_: bool;
    var phi_207_: bool;
    var phi_208_: bool;
    var phi_839_: bool;
    var phi_761_: array<f32, 11>;
    var phi_776_: type_11;
    var phi_777_: type_11;
    var phi_800_: type_11;
    var phi_844_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e50 = gid_1;
            let _e52 = arrayLength((&source.member));
            let _e54 = arrayLength((&before.member));
            let _e59 = params.member.member_2;
            let _e61 = (_e59.x + 1u);
            let _e63 = (_e59.y + 1u);
            let _e64 = (_e63 * _e61);
            let _e69 = ((_e64 + _e61) + ((_e59.z + 1u) * _e64));
            if (_e59.x > 0u) {
                if (_e61 == 0u) {
                    break;
                }
                phi_122_ = (3u * (_e69 / _e61));
            } else {
                phi_122_ = 0u;
            }
            let _e75 = phi_122_;
            let _e76 = (3u * _e69);
            let _e80 = (_e50.x + (_e50.y * 2097152u));
            if (_e80 < (_e75 * _e59.x)) {
                if (_e59.x == 0u) {
                    break;
                }
                let _e84 = (_e80 / _e59.x);
                let _e88 = ((_e84 * _e61) + (_e80 - (_e84 * _e59.x)));
                let _e89 = (_e61 == 0u);
                if _e89 {
                    break;
                }
                let _e90 = (_e69 / _e61);
                if (_e90 == 0u) {
                    break;
                }
                if _e89 {
                    break;
                }
                let _e94 = (_e84 - ((_e84 / _e90) * _e90));
                let _e95 = (_e59.y + 2u);
                let _e98 = (select(_e95, _e94, (_e95 < _e94)) - _e95);
                if (_e63 == 0u) {
                    break;
                }
                let _e100 = (_e98 / _e63);
                if (_e94 >= _e95) {
                    let _e104 = ((_e98 - (_e100 * _e63)) < _e59.y);
                    if _e104 {
                        phi_205_ = (_e100 < _e59.z);
                    } else {
                        phi_205_ = bool();
                    }
                    let _e107 = phi_205_;
                    phi_207_ = _e107;
                    phi_208_ = select(true, false, _e104);
                } else {
                    phi_207_ = bool();
                    phi_208_ = true;
                }
                let _e110 = phi_207_;
                let _e112 = phi_208_;
                if select(_e110, false, _e112) {
                    let _e114 = (_e88 + _e76);
                    if (_e114 < _e52) {
                    } else {
                        break;
                    }
                    let _e118 = source.member[_e114];
                    let _e120 = (_e88 + (_e69 * 6u));
                    if (_e120 < _e52) {
                    } else {
                        break;
                    }
                    let _e124 = source.member[_e120];
                    let _e126 = (_e88 + (_e69 * 9u));
                    if (_e126 < _e52) {
                    } else {
                        break;
                    }
                    let _e130 = source.member[_e126];
                    if (_e88 < _e52) {
                    } else {
                        break;
                    }
                    let _e134 = source.member[_e88];
                    let _e137 = params.member.member_9;
                    let _e141 = params.member.member_4[3u];
                    let _e144 = params.member.member_6;
                    let _e145 = (0.000000000000000001f < _e134);
                    let _e146 = select(0f, _e134, _e145);
                    let _e148 = (1f / select(1f, _e146, _e145));
                    let _e149 = (_e118 * _e148);
                    let _e150 = (_e124 * _e148);
                    let _e151 = (_e130 * _e148);
                    let _e156 = (((_e149 * _e149) + (_e150 * _e150)) + (_e151 * _e151));
                    let _e160 = (1f / sqrt(select(1f, _e156, (1f < _e156))));
                    let _e161 = (_e149 * _e160);
                    let _e162 = (_e150 * _e160);
                    let _e163 = (_e151 * _e160);
                    let _e165 = ((_e156 * _e160) * _e160);
                    let _e166 = sqrt(_e165);
                    if (_e144 != _e144) {
                        phi_839_ = true;
                    } else {
                        phi_839_ = (0.33333334f >= _e144);
                    }
                    let _e170 = phi_839_;
                    let _e171 = select(_e144, 0.33333334f, _e170);
                    let _e174 = (3f * select(_e171, _e166, (_e166 < _e171)));
                    let _e176 = (3f - _e174);
                    let _e178 = (0.31830987f / (_e176 * _e176));
                    let _e181 = (_e166 < select(2f, 0.33333334f, (_e144 > 0.33333334f)));
                    let _e186 = select(((2f - _e174) * _e178), 0.07957747f, _e181);
                    let _e187 = select((_e178 / select(0.33333334f, _e166, (0.33333334f < _e166))), 0.2387324f, _e181);
                    let _e188 = (_e161 * _e187);
                    let _e189 = (_e162 * _e187);
                    let _e190 = (_e163 * _e187);
                    let _e192 = (_e186 + (_e188 * 0.8944272f));
                    let _e193 = (_e189 * 0.4472136f);
                    let _e194 = (_e190 * 0.4472136f);
                    let _e195 = (_e192 + _e193);
                    let _e197 = select(0f, _e195, (0f < _e195));
                    let _e198 = (_e192 - _e193);
                    let _e200 = select(0f, _e198, (0f < _e198));
                    let _e201 = (_e192 + _e194);
                    let _e203 = select(0f, _e201, (0f < _e201));
                    let _e204 = (_e192 - _e194);
                    let _e206 = select(0f, _e204, (0f < _e204));
                    let _e207 = (_e186 + _e188);
                    let _e210 = (select(0f, _e207, (0f < _e207)) * 0.4006697f);
                    let _e214 = (((_e197 + _e200) + (_e203 + _e206)) * 0.42343134f);
                    let _e219 = (_e186 + (_e188 * -0.8944272f));
                    let _e220 = (_e219 + _e193);
                    let _e222 = select(0f, _e220, (0f < _e220));
                    let _e223 = (_e219 - _e193);
                    let _e225 = select(0f, _e223, (0f < _e223));
                    let _e226 = (_e219 + _e194);
                    let _e228 = select(0f, _e226, (0f < _e226));
                    let _e229 = (_e219 - _e194);
                    let _e231 = select(0f, _e229, (0f < _e229));
                    let _e232 = (_e186 + -(_e188));
                    let _e235 = (select(0f, _e232, (0f < _e232)) * 0.4006697f);
                    let _e239 = (((_e222 + _e225) + (_e228 + _e231)) * 0.42343134f);
                    let _e242 = (_e210 + _e214);
                    let _e243 = (_e235 + _e239);
                    let _e252 = (_e186 + (_e189 * 0.8944272f));
                    let _e253 = (_e188 * 0.4472136f);
                    let _e254 = (_e252 + _e194);
                    let _e256 = select(0f, _e254, (0f < _e254));
                    let _e257 = (_e252 - _e194);
                    let _e259 = select(0f, _e257, (0f < _e257));
                    let _e260 = (_e252 + _e253);
                    let _e262 = select(0f, _e260, (0f < _e260));
                    let _e263 = (_e252 - _e253);
                    let _e265 = select(0f, _e263, (0f < _e263));
                    let _e266 = (_e186 + _e189);
                    let _e269 = (select(0f, _e266, (0f < _e266)) * 0.4006697f);
                    let _e273 = (((_e256 + _e259) + (_e262 + _e265)) * 0.42343134f);
                    let _e278 = (_e186 + (_e189 * -0.8944272f));
                    let _e279 = (_e278 + _e194);
                    let _e281 = select(0f, _e279, (0f < _e279));
                    let _e282 = (_e278 - _e194);
                    let _e284 = select(0f, _e282, (0f < _e282));
                    let _e285 = (_e278 + _e253);
                    let _e287 = select(0f, _e285, (0f < _e285));
                    let _e288 = (_e278 - _e253);
                    let _e290 = select(0f, _e288, (0f < _e288));
                    let _e291 = (_e186 + -(_e189));
                    let _e294 = (select(0f, _e291, (0f < _e291)) * 0.4006697f);
                    let _e298 = (((_e281 + _e284) + (_e287 + _e290)) * 0.42343134f);
                    let _e301 = (_e269 + _e273);
                    let _e302 = (_e294 + _e298);
                    let _e315 = (_e186 + (_e190 * 0.8944272f));
                    let _e316 = (_e315 + _e253);
                    let _e318 = select(0f, _e316, (0f < _e316));
                    let _e319 = (_e315 - _e253);
                    let _e321 = select(0f, _e319, (0f < _e319));
                    let _e322 = (_e315 + _e193);
                    let _e324 = select(0f, _e322, (0f < _e322));
                    let _e325 = (_e315 - _e193);
                    let _e327 = select(0f, _e325, (0f < _e325));
                    let _e328 = (_e186 + _e190);
                    let _e331 = (select(0f, _e328, (0f < _e328)) * 0.4006697f);
                    let _e335 = (((_e318 + _e321) + (_e324 + _e327)) * 0.42343134f);
                    let _e340 = (_e186 + (_e190 * -0.8944272f));
                    let _e341 = (_e340 + _e253);
                    let _e343 = select(0f, _e341, (0f < _e341));
                    let _e344 = (_e340 - _e253);
                    let _e346 = select(0f, _e344, (0f < _e344));
                    let _e347 = (_e340 + _e193);
                    let _e349 = select(0f, _e347, (0f < _e347));
                    let _e350 = (_e340 - _e193);
                    let _e352 = select(0f, _e350, (0f < _e350));
                    let _e353 = (_e186 + -(_e190));
                    let _e356 = (select(0f, _e353, (0f < _e353)) * 0.4006697f);
                    let _e360 = (((_e343 + _e346) + (_e349 + _e352)) * 0.42343134f);
                    let _e363 = (_e331 + _e335);
                    let _e364 = (_e356 + _e360);
                    let _e369 = (((0.18936425f * (((_e203 - _e206) + (_e228 - _e231)) + ((_e256 - _e259) + (_e281 - _e284)))) + (_e331 - _e356)) + ((_e335 - _e360) * 0.8944272f));
                    let _e372 = ((((_e210 - _e235) + ((_e214 - _e239) * 0.8944272f)) + (((_e262 - _e265) + (_e287 - _e290)) * 0.18936425f)) + (((_e318 - _e321) + (_e343 - _e346)) * 0.18936425f));
                    let _e375 = ((((((_e197 - _e200) + (_e222 - _e225)) * 0.18936425f) + (_e269 - _e294)) + ((_e273 - _e298) * 0.8944272f)) + (((_e324 - _e327) + (_e349 - _e352)) * 0.18936425f));
                    let _e376 = (_e242 + _e243);
                    let _e377 = (_e301 + _e302);
                    let _e379 = (_e363 + _e364);
                    let _e381 = (1f / ((_e376 + _e377) + _e379));
                    let _e384 = ((_e381 * _e137) + (1f - _e137));
                    let _e396 = (_e146 * _e384);
                    let _e398 = (_e396 * _e187);
                    let _e400 = ((_e146 * _e381) * 0.7329038f);
                    let _e425 = params.member.member_10;
                    let _e434 = params.member.member_11;
                    let _e436 = ((_e69 * 15u) + _e88);
                    if (_e436 < _e54) {
                    } else {
                        break;
                    }
                    let _e440 = before.member[_e436];
                    let _e444 = ((_e69 * 18u) + _e88);
                    if (_e444 < _e54) {
                    } else {
                        break;
                    }
                    let _e448 = before.member[_e444];
                    let _e452 = ((_e69 * 21u) + _e88);
                    if (_e452 < _e54) {
                    } else {
                        break;
                    }
                    let _e456 = before.member[_e452];
                    let _e460 = ((_e69 * 24u) + _e88);
                    if (_e460 < _e54) {
                    } else {
                        break;
                    }
                    let _e464 = before.member[_e460];
                    let _e468 = ((_e69 * 27u) + _e88);
                    if (_e468 < _e54) {
                    } else {
                        break;
                    }
                    let _e472 = before.member[_e468];
                    let _e476 = ((_e69 * 30u) + _e88);
                    if (_e476 < _e54) {
                    } else {
                        break;
                    }
                    let _e480 = before.member[_e476];
                    phi_761_ = array<f32, 11>((_e396 * _e186), (_e161 * _e398), (_e162 * _e398), (_e163 * _e398), select(1f, ((sqrt(((_e165 + 0.0001f) / ((((((_e372 * _e372) + (_e375 * _e375)) + (_e369 * _e369)) * _e384) * _e384) + 0.0001f))) * _e141) + (1f - _e141)), _e145), (((_e146 * 0.2820948f) * _e425) + (_e434 * _e440)), ((((_e301 - _e302) * _e400) * _e425) + (_e434 * _e448)), ((((_e363 - _e364) * _e400) * _e425) + (_e434 * _e456)), ((((_e242 - _e243) * _e400) * _e425) + (_e434 * _e464)), ((((((_e379 * _e381) - 0.33333334f) * _e146) * 1.5138805f) * _e425) + (_e434 * _e472)), ((((((_e376 - _e377) * _e381) * _e146) * 0.8740393f) * _e425) + (_e434 * _e480)));
                } else {
                    phi_761_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e485 = phi_761_;
                local = array<f32, 11>(_e485[0], _e485[1], _e485[2], _e485[3], _e485[4], _e485[5], _e485[6], _e485[7], _e485[8], _e485[9], _e485[10]);
                phi_776_ = type_11(0u, 11u);
                loop {
                    let _e499 = phi_776_;
                    if (_e499.member < _e499.member_1) {
                        phi_777_ = type_11((_e499.member + 1u), _e499.member_1);
                        phi_800_ = type_11(1u, _e499.member);
                    } else {
                        phi_777_ = _e499;
                        phi_800_ = type_11(0u, type_11().member_1);
                    }
                    let _e512 = phi_777_;
                    let _e514 = phi_800_;
                    let _e518 = (bitcast<i32>(_e514.member) != 0i);
                    if _e518 {
                        if (_e514.member_1 < 11u) {
                        } else {
                            phi_844_ = true;
                            break;
                        }
                        let _e521 = local[_e514.member_1];
                        let _e523 = ((_e514.member_1 * _e76) + _e88);
                        if (_e523 < arrayLength((&out.member))) {
                        } else {
                            phi_844_ = true;
                            break;
                        }
                        out.member[_e523] = _e521;
                    }
                    continue;
                    continuing {
                        phi_776_ = _e512;
                        phi_844_ = false;
                        break if !(_e518);
                    }
                }
                let _e529 = phi_844_;
                if _e529 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_begin(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
