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
    var phi_157_: type_11;
    var phi_160_: f32;
    var phi_162_: f32;
    var phi_164_: f32;
    var phi_166_: f32;
    var phi_168_: f32;
    var phi_158_: type_11;
    var phi_191_: type_11;
    var phi_161_: f32;
    var phi_163_: f32;
    var phi_165_: f32;
    var phi_167_: f32;
    var phi_169_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = gid_1;
            let _e34 = params.member.member_2[1u];
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
                let _e83 = params.member.member_2[2u];
                phi_157_ = type_11(0u, _e83);
                phi_160_ = 0f;
                phi_162_ = 0f;
                phi_164_ = 0f;
                phi_166_ = 0f;
                phi_168_ = 0f;
                loop {
                    let _e86 = phi_157_;
                    let _e88 = phi_160_;
                    let _e90 = phi_162_;
                    let _e92 = phi_164_;
                    let _e94 = phi_166_;
                    let _e96 = phi_168_;
                    local = _e94;
                    local_1 = _e92;
                    local_2 = _e90;
                    local_3 = _e88;
                    local_4 = _e96;
                    if (_e86.member < _e86.member_1) {
                        phi_158_ = type_11((_e86.member + 1u), _e86.member_1);
                        phi_191_ = type_11(1u, _e86.member);
                    } else {
                        phi_158_ = _e86;
                        phi_191_ = type_11(0u, type_11().member_1);
                    }
                    let _e109 = phi_158_;
                    let _e111 = phi_191_;
                    let _e115 = (bitcast<i32>(_e111.member) != 0i);
                    if _e115 {
                        let _e120 = (((_e58 + _e51) + (_e67 * _e54)) + (_e111.member_1 * _e57));
                        let _e122 = ((_e65 * _e62) + _e120);
                        let _e124 = select(0f, 1f, (_e111.member_1 == 0u));
                        let _e127 = select(0f, 1f, ((_e111.member_1 + 1u) == _e83));
                        let _e130 = opacity.member[_e120];
                        let _e133 = params.member.member_8;
                        let _e138 = opacity.member[(_e120 - 1u)];
                        let _e140 = (_e62 + _e120);
                        let _e143 = opacity.member[_e140];
                        let _e148 = opacity.member[(_e140 - _e54)];
                        let _e151 = ((2u * _e62) + _e120);
                        let _e154 = opacity.member[_e151];
                        let _e159 = opacity.member[(_e151 - _e57)];
                        let _e164 = state.member[(_e122 + (3u * _e62))];
                        let _e169 = state.member[(_e122 + (_e62 * 6u))];
                        let _e174 = state.member[(_e122 + (_e62 * 9u))];
                        let _e177 = state.member[_e122];
                        let _e179 = (_e177 + (_e164 * 0.8944272f));
                        let _e180 = (_e169 * 0.4472136f);
                        let _e181 = (_e174 * 0.4472136f);
                        let _e182 = (_e179 + _e180);
                        let _e185 = (_e179 - _e180);
                        let _e188 = (_e179 + _e181);
                        let _e191 = (_e179 - _e181);
                        let _e194 = (_e177 + _e164);
                        let _e204 = (_e177 + (_e164 * -0.8944272f));
                        let _e205 = (_e204 + _e180);
                        let _e208 = (_e204 - _e180);
                        let _e211 = (_e204 + _e181);
                        let _e214 = (_e204 - _e181);
                        let _e217 = (_e177 + -(_e164));
                        let _e225 = ((select(0f, _e194, (0f < _e194)) * 0.4006697f) + (((select(0f, _e182, (0f < _e182)) + select(0f, _e185, (0f < _e185))) + (select(0f, _e188, (0f < _e188)) + select(0f, _e191, (0f < _e191)))) * 0.42343134f));
                        let _e226 = ((select(0f, _e217, (0f < _e217)) * 0.4006697f) + (((select(0f, _e205, (0f < _e205)) + select(0f, _e208, (0f < _e208))) + (select(0f, _e211, (0f < _e211)) + select(0f, _e214, (0f < _e214)))) * 0.42343134f));
                        let _e228 = (_e177 + (_e169 * 0.8944272f));
                        let _e229 = (_e164 * 0.4472136f);
                        let _e230 = (_e228 + _e181);
                        let _e233 = (_e228 - _e181);
                        let _e236 = (_e228 + _e229);
                        let _e239 = (_e228 - _e229);
                        let _e242 = (_e177 + _e169);
                        let _e252 = (_e177 + (_e169 * -0.8944272f));
                        let _e253 = (_e252 + _e181);
                        let _e256 = (_e252 - _e181);
                        let _e259 = (_e252 + _e229);
                        let _e262 = (_e252 - _e229);
                        let _e265 = (_e177 + -(_e169));
                        let _e273 = ((select(0f, _e242, (0f < _e242)) * 0.4006697f) + (((select(0f, _e230, (0f < _e230)) + select(0f, _e233, (0f < _e233))) + (select(0f, _e236, (0f < _e236)) + select(0f, _e239, (0f < _e239)))) * 0.42343134f));
                        let _e274 = ((select(0f, _e265, (0f < _e265)) * 0.4006697f) + (((select(0f, _e253, (0f < _e253)) + select(0f, _e256, (0f < _e256))) + (select(0f, _e259, (0f < _e259)) + select(0f, _e262, (0f < _e262)))) * 0.42343134f));
                        let _e276 = (_e177 + (_e174 * 0.8944272f));
                        let _e277 = (_e276 + _e229);
                        let _e280 = (_e276 - _e229);
                        let _e283 = (_e276 + _e180);
                        let _e286 = (_e276 - _e180);
                        let _e289 = (_e177 + _e174);
                        let _e299 = (_e177 + (_e174 * -0.8944272f));
                        let _e300 = (_e299 + _e229);
                        let _e303 = (_e299 - _e229);
                        let _e306 = (_e299 + _e180);
                        let _e309 = (_e299 - _e180);
                        let _e312 = (_e177 + -(_e174));
                        let _e320 = ((select(0f, _e289, (0f < _e289)) * 0.4006697f) + (((select(0f, _e277, (0f < _e277)) + select(0f, _e280, (0f < _e280))) + (select(0f, _e283, (0f < _e283)) + select(0f, _e286, (0f < _e286)))) * 0.42343134f));
                        let _e321 = ((select(0f, _e312, (0f < _e312)) * 0.4006697f) + (((select(0f, _e300, (0f < _e300)) + select(0f, _e303, (0f < _e303))) + (select(0f, _e306, (0f < _e306)) + select(0f, _e309, (0f < _e309)))) * 0.42343134f));
                        let _e326 = (((_e225 + _e226) + (_e273 + _e274)) + (_e320 + _e321));
                        let _e370 = state.member[((_e62 * 15u) + _e122)];
                        phi_161_ = select(_e326, _e88, (_e326 < _e88));
                        phi_163_ = ((((((_e90 + ((_e225 * (1f - _e74)) * (_e130 * _e133))) + ((_e226 * (1f - _e70)) * (_e138 * _e133))) + ((_e273 * (1f - _e79)) * (_e143 * _e133))) + ((_e274 * (1f - _e76)) * (_e148 * _e133))) + ((_e320 * (1f - _e127)) * (_e154 * _e133))) + ((_e321 * (1f - _e124)) * (_e159 * _e133)));
                        phi_165_ = ((((((_e92 + (_e225 * _e74)) + (_e226 * _e70)) + (_e273 * _e79)) + (_e274 * _e76)) + (_e320 * _e127)) + (_e321 * _e124));
                        phi_167_ = (_e94 + _e326);
                        phi_169_ = select(_e370, _e96, (_e370 < _e96));
                    } else {
                        phi_161_ = f32();
                        phi_163_ = f32();
                        phi_165_ = f32();
                        phi_167_ = f32();
                        phi_169_ = f32();
                    }
                    let _e374 = phi_161_;
                    let _e376 = phi_163_;
                    let _e378 = phi_165_;
                    let _e380 = phi_167_;
                    let _e382 = phi_169_;
                    continue;
                    continuing {
                        phi_157_ = _e109;
                        phi_160_ = _e374;
                        phi_162_ = _e376;
                        phi_164_ = _e378;
                        phi_166_ = _e380;
                        phi_168_ = _e382;
                        break if !(_e115);
                    }
                }
                let _e387 = local;
                out.member[_e45] = _e387;
                let _e392 = local_1;
                out.member[(_e41 + _e45)] = _e392;
                let _e398 = local_2;
                out.member[((2u * _e41) + _e45)] = _e398;
                let _e404 = local_3;
                out.member[((3u * _e41) + _e45)] = _e404;
                let _e410 = local_4;
                out.member[((4u * _e41) + _e45)] = _e410;
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
