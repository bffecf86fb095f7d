struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<u32>,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_21 {
    member: type_20,
}

struct type_24 {
    member: array<type_19>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_21;
@group(0) @binding(1) 
var<storage> pairs: type_24;
@group(0) @binding(2) 
var<storage> blocks: type_14;
@group(0) @binding(3) 
var<storage> words: type_14;
@group(0) @binding(4) 
var<storage> coefs: type_5;
@group(0) @binding(5) 
var<storage, read_write> partial: type_5;

fn function_() {
    var local: array<f32, 6>;
    var phi_133_: type_11;
    var phi_136_: u32;
    var phi_138_: u32;
    var phi_140_: array<f32, 6>;
    var phi_134_: type_11;
    var phi_163_: type_11;
    var phi_137_: u32;
    var phi_139_: u32;
    var phi_141_: array<f32, 6>;
    var phi_349_: bool;
    var local_1: array<f32, 6>;
    var local_2: array<f32, 6>;
    var local_3: array<f32, 6>;
    var local_4: array<f32, 6>;
    var local_5: array<f32, 6>;
    var local_6: array<f32, 6>;
    var phi_293_: type_11;
    var phi_294_: type_11;
    var phi_317_: type_11;
    var phi_353_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = gid_1;
            let _e36 = arrayLength((&blocks.member));
            let _e41 = params.member.member;
            let _e45 = params.member.member_2;
            let _e49 = params.member.member_1;
            let _e53 = (_e32.x + (_e32.y * 2097152u));
            if (_e53 < (_e49 * 16u)) {
                let _e56 = (_e53 / 16u);
                let _e57 = (_e56 * 16u);
                let _e58 = (_e53 - _e57);
                let _e61 = (_e41 + _e56);
                if (_e61 < arrayLength((&pairs.member))) {
                } else {
                    break;
                }
                let _e66 = pairs.member[_e61].member;
                let _e70 = pairs.member[_e61].member_1;
                let _e74 = pairs.member[_e61].member_2;
                let _e77 = params.member.member_3;
                phi_133_ = type_11(0u, _e74);
                phi_136_ = _e70;
                phi_138_ = (_e66 + _e58);
                phi_140_ = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e81 = phi_133_;
                    let _e83 = phi_136_;
                    let _e85 = phi_138_;
                    let _e87 = phi_140_;
                    local_1 = _e87;
                    local_2 = _e87;
                    local_3 = _e87;
                    local_4 = _e87;
                    local_5 = _e87;
                    local_6 = _e87;
                    if (_e81.member < _e81.member_1) {
                        phi_134_ = type_11((_e81.member + 1u), _e81.member_1);
                        phi_163_ = type_11(1u, _e81.member);
                    } else {
                        phi_134_ = _e81;
                        phi_163_ = type_11(0u, type_11().member_1);
                    }
                    let _e100 = phi_134_;
                    let _e102 = phi_163_;
                    let _e105 = (bitcast<i32>(_e102.member) != 0i);
                    if _e105 {
                        if (_e83 < _e36) {
                        } else {
                            phi_349_ = true;
                            break;
                        }
                        let _e109 = blocks.member[_e83];
                        let _e110 = (_e109 + _e58);
                        let _e111 = (_e83 + 1u);
                        if (_e111 < _e36) {
                        } else {
                            phi_349_ = true;
                            break;
                        }
                        let _e115 = blocks.member[_e111];
                        let _e116 = (_e115 + _e58);
                        let _e119 = words.member[_e85];
                        let _e128 = (bitcast<f32>((((_e119 << bitcast<u32>(16i)) & 2147483648u) | ((_e119 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e135 = (bitcast<f32>(((_e119 & 2147483648u) | ((_e119 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e139 = words.member[(_e85 + 16u)];
                        let _e148 = (bitcast<f32>((((_e139 << bitcast<u32>(16i)) & 2147483648u) | ((_e139 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e155 = (bitcast<f32>(((_e139 & 2147483648u) | ((_e139 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e158 = coefs.member[_e110];
                        let _e161 = coefs.member[_e116];
                        let _e175 = coefs.member[(_e77 + _e110)];
                        let _e179 = coefs.member[(_e77 + _e116)];
                        let _e190 = (2u * _e77);
                        let _e194 = coefs.member[(_e190 + _e110)];
                        let _e198 = coefs.member[(_e190 + _e116)];
                        phi_137_ = (_e83 + 2u);
                        phi_139_ = (_e85 + 32u);
                        phi_141_ = array<f32, 6>(((_e87[0] + (_e128 * _e158)) + (_e135 * _e161)), ((_e87[1] + (_e128 * _e175)) + (_e135 * _e179)), ((_e87[2] + (_e128 * _e194)) + (_e135 * _e198)), ((_e87[3] + (_e148 * _e158)) + (_e155 * _e161)), ((_e87[4] + (_e148 * _e175)) + (_e155 * _e179)), ((_e87[5] + (_e148 * _e194)) + (_e155 * _e198)));
                    } else {
                        phi_137_ = u32();
                        phi_139_ = u32();
                        phi_141_ = array<f32, 6>();
                    }
                    let _e213 = phi_137_;
                    let _e215 = phi_139_;
                    let _e217 = phi_141_;
                    continue;
                    continuing {
                        phi_133_ = _e100;
                        phi_136_ = _e213;
                        phi_138_ = _e215;
                        phi_140_ = _e217;
                        phi_349_ = false;
                        break if !(_e105);
                    }
                }
                let _e220 = phi_349_;
                if _e220 {
                    break;
                }
                let _e222 = local_1;
                let _e225 = local_2;
                let _e228 = local_3;
                let _e231 = local_4;
                let _e234 = local_5;
                let _e237 = local_6;
                local = array<f32, 6>(_e222[0], _e225[1], _e228[2], _e231[3], _e234[4], _e237[5]);
                phi_293_ = type_11(0u, 6u);
                loop {
                    let _e241 = phi_293_;
                    if (_e241.member < _e241.member_1) {
                        phi_294_ = type_11((_e241.member + 1u), _e241.member_1);
                        phi_317_ = type_11(1u, _e241.member);
                    } else {
                        phi_294_ = _e241;
                        phi_317_ = type_11(0u, type_11().member_1);
                    }
                    let _e254 = phi_294_;
                    let _e256 = phi_317_;
                    let _e260 = (bitcast<i32>(_e256.member) != 0i);
                    if _e260 {
                        if (_e256.member_1 < 6u) {
                        } else {
                            phi_353_ = true;
                            break;
                        }
                        let _e263 = local[_e256.member_1];
                        let _e265 = ((_e256.member_1 * (_e45 * 16u)) + (((_e41 * 16u) + _e57) + _e58));
                        if (_e265 < arrayLength((&partial.member))) {
                        } else {
                            phi_353_ = true;
                            break;
                        }
                        partial.member[_e265] = _e263;
                    }
                    continue;
                    continuing {
                        phi_293_ = _e254;
                        phi_353_ = _e220;
                        break if !(_e260);
                    }
                }
                let _e271 = phi_353_;
                if _e271 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_cluster(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
