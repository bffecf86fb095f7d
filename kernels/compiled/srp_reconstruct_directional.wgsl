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
var<storage> blocks: type_24;
@group(0) @binding(2) 
var<storage> words: type_14;
@group(0) @binding(3) 
var<storage> basis: type_5;
@group(0) @binding(4) 
var<storage, read_write> radiance: type_5;

fn function_() {
    var local: array<f32, 12>;
    var phi_133_: type_11;
    var phi_136_: u32;
    var phi_138_: u32;
    var phi_140_: array<f32, 12>;
    var phi_134_: type_11;
    var phi_163_: type_11;
    var phi_137_: u32;
    var phi_139_: u32;
    var phi_141_: array<f32, 12>;
    var phi_591_: bool;
    var local_1: array<f32, 12>;
    var local_2: array<f32, 12>;
    var local_3: array<f32, 12>;
    var local_4: array<f32, 12>;
    var local_5: array<f32, 12>;
    var local_6: array<f32, 12>;
    var local_7: array<f32, 12>;
    var local_8: array<f32, 12>;
    var local_9: array<f32, 12>;
    var local_10: array<f32, 12>;
    var local_11: array<f32, 12>;
    var local_12: array<f32, 12>;
    var phi_535_: type_11;
    var phi_536_: type_11;
    var phi_559_: type_11;
    var phi_595_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = gid_1;
            let _e40 = arrayLength((&basis.member));
            let _e45 = params.member.member;
            let _e49 = params.member.member_2;
            let _e53 = params.member.member_1;
            let _e57 = (_e36.x + (_e36.y * 2097152u));
            if (_e57 < (_e53 * 16u)) {
                let _e60 = (_e57 / 16u);
                let _e61 = (_e60 * 16u);
                let _e62 = (_e57 - _e61);
                let _e65 = (_e45 + _e60);
                if (_e65 < arrayLength((&blocks.member))) {
                } else {
                    break;
                }
                let _e70 = blocks.member[_e65].member;
                let _e74 = blocks.member[_e65].member_1;
                let _e78 = blocks.member[_e65].member_2;
                phi_133_ = type_11(0u, _e74);
                phi_136_ = (4u * _e78);
                phi_138_ = (_e70 + _e62);
                phi_140_ = array<f32, 12>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e83 = phi_133_;
                    let _e85 = phi_136_;
                    let _e87 = phi_138_;
                    let _e89 = phi_140_;
                    local_1 = _e89;
                    local_2 = _e89;
                    local_3 = _e89;
                    local_4 = _e89;
                    local_5 = _e89;
                    local_6 = _e89;
                    local_7 = _e89;
                    local_8 = _e89;
                    local_9 = _e89;
                    local_10 = _e89;
                    local_11 = _e89;
                    local_12 = _e89;
                    if (_e83.member < _e83.member_1) {
                        phi_134_ = type_11((_e83.member + 1u), _e83.member_1);
                        phi_163_ = type_11(1u, _e83.member);
                    } else {
                        phi_134_ = _e83;
                        phi_163_ = type_11(0u, type_11().member_1);
                    }
                    let _e102 = phi_134_;
                    let _e104 = phi_163_;
                    let _e107 = (bitcast<i32>(_e104.member) != 0i);
                    if _e107 {
                        let _e110 = words.member[_e87];
                        let _e119 = (bitcast<f32>((((_e110 << bitcast<u32>(16i)) & 2147483648u) | ((_e110 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e126 = (bitcast<f32>(((_e110 & 2147483648u) | ((_e110 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e128 = (_e85 < _e40);
                        if _e128 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        let _e131 = basis.member[_e85];
                        let _e134 = (_e85 + 4u);
                        let _e135 = (_e134 < _e40);
                        if _e135 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        let _e138 = basis.member[_e134];
                        let _e142 = (_e85 + 1u);
                        let _e143 = (_e142 < _e40);
                        if _e143 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        let _e146 = basis.member[_e142];
                        let _e149 = (_e85 + 5u);
                        let _e150 = (_e149 < _e40);
                        if _e150 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        let _e153 = basis.member[_e149];
                        let _e157 = (_e85 + 2u);
                        let _e158 = (_e157 < _e40);
                        if _e158 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        let _e161 = basis.member[_e157];
                        let _e164 = (_e85 + 6u);
                        let _e165 = (_e164 < _e40);
                        if _e165 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        let _e168 = basis.member[_e164];
                        let _e174 = words.member[(_e87 + 16u)];
                        let _e183 = (bitcast<f32>((((_e174 << bitcast<u32>(16i)) & 2147483648u) | ((_e174 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e190 = (bitcast<f32>(((_e174 & 2147483648u) | ((_e174 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e128 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e135 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e143 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e150 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e158 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e165 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        let _e209 = words.member[(_e87 + 32u)];
                        let _e218 = (bitcast<f32>((((_e209 << bitcast<u32>(16i)) & 2147483648u) | ((_e209 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e225 = (bitcast<f32>(((_e209 & 2147483648u) | ((_e209 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e128 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e135 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e143 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e150 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e158 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e165 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        let _e244 = words.member[(_e87 + 48u)];
                        let _e253 = (bitcast<f32>((((_e244 << bitcast<u32>(16i)) & 2147483648u) | ((_e244 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e260 = (bitcast<f32>(((_e244 & 2147483648u) | ((_e244 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e128 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e135 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e143 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e150 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e158 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        if _e165 {
                        } else {
                            phi_591_ = true;
                            break;
                        }
                        phi_137_ = (_e85 + 8u);
                        phi_139_ = (_e87 + 64u);
                        phi_141_ = array<f32, 12>(((_e89[0] + (_e119 * _e131)) + (_e126 * _e138)), ((_e89[1] + (_e119 * _e146)) + (_e126 * _e153)), ((_e89[2] + (_e119 * _e161)) + (_e126 * _e168)), ((_e89[3] + (_e183 * _e131)) + (_e190 * _e138)), ((_e89[4] + (_e183 * _e146)) + (_e190 * _e153)), ((_e89[5] + (_e183 * _e161)) + (_e190 * _e168)), ((_e89[6] + (_e218 * _e131)) + (_e225 * _e138)), ((_e89[7] + (_e218 * _e146)) + (_e225 * _e153)), ((_e89[8] + (_e218 * _e161)) + (_e225 * _e168)), ((_e89[9] + (_e253 * _e131)) + (_e260 * _e138)), ((_e89[10] + (_e253 * _e146)) + (_e260 * _e153)), ((_e89[11] + (_e253 * _e161)) + (_e260 * _e168)));
                    } else {
                        phi_137_ = u32();
                        phi_139_ = u32();
                        phi_141_ = array<f32, 12>();
                    }
                    let _e280 = phi_137_;
                    let _e282 = phi_139_;
                    let _e284 = phi_141_;
                    continue;
                    continuing {
                        phi_133_ = _e102;
                        phi_136_ = _e280;
                        phi_138_ = _e282;
                        phi_140_ = _e284;
                        phi_591_ = false;
                        break if !(_e107);
                    }
                }
                let _e287 = phi_591_;
                if _e287 {
                    break;
                }
                let _e289 = local_1;
                let _e292 = local_2;
                let _e295 = local_3;
                let _e298 = local_4;
                let _e301 = local_5;
                let _e304 = local_6;
                let _e307 = local_7;
                let _e310 = local_8;
                let _e313 = local_9;
                let _e316 = local_10;
                let _e319 = local_11;
                let _e322 = local_12;
                local = array<f32, 12>(_e289[0], _e292[1], _e295[2], _e298[3], _e301[4], _e304[5], _e307[6], _e310[7], _e313[8], _e316[9], _e319[10], _e322[11]);
                phi_535_ = type_11(0u, 12u);
                loop {
                    let _e326 = phi_535_;
                    if (_e326.member < _e326.member_1) {
                        phi_536_ = type_11((_e326.member + 1u), _e326.member_1);
                        phi_559_ = type_11(1u, _e326.member);
                    } else {
                        phi_536_ = _e326;
                        phi_559_ = type_11(0u, type_11().member_1);
                    }
                    let _e339 = phi_536_;
                    let _e341 = phi_559_;
                    let _e345 = (bitcast<i32>(_e341.member) != 0i);
                    if _e345 {
                        if (_e341.member_1 < 12u) {
                        } else {
                            phi_595_ = true;
                            break;
                        }
                        let _e348 = local[_e341.member_1];
                        let _e350 = ((_e341.member_1 * (_e49 * 16u)) + (((_e45 * 16u) + _e61) + _e62));
                        if (_e350 < arrayLength((&radiance.member))) {
                        } else {
                            phi_595_ = true;
                            break;
                        }
                        radiance.member[_e350] = _e348;
                    }
                    continue;
                    continuing {
                        phi_535_ = _e339;
                        phi_595_ = _e287;
                        break if !(_e345);
                    }
                }
                let _e356 = phi_595_;
                if _e356 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_reconstruct_directional(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
