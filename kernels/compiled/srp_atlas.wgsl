struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: array<u32>,
}

struct type_19 {
    member: array<vec4<f32>>,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: array<u32, 4>,
    member_1: array<f32, 4>,
}

struct type_26 {
    member: array<type_24>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_22;
@group(0) @binding(1) 
var<storage> map: type_11;
@group(0) @binding(2) 
var<storage> blends: type_26;
@group(0) @binding(3) 
var<storage> irradiance: type_5;
@group(0) @binding(4) 
var<storage, read_write> texels: type_19;

fn function_() {
    var phi_291_: vec4<f32>;
    var phi_292_: vec4<f32>;
    var phi_294_: vec4<f32>;
    var phi_295_: vec4<f32>;
    var phi_296_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = gid_1;
            let _e28 = arrayLength((&irradiance.member));
            let _e33 = params.member.member;
            let _e37 = (_e22.x + (_e22.y * 2097152u));
            if (_e37 < _e33) {
                if (_e37 < arrayLength((&map.member))) {
                } else {
                    break;
                }
                let _e42 = map.member[_e37];
                if (_e42 == 4294967295u) {
                    phi_294_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_295_ = vec4<f32>();
                    phi_296_ = true;
                } else {
                    let _e45 = ((_e42 & 2147483648u) == 0u);
                    if _e45 {
                        let _e177 = params.member.member_1;
                        if (_e42 < _e28) {
                        } else {
                            break;
                        }
                        let _e181 = irradiance.member[_e42];
                        let _e182 = (_e177 + _e42);
                        if (_e182 < _e28) {
                        } else {
                            break;
                        }
                        let _e186 = irradiance.member[_e182];
                        let _e188 = ((2u * _e177) + _e42);
                        if (_e188 < _e28) {
                        } else {
                            break;
                        }
                        let _e192 = irradiance.member[_e188];
                        phi_291_ = vec4<f32>(_e181, _e186, _e192, 1f);
                        phi_292_ = vec4<f32>();
                    } else {
                        let _e46 = (_e42 & 2147483647u);
                        if (_e46 < arrayLength((&blends.member))) {
                        } else {
                            break;
                        }
                        let _e50 = params.member.member_1;
                        let _e55 = blends.member[_e46].member[0u];
                        let _e60 = blends.member[_e46].member_1[0u];
                        if (_e55 < _e28) {
                        } else {
                            break;
                        }
                        let _e64 = irradiance.member[_e55];
                        let _e65 = (_e50 + _e55);
                        if (_e65 < _e28) {
                        } else {
                            break;
                        }
                        let _e69 = irradiance.member[_e65];
                        let _e70 = (2u * _e50);
                        let _e71 = (_e70 + _e55);
                        if (_e71 < _e28) {
                        } else {
                            break;
                        }
                        let _e75 = irradiance.member[_e71];
                        let _e83 = blends.member[_e46].member[1u];
                        let _e88 = blends.member[_e46].member_1[1u];
                        if (_e83 < _e28) {
                        } else {
                            break;
                        }
                        let _e92 = irradiance.member[_e83];
                        let _e93 = (_e50 + _e83);
                        if (_e93 < _e28) {
                        } else {
                            break;
                        }
                        let _e97 = irradiance.member[_e93];
                        let _e98 = (_e70 + _e83);
                        if (_e98 < _e28) {
                        } else {
                            break;
                        }
                        let _e102 = irradiance.member[_e98];
                        let _e114 = blends.member[_e46].member[2u];
                        let _e119 = blends.member[_e46].member_1[2u];
                        if (_e114 < _e28) {
                        } else {
                            break;
                        }
                        let _e123 = irradiance.member[_e114];
                        let _e124 = (_e50 + _e114);
                        if (_e124 < _e28) {
                        } else {
                            break;
                        }
                        let _e128 = irradiance.member[_e124];
                        let _e129 = (_e70 + _e114);
                        if (_e129 < _e28) {
                        } else {
                            break;
                        }
                        let _e133 = irradiance.member[_e129];
                        let _e145 = blends.member[_e46].member[3u];
                        let _e150 = blends.member[_e46].member_1[3u];
                        if (_e145 < _e28) {
                        } else {
                            break;
                        }
                        let _e154 = irradiance.member[_e145];
                        let _e155 = (_e50 + _e145);
                        if (_e155 < _e28) {
                        } else {
                            break;
                        }
                        let _e159 = irradiance.member[_e155];
                        let _e160 = (_e70 + _e145);
                        if (_e160 < _e28) {
                        } else {
                            break;
                        }
                        let _e164 = irradiance.member[_e160];
                        phi_291_ = vec4<f32>();
                        phi_292_ = vec4<f32>(((((_e60 * _e64) + (_e88 * _e92)) + (_e119 * _e123)) + (_e150 * _e154)), ((((_e60 * _e69) + (_e88 * _e97)) + (_e119 * _e128)) + (_e150 * _e159)), ((((_e60 * _e75) + (_e88 * _e102)) + (_e119 * _e133)) + (_e150 * _e164)), select(0f, 1f, ((((_e60 + _e88) + _e119) + _e150) > 0f)));
                    }
                    let _e195 = phi_291_;
                    let _e197 = phi_292_;
                    phi_294_ = _e197;
                    phi_295_ = _e195;
                    phi_296_ = select(true, false, _e45);
                }
                let _e200 = phi_294_;
                let _e202 = phi_295_;
                let _e204 = phi_296_;
                if (_e37 < arrayLength((&texels.member))) {
                } else {
                    break;
                }
                texels.member[_e37] = select(_e202, _e200, vec4(_e204));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_atlas(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
