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
    var phi_158_: type_11;
    var phi_161_: f32;
    var phi_163_: f32;
    var phi_165_: f32;
    var phi_167_: f32;
    var phi_169_: f32;
    var phi_159_: type_11;
    var phi_192_: type_11;
    var phi_162_: f32;
    var phi_164_: f32;
    var phi_166_: f32;
    var phi_168_: f32;
    var phi_170_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = gid_1;
            let _e34 = params.member.member_2[2u];
            let _e39 = params.member.member_2[0u];
            let _e41 = ((3u * _e39) * _e34);
            let _e45 = (_e28.x + (_e28.y * 2097152u));
            if (_e45 < ((3u * _e34) * _e39)) {
                if (_e39 == 0u) {
                    break;
                }
                let _e49 = (_e45 / _e39);
                let _e51 = (_e45 - (_e49 * _e39));
                let _e52 = params.member.member_2;
                let _e54 = (_e52.x + 1u);
                let _e57 = ((_e52.y + 1u) * _e54);
                let _e58 = (_e57 + _e54);
                let _e62 = (_e58 + ((_e52.z + 1u) * _e57));
                if (_e34 == 0u) {
                    break;
                }
                let _e65 = (_e49 / _e34);
                let _e67 = (_e49 - (_e65 * _e34));
                let _e68 = f32(_e51);
                let _e70 = select(0f, 1f, (_e68 < 0.5f));
                let _e74 = select(0f, 1f, ((f32(_e39) - 1.5f) < _e68));
                let _e76 = select(0f, 1f, (_e67 == 0u));
                let _e79 = select(0f, 1f, ((_e67 + 1u) == _e34));
                let _e83 = params.member.member_2[1u];
                phi_158_ = type_11(0u, _e83);
                phi_161_ = 0f;
                phi_163_ = 0f;
                phi_165_ = 0f;
                phi_167_ = 0f;
                phi_169_ = 0f;
                loop {
                    let _e86 = phi_158_;
                    let _e88 = phi_161_;
                    let _e90 = phi_163_;
                    let _e92 = phi_165_;
                    let _e94 = phi_167_;
                    let _e96 = phi_169_;
                    local = _e94;
                    local_1 = _e92;
                    local_2 = _e90;
                    local_3 = _e88;
                    local_4 = _e96;
                    if (_e86.member < _e86.member_1) {
                        phi_159_ = type_11((_e86.member + 1u), _e86.member_1);
                        phi_192_ = type_11(1u, _e86.member);
                    } else {
                        phi_159_ = _e86;
                        phi_192_ = type_11(0u, type_11().member_1);
                    }
                    let _e109 = phi_159_;
                    let _e111 = phi_192_;
                    let _e115 = (bitcast<i32>(_e111.member) != 0i);
                    if _e115 {
                        let _e120 = (((_e58 + _e51) + (_e111.member_1 * _e54)) + (_e67 * _e57));
                        let _e122 = ((_e65 * _e62) + _e120);
                        let _e124 = select(0f, 1f, (_e111.member_1 == 0u));
                        let _e127 = select(0f, 1f, ((_e111.member_1 + 1u) == _e83));
                        let _e130 = opacity.member[_e120];
                        let _e133 = params.member.member_8;
                        let _e134 = -(_e133);
                        let _e139 = opacity.member[(_e120 - 1u)];
                        let _e141 = (_e62 + _e120);
                        let _e144 = opacity.member[_e141];
                        let _e149 = opacity.member[(_e141 - _e54)];
                        let _e152 = ((2u * _e62) + _e120);
                        let _e155 = opacity.member[_e152];
                        let _e160 = opacity.member[(_e152 - _e57)];
                        let _e165 = state.member[(_e122 + (3u * _e62))];
                        let _e170 = state.member[(_e122 + (_e62 * 6u))];
                        let _e175 = state.member[(_e122 + (_e62 * 9u))];
                        let _e178 = state.member[_e122];
                        let _e179 = fma(_e165, 0.8944272f, _e178);
                        let _e180 = fma(_e170, 0.4472136f, _e179);
                        let _e183 = fma(_e170, -0.4472136f, _e179);
                        let _e186 = fma(_e175, 0.4472136f, _e179);
                        let _e189 = fma(_e175, -0.4472136f, _e179);
                        let _e192 = (_e178 + _e165);
                        let _e198 = -(_e165);
                        let _e199 = fma(_e198, 0.8944272f, _e178);
                        let _e200 = fma(_e170, 0.4472136f, _e199);
                        let _e203 = fma(_e170, -0.4472136f, _e199);
                        let _e206 = fma(_e175, 0.4472136f, _e199);
                        let _e209 = fma(_e175, -0.4472136f, _e199);
                        let _e212 = (_e178 + _e198);
                        let _e219 = fma(select(0f, _e192, (0f < _e192)), 0.4006697f, (((select(0f, _e180, (0f < _e180)) + select(0f, _e183, (0f < _e183))) + (select(0f, _e186, (0f < _e186)) + select(0f, _e189, (0f < _e189)))) * 0.42343134f));
                        let _e221 = fma(select(0f, _e212, (0f < _e212)), 0.4006697f, (((select(0f, _e200, (0f < _e200)) + select(0f, _e203, (0f < _e203))) + (select(0f, _e206, (0f < _e206)) + select(0f, _e209, (0f < _e209)))) * 0.42343134f));
                        let _e222 = fma(_e170, 0.8944272f, _e178);
                        let _e223 = fma(_e175, 0.4472136f, _e222);
                        let _e226 = fma(_e175, -0.4472136f, _e222);
                        let _e229 = fma(_e165, 0.4472136f, _e222);
                        let _e232 = fma(_e165, -0.4472136f, _e222);
                        let _e235 = (_e178 + _e170);
                        let _e241 = -(_e170);
                        let _e242 = fma(_e241, 0.8944272f, _e178);
                        let _e243 = fma(_e175, 0.4472136f, _e242);
                        let _e246 = fma(_e175, -0.4472136f, _e242);
                        let _e249 = fma(_e165, 0.4472136f, _e242);
                        let _e252 = fma(_e165, -0.4472136f, _e242);
                        let _e255 = (_e178 + _e241);
                        let _e262 = fma(select(0f, _e235, (0f < _e235)), 0.4006697f, (((select(0f, _e223, (0f < _e223)) + select(0f, _e226, (0f < _e226))) + (select(0f, _e229, (0f < _e229)) + select(0f, _e232, (0f < _e232)))) * 0.42343134f));
                        let _e264 = fma(select(0f, _e255, (0f < _e255)), 0.4006697f, (((select(0f, _e243, (0f < _e243)) + select(0f, _e246, (0f < _e246))) + (select(0f, _e249, (0f < _e249)) + select(0f, _e252, (0f < _e252)))) * 0.42343134f));
                        let _e265 = fma(_e175, 0.8944272f, _e178);
                        let _e266 = fma(_e165, 0.4472136f, _e265);
                        let _e269 = fma(_e165, -0.4472136f, _e265);
                        let _e272 = fma(_e170, 0.4472136f, _e265);
                        let _e275 = fma(_e170, -0.4472136f, _e265);
                        let _e278 = (_e178 + _e175);
                        let _e284 = -(_e175);
                        let _e285 = fma(_e284, 0.8944272f, _e178);
                        let _e286 = fma(_e165, 0.4472136f, _e285);
                        let _e289 = fma(_e165, -0.4472136f, _e285);
                        let _e292 = fma(_e170, 0.4472136f, _e285);
                        let _e295 = fma(_e170, -0.4472136f, _e285);
                        let _e298 = (_e178 + _e284);
                        let _e305 = fma(select(0f, _e278, (0f < _e278)), 0.4006697f, (((select(0f, _e266, (0f < _e266)) + select(0f, _e269, (0f < _e269))) + (select(0f, _e272, (0f < _e272)) + select(0f, _e275, (0f < _e275)))) * 0.42343134f));
                        let _e307 = fma(select(0f, _e298, (0f < _e298)), 0.4006697f, (((select(0f, _e286, (0f < _e286)) + select(0f, _e289, (0f < _e289))) + (select(0f, _e292, (0f < _e292)) + select(0f, _e295, (0f < _e295)))) * 0.42343134f));
                        let _e312 = (((_e219 + _e221) + (_e262 + _e264)) + (_e305 + _e307));
                        let _e350 = state.member[((_e62 * 15u) + _e122)];
                        phi_162_ = select(_e312, _e88, (_e312 < _e88));
                        phi_164_ = fma((_e307 * (1f - _e76)), (1f - fma(_e160, _e134, 1f)), fma((_e305 * (1f - _e79)), (1f - fma(_e155, _e134, 1f)), fma((_e264 * (1f - _e124)), (1f - fma(_e149, _e134, 1f)), fma((_e262 * (1f - _e127)), (1f - fma(_e144, _e134, 1f)), fma((_e221 * (1f - _e70)), (1f - fma(_e139, _e134, 1f)), fma((_e219 * (1f - _e74)), (1f - fma(_e130, _e134, 1f)), _e90))))));
                        phi_166_ = fma(_e307, _e76, fma(_e305, _e79, fma(_e264, _e124, fma(_e262, _e127, fma(_e221, _e70, fma(_e219, _e74, _e92))))));
                        phi_168_ = (_e94 + _e312);
                        phi_170_ = select(_e350, _e96, (_e350 < _e96));
                    } else {
                        phi_162_ = f32();
                        phi_164_ = f32();
                        phi_166_ = f32();
                        phi_168_ = f32();
                        phi_170_ = f32();
                    }
                    let _e354 = phi_162_;
                    let _e356 = phi_164_;
                    let _e358 = phi_166_;
                    let _e360 = phi_168_;
                    let _e362 = phi_170_;
                    continue;
                    continuing {
                        phi_158_ = _e109;
                        phi_161_ = _e354;
                        phi_163_ = _e356;
                        phi_165_ = _e358;
                        phi_167_ = _e360;
                        phi_169_ = _e362;
                        break if !(_e115);
                    }
                }
                let _e367 = local;
                out.member[_e45] = _e367;
                let _e372 = local_1;
                out.member[(_e41 + _e45)] = _e372;
                let _e378 = local_2;
                out.member[((2u * _e41) + _e45)] = _e378;
                let _e384 = local_3;
                out.member[((3u * _e41) + _e45)] = _e384;
                let _e390 = local_4;
                out.member[((4u * _e41) + _e45)] = _e390;
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
