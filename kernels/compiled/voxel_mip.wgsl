struct type_8 {
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
var<storage> cells: type_8;
@group(0) @binding(0) 
var<uniform> params: type_19;
@group(0) @binding(2) 
var<storage> children: type_8;
@group(0) @binding(3) 
var<storage> finer: type_15;

fn function_() {
    var local: array<vec4<f32>, 8>;
    var phi_160_: u32;
    var phi_180_: u32;
    var phi_200_: u32;
    var phi_220_: u32;
    var phi_240_: u32;
    var phi_260_: u32;
    var phi_280_: u32;
    var phi_450_: vec4<f32>;
    var phi_487_: vec4<f32>;
    var phi_536_: vec4<f32>;
    var phi_583_: vec4<f32>;
    var phi_395_: vec4<f32>;
    var phi_597_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = gid_1;
            let _e30 = arrayLength((&cells.member));
            let _e34 = arrayLength((&finer.member));
            let _e39 = params.member.member_12;
            let _e42 = params.member.member_13;
            let _e46 = (_e28.x + (_e28.y * 2097152u));
            if (_e46 < _e42) {
                let _e48 = (_e39 + _e46);
                let _e51 = params.member.member_6;
                if (_e51 == 0u) {
                    break;
                }
                let _e53 = (_e48 / _e51);
                let _e55 = (_e48 - (_e53 * _e51));
                if (_e53 < arrayLength((&children.member))) {
                } else {
                    break;
                }
                let _e59 = children.member[_e53];
                let _e62 = (2u * (_e59 >> bitcast<u32>(2i)));
                if (_e62 < _e30) {
                } else {
                    break;
                }
                let _e67 = cells.member[_e62];
                let _e69 = ((8u * (_e59 & 3u)) & 31u);
                let _e71 = (_e67 >> bitcast<u32>(_e69));
                let _e72 = (_e62 + 1u);
                if (_e72 < _e30) {
                } else {
                    break;
                }
                let _e76 = cells.member[_e72];
                let _e82 = (_e76 + countOneBits((_e67 & ((1u << bitcast<u32>(_e69)) - 1u))));
                local[0u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[1u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[2u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[3u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[4u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[5u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[6u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[7u] = vec4<f32>(0f, 0f, 0f, 0f);
                if ((_e71 & 1u) == 1u) {
                    let _e94 = ((_e82 * _e51) + _e55);
                    if (_e94 < _e34) {
                    } else {
                        break;
                    }
                    let _e98 = finer.member[_e94];
                    local[0u] = _e98;
                    phi_160_ = (_e82 + 1u);
                } else {
                    phi_160_ = _e82;
                }
                let _e101 = phi_160_;
                if (((_e71 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    let _e107 = ((_e101 * _e51) + _e55);
                    if (_e107 < _e34) {
                    } else {
                        break;
                    }
                    let _e111 = finer.member[_e107];
                    local[1u] = _e111;
                    phi_180_ = (_e101 + 1u);
                } else {
                    phi_180_ = _e101;
                }
                let _e114 = phi_180_;
                if (((_e71 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    let _e120 = ((_e114 * _e51) + _e55);
                    if (_e120 < _e34) {
                    } else {
                        break;
                    }
                    let _e124 = finer.member[_e120];
                    local[2u] = _e124;
                    phi_200_ = (_e114 + 1u);
                } else {
                    phi_200_ = _e114;
                }
                let _e127 = phi_200_;
                if (((_e71 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    let _e133 = ((_e127 * _e51) + _e55);
                    if (_e133 < _e34) {
                    } else {
                        break;
                    }
                    let _e137 = finer.member[_e133];
                    local[3u] = _e137;
                    phi_220_ = (_e127 + 1u);
                } else {
                    phi_220_ = _e127;
                }
                let _e140 = phi_220_;
                if (((_e71 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    let _e146 = ((_e140 * _e51) + _e55);
                    if (_e146 < _e34) {
                    } else {
                        break;
                    }
                    let _e150 = finer.member[_e146];
                    local[4u] = _e150;
                    phi_240_ = (_e140 + 1u);
                } else {
                    phi_240_ = _e140;
                }
                let _e153 = phi_240_;
                if (((_e71 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    let _e159 = ((_e153 * _e51) + _e55);
                    if (_e159 < _e34) {
                    } else {
                        break;
                    }
                    let _e163 = finer.member[_e159];
                    local[5u] = _e163;
                    phi_260_ = (_e153 + 1u);
                } else {
                    phi_260_ = _e153;
                }
                let _e166 = phi_260_;
                if (((_e71 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    let _e172 = ((_e166 * _e51) + _e55);
                    if (_e172 < _e34) {
                    } else {
                        break;
                    }
                    let _e176 = finer.member[_e172];
                    local[6u] = _e176;
                    phi_280_ = (_e166 + 1u);
                } else {
                    phi_280_ = _e166;
                }
                let _e179 = phi_280_;
                if (((_e71 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    let _e185 = ((_e179 * _e51) + _e55);
                    if (_e185 < _e34) {
                    } else {
                        break;
                    }
                    let _e189 = finer.member[_e185];
                    local[7u] = _e189;
                }
                if (_e51 == 1u) {
                    let _e332 = local[0u];
                    let _e333 = local[1u];
                    let _e346 = local[2u];
                    let _e347 = local[3u];
                    let _e364 = local[4u];
                    let _e365 = local[5u];
                    let _e378 = local[6u];
                    let _e379 = local[7u];
                    let _e400 = ((((_e332.x + _e333.x) + (_e346.x + _e347.x)) + ((_e364.x + _e365.x) + (_e378.x + _e379.x))) * 0.25f);
                    let _e401 = ((((_e332.y + _e333.y) + (_e346.y + _e347.y)) + ((_e364.y + _e365.y) + (_e378.y + _e379.y))) * 0.25f);
                    let _e402 = ((((_e332.z + _e333.z) + (_e346.z + _e347.z)) + ((_e364.z + _e365.z) + (_e378.z + _e379.z))) * 0.25f);
                    let _e403 = ((((_e332.w + _e333.w) + (_e346.w + _e347.w)) + ((_e364.w + _e365.w) + (_e378.w + _e379.w))) * 0.25f);
                    if (_e403 > 1f) {
                        phi_395_ = vec4<f32>((_e400 / _e403), (_e401 / _e403), (_e402 / _e403), (_e403 / _e403));
                    } else {
                        phi_395_ = vec4<f32>(_e400, _e401, _e402, _e403);
                    }
                    let _e412 = phi_395_;
                    phi_597_ = _e412;
                } else {
                    let _e192 = (_e55 >> bitcast<u32>(1i));
                    let _e194 = ((_e55 & 1u) == 1u);
                    let _e197 = (1u << bitcast<u32>((_e192 & 31u)));
                    let _e199 = select(1u, 2u, (_e192 == 0u));
                    let _e201 = select(4u, 2u, (_e192 == 2u));
                    let _e202 = select(0u, _e197, _e194);
                    let _e203 = select(_e197, 0u, _e194);
                    if (_e202 < 8u) {
                    } else {
                        break;
                    }
                    let _e206 = local[_e202];
                    if (_e203 < 8u) {
                    } else {
                        break;
                    }
                    let _e209 = local[_e203];
                    let _e211 = (1f - _e206.w);
                    if (_e209.w <= _e211) {
                        phi_450_ = (_e206 + _e209);
                    } else {
                        let _e214 = (_e211 / _e209.w);
                        phi_450_ = (_e206 + vec4<f32>((_e209.x * _e214), (_e209.y * _e214), (_e209.z * _e214), _e211));
                    }
                    let _e225 = phi_450_;
                    let _e226 = (_e199 + _e202);
                    if (_e226 < 8u) {
                    } else {
                        break;
                    }
                    let _e229 = local[_e226];
                    let _e230 = (_e199 + _e203);
                    if (_e230 < 8u) {
                    } else {
                        break;
                    }
                    let _e233 = local[_e230];
                    let _e235 = (1f - _e229.w);
                    if (_e233.w <= _e235) {
                        phi_487_ = (_e229 + _e233);
                    } else {
                        let _e238 = (_e235 / _e233.w);
                        phi_487_ = (_e229 + vec4<f32>((_e233.x * _e238), (_e233.y * _e238), (_e233.z * _e238), _e235));
                    }
                    let _e249 = phi_487_;
                    let _e262 = (_e201 + _e202);
                    if (_e262 < 8u) {
                    } else {
                        break;
                    }
                    let _e265 = local[_e262];
                    let _e266 = (_e201 + _e203);
                    if (_e266 < 8u) {
                    } else {
                        break;
                    }
                    let _e269 = local[_e266];
                    let _e271 = (1f - _e265.w);
                    if (_e269.w <= _e271) {
                        phi_536_ = (_e265 + _e269);
                    } else {
                        let _e274 = (_e271 / _e269.w);
                        phi_536_ = (_e265 + vec4<f32>((_e269.x * _e274), (_e269.y * _e274), (_e269.z * _e274), _e271));
                    }
                    let _e285 = phi_536_;
                    let _e294 = (_e199 + _e201);
                    let _e295 = (_e294 + _e202);
                    if (_e295 < 8u) {
                    } else {
                        break;
                    }
                    let _e298 = local[_e295];
                    let _e299 = (_e294 + _e203);
                    if (_e299 < 8u) {
                    } else {
                        break;
                    }
                    let _e302 = local[_e299];
                    let _e304 = (1f - _e298.w);
                    if (_e302.w <= _e304) {
                        phi_583_ = (_e298 + _e302);
                    } else {
                        let _e307 = (_e304 / _e302.w);
                        phi_583_ = (_e298 + vec4<f32>((_e302.x * _e307), (_e302.y * _e307), (_e302.z * _e307), _e304));
                    }
                    let _e318 = phi_583_;
                    phi_597_ = vec4<f32>(((((_e225.x + _e249.x) + _e285.x) + _e318.x) * 0.25f), ((((_e225.y + _e249.y) + _e285.y) + _e318.y) * 0.25f), ((((_e225.z + _e249.z) + _e285.z) + _e318.z) * 0.25f), ((((_e225.w + _e249.w) + _e285.w) + _e318.w) * 0.25f));
                }
                let _e414 = phi_597_;
                let _e416 = (_e48 + (_e46 - _e46));
                if (_e416 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e416] = _e414;
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
