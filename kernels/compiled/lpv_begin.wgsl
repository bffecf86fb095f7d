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
    var phi_112_: u32;
    var phi_195_: bool;
    var phi_197_: bool;
    var phi_198_: bool;
    var phi_761_: bool;
    var phi_701_: array<f32, 11>;

    switch bitcast<i32>(0u) {
        default: {
            let _e47 = gid_1;
            let _e50 = params.member.member_2;
            let _e52 = (_e50.x + 1u);
            let _e54 = (_e50.y + 1u);
            let _e55 = (_e54 * _e52);
            let _e60 = ((_e55 + _e52) + ((_e50.z + 1u) * _e55));
            if (_e50.x > 0u) {
                if (_e52 == 0u) {
                    break;
                }
                phi_112_ = (3u * (_e60 / _e52));
            } else {
                phi_112_ = 0u;
            }
            let _e66 = phi_112_;
            let _e67 = (3u * _e60);
            let _e71 = (_e47.x + (_e47.y * 2097152u));
            if (_e71 < (_e66 * _e50.x)) {
                if (_e50.x == 0u) {
                    break;
                }
                let _e75 = (_e71 / _e50.x);
                let _e79 = ((_e75 * _e52) + (_e71 - (_e75 * _e50.x)));
                let _e80 = (_e52 == 0u);
                if _e80 {
                    break;
                }
                let _e81 = (_e60 / _e52);
                if (_e81 == 0u) {
                    break;
                }
                if _e80 {
                    break;
                }
                let _e85 = (_e75 - ((_e75 / _e81) * _e81));
                let _e86 = (_e50.y + 2u);
                let _e89 = (select(_e86, _e85, (_e86 < _e85)) - _e86);
                if (_e54 == 0u) {
                    break;
                }
                let _e91 = (_e89 / _e54);
                if (_e85 >= _e86) {
                    let _e95 = ((_e89 - (_e91 * _e54)) < _e50.y);
                    if _e95 {
                        phi_195_ = (_e91 < _e50.z);
                    } else {
                        phi_195_ = bool();
                    }
                    let _e98 = phi_195_;
                    phi_197_ = _e98;
                    phi_198_ = select(true, false, _e95);
                } else {
                    phi_197_ = bool();
                    phi_198_ = true;
                }
                let _e101 = phi_197_;
                let _e103 = phi_198_;
                if select(_e101, false, _e103) {
                    let _e108 = source.member[(_e79 + _e67)];
                    let _e113 = source.member[(_e79 + (_e60 * 6u))];
                    let _e118 = source.member[(_e79 + (_e60 * 9u))];
                    let _e121 = source.member[_e79];
                    let _e124 = params.member.member_9;
                    let _e128 = params.member.member_4[3u];
                    let _e131 = params.member.member_6;
                    let _e132 = (0.000000000000000001f < _e121);
                    let _e133 = select(0f, _e121, _e132);
                    let _e135 = (1f / select(1f, _e133, _e132));
                    let _e136 = (_e108 * _e135);
                    let _e137 = (_e113 * _e135);
                    let _e138 = (_e118 * _e135);
                    let _e143 = (((_e136 * _e136) + (_e137 * _e137)) + (_e138 * _e138));
                    let _e147 = (1f / sqrt(select(1f, _e143, (1f < _e143))));
                    let _e148 = (_e136 * _e147);
                    let _e149 = (_e137 * _e147);
                    let _e150 = (_e138 * _e147);
                    let _e152 = ((_e143 * _e147) * _e147);
                    let _e153 = sqrt(_e152);
                    if (_e131 != _e131) {
                        phi_761_ = true;
                    } else {
                        phi_761_ = (0.33333334f >= _e131);
                    }
                    let _e157 = phi_761_;
                    let _e158 = select(_e131, 0.33333334f, _e157);
                    let _e161 = (3f * select(_e158, _e153, (_e153 < _e158)));
                    let _e163 = (3f - _e161);
                    let _e165 = (0.31830987f / (_e163 * _e163));
                    let _e168 = (_e153 < select(2f, 0.33333334f, (_e131 > 0.33333334f)));
                    let _e173 = select(((2f - _e161) * _e165), 0.07957747f, _e168);
                    let _e174 = select((_e165 / select(0.33333334f, _e153, (0.33333334f < _e153))), 0.2387324f, _e168);
                    let _e175 = (_e148 * _e174);
                    let _e176 = (_e149 * _e174);
                    let _e177 = (_e150 * _e174);
                    let _e179 = (_e173 + (_e175 * 0.8944272f));
                    let _e180 = (_e176 * 0.4472136f);
                    let _e181 = (_e177 * 0.4472136f);
                    let _e182 = (_e179 + _e180);
                    let _e184 = select(0f, _e182, (0f < _e182));
                    let _e185 = (_e179 - _e180);
                    let _e187 = select(0f, _e185, (0f < _e185));
                    let _e188 = (_e179 + _e181);
                    let _e190 = select(0f, _e188, (0f < _e188));
                    let _e191 = (_e179 - _e181);
                    let _e193 = select(0f, _e191, (0f < _e191));
                    let _e194 = (_e173 + _e175);
                    let _e197 = (select(0f, _e194, (0f < _e194)) * 0.4006697f);
                    let _e201 = (((_e184 + _e187) + (_e190 + _e193)) * 0.42343134f);
                    let _e206 = (_e173 + (_e175 * -0.8944272f));
                    let _e207 = (_e206 + _e180);
                    let _e209 = select(0f, _e207, (0f < _e207));
                    let _e210 = (_e206 - _e180);
                    let _e212 = select(0f, _e210, (0f < _e210));
                    let _e213 = (_e206 + _e181);
                    let _e215 = select(0f, _e213, (0f < _e213));
                    let _e216 = (_e206 - _e181);
                    let _e218 = select(0f, _e216, (0f < _e216));
                    let _e219 = (_e173 + -(_e175));
                    let _e222 = (select(0f, _e219, (0f < _e219)) * 0.4006697f);
                    let _e226 = (((_e209 + _e212) + (_e215 + _e218)) * 0.42343134f);
                    let _e229 = (_e197 + _e201);
                    let _e230 = (_e222 + _e226);
                    let _e239 = (_e173 + (_e176 * 0.8944272f));
                    let _e240 = (_e175 * 0.4472136f);
                    let _e241 = (_e239 + _e181);
                    let _e243 = select(0f, _e241, (0f < _e241));
                    let _e244 = (_e239 - _e181);
                    let _e246 = select(0f, _e244, (0f < _e244));
                    let _e247 = (_e239 + _e240);
                    let _e249 = select(0f, _e247, (0f < _e247));
                    let _e250 = (_e239 - _e240);
                    let _e252 = select(0f, _e250, (0f < _e250));
                    let _e253 = (_e173 + _e176);
                    let _e256 = (select(0f, _e253, (0f < _e253)) * 0.4006697f);
                    let _e260 = (((_e243 + _e246) + (_e249 + _e252)) * 0.42343134f);
                    let _e265 = (_e173 + (_e176 * -0.8944272f));
                    let _e266 = (_e265 + _e181);
                    let _e268 = select(0f, _e266, (0f < _e266));
                    let _e269 = (_e265 - _e181);
                    let _e271 = select(0f, _e269, (0f < _e269));
                    let _e272 = (_e265 + _e240);
                    let _e274 = select(0f, _e272, (0f < _e272));
                    let _e275 = (_e265 - _e240);
                    let _e277 = select(0f, _e275, (0f < _e275));
                    let _e278 = (_e173 + -(_e176));
                    let _e281 = (select(0f, _e278, (0f < _e278)) * 0.4006697f);
                    let _e285 = (((_e268 + _e271) + (_e274 + _e277)) * 0.42343134f);
                    let _e288 = (_e256 + _e260);
                    let _e289 = (_e281 + _e285);
                    let _e302 = (_e173 + (_e177 * 0.8944272f));
                    let _e303 = (_e302 + _e240);
                    let _e305 = select(0f, _e303, (0f < _e303));
                    let _e306 = (_e302 - _e240);
                    let _e308 = select(0f, _e306, (0f < _e306));
                    let _e309 = (_e302 + _e180);
                    let _e311 = select(0f, _e309, (0f < _e309));
                    let _e312 = (_e302 - _e180);
                    let _e314 = select(0f, _e312, (0f < _e312));
                    let _e315 = (_e173 + _e177);
                    let _e318 = (select(0f, _e315, (0f < _e315)) * 0.4006697f);
                    let _e322 = (((_e305 + _e308) + (_e311 + _e314)) * 0.42343134f);
                    let _e327 = (_e173 + (_e177 * -0.8944272f));
                    let _e328 = (_e327 + _e240);
                    let _e330 = select(0f, _e328, (0f < _e328));
                    let _e331 = (_e327 - _e240);
                    let _e333 = select(0f, _e331, (0f < _e331));
                    let _e334 = (_e327 + _e180);
                    let _e336 = select(0f, _e334, (0f < _e334));
                    let _e337 = (_e327 - _e180);
                    let _e339 = select(0f, _e337, (0f < _e337));
                    let _e340 = (_e173 + -(_e177));
                    let _e343 = (select(0f, _e340, (0f < _e340)) * 0.4006697f);
                    let _e347 = (((_e330 + _e333) + (_e336 + _e339)) * 0.42343134f);
                    let _e350 = (_e318 + _e322);
                    let _e351 = (_e343 + _e347);
                    let _e356 = (((0.18936425f * (((_e190 - _e193) + (_e215 - _e218)) + ((_e243 - _e246) + (_e268 - _e271)))) + (_e318 - _e343)) + ((_e322 - _e347) * 0.8944272f));
                    let _e359 = ((((_e197 - _e222) + ((_e201 - _e226) * 0.8944272f)) + (((_e249 - _e252) + (_e274 - _e277)) * 0.18936425f)) + (((_e305 - _e308) + (_e330 - _e333)) * 0.18936425f));
                    let _e362 = ((((((_e184 - _e187) + (_e209 - _e212)) * 0.18936425f) + (_e256 - _e281)) + ((_e260 - _e285) * 0.8944272f)) + (((_e311 - _e314) + (_e336 - _e339)) * 0.18936425f));
                    let _e363 = (_e229 + _e230);
                    let _e364 = (_e288 + _e289);
                    let _e366 = (_e350 + _e351);
                    let _e368 = (1f / ((_e363 + _e364) + _e366));
                    let _e371 = ((_e368 * _e124) + (1f - _e124));
                    let _e383 = (_e133 * _e371);
                    let _e385 = (_e383 * _e174);
                    let _e387 = ((_e133 * _e368) * 0.7329038f);
                    let _e412 = params.member.member_10;
                    let _e421 = params.member.member_11;
                    let _e426 = before.member[((_e60 * 15u) + _e79)];
                    let _e433 = before.member[((_e60 * 18u) + _e79)];
                    let _e440 = before.member[((_e60 * 21u) + _e79)];
                    let _e447 = before.member[((_e60 * 24u) + _e79)];
                    let _e454 = before.member[((_e60 * 27u) + _e79)];
                    let _e461 = before.member[((_e60 * 30u) + _e79)];
                    phi_701_ = array<f32, 11>((_e383 * _e173), (_e148 * _e385), (_e149 * _e385), (_e150 * _e385), select(1f, ((sqrt(((_e152 + 0.0001f) / ((((((_e359 * _e359) + (_e362 * _e362)) + (_e356 * _e356)) * _e371) * _e371) + 0.0001f))) * _e128) + (1f - _e128)), _e132), (((_e133 * 0.2820948f) * _e412) + (_e421 * _e426)), ((((_e288 - _e289) * _e387) * _e412) + (_e421 * _e433)), ((((_e350 - _e351) * _e387) * _e412) + (_e421 * _e440)), ((((_e229 - _e230) * _e387) * _e412) + (_e421 * _e447)), ((((((_e366 * _e368) - 0.33333334f) * _e133) * 1.5138805f) * _e412) + (_e421 * _e454)), ((((((_e363 - _e364) * _e368) * _e133) * 0.8740393f) * _e412) + (_e421 * _e461)));
                } else {
                    phi_701_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e466 = phi_701_;
                out.member[_e79] = _e466[0];
                out.member[(_e67 + _e79)] = _e466[1];
                out.member[((_e60 * 6u) + _e79)] = _e466[2];
                out.member[((_e60 * 9u) + _e79)] = _e466[3];
                out.member[((_e60 * 12u) + _e79)] = _e466[4];
                out.member[((_e60 * 15u) + _e79)] = _e466[5];
                out.member[((_e60 * 18u) + _e79)] = _e466[6];
                out.member[((_e60 * 21u) + _e79)] = _e466[7];
                out.member[((_e60 * 24u) + _e79)] = _e466[8];
                out.member[((_e60 * 27u) + _e79)] = _e466[9];
                out.member[((_e60 * 30u) + _e79)] = _e466[10];
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
