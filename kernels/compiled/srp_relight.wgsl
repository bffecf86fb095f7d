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

struct type_19 {
    member: array<vec4<f32>>,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_5;
@group(0) @binding(1) 
var<storage> direct: type_19;
@group(0) @binding(2) 
var<storage> indirect: type_8;
@group(0) @binding(3) 
var<storage> surfaces: type_23;
@group(0) @binding(4) 
var<storage> special: type_19;
@group(0) @binding(5) 
var<storage, read_write> radiance: type_19;

fn function_() {
    var phi_186_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e15 = gid_1;
            let _e19 = arrayLength((&indirect.member));
            let _e28 = params.member.member;
            let _e31 = params.member.member_1;
            let _e36 = (_e15.x + (_e15.y * 2097152u));
            if (_e36 < (_e28 + _e31)) {
                if (_e36 >= _e28) {
                    let _e101 = (_e36 - _e28);
                    if (_e101 < arrayLength((&special.member))) {
                    } else {
                        break;
                    }
                    let _e105 = special.member[_e101];
                    phi_186_ = _e105;
                } else {
                    if (_e36 < arrayLength((&direct.member))) {
                    } else {
                        break;
                    }
                    let _e43 = direct.member[_e36][0u];
                    let _e47 = direct.member[_e36][1u];
                    let _e51 = direct.member[_e36][2u];
                    if (_e36 < arrayLength((&surfaces.member))) {
                    } else {
                        break;
                    }
                    let _e56 = surfaces.member[_e36].member;
                    let _e60 = surfaces.member[_e36].member_2;
                    let _e63 = params.member.member_2;
                    if (_e36 < _e19) {
                    } else {
                        break;
                    }
                    let _e67 = indirect.member[_e36];
                    let _e70 = (_e28 + _e36);
                    if (_e70 < _e19) {
                    } else {
                        break;
                    }
                    let _e74 = indirect.member[_e70];
                    let _e78 = ((2u * _e28) + _e36);
                    if (_e78 < _e19) {
                    } else {
                        break;
                    }
                    let _e82 = indirect.member[_e78];
                    phi_186_ = vec4<f32>(((((_e43 + (_e63 * _e67)) * _e56[0]) * 0.31830987f) + _e60[0]), ((((_e47 + (_e63 * _e74)) * _e56[1]) * 0.31830987f) + _e60[1]), ((((_e51 + (_e63 * _e82)) * _e56[2]) * 0.31830987f) + _e60[2]), 0f);
                }
                let _e107 = phi_186_;
                if (_e36 < arrayLength((&radiance.member))) {
                } else {
                    break;
                }
                radiance.member[_e36] = _e107;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_relight(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
