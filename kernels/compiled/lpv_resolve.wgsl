struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_19 {
    member: vec4<f32>,
    member_1: vec4<i32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
    member_4: vec4<f32>,
    member_5: u32,
    member_6: f32,
    member_7: f32,
    member_8: f32,
    member_9: f32,
    member_10: f32,
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: f32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: vec4<f32>,
}

struct type_20 {
    member: type_19,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_20;
@group(0) @binding(1) 
var<storage> words: type_12;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e13 = gid_1;
            let _e21 = (_e13.x + (_e13.y * 2097152u));
            let _e22 = (_e21 < arrayLength((&out.member)));
            if _e22 {
                let _e25 = params.member.member_17;
                let _e29 = params.member.member_2;
                let _e31 = (_e29.x + 1u);
                let _e34 = ((_e29.y + 1u) * _e31);
                let _e42 = (((_e25 * 4u) * (3u * ((_e34 + _e31) + ((_e29.z + 1u) * _e34)))) + _e21);
                if (_e42 < arrayLength((&words.member))) {
                } else {
                    break;
                }
                let _e46 = words.member[_e42];
                let _e51 = params.member.member_7;
                if _e22 {
                } else {
                    break;
                }
                out.member[_e21] = (f32(bitcast<i32>(_e46)) / _e51);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_resolve(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
