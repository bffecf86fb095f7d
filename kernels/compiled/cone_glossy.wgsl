struct type_9 {
    member: array<u32>,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
    member_8: array<f32, 3>,
    member_9: f32,
}

struct type_29 {
    member: array<vec4<f32>>,
}

struct type_33 {
    member: array<type_25>,
}

struct type_37 {
    member: vec4<f32>,
    member_1: vec4<u32>,
    member_2: array<vec4<u32>, 10>,
    member_3: array<vec4<f32>, 16>,
    member_4: array<vec4<f32>, 16>,
    member_5: vec4<f32>,
    member_6: vec4<f32>,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: f32,
}

struct type_38 {
    member: type_37,
}

struct type_40 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: i32,
    member_4: f32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_38;
@group(0) @binding(1) 
var<storage> cells: type_9;
@group(0) @binding(2) 
var<storage> facet_bits: type_9;
@group(0) @binding(3) 
var<storage> facets: type_19;
@group(0) @binding(4) 
var<storage> radiance: type_29;
@group(0) @binding(5) 
var<storage> odd: type_29;
@group(0) @binding(6) 
var<storage> even: type_29;
@group(0) @binding(7) 
var<storage> surfels: type_33;
@group(0) @binding(8) 
var<storage, read_write> out: type_29;

fn function_() {
    var phi_182_: vec3<f32>;
    var phi_272_: bool;
    var phi_281_: u32;
    var phi_297_: i32;
    var phi_326_: f32;
    var phi_343_: i32;
    var phi_372_: f32;
    var phi_389_: i32;
    var phi_418_: f32;
    var phi_421_: vec3<f32>;
    var phi_424_: type_40;
    var phi_426_: type_40;
    var phi_428_: type_40;
    var phi_430_: u32;
    var phi_432_: f32;
    var phi_434_: f32;
    var phi_460_: u32;
    var phi_482_: i32;
    var phi_483_: u32;
    var phi_484_: f32;
    var phi_485_: f32;
    var phi_486_: i32;
    var phi_487_: u32;
    var phi_488_: f32;
    var phi_537_: u32;
    var phi_552_: f32;
    var phi_634_: f32;
    var phi_645_: f32;
    var phi_728_: f32;
    var phi_739_: f32;
    var phi_822_: f32;
    var phi_849_: f32;
    var phi_850_: f32;
    var phi_851_: u32;
    var phi_852_: u32;
    var phi_853_: u32;
    var phi_854_: u32;
    var phi_855_: f32;
    var phi_856_: f32;
    var phi_857_: u32;
    var phi_858_: u32;
    var phi_859_: u32;
    var phi_860_: u32;
    var phi_861_: u32;
    var phi_862_: u32;
    var phi_864_: vec4<f32>;
    var phi_867_: u32;
    var phi_1254_: u32;
    var phi_1266_: vec4<f32>;
    var phi_1120_: vec4<f32>;
    var phi_1123_: vec4<f32>;
    var phi_1125_: u32;
    var phi_1195_: vec4<f32>;
    var phi_1196_: vec4<f32>;
    var phi_1121_: vec4<f32>;
    var phi_1124_: vec4<f32>;
    var phi_1126_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1219_: vec4<f32>;
    var phi_1021_: vec4<f32>;
    var phi_1024_: u32;
    var phi_1022_: vec4<f32>;
    var phi_1025_: u32;
    var phi_1220_: vec4<f32>;
    var phi_1234_: vec4<f32>;
    var phi_1267_: vec4<f32>;
    var phi_1288_: vec4<f32>;
    var phi_865_: vec4<f32>;
    var phi_868_: u32;
    var phi_1290_: vec4<f32>;
    var phi_1330_: vec3<f32>;
    var phi_1331_: f32;
    var phi_1332_: f32;
    var phi_1517_: i32;
    var phi_1530_: type_40;
    var phi_1570_: f32;
    var phi_1448_: i32;
    var phi_1461_: type_40;
    var phi_1501_: f32;
    var phi_1572_: type_40;
    var phi_1573_: type_40;
    var phi_1375_: i32;
    var phi_1388_: type_40;
    var phi_1428_: f32;
    var phi_1574_: type_40;
    var phi_1575_: type_40;
    var phi_1576_: type_40;
    var phi_1577_: vec3<f32>;
    var phi_1578_: type_40;
    var phi_1579_: type_40;
    var phi_1580_: type_40;
    var phi_1581_: f32;
    var phi_1582_: f32;
    var phi_422_: vec3<f32>;
    var phi_425_: type_40;
    var phi_427_: type_40;
    var phi_429_: type_40;
    var phi_431_: u32;
    var phi_433_: f32;
    var phi_435_: f32;
    var phi_1584_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var phi_1606_: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e51 = gid_1;
            let _e63 = (_e51.x + (_e51.y * 2097152u));
            let _e64 = (_e63 < arrayLength((&out.member)));
            if _e64 {
                let _e68 = surfels.member[_e63].member_1;
                if (_e68 == 4294967295u) {
                    phi_1606_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e73 = surfels.member[_e63].member;
                    let _e79 = params.member.member_6;
                    let _e83 = (_e79.x - _e73[0]);
                    let _e84 = (_e79.y - _e73[1]);
                    let _e85 = (_e79.z - _e73[2]);
                    let _e90 = (((_e83 * _e83) + (_e84 * _e84)) + (_e85 * _e85));
                    if (_e90 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e93 = (1f / sqrt(_e90));
                        phi_182_ = vec3<f32>((_e83 * _e93), (_e84 * _e93), (_e85 * _e93));
                    } else {
                        phi_182_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e99 = phi_182_;
                    let _e103 = surfels.member[_e63].member_2;
                    let _e115 = (2f * (((_e99.x * _e103[0]) + (_e99.y * _e103[1])) + (_e99.z * _e103[2])));
                    let _e119 = ((_e103[0] * _e115) - _e99.x);
                    let _e120 = ((_e103[1] * _e115) - _e99.y);
                    let _e121 = ((_e103[2] * _e115) - _e99.z);
                    let _e124 = params.member.member;
                    let _e138 = surfels.member[_e63].member_4;
                    let _e144 = params.member.member_12;
                    let _e148 = (((_e73[0] - _e124.x) / _e124.w) + (_e138[0] * _e144));
                    let _e149 = (((_e73[1] - _e124.y) / _e124.w) + (_e138[1] * _e144));
                    let _e150 = (((_e73[2] - _e124.z) / _e124.w) + (_e138[2] * _e144));
                    let _e154 = params.member.member_6[3u];
                    let _e158 = params.member.member_13;
                    let _e164 = (((_e119 * _e138[0]) + (_e120 * _e138[1])) + (_e121 * _e138[2]));
                    let _e170 = params.member.member_1;
                    let _e171 = abs(_e119);
                    let _e172 = abs(_e120);
                    let _e173 = abs(_e121);
                    if (_e171 >= _e172) {
                        phi_272_ = select(true, false, (_e171 >= _e173));
                    } else {
                        phi_272_ = true;
                    }
                    let _e178 = phi_272_;
                    if _e178 {
                        phi_281_ = select(2u, 1u, (_e172 >= _e173));
                    } else {
                        phi_281_ = 0u;
                    }
                    let _e182 = phi_281_;
                    let _e191 = (_e119 < 0f);
                    if _e191 {
                        phi_297_ = (i32(-(floor((0.5f - _e148)))) - 1i);
                    } else {
                        phi_297_ = (i32(floor((_e148 - 0.5f))) + 1i);
                    }
                    let _e195 = phi_297_;
                    if (((_e191 && (_e195 < 0i)) || ((_e119 >= 0f) && (_e195 >= bitcast<i32>(_e170.x)))) || (_e171 < 0.000001f)) {
                        phi_326_ = 340282350000000000000000000000000000000f;
                    } else {
                        phi_326_ = (((f32(_e195) + 0.5f) - _e148) / _e119);
                    }
                    let _e210 = phi_326_;
                    let _e220 = (_e120 < 0f);
                    if _e220 {
                        phi_343_ = (i32(-(floor((0.5f - _e149)))) - 1i);
                    } else {
                        phi_343_ = (i32(floor((_e149 - 0.5f))) + 1i);
                    }
                    let _e224 = phi_343_;
                    if (((_e220 && (_e224 < 0i)) || ((_e120 >= 0f) && (_e224 >= bitcast<i32>(_e170.y)))) || (_e172 < 0.000001f)) {
                        phi_372_ = 340282350000000000000000000000000000000f;
                    } else {
                        phi_372_ = (((f32(_e224) + 0.5f) - _e149) / _e120);
                    }
                    let _e239 = phi_372_;
                    let _e249 = (_e121 < 0f);
                    if _e249 {
                        phi_389_ = (i32(-(floor((0.5f - _e150)))) - 1i);
                    } else {
                        phi_389_ = (i32(floor((_e150 - 0.5f))) + 1i);
                    }
                    let _e253 = phi_389_;
                    if (((_e249 && (_e253 < 0i)) || ((_e121 >= 0f) && (_e253 >= bitcast<i32>(_e170.z)))) || (_e173 < 0.000001f)) {
                        phi_418_ = 340282350000000000000000000000000000000f;
                    } else {
                        phi_418_ = (((f32(_e253) + 0.5f) - _e150) / _e121);
                    }
                    let _e268 = phi_418_;
                    phi_421_ = vec3<f32>(0f, 0f, 0f);
                    phi_424_ = type_40(_e150, _e121, 0u, _e253, _e268);
                    phi_426_ = type_40(_e149, _e120, 0u, _e224, _e239);
                    phi_428_ = type_40(_e148, _e119, 0u, _e195, _e210);
                    phi_430_ = 0u;
                    phi_432_ = 0f;
                    phi_434_ = 1f;
                    loop {
                        let _e271 = phi_421_;
                        let _e273 = phi_424_;
                        let _e275 = phi_426_;
                        let _e277 = phi_428_;
                        let _e279 = phi_430_;
                        let _e281 = phi_432_;
                        let _e283 = phi_434_;
                        local_6 = _e281;
                        local_7 = _e283;
                        local_8 = _e271;
                        local_9 = _e271;
                        local_10 = _e271;
                        if (_e279 < 2048u) {
                            if ((_e277.member_4 <= _e275.member_4) && (_e277.member_4 <= _e273.member_4)) {
                                phi_460_ = 0u;
                            } else {
                                phi_460_ = select(2u, 1u, (_e275.member_4 <= _e273.member_4));
                            }
                            let _e295 = phi_460_;
                            let _e296 = (_e295 == 0u);
                            if _e296 {
                                phi_485_ = _e277.member_4;
                                phi_486_ = _e277.member_3;
                                phi_487_ = _e277.member_2;
                                phi_488_ = _e277.member_1;
                            } else {
                                let _e297 = (_e295 == 1u);
                                if _e297 {
                                    phi_482_ = _e275.member_3;
                                    phi_483_ = _e275.member_2;
                                    phi_484_ = _e275.member_1;
                                } else {
                                    phi_482_ = _e273.member_3;
                                    phi_483_ = _e273.member_2;
                                    phi_484_ = _e273.member_1;
                                }
                                let _e305 = phi_482_;
                                let _e307 = phi_483_;
                                let _e309 = phi_484_;
                                phi_485_ = select(_e273.member_4, _e275.member_4, _e297);
                                phi_486_ = _e305;
                                phi_487_ = _e307;
                                phi_488_ = _e309;
                            }
                            let _e315 = phi_485_;
                            let _e317 = phi_486_;
                            let _e319 = phi_487_;
                            let _e321 = phi_488_;
                            let _e323 = (1f - _e281);
                            let _e324 = (_e283 * _e323);
                            let _e326 = ((_e315 >= 340282350000000000000000000000000000000f) || (_e324 < 0.001f));
                            if _e326 {
                                phi_1577_ = vec3<f32>();
                                phi_1578_ = type_40();
                                phi_1579_ = type_40();
                                phi_1580_ = type_40();
                                phi_1581_ = f32();
                                phi_1582_ = f32();
                            } else {
                                let _e333 = (_e321 < 0f);
                                let _e337 = params.member.member_2[_e319];
                                let _e338 = (_e319 & 31u);
                                let _e340 = (1u << bitcast<u32>(_e338));
                                let _e341 = (_e340 - 1u);
                                let _e344 = ((_e170.x + _e341) >> bitcast<u32>(_e338));
                                let _e347 = ((_e170.y + _e341) >> bitcast<u32>(_e338));
                                let _e350 = ((_e170.z + _e341) >> bitcast<u32>(_e338));
                                let _e352 = (1f / f32(_e340));
                                if _e296 {
                                    phi_537_ = _e344;
                                } else {
                                    phi_537_ = select(_e350, _e347, (_e295 == 1u));
                                }
                                let _e356 = phi_537_;
                                if ((_e317 < 0i) || (_e317 >= bitcast<i32>(_e356))) {
                                    phi_1290_ = vec4<f32>(0f, 0f, 0f, 0f);
                                } else {
                                    let _e361 = f32(_e317);
                                    if _e296 {
                                        phi_552_ = _e361;
                                    } else {
                                        phi_552_ = (((_e148 + (_e119 * _e315)) * _e352) - 0.5f);
                                    }
                                    let _e365 = phi_552_;
                                    let _e366 = floor(_e365);
                                    let _e368 = i32(_e366);
                                    let _e370 = (bitcast<i32>(_e344) - 1i);
                                    let _e375 = ((_e365 >= -0.5f) && (_e365 <= (f32(_e370) + 0.5f)));
                                    let _e377 = select(0i, _e368, (0i < _e368));
                                    let _e380 = bitcast<u32>(select(_e377, _e370, (_e370 < _e377)));
                                    let _e381 = (_e368 + 1i);
                                    let _e383 = select(0i, _e381, (0i < _e381));
                                    let _e386 = bitcast<u32>(select(_e383, _e370, (_e370 < _e383)));
                                    let _e390 = select(select(0f, (_e365 - _e366), (_e368 < _e370)), 1f, (_e368 < 0i));
                                    let _e392 = (_e380 >> bitcast<u32>(2u));
                                    let _e394 = (_e386 >> bitcast<u32>(2u));
                                    let _e401 = ((_e380 & 1u) | (((_e380 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                    let _e408 = ((_e386 & 1u) | (((_e386 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                    if _e375 {
                                        phi_634_ = (1f - _e390);
                                    } else {
                                        phi_634_ = 0f;
                                    }
                                    let _e411 = phi_634_;
                                    let _e412 = select(0f, _e390, _e375);
                                    let _e413 = (_e295 == 1u);
                                    if _e413 {
                                        phi_645_ = _e361;
                                    } else {
                                        phi_645_ = (((_e149 + (_e120 * _e315)) * _e352) - 0.5f);
                                    }
                                    let _e417 = phi_645_;
                                    let _e419 = floor(_e417);
                                    let _e421 = i32(_e419);
                                    let _e423 = (bitcast<i32>(_e347) - 1i);
                                    let _e428 = ((_e417 >= -0.5f) && (_e417 <= (f32(_e423) + 0.5f)));
                                    let _e430 = select(0i, _e421, (0i < _e421));
                                    let _e433 = bitcast<u32>(select(_e430, _e423, (_e423 < _e430)));
                                    let _e434 = (_e421 + 1i);
                                    let _e436 = select(0i, _e434, (0i < _e434));
                                    let _e439 = bitcast<u32>(select(_e436, _e423, (_e423 < _e436)));
                                    let _e443 = select(select(0f, (_e417 - _e419), (_e421 < _e423)), 1f, (_e421 < 0i));
                                    let _e446 = ((_e433 >> bitcast<u32>(2u)) * _e337.x);
                                    let _e449 = ((_e439 >> bitcast<u32>(2u)) * _e337.x);
                                    let _e458 = (((_e433 & 1u) << bitcast<u32>(1u)) | (((_e433 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                    let _e467 = (((_e439 & 1u) << bitcast<u32>(1u)) | (((_e439 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                    if _e428 {
                                        phi_728_ = (1f - _e443);
                                    } else {
                                        phi_728_ = 0f;
                                    }
                                    let _e470 = phi_728_;
                                    let _e471 = select(0f, _e443, _e428);
                                    let _e472 = (_e295 == 2u);
                                    if _e472 {
                                        phi_739_ = _e361;
                                    } else {
                                        phi_739_ = (((_e150 + (_e121 * _e315)) * _e352) - 0.5f);
                                    }
                                    let _e476 = phi_739_;
                                    let _e478 = floor(_e476);
                                    let _e480 = i32(_e478);
                                    let _e482 = (bitcast<i32>(_e350) - 1i);
                                    let _e487 = ((_e476 >= -0.5f) && (_e476 <= (f32(_e482) + 0.5f)));
                                    let _e489 = select(0i, _e480, (0i < _e480));
                                    let _e492 = bitcast<u32>(select(_e489, _e482, (_e482 < _e489)));
                                    let _e493 = (_e480 + 1i);
                                    let _e495 = select(0i, _e493, (0i < _e493));
                                    let _e498 = bitcast<u32>(select(_e495, _e482, (_e482 < _e495)));
                                    let _e502 = select(select(0f, (_e476 - _e478), (_e480 < _e482)), 1f, (_e480 < 0i));
                                    let _e505 = ((_e492 >> bitcast<u32>(1u)) * _e337.y);
                                    let _e508 = ((_e498 >> bitcast<u32>(1u)) * _e337.y);
                                    let _e511 = ((_e492 & 1u) << bitcast<u32>(2u));
                                    let _e514 = ((_e498 & 1u) << bitcast<u32>(2u));
                                    if _e487 {
                                        phi_822_ = (1f - _e502);
                                    } else {
                                        phi_822_ = 0f;
                                    }
                                    let _e517 = phi_822_;
                                    let _e518 = select(0f, _e502, _e487);
                                    if _e296 {
                                        phi_849_ = _e518;
                                        phi_850_ = _e517;
                                        phi_851_ = _e514;
                                        phi_852_ = _e511;
                                        phi_853_ = _e508;
                                        phi_854_ = _e505;
                                        phi_855_ = _e471;
                                        phi_856_ = _e470;
                                        phi_857_ = _e467;
                                        phi_858_ = _e458;
                                        phi_859_ = _e449;
                                        phi_860_ = _e446;
                                        phi_861_ = _e401;
                                        phi_862_ = _e392;
                                    } else {
                                        phi_849_ = select(_e471, _e412, _e413);
                                        phi_850_ = select(_e470, _e411, _e413);
                                        phi_851_ = select(_e467, _e408, _e413);
                                        phi_852_ = select(_e458, _e401, _e413);
                                        phi_853_ = select(_e449, _e394, _e413);
                                        phi_854_ = select(_e446, _e392, _e413);
                                        phi_855_ = select(_e412, _e518, _e413);
                                        phi_856_ = select(_e411, _e517, _e413);
                                        phi_857_ = select(_e408, _e514, _e413);
                                        phi_858_ = select(_e401, _e511, _e413);
                                        phi_859_ = select(_e394, _e508, _e413);
                                        phi_860_ = select(_e392, _e505, _e413);
                                        phi_861_ = select(_e511, _e458, _e413);
                                        phi_862_ = select(_e505, _e446, _e413);
                                    }
                                    let _e534 = phi_849_;
                                    let _e536 = phi_850_;
                                    let _e538 = phi_851_;
                                    let _e540 = phi_852_;
                                    let _e542 = phi_853_;
                                    let _e544 = phi_854_;
                                    let _e546 = phi_855_;
                                    let _e548 = phi_856_;
                                    let _e550 = phi_857_;
                                    let _e552 = phi_858_;
                                    let _e554 = phi_859_;
                                    let _e556 = phi_860_;
                                    let _e558 = phi_861_;
                                    let _e560 = phi_862_;
                                    phi_864_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    phi_867_ = 0u;
                                    loop {
                                        let _e562 = phi_864_;
                                        let _e564 = phi_867_;
                                        local_13 = _e562;
                                        let _e565 = (_e564 < 4u);
                                        if _e565 {
                                            let _e567 = ((_e564 & 1u) == 1u);
                                            let _e569 = ((_e564 & 2u) == 2u);
                                            let _e572 = (select(_e548, _e546, _e567) * select(_e536, _e534, _e569));
                                            let _e578 = (((_e337.z + _e560) + select(_e556, _e554, _e567)) + select(_e544, _e542, _e569));
                                            let _e583 = (2u * _e578);
                                            let _e585 = cells.member[_e583];
                                            let _e587 = (((_e558 | select(_e552, _e550, _e567)) | select(_e540, _e538, _e569)) & 31u);
                                            if ((_e572 > 0f) && (((_e585 >> bitcast<u32>(_e587)) & 1u) == 1u)) {
                                                let _e595 = params.member.member_8;
                                                let _e596 = (_e595 == 1u);
                                                if (_e319 == 0u) {
                                                    let _e622 = (_e578 * 6u);
                                                    let _e625 = cells.member[(_e583 + 1u)];
                                                    let _e627 = facet_bits.member[_e622];
                                                    let _e630 = ((1u << bitcast<u32>(_e587)) - 1u);
                                                    let _e639 = facet_bits.member[(_e622 + 1u)];
                                                    let _e649 = facet_bits.member[(_e622 + 2u)];
                                                    let _e659 = facet_bits.member[(_e622 + 3u)];
                                                    let _e669 = facet_bits.member[(_e622 + 4u)];
                                                    let _e679 = facet_bits.member[(_e622 + 5u)];
                                                    let _e682 = ((((((_e625 + countOneBits((_e627 & _e630))) + countOneBits((_e639 & _e630))) + countOneBits((_e649 & _e630))) + countOneBits((_e659 & _e630))) + countOneBits((_e669 & _e630))) + countOneBits((_e679 & _e630)));
                                                    let _e686 = (((((((_e627 >> bitcast<u32>(_e587)) & 1u) + ((_e639 >> bitcast<u32>(_e587)) & 1u)) + ((_e649 >> bitcast<u32>(_e587)) & 1u)) + ((_e659 >> bitcast<u32>(_e587)) & 1u)) + ((_e669 >> bitcast<u32>(_e587)) & 1u)) + ((_e679 >> bitcast<u32>(_e587)) & 1u));
                                                    if _e596 {
                                                        phi_1021_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                        phi_1024_ = _e682;
                                                        loop {
                                                            let _e789 = phi_1021_;
                                                            let _e791 = phi_1024_;
                                                            local_12 = _e789;
                                                            let _e793 = (_e791 < (_e682 + _e686));
                                                            if _e793 {
                                                                let _e794 = (2u * _e791);
                                                                let _e797 = radiance.member[_e794][0u];
                                                                let _e800 = radiance.member[_e794][1u];
                                                                let _e803 = radiance.member[_e794][2u];
                                                                let _e804 = (_e794 + 1u);
                                                                let _e807 = radiance.member[_e804][0u];
                                                                let _e810 = radiance.member[_e804][1u];
                                                                let _e813 = radiance.member[_e804][2u];
                                                                let _e822 = facets.member[_e791].member_2;
                                                                let _e831 = sqrt((((_e822[0] * _e822[0]) + (_e822[1] * _e822[1])) + (_e822[2] * _e822[2])));
                                                                phi_1022_ = vec4<f32>((_e789.x + (select(_e807, _e797, (_e797 > _e807)) * _e831)), (_e789.y + (select(_e810, _e800, (_e800 > _e810)) * _e831)), (_e789.z + (select(_e813, _e803, (_e803 > _e813)) * _e831)), (_e789.w + _e831));
                                                                phi_1025_ = (_e791 + 1u);
                                                            } else {
                                                                phi_1022_ = vec4<f32>();
                                                                phi_1025_ = u32();
                                                            }
                                                            let _e846 = phi_1022_;
                                                            let _e848 = phi_1025_;
                                                            continue;
                                                            continuing {
                                                                phi_1021_ = _e846;
                                                                phi_1024_ = _e848;
                                                                break if !(_e793);
                                                            }
                                                        }
                                                        let _e1298 = local_12;
                                                        phi_1220_ = _e1298;
                                                    } else {
                                                        let _e687 = select(1f, -1f, _e333);
                                                        phi_1120_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                        phi_1123_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                        phi_1125_ = _e682;
                                                        loop {
                                                            let _e692 = phi_1120_;
                                                            let _e694 = phi_1123_;
                                                            let _e696 = phi_1125_;
                                                            local = _e692;
                                                            local_1 = _e694;
                                                            local_2 = _e692;
                                                            local_3 = _e692;
                                                            local_4 = _e692;
                                                            local_5 = _e694;
                                                            local_11 = _e694;
                                                            let _e698 = (_e696 < (_e682 + _e686));
                                                            if _e698 {
                                                                let _e701 = facets.member[_e696].member_2;
                                                                let _e710 = -((((select(0f, _e687, _e296) * _e701[0]) + (select(0f, _e687, _e413) * _e701[1])) + (select(0f, _e687, _e472) * _e701[2])));
                                                                if (_e710 > 0f) {
                                                                    let _e733 = radiance.member[(2u * _e696)];
                                                                    phi_1195_ = _e692;
                                                                    phi_1196_ = vec4<f32>((_e694.x + (_e733.x * _e710)), (_e694.y + (_e733.y * _e710)), (_e694.z + (_e733.z * _e710)), (_e694.w + _e710));
                                                                } else {
                                                                    let _e715 = radiance.member[((2u * _e696) + 1u)];
                                                                    phi_1195_ = vec4<f32>((_e692.x - (_e715.x * _e710)), (_e692.y - (_e715.y * _e710)), (_e692.z - (_e715.z * _e710)), (_e692.w - _e710));
                                                                    phi_1196_ = _e694;
                                                                }
                                                                let _e750 = phi_1195_;
                                                                let _e752 = phi_1196_;
                                                                phi_1121_ = _e750;
                                                                phi_1124_ = _e752;
                                                                phi_1126_ = (_e696 + 1u);
                                                            } else {
                                                                phi_1121_ = vec4<f32>();
                                                                phi_1124_ = vec4<f32>();
                                                                phi_1126_ = u32();
                                                            }
                                                            let _e755 = phi_1121_;
                                                            let _e757 = phi_1124_;
                                                            let _e759 = phi_1126_;
                                                            continue;
                                                            continuing {
                                                                phi_1120_ = _e755;
                                                                phi_1123_ = _e757;
                                                                phi_1125_ = _e759;
                                                                break if !(_e698);
                                                            }
                                                        }
                                                        let _e762 = local;
                                                        let _e765 = local_1;
                                                        if (_e762.w > _e765.w) {
                                                            let _e768 = (_e762.w - _e765.w);
                                                            let _e769 = (_e768 / _e762.w);
                                                            let _e771 = local_2;
                                                            let _e775 = local_3;
                                                            let _e779 = local_4;
                                                            let _e784 = local_5;
                                                            phi_1219_ = (_e784 + vec4<f32>((_e771.x * _e769), (_e775.y * _e769), (_e779.z * _e769), _e768));
                                                        } else {
                                                            let _e1291 = local_11;
                                                            phi_1219_ = _e1291;
                                                        }
                                                        let _e787 = phi_1219_;
                                                        phi_1220_ = _e787;
                                                    }
                                                    let _e851 = phi_1220_;
                                                    if (_e851.w > 1f) {
                                                        phi_1234_ = vec4<f32>((_e851.x / _e851.w), (_e851.y / _e851.w), (_e851.z / _e851.w), 1f);
                                                    } else {
                                                        phi_1234_ = _e851;
                                                    }
                                                    let _e862 = phi_1234_;
                                                    phi_1267_ = _e862;
                                                } else {
                                                    let _e600 = cells.member[(_e583 + 1u)];
                                                    let _e606 = (_e600 + countOneBits((_e585 & ((1u << bitcast<u32>(_e587)) - 1u))));
                                                    if _e596 {
                                                        phi_1254_ = _e606;
                                                    } else {
                                                        phi_1254_ = (((6u * _e606) + (2u * _e295)) + select(0u, 1u, _e333));
                                                    }
                                                    let _e613 = phi_1254_;
                                                    if ((_e319 & 1u) == 1u) {
                                                        let _e619 = odd.member[_e613];
                                                        phi_1266_ = _e619;
                                                    } else {
                                                        let _e617 = even.member[_e613];
                                                        phi_1266_ = _e617;
                                                    }
                                                    let _e621 = phi_1266_;
                                                    phi_1267_ = _e621;
                                                }
                                                let _e864 = phi_1267_;
                                                phi_1288_ = vec4<f32>((_e562.x + (_e864.x * _e572)), (_e562.y + (_e864.y * _e572)), (_e562.z + (_e864.z * _e572)), (_e562.w + (_e864.w * _e572)));
                                            } else {
                                                phi_1288_ = _e562;
                                            }
                                            let _e883 = phi_1288_;
                                            phi_865_ = _e883;
                                            phi_868_ = (_e564 + 1u);
                                        } else {
                                            phi_865_ = vec4<f32>();
                                            phi_868_ = u32();
                                        }
                                        let _e886 = phi_865_;
                                        let _e888 = phi_868_;
                                        continue;
                                        continuing {
                                            phi_864_ = _e886;
                                            phi_867_ = _e888;
                                            break if !(_e565);
                                        }
                                    }
                                    let _e1306 = local_13;
                                    phi_1290_ = _e1306;
                                }
                                let _e891 = phi_1290_;
                                if (_e891.w > 0f) {
                                    let _e898 = select(_e323, _e891.w, (_e891.w < _e323));
                                    let _e903 = ((_e283 * _e898) / _e891.w);
                                    phi_1330_ = vec3<f32>((_e271.x + (_e891.x * _e903)), (_e271.y + (_e891.y * _e903)), (_e271.z + (_e891.z * _e903)));
                                    phi_1331_ = (_e281 + _e898);
                                    phi_1332_ = _e283;
                                } else {
                                    let _e894 = (_e295 == _e182);
                                    phi_1330_ = _e271;
                                    phi_1331_ = select(_e281, 0f, _e894);
                                    phi_1332_ = select(_e283, _e324, _e894);
                                }
                                let _e916 = phi_1330_;
                                let _e918 = phi_1331_;
                                let _e920 = phi_1332_;
                                let _e921 = ((2f * _e154) * _e315);
                                let _e923 = ((_e158 * _e144) + ((_e158 * select(0f, _e164, (_e164 > 0f))) * _e315));
                                let _e925 = select(_e923, _e921, (_e921 < _e923));
                                let _e932 = ((bitcast<u32>((select(1f, _e925, (_e925 > 1f)) * 1.4142135f)) >> bitcast<u32>(23i)) - 127u);
                                let _e934 = (_e170.w - 1u);
                                let _e936 = select(_e932, _e934, (_e934 < _e932));
                                if _e296 {
                                    let _e1087 = (_e277.member_1 < 0f);
                                    if _e1087 {
                                        phi_1375_ = (_e277.member_3 - 1i);
                                    } else {
                                        phi_1375_ = (_e277.member_3 + 1i);
                                    }
                                    let _e1095 = phi_1375_;
                                    let _e1101 = type_40(_e277.member, _e277.member_1, _e277.member_2, _e1095, _e277.member_4);
                                    if ((((_e277.member_3 & 1i) == 0i) == _e1087) && (_e936 > _e277.member_2)) {
                                        let _e1111 = type_40(_e1101.member, _e1101.member_1, (_e277.member_2 + 1u), _e1101.member_3, _e1101.member_4);
                                        phi_1388_ = type_40(_e1111.member, _e1111.member_1, _e1111.member_2, (_e1095 >> bitcast<u32>(1i)), _e1111.member_4);
                                    } else {
                                        phi_1388_ = _e1101;
                                    }
                                    let _e1121 = phi_1388_;
                                    let _e1123 = (_e1121.member_2 & 31u);
                                    let _e1125 = (1u << bitcast<u32>(_e1123));
                                    if ((((_e1121.member_1 < 0f) && (_e1121.member_3 < 0i)) || ((_e1121.member_1 >= 0f) && (_e1121.member_3 >= bitcast<i32>((((_e170.x + _e1125) - 1u) >> bitcast<u32>(_e1123)))))) || (abs(_e1121.member_1) < 0.000001f)) {
                                        phi_1428_ = 340282350000000000000000000000000000000f;
                                    } else {
                                        phi_1428_ = ((((f32(_e1121.member_3) + 0.5f) * f32(_e1125)) - _e1121.member) / _e1121.member_1);
                                    }
                                    let _e1151 = phi_1428_;
                                    phi_1574_ = _e273;
                                    phi_1575_ = _e275;
                                    phi_1576_ = type_40(_e1121.member, _e1121.member_1, _e1121.member_2, _e1121.member_3, _e1151);
                                } else {
                                    if (_e295 == 1u) {
                                        let _e1011 = (_e275.member_1 < 0f);
                                        if _e1011 {
                                            phi_1448_ = (_e275.member_3 - 1i);
                                        } else {
                                            phi_1448_ = (_e275.member_3 + 1i);
                                        }
                                        let _e1019 = phi_1448_;
                                        let _e1025 = type_40(_e275.member, _e275.member_1, _e275.member_2, _e1019, _e275.member_4);
                                        if ((((_e275.member_3 & 1i) == 0i) == _e1011) && (_e936 > _e275.member_2)) {
                                            let _e1035 = type_40(_e1025.member, _e1025.member_1, (_e275.member_2 + 1u), _e1025.member_3, _e1025.member_4);
                                            phi_1461_ = type_40(_e1035.member, _e1035.member_1, _e1035.member_2, (_e1019 >> bitcast<u32>(1i)), _e1035.member_4);
                                        } else {
                                            phi_1461_ = _e1025;
                                        }
                                        let _e1045 = phi_1461_;
                                        let _e1047 = (_e1045.member_2 & 31u);
                                        let _e1049 = (1u << bitcast<u32>(_e1047));
                                        if ((((_e1045.member_1 < 0f) && (_e1045.member_3 < 0i)) || ((_e1045.member_1 >= 0f) && (_e1045.member_3 >= bitcast<i32>((((_e170.y + _e1049) - 1u) >> bitcast<u32>(_e1047)))))) || (abs(_e1045.member_1) < 0.000001f)) {
                                            phi_1501_ = 340282350000000000000000000000000000000f;
                                        } else {
                                            phi_1501_ = ((((f32(_e1045.member_3) + 0.5f) * f32(_e1049)) - _e1045.member) / _e1045.member_1);
                                        }
                                        let _e1075 = phi_1501_;
                                        phi_1572_ = _e273;
                                        phi_1573_ = type_40(_e1045.member, _e1045.member_1, _e1045.member_2, _e1045.member_3, _e1075);
                                    } else {
                                        let _e939 = (_e273.member_1 < 0f);
                                        if _e939 {
                                            phi_1517_ = (_e273.member_3 - 1i);
                                        } else {
                                            phi_1517_ = (_e273.member_3 + 1i);
                                        }
                                        let _e947 = phi_1517_;
                                        let _e953 = type_40(_e273.member, _e273.member_1, _e273.member_2, _e947, _e273.member_4);
                                        if ((((_e273.member_3 & 1i) == 0i) == _e939) && (_e936 > _e273.member_2)) {
                                            let _e963 = type_40(_e953.member, _e953.member_1, (_e273.member_2 + 1u), _e953.member_3, _e953.member_4);
                                            phi_1530_ = type_40(_e963.member, _e963.member_1, _e963.member_2, (_e947 >> bitcast<u32>(1i)), _e963.member_4);
                                        } else {
                                            phi_1530_ = _e953;
                                        }
                                        let _e973 = phi_1530_;
                                        let _e975 = (_e973.member_2 & 31u);
                                        let _e977 = (1u << bitcast<u32>(_e975));
                                        if ((((_e973.member_1 < 0f) && (_e973.member_3 < 0i)) || ((_e973.member_1 >= 0f) && (_e973.member_3 >= bitcast<i32>((((_e170.z + _e977) - 1u) >> bitcast<u32>(_e975)))))) || (abs(_e973.member_1) < 0.000001f)) {
                                            phi_1570_ = 340282350000000000000000000000000000000f;
                                        } else {
                                            phi_1570_ = ((((f32(_e973.member_3) + 0.5f) * f32(_e977)) - _e973.member) / _e973.member_1);
                                        }
                                        let _e1003 = phi_1570_;
                                        phi_1572_ = type_40(_e973.member, _e973.member_1, _e973.member_2, _e973.member_3, _e1003);
                                        phi_1573_ = _e275;
                                    }
                                    let _e1083 = phi_1572_;
                                    let _e1085 = phi_1573_;
                                    phi_1574_ = _e1083;
                                    phi_1575_ = _e1085;
                                    phi_1576_ = _e277;
                                }
                                let _e1159 = phi_1574_;
                                let _e1161 = phi_1575_;
                                let _e1163 = phi_1576_;
                                phi_1577_ = _e916;
                                phi_1578_ = _e1159;
                                phi_1579_ = _e1161;
                                phi_1580_ = _e1163;
                                phi_1581_ = _e918;
                                phi_1582_ = _e920;
                            }
                            let _e1165 = phi_1577_;
                            let _e1167 = phi_1578_;
                            let _e1169 = phi_1579_;
                            let _e1171 = phi_1580_;
                            let _e1173 = phi_1581_;
                            let _e1175 = phi_1582_;
                            phi_422_ = _e1165;
                            phi_425_ = _e1167;
                            phi_427_ = _e1169;
                            phi_429_ = _e1171;
                            phi_431_ = (_e279 + 1u);
                            phi_433_ = _e1173;
                            phi_435_ = _e1175;
                            phi_1584_ = select(true, false, _e326);
                        } else {
                            phi_422_ = vec3<f32>();
                            phi_425_ = type_40();
                            phi_427_ = type_40();
                            phi_429_ = type_40();
                            phi_431_ = u32();
                            phi_433_ = f32();
                            phi_435_ = f32();
                            phi_1584_ = false;
                        }
                        let _e1178 = phi_422_;
                        let _e1180 = phi_425_;
                        let _e1182 = phi_427_;
                        let _e1184 = phi_429_;
                        let _e1186 = phi_431_;
                        let _e1188 = phi_433_;
                        let _e1190 = phi_435_;
                        let _e1192 = phi_1584_;
                        continue;
                        continuing {
                            phi_421_ = _e1178;
                            phi_424_ = _e1180;
                            phi_426_ = _e1182;
                            phi_428_ = _e1184;
                            phi_430_ = _e1186;
                            phi_432_ = _e1188;
                            phi_434_ = _e1190;
                            break if !(_e1192);
                        }
                    }
                    let _e1195 = local_6;
                    let _e1198 = local_7;
                    let _e1199 = (_e1198 * (1f - _e1195));
                    let _e1201 = local_8;
                    let _e1204 = local_9;
                    let _e1207 = local_10;
                    let _e1211 = params.member.member_5;
                    phi_1606_ = vec4<f32>((_e1201.x + (_e1211.x * _e1199)), (_e1204.y + (_e1211.y * _e1199)), (_e1207.z + (_e1211.z * _e1199)), _e1199);
                }
                let _e1223 = phi_1606_;
                if _e64 {
                } else {
                    break;
                }
                out.member[_e63] = _e1223;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn cone_glossy(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
