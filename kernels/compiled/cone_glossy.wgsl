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
    var phi_184_: vec3<f32>;
    var phi_274_: bool;
    var phi_283_: u32;
    var phi_299_: i32;
    var phi_328_: f32;
    var phi_345_: i32;
    var phi_374_: f32;
    var phi_391_: i32;
    var phi_420_: f32;
    var phi_423_: vec3<f32>;
    var phi_426_: type_40;
    var phi_428_: type_40;
    var phi_430_: type_40;
    var phi_432_: u32;
    var phi_434_: f32;
    var phi_436_: f32;
    var phi_462_: u32;
    var phi_484_: i32;
    var phi_485_: u32;
    var phi_486_: f32;
    var phi_487_: f32;
    var phi_488_: i32;
    var phi_489_: u32;
    var phi_490_: f32;
    var phi_715_: f32;
    var phi_845_: f32;
    var phi_851_: vec4<f32>;
    var phi_854_: u32;
    var phi_1241_: u32;
    var phi_1253_: vec4<f32>;
    var phi_1107_: vec4<f32>;
    var phi_1110_: vec4<f32>;
    var phi_1112_: u32;
    var phi_1182_: vec4<f32>;
    var phi_1183_: vec4<f32>;
    var phi_1108_: vec4<f32>;
    var phi_1111_: vec4<f32>;
    var phi_1113_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1206_: vec4<f32>;
    var phi_1008_: vec4<f32>;
    var phi_1011_: u32;
    var phi_1009_: vec4<f32>;
    var phi_1012_: u32;
    var phi_1207_: vec4<f32>;
    var phi_1221_: vec4<f32>;
    var phi_1254_: vec4<f32>;
    var phi_1275_: vec4<f32>;
    var phi_852_: vec4<f32>;
    var phi_855_: u32;
    var phi_1277_: vec4<f32>;
    var phi_1317_: vec3<f32>;
    var phi_1318_: f32;
    var phi_1319_: f32;
    var phi_1504_: i32;
    var phi_1517_: type_40;
    var phi_1557_: f32;
    var phi_1435_: i32;
    var phi_1448_: type_40;
    var phi_1488_: f32;
    var phi_1559_: type_40;
    var phi_1560_: type_40;
    var phi_1362_: i32;
    var phi_1375_: type_40;
    var phi_1415_: f32;
    var phi_1561_: type_40;
    var phi_1562_: type_40;
    var phi_1563_: type_40;
    var phi_1564_: vec3<f32>;
    var phi_1565_: type_40;
    var phi_1566_: type_40;
    var phi_1567_: type_40;
    var phi_1568_: f32;
    var phi_1569_: f32;
    var phi_424_: vec3<f32>;
    var phi_427_: type_40;
    var phi_429_: type_40;
    var phi_431_: type_40;
    var phi_433_: u32;
    var phi_435_: f32;
    var phi_437_: f32;
    var phi_1571_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var phi_1593_: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e53 = gid_1;
            let _e65 = (_e53.x + (_e53.y * 2097152u));
            let _e66 = (_e65 < arrayLength((&out.member)));
            if _e66 {
                let _e70 = surfels.member[_e65].member_1;
                if (_e70 == 4294967295u) {
                    phi_1593_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e75 = surfels.member[_e65].member;
                    let _e81 = params.member.member_6;
                    let _e85 = (_e81.x - _e75[0]);
                    let _e86 = (_e81.y - _e75[1]);
                    let _e87 = (_e81.z - _e75[2]);
                    let _e92 = (((_e85 * _e85) + (_e86 * _e86)) + (_e87 * _e87));
                    if (_e92 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e95 = (1f / sqrt(_e92));
                        phi_184_ = vec3<f32>((_e85 * _e95), (_e86 * _e95), (_e87 * _e95));
                    } else {
                        phi_184_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e101 = phi_184_;
                    let _e105 = surfels.member[_e65].member_2;
                    let _e117 = (2f * (((_e101.x * _e105[0]) + (_e101.y * _e105[1])) + (_e101.z * _e105[2])));
                    let _e121 = ((_e105[0] * _e117) - _e101.x);
                    let _e122 = ((_e105[1] * _e117) - _e101.y);
                    let _e123 = ((_e105[2] * _e117) - _e101.z);
                    let _e126 = params.member.member;
                    let _e140 = surfels.member[_e65].member_4;
                    let _e146 = params.member.member_12;
                    let _e150 = (((_e75[0] - _e126.x) / _e126.w) + (_e140[0] * _e146));
                    let _e151 = (((_e75[1] - _e126.y) / _e126.w) + (_e140[1] * _e146));
                    let _e152 = (((_e75[2] - _e126.z) / _e126.w) + (_e140[2] * _e146));
                    let _e156 = params.member.member_6[3u];
                    let _e160 = params.member.member_13;
                    let _e166 = (((_e121 * _e140[0]) + (_e122 * _e140[1])) + (_e123 * _e140[2]));
                    let _e172 = params.member.member_1;
                    let _e173 = abs(_e121);
                    let _e174 = abs(_e122);
                    let _e175 = abs(_e123);
                    if (_e173 >= _e174) {
                        phi_274_ = select(true, false, (_e173 >= _e175));
                    } else {
                        phi_274_ = true;
                    }
                    let _e180 = phi_274_;
                    if _e180 {
                        phi_283_ = select(2u, 1u, (_e174 >= _e175));
                    } else {
                        phi_283_ = 0u;
                    }
                    let _e184 = phi_283_;
                    let _e193 = (_e121 < 0f);
                    if _e193 {
                        phi_299_ = (i32(-(floor((0.5f - _e150)))) - 1i);
                    } else {
                        phi_299_ = (i32(floor((_e150 - 0.5f))) + 1i);
                    }
                    let _e197 = phi_299_;
                    if (((_e193 && (_e197 < 0i)) || ((_e121 >= 0f) && (_e197 >= bitcast<i32>(_e172.x)))) || (_e173 < 0.000001f)) {
                        phi_328_ = 340282350000000000000000000000000000000f;
                    } else {
                        phi_328_ = (((f32(_e197) + 0.5f) - _e150) / _e121);
                    }
                    let _e212 = phi_328_;
                    let _e222 = (_e122 < 0f);
                    if _e222 {
                        phi_345_ = (i32(-(floor((0.5f - _e151)))) - 1i);
                    } else {
                        phi_345_ = (i32(floor((_e151 - 0.5f))) + 1i);
                    }
                    let _e226 = phi_345_;
                    if (((_e222 && (_e226 < 0i)) || ((_e122 >= 0f) && (_e226 >= bitcast<i32>(_e172.y)))) || (_e174 < 0.000001f)) {
                        phi_374_ = 340282350000000000000000000000000000000f;
                    } else {
                        phi_374_ = (((f32(_e226) + 0.5f) - _e151) / _e122);
                    }
                    let _e241 = phi_374_;
                    let _e251 = (_e123 < 0f);
                    if _e251 {
                        phi_391_ = (i32(-(floor((0.5f - _e152)))) - 1i);
                    } else {
                        phi_391_ = (i32(floor((_e152 - 0.5f))) + 1i);
                    }
                    let _e255 = phi_391_;
                    if (((_e251 && (_e255 < 0i)) || ((_e123 >= 0f) && (_e255 >= bitcast<i32>(_e172.z)))) || (_e175 < 0.000001f)) {
                        phi_420_ = 340282350000000000000000000000000000000f;
                    } else {
                        phi_420_ = (((f32(_e255) + 0.5f) - _e152) / _e123);
                    }
                    let _e270 = phi_420_;
                    phi_423_ = vec3<f32>(0f, 0f, 0f);
                    phi_426_ = type_40(_e152, _e123, 0u, _e255, _e270);
                    phi_428_ = type_40(_e151, _e122, 0u, _e226, _e241);
                    phi_430_ = type_40(_e150, _e121, 0u, _e197, _e212);
                    phi_432_ = 0u;
                    phi_434_ = 0f;
                    phi_436_ = 1f;
                    loop {
                        let _e273 = phi_423_;
                        let _e275 = phi_426_;
                        let _e277 = phi_428_;
                        let _e279 = phi_430_;
                        let _e281 = phi_432_;
                        let _e283 = phi_434_;
                        let _e285 = phi_436_;
                        local_6 = _e283;
                        local_7 = _e285;
                        local_8 = _e273;
                        local_9 = _e273;
                        local_10 = _e273;
                        if (_e281 < 2048u) {
                            if ((_e279.member_4 <= _e277.member_4) && (_e279.member_4 <= _e275.member_4)) {
                                phi_462_ = 0u;
                            } else {
                                phi_462_ = select(2u, 1u, (_e277.member_4 <= _e275.member_4));
                            }
                            let _e297 = phi_462_;
                            let _e298 = (_e297 == 0u);
                            if _e298 {
                                phi_487_ = _e279.member_4;
                                phi_488_ = _e279.member_3;
                                phi_489_ = _e279.member_2;
                                phi_490_ = _e279.member_1;
                            } else {
                                let _e299 = (_e297 == 1u);
                                if _e299 {
                                    phi_484_ = _e277.member_3;
                                    phi_485_ = _e277.member_2;
                                    phi_486_ = _e277.member_1;
                                } else {
                                    phi_484_ = _e275.member_3;
                                    phi_485_ = _e275.member_2;
                                    phi_486_ = _e275.member_1;
                                }
                                let _e307 = phi_484_;
                                let _e309 = phi_485_;
                                let _e311 = phi_486_;
                                phi_487_ = select(_e275.member_4, _e277.member_4, _e299);
                                phi_488_ = _e307;
                                phi_489_ = _e309;
                                phi_490_ = _e311;
                            }
                            let _e317 = phi_487_;
                            let _e319 = phi_488_;
                            let _e321 = phi_489_;
                            let _e323 = phi_490_;
                            let _e325 = (1f - _e283);
                            let _e326 = (_e285 * _e325);
                            let _e328 = ((_e317 >= 340282350000000000000000000000000000000f) || (_e326 < 0.001f));
                            if _e328 {
                                phi_1564_ = vec3<f32>();
                                phi_1565_ = type_40();
                                phi_1566_ = type_40();
                                phi_1567_ = type_40();
                                phi_1568_ = f32();
                                phi_1569_ = f32();
                            } else {
                                let _e335 = (_e323 < 0f);
                                let _e339 = params.member.member_2[_e321];
                                let _e340 = (_e321 & 31u);
                                let _e342 = (1u << bitcast<u32>(_e340));
                                let _e343 = (_e342 - 1u);
                                let _e346 = ((_e172.x + _e343) >> bitcast<u32>(_e340));
                                let _e349 = ((_e172.y + _e343) >> bitcast<u32>(_e340));
                                let _e352 = ((_e172.z + _e343) >> bitcast<u32>(_e340));
                                let _e355 = (_e297 == 2u);
                                if ((_e319 < 0i) || (_e319 >= bitcast<i32>(select(select(_e349, _e346, _e298), _e352, _e355)))) {
                                    phi_1277_ = vec4<f32>(0f, 0f, 0f, 0f);
                                } else {
                                    let _e361 = (1f / f32(_e342));
                                    let _e363 = (((_e150 + (_e121 * _e317)) * _e361) - 0.5f);
                                    let _e365 = (((_e151 + (_e122 * _e317)) * _e361) - 0.5f);
                                    let _e367 = (((_e152 + (_e123 * _e317)) * _e361) - 0.5f);
                                    let _e368 = bitcast<u32>(_e319);
                                    let _e393 = select(select(_e367, _e365, _e298), _e363, _e355);
                                    let _e397 = select(select(1u, 2u, _e298), 2u, _e355);
                                    let _e399 = select(select(_e339.y, _e339.x, _e298), 1u, _e355);
                                    let _e400 = select(2u, 1u, _e298);
                                    let _e401 = select(_e400, 0u, _e355);
                                    let _e402 = floor(_e393);
                                    let _e404 = i32(_e402);
                                    let _e406 = (bitcast<i32>(select(select(_e352, _e349, _e298), _e346, _e355)) - 1i);
                                    let _e411 = ((_e393 >= -0.5f) && (_e393 <= (f32(_e406) + 0.5f)));
                                    let _e413 = select(0i, _e404, (0i < _e404));
                                    let _e416 = bitcast<u32>(select(_e413, _e406, (_e406 < _e413)));
                                    let _e417 = (_e404 + 1i);
                                    let _e419 = select(0i, _e417, (0i < _e417));
                                    let _e422 = bitcast<u32>(select(_e419, _e406, (_e406 < _e419)));
                                    let _e426 = select(select(0f, (_e393 - _e402), (_e404 < _e406)), 1f, (_e404 < 0i));
                                    let _e427 = (_e397 & 31u);
                                    let _e435 = (_e401 & 31u);
                                    let _e440 = (_e397 - 1u);
                                    let _e443 = ((_e401 + 3u) & 31u);
                                    if _e411 {
                                        phi_715_ = (1f - _e426);
                                    } else {
                                        phi_715_ = 0f;
                                    }
                                    let _e458 = phi_715_;
                                    let _e461 = select(select(_e363, _e367, _e298), _e365, _e355);
                                    let _e464 = select(_e400, 2u, _e355);
                                    let _e466 = select(select(1u, _e339.y, _e298), _e339.x, _e355);
                                    let _e468 = select(select(0u, 2u, _e298), 1u, _e355);
                                    let _e469 = floor(_e461);
                                    let _e471 = i32(_e469);
                                    let _e473 = (bitcast<i32>(select(select(_e346, _e352, _e298), _e349, _e355)) - 1i);
                                    let _e478 = ((_e461 >= -0.5f) && (_e461 <= (f32(_e473) + 0.5f)));
                                    let _e480 = select(0i, _e471, (0i < _e471));
                                    let _e483 = bitcast<u32>(select(_e480, _e473, (_e473 < _e480)));
                                    let _e484 = (_e471 + 1i);
                                    let _e486 = select(0i, _e484, (0i < _e484));
                                    let _e489 = bitcast<u32>(select(_e486, _e473, (_e473 < _e486)));
                                    let _e493 = select(select(0f, (_e461 - _e469), (_e471 < _e473)), 1f, (_e471 < 0i));
                                    let _e494 = (_e464 & 31u);
                                    let _e502 = (_e468 & 31u);
                                    let _e507 = (_e464 - 1u);
                                    let _e510 = ((_e468 + 3u) & 31u);
                                    if _e478 {
                                        phi_845_ = (1f - _e493);
                                    } else {
                                        phi_845_ = 0f;
                                    }
                                    let _e525 = phi_845_;
                                    phi_851_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    phi_854_ = 0u;
                                    loop {
                                        let _e528 = phi_851_;
                                        let _e530 = phi_854_;
                                        local_13 = _e528;
                                        let _e531 = (_e530 < 4u);
                                        if _e531 {
                                            let _e533 = ((_e530 & 1u) == 1u);
                                            let _e535 = ((_e530 & 2u) == 2u);
                                            let _e538 = (select(_e458, select(0f, _e426, _e411), _e533) * select(_e525, select(0f, _e493, _e478), _e535));
                                            let _e544 = (((_e339.z + ((_e368 >> bitcast<u32>((select(2i, 1i, _e355) & 31i))) * select(select(_e339.x, 1u, _e298), _e339.y, _e355))) + select(((_e416 >> bitcast<u32>(_e427)) * _e399), ((_e422 >> bitcast<u32>(_e427)) * _e399), _e533)) + select(((_e483 >> bitcast<u32>(_e494)) * _e466), ((_e489 >> bitcast<u32>(_e494)) * _e466), _e535));
                                            let _e549 = (2u * _e544);
                                            let _e551 = cells.member[_e549];
                                            let _e553 = ((((((_e368 & 1u) << bitcast<u32>((_e297 & 31u))) | (((_e368 >> bitcast<u32>(1i)) & (select(2u, 1u, _e355) - 1u)) << bitcast<u32>(((_e297 + 3u) & 31u)))) | select((((_e416 & 1u) << bitcast<u32>(_e435)) | (((_e416 >> bitcast<u32>(1i)) & _e440) << bitcast<u32>(_e443))), (((_e422 & 1u) << bitcast<u32>(_e435)) | (((_e422 >> bitcast<u32>(1i)) & _e440) << bitcast<u32>(_e443))), _e533)) | select((((_e483 & 1u) << bitcast<u32>(_e502)) | (((_e483 >> bitcast<u32>(1i)) & _e507) << bitcast<u32>(_e510))), (((_e489 & 1u) << bitcast<u32>(_e502)) | (((_e489 >> bitcast<u32>(1i)) & _e507) << bitcast<u32>(_e510))), _e535)) & 31u);
                                            if ((_e538 > 0f) && (((_e551 >> bitcast<u32>(_e553)) & 1u) == 1u)) {
                                                let _e561 = params.member.member_8;
                                                let _e562 = (_e561 == 1u);
                                                if (_e321 == 0u) {
                                                    let _e588 = (_e544 * 6u);
                                                    let _e591 = cells.member[(_e549 + 1u)];
                                                    let _e593 = facet_bits.member[_e588];
                                                    let _e596 = ((1u << bitcast<u32>(_e553)) - 1u);
                                                    let _e605 = facet_bits.member[(_e588 + 1u)];
                                                    let _e615 = facet_bits.member[(_e588 + 2u)];
                                                    let _e625 = facet_bits.member[(_e588 + 3u)];
                                                    let _e635 = facet_bits.member[(_e588 + 4u)];
                                                    let _e645 = facet_bits.member[(_e588 + 5u)];
                                                    let _e648 = ((((((_e591 + countOneBits((_e593 & _e596))) + countOneBits((_e605 & _e596))) + countOneBits((_e615 & _e596))) + countOneBits((_e625 & _e596))) + countOneBits((_e635 & _e596))) + countOneBits((_e645 & _e596)));
                                                    let _e652 = (((((((_e593 >> bitcast<u32>(_e553)) & 1u) + ((_e605 >> bitcast<u32>(_e553)) & 1u)) + ((_e615 >> bitcast<u32>(_e553)) & 1u)) + ((_e625 >> bitcast<u32>(_e553)) & 1u)) + ((_e635 >> bitcast<u32>(_e553)) & 1u)) + ((_e645 >> bitcast<u32>(_e553)) & 1u));
                                                    if _e562 {
                                                        phi_1008_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                        phi_1011_ = _e648;
                                                        loop {
                                                            let _e756 = phi_1008_;
                                                            let _e758 = phi_1011_;
                                                            local_12 = _e756;
                                                            let _e760 = (_e758 < (_e648 + _e652));
                                                            if _e760 {
                                                                let _e761 = (2u * _e758);
                                                                let _e764 = radiance.member[_e761][0u];
                                                                let _e767 = radiance.member[_e761][1u];
                                                                let _e770 = radiance.member[_e761][2u];
                                                                let _e771 = (_e761 + 1u);
                                                                let _e774 = radiance.member[_e771][0u];
                                                                let _e777 = radiance.member[_e771][1u];
                                                                let _e780 = radiance.member[_e771][2u];
                                                                let _e789 = facets.member[_e758].member_2;
                                                                let _e798 = sqrt((((_e789[0] * _e789[0]) + (_e789[1] * _e789[1])) + (_e789[2] * _e789[2])));
                                                                phi_1009_ = vec4<f32>((_e756.x + (select(_e774, _e764, (_e764 > _e774)) * _e798)), (_e756.y + (select(_e777, _e767, (_e767 > _e777)) * _e798)), (_e756.z + (select(_e780, _e770, (_e770 > _e780)) * _e798)), (_e756.w + _e798));
                                                                phi_1012_ = (_e758 + 1u);
                                                            } else {
                                                                phi_1009_ = vec4<f32>();
                                                                phi_1012_ = u32();
                                                            }
                                                            let _e813 = phi_1009_;
                                                            let _e815 = phi_1012_;
                                                            continue;
                                                            continuing {
                                                                phi_1008_ = _e813;
                                                                phi_1011_ = _e815;
                                                                break if !(_e760);
                                                            }
                                                        }
                                                        let _e1246 = local_12;
                                                        phi_1207_ = _e1246;
                                                    } else {
                                                        let _e653 = select(1f, -1f, _e335);
                                                        phi_1107_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                        phi_1110_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                        phi_1112_ = _e648;
                                                        loop {
                                                            let _e659 = phi_1107_;
                                                            let _e661 = phi_1110_;
                                                            let _e663 = phi_1112_;
                                                            local = _e659;
                                                            local_1 = _e661;
                                                            local_2 = _e659;
                                                            local_3 = _e659;
                                                            local_4 = _e659;
                                                            local_5 = _e661;
                                                            local_11 = _e661;
                                                            let _e665 = (_e663 < (_e648 + _e652));
                                                            if _e665 {
                                                                let _e668 = facets.member[_e663].member_2;
                                                                let _e677 = -((((select(0f, _e653, _e298) * _e668[0]) + (select(0f, _e653, (_e297 == 1u)) * _e668[1])) + (select(0f, _e653, _e355) * _e668[2])));
                                                                if (_e677 > 0f) {
                                                                    let _e700 = radiance.member[(2u * _e663)];
                                                                    phi_1182_ = _e659;
                                                                    phi_1183_ = vec4<f32>((_e661.x + (_e700.x * _e677)), (_e661.y + (_e700.y * _e677)), (_e661.z + (_e700.z * _e677)), (_e661.w + _e677));
                                                                } else {
                                                                    let _e682 = radiance.member[((2u * _e663) + 1u)];
                                                                    phi_1182_ = vec4<f32>((_e659.x - (_e682.x * _e677)), (_e659.y - (_e682.y * _e677)), (_e659.z - (_e682.z * _e677)), (_e659.w - _e677));
                                                                    phi_1183_ = _e661;
                                                                }
                                                                let _e717 = phi_1182_;
                                                                let _e719 = phi_1183_;
                                                                phi_1108_ = _e717;
                                                                phi_1111_ = _e719;
                                                                phi_1113_ = (_e663 + 1u);
                                                            } else {
                                                                phi_1108_ = vec4<f32>();
                                                                phi_1111_ = vec4<f32>();
                                                                phi_1113_ = u32();
                                                            }
                                                            let _e722 = phi_1108_;
                                                            let _e724 = phi_1111_;
                                                            let _e726 = phi_1113_;
                                                            continue;
                                                            continuing {
                                                                phi_1107_ = _e722;
                                                                phi_1110_ = _e724;
                                                                phi_1112_ = _e726;
                                                                break if !(_e665);
                                                            }
                                                        }
                                                        let _e729 = local;
                                                        let _e732 = local_1;
                                                        if (_e729.w > _e732.w) {
                                                            let _e735 = (_e729.w - _e732.w);
                                                            let _e736 = (_e735 / _e729.w);
                                                            let _e738 = local_2;
                                                            let _e742 = local_3;
                                                            let _e746 = local_4;
                                                            let _e751 = local_5;
                                                            phi_1206_ = (_e751 + vec4<f32>((_e738.x * _e736), (_e742.y * _e736), (_e746.z * _e736), _e735));
                                                        } else {
                                                            let _e1239 = local_11;
                                                            phi_1206_ = _e1239;
                                                        }
                                                        let _e754 = phi_1206_;
                                                        phi_1207_ = _e754;
                                                    }
                                                    let _e818 = phi_1207_;
                                                    if (_e818.w > 1f) {
                                                        phi_1221_ = vec4<f32>((_e818.x / _e818.w), (_e818.y / _e818.w), (_e818.z / _e818.w), 1f);
                                                    } else {
                                                        phi_1221_ = _e818;
                                                    }
                                                    let _e829 = phi_1221_;
                                                    phi_1254_ = _e829;
                                                } else {
                                                    let _e566 = cells.member[(_e549 + 1u)];
                                                    let _e572 = (_e566 + countOneBits((_e551 & ((1u << bitcast<u32>(_e553)) - 1u))));
                                                    if _e562 {
                                                        phi_1241_ = _e572;
                                                    } else {
                                                        phi_1241_ = (((6u * _e572) + (2u * _e297)) + select(0u, 1u, _e335));
                                                    }
                                                    let _e579 = phi_1241_;
                                                    if ((_e321 & 1u) == 1u) {
                                                        let _e585 = odd.member[_e579];
                                                        phi_1253_ = _e585;
                                                    } else {
                                                        let _e583 = even.member[_e579];
                                                        phi_1253_ = _e583;
                                                    }
                                                    let _e587 = phi_1253_;
                                                    phi_1254_ = _e587;
                                                }
                                                let _e831 = phi_1254_;
                                                phi_1275_ = vec4<f32>((_e528.x + (_e831.x * _e538)), (_e528.y + (_e831.y * _e538)), (_e528.z + (_e831.z * _e538)), (_e528.w + (_e831.w * _e538)));
                                            } else {
                                                phi_1275_ = _e528;
                                            }
                                            let _e850 = phi_1275_;
                                            phi_852_ = _e850;
                                            phi_855_ = (_e530 + 1u);
                                        } else {
                                            phi_852_ = vec4<f32>();
                                            phi_855_ = u32();
                                        }
                                        let _e853 = phi_852_;
                                        let _e855 = phi_855_;
                                        continue;
                                        continuing {
                                            phi_851_ = _e853;
                                            phi_854_ = _e855;
                                            break if !(_e531);
                                        }
                                    }
                                    let _e1254 = local_13;
                                    phi_1277_ = _e1254;
                                }
                                let _e858 = phi_1277_;
                                if (_e858.w > 0f) {
                                    let _e865 = select(_e325, _e858.w, (_e858.w < _e325));
                                    let _e870 = ((_e285 * _e865) / _e858.w);
                                    phi_1317_ = vec3<f32>((_e273.x + (_e858.x * _e870)), (_e273.y + (_e858.y * _e870)), (_e273.z + (_e858.z * _e870)));
                                    phi_1318_ = (_e283 + _e865);
                                    phi_1319_ = _e285;
                                } else {
                                    let _e861 = (_e297 == _e184);
                                    phi_1317_ = _e273;
                                    phi_1318_ = select(_e283, 0f, _e861);
                                    phi_1319_ = select(_e285, _e326, _e861);
                                }
                                let _e883 = phi_1317_;
                                let _e885 = phi_1318_;
                                let _e887 = phi_1319_;
                                let _e888 = ((2f * _e156) * _e317);
                                let _e890 = ((_e160 * _e146) + ((_e160 * select(0f, _e166, (_e166 > 0f))) * _e317));
                                let _e892 = select(_e890, _e888, (_e888 < _e890));
                                let _e899 = ((bitcast<u32>((select(1f, _e892, (_e892 > 1f)) * 1.4142135f)) >> bitcast<u32>(23i)) - 127u);
                                let _e901 = (_e172.w - 1u);
                                let _e903 = select(_e899, _e901, (_e901 < _e899));
                                if _e298 {
                                    let _e1054 = (_e279.member_1 < 0f);
                                    if _e1054 {
                                        phi_1362_ = (_e279.member_3 - 1i);
                                    } else {
                                        phi_1362_ = (_e279.member_3 + 1i);
                                    }
                                    let _e1062 = phi_1362_;
                                    let _e1068 = type_40(_e279.member, _e279.member_1, _e279.member_2, _e1062, _e279.member_4);
                                    if ((((_e279.member_3 & 1i) == 0i) == _e1054) && (_e903 > _e279.member_2)) {
                                        let _e1078 = type_40(_e1068.member, _e1068.member_1, (_e279.member_2 + 1u), _e1068.member_3, _e1068.member_4);
                                        phi_1375_ = type_40(_e1078.member, _e1078.member_1, _e1078.member_2, (_e1062 >> bitcast<u32>(1i)), _e1078.member_4);
                                    } else {
                                        phi_1375_ = _e1068;
                                    }
                                    let _e1088 = phi_1375_;
                                    let _e1090 = (_e1088.member_2 & 31u);
                                    let _e1092 = (1u << bitcast<u32>(_e1090));
                                    if ((((_e1088.member_1 < 0f) && (_e1088.member_3 < 0i)) || ((_e1088.member_1 >= 0f) && (_e1088.member_3 >= bitcast<i32>((((_e172.x + _e1092) - 1u) >> bitcast<u32>(_e1090)))))) || (abs(_e1088.member_1) < 0.000001f)) {
                                        phi_1415_ = 340282350000000000000000000000000000000f;
                                    } else {
                                        phi_1415_ = ((((f32(_e1088.member_3) + 0.5f) * f32(_e1092)) - _e1088.member) / _e1088.member_1);
                                    }
                                    let _e1118 = phi_1415_;
                                    phi_1561_ = _e275;
                                    phi_1562_ = _e277;
                                    phi_1563_ = type_40(_e1088.member, _e1088.member_1, _e1088.member_2, _e1088.member_3, _e1118);
                                } else {
                                    if (_e297 == 1u) {
                                        let _e978 = (_e277.member_1 < 0f);
                                        if _e978 {
                                            phi_1435_ = (_e277.member_3 - 1i);
                                        } else {
                                            phi_1435_ = (_e277.member_3 + 1i);
                                        }
                                        let _e986 = phi_1435_;
                                        let _e992 = type_40(_e277.member, _e277.member_1, _e277.member_2, _e986, _e277.member_4);
                                        if ((((_e277.member_3 & 1i) == 0i) == _e978) && (_e903 > _e277.member_2)) {
                                            let _e1002 = type_40(_e992.member, _e992.member_1, (_e277.member_2 + 1u), _e992.member_3, _e992.member_4);
                                            phi_1448_ = type_40(_e1002.member, _e1002.member_1, _e1002.member_2, (_e986 >> bitcast<u32>(1i)), _e1002.member_4);
                                        } else {
                                            phi_1448_ = _e992;
                                        }
                                        let _e1012 = phi_1448_;
                                        let _e1014 = (_e1012.member_2 & 31u);
                                        let _e1016 = (1u << bitcast<u32>(_e1014));
                                        if ((((_e1012.member_1 < 0f) && (_e1012.member_3 < 0i)) || ((_e1012.member_1 >= 0f) && (_e1012.member_3 >= bitcast<i32>((((_e172.y + _e1016) - 1u) >> bitcast<u32>(_e1014)))))) || (abs(_e1012.member_1) < 0.000001f)) {
                                            phi_1488_ = 340282350000000000000000000000000000000f;
                                        } else {
                                            phi_1488_ = ((((f32(_e1012.member_3) + 0.5f) * f32(_e1016)) - _e1012.member) / _e1012.member_1);
                                        }
                                        let _e1042 = phi_1488_;
                                        phi_1559_ = _e275;
                                        phi_1560_ = type_40(_e1012.member, _e1012.member_1, _e1012.member_2, _e1012.member_3, _e1042);
                                    } else {
                                        let _e906 = (_e275.member_1 < 0f);
                                        if _e906 {
                                            phi_1504_ = (_e275.member_3 - 1i);
                                        } else {
                                            phi_1504_ = (_e275.member_3 + 1i);
                                        }
                                        let _e914 = phi_1504_;
                                        let _e920 = type_40(_e275.member, _e275.member_1, _e275.member_2, _e914, _e275.member_4);
                                        if ((((_e275.member_3 & 1i) == 0i) == _e906) && (_e903 > _e275.member_2)) {
                                            let _e930 = type_40(_e920.member, _e920.member_1, (_e275.member_2 + 1u), _e920.member_3, _e920.member_4);
                                            phi_1517_ = type_40(_e930.member, _e930.member_1, _e930.member_2, (_e914 >> bitcast<u32>(1i)), _e930.member_4);
                                        } else {
                                            phi_1517_ = _e920;
                                        }
                                        let _e940 = phi_1517_;
                                        let _e942 = (_e940.member_2 & 31u);
                                        let _e944 = (1u << bitcast<u32>(_e942));
                                        if ((((_e940.member_1 < 0f) && (_e940.member_3 < 0i)) || ((_e940.member_1 >= 0f) && (_e940.member_3 >= bitcast<i32>((((_e172.z + _e944) - 1u) >> bitcast<u32>(_e942)))))) || (abs(_e940.member_1) < 0.000001f)) {
                                            phi_1557_ = 340282350000000000000000000000000000000f;
                                        } else {
                                            phi_1557_ = ((((f32(_e940.member_3) + 0.5f) * f32(_e944)) - _e940.member) / _e940.member_1);
                                        }
                                        let _e970 = phi_1557_;
                                        phi_1559_ = type_40(_e940.member, _e940.member_1, _e940.member_2, _e940.member_3, _e970);
                                        phi_1560_ = _e277;
                                    }
                                    let _e1050 = phi_1559_;
                                    let _e1052 = phi_1560_;
                                    phi_1561_ = _e1050;
                                    phi_1562_ = _e1052;
                                    phi_1563_ = _e279;
                                }
                                let _e1126 = phi_1561_;
                                let _e1128 = phi_1562_;
                                let _e1130 = phi_1563_;
                                phi_1564_ = _e883;
                                phi_1565_ = _e1126;
                                phi_1566_ = _e1128;
                                phi_1567_ = _e1130;
                                phi_1568_ = _e885;
                                phi_1569_ = _e887;
                            }
                            let _e1132 = phi_1564_;
                            let _e1134 = phi_1565_;
                            let _e1136 = phi_1566_;
                            let _e1138 = phi_1567_;
                            let _e1140 = phi_1568_;
                            let _e1142 = phi_1569_;
                            phi_424_ = _e1132;
                            phi_427_ = _e1134;
                            phi_429_ = _e1136;
                            phi_431_ = _e1138;
                            phi_433_ = (_e281 + 1u);
                            phi_435_ = _e1140;
                            phi_437_ = _e1142;
                            phi_1571_ = select(true, false, _e328);
                        } else {
                            phi_424_ = vec3<f32>();
                            phi_427_ = type_40();
                            phi_429_ = type_40();
                            phi_431_ = type_40();
                            phi_433_ = u32();
                            phi_435_ = f32();
                            phi_437_ = f32();
                            phi_1571_ = false;
                        }
                        let _e1145 = phi_424_;
                        let _e1147 = phi_427_;
                        let _e1149 = phi_429_;
                        let _e1151 = phi_431_;
                        let _e1153 = phi_433_;
                        let _e1155 = phi_435_;
                        let _e1157 = phi_437_;
                        let _e1159 = phi_1571_;
                        continue;
                        continuing {
                            phi_423_ = _e1145;
                            phi_426_ = _e1147;
                            phi_428_ = _e1149;
                            phi_430_ = _e1151;
                            phi_432_ = _e1153;
                            phi_434_ = _e1155;
                            phi_436_ = _e1157;
                            break if !(_e1159);
                        }
                    }
                    let _e1162 = local_6;
                    let _e1165 = local_7;
                    let _e1166 = (_e1165 * (1f - _e1162));
                    let _e1168 = local_8;
                    let _e1171 = local_9;
                    let _e1174 = local_10;
                    let _e1178 = params.member.member_5;
                    phi_1593_ = vec4<f32>((_e1168.x + (_e1178.x * _e1166)), (_e1171.y + (_e1178.y * _e1166)), (_e1174.z + (_e1178.z * _e1166)), _e1166);
                }
                let _e1190 = phi_1593_;
                if _e66 {
                } else {
                    break;
                }
                out.member[_e65] = _e1190;
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
