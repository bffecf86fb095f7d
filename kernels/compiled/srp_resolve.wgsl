struct type_5 {
    member: array<f32>,
}

struct type_15 {
    member: array<vec4<f32>>,
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

struct type_20 {
    member: array<u32, 4>,
    member_1: array<f32, 4>,
}

struct type_22 {
    member: array<type_20>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_18;
@group(0) @binding(1) 
var<storage> blends: type_22;
@group(0) @binding(2) 
var<storage> irradiance: type_5;
@group(0) @binding(3) 
var<storage, read_write> points: type_15;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e12 = gid_1;
            let _e16 = arrayLength((&irradiance.member));
            let _e21 = params.member.member;
            let _e25 = (_e12.x + (_e12.y * 2097152u));
            if (_e25 < _e21) {
                if (_e25 < arrayLength((&blends.member))) {
                } else {
                    break;
                }
                let _e30 = blends.member[_e25];
                let _e33 = params.member.member_1;
                if (_e30.member[0] < _e16) {
                } else {
                    break;
                }
                let _e41 = irradiance.member[_e30.member[0]];
                let _e42 = (_e33 + _e30.member[0]);
                if (_e42 < _e16) {
                } else {
                    break;
                }
                let _e46 = irradiance.member[_e42];
                let _e47 = (2u * _e33);
                let _e48 = (_e47 + _e30.member[0]);
                if (_e48 < _e16) {
                } else {
                    break;
                }
                let _e52 = irradiance.member[_e48];
                if (_e30.member[1] < _e16) {
                } else {
                    break;
                }
                let _e63 = irradiance.member[_e30.member[1]];
                let _e64 = (_e33 + _e30.member[1]);
                if (_e64 < _e16) {
                } else {
                    break;
                }
                let _e68 = irradiance.member[_e64];
                let _e69 = (_e47 + _e30.member[1]);
                if (_e69 < _e16) {
                } else {
                    break;
                }
                let _e73 = irradiance.member[_e69];
                if (_e30.member[2] < _e16) {
                } else {
                    break;
                }
                let _e87 = irradiance.member[_e30.member[2]];
                let _e88 = (_e33 + _e30.member[2]);
                if (_e88 < _e16) {
                } else {
                    break;
                }
                let _e92 = irradiance.member[_e88];
                let _e93 = (_e47 + _e30.member[2]);
                if (_e93 < _e16) {
                } else {
                    break;
                }
                let _e97 = irradiance.member[_e93];
                if (_e30.member[3] < _e16) {
                } else {
                    break;
                }
                let _e111 = irradiance.member[_e30.member[3]];
                let _e112 = (_e33 + _e30.member[3]);
                if (_e112 < _e16) {
                } else {
                    break;
                }
                let _e116 = irradiance.member[_e112];
                let _e117 = (_e47 + _e30.member[3]);
                if (_e117 < _e16) {
                } else {
                    break;
                }
                let _e121 = irradiance.member[_e117];
                if (_e25 < arrayLength((&points.member))) {
                } else {
                    break;
                }
                points.member[_e25] = vec4<f32>(((((_e30.member_1[0] * _e41) + (_e30.member_1[1] * _e63)) + (_e30.member_1[2] * _e87)) + (_e30.member_1[3] * _e111)), ((((_e30.member_1[0] * _e46) + (_e30.member_1[1] * _e68)) + (_e30.member_1[2] * _e92)) + (_e30.member_1[3] * _e116)), ((((_e30.member_1[0] * _e52) + (_e30.member_1[1] * _e73)) + (_e30.member_1[2] * _e97)) + (_e30.member_1[3] * _e121)), 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_resolve(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
