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

struct type_31 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_24;
@group(0) @binding(1) 
var<storage> facets: type_17;
@group(0) @binding(2) 
var<storage, read_write> words: type_31;

fn function_() {
    var phi_183_: vec3<f32>;
    var phi_317_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_412_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_507_: bool;
    var phi_509_: bool;
    var phi_510_: bool;
    var phi_511_: bool;
    var phi_512_: bool;
    var phi_513_: bool;
    var phi_514_: bool;
    var phi_515_: bool;
    var phi_516_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = gid_1;
            let _e35 = arrayLength((&words.member));
            let _e39 = (_e31.x + (_e31.y * 2097152u));
            let _e42 = params.member.member_5;
            if (_e39 < _e42) {
                if (_e39 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e47 = params.member.member_13;
                let _e51 = params.member.member[3u];
                let _e52 = (_e47 / _e51);
                let _e56 = facets.member[_e39].member;
                let _e63 = facets.member[_e39].member_2;
                let _e67 = (_e52 * _e52);
                let _e68 = (_e63[0] * _e67);
                let _e69 = (_e63[1] * _e67);
                let _e70 = (_e63[2] * _e67);
                let _e73 = params.member.member;
                let _e81 = ((_e56[0] - _e73.x) / _e73.w);
                let _e82 = ((_e56[1] - _e73.y) / _e73.w);
                let _e83 = ((_e56[2] - _e73.z) / _e73.w);
                let _e89 = params.member.member_1[0u];
                let _e91 = (_e81 - f32(_e89));
                let _e95 = params.member.member_1[1u];
                let _e97 = (_e82 - f32(_e95));
                let _e101 = params.member.member_1[2u];
                let _e103 = (_e83 - f32(_e101));
                let _e109 = params.member.member_2[0u];
                let _e114 = params.member.member_2[1u];
                let _e119 = params.member.member_2[2u];
                if ((((((_e91 > -1f) && (_e91 < (f32(_e109) + 1f))) && (_e97 > -1f)) && (_e97 < (f32(_e114) + 1f))) && (_e103 > -1f)) && (_e103 < (f32(_e119) + 1f))) {
                    let _e139 = (((_e68 * _e68) + (_e69 * _e69)) + (_e70 * _e70));
                    if (_e139 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e142 = (1f / sqrt(_e139));
                        phi_183_ = vec3<f32>((_e68 * _e142), (_e69 * _e142), (_e70 * _e142));
                    } else {
                        phi_183_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e148 = phi_183_;
                    let _e155 = (_e81 - (_e148.x * 0.015625f));
                    let _e156 = (_e82 - (_e148.y * 0.015625f));
                    let _e157 = (_e83 - (_e148.z * 0.015625f));
                    let _e158 = params.member.member_1;
                    let _e159 = floor(_e155);
                    let _e167 = floor(_e156);
                    let _e175 = floor(_e157);
                    let _e186 = (select(0i, select(select(i32(_e159), i32(-2147483648), (_e159 < -2147483600f)), 2147483647i, (_e159 > 2147483500f)), (_e159 == _e159)) - _e158.x);
                    let _e187 = (select(0i, select(select(i32(_e167), i32(-2147483648), (_e167 < -2147483600f)), 2147483647i, (_e167 > 2147483500f)), (_e167 == _e167)) - _e158.y);
                    let _e188 = (select(0i, select(select(i32(_e175), i32(-2147483648), (_e175 < -2147483600f)), 2147483647i, (_e175 > 2147483500f)), (_e175 == _e175)) - _e158.z);
                    let _e192 = floor((_e155 - 0.5f));
                    let _e200 = floor((_e156 - 0.5f));
                    let _e208 = floor((_e157 - 0.5f));
                    let _e216 = (select(0i, select(select(i32(_e192), i32(-2147483648), (_e192 < -2147483600f)), 2147483647i, (_e192 > 2147483500f)), (_e192 == _e192)) - _e158.x);
                    let _e217 = (select(0i, select(select(i32(_e200), i32(-2147483648), (_e200 < -2147483600f)), 2147483647i, (_e200 > 2147483500f)), (_e200 == _e200)) - _e158.y);
                    let _e218 = (select(0i, select(select(i32(_e208), i32(-2147483648), (_e208 < -2147483600f)), 2147483647i, (_e208 > 2147483500f)), (_e208 == _e208)) - _e158.z);
                    let _e219 = abs(_e68);
                    let _e224 = floor(((select(16f, _e219, (_e219 < 16f)) * 65536f) + 0.5f));
                    let _e229 = select(select(u32(_e224), 0u, (_e224 < 0f)), 4294967295u, (_e224 > 4294967000f));
                    let _e230 = params.member.member_2;
                    if (_e216 >= 0i) {
                        if (_e187 >= 0i) {
                            if (_e188 >= 0i) {
                                if (_e216 < bitcast<i32>(_e230.x)) {
                                    let _e239 = (_e187 < bitcast<i32>(_e230.y));
                                    if _e239 {
                                        phi_317_ = (_e188 < bitcast<i32>(_e230.z));
                                    } else {
                                        phi_317_ = bool();
                                    }
                                    let _e244 = phi_317_;
                                    phi_319_ = _e244;
                                    phi_320_ = select(true, false, _e239);
                                } else {
                                    phi_319_ = bool();
                                    phi_320_ = true;
                                }
                                let _e247 = phi_319_;
                                let _e249 = phi_320_;
                                phi_321_ = _e247;
                                phi_322_ = _e249;
                            } else {
                                phi_321_ = bool();
                                phi_322_ = true;
                            }
                            let _e251 = phi_321_;
                            let _e253 = phi_322_;
                            phi_323_ = _e251;
                            phi_324_ = _e253;
                        } else {
                            phi_323_ = bool();
                            phi_324_ = true;
                        }
                        let _e255 = phi_323_;
                        let _e257 = phi_324_;
                        phi_325_ = _e255;
                        phi_326_ = _e257;
                    } else {
                        phi_325_ = bool();
                        phi_326_ = true;
                    }
                    let _e259 = phi_325_;
                    let _e261 = phi_326_;
                    if select(_e259, false, _e261) {
                        if (_e229 > 0u) {
                            let _e265 = (_e230.x + 1u);
                            let _e268 = ((_e230.y + 1u) * _e265);
                            let _e277 = ((((_e268 + _e265) + bitcast<u32>(_e216)) + (bitcast<u32>(_e187) * _e265)) + (bitcast<u32>(_e188) * _e268));
                            if (_e277 < _e35) {
                            } else {
                                break;
                            }
                            let _e281 = atomicAdd((&words.member[_e277]), _e229);
                        }
                    }
                    let _e282 = abs(_e69);
                    let _e287 = floor(((select(16f, _e282, (_e282 < 16f)) * 65536f) + 0.5f));
                    let _e292 = select(select(u32(_e287), 0u, (_e287 < 0f)), 4294967295u, (_e287 > 4294967000f));
                    let _e293 = (_e186 >= 0i);
                    if _e293 {
                        if (_e217 >= 0i) {
                            if (_e188 >= 0i) {
                                if (_e186 < bitcast<i32>(_e230.x)) {
                                    let _e301 = (_e217 < bitcast<i32>(_e230.y));
                                    if _e301 {
                                        phi_412_ = (_e188 < bitcast<i32>(_e230.z));
                                    } else {
                                        phi_412_ = bool();
                                    }
                                    let _e306 = phi_412_;
                                    phi_414_ = _e306;
                                    phi_415_ = select(true, false, _e301);
                                } else {
                                    phi_414_ = bool();
                                    phi_415_ = true;
                                }
                                let _e309 = phi_414_;
                                let _e311 = phi_415_;
                                phi_416_ = _e309;
                                phi_417_ = _e311;
                            } else {
                                phi_416_ = bool();
                                phi_417_ = true;
                            }
                            let _e313 = phi_416_;
                            let _e315 = phi_417_;
                            phi_418_ = _e313;
                            phi_419_ = _e315;
                        } else {
                            phi_418_ = bool();
                            phi_419_ = true;
                        }
                        let _e317 = phi_418_;
                        let _e319 = phi_419_;
                        phi_420_ = _e317;
                        phi_421_ = _e319;
                    } else {
                        phi_420_ = bool();
                        phi_421_ = true;
                    }
                    let _e321 = phi_420_;
                    let _e323 = phi_421_;
                    if select(_e321, false, _e323) {
                        if (_e292 > 0u) {
                            let _e327 = (_e230.x + 1u);
                            let _e330 = ((_e230.y + 1u) * _e327);
                            let _e331 = (_e330 + _e327);
                            let _e344 = ((_e331 + ((_e230.z + 1u) * _e330)) + (((_e331 + bitcast<u32>(_e186)) + (bitcast<u32>(_e217) * _e327)) + (bitcast<u32>(_e188) * _e330)));
                            if (_e344 < _e35) {
                            } else {
                                break;
                            }
                            let _e348 = atomicAdd((&words.member[_e344]), _e292);
                        }
                    }
                    let _e349 = abs(_e70);
                    let _e354 = floor(((select(16f, _e349, (_e349 < 16f)) * 65536f) + 0.5f));
                    let _e359 = select(select(u32(_e354), 0u, (_e354 < 0f)), 4294967295u, (_e354 > 4294967000f));
                    if _e293 {
                        if (_e187 >= 0i) {
                            if (_e218 >= 0i) {
                                if (_e186 < bitcast<i32>(_e230.x)) {
                                    let _e367 = (_e187 < bitcast<i32>(_e230.y));
                                    if _e367 {
                                        phi_507_ = (_e218 < bitcast<i32>(_e230.z));
                                    } else {
                                        phi_507_ = bool();
                                    }
                                    let _e372 = phi_507_;
                                    phi_509_ = _e372;
                                    phi_510_ = select(true, false, _e367);
                                } else {
                                    phi_509_ = bool();
                                    phi_510_ = true;
                                }
                                let _e375 = phi_509_;
                                let _e377 = phi_510_;
                                phi_511_ = _e375;
                                phi_512_ = _e377;
                            } else {
                                phi_511_ = bool();
                                phi_512_ = true;
                            }
                            let _e379 = phi_511_;
                            let _e381 = phi_512_;
                            phi_513_ = _e379;
                            phi_514_ = _e381;
                        } else {
                            phi_513_ = bool();
                            phi_514_ = true;
                        }
                        let _e383 = phi_513_;
                        let _e385 = phi_514_;
                        phi_515_ = _e383;
                        phi_516_ = _e385;
                    } else {
                        phi_515_ = bool();
                        phi_516_ = true;
                    }
                    let _e387 = phi_515_;
                    let _e389 = phi_516_;
                    if select(_e387, false, _e389) {
                        if (_e359 > 0u) {
                            let _e393 = (_e230.x + 1u);
                            let _e396 = ((_e230.y + 1u) * _e393);
                            let _e397 = (_e396 + _e393);
                            let _e411 = ((2u * (_e397 + ((_e230.z + 1u) * _e396))) + (((_e397 + bitcast<u32>(_e186)) + (bitcast<u32>(_e187) * _e393)) + (bitcast<u32>(_e218) * _e396)));
                            if (_e411 < _e35) {
                            } else {
                                break;
                            }
                            let _e415 = atomicAdd((&words.member[_e411]), _e359);
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
fn lpv_block_facets(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
