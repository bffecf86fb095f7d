struct type_5 {
    member: array<f32>,
}

struct type_9 {
    member: u32,
    member_1: u32,
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
@group(0) @binding(2) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_15;
@group(0) @binding(1) 
var<storage> state: type_5;

fn function_() {
    var phi_79_: u32;
    var phi_173_: bool;
    var phi_175_: bool;
    var phi_176_: bool;
    var phi_197_: type_9;
    var phi_200_: array<f32, 4>;
    var phi_198_: type_9;
    var phi_223_: type_9;
    var phi_201_: array<f32, 4>;
    var phi_548_: array<f32, 4>;
    var local: array<f32, 4>;

    switch bitcast<i32>(0u) {
        default: {
            let _e34 = gid_1;
            let _e37 = params.member.member_3;
            let _e39 = (_e37.x + 1u);
            let _e41 = (_e37.y + 1u);
            let _e42 = (_e41 * _e39);
            let _e47 = ((_e42 + _e39) + ((_e37.z + 1u) * _e42));
            if (_e37.x > 0u) {
                if (_e39 == 0u) {
                    break;
                }
                phi_79_ = (3u * (_e47 / _e39));
            } else {
                phi_79_ = 0u;
            }
            let _e53 = phi_79_;
            let _e58 = (_e34.x + (_e34.y * 2097152u));
            if (_e58 < (_e53 * _e37.x)) {
                if (_e37.x == 0u) {
                    break;
                }
                let _e62 = (_e58 / _e37.x);
                let _e64 = (_e58 - (_e62 * _e37.x));
                let _e66 = ((_e62 * _e39) + _e64);
                let _e69 = params.member.member_2;
                let _e71 = (_e69.x + 1u);
                let _e74 = ((_e69.y + 1u) * _e71);
                let _e75 = (_e74 + _e71);
                let _e79 = (_e75 + ((_e69.z + 1u) * _e74));
                let _e81 = (_e39 == 0u);
                if _e81 {
                    break;
                }
                let _e82 = (_e47 / _e39);
                if (_e82 == 0u) {
                    break;
                }
                let _e84 = (_e62 / _e82);
                if _e81 {
                    break;
                }
                let _e86 = (_e62 - (_e84 * _e82));
                let _e87 = (_e37.y + 2u);
                let _e90 = (select(_e87, _e86, (_e87 < _e86)) - _e87);
                if (_e41 == 0u) {
                    break;
                }
                let _e92 = (_e90 / _e41);
                let _e94 = (_e90 - (_e92 * _e41));
                if (_e86 >= _e87) {
                    let _e96 = (_e94 < _e37.y);
                    if _e96 {
                        phi_173_ = (_e92 < _e37.z);
                    } else {
                        phi_173_ = bool();
                    }
                    let _e99 = phi_173_;
                    phi_175_ = _e99;
                    phi_176_ = select(true, false, _e96);
                } else {
                    phi_175_ = bool();
                    phi_176_ = true;
                }
                let _e102 = phi_175_;
                let _e104 = phi_176_;
                if select(_e102, false, _e104) {
                    phi_197_ = type_9(0u, 8u);
                    phi_200_ = array<f32, 4>(0f, 0f, 0f, 0f);
                    loop {
                        let _e117 = phi_197_;
                        let _e119 = phi_200_;
                        local = _e119;
                        if (_e117.member < _e117.member_1) {
                            phi_198_ = type_9((_e117.member + 1u), _e117.member_1);
                            phi_223_ = type_9(1u, _e117.member);
                        } else {
                            phi_198_ = _e117;
                            phi_223_ = type_9(0u, type_9().member_1);
                        }
                        let _e132 = phi_198_;
                        let _e134 = phi_223_;
                        let _e138 = (bitcast<i32>(_e134.member) != 0i);
                        if _e138 {
                            let _e149 = (((((_e84 * _e79) + (((_e75 + (2u * _e64)) + ((2u * _e94) * _e71)) + ((2u * _e92) * _e74))) + (_e134.member_1 & 1u)) + (((_e134.member_1 >> bitcast<u32>(1i)) & 1u) * _e71)) + ((_e134.member_1 >> bitcast<u32>(2i)) * _e74));
                            let _e152 = state.member[_e149];
                            let _e156 = state.member[((3u * _e79) + _e149)];
                            let _e161 = state.member[((_e79 * 6u) + _e149)];
                            let _e166 = state.member[((_e79 * 9u) + _e149)];
                            let _e167 = fma(_e156, 0.8944272f, _e152);
                            let _e168 = fma(_e161, 0.4472136f, _e167);
                            let _e170 = select(0f, _e168, (0f < _e168));
                            let _e171 = fma(_e161, -0.4472136f, _e167);
                            let _e173 = select(0f, _e171, (0f < _e171));
                            let _e174 = fma(_e166, 0.4472136f, _e167);
                            let _e176 = select(0f, _e174, (0f < _e174));
                            let _e177 = fma(_e166, -0.4472136f, _e167);
                            let _e179 = select(0f, _e177, (0f < _e177));
                            let _e180 = (_e152 + _e156);
                            let _e182 = select(0f, _e180, (0f < _e180));
                            let _e185 = ((_e170 + _e173) + (_e176 + _e179));
                            let _e188 = -(_e156);
                            let _e189 = fma(_e188, 0.8944272f, _e152);
                            let _e190 = fma(_e161, 0.4472136f, _e189);
                            let _e192 = select(0f, _e190, (0f < _e190));
                            let _e193 = fma(_e161, -0.4472136f, _e189);
                            let _e195 = select(0f, _e193, (0f < _e193));
                            let _e196 = fma(_e166, 0.4472136f, _e189);
                            let _e198 = select(0f, _e196, (0f < _e196));
                            let _e199 = fma(_e166, -0.4472136f, _e189);
                            let _e201 = select(0f, _e199, (0f < _e199));
                            let _e202 = (_e152 + _e188);
                            let _e204 = select(0f, _e202, (0f < _e202));
                            let _e207 = ((_e192 + _e195) + (_e198 + _e201));
                            let _e220 = fma(_e161, 0.8944272f, _e152);
                            let _e221 = fma(_e166, 0.4472136f, _e220);
                            let _e223 = select(0f, _e221, (0f < _e221));
                            let _e224 = fma(_e166, -0.4472136f, _e220);
                            let _e226 = select(0f, _e224, (0f < _e224));
                            let _e227 = fma(_e156, 0.4472136f, _e220);
                            let _e229 = select(0f, _e227, (0f < _e227));
                            let _e230 = fma(_e156, -0.4472136f, _e220);
                            let _e232 = select(0f, _e230, (0f < _e230));
                            let _e233 = (_e152 + _e161);
                            let _e235 = select(0f, _e233, (0f < _e233));
                            let _e238 = ((_e223 + _e226) + (_e229 + _e232));
                            let _e241 = -(_e161);
                            let _e242 = fma(_e241, 0.8944272f, _e152);
                            let _e243 = fma(_e166, 0.4472136f, _e242);
                            let _e245 = select(0f, _e243, (0f < _e243));
                            let _e246 = fma(_e166, -0.4472136f, _e242);
                            let _e248 = select(0f, _e246, (0f < _e246));
                            let _e249 = fma(_e156, 0.4472136f, _e242);
                            let _e251 = select(0f, _e249, (0f < _e249));
                            let _e252 = fma(_e156, -0.4472136f, _e242);
                            let _e254 = select(0f, _e252, (0f < _e252));
                            let _e255 = (_e152 + _e241);
                            let _e257 = select(0f, _e255, (0f < _e255));
                            let _e260 = ((_e245 + _e248) + (_e251 + _e254));
                            let _e275 = fma(_e166, 0.8944272f, _e152);
                            let _e276 = fma(_e156, 0.4472136f, _e275);
                            let _e278 = select(0f, _e276, (0f < _e276));
                            let _e279 = fma(_e156, -0.4472136f, _e275);
                            let _e281 = select(0f, _e279, (0f < _e279));
                            let _e282 = fma(_e161, 0.4472136f, _e275);
                            let _e284 = select(0f, _e282, (0f < _e282));
                            let _e285 = fma(_e161, -0.4472136f, _e275);
                            let _e287 = select(0f, _e285, (0f < _e285));
                            let _e288 = (_e152 + _e166);
                            let _e290 = select(0f, _e288, (0f < _e288));
                            let _e293 = ((_e278 + _e281) + (_e284 + _e287));
                            let _e296 = -(_e166);
                            let _e297 = fma(_e296, 0.8944272f, _e152);
                            let _e298 = fma(_e156, 0.4472136f, _e297);
                            let _e300 = select(0f, _e298, (0f < _e298));
                            let _e301 = fma(_e156, -0.4472136f, _e297);
                            let _e303 = select(0f, _e301, (0f < _e301));
                            let _e304 = fma(_e161, 0.4472136f, _e297);
                            let _e306 = select(0f, _e304, (0f < _e304));
                            let _e307 = fma(_e161, -0.4472136f, _e297);
                            let _e309 = select(0f, _e307, (0f < _e307));
                            let _e310 = (_e152 + _e296);
                            let _e312 = select(0f, _e310, (0f < _e310));
                            let _e315 = ((_e300 + _e303) + (_e306 + _e309));
                            let _e342 = state.member[((_e79 * 12u) + _e149)];
                            phi_201_ = array<f32, 4>((_e119[0] + (((fma(_e182, 0.4006697f, (_e185 * 0.42343134f)) + fma(_e204, 0.4006697f, (_e207 * 0.42343134f))) + (fma(_e235, 0.4006697f, (_e238 * 0.42343134f)) + fma(_e257, 0.4006697f, (_e260 * 0.42343134f)))) + (fma(_e290, 0.4006697f, (_e293 * 0.42343134f)) + fma(_e312, 0.4006697f, (_e315 * 0.42343134f))))), fma((((fma((_e182 - _e204), 2.1158676f, fma((_e185 - _e207), 2f, 0f)) + ((_e229 - _e232) + (_e251 - _e254))) + ((_e278 - _e281) + (_e300 - _e303))) * 0.18936425f), _e342, _e119[1]), fma(((fma((_e235 - _e257), 2.1158676f, fma((_e238 - _e260), 2f, ((_e170 - _e173) + (_e192 - _e195)))) + ((_e284 - _e287) + (_e306 - _e309))) * 0.18936425f), _e342, _e119[2]), fma((fma((_e290 - _e312), 2.1158676f, fma((_e293 - _e315), 2f, (((_e176 - _e179) + (_e198 - _e201)) + ((_e223 - _e226) + (_e245 - _e248))))) * 0.18936425f), _e342, _e119[3]));
                        } else {
                            phi_201_ = array<f32, 4>();
                        }
                        let _e353 = phi_201_;
                        continue;
                        continuing {
                            phi_197_ = _e132;
                            phi_200_ = _e353;
                            break if !(_e138);
                        }
                    }
                    let _e385 = local;
                    phi_548_ = _e385;
                } else {
                    phi_548_ = array<f32, 4>(0f, 0f, 0f, 0f);
                }
                let _e356 = phi_548_;
                out.member[_e66] = _e356[0];
                out.member[((3u * _e47) + _e66)] = _e356[1];
                out.member[((_e47 * 6u) + _e66)] = _e356[2];
                out.member[((_e47 * 9u) + _e66)] = _e356[3];
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_restrict(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
