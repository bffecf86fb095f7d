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

struct type_47 {
    member: vec3<f32>,
    member_1: vec3<f32>,
    member_2: f32,
    member_3: f32,
}

struct type_51 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
}

struct type_53 {
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

struct type_55 {
    member: array<vec4<f32>>,
}

struct type_58 {
    member: array<type_53>,
}

struct type_61 {
    member: f32,
    member_1: vec3<f32>,
    member_2: vec3<f32>,
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
var<storage> surfels: type_58;
@group(0) @binding(7) 
var<storage, read_write> irradiance: type_55;

fn function_() {
    var local: array<u32, 64>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var phi_5091_: bool;
    var phi_354_: type_12;
    var phi_357_: vec3<f32>;
    var phi_355_: type_12;
    var phi_380_: type_12;
    var phi_419_: u32;
    var phi_422_: u32;
    var phi_446_: u32;
    var phi_420_: u32;
    var phi_423_: u32;
    var phi_5087_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_463_: f32;
    var phi_5125_: bool;
    var phi_473_: type_35;
    var phi_474_: u32;
    var phi_475_: f32;
    var phi_5124_: bool;
    var phi_477_: type_35;
    var phi_478_: u32;
    var phi_479_: f32;
    var phi_480_: bool;
    var phi_512_: type_35;
    var phi_513_: u32;
    var phi_515_: type_35;
    var phi_516_: u32;
    var phi_517_: u32;
    var phi_533_: bool;
    var phi_5120_: bool;
    var phi_540_: type_12;
    var phi_543_: f32;
    var phi_545_: f32;
    var phi_547_: f32;
    var phi_541_: type_12;
    var phi_570_: type_12;
    var phi_1142_: f32;
    var phi_3773_: f32;
    var phi_3781_: f32;
    var phi_906_: vec2<f32>;
    var phi_907_: bool;
    var phi_1037_: f32;
    var phi_1045_: f32;
    var phi_971_: f32;
    var phi_979_: f32;
    var phi_1049_: vec2<f32>;
    var phi_1050_: vec2<f32>;
    var phi_1143_: vec3<f32>;
    var phi_1144_: f32;
    var phi_1145_: f32;
    var phi_1146_: vec3<f32>;
    var phi_1147_: f32;
    var phi_1148_: bool;
    var phi_1165_: f32;
    var phi_1174_: type_47;
    var phi_649_: vec3<f32>;
    var phi_651_: vec3<f32>;
    var phi_652_: bool;
    var phi_3789_: f32;
    var phi_3797_: f32;
    var phi_726_: vec2<f32>;
    var phi_1176_: f32;
    var phi_1177_: vec3<f32>;
    var phi_1178_: f32;
    var phi_1179_: vec3<f32>;
    var phi_1180_: type_47;
    var phi_1181_: f32;
    var phi_1182_: bool;
    var phi_1199_: f32;
    var phi_1210_: type_47;
    var phi_1243_: bool;
    var phi_1253_: u32;
    var phi_1256_: bool;
    var phi_1267_: u32;
    var phi_1420_: f32;
    var phi_1428_: f32;
    var phi_1436_: f32;
    var phi_5098_: bool;
    var phi_1440_: u32;
    var phi_1443_: u32;
    var phi_1870_: type_12;
    var phi_1871_: type_12;
    var phi_1894_: type_12;
    var phi_2010_: f32;
    var phi_2021_: f32;
    var phi_2032_: f32;
    var phi_2047_: f32;
    var phi_2048_: f32;
    var phi_2049_: bool;
    var phi_2050_: f32;
    var phi_2051_: bool;
    var phi_2070_: f32;
    var phi_2071_: bool;
    var phi_2072_: f32;
    var phi_2073_: bool;
    var phi_2074_: bool;
    var phi_2079_: f32;
    var phi_2080_: bool;
    var phi_2166_: array<f32, 3>;
    var phi_2167_: array<f32, 3>;
    var phi_2168_: array<f32, 3>;
    var phi_2169_: array<f32, 3>;
    var phi_2170_: bool;
    var phi_2171_: array<f32, 3>;
    var phi_2172_: array<f32, 3>;
    var phi_2173_: bool;
    var phi_2174_: bool;
    var phi_2179_: array<f32, 3>;
    var phi_2184_: array<f32, 3>;
    var phi_2395_: u32;
    var phi_2401_: u32;
    var phi_2431_: u32;
    var phi_2437_: u32;
    var phi_2512_: bool;
    var phi_2517_: bool;
    var phi_2522_: type_51;
    var phi_2524_: type_51;
    var phi_2526_: bool;
    var phi_2527_: type_51;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: type_51;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2547_: type_51;
    var phi_2554_: bool;
    var phi_5094_: bool;
    var phi_3764_: bool;
    var phi_1830_: u32;
    var phi_1842_: u32;
    var phi_1854_: u32;
    var phi_1866_: u32;
    var phi_5205_: bool;
    var phi_2559_: u32;
    var phi_2560_: bool;
    var phi_2576_: u32;
    var phi_2577_: u32;
    var phi_1441_: u32;
    var phi_1444_: u32;
    var phi_2579_: bool;
    var phi_2580_: bool;
    var phi_5203_: bool;
    var phi_3765_: bool;
    var phi_2593_: f32;
    var phi_5265_: bool;
    var phi_2594_: f32;
    var phi_5264_: bool;
    var phi_544_: f32;
    var phi_546_: f32;
    var phi_548_: f32;
    var phi_5263_: bool;
    var local_5: f32;
    var local_6: f32;
    var phi_2607_: f32;
    var local_7: f32;
    var phi_4107_: bool;
    var phi_4118_: bool;
    var phi_4139_: type_61;
    var phi_4143_: type_61;
    var phi_4144_: vec3<f32>;
    var phi_4145_: vec3<f32>;
    var phi_4185_: vec3<f32>;
    var phi_4188_: vec3<f32>;
    var phi_4189_: bool;
    var phi_4233_: vec3<f32>;
    var phi_4236_: vec3<f32>;
    var phi_4237_: bool;
    var phi_4304_: f32;
    var phi_4312_: f32;
    var phi_4327_: f32;
    var phi_4333_: f32;
    var phi_4341_: f32;
    var phi_4351_: f32;
    var phi_4356_: type_61;
    var phi_4366_: bool;
    var phi_4377_: bool;
    var phi_4398_: type_61;
    var phi_4402_: type_61;
    var phi_4403_: vec3<f32>;
    var phi_4404_: vec3<f32>;
    var phi_4444_: vec3<f32>;
    var phi_4447_: vec3<f32>;
    var phi_4448_: bool;
    var phi_4492_: vec3<f32>;
    var phi_4495_: vec3<f32>;
    var phi_4496_: bool;
    var phi_4563_: f32;
    var phi_4571_: f32;
    var phi_4586_: f32;
    var phi_4592_: f32;
    var phi_4600_: f32;
    var phi_4610_: f32;
    var phi_4615_: type_61;
    var phi_4625_: bool;
    var phi_4657_: type_61;
    var phi_4661_: type_61;
    var phi_4662_: vec3<f32>;
    var phi_4663_: vec3<f32>;
    var phi_4703_: vec3<f32>;
    var phi_4706_: vec3<f32>;
    var phi_4707_: bool;
    var phi_4751_: vec3<f32>;
    var phi_4754_: vec3<f32>;
    var phi_4755_: bool;
    var phi_4822_: f32;
    var phi_4830_: f32;
    var phi_4845_: f32;
    var phi_4851_: f32;
    var phi_4859_: f32;
    var phi_4869_: f32;
    var phi_4874_: type_61;
    var phi_4916_: vec3<f32>;
    var phi_4919_: vec3<f32>;
    var phi_4920_: bool;
    var phi_4964_: vec3<f32>;
    var phi_4967_: vec3<f32>;
    var phi_4968_: bool;
    var phi_5035_: f32;
    var phi_5043_: f32;
    var phi_5058_: f32;
    var phi_5064_: f32;
    var phi_5072_: f32;
    var phi_5082_: f32;
    var local_8: f32;
    var local_9: f32;
    var phi_2641_: f32;
    var phi_2642_: f32;
    var phi_2643_: bool;
    var local_10: f32;
    var phi_2651_: f32;
    var phi_2652_: f32;
    var phi_2661_: vec3<f32>;
    var phi_5271_: bool;
    var phi_2677_: vec3<f32>;
    var phi_5270_: bool;
    var phi_358_: vec3<f32>;
    var phi_5269_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var phi_2682_: vec4<f32>;
    var local_14: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e113 = gid_1;
            let _e116 = arrayLength((&nodes.member));
            let _e125 = arrayLength((&surfaces.member));
            let _e127 = arrayLength((&lights.member));
            let _e134 = params.member.member_1;
            let _e138 = (_e113.x + (_e113.y * 2097152u));
            if (_e138 < _e134) {
                if (_e138 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e143 = surfels.member[_e138];
                if (_e143.member_1 == 4294967295u) {
                    phi_2682_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e150 = vec3<f32>(_e143.member[0], _e143.member[1], _e143.member[2]);
                    let _e162 = params.member.member_2;
                    let _e165 = params.member.member_3;
                    let _e168 = params.member.member_5;
                    let _e171 = params.member.member;
                    let _e177 = params.member.member_4;
                    let _e180 = params.member.member_6;
                    let _e184 = ((_e138 ^ (_e138 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e188 = ((_e184 ^ (_e184 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e192 = (_e180 ^ (_e188 ^ (_e188 >> bitcast<u32>(16i))));
                    let _e196 = ((_e192 ^ (_e192 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e200 = ((_e196 ^ (_e196 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e203 = (_e200 ^ (_e200 >> bitcast<u32>(16i)));
                    let _e204 = (_e162 > _e168);
                    let _e205 = select(_e162, _e165, _e204);
                    let _e212 = ((_e203 ^ (_e203 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e216 = ((_e212 ^ (_e212 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e219 = (_e216 ^ (_e216 >> bitcast<u32>(16i)));
                    phi_5091_ = false;
                    phi_354_ = type_12(0u, (_e205 + select(0u, 1u, (_e177 > 0u))));
                    phi_357_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e226 = phi_5091_;
                        let _e228 = phi_354_;
                        let _e230 = phi_357_;
                        local_11 = _e230;
                        local_12 = _e230;
                        local_13 = _e230;
                        if (_e228.member < _e228.member_1) {
                            phi_355_ = type_12((_e228.member + 1u), _e228.member_1);
                            phi_380_ = type_12(1u, _e228.member);
                        } else {
                            phi_355_ = _e228;
                            phi_380_ = type_12(0u, type_12().member_1);
                        }
                        let _e243 = phi_355_;
                        let _e245 = phi_380_;
                        let _e249 = (bitcast<i32>(_e245.member) != 0i);
                        if _e249 {
                            let _e255 = ((_e219 ^ (_e219 >> bitcast<u32>(16i))) * 2146121005u);
                            let _e259 = ((_e255 ^ (_e255 >> bitcast<u32>(15i))) * 2221713035u);
                            let _e263 = (_e245.member_1 < _e205);
                            if _e263 {
                                if _e204 {
                                    let _e266 = f32(_e205);
                                    phi_419_ = (_e162 - 1u);
                                    phi_422_ = 0u;
                                    loop {
                                        let _e270 = phi_419_;
                                        let _e272 = phi_422_;
                                        local_3 = _e272;
                                        local_4 = _e272;
                                        let _e273 = (_e272 < _e270);
                                        if _e273 {
                                            let _e275 = ((_e272 + _e270) / 2u);
                                            if (_e275 < _e127) {
                                            } else {
                                                phi_5087_ = true;
                                                break;
                                            }
                                            let _e280 = lights.member[_e275].member_5;
                                            let _e281 = (_e280 > ((f32(_e245.member_1) + (f32((_e219 >> bitcast<u32>(8i))) * 0.000000059604645f)) / _e266));
                                            if _e281 {
                                                phi_446_ = _e272;
                                            } else {
                                                phi_446_ = (_e275 + 1u);
                                            }
                                            let _e284 = phi_446_;
                                            phi_420_ = select(_e270, _e275, _e281);
                                            phi_423_ = _e284;
                                        } else {
                                            phi_420_ = u32();
                                            phi_423_ = u32();
                                        }
                                        let _e287 = phi_420_;
                                        let _e289 = phi_423_;
                                        continue;
                                        continuing {
                                            phi_419_ = _e287;
                                            phi_422_ = _e289;
                                            phi_5087_ = _e226;
                                            break if !(_e273);
                                        }
                                    }
                                    let _e292 = phi_5087_;
                                    phi_5269_ = _e292;
                                    if _e292 {
                                        break;
                                    }
                                    let _e294 = local_3;
                                    if (_e294 < _e127) {
                                    } else {
                                        phi_5269_ = true;
                                        break;
                                    }
                                    let _e298 = local_4;
                                    let _e300 = lights.member[_e298];
                                    if (_e300.member_7 > 0f) {
                                        phi_463_ = (1f / (_e300.member_7 * _e266));
                                    } else {
                                        phi_463_ = 0f;
                                    }
                                    let _e306 = phi_463_;
                                    let _e307 = (_e203 + _e245.member_1);
                                    let _e311 = ((_e307 ^ (_e307 >> bitcast<u32>(16i))) * 2146121005u);
                                    let _e315 = ((_e311 ^ (_e311 >> bitcast<u32>(15i))) * 2221713035u);
                                    phi_5125_ = _e292;
                                    phi_473_ = _e300;
                                    phi_474_ = (_e315 ^ (_e315 >> bitcast<u32>(16i)));
                                    phi_475_ = _e306;
                                } else {
                                    phi_5125_ = _e226;
                                    phi_473_ = type_35();
                                    phi_474_ = u32();
                                    phi_475_ = f32();
                                }
                                let _e320 = phi_5125_;
                                let _e322 = phi_473_;
                                let _e324 = phi_474_;
                                let _e326 = phi_475_;
                                phi_5124_ = _e320;
                                phi_477_ = _e322;
                                phi_478_ = _e324;
                                phi_479_ = _e326;
                                phi_480_ = select(true, false, _e204);
                            } else {
                                phi_5124_ = _e226;
                                phi_477_ = type_35();
                                phi_478_ = u32();
                                phi_479_ = f32();
                                phi_480_ = true;
                            }
                            let _e329 = phi_5124_;
                            let _e331 = phi_477_;
                            let _e333 = phi_478_;
                            let _e335 = phi_479_;
                            let _e337 = phi_480_;
                            if _e337 {
                                if _e263 {
                                    if (_e245.member_1 < _e127) {
                                    } else {
                                        phi_5269_ = true;
                                        break;
                                    }
                                    let _e341 = lights.member[_e245.member_1];
                                    let _e345 = ((_e245.member_1 ^ (_e245.member_1 >> bitcast<u32>(16i))) * 2146121005u);
                                    let _e349 = ((_e345 ^ (_e345 >> bitcast<u32>(15i))) * 2221713035u);
                                    let _e353 = (_e203 ^ (_e349 ^ (_e349 >> bitcast<u32>(16i))));
                                    let _e357 = ((_e353 ^ (_e353 >> bitcast<u32>(16i))) * 2146121005u);
                                    let _e361 = ((_e357 ^ (_e357 >> bitcast<u32>(15i))) * 2221713035u);
                                    phi_512_ = _e341;
                                    phi_513_ = (_e361 ^ (_e361 >> bitcast<u32>(16i)));
                                } else {
                                    phi_512_ = type_35(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(_e171.x, _e171.y, _e171.z), 1f);
                                    phi_513_ = (_e259 ^ (_e259 >> bitcast<u32>(16i)));
                                }
                                let _e366 = phi_512_;
                                let _e368 = phi_513_;
                                phi_515_ = _e366;
                                phi_516_ = _e368;
                                phi_517_ = select(_e177, _e165, _e263);
                            } else {
                                phi_515_ = _e331;
                                phi_516_ = _e333;
                                phi_517_ = 1u;
                            }
                            let _e371 = phi_515_;
                            let _e373 = phi_516_;
                            let _e375 = phi_517_;
                            let _e376 = select(_e335, 1f, _e337);
                            if (_e376 > 0f) {
                                let _e379 = (_e371.member_1 == 3u);
                                if _e379 {
                                    phi_533_ = true;
                                } else {
                                    phi_533_ = (_e371.member_1 == 4294967295u);
                                }
                                let _e382 = phi_533_;
                                let _e383 = select(1u, _e375, _e382);
                                phi_5120_ = _e329;
                                phi_540_ = type_12(0u, _e383);
                                phi_543_ = 340282350000000000000000000000000000000f;
                                phi_545_ = 0f;
                                phi_547_ = 0f;
                                loop {
                                    let _e386 = phi_5120_;
                                    let _e388 = phi_540_;
                                    let _e390 = phi_543_;
                                    let _e392 = phi_545_;
                                    let _e394 = phi_547_;
                                    local_5 = _e392;
                                    local_6 = _e392;
                                    local_14 = _e392;
                                    local_7 = _e390;
                                    local_8 = _e392;
                                    local_9 = _e394;
                                    local_10 = _e392;
                                    if (_e388.member < _e388.member_1) {
                                        phi_541_ = type_12((_e388.member + 1u), _e388.member_1);
                                        phi_570_ = type_12(1u, _e388.member);
                                    } else {
                                        phi_541_ = _e388;
                                        phi_570_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e407 = phi_541_;
                                    let _e409 = phi_570_;
                                    let _e413 = (bitcast<i32>(_e409.member) != 0i);
                                    if _e413 {
                                        let _e423 = (_e371.member[0] - _e143.member[0]);
                                        let _e424 = (_e371.member[1] - _e143.member[1]);
                                        let _e425 = (_e371.member[2] - _e143.member[2]);
                                        if _e379 {
                                            let _e745 = (_e371.member_2[0] - _e371.member[0]);
                                            let _e746 = (_e371.member_2[1] - _e371.member[1]);
                                            let _e747 = (_e371.member_2[2] - _e371.member[2]);
                                            let _e748 = (_e371.member_4[0] - _e371.member[0]);
                                            let _e749 = (_e371.member_4[1] - _e371.member[1]);
                                            let _e750 = (_e371.member_4[2] - _e371.member[2]);
                                            let _e753 = ((_e746 * _e750) - (_e749 * _e747));
                                            let _e756 = ((_e747 * _e748) - (_e750 * _e745));
                                            let _e759 = ((_e745 * _e749) - (_e748 * _e746));
                                            let _e760 = abs(_e753);
                                            let _e761 = abs(_e756);
                                            let _e763 = select(_e761, _e760, (_e760 > _e761));
                                            let _e764 = abs(_e759);
                                            let _e766 = select(_e764, _e763, (_e763 > _e764));
                                            if (_e766 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e768 = (_e766 < 340282350000000000000000000000000000000f);
                                                if _e768 {
                                                    let _e769 = (_e753 / _e766);
                                                    let _e770 = (_e756 / _e766);
                                                    let _e771 = (_e759 / _e766);
                                                    let _e777 = sqrt((((_e769 * _e769) + (_e770 * _e770)) + (_e771 * _e771)));
                                                    phi_649_ = vec3<f32>((_e769 / _e777), (_e770 / _e777), (_e771 / _e777));
                                                } else {
                                                    phi_649_ = vec3<f32>();
                                                }
                                                let _e783 = phi_649_;
                                                phi_651_ = _e783;
                                                phi_652_ = select(true, false, _e768);
                                            } else {
                                                phi_651_ = vec3<f32>();
                                                phi_652_ = true;
                                            }
                                            let _e786 = phi_651_;
                                            let _e788 = phi_652_;
                                            let _e790 = select(_e786, vec3<f32>(0f, 0f, 0f), vec3(_e788));
                                            let _e801 = (((_e790.x * (_e143.member[0] - _e371.member[0])) + (_e790.y * (_e143.member[1] - _e371.member[1]))) + (_e790.z * (_e143.member[2] - _e371.member[2])));
                                            let _e807 = ((_e373 ^ (_e373 >> bitcast<u32>(16i))) * 2146121005u);
                                            let _e811 = ((_e807 ^ (_e807 >> bitcast<u32>(15i))) * 2221713035u);
                                            let _e818 = (_e373 ^ 2654435769u);
                                            let _e822 = ((_e818 ^ (_e818 >> bitcast<u32>(16i))) * 2146121005u);
                                            let _e826 = ((_e822 ^ (_e822 >> bitcast<u32>(15i))) * 2221713035u);
                                            let _e844 = (0.000000059604645f * (f32(((2147483648u + (_e409.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e811 ^ (_e811 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                            if (_e844 >= 1f) {
                                                phi_3789_ = (_e844 - 1f);
                                            } else {
                                                phi_3789_ = _e844;
                                            }
                                            let _e848 = phi_3789_;
                                            let _e850 = (0.000000059604645f * (f32(((2147483648u + (_e409.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e826 ^ (_e826 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                            if (_e850 >= 1f) {
                                                phi_3797_ = (_e850 - 1f);
                                            } else {
                                                phi_3797_ = _e850;
                                            }
                                            let _e854 = phi_3797_;
                                            if (_e848 < _e854) {
                                                let _e859 = (0.5f * _e848);
                                                phi_726_ = vec2<f32>(_e859, (_e854 - _e859));
                                            } else {
                                                let _e856 = (0.5f * _e854);
                                                phi_726_ = vec2<f32>((_e848 - _e856), _e856);
                                            }
                                            let _e863 = phi_726_;
                                            let _e875 = ((_e371.member[0] + (_e745 * _e863.x)) + (_e748 * _e863.y));
                                            let _e876 = ((_e371.member[1] + (_e746 * _e863.x)) + (_e749 * _e863.y));
                                            let _e877 = ((_e371.member[2] + (_e747 * _e863.x)) + (_e750 * _e863.y));
                                            let _e878 = abs(_e875);
                                            let _e879 = abs(_e876);
                                            let _e881 = select(_e879, _e878, (_e878 > _e879));
                                            let _e882 = abs(_e877);
                                            let _e888 = ((select(_e882, _e881, (_e881 > _e882)) + sqrt(_e371.member_3)) * 0.0000009536743f);
                                            let _e892 = (_e875 + (_e790.x * _e888));
                                            let _e893 = (_e876 + (_e790.y * _e888));
                                            let _e894 = (_e877 + (_e790.z * _e888));
                                            let _e900 = (_e875 - _e143.member[0]);
                                            let _e901 = (_e876 - _e143.member[1]);
                                            let _e902 = (_e877 - _e143.member[2]);
                                            let _e907 = (((_e900 * _e900) + (_e901 * _e901)) + (_e902 * _e902));
                                            let _e912 = (((_e143.member_2[0] * _e900) + (_e143.member_2[1] * _e901)) + (_e143.member_2[2] * _e902));
                                            let _e916 = (_e907 * _e907);
                                            phi_1176_ = ((select(0f, _e912, (_e912 > 0f)) * select(0f, _e801, (_e801 > 0f))) / select(0.000000000000000000000000000000000000011754944f, _e916, (_e916 > 0.000000000000000000000000000000000000011754944f)));
                                            phi_1177_ = vec3<f32>((_e892 - _e143.member[0]), (_e893 - _e143.member[1]), (_e894 - _e143.member[2]));
                                            phi_1178_ = _e907;
                                            phi_1179_ = vec3<f32>(_e892, _e893, _e894);
                                            phi_1180_ = type_47();
                                            phi_1181_ = f32();
                                            phi_1182_ = true;
                                        } else {
                                            if (_e371.member_1 == 2u) {
                                                let _e699 = -(_e371.member_2[0]);
                                                let _e700 = -(_e371.member_2[1]);
                                                let _e701 = -(_e371.member_2[2]);
                                                let _e707 = (((_e143.member_2[0] * _e699) + (_e143.member_2[1] * _e700)) + (_e143.member_2[2] * _e701));
                                                phi_1145_ = select(0f, _e707, (_e707 > 0f));
                                                phi_1146_ = vec3<f32>(_e699, _e700, _e701);
                                                phi_1147_ = f32();
                                                phi_1148_ = true;
                                            } else {
                                                let _e428 = (_e371.member_1 == 4294967295u);
                                                if _e428 {
                                                    let _e477 = bitcast<f32>((1065353216u | (bitcast<u32>(_e143.member_2[2]) & 2147483648u)));
                                                    let _e479 = (-1f / (_e477 + _e143.member_2[2]));
                                                    let _e481 = ((_e143.member_2[0] * _e143.member_2[1]) * _e479);
                                                    let _e496 = ((_e373 ^ (_e373 >> bitcast<u32>(16i))) * 2146121005u);
                                                    let _e500 = ((_e496 ^ (_e496 >> bitcast<u32>(15i))) * 2221713035u);
                                                    let _e507 = (_e373 ^ 2654435769u);
                                                    let _e511 = ((_e507 ^ (_e507 >> bitcast<u32>(16i))) * 2146121005u);
                                                    let _e515 = ((_e511 ^ (_e511 >> bitcast<u32>(15i))) * 2221713035u);
                                                    let _e533 = (0.000000059604645f * (f32(((2147483648u + (_e409.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e500 ^ (_e500 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                    if (_e533 >= 1f) {
                                                        phi_3773_ = (_e533 - 1f);
                                                    } else {
                                                        phi_3773_ = _e533;
                                                    }
                                                    let _e537 = phi_3773_;
                                                    let _e539 = (0.000000059604645f * (f32(((2147483648u + (_e409.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e515 ^ (_e515 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                    if (_e539 >= 1f) {
                                                        phi_3781_ = (_e539 - 1f);
                                                    } else {
                                                        phi_3781_ = _e539;
                                                    }
                                                    let _e543 = phi_3781_;
                                                    let _e545 = ((2f * _e537) - 1f);
                                                    let _e547 = ((2f * _e543) - 1f);
                                                    if (_e545 == 0f) {
                                                        let _e549 = (_e547 == 0f);
                                                        phi_906_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e549));
                                                        phi_907_ = select(true, false, _e549);
                                                    } else {
                                                        phi_906_ = vec2<f32>();
                                                        phi_907_ = true;
                                                    }
                                                    let _e554 = phi_906_;
                                                    let _e556 = phi_907_;
                                                    if _e556 {
                                                        if (abs(_e545) > abs(_e547)) {
                                                            let _e613 = (_e547 / _e545);
                                                            let _e617 = floor(((_e613 * 0.5f) + 0.5f));
                                                            let _e623 = ((((0.7853982f * _e613) - (_e617 * 1.5703125f)) - (_e617 * 0.0004837513f)) - (_e617 * 0.0000000754979f));
                                                            let _e624 = (_e623 * _e623);
                                                            let _e631 = (_e623 + ((_e623 * _e624) * (-0.16666655f + (_e624 * (0.008332161f + (_e624 * -0.00019515296f))))));
                                                            let _e640 = ((1f - (0.5f * _e624)) + ((_e624 * _e624) * (0.041666646f + (_e624 * (-0.0013887316f + (_e624 * 0.000024433157f))))));
                                                            let _e647 = select(0i, select(select(i32(_e617), i32(-2147483648), (_e617 < -2147483600f)), 2147483647i, (_e617 > 2147483500f)), (_e617 == _e617));
                                                            let _e649 = ((_e647 & 1i) == 0i);
                                                            let _e650 = select(_e640, _e631, _e649);
                                                            let _e651 = select(_e631, _e640, _e649);
                                                            if ((_e647 & 2i) == 0i) {
                                                                phi_971_ = _e650;
                                                            } else {
                                                                phi_971_ = -(_e650);
                                                            }
                                                            let _e656 = phi_971_;
                                                            if (((_e647 + 1i) & 2i) == 0i) {
                                                                phi_979_ = _e651;
                                                            } else {
                                                                phi_979_ = -(_e651);
                                                            }
                                                            let _e662 = phi_979_;
                                                            phi_1049_ = vec2<f32>((_e545 * _e662), (_e545 * _e656));
                                                        } else {
                                                            let _e560 = (_e545 / _e547);
                                                            let _e564 = floor(((_e560 * 0.5f) + 0.5f));
                                                            let _e570 = ((((0.7853982f * _e560) - (_e564 * 1.5703125f)) - (_e564 * 0.0004837513f)) - (_e564 * 0.0000000754979f));
                                                            let _e571 = (_e570 * _e570);
                                                            let _e578 = (_e570 + ((_e570 * _e571) * (-0.16666655f + (_e571 * (0.008332161f + (_e571 * -0.00019515296f))))));
                                                            let _e587 = ((1f - (0.5f * _e571)) + ((_e571 * _e571) * (0.041666646f + (_e571 * (-0.0013887316f + (_e571 * 0.000024433157f))))));
                                                            let _e594 = select(0i, select(select(i32(_e564), i32(-2147483648), (_e564 < -2147483600f)), 2147483647i, (_e564 > 2147483500f)), (_e564 == _e564));
                                                            let _e596 = ((_e594 & 1i) == 0i);
                                                            let _e597 = select(_e587, _e578, _e596);
                                                            let _e598 = select(_e578, _e587, _e596);
                                                            if ((_e594 & 2i) == 0i) {
                                                                phi_1037_ = _e597;
                                                            } else {
                                                                phi_1037_ = -(_e597);
                                                            }
                                                            let _e603 = phi_1037_;
                                                            if (((_e594 + 1i) & 2i) == 0i) {
                                                                phi_1045_ = _e598;
                                                            } else {
                                                                phi_1045_ = -(_e598);
                                                            }
                                                            let _e609 = phi_1045_;
                                                            phi_1049_ = vec2<f32>((_e547 * _e603), (_e547 * _e609));
                                                        }
                                                        let _e667 = phi_1049_;
                                                        phi_1050_ = _e667;
                                                    } else {
                                                        phi_1050_ = _e554;
                                                    }
                                                    let _e669 = phi_1050_;
                                                    let _e675 = (1f - ((_e669.x * _e669.x) + (_e669.y * _e669.y)));
                                                    let _e678 = sqrt(select(0f, _e675, (_e675 > 0f)));
                                                    phi_1143_ = vec3<f32>(((((1f + (((_e477 * _e143.member_2[0]) * _e143.member_2[0]) * _e479)) * _e669.x) + (_e481 * _e669.y)) + (_e143.member_2[0] * _e678)), ((((_e477 * _e481) * _e669.x) + ((_e477 + ((_e143.member_2[1] * _e143.member_2[1]) * _e479)) * _e669.y)) + (_e143.member_2[1] * _e678)), ((((-(_e477) * _e143.member_2[0]) * _e669.x) + (-(_e143.member_2[1]) * _e669.y)) + (_e143.member_2[2] * _e678)));
                                                    phi_1144_ = f32();
                                                } else {
                                                    let _e434 = sqrt((((_e423 * _e423) + (_e424 * _e424)) + (_e425 * _e425)));
                                                    let _e439 = (((_e143.member_2[0] * _e423) + (_e143.member_2[1] * _e424)) + (_e143.member_2[2] * _e425));
                                                    let _e443 = ((_e434 * _e434) * _e434);
                                                    let _e446 = (select(0f, _e439, (_e439 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e443, (_e443 > 0.000000000000000000000000000000000000011754944f)));
                                                    if (_e371.member_1 == 1u) {
                                                        let _e462 = (_e371.member_4[0] - _e371.member_4[1]);
                                                        let _e465 = (((-((((_e423 * _e371.member_2[0]) + (_e424 * _e371.member_2[1])) + (_e425 * _e371.member_2[2]))) / select(0.000000000000000000000000000000000000011754944f, _e434, (_e434 > 0.000000000000000000000000000000000000011754944f))) - _e371.member_4[1]) / select(0.001f, _e462, (_e462 > 0.001f)));
                                                        let _e467 = select(0f, _e465, (_e465 > 0f));
                                                        let _e469 = select(1f, _e467, (_e467 < 1f));
                                                        phi_1142_ = (_e446 * (_e469 * _e469));
                                                    } else {
                                                        phi_1142_ = _e446;
                                                    }
                                                    let _e473 = phi_1142_;
                                                    phi_1143_ = vec3<f32>();
                                                    phi_1144_ = _e473;
                                                }
                                                let _e696 = phi_1143_;
                                                let _e698 = phi_1144_;
                                                phi_1145_ = 1f;
                                                phi_1146_ = _e696;
                                                phi_1147_ = _e698;
                                                phi_1148_ = _e428;
                                            }
                                            let _e711 = phi_1145_;
                                            let _e713 = phi_1146_;
                                            let _e715 = phi_1147_;
                                            let _e717 = phi_1148_;
                                            if _e717 {
                                                if ((((_e143.member_4[0] * _e713.x) + (_e143.member_4[1] * _e713.y)) + (_e143.member_4[2] * _e713.z)) < 0f) {
                                                    phi_1165_ = -(_e143.member_9);
                                                } else {
                                                    phi_1165_ = _e143.member_9;
                                                }
                                                let _e729 = phi_1165_;
                                                phi_1174_ = type_47(vec3<f32>((_e143.member[0] + (_e143.member_4[0] * _e729)), (_e143.member[1] + (_e143.member_4[1] * _e729)), (_e143.member[2] + (_e143.member_4[2] * _e729))), _e713, 0f, 340282350000000000000000000000000000000f);
                                            } else {
                                                phi_1174_ = type_47();
                                            }
                                            let _e739 = phi_1174_;
                                            phi_1176_ = _e715;
                                            phi_1177_ = vec3<f32>(_e423, _e424, _e425);
                                            phi_1178_ = 340282350000000000000000000000000000000f;
                                            phi_1179_ = vec3<f32>(_e371.member[0], _e371.member[1], _e371.member[2]);
                                            phi_1180_ = _e739;
                                            phi_1181_ = _e711;
                                            phi_1182_ = select(true, false, _e717);
                                        }
                                        let _e921 = phi_1176_;
                                        let _e923 = phi_1177_;
                                        let _e925 = phi_1178_;
                                        let _e927 = phi_1179_;
                                        let _e929 = phi_1180_;
                                        let _e931 = phi_1181_;
                                        let _e933 = phi_1182_;
                                        if _e933 {
                                            if ((((_e143.member_4[0] * _e923.x) + (_e143.member_4[1] * _e923.y)) + (_e143.member_4[2] * _e923.z)) < 0f) {
                                                phi_1199_ = -(_e143.member_9);
                                            } else {
                                                phi_1199_ = _e143.member_9;
                                            }
                                            let _e945 = phi_1199_;
                                            let _e952 = vec3<f32>((_e143.member[0] + (_e143.member_4[0] * _e945)), (_e143.member[1] + (_e143.member_4[1] * _e945)), (_e143.member[2] + (_e143.member_4[2] * _e945)));
                                            phi_1210_ = type_47(_e952, (_e927 - _e952), 0f, 0.9999995f);
                                        } else {
                                            phi_1210_ = _e929;
                                        }
                                        let _e956 = phi_1210_;
                                        let _e957 = select(_e931, _e921, _e933);
                                        let _e958 = select(340282350000000000000000000000000000000f, _e925, _e933);
                                        if (_e957 > 0f) {
                                            let _e965 = abs(_e956.member_1.x);
                                            let _e968 = abs(_e956.member_1.y);
                                            let _e971 = abs(_e956.member_1.z);
                                            let _e972 = (_e965 > _e968);
                                            if _e972 {
                                                phi_1243_ = (_e965 > _e971);
                                            } else {
                                                phi_1243_ = (_e968 > _e971);
                                            }
                                            let _e976 = phi_1243_;
                                            let _e977 = select(1u, 0u, _e972);
                                            if _e976 {
                                                let _e978 = (_e977 + 1u);
                                                phi_1253_ = _e978;
                                                phi_1256_ = select(true, false, (_e978 == 2u));
                                            } else {
                                                phi_1253_ = u32();
                                                phi_1256_ = false;
                                            }
                                            let _e982 = phi_1253_;
                                            let _e984 = phi_1256_;
                                            let _e985 = select(true, false, _e976);
                                            let _e986 = select(_e982, 0u, _e985);
                                            let _e988 = select(_e984, true, _e985);
                                            if _e988 {
                                                phi_1267_ = (_e986 + 1u);
                                            } else {
                                                phi_1267_ = 0u;
                                            }
                                            let _e991 = phi_1267_;
                                            let _e992 = select(_e982, _e986, _e988);
                                            let _e993 = select(_e977, select(_e977, 2u, _e985), _e988);
                                            local_1 = array<f32, 3>(_e956.member_1.x, _e956.member_1.y, _e956.member_1.z);
                                            local_2 = array<f32, 3>(_e956.member.x, _e956.member.y, _e956.member.z);
                                            let _e1002 = (_e993 < 3u);
                                            if _e1002 {
                                            } else {
                                                phi_5263_ = true;
                                                break;
                                            }
                                            let _e1004 = local_1[_e993];
                                            let _e1005 = (1f / _e1004);
                                            let _e1006 = (_e992 < 3u);
                                            if _e1006 {
                                            } else {
                                                phi_5263_ = true;
                                                break;
                                            }
                                            let _e1008 = local_1[_e992];
                                            let _e1009 = (_e1008 * _e1005);
                                            let _e1010 = (_e991 < 3u);
                                            if _e1010 {
                                            } else {
                                                phi_5263_ = true;
                                                break;
                                            }
                                            let _e1012 = local_1[_e991];
                                            let _e1013 = (_e1012 * _e1005);
                                            if _e1006 {
                                            } else {
                                                phi_5263_ = true;
                                                break;
                                            }
                                            let _e1015 = local_2[_e992];
                                            if _e1010 {
                                            } else {
                                                phi_5263_ = true;
                                                break;
                                            }
                                            let _e1017 = local_2[_e991];
                                            if _e1002 {
                                            } else {
                                                phi_5263_ = true;
                                                break;
                                            }
                                            let _e1019 = local_2[_e993];
                                            if (0u < _e116) {
                                            } else {
                                                phi_5263_ = true;
                                                break;
                                            }
                                            let _e1024 = nodes.member[0u].member_7[0u];
                                            let _e1028 = nodes.member[0u].member_7[1u];
                                            let _e1032 = nodes.member[0u].member_7[2u];
                                            let _e1036 = nodes.member[0u].member_7[3u];
                                            let _e1038 = abs((_e956.member.x - _e1024));
                                            let _e1040 = abs((_e956.member.y - _e1028));
                                            let _e1042 = select(_e1040, _e1038, (_e1038 > _e1040));
                                            let _e1044 = abs((_e956.member.z - _e1032));
                                            let _e1048 = ((select(_e1044, _e1042, (_e1042 > _e1044)) + _e1036) * 0.0000009536743f);
                                            let _e1055 = (_e1048 + (abs(_e956.member.x) * 0.00000023841858f));
                                            let _e1056 = (_e1048 + (abs(_e956.member.y) * 0.00000023841858f));
                                            let _e1057 = (_e1048 + (abs(_e956.member.z) * 0.00000023841858f));
                                            let _e1058 = select(_e968, _e965, _e972);
                                            let _e1060 = select(_e971, _e1058, (_e1058 > _e971));
                                            let _e1061 = (_e1060 * 0.000000000001f);
                                            let _e1064 = (_e956.member.x + _e1055);
                                            let _e1066 = (_e956.member.y + _e1056);
                                            let _e1068 = (_e956.member.z + _e1057);
                                            let _e1069 = (_e956.member.x - _e1055);
                                            let _e1070 = (_e956.member.y - _e1056);
                                            let _e1071 = (_e956.member.z - _e1057);
                                            if (_e965 > _e1061) {
                                                phi_1420_ = (1f / _e956.member_1.x);
                                            } else {
                                                phi_1420_ = (1000000000000f / _e1060);
                                            }
                                            let _e1076 = phi_1420_;
                                            if (_e968 > _e1061) {
                                                phi_1428_ = (1f / _e956.member_1.y);
                                            } else {
                                                phi_1428_ = (1000000000000f / _e1060);
                                            }
                                            let _e1081 = phi_1428_;
                                            if (_e971 > _e1061) {
                                                phi_1436_ = (1f / _e956.member_1.z);
                                            } else {
                                                phi_1436_ = (1000000000000f / _e1060);
                                            }
                                            let _e1086 = phi_1436_;
                                            local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                            phi_5098_ = _e386;
                                            phi_1440_ = 0u;
                                            phi_1443_ = 0u;
                                            loop {
                                                let _e1090 = phi_5098_;
                                                let _e1092 = phi_1440_;
                                                let _e1094 = phi_1443_;
                                                let _e1095 = (_e1092 & 15u);
                                                let _e1097 = (_e1092 >> bitcast<u32>(4u));
                                                if (_e1095 == 0u) {
                                                    if (_e1097 < _e116) {
                                                    } else {
                                                        phi_5203_ = true;
                                                        phi_3765_ = bool();
                                                        break;
                                                    }
                                                    let _e1730 = nodes.member[_e1097].member;
                                                    let _e1739 = ((_e1730.x - _e1064) * _e1076);
                                                    let _e1740 = ((_e1730.y - _e1064) * _e1076);
                                                    let _e1741 = ((_e1730.z - _e1064) * _e1076);
                                                    let _e1742 = ((_e1730.w - _e1064) * _e1076);
                                                    let _e1745 = nodes.member[_e1097].member_3;
                                                    let _e1754 = ((_e1745.x - _e1069) * _e1076);
                                                    let _e1755 = ((_e1745.y - _e1069) * _e1076);
                                                    let _e1756 = ((_e1745.z - _e1069) * _e1076);
                                                    let _e1757 = ((_e1745.w - _e1069) * _e1076);
                                                    let _e1760 = nodes.member[_e1097].member_1;
                                                    let _e1769 = ((_e1760.x - _e1066) * _e1081);
                                                    let _e1770 = ((_e1760.y - _e1066) * _e1081);
                                                    let _e1771 = ((_e1760.z - _e1066) * _e1081);
                                                    let _e1772 = ((_e1760.w - _e1066) * _e1081);
                                                    let _e1775 = nodes.member[_e1097].member_4;
                                                    let _e1784 = ((_e1775.x - _e1070) * _e1081);
                                                    let _e1785 = ((_e1775.y - _e1070) * _e1081);
                                                    let _e1786 = ((_e1775.z - _e1070) * _e1081);
                                                    let _e1787 = ((_e1775.w - _e1070) * _e1081);
                                                    let _e1790 = nodes.member[_e1097].member_2;
                                                    let _e1799 = ((_e1790.x - _e1068) * _e1086);
                                                    let _e1800 = ((_e1790.y - _e1068) * _e1086);
                                                    let _e1801 = ((_e1790.z - _e1068) * _e1086);
                                                    let _e1802 = ((_e1790.w - _e1068) * _e1086);
                                                    let _e1805 = nodes.member[_e1097].member_5;
                                                    let _e1814 = ((_e1805.x - _e1071) * _e1086);
                                                    let _e1815 = ((_e1805.y - _e1071) * _e1086);
                                                    let _e1816 = ((_e1805.z - _e1071) * _e1086);
                                                    let _e1817 = ((_e1805.w - _e1071) * _e1086);
                                                    let _e1819 = select(_e1754, _e1739, (_e1739 < _e1754));
                                                    let _e1821 = select(_e1755, _e1740, (_e1740 < _e1755));
                                                    let _e1823 = select(_e1756, _e1741, (_e1741 < _e1756));
                                                    let _e1825 = select(_e1757, _e1742, (_e1742 < _e1757));
                                                    let _e1827 = select(_e1784, _e1769, (_e1769 < _e1784));
                                                    let _e1829 = select(_e1785, _e1770, (_e1770 < _e1785));
                                                    let _e1831 = select(_e1786, _e1771, (_e1771 < _e1786));
                                                    let _e1833 = select(_e1787, _e1772, (_e1772 < _e1787));
                                                    let _e1835 = select(_e1827, _e1819, (_e1819 > _e1827));
                                                    let _e1837 = select(_e1829, _e1821, (_e1821 > _e1829));
                                                    let _e1839 = select(_e1831, _e1823, (_e1823 > _e1831));
                                                    let _e1841 = select(_e1833, _e1825, (_e1825 > _e1833));
                                                    let _e1843 = select(_e1814, _e1799, (_e1799 < _e1814));
                                                    let _e1845 = select(_e1815, _e1800, (_e1800 < _e1815));
                                                    let _e1847 = select(_e1816, _e1801, (_e1801 < _e1816));
                                                    let _e1849 = select(_e1817, _e1802, (_e1802 < _e1817));
                                                    let _e1851 = select(_e1843, _e1835, (_e1835 > _e1843));
                                                    let _e1853 = select(_e1845, _e1837, (_e1837 > _e1845));
                                                    let _e1855 = select(_e1847, _e1839, (_e1839 > _e1847));
                                                    let _e1857 = select(_e1849, _e1841, (_e1841 > _e1849));
                                                    let _e1859 = select(_e956.member_2, _e1851, (_e1851 > _e956.member_2));
                                                    let _e1861 = select(_e956.member_2, _e1853, (_e1853 > _e956.member_2));
                                                    let _e1863 = select(_e956.member_2, _e1855, (_e1855 > _e956.member_2));
                                                    let _e1865 = select(_e956.member_2, _e1857, (_e1857 > _e956.member_2));
                                                    let _e1867 = select(_e1754, _e1739, (_e1739 > _e1754));
                                                    let _e1869 = select(_e1755, _e1740, (_e1740 > _e1755));
                                                    let _e1871 = select(_e1756, _e1741, (_e1741 > _e1756));
                                                    let _e1873 = select(_e1757, _e1742, (_e1742 > _e1757));
                                                    let _e1875 = select(_e1784, _e1769, (_e1769 > _e1784));
                                                    let _e1877 = select(_e1785, _e1770, (_e1770 > _e1785));
                                                    let _e1879 = select(_e1786, _e1771, (_e1771 > _e1786));
                                                    let _e1881 = select(_e1787, _e1772, (_e1772 > _e1787));
                                                    let _e1883 = select(_e1875, _e1867, (_e1867 < _e1875));
                                                    let _e1885 = select(_e1877, _e1869, (_e1869 < _e1877));
                                                    let _e1887 = select(_e1879, _e1871, (_e1871 < _e1879));
                                                    let _e1889 = select(_e1881, _e1873, (_e1873 < _e1881));
                                                    let _e1891 = select(_e1814, _e1799, (_e1799 > _e1814));
                                                    let _e1893 = select(_e1815, _e1800, (_e1800 > _e1815));
                                                    let _e1895 = select(_e1816, _e1801, (_e1801 > _e1816));
                                                    let _e1897 = select(_e1817, _e1802, (_e1802 > _e1817));
                                                    let _e1899 = select(_e1891, _e1883, (_e1883 < _e1891));
                                                    let _e1901 = select(_e1893, _e1885, (_e1885 < _e1893));
                                                    let _e1903 = select(_e1895, _e1887, (_e1887 < _e1895));
                                                    let _e1905 = select(_e1897, _e1889, (_e1889 < _e1897));
                                                    let _e1925 = nodes.member[_e1097].member_6[0u];
                                                    let _e1929 = nodes.member[_e1097].member_6[1u];
                                                    let _e1933 = nodes.member[_e1097].member_6[2u];
                                                    let _e1937 = nodes.member[_e1097].member_6[3u];
                                                    if (select(340282350000000000000000000000000000000f, _e1865, (_e1865 <= select(_e956.member_3, _e1905, (_e1905 < _e956.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1094 < 64u) {
                                                        } else {
                                                            phi_5203_ = true;
                                                            phi_3765_ = bool();
                                                            break;
                                                        }
                                                        local[_e1094] = _e1937;
                                                        phi_1830_ = (_e1094 + 1u);
                                                    } else {
                                                        phi_1830_ = _e1094;
                                                    }
                                                    let _e1943 = phi_1830_;
                                                    if (select(340282350000000000000000000000000000000f, _e1863, (_e1863 <= select(_e956.member_3, _e1903, (_e1903 < _e956.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1943 < 64u) {
                                                        } else {
                                                            phi_5203_ = true;
                                                            phi_3765_ = bool();
                                                            break;
                                                        }
                                                        local[_e1943] = _e1933;
                                                        phi_1842_ = (_e1943 + 1u);
                                                    } else {
                                                        phi_1842_ = _e1943;
                                                    }
                                                    let _e1949 = phi_1842_;
                                                    if (select(340282350000000000000000000000000000000f, _e1861, (_e1861 <= select(_e956.member_3, _e1901, (_e1901 < _e956.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1949 < 64u) {
                                                        } else {
                                                            phi_5203_ = true;
                                                            phi_3765_ = bool();
                                                            break;
                                                        }
                                                        local[_e1949] = _e1929;
                                                        phi_1854_ = (_e1949 + 1u);
                                                    } else {
                                                        phi_1854_ = _e1949;
                                                    }
                                                    let _e1955 = phi_1854_;
                                                    if (select(340282350000000000000000000000000000000f, _e1859, (_e1859 <= select(_e956.member_3, _e1899, (_e1899 < _e956.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1955 < 64u) {
                                                        } else {
                                                            phi_5203_ = true;
                                                            phi_3765_ = bool();
                                                            break;
                                                        }
                                                        local[_e1955] = _e1925;
                                                        phi_1866_ = (_e1955 + 1u);
                                                    } else {
                                                        phi_1866_ = _e1955;
                                                    }
                                                    let _e1961 = phi_1866_;
                                                    phi_5205_ = _e1090;
                                                    phi_2559_ = _e1961;
                                                    phi_2560_ = true;
                                                } else {
                                                    phi_1870_ = type_12(_e1097, (_e1097 + _e1095));
                                                    loop {
                                                        let _e1102 = phi_1870_;
                                                        if (_e1102.member < _e1102.member_1) {
                                                            phi_1871_ = type_12((_e1102.member + 1u), _e1102.member_1);
                                                            phi_1894_ = type_12(1u, _e1102.member);
                                                        } else {
                                                            phi_1871_ = _e1102;
                                                            phi_1894_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e1115 = phi_1871_;
                                                        let _e1117 = phi_1894_;
                                                        let _e1121 = (bitcast<i32>(_e1117.member) != 0i);
                                                        if _e1121 {
                                                            let _e1122 = (_e1117.member_1 < arrayLength((&triangles.member)));
                                                            if _e1122 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            if _e1002 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            let _e1126 = triangles.member[_e1117.member_1].member[_e993];
                                                            let _e1127 = (_e1126 - _e1019);
                                                            if _e1002 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            let _e1131 = triangles.member[_e1117.member_1].member_2[_e993];
                                                            let _e1132 = (_e1131 - _e1019);
                                                            if _e1002 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            let _e1136 = triangles.member[_e1117.member_1].member_4[_e993];
                                                            let _e1137 = (_e1136 - _e1019);
                                                            if _e1006 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            let _e1141 = triangles.member[_e1117.member_1].member[_e992];
                                                            let _e1144 = ((_e1141 - _e1015) - (_e1009 * _e1127));
                                                            if _e1010 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            let _e1148 = triangles.member[_e1117.member_1].member[_e991];
                                                            let _e1151 = ((_e1148 - _e1017) - (_e1013 * _e1127));
                                                            if _e1006 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            let _e1155 = triangles.member[_e1117.member_1].member_2[_e992];
                                                            let _e1158 = ((_e1155 - _e1015) - (_e1009 * _e1132));
                                                            if _e1010 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            let _e1162 = triangles.member[_e1117.member_1].member_2[_e991];
                                                            let _e1165 = ((_e1162 - _e1017) - (_e1013 * _e1132));
                                                            if _e1006 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            let _e1169 = triangles.member[_e1117.member_1].member_4[_e992];
                                                            let _e1172 = ((_e1169 - _e1015) - (_e1009 * _e1137));
                                                            if _e1010 {
                                                            } else {
                                                                phi_5094_ = true;
                                                                phi_3764_ = bool();
                                                                break;
                                                            }
                                                            let _e1176 = triangles.member[_e1117.member_1].member_4[_e991];
                                                            let _e1179 = ((_e1176 - _e1017) - (_e1013 * _e1137));
                                                            let _e1180 = (_e1172 * _e1165);
                                                            let _e1181 = (_e1179 * _e1158);
                                                            if (_e1180 != _e1181) {
                                                                phi_2010_ = (_e1180 - _e1181);
                                                            } else {
                                                                let _e1183 = (_e1172 * 4097f);
                                                                let _e1185 = (_e1183 - (_e1183 - _e1172));
                                                                let _e1186 = (_e1165 * 4097f);
                                                                let _e1188 = (_e1186 - (_e1186 - _e1165));
                                                                let _e1189 = (_e1172 - _e1185);
                                                                let _e1190 = (_e1165 - _e1188);
                                                                let _e1199 = (_e1179 * 4097f);
                                                                let _e1201 = (_e1199 - (_e1199 - _e1179));
                                                                let _e1202 = (_e1158 * 4097f);
                                                                let _e1204 = (_e1202 - (_e1202 - _e1158));
                                                                let _e1205 = (_e1179 - _e1201);
                                                                let _e1206 = (_e1158 - _e1204);
                                                                phi_2010_ = ((((((_e1185 * _e1188) - _e1180) + (_e1185 * _e1190)) + (_e1189 * _e1188)) + (_e1189 * _e1190)) - (((((_e1201 * _e1204) - _e1181) + (_e1201 * _e1206)) + (_e1205 * _e1204)) + (_e1205 * _e1206)));
                                                            }
                                                            let _e1218 = phi_2010_;
                                                            let _e1219 = (_e1144 * _e1179);
                                                            let _e1220 = (_e1151 * _e1172);
                                                            if (_e1219 != _e1220) {
                                                                phi_2021_ = (_e1219 - _e1220);
                                                            } else {
                                                                let _e1222 = (_e1144 * 4097f);
                                                                let _e1224 = (_e1222 - (_e1222 - _e1144));
                                                                let _e1225 = (_e1179 * 4097f);
                                                                let _e1227 = (_e1225 - (_e1225 - _e1179));
                                                                let _e1228 = (_e1144 - _e1224);
                                                                let _e1229 = (_e1179 - _e1227);
                                                                let _e1238 = (_e1151 * 4097f);
                                                                let _e1240 = (_e1238 - (_e1238 - _e1151));
                                                                let _e1241 = (_e1172 * 4097f);
                                                                let _e1243 = (_e1241 - (_e1241 - _e1172));
                                                                let _e1244 = (_e1151 - _e1240);
                                                                let _e1245 = (_e1172 - _e1243);
                                                                phi_2021_ = ((((((_e1224 * _e1227) - _e1219) + (_e1224 * _e1229)) + (_e1228 * _e1227)) + (_e1228 * _e1229)) - (((((_e1240 * _e1243) - _e1220) + (_e1240 * _e1245)) + (_e1244 * _e1243)) + (_e1244 * _e1245)));
                                                            }
                                                            let _e1257 = phi_2021_;
                                                            let _e1258 = (_e1158 * _e1151);
                                                            let _e1259 = (_e1165 * _e1144);
                                                            if (_e1258 != _e1259) {
                                                                phi_2032_ = (_e1258 - _e1259);
                                                            } else {
                                                                let _e1261 = (_e1158 * 4097f);
                                                                let _e1263 = (_e1261 - (_e1261 - _e1158));
                                                                let _e1264 = (_e1151 * 4097f);
                                                                let _e1266 = (_e1264 - (_e1264 - _e1151));
                                                                let _e1267 = (_e1158 - _e1263);
                                                                let _e1268 = (_e1151 - _e1266);
                                                                let _e1277 = (_e1165 * 4097f);
                                                                let _e1279 = (_e1277 - (_e1277 - _e1165));
                                                                let _e1280 = (_e1144 * 4097f);
                                                                let _e1282 = (_e1280 - (_e1280 - _e1144));
                                                                let _e1283 = (_e1165 - _e1279);
                                                                let _e1284 = (_e1144 - _e1282);
                                                                phi_2032_ = ((((((_e1263 * _e1266) - _e1258) + (_e1263 * _e1268)) + (_e1267 * _e1266)) + (_e1267 * _e1268)) - (((((_e1279 * _e1282) - _e1259) + (_e1279 * _e1284)) + (_e1283 * _e1282)) + (_e1283 * _e1284)));
                                                            }
                                                            let _e1296 = phi_2032_;
                                                            if (_e1218 < 0f) {
                                                                phi_2050_ = f32();
                                                                phi_2051_ = true;
                                                            } else {
                                                                if (_e1257 < 0f) {
                                                                    phi_2048_ = f32();
                                                                    phi_2049_ = true;
                                                                } else {
                                                                    let _e1299 = (_e1296 < 0f);
                                                                    if _e1299 {
                                                                        phi_2047_ = f32();
                                                                    } else {
                                                                        phi_2047_ = ((_e1218 + _e1257) + _e1296);
                                                                    }
                                                                    let _e1303 = phi_2047_;
                                                                    phi_2048_ = _e1303;
                                                                    phi_2049_ = _e1299;
                                                                }
                                                                let _e1305 = phi_2048_;
                                                                let _e1307 = phi_2049_;
                                                                phi_2050_ = _e1305;
                                                                phi_2051_ = _e1307;
                                                            }
                                                            let _e1309 = phi_2050_;
                                                            let _e1311 = phi_2051_;
                                                            if _e1311 {
                                                                if (_e1218 > 0f) {
                                                                    phi_2072_ = f32();
                                                                    phi_2073_ = true;
                                                                    phi_2074_ = false;
                                                                } else {
                                                                    let _e1313 = (_e1257 > 0f);
                                                                    if _e1313 {
                                                                        phi_2070_ = f32();
                                                                        phi_2071_ = false;
                                                                    } else {
                                                                        phi_2070_ = ((_e1218 + _e1257) + _e1296);
                                                                        phi_2071_ = select(true, false, (_e1296 > 0f));
                                                                    }
                                                                    let _e1319 = phi_2070_;
                                                                    let _e1321 = phi_2071_;
                                                                    phi_2072_ = _e1319;
                                                                    phi_2073_ = _e1313;
                                                                    phi_2074_ = _e1321;
                                                                }
                                                                let _e1323 = phi_2072_;
                                                                let _e1325 = phi_2073_;
                                                                let _e1327 = phi_2074_;
                                                                phi_2079_ = _e1323;
                                                                phi_2080_ = select(_e1327, false, _e1325);
                                                            } else {
                                                                phi_2079_ = _e1309;
                                                                phi_2080_ = true;
                                                            }
                                                            let _e1330 = phi_2079_;
                                                            let _e1332 = phi_2080_;
                                                            if _e1332 {
                                                                let _e1333 = (_e1330 == 0f);
                                                                if _e1333 {
                                                                    phi_2168_ = array<f32, 3>();
                                                                    phi_2169_ = array<f32, 3>();
                                                                    phi_2170_ = false;
                                                                } else {
                                                                    let _e1334 = (_e1127 * _e1005);
                                                                    let _e1335 = (_e1132 * _e1005);
                                                                    let _e1336 = (_e1137 * _e1005);
                                                                    let _e1339 = (1f / ((_e1218 + _e1257) + _e1296));
                                                                    let _e1340 = (_e1257 * _e1339);
                                                                    let _e1341 = (_e1296 * _e1339);
                                                                    let _e1347 = ((((_e1218 * _e1339) * _e1334) + (_e1340 * _e1335)) + (_e1341 * _e1336));
                                                                    let _e1348 = abs(_e1144);
                                                                    let _e1349 = abs(_e1158);
                                                                    let _e1351 = select(_e1349, _e1348, (_e1348 > _e1349));
                                                                    let _e1352 = abs(_e1172);
                                                                    let _e1355 = abs(_e1151);
                                                                    let _e1356 = abs(_e1165);
                                                                    let _e1358 = select(_e1356, _e1355, (_e1355 > _e1356));
                                                                    let _e1359 = abs(_e1179);
                                                                    let _e1363 = abs(_e1334);
                                                                    let _e1364 = abs(_e1335);
                                                                    let _e1366 = select(_e1364, _e1363, (_e1363 > _e1364));
                                                                    let _e1367 = abs(_e1336);
                                                                    let _e1374 = (((select(_e1352, _e1351, (_e1351 > _e1352)) * select(_e1359, _e1358, (_e1358 > _e1359))) * select(_e1367, _e1366, (_e1366 > _e1367))) <= (abs((_e1330 * _e1347)) * 256f));
                                                                    if _e1374 {
                                                                        phi_2166_ = array<f32, 3>(_e1347, _e1340, _e1341);
                                                                        phi_2167_ = array<f32, 3>();
                                                                    } else {
                                                                        let _e1376 = (_e1172 * 4097f);
                                                                        let _e1378 = (_e1376 - (_e1376 - _e1172));
                                                                        let _e1379 = (_e1165 * 4097f);
                                                                        let _e1381 = (_e1379 - (_e1379 - _e1165));
                                                                        let _e1382 = (_e1172 - _e1378);
                                                                        let _e1383 = (_e1165 - _e1381);
                                                                        let _e1392 = (_e1179 * 4097f);
                                                                        let _e1394 = (_e1392 - (_e1392 - _e1179));
                                                                        let _e1395 = (_e1158 * 4097f);
                                                                        let _e1397 = (_e1395 - (_e1395 - _e1158));
                                                                        let _e1398 = (_e1179 - _e1394);
                                                                        let _e1399 = (_e1158 - _e1397);
                                                                        let _e1409 = ((_e1180 - _e1181) + ((((((_e1378 * _e1381) - _e1180) + (_e1378 * _e1383)) + (_e1382 * _e1381)) + (_e1382 * _e1383)) - (((((_e1394 * _e1397) - _e1181) + (_e1394 * _e1399)) + (_e1398 * _e1397)) + (_e1398 * _e1399))));
                                                                        let _e1411 = (_e1144 * 4097f);
                                                                        let _e1413 = (_e1411 - (_e1411 - _e1144));
                                                                        let _e1414 = (_e1144 - _e1413);
                                                                        let _e1423 = (_e1151 * 4097f);
                                                                        let _e1425 = (_e1423 - (_e1423 - _e1151));
                                                                        let _e1426 = (_e1151 - _e1425);
                                                                        let _e1436 = ((_e1219 - _e1220) + ((((((_e1413 * _e1394) - _e1219) + (_e1413 * _e1398)) + (_e1414 * _e1394)) + (_e1414 * _e1398)) - (((((_e1425 * _e1378) - _e1220) + (_e1425 * _e1382)) + (_e1426 * _e1378)) + (_e1426 * _e1382))));
                                                                        let _e1455 = ((_e1258 - _e1259) + ((((((_e1397 * _e1425) - _e1258) + (_e1397 * _e1426)) + (_e1399 * _e1425)) + (_e1399 * _e1426)) - (((((_e1381 * _e1413) - _e1259) + (_e1381 * _e1414)) + (_e1383 * _e1413)) + (_e1383 * _e1414))));
                                                                        let _e1458 = (1f / ((_e1409 + _e1436) + _e1455));
                                                                        let _e1459 = (_e1436 * _e1458);
                                                                        let _e1460 = (_e1455 * _e1458);
                                                                        phi_2166_ = array<f32, 3>();
                                                                        phi_2167_ = array<f32, 3>(((((_e1409 * _e1458) * _e1334) + (_e1459 * _e1335)) + (_e1460 * _e1336)), _e1459, _e1460);
                                                                    }
                                                                    let _e1470 = phi_2166_;
                                                                    let _e1472 = phi_2167_;
                                                                    phi_2168_ = _e1470;
                                                                    phi_2169_ = _e1472;
                                                                    phi_2170_ = _e1374;
                                                                }
                                                                let _e1474 = phi_2168_;
                                                                let _e1476 = phi_2169_;
                                                                let _e1478 = phi_2170_;
                                                                phi_2171_ = _e1474;
                                                                phi_2172_ = _e1476;
                                                                phi_2173_ = _e1333;
                                                                phi_2174_ = _e1478;
                                                            } else {
                                                                phi_2171_ = array<f32, 3>();
                                                                phi_2172_ = array<f32, 3>();
                                                                phi_2173_ = true;
                                                                phi_2174_ = false;
                                                            }
                                                            let _e1480 = phi_2171_;
                                                            let _e1482 = phi_2172_;
                                                            let _e1484 = phi_2173_;
                                                            let _e1486 = phi_2174_;
                                                            if _e1484 {
                                                                phi_2179_ = array<f32, 3>(-1f, 0f, 0f);
                                                            } else {
                                                                phi_2179_ = _e1480;
                                                            }
                                                            let _e1488 = phi_2179_;
                                                            if select(_e1486, true, _e1484) {
                                                                phi_2184_ = _e1488;
                                                            } else {
                                                                phi_2184_ = _e1482;
                                                            }
                                                            let _e1491 = phi_2184_;
                                                            if (_e1491[0] >= _e956.member_2) {
                                                                let _e1497 = (_e1491[0] < _e956.member_3);
                                                                if _e1497 {
                                                                    let _e1498 = (_e1491[0] >= 0f);
                                                                    if _e1498 {
                                                                        if _e1122 {
                                                                        } else {
                                                                            phi_5094_ = true;
                                                                            phi_3764_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1501 = triangles.member[_e1117.member_1].member_3;
                                                                        if ((_e1501 & 1u) == 0u) {
                                                                            phi_2517_ = true;
                                                                        } else {
                                                                            if _e1122 {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1506 = triangles.member[_e1117.member_1].member_1;
                                                                            let _e1507 = (_e1506 * 12u);
                                                                            if ((256u + _e1507) < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1507 + 257u) < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1507 + 258u) < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1514 = (_e1507 + 259u);
                                                                            if (_e1514 < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1517 = surfaces.member[_e1514];
                                                                            if ((_e1507 + 260u) < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1507 + 261u) < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1507 + 262u) < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1524 = (_e1507 + 263u);
                                                                            if (_e1524 < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1527 = surfaces.member[_e1524];
                                                                            let _e1528 = (_e1507 + 264u);
                                                                            if (_e1528 < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1531 = surfaces.member[_e1528];
                                                                            let _e1532 = bitcast<f32>(_e1531);
                                                                            let _e1533 = (_e1507 + 265u);
                                                                            if (_e1533 < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1536 = surfaces.member[_e1533];
                                                                            let _e1537 = bitcast<f32>(_e1536);
                                                                            if ((_e1507 + 266u) < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1507 + 267u) < _e125) {
                                                                            } else {
                                                                                phi_5094_ = true;
                                                                                phi_3764_ = bool();
                                                                                break;
                                                                            }
                                                                            if (_e1517 == 4294967295u) {
                                                                                phi_2512_ = (_e1532 < _e1537);
                                                                            } else {
                                                                                if (_e1117.member_1 < arrayLength((&attributes.member))) {
                                                                                } else {
                                                                                    phi_5094_ = true;
                                                                                    phi_3764_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1545 = ((1f - _e1491[1]) - _e1491[2]);
                                                                                let _e1549 = attributes.member[_e1117.member_1].member[0u];
                                                                                let _e1554 = attributes.member[_e1117.member_1].member[2u];
                                                                                let _e1560 = attributes.member[_e1117.member_1].member[4u];
                                                                                let _e1562 = (((_e1549 * _e1545) + (_e1554 * _e1491[1])) + (_e1560 * _e1491[2]));
                                                                                let _e1566 = attributes.member[_e1117.member_1].member[1u];
                                                                                let _e1571 = attributes.member[_e1117.member_1].member[3u];
                                                                                let _e1577 = attributes.member[_e1117.member_1].member[5u];
                                                                                let _e1579 = (((_e1566 * _e1545) + (_e1571 * _e1491[1])) + (_e1577 * _e1491[2]));
                                                                                let _e1580 = (_e1527 & 65535u);
                                                                                let _e1582 = (_e1527 >> bitcast<u32>(16i));
                                                                                let _e1584 = (_e1562 - floor(_e1562));
                                                                                let _e1589 = ((select(0f, _e1584, (_e1584 <= 1f)) * f32(_e1580)) - 0.5f);
                                                                                let _e1590 = floor(_e1589);
                                                                                let _e1591 = (_e1589 - _e1590);
                                                                                let _e1592 = (_e1580 - 1u);
                                                                                if (_e1590 < 0f) {
                                                                                    phi_2395_ = _e1592;
                                                                                } else {
                                                                                    let _e1598 = select(select(u32(_e1590), 0u, (_e1590 < 0f)), 4294967295u, (_e1590 > 4294967000f));
                                                                                    phi_2395_ = select(_e1598, _e1592, (_e1592 < _e1598));
                                                                                }
                                                                                let _e1602 = phi_2395_;
                                                                                if (_e1602 == _e1592) {
                                                                                    phi_2401_ = 0u;
                                                                                } else {
                                                                                    phi_2401_ = (_e1602 + 1u);
                                                                                }
                                                                                let _e1606 = phi_2401_;
                                                                                let _e1608 = (_e1579 - floor(_e1579));
                                                                                let _e1613 = ((select(0f, _e1608, (_e1608 <= 1f)) * f32(_e1582)) - 0.5f);
                                                                                let _e1614 = floor(_e1613);
                                                                                let _e1615 = (_e1613 - _e1614);
                                                                                let _e1616 = (_e1582 - 1u);
                                                                                if (_e1614 < 0f) {
                                                                                    phi_2431_ = _e1616;
                                                                                } else {
                                                                                    let _e1622 = select(select(u32(_e1614), 0u, (_e1614 < 0f)), 4294967295u, (_e1614 > 4294967000f));
                                                                                    phi_2431_ = select(_e1622, _e1616, (_e1616 < _e1622));
                                                                                }
                                                                                let _e1626 = phi_2431_;
                                                                                if (_e1626 == _e1616) {
                                                                                    phi_2437_ = 0u;
                                                                                } else {
                                                                                    phi_2437_ = (_e1626 + 1u);
                                                                                }
                                                                                let _e1630 = phi_2437_;
                                                                                let _e1632 = (_e1517 + (_e1626 * _e1580));
                                                                                let _e1634 = (_e1517 + (_e1630 * _e1580));
                                                                                let _e1635 = (_e1632 + _e1602);
                                                                                let _e1636 = (_e1632 + _e1606);
                                                                                let _e1637 = (_e1634 + _e1602);
                                                                                let _e1638 = (_e1634 + _e1606);
                                                                                if (_e1635 < _e125) {
                                                                                } else {
                                                                                    phi_5094_ = true;
                                                                                    phi_3764_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1641 = surfaces.member[_e1635];
                                                                                if (_e1636 < _e125) {
                                                                                } else {
                                                                                    phi_5094_ = true;
                                                                                    phi_3764_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1644 = surfaces.member[_e1636];
                                                                                if (_e1637 < _e125) {
                                                                                } else {
                                                                                    phi_5094_ = true;
                                                                                    phi_3764_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1647 = surfaces.member[_e1637];
                                                                                if (_e1638 < _e125) {
                                                                                } else {
                                                                                    phi_5094_ = true;
                                                                                    phi_3764_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1650 = surfaces.member[_e1638];
                                                                                let _e1667 = (1f - _e1591);
                                                                                phi_2512_ = ((_e1532 * (((((f32((_e1641 >> bitcast<u32>(24i))) * 0.003921569f) * _e1667) + ((f32((_e1644 >> bitcast<u32>(24i))) * 0.003921569f) * _e1591)) * (1f - _e1615)) + ((((f32((_e1647 >> bitcast<u32>(24i))) * 0.003921569f) * _e1667) + ((f32((_e1650 >> bitcast<u32>(24i))) * 0.003921569f) * _e1591)) * _e1615))) < _e1537);
                                                                            }
                                                                            let _e1682 = phi_2512_;
                                                                            phi_2517_ = select(true, false, _e1682);
                                                                        }
                                                                        let _e1685 = phi_2517_;
                                                                        if _e1685 {
                                                                            phi_2522_ = type_51(_e1491[0], _e1117.member_1, _e1491[1], _e1491[2]);
                                                                        } else {
                                                                            phi_2522_ = type_51();
                                                                        }
                                                                        let _e1688 = phi_2522_;
                                                                        phi_2524_ = _e1688;
                                                                        phi_2526_ = select(true, false, _e1685);
                                                                    } else {
                                                                        phi_2524_ = type_51();
                                                                        phi_2526_ = false;
                                                                    }
                                                                    let _e1691 = phi_2524_;
                                                                    let _e1693 = phi_2526_;
                                                                    phi_2527_ = _e1691;
                                                                    phi_2529_ = select(true, false, _e1498);
                                                                    phi_2530_ = _e1693;
                                                                } else {
                                                                    phi_2527_ = type_51();
                                                                    phi_2529_ = false;
                                                                    phi_2530_ = false;
                                                                }
                                                                let _e1696 = phi_2527_;
                                                                let _e1698 = phi_2529_;
                                                                let _e1700 = phi_2530_;
                                                                phi_2531_ = _e1696;
                                                                phi_2532_ = select(true, false, _e1497);
                                                                phi_2533_ = _e1698;
                                                                phi_2534_ = _e1700;
                                                            } else {
                                                                phi_2531_ = type_51();
                                                                phi_2532_ = true;
                                                                phi_2533_ = false;
                                                                phi_2534_ = false;
                                                            }
                                                            let _e1703 = phi_2531_;
                                                            let _e1705 = phi_2532_;
                                                            let _e1707 = phi_2533_;
                                                            let _e1709 = phi_2534_;
                                                            if select(select(_e1709, false, _e1705), true, select(_e1707, true, _e1705)) {
                                                                phi_2547_ = type_51(_e956.member_3, 4294967295u, 0f, 0f);
                                                            } else {
                                                                phi_2547_ = _e1703;
                                                            }
                                                            let _e1714 = phi_2547_;
                                                            phi_2554_ = select(true, false, (_e1714.member_1 != 4294967295u));
                                                        } else {
                                                            phi_2554_ = false;
                                                        }
                                                        let _e1719 = phi_2554_;
                                                        continue;
                                                        continuing {
                                                            phi_1870_ = _e1115;
                                                            phi_5094_ = _e1090;
                                                            phi_3764_ = select(true, false, _e1121);
                                                            break if !(_e1719);
                                                        }
                                                    }
                                                    let _e1723 = phi_5094_;
                                                    let _e1725 = phi_3764_;
                                                    phi_5203_ = _e1723;
                                                    phi_3765_ = bool();
                                                    if _e1723 {
                                                        break;
                                                    }
                                                    phi_5205_ = _e1723;
                                                    phi_2559_ = _e1094;
                                                    phi_2560_ = _e1725;
                                                }
                                                let _e1963 = phi_5205_;
                                                let _e1965 = phi_2559_;
                                                let _e1967 = phi_2560_;
                                                if _e1967 {
                                                    let _e1968 = (_e1965 == 0u);
                                                    if _e1968 {
                                                        phi_2576_ = u32();
                                                        phi_2577_ = u32();
                                                    } else {
                                                        let _e1969 = (_e1965 - 1u);
                                                        if (_e1969 < 64u) {
                                                        } else {
                                                            phi_5203_ = true;
                                                            phi_3765_ = bool();
                                                            break;
                                                        }
                                                        let _e1972 = local[_e1969];
                                                        phi_2576_ = _e1972;
                                                        phi_2577_ = _e1969;
                                                    }
                                                    let _e1974 = phi_2576_;
                                                    let _e1976 = phi_2577_;
                                                    phi_1441_ = _e1974;
                                                    phi_1444_ = _e1976;
                                                    phi_2579_ = select(true, false, _e1968);
                                                    phi_2580_ = _e1968;
                                                } else {
                                                    phi_1441_ = u32();
                                                    phi_1444_ = u32();
                                                    phi_2579_ = false;
                                                    phi_2580_ = false;
                                                }
                                                let _e1979 = phi_1441_;
                                                let _e1981 = phi_1444_;
                                                let _e1983 = phi_2579_;
                                                let _e1985 = phi_2580_;
                                                continue;
                                                continuing {
                                                    phi_5098_ = _e1963;
                                                    phi_1440_ = _e1979;
                                                    phi_1443_ = _e1981;
                                                    phi_5203_ = _e1963;
                                                    phi_3765_ = _e1985;
                                                    break if !(_e1983);
                                                }
                                            }
                                            let _e1988 = phi_5203_;
                                            let _e1990 = phi_3765_;
                                            phi_5263_ = _e1988;
                                            if _e1988 {
                                                break;
                                            }
                                            if select(false, true, select(true, false, _e1990)) {
                                                phi_2593_ = _e392;
                                            } else {
                                                phi_2593_ = (_e392 + _e957);
                                            }
                                            let _e1995 = phi_2593_;
                                            phi_5265_ = _e1988;
                                            phi_2594_ = _e1995;
                                        } else {
                                            phi_5265_ = _e386;
                                            phi_2594_ = _e392;
                                        }
                                        let _e1997 = phi_5265_;
                                        let _e1999 = phi_2594_;
                                        phi_5264_ = _e1997;
                                        phi_544_ = select(_e958, _e390, (_e390 < _e958));
                                        phi_546_ = _e1999;
                                        phi_548_ = (_e394 + _e957);
                                    } else {
                                        phi_5264_ = _e386;
                                        phi_544_ = f32();
                                        phi_546_ = f32();
                                        phi_548_ = f32();
                                    }
                                    let _e2001 = phi_5264_;
                                    let _e2003 = phi_544_;
                                    let _e2005 = phi_546_;
                                    let _e2007 = phi_548_;
                                    continue;
                                    continuing {
                                        phi_5120_ = _e2001;
                                        phi_540_ = _e407;
                                        phi_543_ = _e2003;
                                        phi_545_ = _e2005;
                                        phi_547_ = _e2007;
                                        phi_5263_ = _e2001;
                                        break if !(_e413);
                                    }
                                }
                                let _e2010 = phi_5263_;
                                phi_5269_ = _e2010;
                                if _e2010 {
                                    break;
                                }
                                let _e2012 = local_5;
                                if (_e2012 <= 0f) {
                                    phi_2661_ = vec3<f32>(0f, 0f, 0f);
                                } else {
                                    if (_e371.member_1 == 4294967295u) {
                                        let _e2016 = local_6;
                                        phi_2607_ = ((3.1415927f * _e2016) / f32(_e383));
                                    } else {
                                        let _e3023 = local_14;
                                        phi_2607_ = _e3023;
                                    }
                                    let _e2021 = phi_2607_;
                                    if _e379 {
                                        if (_e383 == 1u) {
                                            phi_2642_ = f32();
                                            phi_2643_ = true;
                                        } else {
                                            let _e2025 = local_7;
                                            let _e2027 = (_e371.member_3 < (0.01f * _e2025));
                                            if _e2027 {
                                                phi_2641_ = f32();
                                            } else {
                                                let _e2043 = (_e371.member[0] - _e143.member[0]);
                                                let _e2044 = (_e371.member[1] - _e143.member[1]);
                                                let _e2045 = (_e371.member[2] - _e143.member[2]);
                                                let _e2046 = (vec3<f32>(_e371.member[0], _e371.member[1], _e371.member[2]) - _e150);
                                                let _e2047 = (_e371.member_2[0] - _e143.member[0]);
                                                let _e2048 = (_e371.member_2[1] - _e143.member[1]);
                                                let _e2049 = (_e371.member_2[2] - _e143.member[2]);
                                                let _e2050 = (vec3<f32>(_e371.member_2[0], _e371.member_2[1], _e371.member_2[2]) - _e150);
                                                let _e2051 = (_e371.member_4[0] - _e143.member[0]);
                                                let _e2052 = (_e371.member_4[1] - _e143.member[1]);
                                                let _e2053 = (_e371.member_4[2] - _e143.member[2]);
                                                let _e2054 = (vec3<f32>(_e371.member_4[0], _e371.member_4[1], _e371.member_4[2]) - _e150);
                                                let _e2059 = (((_e143.member_2[0] * _e2043) + (_e143.member_2[1] * _e2044)) + (_e143.member_2[2] * _e2045));
                                                let _e2064 = (((_e143.member_2[0] * _e2047) + (_e143.member_2[1] * _e2048)) + (_e143.member_2[2] * _e2049));
                                                let _e2069 = (((_e143.member_2[0] * _e2051) + (_e143.member_2[1] * _e2052)) + (_e143.member_2[2] * _e2053));
                                                let _e2070 = (_e2059 <= 0f);
                                                if _e2070 {
                                                    phi_4107_ = select(true, false, (_e2064 <= 0f));
                                                } else {
                                                    phi_4107_ = true;
                                                }
                                                let _e2074 = phi_4107_;
                                                if _e2074 {
                                                    if _e2070 {
                                                        phi_4118_ = true;
                                                    } else {
                                                        phi_4118_ = (_e2064 <= 0f);
                                                    }
                                                    let _e2077 = phi_4118_;
                                                    if _e2077 {
                                                        let _e2082 = (_e2059 / (_e2059 - _e2064));
                                                        let _e2089 = vec3<f32>((_e2043 + ((_e2047 - _e2043) * _e2082)), (_e2044 + ((_e2048 - _e2044) * _e2082)), (_e2045 + ((_e2049 - _e2045) * _e2082)));
                                                        if _e2070 {
                                                            phi_4139_ = type_61(0f, vec3<f32>(0f, 0f, 0f), _e2089);
                                                        } else {
                                                            phi_4139_ = type_61(0f, _e2089, vec3<f32>(0f, 0f, 0f));
                                                        }
                                                        let _e2093 = phi_4139_;
                                                        let _e2094 = vec3(_e2070);
                                                        phi_4143_ = _e2093;
                                                        phi_4144_ = select(_e2089, _e2050, _e2094);
                                                        phi_4145_ = select(_e2046, _e2089, _e2094);
                                                    } else {
                                                        phi_4143_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                        phi_4144_ = _e2050;
                                                        phi_4145_ = _e2046;
                                                    }
                                                    let _e2098 = phi_4143_;
                                                    let _e2100 = phi_4144_;
                                                    let _e2102 = phi_4145_;
                                                    let _e2104 = abs(_e2102.x);
                                                    let _e2106 = abs(_e2102.y);
                                                    let _e2108 = select(_e2106, _e2104, (_e2104 > _e2106));
                                                    let _e2110 = abs(_e2102.z);
                                                    let _e2112 = select(_e2110, _e2108, (_e2108 > _e2110));
                                                    if (_e2112 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2114 = (_e2112 < 340282350000000000000000000000000000000f);
                                                        if _e2114 {
                                                            let _e2115 = (_e2102.x / _e2112);
                                                            let _e2116 = (_e2102.y / _e2112);
                                                            let _e2117 = (_e2102.z / _e2112);
                                                            let _e2123 = sqrt((((_e2115 * _e2115) + (_e2116 * _e2116)) + (_e2117 * _e2117)));
                                                            phi_4185_ = vec3<f32>((_e2115 / _e2123), (_e2116 / _e2123), (_e2117 / _e2123));
                                                        } else {
                                                            phi_4185_ = vec3<f32>();
                                                        }
                                                        let _e2129 = phi_4185_;
                                                        phi_4188_ = _e2129;
                                                        phi_4189_ = select(true, false, _e2114);
                                                    } else {
                                                        phi_4188_ = vec3<f32>();
                                                        phi_4189_ = true;
                                                    }
                                                    let _e2132 = phi_4188_;
                                                    let _e2134 = phi_4189_;
                                                    let _e2136 = select(_e2132, vec3<f32>(0f, 0f, 0f), vec3(_e2134));
                                                    let _e2138 = abs(_e2100.x);
                                                    let _e2140 = abs(_e2100.y);
                                                    let _e2142 = select(_e2140, _e2138, (_e2138 > _e2140));
                                                    let _e2144 = abs(_e2100.z);
                                                    let _e2146 = select(_e2144, _e2142, (_e2142 > _e2144));
                                                    if (_e2146 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2148 = (_e2146 < 340282350000000000000000000000000000000f);
                                                        if _e2148 {
                                                            let _e2149 = (_e2100.x / _e2146);
                                                            let _e2150 = (_e2100.y / _e2146);
                                                            let _e2151 = (_e2100.z / _e2146);
                                                            let _e2157 = sqrt((((_e2149 * _e2149) + (_e2150 * _e2150)) + (_e2151 * _e2151)));
                                                            phi_4233_ = vec3<f32>((_e2149 / _e2157), (_e2150 / _e2157), (_e2151 / _e2157));
                                                        } else {
                                                            phi_4233_ = vec3<f32>();
                                                        }
                                                        let _e2163 = phi_4233_;
                                                        phi_4236_ = _e2163;
                                                        phi_4237_ = select(true, false, _e2148);
                                                    } else {
                                                        phi_4236_ = vec3<f32>();
                                                        phi_4237_ = true;
                                                    }
                                                    let _e2166 = phi_4236_;
                                                    let _e2168 = phi_4237_;
                                                    let _e2170 = select(_e2166, vec3<f32>(0f, 0f, 0f), vec3(_e2168));
                                                    let _e2177 = ((_e2136.y * _e2170.z) - (_e2170.y * _e2136.z));
                                                    let _e2182 = ((_e2136.z * _e2170.x) - (_e2170.z * _e2136.x));
                                                    let _e2185 = ((_e2136.x * _e2170.y) - (_e2170.x * _e2136.y));
                                                    let _e2191 = sqrt((((_e2177 * _e2177) + (_e2182 * _e2182)) + (_e2185 * _e2185)));
                                                    if (_e2191 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_4351_ = 0f;
                                                    } else {
                                                        let _e2203 = (((_e2136.x * _e2170.x) + (_e2136.y * _e2170.y)) + (_e2136.z * _e2170.z));
                                                        let _e2204 = abs(_e2203);
                                                        let _e2205 = abs(_e2191);
                                                        let _e2206 = (_e2205 > _e2204);
                                                        let _e2207 = select(_e2204, _e2205, _e2206);
                                                        if (_e2207 > 0f) {
                                                            phi_4304_ = (select(_e2205, _e2204, _e2206) / _e2207);
                                                        } else {
                                                            phi_4304_ = 0f;
                                                        }
                                                        let _e2212 = phi_4304_;
                                                        let _e2213 = (_e2212 > 0.41421357f);
                                                        if _e2213 {
                                                            phi_4312_ = ((_e2212 - 1f) / (_e2212 + 1f));
                                                        } else {
                                                            phi_4312_ = _e2212;
                                                        }
                                                        let _e2218 = phi_4312_;
                                                        let _e2219 = (_e2218 * _e2218);
                                                        let _e2228 = (_e2218 + ((_e2218 * _e2219) * (-0.3333295f + (_e2219 * (0.19977711f + (_e2219 * (-0.13877685f + (_e2219 * 0.080537446f))))))));
                                                        if _e2213 {
                                                            phi_4327_ = (_e2228 + 0.7853982f);
                                                        } else {
                                                            phi_4327_ = _e2228;
                                                        }
                                                        let _e2231 = phi_4327_;
                                                        if _e2206 {
                                                            phi_4333_ = (1.5707964f - _e2231);
                                                        } else {
                                                            phi_4333_ = _e2231;
                                                        }
                                                        let _e2234 = phi_4333_;
                                                        if ((bitcast<u32>(_e2203) & 2147483648u) == 0u) {
                                                            phi_4341_ = _e2234;
                                                        } else {
                                                            phi_4341_ = (3.1415927f - _e2234);
                                                        }
                                                        let _e2240 = phi_4341_;
                                                        phi_4351_ = (((((_e143.member_2[0] * _e2177) + (_e143.member_2[1] * _e2182)) + (_e143.member_2[2] * _e2185)) / _e2191) * bitcast<f32>(((bitcast<u32>(_e2240) & 2147483647u) | (bitcast<u32>(_e2191) & 2147483648u))));
                                                    }
                                                    let _e2249 = phi_4351_;
                                                    phi_4356_ = type_61((_e2098.member + _e2249), _e2098.member_1, _e2098.member_2);
                                                } else {
                                                    phi_4356_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                }
                                                let _e2257 = phi_4356_;
                                                let _e2258 = (_e2064 <= 0f);
                                                if _e2258 {
                                                    phi_4366_ = select(true, false, (_e2069 <= 0f));
                                                } else {
                                                    phi_4366_ = true;
                                                }
                                                let _e2262 = phi_4366_;
                                                if _e2262 {
                                                    if _e2258 {
                                                        phi_4377_ = true;
                                                    } else {
                                                        phi_4377_ = (_e2069 <= 0f);
                                                    }
                                                    let _e2265 = phi_4377_;
                                                    if _e2265 {
                                                        let _e2270 = (_e2064 / (_e2064 - _e2069));
                                                        let _e2277 = vec3<f32>((_e2047 + ((_e2051 - _e2047) * _e2270)), (_e2048 + ((_e2052 - _e2048) * _e2270)), (_e2049 + ((_e2053 - _e2049) * _e2270)));
                                                        if _e2258 {
                                                            phi_4398_ = type_61(_e2257.member, _e2257.member_1, _e2277);
                                                        } else {
                                                            phi_4398_ = type_61(_e2257.member, _e2277, _e2257.member_2);
                                                        }
                                                        let _e2287 = phi_4398_;
                                                        let _e2288 = vec3(_e2258);
                                                        phi_4402_ = _e2287;
                                                        phi_4403_ = select(_e2277, _e2054, _e2288);
                                                        phi_4404_ = select(_e2050, _e2277, _e2288);
                                                    } else {
                                                        phi_4402_ = _e2257;
                                                        phi_4403_ = _e2054;
                                                        phi_4404_ = _e2050;
                                                    }
                                                    let _e2292 = phi_4402_;
                                                    let _e2294 = phi_4403_;
                                                    let _e2296 = phi_4404_;
                                                    let _e2298 = abs(_e2296.x);
                                                    let _e2300 = abs(_e2296.y);
                                                    let _e2302 = select(_e2300, _e2298, (_e2298 > _e2300));
                                                    let _e2304 = abs(_e2296.z);
                                                    let _e2306 = select(_e2304, _e2302, (_e2302 > _e2304));
                                                    if (_e2306 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2308 = (_e2306 < 340282350000000000000000000000000000000f);
                                                        if _e2308 {
                                                            let _e2309 = (_e2296.x / _e2306);
                                                            let _e2310 = (_e2296.y / _e2306);
                                                            let _e2311 = (_e2296.z / _e2306);
                                                            let _e2317 = sqrt((((_e2309 * _e2309) + (_e2310 * _e2310)) + (_e2311 * _e2311)));
                                                            phi_4444_ = vec3<f32>((_e2309 / _e2317), (_e2310 / _e2317), (_e2311 / _e2317));
                                                        } else {
                                                            phi_4444_ = vec3<f32>();
                                                        }
                                                        let _e2323 = phi_4444_;
                                                        phi_4447_ = _e2323;
                                                        phi_4448_ = select(true, false, _e2308);
                                                    } else {
                                                        phi_4447_ = vec3<f32>();
                                                        phi_4448_ = true;
                                                    }
                                                    let _e2326 = phi_4447_;
                                                    let _e2328 = phi_4448_;
                                                    let _e2330 = select(_e2326, vec3<f32>(0f, 0f, 0f), vec3(_e2328));
                                                    let _e2332 = abs(_e2294.x);
                                                    let _e2334 = abs(_e2294.y);
                                                    let _e2336 = select(_e2334, _e2332, (_e2332 > _e2334));
                                                    let _e2338 = abs(_e2294.z);
                                                    let _e2340 = select(_e2338, _e2336, (_e2336 > _e2338));
                                                    if (_e2340 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2342 = (_e2340 < 340282350000000000000000000000000000000f);
                                                        if _e2342 {
                                                            let _e2343 = (_e2294.x / _e2340);
                                                            let _e2344 = (_e2294.y / _e2340);
                                                            let _e2345 = (_e2294.z / _e2340);
                                                            let _e2351 = sqrt((((_e2343 * _e2343) + (_e2344 * _e2344)) + (_e2345 * _e2345)));
                                                            phi_4492_ = vec3<f32>((_e2343 / _e2351), (_e2344 / _e2351), (_e2345 / _e2351));
                                                        } else {
                                                            phi_4492_ = vec3<f32>();
                                                        }
                                                        let _e2357 = phi_4492_;
                                                        phi_4495_ = _e2357;
                                                        phi_4496_ = select(true, false, _e2342);
                                                    } else {
                                                        phi_4495_ = vec3<f32>();
                                                        phi_4496_ = true;
                                                    }
                                                    let _e2360 = phi_4495_;
                                                    let _e2362 = phi_4496_;
                                                    let _e2364 = select(_e2360, vec3<f32>(0f, 0f, 0f), vec3(_e2362));
                                                    let _e2371 = ((_e2330.y * _e2364.z) - (_e2364.y * _e2330.z));
                                                    let _e2376 = ((_e2330.z * _e2364.x) - (_e2364.z * _e2330.x));
                                                    let _e2379 = ((_e2330.x * _e2364.y) - (_e2364.x * _e2330.y));
                                                    let _e2385 = sqrt((((_e2371 * _e2371) + (_e2376 * _e2376)) + (_e2379 * _e2379)));
                                                    if (_e2385 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_4610_ = 0f;
                                                    } else {
                                                        let _e2397 = (((_e2330.x * _e2364.x) + (_e2330.y * _e2364.y)) + (_e2330.z * _e2364.z));
                                                        let _e2398 = abs(_e2397);
                                                        let _e2399 = abs(_e2385);
                                                        let _e2400 = (_e2399 > _e2398);
                                                        let _e2401 = select(_e2398, _e2399, _e2400);
                                                        if (_e2401 > 0f) {
                                                            phi_4563_ = (select(_e2399, _e2398, _e2400) / _e2401);
                                                        } else {
                                                            phi_4563_ = 0f;
                                                        }
                                                        let _e2406 = phi_4563_;
                                                        let _e2407 = (_e2406 > 0.41421357f);
                                                        if _e2407 {
                                                            phi_4571_ = ((_e2406 - 1f) / (_e2406 + 1f));
                                                        } else {
                                                            phi_4571_ = _e2406;
                                                        }
                                                        let _e2412 = phi_4571_;
                                                        let _e2413 = (_e2412 * _e2412);
                                                        let _e2422 = (_e2412 + ((_e2412 * _e2413) * (-0.3333295f + (_e2413 * (0.19977711f + (_e2413 * (-0.13877685f + (_e2413 * 0.080537446f))))))));
                                                        if _e2407 {
                                                            phi_4586_ = (_e2422 + 0.7853982f);
                                                        } else {
                                                            phi_4586_ = _e2422;
                                                        }
                                                        let _e2425 = phi_4586_;
                                                        if _e2400 {
                                                            phi_4592_ = (1.5707964f - _e2425);
                                                        } else {
                                                            phi_4592_ = _e2425;
                                                        }
                                                        let _e2428 = phi_4592_;
                                                        if ((bitcast<u32>(_e2397) & 2147483648u) == 0u) {
                                                            phi_4600_ = _e2428;
                                                        } else {
                                                            phi_4600_ = (3.1415927f - _e2428);
                                                        }
                                                        let _e2434 = phi_4600_;
                                                        phi_4610_ = (((((_e143.member_2[0] * _e2371) + (_e143.member_2[1] * _e2376)) + (_e143.member_2[2] * _e2379)) / _e2385) * bitcast<f32>(((bitcast<u32>(_e2434) & 2147483647u) | (bitcast<u32>(_e2385) & 2147483648u))));
                                                    }
                                                    let _e2443 = phi_4610_;
                                                    phi_4615_ = type_61((_e2292.member + _e2443), _e2292.member_1, _e2292.member_2);
                                                } else {
                                                    phi_4615_ = _e2257;
                                                }
                                                let _e2451 = phi_4615_;
                                                let _e2452 = (_e2069 <= 0f);
                                                if _e2452 {
                                                    phi_4625_ = select(true, false, _e2070);
                                                } else {
                                                    phi_4625_ = true;
                                                }
                                                let _e2455 = phi_4625_;
                                                if _e2455 {
                                                    if select(_e2070, true, _e2452) {
                                                        let _e2461 = (_e2069 / (_e2069 - _e2059));
                                                        let _e2468 = vec3<f32>((_e2051 + ((_e2043 - _e2051) * _e2461)), (_e2052 + ((_e2044 - _e2052) * _e2461)), (_e2053 + ((_e2045 - _e2053) * _e2461)));
                                                        if _e2452 {
                                                            phi_4657_ = type_61(_e2451.member, _e2451.member_1, _e2468);
                                                        } else {
                                                            phi_4657_ = type_61(_e2451.member, _e2468, _e2451.member_2);
                                                        }
                                                        let _e2478 = phi_4657_;
                                                        let _e2479 = vec3(_e2452);
                                                        phi_4661_ = _e2478;
                                                        phi_4662_ = select(_e2468, _e2046, _e2479);
                                                        phi_4663_ = select(_e2054, _e2468, _e2479);
                                                    } else {
                                                        phi_4661_ = _e2451;
                                                        phi_4662_ = _e2046;
                                                        phi_4663_ = _e2054;
                                                    }
                                                    let _e2483 = phi_4661_;
                                                    let _e2485 = phi_4662_;
                                                    let _e2487 = phi_4663_;
                                                    let _e2489 = abs(_e2487.x);
                                                    let _e2491 = abs(_e2487.y);
                                                    let _e2493 = select(_e2491, _e2489, (_e2489 > _e2491));
                                                    let _e2495 = abs(_e2487.z);
                                                    let _e2497 = select(_e2495, _e2493, (_e2493 > _e2495));
                                                    if (_e2497 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2499 = (_e2497 < 340282350000000000000000000000000000000f);
                                                        if _e2499 {
                                                            let _e2500 = (_e2487.x / _e2497);
                                                            let _e2501 = (_e2487.y / _e2497);
                                                            let _e2502 = (_e2487.z / _e2497);
                                                            let _e2508 = sqrt((((_e2500 * _e2500) + (_e2501 * _e2501)) + (_e2502 * _e2502)));
                                                            phi_4703_ = vec3<f32>((_e2500 / _e2508), (_e2501 / _e2508), (_e2502 / _e2508));
                                                        } else {
                                                            phi_4703_ = vec3<f32>();
                                                        }
                                                        let _e2514 = phi_4703_;
                                                        phi_4706_ = _e2514;
                                                        phi_4707_ = select(true, false, _e2499);
                                                    } else {
                                                        phi_4706_ = vec3<f32>();
                                                        phi_4707_ = true;
                                                    }
                                                    let _e2517 = phi_4706_;
                                                    let _e2519 = phi_4707_;
                                                    let _e2521 = select(_e2517, vec3<f32>(0f, 0f, 0f), vec3(_e2519));
                                                    let _e2523 = abs(_e2485.x);
                                                    let _e2525 = abs(_e2485.y);
                                                    let _e2527 = select(_e2525, _e2523, (_e2523 > _e2525));
                                                    let _e2529 = abs(_e2485.z);
                                                    let _e2531 = select(_e2529, _e2527, (_e2527 > _e2529));
                                                    if (_e2531 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2533 = (_e2531 < 340282350000000000000000000000000000000f);
                                                        if _e2533 {
                                                            let _e2534 = (_e2485.x / _e2531);
                                                            let _e2535 = (_e2485.y / _e2531);
                                                            let _e2536 = (_e2485.z / _e2531);
                                                            let _e2542 = sqrt((((_e2534 * _e2534) + (_e2535 * _e2535)) + (_e2536 * _e2536)));
                                                            phi_4751_ = vec3<f32>((_e2534 / _e2542), (_e2535 / _e2542), (_e2536 / _e2542));
                                                        } else {
                                                            phi_4751_ = vec3<f32>();
                                                        }
                                                        let _e2548 = phi_4751_;
                                                        phi_4754_ = _e2548;
                                                        phi_4755_ = select(true, false, _e2533);
                                                    } else {
                                                        phi_4754_ = vec3<f32>();
                                                        phi_4755_ = true;
                                                    }
                                                    let _e2551 = phi_4754_;
                                                    let _e2553 = phi_4755_;
                                                    let _e2555 = select(_e2551, vec3<f32>(0f, 0f, 0f), vec3(_e2553));
                                                    let _e2562 = ((_e2521.y * _e2555.z) - (_e2555.y * _e2521.z));
                                                    let _e2567 = ((_e2521.z * _e2555.x) - (_e2555.z * _e2521.x));
                                                    let _e2570 = ((_e2521.x * _e2555.y) - (_e2555.x * _e2521.y));
                                                    let _e2576 = sqrt((((_e2562 * _e2562) + (_e2567 * _e2567)) + (_e2570 * _e2570)));
                                                    if (_e2576 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_4869_ = 0f;
                                                    } else {
                                                        let _e2588 = (((_e2521.x * _e2555.x) + (_e2521.y * _e2555.y)) + (_e2521.z * _e2555.z));
                                                        let _e2589 = abs(_e2588);
                                                        let _e2590 = abs(_e2576);
                                                        let _e2591 = (_e2590 > _e2589);
                                                        let _e2592 = select(_e2589, _e2590, _e2591);
                                                        if (_e2592 > 0f) {
                                                            phi_4822_ = (select(_e2590, _e2589, _e2591) / _e2592);
                                                        } else {
                                                            phi_4822_ = 0f;
                                                        }
                                                        let _e2597 = phi_4822_;
                                                        let _e2598 = (_e2597 > 0.41421357f);
                                                        if _e2598 {
                                                            phi_4830_ = ((_e2597 - 1f) / (_e2597 + 1f));
                                                        } else {
                                                            phi_4830_ = _e2597;
                                                        }
                                                        let _e2603 = phi_4830_;
                                                        let _e2604 = (_e2603 * _e2603);
                                                        let _e2613 = (_e2603 + ((_e2603 * _e2604) * (-0.3333295f + (_e2604 * (0.19977711f + (_e2604 * (-0.13877685f + (_e2604 * 0.080537446f))))))));
                                                        if _e2598 {
                                                            phi_4845_ = (_e2613 + 0.7853982f);
                                                        } else {
                                                            phi_4845_ = _e2613;
                                                        }
                                                        let _e2616 = phi_4845_;
                                                        if _e2591 {
                                                            phi_4851_ = (1.5707964f - _e2616);
                                                        } else {
                                                            phi_4851_ = _e2616;
                                                        }
                                                        let _e2619 = phi_4851_;
                                                        if ((bitcast<u32>(_e2588) & 2147483648u) == 0u) {
                                                            phi_4859_ = _e2619;
                                                        } else {
                                                            phi_4859_ = (3.1415927f - _e2619);
                                                        }
                                                        let _e2625 = phi_4859_;
                                                        phi_4869_ = (((((_e143.member_2[0] * _e2562) + (_e143.member_2[1] * _e2567)) + (_e143.member_2[2] * _e2570)) / _e2576) * bitcast<f32>(((bitcast<u32>(_e2625) & 2147483647u) | (bitcast<u32>(_e2576) & 2147483648u))));
                                                    }
                                                    let _e2634 = phi_4869_;
                                                    phi_4874_ = type_61((_e2483.member + _e2634), _e2483.member_1, _e2483.member_2);
                                                } else {
                                                    phi_4874_ = _e2451;
                                                }
                                                let _e2642 = phi_4874_;
                                                let _e2646 = abs(_e2642.member_1.x);
                                                let _e2648 = abs(_e2642.member_1.y);
                                                let _e2650 = select(_e2648, _e2646, (_e2646 > _e2648));
                                                let _e2652 = abs(_e2642.member_1.z);
                                                let _e2654 = select(_e2652, _e2650, (_e2650 > _e2652));
                                                if (_e2654 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2656 = (_e2654 < 340282350000000000000000000000000000000f);
                                                    if _e2656 {
                                                        let _e2657 = (_e2642.member_1.x / _e2654);
                                                        let _e2658 = (_e2642.member_1.y / _e2654);
                                                        let _e2659 = (_e2642.member_1.z / _e2654);
                                                        let _e2665 = sqrt((((_e2657 * _e2657) + (_e2658 * _e2658)) + (_e2659 * _e2659)));
                                                        phi_4916_ = vec3<f32>((_e2657 / _e2665), (_e2658 / _e2665), (_e2659 / _e2665));
                                                    } else {
                                                        phi_4916_ = vec3<f32>();
                                                    }
                                                    let _e2671 = phi_4916_;
                                                    phi_4919_ = _e2671;
                                                    phi_4920_ = select(true, false, _e2656);
                                                } else {
                                                    phi_4919_ = vec3<f32>();
                                                    phi_4920_ = true;
                                                }
                                                let _e2674 = phi_4919_;
                                                let _e2676 = phi_4920_;
                                                let _e2678 = select(_e2674, vec3<f32>(0f, 0f, 0f), vec3(_e2676));
                                                let _e2680 = abs(_e2642.member_2.x);
                                                let _e2682 = abs(_e2642.member_2.y);
                                                let _e2684 = select(_e2682, _e2680, (_e2680 > _e2682));
                                                let _e2686 = abs(_e2642.member_2.z);
                                                let _e2688 = select(_e2686, _e2684, (_e2684 > _e2686));
                                                if (_e2688 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2690 = (_e2688 < 340282350000000000000000000000000000000f);
                                                    if _e2690 {
                                                        let _e2691 = (_e2642.member_2.x / _e2688);
                                                        let _e2692 = (_e2642.member_2.y / _e2688);
                                                        let _e2693 = (_e2642.member_2.z / _e2688);
                                                        let _e2699 = sqrt((((_e2691 * _e2691) + (_e2692 * _e2692)) + (_e2693 * _e2693)));
                                                        phi_4964_ = vec3<f32>((_e2691 / _e2699), (_e2692 / _e2699), (_e2693 / _e2699));
                                                    } else {
                                                        phi_4964_ = vec3<f32>();
                                                    }
                                                    let _e2705 = phi_4964_;
                                                    phi_4967_ = _e2705;
                                                    phi_4968_ = select(true, false, _e2690);
                                                } else {
                                                    phi_4967_ = vec3<f32>();
                                                    phi_4968_ = true;
                                                }
                                                let _e2708 = phi_4967_;
                                                let _e2710 = phi_4968_;
                                                let _e2712 = select(_e2708, vec3<f32>(0f, 0f, 0f), vec3(_e2710));
                                                let _e2719 = ((_e2678.y * _e2712.z) - (_e2712.y * _e2678.z));
                                                let _e2724 = ((_e2678.z * _e2712.x) - (_e2712.z * _e2678.x));
                                                let _e2727 = ((_e2678.x * _e2712.y) - (_e2712.x * _e2678.y));
                                                let _e2733 = sqrt((((_e2719 * _e2719) + (_e2724 * _e2724)) + (_e2727 * _e2727)));
                                                if (_e2733 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5082_ = 0f;
                                                } else {
                                                    let _e2745 = (((_e2678.x * _e2712.x) + (_e2678.y * _e2712.y)) + (_e2678.z * _e2712.z));
                                                    let _e2746 = abs(_e2745);
                                                    let _e2747 = abs(_e2733);
                                                    let _e2748 = (_e2747 > _e2746);
                                                    let _e2749 = select(_e2746, _e2747, _e2748);
                                                    if (_e2749 > 0f) {
                                                        phi_5035_ = (select(_e2747, _e2746, _e2748) / _e2749);
                                                    } else {
                                                        phi_5035_ = 0f;
                                                    }
                                                    let _e2754 = phi_5035_;
                                                    let _e2755 = (_e2754 > 0.41421357f);
                                                    if _e2755 {
                                                        phi_5043_ = ((_e2754 - 1f) / (_e2754 + 1f));
                                                    } else {
                                                        phi_5043_ = _e2754;
                                                    }
                                                    let _e2760 = phi_5043_;
                                                    let _e2761 = (_e2760 * _e2760);
                                                    let _e2770 = (_e2760 + ((_e2760 * _e2761) * (-0.3333295f + (_e2761 * (0.19977711f + (_e2761 * (-0.13877685f + (_e2761 * 0.080537446f))))))));
                                                    if _e2755 {
                                                        phi_5058_ = (_e2770 + 0.7853982f);
                                                    } else {
                                                        phi_5058_ = _e2770;
                                                    }
                                                    let _e2773 = phi_5058_;
                                                    if _e2748 {
                                                        phi_5064_ = (1.5707964f - _e2773);
                                                    } else {
                                                        phi_5064_ = _e2773;
                                                    }
                                                    let _e2776 = phi_5064_;
                                                    if ((bitcast<u32>(_e2745) & 2147483648u) == 0u) {
                                                        phi_5072_ = _e2776;
                                                    } else {
                                                        phi_5072_ = (3.1415927f - _e2776);
                                                    }
                                                    let _e2782 = phi_5072_;
                                                    phi_5082_ = (((((_e143.member_2[0] * _e2719) + (_e143.member_2[1] * _e2724)) + (_e143.member_2[2] * _e2727)) / _e2733) * bitcast<f32>(((bitcast<u32>(_e2782) & 2147483647u) | (bitcast<u32>(_e2733) & 2147483648u))));
                                                }
                                                let _e2791 = phi_5082_;
                                                let _e2797 = local_8;
                                                let _e2799 = local_9;
                                                phi_2641_ = ((abs((_e2642.member + _e2791)) * 0.5f) * (_e2797 / _e2799));
                                            }
                                            let _e2803 = phi_2641_;
                                            phi_2642_ = _e2803;
                                            phi_2643_ = _e2027;
                                        }
                                        let _e2805 = phi_2642_;
                                        let _e2807 = phi_2643_;
                                        if _e2807 {
                                            let _e2810 = local_10;
                                            phi_2651_ = ((_e2810 * _e371.member_3) / f32(_e383));
                                        } else {
                                            phi_2651_ = _e2805;
                                        }
                                        let _e2815 = phi_2651_;
                                        phi_2652_ = _e2815;
                                    } else {
                                        phi_2652_ = _e2021;
                                    }
                                    let _e2817 = phi_2652_;
                                    phi_2661_ = vec3<f32>((_e371.member_6[0] * _e2817), (_e371.member_6[1] * _e2817), (_e371.member_6[2] * _e2817));
                                }
                                let _e2827 = phi_2661_;
                                phi_5271_ = _e2010;
                                phi_2677_ = vec3<f32>((_e230.x + (_e2827.x * _e376)), (_e230.y + (_e2827.y * _e376)), (_e230.z + (_e2827.z * _e376)));
                            } else {
                                phi_5271_ = _e329;
                                phi_2677_ = _e230;
                            }
                            let _e2842 = phi_5271_;
                            let _e2844 = phi_2677_;
                            phi_5270_ = _e2842;
                            phi_358_ = _e2844;
                        } else {
                            phi_5270_ = _e226;
                            phi_358_ = vec3<f32>();
                        }
                        let _e2846 = phi_5270_;
                        let _e2848 = phi_358_;
                        continue;
                        continuing {
                            phi_5091_ = _e2846;
                            phi_354_ = _e243;
                            phi_357_ = _e2848;
                            phi_5269_ = _e2846;
                            break if !(_e249);
                        }
                    }
                    let _e2851 = phi_5269_;
                    if _e2851 {
                        break;
                    }
                    let _e2853 = local_11;
                    let _e2856 = local_12;
                    let _e2859 = local_13;
                    phi_2682_ = vec4<f32>(_e2853.x, _e2856.y, _e2859.z, 0f);
                }
                let _e2863 = phi_2682_;
                if (_e138 < arrayLength((&irradiance.member))) {
                } else {
                    break;
                }
                irradiance.member[_e138] = _e2863;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_direct(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
