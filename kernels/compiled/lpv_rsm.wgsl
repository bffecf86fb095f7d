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
    var phi_1215_: f32;
    var phi_1229_: u32;
    var phi_1232_: u32;
    var phi_1256_: u32;
    var phi_1230_: u32;
    var phi_1233_: u32;
    var phi_5249_: bool;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_1351_: vec3<f32>;
    var phi_1353_: vec3<f32>;
    var phi_1354_: bool;
    var phi_1405_: vec2<f32>;
    var phi_4461_: f32;
    var phi_4469_: f32;
    var phi_1486_: vec2<f32>;
    var phi_1487_: bool;
    var phi_1617_: f32;
    var phi_1625_: f32;
    var phi_1551_: f32;
    var phi_1559_: f32;
    var phi_1629_: vec2<f32>;
    var phi_1630_: vec2<f32>;
    var phi_1755_: f32;
    var phi_5273_: bool;
    var phi_1786_: type_59;
    var phi_1021_: f32;
    var phi_1029_: f32;
    var phi_5272_: bool;
    var phi_1787_: type_59;
    var phi_756_: vec3<f32>;
    var phi_800_: vec3<f32>;
    var phi_844_: vec3<f32>;
    var phi_888_: vec3<f32>;
    var phi_4550_: f32;
    var phi_4558_: f32;
    var phi_4573_: f32;
    var phi_4579_: f32;
    var phi_4587_: f32;
    var phi_4676_: f32;
    var phi_4684_: f32;
    var phi_4699_: f32;
    var phi_4705_: f32;
    var phi_4713_: f32;
    var phi_4802_: f32;
    var phi_4810_: f32;
    var phi_4825_: f32;
    var phi_4831_: f32;
    var phi_4839_: f32;
    var phi_4928_: f32;
    var phi_4936_: f32;
    var phi_4951_: f32;
    var phi_4957_: f32;
    var phi_4965_: f32;
    var phi_900_: f32;
    var phi_945_: vec3<f32>;
    var phi_5271_: bool;
    var phi_1788_: type_59;
    var phi_4981_: f32;
    var phi_4989_: f32;
    var phi_405_: f32;
    var phi_413_: f32;
    var phi_474_: vec2<f32>;
    var phi_475_: bool;
    var phi_605_: f32;
    var phi_613_: f32;
    var phi_539_: f32;
    var phi_547_: f32;
    var phi_617_: vec2<f32>;
    var phi_618_: vec2<f32>;
    var phi_5270_: bool;
    var phi_1789_: type_59;
    var phi_1809_: bool;
    var phi_1819_: u32;
    var phi_1822_: bool;
    var phi_1833_: u32;
    var phi_1986_: f32;
    var phi_1994_: f32;
    var phi_2002_: f32;
    var phi_5258_: bool;
    var phi_2006_: u32;
    var phi_2009_: u32;
    var phi_2011_: type_64;
    var phi_2504_: type_12;
    var phi_2507_: type_64;
    var phi_2505_: type_12;
    var phi_2530_: type_12;
    var phi_2646_: f32;
    var phi_2657_: f32;
    var phi_2668_: f32;
    var phi_2683_: f32;
    var phi_2684_: f32;
    var phi_2685_: bool;
    var phi_2686_: f32;
    var phi_2687_: bool;
    var phi_2706_: f32;
    var phi_2707_: bool;
    var phi_2708_: f32;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var phi_2715_: f32;
    var phi_2716_: bool;
    var phi_2802_: array<f32, 3>;
    var phi_2803_: array<f32, 3>;
    var phi_2804_: array<f32, 3>;
    var phi_2805_: array<f32, 3>;
    var phi_2806_: bool;
    var phi_2807_: array<f32, 3>;
    var phi_2808_: array<f32, 3>;
    var phi_2809_: bool;
    var phi_2810_: bool;
    var phi_2815_: array<f32, 3>;
    var phi_2820_: array<f32, 3>;
    var phi_3032_: u32;
    var phi_3038_: u32;
    var phi_3068_: u32;
    var phi_3074_: u32;
    var phi_3149_: bool;
    var phi_3154_: bool;
    var phi_3159_: type_64;
    var phi_3161_: type_64;
    var phi_3163_: bool;
    var phi_3164_: type_64;
    var phi_3166_: bool;
    var phi_3167_: bool;
    var phi_3168_: type_64;
    var phi_3169_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3184_: type_64;
    var phi_2508_: type_64;
    var phi_5254_: bool;
    var phi_2393_: type_65;
    var phi_2404_: type_65;
    var phi_2415_: type_65;
    var phi_2426_: type_65;
    var phi_2437_: type_65;
    var phi_2459_: u32;
    var phi_2477_: u32;
    var phi_2495_: u32;
    var phi_5403_: bool;
    var phi_3185_: u32;
    var phi_3186_: u32;
    var phi_2012_: type_64;
    var phi_2007_: u32;
    var phi_2010_: u32;
    var phi_3221_: u32;
    var phi_3222_: u32;
    var phi_3223_: u32;
    var phi_3188_: u32;
    var phi_3190_: u32;
    var phi_3224_: bool;
    var phi_5400_: bool;
    var local_11: bool;
    var phi_5467_: bool;
    var phi_4437_: type_64;
    var phi_3331_: vec3<f32>;
    var phi_3333_: vec3<f32>;
    var phi_3334_: bool;
    var phi_3356_: vec3<f32>;
    var phi_3540_: u32;
    var phi_3546_: u32;
    var phi_3576_: u32;
    var phi_3582_: u32;
    var phi_3799_: type_67;
    var phi_3866_: vec3<f32>;
    var phi_3940_: vec3<f32>;
    var phi_4014_: vec3<f32>;
    var phi_4059_: vec3<f32>;
    var phi_4061_: vec3<f32>;
    var phi_4062_: bool;
    var phi_4083_: vec3<f32>;
    var phi_4117_: array<f32, 3>;
    var phi_4163_: type_68;
    var phi_4165_: type_68;
    var phi_4189_: bool;
    var phi_4217_: f32;
    var phi_4227_: array<f32, 3>;
    var phi_4232_: array<f32, 3>;
    var local_12: u32;
    var local_13: u32;
    var local_14: type_64;

    switch bitcast<i32>(0u) {
        default: {
            let _e128 = gid_1;
            let _e131 = arrayLength((&nodes.member));
            let _e134 = arrayLength((&triangles.member));
            let _e137 = arrayLength((&attributes.member));
            let _e140 = arrayLength((&surfaces.member));
            let _e142 = arrayLength((&lights.member));
            let _e149 = params.member.member_2;
            let _e152 = params.member.member_3;
            let _e156 = (_e128.x + (_e128.y * 2097152u));
            if (_e156 < _e152) {
                let _e158 = (_e149 + _e156);
                let _e161 = params.member.member_1;
                let _e162 = (_e161 * _e161);
                let _e163 = (_e162 == 0u);
                if _e163 {
                    break;
                }
                let _e164 = (_e158 / _e162);
                if (_e164 < arrayLength((&maps.member))) {
                } else {
                    break;
                }
                let _e168 = maps.member[_e164];
                if _e163 {
                    break;
                }
                let _e170 = (_e158 - (_e164 * _e162));
                if (_e161 == 0u) {
                    break;
                }
                let _e172 = (_e170 / _e161);
                let _e179 = f32(_e161);
                let _e180 = ((f32((_e170 - (_e172 * _e161))) + 0.5f) / _e179);
                let _e181 = ((f32(_e172) + 0.5f) / _e179);
                if (_e168.member_1 == 4u) {
                    let _e1398 = (_e168.member_3 + _e170);
                    let _e1413 = params.member.member_5;
                    let _e1417 = ((_e1413 ^ (_e1413 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e1421 = ((_e1417 ^ (_e1417 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e1428 = (_e1413 ^ 2654435769u);
                    let _e1432 = ((_e1428 ^ (_e1428 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e1436 = ((_e1432 ^ (_e1432 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e1444 = (0.000000059604645f * (f32(((2147483648u + (_e1398 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e1421 ^ (_e1421 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                    if (_e1444 >= 1f) {
                        phi_4981_ = (_e1444 - 1f);
                    } else {
                        phi_4981_ = _e1444;
                    }
                    let _e1448 = phi_4981_;
                    let _e1450 = (0.000000059604645f * (f32(((2147483648u + (_e1398 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e1436 ^ (_e1436 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                    if (_e1450 >= 1f) {
                        phi_4989_ = (_e1450 - 1f);
                    } else {
                        phi_4989_ = _e1450;
                    }
                    let _e1454 = phi_4989_;
                    let _e1456 = (1f - (2f * _e1448));
                    let _e1460 = floor(((_e1454 * 4f) + 0.5f));
                    let _e1466 = ((((6.2831855f * _e1454) - (_e1460 * 1.5703125f)) - (_e1460 * 0.0004837513f)) - (_e1460 * 0.0000000754979f));
                    let _e1467 = (_e1466 * _e1466);
                    let _e1474 = (_e1466 + ((_e1466 * _e1467) * (-0.16666655f + (_e1467 * (0.008332161f + (_e1467 * -0.00019515296f))))));
                    let _e1483 = ((1f - (0.5f * _e1467)) + ((_e1467 * _e1467) * (0.041666646f + (_e1467 * (-0.0013887316f + (_e1467 * 0.000024433157f))))));
                    let _e1490 = select(0i, select(select(i32(_e1460), i32(-2147483648), (_e1460 < -2147483600f)), 2147483647i, (_e1460 > 2147483500f)), (_e1460 == _e1460));
                    let _e1492 = ((_e1490 & 1i) == 0i);
                    let _e1493 = select(_e1483, _e1474, _e1492);
                    let _e1494 = select(_e1474, _e1483, _e1492);
                    if ((_e1490 & 2i) == 0i) {
                        phi_405_ = _e1493;
                    } else {
                        phi_405_ = -(_e1493);
                    }
                    let _e1499 = phi_405_;
                    if (((_e1490 + 1i) & 2i) == 0i) {
                        phi_413_ = _e1494;
                    } else {
                        phi_413_ = -(_e1494);
                    }
                    let _e1505 = phi_413_;
                    let _e1507 = (1f - (_e1456 * _e1456));
                    let _e1510 = sqrt(select(0f, _e1507, (_e1507 > 0f)));
                    let _e1511 = (_e1510 * _e1505);
                    let _e1512 = (_e1510 * _e1499);
                    let _e1517 = ((_e1398 * 1664525u) + 1013904223u);
                    let _e1519 = (((_e1413 * 1664525u) + 1013904223u) + (_e1517 * 1013904223u));
                    let _e1521 = (_e1517 + (1015568748u * _e1519));
                    let _e1523 = (1015568748u + (_e1519 * _e1521));
                    let _e1525 = (1013904223u + (_e1521 * _e1523));
                    let _e1531 = (_e1521 ^ (_e1521 >> bitcast<u32>(16i)));
                    let _e1539 = ((_e1519 ^ (_e1519 >> bitcast<u32>(16i))) + (_e1531 * (_e1525 ^ (_e1525 >> bitcast<u32>(16i)))));
                    let _e1549 = ((f32((_e1539 >> bitcast<u32>(8i))) * 0.00000011920929f) - 1f);
                    let _e1551 = ((f32(((_e1531 + ((_e1523 ^ (_e1523 >> bitcast<u32>(16i))) * _e1539)) >> bitcast<u32>(8i))) * 0.00000011920929f) - 1f);
                    if (_e1549 == 0f) {
                        let _e1553 = (_e1551 == 0f);
                        phi_474_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e1553));
                        phi_475_ = select(true, false, _e1553);
                    } else {
                        phi_474_ = vec2<f32>();
                        phi_475_ = true;
                    }
                    let _e1558 = phi_474_;
                    let _e1560 = phi_475_;
                    if _e1560 {
                        if (abs(_e1549) > abs(_e1551)) {
                            let _e1617 = (_e1551 / _e1549);
                            let _e1621 = floor(((_e1617 * 0.5f) + 0.5f));
                            let _e1627 = ((((0.7853982f * _e1617) - (_e1621 * 1.5703125f)) - (_e1621 * 0.0004837513f)) - (_e1621 * 0.0000000754979f));
                            let _e1628 = (_e1627 * _e1627);
                            let _e1635 = (_e1627 + ((_e1627 * _e1628) * (-0.16666655f + (_e1628 * (0.008332161f + (_e1628 * -0.00019515296f))))));
                            let _e1644 = ((1f - (0.5f * _e1628)) + ((_e1628 * _e1628) * (0.041666646f + (_e1628 * (-0.0013887316f + (_e1628 * 0.000024433157f))))));
                            let _e1651 = select(0i, select(select(i32(_e1621), i32(-2147483648), (_e1621 < -2147483600f)), 2147483647i, (_e1621 > 2147483500f)), (_e1621 == _e1621));
                            let _e1653 = ((_e1651 & 1i) == 0i);
                            let _e1654 = select(_e1644, _e1635, _e1653);
                            let _e1655 = select(_e1635, _e1644, _e1653);
                            if ((_e1651 & 2i) == 0i) {
                                phi_539_ = _e1654;
                            } else {
                                phi_539_ = -(_e1654);
                            }
                            let _e1660 = phi_539_;
                            if (((_e1651 + 1i) & 2i) == 0i) {
                                phi_547_ = _e1655;
                            } else {
                                phi_547_ = -(_e1655);
                            }
                            let _e1666 = phi_547_;
                            phi_617_ = vec2<f32>((_e1549 * _e1666), (_e1549 * _e1660));
                        } else {
                            let _e1564 = (_e1549 / _e1551);
                            let _e1568 = floor(((_e1564 * 0.5f) + 0.5f));
                            let _e1574 = ((((0.7853982f * _e1564) - (_e1568 * 1.5703125f)) - (_e1568 * 0.0004837513f)) - (_e1568 * 0.0000000754979f));
                            let _e1575 = (_e1574 * _e1574);
                            let _e1582 = (_e1574 + ((_e1574 * _e1575) * (-0.16666655f + (_e1575 * (0.008332161f + (_e1575 * -0.00019515296f))))));
                            let _e1591 = ((1f - (0.5f * _e1575)) + ((_e1575 * _e1575) * (0.041666646f + (_e1575 * (-0.0013887316f + (_e1575 * 0.000024433157f))))));
                            let _e1598 = select(0i, select(select(i32(_e1568), i32(-2147483648), (_e1568 < -2147483600f)), 2147483647i, (_e1568 > 2147483500f)), (_e1568 == _e1568));
                            let _e1600 = ((_e1598 & 1i) == 0i);
                            let _e1601 = select(_e1591, _e1582, _e1600);
                            let _e1602 = select(_e1582, _e1591, _e1600);
                            if ((_e1598 & 2i) == 0i) {
                                phi_605_ = _e1601;
                            } else {
                                phi_605_ = -(_e1601);
                            }
                            let _e1607 = phi_605_;
                            if (((_e1598 + 1i) & 2i) == 0i) {
                                phi_613_ = _e1602;
                            } else {
                                phi_613_ = -(_e1602);
                            }
                            let _e1613 = phi_613_;
                            phi_617_ = vec2<f32>((_e1551 * _e1607), (_e1551 * _e1613));
                        }
                        let _e1671 = phi_617_;
                        phi_618_ = _e1671;
                    } else {
                        phi_618_ = _e1558;
                    }
                    let _e1673 = phi_618_;
                    let _e1676 = (_e1673.x * _e168.member.w);
                    let _e1677 = (_e1673.y * _e168.member.w);
                    let _e1681 = bitcast<f32>((1065353216u | (bitcast<u32>(_e1456) & 2147483648u)));
                    let _e1683 = (-1f / (_e1681 + _e1456));
                    let _e1685 = ((_e1511 * _e1512) * _e1683);
                    let _e1697 = -(_e168.member.w);
                    let _e1715 = (1f / f32(_e168.member_4));
                    let _e1727 = params.member.member;
                    let _e1733 = (((39.47842f * _e168.member.w) * _e168.member.w) * _e1715);
                    phi_5270_ = false;
                    phi_1789_ = type_59(type_58(vec3<f32>((_e168.member.x + ((((1f + (((_e1681 * _e1511) * _e1511) * _e1683)) * _e1676) + (_e1685 * _e1677)) + (_e1511 * _e1697))), (_e168.member.y + ((((_e1681 * _e1685) * _e1676) + ((_e1681 + ((_e1512 * _e1512) * _e1683)) * _e1677)) + (_e1512 * _e1697))), (_e168.member.z + ((((-(_e1681) * _e1511) * _e1676) + (-(_e1512) * _e1677)) + (_e1456 * _e1697)))), vec3<f32>(_e1511, _e1512, _e1456), 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e1727.x * _e1733), (_e1727.y * _e1733), (_e1727.z * _e1733)), ((((12.566371f * _e168.member.w) * _e168.member.w) * _e1715) * 0.05f), 0f);
                } else {
                    if (_e168.member_2 < _e142) {
                    } else {
                        break;
                    }
                    let _e188 = lights.member[_e168.member_2];
                    if (_e168.member_1 == 0u) {
                        let _e881 = ((_e180 * 2f) - 1f);
                        let _e882 = ((_e181 * 2f) - 1f);
                        let _e883 = (1f / _e179);
                        let _e884 = (-1f / _e179);
                        let _e885 = (_e881 + _e884);
                        let _e886 = (_e882 + _e884);
                        let _e888 = (1f - abs(_e885));
                        let _e889 = abs(_e886);
                        let _e890 = (_e888 - _e889);
                        let _e891 = -(_e890);
                        let _e895 = (bitcast<u32>(select(0f, _e891, (_e891 > 0f))) & 2147483647u);
                        let _e897 = (bitcast<u32>(_e885) & 2147483648u);
                        let _e900 = (_e885 - bitcast<f32>((_e895 | _e897)));
                        let _e902 = (bitcast<u32>(_e886) & 2147483648u);
                        let _e905 = (_e886 - bitcast<f32>((_e895 | _e902)));
                        let _e910 = (((_e900 * _e900) + (_e905 * _e905)) + (_e890 * _e890));
                        if (_e910 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e913 = (1f / sqrt(_e910));
                            phi_756_ = vec3<f32>((_e900 * _e913), (_e905 * _e913), (_e890 * _e913));
                        } else {
                            phi_756_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e919 = phi_756_;
                        let _e920 = (_e881 + _e883);
                        let _e922 = (1f - abs(_e920));
                        let _e923 = (_e922 - _e889);
                        let _e924 = -(_e923);
                        let _e928 = (bitcast<u32>(select(0f, _e924, (_e924 > 0f))) & 2147483647u);
                        let _e930 = (bitcast<u32>(_e920) & 2147483648u);
                        let _e933 = (_e920 - bitcast<f32>((_e928 | _e930)));
                        let _e936 = (_e886 - bitcast<f32>((_e928 | _e902)));
                        let _e941 = (((_e933 * _e933) + (_e936 * _e936)) + (_e923 * _e923));
                        if (_e941 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e944 = (1f / sqrt(_e941));
                            phi_800_ = vec3<f32>((_e933 * _e944), (_e936 * _e944), (_e923 * _e944));
                        } else {
                            phi_800_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e950 = phi_800_;
                        let _e951 = (_e882 + _e883);
                        let _e952 = abs(_e951);
                        let _e953 = (_e922 - _e952);
                        let _e954 = -(_e953);
                        let _e958 = (bitcast<u32>(select(0f, _e954, (_e954 > 0f))) & 2147483647u);
                        let _e961 = (_e920 - bitcast<f32>((_e958 | _e930)));
                        let _e963 = (bitcast<u32>(_e951) & 2147483648u);
                        let _e966 = (_e951 - bitcast<f32>((_e958 | _e963)));
                        let _e971 = (((_e961 * _e961) + (_e966 * _e966)) + (_e953 * _e953));
                        if (_e971 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e974 = (1f / sqrt(_e971));
                            phi_844_ = vec3<f32>((_e961 * _e974), (_e966 * _e974), (_e953 * _e974));
                        } else {
                            phi_844_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e980 = phi_844_;
                        let _e981 = (_e888 - _e952);
                        let _e982 = -(_e981);
                        let _e986 = (bitcast<u32>(select(0f, _e982, (_e982 > 0f))) & 2147483647u);
                        let _e989 = (_e885 - bitcast<f32>((_e986 | _e897)));
                        let _e992 = (_e951 - bitcast<f32>((_e986 | _e963)));
                        let _e997 = (((_e989 * _e989) + (_e992 * _e992)) + (_e981 * _e981));
                        if (_e997 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e1000 = (1f / sqrt(_e997));
                            phi_888_ = vec3<f32>((_e989 * _e1000), (_e992 * _e1000), (_e981 * _e1000));
                        } else {
                            phi_888_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e1006 = phi_888_;
                        if ((_e881 * _e882) > 0f) {
                            let _e1198 = (((_e919.x * ((_e950.y * _e1006.z) - (_e1006.y * _e950.z))) + (_e919.y * ((_e950.z * _e1006.x) - (_e1006.z * _e950.x)))) + (_e919.z * ((_e950.x * _e1006.y) - (_e1006.x * _e950.y))));
                            let _e1216 = (((1f + (((_e919.x * _e950.x) + (_e919.y * _e950.y)) + (_e919.z * _e950.z))) + (((_e950.x * _e1006.x) + (_e950.y * _e1006.y)) + (_e950.z * _e1006.z))) + (((_e1006.x * _e919.x) + (_e1006.y * _e919.y)) + (_e1006.z * _e919.z)));
                            let _e1217 = abs(_e1216);
                            let _e1218 = abs(_e1198);
                            let _e1219 = (_e1218 > _e1217);
                            let _e1220 = select(_e1217, _e1218, _e1219);
                            if (_e1220 > 0f) {
                                phi_4802_ = (select(_e1218, _e1217, _e1219) / _e1220);
                            } else {
                                phi_4802_ = 0f;
                            }
                            let _e1225 = phi_4802_;
                            let _e1226 = (_e1225 > 0.41421357f);
                            if _e1226 {
                                phi_4810_ = ((_e1225 - 1f) / (_e1225 + 1f));
                            } else {
                                phi_4810_ = _e1225;
                            }
                            let _e1231 = phi_4810_;
                            let _e1232 = (_e1231 * _e1231);
                            let _e1241 = (_e1231 + ((_e1231 * _e1232) * (-0.3333295f + (_e1232 * (0.19977711f + (_e1232 * (-0.13877685f + (_e1232 * 0.080537446f))))))));
                            if _e1226 {
                                phi_4825_ = (_e1241 + 0.7853982f);
                            } else {
                                phi_4825_ = _e1241;
                            }
                            let _e1244 = phi_4825_;
                            if _e1219 {
                                phi_4831_ = (1.5707964f - _e1244);
                            } else {
                                phi_4831_ = _e1244;
                            }
                            let _e1247 = phi_4831_;
                            if ((bitcast<u32>(_e1216) & 2147483648u) == 0u) {
                                phi_4839_ = _e1247;
                            } else {
                                phi_4839_ = (3.1415927f - _e1247);
                            }
                            let _e1253 = phi_4839_;
                            let _e1278 = (((_e950.x * ((_e980.y * _e1006.z) - (_e1006.y * _e980.z))) + (_e950.y * ((_e980.z * _e1006.x) - (_e1006.z * _e980.x)))) + (_e950.z * ((_e980.x * _e1006.y) - (_e1006.x * _e980.y))));
                            let _e1296 = (((1f + (((_e950.x * _e980.x) + (_e950.y * _e980.y)) + (_e950.z * _e980.z))) + (((_e980.x * _e1006.x) + (_e980.y * _e1006.y)) + (_e980.z * _e1006.z))) + (((_e1006.x * _e950.x) + (_e1006.y * _e950.y)) + (_e1006.z * _e950.z)));
                            let _e1297 = abs(_e1296);
                            let _e1298 = abs(_e1278);
                            let _e1299 = (_e1298 > _e1297);
                            let _e1300 = select(_e1297, _e1298, _e1299);
                            if (_e1300 > 0f) {
                                phi_4928_ = (select(_e1298, _e1297, _e1299) / _e1300);
                            } else {
                                phi_4928_ = 0f;
                            }
                            let _e1305 = phi_4928_;
                            let _e1306 = (_e1305 > 0.41421357f);
                            if _e1306 {
                                phi_4936_ = ((_e1305 - 1f) / (_e1305 + 1f));
                            } else {
                                phi_4936_ = _e1305;
                            }
                            let _e1311 = phi_4936_;
                            let _e1312 = (_e1311 * _e1311);
                            let _e1321 = (_e1311 + ((_e1311 * _e1312) * (-0.3333295f + (_e1312 * (0.19977711f + (_e1312 * (-0.13877685f + (_e1312 * 0.080537446f))))))));
                            if _e1306 {
                                phi_4951_ = (_e1321 + 0.7853982f);
                            } else {
                                phi_4951_ = _e1321;
                            }
                            let _e1324 = phi_4951_;
                            if _e1299 {
                                phi_4957_ = (1.5707964f - _e1324);
                            } else {
                                phi_4957_ = _e1324;
                            }
                            let _e1327 = phi_4957_;
                            if ((bitcast<u32>(_e1296) & 2147483648u) == 0u) {
                                phi_4965_ = _e1327;
                            } else {
                                phi_4965_ = (3.1415927f - _e1327);
                            }
                            let _e1333 = phi_4965_;
                            phi_900_ = (abs((2f * bitcast<f32>(((bitcast<u32>(_e1253) & 2147483647u) | (bitcast<u32>(_e1198) & 2147483648u))))) + abs((2f * bitcast<f32>(((bitcast<u32>(_e1333) & 2147483647u) | (bitcast<u32>(_e1278) & 2147483648u))))));
                        } else {
                            let _e1031 = (((_e919.x * ((_e950.y * _e980.z) - (_e980.y * _e950.z))) + (_e919.y * ((_e950.z * _e980.x) - (_e980.z * _e950.x)))) + (_e919.z * ((_e950.x * _e980.y) - (_e980.x * _e950.y))));
                            let _e1049 = (((1f + (((_e919.x * _e950.x) + (_e919.y * _e950.y)) + (_e919.z * _e950.z))) + (((_e950.x * _e980.x) + (_e950.y * _e980.y)) + (_e950.z * _e980.z))) + (((_e980.x * _e919.x) + (_e980.y * _e919.y)) + (_e980.z * _e919.z)));
                            let _e1050 = abs(_e1049);
                            let _e1051 = abs(_e1031);
                            let _e1052 = (_e1051 > _e1050);
                            let _e1053 = select(_e1050, _e1051, _e1052);
                            if (_e1053 > 0f) {
                                phi_4550_ = (select(_e1051, _e1050, _e1052) / _e1053);
                            } else {
                                phi_4550_ = 0f;
                            }
                            let _e1058 = phi_4550_;
                            let _e1059 = (_e1058 > 0.41421357f);
                            if _e1059 {
                                phi_4558_ = ((_e1058 - 1f) / (_e1058 + 1f));
                            } else {
                                phi_4558_ = _e1058;
                            }
                            let _e1064 = phi_4558_;
                            let _e1065 = (_e1064 * _e1064);
                            let _e1074 = (_e1064 + ((_e1064 * _e1065) * (-0.3333295f + (_e1065 * (0.19977711f + (_e1065 * (-0.13877685f + (_e1065 * 0.080537446f))))))));
                            if _e1059 {
                                phi_4573_ = (_e1074 + 0.7853982f);
                            } else {
                                phi_4573_ = _e1074;
                            }
                            let _e1077 = phi_4573_;
                            if _e1052 {
                                phi_4579_ = (1.5707964f - _e1077);
                            } else {
                                phi_4579_ = _e1077;
                            }
                            let _e1080 = phi_4579_;
                            if ((bitcast<u32>(_e1049) & 2147483648u) == 0u) {
                                phi_4587_ = _e1080;
                            } else {
                                phi_4587_ = (3.1415927f - _e1080);
                            }
                            let _e1086 = phi_4587_;
                            let _e1111 = (((_e919.x * ((_e980.y * _e1006.z) - (_e1006.y * _e980.z))) + (_e919.y * ((_e980.z * _e1006.x) - (_e1006.z * _e980.x)))) + (_e919.z * ((_e980.x * _e1006.y) - (_e1006.x * _e980.y))));
                            let _e1129 = (((1f + (((_e919.x * _e980.x) + (_e919.y * _e980.y)) + (_e919.z * _e980.z))) + (((_e980.x * _e1006.x) + (_e980.y * _e1006.y)) + (_e980.z * _e1006.z))) + (((_e1006.x * _e919.x) + (_e1006.y * _e919.y)) + (_e1006.z * _e919.z)));
                            let _e1130 = abs(_e1129);
                            let _e1131 = abs(_e1111);
                            let _e1132 = (_e1131 > _e1130);
                            let _e1133 = select(_e1130, _e1131, _e1132);
                            if (_e1133 > 0f) {
                                phi_4676_ = (select(_e1131, _e1130, _e1132) / _e1133);
                            } else {
                                phi_4676_ = 0f;
                            }
                            let _e1138 = phi_4676_;
                            let _e1139 = (_e1138 > 0.41421357f);
                            if _e1139 {
                                phi_4684_ = ((_e1138 - 1f) / (_e1138 + 1f));
                            } else {
                                phi_4684_ = _e1138;
                            }
                            let _e1144 = phi_4684_;
                            let _e1145 = (_e1144 * _e1144);
                            let _e1154 = (_e1144 + ((_e1144 * _e1145) * (-0.3333295f + (_e1145 * (0.19977711f + (_e1145 * (-0.13877685f + (_e1145 * 0.080537446f))))))));
                            if _e1139 {
                                phi_4699_ = (_e1154 + 0.7853982f);
                            } else {
                                phi_4699_ = _e1154;
                            }
                            let _e1157 = phi_4699_;
                            if _e1132 {
                                phi_4705_ = (1.5707964f - _e1157);
                            } else {
                                phi_4705_ = _e1157;
                            }
                            let _e1160 = phi_4705_;
                            if ((bitcast<u32>(_e1129) & 2147483648u) == 0u) {
                                phi_4713_ = _e1160;
                            } else {
                                phi_4713_ = (3.1415927f - _e1160);
                            }
                            let _e1166 = phi_4713_;
                            phi_900_ = (abs((2f * bitcast<f32>(((bitcast<u32>(_e1086) & 2147483647u) | (bitcast<u32>(_e1031) & 2147483648u))))) + abs((2f * bitcast<f32>(((bitcast<u32>(_e1166) & 2147483647u) | (bitcast<u32>(_e1111) & 2147483648u))))));
                        }
                        let _e1344 = phi_900_;
                        let _e1353 = ((1f - abs(_e881)) - abs(_e882));
                        let _e1354 = -(_e1353);
                        let _e1358 = (bitcast<u32>(select(0f, _e1354, (_e1354 > 0f))) & 2147483647u);
                        let _e1363 = (_e881 - bitcast<f32>((_e1358 | (bitcast<u32>(_e881) & 2147483648u))));
                        let _e1368 = (_e882 - bitcast<f32>((_e1358 | (bitcast<u32>(_e882) & 2147483648u))));
                        let _e1373 = (((_e1363 * _e1363) + (_e1368 * _e1368)) + (_e1353 * _e1353));
                        if (_e1373 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e1376 = (1f / sqrt(_e1373));
                            phi_945_ = vec3<f32>((_e1363 * _e1376), (_e1368 * _e1376), (_e1353 * _e1376));
                        } else {
                            phi_945_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e1382 = phi_945_;
                        phi_5271_ = false;
                        phi_1788_ = type_59(type_58(vec3<f32>(_e188.member[0], _e188.member[1], _e188.member[2]), _e1382, 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e188.member_6[0] * _e1344), (_e188.member_6[1] * _e1344), (_e188.member_6[2] * _e1344)), 0f, _e1344);
                    } else {
                        if (_e168.member_1 == 1u) {
                            let _e752 = (1f - _e188.member_4[1]);
                            let _e753 = (_e180 * _e752);
                            let _e757 = floor(((_e181 * 4f) + 0.5f));
                            let _e763 = ((((6.2831855f * _e181) - (_e757 * 1.5703125f)) - (_e757 * 0.0004837513f)) - (_e757 * 0.0000000754979f));
                            let _e764 = (_e763 * _e763);
                            let _e771 = (_e763 + ((_e763 * _e764) * (-0.16666655f + (_e764 * (0.008332161f + (_e764 * -0.00019515296f))))));
                            let _e780 = ((1f - (0.5f * _e764)) + ((_e764 * _e764) * (0.041666646f + (_e764 * (-0.0013887316f + (_e764 * 0.000024433157f))))));
                            let _e787 = select(0i, select(select(i32(_e757), i32(-2147483648), (_e757 < -2147483600f)), 2147483647i, (_e757 > 2147483500f)), (_e757 == _e757));
                            let _e789 = ((_e787 & 1i) == 0i);
                            let _e790 = select(_e780, _e771, _e789);
                            let _e791 = select(_e771, _e780, _e789);
                            if ((_e787 & 2i) == 0i) {
                                phi_1021_ = _e790;
                            } else {
                                phi_1021_ = -(_e790);
                            }
                            let _e796 = phi_1021_;
                            if (((_e787 + 1i) & 2i) == 0i) {
                                phi_1029_ = _e791;
                            } else {
                                phi_1029_ = -(_e791);
                            }
                            let _e802 = phi_1029_;
                            let _e805 = sqrt((_e753 * (2f - _e753)));
                            let _e806 = (_e805 * _e802);
                            let _e807 = (_e805 * _e796);
                            let _e808 = (1f - _e753);
                            let _e811 = ((6.2831855f * _e752) / f32(_e162));
                            let _e820 = bitcast<f32>((1065353216u | (bitcast<u32>(_e188.member_2[2]) & 2147483648u)));
                            let _e822 = (-1f / (_e820 + _e188.member_2[2]));
                            let _e824 = ((_e188.member_2[0] * _e188.member_2[1]) * _e822);
                            let _e860 = (_e188.member_4[0] - _e188.member_4[1]);
                            let _e863 = ((_e808 - _e188.member_4[1]) / select(0.001f, _e860, (_e860 > 0.001f)));
                            let _e865 = select(0f, _e863, (_e863 > 0f));
                            let _e867 = select(1f, _e865, (_e865 < 1f));
                            let _e869 = ((_e867 * _e867) * _e811);
                            phi_5272_ = false;
                            phi_1787_ = type_59(type_58(vec3<f32>(_e188.member[0], _e188.member[1], _e188.member[2]), vec3<f32>(((((1f + (((_e820 * _e188.member_2[0]) * _e188.member_2[0]) * _e822)) * _e806) + (_e824 * _e807)) + (_e188.member_2[0] * _e808)), ((((_e820 * _e824) * _e806) + ((_e820 + ((_e188.member_2[1] * _e188.member_2[1]) * _e822)) * _e807)) + (_e188.member_2[1] * _e808)), ((((-(_e820) * _e188.member_2[0]) * _e806) + (-(_e188.member_2[1]) * _e807)) + (_e188.member_2[2] * _e808))), 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e188.member_6[0] * _e869), (_e188.member_6[1] * _e869), (_e188.member_6[2] * _e869)), 0f, _e811);
                        } else {
                            if (_e168.member_1 == 2u) {
                                let _e683 = bitcast<f32>((1065353216u | (bitcast<u32>(_e188.member_2[2]) & 2147483648u)));
                                let _e685 = (-1f / (_e683 + _e188.member_2[2]));
                                let _e687 = ((_e188.member_2[0] * _e188.member_2[1]) * _e685);
                                let _e701 = (((_e180 * 2f) - 1f) * _e168.member.w);
                                let _e704 = (((_e181 * 2f) - 1f) * _e168.member.w);
                                let _e705 = -(_e168.member.w);
                                let _e707 = ((2f * _e168.member.w) / _e179);
                                let _e736 = (_e707 * _e707);
                                phi_5273_ = false;
                                phi_1786_ = type_59(type_58(vec3<f32>((_e168.member.x + ((((1f + (((_e683 * _e188.member_2[0]) * _e188.member_2[0]) * _e685)) * _e701) + (_e687 * _e704)) + (_e188.member_2[0] * _e705))), (_e168.member.y + ((((_e683 * _e687) * _e701) + ((_e683 + ((_e188.member_2[1] * _e188.member_2[1]) * _e685)) * _e704)) + (_e188.member_2[1] * _e705))), (_e168.member.z + ((((-(_e683) * _e188.member_2[0]) * _e701) + (-(_e188.member_2[1]) * _e704)) + (_e188.member_2[2] * _e705)))), vec3<f32>(_e188.member_2[0], _e188.member_2[1], _e188.member_2[2]), 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e188.member_6[0] * _e736), (_e188.member_6[1] * _e736), (_e188.member_6[2] * _e736)), _e736, 0f);
                            } else {
                                let _e193 = (_e168.member_3 + _e170);
                                if (_e168.member_2 > 0u) {
                                    let _e195 = (_e168.member_2 - 1u);
                                    if (_e195 < _e142) {
                                    } else {
                                        break;
                                    }
                                    let _e200 = lights.member[_e195].member_5;
                                    phi_1215_ = _e200;
                                } else {
                                    phi_1215_ = 0f;
                                }
                                let _e202 = phi_1215_;
                                let _e203 = (1f - _e202);
                                let _e206 = params.member.member_4;
                                let _e210 = f32(_e168.member_4);
                                phi_1229_ = (_e206 - 1u);
                                phi_1232_ = _e168.member_2;
                                loop {
                                    let _e216 = phi_1229_;
                                    let _e218 = phi_1232_;
                                    local_4 = _e218;
                                    local_5 = _e218;
                                    local_6 = _e218;
                                    local_7 = _e218;
                                    local_8 = _e218;
                                    local_9 = _e218;
                                    local_10 = _e218;
                                    let _e219 = (_e218 < _e216);
                                    if _e219 {
                                        let _e221 = ((_e218 + _e216) / 2u);
                                        if (_e221 < _e142) {
                                        } else {
                                            phi_5249_ = true;
                                            break;
                                        }
                                        let _e226 = lights.member[_e221].member_5;
                                        let _e227 = (_e226 > (_e202 + (_e203 * ((f32(_e193) + 0.5f) / _e210))));
                                        if _e227 {
                                            phi_1256_ = _e218;
                                        } else {
                                            phi_1256_ = (_e221 + 1u);
                                        }
                                        let _e230 = phi_1256_;
                                        phi_1230_ = select(_e216, _e221, _e227);
                                        phi_1233_ = _e230;
                                    } else {
                                        phi_1230_ = u32();
                                        phi_1233_ = u32();
                                    }
                                    let _e233 = phi_1230_;
                                    let _e235 = phi_1233_;
                                    continue;
                                    continuing {
                                        phi_1229_ = _e233;
                                        phi_1232_ = _e235;
                                        phi_5249_ = false;
                                        break if !(_e219);
                                    }
                                }
                                let _e238 = phi_5249_;
                                if _e238 {
                                    break;
                                }
                                let _e240 = local_4;
                                if (_e240 < _e142) {
                                } else {
                                    break;
                                }
                                let _e244 = local_5;
                                let _e247 = lights.member[_e244].member;
                                let _e250 = local_6;
                                let _e253 = lights.member[_e250].member_2;
                                let _e256 = local_7;
                                let _e259 = lights.member[_e256].member_3;
                                let _e262 = local_8;
                                let _e265 = lights.member[_e262].member_4;
                                let _e268 = local_9;
                                let _e271 = lights.member[_e268].member_6;
                                let _e274 = local_10;
                                let _e277 = lights.member[_e274].member_7;
                                let _e287 = (_e253[0] - _e247[0]);
                                let _e288 = (_e253[1] - _e247[1]);
                                let _e289 = (_e253[2] - _e247[2]);
                                let _e290 = (_e265[0] - _e247[0]);
                                let _e291 = (_e265[1] - _e247[1]);
                                let _e292 = (_e265[2] - _e247[2]);
                                let _e295 = ((_e288 * _e292) - (_e291 * _e289));
                                let _e298 = ((_e289 * _e290) - (_e292 * _e287));
                                let _e301 = ((_e287 * _e291) - (_e290 * _e288));
                                let _e302 = abs(_e295);
                                let _e303 = abs(_e298);
                                let _e305 = select(_e303, _e302, (_e302 > _e303));
                                let _e306 = abs(_e301);
                                let _e308 = select(_e306, _e305, (_e305 > _e306));
                                if (_e308 > 0.000000000000000000000000000000000000011754944f) {
                                    let _e310 = (_e308 < 340282350000000000000000000000000000000f);
                                    if _e310 {
                                        let _e311 = (_e295 / _e308);
                                        let _e312 = (_e298 / _e308);
                                        let _e313 = (_e301 / _e308);
                                        let _e319 = sqrt((((_e311 * _e311) + (_e312 * _e312)) + (_e313 * _e313)));
                                        phi_1351_ = vec3<f32>((_e311 / _e319), (_e312 / _e319), (_e313 / _e319));
                                    } else {
                                        phi_1351_ = vec3<f32>();
                                    }
                                    let _e325 = phi_1351_;
                                    phi_1353_ = _e325;
                                    phi_1354_ = select(true, false, _e310);
                                } else {
                                    phi_1353_ = vec3<f32>();
                                    phi_1354_ = true;
                                }
                                let _e328 = phi_1353_;
                                let _e330 = phi_1354_;
                                let _e332 = select(_e328, vec3<f32>(0f, 1f, 0f), vec3(_e330));
                                let _e335 = params.member.member_5;
                                let _e339 = ((_e193 * 1664525u) + 1013904223u);
                                let _e341 = (((_e335 * 1664525u) + 1013904223u) + (_e339 * 1013904223u));
                                let _e343 = (_e339 + (1013904223u * _e341));
                                let _e345 = (1013904223u + (_e341 * _e343));
                                let _e347 = (1013904223u + (_e343 * _e345));
                                let _e353 = (_e343 ^ (_e343 >> bitcast<u32>(16i)));
                                let _e361 = ((_e341 ^ (_e341 >> bitcast<u32>(16i))) + (_e353 * (_e347 ^ (_e347 >> bitcast<u32>(16i)))));
                                let _e366 = f32((_e361 >> bitcast<u32>(8i)));
                                let _e367 = (_e366 * 0.000000059604645f);
                                let _e370 = f32(((_e353 + ((_e345 ^ (_e345 >> bitcast<u32>(16i))) * _e361)) >> bitcast<u32>(8i)));
                                let _e371 = (_e370 * 0.000000059604645f);
                                if (_e367 < _e371) {
                                    let _e376 = (_e366 * 0.000000029802322f);
                                    phi_1405_ = vec2<f32>(_e376, (_e371 - _e376));
                                } else {
                                    let _e373 = (_e370 * 0.000000029802322f);
                                    phi_1405_ = vec2<f32>((_e367 - _e373), _e373);
                                }
                                let _e380 = phi_1405_;
                                let _e408 = ((_e335 ^ (_e335 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e412 = ((_e408 ^ (_e408 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e419 = (_e335 ^ 2654435769u);
                                let _e423 = ((_e419 ^ (_e419 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e427 = ((_e423 ^ (_e423 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e435 = (0.000000059604645f * (f32(((2147483648u + (_e193 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e412 ^ (_e412 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                if (_e435 >= 1f) {
                                    phi_4461_ = (_e435 - 1f);
                                } else {
                                    phi_4461_ = _e435;
                                }
                                let _e439 = phi_4461_;
                                let _e441 = (0.000000059604645f * (f32(((2147483648u + (_e193 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e427 ^ (_e427 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                if (_e441 >= 1f) {
                                    phi_4469_ = (_e441 - 1f);
                                } else {
                                    phi_4469_ = _e441;
                                }
                                let _e445 = phi_4469_;
                                let _e447 = ((2f * _e439) - 1f);
                                let _e449 = ((2f * _e445) - 1f);
                                if (_e447 == 0f) {
                                    let _e451 = (_e449 == 0f);
                                    phi_1486_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e451));
                                    phi_1487_ = select(true, false, _e451);
                                } else {
                                    phi_1486_ = vec2<f32>();
                                    phi_1487_ = true;
                                }
                                let _e456 = phi_1486_;
                                let _e458 = phi_1487_;
                                if _e458 {
                                    if (abs(_e447) > abs(_e449)) {
                                        let _e515 = (_e449 / _e447);
                                        let _e519 = floor(((_e515 * 0.5f) + 0.5f));
                                        let _e525 = ((((0.7853982f * _e515) - (_e519 * 1.5703125f)) - (_e519 * 0.0004837513f)) - (_e519 * 0.0000000754979f));
                                        let _e526 = (_e525 * _e525);
                                        let _e533 = (_e525 + ((_e525 * _e526) * (-0.16666655f + (_e526 * (0.008332161f + (_e526 * -0.00019515296f))))));
                                        let _e542 = ((1f - (0.5f * _e526)) + ((_e526 * _e526) * (0.041666646f + (_e526 * (-0.0013887316f + (_e526 * 0.000024433157f))))));
                                        let _e549 = select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < -2147483600f)), 2147483647i, (_e519 > 2147483500f)), (_e519 == _e519));
                                        let _e551 = ((_e549 & 1i) == 0i);
                                        let _e552 = select(_e542, _e533, _e551);
                                        let _e553 = select(_e533, _e542, _e551);
                                        if ((_e549 & 2i) == 0i) {
                                            phi_1551_ = _e552;
                                        } else {
                                            phi_1551_ = -(_e552);
                                        }
                                        let _e558 = phi_1551_;
                                        if (((_e549 + 1i) & 2i) == 0i) {
                                            phi_1559_ = _e553;
                                        } else {
                                            phi_1559_ = -(_e553);
                                        }
                                        let _e564 = phi_1559_;
                                        phi_1629_ = vec2<f32>((_e447 * _e564), (_e447 * _e558));
                                    } else {
                                        let _e462 = (_e447 / _e449);
                                        let _e466 = floor(((_e462 * 0.5f) + 0.5f));
                                        let _e472 = ((((0.7853982f * _e462) - (_e466 * 1.5703125f)) - (_e466 * 0.0004837513f)) - (_e466 * 0.0000000754979f));
                                        let _e473 = (_e472 * _e472);
                                        let _e480 = (_e472 + ((_e472 * _e473) * (-0.16666655f + (_e473 * (0.008332161f + (_e473 * -0.00019515296f))))));
                                        let _e489 = ((1f - (0.5f * _e473)) + ((_e473 * _e473) * (0.041666646f + (_e473 * (-0.0013887316f + (_e473 * 0.000024433157f))))));
                                        let _e496 = select(0i, select(select(i32(_e466), i32(-2147483648), (_e466 < -2147483600f)), 2147483647i, (_e466 > 2147483500f)), (_e466 == _e466));
                                        let _e498 = ((_e496 & 1i) == 0i);
                                        let _e499 = select(_e489, _e480, _e498);
                                        let _e500 = select(_e480, _e489, _e498);
                                        if ((_e496 & 2i) == 0i) {
                                            phi_1617_ = _e499;
                                        } else {
                                            phi_1617_ = -(_e499);
                                        }
                                        let _e505 = phi_1617_;
                                        if (((_e496 + 1i) & 2i) == 0i) {
                                            phi_1625_ = _e500;
                                        } else {
                                            phi_1625_ = -(_e500);
                                        }
                                        let _e511 = phi_1625_;
                                        phi_1629_ = vec2<f32>((_e449 * _e505), (_e449 * _e511));
                                    }
                                    let _e569 = phi_1629_;
                                    phi_1630_ = _e569;
                                } else {
                                    phi_1630_ = _e456;
                                }
                                let _e571 = phi_1630_;
                                let _e577 = (1f - ((_e571.x * _e571.x) + (_e571.y * _e571.y)));
                                let _e580 = sqrt(select(0f, _e577, (_e577 > 0f)));
                                let _e585 = bitcast<f32>((1065353216u | (bitcast<u32>(_e332.z) & 2147483648u)));
                                let _e587 = (-1f / (_e585 + _e332.z));
                                let _e591 = ((_e332.x * _e332.y) * _e587);
                                let _e615 = ((((1f + (((_e585 * _e332.x) * _e332.x) * _e587)) * _e571.x) + (_e591 * _e571.y)) + (_e332.x * _e580));
                                let _e616 = ((((_e585 * _e591) * _e571.x) + ((_e585 + ((_e332.y * _e332.y) * _e587)) * _e571.y)) + (_e332.y * _e580));
                                let _e617 = ((((-(_e585) * _e332.x) * _e571.x) + (-(_e332.y) * _e571.y)) + (_e332.z * _e580));
                                let _e622 = ((_e210 * _e277) / select(0.000000000000000000000000000000000000011754944f, _e203, (_e203 > 0.000000000000000000000000000000000000011754944f)));
                                let _e625 = abs(_e247[0]);
                                let _e626 = abs(_e247[1]);
                                let _e627 = abs(_e247[2]);
                                let _e629 = select(_e626, _e625, (_e625 > _e626));
                                let _e631 = select(_e627, _e629, (_e629 > _e627));
                                let _e632 = abs(_e287);
                                let _e633 = abs(_e288);
                                let _e634 = abs(_e289);
                                let _e636 = select(_e633, _e632, (_e632 > _e633));
                                let _e638 = select(_e634, _e636, (_e636 > _e634));
                                let _e640 = select(_e638, _e631, (_e631 > _e638));
                                if ((((_e332.x * _e615) + (_e332.y * _e616)) + (_e332.z * _e617)) < 0f) {
                                    phi_1755_ = (_e640 * -0.000001f);
                                } else {
                                    phi_1755_ = (_e640 * 0.000001f);
                                }
                                let _e650 = phi_1755_;
                                let _e663 = ((3.1415927f * _e259) / select(0.000000000000000000000000000000000000011754944f, _e622, (_e622 > 0.000000000000000000000000000000000000011754944f)));
                                phi_5273_ = _e238;
                                phi_1786_ = type_59(type_58(vec3<f32>((((_e247[0] + (_e287 * _e380.x)) + (_e290 * _e380.y)) + (_e332.x * _e650)), (((_e247[1] + (_e288 * _e380.x)) + (_e291 * _e380.y)) + (_e332.y * _e650)), (((_e247[2] + (_e289 * _e380.x)) + (_e292 * _e380.y)) + (_e332.z * _e650))), vec3<f32>(_e615, _e616, _e617), 0f, 340282350000000000000000000000000000000f), vec3<f32>((_e271[0] * _e663), (_e271[1] * _e663), (_e271[2] * _e663)), 0f, (3.1415927f / (_e210 * select(0.05f, _e580, (_e580 > 0.05f)))));
                            }
                            let _e743 = phi_5273_;
                            let _e745 = phi_1786_;
                            phi_5272_ = _e743;
                            phi_1787_ = _e745;
                        }
                        let _e876 = phi_5272_;
                        let _e878 = phi_1787_;
                        phi_5271_ = _e876;
                        phi_1788_ = _e878;
                    }
                    let _e1394 = phi_5271_;
                    let _e1396 = phi_1788_;
                    phi_5270_ = _e1394;
                    phi_1789_ = _e1396;
                }
                let _e1744 = phi_5270_;
                let _e1746 = phi_1789_;
                let _e1750 = abs(_e1746.member.member_1.x);
                let _e1754 = abs(_e1746.member.member_1.y);
                let _e1758 = abs(_e1746.member.member_1.z);
                let _e1759 = (_e1750 > _e1754);
                if _e1759 {
                    phi_1809_ = (_e1750 > _e1758);
                } else {
                    phi_1809_ = (_e1754 > _e1758);
                }
                let _e1763 = phi_1809_;
                let _e1764 = select(1u, 0u, _e1759);
                if _e1763 {
                    let _e1765 = (_e1764 + 1u);
                    phi_1819_ = _e1765;
                    phi_1822_ = select(true, false, (_e1765 == 2u));
                } else {
                    phi_1819_ = u32();
                    phi_1822_ = false;
                }
                let _e1769 = phi_1819_;
                let _e1771 = phi_1822_;
                let _e1772 = select(true, false, _e1763);
                let _e1773 = select(_e1769, 0u, _e1772);
                let _e1775 = select(_e1771, true, _e1772);
                if _e1775 {
                    phi_1833_ = (_e1773 + 1u);
                } else {
                    phi_1833_ = 0u;
                }
                let _e1778 = phi_1833_;
                let _e1779 = select(_e1769, _e1773, _e1775);
                let _e1780 = select(_e1764, select(_e1764, 2u, _e1772), _e1775);
                local_2 = array<f32, 3>(_e1746.member.member_1.x, _e1746.member.member_1.y, _e1746.member.member_1.z);
                local_3 = array<f32, 3>(_e1746.member.member.x, _e1746.member.member.y, _e1746.member.member.z);
                let _e1792 = (_e1780 < 3u);
                if _e1792 {
                } else {
                    break;
                }
                let _e1794 = local_2[_e1780];
                let _e1795 = (1f / _e1794);
                let _e1796 = (_e1779 < 3u);
                if _e1796 {
                } else {
                    break;
                }
                let _e1798 = local_2[_e1779];
                let _e1799 = (_e1798 * _e1795);
                let _e1800 = (_e1778 < 3u);
                if _e1800 {
                } else {
                    break;
                }
                let _e1802 = local_2[_e1778];
                let _e1803 = (_e1802 * _e1795);
                if _e1796 {
                } else {
                    break;
                }
                let _e1805 = local_3[_e1779];
                if _e1800 {
                } else {
                    break;
                }
                let _e1807 = local_3[_e1778];
                if _e1792 {
                } else {
                    break;
                }
                let _e1809 = local_3[_e1780];
                if (0u < _e131) {
                } else {
                    break;
                }
                let _e1814 = nodes.member[0u].member_7[0u];
                let _e1818 = nodes.member[0u].member_7[1u];
                let _e1822 = nodes.member[0u].member_7[2u];
                let _e1826 = nodes.member[0u].member_7[3u];
                let _e1828 = abs((_e1746.member.member.x - _e1814));
                let _e1830 = abs((_e1746.member.member.y - _e1818));
                let _e1832 = select(_e1830, _e1828, (_e1828 > _e1830));
                let _e1834 = abs((_e1746.member.member.z - _e1822));
                let _e1838 = ((select(_e1834, _e1832, (_e1832 > _e1834)) + _e1826) * 0.0000009536743f);
                let _e1845 = (_e1838 + (abs(_e1746.member.member.x) * 0.00000023841858f));
                let _e1846 = (_e1838 + (abs(_e1746.member.member.y) * 0.00000023841858f));
                let _e1847 = (_e1838 + (abs(_e1746.member.member.z) * 0.00000023841858f));
                let _e1848 = select(_e1754, _e1750, _e1759);
                let _e1850 = select(_e1758, _e1848, (_e1848 > _e1758));
                let _e1851 = (_e1850 * 0.000000000001f);
                let _e1855 = (_e1746.member.member.x + _e1845);
                let _e1857 = (_e1746.member.member.y + _e1846);
                let _e1859 = (_e1746.member.member.z + _e1847);
                let _e1860 = (_e1746.member.member.x - _e1845);
                let _e1861 = (_e1746.member.member.y - _e1846);
                let _e1862 = (_e1746.member.member.z - _e1847);
                if (_e1750 > _e1851) {
                    phi_1986_ = (1f / _e1746.member.member_1.x);
                } else {
                    phi_1986_ = (1000000000000f / _e1850);
                }
                let _e1867 = phi_1986_;
                if (_e1754 > _e1851) {
                    phi_1994_ = (1f / _e1746.member.member_1.y);
                } else {
                    phi_1994_ = (1000000000000f / _e1850);
                }
                let _e1872 = phi_1994_;
                if (_e1758 > _e1851) {
                    phi_2002_ = (1f / _e1746.member.member_1.z);
                } else {
                    phi_2002_ = (1000000000000f / _e1850);
                }
                let _e1877 = phi_2002_;
                local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                local_1 = array<f32, 64>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                phi_5258_ = _e1744;
                phi_2006_ = 0u;
                phi_2009_ = 0u;
                phi_2011_ = type_64(_e1746.member.member_3, 4294967295u, 0f, 0f);
                loop {
                    let _e1882 = phi_5258_;
                    let _e1884 = phi_2006_;
                    let _e1886 = phi_2009_;
                    let _e1888 = phi_2011_;
                    let _e1889 = (_e1884 & 15u);
                    let _e1891 = (_e1884 >> bitcast<u32>(4u));
                    if (_e1889 == 0u) {
                        if (_e1891 < _e131) {
                        } else {
                            phi_5467_ = true;
                            phi_4437_ = type_64();
                            break;
                        }
                        let _e2524 = nodes.member[_e1891].member;
                        let _e2533 = ((_e2524.x - _e1855) * _e1867);
                        let _e2534 = ((_e2524.y - _e1855) * _e1867);
                        let _e2535 = ((_e2524.z - _e1855) * _e1867);
                        let _e2536 = ((_e2524.w - _e1855) * _e1867);
                        let _e2539 = nodes.member[_e1891].member_3;
                        let _e2548 = ((_e2539.x - _e1860) * _e1867);
                        let _e2549 = ((_e2539.y - _e1860) * _e1867);
                        let _e2550 = ((_e2539.z - _e1860) * _e1867);
                        let _e2551 = ((_e2539.w - _e1860) * _e1867);
                        let _e2554 = nodes.member[_e1891].member_1;
                        let _e2563 = ((_e2554.x - _e1857) * _e1872);
                        let _e2564 = ((_e2554.y - _e1857) * _e1872);
                        let _e2565 = ((_e2554.z - _e1857) * _e1872);
                        let _e2566 = ((_e2554.w - _e1857) * _e1872);
                        let _e2569 = nodes.member[_e1891].member_4;
                        let _e2578 = ((_e2569.x - _e1861) * _e1872);
                        let _e2579 = ((_e2569.y - _e1861) * _e1872);
                        let _e2580 = ((_e2569.z - _e1861) * _e1872);
                        let _e2581 = ((_e2569.w - _e1861) * _e1872);
                        let _e2584 = nodes.member[_e1891].member_2;
                        let _e2593 = ((_e2584.x - _e1859) * _e1877);
                        let _e2594 = ((_e2584.y - _e1859) * _e1877);
                        let _e2595 = ((_e2584.z - _e1859) * _e1877);
                        let _e2596 = ((_e2584.w - _e1859) * _e1877);
                        let _e2599 = nodes.member[_e1891].member_5;
                        let _e2608 = ((_e2599.x - _e1862) * _e1877);
                        let _e2609 = ((_e2599.y - _e1862) * _e1877);
                        let _e2610 = ((_e2599.z - _e1862) * _e1877);
                        let _e2611 = ((_e2599.w - _e1862) * _e1877);
                        let _e2613 = select(_e2548, _e2533, (_e2533 < _e2548));
                        let _e2615 = select(_e2549, _e2534, (_e2534 < _e2549));
                        let _e2617 = select(_e2550, _e2535, (_e2535 < _e2550));
                        let _e2619 = select(_e2551, _e2536, (_e2536 < _e2551));
                        let _e2621 = select(_e2578, _e2563, (_e2563 < _e2578));
                        let _e2623 = select(_e2579, _e2564, (_e2564 < _e2579));
                        let _e2625 = select(_e2580, _e2565, (_e2565 < _e2580));
                        let _e2627 = select(_e2581, _e2566, (_e2566 < _e2581));
                        let _e2629 = select(_e2621, _e2613, (_e2613 > _e2621));
                        let _e2631 = select(_e2623, _e2615, (_e2615 > _e2623));
                        let _e2633 = select(_e2625, _e2617, (_e2617 > _e2625));
                        let _e2635 = select(_e2627, _e2619, (_e2619 > _e2627));
                        let _e2637 = select(_e2608, _e2593, (_e2593 < _e2608));
                        let _e2639 = select(_e2609, _e2594, (_e2594 < _e2609));
                        let _e2641 = select(_e2610, _e2595, (_e2595 < _e2610));
                        let _e2643 = select(_e2611, _e2596, (_e2596 < _e2611));
                        let _e2645 = select(_e2637, _e2629, (_e2629 > _e2637));
                        let _e2647 = select(_e2639, _e2631, (_e2631 > _e2639));
                        let _e2649 = select(_e2641, _e2633, (_e2633 > _e2641));
                        let _e2651 = select(_e2643, _e2635, (_e2635 > _e2643));
                        let _e2653 = select(_e1746.member.member_2, _e2645, (_e2645 > _e1746.member.member_2));
                        let _e2655 = select(_e1746.member.member_2, _e2647, (_e2647 > _e1746.member.member_2));
                        let _e2657 = select(_e1746.member.member_2, _e2649, (_e2649 > _e1746.member.member_2));
                        let _e2659 = select(_e1746.member.member_2, _e2651, (_e2651 > _e1746.member.member_2));
                        let _e2661 = select(_e2548, _e2533, (_e2533 > _e2548));
                        let _e2663 = select(_e2549, _e2534, (_e2534 > _e2549));
                        let _e2665 = select(_e2550, _e2535, (_e2535 > _e2550));
                        let _e2667 = select(_e2551, _e2536, (_e2536 > _e2551));
                        let _e2669 = select(_e2578, _e2563, (_e2563 > _e2578));
                        let _e2671 = select(_e2579, _e2564, (_e2564 > _e2579));
                        let _e2673 = select(_e2580, _e2565, (_e2565 > _e2580));
                        let _e2675 = select(_e2581, _e2566, (_e2566 > _e2581));
                        let _e2677 = select(_e2669, _e2661, (_e2661 < _e2669));
                        let _e2679 = select(_e2671, _e2663, (_e2663 < _e2671));
                        let _e2681 = select(_e2673, _e2665, (_e2665 < _e2673));
                        let _e2683 = select(_e2675, _e2667, (_e2667 < _e2675));
                        let _e2685 = select(_e2608, _e2593, (_e2593 > _e2608));
                        let _e2687 = select(_e2609, _e2594, (_e2594 > _e2609));
                        let _e2689 = select(_e2610, _e2595, (_e2595 > _e2610));
                        let _e2691 = select(_e2611, _e2596, (_e2596 > _e2611));
                        let _e2693 = select(_e2685, _e2677, (_e2677 < _e2685));
                        let _e2695 = select(_e2687, _e2679, (_e2679 < _e2687));
                        let _e2697 = select(_e2689, _e2681, (_e2681 < _e2689));
                        let _e2699 = select(_e2691, _e2683, (_e2683 < _e2691));
                        let _e2709 = select(340282350000000000000000000000000000000f, _e2653, (_e2653 <= select(_e1888.member, _e2693, (_e2693 < _e1888.member))));
                        let _e2711 = select(340282350000000000000000000000000000000f, _e2655, (_e2655 <= select(_e1888.member, _e2695, (_e2695 < _e1888.member))));
                        let _e2713 = select(340282350000000000000000000000000000000f, _e2657, (_e2657 <= select(_e1888.member, _e2697, (_e2697 < _e1888.member))));
                        let _e2715 = select(340282350000000000000000000000000000000f, _e2659, (_e2659 <= select(_e1888.member, _e2699, (_e2699 < _e1888.member))));
                        let _e2719 = nodes.member[_e1891].member_6[0u];
                        let _e2723 = nodes.member[_e1891].member_6[1u];
                        let _e2727 = nodes.member[_e1891].member_6[2u];
                        let _e2731 = nodes.member[_e1891].member_6[3u];
                        if (_e2711 < _e2709) {
                            phi_2393_ = type_65(_e2711, _e2723, _e2709, _e2719);
                        } else {
                            phi_2393_ = type_65(_e2709, _e2719, _e2711, _e2723);
                        }
                        let _e2736 = phi_2393_;
                        if (_e2715 < _e2713) {
                            phi_2404_ = type_65(_e2715, _e2731, _e2713, _e2727);
                        } else {
                            phi_2404_ = type_65(_e2713, _e2727, _e2715, _e2731);
                        }
                        let _e2745 = phi_2404_;
                        if (_e2745.member < _e2736.member) {
                            phi_2415_ = type_65(_e2745.member, _e2745.member_1, _e2736.member, _e2736.member_1);
                        } else {
                            phi_2415_ = type_65(_e2736.member, _e2736.member_1, _e2745.member, _e2745.member_1);
                        }
                        let _e2754 = phi_2415_;
                        if (_e2745.member_2 < _e2736.member_2) {
                            phi_2426_ = type_65(_e2745.member_2, _e2745.member_3, _e2736.member_2, _e2736.member_3);
                        } else {
                            phi_2426_ = type_65(_e2736.member_2, _e2736.member_3, _e2745.member_2, _e2745.member_3);
                        }
                        let _e2763 = phi_2426_;
                        if (_e2754.member_2 < _e2763.member) {
                            phi_2437_ = type_65(_e2754.member_2, _e2754.member_3, _e2763.member, _e2763.member_1);
                        } else {
                            phi_2437_ = type_65(_e2763.member, _e2763.member_1, _e2754.member_2, _e2754.member_3);
                        }
                        let _e2772 = phi_2437_;
                        if (_e2763.member_2 < 340282350000000000000000000000000000000f) {
                            let _e2778 = (_e1886 < 64u);
                            if _e2778 {
                            } else {
                                phi_5467_ = true;
                                phi_4437_ = type_64();
                                break;
                            }
                            local[_e1886] = _e2763.member_3;
                            if _e2778 {
                            } else {
                                phi_5467_ = true;
                                phi_4437_ = type_64();
                                break;
                            }
                            local_1[_e1886] = _e2763.member_2;
                            phi_2459_ = (_e1886 + 1u);
                        } else {
                            phi_2459_ = _e1886;
                        }
                        let _e2783 = phi_2459_;
                        if (_e2772.member_2 < 340282350000000000000000000000000000000f) {
                            let _e2785 = (_e2783 < 64u);
                            if _e2785 {
                            } else {
                                phi_5467_ = true;
                                phi_4437_ = type_64();
                                break;
                            }
                            local[_e2783] = _e2772.member_3;
                            if _e2785 {
                            } else {
                                phi_5467_ = true;
                                phi_4437_ = type_64();
                                break;
                            }
                            local_1[_e2783] = _e2772.member_2;
                            phi_2477_ = (_e2783 + 1u);
                        } else {
                            phi_2477_ = _e2783;
                        }
                        let _e2790 = phi_2477_;
                        if (_e2772.member < 340282350000000000000000000000000000000f) {
                            let _e2792 = (_e2790 < 64u);
                            if _e2792 {
                            } else {
                                phi_5467_ = true;
                                phi_4437_ = type_64();
                                break;
                            }
                            local[_e2790] = _e2772.member_1;
                            if _e2792 {
                            } else {
                                phi_5467_ = true;
                                phi_4437_ = type_64();
                                break;
                            }
                            local_1[_e2790] = _e2772.member;
                            phi_2495_ = (_e2790 + 1u);
                        } else {
                            phi_2495_ = _e2790;
                        }
                        let _e2797 = phi_2495_;
                        phi_5403_ = _e1882;
                        phi_3185_ = select(0u, _e2754.member_1, (_e2754.member < 340282350000000000000000000000000000000f));
                        phi_3186_ = _e2797;
                        phi_2012_ = _e1888;
                    } else {
                        phi_2504_ = type_12(_e1891, (_e1891 + _e1889));
                        phi_2507_ = _e1888;
                        loop {
                            let _e1896 = phi_2504_;
                            let _e1898 = phi_2507_;
                            local_14 = _e1898;
                            if (_e1896.member < _e1896.member_1) {
                                phi_2505_ = type_12((_e1896.member + 1u), _e1896.member_1);
                                phi_2530_ = type_12(1u, _e1896.member);
                            } else {
                                phi_2505_ = _e1896;
                                phi_2530_ = type_12(0u, type_12().member_1);
                            }
                            let _e1911 = phi_2505_;
                            let _e1913 = phi_2530_;
                            let _e1917 = (bitcast<i32>(_e1913.member) != 0i);
                            if _e1917 {
                                let _e1918 = (_e1913.member_1 < _e134);
                                if _e1918 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                if _e1792 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                let _e1922 = triangles.member[_e1913.member_1].member[_e1780];
                                let _e1923 = (_e1922 - _e1809);
                                if _e1792 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                let _e1927 = triangles.member[_e1913.member_1].member_2[_e1780];
                                let _e1928 = (_e1927 - _e1809);
                                if _e1792 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                let _e1932 = triangles.member[_e1913.member_1].member_4[_e1780];
                                let _e1933 = (_e1932 - _e1809);
                                if _e1796 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                let _e1937 = triangles.member[_e1913.member_1].member[_e1779];
                                let _e1940 = ((_e1937 - _e1805) - (_e1799 * _e1923));
                                if _e1800 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                let _e1944 = triangles.member[_e1913.member_1].member[_e1778];
                                let _e1947 = ((_e1944 - _e1807) - (_e1803 * _e1923));
                                if _e1796 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                let _e1951 = triangles.member[_e1913.member_1].member_2[_e1779];
                                let _e1954 = ((_e1951 - _e1805) - (_e1799 * _e1928));
                                if _e1800 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                let _e1958 = triangles.member[_e1913.member_1].member_2[_e1778];
                                let _e1961 = ((_e1958 - _e1807) - (_e1803 * _e1928));
                                if _e1796 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                let _e1965 = triangles.member[_e1913.member_1].member_4[_e1779];
                                let _e1968 = ((_e1965 - _e1805) - (_e1799 * _e1933));
                                if _e1800 {
                                } else {
                                    phi_5254_ = true;
                                    break;
                                }
                                let _e1972 = triangles.member[_e1913.member_1].member_4[_e1778];
                                let _e1975 = ((_e1972 - _e1807) - (_e1803 * _e1933));
                                let _e1976 = (_e1968 * _e1961);
                                let _e1977 = (_e1975 * _e1954);
                                if (_e1976 != _e1977) {
                                    phi_2646_ = (_e1976 - _e1977);
                                } else {
                                    let _e1979 = (_e1968 * 4097f);
                                    let _e1981 = (_e1979 - (_e1979 - _e1968));
                                    let _e1982 = (_e1961 * 4097f);
                                    let _e1984 = (_e1982 - (_e1982 - _e1961));
                                    let _e1985 = (_e1968 - _e1981);
                                    let _e1986 = (_e1961 - _e1984);
                                    let _e1995 = (_e1975 * 4097f);
                                    let _e1997 = (_e1995 - (_e1995 - _e1975));
                                    let _e1998 = (_e1954 * 4097f);
                                    let _e2000 = (_e1998 - (_e1998 - _e1954));
                                    let _e2001 = (_e1975 - _e1997);
                                    let _e2002 = (_e1954 - _e2000);
                                    phi_2646_ = ((((((_e1981 * _e1984) - _e1976) + (_e1981 * _e1986)) + (_e1985 * _e1984)) + (_e1985 * _e1986)) - (((((_e1997 * _e2000) - _e1977) + (_e1997 * _e2002)) + (_e2001 * _e2000)) + (_e2001 * _e2002)));
                                }
                                let _e2014 = phi_2646_;
                                let _e2015 = (_e1940 * _e1975);
                                let _e2016 = (_e1947 * _e1968);
                                if (_e2015 != _e2016) {
                                    phi_2657_ = (_e2015 - _e2016);
                                } else {
                                    let _e2018 = (_e1940 * 4097f);
                                    let _e2020 = (_e2018 - (_e2018 - _e1940));
                                    let _e2021 = (_e1975 * 4097f);
                                    let _e2023 = (_e2021 - (_e2021 - _e1975));
                                    let _e2024 = (_e1940 - _e2020);
                                    let _e2025 = (_e1975 - _e2023);
                                    let _e2034 = (_e1947 * 4097f);
                                    let _e2036 = (_e2034 - (_e2034 - _e1947));
                                    let _e2037 = (_e1968 * 4097f);
                                    let _e2039 = (_e2037 - (_e2037 - _e1968));
                                    let _e2040 = (_e1947 - _e2036);
                                    let _e2041 = (_e1968 - _e2039);
                                    phi_2657_ = ((((((_e2020 * _e2023) - _e2015) + (_e2020 * _e2025)) + (_e2024 * _e2023)) + (_e2024 * _e2025)) - (((((_e2036 * _e2039) - _e2016) + (_e2036 * _e2041)) + (_e2040 * _e2039)) + (_e2040 * _e2041)));
                                }
                                let _e2053 = phi_2657_;
                                let _e2054 = (_e1954 * _e1947);
                                let _e2055 = (_e1961 * _e1940);
                                if (_e2054 != _e2055) {
                                    phi_2668_ = (_e2054 - _e2055);
                                } else {
                                    let _e2057 = (_e1954 * 4097f);
                                    let _e2059 = (_e2057 - (_e2057 - _e1954));
                                    let _e2060 = (_e1947 * 4097f);
                                    let _e2062 = (_e2060 - (_e2060 - _e1947));
                                    let _e2063 = (_e1954 - _e2059);
                                    let _e2064 = (_e1947 - _e2062);
                                    let _e2073 = (_e1961 * 4097f);
                                    let _e2075 = (_e2073 - (_e2073 - _e1961));
                                    let _e2076 = (_e1940 * 4097f);
                                    let _e2078 = (_e2076 - (_e2076 - _e1940));
                                    let _e2079 = (_e1961 - _e2075);
                                    let _e2080 = (_e1940 - _e2078);
                                    phi_2668_ = ((((((_e2059 * _e2062) - _e2054) + (_e2059 * _e2064)) + (_e2063 * _e2062)) + (_e2063 * _e2064)) - (((((_e2075 * _e2078) - _e2055) + (_e2075 * _e2080)) + (_e2079 * _e2078)) + (_e2079 * _e2080)));
                                }
                                let _e2092 = phi_2668_;
                                if (_e2014 < 0f) {
                                    phi_2686_ = f32();
                                    phi_2687_ = true;
                                } else {
                                    if (_e2053 < 0f) {
                                        phi_2684_ = f32();
                                        phi_2685_ = true;
                                    } else {
                                        let _e2095 = (_e2092 < 0f);
                                        if _e2095 {
                                            phi_2683_ = f32();
                                        } else {
                                            phi_2683_ = ((_e2014 + _e2053) + _e2092);
                                        }
                                        let _e2099 = phi_2683_;
                                        phi_2684_ = _e2099;
                                        phi_2685_ = _e2095;
                                    }
                                    let _e2101 = phi_2684_;
                                    let _e2103 = phi_2685_;
                                    phi_2686_ = _e2101;
                                    phi_2687_ = _e2103;
                                }
                                let _e2105 = phi_2686_;
                                let _e2107 = phi_2687_;
                                if _e2107 {
                                    if (_e2014 > 0f) {
                                        phi_2708_ = f32();
                                        phi_2709_ = true;
                                        phi_2710_ = false;
                                    } else {
                                        let _e2109 = (_e2053 > 0f);
                                        if _e2109 {
                                            phi_2706_ = f32();
                                            phi_2707_ = false;
                                        } else {
                                            phi_2706_ = ((_e2014 + _e2053) + _e2092);
                                            phi_2707_ = select(true, false, (_e2092 > 0f));
                                        }
                                        let _e2115 = phi_2706_;
                                        let _e2117 = phi_2707_;
                                        phi_2708_ = _e2115;
                                        phi_2709_ = _e2109;
                                        phi_2710_ = _e2117;
                                    }
                                    let _e2119 = phi_2708_;
                                    let _e2121 = phi_2709_;
                                    let _e2123 = phi_2710_;
                                    phi_2715_ = _e2119;
                                    phi_2716_ = select(_e2123, false, _e2121);
                                } else {
                                    phi_2715_ = _e2105;
                                    phi_2716_ = true;
                                }
                                let _e2126 = phi_2715_;
                                let _e2128 = phi_2716_;
                                if _e2128 {
                                    let _e2129 = (_e2126 == 0f);
                                    if _e2129 {
                                        phi_2804_ = array<f32, 3>();
                                        phi_2805_ = array<f32, 3>();
                                        phi_2806_ = false;
                                    } else {
                                        let _e2130 = (_e1923 * _e1795);
                                        let _e2131 = (_e1928 * _e1795);
                                        let _e2132 = (_e1933 * _e1795);
                                        let _e2135 = (1f / ((_e2014 + _e2053) + _e2092));
                                        let _e2136 = (_e2053 * _e2135);
                                        let _e2137 = (_e2092 * _e2135);
                                        let _e2143 = ((((_e2014 * _e2135) * _e2130) + (_e2136 * _e2131)) + (_e2137 * _e2132));
                                        let _e2144 = abs(_e1940);
                                        let _e2145 = abs(_e1954);
                                        let _e2147 = select(_e2145, _e2144, (_e2144 > _e2145));
                                        let _e2148 = abs(_e1968);
                                        let _e2151 = abs(_e1947);
                                        let _e2152 = abs(_e1961);
                                        let _e2154 = select(_e2152, _e2151, (_e2151 > _e2152));
                                        let _e2155 = abs(_e1975);
                                        let _e2159 = abs(_e2130);
                                        let _e2160 = abs(_e2131);
                                        let _e2162 = select(_e2160, _e2159, (_e2159 > _e2160));
                                        let _e2163 = abs(_e2132);
                                        let _e2170 = (((select(_e2148, _e2147, (_e2147 > _e2148)) * select(_e2155, _e2154, (_e2154 > _e2155))) * select(_e2163, _e2162, (_e2162 > _e2163))) <= (abs((_e2126 * _e2143)) * 256f));
                                        if _e2170 {
                                            phi_2802_ = array<f32, 3>(_e2143, _e2136, _e2137);
                                            phi_2803_ = array<f32, 3>();
                                        } else {
                                            let _e2172 = (_e1968 * 4097f);
                                            let _e2174 = (_e2172 - (_e2172 - _e1968));
                                            let _e2175 = (_e1961 * 4097f);
                                            let _e2177 = (_e2175 - (_e2175 - _e1961));
                                            let _e2178 = (_e1968 - _e2174);
                                            let _e2179 = (_e1961 - _e2177);
                                            let _e2188 = (_e1975 * 4097f);
                                            let _e2190 = (_e2188 - (_e2188 - _e1975));
                                            let _e2191 = (_e1954 * 4097f);
                                            let _e2193 = (_e2191 - (_e2191 - _e1954));
                                            let _e2194 = (_e1975 - _e2190);
                                            let _e2195 = (_e1954 - _e2193);
                                            let _e2205 = ((_e1976 - _e1977) + ((((((_e2174 * _e2177) - _e1976) + (_e2174 * _e2179)) + (_e2178 * _e2177)) + (_e2178 * _e2179)) - (((((_e2190 * _e2193) - _e1977) + (_e2190 * _e2195)) + (_e2194 * _e2193)) + (_e2194 * _e2195))));
                                            let _e2207 = (_e1940 * 4097f);
                                            let _e2209 = (_e2207 - (_e2207 - _e1940));
                                            let _e2210 = (_e1940 - _e2209);
                                            let _e2219 = (_e1947 * 4097f);
                                            let _e2221 = (_e2219 - (_e2219 - _e1947));
                                            let _e2222 = (_e1947 - _e2221);
                                            let _e2232 = ((_e2015 - _e2016) + ((((((_e2209 * _e2190) - _e2015) + (_e2209 * _e2194)) + (_e2210 * _e2190)) + (_e2210 * _e2194)) - (((((_e2221 * _e2174) - _e2016) + (_e2221 * _e2178)) + (_e2222 * _e2174)) + (_e2222 * _e2178))));
                                            let _e2251 = ((_e2054 - _e2055) + ((((((_e2193 * _e2221) - _e2054) + (_e2193 * _e2222)) + (_e2195 * _e2221)) + (_e2195 * _e2222)) - (((((_e2177 * _e2209) - _e2055) + (_e2177 * _e2210)) + (_e2179 * _e2209)) + (_e2179 * _e2210))));
                                            let _e2254 = (1f / ((_e2205 + _e2232) + _e2251));
                                            let _e2255 = (_e2232 * _e2254);
                                            let _e2256 = (_e2251 * _e2254);
                                            phi_2802_ = array<f32, 3>();
                                            phi_2803_ = array<f32, 3>(((((_e2205 * _e2254) * _e2130) + (_e2255 * _e2131)) + (_e2256 * _e2132)), _e2255, _e2256);
                                        }
                                        let _e2266 = phi_2802_;
                                        let _e2268 = phi_2803_;
                                        phi_2804_ = _e2266;
                                        phi_2805_ = _e2268;
                                        phi_2806_ = _e2170;
                                    }
                                    let _e2270 = phi_2804_;
                                    let _e2272 = phi_2805_;
                                    let _e2274 = phi_2806_;
                                    phi_2807_ = _e2270;
                                    phi_2808_ = _e2272;
                                    phi_2809_ = _e2129;
                                    phi_2810_ = _e2274;
                                } else {
                                    phi_2807_ = array<f32, 3>();
                                    phi_2808_ = array<f32, 3>();
                                    phi_2809_ = true;
                                    phi_2810_ = false;
                                }
                                let _e2276 = phi_2807_;
                                let _e2278 = phi_2808_;
                                let _e2280 = phi_2809_;
                                let _e2282 = phi_2810_;
                                if _e2280 {
                                    phi_2815_ = array<f32, 3>(-1f, 0f, 0f);
                                } else {
                                    phi_2815_ = _e2276;
                                }
                                let _e2284 = phi_2815_;
                                if select(_e2282, true, _e2280) {
                                    phi_2820_ = _e2284;
                                } else {
                                    phi_2820_ = _e2278;
                                }
                                let _e2287 = phi_2820_;
                                if (_e2287[0] >= _e1746.member.member_2) {
                                    let _e2295 = (_e2287[0] < _e1898.member);
                                    if _e2295 {
                                        let _e2296 = (_e2287[0] >= 0f);
                                        if _e2296 {
                                            if _e1918 {
                                            } else {
                                                phi_5254_ = true;
                                                break;
                                            }
                                            let _e2299 = triangles.member[_e1913.member_1].member_3;
                                            if ((_e2299 & 1u) == 0u) {
                                                phi_3154_ = true;
                                            } else {
                                                if _e1918 {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                let _e2304 = triangles.member[_e1913.member_1].member_1;
                                                let _e2305 = (_e2304 * 12u);
                                                if ((256u + _e2305) < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                if ((_e2305 + 257u) < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                if ((_e2305 + 258u) < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                let _e2312 = (_e2305 + 259u);
                                                if (_e2312 < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                let _e2315 = surfaces.member[_e2312];
                                                if ((_e2305 + 260u) < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                if ((_e2305 + 261u) < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                if ((_e2305 + 262u) < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                let _e2322 = (_e2305 + 263u);
                                                if (_e2322 < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                let _e2325 = surfaces.member[_e2322];
                                                let _e2326 = (_e2305 + 264u);
                                                if (_e2326 < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                let _e2329 = surfaces.member[_e2326];
                                                let _e2330 = bitcast<f32>(_e2329);
                                                let _e2331 = (_e2305 + 265u);
                                                if (_e2331 < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                let _e2334 = surfaces.member[_e2331];
                                                let _e2335 = bitcast<f32>(_e2334);
                                                if ((_e2305 + 266u) < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                if ((_e2305 + 267u) < _e140) {
                                                } else {
                                                    phi_5254_ = true;
                                                    break;
                                                }
                                                if (_e2315 == 4294967295u) {
                                                    phi_3149_ = (_e2330 < _e2335);
                                                } else {
                                                    if (_e1913.member_1 < _e137) {
                                                    } else {
                                                        phi_5254_ = true;
                                                        break;
                                                    }
                                                    let _e2343 = ((1f - _e2287[1]) - _e2287[2]);
                                                    let _e2347 = attributes.member[_e1913.member_1].member[0u];
                                                    let _e2352 = attributes.member[_e1913.member_1].member[2u];
                                                    let _e2358 = attributes.member[_e1913.member_1].member[4u];
                                                    let _e2360 = (((_e2347 * _e2343) + (_e2352 * _e2287[1])) + (_e2358 * _e2287[2]));
                                                    let _e2364 = attributes.member[_e1913.member_1].member[1u];
                                                    let _e2369 = attributes.member[_e1913.member_1].member[3u];
                                                    let _e2375 = attributes.member[_e1913.member_1].member[5u];
                                                    let _e2377 = (((_e2364 * _e2343) + (_e2369 * _e2287[1])) + (_e2375 * _e2287[2]));
                                                    let _e2378 = (_e2325 & 65535u);
                                                    let _e2380 = (_e2325 >> bitcast<u32>(16i));
                                                    let _e2382 = (_e2360 - floor(_e2360));
                                                    let _e2387 = ((select(0f, _e2382, (_e2382 <= 1f)) * f32(_e2378)) - 0.5f);
                                                    let _e2388 = floor(_e2387);
                                                    let _e2389 = (_e2387 - _e2388);
                                                    let _e2390 = (_e2378 - 1u);
                                                    if (_e2388 < 0f) {
                                                        phi_3032_ = _e2390;
                                                    } else {
                                                        let _e2396 = select(select(u32(_e2388), 0u, (_e2388 < 0f)), 4294967295u, (_e2388 > 4294967000f));
                                                        phi_3032_ = select(_e2396, _e2390, (_e2390 < _e2396));
                                                    }
                                                    let _e2400 = phi_3032_;
                                                    if (_e2400 == _e2390) {
                                                        phi_3038_ = 0u;
                                                    } else {
                                                        phi_3038_ = (_e2400 + 1u);
                                                    }
                                                    let _e2404 = phi_3038_;
                                                    let _e2406 = (_e2377 - floor(_e2377));
                                                    let _e2411 = ((select(0f, _e2406, (_e2406 <= 1f)) * f32(_e2380)) - 0.5f);
                                                    let _e2412 = floor(_e2411);
                                                    let _e2413 = (_e2411 - _e2412);
                                                    let _e2414 = (_e2380 - 1u);
                                                    if (_e2412 < 0f) {
                                                        phi_3068_ = _e2414;
                                                    } else {
                                                        let _e2420 = select(select(u32(_e2412), 0u, (_e2412 < 0f)), 4294967295u, (_e2412 > 4294967000f));
                                                        phi_3068_ = select(_e2420, _e2414, (_e2414 < _e2420));
                                                    }
                                                    let _e2424 = phi_3068_;
                                                    if (_e2424 == _e2414) {
                                                        phi_3074_ = 0u;
                                                    } else {
                                                        phi_3074_ = (_e2424 + 1u);
                                                    }
                                                    let _e2428 = phi_3074_;
                                                    let _e2430 = (_e2315 + (_e2424 * _e2378));
                                                    let _e2432 = (_e2315 + (_e2428 * _e2378));
                                                    let _e2433 = (_e2430 + _e2400);
                                                    let _e2434 = (_e2430 + _e2404);
                                                    let _e2435 = (_e2432 + _e2400);
                                                    let _e2436 = (_e2432 + _e2404);
                                                    if (_e2433 < _e140) {
                                                    } else {
                                                        phi_5254_ = true;
                                                        break;
                                                    }
                                                    let _e2439 = surfaces.member[_e2433];
                                                    if (_e2434 < _e140) {
                                                    } else {
                                                        phi_5254_ = true;
                                                        break;
                                                    }
                                                    let _e2442 = surfaces.member[_e2434];
                                                    if (_e2435 < _e140) {
                                                    } else {
                                                        phi_5254_ = true;
                                                        break;
                                                    }
                                                    let _e2445 = surfaces.member[_e2435];
                                                    if (_e2436 < _e140) {
                                                    } else {
                                                        phi_5254_ = true;
                                                        break;
                                                    }
                                                    let _e2448 = surfaces.member[_e2436];
                                                    let _e2465 = (1f - _e2389);
                                                    phi_3149_ = ((_e2330 * (((((f32((_e2439 >> bitcast<u32>(24i))) * 0.003921569f) * _e2465) + ((f32((_e2442 >> bitcast<u32>(24i))) * 0.003921569f) * _e2389)) * (1f - _e2413)) + ((((f32((_e2445 >> bitcast<u32>(24i))) * 0.003921569f) * _e2465) + ((f32((_e2448 >> bitcast<u32>(24i))) * 0.003921569f) * _e2389)) * _e2413))) < _e2335);
                                                }
                                                let _e2480 = phi_3149_;
                                                phi_3154_ = select(true, false, _e2480);
                                            }
                                            let _e2483 = phi_3154_;
                                            if _e2483 {
                                                phi_3159_ = type_64(_e2287[0], _e1913.member_1, _e2287[1], _e2287[2]);
                                            } else {
                                                phi_3159_ = type_64();
                                            }
                                            let _e2486 = phi_3159_;
                                            phi_3161_ = _e2486;
                                            phi_3163_ = select(true, false, _e2483);
                                        } else {
                                            phi_3161_ = type_64();
                                            phi_3163_ = false;
                                        }
                                        let _e2489 = phi_3161_;
                                        let _e2491 = phi_3163_;
                                        phi_3164_ = _e2489;
                                        phi_3166_ = select(true, false, _e2296);
                                        phi_3167_ = _e2491;
                                    } else {
                                        phi_3164_ = type_64();
                                        phi_3166_ = false;
                                        phi_3167_ = false;
                                    }
                                    let _e2494 = phi_3164_;
                                    let _e2496 = phi_3166_;
                                    let _e2498 = phi_3167_;
                                    phi_3168_ = _e2494;
                                    phi_3169_ = select(true, false, _e2295);
                                    phi_3170_ = _e2496;
                                    phi_3171_ = _e2498;
                                } else {
                                    phi_3168_ = type_64();
                                    phi_3169_ = true;
                                    phi_3170_ = false;
                                    phi_3171_ = false;
                                }
                                let _e2501 = phi_3168_;
                                let _e2503 = phi_3169_;
                                let _e2505 = phi_3170_;
                                let _e2507 = phi_3171_;
                                if select(select(_e2507, false, _e2503), true, select(_e2505, true, _e2503)) {
                                    phi_3184_ = _e1898;
                                } else {
                                    phi_3184_ = _e2501;
                                }
                                let _e2512 = phi_3184_;
                                phi_2508_ = _e2512;
                            } else {
                                phi_2508_ = type_64();
                            }
                            let _e2514 = phi_2508_;
                            continue;
                            continuing {
                                phi_2504_ = _e1911;
                                phi_2507_ = _e2514;
                                phi_5254_ = _e1882;
                                break if !(_e1917);
                            }
                        }
                        let _e2517 = phi_5254_;
                        phi_5467_ = _e2517;
                        phi_4437_ = type_64();
                        if _e2517 {
                            break;
                        }
                        phi_5403_ = _e2517;
                        phi_3185_ = 0u;
                        phi_3186_ = _e1886;
                        let _e3742 = local_14;
                        phi_2012_ = _e3742;
                    }
                    let _e2801 = phi_5403_;
                    let _e2803 = phi_3185_;
                    let _e2805 = phi_3186_;
                    let _e2807 = phi_2012_;
                    phi_2007_ = _e2803;
                    phi_2010_ = _e2805;
                    loop {
                        let _e2809 = phi_2007_;
                        let _e2811 = phi_2010_;
                        local_12 = _e2809;
                        local_13 = _e2811;
                        let _e2812 = (_e2809 == 0u);
                        local_11 = _e2812;
                        if _e2812 {
                            let _e2813 = (_e2811 > 0u);
                            if _e2813 {
                                let _e2814 = (_e2811 - 1u);
                                let _e2815 = (_e2814 < 64u);
                                if _e2815 {
                                } else {
                                    phi_5400_ = true;
                                    break;
                                }
                                let _e2817 = local_1[_e2814];
                                if (_e2817 <= _e2807.member) {
                                    if _e2815 {
                                    } else {
                                        phi_5400_ = true;
                                        break;
                                    }
                                    let _e2821 = local[_e2814];
                                    phi_3221_ = _e2821;
                                } else {
                                    phi_3221_ = _e2809;
                                }
                                let _e2823 = phi_3221_;
                                phi_3222_ = _e2823;
                                phi_3223_ = _e2814;
                            } else {
                                phi_3222_ = u32();
                                phi_3223_ = u32();
                            }
                            let _e2825 = phi_3222_;
                            let _e2827 = phi_3223_;
                            phi_3188_ = _e2825;
                            phi_3190_ = _e2827;
                            phi_3224_ = _e2813;
                        } else {
                            phi_3188_ = u32();
                            phi_3190_ = u32();
                            phi_3224_ = false;
                        }
                        let _e2829 = phi_3188_;
                        let _e2831 = phi_3190_;
                        let _e2833 = phi_3224_;
                        continue;
                        continuing {
                            phi_2007_ = _e2829;
                            phi_2010_ = _e2831;
                            phi_5400_ = _e2801;
                            break if !(_e2833);
                        }
                    }
                    let _e2836 = phi_5400_;
                    phi_5467_ = _e2836;
                    phi_4437_ = type_64();
                    if _e2836 {
                        break;
                    }
                    let _e2838 = local_11;
                    continue;
                    continuing {
                        phi_5258_ = _e2836;
                        let _e3675 = local_12;
                        phi_2006_ = _e3675;
                        let _e3678 = local_13;
                        phi_2009_ = _e3678;
                        phi_2011_ = _e2807;
                        phi_5467_ = _e2836;
                        phi_4437_ = _e2807;
                        break if !(select(true, false, _e2838));
                    }
                }
                let _e2842 = phi_5467_;
                let _e2844 = phi_4437_;
                if _e2842 {
                    break;
                }
                let _e2846 = (_e2844.member_1 != 4294967295u);
                if _e2846 {
                    if _e2846 {
                        if (_e2844.member_1 < _e134) {
                        } else {
                            break;
                        }
                        let _e2850 = triangles.member[_e2844.member_1].member;
                        let _e2856 = triangles.member[_e2844.member_1].member_2;
                        let _e2862 = triangles.member[_e2844.member_1].member_4;
                        let _e2866 = (_e2856[0] - _e2850[0]);
                        let _e2867 = (_e2856[1] - _e2850[1]);
                        let _e2868 = (_e2856[2] - _e2850[2]);
                        let _e2869 = (_e2862[0] - _e2850[0]);
                        let _e2870 = (_e2862[1] - _e2850[1]);
                        let _e2871 = (_e2862[2] - _e2850[2]);
                        let _e2888 = ((_e2867 * _e2871) - (_e2870 * _e2868));
                        let _e2891 = ((_e2868 * _e2869) - (_e2871 * _e2866));
                        let _e2894 = ((_e2866 * _e2870) - (_e2869 * _e2867));
                        let _e2895 = abs(_e2888);
                        let _e2896 = abs(_e2891);
                        let _e2898 = select(_e2896, _e2895, (_e2895 > _e2896));
                        let _e2899 = abs(_e2894);
                        let _e2901 = select(_e2899, _e2898, (_e2898 > _e2899));
                        if (_e2901 > 0.000000000000000000000000000000000000011754944f) {
                            let _e2903 = (_e2901 < 340282350000000000000000000000000000000f);
                            if _e2903 {
                                let _e2904 = (_e2888 / _e2901);
                                let _e2905 = (_e2891 / _e2901);
                                let _e2906 = (_e2894 / _e2901);
                                let _e2912 = sqrt((((_e2904 * _e2904) + (_e2905 * _e2905)) + (_e2906 * _e2906)));
                                phi_3331_ = vec3<f32>((_e2904 / _e2912), (_e2905 / _e2912), (_e2906 / _e2912));
                            } else {
                                phi_3331_ = vec3<f32>();
                            }
                            let _e2918 = phi_3331_;
                            phi_3333_ = _e2918;
                            phi_3334_ = select(true, false, _e2903);
                        } else {
                            phi_3333_ = vec3<f32>();
                            phi_3334_ = true;
                        }
                        let _e2921 = phi_3333_;
                        let _e2923 = phi_3334_;
                        let _e2925 = select(_e2921, vec3<f32>(0f, 1f, 0f), vec3(_e2923));
                        let _e2939 = ((((_e2925.x * _e1746.member.member_1.x) + (_e2925.y * _e1746.member.member_1.y)) + (_e2925.z * _e1746.member.member_1.z)) < 0f);
                        if _e2939 {
                            phi_3356_ = _e2925;
                        } else {
                            phi_3356_ = -(_e2925);
                        }
                        let _e2942 = phi_3356_;
                        if (_e2844.member_1 < _e137) {
                        } else {
                            break;
                        }
                        let _e2946 = triangles.member[_e2844.member_1].member_1;
                        let _e2947 = (_e2946 * 12u);
                        let _e2948 = (256u + _e2947);
                        if (_e2948 < _e140) {
                        } else {
                            break;
                        }
                        let _e2951 = surfaces.member[_e2948];
                        let _e2952 = bitcast<f32>(_e2951);
                        let _e2953 = (_e2947 + 257u);
                        if (_e2953 < _e140) {
                        } else {
                            break;
                        }
                        let _e2956 = surfaces.member[_e2953];
                        let _e2957 = bitcast<f32>(_e2956);
                        let _e2958 = (_e2947 + 258u);
                        if (_e2958 < _e140) {
                        } else {
                            break;
                        }
                        let _e2961 = surfaces.member[_e2958];
                        let _e2962 = bitcast<f32>(_e2961);
                        let _e2963 = (_e2947 + 259u);
                        if (_e2963 < _e140) {
                        } else {
                            break;
                        }
                        let _e2966 = surfaces.member[_e2963];
                        let _e2967 = (_e2947 + 260u);
                        if (_e2967 < _e140) {
                        } else {
                            break;
                        }
                        let _e2970 = surfaces.member[_e2967];
                        let _e2972 = (_e2947 + 261u);
                        if (_e2972 < _e140) {
                        } else {
                            break;
                        }
                        let _e2975 = surfaces.member[_e2972];
                        let _e2977 = (_e2947 + 262u);
                        if (_e2977 < _e140) {
                        } else {
                            break;
                        }
                        let _e2980 = surfaces.member[_e2977];
                        let _e2983 = (_e2947 + 263u);
                        if (_e2983 < _e140) {
                        } else {
                            break;
                        }
                        let _e2986 = surfaces.member[_e2983];
                        let _e2987 = (_e2947 + 264u);
                        if (_e2987 < _e140) {
                        } else {
                            break;
                        }
                        let _e2990 = surfaces.member[_e2987];
                        let _e2991 = bitcast<f32>(_e2990);
                        if ((_e2947 + 265u) < _e140) {
                        } else {
                            break;
                        }
                        if ((_e2947 + 266u) < _e140) {
                        } else {
                            break;
                        }
                        if ((_e2947 + 267u) < _e140) {
                        } else {
                            break;
                        }
                        let _e2999 = ((1f - _e2844.member_2) - _e2844.member_3);
                        let _e3003 = attributes.member[_e2844.member_1].member[0u];
                        let _e3008 = attributes.member[_e2844.member_1].member[2u];
                        let _e3014 = attributes.member[_e2844.member_1].member[4u];
                        let _e3016 = (((_e3003 * _e2999) + (_e3008 * _e2844.member_2)) + (_e3014 * _e2844.member_3));
                        let _e3020 = attributes.member[_e2844.member_1].member[1u];
                        let _e3025 = attributes.member[_e2844.member_1].member[3u];
                        let _e3031 = attributes.member[_e2844.member_1].member[5u];
                        let _e3033 = (((_e3020 * _e2999) + (_e3025 * _e2844.member_2)) + (_e3031 * _e2844.member_3));
                        if (_e2966 == 4294967295u) {
                            phi_3799_ = type_67(vec3<f32>(_e2952, _e2957, _e2962), _e2991);
                        } else {
                            let _e3036 = (_e2986 & 65535u);
                            let _e3038 = (_e2986 >> bitcast<u32>(16i));
                            let _e3040 = (_e3016 - floor(_e3016));
                            let _e3045 = ((select(0f, _e3040, (_e3040 <= 1f)) * f32(_e3036)) - 0.5f);
                            let _e3046 = floor(_e3045);
                            let _e3047 = (_e3045 - _e3046);
                            let _e3048 = (_e3036 - 1u);
                            if (_e3046 < 0f) {
                                phi_3540_ = _e3048;
                            } else {
                                let _e3054 = select(select(u32(_e3046), 0u, (_e3046 < 0f)), 4294967295u, (_e3046 > 4294967000f));
                                phi_3540_ = select(_e3054, _e3048, (_e3048 < _e3054));
                            }
                            let _e3058 = phi_3540_;
                            if (_e3058 == _e3048) {
                                phi_3546_ = 0u;
                            } else {
                                phi_3546_ = (_e3058 + 1u);
                            }
                            let _e3062 = phi_3546_;
                            let _e3064 = (_e3033 - floor(_e3033));
                            let _e3069 = ((select(0f, _e3064, (_e3064 <= 1f)) * f32(_e3038)) - 0.5f);
                            let _e3070 = floor(_e3069);
                            let _e3071 = (_e3069 - _e3070);
                            let _e3072 = (_e3038 - 1u);
                            if (_e3070 < 0f) {
                                phi_3576_ = _e3072;
                            } else {
                                let _e3078 = select(select(u32(_e3070), 0u, (_e3070 < 0f)), 4294967295u, (_e3070 > 4294967000f));
                                phi_3576_ = select(_e3078, _e3072, (_e3072 < _e3078));
                            }
                            let _e3082 = phi_3576_;
                            if (_e3082 == _e3072) {
                                phi_3582_ = 0u;
                            } else {
                                phi_3582_ = (_e3082 + 1u);
                            }
                            let _e3086 = phi_3582_;
                            let _e3088 = (_e2966 + (_e3082 * _e3036));
                            let _e3090 = (_e2966 + (_e3086 * _e3036));
                            let _e3091 = (_e3088 + _e3058);
                            let _e3092 = (_e3088 + _e3062);
                            let _e3093 = (_e3090 + _e3058);
                            let _e3094 = (_e3090 + _e3062);
                            if (_e3091 < _e140) {
                            } else {
                                break;
                            }
                            let _e3097 = surfaces.member[_e3091];
                            if (_e3092 < _e140) {
                            } else {
                                break;
                            }
                            let _e3100 = surfaces.member[_e3092];
                            if (_e3093 < _e140) {
                            } else {
                                break;
                            }
                            let _e3103 = surfaces.member[_e3093];
                            if (_e3094 < _e140) {
                            } else {
                                break;
                            }
                            let _e3106 = surfaces.member[_e3094];
                            let _e3107 = (_e3097 & 255u);
                            if (_e3107 < _e140) {
                            } else {
                                break;
                            }
                            let _e3110 = surfaces.member[_e3107];
                            let _e3114 = ((_e3097 >> bitcast<u32>(8i)) & 255u);
                            if (_e3114 < _e140) {
                            } else {
                                break;
                            }
                            let _e3117 = surfaces.member[_e3114];
                            let _e3121 = ((_e3097 >> bitcast<u32>(16i)) & 255u);
                            if (_e3121 < _e140) {
                            } else {
                                break;
                            }
                            let _e3124 = surfaces.member[_e3121];
                            let _e3126 = (1f - _e3047);
                            let _e3130 = (_e3100 & 255u);
                            if (_e3130 < _e140) {
                            } else {
                                break;
                            }
                            let _e3133 = surfaces.member[_e3130];
                            let _e3137 = ((_e3100 >> bitcast<u32>(8i)) & 255u);
                            if (_e3137 < _e140) {
                            } else {
                                break;
                            }
                            let _e3140 = surfaces.member[_e3137];
                            let _e3144 = ((_e3100 >> bitcast<u32>(16i)) & 255u);
                            if (_e3144 < _e140) {
                            } else {
                                break;
                            }
                            let _e3147 = surfaces.member[_e3144];
                            let _e3155 = (_e3103 & 255u);
                            if (_e3155 < _e140) {
                            } else {
                                break;
                            }
                            let _e3158 = surfaces.member[_e3155];
                            let _e3162 = ((_e3103 >> bitcast<u32>(8i)) & 255u);
                            if (_e3162 < _e140) {
                            } else {
                                break;
                            }
                            let _e3165 = surfaces.member[_e3162];
                            let _e3169 = ((_e3103 >> bitcast<u32>(16i)) & 255u);
                            if (_e3169 < _e140) {
                            } else {
                                break;
                            }
                            let _e3172 = surfaces.member[_e3169];
                            let _e3177 = (_e3106 & 255u);
                            if (_e3177 < _e140) {
                            } else {
                                break;
                            }
                            let _e3180 = surfaces.member[_e3177];
                            let _e3184 = ((_e3106 >> bitcast<u32>(8i)) & 255u);
                            if (_e3184 < _e140) {
                            } else {
                                break;
                            }
                            let _e3187 = surfaces.member[_e3184];
                            let _e3191 = ((_e3106 >> bitcast<u32>(16i)) & 255u);
                            if (_e3191 < _e140) {
                            } else {
                                break;
                            }
                            let _e3194 = surfaces.member[_e3191];
                            let _e3202 = (1f - _e3071);
                            phi_3799_ = type_67(vec3<f32>((_e2952 * ((((bitcast<f32>(_e3110) * _e3126) + (bitcast<f32>(_e3133) * _e3047)) * _e3202) + (((bitcast<f32>(_e3158) * _e3126) + (bitcast<f32>(_e3180) * _e3047)) * _e3071))), (_e2957 * ((((bitcast<f32>(_e3117) * _e3126) + (bitcast<f32>(_e3140) * _e3047)) * _e3202) + (((bitcast<f32>(_e3165) * _e3126) + (bitcast<f32>(_e3187) * _e3047)) * _e3071))), (_e2962 * ((((bitcast<f32>(_e3124) * _e3126) + (bitcast<f32>(_e3147) * _e3047)) * _e3202) + (((bitcast<f32>(_e3172) * _e3126) + (bitcast<f32>(_e3194) * _e3047)) * _e3071)))), (_e2991 * (((((f32((_e3097 >> bitcast<u32>(24i))) * 0.003921569f) * _e3126) + ((f32((_e3100 >> bitcast<u32>(24i))) * 0.003921569f) * _e3047)) * _e3202) + ((((f32((_e3103 >> bitcast<u32>(24i))) * 0.003921569f) * _e3126) + ((f32((_e3106 >> bitcast<u32>(24i))) * 0.003921569f) * _e3047)) * _e3071))));
                        }
                        let _e3245 = phi_3799_;
                        let _e3250 = attributes.member[_e2844.member_1].member_1[0u];
                        let _e3260 = (f32((bitcast<i32>((_e3250 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3262 = select(-1f, _e3260, (_e3260 > -1f));
                        let _e3264 = (f32((bitcast<i32>(_e3250) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3266 = select(-1f, _e3264, (_e3264 > -1f));
                        let _e3270 = ((1f - abs(_e3262)) - abs(_e3266));
                        let _e3271 = -(_e3270);
                        let _e3275 = (bitcast<u32>(select(0f, _e3271, (_e3271 > 0f))) & 2147483647u);
                        let _e3280 = (_e3262 - bitcast<f32>((_e3275 | (bitcast<u32>(_e3262) & 2147483648u))));
                        let _e3285 = (_e3266 - bitcast<f32>((_e3275 | (bitcast<u32>(_e3266) & 2147483648u))));
                        let _e3290 = (((_e3280 * _e3280) + (_e3285 * _e3285)) + (_e3270 * _e3270));
                        if (_e3290 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e3293 = (1f / sqrt(_e3290));
                            phi_3866_ = vec3<f32>((_e3280 * _e3293), (_e3285 * _e3293), (_e3270 * _e3293));
                        } else {
                            phi_3866_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e3299 = phi_3866_;
                        let _e3309 = attributes.member[_e2844.member_1].member_1[1u];
                        let _e3319 = (f32((bitcast<i32>((_e3309 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3321 = select(-1f, _e3319, (_e3319 > -1f));
                        let _e3323 = (f32((bitcast<i32>(_e3309) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3325 = select(-1f, _e3323, (_e3323 > -1f));
                        let _e3329 = ((1f - abs(_e3321)) - abs(_e3325));
                        let _e3330 = -(_e3329);
                        let _e3334 = (bitcast<u32>(select(0f, _e3330, (_e3330 > 0f))) & 2147483647u);
                        let _e3339 = (_e3321 - bitcast<f32>((_e3334 | (bitcast<u32>(_e3321) & 2147483648u))));
                        let _e3344 = (_e3325 - bitcast<f32>((_e3334 | (bitcast<u32>(_e3325) & 2147483648u))));
                        let _e3349 = (((_e3339 * _e3339) + (_e3344 * _e3344)) + (_e3329 * _e3329));
                        if (_e3349 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e3352 = (1f / sqrt(_e3349));
                            phi_3940_ = vec3<f32>((_e3339 * _e3352), (_e3344 * _e3352), (_e3329 * _e3352));
                        } else {
                            phi_3940_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e3358 = phi_3940_;
                        let _e3371 = attributes.member[_e2844.member_1].member_1[2u];
                        let _e3381 = (f32((bitcast<i32>((_e3371 << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3383 = select(-1f, _e3381, (_e3381 > -1f));
                        let _e3385 = (f32((bitcast<i32>(_e3371) >> bitcast<u32>(16i))) * 0.00003051851f);
                        let _e3387 = select(-1f, _e3385, (_e3385 > -1f));
                        let _e3391 = ((1f - abs(_e3383)) - abs(_e3387));
                        let _e3392 = -(_e3391);
                        let _e3396 = (bitcast<u32>(select(0f, _e3392, (_e3392 > 0f))) & 2147483647u);
                        let _e3401 = (_e3383 - bitcast<f32>((_e3396 | (bitcast<u32>(_e3383) & 2147483648u))));
                        let _e3406 = (_e3387 - bitcast<f32>((_e3396 | (bitcast<u32>(_e3387) & 2147483648u))));
                        let _e3411 = (((_e3401 * _e3401) + (_e3406 * _e3406)) + (_e3391 * _e3391));
                        if (_e3411 >= 0.000000000000000000000000000000000000011754944f) {
                            let _e3414 = (1f / sqrt(_e3411));
                            phi_4014_ = vec3<f32>((_e3401 * _e3414), (_e3406 * _e3414), (_e3391 * _e3414));
                        } else {
                            phi_4014_ = vec3<f32>(0f, 0f, 0f);
                        }
                        let _e3420 = phi_4014_;
                        let _e3427 = (((_e3299.x * _e2999) + (_e3358.x * _e2844.member_2)) + (_e3420.x * _e2844.member_3));
                        let _e3428 = (((_e3299.y * _e2999) + (_e3358.y * _e2844.member_2)) + (_e3420.y * _e2844.member_3));
                        let _e3429 = (((_e3299.z * _e2999) + (_e3358.z * _e2844.member_2)) + (_e3420.z * _e2844.member_3));
                        let _e3430 = abs(_e3427);
                        let _e3431 = abs(_e3428);
                        let _e3433 = select(_e3431, _e3430, (_e3430 > _e3431));
                        let _e3434 = abs(_e3429);
                        let _e3436 = select(_e3434, _e3433, (_e3433 > _e3434));
                        if (_e3436 > 0.000000000000000000000000000000000000011754944f) {
                            let _e3438 = (_e3436 < 340282350000000000000000000000000000000f);
                            if _e3438 {
                                let _e3439 = (_e3427 / _e3436);
                                let _e3440 = (_e3428 / _e3436);
                                let _e3441 = (_e3429 / _e3436);
                                let _e3447 = sqrt((((_e3439 * _e3439) + (_e3440 * _e3440)) + (_e3441 * _e3441)));
                                phi_4059_ = vec3<f32>((_e3439 / _e3447), (_e3440 / _e3447), (_e3441 / _e3447));
                            } else {
                                phi_4059_ = vec3<f32>();
                            }
                            let _e3453 = phi_4059_;
                            phi_4061_ = _e3453;
                            phi_4062_ = select(true, false, _e3438);
                        } else {
                            phi_4061_ = vec3<f32>();
                            phi_4062_ = true;
                        }
                        let _e3456 = phi_4061_;
                        let _e3458 = phi_4062_;
                        let _e3460 = select(_e3456, _e2942, vec3(_e3458));
                        if ((((_e3460.x * _e1746.member.member_1.x) + (_e3460.y * _e1746.member.member_1.y)) + (_e3460.z * _e1746.member.member_1.z)) > 0f) {
                            phi_4083_ = -(_e3460);
                        } else {
                            phi_4083_ = _e3460;
                        }
                        let _e3472 = phi_4083_;
                        if _e2939 {
                            phi_4117_ = array<f32, 3>(bitcast<f32>(_e2970), bitcast<f32>(_e2975), bitcast<f32>(_e2980));
                        } else {
                            phi_4117_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e3498 = phi_4117_;
                        let _e3499 = abs(_e2850[0]);
                        let _e3500 = abs(_e2850[1]);
                        let _e3502 = select(_e3500, _e3499, (_e3499 > _e3500));
                        let _e3503 = abs(_e2850[2]);
                        let _e3507 = abs(_e2866);
                        let _e3508 = abs(_e2867);
                        let _e3510 = select(_e3508, _e3507, (_e3507 > _e3508));
                        let _e3511 = abs(_e2868);
                        let _e3514 = abs(_e2869);
                        let _e3515 = abs(_e2870);
                        let _e3517 = select(_e3515, _e3514, (_e3514 > _e3515));
                        let _e3518 = abs(_e2871);
                        phi_4163_ = type_68(array<f32, 3>(((_e2850[0] + (_e2866 * _e2844.member_2)) + (_e2869 * _e2844.member_3)), ((_e2850[1] + (_e2867 * _e2844.member_2)) + (_e2870 * _e2844.member_3)), ((_e2850[2] + (_e2868 * _e2844.member_2)) + (_e2871 * _e2844.member_3))), _e2844.member_1, array<f32, 3>(_e3472.x, _e3472.y, _e3472.z), (_e2844.member * sqrt((((_e1746.member.member_1.x * _e1746.member.member_1.x) + (_e1746.member.member_1.y * _e1746.member.member_1.y)) + (_e1746.member.member_1.z * _e1746.member.member_1.z)))), array<f32, 3>(_e2942.x, _e2942.y, _e2942.z), select(0u, 1u, _e2939), array<f32, 3>(_e3245.member.x, _e3245.member.y, _e3245.member.z), _e2946, _e3498, ((select(_e3503, _e3502, (_e3502 > _e3503)) * 0.00000047683716f) + ((select(_e3511, _e3510, (_e3510 > _e3511)) + select(_e3518, _e3517, (_e3517 > _e3518))) * 0.0000010728836f)));
                    } else {
                        phi_4163_ = type_68(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0f);
                    }
                    let _e3526 = phi_4163_;
                    phi_4165_ = _e3526;
                } else {
                    phi_4165_ = type_68(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0u, array<f32, 3>(0f, 0f, 0f), 0f);
                }
                let _e3528 = phi_4165_;
                if _e2846 {
                    let _e3540 = select(_e1746.member_1.z, _e1746.member_1.y, (_e1746.member_1.y > _e1746.member_1.z));
                    phi_4189_ = (select(_e3540, _e1746.member_1.x, (_e1746.member_1.x > _e3540)) > 0.000000000000000000000000000001f);
                } else {
                    phi_4189_ = false;
                }
                let _e3545 = phi_4189_;
                let _e3556 = -((((_e3528.member_4[0] * _e1746.member.member_1.x) + (_e3528.member_4[1] * _e1746.member.member_1.y)) + (_e3528.member_4[2] * _e1746.member.member_1.z)));
                if _e3545 {
                    phi_4217_ = ((_e1746.member_2 + ((_e1746.member_3 * _e3528.member_3) * _e3528.member_3)) / select(0.05f, _e3556, (_e3556 > 0.05f)));
                } else {
                    phi_4217_ = 0f;
                }
                let _e3568 = phi_4217_;
                if _e3545 {
                    phi_4227_ = array<f32, 3>(_e1746.member_1.x, _e1746.member_1.y, _e1746.member_1.z);
                } else {
                    phi_4227_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e3578 = phi_4227_;
                if _e3545 {
                    phi_4232_ = _e3528.member_6;
                } else {
                    phi_4232_ = array<f32, 3>(0f, 0f, 0f);
                }
                let _e3581 = phi_4232_;
                let _e3584 = (_e158 + (_e156 - _e156));
                if (_e3584 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e3584] = type_43(_e3528.member, _e3568, _e3528.member_4, select(0u, 1u, _e3545), _e3578, 0u, _e3581, 0u);
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
