struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_16 {
    member: type_15,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(3) 
var<storage, read_write> irradiance: type_5;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(0) 
var<uniform> params: type_16;
@group(0) @binding(1) 
var<storage> normals: type_5;

fn function_() {
    var local: array<f32, 3>;
    var phi_2288_: type_11;
    var phi_2289_: type_11;
    var phi_2312_: type_11;
    var phi_2342_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = gid_1;
            let _e24 = arrayLength((&normals.member));
            let _e26 = arrayLength((&radiance.member));
            let _e31 = params.member.member_1;
            let _e36 = (_e22.x + (_e22.y * 2097152u));
            if (_e36 < ((_e31 / 16u) * 16u)) {
                if (_e36 < _e24) {
                } else {
                    break;
                }
                let _e42 = normals.member[_e36];
                let _e43 = (_e31 + _e36);
                if (_e43 < _e24) {
                } else {
                    break;
                }
                let _e47 = normals.member[_e43];
                let _e49 = ((2u * _e31) + _e36);
                if (_e49 < _e24) {
                } else {
                    break;
                }
                let _e53 = normals.member[_e49];
                if (_e36 < _e26) {
                } else {
                    break;
                }
                let _e57 = radiance.member[_e36];
                let _e58 = (3u * _e31);
                let _e59 = (_e36 + _e58);
                if (_e59 < _e26) {
                } else {
                    break;
                }
                let _e63 = radiance.member[_e59];
                let _e64 = (6u * _e31);
                let _e65 = (_e36 + _e64);
                if (_e65 < _e26) {
                } else {
                    break;
                }
                let _e69 = radiance.member[_e65];
                let _e70 = (9u * _e31);
                let _e71 = (_e36 + _e70);
                if (_e71 < _e26) {
                } else {
                    break;
                }
                let _e75 = radiance.member[_e71];
                let _e77 = (_e53 * 1.0233268f);
                let _e80 = (_e42 * 1.0233268f);
                let _e83 = (_e47 * 1.0233268f);
                if (_e43 < _e26) {
                } else {
                    break;
                }
                let _e89 = radiance.member[_e43];
                let _e90 = (_e43 + _e58);
                if (_e90 < _e26) {
                } else {
                    break;
                }
                let _e94 = radiance.member[_e90];
                let _e95 = (_e43 + _e64);
                if (_e95 < _e26) {
                } else {
                    break;
                }
                let _e99 = radiance.member[_e95];
                let _e100 = (_e43 + _e70);
                if (_e100 < _e26) {
                } else {
                    break;
                }
                let _e104 = radiance.member[_e100];
                if (_e49 < _e26) {
                } else {
                    break;
                }
                let _e115 = radiance.member[_e49];
                let _e116 = (_e49 + _e58);
                if (_e116 < _e26) {
                } else {
                    break;
                }
                let _e120 = radiance.member[_e116];
                let _e121 = (_e49 + _e64);
                if (_e121 < _e26) {
                } else {
                    break;
                }
                let _e125 = radiance.member[_e121];
                let _e126 = (_e49 + _e70);
                if (_e126 < _e26) {
                } else {
                    break;
                }
                let _e130 = radiance.member[_e126];
                local = array<f32, 3>(((((_e57 * 0.886227f) + (_e69 * _e77)) + (_e75 * _e80)) + (_e63 * _e83)), ((((_e89 * 0.886227f) + (_e99 * _e77)) + (_e104 * _e80)) + (_e94 * _e83)), ((((_e115 * 0.886227f) + (_e125 * _e77)) + (_e130 * _e80)) + (_e120 * _e83)));
                phi_2288_ = type_11(0u, 3u);
                loop {
                    let _e140 = phi_2288_;
                    if (_e140.member < _e140.member_1) {
                        phi_2289_ = type_11((_e140.member + 1u), _e140.member_1);
                        phi_2312_ = type_11(1u, _e140.member);
                    } else {
                        phi_2289_ = _e140;
                        phi_2312_ = type_11(0u, type_11().member_1);
                    }
                    let _e153 = phi_2289_;
                    let _e155 = phi_2312_;
                    let _e159 = (bitcast<i32>(_e155.member) != 0i);
                    if _e159 {
                        if (_e155.member_1 < 3u) {
                        } else {
                            phi_2342_ = true;
                            break;
                        }
                        let _e162 = local[_e155.member_1];
                        let _e164 = ((_e155.member_1 * _e31) + _e36);
                        if (_e164 < arrayLength((&irradiance.member))) {
                        } else {
                            phi_2342_ = true;
                            break;
                        }
                        irradiance.member[_e164] = _e162;
                    }
                    continue;
                    continuing {
                        phi_2288_ = _e153;
                        phi_2342_ = false;
                        break if !(_e159);
                    }
                }
                let _e170 = phi_2342_;
                if _e170 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_receiver_irradiance(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
