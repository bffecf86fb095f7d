struct type_8 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
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

struct type_29 {
    member: array<vec4<f32>>,
}

struct type_34 {
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

struct type_35 {
    member: type_34,
}

struct type_37 {
    member: u32,
    member_1: i32,
    member_2: f32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_35;
@group(0) @binding(1) 
var<storage> cells: type_8;
@group(0) @binding(2) 
var<storage> facet_bits: type_8;
@group(0) @binding(3) 
var<storage> facets: type_19;
@group(0) @binding(4) 
var<storage> radiance: type_29;
@group(0) @binding(5) 
var<storage> odd: type_29;
@group(0) @binding(6) 
var<storage> even: type_29;
@group(0) @binding(7) 
var<storage, read_write> out: type_29;

fn function_() {
    var phi_190_: vec3<f32>;
    var phi_197_: vec3<f32>;
    var phi_300_: f32;
    var phi_305_: type_12;
    var phi_308_: vec3<f32>;
    var phi_306_: type_12;
    var phi_331_: type_12;
    var phi_469_: f32;
    var phi_477_: f32;
    var phi_490_: f32;
    var phi_491_: vec3<f32>;
    var phi_538_: bool;
    var phi_547_: u32;
    var phi_565_: i32;
    var phi_579_: bool;
    var phi_610_: i32;
    var phi_624_: bool;
    var phi_655_: i32;
    var phi_669_: bool;
    var phi_720_: vec3<f32>;
    var phi_723_: type_37;
    var phi_725_: u32;
    var phi_727_: u32;
    var phi_729_: f32;
    var phi_731_: f32;
    var phi_733_: type_37;
    var phi_735_: type_37;
    var phi_737_: type_37;
    var phi_1005_: f32;
    var phi_1135_: f32;
    var phi_1141_: vec4<f32>;
    var phi_1144_: u32;
    var phi_1494_: u32;
    var phi_1506_: vec4<f32>;
    var phi_1310_: vec4<f32>;
    var phi_1313_: vec4<f32>;
    var phi_1315_: u32;
    var phi_1311_: vec4<f32>;
    var phi_1314_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1460_: vec4<f32>;
    var phi_1474_: vec4<f32>;
    var phi_1507_: vec4<f32>;
    var phi_1142_: vec4<f32>;
    var phi_1533_: vec4<f32>;
    var phi_1573_: vec3<f32>;
    var phi_1574_: f32;
    var phi_1575_: f32;
    var phi_1617_: i32;
    var phi_1635_: bool;
    var phi_1656_: u32;
    var phi_1661_: i32;
    var phi_1666_: f32;
    var phi_1673_: u32;
    var phi_1678_: i32;
    var phi_1683_: f32;
    var phi_1690_: u32;
    var phi_1695_: i32;
    var phi_1700_: f32;
    var phi_721_: vec3<f32>;
    var phi_724_: type_37;
    var phi_726_: u32;
    var phi_728_: u32;
    var phi_730_: f32;
    var phi_732_: f32;
    var phi_734_: type_37;
    var phi_736_: type_37;
    var phi_738_: type_37;
    var local_6: vec3<f32>;
    var local_7: vec3<f32>;
    var local_8: vec3<f32>;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var phi_309_: vec3<f32>;
    var phi_1830_: bool;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: vec3<f32>;
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
                    phi_190_ = vec3<f32>((_e100.member_2[0] / _e110), (_e100.member_2[1] / _e110), (_e100.member_2[2] / _e110));
                } else {
                    phi_190_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e117 = phi_190_;
                if ((_e94 & 1u) == 0u) {
                    phi_197_ = _e117;
                } else {
                    phi_197_ = -(_e117);
                }
                let _e122 = phi_197_;
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
                    phi_300_ = 0f;
                } else {
                    let _e178 = ((_e94 * 1664525u) + 1013904223u);
                    let _e180 = (((_e173 * 1664525u) + 1013904223u) + (_e178 * 1013904223u));
                    let _e182 = (_e178 + (1013904223u * _e180));
                    let _e186 = (1013904223u + (_e182 * (1013904223u + (_e180 * _e182))));
                    phi_300_ = (f32((((_e180 ^ (_e180 >> bitcast<u32>(16i))) + ((_e182 ^ (_e182 >> bitcast<u32>(16i))) * (_e186 ^ (_e186 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                }
                let _e203 = phi_300_;
                let _e206 = params.member.member_7;
                phi_305_ = type_12(0u, _e206);
                phi_308_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e209 = phi_305_;
                    let _e211 = phi_308_;
                    local_12 = _e211;
                    local_13 = _e211;
                    local_14 = _e211;
                    if (_e209.member < _e209.member_1) {
                        phi_306_ = type_12((_e209.member + 1u), _e209.member_1);
                        phi_331_ = type_12(1u, _e209.member);
                    } else {
                        phi_306_ = _e209;
                        phi_331_ = type_12(0u, type_12().member_1);
                    }
                    let _e224 = phi_306_;
                    let _e226 = phi_331_;
                    let _e230 = (bitcast<i32>(_e226.member) != 0i);
                    if _e230 {
                        let _e231 = (_e226.member_1 < 16u);
                        if _e231 {
                        } else {
                            phi_1830_ = true;
                            break;
                        }
                        let _e235 = params.member.member_3[_e226.member_1];
                        if _e174 {
                            phi_490_ = 1.4142135f;
                            phi_491_ = vec3<f32>(_e235.x, _e235.y, _e235.z);
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
                                phi_1830_ = true;
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
                                phi_469_ = _e331;
                            } else {
                                phi_469_ = -(_e331);
                            }
                            let _e337 = phi_469_;
                            if (((_e328 + 1i) & 2i) == 0i) {
                                phi_477_ = _e332;
                            } else {
                                phi_477_ = -(_e332);
                            }
                            let _e343 = phi_477_;
                            let _e344 = (1f - _e289);
                            let _e347 = sqrt(select(0f, _e344, (_e344 > 0f)));
                            phi_490_ = (1f + (f32(((_e259 + (_e264 * _e266)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                            phi_491_ = vec3<f32>((_e347 * _e343), (_e347 * _e337), sqrt(_e289));
                        }
                        let _e358 = phi_490_;
                        let _e360 = phi_491_;
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
                            phi_538_ = select(true, false, (_e390 >= _e392));
                        } else {
                            phi_538_ = true;
                        }
                        let _e397 = phi_538_;
                        if _e397 {
                            phi_547_ = select(2u, 1u, (_e391 >= _e392));
                        } else {
                            phi_547_ = 0u;
                        }
                        let _e401 = phi_547_;
                        let _e412 = (_e384 < 0f);
                        if _e412 {
                            phi_565_ = (i32(-(floor((0.5f - _e149)))) - 1i);
                        } else {
                            phi_565_ = (i32(floor((_e149 - 0.5f))) + 1i);
                        }
                        let _e416 = phi_565_;
                        if _e412 {
                            phi_579_ = (_e416 < 0i);
                        } else {
                            phi_579_ = (_e416 >= bitcast<i32>(_e389.x));
                        }
                        let _e421 = phi_579_;
                        let _e428 = select((((f32(_e416) + 0.5f) - _e149) / _e384), 340282350000000000000000000000000000000f, (_e421 || (_e390 < 0.000001f)));
                        let _e437 = (_e385 < 0f);
                        if _e437 {
                            phi_610_ = (i32(-(floor((0.5f - _e150)))) - 1i);
                        } else {
                            phi_610_ = (i32(floor((_e150 - 0.5f))) + 1i);
                        }
                        let _e441 = phi_610_;
                        if _e437 {
                            phi_624_ = (_e441 < 0i);
                        } else {
                            phi_624_ = (_e441 >= bitcast<i32>(_e389.y));
                        }
                        let _e446 = phi_624_;
                        let _e453 = select((((f32(_e441) + 0.5f) - _e150) / _e385), 340282350000000000000000000000000000000f, (_e446 || (_e391 < 0.000001f)));
                        let _e462 = (_e386 < 0f);
                        if _e462 {
                            phi_655_ = (i32(-(floor((0.5f - _e151)))) - 1i);
                        } else {
                            phi_655_ = (i32(floor((_e151 - 0.5f))) + 1i);
                        }
                        let _e466 = phi_655_;
                        if _e462 {
                            phi_669_ = (_e466 < 0i);
                        } else {
                            phi_669_ = (_e466 >= bitcast<i32>(_e389.z));
                        }
                        let _e471 = phi_669_;
                        let _e478 = select((((f32(_e466) + 0.5f) - _e151) / _e386), 340282350000000000000000000000000000000f, (_e471 || (_e392 < 0.000001f)));
                        let _e482 = ((_e428 <= _e453) && (_e428 <= _e478));
                        let _e483 = (_e453 <= _e478);
                        phi_720_ = vec3<f32>(0f, 0f, 0f);
                        phi_723_ = type_37(0u, select(select(_e466, _e441, _e483), _e416, _e482), select(select(_e478, _e453, _e483), _e428, _e482));
                        phi_725_ = select(select(2u, 1u, _e483), 0u, _e482);
                        phi_727_ = 0u;
                        phi_729_ = 0f;
                        phi_731_ = 1f;
                        phi_733_ = type_37(0u, _e466, _e478);
                        phi_735_ = type_37(0u, _e441, _e453);
                        phi_737_ = type_37(0u, _e416, _e428);
                        loop {
                            let _e492 = phi_720_;
                            let _e494 = phi_723_;
                            let _e496 = phi_725_;
                            let _e498 = phi_727_;
                            let _e500 = phi_729_;
                            let _e502 = phi_731_;
                            let _e504 = phi_733_;
                            let _e506 = phi_735_;
                            let _e508 = phi_737_;
                            local_6 = _e492;
                            local_7 = _e492;
                            local_8 = _e492;
                            let _e513 = (1f - _e500);
                            let _e514 = (_e502 * _e513);
                            let _e516 = (((_e498 < 2048u) && (_e494.member_2 < 340282350000000000000000000000000000000f)) && (_e514 >= 0.001f));
                            local_9 = _e514;
                            local_10 = _e514;
                            local_11 = _e514;
                            if _e516 {
                                let _e518 = (_e496 == 0u);
                                let _e520 = (_e496 == 2u);
                                let _e523 = select(select(_e385, _e384, _e518), _e386, _e520);
                                let _e534 = (_e523 < 0f);
                                let _e538 = params.member.member_2[_e494.member];
                                let _e539 = (_e494.member & 31u);
                                let _e541 = (1u << bitcast<u32>(_e539));
                                let _e542 = (_e541 - 1u);
                                let _e545 = ((_e389.x + _e542) >> bitcast<u32>(_e539));
                                let _e548 = ((_e389.y + _e542) >> bitcast<u32>(_e539));
                                let _e551 = ((_e389.z + _e542) >> bitcast<u32>(_e539));
                                if ((_e494.member_1 < 0i) || (_e494.member_1 >= bitcast<i32>(select(select(_e548, _e545, _e518), _e551, _e520)))) {
                                    phi_1533_ = vec4<f32>(0f, 0f, 0f, 0f);
                                } else {
                                    let _e559 = (1f / f32(_e541));
                                    let _e561 = (((_e149 + (_e384 * _e494.member_2)) * _e559) - 0.5f);
                                    let _e563 = (((_e150 + (_e385 * _e494.member_2)) * _e559) - 0.5f);
                                    let _e565 = (((_e151 + (_e386 * _e494.member_2)) * _e559) - 0.5f);
                                    let _e566 = bitcast<u32>(_e494.member_1);
                                    let _e591 = select(select(_e565, _e563, _e518), _e561, _e520);
                                    let _e595 = select(select(1u, 2u, _e518), 2u, _e520);
                                    let _e597 = select(select(_e538.y, _e538.x, _e518), 1u, _e520);
                                    let _e598 = select(2u, 1u, _e518);
                                    let _e599 = select(_e598, 0u, _e520);
                                    let _e600 = floor(_e591);
                                    let _e602 = i32(_e600);
                                    let _e604 = (bitcast<i32>(select(select(_e551, _e548, _e518), _e545, _e520)) - 1i);
                                    let _e609 = ((_e591 >= -0.5f) && (_e591 <= (f32(_e604) + 0.5f)));
                                    let _e611 = select(0i, _e602, (0i < _e602));
                                    let _e614 = bitcast<u32>(select(_e611, _e604, (_e604 < _e611)));
                                    let _e615 = (_e602 + 1i);
                                    let _e617 = select(0i, _e615, (0i < _e615));
                                    let _e620 = bitcast<u32>(select(_e617, _e604, (_e604 < _e617)));
                                    let _e624 = select(select(0f, (_e591 - _e600), (_e602 < _e604)), 1f, (_e602 < 0i));
                                    let _e625 = (_e595 & 31u);
                                    let _e633 = (_e599 & 31u);
                                    let _e638 = (_e595 - 1u);
                                    let _e641 = ((_e599 + 3u) & 31u);
                                    if _e609 {
                                        phi_1005_ = (1f - _e624);
                                    } else {
                                        phi_1005_ = 0f;
                                    }
                                    let _e656 = phi_1005_;
                                    let _e659 = select(select(_e561, _e565, _e518), _e563, _e520);
                                    let _e662 = select(_e598, 2u, _e520);
                                    let _e664 = select(select(1u, _e538.y, _e518), _e538.x, _e520);
                                    let _e666 = select(select(0u, 2u, _e518), 1u, _e520);
                                    let _e667 = floor(_e659);
                                    let _e669 = i32(_e667);
                                    let _e671 = (bitcast<i32>(select(select(_e545, _e551, _e518), _e548, _e520)) - 1i);
                                    let _e676 = ((_e659 >= -0.5f) && (_e659 <= (f32(_e671) + 0.5f)));
                                    let _e678 = select(0i, _e669, (0i < _e669));
                                    let _e681 = bitcast<u32>(select(_e678, _e671, (_e671 < _e678)));
                                    let _e682 = (_e669 + 1i);
                                    let _e684 = select(0i, _e682, (0i < _e682));
                                    let _e687 = bitcast<u32>(select(_e684, _e671, (_e671 < _e684)));
                                    let _e691 = select(select(0f, (_e659 - _e667), (_e669 < _e671)), 1f, (_e669 < 0i));
                                    let _e692 = (_e662 & 31u);
                                    let _e700 = (_e666 & 31u);
                                    let _e705 = (_e662 - 1u);
                                    let _e708 = ((_e666 + 3u) & 31u);
                                    if _e676 {
                                        phi_1135_ = (1f - _e691);
                                    } else {
                                        phi_1135_ = 0f;
                                    }
                                    let _e723 = phi_1135_;
                                    phi_1141_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    phi_1144_ = 0u;
                                    loop {
                                        let _e726 = phi_1141_;
                                        let _e728 = phi_1144_;
                                        let _e730 = ((_e728 & 1u) == 1u);
                                        let _e732 = ((_e728 & 2u) == 2u);
                                        let _e735 = (select(_e656, select(0f, _e624, _e609), _e730) * select(_e723, select(0f, _e691, _e676), _e732));
                                        let _e741 = (((_e538.z + ((_e566 >> bitcast<u32>((select(2i, 1i, _e520) & 31i))) * select(select(_e538.x, 1u, _e518), _e538.y, _e520))) + select(((_e614 >> bitcast<u32>(_e625)) * _e597), ((_e620 >> bitcast<u32>(_e625)) * _e597), _e730)) + select(((_e681 >> bitcast<u32>(_e692)) * _e664), ((_e687 >> bitcast<u32>(_e692)) * _e664), _e732));
                                        let _e746 = (2u * _e741);
                                        let _e748 = cells.member[_e746];
                                        let _e750 = ((((((_e566 & 1u) << bitcast<u32>((_e496 & 31u))) | (((_e566 >> bitcast<u32>(1i)) & (select(2u, 1u, _e520) - 1u)) << bitcast<u32>(((_e496 + 3u) & 31u)))) | select((((_e614 & 1u) << bitcast<u32>(_e633)) | (((_e614 >> bitcast<u32>(1i)) & _e638) << bitcast<u32>(_e641))), (((_e620 & 1u) << bitcast<u32>(_e633)) | (((_e620 >> bitcast<u32>(1i)) & _e638) << bitcast<u32>(_e641))), _e730)) | select((((_e681 & 1u) << bitcast<u32>(_e700)) | (((_e681 >> bitcast<u32>(1i)) & _e705) << bitcast<u32>(_e708))), (((_e687 & 1u) << bitcast<u32>(_e700)) | (((_e687 >> bitcast<u32>(1i)) & _e705) << bitcast<u32>(_e708))), _e732)) & 31u);
                                        if ((_e735 > 0f) && (((_e748 >> bitcast<u32>(_e750)) & 1u) == 1u)) {
                                            let _e758 = params.member.member_8;
                                            let _e759 = (_e758 == 1u);
                                            if (_e494.member == 0u) {
                                                let _e785 = (_e741 * 6u);
                                                let _e788 = cells.member[(_e746 + 1u)];
                                                let _e790 = facet_bits.member[_e785];
                                                let _e793 = ((1u << bitcast<u32>(_e750)) - 1u);
                                                let _e802 = facet_bits.member[(_e785 + 1u)];
                                                let _e812 = facet_bits.member[(_e785 + 2u)];
                                                let _e822 = facet_bits.member[(_e785 + 3u)];
                                                let _e832 = facet_bits.member[(_e785 + 4u)];
                                                let _e842 = facet_bits.member[(_e785 + 5u)];
                                                let _e845 = ((((((_e788 + countOneBits((_e790 & _e793))) + countOneBits((_e802 & _e793))) + countOneBits((_e812 & _e793))) + countOneBits((_e822 & _e793))) + countOneBits((_e832 & _e793))) + countOneBits((_e842 & _e793)));
                                                let _e850 = select(1f, -1f, _e534);
                                                phi_1310_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                phi_1313_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                phi_1315_ = _e845;
                                                loop {
                                                    let _e856 = phi_1310_;
                                                    let _e858 = phi_1313_;
                                                    let _e860 = phi_1315_;
                                                    let _e863 = facets.member[_e860].member_2;
                                                    let _e867 = (2u * _e860);
                                                    let _e869 = radiance.member[_e867];
                                                    let _e872 = radiance.member[(_e867 + 1u)];
                                                    let _e877 = (((select(0f, _e850, _e518) * _e863[0]) + (select(0f, _e850, (_e496 == 1u)) * _e863[1])) + (select(0f, _e850, _e520) * _e863[2]));
                                                    let _e878 = -(_e877);
                                                    if _e759 {
                                                        let _e930 = sqrt((((_e863[0] * _e863[0]) + (_e863[1] * _e863[1])) + (_e863[2] * _e863[2])));
                                                        phi_1311_ = _e856;
                                                        phi_1314_ = vec4<f32>((_e858.x + (select(_e872.x, _e869.x, (_e869.x > _e872.x)) * _e930)), (_e858.y + (select(_e872.y, _e869.y, (_e869.y > _e872.y)) * _e930)), (_e858.z + (select(_e872.z, _e869.z, (_e869.z > _e872.z)) * _e930)), (_e858.w + _e930));
                                                    } else {
                                                        let _e883 = select(0f, _e878, (_e878 > 0f));
                                                        let _e900 = select(0f, _e877, (_e877 > 0f));
                                                        phi_1311_ = vec4<f32>((_e856.x + (_e872.x * _e900)), (_e856.y + (_e872.y * _e900)), (_e856.z + (_e872.z * _e900)), (_e856.w + _e900));
                                                        phi_1314_ = vec4<f32>((_e858.x + (_e869.x * _e883)), (_e858.y + (_e869.y * _e883)), (_e858.z + (_e869.z * _e883)), (_e858.w + _e883));
                                                    }
                                                    let _e944 = phi_1311_;
                                                    let _e946 = phi_1314_;
                                                    let _e947 = (_e860 + 1u);
                                                    local = _e944;
                                                    local_1 = _e946;
                                                    local_2 = _e944;
                                                    local_3 = _e944;
                                                    local_4 = _e944;
                                                    local_5 = _e946;
                                                    local_15 = _e946;
                                                    continue;
                                                    continuing {
                                                        phi_1310_ = _e944;
                                                        phi_1313_ = _e946;
                                                        phi_1315_ = _e947;
                                                        break if !(select(true, false, (_e947 >= (_e845 + (((((((_e790 >> bitcast<u32>(_e750)) & 1u) + ((_e802 >> bitcast<u32>(_e750)) & 1u)) + ((_e812 >> bitcast<u32>(_e750)) & 1u)) + ((_e822 >> bitcast<u32>(_e750)) & 1u)) + ((_e832 >> bitcast<u32>(_e750)) & 1u)) + ((_e842 >> bitcast<u32>(_e750)) & 1u))))));
                                                    }
                                                }
                                                let _e953 = local;
                                                let _e956 = local_1;
                                                if (_e953.w > _e956.w) {
                                                    let _e959 = (_e953.w - _e956.w);
                                                    let _e960 = (_e959 / _e953.w);
                                                    let _e962 = local_2;
                                                    let _e966 = local_3;
                                                    let _e970 = local_4;
                                                    let _e975 = local_5;
                                                    phi_1460_ = (_e975 + vec4<f32>((_e962.x * _e960), (_e966.y * _e960), (_e970.z * _e960), _e959));
                                                } else {
                                                    let _e1267 = local_15;
                                                    phi_1460_ = _e1267;
                                                }
                                                let _e978 = phi_1460_;
                                                if (_e978.w > 1f) {
                                                    phi_1474_ = vec4<f32>((_e978.x / _e978.w), (_e978.y / _e978.w), (_e978.z / _e978.w), 1f);
                                                } else {
                                                    phi_1474_ = _e978;
                                                }
                                                let _e989 = phi_1474_;
                                                phi_1507_ = _e989;
                                            } else {
                                                let _e763 = cells.member[(_e746 + 1u)];
                                                let _e769 = (_e763 + countOneBits((_e748 & ((1u << bitcast<u32>(_e750)) - 1u))));
                                                if _e759 {
                                                    phi_1494_ = _e769;
                                                } else {
                                                    phi_1494_ = (((6u * _e769) + (2u * _e496)) + select(0u, 1u, _e534));
                                                }
                                                let _e776 = phi_1494_;
                                                if ((_e494.member & 1u) == 1u) {
                                                    let _e782 = odd.member[_e776];
                                                    phi_1506_ = _e782;
                                                } else {
                                                    let _e780 = even.member[_e776];
                                                    phi_1506_ = _e780;
                                                }
                                                let _e784 = phi_1506_;
                                                phi_1507_ = _e784;
                                            }
                                            let _e991 = phi_1507_;
                                            phi_1142_ = vec4<f32>((_e726.x + (_e991.x * _e735)), (_e726.y + (_e991.y * _e735)), (_e726.z + (_e991.z * _e735)), (_e726.w + (_e991.w * _e735)));
                                        } else {
                                            phi_1142_ = _e726;
                                        }
                                        let _e1010 = phi_1142_;
                                        let _e1011 = (_e728 + 1u);
                                        local_16 = _e1010;
                                        continue;
                                        continuing {
                                            phi_1141_ = _e1010;
                                            phi_1144_ = _e1011;
                                            break if !(select(true, false, (_e1011 == 4u)));
                                        }
                                    }
                                    let _e1273 = local_16;
                                    phi_1533_ = _e1273;
                                }
                                let _e1016 = phi_1533_;
                                if (_e1016.w > 0f) {
                                    let _e1023 = select(_e513, _e1016.w, (_e1016.w < _e513));
                                    let _e1028 = ((_e502 * _e1023) / _e1016.w);
                                    phi_1573_ = vec3<f32>((_e492.x + (_e1016.x * _e1028)), (_e492.y + (_e1016.y * _e1028)), (_e492.z + (_e1016.z * _e1028)));
                                    phi_1574_ = (_e500 + _e1023);
                                    phi_1575_ = _e502;
                                } else {
                                    let _e1019 = (_e496 == _e401);
                                    phi_1573_ = _e492;
                                    phi_1574_ = select(_e500, 0f, _e1019);
                                    phi_1575_ = select(_e502, _e514, _e1019);
                                }
                                let _e1041 = phi_1573_;
                                let _e1043 = phi_1574_;
                                let _e1045 = phi_1575_;
                                let _e1046 = (_e363 * _e494.member_2);
                                let _e1048 = ((_e366 * _e142) + ((_e366 * _e360.z) * _e494.member_2));
                                let _e1050 = select(_e1048, _e1046, (_e1046 < _e1048));
                                let _e1057 = ((bitcast<u32>((select(1f, _e1050, (_e1050 > 1f)) * _e358)) >> bitcast<u32>(23i)) - 127u);
                                let _e1059 = (_e389.w - 1u);
                                let _e1067 = select(0u, 1u, ((((_e494.member_1 & 1i) == 0i) == _e534) && (select(_e1057, _e1059, (_e1059 < _e1057)) > _e494.member)));
                                if _e534 {
                                    phi_1617_ = (_e494.member_1 - 1i);
                                } else {
                                    phi_1617_ = (_e494.member_1 + 1i);
                                }
                                let _e1071 = phi_1617_;
                                let _e1072 = (_e494.member + _e1067);
                                let _e1075 = (_e1071 >> bitcast<u32>((_e1067 & 31u)));
                                let _e1076 = (_e1072 & 31u);
                                let _e1078 = (1u << bitcast<u32>(_e1076));
                                if _e534 {
                                    phi_1635_ = (_e1075 < 0i);
                                } else {
                                    phi_1635_ = (_e1075 >= bitcast<i32>((((select(select(_e389.y, _e389.x, _e518), _e389.z, _e520) + _e1078) - 1u) >> bitcast<u32>(_e1076))));
                                }
                                let _e1087 = phi_1635_;
                                let _e1097 = select(((((f32(_e1075) + 0.5f) * f32(_e1078)) - select(select(_e150, _e149, _e518), _e151, _e520)) / _e523), 340282350000000000000000000000000000000f, (_e1087 || (abs(_e523) < 0.000001f)));
                                if _e518 {
                                    phi_1656_ = _e1072;
                                } else {
                                    phi_1656_ = _e508.member;
                                }
                                let _e1100 = phi_1656_;
                                if _e518 {
                                    phi_1661_ = _e1075;
                                } else {
                                    phi_1661_ = _e508.member_1;
                                }
                                let _e1103 = phi_1661_;
                                if _e518 {
                                    phi_1666_ = _e1097;
                                } else {
                                    phi_1666_ = _e508.member_2;
                                }
                                let _e1106 = phi_1666_;
                                let _e1108 = (_e496 == 1u);
                                if _e1108 {
                                    phi_1673_ = _e1072;
                                } else {
                                    phi_1673_ = _e506.member;
                                }
                                let _e1111 = phi_1673_;
                                if _e1108 {
                                    phi_1678_ = _e1075;
                                } else {
                                    phi_1678_ = _e506.member_1;
                                }
                                let _e1114 = phi_1678_;
                                if _e1108 {
                                    phi_1683_ = _e1097;
                                } else {
                                    phi_1683_ = _e506.member_2;
                                }
                                let _e1117 = phi_1683_;
                                if _e520 {
                                    phi_1690_ = _e1072;
                                } else {
                                    phi_1690_ = _e504.member;
                                }
                                let _e1121 = phi_1690_;
                                if _e520 {
                                    phi_1695_ = _e1075;
                                } else {
                                    phi_1695_ = _e504.member_1;
                                }
                                let _e1124 = phi_1695_;
                                if _e520 {
                                    phi_1700_ = _e1097;
                                } else {
                                    phi_1700_ = _e504.member_2;
                                }
                                let _e1127 = phi_1700_;
                                let _e1131 = ((_e1106 <= _e1117) && (_e1106 <= _e1127));
                                let _e1132 = (_e1117 <= _e1127);
                                phi_721_ = _e1041;
                                phi_724_ = type_37(select(select(_e1121, _e1111, _e1132), _e1100, _e1131), select(select(_e1124, _e1114, _e1132), _e1103, _e1131), select(select(_e1127, _e1117, _e1132), _e1106, _e1131));
                                phi_726_ = select(select(2u, 1u, _e1132), 0u, _e1131);
                                phi_728_ = (_e498 + 1u);
                                phi_730_ = _e1043;
                                phi_732_ = _e1045;
                                phi_734_ = type_37(_e1121, _e1124, _e1127);
                                phi_736_ = type_37(_e1111, _e1114, _e1117);
                                phi_738_ = type_37(_e1100, _e1103, _e1106);
                            } else {
                                phi_721_ = vec3<f32>();
                                phi_724_ = type_37();
                                phi_726_ = u32();
                                phi_728_ = u32();
                                phi_730_ = f32();
                                phi_732_ = f32();
                                phi_734_ = type_37();
                                phi_736_ = type_37();
                                phi_738_ = type_37();
                            }
                            let _e1143 = phi_721_;
                            let _e1145 = phi_724_;
                            let _e1147 = phi_726_;
                            let _e1149 = phi_728_;
                            let _e1151 = phi_730_;
                            let _e1153 = phi_732_;
                            let _e1155 = phi_734_;
                            let _e1157 = phi_736_;
                            let _e1159 = phi_738_;
                            continue;
                            continuing {
                                phi_720_ = _e1143;
                                phi_723_ = _e1145;
                                phi_725_ = _e1147;
                                phi_727_ = _e1149;
                                phi_729_ = _e1151;
                                phi_731_ = _e1153;
                                phi_733_ = _e1155;
                                phi_735_ = _e1157;
                                phi_737_ = _e1159;
                                break if !(_e516);
                            }
                        }
                        let _e1162 = local_6;
                        let _e1165 = local_7;
                        let _e1168 = local_8;
                        let _e1172 = params.member.member_5;
                        let _e1177 = local_9;
                        let _e1180 = local_10;
                        let _e1183 = local_11;
                        phi_309_ = vec3<f32>((_e211.x + ((_e1162.x + (_e1172.x * _e1177)) * _e235.w)), (_e211.y + ((_e1165.y + (_e1172.y * _e1180)) * _e235.w)), (_e211.z + ((_e1168.z + (_e1172.z * _e1183)) * _e235.w)));
                    } else {
                        phi_309_ = vec3<f32>();
                    }
                    let _e1200 = phi_309_;
                    continue;
                    continuing {
                        phi_305_ = _e224;
                        phi_308_ = _e1200;
                        phi_1830_ = false;
                        break if !(_e230);
                    }
                }
                let _e1203 = phi_1830_;
                if _e1203 {
                    break;
                }
                let _e1205 = local_12;
                let _e1209 = local_13;
                let _e1213 = local_14;
                if (_e94 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e94] = vec4<f32>((_e1205.x * 3.1415927f), (_e1209.y * 3.1415927f), (_e1213.z * 3.1415927f), 0f);
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
