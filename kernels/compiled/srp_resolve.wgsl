struct type_5 {
    member: array<f32>,
}

struct type_14 {
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
var<storage, read_write> points: type_14;

fn function_() {
    var phi_239_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e14 = gid_1;
            let _e18 = arrayLength((&irradiance.member));
            let _e23 = params.member.member;
            let _e27 = (_e14.x + (_e14.y * 2097152u));
            if (_e27 < _e23) {
                if (_e27 < arrayLength((&blends.member))) {
                } else {
                    break;
                }
                let _e32 = blends.member[_e27];
                let _e35 = params.member.member_1;
                if (_e35 == 0u) {
                    phi_239_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    if (_e32.member[0] < _e18) {
                    } else {
                        break;
                    }
                    let _e44 = irradiance.member[_e32.member[0]];
                    let _e45 = (_e35 + _e32.member[0]);
                    if (_e45 < _e18) {
                    } else {
                        break;
                    }
                    let _e49 = irradiance.member[_e45];
                    let _e50 = (2u * _e35);
                    let _e51 = (_e50 + _e32.member[0]);
                    if (_e51 < _e18) {
                    } else {
                        break;
                    }
                    let _e55 = irradiance.member[_e51];
                    if (_e32.member[1] < _e18) {
                    } else {
                        break;
                    }
                    let _e66 = irradiance.member[_e32.member[1]];
                    let _e67 = (_e35 + _e32.member[1]);
                    if (_e67 < _e18) {
                    } else {
                        break;
                    }
                    let _e71 = irradiance.member[_e67];
                    let _e72 = (_e50 + _e32.member[1]);
                    if (_e72 < _e18) {
                    } else {
                        break;
                    }
                    let _e76 = irradiance.member[_e72];
                    if (_e32.member[2] < _e18) {
                    } else {
                        break;
                    }
                    let _e90 = irradiance.member[_e32.member[2]];
                    let _e91 = (_e35 + _e32.member[2]);
                    if (_e91 < _e18) {
                    } else {
                        break;
                    }
                    let _e95 = irradiance.member[_e91];
                    let _e96 = (_e50 + _e32.member[2]);
                    if (_e96 < _e18) {
                    } else {
                        break;
                    }
                    let _e100 = irradiance.member[_e96];
                    if (_e32.member[3] < _e18) {
                    } else {
                        break;
                    }
                    let _e114 = irradiance.member[_e32.member[3]];
                    let _e115 = (_e35 + _e32.member[3]);
                    if (_e115 < _e18) {
                    } else {
                        break;
                    }
                    let _e119 = irradiance.member[_e115];
                    let _e120 = (_e50 + _e32.member[3]);
                    if (_e120 < _e18) {
                    } else {
                        break;
                    }
                    let _e124 = irradiance.member[_e120];
                    let _e128 = ((((_e32.member_1[0] * _e44) + (_e32.member_1[1] * _e66)) + (_e32.member_1[2] * _e90)) + (_e32.member_1[3] * _e114));
                    let _e129 = ((((_e32.member_1[0] * _e49) + (_e32.member_1[1] * _e71)) + (_e32.member_1[2] * _e95)) + (_e32.member_1[3] * _e119));
                    let _e130 = ((((_e32.member_1[0] * _e55) + (_e32.member_1[1] * _e76)) + (_e32.member_1[2] * _e100)) + (_e32.member_1[3] * _e124));
                    phi_239_ = vec4<f32>(select(0f, _e128, (_e128 > 0f)), select(0f, _e129, (_e129 > 0f)), select(0f, _e130, (_e130 > 0f)), f32());
                }
                let _e139 = phi_239_;
                if (_e27 < arrayLength((&points.member))) {
                } else {
                    break;
                }
                points.member[_e27] = vec4<f32>(_e139.x, _e139.y, _e139.z, 0f);
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
