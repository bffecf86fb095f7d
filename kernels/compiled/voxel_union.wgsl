struct type_7 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: vec4<f32>,
    member_1: vec4<u32>,
    member_2: array<vec4<u32>, 10>,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: f32,
    member_8: f32,
    member_9: f32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: vec4<f32>,
    member_16: vec4<f32>,
    member_17: vec4<u32>,
}

struct type_16 {
    member: type_15,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_7;
@group(0) @binding(0) 
var<uniform> params: type_16;
@group(0) @binding(1) 
var<storage> facet_bits: type_7;

fn function_() {
    var phi_64_: type_10;
    var phi_67_: u32;
    var phi_65_: type_10;
    var phi_90_: type_10;
    var phi_68_: u32;
    var phi_130_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e18 = gid_1;
            let _e25 = params.member.member_12;
            let _e28 = params.member.member_13;
            let _e32 = (_e18.x + (_e18.y * 2097152u));
            if (_e32 < _e28) {
                phi_64_ = type_10(0u, 6u);
                phi_67_ = 0u;
                loop {
                    let _e36 = phi_64_;
                    let _e38 = phi_67_;
                    local = _e38;
                    if (_e36.member < _e36.member_1) {
                        phi_65_ = type_10((_e36.member + 1u), _e36.member_1);
                        phi_90_ = type_10(1u, _e36.member);
                    } else {
                        phi_65_ = _e36;
                        phi_90_ = type_10(0u, type_10().member_1);
                    }
                    let _e51 = phi_65_;
                    let _e53 = phi_90_;
                    let _e57 = (bitcast<i32>(_e53.member) != 0i);
                    if _e57 {
                        let _e58 = ((_e32 * 6u) + _e53.member_1);
                        if (_e58 < arrayLength((&facet_bits.member))) {
                        } else {
                            phi_130_ = true;
                            break;
                        }
                        let _e62 = facet_bits.member[_e58];
                        phi_68_ = (_e38 | _e62);
                    } else {
                        phi_68_ = u32();
                    }
                    let _e65 = phi_68_;
                    continue;
                    continuing {
                        phi_64_ = _e51;
                        phi_67_ = _e65;
                        phi_130_ = false;
                        break if !(_e57);
                    }
                }
                let _e68 = phi_130_;
                if _e68 {
                    break;
                }
                let _e71 = ((_e25 + _e32) + (_e32 - _e32));
                if (_e71 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                let _e76 = local;
                out.member[_e71] = _e76;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_union(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
