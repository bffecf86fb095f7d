struct type_5 {
    member: array<f32>,
}

struct type_10 {
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
@group(0) @binding(2) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_18;
@group(0) @binding(1) 
var<storage> state: type_5;

fn function_() {
    var local: array<f32, 4>;
    var phi_83_: u32;
    var phi_177_: bool;
    var phi_179_: bool;
    var phi_180_: bool;
    var phi_201_: type_10;
    var phi_204_: array<f32, 4>;
    var phi_202_: type_10;
    var phi_227_: type_10;
    var phi_205_: array<f32, 4>;
    var phi_581_: array<f32, 4>;
    var phi_589_: type_10;
    var phi_590_: type_10;
    var phi_613_: type_10;
    var phi_642_: bool;
    var local_1: array<f32, 4>;

    switch bitcast<i32>(0u) {
        default: {
            let _e34 = gid_1;
            let _e39 = params.member.member_3;
            let _e41 = (_e39.x + 1u);
            let _e43 = (_e39.y + 1u);
            let _e44 = (_e43 * _e41);
            let _e49 = ((_e44 + _e41) + ((_e39.z + 1u) * _e44));
            if (_e39.x > 0u) {
                if (_e41 == 0u) {
                    break;
                }
                phi_83_ = (3u * (_e49 / _e41));
            } else {
                phi_83_ = 0u;
            }
            let _e55 = phi_83_;
            let _e60 = (_e34.x + (_e34.y * 2097152u));
            if (_e60 < (_e55 * _e39.x)) {
                if (_e39.x == 0u) {
                    break;
                }
                let _e64 = (_e60 / _e39.x);
                let _e66 = (_e60 - (_e64 * _e39.x));
                let _e71 = params.member.member_2;
                let _e73 = (_e71.x + 1u);
                let _e76 = ((_e71.y + 1u) * _e73);
                let _e77 = (_e76 + _e73);
                let _e81 = (_e77 + ((_e71.z + 1u) * _e76));
                let _e83 = (_e41 == 0u);
                if _e83 {
                    break;
                }
                let _e84 = (_e49 / _e41);
                if (_e84 == 0u) {
                    break;
                }
                let _e86 = (_e64 / _e84);
                if _e83 {
                    break;
                }
                let _e88 = (_e64 - (_e86 * _e84));
                let _e89 = (_e39.y + 2u);
                let _e92 = (select(_e89, _e88, (_e89 < _e88)) - _e89);
                if (_e43 == 0u) {
                    break;
                }
                let _e94 = (_e92 / _e43);
                let _e96 = (_e92 - (_e94 * _e43));
                if (_e88 >= _e89) {
                    let _e98 = (_e96 < _e39.y);
                    if _e98 {
                        phi_177_ = (_e94 < _e39.z);
                    } else {
                        phi_177_ = bool();
                    }
                    let _e101 = phi_177_;
                    phi_179_ = _e101;
                    phi_180_ = select(true, false, _e98);
                } else {
                    phi_179_ = bool();
                    phi_180_ = true;
                }
                let _e104 = phi_179_;
                let _e106 = phi_180_;
                if select(_e104, false, _e106) {
                    phi_201_ = type_10(0u, 8u);
                    phi_204_ = array<f32, 4>(0f, 0f, 0f, 0f);
                    loop {
                        let _e119 = phi_201_;
                        let _e121 = phi_204_;
                        local_1 = _e121;
                        if (_e119.member < _e119.member_1) {
                            phi_202_ = type_10((_e119.member + 1u), _e119.member_1);
                            phi_227_ = type_10(1u, _e119.member);
                        } else {
                            phi_202_ = _e119;
                            phi_227_ = type_10(0u, type_10().member_1);
                        }
                        let _e134 = phi_202_;
                        let _e136 = phi_227_;
                        let _e140 = (bitcast<i32>(_e136.member) != 0i);
                        if _e140 {
                            let _e151 = (((((_e86 * _e81) + (((_e77 + (2u * _e66)) + ((2u * _e96) * _e73)) + ((2u * _e94) * _e76))) + (_e136.member_1 & 1u)) + (((_e136.member_1 >> bitcast<u32>(1i)) & 1u) * _e73)) + ((_e136.member_1 >> bitcast<u32>(2i)) * _e76));
                            let _e154 = state.member[_e151];
                            let _e158 = state.member[((3u * _e81) + _e151)];
                            let _e163 = state.member[((_e81 * 6u) + _e151)];
                            let _e168 = state.member[((_e81 * 9u) + _e151)];
                            let _e170 = (_e154 + (_e158 * 0.8944272f));
                            let _e171 = (_e163 * 0.4472136f);
                            let _e172 = (_e168 * 0.4472136f);
                            let _e173 = (_e170 + _e171);
                            let _e175 = select(0f, _e173, (0f < _e173));
                            let _e176 = (_e170 - _e171);
                            let _e178 = select(0f, _e176, (0f < _e176));
                            let _e179 = (_e170 + _e172);
                            let _e181 = select(0f, _e179, (0f < _e179));
                            let _e182 = (_e170 - _e172);
                            let _e184 = select(0f, _e182, (0f < _e182));
                            let _e185 = (_e154 + _e158);
                            let _e188 = (select(0f, _e185, (0f < _e185)) * 0.4006697f);
                            let _e192 = (((_e175 + _e178) + (_e181 + _e184)) * 0.42343134f);
                            let _e197 = (_e154 + (_e158 * -0.8944272f));
                            let _e198 = (_e197 + _e171);
                            let _e200 = select(0f, _e198, (0f < _e198));
                            let _e201 = (_e197 - _e171);
                            let _e203 = select(0f, _e201, (0f < _e201));
                            let _e204 = (_e197 + _e172);
                            let _e206 = select(0f, _e204, (0f < _e204));
                            let _e207 = (_e197 - _e172);
                            let _e209 = select(0f, _e207, (0f < _e207));
                            let _e210 = (_e154 + -(_e158));
                            let _e213 = (select(0f, _e210, (0f < _e210)) * 0.4006697f);
                            let _e217 = (((_e200 + _e203) + (_e206 + _e209)) * 0.42343134f);
                            let _e230 = (_e154 + (_e163 * 0.8944272f));
                            let _e231 = (_e158 * 0.4472136f);
                            let _e232 = (_e230 + _e172);
                            let _e234 = select(0f, _e232, (0f < _e232));
                            let _e235 = (_e230 - _e172);
                            let _e237 = select(0f, _e235, (0f < _e235));
                            let _e238 = (_e230 + _e231);
                            let _e240 = select(0f, _e238, (0f < _e238));
                            let _e241 = (_e230 - _e231);
                            let _e243 = select(0f, _e241, (0f < _e241));
                            let _e244 = (_e154 + _e163);
                            let _e247 = (select(0f, _e244, (0f < _e244)) * 0.4006697f);
                            let _e251 = (((_e234 + _e237) + (_e240 + _e243)) * 0.42343134f);
                            let _e256 = (_e154 + (_e163 * -0.8944272f));
                            let _e257 = (_e256 + _e172);
                            let _e259 = select(0f, _e257, (0f < _e257));
                            let _e260 = (_e256 - _e172);
                            let _e262 = select(0f, _e260, (0f < _e260));
                            let _e263 = (_e256 + _e231);
                            let _e265 = select(0f, _e263, (0f < _e263));
                            let _e266 = (_e256 - _e231);
                            let _e268 = select(0f, _e266, (0f < _e266));
                            let _e269 = (_e154 + -(_e163));
                            let _e272 = (select(0f, _e269, (0f < _e269)) * 0.4006697f);
                            let _e276 = (((_e259 + _e262) + (_e265 + _e268)) * 0.42343134f);
                            let _e293 = (_e154 + (_e168 * 0.8944272f));
                            let _e294 = (_e293 + _e231);
                            let _e296 = select(0f, _e294, (0f < _e294));
                            let _e297 = (_e293 - _e231);
                            let _e299 = select(0f, _e297, (0f < _e297));
                            let _e300 = (_e293 + _e171);
                            let _e302 = select(0f, _e300, (0f < _e300));
                            let _e303 = (_e293 - _e171);
                            let _e305 = select(0f, _e303, (0f < _e303));
                            let _e306 = (_e154 + _e168);
                            let _e309 = (select(0f, _e306, (0f < _e306)) * 0.4006697f);
                            let _e313 = (((_e296 + _e299) + (_e302 + _e305)) * 0.42343134f);
                            let _e318 = (_e154 + (_e168 * -0.8944272f));
                            let _e319 = (_e318 + _e231);
                            let _e321 = select(0f, _e319, (0f < _e319));
                            let _e322 = (_e318 - _e231);
                            let _e324 = select(0f, _e322, (0f < _e322));
                            let _e325 = (_e318 + _e171);
                            let _e327 = select(0f, _e325, (0f < _e325));
                            let _e328 = (_e318 - _e171);
                            let _e330 = select(0f, _e328, (0f < _e328));
                            let _e331 = (_e154 + -(_e168));
                            let _e334 = (select(0f, _e331, (0f < _e331)) * 0.4006697f);
                            let _e338 = (((_e321 + _e324) + (_e327 + _e330)) * 0.42343134f);
                            let _e363 = state.member[((_e81 * 12u) + _e151)];
                            phi_205_ = array<f32, 4>((_e121[0] + ((((_e188 + _e192) + (_e213 + _e217)) + ((_e247 + _e251) + (_e272 + _e276))) + ((_e309 + _e313) + (_e334 + _e338)))), (_e121[1] + (((((_e188 - _e213) + ((_e192 - _e217) * 0.8944272f)) + (((_e240 - _e243) + (_e265 - _e268)) * 0.18936425f)) + (((_e296 - _e299) + (_e321 - _e324)) * 0.18936425f)) * _e363)), (_e121[2] + (((((((_e175 - _e178) + (_e200 - _e203)) * 0.18936425f) + (_e247 - _e272)) + ((_e251 - _e276) * 0.8944272f)) + (((_e302 - _e305) + (_e327 - _e330)) * 0.18936425f)) * _e363)), (_e121[3] + ((((0.18936425f * (((_e181 - _e184) + (_e206 - _e209)) + ((_e234 - _e237) + (_e259 - _e262)))) + (_e309 - _e334)) + ((_e313 - _e338) * 0.8944272f)) * _e363)));
                        } else {
                            phi_205_ = array<f32, 4>();
                        }
                        let _e377 = phi_205_;
                        continue;
                        continuing {
                            phi_201_ = _e134;
                            phi_204_ = _e377;
                            break if !(_e140);
                        }
                    }
                    let _e429 = local_1;
                    phi_581_ = _e429;
                } else {
                    phi_581_ = array<f32, 4>(0f, 0f, 0f, 0f);
                }
                let _e380 = phi_581_;
                local = array<f32, 4>(_e380[0], _e380[1], _e380[2], _e380[3]);
                phi_589_ = type_10(0u, 4u);
                loop {
                    let _e387 = phi_589_;
                    if (_e387.member < _e387.member_1) {
                        phi_590_ = type_10((_e387.member + 1u), _e387.member_1);
                        phi_613_ = type_10(1u, _e387.member);
                    } else {
                        phi_590_ = _e387;
                        phi_613_ = type_10(0u, type_10().member_1);
                    }
                    let _e400 = phi_590_;
                    let _e402 = phi_613_;
                    let _e406 = (bitcast<i32>(_e402.member) != 0i);
                    if _e406 {
                        if (_e402.member_1 < 4u) {
                        } else {
                            phi_642_ = true;
                            break;
                        }
                        let _e409 = local[_e402.member_1];
                        let _e411 = ((_e402.member_1 * (3u * _e49)) + ((_e64 * _e41) + _e66));
                        if (_e411 < arrayLength((&out.member))) {
                        } else {
                            phi_642_ = true;
                            break;
                        }
                        out.member[_e411] = _e409;
                    }
                    continue;
                    continuing {
                        phi_589_ = _e400;
                        phi_642_ = false;
                        break if !(_e406);
                    }
                }
                let _e417 = phi_642_;
                if _e417 {
                    break;
                }
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
