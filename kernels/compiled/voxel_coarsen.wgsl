struct type_7 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_16 {
    member: vec4<f32>,
    member_1: vec4<u32>,
    member_2: array<vec4<u32>, 10>,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: f32,
    member_8: f32,
    member_9: f32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: vec4<f32>,
    member_16: vec4<f32>,
    member_17: vec4<u32>,
}

struct type_17 {
    member: type_16,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_7;
@group(0) @binding(0) 
var<uniform> params: type_17;
@group(0) @binding(1) 
var<storage> finer: type_7;

fn function_() {
    var phi_94_: u32;
    var phi_155_: type_10;
    var phi_158_: u32;
    var phi_156_: type_10;
    var phi_181_: type_10;
    var phi_258_: u32;
    var phi_259_: u32;
    var phi_260_: u32;
    var phi_159_: u32;
    var phi_284_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = gid_1;
            let _e36 = params.member.member_12;
            let _e39 = params.member.member_13;
            let _e43 = (_e29.x + (_e29.y * 2097152u));
            if (_e43 < _e39) {
                let _e47 = params.member.member_11;
                let _e51 = params.member.member_2[_e47];
                let _e52 = (_e47 - 1u);
                let _e56 = params.member.member_2[_e52];
                if ((_e47 & 1u) == 1u) {
                    phi_94_ = 0u;
                } else {
                    let _e61 = params.member.member_10;
                    phi_94_ = _e61;
                }
                let _e63 = phi_94_;
                if (_e51.y == 0u) {
                    break;
                }
                let _e66 = (_e43 / _e51.y);
                let _e68 = (_e43 - (_e66 * _e51.y));
                if (_e51.x == 0u) {
                    break;
                }
                let _e71 = (_e68 / _e51.x);
                let _e82 = (_e52 & 31u);
                let _e85 = ((1u << bitcast<u32>(_e82)) - 1u);
                let _e88 = params.member.member_1;
                phi_155_ = type_10(0u, 8u);
                phi_158_ = 0u;
                loop {
                    let _e102 = phi_155_;
                    let _e104 = phi_158_;
                    local = _e104;
                    if (_e102.member < _e102.member_1) {
                        phi_156_ = type_10((_e102.member + 1u), _e102.member_1);
                        phi_181_ = type_10(1u, _e102.member);
                    } else {
                        phi_156_ = _e102;
                        phi_181_ = type_10(0u, type_10().member_1);
                    }
                    let _e117 = phi_156_;
                    let _e119 = phi_181_;
                    let _e123 = (bitcast<i32>(_e119.member) != 0i);
                    if _e123 {
                        let _e124 = (_e119.member_1 & 1u);
                        let _e127 = ((_e119.member_1 >> bitcast<u32>(1i)) & 1u);
                        let _e129 = (_e119.member_1 >> bitcast<u32>(2i));
                        let _e131 = ((((_e68 - (_e71 * _e51.x)) << bitcast<u32>(2i)) * 2u) + (_e124 * 4u));
                        let _e133 = (((_e71 << bitcast<u32>(2i)) * 2u) + (_e127 * 4u));
                        let _e135 = (2u * ((_e66 << bitcast<u32>(1i)) + _e129));
                        if (_e131 < ((_e88.x + _e85) >> bitcast<u32>(_e82))) {
                            if (_e133 < ((_e88.y + _e85) >> bitcast<u32>(_e82))) {
                                if (_e135 < ((_e88.z + _e85) >> bitcast<u32>(_e82))) {
                                    let _e153 = ((((_e56.z + (_e131 >> bitcast<u32>(2i))) + (_e56.x * (_e133 >> bitcast<u32>(2i)))) + (_e56.y * (_e135 >> bitcast<u32>(1i)))) - _e63);
                                    if (_e153 < arrayLength((&finer.member))) {
                                    } else {
                                        phi_284_ = true;
                                        break;
                                    }
                                    let _e157 = finer.member[_e153];
                                    phi_258_ = (_e104 | ((((select(0u, 1u, ((_e157 & 255u) != 0u)) | (select(0u, 1u, (((_e157 >> bitcast<u32>(8i)) & 255u) != 0u)) << bitcast<u32>(1i))) | (select(0u, 1u, (((_e157 >> bitcast<u32>(16i)) & 255u) != 0u)) << bitcast<u32>(2i))) | (select(0u, 1u, ((_e157 >> bitcast<u32>(24i)) != 0u)) << bitcast<u32>(3i))) << bitcast<u32>((((8u * (_e124 + (2u * _e127))) + (4u * _e129)) & 31u))));
                                } else {
                                    phi_258_ = _e104;
                                }
                                let _e194 = phi_258_;
                                phi_259_ = _e194;
                            } else {
                                phi_259_ = _e104;
                            }
                            let _e196 = phi_259_;
                            phi_260_ = _e196;
                        } else {
                            phi_260_ = _e104;
                        }
                        let _e198 = phi_260_;
                        phi_159_ = _e198;
                    } else {
                        phi_159_ = u32();
                    }
                    let _e200 = phi_159_;
                    continue;
                    continuing {
                        phi_155_ = _e117;
                        phi_158_ = _e200;
                        phi_284_ = false;
                        break if !(_e123);
                    }
                }
                let _e203 = phi_284_;
                if _e203 {
                    break;
                }
                let _e206 = ((_e36 + _e43) + (_e43 - _e43));
                if (_e206 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                let _e211 = local;
                out.member[_e206] = _e211;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_coarsen(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
