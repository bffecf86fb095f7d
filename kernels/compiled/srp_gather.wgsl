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
    member_4: f32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_20 {
    member: type_19,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(0) 
var<uniform> params: type_20;
@group(0) @binding(1) 
var<storage> hits: type_14;
@group(0) @binding(3) 
var<storage, read_write> light: type_5;

fn function_() {
    var local: array<f32, 3>;
    var phi_88_: u32;
    var phi_177_: u32;
    var phi_230_: type_11;
    var phi_231_: type_11;
    var phi_254_: type_11;
    var phi_284_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = gid_1;
            let _e27 = params.member.member_3;
            let _e29 = select(_e27, 16u, (_e27 == 0u));
            let _e32 = params.member.member;
            let _e33 = (_e32 / 16u);
            let _e35 = ((_e32 % 16u) > 0u);
            if _e35 {
                phi_88_ = (_e33 + 1u);
            } else {
                phi_88_ = _e33;
            }
            let _e38 = phi_88_;
            let _e39 = (_e29 == 0u);
            if _e39 {
                break;
            }
            if _e39 {
                break;
            }
            let _e44 = params.member.member_6;
            let _e45 = (((_e38 * _e29) * 16u) * _e44);
            let _e50 = (_e22.x + (_e22.y * 2097152u));
            if (_e50 < ((_e45 / 256u) * 256u)) {
                let _e55 = params.member.member_5;
                if _e35 {
                    phi_177_ = (_e33 + 1u);
                } else {
                    phi_177_ = _e33;
                }
                let _e58 = phi_177_;
                if _e39 {
                    break;
                }
                if _e39 {
                    break;
                }
                let _e65 = hits.member[((_e55 * ((_e58 * _e29) * 16u)) + _e50)];
                let _e66 = (4u * _e65);
                let _e69 = radiance.member[_e66];
                let _e73 = radiance.member[(_e66 + 1u)];
                let _e77 = radiance.member[(_e66 + 2u)];
                local = array<f32, 3>(_e69, _e73, _e77);
                phi_230_ = type_11(0u, 3u);
                loop {
                    let _e80 = phi_230_;
                    if (_e80.member < _e80.member_1) {
                        phi_231_ = type_11((_e80.member + 1u), _e80.member_1);
                        phi_254_ = type_11(1u, _e80.member);
                    } else {
                        phi_231_ = _e80;
                        phi_254_ = type_11(0u, type_11().member_1);
                    }
                    let _e93 = phi_231_;
                    let _e95 = phi_254_;
                    let _e99 = (bitcast<i32>(_e95.member) != 0i);
                    if _e99 {
                        if (_e95.member_1 < 3u) {
                        } else {
                            phi_284_ = true;
                            break;
                        }
                        let _e102 = local[_e95.member_1];
                        let _e104 = ((_e95.member_1 * _e45) + _e50);
                        if (_e104 < arrayLength((&light.member))) {
                        } else {
                            phi_284_ = true;
                            break;
                        }
                        light.member[_e104] = _e102;
                    }
                    continue;
                    continuing {
                        phi_230_ = _e93;
                        phi_284_ = false;
                        break if !(_e99);
                    }
                }
                let _e110 = phi_284_;
                if _e110 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_gather(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
