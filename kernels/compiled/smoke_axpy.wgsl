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
var<storage> y: type_8;
@group(0) @binding(3) 
var<storage, read_write> out: type_8;

fn function_() {
    var local: array<f32, 1>;
    var phi_64_: u32;
    var phi_82_: u32;
    var phi_115_: type_17;
    var phi_116_: type_17;
    var phi_139_: type_17;
    var phi_169_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e17 = gid_1;
            let _e22 = params.member.member;
            let _e23 = (_e22 / 256u);
            let _e25 = ((_e22 % 256u) > 0u);
            if _e25 {
                phi_64_ = (_e23 + 1u);
            } else {
                phi_64_ = _e23;
            }
            let _e28 = phi_64_;
            if _e25 {
                phi_82_ = (_e23 + 1u);
            } else {
                phi_82_ = _e23;
            }
            let _e31 = phi_82_;
            let _e36 = (_e17.x + (_e17.y * 2097152u));
            if (_e36 < (_e28 * 256u)) {
                let _e41 = params.member.member_2;
                let _e44 = x.member[_e36];
                let _e48 = y.member[_e36];
                local[0u] = ((_e41 * _e44) + _e48);
                phi_115_ = type_17(0u, 1u);
                loop {
                    let _e52 = phi_115_;
                    if (_e52.member < _e52.member_1) {
                        phi_116_ = type_17((_e52.member + 1u), _e52.member_1);
                        phi_139_ = type_17(1u, _e52.member);
                    } else {
                        phi_116_ = _e52;
                        phi_139_ = type_17(0u, type_17().member_1);
                    }
                    let _e65 = phi_116_;
                    let _e67 = phi_139_;
                    let _e71 = (bitcast<i32>(_e67.member) != 0i);
                    if _e71 {
                        if (_e67.member_1 < 1u) {
                        } else {
                            phi_169_ = true;
                            break;
                        }
                        let _e74 = local[_e67.member_1];
                        let _e76 = ((_e67.member_1 * (_e31 * 256u)) + _e36);
                        if (_e76 < arrayLength((&out.member))) {
                        } else {
                            phi_169_ = true;
                            break;
                        }
                        out.member[_e76] = _e74;
                    }
                    continue;
                    continuing {
                        phi_115_ = _e65;
                        phi_169_ = false;
                        break if !(_e71);
                    }
                }
                let _e82 = phi_169_;
                if _e82 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn smoke_axpy(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
