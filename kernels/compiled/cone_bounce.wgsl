struct type_9 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
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

struct type_30 {
    member: array<vec4<f32>>,
}

struct type_35 {
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

struct type_36 {
    member: type_35,
}

struct type_38 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: i32,
    member_4: f32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_36;
@group(0) @binding(1) 
var<storage> cells: type_9;
@group(0) @binding(2) 
var<storage> facet_bits: type_9;
@group(0) @binding(3) 
var<storage> facets: type_20;
@group(0) @binding(4) 
var<storage> radiance: type_30;
@group(0) @binding(5) 
var<storage> odd: type_30;
@group(0) @binding(6) 
var<storage> even: type_30;
@group(0) @binding(7) 
var<storage, read_write> out: type_30;

fn function_() {
    var phi_191_: vec3<f32>;
    var phi_198_: vec3<f32>;
    var phi_301_: f32;
    var phi_306_: type_13;
    var phi_309_: vec3<f32>;
    var phi_307_: type_13;
    var phi_332_: type_13;
    var phi_470_: f32;
    var phi_478_: f32;
    var phi_491_: f32;
    var phi_492_: vec3<f32>;
    var phi_539_: bool;
    var phi_548_: u32;
    var phi_564_: i32;
    var phi_593_: f32;
    var phi_610_: i32;
    var phi_639_: f32;
    var phi_656_: i32;
    var phi_685_: f32;
    var phi_688_: vec3<f32>;
    var phi_691_: type_38;
    var phi_693_: type_38;
    var phi_695_: type_38;
    var phi_697_: u32;
    var phi_699_: f32;
    var phi_701_: f32;
    var phi_727_: u32;
    var phi_749_: i32;
    var phi_750_: u32;
    var phi_751_: f32;
    var phi_752_: f32;
    var phi_753_: i32;
    var phi_754_: u32;
    var phi_755_: f32;
    var phi_804_: u32;
    var phi_819_: f32;
    var phi_901_: f32;
    var phi_912_: f32;
    var phi_995_: f32;
    var phi_1006_: f32;
    var phi_1089_: f32;
    var phi_1116_: f32;
    var phi_1117_: f32;
    var phi_1118_: u32;
    var phi_1119_: u32;
    var phi_1120_: u32;
    var phi_1121_: u32;
    var phi_1122_: f32;
    var phi_1123_: f32;
    var phi_1124_: u32;
    var phi_1125_: u32;
    var phi_1126_: u32;
    var phi_1127_: u32;
    var phi_1128_: u32;
    var phi_1129_: u32;
    var phi_1131_: vec4<f32>;
    var phi_1134_: u32;
    var phi_1521_: u32;
    var phi_1533_: vec4<f32>;
    var phi_1387_: vec4<f32>;
    var phi_1390_: vec4<f32>;
    var phi_1392_: u32;
    var phi_1462_: vec4<f32>;
    var phi_1463_: vec4<f32>;
    var phi_1388_: vec4<f32>;
    var phi_1391_: vec4<f32>;
    var phi_1393_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1486_: vec4<f32>;
    var phi_1288_: vec4<f32>;
    var phi_1291_: u32;
    var phi_1289_: vec4<f32>;
    var phi_1292_: u32;
    var phi_1487_: vec4<f32>;
    var phi_1501_: vec4<f32>;
    var phi_1534_: vec4<f32>;
    var phi_1555_: vec4<f32>;
    var phi_1132_: vec4<f32>;
    var phi_1135_: u32;
    var phi_1557_: vec4<f32>;
    var phi_1597_: vec3<f32>;
    var phi_1598_: f32;
    var phi_1599_: f32;
    var phi_1784_: i32;
    var phi_1797_: type_38;
    var phi_1837_: f32;
    var phi_1715_: i32;
    var phi_1728_: type_38;
    var phi_1768_: f32;
    var phi_1839_: type_38;
    var phi_1840_: type_38;
    var phi_1642_: i32;
    var phi_1655_: type_38;
    var phi_1695_: f32;
    var phi_1841_: type_38;
    var phi_1842_: type_38;
    var phi_1843_: type_38;
    var phi_1844_: vec3<f32>;
    var phi_1845_: type_38;
    var phi_1846_: type_38;
    var phi_1847_: type_38;
    var phi_1848_: f32;
    var phi_1849_: f32;
    var phi_689_: vec3<f32>;
    var phi_692_: type_38;
    var phi_694_: type_38;
    var phi_696_: type_38;
    var phi_698_: u32;
    var phi_700_: f32;
    var phi_702_: f32;
    var phi_1851_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var phi_310_: vec3<f32>;
    var phi_1947_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e77 = gid_1;
            let _e90 = params.member.member_9;
            let _e94 = (_e77.x + (_e77.y * 2097152u));
            if (_e94 < _e90) {
                let _e96 = (_e94 / 2u);
                if (_e96 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e100 = facets.member[_e96];
                let _e110 = sqrt((((_e100.member_2[0] * _e100.member_2[0]) + (_e100.member_2[1] * _e100.member_2[1])) + (_e100.member_2[2] * _e100.member_2[2])));
                if (_e110 > 0.000000000001f) {
                    phi_191_ = vec3<f32>((_e100.member_2[0] / _e110), (_e100.member_2[1] / _e110), (_e100.member_2[2] / _e110));
                } else {
                    phi_191_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e117 = phi_191_;
                if ((_e94 & 1u) == 0u) {
                    phi_198_ = _e117;
                } else {
                    phi_198_ = -(_e117);
                }
                let _e122 = phi_198_;
                let _e129 = params.member.member;
                let _e142 = params.member.member_12;
                let _e149 = (((_e100.member[0] - _e129.x) / _e129.w) + (_e122.x * _e142));
                let _e150 = (((_e100.member[1] - _e129.y) / _e129.w) + (_e122.y * _e142));
                let _e151 = (((_e100.member[2] - _e129.z) / _e129.w) + (_e122.z * _e142));
                let _e155 = bitcast<f32>((1065353216u | (bitcast<u32>(_e122.z) & 2147483648u)));
                let _e157 = (-1f / (_e155 + _e122.z));
                let _e159 = ((_e122.x * _e122.y) * _e157);
                let _e173 = params.member.member_10;
                let _e174 = (_e173 == 0u);
                if _e174 {
                    phi_301_ = 0f;
                } else {
                    let _e178 = ((_e94 * 1664525u) + 1013904223u);
                    let _e180 = (((_e173 * 1664525u) + 1013904223u) + (_e178 * 1013904223u));
                    let _e182 = (_e178 + (1013904223u * _e180));
                    let _e186 = (1013904223u + (_e182 * (1013904223u + (_e180 * _e182))));
                    phi_301_ = (f32((((_e180 ^ (_e180 >> bitcast<u32>(16i))) + ((_e182 ^ (_e182 >> bitcast<u32>(16i))) * (_e186 ^ (_e186 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                }
                let _e203 = phi_301_;
                let _e206 = params.member.member_7;
                phi_306_ = type_13(0u, _e206);
                phi_309_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e209 = phi_306_;
                    let _e211 = phi_309_;
                    local_11 = _e211;
                    local_12 = _e211;
                    local_13 = _e211;
                    if (_e209.member < _e209.member_1) {
                        phi_307_ = type_13((_e209.member + 1u), _e209.member_1);
                        phi_332_ = type_13(1u, _e209.member);
                    } else {
                        phi_307_ = _e209;
                        phi_332_ = type_13(0u, type_13().member_1);
                    }
                    let _e224 = phi_307_;
                    let _e226 = phi_332_;
                    let _e230 = (bitcast<i32>(_e226.member) != 0i);
                    if _e230 {
                        let _e231 = (_e226.member_1 < 16u);
                        if _e231 {
                        } else {
                            phi_1947_ = true;
                            break;
                        }
                        let _e235 = params.member.member_3[_e226.member_1];
                        if _e174 {
                            phi_491_ = 1.4142135f;
                            phi_492_ = vec3<f32>(_e235.x, _e235.y, _e235.z);
                        } else {
                            let _e240 = ((_e94 * 1664525u) + 1013904223u);
                            let _e242 = (((1u + _e226.member_1) * 1664525u) + 1013904223u);
                            let _e244 = (((_e173 * 1664525u) + 1013904223u) + (_e240 * 1013904223u));
                            let _e246 = (_e240 + (_e242 * _e244));
                            let _e248 = (_e242 + (_e244 * _e246));
                            let _e250 = (1013904223u + (_e246 * _e248));
                            let _e256 = (_e246 ^ (_e246 >> bitcast<u32>(16i)));
                            let _e259 = (_e248 ^ (_e248 >> bitcast<u32>(16i)));
                            let _e264 = ((_e244 ^ (_e244 >> bitcast<u32>(16i))) + (_e256 * (_e250 ^ (_e250 >> bitcast<u32>(16i)))));
                            let _e266 = (_e256 + (_e259 * _e264));
                            if _e231 {
                            } else {
                                phi_1947_ = true;
                                break;
                            }
                            let _e284 = params.member.member_4[_e226.member_1];
                            let _e289 = (_e284.y + ((_e284.x - _e284.y) * (f32((_e264 >> bitcast<u32>(8i))) * 0.000000059604645f)));
                            let _e294 = ((_e284.z + (_e284.w * (f32((_e266 >> bitcast<u32>(8i))) * 0.000000059604645f))) + _e203);
                            let _e298 = floor(((_e294 * 4f) + 0.5f));
                            let _e304 = ((((6.2831855f * _e294) - (_e298 * 1.5703125f)) - (_e298 * 0.0004837513f)) - (_e298 * 0.0000000754979f));
                            let _e305 = (_e304 * _e304);
                            let _e312 = (_e304 + ((_e304 * _e305) * (-0.16666655f + (_e305 * (0.008332161f + (_e305 * -0.00019515296f))))));
                            let _e321 = ((1f - (0.5f * _e305)) + ((_e305 * _e305) * (0.041666646f + (_e305 * (-0.0013887316f + (_e305 * 0.000024433157f))))));
                            let _e328 = select(0i, select(select(i32(_e298), i32(-2147483648), (_e298 < -2147483600f)), 2147483647i, (_e298 > 2147483500f)), (_e298 == _e298));
                            let _e330 = ((_e328 & 1i) == 0i);
                            let _e331 = select(_e321, _e312, _e330);
                            let _e332 = select(_e312, _e321, _e330);
                            if ((_e328 & 2i) == 0i) {
                                phi_470_ = _e331;
                            } else {
                                phi_470_ = -(_e331);
                            }
                            let _e337 = phi_470_;
                            if (((_e328 + 1i) & 2i) == 0i) {
                                phi_478_ = _e332;
                            } else {
                                phi_478_ = -(_e332);
                            }
                            let _e343 = phi_478_;
                            let _e344 = (1f - _e289);
                            let _e347 = sqrt(select(0f, _e344, (_e344 > 0f)));
                            phi_491_ = (1f + (f32(((_e259 + (_e264 * _e266)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                            phi_492_ = vec3<f32>((_e347 * _e343), (_e347 * _e337), sqrt(_e289));
                        }
                        let _e358 = phi_491_;
                        let _e360 = phi_492_;
                        let _e363 = params.member.member_11;
                        let _e366 = params.member.member_13;
                        let _e384 = ((((1f + (((_e155 * _e122.x) * _e122.x) * _e157)) * _e360.x) + (_e159 * _e360.y)) + (_e122.x * _e360.z));
                        let _e385 = ((((_e155 * _e159) * _e360.x) + ((_e155 + ((_e122.y * _e122.y) * _e157)) * _e360.y)) + (_e122.y * _e360.z));
                        let _e386 = ((((-(_e155) * _e122.x) * _e360.x) + (-(_e122.y) * _e360.y)) + (_e122.z * _e360.z));
                        let _e389 = params.member.member_1;
                        let _e390 = abs(_e384);
                        let _e391 = abs(_e385);
                        let _e392 = abs(_e386);
                        if (_e390 >= _e391) {
                            phi_539_ = select(true, false, (_e390 >= _e392));
                        } else {
                            phi_539_ = true;
                        }
                        let _e397 = phi_539_;
                        if _e397 {
                            phi_548_ = select(2u, 1u, (_e391 >= _e392));
                        } else {
                            phi_548_ = 0u;
                        }
                        let _e401 = phi_548_;
                        let _e410 = (_e384 < 0f);
                        if _e410 {
                            phi_564_ = (i32(-(floor((0.5f - _e149)))) - 1i);
                        } else {
                            phi_564_ = (i32(floor((_e149 - 0.5f))) + 1i);
                        }
                        let _e414 = phi_564_;
                        if (((_e410 && (_e414 < 0i)) || ((_e384 >= 0f) && (_e414 >= bitcast<i32>(_e389.x)))) || (_e390 < 0.000001f)) {
                            phi_593_ = 340282350000000000000000000000000000000f;
                        } else {
                            phi_593_ = (((f32(_e414) + 0.5f) - _e149) / _e384);
                        }
                        let _e429 = phi_593_;
                        let _e439 = (_e385 < 0f);
                        if _e439 {
                            phi_610_ = (i32(-(floor((0.5f - _e150)))) - 1i);
                        } else {
                            phi_610_ = (i32(floor((_e150 - 0.5f))) + 1i);
                        }
                        let _e443 = phi_610_;
                        if (((_e439 && (_e443 < 0i)) || ((_e385 >= 0f) && (_e443 >= bitcast<i32>(_e389.y)))) || (_e391 < 0.000001f)) {
                            phi_639_ = 340282350000000000000000000000000000000f;
                        } else {
                            phi_639_ = (((f32(_e443) + 0.5f) - _e150) / _e385);
                        }
                        let _e458 = phi_639_;
                        let _e468 = (_e386 < 0f);
                        if _e468 {
                            phi_656_ = (i32(-(floor((0.5f - _e151)))) - 1i);
                        } else {
                            phi_656_ = (i32(floor((_e151 - 0.5f))) + 1i);
                        }
                        let _e472 = phi_656_;
                        if (((_e468 && (_e472 < 0i)) || ((_e386 >= 0f) && (_e472 >= bitcast<i32>(_e389.z)))) || (_e392 < 0.000001f)) {
                            phi_685_ = 340282350000000000000000000000000000000f;
                        } else {
                            phi_685_ = (((f32(_e472) + 0.5f) - _e151) / _e386);
                        }
                        let _e487 = phi_685_;
                        phi_688_ = vec3<f32>(0f, 0f, 0f);
                        phi_691_ = type_38(_e151, _e386, 0u, _e472, _e487);
                        phi_693_ = type_38(_e150, _e385, 0u, _e443, _e458);
                        phi_695_ = type_38(_e149, _e384, 0u, _e414, _e429);
                        phi_697_ = 0u;
                        phi_699_ = 0f;
                        phi_701_ = 1f;
                        loop {
                            let _e490 = phi_688_;
                            let _e492 = phi_691_;
                            let _e494 = phi_693_;
                            let _e496 = phi_695_;
                            let _e498 = phi_697_;
                            let _e500 = phi_699_;
                            let _e502 = phi_701_;
                            local_6 = _e500;
                            local_7 = _e502;
                            local_8 = _e490;
                            local_9 = _e490;
                            local_10 = _e490;
                            if (_e498 < 2048u) {
                                if ((_e496.member_4 <= _e494.member_4) && (_e496.member_4 <= _e492.member_4)) {
                                    phi_727_ = 0u;
                                } else {
                                    phi_727_ = select(2u, 1u, (_e494.member_4 <= _e492.member_4));
                                }
                                let _e514 = phi_727_;
                                let _e515 = (_e514 == 0u);
                                if _e515 {
                                    phi_752_ = _e496.member_4;
                                    phi_753_ = _e496.member_3;
                                    phi_754_ = _e496.member_2;
                                    phi_755_ = _e496.member_1;
                                } else {
                                    let _e516 = (_e514 == 1u);
                                    if _e516 {
                                        phi_749_ = _e494.member_3;
                                        phi_750_ = _e494.member_2;
                                        phi_751_ = _e494.member_1;
                                    } else {
                                        phi_749_ = _e492.member_3;
                                        phi_750_ = _e492.member_2;
                                        phi_751_ = _e492.member_1;
                                    }
                                    let _e524 = phi_749_;
                                    let _e526 = phi_750_;
                                    let _e528 = phi_751_;
                                    phi_752_ = select(_e492.member_4, _e494.member_4, _e516);
                                    phi_753_ = _e524;
                                    phi_754_ = _e526;
                                    phi_755_ = _e528;
                                }
                                let _e534 = phi_752_;
                                let _e536 = phi_753_;
                                let _e538 = phi_754_;
                                let _e540 = phi_755_;
                                let _e542 = (1f - _e500);
                                let _e543 = (_e502 * _e542);
                                let _e545 = ((_e534 >= 340282350000000000000000000000000000000f) || (_e543 < 0.001f));
                                if _e545 {
                                    phi_1844_ = vec3<f32>();
                                    phi_1845_ = type_38();
                                    phi_1846_ = type_38();
                                    phi_1847_ = type_38();
                                    phi_1848_ = f32();
                                    phi_1849_ = f32();
                                } else {
                                    let _e552 = (_e540 < 0f);
                                    let _e556 = params.member.member_2[_e538];
                                    let _e557 = (_e538 & 31u);
                                    let _e559 = (1u << bitcast<u32>(_e557));
                                    let _e560 = (_e559 - 1u);
                                    let _e563 = ((_e389.x + _e560) >> bitcast<u32>(_e557));
                                    let _e566 = ((_e389.y + _e560) >> bitcast<u32>(_e557));
                                    let _e569 = ((_e389.z + _e560) >> bitcast<u32>(_e557));
                                    let _e571 = (1f / f32(_e559));
                                    if _e515 {
                                        phi_804_ = _e563;
                                    } else {
                                        phi_804_ = select(_e569, _e566, (_e514 == 1u));
                                    }
                                    let _e575 = phi_804_;
                                    if ((_e536 < 0i) || (_e536 >= bitcast<i32>(_e575))) {
                                        phi_1557_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    } else {
                                        let _e580 = f32(_e536);
                                        if _e515 {
                                            phi_819_ = _e580;
                                        } else {
                                            phi_819_ = (((_e149 + (_e384 * _e534)) * _e571) - 0.5f);
                                        }
                                        let _e584 = phi_819_;
                                        let _e585 = floor(_e584);
                                        let _e587 = i32(_e585);
                                        let _e589 = (bitcast<i32>(_e563) - 1i);
                                        let _e594 = ((_e584 >= -0.5f) && (_e584 <= (f32(_e589) + 0.5f)));
                                        let _e596 = select(0i, _e587, (0i < _e587));
                                        let _e599 = bitcast<u32>(select(_e596, _e589, (_e589 < _e596)));
                                        let _e600 = (_e587 + 1i);
                                        let _e602 = select(0i, _e600, (0i < _e600));
                                        let _e605 = bitcast<u32>(select(_e602, _e589, (_e589 < _e602)));
                                        let _e609 = select(select(0f, (_e584 - _e585), (_e587 < _e589)), 1f, (_e587 < 0i));
                                        let _e611 = (_e599 >> bitcast<u32>(2u));
                                        let _e613 = (_e605 >> bitcast<u32>(2u));
                                        let _e620 = ((_e599 & 1u) | (((_e599 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                        let _e627 = ((_e605 & 1u) | (((_e605 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                        if _e594 {
                                            phi_901_ = (1f - _e609);
                                        } else {
                                            phi_901_ = 0f;
                                        }
                                        let _e630 = phi_901_;
                                        let _e631 = select(0f, _e609, _e594);
                                        let _e632 = (_e514 == 1u);
                                        if _e632 {
                                            phi_912_ = _e580;
                                        } else {
                                            phi_912_ = (((_e150 + (_e385 * _e534)) * _e571) - 0.5f);
                                        }
                                        let _e636 = phi_912_;
                                        let _e638 = floor(_e636);
                                        let _e640 = i32(_e638);
                                        let _e642 = (bitcast<i32>(_e566) - 1i);
                                        let _e647 = ((_e636 >= -0.5f) && (_e636 <= (f32(_e642) + 0.5f)));
                                        let _e649 = select(0i, _e640, (0i < _e640));
                                        let _e652 = bitcast<u32>(select(_e649, _e642, (_e642 < _e649)));
                                        let _e653 = (_e640 + 1i);
                                        let _e655 = select(0i, _e653, (0i < _e653));
                                        let _e658 = bitcast<u32>(select(_e655, _e642, (_e642 < _e655)));
                                        let _e662 = select(select(0f, (_e636 - _e638), (_e640 < _e642)), 1f, (_e640 < 0i));
                                        let _e665 = ((_e652 >> bitcast<u32>(2u)) * _e556.x);
                                        let _e668 = ((_e658 >> bitcast<u32>(2u)) * _e556.x);
                                        let _e677 = (((_e652 & 1u) << bitcast<u32>(1u)) | (((_e652 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                        let _e686 = (((_e658 & 1u) << bitcast<u32>(1u)) | (((_e658 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                        if _e647 {
                                            phi_995_ = (1f - _e662);
                                        } else {
                                            phi_995_ = 0f;
                                        }
                                        let _e689 = phi_995_;
                                        let _e690 = select(0f, _e662, _e647);
                                        let _e691 = (_e514 == 2u);
                                        if _e691 {
                                            phi_1006_ = _e580;
                                        } else {
                                            phi_1006_ = (((_e151 + (_e386 * _e534)) * _e571) - 0.5f);
                                        }
                                        let _e695 = phi_1006_;
                                        let _e697 = floor(_e695);
                                        let _e699 = i32(_e697);
                                        let _e701 = (bitcast<i32>(_e569) - 1i);
                                        let _e706 = ((_e695 >= -0.5f) && (_e695 <= (f32(_e701) + 0.5f)));
                                        let _e708 = select(0i, _e699, (0i < _e699));
                                        let _e711 = bitcast<u32>(select(_e708, _e701, (_e701 < _e708)));
                                        let _e712 = (_e699 + 1i);
                                        let _e714 = select(0i, _e712, (0i < _e712));
                                        let _e717 = bitcast<u32>(select(_e714, _e701, (_e701 < _e714)));
                                        let _e721 = select(select(0f, (_e695 - _e697), (_e699 < _e701)), 1f, (_e699 < 0i));
                                        let _e724 = ((_e711 >> bitcast<u32>(1u)) * _e556.y);
                                        let _e727 = ((_e717 >> bitcast<u32>(1u)) * _e556.y);
                                        let _e730 = ((_e711 & 1u) << bitcast<u32>(2u));
                                        let _e733 = ((_e717 & 1u) << bitcast<u32>(2u));
                                        if _e706 {
                                            phi_1089_ = (1f - _e721);
                                        } else {
                                            phi_1089_ = 0f;
                                        }
                                        let _e736 = phi_1089_;
                                        let _e737 = select(0f, _e721, _e706);
                                        if _e515 {
                                            phi_1116_ = _e737;
                                            phi_1117_ = _e736;
                                            phi_1118_ = _e733;
                                            phi_1119_ = _e730;
                                            phi_1120_ = _e727;
                                            phi_1121_ = _e724;
                                            phi_1122_ = _e690;
                                            phi_1123_ = _e689;
                                            phi_1124_ = _e686;
                                            phi_1125_ = _e677;
                                            phi_1126_ = _e668;
                                            phi_1127_ = _e665;
                                            phi_1128_ = _e620;
                                            phi_1129_ = _e611;
                                        } else {
                                            phi_1116_ = select(_e690, _e631, _e632);
                                            phi_1117_ = select(_e689, _e630, _e632);
                                            phi_1118_ = select(_e686, _e627, _e632);
                                            phi_1119_ = select(_e677, _e620, _e632);
                                            phi_1120_ = select(_e668, _e613, _e632);
                                            phi_1121_ = select(_e665, _e611, _e632);
                                            phi_1122_ = select(_e631, _e737, _e632);
                                            phi_1123_ = select(_e630, _e736, _e632);
                                            phi_1124_ = select(_e627, _e733, _e632);
                                            phi_1125_ = select(_e620, _e730, _e632);
                                            phi_1126_ = select(_e613, _e727, _e632);
                                            phi_1127_ = select(_e611, _e724, _e632);
                                            phi_1128_ = select(_e730, _e677, _e632);
                                            phi_1129_ = select(_e724, _e665, _e632);
                                        }
                                        let _e753 = phi_1116_;
                                        let _e755 = phi_1117_;
                                        let _e757 = phi_1118_;
                                        let _e759 = phi_1119_;
                                        let _e761 = phi_1120_;
                                        let _e763 = phi_1121_;
                                        let _e765 = phi_1122_;
                                        let _e767 = phi_1123_;
                                        let _e769 = phi_1124_;
                                        let _e771 = phi_1125_;
                                        let _e773 = phi_1126_;
                                        let _e775 = phi_1127_;
                                        let _e777 = phi_1128_;
                                        let _e779 = phi_1129_;
                                        phi_1131_ = vec4<f32>(0f, 0f, 0f, 0f);
                                        phi_1134_ = 0u;
                                        loop {
                                            let _e781 = phi_1131_;
                                            let _e783 = phi_1134_;
                                            local_16 = _e781;
                                            let _e784 = (_e783 < 4u);
                                            if _e784 {
                                                let _e786 = ((_e783 & 1u) == 1u);
                                                let _e788 = ((_e783 & 2u) == 2u);
                                                let _e791 = (select(_e767, _e765, _e786) * select(_e755, _e753, _e788));
                                                let _e797 = (((_e556.z + _e779) + select(_e775, _e773, _e786)) + select(_e763, _e761, _e788));
                                                let _e802 = (2u * _e797);
                                                let _e804 = cells.member[_e802];
                                                let _e806 = (((_e777 | select(_e771, _e769, _e786)) | select(_e759, _e757, _e788)) & 31u);
                                                if ((_e791 > 0f) && (((_e804 >> bitcast<u32>(_e806)) & 1u) == 1u)) {
                                                    let _e814 = params.member.member_8;
                                                    let _e815 = (_e814 == 1u);
                                                    if (_e538 == 0u) {
                                                        let _e841 = (_e797 * 6u);
                                                        let _e844 = cells.member[(_e802 + 1u)];
                                                        let _e846 = facet_bits.member[_e841];
                                                        let _e849 = ((1u << bitcast<u32>(_e806)) - 1u);
                                                        let _e858 = facet_bits.member[(_e841 + 1u)];
                                                        let _e868 = facet_bits.member[(_e841 + 2u)];
                                                        let _e878 = facet_bits.member[(_e841 + 3u)];
                                                        let _e888 = facet_bits.member[(_e841 + 4u)];
                                                        let _e898 = facet_bits.member[(_e841 + 5u)];
                                                        let _e901 = ((((((_e844 + countOneBits((_e846 & _e849))) + countOneBits((_e858 & _e849))) + countOneBits((_e868 & _e849))) + countOneBits((_e878 & _e849))) + countOneBits((_e888 & _e849))) + countOneBits((_e898 & _e849)));
                                                        let _e905 = (((((((_e846 >> bitcast<u32>(_e806)) & 1u) + ((_e858 >> bitcast<u32>(_e806)) & 1u)) + ((_e868 >> bitcast<u32>(_e806)) & 1u)) + ((_e878 >> bitcast<u32>(_e806)) & 1u)) + ((_e888 >> bitcast<u32>(_e806)) & 1u)) + ((_e898 >> bitcast<u32>(_e806)) & 1u));
                                                        if _e815 {
                                                            phi_1288_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                            phi_1291_ = _e901;
                                                            loop {
                                                                let _e1008 = phi_1288_;
                                                                let _e1010 = phi_1291_;
                                                                local_15 = _e1008;
                                                                let _e1012 = (_e1010 < (_e901 + _e905));
                                                                if _e1012 {
                                                                    let _e1013 = (2u * _e1010);
                                                                    let _e1016 = radiance.member[_e1013][0u];
                                                                    let _e1019 = radiance.member[_e1013][1u];
                                                                    let _e1022 = radiance.member[_e1013][2u];
                                                                    let _e1023 = (_e1013 + 1u);
                                                                    let _e1026 = radiance.member[_e1023][0u];
                                                                    let _e1029 = radiance.member[_e1023][1u];
                                                                    let _e1032 = radiance.member[_e1023][2u];
                                                                    let _e1041 = facets.member[_e1010].member_2;
                                                                    let _e1050 = sqrt((((_e1041[0] * _e1041[0]) + (_e1041[1] * _e1041[1])) + (_e1041[2] * _e1041[2])));
                                                                    phi_1289_ = vec4<f32>((_e1008.x + (select(_e1026, _e1016, (_e1016 > _e1026)) * _e1050)), (_e1008.y + (select(_e1029, _e1019, (_e1019 > _e1029)) * _e1050)), (_e1008.z + (select(_e1032, _e1022, (_e1022 > _e1032)) * _e1050)), (_e1008.w + _e1050));
                                                                    phi_1292_ = (_e1010 + 1u);
                                                                } else {
                                                                    phi_1289_ = vec4<f32>();
                                                                    phi_1292_ = u32();
                                                                }
                                                                let _e1065 = phi_1289_;
                                                                let _e1067 = phi_1292_;
                                                                continue;
                                                                continuing {
                                                                    phi_1288_ = _e1065;
                                                                    phi_1291_ = _e1067;
                                                                    break if !(_e1012);
                                                                }
                                                            }
                                                            let _e1554 = local_15;
                                                            phi_1487_ = _e1554;
                                                        } else {
                                                            let _e906 = select(1f, -1f, _e552);
                                                            phi_1387_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                            phi_1390_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                            phi_1392_ = _e901;
                                                            loop {
                                                                let _e911 = phi_1387_;
                                                                let _e913 = phi_1390_;
                                                                let _e915 = phi_1392_;
                                                                local = _e911;
                                                                local_1 = _e913;
                                                                local_2 = _e911;
                                                                local_3 = _e911;
                                                                local_4 = _e911;
                                                                local_5 = _e913;
                                                                local_14 = _e913;
                                                                let _e917 = (_e915 < (_e901 + _e905));
                                                                if _e917 {
                                                                    let _e920 = facets.member[_e915].member_2;
                                                                    let _e929 = -((((select(0f, _e906, _e515) * _e920[0]) + (select(0f, _e906, _e632) * _e920[1])) + (select(0f, _e906, _e691) * _e920[2])));
                                                                    if (_e929 > 0f) {
                                                                        let _e952 = radiance.member[(2u * _e915)];
                                                                        phi_1462_ = _e911;
                                                                        phi_1463_ = vec4<f32>((_e913.x + (_e952.x * _e929)), (_e913.y + (_e952.y * _e929)), (_e913.z + (_e952.z * _e929)), (_e913.w + _e929));
                                                                    } else {
                                                                        let _e934 = radiance.member[((2u * _e915) + 1u)];
                                                                        phi_1462_ = vec4<f32>((_e911.x - (_e934.x * _e929)), (_e911.y - (_e934.y * _e929)), (_e911.z - (_e934.z * _e929)), (_e911.w - _e929));
                                                                        phi_1463_ = _e913;
                                                                    }
                                                                    let _e969 = phi_1462_;
                                                                    let _e971 = phi_1463_;
                                                                    phi_1388_ = _e969;
                                                                    phi_1391_ = _e971;
                                                                    phi_1393_ = (_e915 + 1u);
                                                                } else {
                                                                    phi_1388_ = vec4<f32>();
                                                                    phi_1391_ = vec4<f32>();
                                                                    phi_1393_ = u32();
                                                                }
                                                                let _e974 = phi_1388_;
                                                                let _e976 = phi_1391_;
                                                                let _e978 = phi_1393_;
                                                                continue;
                                                                continuing {
                                                                    phi_1387_ = _e974;
                                                                    phi_1390_ = _e976;
                                                                    phi_1392_ = _e978;
                                                                    break if !(_e917);
                                                                }
                                                            }
                                                            let _e981 = local;
                                                            let _e984 = local_1;
                                                            if (_e981.w > _e984.w) {
                                                                let _e987 = (_e981.w - _e984.w);
                                                                let _e988 = (_e987 / _e981.w);
                                                                let _e990 = local_2;
                                                                let _e994 = local_3;
                                                                let _e998 = local_4;
                                                                let _e1003 = local_5;
                                                                phi_1486_ = (_e1003 + vec4<f32>((_e990.x * _e988), (_e994.y * _e988), (_e998.z * _e988), _e987));
                                                            } else {
                                                                let _e1547 = local_14;
                                                                phi_1486_ = _e1547;
                                                            }
                                                            let _e1006 = phi_1486_;
                                                            phi_1487_ = _e1006;
                                                        }
                                                        let _e1070 = phi_1487_;
                                                        if (_e1070.w > 1f) {
                                                            phi_1501_ = vec4<f32>((_e1070.x / _e1070.w), (_e1070.y / _e1070.w), (_e1070.z / _e1070.w), 1f);
                                                        } else {
                                                            phi_1501_ = _e1070;
                                                        }
                                                        let _e1081 = phi_1501_;
                                                        phi_1534_ = _e1081;
                                                    } else {
                                                        let _e819 = cells.member[(_e802 + 1u)];
                                                        let _e825 = (_e819 + countOneBits((_e804 & ((1u << bitcast<u32>(_e806)) - 1u))));
                                                        if _e815 {
                                                            phi_1521_ = _e825;
                                                        } else {
                                                            phi_1521_ = (((6u * _e825) + (2u * _e514)) + select(0u, 1u, _e552));
                                                        }
                                                        let _e832 = phi_1521_;
                                                        if ((_e538 & 1u) == 1u) {
                                                            let _e838 = odd.member[_e832];
                                                            phi_1533_ = _e838;
                                                        } else {
                                                            let _e836 = even.member[_e832];
                                                            phi_1533_ = _e836;
                                                        }
                                                        let _e840 = phi_1533_;
                                                        phi_1534_ = _e840;
                                                    }
                                                    let _e1083 = phi_1534_;
                                                    phi_1555_ = vec4<f32>((_e781.x + (_e1083.x * _e791)), (_e781.y + (_e1083.y * _e791)), (_e781.z + (_e1083.z * _e791)), (_e781.w + (_e1083.w * _e791)));
                                                } else {
                                                    phi_1555_ = _e781;
                                                }
                                                let _e1102 = phi_1555_;
                                                phi_1132_ = _e1102;
                                                phi_1135_ = (_e783 + 1u);
                                            } else {
                                                phi_1132_ = vec4<f32>();
                                                phi_1135_ = u32();
                                            }
                                            let _e1105 = phi_1132_;
                                            let _e1107 = phi_1135_;
                                            continue;
                                            continuing {
                                                phi_1131_ = _e1105;
                                                phi_1134_ = _e1107;
                                                break if !(_e784);
                                            }
                                        }
                                        let _e1562 = local_16;
                                        phi_1557_ = _e1562;
                                    }
                                    let _e1110 = phi_1557_;
                                    if (_e1110.w > 0f) {
                                        let _e1117 = select(_e542, _e1110.w, (_e1110.w < _e542));
                                        let _e1122 = ((_e502 * _e1117) / _e1110.w);
                                        phi_1597_ = vec3<f32>((_e490.x + (_e1110.x * _e1122)), (_e490.y + (_e1110.y * _e1122)), (_e490.z + (_e1110.z * _e1122)));
                                        phi_1598_ = (_e500 + _e1117);
                                        phi_1599_ = _e502;
                                    } else {
                                        let _e1113 = (_e514 == _e401);
                                        phi_1597_ = _e490;
                                        phi_1598_ = select(_e500, 0f, _e1113);
                                        phi_1599_ = select(_e502, _e543, _e1113);
                                    }
                                    let _e1135 = phi_1597_;
                                    let _e1137 = phi_1598_;
                                    let _e1139 = phi_1599_;
                                    let _e1140 = (_e363 * _e534);
                                    let _e1142 = ((_e366 * _e142) + ((_e366 * _e360.z) * _e534));
                                    let _e1144 = select(_e1142, _e1140, (_e1140 < _e1142));
                                    let _e1151 = ((bitcast<u32>((select(1f, _e1144, (_e1144 > 1f)) * _e358)) >> bitcast<u32>(23i)) - 127u);
                                    let _e1153 = (_e389.w - 1u);
                                    let _e1155 = select(_e1151, _e1153, (_e1153 < _e1151));
                                    if _e515 {
                                        let _e1306 = (_e496.member_1 < 0f);
                                        if _e1306 {
                                            phi_1642_ = (_e496.member_3 - 1i);
                                        } else {
                                            phi_1642_ = (_e496.member_3 + 1i);
                                        }
                                        let _e1314 = phi_1642_;
                                        let _e1320 = type_38(_e496.member, _e496.member_1, _e496.member_2, _e1314, _e496.member_4);
                                        if ((((_e496.member_3 & 1i) == 0i) == _e1306) && (_e1155 > _e496.member_2)) {
                                            let _e1330 = type_38(_e1320.member, _e1320.member_1, (_e496.member_2 + 1u), _e1320.member_3, _e1320.member_4);
                                            phi_1655_ = type_38(_e1330.member, _e1330.member_1, _e1330.member_2, (_e1314 >> bitcast<u32>(1i)), _e1330.member_4);
                                        } else {
                                            phi_1655_ = _e1320;
                                        }
                                        let _e1340 = phi_1655_;
                                        let _e1342 = (_e1340.member_2 & 31u);
                                        let _e1344 = (1u << bitcast<u32>(_e1342));
                                        if ((((_e1340.member_1 < 0f) && (_e1340.member_3 < 0i)) || ((_e1340.member_1 >= 0f) && (_e1340.member_3 >= bitcast<i32>((((_e389.x + _e1344) - 1u) >> bitcast<u32>(_e1342)))))) || (abs(_e1340.member_1) < 0.000001f)) {
                                            phi_1695_ = 340282350000000000000000000000000000000f;
                                        } else {
                                            phi_1695_ = ((((f32(_e1340.member_3) + 0.5f) * f32(_e1344)) - _e1340.member) / _e1340.member_1);
                                        }
                                        let _e1370 = phi_1695_;
                                        phi_1841_ = _e492;
                                        phi_1842_ = _e494;
                                        phi_1843_ = type_38(_e1340.member, _e1340.member_1, _e1340.member_2, _e1340.member_3, _e1370);
                                    } else {
                                        if (_e514 == 1u) {
                                            let _e1230 = (_e494.member_1 < 0f);
                                            if _e1230 {
                                                phi_1715_ = (_e494.member_3 - 1i);
                                            } else {
                                                phi_1715_ = (_e494.member_3 + 1i);
                                            }
                                            let _e1238 = phi_1715_;
                                            let _e1244 = type_38(_e494.member, _e494.member_1, _e494.member_2, _e1238, _e494.member_4);
                                            if ((((_e494.member_3 & 1i) == 0i) == _e1230) && (_e1155 > _e494.member_2)) {
                                                let _e1254 = type_38(_e1244.member, _e1244.member_1, (_e494.member_2 + 1u), _e1244.member_3, _e1244.member_4);
                                                phi_1728_ = type_38(_e1254.member, _e1254.member_1, _e1254.member_2, (_e1238 >> bitcast<u32>(1i)), _e1254.member_4);
                                            } else {
                                                phi_1728_ = _e1244;
                                            }
                                            let _e1264 = phi_1728_;
                                            let _e1266 = (_e1264.member_2 & 31u);
                                            let _e1268 = (1u << bitcast<u32>(_e1266));
                                            if ((((_e1264.member_1 < 0f) && (_e1264.member_3 < 0i)) || ((_e1264.member_1 >= 0f) && (_e1264.member_3 >= bitcast<i32>((((_e389.y + _e1268) - 1u) >> bitcast<u32>(_e1266)))))) || (abs(_e1264.member_1) < 0.000001f)) {
                                                phi_1768_ = 340282350000000000000000000000000000000f;
                                            } else {
                                                phi_1768_ = ((((f32(_e1264.member_3) + 0.5f) * f32(_e1268)) - _e1264.member) / _e1264.member_1);
                                            }
                                            let _e1294 = phi_1768_;
                                            phi_1839_ = _e492;
                                            phi_1840_ = type_38(_e1264.member, _e1264.member_1, _e1264.member_2, _e1264.member_3, _e1294);
                                        } else {
                                            let _e1158 = (_e492.member_1 < 0f);
                                            if _e1158 {
                                                phi_1784_ = (_e492.member_3 - 1i);
                                            } else {
                                                phi_1784_ = (_e492.member_3 + 1i);
                                            }
                                            let _e1166 = phi_1784_;
                                            let _e1172 = type_38(_e492.member, _e492.member_1, _e492.member_2, _e1166, _e492.member_4);
                                            if ((((_e492.member_3 & 1i) == 0i) == _e1158) && (_e1155 > _e492.member_2)) {
                                                let _e1182 = type_38(_e1172.member, _e1172.member_1, (_e492.member_2 + 1u), _e1172.member_3, _e1172.member_4);
                                                phi_1797_ = type_38(_e1182.member, _e1182.member_1, _e1182.member_2, (_e1166 >> bitcast<u32>(1i)), _e1182.member_4);
                                            } else {
                                                phi_1797_ = _e1172;
                                            }
                                            let _e1192 = phi_1797_;
                                            let _e1194 = (_e1192.member_2 & 31u);
                                            let _e1196 = (1u << bitcast<u32>(_e1194));
                                            if ((((_e1192.member_1 < 0f) && (_e1192.member_3 < 0i)) || ((_e1192.member_1 >= 0f) && (_e1192.member_3 >= bitcast<i32>((((_e389.z + _e1196) - 1u) >> bitcast<u32>(_e1194)))))) || (abs(_e1192.member_1) < 0.000001f)) {
                                                phi_1837_ = 340282350000000000000000000000000000000f;
                                            } else {
                                                phi_1837_ = ((((f32(_e1192.member_3) + 0.5f) * f32(_e1196)) - _e1192.member) / _e1192.member_1);
                                            }
                                            let _e1222 = phi_1837_;
                                            phi_1839_ = type_38(_e1192.member, _e1192.member_1, _e1192.member_2, _e1192.member_3, _e1222);
                                            phi_1840_ = _e494;
                                        }
                                        let _e1302 = phi_1839_;
                                        let _e1304 = phi_1840_;
                                        phi_1841_ = _e1302;
                                        phi_1842_ = _e1304;
                                        phi_1843_ = _e496;
                                    }
                                    let _e1378 = phi_1841_;
                                    let _e1380 = phi_1842_;
                                    let _e1382 = phi_1843_;
                                    phi_1844_ = _e1135;
                                    phi_1845_ = _e1378;
                                    phi_1846_ = _e1380;
                                    phi_1847_ = _e1382;
                                    phi_1848_ = _e1137;
                                    phi_1849_ = _e1139;
                                }
                                let _e1384 = phi_1844_;
                                let _e1386 = phi_1845_;
                                let _e1388 = phi_1846_;
                                let _e1390 = phi_1847_;
                                let _e1392 = phi_1848_;
                                let _e1394 = phi_1849_;
                                phi_689_ = _e1384;
                                phi_692_ = _e1386;
                                phi_694_ = _e1388;
                                phi_696_ = _e1390;
                                phi_698_ = (_e498 + 1u);
                                phi_700_ = _e1392;
                                phi_702_ = _e1394;
                                phi_1851_ = select(true, false, _e545);
                            } else {
                                phi_689_ = vec3<f32>();
                                phi_692_ = type_38();
                                phi_694_ = type_38();
                                phi_696_ = type_38();
                                phi_698_ = u32();
                                phi_700_ = f32();
                                phi_702_ = f32();
                                phi_1851_ = false;
                            }
                            let _e1397 = phi_689_;
                            let _e1399 = phi_692_;
                            let _e1401 = phi_694_;
                            let _e1403 = phi_696_;
                            let _e1405 = phi_698_;
                            let _e1407 = phi_700_;
                            let _e1409 = phi_702_;
                            let _e1411 = phi_1851_;
                            continue;
                            continuing {
                                phi_688_ = _e1397;
                                phi_691_ = _e1399;
                                phi_693_ = _e1401;
                                phi_695_ = _e1403;
                                phi_697_ = _e1405;
                                phi_699_ = _e1407;
                                phi_701_ = _e1409;
                                break if !(_e1411);
                            }
                        }
                        let _e1414 = local_6;
                        let _e1417 = local_7;
                        let _e1418 = (_e1417 * (1f - _e1414));
                        let _e1420 = local_8;
                        let _e1423 = local_9;
                        let _e1426 = local_10;
                        let _e1430 = params.member.member_5;
                        phi_310_ = vec3<f32>((_e211.x + ((_e1420.x + (_e1430.x * _e1418)) * _e235.w)), (_e211.y + ((_e1423.y + (_e1430.y * _e1418)) * _e235.w)), (_e211.z + ((_e1426.z + (_e1430.z * _e1418)) * _e235.w)));
                    } else {
                        phi_310_ = vec3<f32>();
                    }
                    let _e1452 = phi_310_;
                    continue;
                    continuing {
                        phi_306_ = _e224;
                        phi_309_ = _e1452;
                        phi_1947_ = false;
                        break if !(_e230);
                    }
                }
                let _e1455 = phi_1947_;
                if _e1455 {
                    break;
                }
                let _e1457 = local_11;
                let _e1461 = local_12;
                let _e1465 = local_13;
                if (_e94 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e94] = vec4<f32>((_e1457.x * 3.1415927f), (_e1461.y * 3.1415927f), (_e1465.z * 3.1415927f), 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn cone_bounce(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
