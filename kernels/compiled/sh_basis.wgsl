struct type_5 {
    member: array<f32>,
}

struct type_10 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_13 {
    member: type_12,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_13;
@group(0) @binding(1) 
var<storage> directions: type_5;
@group(0) @binding(2) 
var<storage, read_write> table: type_5;

fn function_() {
    var phi_103_: u32;
    var phi_207_: u32;
    var phi_505_: f32;
    var phi_569_: u32;
    var phi_867_: f32;
    var phi_931_: u32;
    var phi_1229_: f32;
    var phi_1293_: u32;
    var phi_1591_: f32;
    var phi_1604_: f32;
    var phi_1611_: type_10;
    var phi_1614_: f32;
    var phi_1616_: f32;
    var phi_1612_: type_10;
    var phi_1638_: type_10;
    var phi_1615_: f32;
    var phi_1653_: type_10;
    var phi_1656_: f32;
    var phi_1658_: f32;
    var phi_1660_: f32;
    var phi_1662_: f32;
    var phi_1654_: type_10;
    var phi_1684_: type_10;
    var phi_1657_: f32;
    var phi_1659_: f32;
    var phi_1661_: f32;
    var local: f32;
    var phi_1711_: f32;
    var phi_1718_: type_10;
    var phi_1721_: f32;
    var phi_1723_: f32;
    var phi_1719_: type_10;
    var phi_1745_: type_10;
    var phi_1722_: f32;
    var phi_1760_: type_10;
    var phi_1763_: f32;
    var phi_1765_: f32;
    var phi_1767_: f32;
    var phi_1769_: f32;
    var phi_1761_: type_10;
    var phi_1791_: type_10;
    var phi_1764_: f32;
    var phi_1766_: f32;
    var phi_1768_: f32;
    var local_1: f32;
    var phi_1818_: f32;
    var phi_1825_: type_10;
    var phi_1828_: f32;
    var phi_1830_: f32;
    var phi_1826_: type_10;
    var phi_1852_: type_10;
    var phi_1829_: f32;
    var phi_1867_: type_10;
    var phi_1870_: f32;
    var phi_1872_: f32;
    var phi_1874_: f32;
    var phi_1876_: f32;
    var phi_1868_: type_10;
    var phi_1898_: type_10;
    var phi_1871_: f32;
    var phi_1873_: f32;
    var phi_1875_: f32;
    var local_2: f32;
    var phi_1925_: f32;
    var phi_1932_: type_10;
    var phi_1935_: f32;
    var phi_1937_: f32;
    var phi_1933_: type_10;
    var phi_1959_: type_10;
    var phi_1936_: f32;
    var phi_1974_: type_10;
    var phi_1977_: f32;
    var phi_1979_: f32;
    var phi_1981_: f32;
    var phi_1983_: f32;
    var phi_1975_: type_10;
    var phi_2005_: type_10;
    var phi_1978_: f32;
    var phi_1980_: f32;
    var phi_1982_: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: f32;
    var local_6: f32;
    var local_7: f32;
    var local_8: f32;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e54 = gid_1;
            let _e57 = params.member.member_2;
            let _e60 = (select(_e57, 9u, (_e57 > 9u)) + 1u);
            let _e61 = (_e60 * _e60);
            let _e62 = (_e61 / 4u);
            if ((_e61 % 4u) > 0u) {
                phi_103_ = (_e62 + 1u);
            } else {
                phi_103_ = _e62;
            }
            let _e67 = phi_103_;
            let _e70 = params.member.member_1;
            let _e71 = (_e67 * _e70);
            let _e75 = (_e54.x + (_e54.y * 2097152u));
            if (_e75 < _e71) {
                if (_e70 == 0u) {
                    break;
                }
                let _e78 = (_e75 / _e70);
                let _e80 = (_e75 - (_e78 * _e70));
                let _e83 = directions.member[_e80];
                let _e87 = directions.member[(_e70 + _e80)];
                let _e92 = directions.member[((2u * _e70) + _e80)];
                let _e97 = directions.member[((3u * _e70) + _e80)];
                let _e98 = (_e78 * 4u);
                let _e124 = ((((((((select(0u, 1u, (_e98 >= 1u)) + select(0u, 1u, (_e98 >= 4u))) + select(0u, 1u, (_e98 >= 9u))) + select(0u, 1u, (_e98 >= 16u))) + select(0u, 1u, (_e98 >= 25u))) + select(0u, 1u, (_e98 >= 36u))) + select(0u, 1u, (_e98 >= 49u))) + select(0u, 1u, (_e98 >= 64u))) + select(0u, 1u, (_e98 >= 81u)));
                let _e126 = (_e124 * (_e124 + 1u));
                let _e127 = (_e98 < _e126);
                if _e127 {
                    phi_207_ = (_e126 - _e98);
                } else {
                    phi_207_ = (_e98 - _e126);
                }
                let _e131 = phi_207_;
                if (_e124 <= _e57) {
                    let _e137 = (_e124 - _e131);
                    let _e179 = (((((((select(1f, 3f, (2u <= _e131)) * select(1f, 5f, (3u <= _e131))) * select(1f, 7f, (4u <= _e131))) * select(1f, 9f, (5u <= _e131))) * select(1f, 11f, (6u <= _e131))) * select(1f, 13f, (7u <= _e131))) * select(1f, 15f, (8u <= _e131))) * select(1f, 17f, (9u <= _e131)));
                    let _e183 = (_e124 + _e131);
                    phi_505_ = sqrt((((f32(((2u * _e124) + 1u)) * _e179) * _e179) / (((((((((((((((((((((((((select(6.2831855f, 12.566371f, (_e131 == 0u)) * select(1f, 2f, (2u <= _e137))) * select(1f, 3f, (3u <= _e137))) * select(1f, 4f, (4u <= _e137))) * select(1f, 5f, (5u <= _e137))) * select(1f, 6f, (6u <= _e137))) * select(1f, 7f, (7u <= _e137))) * select(1f, 8f, (8u <= _e137))) * select(1f, 9f, (9u <= _e137))) * select(1f, 2f, (2u <= _e183))) * select(1f, 3f, (3u <= _e183))) * select(1f, 4f, (4u <= _e183))) * select(1f, 5f, (5u <= _e183))) * select(1f, 6f, (6u <= _e183))) * select(1f, 7f, (7u <= _e183))) * select(1f, 8f, (8u <= _e183))) * select(1f, 9f, (9u <= _e183))) * select(1f, 10f, (10u <= _e183))) * select(1f, 11f, (11u <= _e183))) * select(1f, 12f, (12u <= _e183))) * select(1f, 13f, (13u <= _e183))) * select(1f, 14f, (14u <= _e183))) * select(1f, 15f, (15u <= _e183))) * select(1f, 16f, (16u <= _e183))) * select(1f, 17f, (17u <= _e183))) * select(1f, 18f, (18u <= _e183)))));
                } else {
                    phi_505_ = 0f;
                }
                let _e243 = phi_505_;
                let _e244 = (_e98 + 1u);
                let _e270 = ((((((((select(0u, 1u, (_e244 >= 1u)) + select(0u, 1u, (_e244 >= 4u))) + select(0u, 1u, (_e244 >= 9u))) + select(0u, 1u, (_e244 >= 16u))) + select(0u, 1u, (_e244 >= 25u))) + select(0u, 1u, (_e244 >= 36u))) + select(0u, 1u, (_e244 >= 49u))) + select(0u, 1u, (_e244 >= 64u))) + select(0u, 1u, (_e244 >= 81u)));
                let _e272 = (_e270 * (_e270 + 1u));
                let _e273 = (_e244 < _e272);
                if _e273 {
                    phi_569_ = (_e272 - _e244);
                } else {
                    phi_569_ = (_e244 - _e272);
                }
                let _e277 = phi_569_;
                if (_e270 <= _e57) {
                    let _e283 = (_e270 - _e277);
                    let _e325 = (((((((select(1f, 3f, (2u <= _e277)) * select(1f, 5f, (3u <= _e277))) * select(1f, 7f, (4u <= _e277))) * select(1f, 9f, (5u <= _e277))) * select(1f, 11f, (6u <= _e277))) * select(1f, 13f, (7u <= _e277))) * select(1f, 15f, (8u <= _e277))) * select(1f, 17f, (9u <= _e277)));
                    let _e329 = (_e270 + _e277);
                    phi_867_ = sqrt((((f32(((2u * _e270) + 1u)) * _e325) * _e325) / (((((((((((((((((((((((((select(6.2831855f, 12.566371f, (_e277 == 0u)) * select(1f, 2f, (2u <= _e283))) * select(1f, 3f, (3u <= _e283))) * select(1f, 4f, (4u <= _e283))) * select(1f, 5f, (5u <= _e283))) * select(1f, 6f, (6u <= _e283))) * select(1f, 7f, (7u <= _e283))) * select(1f, 8f, (8u <= _e283))) * select(1f, 9f, (9u <= _e283))) * select(1f, 2f, (2u <= _e329))) * select(1f, 3f, (3u <= _e329))) * select(1f, 4f, (4u <= _e329))) * select(1f, 5f, (5u <= _e329))) * select(1f, 6f, (6u <= _e329))) * select(1f, 7f, (7u <= _e329))) * select(1f, 8f, (8u <= _e329))) * select(1f, 9f, (9u <= _e329))) * select(1f, 10f, (10u <= _e329))) * select(1f, 11f, (11u <= _e329))) * select(1f, 12f, (12u <= _e329))) * select(1f, 13f, (13u <= _e329))) * select(1f, 14f, (14u <= _e329))) * select(1f, 15f, (15u <= _e329))) * select(1f, 16f, (16u <= _e329))) * select(1f, 17f, (17u <= _e329))) * select(1f, 18f, (18u <= _e329)))));
                } else {
                    phi_867_ = 0f;
                }
                let _e389 = phi_867_;
                let _e390 = (_e98 + 2u);
                let _e416 = ((((((((select(0u, 1u, (_e390 >= 1u)) + select(0u, 1u, (_e390 >= 4u))) + select(0u, 1u, (_e390 >= 9u))) + select(0u, 1u, (_e390 >= 16u))) + select(0u, 1u, (_e390 >= 25u))) + select(0u, 1u, (_e390 >= 36u))) + select(0u, 1u, (_e390 >= 49u))) + select(0u, 1u, (_e390 >= 64u))) + select(0u, 1u, (_e390 >= 81u)));
                let _e418 = (_e416 * (_e416 + 1u));
                let _e419 = (_e390 < _e418);
                if _e419 {
                    phi_931_ = (_e418 - _e390);
                } else {
                    phi_931_ = (_e390 - _e418);
                }
                let _e423 = phi_931_;
                if (_e416 <= _e57) {
                    let _e429 = (_e416 - _e423);
                    let _e471 = (((((((select(1f, 3f, (2u <= _e423)) * select(1f, 5f, (3u <= _e423))) * select(1f, 7f, (4u <= _e423))) * select(1f, 9f, (5u <= _e423))) * select(1f, 11f, (6u <= _e423))) * select(1f, 13f, (7u <= _e423))) * select(1f, 15f, (8u <= _e423))) * select(1f, 17f, (9u <= _e423)));
                    let _e475 = (_e416 + _e423);
                    phi_1229_ = sqrt((((f32(((2u * _e416) + 1u)) * _e471) * _e471) / (((((((((((((((((((((((((select(6.2831855f, 12.566371f, (_e423 == 0u)) * select(1f, 2f, (2u <= _e429))) * select(1f, 3f, (3u <= _e429))) * select(1f, 4f, (4u <= _e429))) * select(1f, 5f, (5u <= _e429))) * select(1f, 6f, (6u <= _e429))) * select(1f, 7f, (7u <= _e429))) * select(1f, 8f, (8u <= _e429))) * select(1f, 9f, (9u <= _e429))) * select(1f, 2f, (2u <= _e475))) * select(1f, 3f, (3u <= _e475))) * select(1f, 4f, (4u <= _e475))) * select(1f, 5f, (5u <= _e475))) * select(1f, 6f, (6u <= _e475))) * select(1f, 7f, (7u <= _e475))) * select(1f, 8f, (8u <= _e475))) * select(1f, 9f, (9u <= _e475))) * select(1f, 10f, (10u <= _e475))) * select(1f, 11f, (11u <= _e475))) * select(1f, 12f, (12u <= _e475))) * select(1f, 13f, (13u <= _e475))) * select(1f, 14f, (14u <= _e475))) * select(1f, 15f, (15u <= _e475))) * select(1f, 16f, (16u <= _e475))) * select(1f, 17f, (17u <= _e475))) * select(1f, 18f, (18u <= _e475)))));
                } else {
                    phi_1229_ = 0f;
                }
                let _e535 = phi_1229_;
                let _e536 = (_e98 + 3u);
                let _e562 = ((((((((select(0u, 1u, (_e536 >= 1u)) + select(0u, 1u, (_e536 >= 4u))) + select(0u, 1u, (_e536 >= 9u))) + select(0u, 1u, (_e536 >= 16u))) + select(0u, 1u, (_e536 >= 25u))) + select(0u, 1u, (_e536 >= 36u))) + select(0u, 1u, (_e536 >= 49u))) + select(0u, 1u, (_e536 >= 64u))) + select(0u, 1u, (_e536 >= 81u)));
                let _e564 = (_e562 * (_e562 + 1u));
                let _e565 = (_e536 < _e564);
                if _e565 {
                    phi_1293_ = (_e564 - _e536);
                } else {
                    phi_1293_ = (_e536 - _e564);
                }
                let _e569 = phi_1293_;
                if (_e562 <= _e57) {
                    let _e575 = (_e562 - _e569);
                    let _e617 = (((((((select(1f, 3f, (2u <= _e569)) * select(1f, 5f, (3u <= _e569))) * select(1f, 7f, (4u <= _e569))) * select(1f, 9f, (5u <= _e569))) * select(1f, 11f, (6u <= _e569))) * select(1f, 13f, (7u <= _e569))) * select(1f, 15f, (8u <= _e569))) * select(1f, 17f, (9u <= _e569)));
                    let _e621 = (_e562 + _e569);
                    phi_1591_ = sqrt((((f32(((2u * _e562) + 1u)) * _e617) * _e617) / (((((((((((((((((((((((((select(6.2831855f, 12.566371f, (_e569 == 0u)) * select(1f, 2f, (2u <= _e575))) * select(1f, 3f, (3u <= _e575))) * select(1f, 4f, (4u <= _e575))) * select(1f, 5f, (5u <= _e575))) * select(1f, 6f, (6u <= _e575))) * select(1f, 7f, (7u <= _e575))) * select(1f, 8f, (8u <= _e575))) * select(1f, 9f, (9u <= _e575))) * select(1f, 2f, (2u <= _e621))) * select(1f, 3f, (3u <= _e621))) * select(1f, 4f, (4u <= _e621))) * select(1f, 5f, (5u <= _e621))) * select(1f, 6f, (6u <= _e621))) * select(1f, 7f, (7u <= _e621))) * select(1f, 8f, (8u <= _e621))) * select(1f, 9f, (9u <= _e621))) * select(1f, 10f, (10u <= _e621))) * select(1f, 11f, (11u <= _e621))) * select(1f, 12f, (12u <= _e621))) * select(1f, 13f, (13u <= _e621))) * select(1f, 14f, (14u <= _e621))) * select(1f, 15f, (15u <= _e621))) * select(1f, 16f, (16u <= _e621))) * select(1f, 17f, (17u <= _e621))) * select(1f, 18f, (18u <= _e621)))));
                } else {
                    phi_1591_ = 0f;
                }
                let _e681 = phi_1591_;
                let _e682 = select(1f, 0f, _e127);
                if (_e131 == 0u) {
                    phi_1604_ = _e682;
                } else {
                    phi_1604_ = select(_e83, _e87, _e127);
                }
                let _e686 = phi_1604_;
                let _e687 = (_e83 + _e83);
                let _e690 = ((_e83 * _e83) + (_e87 * _e87));
                phi_1611_ = type_10(1u, _e131);
                phi_1614_ = _e686;
                phi_1616_ = _e682;
                loop {
                    let _e693 = phi_1611_;
                    let _e695 = phi_1614_;
                    let _e697 = phi_1616_;
                    local_4 = _e695;
                    local_5 = _e697;
                    if (_e693.member < _e693.member_1) {
                        phi_1612_ = type_10((_e693.member + 1u), _e693.member_1);
                        phi_1638_ = type_10(1u, _e693.member);
                    } else {
                        phi_1612_ = _e693;
                        phi_1638_ = type_10(0u, type_10().member_1);
                    }
                    let _e710 = phi_1612_;
                    let _e712 = phi_1638_;
                    let _e715 = (bitcast<i32>(_e712.member) != 0i);
                    if _e715 {
                        phi_1615_ = fma(_e687, _e695, -((_e690 * _e697)));
                    } else {
                        phi_1615_ = f32();
                    }
                    let _e720 = phi_1615_;
                    continue;
                    continuing {
                        phi_1611_ = _e710;
                        phi_1614_ = _e720;
                        phi_1616_ = _e695;
                        break if !(_e715);
                    }
                }
                phi_1653_ = type_10(_e131, _e124);
                phi_1656_ = f32(((2u * _e131) + 1u));
                phi_1658_ = 0f;
                let _e1060 = local_4;
                phi_1660_ = _e1060;
                let _e1063 = local_5;
                phi_1662_ = _e1063;
                loop {
                    let _e727 = phi_1653_;
                    let _e729 = phi_1656_;
                    let _e731 = phi_1658_;
                    let _e733 = phi_1660_;
                    let _e735 = phi_1662_;
                    local = _e733;
                    if (_e727.member < _e727.member_1) {
                        phi_1654_ = type_10((_e727.member + 1u), _e727.member_1);
                        phi_1684_ = type_10(1u, _e727.member);
                    } else {
                        phi_1654_ = _e727;
                        phi_1684_ = type_10(0u, type_10().member_1);
                    }
                    let _e748 = phi_1654_;
                    let _e750 = phi_1684_;
                    let _e753 = (bitcast<i32>(_e750.member) != 0i);
                    if _e753 {
                        phi_1657_ = (_e729 + 2f);
                        phi_1659_ = (_e731 + _e729);
                        phi_1661_ = fma((_e92 * _e729), _e733, -((_e731 * _e735)));
                    } else {
                        phi_1657_ = f32();
                        phi_1659_ = f32();
                        phi_1661_ = f32();
                    }
                    let _e761 = phi_1657_;
                    let _e763 = phi_1659_;
                    let _e765 = phi_1661_;
                    continue;
                    continuing {
                        phi_1653_ = _e748;
                        phi_1656_ = _e761;
                        phi_1658_ = _e763;
                        phi_1660_ = _e765;
                        phi_1662_ = _e733;
                        break if !(_e753);
                    }
                }
                let _e768 = local;
                let _e771 = select(1f, 0f, _e273);
                if (_e277 == 0u) {
                    phi_1711_ = _e771;
                } else {
                    phi_1711_ = select(_e83, _e87, _e273);
                }
                let _e775 = phi_1711_;
                phi_1718_ = type_10(1u, _e277);
                phi_1721_ = _e775;
                phi_1723_ = _e771;
                loop {
                    let _e778 = phi_1718_;
                    let _e780 = phi_1721_;
                    let _e782 = phi_1723_;
                    local_6 = _e780;
                    local_7 = _e782;
                    if (_e778.member < _e778.member_1) {
                        phi_1719_ = type_10((_e778.member + 1u), _e778.member_1);
                        phi_1745_ = type_10(1u, _e778.member);
                    } else {
                        phi_1719_ = _e778;
                        phi_1745_ = type_10(0u, type_10().member_1);
                    }
                    let _e795 = phi_1719_;
                    let _e797 = phi_1745_;
                    let _e800 = (bitcast<i32>(_e797.member) != 0i);
                    if _e800 {
                        phi_1722_ = fma(_e687, _e780, -((_e690 * _e782)));
                    } else {
                        phi_1722_ = f32();
                    }
                    let _e805 = phi_1722_;
                    continue;
                    continuing {
                        phi_1718_ = _e795;
                        phi_1721_ = _e805;
                        phi_1723_ = _e780;
                        break if !(_e800);
                    }
                }
                phi_1760_ = type_10(_e277, _e270);
                phi_1763_ = f32(((2u * _e277) + 1u));
                phi_1765_ = 0f;
                let _e1082 = local_6;
                phi_1767_ = _e1082;
                let _e1085 = local_7;
                phi_1769_ = _e1085;
                loop {
                    let _e812 = phi_1760_;
                    let _e814 = phi_1763_;
                    let _e816 = phi_1765_;
                    let _e818 = phi_1767_;
                    let _e820 = phi_1769_;
                    local_1 = _e818;
                    if (_e812.member < _e812.member_1) {
                        phi_1761_ = type_10((_e812.member + 1u), _e812.member_1);
                        phi_1791_ = type_10(1u, _e812.member);
                    } else {
                        phi_1761_ = _e812;
                        phi_1791_ = type_10(0u, type_10().member_1);
                    }
                    let _e833 = phi_1761_;
                    let _e835 = phi_1791_;
                    let _e838 = (bitcast<i32>(_e835.member) != 0i);
                    if _e838 {
                        phi_1764_ = (_e814 + 2f);
                        phi_1766_ = (_e816 + _e814);
                        phi_1768_ = fma((_e92 * _e814), _e818, -((_e816 * _e820)));
                    } else {
                        phi_1764_ = f32();
                        phi_1766_ = f32();
                        phi_1768_ = f32();
                    }
                    let _e846 = phi_1764_;
                    let _e848 = phi_1766_;
                    let _e850 = phi_1768_;
                    continue;
                    continuing {
                        phi_1760_ = _e833;
                        phi_1763_ = _e846;
                        phi_1765_ = _e848;
                        phi_1767_ = _e850;
                        phi_1769_ = _e818;
                        break if !(_e838);
                    }
                }
                let _e853 = local_1;
                let _e856 = select(1f, 0f, _e419);
                if (_e423 == 0u) {
                    phi_1818_ = _e856;
                } else {
                    phi_1818_ = select(_e83, _e87, _e419);
                }
                let _e860 = phi_1818_;
                phi_1825_ = type_10(1u, _e423);
                phi_1828_ = _e860;
                phi_1830_ = _e856;
                loop {
                    let _e863 = phi_1825_;
                    let _e865 = phi_1828_;
                    let _e867 = phi_1830_;
                    local_8 = _e865;
                    local_9 = _e867;
                    if (_e863.member < _e863.member_1) {
                        phi_1826_ = type_10((_e863.member + 1u), _e863.member_1);
                        phi_1852_ = type_10(1u, _e863.member);
                    } else {
                        phi_1826_ = _e863;
                        phi_1852_ = type_10(0u, type_10().member_1);
                    }
                    let _e880 = phi_1826_;
                    let _e882 = phi_1852_;
                    let _e885 = (bitcast<i32>(_e882.member) != 0i);
                    if _e885 {
                        phi_1829_ = fma(_e687, _e865, -((_e690 * _e867)));
                    } else {
                        phi_1829_ = f32();
                    }
                    let _e890 = phi_1829_;
                    continue;
                    continuing {
                        phi_1825_ = _e880;
                        phi_1828_ = _e890;
                        phi_1830_ = _e865;
                        break if !(_e885);
                    }
                }
                phi_1867_ = type_10(_e423, _e416);
                phi_1870_ = f32(((2u * _e423) + 1u));
                phi_1872_ = 0f;
                let _e1104 = local_8;
                phi_1874_ = _e1104;
                let _e1107 = local_9;
                phi_1876_ = _e1107;
                loop {
                    let _e897 = phi_1867_;
                    let _e899 = phi_1870_;
                    let _e901 = phi_1872_;
                    let _e903 = phi_1874_;
                    let _e905 = phi_1876_;
                    local_2 = _e903;
                    if (_e897.member < _e897.member_1) {
                        phi_1868_ = type_10((_e897.member + 1u), _e897.member_1);
                        phi_1898_ = type_10(1u, _e897.member);
                    } else {
                        phi_1868_ = _e897;
                        phi_1898_ = type_10(0u, type_10().member_1);
                    }
                    let _e918 = phi_1868_;
                    let _e920 = phi_1898_;
                    let _e923 = (bitcast<i32>(_e920.member) != 0i);
                    if _e923 {
                        phi_1871_ = (_e899 + 2f);
                        phi_1873_ = (_e901 + _e899);
                        phi_1875_ = fma((_e92 * _e899), _e903, -((_e901 * _e905)));
                    } else {
                        phi_1871_ = f32();
                        phi_1873_ = f32();
                        phi_1875_ = f32();
                    }
                    let _e931 = phi_1871_;
                    let _e933 = phi_1873_;
                    let _e935 = phi_1875_;
                    continue;
                    continuing {
                        phi_1867_ = _e918;
                        phi_1870_ = _e931;
                        phi_1872_ = _e933;
                        phi_1874_ = _e935;
                        phi_1876_ = _e903;
                        break if !(_e923);
                    }
                }
                let _e938 = local_2;
                let _e941 = select(1f, 0f, _e565);
                if (_e569 == 0u) {
                    phi_1925_ = _e941;
                } else {
                    phi_1925_ = select(_e83, _e87, _e565);
                }
                let _e945 = phi_1925_;
                phi_1932_ = type_10(1u, _e569);
                phi_1935_ = _e945;
                phi_1937_ = _e941;
                loop {
                    let _e948 = phi_1932_;
                    let _e950 = phi_1935_;
                    let _e952 = phi_1937_;
                    local_10 = _e950;
                    local_11 = _e952;
                    if (_e948.member < _e948.member_1) {
                        phi_1933_ = type_10((_e948.member + 1u), _e948.member_1);
                        phi_1959_ = type_10(1u, _e948.member);
                    } else {
                        phi_1933_ = _e948;
                        phi_1959_ = type_10(0u, type_10().member_1);
                    }
                    let _e965 = phi_1933_;
                    let _e967 = phi_1959_;
                    let _e970 = (bitcast<i32>(_e967.member) != 0i);
                    if _e970 {
                        phi_1936_ = fma(_e687, _e950, -((_e690 * _e952)));
                    } else {
                        phi_1936_ = f32();
                    }
                    let _e975 = phi_1936_;
                    continue;
                    continuing {
                        phi_1932_ = _e965;
                        phi_1935_ = _e975;
                        phi_1937_ = _e950;
                        break if !(_e970);
                    }
                }
                phi_1974_ = type_10(_e569, _e562);
                phi_1977_ = f32(((2u * _e569) + 1u));
                phi_1979_ = 0f;
                let _e1126 = local_10;
                phi_1981_ = _e1126;
                let _e1129 = local_11;
                phi_1983_ = _e1129;
                loop {
                    let _e982 = phi_1974_;
                    let _e984 = phi_1977_;
                    let _e986 = phi_1979_;
                    let _e988 = phi_1981_;
                    let _e990 = phi_1983_;
                    local_3 = _e988;
                    if (_e982.member < _e982.member_1) {
                        phi_1975_ = type_10((_e982.member + 1u), _e982.member_1);
                        phi_2005_ = type_10(1u, _e982.member);
                    } else {
                        phi_1975_ = _e982;
                        phi_2005_ = type_10(0u, type_10().member_1);
                    }
                    let _e1003 = phi_1975_;
                    let _e1005 = phi_2005_;
                    let _e1008 = (bitcast<i32>(_e1005.member) != 0i);
                    if _e1008 {
                        phi_1978_ = (_e984 + 2f);
                        phi_1980_ = (_e986 + _e984);
                        phi_1982_ = fma((_e92 * _e984), _e988, -((_e986 * _e990)));
                    } else {
                        phi_1978_ = f32();
                        phi_1980_ = f32();
                        phi_1982_ = f32();
                    }
                    let _e1016 = phi_1978_;
                    let _e1018 = phi_1980_;
                    let _e1020 = phi_1982_;
                    continue;
                    continuing {
                        phi_1974_ = _e1003;
                        phi_1977_ = _e1016;
                        phi_1979_ = _e1018;
                        phi_1981_ = _e1020;
                        phi_1983_ = _e988;
                        break if !(_e1008);
                    }
                }
                let _e1023 = local_3;
                table.member[_e75] = (_e97 * (_e768 * _e243));
                table.member[(_e71 + _e75)] = (_e97 * (_e853 * _e389));
                table.member[((2u * _e71) + _e75)] = (_e97 * (_e938 * _e535));
                table.member[((3u * _e71) + _e75)] = (_e97 * (_e1023 * _e681));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_basis(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
