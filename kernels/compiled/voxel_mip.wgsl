struct type_7 {
    member: array<u32>,
}

struct type_15 {
    member: array<vec4<f32>>,
}

struct type_18 {
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

struct type_19 {
    member: type_18,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> out: type_15;
@group(0) @binding(1) 
var<storage> cells: type_7;
@group(0) @binding(0) 
var<uniform> params: type_19;
@group(0) @binding(2) 
var<storage> children: type_7;
@group(0) @binding(3) 
var<storage> finer: type_15;

fn function_() {
    var local: array<vec4<f32>, 8>;
    var phi_137_: u32;
    var phi_152_: u32;
    var phi_167_: u32;
    var phi_182_: u32;
    var phi_197_: u32;
    var phi_212_: u32;
    var phi_227_: u32;
    var phi_392_: vec4<f32>;
    var phi_429_: vec4<f32>;
    var phi_478_: vec4<f32>;
    var phi_525_: vec4<f32>;
    var phi_337_: vec4<f32>;
    var phi_539_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = gid_1;
            let _e33 = params.member.member_12;
            let _e36 = params.member.member_13;
            let _e40 = (_e28.x + (_e28.y * 2097152u));
            if (_e40 < _e36) {
                let _e42 = (_e33 + _e40);
                let _e45 = params.member.member_6;
                if (_e45 == 0u) {
                    break;
                }
                let _e47 = (_e42 / _e45);
                let _e49 = (_e42 - (_e47 * _e45));
                let _e52 = children.member[_e47];
                let _e55 = (2u * (_e52 >> bitcast<u32>(2i)));
                let _e59 = cells.member[_e55];
                let _e61 = ((8u * (_e52 & 3u)) & 31u);
                let _e63 = (_e59 >> bitcast<u32>(_e61));
                let _e67 = cells.member[(_e55 + 1u)];
                let _e73 = (_e67 + countOneBits((_e59 & ((1u << bitcast<u32>(_e61)) - 1u))));
                local[0u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[1u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[2u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[3u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[4u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[5u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[6u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[7u] = vec4<f32>(0f, 0f, 0f, 0f);
                if ((_e63 & 1u) == 1u) {
                    let _e88 = finer.member[((_e73 * _e45) + _e49)];
                    local[0u] = _e88;
                    phi_137_ = (_e73 + 1u);
                } else {
                    phi_137_ = _e73;
                }
                let _e91 = phi_137_;
                if (((_e63 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    let _e100 = finer.member[((_e91 * _e45) + _e49)];
                    local[1u] = _e100;
                    phi_152_ = (_e91 + 1u);
                } else {
                    phi_152_ = _e91;
                }
                let _e103 = phi_152_;
                if (((_e63 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    let _e112 = finer.member[((_e103 * _e45) + _e49)];
                    local[2u] = _e112;
                    phi_167_ = (_e103 + 1u);
                } else {
                    phi_167_ = _e103;
                }
                let _e115 = phi_167_;
                if (((_e63 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    let _e124 = finer.member[((_e115 * _e45) + _e49)];
                    local[3u] = _e124;
                    phi_182_ = (_e115 + 1u);
                } else {
                    phi_182_ = _e115;
                }
                let _e127 = phi_182_;
                if (((_e63 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    let _e136 = finer.member[((_e127 * _e45) + _e49)];
                    local[4u] = _e136;
                    phi_197_ = (_e127 + 1u);
                } else {
                    phi_197_ = _e127;
                }
                let _e139 = phi_197_;
                if (((_e63 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    let _e148 = finer.member[((_e139 * _e45) + _e49)];
                    local[5u] = _e148;
                    phi_212_ = (_e139 + 1u);
                } else {
                    phi_212_ = _e139;
                }
                let _e151 = phi_212_;
                if (((_e63 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    let _e160 = finer.member[((_e151 * _e45) + _e49)];
                    local[6u] = _e160;
                    phi_227_ = (_e151 + 1u);
                } else {
                    phi_227_ = _e151;
                }
                let _e163 = phi_227_;
                if (((_e63 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    let _e172 = finer.member[((_e163 * _e45) + _e49)];
                    local[7u] = _e172;
                }
                if (_e45 == 1u) {
                    let _e315 = local[0u];
                    let _e316 = local[1u];
                    let _e329 = local[2u];
                    let _e330 = local[3u];
                    let _e347 = local[4u];
                    let _e348 = local[5u];
                    let _e361 = local[6u];
                    let _e362 = local[7u];
                    let _e383 = ((((_e315.x + _e316.x) + (_e329.x + _e330.x)) + ((_e347.x + _e348.x) + (_e361.x + _e362.x))) * 0.25f);
                    let _e384 = ((((_e315.y + _e316.y) + (_e329.y + _e330.y)) + ((_e347.y + _e348.y) + (_e361.y + _e362.y))) * 0.25f);
                    let _e385 = ((((_e315.z + _e316.z) + (_e329.z + _e330.z)) + ((_e347.z + _e348.z) + (_e361.z + _e362.z))) * 0.25f);
                    let _e386 = ((((_e315.w + _e316.w) + (_e329.w + _e330.w)) + ((_e347.w + _e348.w) + (_e361.w + _e362.w))) * 0.25f);
                    if (_e386 > 1f) {
                        phi_337_ = vec4<f32>((_e383 / _e386), (_e384 / _e386), (_e385 / _e386), (_e386 / _e386));
                    } else {
                        phi_337_ = vec4<f32>(_e383, _e384, _e385, _e386);
                    }
                    let _e395 = phi_337_;
                    phi_539_ = _e395;
                } else {
                    let _e175 = (_e49 >> bitcast<u32>(1i));
                    let _e177 = ((_e49 & 1u) == 1u);
                    let _e180 = (1u << bitcast<u32>((_e175 & 31u)));
                    let _e182 = select(1u, 2u, (_e175 == 0u));
                    let _e184 = select(4u, 2u, (_e175 == 2u));
                    let _e185 = select(0u, _e180, _e177);
                    let _e186 = select(_e180, 0u, _e177);
                    if (_e185 < 8u) {
                    } else {
                        break;
                    }
                    let _e189 = local[_e185];
                    if (_e186 < 8u) {
                    } else {
                        break;
                    }
                    let _e192 = local[_e186];
                    let _e194 = (1f - _e189.w);
                    if (_e192.w <= _e194) {
                        phi_392_ = (_e189 + _e192);
                    } else {
                        let _e197 = (_e194 / _e192.w);
                        phi_392_ = (_e189 + vec4<f32>((_e192.x * _e197), (_e192.y * _e197), (_e192.z * _e197), _e194));
                    }
                    let _e208 = phi_392_;
                    let _e209 = (_e182 + _e185);
                    if (_e209 < 8u) {
                    } else {
                        break;
                    }
                    let _e212 = local[_e209];
                    let _e213 = (_e182 + _e186);
                    if (_e213 < 8u) {
                    } else {
                        break;
                    }
                    let _e216 = local[_e213];
                    let _e218 = (1f - _e212.w);
                    if (_e216.w <= _e218) {
                        phi_429_ = (_e212 + _e216);
                    } else {
                        let _e221 = (_e218 / _e216.w);
                        phi_429_ = (_e212 + vec4<f32>((_e216.x * _e221), (_e216.y * _e221), (_e216.z * _e221), _e218));
                    }
                    let _e232 = phi_429_;
                    let _e245 = (_e184 + _e185);
                    if (_e245 < 8u) {
                    } else {
                        break;
                    }
                    let _e248 = local[_e245];
                    let _e249 = (_e184 + _e186);
                    if (_e249 < 8u) {
                    } else {
                        break;
                    }
                    let _e252 = local[_e249];
                    let _e254 = (1f - _e248.w);
                    if (_e252.w <= _e254) {
                        phi_478_ = (_e248 + _e252);
                    } else {
                        let _e257 = (_e254 / _e252.w);
                        phi_478_ = (_e248 + vec4<f32>((_e252.x * _e257), (_e252.y * _e257), (_e252.z * _e257), _e254));
                    }
                    let _e268 = phi_478_;
                    let _e277 = (_e182 + _e184);
                    let _e278 = (_e277 + _e185);
                    if (_e278 < 8u) {
                    } else {
                        break;
                    }
                    let _e281 = local[_e278];
                    let _e282 = (_e277 + _e186);
                    if (_e282 < 8u) {
                    } else {
                        break;
                    }
                    let _e285 = local[_e282];
                    let _e287 = (1f - _e281.w);
                    if (_e285.w <= _e287) {
                        phi_525_ = (_e281 + _e285);
                    } else {
                        let _e290 = (_e287 / _e285.w);
                        phi_525_ = (_e281 + vec4<f32>((_e285.x * _e290), (_e285.y * _e290), (_e285.z * _e290), _e287));
                    }
                    let _e301 = phi_525_;
                    phi_539_ = vec4<f32>(((((_e208.x + _e232.x) + _e268.x) + _e301.x) * 0.25f), ((((_e208.y + _e232.y) + _e268.y) + _e301.y) * 0.25f), ((((_e208.z + _e232.z) + _e268.z) + _e301.z) * 0.25f), ((((_e208.w + _e232.w) + _e268.w) + _e301.w) * 0.25f));
                }
                let _e397 = phi_539_;
                let _e399 = (_e42 + (_e40 - _e40));
                if (_e399 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e399] = _e397;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_mip(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
