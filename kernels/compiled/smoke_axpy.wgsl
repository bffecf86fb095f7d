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
    var phi_66_: u32;
    var phi_84_: u32;
    var phi_127_: type_17;
    var phi_128_: type_17;
    var phi_151_: type_17;
    var phi_181_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e17 = gid_1;
            let _e26 = params.member.member;
            let _e27 = (_e26 / 256u);
            let _e29 = ((_e26 % 256u) > 0u);
            if _e29 {
                phi_66_ = (_e27 + 1u);
            } else {
                phi_66_ = _e27;
            }
            let _e32 = phi_66_;
            if _e29 {
                phi_84_ = (_e27 + 1u);
            } else {
                phi_84_ = _e27;
            }
            let _e35 = phi_84_;
            let _e40 = (_e17.x + (_e17.y * 2097152u));
            if (_e40 < (_e32 * 256u)) {
                let _e45 = params.member.member_2;
                if (_e40 < arrayLength((&x.member))) {
                } else {
                    break;
                }
                let _e49 = x.member[_e40];
                if (_e40 < arrayLength((&y.member))) {
                } else {
                    break;
                }
                let _e54 = y.member[_e40];
                local[0u] = ((_e45 * _e49) + _e54);
                phi_127_ = type_17(0u, 1u);
                loop {
                    let _e58 = phi_127_;
                    if (_e58.member < _e58.member_1) {
                        phi_128_ = type_17((_e58.member + 1u), _e58.member_1);
                        phi_151_ = type_17(1u, _e58.member);
                    } else {
                        phi_128_ = _e58;
                        phi_151_ = type_17(0u, type_17().member_1);
                    }
                    let _e71 = phi_128_;
                    let _e73 = phi_151_;
                    let _e77 = (bitcast<i32>(_e73.member) != 0i);
                    if _e77 {
                        if (_e73.member_1 < 1u) {
                        } else {
                            phi_181_ = true;
                            break;
                        }
                        let _e80 = local[_e73.member_1];
                        let _e82 = ((_e73.member_1 * (_e35 * 256u)) + _e40);
                        if (_e82 < arrayLength((&out.member))) {
                        } else {
                            phi_181_ = true;
                            break;
                        }
                        out.member[_e82] = _e80;
                    }
                    continue;
                    continuing {
                        phi_127_ = _e71;
                        phi_181_ = false;
                        break if !(_e77);
                    }
                }
                let _e88 = phi_181_;
                if _e88 {
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
