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

struct type_17 {
    member: u32,
    member_1: u32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_5;
@group(0) @binding(1) 
var<storage> x: type_8;
@group(0) @binding(2) 
var<storage, read_write> out: type_8;

fn function_() {
    var local: array<f32, 1>;
    var phi_75_: u32;
    var phi_93_: u32;
    var phi_146_: type_17;
    var phi_149_: array<f32, 12>;
    var phi_147_: type_17;
    var phi_172_: type_17;
    var phi_150_: array<f32, 12>;
    var local_1: array<f32, 12>;
    var local_2: array<f32, 12>;
    var local_3: array<f32, 12>;
    var local_4: array<f32, 12>;
    var local_5: array<f32, 12>;
    var local_6: array<f32, 12>;
    var local_7: array<f32, 12>;
    var local_8: array<f32, 12>;
    var local_9: array<f32, 12>;
    var local_10: array<f32, 12>;
    var local_11: array<f32, 12>;
    var local_12: array<f32, 12>;
    var phi_254_: type_17;
    var phi_255_: type_17;
    var phi_278_: type_17;
    var phi_308_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = gid_1;
            let _e36 = params.member.member;
            let _e37 = (_e36 / 256u);
            let _e39 = ((_e36 % 256u) > 0u);
            if _e39 {
                phi_75_ = (_e37 + 1u);
            } else {
                phi_75_ = _e37;
            }
            let _e42 = phi_75_;
            if _e39 {
                phi_93_ = (_e37 + 1u);
            } else {
                phi_93_ = _e37;
            }
            let _e45 = phi_93_;
            let _e50 = (_e31.x + (_e31.y * 2097152u));
            if (_e50 < (_e42 * 256u)) {
                let _e55 = x.member[_e50];
                let _e58 = params.member.member_2;
                phi_146_ = type_17(0u, 64u);
                phi_149_ = array<f32, 12>(0f, _e55, (_e55 * 2f), (_e55 * 3f), (_e55 * 4f), (_e55 * 5f), (_e55 * 6f), (_e55 * 7f), (_e55 * 8f), (_e55 * 9f), (_e55 * 10f), (_e55 * 11f));
                loop {
                    let _e71 = phi_146_;
                    let _e73 = phi_149_;
                    local_1 = _e73;
                    local_2 = _e73;
                    local_3 = _e73;
                    local_4 = _e73;
                    local_5 = _e73;
                    local_6 = _e73;
                    local_7 = _e73;
                    local_8 = _e73;
                    local_9 = _e73;
                    local_10 = _e73;
                    local_11 = _e73;
                    local_12 = _e73;
                    if (_e71.member < _e71.member_1) {
                        phi_147_ = type_17((_e71.member + 1u), _e71.member_1);
                        phi_172_ = type_17(1u, _e71.member);
                    } else {
                        phi_147_ = _e71;
                        phi_172_ = type_17(0u, type_17().member_1);
                    }
                    let _e86 = phi_147_;
                    let _e88 = phi_172_;
                    let _e91 = (bitcast<i32>(_e88.member) != 0i);
                    if _e91 {
                        phi_150_ = array<f32, 12>(((_e73[0] * _e58) + _e55), ((_e73[1] * _e58) + _e55), ((_e73[2] * _e58) + _e55), ((_e73[3] * _e58) + _e55), ((_e73[4] * _e58) + _e55), ((_e73[5] * _e58) + _e55), ((_e73[6] * _e58) + _e55), ((_e73[7] * _e58) + _e55), ((_e73[8] * _e58) + _e55), ((_e73[9] * _e58) + _e55), ((_e73[10] * _e58) + _e55), ((_e73[11] * _e58) + _e55));
                    } else {
                        phi_150_ = array<f32, 12>();
                    }
                    let _e130 = phi_150_;
                    continue;
                    continuing {
                        phi_146_ = _e86;
                        phi_149_ = _e130;
                        break if !(_e91);
                    }
                }
                let _e133 = local_1;
                let _e136 = local_2;
                let _e140 = local_3;
                let _e144 = local_4;
                let _e148 = local_5;
                let _e152 = local_6;
                let _e156 = local_7;
                let _e160 = local_8;
                let _e164 = local_9;
                let _e168 = local_10;
                let _e172 = local_11;
                let _e176 = local_12;
                local[0u] = (((((((((((_e133[0] + _e136[1]) + _e140[2]) + _e144[3]) + _e148[4]) + _e152[5]) + _e156[6]) + _e160[7]) + _e164[8]) + _e168[9]) + _e172[10]) + _e176[11]);
                phi_254_ = type_17(0u, 1u);
                loop {
                    let _e181 = phi_254_;
                    if (_e181.member < _e181.member_1) {
                        phi_255_ = type_17((_e181.member + 1u), _e181.member_1);
                        phi_278_ = type_17(1u, _e181.member);
                    } else {
                        phi_255_ = _e181;
                        phi_278_ = type_17(0u, type_17().member_1);
                    }
                    let _e194 = phi_255_;
                    let _e196 = phi_278_;
                    let _e200 = (bitcast<i32>(_e196.member) != 0i);
                    if _e200 {
                        if (_e196.member_1 < 1u) {
                        } else {
                            phi_308_ = true;
                            break;
                        }
                        let _e203 = local[_e196.member_1];
                        let _e205 = ((_e196.member_1 * (_e45 * 256u)) + _e50);
                        if (_e205 < arrayLength((&out.member))) {
                        } else {
                            phi_308_ = true;
                            break;
                        }
                        out.member[_e205] = _e203;
                    }
                    continue;
                    continuing {
                        phi_254_ = _e194;
                        phi_308_ = false;
                        break if !(_e200);
                    }
                }
                let _e211 = phi_308_;
                if _e211 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn smoke_madd(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
