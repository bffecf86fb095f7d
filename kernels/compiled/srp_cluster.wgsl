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

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_20 {
    member: type_19,
}

struct type_23 {
    member: array<type_18>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_20;
@group(0) @binding(1) 
var<storage> pairs: type_23;
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
    var phi_135_: type_11;
    var phi_138_: u32;
    var phi_140_: u32;
    var phi_142_: array<f32, 6>;
    var phi_136_: type_11;
    var phi_165_: type_11;
    var phi_139_: u32;
    var phi_141_: u32;
    var phi_143_: array<f32, 6>;
    var phi_401_: bool;
    var local_1: array<f32, 6>;
    var local_2: array<f32, 6>;
    var local_3: array<f32, 6>;
    var local_4: array<f32, 6>;
    var local_5: array<f32, 6>;
    var local_6: array<f32, 6>;
    var phi_345_: type_11;
    var phi_346_: type_11;
    var phi_369_: type_11;
    var phi_405_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = gid_1;
            let _e36 = arrayLength((&blocks.member));
            let _e38 = arrayLength((&words.member));
            let _e40 = arrayLength((&coefs.member));
            let _e45 = params.member.member;
            let _e49 = params.member.member_2;
            let _e53 = params.member.member_1;
            let _e57 = (_e32.x + (_e32.y * 2097152u));
            if (_e57 < (_e53 * 16u)) {
                let _e60 = (_e57 / 16u);
                let _e61 = (_e60 * 16u);
                let _e62 = (_e57 - _e61);
                let _e65 = (_e45 + _e60);
                if (_e65 < arrayLength((&pairs.member))) {
                } else {
                    break;
                }
                let _e70 = pairs.member[_e65].member;
                let _e74 = pairs.member[_e65].member_1;
                let _e78 = pairs.member[_e65].member_2;
                let _e81 = params.member.member_3;
                phi_135_ = type_11(0u, _e78);
                phi_138_ = _e74;
                phi_140_ = (_e70 + _e62);
                phi_142_ = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e85 = phi_135_;
                    let _e87 = phi_138_;
                    let _e89 = phi_140_;
                    let _e91 = phi_142_;
                    local_1 = _e91;
                    local_2 = _e91;
                    local_3 = _e91;
                    local_4 = _e91;
                    local_5 = _e91;
                    local_6 = _e91;
                    if (_e85.member < _e85.member_1) {
                        phi_136_ = type_11((_e85.member + 1u), _e85.member_1);
                        phi_165_ = type_11(1u, _e85.member);
                    } else {
                        phi_136_ = _e85;
                        phi_165_ = type_11(0u, type_11().member_1);
                    }
                    let _e104 = phi_136_;
                    let _e106 = phi_165_;
                    let _e109 = (bitcast<i32>(_e106.member) != 0i);
                    if _e109 {
                        if (_e87 < _e36) {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e113 = blocks.member[_e87];
                        let _e114 = (_e113 + _e62);
                        let _e115 = (_e87 + 1u);
                        if (_e115 < _e36) {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e119 = blocks.member[_e115];
                        let _e120 = (_e119 + _e62);
                        let _e121 = (_e89 < _e38);
                        if _e121 {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e124 = words.member[_e89];
                        let _e133 = (bitcast<f32>((((_e124 << bitcast<u32>(16i)) & 2147483648u) | ((_e124 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e121 {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e140 = (bitcast<f32>(((_e124 & 2147483648u) | ((_e124 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e141 = (_e89 + 16u);
                        let _e142 = (_e141 < _e38);
                        if _e142 {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e145 = words.member[_e141];
                        let _e154 = (bitcast<f32>((((_e145 << bitcast<u32>(16i)) & 2147483648u) | ((_e145 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e142 {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e161 = (bitcast<f32>(((_e145 & 2147483648u) | ((_e145 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if (_e114 < _e40) {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e165 = coefs.member[_e114];
                        if (_e120 < _e40) {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e169 = coefs.member[_e120];
                        let _e180 = (_e81 + _e114);
                        if (_e180 < _e40) {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e184 = coefs.member[_e180];
                        let _e185 = (_e81 + _e120);
                        if (_e185 < _e40) {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e189 = coefs.member[_e185];
                        let _e200 = (2u * _e81);
                        let _e201 = (_e200 + _e114);
                        if (_e201 < _e40) {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e205 = coefs.member[_e201];
                        let _e206 = (_e200 + _e120);
                        if (_e206 < _e40) {
                        } else {
                            phi_401_ = true;
                            break;
                        }
                        let _e210 = coefs.member[_e206];
                        phi_139_ = (_e87 + 2u);
                        phi_141_ = (_e89 + 32u);
                        phi_143_ = array<f32, 6>(((_e91[0] + (_e133 * _e165)) + (_e140 * _e169)), ((_e91[1] + (_e133 * _e184)) + (_e140 * _e189)), ((_e91[2] + (_e133 * _e205)) + (_e140 * _e210)), ((_e91[3] + (_e154 * _e165)) + (_e161 * _e169)), ((_e91[4] + (_e154 * _e184)) + (_e161 * _e189)), ((_e91[5] + (_e154 * _e205)) + (_e161 * _e210)));
                    } else {
                        phi_139_ = u32();
                        phi_141_ = u32();
                        phi_143_ = array<f32, 6>();
                    }
                    let _e225 = phi_139_;
                    let _e227 = phi_141_;
                    let _e229 = phi_143_;
                    continue;
                    continuing {
                        phi_135_ = _e104;
                        phi_138_ = _e225;
                        phi_140_ = _e227;
                        phi_142_ = _e229;
                        phi_401_ = false;
                        break if !(_e109);
                    }
                }
                let _e232 = phi_401_;
                if _e232 {
                    break;
                }
                let _e234 = local_1;
                let _e237 = local_2;
                let _e240 = local_3;
                let _e243 = local_4;
                let _e246 = local_5;
                let _e249 = local_6;
                local = array<f32, 6>(_e234[0], _e237[1], _e240[2], _e243[3], _e246[4], _e249[5]);
                phi_345_ = type_11(0u, 6u);
                loop {
                    let _e253 = phi_345_;
                    if (_e253.member < _e253.member_1) {
                        phi_346_ = type_11((_e253.member + 1u), _e253.member_1);
                        phi_369_ = type_11(1u, _e253.member);
                    } else {
                        phi_346_ = _e253;
                        phi_369_ = type_11(0u, type_11().member_1);
                    }
                    let _e266 = phi_346_;
                    let _e268 = phi_369_;
                    let _e272 = (bitcast<i32>(_e268.member) != 0i);
                    if _e272 {
                        if (_e268.member_1 < 6u) {
                        } else {
                            phi_405_ = true;
                            break;
                        }
                        let _e275 = local[_e268.member_1];
                        let _e277 = ((_e268.member_1 * (_e49 * 16u)) + (((_e45 * 16u) + _e61) + _e62));
                        if (_e277 < arrayLength((&partial.member))) {
                        } else {
                            phi_405_ = true;
                            break;
                        }
                        partial.member[_e277] = _e275;
                    }
                    continue;
                    continuing {
                        phi_345_ = _e266;
                        phi_405_ = _e232;
                        break if !(_e272);
                    }
                }
                let _e283 = phi_405_;
                if _e283 {
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
