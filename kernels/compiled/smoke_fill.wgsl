struct type_4 {
    member: u32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_5 {
    member: type_4,
}

struct type_10 {
    member: array<u32>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_5;
@group(0) @binding(1) 
var<storage, read_write> out: type_10;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e8 = gid_1;
            let _e14 = (_e8.x + (_e8.y * 2097152u));
            let _e15 = (_e14 < arrayLength((&out.member)));
            if _e15 {
                let _e19 = params.member.member_1;
                if _e15 {
                } else {
                    break;
                }
                out.member[_e14] = ((_e14 * 747796405u) ^ _e19);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn smoke_fill(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
