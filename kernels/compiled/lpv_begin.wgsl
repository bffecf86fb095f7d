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
var<storage> source: type_5;
@group(0) @binding(2) 
var<storage> before: type_5;

fn function_() {
    var phi_115_: u32;
    var phi_198_: bool;
    var phi_200_: bool;
    var phi_201_: bool;
    var phi_715_: bool;
    var phi_655_: array<f32, 11>;

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
                phi_115_ = (3u * (_e63 / _e55));
            } else {
                phi_115_ = 0u;
            }
            let _e69 = phi_115_;
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
                if _e83 {
                    break;
                }
                let _e88 = (_e78 - ((_e78 / _e84) * _e84));
                let _e89 = (_e53.y + 2u);
                let _e92 = (select(_e89, _e88, (_e89 < _e88)) - _e89);
                if (_e57 == 0u) {
                    break;
                }
                let _e94 = (_e92 / _e57);
                if (_e88 >= _e89) {
                    let _e98 = ((_e92 - (_e94 * _e57)) < _e53.y);
                    if _e98 {
                        phi_198_ = (_e94 < _e53.z);
                    } else {
                        phi_198_ = bool();
                    }
                    let _e101 = phi_198_;
                    phi_200_ = _e101;
                    phi_201_ = select(true, false, _e98);
                } else {
                    phi_200_ = bool();
                    phi_201_ = true;
                }
                let _e104 = phi_200_;
                let _e106 = phi_201_;
                if select(_e104, false, _e106) {
                    let _e111 = source.member[(_e82 + _e70)];
                    let _e116 = source.member[(_e82 + (_e63 * 6u))];
                    let _e121 = source.member[(_e82 + (_e63 * 9u))];
                    let _e124 = source.member[_e82];
                    let _e127 = params.member.member_9;
                    let _e131 = params.member.member_4[3u];
                    let _e134 = params.member.member_6;
                    let _e135 = (0.000000000000000001f < _e124);
                    let _e136 = select(0f, _e124, _e135);
                    let _e140 = sqrt(fma(_e121, _e121, fma(_e116, _e116, (_e111 * _e111))));
                    let _e141 = select(1f, _e136, _e135);
                    let _e143 = select(_e140, _e141, (_e140 < _e141));
                    let _e145 = (_e140 * (1f / _e143));
                    if (_e134 != _e134) {
                        phi_715_ = true;
                    } else {
                        phi_715_ = (0.33333334f >= _e134);
                    }
                    let _e149 = phi_715_;
                    let _e150 = select(_e134, 0.33333334f, _e149);
                    let _e153 = fma(select(_e150, _e145, (_e145 < _e150)), -3f, 3f);
                    let _e156 = (0.31830987f / ((_e153 * _e153) * _e140));
                    let _e162 = (_e145 < select(2f, 0.33333334f, (_e134 > 0.33333334f)));
                    let _e163 = select(((_e153 - 1f) * (_e156 * _e140)), 0.07957747f, _e162);
                    let _e165 = select(_e156, (0.2387324f / _e143), _e162);
                    let _e166 = (_e111 * _e165);
                    let _e167 = (_e116 * _e165);
                    let _e168 = (_e121 * _e165);
                    let _e169 = fma(_e166, 0.8944272f, _e163);
                    let _e170 = fma(_e167, 0.4472136f, _e169);
                    let _e172 = select(0f, _e170, (0f < _e170));
                    let _e173 = fma(_e167, -0.4472136f, _e169);
                    let _e175 = select(0f, _e173, (0f < _e173));
                    let _e176 = fma(_e168, 0.4472136f, _e169);
                    let _e178 = select(0f, _e176, (0f < _e176));
                    let _e179 = fma(_e168, -0.4472136f, _e169);
                    let _e181 = select(0f, _e179, (0f < _e179));
                    let _e182 = (_e163 + _e166);
                    let _e184 = select(0f, _e182, (0f < _e182));
                    let _e187 = ((_e172 + _e175) + (_e178 + _e181));
                    let _e190 = -(_e166);
                    let _e191 = fma(_e190, 0.8944272f, _e163);
                    let _e192 = fma(_e167, 0.4472136f, _e191);
                    let _e194 = select(0f, _e192, (0f < _e192));
                    let _e195 = fma(_e167, -0.4472136f, _e191);
                    let _e197 = select(0f, _e195, (0f < _e195));
                    let _e198 = fma(_e168, 0.4472136f, _e191);
                    let _e200 = select(0f, _e198, (0f < _e198));
                    let _e201 = fma(_e168, -0.4472136f, _e191);
                    let _e203 = select(0f, _e201, (0f < _e201));
                    let _e204 = (_e163 + _e190);
                    let _e206 = select(0f, _e204, (0f < _e204));
                    let _e209 = ((_e194 + _e197) + (_e200 + _e203));
                    let _e213 = fma(_e184, 0.4006697f, (_e187 * 0.42343134f));
                    let _e215 = fma(_e206, 0.4006697f, (_e209 * 0.42343134f));
                    let _e222 = fma(_e167, 0.8944272f, _e163);
                    let _e223 = fma(_e168, 0.4472136f, _e222);
                    let _e225 = select(0f, _e223, (0f < _e223));
                    let _e226 = fma(_e168, -0.4472136f, _e222);
                    let _e228 = select(0f, _e226, (0f < _e226));
                    let _e229 = fma(_e166, 0.4472136f, _e222);
                    let _e231 = select(0f, _e229, (0f < _e229));
                    let _e232 = fma(_e166, -0.4472136f, _e222);
                    let _e234 = select(0f, _e232, (0f < _e232));
                    let _e235 = (_e163 + _e167);
                    let _e237 = select(0f, _e235, (0f < _e235));
                    let _e240 = ((_e225 + _e228) + (_e231 + _e234));
                    let _e243 = -(_e167);
                    let _e244 = fma(_e243, 0.8944272f, _e163);
                    let _e245 = fma(_e168, 0.4472136f, _e244);
                    let _e247 = select(0f, _e245, (0f < _e245));
                    let _e248 = fma(_e168, -0.4472136f, _e244);
                    let _e250 = select(0f, _e248, (0f < _e248));
                    let _e251 = fma(_e166, 0.4472136f, _e244);
                    let _e253 = select(0f, _e251, (0f < _e251));
                    let _e254 = fma(_e166, -0.4472136f, _e244);
                    let _e256 = select(0f, _e254, (0f < _e254));
                    let _e257 = (_e163 + _e243);
                    let _e259 = select(0f, _e257, (0f < _e257));
                    let _e262 = ((_e247 + _e250) + (_e253 + _e256));
                    let _e266 = fma(_e237, 0.4006697f, (_e240 * 0.42343134f));
                    let _e268 = fma(_e259, 0.4006697f, (_e262 * 0.42343134f));
                    let _e277 = fma(_e168, 0.8944272f, _e163);
                    let _e278 = fma(_e166, 0.4472136f, _e277);
                    let _e280 = select(0f, _e278, (0f < _e278));
                    let _e281 = fma(_e166, -0.4472136f, _e277);
                    let _e283 = select(0f, _e281, (0f < _e281));
                    let _e284 = fma(_e167, 0.4472136f, _e277);
                    let _e286 = select(0f, _e284, (0f < _e284));
                    let _e287 = fma(_e167, -0.4472136f, _e277);
                    let _e289 = select(0f, _e287, (0f < _e287));
                    let _e290 = (_e163 + _e168);
                    let _e292 = select(0f, _e290, (0f < _e290));
                    let _e295 = ((_e280 + _e283) + (_e286 + _e289));
                    let _e298 = -(_e168);
                    let _e299 = fma(_e298, 0.8944272f, _e163);
                    let _e300 = fma(_e166, 0.4472136f, _e299);
                    let _e302 = select(0f, _e300, (0f < _e300));
                    let _e303 = fma(_e166, -0.4472136f, _e299);
                    let _e305 = select(0f, _e303, (0f < _e303));
                    let _e306 = fma(_e167, 0.4472136f, _e299);
                    let _e308 = select(0f, _e306, (0f < _e306));
                    let _e309 = fma(_e167, -0.4472136f, _e299);
                    let _e311 = select(0f, _e309, (0f < _e309));
                    let _e312 = (_e163 + _e298);
                    let _e314 = select(0f, _e312, (0f < _e312));
                    let _e317 = ((_e302 + _e305) + (_e308 + _e311));
                    let _e321 = fma(_e292, 0.4006697f, (_e295 * 0.42343134f));
                    let _e323 = fma(_e314, 0.4006697f, (_e317 * 0.42343134f));
                    let _e332 = (_e213 + _e215);
                    let _e333 = (_e266 + _e268);
                    let _e335 = (_e321 + _e323);
                    let _e336 = ((_e332 + _e333) + _e335);
                    let _e337 = (((fma((_e184 - _e206), 2.1158676f, fma((_e187 - _e209), 2f, 0f)) + ((_e231 - _e234) + (_e253 - _e256))) + ((_e280 - _e283) + (_e302 - _e305))) * 0.18936425f);
                    let _e338 = ((fma((_e237 - _e259), 2.1158676f, fma((_e240 - _e262), 2f, ((_e172 - _e175) + (_e194 - _e197)))) + ((_e286 - _e289) + (_e308 - _e311))) * 0.18936425f);
                    let _e339 = (fma((_e292 - _e314), 2.1158676f, fma((_e295 - _e317), 2f, (((_e178 - _e181) + (_e200 - _e203)) + ((_e225 - _e228) + (_e247 - _e250))))) * 0.18936425f);
                    let _e340 = (_e136 / _e336);
                    let _e342 = fma(_e336, (1f - _e127), _e127);
                    let _e343 = (_e336 * _e336);
                    let _e356 = (_e340 * _e342);
                    let _e357 = (_e356 * _e165);
                    let _e363 = (_e145 < 0.33333334f);
                    let _e364 = (_e340 * 0.7329038f);
                    let _e382 = params.member.member_10;
                    let _e391 = params.member.member_11;
                    let _e396 = before.member[((_e63 * 15u) + _e82)];
                    let _e402 = before.member[((_e63 * 18u) + _e82)];
                    let _e408 = before.member[((_e63 * 21u) + _e82)];
                    let _e414 = before.member[((_e63 * 24u) + _e82)];
                    let _e420 = before.member[((_e63 * 27u) + _e82)];
                    let _e426 = before.member[((_e63 * 30u) + _e82)];
                    phi_655_ = array<f32, 11>((_e356 * _e163), (_e111 * _e357), (_e116 * _e357), (_e121 * _e357), select(1f, fma(sqrt(((fma(_e145, _e145, 0.0001f) * _e343) / fma((fma(_e339, _e339, fma(_e338, _e338, (_e337 * _e337))) * _e342), _e342, (0.0001f * _e343)))), _e131, (1f - _e131)), _e135), fma(_e396, _e391, ((_e136 * 0.2820948f) * _e382)), fma(_e402, _e391, (((_e266 - _e268) * _e364) * _e382)), fma(_e408, _e391, (((_e321 - _e323) * _e364) * _e382)), fma(_e414, _e391, (((_e213 - _e215) * _e364) * _e382)), fma(_e420, _e391, (select((fma(_e335, _e340, (_e136 * -0.33333334f)) * 1.5138805f), 0f, _e363) * _e382)), fma(_e426, _e391, (select(((_e332 - _e333) * (_e340 * 0.8740393f)), 0f, _e363) * _e382)));
                } else {
                    phi_655_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e430 = phi_655_;
                out.member[_e82] = _e430[0];
                out.member[(_e70 + _e82)] = _e430[1];
                out.member[((_e63 * 6u) + _e82)] = _e430[2];
                out.member[((_e63 * 9u) + _e82)] = _e430[3];
                out.member[((_e63 * 12u) + _e82)] = _e430[4];
                out.member[((_e63 * 15u) + _e82)] = _e430[5];
                out.member[((_e63 * 18u) + _e82)] = _e430[6];
                out.member[((_e63 * 21u) + _e82)] = _e430[7];
                out.member[((_e63 * 24u) + _e82)] = _e430[8];
                out.member[((_e63 * 27u) + _e82)] = _e430[9];
                out.member[((_e63 * 30u) + _e82)] = _e430[10];
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
