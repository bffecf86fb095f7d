struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: array<u32>,
}

struct type_18 {
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
    member_17: vec4<f32>,
}

struct type_19 {
    member: type_18,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_19;
@group(0) @binding(1) 
var<storage> words: type_12;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e8 = gid_1;
            let _e16 = (_e8.x + (_e8.y * 2097152u));
            let _e17 = (_e16 < arrayLength((&out.member)));
            if _e17 {
                if (_e16 < arrayLength((&words.member))) {
                } else {
                    break;
                }
                let _e21 = words.member[_e16];
                let _e26 = params.member.member_7;
                if _e17 {
                } else {
                    break;
                }
                out.member[_e16] = (f32(bitcast<i32>(_e21)) / _e26);
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
