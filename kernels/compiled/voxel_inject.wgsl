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
    var phi_5195_: bool;
    var phi_1475_: type_13;
    var phi_1478_: vec3<f32>;
    var phi_1476_: type_13;
    var phi_1501_: type_13;
    var phi_1540_: u32;
    var phi_1543_: u32;
    var phi_1567_: u32;
    var phi_1541_: u32;
    var phi_1544_: u32;
    var phi_5191_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1584_: f32;
    var phi_5236_: bool;
    var phi_1594_: type_33;
    var phi_1595_: u32;
    var phi_1596_: f32;
    var phi_5235_: bool;
    var phi_1598_: type_33;
    var phi_1599_: u32;
    var phi_1600_: f32;
    var phi_1601_: bool;
    var phi_1633_: type_33;
    var phi_1634_: u32;
    var phi_1636_: type_33;
    var phi_1637_: u32;
    var phi_1638_: u32;
    var phi_1654_: bool;
    var phi_5231_: bool;
    var phi_1661_: type_13;
    var phi_1664_: f32;
    var phi_1666_: f32;
    var phi_1668_: f32;
    var phi_1662_: type_13;
    var phi_1691_: type_13;
    var phi_2285_: f32;
    var phi_3877_: f32;
    var phi_3885_: f32;
    var phi_2043_: vec2<f32>;
    var phi_2044_: bool;
    var phi_2174_: f32;
    var phi_2182_: f32;
    var phi_2108_: f32;
    var phi_2116_: f32;
    var phi_2186_: vec2<f32>;
    var phi_2187_: vec2<f32>;
    var phi_2286_: vec3<f32>;
    var phi_2287_: f32;
    var phi_2288_: f32;
    var phi_2289_: vec3<f32>;
    var phi_2290_: f32;
    var phi_2291_: bool;
    var phi_2311_: f32;
    var phi_2323_: type_49;
    var phi_1770_: vec3<f32>;
    var phi_1772_: vec3<f32>;
    var phi_1773_: bool;
    var phi_3893_: f32;
    var phi_3901_: f32;
    var phi_1847_: vec2<f32>;
    var phi_2325_: f32;
    var phi_2326_: vec3<f32>;
    var phi_2327_: f32;
    var phi_2328_: vec3<f32>;
    var phi_2329_: type_49;
    var phi_2330_: f32;
    var phi_2331_: bool;
    var phi_2351_: f32;
    var phi_2365_: type_49;
    var phi_2398_: bool;
    var phi_2408_: u32;
    var phi_2411_: bool;
    var phi_2422_: u32;
    var phi_2575_: f32;
    var phi_2583_: f32;
    var phi_2591_: f32;
    var phi_5209_: bool;
    var phi_2595_: u32;
    var phi_2598_: u32;
    var phi_3025_: type_13;
    var phi_3026_: type_13;
    var phi_3049_: type_13;
    var phi_3165_: f32;
    var phi_3176_: f32;
    var phi_3187_: f32;
    var phi_3202_: f32;
    var phi_3203_: f32;
    var phi_3204_: bool;
    var phi_3205_: f32;
    var phi_3206_: bool;
    var phi_3225_: f32;
    var phi_3226_: bool;
    var phi_3227_: f32;
    var phi_3228_: bool;
    var phi_3229_: bool;
    var phi_3234_: f32;
    var phi_3235_: bool;
    var phi_3321_: array<f32, 3>;
    var phi_3322_: array<f32, 3>;
    var phi_3323_: array<f32, 3>;
    var phi_3324_: array<f32, 3>;
    var phi_3325_: bool;
    var phi_3326_: array<f32, 3>;
    var phi_3327_: array<f32, 3>;
    var phi_3328_: bool;
    var phi_3329_: bool;
    var phi_3334_: array<f32, 3>;
    var phi_3339_: array<f32, 3>;
    var phi_3550_: u32;
    var phi_3556_: u32;
    var phi_3586_: u32;
    var phi_3592_: u32;
    var phi_3667_: bool;
    var phi_3672_: bool;
    var phi_3677_: type_53;
    var phi_3679_: type_53;
    var phi_3681_: bool;
    var phi_3682_: type_53;
    var phi_3684_: bool;
    var phi_3685_: bool;
    var phi_3686_: type_53;
    var phi_3687_: bool;
    var phi_3688_: bool;
    var phi_3689_: bool;
    var phi_3702_: type_53;
    var phi_3709_: bool;
    var phi_5205_: bool;
    var phi_3868_: bool;
    var phi_2985_: u32;
    var phi_2997_: u32;
    var phi_3009_: u32;
    var phi_3021_: u32;
    var phi_5316_: bool;
    var phi_3714_: u32;
    var phi_3715_: bool;
    var phi_3731_: u32;
    var phi_3732_: u32;
    var phi_2596_: u32;
    var phi_2599_: u32;
    var phi_3734_: bool;
    var phi_3735_: bool;
    var phi_5314_: bool;
    var phi_3869_: bool;
    var phi_3748_: f32;
    var phi_5376_: bool;
    var phi_3749_: f32;
    var phi_5375_: bool;
    var phi_1665_: f32;
    var phi_1667_: f32;
    var phi_1669_: f32;
    var phi_5374_: bool;
    var local_5: f32;
    var local_6: f32;
    var phi_3762_: f32;
    var local_7: f32;
    var phi_4211_: bool;
    var phi_4222_: bool;
    var phi_4243_: type_61;
    var phi_4247_: type_61;
    var phi_4248_: vec3<f32>;
    var phi_4249_: vec3<f32>;
    var phi_4289_: vec3<f32>;
    var phi_4292_: vec3<f32>;
    var phi_4293_: bool;
    var phi_4337_: vec3<f32>;
    var phi_4340_: vec3<f32>;
    var phi_4341_: bool;
    var phi_4408_: f32;
    var phi_4416_: f32;
    var phi_4431_: f32;
    var phi_4437_: f32;
    var phi_4445_: f32;
    var phi_4455_: f32;
    var phi_4460_: type_61;
    var phi_4470_: bool;
    var phi_4481_: bool;
    var phi_4502_: type_61;
    var phi_4506_: type_61;
    var phi_4507_: vec3<f32>;
    var phi_4508_: vec3<f32>;
    var phi_4548_: vec3<f32>;
    var phi_4551_: vec3<f32>;
    var phi_4552_: bool;
    var phi_4596_: vec3<f32>;
    var phi_4599_: vec3<f32>;
    var phi_4600_: bool;
    var phi_4667_: f32;
    var phi_4675_: f32;
    var phi_4690_: f32;
    var phi_4696_: f32;
    var phi_4704_: f32;
    var phi_4714_: f32;
    var phi_4719_: type_61;
    var phi_4729_: bool;
    var phi_4761_: type_61;
    var phi_4765_: type_61;
    var phi_4766_: vec3<f32>;
    var phi_4767_: vec3<f32>;
    var phi_4807_: vec3<f32>;
    var phi_4810_: vec3<f32>;
    var phi_4811_: bool;
    var phi_4855_: vec3<f32>;
    var phi_4858_: vec3<f32>;
    var phi_4859_: bool;
    var phi_4926_: f32;
    var phi_4934_: f32;
    var phi_4949_: f32;
    var phi_4955_: f32;
    var phi_4963_: f32;
    var phi_4973_: f32;
    var phi_4978_: type_61;
    var phi_5020_: vec3<f32>;
    var phi_5023_: vec3<f32>;
    var phi_5024_: bool;
    var phi_5068_: vec3<f32>;
    var phi_5071_: vec3<f32>;
    var phi_5072_: bool;
    var phi_5139_: f32;
    var phi_5147_: f32;
    var phi_5162_: f32;
    var phi_5168_: f32;
    var phi_5176_: f32;
    var phi_5186_: f32;
    var local_8: f32;
    var local_9: f32;
    var phi_3796_: f32;
    var phi_3797_: f32;
    var phi_3798_: bool;
    var local_10: f32;
    var phi_3806_: f32;
    var phi_3807_: f32;
    var phi_3816_: vec3<f32>;
    var phi_5382_: bool;
    var phi_3832_: vec3<f32>;
    var phi_5381_: bool;
    var phi_1479_: vec3<f32>;
    var phi_5380_: bool;
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
                let _e189 = abs(_e144.member[0]);
                let _e190 = abs(_e144.member[1]);
                let _e192 = select(_e190, _e189, (_e189 > _e190));
                let _e193 = abs(_e144.member[2]);
                let _e197 = (((0.001f + (0.61f * sqrt(select(0.5f, _e178, (_e178 < 0.5f))))) * _e187) + (0.00000023841858f * select(_e193, _e192, (_e192 > _e193))));
                let _e201 = params.member.member_17[0u];
                let _e205 = params.member.member_17[1u];
                let _e208 = params.member.member_15;
                let _e215 = params.member.member_17[2u];
                let _e219 = params.member.member_17[3u];
                let _e223 = ((_e138 ^ (_e138 >> bitcast<u32>(16i))) * 2146121005u);
                let _e227 = ((_e223 ^ (_e223 >> bitcast<u32>(15i))) * 2221713035u);
                let _e231 = (_e219 ^ (_e227 ^ (_e227 >> bitcast<u32>(16i))));
                let _e235 = ((_e231 ^ (_e231 >> bitcast<u32>(16i))) * 2146121005u);
                let _e239 = ((_e235 ^ (_e235 >> bitcast<u32>(15i))) * 2221713035u);
                let _e242 = (_e239 ^ (_e239 >> bitcast<u32>(16i)));
                let _e243 = (_e201 > 64u);
                let _e244 = select(_e201, _e205, _e243);
                let _e251 = ((_e242 ^ (_e242 >> bitcast<u32>(16i))) * 2146121005u);
                let _e255 = ((_e251 ^ (_e251 >> bitcast<u32>(15i))) * 2221713035u);
                let _e258 = (_e255 ^ (_e255 >> bitcast<u32>(16i)));
                phi_5195_ = false;
                phi_1475_ = type_13(0u, (_e244 + select(0u, 1u, (_e215 > 0u))));
                phi_1478_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e265 = phi_5195_;
                    let _e267 = phi_1475_;
                    let _e269 = phi_1478_;
                    local_11 = _e269;
                    local_12 = _e269;
                    local_13 = _e269;
                    if (_e267.member < _e267.member_1) {
                        phi_1476_ = type_13((_e267.member + 1u), _e267.member_1);
                        phi_1501_ = type_13(1u, _e267.member);
                    } else {
                        phi_1476_ = _e267;
                        phi_1501_ = type_13(0u, type_13().member_1);
                    }
                    let _e282 = phi_1476_;
                    let _e284 = phi_1501_;
                    let _e288 = (bitcast<i32>(_e284.member) != 0i);
                    if _e288 {
                        let _e294 = ((_e258 ^ (_e258 >> bitcast<u32>(16i))) * 2146121005u);
                        let _e298 = ((_e294 ^ (_e294 >> bitcast<u32>(15i))) * 2221713035u);
                        let _e302 = (_e284.member_1 < _e244);
                        if _e302 {
                            if _e243 {
                                let _e305 = f32(_e244);
                                phi_1540_ = (_e201 - 1u);
                                phi_1543_ = 0u;
                                loop {
                                    let _e309 = phi_1540_;
                                    let _e311 = phi_1543_;
                                    local_3 = _e311;
                                    local_4 = _e311;
                                    let _e312 = (_e311 < _e309);
                                    if _e312 {
                                        let _e314 = ((_e311 + _e309) / 2u);
                                        if (_e314 < _e130) {
                                        } else {
                                            phi_5191_ = true;
                                            break;
                                        }
                                        let _e319 = lights.member[_e314].member_5;
                                        let _e320 = (_e319 > ((f32(_e284.member_1) + (f32((_e258 >> bitcast<u32>(8i))) * 0.000000059604645f)) / _e305));
                                        if _e320 {
                                            phi_1567_ = _e311;
                                        } else {
                                            phi_1567_ = (_e314 + 1u);
                                        }
                                        let _e323 = phi_1567_;
                                        phi_1541_ = select(_e309, _e314, _e320);
                                        phi_1544_ = _e323;
                                    } else {
                                        phi_1541_ = u32();
                                        phi_1544_ = u32();
                                    }
                                    let _e326 = phi_1541_;
                                    let _e328 = phi_1544_;
                                    continue;
                                    continuing {
                                        phi_1540_ = _e326;
                                        phi_1543_ = _e328;
                                        phi_5191_ = _e265;
                                        break if !(_e312);
                                    }
                                }
                                let _e331 = phi_5191_;
                                phi_5380_ = _e331;
                                if _e331 {
                                    break;
                                }
                                let _e333 = local_3;
                                if (_e333 < _e130) {
                                } else {
                                    phi_5380_ = true;
                                    break;
                                }
                                let _e337 = local_4;
                                let _e339 = lights.member[_e337];
                                if (_e339.member_7 > 0f) {
                                    phi_1584_ = (1f / (_e339.member_7 * _e305));
                                } else {
                                    phi_1584_ = 0f;
                                }
                                let _e345 = phi_1584_;
                                let _e346 = (_e242 + _e284.member_1);
                                let _e350 = ((_e346 ^ (_e346 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e354 = ((_e350 ^ (_e350 >> bitcast<u32>(15i))) * 2221713035u);
                                phi_5236_ = _e331;
                                phi_1594_ = _e339;
                                phi_1595_ = (_e354 ^ (_e354 >> bitcast<u32>(16i)));
                                phi_1596_ = _e345;
                            } else {
                                phi_5236_ = _e265;
                                phi_1594_ = type_33();
                                phi_1595_ = u32();
                                phi_1596_ = f32();
                            }
                            let _e359 = phi_5236_;
                            let _e361 = phi_1594_;
                            let _e363 = phi_1595_;
                            let _e365 = phi_1596_;
                            phi_5235_ = _e359;
                            phi_1598_ = _e361;
                            phi_1599_ = _e363;
                            phi_1600_ = _e365;
                            phi_1601_ = select(true, false, _e243);
                        } else {
                            phi_5235_ = _e265;
                            phi_1598_ = type_33();
                            phi_1599_ = u32();
                            phi_1600_ = f32();
                            phi_1601_ = true;
                        }
                        let _e368 = phi_5235_;
                        let _e370 = phi_1598_;
                        let _e372 = phi_1599_;
                        let _e374 = phi_1600_;
                        let _e376 = phi_1601_;
                        if _e376 {
                            if _e302 {
                                if (_e284.member_1 < _e130) {
                                } else {
                                    phi_5380_ = true;
                                    break;
                                }
                                let _e380 = lights.member[_e284.member_1];
                                let _e384 = ((_e284.member_1 ^ (_e284.member_1 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e388 = ((_e384 ^ (_e384 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e392 = (_e242 ^ (_e388 ^ (_e388 >> bitcast<u32>(16i))));
                                let _e396 = ((_e392 ^ (_e392 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e400 = ((_e396 ^ (_e396 >> bitcast<u32>(15i))) * 2221713035u);
                                phi_1633_ = _e380;
                                phi_1634_ = (_e400 ^ (_e400 >> bitcast<u32>(16i)));
                            } else {
                                phi_1633_ = type_33(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(_e208.x, _e208.y, _e208.z), 1f);
                                phi_1634_ = (_e298 ^ (_e298 >> bitcast<u32>(16i)));
                            }
                            let _e405 = phi_1633_;
                            let _e407 = phi_1634_;
                            phi_1636_ = _e405;
                            phi_1637_ = _e407;
                            phi_1638_ = select(_e215, _e205, _e302);
                        } else {
                            phi_1636_ = _e370;
                            phi_1637_ = _e372;
                            phi_1638_ = 1u;
                        }
                        let _e410 = phi_1636_;
                        let _e412 = phi_1637_;
                        let _e414 = phi_1638_;
                        let _e415 = select(_e374, 1f, _e376);
                        if (_e415 > 0f) {
                            let _e418 = (_e410.member_1 == 3u);
                            if _e418 {
                                phi_1654_ = true;
                            } else {
                                phi_1654_ = (_e410.member_1 == 4294967295u);
                            }
                            let _e421 = phi_1654_;
                            let _e422 = select(1u, _e414, _e421);
                            phi_5231_ = _e368;
                            phi_1661_ = type_13(0u, _e422);
                            phi_1664_ = 340282350000000000000000000000000000000f;
                            phi_1666_ = 0f;
                            phi_1668_ = 0f;
                            loop {
                                let _e425 = phi_5231_;
                                let _e427 = phi_1661_;
                                let _e429 = phi_1664_;
                                let _e431 = phi_1666_;
                                let _e433 = phi_1668_;
                                local_5 = _e431;
                                local_6 = _e431;
                                local_14 = _e431;
                                local_7 = _e429;
                                local_8 = _e431;
                                local_9 = _e433;
                                local_10 = _e431;
                                if (_e427.member < _e427.member_1) {
                                    phi_1662_ = type_13((_e427.member + 1u), _e427.member_1);
                                    phi_1691_ = type_13(1u, _e427.member);
                                } else {
                                    phi_1662_ = _e427;
                                    phi_1691_ = type_13(0u, type_13().member_1);
                                }
                                let _e446 = phi_1662_;
                                let _e448 = phi_1691_;
                                let _e452 = (bitcast<i32>(_e448.member) != 0i);
                                if _e452 {
                                    let _e462 = (_e410.member[0] - _e144.member[0]);
                                    let _e463 = (_e410.member[1] - _e144.member[1]);
                                    let _e464 = (_e410.member[2] - _e144.member[2]);
                                    if _e418 {
                                        let _e796 = (_e410.member_2[0] - _e410.member[0]);
                                        let _e797 = (_e410.member_2[1] - _e410.member[1]);
                                        let _e798 = (_e410.member_2[2] - _e410.member[2]);
                                        let _e799 = (_e410.member_4[0] - _e410.member[0]);
                                        let _e800 = (_e410.member_4[1] - _e410.member[1]);
                                        let _e801 = (_e410.member_4[2] - _e410.member[2]);
                                        let _e804 = ((_e797 * _e801) - (_e800 * _e798));
                                        let _e807 = ((_e798 * _e799) - (_e801 * _e796));
                                        let _e810 = ((_e796 * _e800) - (_e799 * _e797));
                                        let _e811 = abs(_e804);
                                        let _e812 = abs(_e807);
                                        let _e814 = select(_e812, _e811, (_e811 > _e812));
                                        let _e815 = abs(_e810);
                                        let _e817 = select(_e815, _e814, (_e814 > _e815));
                                        if (_e817 > 0.000000000000000000000000000000000000011754944f) {
                                            let _e819 = (_e817 < 340282350000000000000000000000000000000f);
                                            if _e819 {
                                                let _e820 = (_e804 / _e817);
                                                let _e821 = (_e807 / _e817);
                                                let _e822 = (_e810 / _e817);
                                                let _e828 = sqrt((((_e820 * _e820) + (_e821 * _e821)) + (_e822 * _e822)));
                                                phi_1770_ = vec3<f32>((_e820 / _e828), (_e821 / _e828), (_e822 / _e828));
                                            } else {
                                                phi_1770_ = vec3<f32>();
                                            }
                                            let _e834 = phi_1770_;
                                            phi_1772_ = _e834;
                                            phi_1773_ = select(true, false, _e819);
                                        } else {
                                            phi_1772_ = vec3<f32>();
                                            phi_1773_ = true;
                                        }
                                        let _e837 = phi_1772_;
                                        let _e839 = phi_1773_;
                                        let _e841 = select(_e837, vec3<f32>(0f, 0f, 0f), vec3(_e839));
                                        let _e852 = (((_e841.x * (_e144.member[0] - _e410.member[0])) + (_e841.y * (_e144.member[1] - _e410.member[1]))) + (_e841.z * (_e144.member[2] - _e410.member[2])));
                                        let _e858 = ((_e412 ^ (_e412 >> bitcast<u32>(16i))) * 2146121005u);
                                        let _e862 = ((_e858 ^ (_e858 >> bitcast<u32>(15i))) * 2221713035u);
                                        let _e869 = (_e412 ^ 2654435769u);
                                        let _e873 = ((_e869 ^ (_e869 >> bitcast<u32>(16i))) * 2146121005u);
                                        let _e877 = ((_e873 ^ (_e873 >> bitcast<u32>(15i))) * 2221713035u);
                                        let _e895 = (0.000000059604645f * (f32(((2147483648u + (_e448.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e862 ^ (_e862 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                        if (_e895 >= 1f) {
                                            phi_3893_ = (_e895 - 1f);
                                        } else {
                                            phi_3893_ = _e895;
                                        }
                                        let _e899 = phi_3893_;
                                        let _e901 = (0.000000059604645f * (f32(((2147483648u + (_e448.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e877 ^ (_e877 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                        if (_e901 >= 1f) {
                                            phi_3901_ = (_e901 - 1f);
                                        } else {
                                            phi_3901_ = _e901;
                                        }
                                        let _e905 = phi_3901_;
                                        if (_e899 < _e905) {
                                            let _e910 = (0.5f * _e899);
                                            phi_1847_ = vec2<f32>(_e910, (_e905 - _e910));
                                        } else {
                                            let _e907 = (0.5f * _e905);
                                            phi_1847_ = vec2<f32>((_e899 - _e907), _e907);
                                        }
                                        let _e914 = phi_1847_;
                                        let _e926 = ((_e410.member[0] + (_e796 * _e914.x)) + (_e799 * _e914.y));
                                        let _e927 = ((_e410.member[1] + (_e797 * _e914.x)) + (_e800 * _e914.y));
                                        let _e928 = ((_e410.member[2] + (_e798 * _e914.x)) + (_e801 * _e914.y));
                                        let _e929 = abs(_e926);
                                        let _e930 = abs(_e927);
                                        let _e932 = select(_e930, _e929, (_e929 > _e930));
                                        let _e933 = abs(_e928);
                                        let _e939 = ((select(_e933, _e932, (_e932 > _e933)) + sqrt(_e410.member_3)) * 0.0000009536743f);
                                        let _e943 = (_e926 + (_e841.x * _e939));
                                        let _e944 = (_e927 + (_e841.y * _e939));
                                        let _e945 = (_e928 + (_e841.z * _e939));
                                        let _e951 = (_e926 - _e144.member[0]);
                                        let _e952 = (_e927 - _e144.member[1]);
                                        let _e953 = (_e928 - _e144.member[2]);
                                        let _e958 = (((_e951 * _e951) + (_e952 * _e952)) + (_e953 * _e953));
                                        let _e966 = (((_e166.x * _e951) + (_e166.y * _e952)) + (_e166.z * _e953));
                                        let _e970 = (_e958 * _e958);
                                        phi_2325_ = ((select(0f, _e966, (_e966 > 0f)) * select(0f, _e852, (_e852 > 0f))) / select(0.000000000000000000000000000000000000011754944f, _e970, (_e970 > 0.000000000000000000000000000000000000011754944f)));
                                        phi_2326_ = vec3<f32>((_e943 - _e144.member[0]), (_e944 - _e144.member[1]), (_e945 - _e144.member[2]));
                                        phi_2327_ = _e958;
                                        phi_2328_ = vec3<f32>(_e943, _e944, _e945);
                                        phi_2329_ = type_49();
                                        phi_2330_ = f32();
                                        phi_2331_ = true;
                                    } else {
                                        if (_e410.member_1 == 2u) {
                                            let _e744 = -(_e410.member_2[0]);
                                            let _e745 = -(_e410.member_2[1]);
                                            let _e746 = -(_e410.member_2[2]);
                                            let _e755 = (((_e166.x * _e744) + (_e166.y * _e745)) + (_e166.z * _e746));
                                            phi_2288_ = select(0f, _e755, (_e755 > 0f));
                                            phi_2289_ = vec3<f32>(_e744, _e745, _e746);
                                            phi_2290_ = f32();
                                            phi_2291_ = true;
                                        } else {
                                            let _e467 = (_e410.member_1 == 4294967295u);
                                            if _e467 {
                                                let _e520 = bitcast<f32>((1065353216u | (bitcast<u32>(_e166.z) & 2147483648u)));
                                                let _e522 = (-1f / (_e520 + _e166.z));
                                                let _e526 = ((_e166.x * _e166.y) * _e522);
                                                let _e541 = ((_e412 ^ (_e412 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e545 = ((_e541 ^ (_e541 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e552 = (_e412 ^ 2654435769u);
                                                let _e556 = ((_e552 ^ (_e552 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e560 = ((_e556 ^ (_e556 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e578 = (0.000000059604645f * (f32(((2147483648u + (_e448.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e545 ^ (_e545 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e578 >= 1f) {
                                                    phi_3877_ = (_e578 - 1f);
                                                } else {
                                                    phi_3877_ = _e578;
                                                }
                                                let _e582 = phi_3877_;
                                                let _e584 = (0.000000059604645f * (f32(((2147483648u + (_e448.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e560 ^ (_e560 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e584 >= 1f) {
                                                    phi_3885_ = (_e584 - 1f);
                                                } else {
                                                    phi_3885_ = _e584;
                                                }
                                                let _e588 = phi_3885_;
                                                let _e590 = ((2f * _e582) - 1f);
                                                let _e592 = ((2f * _e588) - 1f);
                                                if (_e590 == 0f) {
                                                    let _e594 = (_e592 == 0f);
                                                    phi_2043_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e594));
                                                    phi_2044_ = select(true, false, _e594);
                                                } else {
                                                    phi_2043_ = vec2<f32>();
                                                    phi_2044_ = true;
                                                }
                                                let _e599 = phi_2043_;
                                                let _e601 = phi_2044_;
                                                if _e601 {
                                                    if (abs(_e590) > abs(_e592)) {
                                                        let _e658 = (_e592 / _e590);
                                                        let _e662 = floor(((_e658 * 0.5f) + 0.5f));
                                                        let _e668 = ((((0.7853982f * _e658) - (_e662 * 1.5703125f)) - (_e662 * 0.0004837513f)) - (_e662 * 0.0000000754979f));
                                                        let _e669 = (_e668 * _e668);
                                                        let _e676 = (_e668 + ((_e668 * _e669) * (-0.16666655f + (_e669 * (0.008332161f + (_e669 * -0.00019515296f))))));
                                                        let _e685 = ((1f - (0.5f * _e669)) + ((_e669 * _e669) * (0.041666646f + (_e669 * (-0.0013887316f + (_e669 * 0.000024433157f))))));
                                                        let _e692 = select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < -2147483600f)), 2147483647i, (_e662 > 2147483500f)), (_e662 == _e662));
                                                        let _e694 = ((_e692 & 1i) == 0i);
                                                        let _e695 = select(_e685, _e676, _e694);
                                                        let _e696 = select(_e676, _e685, _e694);
                                                        if ((_e692 & 2i) == 0i) {
                                                            phi_2108_ = _e695;
                                                        } else {
                                                            phi_2108_ = -(_e695);
                                                        }
                                                        let _e701 = phi_2108_;
                                                        if (((_e692 + 1i) & 2i) == 0i) {
                                                            phi_2116_ = _e696;
                                                        } else {
                                                            phi_2116_ = -(_e696);
                                                        }
                                                        let _e707 = phi_2116_;
                                                        phi_2186_ = vec2<f32>((_e590 * _e707), (_e590 * _e701));
                                                    } else {
                                                        let _e605 = (_e590 / _e592);
                                                        let _e609 = floor(((_e605 * 0.5f) + 0.5f));
                                                        let _e615 = ((((0.7853982f * _e605) - (_e609 * 1.5703125f)) - (_e609 * 0.0004837513f)) - (_e609 * 0.0000000754979f));
                                                        let _e616 = (_e615 * _e615);
                                                        let _e623 = (_e615 + ((_e615 * _e616) * (-0.16666655f + (_e616 * (0.008332161f + (_e616 * -0.00019515296f))))));
                                                        let _e632 = ((1f - (0.5f * _e616)) + ((_e616 * _e616) * (0.041666646f + (_e616 * (-0.0013887316f + (_e616 * 0.000024433157f))))));
                                                        let _e639 = select(0i, select(select(i32(_e609), i32(-2147483648), (_e609 < -2147483600f)), 2147483647i, (_e609 > 2147483500f)), (_e609 == _e609));
                                                        let _e641 = ((_e639 & 1i) == 0i);
                                                        let _e642 = select(_e632, _e623, _e641);
                                                        let _e643 = select(_e623, _e632, _e641);
                                                        if ((_e639 & 2i) == 0i) {
                                                            phi_2174_ = _e642;
                                                        } else {
                                                            phi_2174_ = -(_e642);
                                                        }
                                                        let _e648 = phi_2174_;
                                                        if (((_e639 + 1i) & 2i) == 0i) {
                                                            phi_2182_ = _e643;
                                                        } else {
                                                            phi_2182_ = -(_e643);
                                                        }
                                                        let _e654 = phi_2182_;
                                                        phi_2186_ = vec2<f32>((_e592 * _e648), (_e592 * _e654));
                                                    }
                                                    let _e712 = phi_2186_;
                                                    phi_2187_ = _e712;
                                                } else {
                                                    phi_2187_ = _e599;
                                                }
                                                let _e714 = phi_2187_;
                                                let _e720 = (1f - ((_e714.x * _e714.x) + (_e714.y * _e714.y)));
                                                let _e723 = sqrt(select(0f, _e720, (_e720 > 0f)));
                                                phi_2286_ = vec3<f32>(((((1f + (((_e520 * _e166.x) * _e166.x) * _e522)) * _e714.x) + (_e526 * _e714.y)) + (_e166.x * _e723)), ((((_e520 * _e526) * _e714.x) + ((_e520 + ((_e166.y * _e166.y) * _e522)) * _e714.y)) + (_e166.y * _e723)), ((((-(_e520) * _e166.x) * _e714.x) + (-(_e166.y) * _e714.y)) + (_e166.z * _e723)));
                                                phi_2287_ = f32();
                                            } else {
                                                let _e473 = sqrt((((_e462 * _e462) + (_e463 * _e463)) + (_e464 * _e464)));
                                                let _e481 = (((_e166.x * _e462) + (_e166.y * _e463)) + (_e166.z * _e464));
                                                let _e485 = ((_e473 * _e473) * _e473);
                                                let _e488 = (select(0f, _e481, (_e481 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e485, (_e485 > 0.000000000000000000000000000000000000011754944f)));
                                                if (_e410.member_1 == 1u) {
                                                    let _e504 = (_e410.member_4[0] - _e410.member_4[1]);
                                                    let _e507 = (((-((((_e462 * _e410.member_2[0]) + (_e463 * _e410.member_2[1])) + (_e464 * _e410.member_2[2]))) / select(0.000000000000000000000000000000000000011754944f, _e473, (_e473 > 0.000000000000000000000000000000000000011754944f))) - _e410.member_4[1]) / select(0.001f, _e504, (_e504 > 0.001f)));
                                                    let _e509 = select(0f, _e507, (_e507 > 0f));
                                                    let _e511 = select(1f, _e509, (_e509 < 1f));
                                                    phi_2285_ = (_e488 * (_e511 * _e511));
                                                } else {
                                                    phi_2285_ = _e488;
                                                }
                                                let _e515 = phi_2285_;
                                                phi_2286_ = vec3<f32>();
                                                phi_2287_ = _e515;
                                            }
                                            let _e741 = phi_2286_;
                                            let _e743 = phi_2287_;
                                            phi_2288_ = 1f;
                                            phi_2289_ = _e741;
                                            phi_2290_ = _e743;
                                            phi_2291_ = _e467;
                                        }
                                        let _e759 = phi_2288_;
                                        let _e761 = phi_2289_;
                                        let _e763 = phi_2290_;
                                        let _e765 = phi_2291_;
                                        if _e765 {
                                            if ((((_e166.x * _e761.x) + (_e166.y * _e761.y)) + (_e166.z * _e761.z)) < 0f) {
                                                phi_2311_ = -(_e197);
                                            } else {
                                                phi_2311_ = _e197;
                                            }
                                            let _e780 = phi_2311_;
                                            phi_2323_ = type_49(vec3<f32>((_e144.member[0] + (_e166.x * _e780)), (_e144.member[1] + (_e166.y * _e780)), (_e144.member[2] + (_e166.z * _e780))), _e761, 0f, 340282350000000000000000000000000000000f);
                                        } else {
                                            phi_2323_ = type_49();
                                        }
                                        let _e790 = phi_2323_;
                                        phi_2325_ = _e763;
                                        phi_2326_ = vec3<f32>(_e462, _e463, _e464);
                                        phi_2327_ = 340282350000000000000000000000000000000f;
                                        phi_2328_ = vec3<f32>(_e410.member[0], _e410.member[1], _e410.member[2]);
                                        phi_2329_ = _e790;
                                        phi_2330_ = _e759;
                                        phi_2331_ = select(true, false, _e765);
                                    }
                                    let _e975 = phi_2325_;
                                    let _e977 = phi_2326_;
                                    let _e979 = phi_2327_;
                                    let _e981 = phi_2328_;
                                    let _e983 = phi_2329_;
                                    let _e985 = phi_2330_;
                                    let _e987 = phi_2331_;
                                    if _e987 {
                                        if ((((_e166.x * _e977.x) + (_e166.y * _e977.y)) + (_e166.z * _e977.z)) < 0f) {
                                            phi_2351_ = -(_e197);
                                        } else {
                                            phi_2351_ = _e197;
                                        }
                                        let _e1002 = phi_2351_;
                                        let _e1009 = vec3<f32>((_e144.member[0] + (_e166.x * _e1002)), (_e144.member[1] + (_e166.y * _e1002)), (_e144.member[2] + (_e166.z * _e1002)));
                                        phi_2365_ = type_49(_e1009, (_e981 - _e1009), 0f, 0.9999995f);
                                    } else {
                                        phi_2365_ = _e983;
                                    }
                                    let _e1013 = phi_2365_;
                                    let _e1014 = select(_e985, _e975, _e987);
                                    let _e1015 = select(340282350000000000000000000000000000000f, _e979, _e987);
                                    if (_e1014 > 0f) {
                                        let _e1022 = abs(_e1013.member_1.x);
                                        let _e1025 = abs(_e1013.member_1.y);
                                        let _e1028 = abs(_e1013.member_1.z);
                                        let _e1029 = (_e1022 > _e1025);
                                        if _e1029 {
                                            phi_2398_ = (_e1022 > _e1028);
                                        } else {
                                            phi_2398_ = (_e1025 > _e1028);
                                        }
                                        let _e1033 = phi_2398_;
                                        let _e1034 = select(1u, 0u, _e1029);
                                        if _e1033 {
                                            let _e1035 = (_e1034 + 1u);
                                            phi_2408_ = _e1035;
                                            phi_2411_ = select(true, false, (_e1035 == 2u));
                                        } else {
                                            phi_2408_ = u32();
                                            phi_2411_ = false;
                                        }
                                        let _e1039 = phi_2408_;
                                        let _e1041 = phi_2411_;
                                        let _e1042 = select(true, false, _e1033);
                                        let _e1043 = select(_e1039, 0u, _e1042);
                                        let _e1045 = select(_e1041, true, _e1042);
                                        if _e1045 {
                                            phi_2422_ = (_e1043 + 1u);
                                        } else {
                                            phi_2422_ = 0u;
                                        }
                                        let _e1048 = phi_2422_;
                                        let _e1049 = select(_e1039, _e1043, _e1045);
                                        let _e1050 = select(_e1034, select(_e1034, 2u, _e1042), _e1045);
                                        local_1 = array<f32, 3>(_e1013.member_1.x, _e1013.member_1.y, _e1013.member_1.z);
                                        local_2 = array<f32, 3>(_e1013.member.x, _e1013.member.y, _e1013.member.z);
                                        let _e1059 = (_e1050 < 3u);
                                        if _e1059 {
                                        } else {
                                            phi_5374_ = true;
                                            break;
                                        }
                                        let _e1061 = local_1[_e1050];
                                        let _e1062 = (1f / _e1061);
                                        let _e1063 = (_e1049 < 3u);
                                        if _e1063 {
                                        } else {
                                            phi_5374_ = true;
                                            break;
                                        }
                                        let _e1065 = local_1[_e1049];
                                        let _e1066 = (_e1065 * _e1062);
                                        let _e1067 = (_e1048 < 3u);
                                        if _e1067 {
                                        } else {
                                            phi_5374_ = true;
                                            break;
                                        }
                                        let _e1069 = local_1[_e1048];
                                        let _e1070 = (_e1069 * _e1062);
                                        if _e1063 {
                                        } else {
                                            phi_5374_ = true;
                                            break;
                                        }
                                        let _e1072 = local_2[_e1049];
                                        if _e1067 {
                                        } else {
                                            phi_5374_ = true;
                                            break;
                                        }
                                        let _e1074 = local_2[_e1048];
                                        if _e1059 {
                                        } else {
                                            phi_5374_ = true;
                                            break;
                                        }
                                        let _e1076 = local_2[_e1050];
                                        if (0u < _e119) {
                                        } else {
                                            phi_5374_ = true;
                                            break;
                                        }
                                        let _e1081 = nodes.member[0u].member_7[0u];
                                        let _e1085 = nodes.member[0u].member_7[1u];
                                        let _e1089 = nodes.member[0u].member_7[2u];
                                        let _e1093 = nodes.member[0u].member_7[3u];
                                        let _e1095 = abs((_e1013.member.x - _e1081));
                                        let _e1097 = abs((_e1013.member.y - _e1085));
                                        let _e1099 = select(_e1097, _e1095, (_e1095 > _e1097));
                                        let _e1101 = abs((_e1013.member.z - _e1089));
                                        let _e1105 = ((select(_e1101, _e1099, (_e1099 > _e1101)) + _e1093) * 0.0000009536743f);
                                        let _e1112 = (_e1105 + (abs(_e1013.member.x) * 0.00000023841858f));
                                        let _e1113 = (_e1105 + (abs(_e1013.member.y) * 0.00000023841858f));
                                        let _e1114 = (_e1105 + (abs(_e1013.member.z) * 0.00000023841858f));
                                        let _e1115 = select(_e1025, _e1022, _e1029);
                                        let _e1117 = select(_e1028, _e1115, (_e1115 > _e1028));
                                        let _e1118 = (_e1117 * 0.000000000001f);
                                        let _e1121 = (_e1013.member.x + _e1112);
                                        let _e1123 = (_e1013.member.y + _e1113);
                                        let _e1125 = (_e1013.member.z + _e1114);
                                        let _e1126 = (_e1013.member.x - _e1112);
                                        let _e1127 = (_e1013.member.y - _e1113);
                                        let _e1128 = (_e1013.member.z - _e1114);
                                        if (_e1022 > _e1118) {
                                            phi_2575_ = (1f / _e1013.member_1.x);
                                        } else {
                                            phi_2575_ = (1000000000000f / _e1117);
                                        }
                                        let _e1133 = phi_2575_;
                                        if (_e1025 > _e1118) {
                                            phi_2583_ = (1f / _e1013.member_1.y);
                                        } else {
                                            phi_2583_ = (1000000000000f / _e1117);
                                        }
                                        let _e1138 = phi_2583_;
                                        if (_e1028 > _e1118) {
                                            phi_2591_ = (1f / _e1013.member_1.z);
                                        } else {
                                            phi_2591_ = (1000000000000f / _e1117);
                                        }
                                        let _e1143 = phi_2591_;
                                        local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_5209_ = _e425;
                                        phi_2595_ = 0u;
                                        phi_2598_ = 0u;
                                        loop {
                                            let _e1147 = phi_5209_;
                                            let _e1149 = phi_2595_;
                                            let _e1151 = phi_2598_;
                                            let _e1152 = (_e1149 & 15u);
                                            let _e1154 = (_e1149 >> bitcast<u32>(4u));
                                            if (_e1152 == 0u) {
                                                if (_e1154 < _e119) {
                                                } else {
                                                    phi_5314_ = true;
                                                    phi_3869_ = bool();
                                                    break;
                                                }
                                                let _e1787 = nodes.member[_e1154].member;
                                                let _e1796 = ((_e1787.x - _e1121) * _e1133);
                                                let _e1797 = ((_e1787.y - _e1121) * _e1133);
                                                let _e1798 = ((_e1787.z - _e1121) * _e1133);
                                                let _e1799 = ((_e1787.w - _e1121) * _e1133);
                                                let _e1802 = nodes.member[_e1154].member_3;
                                                let _e1811 = ((_e1802.x - _e1126) * _e1133);
                                                let _e1812 = ((_e1802.y - _e1126) * _e1133);
                                                let _e1813 = ((_e1802.z - _e1126) * _e1133);
                                                let _e1814 = ((_e1802.w - _e1126) * _e1133);
                                                let _e1817 = nodes.member[_e1154].member_1;
                                                let _e1826 = ((_e1817.x - _e1123) * _e1138);
                                                let _e1827 = ((_e1817.y - _e1123) * _e1138);
                                                let _e1828 = ((_e1817.z - _e1123) * _e1138);
                                                let _e1829 = ((_e1817.w - _e1123) * _e1138);
                                                let _e1832 = nodes.member[_e1154].member_4;
                                                let _e1841 = ((_e1832.x - _e1127) * _e1138);
                                                let _e1842 = ((_e1832.y - _e1127) * _e1138);
                                                let _e1843 = ((_e1832.z - _e1127) * _e1138);
                                                let _e1844 = ((_e1832.w - _e1127) * _e1138);
                                                let _e1847 = nodes.member[_e1154].member_2;
                                                let _e1856 = ((_e1847.x - _e1125) * _e1143);
                                                let _e1857 = ((_e1847.y - _e1125) * _e1143);
                                                let _e1858 = ((_e1847.z - _e1125) * _e1143);
                                                let _e1859 = ((_e1847.w - _e1125) * _e1143);
                                                let _e1862 = nodes.member[_e1154].member_5;
                                                let _e1871 = ((_e1862.x - _e1128) * _e1143);
                                                let _e1872 = ((_e1862.y - _e1128) * _e1143);
                                                let _e1873 = ((_e1862.z - _e1128) * _e1143);
                                                let _e1874 = ((_e1862.w - _e1128) * _e1143);
                                                let _e1876 = select(_e1811, _e1796, (_e1796 < _e1811));
                                                let _e1878 = select(_e1812, _e1797, (_e1797 < _e1812));
                                                let _e1880 = select(_e1813, _e1798, (_e1798 < _e1813));
                                                let _e1882 = select(_e1814, _e1799, (_e1799 < _e1814));
                                                let _e1884 = select(_e1841, _e1826, (_e1826 < _e1841));
                                                let _e1886 = select(_e1842, _e1827, (_e1827 < _e1842));
                                                let _e1888 = select(_e1843, _e1828, (_e1828 < _e1843));
                                                let _e1890 = select(_e1844, _e1829, (_e1829 < _e1844));
                                                let _e1892 = select(_e1884, _e1876, (_e1876 > _e1884));
                                                let _e1894 = select(_e1886, _e1878, (_e1878 > _e1886));
                                                let _e1896 = select(_e1888, _e1880, (_e1880 > _e1888));
                                                let _e1898 = select(_e1890, _e1882, (_e1882 > _e1890));
                                                let _e1900 = select(_e1871, _e1856, (_e1856 < _e1871));
                                                let _e1902 = select(_e1872, _e1857, (_e1857 < _e1872));
                                                let _e1904 = select(_e1873, _e1858, (_e1858 < _e1873));
                                                let _e1906 = select(_e1874, _e1859, (_e1859 < _e1874));
                                                let _e1908 = select(_e1900, _e1892, (_e1892 > _e1900));
                                                let _e1910 = select(_e1902, _e1894, (_e1894 > _e1902));
                                                let _e1912 = select(_e1904, _e1896, (_e1896 > _e1904));
                                                let _e1914 = select(_e1906, _e1898, (_e1898 > _e1906));
                                                let _e1916 = select(_e1013.member_2, _e1908, (_e1908 > _e1013.member_2));
                                                let _e1918 = select(_e1013.member_2, _e1910, (_e1910 > _e1013.member_2));
                                                let _e1920 = select(_e1013.member_2, _e1912, (_e1912 > _e1013.member_2));
                                                let _e1922 = select(_e1013.member_2, _e1914, (_e1914 > _e1013.member_2));
                                                let _e1924 = select(_e1811, _e1796, (_e1796 > _e1811));
                                                let _e1926 = select(_e1812, _e1797, (_e1797 > _e1812));
                                                let _e1928 = select(_e1813, _e1798, (_e1798 > _e1813));
                                                let _e1930 = select(_e1814, _e1799, (_e1799 > _e1814));
                                                let _e1932 = select(_e1841, _e1826, (_e1826 > _e1841));
                                                let _e1934 = select(_e1842, _e1827, (_e1827 > _e1842));
                                                let _e1936 = select(_e1843, _e1828, (_e1828 > _e1843));
                                                let _e1938 = select(_e1844, _e1829, (_e1829 > _e1844));
                                                let _e1940 = select(_e1932, _e1924, (_e1924 < _e1932));
                                                let _e1942 = select(_e1934, _e1926, (_e1926 < _e1934));
                                                let _e1944 = select(_e1936, _e1928, (_e1928 < _e1936));
                                                let _e1946 = select(_e1938, _e1930, (_e1930 < _e1938));
                                                let _e1948 = select(_e1871, _e1856, (_e1856 > _e1871));
                                                let _e1950 = select(_e1872, _e1857, (_e1857 > _e1872));
                                                let _e1952 = select(_e1873, _e1858, (_e1858 > _e1873));
                                                let _e1954 = select(_e1874, _e1859, (_e1859 > _e1874));
                                                let _e1956 = select(_e1948, _e1940, (_e1940 < _e1948));
                                                let _e1958 = select(_e1950, _e1942, (_e1942 < _e1950));
                                                let _e1960 = select(_e1952, _e1944, (_e1944 < _e1952));
                                                let _e1962 = select(_e1954, _e1946, (_e1946 < _e1954));
                                                let _e1982 = nodes.member[_e1154].member_6[0u];
                                                let _e1986 = nodes.member[_e1154].member_6[1u];
                                                let _e1990 = nodes.member[_e1154].member_6[2u];
                                                let _e1994 = nodes.member[_e1154].member_6[3u];
                                                if (select(340282350000000000000000000000000000000f, _e1922, (_e1922 <= select(_e1013.member_3, _e1962, (_e1962 < _e1013.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e1151 < 64u) {
                                                    } else {
                                                        phi_5314_ = true;
                                                        phi_3869_ = bool();
                                                        break;
                                                    }
                                                    local[_e1151] = _e1994;
                                                    phi_2985_ = (_e1151 + 1u);
                                                } else {
                                                    phi_2985_ = _e1151;
                                                }
                                                let _e2000 = phi_2985_;
                                                if (select(340282350000000000000000000000000000000f, _e1920, (_e1920 <= select(_e1013.member_3, _e1960, (_e1960 < _e1013.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2000 < 64u) {
                                                    } else {
                                                        phi_5314_ = true;
                                                        phi_3869_ = bool();
                                                        break;
                                                    }
                                                    local[_e2000] = _e1990;
                                                    phi_2997_ = (_e2000 + 1u);
                                                } else {
                                                    phi_2997_ = _e2000;
                                                }
                                                let _e2006 = phi_2997_;
                                                if (select(340282350000000000000000000000000000000f, _e1918, (_e1918 <= select(_e1013.member_3, _e1958, (_e1958 < _e1013.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2006 < 64u) {
                                                    } else {
                                                        phi_5314_ = true;
                                                        phi_3869_ = bool();
                                                        break;
                                                    }
                                                    local[_e2006] = _e1986;
                                                    phi_3009_ = (_e2006 + 1u);
                                                } else {
                                                    phi_3009_ = _e2006;
                                                }
                                                let _e2012 = phi_3009_;
                                                if (select(340282350000000000000000000000000000000f, _e1916, (_e1916 <= select(_e1013.member_3, _e1956, (_e1956 < _e1013.member_3)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e2012 < 64u) {
                                                    } else {
                                                        phi_5314_ = true;
                                                        phi_3869_ = bool();
                                                        break;
                                                    }
                                                    local[_e2012] = _e1982;
                                                    phi_3021_ = (_e2012 + 1u);
                                                } else {
                                                    phi_3021_ = _e2012;
                                                }
                                                let _e2018 = phi_3021_;
                                                phi_5316_ = _e1147;
                                                phi_3714_ = _e2018;
                                                phi_3715_ = true;
                                            } else {
                                                phi_3025_ = type_13(_e1154, (_e1154 + _e1152));
                                                loop {
                                                    let _e1159 = phi_3025_;
                                                    if (_e1159.member < _e1159.member_1) {
                                                        phi_3026_ = type_13((_e1159.member + 1u), _e1159.member_1);
                                                        phi_3049_ = type_13(1u, _e1159.member);
                                                    } else {
                                                        phi_3026_ = _e1159;
                                                        phi_3049_ = type_13(0u, type_13().member_1);
                                                    }
                                                    let _e1172 = phi_3026_;
                                                    let _e1174 = phi_3049_;
                                                    let _e1178 = (bitcast<i32>(_e1174.member) != 0i);
                                                    if _e1178 {
                                                        let _e1179 = (_e1174.member_1 < arrayLength((&triangles.member)));
                                                        if _e1179 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        if _e1059 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        let _e1183 = triangles.member[_e1174.member_1].member[_e1050];
                                                        let _e1184 = (_e1183 - _e1076);
                                                        if _e1059 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        let _e1188 = triangles.member[_e1174.member_1].member_2[_e1050];
                                                        let _e1189 = (_e1188 - _e1076);
                                                        if _e1059 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        let _e1193 = triangles.member[_e1174.member_1].member_4[_e1050];
                                                        let _e1194 = (_e1193 - _e1076);
                                                        if _e1063 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        let _e1198 = triangles.member[_e1174.member_1].member[_e1049];
                                                        let _e1201 = ((_e1198 - _e1072) - (_e1066 * _e1184));
                                                        if _e1067 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        let _e1205 = triangles.member[_e1174.member_1].member[_e1048];
                                                        let _e1208 = ((_e1205 - _e1074) - (_e1070 * _e1184));
                                                        if _e1063 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        let _e1212 = triangles.member[_e1174.member_1].member_2[_e1049];
                                                        let _e1215 = ((_e1212 - _e1072) - (_e1066 * _e1189));
                                                        if _e1067 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        let _e1219 = triangles.member[_e1174.member_1].member_2[_e1048];
                                                        let _e1222 = ((_e1219 - _e1074) - (_e1070 * _e1189));
                                                        if _e1063 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        let _e1226 = triangles.member[_e1174.member_1].member_4[_e1049];
                                                        let _e1229 = ((_e1226 - _e1072) - (_e1066 * _e1194));
                                                        if _e1067 {
                                                        } else {
                                                            phi_5205_ = true;
                                                            phi_3868_ = bool();
                                                            break;
                                                        }
                                                        let _e1233 = triangles.member[_e1174.member_1].member_4[_e1048];
                                                        let _e1236 = ((_e1233 - _e1074) - (_e1070 * _e1194));
                                                        let _e1237 = (_e1229 * _e1222);
                                                        let _e1238 = (_e1236 * _e1215);
                                                        if (_e1237 != _e1238) {
                                                            phi_3165_ = (_e1237 - _e1238);
                                                        } else {
                                                            let _e1240 = (_e1229 * 4097f);
                                                            let _e1242 = (_e1240 - (_e1240 - _e1229));
                                                            let _e1243 = (_e1222 * 4097f);
                                                            let _e1245 = (_e1243 - (_e1243 - _e1222));
                                                            let _e1246 = (_e1229 - _e1242);
                                                            let _e1247 = (_e1222 - _e1245);
                                                            let _e1256 = (_e1236 * 4097f);
                                                            let _e1258 = (_e1256 - (_e1256 - _e1236));
                                                            let _e1259 = (_e1215 * 4097f);
                                                            let _e1261 = (_e1259 - (_e1259 - _e1215));
                                                            let _e1262 = (_e1236 - _e1258);
                                                            let _e1263 = (_e1215 - _e1261);
                                                            phi_3165_ = ((((((_e1242 * _e1245) - _e1237) + (_e1242 * _e1247)) + (_e1246 * _e1245)) + (_e1246 * _e1247)) - (((((_e1258 * _e1261) - _e1238) + (_e1258 * _e1263)) + (_e1262 * _e1261)) + (_e1262 * _e1263)));
                                                        }
                                                        let _e1275 = phi_3165_;
                                                        let _e1276 = (_e1201 * _e1236);
                                                        let _e1277 = (_e1208 * _e1229);
                                                        if (_e1276 != _e1277) {
                                                            phi_3176_ = (_e1276 - _e1277);
                                                        } else {
                                                            let _e1279 = (_e1201 * 4097f);
                                                            let _e1281 = (_e1279 - (_e1279 - _e1201));
                                                            let _e1282 = (_e1236 * 4097f);
                                                            let _e1284 = (_e1282 - (_e1282 - _e1236));
                                                            let _e1285 = (_e1201 - _e1281);
                                                            let _e1286 = (_e1236 - _e1284);
                                                            let _e1295 = (_e1208 * 4097f);
                                                            let _e1297 = (_e1295 - (_e1295 - _e1208));
                                                            let _e1298 = (_e1229 * 4097f);
                                                            let _e1300 = (_e1298 - (_e1298 - _e1229));
                                                            let _e1301 = (_e1208 - _e1297);
                                                            let _e1302 = (_e1229 - _e1300);
                                                            phi_3176_ = ((((((_e1281 * _e1284) - _e1276) + (_e1281 * _e1286)) + (_e1285 * _e1284)) + (_e1285 * _e1286)) - (((((_e1297 * _e1300) - _e1277) + (_e1297 * _e1302)) + (_e1301 * _e1300)) + (_e1301 * _e1302)));
                                                        }
                                                        let _e1314 = phi_3176_;
                                                        let _e1315 = (_e1215 * _e1208);
                                                        let _e1316 = (_e1222 * _e1201);
                                                        if (_e1315 != _e1316) {
                                                            phi_3187_ = (_e1315 - _e1316);
                                                        } else {
                                                            let _e1318 = (_e1215 * 4097f);
                                                            let _e1320 = (_e1318 - (_e1318 - _e1215));
                                                            let _e1321 = (_e1208 * 4097f);
                                                            let _e1323 = (_e1321 - (_e1321 - _e1208));
                                                            let _e1324 = (_e1215 - _e1320);
                                                            let _e1325 = (_e1208 - _e1323);
                                                            let _e1334 = (_e1222 * 4097f);
                                                            let _e1336 = (_e1334 - (_e1334 - _e1222));
                                                            let _e1337 = (_e1201 * 4097f);
                                                            let _e1339 = (_e1337 - (_e1337 - _e1201));
                                                            let _e1340 = (_e1222 - _e1336);
                                                            let _e1341 = (_e1201 - _e1339);
                                                            phi_3187_ = ((((((_e1320 * _e1323) - _e1315) + (_e1320 * _e1325)) + (_e1324 * _e1323)) + (_e1324 * _e1325)) - (((((_e1336 * _e1339) - _e1316) + (_e1336 * _e1341)) + (_e1340 * _e1339)) + (_e1340 * _e1341)));
                                                        }
                                                        let _e1353 = phi_3187_;
                                                        if (_e1275 < 0f) {
                                                            phi_3205_ = f32();
                                                            phi_3206_ = true;
                                                        } else {
                                                            if (_e1314 < 0f) {
                                                                phi_3203_ = f32();
                                                                phi_3204_ = true;
                                                            } else {
                                                                let _e1356 = (_e1353 < 0f);
                                                                if _e1356 {
                                                                    phi_3202_ = f32();
                                                                } else {
                                                                    phi_3202_ = ((_e1275 + _e1314) + _e1353);
                                                                }
                                                                let _e1360 = phi_3202_;
                                                                phi_3203_ = _e1360;
                                                                phi_3204_ = _e1356;
                                                            }
                                                            let _e1362 = phi_3203_;
                                                            let _e1364 = phi_3204_;
                                                            phi_3205_ = _e1362;
                                                            phi_3206_ = _e1364;
                                                        }
                                                        let _e1366 = phi_3205_;
                                                        let _e1368 = phi_3206_;
                                                        if _e1368 {
                                                            if (_e1275 > 0f) {
                                                                phi_3227_ = f32();
                                                                phi_3228_ = true;
                                                                phi_3229_ = false;
                                                            } else {
                                                                let _e1370 = (_e1314 > 0f);
                                                                if _e1370 {
                                                                    phi_3225_ = f32();
                                                                    phi_3226_ = false;
                                                                } else {
                                                                    phi_3225_ = ((_e1275 + _e1314) + _e1353);
                                                                    phi_3226_ = select(true, false, (_e1353 > 0f));
                                                                }
                                                                let _e1376 = phi_3225_;
                                                                let _e1378 = phi_3226_;
                                                                phi_3227_ = _e1376;
                                                                phi_3228_ = _e1370;
                                                                phi_3229_ = _e1378;
                                                            }
                                                            let _e1380 = phi_3227_;
                                                            let _e1382 = phi_3228_;
                                                            let _e1384 = phi_3229_;
                                                            phi_3234_ = _e1380;
                                                            phi_3235_ = select(_e1384, false, _e1382);
                                                        } else {
                                                            phi_3234_ = _e1366;
                                                            phi_3235_ = true;
                                                        }
                                                        let _e1387 = phi_3234_;
                                                        let _e1389 = phi_3235_;
                                                        if _e1389 {
                                                            let _e1390 = (_e1387 == 0f);
                                                            if _e1390 {
                                                                phi_3323_ = array<f32, 3>();
                                                                phi_3324_ = array<f32, 3>();
                                                                phi_3325_ = false;
                                                            } else {
                                                                let _e1391 = (_e1184 * _e1062);
                                                                let _e1392 = (_e1189 * _e1062);
                                                                let _e1393 = (_e1194 * _e1062);
                                                                let _e1396 = (1f / ((_e1275 + _e1314) + _e1353));
                                                                let _e1397 = (_e1314 * _e1396);
                                                                let _e1398 = (_e1353 * _e1396);
                                                                let _e1404 = ((((_e1275 * _e1396) * _e1391) + (_e1397 * _e1392)) + (_e1398 * _e1393));
                                                                let _e1405 = abs(_e1201);
                                                                let _e1406 = abs(_e1215);
                                                                let _e1408 = select(_e1406, _e1405, (_e1405 > _e1406));
                                                                let _e1409 = abs(_e1229);
                                                                let _e1412 = abs(_e1208);
                                                                let _e1413 = abs(_e1222);
                                                                let _e1415 = select(_e1413, _e1412, (_e1412 > _e1413));
                                                                let _e1416 = abs(_e1236);
                                                                let _e1420 = abs(_e1391);
                                                                let _e1421 = abs(_e1392);
                                                                let _e1423 = select(_e1421, _e1420, (_e1420 > _e1421));
                                                                let _e1424 = abs(_e1393);
                                                                let _e1431 = (((select(_e1409, _e1408, (_e1408 > _e1409)) * select(_e1416, _e1415, (_e1415 > _e1416))) * select(_e1424, _e1423, (_e1423 > _e1424))) <= (abs((_e1387 * _e1404)) * 256f));
                                                                if _e1431 {
                                                                    phi_3321_ = array<f32, 3>(_e1404, _e1397, _e1398);
                                                                    phi_3322_ = array<f32, 3>();
                                                                } else {
                                                                    let _e1433 = (_e1229 * 4097f);
                                                                    let _e1435 = (_e1433 - (_e1433 - _e1229));
                                                                    let _e1436 = (_e1222 * 4097f);
                                                                    let _e1438 = (_e1436 - (_e1436 - _e1222));
                                                                    let _e1439 = (_e1229 - _e1435);
                                                                    let _e1440 = (_e1222 - _e1438);
                                                                    let _e1449 = (_e1236 * 4097f);
                                                                    let _e1451 = (_e1449 - (_e1449 - _e1236));
                                                                    let _e1452 = (_e1215 * 4097f);
                                                                    let _e1454 = (_e1452 - (_e1452 - _e1215));
                                                                    let _e1455 = (_e1236 - _e1451);
                                                                    let _e1456 = (_e1215 - _e1454);
                                                                    let _e1466 = ((_e1237 - _e1238) + ((((((_e1435 * _e1438) - _e1237) + (_e1435 * _e1440)) + (_e1439 * _e1438)) + (_e1439 * _e1440)) - (((((_e1451 * _e1454) - _e1238) + (_e1451 * _e1456)) + (_e1455 * _e1454)) + (_e1455 * _e1456))));
                                                                    let _e1468 = (_e1201 * 4097f);
                                                                    let _e1470 = (_e1468 - (_e1468 - _e1201));
                                                                    let _e1471 = (_e1201 - _e1470);
                                                                    let _e1480 = (_e1208 * 4097f);
                                                                    let _e1482 = (_e1480 - (_e1480 - _e1208));
                                                                    let _e1483 = (_e1208 - _e1482);
                                                                    let _e1493 = ((_e1276 - _e1277) + ((((((_e1470 * _e1451) - _e1276) + (_e1470 * _e1455)) + (_e1471 * _e1451)) + (_e1471 * _e1455)) - (((((_e1482 * _e1435) - _e1277) + (_e1482 * _e1439)) + (_e1483 * _e1435)) + (_e1483 * _e1439))));
                                                                    let _e1512 = ((_e1315 - _e1316) + ((((((_e1454 * _e1482) - _e1315) + (_e1454 * _e1483)) + (_e1456 * _e1482)) + (_e1456 * _e1483)) - (((((_e1438 * _e1470) - _e1316) + (_e1438 * _e1471)) + (_e1440 * _e1470)) + (_e1440 * _e1471))));
                                                                    let _e1515 = (1f / ((_e1466 + _e1493) + _e1512));
                                                                    let _e1516 = (_e1493 * _e1515);
                                                                    let _e1517 = (_e1512 * _e1515);
                                                                    phi_3321_ = array<f32, 3>();
                                                                    phi_3322_ = array<f32, 3>(((((_e1466 * _e1515) * _e1391) + (_e1516 * _e1392)) + (_e1517 * _e1393)), _e1516, _e1517);
                                                                }
                                                                let _e1527 = phi_3321_;
                                                                let _e1529 = phi_3322_;
                                                                phi_3323_ = _e1527;
                                                                phi_3324_ = _e1529;
                                                                phi_3325_ = _e1431;
                                                            }
                                                            let _e1531 = phi_3323_;
                                                            let _e1533 = phi_3324_;
                                                            let _e1535 = phi_3325_;
                                                            phi_3326_ = _e1531;
                                                            phi_3327_ = _e1533;
                                                            phi_3328_ = _e1390;
                                                            phi_3329_ = _e1535;
                                                        } else {
                                                            phi_3326_ = array<f32, 3>();
                                                            phi_3327_ = array<f32, 3>();
                                                            phi_3328_ = true;
                                                            phi_3329_ = false;
                                                        }
                                                        let _e1537 = phi_3326_;
                                                        let _e1539 = phi_3327_;
                                                        let _e1541 = phi_3328_;
                                                        let _e1543 = phi_3329_;
                                                        if _e1541 {
                                                            phi_3334_ = array<f32, 3>(-1f, 0f, 0f);
                                                        } else {
                                                            phi_3334_ = _e1537;
                                                        }
                                                        let _e1545 = phi_3334_;
                                                        if select(_e1543, true, _e1541) {
                                                            phi_3339_ = _e1545;
                                                        } else {
                                                            phi_3339_ = _e1539;
                                                        }
                                                        let _e1548 = phi_3339_;
                                                        if (_e1548[0] >= _e1013.member_2) {
                                                            let _e1554 = (_e1548[0] < _e1013.member_3);
                                                            if _e1554 {
                                                                let _e1555 = (_e1548[0] >= 0f);
                                                                if _e1555 {
                                                                    if _e1179 {
                                                                    } else {
                                                                        phi_5205_ = true;
                                                                        phi_3868_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e1558 = triangles.member[_e1174.member_1].member_3;
                                                                    if ((_e1558 & 1u) == 0u) {
                                                                        phi_3672_ = true;
                                                                    } else {
                                                                        if _e1179 {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1563 = triangles.member[_e1174.member_1].member_1;
                                                                        let _e1564 = (_e1563 * 12u);
                                                                        if ((256u + _e1564) < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1564 + 257u) < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1564 + 258u) < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1571 = (_e1564 + 259u);
                                                                        if (_e1571 < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1574 = surfaces.member[_e1571];
                                                                        if ((_e1564 + 260u) < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1564 + 261u) < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1564 + 262u) < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1581 = (_e1564 + 263u);
                                                                        if (_e1581 < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1584 = surfaces.member[_e1581];
                                                                        let _e1585 = (_e1564 + 264u);
                                                                        if (_e1585 < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1588 = surfaces.member[_e1585];
                                                                        let _e1589 = bitcast<f32>(_e1588);
                                                                        let _e1590 = (_e1564 + 265u);
                                                                        if (_e1590 < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1593 = surfaces.member[_e1590];
                                                                        let _e1594 = bitcast<f32>(_e1593);
                                                                        if ((_e1564 + 266u) < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e1564 + 267u) < _e128) {
                                                                        } else {
                                                                            phi_5205_ = true;
                                                                            phi_3868_ = bool();
                                                                            break;
                                                                        }
                                                                        if (_e1574 == 4294967295u) {
                                                                            phi_3667_ = (_e1589 < _e1594);
                                                                        } else {
                                                                            if (_e1174.member_1 < arrayLength((&attributes.member))) {
                                                                            } else {
                                                                                phi_5205_ = true;
                                                                                phi_3868_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1602 = ((1f - _e1548[1]) - _e1548[2]);
                                                                            let _e1606 = attributes.member[_e1174.member_1].member[0u];
                                                                            let _e1611 = attributes.member[_e1174.member_1].member[2u];
                                                                            let _e1617 = attributes.member[_e1174.member_1].member[4u];
                                                                            let _e1619 = (((_e1606 * _e1602) + (_e1611 * _e1548[1])) + (_e1617 * _e1548[2]));
                                                                            let _e1623 = attributes.member[_e1174.member_1].member[1u];
                                                                            let _e1628 = attributes.member[_e1174.member_1].member[3u];
                                                                            let _e1634 = attributes.member[_e1174.member_1].member[5u];
                                                                            let _e1636 = (((_e1623 * _e1602) + (_e1628 * _e1548[1])) + (_e1634 * _e1548[2]));
                                                                            let _e1637 = (_e1584 & 65535u);
                                                                            let _e1639 = (_e1584 >> bitcast<u32>(16i));
                                                                            let _e1641 = (_e1619 - floor(_e1619));
                                                                            let _e1646 = ((select(0f, _e1641, (_e1641 <= 1f)) * f32(_e1637)) - 0.5f);
                                                                            let _e1647 = floor(_e1646);
                                                                            let _e1648 = (_e1646 - _e1647);
                                                                            let _e1649 = (_e1637 - 1u);
                                                                            if (_e1647 < 0f) {
                                                                                phi_3550_ = _e1649;
                                                                            } else {
                                                                                let _e1655 = select(select(u32(_e1647), 0u, (_e1647 < 0f)), 4294967295u, (_e1647 > 4294967000f));
                                                                                phi_3550_ = select(_e1655, _e1649, (_e1649 < _e1655));
                                                                            }
                                                                            let _e1659 = phi_3550_;
                                                                            if (_e1659 == _e1649) {
                                                                                phi_3556_ = 0u;
                                                                            } else {
                                                                                phi_3556_ = (_e1659 + 1u);
                                                                            }
                                                                            let _e1663 = phi_3556_;
                                                                            let _e1665 = (_e1636 - floor(_e1636));
                                                                            let _e1670 = ((select(0f, _e1665, (_e1665 <= 1f)) * f32(_e1639)) - 0.5f);
                                                                            let _e1671 = floor(_e1670);
                                                                            let _e1672 = (_e1670 - _e1671);
                                                                            let _e1673 = (_e1639 - 1u);
                                                                            if (_e1671 < 0f) {
                                                                                phi_3586_ = _e1673;
                                                                            } else {
                                                                                let _e1679 = select(select(u32(_e1671), 0u, (_e1671 < 0f)), 4294967295u, (_e1671 > 4294967000f));
                                                                                phi_3586_ = select(_e1679, _e1673, (_e1673 < _e1679));
                                                                            }
                                                                            let _e1683 = phi_3586_;
                                                                            if (_e1683 == _e1673) {
                                                                                phi_3592_ = 0u;
                                                                            } else {
                                                                                phi_3592_ = (_e1683 + 1u);
                                                                            }
                                                                            let _e1687 = phi_3592_;
                                                                            let _e1689 = (_e1574 + (_e1683 * _e1637));
                                                                            let _e1691 = (_e1574 + (_e1687 * _e1637));
                                                                            let _e1692 = (_e1689 + _e1659);
                                                                            let _e1693 = (_e1689 + _e1663);
                                                                            let _e1694 = (_e1691 + _e1659);
                                                                            let _e1695 = (_e1691 + _e1663);
                                                                            if (_e1692 < _e128) {
                                                                            } else {
                                                                                phi_5205_ = true;
                                                                                phi_3868_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1698 = surfaces.member[_e1692];
                                                                            if (_e1693 < _e128) {
                                                                            } else {
                                                                                phi_5205_ = true;
                                                                                phi_3868_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1701 = surfaces.member[_e1693];
                                                                            if (_e1694 < _e128) {
                                                                            } else {
                                                                                phi_5205_ = true;
                                                                                phi_3868_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1704 = surfaces.member[_e1694];
                                                                            if (_e1695 < _e128) {
                                                                            } else {
                                                                                phi_5205_ = true;
                                                                                phi_3868_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1707 = surfaces.member[_e1695];
                                                                            let _e1724 = (1f - _e1648);
                                                                            phi_3667_ = ((_e1589 * (((((f32((_e1698 >> bitcast<u32>(24i))) * 0.003921569f) * _e1724) + ((f32((_e1701 >> bitcast<u32>(24i))) * 0.003921569f) * _e1648)) * (1f - _e1672)) + ((((f32((_e1704 >> bitcast<u32>(24i))) * 0.003921569f) * _e1724) + ((f32((_e1707 >> bitcast<u32>(24i))) * 0.003921569f) * _e1648)) * _e1672))) < _e1594);
                                                                        }
                                                                        let _e1739 = phi_3667_;
                                                                        phi_3672_ = select(true, false, _e1739);
                                                                    }
                                                                    let _e1742 = phi_3672_;
                                                                    if _e1742 {
                                                                        phi_3677_ = type_53(_e1548[0], _e1174.member_1, _e1548[1], _e1548[2]);
                                                                    } else {
                                                                        phi_3677_ = type_53();
                                                                    }
                                                                    let _e1745 = phi_3677_;
                                                                    phi_3679_ = _e1745;
                                                                    phi_3681_ = select(true, false, _e1742);
                                                                } else {
                                                                    phi_3679_ = type_53();
                                                                    phi_3681_ = false;
                                                                }
                                                                let _e1748 = phi_3679_;
                                                                let _e1750 = phi_3681_;
                                                                phi_3682_ = _e1748;
                                                                phi_3684_ = select(true, false, _e1555);
                                                                phi_3685_ = _e1750;
                                                            } else {
                                                                phi_3682_ = type_53();
                                                                phi_3684_ = false;
                                                                phi_3685_ = false;
                                                            }
                                                            let _e1753 = phi_3682_;
                                                            let _e1755 = phi_3684_;
                                                            let _e1757 = phi_3685_;
                                                            phi_3686_ = _e1753;
                                                            phi_3687_ = select(true, false, _e1554);
                                                            phi_3688_ = _e1755;
                                                            phi_3689_ = _e1757;
                                                        } else {
                                                            phi_3686_ = type_53();
                                                            phi_3687_ = true;
                                                            phi_3688_ = false;
                                                            phi_3689_ = false;
                                                        }
                                                        let _e1760 = phi_3686_;
                                                        let _e1762 = phi_3687_;
                                                        let _e1764 = phi_3688_;
                                                        let _e1766 = phi_3689_;
                                                        if select(select(_e1766, false, _e1762), true, select(_e1764, true, _e1762)) {
                                                            phi_3702_ = type_53(_e1013.member_3, 4294967295u, 0f, 0f);
                                                        } else {
                                                            phi_3702_ = _e1760;
                                                        }
                                                        let _e1771 = phi_3702_;
                                                        phi_3709_ = select(true, false, (_e1771.member_1 != 4294967295u));
                                                    } else {
                                                        phi_3709_ = false;
                                                    }
                                                    let _e1776 = phi_3709_;
                                                    continue;
                                                    continuing {
                                                        phi_3025_ = _e1172;
                                                        phi_5205_ = _e1147;
                                                        phi_3868_ = select(true, false, _e1178);
                                                        break if !(_e1776);
                                                    }
                                                }
                                                let _e1780 = phi_5205_;
                                                let _e1782 = phi_3868_;
                                                phi_5314_ = _e1780;
                                                phi_3869_ = bool();
                                                if _e1780 {
                                                    break;
                                                }
                                                phi_5316_ = _e1780;
                                                phi_3714_ = _e1151;
                                                phi_3715_ = _e1782;
                                            }
                                            let _e2020 = phi_5316_;
                                            let _e2022 = phi_3714_;
                                            let _e2024 = phi_3715_;
                                            if _e2024 {
                                                let _e2025 = (_e2022 == 0u);
                                                if _e2025 {
                                                    phi_3731_ = u32();
                                                    phi_3732_ = u32();
                                                } else {
                                                    let _e2026 = (_e2022 - 1u);
                                                    if (_e2026 < 64u) {
                                                    } else {
                                                        phi_5314_ = true;
                                                        phi_3869_ = bool();
                                                        break;
                                                    }
                                                    let _e2029 = local[_e2026];
                                                    phi_3731_ = _e2029;
                                                    phi_3732_ = _e2026;
                                                }
                                                let _e2031 = phi_3731_;
                                                let _e2033 = phi_3732_;
                                                phi_2596_ = _e2031;
                                                phi_2599_ = _e2033;
                                                phi_3734_ = select(true, false, _e2025);
                                                phi_3735_ = _e2025;
                                            } else {
                                                phi_2596_ = u32();
                                                phi_2599_ = u32();
                                                phi_3734_ = false;
                                                phi_3735_ = false;
                                            }
                                            let _e2036 = phi_2596_;
                                            let _e2038 = phi_2599_;
                                            let _e2040 = phi_3734_;
                                            let _e2042 = phi_3735_;
                                            continue;
                                            continuing {
                                                phi_5209_ = _e2020;
                                                phi_2595_ = _e2036;
                                                phi_2598_ = _e2038;
                                                phi_5314_ = _e2020;
                                                phi_3869_ = _e2042;
                                                break if !(_e2040);
                                            }
                                        }
                                        let _e2045 = phi_5314_;
                                        let _e2047 = phi_3869_;
                                        phi_5374_ = _e2045;
                                        if _e2045 {
                                            break;
                                        }
                                        if select(false, true, select(true, false, _e2047)) {
                                            phi_3748_ = _e431;
                                        } else {
                                            phi_3748_ = (_e431 + _e1014);
                                        }
                                        let _e2052 = phi_3748_;
                                        phi_5376_ = _e2045;
                                        phi_3749_ = _e2052;
                                    } else {
                                        phi_5376_ = _e425;
                                        phi_3749_ = _e431;
                                    }
                                    let _e2054 = phi_5376_;
                                    let _e2056 = phi_3749_;
                                    phi_5375_ = _e2054;
                                    phi_1665_ = select(_e1015, _e429, (_e429 < _e1015));
                                    phi_1667_ = _e2056;
                                    phi_1669_ = (_e433 + _e1014);
                                } else {
                                    phi_5375_ = _e425;
                                    phi_1665_ = f32();
                                    phi_1667_ = f32();
                                    phi_1669_ = f32();
                                }
                                let _e2058 = phi_5375_;
                                let _e2060 = phi_1665_;
                                let _e2062 = phi_1667_;
                                let _e2064 = phi_1669_;
                                continue;
                                continuing {
                                    phi_5231_ = _e2058;
                                    phi_1661_ = _e446;
                                    phi_1664_ = _e2060;
                                    phi_1666_ = _e2062;
                                    phi_1668_ = _e2064;
                                    phi_5374_ = _e2058;
                                    break if !(_e452);
                                }
                            }
                            let _e2067 = phi_5374_;
                            phi_5380_ = _e2067;
                            if _e2067 {
                                break;
                            }
                            let _e2069 = local_5;
                            if (_e2069 <= 0f) {
                                phi_3816_ = vec3<f32>(0f, 0f, 0f);
                            } else {
                                if (_e410.member_1 == 4294967295u) {
                                    let _e2073 = local_6;
                                    phi_3762_ = ((3.1415927f * _e2073) / f32(_e422));
                                } else {
                                    let _e3082 = local_14;
                                    phi_3762_ = _e3082;
                                }
                                let _e2078 = phi_3762_;
                                if _e418 {
                                    if (_e422 == 1u) {
                                        phi_3797_ = f32();
                                        phi_3798_ = true;
                                    } else {
                                        let _e2082 = local_7;
                                        let _e2084 = (_e410.member_3 < (0.01f * _e2082));
                                        if _e2084 {
                                            phi_3796_ = f32();
                                        } else {
                                            let _e2100 = (_e410.member[0] - _e144.member[0]);
                                            let _e2101 = (_e410.member[1] - _e144.member[1]);
                                            let _e2102 = (_e410.member[2] - _e144.member[2]);
                                            let _e2103 = (vec3<f32>(_e410.member[0], _e410.member[1], _e410.member[2]) - _e171);
                                            let _e2104 = (_e410.member_2[0] - _e144.member[0]);
                                            let _e2105 = (_e410.member_2[1] - _e144.member[1]);
                                            let _e2106 = (_e410.member_2[2] - _e144.member[2]);
                                            let _e2107 = (vec3<f32>(_e410.member_2[0], _e410.member_2[1], _e410.member_2[2]) - _e171);
                                            let _e2108 = (_e410.member_4[0] - _e144.member[0]);
                                            let _e2109 = (_e410.member_4[1] - _e144.member[1]);
                                            let _e2110 = (_e410.member_4[2] - _e144.member[2]);
                                            let _e2111 = (vec3<f32>(_e410.member_4[0], _e410.member_4[1], _e410.member_4[2]) - _e171);
                                            let _e2119 = (((_e166.x * _e2100) + (_e166.y * _e2101)) + (_e166.z * _e2102));
                                            let _e2124 = (((_e166.x * _e2104) + (_e166.y * _e2105)) + (_e166.z * _e2106));
                                            let _e2129 = (((_e166.x * _e2108) + (_e166.y * _e2109)) + (_e166.z * _e2110));
                                            let _e2130 = (_e2119 <= 0f);
                                            if _e2130 {
                                                phi_4211_ = select(true, false, (_e2124 <= 0f));
                                            } else {
                                                phi_4211_ = true;
                                            }
                                            let _e2134 = phi_4211_;
                                            if _e2134 {
                                                if _e2130 {
                                                    phi_4222_ = true;
                                                } else {
                                                    phi_4222_ = (_e2124 <= 0f);
                                                }
                                                let _e2137 = phi_4222_;
                                                if _e2137 {
                                                    let _e2142 = (_e2119 / (_e2119 - _e2124));
                                                    let _e2149 = vec3<f32>((_e2100 + ((_e2104 - _e2100) * _e2142)), (_e2101 + ((_e2105 - _e2101) * _e2142)), (_e2102 + ((_e2106 - _e2102) * _e2142)));
                                                    if _e2130 {
                                                        phi_4243_ = type_61(0f, vec3<f32>(0f, 0f, 0f), _e2149);
                                                    } else {
                                                        phi_4243_ = type_61(0f, _e2149, vec3<f32>(0f, 0f, 0f));
                                                    }
                                                    let _e2153 = phi_4243_;
                                                    let _e2154 = vec3(_e2130);
                                                    phi_4247_ = _e2153;
                                                    phi_4248_ = select(_e2149, _e2107, _e2154);
                                                    phi_4249_ = select(_e2103, _e2149, _e2154);
                                                } else {
                                                    phi_4247_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                    phi_4248_ = _e2107;
                                                    phi_4249_ = _e2103;
                                                }
                                                let _e2158 = phi_4247_;
                                                let _e2160 = phi_4248_;
                                                let _e2162 = phi_4249_;
                                                let _e2164 = abs(_e2162.x);
                                                let _e2166 = abs(_e2162.y);
                                                let _e2168 = select(_e2166, _e2164, (_e2164 > _e2166));
                                                let _e2170 = abs(_e2162.z);
                                                let _e2172 = select(_e2170, _e2168, (_e2168 > _e2170));
                                                if (_e2172 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2174 = (_e2172 < 340282350000000000000000000000000000000f);
                                                    if _e2174 {
                                                        let _e2175 = (_e2162.x / _e2172);
                                                        let _e2176 = (_e2162.y / _e2172);
                                                        let _e2177 = (_e2162.z / _e2172);
                                                        let _e2183 = sqrt((((_e2175 * _e2175) + (_e2176 * _e2176)) + (_e2177 * _e2177)));
                                                        phi_4289_ = vec3<f32>((_e2175 / _e2183), (_e2176 / _e2183), (_e2177 / _e2183));
                                                    } else {
                                                        phi_4289_ = vec3<f32>();
                                                    }
                                                    let _e2189 = phi_4289_;
                                                    phi_4292_ = _e2189;
                                                    phi_4293_ = select(true, false, _e2174);
                                                } else {
                                                    phi_4292_ = vec3<f32>();
                                                    phi_4293_ = true;
                                                }
                                                let _e2192 = phi_4292_;
                                                let _e2194 = phi_4293_;
                                                let _e2196 = select(_e2192, vec3<f32>(0f, 0f, 0f), vec3(_e2194));
                                                let _e2198 = abs(_e2160.x);
                                                let _e2200 = abs(_e2160.y);
                                                let _e2202 = select(_e2200, _e2198, (_e2198 > _e2200));
                                                let _e2204 = abs(_e2160.z);
                                                let _e2206 = select(_e2204, _e2202, (_e2202 > _e2204));
                                                if (_e2206 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2208 = (_e2206 < 340282350000000000000000000000000000000f);
                                                    if _e2208 {
                                                        let _e2209 = (_e2160.x / _e2206);
                                                        let _e2210 = (_e2160.y / _e2206);
                                                        let _e2211 = (_e2160.z / _e2206);
                                                        let _e2217 = sqrt((((_e2209 * _e2209) + (_e2210 * _e2210)) + (_e2211 * _e2211)));
                                                        phi_4337_ = vec3<f32>((_e2209 / _e2217), (_e2210 / _e2217), (_e2211 / _e2217));
                                                    } else {
                                                        phi_4337_ = vec3<f32>();
                                                    }
                                                    let _e2223 = phi_4337_;
                                                    phi_4340_ = _e2223;
                                                    phi_4341_ = select(true, false, _e2208);
                                                } else {
                                                    phi_4340_ = vec3<f32>();
                                                    phi_4341_ = true;
                                                }
                                                let _e2226 = phi_4340_;
                                                let _e2228 = phi_4341_;
                                                let _e2230 = select(_e2226, vec3<f32>(0f, 0f, 0f), vec3(_e2228));
                                                let _e2237 = ((_e2196.y * _e2230.z) - (_e2230.y * _e2196.z));
                                                let _e2242 = ((_e2196.z * _e2230.x) - (_e2230.z * _e2196.x));
                                                let _e2245 = ((_e2196.x * _e2230.y) - (_e2230.x * _e2196.y));
                                                let _e2251 = sqrt((((_e2237 * _e2237) + (_e2242 * _e2242)) + (_e2245 * _e2245)));
                                                if (_e2251 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4455_ = 0f;
                                                } else {
                                                    let _e2263 = (((_e2196.x * _e2230.x) + (_e2196.y * _e2230.y)) + (_e2196.z * _e2230.z));
                                                    let _e2264 = abs(_e2263);
                                                    let _e2265 = abs(_e2251);
                                                    let _e2266 = (_e2265 > _e2264);
                                                    let _e2267 = select(_e2264, _e2265, _e2266);
                                                    if (_e2267 > 0f) {
                                                        phi_4408_ = (select(_e2265, _e2264, _e2266) / _e2267);
                                                    } else {
                                                        phi_4408_ = 0f;
                                                    }
                                                    let _e2272 = phi_4408_;
                                                    let _e2273 = (_e2272 > 0.41421357f);
                                                    if _e2273 {
                                                        phi_4416_ = ((_e2272 - 1f) / (_e2272 + 1f));
                                                    } else {
                                                        phi_4416_ = _e2272;
                                                    }
                                                    let _e2278 = phi_4416_;
                                                    let _e2279 = (_e2278 * _e2278);
                                                    let _e2288 = (_e2278 + ((_e2278 * _e2279) * (-0.3333295f + (_e2279 * (0.19977711f + (_e2279 * (-0.13877685f + (_e2279 * 0.080537446f))))))));
                                                    if _e2273 {
                                                        phi_4431_ = (_e2288 + 0.7853982f);
                                                    } else {
                                                        phi_4431_ = _e2288;
                                                    }
                                                    let _e2291 = phi_4431_;
                                                    if _e2266 {
                                                        phi_4437_ = (1.5707964f - _e2291);
                                                    } else {
                                                        phi_4437_ = _e2291;
                                                    }
                                                    let _e2294 = phi_4437_;
                                                    if ((bitcast<u32>(_e2263) & 2147483648u) == 0u) {
                                                        phi_4445_ = _e2294;
                                                    } else {
                                                        phi_4445_ = (3.1415927f - _e2294);
                                                    }
                                                    let _e2300 = phi_4445_;
                                                    phi_4455_ = (((((_e166.x * _e2237) + (_e166.y * _e2242)) + (_e166.z * _e2245)) / _e2251) * bitcast<f32>(((bitcast<u32>(_e2300) & 2147483647u) | (bitcast<u32>(_e2251) & 2147483648u))));
                                                }
                                                let _e2309 = phi_4455_;
                                                phi_4460_ = type_61((_e2158.member + _e2309), _e2158.member_1, _e2158.member_2);
                                            } else {
                                                phi_4460_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                            }
                                            let _e2317 = phi_4460_;
                                            let _e2318 = (_e2124 <= 0f);
                                            if _e2318 {
                                                phi_4470_ = select(true, false, (_e2129 <= 0f));
                                            } else {
                                                phi_4470_ = true;
                                            }
                                            let _e2322 = phi_4470_;
                                            if _e2322 {
                                                if _e2318 {
                                                    phi_4481_ = true;
                                                } else {
                                                    phi_4481_ = (_e2129 <= 0f);
                                                }
                                                let _e2325 = phi_4481_;
                                                if _e2325 {
                                                    let _e2330 = (_e2124 / (_e2124 - _e2129));
                                                    let _e2337 = vec3<f32>((_e2104 + ((_e2108 - _e2104) * _e2330)), (_e2105 + ((_e2109 - _e2105) * _e2330)), (_e2106 + ((_e2110 - _e2106) * _e2330)));
                                                    if _e2318 {
                                                        phi_4502_ = type_61(_e2317.member, _e2317.member_1, _e2337);
                                                    } else {
                                                        phi_4502_ = type_61(_e2317.member, _e2337, _e2317.member_2);
                                                    }
                                                    let _e2347 = phi_4502_;
                                                    let _e2348 = vec3(_e2318);
                                                    phi_4506_ = _e2347;
                                                    phi_4507_ = select(_e2337, _e2111, _e2348);
                                                    phi_4508_ = select(_e2107, _e2337, _e2348);
                                                } else {
                                                    phi_4506_ = _e2317;
                                                    phi_4507_ = _e2111;
                                                    phi_4508_ = _e2107;
                                                }
                                                let _e2352 = phi_4506_;
                                                let _e2354 = phi_4507_;
                                                let _e2356 = phi_4508_;
                                                let _e2358 = abs(_e2356.x);
                                                let _e2360 = abs(_e2356.y);
                                                let _e2362 = select(_e2360, _e2358, (_e2358 > _e2360));
                                                let _e2364 = abs(_e2356.z);
                                                let _e2366 = select(_e2364, _e2362, (_e2362 > _e2364));
                                                if (_e2366 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2368 = (_e2366 < 340282350000000000000000000000000000000f);
                                                    if _e2368 {
                                                        let _e2369 = (_e2356.x / _e2366);
                                                        let _e2370 = (_e2356.y / _e2366);
                                                        let _e2371 = (_e2356.z / _e2366);
                                                        let _e2377 = sqrt((((_e2369 * _e2369) + (_e2370 * _e2370)) + (_e2371 * _e2371)));
                                                        phi_4548_ = vec3<f32>((_e2369 / _e2377), (_e2370 / _e2377), (_e2371 / _e2377));
                                                    } else {
                                                        phi_4548_ = vec3<f32>();
                                                    }
                                                    let _e2383 = phi_4548_;
                                                    phi_4551_ = _e2383;
                                                    phi_4552_ = select(true, false, _e2368);
                                                } else {
                                                    phi_4551_ = vec3<f32>();
                                                    phi_4552_ = true;
                                                }
                                                let _e2386 = phi_4551_;
                                                let _e2388 = phi_4552_;
                                                let _e2390 = select(_e2386, vec3<f32>(0f, 0f, 0f), vec3(_e2388));
                                                let _e2392 = abs(_e2354.x);
                                                let _e2394 = abs(_e2354.y);
                                                let _e2396 = select(_e2394, _e2392, (_e2392 > _e2394));
                                                let _e2398 = abs(_e2354.z);
                                                let _e2400 = select(_e2398, _e2396, (_e2396 > _e2398));
                                                if (_e2400 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2402 = (_e2400 < 340282350000000000000000000000000000000f);
                                                    if _e2402 {
                                                        let _e2403 = (_e2354.x / _e2400);
                                                        let _e2404 = (_e2354.y / _e2400);
                                                        let _e2405 = (_e2354.z / _e2400);
                                                        let _e2411 = sqrt((((_e2403 * _e2403) + (_e2404 * _e2404)) + (_e2405 * _e2405)));
                                                        phi_4596_ = vec3<f32>((_e2403 / _e2411), (_e2404 / _e2411), (_e2405 / _e2411));
                                                    } else {
                                                        phi_4596_ = vec3<f32>();
                                                    }
                                                    let _e2417 = phi_4596_;
                                                    phi_4599_ = _e2417;
                                                    phi_4600_ = select(true, false, _e2402);
                                                } else {
                                                    phi_4599_ = vec3<f32>();
                                                    phi_4600_ = true;
                                                }
                                                let _e2420 = phi_4599_;
                                                let _e2422 = phi_4600_;
                                                let _e2424 = select(_e2420, vec3<f32>(0f, 0f, 0f), vec3(_e2422));
                                                let _e2431 = ((_e2390.y * _e2424.z) - (_e2424.y * _e2390.z));
                                                let _e2436 = ((_e2390.z * _e2424.x) - (_e2424.z * _e2390.x));
                                                let _e2439 = ((_e2390.x * _e2424.y) - (_e2424.x * _e2390.y));
                                                let _e2445 = sqrt((((_e2431 * _e2431) + (_e2436 * _e2436)) + (_e2439 * _e2439)));
                                                if (_e2445 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4714_ = 0f;
                                                } else {
                                                    let _e2457 = (((_e2390.x * _e2424.x) + (_e2390.y * _e2424.y)) + (_e2390.z * _e2424.z));
                                                    let _e2458 = abs(_e2457);
                                                    let _e2459 = abs(_e2445);
                                                    let _e2460 = (_e2459 > _e2458);
                                                    let _e2461 = select(_e2458, _e2459, _e2460);
                                                    if (_e2461 > 0f) {
                                                        phi_4667_ = (select(_e2459, _e2458, _e2460) / _e2461);
                                                    } else {
                                                        phi_4667_ = 0f;
                                                    }
                                                    let _e2466 = phi_4667_;
                                                    let _e2467 = (_e2466 > 0.41421357f);
                                                    if _e2467 {
                                                        phi_4675_ = ((_e2466 - 1f) / (_e2466 + 1f));
                                                    } else {
                                                        phi_4675_ = _e2466;
                                                    }
                                                    let _e2472 = phi_4675_;
                                                    let _e2473 = (_e2472 * _e2472);
                                                    let _e2482 = (_e2472 + ((_e2472 * _e2473) * (-0.3333295f + (_e2473 * (0.19977711f + (_e2473 * (-0.13877685f + (_e2473 * 0.080537446f))))))));
                                                    if _e2467 {
                                                        phi_4690_ = (_e2482 + 0.7853982f);
                                                    } else {
                                                        phi_4690_ = _e2482;
                                                    }
                                                    let _e2485 = phi_4690_;
                                                    if _e2460 {
                                                        phi_4696_ = (1.5707964f - _e2485);
                                                    } else {
                                                        phi_4696_ = _e2485;
                                                    }
                                                    let _e2488 = phi_4696_;
                                                    if ((bitcast<u32>(_e2457) & 2147483648u) == 0u) {
                                                        phi_4704_ = _e2488;
                                                    } else {
                                                        phi_4704_ = (3.1415927f - _e2488);
                                                    }
                                                    let _e2494 = phi_4704_;
                                                    phi_4714_ = (((((_e166.x * _e2431) + (_e166.y * _e2436)) + (_e166.z * _e2439)) / _e2445) * bitcast<f32>(((bitcast<u32>(_e2494) & 2147483647u) | (bitcast<u32>(_e2445) & 2147483648u))));
                                                }
                                                let _e2503 = phi_4714_;
                                                phi_4719_ = type_61((_e2352.member + _e2503), _e2352.member_1, _e2352.member_2);
                                            } else {
                                                phi_4719_ = _e2317;
                                            }
                                            let _e2511 = phi_4719_;
                                            let _e2512 = (_e2129 <= 0f);
                                            if _e2512 {
                                                phi_4729_ = select(true, false, _e2130);
                                            } else {
                                                phi_4729_ = true;
                                            }
                                            let _e2515 = phi_4729_;
                                            if _e2515 {
                                                if select(_e2130, true, _e2512) {
                                                    let _e2521 = (_e2129 / (_e2129 - _e2119));
                                                    let _e2528 = vec3<f32>((_e2108 + ((_e2100 - _e2108) * _e2521)), (_e2109 + ((_e2101 - _e2109) * _e2521)), (_e2110 + ((_e2102 - _e2110) * _e2521)));
                                                    if _e2512 {
                                                        phi_4761_ = type_61(_e2511.member, _e2511.member_1, _e2528);
                                                    } else {
                                                        phi_4761_ = type_61(_e2511.member, _e2528, _e2511.member_2);
                                                    }
                                                    let _e2538 = phi_4761_;
                                                    let _e2539 = vec3(_e2512);
                                                    phi_4765_ = _e2538;
                                                    phi_4766_ = select(_e2528, _e2103, _e2539);
                                                    phi_4767_ = select(_e2111, _e2528, _e2539);
                                                } else {
                                                    phi_4765_ = _e2511;
                                                    phi_4766_ = _e2103;
                                                    phi_4767_ = _e2111;
                                                }
                                                let _e2543 = phi_4765_;
                                                let _e2545 = phi_4766_;
                                                let _e2547 = phi_4767_;
                                                let _e2549 = abs(_e2547.x);
                                                let _e2551 = abs(_e2547.y);
                                                let _e2553 = select(_e2551, _e2549, (_e2549 > _e2551));
                                                let _e2555 = abs(_e2547.z);
                                                let _e2557 = select(_e2555, _e2553, (_e2553 > _e2555));
                                                if (_e2557 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2559 = (_e2557 < 340282350000000000000000000000000000000f);
                                                    if _e2559 {
                                                        let _e2560 = (_e2547.x / _e2557);
                                                        let _e2561 = (_e2547.y / _e2557);
                                                        let _e2562 = (_e2547.z / _e2557);
                                                        let _e2568 = sqrt((((_e2560 * _e2560) + (_e2561 * _e2561)) + (_e2562 * _e2562)));
                                                        phi_4807_ = vec3<f32>((_e2560 / _e2568), (_e2561 / _e2568), (_e2562 / _e2568));
                                                    } else {
                                                        phi_4807_ = vec3<f32>();
                                                    }
                                                    let _e2574 = phi_4807_;
                                                    phi_4810_ = _e2574;
                                                    phi_4811_ = select(true, false, _e2559);
                                                } else {
                                                    phi_4810_ = vec3<f32>();
                                                    phi_4811_ = true;
                                                }
                                                let _e2577 = phi_4810_;
                                                let _e2579 = phi_4811_;
                                                let _e2581 = select(_e2577, vec3<f32>(0f, 0f, 0f), vec3(_e2579));
                                                let _e2583 = abs(_e2545.x);
                                                let _e2585 = abs(_e2545.y);
                                                let _e2587 = select(_e2585, _e2583, (_e2583 > _e2585));
                                                let _e2589 = abs(_e2545.z);
                                                let _e2591 = select(_e2589, _e2587, (_e2587 > _e2589));
                                                if (_e2591 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2593 = (_e2591 < 340282350000000000000000000000000000000f);
                                                    if _e2593 {
                                                        let _e2594 = (_e2545.x / _e2591);
                                                        let _e2595 = (_e2545.y / _e2591);
                                                        let _e2596 = (_e2545.z / _e2591);
                                                        let _e2602 = sqrt((((_e2594 * _e2594) + (_e2595 * _e2595)) + (_e2596 * _e2596)));
                                                        phi_4855_ = vec3<f32>((_e2594 / _e2602), (_e2595 / _e2602), (_e2596 / _e2602));
                                                    } else {
                                                        phi_4855_ = vec3<f32>();
                                                    }
                                                    let _e2608 = phi_4855_;
                                                    phi_4858_ = _e2608;
                                                    phi_4859_ = select(true, false, _e2593);
                                                } else {
                                                    phi_4858_ = vec3<f32>();
                                                    phi_4859_ = true;
                                                }
                                                let _e2611 = phi_4858_;
                                                let _e2613 = phi_4859_;
                                                let _e2615 = select(_e2611, vec3<f32>(0f, 0f, 0f), vec3(_e2613));
                                                let _e2622 = ((_e2581.y * _e2615.z) - (_e2615.y * _e2581.z));
                                                let _e2627 = ((_e2581.z * _e2615.x) - (_e2615.z * _e2581.x));
                                                let _e2630 = ((_e2581.x * _e2615.y) - (_e2615.x * _e2581.y));
                                                let _e2636 = sqrt((((_e2622 * _e2622) + (_e2627 * _e2627)) + (_e2630 * _e2630)));
                                                if (_e2636 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_4973_ = 0f;
                                                } else {
                                                    let _e2648 = (((_e2581.x * _e2615.x) + (_e2581.y * _e2615.y)) + (_e2581.z * _e2615.z));
                                                    let _e2649 = abs(_e2648);
                                                    let _e2650 = abs(_e2636);
                                                    let _e2651 = (_e2650 > _e2649);
                                                    let _e2652 = select(_e2649, _e2650, _e2651);
                                                    if (_e2652 > 0f) {
                                                        phi_4926_ = (select(_e2650, _e2649, _e2651) / _e2652);
                                                    } else {
                                                        phi_4926_ = 0f;
                                                    }
                                                    let _e2657 = phi_4926_;
                                                    let _e2658 = (_e2657 > 0.41421357f);
                                                    if _e2658 {
                                                        phi_4934_ = ((_e2657 - 1f) / (_e2657 + 1f));
                                                    } else {
                                                        phi_4934_ = _e2657;
                                                    }
                                                    let _e2663 = phi_4934_;
                                                    let _e2664 = (_e2663 * _e2663);
                                                    let _e2673 = (_e2663 + ((_e2663 * _e2664) * (-0.3333295f + (_e2664 * (0.19977711f + (_e2664 * (-0.13877685f + (_e2664 * 0.080537446f))))))));
                                                    if _e2658 {
                                                        phi_4949_ = (_e2673 + 0.7853982f);
                                                    } else {
                                                        phi_4949_ = _e2673;
                                                    }
                                                    let _e2676 = phi_4949_;
                                                    if _e2651 {
                                                        phi_4955_ = (1.5707964f - _e2676);
                                                    } else {
                                                        phi_4955_ = _e2676;
                                                    }
                                                    let _e2679 = phi_4955_;
                                                    if ((bitcast<u32>(_e2648) & 2147483648u) == 0u) {
                                                        phi_4963_ = _e2679;
                                                    } else {
                                                        phi_4963_ = (3.1415927f - _e2679);
                                                    }
                                                    let _e2685 = phi_4963_;
                                                    phi_4973_ = (((((_e166.x * _e2622) + (_e166.y * _e2627)) + (_e166.z * _e2630)) / _e2636) * bitcast<f32>(((bitcast<u32>(_e2685) & 2147483647u) | (bitcast<u32>(_e2636) & 2147483648u))));
                                                }
                                                let _e2694 = phi_4973_;
                                                phi_4978_ = type_61((_e2543.member + _e2694), _e2543.member_1, _e2543.member_2);
                                            } else {
                                                phi_4978_ = _e2511;
                                            }
                                            let _e2702 = phi_4978_;
                                            let _e2706 = abs(_e2702.member_1.x);
                                            let _e2708 = abs(_e2702.member_1.y);
                                            let _e2710 = select(_e2708, _e2706, (_e2706 > _e2708));
                                            let _e2712 = abs(_e2702.member_1.z);
                                            let _e2714 = select(_e2712, _e2710, (_e2710 > _e2712));
                                            if (_e2714 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e2716 = (_e2714 < 340282350000000000000000000000000000000f);
                                                if _e2716 {
                                                    let _e2717 = (_e2702.member_1.x / _e2714);
                                                    let _e2718 = (_e2702.member_1.y / _e2714);
                                                    let _e2719 = (_e2702.member_1.z / _e2714);
                                                    let _e2725 = sqrt((((_e2717 * _e2717) + (_e2718 * _e2718)) + (_e2719 * _e2719)));
                                                    phi_5020_ = vec3<f32>((_e2717 / _e2725), (_e2718 / _e2725), (_e2719 / _e2725));
                                                } else {
                                                    phi_5020_ = vec3<f32>();
                                                }
                                                let _e2731 = phi_5020_;
                                                phi_5023_ = _e2731;
                                                phi_5024_ = select(true, false, _e2716);
                                            } else {
                                                phi_5023_ = vec3<f32>();
                                                phi_5024_ = true;
                                            }
                                            let _e2734 = phi_5023_;
                                            let _e2736 = phi_5024_;
                                            let _e2738 = select(_e2734, vec3<f32>(0f, 0f, 0f), vec3(_e2736));
                                            let _e2740 = abs(_e2702.member_2.x);
                                            let _e2742 = abs(_e2702.member_2.y);
                                            let _e2744 = select(_e2742, _e2740, (_e2740 > _e2742));
                                            let _e2746 = abs(_e2702.member_2.z);
                                            let _e2748 = select(_e2746, _e2744, (_e2744 > _e2746));
                                            if (_e2748 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e2750 = (_e2748 < 340282350000000000000000000000000000000f);
                                                if _e2750 {
                                                    let _e2751 = (_e2702.member_2.x / _e2748);
                                                    let _e2752 = (_e2702.member_2.y / _e2748);
                                                    let _e2753 = (_e2702.member_2.z / _e2748);
                                                    let _e2759 = sqrt((((_e2751 * _e2751) + (_e2752 * _e2752)) + (_e2753 * _e2753)));
                                                    phi_5068_ = vec3<f32>((_e2751 / _e2759), (_e2752 / _e2759), (_e2753 / _e2759));
                                                } else {
                                                    phi_5068_ = vec3<f32>();
                                                }
                                                let _e2765 = phi_5068_;
                                                phi_5071_ = _e2765;
                                                phi_5072_ = select(true, false, _e2750);
                                            } else {
                                                phi_5071_ = vec3<f32>();
                                                phi_5072_ = true;
                                            }
                                            let _e2768 = phi_5071_;
                                            let _e2770 = phi_5072_;
                                            let _e2772 = select(_e2768, vec3<f32>(0f, 0f, 0f), vec3(_e2770));
                                            let _e2779 = ((_e2738.y * _e2772.z) - (_e2772.y * _e2738.z));
                                            let _e2784 = ((_e2738.z * _e2772.x) - (_e2772.z * _e2738.x));
                                            let _e2787 = ((_e2738.x * _e2772.y) - (_e2772.x * _e2738.y));
                                            let _e2793 = sqrt((((_e2779 * _e2779) + (_e2784 * _e2784)) + (_e2787 * _e2787)));
                                            if (_e2793 <= 0.000000000000000000000000000000000000011754944f) {
                                                phi_5186_ = 0f;
                                            } else {
                                                let _e2805 = (((_e2738.x * _e2772.x) + (_e2738.y * _e2772.y)) + (_e2738.z * _e2772.z));
                                                let _e2806 = abs(_e2805);
                                                let _e2807 = abs(_e2793);
                                                let _e2808 = (_e2807 > _e2806);
                                                let _e2809 = select(_e2806, _e2807, _e2808);
                                                if (_e2809 > 0f) {
                                                    phi_5139_ = (select(_e2807, _e2806, _e2808) / _e2809);
                                                } else {
                                                    phi_5139_ = 0f;
                                                }
                                                let _e2814 = phi_5139_;
                                                let _e2815 = (_e2814 > 0.41421357f);
                                                if _e2815 {
                                                    phi_5147_ = ((_e2814 - 1f) / (_e2814 + 1f));
                                                } else {
                                                    phi_5147_ = _e2814;
                                                }
                                                let _e2820 = phi_5147_;
                                                let _e2821 = (_e2820 * _e2820);
                                                let _e2830 = (_e2820 + ((_e2820 * _e2821) * (-0.3333295f + (_e2821 * (0.19977711f + (_e2821 * (-0.13877685f + (_e2821 * 0.080537446f))))))));
                                                if _e2815 {
                                                    phi_5162_ = (_e2830 + 0.7853982f);
                                                } else {
                                                    phi_5162_ = _e2830;
                                                }
                                                let _e2833 = phi_5162_;
                                                if _e2808 {
                                                    phi_5168_ = (1.5707964f - _e2833);
                                                } else {
                                                    phi_5168_ = _e2833;
                                                }
                                                let _e2836 = phi_5168_;
                                                if ((bitcast<u32>(_e2805) & 2147483648u) == 0u) {
                                                    phi_5176_ = _e2836;
                                                } else {
                                                    phi_5176_ = (3.1415927f - _e2836);
                                                }
                                                let _e2842 = phi_5176_;
                                                phi_5186_ = (((((_e166.x * _e2779) + (_e166.y * _e2784)) + (_e166.z * _e2787)) / _e2793) * bitcast<f32>(((bitcast<u32>(_e2842) & 2147483647u) | (bitcast<u32>(_e2793) & 2147483648u))));
                                            }
                                            let _e2851 = phi_5186_;
                                            let _e2857 = local_8;
                                            let _e2859 = local_9;
                                            phi_3796_ = ((abs((_e2702.member + _e2851)) * 0.5f) * (_e2857 / _e2859));
                                        }
                                        let _e2863 = phi_3796_;
                                        phi_3797_ = _e2863;
                                        phi_3798_ = _e2084;
                                    }
                                    let _e2865 = phi_3797_;
                                    let _e2867 = phi_3798_;
                                    if _e2867 {
                                        let _e2870 = local_10;
                                        phi_3806_ = ((_e2870 * _e410.member_3) / f32(_e422));
                                    } else {
                                        phi_3806_ = _e2865;
                                    }
                                    let _e2875 = phi_3806_;
                                    phi_3807_ = _e2875;
                                } else {
                                    phi_3807_ = _e2078;
                                }
                                let _e2877 = phi_3807_;
                                phi_3816_ = vec3<f32>((_e410.member_6[0] * _e2877), (_e410.member_6[1] * _e2877), (_e410.member_6[2] * _e2877));
                            }
                            let _e2887 = phi_3816_;
                            phi_5382_ = _e2067;
                            phi_3832_ = vec3<f32>((_e269.x + (_e2887.x * _e415)), (_e269.y + (_e2887.y * _e415)), (_e269.z + (_e2887.z * _e415)));
                        } else {
                            phi_5382_ = _e368;
                            phi_3832_ = _e269;
                        }
                        let _e2902 = phi_5382_;
                        let _e2904 = phi_3832_;
                        phi_5381_ = _e2902;
                        phi_1479_ = _e2904;
                    } else {
                        phi_5381_ = _e265;
                        phi_1479_ = vec3<f32>();
                    }
                    let _e2906 = phi_5381_;
                    let _e2908 = phi_1479_;
                    continue;
                    continuing {
                        phi_5195_ = _e2906;
                        phi_1475_ = _e282;
                        phi_1478_ = _e2908;
                        phi_5380_ = _e2906;
                        break if !(_e288);
                    }
                }
                let _e2911 = phi_5380_;
                if _e2911 {
                    break;
                }
                let _e2913 = local_11;
                let _e2916 = local_12;
                let _e2919 = local_13;
                if _e139 {
                } else {
                    break;
                }
                out.member[_e138] = vec4<f32>(_e2913.x, _e2916.y, _e2919.z, 0f);
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
