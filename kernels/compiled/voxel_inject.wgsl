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
    var phi_1353_: vec3<f32>;
    var phi_1360_: vec3<f32>;
    var phi_5176_: bool;
    var phi_1456_: type_13;
    var phi_1459_: vec3<f32>;
    var phi_1457_: type_13;
    var phi_1482_: type_13;
    var phi_1521_: u32;
    var phi_1524_: u32;
    var phi_1548_: u32;
    var phi_1522_: u32;
    var phi_1525_: u32;
    var phi_5172_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1565_: f32;
    var phi_5215_: bool;
    var phi_1575_: type_33;
    var phi_1576_: u32;
    var phi_1577_: f32;
    var phi_5214_: bool;
    var phi_1579_: type_33;
    var phi_1580_: u32;
    var phi_1581_: f32;
    var phi_1582_: bool;
    var phi_1614_: type_33;
    var phi_1615_: u32;
    var phi_1617_: type_33;
    var phi_1618_: u32;
    var phi_1619_: u32;
    var phi_1635_: bool;
    var phi_5210_: bool;
    var phi_1642_: type_13;
    var phi_1645_: f32;
    var phi_1647_: f32;
    var phi_1649_: f32;
    var phi_1643_: type_13;
    var phi_1672_: type_13;
    var phi_2266_: f32;
    var phi_3858_: f32;
    var phi_3866_: f32;
    var phi_2024_: vec2<f32>;
    var phi_2025_: bool;
    var phi_2155_: f32;
    var phi_2163_: f32;
    var phi_2089_: f32;
    var phi_2097_: f32;
    var phi_2167_: vec2<f32>;
    var phi_2168_: vec2<f32>;
    var phi_2267_: vec3<f32>;
    var phi_2268_: f32;
    var phi_2269_: f32;
    var phi_2270_: vec3<f32>;
    var phi_2271_: f32;
    var phi_2272_: bool;
    var phi_2292_: f32;
    var phi_2304_: type_49;
    var phi_1751_: vec3<f32>;
    var phi_1753_: vec3<f32>;
    var phi_1754_: bool;
    var phi_3874_: f32;
    var phi_3882_: f32;
    var phi_1828_: vec2<f32>;
    var phi_2306_: f32;
    var phi_2307_: vec3<f32>;
    var phi_2308_: f32;
    var phi_2309_: vec3<f32>;
    var phi_2310_: type_49;
    var phi_2311_: f32;
    var phi_2312_: bool;
    var phi_2332_: f32;
    var phi_2346_: type_49;
    var phi_2379_: bool;
    var phi_2389_: u32;
    var phi_2392_: bool;
    var phi_2403_: u32;
    var phi_2556_: f32;
    var phi_2564_: f32;
    var phi_2572_: f32;
    var phi_5188_: bool;
    var phi_2576_: u32;
    var phi_2579_: u32;
    var phi_3006_: type_13;
    var phi_3007_: type_13;
    var phi_3030_: type_13;
    var phi_3146_: f32;
    var phi_3157_: f32;
    var phi_3168_: f32;
    var phi_3183_: f32;
    var phi_3184_: f32;
    var phi_3185_: bool;
    var phi_3186_: f32;
    var phi_3187_: bool;
    var phi_3206_: f32;
    var phi_3207_: bool;
    var phi_3208_: f32;
    var phi_3209_: bool;
    var phi_3210_: bool;
    var phi_3215_: f32;
    var phi_3216_: bool;
    var phi_3302_: array<f32, 3>;
    var phi_3303_: array<f32, 3>;
    var phi_3304_: array<f32, 3>;
    var phi_3305_: array<f32, 3>;
    var phi_3306_: bool;
    var phi_3307_: array<f32, 3>;
    var phi_3308_: array<f32, 3>;
    var phi_3309_: bool;
    var phi_3310_: bool;
    var phi_3315_: array<f32, 3>;
    var phi_3320_: array<f32, 3>;
    var phi_3531_: u32;
    var phi_3537_: u32;
    var phi_3567_: u32;
    var phi_3573_: u32;
    var phi_3648_: bool;
    var phi_3653_: bool;
    var phi_3658_: type_53;
    var phi_3660_: type_53;
    var phi_3662_: bool;
    var phi_3663_: type_53;
    var phi_3665_: bool;
    var phi_3666_: bool;
    var phi_3667_: type_53;
    var phi_3668_: bool;
    var phi_3669_: bool;
    var phi_3670_: bool;
    var phi_3683_: type_53;
    var phi_3690_: bool;
    var phi_5184_: bool;
    var phi_3849_: bool;
    var phi_2966_: u32;
    var phi_2978_: u32;
    var phi_2990_: u32;
    var phi_3002_: u32;
    var phi_5295_: bool;
    var phi_3695_: u32;
    var phi_3696_: bool;
    var phi_3712_: u32;
    var phi_3713_: u32;
    var phi_2577_: u32;
    var phi_2580_: u32;
    var phi_3715_: bool;
    var phi_3716_: bool;
    var phi_5293_: bool;
    var phi_3850_: bool;
    var phi_3729_: f32;
    var phi_5355_: bool;
    var phi_3730_: f32;
    var phi_5354_: bool;
    var phi_1646_: f32;
    var phi_1648_: f32;
    var phi_1650_: f32;
    var phi_5353_: bool;
    var local_5: f32;
    var local_6: f32;
    var phi_3743_: f32;
    var local_7: f32;
    var phi_4192_: bool;
    var phi_4203_: bool;
    var phi_4224_: type_61;
    var phi_4228_: type_61;
    var phi_4229_: vec3<f32>;
    var phi_4230_: vec3<f32>;
    var phi_4270_: vec3<f32>;
    var phi_4273_: vec3<f32>;
    var phi_4274_: bool;
    var phi_4318_: vec3<f32>;
    var phi_4321_: vec3<f32>;
    var phi_4322_: bool;
    var phi_4389_: f32;
    var phi_4397_: f32;
    var phi_4412_: f32;
    var phi_4418_: f32;
    var phi_4426_: f32;
    var phi_4436_: f32;
    var phi_4441_: type_61;
    var phi_4451_: bool;
    var phi_4462_: bool;
    var phi_4483_: type_61;
    var phi_4487_: type_61;
    var phi_4488_: vec3<f32>;
    var phi_4489_: vec3<f32>;
    var phi_4529_: vec3<f32>;
    var phi_4532_: vec3<f32>;
    var phi_4533_: bool;
    var phi_4577_: vec3<f32>;
    var phi_4580_: vec3<f32>;
    var phi_4581_: bool;
    var phi_4648_: f32;
    var phi_4656_: f32;
    var phi_4671_: f32;
    var phi_4677_: f32;
    var phi_4685_: f32;
    var phi_4695_: f32;
    var phi_4700_: type_61;
    var phi_4710_: bool;
    var phi_4742_: type_61;
    var phi_4746_: type_61;
    var phi_4747_: vec3<f32>;
    var phi_4748_: vec3<f32>;
    var phi_4788_: vec3<f32>;
    var phi_4791_: vec3<f32>;
    var phi_4792_: bool;
    var phi_4836_: vec3<f32>;
    var phi_4839_: vec3<f32>;
    var phi_4840_: bool;
    var phi_4907_: f32;
    var phi_4915_: f32;
    var phi_4930_: f32;
    var phi_4936_: f32;
    var phi_4944_: f32;
    var phi_4954_: f32;
    var phi_4959_: type_61;
    var phi_5001_: vec3<f32>;
    var phi_5004_: vec3<f32>;
    var phi_5005_: bool;
    var phi_5049_: vec3<f32>;
    var phi_5052_: vec3<f32>;
    var phi_5053_: bool;
    var phi_5120_: f32;
    var phi_5128_: f32;
    var phi_5143_: f32;
    var phi_5149_: f32;
    var phi_5157_: f32;
    var phi_5167_: f32;
    var local_8: f32;
    var local_9: f32;
    var phi_3777_: f32;
    var phi_3778_: f32;
    var phi_3779_: bool;
    var local_10: f32;
    var phi_3787_: f32;
    var phi_3788_: f32;
    var phi_3797_: vec3<f32>;
    var phi_5361_: bool;
    var phi_3813_: vec3<f32>;
    var phi_5360_: bool;
    var phi_1460_: vec3<f32>;
    var phi_5359_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e116 = gid_1;
            let _e119 = arrayLength((&nodes.member));
            let _e128 = arrayLength((&surfaces.member));
            let _e130 = arrayLength((&lights.member));
            let _e138 = (_e116.x + (_e116.y * 2097152u));
            let _e139 = (_e138 < arrayLength((&out.member)));
            if _e139 {
                let _e140 = (_e138 / 2u);
                if (_e140 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e144 = facets.member[_e140];
                let _e154 = sqrt((((_e144.member_2[0] * _e144.member_2[0]) + (_e144.member_2[1] * _e144.member_2[1])) + (_e144.member_2[2] * _e144.member_2[2])));
                if (_e154 > 0.000000000001f) {
                    phi_1353_ = vec3<f32>((_e144.member_2[0] / _e154), (_e144.member_2[1] / _e154), (_e144.member_2[2] / _e154));
                } else {
                    phi_1353_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e161 = phi_1353_;
                if ((_e138 & 1u) == 0u) {
                    phi_1360_ = _e161;
                } else {
                    phi_1360_ = -(_e161);
                }
                let _e166 = phi_1360_;
                let _e171 = vec3<f32>(_e144.member[0], _e144.member[1], _e144.member[2]);
                let _e176 = (1f - (_e154 / select(0.000000000001f, _e144.member_1, (_e144.member_1 > 0.000000000001f))));
                let _e178 = select(0f, _e176, (_e176 > 0f));
                let _e187 = params.member.member[3u];
                let _e188 = ((0.001f + (0.61f * sqrt(select(0.5f, _e178, (_e178 < 0.5f))))) * _e187);
                let _e192 = params.member.member_17[0u];
                let _e196 = params.member.member_17[1u];
                let _e199 = params.member.member_15;
                let _e206 = params.member.member_17[2u];
                let _e210 = params.member.member_17[3u];
                let _e214 = ((_e138 ^ (_e138 >> bitcast<u32>(16i))) * 2146121005u);
                let _e218 = ((_e214 ^ (_e214 >> bitcast<u32>(15i))) * 2221713035u);
                let _e222 = (_e210 ^ (_e218 ^ (_e218 >> bitcast<u32>(16i))));
                let _e226 = ((_e222 ^ (_e222 >> bitcast<u32>(16i))) * 2146121005u);
                let _e230 = ((_e226 ^ (_e226 >> bitcast<u32>(15i))) * 2221713035u);
                let _e233 = (_e230 ^ (_e230 >> bitcast<u32>(16i)));
                let _e234 = (_e192 > 64u);
                let _e235 = select(_e192, _e196, _e234);
                let _e242 = ((_e233 ^ (_e233 >> bitcast<u32>(16i))) * 2146121005u);
                let _e246 = ((_e242 ^ (_e242 >> bitcast<u32>(15i))) * 2221713035u);
                let _e249 = (_e246 ^ (_e246 >> bitcast<u32>(16i)));
                phi_5176_ = false;
                phi_1456_ = type_13(0u, (_e235 + select(0u, 1u, (_e206 > 0u))));
                phi_1459_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e256 = phi_5176_;
                    let _e258 = phi_1456_;
                    let _e260 = phi_1459_;
                    local_11 = _e260;
                    local_12 = _e260;
                    local_13 = _e260;
                    if (_e258.member < _e258.member_1) {
                        phi_1457_ = type_13((_e258.member + 1u), _e258.member_1);
                        phi_1482_ = type_13(1u, _e258.member);
                    } else {
                        phi_1457_ = _e258;
                        phi_1482_ = type_13(0u, type_13().member_1);
                    }
                    let _e273 = phi_1457_;
                    let _e275 = phi_1482_;
                    let _e279 = (bitcast<i32>(_e275.member) != 0i);
                    if _e279 {
                        let _e285 = ((_e249 ^ (_e249 >> bitcast<u32>(16i))) * 2146121005u);
                        let _e289 = ((_e285 ^ (_e285 >> bitcast<u32>(15i))) * 2221713035u);
                        let _e293 = (_e275.member_1 < _e235);
                        if _e293 {
                            if _e234 {
                                let _e296 = f32(_e235);
                                phi_1521_ = (_e192 - 1u);
                                phi_1524_ = 0u;
                                loop {
                                    let _e300 = phi_1521_;
                                    let _e302 = phi_1524_;
                                    local_3 = _e302;
                                    local_4 = _e302;
                                    let _e303 = (_e302 < _e300);
                                    if _e303 {
                                        let _e305 = ((_e302 + _e300) / 2u);
                                        if (_e305 < _e130) {
                                        } else {
                                            phi_5172_ = true;
                                            break;
                                        }
                                        let _e310 = lights.member[_e305].member_5;
                                        let _e311 = (_e310 > ((f32(_e275.member_1) + (f32((_e249 >> bitcast<u32>(8i))) * 0.000000059604645f)) / _e296));
                                        if _e311 {
                                            phi_1548_ = _e302;
                                        } else {
                                            phi_1548_ = (_e305 + 1u);
                                        }
                                        let _e314 = phi_1548_;
                                        phi_1522_ = select(_e300, _e305, _e311);
                                        phi_1525_ = _e314;
                                    } else {
                                        phi_1522_ = u32();
                                        phi_1525_ = u32();
                                    }
                                    let _e317 = phi_1522_;
                                    let _e319 = phi_1525_;
                                    continue;
                                    continuing {
                                        phi_1521_ = _e317;
                                        phi_1524_ = _e319;
                                        phi_5172_ = _e256;
                                        break if !(_e303);
                                    }
                                }
                                let _e322 = phi_5172_;
                                phi_5359_ = _e322;
                                if _e322 {
                                    break;
                                }
                                let _e324 = local_3;
                                if (_e324 < _e130) {
                                } else {
                                    phi_5359_ = true;
                                    break;
                                }
                                let _e328 = local_4;
                                let _e330 = lights.member[_e328];
                                if (_e330.member_7 > 0f) {
                                    phi_1565_ = (1f / (_e330.member_7 * _e296));
                                } else {
                                    phi_1565_ = 0f;
                                }
                                let _e336 = phi_1565_;
                                let _e337 = (_e233 + _e275.member_1);
                                let _e341 = ((_e337 ^ (_e337 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e345 = ((_e341 ^ (_e341 >> bitcast<u32>(15i))) * 2221713035u);
                                phi_5215_ = _e322;
                                phi_1575_ = _e330;
                                phi_1576_ = (_e345 ^ (_e345 >> bitcast<u32>(16i)));
                                phi_1577_ = _e336;
                            } else {
                                phi_5215_ = _e256;
                                phi_1575_ = type_33();
                                phi_1576_ = u32();
                                phi_1577_ = f32();
                            }
                            let _e350 = phi_5215_;
                            let _e352 = phi_1575_;
                            let _e354 = phi_1576_;
                            let _e356 = phi_1577_;
                            phi_5214_ = _e350;
                            phi_1579_ = _e352;
                            phi_1580_ = _e354;
                            phi_1581_ = _e356;
                            phi_1582_ = select(true, false, _e234);
                        } else {
                            phi_5214_ = _e256;
                            phi_1579_ = type_33();
                            phi_1580_ = u32();
                            phi_1581_ = f32();
                            phi_1582_ = true;
                        }
                        let _e359 = phi_5214_;
                        let _e361 = phi_1579_;
                        let _e363 = phi_1580_;
                        let _e365 = phi_1581_;
                        let _e367 = phi_1582_;
                        if _e367 {
                            if _e293 {
                                if (_e275.member_1 < _e130) {
                                } else {
                                    phi_5359_ = true;
                                    break;
                                }
                                let _e371 = lights.member[_e275.member_1];
                                let _e375 = ((_e275.member_1 ^ (_e275.member_1 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e379 = ((_e375 ^ (_e375 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e383 = (_e233 ^ (_e379 ^ (_e379 >> bitcast<u32>(16i))));
                                let _e387 = ((_e383 ^ (_e383 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e391 = ((_e387 ^ (_e387 >> bitcast<u32>(15i))) * 2221713035u);
                                phi_1614_ = _e371;
                                phi_1615_ = (_e391 ^ (_e391 >> bitcast<u32>(16i)));
                            } else {
                                phi_1614_ = type_33(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(_e199.x, _e199.y, _e199.z), 1f);
                                phi_1615_ = (_e289 ^ (_e289 >> bitcast<u32>(16i)));
                            }
                            let _e396 = phi_1614_;
                            let _e398 = phi_1615_;
                            phi_1617_ = _e396;
                            phi_1618_ = _e398;
                            phi_1619_ = select(_e206, _e196, _e293);
                        } else {
                            phi_1617_ = _e361;
                            phi_1618_ = _e363;
                            phi_1619_ = 1u;
                        }
                        let _e401 = phi_1617_;
                        let _e403 = phi_1618_;
                        let _e405 = phi_1619_;
                        let _e406 = select(_e365, 1f, _e367);
                        if (_e406 > 0f) {
                            let _e409 = (_e401.member_1 == 3u);
                            if _e409 {
                                phi_1635_ = true;
                            } else {
                                phi_1635_ = (_e401.member_1 == 4294967295u);
                            }
                            let _e412 = phi_1635_;
                            let _e413 = select(1u, _e405, _e412);
                            phi_5210_ = _e359;
                            phi_1642_ = type_13(0u, _e413);
                            phi_1645_ = 340282350000000000000000000000000000000f;
                            phi_1647_ = 0f;
                            phi_1649_ = 0f;
                            loop {
                                let _e416 = phi_5210_;
                                let _e418 = phi_1642_;
                                let _e420 = phi_1645_;
                                let _e422 = phi_1647_;
                                let _e424 = phi_1649_;
                                local_5 = _e422;
                                local_6 = _e422;
                                local_14 = _e422;
                                local_7 = _e420;
                                local_8 = _e422;
                                local_9 = _e424;
                                local_10 = _e422;
                                if (_e418.member < _e418.member_1) {
                                    phi_1643_ = type_13((_e418.member + 1u), _e418.member_1);
                                    phi_1672_ = type_13(1u, _e418.member);
                                } else {
                                    phi_1643_ = _e418;
                                    phi_1672_ = type_13(0u, type_13().member_1);
                                }
                                let _e437 = phi_1643_;
                                let _e439 = phi_1672_;
                                let _e443 = (bitcast<i32>(_e439.member) != 0i);
                                if _e443 {
                                    let _e453 = (_e401.member[0] - _e144.member[0]);
                                    let _e454 = (_e401.member[1] - _e144.member[1]);
                                    let _e455 = (_e401.member[2] - _e144.member[2]);
                                    if _e409 {
                                        let _e787 = (_e401.member_2[0] - _e401.member[0]);
                                        let _e788 = (_e401.member_2[1] - _e401.member[1]);
                                        let _e789 = (_e401.member_2[2] - _e401.member[2]);
                                        let _e790 = (_e401.member_4[0] - _e401.member[0]);
                                        let _e791 = (_e401.member_4[1] - _e401.member[1]);
                                        let _e792 = (_e401.member_4[2] - _e401.member[2]);
                                        let _e795 = ((_e788 * _e792) - (_e791 * _e789));
                                        let _e798 = ((_e789 * _e790) - (_e792 * _e787));
                                        let _e801 = ((_e787 * _e791) - (_e790 * _e788));
                                        let _e802 = abs(_e795);
                                        let _e803 = abs(_e798);
                                        let _e805 = select(_e803, _e802, (_e802 > _e803));
                                        let _e806 = abs(_e801);
                                        let _e808 = select(_e806, _e805, (_e805 > _e806));
                                        if (_e808 > 0.000000000000000000000000000000000000011754944f) {
                                            let _e810 = (_e808 < 340282350000000000000000000000000000000f);
                                            if _e810 {
                                                let _e811 = (_e795 / _e808);
                                                let _e812 = (_e798 / _e808);
                                                let _e813 = (_e801 / _e808);
                                                let _e819 = sqrt((((_e811 * _e811) + (_e812 * _e812)) + (_e813 * _e813)));
                                                phi_1751_ = vec3<f32>((_e811 / _e819), (_e812 / _e819), (_e813 / _e819));
                                            } else {
                                                phi_1751_ = vec3<f32>();
                                            }
                                            let _e825 = phi_1751_;
                                            phi_1753_ = _e825;
                                            phi_1754_ = select(true, false, _e810);
                                        } else {
                                            phi_1753_ = vec3<f32>();
                                            phi_1754_ = true;
                                        }
                                        let _e828 = phi_1753_;
                                        let _e830 = phi_1754_;
                                        let _e832 = select(_e828, vec3<f32>(0f, 0f, 0f), vec3(_e830));
                                        let _e843 = (((_e832.x * (_e144.member[0] - _e401.member[0])) + (_e832.y * (_e144.member[1] - _e401.member[1]))) + (_e832.z * (_e144.member[2] - _e401.member[2])));
                                        let _e849 = ((_e403 ^ (_e403 >> bitcast<u32>(16i))) * 2146121005u);
                                        let _e853 = ((_e849 ^ (_e849 >> bitcast<u32>(15i))) * 2221713035u);
                                        let _e860 = (_e403 ^ 2654435769u);
                                        let _e864 = ((_e860 ^ (_e860 >> bitcast<u32>(16i))) * 2146121005u);
                                        let _e868 = ((_e864 ^ (_e864 >> bitcast<u32>(15i))) * 2221713035u);
                                        let _e886 = (0.000000059604645f * (f32(((2147483648u + (_e439.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e853 ^ (_e853 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                        if (_e886 >= 1f) {
                                            phi_3874_ = (_e886 - 1f);
                                        } else {
                                            phi_3874_ = _e886;
                                        }
                                        let _e890 = phi_3874_;
                                        let _e892 = (0.000000059604645f * (f32(((2147483648u + (_e439.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e868 ^ (_e868 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                        if (_e892 >= 1f) {
                                            phi_3882_ = (_e892 - 1f);
                                        } else {
                                            phi_3882_ = _e892;
                                        }
                                        let _e896 = phi_3882_;
                                        if (_e890 < _e896) {
                                            let _e901 = (0.5f * _e890);
                                            phi_1828_ = vec2<f32>(_e901, (_e896 - _e901));
                                        } else {
                                            let _e898 = (0.5f * _e896);
                                            phi_1828_ = vec2<f32>((_e890 - _e898), _e898);
                                        }
                                        let _e905 = phi_1828_;
                                        let _e917 = ((_e401.member[0] + (_e787 * _e905.x)) + (_e790 * _e905.y));
                                        let _e918 = ((_e401.member[1] + (_e788 * _e905.x)) + (_e791 * _e905.y));
                                        let _e919 = ((_e401.member[2] + (_e789 * _e905.x)) + (_e792 * _e905.y));
                                        let _e920 = abs(_e917);
                                        let _e921 = abs(_e918);
                                        let _e923 = select(_e921, _e920, (_e920 > _e921));
                                        let _e924 = abs(_e919);
                                        let _e930 = ((select(_e924, _e923, (_e923 > _e924)) + sqrt(_e401.member_3)) * 0.0000009536743f);
                                        let _e934 = (_e917 + (_e832.x * _e930));
                                        let _e935 = (_e918 + (_e832.y * _e930));
                                        let _e936 = (_e919 + (_e832.z * _e930));
                                        let _e942 = (_e917 - _e144.member[0]);
                                        let _e943 = (_e918 - _e144.member[1]);
                                        let _e944 = (_e919 - _e144.member[2]);
                                        let _e949 = (((_e942 * _e942) + (_e943 * _e943)) + (_e944 * _e944));
                                        let _e957 = (((_e166.x * _e942) + (_e166.y * _e943)) + (_e166.z * _e944));
                                        let _e961 = (_e949 * _e949);
                                        phi_2306_ = ((select(0f, _e957, (_e957 > 0f)) * select(0f, _e843, (_e843 > 0f))) / select(0.000000000000000000000000000000000000011754944f, _e961, (_e961 > 0.000000000000000000000000000000000000011754944f)));
                                        phi_2307_ = vec3<f32>((_e934 - _e144.member[0]), (_e935 - _e144.member[1]), (_e936 - _e144.member[2]));
                                        phi_2308_ = _e949;
                                        phi_2309_ = vec3<f32>(_e934, _e935, _e936);
                                        phi_2310_ = type_49();
                                        phi_2311_ = f32();
                                        phi_2312_ = true;
                                    } else {
                                        if (_e401.member_1 == 2u) {
                                            let _e735 = -(_e401.member_2[0]);
                                            let _e736 = -(_e401.member_2[1]);
                                            let _e737 = -(_e401.member_2[2]);
                                            let _e746 = (((_e166.x * _e735) + (_e166.y * _e736)) + (_e166.z * _e737));
                                            phi_2269_ = select(0f, _e746, (_e746 > 0f));
                                            phi_2270_ = vec3<f32>(_e735, _e736, _e737);
                                            phi_2271_ = f32();
                                            phi_2272_ = true;
                                        } else {
                                            let _e458 = (_e401.member_1 == 4294967295u);
                                            if _e458 {
                                                let _e511 = bitcast<f32>((1065353216u | (bitcast<u32>(_e166.z) & 2147483648u)));
                                                let _e513 = (-1f / (_e511 + _e166.z));
                                                let _e517 = ((_e166.x * _e166.y) * _e513);
                                                let _e532 = ((_e403 ^ (_e403 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e536 = ((_e532 ^ (_e532 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e543 = (_e403 ^ 2654435769u);
                                                let _e547 = ((_e543 ^ (_e543 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e551 = ((_e547 ^ (_e547 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e569 = (0.000000059604645f * (f32(((2147483648u + (_e439.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e536 ^ (_e536 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e569 >= 1f) {
                                                    phi_3858_ = (_e569 - 1f);
                                                } else {
                                                    phi_3858_ = _e569;
                                                }
                                                let _e573 = phi_3858_;
                                                let _e575 = (0.000000059604645f * (f32(((2147483648u + (_e439.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e551 ^ (_e551 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e575 >= 1f) {
                                                    phi_3866_ = (_e575 - 1f);
                                                } else {
                                                    phi_3866_ = _e575;
                                                }
                                                let _e579 = phi_3866_;
                                                let _e581 = ((2f * _e573) - 1f);
                                                let _e583 = ((2f * _e579) - 1f);
                                                if (_e581 == 0f) {
                                                    let _e585 = (_e583 == 0f);
                                                    phi_2024_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e585));
                                                    phi_2025_ = select(true, false, _e585);
                                                } else {
                                                    phi_2024_ = vec2<f32>();
                                                    phi_2025_ = true;
                                                }
                                                let _e590 = phi_2024_;
                                                let _e592 = phi_2025_;
                                                if _e592 {
                                                    if (abs(_e581) > abs(_e583)) {
                                                        let _e649 = (_e583 / _e581);
                                                        let _e653 = floor(((_e649 * 0.5f) + 0.5f));
                                                        let _e659 = ((((0.7853982f * _e649) - (_e653 * 1.5703125f)) - (_e653 * 0.0004837513f)) - (_e653 * 0.0000000754979f));
                                                        let _e660 = (_e659 * _e659);
                                                        let _e667 = (_e659 + ((_e659 * _e660) * (-0.16666655f + (_e660 * (0.008332161f + (_e660 * -0.00019515296f))))));
                                                        let _e676 = ((1f - (0.5f * _e660)) + ((_e660 * _e660) * (0.041666646f + (_e660 * (-0.0013887316f + (_e660 * 0.000024433157f))))));
                                                        let _e683 = select(0i, select(select(i32(_e653), i32(-2147483648), (_e653 < -2147483600f)), 2147483647i, (_e653 > 2147483500f)), (_e653 == _e653));
                                                        let _e685 = ((_e683 & 1i) == 0i);
                                                        let _e686 = select(_e676, _e667, _e685);
                                                        let _e687 = select(_e667, _e676, _e685);
                                                        if ((_e683 & 2i) == 0i) {
                                                            phi_2089_ = _e686;
                                                        } else {
                                                            phi_2089_ = -(_e686);
                                                        }
                                                        let _e692 = phi_2089_;
                                                        if (((_e683 + 1i) & 2i) == 0i) {
                                                            phi_2097_ = _e687;
                                                        } else {
                                                            phi_2097_ = -(_e687);
                                                        }
                                                        let _e698 = phi_2097_;
                                                        phi_2167_ = vec2<f32>((_e581 * _e698), (_e581 * _e692));
                                                    } else {
                                                        let _e596 = (_e581 / _e583);
                                                        let _e600 = floor(((_e596 * 0.5f) + 0.5f));
                                                        let _e606 = ((((0.7853982f * _e596) - (_e600 * 1.5703125f)) - (_e600 * 0.0004837513f)) - (_e600 * 0.0000000754979f));
                                                        let _e607 = (_e606 * _e606);
                                                        let _e614 = (_e606 + ((_e606 * _e607) * (-0.16666655f + (_e607 * (0.008332161f + (_e607 * -0.00019515296f))))));
                                                        let _e623 = ((1f - (0.5f * _e607)) + ((_e607 * _e607) * (0.041666646f + (_e607 * (-0.0013887316f + (_e607 * 0.000024433157f))))));
                                                        let _e630 = select(0i, select(select(i32(_e600), i32(-2147483648), (_e600 < -2147483600f)), 2147483647i, (_e600 > 2147483500f)), (_e600 == _e600));
                                                        let _e632 = ((_e630 & 1i) == 0i);
                                                        let _e633 = select(_e623, _e614, _e632);
                                                        let _e634 = select(_e614, _e623, _e632);
                                                        if ((_e630 & 2i) == 0i) {
                                                            phi_2155_ = _e633;
                                                        } else {
                                                            phi_2155_ = -(_e633);
                                                        }
                                                        let _e639 = phi_2155_;
                                                        if (((_e630 + 1i) & 2i) == 0i) {
                                                            phi_2163_ = _e634;
                                                        } else {
                                                            phi_2163_ = -(_e634);
                                                        }
                                                        let _e645 = phi_2163_;
                                                        phi_2167_ = vec2<f32>((_e583 * _e639), (_e583 * _e645));
                                                    }
                                                    let _e703 = phi_2167_;
                                                    phi_2168_ = _e703;
                                                } else {
                                                    phi_2168_ = _e590;
                                                }
                                                let _e705 = phi_2168_;
                                                let _e711 = (1f - ((_e705.x * _e705.x) + (_e705.y * _e705.y)));
                                                let _e714 = sqrt(select(0f, _e711, (_e711 > 0f)));
                                                phi_2267_ = vec3<f32>(((((1f + (((_e511 * _e166.x) * _e166.x) * _e513)) * _e705.x) + (_e517 * _e705.y)) + (_e166.x * _e714)), ((((_e511 * _e517) * _e705.x) + ((_e511 + ((_e166.y * _e166.y) * _e513)) * _e705.y)) + (_e166.y * _e714)), ((((-(_e511) * _e166.x) * _e705.x) + (-(_e166.y) * _e705.y)) + (_e166.z * _e714)));
                                                phi_2268_ = f32();
                                            } else {
                                                let _e464 = sqrt((((_e453 * _e453) + (_e454 * _e454)) + (_e455 * _e455)));
                                                let _e472 = (((_e166.x * _e453) + (_e166.y * _e454)) + (_e166.z * _e455));
                                                let _e476 = ((_e464 * _e464) * _e464);
                                                let _e479 = (select(0f, _e472, (_e472 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e476, (_e476 > 0.000000000000000000000000000000000000011754944f)));
                                                if (_e401.member_1 == 1u) {
                                                    let _e495 = (_e401.member_4[0] - _e401.member_4[1]);
                                                    let _e498 = (((-((((_e453 * _e401.member_2[0]) + (_e454 * _e401.member_2[1])) + (_e455 * _e401.member_2[2]))) / select(0.000000000000000000000000000000000000011754944f, _e464, (_e464 > 0.000000000000000000000000000000000000011754944f))) - _e401.member_4[1]) / select(0.001f, _e495, (_e495 > 0.001f)));
                                                    let _e500 = select(0f, _e498, (_e498 > 0f));
                                                    let _e502 = select(1f, _e500, (_e500 < 1f));
                                                    phi_2266_ = (_e479 * (_e502 * _e502));
                                                } else {
                                                    phi_2266_ = _e479;
                                                }
                                                let _e506 = phi_2266_;
                                                phi_2267_ = vec3<f32>();
                                                phi_2268_ = _e506;
                                            }
                                            let _e732 = phi_2267_;
                                            let _e734 = phi_2268_;
                                            phi_2269_ = 1f;
                                            phi_2270_ = _e732;
                                            phi_2271_ = _e734;
                                            phi_2272_ = _e458;
                                        }
                                        let _e750 = phi_2269_;
                                        let _e752 = phi_2270_;
                                        let _e754 = phi_2271_;
                                        let _e756 = phi_2272_;
                                        if _e756 {
                                            if ((((_e166.x * _e752.x) + (_e166.y * _e752.y)) + (_e166.z * _e752.z)) < 0f) {
                                                phi_2292_ = -(_e188);
                                            } else {
                                                phi_2292_ = _e188;
                                            }
                                            let _e771 = phi_2292_;
                                            phi_2304_ = type_49(vec3<f32>((_e144.member[0] + (_e166.x * _e771)), (_e144.member[1] + (_e166.y * _e771)), (_e144.member[2] + (_e166.z * _e771))), _e752, 0f, 340282350000000000000000000000000000000f);
                                        } else {
                                            phi_2304_ = type_49();
                                        }
                                        let _e781 = phi_2304_;
                                        phi_2306_ = _e754;
                                        phi_2307_ = vec3<f32>(_e453, _e454, _e455);
                                        phi_2308_ = 340282350000000000000000000000000000000f;
                                        phi_2309_ = vec3<f32>(_e401.member[0], _e401.member[1], _e401.member[2]);
                                        phi_2310_ = _e781;
                                        phi_2311_ = _e750;
                                        phi_2312_ = select(true, false, _e756);
                                    }
                                    let _e966 = phi_2306_;
                                    let _e968 = phi_2307_;
                                    let _e970 = phi_2308_;
                                    let _e972 = phi_2309_;
                                    let _e974 = phi_2310_;
                                    let _e976 = phi_2311_;
                                    let _e978 = phi_2312_;
                                    if _e978 {
                                        if ((((_e166.x * _e968.x) + (_e166.y * _e968.y)) + (_e166.z * _e968.z)) < 0f) {
                                            phi_2332_ = -(_e188);
                                        } else {
                                            phi_2332_ = _e188;
                                        }
                                        let _e993 = phi_2332_;
                                        let _e1000 = vec3<f32>((_e144.member[0] + (_e166.x * _e993)), (_e144.member[1] + (_e166.y * _e993)), (_e144.member[2] + (_e166.z * _e993)));
                                        phi_2346_ = type_49(_e1000, (_e972 - _e1000), 0f, 0.9999995f);
                                    } else {
                                        phi_2346_ = _e974;
                                    }
                                    let _e1004 = phi_2346_;
                                    let _e1005 = select(_e976, _e966, _e978);
                                    let _e1006 = select(340282350000000000000000000000000000000f, _e970, _e978);
                                    if (_e1005 > 0f) {
                                        let _e1013 = abs(_e1004.member_1.x);
                                        let _e1016 = abs(_e1004.member_1.y);
                                        let _e1019 = abs(_e1004.member_1.z);
                                        let _e1020 = (_e1013 > _e1016);
                                        if _e1020 {
                                            phi_2379_ = (_e1013 > _e1019);
                                        } else {
                                            phi_2379_ = (_e1016 > _e1019);
                                        }
                                        let _e1024 = phi_2379_;
                                        let _e1025 = select(1u, 0u, _e1020);
                                        if _e1024 {
                                            let _e1026 = (_e1025 + 1u);
                                            phi_2389_ = _e1026;
                                            phi_2392_ = select(true, false, (_e1026 == 2u));
                                        } else {
                                            phi_2389_ = u32();
                                            phi_2392_ = false;
                                        }
                                        let _e1030 = phi_2389_;
                                        let _e1032 = phi_2392_;
                                        let _e1033 = select(true, false, _e1024);
                                        let _e1034 = select(_e1030, 0u, _e1033);
                                        let _e1036 = select(_e1032, true, _e1033);
                                        if _e1036 {
                                            phi_2403_ = (_e1034 + 1u);
                                        } else {
                                            phi_2403_ = 0u;
                                        }
                                        let _e1039 = phi_2403_;
                                        let _e1040 = select(_e1030, _e1034, _e1036);
                                        let _e1041 = select(_e1025, select(_e1025, 2u, _e1033), _e1036);
                                        local_1 = array<f32, 3>(_e1004.member_1.x, _e1004.member_1.y, _e1004.member_1.z);
                                        local_2 = array<f32, 3>(_e1004.member.x, _e1004.member.y, _e1004.member.z);
                                        let _e1050 = (_e1041 < 3u);
                                        if _e1050 {
                                        } else {
                                            phi_5353_ = true;
                                            break;
                                        }
                                        let _e1052 = local_1[_e1041];
                                        let _e1053 = (1f / _e1052);
                                        let _e1054 = (_e1040 < 3u);
                                        if _e1054 {
                                        } else {
                                            phi_5353_ = true;
                                            break;
                                        }
                                        let _e1056 = local_1[_e1040];
                                        let _e1057 = (_e1056 * _e1053);
                                        let _e1058 = (_e1039 < 3u);
                                        if _e1058 {
                                        } else {
                                            phi_5353_ = true;
                                            break;
                                        }
                                        let _e1060 = local_1[_e1039];
                                        let _e1061 = (_e1060 * _e1053);
                                        if _e1054 {
                                        } else {
                                            phi_5353_ = true;
                                            break;
                                        }
                                        let _e1063 = local_2[_e1040];
                                        if _e1058 {
                                        } else {
                                            phi_5353_ = true;
                                            break;
                                        }
                                        let _e1065 = local_2[_e1039];
                                        if _e1050 {
                                        } else {
                                            phi_5353_ = true;
                                            break;
                                        }
                                        let _e1067 = local_2[_e1041];
                                        if (0u < _e119) {
                                        } else {
                                            phi_5353_ = true;
                                            break;
                                        }
                                        let _e1072 = nodes.member[0u].member_7[0u];
                                        let _e1076 = nodes.member[0u].member_7[1u];
                                        let _e1080 = nodes.member[0u].member_7[2u];
                                        let _e1084 = nodes.member[0u].member_7[3u];
                                        let _e1086 = abs((_e1004.member.x - _e1072));
                                        let _e1088 = abs((_e1004.member.y - _e1076));
                                        let _e1090 = select(_e1088, _e1086, (_e1086 > _e1088));
                                        let _e1092 = abs((_e1004.member.z - _e1080));
                                        let _e1096 = ((select(_e1092, _e1090, (_e1090 > _e1092)) + _e1084) * 0.0000009536743f);
                                        let _e1103 = (_e1096 + (abs(_e1004.member.x) * 0.00000023841858f));
                                        let _e1104 = (_e1096 + (abs(_e1004.member.y) * 0.00000023841858f));
                                        let _e1105 = (_e1096 + (abs(_e1004.member.z) * 0.00000023841858f));
                                        let _e1106 = select(_e1016, _e1013, _e1020);
                                        let _e1108 = select(_e1019, _e1106, (_e1106 > _e1019));
                                        let _e1109 = (_e1108 * 0.000000000001f);
                                        let _e1112 = (_e1004.member.x + _e1103);
                                        let _e1114 = (_e1004.member.y + _e1104);
                                        let _e1116 = (_e1004.member.z + _e1105);
                                        let _e1117 = (_e1004.member.x - _e1103);
                                        let _e1118 = (_e1004.member.y - _e1104);
                                        let _e1119 = (_e1004.member.z - _e1105);
                                        if (_e1013 > _e1109) {
                                            phi_2556_ = (1f / _e1004.member_1.x);
                                        } else {
                                            phi_2556_ = (1000000000000f / _e1108);
                                        }
                                        let _e1124 = phi_2556_;
                                        if (_e1016 > _e1109) {
                                            phi_2564_ = (1f / _e1004.member_1.y);
                                        } else {
                                            phi_2564_ = (1000000000000f / _e1108);
                                        }
                                        let _e1129 = phi_2564_;
                                        if (_e1019 > _e1109) {
                                            phi_2572_ = (1f / _e1004.member_1.z);
                                        } else {
                                            phi_2572_ = (1000000000000f / _e1108);
                                        }
                                        let _e1134 = phi_2572_;
                                        local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_5188_ = _e416;
                                        phi_2576_ = 0u;
                                        phi_2579_ = 0u;
                                        loop {
                                            let _e1138 = phi_5188_;
                                            let _e1140 = phi_2576_;
                                            let _e1142 = phi_2579_;
                                            let _e1143 = (_e1140 & 15u);
                                            let _e1145 = (_e1140 >> bitcast<u32>(4u));
                                            if (_e1143 == 0u) {
                                                if (_e1145 < _e119) {
                                                } else {
                                                    phi_5293_ = true;
                                                    phi_3850_ = bool();
                                                    break;
                                                }
                                                let _e1778 = nodes.member[_e1145].member;
                                                let _e1787 = ((_e1778.x - _e1112) * _e1124);
                                                let _e1788 = ((_e1778.y - _e1112) * _e1124);
                                                let _e1789 = ((_e1778.z - _e1112) * _e1124);
                                                let _e1790 = ((_e1778.w - _e1112) * _e1124);
                                                let _e1793 = nodes.member[_e1145].member_3;
                                                let _e1802 = ((_e1793.x - _e1117) * _e1124);
                                                let _e1803 = ((_e1793.y - _e1117) * _e1124);
                                                let _e1804 = ((_e1793.z - _e1117) * _e1124);
                                                let _e1805 = ((_e1793.w - _e1117) * _e1124);
                                                let _e1808 = nodes.member[_e1145].member_1;
                                                let _e1817 = ((_e1808.x - _e1114) * _e1129);
                                                let _e1818 = ((_e1808.y - _e1114) * _e1129);
                                                let _e1819 = ((_e1808.z - _e1114) * _e1129);
                                                let _e1820 = ((_e1808.w - _e1114) * _e1129);
                                                let _e1823 = nodes.member[_e1145].member_4;
                                                let _e1832 = ((_e1823.x - _e1118) * _e1129);
                                                let _e1833 = ((_e1823.y - _e1118) * _e1129);
                                                let _e1834 = ((_e1823.z - _e1118) * _e1129);
                                                let _e1835 = ((_e1823.w - _e1118) * _e1129);
                                                let _e1838 = nodes.member[_e1145].member_2;
                                                let _e1847 = ((_e1838.x - _e1116) * _e1134);
                                                let _e1848 = ((_e1838.y - _e1116) * _e1134);
                                                let _e1849 = ((_e1838.z - _e1116) * _e1134);
                                                let _e1850 = ((_e1838.w - _e1116) * _e1134);
                                                let _e1853 = nodes.member[_e1145].member_5;
                                                let _e1862 = ((_e1853.x - _e1119) * _e1134);
                                                let _e1863 = ((_e1853.y - _e1119) * _e1134);
                                                let _e1864 = ((_e1853.z - _e1119) * _e1134);
                                                let _e1865 = ((_e1853.w - _e1119) * _e1134);
                                                let _e1867 = select(_e1802, _e1787, (_e1787 < _e1802));
                                                let _e1869 = select(_e1803, _e1788, (_e1788 < _e1803));
                                                let _e1871 = select(_e1804, _e1789, (_e1789 < _e1804));
                                                let _e1873 = select(_e1805, _e1790, (_e1790 < _e1805));
                                                let _e1875 = select(_e1832, _e1817, (_e1817 < _e1832));
                                                let _e1877 = select(_e1833, _e1818, (_e1818 < _e1833));
                                                let _e1879 = select(_e1834, _e1819, (_e1819 < _e1834));
                                                let _e1881 = select(_e1835, _e1820, (_e1820 < _e1835));
                                                let _e1883 = select(_e1875, _e1867, (_e1867 > _e1875));
                                                let _e1885 = select(_e1877, _e1869, (_e1869 > _e1877));
                                                let _e1887 = select(_e1879, _e1871, (_e1871 > _e1879));
                                                let _e1889 = select(_e1881, _e1873, (_e1873 > _e1881));
                                                let _e1891 = select(_e1862, _e1847, (_e1847 < _e1862));
                                                let _e1893 = select(_e1863, _e1848, (_e1848 < _e1863));
                                                let _e1895 = select(_e1864, _e1849, (_e1849 < _e1864));
                                                let _e1897 = select(_e1865, _e1850, (_e1850 < _e1865));
                                                let _e1899 = select(_e1891, _e1883, (_e1883 > _e1891));
                                                let _e1901 = select(_e1893, _e1885, (_e1885 > _e1893));
                                                let _e1903 = select(_e1895, _e1887, (_e1887 > _e1895));
                                                let _e1905 = select(_e1897, _e1889, (_e1889 > _e1897));
                                                let _e1907 = select(_e1004.member_2, _e1899, (_e1899 > _e1004.member_2));
                                                let _e1909 = select(_e1004.member_2, _e1901, (_e1901 > _e1004.member_2));
                                                let _e1911 = select(_e1004.member_2, _e1903, (_e1903 > _e1004.member_2));
                                                let _e1913 = select(_e1004.member_2, _e1905, (_e1905 > _e1004.member_2));
                                                let _e1915 = select(_e1802, _e1787, (_e1787 > _e1802));
                                                let _e1917 = select(_e1803, _e1788, (_e1788 > _e1803));
                                                let _e1919 = select(_e1804, _e1789, (_e1789 > _e1804));
                                                let _e1921 = select(_e1805, _e1790, (_e1790 > _e1805));
                                                let _e1923 = select(_e1832, _e1817, (_e1817 > _e1832));
                                                let _e1925 = select(_e1833, _e1818, (_e1818 > _e1833));
                                                let _e1927 = select(_e1834, _e1819, (_e1819 > _e1834));
                                                let _e1929 = select(_e1835, _e1820, (_e1820 > _e1835));
                                                let _e1931 = select(_e1923, _e1915, (_e1915 < _e1923));
                                                let _e1933 = select(_e1925, _e1917, (_e1917 < _e1925));
                                                let _e1935 = select(_e1927, _e1919, (_e1919 < _e1927));
                                                let _e1937 = select(_e1929, _e1921, (_e1921 < _e1929));
                                                let _e1939 = select(_e1862, _e1847, (_e1847 > _e1862));
                                                let _e1941 = select(_e1863, _e1848, (_e1848 > _e1863));
                                                let _e1943 = select(_e1864, _e1849, (_e1849 > _e1864));
                                                let _e1945 = select(_e1865, _e1850, (_e1850 > _e1865));
                                                let _e1947 = select(_e1939, _e1931, (_e1931 < _e1939));
                                                let _e1949 = select(_e1941, _e1933, (_e1933 < _e1941));
                                                let _e1951 = select(_e1943, _e1935, (_e1935 < _e1943));
                                                let _e1953 = select(_e1945, _e1937, (_e1937 < _e1945));
                                                let _e1973 = nodes.member[_e1145].member_6[0u];
                                                let _e1977 = nodes.member[_e1145].member_6[1u];
                                                let _e1981 = nodes.member[_e1145].member_6[2u];
                                                let _e1985 = nodes.member[_e1145].member_6[3u];
                                                if (select(340282350000000000000000000000000000000f, _e1913, (_e1913 <= select(_e1004.member_3, _e1953, (_e1953 < _e1004.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e1142 < 64u) {
                                                    } else {
                                                        phi_5293_ = true;
                                                        phi_3850_ = bool();
                                                        break;
                                                    }
                                                    local[_e1142] = _e1985;
                                                    phi_2966_ = (_e1142 + 1u);
                                                } else {
                                                    phi_2966_ = _e1142;
                                                }
                                                let _e1991 = phi_2966_;
                                                if (select(340282350000000000000000000000000000000f, _e1911, (_e1911 <= select(_e1004.member_3, _e1951, (_e1951 < _e1004.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e1991 < 64u) {
                                                    } else {
                                                        phi_5293_ = true;
                                                        phi_3850_ = bool();
                                                        break;
                                                    }
                                                    local[_e1991] = _e1981;
                                                    phi_2978_ = (_e1991 + 1u);
                                                } else {
                                                    phi_2978_ = _e1991;
                                                }
                                                let _e1997 = phi_2978_;
                                                if (select(340282350000000000000000000000000000000f, _e1909, (_e1909 <= select(_e1004.member_3, _e1949, (_e1949 < _e1004.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e1997 < 64u) {
                                                    } else {
                                                        phi_5293_ = true;
                                                        phi_3850_ = bool();
                                                        break;
                                                    }
                                                    local[_e1997] = _e1977;
                                                    phi_2990_ = (_e1997 + 1u);
                                                } else {
                                                    phi_2990_ = _e1997;
                                                }
                                                let _e2003 = phi_2990_;
                                                if (select(340282350000000000000000000000000000000f, _e1907, (_e1907 <= select(_e1004.member_3, _e1947, (_e1947 < _e1004.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2003 < 64u) {
                                                    } else {
                                                        phi_5293_ = true;
                                                        phi_3850_ = bool();
                                                        break;
                                                    }
                                                    local[_e2003] = _e1973;
                                                    phi_3002_ = (_e2003 + 1u);
                                                } else {
                                                    phi_3002_ = _e2003;
                                                }
                                                let _e2009 = phi_3002_;
                                                phi_5295_ = _e1138;
                                                phi_3695_ = _e2009;
                                                phi_3696_ = true;
                                            } else {
                                                phi_3006_ = type_13(_e1145, (_e1145 + _e1143));
                                                loop {
                                                    let _e1150 = phi_3006_;
                                                    if (_e1150.member < _e1150.member_1) {
                                                        phi_3007_ = type_13((_e1150.member + 1u), _e1150.member_1);
                                                        phi_3030_ = type_13(1u, _e1150.member);
                                                    } else {
                                                        phi_3007_ = _e1150;
                                                        phi_3030_ = type_13(0u, type_13().member_1);
                                                    }
                                                    let _e1163 = phi_3007_;
                                                    let _e1165 = phi_3030_;
                                                    let _e1169 = (bitcast<i32>(_e1165.member) != 0i);
                                                    if _e1169 {
                                                        let _e1170 = (_e1165.member_1 < arrayLength((&triangles.member)));
                                                        if _e1170 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        if _e1050 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        let _e1174 = triangles.member[_e1165.member_1].member[_e1041];
                                                        let _e1175 = (_e1174 - _e1067);
                                                        if _e1050 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        let _e1179 = triangles.member[_e1165.member_1].member_2[_e1041];
                                                        let _e1180 = (_e1179 - _e1067);
                                                        if _e1050 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        let _e1184 = triangles.member[_e1165.member_1].member_4[_e1041];
                                                        let _e1185 = (_e1184 - _e1067);
                                                        if _e1054 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        let _e1189 = triangles.member[_e1165.member_1].member[_e1040];
                                                        let _e1192 = ((_e1189 - _e1063) - (_e1057 * _e1175));
                                                        if _e1058 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        let _e1196 = triangles.member[_e1165.member_1].member[_e1039];
                                                        let _e1199 = ((_e1196 - _e1065) - (_e1061 * _e1175));
                                                        if _e1054 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        let _e1203 = triangles.member[_e1165.member_1].member_2[_e1040];
                                                        let _e1206 = ((_e1203 - _e1063) - (_e1057 * _e1180));
                                                        if _e1058 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        let _e1210 = triangles.member[_e1165.member_1].member_2[_e1039];
                                                        let _e1213 = ((_e1210 - _e1065) - (_e1061 * _e1180));
                                                        if _e1054 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        let _e1217 = triangles.member[_e1165.member_1].member_4[_e1040];
                                                        let _e1220 = ((_e1217 - _e1063) - (_e1057 * _e1185));
                                                        if _e1058 {
                                                        } else {
                                                            phi_5184_ = true;
                                                            phi_3849_ = bool();
                                                            break;
                                                        }
                                                        let _e1224 = triangles.member[_e1165.member_1].member_4[_e1039];
                                                        let _e1227 = ((_e1224 - _e1065) - (_e1061 * _e1185));
                                                        let _e1228 = (_e1220 * _e1213);
                                                        let _e1229 = (_e1227 * _e1206);
                                                        if (_e1228 != _e1229) {
                                                            phi_3146_ = (_e1228 - _e1229);
                                                        } else {
                                                            let _e1231 = (_e1220 * 4097f);
                                                            let _e1233 = (_e1231 - (_e1231 - _e1220));
                                                            let _e1234 = (_e1213 * 4097f);
                                                            let _e1236 = (_e1234 - (_e1234 - _e1213));
                                                            let _e1237 = (_e1220 - _e1233);
                                                            let _e1238 = (_e1213 - _e1236);
                                                            let _e1247 = (_e1227 * 4097f);
                                                            let _e1249 = (_e1247 - (_e1247 - _e1227));
                                                            let _e1250 = (_e1206 * 4097f);
                                                            let _e1252 = (_e1250 - (_e1250 - _e1206));
                                                            let _e1253 = (_e1227 - _e1249);
                                                            let _e1254 = (_e1206 - _e1252);
                                                            phi_3146_ = ((((((_e1233 * _e1236) - _e1228) + (_e1233 * _e1238)) + (_e1237 * _e1236)) + (_e1237 * _e1238)) - (((((_e1249 * _e1252) - _e1229) + (_e1249 * _e1254)) + (_e1253 * _e1252)) + (_e1253 * _e1254)));
                                                        }
                                                        let _e1266 = phi_3146_;
                                                        let _e1267 = (_e1192 * _e1227);
                                                        let _e1268 = (_e1199 * _e1220);
                                                        if (_e1267 != _e1268) {
                                                            phi_3157_ = (_e1267 - _e1268);
                                                        } else {
                                                            let _e1270 = (_e1192 * 4097f);
                                                            let _e1272 = (_e1270 - (_e1270 - _e1192));
                                                            let _e1273 = (_e1227 * 4097f);
                                                            let _e1275 = (_e1273 - (_e1273 - _e1227));
                                                            let _e1276 = (_e1192 - _e1272);
                                                            let _e1277 = (_e1227 - _e1275);
                                                            let _e1286 = (_e1199 * 4097f);
                                                            let _e1288 = (_e1286 - (_e1286 - _e1199));
                                                            let _e1289 = (_e1220 * 4097f);
                                                            let _e1291 = (_e1289 - (_e1289 - _e1220));
                                                            let _e1292 = (_e1199 - _e1288);
                                                            let _e1293 = (_e1220 - _e1291);
                                                            phi_3157_ = ((((((_e1272 * _e1275) - _e1267) + (_e1272 * _e1277)) + (_e1276 * _e1275)) + (_e1276 * _e1277)) - (((((_e1288 * _e1291) - _e1268) + (_e1288 * _e1293)) + (_e1292 * _e1291)) + (_e1292 * _e1293)));
                                                        }
                                                        let _e1305 = phi_3157_;
                                                        let _e1306 = (_e1206 * _e1199);
                                                        let _e1307 = (_e1213 * _e1192);
                                                        if (_e1306 != _e1307) {
                                                            phi_3168_ = (_e1306 - _e1307);
                                                        } else {
                                                            let _e1309 = (_e1206 * 4097f);
                                                            let _e1311 = (_e1309 - (_e1309 - _e1206));
                                                            let _e1312 = (_e1199 * 4097f);
                                                            let _e1314 = (_e1312 - (_e1312 - _e1199));
                                                            let _e1315 = (_e1206 - _e1311);
                                                            let _e1316 = (_e1199 - _e1314);
                                                            let _e1325 = (_e1213 * 4097f);
                                                            let _e1327 = (_e1325 - (_e1325 - _e1213));
                                                            let _e1328 = (_e1192 * 4097f);
                                                            let _e1330 = (_e1328 - (_e1328 - _e1192));
                                                            let _e1331 = (_e1213 - _e1327);
                                                            let _e1332 = (_e1192 - _e1330);
                                                            phi_3168_ = ((((((_e1311 * _e1314) - _e1306) + (_e1311 * _e1316)) + (_e1315 * _e1314)) + (_e1315 * _e1316)) - (((((_e1327 * _e1330) - _e1307) + (_e1327 * _e1332)) + (_e1331 * _e1330)) + (_e1331 * _e1332)));
                                                        }
                                                        let _e1344 = phi_3168_;
                                                        if (_e1266 < 0f) {
                                                            phi_3186_ = f32();
                                                            phi_3187_ = true;
                                                        } else {
                                                            if (_e1305 < 0f) {
                                                                phi_3184_ = f32();
                                                                phi_3185_ = true;
                                                            } else {
                                                                let _e1347 = (_e1344 < 0f);
                                                                if _e1347 {
                                                                    phi_3183_ = f32();
                                                                } else {
                                                                    phi_3183_ = ((_e1266 + _e1305) + _e1344);
                                                                }
                                                                let _e1351 = phi_3183_;
                                                                phi_3184_ = _e1351;
                                                                phi_3185_ = _e1347;
                                                            }
                                                            let _e1353 = phi_3184_;
                                                            let _e1355 = phi_3185_;
                                                            phi_3186_ = _e1353;
                                                            phi_3187_ = _e1355;
                                                        }
                                                        let _e1357 = phi_3186_;
                                                        let _e1359 = phi_3187_;
                                                        if _e1359 {
                                                            if (_e1266 > 0f) {
                                                                phi_3208_ = f32();
                                                                phi_3209_ = true;
                                                                phi_3210_ = false;
                                                            } else {
                                                                let _e1361 = (_e1305 > 0f);
                                                                if _e1361 {
                                                                    phi_3206_ = f32();
                                                                    phi_3207_ = false;
                                                                } else {
                                                                    phi_3206_ = ((_e1266 + _e1305) + _e1344);
                                                                    phi_3207_ = select(true, false, (_e1344 > 0f));
                                                                }
                                                                let _e1367 = phi_3206_;
                                                                let _e1369 = phi_3207_;
                                                                phi_3208_ = _e1367;
                                                                phi_3209_ = _e1361;
                                                                phi_3210_ = _e1369;
                                                            }
                                                            let _e1371 = phi_3208_;
                                                            let _e1373 = phi_3209_;
                                                            let _e1375 = phi_3210_;
                                                            phi_3215_ = _e1371;
                                                            phi_3216_ = select(_e1375, false, _e1373);
                                                        } else {
                                                            phi_3215_ = _e1357;
                                                            phi_3216_ = true;
                                                        }
                                                        let _e1378 = phi_3215_;
                                                        let _e1380 = phi_3216_;
                                                        if _e1380 {
                                                            let _e1381 = (_e1378 == 0f);
                                                            if _e1381 {
                                                                phi_3304_ = array<f32, 3>();
                                                                phi_3305_ = array<f32, 3>();
                                                                phi_3306_ = false;
                                                            } else {
                                                                let _e1382 = (_e1175 * _e1053);
                                                                let _e1383 = (_e1180 * _e1053);
                                                                let _e1384 = (_e1185 * _e1053);
                                                                let _e1387 = (1f / ((_e1266 + _e1305) + _e1344));
                                                                let _e1388 = (_e1305 * _e1387);
                                                                let _e1389 = (_e1344 * _e1387);
                                                                let _e1395 = ((((_e1266 * _e1387) * _e1382) + (_e1388 * _e1383)) + (_e1389 * _e1384));
                                                                let _e1396 = abs(_e1192);
                                                                let _e1397 = abs(_e1206);
                                                                let _e1399 = select(_e1397, _e1396, (_e1396 > _e1397));
                                                                let _e1400 = abs(_e1220);
                                                                let _e1403 = abs(_e1199);
                                                                let _e1404 = abs(_e1213);
                                                                let _e1406 = select(_e1404, _e1403, (_e1403 > _e1404));
                                                                let _e1407 = abs(_e1227);
                                                                let _e1411 = abs(_e1382);
                                                                let _e1412 = abs(_e1383);
                                                                let _e1414 = select(_e1412, _e1411, (_e1411 > _e1412));
                                                                let _e1415 = abs(_e1384);
                                                                let _e1422 = (((select(_e1400, _e1399, (_e1399 > _e1400)) * select(_e1407, _e1406, (_e1406 > _e1407))) * select(_e1415, _e1414, (_e1414 > _e1415))) <= (abs((_e1378 * _e1395)) * 256f));
                                                                if _e1422 {
                                                                    phi_3302_ = array<f32, 3>(_e1395, _e1388, _e1389);
                                                                    phi_3303_ = array<f32, 3>();
                                                                } else {
                                                                    let _e1424 = (_e1220 * 4097f);
                                                                    let _e1426 = (_e1424 - (_e1424 - _e1220));
                                                                    let _e1427 = (_e1213 * 4097f);
                                                                    let _e1429 = (_e1427 - (_e1427 - _e1213));
                                                                    let _e1430 = (_e1220 - _e1426);
                                                                    let _e1431 = (_e1213 - _e1429);
                                                                    let _e1440 = (_e1227 * 4097f);
                                                                    let _e1442 = (_e1440 - (_e1440 - _e1227));
                                                                    let _e1443 = (_e1206 * 4097f);
                                                                    let _e1445 = (_e1443 - (_e1443 - _e1206));
                                                                    let _e1446 = (_e1227 - _e1442);
                                                                    let _e1447 = (_e1206 - _e1445);
                                                                    let _e1457 = ((_e1228 - _e1229) + ((((((_e1426 * _e1429) - _e1228) + (_e1426 * _e1431)) + (_e1430 * _e1429)) + (_e1430 * _e1431)) - (((((_e1442 * _e1445) - _e1229) + (_e1442 * _e1447)) + (_e1446 * _e1445)) + (_e1446 * _e1447))));
                                                                    let _e1459 = (_e1192 * 4097f);
                                                                    let _e1461 = (_e1459 - (_e1459 - _e1192));
                                                                    let _e1462 = (_e1192 - _e1461);
                                                                    let _e1471 = (_e1199 * 4097f);
                                                                    let _e1473 = (_e1471 - (_e1471 - _e1199));
                                                                    let _e1474 = (_e1199 - _e1473);
                                                                    let _e1484 = ((_e1267 - _e1268) + ((((((_e1461 * _e1442) - _e1267) + (_e1461 * _e1446)) + (_e1462 * _e1442)) + (_e1462 * _e1446)) - (((((_e1473 * _e1426) - _e1268) + (_e1473 * _e1430)) + (_e1474 * _e1426)) + (_e1474 * _e1430))));
                                                                    let _e1503 = ((_e1306 - _e1307) + ((((((_e1445 * _e1473) - _e1306) + (_e1445 * _e1474)) + (_e1447 * _e1473)) + (_e1447 * _e1474)) - (((((_e1429 * _e1461) - _e1307) + (_e1429 * _e1462)) + (_e1431 * _e1461)) + (_e1431 * _e1462))));
                                                                    let _e1506 = (1f / ((_e1457 + _e1484) + _e1503));
                                                                    let _e1507 = (_e1484 * _e1506);
                                                                    let _e1508 = (_e1503 * _e1506);
                                                                    phi_3302_ = array<f32, 3>();
                                                                    phi_3303_ = array<f32, 3>(((((_e1457 * _e1506) * _e1382) + (_e1507 * _e1383)) + (_e1508 * _e1384)), _e1507, _e1508);
                                                                }
                                                                let _e1518 = phi_3302_;
                                                                let _e1520 = phi_3303_;
                                                                phi_3304_ = _e1518;
                                                                phi_3305_ = _e1520;
                                                                phi_3306_ = _e1422;
                                                            }
                                                            let _e1522 = phi_3304_;
                                                            let _e1524 = phi_3305_;
                                                            let _e1526 = phi_3306_;
                                                            phi_3307_ = _e1522;
                                                            phi_3308_ = _e1524;
                                                            phi_3309_ = _e1381;
                                                            phi_3310_ = _e1526;
                                                        } else {
                                                            phi_3307_ = array<f32, 3>();
                                                            phi_3308_ = array<f32, 3>();
                                                            phi_3309_ = true;
                                                            phi_3310_ = false;
                                                        }
                                                        let _e1528 = phi_3307_;
                                                        let _e1530 = phi_3308_;
                                                        let _e1532 = phi_3309_;
                                                        let _e1534 = phi_3310_;
                                                        if _e1532 {
                                                            phi_3315_ = array<f32, 3>(-1f, 0f, 0f);
                                                        } else {
                                                            phi_3315_ = _e1528;
                                                        }
                                                        let _e1536 = phi_3315_;
                                                        if select(_e1534, true, _e1532) {
                                                            phi_3320_ = _e1536;
                                                        } else {
                                                            phi_3320_ = _e1530;
                                                        }
                                                        let _e1539 = phi_3320_;
                                                        if (_e1539[0] >= _e1004.member_2) {
                                                            let _e1545 = (_e1539[0] < _e1004.member_3);
                                                            if _e1545 {
                                                                let _e1546 = (_e1539[0] >= 0f);
                                                                if _e1546 {
                                                                    if _e1170 {
                                                                    } else {
                                                                        phi_5184_ = true;
                                                                        phi_3849_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e1549 = triangles.member[_e1165.member_1].member_3;
                                                                    if ((_e1549 & 1u) == 0u) {
                                                                        phi_3653_ = true;
                                                                    } else {
                                                                        if _e1170 {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1554 = triangles.member[_e1165.member_1].member_1;
                                                                        let _e1555 = (_e1554 * 12u);
                                                                        if ((256u + _e1555) < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1555 + 257u) < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1555 + 258u) < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1562 = (_e1555 + 259u);
                                                                        if (_e1562 < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1565 = surfaces.member[_e1562];
                                                                        if ((_e1555 + 260u) < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1555 + 261u) < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1555 + 262u) < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1572 = (_e1555 + 263u);
                                                                        if (_e1572 < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1575 = surfaces.member[_e1572];
                                                                        let _e1576 = (_e1555 + 264u);
                                                                        if (_e1576 < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1579 = surfaces.member[_e1576];
                                                                        let _e1580 = bitcast<f32>(_e1579);
                                                                        let _e1581 = (_e1555 + 265u);
                                                                        if (_e1581 < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1584 = surfaces.member[_e1581];
                                                                        let _e1585 = bitcast<f32>(_e1584);
                                                                        if ((_e1555 + 266u) < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1555 + 267u) < _e128) {
                                                                        } else {
                                                                            phi_5184_ = true;
                                                                            phi_3849_ = bool();
                                                                            break;
                                                                        }
                                                                        if (_e1565 == 4294967295u) {
                                                                            phi_3648_ = (_e1580 < _e1585);
                                                                        } else {
                                                                            if (_e1165.member_1 < arrayLength((&attributes.member))) {
                                                                            } else {
                                                                                phi_5184_ = true;
                                                                                phi_3849_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1593 = ((1f - _e1539[1]) - _e1539[2]);
                                                                            let _e1597 = attributes.member[_e1165.member_1].member[0u];
                                                                            let _e1602 = attributes.member[_e1165.member_1].member[2u];
                                                                            let _e1608 = attributes.member[_e1165.member_1].member[4u];
                                                                            let _e1610 = (((_e1597 * _e1593) + (_e1602 * _e1539[1])) + (_e1608 * _e1539[2]));
                                                                            let _e1614 = attributes.member[_e1165.member_1].member[1u];
                                                                            let _e1619 = attributes.member[_e1165.member_1].member[3u];
                                                                            let _e1625 = attributes.member[_e1165.member_1].member[5u];
                                                                            let _e1627 = (((_e1614 * _e1593) + (_e1619 * _e1539[1])) + (_e1625 * _e1539[2]));
                                                                            let _e1628 = (_e1575 & 65535u);
                                                                            let _e1630 = (_e1575 >> bitcast<u32>(16i));
                                                                            let _e1632 = (_e1610 - floor(_e1610));
                                                                            let _e1637 = ((select(0f, _e1632, (_e1632 <= 1f)) * f32(_e1628)) - 0.5f);
                                                                            let _e1638 = floor(_e1637);
                                                                            let _e1639 = (_e1637 - _e1638);
                                                                            let _e1640 = (_e1628 - 1u);
                                                                            if (_e1638 < 0f) {
                                                                                phi_3531_ = _e1640;
                                                                            } else {
                                                                                let _e1646 = select(select(u32(_e1638), 0u, (_e1638 < 0f)), 4294967295u, (_e1638 > 4294967000f));
                                                                                phi_3531_ = select(_e1646, _e1640, (_e1640 < _e1646));
                                                                            }
                                                                            let _e1650 = phi_3531_;
                                                                            if (_e1650 == _e1640) {
                                                                                phi_3537_ = 0u;
                                                                            } else {
                                                                                phi_3537_ = (_e1650 + 1u);
                                                                            }
                                                                            let _e1654 = phi_3537_;
                                                                            let _e1656 = (_e1627 - floor(_e1627));
                                                                            let _e1661 = ((select(0f, _e1656, (_e1656 <= 1f)) * f32(_e1630)) - 0.5f);
                                                                            let _e1662 = floor(_e1661);
                                                                            let _e1663 = (_e1661 - _e1662);
                                                                            let _e1664 = (_e1630 - 1u);
                                                                            if (_e1662 < 0f) {
                                                                                phi_3567_ = _e1664;
                                                                            } else {
                                                                                let _e1670 = select(select(u32(_e1662), 0u, (_e1662 < 0f)), 4294967295u, (_e1662 > 4294967000f));
                                                                                phi_3567_ = select(_e1670, _e1664, (_e1664 < _e1670));
                                                                            }
                                                                            let _e1674 = phi_3567_;
                                                                            if (_e1674 == _e1664) {
                                                                                phi_3573_ = 0u;
                                                                            } else {
                                                                                phi_3573_ = (_e1674 + 1u);
                                                                            }
                                                                            let _e1678 = phi_3573_;
                                                                            let _e1680 = (_e1565 + (_e1674 * _e1628));
                                                                            let _e1682 = (_e1565 + (_e1678 * _e1628));
                                                                            let _e1683 = (_e1680 + _e1650);
                                                                            let _e1684 = (_e1680 + _e1654);
                                                                            let _e1685 = (_e1682 + _e1650);
                                                                            let _e1686 = (_e1682 + _e1654);
                                                                            if (_e1683 < _e128) {
                                                                            } else {
                                                                                phi_5184_ = true;
                                                                                phi_3849_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1689 = surfaces.member[_e1683];
                                                                            if (_e1684 < _e128) {
                                                                            } else {
                                                                                phi_5184_ = true;
                                                                                phi_3849_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1692 = surfaces.member[_e1684];
                                                                            if (_e1685 < _e128) {
                                                                            } else {
                                                                                phi_5184_ = true;
                                                                                phi_3849_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1695 = surfaces.member[_e1685];
                                                                            if (_e1686 < _e128) {
                                                                            } else {
                                                                                phi_5184_ = true;
                                                                                phi_3849_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1698 = surfaces.member[_e1686];
                                                                            let _e1715 = (1f - _e1639);
                                                                            phi_3648_ = ((_e1580 * (((((f32((_e1689 >> bitcast<u32>(24i))) * 0.003921569f) * _e1715) + ((f32((_e1692 >> bitcast<u32>(24i))) * 0.003921569f) * _e1639)) * (1f - _e1663)) + ((((f32((_e1695 >> bitcast<u32>(24i))) * 0.003921569f) * _e1715) + ((f32((_e1698 >> bitcast<u32>(24i))) * 0.003921569f) * _e1639)) * _e1663))) < _e1585);
                                                                        }
                                                                        let _e1730 = phi_3648_;
                                                                        phi_3653_ = select(true, false, _e1730);
                                                                    }
                                                                    let _e1733 = phi_3653_;
                                                                    if _e1733 {
                                                                        phi_3658_ = type_53(_e1539[0], _e1165.member_1, _e1539[1], _e1539[2]);
                                                                    } else {
                                                                        phi_3658_ = type_53();
                                                                    }
                                                                    let _e1736 = phi_3658_;
                                                                    phi_3660_ = _e1736;
                                                                    phi_3662_ = select(true, false, _e1733);
                                                                } else {
                                                                    phi_3660_ = type_53();
                                                                    phi_3662_ = false;
                                                                }
                                                                let _e1739 = phi_3660_;
                                                                let _e1741 = phi_3662_;
                                                                phi_3663_ = _e1739;
                                                                phi_3665_ = select(true, false, _e1546);
                                                                phi_3666_ = _e1741;
                                                            } else {
                                                                phi_3663_ = type_53();
                                                                phi_3665_ = false;
                                                                phi_3666_ = false;
                                                            }
                                                            let _e1744 = phi_3663_;
                                                            let _e1746 = phi_3665_;
                                                            let _e1748 = phi_3666_;
                                                            phi_3667_ = _e1744;
                                                            phi_3668_ = select(true, false, _e1545);
                                                            phi_3669_ = _e1746;
                                                            phi_3670_ = _e1748;
                                                        } else {
                                                            phi_3667_ = type_53();
                                                            phi_3668_ = true;
                                                            phi_3669_ = false;
                                                            phi_3670_ = false;
                                                        }
                                                        let _e1751 = phi_3667_;
                                                        let _e1753 = phi_3668_;
                                                        let _e1755 = phi_3669_;
                                                        let _e1757 = phi_3670_;
                                                        if select(select(_e1757, false, _e1753), true, select(_e1755, true, _e1753)) {
                                                            phi_3683_ = type_53(_e1004.member_3, 4294967295u, 0f, 0f);
                                                        } else {
                                                            phi_3683_ = _e1751;
                                                        }
                                                        let _e1762 = phi_3683_;
                                                        phi_3690_ = select(true, false, (_e1762.member_1 != 4294967295u));
                                                    } else {
                                                        phi_3690_ = false;
                                                    }
                                                    let _e1767 = phi_3690_;
                                                    continue;
                                                    continuing {
                                                        phi_3006_ = _e1163;
                                                        phi_5184_ = _e1138;
                                                        phi_3849_ = select(true, false, _e1169);
                                                        break if !(_e1767);
                                                    }
                                                }
                                                let _e1771 = phi_5184_;
                                                let _e1773 = phi_3849_;
                                                phi_5293_ = _e1771;
                                                phi_3850_ = bool();
                                                if _e1771 {
                                                    break;
                                                }
                                                phi_5295_ = _e1771;
                                                phi_3695_ = _e1142;
                                                phi_3696_ = _e1773;
                                            }
                                            let _e2011 = phi_5295_;
                                            let _e2013 = phi_3695_;
                                            let _e2015 = phi_3696_;
                                            if _e2015 {
                                                let _e2016 = (_e2013 == 0u);
                                                if _e2016 {
                                                    phi_3712_ = u32();
                                                    phi_3713_ = u32();
                                                } else {
                                                    let _e2017 = (_e2013 - 1u);
                                                    if (_e2017 < 64u) {
                                                    } else {
                                                        phi_5293_ = true;
                                                        phi_3850_ = bool();
                                                        break;
                                                    }
                                                    let _e2020 = local[_e2017];
                                                    phi_3712_ = _e2020;
                                                    phi_3713_ = _e2017;
                                                }
                                                let _e2022 = phi_3712_;
                                                let _e2024 = phi_3713_;
                                                phi_2577_ = _e2022;
                                                phi_2580_ = _e2024;
                                                phi_3715_ = select(true, false, _e2016);
                                                phi_3716_ = _e2016;
                                            } else {
                                                phi_2577_ = u32();
                                                phi_2580_ = u32();
                                                phi_3715_ = false;
                                                phi_3716_ = false;
                                            }
                                            let _e2027 = phi_2577_;
                                            let _e2029 = phi_2580_;
                                            let _e2031 = phi_3715_;
                                            let _e2033 = phi_3716_;
                                            continue;
                                            continuing {
                                                phi_5188_ = _e2011;
                                                phi_2576_ = _e2027;
                                                phi_2579_ = _e2029;
                                                phi_5293_ = _e2011;
                                                phi_3850_ = _e2033;
                                                break if !(_e2031);
                                            }
                                        }
                                        let _e2036 = phi_5293_;
                                        let _e2038 = phi_3850_;
                                        phi_5353_ = _e2036;
                                        if _e2036 {
                                            break;
                                        }
                                        if select(false, true, select(true, false, _e2038)) {
                                            phi_3729_ = _e422;
                                        } else {
                                            phi_3729_ = (_e422 + _e1005);
                                        }
                                        let _e2043 = phi_3729_;
                                        phi_5355_ = _e2036;
                                        phi_3730_ = _e2043;
                                    } else {
                                        phi_5355_ = _e416;
                                        phi_3730_ = _e422;
                                    }
                                    let _e2045 = phi_5355_;
                                    let _e2047 = phi_3730_;
                                    phi_5354_ = _e2045;
                                    phi_1646_ = select(_e1006, _e420, (_e420 < _e1006));
                                    phi_1648_ = _e2047;
                                    phi_1650_ = (_e424 + _e1005);
                                } else {
                                    phi_5354_ = _e416;
                                    phi_1646_ = f32();
                                    phi_1648_ = f32();
                                    phi_1650_ = f32();
                                }
                                let _e2049 = phi_5354_;
                                let _e2051 = phi_1646_;
                                let _e2053 = phi_1648_;
                                let _e2055 = phi_1650_;
                                continue;
                                continuing {
                                    phi_5210_ = _e2049;
                                    phi_1642_ = _e437;
                                    phi_1645_ = _e2051;
                                    phi_1647_ = _e2053;
                                    phi_1649_ = _e2055;
                                    phi_5353_ = _e2049;
                                    break if !(_e443);
                                }
                            }
                            let _e2058 = phi_5353_;
                            phi_5359_ = _e2058;
                            if _e2058 {
                                break;
                            }
                            let _e2060 = local_5;
                            if (_e2060 <= 0f) {
                                phi_3797_ = vec3<f32>(0f, 0f, 0f);
                            } else {
                                if (_e401.member_1 == 4294967295u) {
                                    let _e2064 = local_6;
                                    phi_3743_ = ((3.1415927f * _e2064) / f32(_e413));
                                } else {
                                    let _e3073 = local_14;
                                    phi_3743_ = _e3073;
                                }
                                let _e2069 = phi_3743_;
                                if _e409 {
                                    if (_e413 == 1u) {
                                        phi_3778_ = f32();
                                        phi_3779_ = true;
                                    } else {
                                        let _e2073 = local_7;
                                        let _e2075 = (_e401.member_3 < (0.01f * _e2073));
                                        if _e2075 {
                                            phi_3777_ = f32();
                                        } else {
                                            let _e2091 = (_e401.member[0] - _e144.member[0]);
                                            let _e2092 = (_e401.member[1] - _e144.member[1]);
                                            let _e2093 = (_e401.member[2] - _e144.member[2]);
                                            let _e2094 = (vec3<f32>(_e401.member[0], _e401.member[1], _e401.member[2]) - _e171);
                                            let _e2095 = (_e401.member_2[0] - _e144.member[0]);
                                            let _e2096 = (_e401.member_2[1] - _e144.member[1]);
                                            let _e2097 = (_e401.member_2[2] - _e144.member[2]);
                                            let _e2098 = (vec3<f32>(_e401.member_2[0], _e401.member_2[1], _e401.member_2[2]) - _e171);
                                            let _e2099 = (_e401.member_4[0] - _e144.member[0]);
                                            let _e2100 = (_e401.member_4[1] - _e144.member[1]);
                                            let _e2101 = (_e401.member_4[2] - _e144.member[2]);
                                            let _e2102 = (vec3<f32>(_e401.member_4[0], _e401.member_4[1], _e401.member_4[2]) - _e171);
                                            let _e2110 = (((_e166.x * _e2091) + (_e166.y * _e2092)) + (_e166.z * _e2093));
                                            let _e2115 = (((_e166.x * _e2095) + (_e166.y * _e2096)) + (_e166.z * _e2097));
                                            let _e2120 = (((_e166.x * _e2099) + (_e166.y * _e2100)) + (_e166.z * _e2101));
                                            let _e2121 = (_e2110 <= 0f);
                                            if _e2121 {
                                                phi_4192_ = select(true, false, (_e2115 <= 0f));
                                            } else {
                                                phi_4192_ = true;
                                            }
                                            let _e2125 = phi_4192_;
                                            if _e2125 {
                                                if _e2121 {
                                                    phi_4203_ = true;
                                                } else {
                                                    phi_4203_ = (_e2115 <= 0f);
                                                }
                                                let _e2128 = phi_4203_;
                                                if _e2128 {
                                                    let _e2133 = (_e2110 / (_e2110 - _e2115));
                                                    let _e2140 = vec3<f32>((_e2091 + ((_e2095 - _e2091) * _e2133)), (_e2092 + ((_e2096 - _e2092) * _e2133)), (_e2093 + ((_e2097 - _e2093) * _e2133)));
                                                    if _e2121 {
                                                        phi_4224_ = type_61(0f, vec3<f32>(0f, 0f, 0f), _e2140);
                                                    } else {
                                                        phi_4224_ = type_61(0f, _e2140, vec3<f32>(0f, 0f, 0f));
                                                    }
                                                    let _e2144 = phi_4224_;
                                                    let _e2145 = vec3(_e2121);
                                                    phi_4228_ = _e2144;
                                                    phi_4229_ = select(_e2140, _e2098, _e2145);
                                                    phi_4230_ = select(_e2094, _e2140, _e2145);
                                                } else {
                                                    phi_4228_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                    phi_4229_ = _e2098;
                                                    phi_4230_ = _e2094;
                                                }
                                                let _e2149 = phi_4228_;
                                                let _e2151 = phi_4229_;
                                                let _e2153 = phi_4230_;
                                                let _e2155 = abs(_e2153.x);
                                                let _e2157 = abs(_e2153.y);
                                                let _e2159 = select(_e2157, _e2155, (_e2155 > _e2157));
                                                let _e2161 = abs(_e2153.z);
                                                let _e2163 = select(_e2161, _e2159, (_e2159 > _e2161));
                                                if (_e2163 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2165 = (_e2163 < 340282350000000000000000000000000000000f);
                                                    if _e2165 {
                                                        let _e2166 = (_e2153.x / _e2163);
                                                        let _e2167 = (_e2153.y / _e2163);
                                                        let _e2168 = (_e2153.z / _e2163);
                                                        let _e2174 = sqrt((((_e2166 * _e2166) + (_e2167 * _e2167)) + (_e2168 * _e2168)));
                                                        phi_4270_ = vec3<f32>((_e2166 / _e2174), (_e2167 / _e2174), (_e2168 / _e2174));
                                                    } else {
                                                        phi_4270_ = vec3<f32>();
                                                    }
                                                    let _e2180 = phi_4270_;
                                                    phi_4273_ = _e2180;
                                                    phi_4274_ = select(true, false, _e2165);
                                                } else {
                                                    phi_4273_ = vec3<f32>();
                                                    phi_4274_ = true;
                                                }
                                                let _e2183 = phi_4273_;
                                                let _e2185 = phi_4274_;
                                                let _e2187 = select(_e2183, vec3<f32>(0f, 0f, 0f), vec3(_e2185));
                                                let _e2189 = abs(_e2151.x);
                                                let _e2191 = abs(_e2151.y);
                                                let _e2193 = select(_e2191, _e2189, (_e2189 > _e2191));
                                                let _e2195 = abs(_e2151.z);
                                                let _e2197 = select(_e2195, _e2193, (_e2193 > _e2195));
                                                if (_e2197 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2199 = (_e2197 < 340282350000000000000000000000000000000f);
                                                    if _e2199 {
                                                        let _e2200 = (_e2151.x / _e2197);
                                                        let _e2201 = (_e2151.y / _e2197);
                                                        let _e2202 = (_e2151.z / _e2197);
                                                        let _e2208 = sqrt((((_e2200 * _e2200) + (_e2201 * _e2201)) + (_e2202 * _e2202)));
                                                        phi_4318_ = vec3<f32>((_e2200 / _e2208), (_e2201 / _e2208), (_e2202 / _e2208));
                                                    } else {
                                                        phi_4318_ = vec3<f32>();
                                                    }
                                                    let _e2214 = phi_4318_;
                                                    phi_4321_ = _e2214;
                                                    phi_4322_ = select(true, false, _e2199);
                                                } else {
                                                    phi_4321_ = vec3<f32>();
                                                    phi_4322_ = true;
                                                }
                                                let _e2217 = phi_4321_;
                                                let _e2219 = phi_4322_;
                                                let _e2221 = select(_e2217, vec3<f32>(0f, 0f, 0f), vec3(_e2219));
                                                let _e2228 = ((_e2187.y * _e2221.z) - (_e2221.y * _e2187.z));
                                                let _e2233 = ((_e2187.z * _e2221.x) - (_e2221.z * _e2187.x));
                                                let _e2236 = ((_e2187.x * _e2221.y) - (_e2221.x * _e2187.y));
                                                let _e2242 = sqrt((((_e2228 * _e2228) + (_e2233 * _e2233)) + (_e2236 * _e2236)));
                                                if (_e2242 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4436_ = 0f;
                                                } else {
                                                    let _e2254 = (((_e2187.x * _e2221.x) + (_e2187.y * _e2221.y)) + (_e2187.z * _e2221.z));
                                                    let _e2255 = abs(_e2254);
                                                    let _e2256 = abs(_e2242);
                                                    let _e2257 = (_e2256 > _e2255);
                                                    let _e2258 = select(_e2255, _e2256, _e2257);
                                                    if (_e2258 > 0f) {
                                                        phi_4389_ = (select(_e2256, _e2255, _e2257) / _e2258);
                                                    } else {
                                                        phi_4389_ = 0f;
                                                    }
                                                    let _e2263 = phi_4389_;
                                                    let _e2264 = (_e2263 > 0.41421357f);
                                                    if _e2264 {
                                                        phi_4397_ = ((_e2263 - 1f) / (_e2263 + 1f));
                                                    } else {
                                                        phi_4397_ = _e2263;
                                                    }
                                                    let _e2269 = phi_4397_;
                                                    let _e2270 = (_e2269 * _e2269);
                                                    let _e2279 = (_e2269 + ((_e2269 * _e2270) * (-0.3333295f + (_e2270 * (0.19977711f + (_e2270 * (-0.13877685f + (_e2270 * 0.080537446f))))))));
                                                    if _e2264 {
                                                        phi_4412_ = (_e2279 + 0.7853982f);
                                                    } else {
                                                        phi_4412_ = _e2279;
                                                    }
                                                    let _e2282 = phi_4412_;
                                                    if _e2257 {
                                                        phi_4418_ = (1.5707964f - _e2282);
                                                    } else {
                                                        phi_4418_ = _e2282;
                                                    }
                                                    let _e2285 = phi_4418_;
                                                    if ((bitcast<u32>(_e2254) & 2147483648u) == 0u) {
                                                        phi_4426_ = _e2285;
                                                    } else {
                                                        phi_4426_ = (3.1415927f - _e2285);
                                                    }
                                                    let _e2291 = phi_4426_;
                                                    phi_4436_ = (((((_e166.x * _e2228) + (_e166.y * _e2233)) + (_e166.z * _e2236)) / _e2242) * bitcast<f32>(((bitcast<u32>(_e2291) & 2147483647u) | (bitcast<u32>(_e2242) & 2147483648u))));
                                                }
                                                let _e2300 = phi_4436_;
                                                phi_4441_ = type_61((_e2149.member + _e2300), _e2149.member_1, _e2149.member_2);
                                            } else {
                                                phi_4441_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                            }
                                            let _e2308 = phi_4441_;
                                            let _e2309 = (_e2115 <= 0f);
                                            if _e2309 {
                                                phi_4451_ = select(true, false, (_e2120 <= 0f));
                                            } else {
                                                phi_4451_ = true;
                                            }
                                            let _e2313 = phi_4451_;
                                            if _e2313 {
                                                if _e2309 {
                                                    phi_4462_ = true;
                                                } else {
                                                    phi_4462_ = (_e2120 <= 0f);
                                                }
                                                let _e2316 = phi_4462_;
                                                if _e2316 {
                                                    let _e2321 = (_e2115 / (_e2115 - _e2120));
                                                    let _e2328 = vec3<f32>((_e2095 + ((_e2099 - _e2095) * _e2321)), (_e2096 + ((_e2100 - _e2096) * _e2321)), (_e2097 + ((_e2101 - _e2097) * _e2321)));
                                                    if _e2309 {
                                                        phi_4483_ = type_61(_e2308.member, _e2308.member_1, _e2328);
                                                    } else {
                                                        phi_4483_ = type_61(_e2308.member, _e2328, _e2308.member_2);
                                                    }
                                                    let _e2338 = phi_4483_;
                                                    let _e2339 = vec3(_e2309);
                                                    phi_4487_ = _e2338;
                                                    phi_4488_ = select(_e2328, _e2102, _e2339);
                                                    phi_4489_ = select(_e2098, _e2328, _e2339);
                                                } else {
                                                    phi_4487_ = _e2308;
                                                    phi_4488_ = _e2102;
                                                    phi_4489_ = _e2098;
                                                }
                                                let _e2343 = phi_4487_;
                                                let _e2345 = phi_4488_;
                                                let _e2347 = phi_4489_;
                                                let _e2349 = abs(_e2347.x);
                                                let _e2351 = abs(_e2347.y);
                                                let _e2353 = select(_e2351, _e2349, (_e2349 > _e2351));
                                                let _e2355 = abs(_e2347.z);
                                                let _e2357 = select(_e2355, _e2353, (_e2353 > _e2355));
                                                if (_e2357 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2359 = (_e2357 < 340282350000000000000000000000000000000f);
                                                    if _e2359 {
                                                        let _e2360 = (_e2347.x / _e2357);
                                                        let _e2361 = (_e2347.y / _e2357);
                                                        let _e2362 = (_e2347.z / _e2357);
                                                        let _e2368 = sqrt((((_e2360 * _e2360) + (_e2361 * _e2361)) + (_e2362 * _e2362)));
                                                        phi_4529_ = vec3<f32>((_e2360 / _e2368), (_e2361 / _e2368), (_e2362 / _e2368));
                                                    } else {
                                                        phi_4529_ = vec3<f32>();
                                                    }
                                                    let _e2374 = phi_4529_;
                                                    phi_4532_ = _e2374;
                                                    phi_4533_ = select(true, false, _e2359);
                                                } else {
                                                    phi_4532_ = vec3<f32>();
                                                    phi_4533_ = true;
                                                }
                                                let _e2377 = phi_4532_;
                                                let _e2379 = phi_4533_;
                                                let _e2381 = select(_e2377, vec3<f32>(0f, 0f, 0f), vec3(_e2379));
                                                let _e2383 = abs(_e2345.x);
                                                let _e2385 = abs(_e2345.y);
                                                let _e2387 = select(_e2385, _e2383, (_e2383 > _e2385));
                                                let _e2389 = abs(_e2345.z);
                                                let _e2391 = select(_e2389, _e2387, (_e2387 > _e2389));
                                                if (_e2391 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2393 = (_e2391 < 340282350000000000000000000000000000000f);
                                                    if _e2393 {
                                                        let _e2394 = (_e2345.x / _e2391);
                                                        let _e2395 = (_e2345.y / _e2391);
                                                        let _e2396 = (_e2345.z / _e2391);
                                                        let _e2402 = sqrt((((_e2394 * _e2394) + (_e2395 * _e2395)) + (_e2396 * _e2396)));
                                                        phi_4577_ = vec3<f32>((_e2394 / _e2402), (_e2395 / _e2402), (_e2396 / _e2402));
                                                    } else {
                                                        phi_4577_ = vec3<f32>();
                                                    }
                                                    let _e2408 = phi_4577_;
                                                    phi_4580_ = _e2408;
                                                    phi_4581_ = select(true, false, _e2393);
                                                } else {
                                                    phi_4580_ = vec3<f32>();
                                                    phi_4581_ = true;
                                                }
                                                let _e2411 = phi_4580_;
                                                let _e2413 = phi_4581_;
                                                let _e2415 = select(_e2411, vec3<f32>(0f, 0f, 0f), vec3(_e2413));
                                                let _e2422 = ((_e2381.y * _e2415.z) - (_e2415.y * _e2381.z));
                                                let _e2427 = ((_e2381.z * _e2415.x) - (_e2415.z * _e2381.x));
                                                let _e2430 = ((_e2381.x * _e2415.y) - (_e2415.x * _e2381.y));
                                                let _e2436 = sqrt((((_e2422 * _e2422) + (_e2427 * _e2427)) + (_e2430 * _e2430)));
                                                if (_e2436 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4695_ = 0f;
                                                } else {
                                                    let _e2448 = (((_e2381.x * _e2415.x) + (_e2381.y * _e2415.y)) + (_e2381.z * _e2415.z));
                                                    let _e2449 = abs(_e2448);
                                                    let _e2450 = abs(_e2436);
                                                    let _e2451 = (_e2450 > _e2449);
                                                    let _e2452 = select(_e2449, _e2450, _e2451);
                                                    if (_e2452 > 0f) {
                                                        phi_4648_ = (select(_e2450, _e2449, _e2451) / _e2452);
                                                    } else {
                                                        phi_4648_ = 0f;
                                                    }
                                                    let _e2457 = phi_4648_;
                                                    let _e2458 = (_e2457 > 0.41421357f);
                                                    if _e2458 {
                                                        phi_4656_ = ((_e2457 - 1f) / (_e2457 + 1f));
                                                    } else {
                                                        phi_4656_ = _e2457;
                                                    }
                                                    let _e2463 = phi_4656_;
                                                    let _e2464 = (_e2463 * _e2463);
                                                    let _e2473 = (_e2463 + ((_e2463 * _e2464) * (-0.3333295f + (_e2464 * (0.19977711f + (_e2464 * (-0.13877685f + (_e2464 * 0.080537446f))))))));
                                                    if _e2458 {
                                                        phi_4671_ = (_e2473 + 0.7853982f);
                                                    } else {
                                                        phi_4671_ = _e2473;
                                                    }
                                                    let _e2476 = phi_4671_;
                                                    if _e2451 {
                                                        phi_4677_ = (1.5707964f - _e2476);
                                                    } else {
                                                        phi_4677_ = _e2476;
                                                    }
                                                    let _e2479 = phi_4677_;
                                                    if ((bitcast<u32>(_e2448) & 2147483648u) == 0u) {
                                                        phi_4685_ = _e2479;
                                                    } else {
                                                        phi_4685_ = (3.1415927f - _e2479);
                                                    }
                                                    let _e2485 = phi_4685_;
                                                    phi_4695_ = (((((_e166.x * _e2422) + (_e166.y * _e2427)) + (_e166.z * _e2430)) / _e2436) * bitcast<f32>(((bitcast<u32>(_e2485) & 2147483647u) | (bitcast<u32>(_e2436) & 2147483648u))));
                                                }
                                                let _e2494 = phi_4695_;
                                                phi_4700_ = type_61((_e2343.member + _e2494), _e2343.member_1, _e2343.member_2);
                                            } else {
                                                phi_4700_ = _e2308;
                                            }
                                            let _e2502 = phi_4700_;
                                            let _e2503 = (_e2120 <= 0f);
                                            if _e2503 {
                                                phi_4710_ = select(true, false, _e2121);
                                            } else {
                                                phi_4710_ = true;
                                            }
                                            let _e2506 = phi_4710_;
                                            if _e2506 {
                                                if select(_e2121, true, _e2503) {
                                                    let _e2512 = (_e2120 / (_e2120 - _e2110));
                                                    let _e2519 = vec3<f32>((_e2099 + ((_e2091 - _e2099) * _e2512)), (_e2100 + ((_e2092 - _e2100) * _e2512)), (_e2101 + ((_e2093 - _e2101) * _e2512)));
                                                    if _e2503 {
                                                        phi_4742_ = type_61(_e2502.member, _e2502.member_1, _e2519);
                                                    } else {
                                                        phi_4742_ = type_61(_e2502.member, _e2519, _e2502.member_2);
                                                    }
                                                    let _e2529 = phi_4742_;
                                                    let _e2530 = vec3(_e2503);
                                                    phi_4746_ = _e2529;
                                                    phi_4747_ = select(_e2519, _e2094, _e2530);
                                                    phi_4748_ = select(_e2102, _e2519, _e2530);
                                                } else {
                                                    phi_4746_ = _e2502;
                                                    phi_4747_ = _e2094;
                                                    phi_4748_ = _e2102;
                                                }
                                                let _e2534 = phi_4746_;
                                                let _e2536 = phi_4747_;
                                                let _e2538 = phi_4748_;
                                                let _e2540 = abs(_e2538.x);
                                                let _e2542 = abs(_e2538.y);
                                                let _e2544 = select(_e2542, _e2540, (_e2540 > _e2542));
                                                let _e2546 = abs(_e2538.z);
                                                let _e2548 = select(_e2546, _e2544, (_e2544 > _e2546));
                                                if (_e2548 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2550 = (_e2548 < 340282350000000000000000000000000000000f);
                                                    if _e2550 {
                                                        let _e2551 = (_e2538.x / _e2548);
                                                        let _e2552 = (_e2538.y / _e2548);
                                                        let _e2553 = (_e2538.z / _e2548);
                                                        let _e2559 = sqrt((((_e2551 * _e2551) + (_e2552 * _e2552)) + (_e2553 * _e2553)));
                                                        phi_4788_ = vec3<f32>((_e2551 / _e2559), (_e2552 / _e2559), (_e2553 / _e2559));
                                                    } else {
                                                        phi_4788_ = vec3<f32>();
                                                    }
                                                    let _e2565 = phi_4788_;
                                                    phi_4791_ = _e2565;
                                                    phi_4792_ = select(true, false, _e2550);
                                                } else {
                                                    phi_4791_ = vec3<f32>();
                                                    phi_4792_ = true;
                                                }
                                                let _e2568 = phi_4791_;
                                                let _e2570 = phi_4792_;
                                                let _e2572 = select(_e2568, vec3<f32>(0f, 0f, 0f), vec3(_e2570));
                                                let _e2574 = abs(_e2536.x);
                                                let _e2576 = abs(_e2536.y);
                                                let _e2578 = select(_e2576, _e2574, (_e2574 > _e2576));
                                                let _e2580 = abs(_e2536.z);
                                                let _e2582 = select(_e2580, _e2578, (_e2578 > _e2580));
                                                if (_e2582 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2584 = (_e2582 < 340282350000000000000000000000000000000f);
                                                    if _e2584 {
                                                        let _e2585 = (_e2536.x / _e2582);
                                                        let _e2586 = (_e2536.y / _e2582);
                                                        let _e2587 = (_e2536.z / _e2582);
                                                        let _e2593 = sqrt((((_e2585 * _e2585) + (_e2586 * _e2586)) + (_e2587 * _e2587)));
                                                        phi_4836_ = vec3<f32>((_e2585 / _e2593), (_e2586 / _e2593), (_e2587 / _e2593));
                                                    } else {
                                                        phi_4836_ = vec3<f32>();
                                                    }
                                                    let _e2599 = phi_4836_;
                                                    phi_4839_ = _e2599;
                                                    phi_4840_ = select(true, false, _e2584);
                                                } else {
                                                    phi_4839_ = vec3<f32>();
                                                    phi_4840_ = true;
                                                }
                                                let _e2602 = phi_4839_;
                                                let _e2604 = phi_4840_;
                                                let _e2606 = select(_e2602, vec3<f32>(0f, 0f, 0f), vec3(_e2604));
                                                let _e2613 = ((_e2572.y * _e2606.z) - (_e2606.y * _e2572.z));
                                                let _e2618 = ((_e2572.z * _e2606.x) - (_e2606.z * _e2572.x));
                                                let _e2621 = ((_e2572.x * _e2606.y) - (_e2606.x * _e2572.y));
                                                let _e2627 = sqrt((((_e2613 * _e2613) + (_e2618 * _e2618)) + (_e2621 * _e2621)));
                                                if (_e2627 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4954_ = 0f;
                                                } else {
                                                    let _e2639 = (((_e2572.x * _e2606.x) + (_e2572.y * _e2606.y)) + (_e2572.z * _e2606.z));
                                                    let _e2640 = abs(_e2639);
                                                    let _e2641 = abs(_e2627);
                                                    let _e2642 = (_e2641 > _e2640);
                                                    let _e2643 = select(_e2640, _e2641, _e2642);
                                                    if (_e2643 > 0f) {
                                                        phi_4907_ = (select(_e2641, _e2640, _e2642) / _e2643);
                                                    } else {
                                                        phi_4907_ = 0f;
                                                    }
                                                    let _e2648 = phi_4907_;
                                                    let _e2649 = (_e2648 > 0.41421357f);
                                                    if _e2649 {
                                                        phi_4915_ = ((_e2648 - 1f) / (_e2648 + 1f));
                                                    } else {
                                                        phi_4915_ = _e2648;
                                                    }
                                                    let _e2654 = phi_4915_;
                                                    let _e2655 = (_e2654 * _e2654);
                                                    let _e2664 = (_e2654 + ((_e2654 * _e2655) * (-0.3333295f + (_e2655 * (0.19977711f + (_e2655 * (-0.13877685f + (_e2655 * 0.080537446f))))))));
                                                    if _e2649 {
                                                        phi_4930_ = (_e2664 + 0.7853982f);
                                                    } else {
                                                        phi_4930_ = _e2664;
                                                    }
                                                    let _e2667 = phi_4930_;
                                                    if _e2642 {
                                                        phi_4936_ = (1.5707964f - _e2667);
                                                    } else {
                                                        phi_4936_ = _e2667;
                                                    }
                                                    let _e2670 = phi_4936_;
                                                    if ((bitcast<u32>(_e2639) & 2147483648u) == 0u) {
                                                        phi_4944_ = _e2670;
                                                    } else {
                                                        phi_4944_ = (3.1415927f - _e2670);
                                                    }
                                                    let _e2676 = phi_4944_;
                                                    phi_4954_ = (((((_e166.x * _e2613) + (_e166.y * _e2618)) + (_e166.z * _e2621)) / _e2627) * bitcast<f32>(((bitcast<u32>(_e2676) & 2147483647u) | (bitcast<u32>(_e2627) & 2147483648u))));
                                                }
                                                let _e2685 = phi_4954_;
                                                phi_4959_ = type_61((_e2534.member + _e2685), _e2534.member_1, _e2534.member_2);
                                            } else {
                                                phi_4959_ = _e2502;
                                            }
                                            let _e2693 = phi_4959_;
                                            let _e2697 = abs(_e2693.member_1.x);
                                            let _e2699 = abs(_e2693.member_1.y);
                                            let _e2701 = select(_e2699, _e2697, (_e2697 > _e2699));
                                            let _e2703 = abs(_e2693.member_1.z);
                                            let _e2705 = select(_e2703, _e2701, (_e2701 > _e2703));
                                            if (_e2705 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e2707 = (_e2705 < 340282350000000000000000000000000000000f);
                                                if _e2707 {
                                                    let _e2708 = (_e2693.member_1.x / _e2705);
                                                    let _e2709 = (_e2693.member_1.y / _e2705);
                                                    let _e2710 = (_e2693.member_1.z / _e2705);
                                                    let _e2716 = sqrt((((_e2708 * _e2708) + (_e2709 * _e2709)) + (_e2710 * _e2710)));
                                                    phi_5001_ = vec3<f32>((_e2708 / _e2716), (_e2709 / _e2716), (_e2710 / _e2716));
                                                } else {
                                                    phi_5001_ = vec3<f32>();
                                                }
                                                let _e2722 = phi_5001_;
                                                phi_5004_ = _e2722;
                                                phi_5005_ = select(true, false, _e2707);
                                            } else {
                                                phi_5004_ = vec3<f32>();
                                                phi_5005_ = true;
                                            }
                                            let _e2725 = phi_5004_;
                                            let _e2727 = phi_5005_;
                                            let _e2729 = select(_e2725, vec3<f32>(0f, 0f, 0f), vec3(_e2727));
                                            let _e2731 = abs(_e2693.member_2.x);
                                            let _e2733 = abs(_e2693.member_2.y);
                                            let _e2735 = select(_e2733, _e2731, (_e2731 > _e2733));
                                            let _e2737 = abs(_e2693.member_2.z);
                                            let _e2739 = select(_e2737, _e2735, (_e2735 > _e2737));
                                            if (_e2739 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e2741 = (_e2739 < 340282350000000000000000000000000000000f);
                                                if _e2741 {
                                                    let _e2742 = (_e2693.member_2.x / _e2739);
                                                    let _e2743 = (_e2693.member_2.y / _e2739);
                                                    let _e2744 = (_e2693.member_2.z / _e2739);
                                                    let _e2750 = sqrt((((_e2742 * _e2742) + (_e2743 * _e2743)) + (_e2744 * _e2744)));
                                                    phi_5049_ = vec3<f32>((_e2742 / _e2750), (_e2743 / _e2750), (_e2744 / _e2750));
                                                } else {
                                                    phi_5049_ = vec3<f32>();
                                                }
                                                let _e2756 = phi_5049_;
                                                phi_5052_ = _e2756;
                                                phi_5053_ = select(true, false, _e2741);
                                            } else {
                                                phi_5052_ = vec3<f32>();
                                                phi_5053_ = true;
                                            }
                                            let _e2759 = phi_5052_;
                                            let _e2761 = phi_5053_;
                                            let _e2763 = select(_e2759, vec3<f32>(0f, 0f, 0f), vec3(_e2761));
                                            let _e2770 = ((_e2729.y * _e2763.z) - (_e2763.y * _e2729.z));
                                            let _e2775 = ((_e2729.z * _e2763.x) - (_e2763.z * _e2729.x));
                                            let _e2778 = ((_e2729.x * _e2763.y) - (_e2763.x * _e2729.y));
                                            let _e2784 = sqrt((((_e2770 * _e2770) + (_e2775 * _e2775)) + (_e2778 * _e2778)));
                                            if (_e2784 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5167_ = 0f;
                                            } else {
                                                let _e2796 = (((_e2729.x * _e2763.x) + (_e2729.y * _e2763.y)) + (_e2729.z * _e2763.z));
                                                let _e2797 = abs(_e2796);
                                                let _e2798 = abs(_e2784);
                                                let _e2799 = (_e2798 > _e2797);
                                                let _e2800 = select(_e2797, _e2798, _e2799);
                                                if (_e2800 > 0f) {
                                                    phi_5120_ = (select(_e2798, _e2797, _e2799) / _e2800);
                                                } else {
                                                    phi_5120_ = 0f;
                                                }
                                                let _e2805 = phi_5120_;
                                                let _e2806 = (_e2805 > 0.41421357f);
                                                if _e2806 {
                                                    phi_5128_ = ((_e2805 - 1f) / (_e2805 + 1f));
                                                } else {
                                                    phi_5128_ = _e2805;
                                                }
                                                let _e2811 = phi_5128_;
                                                let _e2812 = (_e2811 * _e2811);
                                                let _e2821 = (_e2811 + ((_e2811 * _e2812) * (-0.3333295f + (_e2812 * (0.19977711f + (_e2812 * (-0.13877685f + (_e2812 * 0.080537446f))))))));
                                                if _e2806 {
                                                    phi_5143_ = (_e2821 + 0.7853982f);
                                                } else {
                                                    phi_5143_ = _e2821;
                                                }
                                                let _e2824 = phi_5143_;
                                                if _e2799 {
                                                    phi_5149_ = (1.5707964f - _e2824);
                                                } else {
                                                    phi_5149_ = _e2824;
                                                }
                                                let _e2827 = phi_5149_;
                                                if ((bitcast<u32>(_e2796) & 2147483648u) == 0u) {
                                                    phi_5157_ = _e2827;
                                                } else {
                                                    phi_5157_ = (3.1415927f - _e2827);
                                                }
                                                let _e2833 = phi_5157_;
                                                phi_5167_ = (((((_e166.x * _e2770) + (_e166.y * _e2775)) + (_e166.z * _e2778)) / _e2784) * bitcast<f32>(((bitcast<u32>(_e2833) & 2147483647u) | (bitcast<u32>(_e2784) & 2147483648u))));
                                            }
                                            let _e2842 = phi_5167_;
                                            let _e2848 = local_8;
                                            let _e2850 = local_9;
                                            phi_3777_ = ((abs((_e2693.member + _e2842)) * 0.5f) * (_e2848 / _e2850));
                                        }
                                        let _e2854 = phi_3777_;
                                        phi_3778_ = _e2854;
                                        phi_3779_ = _e2075;
                                    }
                                    let _e2856 = phi_3778_;
                                    let _e2858 = phi_3779_;
                                    if _e2858 {
                                        let _e2861 = local_10;
                                        phi_3787_ = ((_e2861 * _e401.member_3) / f32(_e413));
                                    } else {
                                        phi_3787_ = _e2856;
                                    }
                                    let _e2866 = phi_3787_;
                                    phi_3788_ = _e2866;
                                } else {
                                    phi_3788_ = _e2069;
                                }
                                let _e2868 = phi_3788_;
                                phi_3797_ = vec3<f32>((_e401.member_6[0] * _e2868), (_e401.member_6[1] * _e2868), (_e401.member_6[2] * _e2868));
                            }
                            let _e2878 = phi_3797_;
                            phi_5361_ = _e2058;
                            phi_3813_ = vec3<f32>((_e260.x + (_e2878.x * _e406)), (_e260.y + (_e2878.y * _e406)), (_e260.z + (_e2878.z * _e406)));
                        } else {
                            phi_5361_ = _e359;
                            phi_3813_ = _e260;
                        }
                        let _e2893 = phi_5361_;
                        let _e2895 = phi_3813_;
                        phi_5360_ = _e2893;
                        phi_1460_ = _e2895;
                    } else {
                        phi_5360_ = _e256;
                        phi_1460_ = vec3<f32>();
                    }
                    let _e2897 = phi_5360_;
                    let _e2899 = phi_1460_;
                    continue;
                    continuing {
                        phi_5176_ = _e2897;
                        phi_1456_ = _e273;
                        phi_1459_ = _e2899;
                        phi_5359_ = _e2897;
                        break if !(_e279);
                    }
                }
                let _e2902 = phi_5359_;
                if _e2902 {
                    break;
                }
                let _e2904 = local_11;
                let _e2907 = local_12;
                let _e2910 = local_13;
                if _e139 {
                } else {
                    break;
                }
                out.member[_e138] = vec4<f32>(_e2904.x, _e2907.y, _e2910.z, 0f);
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
