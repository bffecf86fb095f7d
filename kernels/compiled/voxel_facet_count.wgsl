struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_7 {
    member: array<u32>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_7;
@group(0) @binding(1) 
var<storage> facet_bits: type_7;

fn function_() {
    var phi_46_: type_4;
    var phi_49_: u32;
    var phi_47_: type_4;
    var phi_72_: type_4;
    var phi_50_: u32;
    var phi_113_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e14 = gid_1;
            let _e22 = (_e14.x + (_e14.y * 2097152u));
            let _e23 = (_e22 < arrayLength((&out.member)));
            if _e23 {
                phi_46_ = type_4(0u, 6u);
                phi_49_ = 0u;
                loop {
                    let _e26 = phi_46_;
                    let _e28 = phi_49_;
                    local = _e28;
                    if (_e26.member < _e26.member_1) {
                        phi_47_ = type_4((_e26.member + 1u), _e26.member_1);
                        phi_72_ = type_4(1u, _e26.member);
                    } else {
                        phi_47_ = _e26;
                        phi_72_ = type_4(0u, type_4().member_1);
                    }
                    let _e41 = phi_47_;
                    let _e43 = phi_72_;
                    let _e47 = (bitcast<i32>(_e43.member) != 0i);
                    if _e47 {
                        let _e48 = ((_e22 * 6u) + _e43.member_1);
                        if (_e48 < arrayLength((&facet_bits.member))) {
                        } else {
                            phi_113_ = true;
                            break;
                        }
                        let _e52 = facet_bits.member[_e48];
                        phi_50_ = (_e28 + countOneBits(_e52));
                    } else {
                        phi_50_ = u32();
                    }
                    let _e56 = phi_50_;
                    continue;
                    continuing {
                        phi_46_ = _e41;
                        phi_49_ = _e56;
                        phi_113_ = false;
                        break if !(_e47);
                    }
                }
                let _e59 = phi_113_;
                if _e59 {
                    break;
                }
                if _e23 {
                } else {
                    break;
                }
                let _e63 = local;
                out.member[_e22] = _e63;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_facet_count(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
