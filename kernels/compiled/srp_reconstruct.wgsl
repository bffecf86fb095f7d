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
var<storage> blocks: type_22;
@group(0) @binding(2) 
var<storage> words: type_11;
@group(0) @binding(3) 
var<storage> basis: type_5;
@group(0) @binding(4) 
var<storage, read_write> irradiance: type_5;

fn function_() {
    var phi_124_: type_14;
    var phi_127_: u32;
    var phi_129_: u32;
    var phi_131_: array<f32, 3>;
    var phi_125_: type_14;
    var phi_154_: type_14;
    var phi_128_: u32;
    var phi_130_: u32;
    var phi_132_: array<f32, 3>;
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;

    switch bitcast<i32>(0u) {
        default: {
            let _e30 = gid_1;
            let _e35 = params.member.member;
            let _e39 = params.member.member_2;
            let _e43 = params.member.member_1;
            let _e47 = (_e30.x + (_e30.y * 2097152u));
            if (_e47 < (_e43 * 16u)) {
                let _e50 = (_e47 / 16u);
                let _e51 = (_e50 * 16u);
                let _e52 = (_e47 - _e51);
                let _e54 = (((_e35 * 16u) + _e51) + _e52);
                let _e55 = (_e35 + _e50);
                if (_e55 < arrayLength((&blocks.member))) {
                } else {
                    break;
                }
                let _e60 = blocks.member[_e55].member;
                let _e64 = blocks.member[_e55].member_1;
                let _e68 = blocks.member[_e55].member_2;
                phi_124_ = type_14(0u, _e64);
                phi_127_ = (4u * _e68);
                phi_129_ = (_e60 + _e52);
                phi_131_ = array<f32, 3>(0f, 0f, 0f);
                loop {
                    let _e73 = phi_124_;
                    let _e75 = phi_127_;
                    let _e77 = phi_129_;
                    let _e79 = phi_131_;
                    local = _e79;
                    local_1 = _e79;
                    local_2 = _e79;
                    if (_e73.member < _e73.member_1) {
                        phi_125_ = type_14((_e73.member + 1u), _e73.member_1);
                        phi_154_ = type_14(1u, _e73.member);
                    } else {
                        phi_125_ = _e73;
                        phi_154_ = type_14(0u, type_14().member_1);
                    }
                    let _e92 = phi_125_;
                    let _e94 = phi_154_;
                    let _e97 = (bitcast<i32>(_e94.member) != 0i);
                    if _e97 {
                        let _e100 = words.member[_e77];
                        let _e109 = (bitcast<f32>((((_e100 << bitcast<u32>(16i)) & 2147483648u) | ((_e100 << bitcast<u32>(13i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e116 = (bitcast<f32>(((_e100 & 2147483648u) | ((_e100 >> bitcast<u32>(3i)) & 268427264u))) * 5192297000000000000000000000000000f);
                        let _e120 = basis.member[_e75];
                        let _e126 = basis.member[(_e75 + 4u)];
                        let _e133 = basis.member[(_e75 + 1u)];
                        let _e139 = basis.member[(_e75 + 5u)];
                        let _e146 = basis.member[(_e75 + 2u)];
                        let _e152 = basis.member[(_e75 + 6u)];
                        phi_128_ = (_e75 + 8u);
                        phi_130_ = (_e77 + 16u);
                        phi_132_ = array<f32, 3>(((_e79[0] + (_e109 * _e120)) + (_e116 * _e126)), ((_e79[1] + (_e109 * _e133)) + (_e116 * _e139)), ((_e79[2] + (_e109 * _e146)) + (_e116 * _e152)));
                    } else {
                        phi_128_ = u32();
                        phi_130_ = u32();
                        phi_132_ = array<f32, 3>();
                    }
                    let _e159 = phi_128_;
                    let _e161 = phi_130_;
                    let _e163 = phi_132_;
                    continue;
                    continuing {
                        phi_124_ = _e92;
                        phi_127_ = _e159;
                        phi_129_ = _e161;
                        phi_131_ = _e163;
                        break if !(_e97);
                    }
                }
                let _e166 = local;
                irradiance.member[_e54] = _e166[0];
                let _e172 = local_1;
                irradiance.member[((_e39 * 16u) + _e54)] = _e172[1];
                let _e179 = local_2;
                irradiance.member[((_e39 * 32u) + _e54)] = _e179[2];
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
