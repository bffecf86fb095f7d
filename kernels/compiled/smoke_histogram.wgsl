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

struct type_15 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_5;
@group(0) @binding(1) 
var<storage> values: type_10;
@group(0) @binding(2) 
var<storage, read_write> bins: type_15;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e10 = gid_1;
            let _e18 = (_e10.x + (_e10.y * 2097152u));
            let _e21 = params.member.member;
            if (_e18 < _e21) {
                if (_e18 < arrayLength((&values.member))) {
                } else {
                    break;
                }
                let _e26 = values.member[_e18];
                let _e29 = params.member.member_1;
                let _e31 = ((_e26 ^ _e29) % 4096u);
                if (_e31 < arrayLength((&bins.member))) {
                } else {
                    break;
                }
                let _e35 = atomicAdd((&bins.member[_e31]), 1u);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn smoke_histogram(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
