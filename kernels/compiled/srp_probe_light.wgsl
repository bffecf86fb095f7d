struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
    member_8: array<f32, 3>,
    member_9: f32,
}

struct type_20 {
    member: array<vec4<f32>>,
}

struct type_23 {
    member: array<type_18>,
}

struct type_25 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: f32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_26 {
    member: type_25,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage> coefs: type_5;
@group(0) @binding(0) 
var<uniform> params: type_26;
@group(0) @binding(1) 
var<storage> probes: type_20;
@group(0) @binding(3) 
var<storage> surfels: type_23;
@group(0) @binding(4) 
var<storage, read_write> irradiance: type_20;

fn function_() {
    var phi_447_: type_11;
    var phi_450_: vec3<f32>;
    var phi_452_: f32;
    var phi_448_: type_11;
    var phi_475_: type_11;
    var phi_514_: f32;
    var phi_538_: f32;
    var phi_553_: f32;
    var phi_568_: f32;
    var phi_583_: f32;
    var phi_598_: f32;
    var phi_613_: f32;
    var phi_628_: f32;
    var phi_643_: f32;
    var phi_658_: f32;
    var phi_676_: f32;
    var phi_691_: f32;
    var phi_706_: f32;
    var phi_721_: f32;
    var phi_736_: f32;
    var phi_751_: f32;
    var phi_766_: f32;
    var phi_781_: f32;
    var phi_796_: f32;
    var phi_815_: f32;
    var phi_830_: f32;
    var phi_845_: f32;
    var phi_860_: f32;
    var phi_875_: f32;
    var phi_890_: f32;
    var phi_905_: f32;
    var phi_920_: f32;
    var phi_935_: f32;
    var phi_949_: vec3<f32>;
    var phi_950_: f32;
    var phi_451_: vec3<f32>;
    var phi_453_: f32;
    var phi_1000_: bool;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: vec3<f32>;
    var phi_957_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = gid_1;
            let _e40 = arrayLength((&coefs.member));
            let _e47 = params.member.member;
            let _e51 = (_e36.x + (_e36.y * 2097152u));
            if (_e51 < _e47) {
                let _e53 = (_e51 < arrayLength((&surfels.member)));
                if _e53 {
                } else {
                    break;
                }
                let _e57 = surfels.member[_e51].member;
                if _e53 {
                } else {
                    break;
                }
                let _e64 = surfels.member[_e51].member_2;
                let _e72 = (_e64[2] * 1.0925485f);
                let _e80 = (_e64[1] * 1.0233268f);
                let _e81 = (_e64[2] * 1.0233268f);
                let _e82 = (_e64[0] * 1.0233268f);
                let _e83 = ((_e64[0] * (_e64[1] + _e64[1])) * 0.4290428f);
                let _e84 = ((_e72 * _e64[1]) * 0.7853982f);
                let _e85 = ((((_e64[2] * 1.9364917f) * (_e64[2] * 0.48860252f)) - 0.3153916f) * 0.7853982f);
                let _e86 = ((_e72 * _e64[0]) * 0.7853982f);
                let _e87 = (((_e64[0] * _e64[0]) - (_e64[1] * _e64[1])) * 0.4290428f);
                let _e90 = params.member.member_3;
                let _e93 = params.member.member_1;
                phi_447_ = type_11(0u, _e93);
                phi_450_ = vec3<f32>(0f, 0f, 0f);
                phi_452_ = 0f;
                loop {
                    let _e96 = phi_447_;
                    let _e98 = phi_450_;
                    let _e100 = phi_452_;
                    local = _e100;
                    local_1 = _e100;
                    local_2 = _e100;
                    local_3 = _e100;
                    local_4 = _e98;
                    if (_e96.member < _e96.member_1) {
                        phi_448_ = type_11((_e96.member + 1u), _e96.member_1);
                        phi_475_ = type_11(1u, _e96.member);
                    } else {
                        phi_448_ = _e96;
                        phi_475_ = type_11(0u, type_11().member_1);
                    }
                    let _e113 = phi_448_;
                    let _e115 = phi_475_;
                    let _e119 = (bitcast<i32>(_e115.member) != 0i);
                    if _e119 {
                        if (_e115.member_1 < arrayLength((&probes.member))) {
                        } else {
                            phi_1000_ = true;
                            break;
                        }
                        let _e123 = probes.member[_e115.member_1];
                        let _e127 = (_e123.x - _e57[0]);
                        let _e128 = (_e123.y - _e57[1]);
                        let _e129 = (_e123.z - _e57[2]);
                        let _e138 = params.member.member_4;
                        let _e139 = (sqrt((((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129))) / _e138);
                        if (_e139 < 1f) {
                            phi_514_ = (((((2f * _e139) - 3f) * _e139) * _e139) + 1f);
                        } else {
                            phi_514_ = 0f;
                        }
                        let _e147 = phi_514_;
                        if (_e147 > 0f) {
                            let _e151 = params.member.member_2;
                            let _e152 = (_e115.member_1 * _e151);
                            let _e153 = (0u < _e151);
                            if _e153 {
                                if (_e152 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e157 = coefs.member[_e152];
                                phi_538_ = (0.886227f * _e157);
                            } else {
                                phi_538_ = 0f;
                            }
                            let _e160 = phi_538_;
                            let _e161 = (1u < _e151);
                            if _e161 {
                                let _e162 = (_e152 + 1u);
                                if (_e162 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e166 = coefs.member[_e162];
                                phi_553_ = (_e160 + (_e80 * _e166));
                            } else {
                                phi_553_ = _e160;
                            }
                            let _e170 = phi_553_;
                            let _e171 = (2u < _e151);
                            if _e171 {
                                let _e172 = (_e152 + 2u);
                                if (_e172 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e176 = coefs.member[_e172];
                                phi_568_ = (_e170 + (_e81 * _e176));
                            } else {
                                phi_568_ = _e170;
                            }
                            let _e180 = phi_568_;
                            let _e181 = (3u < _e151);
                            if _e181 {
                                let _e182 = (_e152 + 3u);
                                if (_e182 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e186 = coefs.member[_e182];
                                phi_583_ = (_e180 + (_e82 * _e186));
                            } else {
                                phi_583_ = _e180;
                            }
                            let _e190 = phi_583_;
                            let _e191 = (4u < _e151);
                            if _e191 {
                                let _e192 = (_e152 + 4u);
                                if (_e192 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e196 = coefs.member[_e192];
                                phi_598_ = (_e190 + (_e83 * _e196));
                            } else {
                                phi_598_ = _e190;
                            }
                            let _e200 = phi_598_;
                            let _e201 = (5u < _e151);
                            if _e201 {
                                let _e202 = (_e152 + 5u);
                                if (_e202 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e206 = coefs.member[_e202];
                                phi_613_ = (_e200 + (_e84 * _e206));
                            } else {
                                phi_613_ = _e200;
                            }
                            let _e210 = phi_613_;
                            let _e211 = (6u < _e151);
                            if _e211 {
                                let _e212 = (_e152 + 6u);
                                if (_e212 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e216 = coefs.member[_e212];
                                phi_628_ = (_e210 + (_e85 * _e216));
                            } else {
                                phi_628_ = _e210;
                            }
                            let _e220 = phi_628_;
                            let _e221 = (7u < _e151);
                            if _e221 {
                                let _e222 = (_e152 + 7u);
                                if (_e222 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e226 = coefs.member[_e222];
                                phi_643_ = (_e220 + (_e86 * _e226));
                            } else {
                                phi_643_ = _e220;
                            }
                            let _e230 = phi_643_;
                            let _e231 = (8u < _e151);
                            if _e231 {
                                let _e232 = (_e152 + 8u);
                                if (_e232 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e236 = coefs.member[_e232];
                                phi_658_ = (_e230 + (_e87 * _e236));
                            } else {
                                phi_658_ = _e230;
                            }
                            let _e240 = phi_658_;
                            let _e241 = (_e90 + _e152);
                            if _e153 {
                                if (_e241 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e245 = coefs.member[_e241];
                                phi_676_ = (0.886227f * _e245);
                            } else {
                                phi_676_ = 0f;
                            }
                            let _e248 = phi_676_;
                            if _e161 {
                                let _e249 = (_e241 + 1u);
                                if (_e249 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e253 = coefs.member[_e249];
                                phi_691_ = (_e248 + (_e80 * _e253));
                            } else {
                                phi_691_ = _e248;
                            }
                            let _e257 = phi_691_;
                            if _e171 {
                                let _e258 = (_e241 + 2u);
                                if (_e258 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e262 = coefs.member[_e258];
                                phi_706_ = (_e257 + (_e81 * _e262));
                            } else {
                                phi_706_ = _e257;
                            }
                            let _e266 = phi_706_;
                            if _e181 {
                                let _e267 = (_e241 + 3u);
                                if (_e267 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e271 = coefs.member[_e267];
                                phi_721_ = (_e266 + (_e82 * _e271));
                            } else {
                                phi_721_ = _e266;
                            }
                            let _e275 = phi_721_;
                            if _e191 {
                                let _e276 = (_e241 + 4u);
                                if (_e276 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e280 = coefs.member[_e276];
                                phi_736_ = (_e275 + (_e83 * _e280));
                            } else {
                                phi_736_ = _e275;
                            }
                            let _e284 = phi_736_;
                            if _e201 {
                                let _e285 = (_e241 + 5u);
                                if (_e285 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e289 = coefs.member[_e285];
                                phi_751_ = (_e284 + (_e84 * _e289));
                            } else {
                                phi_751_ = _e284;
                            }
                            let _e293 = phi_751_;
                            if _e211 {
                                let _e294 = (_e241 + 6u);
                                if (_e294 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e298 = coefs.member[_e294];
                                phi_766_ = (_e293 + (_e85 * _e298));
                            } else {
                                phi_766_ = _e293;
                            }
                            let _e302 = phi_766_;
                            if _e221 {
                                let _e303 = (_e241 + 7u);
                                if (_e303 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e307 = coefs.member[_e303];
                                phi_781_ = (_e302 + (_e86 * _e307));
                            } else {
                                phi_781_ = _e302;
                            }
                            let _e311 = phi_781_;
                            if _e231 {
                                let _e312 = (_e241 + 8u);
                                if (_e312 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e316 = coefs.member[_e312];
                                phi_796_ = (_e311 + (_e87 * _e316));
                            } else {
                                phi_796_ = _e311;
                            }
                            let _e320 = phi_796_;
                            let _e322 = ((2u * _e90) + _e152);
                            if _e153 {
                                if (_e322 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e326 = coefs.member[_e322];
                                phi_815_ = (0.886227f * _e326);
                            } else {
                                phi_815_ = 0f;
                            }
                            let _e329 = phi_815_;
                            if _e161 {
                                let _e330 = (_e322 + 1u);
                                if (_e330 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e334 = coefs.member[_e330];
                                phi_830_ = (_e329 + (_e80 * _e334));
                            } else {
                                phi_830_ = _e329;
                            }
                            let _e338 = phi_830_;
                            if _e171 {
                                let _e339 = (_e322 + 2u);
                                if (_e339 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e343 = coefs.member[_e339];
                                phi_845_ = (_e338 + (_e81 * _e343));
                            } else {
                                phi_845_ = _e338;
                            }
                            let _e347 = phi_845_;
                            if _e181 {
                                let _e348 = (_e322 + 3u);
                                if (_e348 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e352 = coefs.member[_e348];
                                phi_860_ = (_e347 + (_e82 * _e352));
                            } else {
                                phi_860_ = _e347;
                            }
                            let _e356 = phi_860_;
                            if _e191 {
                                let _e357 = (_e322 + 4u);
                                if (_e357 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e361 = coefs.member[_e357];
                                phi_875_ = (_e356 + (_e83 * _e361));
                            } else {
                                phi_875_ = _e356;
                            }
                            let _e365 = phi_875_;
                            if _e201 {
                                let _e366 = (_e322 + 5u);
                                if (_e366 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e370 = coefs.member[_e366];
                                phi_890_ = (_e365 + (_e84 * _e370));
                            } else {
                                phi_890_ = _e365;
                            }
                            let _e374 = phi_890_;
                            if _e211 {
                                let _e375 = (_e322 + 6u);
                                if (_e375 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e379 = coefs.member[_e375];
                                phi_905_ = (_e374 + (_e85 * _e379));
                            } else {
                                phi_905_ = _e374;
                            }
                            let _e383 = phi_905_;
                            if _e221 {
                                let _e384 = (_e322 + 7u);
                                if (_e384 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e388 = coefs.member[_e384];
                                phi_920_ = (_e383 + (_e86 * _e388));
                            } else {
                                phi_920_ = _e383;
                            }
                            let _e392 = phi_920_;
                            if _e231 {
                                let _e393 = (_e322 + 8u);
                                if (_e393 < _e40) {
                                } else {
                                    phi_1000_ = true;
                                    break;
                                }
                                let _e397 = coefs.member[_e393];
                                phi_935_ = (_e392 + (_e87 * _e397));
                            } else {
                                phi_935_ = _e392;
                            }
                            let _e401 = phi_935_;
                            phi_949_ = vec3<f32>((_e98.x + (_e147 * _e240)), (_e98.y + (_e147 * _e320)), (_e98.z + (_e147 * _e401)));
                            phi_950_ = (_e100 + _e147);
                        } else {
                            phi_949_ = _e98;
                            phi_950_ = _e100;
                        }
                        let _e414 = phi_949_;
                        let _e416 = phi_950_;
                        phi_451_ = _e414;
                        phi_453_ = _e416;
                    } else {
                        phi_451_ = vec3<f32>();
                        phi_453_ = f32();
                    }
                    let _e418 = phi_451_;
                    let _e420 = phi_453_;
                    continue;
                    continuing {
                        phi_447_ = _e113;
                        phi_450_ = _e418;
                        phi_452_ = _e420;
                        phi_1000_ = false;
                        break if !(_e119);
                    }
                }
                let _e423 = phi_1000_;
                if _e423 {
                    break;
                }
                let _e425 = local;
                if (_e425 > 0f) {
                    let _e428 = local_1;
                    let _e430 = local_2;
                    let _e432 = local_3;
                    let _e435 = local_4;
                    phi_957_ = (_e435 / vec3<f32>(_e428, _e430, _e432));
                } else {
                    phi_957_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e438 = phi_957_;
                if (_e51 < arrayLength((&irradiance.member))) {
                } else {
                    break;
                }
                irradiance.member[_e51] = vec4<f32>(select(0f, _e438.x, (_e438.x > 0f)), select(0f, _e438.y, (_e438.y > 0f)), select(0f, _e438.z, (_e438.z > 0f)), 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_probe_light(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
