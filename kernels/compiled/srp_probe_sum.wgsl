struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: f32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_14 {
    member: type_13,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_14;
@group(0) @binding(1) 
var<storage> partial: type_5;
@group(0) @binding(2) 
var<storage, read_write> coefs: type_5;

fn function_() {
    var phi_148_: u32;
    var phi_166_: u32;
    var phi_184_: u32;
    var phi_207_: type_11;
    var phi_210_: f32;
    var phi_208_: type_11;
    var phi_233_: type_11;
    var phi_211_: f32;
    var phi_294_: bool;
    var phi_267_: f32;
    var local: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e19 = gid_1;
            let _e26 = params.member.member_3;
            let _e28 = select(_e26, 16u, (_e26 == 0u));
            let _e31 = params.member.member;
            let _e34 = params.member.member_2;
            let _e35 = (_e28 == 0u);
            if _e35 {
                break;
            }
            if _e35 {
                break;
            }
            let _e37 = ((_e31 * _e34) + 16u);
            let _e42 = (_e19.x + (_e19.y * 2097152u));
            if (_e42 < (3u * _e37)) {
                let _e44 = (_e31 / 16u);
                if ((_e31 % 16u) > 0u) {
                    phi_148_ = (_e44 + 1u);
                } else {
                    phi_148_ = _e44;
                }
                let _e49 = phi_148_;
                let _e50 = (_e34 / 8u);
                if ((_e34 % 8u) > 0u) {
                    phi_166_ = (_e50 + 1u);
                } else {
                    phi_166_ = _e50;
                }
                let _e55 = phi_166_;
                let _e58 = params.member.member_1;
                if _e35 {
                    break;
                }
                let _e59 = (_e58 / _e28);
                if _e35 {
                    break;
                }
                if ((_e58 % _e28) > 0u) {
                    phi_184_ = (_e59 + 1u);
                } else {
                    phi_184_ = _e59;
                }
                let _e64 = phi_184_;
                if (_e37 == 0u) {
                    break;
                }
                let _e66 = (_e42 / _e37);
                let _e68 = (_e42 - (_e66 * _e37));
                if (_e34 == 0u) {
                    break;
                }
                let _e70 = (_e68 / _e34);
                if (_e70 < _e31) {
                    phi_207_ = type_11(0u, _e64);
                    phi_210_ = 0f;
                    loop {
                        let _e74 = phi_207_;
                        let _e76 = phi_210_;
                        local = _e76;
                        if (_e74.member < _e74.member_1) {
                            phi_208_ = type_11((_e74.member + 1u), _e74.member_1);
                            phi_233_ = type_11(1u, _e74.member);
                        } else {
                            phi_208_ = _e74;
                            phi_233_ = type_11(0u, type_11().member_1);
                        }
                        let _e89 = phi_208_;
                        let _e91 = phi_233_;
                        let _e95 = (bitcast<i32>(_e91.member) != 0i);
                        if _e95 {
                            let _e97 = (_e68 - (_e70 * _e34));
                            let _e113 = ((((((_e66 * 8u) + (_e97 % 8u)) * ((_e64 * _e49) * _e55)) + ((((_e91.member_1 * _e49) + (_e70 / 16u)) * _e55) + (_e97 / 8u))) * 16u) + (_e70 % 16u));
                            if (_e113 < arrayLength((&partial.member))) {
                            } else {
                                phi_294_ = true;
                                break;
                            }
                            let _e117 = partial.member[_e113];
                            phi_211_ = (_e76 + _e117);
                        } else {
                            phi_211_ = f32();
                        }
                        let _e120 = phi_211_;
                        continue;
                        continuing {
                            phi_207_ = _e89;
                            phi_210_ = _e120;
                            phi_294_ = false;
                            break if !(_e95);
                        }
                    }
                    let _e123 = phi_294_;
                    if _e123 {
                        break;
                    }
                    let _e144 = local;
                    phi_267_ = _e144;
                } else {
                    phi_267_ = 0f;
                }
                let _e125 = phi_267_;
                let _e128 = params.member.member_4;
                if (_e42 < arrayLength((&coefs.member))) {
                } else {
                    break;
                }
                coefs.member[_e42] = (_e125 * _e128);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_probe_sum(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
