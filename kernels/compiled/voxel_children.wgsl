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
@group(0) @binding(1) 
var<storage> cells: type_9;
@group(0) @binding(0) 
var<uniform> params: type_17;

fn function_() {
    var phi_88_: u32;
    var phi_92_: u32;
    var phi_95_: u32;
    var phi_93_: u32;
    var phi_96_: u32;
    var phi_326_: bool;
    var local: u32;
    var phi_141_: type_6;
    var phi_144_: u32;
    var phi_142_: type_6;
    var phi_167_: type_6;
    var phi_145_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_182_: u32;
    var local_3: u32;
    var phi_183_: u32;
    var phi_211_: bool;
    var phi_331_: bool;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e23 = gid_1;
            let _e25 = arrayLength((&cells.member));
            let _e31 = (_e23.x + (_e23.y * 2097152u));
            let _e32 = (_e31 < arrayLength((&out.member)));
            if _e32 {
                let _e35 = params.member.member_11;
                if (_e35 < 10u) {
                } else {
                    break;
                }
                let _e40 = params.member.member_2[_e35];
                if ((_e35 & 1u) == 1u) {
                    phi_88_ = (_e25 / 2u);
                } else {
                    let _e46 = params.member.member_10;
                    phi_88_ = _e46;
                }
                let _e49 = phi_88_;
                phi_92_ = _e49;
                phi_95_ = _e40.z;
                loop {
                    let _e51 = phi_92_;
                    let _e53 = phi_95_;
                    local = _e53;
                    local_3 = _e53;
                    local_6 = _e53;
                    let _e55 = ((_e51 - _e53) > 1u);
                    if _e55 {
                        let _e57 = ((_e53 + _e51) / 2u);
                        let _e59 = ((_e57 * 2u) + 1u);
                        if (_e59 < _e25) {
                        } else {
                            phi_326_ = true;
                            break;
                        }
                        let _e63 = cells.member[_e59];
                        let _e64 = (_e63 <= _e31);
                        phi_93_ = select(_e57, _e51, _e64);
                        phi_96_ = select(_e53, _e57, _e64);
                    } else {
                        phi_93_ = u32();
                        phi_96_ = u32();
                    }
                    let _e68 = phi_93_;
                    let _e70 = phi_96_;
                    continue;
                    continuing {
                        phi_92_ = _e68;
                        phi_95_ = _e70;
                        phi_326_ = false;
                        break if !(_e55);
                    }
                }
                let _e73 = phi_326_;
                if _e73 {
                    break;
                }
                let _e75 = local;
                let _e76 = (2u * _e75);
                if (_e76 < _e25) {
                } else {
                    break;
                }
                let _e80 = cells.member[_e76];
                let _e81 = (_e76 + 1u);
                if (_e81 < _e25) {
                } else {
                    break;
                }
                let _e85 = cells.member[_e81];
                phi_141_ = type_6(0u, (_e31 - _e85));
                phi_144_ = _e80;
                loop {
                    let _e89 = phi_141_;
                    let _e91 = phi_144_;
                    local_1 = _e91;
                    local_2 = _e91;
                    if (_e89.member < _e89.member_1) {
                        phi_142_ = type_6((_e89.member + 1u), _e89.member_1);
                        phi_167_ = type_6(1u, _e89.member);
                    } else {
                        phi_142_ = _e89;
                        phi_167_ = type_6(0u, type_6().member_1);
                    }
                    let _e104 = phi_142_;
                    let _e106 = phi_167_;
                    let _e109 = (bitcast<i32>(_e106.member) != 0i);
                    if _e109 {
                        phi_145_ = (_e91 & (_e91 - 1u));
                    } else {
                        phi_145_ = u32();
                    }
                    let _e113 = phi_145_;
                    continue;
                    continuing {
                        phi_141_ = _e104;
                        phi_144_ = _e113;
                        break if !(_e109);
                    }
                }
                let _e116 = local_1;
                let _e119 = local_2;
                let _e121 = select(firstTrailingBit(_e116), 32u, (_e119 == 0u));
                phi_182_ = _e35;
                loop {
                    let _e123 = phi_182_;
                    local_4 = _e123;
                    local_5 = _e123;
                    local_7 = _e123;
                    let _e124 = (_e123 + 2u);
                    let _e128 = params.member.member_1[3u];
                    if (_e124 < _e128) {
                        if (_e124 < 10u) {
                        } else {
                            phi_331_ = true;
                            break;
                        }
                        let _e134 = params.member.member_2[_e124];
                        let _e137 = local_3;
                        let _e138 = (_e134.z <= _e137);
                        phi_183_ = select(u32(), _e124, _e138);
                        phi_211_ = _e138;
                    } else {
                        phi_183_ = u32();
                        phi_211_ = false;
                    }
                    let _e141 = phi_183_;
                    let _e143 = phi_211_;
                    continue;
                    continuing {
                        phi_182_ = _e141;
                        phi_331_ = _e73;
                        break if !(_e143);
                    }
                }
                let _e146 = phi_331_;
                if _e146 {
                    break;
                }
                let _e148 = local_4;
                if (_e148 < 10u) {
                } else {
                    break;
                }
                let _e153 = local_5;
                let _e155 = params.member.member_2[_e153];
                let _e158 = local_6;
                let _e159 = (_e158 - _e155.z);
                if (_e155.y == 0u) {
                    break;
                }
                let _e162 = (_e159 / _e155.y);
                let _e164 = (_e159 - (_e162 * _e155.y));
                if (_e155.x == 0u) {
                    break;
                }
                let _e167 = (_e164 / _e155.x);
                let _e175 = (_e121 >> bitcast<u32>(2i));
                let _e192 = (((((_e164 - (_e167 * _e155.x)) << bitcast<u32>(2i)) | (_e121 & 1u)) | (_e175 & 2u)) * 2u);
                let _e193 = ((((_e167 << bitcast<u32>(2i)) | ((_e121 >> bitcast<u32>(1i)) & 1u)) | ((_e121 >> bitcast<u32>(3i)) & 2u)) * 2u);
                let _e194 = (((_e162 << bitcast<u32>(1i)) | (_e175 & 1u)) * 2u);
                let _e196 = local_7;
                let _e197 = (_e196 - 1u);
                if (_e197 < 10u) {
                } else {
                    break;
                }
                let _e202 = params.member.member_2[_e197];
                if _e32 {
                } else {
                    break;
                }
                out.member[_e31] = (((((_e202.z + (_e192 >> bitcast<u32>(2i))) + (_e202.x * (_e193 >> bitcast<u32>(2i)))) + (_e202.y * (_e194 >> bitcast<u32>(1i)))) * 4u) + ((((((_e192 & 1u) | ((_e193 & 1u) << bitcast<u32>(1i))) | ((_e194 & 1u) << bitcast<u32>(2i))) | ((_e192 & 2u) << bitcast<u32>(2i))) | ((_e193 & 2u) << bitcast<u32>(3i))) / 8u));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_children(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
