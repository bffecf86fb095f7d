struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_15 {
    member: type_14,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_15;
@group(0) @binding(1) 
var<storage> directions: type_5;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(3) 
var<storage, read_write> coefs: type_5;

fn function_() {
    var phi_95_: u32;
    var phi_114_: u32;
    var phi_178_: u32;
    var phi_263_: u32;
    var phi_561_: f32;
    var phi_625_: u32;
    var phi_923_: f32;
    var phi_987_: u32;
    var phi_1285_: f32;
    var phi_1349_: u32;
    var phi_1647_: f32;
    var phi_1653_: type_12;
    var phi_1656_: array<f32, 12>;
    var phi_1654_: type_12;
    var phi_1679_: type_12;
    var phi_1718_: f32;
    var phi_1725_: type_12;
    var phi_1728_: f32;
    var phi_1730_: f32;
    var phi_1726_: type_12;
    var phi_1752_: type_12;
    var phi_1729_: f32;
    var phi_1767_: type_12;
    var phi_1770_: f32;
    var phi_1772_: f32;
    var phi_1774_: f32;
    var phi_1776_: f32;
    var phi_1768_: type_12;
    var phi_1798_: type_12;
    var phi_1771_: f32;
    var phi_1773_: f32;
    var phi_1775_: f32;
    var local: f32;
    var phi_1833_: f32;
    var phi_1840_: type_12;
    var phi_1843_: f32;
    var phi_1845_: f32;
    var phi_1841_: type_12;
    var phi_1867_: type_12;
    var phi_1844_: f32;
    var phi_1882_: type_12;
    var phi_1885_: f32;
    var phi_1887_: f32;
    var phi_1889_: f32;
    var phi_1891_: f32;
    var phi_1883_: type_12;
    var phi_1913_: type_12;
    var phi_1886_: f32;
    var phi_1888_: f32;
    var phi_1890_: f32;
    var local_1: f32;
    var phi_1948_: f32;
    var phi_1955_: type_12;
    var phi_1958_: f32;
    var phi_1960_: f32;
    var phi_1956_: type_12;
    var phi_1982_: type_12;
    var phi_1959_: f32;
    var phi_1997_: type_12;
    var phi_2000_: f32;
    var phi_2002_: f32;
    var phi_2004_: f32;
    var phi_2006_: f32;
    var phi_1998_: type_12;
    var phi_2028_: type_12;
    var phi_2001_: f32;
    var phi_2003_: f32;
    var phi_2005_: f32;
    var local_2: f32;
    var phi_2063_: f32;
    var phi_2070_: type_12;
    var phi_2073_: f32;
    var phi_2075_: f32;
    var phi_2071_: type_12;
    var phi_2097_: type_12;
    var phi_2074_: f32;
    var phi_2112_: type_12;
    var phi_2115_: f32;
    var phi_2117_: f32;
    var phi_2119_: f32;
    var phi_2121_: f32;
    var phi_2113_: type_12;
    var phi_2143_: type_12;
    var phi_2116_: f32;
    var phi_2118_: f32;
    var phi_2120_: f32;
    var local_3: f32;
    var phi_1657_: array<f32, 12>;
    var local_4: array<f32, 12>;
    var local_5: array<f32, 12>;
    var local_6: array<f32, 12>;
    var local_7: array<f32, 12>;
    var local_8: array<f32, 12>;
    var local_9: array<f32, 12>;
    var local_10: array<f32, 12>;
    var local_11: array<f32, 12>;
    var local_12: array<f32, 12>;
    var local_13: array<f32, 12>;
    var local_14: array<f32, 12>;
    var local_15: array<f32, 12>;
    var local_16: f32;
    var local_17: f32;
    var local_18: f32;
    var local_19: f32;
    var local_20: f32;
    var local_21: f32;
    var local_22: f32;
    var local_23: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e67 = gid_1;
            let _e70 = params.member.member;
            let _e73 = params.member.member_2;
            let _e76 = (_e70 / 64u);
            if ((_e70 % 64u) > 0u) {
                phi_95_ = (_e76 + 1u);
            } else {
                phi_95_ = _e76;
            }
            let _e81 = phi_95_;
            let _e82 = (select(_e73, 9u, (_e73 > 9u)) + 1u);
            let _e83 = (_e82 * _e82);
            let _e84 = (_e83 / 4u);
            let _e86 = ((_e83 % 4u) > 0u);
            if _e86 {
                phi_114_ = (_e84 + 1u);
            } else {
                phi_114_ = _e84;
            }
            let _e89 = phi_114_;
            let _e90 = (_e81 * _e89);
            let _e91 = (_e90 * 64u);
            let _e95 = (_e67.x + (_e67.y * 2097152u));
            if (_e95 < _e91) {
                let _e97 = (_e95 / 64u);
                if _e86 {
                    phi_178_ = (_e84 + 1u);
                } else {
                    phi_178_ = _e84;
                }
                let _e102 = phi_178_;
                if (_e102 == 0u) {
                    break;
                }
                let _e104 = (_e97 / _e102);
                let _e107 = (_e104 * 64u);
                let _e110 = params.member.member_1;
                let _e117 = ((_e97 - (_e104 * _e102)) * 4u);
                let _e143 = ((((((((select(0u, 1u, (_e117 >= 1u)) + select(0u, 1u, (_e117 >= 4u))) + select(0u, 1u, (_e117 >= 9u))) + select(0u, 1u, (_e117 >= 16u))) + select(0u, 1u, (_e117 >= 25u))) + select(0u, 1u, (_e117 >= 36u))) + select(0u, 1u, (_e117 >= 49u))) + select(0u, 1u, (_e117 >= 64u))) + select(0u, 1u, (_e117 >= 81u)));
                let _e145 = (_e143 * (_e143 + 1u));
                let _e146 = (_e117 < _e145);
                if _e146 {
                    phi_263_ = (_e145 - _e117);
                } else {
                    phi_263_ = (_e117 - _e145);
                }
                let _e150 = phi_263_;
                if (_e143 <= _e73) {
                    let _e156 = (_e143 - _e150);
                    let _e198 = (((((((select(1f, 3f, (2u <= _e150)) * select(1f, 5f, (3u <= _e150))) * select(1f, 7f, (4u <= _e150))) * select(1f, 9f, (5u <= _e150))) * select(1f, 11f, (6u <= _e150))) * select(1f, 13f, (7u <= _e150))) * select(1f, 15f, (8u <= _e150))) * select(1f, 17f, (9u <= _e150)));
                    let _e202 = (_e143 + _e150);
                    phi_561_ = sqrt((((f32(((2u * _e143) + 1u)) * _e198) * _e198) / (((((((((((((((((((((((((select(6.2831855f, 12.566371f, (_e150 == 0u)) * select(1f, 2f, (2u <= _e156))) * select(1f, 3f, (3u <= _e156))) * select(1f, 4f, (4u <= _e156))) * select(1f, 5f, (5u <= _e156))) * select(1f, 6f, (6u <= _e156))) * select(1f, 7f, (7u <= _e156))) * select(1f, 8f, (8u <= _e156))) * select(1f, 9f, (9u <= _e156))) * select(1f, 2f, (2u <= _e202))) * select(1f, 3f, (3u <= _e202))) * select(1f, 4f, (4u <= _e202))) * select(1f, 5f, (5u <= _e202))) * select(1f, 6f, (6u <= _e202))) * select(1f, 7f, (7u <= _e202))) * select(1f, 8f, (8u <= _e202))) * select(1f, 9f, (9u <= _e202))) * select(1f, 10f, (10u <= _e202))) * select(1f, 11f, (11u <= _e202))) * select(1f, 12f, (12u <= _e202))) * select(1f, 13f, (13u <= _e202))) * select(1f, 14f, (14u <= _e202))) * select(1f, 15f, (15u <= _e202))) * select(1f, 16f, (16u <= _e202))) * select(1f, 17f, (17u <= _e202))) * select(1f, 18f, (18u <= _e202)))));
                } else {
                    phi_561_ = 0f;
                }
                let _e262 = phi_561_;
                let _e263 = (_e117 + 1u);
                let _e289 = ((((((((select(0u, 1u, (_e263 >= 1u)) + select(0u, 1u, (_e263 >= 4u))) + select(0u, 1u, (_e263 >= 9u))) + select(0u, 1u, (_e263 >= 16u))) + select(0u, 1u, (_e263 >= 25u))) + select(0u, 1u, (_e263 >= 36u))) + select(0u, 1u, (_e263 >= 49u))) + select(0u, 1u, (_e263 >= 64u))) + select(0u, 1u, (_e263 >= 81u)));
                let _e291 = (_e289 * (_e289 + 1u));
                let _e292 = (_e263 < _e291);
                if _e292 {
                    phi_625_ = (_e291 - _e263);
                } else {
                    phi_625_ = (_e263 - _e291);
                }
                let _e296 = phi_625_;
                if (_e289 <= _e73) {
                    let _e302 = (_e289 - _e296);
                    let _e344 = (((((((select(1f, 3f, (2u <= _e296)) * select(1f, 5f, (3u <= _e296))) * select(1f, 7f, (4u <= _e296))) * select(1f, 9f, (5u <= _e296))) * select(1f, 11f, (6u <= _e296))) * select(1f, 13f, (7u <= _e296))) * select(1f, 15f, (8u <= _e296))) * select(1f, 17f, (9u <= _e296)));
                    let _e348 = (_e289 + _e296);
                    phi_923_ = sqrt((((f32(((2u * _e289) + 1u)) * _e344) * _e344) / (((((((((((((((((((((((((select(6.2831855f, 12.566371f, (_e296 == 0u)) * select(1f, 2f, (2u <= _e302))) * select(1f, 3f, (3u <= _e302))) * select(1f, 4f, (4u <= _e302))) * select(1f, 5f, (5u <= _e302))) * select(1f, 6f, (6u <= _e302))) * select(1f, 7f, (7u <= _e302))) * select(1f, 8f, (8u <= _e302))) * select(1f, 9f, (9u <= _e302))) * select(1f, 2f, (2u <= _e348))) * select(1f, 3f, (3u <= _e348))) * select(1f, 4f, (4u <= _e348))) * select(1f, 5f, (5u <= _e348))) * select(1f, 6f, (6u <= _e348))) * select(1f, 7f, (7u <= _e348))) * select(1f, 8f, (8u <= _e348))) * select(1f, 9f, (9u <= _e348))) * select(1f, 10f, (10u <= _e348))) * select(1f, 11f, (11u <= _e348))) * select(1f, 12f, (12u <= _e348))) * select(1f, 13f, (13u <= _e348))) * select(1f, 14f, (14u <= _e348))) * select(1f, 15f, (15u <= _e348))) * select(1f, 16f, (16u <= _e348))) * select(1f, 17f, (17u <= _e348))) * select(1f, 18f, (18u <= _e348)))));
                } else {
                    phi_923_ = 0f;
                }
                let _e408 = phi_923_;
                let _e409 = (_e117 + 2u);
                let _e435 = ((((((((select(0u, 1u, (_e409 >= 1u)) + select(0u, 1u, (_e409 >= 4u))) + select(0u, 1u, (_e409 >= 9u))) + select(0u, 1u, (_e409 >= 16u))) + select(0u, 1u, (_e409 >= 25u))) + select(0u, 1u, (_e409 >= 36u))) + select(0u, 1u, (_e409 >= 49u))) + select(0u, 1u, (_e409 >= 64u))) + select(0u, 1u, (_e409 >= 81u)));
                let _e437 = (_e435 * (_e435 + 1u));
                let _e438 = (_e409 < _e437);
                if _e438 {
                    phi_987_ = (_e437 - _e409);
                } else {
                    phi_987_ = (_e409 - _e437);
                }
                let _e442 = phi_987_;
                if (_e435 <= _e73) {
                    let _e448 = (_e435 - _e442);
                    let _e490 = (((((((select(1f, 3f, (2u <= _e442)) * select(1f, 5f, (3u <= _e442))) * select(1f, 7f, (4u <= _e442))) * select(1f, 9f, (5u <= _e442))) * select(1f, 11f, (6u <= _e442))) * select(1f, 13f, (7u <= _e442))) * select(1f, 15f, (8u <= _e442))) * select(1f, 17f, (9u <= _e442)));
                    let _e494 = (_e435 + _e442);
                    phi_1285_ = sqrt((((f32(((2u * _e435) + 1u)) * _e490) * _e490) / (((((((((((((((((((((((((select(6.2831855f, 12.566371f, (_e442 == 0u)) * select(1f, 2f, (2u <= _e448))) * select(1f, 3f, (3u <= _e448))) * select(1f, 4f, (4u <= _e448))) * select(1f, 5f, (5u <= _e448))) * select(1f, 6f, (6u <= _e448))) * select(1f, 7f, (7u <= _e448))) * select(1f, 8f, (8u <= _e448))) * select(1f, 9f, (9u <= _e448))) * select(1f, 2f, (2u <= _e494))) * select(1f, 3f, (3u <= _e494))) * select(1f, 4f, (4u <= _e494))) * select(1f, 5f, (5u <= _e494))) * select(1f, 6f, (6u <= _e494))) * select(1f, 7f, (7u <= _e494))) * select(1f, 8f, (8u <= _e494))) * select(1f, 9f, (9u <= _e494))) * select(1f, 10f, (10u <= _e494))) * select(1f, 11f, (11u <= _e494))) * select(1f, 12f, (12u <= _e494))) * select(1f, 13f, (13u <= _e494))) * select(1f, 14f, (14u <= _e494))) * select(1f, 15f, (15u <= _e494))) * select(1f, 16f, (16u <= _e494))) * select(1f, 17f, (17u <= _e494))) * select(1f, 18f, (18u <= _e494)))));
                } else {
                    phi_1285_ = 0f;
                }
                let _e554 = phi_1285_;
                let _e555 = (_e117 + 3u);
                let _e581 = ((((((((select(0u, 1u, (_e555 >= 1u)) + select(0u, 1u, (_e555 >= 4u))) + select(0u, 1u, (_e555 >= 9u))) + select(0u, 1u, (_e555 >= 16u))) + select(0u, 1u, (_e555 >= 25u))) + select(0u, 1u, (_e555 >= 36u))) + select(0u, 1u, (_e555 >= 49u))) + select(0u, 1u, (_e555 >= 64u))) + select(0u, 1u, (_e555 >= 81u)));
                let _e583 = (_e581 * (_e581 + 1u));
                let _e584 = (_e555 < _e583);
                if _e584 {
                    phi_1349_ = (_e583 - _e555);
                } else {
                    phi_1349_ = (_e555 - _e583);
                }
                let _e588 = phi_1349_;
                if (_e581 <= _e73) {
                    let _e594 = (_e581 - _e588);
                    let _e636 = (((((((select(1f, 3f, (2u <= _e588)) * select(1f, 5f, (3u <= _e588))) * select(1f, 7f, (4u <= _e588))) * select(1f, 9f, (5u <= _e588))) * select(1f, 11f, (6u <= _e588))) * select(1f, 13f, (7u <= _e588))) * select(1f, 15f, (8u <= _e588))) * select(1f, 17f, (9u <= _e588)));
                    let _e640 = (_e581 + _e588);
                    phi_1647_ = sqrt((((f32(((2u * _e581) + 1u)) * _e636) * _e636) / (((((((((((((((((((((((((select(6.2831855f, 12.566371f, (_e588 == 0u)) * select(1f, 2f, (2u <= _e594))) * select(1f, 3f, (3u <= _e594))) * select(1f, 4f, (4u <= _e594))) * select(1f, 5f, (5u <= _e594))) * select(1f, 6f, (6u <= _e594))) * select(1f, 7f, (7u <= _e594))) * select(1f, 8f, (8u <= _e594))) * select(1f, 9f, (9u <= _e594))) * select(1f, 2f, (2u <= _e640))) * select(1f, 3f, (3u <= _e640))) * select(1f, 4f, (4u <= _e640))) * select(1f, 5f, (5u <= _e640))) * select(1f, 6f, (6u <= _e640))) * select(1f, 7f, (7u <= _e640))) * select(1f, 8f, (8u <= _e640))) * select(1f, 9f, (9u <= _e640))) * select(1f, 10f, (10u <= _e640))) * select(1f, 11f, (11u <= _e640))) * select(1f, 12f, (12u <= _e640))) * select(1f, 13f, (13u <= _e640))) * select(1f, 14f, (14u <= _e640))) * select(1f, 15f, (15u <= _e640))) * select(1f, 16f, (16u <= _e640))) * select(1f, 17f, (17u <= _e640))) * select(1f, 18f, (18u <= _e640)))));
                } else {
                    phi_1647_ = 0f;
                }
                let _e700 = phi_1647_;
                phi_1653_ = type_12(0u, _e110);
                phi_1656_ = array<f32, 12>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e703 = phi_1653_;
                    let _e705 = phi_1656_;
                    local_4 = _e705;
                    local_5 = _e705;
                    local_6 = _e705;
                    local_7 = _e705;
                    local_8 = _e705;
                    local_9 = _e705;
                    local_10 = _e705;
                    local_11 = _e705;
                    local_12 = _e705;
                    local_13 = _e705;
                    local_14 = _e705;
                    local_15 = _e705;
                    if (_e703.member < _e703.member_1) {
                        phi_1654_ = type_12((_e703.member + 1u), _e703.member_1);
                        phi_1679_ = type_12(1u, _e703.member);
                    } else {
                        phi_1654_ = _e703;
                        phi_1679_ = type_12(0u, type_12().member_1);
                    }
                    let _e718 = phi_1654_;
                    let _e720 = phi_1679_;
                    let _e724 = (bitcast<i32>(_e720.member) != 0i);
                    if _e724 {
                        let _e726 = ((((((_e107 / 64u) * _e110) * 192u) + (_e107 % 64u)) + (_e95 - (_e97 * 64u))) + (_e720.member_1 * 192u));
                        let _e729 = directions.member[_e726];
                        let _e730 = (_e726 + 64u);
                        let _e733 = directions.member[_e730];
                        let _e734 = (_e726 + 128u);
                        let _e737 = directions.member[_e734];
                        let _e740 = radiance.member[_e726];
                        let _e743 = radiance.member[_e730];
                        let _e746 = radiance.member[_e734];
                        let _e747 = select(1f, 0f, _e146);
                        if (_e150 == 0u) {
                            phi_1718_ = _e747;
                        } else {
                            phi_1718_ = select(_e729, _e733, _e146);
                        }
                        let _e751 = phi_1718_;
                        let _e752 = (_e729 + _e729);
                        let _e755 = ((_e729 * _e729) + (_e733 * _e733));
                        phi_1725_ = type_12(1u, _e150);
                        phi_1728_ = _e751;
                        phi_1730_ = _e747;
                        loop {
                            let _e758 = phi_1725_;
                            let _e760 = phi_1728_;
                            let _e762 = phi_1730_;
                            local_16 = _e760;
                            local_17 = _e762;
                            if (_e758.member < _e758.member_1) {
                                phi_1726_ = type_12((_e758.member + 1u), _e758.member_1);
                                phi_1752_ = type_12(1u, _e758.member);
                            } else {
                                phi_1726_ = _e758;
                                phi_1752_ = type_12(0u, type_12().member_1);
                            }
                            let _e775 = phi_1726_;
                            let _e777 = phi_1752_;
                            let _e780 = (bitcast<i32>(_e777.member) != 0i);
                            if _e780 {
                                phi_1729_ = fma(_e752, _e760, -((_e755 * _e762)));
                            } else {
                                phi_1729_ = f32();
                            }
                            let _e785 = phi_1729_;
                            continue;
                            continuing {
                                phi_1725_ = _e775;
                                phi_1728_ = _e785;
                                phi_1730_ = _e760;
                                break if !(_e780);
                            }
                        }
                        phi_1767_ = type_12(_e150, _e143);
                        phi_1770_ = f32(((2u * _e150) + 1u));
                        phi_1772_ = 0f;
                        let _e1238 = local_16;
                        phi_1774_ = _e1238;
                        let _e1241 = local_17;
                        phi_1776_ = _e1241;
                        loop {
                            let _e792 = phi_1767_;
                            let _e794 = phi_1770_;
                            let _e796 = phi_1772_;
                            let _e798 = phi_1774_;
                            let _e800 = phi_1776_;
                            local = _e798;
                            if (_e792.member < _e792.member_1) {
                                phi_1768_ = type_12((_e792.member + 1u), _e792.member_1);
                                phi_1798_ = type_12(1u, _e792.member);
                            } else {
                                phi_1768_ = _e792;
                                phi_1798_ = type_12(0u, type_12().member_1);
                            }
                            let _e813 = phi_1768_;
                            let _e815 = phi_1798_;
                            let _e818 = (bitcast<i32>(_e815.member) != 0i);
                            if _e818 {
                                phi_1771_ = (_e794 + 2f);
                                phi_1773_ = (_e796 + _e794);
                                phi_1775_ = fma((_e737 * _e794), _e798, -((_e796 * _e800)));
                            } else {
                                phi_1771_ = f32();
                                phi_1773_ = f32();
                                phi_1775_ = f32();
                            }
                            let _e826 = phi_1771_;
                            let _e828 = phi_1773_;
                            let _e830 = phi_1775_;
                            continue;
                            continuing {
                                phi_1767_ = _e813;
                                phi_1770_ = _e826;
                                phi_1772_ = _e828;
                                phi_1774_ = _e830;
                                phi_1776_ = _e798;
                                break if !(_e818);
                            }
                        }
                        let _e833 = local;
                        let _e834 = (_e833 * _e262);
                        let _e841 = select(1f, 0f, _e292);
                        if (_e296 == 0u) {
                            phi_1833_ = _e841;
                        } else {
                            phi_1833_ = select(_e729, _e733, _e292);
                        }
                        let _e845 = phi_1833_;
                        phi_1840_ = type_12(1u, _e296);
                        phi_1843_ = _e845;
                        phi_1845_ = _e841;
                        loop {
                            let _e848 = phi_1840_;
                            let _e850 = phi_1843_;
                            let _e852 = phi_1845_;
                            local_18 = _e850;
                            local_19 = _e852;
                            if (_e848.member < _e848.member_1) {
                                phi_1841_ = type_12((_e848.member + 1u), _e848.member_1);
                                phi_1867_ = type_12(1u, _e848.member);
                            } else {
                                phi_1841_ = _e848;
                                phi_1867_ = type_12(0u, type_12().member_1);
                            }
                            let _e865 = phi_1841_;
                            let _e867 = phi_1867_;
                            let _e870 = (bitcast<i32>(_e867.member) != 0i);
                            if _e870 {
                                phi_1844_ = fma(_e752, _e850, -((_e755 * _e852)));
                            } else {
                                phi_1844_ = f32();
                            }
                            let _e875 = phi_1844_;
                            continue;
                            continuing {
                                phi_1840_ = _e865;
                                phi_1843_ = _e875;
                                phi_1845_ = _e850;
                                break if !(_e870);
                            }
                        }
                        phi_1882_ = type_12(_e296, _e289);
                        phi_1885_ = f32(((2u * _e296) + 1u));
                        phi_1887_ = 0f;
                        let _e1260 = local_18;
                        phi_1889_ = _e1260;
                        let _e1263 = local_19;
                        phi_1891_ = _e1263;
                        loop {
                            let _e882 = phi_1882_;
                            let _e884 = phi_1885_;
                            let _e886 = phi_1887_;
                            let _e888 = phi_1889_;
                            let _e890 = phi_1891_;
                            local_1 = _e888;
                            if (_e882.member < _e882.member_1) {
                                phi_1883_ = type_12((_e882.member + 1u), _e882.member_1);
                                phi_1913_ = type_12(1u, _e882.member);
                            } else {
                                phi_1883_ = _e882;
                                phi_1913_ = type_12(0u, type_12().member_1);
                            }
                            let _e903 = phi_1883_;
                            let _e905 = phi_1913_;
                            let _e908 = (bitcast<i32>(_e905.member) != 0i);
                            if _e908 {
                                phi_1886_ = (_e884 + 2f);
                                phi_1888_ = (_e886 + _e884);
                                phi_1890_ = fma((_e737 * _e884), _e888, -((_e886 * _e890)));
                            } else {
                                phi_1886_ = f32();
                                phi_1888_ = f32();
                                phi_1890_ = f32();
                            }
                            let _e916 = phi_1886_;
                            let _e918 = phi_1888_;
                            let _e920 = phi_1890_;
                            continue;
                            continuing {
                                phi_1882_ = _e903;
                                phi_1885_ = _e916;
                                phi_1887_ = _e918;
                                phi_1889_ = _e920;
                                phi_1891_ = _e888;
                                break if !(_e908);
                            }
                        }
                        let _e923 = local_1;
                        let _e924 = (_e923 * _e408);
                        let _e931 = select(1f, 0f, _e438);
                        if (_e442 == 0u) {
                            phi_1948_ = _e931;
                        } else {
                            phi_1948_ = select(_e729, _e733, _e438);
                        }
                        let _e935 = phi_1948_;
                        phi_1955_ = type_12(1u, _e442);
                        phi_1958_ = _e935;
                        phi_1960_ = _e931;
                        loop {
                            let _e938 = phi_1955_;
                            let _e940 = phi_1958_;
                            let _e942 = phi_1960_;
                            local_20 = _e940;
                            local_21 = _e942;
                            if (_e938.member < _e938.member_1) {
                                phi_1956_ = type_12((_e938.member + 1u), _e938.member_1);
                                phi_1982_ = type_12(1u, _e938.member);
                            } else {
                                phi_1956_ = _e938;
                                phi_1982_ = type_12(0u, type_12().member_1);
                            }
                            let _e955 = phi_1956_;
                            let _e957 = phi_1982_;
                            let _e960 = (bitcast<i32>(_e957.member) != 0i);
                            if _e960 {
                                phi_1959_ = fma(_e752, _e940, -((_e755 * _e942)));
                            } else {
                                phi_1959_ = f32();
                            }
                            let _e965 = phi_1959_;
                            continue;
                            continuing {
                                phi_1955_ = _e955;
                                phi_1958_ = _e965;
                                phi_1960_ = _e940;
                                break if !(_e960);
                            }
                        }
                        phi_1997_ = type_12(_e442, _e435);
                        phi_2000_ = f32(((2u * _e442) + 1u));
                        phi_2002_ = 0f;
                        let _e1282 = local_20;
                        phi_2004_ = _e1282;
                        let _e1285 = local_21;
                        phi_2006_ = _e1285;
                        loop {
                            let _e972 = phi_1997_;
                            let _e974 = phi_2000_;
                            let _e976 = phi_2002_;
                            let _e978 = phi_2004_;
                            let _e980 = phi_2006_;
                            local_2 = _e978;
                            if (_e972.member < _e972.member_1) {
                                phi_1998_ = type_12((_e972.member + 1u), _e972.member_1);
                                phi_2028_ = type_12(1u, _e972.member);
                            } else {
                                phi_1998_ = _e972;
                                phi_2028_ = type_12(0u, type_12().member_1);
                            }
                            let _e993 = phi_1998_;
                            let _e995 = phi_2028_;
                            let _e998 = (bitcast<i32>(_e995.member) != 0i);
                            if _e998 {
                                phi_2001_ = (_e974 + 2f);
                                phi_2003_ = (_e976 + _e974);
                                phi_2005_ = fma((_e737 * _e974), _e978, -((_e976 * _e980)));
                            } else {
                                phi_2001_ = f32();
                                phi_2003_ = f32();
                                phi_2005_ = f32();
                            }
                            let _e1006 = phi_2001_;
                            let _e1008 = phi_2003_;
                            let _e1010 = phi_2005_;
                            continue;
                            continuing {
                                phi_1997_ = _e993;
                                phi_2000_ = _e1006;
                                phi_2002_ = _e1008;
                                phi_2004_ = _e1010;
                                phi_2006_ = _e978;
                                break if !(_e998);
                            }
                        }
                        let _e1013 = local_2;
                        let _e1014 = (_e1013 * _e554);
                        let _e1021 = select(1f, 0f, _e584);
                        if (_e588 == 0u) {
                            phi_2063_ = _e1021;
                        } else {
                            phi_2063_ = select(_e729, _e733, _e584);
                        }
                        let _e1025 = phi_2063_;
                        phi_2070_ = type_12(1u, _e588);
                        phi_2073_ = _e1025;
                        phi_2075_ = _e1021;
                        loop {
                            let _e1028 = phi_2070_;
                            let _e1030 = phi_2073_;
                            let _e1032 = phi_2075_;
                            local_22 = _e1030;
                            local_23 = _e1032;
                            if (_e1028.member < _e1028.member_1) {
                                phi_2071_ = type_12((_e1028.member + 1u), _e1028.member_1);
                                phi_2097_ = type_12(1u, _e1028.member);
                            } else {
                                phi_2071_ = _e1028;
                                phi_2097_ = type_12(0u, type_12().member_1);
                            }
                            let _e1045 = phi_2071_;
                            let _e1047 = phi_2097_;
                            let _e1050 = (bitcast<i32>(_e1047.member) != 0i);
                            if _e1050 {
                                phi_2074_ = fma(_e752, _e1030, -((_e755 * _e1032)));
                            } else {
                                phi_2074_ = f32();
                            }
                            let _e1055 = phi_2074_;
                            continue;
                            continuing {
                                phi_2070_ = _e1045;
                                phi_2073_ = _e1055;
                                phi_2075_ = _e1030;
                                break if !(_e1050);
                            }
                        }
                        phi_2112_ = type_12(_e588, _e581);
                        phi_2115_ = f32(((2u * _e588) + 1u));
                        phi_2117_ = 0f;
                        let _e1304 = local_22;
                        phi_2119_ = _e1304;
                        let _e1307 = local_23;
                        phi_2121_ = _e1307;
                        loop {
                            let _e1062 = phi_2112_;
                            let _e1064 = phi_2115_;
                            let _e1066 = phi_2117_;
                            let _e1068 = phi_2119_;
                            let _e1070 = phi_2121_;
                            local_3 = _e1068;
                            if (_e1062.member < _e1062.member_1) {
                                phi_2113_ = type_12((_e1062.member + 1u), _e1062.member_1);
                                phi_2143_ = type_12(1u, _e1062.member);
                            } else {
                                phi_2113_ = _e1062;
                                phi_2143_ = type_12(0u, type_12().member_1);
                            }
                            let _e1083 = phi_2113_;
                            let _e1085 = phi_2143_;
                            let _e1088 = (bitcast<i32>(_e1085.member) != 0i);
                            if _e1088 {
                                phi_2116_ = (_e1064 + 2f);
                                phi_2118_ = (_e1066 + _e1064);
                                phi_2120_ = fma((_e737 * _e1064), _e1068, -((_e1066 * _e1070)));
                            } else {
                                phi_2116_ = f32();
                                phi_2118_ = f32();
                                phi_2120_ = f32();
                            }
                            let _e1096 = phi_2116_;
                            let _e1098 = phi_2118_;
                            let _e1100 = phi_2120_;
                            continue;
                            continuing {
                                phi_2112_ = _e1083;
                                phi_2115_ = _e1096;
                                phi_2117_ = _e1098;
                                phi_2119_ = _e1100;
                                phi_2121_ = _e1068;
                                break if !(_e1088);
                            }
                        }
                        let _e1103 = local_3;
                        let _e1104 = (_e1103 * _e700);
                        phi_1657_ = array<f32, 12>(fma(_e740, _e834, _e705[0]), fma(_e740, _e924, _e705[1]), fma(_e740, _e1014, _e705[2]), fma(_e740, _e1104, _e705[3]), fma(_e743, _e834, _e705[4]), fma(_e743, _e924, _e705[5]), fma(_e743, _e1014, _e705[6]), fma(_e743, _e1104, _e705[7]), fma(_e746, _e834, _e705[8]), fma(_e746, _e924, _e705[9]), fma(_e746, _e1014, _e705[10]), fma(_e746, _e1104, _e705[11]));
                    } else {
                        phi_1657_ = array<f32, 12>();
                    }
                    let _e1113 = phi_1657_;
                    continue;
                    continuing {
                        phi_1653_ = _e718;
                        phi_1656_ = _e1113;
                        break if !(_e724);
                    }
                }
                let _e1117 = params.member.member_3;
                let _e1119 = local_4;
                let _e1123 = local_5;
                let _e1127 = local_6;
                let _e1131 = local_7;
                let _e1135 = local_8;
                let _e1139 = local_9;
                let _e1143 = local_10;
                let _e1147 = local_11;
                let _e1151 = local_12;
                let _e1155 = local_13;
                let _e1159 = local_14;
                let _e1163 = local_15;
                coefs.member[_e95] = (_e1119[0] * _e1117);
                coefs.member[(_e91 + _e95)] = (_e1123[1] * _e1117);
                coefs.member[((_e90 * 128u) + _e95)] = (_e1127[2] * _e1117);
                coefs.member[((_e90 * 192u) + _e95)] = (_e1131[3] * _e1117);
                coefs.member[((_e90 * 256u) + _e95)] = (_e1135[4] * _e1117);
                coefs.member[((_e90 * 320u) + _e95)] = (_e1139[5] * _e1117);
                coefs.member[((_e90 * 384u) + _e95)] = (_e1143[6] * _e1117);
                coefs.member[((_e90 * 448u) + _e95)] = (_e1147[7] * _e1117);
                coefs.member[((_e90 * 512u) + _e95)] = (_e1151[8] * _e1117);
                coefs.member[((_e90 * 576u) + _e95)] = (_e1155[9] * _e1117);
                coefs.member[((_e90 * 640u) + _e95)] = (_e1159[10] * _e1117);
                coefs.member[((_e90 * 704u) + _e95)] = (_e1163[11] * _e1117);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_project_rays(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
