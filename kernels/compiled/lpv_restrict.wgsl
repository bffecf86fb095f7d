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
    var phi_78_: u32;
    var phi_172_: bool;
    var phi_174_: bool;
    var phi_175_: bool;
    var phi_196_: type_9;
    var phi_199_: array<f32, 4>;
    var phi_197_: type_9;
    var phi_222_: type_9;
    var phi_200_: array<f32, 4>;
    var phi_576_: array<f32, 4>;
    var local: array<f32, 4>;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = gid_1;
            let _e35 = params.member.member_3;
            let _e37 = (_e35.x + 1u);
            let _e39 = (_e35.y + 1u);
            let _e40 = (_e39 * _e37);
            let _e45 = ((_e40 + _e37) + ((_e35.z + 1u) * _e40));
            if (_e35.x > 0u) {
                if (_e37 == 0u) {
                    break;
                }
                phi_78_ = (3u * (_e45 / _e37));
            } else {
                phi_78_ = 0u;
            }
            let _e51 = phi_78_;
            let _e56 = (_e32.x + (_e32.y * 2097152u));
            if (_e56 < (_e51 * _e35.x)) {
                if (_e35.x == 0u) {
                    break;
                }
                let _e60 = (_e56 / _e35.x);
                let _e62 = (_e56 - (_e60 * _e35.x));
                let _e64 = ((_e60 * _e37) + _e62);
                let _e67 = params.member.member_2;
                let _e69 = (_e67.x + 1u);
                let _e72 = ((_e67.y + 1u) * _e69);
                let _e73 = (_e72 + _e69);
                let _e77 = (_e73 + ((_e67.z + 1u) * _e72));
                let _e79 = (_e37 == 0u);
                if _e79 {
                    break;
                }
                let _e80 = (_e45 / _e37);
                if (_e80 == 0u) {
                    break;
                }
                let _e82 = (_e60 / _e80);
                if _e79 {
                    break;
                }
                let _e84 = (_e60 - (_e82 * _e80));
                let _e85 = (_e35.y + 2u);
                let _e88 = (select(_e85, _e84, (_e85 < _e84)) - _e85);
                if (_e39 == 0u) {
                    break;
                }
                let _e90 = (_e88 / _e39);
                let _e92 = (_e88 - (_e90 * _e39));
                if (_e84 >= _e85) {
                    let _e94 = (_e92 < _e35.y);
                    if _e94 {
                        phi_172_ = (_e90 < _e35.z);
                    } else {
                        phi_172_ = bool();
                    }
                    let _e97 = phi_172_;
                    phi_174_ = _e97;
                    phi_175_ = select(true, false, _e94);
                } else {
                    phi_174_ = bool();
                    phi_175_ = true;
                }
                let _e100 = phi_174_;
                let _e102 = phi_175_;
                if select(_e100, false, _e102) {
                    phi_196_ = type_9(0u, 8u);
                    phi_199_ = array<f32, 4>(0f, 0f, 0f, 0f);
                    loop {
                        let _e115 = phi_196_;
                        let _e117 = phi_199_;
                        local = _e117;
                        if (_e115.member < _e115.member_1) {
                            phi_197_ = type_9((_e115.member + 1u), _e115.member_1);
                            phi_222_ = type_9(1u, _e115.member);
                        } else {
                            phi_197_ = _e115;
                            phi_222_ = type_9(0u, type_9().member_1);
                        }
                        let _e130 = phi_197_;
                        let _e132 = phi_222_;
                        let _e136 = (bitcast<i32>(_e132.member) != 0i);
                        if _e136 {
                            let _e147 = (((((_e82 * _e77) + (((_e73 + (2u * _e62)) + ((2u * _e92) * _e69)) + ((2u * _e90) * _e72))) + (_e132.member_1 & 1u)) + (((_e132.member_1 >> bitcast<u32>(1i)) & 1u) * _e69)) + ((_e132.member_1 >> bitcast<u32>(2i)) * _e72));
                            let _e150 = state.member[_e147];
                            let _e154 = state.member[((3u * _e77) + _e147)];
                            let _e159 = state.member[((_e77 * 6u) + _e147)];
                            let _e164 = state.member[((_e77 * 9u) + _e147)];
                            let _e166 = (_e150 + (_e154 * 0.8944272f));
                            let _e167 = (_e159 * 0.4472136f);
                            let _e168 = (_e164 * 0.4472136f);
                            let _e169 = (_e166 + _e167);
                            let _e171 = select(0f, _e169, (0f < _e169));
                            let _e172 = (_e166 - _e167);
                            let _e174 = select(0f, _e172, (0f < _e172));
                            let _e175 = (_e166 + _e168);
                            let _e177 = select(0f, _e175, (0f < _e175));
                            let _e178 = (_e166 - _e168);
                            let _e180 = select(0f, _e178, (0f < _e178));
                            let _e181 = (_e150 + _e154);
                            let _e184 = (select(0f, _e181, (0f < _e181)) * 0.4006697f);
                            let _e188 = (((_e171 + _e174) + (_e177 + _e180)) * 0.42343134f);
                            let _e193 = (_e150 + (_e154 * -0.8944272f));
                            let _e194 = (_e193 + _e167);
                            let _e196 = select(0f, _e194, (0f < _e194));
                            let _e197 = (_e193 - _e167);
                            let _e199 = select(0f, _e197, (0f < _e197));
                            let _e200 = (_e193 + _e168);
                            let _e202 = select(0f, _e200, (0f < _e200));
                            let _e203 = (_e193 - _e168);
                            let _e205 = select(0f, _e203, (0f < _e203));
                            let _e206 = (_e150 + -(_e154));
                            let _e209 = (select(0f, _e206, (0f < _e206)) * 0.4006697f);
                            let _e213 = (((_e196 + _e199) + (_e202 + _e205)) * 0.42343134f);
                            let _e226 = (_e150 + (_e159 * 0.8944272f));
                            let _e227 = (_e154 * 0.4472136f);
                            let _e228 = (_e226 + _e168);
                            let _e230 = select(0f, _e228, (0f < _e228));
                            let _e231 = (_e226 - _e168);
                            let _e233 = select(0f, _e231, (0f < _e231));
                            let _e234 = (_e226 + _e227);
                            let _e236 = select(0f, _e234, (0f < _e234));
                            let _e237 = (_e226 - _e227);
                            let _e239 = select(0f, _e237, (0f < _e237));
                            let _e240 = (_e150 + _e159);
                            let _e243 = (select(0f, _e240, (0f < _e240)) * 0.4006697f);
                            let _e247 = (((_e230 + _e233) + (_e236 + _e239)) * 0.42343134f);
                            let _e252 = (_e150 + (_e159 * -0.8944272f));
                            let _e253 = (_e252 + _e168);
                            let _e255 = select(0f, _e253, (0f < _e253));
                            let _e256 = (_e252 - _e168);
                            let _e258 = select(0f, _e256, (0f < _e256));
                            let _e259 = (_e252 + _e227);
                            let _e261 = select(0f, _e259, (0f < _e259));
                            let _e262 = (_e252 - _e227);
                            let _e264 = select(0f, _e262, (0f < _e262));
                            let _e265 = (_e150 + -(_e159));
                            let _e268 = (select(0f, _e265, (0f < _e265)) * 0.4006697f);
                            let _e272 = (((_e255 + _e258) + (_e261 + _e264)) * 0.42343134f);
                            let _e289 = (_e150 + (_e164 * 0.8944272f));
                            let _e290 = (_e289 + _e227);
                            let _e292 = select(0f, _e290, (0f < _e290));
                            let _e293 = (_e289 - _e227);
                            let _e295 = select(0f, _e293, (0f < _e293));
                            let _e296 = (_e289 + _e167);
                            let _e298 = select(0f, _e296, (0f < _e296));
                            let _e299 = (_e289 - _e167);
                            let _e301 = select(0f, _e299, (0f < _e299));
                            let _e302 = (_e150 + _e164);
                            let _e305 = (select(0f, _e302, (0f < _e302)) * 0.4006697f);
                            let _e309 = (((_e292 + _e295) + (_e298 + _e301)) * 0.42343134f);
                            let _e314 = (_e150 + (_e164 * -0.8944272f));
                            let _e315 = (_e314 + _e227);
                            let _e317 = select(0f, _e315, (0f < _e315));
                            let _e318 = (_e314 - _e227);
                            let _e320 = select(0f, _e318, (0f < _e318));
                            let _e321 = (_e314 + _e167);
                            let _e323 = select(0f, _e321, (0f < _e321));
                            let _e324 = (_e314 - _e167);
                            let _e326 = select(0f, _e324, (0f < _e324));
                            let _e327 = (_e150 + -(_e164));
                            let _e330 = (select(0f, _e327, (0f < _e327)) * 0.4006697f);
                            let _e334 = (((_e317 + _e320) + (_e323 + _e326)) * 0.42343134f);
                            let _e359 = state.member[((_e77 * 12u) + _e147)];
                            phi_200_ = array<f32, 4>((_e117[0] + ((((_e184 + _e188) + (_e209 + _e213)) + ((_e243 + _e247) + (_e268 + _e272))) + ((_e305 + _e309) + (_e330 + _e334)))), (_e117[1] + (((((_e184 - _e209) + ((_e188 - _e213) * 0.8944272f)) + (((_e236 - _e239) + (_e261 - _e264)) * 0.18936425f)) + (((_e292 - _e295) + (_e317 - _e320)) * 0.18936425f)) * _e359)), (_e117[2] + (((((((_e171 - _e174) + (_e196 - _e199)) * 0.18936425f) + (_e243 - _e268)) + ((_e247 - _e272) * 0.8944272f)) + (((_e298 - _e301) + (_e323 - _e326)) * 0.18936425f)) * _e359)), (_e117[3] + ((((0.18936425f * (((_e177 - _e180) + (_e202 - _e205)) + ((_e230 - _e233) + (_e255 - _e258)))) + (_e305 - _e330)) + ((_e309 - _e334) * 0.8944272f)) * _e359)));
                        } else {
                            phi_200_ = array<f32, 4>();
                        }
                        let _e373 = phi_200_;
                        continue;
                        continuing {
                            phi_196_ = _e130;
                            phi_199_ = _e373;
                            break if !(_e136);
                        }
                    }
                    let _e405 = local;
                    phi_576_ = _e405;
                } else {
                    phi_576_ = array<f32, 4>(0f, 0f, 0f, 0f);
                }
                let _e376 = phi_576_;
                out.member[_e64] = _e376[0];
                out.member[((3u * _e45) + _e64)] = _e376[1];
                out.member[((_e45 * 6u) + _e64)] = _e376[2];
                out.member[((_e45 * 9u) + _e64)] = _e376[3];
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
