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
    var phi_5227_: bool;
    var phi_357_: type_12;
    var phi_360_: vec3<f32>;
    var phi_358_: type_12;
    var phi_383_: type_12;
    var phi_422_: u32;
    var phi_425_: u32;
    var phi_449_: u32;
    var phi_423_: u32;
    var phi_426_: u32;
    var phi_5223_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_466_: f32;
    var phi_5261_: bool;
    var phi_476_: type_35;
    var phi_477_: u32;
    var phi_478_: f32;
    var phi_5260_: bool;
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
    var phi_5256_: bool;
    var phi_543_: type_12;
    var phi_546_: f32;
    var phi_548_: f32;
    var phi_550_: f32;
    var phi_544_: type_12;
    var phi_573_: type_12;
    var phi_1145_: f32;
    var phi_3909_: f32;
    var phi_3917_: f32;
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
    var phi_3925_: f32;
    var phi_3933_: f32;
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
    var phi_5234_: bool;
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
    var phi_2429_: u32;
    var phi_2439_: u32;
    var phi_2448_: bool;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2488_: f32;
    var phi_2503_: f32;
    var phi_2531_: u32;
    var phi_2541_: u32;
    var phi_2550_: bool;
    var phi_2566_: bool;
    var phi_2567_: bool;
    var phi_2648_: bool;
    var phi_2653_: bool;
    var phi_2658_: type_51;
    var phi_2660_: type_51;
    var phi_2662_: bool;
    var phi_2663_: type_51;
    var phi_2665_: bool;
    var phi_2666_: bool;
    var phi_2667_: type_51;
    var phi_2668_: bool;
    var phi_2669_: bool;
    var phi_2670_: bool;
    var phi_2683_: type_51;
    var phi_2690_: bool;
    var phi_5230_: bool;
    var phi_3900_: bool;
    var phi_1833_: u32;
    var phi_1845_: u32;
    var phi_1857_: u32;
    var phi_1869_: u32;
    var phi_5367_: bool;
    var phi_2695_: u32;
    var phi_2696_: bool;
    var phi_2712_: u32;
    var phi_2713_: u32;
    var phi_1444_: u32;
    var phi_1447_: u32;
    var phi_2715_: bool;
    var phi_2716_: bool;
    var phi_5365_: bool;
    var phi_3901_: bool;
    var phi_2729_: f32;
    var phi_5427_: bool;
    var phi_2730_: f32;
    var phi_5426_: bool;
    var phi_547_: f32;
    var phi_549_: f32;
    var phi_551_: f32;
    var phi_5425_: bool;
    var local_5: f32;
    var local_6: f32;
    var phi_2743_: f32;
    var local_7: f32;
    var phi_4243_: bool;
    var phi_4254_: bool;
    var phi_4275_: type_61;
    var phi_4279_: type_61;
    var phi_4280_: vec3<f32>;
    var phi_4281_: vec3<f32>;
    var phi_4321_: vec3<f32>;
    var phi_4324_: vec3<f32>;
    var phi_4325_: bool;
    var phi_4369_: vec3<f32>;
    var phi_4372_: vec3<f32>;
    var phi_4373_: bool;
    var phi_4440_: f32;
    var phi_4448_: f32;
    var phi_4463_: f32;
    var phi_4469_: f32;
    var phi_4477_: f32;
    var phi_4487_: f32;
    var phi_4492_: type_61;
    var phi_4502_: bool;
    var phi_4513_: bool;
    var phi_4534_: type_61;
    var phi_4538_: type_61;
    var phi_4539_: vec3<f32>;
    var phi_4540_: vec3<f32>;
    var phi_4580_: vec3<f32>;
    var phi_4583_: vec3<f32>;
    var phi_4584_: bool;
    var phi_4628_: vec3<f32>;
    var phi_4631_: vec3<f32>;
    var phi_4632_: bool;
    var phi_4699_: f32;
    var phi_4707_: f32;
    var phi_4722_: f32;
    var phi_4728_: f32;
    var phi_4736_: f32;
    var phi_4746_: f32;
    var phi_4751_: type_61;
    var phi_4761_: bool;
    var phi_4793_: type_61;
    var phi_4797_: type_61;
    var phi_4798_: vec3<f32>;
    var phi_4799_: vec3<f32>;
    var phi_4839_: vec3<f32>;
    var phi_4842_: vec3<f32>;
    var phi_4843_: bool;
    var phi_4887_: vec3<f32>;
    var phi_4890_: vec3<f32>;
    var phi_4891_: bool;
    var phi_4958_: f32;
    var phi_4966_: f32;
    var phi_4981_: f32;
    var phi_4987_: f32;
    var phi_4995_: f32;
    var phi_5005_: f32;
    var phi_5010_: type_61;
    var phi_5052_: vec3<f32>;
    var phi_5055_: vec3<f32>;
    var phi_5056_: bool;
    var phi_5100_: vec3<f32>;
    var phi_5103_: vec3<f32>;
    var phi_5104_: bool;
    var phi_5171_: f32;
    var phi_5179_: f32;
    var phi_5194_: f32;
    var phi_5200_: f32;
    var phi_5208_: f32;
    var phi_5218_: f32;
    var local_8: f32;
    var local_9: f32;
    var phi_2777_: f32;
    var phi_2778_: f32;
    var phi_2779_: bool;
    var local_10: f32;
    var phi_2787_: f32;
    var phi_2788_: f32;
    var phi_2797_: vec3<f32>;
    var phi_5433_: bool;
    var phi_2813_: vec3<f32>;
    var phi_5432_: bool;
    var phi_361_: vec3<f32>;
    var phi_5431_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var phi_2818_: vec4<f32>;
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
                    phi_2818_ = vec4<f32>(0f, 0f, 0f, 0f);
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
                    phi_5227_ = false;
                    phi_357_ = type_12(0u, (_e208 + select(0u, 1u, (_e180 > 0u))));
                    phi_360_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e229 = phi_5227_;
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
                                                phi_5223_ = true;
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
                                            phi_5223_ = _e229;
                                            break if !(_e276);
                                        }
                                    }
                                    let _e295 = phi_5223_;
                                    phi_5431_ = _e295;
                                    if _e295 {
                                        break;
                                    }
                                    let _e297 = local_3;
                                    if (_e297 < _e130) {
                                    } else {
                                        phi_5431_ = true;
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
                                    phi_5261_ = _e295;
                                    phi_476_ = _e303;
                                    phi_477_ = (_e318 ^ (_e318 >> bitcast<u32>(16i)));
                                    phi_478_ = _e309;
                                } else {
                                    phi_5261_ = _e229;
                                    phi_476_ = type_35();
                                    phi_477_ = u32();
                                    phi_478_ = f32();
                                }
                                let _e323 = phi_5261_;
                                let _e325 = phi_476_;
                                let _e327 = phi_477_;
                                let _e329 = phi_478_;
                                phi_5260_ = _e323;
                                phi_480_ = _e325;
                                phi_481_ = _e327;
                                phi_482_ = _e329;
                                phi_483_ = select(true, false, _e207);
                            } else {
                                phi_5260_ = _e229;
                                phi_480_ = type_35();
                                phi_481_ = u32();
                                phi_482_ = f32();
                                phi_483_ = true;
                            }
                            let _e332 = phi_5260_;
                            let _e334 = phi_480_;
                            let _e336 = phi_481_;
                            let _e338 = phi_482_;
                            let _e340 = phi_483_;
                            if _e340 {
                                if _e266 {
                                    if (_e248.member_1 < _e130) {
                                    } else {
                                        phi_5431_ = true;
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
                                phi_5256_ = _e332;
                                phi_543_ = type_12(0u, _e386);
                                phi_546_ = 340282350000000000000000000000000000000f;
                                phi_548_ = 0f;
                                phi_550_ = 0f;
                                loop {
                                    let _e389 = phi_5256_;
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
                                                phi_3925_ = (_e847 - 1f);
                                            } else {
                                                phi_3925_ = _e847;
                                            }
                                            let _e851 = phi_3925_;
                                            let _e853 = (0.000000059604645f * (f32(((2147483648u + (_e412.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e829 ^ (_e829 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                            if (_e853 >= 1f) {
                                                phi_3933_ = (_e853 - 1f);
                                            } else {
                                                phi_3933_ = _e853;
                                            }
                                            let _e857 = phi_3933_;
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
                                                        phi_3909_ = (_e536 - 1f);
                                                    } else {
                                                        phi_3909_ = _e536;
                                                    }
                                                    let _e540 = phi_3909_;
                                                    let _e542 = (0.000000059604645f * (f32(((2147483648u + (_e412.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e518 ^ (_e518 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                    if (_e542 >= 1f) {
                                                        phi_3917_ = (_e542 - 1f);
                                                    } else {
                                                        phi_3917_ = _e542;
                                                    }
                                                    let _e546 = phi_3917_;
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
                                                phi_5425_ = true;
                                                break;
                                            }
                                            let _e1007 = local_1[_e996];
                                            let _e1008 = (1f / _e1007);
                                            let _e1009 = (_e995 < 3u);
                                            if _e1009 {
                                            } else {
                                                phi_5425_ = true;
                                                break;
                                            }
                                            let _e1011 = local_1[_e995];
                                            let _e1012 = (_e1011 * _e1008);
                                            let _e1013 = (_e994 < 3u);
                                            if _e1013 {
                                            } else {
                                                phi_5425_ = true;
                                                break;
                                            }
                                            let _e1015 = local_1[_e994];
                                            let _e1016 = (_e1015 * _e1008);
                                            if _e1009 {
                                            } else {
                                                phi_5425_ = true;
                                                break;
                                            }
                                            let _e1018 = local_2[_e995];
                                            if _e1013 {
                                            } else {
                                                phi_5425_ = true;
                                                break;
                                            }
                                            let _e1020 = local_2[_e994];
                                            if _e1005 {
                                            } else {
                                                phi_5425_ = true;
                                                break;
                                            }
                                            let _e1022 = local_2[_e996];
                                            if (0u < _e119) {
                                            } else {
                                                phi_5425_ = true;
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
                                            phi_5234_ = _e389;
                                            phi_1443_ = 0u;
                                            phi_1446_ = 0u;
                                            loop {
                                                let _e1093 = phi_5234_;
                                                let _e1095 = phi_1443_;
                                                let _e1097 = phi_1446_;
                                                let _e1098 = (_e1095 & 15u);
                                                let _e1100 = (_e1095 >> bitcast<u32>(4u));
                                                if (_e1098 == 0u) {
                                                    if (_e1100 < _e119) {
                                                    } else {
                                                        phi_5365_ = true;
                                                        phi_3901_ = bool();
                                                        break;
                                                    }
                                                    let _e1800 = nodes.member[_e1100].member;
                                                    let _e1809 = ((_e1800.x - _e1067) * _e1079);
                                                    let _e1810 = ((_e1800.y - _e1067) * _e1079);
                                                    let _e1811 = ((_e1800.z - _e1067) * _e1079);
                                                    let _e1812 = ((_e1800.w - _e1067) * _e1079);
                                                    let _e1815 = nodes.member[_e1100].member_3;
                                                    let _e1824 = ((_e1815.x - _e1072) * _e1079);
                                                    let _e1825 = ((_e1815.y - _e1072) * _e1079);
                                                    let _e1826 = ((_e1815.z - _e1072) * _e1079);
                                                    let _e1827 = ((_e1815.w - _e1072) * _e1079);
                                                    let _e1830 = nodes.member[_e1100].member_1;
                                                    let _e1839 = ((_e1830.x - _e1069) * _e1084);
                                                    let _e1840 = ((_e1830.y - _e1069) * _e1084);
                                                    let _e1841 = ((_e1830.z - _e1069) * _e1084);
                                                    let _e1842 = ((_e1830.w - _e1069) * _e1084);
                                                    let _e1845 = nodes.member[_e1100].member_4;
                                                    let _e1854 = ((_e1845.x - _e1073) * _e1084);
                                                    let _e1855 = ((_e1845.y - _e1073) * _e1084);
                                                    let _e1856 = ((_e1845.z - _e1073) * _e1084);
                                                    let _e1857 = ((_e1845.w - _e1073) * _e1084);
                                                    let _e1860 = nodes.member[_e1100].member_2;
                                                    let _e1869 = ((_e1860.x - _e1071) * _e1089);
                                                    let _e1870 = ((_e1860.y - _e1071) * _e1089);
                                                    let _e1871 = ((_e1860.z - _e1071) * _e1089);
                                                    let _e1872 = ((_e1860.w - _e1071) * _e1089);
                                                    let _e1875 = nodes.member[_e1100].member_5;
                                                    let _e1884 = ((_e1875.x - _e1074) * _e1089);
                                                    let _e1885 = ((_e1875.y - _e1074) * _e1089);
                                                    let _e1886 = ((_e1875.z - _e1074) * _e1089);
                                                    let _e1887 = ((_e1875.w - _e1074) * _e1089);
                                                    let _e1889 = select(_e1824, _e1809, (_e1809 < _e1824));
                                                    let _e1891 = select(_e1825, _e1810, (_e1810 < _e1825));
                                                    let _e1893 = select(_e1826, _e1811, (_e1811 < _e1826));
                                                    let _e1895 = select(_e1827, _e1812, (_e1812 < _e1827));
                                                    let _e1897 = select(_e1854, _e1839, (_e1839 < _e1854));
                                                    let _e1899 = select(_e1855, _e1840, (_e1840 < _e1855));
                                                    let _e1901 = select(_e1856, _e1841, (_e1841 < _e1856));
                                                    let _e1903 = select(_e1857, _e1842, (_e1842 < _e1857));
                                                    let _e1905 = select(_e1897, _e1889, (_e1889 > _e1897));
                                                    let _e1907 = select(_e1899, _e1891, (_e1891 > _e1899));
                                                    let _e1909 = select(_e1901, _e1893, (_e1893 > _e1901));
                                                    let _e1911 = select(_e1903, _e1895, (_e1895 > _e1903));
                                                    let _e1913 = select(_e1884, _e1869, (_e1869 < _e1884));
                                                    let _e1915 = select(_e1885, _e1870, (_e1870 < _e1885));
                                                    let _e1917 = select(_e1886, _e1871, (_e1871 < _e1886));
                                                    let _e1919 = select(_e1887, _e1872, (_e1872 < _e1887));
                                                    let _e1921 = select(_e1913, _e1905, (_e1905 > _e1913));
                                                    let _e1923 = select(_e1915, _e1907, (_e1907 > _e1915));
                                                    let _e1925 = select(_e1917, _e1909, (_e1909 > _e1917));
                                                    let _e1927 = select(_e1919, _e1911, (_e1911 > _e1919));
                                                    let _e1929 = select(_e959.member_2, _e1921, (_e1921 > _e959.member_2));
                                                    let _e1931 = select(_e959.member_2, _e1923, (_e1923 > _e959.member_2));
                                                    let _e1933 = select(_e959.member_2, _e1925, (_e1925 > _e959.member_2));
                                                    let _e1935 = select(_e959.member_2, _e1927, (_e1927 > _e959.member_2));
                                                    let _e1937 = select(_e1824, _e1809, (_e1809 > _e1824));
                                                    let _e1939 = select(_e1825, _e1810, (_e1810 > _e1825));
                                                    let _e1941 = select(_e1826, _e1811, (_e1811 > _e1826));
                                                    let _e1943 = select(_e1827, _e1812, (_e1812 > _e1827));
                                                    let _e1945 = select(_e1854, _e1839, (_e1839 > _e1854));
                                                    let _e1947 = select(_e1855, _e1840, (_e1840 > _e1855));
                                                    let _e1949 = select(_e1856, _e1841, (_e1841 > _e1856));
                                                    let _e1951 = select(_e1857, _e1842, (_e1842 > _e1857));
                                                    let _e1953 = select(_e1945, _e1937, (_e1937 < _e1945));
                                                    let _e1955 = select(_e1947, _e1939, (_e1939 < _e1947));
                                                    let _e1957 = select(_e1949, _e1941, (_e1941 < _e1949));
                                                    let _e1959 = select(_e1951, _e1943, (_e1943 < _e1951));
                                                    let _e1961 = select(_e1884, _e1869, (_e1869 > _e1884));
                                                    let _e1963 = select(_e1885, _e1870, (_e1870 > _e1885));
                                                    let _e1965 = select(_e1886, _e1871, (_e1871 > _e1886));
                                                    let _e1967 = select(_e1887, _e1872, (_e1872 > _e1887));
                                                    let _e1969 = select(_e1961, _e1953, (_e1953 < _e1961));
                                                    let _e1971 = select(_e1963, _e1955, (_e1955 < _e1963));
                                                    let _e1973 = select(_e1965, _e1957, (_e1957 < _e1965));
                                                    let _e1975 = select(_e1967, _e1959, (_e1959 < _e1967));
                                                    let _e1995 = nodes.member[_e1100].member_6[0u];
                                                    let _e1999 = nodes.member[_e1100].member_6[1u];
                                                    let _e2003 = nodes.member[_e1100].member_6[2u];
                                                    let _e2007 = nodes.member[_e1100].member_6[3u];
                                                    if (select(340282350000000000000000000000000000000f, _e1935, (_e1935 <= select(_e959.member_3, _e1975, (_e1975 < _e959.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1097 < 64u) {
                                                        } else {
                                                            phi_5365_ = true;
                                                            phi_3901_ = bool();
                                                            break;
                                                        }
                                                        local[_e1097] = _e2007;
                                                        phi_1833_ = (_e1097 + 1u);
                                                    } else {
                                                        phi_1833_ = _e1097;
                                                    }
                                                    let _e2013 = phi_1833_;
                                                    if (select(340282350000000000000000000000000000000f, _e1933, (_e1933 <= select(_e959.member_3, _e1973, (_e1973 < _e959.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2013 < 64u) {
                                                        } else {
                                                            phi_5365_ = true;
                                                            phi_3901_ = bool();
                                                            break;
                                                        }
                                                        local[_e2013] = _e2003;
                                                        phi_1845_ = (_e2013 + 1u);
                                                    } else {
                                                        phi_1845_ = _e2013;
                                                    }
                                                    let _e2019 = phi_1845_;
                                                    if (select(340282350000000000000000000000000000000f, _e1931, (_e1931 <= select(_e959.member_3, _e1971, (_e1971 < _e959.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2019 < 64u) {
                                                        } else {
                                                            phi_5365_ = true;
                                                            phi_3901_ = bool();
                                                            break;
                                                        }
                                                        local[_e2019] = _e1999;
                                                        phi_1857_ = (_e2019 + 1u);
                                                    } else {
                                                        phi_1857_ = _e2019;
                                                    }
                                                    let _e2025 = phi_1857_;
                                                    if (select(340282350000000000000000000000000000000f, _e1929, (_e1929 <= select(_e959.member_3, _e1969, (_e1969 < _e959.member_3)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2025 < 64u) {
                                                        } else {
                                                            phi_5365_ = true;
                                                            phi_3901_ = bool();
                                                            break;
                                                        }
                                                        local[_e2025] = _e1995;
                                                        phi_1869_ = (_e2025 + 1u);
                                                    } else {
                                                        phi_1869_ = _e2025;
                                                    }
                                                    let _e2031 = phi_1869_;
                                                    phi_5367_ = _e1093;
                                                    phi_2695_ = _e2031;
                                                    phi_2696_ = true;
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
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
                                                                break;
                                                            }
                                                            if _e1005 {
                                                            } else {
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
                                                                break;
                                                            }
                                                            let _e1129 = triangles.member[_e1120.member_1].member[_e996];
                                                            let _e1130 = (_e1129 - _e1022);
                                                            if _e1005 {
                                                            } else {
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
                                                                break;
                                                            }
                                                            let _e1134 = triangles.member[_e1120.member_1].member_2[_e996];
                                                            let _e1135 = (_e1134 - _e1022);
                                                            if _e1005 {
                                                            } else {
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
                                                                break;
                                                            }
                                                            let _e1139 = triangles.member[_e1120.member_1].member_4[_e996];
                                                            let _e1140 = (_e1139 - _e1022);
                                                            if _e1009 {
                                                            } else {
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
                                                                break;
                                                            }
                                                            let _e1144 = triangles.member[_e1120.member_1].member[_e995];
                                                            let _e1147 = ((_e1144 - _e1018) - (_e1012 * _e1130));
                                                            if _e1013 {
                                                            } else {
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
                                                                break;
                                                            }
                                                            let _e1151 = triangles.member[_e1120.member_1].member[_e994];
                                                            let _e1154 = ((_e1151 - _e1020) - (_e1016 * _e1130));
                                                            if _e1009 {
                                                            } else {
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
                                                                break;
                                                            }
                                                            let _e1158 = triangles.member[_e1120.member_1].member_2[_e995];
                                                            let _e1161 = ((_e1158 - _e1018) - (_e1012 * _e1135));
                                                            if _e1013 {
                                                            } else {
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
                                                                break;
                                                            }
                                                            let _e1165 = triangles.member[_e1120.member_1].member_2[_e994];
                                                            let _e1168 = ((_e1165 - _e1020) - (_e1016 * _e1135));
                                                            if _e1009 {
                                                            } else {
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
                                                                break;
                                                            }
                                                            let _e1172 = triangles.member[_e1120.member_1].member_4[_e995];
                                                            let _e1175 = ((_e1172 - _e1018) - (_e1012 * _e1140));
                                                            if _e1013 {
                                                            } else {
                                                                phi_5230_ = true;
                                                                phi_3900_ = bool();
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
                                                                            phi_5230_ = true;
                                                                            phi_3900_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1504 = triangles.member[_e1120.member_1].member_3;
                                                                        if ((_e1504 & 1u) == 0u) {
                                                                            phi_2653_ = true;
                                                                        } else {
                                                                            if _e1125 {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1509 = triangles.member[_e1120.member_1].member_1;
                                                                            let _e1510 = (_e1509 * 12u);
                                                                            if ((256u + _e1510) < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 257u) < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 258u) < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1517 = (_e1510 + 259u);
                                                                            if (_e1517 < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1520 = surfaces.member[_e1517];
                                                                            if ((_e1510 + 260u) < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 261u) < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 262u) < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1527 = (_e1510 + 263u);
                                                                            if (_e1527 < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1530 = surfaces.member[_e1527];
                                                                            let _e1531 = (_e1510 + 264u);
                                                                            if (_e1531 < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1534 = surfaces.member[_e1531];
                                                                            let _e1535 = bitcast<f32>(_e1534);
                                                                            let _e1536 = (_e1510 + 265u);
                                                                            if (_e1536 < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1539 = surfaces.member[_e1536];
                                                                            let _e1540 = bitcast<f32>(_e1539);
                                                                            if ((_e1510 + 266u) < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1510 + 267u) < _e128) {
                                                                            } else {
                                                                                phi_5230_ = true;
                                                                                phi_3900_ = bool();
                                                                                break;
                                                                            }
                                                                            if (_e1520 == 4294967295u) {
                                                                                phi_2648_ = (_e1535 < _e1540);
                                                                            } else {
                                                                                if (_e1120.member_1 < arrayLength((&attributes.member))) {
                                                                                } else {
                                                                                    phi_5230_ = true;
                                                                                    phi_3900_ = bool();
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
                                                                                let _e1613 = ((select(0f, _e1606, (abs((_e1606 - 0.5f)) <= 0.5f)) * f32(_e1583)) - 0.5f);
                                                                                let _e1614 = floor(_e1613);
                                                                                let _e1615 = (_e1614 < 0f);
                                                                                if _e1615 {
                                                                                    phi_2429_ = 0u;
                                                                                } else {
                                                                                    let _e1620 = select(select(u32(_e1614), 0u, (_e1614 < 0f)), 4294967295u, (_e1614 > 4294967000f));
                                                                                    phi_2429_ = select(_e1620, _e1589, (_e1589 < _e1620));
                                                                                }
                                                                                let _e1624 = phi_2429_;
                                                                                if _e1615 {
                                                                                    phi_2439_ = 0u;
                                                                                } else {
                                                                                    let _e1625 = (_e1624 + 1u);
                                                                                    phi_2439_ = select(_e1625, _e1589, (_e1589 < _e1625));
                                                                                }
                                                                                let _e1629 = phi_2439_;
                                                                                let _e1630 = (_e1588 == 0u);
                                                                                if _e1630 {
                                                                                    phi_2448_ = select(true, false, _e1615);
                                                                                } else {
                                                                                    phi_2448_ = true;
                                                                                }
                                                                                let _e1633 = phi_2448_;
                                                                                let _e1634 = select(_e1589, _e1624, _e1633);
                                                                                if _e1630 {
                                                                                    if _e1615 {
                                                                                        phi_2464_ = true;
                                                                                    } else {
                                                                                        phi_2464_ = select(true, false, (_e1634 == _e1589));
                                                                                    }
                                                                                    let _e1638 = phi_2464_;
                                                                                    phi_2465_ = _e1638;
                                                                                } else {
                                                                                    phi_2465_ = true;
                                                                                }
                                                                                let _e1640 = phi_2465_;
                                                                                let _e1641 = select(0u, _e1629, _e1640);
                                                                                let _e1642 = (_e1613 - _e1614);
                                                                                let _e1645 = ((_e1520 >> bitcast<u32>(30u)) & 3u);
                                                                                let _e1646 = (_e1585 - 1u);
                                                                                let _e1648 = select(1f, 2f, (_e1645 == 2u));
                                                                                let _e1652 = (_e1582 - (floor((_e1582 / _e1648)) * _e1648));
                                                                                if (_e1652 > 1f) {
                                                                                    phi_2488_ = (_e1648 - _e1652);
                                                                                } else {
                                                                                    phi_2488_ = _e1652;
                                                                                }
                                                                                let _e1656 = phi_2488_;
                                                                                if (_e1645 == 1u) {
                                                                                    let _e1659 = select(0f, _e1582, (_e1582 > 0f));
                                                                                    phi_2503_ = select(1f, _e1659, (_e1659 < 1f));
                                                                                } else {
                                                                                    phi_2503_ = _e1656;
                                                                                }
                                                                                let _e1663 = phi_2503_;
                                                                                let _e1670 = ((select(0f, _e1663, (abs((_e1663 - 0.5f)) <= 0.5f)) * f32(_e1585)) - 0.5f);
                                                                                let _e1671 = floor(_e1670);
                                                                                let _e1672 = (_e1671 < 0f);
                                                                                if _e1672 {
                                                                                    phi_2531_ = 0u;
                                                                                } else {
                                                                                    let _e1677 = select(select(u32(_e1671), 0u, (_e1671 < 0f)), 4294967295u, (_e1671 > 4294967000f));
                                                                                    phi_2531_ = select(_e1677, _e1646, (_e1646 < _e1677));
                                                                                }
                                                                                let _e1681 = phi_2531_;
                                                                                if _e1672 {
                                                                                    phi_2541_ = 0u;
                                                                                } else {
                                                                                    let _e1682 = (_e1681 + 1u);
                                                                                    phi_2541_ = select(_e1682, _e1646, (_e1646 < _e1682));
                                                                                }
                                                                                let _e1686 = phi_2541_;
                                                                                let _e1687 = (_e1645 == 0u);
                                                                                if _e1687 {
                                                                                    phi_2550_ = select(true, false, _e1672);
                                                                                } else {
                                                                                    phi_2550_ = true;
                                                                                }
                                                                                let _e1690 = phi_2550_;
                                                                                let _e1691 = select(_e1646, _e1681, _e1690);
                                                                                if _e1687 {
                                                                                    if _e1672 {
                                                                                        phi_2566_ = true;
                                                                                    } else {
                                                                                        phi_2566_ = select(true, false, (_e1691 == _e1646));
                                                                                    }
                                                                                    let _e1695 = phi_2566_;
                                                                                    phi_2567_ = _e1695;
                                                                                } else {
                                                                                    phi_2567_ = true;
                                                                                }
                                                                                let _e1697 = phi_2567_;
                                                                                let _e1699 = (_e1670 - _e1671);
                                                                                let _e1700 = (_e1520 & 268435455u);
                                                                                let _e1702 = (_e1700 + (_e1691 * _e1583));
                                                                                let _e1704 = (_e1700 + (select(0u, _e1686, _e1697) * _e1583));
                                                                                let _e1705 = (_e1702 + _e1634);
                                                                                let _e1706 = (_e1702 + _e1641);
                                                                                let _e1707 = (_e1704 + _e1634);
                                                                                let _e1708 = (_e1704 + _e1641);
                                                                                if (_e1705 < _e128) {
                                                                                } else {
                                                                                    phi_5230_ = true;
                                                                                    phi_3900_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1711 = surfaces.member[_e1705];
                                                                                if (_e1706 < _e128) {
                                                                                } else {
                                                                                    phi_5230_ = true;
                                                                                    phi_3900_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1714 = surfaces.member[_e1706];
                                                                                if (_e1707 < _e128) {
                                                                                } else {
                                                                                    phi_5230_ = true;
                                                                                    phi_3900_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1717 = surfaces.member[_e1707];
                                                                                if (_e1708 < _e128) {
                                                                                } else {
                                                                                    phi_5230_ = true;
                                                                                    phi_3900_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1720 = surfaces.member[_e1708];
                                                                                let _e1737 = (1f - _e1642);
                                                                                phi_2648_ = ((_e1535 * (((((f32((_e1711 >> bitcast<u32>(24i))) * 0.003921569f) * _e1737) + ((f32((_e1714 >> bitcast<u32>(24i))) * 0.003921569f) * _e1642)) * (1f - _e1699)) + ((((f32((_e1717 >> bitcast<u32>(24i))) * 0.003921569f) * _e1737) + ((f32((_e1720 >> bitcast<u32>(24i))) * 0.003921569f) * _e1642)) * _e1699))) < _e1540);
                                                                            }
                                                                            let _e1752 = phi_2648_;
                                                                            phi_2653_ = select(true, false, _e1752);
                                                                        }
                                                                        let _e1755 = phi_2653_;
                                                                        if _e1755 {
                                                                            phi_2658_ = type_51(_e1494[0], _e1120.member_1, _e1494[1], _e1494[2]);
                                                                        } else {
                                                                            phi_2658_ = type_51();
                                                                        }
                                                                        let _e1758 = phi_2658_;
                                                                        phi_2660_ = _e1758;
                                                                        phi_2662_ = select(true, false, _e1755);
                                                                    } else {
                                                                        phi_2660_ = type_51();
                                                                        phi_2662_ = false;
                                                                    }
                                                                    let _e1761 = phi_2660_;
                                                                    let _e1763 = phi_2662_;
                                                                    phi_2663_ = _e1761;
                                                                    phi_2665_ = select(true, false, _e1501);
                                                                    phi_2666_ = _e1763;
                                                                } else {
                                                                    phi_2663_ = type_51();
                                                                    phi_2665_ = false;
                                                                    phi_2666_ = false;
                                                                }
                                                                let _e1766 = phi_2663_;
                                                                let _e1768 = phi_2665_;
                                                                let _e1770 = phi_2666_;
                                                                phi_2667_ = _e1766;
                                                                phi_2668_ = select(true, false, _e1500);
                                                                phi_2669_ = _e1768;
                                                                phi_2670_ = _e1770;
                                                            } else {
                                                                phi_2667_ = type_51();
                                                                phi_2668_ = true;
                                                                phi_2669_ = false;
                                                                phi_2670_ = false;
                                                            }
                                                            let _e1773 = phi_2667_;
                                                            let _e1775 = phi_2668_;
                                                            let _e1777 = phi_2669_;
                                                            let _e1779 = phi_2670_;
                                                            if select(select(_e1779, false, _e1775), true, select(_e1777, true, _e1775)) {
                                                                phi_2683_ = type_51(_e959.member_3, 4294967295u, 0f, 0f);
                                                            } else {
                                                                phi_2683_ = _e1773;
                                                            }
                                                            let _e1784 = phi_2683_;
                                                            phi_2690_ = select(true, false, (_e1784.member_1 != 4294967295u));
                                                        } else {
                                                            phi_2690_ = false;
                                                        }
                                                        let _e1789 = phi_2690_;
                                                        continue;
                                                        continuing {
                                                            phi_1873_ = _e1118;
                                                            phi_5230_ = _e1093;
                                                            phi_3900_ = select(true, false, _e1124);
                                                            break if !(_e1789);
                                                        }
                                                    }
                                                    let _e1793 = phi_5230_;
                                                    let _e1795 = phi_3900_;
                                                    phi_5365_ = _e1793;
                                                    phi_3901_ = bool();
                                                    if _e1793 {
                                                        break;
                                                    }
                                                    phi_5367_ = _e1793;
                                                    phi_2695_ = _e1097;
                                                    phi_2696_ = _e1795;
                                                }
                                                let _e2033 = phi_5367_;
                                                let _e2035 = phi_2695_;
                                                let _e2037 = phi_2696_;
                                                if _e2037 {
                                                    let _e2038 = (_e2035 == 0u);
                                                    if _e2038 {
                                                        phi_2712_ = u32();
                                                        phi_2713_ = u32();
                                                    } else {
                                                        let _e2039 = (_e2035 - 1u);
                                                        if (_e2039 < 64u) {
                                                        } else {
                                                            phi_5365_ = true;
                                                            phi_3901_ = bool();
                                                            break;
                                                        }
                                                        let _e2042 = local[_e2039];
                                                        phi_2712_ = _e2042;
                                                        phi_2713_ = _e2039;
                                                    }
                                                    let _e2044 = phi_2712_;
                                                    let _e2046 = phi_2713_;
                                                    phi_1444_ = _e2044;
                                                    phi_1447_ = _e2046;
                                                    phi_2715_ = select(true, false, _e2038);
                                                    phi_2716_ = _e2038;
                                                } else {
                                                    phi_1444_ = u32();
                                                    phi_1447_ = u32();
                                                    phi_2715_ = false;
                                                    phi_2716_ = false;
                                                }
                                                let _e2049 = phi_1444_;
                                                let _e2051 = phi_1447_;
                                                let _e2053 = phi_2715_;
                                                let _e2055 = phi_2716_;
                                                continue;
                                                continuing {
                                                    phi_5234_ = _e2033;
                                                    phi_1443_ = _e2049;
                                                    phi_1446_ = _e2051;
                                                    phi_5365_ = _e2033;
                                                    phi_3901_ = _e2055;
                                                    break if !(_e2053);
                                                }
                                            }
                                            let _e2058 = phi_5365_;
                                            let _e2060 = phi_3901_;
                                            phi_5425_ = _e2058;
                                            if _e2058 {
                                                break;
                                            }
                                            if select(false, true, select(true, false, _e2060)) {
                                                phi_2729_ = _e395;
                                            } else {
                                                phi_2729_ = (_e395 + _e960);
                                            }
                                            let _e2065 = phi_2729_;
                                            phi_5427_ = _e2058;
                                            phi_2730_ = _e2065;
                                        } else {
                                            phi_5427_ = _e389;
                                            phi_2730_ = _e395;
                                        }
                                        let _e2067 = phi_5427_;
                                        let _e2069 = phi_2730_;
                                        phi_5426_ = _e2067;
                                        phi_547_ = select(_e961, _e393, (_e393 < _e961));
                                        phi_549_ = _e2069;
                                        phi_551_ = (_e397 + _e960);
                                    } else {
                                        phi_5426_ = _e389;
                                        phi_547_ = f32();
                                        phi_549_ = f32();
                                        phi_551_ = f32();
                                    }
                                    let _e2071 = phi_5426_;
                                    let _e2073 = phi_547_;
                                    let _e2075 = phi_549_;
                                    let _e2077 = phi_551_;
                                    continue;
                                    continuing {
                                        phi_5256_ = _e2071;
                                        phi_543_ = _e410;
                                        phi_546_ = _e2073;
                                        phi_548_ = _e2075;
                                        phi_550_ = _e2077;
                                        phi_5425_ = _e2071;
                                        break if !(_e416);
                                    }
                                }
                                let _e2080 = phi_5425_;
                                phi_5431_ = _e2080;
                                if _e2080 {
                                    break;
                                }
                                let _e2082 = local_5;
                                if (_e2082 <= 0f) {
                                    phi_2797_ = vec3<f32>(0f, 0f, 0f);
                                } else {
                                    if (_e374.member_1 == 4294967295u) {
                                        let _e2086 = local_6;
                                        phi_2743_ = ((3.1415927f * _e2086) / f32(_e386));
                                    } else {
                                        let _e3103 = local_14;
                                        phi_2743_ = _e3103;
                                    }
                                    let _e2091 = phi_2743_;
                                    if _e382 {
                                        if (_e386 == 1u) {
                                            phi_2778_ = f32();
                                            phi_2779_ = true;
                                        } else {
                                            let _e2095 = local_7;
                                            let _e2097 = (_e374.member_3 < (0.01f * _e2095));
                                            if _e2097 {
                                                phi_2777_ = f32();
                                            } else {
                                                let _e2113 = (_e374.member[0] - _e146.member[0]);
                                                let _e2114 = (_e374.member[1] - _e146.member[1]);
                                                let _e2115 = (_e374.member[2] - _e146.member[2]);
                                                let _e2116 = (vec3<f32>(_e374.member[0], _e374.member[1], _e374.member[2]) - _e153);
                                                let _e2117 = (_e374.member_2[0] - _e146.member[0]);
                                                let _e2118 = (_e374.member_2[1] - _e146.member[1]);
                                                let _e2119 = (_e374.member_2[2] - _e146.member[2]);
                                                let _e2120 = (vec3<f32>(_e374.member_2[0], _e374.member_2[1], _e374.member_2[2]) - _e153);
                                                let _e2121 = (_e374.member_4[0] - _e146.member[0]);
                                                let _e2122 = (_e374.member_4[1] - _e146.member[1]);
                                                let _e2123 = (_e374.member_4[2] - _e146.member[2]);
                                                let _e2124 = (vec3<f32>(_e374.member_4[0], _e374.member_4[1], _e374.member_4[2]) - _e153);
                                                let _e2129 = (((_e146.member_2[0] * _e2113) + (_e146.member_2[1] * _e2114)) + (_e146.member_2[2] * _e2115));
                                                let _e2134 = (((_e146.member_2[0] * _e2117) + (_e146.member_2[1] * _e2118)) + (_e146.member_2[2] * _e2119));
                                                let _e2139 = (((_e146.member_2[0] * _e2121) + (_e146.member_2[1] * _e2122)) + (_e146.member_2[2] * _e2123));
                                                let _e2140 = (_e2129 <= 0f);
                                                if _e2140 {
                                                    phi_4243_ = select(true, false, (_e2134 <= 0f));
                                                } else {
                                                    phi_4243_ = true;
                                                }
                                                let _e2144 = phi_4243_;
                                                if _e2144 {
                                                    if _e2140 {
                                                        phi_4254_ = true;
                                                    } else {
                                                        phi_4254_ = (_e2134 <= 0f);
                                                    }
                                                    let _e2147 = phi_4254_;
                                                    if _e2147 {
                                                        let _e2152 = (_e2129 / (_e2129 - _e2134));
                                                        let _e2159 = vec3<f32>((_e2113 + ((_e2117 - _e2113) * _e2152)), (_e2114 + ((_e2118 - _e2114) * _e2152)), (_e2115 + ((_e2119 - _e2115) * _e2152)));
                                                        if _e2140 {
                                                            phi_4275_ = type_61(0f, vec3<f32>(0f, 0f, 0f), _e2159);
                                                        } else {
                                                            phi_4275_ = type_61(0f, _e2159, vec3<f32>(0f, 0f, 0f));
                                                        }
                                                        let _e2163 = phi_4275_;
                                                        let _e2164 = vec3(_e2140);
                                                        phi_4279_ = _e2163;
                                                        phi_4280_ = select(_e2159, _e2120, _e2164);
                                                        phi_4281_ = select(_e2116, _e2159, _e2164);
                                                    } else {
                                                        phi_4279_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                        phi_4280_ = _e2120;
                                                        phi_4281_ = _e2116;
                                                    }
                                                    let _e2168 = phi_4279_;
                                                    let _e2170 = phi_4280_;
                                                    let _e2172 = phi_4281_;
                                                    let _e2174 = abs(_e2172.x);
                                                    let _e2176 = abs(_e2172.y);
                                                    let _e2178 = select(_e2176, _e2174, (_e2174 > _e2176));
                                                    let _e2180 = abs(_e2172.z);
                                                    let _e2182 = select(_e2180, _e2178, (_e2178 > _e2180));
                                                    if (_e2182 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2184 = (_e2182 < 340282350000000000000000000000000000000f);
                                                        if _e2184 {
                                                            let _e2185 = (_e2172.x / _e2182);
                                                            let _e2186 = (_e2172.y / _e2182);
                                                            let _e2187 = (_e2172.z / _e2182);
                                                            let _e2193 = sqrt((((_e2185 * _e2185) + (_e2186 * _e2186)) + (_e2187 * _e2187)));
                                                            phi_4321_ = vec3<f32>((_e2185 / _e2193), (_e2186 / _e2193), (_e2187 / _e2193));
                                                        } else {
                                                            phi_4321_ = vec3<f32>();
                                                        }
                                                        let _e2199 = phi_4321_;
                                                        phi_4324_ = _e2199;
                                                        phi_4325_ = select(true, false, _e2184);
                                                    } else {
                                                        phi_4324_ = vec3<f32>();
                                                        phi_4325_ = true;
                                                    }
                                                    let _e2202 = phi_4324_;
                                                    let _e2204 = phi_4325_;
                                                    let _e2206 = select(_e2202, vec3<f32>(0f, 0f, 0f), vec3(_e2204));
                                                    let _e2208 = abs(_e2170.x);
                                                    let _e2210 = abs(_e2170.y);
                                                    let _e2212 = select(_e2210, _e2208, (_e2208 > _e2210));
                                                    let _e2214 = abs(_e2170.z);
                                                    let _e2216 = select(_e2214, _e2212, (_e2212 > _e2214));
                                                    if (_e2216 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2218 = (_e2216 < 340282350000000000000000000000000000000f);
                                                        if _e2218 {
                                                            let _e2219 = (_e2170.x / _e2216);
                                                            let _e2220 = (_e2170.y / _e2216);
                                                            let _e2221 = (_e2170.z / _e2216);
                                                            let _e2227 = sqrt((((_e2219 * _e2219) + (_e2220 * _e2220)) + (_e2221 * _e2221)));
                                                            phi_4369_ = vec3<f32>((_e2219 / _e2227), (_e2220 / _e2227), (_e2221 / _e2227));
                                                        } else {
                                                            phi_4369_ = vec3<f32>();
                                                        }
                                                        let _e2233 = phi_4369_;
                                                        phi_4372_ = _e2233;
                                                        phi_4373_ = select(true, false, _e2218);
                                                    } else {
                                                        phi_4372_ = vec3<f32>();
                                                        phi_4373_ = true;
                                                    }
                                                    let _e2236 = phi_4372_;
                                                    let _e2238 = phi_4373_;
                                                    let _e2240 = select(_e2236, vec3<f32>(0f, 0f, 0f), vec3(_e2238));
                                                    let _e2247 = ((_e2206.y * _e2240.z) - (_e2240.y * _e2206.z));
                                                    let _e2252 = ((_e2206.z * _e2240.x) - (_e2240.z * _e2206.x));
                                                    let _e2255 = ((_e2206.x * _e2240.y) - (_e2240.x * _e2206.y));
                                                    let _e2261 = sqrt((((_e2247 * _e2247) + (_e2252 * _e2252)) + (_e2255 * _e2255)));
                                                    if (_e2261 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_4487_ = 0f;
                                                    } else {
                                                        let _e2273 = (((_e2206.x * _e2240.x) + (_e2206.y * _e2240.y)) + (_e2206.z * _e2240.z));
                                                        let _e2274 = abs(_e2273);
                                                        let _e2275 = abs(_e2261);
                                                        let _e2276 = (_e2275 > _e2274);
                                                        let _e2277 = select(_e2274, _e2275, _e2276);
                                                        if (_e2277 > 0f) {
                                                            phi_4440_ = (select(_e2275, _e2274, _e2276) / _e2277);
                                                        } else {
                                                            phi_4440_ = 0f;
                                                        }
                                                        let _e2282 = phi_4440_;
                                                        let _e2283 = (_e2282 > 0.41421357f);
                                                        if _e2283 {
                                                            phi_4448_ = ((_e2282 - 1f) / (_e2282 + 1f));
                                                        } else {
                                                            phi_4448_ = _e2282;
                                                        }
                                                        let _e2288 = phi_4448_;
                                                        let _e2289 = (_e2288 * _e2288);
                                                        let _e2298 = (_e2288 + ((_e2288 * _e2289) * (-0.3333295f + (_e2289 * (0.19977711f + (_e2289 * (-0.13877685f + (_e2289 * 0.080537446f))))))));
                                                        if _e2283 {
                                                            phi_4463_ = (_e2298 + 0.7853982f);
                                                        } else {
                                                            phi_4463_ = _e2298;
                                                        }
                                                        let _e2301 = phi_4463_;
                                                        if _e2276 {
                                                            phi_4469_ = (1.5707964f - _e2301);
                                                        } else {
                                                            phi_4469_ = _e2301;
                                                        }
                                                        let _e2304 = phi_4469_;
                                                        if ((bitcast<u32>(_e2273) & 2147483648u) == 0u) {
                                                            phi_4477_ = _e2304;
                                                        } else {
                                                            phi_4477_ = (3.1415927f - _e2304);
                                                        }
                                                        let _e2310 = phi_4477_;
                                                        phi_4487_ = (((((_e146.member_2[0] * _e2247) + (_e146.member_2[1] * _e2252)) + (_e146.member_2[2] * _e2255)) / _e2261) * bitcast<f32>(((bitcast<u32>(_e2310) & 2147483647u) | (bitcast<u32>(_e2261) & 2147483648u))));
                                                    }
                                                    let _e2319 = phi_4487_;
                                                    phi_4492_ = type_61((_e2168.member + _e2319), _e2168.member_1, _e2168.member_2);
                                                } else {
                                                    phi_4492_ = type_61(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                }
                                                let _e2327 = phi_4492_;
                                                let _e2328 = (_e2134 <= 0f);
                                                if _e2328 {
                                                    phi_4502_ = select(true, false, (_e2139 <= 0f));
                                                } else {
                                                    phi_4502_ = true;
                                                }
                                                let _e2332 = phi_4502_;
                                                if _e2332 {
                                                    if _e2328 {
                                                        phi_4513_ = true;
                                                    } else {
                                                        phi_4513_ = (_e2139 <= 0f);
                                                    }
                                                    let _e2335 = phi_4513_;
                                                    if _e2335 {
                                                        let _e2340 = (_e2134 / (_e2134 - _e2139));
                                                        let _e2347 = vec3<f32>((_e2117 + ((_e2121 - _e2117) * _e2340)), (_e2118 + ((_e2122 - _e2118) * _e2340)), (_e2119 + ((_e2123 - _e2119) * _e2340)));
                                                        if _e2328 {
                                                            phi_4534_ = type_61(_e2327.member, _e2327.member_1, _e2347);
                                                        } else {
                                                            phi_4534_ = type_61(_e2327.member, _e2347, _e2327.member_2);
                                                        }
                                                        let _e2357 = phi_4534_;
                                                        let _e2358 = vec3(_e2328);
                                                        phi_4538_ = _e2357;
                                                        phi_4539_ = select(_e2347, _e2124, _e2358);
                                                        phi_4540_ = select(_e2120, _e2347, _e2358);
                                                    } else {
                                                        phi_4538_ = _e2327;
                                                        phi_4539_ = _e2124;
                                                        phi_4540_ = _e2120;
                                                    }
                                                    let _e2362 = phi_4538_;
                                                    let _e2364 = phi_4539_;
                                                    let _e2366 = phi_4540_;
                                                    let _e2368 = abs(_e2366.x);
                                                    let _e2370 = abs(_e2366.y);
                                                    let _e2372 = select(_e2370, _e2368, (_e2368 > _e2370));
                                                    let _e2374 = abs(_e2366.z);
                                                    let _e2376 = select(_e2374, _e2372, (_e2372 > _e2374));
                                                    if (_e2376 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2378 = (_e2376 < 340282350000000000000000000000000000000f);
                                                        if _e2378 {
                                                            let _e2379 = (_e2366.x / _e2376);
                                                            let _e2380 = (_e2366.y / _e2376);
                                                            let _e2381 = (_e2366.z / _e2376);
                                                            let _e2387 = sqrt((((_e2379 * _e2379) + (_e2380 * _e2380)) + (_e2381 * _e2381)));
                                                            phi_4580_ = vec3<f32>((_e2379 / _e2387), (_e2380 / _e2387), (_e2381 / _e2387));
                                                        } else {
                                                            phi_4580_ = vec3<f32>();
                                                        }
                                                        let _e2393 = phi_4580_;
                                                        phi_4583_ = _e2393;
                                                        phi_4584_ = select(true, false, _e2378);
                                                    } else {
                                                        phi_4583_ = vec3<f32>();
                                                        phi_4584_ = true;
                                                    }
                                                    let _e2396 = phi_4583_;
                                                    let _e2398 = phi_4584_;
                                                    let _e2400 = select(_e2396, vec3<f32>(0f, 0f, 0f), vec3(_e2398));
                                                    let _e2402 = abs(_e2364.x);
                                                    let _e2404 = abs(_e2364.y);
                                                    let _e2406 = select(_e2404, _e2402, (_e2402 > _e2404));
                                                    let _e2408 = abs(_e2364.z);
                                                    let _e2410 = select(_e2408, _e2406, (_e2406 > _e2408));
                                                    if (_e2410 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2412 = (_e2410 < 340282350000000000000000000000000000000f);
                                                        if _e2412 {
                                                            let _e2413 = (_e2364.x / _e2410);
                                                            let _e2414 = (_e2364.y / _e2410);
                                                            let _e2415 = (_e2364.z / _e2410);
                                                            let _e2421 = sqrt((((_e2413 * _e2413) + (_e2414 * _e2414)) + (_e2415 * _e2415)));
                                                            phi_4628_ = vec3<f32>((_e2413 / _e2421), (_e2414 / _e2421), (_e2415 / _e2421));
                                                        } else {
                                                            phi_4628_ = vec3<f32>();
                                                        }
                                                        let _e2427 = phi_4628_;
                                                        phi_4631_ = _e2427;
                                                        phi_4632_ = select(true, false, _e2412);
                                                    } else {
                                                        phi_4631_ = vec3<f32>();
                                                        phi_4632_ = true;
                                                    }
                                                    let _e2430 = phi_4631_;
                                                    let _e2432 = phi_4632_;
                                                    let _e2434 = select(_e2430, vec3<f32>(0f, 0f, 0f), vec3(_e2432));
                                                    let _e2441 = ((_e2400.y * _e2434.z) - (_e2434.y * _e2400.z));
                                                    let _e2446 = ((_e2400.z * _e2434.x) - (_e2434.z * _e2400.x));
                                                    let _e2449 = ((_e2400.x * _e2434.y) - (_e2434.x * _e2400.y));
                                                    let _e2455 = sqrt((((_e2441 * _e2441) + (_e2446 * _e2446)) + (_e2449 * _e2449)));
                                                    if (_e2455 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_4746_ = 0f;
                                                    } else {
                                                        let _e2467 = (((_e2400.x * _e2434.x) + (_e2400.y * _e2434.y)) + (_e2400.z * _e2434.z));
                                                        let _e2468 = abs(_e2467);
                                                        let _e2469 = abs(_e2455);
                                                        let _e2470 = (_e2469 > _e2468);
                                                        let _e2471 = select(_e2468, _e2469, _e2470);
                                                        if (_e2471 > 0f) {
                                                            phi_4699_ = (select(_e2469, _e2468, _e2470) / _e2471);
                                                        } else {
                                                            phi_4699_ = 0f;
                                                        }
                                                        let _e2476 = phi_4699_;
                                                        let _e2477 = (_e2476 > 0.41421357f);
                                                        if _e2477 {
                                                            phi_4707_ = ((_e2476 - 1f) / (_e2476 + 1f));
                                                        } else {
                                                            phi_4707_ = _e2476;
                                                        }
                                                        let _e2482 = phi_4707_;
                                                        let _e2483 = (_e2482 * _e2482);
                                                        let _e2492 = (_e2482 + ((_e2482 * _e2483) * (-0.3333295f + (_e2483 * (0.19977711f + (_e2483 * (-0.13877685f + (_e2483 * 0.080537446f))))))));
                                                        if _e2477 {
                                                            phi_4722_ = (_e2492 + 0.7853982f);
                                                        } else {
                                                            phi_4722_ = _e2492;
                                                        }
                                                        let _e2495 = phi_4722_;
                                                        if _e2470 {
                                                            phi_4728_ = (1.5707964f - _e2495);
                                                        } else {
                                                            phi_4728_ = _e2495;
                                                        }
                                                        let _e2498 = phi_4728_;
                                                        if ((bitcast<u32>(_e2467) & 2147483648u) == 0u) {
                                                            phi_4736_ = _e2498;
                                                        } else {
                                                            phi_4736_ = (3.1415927f - _e2498);
                                                        }
                                                        let _e2504 = phi_4736_;
                                                        phi_4746_ = (((((_e146.member_2[0] * _e2441) + (_e146.member_2[1] * _e2446)) + (_e146.member_2[2] * _e2449)) / _e2455) * bitcast<f32>(((bitcast<u32>(_e2504) & 2147483647u) | (bitcast<u32>(_e2455) & 2147483648u))));
                                                    }
                                                    let _e2513 = phi_4746_;
                                                    phi_4751_ = type_61((_e2362.member + _e2513), _e2362.member_1, _e2362.member_2);
                                                } else {
                                                    phi_4751_ = _e2327;
                                                }
                                                let _e2521 = phi_4751_;
                                                let _e2522 = (_e2139 <= 0f);
                                                if _e2522 {
                                                    phi_4761_ = select(true, false, _e2140);
                                                } else {
                                                    phi_4761_ = true;
                                                }
                                                let _e2525 = phi_4761_;
                                                if _e2525 {
                                                    if select(_e2140, true, _e2522) {
                                                        let _e2531 = (_e2139 / (_e2139 - _e2129));
                                                        let _e2538 = vec3<f32>((_e2121 + ((_e2113 - _e2121) * _e2531)), (_e2122 + ((_e2114 - _e2122) * _e2531)), (_e2123 + ((_e2115 - _e2123) * _e2531)));
                                                        if _e2522 {
                                                            phi_4793_ = type_61(_e2521.member, _e2521.member_1, _e2538);
                                                        } else {
                                                            phi_4793_ = type_61(_e2521.member, _e2538, _e2521.member_2);
                                                        }
                                                        let _e2548 = phi_4793_;
                                                        let _e2549 = vec3(_e2522);
                                                        phi_4797_ = _e2548;
                                                        phi_4798_ = select(_e2538, _e2116, _e2549);
                                                        phi_4799_ = select(_e2124, _e2538, _e2549);
                                                    } else {
                                                        phi_4797_ = _e2521;
                                                        phi_4798_ = _e2116;
                                                        phi_4799_ = _e2124;
                                                    }
                                                    let _e2553 = phi_4797_;
                                                    let _e2555 = phi_4798_;
                                                    let _e2557 = phi_4799_;
                                                    let _e2559 = abs(_e2557.x);
                                                    let _e2561 = abs(_e2557.y);
                                                    let _e2563 = select(_e2561, _e2559, (_e2559 > _e2561));
                                                    let _e2565 = abs(_e2557.z);
                                                    let _e2567 = select(_e2565, _e2563, (_e2563 > _e2565));
                                                    if (_e2567 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2569 = (_e2567 < 340282350000000000000000000000000000000f);
                                                        if _e2569 {
                                                            let _e2570 = (_e2557.x / _e2567);
                                                            let _e2571 = (_e2557.y / _e2567);
                                                            let _e2572 = (_e2557.z / _e2567);
                                                            let _e2578 = sqrt((((_e2570 * _e2570) + (_e2571 * _e2571)) + (_e2572 * _e2572)));
                                                            phi_4839_ = vec3<f32>((_e2570 / _e2578), (_e2571 / _e2578), (_e2572 / _e2578));
                                                        } else {
                                                            phi_4839_ = vec3<f32>();
                                                        }
                                                        let _e2584 = phi_4839_;
                                                        phi_4842_ = _e2584;
                                                        phi_4843_ = select(true, false, _e2569);
                                                    } else {
                                                        phi_4842_ = vec3<f32>();
                                                        phi_4843_ = true;
                                                    }
                                                    let _e2587 = phi_4842_;
                                                    let _e2589 = phi_4843_;
                                                    let _e2591 = select(_e2587, vec3<f32>(0f, 0f, 0f), vec3(_e2589));
                                                    let _e2593 = abs(_e2555.x);
                                                    let _e2595 = abs(_e2555.y);
                                                    let _e2597 = select(_e2595, _e2593, (_e2593 > _e2595));
                                                    let _e2599 = abs(_e2555.z);
                                                    let _e2601 = select(_e2599, _e2597, (_e2597 > _e2599));
                                                    if (_e2601 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e2603 = (_e2601 < 340282350000000000000000000000000000000f);
                                                        if _e2603 {
                                                            let _e2604 = (_e2555.x / _e2601);
                                                            let _e2605 = (_e2555.y / _e2601);
                                                            let _e2606 = (_e2555.z / _e2601);
                                                            let _e2612 = sqrt((((_e2604 * _e2604) + (_e2605 * _e2605)) + (_e2606 * _e2606)));
                                                            phi_4887_ = vec3<f32>((_e2604 / _e2612), (_e2605 / _e2612), (_e2606 / _e2612));
                                                        } else {
                                                            phi_4887_ = vec3<f32>();
                                                        }
                                                        let _e2618 = phi_4887_;
                                                        phi_4890_ = _e2618;
                                                        phi_4891_ = select(true, false, _e2603);
                                                    } else {
                                                        phi_4890_ = vec3<f32>();
                                                        phi_4891_ = true;
                                                    }
                                                    let _e2621 = phi_4890_;
                                                    let _e2623 = phi_4891_;
                                                    let _e2625 = select(_e2621, vec3<f32>(0f, 0f, 0f), vec3(_e2623));
                                                    let _e2632 = ((_e2591.y * _e2625.z) - (_e2625.y * _e2591.z));
                                                    let _e2637 = ((_e2591.z * _e2625.x) - (_e2625.z * _e2591.x));
                                                    let _e2640 = ((_e2591.x * _e2625.y) - (_e2625.x * _e2591.y));
                                                    let _e2646 = sqrt((((_e2632 * _e2632) + (_e2637 * _e2637)) + (_e2640 * _e2640)));
                                                    if (_e2646 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_5005_ = 0f;
                                                    } else {
                                                        let _e2658 = (((_e2591.x * _e2625.x) + (_e2591.y * _e2625.y)) + (_e2591.z * _e2625.z));
                                                        let _e2659 = abs(_e2658);
                                                        let _e2660 = abs(_e2646);
                                                        let _e2661 = (_e2660 > _e2659);
                                                        let _e2662 = select(_e2659, _e2660, _e2661);
                                                        if (_e2662 > 0f) {
                                                            phi_4958_ = (select(_e2660, _e2659, _e2661) / _e2662);
                                                        } else {
                                                            phi_4958_ = 0f;
                                                        }
                                                        let _e2667 = phi_4958_;
                                                        let _e2668 = (_e2667 > 0.41421357f);
                                                        if _e2668 {
                                                            phi_4966_ = ((_e2667 - 1f) / (_e2667 + 1f));
                                                        } else {
                                                            phi_4966_ = _e2667;
                                                        }
                                                        let _e2673 = phi_4966_;
                                                        let _e2674 = (_e2673 * _e2673);
                                                        let _e2683 = (_e2673 + ((_e2673 * _e2674) * (-0.3333295f + (_e2674 * (0.19977711f + (_e2674 * (-0.13877685f + (_e2674 * 0.080537446f))))))));
                                                        if _e2668 {
                                                            phi_4981_ = (_e2683 + 0.7853982f);
                                                        } else {
                                                            phi_4981_ = _e2683;
                                                        }
                                                        let _e2686 = phi_4981_;
                                                        if _e2661 {
                                                            phi_4987_ = (1.5707964f - _e2686);
                                                        } else {
                                                            phi_4987_ = _e2686;
                                                        }
                                                        let _e2689 = phi_4987_;
                                                        if ((bitcast<u32>(_e2658) & 2147483648u) == 0u) {
                                                            phi_4995_ = _e2689;
                                                        } else {
                                                            phi_4995_ = (3.1415927f - _e2689);
                                                        }
                                                        let _e2695 = phi_4995_;
                                                        phi_5005_ = (((((_e146.member_2[0] * _e2632) + (_e146.member_2[1] * _e2637)) + (_e146.member_2[2] * _e2640)) / _e2646) * bitcast<f32>(((bitcast<u32>(_e2695) & 2147483647u) | (bitcast<u32>(_e2646) & 2147483648u))));
                                                    }
                                                    let _e2704 = phi_5005_;
                                                    phi_5010_ = type_61((_e2553.member + _e2704), _e2553.member_1, _e2553.member_2);
                                                } else {
                                                    phi_5010_ = _e2521;
                                                }
                                                let _e2712 = phi_5010_;
                                                let _e2716 = abs(_e2712.member_1.x);
                                                let _e2718 = abs(_e2712.member_1.y);
                                                let _e2720 = select(_e2718, _e2716, (_e2716 > _e2718));
                                                let _e2722 = abs(_e2712.member_1.z);
                                                let _e2724 = select(_e2722, _e2720, (_e2720 > _e2722));
                                                if (_e2724 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2726 = (_e2724 < 340282350000000000000000000000000000000f);
                                                    if _e2726 {
                                                        let _e2727 = (_e2712.member_1.x / _e2724);
                                                        let _e2728 = (_e2712.member_1.y / _e2724);
                                                        let _e2729 = (_e2712.member_1.z / _e2724);
                                                        let _e2735 = sqrt((((_e2727 * _e2727) + (_e2728 * _e2728)) + (_e2729 * _e2729)));
                                                        phi_5052_ = vec3<f32>((_e2727 / _e2735), (_e2728 / _e2735), (_e2729 / _e2735));
                                                    } else {
                                                        phi_5052_ = vec3<f32>();
                                                    }
                                                    let _e2741 = phi_5052_;
                                                    phi_5055_ = _e2741;
                                                    phi_5056_ = select(true, false, _e2726);
                                                } else {
                                                    phi_5055_ = vec3<f32>();
                                                    phi_5056_ = true;
                                                }
                                                let _e2744 = phi_5055_;
                                                let _e2746 = phi_5056_;
                                                let _e2748 = select(_e2744, vec3<f32>(0f, 0f, 0f), vec3(_e2746));
                                                let _e2750 = abs(_e2712.member_2.x);
                                                let _e2752 = abs(_e2712.member_2.y);
                                                let _e2754 = select(_e2752, _e2750, (_e2750 > _e2752));
                                                let _e2756 = abs(_e2712.member_2.z);
                                                let _e2758 = select(_e2756, _e2754, (_e2754 > _e2756));
                                                if (_e2758 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e2760 = (_e2758 < 340282350000000000000000000000000000000f);
                                                    if _e2760 {
                                                        let _e2761 = (_e2712.member_2.x / _e2758);
                                                        let _e2762 = (_e2712.member_2.y / _e2758);
                                                        let _e2763 = (_e2712.member_2.z / _e2758);
                                                        let _e2769 = sqrt((((_e2761 * _e2761) + (_e2762 * _e2762)) + (_e2763 * _e2763)));
                                                        phi_5100_ = vec3<f32>((_e2761 / _e2769), (_e2762 / _e2769), (_e2763 / _e2769));
                                                    } else {
                                                        phi_5100_ = vec3<f32>();
                                                    }
                                                    let _e2775 = phi_5100_;
                                                    phi_5103_ = _e2775;
                                                    phi_5104_ = select(true, false, _e2760);
                                                } else {
                                                    phi_5103_ = vec3<f32>();
                                                    phi_5104_ = true;
                                                }
                                                let _e2778 = phi_5103_;
                                                let _e2780 = phi_5104_;
                                                let _e2782 = select(_e2778, vec3<f32>(0f, 0f, 0f), vec3(_e2780));
                                                let _e2789 = ((_e2748.y * _e2782.z) - (_e2782.y * _e2748.z));
                                                let _e2794 = ((_e2748.z * _e2782.x) - (_e2782.z * _e2748.x));
                                                let _e2797 = ((_e2748.x * _e2782.y) - (_e2782.x * _e2748.y));
                                                let _e2803 = sqrt((((_e2789 * _e2789) + (_e2794 * _e2794)) + (_e2797 * _e2797)));
                                                if (_e2803 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_5218_ = 0f;
                                                } else {
                                                    let _e2815 = (((_e2748.x * _e2782.x) + (_e2748.y * _e2782.y)) + (_e2748.z * _e2782.z));
                                                    let _e2816 = abs(_e2815);
                                                    let _e2817 = abs(_e2803);
                                                    let _e2818 = (_e2817 > _e2816);
                                                    let _e2819 = select(_e2816, _e2817, _e2818);
                                                    if (_e2819 > 0f) {
                                                        phi_5171_ = (select(_e2817, _e2816, _e2818) / _e2819);
                                                    } else {
                                                        phi_5171_ = 0f;
                                                    }
                                                    let _e2824 = phi_5171_;
                                                    let _e2825 = (_e2824 > 0.41421357f);
                                                    if _e2825 {
                                                        phi_5179_ = ((_e2824 - 1f) / (_e2824 + 1f));
                                                    } else {
                                                        phi_5179_ = _e2824;
                                                    }
                                                    let _e2830 = phi_5179_;
                                                    let _e2831 = (_e2830 * _e2830);
                                                    let _e2840 = (_e2830 + ((_e2830 * _e2831) * (-0.3333295f + (_e2831 * (0.19977711f + (_e2831 * (-0.13877685f + (_e2831 * 0.080537446f))))))));
                                                    if _e2825 {
                                                        phi_5194_ = (_e2840 + 0.7853982f);
                                                    } else {
                                                        phi_5194_ = _e2840;
                                                    }
                                                    let _e2843 = phi_5194_;
                                                    if _e2818 {
                                                        phi_5200_ = (1.5707964f - _e2843);
                                                    } else {
                                                        phi_5200_ = _e2843;
                                                    }
                                                    let _e2846 = phi_5200_;
                                                    if ((bitcast<u32>(_e2815) & 2147483648u) == 0u) {
                                                        phi_5208_ = _e2846;
                                                    } else {
                                                        phi_5208_ = (3.1415927f - _e2846);
                                                    }
                                                    let _e2852 = phi_5208_;
                                                    phi_5218_ = (((((_e146.member_2[0] * _e2789) + (_e146.member_2[1] * _e2794)) + (_e146.member_2[2] * _e2797)) / _e2803) * bitcast<f32>(((bitcast<u32>(_e2852) & 2147483647u) | (bitcast<u32>(_e2803) & 2147483648u))));
                                                }
                                                let _e2861 = phi_5218_;
                                                let _e2867 = local_8;
                                                let _e2869 = local_9;
                                                phi_2777_ = ((abs((_e2712.member + _e2861)) * 0.5f) * (_e2867 / _e2869));
                                            }
                                            let _e2873 = phi_2777_;
                                            phi_2778_ = _e2873;
                                            phi_2779_ = _e2097;
                                        }
                                        let _e2875 = phi_2778_;
                                        let _e2877 = phi_2779_;
                                        if _e2877 {
                                            let _e2880 = local_10;
                                            phi_2787_ = ((_e2880 * _e374.member_3) / f32(_e386));
                                        } else {
                                            phi_2787_ = _e2875;
                                        }
                                        let _e2885 = phi_2787_;
                                        phi_2788_ = _e2885;
                                    } else {
                                        phi_2788_ = _e2091;
                                    }
                                    let _e2887 = phi_2788_;
                                    phi_2797_ = vec3<f32>((_e374.member_6[0] * _e2887), (_e374.member_6[1] * _e2887), (_e374.member_6[2] * _e2887));
                                }
                                let _e2897 = phi_2797_;
                                phi_5433_ = _e2080;
                                phi_2813_ = vec3<f32>((_e233.x + (_e2897.x * _e379)), (_e233.y + (_e2897.y * _e379)), (_e233.z + (_e2897.z * _e379)));
                            } else {
                                phi_5433_ = _e332;
                                phi_2813_ = _e233;
                            }
                            let _e2912 = phi_5433_;
                            let _e2914 = phi_2813_;
                            phi_5432_ = _e2912;
                            phi_361_ = _e2914;
                        } else {
                            phi_5432_ = _e229;
                            phi_361_ = vec3<f32>();
                        }
                        let _e2916 = phi_5432_;
                        let _e2918 = phi_361_;
                        continue;
                        continuing {
                            phi_5227_ = _e2916;
                            phi_357_ = _e246;
                            phi_360_ = _e2918;
                            phi_5431_ = _e2916;
                            break if !(_e252);
                        }
                    }
                    let _e2921 = phi_5431_;
                    if _e2921 {
                        break;
                    }
                    let _e2923 = local_11;
                    let _e2926 = local_12;
                    let _e2929 = local_13;
                    phi_2818_ = vec4<f32>(_e2923.x, _e2926.y, _e2929.z, 0f);
                }
                let _e2933 = phi_2818_;
                if (_e141 < arrayLength((&irradiance.member))) {
                } else {
                    break;
                }
                irradiance.member[_e141] = _e2933;
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
