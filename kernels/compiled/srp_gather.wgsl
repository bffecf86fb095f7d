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
    var phi_90_: u32;
    var phi_179_: u32;
    var phi_252_: type_11;
    var phi_253_: type_11;
    var phi_276_: type_11;
    var phi_306_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = gid_1;
            let _e26 = arrayLength((&radiance.member));
            let _e31 = params.member.member_3;
            let _e33 = select(_e31, 16u, (_e31 == 0u));
            let _e36 = params.member.member;
            let _e37 = (_e36 / 16u);
            let _e39 = ((_e36 % 16u) > 0u);
            if _e39 {
                phi_90_ = (_e37 + 1u);
            } else {
                phi_90_ = _e37;
            }
            let _e42 = phi_90_;
            let _e43 = (_e33 == 0u);
            if _e43 {
                break;
            }
            if _e43 {
                break;
            }
            let _e48 = params.member.member_6;
            let _e49 = (((_e42 * _e33) * 16u) * _e48);
            let _e54 = (_e22.x + (_e22.y * 2097152u));
            if (_e54 < ((_e49 / 256u) * 256u)) {
                let _e59 = params.member.member_5;
                if _e39 {
                    phi_179_ = (_e37 + 1u);
                } else {
                    phi_179_ = _e37;
                }
                let _e62 = phi_179_;
                if _e43 {
                    break;
                }
                if _e43 {
                    break;
                }
                let _e66 = ((_e59 * ((_e62 * _e33) * 16u)) + _e54);
                if (_e66 < arrayLength((&hits.member))) {
                } else {
                    break;
                }
                let _e70 = hits.member[_e66];
                let _e71 = (4u * _e70);
                if (_e71 < _e26) {
                } else {
                    break;
                }
                let _e75 = radiance.member[_e71];
                let _e76 = (_e71 + 1u);
                if (_e76 < _e26) {
                } else {
                    break;
                }
                let _e80 = radiance.member[_e76];
                let _e81 = (_e71 + 2u);
                if (_e81 < _e26) {
                } else {
                    break;
                }
                let _e85 = radiance.member[_e81];
                local = array<f32, 3>(_e75, _e80, _e85);
                phi_252_ = type_11(0u, 3u);
                loop {
                    let _e88 = phi_252_;
                    if (_e88.member < _e88.member_1) {
                        phi_253_ = type_11((_e88.member + 1u), _e88.member_1);
                        phi_276_ = type_11(1u, _e88.member);
                    } else {
                        phi_253_ = _e88;
                        phi_276_ = type_11(0u, type_11().member_1);
                    }
                    let _e101 = phi_253_;
                    let _e103 = phi_276_;
                    let _e107 = (bitcast<i32>(_e103.member) != 0i);
                    if _e107 {
                        if (_e103.member_1 < 3u) {
                        } else {
                            phi_306_ = true;
                            break;
                        }
                        let _e110 = local[_e103.member_1];
                        let _e112 = ((_e103.member_1 * _e49) + _e54);
                        if (_e112 < arrayLength((&light.member))) {
                        } else {
                            phi_306_ = true;
                            break;
                        }
                        light.member[_e112] = _e110;
                    }
                    continue;
                    continuing {
                        phi_252_ = _e101;
                        phi_306_ = false;
                        break if !(_e107);
                    }
                }
                let _e118 = phi_306_;
                if _e118 {
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
