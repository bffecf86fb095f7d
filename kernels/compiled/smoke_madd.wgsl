struct type_4 {
    member: u32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_5 {
    member: type_4,
}

struct type_8 {
    member: array<f32>,
}

struct type_17 {
    member: u32,
    member_1: u32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_5;
@group(0) @binding(1) 
var<storage> x: type_8;
@group(0) @binding(2) 
var<storage, read_write> out: type_8;

fn function_() {
    var local: array<f32, 1>;
    var phi_76_: u32;
    var phi_94_: u32;
    var phi_152_: type_17;
    var phi_155_: array<f32, 12>;
    var phi_153_: type_17;
    var phi_178_: type_17;
    var phi_156_: array<f32, 12>;
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
    var phi_260_: type_17;
    var phi_261_: type_17;
    var phi_284_: type_17;
    var phi_314_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = gid_1;
            let _e38 = params.member.member;
            let _e39 = (_e38 / 256u);
            let _e41 = ((_e38 % 256u) > 0u);
            if _e41 {
                phi_76_ = (_e39 + 1u);
            } else {
                phi_76_ = _e39;
            }
            let _e44 = phi_76_;
            if _e41 {
                phi_94_ = (_e39 + 1u);
            } else {
                phi_94_ = _e39;
            }
            let _e47 = phi_94_;
            let _e52 = (_e31.x + (_e31.y * 2097152u));
            if (_e52 < (_e44 * 256u)) {
                if (_e52 < arrayLength((&x.member))) {
                } else {
                    break;
                }
                let _e58 = x.member[_e52];
                let _e61 = params.member.member_2;
                phi_152_ = type_17(0u, 64u);
                phi_155_ = array<f32, 12>(0f, _e58, (_e58 * 2f), (_e58 * 3f), (_e58 * 4f), (_e58 * 5f), (_e58 * 6f), (_e58 * 7f), (_e58 * 8f), (_e58 * 9f), (_e58 * 10f), (_e58 * 11f));
                loop {
                    let _e74 = phi_152_;
                    let _e76 = phi_155_;
                    local_1 = _e76;
                    local_2 = _e76;
                    local_3 = _e76;
                    local_4 = _e76;
                    local_5 = _e76;
                    local_6 = _e76;
                    local_7 = _e76;
                    local_8 = _e76;
                    local_9 = _e76;
                    local_10 = _e76;
                    local_11 = _e76;
                    local_12 = _e76;
                    if (_e74.member < _e74.member_1) {
                        phi_153_ = type_17((_e74.member + 1u), _e74.member_1);
                        phi_178_ = type_17(1u, _e74.member);
                    } else {
                        phi_153_ = _e74;
                        phi_178_ = type_17(0u, type_17().member_1);
                    }
                    let _e89 = phi_153_;
                    let _e91 = phi_178_;
                    let _e94 = (bitcast<i32>(_e91.member) != 0i);
                    if _e94 {
                        phi_156_ = array<f32, 12>(((_e76[0] * _e61) + _e58), ((_e76[1] * _e61) + _e58), ((_e76[2] * _e61) + _e58), ((_e76[3] * _e61) + _e58), ((_e76[4] * _e61) + _e58), ((_e76[5] * _e61) + _e58), ((_e76[6] * _e61) + _e58), ((_e76[7] * _e61) + _e58), ((_e76[8] * _e61) + _e58), ((_e76[9] * _e61) + _e58), ((_e76[10] * _e61) + _e58), ((_e76[11] * _e61) + _e58));
                    } else {
                        phi_156_ = array<f32, 12>();
                    }
                    let _e133 = phi_156_;
                    continue;
                    continuing {
                        phi_152_ = _e89;
                        phi_155_ = _e133;
                        break if !(_e94);
                    }
                }
                let _e136 = local_1;
                let _e139 = local_2;
                let _e143 = local_3;
                let _e147 = local_4;
                let _e151 = local_5;
                let _e155 = local_6;
                let _e159 = local_7;
                let _e163 = local_8;
                let _e167 = local_9;
                let _e171 = local_10;
                let _e175 = local_11;
                let _e179 = local_12;
                local[0u] = (((((((((((_e136[0] + _e139[1]) + _e143[2]) + _e147[3]) + _e151[4]) + _e155[5]) + _e159[6]) + _e163[7]) + _e167[8]) + _e171[9]) + _e175[10]) + _e179[11]);
                phi_260_ = type_17(0u, 1u);
                loop {
                    let _e184 = phi_260_;
                    if (_e184.member < _e184.member_1) {
                        phi_261_ = type_17((_e184.member + 1u), _e184.member_1);
                        phi_284_ = type_17(1u, _e184.member);
                    } else {
                        phi_261_ = _e184;
                        phi_284_ = type_17(0u, type_17().member_1);
                    }
                    let _e197 = phi_261_;
                    let _e199 = phi_284_;
                    let _e203 = (bitcast<i32>(_e199.member) != 0i);
                    if _e203 {
                        if (_e199.member_1 < 1u) {
                        } else {
                            phi_314_ = true;
                            break;
                        }
                        let _e206 = local[_e199.member_1];
                        let _e208 = ((_e199.member_1 * (_e47 * 256u)) + _e52);
                        if (_e208 < arrayLength((&out.member))) {
                        } else {
                            phi_314_ = true;
                            break;
                        }
                        out.member[_e208] = _e206;
                    }
                    continue;
                    continuing {
                        phi_260_ = _e197;
                        phi_314_ = false;
                        break if !(_e203);
                    }
                }
                let _e214 = phi_314_;
                if _e214 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn smoke_madd(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
