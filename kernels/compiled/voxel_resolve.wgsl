struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<u32>,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_24 {
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
    member_16: vec4<u32>,
}

struct type_25 {
    member: type_24,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> cells: type_10;
@group(0) @binding(2) 
var<storage> facet_bits: type_10;
@group(0) @binding(0) 
var<uniform> params: type_25;
@group(0) @binding(3) 
var<storage> sums: type_10;
@group(0) @binding(4) 
var<storage, read_write> out: type_20;

fn function_() {
    var phi_91_: u32;
    var phi_94_: u32;
    var phi_92_: u32;
    var phi_95_: u32;
    var phi_469_: bool;
    var local: u32;
    var local_1: u32;
    var phi_477_: bool;
    var phi_140_: u32;
    var phi_143_: u32;
    var phi_153_: type_7;
    var phi_156_: u32;
    var phi_154_: type_7;
    var phi_179_: type_7;
    var phi_157_: u32;
    var phi_473_: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_210_: u32;
    var phi_211_: u32;
    var phi_141_: u32;
    var phi_144_: u32;
    var phi_213_: bool;
    var local_4: bool;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e34 = gid_1;
            let _e36 = arrayLength((&cells.member));
            let _e40 = arrayLength((&sums.member));
            let _e46 = (_e34.x + (_e34.y * 2097152u));
            let _e47 = (_e46 < arrayLength((&out.member)));
            if _e47 {
                let _e52 = params.member.member_2[0u][3u];
                phi_91_ = _e52;
                phi_94_ = 0u;
                loop {
                    let _e54 = phi_91_;
                    let _e56 = phi_94_;
                    local = _e56;
                    local_1 = _e56;
                    local_5 = _e56;
                    local_6 = _e56;
                    let _e58 = ((_e54 - _e56) > 1u);
                    if _e58 {
                        let _e60 = ((_e56 + _e54) / 2u);
                        let _e62 = ((_e60 * 2u) + 1u);
                        if (_e62 < _e36) {
                        } else {
                            phi_469_ = true;
                            break;
                        }
                        let _e66 = cells.member[_e62];
                        let _e67 = (_e66 <= _e46);
                        phi_92_ = select(_e60, _e54, _e67);
                        phi_95_ = select(_e56, _e60, _e67);
                    } else {
                        phi_92_ = u32();
                        phi_95_ = u32();
                    }
                    let _e71 = phi_92_;
                    let _e73 = phi_95_;
                    continue;
                    continuing {
                        phi_91_ = _e71;
                        phi_94_ = _e73;
                        phi_469_ = false;
                        break if !(_e58);
                    }
                }
                let _e76 = phi_469_;
                if _e76 {
                    break;
                }
                let _e78 = local;
                let _e79 = (2u * _e78);
                if (_e79 < _e36) {
                } else {
                    break;
                }
                let _e83 = cells.member[_e79];
                let _e84 = (_e79 + 1u);
                if (_e84 < _e36) {
                } else {
                    break;
                }
                let _e88 = cells.member[_e84];
                let _e91 = local_1;
                phi_477_ = _e76;
                phi_140_ = (_e46 - _e88);
                phi_143_ = _e83;
                loop {
                    let _e94 = phi_477_;
                    let _e96 = phi_140_;
                    let _e98 = phi_143_;
                    let _e100 = (_e98 == 0u);
                    let _e102 = (select(firstTrailingBit(_e98), 32u, _e100) & 31u);
                    phi_153_ = type_7(0u, 6u);
                    phi_156_ = 0u;
                    local_7 = _e102;
                    local_8 = _e102;
                    local_9 = _e102;
                    local_10 = _e102;
                    loop {
                        let _e104 = phi_153_;
                        let _e106 = phi_156_;
                        local_2 = _e106;
                        local_3 = _e106;
                        if (_e104.member < _e104.member_1) {
                            phi_154_ = type_7((_e104.member + 1u), _e104.member_1);
                            phi_179_ = type_7(1u, _e104.member);
                        } else {
                            phi_154_ = _e104;
                            phi_179_ = type_7(0u, type_7().member_1);
                        }
                        let _e119 = phi_154_;
                        let _e121 = phi_179_;
                        let _e125 = (bitcast<i32>(_e121.member) != 0i);
                        if _e125 {
                            let _e126 = ((_e91 * 6u) + _e121.member_1);
                            if (_e126 < arrayLength((&facet_bits.member))) {
                            } else {
                                phi_473_ = true;
                                break;
                            }
                            let _e130 = facet_bits.member[_e126];
                            phi_157_ = (_e106 + ((_e130 >> bitcast<u32>((_e102 & 31u))) & 1u));
                        } else {
                            phi_157_ = u32();
                        }
                        let _e137 = phi_157_;
                        continue;
                        continuing {
                            phi_153_ = _e119;
                            phi_156_ = _e137;
                            phi_473_ = _e94;
                            break if !(_e125);
                        }
                    }
                    let _e140 = phi_473_;
                    local_4 = _e140;
                    if _e140 {
                        break;
                    }
                    let _e142 = local_2;
                    if (_e96 < _e142) {
                        phi_141_ = u32();
                        phi_144_ = u32();
                        phi_213_ = false;
                    } else {
                        if _e100 {
                            phi_210_ = u32();
                            phi_211_ = u32();
                        } else {
                            let _e145 = local_3;
                            phi_210_ = (_e96 - _e145);
                            phi_211_ = (_e98 & (_e98 - 1u));
                        }
                        let _e150 = phi_210_;
                        let _e152 = phi_211_;
                        phi_141_ = _e150;
                        phi_144_ = _e152;
                        phi_213_ = select(true, false, _e100);
                    }
                    let _e155 = phi_141_;
                    let _e157 = phi_144_;
                    let _e159 = phi_213_;
                    continue;
                    continuing {
                        phi_477_ = _e140;
                        phi_140_ = _e155;
                        phi_143_ = _e157;
                        break if !(_e159);
                    }
                }
                let _e162 = local_4;
                if _e162 {
                    break;
                }
                let _e166 = params.member.member_2[0u];
                if (_e166.y == 0u) {
                    break;
                }
                let _e170 = local_5;
                let _e171 = (_e170 / _e166.y);
                let _e174 = local_6;
                let _e175 = (_e174 - (_e171 * _e166.y));
                if (_e166.x == 0u) {
                    break;
                }
                let _e178 = (_e175 / _e166.x);
                let _e184 = local_7;
                let _e188 = local_8;
                let _e190 = (_e188 >> bitcast<u32>(2i));
                let _e192 = ((((_e175 - (_e178 * _e166.x)) << bitcast<u32>(2i)) | (_e184 & 1u)) | (_e190 & 2u));
                let _e196 = local_9;
                let _e202 = local_10;
                let _e206 = (((_e178 << bitcast<u32>(2i)) | ((_e196 >> bitcast<u32>(1i)) & 1u)) | ((_e202 >> bitcast<u32>(3i)) & 2u));
                let _e210 = ((_e171 << bitcast<u32>(1i)) | (_e190 & 1u));
                let _e211 = (_e46 * 13u);
                if (_e211 < _e40) {
                } else {
                    break;
                }
                let _e215 = sums.member[_e211];
                let _e216 = f32(_e215);
                let _e218 = select(1f, _e216, (_e216 > 1f));
                let _e219 = (_e211 + 4u);
                if (_e219 < _e40) {
                } else {
                    break;
                }
                let _e223 = sums.member[_e219];
                let _e226 = (_e211 + 5u);
                if (_e226 < _e40) {
                } else {
                    break;
                }
                let _e230 = sums.member[_e226];
                let _e233 = (_e211 + 6u);
                if (_e233 < _e40) {
                } else {
                    break;
                }
                let _e237 = sums.member[_e233];
                let _e245 = params.member.member;
                let _e258 = params.member.member[3u];
                let _e267 = params.member.member_1;
                let _e271 = params.member.member_7;
                let _e273 = (_e211 + 1u);
                if (_e273 < _e40) {
                } else {
                    break;
                }
                let _e277 = sums.member[_e273];
                let _e280 = (_e211 + 2u);
                if (_e280 < _e40) {
                } else {
                    break;
                }
                let _e284 = sums.member[_e280];
                let _e287 = (_e211 + 3u);
                if (_e287 < _e40) {
                } else {
                    break;
                }
                let _e291 = sums.member[_e287];
                let _e304 = (_e211 + 7u);
                if (_e304 < _e40) {
                } else {
                    break;
                }
                let _e308 = sums.member[_e304];
                let _e311 = (_e211 + 8u);
                if (_e311 < _e40) {
                } else {
                    break;
                }
                let _e315 = sums.member[_e311];
                let _e318 = (_e211 + 9u);
                if (_e318 < _e40) {
                } else {
                    break;
                }
                let _e322 = sums.member[_e318];
                let _e329 = (_e211 + 10u);
                if (_e329 < _e40) {
                } else {
                    break;
                }
                let _e333 = sums.member[_e329];
                let _e336 = (_e211 + 11u);
                if (_e336 < _e40) {
                } else {
                    break;
                }
                let _e340 = sums.member[_e336];
                let _e343 = (_e211 + 12u);
                if (_e343 < _e40) {
                } else {
                    break;
                }
                let _e347 = sums.member[_e343];
                let _e352 = params.member.member_8;
                let _e353 = (_e352 / _e218);
                if _e47 {
                } else {
                    break;
                }
                out.member[_e46] = type_18(array<f32, 3>((_e245.x + ((f32(_e192) + (f32(bitcast<i32>(_e223)) / _e218)) * _e258)), (_e245.y + ((f32(_e206) + (f32(bitcast<i32>(_e230)) / _e218)) * _e258)), (_e245.z + ((f32(_e210) + (f32(bitcast<i32>(_e237)) / _e218)) * _e258))), (_e218 / _e271), array<f32, 3>((f32(bitcast<i32>(_e277)) / _e271), (f32(bitcast<i32>(_e284)) / _e271), (f32(bitcast<i32>(_e291)) / _e271)), (_e192 + (_e267.x * (_e206 + (_e267.y * _e210)))), array<f32, 3>((f32(bitcast<i32>(_e308)) / _e218), (f32(bitcast<i32>(_e315)) / _e218), (f32(bitcast<i32>(_e322)) / _e218)), 0u, array<f32, 3>((f32(bitcast<i32>(_e333)) * _e353), (f32(bitcast<i32>(_e340)) * _e353), (f32(bitcast<i32>(_e347)) * _e353)), 0u);
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
