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
    var phi_87_: u32;
    var phi_90_: u32;
    var phi_88_: u32;
    var phi_91_: u32;
    var phi_502_: bool;
    var local: u32;
    var local_1: u32;
    var phi_179_: u32;
    var phi_182_: u32;
    var phi_184_: u32;
    var phi_186_: u32;
    var phi_246_: u32;
    var phi_247_: u32;
    var phi_248_: u32;
    var phi_249_: u32;
    var phi_180_: u32;
    var phi_183_: u32;
    var phi_185_: u32;
    var phi_187_: u32;
    var phi_251_: bool;
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
                phi_87_ = _e47;
                phi_90_ = 0u;
                loop {
                    let _e49 = phi_87_;
                    let _e51 = phi_90_;
                    local = _e51;
                    local_1 = _e51;
                    local_2 = _e51;
                    local_3 = _e51;
                    let _e52 = (_e49 > 1u);
                    if _e52 {
                        let _e53 = (_e49 / 2u);
                        let _e54 = (_e51 + _e53);
                        let _e56 = ((_e54 * 2u) + 1u);
                        if (_e56 < _e33) {
                        } else {
                            phi_502_ = true;
                            break;
                        }
                        let _e60 = cells.member[_e56];
                        phi_88_ = (_e49 - _e53);
                        phi_91_ = select(_e51, _e54, (_e60 <= _e41));
                    } else {
                        phi_88_ = u32();
                        phi_91_ = u32();
                    }
                    let _e65 = phi_88_;
                    let _e67 = phi_91_;
                    continue;
                    continuing {
                        phi_87_ = _e65;
                        phi_90_ = _e67;
                        phi_502_ = false;
                        break if !(_e52);
                    }
                }
                let _e70 = phi_502_;
                if _e70 {
                    break;
                }
                let _e72 = local;
                let _e73 = (2u * _e72);
                if (_e73 < _e33) {
                } else {
                    break;
                }
                let _e77 = cells.member[_e73];
                let _e78 = (_e73 + 1u);
                if (_e78 < _e33) {
                } else {
                    break;
                }
                let _e82 = cells.member[_e78];
                let _e87 = (select(firstTrailingBit(_e77), 32u, (_e77 == 0u)) & 31u);
                let _e89 = local_1;
                let _e90 = (_e89 * 6u);
                let _e93 = facet_bits.member[_e90];
                let _e94 = (_e87 & 31u);
                let _e101 = facet_bits.member[(_e90 + 1u)];
                let _e109 = facet_bits.member[(_e90 + 2u)];
                let _e117 = facet_bits.member[(_e90 + 3u)];
                let _e125 = facet_bits.member[(_e90 + 4u)];
                let _e133 = facet_bits.member[(_e90 + 5u)];
                phi_179_ = (((((((_e93 >> bitcast<u32>(_e94)) & 1u) + ((_e101 >> bitcast<u32>(_e94)) & 1u)) + ((_e109 >> bitcast<u32>(_e94)) & 1u)) + ((_e117 >> bitcast<u32>(_e94)) & 1u)) + ((_e125 >> bitcast<u32>(_e94)) & 1u)) + ((_e133 >> bitcast<u32>(_e94)) & 1u));
                phi_182_ = _e87;
                phi_184_ = (_e41 - _e82);
                phi_186_ = _e77;
                loop {
                    let _e139 = phi_179_;
                    let _e141 = phi_182_;
                    let _e143 = phi_184_;
                    let _e145 = phi_186_;
                    local_4 = _e141;
                    local_5 = _e141;
                    local_6 = _e141;
                    local_7 = _e141;
                    if (_e143 >= _e139) {
                        let _e147 = (_e145 == 0u);
                        if _e147 {
                            phi_246_ = u32();
                            phi_247_ = u32();
                            phi_248_ = u32();
                            phi_249_ = u32();
                        } else {
                            let _e150 = (_e145 & (_e145 - 1u));
                            let _e154 = (select(firstTrailingBit(_e150), 32u, (_e150 == 0u)) & 31u);
                            let _e155 = (_e154 & 31u);
                            phi_246_ = (((((((_e93 >> bitcast<u32>(_e155)) & 1u) + ((_e101 >> bitcast<u32>(_e155)) & 1u)) + ((_e109 >> bitcast<u32>(_e155)) & 1u)) + ((_e117 >> bitcast<u32>(_e155)) & 1u)) + ((_e125 >> bitcast<u32>(_e155)) & 1u)) + ((_e133 >> bitcast<u32>(_e155)) & 1u));
                            phi_247_ = _e154;
                            phi_248_ = (_e143 - _e139);
                            phi_249_ = _e150;
                        }
                        let _e180 = phi_246_;
                        let _e182 = phi_247_;
                        let _e184 = phi_248_;
                        let _e186 = phi_249_;
                        phi_180_ = _e180;
                        phi_183_ = _e182;
                        phi_185_ = _e184;
                        phi_187_ = _e186;
                        phi_251_ = select(true, false, _e147);
                    } else {
                        phi_180_ = u32();
                        phi_183_ = u32();
                        phi_185_ = u32();
                        phi_187_ = u32();
                        phi_251_ = false;
                    }
                    let _e189 = phi_180_;
                    let _e191 = phi_183_;
                    let _e193 = phi_185_;
                    let _e195 = phi_187_;
                    let _e197 = phi_251_;
                    continue;
                    continuing {
                        phi_179_ = _e189;
                        phi_182_ = _e191;
                        phi_184_ = _e193;
                        phi_186_ = _e195;
                        break if !(_e197);
                    }
                }
                let _e202 = params.member.member_2[0u];
                if (_e202.y == 0u) {
                    break;
                }
                let _e206 = local_2;
                let _e207 = (_e206 / _e202.y);
                let _e210 = local_3;
                let _e211 = (_e210 - (_e207 * _e202.y));
                if (_e202.x == 0u) {
                    break;
                }
                let _e214 = (_e211 / _e202.x);
                let _e220 = local_4;
                let _e224 = local_5;
                let _e226 = (_e224 >> bitcast<u32>(2i));
                let _e228 = ((((_e211 - (_e214 * _e202.x)) << bitcast<u32>(2i)) | (_e220 & 1u)) | (_e226 & 2u));
                let _e232 = local_6;
                let _e238 = local_7;
                let _e242 = (((_e214 << bitcast<u32>(2i)) | ((_e232 >> bitcast<u32>(1i)) & 1u)) | ((_e238 >> bitcast<u32>(3i)) & 2u));
                let _e246 = ((_e207 << bitcast<u32>(1i)) | (_e226 & 1u));
                let _e247 = (_e41 * 13u);
                if (_e247 < _e35) {
                } else {
                    break;
                }
                let _e251 = sums.member[_e247];
                let _e252 = f32(_e251);
                let _e254 = select(1f, _e252, (_e252 > 1f));
                let _e255 = (_e247 + 4u);
                if (_e255 < _e35) {
                } else {
                    break;
                }
                let _e259 = sums.member[_e255];
                let _e262 = (_e247 + 5u);
                if (_e262 < _e35) {
                } else {
                    break;
                }
                let _e266 = sums.member[_e262];
                let _e269 = (_e247 + 6u);
                if (_e269 < _e35) {
                } else {
                    break;
                }
                let _e273 = sums.member[_e269];
                let _e281 = params.member.member;
                let _e294 = params.member.member[3u];
                let _e303 = params.member.member_1;
                let _e307 = params.member.member_7;
                let _e309 = (_e247 + 1u);
                if (_e309 < _e35) {
                } else {
                    break;
                }
                let _e313 = sums.member[_e309];
                let _e316 = (_e247 + 2u);
                if (_e316 < _e35) {
                } else {
                    break;
                }
                let _e320 = sums.member[_e316];
                let _e323 = (_e247 + 3u);
                if (_e323 < _e35) {
                } else {
                    break;
                }
                let _e327 = sums.member[_e323];
                let _e340 = (_e247 + 7u);
                if (_e340 < _e35) {
                } else {
                    break;
                }
                let _e344 = sums.member[_e340];
                let _e347 = (_e247 + 8u);
                if (_e347 < _e35) {
                } else {
                    break;
                }
                let _e351 = sums.member[_e347];
                let _e354 = (_e247 + 9u);
                if (_e354 < _e35) {
                } else {
                    break;
                }
                let _e358 = sums.member[_e354];
                let _e365 = (_e247 + 10u);
                if (_e365 < _e35) {
                } else {
                    break;
                }
                let _e369 = sums.member[_e365];
                let _e372 = (_e247 + 11u);
                if (_e372 < _e35) {
                } else {
                    break;
                }
                let _e376 = sums.member[_e372];
                let _e379 = (_e247 + 12u);
                if (_e379 < _e35) {
                } else {
                    break;
                }
                let _e383 = sums.member[_e379];
                let _e388 = params.member.member_8;
                let _e389 = (_e388 / _e254);
                if _e42 {
                } else {
                    break;
                }
                out.member[_e41] = type_15(array<f32, 3>((_e281.x + ((f32(_e228) + (f32(bitcast<i32>(_e259)) / _e254)) * _e294)), (_e281.y + ((f32(_e242) + (f32(bitcast<i32>(_e266)) / _e254)) * _e294)), (_e281.z + ((f32(_e246) + (f32(bitcast<i32>(_e273)) / _e254)) * _e294))), (_e254 / _e307), array<f32, 3>((f32(bitcast<i32>(_e313)) / _e307), (f32(bitcast<i32>(_e320)) / _e307), (f32(bitcast<i32>(_e327)) / _e307)), (_e228 + (_e303.x * (_e242 + (_e303.y * _e246)))), array<f32, 3>((f32(bitcast<i32>(_e344)) / _e254), (f32(bitcast<i32>(_e351)) / _e254), (f32(bitcast<i32>(_e358)) / _e254)), 0u, array<f32, 3>((f32(bitcast<i32>(_e369)) * _e389), (f32(bitcast<i32>(_e376)) * _e389), (f32(bitcast<i32>(_e383)) * _e389)), 0u);
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
