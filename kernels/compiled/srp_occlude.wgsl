struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
}

struct type_20 {
    member: array<vec4<f32>>,
}

struct type_22 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
}

struct type_23 {
    member: type_22,
}

struct type_25 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_27 {
    member: array<type_25>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> hits: type_11;
@group(0) @binding(0) 
var<uniform> params: type_23;
@group(0) @binding(2) 
var<storage> distances: type_5;
@group(0) @binding(3) 
var<storage> rays: type_20;
@group(0) @binding(4) 
var<storage> occluders: type_27;
@group(0) @binding(5) 
var<storage, read_write> seen: type_11;

fn function_() {
    var phi_110_: u32;
    var phi_191_: type_14;
    var phi_194_: f32;
    var phi_196_: u32;
    var phi_192_: type_14;
    var phi_219_: type_14;
    var phi_458_: bool;
    var phi_463_: bool;
    var phi_472_: f32;
    var phi_404_: f32;
    var phi_406_: f32;
    var phi_407_: bool;
    var phi_473_: f32;
    var phi_480_: u32;
    var phi_195_: f32;
    var phi_197_: u32;
    var phi_505_: bool;
    var phi_481_: u32;
    var phi_482_: u32;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = gid_1;
            let _e34 = arrayLength((&rays.member));
            let _e41 = params.member.member_6;
            let _e45 = (_e28.x + (_e28.y * 2097152u));
            if (_e45 < _e41) {
                let _e49 = params.member.member_1;
                let _e50 = (_e49 / 16u);
                if ((_e49 % 16u) > 0u) {
                    phi_110_ = (_e50 + 1u);
                } else {
                    phi_110_ = _e50;
                }
                let _e55 = phi_110_;
                let _e56 = (_e45 / 16u);
                let _e59 = params.member.member_3;
                if (_e59 == 0u) {
                    break;
                }
                let _e61 = (_e56 / _e59);
                if (_e55 == 0u) {
                    break;
                }
                let _e63 = (_e61 / _e55);
                let _e69 = ((((_e61 - (_e63 * _e55)) * 16u) + _e45) - (_e56 * 16u));
                let _e73 = (((_e63 * _e59) + _e56) - (_e61 * _e59));
                if (_e45 < arrayLength((&hits.member))) {
                } else {
                    break;
                }
                let _e77 = hits.member[_e45];
                if (_e45 < arrayLength((&distances.member))) {
                } else {
                    break;
                }
                let _e81 = distances.member[_e45];
                if (_e69 < _e49) {
                    let _e85 = params.member.member_2;
                    if (_e73 < _e85) {
                        if (_e69 < _e34) {
                        } else {
                            break;
                        }
                        let _e90 = rays.member[_e69];
                        let _e94 = (_e49 + _e73);
                        if (_e94 < _e34) {
                        } else {
                            break;
                        }
                        let _e98 = rays.member[_e94];
                        let _e104 = params.member.member_4;
                        phi_191_ = type_14(0u, _e104);
                        phi_194_ = _e81;
                        phi_196_ = _e77;
                        loop {
                            let _e107 = phi_191_;
                            let _e109 = phi_194_;
                            let _e111 = phi_196_;
                            local = _e111;
                            if (_e107.member < _e107.member_1) {
                                phi_192_ = type_14((_e107.member + 1u), _e107.member_1);
                                phi_219_ = type_14(1u, _e107.member);
                            } else {
                                phi_192_ = _e107;
                                phi_219_ = type_14(0u, type_14().member_1);
                            }
                            let _e124 = phi_192_;
                            let _e126 = phi_219_;
                            let _e130 = (bitcast<i32>(_e126.member) != 0i);
                            if _e130 {
                                if (_e126.member_1 < arrayLength((&occluders.member))) {
                                } else {
                                    phi_505_ = true;
                                    break;
                                }
                                let _e134 = occluders.member[_e126.member_1];
                                let _e146 = ((((_e134.member[0].x * _e90.x) + (_e134.member[0].y * _e90.y)) + (_e134.member[0].z * _e90.z)) + _e134.member[0].w);
                                let _e158 = ((((_e134.member[1].x * _e90.x) + (_e134.member[1].y * _e90.y)) + (_e134.member[1].z * _e90.z)) + _e134.member[1].w);
                                let _e170 = ((((_e134.member[2].x * _e90.x) + (_e134.member[2].y * _e90.y)) + (_e134.member[2].z * _e90.z)) + _e134.member[2].w);
                                let _e175 = (((_e134.member[0].x * _e98.x) + (_e134.member[0].y * _e98.y)) + (_e134.member[0].z * _e98.z));
                                let _e180 = (((_e134.member[1].x * _e98.x) + (_e134.member[1].y * _e98.y)) + (_e134.member[1].z * _e98.z));
                                let _e185 = (((_e134.member[2].x * _e98.x) + (_e134.member[2].y * _e98.y)) + (_e134.member[2].z * _e98.z));
                                if (_e134.member_1 == 1u) {
                                    let _e229 = select(_e175, 0.000000000001f, (abs(_e175) < 0.000000000001f));
                                    let _e231 = ((-1f - _e146) / _e229);
                                    let _e233 = ((1f - _e146) / _e229);
                                    let _e235 = select(_e233, _e231, (_e231 < _e233));
                                    let _e237 = select(_e233, _e231, (_e231 > _e233));
                                    let _e240 = select(_e180, 0.000000000001f, (abs(_e180) < 0.000000000001f));
                                    let _e242 = ((-1f - _e158) / _e240);
                                    let _e244 = ((1f - _e158) / _e240);
                                    let _e246 = select(_e244, _e242, (_e242 < _e244));
                                    let _e248 = select(_e244, _e242, (_e242 > _e244));
                                    let _e251 = select(_e185, 0.000000000001f, (abs(_e185) < 0.000000000001f));
                                    let _e253 = ((-1f - _e170) / _e251);
                                    let _e255 = ((1f - _e170) / _e251);
                                    let _e257 = select(_e255, _e253, (_e253 < _e255));
                                    let _e259 = select(_e255, _e253, (_e253 > _e255));
                                    let _e261 = select(_e246, _e235, (_e235 > _e246));
                                    let _e263 = select(_e257, _e261, (_e261 > _e257));
                                    let _e265 = select(_e248, _e237, (_e237 < _e248));
                                    let _e267 = select(_e259, _e265, (_e265 < _e259));
                                    if (_e263 <= _e267) {
                                        let _e269 = (_e267 >= 0f);
                                        if _e269 {
                                            phi_404_ = select(0f, _e263, (_e263 > 0f));
                                        } else {
                                            phi_404_ = f32();
                                        }
                                        let _e273 = phi_404_;
                                        phi_406_ = _e273;
                                        phi_407_ = select(true, false, _e269);
                                    } else {
                                        phi_406_ = f32();
                                        phi_407_ = true;
                                    }
                                    let _e276 = phi_406_;
                                    let _e278 = phi_407_;
                                    phi_473_ = select(_e276, 340282350000000000000000000000000000000f, _e278);
                                } else {
                                    let _e192 = (((_e175 * _e175) + (_e180 * _e180)) + (_e185 * _e185));
                                    let _e197 = (((_e146 * _e175) + (_e158 * _e180)) + (_e170 * _e185));
                                    let _e203 = ((((_e146 * _e146) + (_e158 * _e158)) + (_e170 * _e170)) - 1f);
                                    let _e206 = ((_e197 * _e197) - (_e192 * _e203));
                                    let _e208 = (_e206 > 0f);
                                    let _e214 = ((-(_e197) - sqrt(select(0f, _e206, _e208))) / select(0.000000000000000000000000000000000000011754944f, _e192, (_e192 > 0.000000000000000000000000000000000000011754944f)));
                                    if (_e203 <= 0f) {
                                        phi_463_ = true;
                                    } else {
                                        if _e208 {
                                            phi_458_ = select(true, false, (_e197 < 0f));
                                        } else {
                                            phi_458_ = true;
                                        }
                                        let _e219 = phi_458_;
                                        phi_463_ = select(true, false, _e219);
                                    }
                                    let _e222 = phi_463_;
                                    if _e222 {
                                        phi_472_ = select(0f, _e214, (_e214 > 0f));
                                    } else {
                                        phi_472_ = 340282350000000000000000000000000000000f;
                                    }
                                    let _e226 = phi_472_;
                                    phi_473_ = _e226;
                                }
                                let _e281 = phi_473_;
                                let _e282 = (_e281 < _e109);
                                if _e282 {
                                    phi_480_ = _e134.member_2;
                                } else {
                                    phi_480_ = _e111;
                                }
                                let _e285 = phi_480_;
                                phi_195_ = select(_e109, _e281, _e282);
                                phi_197_ = _e285;
                            } else {
                                phi_195_ = f32();
                                phi_197_ = u32();
                            }
                            let _e288 = phi_195_;
                            let _e290 = phi_197_;
                            continue;
                            continuing {
                                phi_191_ = _e124;
                                phi_194_ = _e288;
                                phi_196_ = _e290;
                                phi_505_ = false;
                                break if !(_e130);
                            }
                        }
                        let _e293 = phi_505_;
                        if _e293 {
                            break;
                        }
                        let _e320 = local;
                        phi_481_ = _e320;
                    } else {
                        phi_481_ = _e77;
                    }
                    let _e295 = phi_481_;
                    phi_482_ = _e295;
                } else {
                    phi_482_ = _e77;
                }
                let _e297 = phi_482_;
                if (_e45 < arrayLength((&seen.member))) {
                } else {
                    break;
                }
                seen.member[_e45] = _e297;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_occlude(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
