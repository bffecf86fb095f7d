struct type_9 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
}

struct type_19 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
    member_4: vec4<f32>,
    member_5: vec4<f32>,
    member_6: array<u32, 4>,
    member_7: vec4<f32>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_29 {
    member: array<f32, 6>,
    member_1: array<u32, 3>,
    member_2: array<u32, 3>,
}

struct type_31 {
    member: array<type_29>,
}

struct type_33 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: f32,
    member_6: array<f32, 3>,
    member_7: f32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_37 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_49 {
    member: vec3<f32>,
    member_1: vec3<f32>,
    member_2: f32,
    member_3: f32,
}

struct type_53 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
}

struct type_58 {
    member: array<vec4<f32>>,
}

struct type_61 {
    member: f32,
    member_1: vec3<f32>,
    member_2: vec3<f32>,
}

struct type_62 {
    member: vec4<f32>,
    member_1: vec4<u32>,
    member_2: array<vec4<u32>, 10>,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: f32,
    member_8: f32,
    member_9: f32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: vec4<f32>,
    member_16: vec4<f32>,
    member_17: vec4<u32>,
}

struct type_63 {
    member: type_62,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> nodes: type_21;
@group(0) @binding(2) 
var<storage> triangles: type_25;
@group(0) @binding(3) 
var<storage> attributes: type_31;
@group(0) @binding(4) 
var<storage> surfaces: type_9;
@group(0) @binding(5) 
var<storage> lights: type_35;
@group(0) @binding(7) 
var<storage, read_write> out: type_58;
@group(0) @binding(0) 
var<uniform> params: type_63;
@group(0) @binding(6) 
var<storage> facets: type_39;

fn function_() {
    var local: array<u32, 64>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var phi_1356_: vec3<f32>;
    var phi_1363_: vec3<f32>;
    var phi_5331_: bool;
    var phi_1478_: type_13;
    var phi_1481_: vec3<f32>;
    var phi_1479_: type_13;
    var phi_1504_: type_13;
    var phi_1543_: u32;
    var phi_1546_: u32;
    var phi_1570_: u32;
    var phi_1544_: u32;
    var phi_1547_: u32;
    var phi_5327_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1587_: f32;
    var phi_5372_: bool;
    var phi_1597_: type_33;
    var phi_1598_: u32;
    var phi_1599_: f32;
    var phi_5371_: bool;
    var phi_1601_: type_33;
    var phi_1602_: u32;
    var phi_1603_: f32;
    var phi_1604_: bool;
    var phi_1636_: type_33;
    var phi_1637_: u32;
    var phi_1639_: type_33;
    var phi_1640_: u32;
    var phi_1641_: u32;
    var phi_1657_: bool;
    var phi_5367_: bool;
    var phi_1664_: type_13;
    var phi_1667_: f32;
    var phi_1669_: f32;
    var phi_1671_: f32;
    var phi_1665_: type_13;
    var phi_1694_: type_13;
    var phi_2288_: f32;
    var phi_4013_: f32;
    var phi_4021_: f32;
    var phi_2046_: vec2<f32>;
    var phi_2047_: bool;
    var phi_2177_: f32;
    var phi_2185_: f32;
    var phi_2111_: f32;
    var phi_2119_: f32;
    var phi_2189_: vec2<f32>;
    var phi_2190_: vec2<f32>;
    var phi_2289_: vec3<f32>;
    var phi_2290_: f32;
    var phi_2291_: f32;
    var phi_2292_: vec3<f32>;
    var phi_2293_: f32;
    var phi_2294_: bool;
    var phi_2314_: f32;
    var phi_2326_: type_49;
    var phi_1773_: vec3<f32>;
    var phi_1775_: vec3<f32>;
    var phi_1776_: bool;
    var phi_4029_: f32;
    var phi_4037_: f32;
    var phi_1850_: vec2<f32>;
    var phi_2328_: f32;
    var phi_2329_: vec3<f32>;
    var phi_2330_: f32;
    var phi_2331_: vec3<f32>;
    var phi_2332_: type_49;
    var phi_2333_: f32;
    var phi_2334_: bool;
    var phi_2354_: f32;
    var phi_2368_: type_49;
    var phi_2401_: bool;
    var phi_2411_: u32;
    var phi_2414_: bool;
    var phi_2425_: u32;
    var phi_2578_: f32;
    var phi_2586_: f32;
    var phi_2594_: f32;
    var phi_5345_: bool;
    var phi_2598_: u32;
    var phi_2601_: u32;
    var phi_3028_: type_13;
    var phi_3029_: type_13;
    var phi_3052_: type_13;
    var phi_3168_: f32;
    var phi_3179_: f32;
    var phi_3190_: f32;
    var phi_3205_: f32;
    var phi_3206_: f32;
    var phi_3207_: bool;
    var phi_3208_: f32;
    var phi_3209_: bool;
    var phi_3228_: f32;
    var phi_3229_: bool;
    var phi_3230_: f32;
    var phi_3231_: bool;
    var phi_3232_: bool;
    var phi_3237_: f32;
    var phi_3238_: bool;
    var phi_3324_: array<f32, 3>;
    var phi_3325_: array<f32, 3>;
    var phi_3326_: array<f32, 3>;
    var phi_3327_: array<f32, 3>;
    var phi_3328_: bool;
    var phi_3329_: array<f32, 3>;
    var phi_3330_: array<f32, 3>;
    var phi_3331_: bool;
    var phi_3332_: bool;
    var phi_3337_: array<f32, 3>;
    var phi_3342_: array<f32, 3>;
    var phi_3541_: f32;
    var phi_3556_: f32;
    var phi_3584_: u32;
    var phi_3594_: u32;
    var phi_3603_: bool;
    var phi_3619_: bool;
    var phi_3620_: bool;
    var phi_3643_: f32;
    var phi_3658_: f32;
    var phi_3686_: u32;
    var phi_3696_: u32;
    var phi_3705_: bool;
    var phi_3721_: bool;
    var phi_3722_: bool;
    var phi_3803_: bool;
    var phi_3808_: bool;
    var phi_3813_: type_53;
    var phi_3815_: type_53;
    var phi_3817_: bool;
    var phi_3818_: type_53;
    var phi_3820_: bool;
    var phi_3821_: bool;
    var phi_3822_: type_53;
    var phi_3823_: bool;
    var phi_3824_: bool;
    var phi_3825_: bool;
    var phi_3838_: type_53;
    var phi_3845_: bool;
    var phi_5341_: bool;
    var phi_4004_: bool;
    var phi_2988_: u32;
    var phi_3000_: u32;
    var phi_3012_: u32;
    var phi_3024_: u32;
    var phi_5478_: bool;
    var phi_3850_: u32;
    var phi_3851_: bool;
    var phi_3867_: u32;
    var phi_3868_: u32;
    var phi_2599_: u32;
    var phi_2602_: u32;
    var phi_3870_: bool;
    var phi_3871_: bool;
    var phi_5476_: bool;
    var phi_4005_: bool;
    var phi_3884_: f32;
    var phi_5538_: bool;
    var phi_3885_: f32;
    var phi_5537_: bool;
    var phi_1668_: f32;
    var phi_1670_: f32;
    var phi_1672_: f32;
    var phi_5536_: bool;
    var local_5: f32;
    var local_6: f32;
    var phi_3898_: f32;
    var local_7: f32;
    var phi_4347_: bool;
    var phi_4358_: bool;
    var phi_4379_: type_61;
    var phi_4383_: type_61;
    var phi_4384_: vec3<f32>;
    var phi_4385_: vec3<f32>;
    var phi_4425_: vec3<f32>;
    var phi_4428_: vec3<f32>;
    var phi_4429_: bool;
    var phi_4473_: vec3<f32>;
    var phi_4476_: vec3<f32>;
    var phi_4477_: bool;
    var phi_4544_: f32;
    var phi_4552_: f32;
    var phi_4567_: f32;
    var phi_4573_: f32;
    var phi_4581_: f32;
    var phi_4591_: f32;
    var phi_4596_: type_61;
    var phi_4606_: bool;
    var phi_4617_: bool;
    var phi_4638_: type_61;
    var phi_4642_: type_61;
    var phi_4643_: vec3<f32>;
    var phi_4644_: vec3<f32>;
    var phi_4684_: vec3<f32>;
    var phi_4687_: vec3<f32>;
    var phi_4688_: bool;
    var phi_4732_: vec3<f32>;
    var phi_4735_: vec3<f32>;
    var phi_4736_: bool;
    var phi_4803_: f32;
    var phi_4811_: f32;
    var phi_4826_: f32;
    var phi_4832_: f32;
    var phi_4840_: f32;
    var phi_4850_: f32;
    var phi_4855_: type_61;
    var phi_4865_: bool;
    var phi_4897_: type_61;
    var phi_4901_: type_61;
    var phi_4902_: vec3<f32>;
    var phi_4903_: vec3<f32>;
    var phi_4943_: vec3<f32>;
    var phi_4946_: vec3<f32>;
    var phi_4947_: bool;
    var phi_4991_: vec3<f32>;
    var phi_4994_: vec3<f32>;
    var phi_4995_: bool;
    var phi_5062_: f32;
    var phi_5070_: f32;
    var phi_5085_: f32;
    var phi_5091_: f32;
    var phi_5099_: f32;
    var phi_5109_: f32;
    var phi_5114_: type_61;
    var phi_5156_: vec3<f32>;
    var phi_5159_: vec3<f32>;
    var phi_5160_: bool;
    var phi_5204_: vec3<f32>;
    var phi_5207_: vec3<f32>;
    var phi_5208_: bool;
    var phi_5275_: f32;
    var phi_5283_: f32;
    var phi_5298_: f32;
    var phi_5304_: f32;
    var phi_5312_: f32;
    var phi_5322_: f32;
    var local_8: f32;
    var local_9: f32;
    var phi_3932_: f32;
    var phi_3933_: f32;
    var phi_3934_: bool;
    var local_10: f32;
    var phi_3942_: f32;
    var phi_3943_: f32;
    var phi_3952_: vec3<f32>;
    var phi_5544_: bool;
    var phi_3968_: vec3<f32>;
    var phi_5543_: bool;
    var phi_1482_: vec3<f32>;
    var phi_5542_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e119 = gid_1;
            let _e122 = arrayLength((&nodes.member));
            let _e131 = arrayLength((&surfaces.member));
            let _e133 = arrayLength((&lights.member));
            let _e141 = (_e119.x + (_e119.y * 2097152u));
            let _e142 = (_e141 < arrayLength((&out.member)));
            if _e142 {
                let _e143 = (_e141 / 2u);
                if (_e143 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e147 = facets.member[_e143];
                let _e157 = sqrt((((_e147.member_2[0] * _e147.member_2[0]) + (_e147.member_2[1] * _e147.member_2[1])) + (_e147.member_2[2] * _e147.member_2[2])));
                if (_e157 > 0.000000000001f) {
                    phi_1356_ = vec3<f32>((_e147.member_2[0] / _e157), (_e147.member_2[1] / _e157), (_e147.member_2[2] / _e157));
                } else {
                    phi_1356_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e164 = phi_1356_;
                if ((_e141 & 1u) == 0u) {
                    phi_1363_ = _e164;
                } else {
                    phi_1363_ = -(_e164);
                }
                let _e169 = phi_1363_;
                let _e174 = vec3<f32>(_e147.member[0], _e147.member[1], _e147.member[2]);
                let _e179 = (1f - (_e157 / select(0.000000000001f, _e147.member_1, (_e147.member_1 > 0.000000000001f))));
                let _e181 = select(0f, _e179, (_e179 > 0f));
                let _e190 = params.member.member[3u];
                let _e192 = abs(_e147.member[0]);
                let _e193 = abs(_e147.member[1]);
                let _e195 = select(_e193, _e192, (_e192 > _e193));
                let _e196 = abs(_e147.member[2]);
                let _e200 = (((0.001f + (0.61f * sqrt(select(0.5f, _e181, (_e181 < 0.5f))))) * _e190) + (0.00000023841858f * select(_e196, _e195, (_e195 > _e196))));
                let _e204 = params.member.member_17[0u];
                let _e208 = params.member.member_17[1u];
                let _e211 = params.member.member_15;
                let _e218 = params.member.member_17[2u];
                let _e222 = params.member.member_17[3u];
                let _e226 = ((_e141 ^ (_e141 >> bitcast<u32>(16i))) * 2146121005u);
                let _e230 = ((_e226 ^ (_e226 >> bitcast<u32>(15i))) * 2221713035u);
                let _e234 = (_e222 ^ (_e230 ^ (_e230 >> bitcast<u32>(16i))));
                let _e238 = ((_e234 ^ (_e234 >> bitcast<u32>(16i))) * 2146121005u);
                let _e242 = ((_e238 ^ (_e238 >> bitcast<u32>(15i))) * 2221713035u);
                let _e245 = (_e242 ^ (_e242 >> bitcast<u32>(16i)));
                let _e246 = (_e204 > 64u);
                let _e247 = select(_e204, _e208, _e246);
                let _e254 = ((_e245 ^ (_e245 >> bitcast<u32>(16i))) * 2146121005u);
                let _e258 = ((_e254 ^ (_e254 >> bitcast<u32>(15i))) * 2221713035u);
                let _e261 = (_e258 ^ (_e258 >> bitcast<u32>(16i)));
                phi_5331_ = false;
                phi_1478_ = type_13(0u, (_e247 + select(0u, 1u, (_e218 > 0u))));
                phi_1481_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e268 = phi_5331_;
                    let _e270 = phi_1478_;
                    let _e272 = phi_1481_;
                    local_11 = _e272;
                    local_12 = _e272;
                    local_13 = _e272;
                    if (_e270.member < _e270.member_1) {
                        phi_1479_ = type_13((_e270.member + 1u), _e270.member_1);
                        phi_1504_ = type_13(1u, _e270.member);
                    } else {
                        phi_1479_ = _e270;
                        phi_1504_ = type_13(0u, type_13().member_1);
                    }
                    let _e285 = phi_1479_;
                    let _e287 = phi_1504_;
                    let _e291 = (bitcast<i32>(_e287.member) != 0i);
                    if _e291 {
                        let _e297 = ((_e261 ^ (_e261 >> bitcast<u32>(16i))) * 2146121005u);
                        let _e301 = ((_e297 ^ (_e297 >> bitcast<u32>(15i))) * 2221713035u);
                        let _e305 = (_e287.member_1 < _e247);
                        if _e305 {
                            if _e246 {
                                let _e308 = f32(_e247);
                                phi_1543_ = (_e204 - 1u);
                                phi_1546_ = 0u;
                                loop {
                                    let _e312 = phi_1543_;
                                    let _e314 = phi_1546_;
                                    local_3 = _e314;
                                    local_4 = _e314;
                                    let _e315 = (_e314 < _e312);
                                    if _e315 {
                                        let _e317 = ((_e314 + _e312) / 2u);
                                        if (_e317 < _e133) {
                                        } else {
                                            phi_5327_ = true;
                                            break;
                                        }
                                        let _e322 = lights.member[_e317].member_5;
                                        let _e323 = (_e322 > ((f32(_e287.member_1) + (f32((_e261 >> bitcast<u32>(8i))) * 0.000000059604645f)) / _e308));
                                        if _e323 {
                                            phi_1570_ = _e314;
                                        } else {
                                            phi_1570_ = (_e317 + 1u);
                                        }
                                        let _e326 = phi_1570_;
                                        phi_1544_ = select(_e312, _e317, _e323);
                                        phi_1547_ = _e326;
                                    } else {
                                        phi_1544_ = u32();
                                        phi_1547_ = u32();
                                    }
                                    let _e329 = phi_1544_;
                                    let _e331 = phi_1547_;
                                    continue;
                                    continuing {
                                        phi_1543_ = _e329;
                                        phi_1546_ = _e331;
                                        phi_5327_ = _e268;
                                        break if !(_e315);
                                    }
                                }
                                let _e334 = phi_5327_;
                                phi_5542_ = _e334;
                                if _e334 {
                                    break;
                                }
                                let _e336 = local_3;
                                if (_e336 < _e133) {
                                } else {
                                    phi_5542_ = true;
                                    break;
                                }
                                let _e340 = local_4;
                                let _e342 = lights.member[_e340];
                                if (_e342.member_7 > 0f) {
                                    phi_1587_ = (1f / (_e342.member_7 * _e308));
                                } else {
                                    phi_1587_ = 0f;
                                }
                                let _e348 = phi_1587_;
                                let _e349 = (_e245 + _e287.member_1);
                                let _e353 = ((_e349 ^ (_e349 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e357 = ((_e353 ^ (_e353 >> bitcast<u32>(15i))) * 2221713035u);
                                phi_5372_ = _e334;
                                phi_1597_ = _e342;
                                phi_1598_ = (_e357 ^ (_e357 >> bitcast<u32>(16i)));
                                phi_1599_ = _e348;
                            } else {
                                phi_5372_ = _e268;
                                phi_1597_ = type_33();
                                phi_1598_ = u32();
                                phi_1599_ = f32();
                            }
                            let _e362 = phi_5372_;
                            let _e364 = phi_1597_;
                            let _e366 = phi_1598_;
                            let _e368 = phi_1599_;
                            phi_5371_ = _e362;
                            phi_1601_ = _e364;
                            phi_1602_ = _e366;
                            phi_1603_ = _e368;
                            phi_1604_ = select(true, false, _e246);
                        } else {
                            phi_5371_ = _e268;
                            phi_1601_ = type_33();
                            phi_1602_ = u32();
                            phi_1603_ = f32();
                            phi_1604_ = true;
                        }
                        let _e371 = phi_5371_;
                        let _e373 = phi_1601_;
                        let _e375 = phi_1602_;
                        let _e377 = phi_1603_;
                        let _e379 = phi_1604_;
                        if _e379 {
                            if _e305 {
                                if (_e287.member_1 < _e133) {
                                } else {
                                    phi_5542_ = true;
                                    break;
                                }
                                let _e383 = lights.member[_e287.member_1];
                                let _e387 = ((_e287.member_1 ^ (_e287.member_1 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e391 = ((_e387 ^ (_e387 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e395 = (_e245 ^ (_e391 ^ (_e391 >> bitcast<u32>(16i))));
                                let _e399 = ((_e395 ^ (_e395 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e403 = ((_e399 ^ (_e399 >> bitcast<u32>(15i))) * 2221713035u);
                                phi_1636_ = _e383;
                                phi_1637_ = (_e403 ^ (_e403 >> bitcast<u32>(16i)));
                            } else {
                                phi_1636_ = type_33(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(_e211.x, _e211.y, _e211.z), 1f);
                                phi_1637_ = (_e301 ^ (_e301 >> bitcast<u32>(16i)));
                            }
                            let _e408 = phi_1636_;
                            let _e410 = phi_1637_;
                            phi_1639_ = _e408;
                            phi_1640_ = _e410;
                            phi_1641_ = select(_e218, _e208, _e305);
                        } else {
                            phi_1639_ = _e373;
                            phi_1640_ = _e375;
                            phi_1641_ = 1u;
                        }
                        let _e413 = phi_1639_;
                        let _e415 = phi_1640_;
                        let _e417 = phi_1641_;
                        let _e418 = select(_e377, 1f, _e379);
                        if (_e418 > 0f) {
                            let _e421 = (_e413.member_1 == 3u);
                            if _e421 {
                                phi_1657_ = true;
                            } else {
                                phi_1657_ = (_e413.member_1 == 4294967295u);
                            }
                            let _e424 = phi_1657_;
                            let _e425 = select(1u, _e417, _e424);
                            phi_5367_ = _e371;
                            phi_1664_ = type_13(0u, _e425);
                            phi_1667_ = 340282350000000000000000000000000000000f;
                            phi_1669_ = 0f;
                            phi_1671_ = 0f;
                            loop {
                                let _e428 = phi_5367_;
                                let _e430 = phi_1664_;
                                let _e432 = phi_1667_;
                                let _e434 = phi_1669_;
                                let _e436 = phi_1671_;
                                local_5 = _e434;
                                local_6 = _e434;
                                local_14 = _e434;
                                local_7 = _e432;
                                local_8 = _e434;
                                local_9 = _e436;
                                local_10 = _e434;
                                if (_e430.member < _e430.member_1) {
                                    phi_1665_ = type_13((_e430.member + 1u), _e430.member_1);
                                    phi_1694_ = type_13(1u, _e430.member);
                                } else {
                                    phi_1665_ = _e430;
                                    phi_1694_ = type_13(0u, type_13().member_1);
                                }
                                let _e449 = phi_1665_;
                                let _e451 = phi_1694_;
                                let _e455 = (bitcast<i32>(_e451.member) != 0i);
                                if _e455 {
                                    let _e465 = (_e413.member[0] - _e147.member[0]);
                                    let _e466 = (_e413.member[1] - _e147.member[1]);
                                    let _e467 = (_e413.member[2] - _e147.member[2]);
                                    if _e421 {
                                        let _e799 = (_e413.member_2[0] - _e413.member[0]);
                                        let _e800 = (_e413.member_2[1] - _e413.member[1]);
                                        let _e801 = (_e413.member_2[2] - _e413.member[2]);
                                        let _e802 = (_e413.member_4[0] - _e413.member[0]);
                                        let _e803 = (_e413.member_4[1] - _e413.member[1]);
                                        let _e804 = (_e413.member_4[2] - _e413.member[2]);
                                        let _e807 = ((_e800 * _e804) - (_e803 * _e801));
                                        let _e810 = ((_e801 * _e802) - (_e804 * _e799));
                                        let _e813 = ((_e799 * _e803) - (_e802 * _e800));
                                        let _e814 = abs(_e807);
                                        let _e815 = abs(_e810);
                                        let _e817 = select(_e815, _e814, (_e814 > _e815));
                                        let _e818 = abs(_e813);
                                        let _e820 = select(_e818, _e817, (_e817 > _e818));
                                        if (_e820 > 0.000000000000000000000000000000000000011754944f) {
                                            let _e822 = (_e820 < 340282350000000000000000000000000000000f);
                                            if _e822 {
                                                let _e823 = (_e807 / _e820);
                                                let _e824 = (_e810 / _e820);
                                                let _e825 = (_e813 / _e820);
                                                let _e831 = sqrt((((_e823 * _e823) + (_e824 * _e824)) + (_e825 * _e825)));
                                                phi_1773_ = vec3<f32>((_e823 / _e831), (_e824 / _e831), (_e825 / _e831));
                                            } else {
                                                phi_1773_ = vec3<f32>();
                                            }
                                            let _e837 = phi_1773_;
                                            phi_1775_ = _e837;
                                            phi_1776_ = select(true, false, _e822);
                                        } else {
                                            phi_1775_ = vec3<f32>();
                                            phi_1776_ = true;
                                        }
                                        let _e840 = phi_1775_;
                                        let _e842 = phi_1776_;
                                        let _e844 = select(_e840, vec3<f32>(0f, 0f, 0f), vec3(_e842));
                                        let _e855 = (((_e844.x * (_e147.member[0] - _e413.member[0])) + (_e844.y * (_e147.member[1] - _e413.member[1]))) + (_e844.z * (_e147.member[2] - _e413.member[2])));
                                        let _e861 = ((_e415 ^ (_e415 >> bitcast<u32>(16i))) * 2146121005u);
                                        let _e865 = ((_e861 ^ (_e861 >> bitcast<u32>(15i))) * 2221713035u);
                                        let _e872 = (_e415 ^ 2654435769u);
                                        let _e876 = ((_e872 ^ (_e872 >> bitcast<u32>(16i))) * 2146121005u);
                                        let _e880 = ((_e876 ^ (_e876 >> bitcast<u32>(15i))) * 2221713035u);
                                        let _e898 = (0.000000059604645f * (f32(((2147483648u + (_e451.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e865 ^ (_e865 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                        if (_e898 >= 1f) {
                                            phi_4029_ = (_e898 - 1f);
                                        } else {
                                            phi_4029_ = _e898;
                                        }
                                        let _e902 = phi_4029_;
                                        let _e904 = (0.000000059604645f * (f32(((2147483648u + (_e451.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e880 ^ (_e880 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                        if (_e904 >= 1f) {
                                            phi_4037_ = (_e904 - 1f);
                                        } else {
                                            phi_4037_ = _e904;
                                        }
                                        let _e908 = phi_4037_;
                                        if (_e902 < _e908) {
                                            let _e913 = (0.5f * _e902);
                                            phi_1850_ = vec2<f32>(_e913, (_e908 - _e913));
                                        } else {
                                            let _e910 = (0.5f * _e908);
                                            phi_1850_ = vec2<f32>((_e902 - _e910), _e910);
                                        }
                                        let _e917 = phi_1850_;
                                        let _e929 = ((_e413.member[0] + (_e799 * _e917.x)) + (_e802 * _e917.y));
                                        let _e930 = ((_e413.member[1] + (_e800 * _e917.x)) + (_e803 * _e917.y));
                                        let _e931 = ((_e413.member[2] + (_e801 * _e917.x)) + (_e804 * _e917.y));
                                        let _e932 = abs(_e929);
                                        let _e933 = abs(_e930);
                                        let _e935 = select(_e933, _e932, (_e932 > _e933));
                                        let _e936 = abs(_e931);
                                        let _e942 = ((select(_e936, _e935, (_e935 > _e936)) + sqrt(_e413.member_3)) * 0.0000009536743f);
                                        let _e946 = (_e929 + (_e844.x * _e942));
                                        let _e947 = (_e930 + (_e844.y * _e942));
                                        let _e948 = (_e931 + (_e844.z * _e942));
                                        let _e954 = (_e929 - _e147.member[0]);
                                        let _e955 = (_e930 - _e147.member[1]);
                                        let _e956 = (_e931 - _e147.member[2]);
                                        let _e961 = (((_e954 * _e954) + (_e955 * _e955)) + (_e956 * _e956));
                                        let _e969 = (((_e169.x * _e954) + (_e169.y * _e955)) + (_e169.z * _e956));
                                        let _e973 = (_e961 * _e961);
                                        phi_2328_ = ((select(0f, _e969, (_e969 > 0f)) * select(0f, _e855, (_e855 > 0f))) / select(0.000000000000000000000000000000000000011754944f, _e973, (_e973 > 0.000000000000000000000000000000000000011754944f)));
                                        phi_2329_ = vec3<f32>((_e946 - _e147.member[0]), (_e947 - _e147.member[1]), (_e948 - _e147.member[2]));
                                        phi_2330_ = _e961;
                                        phi_2331_ = vec3<f32>(_e946, _e947, _e948);
                                        phi_2332_ = type_49();
                                        phi_2333_ = f32();
                                        phi_2334_ = true;
                                    } else {
                                        if (_e413.member_1 == 2u) {
                                            let _e747 = -(_e413.member_2[0]);
                                            let _e748 = -(_e413.member_2[1]);
                                            let _e749 = -(_e413.member_2[2]);
                                            let _e758 = (((_e169.x * _e747) + (_e169.y * _e748)) + (_e169.z * _e749));
                                            phi_2291_ = select(0f, _e758, (_e758 > 0f));
                                            phi_2292_ = vec3<f32>(_e747, _e748, _e749);
                                            phi_2293_ = f32();
                                            phi_2294_ = true;
                                        } else {
                                            let _e470 = (_e413.member_1 == 4294967295u);
                                            if _e470 {
                                                let _e523 = bitcast<f32>((1065353216u | (bitcast<u32>(_e169.z) & 2147483648u)));
                                                let _e525 = (-1f / (_e523 + _e169.z));
                                                let _e529 = ((_e169.x * _e169.y) * _e525);
                                                let _e544 = ((_e415 ^ (_e415 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e548 = ((_e544 ^ (_e544 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e555 = (_e415 ^ 2654435769u);
                                                let _e559 = ((_e555 ^ (_e555 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e563 = ((_e559 ^ (_e559 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e581 = (0.000000059604645f * (f32(((2147483648u + (_e451.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e548 ^ (_e548 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e581 >= 1f) {
                                                    phi_4013_ = (_e581 - 1f);
                                                } else {
                                                    phi_4013_ = _e581;
                                                }
                                                let _e585 = phi_4013_;
                                                let _e587 = (0.000000059604645f * (f32(((2147483648u + (_e451.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e563 ^ (_e563 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e587 >= 1f) {
                                                    phi_4021_ = (_e587 - 1f);
                                                } else {
                                                    phi_4021_ = _e587;
                                                }
                                                let _e591 = phi_4021_;
                                                let _e593 = ((2f * _e585) - 1f);
                                                let _e595 = ((2f * _e591) - 1f);
                                                if (_e593 == 0f) {
                                                    let _e597 = (_e595 == 0f);
                                                    phi_2046_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e597));
                                                    phi_2047_ = select(true, false, _e597);
                                                } else {
                                                    phi_2046_ = vec2<f32>();
                                                    phi_2047_ = true;
                                                }
                                                let _e602 = phi_2046_;
                                                let _e604 = phi_2047_;
                                                if _e604 {
                                                    if (abs(_e593) > abs(_e595)) {
                                                        let _e661 = (_e595 / _e593);
                                                        let _e665 = floor(((_e661 * 0.5f) + 0.5f));
                                                        let _e671 = ((((0.7853982f * _e661) - (_e665 * 1.5703125f)) - (_e665 * 0.0004837513f)) - (_e665 * 0.0000000754979f));
                                                        let _e672 = (_e671 * _e671);
                                                        let _e679 = (_e671 + ((_e671 * _e672) * (-0.16666655f + (_e672 * (0.008332161f + (_e672 * -0.00019515296f))))));
                                                        let _e688 = ((1f - (0.5f * _e672)) + ((_e672 * _e672) * (0.041666646f + (_e672 * (-0.0013887316f + (_e672 * 0.000024433157f))))));
                                                        let _e695 = select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < -2147483600f)), 2147483647i, (_e665 > 2147483500f)), (_e665 == _e665));
                                                        let _e697 = ((_e695 & 1i) == 0i);
                                                        let _e698 = select(_e688, _e679, _e697);
                                                        let _e699 = select(_e679, _e688, _e697);
                                                        if ((_e695 & 2i) == 0i) {
                                                            phi_2111_ = _e698;
                                                        } else {
                                                            phi_2111_ = -(_e698);
                                                        }
                                                        let _e704 = phi_2111_;
                                                        if (((_e695 + 1i) & 2i) == 0i) {
                                                            phi_2119_ = _e699;
                                                        } else {
                                                            phi_2119_ = -(_e699);
                                                        }
                                                        let _e710 = phi_2119_;
                                                        phi_2189_ = vec2<f32>((_e593 * _e710), (_e593 * _e704));
                                                    } else {
                                                        let _e608 = (_e593 / _e595);
                                                        let _e612 = floor(((_e608 * 0.5f) + 0.5f));
                                                        let _e618 = ((((0.7853982f * _e608) - (_e612 * 1.5703125f)) - (_e612 * 0.0004837513f)) - (_e612 * 0.0000000754979f));
                                                        let _e619 = (_e618 * _e618);
                                                        let _e626 = (_e618 + ((_e618 * _e619) * (-0.16666655f + (_e619 * (0.008332161f + (_e619 * -0.00019515296f))))));
                                                        let _e635 = ((1f - (0.5f * _e619)) + ((_e619 * _e619) * (0.041666646f + (_e619 * (-0.0013887316f + (_e619 * 0.000024433157f))))));
                                                        let _e642 = select(0i, select(select(i32(_e612), i32(-2147483648), (_e612 < -2147483600f)), 2147483647i, (_e612 > 2147483500f)), (_e612 == _e612));
                                                        let _e644 = ((_e642 & 1i) == 0i);
                                                        let _e645 = select(_e635, _e626, _e644);
                                                        let _e646 = select(_e626, _e635, _e644);
                                                        if ((_e642 & 2i) == 0i) {
                                                            phi_2177_ = _e645;
                                                        } else {
                                                            phi_2177_ = -(_e645);
                                                        }
                                                        let _e651 = phi_2177_;
                                                        if (((_e642 + 1i) & 2i) == 0i) {
                                                            phi_2185_ = _e646;
                                                        } else {
                                                            phi_2185_ = -(_e646);
                                                        }
                                                        let _e657 = phi_2185_;
                                                        phi_2189_ = vec2<f32>((_e595 * _e651), (_e595 * _e657));
                                                    }
                                                    let _e715 = phi_2189_;
                                                    phi_2190_ = _e715;
                                                } else {
                                                    phi_2190_ = _e602;
                                                }
                                                let _e717 = phi_2190_;
                                                let _e723 = (1f - ((_e717.x * _e717.x) + (_e717.y * _e717.y)));
                                                let _e726 = sqrt(select(0f, _e723, (_e723 > 0f)));
                                                phi_2289_ = vec3<f32>(((((1f + (((_e523 * _e169.x) * _e169.x) * _e525)) * _e717.x) + (_e529 * _e717.y)) + (_e169.x * _e726)), ((((_e523 * _e529) * _e717.x) + ((_e523 + ((_e169.y * _e169.y) * _e525)) * _e717.y)) + (_e169.y * _e726)), ((((-(_e523) * _e169.x) * _e717.x) + (-(_e169.y) * _e717.y)) + (_e169.z * _e726)));
                                                phi_2290_ = f32();
                                            } else {
                                                let _e476 = sqrt((((_e465 * _e465) + (_e466 * _e466)) + (_e467 * _e467)));
                                                let _e484 = (((_e169.x * _e465) + (_e169.y * _e466)) + (_e169.z * _e467));
                                                let _e488 = ((_e476 * _e476) * _e476);
                                                let _e491 = (select(0f, _e484, (_e484 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e488, (_e488 > 0.000000000000000000000000000000000000011754944f)));
                                                if (_e413.member_1 == 1u) {
                                                    let _e507 = (_e413.member_4[0] - _e413.member_4[1]);
                                                    let _e510 = (((-((((_e465 * _e413.member_2[0]) + (_e466 * _e413.member_2[1])) + (_e467 * _e413.member_2[2]))) / select(0.000000000000000000000000000000000000011754944f, _e476, (_e476 > 0.000000000000000000000000000000000000011754944f))) - _e413.member_4[1]) / select(0.001f, _e507, (_e507 > 0.001f)));
                                                    let _e512 = select(0f, _e510, (_e510 > 0f));
                                                    let _e514 = select(1f, _e512, (_e512 < 1f));
                                                    phi_2288_ = (_e491 * (_e514 * _e514));
                                                } else {
                                                    phi_2288_ = _e491;
                                                }
                                                let _e518 = phi_2288_;
                                                phi_2289_ = vec3<f32>();
                                                phi_2290_ = _e518;
                                            }
                                            let _e744 = phi_2289_;
                                            let _e746 = phi_2290_;
                                            phi_2291_ = 1f;
                                            phi_2292_ = _e744;
                                            phi_2293_ = _e746;
                                            phi_2294_ = _e470;
                                        }
                                        let _e762 = phi_2291_;
                                        let _e764 = phi_2292_;
                                        let _e766 = phi_2293_;
                                        let _e768 = phi_2294_;
                                        if _e768 {
                                            if ((((_e169.x * _e764.x) + (_e169.y * _e764.y)) + (_e169.z * _e764.z)) < 0f) {
                                                phi_2314_ = -(_e200);
                                            } else {
                                                phi_2314_ = _e200;
                                            }
                                            let _e783 = phi_2314_;
                                            phi_2326_ = type_49(vec3<f32>((_e147.member[0] + (_e169.x * _e783)), (_e147.member[1] + (_e169.y * _e783)), (_e147.member[2] + (_e169.z * _e783))), _e764, 0f, 340282350000000000000000000000000000000f);
                                        } else {
                                            phi_2326_ = type_49();
                                        }
                                        let _e793 = phi_2326_;
                                        phi_2328_ = _e766;
                                        phi_2329_ = vec3<f32>(_e465, _e466, _e467);
                                        phi_2330_ = 340282350000000000000000000000000000000f;
                                        phi_2331_ = vec3<f32>(_e413.member[0], _e413.member[1], _e413.member[2]);
                                        phi_2332_ = _e793;
                                        phi_2333_ = _e762;
                                        phi_2334_ = select(true, false, _e768);
                                    }
                                    let _e978 = phi_2328_;
                                    let _e980 = phi_2329_;
                                    let _e982 = phi_2330_;
                                    let _e984 = phi_2331_;
                                    let _e986 = phi_2332_;
                                    let _e988 = phi_2333_;
                                    let _e990 = phi_2334_;
                                    if _e990 {
                                        if ((((_e169.x * _e980.x) + (_e169.y * _e980.y)) + (_e169.z * _e980.z)) < 0f) {
                                            phi_2354_ = -(_e200);
                                        } else {
                                            phi_2354_ = _e200;
                                        }
                                        let _e1005 = phi_2354_;
                                        let _e1012 = vec3<f32>((_e147.member[0] + (_e169.x * _e1005)), (_e147.member[1] + (_e169.y * _e1005)), (_e147.member[2] + (_e169.z * _e1005)));
                                        phi_2368_ = type_49(_e1012, (_e984 - _e1012), 0f, 0.9999995f);
                                    } else {
                                        phi_2368_ = _e986;
                                    }
                                    let _e1016 = phi_2368_;
                                    let _e1017 = select(_e988, _e978, _e990);
                                    let _e1018 = select(340282350000000000000000000000000000000f, _e982, _e990);
                                    if (_e1017 > 0f) {
                                        let _e1025 = abs(_e1016.member_1.x);
                                        let _e1028 = abs(_e1016.member_1.y);
                                        let _e1031 = abs(_e1016.member_1.z);
                                        let _e1032 = (_e1025 > _e1028);
                                        if _e1032 {
                                            phi_2401_ = (_e1025 > _e1031);
                                        } else {
                                            phi_2401_ = (_e1028 > _e1031);
                                        }
                                        let _e1036 = phi_2401_;
                                        let _e1037 = select(1u, 0u, _e1032);
                                        if _e1036 {
                                            let _e1038 = (_e1037 + 1u);
                                            phi_2411_ = _e1038;
                                            phi_2414_ = select(true, false, (_e1038 == 2u));
                                        } else {
                                            phi_2411_ = u32();
                                            phi_2414_ = false;
                                        }
                                        let _e1042 = phi_2411_;
                                        let _e1044 = phi_2414_;
                                        let _e1045 = select(true, false, _e1036);
                                        let _e1046 = select(_e1042, 0u, _e1045);
                                        let _e1048 = select(_e1044, true, _e1045);
                                        if _e1048 {
                                            phi_2425_ = (_e1046 + 1u);
                                        } else {
                                            phi_2425_ = 0u;
                                        }
                                        let _e1051 = phi_2425_;
                                        let _e1052 = select(_e1042, _e1046, _e1048);
                                        let _e1053 = select(_e1037, select(_e1037, 2u, _e1045), _e1048);
                                        local_1 = array<f32, 3>(_e1016.member_1.x, _e1016.member_1.y, _e1016.member_1.z);
                                        local_2 = array<f32, 3>(_e1016.member.x, _e1016.member.y, _e1016.member.z);
                                        let _e1062 = (_e1053 < 3u);
                                        if _e1062 {
                                        } else {
                                            phi_5536_ = true;
                                            break;
                                        }
                                        let _e1064 = local_1[_e1053];
                                        let _e1065 = (1f / _e1064);
                                        let _e1066 = (_e1052 < 3u);
                                        if _e1066 {
                                        } else {
                                            phi_5536_ = true;
                                            break;
                                        }
                                        let _e1068 = local_1[_e1052];
                                        let _e1069 = (_e1068 * _e1065);
                                        let _e1070 = (_e1051 < 3u);
                                        if _e1070 {
                                        } else {
                                            phi_5536_ = true;
                                            break;
                                        }
                                        let _e1072 = local_1[_e1051];
                                        let _e1073 = (_e1072 * _e1065);
                                        if _e1066 {
                                        } else {
                                            phi_5536_ = true;
                                            break;
                                        }
                                        let _e1075 = local_2[_e1052];
                                        if _e1070 {
                                        } else {
                                            phi_5536_ = true;
                                            break;
                                        }
                                        let _e1077 = local_2[_e1051];
                                        if _e1062 {
                                        } else {
                                            phi_5536_ = true;
                                            break;
                                        }
                                        let _e1079 = local_2[_e1053];
                                        if (0u < _e122) {
                                        } else {
                                            phi_5536_ = true;
                                            break;
                                        }
                                        let _e1084 = nodes.member[0u].member_7[0u];
                                        let _e1088 = nodes.member[0u].member_7[1u];
                                        let _e1092 = nodes.member[0u].member_7[2u];
                                        let _e1096 = nodes.member[0u].member_7[3u];
                                        let _e1098 = abs((_e1016.member.x - _e1084));
                                        let _e1100 = abs((_e1016.member.y - _e1088));
                                        let _e1102 = select(_e1100, _e1098, (_e1098 > _e1100));
                                        let _e1104 = abs((_e1016.member.z - _e1092));
                                        let _e1108 = ((select(_e1104, _e1102, (_e1102 > _e1104)) + _e1096) * 0.0000009536743f);
                                        let _e1115 = (_e1108 + (abs(_e1016.member.x) * 0.00000023841858f));
                                        let _e1116 = (_e1108 + (abs(_e1016.member.y) * 0.00000023841858f));
                                        let _e1117 = (_e1108 + (abs(_e1016.member.z) * 0.00000023841858f));
                                        let _e1118 = select(_e1028, _e1025, _e1032);
                                        let _e1120 = select(_e1031, _e1118, (_e1118 > _e1031));
                                        let _e1121 = (_e1120 * 0.000000000001f);
                                        let _e1124 = (_e1016.member.x + _e1115);
                                        let _e1126 = (_e1016.member.y + _e1116);
                                        let _e1128 = (_e1016.member.z + _e1117);
                                        let _e1129 = (_e1016.member.x - _e1115);
                                        let _e1130 = (_e1016.member.y - _e1116);
                                        let _e1131 = (_e1016.member.z - _e1117);
                                        if (_e1025 > _e1121) {
                                            phi_2578_ = (1f / _e1016.member_1.x);
                                        } else {
                                            phi_2578_ = (1000000000000f / _e1120);
                                        }
                                        let _e1136 = phi_2578_;
                                        if (_e1028 > _e1121) {
                                            phi_2586_ = (1f / _e1016.member_1.y);
                                        } else {
                                            phi_2586_ = (1000000000000f / _e1120);
                                        }
                                        let _e1141 = phi_2586_;
                                        if (_e1031 > _e1121) {
                                            phi_2594_ = (1f / _e1016.member_1.z);
                                        } else {
                                            phi_2594_ = (1000000000000f / _e1120);
                                        }
                                        let _e1146 = phi_2594_;
                                        local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_5345_ = _e428;
                                        phi_2598_ = 0u;
                                        phi_2601_ = 0u;
                                        loop {
                                            let _e1150 = phi_5345_;
                                            let _e1152 = phi_2598_;
                                            let _e1154 = phi_2601_;
                                            let _e1155 = (_e1152 & 15u);
                                            let _e1157 = (_e1152 >> bitcast<u32>(4u));
                                            if (_e1155 == 0u) {
                                                if (_e1157 < _e122) {
                                                } else {
                                                    phi_5476_ = true;
                                                    phi_4005_ = bool();
                                                    break;
                                                }
                                                let _e1857 = nodes.member[_e1157].member;
                                                let _e1866 = ((_e1857.x - _e1124) * _e1136);
                                                let _e1867 = ((_e1857.y - _e1124) * _e1136);
                                                let _e1868 = ((_e1857.z - _e1124) * _e1136);
                                                let _e1869 = ((_e1857.w - _e1124) * _e1136);
                                                let _e1872 = nodes.member[_e1157].member_3;
                                                let _e1881 = ((_e1872.x - _e1129) * _e1136);
                                                let _e1882 = ((_e1872.y - _e1129) * _e1136);
                                                let _e1883 = ((_e1872.z - _e1129) * _e1136);
                                                let _e1884 = ((_e1872.w - _e1129) * _e1136);
                                                let _e1887 = nodes.member[_e1157].member_1;
                                                let _e1896 = ((_e1887.x - _e1126) * _e1141);
                                                let _e1897 = ((_e1887.y - _e1126) * _e1141);
                                                let _e1898 = ((_e1887.z - _e1126) * _e1141);
                                                let _e1899 = ((_e1887.w - _e1126) * _e1141);
                                                let _e1902 = nodes.member[_e1157].member_4;
                                                let _e1911 = ((_e1902.x - _e1130) * _e1141);
                                                let _e1912 = ((_e1902.y - _e1130) * _e1141);
                                                let _e1913 = ((_e1902.z - _e1130) * _e1141);
                                                let _e1914 = ((_e1902.w - _e1130) * _e1141);
                                                let _e1917 = nodes.member[_e1157].member_2;
                                                let _e1926 = ((_e1917.x - _e1128) * _e1146);
                                                let _e1927 = ((_e1917.y - _e1128) * _e1146);
                                                let _e1928 = ((_e1917.z - _e1128) * _e1146);
                                                let _e1929 = ((_e1917.w - _e1128) * _e1146);
                                                let _e1932 = nodes.member[_e1157].member_5;
                                                let _e1941 = ((_e1932.x - _e1131) * _e1146);
                                                let _e1942 = ((_e1932.y - _e1131) * _e1146);
                                                let _e1943 = ((_e1932.z - _e1131) * _e1146);
                                                let _e1944 = ((_e1932.w - _e1131) * _e1146);
                                                let _e1946 = select(_e1881, _e1866, (_e1866 < _e1881));
                                                let _e1948 = select(_e1882, _e1867, (_e1867 < _e1882));
                                                let _e1950 = select(_e1883, _e1868, (_e1868 < _e1883));
                                                let _e1952 = select(_e1884, _e1869, (_e1869 < _e1884));
                                                let _e1954 = select(_e1911, _e1896, (_e1896 < _e1911));
                                                let _e1956 = select(_e1912, _e1897, (_e1897 < _e1912));
                                                let _e1958 = select(_e1913, _e1898, (_e1898 < _e1913));
                                                let _e1960 = select(_e1914, _e1899, (_e1899 < _e1914));
                                                let _e1962 = select(_e1954, _e1946, (_e1946 > _e1954));
                                                let _e1964 = select(_e1956, _e1948, (_e1948 > _e1956));
                                                let _e1966 = select(_e1958, _e1950, (_e1950 > _e1958));
                                                let _e1968 = select(_e1960, _e1952, (_e1952 > _e1960));
                                                let _e1970 = select(_e1941, _e1926, (_e1926 < _e1941));
                                                let _e1972 = select(_e1942, _e1927, (_e1927 < _e1942));
                                                let _e1974 = select(_e1943, _e1928, (_e1928 < _e1943));
                                                let _e1976 = select(_e1944, _e1929, (_e1929 < _e1944));
                                                let _e1978 = select(_e1970, _e1962, (_e1962 > _e1970));
                                                let _e1980 = select(_e1972, _e1964, (_e1964 > _e1972));
                                                let _e1982 = select(_e1974, _e1966, (_e1966 > _e1974));
                                                let _e1984 = select(_e1976, _e1968, (_e1968 > _e1976));
                                                let _e1986 = select(_e1016.member_2, _e1978, (_e1978 > _e1016.member_2));
                                                let _e1988 = select(_e1016.member_2, _e1980, (_e1980 > _e1016.member_2));
                                                let _e1990 = select(_e1016.member_2, _e1982, (_e1982 > _e1016.member_2));
                                                let _e1992 = select(_e1016.member_2, _e1984, (_e1984 > _e1016.member_2));
                                                let _e1994 = select(_e1881, _e1866, (_e1866 > _e1881));
                                                let _e1996 = select(_e1882, _e1867, (_e1867 > _e1882));
                                                let _e1998 = select(_e1883, _e1868, (_e1868 > _e1883));
                                                let _e2000 = select(_e1884, _e1869, (_e1869 > _e1884));
                                                let _e2002 = select(_e1911, _e1896, (_e1896 > _e1911));
                                                let _e2004 = select(_e1912, _e1897, (_e1897 > _e1912));
                                                let _e2006 = select(_e1913, _e1898, (_e1898 > _e1913));
                                                let _e2008 = select(_e1914, _e1899, (_e1899 > _e1914));
                                                let _e2010 = select(_e2002, _e1994, (_e1994 < _e2002));
                                                let _e2012 = select(_e2004, _e1996, (_e1996 < _e2004));
                                                let _e2014 = select(_e2006, _e1998, (_e1998 < _e2006));
                                                let _e2016 = select(_e2008, _e2000, (_e2000 < _e2008));
                                                let _e2018 = select(_e1941, _e1926, (_e1926 > _e1941));
                                                let _e2020 = select(_e1942, _e1927, (_e1927 > _e1942));
                                                let _e2022 = select(_e1943, _e1928, (_e1928 > _e1943));
                                                let _e2024 = select(_e1944, _e1929, (_e1929 > _e1944));
                                                let _e2026 = select(_e2018, _e2010, (_e2010 < _e2018));
                                                let _e2028 = select(_e2020, _e2012, (_e2012 < _e2020));
                                                let _e2030 = select(_e2022, _e2014, (_e2014 < _e2022));
                                                let _e2032 = select(_e2024, _e2016, (_e2016 < _e2024));
                                                let _e2052 = nodes.member[_e1157].member_6[0u];
                                                let _e2056 = nodes.member[_e1157].member_6[1u];
                                                let _e2060 = nodes.member[_e1157].member_6[2u];
                                                let _e2064 = nodes.member[_e1157].member_6[3u];
                                                if (select(340282350000000000000000000000000000000f, _e1992, (_e1992 <= select(_e1016.member_3, _e2032, (_e2032 < _e1016.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e1154 < 64u) {
                                                    } else {
                                                        phi_5476_ = true;
                                                        phi_4005_ = bool();
                                                        break;
                                                    }
                                                    local[_e1154] = _e2064;
                                                    phi_2988_ = (_e1154 + 1u);
                                                } else {
                                                    phi_2988_ = _e1154;
                                                }
                                                let _e2070 = phi_2988_;
                                                if (select(340282350000000000000000000000000000000f, _e1990, (_e1990 <= select(_e1016.member_3, _e2030, (_e2030 < _e1016.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2070 < 64u) {
                                                    } else {
                                                        phi_5476_ = true;
                                                        phi_4005_ = bool();
                                                        break;
                                                    }
                                                    local[_e2070] = _e2060;
                                                    phi_3000_ = (_e2070 + 1u);
                                                } else {
                                                    phi_3000_ = _e2070;
                                                }
                                                let _e2076 = phi_3000_;
                                                if (select(340282350000000000000000000000000000000f, _e1988, (_e1988 <= select(_e1016.member_3, _e2028, (_e2028 < _e1016.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2076 < 64u) {
                                                    } else {
                                                        phi_5476_ = true;
                                                        phi_4005_ = bool();
                                                        break;
                                                    }
                                                    local[_e2076] = _e2056;
                                                    phi_3012_ = (_e2076 + 1u);
                                                } else {
                                                    phi_3012_ = _e2076;
                                                }
                                                let _e2082 = phi_3012_;
                                                if (select(340282350000000000000000000000000000000f, _e1986, (_e1986 <= select(_e1016.member_3, _e2026, (_e2026 < _e1016.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2082 < 64u) {
                                                    } else {
                                                        phi_5476_ = true;
                                                        phi_4005_ = bool();
                                                        break;
                                                    }
                                                    local[_e2082] = _e2052;
                                                    phi_3024_ = (_e2082 + 1u);
                                                } else {
                                                    phi_3024_ = _e2082;
                                                }
                                                let _e2088 = phi_3024_;
                                                phi_5478_ = _e1150;
                                                phi_3850_ = _e2088;
                                                phi_3851_ = true;
                                            } else {
                                                phi_3028_ = type_13(_e1157, (_e1157 + _e1155));
                                                loop {
                                                    let _e1162 = phi_3028_;
                                                    if (_e1162.member < _e1162.member_1) {
                                                        phi_3029_ = type_13((_e1162.member + 1u), _e1162.member_1);
                                                        phi_3052_ = type_13(1u, _e1162.member);
                                                    } else {
                                                        phi_3029_ = _e1162;
                                                        phi_3052_ = type_13(0u, type_13().member_1);
                                                    }
                                                    let _e1175 = phi_3029_;
                                                    let _e1177 = phi_3052_;
                                                    let _e1181 = (bitcast<i32>(_e1177.member) != 0i);
                                                    if _e1181 {
                                                        let _e1182 = (_e1177.member_1 < arrayLength((&triangles.member)));
                                                        if _e1182 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        if _e1062 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        let _e1186 = triangles.member[_e1177.member_1].member[_e1053];
                                                        let _e1187 = (_e1186 - _e1079);
                                                        if _e1062 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        let _e1191 = triangles.member[_e1177.member_1].member_2[_e1053];
                                                        let _e1192 = (_e1191 - _e1079);
                                                        if _e1062 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        let _e1196 = triangles.member[_e1177.member_1].member_4[_e1053];
                                                        let _e1197 = (_e1196 - _e1079);
                                                        if _e1066 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        let _e1201 = triangles.member[_e1177.member_1].member[_e1052];
                                                        let _e1204 = ((_e1201 - _e1075) - (_e1069 * _e1187));
                                                        if _e1070 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        let _e1208 = triangles.member[_e1177.member_1].member[_e1051];
                                                        let _e1211 = ((_e1208 - _e1077) - (_e1073 * _e1187));
                                                        if _e1066 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        let _e1215 = triangles.member[_e1177.member_1].member_2[_e1052];
                                                        let _e1218 = ((_e1215 - _e1075) - (_e1069 * _e1192));
                                                        if _e1070 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        let _e1222 = triangles.member[_e1177.member_1].member_2[_e1051];
                                                        let _e1225 = ((_e1222 - _e1077) - (_e1073 * _e1192));
                                                        if _e1066 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        let _e1229 = triangles.member[_e1177.member_1].member_4[_e1052];
                                                        let _e1232 = ((_e1229 - _e1075) - (_e1069 * _e1197));
                                                        if _e1070 {
                                                        } else {
                                                            phi_5341_ = true;
                                                            phi_4004_ = bool();
                                                            break;
                                                        }
                                                        let _e1236 = triangles.member[_e1177.member_1].member_4[_e1051];
                                                        let _e1239 = ((_e1236 - _e1077) - (_e1073 * _e1197));
                                                        let _e1240 = (_e1232 * _e1225);
                                                        let _e1241 = (_e1239 * _e1218);
                                                        if (_e1240 != _e1241) {
                                                            phi_3168_ = (_e1240 - _e1241);
                                                        } else {
                                                            let _e1243 = (_e1232 * 4097f);
                                                            let _e1245 = (_e1243 - (_e1243 - _e1232));
                                                            let _e1246 = (_e1225 * 4097f);
                                                            let _e1248 = (_e1246 - (_e1246 - _e1225));
                                                            let _e1249 = (_e1232 - _e1245);
                                                            let _e1250 = (_e1225 - _e1248);
                                                            let _e1259 = (_e1239 * 4097f);
                                                            let _e1261 = (_e1259 - (_e1259 - _e1239));
                                                            let _e1262 = (_e1218 * 4097f);
                                                            let _e1264 = (_e1262 - (_e1262 - _e1218));
                                                            let _e1265 = (_e1239 - _e1261);
                                                            let _e1266 = (_e1218 - _e1264);
                                                            phi_3168_ = ((((((_e1245 * _e1248) - _e1240) + (_e1245 * _e1250)) + (_e1249 * _e1248)) + (_e1249 * _e1250)) - (((((_e1261 * _e1264) - _e1241) + (_e1261 * _e1266)) + (_e1265 * _e1264)) + (_e1265 * _e1266)));
                                                        }
                                                        let _e1278 = phi_3168_;
                                                        let _e1279 = (_e1204 * _e1239);
                                                        let _e1280 = (_e1211 * _e1232);
                                                        if (_e1279 != _e1280) {
                                                            phi_3179_ = (_e1279 - _e1280);
                                                        } else {
                                                            let _e1282 = (_e1204 * 4097f);
                                                            let _e1284 = (_e1282 - (_e1282 - _e1204));
                                                            let _e1285 = (_e1239 * 4097f);
                                                            let _e1287 = (_e1285 - (_e1285 - _e1239));
                                                            let _e1288 = (_e1204 - _e1284);
                                                            let _e1289 = (_e1239 - _e1287);
                                                            let _e1298 = (_e1211 * 4097f);
                                                            let _e1300 = (_e1298 - (_e1298 - _e1211));
                                                            let _e1301 = (_e1232 * 4097f);
                                                            let _e1303 = (_e1301 - (_e1301 - _e1232));
                                                            let _e1304 = (_e1211 - _e1300);
                                                            let _e1305 = (_e1232 - _e1303);
                                                            phi_3179_ = ((((((_e1284 * _e1287) - _e1279) + (_e1284 * _e1289)) + (_e1288 * _e1287)) + (_e1288 * _e1289)) - (((((_e1300 * _e1303) - _e1280) + (_e1300 * _e1305)) + (_e1304 * _e1303)) + (_e1304 * _e1305)));
                                                        }
                                                        let _e1317 = phi_3179_;
                                                        let _e1318 = (_e1218 * _e1211);
                                                        let _e1319 = (_e1225 * _e1204);
                                                        if (_e1318 != _e1319) {
                                                            phi_3190_ = (_e1318 - _e1319);
                                                        } else {
                                                            let _e1321 = (_e1218 * 4097f);
                                                            let _e1323 = (_e1321 - (_e1321 - _e1218));
                                                            let _e1324 = (_e1211 * 4097f);
                                                            let _e1326 = (_e1324 - (_e1324 - _e1211));
                                                            let _e1327 = (_e1218 - _e1323);
                                                            let _e1328 = (_e1211 - _e1326);
                                                            let _e1337 = (_e1225 * 4097f);
                                                            let _e1339 = (_e1337 - (_e1337 - _e1225));
                                                            let _e1340 = (_e1204 * 4097f);
                                                            let _e1342 = (_e1340 - (_e1340 - _e1204));
                                                            let _e1343 = (_e1225 - _e1339);
                                                            let _e1344 = (_e1204 - _e1342);
                                                            phi_3190_ = ((((((_e1323 * _e1326) - _e1318) + (_e1323 * _e1328)) + (_e1327 * _e1326)) + (_e1327 * _e1328)) - (((((_e1339 * _e1342) - _e1319) + (_e1339 * _e1344)) + (_e1343 * _e1342)) + (_e1343 * _e1344)));
                                                        }
                                                        let _e1356 = phi_3190_;
                                                        if (_e1278 < 0f) {
                                                            phi_3208_ = f32();
                                                            phi_3209_ = true;
                                                        } else {
                                                            if (_e1317 < 0f) {
                                                                phi_3206_ = f32();
                                                                phi_3207_ = true;
                                                            } else {
                                                                let _e1359 = (_e1356 < 0f);
                                                                if _e1359 {
                                                                    phi_3205_ = f32();
                                                                } else {
                                                                    phi_3205_ = ((_e1278 + _e1317) + _e1356);
                                                                }
                                                                let _e1363 = phi_3205_;
                                                                phi_3206_ = _e1363;
                                                                phi_3207_ = _e1359;
                                                            }
                                                            let _e1365 = phi_3206_;
                                                            let _e1367 = phi_3207_;
                                                            phi_3208_ = _e1365;
                                                            phi_3209_ = _e1367;
                                                        }
                                                        let _e1369 = phi_3208_;
                                                        let _e1371 = phi_3209_;
                                                        if _e1371 {
                                                            if (_e1278 > 0f) {
                                                                phi_3230_ = f32();
                                                                phi_3231_ = true;
                                                                phi_3232_ = false;
                                                            } else {
                                                                let _e1373 = (_e1317 > 0f);
                                                                if _e1373 {
                                                                    phi_3228_ = f32();
                                                                    phi_3229_ = false;
                                                                } else {
                                                                    phi_3228_ = ((_e1278 + _e1317) + _e1356);
                                                                    phi_3229_ = select(true, false, (_e1356 > 0f));
                                                                }
                                                                let _e1379 = phi_3228_;
                                                                let _e1381 = phi_3229_;
                                                                phi_3230_ = _e1379;
                                                                phi_3231_ = _e1373;
                                                                phi_3232_ = _e1381;
                                                            }
                                                            let _e1383 = phi_3230_;
                                                            let _e1385 = phi_3231_;
                                                            let _e1387 = phi_3232_;
                                                            phi_3237_ = _e1383;
                                                            phi_3238_ = select(_e1387, false, _e1385);
                                                        } else {
                                                            phi_3237_ = _e1369;
                                                            phi_3238_ = true;
                                                        }
                                                        let _e1390 = phi_3237_;
                                                        let _e1392 = phi_3238_;
                                                        if _e1392 {
                                                            let _e1393 = (_e1390 == 0f);
                                                            if _e1393 {
                                                                phi_3326_ = array<f32, 3>();
                                                                phi_3327_ = array<f32, 3>();
                                                                phi_3328_ = false;
                                                            } else {
                                                                let _e1394 = (_e1187 * _e1065);
                                                                let _e1395 = (_e1192 * _e1065);
                                                                let _e1396 = (_e1197 * _e1065);
                                                                let _e1399 = (1f / ((_e1278 + _e1317) + _e1356));
                                                                let _e1400 = (_e1317 * _e1399);
                                                                let _e1401 = (_e1356 * _e1399);
                                                                let _e1407 = ((((_e1278 * _e1399) * _e1394) + (_e1400 * _e1395)) + (_e1401 * _e1396));
                                                                let _e1408 = abs(_e1204);
                                                                let _e1409 = abs(_e1218);
                                                                let _e1411 = select(_e1409, _e1408, (_e1408 > _e1409));
                                                                let _e1412 = abs(_e1232);
                                                                let _e1415 = abs(_e1211);
                                                                let _e1416 = abs(_e1225);
                                                                let _e1418 = select(_e1416, _e1415, (_e1415 > _e1416));
                                                                let _e1419 = abs(_e1239);
                                                                let _e1423 = abs(_e1394);
                                                                let _e1424 = abs(_e1395);
                                                                let _e1426 = select(_e1424, _e1423, (_e1423 > _e1424));
                                                                let _e1427 = abs(_e1396);
                                                                let _e1434 = (((select(_e1412, _e1411, (_e1411 > _e1412)) * select(_e1419, _e1418, (_e1418 > _e1419))) * select(_e1427, _e1426, (_e1426 > _e1427))) <= (abs((_e1390 * _e1407)) * 256f));
                                                                if _e1434 {
                                                                    phi_3324_ = array<f32, 3>(_e1407, _e1400, _e1401);
                                                                    phi_3325_ = array<f32, 3>();
                                                                } else {
                                                                    let _e1436 = (_e1232 * 4097f);
                                                                    let _e1438 = (_e1436 - (_e1436 - _e1232));
                                                                    let _e1439 = (_e1225 * 4097f);
                                                                    let _e1441 = (_e1439 - (_e1439 - _e1225));
                                                                    let _e1442 = (_e1232 - _e1438);
                                                                    let _e1443 = (_e1225 - _e1441);
                                                                    let _e1452 = (_e1239 * 4097f);
                                                                    let _e1454 = (_e1452 - (_e1452 - _e1239));
                                                                    let _e1455 = (_e1218 * 4097f);
                                                                    let _e1457 = (_e1455 - (_e1455 - _e1218));
                                                                    let _e1458 = (_e1239 - _e1454);
                                                                    let _e1459 = (_e1218 - _e1457);
                                                                    let _e1469 = ((_e1240 - _e1241) + ((((((_e1438 * _e1441) - _e1240) + (_e1438 * _e1443)) + (_e1442 * _e1441)) + (_e1442 * _e1443)) - (((((_e1454 * _e1457) - _e1241) + (_e1454 * _e1459)) + (_e1458 * _e1457)) + (_e1458 * _e1459))));
                                                                    let _e1471 = (_e1204 * 4097f);
                                                                    let _e1473 = (_e1471 - (_e1471 - _e1204));
                                                                    let _e1474 = (_e1204 - _e1473);
                                                                    let _e1483 = (_e1211 * 4097f);
                                                                    let _e1485 = (_e1483 - (_e1483 - _e1211));
                                                                    let _e1486 = (_e1211 - _e1485);
                                                                    let _e1496 = ((_e1279 - _e1280) + ((((((_e1473 * _e1454) - _e1279) + (_e1473 * _e1458)) + (_e1474 * _e1454)) + (_e1474 * _e1458)) - (((((_e1485 * _e1438) - _e1280) + (_e1485 * _e1442)) + (_e1486 * _e1438)) + (_e1486 * _e1442))));
                                                                    let _e1515 = ((_e1318 - _e1319) + ((((((_e1457 * _e1485) - _e1318) + (_e1457 * _e1486)) + (_e1459 * _e1485)) + (_e1459 * _e1486)) - (((((_e1441 * _e1473) - _e1319) + (_e1441 * _e1474)) + (_e1443 * _e1473)) + (_e1443 * _e1474))));
                                                                    let _e1518 = (1f / ((_e1469 + _e1496) + _e1515));
                                                                    let _e1519 = (_e1496 * _e1518);
                                                                    let _e1520 = (_e1515 * _e1518);
                                                                    phi_3324_ = array<f32, 3>();
                                                                    phi_3325_ = array<f32, 3>(((((_e1469 * _e1518) * _e1394) + (_e1519 * _e1395)) + (_e1520 * _e1396)), _e1519, _e1520);
                                                                }
                                                                let _e1530 = phi_3324_;
                                                                let _e1532 = phi_3325_;
                                                                phi_3326_ = _e1530;
                                                                phi_3327_ = _e1532;
                                                                phi_3328_ = _e1434;
                                                            }
                                                            let _e1534 = phi_3326_;
                                                            let _e1536 = phi_3327_;
                                                            let _e1538 = phi_3328_;
                                                            phi_3329_ = _e1534;
                                                            phi_3330_ = _e1536;
                                                            phi_3331_ = _e1393;
                                                            phi_3332_ = _e1538;
                                                        } else {
                                                            phi_3329_ = array<f32, 3>();
                                                            phi_3330_ = array<f32, 3>();
                                                            phi_3331_ = true;
                                                            phi_3332_ = false;
                                                        }
                                                        let _e1540 = phi_3329_;
                                                        let _e1542 = phi_3330_;
                                                        let _e1544 = phi_3331_;
                                                        let _e1546 = phi_3332_;
                                                        if _e1544 {
                                                            phi_3337_ = array<f32, 3>(-1f, 0f, 0f);
                                                        } else {
                                                            phi_3337_ = _e1540;
                                                        }
                                                        let _e1548 = phi_3337_;
                                                        if select(_e1546, true, _e1544) {
                                                            phi_3342_ = _e1548;
                                                        } else {
                                                            phi_3342_ = _e1542;
                                                        }
                                                        let _e1551 = phi_3342_;
                                                        if (_e1551[0] >= _e1016.member_2) {
                                                            let _e1557 = (_e1551[0] < _e1016.member_3);
                                                            if _e1557 {
                                                                let _e1558 = (_e1551[0] >= 0f);
                                                                if _e1558 {
                                                                    if _e1182 {
                                                                    } else {
                                                                        phi_5341_ = true;
                                                                        phi_4004_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e1561 = triangles.member[_e1177.member_1].member_3;
                                                                    if ((_e1561 & 1u) == 0u) {
                                                                        phi_3808_ = true;
                                                                    } else {
                                                                        if _e1182 {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1566 = triangles.member[_e1177.member_1].member_1;
                                                                        let _e1567 = (_e1566 * 12u);
                                                                        if ((256u + _e1567) < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 257u) < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 258u) < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1574 = (_e1567 + 259u);
                                                                        if (_e1574 < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1577 = surfaces.member[_e1574];
                                                                        if ((_e1567 + 260u) < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 261u) < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 262u) < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1584 = (_e1567 + 263u);
                                                                        if (_e1584 < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1587 = surfaces.member[_e1584];
                                                                        let _e1588 = (_e1567 + 264u);
                                                                        if (_e1588 < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1591 = surfaces.member[_e1588];
                                                                        let _e1592 = bitcast<f32>(_e1591);
                                                                        let _e1593 = (_e1567 + 265u);
                                                                        if (_e1593 < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1596 = surfaces.member[_e1593];
                                                                        let _e1597 = bitcast<f32>(_e1596);
                                                                        if ((_e1567 + 266u) < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 267u) < _e131) {
                                                                        } else {
                                                                            phi_5341_ = true;
                                                                            phi_4004_ = bool();
                                                                            break;
                                                                        }
                                                                        if (_e1577 == 4294967295u) {
                                                                            phi_3803_ = (_e1592 < _e1597);
                                                                        } else {
                                                                            if (_e1177.member_1 < arrayLength((&attributes.member))) {
                                                                            } else {
                                                                                phi_5341_ = true;
                                                                                phi_4004_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1605 = ((1f - _e1551[1]) - _e1551[2]);
                                                                            let _e1609 = attributes.member[_e1177.member_1].member[0u];
                                                                            let _e1614 = attributes.member[_e1177.member_1].member[2u];
                                                                            let _e1620 = attributes.member[_e1177.member_1].member[4u];
                                                                            let _e1622 = (((_e1609 * _e1605) + (_e1614 * _e1551[1])) + (_e1620 * _e1551[2]));
                                                                            let _e1626 = attributes.member[_e1177.member_1].member[1u];
                                                                            let _e1631 = attributes.member[_e1177.member_1].member[3u];
                                                                            let _e1637 = attributes.member[_e1177.member_1].member[5u];
                                                                            let _e1639 = (((_e1626 * _e1605) + (_e1631 * _e1551[1])) + (_e1637 * _e1551[2]));
                                                                            let _e1640 = (_e1587 & 65535u);
                                                                            let _e1642 = (_e1587 >> bitcast<u32>(16i));
                                                                            let _e1645 = ((_e1577 >> bitcast<u32>(28u)) & 3u);
                                                                            let _e1646 = (_e1640 - 1u);
                                                                            let _e1648 = select(1f, 2f, (_e1645 == 2u));
                                                                            let _e1652 = (_e1622 - (floor((_e1622 / _e1648)) * _e1648));
                                                                            if (_e1652 > 1f) {
                                                                                phi_3541_ = (_e1648 - _e1652);
                                                                            } else {
                                                                                phi_3541_ = _e1652;
                                                                            }
                                                                            let _e1656 = phi_3541_;
                                                                            if (_e1645 == 1u) {
                                                                                let _e1659 = select(0f, _e1622, (_e1622 > 0f));
                                                                                phi_3556_ = select(1f, _e1659, (_e1659 < 1f));
                                                                            } else {
                                                                                phi_3556_ = _e1656;
                                                                            }
                                                                            let _e1663 = phi_3556_;
                                                                            let _e1670 = ((select(0f, _e1663, (abs((_e1663 - 0.5f)) <= 0.5f)) * f32(_e1640)) - 0.5f);
                                                                            let _e1671 = floor(_e1670);
                                                                            let _e1672 = (_e1671 < 0f);
                                                                            if _e1672 {
                                                                                phi_3584_ = 0u;
                                                                            } else {
                                                                                let _e1677 = select(select(u32(_e1671), 0u, (_e1671 < 0f)), 4294967295u, (_e1671 > 4294967000f));
                                                                                phi_3584_ = select(_e1677, _e1646, (_e1646 < _e1677));
                                                                            }
                                                                            let _e1681 = phi_3584_;
                                                                            if _e1672 {
                                                                                phi_3594_ = 0u;
                                                                            } else {
                                                                                let _e1682 = (_e1681 + 1u);
                                                                                phi_3594_ = select(_e1682, _e1646, (_e1646 < _e1682));
                                                                            }
                                                                            let _e1686 = phi_3594_;
                                                                            let _e1687 = (_e1645 == 0u);
                                                                            if _e1687 {
                                                                                phi_3603_ = select(true, false, _e1672);
                                                                            } else {
                                                                                phi_3603_ = true;
                                                                            }
                                                                            let _e1690 = phi_3603_;
                                                                            let _e1691 = select(_e1646, _e1681, _e1690);
                                                                            if _e1687 {
                                                                                if _e1672 {
                                                                                    phi_3619_ = true;
                                                                                } else {
                                                                                    phi_3619_ = select(true, false, (_e1691 == _e1646));
                                                                                }
                                                                                let _e1695 = phi_3619_;
                                                                                phi_3620_ = _e1695;
                                                                            } else {
                                                                                phi_3620_ = true;
                                                                            }
                                                                            let _e1697 = phi_3620_;
                                                                            let _e1698 = select(0u, _e1686, _e1697);
                                                                            let _e1699 = (_e1670 - _e1671);
                                                                            let _e1702 = ((_e1577 >> bitcast<u32>(30u)) & 3u);
                                                                            let _e1703 = (_e1642 - 1u);
                                                                            let _e1705 = select(1f, 2f, (_e1702 == 2u));
                                                                            let _e1709 = (_e1639 - (floor((_e1639 / _e1705)) * _e1705));
                                                                            if (_e1709 > 1f) {
                                                                                phi_3643_ = (_e1705 - _e1709);
                                                                            } else {
                                                                                phi_3643_ = _e1709;
                                                                            }
                                                                            let _e1713 = phi_3643_;
                                                                            if (_e1702 == 1u) {
                                                                                let _e1716 = select(0f, _e1639, (_e1639 > 0f));
                                                                                phi_3658_ = select(1f, _e1716, (_e1716 < 1f));
                                                                            } else {
                                                                                phi_3658_ = _e1713;
                                                                            }
                                                                            let _e1720 = phi_3658_;
                                                                            let _e1727 = ((select(0f, _e1720, (abs((_e1720 - 0.5f)) <= 0.5f)) * f32(_e1642)) - 0.5f);
                                                                            let _e1728 = floor(_e1727);
                                                                            let _e1729 = (_e1728 < 0f);
                                                                            if _e1729 {
                                                                                phi_3686_ = 0u;
                                                                            } else {
                                                                                let _e1734 = select(select(u32(_e1728), 0u, (_e1728 < 0f)), 4294967295u, (_e1728 > 4294967000f));
                                                                                phi_3686_ = select(_e1734, _e1703, (_e1703 < _e1734));
                                                                            }
                                                                            let _e1738 = phi_3686_;
                                                                            if _e1729 {
                                                                                phi_3696_ = 0u;
                                                                            } else {
                                                                                let _e1739 = (_e1738 + 1u);
                                                                                phi_3696_ = select(_e1739, _e1703, (_e1703 < _e1739));
                                                                            }
                                                                            let _e1743 = phi_3696_;
                                                                            let _e1744 = (_e1702 == 0u);
                                                                            if _e1744 {
                                                                                phi_3705_ = select(true, false, _e1729);
                                                                            } else {
                                                                                phi_3705_ = true;
                                                                            }
                                                                            let _e1747 = phi_3705_;
                                                                            let _e1748 = select(_e1703, _e1738, _e1747);
                                                                            if _e1744 {
                                                                                if _e1729 {
                                                                                    phi_3721_ = true;
                                                                                } else {
                                                                                    phi_3721_ = select(true, false, (_e1748 == _e1703));
                                                                                }
                                                                                let _e1752 = phi_3721_;
                                                                                phi_3722_ = _e1752;
                                                                            } else {
                                                                                phi_3722_ = true;
                                                                            }
                                                                            let _e1754 = phi_3722_;
                                                                            let _e1756 = (_e1727 - _e1728);
                                                                            let _e1757 = (_e1577 & 268435455u);
                                                                            let _e1759 = (_e1757 + (_e1748 * _e1640));
                                                                            let _e1761 = (_e1757 + (select(0u, _e1743, _e1754) * _e1640));
                                                                            let _e1762 = (_e1759 + _e1691);
                                                                            let _e1763 = (_e1759 + _e1698);
                                                                            let _e1764 = (_e1761 + _e1691);
                                                                            let _e1765 = (_e1761 + _e1698);
                                                                            if (_e1762 < _e131) {
                                                                            } else {
                                                                                phi_5341_ = true;
                                                                                phi_4004_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1768 = surfaces.member[_e1762];
                                                                            if (_e1763 < _e131) {
                                                                            } else {
                                                                                phi_5341_ = true;
                                                                                phi_4004_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1771 = surfaces.member[_e1763];
                                                                            if (_e1764 < _e131) {
                                                                            } else {
                                                                                phi_5341_ = true;
                                                                                phi_4004_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1774 = surfaces.member[_e1764];
                                                                            if (_e1765 < _e131) {
                                                                            } else {
                                                                                phi_5341_ = true;
                                                                                phi_4004_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1777 = surfaces.member[_e1765];
                                                                            let _e1794 = (1f - _e1699);
                                                                            phi_3803_ = ((_e1592 * (((((f32((_e1768 >> bitcast<u32>(24i))) * 0.003921569f) * _e1794) + ((f32((_e1771 >> bitcast<u32>(24i))) * 0.003921569f) * _e1699)) * (1f - _e1756)) + ((((f32((_e1774 >> bitcast<u32>(24i))) * 0.003921569f) * _e1794) + ((f32((_e1777 >> bitcast<u32>(24i))) * 0.003921569f) * _e1699)) * _e1756))) < _e1597);
                                                                        }
                                                                        let _e1809 = phi_3803_;
                                                                        phi_3808_ = select(true, false, _e1809);
                                                                    }
                                                                    let _e1812 = phi_3808_;
                                                                    if _e1812 {
                                                                        phi_3813_ = type_53(_e1551[0], _e1177.member_1, _e1551[1], _e1551[2]);
                                                                    } else {
                                                                        phi_3813_ = type_53();
                                                                    }
                                                                    let _e1815 = phi_3813_;
                                                                    phi_3815_ = _e1815;
                                                                    phi_3817_ = select(true, false, _e1812);
                                                                } else {
                                                                    phi_3815_ = type_53();
                                                                    phi_3817_ = false;
                                                                }
                                                                let _e1818 = phi_3815_;
                                                                let _e1820 = phi_3817_;
                                                                phi_3818_ = _e1818;
                                                                phi_3820_ = select(true, false, _e1558);
                                                                phi_3821_ = _e1820;
                                                            } else {
                                                                phi_3818_ = type_53();
                                                                phi_3820_ = false;
                                                                phi_3821_ = false;
                                                            }
                                                            let _e1823 = phi_3818_;
                                                            let _e1825 = phi_3820_;
                                                            let _e1827 = phi_3821_;
                                                            phi_3822_ = _e1823;
                                                            phi_3823_ = select(true, false, _e1557);
                                                            phi_3824_ = _e1825;
                                                            phi_3825_ = _e1827;
                                                        } else {
                                                            phi_3822_ = type_53();
                                                            phi_3823_ = true;
                                                            phi_3824_ = false;
                                                            phi_3825_ = false;
                                                        }
                                                        let _e1830 = phi_3822_;
                                                        let _e1832 = phi_3823_;
                                                        let _e1834 = phi_3824_;
                                                        let _e1836 = phi_3825_;
                                                        if select(select(_e1836, false, _e1832), true, select(_e1834, true, _e1832)) {
                                                            phi_3838_ = type_53(_e1016.member_3, 4294967295u, 0f, 0f);
                                                        } else {
                                                            phi_3838_ = _e1830;
                                                        }
                                                        let _e1841 = phi_3838_;
                                                        phi_3845_ = select(true, false, (_e1841.member_1 != 4294967295u));
                                                    } else {
                                                        phi_3845_ = false;
                                                    }
                                                    let _e1846 = phi_3845_;
                                                    continue;
                                                    continuing {
                                                        phi_3028_ = _e1175;
                                                        phi_5341_ = _e1150;
                                                        phi_4004_ = select(true, false, _e1181);
                                                        break if !(_e1846);
                                                    }
                                                }
                                                let _e1850 = phi_5341_;
                                                let _e1852 = phi_4004_;
                                                phi_5476_ = _e1850;
                                                phi_4005_ = bool();
                                                if _e1850 {
                                                    break;
                                                }
                                                phi_5478_ = _e1850;
                                                phi_3850_ = _e1154;
                                                phi_3851_ = _e1852;
                                            }
                                            let _e2090 = phi_5478_;
                                            let _e2092 = phi_3850_;
                                            let _e2094 = phi_3851_;
                                            if _e2094 {
                                                let _e2095 = (_e2092 == 0u);
                                                if _e2095 {
                                                    phi_3867_ = u32();
                                                    phi_3868_ = u32();
                                                } else {
                                                    let _e2096 = (_e2092 - 1u);
                                                    if (_e2096 < 64u) {
                                                    } else {
                                                        phi_5476_ = true;
                                                        phi_4005_ = bool();
                                                        break;
                                                    }
                                                    let _e2099 = local[_e2096];
                                                    phi_3867_ = _e2099;
                                                    phi_3868_ = _e2096;
                                                }
                                                let _e2101 = phi_3867_;
                                                let _e2103 = phi_3868_;
                                                phi_2599_ = _e2101;
                                                phi_2602_ = _e2103;
                                                phi_3870_ = select(true, false, _e2095);
                                                phi_3871_ = _e2095;
                                            } else {
                                                phi_2599_ = u32();
                                                phi_2602_ = u32();
                                                phi_3870_ = false;
                                                phi_3871_ = false;
                                            }
                                            let _e2106 = phi_2599_;
                                            let _e2108 = phi_2602_;
                                            let _e2110 = phi_3870_;
                                            let _e2112 = phi_3871_;
                                            continue;
                                            continuing {
                                                phi_5345_ = _e2090;
                                                phi_2598_ = _e2106;
                                                phi_2601_ = _e2108;
                                                phi_5476_ = _e2090;
                                                phi_4005_ = _e2112;
                                                break if !(_e2110);
                                            }
                                        }
                                        let _e2115 = phi_5476_;
                                        let _e2117 = phi_4005_;
                                        phi_5536_ = _e2115;
                                        if _e2115 {
                                            break;
                                        }
                                        if select(false, true, select(true, false, _e2117)) {
                                            phi_3884_ = _e434;
                                        } else {
                                            phi_3884_ = (_e434 + _e1017);
                                        }
                                        let _e2122 = phi_3884_;
                                        phi_5538_ = _e2115;
                                        phi_3885_ = _e2122;
                                    } else {
                                        phi_5538_ = _e428;
                                        phi_3885_ = _e434;
                                    }
                                    let _e2124 = phi_5538_;
                                    let _e2126 = phi_3885_;
                                    phi_5537_ = _e2124;
                                    phi_1668_ = select(_e1018, _e432, (_e432 < _e1018));
                                    phi_1670_ = _e2126;
                                    phi_1672_ = (_e436 + _e1017);
                                } else {
                                    phi_5537_ = _e428;
                                    phi_1668_ = f32();
                                    phi_1670_ = f32();
                                    phi_1672_ = f32();
                                }
                                let _e2128 = phi_5537_;
                                let _e2130 = phi_1668_;
                                let _e2132 = phi_1670_;
                                let _e2134 = phi_1672_;
                                continue;
                                continuing {
                                    phi_5367_ = _e2128;
                                    phi_1664_ = _e449;
                                    phi_1667_ = _e2130;
                                    phi_1669_ = _e2132;
                                    phi_1671_ = _e2134;
                                    phi_5536_ = _e2128;
                                    break if !(_e455);
                                }
                            }
                            let _e2137 = phi_5536_;
                            phi_5542_ = _e2137;
                            if _e2137 {
                                break;
                            }
                            let _e2139 = local_5;
                            if (_e2139 <= 0f) {
                                phi_3952_ = vec3<f32>(0f, 0f, 0f);
                            } else {
                                if (_e413.member_1 == 4294967295u) {
                                    let _e2143 = local_6;
                                    phi_3898_ = ((3.1415927f * _e2143) / f32(_e425));
                                } else {
                                    let _e3162 = local_14;
                                    phi_3898_ = _e3162;
                                }
                                let _e2148 = phi_3898_;
                                if _e421 {
                                    if (_e425 == 1u) {
                                        phi_3933_ = f32();
                                        phi_3934_ = true;
                                    } else {
                                        let _e2152 = local_7;
                                        let _e2154 = (_e413.member_3 < (0.01f * _e2152));
                                        if _e2154 {
                                            phi_3932_ = f32();
                                        } else {
                                            let _e2170 = (_e413.member[0] - _e147.member[0]);
                                            let _e2171 = (_e413.member[1] - _e147.member[1]);
                                            let _e2172 = (_e413.member[2] - _e147.member[2]);
                                            let _e2173 = (vec3<f32>(_e413.member[0], _e413.member[1], _e413.member[2]) - _e174);
                                            let _e2174 = (_e413.member_2[0] - _e147.member[0]);
                                            let _e2175 = (_e413.member_2[1] - _e147.member[1]);
                                            let _e2176 = (_e413.member_2[2] - _e147.member[2]);
                                            let _e2177 = (vec3<f32>(_e413.member_2[0], _e413.member_2[1], _e413.member_2[2]) - _e174);
                                            let _e2178 = (_e413.member_4[0] - _e147.member[0]);
                                            let _e2179 = (_e413.member_4[1] - _e147.member[1]);
                                            let _e2180 = (_e413.member_4[2] - _e147.member[2]);
                                            let _e2181 = (vec3<f32>(_e413.member_4[0], _e413.member_4[1], _e413.member_4[2]) - _e174);
                                            let _e2189 = (((_e169.x * _e2170) + (_e169.y * _e2171)) + (_e169.z * _e2172));
                                            let _e2194 = (((_e169.x * _e2174) + (_e169.y * _e2175)) + (_e169.z * _e2176));
                                            let _e2199 = (((_e169.x * _e2178) + (_e169.y * _e2179)) + (_e169.z * _e2180));
                                            let _e2200 = (_e2189 <= 0f);
                                            if _e2200 {
                                                phi_4347_ = select(true, false, (_e2194 <= 0f));
                                            } else {
                                                phi_4347_ = true;
                                            }
                                            let _e2204 = phi_4347_;
                                            if _e2204 {
                                                if _e2200 {
                                                    phi_4358_ = true;
                                                } else {
                                                    phi_4358_ = (_e2194 <= 0f);
                                                }
                                                let _e2207 = phi_4358_;
                                                if _e2207 {
                                                    let _e2212 = (_e2189 / (_e2189 - _e2194));
                                                    let _e2219 = vec3<f32>((_e2170 + ((_e2174 - _e2170) * _e2212)), (_e2171 + ((_e2175 - _e2171) * _e2212)), (_e2172 + ((_e2176 - _e2172) * _e2212)));
                                                    if _e2200 {
                                                        phi_4379_ = type_61(0f, vec3<f32>(0f, 0f, 0f), _e2219);
                                                    } else {
                                                        phi_4379_ = type_61(0f, _e2219, vec3<f32>(0f, 0f, 0f));
                                                    }
                                                    let _e2223 = phi_4379_;
                                                    let _e2224 = vec3(_e2200);
                                                    phi_4383_ = _e2223;
                                                    phi_4384_ = select(_e2219, _e2177, _e2224);
                                                    phi_4385_ = select(_e2173, _e2219, _e2224);
                                                } else {
                                                    phi_4383_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                    phi_4384_ = _e2177;
                                                    phi_4385_ = _e2173;
                                                }
                                                let _e2228 = phi_4383_;
                                                let _e2230 = phi_4384_;
                                                let _e2232 = phi_4385_;
                                                let _e2234 = abs(_e2232.x);
                                                let _e2236 = abs(_e2232.y);
                                                let _e2238 = select(_e2236, _e2234, (_e2234 > _e2236));
                                                let _e2240 = abs(_e2232.z);
                                                let _e2242 = select(_e2240, _e2238, (_e2238 > _e2240));
                                                if (_e2242 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2244 = (_e2242 < 340282350000000000000000000000000000000f);
                                                    if _e2244 {
                                                        let _e2245 = (_e2232.x / _e2242);
                                                        let _e2246 = (_e2232.y / _e2242);
                                                        let _e2247 = (_e2232.z / _e2242);
                                                        let _e2253 = sqrt((((_e2245 * _e2245) + (_e2246 * _e2246)) + (_e2247 * _e2247)));
                                                        phi_4425_ = vec3<f32>((_e2245 / _e2253), (_e2246 / _e2253), (_e2247 / _e2253));
                                                    } else {
                                                        phi_4425_ = vec3<f32>();
                                                    }
                                                    let _e2259 = phi_4425_;
                                                    phi_4428_ = _e2259;
                                                    phi_4429_ = select(true, false, _e2244);
                                                } else {
                                                    phi_4428_ = vec3<f32>();
                                                    phi_4429_ = true;
                                                }
                                                let _e2262 = phi_4428_;
                                                let _e2264 = phi_4429_;
                                                let _e2266 = select(_e2262, vec3<f32>(0f, 0f, 0f), vec3(_e2264));
                                                let _e2268 = abs(_e2230.x);
                                                let _e2270 = abs(_e2230.y);
                                                let _e2272 = select(_e2270, _e2268, (_e2268 > _e2270));
                                                let _e2274 = abs(_e2230.z);
                                                let _e2276 = select(_e2274, _e2272, (_e2272 > _e2274));
                                                if (_e2276 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2278 = (_e2276 < 340282350000000000000000000000000000000f);
                                                    if _e2278 {
                                                        let _e2279 = (_e2230.x / _e2276);
                                                        let _e2280 = (_e2230.y / _e2276);
                                                        let _e2281 = (_e2230.z / _e2276);
                                                        let _e2287 = sqrt((((_e2279 * _e2279) + (_e2280 * _e2280)) + (_e2281 * _e2281)));
                                                        phi_4473_ = vec3<f32>((_e2279 / _e2287), (_e2280 / _e2287), (_e2281 / _e2287));
                                                    } else {
                                                        phi_4473_ = vec3<f32>();
                                                    }
                                                    let _e2293 = phi_4473_;
                                                    phi_4476_ = _e2293;
                                                    phi_4477_ = select(true, false, _e2278);
                                                } else {
                                                    phi_4476_ = vec3<f32>();
                                                    phi_4477_ = true;
                                                }
                                                let _e2296 = phi_4476_;
                                                let _e2298 = phi_4477_;
                                                let _e2300 = select(_e2296, vec3<f32>(0f, 0f, 0f), vec3(_e2298));
                                                let _e2307 = ((_e2266.y * _e2300.z) - (_e2300.y * _e2266.z));
                                                let _e2312 = ((_e2266.z * _e2300.x) - (_e2300.z * _e2266.x));
                                                let _e2315 = ((_e2266.x * _e2300.y) - (_e2300.x * _e2266.y));
                                                let _e2321 = sqrt((((_e2307 * _e2307) + (_e2312 * _e2312)) + (_e2315 * _e2315)));
                                                if (_e2321 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4591_ = 0f;
                                                } else {
                                                    let _e2333 = (((_e2266.x * _e2300.x) + (_e2266.y * _e2300.y)) + (_e2266.z * _e2300.z));
                                                    let _e2334 = abs(_e2333);
                                                    let _e2335 = abs(_e2321);
                                                    let _e2336 = (_e2335 > _e2334);
                                                    let _e2337 = select(_e2334, _e2335, _e2336);
                                                    if (_e2337 > 0f) {
                                                        phi_4544_ = (select(_e2335, _e2334, _e2336) / _e2337);
                                                    } else {
                                                        phi_4544_ = 0f;
                                                    }
                                                    let _e2342 = phi_4544_;
                                                    let _e2343 = (_e2342 > 0.41421357f);
                                                    if _e2343 {
                                                        phi_4552_ = ((_e2342 - 1f) / (_e2342 + 1f));
                                                    } else {
                                                        phi_4552_ = _e2342;
                                                    }
                                                    let _e2348 = phi_4552_;
                                                    let _e2349 = (_e2348 * _e2348);
                                                    let _e2358 = (_e2348 + ((_e2348 * _e2349) * (-0.3333295f + (_e2349 * (0.19977711f + (_e2349 * (-0.13877685f + (_e2349 * 0.080537446f))))))));
                                                    if _e2343 {
                                                        phi_4567_ = (_e2358 + 0.7853982f);
                                                    } else {
                                                        phi_4567_ = _e2358;
                                                    }
                                                    let _e2361 = phi_4567_;
                                                    if _e2336 {
                                                        phi_4573_ = (1.5707964f - _e2361);
                                                    } else {
                                                        phi_4573_ = _e2361;
                                                    }
                                                    let _e2364 = phi_4573_;
                                                    if ((bitcast<u32>(_e2333) & 2147483648u) == 0u) {
                                                        phi_4581_ = _e2364;
                                                    } else {
                                                        phi_4581_ = (3.1415927f - _e2364);
                                                    }
                                                    let _e2370 = phi_4581_;
                                                    phi_4591_ = (((((_e169.x * _e2307) + (_e169.y * _e2312)) + (_e169.z * _e2315)) / _e2321) * bitcast<f32>(((bitcast<u32>(_e2370) & 2147483647u) | (bitcast<u32>(_e2321) & 2147483648u))));
                                                }
                                                let _e2379 = phi_4591_;
                                                phi_4596_ = type_61((_e2228.member + _e2379), _e2228.member_1, _e2228.member_2);
                                            } else {
                                                phi_4596_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                            }
                                            let _e2387 = phi_4596_;
                                            let _e2388 = (_e2194 <= 0f);
                                            if _e2388 {
                                                phi_4606_ = select(true, false, (_e2199 <= 0f));
                                            } else {
                                                phi_4606_ = true;
                                            }
                                            let _e2392 = phi_4606_;
                                            if _e2392 {
                                                if _e2388 {
                                                    phi_4617_ = true;
                                                } else {
                                                    phi_4617_ = (_e2199 <= 0f);
                                                }
                                                let _e2395 = phi_4617_;
                                                if _e2395 {
                                                    let _e2400 = (_e2194 / (_e2194 - _e2199));
                                                    let _e2407 = vec3<f32>((_e2174 + ((_e2178 - _e2174) * _e2400)), (_e2175 + ((_e2179 - _e2175) * _e2400)), (_e2176 + ((_e2180 - _e2176) * _e2400)));
                                                    if _e2388 {
                                                        phi_4638_ = type_61(_e2387.member, _e2387.member_1, _e2407);
                                                    } else {
                                                        phi_4638_ = type_61(_e2387.member, _e2407, _e2387.member_2);
                                                    }
                                                    let _e2417 = phi_4638_;
                                                    let _e2418 = vec3(_e2388);
                                                    phi_4642_ = _e2417;
                                                    phi_4643_ = select(_e2407, _e2181, _e2418);
                                                    phi_4644_ = select(_e2177, _e2407, _e2418);
                                                } else {
                                                    phi_4642_ = _e2387;
                                                    phi_4643_ = _e2181;
                                                    phi_4644_ = _e2177;
                                                }
                                                let _e2422 = phi_4642_;
                                                let _e2424 = phi_4643_;
                                                let _e2426 = phi_4644_;
                                                let _e2428 = abs(_e2426.x);
                                                let _e2430 = abs(_e2426.y);
                                                let _e2432 = select(_e2430, _e2428, (_e2428 > _e2430));
                                                let _e2434 = abs(_e2426.z);
                                                let _e2436 = select(_e2434, _e2432, (_e2432 > _e2434));
                                                if (_e2436 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2438 = (_e2436 < 340282350000000000000000000000000000000f);
                                                    if _e2438 {
                                                        let _e2439 = (_e2426.x / _e2436);
                                                        let _e2440 = (_e2426.y / _e2436);
                                                        let _e2441 = (_e2426.z / _e2436);
                                                        let _e2447 = sqrt((((_e2439 * _e2439) + (_e2440 * _e2440)) + (_e2441 * _e2441)));
                                                        phi_4684_ = vec3<f32>((_e2439 / _e2447), (_e2440 / _e2447), (_e2441 / _e2447));
                                                    } else {
                                                        phi_4684_ = vec3<f32>();
                                                    }
                                                    let _e2453 = phi_4684_;
                                                    phi_4687_ = _e2453;
                                                    phi_4688_ = select(true, false, _e2438);
                                                } else {
                                                    phi_4687_ = vec3<f32>();
                                                    phi_4688_ = true;
                                                }
                                                let _e2456 = phi_4687_;
                                                let _e2458 = phi_4688_;
                                                let _e2460 = select(_e2456, vec3<f32>(0f, 0f, 0f), vec3(_e2458));
                                                let _e2462 = abs(_e2424.x);
                                                let _e2464 = abs(_e2424.y);
                                                let _e2466 = select(_e2464, _e2462, (_e2462 > _e2464));
                                                let _e2468 = abs(_e2424.z);
                                                let _e2470 = select(_e2468, _e2466, (_e2466 > _e2468));
                                                if (_e2470 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2472 = (_e2470 < 340282350000000000000000000000000000000f);
                                                    if _e2472 {
                                                        let _e2473 = (_e2424.x / _e2470);
                                                        let _e2474 = (_e2424.y / _e2470);
                                                        let _e2475 = (_e2424.z / _e2470);
                                                        let _e2481 = sqrt((((_e2473 * _e2473) + (_e2474 * _e2474)) + (_e2475 * _e2475)));
                                                        phi_4732_ = vec3<f32>((_e2473 / _e2481), (_e2474 / _e2481), (_e2475 / _e2481));
                                                    } else {
                                                        phi_4732_ = vec3<f32>();
                                                    }
                                                    let _e2487 = phi_4732_;
                                                    phi_4735_ = _e2487;
                                                    phi_4736_ = select(true, false, _e2472);
                                                } else {
                                                    phi_4735_ = vec3<f32>();
                                                    phi_4736_ = true;
                                                }
                                                let _e2490 = phi_4735_;
                                                let _e2492 = phi_4736_;
                                                let _e2494 = select(_e2490, vec3<f32>(0f, 0f, 0f), vec3(_e2492));
                                                let _e2501 = ((_e2460.y * _e2494.z) - (_e2494.y * _e2460.z));
                                                let _e2506 = ((_e2460.z * _e2494.x) - (_e2494.z * _e2460.x));
                                                let _e2509 = ((_e2460.x * _e2494.y) - (_e2494.x * _e2460.y));
                                                let _e2515 = sqrt((((_e2501 * _e2501) + (_e2506 * _e2506)) + (_e2509 * _e2509)));
                                                if (_e2515 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4850_ = 0f;
                                                } else {
                                                    let _e2527 = (((_e2460.x * _e2494.x) + (_e2460.y * _e2494.y)) + (_e2460.z * _e2494.z));
                                                    let _e2528 = abs(_e2527);
                                                    let _e2529 = abs(_e2515);
                                                    let _e2530 = (_e2529 > _e2528);
                                                    let _e2531 = select(_e2528, _e2529, _e2530);
                                                    if (_e2531 > 0f) {
                                                        phi_4803_ = (select(_e2529, _e2528, _e2530) / _e2531);
                                                    } else {
                                                        phi_4803_ = 0f;
                                                    }
                                                    let _e2536 = phi_4803_;
                                                    let _e2537 = (_e2536 > 0.41421357f);
                                                    if _e2537 {
                                                        phi_4811_ = ((_e2536 - 1f) / (_e2536 + 1f));
                                                    } else {
                                                        phi_4811_ = _e2536;
                                                    }
                                                    let _e2542 = phi_4811_;
                                                    let _e2543 = (_e2542 * _e2542);
                                                    let _e2552 = (_e2542 + ((_e2542 * _e2543) * (-0.3333295f + (_e2543 * (0.19977711f + (_e2543 * (-0.13877685f + (_e2543 * 0.080537446f))))))));
                                                    if _e2537 {
                                                        phi_4826_ = (_e2552 + 0.7853982f);
                                                    } else {
                                                        phi_4826_ = _e2552;
                                                    }
                                                    let _e2555 = phi_4826_;
                                                    if _e2530 {
                                                        phi_4832_ = (1.5707964f - _e2555);
                                                    } else {
                                                        phi_4832_ = _e2555;
                                                    }
                                                    let _e2558 = phi_4832_;
                                                    if ((bitcast<u32>(_e2527) & 2147483648u) == 0u) {
                                                        phi_4840_ = _e2558;
                                                    } else {
                                                        phi_4840_ = (3.1415927f - _e2558);
                                                    }
                                                    let _e2564 = phi_4840_;
                                                    phi_4850_ = (((((_e169.x * _e2501) + (_e169.y * _e2506)) + (_e169.z * _e2509)) / _e2515) * bitcast<f32>(((bitcast<u32>(_e2564) & 2147483647u) | (bitcast<u32>(_e2515) & 2147483648u))));
                                                }
                                                let _e2573 = phi_4850_;
                                                phi_4855_ = type_61((_e2422.member + _e2573), _e2422.member_1, _e2422.member_2);
                                            } else {
                                                phi_4855_ = _e2387;
                                            }
                                            let _e2581 = phi_4855_;
                                            let _e2582 = (_e2199 <= 0f);
                                            if _e2582 {
                                                phi_4865_ = select(true, false, _e2200);
                                            } else {
                                                phi_4865_ = true;
                                            }
                                            let _e2585 = phi_4865_;
                                            if _e2585 {
                                                if select(_e2200, true, _e2582) {
                                                    let _e2591 = (_e2199 / (_e2199 - _e2189));
                                                    let _e2598 = vec3<f32>((_e2178 + ((_e2170 - _e2178) * _e2591)), (_e2179 + ((_e2171 - _e2179) * _e2591)), (_e2180 + ((_e2172 - _e2180) * _e2591)));
                                                    if _e2582 {
                                                        phi_4897_ = type_61(_e2581.member, _e2581.member_1, _e2598);
                                                    } else {
                                                        phi_4897_ = type_61(_e2581.member, _e2598, _e2581.member_2);
                                                    }
                                                    let _e2608 = phi_4897_;
                                                    let _e2609 = vec3(_e2582);
                                                    phi_4901_ = _e2608;
                                                    phi_4902_ = select(_e2598, _e2173, _e2609);
                                                    phi_4903_ = select(_e2181, _e2598, _e2609);
                                                } else {
                                                    phi_4901_ = _e2581;
                                                    phi_4902_ = _e2173;
                                                    phi_4903_ = _e2181;
                                                }
                                                let _e2613 = phi_4901_;
                                                let _e2615 = phi_4902_;
                                                let _e2617 = phi_4903_;
                                                let _e2619 = abs(_e2617.x);
                                                let _e2621 = abs(_e2617.y);
                                                let _e2623 = select(_e2621, _e2619, (_e2619 > _e2621));
                                                let _e2625 = abs(_e2617.z);
                                                let _e2627 = select(_e2625, _e2623, (_e2623 > _e2625));
                                                if (_e2627 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2629 = (_e2627 < 340282350000000000000000000000000000000f);
                                                    if _e2629 {
                                                        let _e2630 = (_e2617.x / _e2627);
                                                        let _e2631 = (_e2617.y / _e2627);
                                                        let _e2632 = (_e2617.z / _e2627);
                                                        let _e2638 = sqrt((((_e2630 * _e2630) + (_e2631 * _e2631)) + (_e2632 * _e2632)));
                                                        phi_4943_ = vec3<f32>((_e2630 / _e2638), (_e2631 / _e2638), (_e2632 / _e2638));
                                                    } else {
                                                        phi_4943_ = vec3<f32>();
                                                    }
                                                    let _e2644 = phi_4943_;
                                                    phi_4946_ = _e2644;
                                                    phi_4947_ = select(true, false, _e2629);
                                                } else {
                                                    phi_4946_ = vec3<f32>();
                                                    phi_4947_ = true;
                                                }
                                                let _e2647 = phi_4946_;
                                                let _e2649 = phi_4947_;
                                                let _e2651 = select(_e2647, vec3<f32>(0f, 0f, 0f), vec3(_e2649));
                                                let _e2653 = abs(_e2615.x);
                                                let _e2655 = abs(_e2615.y);
                                                let _e2657 = select(_e2655, _e2653, (_e2653 > _e2655));
                                                let _e2659 = abs(_e2615.z);
                                                let _e2661 = select(_e2659, _e2657, (_e2657 > _e2659));
                                                if (_e2661 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2663 = (_e2661 < 340282350000000000000000000000000000000f);
                                                    if _e2663 {
                                                        let _e2664 = (_e2615.x / _e2661);
                                                        let _e2665 = (_e2615.y / _e2661);
                                                        let _e2666 = (_e2615.z / _e2661);
                                                        let _e2672 = sqrt((((_e2664 * _e2664) + (_e2665 * _e2665)) + (_e2666 * _e2666)));
                                                        phi_4991_ = vec3<f32>((_e2664 / _e2672), (_e2665 / _e2672), (_e2666 / _e2672));
                                                    } else {
                                                        phi_4991_ = vec3<f32>();
                                                    }
                                                    let _e2678 = phi_4991_;
                                                    phi_4994_ = _e2678;
                                                    phi_4995_ = select(true, false, _e2663);
                                                } else {
                                                    phi_4994_ = vec3<f32>();
                                                    phi_4995_ = true;
                                                }
                                                let _e2681 = phi_4994_;
                                                let _e2683 = phi_4995_;
                                                let _e2685 = select(_e2681, vec3<f32>(0f, 0f, 0f), vec3(_e2683));
                                                let _e2692 = ((_e2651.y * _e2685.z) - (_e2685.y * _e2651.z));
                                                let _e2697 = ((_e2651.z * _e2685.x) - (_e2685.z * _e2651.x));
                                                let _e2700 = ((_e2651.x * _e2685.y) - (_e2685.x * _e2651.y));
                                                let _e2706 = sqrt((((_e2692 * _e2692) + (_e2697 * _e2697)) + (_e2700 * _e2700)));
                                                if (_e2706 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5109_ = 0f;
                                                } else {
                                                    let _e2718 = (((_e2651.x * _e2685.x) + (_e2651.y * _e2685.y)) + (_e2651.z * _e2685.z));
                                                    let _e2719 = abs(_e2718);
                                                    let _e2720 = abs(_e2706);
                                                    let _e2721 = (_e2720 > _e2719);
                                                    let _e2722 = select(_e2719, _e2720, _e2721);
                                                    if (_e2722 > 0f) {
                                                        phi_5062_ = (select(_e2720, _e2719, _e2721) / _e2722);
                                                    } else {
                                                        phi_5062_ = 0f;
                                                    }
                                                    let _e2727 = phi_5062_;
                                                    let _e2728 = (_e2727 > 0.41421357f);
                                                    if _e2728 {
                                                        phi_5070_ = ((_e2727 - 1f) / (_e2727 + 1f));
                                                    } else {
                                                        phi_5070_ = _e2727;
                                                    }
                                                    let _e2733 = phi_5070_;
                                                    let _e2734 = (_e2733 * _e2733);
                                                    let _e2743 = (_e2733 + ((_e2733 * _e2734) * (-0.3333295f + (_e2734 * (0.19977711f + (_e2734 * (-0.13877685f + (_e2734 * 0.080537446f))))))));
                                                    if _e2728 {
                                                        phi_5085_ = (_e2743 + 0.7853982f);
                                                    } else {
                                                        phi_5085_ = _e2743;
                                                    }
                                                    let _e2746 = phi_5085_;
                                                    if _e2721 {
                                                        phi_5091_ = (1.5707964f - _e2746);
                                                    } else {
                                                        phi_5091_ = _e2746;
                                                    }
                                                    let _e2749 = phi_5091_;
                                                    if ((bitcast<u32>(_e2718) & 2147483648u) == 0u) {
                                                        phi_5099_ = _e2749;
                                                    } else {
                                                        phi_5099_ = (3.1415927f - _e2749);
                                                    }
                                                    let _e2755 = phi_5099_;
                                                    phi_5109_ = (((((_e169.x * _e2692) + (_e169.y * _e2697)) + (_e169.z * _e2700)) / _e2706) * bitcast<f32>(((bitcast<u32>(_e2755) & 2147483647u) | (bitcast<u32>(_e2706) & 2147483648u))));
                                                }
                                                let _e2764 = phi_5109_;
                                                phi_5114_ = type_61((_e2613.member + _e2764), _e2613.member_1, _e2613.member_2);
                                            } else {
                                                phi_5114_ = _e2581;
                                            }
                                            let _e2772 = phi_5114_;
                                            let _e2776 = abs(_e2772.member_1.x);
                                            let _e2778 = abs(_e2772.member_1.y);
                                            let _e2780 = select(_e2778, _e2776, (_e2776 > _e2778));
                                            let _e2782 = abs(_e2772.member_1.z);
                                            let _e2784 = select(_e2782, _e2780, (_e2780 > _e2782));
                                            if (_e2784 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e2786 = (_e2784 < 340282350000000000000000000000000000000f);
                                                if _e2786 {
                                                    let _e2787 = (_e2772.member_1.x / _e2784);
                                                    let _e2788 = (_e2772.member_1.y / _e2784);
                                                    let _e2789 = (_e2772.member_1.z / _e2784);
                                                    let _e2795 = sqrt((((_e2787 * _e2787) + (_e2788 * _e2788)) + (_e2789 * _e2789)));
                                                    phi_5156_ = vec3<f32>((_e2787 / _e2795), (_e2788 / _e2795), (_e2789 / _e2795));
                                                } else {
                                                    phi_5156_ = vec3<f32>();
                                                }
                                                let _e2801 = phi_5156_;
                                                phi_5159_ = _e2801;
                                                phi_5160_ = select(true, false, _e2786);
                                            } else {
                                                phi_5159_ = vec3<f32>();
                                                phi_5160_ = true;
                                            }
                                            let _e2804 = phi_5159_;
                                            let _e2806 = phi_5160_;
                                            let _e2808 = select(_e2804, vec3<f32>(0f, 0f, 0f), vec3(_e2806));
                                            let _e2810 = abs(_e2772.member_2.x);
                                            let _e2812 = abs(_e2772.member_2.y);
                                            let _e2814 = select(_e2812, _e2810, (_e2810 > _e2812));
                                            let _e2816 = abs(_e2772.member_2.z);
                                            let _e2818 = select(_e2816, _e2814, (_e2814 > _e2816));
                                            if (_e2818 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e2820 = (_e2818 < 340282350000000000000000000000000000000f);
                                                if _e2820 {
                                                    let _e2821 = (_e2772.member_2.x / _e2818);
                                                    let _e2822 = (_e2772.member_2.y / _e2818);
                                                    let _e2823 = (_e2772.member_2.z / _e2818);
                                                    let _e2829 = sqrt((((_e2821 * _e2821) + (_e2822 * _e2822)) + (_e2823 * _e2823)));
                                                    phi_5204_ = vec3<f32>((_e2821 / _e2829), (_e2822 / _e2829), (_e2823 / _e2829));
                                                } else {
                                                    phi_5204_ = vec3<f32>();
                                                }
                                                let _e2835 = phi_5204_;
                                                phi_5207_ = _e2835;
                                                phi_5208_ = select(true, false, _e2820);
                                            } else {
                                                phi_5207_ = vec3<f32>();
                                                phi_5208_ = true;
                                            }
                                            let _e2838 = phi_5207_;
                                            let _e2840 = phi_5208_;
                                            let _e2842 = select(_e2838, vec3<f32>(0f, 0f, 0f), vec3(_e2840));
                                            let _e2849 = ((_e2808.y * _e2842.z) - (_e2842.y * _e2808.z));
                                            let _e2854 = ((_e2808.z * _e2842.x) - (_e2842.z * _e2808.x));
                                            let _e2857 = ((_e2808.x * _e2842.y) - (_e2842.x * _e2808.y));
                                            let _e2863 = sqrt((((_e2849 * _e2849) + (_e2854 * _e2854)) + (_e2857 * _e2857)));
                                            if (_e2863 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5322_ = 0f;
                                            } else {
                                                let _e2875 = (((_e2808.x * _e2842.x) + (_e2808.y * _e2842.y)) + (_e2808.z * _e2842.z));
                                                let _e2876 = abs(_e2875);
                                                let _e2877 = abs(_e2863);
                                                let _e2878 = (_e2877 > _e2876);
                                                let _e2879 = select(_e2876, _e2877, _e2878);
                                                if (_e2879 > 0f) {
                                                    phi_5275_ = (select(_e2877, _e2876, _e2878) / _e2879);
                                                } else {
                                                    phi_5275_ = 0f;
                                                }
                                                let _e2884 = phi_5275_;
                                                let _e2885 = (_e2884 > 0.41421357f);
                                                if _e2885 {
                                                    phi_5283_ = ((_e2884 - 1f) / (_e2884 + 1f));
                                                } else {
                                                    phi_5283_ = _e2884;
                                                }
                                                let _e2890 = phi_5283_;
                                                let _e2891 = (_e2890 * _e2890);
                                                let _e2900 = (_e2890 + ((_e2890 * _e2891) * (-0.3333295f + (_e2891 * (0.19977711f + (_e2891 * (-0.13877685f + (_e2891 * 0.080537446f))))))));
                                                if _e2885 {
                                                    phi_5298_ = (_e2900 + 0.7853982f);
                                                } else {
                                                    phi_5298_ = _e2900;
                                                }
                                                let _e2903 = phi_5298_;
                                                if _e2878 {
                                                    phi_5304_ = (1.5707964f - _e2903);
                                                } else {
                                                    phi_5304_ = _e2903;
                                                }
                                                let _e2906 = phi_5304_;
                                                if ((bitcast<u32>(_e2875) & 2147483648u) == 0u) {
                                                    phi_5312_ = _e2906;
                                                } else {
                                                    phi_5312_ = (3.1415927f - _e2906);
                                                }
                                                let _e2912 = phi_5312_;
                                                phi_5322_ = (((((_e169.x * _e2849) + (_e169.y * _e2854)) + (_e169.z * _e2857)) / _e2863) * bitcast<f32>(((bitcast<u32>(_e2912) & 2147483647u) | (bitcast<u32>(_e2863) & 2147483648u))));
                                            }
                                            let _e2921 = phi_5322_;
                                            let _e2927 = local_8;
                                            let _e2929 = local_9;
                                            phi_3932_ = ((abs((_e2772.member + _e2921)) * 0.5f) * (_e2927 / _e2929));
                                        }
                                        let _e2933 = phi_3932_;
                                        phi_3933_ = _e2933;
                                        phi_3934_ = _e2154;
                                    }
                                    let _e2935 = phi_3933_;
                                    let _e2937 = phi_3934_;
                                    if _e2937 {
                                        let _e2940 = local_10;
                                        phi_3942_ = ((_e2940 * _e413.member_3) / f32(_e425));
                                    } else {
                                        phi_3942_ = _e2935;
                                    }
                                    let _e2945 = phi_3942_;
                                    phi_3943_ = _e2945;
                                } else {
                                    phi_3943_ = _e2148;
                                }
                                let _e2947 = phi_3943_;
                                phi_3952_ = vec3<f32>((_e413.member_6[0] * _e2947), (_e413.member_6[1] * _e2947), (_e413.member_6[2] * _e2947));
                            }
                            let _e2957 = phi_3952_;
                            phi_5544_ = _e2137;
                            phi_3968_ = vec3<f32>((_e272.x + (_e2957.x * _e418)), (_e272.y + (_e2957.y * _e418)), (_e272.z + (_e2957.z * _e418)));
                        } else {
                            phi_5544_ = _e371;
                            phi_3968_ = _e272;
                        }
                        let _e2972 = phi_5544_;
                        let _e2974 = phi_3968_;
                        phi_5543_ = _e2972;
                        phi_1482_ = _e2974;
                    } else {
                        phi_5543_ = _e268;
                        phi_1482_ = vec3<f32>();
                    }
                    let _e2976 = phi_5543_;
                    let _e2978 = phi_1482_;
                    continue;
                    continuing {
                        phi_5331_ = _e2976;
                        phi_1478_ = _e285;
                        phi_1481_ = _e2978;
                        phi_5542_ = _e2976;
                        break if !(_e291);
                    }
                }
                let _e2981 = phi_5542_;
                if _e2981 {
                    break;
                }
                let _e2983 = local_11;
                let _e2986 = local_12;
                let _e2989 = local_13;
                if _e142 {
                } else {
                    break;
                }
                out.member[_e141] = vec4<f32>(_e2983.x, _e2986.y, _e2989.z, 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_inject(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
