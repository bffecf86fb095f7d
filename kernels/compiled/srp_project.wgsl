struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: f32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_13 {
    member: type_12,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> table: type_5;
@group(0) @binding(0) 
var<uniform> params: type_13;
@group(0) @binding(2) 
var<storage> light: type_5;
@group(0) @binding(3) 
var<storage, read_write> partial: type_5;

fn function_() {
    var phi_96_: u32;
    var phi_114_: u32;
    var phi_132_: u32;
    var phi_194_: u32;
    var phi_212_: u32;
    var phi_230_: u32;
    var phi_266_: type_10;
    var phi_269_: u32;
    var phi_271_: u32;
    var phi_273_: array<f32, 24>;
    var phi_267_: type_10;
    var phi_296_: type_10;
    var phi_270_: u32;
    var phi_272_: u32;
    var phi_274_: array<f32, 24>;
    var local: array<f32, 24>;
    var local_1: array<f32, 24>;
    var local_2: array<f32, 24>;
    var local_3: array<f32, 24>;
    var local_4: array<f32, 24>;
    var local_5: array<f32, 24>;
    var local_6: array<f32, 24>;
    var local_7: array<f32, 24>;
    var local_8: array<f32, 24>;
    var local_9: array<f32, 24>;
    var local_10: array<f32, 24>;
    var local_11: array<f32, 24>;
    var local_12: array<f32, 24>;
    var local_13: array<f32, 24>;
    var local_14: array<f32, 24>;
    var local_15: array<f32, 24>;
    var local_16: array<f32, 24>;
    var local_17: array<f32, 24>;
    var local_18: array<f32, 24>;
    var local_19: array<f32, 24>;
    var local_20: array<f32, 24>;
    var local_21: array<f32, 24>;
    var local_22: array<f32, 24>;
    var local_23: array<f32, 24>;

    switch bitcast<i32>(0u) {
        default: {
            let _e46 = gid_1;
            let _e49 = params.member.member_3;
            let _e51 = select(_e49, 16u, (_e49 == 0u));
            let _e54 = params.member.member;
            let _e55 = (_e54 / 16u);
            let _e57 = ((_e54 % 16u) > 0u);
            if _e57 {
                phi_96_ = (_e55 + 1u);
            } else {
                phi_96_ = _e55;
            }
            let _e60 = phi_96_;
            let _e63 = params.member.member_2;
            let _e64 = (_e63 / 8u);
            let _e66 = ((_e63 % 8u) > 0u);
            if _e66 {
                phi_114_ = (_e64 + 1u);
            } else {
                phi_114_ = _e64;
            }
            let _e69 = phi_114_;
            let _e72 = params.member.member_1;
            let _e73 = (_e51 == 0u);
            if _e73 {
                break;
            }
            let _e74 = (_e72 / _e51);
            if _e73 {
                break;
            }
            let _e76 = ((_e72 % _e51) > 0u);
            if _e76 {
                phi_132_ = (_e74 + 1u);
            } else {
                phi_132_ = _e74;
            }
            let _e79 = phi_132_;
            let _e80 = (_e60 * _e69);
            let _e83 = params.member.member_6;
            let _e87 = params.member.member_5;
            let _e91 = ((_e79 * _e60) * _e69);
            let _e96 = (_e46.x + (_e46.y * 2097152u));
            if (_e96 < ((_e83 * _e80) * 16u)) {
                let _e99 = (_e96 / 16u);
                let _e100 = (_e99 * 16u);
                let _e101 = (_e96 - _e100);
                let _e103 = ((((_e87 * _e80) * 16u) + _e100) + _e101);
                if _e57 {
                    phi_194_ = (_e55 + 1u);
                } else {
                    phi_194_ = _e55;
                }
                let _e106 = phi_194_;
                if _e66 {
                    phi_212_ = (_e64 + 1u);
                } else {
                    phi_212_ = _e64;
                }
                let _e109 = phi_212_;
                if _e73 {
                    break;
                }
                if _e73 {
                    break;
                }
                if _e76 {
                    phi_230_ = (_e74 + 1u);
                } else {
                    phi_230_ = _e74;
                }
                let _e112 = phi_230_;
                if (_e109 == 0u) {
                    break;
                }
                let _e114 = (_e99 / _e109);
                if (_e106 == 0u) {
                    break;
                }
                let _e121 = (((_e106 * _e51) * 16u) * _e83);
                let _e125 = ((_e99 - (_e114 * _e109)) * 8u);
                phi_266_ = type_10(0u, _e51);
                phi_269_ = (((_e51 * (((_e125 / 8u) * _e112) + (_e87 + (_e114 / _e106)))) * 8u) + (_e125 % 8u));
                phi_271_ = (((_e114 * _e51) * 16u) + _e101);
                phi_273_ = array<f32, 24>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e136 = phi_266_;
                    let _e138 = phi_269_;
                    let _e140 = phi_271_;
                    let _e142 = phi_273_;
                    local = _e142;
                    local_1 = _e142;
                    local_2 = _e142;
                    local_3 = _e142;
                    local_4 = _e142;
                    local_5 = _e142;
                    local_6 = _e142;
                    local_7 = _e142;
                    local_8 = _e142;
                    local_9 = _e142;
                    local_10 = _e142;
                    local_11 = _e142;
                    local_12 = _e142;
                    local_13 = _e142;
                    local_14 = _e142;
                    local_15 = _e142;
                    local_16 = _e142;
                    local_17 = _e142;
                    local_18 = _e142;
                    local_19 = _e142;
                    local_20 = _e142;
                    local_21 = _e142;
                    local_22 = _e142;
                    local_23 = _e142;
                    if (_e136.member < _e136.member_1) {
                        phi_267_ = type_10((_e136.member + 1u), _e136.member_1);
                        phi_296_ = type_10(1u, _e136.member);
                    } else {
                        phi_267_ = _e136;
                        phi_296_ = type_10(0u, type_10().member_1);
                    }
                    let _e155 = phi_267_;
                    let _e157 = phi_296_;
                    let _e160 = (bitcast<i32>(_e157.member) != 0i);
                    if _e160 {
                        let _e163 = light.member[_e140];
                        let _e167 = light.member[(_e121 + _e140)];
                        let _e172 = light.member[((2u * _e121) + _e140)];
                        let _e175 = table.member[_e138];
                        let _e188 = table.member[(_e138 + 1u)];
                        let _e201 = table.member[(_e138 + 2u)];
                        let _e214 = table.member[(_e138 + 3u)];
                        let _e227 = table.member[(_e138 + 4u)];
                        let _e240 = table.member[(_e138 + 5u)];
                        let _e253 = table.member[(_e138 + 6u)];
                        let _e266 = table.member[(_e138 + 7u)];
                        phi_270_ = (_e138 + 8u);
                        phi_272_ = (_e140 + 16u);
                        phi_274_ = array<f32, 24>((_e142[0] + (_e163 * _e175)), (_e142[1] + (_e163 * _e188)), (_e142[2] + (_e163 * _e201)), (_e142[3] + (_e163 * _e214)), (_e142[4] + (_e163 * _e227)), (_e142[5] + (_e163 * _e240)), (_e142[6] + (_e163 * _e253)), (_e142[7] + (_e163 * _e266)), (_e142[8] + (_e167 * _e175)), (_e142[9] + (_e167 * _e188)), (_e142[10] + (_e167 * _e201)), (_e142[11] + (_e167 * _e214)), (_e142[12] + (_e167 * _e227)), (_e142[13] + (_e167 * _e240)), (_e142[14] + (_e167 * _e253)), (_e142[15] + (_e167 * _e266)), (_e142[16] + (_e172 * _e175)), (_e142[17] + (_e172 * _e188)), (_e142[18] + (_e172 * _e201)), (_e142[19] + (_e172 * _e214)), (_e142[20] + (_e172 * _e227)), (_e142[21] + (_e172 * _e240)), (_e142[22] + (_e172 * _e253)), (_e142[23] + (_e172 * _e266)));
                    } else {
                        phi_270_ = u32();
                        phi_272_ = u32();
                        phi_274_ = array<f32, 24>();
                    }
                    let _e280 = phi_270_;
                    let _e282 = phi_272_;
                    let _e284 = phi_274_;
                    continue;
                    continuing {
                        phi_266_ = _e155;
                        phi_269_ = _e280;
                        phi_271_ = _e282;
                        phi_273_ = _e284;
                        break if !(_e160);
                    }
                }
                let _e287 = local;
                partial.member[_e103] = _e287[0];
                let _e293 = local_1;
                partial.member[((_e91 * 16u) + _e103)] = _e293[1];
                let _e300 = local_2;
                partial.member[((_e91 * 32u) + _e103)] = _e300[2];
                let _e307 = local_3;
                partial.member[((_e91 * 48u) + _e103)] = _e307[3];
                let _e314 = local_4;
                partial.member[((_e91 * 64u) + _e103)] = _e314[4];
                let _e321 = local_5;
                partial.member[((_e91 * 80u) + _e103)] = _e321[5];
                let _e328 = local_6;
                partial.member[((_e91 * 96u) + _e103)] = _e328[6];
                let _e335 = local_7;
                partial.member[((_e91 * 112u) + _e103)] = _e335[7];
                let _e342 = local_8;
                partial.member[((_e91 * 128u) + _e103)] = _e342[8];
                let _e349 = local_9;
                partial.member[((_e91 * 144u) + _e103)] = _e349[9];
                let _e356 = local_10;
                partial.member[((_e91 * 160u) + _e103)] = _e356[10];
                let _e363 = local_11;
                partial.member[((_e91 * 176u) + _e103)] = _e363[11];
                let _e370 = local_12;
                partial.member[((_e91 * 192u) + _e103)] = _e370[12];
                let _e377 = local_13;
                partial.member[((_e91 * 208u) + _e103)] = _e377[13];
                let _e384 = local_14;
                partial.member[((_e91 * 224u) + _e103)] = _e384[14];
                let _e391 = local_15;
                partial.member[((_e91 * 240u) + _e103)] = _e391[15];
                let _e398 = local_16;
                partial.member[((_e91 * 256u) + _e103)] = _e398[16];
                let _e405 = local_17;
                partial.member[((_e91 * 272u) + _e103)] = _e405[17];
                let _e412 = local_18;
                partial.member[((_e91 * 288u) + _e103)] = _e412[18];
                let _e419 = local_19;
                partial.member[((_e91 * 304u) + _e103)] = _e419[19];
                let _e426 = local_20;
                partial.member[((_e91 * 320u) + _e103)] = _e426[20];
                let _e433 = local_21;
                partial.member[((_e91 * 336u) + _e103)] = _e433[21];
                let _e440 = local_22;
                partial.member[((_e91 * 352u) + _e103)] = _e440[22];
                let _e447 = local_23;
                partial.member[((_e91 * 368u) + _e103)] = _e447[23];
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_project(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
