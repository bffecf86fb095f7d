struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_16 {
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
    member_17: vec4<f32>,
}

struct type_17 {
    member: type_16,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_17;
@group(0) @binding(1) 
var<storage> source: type_5;

fn function_() {
    var local: array<f32, 9>;
    var phi_94_: u32;
    var phi_177_: bool;
    var phi_179_: bool;
    var phi_180_: bool;
    var phi_647_: array<f32, 9>;
    var phi_660_: type_11;
    var phi_661_: type_11;
    var phi_684_: type_11;
    var phi_713_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e38 = gid_1;
            let _e40 = arrayLength((&source.member));
            let _e45 = params.member.member_2;
            let _e47 = (_e45.x + 1u);
            let _e49 = (_e45.y + 1u);
            let _e50 = (_e49 * _e47);
            let _e55 = ((_e50 + _e47) + ((_e45.z + 1u) * _e50));
            if (_e45.x > 0u) {
                if (_e47 == 0u) {
                    break;
                }
                phi_94_ = (3u * (_e55 / _e47));
            } else {
                phi_94_ = 0u;
            }
            let _e61 = phi_94_;
            let _e62 = (3u * _e55);
            let _e66 = (_e38.x + (_e38.y * 2097152u));
            if (_e66 < (_e61 * _e45.x)) {
                if (_e45.x == 0u) {
                    break;
                }
                let _e70 = (_e66 / _e45.x);
                let _e74 = ((_e70 * _e47) + (_e66 - (_e70 * _e45.x)));
                let _e75 = (_e47 == 0u);
                if _e75 {
                    break;
                }
                let _e76 = (_e55 / _e47);
                if (_e76 == 0u) {
                    break;
                }
                if _e75 {
                    break;
                }
                let _e80 = (_e70 - ((_e70 / _e76) * _e76));
                let _e81 = (_e45.y + 2u);
                let _e84 = (select(_e81, _e80, (_e81 < _e80)) - _e81);
                if (_e49 == 0u) {
                    break;
                }
                let _e86 = (_e84 / _e49);
                if (_e80 >= _e81) {
                    let _e90 = ((_e84 - (_e86 * _e49)) < _e45.y);
                    if _e90 {
                        phi_177_ = (_e86 < _e45.z);
                    } else {
                        phi_177_ = bool();
                    }
                    let _e93 = phi_177_;
                    phi_179_ = _e93;
                    phi_180_ = select(true, false, _e90);
                } else {
                    phi_179_ = bool();
                    phi_180_ = true;
                }
                let _e96 = phi_179_;
                let _e98 = phi_180_;
                if select(_e96, false, _e98) {
                    let _e100 = (_e74 + _e62);
                    if (_e100 < _e40) {
                    } else {
                        break;
                    }
                    let _e104 = source.member[_e100];
                    let _e106 = (_e74 + (_e55 * 6u));
                    if (_e106 < _e40) {
                    } else {
                        break;
                    }
                    let _e110 = source.member[_e106];
                    let _e112 = (_e74 + (_e55 * 9u));
                    if (_e112 < _e40) {
                    } else {
                        break;
                    }
                    let _e116 = source.member[_e112];
                    if (_e74 < _e40) {
                    } else {
                        break;
                    }
                    let _e120 = source.member[_e74];
                    let _e123 = params.member.member_9;
                    let _e127 = params.member.member_4[3u];
                    let _e130 = params.member.member_6;
                    let _e131 = (0.000000000000000001f < _e120);
                    let _e132 = select(0f, _e120, _e131);
                    let _e134 = (1f / select(1f, _e132, _e131));
                    let _e135 = (_e104 * _e134);
                    let _e136 = (_e110 * _e134);
                    let _e137 = (_e116 * _e134);
                    let _e142 = (((_e135 * _e135) + (_e136 * _e136)) + (_e137 * _e137));
                    let _e146 = (1f / sqrt(select(1f, _e142, (1f < _e142))));
                    let _e147 = (_e135 * _e146);
                    let _e148 = (_e136 * _e146);
                    let _e149 = (_e137 * _e146);
                    let _e152 = (0.2387324f * _e130);
                    let _e153 = (_e147 * _e152);
                    let _e154 = (_e148 * _e152);
                    let _e155 = (_e149 * _e152);
                    let _e157 = (0.07957747f + (_e153 * 0.8944272f));
                    let _e158 = (_e154 * 0.4472136f);
                    let _e159 = (_e155 * 0.4472136f);
                    let _e160 = (_e157 + _e158);
                    let _e162 = select(0f, _e160, (0f < _e160));
                    let _e163 = (_e157 - _e158);
                    let _e165 = select(0f, _e163, (0f < _e163));
                    let _e166 = (_e157 + _e159);
                    let _e168 = select(0f, _e166, (0f < _e166));
                    let _e169 = (_e157 - _e159);
                    let _e171 = select(0f, _e169, (0f < _e169));
                    let _e172 = (0.07957747f + _e153);
                    let _e175 = (select(0f, _e172, (0f < _e172)) * 0.4006697f);
                    let _e179 = (((_e162 + _e165) + (_e168 + _e171)) * 0.42343134f);
                    let _e183 = (0.07957747f + (_e153 * -0.8944272f));
                    let _e184 = (_e183 + _e158);
                    let _e186 = select(0f, _e184, (0f < _e184));
                    let _e187 = (_e183 - _e158);
                    let _e189 = select(0f, _e187, (0f < _e187));
                    let _e190 = (_e183 + _e159);
                    let _e192 = select(0f, _e190, (0f < _e190));
                    let _e193 = (_e183 - _e159);
                    let _e195 = select(0f, _e193, (0f < _e193));
                    let _e196 = (0.07957747f - _e153);
                    let _e199 = (select(0f, _e196, (0f < _e196)) * 0.4006697f);
                    let _e203 = (((_e186 + _e189) + (_e192 + _e195)) * 0.42343134f);
                    let _e206 = (_e175 + _e179);
                    let _e207 = (_e199 + _e203);
                    let _e216 = (0.07957747f + (_e154 * 0.8944272f));
                    let _e217 = (_e153 * 0.4472136f);
                    let _e218 = (_e216 + _e159);
                    let _e220 = select(0f, _e218, (0f < _e218));
                    let _e221 = (_e216 - _e159);
                    let _e223 = select(0f, _e221, (0f < _e221));
                    let _e224 = (_e216 + _e217);
                    let _e226 = select(0f, _e224, (0f < _e224));
                    let _e227 = (_e216 - _e217);
                    let _e229 = select(0f, _e227, (0f < _e227));
                    let _e230 = (0.07957747f + _e154);
                    let _e233 = (select(0f, _e230, (0f < _e230)) * 0.4006697f);
                    let _e237 = (((_e220 + _e223) + (_e226 + _e229)) * 0.42343134f);
                    let _e241 = (0.07957747f + (_e154 * -0.8944272f));
                    let _e242 = (_e241 + _e159);
                    let _e244 = select(0f, _e242, (0f < _e242));
                    let _e245 = (_e241 - _e159);
                    let _e247 = select(0f, _e245, (0f < _e245));
                    let _e248 = (_e241 + _e217);
                    let _e250 = select(0f, _e248, (0f < _e248));
                    let _e251 = (_e241 - _e217);
                    let _e253 = select(0f, _e251, (0f < _e251));
                    let _e254 = (0.07957747f - _e154);
                    let _e257 = (select(0f, _e254, (0f < _e254)) * 0.4006697f);
                    let _e261 = (((_e244 + _e247) + (_e250 + _e253)) * 0.42343134f);
                    let _e264 = (_e233 + _e237);
                    let _e265 = (_e257 + _e261);
                    let _e278 = (0.07957747f + (_e155 * 0.8944272f));
                    let _e279 = (_e278 + _e217);
                    let _e281 = select(0f, _e279, (0f < _e279));
                    let _e282 = (_e278 - _e217);
                    let _e284 = select(0f, _e282, (0f < _e282));
                    let _e285 = (_e278 + _e158);
                    let _e287 = select(0f, _e285, (0f < _e285));
                    let _e288 = (_e278 - _e158);
                    let _e290 = select(0f, _e288, (0f < _e288));
                    let _e291 = (0.07957747f + _e155);
                    let _e294 = (select(0f, _e291, (0f < _e291)) * 0.4006697f);
                    let _e298 = (((_e281 + _e284) + (_e287 + _e290)) * 0.42343134f);
                    let _e302 = (0.07957747f + (_e155 * -0.8944272f));
                    let _e303 = (_e302 + _e217);
                    let _e305 = select(0f, _e303, (0f < _e303));
                    let _e306 = (_e302 - _e217);
                    let _e308 = select(0f, _e306, (0f < _e306));
                    let _e309 = (_e302 + _e158);
                    let _e311 = select(0f, _e309, (0f < _e309));
                    let _e312 = (_e302 - _e158);
                    let _e314 = select(0f, _e312, (0f < _e312));
                    let _e315 = (0.07957747f - _e155);
                    let _e318 = (select(0f, _e315, (0f < _e315)) * 0.4006697f);
                    let _e322 = (((_e305 + _e308) + (_e311 + _e314)) * 0.42343134f);
                    let _e325 = (_e294 + _e298);
                    let _e326 = (_e318 + _e322);
                    let _e331 = (((0.18936425f * (((_e168 - _e171) + (_e192 - _e195)) + ((_e220 - _e223) + (_e244 - _e247)))) + (_e294 - _e318)) + ((_e298 - _e322) * 0.8944272f));
                    let _e334 = ((((_e175 - _e199) + ((_e179 - _e203) * 0.8944272f)) + (((_e226 - _e229) + (_e250 - _e253)) * 0.18936425f)) + (((_e281 - _e284) + (_e305 - _e308)) * 0.18936425f));
                    let _e337 = ((((((_e162 - _e165) + (_e186 - _e189)) * 0.18936425f) + (_e233 - _e257)) + ((_e237 - _e261) * 0.8944272f)) + (((_e287 - _e290) + (_e311 - _e314)) * 0.18936425f));
                    let _e343 = (1f / (((_e206 + _e207) + (_e264 + _e265)) + (_e325 + _e326)));
                    let _e346 = ((_e343 * _e123) + (1f - _e123));
                    let _e358 = (_e132 * _e346);
                    let _e360 = (_e358 * _e152);
                    let _e362 = ((_e132 * _e343) * 0.7329038f);
                    let _e372 = ((_e264 - _e265) * _e362);
                    let _e374 = ((_e325 - _e326) * _e362);
                    let _e376 = ((_e206 - _e207) * _e362);
                    let _e379 = params.member.member_10;
                    let _e380 = (_e132 * 0.24430126f);
                    let _e383 = select(_e380, _e372, (_e372 < _e380));
                    let _e384 = (_e132 * -0.24430126f);
                    let _e389 = select(_e380, _e374, (_e374 < _e380));
                    let _e394 = select(_e380, _e376, (_e376 < _e380));
                    phi_647_ = array<f32, 9>((_e358 * 0.07957747f), (_e147 * _e360), (_e148 * _e360), (_e149 * _e360), select(1f, ((sqrt(((((_e142 * _e146) * _e146) + 0.0001f) / ((((((_e334 * _e334) + (_e337 * _e337)) + (_e331 * _e331)) * _e346) * _e346) + 0.0001f))) * _e127) + (1f - _e127)), _e131), ((_e132 * 0.2820948f) * _e379), (select(_e384, _e383, (_e384 < _e383)) * _e379), (select(_e384, _e389, (_e384 < _e389)) * _e379), (select(_e384, _e394, (_e384 < _e394)) * _e379));
                } else {
                    phi_647_ = array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e400 = phi_647_;
                local = array<f32, 9>(_e400[0], _e400[1], _e400[2], _e400[3], _e400[4], _e400[5], _e400[6], _e400[7], _e400[8]);
                phi_660_ = type_11(0u, 9u);
                loop {
                    let _e412 = phi_660_;
                    if (_e412.member < _e412.member_1) {
                        phi_661_ = type_11((_e412.member + 1u), _e412.member_1);
                        phi_684_ = type_11(1u, _e412.member);
                    } else {
                        phi_661_ = _e412;
                        phi_684_ = type_11(0u, type_11().member_1);
                    }
                    let _e425 = phi_661_;
                    let _e427 = phi_684_;
                    let _e431 = (bitcast<i32>(_e427.member) != 0i);
                    if _e431 {
                        if (_e427.member_1 < 9u) {
                        } else {
                            phi_713_ = true;
                            break;
                        }
                        let _e434 = local[_e427.member_1];
                        let _e436 = ((_e427.member_1 * _e62) + _e74);
                        if (_e436 < arrayLength((&out.member))) {
                        } else {
                            phi_713_ = true;
                            break;
                        }
                        out.member[_e436] = _e434;
                    }
                    continue;
                    continuing {
                        phi_660_ = _e425;
                        phi_713_ = false;
                        break if !(_e431);
                    }
                }
                let _e442 = phi_713_;
                if _e442 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_begin(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
