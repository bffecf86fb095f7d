struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_15 {
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
var<storage> blocks: type_22;
@group(0) @binding(2) 
var<storage> words: type_11;
@group(0) @binding(3) 
var<storage> basis: type_5;
@group(0) @binding(4) 
var<storage, read_write> radiance: type_5;

fn function_() {
    var phi_133_: type_15;
    var phi_136_: u32;
    var phi_138_: u32;
    var phi_140_: array<f32, 12>;
    var phi_134_: type_15;
    var phi_163_: type_15;
    var phi_137_: u32;
    var phi_139_: u32;
    var phi_141_: array<f32, 12>;
    var local: array<f32, 12>;
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

    switch bitcast<i32>(0u) {
        default: {
            let _e39 = gid_1;
            let _e44 = params.member.member;
            let _e48 = params.member.member_2;
            let _e52 = params.member.member_1;
            let _e56 = (_e39.x + (_e39.y * 2097152u));
            if (_e56 < (_e52 * 16u)) {
                let _e59 = (_e56 / 16u);
                let _e60 = (_e59 * 16u);
                let _e61 = (_e56 - _e60);
                let _e63 = (((_e44 * 16u) + _e60) + _e61);
                let _e64 = (_e44 + _e59);
                if (_e64 < arrayLength((&blocks.member))) {
                } else {
                    break;
                }
                let _e69 = blocks.member[_e64].member;
                let _e73 = blocks.member[_e64].member_1;
                let _e77 = blocks.member[_e64].member_2;
                phi_133_ = type_15(0u, _e73);
                phi_136_ = (4u * _e77);
                phi_138_ = (_e69 + _e61);
                phi_140_ = array<f32, 12>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e82 = phi_133_;
                    let _e84 = phi_136_;
                    let _e86 = phi_138_;
                    let _e88 = phi_140_;
                    local = _e88;
                    local_1 = _e88;
                    local_2 = _e88;
                    local_3 = _e88;
                    local_4 = _e88;
                    local_5 = _e88;
                    local_6 = _e88;
                    local_7 = _e88;
                    local_8 = _e88;
                    local_9 = _e88;
                    local_10 = _e88;
                    local_11 = _e88;
                    if (_e82.member < _e82.member_1) {
                        phi_134_ = type_15((_e82.member + 1u), _e82.member_1);
                        phi_163_ = type_15(1u, _e82.member);
                    } else {
                        phi_134_ = _e82;
                        phi_163_ = type_15(0u, type_15().member_1);
                    }
                    let _e101 = phi_134_;
                    let _e103 = phi_163_;
                    let _e106 = (bitcast<i32>(_e103.member) != 0i);
                    if _e106 {
                        let _e109 = words.member[_e86];
                        let _e118 = (bitcast<f32>((((_e109 << bitcast<u32>(16i)) & 2147483648u) | ((_e109 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e125 = (bitcast<f32>(((_e109 & 2147483648u) | ((_e109 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e129 = basis.member[_e84];
                        let _e135 = basis.member[(_e84 + 4u)];
                        let _e142 = basis.member[(_e84 + 1u)];
                        let _e148 = basis.member[(_e84 + 5u)];
                        let _e155 = basis.member[(_e84 + 2u)];
                        let _e161 = basis.member[(_e84 + 6u)];
                        let _e167 = words.member[(_e86 + 16u)];
                        let _e176 = (bitcast<f32>((((_e167 << bitcast<u32>(16i)) & 2147483648u) | ((_e167 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e183 = (bitcast<f32>(((_e167 & 2147483648u) | ((_e167 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e202 = words.member[(_e86 + 32u)];
                        let _e211 = (bitcast<f32>((((_e202 << bitcast<u32>(16i)) & 2147483648u) | ((_e202 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e218 = (bitcast<f32>(((_e202 & 2147483648u) | ((_e202 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e237 = words.member[(_e86 + 48u)];
                        let _e246 = (bitcast<f32>((((_e237 << bitcast<u32>(16i)) & 2147483648u) | ((_e237 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e253 = (bitcast<f32>(((_e237 & 2147483648u) | ((_e237 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        phi_137_ = (_e84 + 8u);
                        phi_139_ = (_e86 + 64u);
                        phi_141_ = array<f32, 12>(((_e88[0] + (_e118 * _e129)) + (_e125 * _e135)), ((_e88[1] + (_e118 * _e142)) + (_e125 * _e148)), ((_e88[2] + (_e118 * _e155)) + (_e125 * _e161)), ((_e88[3] + (_e176 * _e129)) + (_e183 * _e135)), ((_e88[4] + (_e176 * _e142)) + (_e183 * _e148)), ((_e88[5] + (_e176 * _e155)) + (_e183 * _e161)), ((_e88[6] + (_e211 * _e129)) + (_e218 * _e135)), ((_e88[7] + (_e211 * _e142)) + (_e218 * _e148)), ((_e88[8] + (_e211 * _e155)) + (_e218 * _e161)), ((_e88[9] + (_e246 * _e129)) + (_e253 * _e135)), ((_e88[10] + (_e246 * _e142)) + (_e253 * _e148)), ((_e88[11] + (_e246 * _e155)) + (_e253 * _e161)));
                    } else {
                        phi_137_ = u32();
                        phi_139_ = u32();
                        phi_141_ = array<f32, 12>();
                    }
                    let _e273 = phi_137_;
                    let _e275 = phi_139_;
                    let _e277 = phi_141_;
                    continue;
                    continuing {
                        phi_133_ = _e101;
                        phi_136_ = _e273;
                        phi_138_ = _e275;
                        phi_140_ = _e277;
                        break if !(_e106);
                    }
                }
                let _e280 = local;
                radiance.member[_e63] = _e280[0];
                let _e286 = local_1;
                radiance.member[((_e48 * 16u) + _e63)] = _e286[1];
                let _e293 = local_2;
                radiance.member[((_e48 * 32u) + _e63)] = _e293[2];
                let _e300 = local_3;
                radiance.member[((_e48 * 48u) + _e63)] = _e300[3];
                let _e307 = local_4;
                radiance.member[((_e48 * 64u) + _e63)] = _e307[4];
                let _e314 = local_5;
                radiance.member[((_e48 * 80u) + _e63)] = _e314[5];
                let _e321 = local_6;
                radiance.member[((_e48 * 96u) + _e63)] = _e321[6];
                let _e328 = local_7;
                radiance.member[((_e48 * 112u) + _e63)] = _e328[7];
                let _e335 = local_8;
                radiance.member[((_e48 * 128u) + _e63)] = _e335[8];
                let _e342 = local_9;
                radiance.member[((_e48 * 144u) + _e63)] = _e342[9];
                let _e349 = local_10;
                radiance.member[((_e48 * 160u) + _e63)] = _e349[10];
                let _e356 = local_11;
                radiance.member[((_e48 * 176u) + _e63)] = _e356[11];
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_reconstruct_directional(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
