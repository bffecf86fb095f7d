struct type_7 {
    member: array<u32>,
}

struct type_13 {
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

struct type_14 {
    member: type_13,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_14;
@group(0) @binding(1) 
var<storage> even_bits: type_7;
@group(0) @binding(2) 
var<storage> odd_bits: type_7;
@group(0) @binding(3) 
var<storage> facet_ranks: type_7;
@group(0) @binding(4) 
var<storage> even_ranks: type_7;
@group(0) @binding(5) 
var<storage> odd_ranks: type_7;
@group(0) @binding(6) 
var<storage, read_write> out: type_7;

fn function_() {
    var phi_117_: u32;
    var phi_125_: u32;
    var phi_92_: u32;
    var phi_126_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e15 = gid_1;
            let _e31 = (_e15.x + (_e15.y * 2097152u));
            let _e32 = (_e31 < arrayLength((&out.member)));
            if _e32 {
                let _e33 = (_e31 / 2u);
                let _e35 = ((_e31 & 1u) == 1u);
                let _e38 = params.member.member_10;
                if (_e33 >= _e38) {
                    let _e62 = (_e33 - _e38);
                    if _e35 {
                        if (_e62 < arrayLength((&odd_ranks.member))) {
                        } else {
                            break;
                        }
                        let _e70 = odd_ranks.member[_e62];
                        phi_92_ = _e70;
                    } else {
                        if (_e62 < arrayLength((&odd_bits.member))) {
                        } else {
                            break;
                        }
                        let _e66 = odd_bits.member[_e62];
                        phi_92_ = _e66;
                    }
                    let _e72 = phi_92_;
                    phi_126_ = _e72;
                } else {
                    if _e35 {
                        let _e48 = params.member.member_2[0u][3u];
                        if (_e33 < _e48) {
                            if (_e33 < arrayLength((&facet_ranks.member))) {
                            } else {
                                break;
                            }
                            let _e57 = facet_ranks.member[_e33];
                            phi_117_ = _e57;
                        } else {
                            if (_e33 < arrayLength((&even_ranks.member))) {
                            } else {
                                break;
                            }
                            let _e53 = even_ranks.member[_e33];
                            phi_117_ = _e53;
                        }
                        let _e59 = phi_117_;
                        phi_125_ = _e59;
                    } else {
                        if (_e33 < arrayLength((&even_bits.member))) {
                        } else {
                            break;
                        }
                        let _e43 = even_bits.member[_e33];
                        phi_125_ = _e43;
                    }
                    let _e61 = phi_125_;
                    phi_126_ = _e61;
                }
                let _e74 = phi_126_;
                if _e32 {
                } else {
                    break;
                }
                out.member[_e31] = _e74;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_cells(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
