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
    var phi_5241_: bool;
    var phi_357_: type_12;
    var phi_360_: vec3<f32>;
    var phi_358_: type_12;
    var phi_383_: type_12;
    var phi_422_: u32;
    var phi_425_: u32;
    var phi_449_: u32;
    var phi_423_: u32;
    var phi_426_: u32;
    var phi_5237_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_466_: f32;
    var phi_5275_: bool;
    var phi_476_: type_35;
    var phi_477_: u32;
    var phi_478_: f32;
    var phi_5274_: bool;
    var phi_480_: type_35;
    var phi_481_: u32;
    var phi_482_: f32;
    var phi_483_: bool;
    var phi_515_: type_35;
    var phi_516_: u32;
    var phi_518_: type_35;
    var phi_519_: u32;
    var phi_520_: u32;
    var phi_536_: bool;
    var phi_5270_: bool;
    var phi_543_: type_12;
    var phi_546_: f32;
    var phi_548_: f32;
    var phi_550_: f32;
    var phi_544_: type_12;
    var phi_573_: type_12;
    var phi_1145_: f32;
    var phi_3923_: f32;
    var phi_3931_: f32;
    var phi_909_: vec2<f32>;
    var phi_910_: bool;
    var phi_1040_: f32;
    var phi_1048_: f32;
    var phi_974_: f32;
    var phi_982_: f32;
    var phi_1052_: vec2<f32>;
    var phi_1053_: vec2<f32>;
    var phi_1146_: vec3<f32>;
    var phi_1147_: f32;
    var phi_1148_: f32;
    var phi_1149_: vec3<f32>;
    var phi_1150_: f32;
    var phi_1151_: bool;
    var phi_1168_: f32;
    var phi_1177_: type_47;
    var phi_652_: vec3<f32>;
    var phi_654_: vec3<f32>;
    var phi_655_: bool;
    var phi_3939_: f32;
    var phi_3947_: f32;
    var phi_729_: vec2<f32>;
    var phi_1179_: f32;
    var phi_1180_: vec3<f32>;
    var phi_1181_: f32;
    var phi_1182_: vec3<f32>;
    var phi_1183_: type_47;
    var phi_1184_: f32;
    var phi_1185_: bool;
    var phi_1202_: f32;
    var phi_1213_: type_47;
    var phi_1246_: bool;
    var phi_1256_: u32;
    var phi_1259_: bool;
    var phi_1270_: u32;
    var phi_1423_: f32;
    var phi_1431_: f32;
    var phi_1439_: f32;
    var phi_5248_: bool;
    var phi_1443_: u32;
    var phi_1446_: u32;
    var phi_1873_: type_12;
    var phi_1874_: type_12;
    var phi_1897_: type_12;
    var phi_2013_: f32;
    var phi_2024_: f32;
    var phi_2035_: f32;
    var phi_2050_: f32;
    var phi_2051_: f32;
    var phi_2052_: bool;
    var phi_2053_: f32;
    var phi_2054_: bool;
    var phi_2073_: f32;
    var phi_2074_: bool;
    var phi_2075_: f32;
    var phi_2076_: bool;
    var phi_2077_: bool;
    var phi_2082_: f32;
    var phi_2083_: bool;
    var phi_2169_: array<f32, 3>;
    var phi_2170_: array<f32, 3>;
    var phi_2171_: array<f32, 3>;
    var phi_2172_: array<f32, 3>;
    var phi_2173_: bool;
    var phi_2174_: array<f32, 3>;
    var phi_2175_: array<f32, 3>;
    var phi_2176_: bool;
    var phi_2177_: bool;
    var phi_2182_: array<f32, 3>;
    var phi_2187_: array<f32, 3>;
    var phi_2386_: f32;
    var phi_2401_: f32;
    var phi_2411_: bool;
    var phi_2436_: u32;
    var phi_2446_: u32;
    var phi_2455_: bool;
    var phi_2471_: bool;
    var phi_2472_: bool;
    var phi_2495_: f32;
    var phi_2510_: f32;
    var phi_2520_: bool;
    var phi_2545_: u32;
    var phi_2555_: u32;
    var phi_2564_: bool;
    var phi_2580_: bool;
    var phi_2581_: bool;
    var phi_2662_: bool;
    var phi_2667_: bool;
    var phi_2672_: type_51;
    var phi_2674_: type_51;
    var phi_2676_: bool;
    var phi_2677_: type_51;
    var phi_2679_: bool;
    var phi_2680_: bool;
    var phi_2681_: type_51;
    var phi_2682_: bool;
    var phi_2683_: bool;
    var phi_2684_: bool;
    var phi_2697_: type_51;
    var phi_2704_: bool;
    var phi_5244_: bool;
    var phi_3914_: bool;
    var phi_1833_: u32;
    var phi_1845_: u32;
    var phi_1857_: u32;
    var phi_1869_: u32;
    var phi_5385_: bool;
    var phi_2709_: u32;
    var phi_2710_: bool;
    var phi_2726_: u32;
    var phi_2727_: u32;
    var phi_1444_: u32;
    var phi_1447_: u32;
    var phi_2729_: bool;
    var phi_2730_: bool;
    var phi_5383_: bool;
    var phi_3915_: bool;
    var phi_2743_: f32;
    var phi_5445_: bool;
    var phi_2744_: f32;
    var phi_5444_: bool;
    var phi_547_: f32;
    var phi_549_: f32;
    var phi_551_: f32;
    var phi_5443_: bool;
    var local_5: f32;
    var local_6: f32;
    var phi_2757_: f32;
    var local_7: f32;
    var phi_4257_: bool;
    var phi_4268_: bool;
    var phi_4289_: type_61;
    var phi_4293_: type_61;
    var phi_4294_: vec3<f32>;
    var phi_4295_: vec3<f32>;
    var phi_4335_: vec3<f32>;
    var phi_4338_: vec3<f32>;
    var phi_4339_: bool;
    var phi_4383_: vec3<f32>;
    var phi_4386_: vec3<f32>;
    var phi_4387_: bool;
    var phi_4454_: f32;
    var phi_4462_: f32;
    var phi_4477_: f32;
    var phi_4483_: f32;
    var phi_4491_: f32;
    var phi_4501_: f32;
    var phi_4506_: type_61;
    var phi_4516_: bool;
    var phi_4527_: bool;
    var phi_4548_: type_61;
    var phi_4552_: type_61;
    var phi_4553_: vec3<f32>;
    var phi_4554_: vec3<f32>;
    var phi_4594_: vec3<f32>;
    var phi_4597_: vec3<f32>;
    var phi_4598_: bool;
    var phi_4642_: vec3<f32>;
    var phi_4645_: vec3<f32>;
    var phi_4646_: bool;
    var phi_4713_: f32;
    var phi_4721_: f32;
    var phi_4736_: f32;
    var phi_4742_: f32;
    var phi_4750_: f32;
    var phi_4760_: f32;
    var phi_4765_: type_61;
    var phi_4775_: bool;
    var phi_4807_: type_61;
    var phi_4811_: type_61;
    var phi_4812_: vec3<f32>;
    var phi_4813_: vec3<f32>;
    var phi_4853_: vec3<f32>;
    var phi_4856_: vec3<f32>;
    var phi_4857_: bool;
    var phi_4901_: vec3<f32>;
    var phi_4904_: vec3<f32>;
    var phi_4905_: bool;
    var phi_4972_: f32;
    var phi_4980_: f32;
    var phi_4995_: f32;
    var phi_5001_: f32;
    var phi_5009_: f32;
    var phi_5019_: f32;
    var phi_5024_: type_61;
    var phi_5066_: vec3<f32>;
    var phi_5069_: vec3<f32>;
    var phi_5070_: bool;
    var phi_5114_: vec3<f32>;
    var phi_5117_: vec3<f32>;
    var phi_5118_: bool;
    var phi_5185_: f32;
    var phi_5193_: f32;
    var phi_5208_: f32;
    var phi_5214_: f32;
    var phi_5222_: f32;
    var phi_5232_: f32;
    var local_8: f32;
    var local_9: f32;
    var phi_2791_: f32;
    var phi_2792_: f32;
    var phi_2793_: bool;
    var local_10: f32;
    var phi_2801_: f32;
    var phi_2802_: f32;
    var phi_2811_: vec3<f32>;
    var phi_5451_: bool;
    var phi_2827_: vec3<f32>;
    var phi_5450_: bool;
    var phi_361_: vec3<f32>;
    var phi_5449_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var phi_2832_: vec4<f32>;
    var local_14: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e116 = gid_1;
            let _e119 = arrayLength((&nodes.member));
            let _e128 = arrayLength((&surfaces.member));
            let _e130 = arrayLength((&lights.member));
            let _e137 = params.member.member_1;
            let _e141 = (_e116.x + (_e116.y * 2097152u));
            if (_e141 < _e137) {
                if (_e141 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e146 = surfels.member[_e141];
                if (_e146.member_1 == 4294967295u) {
                    phi_2832_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e153 = vec3<f32>(_e146.member[0], _e146.member[1], _e146.member[2]);
                    let _e165 = params.member.member_2;
                    let _e168 = params.member.member_3;
                    let _e171 = params.member.member_5;
                    let _e174 = params.member.member;
                    let _e180 = params.member.member_4;
                    let _e183 = params.member.member_6;
                    let _e187 = ((_e141 ^ (_e141 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e191 = ((_e187 ^ (_e187 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e195 = (_e183 ^ (_e191 ^ (_e191 >> bitcast<u32>(16i))));
                    let _e199 = ((_e195 ^ (_e195 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e203 = ((_e199 ^ (_e199 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e206 = (_e203 ^ (_e203 >> bitcast<u32>(16i)));
                    let _e207 = (_e165 > _e171);
                    let _e208 = select(_e165, _e168, _e207);
                    let _e215 = ((_e206 ^ (_e206 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e219 = ((_e215 ^ (_e215 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e222 = (_e219 ^ (_e219 >> bitcast<u32>(16i)));
                    phi_5241_ = false;
                    phi_357_ = type_12(0u, (_e208 + select(0u, 1u, (_e180 > 0u))));
                    phi_360_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e229 = phi_5241_;
                        let _e231 = phi_357_;
                        let _e233 = phi_360_;
                        local_11 = _e233;
                        local_12 = _e233;
                        local_13 = _e233;
                        if (_e231.member < _e231.member_1) {
                            phi_358_ = type_12((_e231.member + 1u), _e231.member_1);
                            phi_383_ = type_12(1u, _e231.member);
                        } else {
                            phi_358_ = _e231;
                            phi_383_ = type_12(0u, type_12().member_1);
                        }
                        let _e246 = phi_358_;
                        let _e248 = phi_383_;
                        let _e252 = (bitcast<i32>(_e248.member) != 0i);
                        if _e252 {
                            let _e258 = ((_e222 ^ (_e222 >> bitcast<u32>(16i))) * 2146121005u);
                            let _e262 = ((_e258 ^ (_e258 >> bitcast<u32>(15i))) * 2221713035u);
                            let _e266 = (_e248.member_1 < _e208);
                            if _e266 {
                                if _e207 {
                                    let _e269 = f32(_e208);
                                    phi_422_ = (_e165 - 1u);
                                    phi_425_ = 0u;
                                    loop {
                                        let _e273 = phi_422_;
                                        let _e275 = phi_425_;
                                        local_3 = _e275;
                                        local_4 = _e275;
                                        let _e276 = (_e275 < _e273);
                                        if _e276 {
                                            let _e278 = ((_e275 + _e273) / 2u);
                                            if (_e278 < _e130) {
                                            } else {
                                                phi_5237_ = true;
                                                break;
                                            }
                                            let _e283 = lights.member[_e278].member_5;
                                            let _e284 = (_e283 > ((f32(_e248.member_1) + (f32((_e222 >> bitcast<u32>(8i))) * 0.000000059604645f)) / _e269));
                                            if _e284 {
                                                phi_449_ = _e275;
                                            } else {
                                                phi_449_ = (_e278 + 1u);
                                            }
                                            let _e287 = phi_449_;
                                            phi_423_ = select(_e273, _e278, _e284);
                                            phi_426_ = _e287;
                                        } else {
                                            phi_423_ = u32();
                                            phi_426_ = u32();
                                        }
                                        let _e290 = phi_423_;
                                        let _e292 = phi_426_;
                                        continue;
                                        continuing {
                                            phi_422_ = _e290;
                                            phi_425_ = _e292;
                                            phi_5237_ = _e229;
                                            break if !(_e276);
                                        }
                                    }
                                    let _e295 = phi_5237_;
                                    phi_5449_ = _e295;
                                    if _e295 {
                                        break;
                                    }
                                    let _e297 = local_3;
                                    if (_e297 < _e130) {
                                    } else {
                                        phi_5449_ = true;
                                        break;
                                    }
                                    let _e301 = local_4;
                                    let _e303 = lights.member[_e301];
                                    if (_e303.member_7 > 0f) {
                                        phi_466_ = (1f / (_e303.member_7 * _e269));
                                    } else {
                                        phi_466_ = 0f;
                                    }
                                    let _e309 = phi_466_;
                                    let _e310 = (_e206 + _e248.member_1);
                                    let _e314 = ((_e310 ^ (_e310 >> bitcast<u32>(16i))) * 2146121005u);
                                    let _e318 = ((_e314 ^ (_e314 >> bitcast<u32>(15i))) * 2221713035u);
                                    phi_5275_ = _e295;
                                    phi_476_ = _e303;
                                    phi_477_ = (_e318 ^ (_e318 >> bitcast<u32>(16i)));
                                    phi_478_ = _e309;
                                } else {
                                    phi_5275_ = _e229;
                                    phi_476_ = type_35();
                                    phi_477_ = u32();
                                    phi_478_ = f32();
                                }
                                let _e323 = phi_5275_;
                                let _e325 = phi_476_;
                                let _e327 = phi_477_;
                                let _e329 = phi_478_;
                                phi_5274_ = _e323;
                                phi_480_ = _e325;
                                phi_481_ = _e327;
                                phi_482_ = _e329;
                                phi_483_ = select(true, false, _e207);
                            } else {
                                phi_5274_ = _e229;
                                phi_480_ = type_35();
                                phi_481_ = u32();
                                phi_482_ = f32();
                                phi_483_ = true;
                            }
                            let _e332 = phi_5274_;
                            let _e334 = phi_480_;
                            let _e336 = phi_481_;
                            let _e338 = phi_482_;
                            let _e340 = phi_483_;
                            if _e340 {
                                if _e266 {
                                    if (_e248.member_1 < _e130) {
                                    } else {
                                        phi_5449_ = true;
                                        break;
                                    }
                                    let _e344 = lights.member[_e248.member_1];
                                    let _e348 = ((_e248.member_1 ^ (_e248.member_1 >> bitcast<u32>(16i))) * 2146121005u);
                                    let _e352 = ((_e348 ^ (_e348 >> bitcast<u32>(15i))) * 2221713035u);
                                    let _e356 = (_e206 ^ (_e352 ^ (_e352 >> bitcast<u32>(16i))));
                                    let _e360 = ((_e356 ^ (_e356 >> bitcast<u32>(16i))) * 2146121005u);
                                    let _e364 = ((_e360 ^ (_e360 >> bitcast<u32>(15i))) * 2221713035u);
                                    phi_515_ = _e344;
                                    phi_516_ = (_e364 ^ (_e364 >> bitcast<u32>(16i)));
                                } else {
                                    phi_515_ = type_35(array<f32, 3>(0f, 0f, 0f), 4294967295u, array<f32, 3>(0f, 0f, 0f), 0f, array<f32, 3>(0f, 0f, 0f), 1f, array<f32, 3>(_e174.x, _e174.y, _e174.z), 1f);
                                    phi_516_ = (_e262 ^ (_e262 >> bitcast<u32>(16i)));
                                }
                                let _e369 = phi_515_;
                                let _e371 = phi_516_;
                                phi_518_ = _e369;
                                phi_519_ = _e371;
                                phi_520_ = select(_e180, _e168, _e266);
                            } else {
                                phi_518_ = _e334;
                                phi_519_ = _e336;
                                phi_520_ = 1u;
                            }
                            let _e374 = phi_518_;
                            let _e376 = phi_519_;
                            let _e378 = phi_520_;
                            let _e379 = select(_e338, 1f, _e340);
                            if (_e379 > 0f) {
                                let _e382 = (_e374.member_1 == 3u);
                                if _e382 {
                                    phi_536_ = true;
                                } else {
                                    phi_536_ = (_e374.member_1 == 4294967295u);
                                }
                                let _e385 = phi_536_;
                                let _e386 = select(1u, _e378, _e385);
                                phi_5270_ = _e332;
                                phi_543_ = type_12(0u, _e386);
                                phi_546_ = 340282350000000000000000000000000000000f;
                                phi_548_ = 0f;
                                phi_550_ = 0f;
                                loop {
                                    let _e389 = phi_5270_;
                                    let _e391 = phi_543_;
                                    let _e393 = phi_546_;
                                    let _e395 = phi_548_;
                                    let _e397 = phi_550_;
                                    local_5 = _e395;
                                    local_6 = _e395;
                                    local_14 = _e395;
                                    local_7 = _e393;
                                    local_8 = _e395;
                                    local_9 = _e397;
                                    local_10 = _e395;
                                    if (_e391.member < _e391.member_1) {
                                        phi_544_ = type_12((_e391.member + 1u), _e391.member_1);
                                        phi_573_ = type_12(1u, _e391.member);
                                    } else {
                                        phi_544_ = _e391;
                                        phi_573_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e410 = phi_544_;
                                    let _e412 = phi_573_;
                                    let _e416 = (bitcast<i32>(_e412.member) != 0i);
                                    if _e416 {
                                        let _e426 = (_e374.member[0] - _e146.member[0]);
                                        let _e427 = (_e374.member[1] - _e146.member[1]);
                                        let _e428 = (_e374.member[2] - _e146.member[2]);
                                        if _e382 {
                                            let _e748 = (_e374.member_2[0] - _e374.member[0]);
                                            let _e749 = (_e374.member_2[1] - _e374.member[1]);
                                            let _e750 = (_e374.member_2[2] - _e374.member[2]);
                                            let _e751 = (_e374.member_4[0] - _e374.member[0]);
                                            let _e752 = (_e374.member_4[1] - _e374.member[1]);
                                            let _e753 = (_e374.member_4[2] - _e374.member[2]);
                                            let _e756 = ((_e749 * _e753) - (_e752 * _e750));
                                            let _e759 = ((_e750 * _e751) - (_e753 * _e748));
                                            let _e762 = ((_e748 * _e752) - (_e751 * _e749));
                                            let _e763 = abs(_e756);
                                            let _e764 = abs(_e759);
                                            let _e766 = select(_e764, _e763, (_e763 > _e764));
                                            let _e767 = abs(_e762);
                                            let _e769 = select(_e767, _e766, (_e766 > _e767));
                                            if (_e769 > 0.000000000000000000000000000000000000011754944f) {
                                                let _e771 = (_e769 < 340282350000000000000000000000000000000f);
                                                if _e771 {
                                                    let _e772 = (_e756 / _e769);
                                                    let _e773 = (_e759 / _e769);
                                                    let _e774 = (_e762 / _e769);
                                                    let _e780 = sqrt((((_e772 * _e772) + (_e773 * _e773)) + (_e774 * _e774)));
                                                    phi_652_ = vec3<f32>((_e772 / _e780), (_e773 / _e780), (_e774 / _e780));
                                                } else {
                                                    phi_652_ = vec3<f32>();
                                                }
                                                let _e786 = phi_652_;
                                                phi_654_ = _e786;
                                                phi_655_ = select(true, false, _e771);
                                            } else {
                                                phi_654_ = vec3<f32>();
                                                phi_655_ = true;
                                            }
                                            let _e789 = phi_654_;
                                            let _e791 = phi_655_;
                                            let _e793 = select(_e789, vec3<f32>(0f, 0f, 0f), vec3(_e791));
                                            let _e804 = (((_e793.x * (_e146.member[0] - _e374.member[0])) + (_e793.y * (_e146.member[1] - _e374.member[1]))) + (_e793.z * (_e146.member[2] - _e374.member[2])));
                                            let _e810 = ((_e376 ^ (_e376 >> bitcast<u32>(16i))) * 2146121005u);
                                            let _e814 = ((_e810 ^ (_e810 >> bitcast<u32>(15i))) * 2221713035u);
                                            let _e821 = (_e376 ^ 2654435769u);
                                            let _e825 = ((_e821 ^ (_e821 >> bitcast<u32>(16i))) * 2146121005u);
                                            let _e829 = ((_e825 ^ (_e825 >> bitcast<u32>(15i))) * 2221713035u);
                                            let _e847 = (0.000000059604645f * (f32(((2147483648u + (_e412.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e814 ^ (_e814 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                            if (_e847 >= 1f) {
                                                phi_3939_ = (_e847 - 1f);
                                            } else {
                                                phi_3939_ = _e847;
                                            }
                                            let _e851 = phi_3939_;
                                            let _e853 = (0.000000059604645f * (f32(((2147483648u + (_e412.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e829 ^ (_e829 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                            if (_e853 >= 1f) {
                                                phi_3947_ = (_e853 - 1f);
                                            } else {
                                                phi_3947_ = _e853;
                                            }
                                            let _e857 = phi_3947_;
                                            if (_e851 < _e857) {
                                                let _e862 = (0.5f * _e851);
                                                phi_729_ = vec2<f32>(_e862, (_e857 - _e862));
                                            } else {
                                                let _e859 = (0.5f * _e857);
                                                phi_729_ = vec2<f32>((_e851 - _e859), _e859);
                                            }
                                            let _e866 = phi_729_;
                                            let _e878 = ((_e374.member[0] + (_e748 * _e866.x)) + (_e751 * _e866.y));
                                            let _e879 = ((_e374.member[1] + (_e749 * _e866.x)) + (_e752 * _e866.y));
                                            let _e880 = ((_e374.member[2] + (_e750 * _e866.x)) + (_e753 * _e866.y));
                                            let _e881 = abs(_e878);
                                            let _e882 = abs(_e879);
                                            let _e884 = select(_e882, _e881, (_e881 > _e882));
                                            let _e885 = abs(_e880);
                                            let _e891 = ((select(_e885, _e884, (_e884 > _e885)) + sqrt(_e374.member_3)) * 0.0000009536743f);
                                            let _e895 = (_e878 + (_e793.x * _e891));
                                            let _e896 = (_e879 + (_e793.y * _e891));
                                            let _e897 = (_e880 + (_e793.z * _e891));
                                            let _e903 = (_e878 - _e146.member[0]);
                                            let _e904 = (_e879 - _e146.member[1]);
                                            let _e905 = (_e880 - _e146.member[2]);
                                            let _e910 = (((_e903 * _e903) + (_e904 * _e904)) + (_e905 * _e905));
                                            let _e915 = (((_e146.member_2[0] * _e903) + (_e146.member_2[1] * _e904)) + (_e146.member_2[2] * _e905));
                                            let _e919 = (_e910 * _e910);
                                            phi_1179_ = ((select(0f, _e915, (_e915 > 0f)) * select(0f, _e804, (_e804 > 0f))) / select(0.000000000000000000000000000000000000011754944f, _e919, (_e919 > 0.000000000000000000000000000000000000011754944f)));
                                            phi_1180_ = vec3<f32>((_e895 - _e146.member[0]), (_e896 - _e146.member[1]), (_e897 - _e146.member[2]));
                                            phi_1181_ = _e910;
                                            phi_1182_ = vec3<f32>(_e895, _e896, _e897);
                                            phi_1183_ = type_47();
                                            phi_1184_ = f32();
                                            phi_1185_ = true;
                                        } else {
                                            if (_e374.member_1 == 2u) {
                                                let _e702 = -(_e374.member_2[0]);
                                                let _e703 = -(_e374.member_2[1]);
                                                let _e704 = -(_e374.member_2[2]);
                                                let _e710 = (((_e146.member_2[0] * _e702) + (_e146.member_2[1] * _e703)) + (_e146.member_2[2] * _e704));
                                                phi_1148_ = select(0f, _e710, (_e710 > 0f));
                                                phi_1149_ = vec3<f32>(_e702, _e703, _e704);
                                                phi_1150_ = f32();
                                                phi_1151_ = true;
                                            } else {
                                                let _e431 = (_e374.member_1 == 4294967295u);
                                                if _e431 {
                                                    let _e480 = bitcast<f32>((1065353216u | (bitcast<u32>(_e146.member_2[2]) & 2147483648u)));
                                                    let _e482 = (-1f / (_e480 + _e146.member_2[2]));
                                                    let _e484 = ((_e146.member_2[0] * _e146.member_2[1]) * _e482);
                                                    let _e499 = ((_e376 ^ (_e376 >> bitcast<u32>(16i))) * 2146121005u);
                                                    let _e503 = ((_e499 ^ (_e499 >> bitcast<u32>(15i))) * 2221713035u);
                                                    let _e510 = (_e376 ^ 2654435769u);
                                                    let _e514 = ((_e510 ^ (_e510 >> bitcast<u32>(16i))) * 2146121005u);
                                                    let _e518 = ((_e514 ^ (_e514 >> bitcast<u32>(15i))) * 2221713035u);
                                                    let _e536 = (0.000000059604645f * (f32(((2147483648u + (_e412.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e503 ^ (_e503 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                    if (_e536 >= 1f) {
                                                        phi_3923_ = (_e536 - 1f);
                                                    } else {
                                                        phi_3923_ = _e536;
                                                    }
                                                    let _e540 = phi_3923_;
                                                    let _e542 = (0.000000059604645f * (f32(((2147483648u + (_e412.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e518 ^ (_e518 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                    if (_e542 >= 1f) {
                                                        phi_3931_ = (_e542 - 1f);
                                                    } else {
                                                        phi_3931_ = _e542;
                                                    }
                                                    let _e546 = phi_3931_;
                                                    let _e548 = ((2f * _e540) - 1f);
                                                    let _e550 = ((2f * _e546) - 1f);
                                                    if (_e548 == 0f) {
                                                        let _e552 = (_e550 == 0f);
                                                        phi_909_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e552));
                                                        phi_910_ = select(true, false, _e552);
                                                    } else {
                                                        phi_909_ = vec2<f32>();
                                                        phi_910_ = true;
                                                    }
                                                    let _e557 = phi_909_;
                                                    let _e559 = phi_910_;
                                                    if _e559 {
                                                        if (abs(_e548) > abs(_e550)) {
                                                            let _e616 = (_e550 / _e548);
                                                            let _e620 = floor(((_e616 * 0.5f) + 0.5f));
                                                            let _e626 = ((((0.7853982f * _e616) - (_e620 * 1.5703125f)) - (_e620 * 0.0004837513f)) - (_e620 * 0.0000000754979f));
                                                            let _e627 = (_e626 * _e626);
                                                            let _e634 = (_e626 + ((_e626 * _e627) * (-0.16666655f + (_e627 * (0.008332161f + (_e627 * -0.00019515296f))))));
                                                            let _e643 = ((1f - (0.5f * _e627)) + ((_e627 * _e627) * (0.041666646f + (_e627 * (-0.0013887316f + (_e627 * 0.000024433157f))))));
                                                            let _e650 = select(0i, select(select(i32(_e620), i32(-2147483648), (_e620 < -2147483600f)), 2147483647i, (_e620 > 2147483500f)), (_e620 == _e620));
                                                            let _e652 = ((_e650 & 1i) == 0i);
                                                            let _e653 = select(_e643, _e634, _e652);
                                                            let _e654 = select(_e634, _e643, _e652);
                                                            if ((_e650 & 2i) == 0i) {
                                                                phi_974_ = _e653;
                                                            } else {
                                                                phi_974_ = -(_e653);
                                                            }
                                                            let _e659 = phi_974_;
                                                            if (((_e650 + 1i) & 2i) == 0i) {
                                                                phi_982_ = _e654;
                                                            } else {
                                                                phi_982_ = -(_e654);
                                                            }
                                                            let _e665 = phi_982_;
                                                            phi_1052_ = vec2<f32>((_e548 * _e665), (_e548 * _e659));
                                                        } else {
                                                            let _e563 = (_e548 / _e550);
                                                            let _e567 = floor(((_e563 * 0.5f) + 0.5f));
                                                            let _e573 = ((((0.7853982f * _e563) - (_e567 * 1.5703125f)) - (_e567 * 0.0004837513f)) - (_e567 * 0.0000000754979f));
                                                            let _e574 = (_e573 * _e573);
                                                            let _e581 = (_e573 + ((_e573 * _e574) * (-0.16666655f + (_e574 * (0.008332161f + (_e574 * -0.00019515296f))))));
                                                            let _e590 = ((1f - (0.5f * _e574)) + ((_e574 * _e574) * (0.041666646f + (_e574 * (-0.0013887316f + (_e574 * 0.000024433157f))))));
                                                            let _e597 = select(0i, select(select(i32(_e567), i32(-2147483648), (_e567 < -2147483600f)), 2147483647i, (_e567 > 2147483500f)), (_e567 == _e567));
                                                            let _e599 = ((_e597 & 1i) == 0i);
                                                            let _e600 = select(_e590, _e581, _e599);
                                                            let _e601 = select(_e581, _e590, _e599);
                                                            if ((_e597 & 2i) == 0i) {
                                                                phi_1040_ = _e600;
                                                            } else {
                                                                phi_1040_ = -(_e600);
                                                            }
                                                            let _e606 = phi_1040_;
                                                            if (((_e597 + 1i) & 2i) == 0i) {
                                                                phi_1048_ = _e601;
                                                            } else {
                                                                phi_1048_ = -(_e601);
                                                            }
                                                            let _e612 = phi_1048_;
                                                            phi_1052_ = vec2<f32>((_e550 * _e606), (_e550 * _e612));
                                                        }
                                                        let _e670 = phi_1052_;
                                                        phi_1053_ = _e670;
                                                    } else {
                                                        phi_1053_ = _e557;
                                                    }
                                                    let _e672 = phi_1053_;
                                                    let _e678 = (1f - ((_e672.x * _e672.x) + (_e672.y * _e672.y)));
                                                    let _e681 = sqrt(select(0f, _e678, (_e678 > 0f)));
                                                    phi_1146_ = vec3<f32>(((((1f + (((_e480 * _e146.member_2[0]) * _e146.member_2[0]) * _e482)) * _e672.x) + (_e484 * _e672.y)) + (_e146.member_2[0] * _e681)), ((((_e480 * _e484) * _e672.x) + ((_e480 + ((_e146.member_2[1] * _e146.member_2[1]) * _e482)) * _e672.y)) + (_e146.member_2[1] * _e681)), ((((-(_e480) * _e146.member_2[0]) * _e672.x) + (-(_e146.member_2[1]) * _e672.y)) + (_e146.member_2[2] * _e681)));
                                                    phi_1147_ = f32();
                                                } else {
                                                    let _e437 = sqrt((((_e426 * _e426) + (_e427 * _e427)) + (_e428 * _e428)));
                                                    let _e442 = (((_e146.member_2[0] * _e426) + (_e146.member_2[1] * _e427)) + (_e146.member_2[2] * _e428));
                                                    let _e446 = ((_e437 * _e437) * _e437);
                                                    let _e449 = (select(0f, _e442, (_e442 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e446, (_e446 > 0.000000000000000000000000000000000000011754944f)));
                                                    if (_e374.member_1 == 1u) {
                                                        let _e465 = (_e374.member_4[0] - _e374.member_4[1]);
                                                        let _e468 = (((-((((_e426 * _e374.member_2[0]) + (_e427 * _e374.member_2[1])) + (_e428 * _e374.member_2[2]))) / select(0.000000000000000000000000000000000000011754944f, _e437, (_e437 > 0.000000000000000000000000000000000000011754944f))) - _e374.member_4[1]) / select(0.001f, _e465, (_e465 > 0.001f)));
                                                        let _e470 = select(0f, _e468, (_e468 > 0f));
                                                        let _e472 = select(1f, _e470, (_e470 < 1f));
                                                        phi_1145_ = (_e449 * (_e472 * _e472));
                                                    } else {
                                                        phi_1145_ = _e449;
                                                    }
                                                    let _e476 = phi_1145_;
                                                    phi_1146_ = vec3<f32>();
                                                    phi_1147_ = _e476;
                                                }
                                                let _e699 = phi_1146_;
                                                let _e701 = phi_1147_;
                                                phi_1148_ = 1f;
                                                phi_1149_ = _e699;
                                                phi_1150_ = _e701;
                                                phi_1151_ = _e431;
                                            }
                                            let _e714 = phi_1148_;
                                            let _e716 = phi_1149_;
                                            let _e718 = phi_1150_;
                                            let _e720 = phi_1151_;
                                            if _e720 {
                                                if ((((_e146.member_4[0] * _e716.x) + (_e146.member_4[1] * _e716.y)) + (_e146.member_4[2] * _e716.z)) < 0f) {
                                                    phi_1168_ = -(_e146.member_9);
                                                } else {
                                                    phi_1168_ = _e146.member_9;
                                                }
                                                let _e732 = phi_1168_;
                                                phi_1177_ = type_47(vec3<f32>((_e146.member[0] + (_e146.member_4[0] * _e732)), (_e146.member[1] + (_e146.member_4[1] * _e732)), (_e146.member[2] + (_e146.member_4[2] * _e732))), _e716, 0f, 340282350000000000000000000000000000000f);
                                            } else {
                                                phi_1177_ = type_47();
                                            }
                                            let _e742 = phi_1177_;
                                            phi_1179_ = _e718;
                                            phi_1180_ = vec3<f32>(_e426, _e427, _e428);
                                            phi_1181_ = 340282350000000000000000000000000000000f;
                                            phi_1182_ = vec3<f32>(_e374.member[0], _e374.member[1], _e374.member[2]);
                                            phi_1183_ = _e742;
                                            phi_1184_ = _e714;
                                            phi_1185_ = select(true, false, _e720);
                                        }
                                        let _e924 = phi_1179_;
                                        let _e926 = phi_1180_;
                                        let _e928 = phi_1181_;
                                        let _e930 = phi_1182_;
                                        let _e932 = phi_1183_;
                                        let _e934 = phi_1184_;
                                        let _e936 = phi_1185_;
                                        if _e936 {
                                            if ((((_e146.member_4[0] * _e926.x) + (_e146.member_4[1] * _e926.y)) + (_e146.member_4[2] * _e926.z)) < 0f) {
                                                phi_1202_ = -(_e146.member_9);
                                            } else {
                                                phi_1202_ = _e146.member_9;
                                            }
                                            let _e948 = phi_1202_;
                                            let _e955 = vec3<f32>((_e146.member[0] + (_e146.member_4[0] * _e948)), (_e146.member[1] + (_e146.member_4[1] * _e948)), (_e146.member[2] + (_e146.member_4[2] * _e948)));
                                            phi_1213_ = type_47(_e955, (_e930 - _e955), 0f, 0.9999995f);
                                        } else {
                                            phi_1213_ = _e932;
                                        }
                                        let _e959 = phi_1213_;
                                        let _e960 = select(_e934, _e924, _e936);
                                        let _e961 = select(340282350000000000000000000000000000000f, _e928, _e936);
                                        if (_e960 > 0f) {
                                            let _e968 = abs(_e959.member_1.x);
                                            let _e971 = abs(_e959.member_1.y);
                                            let _e974 = abs(_e959.member_1.z);
                                            let _e975 = (_e968 > _e971);
                                            if _e975 {
                                                phi_1246_ = (_e968 > _e974);
                                            } else {
                                                phi_1246_ = (_e971 > _e974);
                                            }
                                            let _e979 = phi_1246_;
                                            let _e980 = select(1u, 0u, _e975);
                                            if _e979 {
                                                let _e981 = (_e980 + 1u);
                                                phi_1256_ = _e981;
                                                phi_1259_ = select(true, false, (_e981 == 2u));
                                            } else {
                                                phi_1256_ = u32();
                                                phi_1259_ = false;
                                            }
                                            let _e985 = phi_1256_;
                                            let _e987 = phi_1259_;
                                            let _e988 = select(true, false, _e979);
                                            let _e989 = select(_e985, 0u, _e988);
                                            let _e991 = select(_e987, true, _e988);
                                            if _e991 {
                                                phi_1270_ = (_e989 + 1u);
                                            } else {
                                                phi_1270_ = 0u;
                                            }
                                            let _e994 = phi_1270_;
                                            let _e995 = select(_e985, _e989, _e991);
                                            let _e996 = select(_e980, select(_e980, 2u, _e988), _e991);
                                            local_1 = array<f32, 3>(_e959.member_1.x, _e959.member_1.y, _e959.member_1.z);
                                            local_2 = array<f32, 3>(_e959.member.x, _e959.member.y, _e959.member.z);
                                            let _e1005 = (_e996 < 3u);
                                            if _e1005 {
                                            } else {
                                                phi_5443_ = true;
                                                break;
                                            }
                                            let _e1007 = local_1[_e996];
                                            let _e1008 = (1f / _e1007);
                                            let _e1009 = (_e995 < 3u);
                                            if _e1009 {
                                            } else {
                                                phi_5443_ = true;
                                                break;
                                            }
                                            let _e1011 = local_1[_e995];
                                            let _e1012 = (_e1011 * _e1008);
                                            let _e1013 = (_e994 < 3u);
                                            if _e1013 {
                                            } else {
                                                phi_5443_ = true;
                                                break;
                                            }
                                            let _e1015 = local_1[_e994];
                                            let _e1016 = (_e1015 * _e1008);
                                            if _e1009 {
                                            } else {
                                                phi_5443_ = true;
                                                break;
                                            }
                                            let _e1018 = local_2[_e995];
                                            if _e1013 {
                                            } else {
                                                phi_5443_ = true;
                                                break;
                                            }
                                            let _e1020 = local_2[_e994];
                                            if _e1005 {
                                            } else {
                                                phi_5443_ = true;
                                                break;
                                            }
                                            let _e1022 = local_2[_e996];
                                            if (0u < _e119) {
                                            } else {
                                                phi_5443_ = true;
                                                break;
                                            }
                                            let _e1027 = nodes.member[0u].member_7[0u];
                                            let _e1031 = nodes.member[0u].member_7[1u];
                                            let _e1035 = nodes.member[0u].member_7[2u];
                                            let _e1039 = nodes.member[0u].member_7[3u];
                                            let _e1041 = abs((_e959.member.x - _e1027));
                                            let _e1043 = abs((_e959.member.y - _e1031));
                                            let _e1045 = select(_e1043, _e1041, (_e1041 > _e1043));
                                            let _e1047 = abs((_e959.member.z - _e1035));
                                            let _e1051 = ((select(_e1047, _e1045, (_e1045 > _e1047)) + _e1039) * 0.0000009536743f);
                                            let _e1058 = (_e1051 + (abs(_e959.member.x) * 0.00000023841858f));
                                            let _e1059 = (_e1051 + (abs(_e959.member.y) * 0.00000023841858f));
                                            let _e1060 = (_e1051 + (abs(_e959.member.z) * 0.00000023841858f));
                                            let _e1061 = select(_e971, _e968, _e975);
                                            let _e1063 = select(_e974, _e1061, (_e1061 > _e974));
                                            let _e1064 = (_e1063 * 0.000000000001f);
                                            let _e1067 = (_e959.member.x + _e1058);
                                            let _e1069 = (_e959.member.y + _e1059);
                                            let _e1071 = (_e959.member.z + _e1060);
                                            let _e1072 = (_e959.member.x - _e1058);
                                            let _e1073 = (_e959.member.y - _e1059);
                                            let _e1074 = (_e959.member.z - _e1060);
                                            if (_e968 > _e1064) {
                                                phi_1423_ = (1f / _e959.member_1.x);
                                            } else {
                                                phi_1423_ = (1000000000000f / _e1063);
                                            }
                                            let _e1079 = phi_1423_;
                                            if (_e971 > _e1064) {
                                                phi_1431_ = (1f / _e959.member_1.y);
                                            } else {
                                                phi_1431_ = (1000000000000f / _e1063);
                                            }
                                            let _e1084 = phi_1431_;
                                            if (_e974 > _e1064) {
                                                phi_1439_ = (1f / _e959.member_1.z);
                                            } else {
                                                phi_1439_ = (1000000000000f / _e1063);
                                            }
                                            let _e1089 = phi_1439_;
                                            local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                            phi_5248_ = _e389;
                                            phi_1443_ = 0u;
                                            phi_1446_ = 0u;
                                            loop {
                                                let _e1093 = phi_5248_;
                                                let _e1095 = phi_1443_;
                                                let _e1097 = phi_1446_;
                                                let _e1098 = (_e1095 & 15u);
                                                let _e1100 = (_e1095 >> bitcast<u32>(4u));
                                                if (_e1098 == 0u) {
                                                    if (_e1100 < _e119) {
                                                    } else {
                                                        phi_5383_ = true;
                                                        phi_3915_ = bool();
                                                        break;
                                                    }
                                                    let _e1804 = nodes.member[_e1100].member;
                                                    let _e1813 = ((_e1804.x - _e1067) * _e1079);
                                                    let _e1814 = ((_e1804.y - _e1067) * _e1079);
                                                    let _e1815 = ((_e1804.z - _e1067) * _e1079);
                                                    let _e1816 = ((_e1804.w - _e1067) * _e1079);
                                                    let _e1819 = nodes.member[_e1100].member_3;
                                                    let _e1828 = ((_e1819.x - _e1072) * _e1079);
                                                    let _e1829 = ((_e1819.y - _e1072) * _e1079);
                                                    let _e1830 = ((_e1819.z - _e1072) * _e1079);
                                                    let _e1831 = ((_e1819.w - _e1072) * _e1079);
                                                    let _e1834 = nodes.member[_e1100].member_1;
                                                    let _e1843 = ((_e1834.x - _e1069) * _e1084);
                                                    let _e1844 = ((_e1834.y - _e1069) * _e1084);
                                                    let _e1845 = ((_e1834.z - _e1069) * _e1084);
                                                    let _e1846 = ((_e1834.w - _e1069) * _e1084);
                                                    let _e1849 = nodes.member[_e1100].member_4;
                                                    let _e1858 = ((_e1849.x - _e1073) * _e1084);
                                                    let _e1859 = ((_e1849.y - _e1073) * _e1084);
                                                    let _e1860 = ((_e1849.z - _e1073) * _e1084);
                                                    let _e1861 = ((_e1849.w - _e1073) * _e1084);
                                                    let _e1864 = nodes.member[_e1100].member_2;
                                                    let _e1873 = ((_e1864.x - _e1071) * _e1089);
                                                    let _e1874 = ((_e1864.y - _e1071) * _e1089);
                                                    let _e1875 = ((_e1864.z - _e1071) * _e1089);
                                                    let _e1876 = ((_e1864.w - _e1071) * _e1089);
                                                    let _e1879 = nodes.member[_e1100].member_5;
                                                    let _e1888 = ((_e1879.x - _e1074) * _e1089);
                                                    let _e1889 = ((_e1879.y - _e1074) * _e1089);
                                                    let _e1890 = ((_e1879.z - _e1074) * _e1089);
                                                    let _e1891 = ((_e1879.w - _e1074) * _e1089);
                                                    let _e1893 = select(_e1828, _e1813, (_e1813 < _e1828));
                                                    let _e1895 = select(_e1829, _e1814, (_e1814 < _e1829));
                                                    let _e1897 = select(_e1830, _e1815, (_e1815 < _e1830));
                                                    let _e1899 = select(_e1831, _e1816, (_e1816 < _e1831));
                                                    let _e1901 = select(_e1858, _e1843, (_e1843 < _e1858));
                                                    let _e1903 = select(_e1859, _e1844, (_e1844 < _e1859));
                                                    let _e1905 = select(_e1860, _e1845, (_e1845 < _e1860));
                                                    let _e1907 = select(_e1861, _e1846, (_e1846 < _e1861));
                                                    let _e1909 = select(_e1901, _e1893, (_e1893 > _e1901));
                                                    let _e1911 = select(_e1903, _e1895, (_e1895 > _e1903));
                                                    let _e1913 = select(_e1905, _e1897, (_e1897 > _e1905));
                                                    let _e1915 = select(_e1907, _e1899, (_e1899 > _e1907));
                                                    let _e1917 = select(_e1888, _e1873, (_e1873 < _e1888));
                                                    let _e1919 = select(_e1889, _e1874, (_e1874 < _e1889));
                                                    let _e1921 = select(_e1890, _e1875, (_e1875 < _e1890));
                                                    let _e1923 = select(_e1891, _e1876, (_e1876 < _e1891));
                                                    let _e1925 = select(_e1917, _e1909, (_e1909 > _e1917));
                                                    let _e1927 = select(_e1919, _e1911, (_e1911 > _e1919));
                                                    let _e1929 = select(_e1921, _e1913, (_e1913 > _e1921));
                                                    let _e1931 = select(_e1923, _e1915, (_e1915 > _e1923));
                                                    let _e1933 = select(_e959.member_2, _e1925, (_e1925 > _e959.member_2));
                                                    let _e1935 = select(_e959.member_2, _e1927, (_e1927 > _e959.member_2));
                                                    let _e1937 = select(_e959.member_2, _e1929, (_e1929 > _e959.member_2));
                                                    let _e1939 = select(_e959.member_2, _e1931, (_e1931 > _e959.member_2));
                                                    let _e1941 = select(_e1828, _e1813, (_e1813 > _e1828));
                                                    let _e1943 = select(_e1829, _e1814, (_e1814 > _e1829));
                                                    let _e1945 = select(_e1830, _e1815, (_e1815 > _e1830));
                                                    let _e1947 = select(_e1831, _e1816, (_e1816 > _e1831));
                                                    let _e1949 = select(_e1858, _e1843, (_e1843 > _e1858));
                                                    let _e1951 = select(_e1859, _e1844, (_e1844 > _e1859));
                                                    let _e1953 = select(_e1860, _e1845, (_e1845 > _e1860));
                                                    let _e1955 = select(_e1861, _e1846, (_e1846 > _e1861));
                                                    let _e1957 = select(_e1949, _e1941, (_e1941 < _e1949));
                                                    let _e1959 = select(_e1951, _e1943, (_e1943 < _e1951));
                                                    let _e1961 = select(_e1953, _e1945, (_e1945 < _e1953));
                                                    let _e1963 = select(_e1955, _e1947, (_e1947 < _e1955));
                                                    let _e1965 = select(_e1888, _e1873, (_e1873 > _e1888));
                                                    let _e1967 = select(_e1889, _e1874, (_e1874 > _e1889));
                                                    let _e1969 = select(_e1890, _e1875, (_e1875 > _e1890));
                                                    let _e1971 = select(_e1891, _e1876, (_e1876 > _e1891));
                                                    let _e1973 = select(_e1965, _e1957, (_e1957 < _e1965));
                                                    let _e1975 = select(_e1967, _e1959, (_e1959 < _e1967));
                                                    let _e1977 = select(_e1969, _e1961, (_e1961 < _e1969));
                                                    let _e1979 = select(_e1971, _e1963, (_e1963 < _e1971));
                                                    let _e1999 = nodes.member[_e1100].member_6[0u];
                                                    let _e2003 = nodes.member[_e1100].member_6[1u];
                                                    let _e2007 = nodes.member[_e1100].member_6[2u];
                                                    let _e2011 = nodes.member[_e1100].member_6[3u];
                                                    if (select(340282350000000000000000000000000000000f, _e1939, (_e1939 <= select(_e959.member_3, _e1979, (_e1979 < _e959.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1097 < 64u) {
                                                        } else {
                                                            phi_5383_ = true;
                                                            phi_3915_ = bool();
                                                            break;
                                                        }
                                                        local[_e1097] = _e2011;
                                                        phi_1833_ = (_e1097 + 1u);
                                                    } else {
                                                        phi_1833_ = _e1097;
                                                    }
                                                    let _e2017 = phi_1833_;
                                                    if (select(340282350000000000000000000000000000000f, _e1937, (_e1937 <= select(_e959.member_3, _e1977, (_e1977 < _e959.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2017 < 64u) {
                                                        } else {
                                                            phi_5383_ = true;
                                                            phi_3915_ = bool();
                                                            break;
                                                        }
                                                        local[_e2017] = _e2007;
                                                        phi_1845_ = (_e2017 + 1u);
                                                    } else {
                                                        phi_1845_ = _e2017;
                                                    }
                                                    let _e2023 = phi_1845_;
                                                    if (select(340282350000000000000000000000000000000f, _e1935, (_e1935 <= select(_e959.member_3, _e1975, (_e1975 < _e959.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2023 < 64u) {
                                                        } else {
                                                            phi_5383_ = true;
                                                            phi_3915_ = bool();
                                                            break;
                                                        }
                                                        local[_e2023] = _e2003;
                                                        phi_1857_ = (_e2023 + 1u);
                                                    } else {
                                                        phi_1857_ = _e2023;
                                                    }
                                                    let _e2029 = phi_1857_;
                                                    if (select(340282350000000000000000000000000000000f, _e1933, (_e1933 <= select(_e959.member_3, _e1973, (_e1973 < _e959.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2029 < 64u) {
                                                        } else {
                                                            phi_5383_ = true;
                                                            phi_3915_ = bool();
                                                            break;
                                                        }
                                                        local[_e2029] = _e1999;
                                                        phi_1869_ = (_e2029 + 1u);
                                                    } else {
                                                        phi_1869_ = _e2029;
                                                    }
                                                    let _e2035 = phi_1869_;
                                                    phi_5385_ = _e1093;
                                                    phi_2709_ = _e2035;
                                                    phi_2710_ = true;
                                                } else {
                                                    phi_1873_ = type_12(_e1100, (_e1100 + _e1098));
                                                    loop {
                                                        let _e1105 = phi_1873_;
                                                        if (_e1105.member < _e1105.member_1) {
                                                            phi_1874_ = type_12((_e1105.member + 1u), _e1105.member_1);
                                                            phi_1897_ = type_12(1u, _e1105.member);
                                                        } else {
                                                            phi_1874_ = _e1105;
                                                            phi_1897_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e1118 = phi_1874_;
                                                        let _e1120 = phi_1897_;
                                                        let _e1124 = (bitcast<i32>(_e1120.member) != 0i);
                                                        if _e1124 {
                                                            let _e1125 = (_e1120.member_1 < arrayLength((&triangles.member)));
                                                            if _e1125 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            if _e1005 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            let _e1129 = triangles.member[_e1120.member_1].member[_e996];
                                                            let _e1130 = (_e1129 - _e1022);
                                                            if _e1005 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            let _e1134 = triangles.member[_e1120.member_1].member_2[_e996];
                                                            let _e1135 = (_e1134 - _e1022);
                                                            if _e1005 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            let _e1139 = triangles.member[_e1120.member_1].member_4[_e996];
                                                            let _e1140 = (_e1139 - _e1022);
                                                            if _e1009 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            let _e1144 = triangles.member[_e1120.member_1].member[_e995];
                                                            let _e1147 = ((_e1144 - _e1018) - (_e1012 * _e1130));
                                                            if _e1013 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            let _e1151 = triangles.member[_e1120.member_1].member[_e994];
                                                            let _e1154 = ((_e1151 - _e1020) - (_e1016 * _e1130));
                                                            if _e1009 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            let _e1158 = triangles.member[_e1120.member_1].member_2[_e995];
                                                            let _e1161 = ((_e1158 - _e1018) - (_e1012 * _e1135));
                                                            if _e1013 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            let _e1165 = triangles.member[_e1120.member_1].member_2[_e994];
                                                            let _e1168 = ((_e1165 - _e1020) - (_e1016 * _e1135));
                                                            if _e1009 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            let _e1172 = triangles.member[_e1120.member_1].member_4[_e995];
                                                            let _e1175 = ((_e1172 - _e1018) - (_e1012 * _e1140));
                                                            if _e1013 {
                                                            } else {
                                                                phi_5244_ = true;
                                                                phi_3914_ = bool();
                                                                break;
                                                            }
                                                            let _e1179 = triangles.member[_e1120.member_1].member_4[_e994];
                                                            let _e1182 = ((_e1179 - _e1020) - (_e1016 * _e1140));
                                                            let _e1183 = (_e1175 * _e1168);
                                                            let _e1184 = (_e1182 * _e1161);
                                                            if (_e1183 != _e1184) {
                                                                phi_2013_ = (_e1183 - _e1184);
                                                            } else {
                                                                let _e1186 = (_e1175 * 4097f);
                                                                let _e1188 = (_e1186 - (_e1186 - _e1175));
                                                                let _e1189 = (_e1168 * 4097f);
                                                                let _e1191 = (_e1189 - (_e1189 - _e1168));
                                                                let _e1192 = (_e1175 - _e1188);
                                                                let _e1193 = (_e1168 - _e1191);
                                                                let _e1202 = (_e1182 * 4097f);
                                                                let _e1204 = (_e1202 - (_e1202 - _e1182));
                                                                let _e1205 = (_e1161 * 4097f);
                                                                let _e1207 = (_e1205 - (_e1205 - _e1161));
                                                                let _e1208 = (_e1182 - _e1204);
                                                                let _e1209 = (_e1161 - _e1207);
                                                                phi_2013_ = ((((((_e1188 * _e1191) - _e1183) + (_e1188 * _e1193)) + (_e1192 * _e1191)) + (_e1192 * _e1193)) - (((((_e1204 * _e1207) - _e1184) + (_e1204 * _e1209)) + (_e1208 * _e1207)) + (_e1208 * _e1209)));
                                                            }
                                                            let _e1221 = phi_2013_;
                                                            let _e1222 = (_e1147 * _e1182);
                                                            let _e1223 = (_e1154 * _e1175);
                                                            if (_e1222 != _e1223) {
                                                                phi_2024_ = (_e1222 - _e1223);
                                                            } else {
                                                                let _e1225 = (_e1147 * 4097f);
                                                                let _e1227 = (_e1225 - (_e1225 - _e1147));
                                                                let _e1228 = (_e1182 * 4097f);
                                                                let _e1230 = (_e1228 - (_e1228 - _e1182));
                                                                let _e1231 = (_e1147 - _e1227);
                                                                let _e1232 = (_e1182 - _e1230);
                                                                let _e1241 = (_e1154 * 4097f);
                                                                let _e1243 = (_e1241 - (_e1241 - _e1154));
                                                                let _e1244 = (_e1175 * 4097f);
                                                                let _e1246 = (_e1244 - (_e1244 - _e1175));
                                                                let _e1247 = (_e1154 - _e1243);
                                                                let _e1248 = (_e1175 - _e1246);
                                                                phi_2024_ = ((((((_e1227 * _e1230) - _e1222) + (_e1227 * _e1232)) + (_e1231 * _e1230)) + (_e1231 * _e1232)) - (((((_e1243 * _e1246) - _e1223) + (_e1243 * _e1248)) + (_e1247 * _e1246)) + (_e1247 * _e1248)));
                                                            }
                                                            let _e1260 = phi_2024_;
                                                            let _e1261 = (_e1161 * _e1154);
                                                            let _e1262 = (_e1168 * _e1147);
                                                            if (_e1261 != _e1262) {
                                                                phi_2035_ = (_e1261 - _e1262);
                                                            } else {
                                                                let _e1264 = (_e1161 * 4097f);
                                                                let _e1266 = (_e1264 - (_e1264 - _e1161));
                                                                let _e1267 = (_e1154 * 4097f);
                                                                let _e1269 = (_e1267 - (_e1267 - _e1154));
                                                                let _e1270 = (_e1161 - _e1266);
                                                                let _e1271 = (_e1154 - _e1269);
                                                                let _e1280 = (_e1168 * 4097f);
                                                                let _e1282 = (_e1280 - (_e1280 - _e1168));
                                                                let _e1283 = (_e1147 * 4097f);
                                                                let _e1285 = (_e1283 - (_e1283 - _e1147));
                                                                let _e1286 = (_e1168 - _e1282);
                                                                let _e1287 = (_e1147 - _e1285);
                                                                phi_2035_ = ((((((_e1266 * _e1269) - _e1261) + (_e1266 * _e1271)) + (_e1270 * _e1269)) + (_e1270 * _e1271)) - (((((_e1282 * _e1285) - _e1262) + (_e1282 * _e1287)) + (_e1286 * _e1285)) + (_e1286 * _e1287)));
                                                            }
                                                            let _e1299 = phi_2035_;
                                                            if (_e1221 < 0f) {
                                                                phi_2053_ = f32();
                                                                phi_2054_ = true;
                                                            } else {
                                                                if (_e1260 < 0f) {
                                                                    phi_2051_ = f32();
                                                                    phi_2052_ = true;
                                                                } else {
                                                                    let _e1302 = (_e1299 < 0f);
                                                                    if _e1302 {
                                                                        phi_2050_ = f32();
                                                                    } else {
                                                                        phi_2050_ = ((_e1221 + _e1260) + _e1299);
                                                                    }
                                                                    let _e1306 = phi_2050_;
                                                                    phi_2051_ = _e1306;
                                                                    phi_2052_ = _e1302;
                                                                }
                                                                let _e1308 = phi_2051_;
                                                                let _e1310 = phi_2052_;
                                                                phi_2053_ = _e1308;
                                                                phi_2054_ = _e1310;
                                                            }
                                                            let _e1312 = phi_2053_;
                                                            let _e1314 = phi_2054_;
                                                            if _e1314 {
                                                                if (_e1221 > 0f) {
                                                                    phi_2075_ = f32();
                                                                    phi_2076_ = true;
                                                                    phi_2077_ = false;
                                                                } else {
                                                                    let _e1316 = (_e1260 > 0f);
                                                                    if _e1316 {
                                                                        phi_2073_ = f32();
                                                                        phi_2074_ = false;
                                                                    } else {
                                                                        phi_2073_ = ((_e1221 + _e1260) + _e1299);
                                                                        phi_2074_ = select(true, false, (_e1299 > 0f));
                                                                    }
                                                                    let _e1322 = phi_2073_;
                                                                    let _e1324 = phi_2074_;
                                                                    phi_2075_ = _e1322;
                                                                    phi_2076_ = _e1316;
                                                                    phi_2077_ = _e1324;
                                                                }
                                                                let _e1326 = phi_2075_;
                                                                let _e1328 = phi_2076_;
                                                                let _e1330 = phi_2077_;
                                                                phi_2082_ = _e1326;
                                                                phi_2083_ = select(_e1330, false, _e1328);
                                                            } else {
                                                                phi_2082_ = _e1312;
                                                                phi_2083_ = true;
                                                            }
                                                            let _e1333 = phi_2082_;
                                                            let _e1335 = phi_2083_;
                                                            if _e1335 {
                                                                let _e1336 = (_e1333 == 0f);
                                                                if _e1336 {
                                                                    phi_2171_ = array<f32, 3>();
                                                                    phi_2172_ = array<f32, 3>();
                                                                    phi_2173_ = false;
                                                                } else {
                                                                    let _e1337 = (_e1130 * _e1008);
                                                                    let _e1338 = (_e1135 * _e1008);
                                                                    let _e1339 = (_e1140 * _e1008);
                                                                    let _e1342 = (1f / ((_e1221 + _e1260) + _e1299));
                                                                    let _e1343 = (_e1260 * _e1342);
                                                                    let _e1344 = (_e1299 * _e1342);
                                                                    let _e1350 = ((((_e1221 * _e1342) * _e1337) + (_e1343 * _e1338)) + (_e1344 * _e1339));
                                                                    let _e1351 = abs(_e1147);
                                                                    let _e1352 = abs(_e1161);
                                                                    let _e1354 = select(_e1352, _e1351, (_e1351 > _e1352));
                                                                    let _e1355 = abs(_e1175);
                                                                    let _e1358 = abs(_e1154);
                                                                    let _e1359 = abs(_e1168);
                                                                    let _e1361 = select(_e1359, _e1358, (_e1358 > _e1359));
                                                                    let _e1362 = abs(_e1182);
                                                                    let _e1366 = abs(_e1337);
                                                                    let _e1367 = abs(_e1338);
                                                                    let _e1369 = select(_e1367, _e1366, (_e1366 > _e1367));
                                                                    let _e1370 = abs(_e1339);
                                                                    let _e1377 = (((select(_e1355, _e1354, (_e1354 > _e1355)) * select(_e1362, _e1361, (_e1361 > _e1362))) * select(_e1370, _e1369, (_e1369 > _e1370))) <= (abs((_e1333 * _e1350)) * 256f));
                                                                    if _e1377 {
                                                                        phi_2169_ = array<f32, 3>(_e1350, _e1343, _e1344);
                                                                        phi_2170_ = array<f32, 3>();
                                                                    } else {
                                                                        let _e1379 = (_e1175 * 4097f);
                                                                        let _e1381 = (_e1379 - (_e1379 - _e1175));
                                                                        let _e1382 = (_e1168 * 4097f);
                                                                        let _e1384 = (_e1382 - (_e1382 - _e1168));
                                                                        let _e1385 = (_e1175 - _e1381);
                                                                        let _e1386 = (_e1168 - _e1384);
                                                                        let _e1395 = (_e1182 * 4097f);
                                                                        let _e1397 = (_e1395 - (_e1395 - _e1182));
                                                                        let _e1398 = (_e1161 * 4097f);
                                                                        let _e1400 = (_e1398 - (_e1398 - _e1161));
                                                                        let _e1401 = (_e1182 - _e1397);
                                                                        let _e1402 = (_e1161 - _e1400);
                                                                        let _e1412 = ((_e1183 - _e1184) + ((((((_e1381 * _e1384) - _e1183) + (_e1381 * _e1386)) + (_e1385 * _e1384)) + (_e1385 * _e1386)) - (((((_e1397 * _e1400) - _e1184) + (_e1397 * _e1402)) + (_e1401 * _e1400)) + (_e1401 * _e1402))));
                                                                        let _e1414 = (_e1147 * 4097f);
                                                                        let _e1416 = (_e1414 - (_e1414 - _e1147));
                                                                        let _e1417 = (_e1147 - _e1416);
                                                                        let _e1426 = (_e1154 * 4097f);
                                                                        let _e1428 = (_e1426 - (_e1426 - _e1154));
                                                                        let _e1429 = (_e1154 - _e1428);
                                                                        let _e1439 = ((_e1222 - _e1223) + ((((((_e1416 * _e1397) - _e1222) + (_e1416 * _e1401)) + (_e1417 * _e1397)) + (_e1417 * _e1401)) - (((((_e1428 * _e1381) - _e1223) + (_e1428 * _e1385)) + (_e1429 * _e1381)) + (_e1429 * _e1385))));
                                                                        let _e1458 = ((_e1261 - _e1262) + ((((((_e1400 * _e1428) - _e1261) + (_e1400 * _e1429)) + (_e1402 * _e1428)) + (_e1402 * _e1429)) - (((((_e1384 * _e1416) - _e1262) + (_e1384 * _e1417)) + (_e1386 * _e1416)) + (_e1386 * _e1417))));
                                                                        let _e1461 = (1f / ((_e1412 + _e1439) + _e1458));
                                                                        let _e1462 = (_e1439 * _e1461);
                                                                        let _e1463 = (_e1458 * _e1461);
                                                                        phi_2169_ = array<f32, 3>();
                                                                        phi_2170_ = array<f32, 3>(((((_e1412 * _e1461) * _e1337) + (_e1462 * _e1338)) + (_e1463 * _e1339)), _e1462, _e1463);
                                                                    }
                                                                    let _e1473 = phi_2169_;
                                                                    let _e1475 = phi_2170_;
                                                                    phi_2171_ = _e1473;
                                                                    phi_2172_ = _e1475;
                                                                    phi_2173_ = _e1377;
                                                                }
                                                                let _e1477 = phi_2171_;
                                                                let _e1479 = phi_2172_;
                                                                let _e1481 = phi_2173_;
                                                                phi_2174_ = _e1477;
                                                                phi_2175_ = _e1479;
                                                                phi_2176_ = _e1336;
                                                                phi_2177_ = _e1481;
                                                            } else {
                                                                phi_2174_ = array<f32, 3>();
                                                                phi_2175_ = array<f32, 3>();
                                                                phi_2176_ = true;
                                                                phi_2177_ = false;
                                                            }
                                                            let _e1483 = phi_2174_;
                                                            let _e1485 = phi_2175_;
                                                            let _e1487 = phi_2176_;
                                                            let _e1489 = phi_2177_;
                                                            if _e1487 {
                                                                phi_2182_ = array<f32, 3>(-1f, 0f, 0f);
                                                            } else {
                                                                phi_2182_ = _e1483;
                                                            }
                                                            let _e1491 = phi_2182_;
                                                            if select(_e1489, true, _e1487) {
                                                                phi_2187_ = _e1491;
                                                            } else {
                                                                phi_2187_ = _e1485;
                                                            }
                                                            let _e1494 = phi_2187_;
                                                            if (_e1494[0] >= _e959.member_2) {
                                                                let _e1500 = (_e1494[0] < _e959.member_3);
                                                                if _e1500 {
                                                                    let _e1501 = (_e1494[0] >= 0f);
                                                                    if _e1501 {
                                                                        if _e1125 {
                                                                        } else {
                                                                            phi_5244_ = true;
                                                                            phi_3914_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1504 = triangles.member[_e1120.member_1].member_3;
                                                                        if ((_e1504 & 1u) == 0u) {
                                                                            phi_2667_ = true;
                                                                        } else {
                                                                            if _e1125 {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1509 = triangles.member[_e1120.member_1].member_1;
                                                                            let _e1510 = (_e1509 * 12u);
                                                                            if ((256u + _e1510) < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 257u) < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 258u) < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1517 = (_e1510 + 259u);
                                                                            if (_e1517 < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1520 = surfaces.member[_e1517];
                                                                            if ((_e1510 + 260u) < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 261u) < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 262u) < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1527 = (_e1510 + 263u);
                                                                            if (_e1527 < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1530 = surfaces.member[_e1527];
                                                                            let _e1531 = (_e1510 + 264u);
                                                                            if (_e1531 < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1534 = surfaces.member[_e1531];
                                                                            let _e1535 = bitcast<f32>(_e1534);
                                                                            let _e1536 = (_e1510 + 265u);
                                                                            if (_e1536 < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1539 = surfaces.member[_e1536];
                                                                            let _e1540 = bitcast<f32>(_e1539);
                                                                            if ((_e1510 + 266u) < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 267u) < _e128) {
                                                                            } else {
                                                                                phi_5244_ = true;
                                                                                phi_3914_ = bool();
                                                                                break;
                                                                            }
                                                                            if (_e1520 == 4294967295u) {
                                                                                phi_2662_ = (_e1535 < _e1540);
                                                                            } else {
                                                                                if (_e1120.member_1 < arrayLength((&attributes.member))) {
                                                                                } else {
                                                                                    phi_5244_ = true;
                                                                                    phi_3914_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1548 = ((1f - _e1494[1]) - _e1494[2]);
                                                                                let _e1552 = attributes.member[_e1120.member_1].member[0u];
                                                                                let _e1557 = attributes.member[_e1120.member_1].member[2u];
                                                                                let _e1563 = attributes.member[_e1120.member_1].member[4u];
                                                                                let _e1565 = (((_e1552 * _e1548) + (_e1557 * _e1494[1])) + (_e1563 * _e1494[2]));
                                                                                let _e1569 = attributes.member[_e1120.member_1].member[1u];
                                                                                let _e1574 = attributes.member[_e1120.member_1].member[3u];
                                                                                let _e1580 = attributes.member[_e1120.member_1].member[5u];
                                                                                let _e1582 = (((_e1569 * _e1548) + (_e1574 * _e1494[1])) + (_e1580 * _e1494[2]));
                                                                                let _e1583 = (_e1530 & 65535u);
                                                                                let _e1585 = (_e1530 >> bitcast<u32>(16i));
                                                                                let _e1588 = ((_e1520 >> bitcast<u32>(28u)) & 3u);
                                                                                let _e1589 = (_e1583 - 1u);
                                                                                let _e1591 = select(1f, 2f, (_e1588 == 2u));
                                                                                let _e1595 = (_e1565 - (floor((_e1565 / _e1591)) * _e1591));
                                                                                if (_e1595 > 1f) {
                                                                                    phi_2386_ = (_e1591 - _e1595);
                                                                                } else {
                                                                                    phi_2386_ = _e1595;
                                                                                }
                                                                                let _e1599 = phi_2386_;
                                                                                if (_e1588 == 1u) {
                                                                                    let _e1602 = select(0f, _e1565, (_e1565 > 0f));
                                                                                    phi_2401_ = select(1f, _e1602, (_e1602 < 1f));
                                                                                } else {
                                                                                    phi_2401_ = _e1599;
                                                                                }
                                                                                let _e1606 = phi_2401_;
                                                                                if (_e1606 >= 0f) {
                                                                                    phi_2411_ = select(true, false, (_e1606 <= 1f));
                                                                                } else {
                                                                                    phi_2411_ = true;
                                                                                }
                                                                                let _e1611 = phi_2411_;
                                                                                let _e1615 = ((select(_e1606, 0f, _e1611) * f32(_e1583)) - 0.5f);
                                                                                let _e1616 = floor(_e1615);
                                                                                let _e1617 = (_e1616 < 0f);
                                                                                if _e1617 {
                                                                                    phi_2436_ = 0u;
                                                                                } else {
                                                                                    let _e1622 = select(select(u32(_e1616), 0u, (_e1616 < 0f)), 4294967295u, (_e1616 > 4294967000f));
                                                                                    phi_2436_ = select(_e1622, _e1589, (_e1589 < _e1622));
                                                                                }
                                                                                let _e1626 = phi_2436_;
                                                                                if _e1617 {
                                                                                    phi_2446_ = 0u;
                                                                                } else {
                                                                                    let _e1627 = (_e1626 + 1u);
                                                                                    phi_2446_ = select(_e1627, _e1589, (_e1589 < _e1627));
                                                                                }
                                                                                let _e1631 = phi_2446_;
                                                                                let _e1632 = (_e1588 == 0u);
                                                                                if _e1632 {
                                                                                    phi_2455_ = select(true, false, _e1617);
                                                                                } else {
                                                                                    phi_2455_ = true;
                                                                                }
                                                                                let _e1635 = phi_2455_;
                                                                                let _e1636 = select(_e1589, _e1626, _e1635);
                                                                                if _e1632 {
                                                                                    if _e1617 {
                                                                                        phi_2471_ = true;
                                                                                    } else {
                                                                                        phi_2471_ = select(true, false, (_e1636 == _e1589));
                                                                                    }
                                                                                    let _e1640 = phi_2471_;
                                                                                    phi_2472_ = _e1640;
                                                                                } else {
                                                                                    phi_2472_ = true;
                                                                                }
                                                                                let _e1642 = phi_2472_;
                                                                                let _e1643 = select(0u, _e1631, _e1642);
                                                                                let _e1644 = (_e1615 - _e1616);
                                                                                let _e1647 = ((_e1520 >> bitcast<u32>(30u)) & 3u);
                                                                                let _e1648 = (_e1585 - 1u);
                                                                                let _e1650 = select(1f, 2f, (_e1647 == 2u));
                                                                                let _e1654 = (_e1582 - (floor((_e1582 / _e1650)) * _e1650));
                                                                                if (_e1654 > 1f) {
                                                                                    phi_2495_ = (_e1650 - _e1654);
                                                                                } else {
                                                                                    phi_2495_ = _e1654;
                                                                                }
                                                                                let _e1658 = phi_2495_;
                                                                                if (_e1647 == 1u) {
                                                                                    let _e1661 = select(0f, _e1582, (_e1582 > 0f));
                                                                                    phi_2510_ = select(1f, _e1661, (_e1661 < 1f));
                                                                                } else {
                                                                                    phi_2510_ = _e1658;
                                                                                }
                                                                                let _e1665 = phi_2510_;
                                                                                if (_e1665 >= 0f) {
                                                                                    phi_2520_ = select(true, false, (_e1665 <= 1f));
                                                                                } else {
                                                                                    phi_2520_ = true;
                                                                                }
                                                                                let _e1670 = phi_2520_;
                                                                                let _e1674 = ((select(_e1665, 0f, _e1670) * f32(_e1585)) - 0.5f);
                                                                                let _e1675 = floor(_e1674);
                                                                                let _e1676 = (_e1675 < 0f);
                                                                                if _e1676 {
                                                                                    phi_2545_ = 0u;
                                                                                } else {
                                                                                    let _e1681 = select(select(u32(_e1675), 0u, (_e1675 < 0f)), 4294967295u, (_e1675 > 4294967000f));
                                                                                    phi_2545_ = select(_e1681, _e1648, (_e1648 < _e1681));
                                                                                }
                                                                                let _e1685 = phi_2545_;
                                                                                if _e1676 {
                                                                                    phi_2555_ = 0u;
                                                                                } else {
                                                                                    let _e1686 = (_e1685 + 1u);
                                                                                    phi_2555_ = select(_e1686, _e1648, (_e1648 < _e1686));
                                                                                }
                                                                                let _e1690 = phi_2555_;
                                                                                let _e1691 = (_e1647 == 0u);
                                                                                if _e1691 {
                                                                                    phi_2564_ = select(true, false, _e1676);
                                                                                } else {
                                                                                    phi_2564_ = true;
                                                                                }
                                                                                let _e1694 = phi_2564_;
                                                                                let _e1695 = select(_e1648, _e1685, _e1694);
                                                                                if _e1691 {
                                                                                    if _e1676 {
                                                                                        phi_2580_ = true;
                                                                                    } else {
                                                                                        phi_2580_ = select(true, false, (_e1695 == _e1648));
                                                                                    }
                                                                                    let _e1699 = phi_2580_;
                                                                                    phi_2581_ = _e1699;
                                                                                } else {
                                                                                    phi_2581_ = true;
                                                                                }
                                                                                let _e1701 = phi_2581_;
                                                                                let _e1703 = (_e1674 - _e1675);
                                                                                let _e1704 = (_e1520 & 268435455u);
                                                                                let _e1706 = (_e1704 + (_e1695 * _e1583));
                                                                                let _e1708 = (_e1704 + (select(0u, _e1690, _e1701) * _e1583));
                                                                                let _e1709 = (_e1706 + _e1636);
                                                                                let _e1710 = (_e1706 + _e1643);
                                                                                let _e1711 = (_e1708 + _e1636);
                                                                                let _e1712 = (_e1708 + _e1643);
                                                                                if (_e1709 < _e128) {
                                                                                } else {
                                                                                    phi_5244_ = true;
                                                                                    phi_3914_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1715 = surfaces.member[_e1709];
                                                                                if (_e1710 < _e128) {
                                                                                } else {
                                                                                    phi_5244_ = true;
                                                                                    phi_3914_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1718 = surfaces.member[_e1710];
                                                                                if (_e1711 < _e128) {
                                                                                } else {
                                                                                    phi_5244_ = true;
                                                                                    phi_3914_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1721 = surfaces.member[_e1711];
                                                                                if (_e1712 < _e128) {
                                                                                } else {
                                                                                    phi_5244_ = true;
                                                                                    phi_3914_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1724 = surfaces.member[_e1712];
                                                                                let _e1741 = (1f - _e1644);
                                                                                phi_2662_ = ((_e1535 * (((((f32((_e1715 >> bitcast<u32>(24i))) * 0.003921569f) * _e1741) + ((f32((_e1718 >> bitcast<u32>(24i))) * 0.003921569f) * _e1644)) * (1f - _e1703)) + ((((f32((_e1721 >> bitcast<u32>(24i))) * 0.003921569f) * _e1741) + ((f32((_e1724 >> bitcast<u32>(24i))) * 0.003921569f) * _e1644)) * _e1703))) < _e1540);
                                                                            }
                                                                            let _e1756 = phi_2662_;
                                                                            phi_2667_ = select(true, false, _e1756);
                                                                        }
                                                                        let _e1759 = phi_2667_;
                                                                        if _e1759 {
                                                                            phi_2672_ = type_51(_e1494[0], _e1120.member_1, _e1494[1], _e1494[2]);
                                                                        } else {
                                                                            phi_2672_ = type_51();
                                                                        }
                                                                        let _e1762 = phi_2672_;
                                                                        phi_2674_ = _e1762;
                                                                        phi_2676_ = select(true, false, _e1759);
                                                                    } else {
                                                                        phi_2674_ = type_51();
                                                                        phi_2676_ = false;
                                                                    }
                                                                    let _e1765 = phi_2674_;
                                                                    let _e1767 = phi_2676_;
                                                                    phi_2677_ = _e1765;
                                                                    phi_2679_ = select(true, false, _e1501);
                                                                    phi_2680_ = _e1767;
                                                                } else {
                                                                    phi_2677_ = type_51();
                                                                    phi_2679_ = false;
                                                                    phi_2680_ = false;
                                                                }
                                                                let _e1770 = phi_2677_;
                                                                let _e1772 = phi_2679_;
                                                                let _e1774 = phi_2680_;
                                                                phi_2681_ = _e1770;
                                                                phi_2682_ = select(true, false, _e1500);
                                                                phi_2683_ = _e1772;
                                                                phi_2684_ = _e1774;
                                                            } else {
                                                                phi_2681_ = type_51();
                                                                phi_2682_ = true;
                                                                phi_2683_ = false;
                                                                phi_2684_ = false;
                                                            }
                                                            let _e1777 = phi_2681_;
                                                            let _e1779 = phi_2682_;
                                                            let _e1781 = phi_2683_;
                                                            let _e1783 = phi_2684_;
                                                            if select(select(_e1783, false, _e1779), true, select(_e1781, true, _e1779)) {
                                                                phi_2697_ = type_51(_e959.member_3, 4294967295u, 0f, 0f);
                                                            } else {
                                                                phi_2697_ = _e1777;
                                                            }
                                                            let _e1788 = phi_2697_;
                                                            phi_2704_ = select(true, false, (_e1788.member_1 != 4294967295u));
                                                        } else {
                                                            phi_2704_ = false;
                                                        }
                                                        let _e1793 = phi_2704_;
                                                        continue;
                                                        continuing {
                                                            phi_1873_ = _e1118;
                                                            phi_5244_ = _e1093;
                                                            phi_3914_ = select(true, false, _e1124);
                                                            break if !(_e1793);
                                                        }
                                                    }
                                                    let _e1797 = phi_5244_;
                                                    let _e1799 = phi_3914_;
                                                    phi_5383_ = _e1797;
                                                    phi_3915_ = bool();
                                                    if _e1797 {
                                                        break;
                                                    }
                                                    phi_5385_ = _e1797;
                                                    phi_2709_ = _e1097;
                                                    phi_2710_ = _e1799;
                                                }
                                                let _e2037 = phi_5385_;
                                                let _e2039 = phi_2709_;
                                                let _e2041 = phi_2710_;
                                                if _e2041 {
                                                    let _e2042 = (_e2039 == 0u);
                                                    if _e2042 {
                                                        phi_2726_ = u32();
                                                        phi_2727_ = u32();
                                                    } else {
                                                        let _e2043 = (_e2039 - 1u);
                                                        if (_e2043 < 64u) {
                                                        } else {
                                                            phi_5383_ = true;
                                                            phi_3915_ = bool();
                                                            break;
                                                        }
                                                        let _e2046 = local[_e2043];
                                                        phi_2726_ = _e2046;
                                                        phi_2727_ = _e2043;
                                                    }
                                                    let _e2048 = phi_2726_;
                                                    let _e2050 = phi_2727_;
                                                    phi_1444_ = _e2048;
                                                    phi_1447_ = _e2050;
                                                    phi_2729_ = select(true, false, _e2042);
                                                    phi_2730_ = _e2042;
                                                } else {
                                                    phi_1444_ = u32();
                                                    phi_1447_ = u32();
                                                    phi_2729_ = false;
                                                    phi_2730_ = false;
                                                }
                                                let _e2053 = phi_1444_;
                                                let _e2055 = phi_1447_;
                                                let _e2057 = phi_2729_;
                                                let _e2059 = phi_2730_;
                                                continue;
                                                continuing {
                                                    phi_5248_ = _e2037;
                                                    phi_1443_ = _e2053;
                                                    phi_1446_ = _e2055;
                                                    phi_5383_ = _e2037;
                                                    phi_3915_ = _e2059;
                                                    break if !(_e2057);
                                                }
                                            }
                                            let _e2062 = phi_5383_;
                                            let _e2064 = phi_3915_;
                                            phi_5443_ = _e2062;
                                            if _e2062 {
                                                break;
                                            }
                                            if select(false, true, select(true, false, _e2064)) {
                                                phi_2743_ = _e395;
                                            } else {
                                                phi_2743_ = (_e395 + _e960);
                                            }
                                            let _e2069 = phi_2743_;
                                            phi_5445_ = _e2062;
                                            phi_2744_ = _e2069;
                                        } else {
                                            phi_5445_ = _e389;
                                            phi_2744_ = _e395;
                                        }
                                        let _e2071 = phi_5445_;
                                        let _e2073 = phi_2744_;
                                        phi_5444_ = _e2071;
                                        phi_547_ = select(_e961, _e393, (_e393 < _e961));
                                        phi_549_ = _e2073;
                                        phi_551_ = (_e397 + _e960);
                                    } else {
                                        phi_5444_ = _e389;
                                        phi_547_ = f32();
                                        phi_549_ = f32();
                                        phi_551_ = f32();
                                    }
                                    let _e2075 = phi_5444_;
                                    let _e2077 = phi_547_;
                                    let _e2079 = phi_549_;
                                    let _e2081 = phi_551_;
                                    continue;
                                    continuing {
                                        phi_5270_ = _e2075;
                                        phi_543_ = _e410;
                                        phi_546_ = _e2077;
                                        phi_548_ = _e2079;
                                        phi_550_ = _e2081;
                                        phi_5443_ = _e2075;
                                        break if !(_e416);
                                    }
                                }
                                let _e2084 = phi_5443_;
                                phi_5449_ = _e2084;
                                if _e2084 {
                                    break;
                                }
                                let _e2086 = local_5;
                                if (_e2086 <= 0f) {
                                    phi_2811_ = vec3<f32>(0f, 0f, 0f);
                                } else {
                                    if (_e374.member_1 == 4294967295u) {
                                        let _e2090 = local_6;
                                        phi_2757_ = ((3.1415927f * _e2090) / f32(_e386));
                                    } else {
                                        let _e3109 = local_14;
                                        phi_2757_ = _e3109;
                                    }
                                    let _e2095 = phi_2757_;
                                    if _e382 {
                                        if (_e386 == 1u) {
                                            phi_2792_ = f32();
                                            phi_2793_ = true;
                                        } else {
                                            let _e2099 = local_7;
                                            let _e2101 = (_e374.member_3 < (0.01f * _e2099));
                                            if _e2101 {
                                                phi_2791_ = f32();
                                            } else {
                                                let _e2117 = (_e374.member[0] - _e146.member[0]);
                                                let _e2118 = (_e374.member[1] - _e146.member[1]);
                                                let _e2119 = (_e374.member[2] - _e146.member[2]);
                                                let _e2120 = (vec3<f32>(_e374.member[0], _e374.member[1], _e374.member[2]) - _e153);
                                                let _e2121 = (_e374.member_2[0] - _e146.member[0]);
                                                let _e2122 = (_e374.member_2[1] - _e146.member[1]);
                                                let _e2123 = (_e374.member_2[2] - _e146.member[2]);
                                                let _e2124 = (vec3<f32>(_e374.member_2[0], _e374.member_2[1], _e374.member_2[2]) - _e153);
                                                let _e2125 = (_e374.member_4[0] - _e146.member[0]);
                                                let _e2126 = (_e374.member_4[1] - _e146.member[1]);
                                                let _e2127 = (_e374.member_4[2] - _e146.member[2]);
                                                let _e2128 = (vec3<f32>(_e374.member_4[0], _e374.member_4[1], _e374.member_4[2]) - _e153);
                                                let _e2133 = (((_e146.member_2[0] * _e2117) + (_e146.member_2[1] * _e2118)) + (_e146.member_2[2] * _e2119));
                                                let _e2138 = (((_e146.member_2[0] * _e2121) + (_e146.member_2[1] * _e2122)) + (_e146.member_2[2] * _e2123));
                                                let _e2143 = (((_e146.member_2[0] * _e2125) + (_e146.member_2[1] * _e2126)) + (_e146.member_2[2] * _e2127));
                                                let _e2144 = (_e2133 <= 0f);
                                                if _e2144 {
                                                    phi_4257_ = select(true, false, (_e2138 <= 0f));
                                                } else {
                                                    phi_4257_ = true;
                                                }
                                                let _e2148 = phi_4257_;
                                                if _e2148 {
                                                    if _e2144 {
                                                        phi_4268_ = true;
                                                    } else {
                                                        phi_4268_ = (_e2138 <= 0f);
                                                    }
                                                    let _e2151 = phi_4268_;
                                                    if _e2151 {
                                                        let _e2156 = (_e2133 / (_e2133 - _e2138));
                                                        let _e2163 = vec3<f32>((_e2117 + ((_e2121 - _e2117) * _e2156)), (_e2118 + ((_e2122 - _e2118) * _e2156)), (_e2119 + ((_e2123 - _e2119) * _e2156)));
                                                        if _e2144 {
                                                            phi_4289_ = type_61(0f, vec3<f32>(0f, 0f, 0f), _e2163);
                                                        } else {
                                                            phi_4289_ = type_61(0f, _e2163, vec3<f32>(0f, 0f, 0f));
                                                        }
                                                        let _e2167 = phi_4289_;
                                                        let _e2168 = vec3(_e2144);
                                                        phi_4293_ = _e2167;
                                                        phi_4294_ = select(_e2163, _e2124, _e2168);
                                                        phi_4295_ = select(_e2120, _e2163, _e2168);
                                                    } else {
                                                        phi_4293_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                        phi_4294_ = _e2124;
                                                        phi_4295_ = _e2120;
                                                    }
                                                    let _e2172 = phi_4293_;
                                                    let _e2174 = phi_4294_;
                                                    let _e2176 = phi_4295_;
                                                    let _e2178 = abs(_e2176.x);
                                                    let _e2180 = abs(_e2176.y);
                                                    let _e2182 = select(_e2180, _e2178, (_e2178 > _e2180));
                                                    let _e2184 = abs(_e2176.z);
                                                    let _e2186 = select(_e2184, _e2182, (_e2182 > _e2184));
                                                    if (_e2186 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2188 = (_e2186 < 340282350000000000000000000000000000000f);
                                                        if _e2188 {
                                                            let _e2189 = (_e2176.x / _e2186);
                                                            let _e2190 = (_e2176.y / _e2186);
                                                            let _e2191 = (_e2176.z / _e2186);
                                                            let _e2197 = sqrt((((_e2189 * _e2189) + (_e2190 * _e2190)) + (_e2191 * _e2191)));
                                                            phi_4335_ = vec3<f32>((_e2189 / _e2197), (_e2190 / _e2197), (_e2191 / _e2197));
                                                        } else {
                                                            phi_4335_ = vec3<f32>();
                                                        }
                                                        let _e2203 = phi_4335_;
                                                        phi_4338_ = _e2203;
                                                        phi_4339_ = select(true, false, _e2188);
                                                    } else {
                                                        phi_4338_ = vec3<f32>();
                                                        phi_4339_ = true;
                                                    }
                                                    let _e2206 = phi_4338_;
                                                    let _e2208 = phi_4339_;
                                                    let _e2210 = select(_e2206, vec3<f32>(0f, 0f, 0f), vec3(_e2208));
                                                    let _e2212 = abs(_e2174.x);
                                                    let _e2214 = abs(_e2174.y);
                                                    let _e2216 = select(_e2214, _e2212, (_e2212 > _e2214));
                                                    let _e2218 = abs(_e2174.z);
                                                    let _e2220 = select(_e2218, _e2216, (_e2216 > _e2218));
                                                    if (_e2220 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2222 = (_e2220 < 340282350000000000000000000000000000000f);
                                                        if _e2222 {
                                                            let _e2223 = (_e2174.x / _e2220);
                                                            let _e2224 = (_e2174.y / _e2220);
                                                            let _e2225 = (_e2174.z / _e2220);
                                                            let _e2231 = sqrt((((_e2223 * _e2223) + (_e2224 * _e2224)) + (_e2225 * _e2225)));
                                                            phi_4383_ = vec3<f32>((_e2223 / _e2231), (_e2224 / _e2231), (_e2225 / _e2231));
                                                        } else {
                                                            phi_4383_ = vec3<f32>();
                                                        }
                                                        let _e2237 = phi_4383_;
                                                        phi_4386_ = _e2237;
                                                        phi_4387_ = select(true, false, _e2222);
                                                    } else {
                                                        phi_4386_ = vec3<f32>();
                                                        phi_4387_ = true;
                                                    }
                                                    let _e2240 = phi_4386_;
                                                    let _e2242 = phi_4387_;
                                                    let _e2244 = select(_e2240, vec3<f32>(0f, 0f, 0f), vec3(_e2242));
                                                    let _e2251 = ((_e2210.y * _e2244.z) - (_e2244.y * _e2210.z));
                                                    let _e2256 = ((_e2210.z * _e2244.x) - (_e2244.z * _e2210.x));
                                                    let _e2259 = ((_e2210.x * _e2244.y) - (_e2244.x * _e2210.y));
                                                    let _e2265 = sqrt((((_e2251 * _e2251) + (_e2256 * _e2256)) + (_e2259 * _e2259)));
                                                    if (_e2265 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_4501_ = 0f;
                                                    } else {
                                                        let _e2277 = (((_e2210.x * _e2244.x) + (_e2210.y * _e2244.y)) + (_e2210.z * _e2244.z));
                                                        let _e2278 = abs(_e2277);
                                                        let _e2279 = abs(_e2265);
                                                        let _e2280 = (_e2279 > _e2278);
                                                        let _e2281 = select(_e2278, _e2279, _e2280);
                                                        if (_e2281 > 0f) {
                                                            phi_4454_ = (select(_e2279, _e2278, _e2280) / _e2281);
                                                        } else {
                                                            phi_4454_ = 0f;
                                                        }
                                                        let _e2286 = phi_4454_;
                                                        let _e2287 = (_e2286 > 0.41421357f);
                                                        if _e2287 {
                                                            phi_4462_ = ((_e2286 - 1f) / (_e2286 + 1f));
                                                        } else {
                                                            phi_4462_ = _e2286;
                                                        }
                                                        let _e2292 = phi_4462_;
                                                        let _e2293 = (_e2292 * _e2292);
                                                        let _e2302 = (_e2292 + ((_e2292 * _e2293) * (-0.3333295f + (_e2293 * (0.19977711f + (_e2293 * (-0.13877685f + (_e2293 * 0.080537446f))))))));
                                                        if _e2287 {
                                                            phi_4477_ = (_e2302 + 0.7853982f);
                                                        } else {
                                                            phi_4477_ = _e2302;
                                                        }
                                                        let _e2305 = phi_4477_;
                                                        if _e2280 {
                                                            phi_4483_ = (1.5707964f - _e2305);
                                                        } else {
                                                            phi_4483_ = _e2305;
                                                        }
                                                        let _e2308 = phi_4483_;
                                                        if ((bitcast<u32>(_e2277) & 2147483648u) == 0u) {
                                                            phi_4491_ = _e2308;
                                                        } else {
                                                            phi_4491_ = (3.1415927f - _e2308);
                                                        }
                                                        let _e2314 = phi_4491_;
                                                        phi_4501_ = (((((_e146.member_2[0] * _e2251) + (_e146.member_2[1] * _e2256)) + (_e146.member_2[2] * _e2259)) / _e2265) * bitcast<f32>(((bitcast<u32>(_e2314) & 2147483647u) | (bitcast<u32>(_e2265) & 2147483648u))));
                                                    }
                                                    let _e2323 = phi_4501_;
                                                    phi_4506_ = type_61((_e2172.member + _e2323), _e2172.member_1, _e2172.member_2);
                                                } else {
                                                    phi_4506_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                }
                                                let _e2331 = phi_4506_;
                                                let _e2332 = (_e2138 <= 0f);
                                                if _e2332 {
                                                    phi_4516_ = select(true, false, (_e2143 <= 0f));
                                                } else {
                                                    phi_4516_ = true;
                                                }
                                                let _e2336 = phi_4516_;
                                                if _e2336 {
                                                    if _e2332 {
                                                        phi_4527_ = true;
                                                    } else {
                                                        phi_4527_ = (_e2143 <= 0f);
                                                    }
                                                    let _e2339 = phi_4527_;
                                                    if _e2339 {
                                                        let _e2344 = (_e2138 / (_e2138 - _e2143));
                                                        let _e2351 = vec3<f32>((_e2121 + ((_e2125 - _e2121) * _e2344)), (_e2122 + ((_e2126 - _e2122) * _e2344)), (_e2123 + ((_e2127 - _e2123) * _e2344)));
                                                        if _e2332 {
                                                            phi_4548_ = type_61(_e2331.member, _e2331.member_1, _e2351);
                                                        } else {
                                                            phi_4548_ = type_61(_e2331.member, _e2351, _e2331.member_2);
                                                        }
                                                        let _e2361 = phi_4548_;
                                                        let _e2362 = vec3(_e2332);
                                                        phi_4552_ = _e2361;
                                                        phi_4553_ = select(_e2351, _e2128, _e2362);
                                                        phi_4554_ = select(_e2124, _e2351, _e2362);
                                                    } else {
                                                        phi_4552_ = _e2331;
                                                        phi_4553_ = _e2128;
                                                        phi_4554_ = _e2124;
                                                    }
                                                    let _e2366 = phi_4552_;
                                                    let _e2368 = phi_4553_;
                                                    let _e2370 = phi_4554_;
                                                    let _e2372 = abs(_e2370.x);
                                                    let _e2374 = abs(_e2370.y);
                                                    let _e2376 = select(_e2374, _e2372, (_e2372 > _e2374));
                                                    let _e2378 = abs(_e2370.z);
                                                    let _e2380 = select(_e2378, _e2376, (_e2376 > _e2378));
                                                    if (_e2380 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2382 = (_e2380 < 340282350000000000000000000000000000000f);
                                                        if _e2382 {
                                                            let _e2383 = (_e2370.x / _e2380);
                                                            let _e2384 = (_e2370.y / _e2380);
                                                            let _e2385 = (_e2370.z / _e2380);
                                                            let _e2391 = sqrt((((_e2383 * _e2383) + (_e2384 * _e2384)) + (_e2385 * _e2385)));
                                                            phi_4594_ = vec3<f32>((_e2383 / _e2391), (_e2384 / _e2391), (_e2385 / _e2391));
                                                        } else {
                                                            phi_4594_ = vec3<f32>();
                                                        }
                                                        let _e2397 = phi_4594_;
                                                        phi_4597_ = _e2397;
                                                        phi_4598_ = select(true, false, _e2382);
                                                    } else {
                                                        phi_4597_ = vec3<f32>();
                                                        phi_4598_ = true;
                                                    }
                                                    let _e2400 = phi_4597_;
                                                    let _e2402 = phi_4598_;
                                                    let _e2404 = select(_e2400, vec3<f32>(0f, 0f, 0f), vec3(_e2402));
                                                    let _e2406 = abs(_e2368.x);
                                                    let _e2408 = abs(_e2368.y);
                                                    let _e2410 = select(_e2408, _e2406, (_e2406 > _e2408));
                                                    let _e2412 = abs(_e2368.z);
                                                    let _e2414 = select(_e2412, _e2410, (_e2410 > _e2412));
                                                    if (_e2414 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2416 = (_e2414 < 340282350000000000000000000000000000000f);
                                                        if _e2416 {
                                                            let _e2417 = (_e2368.x / _e2414);
                                                            let _e2418 = (_e2368.y / _e2414);
                                                            let _e2419 = (_e2368.z / _e2414);
                                                            let _e2425 = sqrt((((_e2417 * _e2417) + (_e2418 * _e2418)) + (_e2419 * _e2419)));
                                                            phi_4642_ = vec3<f32>((_e2417 / _e2425), (_e2418 / _e2425), (_e2419 / _e2425));
                                                        } else {
                                                            phi_4642_ = vec3<f32>();
                                                        }
                                                        let _e2431 = phi_4642_;
                                                        phi_4645_ = _e2431;
                                                        phi_4646_ = select(true, false, _e2416);
                                                    } else {
                                                        phi_4645_ = vec3<f32>();
                                                        phi_4646_ = true;
                                                    }
                                                    let _e2434 = phi_4645_;
                                                    let _e2436 = phi_4646_;
                                                    let _e2438 = select(_e2434, vec3<f32>(0f, 0f, 0f), vec3(_e2436));
                                                    let _e2445 = ((_e2404.y * _e2438.z) - (_e2438.y * _e2404.z));
                                                    let _e2450 = ((_e2404.z * _e2438.x) - (_e2438.z * _e2404.x));
                                                    let _e2453 = ((_e2404.x * _e2438.y) - (_e2438.x * _e2404.y));
                                                    let _e2459 = sqrt((((_e2445 * _e2445) + (_e2450 * _e2450)) + (_e2453 * _e2453)));
                                                    if (_e2459 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_4760_ = 0f;
                                                    } else {
                                                        let _e2471 = (((_e2404.x * _e2438.x) + (_e2404.y * _e2438.y)) + (_e2404.z * _e2438.z));
                                                        let _e2472 = abs(_e2471);
                                                        let _e2473 = abs(_e2459);
                                                        let _e2474 = (_e2473 > _e2472);
                                                        let _e2475 = select(_e2472, _e2473, _e2474);
                                                        if (_e2475 > 0f) {
                                                            phi_4713_ = (select(_e2473, _e2472, _e2474) / _e2475);
                                                        } else {
                                                            phi_4713_ = 0f;
                                                        }
                                                        let _e2480 = phi_4713_;
                                                        let _e2481 = (_e2480 > 0.41421357f);
                                                        if _e2481 {
                                                            phi_4721_ = ((_e2480 - 1f) / (_e2480 + 1f));
                                                        } else {
                                                            phi_4721_ = _e2480;
                                                        }
                                                        let _e2486 = phi_4721_;
                                                        let _e2487 = (_e2486 * _e2486);
                                                        let _e2496 = (_e2486 + ((_e2486 * _e2487) * (-0.3333295f + (_e2487 * (0.19977711f + (_e2487 * (-0.13877685f + (_e2487 * 0.080537446f))))))));
                                                        if _e2481 {
                                                            phi_4736_ = (_e2496 + 0.7853982f);
                                                        } else {
                                                            phi_4736_ = _e2496;
                                                        }
                                                        let _e2499 = phi_4736_;
                                                        if _e2474 {
                                                            phi_4742_ = (1.5707964f - _e2499);
                                                        } else {
                                                            phi_4742_ = _e2499;
                                                        }
                                                        let _e2502 = phi_4742_;
                                                        if ((bitcast<u32>(_e2471) & 2147483648u) == 0u) {
                                                            phi_4750_ = _e2502;
                                                        } else {
                                                            phi_4750_ = (3.1415927f - _e2502);
                                                        }
                                                        let _e2508 = phi_4750_;
                                                        phi_4760_ = (((((_e146.member_2[0] * _e2445) + (_e146.member_2[1] * _e2450)) + (_e146.member_2[2] * _e2453)) / _e2459) * bitcast<f32>(((bitcast<u32>(_e2508) & 2147483647u) | (bitcast<u32>(_e2459) & 2147483648u))));
                                                    }
                                                    let _e2517 = phi_4760_;
                                                    phi_4765_ = type_61((_e2366.member + _e2517), _e2366.member_1, _e2366.member_2);
                                                } else {
                                                    phi_4765_ = _e2331;
                                                }
                                                let _e2525 = phi_4765_;
                                                let _e2526 = (_e2143 <= 0f);
                                                if _e2526 {
                                                    phi_4775_ = select(true, false, _e2144);
                                                } else {
                                                    phi_4775_ = true;
                                                }
                                                let _e2529 = phi_4775_;
                                                if _e2529 {
                                                    if select(_e2144, true, _e2526) {
                                                        let _e2535 = (_e2143 / (_e2143 - _e2133));
                                                        let _e2542 = vec3<f32>((_e2125 + ((_e2117 - _e2125) * _e2535)), (_e2126 + ((_e2118 - _e2126) * _e2535)), (_e2127 + ((_e2119 - _e2127) * _e2535)));
                                                        if _e2526 {
                                                            phi_4807_ = type_61(_e2525.member, _e2525.member_1, _e2542);
                                                        } else {
                                                            phi_4807_ = type_61(_e2525.member, _e2542, _e2525.member_2);
                                                        }
                                                        let _e2552 = phi_4807_;
                                                        let _e2553 = vec3(_e2526);
                                                        phi_4811_ = _e2552;
                                                        phi_4812_ = select(_e2542, _e2120, _e2553);
                                                        phi_4813_ = select(_e2128, _e2542, _e2553);
                                                    } else {
                                                        phi_4811_ = _e2525;
                                                        phi_4812_ = _e2120;
                                                        phi_4813_ = _e2128;
                                                    }
                                                    let _e2557 = phi_4811_;
                                                    let _e2559 = phi_4812_;
                                                    let _e2561 = phi_4813_;
                                                    let _e2563 = abs(_e2561.x);
                                                    let _e2565 = abs(_e2561.y);
                                                    let _e2567 = select(_e2565, _e2563, (_e2563 > _e2565));
                                                    let _e2569 = abs(_e2561.z);
                                                    let _e2571 = select(_e2569, _e2567, (_e2567 > _e2569));
                                                    if (_e2571 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2573 = (_e2571 < 340282350000000000000000000000000000000f);
                                                        if _e2573 {
                                                            let _e2574 = (_e2561.x / _e2571);
                                                            let _e2575 = (_e2561.y / _e2571);
                                                            let _e2576 = (_e2561.z / _e2571);
                                                            let _e2582 = sqrt((((_e2574 * _e2574) + (_e2575 * _e2575)) + (_e2576 * _e2576)));
                                                            phi_4853_ = vec3<f32>((_e2574 / _e2582), (_e2575 / _e2582), (_e2576 / _e2582));
                                                        } else {
                                                            phi_4853_ = vec3<f32>();
                                                        }
                                                        let _e2588 = phi_4853_;
                                                        phi_4856_ = _e2588;
                                                        phi_4857_ = select(true, false, _e2573);
                                                    } else {
                                                        phi_4856_ = vec3<f32>();
                                                        phi_4857_ = true;
                                                    }
                                                    let _e2591 = phi_4856_;
                                                    let _e2593 = phi_4857_;
                                                    let _e2595 = select(_e2591, vec3<f32>(0f, 0f, 0f), vec3(_e2593));
                                                    let _e2597 = abs(_e2559.x);
                                                    let _e2599 = abs(_e2559.y);
                                                    let _e2601 = select(_e2599, _e2597, (_e2597 > _e2599));
                                                    let _e2603 = abs(_e2559.z);
                                                    let _e2605 = select(_e2603, _e2601, (_e2601 > _e2603));
                                                    if (_e2605 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2607 = (_e2605 < 340282350000000000000000000000000000000f);
                                                        if _e2607 {
                                                            let _e2608 = (_e2559.x / _e2605);
                                                            let _e2609 = (_e2559.y / _e2605);
                                                            let _e2610 = (_e2559.z / _e2605);
                                                            let _e2616 = sqrt((((_e2608 * _e2608) + (_e2609 * _e2609)) + (_e2610 * _e2610)));
                                                            phi_4901_ = vec3<f32>((_e2608 / _e2616), (_e2609 / _e2616), (_e2610 / _e2616));
                                                        } else {
                                                            phi_4901_ = vec3<f32>();
                                                        }
                                                        let _e2622 = phi_4901_;
                                                        phi_4904_ = _e2622;
                                                        phi_4905_ = select(true, false, _e2607);
                                                    } else {
                                                        phi_4904_ = vec3<f32>();
                                                        phi_4905_ = true;
                                                    }
                                                    let _e2625 = phi_4904_;
                                                    let _e2627 = phi_4905_;
                                                    let _e2629 = select(_e2625, vec3<f32>(0f, 0f, 0f), vec3(_e2627));
                                                    let _e2636 = ((_e2595.y * _e2629.z) - (_e2629.y * _e2595.z));
                                                    let _e2641 = ((_e2595.z * _e2629.x) - (_e2629.z * _e2595.x));
                                                    let _e2644 = ((_e2595.x * _e2629.y) - (_e2629.x * _e2595.y));
                                                    let _e2650 = sqrt((((_e2636 * _e2636) + (_e2641 * _e2641)) + (_e2644 * _e2644)));
                                                    if (_e2650 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_5019_ = 0f;
                                                    } else {
                                                        let _e2662 = (((_e2595.x * _e2629.x) + (_e2595.y * _e2629.y)) + (_e2595.z * _e2629.z));
                                                        let _e2663 = abs(_e2662);
                                                        let _e2664 = abs(_e2650);
                                                        let _e2665 = (_e2664 > _e2663);
                                                        let _e2666 = select(_e2663, _e2664, _e2665);
                                                        if (_e2666 > 0f) {
                                                            phi_4972_ = (select(_e2664, _e2663, _e2665) / _e2666);
                                                        } else {
                                                            phi_4972_ = 0f;
                                                        }
                                                        let _e2671 = phi_4972_;
                                                        let _e2672 = (_e2671 > 0.41421357f);
                                                        if _e2672 {
                                                            phi_4980_ = ((_e2671 - 1f) / (_e2671 + 1f));
                                                        } else {
                                                            phi_4980_ = _e2671;
                                                        }
                                                        let _e2677 = phi_4980_;
                                                        let _e2678 = (_e2677 * _e2677);
                                                        let _e2687 = (_e2677 + ((_e2677 * _e2678) * (-0.3333295f + (_e2678 * (0.19977711f + (_e2678 * (-0.13877685f + (_e2678 * 0.080537446f))))))));
                                                        if _e2672 {
                                                            phi_4995_ = (_e2687 + 0.7853982f);
                                                        } else {
                                                            phi_4995_ = _e2687;
                                                        }
                                                        let _e2690 = phi_4995_;
                                                        if _e2665 {
                                                            phi_5001_ = (1.5707964f - _e2690);
                                                        } else {
                                                            phi_5001_ = _e2690;
                                                        }
                                                        let _e2693 = phi_5001_;
                                                        if ((bitcast<u32>(_e2662) & 2147483648u) == 0u) {
                                                            phi_5009_ = _e2693;
                                                        } else {
                                                            phi_5009_ = (3.1415927f - _e2693);
                                                        }
                                                        let _e2699 = phi_5009_;
                                                        phi_5019_ = (((((_e146.member_2[0] * _e2636) + (_e146.member_2[1] * _e2641)) + (_e146.member_2[2] * _e2644)) / _e2650) * bitcast<f32>(((bitcast<u32>(_e2699) & 2147483647u) | (bitcast<u32>(_e2650) & 2147483648u))));
                                                    }
                                                    let _e2708 = phi_5019_;
                                                    phi_5024_ = type_61((_e2557.member + _e2708), _e2557.member_1, _e2557.member_2);
                                                } else {
                                                    phi_5024_ = _e2525;
                                                }
                                                let _e2716 = phi_5024_;
                                                let _e2720 = abs(_e2716.member_1.x);
                                                let _e2722 = abs(_e2716.member_1.y);
                                                let _e2724 = select(_e2722, _e2720, (_e2720 > _e2722));
                                                let _e2726 = abs(_e2716.member_1.z);
                                                let _e2728 = select(_e2726, _e2724, (_e2724 > _e2726));
                                                if (_e2728 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2730 = (_e2728 < 340282350000000000000000000000000000000f);
                                                    if _e2730 {
                                                        let _e2731 = (_e2716.member_1.x / _e2728);
                                                        let _e2732 = (_e2716.member_1.y / _e2728);
                                                        let _e2733 = (_e2716.member_1.z / _e2728);
                                                        let _e2739 = sqrt((((_e2731 * _e2731) + (_e2732 * _e2732)) + (_e2733 * _e2733)));
                                                        phi_5066_ = vec3<f32>((_e2731 / _e2739), (_e2732 / _e2739), (_e2733 / _e2739));
                                                    } else {
                                                        phi_5066_ = vec3<f32>();
                                                    }
                                                    let _e2745 = phi_5066_;
                                                    phi_5069_ = _e2745;
                                                    phi_5070_ = select(true, false, _e2730);
                                                } else {
                                                    phi_5069_ = vec3<f32>();
                                                    phi_5070_ = true;
                                                }
                                                let _e2748 = phi_5069_;
                                                let _e2750 = phi_5070_;
                                                let _e2752 = select(_e2748, vec3<f32>(0f, 0f, 0f), vec3(_e2750));
                                                let _e2754 = abs(_e2716.member_2.x);
                                                let _e2756 = abs(_e2716.member_2.y);
                                                let _e2758 = select(_e2756, _e2754, (_e2754 > _e2756));
                                                let _e2760 = abs(_e2716.member_2.z);
                                                let _e2762 = select(_e2760, _e2758, (_e2758 > _e2760));
                                                if (_e2762 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2764 = (_e2762 < 340282350000000000000000000000000000000f);
                                                    if _e2764 {
                                                        let _e2765 = (_e2716.member_2.x / _e2762);
                                                        let _e2766 = (_e2716.member_2.y / _e2762);
                                                        let _e2767 = (_e2716.member_2.z / _e2762);
                                                        let _e2773 = sqrt((((_e2765 * _e2765) + (_e2766 * _e2766)) + (_e2767 * _e2767)));
                                                        phi_5114_ = vec3<f32>((_e2765 / _e2773), (_e2766 / _e2773), (_e2767 / _e2773));
                                                    } else {
                                                        phi_5114_ = vec3<f32>();
                                                    }
                                                    let _e2779 = phi_5114_;
                                                    phi_5117_ = _e2779;
                                                    phi_5118_ = select(true, false, _e2764);
                                                } else {
                                                    phi_5117_ = vec3<f32>();
                                                    phi_5118_ = true;
                                                }
                                                let _e2782 = phi_5117_;
                                                let _e2784 = phi_5118_;
                                                let _e2786 = select(_e2782, vec3<f32>(0f, 0f, 0f), vec3(_e2784));
                                                let _e2793 = ((_e2752.y * _e2786.z) - (_e2786.y * _e2752.z));
                                                let _e2798 = ((_e2752.z * _e2786.x) - (_e2786.z * _e2752.x));
                                                let _e2801 = ((_e2752.x * _e2786.y) - (_e2786.x * _e2752.y));
                                                let _e2807 = sqrt((((_e2793 * _e2793) + (_e2798 * _e2798)) + (_e2801 * _e2801)));
                                                if (_e2807 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5232_ = 0f;
                                                } else {
                                                    let _e2819 = (((_e2752.x * _e2786.x) + (_e2752.y * _e2786.y)) + (_e2752.z * _e2786.z));
                                                    let _e2820 = abs(_e2819);
                                                    let _e2821 = abs(_e2807);
                                                    let _e2822 = (_e2821 > _e2820);
                                                    let _e2823 = select(_e2820, _e2821, _e2822);
                                                    if (_e2823 > 0f) {
                                                        phi_5185_ = (select(_e2821, _e2820, _e2822) / _e2823);
                                                    } else {
                                                        phi_5185_ = 0f;
                                                    }
                                                    let _e2828 = phi_5185_;
                                                    let _e2829 = (_e2828 > 0.41421357f);
                                                    if _e2829 {
                                                        phi_5193_ = ((_e2828 - 1f) / (_e2828 + 1f));
                                                    } else {
                                                        phi_5193_ = _e2828;
                                                    }
                                                    let _e2834 = phi_5193_;
                                                    let _e2835 = (_e2834 * _e2834);
                                                    let _e2844 = (_e2834 + ((_e2834 * _e2835) * (-0.3333295f + (_e2835 * (0.19977711f + (_e2835 * (-0.13877685f + (_e2835 * 0.080537446f))))))));
                                                    if _e2829 {
                                                        phi_5208_ = (_e2844 + 0.7853982f);
                                                    } else {
                                                        phi_5208_ = _e2844;
                                                    }
                                                    let _e2847 = phi_5208_;
                                                    if _e2822 {
                                                        phi_5214_ = (1.5707964f - _e2847);
                                                    } else {
                                                        phi_5214_ = _e2847;
                                                    }
                                                    let _e2850 = phi_5214_;
                                                    if ((bitcast<u32>(_e2819) & 2147483648u) == 0u) {
                                                        phi_5222_ = _e2850;
                                                    } else {
                                                        phi_5222_ = (3.1415927f - _e2850);
                                                    }
                                                    let _e2856 = phi_5222_;
                                                    phi_5232_ = (((((_e146.member_2[0] * _e2793) + (_e146.member_2[1] * _e2798)) + (_e146.member_2[2] * _e2801)) / _e2807) * bitcast<f32>(((bitcast<u32>(_e2856) & 2147483647u) | (bitcast<u32>(_e2807) & 2147483648u))));
                                                }
                                                let _e2865 = phi_5232_;
                                                let _e2871 = local_8;
                                                let _e2873 = local_9;
                                                phi_2791_ = ((abs((_e2716.member + _e2865)) * 0.5f) * (_e2871 / _e2873));
                                            }
                                            let _e2877 = phi_2791_;
                                            phi_2792_ = _e2877;
                                            phi_2793_ = _e2101;
                                        }
                                        let _e2879 = phi_2792_;
                                        let _e2881 = phi_2793_;
                                        if _e2881 {
                                            let _e2884 = local_10;
                                            phi_2801_ = ((_e2884 * _e374.member_3) / f32(_e386));
                                        } else {
                                            phi_2801_ = _e2879;
                                        }
                                        let _e2889 = phi_2801_;
                                        phi_2802_ = _e2889;
                                    } else {
                                        phi_2802_ = _e2095;
                                    }
                                    let _e2891 = phi_2802_;
                                    phi_2811_ = vec3<f32>((_e374.member_6[0] * _e2891), (_e374.member_6[1] * _e2891), (_e374.member_6[2] * _e2891));
                                }
                                let _e2901 = phi_2811_;
                                phi_5451_ = _e2084;
                                phi_2827_ = vec3<f32>((_e233.x + (_e2901.x * _e379)), (_e233.y + (_e2901.y * _e379)), (_e233.z + (_e2901.z * _e379)));
                            } else {
                                phi_5451_ = _e332;
                                phi_2827_ = _e233;
                            }
                            let _e2916 = phi_5451_;
                            let _e2918 = phi_2827_;
                            phi_5450_ = _e2916;
                            phi_361_ = _e2918;
                        } else {
                            phi_5450_ = _e229;
                            phi_361_ = vec3<f32>();
                        }
                        let _e2920 = phi_5450_;
                        let _e2922 = phi_361_;
                        continue;
                        continuing {
                            phi_5241_ = _e2920;
                            phi_357_ = _e246;
                            phi_360_ = _e2922;
                            phi_5449_ = _e2920;
                            break if !(_e252);
                        }
                    }
                    let _e2925 = phi_5449_;
                    if _e2925 {
                        break;
                    }
                    let _e2927 = local_11;
                    let _e2930 = local_12;
                    let _e2933 = local_13;
                    phi_2832_ = vec4<f32>(_e2927.x, _e2930.y, _e2933.z, 0f);
                }
                let _e2937 = phi_2832_;
                if (_e141 < arrayLength((&irradiance.member))) {
                } else {
                    break;
                }
                irradiance.member[_e141] = _e2937;
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
