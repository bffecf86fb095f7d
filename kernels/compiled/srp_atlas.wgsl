struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_18 {
    member: array<vec4<f32>>,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: array<u32, 4>,
    member_1: array<f32, 4>,
}

struct type_26 {
    member: array<type_24>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_22;
@group(0) @binding(1) 
var<storage> map: type_11;
@group(0) @binding(2) 
var<storage> blends: type_26;
@group(0) @binding(3) 
var<storage> irradiance: type_5;
@group(0) @binding(4) 
var<storage, read_write> texels: type_18;

fn function_() {
    var phi_325_: vec4<f32>;
    var phi_326_: vec4<f32>;
    var phi_327_: vec4<f32>;
    var phi_329_: vec4<f32>;
    var phi_330_: vec4<f32>;
    var phi_331_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = gid_1;
            let _e28 = arrayLength((&irradiance.member));
            let _e33 = params.member.member;
            let _e37 = (_e22.x + (_e22.y * 2097152u));
            if (_e37 < _e33) {
                if (_e37 < arrayLength((&map.member))) {
                } else {
                    break;
                }
                let _e42 = map.member[_e37];
                if (_e42 == 4294967295u) {
                    phi_329_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_330_ = vec4<f32>();
                    phi_331_ = true;
                } else {
                    let _e45 = ((_e42 & 2147483648u) == 0u);
                    if _e45 {
                        let _e186 = params.member.member_1;
                        if (_e42 < _e28) {
                        } else {
                            break;
                        }
                        let _e190 = irradiance.member[_e42];
                        let _e191 = (_e186 + _e42);
                        if (_e191 < _e28) {
                        } else {
                            break;
                        }
                        let _e195 = irradiance.member[_e191];
                        let _e197 = ((2u * _e186) + _e42);
                        if (_e197 < _e28) {
                        } else {
                            break;
                        }
                        let _e201 = irradiance.member[_e197];
                        phi_326_ = vec4<f32>(select(0f, _e190, (_e190 > 0f)), select(0f, _e195, (_e195 > 0f)), select(0f, _e201, (_e201 > 0f)), 1f);
                        phi_327_ = vec4<f32>();
                    } else {
                        let _e46 = (_e42 & 2147483647u);
                        if (_e46 < arrayLength((&blends.member))) {
                        } else {
                            break;
                        }
                        let _e50 = params.member.member_1;
                        if (_e50 == 0u) {
                            phi_325_ = vec4<f32>(0f, 0f, 0f, 0f);
                        } else {
                            let _e56 = blends.member[_e46].member[0u];
                            let _e61 = blends.member[_e46].member_1[0u];
                            if (_e56 < _e28) {
                            } else {
                                break;
                            }
                            let _e65 = irradiance.member[_e56];
                            let _e66 = (_e50 + _e56);
                            if (_e66 < _e28) {
                            } else {
                                break;
                            }
                            let _e70 = irradiance.member[_e66];
                            let _e71 = (2u * _e50);
                            let _e72 = (_e71 + _e56);
                            if (_e72 < _e28) {
                            } else {
                                break;
                            }
                            let _e76 = irradiance.member[_e72];
                            let _e84 = blends.member[_e46].member[1u];
                            let _e89 = blends.member[_e46].member_1[1u];
                            if (_e84 < _e28) {
                            } else {
                                break;
                            }
                            let _e93 = irradiance.member[_e84];
                            let _e94 = (_e50 + _e84);
                            if (_e94 < _e28) {
                            } else {
                                break;
                            }
                            let _e98 = irradiance.member[_e94];
                            let _e99 = (_e71 + _e84);
                            if (_e99 < _e28) {
                            } else {
                                break;
                            }
                            let _e103 = irradiance.member[_e99];
                            let _e115 = blends.member[_e46].member[2u];
                            let _e120 = blends.member[_e46].member_1[2u];
                            if (_e115 < _e28) {
                            } else {
                                break;
                            }
                            let _e124 = irradiance.member[_e115];
                            let _e125 = (_e50 + _e115);
                            if (_e125 < _e28) {
                            } else {
                                break;
                            }
                            let _e129 = irradiance.member[_e125];
                            let _e130 = (_e71 + _e115);
                            if (_e130 < _e28) {
                            } else {
                                break;
                            }
                            let _e134 = irradiance.member[_e130];
                            let _e146 = blends.member[_e46].member[3u];
                            let _e151 = blends.member[_e46].member_1[3u];
                            if (_e146 < _e28) {
                            } else {
                                break;
                            }
                            let _e155 = irradiance.member[_e146];
                            let _e156 = (_e50 + _e146);
                            if (_e156 < _e28) {
                            } else {
                                break;
                            }
                            let _e160 = irradiance.member[_e156];
                            let _e161 = (_e71 + _e146);
                            if (_e161 < _e28) {
                            } else {
                                break;
                            }
                            let _e165 = irradiance.member[_e161];
                            let _e169 = ((((_e61 * _e65) + (_e89 * _e93)) + (_e120 * _e124)) + (_e151 * _e155));
                            let _e170 = ((((_e61 * _e70) + (_e89 * _e98)) + (_e120 * _e129)) + (_e151 * _e160));
                            let _e171 = ((((_e61 * _e76) + (_e89 * _e103)) + (_e120 * _e134)) + (_e151 * _e165));
                            phi_325_ = vec4<f32>(select(0f, _e169, (_e169 > 0f)), select(0f, _e170, (_e170 > 0f)), select(0f, _e171, (_e171 > 0f)), select(0f, 1f, ((((_e61 + _e89) + _e120) + _e151) > 0f)));
                        }
                        let _e183 = phi_325_;
                        phi_326_ = vec4<f32>();
                        phi_327_ = _e183;
                    }
                    let _e210 = phi_326_;
                    let _e212 = phi_327_;
                    phi_329_ = _e212;
                    phi_330_ = _e210;
                    phi_331_ = select(true, false, _e45);
                }
                let _e215 = phi_329_;
                let _e217 = phi_330_;
                let _e219 = phi_331_;
                if (_e37 < arrayLength((&texels.member))) {
                } else {
                    break;
                }
                texels.member[_e37] = select(_e217, _e215, vec4(_e219));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_atlas(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
