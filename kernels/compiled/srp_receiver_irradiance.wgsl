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
    var phi_2211_: type_11;
    var phi_2212_: type_11;
    var phi_2235_: type_11;
    var phi_2265_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = gid_1;
            let _e27 = params.member.member_1;
            let _e32 = (_e22.x + (_e22.y * 2097152u));
            if (_e32 < ((_e27 / 16u) * 16u)) {
                let _e37 = normals.member[_e32];
                let _e38 = (_e27 + _e32);
                let _e41 = normals.member[_e38];
                let _e43 = ((2u * _e27) + _e32);
                let _e46 = normals.member[_e43];
                let _e49 = radiance.member[_e32];
                let _e50 = (3u * _e27);
                let _e54 = radiance.member[(_e32 + _e50)];
                let _e55 = (6u * _e27);
                let _e59 = radiance.member[(_e32 + _e55)];
                let _e60 = (9u * _e27);
                let _e64 = radiance.member[(_e32 + _e60)];
                let _e66 = (_e46 * 1.0233268f);
                let _e69 = (_e37 * 1.0233268f);
                let _e72 = (_e41 * 1.0233268f);
                let _e77 = radiance.member[_e38];
                let _e81 = radiance.member[(_e38 + _e50)];
                let _e85 = radiance.member[(_e38 + _e55)];
                let _e89 = radiance.member[(_e38 + _e60)];
                let _e99 = radiance.member[_e43];
                let _e103 = radiance.member[(_e43 + _e50)];
                let _e107 = radiance.member[(_e43 + _e55)];
                let _e111 = radiance.member[(_e43 + _e60)];
                local = array<f32, 3>(((((_e49 * 0.886227f) + (_e59 * _e66)) + (_e64 * _e69)) + (_e54 * _e72)), ((((_e77 * 0.886227f) + (_e85 * _e66)) + (_e89 * _e69)) + (_e81 * _e72)), ((((_e99 * 0.886227f) + (_e107 * _e66)) + (_e111 * _e69)) + (_e103 * _e72)));
                phi_2211_ = type_11(0u, 3u);
                loop {
                    let _e121 = phi_2211_;
                    if (_e121.member < _e121.member_1) {
                        phi_2212_ = type_11((_e121.member + 1u), _e121.member_1);
                        phi_2235_ = type_11(1u, _e121.member);
                    } else {
                        phi_2212_ = _e121;
                        phi_2235_ = type_11(0u, type_11().member_1);
                    }
                    let _e134 = phi_2212_;
                    let _e136 = phi_2235_;
                    let _e140 = (bitcast<i32>(_e136.member) != 0i);
                    if _e140 {
                        if (_e136.member_1 < 3u) {
                        } else {
                            phi_2265_ = true;
                            break;
                        }
                        let _e143 = local[_e136.member_1];
                        let _e145 = ((_e136.member_1 * _e27) + _e32);
                        if (_e145 < arrayLength((&irradiance.member))) {
                        } else {
                            phi_2265_ = true;
                            break;
                        }
                        irradiance.member[_e145] = _e143;
                    }
                    continue;
                    continuing {
                        phi_2211_ = _e134;
                        phi_2265_ = false;
                        break if !(_e140);
                    }
                }
                let _e151 = phi_2265_;
                if _e151 {
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
