struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_18 {
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

struct type_19 {
    member: type_18,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> coefs: type_5;
@group(0) @binding(0) 
var<uniform> params: type_19;
@group(0) @binding(2) 
var<storage, read_write> out: type_11;

fn function_() {
    var phi_169_: u32;
    var phi_170_: u32;
    var phi_171_: u32;
    var phi_172_: u32;
    var phi_227_: u32;
    var phi_228_: u32;
    var phi_229_: u32;
    var phi_230_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = gid_1;
            let _e33 = arrayLength((&coefs.member));
            let _e39 = (_e31.x + (_e31.y * 2097152u));
            let _e40 = (_e39 < arrayLength((&out.member)));
            if _e40 {
                let _e43 = params.member.member_2;
                let _e45 = (_e43.x + 1u);
                let _e48 = ((_e43.y + 1u) * _e45);
                let _e54 = (3u * ((_e48 + _e45) + ((_e43.z + 1u) * _e48)));
                if (_e54 == 0u) {
                    break;
                }
                let _e58 = (_e39 + ((_e39 / _e54) * _e54));
                if (_e58 < _e33) {
                } else {
                    break;
                }
                let _e62 = coefs.member[_e58];
                let _e65 = params.member.member_14;
                let _e67 = (_e58 + _e54);
                if (_e67 < _e33) {
                } else {
                    break;
                }
                let _e71 = coefs.member[_e67];
                let _e73 = bitcast<u32>((_e62 * _e65));
                let _e76 = ((_e73 >> bitcast<u32>(16i)) & 32768u);
                let _e77 = (_e73 & 2147483647u);
                if (_e77 > 2139095040u) {
                    phi_172_ = ((_e76 | 32256u) | ((_e77 >> bitcast<u32>(13i)) & 1023u));
                } else {
                    if (_e77 >= 1199566848u) {
                        phi_171_ = (_e76 | 31744u);
                    } else {
                        if (_e77 >= 947912704u) {
                            phi_170_ = (_e76 | (((_e77 + 3355447295u) + (((_e77 - 939524096u) >> bitcast<u32>(13u)) & 1u)) >> bitcast<u32>(13u)));
                        } else {
                            if (_e77 >= 855638016u) {
                                let _e83 = ((_e77 & 8388607u) | 8388608u);
                                let _e85 = (_e77 >> bitcast<u32>(23i));
                                let _e93 = ((126u - _e85) & 31u);
                                phi_169_ = (_e76 | (((_e83 + ((1u << bitcast<u32>(((125u - _e85) & 31u))) - 1u)) + ((_e83 >> bitcast<u32>(_e93)) & 1u)) >> bitcast<u32>(_e93)));
                            } else {
                                phi_169_ = _e76;
                            }
                            let _e102 = phi_169_;
                            phi_170_ = _e102;
                        }
                        let _e113 = phi_170_;
                        phi_171_ = _e113;
                    }
                    let _e116 = phi_171_;
                    phi_172_ = _e116;
                }
                let _e123 = phi_172_;
                let _e124 = bitcast<u32>((_e71 * _e65));
                let _e127 = ((_e124 >> bitcast<u32>(16i)) & 32768u);
                let _e128 = (_e124 & 2147483647u);
                if (_e128 > 2139095040u) {
                    phi_230_ = ((_e127 | 32256u) | ((_e128 >> bitcast<u32>(13i)) & 1023u));
                } else {
                    if (_e128 >= 1199566848u) {
                        phi_229_ = (_e127 | 31744u);
                    } else {
                        if (_e128 >= 947912704u) {
                            phi_228_ = (_e127 | (((_e128 + 3355447295u) + (((_e128 - 939524096u) >> bitcast<u32>(13u)) & 1u)) >> bitcast<u32>(13u)));
                        } else {
                            if (_e128 >= 855638016u) {
                                let _e134 = ((_e128 & 8388607u) | 8388608u);
                                let _e136 = (_e128 >> bitcast<u32>(23i));
                                let _e144 = ((126u - _e136) & 31u);
                                phi_227_ = (_e127 | (((_e134 + ((1u << bitcast<u32>(((125u - _e136) & 31u))) - 1u)) + ((_e134 >> bitcast<u32>(_e144)) & 1u)) >> bitcast<u32>(_e144)));
                            } else {
                                phi_227_ = _e127;
                            }
                            let _e153 = phi_227_;
                            phi_228_ = _e153;
                        }
                        let _e164 = phi_228_;
                        phi_229_ = _e164;
                    }
                    let _e167 = phi_229_;
                    phi_230_ = _e167;
                }
                let _e174 = phi_230_;
                if _e40 {
                } else {
                    break;
                }
                out.member[_e39] = (_e123 | (_e174 << bitcast<u32>(16i)));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_pack(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
