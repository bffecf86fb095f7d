struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_11 {
    member: type_10,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(3) 
var<storage, read_write> irradiance: type_5;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(0) 
var<uniform> params: type_11;
@group(0) @binding(1) 
var<storage> normals: type_5;

fn function_() {
    let _e15 = gid_1;
    let _e18 = params.member.member_1;
    let _e23 = (_e15.x + (_e15.y * 2097152u));
    if (_e23 < ((_e18 / 16u) * 16u)) {
        let _e28 = normals.member[_e23];
        let _e29 = (_e18 + _e23);
        let _e32 = normals.member[_e29];
        let _e34 = ((2u * _e18) + _e23);
        let _e37 = normals.member[_e34];
        let _e40 = radiance.member[_e23];
        let _e41 = (3u * _e18);
        let _e45 = radiance.member[(_e23 + _e41)];
        let _e46 = (6u * _e18);
        let _e50 = radiance.member[(_e23 + _e46)];
        let _e51 = (9u * _e18);
        let _e55 = radiance.member[(_e23 + _e51)];
        let _e57 = (_e37 * 1.0233268f);
        let _e60 = (_e28 * 1.0233268f);
        let _e63 = (_e32 * 1.0233268f);
        let _e68 = radiance.member[_e29];
        let _e72 = radiance.member[(_e29 + _e41)];
        let _e76 = radiance.member[(_e29 + _e46)];
        let _e80 = radiance.member[(_e29 + _e51)];
        let _e90 = radiance.member[_e34];
        let _e94 = radiance.member[(_e34 + _e41)];
        let _e98 = radiance.member[(_e34 + _e46)];
        let _e102 = radiance.member[(_e34 + _e51)];
        irradiance.member[_e23] = ((((_e40 * 0.886227f) + (_e50 * _e57)) + (_e55 * _e60)) + (_e45 * _e63));
        irradiance.member[_e29] = ((((_e68 * 0.886227f) + (_e76 * _e57)) + (_e80 * _e60)) + (_e72 * _e63));
        irradiance.member[_e34] = ((((_e90 * 0.886227f) + (_e98 * _e57)) + (_e102 * _e60)) + (_e94 * _e63));
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_receiver_irradiance(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
