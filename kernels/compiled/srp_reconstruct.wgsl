struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<u32>,
}

struct type_19 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_21 {
    member: type_20,
}

struct type_24 {
    member: array<type_19>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_21;
@group(0) @binding(1) 
var<storage> blocks: type_24;
@group(0) @binding(2) 
var<storage> words: type_14;
@group(0) @binding(3) 
var<storage> basis: type_5;
@group(0) @binding(4) 
var<storage, read_write> irradiance: type_5;

fn function_() {
    var local: array<f32, 3>;
    var phi_130_: type_11;
    var phi_133_: u32;
    var phi_135_: u32;
    var phi_137_: array<f32, 3>;
    var phi_131_: type_11;
    var phi_160_: type_11;
    var phi_134_: u32;
    var phi_136_: u32;
    var phi_138_: array<f32, 3>;
    var phi_317_: bool;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var phi_261_: type_11;
    var phi_262_: type_11;
    var phi_285_: type_11;
    var phi_321_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = gid_1;
            let _e37 = arrayLength((&basis.member));
            let _e42 = params.member.member;
            let _e46 = params.member.member_2;
            let _e50 = params.member.member_1;
            let _e54 = (_e33.x + (_e33.y * 2097152u));
            if (_e54 < (_e50 * 16u)) {
                let _e57 = (_e54 / 16u);
                let _e58 = (_e57 * 16u);
                let _e59 = (_e54 - _e58);
                let _e62 = (_e42 + _e57);
                if (_e62 < arrayLength((&blocks.member))) {
                } else {
                    break;
                }
                let _e67 = blocks.member[_e62].member;
                let _e71 = blocks.member[_e62].member_1;
                let _e75 = blocks.member[_e62].member_2;
                phi_130_ = type_11(0u, _e71);
                phi_133_ = (4u * _e75);
                phi_135_ = (_e67 + _e59);
                phi_137_ = array<f32, 3>(0f, 0f, 0f);
                loop {
                    let _e80 = phi_130_;
                    let _e82 = phi_133_;
                    let _e84 = phi_135_;
                    let _e86 = phi_137_;
                    local_1 = _e86;
                    local_2 = _e86;
                    local_3 = _e86;
                    if (_e80.member < _e80.member_1) {
                        phi_131_ = type_11((_e80.member + 1u), _e80.member_1);
                        phi_160_ = type_11(1u, _e80.member);
                    } else {
                        phi_131_ = _e80;
                        phi_160_ = type_11(0u, type_11().member_1);
                    }
                    let _e99 = phi_131_;
                    let _e101 = phi_160_;
                    let _e104 = (bitcast<i32>(_e101.member) != 0i);
                    if _e104 {
                        let _e107 = words.member[_e84];
                        let _e116 = (bitcast<f32>((((_e107 << bitcast<u32>(16i)) & 2147483648u) | ((_e107 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e123 = (bitcast<f32>(((_e107 & 2147483648u) | ((_e107 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if (_e82 < _e37) {
                        } else {
                            phi_317_ = true;
                            break;
                        }
                        let _e128 = basis.member[_e82];
                        let _e131 = (_e82 + 4u);
                        if (_e131 < _e37) {
                        } else {
                            phi_317_ = true;
                            break;
                        }
                        let _e135 = basis.member[_e131];
                        let _e139 = (_e82 + 1u);
                        if (_e139 < _e37) {
                        } else {
                            phi_317_ = true;
                            break;
                        }
                        let _e143 = basis.member[_e139];
                        let _e146 = (_e82 + 5u);
                        if (_e146 < _e37) {
                        } else {
                            phi_317_ = true;
                            break;
                        }
                        let _e150 = basis.member[_e146];
                        let _e154 = (_e82 + 2u);
                        if (_e154 < _e37) {
                        } else {
                            phi_317_ = true;
                            break;
                        }
                        let _e158 = basis.member[_e154];
                        let _e161 = (_e82 + 6u);
                        if (_e161 < _e37) {
                        } else {
                            phi_317_ = true;
                            break;
                        }
                        let _e165 = basis.member[_e161];
                        phi_134_ = (_e82 + 8u);
                        phi_136_ = (_e84 + 16u);
                        phi_138_ = array<f32, 3>(((_e86[0] + (_e116 * _e128)) + (_e123 * _e135)), ((_e86[1] + (_e116 * _e143)) + (_e123 * _e150)), ((_e86[2] + (_e116 * _e158)) + (_e123 * _e165)));
                    } else {
                        phi_134_ = u32();
                        phi_136_ = u32();
                        phi_138_ = array<f32, 3>();
                    }
                    let _e172 = phi_134_;
                    let _e174 = phi_136_;
                    let _e176 = phi_138_;
                    continue;
                    continuing {
                        phi_130_ = _e99;
                        phi_133_ = _e172;
                        phi_135_ = _e174;
                        phi_137_ = _e176;
                        phi_317_ = false;
                        break if !(_e104);
                    }
                }
                let _e179 = phi_317_;
                if _e179 {
                    break;
                }
                let _e181 = local_1;
                let _e184 = local_2;
                let _e187 = local_3;
                local = array<f32, 3>(_e181[0], _e184[1], _e187[2]);
                phi_261_ = type_11(0u, 3u);
                loop {
                    let _e191 = phi_261_;
                    if (_e191.member < _e191.member_1) {
                        phi_262_ = type_11((_e191.member + 1u), _e191.member_1);
                        phi_285_ = type_11(1u, _e191.member);
                    } else {
                        phi_262_ = _e191;
                        phi_285_ = type_11(0u, type_11().member_1);
                    }
                    let _e204 = phi_262_;
                    let _e206 = phi_285_;
                    let _e210 = (bitcast<i32>(_e206.member) != 0i);
                    if _e210 {
                        if (_e206.member_1 < 3u) {
                        } else {
                            phi_321_ = true;
                            break;
                        }
                        let _e213 = local[_e206.member_1];
                        let _e215 = ((_e206.member_1 * (_e46 * 16u)) + (((_e42 * 16u) + _e58) + _e59));
                        if (_e215 < arrayLength((&irradiance.member))) {
                        } else {
                            phi_321_ = true;
                            break;
                        }
                        irradiance.member[_e215] = _e213;
                    }
                    continue;
                    continuing {
                        phi_261_ = _e204;
                        phi_321_ = _e179;
                        break if !(_e210);
                    }
                }
                let _e221 = phi_321_;
                if _e221 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_reconstruct(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
