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
@group(0) @binding(2) 
var<storage, read_write> out: type_7;
@group(0) @binding(0) 
var<uniform> params: type_14;
@group(0) @binding(1) 
var<storage> bits: type_7;

fn function_() {
    var phi_63_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e9 = gid_1;
            let _e17 = (_e9.x + (_e9.y * 2097152u));
            let _e18 = (_e17 < arrayLength((&out.member)));
            if _e18 {
                let _e21 = params.member.member_12;
                if (_e17 < _e21) {
                    phi_63_ = 0u;
                } else {
                    if (_e17 < arrayLength((&bits.member))) {
                    } else {
                        break;
                    }
                    let _e26 = bits.member[_e17];
                    phi_63_ = countOneBits(_e26);
                }
                let _e29 = phi_63_;
                if _e18 {
                } else {
                    break;
                }
                out.member[_e17] = _e29;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_popcount(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
