struct type_6 {
    member: array<u32>,
}

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_12 {
    member: type_11,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> values: type_6;
@group(0) @binding(0) 
var<uniform> params: type_12;
@group(0) @binding(2) 
var<storage> parents: type_6;
@group(0) @binding(3) 
var<storage, read_write> out: type_6;

fn function_() {
    var phi_66_: type_9;
    var phi_69_: u32;
    var phi_67_: type_9;
    var phi_92_: type_9;
    var phi_119_: u32;
    var phi_121_: u32;
    var phi_122_: bool;
    var phi_70_: u32;
    var phi_155_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e16 = gid_1;
            let _e26 = (_e16.x + (_e16.y * 2097152u));
            let _e27 = (_e26 < arrayLength((&out.member)));
            if _e27 {
                let _e28 = (_e26 / 16u);
                if (_e28 < arrayLength((&parents.member))) {
                } else {
                    break;
                }
                let _e32 = parents.member[_e28];
                phi_66_ = type_9((_e28 * 16u), _e26);
                phi_69_ = _e32;
                loop {
                    let _e36 = phi_66_;
                    let _e38 = phi_69_;
                    local = _e38;
                    if (_e36.member < _e36.member_1) {
                        phi_67_ = type_9((_e36.member + 1u), _e36.member_1);
                        phi_92_ = type_9(1u, _e36.member);
                    } else {
                        phi_67_ = _e36;
                        phi_92_ = type_9(0u, type_9().member_1);
                    }
                    let _e51 = phi_67_;
                    let _e53 = phi_92_;
                    let _e57 = (bitcast<i32>(_e53.member) != 0i);
                    if _e57 {
                        let _e60 = params.member.member_1;
                        if (_e53.member_1 >= _e60) {
                            let _e64 = params.member.member;
                            let _e65 = (_e53.member_1 < _e64);
                            if _e65 {
                                if (_e53.member_1 < arrayLength((&values.member))) {
                                } else {
                                    phi_155_ = true;
                                    break;
                                }
                                let _e69 = values.member[_e53.member_1];
                                phi_119_ = _e69;
                            } else {
                                phi_119_ = u32();
                            }
                            let _e71 = phi_119_;
                            phi_121_ = _e71;
                            phi_122_ = select(true, false, _e65);
                        } else {
                            phi_121_ = u32();
                            phi_122_ = true;
                        }
                        let _e74 = phi_121_;
                        let _e76 = phi_122_;
                        let _e78 = (_e38 + select(_e74, 0u, _e76));
                        phi_70_ = select(_e78, 4294967295u, (_e78 < _e38));
                    } else {
                        phi_70_ = u32();
                    }
                    let _e82 = phi_70_;
                    continue;
                    continuing {
                        phi_66_ = _e51;
                        phi_69_ = _e82;
                        phi_155_ = false;
                        break if !(_e57);
                    }
                }
                let _e85 = phi_155_;
                if _e85 {
                    break;
                }
                if _e27 {
                } else {
                    break;
                }
                let _e89 = local;
                out.member[_e26] = _e89;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn scan_prefix(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
