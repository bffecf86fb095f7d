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
    var phi_122_: u32;
    var phi_125_: u32;
    var phi_123_: u32;
    var phi_126_: u32;
    var phi_2801_: bool;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_239_: bool;
    var phi_248_: u32;
    var phi_268_: vec3<f32>;
    var phi_269_: vec3<f32>;
    var phi_280_: vec3<f32>;
    var phi_281_: vec3<f32>;
    var phi_292_: vec3<f32>;
    var phi_293_: vec3<f32>;
    var phi_304_: vec3<f32>;
    var phi_305_: vec3<f32>;
    var phi_441_: bool;
    var phi_450_: u32;
    var phi_460_: f32;
    var local_4: u32;
    var local_5: u32;
    var phi_481_: u32;
    var phi_2166_: bool;
    var phi_2205_: bool;
    var phi_2244_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_688_: type_28;
    var phi_2815_: i32;
    var phi_2812_: i32;
    var phi_2809_: i32;
    var phi_2806_: i32;
    var phi_2814_: i32;
    var phi_2811_: i32;
    var phi_2808_: i32;
    var phi_2805_: i32;
    var phi_2807_: i32;
    var phi_908_: bool;
    var phi_938_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_970_: bool;
    var phi_971_: bool;
    var phi_1005_: bool;
    var phi_1035_: bool;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1102_: bool;
    var phi_1132_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1197_: bool;
    var phi_1207_: vec3<f32>;
    var phi_1208_: vec3<f32>;
    var phi_1260_: bool;
    var phi_1269_: vec3<f32>;
    var phi_1310_: bool;
    var phi_1311_: bool;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1314_: bool;
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
    var phi_1333_: bool;
    var phi_1334_: bool;
    var phi_3106_: i32;
    var phi_1347_: bool;
    var local_6: bool;
    var phi_2963_: i32;
    var phi_2279_: type_22;
    var phi_2283_: type_22;
    var phi_2284_: bool;
    var phi_2289_: type_22;
    var phi_2305_: type_22;
    var phi_2326_: type_22;
    var phi_2330_: type_22;
    var phi_2331_: bool;
    var phi_2336_: type_22;
    var phi_2352_: type_22;
    var phi_2400_: type_22;
    var phi_2434_: type_22;
    var phi_2438_: type_22;
    var phi_2439_: bool;
    var phi_2444_: type_22;
    var phi_2460_: type_22;
    var phi_2481_: type_22;
    var phi_2485_: type_22;
    var phi_2486_: bool;
    var phi_2491_: type_22;
    var phi_2507_: type_22;
    var phi_2555_: type_22;
    var phi_2589_: type_22;
    var phi_2593_: type_22;
    var phi_2594_: bool;
    var phi_2599_: type_22;
    var phi_2615_: type_22;
    var phi_2636_: type_22;
    var phi_2640_: type_22;
    var phi_2641_: bool;
    var phi_2646_: type_22;
    var phi_2662_: type_22;
    var phi_2710_: type_22;
    var phi_1400_: vec3<f32>;
    var phi_1401_: vec3<f32>;
    var phi_1443_: type_22;
    var phi_3397_: i32;
    var phi_3104_: i32;
    var phi_3080_: i32;
    var phi_3050_: i32;
    var phi_3396_: i32;
    var phi_3103_: i32;
    var phi_3079_: i32;
    var phi_3049_: i32;
    var phi_1483_: bool;
    var local_7: bool;
    var local_8: i32;
    var local_9: i32;
    var local_10: i32;
    var phi_1513_: u32;
    var phi_1524_: vec3<f32>;
    var phi_1525_: vec3<f32>;
    var phi_3177_: bool;
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
                phi_122_ = _e66;
                phi_125_ = 0u;
                loop {
                    let _e68 = phi_122_;
                    let _e70 = phi_125_;
                    local = _e70;
                    local_1 = _e70;
                    local_2 = _e70;
                    local_3 = _e70;
                    local_4 = _e70;
                    local_5 = _e70;
                    let _e72 = ((_e68 - _e70) > 1u);
                    if _e72 {
                        let _e74 = ((_e70 + _e68) / 2u);
                        if (_e74 < _e53) {
                        } else {
                            phi_2801_ = true;
                            break;
                        }
                        let _e78 = tile_first.member[_e74];
                        let _e79 = (_e78 <= _e59);
                        phi_123_ = select(_e74, _e68, _e79);
                        phi_126_ = select(_e70, _e74, _e79);
                    } else {
                        phi_123_ = u32();
                        phi_126_ = u32();
                    }
                    let _e83 = phi_123_;
                    let _e85 = phi_126_;
                    continue;
                    continuing {
                        phi_122_ = _e83;
                        phi_125_ = _e85;
                        phi_2801_ = false;
                        break if !(_e72);
                    }
                }
                let _e88 = phi_2801_;
                if _e88 {
                    break;
                }
                let _e90 = local;
                if (_e90 < arrayLength((&triangles.member))) {
                } else {
                    break;
                }
                let _e94 = local_1;
                let _e97 = triangles.member[_e94].member;
                let _e103 = params.member.member;
                let _e111 = ((_e97[0] - _e103.x) / _e103.w);
                let _e112 = ((_e97[1] - _e103.y) / _e103.w);
                let _e113 = ((_e97[2] - _e103.z) / _e103.w);
                let _e117 = local_2;
                let _e120 = triangles.member[_e117].member_2;
                let _e127 = ((_e120[0] - _e103.x) / _e103.w);
                let _e128 = ((_e120[1] - _e103.y) / _e103.w);
                let _e129 = ((_e120[2] - _e103.z) / _e103.w);
                let _e133 = local_3;
                let _e136 = triangles.member[_e133].member_4;
                let _e143 = ((_e136[0] - _e103.x) / _e103.w);
                let _e144 = ((_e136[1] - _e103.y) / _e103.w);
                let _e145 = ((_e136[2] - _e103.z) / _e103.w);
                let _e147 = (_e127 - _e111);
                let _e148 = (_e128 - _e112);
                let _e149 = (_e129 - _e113);
                let _e150 = (_e143 - _e111);
                let _e151 = (_e144 - _e112);
                let _e152 = (_e145 - _e113);
                let _e155 = ((_e148 * _e152) - (_e151 * _e149));
                let _e158 = ((_e149 * _e150) - (_e152 * _e147));
                let _e161 = ((_e147 * _e151) - (_e150 * _e148));
                let _e163 = abs(_e155);
                let _e164 = abs(_e158);
                let _e165 = abs(_e161);
                let _e166 = (_e163 >= _e164);
                if _e166 {
                    phi_239_ = select(true, false, (_e163 >= _e165));
                } else {
                    phi_239_ = true;
                }
                let _e170 = phi_239_;
                if _e170 {
                    phi_248_ = select(2u, 1u, (_e164 >= _e165));
                } else {
                    phi_248_ = 0u;
                }
                let _e174 = phi_248_;
                let _e177 = params.member.member_1;
                let _e179 = f32(_e177.x);
                let _e181 = f32(_e177.y);
                let _e183 = f32(_e177.z);
                let _e185 = (_e174 == 0u);
                if _e185 {
                    phi_269_ = vec3<f32>(_e181, _e183, _e179);
                } else {
                    if (_e174 == 1u) {
                        phi_268_ = vec3<f32>(_e183, _e179, _e181);
                    } else {
                        phi_268_ = vec3<f32>(_e179, _e181, _e183);
                    }
                    let _e190 = phi_268_;
                    phi_269_ = _e190;
                }
                let _e192 = phi_269_;
                if _e185 {
                    phi_281_ = vec3<f32>(_e112, _e113, _e111);
                } else {
                    if (_e174 == 1u) {
                        phi_280_ = vec3<f32>(_e113, _e111, _e112);
                    } else {
                        phi_280_ = vec3<f32>(_e111, _e112, _e113);
                    }
                    let _e197 = phi_280_;
                    phi_281_ = _e197;
                }
                let _e199 = phi_281_;
                if _e185 {
                    phi_293_ = vec3<f32>(_e128, _e129, _e127);
                } else {
                    if (_e174 == 1u) {
                        phi_292_ = vec3<f32>(_e129, _e127, _e128);
                    } else {
                        phi_292_ = vec3<f32>(_e127, _e128, _e129);
                    }
                    let _e204 = phi_292_;
                    phi_293_ = _e204;
                }
                let _e206 = phi_293_;
                if _e185 {
                    phi_305_ = vec3<f32>(_e144, _e145, _e143);
                } else {
                    if (_e174 == 1u) {
                        phi_304_ = vec3<f32>(_e145, _e143, _e144);
                    } else {
                        phi_304_ = vec3<f32>(_e143, _e144, _e145);
                    }
                    let _e211 = phi_304_;
                    phi_305_ = _e211;
                }
                let _e213 = phi_305_;
                let _e217 = select(_e206.x, _e199.x, (_e199.x < _e206.x));
                let _e222 = select(_e206.x, _e199.x, (_e199.x > _e206.x));
                let _e228 = (-1f - floor(-(select(_e213.x, _e217, (_e217 < _e213.x)))));
                let _e229 = floor(select(_e213.x, _e222, (_e222 > _e213.x)));
                let _e230 = (_e192.x - 1f);
                let _e232 = select(0f, _e228, (_e228 > 0f));
                let _e234 = select(_e230, _e229, (_e229 < _e230));
                let _e241 = select(0i, select(select(i32(_e232), i32(-2147483648), (_e232 < -2147483600f)), 2147483647i, (_e232 > 2147483500f)), (_e232 == _e232));
                let _e248 = select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < -2147483600f)), 2147483647i, (_e234 > 2147483500f)), (_e234 == _e234));
                let _e252 = select(_e206.y, _e199.y, (_e199.y < _e206.y));
                let _e257 = select(_e206.y, _e199.y, (_e199.y > _e206.y));
                let _e263 = (-1f - floor(-(select(_e213.y, _e252, (_e252 < _e213.y)))));
                let _e264 = floor(select(_e213.y, _e257, (_e257 > _e213.y)));
                let _e265 = (_e192.y - 1f);
                let _e267 = select(0f, _e263, (_e263 > 0f));
                let _e269 = select(_e265, _e264, (_e264 < _e265));
                let _e276 = select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < -2147483600f)), 2147483647i, (_e267 > 2147483500f)), (_e267 == _e267));
                let _e283 = select(0i, select(select(i32(_e269), i32(-2147483648), (_e269 < -2147483600f)), 2147483647i, (_e269 > 2147483500f)), (_e269 == _e269));
                let _e284 = type_27(_e199, _e206, _e213, vec3<f32>(_e155, _e158, _e161), _e174, _e192, _e241, _e248, _e276, _e283);
                if _e166 {
                    phi_441_ = select(true, false, (_e163 >= _e165));
                } else {
                    phi_441_ = true;
                }
                let _e288 = phi_441_;
                if _e288 {
                    phi_450_ = select(2u, 1u, (_e164 >= _e165));
                } else {
                    phi_450_ = 0u;
                }
                let _e292 = phi_450_;
                if (_e292 == 0u) {
                    phi_460_ = _e155;
                } else {
                    phi_460_ = select(_e161, _e158, (_e292 == 1u));
                }
                let _e297 = phi_460_;
                let _e303 = local_4;
                if (_e303 < _e53) {
                } else {
                    break;
                }
                let _e307 = local_5;
                let _e309 = tile_first.member[_e307];
                let _e310 = (_e59 - _e309);
                if (_e248 < _e241) {
                    phi_481_ = 0u;
                } else {
                    phi_481_ = ((bitcast<u32>((_e248 - _e241)) / 4u) + 1u);
                }
                let _e317 = phi_481_;
                let _e319 = select(1u, _e317, (1u < _e317));
                if (_e319 == 0u) {
                    break;
                }
                let _e321 = (_e310 / _e319);
                let _e326 = (_e241 + bitcast<i32>(((_e310 - (_e321 * _e319)) * 4u)));
                let _e329 = (_e276 + bitcast<i32>((_e321 * 4u)));
                let _e333 = select(_e206.z, _e199.z, (_e199.z < _e206.z));
                let _e338 = select(_e206.z, _e199.z, (_e199.z > _e206.z));
                let _e344 = (-1f - floor(-(select(_e213.z, _e333, (_e333 < _e213.z)))));
                let _e345 = floor(select(_e213.z, _e338, (_e338 > _e213.z)));
                let _e346 = (_e192.z - 1f);
                let _e348 = select(0f, _e344, (_e344 > 0f));
                let _e350 = select(_e346, _e345, (_e345 < _e346));
                let _e357 = select(0i, select(select(i32(_e348), i32(-2147483648), (_e348 < -2147483600f)), 2147483647i, (_e348 > 2147483500f)), (_e348 == _e348));
                let _e364 = select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < -2147483600f)), 2147483647i, (_e350 > 2147483500f)), (_e350 == _e350));
                let _e372 = ((abs((_e206.x - _e199.x)) + abs((_e206.y - _e199.y))) + abs((_e206.z - _e199.z)));
                let _e380 = ((abs((_e213.x - _e199.x)) + abs((_e213.y - _e199.y))) + abs((_e213.z - _e199.z)));
                let _e382 = select(_e164, _e163, (_e163 > _e164));
                let _e390 = (select(_e165, _e382, (_e382 > _e165)) <= (((0.000004f * _e372) * _e380) * select(_e380, _e372, (_e372 > _e380))));
                let _e391 = (_e326 + 4i);
                let _e392 = (_e248 + 1i);
                let _e394 = select(_e391, _e392, (_e392 < _e391));
                let _e395 = (_e329 + 4i);
                let _e396 = (_e283 + 1i);
                let _e399 = (_e326 - 1i);
                let _e402 = (f32(_e326) + 2f);
                let _e404 = (f32(_e329) + 2f);
                let _e407 = ((_e199.x - _e402) * 0.24937655f);
                let _e408 = ((_e199.y - _e404) * 0.24937655f);
                let _e411 = ((_e206.x - _e402) * 0.24937655f);
                let _e412 = ((_e206.y - _e404) * 0.24937655f);
                let _e415 = ((_e213.x - _e402) * 0.24937655f);
                let _e416 = ((_e213.y - _e404) * 0.24937655f);
                let _e417 = (_e411 - _e407);
                let _e418 = (_e412 - _e408);
                let _e421 = ((_e417 * _e408) - (_e418 * _e407));
                let _e424 = ((_e417 * _e416) - (_e418 * _e415));
                let _e427 = (abs(_e417) + abs(_e418));
                if (select(_e424, _e421, (_e421 < _e424)) > (0.5f * _e427)) {
                    phi_2166_ = true;
                } else {
                    phi_2166_ = (select(_e424, _e421, (_e421 > _e424)) < (_e427 * -0.5f));
                }
                let _e437 = phi_2166_;
                if _e437 {
                    phi_678_ = bool();
                    phi_679_ = true;
                } else {
                    let _e438 = (_e415 - _e411);
                    let _e439 = (_e416 - _e412);
                    let _e442 = ((_e438 * _e412) - (_e439 * _e411));
                    let _e445 = ((_e438 * _e408) - (_e439 * _e407));
                    let _e448 = (abs(_e438) + abs(_e439));
                    if (select(_e445, _e442, (_e442 < _e445)) > (0.5f * _e448)) {
                        phi_2205_ = true;
                    } else {
                        phi_2205_ = (select(_e445, _e442, (_e442 > _e445)) < (_e448 * -0.5f));
                    }
                    let _e458 = phi_2205_;
                    if _e458 {
                        phi_677_ = bool();
                    } else {
                        let _e459 = (_e407 - _e415);
                        let _e460 = (_e408 - _e416);
                        let _e463 = ((_e459 * _e416) - (_e460 * _e415));
                        let _e466 = ((_e459 * _e412) - (_e460 * _e411));
                        let _e469 = (abs(_e459) + abs(_e460));
                        if (select(_e466, _e463, (_e463 < _e466)) > (0.5f * _e469)) {
                            phi_2244_ = true;
                        } else {
                            phi_2244_ = (select(_e466, _e463, (_e463 > _e466)) < (_e469 * -0.5f));
                        }
                        let _e479 = phi_2244_;
                        phi_677_ = _e479;
                    }
                    let _e481 = phi_677_;
                    phi_678_ = _e481;
                    phi_679_ = _e458;
                }
                let _e483 = phi_678_;
                let _e485 = phi_679_;
                if select(_e483, true, _e485) {
                    phi_688_ = type_28(_e284, _e326, _e394, _e329, _e357, _e364, _e399, _e329, 0i, -1i, _e390);
                } else {
                    phi_688_ = type_28(_e284, _e326, _e394, select(_e395, _e396, (_e396 < _e395)), _e357, _e364, _e399, _e329, 0i, -1i, _e390);
                }
                let _e489 = phi_688_;
                phi_2815_ = _e489.member_6;
                phi_2812_ = _e489.member_9;
                phi_2809_ = _e489.member_8;
                phi_2806_ = _e489.member_7;
                loop {
                    let _e508 = phi_2815_;
                    let _e510 = phi_2812_;
                    let _e512 = phi_2809_;
                    let _e514 = phi_2806_;
                    phi_2814_ = _e508;
                    phi_2811_ = _e510;
                    phi_2808_ = _e512;
                    phi_2805_ = _e514;
                    loop {
                        let _e516 = phi_2814_;
                        let _e518 = phi_2811_;
                        let _e520 = phi_2808_;
                        let _e522 = phi_2805_;
                        let _e523 = (_e522 < _e489.member_3);
                        if _e523 {
                            phi_2807_ = _e520;
                            loop {
                                let _e525 = phi_2807_;
                                let _e526 = (_e525 < _e518);
                                if _e526 {
                                    let _e527 = (_e525 + 1i);
                                    let _e531 = (f32(_e516) + 0.5f);
                                    let _e532 = (f32(_e522) + 0.5f);
                                    let _e533 = (f32(_e527) + 0.5f);
                                    let _e535 = (_e489.member.member.x - _e531);
                                    let _e537 = (_e489.member.member.y - _e532);
                                    let _e539 = (_e489.member.member.z - _e533);
                                    let _e540 = vec3<f32>(_e531, _e532, _e533);
                                    let _e543 = (_e489.member.member_1.x - _e531);
                                    let _e545 = (_e489.member.member_1.y - _e532);
                                    let _e547 = (_e489.member.member_1.z - _e533);
                                    let _e550 = (_e489.member.member_2.x - _e531);
                                    let _e552 = (_e489.member.member_2.y - _e532);
                                    let _e554 = (_e489.member.member_2.z - _e533);
                                    let _e557 = select(_e543, _e535, (_e535 < _e543));
                                    let _e561 = select(_e545, _e537, (_e537 < _e545));
                                    let _e565 = select(_e547, _e539, (_e539 < _e547));
                                    let _e569 = select(_e543, _e535, (_e535 > _e543));
                                    let _e573 = select(_e545, _e537, (_e537 > _e545));
                                    let _e577 = select(_e547, _e539, (_e539 > _e547));
                                    if (select(_e550, _e557, (_e557 < _e550)) > 0.5f) {
                                        phi_1332_ = bool();
                                        phi_1333_ = true;
                                        phi_1334_ = false;
                                    } else {
                                        if (select(_e552, _e561, (_e561 < _e552)) > 0.5f) {
                                            phi_1329_ = bool();
                                            phi_1330_ = true;
                                            phi_1331_ = false;
                                        } else {
                                            if (select(_e554, _e565, (_e565 < _e554)) > 0.5f) {
                                                phi_1326_ = bool();
                                                phi_1327_ = true;
                                                phi_1328_ = false;
                                            } else {
                                                if (select(_e550, _e569, (_e569 > _e550)) < -0.5f) {
                                                    phi_1323_ = bool();
                                                    phi_1324_ = true;
                                                    phi_1325_ = false;
                                                } else {
                                                    if (select(_e552, _e573, (_e573 > _e552)) < -0.5f) {
                                                        phi_1320_ = bool();
                                                        phi_1321_ = true;
                                                        phi_1322_ = false;
                                                    } else {
                                                        let _e585 = (select(_e554, _e577, (_e577 > _e554)) < -0.5f);
                                                        if _e585 {
                                                            phi_1318_ = bool();
                                                            phi_1319_ = false;
                                                        } else {
                                                            let _e586 = (_e543 - _e535);
                                                            let _e587 = (_e545 - _e537);
                                                            let _e588 = (_e547 - _e539);
                                                            let _e589 = vec3<f32>(_e586, _e587, _e588);
                                                            let _e590 = (_e550 - _e543);
                                                            let _e591 = (_e552 - _e545);
                                                            let _e592 = (_e554 - _e547);
                                                            let _e593 = vec3<f32>(_e590, _e591, _e592);
                                                            let _e594 = (_e535 - _e550);
                                                            let _e595 = (_e537 - _e552);
                                                            let _e596 = (_e539 - _e554);
                                                            let _e597 = vec3<f32>(_e594, _e595, _e596);
                                                            let _e600 = ((_e587 * _e539) - (_e588 * _e537));
                                                            let _e603 = ((_e587 * _e554) - (_e588 * _e552));
                                                            let _e604 = abs(_e587);
                                                            let _e605 = abs(_e588);
                                                            let _e606 = (_e604 + _e605);
                                                            if (select(_e603, _e600, (_e600 < _e603)) > (0.5f * _e606)) {
                                                                phi_908_ = true;
                                                            } else {
                                                                phi_908_ = (select(_e603, _e600, (_e600 > _e603)) < (_e606 * -0.5f));
                                                            }
                                                            let _e616 = phi_908_;
                                                            if _e616 {
                                                                phi_970_ = bool();
                                                                phi_971_ = true;
                                                            } else {
                                                                let _e619 = ((_e588 * _e535) - (_e586 * _e539));
                                                                let _e622 = ((_e588 * _e550) - (_e586 * _e554));
                                                                let _e623 = abs(_e586);
                                                                let _e624 = (_e605 + _e623);
                                                                if (select(_e622, _e619, (_e619 < _e622)) > (0.5f * _e624)) {
                                                                    phi_938_ = true;
                                                                } else {
                                                                    phi_938_ = (select(_e622, _e619, (_e619 > _e622)) < (_e624 * -0.5f));
                                                                }
                                                                let _e634 = phi_938_;
                                                                if _e634 {
                                                                    phi_969_ = bool();
                                                                } else {
                                                                    let _e637 = ((_e586 * _e537) - (_e587 * _e535));
                                                                    let _e640 = ((_e586 * _e552) - (_e587 * _e550));
                                                                    let _e641 = (_e623 + _e604);
                                                                    if (select(_e640, _e637, (_e637 < _e640)) > (0.5f * _e641)) {
                                                                        phi_968_ = true;
                                                                    } else {
                                                                        phi_968_ = (select(_e640, _e637, (_e637 > _e640)) < (_e641 * -0.5f));
                                                                    }
                                                                    let _e651 = phi_968_;
                                                                    phi_969_ = _e651;
                                                                }
                                                                let _e653 = phi_969_;
                                                                phi_970_ = _e653;
                                                                phi_971_ = _e634;
                                                            }
                                                            let _e655 = phi_970_;
                                                            let _e657 = phi_971_;
                                                            if select(_e655, true, _e657) {
                                                                phi_1313_ = bool();
                                                                phi_1314_ = true;
                                                            } else {
                                                                let _e661 = ((_e591 * _e547) - (_e592 * _e545));
                                                                let _e664 = ((_e591 * _e539) - (_e592 * _e537));
                                                                let _e665 = abs(_e591);
                                                                let _e666 = abs(_e592);
                                                                let _e667 = (_e665 + _e666);
                                                                if (select(_e664, _e661, (_e661 < _e664)) > (0.5f * _e667)) {
                                                                    phi_1005_ = true;
                                                                } else {
                                                                    phi_1005_ = (select(_e664, _e661, (_e661 > _e664)) < (_e667 * -0.5f));
                                                                }
                                                                let _e677 = phi_1005_;
                                                                if _e677 {
                                                                    phi_1067_ = bool();
                                                                    phi_1068_ = true;
                                                                } else {
                                                                    let _e680 = ((_e592 * _e543) - (_e590 * _e547));
                                                                    let _e683 = ((_e592 * _e535) - (_e590 * _e539));
                                                                    let _e684 = abs(_e590);
                                                                    let _e685 = (_e666 + _e684);
                                                                    if (select(_e683, _e680, (_e680 < _e683)) > (0.5f * _e685)) {
                                                                        phi_1035_ = true;
                                                                    } else {
                                                                        phi_1035_ = (select(_e683, _e680, (_e680 > _e683)) < (_e685 * -0.5f));
                                                                    }
                                                                    let _e695 = phi_1035_;
                                                                    if _e695 {
                                                                        phi_1066_ = bool();
                                                                    } else {
                                                                        let _e698 = ((_e590 * _e545) - (_e591 * _e543));
                                                                        let _e701 = ((_e590 * _e537) - (_e591 * _e535));
                                                                        let _e702 = (_e684 + _e665);
                                                                        if (select(_e701, _e698, (_e698 < _e701)) > (0.5f * _e702)) {
                                                                            phi_1065_ = true;
                                                                        } else {
                                                                            phi_1065_ = (select(_e701, _e698, (_e698 > _e701)) < (_e702 * -0.5f));
                                                                        }
                                                                        let _e712 = phi_1065_;
                                                                        phi_1066_ = _e712;
                                                                    }
                                                                    let _e714 = phi_1066_;
                                                                    phi_1067_ = _e714;
                                                                    phi_1068_ = _e695;
                                                                }
                                                                let _e716 = phi_1067_;
                                                                let _e718 = phi_1068_;
                                                                if select(_e716, true, _e718) {
                                                                    phi_1311_ = bool();
                                                                    phi_1312_ = true;
                                                                } else {
                                                                    let _e722 = ((_e595 * _e554) - (_e596 * _e552));
                                                                    let _e725 = ((_e595 * _e547) - (_e596 * _e545));
                                                                    let _e726 = abs(_e595);
                                                                    let _e727 = abs(_e596);
                                                                    let _e728 = (_e726 + _e727);
                                                                    if (select(_e725, _e722, (_e722 < _e725)) > (0.5f * _e728)) {
                                                                        phi_1102_ = true;
                                                                    } else {
                                                                        phi_1102_ = (select(_e725, _e722, (_e722 > _e725)) < (_e728 * -0.5f));
                                                                    }
                                                                    let _e738 = phi_1102_;
                                                                    if _e738 {
                                                                        phi_1164_ = bool();
                                                                        phi_1165_ = true;
                                                                    } else {
                                                                        let _e741 = ((_e596 * _e550) - (_e594 * _e554));
                                                                        let _e744 = ((_e596 * _e543) - (_e594 * _e547));
                                                                        let _e745 = abs(_e594);
                                                                        let _e746 = (_e727 + _e745);
                                                                        if (select(_e744, _e741, (_e741 < _e744)) > (0.5f * _e746)) {
                                                                            phi_1132_ = true;
                                                                        } else {
                                                                            phi_1132_ = (select(_e744, _e741, (_e741 > _e744)) < (_e746 * -0.5f));
                                                                        }
                                                                        let _e756 = phi_1132_;
                                                                        if _e756 {
                                                                            phi_1163_ = bool();
                                                                        } else {
                                                                            let _e759 = ((_e594 * _e552) - (_e595 * _e550));
                                                                            let _e762 = ((_e594 * _e545) - (_e595 * _e543));
                                                                            let _e763 = (_e745 + _e726);
                                                                            if (select(_e762, _e759, (_e759 < _e762)) > (0.5f * _e763)) {
                                                                                phi_1162_ = true;
                                                                            } else {
                                                                                phi_1162_ = (select(_e762, _e759, (_e759 > _e762)) < (_e763 * -0.5f));
                                                                            }
                                                                            let _e773 = phi_1162_;
                                                                            phi_1163_ = _e773;
                                                                        }
                                                                        let _e775 = phi_1163_;
                                                                        phi_1164_ = _e775;
                                                                        phi_1165_ = _e756;
                                                                    }
                                                                    let _e777 = phi_1164_;
                                                                    let _e779 = phi_1165_;
                                                                    let _e780 = select(_e777, true, _e779);
                                                                    if _e780 {
                                                                        phi_1310_ = bool();
                                                                    } else {
                                                                        let _e783 = ((abs(_e586) + _e604) + _e605);
                                                                        let _e786 = ((abs(_e590) + _e665) + _e666);
                                                                        let _e789 = ((abs(_e594) + _e726) + _e727);
                                                                        if (_e783 >= _e786) {
                                                                            phi_1197_ = select(true, false, (_e783 >= _e789));
                                                                        } else {
                                                                            phi_1197_ = true;
                                                                        }
                                                                        let _e794 = phi_1197_;
                                                                        if _e794 {
                                                                            let _e796 = vec3((_e786 >= _e789));
                                                                            phi_1207_ = select(_e589, _e597, _e796);
                                                                            phi_1208_ = select(_e593, _e589, _e796);
                                                                        } else {
                                                                            phi_1207_ = _e593;
                                                                            phi_1208_ = _e597;
                                                                        }
                                                                        let _e800 = phi_1207_;
                                                                        let _e802 = phi_1208_;
                                                                        let _e809 = ((_e800.y * _e802.z) - (_e802.y * _e800.z));
                                                                        let _e814 = ((_e800.z * _e802.x) - (_e802.z * _e800.x));
                                                                        let _e817 = ((_e800.x * _e802.y) - (_e802.x * _e800.y));
                                                                        let _e828 = ((abs(_e535) + abs(_e537)) + abs(_e539));
                                                                        let _e833 = ((abs(_e543) + abs(_e545)) + abs(_e547));
                                                                        let _e838 = ((abs(_e550) + abs(_e552)) + abs(_e554));
                                                                        if (_e828 <= _e833) {
                                                                            phi_1260_ = select(true, false, (_e828 <= _e838));
                                                                        } else {
                                                                            phi_1260_ = true;
                                                                        }
                                                                        let _e843 = phi_1260_;
                                                                        if _e843 {
                                                                            phi_1269_ = select((_e489.member.member_2 - _e540), (_e489.member.member_1 - _e540), vec3((_e833 <= _e838)));
                                                                        } else {
                                                                            phi_1269_ = (_e489.member.member - _e540);
                                                                        }
                                                                        let _e848 = phi_1269_;
                                                                        let _e850 = select(_e833, _e828, (_e828 < _e833));
                                                                        phi_1310_ = (abs((((_e809 * _e848.x) + (_e814 * _e848.y)) + (_e817 * _e848.z))) <= ((0.5f * ((abs(_e809) + abs(_e814)) + abs(_e817))) + (((0.00000036f * select(_e838, _e850, (_e850 < _e838))) * ((abs(_e800.x) + abs(_e800.y)) + abs(_e800.z))) * ((abs(_e802.x) + abs(_e802.y)) + abs(_e802.z)))));
                                                                    }
                                                                    let _e878 = phi_1310_;
                                                                    phi_1311_ = _e878;
                                                                    phi_1312_ = _e780;
                                                                }
                                                                let _e880 = phi_1311_;
                                                                let _e882 = phi_1312_;
                                                                phi_1313_ = _e880;
                                                                phi_1314_ = _e882;
                                                            }
                                                            let _e884 = phi_1313_;
                                                            let _e886 = phi_1314_;
                                                            phi_1318_ = _e884;
                                                            phi_1319_ = _e886;
                                                        }
                                                        let _e888 = phi_1318_;
                                                        let _e890 = phi_1319_;
                                                        phi_1320_ = _e888;
                                                        phi_1321_ = _e585;
                                                        phi_1322_ = _e890;
                                                    }
                                                    let _e892 = phi_1320_;
                                                    let _e894 = phi_1321_;
                                                    let _e896 = phi_1322_;
                                                    phi_1323_ = _e892;
                                                    phi_1324_ = _e894;
                                                    phi_1325_ = _e896;
                                                }
                                                let _e898 = phi_1323_;
                                                let _e900 = phi_1324_;
                                                let _e902 = phi_1325_;
                                                phi_1326_ = _e898;
                                                phi_1327_ = _e900;
                                                phi_1328_ = _e902;
                                            }
                                            let _e904 = phi_1326_;
                                            let _e906 = phi_1327_;
                                            let _e908 = phi_1328_;
                                            phi_1329_ = _e904;
                                            phi_1330_ = _e906;
                                            phi_1331_ = _e908;
                                        }
                                        let _e910 = phi_1329_;
                                        let _e912 = phi_1330_;
                                        let _e914 = phi_1331_;
                                        phi_1332_ = _e910;
                                        phi_1333_ = _e912;
                                        phi_1334_ = _e914;
                                    }
                                    let _e916 = phi_1332_;
                                    let _e918 = phi_1333_;
                                    let _e920 = phi_1334_;
                                    phi_3106_ = _e527;
                                    phi_1347_ = select(true, false, select(_e916, false, select(_e920, true, _e918)));
                                } else {
                                    phi_3106_ = _e525;
                                    phi_1347_ = false;
                                }
                                let _e925 = phi_3106_;
                                let _e927 = phi_1347_;
                                let _e928 = select(true, false, _e526);
                                local_6 = _e928;
                                local_15 = _e925;
                                local_16 = _e928;
                                continue;
                                continuing {
                                    phi_2807_ = _e925;
                                    break if !(_e927);
                                }
                            }
                            let _e931 = local_6;
                            if _e931 {
                                let _e932 = (_e516 + 1i);
                                let _e933 = (_e932 >= _e489.member_2);
                                if _e933 {
                                    phi_2963_ = (_e522 + 1i);
                                } else {
                                    phi_2963_ = _e522;
                                }
                                let _e936 = phi_2963_;
                                let _e937 = select(_e932, _e489.member_1, _e933);
                                if _e489.member_10 {
                                    let _e940 = (_e489.member.member_1.x - _e489.member.member.x);
                                    let _e943 = (_e489.member.member_1.y - _e489.member.member.y);
                                    let _e946 = (_e489.member.member_1.z - _e489.member.member.z);
                                    let _e947 = f32(_e937);
                                    let _e948 = (_e947 - 0.01f);
                                    let _e949 = (_e948 - _e489.member.member.x);
                                    let _e950 = (_e947 + 1.01f);
                                    let _e951 = (_e950 - _e489.member.member.x);
                                    if (abs(_e940) < 0.000001f) {
                                        if (_e949 <= 0f) {
                                            let _e955 = (_e951 >= 0f);
                                            if _e955 {
                                                phi_2279_ = type_22(0f, 1f);
                                            } else {
                                                phi_2279_ = type_22();
                                            }
                                            let _e957 = phi_2279_;
                                            phi_2283_ = _e957;
                                            phi_2284_ = select(true, false, _e955);
                                        } else {
                                            phi_2283_ = type_22();
                                            phi_2284_ = true;
                                        }
                                        let _e960 = phi_2283_;
                                        let _e962 = phi_2284_;
                                        if _e962 {
                                            phi_2289_ = type_22(1f, 0f);
                                        } else {
                                            phi_2289_ = _e960;
                                        }
                                        let _e964 = phi_2289_;
                                        phi_2305_ = _e964;
                                    } else {
                                        let _e965 = (_e949 / _e940);
                                        let _e966 = (_e951 / _e940);
                                        phi_2305_ = type_22(select(_e966, _e965, (_e965 < _e966)), select(_e966, _e965, (_e965 > _e966)));
                                    }
                                    let _e973 = phi_2305_;
                                    let _e976 = f32(_e936);
                                    let _e977 = (_e976 - 0.01f);
                                    let _e978 = (_e977 - _e489.member.member.y);
                                    let _e979 = (_e976 + 1.01f);
                                    let _e980 = (_e979 - _e489.member.member.y);
                                    if (abs(_e943) < 0.000001f) {
                                        if (_e978 <= 0f) {
                                            let _e984 = (_e980 >= 0f);
                                            if _e984 {
                                                phi_2326_ = type_22(0f, 1f);
                                            } else {
                                                phi_2326_ = type_22();
                                            }
                                            let _e986 = phi_2326_;
                                            phi_2330_ = _e986;
                                            phi_2331_ = select(true, false, _e984);
                                        } else {
                                            phi_2330_ = type_22();
                                            phi_2331_ = true;
                                        }
                                        let _e989 = phi_2330_;
                                        let _e991 = phi_2331_;
                                        if _e991 {
                                            phi_2336_ = type_22(1f, 0f);
                                        } else {
                                            phi_2336_ = _e989;
                                        }
                                        let _e993 = phi_2336_;
                                        phi_2352_ = _e993;
                                    } else {
                                        let _e994 = (_e978 / _e943);
                                        let _e995 = (_e980 / _e943);
                                        phi_2352_ = type_22(select(_e995, _e994, (_e994 < _e995)), select(_e995, _e994, (_e994 > _e995)));
                                    }
                                    let _e1002 = phi_2352_;
                                    let _e1006 = select(_e1002.member, _e973.member, (_e973.member > _e1002.member));
                                    let _e1008 = select(0f, _e1006, (_e1006 > 0f));
                                    let _e1010 = select(_e1002.member_1, _e973.member_1, (_e973.member_1 < _e1002.member_1));
                                    let _e1012 = select(1f, _e1010, (_e1010 < 1f));
                                    if (_e1008 > _e1012) {
                                        phi_2400_ = type_22(_e489.member.member_5.z, -2f);
                                    } else {
                                        let _e1017 = (_e489.member.member.z + (_e946 * _e1008));
                                        let _e1019 = (_e489.member.member.z + (_e946 * _e1012));
                                        phi_2400_ = type_22(select(_e1019, _e1017, (_e1017 < _e1019)), select(_e1019, _e1017, (_e1017 > _e1019)));
                                    }
                                    let _e1026 = phi_2400_;
                                    let _e1030 = (_e489.member.member_2.x - _e489.member.member_1.x);
                                    let _e1032 = (_e489.member.member_2.y - _e489.member.member_1.y);
                                    let _e1034 = (_e489.member.member_2.z - _e489.member.member_1.z);
                                    let _e1035 = (_e948 - _e489.member.member_1.x);
                                    let _e1036 = (_e950 - _e489.member.member_1.x);
                                    if (abs(_e1030) < 0.000001f) {
                                        if (_e1035 <= 0f) {
                                            let _e1040 = (_e1036 >= 0f);
                                            if _e1040 {
                                                phi_2434_ = type_22(0f, 1f);
                                            } else {
                                                phi_2434_ = type_22();
                                            }
                                            let _e1042 = phi_2434_;
                                            phi_2438_ = _e1042;
                                            phi_2439_ = select(true, false, _e1040);
                                        } else {
                                            phi_2438_ = type_22();
                                            phi_2439_ = true;
                                        }
                                        let _e1045 = phi_2438_;
                                        let _e1047 = phi_2439_;
                                        if _e1047 {
                                            phi_2444_ = type_22(1f, 0f);
                                        } else {
                                            phi_2444_ = _e1045;
                                        }
                                        let _e1049 = phi_2444_;
                                        phi_2460_ = _e1049;
                                    } else {
                                        let _e1050 = (_e1035 / _e1030);
                                        let _e1051 = (_e1036 / _e1030);
                                        phi_2460_ = type_22(select(_e1051, _e1050, (_e1050 < _e1051)), select(_e1051, _e1050, (_e1050 > _e1051)));
                                    }
                                    let _e1058 = phi_2460_;
                                    let _e1061 = (_e977 - _e489.member.member_1.y);
                                    let _e1062 = (_e979 - _e489.member.member_1.y);
                                    if (abs(_e1032) < 0.000001f) {
                                        if (_e1061 <= 0f) {
                                            let _e1066 = (_e1062 >= 0f);
                                            if _e1066 {
                                                phi_2481_ = type_22(0f, 1f);
                                            } else {
                                                phi_2481_ = type_22();
                                            }
                                            let _e1068 = phi_2481_;
                                            phi_2485_ = _e1068;
                                            phi_2486_ = select(true, false, _e1066);
                                        } else {
                                            phi_2485_ = type_22();
                                            phi_2486_ = true;
                                        }
                                        let _e1071 = phi_2485_;
                                        let _e1073 = phi_2486_;
                                        if _e1073 {
                                            phi_2491_ = type_22(1f, 0f);
                                        } else {
                                            phi_2491_ = _e1071;
                                        }
                                        let _e1075 = phi_2491_;
                                        phi_2507_ = _e1075;
                                    } else {
                                        let _e1076 = (_e1061 / _e1032);
                                        let _e1077 = (_e1062 / _e1032);
                                        phi_2507_ = type_22(select(_e1077, _e1076, (_e1076 < _e1077)), select(_e1077, _e1076, (_e1076 > _e1077)));
                                    }
                                    let _e1084 = phi_2507_;
                                    let _e1088 = select(_e1084.member, _e1058.member, (_e1058.member > _e1084.member));
                                    let _e1090 = select(0f, _e1088, (_e1088 > 0f));
                                    let _e1092 = select(_e1084.member_1, _e1058.member_1, (_e1058.member_1 < _e1084.member_1));
                                    let _e1094 = select(1f, _e1092, (_e1092 < 1f));
                                    if (_e1090 > _e1094) {
                                        phi_2555_ = type_22(_e489.member.member_5.z, -2f);
                                    } else {
                                        let _e1099 = (_e489.member.member_1.z + (_e1034 * _e1090));
                                        let _e1101 = (_e489.member.member_1.z + (_e1034 * _e1094));
                                        phi_2555_ = type_22(select(_e1101, _e1099, (_e1099 < _e1101)), select(_e1101, _e1099, (_e1099 > _e1101)));
                                    }
                                    let _e1108 = phi_2555_;
                                    let _e1111 = (_e489.member.member.x - _e489.member.member_2.x);
                                    let _e1112 = (_e489.member.member.y - _e489.member.member_2.y);
                                    let _e1113 = (_e489.member.member.z - _e489.member.member_2.z);
                                    let _e1114 = (_e948 - _e489.member.member_2.x);
                                    let _e1115 = (_e950 - _e489.member.member_2.x);
                                    if (abs(_e1111) < 0.000001f) {
                                        if (_e1114 <= 0f) {
                                            let _e1119 = (_e1115 >= 0f);
                                            if _e1119 {
                                                phi_2589_ = type_22(0f, 1f);
                                            } else {
                                                phi_2589_ = type_22();
                                            }
                                            let _e1121 = phi_2589_;
                                            phi_2593_ = _e1121;
                                            phi_2594_ = select(true, false, _e1119);
                                        } else {
                                            phi_2593_ = type_22();
                                            phi_2594_ = true;
                                        }
                                        let _e1124 = phi_2593_;
                                        let _e1126 = phi_2594_;
                                        if _e1126 {
                                            phi_2599_ = type_22(1f, 0f);
                                        } else {
                                            phi_2599_ = _e1124;
                                        }
                                        let _e1128 = phi_2599_;
                                        phi_2615_ = _e1128;
                                    } else {
                                        let _e1129 = (_e1114 / _e1111);
                                        let _e1130 = (_e1115 / _e1111);
                                        phi_2615_ = type_22(select(_e1130, _e1129, (_e1129 < _e1130)), select(_e1130, _e1129, (_e1129 > _e1130)));
                                    }
                                    let _e1137 = phi_2615_;
                                    let _e1140 = (_e977 - _e489.member.member_2.y);
                                    let _e1141 = (_e979 - _e489.member.member_2.y);
                                    if (abs(_e1112) < 0.000001f) {
                                        if (_e1140 <= 0f) {
                                            let _e1145 = (_e1141 >= 0f);
                                            if _e1145 {
                                                phi_2636_ = type_22(0f, 1f);
                                            } else {
                                                phi_2636_ = type_22();
                                            }
                                            let _e1147 = phi_2636_;
                                            phi_2640_ = _e1147;
                                            phi_2641_ = select(true, false, _e1145);
                                        } else {
                                            phi_2640_ = type_22();
                                            phi_2641_ = true;
                                        }
                                        let _e1150 = phi_2640_;
                                        let _e1152 = phi_2641_;
                                        if _e1152 {
                                            phi_2646_ = type_22(1f, 0f);
                                        } else {
                                            phi_2646_ = _e1150;
                                        }
                                        let _e1154 = phi_2646_;
                                        phi_2662_ = _e1154;
                                    } else {
                                        let _e1155 = (_e1140 / _e1112);
                                        let _e1156 = (_e1141 / _e1112);
                                        phi_2662_ = type_22(select(_e1156, _e1155, (_e1155 < _e1156)), select(_e1156, _e1155, (_e1155 > _e1156)));
                                    }
                                    let _e1163 = phi_2662_;
                                    let _e1167 = select(_e1163.member, _e1137.member, (_e1137.member > _e1163.member));
                                    let _e1169 = select(0f, _e1167, (_e1167 > 0f));
                                    let _e1171 = select(_e1163.member_1, _e1137.member_1, (_e1137.member_1 < _e1163.member_1));
                                    let _e1173 = select(1f, _e1171, (_e1171 < 1f));
                                    if (_e1169 > _e1173) {
                                        phi_2710_ = type_22(_e489.member.member_5.z, -2f);
                                    } else {
                                        let _e1178 = (_e489.member.member_2.z + (_e1113 * _e1169));
                                        let _e1180 = (_e489.member.member_2.z + (_e1113 * _e1173));
                                        phi_2710_ = type_22(select(_e1180, _e1178, (_e1178 < _e1180)), select(_e1180, _e1178, (_e1178 > _e1180)));
                                    }
                                    let _e1187 = phi_2710_;
                                    let _e1191 = select(_e1108.member, _e1026.member, (_e1026.member < _e1108.member));
                                    let _e1197 = select(_e1108.member_1, _e1026.member_1, (_e1026.member_1 > _e1108.member_1));
                                    phi_1443_ = type_22((floor(select(_e1187.member, _e1191, (_e1191 < _e1187.member))) - 1f), (floor(select(_e1187.member_1, _e1197, (_e1197 > _e1187.member_1))) + 1f));
                                } else {
                                    if (_e489.member.member_4 == 0u) {
                                        phi_1401_ = vec3<f32>(_e489.member.member_3.y, _e489.member.member_3.z, _e489.member.member_3.x);
                                    } else {
                                        if (_e489.member.member_4 == 1u) {
                                            phi_1400_ = vec3<f32>(_e489.member.member_3.z, _e489.member.member_3.x, _e489.member.member_3.y);
                                        } else {
                                            phi_1400_ = _e489.member.member_3;
                                        }
                                        let _e1214 = phi_1400_;
                                        phi_1401_ = _e1214;
                                    }
                                    let _e1216 = phi_1401_;
                                    let _e1233 = (_e489.member.member.z - (((_e1216.x * ((f32(_e937) + 0.5f) - _e489.member.member.x)) + (_e1216.y * ((f32(_e936) + 0.5f) - _e489.member.member.y))) / _e1216.z));
                                    let _e1240 = (((0.5f * (abs(_e1216.x) + abs(_e1216.y))) / abs(_e1216.z)) + 0.3f);
                                    phi_1443_ = type_22((-1f - floor((_e1240 - _e1233))), floor((_e1233 + _e1240)));
                                }
                                let _e1248 = phi_1443_;
                                let _e1251 = f32(_e489.member_4);
                                let _e1253 = select(_e1251, _e1248.member, (_e1248.member > _e1251));
                                let _e1262 = f32(_e489.member_5);
                                let _e1264 = select(_e1262, _e1248.member_1, (_e1248.member_1 < _e1262));
                                phi_3397_ = select(0i, select(select(i32(_e1264), i32(-2147483648), (_e1264 < -2147483600f)), 2147483647i, (_e1264 > 2147483500f)), (_e1264 == _e1264));
                                phi_3104_ = (select(0i, select(select(i32(_e1253), i32(-2147483648), (_e1253 < -2147483600f)), 2147483647i, (_e1253 > 2147483500f)), (_e1253 == _e1253)) - 1i);
                                phi_3080_ = _e936;
                                phi_3050_ = _e937;
                            } else {
                                phi_3397_ = _e518;
                                let _e1520 = local_15;
                                phi_3104_ = _e1520;
                                phi_3080_ = _e522;
                                phi_3050_ = _e516;
                            }
                            let _e1273 = phi_3397_;
                            let _e1275 = phi_3104_;
                            let _e1277 = phi_3080_;
                            let _e1279 = phi_3050_;
                            phi_3396_ = _e1273;
                            phi_3103_ = _e1275;
                            phi_3079_ = _e1277;
                            phi_3049_ = _e1279;
                            let _e1529 = local_16;
                            phi_1483_ = _e1529;
                        } else {
                            phi_3396_ = _e518;
                            phi_3103_ = _e520;
                            phi_3079_ = _e522;
                            phi_3049_ = _e516;
                            phi_1483_ = false;
                        }
                        let _e1281 = phi_3396_;
                        let _e1283 = phi_3103_;
                        let _e1285 = phi_3079_;
                        let _e1287 = phi_3049_;
                        let _e1289 = phi_1483_;
                        local_11 = _e1287;
                        local_12 = _e1281;
                        local_13 = _e1283;
                        local_14 = _e1285;
                        local_7 = select(true, false, _e523);
                        local_8 = _e1287;
                        local_9 = _e1285;
                        local_10 = _e1283;
                        continue;
                        continuing {
                            phi_2814_ = _e1287;
                            phi_2811_ = _e1281;
                            phi_2808_ = _e1283;
                            phi_2805_ = _e1285;
                            break if !(_e1289);
                        }
                    }
                    let _e1293 = local_7;
                    let _e1295 = select(false, true, select(true, false, _e1293));
                    if _e1295 {
                        let _e1297 = local_8;
                        let _e1298 = f32(_e1297);
                        let _e1300 = local_9;
                        let _e1301 = f32(_e1300);
                        let _e1303 = local_10;
                        let _e1304 = f32(_e1303);
                        if (_e489.member.member_4 == 2u) {
                            phi_1513_ = 2u;
                        } else {
                            phi_1513_ = (1u - _e489.member.member_4);
                        }
                        let _e1309 = phi_1513_;
                        if (_e1309 == 0u) {
                            phi_1525_ = vec3<f32>(_e1301, _e1304, _e1298);
                        } else {
                            if (_e1309 == 1u) {
                                phi_1524_ = vec3<f32>(_e1304, _e1298, _e1301);
                            } else {
                                phi_1524_ = vec3<f32>(_e1298, _e1301, _e1304);
                            }
                            let _e1315 = phi_1524_;
                            phi_1525_ = _e1315;
                        }
                        let _e1317 = phi_1525_;
                        let _e1323 = select(select(u32(_e1317.x), 0u, (_e1317.x < 0f)), 4294967295u, (_e1317.x > 4294967000f));
                        let _e1329 = select(select(u32(_e1317.y), 0u, (_e1317.y < 0f)), 4294967295u, (_e1317.y > 4294967000f));
                        let _e1335 = select(select(u32(_e1317.z), 0u, (_e1317.z < 0f)), 4294967295u, (_e1317.z > 4294967000f));
                        let _e1339 = params.member.member_2[0u];
                        let _e1372 = (((((_e1339.z + (_e1323 >> bitcast<u32>(2i))) + (_e1339.x * (_e1329 >> bitcast<u32>(2i)))) + (_e1339.y * (_e1335 >> bitcast<u32>(1i)))) * 6u) + ((2u * _e292) + select(0u, 1u, (_e297 < 0f))));
                        if (_e1372 < arrayLength((&facet_bits.member))) {
                        } else {
                            phi_3177_ = true;
                            break;
                        }
                        let _e1379 = atomicOr((&facet_bits.member[_e1372]), (1u << bitcast<u32>(((((((_e1323 & 1u) | ((_e1329 & 1u) << bitcast<u32>(1i))) | ((_e1335 & 1u) << bitcast<u32>(2i))) | ((_e1323 & 2u) << bitcast<u32>(2i))) | ((_e1329 & 2u) << bitcast<u32>(3i))) & 31u))));
                    }
                    continue;
                    continuing {
                        let _e1417 = local_11;
                        phi_2815_ = _e1417;
                        let _e1420 = local_12;
                        phi_2812_ = _e1420;
                        let _e1423 = local_13;
                        phi_2809_ = _e1423;
                        let _e1426 = local_14;
                        phi_2806_ = _e1426;
                        phi_3177_ = _e88;
                        break if !(_e1295);
                    }
                }
                let _e1382 = phi_3177_;
                if _e1382 {
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
