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
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: vec4<f32>,
}

struct type_17 {
    member: type_16,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(3) 
var<storage, read_write> out: type_5;
@group(0) @binding(0) 
var<uniform> params: type_17;
@group(0) @binding(1) 
var<storage> source: type_5;
@group(0) @binding(2) 
var<storage> before: type_5;

fn function_() {
    var local: array<f32, 11>;
    var phi_120_: u32;
    var phi_203_: bool;
    var phi_205_: bool;
    var phi_206_: bool;
    var phi_787_: bool;
    var phi_709_: array<f32, 11>;
    var phi_724_: type_11;
    var phi_725_: type_11;
    var phi_748_: type_11;
    var phi_792_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e50 = gid_1;
            let _e55 = params.member.member_2;
            let _e57 = (_e55.x + 1u);
            let _e59 = (_e55.y + 1u);
            let _e60 = (_e59 * _e57);
            let _e65 = ((_e60 + _e57) + ((_e55.z + 1u) * _e60));
            if (_e55.x > 0u) {
                if (_e57 == 0u) {
                    break;
                }
                phi_120_ = (3u * (_e65 / _e57));
            } else {
                phi_120_ = 0u;
            }
            let _e71 = phi_120_;
            let _e72 = (3u * _e65);
            let _e76 = (_e50.x + (_e50.y * 2097152u));
            if (_e76 < (_e71 * _e55.x)) {
                if (_e55.x == 0u) {
                    break;
                }
                let _e80 = (_e76 / _e55.x);
                let _e84 = ((_e80 * _e57) + (_e76 - (_e80 * _e55.x)));
                let _e85 = (_e57 == 0u);
                if _e85 {
                    break;
                }
                let _e86 = (_e65 / _e57);
                if (_e86 == 0u) {
                    break;
                }
                if _e85 {
                    break;
                }
                let _e90 = (_e80 - ((_e80 / _e86) * _e86));
                let _e91 = (_e55.y + 2u);
                let _e94 = (select(_e91, _e90, (_e91 < _e90)) - _e91);
                if (_e59 == 0u) {
                    break;
                }
                let _e96 = (_e94 / _e59);
                if (_e90 >= _e91) {
                    let _e100 = ((_e94 - (_e96 * _e59)) < _e55.y);
                    if _e100 {
                        phi_203_ = (_e96 < _e55.z);
                    } else {
                        phi_203_ = bool();
                    }
                    let _e103 = phi_203_;
                    phi_205_ = _e103;
                    phi_206_ = select(true, false, _e100);
                } else {
                    phi_205_ = bool();
                    phi_206_ = true;
                }
                let _e106 = phi_205_;
                let _e108 = phi_206_;
                if select(_e106, false, _e108) {
                    let _e113 = source.member[(_e84 + _e72)];
                    let _e118 = source.member[(_e84 + (_e65 * 6u))];
                    let _e123 = source.member[(_e84 + (_e65 * 9u))];
                    let _e126 = source.member[_e84];
                    let _e129 = params.member.member_9;
                    let _e133 = params.member.member_4[3u];
                    let _e136 = params.member.member_6;
                    let _e137 = (0.000000000000000001f < _e126);
                    let _e138 = select(0f, _e126, _e137);
                    let _e140 = (1f / select(1f, _e138, _e137));
                    let _e141 = (_e113 * _e140);
                    let _e142 = (_e118 * _e140);
                    let _e143 = (_e123 * _e140);
                    let _e148 = (((_e141 * _e141) + (_e142 * _e142)) + (_e143 * _e143));
                    let _e152 = (1f / sqrt(select(1f, _e148, (1f < _e148))));
                    let _e153 = (_e141 * _e152);
                    let _e154 = (_e142 * _e152);
                    let _e155 = (_e143 * _e152);
                    let _e157 = ((_e148 * _e152) * _e152);
                    let _e158 = sqrt(_e157);
                    if (_e136 != _e136) {
                        phi_787_ = true;
                    } else {
                        phi_787_ = (0.33333334f >= _e136);
                    }
                    let _e162 = phi_787_;
                    let _e163 = select(_e136, 0.33333334f, _e162);
                    let _e166 = (3f * select(_e163, _e158, (_e158 < _e163)));
                    let _e168 = (3f - _e166);
                    let _e170 = (0.31830987f / (_e168 * _e168));
                    let _e173 = (_e158 < select(2f, 0.33333334f, (_e136 > 0.33333334f)));
                    let _e178 = select(((2f - _e166) * _e170), 0.07957747f, _e173);
                    let _e179 = select((_e170 / select(0.33333334f, _e158, (0.33333334f < _e158))), 0.2387324f, _e173);
                    let _e180 = (_e153 * _e179);
                    let _e181 = (_e154 * _e179);
                    let _e182 = (_e155 * _e179);
                    let _e184 = (_e178 + (_e180 * 0.8944272f));
                    let _e185 = (_e181 * 0.4472136f);
                    let _e186 = (_e182 * 0.4472136f);
                    let _e187 = (_e184 + _e185);
                    let _e189 = select(0f, _e187, (0f < _e187));
                    let _e190 = (_e184 - _e185);
                    let _e192 = select(0f, _e190, (0f < _e190));
                    let _e193 = (_e184 + _e186);
                    let _e195 = select(0f, _e193, (0f < _e193));
                    let _e196 = (_e184 - _e186);
                    let _e198 = select(0f, _e196, (0f < _e196));
                    let _e199 = (_e178 + _e180);
                    let _e202 = (select(0f, _e199, (0f < _e199)) * 0.4006697f);
                    let _e206 = (((_e189 + _e192) + (_e195 + _e198)) * 0.42343134f);
                    let _e211 = (_e178 + (_e180 * -0.8944272f));
                    let _e212 = (_e211 + _e185);
                    let _e214 = select(0f, _e212, (0f < _e212));
                    let _e215 = (_e211 - _e185);
                    let _e217 = select(0f, _e215, (0f < _e215));
                    let _e218 = (_e211 + _e186);
                    let _e220 = select(0f, _e218, (0f < _e218));
                    let _e221 = (_e211 - _e186);
                    let _e223 = select(0f, _e221, (0f < _e221));
                    let _e224 = (_e178 + -(_e180));
                    let _e227 = (select(0f, _e224, (0f < _e224)) * 0.4006697f);
                    let _e231 = (((_e214 + _e217) + (_e220 + _e223)) * 0.42343134f);
                    let _e234 = (_e202 + _e206);
                    let _e235 = (_e227 + _e231);
                    let _e244 = (_e178 + (_e181 * 0.8944272f));
                    let _e245 = (_e180 * 0.4472136f);
                    let _e246 = (_e244 + _e186);
                    let _e248 = select(0f, _e246, (0f < _e246));
                    let _e249 = (_e244 - _e186);
                    let _e251 = select(0f, _e249, (0f < _e249));
                    let _e252 = (_e244 + _e245);
                    let _e254 = select(0f, _e252, (0f < _e252));
                    let _e255 = (_e244 - _e245);
                    let _e257 = select(0f, _e255, (0f < _e255));
                    let _e258 = (_e178 + _e181);
                    let _e261 = (select(0f, _e258, (0f < _e258)) * 0.4006697f);
                    let _e265 = (((_e248 + _e251) + (_e254 + _e257)) * 0.42343134f);
                    let _e270 = (_e178 + (_e181 * -0.8944272f));
                    let _e271 = (_e270 + _e186);
                    let _e273 = select(0f, _e271, (0f < _e271));
                    let _e274 = (_e270 - _e186);
                    let _e276 = select(0f, _e274, (0f < _e274));
                    let _e277 = (_e270 + _e245);
                    let _e279 = select(0f, _e277, (0f < _e277));
                    let _e280 = (_e270 - _e245);
                    let _e282 = select(0f, _e280, (0f < _e280));
                    let _e283 = (_e178 + -(_e181));
                    let _e286 = (select(0f, _e283, (0f < _e283)) * 0.4006697f);
                    let _e290 = (((_e273 + _e276) + (_e279 + _e282)) * 0.42343134f);
                    let _e293 = (_e261 + _e265);
                    let _e294 = (_e286 + _e290);
                    let _e307 = (_e178 + (_e182 * 0.8944272f));
                    let _e308 = (_e307 + _e245);
                    let _e310 = select(0f, _e308, (0f < _e308));
                    let _e311 = (_e307 - _e245);
                    let _e313 = select(0f, _e311, (0f < _e311));
                    let _e314 = (_e307 + _e185);
                    let _e316 = select(0f, _e314, (0f < _e314));
                    let _e317 = (_e307 - _e185);
                    let _e319 = select(0f, _e317, (0f < _e317));
                    let _e320 = (_e178 + _e182);
                    let _e323 = (select(0f, _e320, (0f < _e320)) * 0.4006697f);
                    let _e327 = (((_e310 + _e313) + (_e316 + _e319)) * 0.42343134f);
                    let _e332 = (_e178 + (_e182 * -0.8944272f));
                    let _e333 = (_e332 + _e245);
                    let _e335 = select(0f, _e333, (0f < _e333));
                    let _e336 = (_e332 - _e245);
                    let _e338 = select(0f, _e336, (0f < _e336));
                    let _e339 = (_e332 + _e185);
                    let _e341 = select(0f, _e339, (0f < _e339));
                    let _e342 = (_e332 - _e185);
                    let _e344 = select(0f, _e342, (0f < _e342));
                    let _e345 = (_e178 + -(_e182));
                    let _e348 = (select(0f, _e345, (0f < _e345)) * 0.4006697f);
                    let _e352 = (((_e335 + _e338) + (_e341 + _e344)) * 0.42343134f);
                    let _e355 = (_e323 + _e327);
                    let _e356 = (_e348 + _e352);
                    let _e361 = (((0.18936425f * (((_e195 - _e198) + (_e220 - _e223)) + ((_e248 - _e251) + (_e273 - _e276)))) + (_e323 - _e348)) + ((_e327 - _e352) * 0.8944272f));
                    let _e364 = ((((_e202 - _e227) + ((_e206 - _e231) * 0.8944272f)) + (((_e254 - _e257) + (_e279 - _e282)) * 0.18936425f)) + (((_e310 - _e313) + (_e335 - _e338)) * 0.18936425f));
                    let _e367 = ((((((_e189 - _e192) + (_e214 - _e217)) * 0.18936425f) + (_e261 - _e286)) + ((_e265 - _e290) * 0.8944272f)) + (((_e316 - _e319) + (_e341 - _e344)) * 0.18936425f));
                    let _e368 = (_e234 + _e235);
                    let _e369 = (_e293 + _e294);
                    let _e371 = (_e355 + _e356);
                    let _e373 = (1f / ((_e368 + _e369) + _e371));
                    let _e376 = ((_e373 * _e129) + (1f - _e129));
                    let _e388 = (_e138 * _e376);
                    let _e390 = (_e388 * _e179);
                    let _e392 = ((_e138 * _e373) * 0.7329038f);
                    let _e417 = params.member.member_10;
                    let _e426 = params.member.member_11;
                    let _e431 = before.member[((_e65 * 15u) + _e84)];
                    let _e438 = before.member[((_e65 * 18u) + _e84)];
                    let _e445 = before.member[((_e65 * 21u) + _e84)];
                    let _e452 = before.member[((_e65 * 24u) + _e84)];
                    let _e459 = before.member[((_e65 * 27u) + _e84)];
                    let _e466 = before.member[((_e65 * 30u) + _e84)];
                    phi_709_ = array<f32, 11>((_e388 * _e178), (_e153 * _e390), (_e154 * _e390), (_e155 * _e390), select(1f, ((sqrt(((_e157 + 0.0001f) / ((((((_e364 * _e364) + (_e367 * _e367)) + (_e361 * _e361)) * _e376) * _e376) + 0.0001f))) * _e133) + (1f - _e133)), _e137), (((_e138 * 0.2820948f) * _e417) + (_e426 * _e431)), ((((_e293 - _e294) * _e392) * _e417) + (_e426 * _e438)), ((((_e355 - _e356) * _e392) * _e417) + (_e426 * _e445)), ((((_e234 - _e235) * _e392) * _e417) + (_e426 * _e452)), ((((((_e371 * _e373) - 0.33333334f) * _e138) * 1.5138805f) * _e417) + (_e426 * _e459)), ((((((_e368 - _e369) * _e373) * _e138) * 0.8740393f) * _e417) + (_e426 * _e466)));
                } else {
                    phi_709_ = array<f32, 11>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                }
                let _e471 = phi_709_;
                local = array<f32, 11>(_e471[0], _e471[1], _e471[2], _e471[3], _e471[4], _e471[5], _e471[6], _e471[7], _e471[8], _e471[9], _e471[10]);
                phi_724_ = type_11(0u, 11u);
                loop {
                    let _e485 = phi_724_;
                    if (_e485.member < _e485.member_1) {
                        phi_725_ = type_11((_e485.member + 1u), _e485.member_1);
                        phi_748_ = type_11(1u, _e485.member);
                    } else {
                        phi_725_ = _e485;
                        phi_748_ = type_11(0u, type_11().member_1);
                    }
                    let _e498 = phi_725_;
                    let _e500 = phi_748_;
                    let _e504 = (bitcast<i32>(_e500.member) != 0i);
                    if _e504 {
                        if (_e500.member_1 < 11u) {
                        } else {
                            phi_792_ = true;
                            break;
                        }
                        let _e507 = local[_e500.member_1];
                        let _e509 = ((_e500.member_1 * _e72) + _e84);
                        if (_e509 < arrayLength((&out.member))) {
                        } else {
                            phi_792_ = true;
                            break;
                        }
                        out.member[_e509] = _e507;
                    }
                    continue;
                    continuing {
                        phi_724_ = _e498;
                        phi_792_ = false;
                        break if !(_e504);
                    }
                }
                let _e515 = phi_792_;
                if _e515 {
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
