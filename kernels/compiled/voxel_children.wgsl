struct type_7 {
    member: array<u32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
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
var<storage, read_write> out: type_7;
@group(0) @binding(1) 
var<storage> cells: type_7;
@group(0) @binding(0) 
var<uniform> params: type_17;

fn function_() {
    var phi_83_: u32;
    var phi_87_: u32;
    var phi_90_: u32;
    var phi_88_: u32;
    var phi_91_: u32;
    var phi_302_: bool;
    var local: u32;
    var phi_136_: type_10;
    var phi_139_: u32;
    var phi_137_: type_10;
    var phi_162_: type_10;
    var phi_140_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_177_: u32;
    var local_3: u32;
    var phi_178_: u32;
    var phi_201_: bool;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e23 = gid_1;
            let _e25 = arrayLength((&cells.member));
            let _e31 = (_e23.x + (_e23.y * 2097152u));
            let _e32 = (_e31 < arrayLength((&out.member)));
            if _e32 {
                let _e35 = params.member.member_11;
                let _e39 = params.member.member_2[_e35];
                if ((_e35 & 1u) == 1u) {
                    phi_83_ = (_e25 / 2u);
                } else {
                    let _e45 = params.member.member_10;
                    phi_83_ = _e45;
                }
                let _e48 = phi_83_;
                phi_87_ = _e48;
                phi_90_ = _e39.z;
                loop {
                    let _e50 = phi_87_;
                    let _e52 = phi_90_;
                    local = _e52;
                    local_3 = _e52;
                    local_5 = _e52;
                    let _e54 = ((_e50 - _e52) > 1u);
                    if _e54 {
                        let _e56 = ((_e52 + _e50) / 2u);
                        let _e58 = ((_e56 * 2u) + 1u);
                        if (_e58 < _e25) {
                        } else {
                            phi_302_ = true;
                            break;
                        }
                        let _e62 = cells.member[_e58];
                        let _e63 = (_e62 <= _e31);
                        phi_88_ = select(_e56, _e50, _e63);
                        phi_91_ = select(_e52, _e56, _e63);
                    } else {
                        phi_88_ = u32();
                        phi_91_ = u32();
                    }
                    let _e67 = phi_88_;
                    let _e69 = phi_91_;
                    continue;
                    continuing {
                        phi_87_ = _e67;
                        phi_90_ = _e69;
                        phi_302_ = false;
                        break if !(_e54);
                    }
                }
                let _e72 = phi_302_;
                if _e72 {
                    break;
                }
                let _e74 = local;
                let _e75 = (2u * _e74);
                if (_e75 < _e25) {
                } else {
                    break;
                }
                let _e79 = cells.member[_e75];
                let _e80 = (_e75 + 1u);
                if (_e80 < _e25) {
                } else {
                    break;
                }
                let _e84 = cells.member[_e80];
                phi_136_ = type_10(0u, (_e31 - _e84));
                phi_139_ = _e79;
                loop {
                    let _e88 = phi_136_;
                    let _e90 = phi_139_;
                    local_1 = _e90;
                    local_2 = _e90;
                    if (_e88.member < _e88.member_1) {
                        phi_137_ = type_10((_e88.member + 1u), _e88.member_1);
                        phi_162_ = type_10(1u, _e88.member);
                    } else {
                        phi_137_ = _e88;
                        phi_162_ = type_10(0u, type_10().member_1);
                    }
                    let _e103 = phi_137_;
                    let _e105 = phi_162_;
                    let _e108 = (bitcast<i32>(_e105.member) != 0i);
                    if _e108 {
                        phi_140_ = (_e90 & (_e90 - 1u));
                    } else {
                        phi_140_ = u32();
                    }
                    let _e112 = phi_140_;
                    continue;
                    continuing {
                        phi_136_ = _e103;
                        phi_139_ = _e112;
                        break if !(_e108);
                    }
                }
                let _e115 = local_1;
                let _e118 = local_2;
                let _e120 = select(firstTrailingBit(_e115), 32u, (_e118 == 0u));
                phi_177_ = _e35;
                loop {
                    let _e122 = phi_177_;
                    local_4 = _e122;
                    local_6 = _e122;
                    let _e123 = (_e122 + 2u);
                    let _e127 = params.member.member_1[3u];
                    if (_e123 < _e127) {
                        let _e132 = params.member.member_2[_e123];
                        let _e135 = local_3;
                        let _e136 = (_e132.z <= _e135);
                        phi_178_ = select(u32(), _e123, _e136);
                        phi_201_ = _e136;
                    } else {
                        phi_178_ = u32();
                        phi_201_ = false;
                    }
                    let _e139 = phi_178_;
                    let _e141 = phi_201_;
                    continue;
                    continuing {
                        phi_177_ = _e139;
                        break if !(_e141);
                    }
                }
                let _e146 = local_4;
                let _e148 = params.member.member_2[_e146];
                let _e151 = local_5;
                let _e152 = (_e151 - _e148.z);
                if (_e148.y == 0u) {
                    break;
                }
                let _e155 = (_e152 / _e148.y);
                let _e157 = (_e152 - (_e155 * _e148.y));
                if (_e148.x == 0u) {
                    break;
                }
                let _e160 = (_e157 / _e148.x);
                let _e168 = (_e120 >> bitcast<u32>(2i));
                let _e185 = (((((_e157 - (_e160 * _e148.x)) << bitcast<u32>(2i)) | (_e120 & 1u)) | (_e168 & 2u)) * 2u);
                let _e186 = ((((_e160 << bitcast<u32>(2i)) | ((_e120 >> bitcast<u32>(1i)) & 1u)) | ((_e120 >> bitcast<u32>(3i)) & 2u)) * 2u);
                let _e187 = (((_e155 << bitcast<u32>(1i)) | (_e168 & 1u)) * 2u);
                let _e189 = local_6;
                let _e194 = params.member.member_2[(_e189 - 1u)];
                if _e32 {
                } else {
                    break;
                }
                out.member[_e31] = (((((_e194.z + (_e185 >> bitcast<u32>(2i))) + (_e194.x * (_e186 >> bitcast<u32>(2i)))) + (_e194.y * (_e187 >> bitcast<u32>(1i)))) * 4u) + ((((((_e185 & 1u) | ((_e186 & 1u) << bitcast<u32>(1i))) | ((_e187 & 1u) << bitcast<u32>(2i))) | ((_e185 & 2u) << bitcast<u32>(2i))) | ((_e186 & 2u) << bitcast<u32>(3i))) / 8u));
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
