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
    var phi_5345_: bool;
    var phi_1478_: type_13;
    var phi_1481_: vec3<f32>;
    var phi_1479_: type_13;
    var phi_1504_: type_13;
    var phi_1543_: u32;
    var phi_1546_: u32;
    var phi_1570_: u32;
    var phi_1544_: u32;
    var phi_1547_: u32;
    var phi_5341_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1587_: f32;
    var phi_5386_: bool;
    var phi_1597_: type_33;
    var phi_1598_: u32;
    var phi_1599_: f32;
    var phi_5385_: bool;
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
    var phi_5381_: bool;
    var phi_1664_: type_13;
    var phi_1667_: f32;
    var phi_1669_: f32;
    var phi_1671_: f32;
    var phi_1665_: type_13;
    var phi_1694_: type_13;
    var phi_2288_: f32;
    var phi_4027_: f32;
    var phi_4035_: f32;
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
    var phi_4043_: f32;
    var phi_4051_: f32;
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
    var phi_5359_: bool;
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
    var phi_3566_: bool;
    var phi_3591_: u32;
    var phi_3601_: u32;
    var phi_3610_: bool;
    var phi_3626_: bool;
    var phi_3627_: bool;
    var phi_3650_: f32;
    var phi_3665_: f32;
    var phi_3675_: bool;
    var phi_3700_: u32;
    var phi_3710_: u32;
    var phi_3719_: bool;
    var phi_3735_: bool;
    var phi_3736_: bool;
    var phi_3817_: bool;
    var phi_3822_: bool;
    var phi_3827_: type_53;
    var phi_3829_: type_53;
    var phi_3831_: bool;
    var phi_3832_: type_53;
    var phi_3834_: bool;
    var phi_3835_: bool;
    var phi_3836_: type_53;
    var phi_3837_: bool;
    var phi_3838_: bool;
    var phi_3839_: bool;
    var phi_3852_: type_53;
    var phi_3859_: bool;
    var phi_5355_: bool;
    var phi_4018_: bool;
    var phi_2988_: u32;
    var phi_3000_: u32;
    var phi_3012_: u32;
    var phi_3024_: u32;
    var phi_5496_: bool;
    var phi_3864_: u32;
    var phi_3865_: bool;
    var phi_3881_: u32;
    var phi_3882_: u32;
    var phi_2599_: u32;
    var phi_2602_: u32;
    var phi_3884_: bool;
    var phi_3885_: bool;
    var phi_5494_: bool;
    var phi_4019_: bool;
    var phi_3898_: f32;
    var phi_5556_: bool;
    var phi_3899_: f32;
    var phi_5555_: bool;
    var phi_1668_: f32;
    var phi_1670_: f32;
    var phi_1672_: f32;
    var phi_5554_: bool;
    var local_5: f32;
    var local_6: f32;
    var phi_3912_: f32;
    var local_7: f32;
    var phi_4361_: bool;
    var phi_4372_: bool;
    var phi_4393_: type_61;
    var phi_4397_: type_61;
    var phi_4398_: vec3<f32>;
    var phi_4399_: vec3<f32>;
    var phi_4439_: vec3<f32>;
    var phi_4442_: vec3<f32>;
    var phi_4443_: bool;
    var phi_4487_: vec3<f32>;
    var phi_4490_: vec3<f32>;
    var phi_4491_: bool;
    var phi_4558_: f32;
    var phi_4566_: f32;
    var phi_4581_: f32;
    var phi_4587_: f32;
    var phi_4595_: f32;
    var phi_4605_: f32;
    var phi_4610_: type_61;
    var phi_4620_: bool;
    var phi_4631_: bool;
    var phi_4652_: type_61;
    var phi_4656_: type_61;
    var phi_4657_: vec3<f32>;
    var phi_4658_: vec3<f32>;
    var phi_4698_: vec3<f32>;
    var phi_4701_: vec3<f32>;
    var phi_4702_: bool;
    var phi_4746_: vec3<f32>;
    var phi_4749_: vec3<f32>;
    var phi_4750_: bool;
    var phi_4817_: f32;
    var phi_4825_: f32;
    var phi_4840_: f32;
    var phi_4846_: f32;
    var phi_4854_: f32;
    var phi_4864_: f32;
    var phi_4869_: type_61;
    var phi_4879_: bool;
    var phi_4911_: type_61;
    var phi_4915_: type_61;
    var phi_4916_: vec3<f32>;
    var phi_4917_: vec3<f32>;
    var phi_4957_: vec3<f32>;
    var phi_4960_: vec3<f32>;
    var phi_4961_: bool;
    var phi_5005_: vec3<f32>;
    var phi_5008_: vec3<f32>;
    var phi_5009_: bool;
    var phi_5076_: f32;
    var phi_5084_: f32;
    var phi_5099_: f32;
    var phi_5105_: f32;
    var phi_5113_: f32;
    var phi_5123_: f32;
    var phi_5128_: type_61;
    var phi_5170_: vec3<f32>;
    var phi_5173_: vec3<f32>;
    var phi_5174_: bool;
    var phi_5218_: vec3<f32>;
    var phi_5221_: vec3<f32>;
    var phi_5222_: bool;
    var phi_5289_: f32;
    var phi_5297_: f32;
    var phi_5312_: f32;
    var phi_5318_: f32;
    var phi_5326_: f32;
    var phi_5336_: f32;
    var local_8: f32;
    var local_9: f32;
    var phi_3946_: f32;
    var phi_3947_: f32;
    var phi_3948_: bool;
    var local_10: f32;
    var phi_3956_: f32;
    var phi_3957_: f32;
    var phi_3966_: vec3<f32>;
    var phi_5562_: bool;
    var phi_3982_: vec3<f32>;
    var phi_5561_: bool;
    var phi_1482_: vec3<f32>;
    var phi_5560_: bool;
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
                phi_5345_ = false;
                phi_1478_ = type_13(0u, (_e247 + select(0u, 1u, (_e218 > 0u))));
                phi_1481_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e268 = phi_5345_;
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
                                            phi_5341_ = true;
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
                                        phi_5341_ = _e268;
                                        break if !(_e315);
                                    }
                                }
                                let _e334 = phi_5341_;
                                phi_5560_ = _e334;
                                if _e334 {
                                    break;
                                }
                                let _e336 = local_3;
                                if (_e336 < _e133) {
                                } else {
                                    phi_5560_ = true;
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
                                phi_5386_ = _e334;
                                phi_1597_ = _e342;
                                phi_1598_ = (_e357 ^ (_e357 >> bitcast<u32>(16i)));
                                phi_1599_ = _e348;
                            } else {
                                phi_5386_ = _e268;
                                phi_1597_ = type_33();
                                phi_1598_ = u32();
                                phi_1599_ = f32();
                            }
                            let _e362 = phi_5386_;
                            let _e364 = phi_1597_;
                            let _e366 = phi_1598_;
                            let _e368 = phi_1599_;
                            phi_5385_ = _e362;
                            phi_1601_ = _e364;
                            phi_1602_ = _e366;
                            phi_1603_ = _e368;
                            phi_1604_ = select(true, false, _e246);
                        } else {
                            phi_5385_ = _e268;
                            phi_1601_ = type_33();
                            phi_1602_ = u32();
                            phi_1603_ = f32();
                            phi_1604_ = true;
                        }
                        let _e371 = phi_5385_;
                        let _e373 = phi_1601_;
                        let _e375 = phi_1602_;
                        let _e377 = phi_1603_;
                        let _e379 = phi_1604_;
                        if _e379 {
                            if _e305 {
                                if (_e287.member_1 < _e133) {
                                } else {
                                    phi_5560_ = true;
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
                            phi_5381_ = _e371;
                            phi_1664_ = type_13(0u, _e425);
                            phi_1667_ = 340282350000000000000000000000000000000f;
                            phi_1669_ = 0f;
                            phi_1671_ = 0f;
                            loop {
                                let _e428 = phi_5381_;
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
                                            phi_4043_ = (_e898 - 1f);
                                        } else {
                                            phi_4043_ = _e898;
                                        }
                                        let _e902 = phi_4043_;
                                        let _e904 = (0.000000059604645f * (f32(((2147483648u + (_e451.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e880 ^ (_e880 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                        if (_e904 >= 1f) {
                                            phi_4051_ = (_e904 - 1f);
                                        } else {
                                            phi_4051_ = _e904;
                                        }
                                        let _e908 = phi_4051_;
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
                                                    phi_4027_ = (_e581 - 1f);
                                                } else {
                                                    phi_4027_ = _e581;
                                                }
                                                let _e585 = phi_4027_;
                                                let _e587 = (0.000000059604645f * (f32(((2147483648u + (_e451.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e563 ^ (_e563 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e587 >= 1f) {
                                                    phi_4035_ = (_e587 - 1f);
                                                } else {
                                                    phi_4035_ = _e587;
                                                }
                                                let _e591 = phi_4035_;
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
                                            phi_5554_ = true;
                                            break;
                                        }
                                        let _e1064 = local_1[_e1053];
                                        let _e1065 = (1f / _e1064);
                                        let _e1066 = (_e1052 < 3u);
                                        if _e1066 {
                                        } else {
                                            phi_5554_ = true;
                                            break;
                                        }
                                        let _e1068 = local_1[_e1052];
                                        let _e1069 = (_e1068 * _e1065);
                                        let _e1070 = (_e1051 < 3u);
                                        if _e1070 {
                                        } else {
                                            phi_5554_ = true;
                                            break;
                                        }
                                        let _e1072 = local_1[_e1051];
                                        let _e1073 = (_e1072 * _e1065);
                                        if _e1066 {
                                        } else {
                                            phi_5554_ = true;
                                            break;
                                        }
                                        let _e1075 = local_2[_e1052];
                                        if _e1070 {
                                        } else {
                                            phi_5554_ = true;
                                            break;
                                        }
                                        let _e1077 = local_2[_e1051];
                                        if _e1062 {
                                        } else {
                                            phi_5554_ = true;
                                            break;
                                        }
                                        let _e1079 = local_2[_e1053];
                                        if (0u < _e122) {
                                        } else {
                                            phi_5554_ = true;
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
                                        phi_5359_ = _e428;
                                        phi_2598_ = 0u;
                                        phi_2601_ = 0u;
                                        loop {
                                            let _e1150 = phi_5359_;
                                            let _e1152 = phi_2598_;
                                            let _e1154 = phi_2601_;
                                            let _e1155 = (_e1152 & 15u);
                                            let _e1157 = (_e1152 >> bitcast<u32>(4u));
                                            if (_e1155 == 0u) {
                                                if (_e1157 < _e122) {
                                                } else {
                                                    phi_5494_ = true;
                                                    phi_4019_ = bool();
                                                    break;
                                                }
                                                let _e1861 = nodes.member[_e1157].member;
                                                let _e1870 = ((_e1861.x - _e1124) * _e1136);
                                                let _e1871 = ((_e1861.y - _e1124) * _e1136);
                                                let _e1872 = ((_e1861.z - _e1124) * _e1136);
                                                let _e1873 = ((_e1861.w - _e1124) * _e1136);
                                                let _e1876 = nodes.member[_e1157].member_3;
                                                let _e1885 = ((_e1876.x - _e1129) * _e1136);
                                                let _e1886 = ((_e1876.y - _e1129) * _e1136);
                                                let _e1887 = ((_e1876.z - _e1129) * _e1136);
                                                let _e1888 = ((_e1876.w - _e1129) * _e1136);
                                                let _e1891 = nodes.member[_e1157].member_1;
                                                let _e1900 = ((_e1891.x - _e1126) * _e1141);
                                                let _e1901 = ((_e1891.y - _e1126) * _e1141);
                                                let _e1902 = ((_e1891.z - _e1126) * _e1141);
                                                let _e1903 = ((_e1891.w - _e1126) * _e1141);
                                                let _e1906 = nodes.member[_e1157].member_4;
                                                let _e1915 = ((_e1906.x - _e1130) * _e1141);
                                                let _e1916 = ((_e1906.y - _e1130) * _e1141);
                                                let _e1917 = ((_e1906.z - _e1130) * _e1141);
                                                let _e1918 = ((_e1906.w - _e1130) * _e1141);
                                                let _e1921 = nodes.member[_e1157].member_2;
                                                let _e1930 = ((_e1921.x - _e1128) * _e1146);
                                                let _e1931 = ((_e1921.y - _e1128) * _e1146);
                                                let _e1932 = ((_e1921.z - _e1128) * _e1146);
                                                let _e1933 = ((_e1921.w - _e1128) * _e1146);
                                                let _e1936 = nodes.member[_e1157].member_5;
                                                let _e1945 = ((_e1936.x - _e1131) * _e1146);
                                                let _e1946 = ((_e1936.y - _e1131) * _e1146);
                                                let _e1947 = ((_e1936.z - _e1131) * _e1146);
                                                let _e1948 = ((_e1936.w - _e1131) * _e1146);
                                                let _e1950 = select(_e1885, _e1870, (_e1870 < _e1885));
                                                let _e1952 = select(_e1886, _e1871, (_e1871 < _e1886));
                                                let _e1954 = select(_e1887, _e1872, (_e1872 < _e1887));
                                                let _e1956 = select(_e1888, _e1873, (_e1873 < _e1888));
                                                let _e1958 = select(_e1915, _e1900, (_e1900 < _e1915));
                                                let _e1960 = select(_e1916, _e1901, (_e1901 < _e1916));
                                                let _e1962 = select(_e1917, _e1902, (_e1902 < _e1917));
                                                let _e1964 = select(_e1918, _e1903, (_e1903 < _e1918));
                                                let _e1966 = select(_e1958, _e1950, (_e1950 > _e1958));
                                                let _e1968 = select(_e1960, _e1952, (_e1952 > _e1960));
                                                let _e1970 = select(_e1962, _e1954, (_e1954 > _e1962));
                                                let _e1972 = select(_e1964, _e1956, (_e1956 > _e1964));
                                                let _e1974 = select(_e1945, _e1930, (_e1930 < _e1945));
                                                let _e1976 = select(_e1946, _e1931, (_e1931 < _e1946));
                                                let _e1978 = select(_e1947, _e1932, (_e1932 < _e1947));
                                                let _e1980 = select(_e1948, _e1933, (_e1933 < _e1948));
                                                let _e1982 = select(_e1974, _e1966, (_e1966 > _e1974));
                                                let _e1984 = select(_e1976, _e1968, (_e1968 > _e1976));
                                                let _e1986 = select(_e1978, _e1970, (_e1970 > _e1978));
                                                let _e1988 = select(_e1980, _e1972, (_e1972 > _e1980));
                                                let _e1990 = select(_e1016.member_2, _e1982, (_e1982 > _e1016.member_2));
                                                let _e1992 = select(_e1016.member_2, _e1984, (_e1984 > _e1016.member_2));
                                                let _e1994 = select(_e1016.member_2, _e1986, (_e1986 > _e1016.member_2));
                                                let _e1996 = select(_e1016.member_2, _e1988, (_e1988 > _e1016.member_2));
                                                let _e1998 = select(_e1885, _e1870, (_e1870 > _e1885));
                                                let _e2000 = select(_e1886, _e1871, (_e1871 > _e1886));
                                                let _e2002 = select(_e1887, _e1872, (_e1872 > _e1887));
                                                let _e2004 = select(_e1888, _e1873, (_e1873 > _e1888));
                                                let _e2006 = select(_e1915, _e1900, (_e1900 > _e1915));
                                                let _e2008 = select(_e1916, _e1901, (_e1901 > _e1916));
                                                let _e2010 = select(_e1917, _e1902, (_e1902 > _e1917));
                                                let _e2012 = select(_e1918, _e1903, (_e1903 > _e1918));
                                                let _e2014 = select(_e2006, _e1998, (_e1998 < _e2006));
                                                let _e2016 = select(_e2008, _e2000, (_e2000 < _e2008));
                                                let _e2018 = select(_e2010, _e2002, (_e2002 < _e2010));
                                                let _e2020 = select(_e2012, _e2004, (_e2004 < _e2012));
                                                let _e2022 = select(_e1945, _e1930, (_e1930 > _e1945));
                                                let _e2024 = select(_e1946, _e1931, (_e1931 > _e1946));
                                                let _e2026 = select(_e1947, _e1932, (_e1932 > _e1947));
                                                let _e2028 = select(_e1948, _e1933, (_e1933 > _e1948));
                                                let _e2030 = select(_e2022, _e2014, (_e2014 < _e2022));
                                                let _e2032 = select(_e2024, _e2016, (_e2016 < _e2024));
                                                let _e2034 = select(_e2026, _e2018, (_e2018 < _e2026));
                                                let _e2036 = select(_e2028, _e2020, (_e2020 < _e2028));
                                                let _e2056 = nodes.member[_e1157].member_6[0u];
                                                let _e2060 = nodes.member[_e1157].member_6[1u];
                                                let _e2064 = nodes.member[_e1157].member_6[2u];
                                                let _e2068 = nodes.member[_e1157].member_6[3u];
                                                if (select(340282350000000000000000000000000000000f, _e1996, (_e1996 <= select(_e1016.member_3, _e2036, (_e2036 < _e1016.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e1154 < 64u) {
                                                    } else {
                                                        phi_5494_ = true;
                                                        phi_4019_ = bool();
                                                        break;
                                                    }
                                                    local[_e1154] = _e2068;
                                                    phi_2988_ = (_e1154 + 1u);
                                                } else {
                                                    phi_2988_ = _e1154;
                                                }
                                                let _e2074 = phi_2988_;
                                                if (select(340282350000000000000000000000000000000f, _e1994, (_e1994 <= select(_e1016.member_3, _e2034, (_e2034 < _e1016.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2074 < 64u) {
                                                    } else {
                                                        phi_5494_ = true;
                                                        phi_4019_ = bool();
                                                        break;
                                                    }
                                                    local[_e2074] = _e2064;
                                                    phi_3000_ = (_e2074 + 1u);
                                                } else {
                                                    phi_3000_ = _e2074;
                                                }
                                                let _e2080 = phi_3000_;
                                                if (select(340282350000000000000000000000000000000f, _e1992, (_e1992 <= select(_e1016.member_3, _e2032, (_e2032 < _e1016.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2080 < 64u) {
                                                    } else {
                                                        phi_5494_ = true;
                                                        phi_4019_ = bool();
                                                        break;
                                                    }
                                                    local[_e2080] = _e2060;
                                                    phi_3012_ = (_e2080 + 1u);
                                                } else {
                                                    phi_3012_ = _e2080;
                                                }
                                                let _e2086 = phi_3012_;
                                                if (select(340282350000000000000000000000000000000f, _e1990, (_e1990 <= select(_e1016.member_3, _e2030, (_e2030 < _e1016.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2086 < 64u) {
                                                    } else {
                                                        phi_5494_ = true;
                                                        phi_4019_ = bool();
                                                        break;
                                                    }
                                                    local[_e2086] = _e2056;
                                                    phi_3024_ = (_e2086 + 1u);
                                                } else {
                                                    phi_3024_ = _e2086;
                                                }
                                                let _e2092 = phi_3024_;
                                                phi_5496_ = _e1150;
                                                phi_3864_ = _e2092;
                                                phi_3865_ = true;
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
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
                                                            break;
                                                        }
                                                        if _e1062 {
                                                        } else {
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
                                                            break;
                                                        }
                                                        let _e1186 = triangles.member[_e1177.member_1].member[_e1053];
                                                        let _e1187 = (_e1186 - _e1079);
                                                        if _e1062 {
                                                        } else {
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
                                                            break;
                                                        }
                                                        let _e1191 = triangles.member[_e1177.member_1].member_2[_e1053];
                                                        let _e1192 = (_e1191 - _e1079);
                                                        if _e1062 {
                                                        } else {
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
                                                            break;
                                                        }
                                                        let _e1196 = triangles.member[_e1177.member_1].member_4[_e1053];
                                                        let _e1197 = (_e1196 - _e1079);
                                                        if _e1066 {
                                                        } else {
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
                                                            break;
                                                        }
                                                        let _e1201 = triangles.member[_e1177.member_1].member[_e1052];
                                                        let _e1204 = ((_e1201 - _e1075) - (_e1069 * _e1187));
                                                        if _e1070 {
                                                        } else {
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
                                                            break;
                                                        }
                                                        let _e1208 = triangles.member[_e1177.member_1].member[_e1051];
                                                        let _e1211 = ((_e1208 - _e1077) - (_e1073 * _e1187));
                                                        if _e1066 {
                                                        } else {
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
                                                            break;
                                                        }
                                                        let _e1215 = triangles.member[_e1177.member_1].member_2[_e1052];
                                                        let _e1218 = ((_e1215 - _e1075) - (_e1069 * _e1192));
                                                        if _e1070 {
                                                        } else {
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
                                                            break;
                                                        }
                                                        let _e1222 = triangles.member[_e1177.member_1].member_2[_e1051];
                                                        let _e1225 = ((_e1222 - _e1077) - (_e1073 * _e1192));
                                                        if _e1066 {
                                                        } else {
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
                                                            break;
                                                        }
                                                        let _e1229 = triangles.member[_e1177.member_1].member_4[_e1052];
                                                        let _e1232 = ((_e1229 - _e1075) - (_e1069 * _e1197));
                                                        if _e1070 {
                                                        } else {
                                                            phi_5355_ = true;
                                                            phi_4018_ = bool();
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
                                                                        phi_5355_ = true;
                                                                        phi_4018_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e1561 = triangles.member[_e1177.member_1].member_3;
                                                                    if ((_e1561 & 1u) == 0u) {
                                                                        phi_3822_ = true;
                                                                    } else {
                                                                        if _e1182 {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1566 = triangles.member[_e1177.member_1].member_1;
                                                                        let _e1567 = (_e1566 * 12u);
                                                                        if ((256u + _e1567) < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 257u) < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 258u) < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1574 = (_e1567 + 259u);
                                                                        if (_e1574 < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1577 = surfaces.member[_e1574];
                                                                        if ((_e1567 + 260u) < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 261u) < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 262u) < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1584 = (_e1567 + 263u);
                                                                        if (_e1584 < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1587 = surfaces.member[_e1584];
                                                                        let _e1588 = (_e1567 + 264u);
                                                                        if (_e1588 < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1591 = surfaces.member[_e1588];
                                                                        let _e1592 = bitcast<f32>(_e1591);
                                                                        let _e1593 = (_e1567 + 265u);
                                                                        if (_e1593 < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1596 = surfaces.member[_e1593];
                                                                        let _e1597 = bitcast<f32>(_e1596);
                                                                        if ((_e1567 + 266u) < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1567 + 267u) < _e131) {
                                                                        } else {
                                                                            phi_5355_ = true;
                                                                            phi_4018_ = bool();
                                                                            break;
                                                                        }
                                                                        if (_e1577 == 4294967295u) {
                                                                            phi_3817_ = (_e1592 < _e1597);
                                                                        } else {
                                                                            if (_e1177.member_1 < arrayLength((&attributes.member))) {
                                                                            } else {
                                                                                phi_5355_ = true;
                                                                                phi_4018_ = bool();
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
                                                                            if (_e1663 >= 0f) {
                                                                                phi_3566_ = select(true, false, (_e1663 <= 1f));
                                                                            } else {
                                                                                phi_3566_ = true;
                                                                            }
                                                                            let _e1668 = phi_3566_;
                                                                            let _e1672 = ((select(_e1663, 0f, _e1668) * f32(_e1640)) - 0.5f);
                                                                            let _e1673 = floor(_e1672);
                                                                            let _e1674 = (_e1673 < 0f);
                                                                            if _e1674 {
                                                                                phi_3591_ = 0u;
                                                                            } else {
                                                                                let _e1679 = select(select(u32(_e1673), 0u, (_e1673 < 0f)), 4294967295u, (_e1673 > 4294967000f));
                                                                                phi_3591_ = select(_e1679, _e1646, (_e1646 < _e1679));
                                                                            }
                                                                            let _e1683 = phi_3591_;
                                                                            if _e1674 {
                                                                                phi_3601_ = 0u;
                                                                            } else {
                                                                                let _e1684 = (_e1683 + 1u);
                                                                                phi_3601_ = select(_e1684, _e1646, (_e1646 < _e1684));
                                                                            }
                                                                            let _e1688 = phi_3601_;
                                                                            let _e1689 = (_e1645 == 0u);
                                                                            if _e1689 {
                                                                                phi_3610_ = select(true, false, _e1674);
                                                                            } else {
                                                                                phi_3610_ = true;
                                                                            }
                                                                            let _e1692 = phi_3610_;
                                                                            let _e1693 = select(_e1646, _e1683, _e1692);
                                                                            if _e1689 {
                                                                                if _e1674 {
                                                                                    phi_3626_ = true;
                                                                                } else {
                                                                                    phi_3626_ = select(true, false, (_e1693 == _e1646));
                                                                                }
                                                                                let _e1697 = phi_3626_;
                                                                                phi_3627_ = _e1697;
                                                                            } else {
                                                                                phi_3627_ = true;
                                                                            }
                                                                            let _e1699 = phi_3627_;
                                                                            let _e1700 = select(0u, _e1688, _e1699);
                                                                            let _e1701 = (_e1672 - _e1673);
                                                                            let _e1704 = ((_e1577 >> bitcast<u32>(30u)) & 3u);
                                                                            let _e1705 = (_e1642 - 1u);
                                                                            let _e1707 = select(1f, 2f, (_e1704 == 2u));
                                                                            let _e1711 = (_e1639 - (floor((_e1639 / _e1707)) * _e1707));
                                                                            if (_e1711 > 1f) {
                                                                                phi_3650_ = (_e1707 - _e1711);
                                                                            } else {
                                                                                phi_3650_ = _e1711;
                                                                            }
                                                                            let _e1715 = phi_3650_;
                                                                            if (_e1704 == 1u) {
                                                                                let _e1718 = select(0f, _e1639, (_e1639 > 0f));
                                                                                phi_3665_ = select(1f, _e1718, (_e1718 < 1f));
                                                                            } else {
                                                                                phi_3665_ = _e1715;
                                                                            }
                                                                            let _e1722 = phi_3665_;
                                                                            if (_e1722 >= 0f) {
                                                                                phi_3675_ = select(true, false, (_e1722 <= 1f));
                                                                            } else {
                                                                                phi_3675_ = true;
                                                                            }
                                                                            let _e1727 = phi_3675_;
                                                                            let _e1731 = ((select(_e1722, 0f, _e1727) * f32(_e1642)) - 0.5f);
                                                                            let _e1732 = floor(_e1731);
                                                                            let _e1733 = (_e1732 < 0f);
                                                                            if _e1733 {
                                                                                phi_3700_ = 0u;
                                                                            } else {
                                                                                let _e1738 = select(select(u32(_e1732), 0u, (_e1732 < 0f)), 4294967295u, (_e1732 > 4294967000f));
                                                                                phi_3700_ = select(_e1738, _e1705, (_e1705 < _e1738));
                                                                            }
                                                                            let _e1742 = phi_3700_;
                                                                            if _e1733 {
                                                                                phi_3710_ = 0u;
                                                                            } else {
                                                                                let _e1743 = (_e1742 + 1u);
                                                                                phi_3710_ = select(_e1743, _e1705, (_e1705 < _e1743));
                                                                            }
                                                                            let _e1747 = phi_3710_;
                                                                            let _e1748 = (_e1704 == 0u);
                                                                            if _e1748 {
                                                                                phi_3719_ = select(true, false, _e1733);
                                                                            } else {
                                                                                phi_3719_ = true;
                                                                            }
                                                                            let _e1751 = phi_3719_;
                                                                            let _e1752 = select(_e1705, _e1742, _e1751);
                                                                            if _e1748 {
                                                                                if _e1733 {
                                                                                    phi_3735_ = true;
                                                                                } else {
                                                                                    phi_3735_ = select(true, false, (_e1752 == _e1705));
                                                                                }
                                                                                let _e1756 = phi_3735_;
                                                                                phi_3736_ = _e1756;
                                                                            } else {
                                                                                phi_3736_ = true;
                                                                            }
                                                                            let _e1758 = phi_3736_;
                                                                            let _e1760 = (_e1731 - _e1732);
                                                                            let _e1761 = (_e1577 & 268435455u);
                                                                            let _e1763 = (_e1761 + (_e1752 * _e1640));
                                                                            let _e1765 = (_e1761 + (select(0u, _e1747, _e1758) * _e1640));
                                                                            let _e1766 = (_e1763 + _e1693);
                                                                            let _e1767 = (_e1763 + _e1700);
                                                                            let _e1768 = (_e1765 + _e1693);
                                                                            let _e1769 = (_e1765 + _e1700);
                                                                            if (_e1766 < _e131) {
                                                                            } else {
                                                                                phi_5355_ = true;
                                                                                phi_4018_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1772 = surfaces.member[_e1766];
                                                                            if (_e1767 < _e131) {
                                                                            } else {
                                                                                phi_5355_ = true;
                                                                                phi_4018_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1775 = surfaces.member[_e1767];
                                                                            if (_e1768 < _e131) {
                                                                            } else {
                                                                                phi_5355_ = true;
                                                                                phi_4018_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1778 = surfaces.member[_e1768];
                                                                            if (_e1769 < _e131) {
                                                                            } else {
                                                                                phi_5355_ = true;
                                                                                phi_4018_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1781 = surfaces.member[_e1769];
                                                                            let _e1798 = (1f - _e1701);
                                                                            phi_3817_ = ((_e1592 * (((((f32((_e1772 >> bitcast<u32>(24i))) * 0.003921569f) * _e1798) + ((f32((_e1775 >> bitcast<u32>(24i))) * 0.003921569f) * _e1701)) * (1f - _e1760)) + ((((f32((_e1778 >> bitcast<u32>(24i))) * 0.003921569f) * _e1798) + ((f32((_e1781 >> bitcast<u32>(24i))) * 0.003921569f) * _e1701)) * _e1760))) < _e1597);
                                                                        }
                                                                        let _e1813 = phi_3817_;
                                                                        phi_3822_ = select(true, false, _e1813);
                                                                    }
                                                                    let _e1816 = phi_3822_;
                                                                    if _e1816 {
                                                                        phi_3827_ = type_53(_e1551[0], _e1177.member_1, _e1551[1], _e1551[2]);
                                                                    } else {
                                                                        phi_3827_ = type_53();
                                                                    }
                                                                    let _e1819 = phi_3827_;
                                                                    phi_3829_ = _e1819;
                                                                    phi_3831_ = select(true, false, _e1816);
                                                                } else {
                                                                    phi_3829_ = type_53();
                                                                    phi_3831_ = false;
                                                                }
                                                                let _e1822 = phi_3829_;
                                                                let _e1824 = phi_3831_;
                                                                phi_3832_ = _e1822;
                                                                phi_3834_ = select(true, false, _e1558);
                                                                phi_3835_ = _e1824;
                                                            } else {
                                                                phi_3832_ = type_53();
                                                                phi_3834_ = false;
                                                                phi_3835_ = false;
                                                            }
                                                            let _e1827 = phi_3832_;
                                                            let _e1829 = phi_3834_;
                                                            let _e1831 = phi_3835_;
                                                            phi_3836_ = _e1827;
                                                            phi_3837_ = select(true, false, _e1557);
                                                            phi_3838_ = _e1829;
                                                            phi_3839_ = _e1831;
                                                        } else {
                                                            phi_3836_ = type_53();
                                                            phi_3837_ = true;
                                                            phi_3838_ = false;
                                                            phi_3839_ = false;
                                                        }
                                                        let _e1834 = phi_3836_;
                                                        let _e1836 = phi_3837_;
                                                        let _e1838 = phi_3838_;
                                                        let _e1840 = phi_3839_;
                                                        if select(select(_e1840, false, _e1836), true, select(_e1838, true, _e1836)) {
                                                            phi_3852_ = type_53(_e1016.member_3, 4294967295u, 0f, 0f);
                                                        } else {
                                                            phi_3852_ = _e1834;
                                                        }
                                                        let _e1845 = phi_3852_;
                                                        phi_3859_ = select(true, false, (_e1845.member_1 != 4294967295u));
                                                    } else {
                                                        phi_3859_ = false;
                                                    }
                                                    let _e1850 = phi_3859_;
                                                    continue;
                                                    continuing {
                                                        phi_3028_ = _e1175;
                                                        phi_5355_ = _e1150;
                                                        phi_4018_ = select(true, false, _e1181);
                                                        break if !(_e1850);
                                                    }
                                                }
                                                let _e1854 = phi_5355_;
                                                let _e1856 = phi_4018_;
                                                phi_5494_ = _e1854;
                                                phi_4019_ = bool();
                                                if _e1854 {
                                                    break;
                                                }
                                                phi_5496_ = _e1854;
                                                phi_3864_ = _e1154;
                                                phi_3865_ = _e1856;
                                            }
                                            let _e2094 = phi_5496_;
                                            let _e2096 = phi_3864_;
                                            let _e2098 = phi_3865_;
                                            if _e2098 {
                                                let _e2099 = (_e2096 == 0u);
                                                if _e2099 {
                                                    phi_3881_ = u32();
                                                    phi_3882_ = u32();
                                                } else {
                                                    let _e2100 = (_e2096 - 1u);
                                                    if (_e2100 < 64u) {
                                                    } else {
                                                        phi_5494_ = true;
                                                        phi_4019_ = bool();
                                                        break;
                                                    }
                                                    let _e2103 = local[_e2100];
                                                    phi_3881_ = _e2103;
                                                    phi_3882_ = _e2100;
                                                }
                                                let _e2105 = phi_3881_;
                                                let _e2107 = phi_3882_;
                                                phi_2599_ = _e2105;
                                                phi_2602_ = _e2107;
                                                phi_3884_ = select(true, false, _e2099);
                                                phi_3885_ = _e2099;
                                            } else {
                                                phi_2599_ = u32();
                                                phi_2602_ = u32();
                                                phi_3884_ = false;
                                                phi_3885_ = false;
                                            }
                                            let _e2110 = phi_2599_;
                                            let _e2112 = phi_2602_;
                                            let _e2114 = phi_3884_;
                                            let _e2116 = phi_3885_;
                                            continue;
                                            continuing {
                                                phi_5359_ = _e2094;
                                                phi_2598_ = _e2110;
                                                phi_2601_ = _e2112;
                                                phi_5494_ = _e2094;
                                                phi_4019_ = _e2116;
                                                break if !(_e2114);
                                            }
                                        }
                                        let _e2119 = phi_5494_;
                                        let _e2121 = phi_4019_;
                                        phi_5554_ = _e2119;
                                        if _e2119 {
                                            break;
                                        }
                                        if select(false, true, select(true, false, _e2121)) {
                                            phi_3898_ = _e434;
                                        } else {
                                            phi_3898_ = (_e434 + _e1017);
                                        }
                                        let _e2126 = phi_3898_;
                                        phi_5556_ = _e2119;
                                        phi_3899_ = _e2126;
                                    } else {
                                        phi_5556_ = _e428;
                                        phi_3899_ = _e434;
                                    }
                                    let _e2128 = phi_5556_;
                                    let _e2130 = phi_3899_;
                                    phi_5555_ = _e2128;
                                    phi_1668_ = select(_e1018, _e432, (_e432 < _e1018));
                                    phi_1670_ = _e2130;
                                    phi_1672_ = (_e436 + _e1017);
                                } else {
                                    phi_5555_ = _e428;
                                    phi_1668_ = f32();
                                    phi_1670_ = f32();
                                    phi_1672_ = f32();
                                }
                                let _e2132 = phi_5555_;
                                let _e2134 = phi_1668_;
                                let _e2136 = phi_1670_;
                                let _e2138 = phi_1672_;
                                continue;
                                continuing {
                                    phi_5381_ = _e2132;
                                    phi_1664_ = _e449;
                                    phi_1667_ = _e2134;
                                    phi_1669_ = _e2136;
                                    phi_1671_ = _e2138;
                                    phi_5554_ = _e2132;
                                    break if !(_e455);
                                }
                            }
                            let _e2141 = phi_5554_;
                            phi_5560_ = _e2141;
                            if _e2141 {
                                break;
                            }
                            let _e2143 = local_5;
                            if (_e2143 <= 0f) {
                                phi_3966_ = vec3<f32>(0f, 0f, 0f);
                            } else {
                                if (_e413.member_1 == 4294967295u) {
                                    let _e2147 = local_6;
                                    phi_3912_ = ((3.1415927f * _e2147) / f32(_e425));
                                } else {
                                    let _e3168 = local_14;
                                    phi_3912_ = _e3168;
                                }
                                let _e2152 = phi_3912_;
                                if _e421 {
                                    if (_e425 == 1u) {
                                        phi_3947_ = f32();
                                        phi_3948_ = true;
                                    } else {
                                        let _e2156 = local_7;
                                        let _e2158 = (_e413.member_3 < (0.01f * _e2156));
                                        if _e2158 {
                                            phi_3946_ = f32();
                                        } else {
                                            let _e2174 = (_e413.member[0] - _e147.member[0]);
                                            let _e2175 = (_e413.member[1] - _e147.member[1]);
                                            let _e2176 = (_e413.member[2] - _e147.member[2]);
                                            let _e2177 = (vec3<f32>(_e413.member[0], _e413.member[1], _e413.member[2]) - _e174);
                                            let _e2178 = (_e413.member_2[0] - _e147.member[0]);
                                            let _e2179 = (_e413.member_2[1] - _e147.member[1]);
                                            let _e2180 = (_e413.member_2[2] - _e147.member[2]);
                                            let _e2181 = (vec3<f32>(_e413.member_2[0], _e413.member_2[1], _e413.member_2[2]) - _e174);
                                            let _e2182 = (_e413.member_4[0] - _e147.member[0]);
                                            let _e2183 = (_e413.member_4[1] - _e147.member[1]);
                                            let _e2184 = (_e413.member_4[2] - _e147.member[2]);
                                            let _e2185 = (vec3<f32>(_e413.member_4[0], _e413.member_4[1], _e413.member_4[2]) - _e174);
                                            let _e2193 = (((_e169.x * _e2174) + (_e169.y * _e2175)) + (_e169.z * _e2176));
                                            let _e2198 = (((_e169.x * _e2178) + (_e169.y * _e2179)) + (_e169.z * _e2180));
                                            let _e2203 = (((_e169.x * _e2182) + (_e169.y * _e2183)) + (_e169.z * _e2184));
                                            let _e2204 = (_e2193 <= 0f);
                                            if _e2204 {
                                                phi_4361_ = select(true, false, (_e2198 <= 0f));
                                            } else {
                                                phi_4361_ = true;
                                            }
                                            let _e2208 = phi_4361_;
                                            if _e2208 {
                                                if _e2204 {
                                                    phi_4372_ = true;
                                                } else {
                                                    phi_4372_ = (_e2198 <= 0f);
                                                }
                                                let _e2211 = phi_4372_;
                                                if _e2211 {
                                                    let _e2216 = (_e2193 / (_e2193 - _e2198));
                                                    let _e2223 = vec3<f32>((_e2174 + ((_e2178 - _e2174) * _e2216)), (_e2175 + ((_e2179 - _e2175) * _e2216)), (_e2176 + ((_e2180 - _e2176) * _e2216)));
                                                    if _e2204 {
                                                        phi_4393_ = type_61(0f, vec3<f32>(0f, 0f, 0f), _e2223);
                                                    } else {
                                                        phi_4393_ = type_61(0f, _e2223, vec3<f32>(0f, 0f, 0f));
                                                    }
                                                    let _e2227 = phi_4393_;
                                                    let _e2228 = vec3(_e2204);
                                                    phi_4397_ = _e2227;
                                                    phi_4398_ = select(_e2223, _e2181, _e2228);
                                                    phi_4399_ = select(_e2177, _e2223, _e2228);
                                                } else {
                                                    phi_4397_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                    phi_4398_ = _e2181;
                                                    phi_4399_ = _e2177;
                                                }
                                                let _e2232 = phi_4397_;
                                                let _e2234 = phi_4398_;
                                                let _e2236 = phi_4399_;
                                                let _e2238 = abs(_e2236.x);
                                                let _e2240 = abs(_e2236.y);
                                                let _e2242 = select(_e2240, _e2238, (_e2238 > _e2240));
                                                let _e2244 = abs(_e2236.z);
                                                let _e2246 = select(_e2244, _e2242, (_e2242 > _e2244));
                                                if (_e2246 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2248 = (_e2246 < 340282350000000000000000000000000000000f);
                                                    if _e2248 {
                                                        let _e2249 = (_e2236.x / _e2246);
                                                        let _e2250 = (_e2236.y / _e2246);
                                                        let _e2251 = (_e2236.z / _e2246);
                                                        let _e2257 = sqrt((((_e2249 * _e2249) + (_e2250 * _e2250)) + (_e2251 * _e2251)));
                                                        phi_4439_ = vec3<f32>((_e2249 / _e2257), (_e2250 / _e2257), (_e2251 / _e2257));
                                                    } else {
                                                        phi_4439_ = vec3<f32>();
                                                    }
                                                    let _e2263 = phi_4439_;
                                                    phi_4442_ = _e2263;
                                                    phi_4443_ = select(true, false, _e2248);
                                                } else {
                                                    phi_4442_ = vec3<f32>();
                                                    phi_4443_ = true;
                                                }
                                                let _e2266 = phi_4442_;
                                                let _e2268 = phi_4443_;
                                                let _e2270 = select(_e2266, vec3<f32>(0f, 0f, 0f), vec3(_e2268));
                                                let _e2272 = abs(_e2234.x);
                                                let _e2274 = abs(_e2234.y);
                                                let _e2276 = select(_e2274, _e2272, (_e2272 > _e2274));
                                                let _e2278 = abs(_e2234.z);
                                                let _e2280 = select(_e2278, _e2276, (_e2276 > _e2278));
                                                if (_e2280 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2282 = (_e2280 < 340282350000000000000000000000000000000f);
                                                    if _e2282 {
                                                        let _e2283 = (_e2234.x / _e2280);
                                                        let _e2284 = (_e2234.y / _e2280);
                                                        let _e2285 = (_e2234.z / _e2280);
                                                        let _e2291 = sqrt((((_e2283 * _e2283) + (_e2284 * _e2284)) + (_e2285 * _e2285)));
                                                        phi_4487_ = vec3<f32>((_e2283 / _e2291), (_e2284 / _e2291), (_e2285 / _e2291));
                                                    } else {
                                                        phi_4487_ = vec3<f32>();
                                                    }
                                                    let _e2297 = phi_4487_;
                                                    phi_4490_ = _e2297;
                                                    phi_4491_ = select(true, false, _e2282);
                                                } else {
                                                    phi_4490_ = vec3<f32>();
                                                    phi_4491_ = true;
                                                }
                                                let _e2300 = phi_4490_;
                                                let _e2302 = phi_4491_;
                                                let _e2304 = select(_e2300, vec3<f32>(0f, 0f, 0f), vec3(_e2302));
                                                let _e2311 = ((_e2270.y * _e2304.z) - (_e2304.y * _e2270.z));
                                                let _e2316 = ((_e2270.z * _e2304.x) - (_e2304.z * _e2270.x));
                                                let _e2319 = ((_e2270.x * _e2304.y) - (_e2304.x * _e2270.y));
                                                let _e2325 = sqrt((((_e2311 * _e2311) + (_e2316 * _e2316)) + (_e2319 * _e2319)));
                                                if (_e2325 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4605_ = 0f;
                                                } else {
                                                    let _e2337 = (((_e2270.x * _e2304.x) + (_e2270.y * _e2304.y)) + (_e2270.z * _e2304.z));
                                                    let _e2338 = abs(_e2337);
                                                    let _e2339 = abs(_e2325);
                                                    let _e2340 = (_e2339 > _e2338);
                                                    let _e2341 = select(_e2338, _e2339, _e2340);
                                                    if (_e2341 > 0f) {
                                                        phi_4558_ = (select(_e2339, _e2338, _e2340) / _e2341);
                                                    } else {
                                                        phi_4558_ = 0f;
                                                    }
                                                    let _e2346 = phi_4558_;
                                                    let _e2347 = (_e2346 > 0.41421357f);
                                                    if _e2347 {
                                                        phi_4566_ = ((_e2346 - 1f) / (_e2346 + 1f));
                                                    } else {
                                                        phi_4566_ = _e2346;
                                                    }
                                                    let _e2352 = phi_4566_;
                                                    let _e2353 = (_e2352 * _e2352);
                                                    let _e2362 = (_e2352 + ((_e2352 * _e2353) * (-0.3333295f + (_e2353 * (0.19977711f + (_e2353 * (-0.13877685f + (_e2353 * 0.080537446f))))))));
                                                    if _e2347 {
                                                        phi_4581_ = (_e2362 + 0.7853982f);
                                                    } else {
                                                        phi_4581_ = _e2362;
                                                    }
                                                    let _e2365 = phi_4581_;
                                                    if _e2340 {
                                                        phi_4587_ = (1.5707964f - _e2365);
                                                    } else {
                                                        phi_4587_ = _e2365;
                                                    }
                                                    let _e2368 = phi_4587_;
                                                    if ((bitcast<u32>(_e2337) & 2147483648u) == 0u) {
                                                        phi_4595_ = _e2368;
                                                    } else {
                                                        phi_4595_ = (3.1415927f - _e2368);
                                                    }
                                                    let _e2374 = phi_4595_;
                                                    phi_4605_ = (((((_e169.x * _e2311) + (_e169.y * _e2316)) + (_e169.z * _e2319)) / _e2325) * bitcast<f32>(((bitcast<u32>(_e2374) & 2147483647u) | (bitcast<u32>(_e2325) & 2147483648u))));
                                                }
                                                let _e2383 = phi_4605_;
                                                phi_4610_ = type_61((_e2232.member + _e2383), _e2232.member_1, _e2232.member_2);
                                            } else {
                                                phi_4610_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                            }
                                            let _e2391 = phi_4610_;
                                            let _e2392 = (_e2198 <= 0f);
                                            if _e2392 {
                                                phi_4620_ = select(true, false, (_e2203 <= 0f));
                                            } else {
                                                phi_4620_ = true;
                                            }
                                            let _e2396 = phi_4620_;
                                            if _e2396 {
                                                if _e2392 {
                                                    phi_4631_ = true;
                                                } else {
                                                    phi_4631_ = (_e2203 <= 0f);
                                                }
                                                let _e2399 = phi_4631_;
                                                if _e2399 {
                                                    let _e2404 = (_e2198 / (_e2198 - _e2203));
                                                    let _e2411 = vec3<f32>((_e2178 + ((_e2182 - _e2178) * _e2404)), (_e2179 + ((_e2183 - _e2179) * _e2404)), (_e2180 + ((_e2184 - _e2180) * _e2404)));
                                                    if _e2392 {
                                                        phi_4652_ = type_61(_e2391.member, _e2391.member_1, _e2411);
                                                    } else {
                                                        phi_4652_ = type_61(_e2391.member, _e2411, _e2391.member_2);
                                                    }
                                                    let _e2421 = phi_4652_;
                                                    let _e2422 = vec3(_e2392);
                                                    phi_4656_ = _e2421;
                                                    phi_4657_ = select(_e2411, _e2185, _e2422);
                                                    phi_4658_ = select(_e2181, _e2411, _e2422);
                                                } else {
                                                    phi_4656_ = _e2391;
                                                    phi_4657_ = _e2185;
                                                    phi_4658_ = _e2181;
                                                }
                                                let _e2426 = phi_4656_;
                                                let _e2428 = phi_4657_;
                                                let _e2430 = phi_4658_;
                                                let _e2432 = abs(_e2430.x);
                                                let _e2434 = abs(_e2430.y);
                                                let _e2436 = select(_e2434, _e2432, (_e2432 > _e2434));
                                                let _e2438 = abs(_e2430.z);
                                                let _e2440 = select(_e2438, _e2436, (_e2436 > _e2438));
                                                if (_e2440 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2442 = (_e2440 < 340282350000000000000000000000000000000f);
                                                    if _e2442 {
                                                        let _e2443 = (_e2430.x / _e2440);
                                                        let _e2444 = (_e2430.y / _e2440);
                                                        let _e2445 = (_e2430.z / _e2440);
                                                        let _e2451 = sqrt((((_e2443 * _e2443) + (_e2444 * _e2444)) + (_e2445 * _e2445)));
                                                        phi_4698_ = vec3<f32>((_e2443 / _e2451), (_e2444 / _e2451), (_e2445 / _e2451));
                                                    } else {
                                                        phi_4698_ = vec3<f32>();
                                                    }
                                                    let _e2457 = phi_4698_;
                                                    phi_4701_ = _e2457;
                                                    phi_4702_ = select(true, false, _e2442);
                                                } else {
                                                    phi_4701_ = vec3<f32>();
                                                    phi_4702_ = true;
                                                }
                                                let _e2460 = phi_4701_;
                                                let _e2462 = phi_4702_;
                                                let _e2464 = select(_e2460, vec3<f32>(0f, 0f, 0f), vec3(_e2462));
                                                let _e2466 = abs(_e2428.x);
                                                let _e2468 = abs(_e2428.y);
                                                let _e2470 = select(_e2468, _e2466, (_e2466 > _e2468));
                                                let _e2472 = abs(_e2428.z);
                                                let _e2474 = select(_e2472, _e2470, (_e2470 > _e2472));
                                                if (_e2474 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2476 = (_e2474 < 340282350000000000000000000000000000000f);
                                                    if _e2476 {
                                                        let _e2477 = (_e2428.x / _e2474);
                                                        let _e2478 = (_e2428.y / _e2474);
                                                        let _e2479 = (_e2428.z / _e2474);
                                                        let _e2485 = sqrt((((_e2477 * _e2477) + (_e2478 * _e2478)) + (_e2479 * _e2479)));
                                                        phi_4746_ = vec3<f32>((_e2477 / _e2485), (_e2478 / _e2485), (_e2479 / _e2485));
                                                    } else {
                                                        phi_4746_ = vec3<f32>();
                                                    }
                                                    let _e2491 = phi_4746_;
                                                    phi_4749_ = _e2491;
                                                    phi_4750_ = select(true, false, _e2476);
                                                } else {
                                                    phi_4749_ = vec3<f32>();
                                                    phi_4750_ = true;
                                                }
                                                let _e2494 = phi_4749_;
                                                let _e2496 = phi_4750_;
                                                let _e2498 = select(_e2494, vec3<f32>(0f, 0f, 0f), vec3(_e2496));
                                                let _e2505 = ((_e2464.y * _e2498.z) - (_e2498.y * _e2464.z));
                                                let _e2510 = ((_e2464.z * _e2498.x) - (_e2498.z * _e2464.x));
                                                let _e2513 = ((_e2464.x * _e2498.y) - (_e2498.x * _e2464.y));
                                                let _e2519 = sqrt((((_e2505 * _e2505) + (_e2510 * _e2510)) + (_e2513 * _e2513)));
                                                if (_e2519 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4864_ = 0f;
                                                } else {
                                                    let _e2531 = (((_e2464.x * _e2498.x) + (_e2464.y * _e2498.y)) + (_e2464.z * _e2498.z));
                                                    let _e2532 = abs(_e2531);
                                                    let _e2533 = abs(_e2519);
                                                    let _e2534 = (_e2533 > _e2532);
                                                    let _e2535 = select(_e2532, _e2533, _e2534);
                                                    if (_e2535 > 0f) {
                                                        phi_4817_ = (select(_e2533, _e2532, _e2534) / _e2535);
                                                    } else {
                                                        phi_4817_ = 0f;
                                                    }
                                                    let _e2540 = phi_4817_;
                                                    let _e2541 = (_e2540 > 0.41421357f);
                                                    if _e2541 {
                                                        phi_4825_ = ((_e2540 - 1f) / (_e2540 + 1f));
                                                    } else {
                                                        phi_4825_ = _e2540;
                                                    }
                                                    let _e2546 = phi_4825_;
                                                    let _e2547 = (_e2546 * _e2546);
                                                    let _e2556 = (_e2546 + ((_e2546 * _e2547) * (-0.3333295f + (_e2547 * (0.19977711f + (_e2547 * (-0.13877685f + (_e2547 * 0.080537446f))))))));
                                                    if _e2541 {
                                                        phi_4840_ = (_e2556 + 0.7853982f);
                                                    } else {
                                                        phi_4840_ = _e2556;
                                                    }
                                                    let _e2559 = phi_4840_;
                                                    if _e2534 {
                                                        phi_4846_ = (1.5707964f - _e2559);
                                                    } else {
                                                        phi_4846_ = _e2559;
                                                    }
                                                    let _e2562 = phi_4846_;
                                                    if ((bitcast<u32>(_e2531) & 2147483648u) == 0u) {
                                                        phi_4854_ = _e2562;
                                                    } else {
                                                        phi_4854_ = (3.1415927f - _e2562);
                                                    }
                                                    let _e2568 = phi_4854_;
                                                    phi_4864_ = (((((_e169.x * _e2505) + (_e169.y * _e2510)) + (_e169.z * _e2513)) / _e2519) * bitcast<f32>(((bitcast<u32>(_e2568) & 2147483647u) | (bitcast<u32>(_e2519) & 2147483648u))));
                                                }
                                                let _e2577 = phi_4864_;
                                                phi_4869_ = type_61((_e2426.member + _e2577), _e2426.member_1, _e2426.member_2);
                                            } else {
                                                phi_4869_ = _e2391;
                                            }
                                            let _e2585 = phi_4869_;
                                            let _e2586 = (_e2203 <= 0f);
                                            if _e2586 {
                                                phi_4879_ = select(true, false, _e2204);
                                            } else {
                                                phi_4879_ = true;
                                            }
                                            let _e2589 = phi_4879_;
                                            if _e2589 {
                                                if select(_e2204, true, _e2586) {
                                                    let _e2595 = (_e2203 / (_e2203 - _e2193));
                                                    let _e2602 = vec3<f32>((_e2182 + ((_e2174 - _e2182) * _e2595)), (_e2183 + ((_e2175 - _e2183) * _e2595)), (_e2184 + ((_e2176 - _e2184) * _e2595)));
                                                    if _e2586 {
                                                        phi_4911_ = type_61(_e2585.member, _e2585.member_1, _e2602);
                                                    } else {
                                                        phi_4911_ = type_61(_e2585.member, _e2602, _e2585.member_2);
                                                    }
                                                    let _e2612 = phi_4911_;
                                                    let _e2613 = vec3(_e2586);
                                                    phi_4915_ = _e2612;
                                                    phi_4916_ = select(_e2602, _e2177, _e2613);
                                                    phi_4917_ = select(_e2185, _e2602, _e2613);
                                                } else {
                                                    phi_4915_ = _e2585;
                                                    phi_4916_ = _e2177;
                                                    phi_4917_ = _e2185;
                                                }
                                                let _e2617 = phi_4915_;
                                                let _e2619 = phi_4916_;
                                                let _e2621 = phi_4917_;
                                                let _e2623 = abs(_e2621.x);
                                                let _e2625 = abs(_e2621.y);
                                                let _e2627 = select(_e2625, _e2623, (_e2623 > _e2625));
                                                let _e2629 = abs(_e2621.z);
                                                let _e2631 = select(_e2629, _e2627, (_e2627 > _e2629));
                                                if (_e2631 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2633 = (_e2631 < 340282350000000000000000000000000000000f);
                                                    if _e2633 {
                                                        let _e2634 = (_e2621.x / _e2631);
                                                        let _e2635 = (_e2621.y / _e2631);
                                                        let _e2636 = (_e2621.z / _e2631);
                                                        let _e2642 = sqrt((((_e2634 * _e2634) + (_e2635 * _e2635)) + (_e2636 * _e2636)));
                                                        phi_4957_ = vec3<f32>((_e2634 / _e2642), (_e2635 / _e2642), (_e2636 / _e2642));
                                                    } else {
                                                        phi_4957_ = vec3<f32>();
                                                    }
                                                    let _e2648 = phi_4957_;
                                                    phi_4960_ = _e2648;
                                                    phi_4961_ = select(true, false, _e2633);
                                                } else {
                                                    phi_4960_ = vec3<f32>();
                                                    phi_4961_ = true;
                                                }
                                                let _e2651 = phi_4960_;
                                                let _e2653 = phi_4961_;
                                                let _e2655 = select(_e2651, vec3<f32>(0f, 0f, 0f), vec3(_e2653));
                                                let _e2657 = abs(_e2619.x);
                                                let _e2659 = abs(_e2619.y);
                                                let _e2661 = select(_e2659, _e2657, (_e2657 > _e2659));
                                                let _e2663 = abs(_e2619.z);
                                                let _e2665 = select(_e2663, _e2661, (_e2661 > _e2663));
                                                if (_e2665 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2667 = (_e2665 < 340282350000000000000000000000000000000f);
                                                    if _e2667 {
                                                        let _e2668 = (_e2619.x / _e2665);
                                                        let _e2669 = (_e2619.y / _e2665);
                                                        let _e2670 = (_e2619.z / _e2665);
                                                        let _e2676 = sqrt((((_e2668 * _e2668) + (_e2669 * _e2669)) + (_e2670 * _e2670)));
                                                        phi_5005_ = vec3<f32>((_e2668 / _e2676), (_e2669 / _e2676), (_e2670 / _e2676));
                                                    } else {
                                                        phi_5005_ = vec3<f32>();
                                                    }
                                                    let _e2682 = phi_5005_;
                                                    phi_5008_ = _e2682;
                                                    phi_5009_ = select(true, false, _e2667);
                                                } else {
                                                    phi_5008_ = vec3<f32>();
                                                    phi_5009_ = true;
                                                }
                                                let _e2685 = phi_5008_;
                                                let _e2687 = phi_5009_;
                                                let _e2689 = select(_e2685, vec3<f32>(0f, 0f, 0f), vec3(_e2687));
                                                let _e2696 = ((_e2655.y * _e2689.z) - (_e2689.y * _e2655.z));
                                                let _e2701 = ((_e2655.z * _e2689.x) - (_e2689.z * _e2655.x));
                                                let _e2704 = ((_e2655.x * _e2689.y) - (_e2689.x * _e2655.y));
                                                let _e2710 = sqrt((((_e2696 * _e2696) + (_e2701 * _e2701)) + (_e2704 * _e2704)));
                                                if (_e2710 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5123_ = 0f;
                                                } else {
                                                    let _e2722 = (((_e2655.x * _e2689.x) + (_e2655.y * _e2689.y)) + (_e2655.z * _e2689.z));
                                                    let _e2723 = abs(_e2722);
                                                    let _e2724 = abs(_e2710);
                                                    let _e2725 = (_e2724 > _e2723);
                                                    let _e2726 = select(_e2723, _e2724, _e2725);
                                                    if (_e2726 > 0f) {
                                                        phi_5076_ = (select(_e2724, _e2723, _e2725) / _e2726);
                                                    } else {
                                                        phi_5076_ = 0f;
                                                    }
                                                    let _e2731 = phi_5076_;
                                                    let _e2732 = (_e2731 > 0.41421357f);
                                                    if _e2732 {
                                                        phi_5084_ = ((_e2731 - 1f) / (_e2731 + 1f));
                                                    } else {
                                                        phi_5084_ = _e2731;
                                                    }
                                                    let _e2737 = phi_5084_;
                                                    let _e2738 = (_e2737 * _e2737);
                                                    let _e2747 = (_e2737 + ((_e2737 * _e2738) * (-0.3333295f + (_e2738 * (0.19977711f + (_e2738 * (-0.13877685f + (_e2738 * 0.080537446f))))))));
                                                    if _e2732 {
                                                        phi_5099_ = (_e2747 + 0.7853982f);
                                                    } else {
                                                        phi_5099_ = _e2747;
                                                    }
                                                    let _e2750 = phi_5099_;
                                                    if _e2725 {
                                                        phi_5105_ = (1.5707964f - _e2750);
                                                    } else {
                                                        phi_5105_ = _e2750;
                                                    }
                                                    let _e2753 = phi_5105_;
                                                    if ((bitcast<u32>(_e2722) & 2147483648u) == 0u) {
                                                        phi_5113_ = _e2753;
                                                    } else {
                                                        phi_5113_ = (3.1415927f - _e2753);
                                                    }
                                                    let _e2759 = phi_5113_;
                                                    phi_5123_ = (((((_e169.x * _e2696) + (_e169.y * _e2701)) + (_e169.z * _e2704)) / _e2710) * bitcast<f32>(((bitcast<u32>(_e2759) & 2147483647u) | (bitcast<u32>(_e2710) & 2147483648u))));
                                                }
                                                let _e2768 = phi_5123_;
                                                phi_5128_ = type_61((_e2617.member + _e2768), _e2617.member_1, _e2617.member_2);
                                            } else {
                                                phi_5128_ = _e2585;
                                            }
                                            let _e2776 = phi_5128_;
                                            let _e2780 = abs(_e2776.member_1.x);
                                            let _e2782 = abs(_e2776.member_1.y);
                                            let _e2784 = select(_e2782, _e2780, (_e2780 > _e2782));
                                            let _e2786 = abs(_e2776.member_1.z);
                                            let _e2788 = select(_e2786, _e2784, (_e2784 > _e2786));
                                            if (_e2788 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e2790 = (_e2788 < 340282350000000000000000000000000000000f);
                                                if _e2790 {
                                                    let _e2791 = (_e2776.member_1.x / _e2788);
                                                    let _e2792 = (_e2776.member_1.y / _e2788);
                                                    let _e2793 = (_e2776.member_1.z / _e2788);
                                                    let _e2799 = sqrt((((_e2791 * _e2791) + (_e2792 * _e2792)) + (_e2793 * _e2793)));
                                                    phi_5170_ = vec3<f32>((_e2791 / _e2799), (_e2792 / _e2799), (_e2793 / _e2799));
                                                } else {
                                                    phi_5170_ = vec3<f32>();
                                                }
                                                let _e2805 = phi_5170_;
                                                phi_5173_ = _e2805;
                                                phi_5174_ = select(true, false, _e2790);
                                            } else {
                                                phi_5173_ = vec3<f32>();
                                                phi_5174_ = true;
                                            }
                                            let _e2808 = phi_5173_;
                                            let _e2810 = phi_5174_;
                                            let _e2812 = select(_e2808, vec3<f32>(0f, 0f, 0f), vec3(_e2810));
                                            let _e2814 = abs(_e2776.member_2.x);
                                            let _e2816 = abs(_e2776.member_2.y);
                                            let _e2818 = select(_e2816, _e2814, (_e2814 > _e2816));
                                            let _e2820 = abs(_e2776.member_2.z);
                                            let _e2822 = select(_e2820, _e2818, (_e2818 > _e2820));
                                            if (_e2822 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e2824 = (_e2822 < 340282350000000000000000000000000000000f);
                                                if _e2824 {
                                                    let _e2825 = (_e2776.member_2.x / _e2822);
                                                    let _e2826 = (_e2776.member_2.y / _e2822);
                                                    let _e2827 = (_e2776.member_2.z / _e2822);
                                                    let _e2833 = sqrt((((_e2825 * _e2825) + (_e2826 * _e2826)) + (_e2827 * _e2827)));
                                                    phi_5218_ = vec3<f32>((_e2825 / _e2833), (_e2826 / _e2833), (_e2827 / _e2833));
                                                } else {
                                                    phi_5218_ = vec3<f32>();
                                                }
                                                let _e2839 = phi_5218_;
                                                phi_5221_ = _e2839;
                                                phi_5222_ = select(true, false, _e2824);
                                            } else {
                                                phi_5221_ = vec3<f32>();
                                                phi_5222_ = true;
                                            }
                                            let _e2842 = phi_5221_;
                                            let _e2844 = phi_5222_;
                                            let _e2846 = select(_e2842, vec3<f32>(0f, 0f, 0f), vec3(_e2844));
                                            let _e2853 = ((_e2812.y * _e2846.z) - (_e2846.y * _e2812.z));
                                            let _e2858 = ((_e2812.z * _e2846.x) - (_e2846.z * _e2812.x));
                                            let _e2861 = ((_e2812.x * _e2846.y) - (_e2846.x * _e2812.y));
                                            let _e2867 = sqrt((((_e2853 * _e2853) + (_e2858 * _e2858)) + (_e2861 * _e2861)));
                                            if (_e2867 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5336_ = 0f;
                                            } else {
                                                let _e2879 = (((_e2812.x * _e2846.x) + (_e2812.y * _e2846.y)) + (_e2812.z * _e2846.z));
                                                let _e2880 = abs(_e2879);
                                                let _e2881 = abs(_e2867);
                                                let _e2882 = (_e2881 > _e2880);
                                                let _e2883 = select(_e2880, _e2881, _e2882);
                                                if (_e2883 > 0f) {
                                                    phi_5289_ = (select(_e2881, _e2880, _e2882) / _e2883);
                                                } else {
                                                    phi_5289_ = 0f;
                                                }
                                                let _e2888 = phi_5289_;
                                                let _e2889 = (_e2888 > 0.41421357f);
                                                if _e2889 {
                                                    phi_5297_ = ((_e2888 - 1f) / (_e2888 + 1f));
                                                } else {
                                                    phi_5297_ = _e2888;
                                                }
                                                let _e2894 = phi_5297_;
                                                let _e2895 = (_e2894 * _e2894);
                                                let _e2904 = (_e2894 + ((_e2894 * _e2895) * (-0.3333295f + (_e2895 * (0.19977711f + (_e2895 * (-0.13877685f + (_e2895 * 0.080537446f))))))));
                                                if _e2889 {
                                                    phi_5312_ = (_e2904 + 0.7853982f);
                                                } else {
                                                    phi_5312_ = _e2904;
                                                }
                                                let _e2907 = phi_5312_;
                                                if _e2882 {
                                                    phi_5318_ = (1.5707964f - _e2907);
                                                } else {
                                                    phi_5318_ = _e2907;
                                                }
                                                let _e2910 = phi_5318_;
                                                if ((bitcast<u32>(_e2879) & 2147483648u) == 0u) {
                                                    phi_5326_ = _e2910;
                                                } else {
                                                    phi_5326_ = (3.1415927f - _e2910);
                                                }
                                                let _e2916 = phi_5326_;
                                                phi_5336_ = (((((_e169.x * _e2853) + (_e169.y * _e2858)) + (_e169.z * _e2861)) / _e2867) * bitcast<f32>(((bitcast<u32>(_e2916) & 2147483647u) | (bitcast<u32>(_e2867) & 2147483648u))));
                                            }
                                            let _e2925 = phi_5336_;
                                            let _e2931 = local_8;
                                            let _e2933 = local_9;
                                            phi_3946_ = ((abs((_e2776.member + _e2925)) * 0.5f) * (_e2931 / _e2933));
                                        }
                                        let _e2937 = phi_3946_;
                                        phi_3947_ = _e2937;
                                        phi_3948_ = _e2158;
                                    }
                                    let _e2939 = phi_3947_;
                                    let _e2941 = phi_3948_;
                                    if _e2941 {
                                        let _e2944 = local_10;
                                        phi_3956_ = ((_e2944 * _e413.member_3) / f32(_e425));
                                    } else {
                                        phi_3956_ = _e2939;
                                    }
                                    let _e2949 = phi_3956_;
                                    phi_3957_ = _e2949;
                                } else {
                                    phi_3957_ = _e2152;
                                }
                                let _e2951 = phi_3957_;
                                phi_3966_ = vec3<f32>((_e413.member_6[0] * _e2951), (_e413.member_6[1] * _e2951), (_e413.member_6[2] * _e2951));
                            }
                            let _e2961 = phi_3966_;
                            phi_5562_ = _e2141;
                            phi_3982_ = vec3<f32>((_e272.x + (_e2961.x * _e418)), (_e272.y + (_e2961.y * _e418)), (_e272.z + (_e2961.z * _e418)));
                        } else {
                            phi_5562_ = _e371;
                            phi_3982_ = _e272;
                        }
                        let _e2976 = phi_5562_;
                        let _e2978 = phi_3982_;
                        phi_5561_ = _e2976;
                        phi_1482_ = _e2978;
                    } else {
                        phi_5561_ = _e268;
                        phi_1482_ = vec3<f32>();
                    }
                    let _e2980 = phi_5561_;
                    let _e2982 = phi_1482_;
                    continue;
                    continuing {
                        phi_5345_ = _e2980;
                        phi_1478_ = _e285;
                        phi_1481_ = _e2982;
                        phi_5560_ = _e2980;
                        break if !(_e291);
                    }
                }
                let _e2985 = phi_5560_;
                if _e2985 {
                    break;
                }
                let _e2987 = local_11;
                let _e2990 = local_12;
                let _e2993 = local_13;
                if _e142 {
                } else {
                    break;
                }
                out.member[_e141] = vec4<f32>(_e2987.x, _e2990.y, _e2993.z, 0f);
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
