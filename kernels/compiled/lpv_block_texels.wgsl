struct type_9 {
    member: array<u32>,
}

struct type_16 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_23 {
    member: vec4<f32>,
    member_1: vec4<i32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
    member_4: vec4<f32>,
    member_5: u32,
    member_6: f32,
    member_7: f32,
    member_8: f32,
    member_9: f32,
    member_10: f32,
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: f32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: vec4<f32>,
}

struct type_24 {
    member: type_23,
}

struct type_30 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_24;
@group(0) @binding(2) 
var<storage, read_write> words: type_30;
@group(0) @binding(1) 
var<storage> texels: type_18;

fn function_() {
    var phi_216_: bool;
    var phi_218_: bool;
    var phi_219_: bool;
    var phi_220_: bool;
    var phi_221_: bool;
    var phi_222_: bool;
    var phi_223_: bool;
    var phi_224_: bool;
    var phi_225_: bool;
    var phi_352_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_358_: bool;
    var phi_359_: bool;
    var phi_360_: bool;
    var phi_361_: bool;
    var phi_488_: bool;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_495_: bool;
    var phi_496_: bool;
    var phi_497_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = gid_1;
            let _e29 = arrayLength((&words.member));
            let _e33 = (_e25.x + (_e25.y * 2097152u));
            let _e36 = params.member.member_5;
            if (_e33 < _e36) {
                if (_e33 < arrayLength((&texels.member))) {
                } else {
                    break;
                }
                let _e42 = texels.member[_e33].member_3;
                if (_e42 == 1u) {
                    let _e47 = texels.member[_e33].member_1;
                    let _e51 = params.member.member[3u];
                    let _e53 = ((_e47 / _e51) / _e51);
                    let _e57 = texels.member[_e33].member;
                    let _e64 = texels.member[_e33].member_2;
                    let _e69 = select(16f, _e53, (_e53 < 16f));
                    let _e75 = params.member.member;
                    let _e83 = ((_e57[0] - _e75.x) / _e75.w);
                    let _e84 = ((_e57[1] - _e75.y) / _e75.w);
                    let _e85 = ((_e57[2] - _e75.z) / _e75.w);
                    let _e87 = abs((_e64[0] * _e69));
                    let _e90 = params.member.member_1;
                    let _e91 = floor((_e83 - 0.5f));
                    let _e99 = floor(_e84);
                    let _e107 = floor(_e85);
                    let _e118 = (select(0i, select(select(i32(_e91), i32(-2147483648), (_e91 < -2147483600f)), 2147483647i, (_e91 > 2147483500f)), (_e91 == _e91)) - _e90.x);
                    let _e119 = (select(0i, select(select(i32(_e99), i32(-2147483648), (_e99 < -2147483600f)), 2147483647i, (_e99 > 2147483500f)), (_e99 == _e99)) - _e90.y);
                    let _e120 = (select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < -2147483600f)), 2147483647i, (_e107 > 2147483500f)), (_e107 == _e107)) - _e90.z);
                    let _e125 = floor(((select(16f, _e87, (_e87 < 16f)) * 65536f) + 0.5f));
                    let _e130 = select(select(u32(_e125), 0u, (_e125 < 0f)), 4294967295u, (_e125 > 4294967000f));
                    let _e133 = params.member.member_2;
                    if (_e118 >= 0i) {
                        if (_e119 >= 0i) {
                            if (_e120 >= 0i) {
                                if (_e118 < bitcast<i32>(_e133.x)) {
                                    let _e142 = (_e119 < bitcast<i32>(_e133.y));
                                    if _e142 {
                                        phi_216_ = (_e120 < bitcast<i32>(_e133.z));
                                    } else {
                                        phi_216_ = bool();
                                    }
                                    let _e147 = phi_216_;
                                    phi_218_ = _e147;
                                    phi_219_ = select(true, false, _e142);
                                } else {
                                    phi_218_ = bool();
                                    phi_219_ = true;
                                }
                                let _e150 = phi_218_;
                                let _e152 = phi_219_;
                                phi_220_ = _e150;
                                phi_221_ = _e152;
                            } else {
                                phi_220_ = bool();
                                phi_221_ = true;
                            }
                            let _e154 = phi_220_;
                            let _e156 = phi_221_;
                            phi_222_ = _e154;
                            phi_223_ = _e156;
                        } else {
                            phi_222_ = bool();
                            phi_223_ = true;
                        }
                        let _e158 = phi_222_;
                        let _e160 = phi_223_;
                        phi_224_ = _e158;
                        phi_225_ = _e160;
                    } else {
                        phi_224_ = bool();
                        phi_225_ = true;
                    }
                    let _e162 = phi_224_;
                    let _e164 = phi_225_;
                    if select(_e162, false, _e164) {
                        if (_e130 > 0u) {
                            let _e168 = (_e133.x + 1u);
                            let _e171 = ((_e133.y + 1u) * _e168);
                            let _e180 = ((((_e171 + _e168) + bitcast<u32>(_e118)) + (bitcast<u32>(_e119) * _e168)) + (bitcast<u32>(_e120) * _e171));
                            if (_e180 < _e29) {
                            } else {
                                break;
                            }
                            let _e184 = atomicAdd((&words.member[_e180]), _e130);
                        }
                    }
                    let _e186 = abs((_e64[1] * _e69));
                    let _e187 = floor(_e83);
                    let _e195 = floor((_e84 - 0.5f));
                    let _e203 = (select(0i, select(select(i32(_e187), i32(-2147483648), (_e187 < -2147483600f)), 2147483647i, (_e187 > 2147483500f)), (_e187 == _e187)) - _e90.x);
                    let _e204 = (select(0i, select(select(i32(_e195), i32(-2147483648), (_e195 < -2147483600f)), 2147483647i, (_e195 > 2147483500f)), (_e195 == _e195)) - _e90.y);
                    let _e209 = floor(((select(16f, _e186, (_e186 < 16f)) * 65536f) + 0.5f));
                    let _e214 = select(select(u32(_e209), 0u, (_e209 < 0f)), 4294967295u, (_e209 > 4294967000f));
                    let _e215 = (_e203 >= 0i);
                    if _e215 {
                        if (_e204 >= 0i) {
                            if (_e120 >= 0i) {
                                if (_e203 < bitcast<i32>(_e133.x)) {
                                    let _e223 = (_e204 < bitcast<i32>(_e133.y));
                                    if _e223 {
                                        phi_352_ = (_e120 < bitcast<i32>(_e133.z));
                                    } else {
                                        phi_352_ = bool();
                                    }
                                    let _e228 = phi_352_;
                                    phi_354_ = _e228;
                                    phi_355_ = select(true, false, _e223);
                                } else {
                                    phi_354_ = bool();
                                    phi_355_ = true;
                                }
                                let _e231 = phi_354_;
                                let _e233 = phi_355_;
                                phi_356_ = _e231;
                                phi_357_ = _e233;
                            } else {
                                phi_356_ = bool();
                                phi_357_ = true;
                            }
                            let _e235 = phi_356_;
                            let _e237 = phi_357_;
                            phi_358_ = _e235;
                            phi_359_ = _e237;
                        } else {
                            phi_358_ = bool();
                            phi_359_ = true;
                        }
                        let _e239 = phi_358_;
                        let _e241 = phi_359_;
                        phi_360_ = _e239;
                        phi_361_ = _e241;
                    } else {
                        phi_360_ = bool();
                        phi_361_ = true;
                    }
                    let _e243 = phi_360_;
                    let _e245 = phi_361_;
                    if select(_e243, false, _e245) {
                        if (_e214 > 0u) {
                            let _e249 = (_e133.x + 1u);
                            let _e252 = ((_e133.y + 1u) * _e249);
                            let _e253 = (_e252 + _e249);
                            let _e266 = ((_e253 + ((_e133.z + 1u) * _e252)) + (((_e253 + bitcast<u32>(_e203)) + (bitcast<u32>(_e204) * _e249)) + (bitcast<u32>(_e120) * _e252)));
                            if (_e266 < _e29) {
                            } else {
                                break;
                            }
                            let _e270 = atomicAdd((&words.member[_e266]), _e214);
                        }
                    }
                    let _e272 = abs((_e64[2] * _e69));
                    let _e273 = floor((_e85 - 0.5f));
                    let _e281 = (select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < -2147483600f)), 2147483647i, (_e273 > 2147483500f)), (_e273 == _e273)) - _e90.z);
                    let _e286 = floor(((select(16f, _e272, (_e272 < 16f)) * 65536f) + 0.5f));
                    let _e291 = select(select(u32(_e286), 0u, (_e286 < 0f)), 4294967295u, (_e286 > 4294967000f));
                    if _e215 {
                        if (_e119 >= 0i) {
                            if (_e281 >= 0i) {
                                if (_e203 < bitcast<i32>(_e133.x)) {
                                    let _e299 = (_e119 < bitcast<i32>(_e133.y));
                                    if _e299 {
                                        phi_488_ = (_e281 < bitcast<i32>(_e133.z));
                                    } else {
                                        phi_488_ = bool();
                                    }
                                    let _e304 = phi_488_;
                                    phi_490_ = _e304;
                                    phi_491_ = select(true, false, _e299);
                                } else {
                                    phi_490_ = bool();
                                    phi_491_ = true;
                                }
                                let _e307 = phi_490_;
                                let _e309 = phi_491_;
                                phi_492_ = _e307;
                                phi_493_ = _e309;
                            } else {
                                phi_492_ = bool();
                                phi_493_ = true;
                            }
                            let _e311 = phi_492_;
                            let _e313 = phi_493_;
                            phi_494_ = _e311;
                            phi_495_ = _e313;
                        } else {
                            phi_494_ = bool();
                            phi_495_ = true;
                        }
                        let _e315 = phi_494_;
                        let _e317 = phi_495_;
                        phi_496_ = _e315;
                        phi_497_ = _e317;
                    } else {
                        phi_496_ = bool();
                        phi_497_ = true;
                    }
                    let _e319 = phi_496_;
                    let _e321 = phi_497_;
                    if select(_e319, false, _e321) {
                        if (_e291 > 0u) {
                            let _e325 = (_e133.x + 1u);
                            let _e328 = ((_e133.y + 1u) * _e325);
                            let _e329 = (_e328 + _e325);
                            let _e343 = ((2u * (_e329 + ((_e133.z + 1u) * _e328))) + (((_e329 + bitcast<u32>(_e203)) + (bitcast<u32>(_e119) * _e325)) + (bitcast<u32>(_e281) * _e328)));
                            if (_e343 < _e29) {
                            } else {
                                break;
                            }
                            let _e347 = atomicAdd((&words.member[_e343]), _e291);
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_block_texels(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
