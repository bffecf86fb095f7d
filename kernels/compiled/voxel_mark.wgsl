struct type_7 {
    member: array<u32>,
}

struct type_14 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_22 {
    member: f32,
    member_1: f32,
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
    member_16: vec4<f32>,
    member_17: vec4<u32>,
}

struct type_25 {
    member: type_24,
}

struct type_27 {
    member: vec3<f32>,
    member_1: vec3<f32>,
    member_2: vec3<f32>,
    member_3: vec3<f32>,
    member_4: u32,
    member_5: vec3<f32>,
    member_6: i32,
    member_7: i32,
    member_8: i32,
    member_9: i32,
}

struct type_28 {
    member: type_27,
    member_1: i32,
    member_2: i32,
    member_3: i32,
    member_4: i32,
    member_5: i32,
    member_6: i32,
    member_7: i32,
    member_8: i32,
    member_9: i32,
    member_10: bool,
}

struct type_32 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_25;
@group(0) @binding(1) 
var<storage> triangles: type_16;
@group(0) @binding(2) 
var<storage> tile_first: type_7;
@group(0) @binding(3) 
var<storage, read_write> facet_bits: type_32;

fn function_() {
    var phi_121_: u32;
    var phi_124_: u32;
    var phi_122_: u32;
    var phi_125_: u32;
    var phi_2799_: bool;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_237_: bool;
    var phi_246_: u32;
    var phi_266_: vec3<f32>;
    var phi_267_: vec3<f32>;
    var phi_278_: vec3<f32>;
    var phi_279_: vec3<f32>;
    var phi_290_: vec3<f32>;
    var phi_291_: vec3<f32>;
    var phi_302_: vec3<f32>;
    var phi_303_: vec3<f32>;
    var phi_439_: bool;
    var phi_448_: u32;
    var phi_458_: f32;
    var local_4: u32;
    var local_5: u32;
    var phi_479_: u32;
    var phi_2164_: bool;
    var phi_2203_: bool;
    var phi_2242_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_686_: type_28;
    var phi_2813_: i32;
    var phi_2810_: i32;
    var phi_2807_: i32;
    var phi_2804_: i32;
    var phi_2812_: i32;
    var phi_2809_: i32;
    var phi_2806_: i32;
    var phi_2803_: i32;
    var phi_2805_: i32;
    var phi_906_: bool;
    var phi_936_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_1003_: bool;
    var phi_1033_: bool;
    var phi_1063_: bool;
    var phi_1064_: bool;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1100_: bool;
    var phi_1130_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1195_: bool;
    var phi_1205_: vec3<f32>;
    var phi_1206_: vec3<f32>;
    var phi_1258_: bool;
    var phi_1267_: vec3<f32>;
    var phi_1308_: bool;
    var phi_1309_: bool;
    var phi_1310_: bool;
    var phi_1311_: bool;
    var phi_1312_: bool;
    var phi_1316_: bool;
    var phi_1317_: bool;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1320_: bool;
    var phi_1321_: bool;
    var phi_1322_: bool;
    var phi_1323_: bool;
    var phi_1324_: bool;
    var phi_1325_: bool;
    var phi_1326_: bool;
    var phi_1327_: bool;
    var phi_1328_: bool;
    var phi_1329_: bool;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_3104_: i32;
    var phi_1345_: bool;
    var local_6: bool;
    var phi_2961_: i32;
    var phi_2277_: type_22;
    var phi_2281_: type_22;
    var phi_2282_: bool;
    var phi_2287_: type_22;
    var phi_2303_: type_22;
    var phi_2324_: type_22;
    var phi_2328_: type_22;
    var phi_2329_: bool;
    var phi_2334_: type_22;
    var phi_2350_: type_22;
    var phi_2398_: type_22;
    var phi_2432_: type_22;
    var phi_2436_: type_22;
    var phi_2437_: bool;
    var phi_2442_: type_22;
    var phi_2458_: type_22;
    var phi_2479_: type_22;
    var phi_2483_: type_22;
    var phi_2484_: bool;
    var phi_2489_: type_22;
    var phi_2505_: type_22;
    var phi_2553_: type_22;
    var phi_2587_: type_22;
    var phi_2591_: type_22;
    var phi_2592_: bool;
    var phi_2597_: type_22;
    var phi_2613_: type_22;
    var phi_2634_: type_22;
    var phi_2638_: type_22;
    var phi_2639_: bool;
    var phi_2644_: type_22;
    var phi_2660_: type_22;
    var phi_2708_: type_22;
    var phi_1398_: vec3<f32>;
    var phi_1399_: vec3<f32>;
    var phi_1441_: type_22;
    var phi_3395_: i32;
    var phi_3102_: i32;
    var phi_3078_: i32;
    var phi_3048_: i32;
    var phi_3394_: i32;
    var phi_3101_: i32;
    var phi_3077_: i32;
    var phi_3047_: i32;
    var phi_1481_: bool;
    var local_7: bool;
    var local_8: i32;
    var local_9: i32;
    var local_10: i32;
    var phi_1511_: u32;
    var phi_1522_: vec3<f32>;
    var phi_1523_: vec3<f32>;
    var phi_3175_: bool;
    var local_11: i32;
    var local_12: i32;
    var local_13: i32;
    var local_14: i32;
    var local_15: i32;
    var local_16: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e49 = gid_1;
            let _e53 = arrayLength((&tile_first.member));
            let _e59 = (_e49.x + (_e49.y * 2097152u));
            let _e62 = params.member.member_4;
            if (_e59 < _e62) {
                let _e66 = params.member.member_3;
                phi_121_ = _e66;
                phi_124_ = 0u;
                loop {
                    let _e68 = phi_121_;
                    let _e70 = phi_124_;
                    local = _e70;
                    local_1 = _e70;
                    local_2 = _e70;
                    local_3 = _e70;
                    local_4 = _e70;
                    local_5 = _e70;
                    let _e71 = (_e68 > 1u);
                    if _e71 {
                        let _e72 = (_e68 / 2u);
                        let _e73 = (_e70 + _e72);
                        if (_e73 < _e53) {
                        } else {
                            phi_2799_ = true;
                            break;
                        }
                        let _e77 = tile_first.member[_e73];
                        phi_122_ = (_e68 - _e72);
                        phi_125_ = select(_e70, _e73, (_e77 <= _e59));
                    } else {
                        phi_122_ = u32();
                        phi_125_ = u32();
                    }
                    let _e82 = phi_122_;
                    let _e84 = phi_125_;
                    continue;
                    continuing {
                        phi_121_ = _e82;
                        phi_124_ = _e84;
                        phi_2799_ = false;
                        break if !(_e71);
                    }
                }
                let _e87 = phi_2799_;
                if _e87 {
                    break;
                }
                let _e89 = local;
                if (_e89 < arrayLength((&triangles.member))) {
                } else {
                    break;
                }
                let _e93 = local_1;
                let _e96 = triangles.member[_e93].member;
                let _e102 = params.member.member;
                let _e110 = ((_e96[0] - _e102.x) / _e102.w);
                let _e111 = ((_e96[1] - _e102.y) / _e102.w);
                let _e112 = ((_e96[2] - _e102.z) / _e102.w);
                let _e116 = local_2;
                let _e119 = triangles.member[_e116].member_2;
                let _e126 = ((_e119[0] - _e102.x) / _e102.w);
                let _e127 = ((_e119[1] - _e102.y) / _e102.w);
                let _e128 = ((_e119[2] - _e102.z) / _e102.w);
                let _e132 = local_3;
                let _e135 = triangles.member[_e132].member_4;
                let _e142 = ((_e135[0] - _e102.x) / _e102.w);
                let _e143 = ((_e135[1] - _e102.y) / _e102.w);
                let _e144 = ((_e135[2] - _e102.z) / _e102.w);
                let _e146 = (_e126 - _e110);
                let _e147 = (_e127 - _e111);
                let _e148 = (_e128 - _e112);
                let _e149 = (_e142 - _e110);
                let _e150 = (_e143 - _e111);
                let _e151 = (_e144 - _e112);
                let _e154 = ((_e147 * _e151) - (_e150 * _e148));
                let _e157 = ((_e148 * _e149) - (_e151 * _e146));
                let _e160 = ((_e146 * _e150) - (_e149 * _e147));
                let _e162 = abs(_e154);
                let _e163 = abs(_e157);
                let _e164 = abs(_e160);
                let _e165 = (_e162 >= _e163);
                if _e165 {
                    phi_237_ = select(true, false, (_e162 >= _e164));
                } else {
                    phi_237_ = true;
                }
                let _e169 = phi_237_;
                if _e169 {
                    phi_246_ = select(2u, 1u, (_e163 >= _e164));
                } else {
                    phi_246_ = 0u;
                }
                let _e173 = phi_246_;
                let _e176 = params.member.member_1;
                let _e178 = f32(_e176.x);
                let _e180 = f32(_e176.y);
                let _e182 = f32(_e176.z);
                let _e184 = (_e173 == 0u);
                if _e184 {
                    phi_267_ = vec3<f32>(_e180, _e182, _e178);
                } else {
                    if (_e173 == 1u) {
                        phi_266_ = vec3<f32>(_e182, _e178, _e180);
                    } else {
                        phi_266_ = vec3<f32>(_e178, _e180, _e182);
                    }
                    let _e189 = phi_266_;
                    phi_267_ = _e189;
                }
                let _e191 = phi_267_;
                if _e184 {
                    phi_279_ = vec3<f32>(_e111, _e112, _e110);
                } else {
                    if (_e173 == 1u) {
                        phi_278_ = vec3<f32>(_e112, _e110, _e111);
                    } else {
                        phi_278_ = vec3<f32>(_e110, _e111, _e112);
                    }
                    let _e196 = phi_278_;
                    phi_279_ = _e196;
                }
                let _e198 = phi_279_;
                if _e184 {
                    phi_291_ = vec3<f32>(_e127, _e128, _e126);
                } else {
                    if (_e173 == 1u) {
                        phi_290_ = vec3<f32>(_e128, _e126, _e127);
                    } else {
                        phi_290_ = vec3<f32>(_e126, _e127, _e128);
                    }
                    let _e203 = phi_290_;
                    phi_291_ = _e203;
                }
                let _e205 = phi_291_;
                if _e184 {
                    phi_303_ = vec3<f32>(_e143, _e144, _e142);
                } else {
                    if (_e173 == 1u) {
                        phi_302_ = vec3<f32>(_e144, _e142, _e143);
                    } else {
                        phi_302_ = vec3<f32>(_e142, _e143, _e144);
                    }
                    let _e210 = phi_302_;
                    phi_303_ = _e210;
                }
                let _e212 = phi_303_;
                let _e216 = select(_e205.x, _e198.x, (_e198.x < _e205.x));
                let _e221 = select(_e205.x, _e198.x, (_e198.x > _e205.x));
                let _e227 = (-1f - floor(-(select(_e212.x, _e216, (_e216 < _e212.x)))));
                let _e228 = floor(select(_e212.x, _e221, (_e221 > _e212.x)));
                let _e229 = (_e191.x - 1f);
                let _e231 = select(0f, _e227, (_e227 > 0f));
                let _e233 = select(_e229, _e228, (_e228 < _e229));
                let _e240 = select(0i, select(select(i32(_e231), i32(-2147483648), (_e231 < -2147483600f)), 2147483647i, (_e231 > 2147483500f)), (_e231 == _e231));
                let _e247 = select(0i, select(select(i32(_e233), i32(-2147483648), (_e233 < -2147483600f)), 2147483647i, (_e233 > 2147483500f)), (_e233 == _e233));
                let _e251 = select(_e205.y, _e198.y, (_e198.y < _e205.y));
                let _e256 = select(_e205.y, _e198.y, (_e198.y > _e205.y));
                let _e262 = (-1f - floor(-(select(_e212.y, _e251, (_e251 < _e212.y)))));
                let _e263 = floor(select(_e212.y, _e256, (_e256 > _e212.y)));
                let _e264 = (_e191.y - 1f);
                let _e266 = select(0f, _e262, (_e262 > 0f));
                let _e268 = select(_e264, _e263, (_e263 < _e264));
                let _e275 = select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < -2147483600f)), 2147483647i, (_e266 > 2147483500f)), (_e266 == _e266));
                let _e282 = select(0i, select(select(i32(_e268), i32(-2147483648), (_e268 < -2147483600f)), 2147483647i, (_e268 > 2147483500f)), (_e268 == _e268));
                let _e283 = type_27(_e198, _e205, _e212, vec3<f32>(_e154, _e157, _e160), _e173, _e191, _e240, _e247, _e275, _e282);
                if _e165 {
                    phi_439_ = select(true, false, (_e162 >= _e164));
                } else {
                    phi_439_ = true;
                }
                let _e287 = phi_439_;
                if _e287 {
                    phi_448_ = select(2u, 1u, (_e163 >= _e164));
                } else {
                    phi_448_ = 0u;
                }
                let _e291 = phi_448_;
                if (_e291 == 0u) {
                    phi_458_ = _e154;
                } else {
                    phi_458_ = select(_e160, _e157, (_e291 == 1u));
                }
                let _e296 = phi_458_;
                let _e302 = local_4;
                if (_e302 < _e53) {
                } else {
                    break;
                }
                let _e306 = local_5;
                let _e308 = tile_first.member[_e306];
                let _e309 = (_e59 - _e308);
                if (_e247 < _e240) {
                    phi_479_ = 0u;
                } else {
                    phi_479_ = ((bitcast<u32>((_e247 - _e240)) / 4u) + 1u);
                }
                let _e316 = phi_479_;
                let _e318 = select(1u, _e316, (1u < _e316));
                if (_e318 == 0u) {
                    break;
                }
                let _e320 = (_e309 / _e318);
                let _e325 = (_e240 + bitcast<i32>(((_e309 - (_e320 * _e318)) * 4u)));
                let _e328 = (_e275 + bitcast<i32>((_e320 * 4u)));
                let _e332 = select(_e205.z, _e198.z, (_e198.z < _e205.z));
                let _e337 = select(_e205.z, _e198.z, (_e198.z > _e205.z));
                let _e343 = (-1f - floor(-(select(_e212.z, _e332, (_e332 < _e212.z)))));
                let _e344 = floor(select(_e212.z, _e337, (_e337 > _e212.z)));
                let _e345 = (_e191.z - 1f);
                let _e347 = select(0f, _e343, (_e343 > 0f));
                let _e349 = select(_e345, _e344, (_e344 < _e345));
                let _e356 = select(0i, select(select(i32(_e347), i32(-2147483648), (_e347 < -2147483600f)), 2147483647i, (_e347 > 2147483500f)), (_e347 == _e347));
                let _e363 = select(0i, select(select(i32(_e349), i32(-2147483648), (_e349 < -2147483600f)), 2147483647i, (_e349 > 2147483500f)), (_e349 == _e349));
                let _e371 = ((abs((_e205.x - _e198.x)) + abs((_e205.y - _e198.y))) + abs((_e205.z - _e198.z)));
                let _e379 = ((abs((_e212.x - _e198.x)) + abs((_e212.y - _e198.y))) + abs((_e212.z - _e198.z)));
                let _e381 = select(_e163, _e162, (_e162 > _e163));
                let _e389 = (select(_e164, _e381, (_e381 > _e164)) <= (((0.000004f * _e371) * _e379) * select(_e379, _e371, (_e371 > _e379))));
                let _e390 = (_e325 + 4i);
                let _e391 = (_e247 + 1i);
                let _e393 = select(_e390, _e391, (_e391 < _e390));
                let _e394 = (_e328 + 4i);
                let _e395 = (_e282 + 1i);
                let _e398 = (_e325 - 1i);
                let _e401 = (f32(_e325) + 2f);
                let _e403 = (f32(_e328) + 2f);
                let _e406 = ((_e198.x - _e401) * 0.24937655f);
                let _e407 = ((_e198.y - _e403) * 0.24937655f);
                let _e410 = ((_e205.x - _e401) * 0.24937655f);
                let _e411 = ((_e205.y - _e403) * 0.24937655f);
                let _e414 = ((_e212.x - _e401) * 0.24937655f);
                let _e415 = ((_e212.y - _e403) * 0.24937655f);
                let _e416 = (_e410 - _e406);
                let _e417 = (_e411 - _e407);
                let _e420 = ((_e416 * _e407) - (_e417 * _e406));
                let _e423 = ((_e416 * _e415) - (_e417 * _e414));
                let _e426 = (abs(_e416) + abs(_e417));
                if (select(_e423, _e420, (_e420 < _e423)) > (0.5f * _e426)) {
                    phi_2164_ = true;
                } else {
                    phi_2164_ = (select(_e423, _e420, (_e420 > _e423)) < (_e426 * -0.5f));
                }
                let _e436 = phi_2164_;
                if _e436 {
                    phi_676_ = bool();
                    phi_677_ = true;
                } else {
                    let _e437 = (_e414 - _e410);
                    let _e438 = (_e415 - _e411);
                    let _e441 = ((_e437 * _e411) - (_e438 * _e410));
                    let _e444 = ((_e437 * _e407) - (_e438 * _e406));
                    let _e447 = (abs(_e437) + abs(_e438));
                    if (select(_e444, _e441, (_e441 < _e444)) > (0.5f * _e447)) {
                        phi_2203_ = true;
                    } else {
                        phi_2203_ = (select(_e444, _e441, (_e441 > _e444)) < (_e447 * -0.5f));
                    }
                    let _e457 = phi_2203_;
                    if _e457 {
                        phi_675_ = bool();
                    } else {
                        let _e458 = (_e406 - _e414);
                        let _e459 = (_e407 - _e415);
                        let _e462 = ((_e458 * _e415) - (_e459 * _e414));
                        let _e465 = ((_e458 * _e411) - (_e459 * _e410));
                        let _e468 = (abs(_e458) + abs(_e459));
                        if (select(_e465, _e462, (_e462 < _e465)) > (0.5f * _e468)) {
                            phi_2242_ = true;
                        } else {
                            phi_2242_ = (select(_e465, _e462, (_e462 > _e465)) < (_e468 * -0.5f));
                        }
                        let _e478 = phi_2242_;
                        phi_675_ = _e478;
                    }
                    let _e480 = phi_675_;
                    phi_676_ = _e480;
                    phi_677_ = _e457;
                }
                let _e482 = phi_676_;
                let _e484 = phi_677_;
                if select(_e482, true, _e484) {
                    phi_686_ = type_28(_e283, _e325, _e393, _e328, _e356, _e363, _e398, _e328, 0i, -1i, _e389);
                } else {
                    phi_686_ = type_28(_e283, _e325, _e393, select(_e394, _e395, (_e395 < _e394)), _e356, _e363, _e398, _e328, 0i, -1i, _e389);
                }
                let _e488 = phi_686_;
                phi_2813_ = _e488.member_6;
                phi_2810_ = _e488.member_9;
                phi_2807_ = _e488.member_8;
                phi_2804_ = _e488.member_7;
                loop {
                    let _e507 = phi_2813_;
                    let _e509 = phi_2810_;
                    let _e511 = phi_2807_;
                    let _e513 = phi_2804_;
                    phi_2812_ = _e507;
                    phi_2809_ = _e509;
                    phi_2806_ = _e511;
                    phi_2803_ = _e513;
                    loop {
                        let _e515 = phi_2812_;
                        let _e517 = phi_2809_;
                        let _e519 = phi_2806_;
                        let _e521 = phi_2803_;
                        let _e522 = (_e521 < _e488.member_3);
                        if _e522 {
                            phi_2805_ = _e519;
                            loop {
                                let _e524 = phi_2805_;
                                let _e525 = (_e524 < _e517);
                                if _e525 {
                                    let _e526 = (_e524 + 1i);
                                    let _e530 = (f32(_e515) + 0.5f);
                                    let _e531 = (f32(_e521) + 0.5f);
                                    let _e532 = (f32(_e526) + 0.5f);
                                    let _e534 = (_e488.member.member.x - _e530);
                                    let _e536 = (_e488.member.member.y - _e531);
                                    let _e538 = (_e488.member.member.z - _e532);
                                    let _e539 = vec3<f32>(_e530, _e531, _e532);
                                    let _e542 = (_e488.member.member_1.x - _e530);
                                    let _e544 = (_e488.member.member_1.y - _e531);
                                    let _e546 = (_e488.member.member_1.z - _e532);
                                    let _e549 = (_e488.member.member_2.x - _e530);
                                    let _e551 = (_e488.member.member_2.y - _e531);
                                    let _e553 = (_e488.member.member_2.z - _e532);
                                    let _e556 = select(_e542, _e534, (_e534 < _e542));
                                    let _e560 = select(_e544, _e536, (_e536 < _e544));
                                    let _e564 = select(_e546, _e538, (_e538 < _e546));
                                    let _e568 = select(_e542, _e534, (_e534 > _e542));
                                    let _e572 = select(_e544, _e536, (_e536 > _e544));
                                    let _e576 = select(_e546, _e538, (_e538 > _e546));
                                    if (select(_e549, _e556, (_e556 < _e549)) > 0.5f) {
                                        phi_1330_ = bool();
                                        phi_1331_ = true;
                                        phi_1332_ = false;
                                    } else {
                                        if (select(_e551, _e560, (_e560 < _e551)) > 0.5f) {
                                            phi_1327_ = bool();
                                            phi_1328_ = true;
                                            phi_1329_ = false;
                                        } else {
                                            if (select(_e553, _e564, (_e564 < _e553)) > 0.5f) {
                                                phi_1324_ = bool();
                                                phi_1325_ = true;
                                                phi_1326_ = false;
                                            } else {
                                                if (select(_e549, _e568, (_e568 > _e549)) < -0.5f) {
                                                    phi_1321_ = bool();
                                                    phi_1322_ = true;
                                                    phi_1323_ = false;
                                                } else {
                                                    if (select(_e551, _e572, (_e572 > _e551)) < -0.5f) {
                                                        phi_1318_ = bool();
                                                        phi_1319_ = true;
                                                        phi_1320_ = false;
                                                    } else {
                                                        let _e584 = (select(_e553, _e576, (_e576 > _e553)) < -0.5f);
                                                        if _e584 {
                                                            phi_1316_ = bool();
                                                            phi_1317_ = false;
                                                        } else {
                                                            let _e585 = (_e542 - _e534);
                                                            let _e586 = (_e544 - _e536);
                                                            let _e587 = (_e546 - _e538);
                                                            let _e588 = vec3<f32>(_e585, _e586, _e587);
                                                            let _e589 = (_e549 - _e542);
                                                            let _e590 = (_e551 - _e544);
                                                            let _e591 = (_e553 - _e546);
                                                            let _e592 = vec3<f32>(_e589, _e590, _e591);
                                                            let _e593 = (_e534 - _e549);
                                                            let _e594 = (_e536 - _e551);
                                                            let _e595 = (_e538 - _e553);
                                                            let _e596 = vec3<f32>(_e593, _e594, _e595);
                                                            let _e599 = ((_e586 * _e538) - (_e587 * _e536));
                                                            let _e602 = ((_e586 * _e553) - (_e587 * _e551));
                                                            let _e603 = abs(_e586);
                                                            let _e604 = abs(_e587);
                                                            let _e605 = (_e603 + _e604);
                                                            if (select(_e602, _e599, (_e599 < _e602)) > (0.5f * _e605)) {
                                                                phi_906_ = true;
                                                            } else {
                                                                phi_906_ = (select(_e602, _e599, (_e599 > _e602)) < (_e605 * -0.5f));
                                                            }
                                                            let _e615 = phi_906_;
                                                            if _e615 {
                                                                phi_968_ = bool();
                                                                phi_969_ = true;
                                                            } else {
                                                                let _e618 = ((_e587 * _e534) - (_e585 * _e538));
                                                                let _e621 = ((_e587 * _e549) - (_e585 * _e553));
                                                                let _e622 = abs(_e585);
                                                                let _e623 = (_e604 + _e622);
                                                                if (select(_e621, _e618, (_e618 < _e621)) > (0.5f * _e623)) {
                                                                    phi_936_ = true;
                                                                } else {
                                                                    phi_936_ = (select(_e621, _e618, (_e618 > _e621)) < (_e623 * -0.5f));
                                                                }
                                                                let _e633 = phi_936_;
                                                                if _e633 {
                                                                    phi_967_ = bool();
                                                                } else {
                                                                    let _e636 = ((_e585 * _e536) - (_e586 * _e534));
                                                                    let _e639 = ((_e585 * _e551) - (_e586 * _e549));
                                                                    let _e640 = (_e622 + _e603);
                                                                    if (select(_e639, _e636, (_e636 < _e639)) > (0.5f * _e640)) {
                                                                        phi_966_ = true;
                                                                    } else {
                                                                        phi_966_ = (select(_e639, _e636, (_e636 > _e639)) < (_e640 * -0.5f));
                                                                    }
                                                                    let _e650 = phi_966_;
                                                                    phi_967_ = _e650;
                                                                }
                                                                let _e652 = phi_967_;
                                                                phi_968_ = _e652;
                                                                phi_969_ = _e633;
                                                            }
                                                            let _e654 = phi_968_;
                                                            let _e656 = phi_969_;
                                                            if select(_e654, true, _e656) {
                                                                phi_1311_ = bool();
                                                                phi_1312_ = true;
                                                            } else {
                                                                let _e660 = ((_e590 * _e546) - (_e591 * _e544));
                                                                let _e663 = ((_e590 * _e538) - (_e591 * _e536));
                                                                let _e664 = abs(_e590);
                                                                let _e665 = abs(_e591);
                                                                let _e666 = (_e664 + _e665);
                                                                if (select(_e663, _e660, (_e660 < _e663)) > (0.5f * _e666)) {
                                                                    phi_1003_ = true;
                                                                } else {
                                                                    phi_1003_ = (select(_e663, _e660, (_e660 > _e663)) < (_e666 * -0.5f));
                                                                }
                                                                let _e676 = phi_1003_;
                                                                if _e676 {
                                                                    phi_1065_ = bool();
                                                                    phi_1066_ = true;
                                                                } else {
                                                                    let _e679 = ((_e591 * _e542) - (_e589 * _e546));
                                                                    let _e682 = ((_e591 * _e534) - (_e589 * _e538));
                                                                    let _e683 = abs(_e589);
                                                                    let _e684 = (_e665 + _e683);
                                                                    if (select(_e682, _e679, (_e679 < _e682)) > (0.5f * _e684)) {
                                                                        phi_1033_ = true;
                                                                    } else {
                                                                        phi_1033_ = (select(_e682, _e679, (_e679 > _e682)) < (_e684 * -0.5f));
                                                                    }
                                                                    let _e694 = phi_1033_;
                                                                    if _e694 {
                                                                        phi_1064_ = bool();
                                                                    } else {
                                                                        let _e697 = ((_e589 * _e544) - (_e590 * _e542));
                                                                        let _e700 = ((_e589 * _e536) - (_e590 * _e534));
                                                                        let _e701 = (_e683 + _e664);
                                                                        if (select(_e700, _e697, (_e697 < _e700)) > (0.5f * _e701)) {
                                                                            phi_1063_ = true;
                                                                        } else {
                                                                            phi_1063_ = (select(_e700, _e697, (_e697 > _e700)) < (_e701 * -0.5f));
                                                                        }
                                                                        let _e711 = phi_1063_;
                                                                        phi_1064_ = _e711;
                                                                    }
                                                                    let _e713 = phi_1064_;
                                                                    phi_1065_ = _e713;
                                                                    phi_1066_ = _e694;
                                                                }
                                                                let _e715 = phi_1065_;
                                                                let _e717 = phi_1066_;
                                                                if select(_e715, true, _e717) {
                                                                    phi_1309_ = bool();
                                                                    phi_1310_ = true;
                                                                } else {
                                                                    let _e721 = ((_e594 * _e553) - (_e595 * _e551));
                                                                    let _e724 = ((_e594 * _e546) - (_e595 * _e544));
                                                                    let _e725 = abs(_e594);
                                                                    let _e726 = abs(_e595);
                                                                    let _e727 = (_e725 + _e726);
                                                                    if (select(_e724, _e721, (_e721 < _e724)) > (0.5f * _e727)) {
                                                                        phi_1100_ = true;
                                                                    } else {
                                                                        phi_1100_ = (select(_e724, _e721, (_e721 > _e724)) < (_e727 * -0.5f));
                                                                    }
                                                                    let _e737 = phi_1100_;
                                                                    if _e737 {
                                                                        phi_1162_ = bool();
                                                                        phi_1163_ = true;
                                                                    } else {
                                                                        let _e740 = ((_e595 * _e549) - (_e593 * _e553));
                                                                        let _e743 = ((_e595 * _e542) - (_e593 * _e546));
                                                                        let _e744 = abs(_e593);
                                                                        let _e745 = (_e726 + _e744);
                                                                        if (select(_e743, _e740, (_e740 < _e743)) > (0.5f * _e745)) {
                                                                            phi_1130_ = true;
                                                                        } else {
                                                                            phi_1130_ = (select(_e743, _e740, (_e740 > _e743)) < (_e745 * -0.5f));
                                                                        }
                                                                        let _e755 = phi_1130_;
                                                                        if _e755 {
                                                                            phi_1161_ = bool();
                                                                        } else {
                                                                            let _e758 = ((_e593 * _e551) - (_e594 * _e549));
                                                                            let _e761 = ((_e593 * _e544) - (_e594 * _e542));
                                                                            let _e762 = (_e744 + _e725);
                                                                            if (select(_e761, _e758, (_e758 < _e761)) > (0.5f * _e762)) {
                                                                                phi_1160_ = true;
                                                                            } else {
                                                                                phi_1160_ = (select(_e761, _e758, (_e758 > _e761)) < (_e762 * -0.5f));
                                                                            }
                                                                            let _e772 = phi_1160_;
                                                                            phi_1161_ = _e772;
                                                                        }
                                                                        let _e774 = phi_1161_;
                                                                        phi_1162_ = _e774;
                                                                        phi_1163_ = _e755;
                                                                    }
                                                                    let _e776 = phi_1162_;
                                                                    let _e778 = phi_1163_;
                                                                    let _e779 = select(_e776, true, _e778);
                                                                    if _e779 {
                                                                        phi_1308_ = bool();
                                                                    } else {
                                                                        let _e782 = ((abs(_e585) + _e603) + _e604);
                                                                        let _e785 = ((abs(_e589) + _e664) + _e665);
                                                                        let _e788 = ((abs(_e593) + _e725) + _e726);
                                                                        if (_e782 >= _e785) {
                                                                            phi_1195_ = select(true, false, (_e782 >= _e788));
                                                                        } else {
                                                                            phi_1195_ = true;
                                                                        }
                                                                        let _e793 = phi_1195_;
                                                                        if _e793 {
                                                                            let _e795 = vec3((_e785 >= _e788));
                                                                            phi_1205_ = select(_e588, _e596, _e795);
                                                                            phi_1206_ = select(_e592, _e588, _e795);
                                                                        } else {
                                                                            phi_1205_ = _e592;
                                                                            phi_1206_ = _e596;
                                                                        }
                                                                        let _e799 = phi_1205_;
                                                                        let _e801 = phi_1206_;
                                                                        let _e808 = ((_e799.y * _e801.z) - (_e801.y * _e799.z));
                                                                        let _e813 = ((_e799.z * _e801.x) - (_e801.z * _e799.x));
                                                                        let _e816 = ((_e799.x * _e801.y) - (_e801.x * _e799.y));
                                                                        let _e827 = ((abs(_e534) + abs(_e536)) + abs(_e538));
                                                                        let _e832 = ((abs(_e542) + abs(_e544)) + abs(_e546));
                                                                        let _e837 = ((abs(_e549) + abs(_e551)) + abs(_e553));
                                                                        if (_e827 <= _e832) {
                                                                            phi_1258_ = select(true, false, (_e827 <= _e837));
                                                                        } else {
                                                                            phi_1258_ = true;
                                                                        }
                                                                        let _e842 = phi_1258_;
                                                                        if _e842 {
                                                                            phi_1267_ = select((_e488.member.member_2 - _e539), (_e488.member.member_1 - _e539), vec3((_e832 <= _e837)));
                                                                        } else {
                                                                            phi_1267_ = (_e488.member.member - _e539);
                                                                        }
                                                                        let _e847 = phi_1267_;
                                                                        let _e849 = select(_e832, _e827, (_e827 < _e832));
                                                                        phi_1308_ = (abs((((_e808 * _e847.x) + (_e813 * _e847.y)) + (_e816 * _e847.z))) <= ((0.5f * ((abs(_e808) + abs(_e813)) + abs(_e816))) + (((0.00000036f * select(_e837, _e849, (_e849 < _e837))) * ((abs(_e799.x) + abs(_e799.y)) + abs(_e799.z))) * ((abs(_e801.x) + abs(_e801.y)) + abs(_e801.z)))));
                                                                    }
                                                                    let _e877 = phi_1308_;
                                                                    phi_1309_ = _e877;
                                                                    phi_1310_ = _e779;
                                                                }
                                                                let _e879 = phi_1309_;
                                                                let _e881 = phi_1310_;
                                                                phi_1311_ = _e879;
                                                                phi_1312_ = _e881;
                                                            }
                                                            let _e883 = phi_1311_;
                                                            let _e885 = phi_1312_;
                                                            phi_1316_ = _e883;
                                                            phi_1317_ = _e885;
                                                        }
                                                        let _e887 = phi_1316_;
                                                        let _e889 = phi_1317_;
                                                        phi_1318_ = _e887;
                                                        phi_1319_ = _e584;
                                                        phi_1320_ = _e889;
                                                    }
                                                    let _e891 = phi_1318_;
                                                    let _e893 = phi_1319_;
                                                    let _e895 = phi_1320_;
                                                    phi_1321_ = _e891;
                                                    phi_1322_ = _e893;
                                                    phi_1323_ = _e895;
                                                }
                                                let _e897 = phi_1321_;
                                                let _e899 = phi_1322_;
                                                let _e901 = phi_1323_;
                                                phi_1324_ = _e897;
                                                phi_1325_ = _e899;
                                                phi_1326_ = _e901;
                                            }
                                            let _e903 = phi_1324_;
                                            let _e905 = phi_1325_;
                                            let _e907 = phi_1326_;
                                            phi_1327_ = _e903;
                                            phi_1328_ = _e905;
                                            phi_1329_ = _e907;
                                        }
                                        let _e909 = phi_1327_;
                                        let _e911 = phi_1328_;
                                        let _e913 = phi_1329_;
                                        phi_1330_ = _e909;
                                        phi_1331_ = _e911;
                                        phi_1332_ = _e913;
                                    }
                                    let _e915 = phi_1330_;
                                    let _e917 = phi_1331_;
                                    let _e919 = phi_1332_;
                                    phi_3104_ = _e526;
                                    phi_1345_ = select(true, false, select(_e915, false, select(_e919, true, _e917)));
                                } else {
                                    phi_3104_ = _e524;
                                    phi_1345_ = false;
                                }
                                let _e924 = phi_3104_;
                                let _e926 = phi_1345_;
                                let _e927 = select(true, false, _e525);
                                local_6 = _e927;
                                local_15 = _e924;
                                local_16 = _e927;
                                continue;
                                continuing {
                                    phi_2805_ = _e924;
                                    break if !(_e926);
                                }
                            }
                            let _e930 = local_6;
                            if _e930 {
                                let _e931 = (_e515 + 1i);
                                let _e932 = (_e931 >= _e488.member_2);
                                if _e932 {
                                    phi_2961_ = (_e521 + 1i);
                                } else {
                                    phi_2961_ = _e521;
                                }
                                let _e935 = phi_2961_;
                                let _e936 = select(_e931, _e488.member_1, _e932);
                                if _e488.member_10 {
                                    let _e939 = (_e488.member.member_1.x - _e488.member.member.x);
                                    let _e942 = (_e488.member.member_1.y - _e488.member.member.y);
                                    let _e945 = (_e488.member.member_1.z - _e488.member.member.z);
                                    let _e946 = f32(_e936);
                                    let _e947 = (_e946 - 0.01f);
                                    let _e948 = (_e947 - _e488.member.member.x);
                                    let _e949 = (_e946 + 1.01f);
                                    let _e950 = (_e949 - _e488.member.member.x);
                                    if (abs(_e939) < 0.000001f) {
                                        if (_e948 <= 0f) {
                                            let _e954 = (_e950 >= 0f);
                                            if _e954 {
                                                phi_2277_ = type_22(0f, 1f);
                                            } else {
                                                phi_2277_ = type_22();
                                            }
                                            let _e956 = phi_2277_;
                                            phi_2281_ = _e956;
                                            phi_2282_ = select(true, false, _e954);
                                        } else {
                                            phi_2281_ = type_22();
                                            phi_2282_ = true;
                                        }
                                        let _e959 = phi_2281_;
                                        let _e961 = phi_2282_;
                                        if _e961 {
                                            phi_2287_ = type_22(1f, 0f);
                                        } else {
                                            phi_2287_ = _e959;
                                        }
                                        let _e963 = phi_2287_;
                                        phi_2303_ = _e963;
                                    } else {
                                        let _e964 = (_e948 / _e939);
                                        let _e965 = (_e950 / _e939);
                                        phi_2303_ = type_22(select(_e965, _e964, (_e964 < _e965)), select(_e965, _e964, (_e964 > _e965)));
                                    }
                                    let _e972 = phi_2303_;
                                    let _e975 = f32(_e935);
                                    let _e976 = (_e975 - 0.01f);
                                    let _e977 = (_e976 - _e488.member.member.y);
                                    let _e978 = (_e975 + 1.01f);
                                    let _e979 = (_e978 - _e488.member.member.y);
                                    if (abs(_e942) < 0.000001f) {
                                        if (_e977 <= 0f) {
                                            let _e983 = (_e979 >= 0f);
                                            if _e983 {
                                                phi_2324_ = type_22(0f, 1f);
                                            } else {
                                                phi_2324_ = type_22();
                                            }
                                            let _e985 = phi_2324_;
                                            phi_2328_ = _e985;
                                            phi_2329_ = select(true, false, _e983);
                                        } else {
                                            phi_2328_ = type_22();
                                            phi_2329_ = true;
                                        }
                                        let _e988 = phi_2328_;
                                        let _e990 = phi_2329_;
                                        if _e990 {
                                            phi_2334_ = type_22(1f, 0f);
                                        } else {
                                            phi_2334_ = _e988;
                                        }
                                        let _e992 = phi_2334_;
                                        phi_2350_ = _e992;
                                    } else {
                                        let _e993 = (_e977 / _e942);
                                        let _e994 = (_e979 / _e942);
                                        phi_2350_ = type_22(select(_e994, _e993, (_e993 < _e994)), select(_e994, _e993, (_e993 > _e994)));
                                    }
                                    let _e1001 = phi_2350_;
                                    let _e1005 = select(_e1001.member, _e972.member, (_e972.member > _e1001.member));
                                    let _e1007 = select(0f, _e1005, (_e1005 > 0f));
                                    let _e1009 = select(_e1001.member_1, _e972.member_1, (_e972.member_1 < _e1001.member_1));
                                    let _e1011 = select(1f, _e1009, (_e1009 < 1f));
                                    if (_e1007 > _e1011) {
                                        phi_2398_ = type_22(_e488.member.member_5.z, -2f);
                                    } else {
                                        let _e1016 = (_e488.member.member.z + (_e945 * _e1007));
                                        let _e1018 = (_e488.member.member.z + (_e945 * _e1011));
                                        phi_2398_ = type_22(select(_e1018, _e1016, (_e1016 < _e1018)), select(_e1018, _e1016, (_e1016 > _e1018)));
                                    }
                                    let _e1025 = phi_2398_;
                                    let _e1029 = (_e488.member.member_2.x - _e488.member.member_1.x);
                                    let _e1031 = (_e488.member.member_2.y - _e488.member.member_1.y);
                                    let _e1033 = (_e488.member.member_2.z - _e488.member.member_1.z);
                                    let _e1034 = (_e947 - _e488.member.member_1.x);
                                    let _e1035 = (_e949 - _e488.member.member_1.x);
                                    if (abs(_e1029) < 0.000001f) {
                                        if (_e1034 <= 0f) {
                                            let _e1039 = (_e1035 >= 0f);
                                            if _e1039 {
                                                phi_2432_ = type_22(0f, 1f);
                                            } else {
                                                phi_2432_ = type_22();
                                            }
                                            let _e1041 = phi_2432_;
                                            phi_2436_ = _e1041;
                                            phi_2437_ = select(true, false, _e1039);
                                        } else {
                                            phi_2436_ = type_22();
                                            phi_2437_ = true;
                                        }
                                        let _e1044 = phi_2436_;
                                        let _e1046 = phi_2437_;
                                        if _e1046 {
                                            phi_2442_ = type_22(1f, 0f);
                                        } else {
                                            phi_2442_ = _e1044;
                                        }
                                        let _e1048 = phi_2442_;
                                        phi_2458_ = _e1048;
                                    } else {
                                        let _e1049 = (_e1034 / _e1029);
                                        let _e1050 = (_e1035 / _e1029);
                                        phi_2458_ = type_22(select(_e1050, _e1049, (_e1049 < _e1050)), select(_e1050, _e1049, (_e1049 > _e1050)));
                                    }
                                    let _e1057 = phi_2458_;
                                    let _e1060 = (_e976 - _e488.member.member_1.y);
                                    let _e1061 = (_e978 - _e488.member.member_1.y);
                                    if (abs(_e1031) < 0.000001f) {
                                        if (_e1060 <= 0f) {
                                            let _e1065 = (_e1061 >= 0f);
                                            if _e1065 {
                                                phi_2479_ = type_22(0f, 1f);
                                            } else {
                                                phi_2479_ = type_22();
                                            }
                                            let _e1067 = phi_2479_;
                                            phi_2483_ = _e1067;
                                            phi_2484_ = select(true, false, _e1065);
                                        } else {
                                            phi_2483_ = type_22();
                                            phi_2484_ = true;
                                        }
                                        let _e1070 = phi_2483_;
                                        let _e1072 = phi_2484_;
                                        if _e1072 {
                                            phi_2489_ = type_22(1f, 0f);
                                        } else {
                                            phi_2489_ = _e1070;
                                        }
                                        let _e1074 = phi_2489_;
                                        phi_2505_ = _e1074;
                                    } else {
                                        let _e1075 = (_e1060 / _e1031);
                                        let _e1076 = (_e1061 / _e1031);
                                        phi_2505_ = type_22(select(_e1076, _e1075, (_e1075 < _e1076)), select(_e1076, _e1075, (_e1075 > _e1076)));
                                    }
                                    let _e1083 = phi_2505_;
                                    let _e1087 = select(_e1083.member, _e1057.member, (_e1057.member > _e1083.member));
                                    let _e1089 = select(0f, _e1087, (_e1087 > 0f));
                                    let _e1091 = select(_e1083.member_1, _e1057.member_1, (_e1057.member_1 < _e1083.member_1));
                                    let _e1093 = select(1f, _e1091, (_e1091 < 1f));
                                    if (_e1089 > _e1093) {
                                        phi_2553_ = type_22(_e488.member.member_5.z, -2f);
                                    } else {
                                        let _e1098 = (_e488.member.member_1.z + (_e1033 * _e1089));
                                        let _e1100 = (_e488.member.member_1.z + (_e1033 * _e1093));
                                        phi_2553_ = type_22(select(_e1100, _e1098, (_e1098 < _e1100)), select(_e1100, _e1098, (_e1098 > _e1100)));
                                    }
                                    let _e1107 = phi_2553_;
                                    let _e1110 = (_e488.member.member.x - _e488.member.member_2.x);
                                    let _e1111 = (_e488.member.member.y - _e488.member.member_2.y);
                                    let _e1112 = (_e488.member.member.z - _e488.member.member_2.z);
                                    let _e1113 = (_e947 - _e488.member.member_2.x);
                                    let _e1114 = (_e949 - _e488.member.member_2.x);
                                    if (abs(_e1110) < 0.000001f) {
                                        if (_e1113 <= 0f) {
                                            let _e1118 = (_e1114 >= 0f);
                                            if _e1118 {
                                                phi_2587_ = type_22(0f, 1f);
                                            } else {
                                                phi_2587_ = type_22();
                                            }
                                            let _e1120 = phi_2587_;
                                            phi_2591_ = _e1120;
                                            phi_2592_ = select(true, false, _e1118);
                                        } else {
                                            phi_2591_ = type_22();
                                            phi_2592_ = true;
                                        }
                                        let _e1123 = phi_2591_;
                                        let _e1125 = phi_2592_;
                                        if _e1125 {
                                            phi_2597_ = type_22(1f, 0f);
                                        } else {
                                            phi_2597_ = _e1123;
                                        }
                                        let _e1127 = phi_2597_;
                                        phi_2613_ = _e1127;
                                    } else {
                                        let _e1128 = (_e1113 / _e1110);
                                        let _e1129 = (_e1114 / _e1110);
                                        phi_2613_ = type_22(select(_e1129, _e1128, (_e1128 < _e1129)), select(_e1129, _e1128, (_e1128 > _e1129)));
                                    }
                                    let _e1136 = phi_2613_;
                                    let _e1139 = (_e976 - _e488.member.member_2.y);
                                    let _e1140 = (_e978 - _e488.member.member_2.y);
                                    if (abs(_e1111) < 0.000001f) {
                                        if (_e1139 <= 0f) {
                                            let _e1144 = (_e1140 >= 0f);
                                            if _e1144 {
                                                phi_2634_ = type_22(0f, 1f);
                                            } else {
                                                phi_2634_ = type_22();
                                            }
                                            let _e1146 = phi_2634_;
                                            phi_2638_ = _e1146;
                                            phi_2639_ = select(true, false, _e1144);
                                        } else {
                                            phi_2638_ = type_22();
                                            phi_2639_ = true;
                                        }
                                        let _e1149 = phi_2638_;
                                        let _e1151 = phi_2639_;
                                        if _e1151 {
                                            phi_2644_ = type_22(1f, 0f);
                                        } else {
                                            phi_2644_ = _e1149;
                                        }
                                        let _e1153 = phi_2644_;
                                        phi_2660_ = _e1153;
                                    } else {
                                        let _e1154 = (_e1139 / _e1111);
                                        let _e1155 = (_e1140 / _e1111);
                                        phi_2660_ = type_22(select(_e1155, _e1154, (_e1154 < _e1155)), select(_e1155, _e1154, (_e1154 > _e1155)));
                                    }
                                    let _e1162 = phi_2660_;
                                    let _e1166 = select(_e1162.member, _e1136.member, (_e1136.member > _e1162.member));
                                    let _e1168 = select(0f, _e1166, (_e1166 > 0f));
                                    let _e1170 = select(_e1162.member_1, _e1136.member_1, (_e1136.member_1 < _e1162.member_1));
                                    let _e1172 = select(1f, _e1170, (_e1170 < 1f));
                                    if (_e1168 > _e1172) {
                                        phi_2708_ = type_22(_e488.member.member_5.z, -2f);
                                    } else {
                                        let _e1177 = (_e488.member.member_2.z + (_e1112 * _e1168));
                                        let _e1179 = (_e488.member.member_2.z + (_e1112 * _e1172));
                                        phi_2708_ = type_22(select(_e1179, _e1177, (_e1177 < _e1179)), select(_e1179, _e1177, (_e1177 > _e1179)));
                                    }
                                    let _e1186 = phi_2708_;
                                    let _e1190 = select(_e1107.member, _e1025.member, (_e1025.member < _e1107.member));
                                    let _e1196 = select(_e1107.member_1, _e1025.member_1, (_e1025.member_1 > _e1107.member_1));
                                    phi_1441_ = type_22((floor(select(_e1186.member, _e1190, (_e1190 < _e1186.member))) - 1f), (floor(select(_e1186.member_1, _e1196, (_e1196 > _e1186.member_1))) + 1f));
                                } else {
                                    if (_e488.member.member_4 == 0u) {
                                        phi_1399_ = vec3<f32>(_e488.member.member_3.y, _e488.member.member_3.z, _e488.member.member_3.x);
                                    } else {
                                        if (_e488.member.member_4 == 1u) {
                                            phi_1398_ = vec3<f32>(_e488.member.member_3.z, _e488.member.member_3.x, _e488.member.member_3.y);
                                        } else {
                                            phi_1398_ = _e488.member.member_3;
                                        }
                                        let _e1213 = phi_1398_;
                                        phi_1399_ = _e1213;
                                    }
                                    let _e1215 = phi_1399_;
                                    let _e1232 = (_e488.member.member.z - (((_e1215.x * ((f32(_e936) + 0.5f) - _e488.member.member.x)) + (_e1215.y * ((f32(_e935) + 0.5f) - _e488.member.member.y))) / _e1215.z));
                                    let _e1239 = (((0.5f * (abs(_e1215.x) + abs(_e1215.y))) / abs(_e1215.z)) + 0.3f);
                                    phi_1441_ = type_22((-1f - floor((_e1239 - _e1232))), floor((_e1232 + _e1239)));
                                }
                                let _e1247 = phi_1441_;
                                let _e1250 = f32(_e488.member_4);
                                let _e1252 = select(_e1250, _e1247.member, (_e1247.member > _e1250));
                                let _e1261 = f32(_e488.member_5);
                                let _e1263 = select(_e1261, _e1247.member_1, (_e1247.member_1 < _e1261));
                                phi_3395_ = select(0i, select(select(i32(_e1263), i32(-2147483648), (_e1263 < -2147483600f)), 2147483647i, (_e1263 > 2147483500f)), (_e1263 == _e1263));
                                phi_3102_ = (select(0i, select(select(i32(_e1252), i32(-2147483648), (_e1252 < -2147483600f)), 2147483647i, (_e1252 > 2147483500f)), (_e1252 == _e1252)) - 1i);
                                phi_3078_ = _e935;
                                phi_3048_ = _e936;
                            } else {
                                phi_3395_ = _e517;
                                let _e1519 = local_15;
                                phi_3102_ = _e1519;
                                phi_3078_ = _e521;
                                phi_3048_ = _e515;
                            }
                            let _e1272 = phi_3395_;
                            let _e1274 = phi_3102_;
                            let _e1276 = phi_3078_;
                            let _e1278 = phi_3048_;
                            phi_3394_ = _e1272;
                            phi_3101_ = _e1274;
                            phi_3077_ = _e1276;
                            phi_3047_ = _e1278;
                            let _e1528 = local_16;
                            phi_1481_ = _e1528;
                        } else {
                            phi_3394_ = _e517;
                            phi_3101_ = _e519;
                            phi_3077_ = _e521;
                            phi_3047_ = _e515;
                            phi_1481_ = false;
                        }
                        let _e1280 = phi_3394_;
                        let _e1282 = phi_3101_;
                        let _e1284 = phi_3077_;
                        let _e1286 = phi_3047_;
                        let _e1288 = phi_1481_;
                        local_11 = _e1286;
                        local_12 = _e1280;
                        local_13 = _e1282;
                        local_14 = _e1284;
                        local_7 = select(true, false, _e522);
                        local_8 = _e1286;
                        local_9 = _e1284;
                        local_10 = _e1282;
                        continue;
                        continuing {
                            phi_2812_ = _e1286;
                            phi_2809_ = _e1280;
                            phi_2806_ = _e1282;
                            phi_2803_ = _e1284;
                            break if !(_e1288);
                        }
                    }
                    let _e1292 = local_7;
                    let _e1294 = select(false, true, select(true, false, _e1292));
                    if _e1294 {
                        let _e1296 = local_8;
                        let _e1297 = f32(_e1296);
                        let _e1299 = local_9;
                        let _e1300 = f32(_e1299);
                        let _e1302 = local_10;
                        let _e1303 = f32(_e1302);
                        if (_e488.member.member_4 == 2u) {
                            phi_1511_ = 2u;
                        } else {
                            phi_1511_ = (1u - _e488.member.member_4);
                        }
                        let _e1308 = phi_1511_;
                        if (_e1308 == 0u) {
                            phi_1523_ = vec3<f32>(_e1300, _e1303, _e1297);
                        } else {
                            if (_e1308 == 1u) {
                                phi_1522_ = vec3<f32>(_e1303, _e1297, _e1300);
                            } else {
                                phi_1522_ = vec3<f32>(_e1297, _e1300, _e1303);
                            }
                            let _e1314 = phi_1522_;
                            phi_1523_ = _e1314;
                        }
                        let _e1316 = phi_1523_;
                        let _e1322 = select(select(u32(_e1316.x), 0u, (_e1316.x < 0f)), 4294967295u, (_e1316.x > 4294967000f));
                        let _e1328 = select(select(u32(_e1316.y), 0u, (_e1316.y < 0f)), 4294967295u, (_e1316.y > 4294967000f));
                        let _e1334 = select(select(u32(_e1316.z), 0u, (_e1316.z < 0f)), 4294967295u, (_e1316.z > 4294967000f));
                        let _e1338 = params.member.member_2[0u];
                        let _e1371 = (((((_e1338.z + (_e1322 >> bitcast<u32>(2i))) + (_e1338.x * (_e1328 >> bitcast<u32>(2i)))) + (_e1338.y * (_e1334 >> bitcast<u32>(1i)))) * 6u) + ((2u * _e291) + select(0u, 1u, (_e296 < 0f))));
                        if (_e1371 < arrayLength((&facet_bits.member))) {
                        } else {
                            phi_3175_ = true;
                            break;
                        }
                        let _e1378 = atomicOr((&facet_bits.member[_e1371]), (1u << bitcast<u32>(((((((_e1322 & 1u) | ((_e1328 & 1u) << bitcast<u32>(1i))) | ((_e1334 & 1u) << bitcast<u32>(2i))) | ((_e1322 & 2u) << bitcast<u32>(2i))) | ((_e1328 & 2u) << bitcast<u32>(3i))) & 31u))));
                    }
                    continue;
                    continuing {
                        let _e1416 = local_11;
                        phi_2813_ = _e1416;
                        let _e1419 = local_12;
                        phi_2810_ = _e1419;
                        let _e1422 = local_13;
                        phi_2807_ = _e1422;
                        let _e1425 = local_14;
                        phi_2804_ = _e1425;
                        phi_3175_ = _e87;
                        break if !(_e1294);
                    }
                }
                let _e1381 = phi_3175_;
                if _e1381 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_mark(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
