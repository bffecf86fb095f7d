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
    var phi_4555_: bool;
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
    var phi_3920_: bool;
    var phi_3959_: bool;
    var phi_3998_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1398_: type_39;
    var phi_4953_: bool;
    var phi_4569_: i32;
    var phi_4566_: i32;
    var phi_4563_: i32;
    var phi_4560_: i32;
    var phi_4568_: i32;
    var phi_4565_: i32;
    var phi_4562_: i32;
    var phi_4559_: i32;
    var phi_4561_: i32;
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
    var phi_4859_: i32;
    var phi_2057_: bool;
    var local_9: bool;
    var phi_4718_: i32;
    var phi_2110_: vec3<f32>;
    var phi_2111_: vec3<f32>;
    var phi_4048_: type_33;
    var phi_4051_: type_33;
    var phi_4052_: bool;
    var phi_4057_: type_33;
    var phi_4059_: type_33;
    var phi_4095_: type_33;
    var phi_4098_: type_33;
    var phi_4099_: bool;
    var phi_4104_: type_33;
    var phi_4106_: type_33;
    var phi_4154_: type_33;
    var phi_4203_: type_33;
    var phi_4206_: type_33;
    var phi_4207_: bool;
    var phi_4212_: type_33;
    var phi_4214_: type_33;
    var phi_4250_: type_33;
    var phi_4253_: type_33;
    var phi_4254_: bool;
    var phi_4259_: type_33;
    var phi_4261_: type_33;
    var phi_4309_: type_33;
    var phi_4358_: type_33;
    var phi_4361_: type_33;
    var phi_4362_: bool;
    var phi_4367_: type_33;
    var phi_4369_: type_33;
    var phi_4405_: type_33;
    var phi_4408_: type_33;
    var phi_4409_: bool;
    var phi_4414_: type_33;
    var phi_4416_: type_33;
    var phi_4464_: type_33;
    var phi_2153_: type_33;
    var phi_5462_: i32;
    var phi_4858_: i32;
    var phi_4834_: i32;
    var phi_4804_: i32;
    var phi_5461_: i32;
    var phi_4857_: i32;
    var phi_4833_: i32;
    var phi_4803_: i32;
    var phi_2193_: bool;
    var local_10: bool;
    var local_11: i32;
    var local_12: i32;
    var local_13: i32;
    var phi_2223_: u32;
    var phi_2234_: vec3<f32>;
    var phi_2235_: vec3<f32>;
    var phi_4945_: bool;
    var phi_2291_: type_12;
    var phi_2292_: type_12;
    var phi_2315_: type_12;
    var phi_2327_: type_12;
    var phi_2330_: f32;
    var phi_2328_: type_12;
    var phi_2353_: type_12;
    var phi_2388_: f32;
    var phi_2331_: f32;
    var phi_4940_: bool;
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
    var phi_5155_: bool;
    var local_15: u32;
    var phi_5172_: bool;
    var phi_5171_: bool;
    var phi_5170_: bool;
    var phi_5169_: bool;
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
    var phi_5173_: bool;
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
    var phi_2957_: u32;
    var phi_2967_: u32;
    var phi_2976_: bool;
    var phi_2992_: bool;
    var phi_2993_: bool;
    var phi_3016_: f32;
    var phi_3031_: f32;
    var phi_3059_: u32;
    var phi_3069_: u32;
    var phi_3078_: bool;
    var phi_3094_: bool;
    var phi_3095_: bool;
    var phi_3318_: type_30;
    var local_34: u32;
    var local_35: u32;
    var local_36: u32;
    var phi_3425_: vec3<f32>;
    var phi_3461_: u32;
    var phi_3472_: vec3<f32>;
    var phi_3473_: vec3<f32>;
    var phi_3508_: type_12;
    var phi_3511_: u32;
    var phi_3509_: type_12;
    var phi_3534_: type_12;
    var phi_3559_: u32;
    var phi_3512_: u32;
    var local_37: u32;
    var phi_5182_: bool;
    var phi_5181_: bool;
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
                            phi_4555_ = true;
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
                        phi_4555_ = false;
                        break if !(_e121);
                    }
                }
                let _e137 = phi_4555_;
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
                    phi_3920_ = true;
                } else {
                    phi_3920_ = (select(_e556, _e553, (_e553 > _e556)) < (_e559 * -0.5f));
                }
                let _e569 = phi_3920_;
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
                        phi_3959_ = true;
                    } else {
                        phi_3959_ = (select(_e577, _e574, (_e574 > _e577)) < (_e580 * -0.5f));
                    }
                    let _e590 = phi_3959_;
                    if _e590 {
                        phi_1387_ = bool();
                    } else {
                        let _e591 = (_e539 - _e547);
                        let _e592 = (_e540 - _e548);
                        let _e595 = ((_e591 * _e548) - (_e592 * _e547));
                        let _e598 = ((_e591 * _e544) - (_e592 * _e543));
                        let _e601 = (abs(_e591) + abs(_e592));
                        if (select(_e598, _e595, (_e595 < _e598)) > (0.5f * _e601)) {
                            phi_3998_ = true;
                        } else {
                            phi_3998_ = (select(_e598, _e595, (_e595 > _e598)) < (_e601 * -0.5f));
                        }
                        let _e611 = phi_3998_;
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
                phi_4953_ = _e137;
                phi_4569_ = _e621.member_6;
                phi_4566_ = _e621.member_9;
                phi_4563_ = _e621.member_8;
                phi_4560_ = _e621.member_7;
                loop {
                    let _e640 = phi_4953_;
                    let _e642 = phi_4569_;
                    let _e644 = phi_4566_;
                    let _e646 = phi_4563_;
                    let _e648 = phi_4560_;
                    phi_4568_ = _e642;
                    phi_4565_ = _e644;
                    phi_4562_ = _e646;
                    phi_4559_ = _e648;
                    loop {
                        let _e650 = phi_4568_;
                        let _e652 = phi_4565_;
                        let _e654 = phi_4562_;
                        let _e656 = phi_4559_;
                        let _e657 = (_e656 < _e621.member_3);
                        if _e657 {
                            phi_4561_ = _e654;
                            loop {
                                let _e659 = phi_4561_;
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
                                    phi_4859_ = _e661;
                                    phi_2057_ = select(true, false, select(_e1050, false, select(_e1054, true, _e1052)));
                                } else {
                                    phi_4859_ = _e659;
                                    phi_2057_ = false;
                                }
                                let _e1059 = phi_4859_;
                                let _e1061 = phi_2057_;
                                let _e1062 = select(true, false, _e660);
                                local_9 = _e1062;
                                local_42 = _e1059;
                                local_43 = _e1062;
                                continue;
                                continuing {
                                    phi_4561_ = _e1059;
                                    break if !(_e1061);
                                }
                            }
                            let _e1065 = local_9;
                            if _e1065 {
                                let _e1066 = (_e650 + 1i);
                                let _e1067 = (_e1066 >= _e621.member_2);
                                if _e1067 {
                                    phi_4718_ = (_e656 + 1i);
                                } else {
                                    phi_4718_ = _e656;
                                }
                                let _e1070 = phi_4718_;
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
                                                phi_4048_ = type_33(0f, 1f);
                                            } else {
                                                phi_4048_ = type_33();
                                            }
                                            let _e1142 = phi_4048_;
                                            phi_4051_ = _e1142;
                                            phi_4052_ = select(true, false, _e1140);
                                        } else {
                                            phi_4051_ = type_33();
                                            phi_4052_ = true;
                                        }
                                        let _e1145 = phi_4051_;
                                        let _e1147 = phi_4052_;
                                        if _e1147 {
                                            phi_4057_ = type_33(1f, 0f);
                                        } else {
                                            phi_4057_ = _e1145;
                                        }
                                        let _e1149 = phi_4057_;
                                        phi_4059_ = _e1149;
                                    } else {
                                        let _e1132 = (_e1127 / _e1118);
                                        let _e1133 = (_e1129 / _e1118);
                                        phi_4059_ = type_33(select(_e1133, _e1132, (_e1132 < _e1133)), select(_e1133, _e1132, (_e1132 > _e1133)));
                                    }
                                    let _e1151 = phi_4059_;
                                    let _e1154 = f32(_e1070);
                                    let _e1155 = (_e1154 - 0.01f);
                                    let _e1156 = (_e1155 - _e621.member.member.y);
                                    let _e1157 = (_e1154 + 1.01f);
                                    let _e1158 = (_e1157 - _e621.member.member.y);
                                    if (abs(_e1121) < 0.000001f) {
                                        if (_e1156 <= 0f) {
                                            let _e1169 = (_e1158 >= 0f);
                                            if _e1169 {
                                                phi_4095_ = type_33(0f, 1f);
                                            } else {
                                                phi_4095_ = type_33();
                                            }
                                            let _e1171 = phi_4095_;
                                            phi_4098_ = _e1171;
                                            phi_4099_ = select(true, false, _e1169);
                                        } else {
                                            phi_4098_ = type_33();
                                            phi_4099_ = true;
                                        }
                                        let _e1174 = phi_4098_;
                                        let _e1176 = phi_4099_;
                                        if _e1176 {
                                            phi_4104_ = type_33(1f, 0f);
                                        } else {
                                            phi_4104_ = _e1174;
                                        }
                                        let _e1178 = phi_4104_;
                                        phi_4106_ = _e1178;
                                    } else {
                                        let _e1161 = (_e1156 / _e1121);
                                        let _e1162 = (_e1158 / _e1121);
                                        phi_4106_ = type_33(select(_e1162, _e1161, (_e1161 < _e1162)), select(_e1162, _e1161, (_e1161 > _e1162)));
                                    }
                                    let _e1180 = phi_4106_;
                                    let _e1184 = select(_e1180.member, _e1151.member, (_e1151.member > _e1180.member));
                                    let _e1186 = select(0f, _e1184, (_e1184 > 0f));
                                    let _e1188 = select(_e1180.member_1, _e1151.member_1, (_e1151.member_1 < _e1180.member_1));
                                    let _e1190 = select(1f, _e1188, (_e1188 < 1f));
                                    if (_e1186 > _e1190) {
                                        phi_4154_ = type_33(_e621.member.member_5.z, -2f);
                                    } else {
                                        let _e1193 = (_e621.member.member.z + (_e1124 * _e1186));
                                        let _e1195 = (_e621.member.member.z + (_e1124 * _e1190));
                                        phi_4154_ = type_33(select(_e1195, _e1193, (_e1193 < _e1195)), select(_e1195, _e1193, (_e1193 > _e1195)));
                                    }
                                    let _e1204 = phi_4154_;
                                    let _e1208 = (_e621.member.member_2.x - _e621.member.member_1.x);
                                    let _e1210 = (_e621.member.member_2.y - _e621.member.member_1.y);
                                    let _e1212 = (_e621.member.member_2.z - _e621.member.member_1.z);
                                    let _e1213 = (_e1126 - _e621.member.member_1.x);
                                    let _e1214 = (_e1128 - _e621.member.member_1.x);
                                    if (abs(_e1208) < 0.000001f) {
                                        if (_e1213 <= 0f) {
                                            let _e1225 = (_e1214 >= 0f);
                                            if _e1225 {
                                                phi_4203_ = type_33(0f, 1f);
                                            } else {
                                                phi_4203_ = type_33();
                                            }
                                            let _e1227 = phi_4203_;
                                            phi_4206_ = _e1227;
                                            phi_4207_ = select(true, false, _e1225);
                                        } else {
                                            phi_4206_ = type_33();
                                            phi_4207_ = true;
                                        }
                                        let _e1230 = phi_4206_;
                                        let _e1232 = phi_4207_;
                                        if _e1232 {
                                            phi_4212_ = type_33(1f, 0f);
                                        } else {
                                            phi_4212_ = _e1230;
                                        }
                                        let _e1234 = phi_4212_;
                                        phi_4214_ = _e1234;
                                    } else {
                                        let _e1217 = (_e1213 / _e1208);
                                        let _e1218 = (_e1214 / _e1208);
                                        phi_4214_ = type_33(select(_e1218, _e1217, (_e1217 < _e1218)), select(_e1218, _e1217, (_e1217 > _e1218)));
                                    }
                                    let _e1236 = phi_4214_;
                                    let _e1239 = (_e1155 - _e621.member.member_1.y);
                                    let _e1240 = (_e1157 - _e621.member.member_1.y);
                                    if (abs(_e1210) < 0.000001f) {
                                        if (_e1239 <= 0f) {
                                            let _e1251 = (_e1240 >= 0f);
                                            if _e1251 {
                                                phi_4250_ = type_33(0f, 1f);
                                            } else {
                                                phi_4250_ = type_33();
                                            }
                                            let _e1253 = phi_4250_;
                                            phi_4253_ = _e1253;
                                            phi_4254_ = select(true, false, _e1251);
                                        } else {
                                            phi_4253_ = type_33();
                                            phi_4254_ = true;
                                        }
                                        let _e1256 = phi_4253_;
                                        let _e1258 = phi_4254_;
                                        if _e1258 {
                                            phi_4259_ = type_33(1f, 0f);
                                        } else {
                                            phi_4259_ = _e1256;
                                        }
                                        let _e1260 = phi_4259_;
                                        phi_4261_ = _e1260;
                                    } else {
                                        let _e1243 = (_e1239 / _e1210);
                                        let _e1244 = (_e1240 / _e1210);
                                        phi_4261_ = type_33(select(_e1244, _e1243, (_e1243 < _e1244)), select(_e1244, _e1243, (_e1243 > _e1244)));
                                    }
                                    let _e1262 = phi_4261_;
                                    let _e1266 = select(_e1262.member, _e1236.member, (_e1236.member > _e1262.member));
                                    let _e1268 = select(0f, _e1266, (_e1266 > 0f));
                                    let _e1270 = select(_e1262.member_1, _e1236.member_1, (_e1236.member_1 < _e1262.member_1));
                                    let _e1272 = select(1f, _e1270, (_e1270 < 1f));
                                    if (_e1268 > _e1272) {
                                        phi_4309_ = type_33(_e621.member.member_5.z, -2f);
                                    } else {
                                        let _e1275 = (_e621.member.member_1.z + (_e1212 * _e1268));
                                        let _e1277 = (_e621.member.member_1.z + (_e1212 * _e1272));
                                        phi_4309_ = type_33(select(_e1277, _e1275, (_e1275 < _e1277)), select(_e1277, _e1275, (_e1275 > _e1277)));
                                    }
                                    let _e1286 = phi_4309_;
                                    let _e1289 = (_e621.member.member.x - _e621.member.member_2.x);
                                    let _e1290 = (_e621.member.member.y - _e621.member.member_2.y);
                                    let _e1291 = (_e621.member.member.z - _e621.member.member_2.z);
                                    let _e1292 = (_e1126 - _e621.member.member_2.x);
                                    let _e1293 = (_e1128 - _e621.member.member_2.x);
                                    if (abs(_e1289) < 0.000001f) {
                                        if (_e1292 <= 0f) {
                                            let _e1304 = (_e1293 >= 0f);
                                            if _e1304 {
                                                phi_4358_ = type_33(0f, 1f);
                                            } else {
                                                phi_4358_ = type_33();
                                            }
                                            let _e1306 = phi_4358_;
                                            phi_4361_ = _e1306;
                                            phi_4362_ = select(true, false, _e1304);
                                        } else {
                                            phi_4361_ = type_33();
                                            phi_4362_ = true;
                                        }
                                        let _e1309 = phi_4361_;
                                        let _e1311 = phi_4362_;
                                        if _e1311 {
                                            phi_4367_ = type_33(1f, 0f);
                                        } else {
                                            phi_4367_ = _e1309;
                                        }
                                        let _e1313 = phi_4367_;
                                        phi_4369_ = _e1313;
                                    } else {
                                        let _e1296 = (_e1292 / _e1289);
                                        let _e1297 = (_e1293 / _e1289);
                                        phi_4369_ = type_33(select(_e1297, _e1296, (_e1296 < _e1297)), select(_e1297, _e1296, (_e1296 > _e1297)));
                                    }
                                    let _e1315 = phi_4369_;
                                    let _e1318 = (_e1155 - _e621.member.member_2.y);
                                    let _e1319 = (_e1157 - _e621.member.member_2.y);
                                    if (abs(_e1290) < 0.000001f) {
                                        if (_e1318 <= 0f) {
                                            let _e1330 = (_e1319 >= 0f);
                                            if _e1330 {
                                                phi_4405_ = type_33(0f, 1f);
                                            } else {
                                                phi_4405_ = type_33();
                                            }
                                            let _e1332 = phi_4405_;
                                            phi_4408_ = _e1332;
                                            phi_4409_ = select(true, false, _e1330);
                                        } else {
                                            phi_4408_ = type_33();
                                            phi_4409_ = true;
                                        }
                                        let _e1335 = phi_4408_;
                                        let _e1337 = phi_4409_;
                                        if _e1337 {
                                            phi_4414_ = type_33(1f, 0f);
                                        } else {
                                            phi_4414_ = _e1335;
                                        }
                                        let _e1339 = phi_4414_;
                                        phi_4416_ = _e1339;
                                    } else {
                                        let _e1322 = (_e1318 / _e1290);
                                        let _e1323 = (_e1319 / _e1290);
                                        phi_4416_ = type_33(select(_e1323, _e1322, (_e1322 < _e1323)), select(_e1323, _e1322, (_e1322 > _e1323)));
                                    }
                                    let _e1341 = phi_4416_;
                                    let _e1345 = select(_e1341.member, _e1315.member, (_e1315.member > _e1341.member));
                                    let _e1347 = select(0f, _e1345, (_e1345 > 0f));
                                    let _e1349 = select(_e1341.member_1, _e1315.member_1, (_e1315.member_1 < _e1341.member_1));
                                    let _e1351 = select(1f, _e1349, (_e1349 < 1f));
                                    if (_e1347 > _e1351) {
                                        phi_4464_ = type_33(_e621.member.member_5.z, -2f);
                                    } else {
                                        let _e1354 = (_e621.member.member_2.z + (_e1291 * _e1347));
                                        let _e1356 = (_e621.member.member_2.z + (_e1291 * _e1351));
                                        phi_4464_ = type_33(select(_e1356, _e1354, (_e1354 < _e1356)), select(_e1356, _e1354, (_e1354 > _e1356)));
                                    }
                                    let _e1365 = phi_4464_;
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
                                phi_5462_ = select(0i, select(select(i32(_e1398), i32(-2147483648), (_e1398 < -2147483600f)), 2147483647i, (_e1398 > 2147483500f)), (_e1398 == _e1398));
                                phi_4858_ = (select(0i, select(select(i32(_e1387), i32(-2147483648), (_e1387 < -2147483600f)), 2147483647i, (_e1387 > 2147483500f)), (_e1387 == _e1387)) - 1i);
                                phi_4834_ = _e1070;
                                phi_4804_ = _e1071;
                            } else {
                                phi_5462_ = _e652;
                                let _e2840 = local_42;
                                phi_4858_ = _e2840;
                                phi_4834_ = _e656;
                                phi_4804_ = _e650;
                            }
                            let _e1407 = phi_5462_;
                            let _e1409 = phi_4858_;
                            let _e1411 = phi_4834_;
                            let _e1413 = phi_4804_;
                            phi_5461_ = _e1407;
                            phi_4857_ = _e1409;
                            phi_4833_ = _e1411;
                            phi_4803_ = _e1413;
                            let _e2849 = local_43;
                            phi_2193_ = _e2849;
                        } else {
                            phi_5461_ = _e652;
                            phi_4857_ = _e654;
                            phi_4833_ = _e656;
                            phi_4803_ = _e650;
                            phi_2193_ = false;
                        }
                        let _e1415 = phi_5461_;
                        let _e1417 = phi_4857_;
                        let _e1419 = phi_4833_;
                        let _e1421 = phi_4803_;
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
                            phi_4568_ = _e1421;
                            phi_4565_ = _e1415;
                            phi_4562_ = _e1417;
                            phi_4559_ = _e1419;
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
                        phi_4945_ = _e640;
                        phi_2291_ = type_12(0u, 6u);
                        loop {
                            let _e1477 = phi_4945_;
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
                                            phi_4940_ = true;
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
                                        phi_4940_ = _e1477;
                                        break if !(_e1523);
                                    }
                                }
                                let _e1548 = phi_4940_;
                                phi_5169_ = _e1548;
                                if _e1548 {
                                    break;
                                }
                                let _e1550 = local_14;
                                if (_e1550 >= 0f) {
                                    phi_5171_ = _e1548;
                                } else {
                                    let _e1552 = local_1.member_1;
                                    if (_e1552 == 0u) {
                                        phi_5172_ = _e1548;
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
                                            phi_5169_ = true;
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
                                                    phi_5155_ = true;
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
                                                            phi_5155_ = true;
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
                                                            phi_5155_ = true;
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
                                                phi_5155_ = _e1548;
                                                break if !(_e1612);
                                            }
                                        }
                                        let _e1664 = phi_5155_;
                                        phi_5169_ = _e1664;
                                        if _e1664 {
                                            break;
                                        }
                                        let _e1665 = local;
                                        local_1.member = _e1665;
                                        let _e1667 = local_15;
                                        local_1.member_1 = _e1667;
                                        phi_5172_ = _e1664;
                                    }
                                    let _e1669 = phi_5172_;
                                    phi_5171_ = _e1669;
                                }
                                let _e1671 = phi_5171_;
                                phi_5170_ = _e1671;
                            } else {
                                phi_5170_ = _e1477;
                            }
                            let _e1673 = phi_5170_;
                            continue;
                            continuing {
                                phi_4945_ = _e1673;
                                phi_2291_ = _e1492;
                                phi_5169_ = _e1673;
                                break if !(_e1498);
                            }
                        }
                        let _e1676 = phi_5169_;
                        phi_5181_ = _e1676;
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
                                    phi_5173_ = true;
                                    break;
                                }
                                let _e1719 = local_1.member[_e1711.member_1];
                                let _e1729 = (_e1711.member_1 + 1u);
                                let _e1730 = local_1.member_1;
                                if (_e1729 < _e1730) {
                                    if (_e1729 < 10u) {
                                    } else {
                                        phi_5173_ = true;
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
                                phi_5173_ = _e1676;
                                break if !(_e1715);
                            }
                        }
                        let _e1798 = phi_5173_;
                        phi_5181_ = _e1798;
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
                            phi_5181_ = true;
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
                            phi_3318_ = type_30(vec3<f32>(_e377, _e383, _e389), _e423);
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
                            let _e1982 = ((select(0f, _e1975, (abs((_e1975 - 0.5f)) <= 0.5f)) * f32(_e1952)) - 0.5f);
                            let _e1983 = floor(_e1982);
                            let _e1984 = (_e1983 < 0f);
                            if _e1984 {
                                phi_2957_ = 0u;
                            } else {
                                let _e1989 = select(select(u32(_e1983), 0u, (_e1983 < 0f)), 4294967295u, (_e1983 > 4294967000f));
                                phi_2957_ = select(_e1989, _e1958, (_e1958 < _e1989));
                            }
                            let _e1993 = phi_2957_;
                            if _e1984 {
                                phi_2967_ = 0u;
                            } else {
                                let _e1994 = (_e1993 + 1u);
                                phi_2967_ = select(_e1994, _e1958, (_e1958 < _e1994));
                            }
                            let _e1998 = phi_2967_;
                            let _e1999 = (_e1957 == 0u);
                            if _e1999 {
                                phi_2976_ = select(true, false, _e1984);
                            } else {
                                phi_2976_ = true;
                            }
                            let _e2002 = phi_2976_;
                            let _e2003 = select(_e1958, _e1993, _e2002);
                            if _e1999 {
                                if _e1984 {
                                    phi_2992_ = true;
                                } else {
                                    phi_2992_ = select(true, false, (_e2003 == _e1958));
                                }
                                let _e2007 = phi_2992_;
                                phi_2993_ = _e2007;
                            } else {
                                phi_2993_ = true;
                            }
                            let _e2009 = phi_2993_;
                            let _e2010 = select(0u, _e1998, _e2009);
                            let _e2011 = (_e1982 - _e1983);
                            let _e2014 = ((_e394 >> bitcast<u32>(30u)) & 3u);
                            let _e2015 = (_e1954 - 1u);
                            let _e2017 = select(1f, 2f, (_e2014 == 2u));
                            let _e2021 = (_e1949 - (floor((_e1949 / _e2017)) * _e2017));
                            if (_e2021 > 1f) {
                                phi_3016_ = (_e2017 - _e2021);
                            } else {
                                phi_3016_ = _e2021;
                            }
                            let _e2025 = phi_3016_;
                            if (_e2014 == 1u) {
                                let _e2028 = select(0f, _e1949, (_e1949 > 0f));
                                phi_3031_ = select(1f, _e2028, (_e2028 < 1f));
                            } else {
                                phi_3031_ = _e2025;
                            }
                            let _e2032 = phi_3031_;
                            let _e2039 = ((select(0f, _e2032, (abs((_e2032 - 0.5f)) <= 0.5f)) * f32(_e1954)) - 0.5f);
                            let _e2040 = floor(_e2039);
                            let _e2041 = (_e2040 < 0f);
                            if _e2041 {
                                phi_3059_ = 0u;
                            } else {
                                let _e2046 = select(select(u32(_e2040), 0u, (_e2040 < 0f)), 4294967295u, (_e2040 > 4294967000f));
                                phi_3059_ = select(_e2046, _e2015, (_e2015 < _e2046));
                            }
                            let _e2050 = phi_3059_;
                            if _e2041 {
                                phi_3069_ = 0u;
                            } else {
                                let _e2051 = (_e2050 + 1u);
                                phi_3069_ = select(_e2051, _e2015, (_e2015 < _e2051));
                            }
                            let _e2055 = phi_3069_;
                            let _e2056 = (_e2014 == 0u);
                            if _e2056 {
                                phi_3078_ = select(true, false, _e2041);
                            } else {
                                phi_3078_ = true;
                            }
                            let _e2059 = phi_3078_;
                            let _e2060 = select(_e2015, _e2050, _e2059);
                            if _e2056 {
                                if _e2041 {
                                    phi_3094_ = true;
                                } else {
                                    phi_3094_ = select(true, false, (_e2060 == _e2015));
                                }
                                let _e2064 = phi_3094_;
                                phi_3095_ = _e2064;
                            } else {
                                phi_3095_ = true;
                            }
                            let _e2066 = phi_3095_;
                            let _e2068 = (_e2039 - _e2040);
                            let _e2069 = (_e394 & 268435455u);
                            let _e2071 = (_e2069 + (_e2060 * _e1952));
                            let _e2073 = (_e2069 + (select(0u, _e2055, _e2066) * _e1952));
                            let _e2074 = (_e2071 + _e2003);
                            let _e2075 = (_e2071 + _e2010);
                            let _e2076 = (_e2073 + _e2003);
                            let _e2077 = (_e2073 + _e2010);
                            if (_e2074 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2081 = surfaces.member[_e2074];
                            if (_e2075 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2085 = surfaces.member[_e2075];
                            if (_e2076 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2089 = surfaces.member[_e2076];
                            if (_e2077 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2093 = surfaces.member[_e2077];
                            let _e2094 = (_e2081 & 255u);
                            if (_e2094 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2098 = surfaces.member[_e2094];
                            let _e2102 = ((_e2081 >> bitcast<u32>(8i)) & 255u);
                            if (_e2102 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2106 = surfaces.member[_e2102];
                            let _e2110 = ((_e2081 >> bitcast<u32>(16i)) & 255u);
                            if (_e2110 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2114 = surfaces.member[_e2110];
                            let _e2116 = (1f - _e2011);
                            let _e2120 = (_e2085 & 255u);
                            if (_e2120 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2124 = surfaces.member[_e2120];
                            let _e2128 = ((_e2085 >> bitcast<u32>(8i)) & 255u);
                            if (_e2128 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2132 = surfaces.member[_e2128];
                            let _e2136 = ((_e2085 >> bitcast<u32>(16i)) & 255u);
                            if (_e2136 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2140 = surfaces.member[_e2136];
                            let _e2148 = (_e2089 & 255u);
                            if (_e2148 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2152 = surfaces.member[_e2148];
                            let _e2156 = ((_e2089 >> bitcast<u32>(8i)) & 255u);
                            if (_e2156 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2160 = surfaces.member[_e2156];
                            let _e2164 = ((_e2089 >> bitcast<u32>(16i)) & 255u);
                            if (_e2164 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2168 = surfaces.member[_e2164];
                            let _e2173 = (_e2093 & 255u);
                            if (_e2173 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2177 = surfaces.member[_e2173];
                            let _e2181 = ((_e2093 >> bitcast<u32>(8i)) & 255u);
                            if (_e2181 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2185 = surfaces.member[_e2181];
                            let _e2189 = ((_e2093 >> bitcast<u32>(16i)) & 255u);
                            if (_e2189 < _e101) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2193 = surfaces.member[_e2189];
                            let _e2201 = (1f - _e2068);
                            phi_3318_ = type_30(vec3<f32>((_e377 * ((((bitcast<f32>(_e2098) * _e2116) + (bitcast<f32>(_e2124) * _e2011)) * _e2201) + (((bitcast<f32>(_e2152) * _e2116) + (bitcast<f32>(_e2177) * _e2011)) * _e2068))), (_e383 * ((((bitcast<f32>(_e2106) * _e2116) + (bitcast<f32>(_e2132) * _e2011)) * _e2201) + (((bitcast<f32>(_e2160) * _e2116) + (bitcast<f32>(_e2185) * _e2011)) * _e2068))), (_e389 * ((((bitcast<f32>(_e2114) * _e2116) + (bitcast<f32>(_e2140) * _e2011)) * _e2201) + (((bitcast<f32>(_e2168) * _e2116) + (bitcast<f32>(_e2193) * _e2011)) * _e2068)))), (_e423 * (((((f32((_e2081 >> bitcast<u32>(24i))) * 0.003921569f) * _e2116) + ((f32((_e2085 >> bitcast<u32>(24i))) * 0.003921569f) * _e2011)) * _e2201) + ((((f32((_e2089 >> bitcast<u32>(24i))) * 0.003921569f) * _e2116) + ((f32((_e2093 >> bitcast<u32>(24i))) * 0.003921569f) * _e2011)) * _e2068))));
                        }
                        let _e2244 = phi_3318_;
                        let _e2248 = local_34;
                        let _e2252 = attributes.member[_e2248].member_2[0u];
                        let _e2255 = local_35;
                        let _e2259 = attributes.member[_e2255].member_2[1u];
                        let _e2263 = local_36;
                        let _e2267 = attributes.member[_e2263].member_2[2u];
                        if (((_e2252 | _e2259) | _e2267) == 0u) {
                            phi_3425_ = vec3<f32>(1f, 1f, 1f);
                        } else {
                            let _e2283 = (1f - (f32((_e2252 & 1023u)) * 0.0009775171f));
                            let _e2284 = (1f - (f32(((_e2252 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                            let _e2285 = (1f - (f32(((_e2252 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                            let _e2305 = (1f - (f32((_e2259 & 1023u)) * 0.0009775171f));
                            let _e2306 = (1f - (f32(((_e2259 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                            let _e2307 = (1f - (f32(((_e2259 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                            let _e2330 = (1f - (f32((_e2267 & 1023u)) * 0.0009775171f));
                            let _e2331 = (1f - (f32(((_e2267 >> bitcast<u32>(10i)) & 1023u)) * 0.0009775171f));
                            let _e2332 = (1f - (f32(((_e2267 >> bitcast<u32>(20i)) & 1023u)) * 0.0009775171f));
                            phi_3425_ = vec3<f32>(((((_e2283 * _e2283) * _e1897) + ((_e2305 * _e2305) * _e1887)) + ((_e2330 * _e2330) * _e1895)), ((((_e2284 * _e2284) * _e1897) + ((_e2306 * _e2306) * _e1887)) + ((_e2331 * _e2331) * _e1895)), ((((_e2285 * _e2285) * _e1897) + ((_e2307 * _e2307) * _e1887)) + ((_e2332 * _e2332) * _e1895)));
                        }
                        let _e2344 = phi_3425_;
                        let _e2347 = (_e2244.member.x * _e2344.x);
                        let _e2350 = (_e2244.member.y * _e2344.y);
                        let _e2353 = (_e2244.member.z * _e2344.z);
                        if (_e223 == 2u) {
                            phi_3461_ = 2u;
                        } else {
                            phi_3461_ = (1u - _e223);
                        }
                        let _e2366 = phi_3461_;
                        if (_e2366 == 0u) {
                            phi_3473_ = vec3<f32>(_e1858, _e1863, _e1853);
                        } else {
                            if (_e2366 == 1u) {
                                phi_3472_ = vec3<f32>(_e1863, _e1853, _e1858);
                            } else {
                                phi_3472_ = vec3<f32>(_e1853, _e1858, _e1863);
                            }
                            let _e2371 = phi_3472_;
                            phi_3473_ = _e2371;
                        }
                        let _e2374 = phi_3473_;
                        let _e2378 = params.member.member_2[0u];
                        let _e2392 = (((_e2378.z + (_e1457 >> bitcast<u32>(2i))) + (_e2378.x * (_e1463 >> bitcast<u32>(2i)))) + (_e2378.y * (_e1469 >> bitcast<u32>(1i))));
                        let _e2415 = cells.member[((2u * _e2392) + 1u)];
                        phi_3508_ = type_12(0u, 6u);
                        phi_3511_ = _e2415;
                        loop {
                            let _e2417 = phi_3508_;
                            let _e2419 = phi_3511_;
                            local_37 = _e2419;
                            if (_e2417.member < _e2417.member_1) {
                                phi_3509_ = type_12((_e2417.member + 1u), _e2417.member_1);
                                phi_3534_ = type_12(1u, _e2417.member);
                            } else {
                                phi_3509_ = _e2417;
                                phi_3534_ = type_12(0u, type_12().member_1);
                            }
                            let _e2432 = phi_3509_;
                            let _e2434 = phi_3534_;
                            let _e2438 = (bitcast<i32>(_e2434.member) != 0i);
                            if _e2438 {
                                let _e2442 = facet_bits.member[((_e2392 * 6u) + _e2434.member_1)];
                                let _e2443 = ((((((_e1457 & 1u) | ((_e1463 & 1u) << bitcast<u32>(1i))) | ((_e1469 & 1u) << bitcast<u32>(2i))) | ((_e1457 & 2u) << bitcast<u32>(2i))) | ((_e1463 & 2u) << bitcast<u32>(3i))) & 31u);
                                let _e2449 = (_e2419 + countOneBits((_e2442 & ((1u << bitcast<u32>(_e2443)) - 1u))));
                                if (_e2434.member_1 < ((2u * _e341) + select(0u, 1u, (_e346 < 0f)))) {
                                    phi_3559_ = (_e2449 + ((_e2442 >> bitcast<u32>(_e2443)) & 1u));
                                } else {
                                    phi_3559_ = _e2449;
                                }
                                let _e2456 = phi_3559_;
                                phi_3512_ = _e2456;
                            } else {
                                phi_3512_ = u32();
                            }
                            let _e2458 = phi_3512_;
                            continue;
                            continuing {
                                phi_3508_ = _e2432;
                                phi_3511_ = _e2458;
                                break if !(_e2438);
                            }
                        }
                        let _e2462 = local_37;
                        let _e2463 = (_e2462 * 13u);
                        let _e2466 = params.member.member_7;
                        let _e2469 = floor((((select(_e1847, 0f, select(_e1817, true, _e1819)) * select(1f, 0f, (_e2244.member_1 < bitcast<f32>(_e428)))) * _e2466) + 0.5f));
                        let _e2471 = select(_e2469, 1f, (_e2469 < 1f));
                        let _e2476 = select(select(u32(_e2471), 0u, (_e2471 < 0f)), 4294967295u, (_e2471 > 4294967000f));
                        if (_e2463 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2480 = atomicAdd((&sums.member[_e2463]), _e2476);
                        if (_e2480 >= (2147483648u - select(_e2476, 2147483648u, (2147483648u < _e2476)))) {
                            let _e2487 = params.member.member_5;
                            let _e2488 = (_e2487 * 13u);
                            if (_e2488 < _e105) {
                            } else {
                                phi_5181_ = true;
                                break;
                            }
                            let _e2492 = atomicOr((&sums.member[_e2488]), 1u);
                        }
                        let _e2493 = (_e2463 + 1u);
                        let _e2501 = floor(((_e364.x * _e2471) + 0.5f));
                        if (_e2493 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2513 = atomicAdd((&sums.member[_e2493]), bitcast<u32>(select(0i, select(select(i32(_e2501), i32(-2147483648), (_e2501 < -2147483600f)), 2147483647i, (_e2501 > 2147483500f)), (_e2501 == _e2501))));
                        let _e2514 = (_e2463 + 2u);
                        let _e2516 = floor(((_e364.y * _e2471) + 0.5f));
                        if (_e2514 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2528 = atomicAdd((&sums.member[_e2514]), bitcast<u32>(select(0i, select(select(i32(_e2516), i32(-2147483648), (_e2516 < -2147483600f)), 2147483647i, (_e2516 > 2147483500f)), (_e2516 == _e2516))));
                        let _e2529 = (_e2463 + 3u);
                        let _e2531 = floor(((_e364.z * _e2471) + 0.5f));
                        if (_e2529 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2543 = atomicAdd((&sums.member[_e2529]), bitcast<u32>(select(0i, select(select(i32(_e2531), i32(-2147483648), (_e2531 < -2147483600f)), 2147483647i, (_e2531 > 2147483500f)), (_e2531 == _e2531))));
                        let _e2544 = (_e2463 + 4u);
                        let _e2552 = floor(((_e2374.x * _e2471) + 0.5f));
                        if (_e2544 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2564 = atomicAdd((&sums.member[_e2544]), bitcast<u32>(select(0i, select(select(i32(_e2552), i32(-2147483648), (_e2552 < -2147483600f)), 2147483647i, (_e2552 > 2147483500f)), (_e2552 == _e2552))));
                        let _e2565 = (_e2463 + 5u);
                        let _e2567 = floor(((_e2374.y * _e2471) + 0.5f));
                        if (_e2565 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2579 = atomicAdd((&sums.member[_e2565]), bitcast<u32>(select(0i, select(select(i32(_e2567), i32(-2147483648), (_e2567 < -2147483600f)), 2147483647i, (_e2567 > 2147483500f)), (_e2567 == _e2567))));
                        let _e2580 = (_e2463 + 6u);
                        let _e2582 = floor(((_e2374.z * _e2471) + 0.5f));
                        if (_e2580 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2594 = atomicAdd((&sums.member[_e2580]), bitcast<u32>(select(0i, select(select(i32(_e2582), i32(-2147483648), (_e2582 < -2147483600f)), 2147483647i, (_e2582 > 2147483500f)), (_e2582 == _e2582))));
                        let _e2595 = (_e2463 + 7u);
                        let _e2600 = floor(((select(1f, _e2347, (_e2347 < 1f)) * _e2471) + 0.5f));
                        if (_e2595 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2612 = atomicAdd((&sums.member[_e2595]), bitcast<u32>(select(0i, select(select(i32(_e2600), i32(-2147483648), (_e2600 < -2147483600f)), 2147483647i, (_e2600 > 2147483500f)), (_e2600 == _e2600))));
                        let _e2613 = (_e2463 + 8u);
                        let _e2615 = floor(((select(1f, _e2350, (_e2350 < 1f)) * _e2471) + 0.5f));
                        if (_e2613 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2627 = atomicAdd((&sums.member[_e2613]), bitcast<u32>(select(0i, select(select(i32(_e2615), i32(-2147483648), (_e2615 < -2147483600f)), 2147483647i, (_e2615 > 2147483500f)), (_e2615 == _e2615))));
                        let _e2628 = (_e2463 + 9u);
                        let _e2630 = floor(((select(1f, _e2353, (_e2353 < 1f)) * _e2471) + 0.5f));
                        if (_e2628 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2642 = atomicAdd((&sums.member[_e2628]), bitcast<u32>(select(0i, select(select(i32(_e2630), i32(-2147483648), (_e2630 < -2147483600f)), 2147483647i, (_e2630 > 2147483500f)), (_e2630 == _e2630))));
                        let _e2643 = (_e2463 + 10u);
                        let _e2646 = params.member.member_8;
                        let _e2647 = (_e2471 / _e2646);
                        let _e2652 = floor(((bitcast<f32>(_e399) * _e2647) + 0.5f));
                        if (_e2643 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2664 = atomicAdd((&sums.member[_e2643]), bitcast<u32>(select(0i, select(select(i32(_e2652), i32(-2147483648), (_e2652 < -2147483600f)), 2147483647i, (_e2652 > 2147483500f)), (_e2652 == _e2652))));
                        let _e2665 = (_e2463 + 11u);
                        let _e2667 = floor(((bitcast<f32>(_e405) * _e2647) + 0.5f));
                        if (_e2665 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2679 = atomicAdd((&sums.member[_e2665]), bitcast<u32>(select(0i, select(select(i32(_e2667), i32(-2147483648), (_e2667 < -2147483600f)), 2147483647i, (_e2667 > 2147483500f)), (_e2667 == _e2667))));
                        let _e2680 = (_e2463 + 12u);
                        let _e2682 = floor(((bitcast<f32>(_e411) * _e2647) + 0.5f));
                        if (_e2680 < _e105) {
                        } else {
                            phi_5181_ = true;
                            break;
                        }
                        let _e2694 = atomicAdd((&sums.member[_e2680]), bitcast<u32>(select(0i, select(select(i32(_e2682), i32(-2147483648), (_e2682 < -2147483600f)), 2147483647i, (_e2682 > 2147483500f)), (_e2682 == _e2682))));
                        phi_5182_ = _e1798;
                    } else {
                        phi_5182_ = _e640;
                    }
                    let _e2696 = phi_5182_;
                    continue;
                    continuing {
                        phi_4953_ = _e2696;
                        let _e2737 = local_38;
                        phi_4569_ = _e2737;
                        let _e2740 = local_39;
                        phi_4566_ = _e2740;
                        let _e2743 = local_40;
                        phi_4563_ = _e2743;
                        let _e2746 = local_41;
                        phi_4560_ = _e2746;
                        phi_5181_ = _e2696;
                        break if !(_e1429);
                    }
                }
                let _e2699 = phi_5181_;
                if _e2699 {
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
