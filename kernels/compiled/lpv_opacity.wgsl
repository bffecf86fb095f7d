struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_18 {
    member: vec4<f32>,
    member_1: vec4<i32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
    member_4: vec4<f32>,
    member_5: u32,
    member_6: f32,
    member_7: f32,
    member_8: f32,
    member_9: f32,
    member_10: f32,
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: f32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: vec4<f32>,
}

struct type_19 {
    member: type_18,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(3) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_19;
@group(0) @binding(1) 
var<storage> facet_words: type_11;
@group(0) @binding(2) 
var<storage> texel_words: type_11;

fn function_() {
    var phi_74_: u32;
    var phi_89_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e13 = gid_1;
            let _e23 = (_e13.x + (_e13.y * 2097152u));
            let _e24 = (_e23 < arrayLength((&out.member)));
            if _e24 {
                let _e27 = params.member.member_15;
                if ((_e27 & 1u) == 1u) {
                    if (_e23 < arrayLength((&facet_words.member))) {
                    } else {
                        break;
                    }
                    let _e33 = facet_words.member[_e23];
                    phi_74_ = _e33;
                } else {
                    phi_74_ = 0u;
                }
                let _e35 = phi_74_;
                if ((_e27 & 2u) == 2u) {
                    if (_e23 < arrayLength((&texel_words.member))) {
                    } else {
                        break;
                    }
                    let _e41 = texel_words.member[_e23];
                    phi_89_ = _e41;
                } else {
                    phi_89_ = 0u;
                }
                let _e43 = phi_89_;
                let _e47 = (f32(select(_e43, _e35, (_e35 > 0u))) * 0.000015258789f);
                if _e24 {
                } else {
                    break;
                }
                out.member[_e23] = select(1f, _e47, (_e47 < 1f));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_opacity(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
