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
    var phi_134_: type_11;
    var phi_137_: u32;
    var phi_139_: u32;
    var phi_141_: array<f32, 12>;
    var phi_135_: type_11;
    var phi_164_: type_11;
    var phi_138_: u32;
    var phi_140_: u32;
    var phi_142_: array<f32, 12>;
    var phi_632_: bool;
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
    var phi_576_: type_11;
    var phi_577_: type_11;
    var phi_600_: type_11;
    var phi_636_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = gid_1;
            let _e40 = arrayLength((&words.member));
            let _e42 = arrayLength((&basis.member));
            let _e47 = params.member.member;
            let _e51 = params.member.member_2;
            let _e55 = params.member.member_1;
            let _e59 = (_e36.x + (_e36.y * 2097152u));
            if (_e59 < (_e55 * 16u)) {
                let _e62 = (_e59 / 16u);
                let _e63 = (_e62 * 16u);
                let _e64 = (_e59 - _e63);
                let _e67 = (_e47 + _e62);
                if (_e67 < arrayLength((&blocks.member))) {
                } else {
                    break;
                }
                let _e72 = blocks.member[_e67].member;
                let _e76 = blocks.member[_e67].member_1;
                let _e80 = blocks.member[_e67].member_2;
                phi_134_ = type_11(0u, _e76);
                phi_137_ = (4u * _e80);
                phi_139_ = (_e72 + _e64);
                phi_141_ = array<f32, 12>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e85 = phi_134_;
                    let _e87 = phi_137_;
                    let _e89 = phi_139_;
                    let _e91 = phi_141_;
                    local_1 = _e91;
                    local_2 = _e91;
                    local_3 = _e91;
                    local_4 = _e91;
                    local_5 = _e91;
                    local_6 = _e91;
                    local_7 = _e91;
                    local_8 = _e91;
                    local_9 = _e91;
                    local_10 = _e91;
                    local_11 = _e91;
                    local_12 = _e91;
                    if (_e85.member < _e85.member_1) {
                        phi_135_ = type_11((_e85.member + 1u), _e85.member_1);
                        phi_164_ = type_11(1u, _e85.member);
                    } else {
                        phi_135_ = _e85;
                        phi_164_ = type_11(0u, type_11().member_1);
                    }
                    let _e104 = phi_135_;
                    let _e106 = phi_164_;
                    let _e109 = (bitcast<i32>(_e106.member) != 0i);
                    if _e109 {
                        let _e110 = (_e89 < _e40);
                        if _e110 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e113 = words.member[_e89];
                        let _e122 = (bitcast<f32>((((_e113 << bitcast<u32>(16i)) & 2147483648u) | ((_e113 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e110 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e129 = (bitcast<f32>(((_e113 & 2147483648u) | ((_e113 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e131 = (_e87 < _e42);
                        if _e131 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e134 = basis.member[_e87];
                        let _e137 = (_e87 + 4u);
                        let _e138 = (_e137 < _e42);
                        if _e138 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e141 = basis.member[_e137];
                        let _e145 = (_e87 + 1u);
                        let _e146 = (_e145 < _e42);
                        if _e146 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e149 = basis.member[_e145];
                        let _e152 = (_e87 + 5u);
                        let _e153 = (_e152 < _e42);
                        if _e153 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e156 = basis.member[_e152];
                        let _e160 = (_e87 + 2u);
                        let _e161 = (_e160 < _e42);
                        if _e161 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e164 = basis.member[_e160];
                        let _e167 = (_e87 + 6u);
                        let _e168 = (_e167 < _e42);
                        if _e168 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e171 = basis.member[_e167];
                        let _e174 = (_e89 + 16u);
                        let _e175 = (_e174 < _e40);
                        if _e175 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e178 = words.member[_e174];
                        let _e187 = (bitcast<f32>((((_e178 << bitcast<u32>(16i)) & 2147483648u) | ((_e178 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e175 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e194 = (bitcast<f32>(((_e178 & 2147483648u) | ((_e178 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e131 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e138 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e146 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e153 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e161 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e168 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e210 = (_e89 + 32u);
                        let _e211 = (_e210 < _e40);
                        if _e211 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e214 = words.member[_e210];
                        let _e223 = (bitcast<f32>((((_e214 << bitcast<u32>(16i)) & 2147483648u) | ((_e214 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e211 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e230 = (bitcast<f32>(((_e214 & 2147483648u) | ((_e214 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e131 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e138 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e146 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e153 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e161 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e168 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e246 = (_e89 + 48u);
                        let _e247 = (_e246 < _e40);
                        if _e247 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e250 = words.member[_e246];
                        let _e259 = (bitcast<f32>((((_e250 << bitcast<u32>(16i)) & 2147483648u) | ((_e250 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e247 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        let _e266 = (bitcast<f32>(((_e250 & 2147483648u) | ((_e250 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e131 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e138 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e146 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e153 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e161 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        if _e168 {
                        } else {
                            phi_632_ = true;
                            break;
                        }
                        phi_138_ = (_e87 + 8u);
                        phi_140_ = (_e89 + 64u);
                        phi_142_ = array<f32, 12>(((_e91[0] + (_e122 * _e134)) + (_e129 * _e141)), ((_e91[1] + (_e122 * _e149)) + (_e129 * _e156)), ((_e91[2] + (_e122 * _e164)) + (_e129 * _e171)), ((_e91[3] + (_e187 * _e134)) + (_e194 * _e141)), ((_e91[4] + (_e187 * _e149)) + (_e194 * _e156)), ((_e91[5] + (_e187 * _e164)) + (_e194 * _e171)), ((_e91[6] + (_e223 * _e134)) + (_e230 * _e141)), ((_e91[7] + (_e223 * _e149)) + (_e230 * _e156)), ((_e91[8] + (_e223 * _e164)) + (_e230 * _e171)), ((_e91[9] + (_e259 * _e134)) + (_e266 * _e141)), ((_e91[10] + (_e259 * _e149)) + (_e266 * _e156)), ((_e91[11] + (_e259 * _e164)) + (_e266 * _e171)));
                    } else {
                        phi_138_ = u32();
                        phi_140_ = u32();
                        phi_142_ = array<f32, 12>();
                    }
                    let _e286 = phi_138_;
                    let _e288 = phi_140_;
                    let _e290 = phi_142_;
                    continue;
                    continuing {
                        phi_134_ = _e104;
                        phi_137_ = _e286;
                        phi_139_ = _e288;
                        phi_141_ = _e290;
                        phi_632_ = false;
                        break if !(_e109);
                    }
                }
                let _e293 = phi_632_;
                if _e293 {
                    break;
                }
                let _e295 = local_1;
                let _e298 = local_2;
                let _e301 = local_3;
                let _e304 = local_4;
                let _e307 = local_5;
                let _e310 = local_6;
                let _e313 = local_7;
                let _e316 = local_8;
                let _e319 = local_9;
                let _e322 = local_10;
                let _e325 = local_11;
                let _e328 = local_12;
                local = array<f32, 12>(_e295[0], _e298[1], _e301[2], _e304[3], _e307[4], _e310[5], _e313[6], _e316[7], _e319[8], _e322[9], _e325[10], _e328[11]);
                phi_576_ = type_11(0u, 12u);
                loop {
                    let _e332 = phi_576_;
                    if (_e332.member < _e332.member_1) {
                        phi_577_ = type_11((_e332.member + 1u), _e332.member_1);
                        phi_600_ = type_11(1u, _e332.member);
                    } else {
                        phi_577_ = _e332;
                        phi_600_ = type_11(0u, type_11().member_1);
                    }
                    let _e345 = phi_577_;
                    let _e347 = phi_600_;
                    let _e351 = (bitcast<i32>(_e347.member) != 0i);
                    if _e351 {
                        if (_e347.member_1 < 12u) {
                        } else {
                            phi_636_ = true;
                            break;
                        }
                        let _e354 = local[_e347.member_1];
                        let _e356 = ((_e347.member_1 * (_e51 * 16u)) + (((_e47 * 16u) + _e63) + _e64));
                        if (_e356 < arrayLength((&radiance.member))) {
                        } else {
                            phi_636_ = true;
                            break;
                        }
                        radiance.member[_e356] = _e354;
                    }
                    continue;
                    continuing {
                        phi_576_ = _e345;
                        phi_636_ = _e293;
                        break if !(_e351);
                    }
                }
                let _e362 = phi_636_;
                if _e362 {
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
