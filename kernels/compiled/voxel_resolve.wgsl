struct type_9 {
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
var<storage> cells: type_9;
@group(0) @binding(2) 
var<storage> facet_bits: type_9;
@group(0) @binding(0) 
var<uniform> params: type_24;
@group(0) @binding(3) 
var<storage> sums: type_9;
@group(0) @binding(4) 
var<storage, read_write> out: type_17;

fn function_() {
    var phi_89_: u32;
    var phi_92_: u32;
    var phi_90_: u32;
    var phi_93_: u32;
    var phi_569_: bool;
    var local: u32;
    var local_1: u32;
    var phi_212_: u32;
    var phi_215_: u32;
    var phi_217_: u32;
    var phi_219_: u32;
    var phi_309_: u32;
    var phi_310_: u32;
    var phi_311_: u32;
    var phi_312_: u32;
    var phi_213_: u32;
    var phi_216_: u32;
    var phi_218_: u32;
    var phi_220_: u32;
    var phi_314_: bool;
    var phi_573_: bool;
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
            let _e35 = arrayLength((&facet_bits.member));
            let _e37 = arrayLength((&sums.member));
            let _e43 = (_e31.x + (_e31.y * 2097152u));
            let _e44 = (_e43 < arrayLength((&out.member)));
            if _e44 {
                let _e49 = params.member.member_2[0u][3u];
                phi_89_ = _e49;
                phi_92_ = 0u;
                loop {
                    let _e51 = phi_89_;
                    let _e53 = phi_92_;
                    local = _e53;
                    local_1 = _e53;
                    local_2 = _e53;
                    local_3 = _e53;
                    let _e55 = ((_e51 - _e53) > 1u);
                    if _e55 {
                        let _e57 = ((_e53 + _e51) / 2u);
                        let _e59 = ((_e57 * 2u) + 1u);
                        if (_e59 < _e33) {
                        } else {
                            phi_569_ = true;
                            break;
                        }
                        let _e63 = cells.member[_e59];
                        let _e64 = (_e63 <= _e43);
                        phi_90_ = select(_e57, _e51, _e64);
                        phi_93_ = select(_e53, _e57, _e64);
                    } else {
                        phi_90_ = u32();
                        phi_93_ = u32();
                    }
                    let _e68 = phi_90_;
                    let _e70 = phi_93_;
                    continue;
                    continuing {
                        phi_89_ = _e68;
                        phi_92_ = _e70;
                        phi_569_ = false;
                        break if !(_e55);
                    }
                }
                let _e73 = phi_569_;
                if _e73 {
                    break;
                }
                let _e75 = local;
                let _e76 = (2u * _e75);
                if (_e76 < _e33) {
                } else {
                    break;
                }
                let _e80 = cells.member[_e76];
                let _e81 = (_e76 + 1u);
                if (_e81 < _e33) {
                } else {
                    break;
                }
                let _e85 = cells.member[_e81];
                let _e90 = (select(firstTrailingBit(_e80), 32u, (_e80 == 0u)) & 31u);
                let _e92 = local_1;
                let _e93 = (_e92 * 6u);
                let _e94 = (_e93 < _e35);
                if _e94 {
                } else {
                    break;
                }
                let _e97 = facet_bits.member[_e93];
                let _e98 = (_e90 & 31u);
                let _e102 = (_e93 + 1u);
                let _e103 = (_e102 < _e35);
                if _e103 {
                } else {
                    break;
                }
                let _e106 = facet_bits.member[_e102];
                let _e111 = (_e93 + 2u);
                let _e112 = (_e111 < _e35);
                if _e112 {
                } else {
                    break;
                }
                let _e115 = facet_bits.member[_e111];
                let _e120 = (_e93 + 3u);
                let _e121 = (_e120 < _e35);
                if _e121 {
                } else {
                    break;
                }
                let _e124 = facet_bits.member[_e120];
                let _e129 = (_e93 + 4u);
                let _e130 = (_e129 < _e35);
                if _e130 {
                } else {
                    break;
                }
                let _e133 = facet_bits.member[_e129];
                let _e138 = (_e93 + 5u);
                let _e139 = (_e138 < _e35);
                if _e139 {
                } else {
                    break;
                }
                let _e142 = facet_bits.member[_e138];
                phi_212_ = (((((((_e97 >> bitcast<u32>(_e98)) & 1u) + ((_e106 >> bitcast<u32>(_e98)) & 1u)) + ((_e115 >> bitcast<u32>(_e98)) & 1u)) + ((_e124 >> bitcast<u32>(_e98)) & 1u)) + ((_e133 >> bitcast<u32>(_e98)) & 1u)) + ((_e142 >> bitcast<u32>(_e98)) & 1u));
                phi_215_ = _e90;
                phi_217_ = (_e43 - _e85);
                phi_219_ = _e80;
                loop {
                    let _e148 = phi_212_;
                    let _e150 = phi_215_;
                    let _e152 = phi_217_;
                    let _e154 = phi_219_;
                    local_4 = _e150;
                    local_5 = _e150;
                    local_6 = _e150;
                    local_7 = _e150;
                    if (_e152 >= _e148) {
                        let _e156 = (_e154 == 0u);
                        if _e156 {
                            phi_309_ = u32();
                            phi_310_ = u32();
                            phi_311_ = u32();
                            phi_312_ = u32();
                        } else {
                            let _e159 = (_e154 & (_e154 - 1u));
                            let _e163 = (select(firstTrailingBit(_e159), 32u, (_e159 == 0u)) & 31u);
                            if _e94 {
                            } else {
                                phi_573_ = true;
                                break;
                            }
                            let _e164 = (_e163 & 31u);
                            if _e103 {
                            } else {
                                phi_573_ = true;
                                break;
                            }
                            if _e112 {
                            } else {
                                phi_573_ = true;
                                break;
                            }
                            if _e121 {
                            } else {
                                phi_573_ = true;
                                break;
                            }
                            if _e130 {
                            } else {
                                phi_573_ = true;
                                break;
                            }
                            if _e139 {
                            } else {
                                phi_573_ = true;
                                break;
                            }
                            phi_309_ = (((((((_e97 >> bitcast<u32>(_e164)) & 1u) + ((_e106 >> bitcast<u32>(_e164)) & 1u)) + ((_e115 >> bitcast<u32>(_e164)) & 1u)) + ((_e124 >> bitcast<u32>(_e164)) & 1u)) + ((_e133 >> bitcast<u32>(_e164)) & 1u)) + ((_e142 >> bitcast<u32>(_e164)) & 1u));
                            phi_310_ = _e163;
                            phi_311_ = (_e152 - _e148);
                            phi_312_ = _e159;
                        }
                        let _e189 = phi_309_;
                        let _e191 = phi_310_;
                        let _e193 = phi_311_;
                        let _e195 = phi_312_;
                        phi_213_ = _e189;
                        phi_216_ = _e191;
                        phi_218_ = _e193;
                        phi_220_ = _e195;
                        phi_314_ = select(true, false, _e156);
                    } else {
                        phi_213_ = u32();
                        phi_216_ = u32();
                        phi_218_ = u32();
                        phi_220_ = u32();
                        phi_314_ = false;
                    }
                    let _e198 = phi_213_;
                    let _e200 = phi_216_;
                    let _e202 = phi_218_;
                    let _e204 = phi_220_;
                    let _e206 = phi_314_;
                    continue;
                    continuing {
                        phi_212_ = _e198;
                        phi_215_ = _e200;
                        phi_217_ = _e202;
                        phi_219_ = _e204;
                        phi_573_ = _e73;
                        break if !(_e206);
                    }
                }
                let _e209 = phi_573_;
                if _e209 {
                    break;
                }
                let _e213 = params.member.member_2[0u];
                if (_e213.y == 0u) {
                    break;
                }
                let _e217 = local_2;
                let _e218 = (_e217 / _e213.y);
                let _e221 = local_3;
                let _e222 = (_e221 - (_e218 * _e213.y));
                if (_e213.x == 0u) {
                    break;
                }
                let _e225 = (_e222 / _e213.x);
                let _e231 = local_4;
                let _e235 = local_5;
                let _e237 = (_e235 >> bitcast<u32>(2i));
                let _e239 = ((((_e222 - (_e225 * _e213.x)) << bitcast<u32>(2i)) | (_e231 & 1u)) | (_e237 & 2u));
                let _e243 = local_6;
                let _e249 = local_7;
                let _e253 = (((_e225 << bitcast<u32>(2i)) | ((_e243 >> bitcast<u32>(1i)) & 1u)) | ((_e249 >> bitcast<u32>(3i)) & 2u));
                let _e257 = ((_e218 << bitcast<u32>(1i)) | (_e237 & 1u));
                let _e258 = (_e43 * 13u);
                if (_e258 < _e37) {
                } else {
                    break;
                }
                let _e262 = sums.member[_e258];
                let _e263 = f32(_e262);
                let _e265 = select(1f, _e263, (_e263 > 1f));
                let _e266 = (_e258 + 4u);
                if (_e266 < _e37) {
                } else {
                    break;
                }
                let _e270 = sums.member[_e266];
                let _e273 = (_e258 + 5u);
                if (_e273 < _e37) {
                } else {
                    break;
                }
                let _e277 = sums.member[_e273];
                let _e280 = (_e258 + 6u);
                if (_e280 < _e37) {
                } else {
                    break;
                }
                let _e284 = sums.member[_e280];
                let _e292 = params.member.member;
                let _e305 = params.member.member[3u];
                let _e314 = params.member.member_1;
                let _e318 = params.member.member_7;
                let _e320 = (_e258 + 1u);
                if (_e320 < _e37) {
                } else {
                    break;
                }
                let _e324 = sums.member[_e320];
                let _e327 = (_e258 + 2u);
                if (_e327 < _e37) {
                } else {
                    break;
                }
                let _e331 = sums.member[_e327];
                let _e334 = (_e258 + 3u);
                if (_e334 < _e37) {
                } else {
                    break;
                }
                let _e338 = sums.member[_e334];
                let _e351 = (_e258 + 7u);
                if (_e351 < _e37) {
                } else {
                    break;
                }
                let _e355 = sums.member[_e351];
                let _e358 = (_e258 + 8u);
                if (_e358 < _e37) {
                } else {
                    break;
                }
                let _e362 = sums.member[_e358];
                let _e365 = (_e258 + 9u);
                if (_e365 < _e37) {
                } else {
                    break;
                }
                let _e369 = sums.member[_e365];
                let _e376 = (_e258 + 10u);
                if (_e376 < _e37) {
                } else {
                    break;
                }
                let _e380 = sums.member[_e376];
                let _e383 = (_e258 + 11u);
                if (_e383 < _e37) {
                } else {
                    break;
                }
                let _e387 = sums.member[_e383];
                let _e390 = (_e258 + 12u);
                if (_e390 < _e37) {
                } else {
                    break;
                }
                let _e394 = sums.member[_e390];
                let _e399 = params.member.member_8;
                let _e400 = (_e399 / _e265);
                if _e44 {
                } else {
                    break;
                }
                out.member[_e43] = type_15(array<f32, 3>((_e292.x + ((f32(_e239) + (f32(bitcast<i32>(_e270)) / _e265)) * _e305)), (_e292.y + ((f32(_e253) + (f32(bitcast<i32>(_e277)) / _e265)) * _e305)), (_e292.z + ((f32(_e257) + (f32(bitcast<i32>(_e284)) / _e265)) * _e305))), (_e265 / _e318), array<f32, 3>((f32(bitcast<i32>(_e324)) / _e318), (f32(bitcast<i32>(_e331)) / _e318), (f32(bitcast<i32>(_e338)) / _e318)), (_e239 + (_e314.x * (_e253 + (_e314.y * _e257)))), array<f32, 3>((f32(bitcast<i32>(_e355)) / _e265), (f32(bitcast<i32>(_e362)) / _e265), (f32(bitcast<i32>(_e369)) / _e265)), 0u, array<f32, 3>((f32(bitcast<i32>(_e380)) * _e400), (f32(bitcast<i32>(_e387)) * _e400), (f32(bitcast<i32>(_e394)) * _e400)), 0u);
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
