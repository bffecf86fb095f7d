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
@group(0) @binding(2) 
var<storage, read_write> out: type_6;
@group(0) @binding(0) 
var<uniform> params: type_12;

fn function_() {
    var phi_57_: type_9;
    var phi_60_: u32;
    var phi_58_: type_9;
    var phi_83_: type_9;
    var phi_110_: u32;
    var phi_112_: u32;
    var phi_113_: bool;
    var phi_61_: u32;
    var phi_146_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e15 = gid_1;
            let _e23 = (_e15.x + (_e15.y * 2097152u));
            let _e24 = (_e23 < arrayLength((&out.member)));
            if _e24 {
                phi_57_ = type_9((_e23 * 16u), ((_e23 + 1u) * 16u));
                phi_60_ = 0u;
                loop {
                    let _e30 = phi_57_;
                    let _e32 = phi_60_;
                    local = _e32;
                    if (_e30.member < _e30.member_1) {
                        phi_58_ = type_9((_e30.member + 1u), _e30.member_1);
                        phi_83_ = type_9(1u, _e30.member);
                    } else {
                        phi_58_ = _e30;
                        phi_83_ = type_9(0u, type_9().member_1);
                    }
                    let _e45 = phi_58_;
                    let _e47 = phi_83_;
                    let _e51 = (bitcast<i32>(_e47.member) != 0i);
                    if _e51 {
                        let _e54 = params.member.member_1;
                        if (_e47.member_1 >= _e54) {
                            let _e58 = params.member.member;
                            let _e59 = (_e47.member_1 < _e58);
                            if _e59 {
                                if (_e47.member_1 < arrayLength((&values.member))) {
                                } else {
                                    phi_146_ = true;
                                    break;
                                }
                                let _e63 = values.member[_e47.member_1];
                                phi_110_ = _e63;
                            } else {
                                phi_110_ = u32();
                            }
                            let _e65 = phi_110_;
                            phi_112_ = _e65;
                            phi_113_ = select(true, false, _e59);
                        } else {
                            phi_112_ = u32();
                            phi_113_ = true;
                        }
                        let _e68 = phi_112_;
                        let _e70 = phi_113_;
                        let _e72 = (_e32 + select(_e68, 0u, _e70));
                        phi_61_ = select(_e72, 4294967295u, (_e72 < _e32));
                    } else {
                        phi_61_ = u32();
                    }
                    let _e76 = phi_61_;
                    continue;
                    continuing {
                        phi_57_ = _e45;
                        phi_60_ = _e76;
                        phi_146_ = false;
                        break if !(_e51);
                    }
                }
                let _e79 = phi_146_;
                if _e79 {
                    break;
                }
                if _e24 {
                } else {
                    break;
                }
                let _e83 = local;
                out.member[_e23] = _e83;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn scan_sum(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
