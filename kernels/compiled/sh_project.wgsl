struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_15 {
    member: type_14,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_15;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(3) 
var<storage, read_write> coefs: type_5;
@group(0) @binding(1) 
var<storage> table: type_5;

fn function_() {
    var phi_80_: u32;
    var phi_99_: u32;
    var phi_163_: u32;
    var phi_188_: type_12;
    var phi_191_: array<f32, 12>;
    var phi_189_: type_12;
    var phi_214_: type_12;
    var phi_192_: array<f32, 12>;
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
            let _e30 = gid_1;
            let _e33 = params.member.member;
            let _e36 = params.member.member_2;
            let _e39 = (_e33 / 64u);
            if ((_e33 % 64u) > 0u) {
                phi_80_ = (_e39 + 1u);
            } else {
                phi_80_ = _e39;
            }
            let _e44 = phi_80_;
            let _e45 = (select(_e36, 9u, (_e36 > 9u)) + 1u);
            let _e46 = (_e45 * _e45);
            let _e47 = (_e46 / 4u);
            let _e49 = ((_e46 % 4u) > 0u);
            if _e49 {
                phi_99_ = (_e47 + 1u);
            } else {
                phi_99_ = _e47;
            }
            let _e52 = phi_99_;
            let _e53 = (_e44 * _e52);
            let _e54 = (_e53 * 64u);
            let _e58 = (_e30.x + (_e30.y * 2097152u));
            if (_e58 < _e54) {
                let _e60 = (_e58 / 64u);
                if _e49 {
                    phi_163_ = (_e47 + 1u);
                } else {
                    phi_163_ = _e47;
                }
                let _e65 = phi_163_;
                if (_e65 == 0u) {
                    break;
                }
                let _e67 = (_e60 / _e65);
                let _e72 = params.member.member_1;
                let _e73 = (_e67 * 64u);
                let _e80 = ((_e60 - (_e67 * _e65)) * _e72);
                let _e81 = (_e65 * _e72);
                phi_188_ = type_12(0u, _e72);
                phi_191_ = array<f32, 12>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e84 = phi_188_;
                    let _e86 = phi_191_;
                    local = _e86;
                    local_1 = _e86;
                    local_2 = _e86;
                    local_3 = _e86;
                    local_4 = _e86;
                    local_5 = _e86;
                    local_6 = _e86;
                    local_7 = _e86;
                    local_8 = _e86;
                    local_9 = _e86;
                    local_10 = _e86;
                    local_11 = _e86;
                    if (_e84.member < _e84.member_1) {
                        phi_189_ = type_12((_e84.member + 1u), _e84.member_1);
                        phi_214_ = type_12(1u, _e84.member);
                    } else {
                        phi_189_ = _e84;
                        phi_214_ = type_12(0u, type_12().member_1);
                    }
                    let _e99 = phi_189_;
                    let _e101 = phi_214_;
                    let _e105 = (bitcast<i32>(_e101.member) != 0i);
                    if _e105 {
                        let _e107 = ((((((_e73 / 64u) * _e72) * 192u) + (_e73 % 64u)) + (_e58 - (_e60 * 64u))) + (_e101.member_1 * 192u));
                        let _e110 = radiance.member[_e107];
                        let _e114 = radiance.member[(_e107 + 64u)];
                        let _e118 = radiance.member[(_e107 + 128u)];
                        let _e122 = table.member[(_e80 + _e101.member_1)];
                        let _e133 = table.member[((_e81 + _e80) + _e101.member_1)];
                        let _e145 = table.member[(((2u * _e81) + _e80) + _e101.member_1)];
                        let _e157 = table.member[(((3u * _e81) + _e80) + _e101.member_1)];
                        phi_192_ = array<f32, 12>(fma(_e110, _e122, _e86[0]), fma(_e110, _e133, _e86[1]), fma(_e110, _e145, _e86[2]), fma(_e110, _e157, _e86[3]), fma(_e114, _e122, _e86[4]), fma(_e114, _e133, _e86[5]), fma(_e114, _e145, _e86[6]), fma(_e114, _e157, _e86[7]), fma(_e118, _e122, _e86[8]), fma(_e118, _e133, _e86[9]), fma(_e118, _e145, _e86[10]), fma(_e118, _e157, _e86[11]));
                    } else {
                        phi_192_ = array<f32, 12>();
                    }
                    let _e166 = phi_192_;
                    continue;
                    continuing {
                        phi_188_ = _e99;
                        phi_191_ = _e166;
                        break if !(_e105);
                    }
                }
                let _e170 = params.member.member_3;
                let _e172 = local;
                let _e176 = local_1;
                let _e180 = local_2;
                let _e184 = local_3;
                let _e188 = local_4;
                let _e192 = local_5;
                let _e196 = local_6;
                let _e200 = local_7;
                let _e204 = local_8;
                let _e208 = local_9;
                let _e212 = local_10;
                let _e216 = local_11;
                coefs.member[_e58] = (_e172[0] * _e170);
                coefs.member[(_e54 + _e58)] = (_e176[1] * _e170);
                coefs.member[((_e53 * 128u) + _e58)] = (_e180[2] * _e170);
                coefs.member[((_e53 * 192u) + _e58)] = (_e184[3] * _e170);
                coefs.member[((_e53 * 256u) + _e58)] = (_e188[4] * _e170);
                coefs.member[((_e53 * 320u) + _e58)] = (_e192[5] * _e170);
                coefs.member[((_e53 * 384u) + _e58)] = (_e196[6] * _e170);
                coefs.member[((_e53 * 448u) + _e58)] = (_e200[7] * _e170);
                coefs.member[((_e53 * 512u) + _e58)] = (_e204[8] * _e170);
                coefs.member[((_e53 * 576u) + _e58)] = (_e208[9] * _e170);
                coefs.member[((_e53 * 640u) + _e58)] = (_e212[10] * _e170);
                coefs.member[((_e53 * 704u) + _e58)] = (_e216[11] * _e170);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_project(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
