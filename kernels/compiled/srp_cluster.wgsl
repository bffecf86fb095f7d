struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_14 {
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_19 {
    member: type_18,
}

struct type_22 {
    member: array<type_17>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_19;
@group(0) @binding(1) 
var<storage> pairs: type_22;
@group(0) @binding(2) 
var<storage> blocks: type_11;
@group(0) @binding(3) 
var<storage> words: type_11;
@group(0) @binding(4) 
var<storage> coefs: type_5;
@group(0) @binding(5) 
var<storage, read_write> partial: type_5;

fn function_() {
    var phi_130_: type_14;
    var phi_133_: u32;
    var phi_135_: u32;
    var phi_137_: array<f32, 6>;
    var phi_131_: type_14;
    var phi_160_: type_14;
    var phi_134_: u32;
    var phi_136_: u32;
    var phi_138_: array<f32, 6>;
    var phi_312_: bool;
    var local: array<f32, 6>;
    var local_1: array<f32, 6>;
    var local_2: array<f32, 6>;
    var local_3: array<f32, 6>;
    var local_4: array<f32, 6>;
    var local_5: array<f32, 6>;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = gid_1;
            let _e37 = arrayLength((&blocks.member));
            let _e40 = params.member.member;
            let _e44 = params.member.member_2;
            let _e48 = params.member.member_1;
            let _e52 = (_e33.x + (_e33.y * 2097152u));
            if (_e52 < (_e48 * 16u)) {
                let _e55 = (_e52 / 16u);
                let _e56 = (_e55 * 16u);
                let _e57 = (_e52 - _e56);
                let _e59 = (((_e40 * 16u) + _e56) + _e57);
                let _e60 = (_e40 + _e55);
                if (_e60 < arrayLength((&pairs.member))) {
                } else {
                    break;
                }
                let _e65 = pairs.member[_e60].member;
                let _e69 = pairs.member[_e60].member_1;
                let _e73 = pairs.member[_e60].member_2;
                let _e76 = params.member.member_3;
                phi_130_ = type_14(0u, _e73);
                phi_133_ = _e69;
                phi_135_ = (_e65 + _e57);
                phi_137_ = array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e80 = phi_130_;
                    let _e82 = phi_133_;
                    let _e84 = phi_135_;
                    let _e86 = phi_137_;
                    local = _e86;
                    local_1 = _e86;
                    local_2 = _e86;
                    local_3 = _e86;
                    local_4 = _e86;
                    local_5 = _e86;
                    if (_e80.member < _e80.member_1) {
                        phi_131_ = type_14((_e80.member + 1u), _e80.member_1);
                        phi_160_ = type_14(1u, _e80.member);
                    } else {
                        phi_131_ = _e80;
                        phi_160_ = type_14(0u, type_14().member_1);
                    }
                    let _e99 = phi_131_;
                    let _e101 = phi_160_;
                    let _e104 = (bitcast<i32>(_e101.member) != 0i);
                    if _e104 {
                        if (_e82 < _e37) {
                        } else {
                            phi_312_ = true;
                            break;
                        }
                        let _e108 = blocks.member[_e82];
                        let _e109 = (_e108 + _e57);
                        let _e110 = (_e82 + 1u);
                        if (_e110 < _e37) {
                        } else {
                            phi_312_ = true;
                            break;
                        }
                        let _e114 = blocks.member[_e110];
                        let _e115 = (_e114 + _e57);
                        let _e118 = words.member[_e84];
                        let _e127 = (bitcast<f32>((((_e118 << bitcast<u32>(16i)) & 2147483648u) | ((_e118 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e134 = (bitcast<f32>(((_e118 & 2147483648u) | ((_e118 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e138 = words.member[(_e84 + 16u)];
                        let _e147 = (bitcast<f32>((((_e138 << bitcast<u32>(16i)) & 2147483648u) | ((_e138 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e154 = (bitcast<f32>(((_e138 & 2147483648u) | ((_e138 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e157 = coefs.member[_e109];
                        let _e160 = coefs.member[_e115];
                        let _e174 = coefs.member[(_e76 + _e109)];
                        let _e178 = coefs.member[(_e76 + _e115)];
                        let _e189 = (2u * _e76);
                        let _e193 = coefs.member[(_e189 + _e109)];
                        let _e197 = coefs.member[(_e189 + _e115)];
                        phi_134_ = (_e82 + 2u);
                        phi_136_ = (_e84 + 32u);
                        phi_138_ = array<f32, 6>(((_e86[0] + (_e127 * _e157)) + (_e134 * _e160)), ((_e86[1] + (_e127 * _e174)) + (_e134 * _e178)), ((_e86[2] + (_e127 * _e193)) + (_e134 * _e197)), ((_e86[3] + (_e147 * _e157)) + (_e154 * _e160)), ((_e86[4] + (_e147 * _e174)) + (_e154 * _e178)), ((_e86[5] + (_e147 * _e193)) + (_e154 * _e197)));
                    } else {
                        phi_134_ = u32();
                        phi_136_ = u32();
                        phi_138_ = array<f32, 6>();
                    }
                    let _e212 = phi_134_;
                    let _e214 = phi_136_;
                    let _e216 = phi_138_;
                    continue;
                    continuing {
                        phi_130_ = _e99;
                        phi_133_ = _e212;
                        phi_135_ = _e214;
                        phi_137_ = _e216;
                        phi_312_ = false;
                        break if !(_e104);
                    }
                }
                let _e219 = phi_312_;
                if _e219 {
                    break;
                }
                let _e221 = local;
                partial.member[_e59] = _e221[0];
                let _e227 = local_1;
                partial.member[((_e44 * 16u) + _e59)] = _e227[1];
                let _e234 = local_2;
                partial.member[((_e44 * 32u) + _e59)] = _e234[2];
                let _e241 = local_3;
                partial.member[((_e44 * 48u) + _e59)] = _e241[3];
                let _e248 = local_4;
                partial.member[((_e44 * 64u) + _e59)] = _e248[4];
                let _e255 = local_5;
                partial.member[((_e44 * 80u) + _e59)] = _e255[5];
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_cluster(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
