struct type_9 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_23 {
    member: array<f32, 6>,
    member_1: array<u32, 3>,
    member_2: array<u32, 3>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec3<f32>,
    member_1: f32,
}

struct type_33 {
    member: f32,
    member_1: f32,
}

struct type_35 {
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

struct type_36 {
    member: type_35,
}

struct type_38 {
    member: vec3<f32>,
    member_1: vec3<f32>,
    member_2: vec3<f32>,
    member_3: vec3<f32>,
    member_4: u32,
    member_5: vec3<f32>,
    member_6: i32,
    member_7: i32,
    member_8: i32,
    member_9: i32,
}

struct type_39 {
    member: type_38,
    member_1: i32,
    member_2: i32,
    member_3: i32,
    member_4: i32,
    member_5: i32,
    member_6: i32,
    member_7: i32,
    member_8: i32,
    member_9: i32,
    member_10: bool,
}

struct type_43 {
    member: array<vec3<f32>, 10>,
    member_1: u32,
}

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_36;
@group(0) @binding(1) 
var<storage> triangles: type_19;
@group(0) @binding(2) 
var<storage> attributes: type_25;
@group(0) @binding(3) 
var<storage> surfaces: type_9;
@group(0) @binding(4) 
var<storage> tile_first: type_9;
@group(0) @binding(5) 
var<storage> cells: type_9;
@group(0) @binding(6) 
var<storage> facet_bits: type_9;
@group(0) @binding(7) 
var<storage, read_write> sums: type_48;

fn function_() {
    var local: array<vec3<f32>, 10>;
    var local_1: type_43;
    var phi_710_: u32;
    var phi_713_: u32;
    var phi_711_: u32;
    var phi_714_: u32;
    var phi_4569_: bool;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_826_: bool;
    var phi_835_: u32;
    var phi_855_: vec3<f32>;
    var phi_856_: vec3<f32>;
    var phi_867_: vec3<f32>;
    var phi_868_: vec3<f32>;
    var phi_879_: vec3<f32>;
    var phi_880_: vec3<f32>;
    var phi_891_: vec3<f32>;
    var phi_892_: vec3<f32>;
    var phi_1028_: bool;
    var phi_1037_: u32;
    var phi_1047_: f32;
    var phi_1067_: vec3<f32>;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_1191_: u32;
    var phi_3934_: bool;
    var phi_3973_: bool;
    var phi_4012_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1398_: type_39;
    var phi_4967_: bool;
    var phi_4583_: i32;
    var phi_4580_: i32;
    var phi_4577_: i32;
    var phi_4574_: i32;
    var phi_4582_: i32;
    var phi_4579_: i32;
    var phi_4576_: i32;
    var phi_4573_: i32;
    var phi_4575_: i32;
    var phi_1618_: bool;
    var phi_1648_: bool;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1715_: bool;
    var phi_1745_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1812_: bool;
    var phi_1842_: bool;
    var phi_1872_: bool;
    var phi_1873_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1907_: bool;
    var phi_1917_: vec3<f32>;
    var phi_1918_: vec3<f32>;
    var phi_1970_: bool;
    var phi_1979_: vec3<f32>;
    var phi_2020_: bool;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2023_: bool;
    var phi_2024_: bool;
    var phi_2028_: bool;
    var phi_2029_: bool;
    var phi_2030_: bool;
    var phi_2031_: bool;
    var phi_2032_: bool;
    var phi_2033_: bool;
    var phi_2034_: bool;
    var phi_2035_: bool;
    var phi_2036_: bool;
    var phi_2037_: bool;
    var phi_2038_: bool;
    var phi_2039_: bool;
    var phi_2040_: bool;
    var phi_2041_: bool;
    var phi_2042_: bool;
    var phi_2043_: bool;
    var phi_2044_: bool;
    var phi_4873_: i32;
    var phi_2057_: bool;
    var local_9: bool;
    var phi_4732_: i32;
    var phi_2110_: vec3<f32>;
    var phi_2111_: vec3<f32>;
    var phi_4062_: type_33;
    var phi_4065_: type_33;
    var phi_4066_: bool;
    var phi_4071_: type_33;
    var phi_4073_: type_33;
    var phi_4109_: type_33;
    var phi_4112_: type_33;
    var phi_4113_: bool;
    var phi_4118_: type_33;
    var phi_4120_: type_33;
    var phi_4168_: type_33;
    var phi_4217_: type_33;
    var phi_4220_: type_33;
    var phi_4221_: bool;
    var phi_4226_: type_33;
    var phi_4228_: type_33;
    var phi_4264_: type_33;
    var phi_4267_: type_33;
    var phi_4268_: bool;
    var phi_4273_: type_33;
    var phi_4275_: type_33;
    var phi_4323_: type_33;
    var phi_4372_: type_33;
    var phi_4375_: type_33;
    var phi_4376_: bool;
    var phi_4381_: type_33;
    var phi_4383_: type_33;
    var phi_4419_: type_33;
    var phi_4422_: type_33;
    var phi_4423_: bool;
    var phi_4428_: type_33;
    var phi_4430_: type_33;
    var phi_4478_: type_33;
    var phi_2153_: type_33;
    var phi_5488_: i32;
    var phi_4872_: i32;
    var phi_4848_: i32;
    var phi_4818_: i32;
    var phi_5487_: i32;
    var phi_4871_: i32;
    var phi_4847_: i32;
    var phi_4817_: i32;
    var phi_2193_: bool;
    var local_10: bool;
    var local_11: i32;
    var local_12: i32;
    var local_13: i32;
    var phi_2223_: u32;
    var phi_2234_: vec3<f32>;
    var phi_2235_: vec3<f32>;
    var phi_4959_: bool;
    var phi_2291_: type_12;
    var phi_2292_: type_12;
    var phi_2315_: type_12;
    var phi_2327_: type_12;
    var phi_2330_: f32;
    var phi_2328_: type_12;
    var phi_2353_: type_12;
    var phi_2388_: f32;
    var phi_2331_: f32;
    var phi_4954_: bool;
    var local_14: f32;
    var phi_2444_: f32;
    var phi_2449_: type_12;
    var phi_2452_: f32;
    var phi_2454_: vec3<f32>;
    var phi_2456_: u32;
    var phi_2450_: type_12;
    var phi_2479_: type_12;
    var phi_2514_: f32;
    var phi_2548_: u32;
    var phi_2549_: u32;
    var phi_2565_: u32;
    var phi_2566_: u32;
    var phi_2453_: f32;
    var phi_2455_: vec3<f32>;
    var phi_2457_: u32;
    var phi_5169_: bool;
    var local_15: u32;
    var phi_5186_: bool;
    var phi_5185_: bool;
    var phi_5184_: bool;
    var phi_5183_: bool;
    var phi_2578_: type_12;
    var phi_2581_: vec3<f32>;
    var phi_2583_: f32;
    var phi_2585_: f32;
    var phi_2587_: f32;
    var phi_2589_: f32;
    var phi_2579_: type_12;
    var phi_2612_: type_12;
    var phi_2726_: vec3<f32>;
    var phi_2727_: f32;
    var phi_2582_: vec3<f32>;
    var phi_2584_: f32;
    var phi_2586_: f32;
    var phi_2588_: f32;
    var phi_2590_: f32;
    var phi_5187_: bool;
    var local_16: f32;
    var local_17: f32;
    var local_18: f32;
    var phi_2743_: bool;
    var phi_2744_: bool;
    var phi_2745_: bool;
    var phi_2746_: bool;
    var phi_2747_: bool;
    var local_19: f32;
    var local_20: vec3<f32>;
    var local_21: f32;
    var local_22: vec3<f32>;
    var local_23: f32;
    var local_24: vec3<f32>;
    var local_25: f32;
    var phi_2764_: vec3<f32>;
    var local_26: f32;
    var local_27: u32;
    var phi_2836_: f32;
    var local_28: u32;
    var local_29: u32;
    var local_30: u32;
    var local_31: u32;
    var local_32: u32;
    var local_33: u32;
    var phi_2914_: f32;
    var phi_2929_: f32;
    var phi_2939_: bool;
    var phi_2964_: u32;
    var phi_2974_: u32;
    var phi_2983_: bool;
    var phi_2999_: bool;
    var phi_3000_: bool;
    var phi_3023_: f32;
    var phi_3038_: f32;
    var phi_3048_: bool;
    var phi_3073_: u32;
    var phi_3083_: u32;
    var phi_3092_: bool;
    var phi_3108_: bool;
    var phi_3109_: bool;
    var phi_3332_: type_30;
    var local_34: u32;
    var local_35: u32;
    var local_36: u32;
    var phi_3439_: vec3<f32>;
    var phi_3475_: u32;
    var phi_3486_: vec3<f32>;
    var phi_3487_: vec3<f32>;
    var phi_3522_: type_12;
    var phi_3525_: u32;
    var phi_3523_: type_12;
    var phi_3548_: type_12;
    var phi_3573_: u32;
    var phi_3526_: u32;
    var local_37: u32;
    var phi_5196_: bool;
    var phi_5195_: bool;
    var local_38: i32;
    var local_39: i32;
    var local_40: i32;
    var local_41: i32;
    var local_42: i32;
    var local_43: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = gid_1;
            let _e101 = arrayLength((&surfaces.member));
            let _e103 = arrayLength((&tile_first.member));
            let _e105 = arrayLength((&sums.member));
            let _e109 = (_e95.x + (_e95.y * 2097152u));
            let _e112 = params.member.member_4;
            if (_e109 < _e112) {
                let _e116 = params.member.member_3;
                phi_710_ = _e116;
                phi_713_ = 0u;
                loop {
                    let _e118 = phi_710_;
                    let _e120 = phi_713_;
                    local_2 = _e120;
                    local_3 = _e120;
                    local_4 = _e120;
                    local_5 = _e120;
                    local_6 = _e120;
                    local_7 = _e120;
                    local_8 = _e120;
                    local_27 = _e120;
                    local_28 = _e120;
                    local_29 = _e120;
                    local_30 = _e120;
                    local_31 = _e120;
                    local_32 = _e120;
                    local_33 = _e120;
                    local_34 = _e120;
                    local_35 = _e120;
                    local_36 = _e120;
                    let _e121 = (_e118 > 1u);
                    if _e121 {
                        let _e122 = (_e118 / 2u);
                        let _e123 = (_e120 + _e122);
                        if (_e123 < _e103) {
                        } else {
                            phi_4569_ = true;
                            break;
                        }
                        let _e127 = tile_first.member[_e123];
                        phi_711_ = (_e118 - _e122);
                        phi_714_ = select(_e120, _e123, (_e127 <= _e109));
                    } else {
                        phi_711_ = u32();
                        phi_714_ = u32();
                    }
                    let _e132 = phi_711_;
                    let _e134 = phi_714_;
                    continue;
                    continuing {
                        phi_710_ = _e132;
                        phi_713_ = _e134;
                        phi_4569_ = false;
                        break if !(_e121);
                    }
                }
                let _e137 = phi_4569_;
                if _e137 {
                    break;
                }
                let _e139 = local_2;
                if (_e139 < arrayLength((&triangles.member))) {
                } else {
                    break;
                }
                let _e143 = local_3;
                let _e146 = triangles.member[_e143].member;
                let _e152 = params.member.member;
                let _e160 = ((_e146[0] - _e152.x) / _e152.w);
                let _e161 = ((_e146[1] - _e152.y) / _e152.w);
                let _e162 = ((_e146[2] - _e152.z) / _e152.w);
                let _e166 = local_4;
                let _e169 = triangles.member[_e166].member_2;
                let _e176 = ((_e169[0] - _e152.x) / _e152.w);
                let _e177 = ((_e169[1] - _e152.y) / _e152.w);
                let _e178 = ((_e169[2] - _e152.z) / _e152.w);
                let _e182 = local_5;
                let _e185 = triangles.member[_e182].member_4;
                let _e192 = ((_e185[0] - _e152.x) / _e152.w);
                let _e193 = ((_e185[1] - _e152.y) / _e152.w);
                let _e194 = ((_e185[2] - _e152.z) / _e152.w);
                let _e196 = (_e176 - _e160);
                let _e197 = (_e177 - _e161);
                let _e198 = (_e178 - _e162);
                let _e199 = (_e192 - _e160);
                let _e200 = (_e193 - _e161);
                let _e201 = (_e194 - _e162);
                let _e204 = ((_e197 * _e201) - (_e200 * _e198));
                let _e207 = ((_e198 * _e199) - (_e201 * _e196));
                let _e210 = ((_e196 * _e200) - (_e199 * _e197));
                let _e212 = abs(_e204);
                let _e213 = abs(_e207);
                let _e214 = abs(_e210);
                let _e215 = (_e212 >= _e213);
                if _e215 {
                    phi_826_ = select(true, false, (_e212 >= _e214));
                } else {
                    phi_826_ = true;
                }
                let _e219 = phi_826_;
                if _e219 {
                    phi_835_ = select(2u, 1u, (_e213 >= _e214));
                } else {
                    phi_835_ = 0u;
                }
                let _e223 = phi_835_;
                let _e226 = params.member.member_1;
                let _e228 = f32(_e226.x);
                let _e230 = f32(_e226.y);
                let _e232 = f32(_e226.z);
                let _e234 = (_e223 == 0u);
                if _e234 {
                    phi_856_ = vec3<f32>(_e230, _e232, _e228);
                } else {
                    if (_e223 == 1u) {
                        phi_855_ = vec3<f32>(_e232, _e228, _e230);
                    } else {
                        phi_855_ = vec3<f32>(_e228, _e230, _e232);
                    }
                    let _e238 = phi_855_;
                    phi_856_ = _e238;
                }
                let _e241 = phi_856_;
                if _e234 {
                    phi_868_ = vec3<f32>(_e161, _e162, _e160);
                } else {
                    if (_e223 == 1u) {
                        phi_867_ = vec3<f32>(_e162, _e160, _e161);
                    } else {
                        phi_867_ = vec3<f32>(_e160, _e161, _e162);
                    }
                    let _e245 = phi_867_;
                    phi_868_ = _e245;
                }
                let _e248 = phi_868_;
                if _e234 {
                    phi_880_ = vec3<f32>(_e177, _e178, _e176);
                } else {
                    if (_e223 == 1u) {
                        phi_879_ = vec3<f32>(_e178, _e176, _e177);
                    } else {
                        phi_879_ = vec3<f32>(_e176, _e177, _e178);
                    }
                    let _e252 = phi_879_;
                    phi_880_ = _e252;
                }
                let _e255 = phi_880_;
                if _e234 {
                    phi_892_ = vec3<f32>(_e193, _e194, _e192);
                } else {
                    if (_e223 == 1u) {
                        phi_891_ = vec3<f32>(_e194, _e192, _e193);
                    } else {
                        phi_891_ = vec3<f32>(_e192, _e193, _e194);
                    }
                    let _e259 = phi_891_;
                    phi_892_ = _e259;
                }
                let _e262 = phi_892_;
                let _e266 = select(_e255.x, _e248.x, (_e248.x < _e255.x));
                let _e271 = select(_e255.x, _e248.x, (_e248.x > _e255.x));
                let _e277 = (-1f - floor(-(select(_e262.x, _e266, (_e266 < _e262.x)))));
                let _e278 = floor(select(_e262.x, _e271, (_e271 > _e262.x)));
                let _e279 = (_e241.x - 1f);
                let _e281 = select(0f, _e277, (_e277 > 0f));
                let _e283 = select(_e279, _e278, (_e278 < _e279));
                let _e290 = select(0i, select(select(i32(_e281), i32(-2147483648), (_e281 < -2147483600f)), 2147483647i, (_e281 > 2147483500f)), (_e281 == _e281));
                let _e297 = select(0i, select(select(i32(_e283), i32(-2147483648), (_e283 < -2147483600f)), 2147483647i, (_e283 > 2147483500f)), (_e283 == _e283));
                let _e301 = select(_e255.y, _e248.y, (_e248.y < _e255.y));
                let _e306 = select(_e255.y, _e248.y, (_e248.y > _e255.y));
                let _e312 = (-1f - floor(-(select(_e262.y, _e301, (_e301 < _e262.y)))));
                let _e313 = floor(select(_e262.y, _e306, (_e306 > _e262.y)));
                let _e314 = (_e241.y - 1f);
                let _e316 = select(0f, _e312, (_e312 > 0f));
                let _e318 = select(_e314, _e313, (_e313 < _e314));
                let _e325 = select(0i, select(select(i32(_e316), i32(-2147483648), (_e316 < -2147483600f)), 2147483647i, (_e316 > 2147483500f)), (_e316 == _e316));
                let _e332 = select(0i, select(select(i32(_e318), i32(-2147483648), (_e318 < -2147483600f)), 2147483647i, (_e318 > 2147483500f)), (_e318 == _e318));
                let _e333 = type_38(_e248, _e255, _e262, vec3<f32>(_e204, _e207, _e210), _e223, _e241, _e290, _e297, _e325, _e332);
                if _e215 {
                    phi_1028_ = select(true, false, (_e212 >= _e214));
                } else {
                    phi_1028_ = true;
                }
                let _e337 = phi_1028_;
                if _e337 {
                    phi_1037_ = select(2u, 1u, (_e213 >= _e214));
                } else {
                    phi_1037_ = 0u;
                }
                let _e341 = phi_1037_;
                if (_e341 == 0u) {
                    phi_1047_ = _e204;
                } else {
                    phi_1047_ = select(_e210, _e207, (_e341 == 1u));
                }
                let _e346 = phi_1047_;
                let _e355 = (((_e204 * _e204) + (_e207 * _e207)) + (_e210 * _e210));
                if (_e355 >= 0.000000000000000000000000000000000000011754944f) {
                    let _e358 = (1f / sqrt(_e355));
                    phi_1067_ = vec3<f32>((_e204 * _e358), (_e207 * _e358), (_e210 * _e358));
                } else {
                    phi_1067_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e364 = phi_1067_;
                let _e367 = local_6;
                let _e370 = triangles.member[_e367].member_1;
                let _e371 = (_e370 * 12u);
                let _e372 = (256u + _e371);
                if (_e372 < _e101) {
                } else {
                    break;
                }
                let _e376 = surfaces.member[_e372];
                let _e377 = bitcast<f32>(_e376);
                let _e378 = (_e371 + 257u);
                if (_e378 < _e101) {
                } else {
                    break;
                }
                let _e382 = surfaces.member[_e378];
                let _e383 = bitcast<f32>(_e382);
                let _e384 = (_e371 + 258u);
                if (_e384 < _e101) {
                } else {
                    break;
                }
                let _e388 = surfaces.member[_e384];
                let _e389 = bitcast<f32>(_e388);
                let _e390 = (_e371 + 259u);
                if (_e390 < _e101) {
                } else {
                    break;
                }
                let _e394 = surfaces.member[_e390];
                let _e395 = (_e371 + 260u);
                if (_e395 < _e101) {
                } else {
                    break;
                }
                let _e399 = surfaces.member[_e395];
                let _e401 = (_e371 + 261u);
                if (_e401 < _e101) {
                } else {
                    break;
                }
                let _e405 = surfaces.member[_e401];
                let _e407 = (_e371 + 262u);
                if (_e407 < _e101) {
                } else {
                    break;
                }
                let _e411 = surfaces.member[_e407];
                let _e413 = (_e371 + 263u);
                if (_e413 < _e101) {
                } else {
                    break;
                }
                let _e417 = surfaces.member[_e413];
                let _e418 = (_e371 + 264u);
                if (_e418 < _e101) {
                } else {
                    break;
                }
                let _e422 = surfaces.member[_e418];
                let _e423 = bitcast<f32>(_e422);
                let _e424 = (_e371 + 265u);
                if (_e424 < _e101) {
                } else {
                    break;
                }
                let _e428 = surfaces.member[_e424];
                if ((_e371 + 266u) < _e101) {
                } else {
                    break;
                }
                if ((_e371 + 267u) < _e101) {
                } else {
                    break;
                }
                let _e435 = local_7;
                if (_e435 < _e103) {
                } else {
                    break;
                }
                let _e439 = local_8;
                let _e441 = tile_first.member[_e439];
                let _e442 = (_e109 - _e441);
                if (_e297 < _e290) {
                    phi_1191_ = 0u;
                } else {
                    phi_1191_ = ((bitcast<u32>((_e297 - _e290)) / 4u) + 1u);
                }
                let _e449 = phi_1191_;
                let _e451 = select(1u, _e449, (1u < _e449));
                if (_e451 == 0u) {
                    break;
                }
                let _e453 = (_e442 / _e451);
                let _e458 = (_e290 + bitcast<i32>(((_e442 - (_e453 * _e451)) * 4u)));
                let _e461 = (_e325 + bitcast<i32>((_e453 * 4u)));
                let _e465 = select(_e255.z, _e248.z, (_e248.z < _e255.z));
                let _e470 = select(_e255.z, _e248.z, (_e248.z > _e255.z));
                let _e476 = (-1f - floor(-(select(_e262.z, _e465, (_e465 < _e262.z)))));
                let _e477 = floor(select(_e262.z, _e470, (_e470 > _e262.z)));
                let _e478 = (_e241.z - 1f);
                let _e480 = select(0f, _e476, (_e476 > 0f));
                let _e482 = select(_e478, _e477, (_e477 < _e478));
                let _e489 = select(0i, select(select(i32(_e480), i32(-2147483648), (_e480 < -2147483600f)), 2147483647i, (_e480 > 2147483500f)), (_e480 == _e480));
                let _e496 = select(0i, select(select(i32(_e482), i32(-2147483648), (_e482 < -2147483600f)), 2147483647i, (_e482 > 2147483500f)), (_e482 == _e482));
                let _e497 = (_e255.x - _e248.x);
                let _e498 = (_e255.y - _e248.y);
                let _e504 = ((abs(_e497) + abs(_e498)) + abs((_e255.z - _e248.z)));
                let _e505 = (_e262.x - _e248.x);
                let _e506 = (_e262.y - _e248.y);
                let _e512 = ((abs(_e505) + abs(_e506)) + abs((_e262.z - _e248.z)));
                let _e514 = select(_e213, _e212, (_e212 > _e213));
                let _e522 = (select(_e214, _e514, (_e514 > _e214)) <= (((0.000004f * _e504) * _e512) * select(_e512, _e504, (_e504 > _e512))));
                let _e523 = (_e458 + 4i);
                let _e524 = (_e297 + 1i);
                let _e526 = select(_e523, _e524, (_e524 < _e523));
                let _e527 = (_e461 + 4i);
                let _e528 = (_e332 + 1i);
                let _e531 = (_e458 - 1i);
                let _e534 = (f32(_e458) + 2f);
                let _e536 = (f32(_e461) + 2f);
                let _e539 = ((_e248.x - _e534) * 0.24937655f);
                let _e540 = ((_e248.y - _e536) * 0.24937655f);
                let _e543 = ((_e255.x - _e534) * 0.24937655f);
                let _e544 = ((_e255.y - _e536) * 0.24937655f);
                let _e547 = ((_e262.x - _e534) * 0.24937655f);
                let _e548 = ((_e262.y - _e536) * 0.24937655f);
                let _e549 = (_e543 - _e539);
                let _e550 = (_e544 - _e540);
                let _e553 = ((_e549 * _e540) - (_e550 * _e539));
                let _e556 = ((_e549 * _e548) - (_e550 * _e547));
                let _e559 = (abs(_e549) + abs(_e550));
                if (select(_e556, _e553, (_e553 < _e556)) > (0.5f * _e559)) {
                    phi_3934_ = true;
                } else {
                    phi_3934_ = (select(_e556, _e553, (_e553 > _e556)) < (_e559 * -0.5f));
                }
                let _e569 = phi_3934_;
                if _e569 {
                    phi_1388_ = bool();
                    phi_1389_ = true;
                } else {
                    let _e570 = (_e547 - _e543);
                    let _e571 = (_e548 - _e544);
                    let _e574 = ((_e570 * _e544) - (_e571 * _e543));
                    let _e577 = ((_e570 * _e540) - (_e571 * _e539));
                    let _e580 = (abs(_e570) + abs(_e571));
                    if (select(_e577, _e574, (_e574 < _e577)) > (0.5f * _e580)) {
                        phi_3973_ = true;
                    } else {
                        phi_3973_ = (select(_e577, _e574, (_e574 > _e577)) < (_e580 * -0.5f));
                    }
                    let _e590 = phi_3973_;
                    if _e590 {
                        phi_1387_ = bool();
                    } else {
                        let _e591 = (_e539 - _e547);
                        let _e592 = (_e540 - _e548);
                        let _e595 = ((_e591 * _e548) - (_e592 * _e547));
                        let _e598 = ((_e591 * _e544) - (_e592 * _e543));
                        let _e601 = (abs(_e591) + abs(_e592));
                        if (select(_e598, _e595, (_e595 < _e598)) > (0.5f * _e601)) {
                            phi_4012_ = true;
                        } else {
                            phi_4012_ = (select(_e598, _e595, (_e595 > _e598)) < (_e601 * -0.5f));
                        }
                        let _e611 = phi_4012_;
                        phi_1387_ = _e611;
                    }
                    let _e613 = phi_1387_;
                    phi_1388_ = _e613;
                    phi_1389_ = _e590;
                }
                let _e615 = phi_1388_;
                let _e617 = phi_1389_;
                if select(_e615, true, _e617) {
                    phi_1398_ = type_39(_e333, _e458, _e526, _e461, _e489, _e496, _e531, _e461, 0i, -1i, _e522);
                } else {
                    phi_1398_ = type_39(_e333, _e458, _e526, select(_e527, _e528, (_e528 < _e527)), _e489, _e496, _e531, _e461, 0i, -1i, _e522);
                }
                let _e621 = phi_1398_;
                phi_4967_ = _e137;
                phi_4583_ = _e621.member_6;
                phi_4580_ = _e621.member_9;
                phi_4577_ = _e621.member_8;
                phi_4574_ = _e621.member_7;
                loop {
                    let _e640 = phi_4967_;
                    let _e642 = phi_4583_;
                    let _e644 = phi_4580_;
                    let _e646 = phi_4577_;
                    let _e648 = phi_4574_;
                    phi_4582_ = _e642;
                    phi_4579_ = _e644;
                    phi_4576_ = _e646;
                    phi_4573_ = _e648;
                    loop {
                        let _e650 = phi_4582_;
                        let _e652 = phi_4579_;
                        let _e654 = phi_4576_;
                        let _e656 = phi_4573_;
                        let _e657 = (_e656 < _e621.member_3);
                        if _e657 {
                            phi_4575_ = _e654;
                            loop {
                                let _e659 = phi_4575_;
                                let _e660 = (_e659 < _e652);
                                if _e660 {
                                    let _e661 = (_e659 + 1i);
                                    let _e665 = (f32(_e650) + 0.5f);
                                    let _e666 = (f32(_e656) + 0.5f);
                                    let _e667 = (f32(_e661) + 0.5f);
                                    let _e669 = (_e621.member.member.x - _e665);
                                    let _e671 = (_e621.member.member.y - _e666);
                                    let _e673 = (_e621.member.member.z - _e667);
                                    let _e674 = vec3<f32>(_e665, _e666, _e667);
                                    let _e677 = (_e621.member.member_1.x - _e665);
                                    let _e679 = (_e621.member.member_1.y - _e666);
                                    let _e681 = (_e621.member.member_1.z - _e667);
                                    let _e684 = (_e621.member.member_2.x - _e665);
                                    let _e686 = (_e621.member.member_2.y - _e666);
                                    let _e688 = (_e621.member.member_2.z - _e667);
                                    let _e691 = select(_e677, _e669, (_e669 < _e677));
                                    let _e695 = select(_e679, _e671, (_e671 < _e679));
                                    let _e699 = select(_e681, _e673, (_e673 < _e681));
                                    let _e703 = select(_e677, _e669, (_e669 > _e677));
                                    let _e707 = select(_e679, _e671, (_e671 > _e679));
                                    let _e711 = select(_e681, _e673, (_e673 > _e681));
                                    if (select(_e684, _e691, (_e691 < _e684)) > 0.5f) {
                                        phi_2042_ = bool();
                                        phi_2043_ = true;
                                        phi_2044_ = false;
                                    } else {
                                        if (select(_e686, _e695, (_e695 < _e686)) > 0.5f) {
                                            phi_2039_ = bool();
                                            phi_2040_ = true;
                                            phi_2041_ = false;
                                        } else {
                                            if (select(_e688, _e699, (_e699 < _e688)) > 0.5f) {
                                                phi_2036_ = bool();
                                                phi_2037_ = true;
                                                phi_2038_ = false;
                                            } else {
                                                if (select(_e684, _e703, (_e703 > _e684)) < -0.5f) {
                                                    phi_2033_ = bool();
                                                    phi_2034_ = true;
                                                    phi_2035_ = false;
                                                } else {
                                                    if (select(_e686, _e707, (_e707 > _e686)) < -0.5f) {
                                                        phi_2030_ = bool();
                                                        phi_2031_ = true;
                                                        phi_2032_ = false;
                                                    } else {
                                                        let _e719 = (select(_e688, _e711, (_e711 > _e688)) < -0.5f);
                                                        if _e719 {
                                                            phi_2028_ = bool();
                                                            phi_2029_ = false;
                                                        } else {
                                                            let _e720 = (_e677 - _e669);
                                                            let _e721 = (_e679 - _e671);
                                                            let _e722 = (_e681 - _e673);
                                                            let _e723 = vec3<f32>(_e720, _e721, _e722);
                                                            let _e724 = (_e684 - _e677);
                                                            let _e725 = (_e686 - _e679);
                                                            let _e726 = (_e688 - _e681);
                                                            let _e727 = vec3<f32>(_e724, _e725, _e726);
                                                            let _e728 = (_e669 - _e684);
                                                            let _e729 = (_e671 - _e686);
                                                            let _e730 = (_e673 - _e688);
                                                            let _e731 = vec3<f32>(_e728, _e729, _e730);
                                                            let _e734 = ((_e721 * _e673) - (_e722 * _e671));
                                                            let _e737 = ((_e721 * _e688) - (_e722 * _e686));
                                                            let _e738 = abs(_e721);
                                                            let _e739 = abs(_e722);
                                                            let _e740 = (_e738 + _e739);
                                                            if (select(_e737, _e734, (_e734 < _e737)) > (0.5f * _e740)) {
                                                                phi_1618_ = true;
                                                            } else {
                                                                phi_1618_ = (select(_e737, _e734, (_e734 > _e737)) < (_e740 * -0.5f));
                                                            }
                                                            let _e750 = phi_1618_;
                                                            if _e750 {
                                                                phi_1680_ = bool();
                                                                phi_1681_ = true;
                                                            } else {
                                                                let _e753 = ((_e722 * _e669) - (_e720 * _e673));
                                                                let _e756 = ((_e722 * _e684) - (_e720 * _e688));
                                                                let _e757 = abs(_e720);
                                                                let _e758 = (_e739 + _e757);
                                                                if (select(_e756, _e753, (_e753 < _e756)) > (0.5f * _e758)) {
                                                                    phi_1648_ = true;
                                                                } else {
                                                                    phi_1648_ = (select(_e756, _e753, (_e753 > _e756)) < (_e758 * -0.5f));
                                                                }
                                                                let _e768 = phi_1648_;
                                                                if _e768 {
                                                                    phi_1679_ = bool();
                                                                } else {
                                                                    let _e771 = ((_e720 * _e671) - (_e721 * _e669));
                                                                    let _e774 = ((_e720 * _e686) - (_e721 * _e684));
                                                                    let _e775 = (_e757 + _e738);
                                                                    if (select(_e774, _e771, (_e771 < _e774)) > (0.5f * _e775)) {
                                                                        phi_1678_ = true;
                                                                    } else {
                                                                        phi_1678_ = (select(_e774, _e771, (_e771 > _e774)) < (_e775 * -0.5f));
                                                                    }
                                                                    let _e785 = phi_1678_;
                                                                    phi_1679_ = _e785;
                                                                }
                                                                let _e787 = phi_1679_;
                                                                phi_1680_ = _e787;
                                                                phi_1681_ = _e768;
                                                            }
                                                            let _e789 = phi_1680_;
                                                            let _e791 = phi_1681_;
                                                            if select(_e789, true, _e791) {
                                                                phi_2023_ = bool();
                                                                phi_2024_ = true;
                                                            } else {
                                                                let _e795 = ((_e725 * _e681) - (_e726 * _e679));
                                                                let _e798 = ((_e725 * _e673) - (_e726 * _e671));
                                                                let _e799 = abs(_e725);
                                                                let _e800 = abs(_e726);
                                                                let _e801 = (_e799 + _e800);
                                                                if (select(_e798, _e795, (_e795 < _e798)) > (0.5f * _e801)) {
                                                                    phi_1715_ = true;
                                                                } else {
                                                                    phi_1715_ = (select(_e798, _e795, (_e795 > _e798)) < (_e801 * -0.5f));
                                                                }
                                                                let _e811 = phi_1715_;
                                                                if _e811 {
                                                                    phi_1777_ = bool();
                                                                    phi_1778_ = true;
                                                                } else {
                                                                    let _e814 = ((_e726 * _e677) - (_e724 * _e681));
                                                                    let _e817 = ((_e726 * _e669) - (_e724 * _e673));
                                                                    let _e818 = abs(_e724);
                                                                    let _e819 = (_e800 + _e818);
                                                                    if (select(_e817, _e814, (_e814 < _e817)) > (0.5f * _e819)) {
                                                                        phi_1745_ = true;
                                                                    } else {
                                                                        phi_1745_ = (select(_e817, _e814, (_e814 > _e817)) < (_e819 * -0.5f));
                                                                    }
                                                                    let _e829 = phi_1745_;
                                                                    if _e829 {
                                                                        phi_1776_ = bool();
                                                                    } else {
                                                                        let _e832 = ((_e724 * _e679) - (_e725 * _e677));
                                                                        let _e835 = ((_e724 * _e671) - (_e725 * _e669));
                                                                        let _e836 = (_e818 + _e799);
                                                                        if (select(_e835, _e832, (_e832 < _e835)) > (0.5f * _e836)) {
                                                                            phi_1775_ = true;
                                                                        } else {
                                                                            phi_1775_ = (select(_e835, _e832, (_e832 > _e835)) < (_e836 * -0.5f));
                                                                        }
                                                                        let _e846 = phi_1775_;
                                                                        phi_1776_ = _e846;
                                                                    }
                                                                    let _e848 = phi_1776_;
                                                                    phi_1777_ = _e848;
                                                                    phi_1778_ = _e829;
                                                                }
                                                                let _e850 = phi_1777_;
                                                                let _e852 = phi_1778_;
                                                                if select(_e850, true, _e852) {
                                                                    phi_2021_ = bool();
                                                                    phi_2022_ = true;
                                                                } else {
                                                                    let _e856 = ((_e729 * _e688) - (_e730 * _e686));
                                                                    let _e859 = ((_e729 * _e681) - (_e730 * _e679));
                                                                    let _e860 = abs(_e729);
                                                                    let _e861 = abs(_e730);
                                                                    let _e862 = (_e860 + _e861);
                                                                    if (select(_e859, _e856, (_e856 < _e859)) > (0.5f * _e862)) {
                                                                        phi_1812_ = true;
                                                                    } else {
                                                                        phi_1812_ = (select(_e859, _e856, (_e856 > _e859)) < (_e862 * -0.5f));
                                                                    }
                                                                    let _e872 = phi_1812_;
                                                                    if _e872 {
                                                                        phi_1874_ = bool();
                                                                        phi_1875_ = true;
                                                                    } else {
                                                                        let _e875 = ((_e730 * _e684) - (_e728 * _e688));
                                                                        let _e878 = ((_e730 * _e677) - (_e728 * _e681));
                                                                        let _e879 = abs(_e728);
                                                                        let _e880 = (_e861 + _e879);
                                                                        if (select(_e878, _e875, (_e875 < _e878)) > (0.5f * _e880)) {
                                                                            phi_1842_ = true;
                                                                        } else {
                                                                            phi_1842_ = (select(_e878, _e875, (_e875 > _e878)) < (_e880 * -0.5f));
                                                                        }
                                                                        let _e890 = phi_1842_;
                                                                        if _e890 {
                                                                            phi_1873_ = bool();
                                                                        } else {
                                                                            let _e893 = ((_e728 * _e686) - (_e729 * _e684));
                                                                            let _e896 = ((_e728 * _e679) - (_e729 * _e677));
                                                                            let _e897 = (_e879 + _e860);
                                                                            if (select(_e896, _e893, (_e893 < _e896)) > (0.5f * _e897)) {
                                                                                phi_1872_ = true;
                                                                            } else {
                                                                                phi_1872_ = (select(_e896, _e893, (_e893 > _e896)) < (_e897 * -0.5f));
                                                                            }
                                                                            let _e907 = phi_1872_;
                                                                            phi_1873_ = _e907;
                                                                        }
                                                                        let _e909 = phi_1873_;
                                                                        phi_1874_ = _e909;
                                                                        phi_1875_ = _e890;
                                                                    }
                                                                    let _e911 = phi_1874_;
                                                                    let _e913 = phi_1875_;
                                                                    let _e914 = select(_e911, true, _e913);
                                                                    if _e914 {
                                                                        phi_2020_ = bool();
                                                                    } else {
                                                                        let _e917 = ((abs(_e720) + _e738) + _e739);
                                                                        let _e920 = ((abs(_e724) + _e799) + _e800);
                                                                        let _e923 = ((abs(_e728) + _e860) + _e861);
                                                                        if (_e917 >= _e920) {
                                                                            phi_1907_ = select(true, false, (_e917 >= _e923));
                                                                        } else {
                                                                            phi_1907_ = true;
                                                                        }
                                                                        let _e928 = phi_1907_;
                                                                        if _e928 {
                                                                            let _e930 = vec3((_e920 >= _e923));
                                                                            phi_1917_ = select(_e723, _e731, _e930);
                                                                            phi_1918_ = select(_e727, _e723, _e930);
                                                                        } else {
                                                                            phi_1917_ = _e727;
                                                                            phi_1918_ = _e731;
                                                                        }
                                                                        let _e934 = phi_1917_;
                                                                        let _e936 = phi_1918_;
                                                                        let _e943 = ((_e934.y * _e936.z) - (_e936.y * _e934.z));
                                                                        let _e948 = ((_e934.z * _e936.x) - (_e936.z * _e934.x));
                                                                        let _e951 = ((_e934.x * _e936.y) - (_e936.x * _e934.y));
                                                                        let _e962 = ((abs(_e669) + abs(_e671)) + abs(_e673));
                                                                        let _e967 = ((abs(_e677) + abs(_e679)) + abs(_e681));
                                                                        let _e972 = ((abs(_e684) + abs(_e686)) + abs(_e688));
                                                                        if (_e962 <= _e967) {
                                                                            phi_1970_ = select(true, false, (_e962 <= _e972));
                                                                        } else {
                                                                            phi_1970_ = true;
                                                                        }
                                                                        let _e977 = phi_1970_;
                                                                        if _e977 {
                                                                            phi_1979_ = select((_e621.member.member_2 - _e674), (_e621.member.member_1 - _e674), vec3((_e967 <= _e972)));
                                                                        } else {
                                                                            phi_1979_ = (_e621.member.member - _e674);
                                                                        }
                                                                        let _e982 = phi_1979_;
                                                                        let _e984 = select(_e967, _e962, (_e962 < _e967));
                                                                        phi_2020_ = (abs((((_e943 * _e982.x) + (_e948 * _e982.y)) + (_e951 * _e982.z))) <= ((0.5f * ((abs(_e943) + abs(_e948)) + abs(_e951))) + (((0.00000036f * select(_e972, _e984, (_e984 < _e972))) * ((abs(_e934.x) + abs(_e934.y)) + abs(_e934.z))) * ((abs(_e936.x) + abs(_e936.y)) + abs(_e936.z)))));
                                                                    }
                                                                    let _e1012 = phi_2020_;
                                                                    phi_2021_ = _e1012;
                                                                    phi_2022_ = _e914;
                                                                }
                                                                let _e1014 = phi_2021_;
                                                                let _e1016 = phi_2022_;
                                                                phi_2023_ = _e1014;
                                                                phi_2024_ = _e1016;
                                                            }
                                                            let _e1018 = phi_2023_;
                                                            let _e1020 = phi_2024_;
                                                            phi_2028_ = _e1018;
                                                            phi_2029_ = _e1020;
                                                        }
                                                        let _e1022 = phi_2028_;
                                                        let _e1024 = phi_2029_;
                                                        phi_2030_ = _e1022;
                                                        phi_2031_ = _e719;
                                                        phi_2032_ = _e1024;
                                                    }
                                                    let _e1026 = phi_2030_;
                                                    let _e1028 = phi_2031_;
                                                    let _e1030 = phi_2032_;
                                                    phi_2033_ = _e1026;
                                                    phi_2034_ = _e1028;
                                                    phi_2035_ = _e1030;
                                                }
                                                let _e1032 = phi_2033_;
                                                let _e1034 = phi_2034_;
                                                let _e1036 = phi_2035_;
                                                phi_2036_ = _e1032;
                                                phi_2037_ = _e1034;
                                                phi_2038_ = _e1036;
                                            }
                                            let _e1038 = phi_2036_;
                                            let _e1040 = phi_2037_;
                                            let _e1042 = phi_2038_;
                                            phi_2039_ = _e1038;
                                            phi_2040_ = _e1040;
                                            phi_2041_ = _e1042;
                                        }
                                        let _e1044 = phi_2039_;
                                        let _e1046 = phi_2040_;
                                        let _e1048 = phi_2041_;
                                        phi_2042_ = _e1044;
                                        phi_2043_ = _e1046;
                                        phi_2044_ = _e1048;
                                    }
                                    let _e1050 = phi_2042_;
                                    let _e1052 = phi_2043_;
                                    let _e1054 = phi_2044_;
                                    phi_4873_ = _e661;
                                    phi_2057_ = select(true, false, select(_e1050, false, select(_e1054, true, _e1052)));
                                } else {
                                    phi_4873_ = _e659;
                                    phi_2057_ = false;
                                }
                                let _e1059 = phi_4873_;
                                let _e1061 = phi_2057_;
                                let _e1062 = select(true, false, _e660);
                                local_9 = _e1062;
                                local_42 = _e1059;
                                local_43 = _e1062;
                                continue;
                                continuing {
                                    phi_4575_ = _e1059;
                                    break if !(_e1061);
                                }
                            }
                            let _e1065 = local_9;
                            if _e1065 {
                                let _e1066 = (_e650 + 1i);
                                let _e1067 = (_e1066 >= _e621.member_2);
                                if _e1067 {
                                    phi_4732_ = (_e656 + 1i);
                                } else {
                                    phi_4732_ = _e656;
                                }
                                let _e1070 = phi_4732_;
                                let _e1071 = select(_e1066, _e621.member_1, _e1067);
                                if _e621.member_10 {
                                    let _e1118 = (_e621.member.member_1.x - _e621.member.member.x);
                                    let _e1121 = (_e621.member.member_1.y - _e621.member.member.y);
                                    let _e1124 = (_e621.member.member_1.z - _e621.member.member.z);
                                    let _e1125 = f32(_e1071);
                                    let _e1126 = (_e1125 - 0.01f);
                                    let _e1127 = (_e1126 - _e621.member.member.x);
                                    let _e1128 = (_e1125 + 1.01f);
                                    let _e1129 = (_e1128 - _e621.member.member.x);
                                    if (abs(_e1118) < 0.000001f) {
                                        if (_e1127 <= 0f) {
                                            let _e1140 = (_e1129 >= 0f);
                                            if _e1140 {
                                                phi_4062_ = type_33(0f, 1f);
                                            } else {
                                                phi_4062_ = type_33();
                                            }
                                            let _e1142 = phi_4062_;
                                            phi_4065_ = _e1142;
                                            phi_4066_ = select(true, false, _e1140);
                                        } else {
                                            phi_4065_ = type_33();
                                            phi_4066_ = true;
                                        }
                                        let _e1145 = phi_4065_;
                                        let _e1147 = phi_4066_;
                                        if _e1147 {
                                            phi_4071_ = type_33(1f, 0f);
                                        } else {
                                            phi_4071_ = _e1145;
                                        }
                                        let _e1149 = phi_4071_;
                                        phi_4073_ = _e1149;
                                    } else {
                                        let _e1132 = (_e1127 / _e1118);
                                        let _e1133 = (_e1129 / _e1118);
                                        phi_4073_ = type_33(select(_e1133, _e1132, (_e1132 < _e1133)), select(_e1133, _e1132, (_e1132 > _e1133)));
                                    }
                                    let _e1151 = phi_4073_;
                                    let _e1154 = f32(_e1070);
                                    let _e1155 = (_e1154 - 0.01f);
                                    let _e1156 = (_e1155 - _e621.member.member.y);
                                    let _e1157 = (_e1154 + 1.01f);
                                    let _e1158 = (_e1157 - _e621.member.member.y);
                                    if (abs(_e1121) < 0.000001f) {
                                        if (_e1156 <= 0f) {
                                            let _e1169 = (_e1158 >= 0f);
                                            if _e1169 {
                                                phi_4109_ = type_33(0f, 1f);
                                            } else {
                                                phi_4109_ = type_33();
                                            }
                                            let _e1171 = phi_4109_;
                                            phi_4112_ = _e1171;
                                            phi_4113_ = select(true, false, _e1169);
                                        } else {
                                            phi_4112_ = type_33();
                                            phi_4113_ = true;
                                        }
                                        let _e1174 = phi_4112_;
                                        let _e1176 = phi_4113_;
                                        if _e1176 {
                                            phi_4118_ = type_33(1f, 0f);
                                        } else {
                                            phi_4118_ = _e1174;
                                        }
                                        let _e1178 = phi_4118_;
                                        phi_4120_ = _e1178;
                                    } else {
                                        let _e1161 = (_e1156 / _e1121);
                                        let _e1162 = (_e1158 / _e1121);
                                        phi_4120_ = type_33(select(_e1162, _e1161, (_e1161 < _e1162)), select(_e1162, _e1161, (_e1161 > _e1162)));
                                    }
                                    let _e1180 = phi_4120_;
                                    let _e1184 = select(_e1180.member, _e1151.member, (_e1151.member > _e1180.member));
                                    let _e1186 = select(0f, _e1184, (_e1184 > 0f));
                                    let _e1188 = select(_e1180.member_1, _e1151.member_1, (_e1151.member_1 < _e1180.member_1));
                                    let _e1190 = select(1f, _e1188, (_e1188 < 1f));
                                    if (_e1186 > _e1190) {
                                        phi_4168_ = type_33(_e621.member.member_5.z, -2f);
                                    } else {
                                        let _e1193 = (_e621.member.member.z + (_e1124 * _e1186));
                                        let _e1195 = (_e621.member.member.z + (_e1124 * _e1190));
                                        phi_4168_ = type_33(select(_e1195, _e1193, (_e1193 < _e1195)), select(_e1195, _e1193, (_e1193 > _e1195)));
                                    }
                                    let _e1204 = phi_4168_;
                                    let _e1208 = (_e621.member.member_2.x - _e621.member.member_1.x);
                                    let _e1210 = (_e621.member.member_2.y - _e621.member.member_1.y);
                                    let _e1212 = (_e621.member.member_2.z - _e621.member.member_1.z);
                                    let _e1213 = (_e1126 - _e621.member.member_1.x);
                                    let _e1214 = (_e1128 - _e621.member.member_1.x);
                                    if (abs(_e1208) < 0.000001f) {
                                        if (_e1213 <= 0f) {
                                            let _e1225 = (_e1214 >= 0f);
                                            if _e1225 {
                                                phi_4217_ = type_33(0f, 1f);
                                            } else {
                                                phi_4217_ = type_33();
                                            }
                                            let _e1227 = phi_4217_;
                                            phi_4220_ = _e1227;
                                            phi_4221_ = select(true, false, _e1225);
                                        } else {
                                            phi_4220_ = type_33();
                                            phi_4221_ = true;
                                        }
                                        let _e1230 = phi_4220_;
                                        let _e1232 = phi_4221_;
                                        if _e1232 {
                                            phi_4226_ = type_33(1f, 0f);
                                        } else {
                                            phi_4226_ = _e1230;
                                        }
                                        let _e1234 = phi_4226_;
                                        phi_4228_ = _e1234;
                                    } else {
                                        let _e1217 = (_e1213 / _e1208);
                                        let _e1218 = (_e1214 / _e1208);
                                        phi_4228_ = type_33(select(_e1218, _e1217, (_e1217 < _e1218)), select(_e1218, _e1217, (_e1217 > _e1218)));
                                    }
                                    let _e1236 = phi_4228_;
                                    let _e1239 = (_e1155 - _e621.member.member_1.y);
                                    let _e1240 = (_e1157 - _e621.member.member_1.y);
                                    if (abs(_e1210) < 0.000001f) {
                                        if (_e1239 <= 0f) {
                                            let _e1251 = (_e1240 >= 0f);
                                            if _e1251 {
                                                phi_4264_ = type_33(0f, 1f);
                                            } else {
                                                phi_4264_ = type_33();
                                            }
                                            let _e1253 = phi_4264_;
                                            phi_4267_ = _e1253;
                                            phi_4268_ = select(true, false, _e1251);
                                        } else {
                                            phi_4267_ = type_33();
                                            phi_4268_ = true;
                                        }
                                        let _e1256 = phi_4267_;
                                        let _e1258 = phi_4268_;
                                        if _e1258 {
                                            phi_4273_ = type_33(1f, 0f);
                                        } else {
                                            phi_4273_ = _e1256;
                                        }
                                        let _e1260 = phi_4273_;
                                        phi_4275_ = _e1260;
                                    } else {
                                        let _e1243 = (_e1239 / _e1210);
                                        let _e1244 = (_e1240 / _e1210);
                                        phi_4275_ = type_33(select(_e1244, _e1243, (_e1243 < _e1244)), select(_e1244, _e1243, (_e1243 > _e1244)));
                                    }
                                    let _e1262 = phi_4275_;
                                    let _e1266 = select(_e1262.member, _e1236.member, (_e1236.member > _e1262.member));
                                    let _e1268 = select(0f, _e1266, (_e1266 > 0f));
                                    let _e1270 = select(_e1262.member_1, _e1236.member_1, (_e1236.member_1 < _e1262.member_1));
                                    let _e1272 = select(1f, _e1270, (_e1270 < 1f));
                                    if (_e1268 > _e1272) {
                                        phi_4323_ = type_33(_e621.member.member_5.z, -2f);
                                    } else {
                                        let _e1275 = (_e621.member.member_1.z + (_e1212 * _e1268));
                                        let _e1277 = (_e621.member.member_1.z + (_e1212 * _e1272));
                                        phi_4323_ = type_33(select(_e1277, _e1275, (_e1275 < _e1277)), select(_e1277, _e1275, (_e1275 > _e1277)));
                                    }
                                    let _e1286 = phi_4323_;
                                    let _e1289 = (_e621.member.member.x - _e621.member.member_2.x);
                                    let _e1290 = (_e621.member.member.y - _e621.member.member_2.y);
                                    let _e1291 = (_e621.member.member.z - _e621.member.member_2.z);
                                    let _e1292 = (_e1126 - _e621.member.member_2.x);
                                    let _e1293 = (_e1128 - _e621.member.member_2.x);
                                    if (abs(_e1289) < 0.000001f) {
                                        if (_e1292 <= 0f) {
                                            let _e1304 = (_e1293 >= 0f);
                                            if _e1304 {
                                                phi_4372_ = type_33(0f, 1f);
                                            } else {
                                                phi_4372_ = type_33();
                                            }
                                            let _e1306 = phi_4372_;
                                            phi_4375_ = _e1306;
                                            phi_4376_ = select(true, false, _e1304);
                                        } else {
                                            phi_4375_ = type_33();
                                            phi_4376_ = true;
                                        }
                                        let _e1309 = phi_4375_;
                                        let _e1311 = phi_4376_;
                                        if _e1311 {
                                            phi_4381_ = type_33(1f, 0f);
                                        } else {
                                            phi_4381_ = _e1309;
                                        }
                                        let _e1313 = phi_4381_;
                                        phi_4383_ = _e1313;
                                    } else {
                                        let _e1296 = (_e1292 / _e1289);
                                        let _e1297 = (_e1293 / _e1289);
                                        phi_4383_ = type_33(select(_e1297, _e1296, (_e1296 < _e1297)), select(_e1297, _e1296, (_e1296 > _e1297)));
                                    }
                                    let _e1315 = phi_4383_;
                                    let _e1318 = (_e1155 - _e621.member.member_2.y);
                                    let _e1319 = (_e1157 - _e621.member.member_2.y);
                                    if (abs(_e1290) < 0.000001f) {
                                        if (_e1318 <= 0f) {
                                            let _e1330 = (_e1319 >= 0f);
                                            if _e1330 {
                                                phi_4419_ = type_33(0f, 1f);
                                            } else {
                                                phi_4419_ = type_33();
                                            }
                                            let _e1332 = phi_4419_;
                                            phi_4422_ = _e1332;
                                            phi_4423_ = select(true, false, _e1330);
                                        } else {
                                            phi_4422_ = type_33();
                                            phi_4423_ = true;
                                        }
                                        let _e1335 = phi_4422_;
                                        let _e1337 = phi_4423_;
                                        if _e1337 {
                                            phi_4428_ = type_33(1f, 0f);
                                        } else {
                                            phi_4428_ = _e1335;
                                        }
                                        let _e1339 = phi_4428_;
                                        phi_4430_ = _e1339;
                                    } else {
                                        let _e1322 = (_e1318 / _e1290);
                                        let _e1323 = (_e1319 / _e1290);
                                        phi_4430_ = type_33(select(_e1323, _e1322, (_e1322 < _e1323)), select(_e1323, _e1322, (_e1322 > _e1323)));
                                    }
                                    let _e1341 = phi_4430_;
                                    let _e1345 = select(_e1341.member, _e1315.member, (_e1315.member > _e1341.member));
                                    let _e1347 = select(0f, _e1345, (_e1345 > 0f));
                                    let _e1349 = select(_e1341.member_1, _e1315.member_1, (_e1315.member_1 < _e1341.member_1));
                                    let _e1351 = select(1f, _e1349, (_e1349 < 1f));
                                    if (_e1347 > _e1351) {
                                        phi_4478_ = type_33(_e621.member.member_5.z, -2f);
                                    } else {
                                        let _e1354 = (_e621.member.member_2.z + (_e1291 * _e1347));
                                        let _e1356 = (_e621.member.member_2.z + (_e1291 * _e1351));
                                        phi_4478_ = type_33(select(_e1356, _e1354, (_e1354 < _e1356)), select(_e1356, _e1354, (_e1354 > _e1356)));
                                    }
                                    let _e1365 = phi_4478_;
                                    let _e1369 = select(_e1286.member, _e1204.member, (_e1204.member < _e1286.member));
                                    let _e1375 = select(_e1286.member_1, _e1204.member_1, (_e1204.member_1 > _e1286.member_1));
                                    phi_2153_ = type_33((floor(select(_e1365.member, _e1369, (_e1369 < _e1365.member))) - 1f), (floor(select(_e1365.member_1, _e1375, (_e1375 > _e1365.member_1))) + 1f));
                                } else {
                                    if (_e621.member.member_4 == 0u) {
                                        phi_2111_ = vec3<f32>(_e621.member.member_3.y, _e621.member.member_3.z, _e621.member.member_3.x);
                                    } else {
                                        if (_e621.member.member_4 == 1u) {
                                            phi_2110_ = vec3<f32>(_e621.member.member_3.z, _e621.member.member_3.x, _e621.member.member_3.y);
                                        } else {
                                            phi_2110_ = _e621.member.member_3;
                                        }
                                        let _e1079 = phi_2110_;
                                        phi_2111_ = _e1079;
                                    }
                                    let _e1085 = phi_2111_;
                                    let _e1102 = (_e621.member.member.z - (((_e1085.x * ((f32(_e1071) + 0.5f) - _e621.member.member.x)) + (_e1085.y * ((f32(_e1070) + 0.5f) - _e621.member.member.y))) / _e1085.z));
                                    let _e1109 = (((0.5f * (abs(_e1085.x) + abs(_e1085.y))) / abs(_e1085.z)) + 0.3f);
                                    phi_2153_ = type_33((-1f - floor((_e1109 - _e1102))), floor((_e1102 + _e1109)));
                                }
                                let _e1382 = phi_2153_;
                                let _e1385 = f32(_e621.member_4);
                                let _e1387 = select(_e1385, _e1382.member, (_e1382.member > _e1385));
                                let _e1396 = f32(_e621.member_5);
                                let _e1398 = select(_e1396, _e1382.member_1, (_e1382.member_1 < _e1396));
                                phi_5488_ = select(0i, select(select(i32(_e1398), i32(-2147483648), (_e1398 < -2147483600f)), 2147483647i, (_e1398 > 2147483500f)), (_e1398 == _e1398));
                                phi_4872_ = (select(0i, select(select(i32(_e1387), i32(-2147483648), (_e1387 < -2147483600f)), 2147483647i, (_e1387 > 2147483500f)), (_e1387 == _e1387)) - 1i);
                                phi_4848_ = _e1070;
                                phi_4818_ = _e1071;
                            } else {
                                phi_5488_ = _e652;
                                let _e2844 = local_42;
                                phi_4872_ = _e2844;
                                phi_4848_ = _e656;
                                phi_4818_ = _e650;
                            }
                            let _e1407 = phi_5488_;
                            let _e1409 = phi_4872_;
                            let _e1411 = phi_4848_;
                            let _e1413 = phi_4818_;
                            phi_5487_ = _e1407;
                            phi_4871_ = _e1409;
                            phi_4847_ = _e1411;
                            phi_4817_ = _e1413;
                            let _e2853 = local_43;
                            phi_2193_ = _e2853;
                        } else {
                            phi_5487_ = _e652;
                            phi_4871_ = _e654;
                            phi_4847_ = _e656;
                            phi_4817_ = _e650;
                            phi_2193_ = false;
                        }
                        let _e1415 = phi_5487_;
                        let _e1417 = phi_4871_;
                        let _e1419 = phi_4847_;
                        let _e1421 = phi_4817_;
                        let _e1423 = phi_2193_;
                        local_38 = _e1421;
                        local_39 = _e1415;
                        local_40 = _e1417;
                        local_41 = _e1419;
                        local_10 = select(true, false, _e657);
                        local_11 = _e1421;
                        local_12 = _e1419;
                        local_13 = _e1417;
                        continue;
                        continuing {
                            phi_4582_ = _e1421;
                            phi_4579_ = _e1415;
                            phi_4576_ = _e1417;
                            phi_4573_ = _e1419;
                            break if !(_e1423);
                        }
                    }
                    let _e1427 = local_10;
                    let _e1429 = select(false, true, select(true, false, _e1427));
                    if _e1429 {
                        let _e1431 = local_11;
                        let _e1432 = f32(_e1431);
                        let _e1434 = local_12;
                        let _e1435 = f32(_e1434);
                        let _e1437 = local_13;
                        let _e1438 = f32(_e1437);
                        let _e1439 = vec3<f32>(_e1432, _e1435, _e1438);
                        if (_e621.member.member_4 == 2u) {
                            phi_2223_ = 2u;
                        } else {
                            phi_2223_ = (1u - _e621.member.member_4);
                        }
                        let _e1443 = phi_2223_;
                        if (_e1443 == 0u) {
                            phi_2235_ = vec3<f32>(_e1435, _e1438, _e1432);
                        } else {
                            if (_e1443 == 1u) {
                                phi_2234_ = vec3<f32>(_e1438, _e1432, _e1435);
                            } else {
                                phi_2234_ = _e1439;
                            }
                            let _e1448 = phi_2234_;
                            phi_2235_ = _e1448;
                        }
                        let _e1451 = phi_2235_;
                        let _e1457 = select(select(u32(_e1451.x), 0u, (_e1451.x < 0f)), 4294967295u, (_e1451.x > 4294967000f));
                        let _e1463 = select(select(u32(_e1451.y), 0u, (_e1451.y < 0f)), 4294967295u, (_e1451.y > 4294967000f));
                        let _e1469 = select(select(u32(_e1451.z), 0u, (_e1451.z < 0f)), 4294967295u, (_e1451.z > 4294967000f));
                        local_1.member = array<vec3<f32>, 10>((_e248 - _e1439), (_e255 - _e1439), (_e262 - _e1439), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        local_1.member_1 = 3u;
                        phi_4959_ = _e640;
                        phi_2291_ = type_12(0u, 6u);
                        loop {
                            let _e1477 = phi_4959_;
                            let _e1479 = phi_2291_;
                            if (_e1479.member < _e1479.member_1) {
                                phi_2292_ = type_12((_e1479.member + 1u), _e1479.member_1);
                                phi_2315_ = type_12(1u, _e1479.member);
                            } else {
                                phi_2292_ = _e1479;
                                phi_2315_ = type_12(0u, type_12().member_1);
                            }
                            let _e1492 = phi_2292_;
                            let _e1494 = phi_2315_;
                            let _e1498 = (bitcast<i32>(_e1494.member) != 0i);
                            if _e1498 {
                                let _e1499 = local_1.member_1;
                                phi_2327_ = type_12(0u, _e1499);
                                phi_2330_ = 0f;
                                loop {
                                    let _e1502 = phi_2327_;
                                    let _e1504 = phi_2330_;
                                    local_14 = _e1504;
                                    if (_e1502.member < _e1502.member_1) {
                                        phi_2328_ = type_12((_e1502.member + 1u), _e1502.member_1);
                                        phi_2353_ = type_12(1u, _e1502.member);
                                    } else {
                                        phi_2328_ = _e1502;
                                        phi_2353_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1517 = phi_2328_;
                                    let _e1519 = phi_2353_;
                                    let _e1523 = (bitcast<i32>(_e1519.member) != 0i);
                                    if _e1523 {
                                        if (_e1519.member_1 < 10u) {
                                        } else {
                                            phi_4954_ = true;
                                            break;
                                        }
                                        let _e1527 = local_1.member[_e1519.member_1];
                                        let _e1529 = (_e1494.member_1 >> bitcast<u32>(1i));
                                        let _e1536 = select(select(_e1527.y, _e1527.x, (_e1529 == 0u)), _e1527.z, (_e1529 == 2u));
                                        if ((_e1494.member_1 & 1u) == 1u) {
                                            phi_2388_ = (1f - _e1536);
                                        } else {
                                            phi_2388_ = _e1536;
                                        }
                                        let _e1541 = phi_2388_;
                                        phi_2331_ = select(_e1541, _e1504, (_e1504 < _e1541));
                                    } else {
                                        phi_2331_ = f32();
                                    }
                                    let _e1545 = phi_2331_;
                                    continue;
                                    continuing {
                                        phi_2327_ = _e1517;
                                        phi_2330_ = _e1545;
                                        phi_4954_ = _e1477;
                                        break if !(_e1523);
                                    }
                                }
                                let _e1548 = phi_4954_;
                                phi_5183_ = _e1548;
                                if _e1548 {
                                    break;
                                }
                                let _e1550 = local_14;
                                if (_e1550 >= 0f) {
                                    phi_5185_ = _e1548;
                                } else {
                                    let _e1552 = local_1.member_1;
                                    if (_e1552 == 0u) {
                                        phi_5186_ = _e1548;
                                    } else {
                                        local[0u] = vec3<f32>(0f, 0f, 0f);
                                        local[1u] = vec3<f32>(0f, 0f, 0f);
                                        local[2u] = vec3<f32>(0f, 0f, 0f);
                                        local[3u] = vec3<f32>(0f, 0f, 0f);
                                        local[4u] = vec3<f32>(0f, 0f, 0f);
                                        local[5u] = vec3<f32>(0f, 0f, 0f);
                                        local[6u] = vec3<f32>(0f, 0f, 0f);
                                        local[7u] = vec3<f32>(0f, 0f, 0f);
                                        local[8u] = vec3<f32>(0f, 0f, 0f);
                                        local[9u] = vec3<f32>(0f, 0f, 0f);
                                        let _e1564 = local_1.member_1;
                                        let _e1565 = (_e1564 - 1u);
                                        if (_e1565 < 10u) {
                                        } else {
                                            phi_5183_ = true;
                                            break;
                                        }
                                        let _e1569 = local_1.member[_e1565];
                                        let _e1571 = (_e1494.member_1 >> bitcast<u32>(1i));
                                        let _e1575 = (_e1571 == 0u);
                                        let _e1577 = (_e1571 == 2u);
                                        let _e1578 = select(select(_e1569.y, _e1569.x, _e1575), _e1569.z, _e1577);
                                        let _e1580 = ((_e1494.member_1 & 1u) == 1u);
                                        if _e1580 {
                                            phi_2444_ = (1f - _e1578);
                                        } else {
                                            phi_2444_ = _e1578;
                                        }
                                        let _e1583 = phi_2444_;
                                        let _e1584 = local_1.member_1;
                                        phi_2449_ = type_12(0u, _e1584);
                                        phi_2452_ = _e1583;
                                        phi_2454_ = _e1569;
                                        phi_2456_ = 0u;
                                        loop {
                                            let _e1587 = phi_2449_;
                                            let _e1589 = phi_2452_;
                                            let _e1591 = phi_2454_;
                                            let _e1593 = phi_2456_;
                                            local_15 = _e1593;
                                            if (_e1587.member < _e1587.member_1) {
                                                phi_2450_ = type_12((_e1587.member + 1u), _e1587.member_1);
                                                phi_2479_ = type_12(1u, _e1587.member);
                                            } else {
                                                phi_2450_ = _e1587;
                                                phi_2479_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1606 = phi_2450_;
                                            let _e1608 = phi_2479_;
                                            let _e1612 = (bitcast<i32>(_e1608.member) != 0i);
                                            if _e1612 {
                                                if (_e1608.member_1 < 10u) {
                                                } else {
                                                    phi_5169_ = true;
                                                    break;
                                                }
                                                let _e1616 = local_1.member[_e1608.member_1];
                                                let _e1621 = select(select(_e1616.y, _e1616.x, _e1575), _e1616.z, _e1577);
                                                if _e1580 {
                                                    phi_2514_ = (1f - _e1621);
                                                } else {
                                                    phi_2514_ = _e1621;
                                                }
                                                let _e1624 = phi_2514_;
                                                if ((_e1624 < 0f) != (_e1589 < 0f)) {
                                                    let _e1628 = (_e1593 < 10u);
                                                    if _e1628 {
                                                        let _e1636 = (_e1589 / (_e1589 - _e1624));
                                                        if _e1628 {
                                                        } else {
                                                            phi_5169_ = true;
                                                            break;
                                                        }
                                                        local[_e1593] = (_e1591 + vec3<f32>(((_e1616.x - _e1591.x) * _e1636), ((_e1616.y - _e1591.y) * _e1636), ((_e1616.z - _e1591.z) * _e1636)));
                                                        phi_2548_ = (_e1593 + 1u);
                                                    } else {
                                                        phi_2548_ = _e1593;
                                                    }
                                                    let _e1645 = phi_2548_;
                                                    phi_2549_ = _e1645;
                                                } else {
                                                    phi_2549_ = _e1593;
                                                }
                                                let _e1647 = phi_2549_;
                                                if (_e1624 >= 0f) {
                                                    let _e1649 = (_e1647 < 10u);
                                                    if _e1649 {
                                                        if _e1649 {
                                                        } else {
                                                            phi_5169_ = true;
                                                            break;
                                                        }
                                                        local[_e1647] = _e1616;
                                                        phi_2565_ = (_e1647 + 1u);
                                                    } else {
                                                        phi_2565_ = _e1647;
                                                    }
                                                    let _e1653 = phi_2565_;
                                                    phi_2566_ = _e1653;
                                                } else {
                                                    phi_2566_ = _e1647;
                                                }
                                                let _e1655 = phi_2566_;
                                                phi_2453_ = _e1624;
                                                phi_2455_ = _e1616;
                                                phi_2457_ = _e1655;
                                            } else {
                                                phi_2453_ = f32();
                                                phi_2455_ = vec3<f32>();
                                                phi_2457_ = u32();
                                            }
                                            let _e1657 = phi_2453_;
                                            let _e1659 = phi_2455_;
                                            let _e1661 = phi_2457_;
                                            continue;
                                            continuing {
                                                phi_2449_ = _e1606;
                                                phi_2452_ = _e1657;
                                                phi_2454_ = _e1659;
                                                phi_2456_ = _e1661;
                                                phi_5169_ = _e1548;
                                                break if !(_e1612);
                                            }
                                        }
                                        let _e1664 = phi_5169_;
                                        phi_5183_ = _e1664;
                                        if _e1664 {
                                            break;
                                        }
                                        let _e1665 = local;
                                        local_1.member = _e1665;
                                        let _e1667 = local_15;
                                        local_1.member_1 = _e1667;
                                        phi_5186_ = _e1664;
                                    }
                                    let _e1669 = phi_5186_;
                                    phi_5185_ = _e1669;
                                }
                                let _e1671 = phi_5185_;
                                phi_5184_ = _e1671;
                            } else {
                                phi_5184_ = _e1477;
                            }
                            let _e1673 = phi_5184_;
                            continue;
                            continuing {
                                phi_4959_ = _e1673;
                                phi_2291_ = _e1492;
                                phi_5183_ = _e1673;
                                break if !(_e1498);
                            }
                        }
                        let _e1676 = phi_5183_;
                        phi_5195_ = _e1676;
                        if _e1676 {
                            break;
                        }
                        let _e1679 = local_1.member[0u];
                        let _e1683 = local_1.member_1;
                        phi_2578_ = type_12(1u, _e1683);
                        phi_2581_ = vec3<f32>(0f, 0f, 0f);
                        phi_2583_ = _e1679.z;
                        phi_2585_ = _e1679.y;
                        phi_2587_ = _e1679.x;
                        phi_2589_ = 0f;
                        loop {
                            let _e1686 = phi_2578_;
                            let _e1688 = phi_2581_;
                            let _e1690 = phi_2583_;
                            let _e1692 = phi_2585_;
                            let _e1694 = phi_2587_;
                            let _e1696 = phi_2589_;
                            local_16 = _e1694;
                            local_17 = _e1692;
                            local_18 = _e1690;
                            local_19 = _e1696;
                            local_20 = _e1688;
                            local_21 = _e1696;
                            local_22 = _e1688;
                            local_23 = _e1696;
                            local_24 = _e1688;
                            local_25 = _e1696;
                            local_26 = _e1696;
                            if (_e1686.member < _e1686.member_1) {
                                phi_2579_ = type_12((_e1686.member + 1u), _e1686.member_1);
                                phi_2612_ = type_12(1u, _e1686.member);
                            } else {
                                phi_2579_ = _e1686;
                                phi_2612_ = type_12(0u, type_12().member_1);
                            }
                            let _e1709 = phi_2579_;
                            let _e1711 = phi_2612_;
                            let _e1715 = (bitcast<i32>(_e1711.member) != 0i);
                            if _e1715 {
                                if (_e1711.member_1 < 10u) {
                                } else {
                                    phi_5187_ = true;
                                    break;
                                }
                                let _e1719 = local_1.member[_e1711.member_1];
                                let _e1729 = (_e1711.member_1 + 1u);
                                let _e1730 = local_1.member_1;
                                if (_e1729 < _e1730) {
                                    if (_e1729 < 10u) {
                                    } else {
                                        phi_5187_ = true;
                                        break;
                                    }
                                    let _e1735 = local_1.member[_e1729];
                                    let _e1736 = (_e1719.x - _e1679.x);
                                    let _e1737 = (_e1719.y - _e1679.y);
                                    let _e1738 = (_e1719.z - _e1679.z);
                                    let _e1740 = (_e1735.x - _e1679.x);
                                    let _e1742 = (_e1735.y - _e1679.y);
                                    let _e1744 = (_e1735.z - _e1679.z);
                                    let _e1747 = ((_e1737 * _e1744) - (_e1742 * _e1738));
                                    let _e1750 = ((_e1738 * _e1740) - (_e1744 * _e1736));
                                    let _e1753 = ((_e1736 * _e1742) - (_e1740 * _e1737));
                                    let _e1759 = sqrt((((_e1747 * _e1747) + (_e1750 * _e1750)) + (_e1753 * _e1753)));
                                    let _e1771 = (_e1759 * 0.16666667f);
                                    phi_2726_ = vec3<f32>((_e1688.x + (((_e1719.x + _e1735.x) - (_e1679.x * 2f)) * _e1771)), (_e1688.y + (((_e1719.y + _e1735.y) - (_e1679.y * 2f)) * _e1771)), (_e1688.z + (((_e1719.z + _e1735.z) - (_e1679.z * 2f)) * _e1771)));
                                    phi_2727_ = (_e1696 + (0.5f * _e1759));
                                } else {
                                    phi_2726_ = _e1688;
                                    phi_2727_ = _e1696;
                                }
                                let _e1783 = phi_2726_;
                                let _e1785 = phi_2727_;
                                phi_2582_ = _e1783;
                                phi_2584_ = select(_e1719.z, _e1690, (_e1690 < _e1719.z));
                                phi_2586_ = select(_e1719.y, _e1692, (_e1692 < _e1719.y));
                                phi_2588_ = select(_e1719.x, _e1694, (_e1694 < _e1719.x));
                                phi_2590_ = _e1785;
                            } else {
                                phi_2582_ = vec3<f32>();
                                phi_2584_ = f32();
                                phi_2586_ = f32();
                                phi_2588_ = f32();
                                phi_2590_ = f32();
                            }
                            let _e1787 = phi_2582_;
                            let _e1789 = phi_2584_;
                            let _e1791 = phi_2586_;
                            let _e1793 = phi_2588_;
                            let _e1795 = phi_2590_;
                            continue;
                            continuing {
                                phi_2578_ = _e1709;
                                phi_2581_ = _e1787;
                                phi_2583_ = _e1789;
                                phi_2585_ = _e1791;
                                phi_2587_ = _e1793;
                                phi_2589_ = _e1795;
                                phi_5187_ = _e1676;
                                break if !(_e1715);
                            }
                        }
                        let _e1798 = phi_5187_;
                        phi_5195_ = _e1798;
                        if _e1798 {
                            break;
                        }
                        let _e1799 = local_1.member_1;
                        if (_e1799 == 0u) {
                            phi_2746_ = bool();
                            phi_2747_ = true;
                        } else {
                            let _e1802 = local_16;
                            if (_e1802 >= 1f) {
                                phi_2744_ = bool();
                                phi_2745_ = true;
                            } else {
                                let _e1805 = local_17;
                                let _e1806 = (_e1805 >= 1f);
                                if _e1806 {
                                    phi_2743_ = bool();
                                } else {
                                    let _e1808 = local_18;
                                    phi_2743_ = (_e1808 >= 1f);
                                }
                                let _e1811 = phi_2743_;
                                phi_2744_ = _e1811;
                                phi_2745_ = _e1806;
                            }
                            let _e1813 = phi_2744_;
                            let _e1815 = phi_2745_;
                            phi_2746_ = _e1813;
                            phi_2747_ = _e1815;
                        }
                        let _e1817 = phi_2746_;
                        let _e1819 = phi_2747_;
                        let _e1822 = local_19;
                        if (_e1822 > 0f) {
                            let _e1825 = local_20;
                            let _e1828 = local_21;
                            let _e1831 = local_22;
                            let _e1834 = local_23;
                            let _e1837 = local_24;
                            let _e1840 = local_25;
                            phi_2764_ = (_e1679 + vec3<f32>((_e1825.x / _e1828), (_e1831.y / _e1834), (_e1837.z / _e1840)));
                        } else {
                            phi_2764_ = _e1679;
                        }
                        let _e1845 = phi_2764_;
                        let _e1847 = local_26;
                        let _e1851 = select(0f, _e1845.x, (_e1845.x > 0f));
                        let _e1853 = select(1f, _e1851, (_e1851 < 1f));
                        let _e1856 = select(0f, _e1845.y, (_e1845.y > 0f));
                        let _e1858 = select(1f, _e1856, (_e1856 < 1f));
                        let _e1861 = select(0f, _e1845.z, (_e1845.z > 0f));
                        let _e1863 = select(1f, _e1861, (_e1861 < 1f));
                        let _e1868 = local_27;
                        if (_e1868 < arrayLength((&attributes.member))) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e1870 = ((_e1853 + _e1432) - _e248.x);
                        let _e1871 = ((_e1858 + _e1435) - _e248.y);
                        let _e1874 = ((_e497 * _e506) - (_e498 * _e505));
                        if (abs(_e1874) > 0f) {
                            phi_2836_ = (1f / _e1874);
                        } else {
                            phi_2836_ = 0f;
                        }
                        let _e1879 = phi_2836_;
                        let _e1883 = (((_e1870 * _e506) - (_e1871 * _e505)) * _e1879);
                        let _e1885 = select(0f, _e1883, (_e1883 > 0f));
                        let _e1887 = select(1f, _e1885, (_e1885 < 1f));
                        let _e1891 = (((_e497 * _e1871) - (_e498 * _e1870)) * _e1879);
                        let _e1893 = select(0f, _e1891, (_e1891 > 0f));
                        let _e1895 = select(1f, _e1893, (_e1893 < 1f));
                        let _e1897 = ((1f - _e1887) - _e1895);
                        let _e1900 = local_28;
                        let _e1904 = attributes.member[_e1900].member[0u];
                        let _e1908 = local_29;
                        let _e1912 = attributes.member[_e1908].member[2u];
                        let _e1917 = local_30;
                        let _e1921 = attributes.member[_e1917].member[4u];
                        let _e1923 = (((_e1904 * _e1897) + (_e1912 * _e1887)) + (_e1921 * _e1895));
                        let _e1926 = local_31;
                        let _e1930 = attributes.member[_e1926].member[1u];
                        let _e1934 = local_32;
                        let _e1938 = attributes.member[_e1934].member[3u];
                        let _e1943 = local_33;
                        let _e1947 = attributes.member[_e1943].member[5u];
                        let _e1949 = (((_e1930 * _e1897) + (_e1938 * _e1887)) + (_e1947 * _e1895));
                        if (_e394 == 4294967295u) {
                            phi_3332_ = type_30(vec3<f32>(_e377, _e383, _e389), _e423);
                        } else {
                            let _e1952 = (_e417 & 65535u);
                            let _e1954 = (_e417 >> bitcast<u32>(16i));
                            let _e1957 = ((_e394 >> bitcast<u32>(28u)) & 3u);
                            let _e1958 = (_e1952 - 1u);
                            let _e1960 = select(1f, 2f, (_e1957 == 2u));
                            let _e1964 = (_e1923 - (floor((_e1923 / _e1960)) * _e1960));
                            if (_e1964 > 1f) {
                                phi_2914_ = (_e1960 - _e1964);
                            } else {
                                phi_2914_ = _e1964;
                            }
                            let _e1968 = phi_2914_;
                            if (_e1957 == 1u) {
                                let _e1971 = select(0f, _e1923, (_e1923 > 0f));
                                phi_2929_ = select(1f, _e1971, (_e1971 < 1f));
                            } else {
                                phi_2929_ = _e1968;
                            }
                            let _e1975 = phi_2929_;
                            if (_e1975 >= 0f) {
                                phi_2939_ = select(true, false, (_e1975 <= 1f));
                            } else {
                                phi_2939_ = true;
                            }
                            let _e1980 = phi_2939_;
                            let _e1984 = ((select(_e1975, 0f, _e1980) * f32(_e1952)) - 0.5f);
                            let _e1985 = floor(_e1984);
                            let _e1986 = (_e1985 < 0f);
                            if _e1986 {
                                phi_2964_ = 0u;
                            } else {
                                let _e1991 = select(select(u32(_e1985), 0u, (_e1985 < 0f)), 4294967295u, (_e1985 > 4294967000f));
                                phi_2964_ = select(_e1991, _e1958, (_e1958 < _e1991));
                            }
                            let _e1995 = phi_2964_;
                            if _e1986 {
                                phi_2974_ = 0u;
                            } else {
                                let _e1996 = (_e1995 + 1u);
                                phi_2974_ = select(_e1996, _e1958, (_e1958 < _e1996));
                            }
                            let _e2000 = phi_2974_;
                            let _e2001 = (_e1957 == 0u);
                            if _e2001 {
                                phi_2983_ = select(true, false, _e1986);
                            } else {
                                phi_2983_ = true;
                            }
                            let _e2004 = phi_2983_;
                            let _e2005 = select(_e1958, _e1995, _e2004);
                            if _e2001 {
                                if _e1986 {
                                    phi_2999_ = true;
                                } else {
                                    phi_2999_ = select(true, false, (_e2005 == _e1958));
                                }
                                let _e2009 = phi_2999_;
                                phi_3000_ = _e2009;
                            } else {
                                phi_3000_ = true;
                            }
                            let _e2011 = phi_3000_;
                            let _e2012 = select(0u, _e2000, _e2011);
                            let _e2013 = (_e1984 - _e1985);
                            let _e2016 = ((_e394 >> bitcast<u32>(30u)) & 3u);
                            let _e2017 = (_e1954 - 1u);
                            let _e2019 = select(1f, 2f, (_e2016 == 2u));
                            let _e2023 = (_e1949 - (floor((_e1949 / _e2019)) * _e2019));
                            if (_e2023 > 1f) {
                                phi_3023_ = (_e2019 - _e2023);
                            } else {
                                phi_3023_ = _e2023;
                            }
                            let _e2027 = phi_3023_;
                            if (_e2016 == 1u) {
                                let _e2030 = select(0f, _e1949, (_e1949 > 0f));
                                phi_3038_ = select(1f, _e2030, (_e2030 < 1f));
                            } else {
                                phi_3038_ = _e2027;
                            }
                            let _e2034 = phi_3038_;
                            if (_e2034 >= 0f) {
                                phi_3048_ = select(true, false, (_e2034 <= 1f));
                            } else {
                                phi_3048_ = true;
                            }
                            let _e2039 = phi_3048_;
                            let _e2043 = ((select(_e2034, 0f, _e2039) * f32(_e1954)) - 0.5f);
                            let _e2044 = floor(_e2043);
                            let _e2045 = (_e2044 < 0f);
                            if _e2045 {
                                phi_3073_ = 0u;
                            } else {
                                let _e2050 = select(select(u32(_e2044), 0u, (_e2044 < 0f)), 4294967295u, (_e2044 > 4294967000f));
                                phi_3073_ = select(_e2050, _e2017, (_e2017 < _e2050));
                            }
                            let _e2054 = phi_3073_;
                            if _e2045 {
                                phi_3083_ = 0u;
                            } else {
                                let _e2055 = (_e2054 + 1u);
                                phi_3083_ = select(_e2055, _e2017, (_e2017 < _e2055));
                            }
                            let _e2059 = phi_3083_;
                            let _e2060 = (_e2016 == 0u);
                            if _e2060 {
                                phi_3092_ = select(true, false, _e2045);
                            } else {
                                phi_3092_ = true;
                            }
                            let _e2063 = phi_3092_;
                            let _e2064 = select(_e2017, _e2054, _e2063);
                            if _e2060 {
                                if _e2045 {
                                    phi_3108_ = true;
                                } else {
                                    phi_3108_ = select(true, false, (_e2064 == _e2017));
                                }
                                let _e2068 = phi_3108_;
                                phi_3109_ = _e2068;
                            } else {
                                phi_3109_ = true;
                            }
                            let _e2070 = phi_3109_;
                            let _e2072 = (_e2043 - _e2044);
                            let _e2073 = (_e394 & 268435455u);
                            let _e2075 = (_e2073 + (_e2064 * _e1952));
                            let _e2077 = (_e2073 + (select(0u, _e2059, _e2070) * _e1952));
                            let _e2078 = (_e2075 + _e2005);
                            let _e2079 = (_e2075 + _e2012);
                            let _e2080 = (_e2077 + _e2005);
                            let _e2081 = (_e2077 + _e2012);
                            if (_e2078 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2085 = surfaces.member[_e2078];
                            if (_e2079 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2089 = surfaces.member[_e2079];
                            if (_e2080 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2093 = surfaces.member[_e2080];
                            if (_e2081 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2097 = surfaces.member[_e2081];
                            let _e2098 = (_e2085 & 255u);
                            if (_e2098 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2102 = surfaces.member[_e2098];
                            let _e2106 = ((_e2085 >> bitcast<u32>(8i)) & 255u);
                            if (_e2106 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2110 = surfaces.member[_e2106];
                            let _e2114 = ((_e2085 >> bitcast<u32>(16i)) & 255u);
                            if (_e2114 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2118 = surfaces.member[_e2114];
                            let _e2120 = (1f - _e2013);
                            let _e2124 = (_e2089 & 255u);
                            if (_e2124 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2128 = surfaces.member[_e2124];
                            let _e2132 = ((_e2089 >> bitcast<u32>(8i)) & 255u);
                            if (_e2132 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2136 = surfaces.member[_e2132];
                            let _e2140 = ((_e2089 >> bitcast<u32>(16i)) & 255u);
                            if (_e2140 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2144 = surfaces.member[_e2140];
                            let _e2152 = (_e2093 & 255u);
                            if (_e2152 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2156 = surfaces.member[_e2152];
                            let _e2160 = ((_e2093 >> bitcast<u32>(8i)) & 255u);
                            if (_e2160 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2164 = surfaces.member[_e2160];
                            let _e2168 = ((_e2093 >> bitcast<u32>(16i)) & 255u);
                            if (_e2168 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2172 = surfaces.member[_e2168];
                            let _e2177 = (_e2097 & 255u);
                            if (_e2177 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2181 = surfaces.member[_e2177];
                            let _e2185 = ((_e2097 >> bitcast<u32>(8i)) & 255u);
                            if (_e2185 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2189 = surfaces.member[_e2185];
                            let _e2193 = ((_e2097 >> bitcast<u32>(16i)) & 255u);
                            if (_e2193 < _e101) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2197 = surfaces.member[_e2193];
                            let _e2205 = (1f - _e2072);
                            phi_3332_ = type_30(vec3<f32>((_e377 * ((((bitcast<f32>(_e2102) * _e2120) + (bitcast<f32>(_e2128) * _e2013)) * _e2205) + (((bitcast<f32>(_e2156) * _e2120) + (bitcast<f32>(_e2181) * _e2013)) * _e2072))), (_e383 * ((((bitcast<f32>(_e2110) * _e2120) + (bitcast<f32>(_e2136) * _e2013)) * _e2205) + (((bitcast<f32>(_e2164) * _e2120) + (bitcast<f32>(_e2189) * _e2013)) * _e2072))), (_e389 * ((((bitcast<f32>(_e2118) * _e2120) + (bitcast<f32>(_e2144) * _e2013)) * _e2205) + (((bitcast<f32>(_e2172) * _e2120) + (bitcast<f32>(_e2197) * _e2013)) * _e2072)))), (_e423 * (((((f32((_e2085 >> bitcast<u32>(24i))) * 0.003921569f) * _e2120) + ((f32((_e2089 >> bitcast<u32>(24i))) * 0.003921569f) * _e2013)) * _e2205) + ((((f32((_e2093 >> bitcast<u32>(24i))) * 0.003921569f) * _e2120) + ((f32((_e2097 >> bitcast<u32>(24i))) * 0.003921569f) * _e2013)) * _e2072))));
                        }
                        let _e2248 = phi_3332_;
                        let _e2252 = local_34;
                        let _e2256 = attributes.member[_e2252].member_2[0u];
                        let _e2259 = local_35;
                        let _e2263 = attributes.member[_e2259].member_2[1u];
                        let _e2267 = local_36;
                        let _e2271 = attributes.member[_e2267].member_2[2u];
                        if (((_e2256 | _e2263) | _e2271) == 0u) {
                            phi_3439_ = vec3<f32>(1f, 1f, 1f);
                        } else {
                            let _e2287 = (1f - (f32((_e2256 & 1023u)) * 0.0009775171f));
                            let _e2288 = (1f - (f32(((_e2256 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                            let _e2289 = (1f - (f32(((_e2256 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                            let _e2309 = (1f - (f32((_e2263 & 1023u)) * 0.0009775171f));
                            let _e2310 = (1f - (f32(((_e2263 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                            let _e2311 = (1f - (f32(((_e2263 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                            let _e2334 = (1f - (f32((_e2271 & 1023u)) * 0.0009775171f));
                            let _e2335 = (1f - (f32(((_e2271 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                            let _e2336 = (1f - (f32(((_e2271 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                            phi_3439_ = vec3<f32>(((((_e2287 * _e2287) * _e1897) + ((_e2309 * _e2309) * _e1887)) + ((_e2334 * _e2334) * _e1895)), ((((_e2288 * _e2288) * _e1897) + ((_e2310 * _e2310) * _e1887)) + ((_e2335 * _e2335) * _e1895)), ((((_e2289 * _e2289) * _e1897) + ((_e2311 * _e2311) * _e1887)) + ((_e2336 * _e2336) * _e1895)));
                        }
                        let _e2348 = phi_3439_;
                        let _e2351 = (_e2248.member.x * _e2348.x);
                        let _e2354 = (_e2248.member.y * _e2348.y);
                        let _e2357 = (_e2248.member.z * _e2348.z);
                        if (_e223 == 2u) {
                            phi_3475_ = 2u;
                        } else {
                            phi_3475_ = (1u - _e223);
                        }
                        let _e2370 = phi_3475_;
                        if (_e2370 == 0u) {
                            phi_3487_ = vec3<f32>(_e1858, _e1863, _e1853);
                        } else {
                            if (_e2370 == 1u) {
                                phi_3486_ = vec3<f32>(_e1863, _e1853, _e1858);
                            } else {
                                phi_3486_ = vec3<f32>(_e1853, _e1858, _e1863);
                            }
                            let _e2375 = phi_3486_;
                            phi_3487_ = _e2375;
                        }
                        let _e2378 = phi_3487_;
                        let _e2382 = params.member.member_2[0u];
                        let _e2396 = (((_e2382.z + (_e1457 >> bitcast<u32>(2i))) + (_e2382.x * (_e1463 >> bitcast<u32>(2i)))) + (_e2382.y * (_e1469 >> bitcast<u32>(1i))));
                        let _e2419 = cells.member[((2u * _e2396) + 1u)];
                        phi_3522_ = type_12(0u, 6u);
                        phi_3525_ = _e2419;
                        loop {
                            let _e2421 = phi_3522_;
                            let _e2423 = phi_3525_;
                            local_37 = _e2423;
                            if (_e2421.member < _e2421.member_1) {
                                phi_3523_ = type_12((_e2421.member + 1u), _e2421.member_1);
                                phi_3548_ = type_12(1u, _e2421.member);
                            } else {
                                phi_3523_ = _e2421;
                                phi_3548_ = type_12(0u, type_12().member_1);
                            }
                            let _e2436 = phi_3523_;
                            let _e2438 = phi_3548_;
                            let _e2442 = (bitcast<i32>(_e2438.member) != 0i);
                            if _e2442 {
                                let _e2446 = facet_bits.member[((_e2396 * 6u) + _e2438.member_1)];
                                let _e2447 = ((((((_e1457 & 1u) | ((_e1463 & 1u) << bitcast<u32>(1i))) | ((_e1469 & 1u) << bitcast<u32>(2i))) | ((_e1457 & 2u) << bitcast<u32>(2i))) | ((_e1463 & 2u) << bitcast<u32>(3i))) & 31u);
                                let _e2453 = (_e2423 + countOneBits((_e2446 & ((1u << bitcast<u32>(_e2447)) - 1u))));
                                if (_e2438.member_1 < ((2u * _e341) + select(0u, 1u, (_e346 < 0f)))) {
                                    phi_3573_ = (_e2453 + ((_e2446 >> bitcast<u32>(_e2447)) & 1u));
                                } else {
                                    phi_3573_ = _e2453;
                                }
                                let _e2460 = phi_3573_;
                                phi_3526_ = _e2460;
                            } else {
                                phi_3526_ = u32();
                            }
                            let _e2462 = phi_3526_;
                            continue;
                            continuing {
                                phi_3522_ = _e2436;
                                phi_3525_ = _e2462;
                                break if !(_e2442);
                            }
                        }
                        let _e2466 = local_37;
                        let _e2467 = (_e2466 * 13u);
                        let _e2470 = params.member.member_7;
                        let _e2473 = floor((((select(_e1847, 0f, select(_e1817, true, _e1819)) * select(1f, 0f, (_e2248.member_1 < bitcast<f32>(_e428)))) * _e2470) + 0.5f));
                        let _e2475 = select(_e2473, 1f, (_e2473 < 1f));
                        let _e2480 = select(select(u32(_e2475), 0u, (_e2475 < 0f)), 4294967295u, (_e2475 > 4294967000f));
                        if (_e2467 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2484 = atomicAdd((&sums.member[_e2467]), _e2480);
                        if (_e2484 >= (2147483648u - select(_e2480, 2147483648u, (2147483648u < _e2480)))) {
                            let _e2491 = params.member.member_5;
                            let _e2492 = (_e2491 * 13u);
                            if (_e2492 < _e105) {
                            } else {
                                phi_5195_ = true;
                                break;
                            }
                            let _e2496 = atomicOr((&sums.member[_e2492]), 1u);
                        }
                        let _e2497 = (_e2467 + 1u);
                        let _e2505 = floor(((_e364.x * _e2475) + 0.5f));
                        if (_e2497 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2517 = atomicAdd((&sums.member[_e2497]), bitcast<u32>(select(0i, select(select(i32(_e2505), i32(-2147483648), (_e2505 < -2147483600f)), 2147483647i, (_e2505 > 2147483500f)), (_e2505 == _e2505))));
                        let _e2518 = (_e2467 + 2u);
                        let _e2520 = floor(((_e364.y * _e2475) + 0.5f));
                        if (_e2518 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2532 = atomicAdd((&sums.member[_e2518]), bitcast<u32>(select(0i, select(select(i32(_e2520), i32(-2147483648), (_e2520 < -2147483600f)), 2147483647i, (_e2520 > 2147483500f)), (_e2520 == _e2520))));
                        let _e2533 = (_e2467 + 3u);
                        let _e2535 = floor(((_e364.z * _e2475) + 0.5f));
                        if (_e2533 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2547 = atomicAdd((&sums.member[_e2533]), bitcast<u32>(select(0i, select(select(i32(_e2535), i32(-2147483648), (_e2535 < -2147483600f)), 2147483647i, (_e2535 > 2147483500f)), (_e2535 == _e2535))));
                        let _e2548 = (_e2467 + 4u);
                        let _e2556 = floor(((_e2378.x * _e2475) + 0.5f));
                        if (_e2548 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2568 = atomicAdd((&sums.member[_e2548]), bitcast<u32>(select(0i, select(select(i32(_e2556), i32(-2147483648), (_e2556 < -2147483600f)), 2147483647i, (_e2556 > 2147483500f)), (_e2556 == _e2556))));
                        let _e2569 = (_e2467 + 5u);
                        let _e2571 = floor(((_e2378.y * _e2475) + 0.5f));
                        if (_e2569 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2583 = atomicAdd((&sums.member[_e2569]), bitcast<u32>(select(0i, select(select(i32(_e2571), i32(-2147483648), (_e2571 < -2147483600f)), 2147483647i, (_e2571 > 2147483500f)), (_e2571 == _e2571))));
                        let _e2584 = (_e2467 + 6u);
                        let _e2586 = floor(((_e2378.z * _e2475) + 0.5f));
                        if (_e2584 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2598 = atomicAdd((&sums.member[_e2584]), bitcast<u32>(select(0i, select(select(i32(_e2586), i32(-2147483648), (_e2586 < -2147483600f)), 2147483647i, (_e2586 > 2147483500f)), (_e2586 == _e2586))));
                        let _e2599 = (_e2467 + 7u);
                        let _e2604 = floor(((select(1f, _e2351, (_e2351 < 1f)) * _e2475) + 0.5f));
                        if (_e2599 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2616 = atomicAdd((&sums.member[_e2599]), bitcast<u32>(select(0i, select(select(i32(_e2604), i32(-2147483648), (_e2604 < -2147483600f)), 2147483647i, (_e2604 > 2147483500f)), (_e2604 == _e2604))));
                        let _e2617 = (_e2467 + 8u);
                        let _e2619 = floor(((select(1f, _e2354, (_e2354 < 1f)) * _e2475) + 0.5f));
                        if (_e2617 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2631 = atomicAdd((&sums.member[_e2617]), bitcast<u32>(select(0i, select(select(i32(_e2619), i32(-2147483648), (_e2619 < -2147483600f)), 2147483647i, (_e2619 > 2147483500f)), (_e2619 == _e2619))));
                        let _e2632 = (_e2467 + 9u);
                        let _e2634 = floor(((select(1f, _e2357, (_e2357 < 1f)) * _e2475) + 0.5f));
                        if (_e2632 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2646 = atomicAdd((&sums.member[_e2632]), bitcast<u32>(select(0i, select(select(i32(_e2634), i32(-2147483648), (_e2634 < -2147483600f)), 2147483647i, (_e2634 > 2147483500f)), (_e2634 == _e2634))));
                        let _e2647 = (_e2467 + 10u);
                        let _e2650 = params.member.member_8;
                        let _e2651 = (_e2475 / _e2650);
                        let _e2656 = floor(((bitcast<f32>(_e399) * _e2651) + 0.5f));
                        if (_e2647 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2668 = atomicAdd((&sums.member[_e2647]), bitcast<u32>(select(0i, select(select(i32(_e2656), i32(-2147483648), (_e2656 < -2147483600f)), 2147483647i, (_e2656 > 2147483500f)), (_e2656 == _e2656))));
                        let _e2669 = (_e2467 + 11u);
                        let _e2671 = floor(((bitcast<f32>(_e405) * _e2651) + 0.5f));
                        if (_e2669 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2683 = atomicAdd((&sums.member[_e2669]), bitcast<u32>(select(0i, select(select(i32(_e2671), i32(-2147483648), (_e2671 < -2147483600f)), 2147483647i, (_e2671 > 2147483500f)), (_e2671 == _e2671))));
                        let _e2684 = (_e2467 + 12u);
                        let _e2686 = floor(((bitcast<f32>(_e411) * _e2651) + 0.5f));
                        if (_e2684 < _e105) {
                        } else {
                            phi_5195_ = true;
                            break;
                        }
                        let _e2698 = atomicAdd((&sums.member[_e2684]), bitcast<u32>(select(0i, select(select(i32(_e2686), i32(-2147483648), (_e2686 < -2147483600f)), 2147483647i, (_e2686 > 2147483500f)), (_e2686 == _e2686))));
                        phi_5196_ = _e1798;
                    } else {
                        phi_5196_ = _e640;
                    }
                    let _e2700 = phi_5196_;
                    continue;
                    continuing {
                        phi_4967_ = _e2700;
                        let _e2741 = local_38;
                        phi_4583_ = _e2741;
                        let _e2744 = local_39;
                        phi_4580_ = _e2744;
                        let _e2747 = local_40;
                        phi_4577_ = _e2747;
                        let _e2750 = local_41;
                        phi_4574_ = _e2750;
                        phi_5195_ = _e2700;
                        break if !(_e1429);
                    }
                }
                let _e2703 = phi_5195_;
                if _e2703 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_accumulate(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
