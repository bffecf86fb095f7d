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
    var phi_131_: type_11;
    var phi_134_: u32;
    var phi_136_: u32;
    var phi_138_: array<f32, 3>;
    var phi_132_: type_11;
    var phi_161_: type_11;
    var phi_135_: u32;
    var phi_137_: u32;
    var phi_139_: array<f32, 3>;
    var phi_328_: bool;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var phi_272_: type_11;
    var phi_273_: type_11;
    var phi_296_: type_11;
    var phi_332_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = gid_1;
            let _e39 = arrayLength((&basis.member));
            let _e44 = params.member.member;
            let _e48 = params.member.member_2;
            let _e52 = params.member.member_1;
            let _e56 = (_e33.x + (_e33.y * 2097152u));
            if (_e56 < (_e52 * 16u)) {
                let _e59 = (_e56 / 16u);
                let _e60 = (_e59 * 16u);
                let _e61 = (_e56 - _e60);
                let _e64 = (_e44 + _e59);
                if (_e64 < arrayLength((&blocks.member))) {
                } else {
                    break;
                }
                let _e69 = blocks.member[_e64].member;
                let _e73 = blocks.member[_e64].member_1;
                let _e77 = blocks.member[_e64].member_2;
                phi_131_ = type_11(0u, _e73);
                phi_134_ = (4u * _e77);
                phi_136_ = (_e69 + _e61);
                phi_138_ = array<f32, 3>(0f, 0f, 0f);
                loop {
                    let _e82 = phi_131_;
                    let _e84 = phi_134_;
                    let _e86 = phi_136_;
                    let _e88 = phi_138_;
                    local_1 = _e88;
                    local_2 = _e88;
                    local_3 = _e88;
                    if (_e82.member < _e82.member_1) {
                        phi_132_ = type_11((_e82.member + 1u), _e82.member_1);
                        phi_161_ = type_11(1u, _e82.member);
                    } else {
                        phi_132_ = _e82;
                        phi_161_ = type_11(0u, type_11().member_1);
                    }
                    let _e101 = phi_132_;
                    let _e103 = phi_161_;
                    let _e106 = (bitcast<i32>(_e103.member) != 0i);
                    if _e106 {
                        let _e107 = (_e86 < arrayLength((&words.member)));
                        if _e107 {
                        } else {
                            phi_328_ = true;
                            break;
                        }
                        let _e110 = words.member[_e86];
                        let _e119 = (bitcast<f32>((((_e110 << bitcast<u32>(16i)) & 2147483648u) | ((_e110 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if _e107 {
                        } else {
                            phi_328_ = true;
                            break;
                        }
                        let _e126 = (bitcast<f32>(((_e110 & 2147483648u) | ((_e110 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        if (_e84 < _e39) {
                        } else {
                            phi_328_ = true;
                            break;
                        }
                        let _e131 = basis.member[_e84];
                        let _e134 = (_e84 + 4u);
                        if (_e134 < _e39) {
                        } else {
                            phi_328_ = true;
                            break;
                        }
                        let _e138 = basis.member[_e134];
                        let _e142 = (_e84 + 1u);
                        if (_e142 < _e39) {
                        } else {
                            phi_328_ = true;
                            break;
                        }
                        let _e146 = basis.member[_e142];
                        let _e149 = (_e84 + 5u);
                        if (_e149 < _e39) {
                        } else {
                            phi_328_ = true;
                            break;
                        }
                        let _e153 = basis.member[_e149];
                        let _e157 = (_e84 + 2u);
                        if (_e157 < _e39) {
                        } else {
                            phi_328_ = true;
                            break;
                        }
                        let _e161 = basis.member[_e157];
                        let _e164 = (_e84 + 6u);
                        if (_e164 < _e39) {
                        } else {
                            phi_328_ = true;
                            break;
                        }
                        let _e168 = basis.member[_e164];
                        phi_135_ = (_e84 + 8u);
                        phi_137_ = (_e86 + 16u);
                        phi_139_ = array<f32, 3>(((_e88[0] + (_e119 * _e131)) + (_e126 * _e138)), ((_e88[1] + (_e119 * _e146)) + (_e126 * _e153)), ((_e88[2] + (_e119 * _e161)) + (_e126 * _e168)));
                    } else {
                        phi_135_ = u32();
                        phi_137_ = u32();
                        phi_139_ = array<f32, 3>();
                    }
                    let _e175 = phi_135_;
                    let _e177 = phi_137_;
                    let _e179 = phi_139_;
                    continue;
                    continuing {
                        phi_131_ = _e101;
                        phi_134_ = _e175;
                        phi_136_ = _e177;
                        phi_138_ = _e179;
                        phi_328_ = false;
                        break if !(_e106);
                    }
                }
                let _e182 = phi_328_;
                if _e182 {
                    break;
                }
                let _e184 = local_1;
                let _e187 = local_2;
                let _e190 = local_3;
                local = array<f32, 3>(_e184[0], _e187[1], _e190[2]);
                phi_272_ = type_11(0u, 3u);
                loop {
                    let _e194 = phi_272_;
                    if (_e194.member < _e194.member_1) {
                        phi_273_ = type_11((_e194.member + 1u), _e194.member_1);
                        phi_296_ = type_11(1u, _e194.member);
                    } else {
                        phi_273_ = _e194;
                        phi_296_ = type_11(0u, type_11().member_1);
                    }
                    let _e207 = phi_273_;
                    let _e209 = phi_296_;
                    let _e213 = (bitcast<i32>(_e209.member) != 0i);
                    if _e213 {
                        if (_e209.member_1 < 3u) {
                        } else {
                            phi_332_ = true;
                            break;
                        }
                        let _e216 = local[_e209.member_1];
                        let _e218 = ((_e209.member_1 * (_e48 * 16u)) + (((_e44 * 16u) + _e60) + _e61));
                        if (_e218 < arrayLength((&irradiance.member))) {
                        } else {
                            phi_332_ = true;
                            break;
                        }
                        irradiance.member[_e218] = _e216;
                    }
                    continue;
                    continuing {
                        phi_272_ = _e207;
                        phi_332_ = _e182;
                        break if !(_e213);
                    }
                }
                let _e224 = phi_332_;
                if _e224 {
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
