struct type_8 {
    member: array<u32>,
}

struct type_15 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_23 {
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

struct type_24 {
    member: type_23,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> cells: type_8;
@group(0) @binding(2) 
var<storage> facet_bits: type_8;
@group(0) @binding(0) 
var<uniform> params: type_24;
@group(0) @binding(3) 
var<storage> sums: type_8;
@group(0) @binding(4) 
var<storage, read_write> out: type_17;

fn function_() {
    var phi_88_: u32;
    var phi_91_: u32;
    var phi_89_: u32;
    var phi_92_: u32;
    var phi_504_: bool;
    var local: u32;
    var local_1: u32;
    var phi_181_: u32;
    var phi_184_: u32;
    var phi_186_: u32;
    var phi_188_: u32;
    var phi_248_: u32;
    var phi_249_: u32;
    var phi_250_: u32;
    var phi_251_: u32;
    var phi_182_: u32;
    var phi_185_: u32;
    var phi_187_: u32;
    var phi_189_: u32;
    var phi_253_: bool;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = gid_1;
            let _e33 = arrayLength((&cells.member));
            let _e35 = arrayLength((&sums.member));
            let _e41 = (_e31.x + (_e31.y * 2097152u));
            let _e42 = (_e41 < arrayLength((&out.member)));
            if _e42 {
                let _e47 = params.member.member_2[0u][3u];
                phi_88_ = _e47;
                phi_91_ = 0u;
                loop {
                    let _e49 = phi_88_;
                    let _e51 = phi_91_;
                    local = _e51;
                    local_1 = _e51;
                    local_2 = _e51;
                    local_3 = _e51;
                    let _e53 = ((_e49 - _e51) > 1u);
                    if _e53 {
                        let _e55 = ((_e51 + _e49) / 2u);
                        let _e57 = ((_e55 * 2u) + 1u);
                        if (_e57 < _e33) {
                        } else {
                            phi_504_ = true;
                            break;
                        }
                        let _e61 = cells.member[_e57];
                        let _e62 = (_e61 <= _e41);
                        phi_89_ = select(_e55, _e49, _e62);
                        phi_92_ = select(_e51, _e55, _e62);
                    } else {
                        phi_89_ = u32();
                        phi_92_ = u32();
                    }
                    let _e66 = phi_89_;
                    let _e68 = phi_92_;
                    continue;
                    continuing {
                        phi_88_ = _e66;
                        phi_91_ = _e68;
                        phi_504_ = false;
                        break if !(_e53);
                    }
                }
                let _e71 = phi_504_;
                if _e71 {
                    break;
                }
                let _e73 = local;
                let _e74 = (2u * _e73);
                if (_e74 < _e33) {
                } else {
                    break;
                }
                let _e78 = cells.member[_e74];
                let _e79 = (_e74 + 1u);
                if (_e79 < _e33) {
                } else {
                    break;
                }
                let _e83 = cells.member[_e79];
                let _e88 = (select(firstTrailingBit(_e78), 32u, (_e78 == 0u)) & 31u);
                let _e90 = local_1;
                let _e91 = (_e90 * 6u);
                let _e94 = facet_bits.member[_e91];
                let _e95 = (_e88 & 31u);
                let _e102 = facet_bits.member[(_e91 + 1u)];
                let _e110 = facet_bits.member[(_e91 + 2u)];
                let _e118 = facet_bits.member[(_e91 + 3u)];
                let _e126 = facet_bits.member[(_e91 + 4u)];
                let _e134 = facet_bits.member[(_e91 + 5u)];
                phi_181_ = (((((((_e94 >> bitcast<u32>(_e95)) & 1u) + ((_e102 >> bitcast<u32>(_e95)) & 1u)) + ((_e110 >> bitcast<u32>(_e95)) & 1u)) + ((_e118 >> bitcast<u32>(_e95)) & 1u)) + ((_e126 >> bitcast<u32>(_e95)) & 1u)) + ((_e134 >> bitcast<u32>(_e95)) & 1u));
                phi_184_ = _e88;
                phi_186_ = (_e41 - _e83);
                phi_188_ = _e78;
                loop {
                    let _e140 = phi_181_;
                    let _e142 = phi_184_;
                    let _e144 = phi_186_;
                    let _e146 = phi_188_;
                    local_4 = _e142;
                    local_5 = _e142;
                    local_6 = _e142;
                    local_7 = _e142;
                    if (_e144 >= _e140) {
                        let _e148 = (_e146 == 0u);
                        if _e148 {
                            phi_248_ = u32();
                            phi_249_ = u32();
                            phi_250_ = u32();
                            phi_251_ = u32();
                        } else {
                            let _e151 = (_e146 & (_e146 - 1u));
                            let _e155 = (select(firstTrailingBit(_e151), 32u, (_e151 == 0u)) & 31u);
                            let _e156 = (_e155 & 31u);
                            phi_248_ = (((((((_e94 >> bitcast<u32>(_e156)) & 1u) + ((_e102 >> bitcast<u32>(_e156)) & 1u)) + ((_e110 >> bitcast<u32>(_e156)) & 1u)) + ((_e118 >> bitcast<u32>(_e156)) & 1u)) + ((_e126 >> bitcast<u32>(_e156)) & 1u)) + ((_e134 >> bitcast<u32>(_e156)) & 1u));
                            phi_249_ = _e155;
                            phi_250_ = (_e144 - _e140);
                            phi_251_ = _e151;
                        }
                        let _e181 = phi_248_;
                        let _e183 = phi_249_;
                        let _e185 = phi_250_;
                        let _e187 = phi_251_;
                        phi_182_ = _e181;
                        phi_185_ = _e183;
                        phi_187_ = _e185;
                        phi_189_ = _e187;
                        phi_253_ = select(true, false, _e148);
                    } else {
                        phi_182_ = u32();
                        phi_185_ = u32();
                        phi_187_ = u32();
                        phi_189_ = u32();
                        phi_253_ = false;
                    }
                    let _e190 = phi_182_;
                    let _e192 = phi_185_;
                    let _e194 = phi_187_;
                    let _e196 = phi_189_;
                    let _e198 = phi_253_;
                    continue;
                    continuing {
                        phi_181_ = _e190;
                        phi_184_ = _e192;
                        phi_186_ = _e194;
                        phi_188_ = _e196;
                        break if !(_e198);
                    }
                }
                let _e203 = params.member.member_2[0u];
                if (_e203.y == 0u) {
                    break;
                }
                let _e207 = local_2;
                let _e208 = (_e207 / _e203.y);
                let _e211 = local_3;
                let _e212 = (_e211 - (_e208 * _e203.y));
                if (_e203.x == 0u) {
                    break;
                }
                let _e215 = (_e212 / _e203.x);
                let _e221 = local_4;
                let _e225 = local_5;
                let _e227 = (_e225 >> bitcast<u32>(2i));
                let _e229 = ((((_e212 - (_e215 * _e203.x)) << bitcast<u32>(2i)) | (_e221 & 1u)) | (_e227 & 2u));
                let _e233 = local_6;
                let _e239 = local_7;
                let _e243 = (((_e215 << bitcast<u32>(2i)) | ((_e233 >> bitcast<u32>(1i)) & 1u)) | ((_e239 >> bitcast<u32>(3i)) & 2u));
                let _e247 = ((_e208 << bitcast<u32>(1i)) | (_e227 & 1u));
                let _e248 = (_e41 * 13u);
                if (_e248 < _e35) {
                } else {
                    break;
                }
                let _e252 = sums.member[_e248];
                let _e253 = f32(_e252);
                let _e255 = select(1f, _e253, (_e253 > 1f));
                let _e256 = (_e248 + 4u);
                if (_e256 < _e35) {
                } else {
                    break;
                }
                let _e260 = sums.member[_e256];
                let _e263 = (_e248 + 5u);
                if (_e263 < _e35) {
                } else {
                    break;
                }
                let _e267 = sums.member[_e263];
                let _e270 = (_e248 + 6u);
                if (_e270 < _e35) {
                } else {
                    break;
                }
                let _e274 = sums.member[_e270];
                let _e282 = params.member.member;
                let _e295 = params.member.member[3u];
                let _e304 = params.member.member_1;
                let _e308 = params.member.member_7;
                let _e310 = (_e248 + 1u);
                if (_e310 < _e35) {
                } else {
                    break;
                }
                let _e314 = sums.member[_e310];
                let _e317 = (_e248 + 2u);
                if (_e317 < _e35) {
                } else {
                    break;
                }
                let _e321 = sums.member[_e317];
                let _e324 = (_e248 + 3u);
                if (_e324 < _e35) {
                } else {
                    break;
                }
                let _e328 = sums.member[_e324];
                let _e341 = (_e248 + 7u);
                if (_e341 < _e35) {
                } else {
                    break;
                }
                let _e345 = sums.member[_e341];
                let _e348 = (_e248 + 8u);
                if (_e348 < _e35) {
                } else {
                    break;
                }
                let _e352 = sums.member[_e348];
                let _e355 = (_e248 + 9u);
                if (_e355 < _e35) {
                } else {
                    break;
                }
                let _e359 = sums.member[_e355];
                let _e366 = (_e248 + 10u);
                if (_e366 < _e35) {
                } else {
                    break;
                }
                let _e370 = sums.member[_e366];
                let _e373 = (_e248 + 11u);
                if (_e373 < _e35) {
                } else {
                    break;
                }
                let _e377 = sums.member[_e373];
                let _e380 = (_e248 + 12u);
                if (_e380 < _e35) {
                } else {
                    break;
                }
                let _e384 = sums.member[_e380];
                let _e389 = params.member.member_8;
                let _e390 = (_e389 / _e255);
                if _e42 {
                } else {
                    break;
                }
                out.member[_e41] = type_15(array<f32, 3>((_e282.x + ((f32(_e229) + (f32(bitcast<i32>(_e260)) / _e255)) * _e295)), (_e282.y + ((f32(_e243) + (f32(bitcast<i32>(_e267)) / _e255)) * _e295)), (_e282.z + ((f32(_e247) + (f32(bitcast<i32>(_e274)) / _e255)) * _e295))), (_e255 / _e308), array<f32, 3>((f32(bitcast<i32>(_e314)) / _e308), (f32(bitcast<i32>(_e321)) / _e308), (f32(bitcast<i32>(_e328)) / _e308)), (_e229 + (_e304.x * (_e243 + (_e304.y * _e247)))), array<f32, 3>((f32(bitcast<i32>(_e345)) / _e255), (f32(bitcast<i32>(_e352)) / _e255), (f32(bitcast<i32>(_e359)) / _e255)), 0u, array<f32, 3>((f32(bitcast<i32>(_e370)) * _e390), (f32(bitcast<i32>(_e377)) * _e390), (f32(bitcast<i32>(_e384)) * _e390)), 0u);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_resolve(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
