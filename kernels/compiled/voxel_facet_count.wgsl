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
    var phi_68_: type_10;
    var phi_71_: u32;
    var phi_69_: type_10;
    var phi_94_: type_10;
    var phi_72_: u32;
    var phi_136_: bool;
    var phi_112_: u32;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e18 = gid_1;
            let _e26 = (_e18.x + (_e18.y * 2097152u));
            let _e27 = (_e26 < arrayLength((&out.member)));
            if _e27 {
                let _e32 = params.member.member_2[0u][3u];
                if (_e26 >= _e32) {
                    phi_112_ = 0u;
                } else {
                    phi_68_ = type_10(0u, 6u);
                    phi_71_ = 0u;
                    loop {
                        let _e36 = phi_68_;
                        let _e38 = phi_71_;
                        local = _e38;
                        if (_e36.member < _e36.member_1) {
                            phi_69_ = type_10((_e36.member + 1u), _e36.member_1);
                            phi_94_ = type_10(1u, _e36.member);
                        } else {
                            phi_69_ = _e36;
                            phi_94_ = type_10(0u, type_10().member_1);
                        }
                        let _e51 = phi_69_;
                        let _e53 = phi_94_;
                        let _e57 = (bitcast<i32>(_e53.member) != 0i);
                        if _e57 {
                            let _e58 = ((_e26 * 6u) + _e53.member_1);
                            if (_e58 < arrayLength((&facet_bits.member))) {
                            } else {
                                phi_136_ = true;
                                break;
                            }
                            let _e62 = facet_bits.member[_e58];
                            phi_72_ = (_e38 + countOneBits(_e62));
                        } else {
                            phi_72_ = u32();
                        }
                        let _e66 = phi_72_;
                        continue;
                        continuing {
                            phi_68_ = _e51;
                            phi_71_ = _e66;
                            phi_136_ = false;
                            break if !(_e57);
                        }
                    }
                    let _e69 = phi_136_;
                    if _e69 {
                        break;
                    }
                    let _e82 = local;
                    phi_112_ = _e82;
                }
                let _e71 = phi_112_;
                if _e27 {
                } else {
                    break;
                }
                out.member[_e26] = _e71;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_facet_count(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
