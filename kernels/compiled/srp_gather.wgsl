struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: f32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_15 {
    member: type_14,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(0) 
var<uniform> params: type_15;
@group(0) @binding(1) 
var<storage> hits: type_11;
@group(0) @binding(3) 
var<storage, read_write> light: type_5;

fn function_() {
    var phi_77_: u32;
    var phi_166_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e16 = gid_1;
            let _e19 = params.member.member_3;
            let _e21 = select(_e19, 16u, (_e19 == 0u));
            let _e24 = params.member.member;
            let _e25 = (_e24 / 16u);
            let _e27 = ((_e24 % 16u) > 0u);
            if _e27 {
                phi_77_ = (_e25 + 1u);
            } else {
                phi_77_ = _e25;
            }
            let _e30 = phi_77_;
            let _e31 = (_e21 == 0u);
            if _e31 {
                break;
            }
            if _e31 {
                break;
            }
            let _e36 = params.member.member_6;
            let _e37 = (((_e30 * _e21) * 16u) * _e36);
            let _e42 = (_e16.x + (_e16.y * 2097152u));
            if (_e42 < ((_e37 / 256u) * 256u)) {
                let _e47 = params.member.member_5;
                if _e27 {
                    phi_166_ = (_e25 + 1u);
                } else {
                    phi_166_ = _e25;
                }
                let _e50 = phi_166_;
                if _e31 {
                    break;
                }
                if _e31 {
                    break;
                }
                let _e57 = hits.member[((_e47 * ((_e50 * _e21) * 16u)) + _e42)];
                let _e58 = (4u * _e57);
                let _e61 = radiance.member[_e58];
                let _e65 = radiance.member[(_e58 + 1u)];
                let _e69 = radiance.member[(_e58 + 2u)];
                light.member[_e42] = _e61;
                light.member[(_e37 + _e42)] = _e65;
                light.member[((2u * _e37) + _e42)] = _e69;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_gather(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
