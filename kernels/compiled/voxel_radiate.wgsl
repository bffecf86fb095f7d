struct type_9 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_11 {
    member: array<type_9>,
}

struct type_17 {
    member: array<vec4<f32>>,
}

struct type_20 {
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

struct type_21 {
    member: type_20,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> facets: type_11;
@group(0) @binding(4) 
var<storage, read_write> out: type_17;
@group(0) @binding(2) 
var<storage> direct: type_17;
@group(0) @binding(0) 
var<uniform> params: type_21;
@group(0) @binding(3) 
var<storage> bounced: type_17;

fn function_() {
    var phi_127_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e19 = gid_1;
            let _e31 = (_e19.x + (_e19.y * 2097152u));
            let _e32 = (_e31 < arrayLength((&out.member)));
            if _e32 {
                let _e33 = (_e31 / 2u);
                if (_e33 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                if (_e31 < arrayLength((&direct.member))) {
                } else {
                    break;
                }
                let _e38 = direct.member[_e31];
                if (_e31 < arrayLength((&bounced.member))) {
                } else {
                    break;
                }
                let _e42 = bounced.member[_e31];
                let _e45 = params.member.member_16;
                let _e64 = facets.member[_e33].member_4;
                if ((_e31 & 1u) == 0u) {
                    let _e78 = params.member.member_9;
                    phi_127_ = _e78;
                } else {
                    phi_127_ = 0f;
                }
                let _e80 = phi_127_;
                let _e84 = facets.member[_e33].member_6;
                if _e32 {
                } else {
                    break;
                }
                out.member[_e31] = vec4<f32>((((_e64[0] * (_e38.x + (_e42.x * _e45.x))) * 0.31830987f) + (_e84[0] * _e80)), (((_e64[1] * (_e38.y + (_e42.y * _e45.y))) * 0.31830987f) + (_e84[1] * _e80)), (((_e64[2] * (_e38.z + (_e42.z * _e45.z))) * 0.31830987f) + (_e84[2] * _e80)), 0f);
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
