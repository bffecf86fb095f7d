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
    var phi_191_: vec3<f32>;
    var phi_198_: vec3<f32>;
    var phi_301_: f32;
    var phi_306_: type_12;
    var phi_309_: vec3<f32>;
    var phi_307_: type_12;
    var phi_332_: type_12;
    var phi_470_: f32;
    var phi_478_: f32;
    var phi_491_: f32;
    var phi_492_: vec3<f32>;
    var phi_539_: bool;
    var phi_548_: u32;
    var phi_566_: i32;
    var phi_580_: bool;
    var phi_611_: i32;
    var phi_625_: bool;
    var phi_656_: i32;
    var phi_670_: bool;
    var phi_721_: vec3<f32>;
    var phi_724_: type_37;
    var phi_726_: u32;
    var phi_728_: u32;
    var phi_730_: f32;
    var phi_732_: f32;
    var phi_734_: type_37;
    var phi_736_: type_37;
    var phi_738_: type_37;
    var phi_1006_: f32;
    var phi_1136_: f32;
    var phi_1142_: vec4<f32>;
    var phi_1145_: u32;
    var phi_1505_: u32;
    var phi_1517_: vec4<f32>;
    var phi_1311_: vec4<f32>;
    var phi_1314_: vec4<f32>;
    var phi_1316_: u32;
    var phi_1312_: vec4<f32>;
    var phi_1315_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_1518_: vec4<f32>;
    var phi_1143_: vec4<f32>;
    var phi_1544_: vec4<f32>;
    var phi_1584_: vec3<f32>;
    var phi_1585_: f32;
    var phi_1586_: f32;
    var phi_1628_: i32;
    var phi_1646_: bool;
    var phi_1667_: u32;
    var phi_1672_: i32;
    var phi_1677_: f32;
    var phi_1684_: u32;
    var phi_1689_: i32;
    var phi_1694_: f32;
    var phi_1701_: u32;
    var phi_1706_: i32;
    var phi_1711_: f32;
    var phi_722_: vec3<f32>;
    var phi_725_: type_37;
    var phi_727_: u32;
    var phi_729_: u32;
    var phi_731_: f32;
    var phi_733_: f32;
    var phi_735_: type_37;
    var phi_737_: type_37;
    var phi_739_: type_37;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var local_11: f32;
    var local_12: f32;
    var local_13: f32;
    var phi_310_: vec3<f32>;
    var phi_1841_: bool;
    var local_14: vec3<f32>;
    var local_15: vec3<f32>;
    var local_16: vec3<f32>;
    var local_17: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = gid_1;
            let _e91 = params.member.member_9;
            let _e95 = (_e78.x + (_e78.y * 2097152u));
            if (_e95 < _e91) {
                let _e97 = (_e95 / 2u);
                if (_e97 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e101 = facets.member[_e97];
                let _e111 = sqrt((((_e101.member_2[0] * _e101.member_2[0]) + (_e101.member_2[1] * _e101.member_2[1])) + (_e101.member_2[2] * _e101.member_2[2])));
                if (_e111 > 0.000000000001f) {
                    phi_191_ = vec3<f32>((_e101.member_2[0] / _e111), (_e101.member_2[1] / _e111), (_e101.member_2[2] / _e111));
                } else {
                    phi_191_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e118 = phi_191_;
                if ((_e95 & 1u) == 0u) {
                    phi_198_ = _e118;
                } else {
                    phi_198_ = -(_e118);
                }
                let _e123 = phi_198_;
                let _e130 = params.member.member;
                let _e143 = params.member.member_12;
                let _e150 = (((_e101.member[0] - _e130.x) / _e130.w) + (_e123.x * _e143));
                let _e151 = (((_e101.member[1] - _e130.y) / _e130.w) + (_e123.y * _e143));
                let _e152 = (((_e101.member[2] - _e130.z) / _e130.w) + (_e123.z * _e143));
                let _e156 = bitcast<f32>((1065353216u | (bitcast<u32>(_e123.z) & 2147483648u)));
                let _e158 = (-1f / (_e156 + _e123.z));
                let _e160 = ((_e123.x * _e123.y) * _e158);
                let _e174 = params.member.member_10;
                let _e175 = (_e174 == 0u);
                if _e175 {
                    phi_301_ = 0f;
                } else {
                    let _e179 = ((_e95 * 1664525u) + 1013904223u);
                    let _e181 = (((_e174 * 1664525u) + 1013904223u) + (_e179 * 1013904223u));
                    let _e183 = (_e179 + (1013904223u * _e181));
                    let _e187 = (1013904223u + (_e183 * (1013904223u + (_e181 * _e183))));
                    phi_301_ = (f32((((_e181 ^ (_e181 >> bitcast<u32>(16i))) + ((_e183 ^ (_e183 >> bitcast<u32>(16i))) * (_e187 ^ (_e187 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                }
                let _e204 = phi_301_;
                let _e207 = params.member.member_7;
                phi_306_ = type_12(0u, _e207);
                phi_309_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e210 = phi_306_;
                    let _e212 = phi_309_;
                    local_14 = _e212;
                    local_15 = _e212;
                    local_16 = _e212;
                    if (_e210.member < _e210.member_1) {
                        phi_307_ = type_12((_e210.member + 1u), _e210.member_1);
                        phi_332_ = type_12(1u, _e210.member);
                    } else {
                        phi_307_ = _e210;
                        phi_332_ = type_12(0u, type_12().member_1);
                    }
                    let _e225 = phi_307_;
                    let _e227 = phi_332_;
                    let _e231 = (bitcast<i32>(_e227.member) != 0i);
                    if _e231 {
                        let _e232 = (_e227.member_1 < 16u);
                        if _e232 {
                        } else {
                            phi_1841_ = true;
                            break;
                        }
                        let _e236 = params.member.member_3[_e227.member_1];
                        if _e175 {
                            phi_491_ = 1.4142135f;
                            phi_492_ = vec3<f32>(_e236.x, _e236.y, _e236.z);
                        } else {
                            let _e241 = ((_e95 * 1664525u) + 1013904223u);
                            let _e243 = (((1u + _e227.member_1) * 1664525u) + 1013904223u);
                            let _e245 = (((_e174 * 1664525u) + 1013904223u) + (_e241 * 1013904223u));
                            let _e247 = (_e241 + (_e243 * _e245));
                            let _e249 = (_e243 + (_e245 * _e247));
                            let _e251 = (1013904223u + (_e247 * _e249));
                            let _e257 = (_e247 ^ (_e247 >> bitcast<u32>(16i)));
                            let _e260 = (_e249 ^ (_e249 >> bitcast<u32>(16i)));
                            let _e265 = ((_e245 ^ (_e245 >> bitcast<u32>(16i))) + (_e257 * (_e251 ^ (_e251 >> bitcast<u32>(16i)))));
                            let _e267 = (_e257 + (_e260 * _e265));
                            if _e232 {
                            } else {
                                phi_1841_ = true;
                                break;
                            }
                            let _e285 = params.member.member_4[_e227.member_1];
                            let _e290 = (_e285.y + ((_e285.x - _e285.y) * (f32((_e265 >> bitcast<u32>(8i))) * 0.000000059604645f)));
                            let _e295 = ((_e285.z + (_e285.w * (f32((_e267 >> bitcast<u32>(8i))) * 0.000000059604645f))) + _e204);
                            let _e299 = floor(((_e295 * 4f) + 0.5f));
                            let _e305 = ((((6.2831855f * _e295) - (_e299 * 1.5703125f)) - (_e299 * 0.0004837513f)) - (_e299 * 0.0000000754979f));
                            let _e306 = (_e305 * _e305);
                            let _e313 = (_e305 + ((_e305 * _e306) * (-0.16666655f + (_e306 * (0.008332161f + (_e306 * -0.00019515296f))))));
                            let _e322 = ((1f - (0.5f * _e306)) + ((_e306 * _e306) * (0.041666646f + (_e306 * (-0.0013887316f + (_e306 * 0.000024433157f))))));
                            let _e329 = select(0i, select(select(i32(_e299), i32(-2147483648), (_e299 < -2147483600f)), 2147483647i, (_e299 > 2147483500f)), (_e299 == _e299));
                            let _e331 = ((_e329 & 1i) == 0i);
                            let _e332 = select(_e322, _e313, _e331);
                            let _e333 = select(_e313, _e322, _e331);
                            if ((_e329 & 2i) == 0i) {
                                phi_470_ = _e332;
                            } else {
                                phi_470_ = -(_e332);
                            }
                            let _e338 = phi_470_;
                            if (((_e329 + 1i) & 2i) == 0i) {
                                phi_478_ = _e333;
                            } else {
                                phi_478_ = -(_e333);
                            }
                            let _e344 = phi_478_;
                            let _e345 = (1f - _e290);
                            let _e348 = sqrt(select(0f, _e345, (_e345 > 0f)));
                            phi_491_ = (1f + (f32(((_e260 + (_e265 * _e267)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                            phi_492_ = vec3<f32>((_e348 * _e344), (_e348 * _e338), sqrt(_e290));
                        }
                        let _e359 = phi_491_;
                        let _e361 = phi_492_;
                        let _e364 = params.member.member_11;
                        let _e367 = params.member.member_13;
                        let _e385 = ((((1f + (((_e156 * _e123.x) * _e123.x) * _e158)) * _e361.x) + (_e160 * _e361.y)) + (_e123.x * _e361.z));
                        let _e386 = ((((_e156 * _e160) * _e361.x) + ((_e156 + ((_e123.y * _e123.y) * _e158)) * _e361.y)) + (_e123.y * _e361.z));
                        let _e387 = ((((-(_e156) * _e123.x) * _e361.x) + (-(_e123.y) * _e361.y)) + (_e123.z * _e361.z));
                        let _e390 = params.member.member_1;
                        let _e391 = abs(_e385);
                        let _e392 = abs(_e386);
                        let _e393 = abs(_e387);
                        if (_e391 >= _e392) {
                            phi_539_ = select(true, false, (_e391 >= _e393));
                        } else {
                            phi_539_ = true;
                        }
                        let _e398 = phi_539_;
                        if _e398 {
                            phi_548_ = select(2u, 1u, (_e392 >= _e393));
                        } else {
                            phi_548_ = 0u;
                        }
                        let _e402 = phi_548_;
                        let _e413 = (_e385 < 0f);
                        if _e413 {
                            phi_566_ = (i32(-(floor((0.5f - _e150)))) - 1i);
                        } else {
                            phi_566_ = (i32(floor((_e150 - 0.5f))) + 1i);
                        }
                        let _e417 = phi_566_;
                        if _e413 {
                            phi_580_ = (_e417 < 0i);
                        } else {
                            phi_580_ = (_e417 >= bitcast<i32>(_e390.x));
                        }
                        let _e422 = phi_580_;
                        let _e429 = select((((f32(_e417) + 0.5f) - _e150) / _e385), 340282350000000000000000000000000000000f, (_e422 || (_e391 < 0.000001f)));
                        let _e438 = (_e386 < 0f);
                        if _e438 {
                            phi_611_ = (i32(-(floor((0.5f - _e151)))) - 1i);
                        } else {
                            phi_611_ = (i32(floor((_e151 - 0.5f))) + 1i);
                        }
                        let _e442 = phi_611_;
                        if _e438 {
                            phi_625_ = (_e442 < 0i);
                        } else {
                            phi_625_ = (_e442 >= bitcast<i32>(_e390.y));
                        }
                        let _e447 = phi_625_;
                        let _e454 = select((((f32(_e442) + 0.5f) - _e151) / _e386), 340282350000000000000000000000000000000f, (_e447 || (_e392 < 0.000001f)));
                        let _e463 = (_e387 < 0f);
                        if _e463 {
                            phi_656_ = (i32(-(floor((0.5f - _e152)))) - 1i);
                        } else {
                            phi_656_ = (i32(floor((_e152 - 0.5f))) + 1i);
                        }
                        let _e467 = phi_656_;
                        if _e463 {
                            phi_670_ = (_e467 < 0i);
                        } else {
                            phi_670_ = (_e467 >= bitcast<i32>(_e390.z));
                        }
                        let _e472 = phi_670_;
                        let _e479 = select((((f32(_e467) + 0.5f) - _e152) / _e387), 340282350000000000000000000000000000000f, (_e472 || (_e393 < 0.000001f)));
                        let _e483 = ((_e429 <= _e454) && (_e429 <= _e479));
                        let _e484 = (_e454 <= _e479);
                        phi_721_ = vec3<f32>(0f, 0f, 0f);
                        phi_724_ = type_37(0u, select(select(_e467, _e442, _e484), _e417, _e483), select(select(_e479, _e454, _e484), _e429, _e483));
                        phi_726_ = select(select(2u, 1u, _e484), 0u, _e483);
                        phi_728_ = 0u;
                        phi_730_ = 0f;
                        phi_732_ = 1f;
                        phi_734_ = type_37(0u, _e467, _e479);
                        phi_736_ = type_37(0u, _e442, _e454);
                        phi_738_ = type_37(0u, _e417, _e429);
                        loop {
                            let _e493 = phi_721_;
                            let _e495 = phi_724_;
                            let _e497 = phi_726_;
                            let _e499 = phi_728_;
                            let _e501 = phi_730_;
                            let _e503 = phi_732_;
                            let _e505 = phi_734_;
                            let _e507 = phi_736_;
                            let _e509 = phi_738_;
                            local_8 = _e493;
                            local_9 = _e493;
                            local_10 = _e493;
                            let _e514 = (1f - _e501);
                            let _e515 = (_e503 * _e514);
                            let _e517 = (((_e499 < 2048u) && (_e495.member_2 < 340282350000000000000000000000000000000f)) && (_e515 >= 0.001f));
                            local_11 = _e515;
                            local_12 = _e515;
                            local_13 = _e515;
                            if _e517 {
                                let _e519 = (_e497 == 0u);
                                let _e521 = (_e497 == 2u);
                                let _e524 = select(select(_e386, _e385, _e519), _e387, _e521);
                                let _e535 = (_e524 < 0f);
                                let _e539 = params.member.member_2[_e495.member];
                                let _e540 = (_e495.member & 31u);
                                let _e542 = (1u << bitcast<u32>(_e540));
                                let _e543 = (_e542 - 1u);
                                let _e546 = ((_e390.x + _e543) >> bitcast<u32>(_e540));
                                let _e549 = ((_e390.y + _e543) >> bitcast<u32>(_e540));
                                let _e552 = ((_e390.z + _e543) >> bitcast<u32>(_e540));
                                if ((_e495.member_1 < 0i) || (_e495.member_1 >= bitcast<i32>(select(select(_e549, _e546, _e519), _e552, _e521)))) {
                                    phi_1544_ = vec4<f32>(0f, 0f, 0f, 0f);
                                } else {
                                    let _e560 = (1f / f32(_e542));
                                    let _e562 = (((_e150 + (_e385 * _e495.member_2)) * _e560) - 0.5f);
                                    let _e564 = (((_e151 + (_e386 * _e495.member_2)) * _e560) - 0.5f);
                                    let _e566 = (((_e152 + (_e387 * _e495.member_2)) * _e560) - 0.5f);
                                    let _e567 = bitcast<u32>(_e495.member_1);
                                    let _e592 = select(select(_e566, _e564, _e519), _e562, _e521);
                                    let _e596 = select(select(1u, 2u, _e519), 2u, _e521);
                                    let _e598 = select(select(_e539.y, _e539.x, _e519), 1u, _e521);
                                    let _e599 = select(2u, 1u, _e519);
                                    let _e600 = select(_e599, 0u, _e521);
                                    let _e601 = floor(_e592);
                                    let _e603 = i32(_e601);
                                    let _e605 = (bitcast<i32>(select(select(_e552, _e549, _e519), _e546, _e521)) - 1i);
                                    let _e610 = ((_e592 >= -0.5f) && (_e592 <= (f32(_e605) + 0.5f)));
                                    let _e612 = select(0i, _e603, (0i < _e603));
                                    let _e615 = bitcast<u32>(select(_e612, _e605, (_e605 < _e612)));
                                    let _e616 = (_e603 + 1i);
                                    let _e618 = select(0i, _e616, (0i < _e616));
                                    let _e621 = bitcast<u32>(select(_e618, _e605, (_e605 < _e618)));
                                    let _e625 = select(select(0f, (_e592 - _e601), (_e603 < _e605)), 1f, (_e603 < 0i));
                                    let _e626 = (_e596 & 31u);
                                    let _e634 = (_e600 & 31u);
                                    let _e639 = (_e596 - 1u);
                                    let _e642 = ((_e600 + 3u) & 31u);
                                    if _e610 {
                                        phi_1006_ = (1f - _e625);
                                    } else {
                                        phi_1006_ = 0f;
                                    }
                                    let _e657 = phi_1006_;
                                    let _e660 = select(select(_e562, _e566, _e519), _e564, _e521);
                                    let _e663 = select(_e599, 2u, _e521);
                                    let _e665 = select(select(1u, _e539.y, _e519), _e539.x, _e521);
                                    let _e667 = select(select(0u, 2u, _e519), 1u, _e521);
                                    let _e668 = floor(_e660);
                                    let _e670 = i32(_e668);
                                    let _e672 = (bitcast<i32>(select(select(_e546, _e552, _e519), _e549, _e521)) - 1i);
                                    let _e677 = ((_e660 >= -0.5f) && (_e660 <= (f32(_e672) + 0.5f)));
                                    let _e679 = select(0i, _e670, (0i < _e670));
                                    let _e682 = bitcast<u32>(select(_e679, _e672, (_e672 < _e679)));
                                    let _e683 = (_e670 + 1i);
                                    let _e685 = select(0i, _e683, (0i < _e683));
                                    let _e688 = bitcast<u32>(select(_e685, _e672, (_e672 < _e685)));
                                    let _e692 = select(select(0f, (_e660 - _e668), (_e670 < _e672)), 1f, (_e670 < 0i));
                                    let _e693 = (_e663 & 31u);
                                    let _e701 = (_e667 & 31u);
                                    let _e706 = (_e663 - 1u);
                                    let _e709 = ((_e667 + 3u) & 31u);
                                    if _e677 {
                                        phi_1136_ = (1f - _e692);
                                    } else {
                                        phi_1136_ = 0f;
                                    }
                                    let _e724 = phi_1136_;
                                    phi_1142_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    phi_1145_ = 0u;
                                    loop {
                                        let _e727 = phi_1142_;
                                        let _e729 = phi_1145_;
                                        let _e731 = ((_e729 & 1u) == 1u);
                                        let _e733 = ((_e729 & 2u) == 2u);
                                        let _e736 = (select(_e657, select(0f, _e625, _e610), _e731) * select(_e724, select(0f, _e692, _e677), _e733));
                                        let _e742 = (((_e539.z + ((_e567 >> bitcast<u32>((select(2i, 1i, _e521) & 31i))) * select(select(_e539.x, 1u, _e519), _e539.y, _e521))) + select(((_e615 >> bitcast<u32>(_e626)) * _e598), ((_e621 >> bitcast<u32>(_e626)) * _e598), _e731)) + select(((_e682 >> bitcast<u32>(_e693)) * _e665), ((_e688 >> bitcast<u32>(_e693)) * _e665), _e733));
                                        let _e747 = (2u * _e742);
                                        let _e749 = cells.member[_e747];
                                        let _e751 = ((((((_e567 & 1u) << bitcast<u32>((_e497 & 31u))) | (((_e567 >> bitcast<u32>(1i)) & (select(2u, 1u, _e521) - 1u)) << bitcast<u32>(((_e497 + 3u) & 31u)))) | select((((_e615 & 1u) << bitcast<u32>(_e634)) | (((_e615 >> bitcast<u32>(1i)) & _e639) << bitcast<u32>(_e642))), (((_e621 & 1u) << bitcast<u32>(_e634)) | (((_e621 >> bitcast<u32>(1i)) & _e639) << bitcast<u32>(_e642))), _e731)) | select((((_e682 & 1u) << bitcast<u32>(_e701)) | (((_e682 >> bitcast<u32>(1i)) & _e706) << bitcast<u32>(_e709))), (((_e688 & 1u) << bitcast<u32>(_e701)) | (((_e688 >> bitcast<u32>(1i)) & _e706) << bitcast<u32>(_e709))), _e733)) & 31u);
                                        if ((_e736 > 0f) && (((_e749 >> bitcast<u32>(_e751)) & 1u) == 1u)) {
                                            let _e759 = params.member.member_8;
                                            let _e760 = (_e759 == 1u);
                                            if (_e495.member == 0u) {
                                                let _e786 = (_e742 * 6u);
                                                let _e789 = cells.member[(_e747 + 1u)];
                                                let _e791 = facet_bits.member[_e786];
                                                let _e794 = ((1u << bitcast<u32>(_e751)) - 1u);
                                                let _e803 = facet_bits.member[(_e786 + 1u)];
                                                let _e813 = facet_bits.member[(_e786 + 2u)];
                                                let _e823 = facet_bits.member[(_e786 + 3u)];
                                                let _e833 = facet_bits.member[(_e786 + 4u)];
                                                let _e843 = facet_bits.member[(_e786 + 5u)];
                                                let _e846 = ((((((_e789 + countOneBits((_e791 & _e794))) + countOneBits((_e803 & _e794))) + countOneBits((_e813 & _e794))) + countOneBits((_e823 & _e794))) + countOneBits((_e833 & _e794))) + countOneBits((_e843 & _e794)));
                                                let _e851 = select(1f, -1f, _e535);
                                                phi_1311_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                phi_1314_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                phi_1316_ = _e846;
                                                loop {
                                                    let _e857 = phi_1311_;
                                                    let _e859 = phi_1314_;
                                                    let _e861 = phi_1316_;
                                                    let _e864 = facets.member[_e861].member_2;
                                                    let _e868 = (2u * _e861);
                                                    let _e870 = radiance.member[_e868];
                                                    let _e873 = radiance.member[(_e868 + 1u)];
                                                    let _e878 = (((select(0f, _e851, _e519) * _e864[0]) + (select(0f, _e851, (_e497 == 1u)) * _e864[1])) + (select(0f, _e851, _e521) * _e864[2]));
                                                    let _e879 = -(_e878);
                                                    if _e760 {
                                                        let _e931 = sqrt((((_e864[0] * _e864[0]) + (_e864[1] * _e864[1])) + (_e864[2] * _e864[2])));
                                                        phi_1312_ = _e857;
                                                        phi_1315_ = vec4<f32>((_e859.x + (select(_e873.x, _e870.x, (_e870.x > _e873.x)) * _e931)), (_e859.y + (select(_e873.y, _e870.y, (_e870.y > _e873.y)) * _e931)), (_e859.z + (select(_e873.z, _e870.z, (_e870.z > _e873.z)) * _e931)), (_e859.w + _e931));
                                                    } else {
                                                        let _e884 = select(0f, _e879, (_e879 > 0f));
                                                        let _e901 = select(0f, _e878, (_e878 > 0f));
                                                        phi_1312_ = vec4<f32>((_e857.x + (_e873.x * _e901)), (_e857.y + (_e873.y * _e901)), (_e857.z + (_e873.z * _e901)), (_e857.w + _e901));
                                                        phi_1315_ = vec4<f32>((_e859.x + (_e870.x * _e884)), (_e859.y + (_e870.y * _e884)), (_e859.z + (_e870.z * _e884)), (_e859.w + _e884));
                                                    }
                                                    let _e945 = phi_1312_;
                                                    let _e947 = phi_1315_;
                                                    let _e948 = (_e861 + 1u);
                                                    local = _e945;
                                                    local_1 = _e947;
                                                    local_2 = _e945;
                                                    local_3 = _e945;
                                                    local_4 = _e945;
                                                    local_5 = _e947;
                                                    local_6 = _e947;
                                                    local_7 = _e947;
                                                    continue;
                                                    continuing {
                                                        phi_1311_ = _e945;
                                                        phi_1314_ = _e947;
                                                        phi_1316_ = _e948;
                                                        break if !(select(true, false, (_e948 >= (_e846 + (((((((_e791 >> bitcast<u32>(_e751)) & 1u) + ((_e803 >> bitcast<u32>(_e751)) & 1u)) + ((_e813 >> bitcast<u32>(_e751)) & 1u)) + ((_e823 >> bitcast<u32>(_e751)) & 1u)) + ((_e833 >> bitcast<u32>(_e751)) & 1u)) + ((_e843 >> bitcast<u32>(_e751)) & 1u))))));
                                                    }
                                                }
                                                let _e954 = local;
                                                let _e957 = local_1;
                                                let _e959 = (_e954.w - _e957.w);
                                                let _e964 = (select(0f, _e959, (_e959 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e954.w, (_e954.w > 0.000000000000000000000000000000000000011754944f)));
                                                let _e966 = local_2;
                                                let _e970 = local_3;
                                                let _e974 = local_4;
                                                let _e979 = local_5;
                                                let _e983 = local_6;
                                                let _e987 = local_7;
                                                let _e990 = (_e957.w + (_e954.w * _e964));
                                                let _e993 = (1f / select(1f, _e990, (_e990 > 1f)));
                                                phi_1518_ = vec4<f32>(((_e979.x + (_e966.x * _e964)) * _e993), ((_e983.y + (_e970.y * _e964)) * _e993), ((_e987.z + (_e974.z * _e964)) * _e993), select(1f, _e990, (_e990 < 1f)));
                                            } else {
                                                let _e764 = cells.member[(_e747 + 1u)];
                                                let _e770 = (_e764 + countOneBits((_e749 & ((1u << bitcast<u32>(_e751)) - 1u))));
                                                if _e760 {
                                                    phi_1505_ = _e770;
                                                } else {
                                                    phi_1505_ = (((6u * _e770) + (2u * _e497)) + select(0u, 1u, _e535));
                                                }
                                                let _e777 = phi_1505_;
                                                if ((_e495.member & 1u) == 1u) {
                                                    let _e783 = odd.member[_e777];
                                                    phi_1517_ = _e783;
                                                } else {
                                                    let _e781 = even.member[_e777];
                                                    phi_1517_ = _e781;
                                                }
                                                let _e785 = phi_1517_;
                                                phi_1518_ = _e785;
                                            }
                                            let _e1001 = phi_1518_;
                                            phi_1143_ = vec4<f32>((_e727.x + (_e1001.x * _e736)), (_e727.y + (_e1001.y * _e736)), (_e727.z + (_e1001.z * _e736)), (_e727.w + (_e1001.w * _e736)));
                                        } else {
                                            phi_1143_ = _e727;
                                        }
                                        let _e1020 = phi_1143_;
                                        let _e1021 = (_e729 + 1u);
                                        local_17 = _e1020;
                                        continue;
                                        continuing {
                                            phi_1142_ = _e1020;
                                            phi_1145_ = _e1021;
                                            break if !(select(true, false, (_e1021 == 4u)));
                                        }
                                    }
                                    let _e1281 = local_17;
                                    phi_1544_ = _e1281;
                                }
                                let _e1026 = phi_1544_;
                                if (_e1026.w > 0f) {
                                    let _e1033 = select(_e514, _e1026.w, (_e1026.w < _e514));
                                    let _e1038 = ((_e503 * _e1033) / _e1026.w);
                                    phi_1584_ = vec3<f32>((_e493.x + (_e1026.x * _e1038)), (_e493.y + (_e1026.y * _e1038)), (_e493.z + (_e1026.z * _e1038)));
                                    phi_1585_ = (_e501 + _e1033);
                                    phi_1586_ = _e503;
                                } else {
                                    let _e1029 = (_e497 == _e402);
                                    phi_1584_ = _e493;
                                    phi_1585_ = select(_e501, 0f, _e1029);
                                    phi_1586_ = select(_e503, _e515, _e1029);
                                }
                                let _e1051 = phi_1584_;
                                let _e1053 = phi_1585_;
                                let _e1055 = phi_1586_;
                                let _e1056 = (_e364 * _e495.member_2);
                                let _e1058 = ((_e367 * _e143) + ((_e367 * _e361.z) * _e495.member_2));
                                let _e1060 = select(_e1058, _e1056, (_e1056 < _e1058));
                                let _e1067 = ((bitcast<u32>((select(1f, _e1060, (_e1060 > 1f)) * _e359)) >> bitcast<u32>(23i)) - 127u);
                                let _e1069 = (_e390.w - 1u);
                                let _e1077 = select(0u, 1u, ((((_e495.member_1 & 1i) == 0i) == _e535) && (select(_e1067, _e1069, (_e1069 < _e1067)) > _e495.member)));
                                if _e535 {
                                    phi_1628_ = (_e495.member_1 - 1i);
                                } else {
                                    phi_1628_ = (_e495.member_1 + 1i);
                                }
                                let _e1081 = phi_1628_;
                                let _e1082 = (_e495.member + _e1077);
                                let _e1085 = (_e1081 >> bitcast<u32>((_e1077 & 31u)));
                                let _e1086 = (_e1082 & 31u);
                                let _e1088 = (1u << bitcast<u32>(_e1086));
                                if _e535 {
                                    phi_1646_ = (_e1085 < 0i);
                                } else {
                                    phi_1646_ = (_e1085 >= bitcast<i32>((((select(select(_e390.y, _e390.x, _e519), _e390.z, _e521) + _e1088) - 1u) >> bitcast<u32>(_e1086))));
                                }
                                let _e1097 = phi_1646_;
                                let _e1107 = select(((((f32(_e1085) + 0.5f) * f32(_e1088)) - select(select(_e151, _e150, _e519), _e152, _e521)) / _e524), 340282350000000000000000000000000000000f, (_e1097 || (abs(_e524) < 0.000001f)));
                                if _e519 {
                                    phi_1667_ = _e1082;
                                } else {
                                    phi_1667_ = _e509.member;
                                }
                                let _e1110 = phi_1667_;
                                if _e519 {
                                    phi_1672_ = _e1085;
                                } else {
                                    phi_1672_ = _e509.member_1;
                                }
                                let _e1113 = phi_1672_;
                                if _e519 {
                                    phi_1677_ = _e1107;
                                } else {
                                    phi_1677_ = _e509.member_2;
                                }
                                let _e1116 = phi_1677_;
                                let _e1118 = (_e497 == 1u);
                                if _e1118 {
                                    phi_1684_ = _e1082;
                                } else {
                                    phi_1684_ = _e507.member;
                                }
                                let _e1121 = phi_1684_;
                                if _e1118 {
                                    phi_1689_ = _e1085;
                                } else {
                                    phi_1689_ = _e507.member_1;
                                }
                                let _e1124 = phi_1689_;
                                if _e1118 {
                                    phi_1694_ = _e1107;
                                } else {
                                    phi_1694_ = _e507.member_2;
                                }
                                let _e1127 = phi_1694_;
                                if _e521 {
                                    phi_1701_ = _e1082;
                                } else {
                                    phi_1701_ = _e505.member;
                                }
                                let _e1131 = phi_1701_;
                                if _e521 {
                                    phi_1706_ = _e1085;
                                } else {
                                    phi_1706_ = _e505.member_1;
                                }
                                let _e1134 = phi_1706_;
                                if _e521 {
                                    phi_1711_ = _e1107;
                                } else {
                                    phi_1711_ = _e505.member_2;
                                }
                                let _e1137 = phi_1711_;
                                let _e1141 = ((_e1116 <= _e1127) && (_e1116 <= _e1137));
                                let _e1142 = (_e1127 <= _e1137);
                                phi_722_ = _e1051;
                                phi_725_ = type_37(select(select(_e1131, _e1121, _e1142), _e1110, _e1141), select(select(_e1134, _e1124, _e1142), _e1113, _e1141), select(select(_e1137, _e1127, _e1142), _e1116, _e1141));
                                phi_727_ = select(select(2u, 1u, _e1142), 0u, _e1141);
                                phi_729_ = (_e499 + 1u);
                                phi_731_ = _e1053;
                                phi_733_ = _e1055;
                                phi_735_ = type_37(_e1131, _e1134, _e1137);
                                phi_737_ = type_37(_e1121, _e1124, _e1127);
                                phi_739_ = type_37(_e1110, _e1113, _e1116);
                            } else {
                                phi_722_ = vec3<f32>();
                                phi_725_ = type_37();
                                phi_727_ = u32();
                                phi_729_ = u32();
                                phi_731_ = f32();
                                phi_733_ = f32();
                                phi_735_ = type_37();
                                phi_737_ = type_37();
                                phi_739_ = type_37();
                            }
                            let _e1153 = phi_722_;
                            let _e1155 = phi_725_;
                            let _e1157 = phi_727_;
                            let _e1159 = phi_729_;
                            let _e1161 = phi_731_;
                            let _e1163 = phi_733_;
                            let _e1165 = phi_735_;
                            let _e1167 = phi_737_;
                            let _e1169 = phi_739_;
                            continue;
                            continuing {
                                phi_721_ = _e1153;
                                phi_724_ = _e1155;
                                phi_726_ = _e1157;
                                phi_728_ = _e1159;
                                phi_730_ = _e1161;
                                phi_732_ = _e1163;
                                phi_734_ = _e1165;
                                phi_736_ = _e1167;
                                phi_738_ = _e1169;
                                break if !(_e517);
                            }
                        }
                        let _e1172 = local_8;
                        let _e1175 = local_9;
                        let _e1178 = local_10;
                        let _e1182 = params.member.member_5;
                        let _e1187 = local_11;
                        let _e1190 = local_12;
                        let _e1193 = local_13;
                        phi_310_ = vec3<f32>((_e212.x + ((_e1172.x + (_e1182.x * _e1187)) * _e236.w)), (_e212.y + ((_e1175.y + (_e1182.y * _e1190)) * _e236.w)), (_e212.z + ((_e1178.z + (_e1182.z * _e1193)) * _e236.w)));
                    } else {
                        phi_310_ = vec3<f32>();
                    }
                    let _e1210 = phi_310_;
                    continue;
                    continuing {
                        phi_306_ = _e225;
                        phi_309_ = _e1210;
                        phi_1841_ = false;
                        break if !(_e231);
                    }
                }
                let _e1213 = phi_1841_;
                if _e1213 {
                    break;
                }
                let _e1215 = local_14;
                let _e1219 = local_15;
                let _e1223 = local_16;
                if (_e95 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e95] = vec4<f32>((_e1215.x * 3.1415927f), (_e1219.y * 3.1415927f), (_e1223.z * 3.1415927f), 0f);
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
