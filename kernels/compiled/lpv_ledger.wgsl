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
    var phi_162_: type_12;
    var phi_165_: f32;
    var phi_167_: f32;
    var phi_169_: f32;
    var phi_171_: f32;
    var phi_173_: f32;
    var phi_163_: type_12;
    var phi_196_: type_12;
    var phi_166_: f32;
    var phi_168_: f32;
    var phi_170_: f32;
    var phi_172_: f32;
    var phi_174_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: f32;
    var phi_597_: type_12;
    var phi_598_: type_12;
    var phi_621_: type_12;
    var phi_651_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = gid_1;
            let _e40 = params.member.member_2[1u];
            let _e45 = params.member.member_2[0u];
            let _e51 = (_e32.x + (_e32.y * 2097152u));
            if (_e51 < ((3u * _e40) * _e45)) {
                if (_e45 == 0u) {
                    break;
                }
                let _e55 = (_e51 / _e45);
                let _e57 = (_e51 - (_e55 * _e45));
                let _e58 = params.member.member_2;
                let _e60 = (_e58.x + 1u);
                let _e63 = ((_e58.y + 1u) * _e60);
                let _e64 = (_e63 + _e60);
                let _e68 = (_e64 + ((_e58.z + 1u) * _e63));
                if (_e40 == 0u) {
                    break;
                }
                let _e71 = (_e55 / _e40);
                let _e73 = (_e55 - (_e71 * _e40));
                let _e74 = f32(_e57);
                let _e76 = select(0f, 1f, (_e74 < 0.5f));
                let _e80 = select(0f, 1f, ((f32(_e45) - 1.5f) < _e74));
                let _e82 = select(0f, 1f, (_e73 == 0u));
                let _e85 = select(0f, 1f, ((_e73 + 1u) == _e40));
                let _e89 = params.member.member_2[2u];
                phi_162_ = type_12(0u, _e89);
                phi_165_ = 0f;
                phi_167_ = 0f;
                phi_169_ = 0f;
                phi_171_ = 0f;
                phi_173_ = 0f;
                loop {
                    let _e92 = phi_162_;
                    let _e94 = phi_165_;
                    let _e96 = phi_167_;
                    let _e98 = phi_169_;
                    let _e100 = phi_171_;
                    let _e102 = phi_173_;
                    local_1 = _e100;
                    local_2 = _e98;
                    local_3 = _e96;
                    local_4 = _e94;
                    local_5 = _e102;
                    if (_e92.member < _e92.member_1) {
                        phi_163_ = type_12((_e92.member + 1u), _e92.member_1);
                        phi_196_ = type_12(1u, _e92.member);
                    } else {
                        phi_163_ = _e92;
                        phi_196_ = type_12(0u, type_12().member_1);
                    }
                    let _e115 = phi_163_;
                    let _e117 = phi_196_;
                    let _e121 = (bitcast<i32>(_e117.member) != 0i);
                    if _e121 {
                        let _e126 = (((_e64 + _e57) + (_e73 * _e60)) + (_e117.member_1 * _e63));
                        let _e128 = ((_e71 * _e68) + _e126);
                        let _e130 = select(0f, 1f, (_e117.member_1 == 0u));
                        let _e133 = select(0f, 1f, ((_e117.member_1 + 1u) == _e89));
                        let _e136 = opacity.member[_e126];
                        let _e139 = params.member.member_8;
                        let _e144 = opacity.member[(_e126 - 1u)];
                        let _e146 = (_e68 + _e126);
                        let _e149 = opacity.member[_e146];
                        let _e154 = opacity.member[(_e146 - _e60)];
                        let _e157 = ((2u * _e68) + _e126);
                        let _e160 = opacity.member[_e157];
                        let _e165 = opacity.member[(_e157 - _e63)];
                        let _e170 = state.member[(_e128 + (3u * _e68))];
                        let _e175 = state.member[(_e128 + (_e68 * 6u))];
                        let _e180 = state.member[(_e128 + (_e68 * 9u))];
                        let _e183 = state.member[_e128];
                        let _e185 = (_e183 + (_e170 * 0.8944272f));
                        let _e186 = (_e175 * 0.4472136f);
                        let _e187 = (_e180 * 0.4472136f);
                        let _e188 = (_e185 + _e186);
                        let _e191 = (_e185 - _e186);
                        let _e194 = (_e185 + _e187);
                        let _e197 = (_e185 - _e187);
                        let _e200 = (_e183 + _e170);
                        let _e210 = (_e183 + (_e170 * -0.8944272f));
                        let _e211 = (_e210 + _e186);
                        let _e214 = (_e210 - _e186);
                        let _e217 = (_e210 + _e187);
                        let _e220 = (_e210 - _e187);
                        let _e223 = (_e183 + -(_e170));
                        let _e231 = ((select(0f, _e200, (0f < _e200)) * 0.4006697f) + (((select(0f, _e188, (0f < _e188)) + select(0f, _e191, (0f < _e191))) + (select(0f, _e194, (0f < _e194)) + select(0f, _e197, (0f < _e197)))) * 0.42343134f));
                        let _e232 = ((select(0f, _e223, (0f < _e223)) * 0.4006697f) + (((select(0f, _e211, (0f < _e211)) + select(0f, _e214, (0f < _e214))) + (select(0f, _e217, (0f < _e217)) + select(0f, _e220, (0f < _e220)))) * 0.42343134f));
                        let _e234 = (_e183 + (_e175 * 0.8944272f));
                        let _e235 = (_e170 * 0.4472136f);
                        let _e236 = (_e234 + _e187);
                        let _e239 = (_e234 - _e187);
                        let _e242 = (_e234 + _e235);
                        let _e245 = (_e234 - _e235);
                        let _e248 = (_e183 + _e175);
                        let _e258 = (_e183 + (_e175 * -0.8944272f));
                        let _e259 = (_e258 + _e187);
                        let _e262 = (_e258 - _e187);
                        let _e265 = (_e258 + _e235);
                        let _e268 = (_e258 - _e235);
                        let _e271 = (_e183 + -(_e175));
                        let _e279 = ((select(0f, _e248, (0f < _e248)) * 0.4006697f) + (((select(0f, _e236, (0f < _e236)) + select(0f, _e239, (0f < _e239))) + (select(0f, _e242, (0f < _e242)) + select(0f, _e245, (0f < _e245)))) * 0.42343134f));
                        let _e280 = ((select(0f, _e271, (0f < _e271)) * 0.4006697f) + (((select(0f, _e259, (0f < _e259)) + select(0f, _e262, (0f < _e262))) + (select(0f, _e265, (0f < _e265)) + select(0f, _e268, (0f < _e268)))) * 0.42343134f));
                        let _e282 = (_e183 + (_e180 * 0.8944272f));
                        let _e283 = (_e282 + _e235);
                        let _e286 = (_e282 - _e235);
                        let _e289 = (_e282 + _e186);
                        let _e292 = (_e282 - _e186);
                        let _e295 = (_e183 + _e180);
                        let _e305 = (_e183 + (_e180 * -0.8944272f));
                        let _e306 = (_e305 + _e235);
                        let _e309 = (_e305 - _e235);
                        let _e312 = (_e305 + _e186);
                        let _e315 = (_e305 - _e186);
                        let _e318 = (_e183 + -(_e180));
                        let _e326 = ((select(0f, _e295, (0f < _e295)) * 0.4006697f) + (((select(0f, _e283, (0f < _e283)) + select(0f, _e286, (0f < _e286))) + (select(0f, _e289, (0f < _e289)) + select(0f, _e292, (0f < _e292)))) * 0.42343134f));
                        let _e327 = ((select(0f, _e318, (0f < _e318)) * 0.4006697f) + (((select(0f, _e306, (0f < _e306)) + select(0f, _e309, (0f < _e309))) + (select(0f, _e312, (0f < _e312)) + select(0f, _e315, (0f < _e315)))) * 0.42343134f));
                        let _e332 = (((_e231 + _e232) + (_e279 + _e280)) + (_e326 + _e327));
                        let _e376 = state.member[((_e68 * 15u) + _e128)];
                        phi_166_ = select(_e332, _e94, (_e332 < _e94));
                        phi_168_ = ((((((_e96 + ((_e231 * (1f - _e80)) * (_e136 * _e139))) + ((_e232 * (1f - _e76)) * (_e144 * _e139))) + ((_e279 * (1f - _e85)) * (_e149 * _e139))) + ((_e280 * (1f - _e82)) * (_e154 * _e139))) + ((_e326 * (1f - _e133)) * (_e160 * _e139))) + ((_e327 * (1f - _e130)) * (_e165 * _e139)));
                        phi_170_ = ((((((_e98 + (_e231 * _e80)) + (_e232 * _e76)) + (_e279 * _e85)) + (_e280 * _e82)) + (_e326 * _e133)) + (_e327 * _e130));
                        phi_172_ = (_e100 + _e332);
                        phi_174_ = select(_e376, _e102, (_e376 < _e102));
                    } else {
                        phi_166_ = f32();
                        phi_168_ = f32();
                        phi_170_ = f32();
                        phi_172_ = f32();
                        phi_174_ = f32();
                    }
                    let _e380 = phi_166_;
                    let _e382 = phi_168_;
                    let _e384 = phi_170_;
                    let _e386 = phi_172_;
                    let _e388 = phi_174_;
                    continue;
                    continuing {
                        phi_162_ = _e115;
                        phi_165_ = _e380;
                        phi_167_ = _e382;
                        phi_169_ = _e384;
                        phi_171_ = _e386;
                        phi_173_ = _e388;
                        break if !(_e121);
                    }
                }
                let _e391 = local_1;
                let _e393 = local_2;
                let _e395 = local_3;
                let _e397 = local_4;
                let _e399 = local_5;
                local = array<f32, 5>(_e391, _e393, _e395, _e397, _e399);
                phi_597_ = type_12(0u, 5u);
                loop {
                    let _e402 = phi_597_;
                    if (_e402.member < _e402.member_1) {
                        phi_598_ = type_12((_e402.member + 1u), _e402.member_1);
                        phi_621_ = type_12(1u, _e402.member);
                    } else {
                        phi_598_ = _e402;
                        phi_621_ = type_12(0u, type_12().member_1);
                    }
                    let _e415 = phi_598_;
                    let _e417 = phi_621_;
                    let _e421 = (bitcast<i32>(_e417.member) != 0i);
                    if _e421 {
                        if (_e417.member_1 < 5u) {
                        } else {
                            phi_651_ = true;
                            break;
                        }
                        let _e424 = local[_e417.member_1];
                        let _e426 = ((_e417.member_1 * ((3u * _e45) * _e40)) + _e51);
                        if (_e426 < arrayLength((&out.member))) {
                        } else {
                            phi_651_ = true;
                            break;
                        }
                        out.member[_e426] = _e424;
                    }
                    continue;
                    continuing {
                        phi_597_ = _e415;
                        phi_651_ = false;
                        break if !(_e421);
                    }
                }
                let _e432 = phi_651_;
                if _e432 {
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
