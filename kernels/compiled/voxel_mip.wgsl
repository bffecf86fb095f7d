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
    var phi_124_: vec4<f32>;
    var phi_138_: vec4<f32>;
    var phi_152_: vec4<f32>;
    var phi_166_: vec4<f32>;
    var phi_180_: vec4<f32>;
    var phi_194_: vec4<f32>;
    var phi_208_: vec4<f32>;
    var phi_222_: vec4<f32>;
    var phi_316_: vec4<f32>;
    var phi_368_: vec4<f32>;
    var phi_383_: vec4<f32>;
    var phi_435_: vec4<f32>;
    var phi_457_: vec4<f32>;
    var phi_514_: vec4<f32>;
    var phi_532_: vec4<f32>;
    var phi_584_: vec4<f32>;
    var phi_303_: vec4<f32>;
    var phi_598_: vec4<f32>;

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
                let _e74 = (_e63 & 1u);
                if (_e74 == 1u) {
                    let _e80 = finer.member[((_e73 * _e45) + _e49)];
                    phi_124_ = _e80;
                } else {
                    phi_124_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e82 = phi_124_;
                let _e83 = (_e73 + _e74);
                let _e86 = ((_e63 >> bitcast<u32>(1u)) & 1u);
                if (_e86 == 1u) {
                    let _e92 = finer.member[((_e83 * _e45) + _e49)];
                    phi_138_ = _e92;
                } else {
                    phi_138_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e94 = phi_138_;
                let _e95 = (_e83 + _e86);
                let _e98 = ((_e63 >> bitcast<u32>(2u)) & 1u);
                if (_e98 == 1u) {
                    let _e104 = finer.member[((_e95 * _e45) + _e49)];
                    phi_152_ = _e104;
                } else {
                    phi_152_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e106 = phi_152_;
                let _e107 = (_e95 + _e98);
                let _e110 = ((_e63 >> bitcast<u32>(3u)) & 1u);
                if (_e110 == 1u) {
                    let _e116 = finer.member[((_e107 * _e45) + _e49)];
                    phi_166_ = _e116;
                } else {
                    phi_166_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e118 = phi_166_;
                let _e119 = (_e107 + _e110);
                let _e122 = ((_e63 >> bitcast<u32>(4u)) & 1u);
                if (_e122 == 1u) {
                    let _e128 = finer.member[((_e119 * _e45) + _e49)];
                    phi_180_ = _e128;
                } else {
                    phi_180_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e130 = phi_180_;
                let _e131 = (_e119 + _e122);
                let _e134 = ((_e63 >> bitcast<u32>(5u)) & 1u);
                if (_e134 == 1u) {
                    let _e140 = finer.member[((_e131 * _e45) + _e49)];
                    phi_194_ = _e140;
                } else {
                    phi_194_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e142 = phi_194_;
                let _e143 = (_e131 + _e134);
                let _e146 = ((_e63 >> bitcast<u32>(6u)) & 1u);
                if (_e146 == 1u) {
                    let _e152 = finer.member[((_e143 * _e45) + _e49)];
                    phi_208_ = _e152;
                } else {
                    phi_208_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e154 = phi_208_;
                if (((_e63 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    let _e164 = finer.member[(((_e143 + _e146) * _e45) + _e49)];
                    phi_222_ = _e164;
                } else {
                    phi_222_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e166 = phi_222_;
                if (_e45 == 1u) {
                    let _e433 = ((((_e82.x + _e94.x) + (_e106.x + _e118.x)) + ((_e130.x + _e142.x) + (_e154.x + _e166.x))) * 0.25f);
                    let _e434 = ((((_e82.y + _e94.y) + (_e106.y + _e118.y)) + ((_e130.y + _e142.y) + (_e154.y + _e166.y))) * 0.25f);
                    let _e435 = ((((_e82.z + _e94.z) + (_e106.z + _e118.z)) + ((_e130.z + _e142.z) + (_e154.z + _e166.z))) * 0.25f);
                    let _e436 = ((((_e82.w + _e94.w) + (_e106.w + _e118.w)) + ((_e130.w + _e142.w) + (_e154.w + _e166.w))) * 0.25f);
                    if (_e436 > 1f) {
                        phi_303_ = vec4<f32>((_e433 / _e436), (_e434 / _e436), (_e435 / _e436), (_e436 / _e436));
                    } else {
                        phi_303_ = vec4<f32>(_e433, _e434, _e435, _e436);
                    }
                    let _e445 = phi_303_;
                    phi_598_ = _e445;
                } else {
                    let _e169 = (_e49 >> bitcast<u32>(1i));
                    let _e171 = ((_e49 & 1u) == 1u);
                    let _e172 = (_e169 == 0u);
                    if _e172 {
                        phi_316_ = _e94;
                    } else {
                        phi_316_ = select(_e130, _e106, vec4((_e169 == 1u)));
                    }
                    let _e177 = phi_316_;
                    if _e171 {
                        let _e200 = ((1f - _e177.w) / select(0.000000000000000000000000000000000000011754944f, _e82.w, (_e82.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e202 = select(1f, _e200, (_e200 < 1f));
                        phi_368_ = (_e177 + vec4<f32>((_e82.x * _e202), (_e82.y * _e202), (_e82.z * _e202), (_e82.w * _e202)));
                    } else {
                        let _e183 = ((1f - _e82.w) / select(0.000000000000000000000000000000000000011754944f, _e177.w, (_e177.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e185 = select(1f, _e183, (_e183 < 1f));
                        phi_368_ = (_e82 + vec4<f32>((_e177.x * _e185), (_e177.y * _e185), (_e177.z * _e185), (_e177.w * _e185)));
                    }
                    let _e213 = phi_368_;
                    let _e214 = vec4(_e172);
                    let _e215 = select(_e94, _e106, _e214);
                    if _e172 {
                        phi_383_ = _e118;
                    } else {
                        phi_383_ = select(_e142, _e118, vec4((_e169 == 1u)));
                    }
                    let _e220 = phi_383_;
                    if _e171 {
                        let _e243 = ((1f - _e220.w) / select(0.000000000000000000000000000000000000011754944f, _e215.w, (_e215.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e245 = select(1f, _e243, (_e243 < 1f));
                        phi_435_ = (_e220 + vec4<f32>((_e215.x * _e245), (_e215.y * _e245), (_e215.z * _e245), (_e215.w * _e245)));
                    } else {
                        let _e226 = ((1f - _e215.w) / select(0.000000000000000000000000000000000000011754944f, _e220.w, (_e220.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e228 = select(1f, _e226, (_e226 < 1f));
                        phi_435_ = (_e215 + vec4<f32>((_e220.x * _e228), (_e220.y * _e228), (_e220.z * _e228), (_e220.w * _e228)));
                    }
                    let _e256 = phi_435_;
                    if _e172 {
                        phi_457_ = _e130;
                    } else {
                        phi_457_ = select(_e106, _e130, vec4((_e169 == 1u)));
                    }
                    let _e273 = phi_457_;
                    let _e274 = select(_e154, _e142, _e214);
                    if _e171 {
                        let _e297 = ((1f - _e274.w) / select(0.000000000000000000000000000000000000011754944f, _e273.w, (_e273.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e299 = select(1f, _e297, (_e297 < 1f));
                        phi_514_ = (_e274 + vec4<f32>((_e273.x * _e299), (_e273.y * _e299), (_e273.z * _e299), (_e273.w * _e299)));
                    } else {
                        let _e280 = ((1f - _e273.w) / select(0.000000000000000000000000000000000000011754944f, _e274.w, (_e274.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e282 = select(1f, _e280, (_e280 < 1f));
                        phi_514_ = (_e273 + vec4<f32>((_e274.x * _e282), (_e274.y * _e282), (_e274.z * _e282), (_e274.w * _e282)));
                    }
                    let _e310 = phi_514_;
                    if _e172 {
                        phi_532_ = _e154;
                    } else {
                        phi_532_ = select(_e118, _e142, vec4((_e169 == 1u)));
                    }
                    let _e323 = phi_532_;
                    if _e171 {
                        let _e346 = ((1f - _e166.w) / select(0.000000000000000000000000000000000000011754944f, _e323.w, (_e323.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e348 = select(1f, _e346, (_e346 < 1f));
                        phi_584_ = (_e166 + vec4<f32>((_e323.x * _e348), (_e323.y * _e348), (_e323.z * _e348), (_e323.w * _e348)));
                    } else {
                        let _e329 = ((1f - _e323.w) / select(0.000000000000000000000000000000000000011754944f, _e166.w, (_e166.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e331 = select(1f, _e329, (_e329 < 1f));
                        phi_584_ = (_e323 + vec4<f32>((_e166.x * _e331), (_e166.y * _e331), (_e166.z * _e331), (_e166.w * _e331)));
                    }
                    let _e359 = phi_584_;
                    phi_598_ = vec4<f32>(((((_e213.x + _e256.x) + _e310.x) + _e359.x) * 0.25f), ((((_e213.y + _e256.y) + _e310.y) + _e359.y) * 0.25f), ((((_e213.z + _e256.z) + _e310.z) + _e359.z) * 0.25f), ((((_e213.w + _e256.w) + _e310.w) + _e359.w) * 0.25f));
                }
                let _e447 = phi_598_;
                let _e449 = (_e42 + (_e40 - _e40));
                if (_e449 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e449] = _e447;
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
