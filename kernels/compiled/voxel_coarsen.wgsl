struct type_6 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<u32>,
}

struct type_16 {
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

struct type_17 {
    member: type_16,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_9;
@group(0) @binding(0) 
var<uniform> params: type_17;
@group(0) @binding(1) 
var<storage> finer: type_9;

fn function_() {
    var phi_104_: u32;
    var phi_165_: type_6;
    var phi_168_: u32;
    var phi_166_: type_6;
    var phi_191_: type_6;
    var phi_268_: u32;
    var phi_269_: u32;
    var phi_270_: u32;
    var phi_169_: u32;
    var phi_294_: bool;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = gid_1;
            let _e36 = params.member.member_12;
            let _e39 = params.member.member_13;
            let _e43 = (_e29.x + (_e29.y * 2097152u));
            if (_e43 < _e39) {
                let _e47 = params.member.member_11;
                if (_e47 < 10u) {
                } else {
                    break;
                }
                let _e52 = params.member.member_2[_e47];
                let _e53 = (_e47 - 1u);
                if (_e53 < 10u) {
                } else {
                    break;
                }
                let _e58 = params.member.member_2[_e53];
                if ((_e47 & 1u) == 1u) {
                    phi_104_ = 0u;
                } else {
                    let _e63 = params.member.member_10;
                    phi_104_ = _e63;
                }
                let _e65 = phi_104_;
                if (_e52.y == 0u) {
                    break;
                }
                let _e68 = (_e43 / _e52.y);
                let _e70 = (_e43 - (_e68 * _e52.y));
                if (_e52.x == 0u) {
                    break;
                }
                let _e73 = (_e70 / _e52.x);
                let _e84 = (_e53 & 31u);
                let _e87 = ((1u << bitcast<u32>(_e84)) - 1u);
                let _e90 = params.member.member_1;
                phi_165_ = type_6(0u, 8u);
                phi_168_ = 0u;
                loop {
                    let _e104 = phi_165_;
                    let _e106 = phi_168_;
                    local = _e106;
                    if (_e104.member < _e104.member_1) {
                        phi_166_ = type_6((_e104.member + 1u), _e104.member_1);
                        phi_191_ = type_6(1u, _e104.member);
                    } else {
                        phi_166_ = _e104;
                        phi_191_ = type_6(0u, type_6().member_1);
                    }
                    let _e119 = phi_166_;
                    let _e121 = phi_191_;
                    let _e125 = (bitcast<i32>(_e121.member) != 0i);
                    if _e125 {
                        let _e126 = (_e121.member_1 & 1u);
                        let _e129 = ((_e121.member_1 >> bitcast<u32>(1i)) & 1u);
                        let _e131 = (_e121.member_1 >> bitcast<u32>(2i));
                        let _e133 = ((((_e70 - (_e73 * _e52.x)) << bitcast<u32>(2i)) * 2u) + (_e126 * 4u));
                        let _e135 = (((_e73 << bitcast<u32>(2i)) * 2u) + (_e129 * 4u));
                        let _e137 = (2u * ((_e68 << bitcast<u32>(1i)) + _e131));
                        if (_e133 < ((_e90.x + _e87) >> bitcast<u32>(_e84))) {
                            if (_e135 < ((_e90.y + _e87) >> bitcast<u32>(_e84))) {
                                if (_e137 < ((_e90.z + _e87) >> bitcast<u32>(_e84))) {
                                    let _e155 = ((((_e58.z + (_e133 >> bitcast<u32>(2i))) + (_e58.x * (_e135 >> bitcast<u32>(2i)))) + (_e58.y * (_e137 >> bitcast<u32>(1i)))) - _e65);
                                    if (_e155 < arrayLength((&finer.member))) {
                                    } else {
                                        phi_294_ = true;
                                        break;
                                    }
                                    let _e159 = finer.member[_e155];
                                    phi_268_ = (_e106 | ((((select(0u, 1u, ((_e159 & 255u) != 0u)) | (select(0u, 1u, (((_e159 >> bitcast<u32>(8i)) & 255u) != 0u)) << bitcast<u32>(1i))) | (select(0u, 1u, (((_e159 >> bitcast<u32>(16i)) & 255u) != 0u)) << bitcast<u32>(2i))) | (select(0u, 1u, ((_e159 >> bitcast<u32>(24i)) != 0u)) << bitcast<u32>(3i))) << bitcast<u32>((((8u * (_e126 + (2u * _e129))) + (4u * _e131)) & 31u))));
                                } else {
                                    phi_268_ = _e106;
                                }
                                let _e196 = phi_268_;
                                phi_269_ = _e196;
                            } else {
                                phi_269_ = _e106;
                            }
                            let _e198 = phi_269_;
                            phi_270_ = _e198;
                        } else {
                            phi_270_ = _e106;
                        }
                        let _e200 = phi_270_;
                        phi_169_ = _e200;
                    } else {
                        phi_169_ = u32();
                    }
                    let _e202 = phi_169_;
                    continue;
                    continuing {
                        phi_165_ = _e119;
                        phi_168_ = _e202;
                        phi_294_ = false;
                        break if !(_e125);
                    }
                }
                let _e205 = phi_294_;
                if _e205 {
                    break;
                }
                let _e208 = ((_e36 + _e43) + (_e43 - _e43));
                if (_e208 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                let _e213 = local;
                out.member[_e208] = _e213;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_coarsen(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
