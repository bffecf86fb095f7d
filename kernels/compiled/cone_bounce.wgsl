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
    var phi_192_: vec3<f32>;
    var phi_199_: vec3<f32>;
    var phi_302_: f32;
    var phi_307_: type_13;
    var phi_310_: vec3<f32>;
    var phi_308_: type_13;
    var phi_333_: type_13;
    var phi_471_: f32;
    var phi_479_: f32;
    var phi_492_: f32;
    var phi_493_: vec3<f32>;
    var phi_540_: bool;
    var phi_549_: u32;
    var phi_565_: i32;
    var phi_594_: f32;
    var phi_611_: i32;
    var phi_640_: f32;
    var phi_657_: i32;
    var phi_686_: f32;
    var phi_689_: vec3<f32>;
    var phi_692_: type_38;
    var phi_694_: type_38;
    var phi_696_: type_38;
    var phi_698_: u32;
    var phi_700_: f32;
    var phi_702_: f32;
    var phi_728_: u32;
    var phi_750_: i32;
    var phi_751_: u32;
    var phi_752_: f32;
    var phi_753_: f32;
    var phi_754_: i32;
    var phi_755_: u32;
    var phi_756_: f32;
    var phi_981_: f32;
    var phi_1111_: f32;
    var phi_1117_: vec4<f32>;
    var phi_1120_: u32;
    var phi_1507_: u32;
    var phi_1519_: vec4<f32>;
    var phi_1373_: vec4<f32>;
    var phi_1376_: vec4<f32>;
    var phi_1378_: u32;
    var phi_1448_: vec4<f32>;
    var phi_1449_: vec4<f32>;
    var phi_1374_: vec4<f32>;
    var phi_1377_: vec4<f32>;
    var phi_1379_: u32;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1472_: vec4<f32>;
    var phi_1274_: vec4<f32>;
    var phi_1277_: u32;
    var phi_1275_: vec4<f32>;
    var phi_1278_: u32;
    var phi_1473_: vec4<f32>;
    var phi_1487_: vec4<f32>;
    var phi_1520_: vec4<f32>;
    var phi_1541_: vec4<f32>;
    var phi_1118_: vec4<f32>;
    var phi_1121_: u32;
    var phi_1543_: vec4<f32>;
    var phi_1583_: vec3<f32>;
    var phi_1584_: f32;
    var phi_1585_: f32;
    var phi_1770_: i32;
    var phi_1783_: type_38;
    var phi_1823_: f32;
    var phi_1701_: i32;
    var phi_1714_: type_38;
    var phi_1754_: f32;
    var phi_1825_: type_38;
    var phi_1826_: type_38;
    var phi_1628_: i32;
    var phi_1641_: type_38;
    var phi_1681_: f32;
    var phi_1827_: type_38;
    var phi_1828_: type_38;
    var phi_1829_: type_38;
    var phi_1830_: vec3<f32>;
    var phi_1831_: type_38;
    var phi_1832_: type_38;
    var phi_1833_: type_38;
    var phi_1834_: f32;
    var phi_1835_: f32;
    var phi_690_: vec3<f32>;
    var phi_693_: type_38;
    var phi_695_: type_38;
    var phi_697_: type_38;
    var phi_699_: u32;
    var phi_701_: f32;
    var phi_703_: f32;
    var phi_1837_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var phi_311_: vec3<f32>;
    var phi_1933_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;

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
                    phi_192_ = vec3<f32>((_e101.member_2[0] / _e111), (_e101.member_2[1] / _e111), (_e101.member_2[2] / _e111));
                } else {
                    phi_192_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e118 = phi_192_;
                if ((_e95 & 1u) == 0u) {
                    phi_199_ = _e118;
                } else {
                    phi_199_ = -(_e118);
                }
                let _e123 = phi_199_;
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
                    phi_302_ = 0f;
                } else {
                    let _e179 = ((_e95 * 1664525u) + 1013904223u);
                    let _e181 = (((_e174 * 1664525u) + 1013904223u) + (_e179 * 1013904223u));
                    let _e183 = (_e179 + (1013904223u * _e181));
                    let _e187 = (1013904223u + (_e183 * (1013904223u + (_e181 * _e183))));
                    phi_302_ = (f32((((_e181 ^ (_e181 >> bitcast<u32>(16i))) + ((_e183 ^ (_e183 >> bitcast<u32>(16i))) * (_e187 ^ (_e187 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                }
                let _e204 = phi_302_;
                let _e207 = params.member.member_7;
                phi_307_ = type_13(0u, _e207);
                phi_310_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e210 = phi_307_;
                    let _e212 = phi_310_;
                    local_11 = _e212;
                    local_12 = _e212;
                    local_13 = _e212;
                    if (_e210.member < _e210.member_1) {
                        phi_308_ = type_13((_e210.member + 1u), _e210.member_1);
                        phi_333_ = type_13(1u, _e210.member);
                    } else {
                        phi_308_ = _e210;
                        phi_333_ = type_13(0u, type_13().member_1);
                    }
                    let _e225 = phi_308_;
                    let _e227 = phi_333_;
                    let _e231 = (bitcast<i32>(_e227.member) != 0i);
                    if _e231 {
                        let _e232 = (_e227.member_1 < 16u);
                        if _e232 {
                        } else {
                            phi_1933_ = true;
                            break;
                        }
                        let _e236 = params.member.member_3[_e227.member_1];
                        if _e175 {
                            phi_492_ = 1.4142135f;
                            phi_493_ = vec3<f32>(_e236.x, _e236.y, _e236.z);
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
                                phi_1933_ = true;
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
                                phi_471_ = _e332;
                            } else {
                                phi_471_ = -(_e332);
                            }
                            let _e338 = phi_471_;
                            if (((_e329 + 1i) & 2i) == 0i) {
                                phi_479_ = _e333;
                            } else {
                                phi_479_ = -(_e333);
                            }
                            let _e344 = phi_479_;
                            let _e345 = (1f - _e290);
                            let _e348 = sqrt(select(0f, _e345, (_e345 > 0f)));
                            phi_492_ = (1f + (f32(((_e260 + (_e265 * _e267)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                            phi_493_ = vec3<f32>((_e348 * _e344), (_e348 * _e338), sqrt(_e290));
                        }
                        let _e359 = phi_492_;
                        let _e361 = phi_493_;
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
                            phi_540_ = select(true, false, (_e391 >= _e393));
                        } else {
                            phi_540_ = true;
                        }
                        let _e398 = phi_540_;
                        if _e398 {
                            phi_549_ = select(2u, 1u, (_e392 >= _e393));
                        } else {
                            phi_549_ = 0u;
                        }
                        let _e402 = phi_549_;
                        let _e411 = (_e385 < 0f);
                        if _e411 {
                            phi_565_ = (i32(-(floor((0.5f - _e150)))) - 1i);
                        } else {
                            phi_565_ = (i32(floor((_e150 - 0.5f))) + 1i);
                        }
                        let _e415 = phi_565_;
                        if (((_e411 && (_e415 < 0i)) || ((_e385 >= 0f) && (_e415 >= bitcast<i32>(_e390.x)))) || (_e391 < 0.000001f)) {
                            phi_594_ = 340282350000000000000000000000000000000f;
                        } else {
                            phi_594_ = (((f32(_e415) + 0.5f) - _e150) / _e385);
                        }
                        let _e430 = phi_594_;
                        let _e440 = (_e386 < 0f);
                        if _e440 {
                            phi_611_ = (i32(-(floor((0.5f - _e151)))) - 1i);
                        } else {
                            phi_611_ = (i32(floor((_e151 - 0.5f))) + 1i);
                        }
                        let _e444 = phi_611_;
                        if (((_e440 && (_e444 < 0i)) || ((_e386 >= 0f) && (_e444 >= bitcast<i32>(_e390.y)))) || (_e392 < 0.000001f)) {
                            phi_640_ = 340282350000000000000000000000000000000f;
                        } else {
                            phi_640_ = (((f32(_e444) + 0.5f) - _e151) / _e386);
                        }
                        let _e459 = phi_640_;
                        let _e469 = (_e387 < 0f);
                        if _e469 {
                            phi_657_ = (i32(-(floor((0.5f - _e152)))) - 1i);
                        } else {
                            phi_657_ = (i32(floor((_e152 - 0.5f))) + 1i);
                        }
                        let _e473 = phi_657_;
                        if (((_e469 && (_e473 < 0i)) || ((_e387 >= 0f) && (_e473 >= bitcast<i32>(_e390.z)))) || (_e393 < 0.000001f)) {
                            phi_686_ = 340282350000000000000000000000000000000f;
                        } else {
                            phi_686_ = (((f32(_e473) + 0.5f) - _e152) / _e387);
                        }
                        let _e488 = phi_686_;
                        phi_689_ = vec3<f32>(0f, 0f, 0f);
                        phi_692_ = type_38(_e152, _e387, 0u, _e473, _e488);
                        phi_694_ = type_38(_e151, _e386, 0u, _e444, _e459);
                        phi_696_ = type_38(_e150, _e385, 0u, _e415, _e430);
                        phi_698_ = 0u;
                        phi_700_ = 0f;
                        phi_702_ = 1f;
                        loop {
                            let _e491 = phi_689_;
                            let _e493 = phi_692_;
                            let _e495 = phi_694_;
                            let _e497 = phi_696_;
                            let _e499 = phi_698_;
                            let _e501 = phi_700_;
                            let _e503 = phi_702_;
                            local_6 = _e501;
                            local_7 = _e503;
                            local_8 = _e491;
                            local_9 = _e491;
                            local_10 = _e491;
                            if (_e499 < 2048u) {
                                if ((_e497.member_4 <= _e495.member_4) && (_e497.member_4 <= _e493.member_4)) {
                                    phi_728_ = 0u;
                                } else {
                                    phi_728_ = select(2u, 1u, (_e495.member_4 <= _e493.member_4));
                                }
                                let _e515 = phi_728_;
                                let _e516 = (_e515 == 0u);
                                if _e516 {
                                    phi_753_ = _e497.member_4;
                                    phi_754_ = _e497.member_3;
                                    phi_755_ = _e497.member_2;
                                    phi_756_ = _e497.member_1;
                                } else {
                                    let _e517 = (_e515 == 1u);
                                    if _e517 {
                                        phi_750_ = _e495.member_3;
                                        phi_751_ = _e495.member_2;
                                        phi_752_ = _e495.member_1;
                                    } else {
                                        phi_750_ = _e493.member_3;
                                        phi_751_ = _e493.member_2;
                                        phi_752_ = _e493.member_1;
                                    }
                                    let _e525 = phi_750_;
                                    let _e527 = phi_751_;
                                    let _e529 = phi_752_;
                                    phi_753_ = select(_e493.member_4, _e495.member_4, _e517);
                                    phi_754_ = _e525;
                                    phi_755_ = _e527;
                                    phi_756_ = _e529;
                                }
                                let _e535 = phi_753_;
                                let _e537 = phi_754_;
                                let _e539 = phi_755_;
                                let _e541 = phi_756_;
                                let _e543 = (1f - _e501);
                                let _e544 = (_e503 * _e543);
                                let _e546 = ((_e535 >= 340282350000000000000000000000000000000f) || (_e544 < 0.001f));
                                if _e546 {
                                    phi_1830_ = vec3<f32>();
                                    phi_1831_ = type_38();
                                    phi_1832_ = type_38();
                                    phi_1833_ = type_38();
                                    phi_1834_ = f32();
                                    phi_1835_ = f32();
                                } else {
                                    let _e553 = (_e541 < 0f);
                                    let _e557 = params.member.member_2[_e539];
                                    let _e558 = (_e539 & 31u);
                                    let _e560 = (1u << bitcast<u32>(_e558));
                                    let _e561 = (_e560 - 1u);
                                    let _e564 = ((_e390.x + _e561) >> bitcast<u32>(_e558));
                                    let _e567 = ((_e390.y + _e561) >> bitcast<u32>(_e558));
                                    let _e570 = ((_e390.z + _e561) >> bitcast<u32>(_e558));
                                    let _e573 = (_e515 == 2u);
                                    if ((_e537 < 0i) || (_e537 >= bitcast<i32>(select(select(_e567, _e564, _e516), _e570, _e573)))) {
                                        phi_1543_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    } else {
                                        let _e579 = (1f / f32(_e560));
                                        let _e581 = (((_e150 + (_e385 * _e535)) * _e579) - 0.5f);
                                        let _e583 = (((_e151 + (_e386 * _e535)) * _e579) - 0.5f);
                                        let _e585 = (((_e152 + (_e387 * _e535)) * _e579) - 0.5f);
                                        let _e586 = bitcast<u32>(_e537);
                                        let _e611 = select(select(_e585, _e583, _e516), _e581, _e573);
                                        let _e615 = select(select(1u, 2u, _e516), 2u, _e573);
                                        let _e617 = select(select(_e557.y, _e557.x, _e516), 1u, _e573);
                                        let _e618 = select(2u, 1u, _e516);
                                        let _e619 = select(_e618, 0u, _e573);
                                        let _e620 = floor(_e611);
                                        let _e622 = i32(_e620);
                                        let _e624 = (bitcast<i32>(select(select(_e570, _e567, _e516), _e564, _e573)) - 1i);
                                        let _e629 = ((_e611 >= -0.5f) && (_e611 <= (f32(_e624) + 0.5f)));
                                        let _e631 = select(0i, _e622, (0i < _e622));
                                        let _e634 = bitcast<u32>(select(_e631, _e624, (_e624 < _e631)));
                                        let _e635 = (_e622 + 1i);
                                        let _e637 = select(0i, _e635, (0i < _e635));
                                        let _e640 = bitcast<u32>(select(_e637, _e624, (_e624 < _e637)));
                                        let _e644 = select(select(0f, (_e611 - _e620), (_e622 < _e624)), 1f, (_e622 < 0i));
                                        let _e645 = (_e615 & 31u);
                                        let _e653 = (_e619 & 31u);
                                        let _e658 = (_e615 - 1u);
                                        let _e661 = ((_e619 + 3u) & 31u);
                                        if _e629 {
                                            phi_981_ = (1f - _e644);
                                        } else {
                                            phi_981_ = 0f;
                                        }
                                        let _e676 = phi_981_;
                                        let _e679 = select(select(_e581, _e585, _e516), _e583, _e573);
                                        let _e682 = select(_e618, 2u, _e573);
                                        let _e684 = select(select(1u, _e557.y, _e516), _e557.x, _e573);
                                        let _e686 = select(select(0u, 2u, _e516), 1u, _e573);
                                        let _e687 = floor(_e679);
                                        let _e689 = i32(_e687);
                                        let _e691 = (bitcast<i32>(select(select(_e564, _e570, _e516), _e567, _e573)) - 1i);
                                        let _e696 = ((_e679 >= -0.5f) && (_e679 <= (f32(_e691) + 0.5f)));
                                        let _e698 = select(0i, _e689, (0i < _e689));
                                        let _e701 = bitcast<u32>(select(_e698, _e691, (_e691 < _e698)));
                                        let _e702 = (_e689 + 1i);
                                        let _e704 = select(0i, _e702, (0i < _e702));
                                        let _e707 = bitcast<u32>(select(_e704, _e691, (_e691 < _e704)));
                                        let _e711 = select(select(0f, (_e679 - _e687), (_e689 < _e691)), 1f, (_e689 < 0i));
                                        let _e712 = (_e682 & 31u);
                                        let _e720 = (_e686 & 31u);
                                        let _e725 = (_e682 - 1u);
                                        let _e728 = ((_e686 + 3u) & 31u);
                                        if _e696 {
                                            phi_1111_ = (1f - _e711);
                                        } else {
                                            phi_1111_ = 0f;
                                        }
                                        let _e743 = phi_1111_;
                                        phi_1117_ = vec4<f32>(0f, 0f, 0f, 0f);
                                        phi_1120_ = 0u;
                                        loop {
                                            let _e746 = phi_1117_;
                                            let _e748 = phi_1120_;
                                            local_16 = _e746;
                                            let _e749 = (_e748 < 4u);
                                            if _e749 {
                                                let _e751 = ((_e748 & 1u) == 1u);
                                                let _e753 = ((_e748 & 2u) == 2u);
                                                let _e756 = (select(_e676, select(0f, _e644, _e629), _e751) * select(_e743, select(0f, _e711, _e696), _e753));
                                                let _e762 = (((_e557.z + ((_e586 >> bitcast<u32>((select(2i, 1i, _e573) & 31i))) * select(select(_e557.x, 1u, _e516), _e557.y, _e573))) + select(((_e634 >> bitcast<u32>(_e645)) * _e617), ((_e640 >> bitcast<u32>(_e645)) * _e617), _e751)) + select(((_e701 >> bitcast<u32>(_e712)) * _e684), ((_e707 >> bitcast<u32>(_e712)) * _e684), _e753));
                                                let _e767 = (2u * _e762);
                                                let _e769 = cells.member[_e767];
                                                let _e771 = ((((((_e586 & 1u) << bitcast<u32>((_e515 & 31u))) | (((_e586 >> bitcast<u32>(1i)) & (select(2u, 1u, _e573) - 1u)) << bitcast<u32>(((_e515 + 3u) & 31u)))) | select((((_e634 & 1u) << bitcast<u32>(_e653)) | (((_e634 >> bitcast<u32>(1i)) & _e658) << bitcast<u32>(_e661))), (((_e640 & 1u) << bitcast<u32>(_e653)) | (((_e640 >> bitcast<u32>(1i)) & _e658) << bitcast<u32>(_e661))), _e751)) | select((((_e701 & 1u) << bitcast<u32>(_e720)) | (((_e701 >> bitcast<u32>(1i)) & _e725) << bitcast<u32>(_e728))), (((_e707 & 1u) << bitcast<u32>(_e720)) | (((_e707 >> bitcast<u32>(1i)) & _e725) << bitcast<u32>(_e728))), _e753)) & 31u);
                                                if ((_e756 > 0f) && (((_e769 >> bitcast<u32>(_e771)) & 1u) == 1u)) {
                                                    let _e779 = params.member.member_8;
                                                    let _e780 = (_e779 == 1u);
                                                    if (_e539 == 0u) {
                                                        let _e806 = (_e762 * 6u);
                                                        let _e809 = cells.member[(_e767 + 1u)];
                                                        let _e811 = facet_bits.member[_e806];
                                                        let _e814 = ((1u << bitcast<u32>(_e771)) - 1u);
                                                        let _e823 = facet_bits.member[(_e806 + 1u)];
                                                        let _e833 = facet_bits.member[(_e806 + 2u)];
                                                        let _e843 = facet_bits.member[(_e806 + 3u)];
                                                        let _e853 = facet_bits.member[(_e806 + 4u)];
                                                        let _e863 = facet_bits.member[(_e806 + 5u)];
                                                        let _e866 = ((((((_e809 + countOneBits((_e811 & _e814))) + countOneBits((_e823 & _e814))) + countOneBits((_e833 & _e814))) + countOneBits((_e843 & _e814))) + countOneBits((_e853 & _e814))) + countOneBits((_e863 & _e814)));
                                                        let _e870 = (((((((_e811 >> bitcast<u32>(_e771)) & 1u) + ((_e823 >> bitcast<u32>(_e771)) & 1u)) + ((_e833 >> bitcast<u32>(_e771)) & 1u)) + ((_e843 >> bitcast<u32>(_e771)) & 1u)) + ((_e853 >> bitcast<u32>(_e771)) & 1u)) + ((_e863 >> bitcast<u32>(_e771)) & 1u));
                                                        if _e780 {
                                                            phi_1274_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                            phi_1277_ = _e866;
                                                            loop {
                                                                let _e974 = phi_1274_;
                                                                let _e976 = phi_1277_;
                                                                local_15 = _e974;
                                                                let _e978 = (_e976 < (_e866 + _e870));
                                                                if _e978 {
                                                                    let _e979 = (2u * _e976);
                                                                    let _e982 = radiance.member[_e979][0u];
                                                                    let _e985 = radiance.member[_e979][1u];
                                                                    let _e988 = radiance.member[_e979][2u];
                                                                    let _e989 = (_e979 + 1u);
                                                                    let _e992 = radiance.member[_e989][0u];
                                                                    let _e995 = radiance.member[_e989][1u];
                                                                    let _e998 = radiance.member[_e989][2u];
                                                                    let _e1007 = facets.member[_e976].member_2;
                                                                    let _e1016 = sqrt((((_e1007[0] * _e1007[0]) + (_e1007[1] * _e1007[1])) + (_e1007[2] * _e1007[2])));
                                                                    phi_1275_ = vec4<f32>((_e974.x + (select(_e992, _e982, (_e982 > _e992)) * _e1016)), (_e974.y + (select(_e995, _e985, (_e985 > _e995)) * _e1016)), (_e974.z + (select(_e998, _e988, (_e988 > _e998)) * _e1016)), (_e974.w + _e1016));
                                                                    phi_1278_ = (_e976 + 1u);
                                                                } else {
                                                                    phi_1275_ = vec4<f32>();
                                                                    phi_1278_ = u32();
                                                                }
                                                                let _e1031 = phi_1275_;
                                                                let _e1033 = phi_1278_;
                                                                continue;
                                                                continuing {
                                                                    phi_1274_ = _e1031;
                                                                    phi_1277_ = _e1033;
                                                                    break if !(_e978);
                                                                }
                                                            }
                                                            let _e1501 = local_15;
                                                            phi_1473_ = _e1501;
                                                        } else {
                                                            let _e871 = select(1f, -1f, _e553);
                                                            phi_1373_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                            phi_1376_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                            phi_1378_ = _e866;
                                                            loop {
                                                                let _e877 = phi_1373_;
                                                                let _e879 = phi_1376_;
                                                                let _e881 = phi_1378_;
                                                                local = _e877;
                                                                local_1 = _e879;
                                                                local_2 = _e877;
                                                                local_3 = _e877;
                                                                local_4 = _e877;
                                                                local_5 = _e879;
                                                                local_14 = _e879;
                                                                let _e883 = (_e881 < (_e866 + _e870));
                                                                if _e883 {
                                                                    let _e886 = facets.member[_e881].member_2;
                                                                    let _e895 = -((((select(0f, _e871, _e516) * _e886[0]) + (select(0f, _e871, (_e515 == 1u)) * _e886[1])) + (select(0f, _e871, _e573) * _e886[2])));
                                                                    if (_e895 > 0f) {
                                                                        let _e918 = radiance.member[(2u * _e881)];
                                                                        phi_1448_ = _e877;
                                                                        phi_1449_ = vec4<f32>((_e879.x + (_e918.x * _e895)), (_e879.y + (_e918.y * _e895)), (_e879.z + (_e918.z * _e895)), (_e879.w + _e895));
                                                                    } else {
                                                                        let _e900 = radiance.member[((2u * _e881) + 1u)];
                                                                        phi_1448_ = vec4<f32>((_e877.x - (_e900.x * _e895)), (_e877.y - (_e900.y * _e895)), (_e877.z - (_e900.z * _e895)), (_e877.w - _e895));
                                                                        phi_1449_ = _e879;
                                                                    }
                                                                    let _e935 = phi_1448_;
                                                                    let _e937 = phi_1449_;
                                                                    phi_1374_ = _e935;
                                                                    phi_1377_ = _e937;
                                                                    phi_1379_ = (_e881 + 1u);
                                                                } else {
                                                                    phi_1374_ = vec4<f32>();
                                                                    phi_1377_ = vec4<f32>();
                                                                    phi_1379_ = u32();
                                                                }
                                                                let _e940 = phi_1374_;
                                                                let _e942 = phi_1377_;
                                                                let _e944 = phi_1379_;
                                                                continue;
                                                                continuing {
                                                                    phi_1373_ = _e940;
                                                                    phi_1376_ = _e942;
                                                                    phi_1378_ = _e944;
                                                                    break if !(_e883);
                                                                }
                                                            }
                                                            let _e947 = local;
                                                            let _e950 = local_1;
                                                            if (_e947.w > _e950.w) {
                                                                let _e953 = (_e947.w - _e950.w);
                                                                let _e954 = (_e953 / _e947.w);
                                                                let _e956 = local_2;
                                                                let _e960 = local_3;
                                                                let _e964 = local_4;
                                                                let _e969 = local_5;
                                                                phi_1472_ = (_e969 + vec4<f32>((_e956.x * _e954), (_e960.y * _e954), (_e964.z * _e954), _e953));
                                                            } else {
                                                                let _e1494 = local_14;
                                                                phi_1472_ = _e1494;
                                                            }
                                                            let _e972 = phi_1472_;
                                                            phi_1473_ = _e972;
                                                        }
                                                        let _e1036 = phi_1473_;
                                                        if (_e1036.w > 1f) {
                                                            phi_1487_ = vec4<f32>((_e1036.x / _e1036.w), (_e1036.y / _e1036.w), (_e1036.z / _e1036.w), 1f);
                                                        } else {
                                                            phi_1487_ = _e1036;
                                                        }
                                                        let _e1047 = phi_1487_;
                                                        phi_1520_ = _e1047;
                                                    } else {
                                                        let _e784 = cells.member[(_e767 + 1u)];
                                                        let _e790 = (_e784 + countOneBits((_e769 & ((1u << bitcast<u32>(_e771)) - 1u))));
                                                        if _e780 {
                                                            phi_1507_ = _e790;
                                                        } else {
                                                            phi_1507_ = (((6u * _e790) + (2u * _e515)) + select(0u, 1u, _e553));
                                                        }
                                                        let _e797 = phi_1507_;
                                                        if ((_e539 & 1u) == 1u) {
                                                            let _e803 = odd.member[_e797];
                                                            phi_1519_ = _e803;
                                                        } else {
                                                            let _e801 = even.member[_e797];
                                                            phi_1519_ = _e801;
                                                        }
                                                        let _e805 = phi_1519_;
                                                        phi_1520_ = _e805;
                                                    }
                                                    let _e1049 = phi_1520_;
                                                    phi_1541_ = vec4<f32>((_e746.x + (_e1049.x * _e756)), (_e746.y + (_e1049.y * _e756)), (_e746.z + (_e1049.z * _e756)), (_e746.w + (_e1049.w * _e756)));
                                                } else {
                                                    phi_1541_ = _e746;
                                                }
                                                let _e1068 = phi_1541_;
                                                phi_1118_ = _e1068;
                                                phi_1121_ = (_e748 + 1u);
                                            } else {
                                                phi_1118_ = vec4<f32>();
                                                phi_1121_ = u32();
                                            }
                                            let _e1071 = phi_1118_;
                                            let _e1073 = phi_1121_;
                                            continue;
                                            continuing {
                                                phi_1117_ = _e1071;
                                                phi_1120_ = _e1073;
                                                break if !(_e749);
                                            }
                                        }
                                        let _e1509 = local_16;
                                        phi_1543_ = _e1509;
                                    }
                                    let _e1076 = phi_1543_;
                                    if (_e1076.w > 0f) {
                                        let _e1083 = select(_e543, _e1076.w, (_e1076.w < _e543));
                                        let _e1088 = ((_e503 * _e1083) / _e1076.w);
                                        phi_1583_ = vec3<f32>((_e491.x + (_e1076.x * _e1088)), (_e491.y + (_e1076.y * _e1088)), (_e491.z + (_e1076.z * _e1088)));
                                        phi_1584_ = (_e501 + _e1083);
                                        phi_1585_ = _e503;
                                    } else {
                                        let _e1079 = (_e515 == _e402);
                                        phi_1583_ = _e491;
                                        phi_1584_ = select(_e501, 0f, _e1079);
                                        phi_1585_ = select(_e503, _e544, _e1079);
                                    }
                                    let _e1101 = phi_1583_;
                                    let _e1103 = phi_1584_;
                                    let _e1105 = phi_1585_;
                                    let _e1106 = (_e364 * _e535);
                                    let _e1108 = ((_e367 * _e143) + ((_e367 * _e361.z) * _e535));
                                    let _e1110 = select(_e1108, _e1106, (_e1106 < _e1108));
                                    let _e1117 = ((bitcast<u32>((select(1f, _e1110, (_e1110 > 1f)) * _e359)) >> bitcast<u32>(23i)) - 127u);
                                    let _e1119 = (_e390.w - 1u);
                                    let _e1121 = select(_e1117, _e1119, (_e1119 < _e1117));
                                    if _e516 {
                                        let _e1272 = (_e497.member_1 < 0f);
                                        if _e1272 {
                                            phi_1628_ = (_e497.member_3 - 1i);
                                        } else {
                                            phi_1628_ = (_e497.member_3 + 1i);
                                        }
                                        let _e1280 = phi_1628_;
                                        let _e1286 = type_38(_e497.member, _e497.member_1, _e497.member_2, _e1280, _e497.member_4);
                                        if ((((_e497.member_3 & 1i) == 0i) == _e1272) && (_e1121 > _e497.member_2)) {
                                            let _e1296 = type_38(_e1286.member, _e1286.member_1, (_e497.member_2 + 1u), _e1286.member_3, _e1286.member_4);
                                            phi_1641_ = type_38(_e1296.member, _e1296.member_1, _e1296.member_2, (_e1280 >> bitcast<u32>(1i)), _e1296.member_4);
                                        } else {
                                            phi_1641_ = _e1286;
                                        }
                                        let _e1306 = phi_1641_;
                                        let _e1308 = (_e1306.member_2 & 31u);
                                        let _e1310 = (1u << bitcast<u32>(_e1308));
                                        if ((((_e1306.member_1 < 0f) && (_e1306.member_3 < 0i)) || ((_e1306.member_1 >= 0f) && (_e1306.member_3 >= bitcast<i32>((((_e390.x + _e1310) - 1u) >> bitcast<u32>(_e1308)))))) || (abs(_e1306.member_1) < 0.000001f)) {
                                            phi_1681_ = 340282350000000000000000000000000000000f;
                                        } else {
                                            phi_1681_ = ((((f32(_e1306.member_3) + 0.5f) * f32(_e1310)) - _e1306.member) / _e1306.member_1);
                                        }
                                        let _e1336 = phi_1681_;
                                        phi_1827_ = _e493;
                                        phi_1828_ = _e495;
                                        phi_1829_ = type_38(_e1306.member, _e1306.member_1, _e1306.member_2, _e1306.member_3, _e1336);
                                    } else {
                                        if (_e515 == 1u) {
                                            let _e1196 = (_e495.member_1 < 0f);
                                            if _e1196 {
                                                phi_1701_ = (_e495.member_3 - 1i);
                                            } else {
                                                phi_1701_ = (_e495.member_3 + 1i);
                                            }
                                            let _e1204 = phi_1701_;
                                            let _e1210 = type_38(_e495.member, _e495.member_1, _e495.member_2, _e1204, _e495.member_4);
                                            if ((((_e495.member_3 & 1i) == 0i) == _e1196) && (_e1121 > _e495.member_2)) {
                                                let _e1220 = type_38(_e1210.member, _e1210.member_1, (_e495.member_2 + 1u), _e1210.member_3, _e1210.member_4);
                                                phi_1714_ = type_38(_e1220.member, _e1220.member_1, _e1220.member_2, (_e1204 >> bitcast<u32>(1i)), _e1220.member_4);
                                            } else {
                                                phi_1714_ = _e1210;
                                            }
                                            let _e1230 = phi_1714_;
                                            let _e1232 = (_e1230.member_2 & 31u);
                                            let _e1234 = (1u << bitcast<u32>(_e1232));
                                            if ((((_e1230.member_1 < 0f) && (_e1230.member_3 < 0i)) || ((_e1230.member_1 >= 0f) && (_e1230.member_3 >= bitcast<i32>((((_e390.y + _e1234) - 1u) >> bitcast<u32>(_e1232)))))) || (abs(_e1230.member_1) < 0.000001f)) {
                                                phi_1754_ = 340282350000000000000000000000000000000f;
                                            } else {
                                                phi_1754_ = ((((f32(_e1230.member_3) + 0.5f) * f32(_e1234)) - _e1230.member) / _e1230.member_1);
                                            }
                                            let _e1260 = phi_1754_;
                                            phi_1825_ = _e493;
                                            phi_1826_ = type_38(_e1230.member, _e1230.member_1, _e1230.member_2, _e1230.member_3, _e1260);
                                        } else {
                                            let _e1124 = (_e493.member_1 < 0f);
                                            if _e1124 {
                                                phi_1770_ = (_e493.member_3 - 1i);
                                            } else {
                                                phi_1770_ = (_e493.member_3 + 1i);
                                            }
                                            let _e1132 = phi_1770_;
                                            let _e1138 = type_38(_e493.member, _e493.member_1, _e493.member_2, _e1132, _e493.member_4);
                                            if ((((_e493.member_3 & 1i) == 0i) == _e1124) && (_e1121 > _e493.member_2)) {
                                                let _e1148 = type_38(_e1138.member, _e1138.member_1, (_e493.member_2 + 1u), _e1138.member_3, _e1138.member_4);
                                                phi_1783_ = type_38(_e1148.member, _e1148.member_1, _e1148.member_2, (_e1132 >> bitcast<u32>(1i)), _e1148.member_4);
                                            } else {
                                                phi_1783_ = _e1138;
                                            }
                                            let _e1158 = phi_1783_;
                                            let _e1160 = (_e1158.member_2 & 31u);
                                            let _e1162 = (1u << bitcast<u32>(_e1160));
                                            if ((((_e1158.member_1 < 0f) && (_e1158.member_3 < 0i)) || ((_e1158.member_1 >= 0f) && (_e1158.member_3 >= bitcast<i32>((((_e390.z + _e1162) - 1u) >> bitcast<u32>(_e1160)))))) || (abs(_e1158.member_1) < 0.000001f)) {
                                                phi_1823_ = 340282350000000000000000000000000000000f;
                                            } else {
                                                phi_1823_ = ((((f32(_e1158.member_3) + 0.5f) * f32(_e1162)) - _e1158.member) / _e1158.member_1);
                                            }
                                            let _e1188 = phi_1823_;
                                            phi_1825_ = type_38(_e1158.member, _e1158.member_1, _e1158.member_2, _e1158.member_3, _e1188);
                                            phi_1826_ = _e495;
                                        }
                                        let _e1268 = phi_1825_;
                                        let _e1270 = phi_1826_;
                                        phi_1827_ = _e1268;
                                        phi_1828_ = _e1270;
                                        phi_1829_ = _e497;
                                    }
                                    let _e1344 = phi_1827_;
                                    let _e1346 = phi_1828_;
                                    let _e1348 = phi_1829_;
                                    phi_1830_ = _e1101;
                                    phi_1831_ = _e1344;
                                    phi_1832_ = _e1346;
                                    phi_1833_ = _e1348;
                                    phi_1834_ = _e1103;
                                    phi_1835_ = _e1105;
                                }
                                let _e1350 = phi_1830_;
                                let _e1352 = phi_1831_;
                                let _e1354 = phi_1832_;
                                let _e1356 = phi_1833_;
                                let _e1358 = phi_1834_;
                                let _e1360 = phi_1835_;
                                phi_690_ = _e1350;
                                phi_693_ = _e1352;
                                phi_695_ = _e1354;
                                phi_697_ = _e1356;
                                phi_699_ = (_e499 + 1u);
                                phi_701_ = _e1358;
                                phi_703_ = _e1360;
                                phi_1837_ = select(true, false, _e546);
                            } else {
                                phi_690_ = vec3<f32>();
                                phi_693_ = type_38();
                                phi_695_ = type_38();
                                phi_697_ = type_38();
                                phi_699_ = u32();
                                phi_701_ = f32();
                                phi_703_ = f32();
                                phi_1837_ = false;
                            }
                            let _e1363 = phi_690_;
                            let _e1365 = phi_693_;
                            let _e1367 = phi_695_;
                            let _e1369 = phi_697_;
                            let _e1371 = phi_699_;
                            let _e1373 = phi_701_;
                            let _e1375 = phi_703_;
                            let _e1377 = phi_1837_;
                            continue;
                            continuing {
                                phi_689_ = _e1363;
                                phi_692_ = _e1365;
                                phi_694_ = _e1367;
                                phi_696_ = _e1369;
                                phi_698_ = _e1371;
                                phi_700_ = _e1373;
                                phi_702_ = _e1375;
                                break if !(_e1377);
                            }
                        }
                        let _e1380 = local_6;
                        let _e1383 = local_7;
                        let _e1384 = (_e1383 * (1f - _e1380));
                        let _e1386 = local_8;
                        let _e1389 = local_9;
                        let _e1392 = local_10;
                        let _e1396 = params.member.member_5;
                        phi_311_ = vec3<f32>((_e212.x + ((_e1386.x + (_e1396.x * _e1384)) * _e236.w)), (_e212.y + ((_e1389.y + (_e1396.y * _e1384)) * _e236.w)), (_e212.z + ((_e1392.z + (_e1396.z * _e1384)) * _e236.w)));
                    } else {
                        phi_311_ = vec3<f32>();
                    }
                    let _e1418 = phi_311_;
                    continue;
                    continuing {
                        phi_307_ = _e225;
                        phi_310_ = _e1418;
                        phi_1933_ = false;
                        break if !(_e231);
                    }
                }
                let _e1421 = phi_1933_;
                if _e1421 {
                    break;
                }
                let _e1423 = local_11;
                let _e1427 = local_12;
                let _e1431 = local_13;
                if (_e95 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e95] = vec4<f32>((_e1423.x * 3.1415927f), (_e1427.y * 3.1415927f), (_e1431.z * 3.1415927f), 0f);
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
