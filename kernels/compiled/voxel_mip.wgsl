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
    var phi_134_: u32;
    var phi_154_: u32;
    var phi_174_: u32;
    var phi_194_: u32;
    var phi_214_: u32;
    var phi_234_: u32;
    var phi_254_: u32;
    var phi_274_: u32;
    var phi_379_: vec4<f32>;
    var phi_601_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = gid_1;
            let _e34 = params.member.member_12;
            let _e37 = params.member.member_13;
            let _e41 = (_e29.x + (_e29.y * 2097152u));
            if (_e41 < _e37) {
                let _e43 = (_e34 + _e41);
                let _e46 = params.member.member_6;
                if (_e46 == 0u) {
                    break;
                }
                let _e48 = (_e43 / _e46);
                let _e50 = (_e43 - (_e48 * _e46));
                let _e53 = children.member[_e48];
                let _e56 = (2u * (_e53 >> bitcast<u32>(2i)));
                let _e60 = cells.member[_e56];
                let _e62 = ((8u * (_e53 & 3u)) & 31u);
                let _e64 = (_e60 >> bitcast<u32>(_e62));
                let _e68 = cells.member[(_e56 + 1u)];
                let _e74 = (_e68 + countOneBits((_e60 & ((1u << bitcast<u32>(_e62)) - 1u))));
                local[0u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[1u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[2u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[3u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[4u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[5u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[6u] = vec4<f32>(0f, 0f, 0f, 0f);
                local[7u] = vec4<f32>(0f, 0f, 0f, 0f);
                let _e83 = (_e64 & 1u);
                let _e84 = (_e83 == 1u);
                if _e84 {
                    phi_134_ = ((_e74 * _e46) + _e50);
                } else {
                    phi_134_ = 0u;
                }
                let _e88 = phi_134_;
                let _e91 = finer.member[_e88];
                local[0u] = select(vec4<f32>(0f, 0f, 0f, 0f), _e91, vec4(_e84));
                let _e94 = (_e74 + _e83);
                let _e97 = ((_e64 >> bitcast<u32>(1u)) & 1u);
                let _e98 = (_e97 == 1u);
                if _e98 {
                    phi_154_ = ((_e94 * _e46) + _e50);
                } else {
                    phi_154_ = 0u;
                }
                let _e102 = phi_154_;
                let _e105 = finer.member[_e102];
                local[1u] = select(vec4<f32>(0f, 0f, 0f, 0f), _e105, vec4(_e98));
                let _e108 = (_e94 + _e97);
                let _e111 = ((_e64 >> bitcast<u32>(2u)) & 1u);
                let _e112 = (_e111 == 1u);
                if _e112 {
                    phi_174_ = ((_e108 * _e46) + _e50);
                } else {
                    phi_174_ = 0u;
                }
                let _e116 = phi_174_;
                let _e119 = finer.member[_e116];
                local[2u] = select(vec4<f32>(0f, 0f, 0f, 0f), _e119, vec4(_e112));
                let _e122 = (_e108 + _e111);
                let _e125 = ((_e64 >> bitcast<u32>(3u)) & 1u);
                let _e126 = (_e125 == 1u);
                if _e126 {
                    phi_194_ = ((_e122 * _e46) + _e50);
                } else {
                    phi_194_ = 0u;
                }
                let _e130 = phi_194_;
                let _e133 = finer.member[_e130];
                local[3u] = select(vec4<f32>(0f, 0f, 0f, 0f), _e133, vec4(_e126));
                let _e136 = (_e122 + _e125);
                let _e139 = ((_e64 >> bitcast<u32>(4u)) & 1u);
                let _e140 = (_e139 == 1u);
                if _e140 {
                    phi_214_ = ((_e136 * _e46) + _e50);
                } else {
                    phi_214_ = 0u;
                }
                let _e144 = phi_214_;
                let _e147 = finer.member[_e144];
                local[4u] = select(vec4<f32>(0f, 0f, 0f, 0f), _e147, vec4(_e140));
                let _e150 = (_e136 + _e139);
                let _e153 = ((_e64 >> bitcast<u32>(5u)) & 1u);
                let _e154 = (_e153 == 1u);
                if _e154 {
                    phi_234_ = ((_e150 * _e46) + _e50);
                } else {
                    phi_234_ = 0u;
                }
                let _e158 = phi_234_;
                let _e161 = finer.member[_e158];
                local[5u] = select(vec4<f32>(0f, 0f, 0f, 0f), _e161, vec4(_e154));
                let _e164 = (_e150 + _e153);
                let _e167 = ((_e64 >> bitcast<u32>(6u)) & 1u);
                let _e168 = (_e167 == 1u);
                if _e168 {
                    phi_254_ = ((_e164 * _e46) + _e50);
                } else {
                    phi_254_ = 0u;
                }
                let _e172 = phi_254_;
                let _e175 = finer.member[_e172];
                local[6u] = select(vec4<f32>(0f, 0f, 0f, 0f), _e175, vec4(_e168));
                let _e182 = (((_e64 >> bitcast<u32>(7u)) & 1u) == 1u);
                if _e182 {
                    phi_274_ = (((_e164 + _e167) * _e46) + _e50);
                } else {
                    phi_274_ = 0u;
                }
                let _e186 = phi_274_;
                let _e189 = finer.member[_e186];
                local[7u] = select(vec4<f32>(0f, 0f, 0f, 0f), _e189, vec4(_e182));
                if (_e46 == 1u) {
                    let _e342 = local[0u];
                    let _e343 = local[1u];
                    let _e356 = local[2u];
                    let _e357 = local[3u];
                    let _e374 = local[4u];
                    let _e375 = local[5u];
                    let _e388 = local[6u];
                    let _e389 = local[7u];
                    let _e410 = ((((_e342.x + _e343.x) + (_e356.x + _e357.x)) + ((_e374.x + _e375.x) + (_e388.x + _e389.x))) * 0.25f);
                    let _e411 = ((((_e342.y + _e343.y) + (_e356.y + _e357.y)) + ((_e374.y + _e375.y) + (_e388.y + _e389.y))) * 0.25f);
                    let _e412 = ((((_e342.z + _e343.z) + (_e356.z + _e357.z)) + ((_e374.z + _e375.z) + (_e388.z + _e389.z))) * 0.25f);
                    let _e413 = ((((_e342.w + _e343.w) + (_e356.w + _e357.w)) + ((_e374.w + _e375.w) + (_e388.w + _e389.w))) * 0.25f);
                    if (_e413 > 1f) {
                        phi_379_ = vec4<f32>((_e410 / _e413), (_e411 / _e413), (_e412 / _e413), (_e413 / _e413));
                    } else {
                        phi_379_ = vec4<f32>(_e410, _e411, _e412, _e413);
                    }
                    let _e422 = phi_379_;
                    phi_601_ = _e422;
                } else {
                    let _e194 = (_e50 >> bitcast<u32>(1i));
                    let _e196 = ((_e50 & 1u) == 1u);
                    let _e199 = (1u << bitcast<u32>((_e194 & 31u)));
                    let _e201 = select(1u, 2u, (_e194 == 0u));
                    let _e203 = select(4u, 2u, (_e194 == 2u));
                    let _e204 = select(0u, _e199, _e196);
                    let _e205 = select(_e199, 0u, _e196);
                    if (_e204 < 8u) {
                    } else {
                        break;
                    }
                    let _e208 = local[_e204];
                    if (_e205 < 8u) {
                    } else {
                        break;
                    }
                    let _e211 = local[_e205];
                    let _e217 = ((1f - _e208.w) / select(0.000000000000000000000000000000000000011754944f, _e211.w, (_e211.w > 0.000000000000000000000000000000000000011754944f)));
                    let _e219 = select(1f, _e217, (_e217 < 1f));
                    let _e234 = (_e201 + _e204);
                    if (_e234 < 8u) {
                    } else {
                        break;
                    }
                    let _e237 = local[_e234];
                    let _e238 = (_e201 + _e205);
                    if (_e238 < 8u) {
                    } else {
                        break;
                    }
                    let _e241 = local[_e238];
                    let _e247 = ((1f - _e237.w) / select(0.000000000000000000000000000000000000011754944f, _e241.w, (_e241.w > 0.000000000000000000000000000000000000011754944f)));
                    let _e249 = select(1f, _e247, (_e247 < 1f));
                    let _e268 = (_e203 + _e204);
                    if (_e268 < 8u) {
                    } else {
                        break;
                    }
                    let _e271 = local[_e268];
                    let _e272 = (_e203 + _e205);
                    if (_e272 < 8u) {
                    } else {
                        break;
                    }
                    let _e275 = local[_e272];
                    let _e281 = ((1f - _e271.w) / select(0.000000000000000000000000000000000000011754944f, _e275.w, (_e275.w > 0.000000000000000000000000000000000000011754944f)));
                    let _e283 = select(1f, _e281, (_e281 < 1f));
                    let _e302 = (_e201 + _e203);
                    let _e303 = (_e302 + _e204);
                    if (_e303 < 8u) {
                    } else {
                        break;
                    }
                    let _e306 = local[_e303];
                    let _e307 = (_e302 + _e205);
                    if (_e307 < 8u) {
                    } else {
                        break;
                    }
                    let _e310 = local[_e307];
                    let _e316 = ((1f - _e306.w) / select(0.000000000000000000000000000000000000011754944f, _e310.w, (_e310.w > 0.000000000000000000000000000000000000011754944f)));
                    let _e318 = select(1f, _e316, (_e316 < 1f));
                    phi_601_ = vec4<f32>((((((_e208.x + (_e211.x * _e219)) + (_e237.x + (_e241.x * _e249))) + (_e271.x + (_e275.x * _e283))) + (_e306.x + (_e310.x * _e318))) * 0.25f), (((((_e208.y + (_e211.y * _e219)) + (_e237.y + (_e241.y * _e249))) + (_e271.y + (_e275.y * _e283))) + (_e306.y + (_e310.y * _e318))) * 0.25f), (((((_e208.z + (_e211.z * _e219)) + (_e237.z + (_e241.z * _e249))) + (_e271.z + (_e275.z * _e283))) + (_e306.z + (_e310.z * _e318))) * 0.25f), (((((_e208.w + (_e211.w * _e219)) + (_e237.w + (_e241.w * _e249))) + (_e271.w + (_e275.w * _e283))) + (_e306.w + (_e310.w * _e318))) * 0.25f));
                }
                let _e424 = phi_601_;
                let _e426 = (_e43 + (_e41 - _e41));
                if (_e426 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e426] = _e424;
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
