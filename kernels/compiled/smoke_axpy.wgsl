struct type_4 {
    member: u32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_5 {
    member: type_4,
}

struct type_8 {
    member: array<f32>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_5;
@group(0) @binding(1) 
var<storage> x: type_8;
@group(0) @binding(2) 
var<storage> y: type_8;
@group(0) @binding(3) 
var<storage, read_write> out: type_8;

fn function_() {
    var phi_54_: u32;

    let _e10 = gid_1;
    let _e13 = params.member.member;
    let _e14 = (_e13 / 256u);
    if ((_e13 % 256u) > 0u) {
        phi_54_ = (_e14 + 1u);
    } else {
        phi_54_ = _e14;
    }
    let _e19 = phi_54_;
    let _e23 = (_e10.x + (_e10.y * 2097152u));
    if (_e23 < (_e19 * 256u)) {
        let _e28 = params.member.member_2;
        let _e31 = x.member[_e23];
        let _e35 = y.member[_e23];
        out.member[_e23] = ((_e28 * _e31) + _e35);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn smoke_axpy(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
