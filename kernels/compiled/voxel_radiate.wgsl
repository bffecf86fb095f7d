struct type_10 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_12 {
    member: array<type_10>,
}

struct type_15 {
    member: array<vec4<f32>>,
}

struct type_19 {
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
    member_16: vec4<u32>,
}

struct type_20 {
    member: type_19,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage> direct: type_15;
@group(0) @binding(0) 
var<uniform> params: type_20;
@group(0) @binding(4) 
var<storage, read_write> out: type_15;
@group(0) @binding(1) 
var<storage> facets: type_12;
@group(0) @binding(3) 
var<storage> bounced: type_15;

fn function_() {
    var phi_117_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e18 = gid_1;
            let _e30 = (_e18.x + (_e18.y * 2097152u));
            let _e31 = (_e30 < arrayLength((&out.member)));
            if _e31 {
                let _e32 = (_e30 / 2u);
                if (_e32 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                if (_e30 < arrayLength((&direct.member))) {
                } else {
                    break;
                }
                let _e37 = direct.member[_e30];
                if (_e30 < arrayLength((&bounced.member))) {
                } else {
                    break;
                }
                let _e41 = bounced.member[_e30];
                let _e54 = facets.member[_e32].member_4;
                if ((_e30 & 1u) == 0u) {
                    let _e68 = params.member.member_9;
                    phi_117_ = _e68;
                } else {
                    phi_117_ = 0f;
                }
                let _e70 = phi_117_;
                let _e74 = facets.member[_e32].member_6;
                if _e31 {
                } else {
                    break;
                }
                out.member[_e30] = vec4<f32>((((_e54[0] * (_e37.x + _e41.x)) * 0.31830987f) + (_e74[0] * _e70)), (((_e54[1] * (_e37.y + _e41.y)) * 0.31830987f) + (_e74[1] * _e70)), (((_e54[2] * (_e37.z + _e41.z)) * 0.31830987f) + (_e74[2] * _e70)), 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_radiate(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
