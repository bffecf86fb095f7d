struct type_10 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
    member_8: array<f32, 3>,
    member_9: f32,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct type_15 {
    member: array<type_10>,
}

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_18 {
    member: type_17,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_18;
@group(0) @binding(1) 
var<storage> surfels: type_15;
@group(0) @binding(2) 
var<storage> direct: type_12;
@group(0) @binding(3) 
var<storage> indirect: type_12;
@group(0) @binding(4) 
var<storage, read_write> radiance: type_12;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e14 = gid_1;
            let _e25 = params.member.member;
            let _e29 = (_e14.x + (_e14.y * 2097152u));
            if (_e29 < _e25) {
                let _e31 = (_e29 < arrayLength((&surfels.member)));
                if _e31 {
                } else {
                    break;
                }
                let _e35 = surfels.member[_e29].member_6;
                if (_e29 < arrayLength((&direct.member))) {
                } else {
                    break;
                }
                let _e42 = direct.member[_e29];
                if (_e29 < arrayLength((&indirect.member))) {
                } else {
                    break;
                }
                let _e46 = indirect.member[_e29];
                if _e31 {
                } else {
                    break;
                }
                let _e59 = surfels.member[_e29].member_8;
                if (_e29 < arrayLength((&radiance.member))) {
                } else {
                    break;
                }
                radiance.member[_e29] = vec4<f32>((_e59[0] + ((_e35[0] * (_e42.x + _e46.x)) * 0.31830987f)), (_e59[1] + ((_e35[1] * (_e42.y + _e46.y)) * 0.31830987f)), (_e59[2] + ((_e35[2] * (_e42.z + _e46.z)) * 0.31830987f)), 1f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_compose(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
