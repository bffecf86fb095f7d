struct type_7 {
    member: array<u32>,
}

struct type_15 {
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

struct type_16 {
    member: type_15,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_7;
@group(0) @binding(1) 
var<storage> cells: type_7;
@group(0) @binding(0) 
var<uniform> params: type_16;

fn function_() {
    var phi_80_: u32;
    var phi_83_: u32;
    var phi_86_: u32;
    var phi_84_: u32;
    var phi_87_: u32;
    var phi_356_: bool;
    var local: u32;
    var phi_140_: u32;
    var phi_145_: u32;
    var phi_162_: u32;
    var phi_167_: u32;
    var phi_184_: u32;
    var phi_189_: u32;
    var phi_206_: u32;
    var phi_211_: u32;
    var phi_231_: u32;
    var local_1: u32;
    var phi_232_: u32;
    var phi_255_: bool;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = gid_1;
            let _e26 = arrayLength((&cells.member));
            let _e32 = (_e24.x + (_e24.y * 2097152u));
            let _e33 = (_e32 < arrayLength((&out.member)));
            if _e33 {
                let _e36 = params.member.member_11;
                let _e40 = params.member.member_2[_e36];
                if ((_e36 & 1u) == 1u) {
                    phi_80_ = (_e26 / 2u);
                } else {
                    let _e46 = params.member.member_10;
                    phi_80_ = _e46;
                }
                let _e49 = phi_80_;
                phi_83_ = (_e49 - _e40.z);
                phi_86_ = _e40.z;
                loop {
                    let _e52 = phi_83_;
                    let _e54 = phi_86_;
                    local = _e54;
                    local_1 = _e54;
                    local_3 = _e54;
                    let _e55 = (_e52 > 1u);
                    if _e55 {
                        let _e56 = (_e52 / 2u);
                        let _e57 = (_e54 + _e56);
                        let _e59 = ((_e57 * 2u) + 1u);
                        if (_e59 < _e26) {
                        } else {
                            phi_356_ = true;
                            break;
                        }
                        let _e63 = cells.member[_e59];
                        phi_84_ = (_e52 - _e56);
                        phi_87_ = select(_e54, _e57, (_e63 <= _e32));
                    } else {
                        phi_84_ = u32();
                        phi_87_ = u32();
                    }
                    let _e68 = phi_84_;
                    let _e70 = phi_87_;
                    continue;
                    continuing {
                        phi_83_ = _e68;
                        phi_86_ = _e70;
                        phi_356_ = false;
                        break if !(_e55);
                    }
                }
                let _e73 = phi_356_;
                if _e73 {
                    break;
                }
                let _e75 = local;
                let _e76 = (2u * _e75);
                if (_e76 < _e26) {
                } else {
                    break;
                }
                let _e80 = cells.member[_e76];
                let _e81 = (_e76 + 1u);
                if (_e81 < _e26) {
                } else {
                    break;
                }
                let _e85 = cells.member[_e81];
                let _e86 = (_e32 - _e85);
                let _e88 = countOneBits((_e80 & 65535u));
                let _e89 = (_e86 >= _e88);
                if _e89 {
                    phi_140_ = (_e80 >> bitcast<u32>(16u));
                } else {
                    phi_140_ = _e80;
                }
                let _e93 = phi_140_;
                if _e89 {
                    phi_145_ = (_e86 - _e88);
                } else {
                    phi_145_ = _e86;
                }
                let _e96 = phi_145_;
                let _e99 = countOneBits((_e93 & 255u));
                let _e100 = (_e96 >= _e99);
                if _e100 {
                    phi_162_ = (_e93 >> bitcast<u32>(8u));
                } else {
                    phi_162_ = _e93;
                }
                let _e104 = phi_162_;
                if _e100 {
                    phi_167_ = (_e96 - _e99);
                } else {
                    phi_167_ = _e96;
                }
                let _e107 = phi_167_;
                let _e111 = countOneBits((_e104 & 15u));
                let _e112 = (_e107 >= _e111);
                if _e112 {
                    phi_184_ = (_e104 >> bitcast<u32>(4u));
                } else {
                    phi_184_ = _e104;
                }
                let _e116 = phi_184_;
                if _e112 {
                    phi_189_ = (_e107 - _e111);
                } else {
                    phi_189_ = _e107;
                }
                let _e119 = phi_189_;
                let _e123 = countOneBits((_e116 & 3u));
                let _e124 = (_e119 >= _e123);
                if _e124 {
                    phi_206_ = (_e116 >> bitcast<u32>(2u));
                } else {
                    phi_206_ = _e116;
                }
                let _e128 = phi_206_;
                if _e124 {
                    phi_211_ = (_e119 - _e123);
                } else {
                    phi_211_ = _e119;
                }
                let _e131 = phi_211_;
                let _e138 = ((((select(0u, 16u, _e89) + select(0u, 8u, _e100)) + select(0u, 4u, _e112)) + select(0u, 2u, _e124)) + select(0u, 1u, (_e131 >= countOneBits((_e128 & 1u)))));
                phi_231_ = _e36;
                loop {
                    let _e140 = phi_231_;
                    local_2 = _e140;
                    local_4 = _e140;
                    let _e141 = (_e140 + 2u);
                    let _e145 = params.member.member_1[3u];
                    if (_e141 < _e145) {
                        let _e150 = params.member.member_2[_e141];
                        let _e153 = local_1;
                        let _e154 = (_e150.z <= _e153);
                        phi_232_ = select(u32(), _e141, _e154);
                        phi_255_ = _e154;
                    } else {
                        phi_232_ = u32();
                        phi_255_ = false;
                    }
                    let _e157 = phi_232_;
                    let _e159 = phi_255_;
                    continue;
                    continuing {
                        phi_231_ = _e157;
                        break if !(_e159);
                    }
                }
                let _e164 = local_2;
                let _e166 = params.member.member_2[_e164];
                let _e169 = local_3;
                let _e170 = (_e169 - _e166.z);
                if (_e166.y == 0u) {
                    break;
                }
                let _e173 = (_e170 / _e166.y);
                let _e175 = (_e170 - (_e173 * _e166.y));
                if (_e166.x == 0u) {
                    break;
                }
                let _e178 = (_e175 / _e166.x);
                let _e186 = (_e138 >> bitcast<u32>(2i));
                let _e203 = (((((_e175 - (_e178 * _e166.x)) << bitcast<u32>(2i)) | (_e138 & 1u)) | (_e186 & 2u)) * 2u);
                let _e204 = ((((_e178 << bitcast<u32>(2i)) | ((_e138 >> bitcast<u32>(1i)) & 1u)) | ((_e138 >> bitcast<u32>(3i)) & 2u)) * 2u);
                let _e205 = (((_e173 << bitcast<u32>(1i)) | (_e186 & 1u)) * 2u);
                let _e207 = local_4;
                let _e212 = params.member.member_2[(_e207 - 1u)];
                if _e33 {
                } else {
                    break;
                }
                out.member[_e32] = (((((_e212.z + (_e203 >> bitcast<u32>(2i))) + (_e212.x * (_e204 >> bitcast<u32>(2i)))) + (_e212.y * (_e205 >> bitcast<u32>(1i)))) * 4u) + ((((((_e203 & 1u) | ((_e204 & 1u) << bitcast<u32>(1i))) | ((_e205 & 1u) << bitcast<u32>(2i))) | ((_e203 & 2u) << bitcast<u32>(2i))) | ((_e204 & 2u) << bitcast<u32>(3i))) / 8u));
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
