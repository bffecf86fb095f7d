struct type_8 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: vec4<f32>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
}

struct type_18 {
    member: type_17,
}

struct type_21 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
    member_4: vec4<f32>,
    member_5: vec4<f32>,
    member_6: array<u32, 4>,
    member_7: vec4<f32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_31 {
    member: array<f32, 6>,
    member_1: array<u32, 3>,
    member_2: array<u32, 3>,
}

struct type_33 {
    member: array<type_31>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: f32,
    member_6: array<f32, 3>,
    member_7: f32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_39 {
    member: vec4<f32>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_41 {
    member: array<type_39>,
}

struct type_43 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_45 {
    member: array<type_43>,
}

struct type_58 {
    member: vec3<f32>,
    member_1: vec3<f32>,
    member_2: f32,
    member_3: f32,
}

struct type_59 {
    member: type_58,
    member_1: vec3<f32>,
    member_2: f32,
    member_3: f32,
}

struct type_64 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
}

struct type_65 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_67 {
    member: vec3<f32>,
    member_1: f32,
}

struct type_68 {
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

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_23;
@group(0) @binding(2) 
var<storage> triangles: type_27;
@group(0) @binding(3) 
var<storage> attributes: type_33;
@group(0) @binding(4) 
var<storage> surfaces: type_8;
@group(0) @binding(5) 
var<storage> lights: type_37;
@group(0) @binding(6) 
var<storage> maps: type_41;
@group(0) @binding(7) 
var<storage, read_write> out: type_45;

fn function_() {
    var local: array<u32, 64>;
    var local_1: array<f32, 64>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var phi_1223_: f32;
    var phi_1237_: u32;
    var phi_1240_: u32;
    var phi_1264_: u32;
    var phi_1238_: u32;
    var phi_1241_: u32;
    var phi_5636_: bool;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_1359_: vec3<f32>;
    var phi_1361_: vec3<f32>;
    var phi_1362_: bool;
    var phi_1413_: vec2<f32>;
    var phi_4848_: f32;
    var phi_4856_: f32;
    var phi_1494_: vec2<f32>;
    var phi_1495_: bool;
    var phi_1625_: f32;
    var phi_1633_: f32;
    var phi_1559_: f32;
    var phi_1567_: f32;
    var phi_1637_: vec2<f32>;
    var phi_1638_: vec2<f32>;
    var phi_1763_: f32;
    var phi_5660_: bool;
    var phi_1794_: type_59;
    var phi_1029_: f32;
    var phi_1037_: f32;
    var phi_5659_: bool;
    var phi_1795_: type_59;
    var phi_764_: vec3<f32>;
    var phi_808_: vec3<f32>;
    var phi_852_: vec3<f32>;
    var phi_896_: vec3<f32>;
    var phi_4937_: f32;
    var phi_4945_: f32;
    var phi_4960_: f32;
    var phi_4966_: f32;
    var phi_4974_: f32;
    var phi_5063_: f32;
    var phi_5071_: f32;
    var phi_5086_: f32;
    var phi_5092_: f32;
    var phi_5100_: f32;
    var phi_5189_: f32;
    var phi_5197_: f32;
    var phi_5212_: f32;
    var phi_5218_: f32;
    var phi_5226_: f32;
    var phi_5315_: f32;
    var phi_5323_: f32;
    var phi_5338_: f32;
    var phi_5344_: f32;
    var phi_5352_: f32;
    var phi_908_: f32;
    var phi_953_: vec3<f32>;
    var phi_5658_: bool;
    var phi_1796_: type_59;
    var phi_5368_: f32;
    var phi_5376_: f32;
    var phi_413_: f32;
    var phi_421_: f32;
    var phi_482_: vec2<f32>;
    var phi_483_: bool;
    var phi_613_: f32;
    var phi_621_: f32;
    var phi_547_: f32;
    var phi_555_: f32;
    var phi_625_: vec2<f32>;
    var phi_626_: vec2<f32>;
    var phi_5657_: bool;
    var phi_1797_: type_59;
    var phi_1817_: bool;
    var phi_1827_: u32;
    var phi_1830_: bool;
    var phi_1841_: u32;
    var phi_1994_: f32;
    var phi_2002_: f32;
    var phi_2010_: f32;
    var phi_5645_: bool;
    var phi_2014_: u32;
    var phi_2017_: u32;
    var phi_2019_: type_64;
    var phi_2512_: type_12;
    var phi_2515_: type_64;
    var phi_2513_: type_12;
    var phi_2538_: type_12;
    var phi_2654_: f32;
    var phi_2665_: f32;
    var phi_2676_: f32;
    var phi_2691_: f32;
    var phi_2692_: f32;
    var phi_2693_: bool;
    var phi_2694_: f32;
    var phi_2695_: bool;
    var phi_2714_: f32;
    var phi_2715_: bool;
    var phi_2716_: f32;
    var phi_2717_: bool;
    var phi_2718_: bool;
    var phi_2723_: f32;
    var phi_2724_: bool;
    var phi_2810_: array<f32, 3>;
    var phi_2811_: array<f32, 3>;
    var phi_2812_: array<f32, 3>;
    var phi_2813_: array<f32, 3>;
    var phi_2814_: bool;
    var phi_2815_: array<f32, 3>;
    var phi_2816_: array<f32, 3>;
    var phi_2817_: bool;
    var phi_2818_: bool;
    var phi_2823_: array<f32, 3>;
    var phi_2828_: array<f32, 3>;
    var phi_3028_: f32;
    var phi_3043_: f32;
    var phi_3071_: u32;
    var phi_3081_: u32;
    var phi_3090_: bool;
    var phi_3106_: bool;
    var phi_3107_: bool;
    var phi_3130_: f32;
    var phi_3145_: f32;
    var phi_3173_: u32;
    var phi_3183_: u32;
    var phi_3192_: bool;
    var phi_3208_: bool;
    var phi_3209_: bool;
    var phi_3290_: bool;
    var phi_3295_: bool;
    var phi_3300_: type_64;
    var phi_3302_: type_64;
    var phi_3304_: bool;
    var phi_3305_: type_64;
    var phi_3307_: bool;
    var phi_3308_: bool;
    var phi_3309_: type_64;
    var phi_3310_: bool;
    var phi_3311_: bool;
    var phi_3312_: bool;
    var phi_3325_: type_64;
    var phi_2516_: type_64;
    var phi_5641_: bool;
    var phi_2401_: type_65;
    var phi_2412_: type_65;
    var phi_2423_: type_65;
    var phi_2434_: type_65;
    var phi_2445_: type_65;
    var phi_2467_: u32;
    var phi_2485_: u32;
    var phi_2503_: u32;
    var phi_5816_: bool;
    var phi_3326_: u32;
    var phi_3327_: u32;
    var phi_2020_: type_64;
    var phi_2015_: u32;
    var phi_2018_: u32;
    var phi_3362_: u32;
    var phi_3363_: u32;
    var phi_3364_: u32;
    var phi_3329_: u32;
    var phi_3331_: u32;
    var phi_3365_: bool;
    var phi_5813_: bool;
    var local_11: bool;
    var phi_5880_: bool;
    var phi_4824_: type_64;
    var phi_3472_: vec3<f32>;
    var phi_3474_: vec3<f32>;
    var phi_3475_: bool;
    var phi_3497_: vec3<f32>;
    var phi_3669_: f32;
    var phi_3684_: f32;
    var phi_3712_: u32;
    var phi_3722_: u32;
    var phi_3731_: bool;
    var phi_3747_: bool;
    var phi_3748_: bool;
    var phi_3771_: f32;
    var phi_3786_: f32;
    var phi_3814_: u32;
    var phi_3824_: u32;
    var phi_3833_: bool;
    var phi_3849_: bool;
    var phi_3850_: bool;
    var phi_4073_: type_67;
    var phi_4180_: vec3<f32>;
    var phi_4256_: vec3<f32>;
    var phi_4330_: vec3<f32>;
    var phi_4404_: vec3<f32>;
    var phi_4449_: vec3<f32>;
    var phi_4451_: vec3<f32>;
    var phi_4452_: bool;
    var phi_4473_: vec3<f32>;
    var phi_4504_: array<f32, 3>;
    var phi_4550_: type_68;
    var phi_4552_: type_68;
    var phi_4576_: bool;
    var phi_4604_: f32;
    var phi_4614_: array<f32, 3>;
    var phi_4619_: array<f32, 3>;
    var local_12: u32;
    var local_13: u32;
    var local_14: type_64;

    switch bitcast<i32>(0u) {
        default: {
            let _e136 = gid_1;
            let _e139 = arrayLength((&nodes.member));
            let _e142 = arrayLength((&triangles.member));
            let _e145 = arrayLength((&attributes.member));
            let _e148 = arrayLength((&surfaces.member));
            let _e150 = arrayLength((&lights.member));
            let _e157 = params.member.member_2;
            let _e160 = params.member.member_3;
            let _e164 = (_e136.x + (_e136.y * 2097152u));
            if (_e164 < _e160) {
                let _e166 = (_e157 + _e164);
                let _e169 = params.member.member_1;
                let _e170 = (_e169 * _e169);
                let _e171 = (_e170 == 0u);
                if _e171 {
                    break;
                }
                let _e172 = (_e166 / _e170);
                if (_e172 < arrayLength((&maps.member))) {
                } else {
                    break;
                }
                let _e176 = maps.member[_e172];
                if _e171 {
                    break;
                }
                let _e178 = (_e166 - (_e172 * _e170));
                if (_e169 == 0u) {
                    break;
                }
                let _e180 = (_e178 / _e169);
                let _e187 = f32(_e169);
                let _e188 = ((f32((_e178 - (_e180 * _e169))) + 0.5f) / _e187);
                let _e189 = ((f32(_e180) + 0.5f) / _e187);
                if (_e176.member_1 == 4u) {
                    let _e1406 = (_e176.member_3 + _e178);
                    let _e1421 = params.member.member_5;
                    let _e1425 = ((_e1421 ^ (_e1421 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e1429 = ((_e1425 ^ (_e1425 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e1436 = (_e1421 ^ 2654435769u);
                    let _e1440 = ((_e1436 ^ (_e1436 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e1444 = ((_e1440 ^ (_e1440 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e1452 = (0.000000059604645f * (f32(((2147483648u + (_e1406 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e1429 ^ (_e1429 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                    if (_e1452 >= 1f) {
                        phi_5368_ = (_e1452 - 1f);
                    } else {
                        phi_5368_ = _e1452;
                    }
                    let _e1456 = phi_5368_;
                    let _e1458 = (0.000000059604645f * (f32(((2147483648u + (_e1406 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e1444 ^ (_e1444 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                    if (_e1458 >= 1f) {
                        phi_5376_ = (_e1458 - 1f);
                    } else {
                        phi_5376_ = _e1458;
                    }
                    let _e1462 = phi_5376_;
                    let _e1464 = (1f - (2f * _e1456));
                    let _e1468 = floor(((_e1462 * 4f) + 0.5f));
                    let _e1474 = ((((6.2831855f * _e1462) - (_e1468 * 1.5703125f)) - (_e1468 * 0.0004837513f)) - (_e1468 * 0.0000000754979f));
                    let _e1475 = (_e1474 * _e1474);
                    let _e1482 = (_e1474 + ((_e1474 * _e1475) * (-0.16666655f + (_e1475 * (0.008332161f + (_e1475 * -0.00019515296f))))));
                    let _e1491 = ((1f - (0.5f * _e1475)) + ((_e1475 * _e1475) * (0.041666646f + (_e1475 * (-0.0013887316f + (_e1475 * 0.000024433157f))))));
                    let _e1498 = select(0i, select(select(i32(_e1468), i32(-2147483648), (_e1468 < -2147483600f)), 2147483647i, (_e1468 > 2147483500f)), (_e1468 == _e1468));
                    let _e1500 = ((_e1498 & 1i) == 0i);
                    let _e1501 = select(_e1491, _e1482, _e1500);
                    let _e1502 = select(_e1482, _e1491, _e1500);
                    if ((_e1498 & 2i) == 0i) {
                        phi_413_ = _e1501;
                    } else {
                        phi_413_ = -(_e1501);
                    }
                    let _e1507 = phi_413_;
                    if (((_e1498 + 1i) & 2i) == 0i) {
                        phi_421_ = _e1502;
                    } else {
                        phi_421_ = -(_e1502);
                    }
                    let _e1513 = phi_421_;
                    let _e1515 = (1f - (_e1464 * _e1464));
                    let _e1518 = sqrt(select(0f, _e1515, (_e1515 > 0f)));
                    let _e1519 = (_e1518 * _e1513);
                    let _e1520 = (_e1518 * _e1507);
                    let _e1525 = ((_e1406 * 1664525u) + 1013904223u);
                    let _e1527 = (((_e1421 * 1664525u) + 1013904223u) + (_e1525 * 1013904223u));
                    let _e1529 = (_e1525 + (1015568748u * _e1527));
                    let _e1531 = (1015568748u + (_e1527 * _e1529));
                    let _e1533 = (1013904223u + (_e1529 * _e1531));
                    let _e1539 = (_e1529 ^ (_e1529 >> bitcast<u32>(16i)));
                    let _e1547 = ((_e1527 ^ (_e1527 >> bitcast<u32>(16i))) + (_e1539 * (_e1533 ^ (_e1533 >> bitcast<u32>(16i)))));
                    let _e1557 = ((f32((_e1547 >> bitcast<u32>(8i))) * 0.00000011920929f) - 1f);
                    let _e1559 = ((f32(((_e1539 + ((_e1531 ^ (_e1531 >> bitcast<u32>(16i))) * _e1547)) >> bitcast<u32>(8i))) * 0.00000011920929f) - 1f);
                    if (_e1557 == 0f) {
                        let _e1561 = (_e1559 == 0f);
                        phi_482_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e1561));
                        phi_483_ = select(true, false, _e1561);
                    } else {
                        phi_482_ = vec2<f32>();
                        phi_483_ = true;
                    }
                    let _e1566 = phi_482_;
                    let _e1568 = phi_483_;
                    if _e1568 {
                        if (abs(_e1557) > abs(_e1559)) {
                            let _e1625 = (_e1559 / _e1557);
                            let _e1629 = floor(((_e1625 * 0.5f) + 0.5f));
                            let _e1635 = ((((0.7853982f * _e1625) - (_e1629 * 1.5703125f)) - (_e1629 * 0.0004837513f)) - (_e1629 * 0.0000000754979f));
                            let _e1636 = (_e1635 * _e1635);
                            let _e1643 = (_e1635 + ((_e1635 * _e1636) * (-0.16666655f + (_e1636 * (0.008332161f + (_e1636 * -0.00019515296f))))));
                            let _e1652 = ((1f - (0.5f * _e1636)) + ((_e1636 * _e1636) * (0.041666646f + (_e1636 * (-0.0013887316f + (_e1636 * 0.000024433157f))))));
                            let _e1659 = select(0i, select(select(i32(_e1629), i32(-2147483648), (_e1629 < -2147483600f)), 2147483647i, (_e1629 > 2147483500f)), (_e1629 == _e1629));
                            let _e1661 = ((_e1659 & 1i) == 0i);
                            let _e1662 = select(_e1652, _e1643, _e1661);
                            let _e1663 = select(_e1643, _e1652, _e1661);
                            if ((_e1659 & 2i) == 0i) {
                                phi_547_ = _e1662;
                            } else {
                                phi_547_ = -(_e1662);
                            }
                            let _e1668 = phi_547_;
                            if (((_e1659 + 1i) & 2i) == 0i) {
                                phi_555_ = _e1663;
                            } else {
                                phi_555_ = -(_e1663);
                            }
                            let _e1674 = phi_555_;
                            phi_625_ = vec2<f32>((_e1557 * _e1674), (_e1557 * _e1668));
                        } else {
                            let _e1572 = (_e1557 / _e1559);
                            let _e1576 = floor(((_e1572 * 0.5f) + 0.5f));
                            let _e1582 = ((((0.7853982f * _e1572) - (_e1576 * 1.5703125f)) - (_e1576 * 0.0004837513f)) - (_e1576 * 0.0000000754979f));
                            let _e1583 = (_e1582 * _e1582);
                            let _e1590 = (_e1582 + ((_e1582 * _e1583) * (-0.16666655f + (_e1583 * (0.008332161f + (_e1583 * -0.00019515296f))))));
                            let _e1599 = ((1f - (0.5f * _e1583)) + ((_e1583 * _e1583) * (0.041666646f + (_e1583 * (-0.0013887316f + (_e1583 * 0.000024433157f))))));
                            let _e1606 = select(0i, select(select(i32(_e1576), i32(-2147483648), (_e1576 < -2147483600f)), 2147483647i, (_e1576 > 2147483500f)), (_e1576 == _e1576));
                            let _e1608 = ((_e1606 & 1i) == 0i);
                            let _e1609 = select(_e1599, _e1590, _e1608);
                            let _e1610 = select(_e1590, _e1599, _e1608);
                            if ((_e1606 & 2i) == 0i) {
                                phi_613_ = _e1609;
                            } else {
                                phi_613_ = -(_e1609);
                            }
                            let _e1615 = phi_613_;
                            if (((_e1606 + 1i) & 2i) == 0i) {
                                phi_621_ = _e1610;
                            } else {
                                phi_621_ = -(_e1610);
                            }
                            let _e1621 = phi_621_;
                            phi_625_ = vec2<f32>((_e1559 * _e1615), (_e1559 * _e1621));
                        }
                        let _e1679 = phi_625_;
                        phi_626_ = _e1679;
                    } else {
                        phi_626_ = _e1566;
                    }
                    let _e1681 = phi_626_;
                    let _e1684 = (_e1681.x * _e176.member.w);
                    let _e1685 = (_e1681.y * _e176.member.w);
                    let _e1689 = bitcast<f32>((1065353216u | (bitcast<u32>(_e1464) & 2147483648u)));
                    let _e1691 = (-1f / (_e1689 + _e1464));
                    let _e1693 = ((_e1519 * _e1520) * _e1691);
                    let _e1705 = -(_e176.member.w);
                    let _e1723 = (1f / f32(_e176.member_4));
                    let _e1735 = params.member.member;
                    let _e1741 = (((39.47842f * _e176.member.w) * _e176.member.w) * _e1723);
                    phi_5657_ = false;
                    phi_1797_ = type_59(type_58(vec3<f32>((_e176.member.x + ((((1f + (((_e1689 * _e1519) * _e1519) * _e1691)) * _e1684) + (_e1693 * _e1685)) + (_e1519 * _e1705))), (_e176.member.y + ((((_e1689 * _e1693) * _e1684) + ((_e1689 + ((_e1520 * _e1520) * _e1691)) * _e1685)) + (_e1520 * _e1705))), (_e176.member.z + ((((-(_e1689) * _e1519) * _e1684) + (-(_e1520) * _e1685)) + (_e1464 * _e1705)))), vec3<f32>(_e1519, _e1520, _e1464), 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e1735.x * _e1741), (_e1735.y * _e1741), (_e1735.z * _e1741)), ((((12.566371f * _e176.member.w) * _e176.member.w) * _e1723) * 0.05f), 0f);
                } else {
                    if (_e176.member_2 < _e150) {
                    } else {
                        break;
                    }
                    let _e196 = lights.member[_e176.member_2];
                    if (_e176.member_1 == 0u) {
                        let _e889 = ((_e188 * 2f) - 1f);
                        let _e890 = ((_e189 * 2f) - 1f);
                        let _e891 = (1f / _e187);
                        let _e892 = (-1f / _e187);
                        let _e893 = (_e889 + _e892);
                        let _e894 = (_e890 + _e892);
                        let _e896 = (1f - abs(_e893));
                        let _e897 = abs(_e894);
                        let _e898 = (_e896 - _e897);
                        let _e899 = -(_e898);
                        let _e903 = (bitcast<u32>(select(0f, _e899, (_e899 > 0f))) & 2147483647u);
                        let _e905 = (bitcast<u32>(_e893) & 2147483648u);
                        let _e908 = (_e893 - bitcast<f32>((_e903 | _e905)));
                        let _e910 = (bitcast<u32>(_e894) & 2147483648u);
                        let _e913 = (_e894 - bitcast<f32>((_e903 | _e910)));
                        let _e918 = (((_e908 * _e908) + (_e913 * _e913)) + (_e898 * _e898));
                        if (_e918 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e921 = (1f / sqrt(_e918));
                            phi_764_ = vec3<f32>((_e908 * _e921), (_e913 * _e921), (_e898 * _e921));
                        } else {
                            phi_764_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e927 = phi_764_;
                        let _e928 = (_e889 + _e891);
                        let _e930 = (1f - abs(_e928));
                        let _e931 = (_e930 - _e897);
                        let _e932 = -(_e931);
                        let _e936 = (bitcast<u32>(select(0f, _e932, (_e932 > 0f))) & 2147483647u);
                        let _e938 = (bitcast<u32>(_e928) & 2147483648u);
                        let _e941 = (_e928 - bitcast<f32>((_e936 | _e938)));
                        let _e944 = (_e894 - bitcast<f32>((_e936 | _e910)));
                        let _e949 = (((_e941 * _e941) + (_e944 * _e944)) + (_e931 * _e931));
                        if (_e949 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e952 = (1f / sqrt(_e949));
                            phi_808_ = vec3<f32>((_e941 * _e952), (_e944 * _e952), (_e931 * _e952));
                        } else {
                            phi_808_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e958 = phi_808_;
                        let _e959 = (_e890 + _e891);
                        let _e960 = abs(_e959);
                        let _e961 = (_e930 - _e960);
                        let _e962 = -(_e961);
                        let _e966 = (bitcast<u32>(select(0f, _e962, (_e962 > 0f))) & 2147483647u);
                        let _e969 = (_e928 - bitcast<f32>((_e966 | _e938)));
                        let _e971 = (bitcast<u32>(_e959) & 2147483648u);
                        let _e974 = (_e959 - bitcast<f32>((_e966 | _e971)));
                        let _e979 = (((_e969 * _e969) + (_e974 * _e974)) + (_e961 * _e961));
                        if (_e979 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e982 = (1f / sqrt(_e979));
                            phi_852_ = vec3<f32>((_e969 * _e982), (_e974 * _e982), (_e961 * _e982));
                        } else {
                            phi_852_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e988 = phi_852_;
                        let _e989 = (_e896 - _e960);
                        let _e990 = -(_e989);
                        let _e994 = (bitcast<u32>(select(0f, _e990, (_e990 > 0f))) & 2147483647u);
                        let _e997 = (_e893 - bitcast<f32>((_e994 | _e905)));
                        let _e1000 = (_e959 - bitcast<f32>((_e994 | _e971)));
                        let _e1005 = (((_e997 * _e997) + (_e1000 * _e1000)) + (_e989 * _e989));
                        if (_e1005 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e1008 = (1f / sqrt(_e1005));
                            phi_896_ = vec3<f32>((_e997 * _e1008), (_e1000 * _e1008), (_e989 * _e1008));
                        } else {
                            phi_896_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e1014 = phi_896_;
                        if ((_e889 * _e890) > 0f) {
                            let _e1206 = (((_e927.x * ((_e958.y * _e1014.z) - (_e1014.y * _e958.z))) + (_e927.y * ((_e958.z * _e1014.x) - (_e1014.z * _e958.x)))) + (_e927.z * ((_e958.x * _e1014.y) - (_e1014.x * _e958.y))));
                            let _e1224 = (((1f + (((_e927.x * _e958.x) + (_e927.y * _e958.y)) + (_e927.z * _e958.z))) + (((_e958.x * _e1014.x) + (_e958.y * _e1014.y)) + (_e958.z * _e1014.z))) + (((_e1014.x * _e927.x) + (_e1014.y * _e927.y)) + (_e1014.z * _e927.z)));
                            let _e1225 = abs(_e1224);
                            let _e1226 = abs(_e1206);
                            let _e1227 = (_e1226 > _e1225);
                            let _e1228 = select(_e1225, _e1226, _e1227);
                            if (_e1228 > 0f) {
                                phi_5189_ = (select(_e1226, _e1225, _e1227) / _e1228);
                            } else {
                                phi_5189_ = 0f;
                            }
                            let _e1233 = phi_5189_;
                            let _e1234 = (_e1233 > 0.41421357f);
                            if _e1234 {
                                phi_5197_ = ((_e1233 - 1f) / (_e1233 + 1f));
                            } else {
                                phi_5197_ = _e1233;
                            }
                            let _e1239 = phi_5197_;
                            let _e1240 = (_e1239 * _e1239);
                            let _e1249 = (_e1239 + ((_e1239 * _e1240) * (-0.3333295f + (_e1240 * (0.19977711f + (_e1240 * (-0.13877685f + (_e1240 * 0.080537446f))))))));
                            if _e1234 {
                                phi_5212_ = (_e1249 + 0.7853982f);
                            } else {
                                phi_5212_ = _e1249;
                            }
                            let _e1252 = phi_5212_;
                            if _e1227 {
                                phi_5218_ = (1.5707964f - _e1252);
                            } else {
                                phi_5218_ = _e1252;
                            }
                            let _e1255 = phi_5218_;
                            if ((bitcast<u32>(_e1224) & 2147483648u) == 0u) {
                                phi_5226_ = _e1255;
                            } else {
                                phi_5226_ = (3.1415927f - _e1255);
                            }
                            let _e1261 = phi_5226_;
                            let _e1286 = (((_e958.x * ((_e988.y * _e1014.z) - (_e1014.y * _e988.z))) + (_e958.y * ((_e988.z * _e1014.x) - (_e1014.z * _e988.x)))) + (_e958.z * ((_e988.x * _e1014.y) - (_e1014.x * _e988.y))));
                            let _e1304 = (((1f + (((_e958.x * _e988.x) + (_e958.y * _e988.y)) + (_e958.z * _e988.z))) + (((_e988.x * _e1014.x) + (_e988.y * _e1014.y)) + (_e988.z * _e1014.z))) + (((_e1014.x * _e958.x) + (_e1014.y * _e958.y)) + (_e1014.z * _e958.z)));
                            let _e1305 = abs(_e1304);
                            let _e1306 = abs(_e1286);
                            let _e1307 = (_e1306 > _e1305);
                            let _e1308 = select(_e1305, _e1306, _e1307);
                            if (_e1308 > 0f) {
                                phi_5315_ = (select(_e1306, _e1305, _e1307) / _e1308);
                            } else {
                                phi_5315_ = 0f;
                            }
                            let _e1313 = phi_5315_;
                            let _e1314 = (_e1313 > 0.41421357f);
                            if _e1314 {
                                phi_5323_ = ((_e1313 - 1f) / (_e1313 + 1f));
                            } else {
                                phi_5323_ = _e1313;
                            }
                            let _e1319 = phi_5323_;
                            let _e1320 = (_e1319 * _e1319);
                            let _e1329 = (_e1319 + ((_e1319 * _e1320) * (-0.3333295f + (_e1320 * (0.19977711f + (_e1320 * (-0.13877685f + (_e1320 * 0.080537446f))))))));
                            if _e1314 {
                                phi_5338_ = (_e1329 + 0.7853982f);
                            } else {
                                phi_5338_ = _e1329;
                            }
                            let _e1332 = phi_5338_;
                            if _e1307 {
                                phi_5344_ = (1.5707964f - _e1332);
                            } else {
                                phi_5344_ = _e1332;
                            }
                            let _e1335 = phi_5344_;
                            if ((bitcast<u32>(_e1304) & 2147483648u) == 0u) {
                                phi_5352_ = _e1335;
                            } else {
                                phi_5352_ = (3.1415927f - _e1335);
                            }
                            let _e1341 = phi_5352_;
                            phi_908_ = (abs((2f * bitcast<f32>(((bitcast<u32>(_e1261) & 2147483647u) | (bitcast<u32>(_e1206) & 2147483648u))))) + abs((2f * bitcast<f32>(((bitcast<u32>(_e1341) & 2147483647u) | (bitcast<u32>(_e1286) & 2147483648u))))));
                        } else {
                            let _e1039 = (((_e927.x * ((_e958.y * _e988.z) - (_e988.y * _e958.z))) + (_e927.y * ((_e958.z * _e988.x) - (_e988.z * _e958.x)))) + (_e927.z * ((_e958.x * _e988.y) - (_e988.x * _e958.y))));
                            let _e1057 = (((1f + (((_e927.x * _e958.x) + (_e927.y * _e958.y)) + (_e927.z * _e958.z))) + (((_e958.x * _e988.x) + (_e958.y * _e988.y)) + (_e958.z * _e988.z))) + (((_e988.x * _e927.x) + (_e988.y * _e927.y)) + (_e988.z * _e927.z)));
                            let _e1058 = abs(_e1057);
                            let _e1059 = abs(_e1039);
                            let _e1060 = (_e1059 > _e1058);
                            let _e1061 = select(_e1058, _e1059, _e1060);
                            if (_e1061 > 0f) {
                                phi_4937_ = (select(_e1059, _e1058, _e1060) / _e1061);
                            } else {
                                phi_4937_ = 0f;
                            }
                            let _e1066 = phi_4937_;
                            let _e1067 = (_e1066 > 0.41421357f);
                            if _e1067 {
                                phi_4945_ = ((_e1066 - 1f) / (_e1066 + 1f));
                            } else {
                                phi_4945_ = _e1066;
                            }
                            let _e1072 = phi_4945_;
                            let _e1073 = (_e1072 * _e1072);
                            let _e1082 = (_e1072 + ((_e1072 * _e1073) * (-0.3333295f + (_e1073 * (0.19977711f + (_e1073 * (-0.13877685f + (_e1073 * 0.080537446f))))))));
                            if _e1067 {
                                phi_4960_ = (_e1082 + 0.7853982f);
                            } else {
                                phi_4960_ = _e1082;
                            }
                            let _e1085 = phi_4960_;
                            if _e1060 {
                                phi_4966_ = (1.5707964f - _e1085);
                            } else {
                                phi_4966_ = _e1085;
                            }
                            let _e1088 = phi_4966_;
                            if ((bitcast<u32>(_e1057) & 2147483648u) == 0u) {
                                phi_4974_ = _e1088;
                            } else {
                                phi_4974_ = (3.1415927f - _e1088);
                            }
                            let _e1094 = phi_4974_;
                            let _e1119 = (((_e927.x * ((_e988.y * _e1014.z) - (_e1014.y * _e988.z))) + (_e927.y * ((_e988.z * _e1014.x) - (_e1014.z * _e988.x)))) + (_e927.z * ((_e988.x * _e1014.y) - (_e1014.x * _e988.y))));
                            let _e1137 = (((1f + (((_e927.x * _e988.x) + (_e927.y * _e988.y)) + (_e927.z * _e988.z))) + (((_e988.x * _e1014.x) + (_e988.y * _e1014.y)) + (_e988.z * _e1014.z))) + (((_e1014.x * _e927.x) + (_e1014.y * _e927.y)) + (_e1014.z * _e927.z)));
                            let _e1138 = abs(_e1137);
                            let _e1139 = abs(_e1119);
                            let _e1140 = (_e1139 > _e1138);
                            let _e1141 = select(_e1138, _e1139, _e1140);
                            if (_e1141 > 0f) {
                                phi_5063_ = (select(_e1139, _e1138, _e1140) / _e1141);
                            } else {
                                phi_5063_ = 0f;
                            }
                            let _e1146 = phi_5063_;
                            let _e1147 = (_e1146 > 0.41421357f);
                            if _e1147 {
                                phi_5071_ = ((_e1146 - 1f) / (_e1146 + 1f));
                            } else {
                                phi_5071_ = _e1146;
                            }
                            let _e1152 = phi_5071_;
                            let _e1153 = (_e1152 * _e1152);
                            let _e1162 = (_e1152 + ((_e1152 * _e1153) * (-0.3333295f + (_e1153 * (0.19977711f + (_e1153 * (-0.13877685f + (_e1153 * 0.080537446f))))))));
                            if _e1147 {
                                phi_5086_ = (_e1162 + 0.7853982f);
                            } else {
                                phi_5086_ = _e1162;
                            }
                            let _e1165 = phi_5086_;
                            if _e1140 {
                                phi_5092_ = (1.5707964f - _e1165);
                            } else {
                                phi_5092_ = _e1165;
                            }
                            let _e1168 = phi_5092_;
                            if ((bitcast<u32>(_e1137) & 2147483648u) == 0u) {
                                phi_5100_ = _e1168;
                            } else {
                                phi_5100_ = (3.1415927f - _e1168);
                            }
                            let _e1174 = phi_5100_;
                            phi_908_ = (abs((2f * bitcast<f32>(((bitcast<u32>(_e1094) & 2147483647u) | (bitcast<u32>(_e1039) & 2147483648u))))) + abs((2f * bitcast<f32>(((bitcast<u32>(_e1174) & 2147483647u) | (bitcast<u32>(_e1119) & 2147483648u))))));
                        }
                        let _e1352 = phi_908_;
                        let _e1361 = ((1f - abs(_e889)) - abs(_e890));
                        let _e1362 = -(_e1361);
                        let _e1366 = (bitcast<u32>(select(0f, _e1362, (_e1362 > 0f))) & 2147483647u);
                        let _e1371 = (_e889 - bitcast<f32>((_e1366 | (bitcast<u32>(_e889) & 2147483648u))));
                        let _e1376 = (_e890 - bitcast<f32>((_e1366 | (bitcast<u32>(_e890) & 2147483648u))));
                        let _e1381 = (((_e1371 * _e1371) + (_e1376 * _e1376)) + (_e1361 * _e1361));
                        if (_e1381 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e1384 = (1f / sqrt(_e1381));
                            phi_953_ = vec3<f32>((_e1371 * _e1384), (_e1376 * _e1384), (_e1361 * _e1384));
                        } else {
                            phi_953_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e1390 = phi_953_;
                        phi_5658_ = false;
                        phi_1796_ = type_59(type_58(vec3<f32>(_e196.member[0], _e196.member[1], _e196.member[2]), _e1390, 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e196.member_6[0] * _e1352), (_e196.member_6[1] * _e1352), (_e196.member_6[2] * _e1352)), 0f, _e1352);
                    } else {
                        if (_e176.member_1 == 1u) {
                            let _e760 = (1f - _e196.member_4[1]);
                            let _e761 = (_e188 * _e760);
                            let _e765 = floor(((_e189 * 4f) + 0.5f));
                            let _e771 = ((((6.2831855f * _e189) - (_e765 * 1.5703125f)) - (_e765 * 0.0004837513f)) - (_e765 * 0.0000000754979f));
                            let _e772 = (_e771 * _e771);
                            let _e779 = (_e771 + ((_e771 * _e772) * (-0.16666655f + (_e772 * (0.008332161f + (_e772 * -0.00019515296f))))));
                            let _e788 = ((1f - (0.5f * _e772)) + ((_e772 * _e772) * (0.041666646f + (_e772 * (-0.0013887316f + (_e772 * 0.000024433157f))))));
                            let _e795 = select(0i, select(select(i32(_e765), i32(-2147483648), (_e765 < -2147483600f)), 2147483647i, (_e765 > 2147483500f)), (_e765 == _e765));
                            let _e797 = ((_e795 & 1i) == 0i);
                            let _e798 = select(_e788, _e779, _e797);
                            let _e799 = select(_e779, _e788, _e797);
                            if ((_e795 & 2i) == 0i) {
                                phi_1029_ = _e798;
                            } else {
                                phi_1029_ = -(_e798);
                            }
                            let _e804 = phi_1029_;
                            if (((_e795 + 1i) & 2i) == 0i) {
                                phi_1037_ = _e799;
                            } else {
                                phi_1037_ = -(_e799);
                            }
                            let _e810 = phi_1037_;
                            let _e813 = sqrt((_e761 * (2f - _e761)));
                            let _e814 = (_e813 * _e810);
                            let _e815 = (_e813 * _e804);
                            let _e816 = (1f - _e761);
                            let _e819 = ((6.2831855f * _e760) / f32(_e170));
                            let _e828 = bitcast<f32>((1065353216u | (bitcast<u32>(_e196.member_2[2]) & 2147483648u)));
                            let _e830 = (-1f / (_e828 + _e196.member_2[2]));
                            let _e832 = ((_e196.member_2[0] * _e196.member_2[1]) * _e830);
                            let _e868 = (_e196.member_4[0] - _e196.member_4[1]);
                            let _e871 = ((_e816 - _e196.member_4[1]) / select(0.001f, _e868, (_e868 > 0.001f)));
                            let _e873 = select(0f, _e871, (_e871 > 0f));
                            let _e875 = select(1f, _e873, (_e873 < 1f));
                            let _e877 = ((_e875 * _e875) * _e819);
                            phi_5659_ = false;
                            phi_1795_ = type_59(type_58(vec3<f32>(_e196.member[0], _e196.member[1], _e196.member[2]), vec3<f32>(((((1f + (((_e828 * _e196.member_2[0]) * _e196.member_2[0]) * _e830)) * _e814) + (_e832 * _e815)) + (_e196.member_2[0] * _e816)), ((((_e828 * _e832) * _e814) + ((_e828 + ((_e196.member_2[1] * _e196.member_2[1]) * _e830)) * _e815)) + (_e196.member_2[1] * _e816)), ((((-(_e828) * _e196.member_2[0]) * _e814) + (-(_e196.member_2[1]) * _e815)) + (_e196.member_2[2] * _e816))), 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e196.member_6[0] * _e877), (_e196.member_6[1] * _e877), (_e196.member_6[2] * _e877)), 0f, _e819);
                        } else {
                            if (_e176.member_1 == 2u) {
                                let _e691 = bitcast<f32>((1065353216u | (bitcast<u32>(_e196.member_2[2]) & 2147483648u)));
                                let _e693 = (-1f / (_e691 + _e196.member_2[2]));
                                let _e695 = ((_e196.member_2[0] * _e196.member_2[1]) * _e693);
                                let _e709 = (((_e188 * 2f) - 1f) * _e176.member.w);
                                let _e712 = (((_e189 * 2f) - 1f) * _e176.member.w);
                                let _e713 = -(_e176.member.w);
                                let _e715 = ((2f * _e176.member.w) / _e187);
                                let _e744 = (_e715 * _e715);
                                phi_5660_ = false;
                                phi_1794_ = type_59(type_58(vec3<f32>((_e176.member.x + ((((1f + (((_e691 * _e196.member_2[0]) * _e196.member_2[0]) * _e693)) * _e709) + (_e695 * _e712)) + (_e196.member_2[0] * _e713))), (_e176.member.y + ((((_e691 * _e695) * _e709) + ((_e691 + ((_e196.member_2[1] * _e196.member_2[1]) * _e693)) * _e712)) + (_e196.member_2[1] * _e713))), (_e176.member.z + ((((-(_e691) * _e196.member_2[0]) * _e709) + (-(_e196.member_2[1]) * _e712)) + (_e196.member_2[2] * _e713)))), vec3<f32>(_e196.member_2[0], _e196.member_2[1], _e196.member_2[2]), 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e196.member_6[0] * _e744), (_e196.member_6[1] * _e744), (_e196.member_6[2] * _e744)), _e744, 0f);
                            } else {
                                let _e201 = (_e176.member_3 + _e178);
                                if (_e176.member_2 > 0u) {
                                    let _e203 = (_e176.member_2 - 1u);
                                    if (_e203 < _e150) {
                                    } else {
                                        break;
                                    }
                                    let _e208 = lights.member[_e203].member_5;
                                    phi_1223_ = _e208;
                                } else {
                                    phi_1223_ = 0f;
                                }
                                let _e210 = phi_1223_;
                                let _e211 = (1f - _e210);
                                let _e214 = params.member.member_4;
                                let _e218 = f32(_e176.member_4);
                                phi_1237_ = (_e214 - 1u);
                                phi_1240_ = _e176.member_2;
                                loop {
                                    let _e224 = phi_1237_;
                                    let _e226 = phi_1240_;
                                    local_4 = _e226;
                                    local_5 = _e226;
                                    local_6 = _e226;
                                    local_7 = _e226;
                                    local_8 = _e226;
                                    local_9 = _e226;
                                    local_10 = _e226;
                                    let _e227 = (_e226 < _e224);
                                    if _e227 {
                                        let _e229 = ((_e226 + _e224) / 2u);
                                        if (_e229 < _e150) {
                                        } else {
                                            phi_5636_ = true;
                                            break;
                                        }
                                        let _e234 = lights.member[_e229].member_5;
                                        let _e235 = (_e234 > (_e210 + (_e211 * ((f32(_e201) + 0.5f) / _e218))));
                                        if _e235 {
                                            phi_1264_ = _e226;
                                        } else {
                                            phi_1264_ = (_e229 + 1u);
                                        }
                                        let _e238 = phi_1264_;
                                        phi_1238_ = select(_e224, _e229, _e235);
                                        phi_1241_ = _e238;
                                    } else {
                                        phi_1238_ = u32();
                                        phi_1241_ = u32();
                                    }
                                    let _e241 = phi_1238_;
                                    let _e243 = phi_1241_;
                                    continue;
                                    continuing {
                                        phi_1237_ = _e241;
                                        phi_1240_ = _e243;
                                        phi_5636_ = false;
                                        break if !(_e227);
                                    }
                                }
                                let _e246 = phi_5636_;
                                if _e246 {
                                    break;
                                }
                                let _e248 = local_4;
                                if (_e248 < _e150) {
                                } else {
                                    break;
                                }
                                let _e252 = local_5;
                                let _e255 = lights.member[_e252].member;
                                let _e258 = local_6;
                                let _e261 = lights.member[_e258].member_2;
                                let _e264 = local_7;
                                let _e267 = lights.member[_e264].member_3;
                                let _e270 = local_8;
                                let _e273 = lights.member[_e270].member_4;
                                let _e276 = local_9;
                                let _e279 = lights.member[_e276].member_6;
                                let _e282 = local_10;
                                let _e285 = lights.member[_e282].member_7;
                                let _e295 = (_e261[0] - _e255[0]);
                                let _e296 = (_e261[1] - _e255[1]);
                                let _e297 = (_e261[2] - _e255[2]);
                                let _e298 = (_e273[0] - _e255[0]);
                                let _e299 = (_e273[1] - _e255[1]);
                                let _e300 = (_e273[2] - _e255[2]);
                                let _e303 = ((_e296 * _e300) - (_e299 * _e297));
                                let _e306 = ((_e297 * _e298) - (_e300 * _e295));
                                let _e309 = ((_e295 * _e299) - (_e298 * _e296));
                                let _e310 = abs(_e303);
                                let _e311 = abs(_e306);
                                let _e313 = select(_e311, _e310, (_e310 > _e311));
                                let _e314 = abs(_e309);
                                let _e316 = select(_e314, _e313, (_e313 > _e314));
                                if (_e316 > 0.000000000000000000000000000000000000011754944f) {
                                    let _e318 = (_e316 < 340282350000000000000000000000000000000f);
                                    if _e318 {
                                        let _e319 = (_e303 / _e316);
                                        let _e320 = (_e306 / _e316);
                                        let _e321 = (_e309 / _e316);
                                        let _e327 = sqrt((((_e319 * _e319) + (_e320 * _e320)) + (_e321 * _e321)));
                                        phi_1359_ = vec3<f32>((_e319 / _e327), (_e320 / _e327), (_e321 / _e327));
                                    } else {
                                        phi_1359_ = vec3<f32>();
                                    }
                                    let _e333 = phi_1359_;
                                    phi_1361_ = _e333;
                                    phi_1362_ = select(true, false, _e318);
                                } else {
                                    phi_1361_ = vec3<f32>();
                                    phi_1362_ = true;
                                }
                                let _e336 = phi_1361_;
                                let _e338 = phi_1362_;
                                let _e340 = select(_e336, vec3<f32>(0f, 1f, 0f), vec3(_e338));
                                let _e343 = params.member.member_5;
                                let _e347 = ((_e201 * 1664525u) + 1013904223u);
                                let _e349 = (((_e343 * 1664525u) + 1013904223u) + (_e347 * 1013904223u));
                                let _e351 = (_e347 + (1013904223u * _e349));
                                let _e353 = (1013904223u + (_e349 * _e351));
                                let _e355 = (1013904223u + (_e351 * _e353));
                                let _e361 = (_e351 ^ (_e351 >> bitcast<u32>(16i)));
                                let _e369 = ((_e349 ^ (_e349 >> bitcast<u32>(16i))) + (_e361 * (_e355 ^ (_e355 >> bitcast<u32>(16i)))));
                                let _e374 = f32((_e369 >> bitcast<u32>(8i)));
                                let _e375 = (_e374 * 0.000000059604645f);
                                let _e378 = f32(((_e361 + ((_e353 ^ (_e353 >> bitcast<u32>(16i))) * _e369)) >> bitcast<u32>(8i)));
                                let _e379 = (_e378 * 0.000000059604645f);
                                if (_e375 < _e379) {
                                    let _e384 = (_e374 * 0.000000029802322f);
                                    phi_1413_ = vec2<f32>(_e384, (_e379 - _e384));
                                } else {
                                    let _e381 = (_e378 * 0.000000029802322f);
                                    phi_1413_ = vec2<f32>((_e375 - _e381), _e381);
                                }
                                let _e388 = phi_1413_;
                                let _e416 = ((_e343 ^ (_e343 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e420 = ((_e416 ^ (_e416 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e427 = (_e343 ^ 2654435769u);
                                let _e431 = ((_e427 ^ (_e427 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e435 = ((_e431 ^ (_e431 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e443 = (0.000000059604645f * (f32(((2147483648u + (_e201 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e420 ^ (_e420 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                if (_e443 >= 1f) {
                                    phi_4848_ = (_e443 - 1f);
                                } else {
                                    phi_4848_ = _e443;
                                }
                                let _e447 = phi_4848_;
                                let _e449 = (0.000000059604645f * (f32(((2147483648u + (_e201 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e435 ^ (_e435 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                if (_e449 >= 1f) {
                                    phi_4856_ = (_e449 - 1f);
                                } else {
                                    phi_4856_ = _e449;
                                }
                                let _e453 = phi_4856_;
                                let _e455 = ((2f * _e447) - 1f);
                                let _e457 = ((2f * _e453) - 1f);
                                if (_e455 == 0f) {
                                    let _e459 = (_e457 == 0f);
                                    phi_1494_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e459));
                                    phi_1495_ = select(true, false, _e459);
                                } else {
                                    phi_1494_ = vec2<f32>();
                                    phi_1495_ = true;
                                }
                                let _e464 = phi_1494_;
                                let _e466 = phi_1495_;
                                if _e466 {
                                    if (abs(_e455) > abs(_e457)) {
                                        let _e523 = (_e457 / _e455);
                                        let _e527 = floor(((_e523 * 0.5f) + 0.5f));
                                        let _e533 = ((((0.7853982f * _e523) - (_e527 * 1.5703125f)) - (_e527 * 0.0004837513f)) - (_e527 * 0.0000000754979f));
                                        let _e534 = (_e533 * _e533);
                                        let _e541 = (_e533 + ((_e533 * _e534) * (-0.16666655f + (_e534 * (0.008332161f + (_e534 * -0.00019515296f))))));
                                        let _e550 = ((1f - (0.5f * _e534)) + ((_e534 * _e534) * (0.041666646f + (_e534 * (-0.0013887316f + (_e534 * 0.000024433157f))))));
                                        let _e557 = select(0i, select(select(i32(_e527), i32(-2147483648), (_e527 < -2147483600f)), 2147483647i, (_e527 > 2147483500f)), (_e527 == _e527));
                                        let _e559 = ((_e557 & 1i) == 0i);
                                        let _e560 = select(_e550, _e541, _e559);
                                        let _e561 = select(_e541, _e550, _e559);
                                        if ((_e557 & 2i) == 0i) {
                                            phi_1559_ = _e560;
                                        } else {
                                            phi_1559_ = -(_e560);
                                        }
                                        let _e566 = phi_1559_;
                                        if (((_e557 + 1i) & 2i) == 0i) {
                                            phi_1567_ = _e561;
                                        } else {
                                            phi_1567_ = -(_e561);
                                        }
                                        let _e572 = phi_1567_;
                                        phi_1637_ = vec2<f32>((_e455 * _e572), (_e455 * _e566));
                                    } else {
                                        let _e470 = (_e455 / _e457);
                                        let _e474 = floor(((_e470 * 0.5f) + 0.5f));
                                        let _e480 = ((((0.7853982f * _e470) - (_e474 * 1.5703125f)) - (_e474 * 0.0004837513f)) - (_e474 * 0.0000000754979f));
                                        let _e481 = (_e480 * _e480);
                                        let _e488 = (_e480 + ((_e480 * _e481) * (-0.16666655f + (_e481 * (0.008332161f + (_e481 * -0.00019515296f))))));
                                        let _e497 = ((1f - (0.5f * _e481)) + ((_e481 * _e481) * (0.041666646f + (_e481 * (-0.0013887316f + (_e481 * 0.000024433157f))))));
                                        let _e504 = select(0i, select(select(i32(_e474), i32(-2147483648), (_e474 < -2147483600f)), 2147483647i, (_e474 > 2147483500f)), (_e474 == _e474));
                                        let _e506 = ((_e504 & 1i) == 0i);
                                        let _e507 = select(_e497, _e488, _e506);
                                        let _e508 = select(_e488, _e497, _e506);
                                        if ((_e504 & 2i) == 0i) {
                                            phi_1625_ = _e507;
                                        } else {
                                            phi_1625_ = -(_e507);
                                        }
                                        let _e513 = phi_1625_;
                                        if (((_e504 + 1i) & 2i) == 0i) {
                                            phi_1633_ = _e508;
                                        } else {
                                            phi_1633_ = -(_e508);
                                        }
                                        let _e519 = phi_1633_;
                                        phi_1637_ = vec2<f32>((_e457 * _e513), (_e457 * _e519));
                                    }
                                    let _e577 = phi_1637_;
                                    phi_1638_ = _e577;
                                } else {
                                    phi_1638_ = _e464;
                                }
                                let _e579 = phi_1638_;
                                let _e585 = (1f - ((_e579.x * _e579.x) + (_e579.y * _e579.y)));
                                let _e588 = sqrt(select(0f, _e585, (_e585 > 0f)));
                                let _e593 = bitcast<f32>((1065353216u | (bitcast<u32>(_e340.z) & 2147483648u)));
                                let _e595 = (-1f / (_e593 + _e340.z));
                                let _e599 = ((_e340.x * _e340.y) * _e595);
                                let _e623 = ((((1f + (((_e593 * _e340.x) * _e340.x) * _e595)) * _e579.x) + (_e599 * _e579.y)) + (_e340.x * _e588));
                                let _e624 = ((((_e593 * _e599) * _e579.x) + ((_e593 + ((_e340.y * _e340.y) * _e595)) * _e579.y)) + (_e340.y * _e588));
                                let _e625 = ((((-(_e593) * _e340.x) * _e579.x) + (-(_e340.y) * _e579.y)) + (_e340.z * _e588));
                                let _e630 = ((_e218 * _e285) / select(0.000000000000000000000000000000000000011754944f, _e211, (_e211 > 0.000000000000000000000000000000000000011754944f)));
                                let _e633 = abs(_e255[0]);
                                let _e634 = abs(_e255[1]);
                                let _e635 = abs(_e255[2]);
                                let _e637 = select(_e634, _e633, (_e633 > _e634));
                                let _e639 = select(_e635, _e637, (_e637 > _e635));
                                let _e640 = abs(_e295);
                                let _e641 = abs(_e296);
                                let _e642 = abs(_e297);
                                let _e644 = select(_e641, _e640, (_e640 > _e641));
                                let _e646 = select(_e642, _e644, (_e644 > _e642));
                                let _e648 = select(_e646, _e639, (_e639 > _e646));
                                if ((((_e340.x * _e623) + (_e340.y * _e624)) + (_e340.z * _e625)) < 0f) {
                                    phi_1763_ = (_e648 * -0.000001f);
                                } else {
                                    phi_1763_ = (_e648 * 0.000001f);
                                }
                                let _e658 = phi_1763_;
                                let _e671 = ((3.1415927f * _e267) / select(0.000000000000000000000000000000000000011754944f, _e630, (_e630 > 0.000000000000000000000000000000000000011754944f)));
                                phi_5660_ = _e246;
                                phi_1794_ = type_59(type_58(vec3<f32>((((_e255[0] + (_e295 * _e388.x)) + (_e298 * _e388.y)) + (_e340.x * _e658)), (((_e255[1] + (_e296 * _e388.x)) + (_e299 * _e388.y)) + (_e340.y * _e658)), (((_e255[2] + (_e297 * _e388.x)) + (_e300 * _e388.y)) + (_e340.z * _e658))), vec3<f32>(_e623, _e624, _e625), 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e279[0] * _e671), (_e279[1] * _e671), (_e279[2] * _e671)), 0f, (3.1415927f / (_e218 * select(0.05f, _e588, (_e588 > 0.05f)))));
                            }
                            let _e751 = phi_5660_;
                            let _e753 = phi_1794_;
                            phi_5659_ = _e751;
                            phi_1795_ = _e753;
                        }
                        let _e884 = phi_5659_;
                        let _e886 = phi_1795_;
                        phi_5658_ = _e884;
                        phi_1796_ = _e886;
                    }
                    let _e1402 = phi_5658_;
                    let _e1404 = phi_1796_;
                    phi_5657_ = _e1402;
                    phi_1797_ = _e1404;
                }
                let _e1752 = phi_5657_;
                let _e1754 = phi_1797_;
                let _e1758 = abs(_e1754.member.member_1.x);
                let _e1762 = abs(_e1754.member.member_1.y);
                let _e1766 = abs(_e1754.member.member_1.z);
                let _e1767 = (_e1758 > _e1762);
                if _e1767 {
                    phi_1817_ = (_e1758 > _e1766);
                } else {
                    phi_1817_ = (_e1762 > _e1766);
                }
                let _e1771 = phi_1817_;
                let _e1772 = select(1u, 0u, _e1767);
                if _e1771 {
                    let _e1773 = (_e1772 + 1u);
                    phi_1827_ = _e1773;
                    phi_1830_ = select(true, false, (_e1773 == 2u));
                } else {
                    phi_1827_ = u32();
                    phi_1830_ = false;
                }
                let _e1777 = phi_1827_;
                let _e1779 = phi_1830_;
                let _e1780 = select(true, false, _e1771);
                let _e1781 = select(_e1777, 0u, _e1780);
                let _e1783 = select(_e1779, true, _e1780);
                if _e1783 {
                    phi_1841_ = (_e1781 + 1u);
                } else {
                    phi_1841_ = 0u;
                }
                let _e1786 = phi_1841_;
                let _e1787 = select(_e1777, _e1781, _e1783);
                let _e1788 = select(_e1772, select(_e1772, 2u, _e1780), _e1783);
                local_2 = array<f32, 3>(_e1754.member.member_1.x, _e1754.member.member_1.y, _e1754.member.member_1.z);
                local_3 = array<f32, 3>(_e1754.member.member.x, _e1754.member.member.y, _e1754.member.member.z);
                let _e1800 = (_e1788 < 3u);
                if _e1800 {
                } else {
                    break;
                }
                let _e1802 = local_2[_e1788];
                let _e1803 = (1f / _e1802);
                let _e1804 = (_e1787 < 3u);
                if _e1804 {
                } else {
                    break;
                }
                let _e1806 = local_2[_e1787];
                let _e1807 = (_e1806 * _e1803);
                let _e1808 = (_e1786 < 3u);
                if _e1808 {
                } else {
                    break;
                }
                let _e1810 = local_2[_e1786];
                let _e1811 = (_e1810 * _e1803);
                if _e1804 {
                } else {
                    break;
                }
                let _e1813 = local_3[_e1787];
                if _e1808 {
                } else {
                    break;
                }
                let _e1815 = local_3[_e1786];
                if _e1800 {
                } else {
                    break;
                }
                let _e1817 = local_3[_e1788];
                if (0u < _e139) {
                } else {
                    break;
                }
                let _e1822 = nodes.member[0u].member_7[0u];
                let _e1826 = nodes.member[0u].member_7[1u];
                let _e1830 = nodes.member[0u].member_7[2u];
                let _e1834 = nodes.member[0u].member_7[3u];
                let _e1836 = abs((_e1754.member.member.x - _e1822));
                let _e1838 = abs((_e1754.member.member.y - _e1826));
                let _e1840 = select(_e1838, _e1836, (_e1836 > _e1838));
                let _e1842 = abs((_e1754.member.member.z - _e1830));
                let _e1846 = ((select(_e1842, _e1840, (_e1840 > _e1842)) + _e1834) * 0.0000009536743f);
                let _e1853 = (_e1846 + (abs(_e1754.member.member.x) * 0.00000023841858f));
                let _e1854 = (_e1846 + (abs(_e1754.member.member.y) * 0.00000023841858f));
                let _e1855 = (_e1846 + (abs(_e1754.member.member.z) * 0.00000023841858f));
                let _e1856 = select(_e1762, _e1758, _e1767);
                let _e1858 = select(_e1766, _e1856, (_e1856 > _e1766));
                let _e1859 = (_e1858 * 0.000000000001f);
                let _e1863 = (_e1754.member.member.x + _e1853);
                let _e1865 = (_e1754.member.member.y + _e1854);
                let _e1867 = (_e1754.member.member.z + _e1855);
                let _e1868 = (_e1754.member.member.x - _e1853);
                let _e1869 = (_e1754.member.member.y - _e1854);
                let _e1870 = (_e1754.member.member.z - _e1855);
                if (_e1758 > _e1859) {
                    phi_1994_ = (1f / _e1754.member.member_1.x);
                } else {
                    phi_1994_ = (1000000000000f / _e1858);
                }
                let _e1875 = phi_1994_;
                if (_e1762 > _e1859) {
                    phi_2002_ = (1f / _e1754.member.member_1.y);
                } else {
                    phi_2002_ = (1000000000000f / _e1858);
                }
                let _e1880 = phi_2002_;
                if (_e1766 > _e1859) {
                    phi_2010_ = (1f / _e1754.member.member_1.z);
                } else {
                    phi_2010_ = (1000000000000f / _e1858);
                }
                let _e1885 = phi_2010_;
                local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                local_1 = array<f32, 64>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                phi_5645_ = _e1752;
                phi_2014_ = 0u;
                phi_2017_ = 0u;
                phi_2019_ = type_64(_e1754.member.member_3, 4294967295u, 0f, 0f);
                loop {
                    let _e1890 = phi_5645_;
                    let _e1892 = phi_2014_;
                    let _e1894 = phi_2017_;
                    let _e1896 = phi_2019_;
                    let _e1897 = (_e1892 & 15u);
                    let _e1899 = (_e1892 >> bitcast<u32>(4u));
                    if (_e1897 == 0u) {
                        if (_e1899 < _e139) {
                        } else {
                            phi_5880_ = true;
                            phi_4824_ = type_64();
                            break;
                        }
                        let _e2599 = nodes.member[_e1899].member;
                        let _e2608 = ((_e2599.x - _e1863) * _e1875);
                        let _e2609 = ((_e2599.y - _e1863) * _e1875);
                        let _e2610 = ((_e2599.z - _e1863) * _e1875);
                        let _e2611 = ((_e2599.w - _e1863) * _e1875);
                        let _e2614 = nodes.member[_e1899].member_3;
                        let _e2623 = ((_e2614.x - _e1868) * _e1875);
                        let _e2624 = ((_e2614.y - _e1868) * _e1875);
                        let _e2625 = ((_e2614.z - _e1868) * _e1875);
                        let _e2626 = ((_e2614.w - _e1868) * _e1875);
                        let _e2629 = nodes.member[_e1899].member_1;
                        let _e2638 = ((_e2629.x - _e1865) * _e1880);
                        let _e2639 = ((_e2629.y - _e1865) * _e1880);
                        let _e2640 = ((_e2629.z - _e1865) * _e1880);
                        let _e2641 = ((_e2629.w - _e1865) * _e1880);
                        let _e2644 = nodes.member[_e1899].member_4;
                        let _e2653 = ((_e2644.x - _e1869) * _e1880);
                        let _e2654 = ((_e2644.y - _e1869) * _e1880);
                        let _e2655 = ((_e2644.z - _e1869) * _e1880);
                        let _e2656 = ((_e2644.w - _e1869) * _e1880);
                        let _e2659 = nodes.member[_e1899].member_2;
                        let _e2668 = ((_e2659.x - _e1867) * _e1885);
                        let _e2669 = ((_e2659.y - _e1867) * _e1885);
                        let _e2670 = ((_e2659.z - _e1867) * _e1885);
                        let _e2671 = ((_e2659.w - _e1867) * _e1885);
                        let _e2674 = nodes.member[_e1899].member_5;
                        let _e2683 = ((_e2674.x - _e1870) * _e1885);
                        let _e2684 = ((_e2674.y - _e1870) * _e1885);
                        let _e2685 = ((_e2674.z - _e1870) * _e1885);
                        let _e2686 = ((_e2674.w - _e1870) * _e1885);
                        let _e2688 = select(_e2623, _e2608, (_e2608 < _e2623));
                        let _e2690 = select(_e2624, _e2609, (_e2609 < _e2624));
                        let _e2692 = select(_e2625, _e2610, (_e2610 < _e2625));
                        let _e2694 = select(_e2626, _e2611, (_e2611 < _e2626));
                        let _e2696 = select(_e2653, _e2638, (_e2638 < _e2653));
                        let _e2698 = select(_e2654, _e2639, (_e2639 < _e2654));
                        let _e2700 = select(_e2655, _e2640, (_e2640 < _e2655));
                        let _e2702 = select(_e2656, _e2641, (_e2641 < _e2656));
                        let _e2704 = select(_e2696, _e2688, (_e2688 > _e2696));
                        let _e2706 = select(_e2698, _e2690, (_e2690 > _e2698));
                        let _e2708 = select(_e2700, _e2692, (_e2692 > _e2700));
                        let _e2710 = select(_e2702, _e2694, (_e2694 > _e2702));
                        let _e2712 = select(_e2683, _e2668, (_e2668 < _e2683));
                        let _e2714 = select(_e2684, _e2669, (_e2669 < _e2684));
                        let _e2716 = select(_e2685, _e2670, (_e2670 < _e2685));
                        let _e2718 = select(_e2686, _e2671, (_e2671 < _e2686));
                        let _e2720 = select(_e2712, _e2704, (_e2704 > _e2712));
                        let _e2722 = select(_e2714, _e2706, (_e2706 > _e2714));
                        let _e2724 = select(_e2716, _e2708, (_e2708 > _e2716));
                        let _e2726 = select(_e2718, _e2710, (_e2710 > _e2718));
                        let _e2728 = select(_e1754.member.member_2, _e2720, (_e2720 > _e1754.member.member_2));
                        let _e2730 = select(_e1754.member.member_2, _e2722, (_e2722 > _e1754.member.member_2));
                        let _e2732 = select(_e1754.member.member_2, _e2724, (_e2724 > _e1754.member.member_2));
                        let _e2734 = select(_e1754.member.member_2, _e2726, (_e2726 > _e1754.member.member_2));
                        let _e2736 = select(_e2623, _e2608, (_e2608 > _e2623));
                        let _e2738 = select(_e2624, _e2609, (_e2609 > _e2624));
                        let _e2740 = select(_e2625, _e2610, (_e2610 > _e2625));
                        let _e2742 = select(_e2626, _e2611, (_e2611 > _e2626));
                        let _e2744 = select(_e2653, _e2638, (_e2638 > _e2653));
                        let _e2746 = select(_e2654, _e2639, (_e2639 > _e2654));
                        let _e2748 = select(_e2655, _e2640, (_e2640 > _e2655));
                        let _e2750 = select(_e2656, _e2641, (_e2641 > _e2656));
                        let _e2752 = select(_e2744, _e2736, (_e2736 < _e2744));
                        let _e2754 = select(_e2746, _e2738, (_e2738 < _e2746));
                        let _e2756 = select(_e2748, _e2740, (_e2740 < _e2748));
                        let _e2758 = select(_e2750, _e2742, (_e2742 < _e2750));
                        let _e2760 = select(_e2683, _e2668, (_e2668 > _e2683));
                        let _e2762 = select(_e2684, _e2669, (_e2669 > _e2684));
                        let _e2764 = select(_e2685, _e2670, (_e2670 > _e2685));
                        let _e2766 = select(_e2686, _e2671, (_e2671 > _e2686));
                        let _e2768 = select(_e2760, _e2752, (_e2752 < _e2760));
                        let _e2770 = select(_e2762, _e2754, (_e2754 < _e2762));
                        let _e2772 = select(_e2764, _e2756, (_e2756 < _e2764));
                        let _e2774 = select(_e2766, _e2758, (_e2758 < _e2766));
                        let _e2784 = select(340282350000000000000000000000000000000f, _e2728, (_e2728 <= select(_e1896.member, _e2768, (_e2768 < _e1896.member))));
                        let _e2786 = select(340282350000000000000000000000000000000f, _e2730, (_e2730 <= select(_e1896.member, _e2770, (_e2770 < _e1896.member))));
                        let _e2788 = select(340282350000000000000000000000000000000f, _e2732, (_e2732 <= select(_e1896.member, _e2772, (_e2772 < _e1896.member))));
                        let _e2790 = select(340282350000000000000000000000000000000f, _e2734, (_e2734 <= select(_e1896.member, _e2774, (_e2774 < _e1896.member))));
                        let _e2794 = nodes.member[_e1899].member_6[0u];
                        let _e2798 = nodes.member[_e1899].member_6[1u];
                        let _e2802 = nodes.member[_e1899].member_6[2u];
                        let _e2806 = nodes.member[_e1899].member_6[3u];
                        if (_e2786 < _e2784) {
                            phi_2401_ = type_65(_e2786, _e2798, _e2784, _e2794);
                        } else {
                            phi_2401_ = type_65(_e2784, _e2794, _e2786, _e2798);
                        }
                        let _e2811 = phi_2401_;
                        if (_e2790 < _e2788) {
                            phi_2412_ = type_65(_e2790, _e2806, _e2788, _e2802);
                        } else {
                            phi_2412_ = type_65(_e2788, _e2802, _e2790, _e2806);
                        }
                        let _e2820 = phi_2412_;
                        if (_e2820.member < _e2811.member) {
                            phi_2423_ = type_65(_e2820.member, _e2820.member_1, _e2811.member, _e2811.member_1);
                        } else {
                            phi_2423_ = type_65(_e2811.member, _e2811.member_1, _e2820.member, _e2820.member_1);
                        }
                        let _e2829 = phi_2423_;
                        if (_e2820.member_2 < _e2811.member_2) {
                            phi_2434_ = type_65(_e2820.member_2, _e2820.member_3, _e2811.member_2, _e2811.member_3);
                        } else {
                            phi_2434_ = type_65(_e2811.member_2, _e2811.member_3, _e2820.member_2, _e2820.member_3);
                        }
                        let _e2838 = phi_2434_;
                        if (_e2829.member_2 < _e2838.member) {
                            phi_2445_ = type_65(_e2829.member_2, _e2829.member_3, _e2838.member, _e2838.member_1);
                        } else {
                            phi_2445_ = type_65(_e2838.member, _e2838.member_1, _e2829.member_2, _e2829.member_3);
                        }
                        let _e2847 = phi_2445_;
                        if (_e2838.member_2 < 340282350000000000000000000000000000000f) {
                            let _e2853 = (_e1894 < 64u);
                            if _e2853 {
                            } else {
                                phi_5880_ = true;
                                phi_4824_ = type_64();
                                break;
                            }
                            local[_e1894] = _e2838.member_3;
                            if _e2853 {
                            } else {
                                phi_5880_ = true;
                                phi_4824_ = type_64();
                                break;
                            }
                            local_1[_e1894] = _e2838.member_2;
                            phi_2467_ = (_e1894 + 1u);
                        } else {
                            phi_2467_ = _e1894;
                        }
                        let _e2858 = phi_2467_;
                        if (_e2847.member_2 < 340282350000000000000000000000000000000f) {
                            let _e2860 = (_e2858 < 64u);
                            if _e2860 {
                            } else {
                                phi_5880_ = true;
                                phi_4824_ = type_64();
                                break;
                            }
                            local[_e2858] = _e2847.member_3;
                            if _e2860 {
                            } else {
                                phi_5880_ = true;
                                phi_4824_ = type_64();
                                break;
                            }
                            local_1[_e2858] = _e2847.member_2;
                            phi_2485_ = (_e2858 + 1u);
                        } else {
                            phi_2485_ = _e2858;
                        }
                        let _e2865 = phi_2485_;
                        if (_e2847.member < 340282350000000000000000000000000000000f) {
                            let _e2867 = (_e2865 < 64u);
                            if _e2867 {
                            } else {
                                phi_5880_ = true;
                                phi_4824_ = type_64();
                                break;
                            }
                            local[_e2865] = _e2847.member_1;
                            if _e2867 {
                            } else {
                                phi_5880_ = true;
                                phi_4824_ = type_64();
                                break;
                            }
                            local_1[_e2865] = _e2847.member;
                            phi_2503_ = (_e2865 + 1u);
                        } else {
                            phi_2503_ = _e2865;
                        }
                        let _e2872 = phi_2503_;
                        phi_5816_ = _e1890;
                        phi_3326_ = select(0u, _e2829.member_1, (_e2829.member < 340282350000000000000000000000000000000f));
                        phi_3327_ = _e2872;
                        phi_2020_ = _e1896;
                    } else {
                        phi_2512_ = type_12(_e1899, (_e1899 + _e1897));
                        phi_2515_ = _e1896;
                        loop {
                            let _e1904 = phi_2512_;
                            let _e1906 = phi_2515_;
                            local_14 = _e1906;
                            if (_e1904.member < _e1904.member_1) {
                                phi_2513_ = type_12((_e1904.member + 1u), _e1904.member_1);
                                phi_2538_ = type_12(1u, _e1904.member);
                            } else {
                                phi_2513_ = _e1904;
                                phi_2538_ = type_12(0u, type_12().member_1);
                            }
                            let _e1919 = phi_2513_;
                            let _e1921 = phi_2538_;
                            let _e1925 = (bitcast<i32>(_e1921.member) != 0i);
                            if _e1925 {
                                let _e1926 = (_e1921.member_1 < _e142);
                                if _e1926 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                if _e1800 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                let _e1930 = triangles.member[_e1921.member_1].member[_e1788];
                                let _e1931 = (_e1930 - _e1817);
                                if _e1800 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                let _e1935 = triangles.member[_e1921.member_1].member_2[_e1788];
                                let _e1936 = (_e1935 - _e1817);
                                if _e1800 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                let _e1940 = triangles.member[_e1921.member_1].member_4[_e1788];
                                let _e1941 = (_e1940 - _e1817);
                                if _e1804 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                let _e1945 = triangles.member[_e1921.member_1].member[_e1787];
                                let _e1948 = ((_e1945 - _e1813) - (_e1807 * _e1931));
                                if _e1808 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                let _e1952 = triangles.member[_e1921.member_1].member[_e1786];
                                let _e1955 = ((_e1952 - _e1815) - (_e1811 * _e1931));
                                if _e1804 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                let _e1959 = triangles.member[_e1921.member_1].member_2[_e1787];
                                let _e1962 = ((_e1959 - _e1813) - (_e1807 * _e1936));
                                if _e1808 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                let _e1966 = triangles.member[_e1921.member_1].member_2[_e1786];
                                let _e1969 = ((_e1966 - _e1815) - (_e1811 * _e1936));
                                if _e1804 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                let _e1973 = triangles.member[_e1921.member_1].member_4[_e1787];
                                let _e1976 = ((_e1973 - _e1813) - (_e1807 * _e1941));
                                if _e1808 {
                                } else {
                                    phi_5641_ = true;
                                    break;
                                }
                                let _e1980 = triangles.member[_e1921.member_1].member_4[_e1786];
                                let _e1983 = ((_e1980 - _e1815) - (_e1811 * _e1941));
                                let _e1984 = (_e1976 * _e1969);
                                let _e1985 = (_e1983 * _e1962);
                                if (_e1984 != _e1985) {
                                    phi_2654_ = (_e1984 - _e1985);
                                } else {
                                    let _e1987 = (_e1976 * 4097f);
                                    let _e1989 = (_e1987 - (_e1987 - _e1976));
                                    let _e1990 = (_e1969 * 4097f);
                                    let _e1992 = (_e1990 - (_e1990 - _e1969));
                                    let _e1993 = (_e1976 - _e1989);
                                    let _e1994 = (_e1969 - _e1992);
                                    let _e2003 = (_e1983 * 4097f);
                                    let _e2005 = (_e2003 - (_e2003 - _e1983));
                                    let _e2006 = (_e1962 * 4097f);
                                    let _e2008 = (_e2006 - (_e2006 - _e1962));
                                    let _e2009 = (_e1983 - _e2005);
                                    let _e2010 = (_e1962 - _e2008);
                                    phi_2654_ = ((((((_e1989 * _e1992) - _e1984) + (_e1989 * _e1994)) + (_e1993 * _e1992)) + (_e1993 * _e1994)) - (((((_e2005 * _e2008) - _e1985) + (_e2005 * _e2010)) + (_e2009 * _e2008)) + (_e2009 * _e2010)));
                                }
                                let _e2022 = phi_2654_;
                                let _e2023 = (_e1948 * _e1983);
                                let _e2024 = (_e1955 * _e1976);
                                if (_e2023 != _e2024) {
                                    phi_2665_ = (_e2023 - _e2024);
                                } else {
                                    let _e2026 = (_e1948 * 4097f);
                                    let _e2028 = (_e2026 - (_e2026 - _e1948));
                                    let _e2029 = (_e1983 * 4097f);
                                    let _e2031 = (_e2029 - (_e2029 - _e1983));
                                    let _e2032 = (_e1948 - _e2028);
                                    let _e2033 = (_e1983 - _e2031);
                                    let _e2042 = (_e1955 * 4097f);
                                    let _e2044 = (_e2042 - (_e2042 - _e1955));
                                    let _e2045 = (_e1976 * 4097f);
                                    let _e2047 = (_e2045 - (_e2045 - _e1976));
                                    let _e2048 = (_e1955 - _e2044);
                                    let _e2049 = (_e1976 - _e2047);
                                    phi_2665_ = ((((((_e2028 * _e2031) - _e2023) + (_e2028 * _e2033)) + (_e2032 * _e2031)) + (_e2032 * _e2033)) - (((((_e2044 * _e2047) - _e2024) + (_e2044 * _e2049)) + (_e2048 * _e2047)) + (_e2048 * _e2049)));
                                }
                                let _e2061 = phi_2665_;
                                let _e2062 = (_e1962 * _e1955);
                                let _e2063 = (_e1969 * _e1948);
                                if (_e2062 != _e2063) {
                                    phi_2676_ = (_e2062 - _e2063);
                                } else {
                                    let _e2065 = (_e1962 * 4097f);
                                    let _e2067 = (_e2065 - (_e2065 - _e1962));
                                    let _e2068 = (_e1955 * 4097f);
                                    let _e2070 = (_e2068 - (_e2068 - _e1955));
                                    let _e2071 = (_e1962 - _e2067);
                                    let _e2072 = (_e1955 - _e2070);
                                    let _e2081 = (_e1969 * 4097f);
                                    let _e2083 = (_e2081 - (_e2081 - _e1969));
                                    let _e2084 = (_e1948 * 4097f);
                                    let _e2086 = (_e2084 - (_e2084 - _e1948));
                                    let _e2087 = (_e1969 - _e2083);
                                    let _e2088 = (_e1948 - _e2086);
                                    phi_2676_ = ((((((_e2067 * _e2070) - _e2062) + (_e2067 * _e2072)) + (_e2071 * _e2070)) + (_e2071 * _e2072)) - (((((_e2083 * _e2086) - _e2063) + (_e2083 * _e2088)) + (_e2087 * _e2086)) + (_e2087 * _e2088)));
                                }
                                let _e2100 = phi_2676_;
                                if (_e2022 < 0f) {
                                    phi_2694_ = f32();
                                    phi_2695_ = true;
                                } else {
                                    if (_e2061 < 0f) {
                                        phi_2692_ = f32();
                                        phi_2693_ = true;
                                    } else {
                                        let _e2103 = (_e2100 < 0f);
                                        if _e2103 {
                                            phi_2691_ = f32();
                                        } else {
                                            phi_2691_ = ((_e2022 + _e2061) + _e2100);
                                        }
                                        let _e2107 = phi_2691_;
                                        phi_2692_ = _e2107;
                                        phi_2693_ = _e2103;
                                    }
                                    let _e2109 = phi_2692_;
                                    let _e2111 = phi_2693_;
                                    phi_2694_ = _e2109;
                                    phi_2695_ = _e2111;
                                }
                                let _e2113 = phi_2694_;
                                let _e2115 = phi_2695_;
                                if _e2115 {
                                    if (_e2022 > 0f) {
                                        phi_2716_ = f32();
                                        phi_2717_ = true;
                                        phi_2718_ = false;
                                    } else {
                                        let _e2117 = (_e2061 > 0f);
                                        if _e2117 {
                                            phi_2714_ = f32();
                                            phi_2715_ = false;
                                        } else {
                                            phi_2714_ = ((_e2022 + _e2061) + _e2100);
                                            phi_2715_ = select(true, false, (_e2100 > 0f));
                                        }
                                        let _e2123 = phi_2714_;
                                        let _e2125 = phi_2715_;
                                        phi_2716_ = _e2123;
                                        phi_2717_ = _e2117;
                                        phi_2718_ = _e2125;
                                    }
                                    let _e2127 = phi_2716_;
                                    let _e2129 = phi_2717_;
                                    let _e2131 = phi_2718_;
                                    phi_2723_ = _e2127;
                                    phi_2724_ = select(_e2131, false, _e2129);
                                } else {
                                    phi_2723_ = _e2113;
                                    phi_2724_ = true;
                                }
                                let _e2134 = phi_2723_;
                                let _e2136 = phi_2724_;
                                if _e2136 {
                                    let _e2137 = (_e2134 == 0f);
                                    if _e2137 {
                                        phi_2812_ = array<f32, 3>();
                                        phi_2813_ = array<f32, 3>();
                                        phi_2814_ = false;
                                    } else {
                                        let _e2138 = (_e1931 * _e1803);
                                        let _e2139 = (_e1936 * _e1803);
                                        let _e2140 = (_e1941 * _e1803);
                                        let _e2143 = (1f / ((_e2022 + _e2061) + _e2100));
                                        let _e2144 = (_e2061 * _e2143);
                                        let _e2145 = (_e2100 * _e2143);
                                        let _e2151 = ((((_e2022 * _e2143) * _e2138) + (_e2144 * _e2139)) + (_e2145 * _e2140));
                                        let _e2152 = abs(_e1948);
                                        let _e2153 = abs(_e1962);
                                        let _e2155 = select(_e2153, _e2152, (_e2152 > _e2153));
                                        let _e2156 = abs(_e1976);
                                        let _e2159 = abs(_e1955);
                                        let _e2160 = abs(_e1969);
                                        let _e2162 = select(_e2160, _e2159, (_e2159 > _e2160));
                                        let _e2163 = abs(_e1983);
                                        let _e2167 = abs(_e2138);
                                        let _e2168 = abs(_e2139);
                                        let _e2170 = select(_e2168, _e2167, (_e2167 > _e2168));
                                        let _e2171 = abs(_e2140);
                                        let _e2178 = (((select(_e2156, _e2155, (_e2155 > _e2156)) * select(_e2163, _e2162, (_e2162 > _e2163))) * select(_e2171, _e2170, (_e2170 > _e2171))) <= (abs((_e2134 * _e2151)) * 256f));
                                        if _e2178 {
                                            phi_2810_ = array<f32, 3>(_e2151, _e2144, _e2145);
                                            phi_2811_ = array<f32, 3>();
                                        } else {
                                            let _e2180 = (_e1976 * 4097f);
                                            let _e2182 = (_e2180 - (_e2180 - _e1976));
                                            let _e2183 = (_e1969 * 4097f);
                                            let _e2185 = (_e2183 - (_e2183 - _e1969));
                                            let _e2186 = (_e1976 - _e2182);
                                            let _e2187 = (_e1969 - _e2185);
                                            let _e2196 = (_e1983 * 4097f);
                                            let _e2198 = (_e2196 - (_e2196 - _e1983));
                                            let _e2199 = (_e1962 * 4097f);
                                            let _e2201 = (_e2199 - (_e2199 - _e1962));
                                            let _e2202 = (_e1983 - _e2198);
                                            let _e2203 = (_e1962 - _e2201);
                                            let _e2213 = ((_e1984 - _e1985) + ((((((_e2182 * _e2185) - _e1984) + (_e2182 * _e2187)) + (_e2186 * _e2185)) + (_e2186 * _e2187)) - (((((_e2198 * _e2201) - _e1985) + (_e2198 * _e2203)) + (_e2202 * _e2201)) + (_e2202 * _e2203))));
                                            let _e2215 = (_e1948 * 4097f);
                                            let _e2217 = (_e2215 - (_e2215 - _e1948));
                                            let _e2218 = (_e1948 - _e2217);
                                            let _e2227 = (_e1955 * 4097f);
                                            let _e2229 = (_e2227 - (_e2227 - _e1955));
                                            let _e2230 = (_e1955 - _e2229);
                                            let _e2240 = ((_e2023 - _e2024) + ((((((_e2217 * _e2198) - _e2023) + (_e2217 * _e2202)) + (_e2218 * _e2198)) + (_e2218 * _e2202)) - (((((_e2229 * _e2182) - _e2024) + (_e2229 * _e2186)) + (_e2230 * _e2182)) + (_e2230 * _e2186))));
                                            let _e2259 = ((_e2062 - _e2063) + ((((((_e2201 * _e2229) - _e2062) + (_e2201 * _e2230)) + (_e2203 * _e2229)) + (_e2203 * _e2230)) - (((((_e2185 * _e2217) - _e2063) + (_e2185 * _e2218)) + (_e2187 * _e2217)) + (_e2187 * _e2218))));
                                            let _e2262 = (1f / ((_e2213 + _e2240) + _e2259));
                                            let _e2263 = (_e2240 * _e2262);
                                            let _e2264 = (_e2259 * _e2262);
                                            phi_2810_ = array<f32, 3>();
                                            phi_2811_ = array<f32, 3>(((((_e2213 * _e2262) * _e2138) + (_e2263 * _e2139)) + (_e2264 * _e2140)), _e2263, _e2264);
                                        }
                                        let _e2274 = phi_2810_;
                                        let _e2276 = phi_2811_;
                                        phi_2812_ = _e2274;
                                        phi_2813_ = _e2276;
                                        phi_2814_ = _e2178;
                                    }
                                    let _e2278 = phi_2812_;
                                    let _e2280 = phi_2813_;
                                    let _e2282 = phi_2814_;
                                    phi_2815_ = _e2278;
                                    phi_2816_ = _e2280;
                                    phi_2817_ = _e2137;
                                    phi_2818_ = _e2282;
                                } else {
                                    phi_2815_ = array<f32, 3>();
                                    phi_2816_ = array<f32, 3>();
                                    phi_2817_ = true;
                                    phi_2818_ = false;
                                }
                                let _e2284 = phi_2815_;
                                let _e2286 = phi_2816_;
                                let _e2288 = phi_2817_;
                                let _e2290 = phi_2818_;
                                if _e2288 {
                                    phi_2823_ = array<f32, 3>(-1f, 0f, 0f);
                                } else {
                                    phi_2823_ = _e2284;
                                }
                                let _e2292 = phi_2823_;
                                if select(_e2290, true, _e2288) {
                                    phi_2828_ = _e2292;
                                } else {
                                    phi_2828_ = _e2286;
                                }
                                let _e2295 = phi_2828_;
                                if (_e2295[0] >= _e1754.member.member_2) {
                                    let _e2303 = (_e2295[0] < _e1906.member);
                                    if _e2303 {
                                        let _e2304 = (_e2295[0] >= 0f);
                                        if _e2304 {
                                            if _e1926 {
                                            } else {
                                                phi_5641_ = true;
                                                break;
                                            }
                                            let _e2307 = triangles.member[_e1921.member_1].member_3;
                                            if ((_e2307 & 1u) == 0u) {
                                                phi_3295_ = true;
                                            } else {
                                                if _e1926 {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                let _e2312 = triangles.member[_e1921.member_1].member_1;
                                                let _e2313 = (_e2312 * 12u);
                                                if ((256u + _e2313) < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                if ((_e2313 + 257u) < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                if ((_e2313 + 258u) < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                let _e2320 = (_e2313 + 259u);
                                                if (_e2320 < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                let _e2323 = surfaces.member[_e2320];
                                                if ((_e2313 + 260u) < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                if ((_e2313 + 261u) < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                if ((_e2313 + 262u) < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                let _e2330 = (_e2313 + 263u);
                                                if (_e2330 < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                let _e2333 = surfaces.member[_e2330];
                                                let _e2334 = (_e2313 + 264u);
                                                if (_e2334 < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                let _e2337 = surfaces.member[_e2334];
                                                let _e2338 = bitcast<f32>(_e2337);
                                                let _e2339 = (_e2313 + 265u);
                                                if (_e2339 < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                let _e2342 = surfaces.member[_e2339];
                                                let _e2343 = bitcast<f32>(_e2342);
                                                if ((_e2313 + 266u) < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                if ((_e2313 + 267u) < _e148) {
                                                } else {
                                                    phi_5641_ = true;
                                                    break;
                                                }
                                                if (_e2323 == 4294967295u) {
                                                    phi_3290_ = (_e2338 < _e2343);
                                                } else {
                                                    if (_e1921.member_1 < _e145) {
                                                    } else {
                                                        phi_5641_ = true;
                                                        break;
                                                    }
                                                    let _e2351 = ((1f - _e2295[1]) - _e2295[2]);
                                                    let _e2355 = attributes.member[_e1921.member_1].member[0u];
                                                    let _e2360 = attributes.member[_e1921.member_1].member[2u];
                                                    let _e2366 = attributes.member[_e1921.member_1].member[4u];
                                                    let _e2368 = (((_e2355 * _e2351) + (_e2360 * _e2295[1])) + (_e2366 * _e2295[2]));
                                                    let _e2372 = attributes.member[_e1921.member_1].member[1u];
                                                    let _e2377 = attributes.member[_e1921.member_1].member[3u];
                                                    let _e2383 = attributes.member[_e1921.member_1].member[5u];
                                                    let _e2385 = (((_e2372 * _e2351) + (_e2377 * _e2295[1])) + (_e2383 * _e2295[2]));
                                                    let _e2386 = (_e2333 & 65535u);
                                                    let _e2388 = (_e2333 >> bitcast<u32>(16i));
                                                    let _e2391 = ((_e2323 >> bitcast<u32>(28u)) & 3u);
                                                    let _e2392 = (_e2386 - 1u);
                                                    let _e2394 = select(1f, 2f, (_e2391 == 2u));
                                                    let _e2398 = (_e2368 - (floor((_e2368 / _e2394)) * _e2394));
                                                    if (_e2398 > 1f) {
                                                        phi_3028_ = (_e2394 - _e2398);
                                                    } else {
                                                        phi_3028_ = _e2398;
                                                    }
                                                    let _e2402 = phi_3028_;
                                                    if (_e2391 == 1u) {
                                                        let _e2405 = select(0f, _e2368, (_e2368 > 0f));
                                                        phi_3043_ = select(1f, _e2405, (_e2405 < 1f));
                                                    } else {
                                                        phi_3043_ = _e2402;
                                                    }
                                                    let _e2409 = phi_3043_;
                                                    let _e2416 = ((select(0f, _e2409, (abs((_e2409 - 0.5f)) <= 0.5f)) * f32(_e2386)) - 0.5f);
                                                    let _e2417 = floor(_e2416);
                                                    let _e2418 = (_e2417 < 0f);
                                                    if _e2418 {
                                                        phi_3071_ = 0u;
                                                    } else {
                                                        let _e2423 = select(select(u32(_e2417), 0u, (_e2417 < 0f)), 4294967295u, (_e2417 > 4294967000f));
                                                        phi_3071_ = select(_e2423, _e2392, (_e2392 < _e2423));
                                                    }
                                                    let _e2427 = phi_3071_;
                                                    if _e2418 {
                                                        phi_3081_ = 0u;
                                                    } else {
                                                        let _e2428 = (_e2427 + 1u);
                                                        phi_3081_ = select(_e2428, _e2392, (_e2392 < _e2428));
                                                    }
                                                    let _e2432 = phi_3081_;
                                                    let _e2433 = (_e2391 == 0u);
                                                    if _e2433 {
                                                        phi_3090_ = select(true, false, _e2418);
                                                    } else {
                                                        phi_3090_ = true;
                                                    }
                                                    let _e2436 = phi_3090_;
                                                    let _e2437 = select(_e2392, _e2427, _e2436);
                                                    if _e2433 {
                                                        if _e2418 {
                                                            phi_3106_ = true;
                                                        } else {
                                                            phi_3106_ = select(true, false, (_e2437 == _e2392));
                                                        }
                                                        let _e2441 = phi_3106_;
                                                        phi_3107_ = _e2441;
                                                    } else {
                                                        phi_3107_ = true;
                                                    }
                                                    let _e2443 = phi_3107_;
                                                    let _e2444 = select(0u, _e2432, _e2443);
                                                    let _e2445 = (_e2416 - _e2417);
                                                    let _e2448 = ((_e2323 >> bitcast<u32>(30u)) & 3u);
                                                    let _e2449 = (_e2388 - 1u);
                                                    let _e2451 = select(1f, 2f, (_e2448 == 2u));
                                                    let _e2455 = (_e2385 - (floor((_e2385 / _e2451)) * _e2451));
                                                    if (_e2455 > 1f) {
                                                        phi_3130_ = (_e2451 - _e2455);
                                                    } else {
                                                        phi_3130_ = _e2455;
                                                    }
                                                    let _e2459 = phi_3130_;
                                                    if (_e2448 == 1u) {
                                                        let _e2462 = select(0f, _e2385, (_e2385 > 0f));
                                                        phi_3145_ = select(1f, _e2462, (_e2462 < 1f));
                                                    } else {
                                                        phi_3145_ = _e2459;
                                                    }
                                                    let _e2466 = phi_3145_;
                                                    let _e2473 = ((select(0f, _e2466, (abs((_e2466 - 0.5f)) <= 0.5f)) * f32(_e2388)) - 0.5f);
                                                    let _e2474 = floor(_e2473);
                                                    let _e2475 = (_e2474 < 0f);
                                                    if _e2475 {
                                                        phi_3173_ = 0u;
                                                    } else {
                                                        let _e2480 = select(select(u32(_e2474), 0u, (_e2474 < 0f)), 4294967295u, (_e2474 > 4294967000f));
                                                        phi_3173_ = select(_e2480, _e2449, (_e2449 < _e2480));
                                                    }
                                                    let _e2484 = phi_3173_;
                                                    if _e2475 {
                                                        phi_3183_ = 0u;
                                                    } else {
                                                        let _e2485 = (_e2484 + 1u);
                                                        phi_3183_ = select(_e2485, _e2449, (_e2449 < _e2485));
                                                    }
                                                    let _e2489 = phi_3183_;
                                                    let _e2490 = (_e2448 == 0u);
                                                    if _e2490 {
                                                        phi_3192_ = select(true, false, _e2475);
                                                    } else {
                                                        phi_3192_ = true;
                                                    }
                                                    let _e2493 = phi_3192_;
                                                    let _e2494 = select(_e2449, _e2484, _e2493);
                                                    if _e2490 {
                                                        if _e2475 {
                                                            phi_3208_ = true;
                                                        } else {
                                                            phi_3208_ = select(true, false, (_e2494 == _e2449));
                                                        }
                                                        let _e2498 = phi_3208_;
                                                        phi_3209_ = _e2498;
                                                    } else {
                                                        phi_3209_ = true;
                                                    }
                                                    let _e2500 = phi_3209_;
                                                    let _e2502 = (_e2473 - _e2474);
                                                    let _e2503 = (_e2323 & 268435455u);
                                                    let _e2505 = (_e2503 + (_e2494 * _e2386));
                                                    let _e2507 = (_e2503 + (select(0u, _e2489, _e2500) * _e2386));
                                                    let _e2508 = (_e2505 + _e2437);
                                                    let _e2509 = (_e2505 + _e2444);
                                                    let _e2510 = (_e2507 + _e2437);
                                                    let _e2511 = (_e2507 + _e2444);
                                                    if (_e2508 < _e148) {
                                                    } else {
                                                        phi_5641_ = true;
                                                        break;
                                                    }
                                                    let _e2514 = surfaces.member[_e2508];
                                                    if (_e2509 < _e148) {
                                                    } else {
                                                        phi_5641_ = true;
                                                        break;
                                                    }
                                                    let _e2517 = surfaces.member[_e2509];
                                                    if (_e2510 < _e148) {
                                                    } else {
                                                        phi_5641_ = true;
                                                        break;
                                                    }
                                                    let _e2520 = surfaces.member[_e2510];
                                                    if (_e2511 < _e148) {
                                                    } else {
                                                        phi_5641_ = true;
                                                        break;
                                                    }
                                                    let _e2523 = surfaces.member[_e2511];
                                                    let _e2540 = (1f - _e2445);
                                                    phi_3290_ = ((_e2338 * (((((f32((_e2514 >> bitcast<u32>(24i))) * 0.003921569f) * _e2540) + ((f32((_e2517 >> bitcast<u32>(24i))) * 0.003921569f) * _e2445)) * (1f - _e2502)) + ((((f32((_e2520 >> bitcast<u32>(24i))) * 0.003921569f) * _e2540) + ((f32((_e2523 >> bitcast<u32>(24i))) * 0.003921569f) * _e2445)) * _e2502))) < _e2343);
                                                }
                                                let _e2555 = phi_3290_;
                                                phi_3295_ = select(true, false, _e2555);
                                            }
                                            let _e2558 = phi_3295_;
                                            if _e2558 {
                                                phi_3300_ = type_64(_e2295[0], _e1921.member_1, _e2295[1], _e2295[2]);
                                            } else {
                                                phi_3300_ = type_64();
                                            }
                                            let _e2561 = phi_3300_;
                                            phi_3302_ = _e2561;
                                            phi_3304_ = select(true, false, _e2558);
                                        } else {
                                            phi_3302_ = type_64();
                                            phi_3304_ = false;
                                        }
                                        let _e2564 = phi_3302_;
                                        let _e2566 = phi_3304_;
                                        phi_3305_ = _e2564;
                                        phi_3307_ = select(true, false, _e2304);
                                        phi_3308_ = _e2566;
                                    } else {
                                        phi_3305_ = type_64();
                                        phi_3307_ = false;
                                        phi_3308_ = false;
                                    }
                                    let _e2569 = phi_3305_;
                                    let _e2571 = phi_3307_;
                                    let _e2573 = phi_3308_;
                                    phi_3309_ = _e2569;
                                    phi_3310_ = select(true, false, _e2303);
                                    phi_3311_ = _e2571;
                                    phi_3312_ = _e2573;
                                } else {
                                    phi_3309_ = type_64();
                                    phi_3310_ = true;
                                    phi_3311_ = false;
                                    phi_3312_ = false;
                                }
                                let _e2576 = phi_3309_;
                                let _e2578 = phi_3310_;
                                let _e2580 = phi_3311_;
                                let _e2582 = phi_3312_;
                                if select(select(_e2582, false, _e2578), true, select(_e2580, true, _e2578)) {
                                    phi_3325_ = _e1906;
                                } else {
                                    phi_3325_ = _e2576;
                                }
                                let _e2587 = phi_3325_;
                                phi_2516_ = _e2587;
                            } else {
                                phi_2516_ = type_64();
                            }
                            let _e2589 = phi_2516_;
                            continue;
                            continuing {
                                phi_2512_ = _e1919;
                                phi_2515_ = _e2589;
                                phi_5641_ = _e1890;
                                break if !(_e1925);
                            }
                        }
                        let _e2592 = phi_5641_;
                        phi_5880_ = _e2592;
                        phi_4824_ = type_64();
                        if _e2592 {
                            break;
                        }
                        phi_5816_ = _e2592;
                        phi_3326_ = 0u;
                        phi_3327_ = _e1894;
                        let _e3988 = local_14;
                        phi_2020_ = _e3988;
                    }
                    let _e2876 = phi_5816_;
                    let _e2878 = phi_3326_;
                    let _e2880 = phi_3327_;
                    let _e2882 = phi_2020_;
                    phi_2015_ = _e2878;
                    phi_2018_ = _e2880;
                    loop {
                        let _e2884 = phi_2015_;
                        let _e2886 = phi_2018_;
                        local_12 = _e2884;
                        local_13 = _e2886;
                        let _e2887 = (_e2884 == 0u);
                        local_11 = _e2887;
                        if _e2887 {
                            let _e2888 = (_e2886 > 0u);
                            if _e2888 {
                                let _e2889 = (_e2886 - 1u);
                                let _e2890 = (_e2889 < 64u);
                                if _e2890 {
                                } else {
                                    phi_5813_ = true;
                                    break;
                                }
                                let _e2892 = local_1[_e2889];
                                if (_e2892 <= _e2882.member) {
                                    if _e2890 {
                                    } else {
                                        phi_5813_ = true;
                                        break;
                                    }
                                    let _e2896 = local[_e2889];
                                    phi_3362_ = _e2896;
                                } else {
                                    phi_3362_ = _e2884;
                                }
                                let _e2898 = phi_3362_;
                                phi_3363_ = _e2898;
                                phi_3364_ = _e2889;
                            } else {
                                phi_3363_ = u32();
                                phi_3364_ = u32();
                            }
                            let _e2900 = phi_3363_;
                            let _e2902 = phi_3364_;
                            phi_3329_ = _e2900;
                            phi_3331_ = _e2902;
                            phi_3365_ = _e2888;
                        } else {
                            phi_3329_ = u32();
                            phi_3331_ = u32();
                            phi_3365_ = false;
                        }
                        let _e2904 = phi_3329_;
                        let _e2906 = phi_3331_;
                        let _e2908 = phi_3365_;
                        continue;
                        continuing {
                            phi_2015_ = _e2904;
                            phi_2018_ = _e2906;
                            phi_5813_ = _e2876;
                            break if !(_e2908);
                        }
                    }
                    let _e2911 = phi_5813_;
                    phi_5880_ = _e2911;
                    phi_4824_ = type_64();
                    if _e2911 {
                        break;
                    }
                    let _e2913 = local_11;
                    continue;
                    continuing {
                        phi_5645_ = _e2911;
                        let _e3911 = local_12;
                        phi_2014_ = _e3911;
                        let _e3914 = local_13;
                        phi_2017_ = _e3914;
                        phi_2019_ = _e2882;
                        phi_5880_ = _e2911;
                        phi_4824_ = _e2882;
                        break if !(select(true, false, _e2913));
                    }
                }
                let _e2917 = phi_5880_;
                let _e2919 = phi_4824_;
                if _e2917 {
                    break;
                }
                let _e2921 = (_e2919.member_1 != 4294967295u);
                if _e2921 {
                    if _e2921 {
                        if (_e2919.member_1 < _e142) {
                        } else {
                            break;
                        }
                        let _e2925 = triangles.member[_e2919.member_1].member;
                        let _e2931 = triangles.member[_e2919.member_1].member_2;
                        let _e2937 = triangles.member[_e2919.member_1].member_4;
                        let _e2941 = (_e2931[0] - _e2925[0]);
                        let _e2942 = (_e2931[1] - _e2925[1]);
                        let _e2943 = (_e2931[2] - _e2925[2]);
                        let _e2944 = (_e2937[0] - _e2925[0]);
                        let _e2945 = (_e2937[1] - _e2925[1]);
                        let _e2946 = (_e2937[2] - _e2925[2]);
                        let _e2963 = ((_e2942 * _e2946) - (_e2945 * _e2943));
                        let _e2966 = ((_e2943 * _e2944) - (_e2946 * _e2941));
                        let _e2969 = ((_e2941 * _e2945) - (_e2944 * _e2942));
                        let _e2970 = abs(_e2963);
                        let _e2971 = abs(_e2966);
                        let _e2973 = select(_e2971, _e2970, (_e2970 > _e2971));
                        let _e2974 = abs(_e2969);
                        let _e2976 = select(_e2974, _e2973, (_e2973 > _e2974));
                        if (_e2976 > 0.000000000000000000000000000000000000011754944f) {
                            let _e2978 = (_e2976 < 340282350000000000000000000000000000000f);
                            if _e2978 {
                                let _e2979 = (_e2963 / _e2976);
                                let _e2980 = (_e2966 / _e2976);
                                let _e2981 = (_e2969 / _e2976);
                                let _e2987 = sqrt((((_e2979 * _e2979) + (_e2980 * _e2980)) + (_e2981 * _e2981)));
                                phi_3472_ = vec3<f32>((_e2979 / _e2987), (_e2980 / _e2987), (_e2981 / _e2987));
                            } else {
                                phi_3472_ = vec3<f32>();
                            }
                            let _e2993 = phi_3472_;
                            phi_3474_ = _e2993;
                            phi_3475_ = select(true, false, _e2978);
                        } else {
                            phi_3474_ = vec3<f32>();
                            phi_3475_ = true;
                        }
                        let _e2996 = phi_3474_;
                        let _e2998 = phi_3475_;
                        let _e3000 = select(_e2996, vec3<f32>(0f, 1f, 0f), vec3(_e2998));
                        let _e3014 = ((((_e3000.x * _e1754.member.member_1.x) + (_e3000.y * _e1754.member.member_1.y)) + (_e3000.z * _e1754.member.member_1.z)) < 0f);
                        if _e3014 {
                            phi_3497_ = _e3000;
                        } else {
                            phi_3497_ = -(_e3000);
                        }
                        let _e3017 = phi_3497_;
                        if (_e2919.member_1 < _e145) {
                        } else {
                            break;
                        }
                        let _e3021 = triangles.member[_e2919.member_1].member_1;
                        let _e3022 = (_e3021 * 12u);
                        let _e3023 = (256u + _e3022);
                        if (_e3023 < _e148) {
                        } else {
                            break;
                        }
                        let _e3026 = surfaces.member[_e3023];
                        let _e3027 = bitcast<f32>(_e3026);
                        let _e3028 = (_e3022 + 257u);
                        if (_e3028 < _e148) {
                        } else {
                            break;
                        }
                        let _e3031 = surfaces.member[_e3028];
                        let _e3032 = bitcast<f32>(_e3031);
                        let _e3033 = (_e3022 + 258u);
                        if (_e3033 < _e148) {
                        } else {
                            break;
                        }
                        let _e3036 = surfaces.member[_e3033];
                        let _e3037 = bitcast<f32>(_e3036);
                        let _e3038 = (_e3022 + 259u);
                        if (_e3038 < _e148) {
                        } else {
                            break;
                        }
                        let _e3041 = surfaces.member[_e3038];
                        let _e3042 = (_e3022 + 260u);
                        if (_e3042 < _e148) {
                        } else {
                            break;
                        }
                        let _e3045 = surfaces.member[_e3042];
                        let _e3047 = (_e3022 + 261u);
                        if (_e3047 < _e148) {
                        } else {
                            break;
                        }
                        let _e3050 = surfaces.member[_e3047];
                        let _e3052 = (_e3022 + 262u);
                        if (_e3052 < _e148) {
                        } else {
                            break;
                        }
                        let _e3055 = surfaces.member[_e3052];
                        let _e3058 = (_e3022 + 263u);
                        if (_e3058 < _e148) {
                        } else {
                            break;
                        }
                        let _e3061 = surfaces.member[_e3058];
                        let _e3062 = (_e3022 + 264u);
                        if (_e3062 < _e148) {
                        } else {
                            break;
                        }
                        let _e3065 = surfaces.member[_e3062];
                        let _e3066 = bitcast<f32>(_e3065);
                        if ((_e3022 + 265u) < _e148) {
                        } else {
                            break;
                        }
                        if ((_e3022 + 266u) < _e148) {
                        } else {
                            break;
                        }
                        if ((_e3022 + 267u) < _e148) {
                        } else {
                            break;
                        }
                        let _e3074 = ((1f - _e2919.member_2) - _e2919.member_3);
                        let _e3078 = attributes.member[_e2919.member_1].member[0u];
                        let _e3083 = attributes.member[_e2919.member_1].member[2u];
                        let _e3089 = attributes.member[_e2919.member_1].member[4u];
                        let _e3091 = (((_e3078 * _e3074) + (_e3083 * _e2919.member_2)) + (_e3089 * _e2919.member_3));
                        let _e3095 = attributes.member[_e2919.member_1].member[1u];
                        let _e3100 = attributes.member[_e2919.member_1].member[3u];
                        let _e3106 = attributes.member[_e2919.member_1].member[5u];
                        let _e3108 = (((_e3095 * _e3074) + (_e3100 * _e2919.member_2)) + (_e3106 * _e2919.member_3));
                        if (_e3041 == 4294967295u) {
                            phi_4073_ = type_67(vec3<f32>(_e3027, _e3032, _e3037), _e3066);
                        } else {
                            let _e3111 = (_e3061 & 65535u);
                            let _e3113 = (_e3061 >> bitcast<u32>(16i));
                            let _e3116 = ((_e3041 >> bitcast<u32>(28u)) & 3u);
                            let _e3117 = (_e3111 - 1u);
                            let _e3119 = select(1f, 2f, (_e3116 == 2u));
                            let _e3123 = (_e3091 - (floor((_e3091 / _e3119)) * _e3119));
                            if (_e3123 > 1f) {
                                phi_3669_ = (_e3119 - _e3123);
                            } else {
                                phi_3669_ = _e3123;
                            }
                            let _e3127 = phi_3669_;
                            if (_e3116 == 1u) {
                                let _e3130 = select(0f, _e3091, (_e3091 > 0f));
                                phi_3684_ = select(1f, _e3130, (_e3130 < 1f));
                            } else {
                                phi_3684_ = _e3127;
                            }
                            let _e3134 = phi_3684_;
                            let _e3141 = ((select(0f, _e3134, (abs((_e3134 - 0.5f)) <= 0.5f)) * f32(_e3111)) - 0.5f);
                            let _e3142 = floor(_e3141);
                            let _e3143 = (_e3142 < 0f);
                            if _e3143 {
                                phi_3712_ = 0u;
                            } else {
                                let _e3148 = select(select(u32(_e3142), 0u, (_e3142 < 0f)), 4294967295u, (_e3142 > 4294967000f));
                                phi_3712_ = select(_e3148, _e3117, (_e3117 < _e3148));
                            }
                            let _e3152 = phi_3712_;
                            if _e3143 {
                                phi_3722_ = 0u;
                            } else {
                                let _e3153 = (_e3152 + 1u);
                                phi_3722_ = select(_e3153, _e3117, (_e3117 < _e3153));
                            }
                            let _e3157 = phi_3722_;
                            let _e3158 = (_e3116 == 0u);
                            if _e3158 {
                                phi_3731_ = select(true, false, _e3143);
                            } else {
                                phi_3731_ = true;
                            }
                            let _e3161 = phi_3731_;
                            let _e3162 = select(_e3117, _e3152, _e3161);
                            if _e3158 {
                                if _e3143 {
                                    phi_3747_ = true;
                                } else {
                                    phi_3747_ = select(true, false, (_e3162 == _e3117));
                                }
                                let _e3166 = phi_3747_;
                                phi_3748_ = _e3166;
                            } else {
                                phi_3748_ = true;
                            }
                            let _e3168 = phi_3748_;
                            let _e3169 = select(0u, _e3157, _e3168);
                            let _e3170 = (_e3141 - _e3142);
                            let _e3173 = ((_e3041 >> bitcast<u32>(30u)) & 3u);
                            let _e3174 = (_e3113 - 1u);
                            let _e3176 = select(1f, 2f, (_e3173 == 2u));
                            let _e3180 = (_e3108 - (floor((_e3108 / _e3176)) * _e3176));
                            if (_e3180 > 1f) {
                                phi_3771_ = (_e3176 - _e3180);
                            } else {
                                phi_3771_ = _e3180;
                            }
                            let _e3184 = phi_3771_;
                            if (_e3173 == 1u) {
                                let _e3187 = select(0f, _e3108, (_e3108 > 0f));
                                phi_3786_ = select(1f, _e3187, (_e3187 < 1f));
                            } else {
                                phi_3786_ = _e3184;
                            }
                            let _e3191 = phi_3786_;
                            let _e3198 = ((select(0f, _e3191, (abs((_e3191 - 0.5f)) <= 0.5f)) * f32(_e3113)) - 0.5f);
                            let _e3199 = floor(_e3198);
                            let _e3200 = (_e3199 < 0f);
                            if _e3200 {
                                phi_3814_ = 0u;
                            } else {
                                let _e3205 = select(select(u32(_e3199), 0u, (_e3199 < 0f)), 4294967295u, (_e3199 > 4294967000f));
                                phi_3814_ = select(_e3205, _e3174, (_e3174 < _e3205));
                            }
                            let _e3209 = phi_3814_;
                            if _e3200 {
                                phi_3824_ = 0u;
                            } else {
                                let _e3210 = (_e3209 + 1u);
                                phi_3824_ = select(_e3210, _e3174, (_e3174 < _e3210));
                            }
                            let _e3214 = phi_3824_;
                            let _e3215 = (_e3173 == 0u);
                            if _e3215 {
                                phi_3833_ = select(true, false, _e3200);
                            } else {
                                phi_3833_ = true;
                            }
                            let _e3218 = phi_3833_;
                            let _e3219 = select(_e3174, _e3209, _e3218);
                            if _e3215 {
                                if _e3200 {
                                    phi_3849_ = true;
                                } else {
                                    phi_3849_ = select(true, false, (_e3219 == _e3174));
                                }
                                let _e3223 = phi_3849_;
                                phi_3850_ = _e3223;
                            } else {
                                phi_3850_ = true;
                            }
                            let _e3225 = phi_3850_;
                            let _e3227 = (_e3198 - _e3199);
                            let _e3228 = (_e3041 & 268435455u);
                            let _e3230 = (_e3228 + (_e3219 * _e3111));
                            let _e3232 = (_e3228 + (select(0u, _e3214, _e3225) * _e3111));
                            let _e3233 = (_e3230 + _e3162);
                            let _e3234 = (_e3230 + _e3169);
                            let _e3235 = (_e3232 + _e3162);
                            let _e3236 = (_e3232 + _e3169);
                            if (_e3233 < _e148) {
                            } else {
                                break;
                            }
                            let _e3239 = surfaces.member[_e3233];
                            if (_e3234 < _e148) {
                            } else {
                                break;
                            }
                            let _e3242 = surfaces.member[_e3234];
                            if (_e3235 < _e148) {
                            } else {
                                break;
                            }
                            let _e3245 = surfaces.member[_e3235];
                            if (_e3236 < _e148) {
                            } else {
                                break;
                            }
                            let _e3248 = surfaces.member[_e3236];
                            let _e3249 = (_e3239 & 255u);
                            if (_e3249 < _e148) {
                            } else {
                                break;
                            }
                            let _e3252 = surfaces.member[_e3249];
                            let _e3256 = ((_e3239 >> bitcast<u32>(8i)) & 255u);
                            if (_e3256 < _e148) {
                            } else {
                                break;
                            }
                            let _e3259 = surfaces.member[_e3256];
                            let _e3263 = ((_e3239 >> bitcast<u32>(16i)) & 255u);
                            if (_e3263 < _e148) {
                            } else {
                                break;
                            }
                            let _e3266 = surfaces.member[_e3263];
                            let _e3268 = (1f - _e3170);
                            let _e3272 = (_e3242 & 255u);
                            if (_e3272 < _e148) {
                            } else {
                                break;
                            }
                            let _e3275 = surfaces.member[_e3272];
                            let _e3279 = ((_e3242 >> bitcast<u32>(8i)) & 255u);
                            if (_e3279 < _e148) {
                            } else {
                                break;
                            }
                            let _e3282 = surfaces.member[_e3279];
                            let _e3286 = ((_e3242 >> bitcast<u32>(16i)) & 255u);
                            if (_e3286 < _e148) {
                            } else {
                                break;
                            }
                            let _e3289 = surfaces.member[_e3286];
                            let _e3297 = (_e3245 & 255u);
                            if (_e3297 < _e148) {
                            } else {
                                break;
                            }
                            let _e3300 = surfaces.member[_e3297];
                            let _e3304 = ((_e3245 >> bitcast<u32>(8i)) & 255u);
                            if (_e3304 < _e148) {
                            } else {
                                break;
                            }
                            let _e3307 = surfaces.member[_e3304];
                            let _e3311 = ((_e3245 >> bitcast<u32>(16i)) & 255u);
                            if (_e3311 < _e148) {
                            } else {
                                break;
                            }
                            let _e3314 = surfaces.member[_e3311];
                            let _e3319 = (_e3248 & 255u);
                            if (_e3319 < _e148) {
                            } else {
                                break;
                            }
                            let _e3322 = surfaces.member[_e3319];
                            let _e3326 = ((_e3248 >> bitcast<u32>(8i)) & 255u);
                            if (_e3326 < _e148) {
                            } else {
                                break;
                            }
                            let _e3329 = surfaces.member[_e3326];
                            let _e3333 = ((_e3248 >> bitcast<u32>(16i)) & 255u);
                            if (_e3333 < _e148) {
                            } else {
                                break;
                            }
                            let _e3336 = surfaces.member[_e3333];
                            let _e3344 = (1f - _e3227);
                            phi_4073_ = type_67(vec3<f32>((_e3027 * ((((bitcast<f32>(_e3252) * _e3268) + (bitcast<f32>(_e3275) * _e3170)) * _e3344) + (((bitcast<f32>(_e3300) * _e3268) + (bitcast<f32>(_e3322) * _e3170)) * _e3227))), (_e3032 * ((((bitcast<f32>(_e3259) * _e3268) + (bitcast<f32>(_e3282) * _e3170)) * _e3344) + (((bitcast<f32>(_e3307) * _e3268) + (bitcast<f32>(_e3329) * _e3170)) * _e3227))), (_e3037 * ((((bitcast<f32>(_e3266) * _e3268) + (bitcast<f32>(_e3289) * _e3170)) * _e3344) + (((bitcast<f32>(_e3314) * _e3268) + (bitcast<f32>(_e3336) * _e3170)) * _e3227)))), (_e3066 * (((((f32((_e3239 >> bitcast<u32>(24i))) * 0.003921569f) * _e3268) + ((f32((_e3242 >> bitcast<u32>(24i))) * 0.003921569f) * _e3170)) * _e3344) + ((((f32((_e3245 >> bitcast<u32>(24i))) * 0.003921569f) * _e3268) + ((f32((_e3248 >> bitcast<u32>(24i))) * 0.003921569f) * _e3170)) * _e3227))));
                        }
                        let _e3387 = phi_4073_;
                        let _e3392 = attributes.member[_e2919.member_1].member_2[0u];
                        let _e3396 = attributes.member[_e2919.member_1].member_2[1u];
                        let _e3401 = attributes.member[_e2919.member_1].member_2[2u];
                        if (((_e3392 | _e3396) | _e3401) == 0u) {
                            phi_4180_ = vec3<f32>(1f, 1f, 1f);
                        } else {
                            let _e3417 = (1f - (f32((_e3392 & 1023u)) * 0.0009775171f));
                            let _e3418 = (1f - (f32(((_e3392 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                            let _e3419 = (1f - (f32(((_e3392 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                            let _e3439 = (1f - (f32((_e3396 & 1023u)) * 0.0009775171f));
                            let _e3440 = (1f - (f32(((_e3396 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                            let _e3441 = (1f - (f32(((_e3396 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                            let _e3464 = (1f - (f32((_e3401 & 1023u)) * 0.0009775171f));
                            let _e3465 = (1f - (f32(((_e3401 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                            let _e3466 = (1f - (f32(((_e3401 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                            phi_4180_ = vec3<f32>(((((_e3417 * _e3417) * _e3074) + ((_e3439 * _e3439) * _e2919.member_2)) + ((_e3464 * _e3464) * _e2919.member_3)), ((((_e3418 * _e3418) * _e3074) + ((_e3440 * _e3440) * _e2919.member_2)) + ((_e3465 * _e3465) * _e2919.member_3)), ((((_e3419 * _e3419) * _e3074) + ((_e3441 * _e3441) * _e2919.member_2)) + ((_e3466 * _e3466) * _e2919.member_3)));
                        }
                        let _e3478 = phi_4180_;
                        let _e3492 = attributes.member[_e2919.member_1].member_1[0u];
                        let _e3502 = (f32((bitcast<i32>((_e3492 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3504 = select(-1f, _e3502, (_e3502 > -1f));
                        let _e3506 = (f32((bitcast<i32>(_e3492) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3508 = select(-1f, _e3506, (_e3506 > -1f));
                        let _e3512 = ((1f - abs(_e3504)) - abs(_e3508));
                        let _e3513 = -(_e3512);
                        let _e3517 = (bitcast<u32>(select(0f, _e3513, (_e3513 > 0f))) & 2147483647u);
                        let _e3522 = (_e3504 - bitcast<f32>((_e3517 | (bitcast<u32>(_e3504) & 2147483648u))));
                        let _e3527 = (_e3508 - bitcast<f32>((_e3517 | (bitcast<u32>(_e3508) & 2147483648u))));
                        let _e3532 = (((_e3522 * _e3522) + (_e3527 * _e3527)) + (_e3512 * _e3512));
                        if (_e3532 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e3535 = (1f / sqrt(_e3532));
                            phi_4256_ = vec3<f32>((_e3522 * _e3535), (_e3527 * _e3535), (_e3512 * _e3535));
                        } else {
                            phi_4256_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e3541 = phi_4256_;
                        let _e3551 = attributes.member[_e2919.member_1].member_1[1u];
                        let _e3561 = (f32((bitcast<i32>((_e3551 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3563 = select(-1f, _e3561, (_e3561 > -1f));
                        let _e3565 = (f32((bitcast<i32>(_e3551) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3567 = select(-1f, _e3565, (_e3565 > -1f));
                        let _e3571 = ((1f - abs(_e3563)) - abs(_e3567));
                        let _e3572 = -(_e3571);
                        let _e3576 = (bitcast<u32>(select(0f, _e3572, (_e3572 > 0f))) & 2147483647u);
                        let _e3581 = (_e3563 - bitcast<f32>((_e3576 | (bitcast<u32>(_e3563) & 2147483648u))));
                        let _e3586 = (_e3567 - bitcast<f32>((_e3576 | (bitcast<u32>(_e3567) & 2147483648u))));
                        let _e3591 = (((_e3581 * _e3581) + (_e3586 * _e3586)) + (_e3571 * _e3571));
                        if (_e3591 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e3594 = (1f / sqrt(_e3591));
                            phi_4330_ = vec3<f32>((_e3581 * _e3594), (_e3586 * _e3594), (_e3571 * _e3594));
                        } else {
                            phi_4330_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e3600 = phi_4330_;
                        let _e3613 = attributes.member[_e2919.member_1].member_1[2u];
                        let _e3623 = (f32((bitcast<i32>((_e3613 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3625 = select(-1f, _e3623, (_e3623 > -1f));
                        let _e3627 = (f32((bitcast<i32>(_e3613) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3629 = select(-1f, _e3627, (_e3627 > -1f));
                        let _e3633 = ((1f - abs(_e3625)) - abs(_e3629));
                        let _e3634 = -(_e3633);
                        let _e3638 = (bitcast<u32>(select(0f, _e3634, (_e3634 > 0f))) & 2147483647u);
                        let _e3643 = (_e3625 - bitcast<f32>((_e3638 | (bitcast<u32>(_e3625) & 2147483648u))));
                        let _e3648 = (_e3629 - bitcast<f32>((_e3638 | (bitcast<u32>(_e3629) & 2147483648u))));
                        let _e3653 = (((_e3643 * _e3643) + (_e3648 * _e3648)) + (_e3633 * _e3633));
                        if (_e3653 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e3656 = (1f / sqrt(_e3653));
                            phi_4404_ = vec3<f32>((_e3643 * _e3656), (_e3648 * _e3656), (_e3633 * _e3656));
                        } else {
                            phi_4404_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e3662 = phi_4404_;
                        let _e3669 = (((_e3541.x * _e3074) + (_e3600.x * _e2919.member_2)) + (_e3662.x * _e2919.member_3));
                        let _e3670 = (((_e3541.y * _e3074) + (_e3600.y * _e2919.member_2)) + (_e3662.y * _e2919.member_3));
                        let _e3671 = (((_e3541.z * _e3074) + (_e3600.z * _e2919.member_2)) + (_e3662.z * _e2919.member_3));
                        let _e3672 = abs(_e3669);
                        let _e3673 = abs(_e3670);
                        let _e3675 = select(_e3673, _e3672, (_e3672 > _e3673));
                        let _e3676 = abs(_e3671);
                        let _e3678 = select(_e3676, _e3675, (_e3675 > _e3676));
                        if (_e3678 > 0.000000000000000000000000000000000000011754944f) {
                            let _e3680 = (_e3678 < 340282350000000000000000000000000000000f);
                            if _e3680 {
                                let _e3681 = (_e3669 / _e3678);
                                let _e3682 = (_e3670 / _e3678);
                                let _e3683 = (_e3671 / _e3678);
                                let _e3689 = sqrt((((_e3681 * _e3681) + (_e3682 * _e3682)) + (_e3683 * _e3683)));
                                phi_4449_ = vec3<f32>((_e3681 / _e3689), (_e3682 / _e3689), (_e3683 / _e3689));
                            } else {
                                phi_4449_ = vec3<f32>();
                            }
                            let _e3695 = phi_4449_;
                            phi_4451_ = _e3695;
                            phi_4452_ = select(true, false, _e3680);
                        } else {
                            phi_4451_ = vec3<f32>();
                            phi_4452_ = true;
                        }
                        let _e3698 = phi_4451_;
                        let _e3700 = phi_4452_;
                        let _e3702 = select(_e3698, _e3017, vec3(_e3700));
                        if ((((_e3702.x * _e1754.member.member_1.x) + (_e3702.y * _e1754.member.member_1.y)) + (_e3702.z * _e1754.member.member_1.z)) > 0f) {
                            phi_4473_ = -(_e3702);
                        } else {
                            phi_4473_ = _e3702;
                        }
                        let _e3714 = phi_4473_;
                        if _e3014 {
                            phi_4504_ = array<f32, 3>(bitcast<f32>(_e3045), bitcast<f32>(_e3050), bitcast<f32>(_e3055));
                        } else {
                            phi_4504_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e3734 = phi_4504_;
                        let _e3735 = abs(_e2925[0]);
                        let _e3736 = abs(_e2925[1]);
                        let _e3738 = select(_e3736, _e3735, (_e3735 > _e3736));
                        let _e3739 = abs(_e2925[2]);
                        let _e3743 = abs(_e2941);
                        let _e3744 = abs(_e2942);
                        let _e3746 = select(_e3744, _e3743, (_e3743 > _e3744));
                        let _e3747 = abs(_e2943);
                        let _e3750 = abs(_e2944);
                        let _e3751 = abs(_e2945);
                        let _e3753 = select(_e3751, _e3750, (_e3750 > _e3751));
                        let _e3754 = abs(_e2946);
                        phi_4550_ = type_68(array<f32, 3>(((_e2925[0] + (_e2941 * _e2919.member_2)) + (_e2944 * _e2919.member_3)), ((_e2925[1] + (_e2942 * _e2919.member_2)) + (_e2945 * _e2919.member_3)), ((_e2925[2] + (_e2943 * _e2919.member_2)) + (_e2946 * _e2919.member_3))), _e2919.member_1, array<f32, 3>(_e3714.x, _e3714.y, _e3714.z), (_e2919.member * sqrt((((_e1754.member.member_1.x * _e1754.member.member_1.x) + (_e1754.member.member_1.y * _e1754.member.member_1.y)) + (_e1754.member.member_1.z * _e1754.member.member_1.z)))), array<f32, 3>(_e3017.x, _e3017.y, _e3017.z), select(0u, 1u, _e3014), array<f32, 3>((_e3387.member.x * _e3478.x), (_e3387.member.y * _e3478.y), (_e3387.member.z * _e3478.z)), _e3021, _e3734, ((select(_e3739, _e3738, (_e3738 > _e3739)) * 0.00000047683716f) + ((select(_e3747, _e3746, (_e3746 > _e3747)) + select(_e3754, _e3753, (_e3753 > _e3754))) * 0.0000010728836f)));
                    } else {
                        phi_4550_ = type_68(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0f);
                    }
                    let _e3762 = phi_4550_;
                    phi_4552_ = _e3762;
                } else {
                    phi_4552_ = type_68(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0f);
                }
                let _e3764 = phi_4552_;
                if _e2921 {
                    let _e3776 = select(_e1754.member_1.z, _e1754.member_1.y, (_e1754.member_1.y > _e1754.member_1.z));
                    phi_4576_ = (select(_e3776, _e1754.member_1.x, (_e1754.member_1.x > _e3776)) > 0.000000000000000000000000000001f);
                } else {
                    phi_4576_ = false;
                }
                let _e3781 = phi_4576_;
                let _e3792 = -((((_e3764.member_4[0] * _e1754.member.member_1.x) + (_e3764.member_4[1] * _e1754.member.member_1.y)) + (_e3764.member_4[2] * _e1754.member.member_1.z)));
                if _e3781 {
                    phi_4604_ = ((_e1754.member_2 + ((_e1754.member_3 * _e3764.member_3) * _e3764.member_3)) / select(0.05f, _e3792, (_e3792 > 0.05f)));
                } else {
                    phi_4604_ = 0f;
                }
                let _e3804 = phi_4604_;
                if _e3781 {
                    phi_4614_ = array<f32, 3>(_e1754.member_1.x, _e1754.member_1.y, _e1754.member_1.z);
                } else {
                    phi_4614_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e3814 = phi_4614_;
                if _e3781 {
                    phi_4619_ = _e3764.member_6;
                } else {
                    phi_4619_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e3817 = phi_4619_;
                let _e3820 = (_e166 + (_e164 - _e164));
                if (_e3820 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e3820] = type_43(_e3764.member, _e3804, _e3764.member_4, select(0u, 1u, _e3781), _e3814, 0u, _e3817, 0u);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_rsm(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
