struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
}

struct type_21 {
    member: vec4<f32>,
    member_1: vec4<u32>,
    member_2: array<vec4<u32>, 10>,
    member_3: array<vec4<f32>, 16>,
    member_4: vec4<f32>,
    member_5: vec4<f32>,
    member_6: u32,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: f32,
    member_11: f32,
    member_12: f32,
    member_13: f32,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_29 {
    member: array<vec4<f32>>,
}

struct type_34 {
    member: f32,
    member_1: f32,
}

struct type_38 {
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

struct type_40 {
    member: array<type_38>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_22;
@group(0) @binding(1) 
var<storage> cells: type_11;
@group(0) @binding(2) 
var<storage> facet_bits: type_11;
@group(0) @binding(3) 
var<storage> facets: type_26;
@group(0) @binding(4) 
var<storage> radiance: type_29;
@group(0) @binding(5) 
var<storage> odd: type_29;
@group(0) @binding(6) 
var<storage> even: type_29;
@group(0) @binding(7) 
var<storage> surfels: type_40;
@group(0) @binding(8) 
var<storage, read_write> out: type_29;

fn function_() {
    var phi_368_: f32;
    var phi_376_: f32;
    var phi_378_: type_34;
    var phi_4040_: bool;
    var phi_403_: type_8;
    var phi_406_: vec3<f32>;
    var phi_404_: type_8;
    var phi_429_: type_8;
    var phi_507_: f32;
    var phi_509_: f32;
    var phi_521_: f32;
    var phi_523_: f32;
    var phi_535_: f32;
    var phi_537_: f32;
    var phi_587_: f32;
    var phi_589_: f32;
    var phi_601_: f32;
    var phi_603_: f32;
    var phi_615_: f32;
    var phi_617_: f32;
    var phi_4018_: bool;
    var phi_635_: type_8;
    var phi_638_: vec3<f32>;
    var phi_640_: f32;
    var phi_642_: f32;
    var phi_644_: f32;
    var phi_636_: type_8;
    var phi_667_: type_8;
    var phi_737_: u32;
    var phi_802_: bool;
    var phi_808_: bool;
    var phi_813_: u32;
    var phi_819_: u32;
    var phi_858_: f32;
    var phi_884_: bool;
    var phi_890_: bool;
    var phi_895_: u32;
    var phi_901_: u32;
    var phi_940_: f32;
    var phi_966_: bool;
    var phi_972_: bool;
    var phi_977_: u32;
    var phi_983_: u32;
    var phi_1022_: f32;
    var phi_3987_: bool;
    var phi_1029_: type_8;
    var phi_1032_: vec4<f32>;
    var phi_1030_: type_8;
    var phi_1055_: type_8;
    var phi_1640_: vec4<f32>;
    var phi_1677_: vec4<f32>;
    var phi_1718_: vec4<f32>;
    var phi_1612_: vec4<f32>;
    var phi_1733_: vec4<f32>;
    var phi_1154_: type_8;
    var phi_1157_: u32;
    var phi_1155_: type_8;
    var phi_1180_: type_8;
    var phi_1158_: u32;
    var phi_3973_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1429_: type_8;
    var phi_1432_: vec4<f32>;
    var phi_1434_: vec4<f32>;
    var phi_1430_: type_8;
    var phi_1457_: type_8;
    var phi_1541_: vec4<f32>;
    var phi_1542_: vec4<f32>;
    var phi_1433_: vec4<f32>;
    var phi_1435_: vec4<f32>;
    var phi_4047_: bool;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_1564_: vec4<f32>;
    var local_8: u32;
    var local_9: u32;
    var phi_1297_: type_8;
    var phi_1300_: vec4<f32>;
    var phi_1298_: type_8;
    var phi_1323_: type_8;
    var phi_1301_: vec4<f32>;
    var phi_4052_: bool;
    var phi_4069_: bool;
    var phi_1565_: vec4<f32>;
    var phi_4063_: bool;
    var phi_1734_: vec4<f32>;
    var phi_4062_: bool;
    var phi_1755_: vec4<f32>;
    var phi_4061_: bool;
    var phi_1756_: vec4<f32>;
    var phi_4060_: bool;
    var phi_1033_: vec4<f32>;
    var phi_4059_: bool;
    var local_10: vec4<f32>;
    var phi_1811_: bool;
    var phi_1817_: bool;
    var phi_1822_: u32;
    var phi_1828_: u32;
    var phi_1867_: f32;
    var phi_1893_: bool;
    var phi_1899_: bool;
    var phi_1904_: u32;
    var phi_1910_: u32;
    var phi_1949_: f32;
    var phi_1975_: bool;
    var phi_1981_: bool;
    var phi_1986_: u32;
    var phi_1992_: u32;
    var phi_2031_: f32;
    var phi_4085_: bool;
    var phi_2038_: type_8;
    var phi_2041_: vec4<f32>;
    var phi_2039_: type_8;
    var phi_2064_: type_8;
    var phi_2649_: vec4<f32>;
    var phi_2686_: vec4<f32>;
    var phi_2727_: vec4<f32>;
    var phi_2621_: vec4<f32>;
    var phi_2742_: vec4<f32>;
    var phi_2163_: type_8;
    var phi_2166_: u32;
    var phi_2164_: type_8;
    var phi_2189_: type_8;
    var phi_2167_: u32;
    var phi_4071_: bool;
    var local_11: u32;
    var local_12: u32;
    var phi_2438_: type_8;
    var phi_2441_: vec4<f32>;
    var phi_2443_: vec4<f32>;
    var phi_2439_: type_8;
    var phi_2466_: type_8;
    var phi_2550_: vec4<f32>;
    var phi_2551_: vec4<f32>;
    var phi_2442_: vec4<f32>;
    var phi_2444_: vec4<f32>;
    var phi_4111_: bool;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var phi_2573_: vec4<f32>;
    var local_19: u32;
    var local_20: u32;
    var phi_2306_: type_8;
    var phi_2309_: vec4<f32>;
    var phi_2307_: type_8;
    var phi_2332_: type_8;
    var phi_2310_: vec4<f32>;
    var phi_4116_: bool;
    var phi_4133_: bool;
    var phi_2574_: vec4<f32>;
    var phi_4127_: bool;
    var phi_2743_: vec4<f32>;
    var phi_4126_: bool;
    var phi_2764_: vec4<f32>;
    var phi_4125_: bool;
    var phi_2765_: vec4<f32>;
    var phi_4124_: bool;
    var phi_2042_: vec4<f32>;
    var phi_4123_: bool;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var phi_4176_: bool;
    var phi_2791_: vec4<f32>;
    var phi_4175_: bool;
    var phi_2792_: vec4<f32>;
    var phi_2793_: bool;
    var phi_4174_: bool;
    var phi_2794_: vec4<f32>;
    var phi_2795_: bool;
    var phi_2796_: bool;
    var phi_2849_: bool;
    var phi_2855_: bool;
    var phi_2860_: u32;
    var phi_2866_: u32;
    var phi_2905_: f32;
    var phi_2931_: bool;
    var phi_2937_: bool;
    var phi_2942_: u32;
    var phi_2948_: u32;
    var phi_2987_: f32;
    var phi_3013_: bool;
    var phi_3019_: bool;
    var phi_3024_: u32;
    var phi_3030_: u32;
    var phi_3069_: f32;
    var phi_4149_: bool;
    var phi_3076_: type_8;
    var phi_3079_: vec4<f32>;
    var phi_3077_: type_8;
    var phi_3102_: type_8;
    var phi_3687_: vec4<f32>;
    var phi_3724_: vec4<f32>;
    var phi_3765_: vec4<f32>;
    var phi_3659_: vec4<f32>;
    var phi_3780_: vec4<f32>;
    var phi_3201_: type_8;
    var phi_3204_: u32;
    var phi_3202_: type_8;
    var phi_3227_: type_8;
    var phi_3205_: u32;
    var phi_4135_: bool;
    var local_28: u32;
    var local_29: u32;
    var phi_3476_: type_8;
    var phi_3479_: vec4<f32>;
    var phi_3481_: vec4<f32>;
    var phi_3477_: type_8;
    var phi_3504_: type_8;
    var phi_3588_: vec4<f32>;
    var phi_3589_: vec4<f32>;
    var phi_3480_: vec4<f32>;
    var phi_3482_: vec4<f32>;
    var phi_4178_: bool;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var phi_3611_: vec4<f32>;
    var local_36: u32;
    var local_37: u32;
    var phi_3344_: type_8;
    var phi_3347_: vec4<f32>;
    var phi_3345_: type_8;
    var phi_3370_: type_8;
    var phi_3348_: vec4<f32>;
    var phi_4183_: bool;
    var phi_4200_: bool;
    var phi_3612_: vec4<f32>;
    var phi_4194_: bool;
    var phi_3781_: vec4<f32>;
    var phi_4193_: bool;
    var phi_3802_: vec4<f32>;
    var phi_4192_: bool;
    var phi_3803_: vec4<f32>;
    var phi_4191_: bool;
    var phi_3080_: vec4<f32>;
    var phi_4190_: bool;
    var local_38: vec4<f32>;
    var phi_4208_: bool;
    var phi_3805_: vec4<f32>;
    var phi_3844_: vec3<f32>;
    var phi_3845_: f32;
    var phi_4205_: bool;
    var phi_3848_: vec3<f32>;
    var phi_3849_: f32;
    var phi_3850_: f32;
    var phi_3851_: f32;
    var phi_4204_: bool;
    var phi_3853_: vec3<f32>;
    var phi_3854_: f32;
    var phi_3855_: f32;
    var phi_3856_: f32;
    var phi_3857_: bool;
    var phi_4203_: bool;
    var phi_639_: vec3<f32>;
    var phi_641_: f32;
    var phi_643_: f32;
    var phi_645_: f32;
    var phi_3859_: bool;
    var phi_4202_: bool;
    var local_39: f32;
    var local_40: f32;
    var local_41: vec3<f32>;
    var local_42: vec3<f32>;
    var local_43: vec3<f32>;
    var phi_4211_: bool;
    var phi_407_: vec3<f32>;
    var phi_4210_: bool;
    var local_44: vec3<f32>;
    var local_45: vec3<f32>;
    var local_46: vec3<f32>;
    var phi_3904_: vec4<f32>;
    var local_47: vec4<f32>;
    var local_48: vec4<f32>;
    var local_49: vec4<f32>;
    var local_50: vec4<f32>;
    var local_51: vec4<f32>;
    var local_52: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = gid_1;
            let _e84 = arrayLength((&cells.member));
            let _e87 = arrayLength((&facet_bits.member));
            let _e90 = arrayLength((&facets.member));
            let _e93 = arrayLength((&radiance.member));
            let _e96 = arrayLength((&odd.member));
            let _e99 = arrayLength((&even.member));
            let _e106 = params.member.member_8;
            let _e110 = (_e81.x + (_e81.y * 2097152u));
            if (_e110 < _e106) {
                if (_e110 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e116 = surfels.member[_e110].member;
                let _e120 = surfels.member[_e110].member_1;
                let _e124 = surfels.member[_e110].member_2;
                let _e128 = surfels.member[_e110].member_4;
                if (_e120 == 4294967295u) {
                    phi_3904_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e141 = params.member.member;
                    let _e154 = params.member.member_12;
                    let _e158 = (((_e116[0] - _e141.x) / _e141.w) + (_e128[0] * _e154));
                    let _e159 = (((_e116[1] - _e141.y) / _e141.w) + (_e128[1] * _e154));
                    let _e160 = (((_e116[2] - _e141.z) / _e141.w) + (_e128[2] * _e154));
                    let _e164 = bitcast<f32>((1065353216u | (bitcast<u32>(_e124[2]) & 2147483648u)));
                    let _e166 = (-1f / (_e164 + _e124[2]));
                    let _e168 = ((_e124[0] * _e124[1]) * _e166);
                    let _e172 = (1f + (((_e164 * _e124[0]) * _e124[0]) * _e166));
                    let _e173 = (_e164 * _e168);
                    let _e175 = (-(_e164) * _e124[0]);
                    let _e178 = (_e164 + ((_e124[1] * _e124[1]) * _e166));
                    let _e179 = -(_e124[1]);
                    let _e182 = params.member.member_9;
                    if (_e182 == 0u) {
                        phi_378_ = type_34(0f, 1f);
                    } else {
                        let _e187 = ((_e110 * 1664525u) + 1013904223u);
                        let _e189 = (((_e182 * 1664525u) + 1013904223u) + (_e187 * 1013904223u));
                        let _e191 = (_e187 + (1013904223u * _e189));
                        let _e195 = (1013904223u + (_e191 * (1013904223u + (_e189 * _e191))));
                        let _e209 = f32((((_e189 ^ (_e189 >> bitcast<u32>(16i))) + ((_e191 ^ (_e191 >> bitcast<u32>(16i))) * (_e195 ^ (_e195 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i)));
                        let _e213 = floor(((_e209 * 0.00000023841858f) + 0.5f));
                        let _e219 = ((((_e209 * 0.00000037450704f) - (_e213 * 1.5703125f)) - (_e213 * 0.0004837513f)) - (_e213 * 0.0000000754979f));
                        let _e220 = (_e219 * _e219);
                        let _e227 = (_e219 + ((_e219 * _e220) * (-0.16666655f + (_e220 * (0.008332161f + (_e220 * -0.00019515296f))))));
                        let _e236 = ((1f - (0.5f * _e220)) + ((_e220 * _e220) * (0.041666646f + (_e220 * (-0.0013887316f + (_e220 * 0.000024433157f))))));
                        let _e243 = select(0i, select(select(i32(_e213), i32(-2147483648), (_e213 < -2147483600f)), 2147483647i, (_e213 > 2147483500f)), (_e213 == _e213));
                        let _e245 = ((_e243 & 1i) == 0i);
                        let _e246 = select(_e236, _e227, _e245);
                        let _e247 = select(_e227, _e236, _e245);
                        if ((_e243 & 2i) == 0i) {
                            phi_368_ = _e246;
                        } else {
                            phi_368_ = -(_e246);
                        }
                        let _e252 = phi_368_;
                        if (((_e243 + 1i) & 2i) == 0i) {
                            phi_376_ = _e247;
                        } else {
                            phi_376_ = -(_e247);
                        }
                        let _e258 = phi_376_;
                        phi_378_ = type_34(_e252, _e258);
                    }
                    let _e261 = phi_378_;
                    let _e284 = params.member.member_6;
                    phi_4040_ = false;
                    phi_403_ = type_8(0u, _e284);
                    phi_406_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e287 = phi_4040_;
                        let _e289 = phi_403_;
                        let _e291 = phi_406_;
                        local_44 = _e291;
                        local_45 = _e291;
                        local_46 = _e291;
                        if (_e289.member < _e289.member_1) {
                            phi_404_ = type_8((_e289.member + 1u), _e289.member_1);
                            phi_429_ = type_8(1u, _e289.member);
                        } else {
                            phi_404_ = _e289;
                            phi_429_ = type_8(0u, type_8().member_1);
                        }
                        let _e304 = phi_404_;
                        let _e306 = phi_429_;
                        let _e310 = (bitcast<i32>(_e306.member) != 0i);
                        if _e310 {
                            if (_e306.member_1 < 16u) {
                            } else {
                                phi_4210_ = true;
                                break;
                            }
                            let _e316 = params.member.member_3[_e306.member_1][0u];
                            let _e321 = params.member.member_3[_e306.member_1][1u];
                            let _e326 = params.member.member_3[_e306.member_1][2u];
                            let _e331 = params.member.member_3[_e306.member_1][3u];
                            let _e344 = (((((_e172 * _e261.member_1) + (_e168 * _e261.member)) * _e316) + (((_e168 * _e261.member_1) - (_e172 * _e261.member)) * _e321)) + (_e124[0] * _e326));
                            let _e345 = (((((_e173 * _e261.member_1) + (_e178 * _e261.member)) * _e316) + (((_e178 * _e261.member_1) - (_e173 * _e261.member)) * _e321)) + (_e124[1] * _e326));
                            let _e346 = (((((_e175 * _e261.member_1) + (_e179 * _e261.member)) * _e316) + (((_e179 * _e261.member_1) - (_e175 * _e261.member)) * _e321)) + (_e124[2] * _e326));
                            let _e349 = params.member.member_10;
                            let _e352 = params.member.member_13;
                            let _e353 = (_e352 * _e154);
                            let _e354 = (_e352 * _e326);
                            let _e357 = params.member.member_11;
                            let _e360 = params.member.member_1;
                            let _e362 = f32(_e360.x);
                            let _e364 = f32(_e360.y);
                            let _e366 = f32(_e360.z);
                            let _e367 = abs(_e344);
                            let _e368 = (_e367 < 0.000000001f);
                            if _e368 {
                                phi_509_ = 340282350000000000000000000000000000000f;
                            } else {
                                if (_e344 > 0f) {
                                    phi_507_ = (_e362 - _e158);
                                } else {
                                    phi_507_ = -(_e158);
                                }
                                let _e373 = phi_507_;
                                phi_509_ = (_e373 / _e344);
                            }
                            let _e376 = phi_509_;
                            let _e377 = abs(_e345);
                            let _e378 = (_e377 < 0.000000001f);
                            if _e378 {
                                phi_523_ = 340282350000000000000000000000000000000f;
                            } else {
                                if (_e345 > 0f) {
                                    phi_521_ = (_e364 - _e159);
                                } else {
                                    phi_521_ = -(_e159);
                                }
                                let _e383 = phi_521_;
                                phi_523_ = (_e383 / _e345);
                            }
                            let _e386 = phi_523_;
                            let _e387 = abs(_e346);
                            let _e388 = (_e387 < 0.000000001f);
                            if _e388 {
                                phi_537_ = 340282350000000000000000000000000000000f;
                            } else {
                                if (_e346 > 0f) {
                                    phi_535_ = (_e366 - _e160);
                                } else {
                                    phi_535_ = -(_e160);
                                }
                                let _e393 = phi_535_;
                                phi_537_ = (_e393 / _e346);
                            }
                            let _e396 = phi_537_;
                            let _e398 = select(_e386, _e376, (_e376 < _e386));
                            let _e400 = select(_e396, _e398, (_e398 < _e396));
                            let _e402 = select(0f, _e400, (_e400 > 0f));
                            let _e403 = (_e349 * _e402);
                            let _e405 = (_e353 + (_e354 * _e402));
                            let _e407 = select(_e405, _e403, (_e403 < _e405));
                            let _e409 = select(1f, _e407, (_e407 > 1f));
                            let _e410 = (1.5f * _e409);
                            let _e411 = (_e158 + _e410);
                            let _e412 = (_e159 + _e410);
                            let _e413 = (_e160 + _e410);
                            let _e414 = (_e409 * 3f);
                            if _e368 {
                                phi_589_ = 340282350000000000000000000000000000000f;
                            } else {
                                if (_e344 > 0f) {
                                    phi_587_ = ((_e362 + _e414) - _e411);
                                } else {
                                    phi_587_ = -(_e411);
                                }
                                let _e422 = phi_587_;
                                phi_589_ = (_e422 / _e344);
                            }
                            let _e425 = phi_589_;
                            if _e378 {
                                phi_603_ = 340282350000000000000000000000000000000f;
                            } else {
                                if (_e345 > 0f) {
                                    phi_601_ = ((_e364 + _e414) - _e412);
                                } else {
                                    phi_601_ = -(_e412);
                                }
                                let _e430 = phi_601_;
                                phi_603_ = (_e430 / _e345);
                            }
                            let _e433 = phi_603_;
                            if _e388 {
                                phi_617_ = 340282350000000000000000000000000000000f;
                            } else {
                                if (_e346 > 0f) {
                                    phi_615_ = ((_e366 + _e414) - _e413);
                                } else {
                                    phi_615_ = -(_e413);
                                }
                                let _e438 = phi_615_;
                                phi_617_ = (_e438 / _e346);
                            }
                            let _e441 = phi_617_;
                            let _e443 = select(_e433, _e425, (_e425 < _e433));
                            let _e445 = select(_e441, _e443, (_e443 < _e441));
                            phi_4018_ = _e287;
                            phi_635_ = type_8(0u, 2048u);
                            phi_638_ = vec3<f32>(0f, 0f, 0f);
                            phi_640_ = 0f;
                            phi_642_ = 0f;
                            phi_644_ = 1f;
                            loop {
                                let _e449 = phi_4018_;
                                let _e451 = phi_635_;
                                let _e453 = phi_638_;
                                let _e455 = phi_640_;
                                let _e457 = phi_642_;
                                let _e459 = phi_644_;
                                local_39 = _e457;
                                local_40 = _e459;
                                local_41 = _e453;
                                local_42 = _e453;
                                local_43 = _e453;
                                if (_e451.member < _e451.member_1) {
                                    phi_636_ = type_8((_e451.member + 1u), _e451.member_1);
                                    phi_667_ = type_8(1u, _e451.member);
                                } else {
                                    phi_636_ = _e451;
                                    phi_667_ = type_8(0u, type_8().member_1);
                                }
                                let _e472 = phi_636_;
                                let _e474 = phi_667_;
                                if (bitcast<i32>(_e474.member) != 0i) {
                                    if (_e455 >= select(0f, _e445, (_e445 > 0f))) {
                                        phi_4204_ = _e449;
                                        phi_3853_ = vec3<f32>();
                                        phi_3854_ = f32();
                                        phi_3855_ = f32();
                                        phi_3856_ = f32();
                                        phi_3857_ = false;
                                    } else {
                                        let _e479 = (1f - _e457);
                                        let _e480 = (_e459 * _e479);
                                        let _e481 = (_e480 < 0.001f);
                                        if _e481 {
                                            phi_4205_ = _e449;
                                            phi_3848_ = vec3<f32>();
                                            phi_3849_ = f32();
                                            phi_3850_ = f32();
                                            phi_3851_ = f32();
                                        } else {
                                            let _e482 = (_e349 * _e455);
                                            let _e484 = (_e353 + (_e354 * _e455));
                                            let _e486 = select(_e484, _e482, (_e482 < _e484));
                                            let _e489 = (_e357 * select(1f, _e486, (_e486 > 1f)));
                                            let _e491 = (_e455 + (0.5f * _e489));
                                            let _e495 = (_e158 + (_e344 * _e491));
                                            let _e496 = (_e159 + (_e345 * _e491));
                                            let _e497 = (_e160 + (_e346 * _e491));
                                            let _e498 = (_e349 * _e491);
                                            let _e500 = (_e353 + (_e354 * _e491));
                                            let _e502 = select(_e500, _e498, (_e498 < _e500));
                                            let _e504 = select(1f, _e502, (_e502 > 1f));
                                            let _e509 = (bitcast<i32>((bitcast<u32>(_e504) >> bitcast<u32>(23i))) - 127i);
                                            let _e511 = (_e360.w - 1u);
                                            if (_e509 > 0i) {
                                                let _e513 = bitcast<u32>(_e509);
                                                phi_737_ = select(_e513, _e511, (_e511 < _e513));
                                            } else {
                                                phi_737_ = 0u;
                                            }
                                            let _e517 = phi_737_;
                                            let _e518 = (_e517 & 31u);
                                            let _e520 = (1u << bitcast<u32>(_e518));
                                            let _e522 = (1f / f32(_e520));
                                            let _e523 = (_e504 * _e522);
                                            let _e524 = (_e523 - 1f);
                                            if (_e517 == _e511) {
                                                phi_4174_ = _e449;
                                                phi_2794_ = vec4<f32>();
                                                phi_2795_ = true;
                                                phi_2796_ = false;
                                            } else {
                                                let _e526 = (_e524 <= 0f);
                                                if _e526 {
                                                    phi_4175_ = _e449;
                                                    phi_2792_ = vec4<f32>();
                                                    phi_2793_ = false;
                                                } else {
                                                    let _e527 = (_e517 + 1u);
                                                    if (_e527 < 10u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e532 = params.member.member_2[_e527];
                                                    let _e533 = (_e527 & 31u);
                                                    let _e535 = (1u << bitcast<u32>(_e533));
                                                    let _e536 = (_e535 - 1u);
                                                    let _e547 = (1f / f32(_e535));
                                                    let _e549 = ((_e495 * _e547) - 0.5f);
                                                    let _e550 = floor(_e549);
                                                    let _e551 = (_e549 - _e550);
                                                    let _e558 = select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < -2147483600f)), 2147483647i, (_e550 > 2147483500f)), (_e550 == _e550));
                                                    let _e560 = (bitcast<i32>(((_e360.x + _e536) >> bitcast<u32>(_e533))) - 1i);
                                                    if (_e558 >= 0i) {
                                                        phi_802_ = (_e558 <= _e560);
                                                    } else {
                                                        phi_802_ = false;
                                                    }
                                                    let _e564 = phi_802_;
                                                    if (_e558 >= -1i) {
                                                        phi_808_ = (_e558 < _e560);
                                                    } else {
                                                        phi_808_ = false;
                                                    }
                                                    let _e568 = phi_808_;
                                                    if _e564 {
                                                        phi_813_ = bitcast<u32>(_e558);
                                                    } else {
                                                        phi_813_ = 0u;
                                                    }
                                                    let _e571 = phi_813_;
                                                    if _e568 {
                                                        phi_819_ = bitcast<u32>((_e558 + 1i));
                                                    } else {
                                                        phi_819_ = 0u;
                                                    }
                                                    let _e575 = phi_819_;
                                                    if _e564 {
                                                        phi_858_ = (1f - _e551);
                                                    } else {
                                                        phi_858_ = 0f;
                                                    }
                                                    let _e596 = phi_858_;
                                                    let _e599 = ((_e496 * _e547) - 0.5f);
                                                    let _e601 = floor(_e599);
                                                    let _e602 = (_e599 - _e601);
                                                    let _e609 = select(0i, select(select(i32(_e601), i32(-2147483648), (_e601 < -2147483600f)), 2147483647i, (_e601 > 2147483500f)), (_e601 == _e601));
                                                    let _e611 = (bitcast<i32>(((_e360.y + _e536) >> bitcast<u32>(_e533))) - 1i);
                                                    if (_e609 >= 0i) {
                                                        phi_884_ = (_e609 <= _e611);
                                                    } else {
                                                        phi_884_ = false;
                                                    }
                                                    let _e615 = phi_884_;
                                                    if (_e609 >= -1i) {
                                                        phi_890_ = (_e609 < _e611);
                                                    } else {
                                                        phi_890_ = false;
                                                    }
                                                    let _e619 = phi_890_;
                                                    if _e615 {
                                                        phi_895_ = bitcast<u32>(_e609);
                                                    } else {
                                                        phi_895_ = 0u;
                                                    }
                                                    let _e622 = phi_895_;
                                                    if _e619 {
                                                        phi_901_ = bitcast<u32>((_e609 + 1i));
                                                    } else {
                                                        phi_901_ = 0u;
                                                    }
                                                    let _e626 = phi_901_;
                                                    if _e615 {
                                                        phi_940_ = (1f - _e602);
                                                    } else {
                                                        phi_940_ = 0f;
                                                    }
                                                    let _e653 = phi_940_;
                                                    let _e656 = ((_e497 * _e547) - 0.5f);
                                                    let _e658 = floor(_e656);
                                                    let _e659 = (_e656 - _e658);
                                                    let _e666 = select(0i, select(select(i32(_e658), i32(-2147483648), (_e658 < -2147483600f)), 2147483647i, (_e658 > 2147483500f)), (_e658 == _e658));
                                                    let _e668 = (bitcast<i32>(((_e360.z + _e536) >> bitcast<u32>(_e533))) - 1i);
                                                    if (_e666 >= 0i) {
                                                        phi_966_ = (_e666 <= _e668);
                                                    } else {
                                                        phi_966_ = false;
                                                    }
                                                    let _e672 = phi_966_;
                                                    if (_e666 >= -1i) {
                                                        phi_972_ = (_e666 < _e668);
                                                    } else {
                                                        phi_972_ = false;
                                                    }
                                                    let _e676 = phi_972_;
                                                    if _e672 {
                                                        phi_977_ = bitcast<u32>(_e666);
                                                    } else {
                                                        phi_977_ = 0u;
                                                    }
                                                    let _e679 = phi_977_;
                                                    if _e676 {
                                                        phi_983_ = bitcast<u32>((_e666 + 1i));
                                                    } else {
                                                        phi_983_ = 0u;
                                                    }
                                                    let _e683 = phi_983_;
                                                    if _e672 {
                                                        phi_1022_ = (1f - _e659);
                                                    } else {
                                                        phi_1022_ = 0f;
                                                    }
                                                    let _e698 = phi_1022_;
                                                    phi_3987_ = _e449;
                                                    phi_1029_ = type_8(0u, 8u);
                                                    phi_1032_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                    loop {
                                                        let _e701 = phi_3987_;
                                                        let _e703 = phi_1029_;
                                                        let _e705 = phi_1032_;
                                                        local_10 = _e705;
                                                        local_25 = _e705;
                                                        local_26 = _e705;
                                                        local_27 = _e705;
                                                        if (_e703.member < _e703.member_1) {
                                                            phi_1030_ = type_8((_e703.member + 1u), _e703.member_1);
                                                            phi_1055_ = type_8(1u, _e703.member);
                                                        } else {
                                                            phi_1030_ = _e703;
                                                            phi_1055_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e718 = phi_1030_;
                                                        let _e720 = phi_1055_;
                                                        let _e724 = (bitcast<i32>(_e720.member) != 0i);
                                                        if _e724 {
                                                            let _e726 = ((_e720.member_1 & 1u) == 1u);
                                                            let _e728 = ((_e720.member_1 & 2u) == 2u);
                                                            let _e730 = ((_e720.member_1 & 4u) == 4u);
                                                            let _e735 = ((select(_e596, select(0f, _e551, _e568), _e726) * select(_e653, select(0f, _e602, _e619), _e728)) * select(_e698, select(0f, _e659, _e676), _e730));
                                                            let _e742 = (((_e532.z + select((_e571 >> bitcast<u32>(2u)), (_e575 >> bitcast<u32>(2u)), _e726)) + select(((_e622 >> bitcast<u32>(2u)) * _e532.x), ((_e626 >> bitcast<u32>(2u)) * _e532.x), _e728)) + select(((_e679 >> bitcast<u32>(1u)) * _e532.y), ((_e683 >> bitcast<u32>(1u)) * _e532.y), _e730));
                                                            let _e748 = (2u * _e742);
                                                            if (_e748 < _e84) {
                                                            } else {
                                                                phi_4059_ = true;
                                                                break;
                                                            }
                                                            let _e751 = cells.member[_e748];
                                                            if (_e735 > 0f) {
                                                                let _e753 = (((select(((_e571 & 1u) | (((_e571 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), ((_e575 & 1u) | (((_e575 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), _e726) | select((((_e622 & 1u) << bitcast<u32>(1u)) | (((_e622 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), (((_e626 & 1u) << bitcast<u32>(1u)) | (((_e626 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), _e728)) | select(((_e679 & 1u) << bitcast<u32>(2u)), ((_e683 & 1u) << bitcast<u32>(2u)), _e730)) & 31u);
                                                                if (((_e751 >> bitcast<u32>(_e753)) & 1u) == 1u) {
                                                                    if (_e527 == 0u) {
                                                                        let _e856 = (_e742 * 6u);
                                                                        let _e857 = (_e748 + 1u);
                                                                        if (_e857 < _e84) {
                                                                        } else {
                                                                            phi_4059_ = true;
                                                                            break;
                                                                        }
                                                                        let _e860 = cells.member[_e857];
                                                                        phi_1154_ = type_8(0u, 6u);
                                                                        phi_1157_ = _e860;
                                                                        loop {
                                                                            let _e862 = phi_1154_;
                                                                            let _e864 = phi_1157_;
                                                                            local = _e864;
                                                                            local_1 = _e864;
                                                                            local_8 = _e864;
                                                                            local_9 = _e864;
                                                                            if (_e862.member < _e862.member_1) {
                                                                                phi_1155_ = type_8((_e862.member + 1u), _e862.member_1);
                                                                                phi_1180_ = type_8(1u, _e862.member);
                                                                            } else {
                                                                                phi_1155_ = _e862;
                                                                                phi_1180_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e877 = phi_1155_;
                                                                            let _e879 = phi_1180_;
                                                                            let _e883 = (bitcast<i32>(_e879.member) != 0i);
                                                                            if _e883 {
                                                                                let _e884 = (_e856 + _e879.member_1);
                                                                                if (_e884 < _e87) {
                                                                                } else {
                                                                                    phi_3973_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e887 = facet_bits.member[_e884];
                                                                                phi_1158_ = (_e864 + countOneBits((_e887 & ((1u << bitcast<u32>(_e753)) - 1u))));
                                                                            } else {
                                                                                phi_1158_ = u32();
                                                                            }
                                                                            let _e895 = phi_1158_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_1154_ = _e877;
                                                                                phi_1157_ = _e895;
                                                                                phi_3973_ = _e701;
                                                                                break if !(_e883);
                                                                            }
                                                                        }
                                                                        let _e898 = phi_3973_;
                                                                        phi_4059_ = _e898;
                                                                        if _e898 {
                                                                            break;
                                                                        }
                                                                        if (_e856 < _e87) {
                                                                        } else {
                                                                            phi_4059_ = true;
                                                                            break;
                                                                        }
                                                                        let _e901 = facet_bits.member[_e856];
                                                                        let _e905 = (_e856 + 1u);
                                                                        if (_e905 < _e87) {
                                                                        } else {
                                                                            phi_4059_ = true;
                                                                            break;
                                                                        }
                                                                        let _e908 = facet_bits.member[_e905];
                                                                        let _e913 = (_e856 + 2u);
                                                                        if (_e913 < _e87) {
                                                                        } else {
                                                                            phi_4059_ = true;
                                                                            break;
                                                                        }
                                                                        let _e916 = facet_bits.member[_e913];
                                                                        let _e921 = (_e856 + 3u);
                                                                        if (_e921 < _e87) {
                                                                        } else {
                                                                            phi_4059_ = true;
                                                                            break;
                                                                        }
                                                                        let _e924 = facet_bits.member[_e921];
                                                                        let _e929 = (_e856 + 4u);
                                                                        if (_e929 < _e87) {
                                                                        } else {
                                                                            phi_4059_ = true;
                                                                            break;
                                                                        }
                                                                        let _e932 = facet_bits.member[_e929];
                                                                        let _e937 = (_e856 + 5u);
                                                                        if (_e937 < _e87) {
                                                                        } else {
                                                                            phi_4059_ = true;
                                                                            break;
                                                                        }
                                                                        let _e940 = facet_bits.member[_e937];
                                                                        let _e944 = (((((((_e901 >> bitcast<u32>(_e753)) & 1u) + ((_e908 >> bitcast<u32>(_e753)) & 1u)) + ((_e916 >> bitcast<u32>(_e753)) & 1u)) + ((_e924 >> bitcast<u32>(_e753)) & 1u)) + ((_e932 >> bitcast<u32>(_e753)) & 1u)) + ((_e940 >> bitcast<u32>(_e753)) & 1u));
                                                                        let _e947 = params.member.member_7;
                                                                        if (_e947 == 1u) {
                                                                            let _e1072 = local_8;
                                                                            let _e1075 = local_9;
                                                                            phi_1297_ = type_8(_e1075, (_e1072 + _e944));
                                                                            phi_1300_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            loop {
                                                                                let _e1078 = phi_1297_;
                                                                                let _e1080 = phi_1300_;
                                                                                local_48 = _e1080;
                                                                                if (_e1078.member < _e1078.member_1) {
                                                                                    phi_1298_ = type_8((_e1078.member + 1u), _e1078.member_1);
                                                                                    phi_1323_ = type_8(1u, _e1078.member);
                                                                                } else {
                                                                                    phi_1298_ = _e1078;
                                                                                    phi_1323_ = type_8(0u, type_8().member_1);
                                                                                }
                                                                                let _e1093 = phi_1298_;
                                                                                let _e1095 = phi_1323_;
                                                                                let _e1099 = (bitcast<i32>(_e1095.member) != 0i);
                                                                                if _e1099 {
                                                                                    let _e1100 = (2u * _e1095.member_1);
                                                                                    if (_e1100 < _e93) {
                                                                                    } else {
                                                                                        phi_4052_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1104 = radiance.member[_e1100][0u];
                                                                                    let _e1107 = radiance.member[_e1100][1u];
                                                                                    let _e1110 = radiance.member[_e1100][2u];
                                                                                    let _e1111 = (_e1100 + 1u);
                                                                                    if (_e1111 < _e93) {
                                                                                    } else {
                                                                                        phi_4052_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1115 = radiance.member[_e1111][0u];
                                                                                    let _e1118 = radiance.member[_e1111][1u];
                                                                                    let _e1121 = radiance.member[_e1111][2u];
                                                                                    if (_e1095.member_1 < _e90) {
                                                                                    } else {
                                                                                        phi_4052_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1131 = facets.member[_e1095.member_1].member_2;
                                                                                    let _e1140 = sqrt((((_e1131[0] * _e1131[0]) + (_e1131[1] * _e1131[1])) + (_e1131[2] * _e1131[2])));
                                                                                    phi_1301_ = vec4<f32>((_e1080.x + (select(_e1115, _e1104, (_e1104 > _e1115)) * _e1140)), (_e1080.y + (select(_e1118, _e1107, (_e1107 > _e1118)) * _e1140)), (_e1080.z + (select(_e1121, _e1110, (_e1110 > _e1121)) * _e1140)), (_e1080.w + _e1140));
                                                                                } else {
                                                                                    phi_1301_ = vec4<f32>();
                                                                                }
                                                                                let _e1154 = phi_1301_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_1297_ = _e1093;
                                                                                    phi_1300_ = _e1154;
                                                                                    phi_4052_ = _e898;
                                                                                    break if !(_e1099);
                                                                                }
                                                                            }
                                                                            let _e1157 = phi_4052_;
                                                                            phi_4059_ = _e1157;
                                                                            if _e1157 {
                                                                                break;
                                                                            }
                                                                            phi_4069_ = _e1157;
                                                                            let _e2818 = local_48;
                                                                            phi_1565_ = _e2818;
                                                                        } else {
                                                                            let _e950 = local;
                                                                            let _e953 = local_1;
                                                                            phi_1429_ = type_8(_e953, (_e950 + _e944));
                                                                            phi_1432_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            phi_1434_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            loop {
                                                                                let _e956 = phi_1429_;
                                                                                let _e958 = phi_1432_;
                                                                                let _e960 = phi_1434_;
                                                                                local_2 = _e958;
                                                                                local_3 = _e960;
                                                                                local_4 = _e958;
                                                                                local_5 = _e958;
                                                                                local_6 = _e958;
                                                                                local_7 = _e960;
                                                                                local_47 = _e960;
                                                                                if (_e956.member < _e956.member_1) {
                                                                                    phi_1430_ = type_8((_e956.member + 1u), _e956.member_1);
                                                                                    phi_1457_ = type_8(1u, _e956.member);
                                                                                } else {
                                                                                    phi_1430_ = _e956;
                                                                                    phi_1457_ = type_8(0u, type_8().member_1);
                                                                                }
                                                                                let _e973 = phi_1430_;
                                                                                let _e975 = phi_1457_;
                                                                                let _e979 = (bitcast<i32>(_e975.member) != 0i);
                                                                                if _e979 {
                                                                                    if (_e975.member_1 < _e90) {
                                                                                    } else {
                                                                                        phi_4047_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e983 = facets.member[_e975.member_1].member_2;
                                                                                    let _e992 = -((((_e344 * _e983[0]) + (_e345 * _e983[1])) + (_e346 * _e983[2])));
                                                                                    if (_e992 > 0f) {
                                                                                        let _e1014 = (2u * _e975.member_1);
                                                                                        if (_e1014 < _e93) {
                                                                                        } else {
                                                                                            phi_4047_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e1017 = radiance.member[_e1014];
                                                                                        phi_1541_ = _e958;
                                                                                        phi_1542_ = vec4<f32>((_e960.x + (_e1017.x * _e992)), (_e960.y + (_e1017.y * _e992)), (_e960.z + (_e1017.z * _e992)), (_e960.w + _e992));
                                                                                    } else {
                                                                                        let _e995 = ((2u * _e975.member_1) + 1u);
                                                                                        if (_e995 < _e93) {
                                                                                        } else {
                                                                                            phi_4047_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e998 = radiance.member[_e995];
                                                                                        phi_1541_ = vec4<f32>((_e958.x - (_e998.x * _e992)), (_e958.y - (_e998.y * _e992)), (_e958.z - (_e998.z * _e992)), (_e958.w - _e992));
                                                                                        phi_1542_ = _e960;
                                                                                    }
                                                                                    let _e1034 = phi_1541_;
                                                                                    let _e1036 = phi_1542_;
                                                                                    phi_1433_ = _e1034;
                                                                                    phi_1435_ = _e1036;
                                                                                } else {
                                                                                    phi_1433_ = vec4<f32>();
                                                                                    phi_1435_ = vec4<f32>();
                                                                                }
                                                                                let _e1038 = phi_1433_;
                                                                                let _e1040 = phi_1435_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_1429_ = _e973;
                                                                                    phi_1432_ = _e1038;
                                                                                    phi_1434_ = _e1040;
                                                                                    phi_4047_ = _e898;
                                                                                    break if !(_e979);
                                                                                }
                                                                            }
                                                                            let _e1043 = phi_4047_;
                                                                            phi_4059_ = _e1043;
                                                                            if _e1043 {
                                                                                break;
                                                                            }
                                                                            let _e1045 = local_2;
                                                                            let _e1048 = local_3;
                                                                            if (_e1045.w > _e1048.w) {
                                                                                let _e1051 = (_e1045.w - _e1048.w);
                                                                                let _e1052 = (_e1051 / _e1045.w);
                                                                                let _e1054 = local_4;
                                                                                let _e1058 = local_5;
                                                                                let _e1062 = local_6;
                                                                                let _e1067 = local_7;
                                                                                phi_1564_ = (_e1067 + vec4<f32>((_e1054.x * _e1052), (_e1058.y * _e1052), (_e1062.z * _e1052), _e1051));
                                                                            } else {
                                                                                let _e2806 = local_47;
                                                                                phi_1564_ = _e2806;
                                                                            }
                                                                            let _e1070 = phi_1564_;
                                                                            phi_4069_ = _e1043;
                                                                            phi_1565_ = _e1070;
                                                                        }
                                                                        let _e1159 = phi_4069_;
                                                                        let _e1161 = phi_1565_;
                                                                        phi_4063_ = _e1159;
                                                                        phi_1734_ = _e1161;
                                                                    } else {
                                                                        let _e759 = (_e748 + 1u);
                                                                        if (_e759 < _e84) {
                                                                        } else {
                                                                            phi_4059_ = true;
                                                                            break;
                                                                        }
                                                                        let _e762 = cells.member[_e759];
                                                                        let _e768 = (_e762 + countOneBits((_e751 & ((1u << bitcast<u32>(_e753)) - 1u))));
                                                                        let _e771 = params.member.member_7;
                                                                        if (_e771 == 1u) {
                                                                            if ((_e527 & 1u) == 1u) {
                                                                                if (_e768 < _e96) {
                                                                                } else {
                                                                                    phi_4059_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e851 = odd.member[_e768];
                                                                                phi_1612_ = _e851;
                                                                            } else {
                                                                                if (_e768 < _e99) {
                                                                                } else {
                                                                                    phi_4059_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e848 = even.member[_e768];
                                                                                phi_1612_ = _e848;
                                                                            }
                                                                            let _e853 = phi_1612_;
                                                                            phi_1733_ = _e853;
                                                                        } else {
                                                                            let _e773 = (_e768 * 6u);
                                                                            let _e776 = (_e773 + select(0u, 1u, (_e344 < 0f)));
                                                                            let _e778 = ((_e527 & 1u) == 1u);
                                                                            if _e778 {
                                                                                if (_e776 < _e96) {
                                                                                } else {
                                                                                    phi_4059_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e784 = odd.member[_e776];
                                                                                phi_1640_ = _e784;
                                                                            } else {
                                                                                if (_e776 < _e99) {
                                                                                } else {
                                                                                    phi_4059_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e781 = even.member[_e776];
                                                                                phi_1640_ = _e781;
                                                                            }
                                                                            let _e786 = phi_1640_;
                                                                            let _e798 = ((_e773 + 2u) + select(0u, 1u, (_e345 < 0f)));
                                                                            if _e778 {
                                                                                if (_e798 < _e96) {
                                                                                } else {
                                                                                    phi_4059_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e804 = odd.member[_e798];
                                                                                phi_1677_ = _e804;
                                                                            } else {
                                                                                if (_e798 < _e99) {
                                                                                } else {
                                                                                    phi_4059_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e801 = even.member[_e798];
                                                                                phi_1677_ = _e801;
                                                                            }
                                                                            let _e806 = phi_1677_;
                                                                            let _e822 = ((_e773 + 4u) + select(0u, 1u, (_e346 < 0f)));
                                                                            if _e778 {
                                                                                if (_e822 < _e96) {
                                                                                } else {
                                                                                    phi_4059_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e828 = odd.member[_e822];
                                                                                phi_1718_ = _e828;
                                                                            } else {
                                                                                if (_e822 < _e99) {
                                                                                } else {
                                                                                    phi_4059_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e825 = even.member[_e822];
                                                                                phi_1718_ = _e825;
                                                                            }
                                                                            let _e830 = phi_1718_;
                                                                            phi_1733_ = vec4<f32>((((_e786.x * _e367) + (_e806.x * _e377)) + (_e830.x * _e387)), (((_e786.y * _e367) + (_e806.y * _e377)) + (_e830.y * _e387)), (((_e786.z * _e367) + (_e806.z * _e377)) + (_e830.z * _e387)), (((_e786.w * _e367) + (_e806.w * _e377)) + (_e830.w * _e387)));
                                                                        }
                                                                        let _e855 = phi_1733_;
                                                                        phi_4063_ = _e701;
                                                                        phi_1734_ = _e855;
                                                                    }
                                                                    let _e1163 = phi_4063_;
                                                                    let _e1165 = phi_1734_;
                                                                    phi_4062_ = _e1163;
                                                                    phi_1755_ = vec4<f32>((_e705.x + (_e1165.x * _e735)), (_e705.y + (_e1165.y * _e735)), (_e705.z + (_e1165.z * _e735)), (_e705.w + (_e1165.w * _e735)));
                                                                } else {
                                                                    phi_4062_ = _e701;
                                                                    phi_1755_ = _e705;
                                                                }
                                                                let _e1184 = phi_4062_;
                                                                let _e1186 = phi_1755_;
                                                                phi_4061_ = _e1184;
                                                                phi_1756_ = _e1186;
                                                            } else {
                                                                phi_4061_ = _e701;
                                                                phi_1756_ = _e705;
                                                            }
                                                            let _e1188 = phi_4061_;
                                                            let _e1190 = phi_1756_;
                                                            phi_4060_ = _e1188;
                                                            phi_1033_ = _e1190;
                                                        } else {
                                                            phi_4060_ = _e701;
                                                            phi_1033_ = vec4<f32>();
                                                        }
                                                        let _e1192 = phi_4060_;
                                                        let _e1194 = phi_1033_;
                                                        continue;
                                                        continuing {
                                                            phi_3987_ = _e1192;
                                                            phi_1029_ = _e718;
                                                            phi_1032_ = _e1194;
                                                            phi_4059_ = _e1192;
                                                            break if !(_e724);
                                                        }
                                                    }
                                                    let _e1197 = phi_4059_;
                                                    phi_4202_ = _e1197;
                                                    if _e1197 {
                                                        break;
                                                    }
                                                    let _e1199 = local_10;
                                                    let _e1201 = (_e1199.w <= 0f);
                                                    if _e1201 {
                                                        phi_4176_ = _e1197;
                                                        phi_2791_ = vec4<f32>();
                                                    } else {
                                                        if (_e517 < 10u) {
                                                        } else {
                                                            phi_4202_ = true;
                                                            break;
                                                        }
                                                        let _e1206 = params.member.member_2[_e517];
                                                        let _e1207 = (_e520 - 1u);
                                                        let _e1218 = ((_e495 * _e522) - 0.5f);
                                                        let _e1219 = floor(_e1218);
                                                        let _e1220 = (_e1218 - _e1219);
                                                        let _e1227 = select(0i, select(select(i32(_e1219), i32(-2147483648), (_e1219 < -2147483600f)), 2147483647i, (_e1219 > 2147483500f)), (_e1219 == _e1219));
                                                        let _e1229 = (bitcast<i32>(((_e360.x + _e1207) >> bitcast<u32>(_e518))) - 1i);
                                                        if (_e1227 >= 0i) {
                                                            phi_1811_ = (_e1227 <= _e1229);
                                                        } else {
                                                            phi_1811_ = false;
                                                        }
                                                        let _e1233 = phi_1811_;
                                                        if (_e1227 >= -1i) {
                                                            phi_1817_ = (_e1227 < _e1229);
                                                        } else {
                                                            phi_1817_ = false;
                                                        }
                                                        let _e1237 = phi_1817_;
                                                        if _e1233 {
                                                            phi_1822_ = bitcast<u32>(_e1227);
                                                        } else {
                                                            phi_1822_ = 0u;
                                                        }
                                                        let _e1240 = phi_1822_;
                                                        if _e1237 {
                                                            phi_1828_ = bitcast<u32>((_e1227 + 1i));
                                                        } else {
                                                            phi_1828_ = 0u;
                                                        }
                                                        let _e1244 = phi_1828_;
                                                        if _e1233 {
                                                            phi_1867_ = (1f - _e1220);
                                                        } else {
                                                            phi_1867_ = 0f;
                                                        }
                                                        let _e1265 = phi_1867_;
                                                        let _e1268 = ((_e496 * _e522) - 0.5f);
                                                        let _e1270 = floor(_e1268);
                                                        let _e1271 = (_e1268 - _e1270);
                                                        let _e1278 = select(0i, select(select(i32(_e1270), i32(-2147483648), (_e1270 < -2147483600f)), 2147483647i, (_e1270 > 2147483500f)), (_e1270 == _e1270));
                                                        let _e1280 = (bitcast<i32>(((_e360.y + _e1207) >> bitcast<u32>(_e518))) - 1i);
                                                        if (_e1278 >= 0i) {
                                                            phi_1893_ = (_e1278 <= _e1280);
                                                        } else {
                                                            phi_1893_ = false;
                                                        }
                                                        let _e1284 = phi_1893_;
                                                        if (_e1278 >= -1i) {
                                                            phi_1899_ = (_e1278 < _e1280);
                                                        } else {
                                                            phi_1899_ = false;
                                                        }
                                                        let _e1288 = phi_1899_;
                                                        if _e1284 {
                                                            phi_1904_ = bitcast<u32>(_e1278);
                                                        } else {
                                                            phi_1904_ = 0u;
                                                        }
                                                        let _e1291 = phi_1904_;
                                                        if _e1288 {
                                                            phi_1910_ = bitcast<u32>((_e1278 + 1i));
                                                        } else {
                                                            phi_1910_ = 0u;
                                                        }
                                                        let _e1295 = phi_1910_;
                                                        if _e1284 {
                                                            phi_1949_ = (1f - _e1271);
                                                        } else {
                                                            phi_1949_ = 0f;
                                                        }
                                                        let _e1322 = phi_1949_;
                                                        let _e1325 = ((_e497 * _e522) - 0.5f);
                                                        let _e1327 = floor(_e1325);
                                                        let _e1328 = (_e1325 - _e1327);
                                                        let _e1335 = select(0i, select(select(i32(_e1327), i32(-2147483648), (_e1327 < -2147483600f)), 2147483647i, (_e1327 > 2147483500f)), (_e1327 == _e1327));
                                                        let _e1337 = (bitcast<i32>(((_e360.z + _e1207) >> bitcast<u32>(_e518))) - 1i);
                                                        if (_e1335 >= 0i) {
                                                            phi_1975_ = (_e1335 <= _e1337);
                                                        } else {
                                                            phi_1975_ = false;
                                                        }
                                                        let _e1341 = phi_1975_;
                                                        if (_e1335 >= -1i) {
                                                            phi_1981_ = (_e1335 < _e1337);
                                                        } else {
                                                            phi_1981_ = false;
                                                        }
                                                        let _e1345 = phi_1981_;
                                                        if _e1341 {
                                                            phi_1986_ = bitcast<u32>(_e1335);
                                                        } else {
                                                            phi_1986_ = 0u;
                                                        }
                                                        let _e1348 = phi_1986_;
                                                        if _e1345 {
                                                            phi_1992_ = bitcast<u32>((_e1335 + 1i));
                                                        } else {
                                                            phi_1992_ = 0u;
                                                        }
                                                        let _e1352 = phi_1992_;
                                                        if _e1341 {
                                                            phi_2031_ = (1f - _e1328);
                                                        } else {
                                                            phi_2031_ = 0f;
                                                        }
                                                        let _e1367 = phi_2031_;
                                                        phi_4085_ = _e1197;
                                                        phi_2038_ = type_8(0u, 8u);
                                                        phi_2041_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                        loop {
                                                            let _e1370 = phi_4085_;
                                                            let _e1372 = phi_2038_;
                                                            let _e1374 = phi_2041_;
                                                            local_21 = _e1374;
                                                            local_22 = _e1374;
                                                            local_23 = _e1374;
                                                            local_24 = _e1374;
                                                            if (_e1372.member < _e1372.member_1) {
                                                                phi_2039_ = type_8((_e1372.member + 1u), _e1372.member_1);
                                                                phi_2064_ = type_8(1u, _e1372.member);
                                                            } else {
                                                                phi_2039_ = _e1372;
                                                                phi_2064_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1387 = phi_2039_;
                                                            let _e1389 = phi_2064_;
                                                            let _e1393 = (bitcast<i32>(_e1389.member) != 0i);
                                                            if _e1393 {
                                                                let _e1395 = ((_e1389.member_1 & 1u) == 1u);
                                                                let _e1397 = ((_e1389.member_1 & 2u) == 2u);
                                                                let _e1399 = ((_e1389.member_1 & 4u) == 4u);
                                                                let _e1404 = ((select(_e1265, select(0f, _e1220, _e1237), _e1395) * select(_e1322, select(0f, _e1271, _e1288), _e1397)) * select(_e1367, select(0f, _e1328, _e1345), _e1399));
                                                                let _e1411 = (((_e1206.z + select((_e1240 >> bitcast<u32>(2u)), (_e1244 >> bitcast<u32>(2u)), _e1395)) + select(((_e1291 >> bitcast<u32>(2u)) * _e1206.x), ((_e1295 >> bitcast<u32>(2u)) * _e1206.x), _e1397)) + select(((_e1348 >> bitcast<u32>(1u)) * _e1206.y), ((_e1352 >> bitcast<u32>(1u)) * _e1206.y), _e1399));
                                                                let _e1417 = (2u * _e1411);
                                                                if (_e1417 < _e84) {
                                                                } else {
                                                                    phi_4123_ = true;
                                                                    break;
                                                                }
                                                                let _e1420 = cells.member[_e1417];
                                                                if (_e1404 > 0f) {
                                                                    let _e1422 = (((select(((_e1240 & 1u) | (((_e1240 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), ((_e1244 & 1u) | (((_e1244 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), _e1395) | select((((_e1291 & 1u) << bitcast<u32>(1u)) | (((_e1291 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), (((_e1295 & 1u) << bitcast<u32>(1u)) | (((_e1295 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), _e1397)) | select(((_e1348 & 1u) << bitcast<u32>(2u)), ((_e1352 & 1u) << bitcast<u32>(2u)), _e1399)) & 31u);
                                                                    if (((_e1420 >> bitcast<u32>(_e1422)) & 1u) == 1u) {
                                                                        if (_e517 == 0u) {
                                                                            let _e1525 = (_e1411 * 6u);
                                                                            let _e1526 = (_e1417 + 1u);
                                                                            if (_e1526 < _e84) {
                                                                            } else {
                                                                                phi_4123_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1529 = cells.member[_e1526];
                                                                            phi_2163_ = type_8(0u, 6u);
                                                                            phi_2166_ = _e1529;
                                                                            loop {
                                                                                let _e1531 = phi_2163_;
                                                                                let _e1533 = phi_2166_;
                                                                                local_11 = _e1533;
                                                                                local_12 = _e1533;
                                                                                local_19 = _e1533;
                                                                                local_20 = _e1533;
                                                                                if (_e1531.member < _e1531.member_1) {
                                                                                    phi_2164_ = type_8((_e1531.member + 1u), _e1531.member_1);
                                                                                    phi_2189_ = type_8(1u, _e1531.member);
                                                                                } else {
                                                                                    phi_2164_ = _e1531;
                                                                                    phi_2189_ = type_8(0u, type_8().member_1);
                                                                                }
                                                                                let _e1546 = phi_2164_;
                                                                                let _e1548 = phi_2189_;
                                                                                let _e1552 = (bitcast<i32>(_e1548.member) != 0i);
                                                                                if _e1552 {
                                                                                    let _e1553 = (_e1525 + _e1548.member_1);
                                                                                    if (_e1553 < _e87) {
                                                                                    } else {
                                                                                        phi_4071_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1556 = facet_bits.member[_e1553];
                                                                                    phi_2167_ = (_e1533 + countOneBits((_e1556 & ((1u << bitcast<u32>(_e1422)) - 1u))));
                                                                                } else {
                                                                                    phi_2167_ = u32();
                                                                                }
                                                                                let _e1564 = phi_2167_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_2163_ = _e1546;
                                                                                    phi_2166_ = _e1564;
                                                                                    phi_4071_ = _e1370;
                                                                                    break if !(_e1552);
                                                                                }
                                                                            }
                                                                            let _e1567 = phi_4071_;
                                                                            phi_4123_ = _e1567;
                                                                            if _e1567 {
                                                                                break;
                                                                            }
                                                                            if (_e1525 < _e87) {
                                                                            } else {
                                                                                phi_4123_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1570 = facet_bits.member[_e1525];
                                                                            let _e1574 = (_e1525 + 1u);
                                                                            if (_e1574 < _e87) {
                                                                            } else {
                                                                                phi_4123_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1577 = facet_bits.member[_e1574];
                                                                            let _e1582 = (_e1525 + 2u);
                                                                            if (_e1582 < _e87) {
                                                                            } else {
                                                                                phi_4123_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1585 = facet_bits.member[_e1582];
                                                                            let _e1590 = (_e1525 + 3u);
                                                                            if (_e1590 < _e87) {
                                                                            } else {
                                                                                phi_4123_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1593 = facet_bits.member[_e1590];
                                                                            let _e1598 = (_e1525 + 4u);
                                                                            if (_e1598 < _e87) {
                                                                            } else {
                                                                                phi_4123_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1601 = facet_bits.member[_e1598];
                                                                            let _e1606 = (_e1525 + 5u);
                                                                            if (_e1606 < _e87) {
                                                                            } else {
                                                                                phi_4123_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1609 = facet_bits.member[_e1606];
                                                                            let _e1613 = (((((((_e1570 >> bitcast<u32>(_e1422)) & 1u) + ((_e1577 >> bitcast<u32>(_e1422)) & 1u)) + ((_e1585 >> bitcast<u32>(_e1422)) & 1u)) + ((_e1593 >> bitcast<u32>(_e1422)) & 1u)) + ((_e1601 >> bitcast<u32>(_e1422)) & 1u)) + ((_e1609 >> bitcast<u32>(_e1422)) & 1u));
                                                                            let _e1616 = params.member.member_7;
                                                                            if (_e1616 == 1u) {
                                                                                let _e1741 = local_19;
                                                                                let _e1744 = local_20;
                                                                                phi_2306_ = type_8(_e1744, (_e1741 + _e1613));
                                                                                phi_2309_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                                loop {
                                                                                    let _e1747 = phi_2306_;
                                                                                    let _e1749 = phi_2309_;
                                                                                    local_50 = _e1749;
                                                                                    if (_e1747.member < _e1747.member_1) {
                                                                                        phi_2307_ = type_8((_e1747.member + 1u), _e1747.member_1);
                                                                                        phi_2332_ = type_8(1u, _e1747.member);
                                                                                    } else {
                                                                                        phi_2307_ = _e1747;
                                                                                        phi_2332_ = type_8(0u, type_8().member_1);
                                                                                    }
                                                                                    let _e1762 = phi_2307_;
                                                                                    let _e1764 = phi_2332_;
                                                                                    let _e1768 = (bitcast<i32>(_e1764.member) != 0i);
                                                                                    if _e1768 {
                                                                                        let _e1769 = (2u * _e1764.member_1);
                                                                                        if (_e1769 < _e93) {
                                                                                        } else {
                                                                                            phi_4116_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e1773 = radiance.member[_e1769][0u];
                                                                                        let _e1776 = radiance.member[_e1769][1u];
                                                                                        let _e1779 = radiance.member[_e1769][2u];
                                                                                        let _e1780 = (_e1769 + 1u);
                                                                                        if (_e1780 < _e93) {
                                                                                        } else {
                                                                                            phi_4116_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e1784 = radiance.member[_e1780][0u];
                                                                                        let _e1787 = radiance.member[_e1780][1u];
                                                                                        let _e1790 = radiance.member[_e1780][2u];
                                                                                        if (_e1764.member_1 < _e90) {
                                                                                        } else {
                                                                                            phi_4116_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e1800 = facets.member[_e1764.member_1].member_2;
                                                                                        let _e1809 = sqrt((((_e1800[0] * _e1800[0]) + (_e1800[1] * _e1800[1])) + (_e1800[2] * _e1800[2])));
                                                                                        phi_2310_ = vec4<f32>((_e1749.x + (select(_e1784, _e1773, (_e1773 > _e1784)) * _e1809)), (_e1749.y + (select(_e1787, _e1776, (_e1776 > _e1787)) * _e1809)), (_e1749.z + (select(_e1790, _e1779, (_e1779 > _e1790)) * _e1809)), (_e1749.w + _e1809));
                                                                                    } else {
                                                                                        phi_2310_ = vec4<f32>();
                                                                                    }
                                                                                    let _e1823 = phi_2310_;
                                                                                    continue;
                                                                                    continuing {
                                                                                        phi_2306_ = _e1762;
                                                                                        phi_2309_ = _e1823;
                                                                                        phi_4116_ = _e1567;
                                                                                        break if !(_e1768);
                                                                                    }
                                                                                }
                                                                                let _e1826 = phi_4116_;
                                                                                phi_4123_ = _e1826;
                                                                                if _e1826 {
                                                                                    break;
                                                                                }
                                                                                phi_4133_ = _e1826;
                                                                                let _e2892 = local_50;
                                                                                phi_2574_ = _e2892;
                                                                            } else {
                                                                                let _e1619 = local_11;
                                                                                let _e1622 = local_12;
                                                                                phi_2438_ = type_8(_e1622, (_e1619 + _e1613));
                                                                                phi_2441_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                                phi_2443_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                                loop {
                                                                                    let _e1625 = phi_2438_;
                                                                                    let _e1627 = phi_2441_;
                                                                                    let _e1629 = phi_2443_;
                                                                                    local_13 = _e1627;
                                                                                    local_14 = _e1629;
                                                                                    local_15 = _e1627;
                                                                                    local_16 = _e1627;
                                                                                    local_17 = _e1627;
                                                                                    local_18 = _e1629;
                                                                                    local_49 = _e1629;
                                                                                    if (_e1625.member < _e1625.member_1) {
                                                                                        phi_2439_ = type_8((_e1625.member + 1u), _e1625.member_1);
                                                                                        phi_2466_ = type_8(1u, _e1625.member);
                                                                                    } else {
                                                                                        phi_2439_ = _e1625;
                                                                                        phi_2466_ = type_8(0u, type_8().member_1);
                                                                                    }
                                                                                    let _e1642 = phi_2439_;
                                                                                    let _e1644 = phi_2466_;
                                                                                    let _e1648 = (bitcast<i32>(_e1644.member) != 0i);
                                                                                    if _e1648 {
                                                                                        if (_e1644.member_1 < _e90) {
                                                                                        } else {
                                                                                            phi_4111_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e1652 = facets.member[_e1644.member_1].member_2;
                                                                                        let _e1661 = -((((_e344 * _e1652[0]) + (_e345 * _e1652[1])) + (_e346 * _e1652[2])));
                                                                                        if (_e1661 > 0f) {
                                                                                            let _e1683 = (2u * _e1644.member_1);
                                                                                            if (_e1683 < _e93) {
                                                                                            } else {
                                                                                                phi_4111_ = true;
                                                                                                break;
                                                                                            }
                                                                                            let _e1686 = radiance.member[_e1683];
                                                                                            phi_2550_ = _e1627;
                                                                                            phi_2551_ = vec4<f32>((_e1629.x + (_e1686.x * _e1661)), (_e1629.y + (_e1686.y * _e1661)), (_e1629.z + (_e1686.z * _e1661)), (_e1629.w + _e1661));
                                                                                        } else {
                                                                                            let _e1664 = ((2u * _e1644.member_1) + 1u);
                                                                                            if (_e1664 < _e93) {
                                                                                            } else {
                                                                                                phi_4111_ = true;
                                                                                                break;
                                                                                            }
                                                                                            let _e1667 = radiance.member[_e1664];
                                                                                            phi_2550_ = vec4<f32>((_e1627.x - (_e1667.x * _e1661)), (_e1627.y - (_e1667.y * _e1661)), (_e1627.z - (_e1667.z * _e1661)), (_e1627.w - _e1661));
                                                                                            phi_2551_ = _e1629;
                                                                                        }
                                                                                        let _e1703 = phi_2550_;
                                                                                        let _e1705 = phi_2551_;
                                                                                        phi_2442_ = _e1703;
                                                                                        phi_2444_ = _e1705;
                                                                                    } else {
                                                                                        phi_2442_ = vec4<f32>();
                                                                                        phi_2444_ = vec4<f32>();
                                                                                    }
                                                                                    let _e1707 = phi_2442_;
                                                                                    let _e1709 = phi_2444_;
                                                                                    continue;
                                                                                    continuing {
                                                                                        phi_2438_ = _e1642;
                                                                                        phi_2441_ = _e1707;
                                                                                        phi_2443_ = _e1709;
                                                                                        phi_4111_ = _e1567;
                                                                                        break if !(_e1648);
                                                                                    }
                                                                                }
                                                                                let _e1712 = phi_4111_;
                                                                                phi_4123_ = _e1712;
                                                                                if _e1712 {
                                                                                    break;
                                                                                }
                                                                                let _e1714 = local_13;
                                                                                let _e1717 = local_14;
                                                                                if (_e1714.w > _e1717.w) {
                                                                                    let _e1720 = (_e1714.w - _e1717.w);
                                                                                    let _e1721 = (_e1720 / _e1714.w);
                                                                                    let _e1723 = local_15;
                                                                                    let _e1727 = local_16;
                                                                                    let _e1731 = local_17;
                                                                                    let _e1736 = local_18;
                                                                                    phi_2573_ = (_e1736 + vec4<f32>((_e1723.x * _e1721), (_e1727.y * _e1721), (_e1731.z * _e1721), _e1720));
                                                                                } else {
                                                                                    let _e2880 = local_49;
                                                                                    phi_2573_ = _e2880;
                                                                                }
                                                                                let _e1739 = phi_2573_;
                                                                                phi_4133_ = _e1712;
                                                                                phi_2574_ = _e1739;
                                                                            }
                                                                            let _e1828 = phi_4133_;
                                                                            let _e1830 = phi_2574_;
                                                                            phi_4127_ = _e1828;
                                                                            phi_2743_ = _e1830;
                                                                        } else {
                                                                            let _e1428 = (_e1417 + 1u);
                                                                            if (_e1428 < _e84) {
                                                                            } else {
                                                                                phi_4123_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1431 = cells.member[_e1428];
                                                                            let _e1437 = (_e1431 + countOneBits((_e1420 & ((1u << bitcast<u32>(_e1422)) - 1u))));
                                                                            let _e1440 = params.member.member_7;
                                                                            if (_e1440 == 1u) {
                                                                                if ((_e517 & 1u) == 1u) {
                                                                                    if (_e1437 < _e96) {
                                                                                    } else {
                                                                                        phi_4123_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1520 = odd.member[_e1437];
                                                                                    phi_2621_ = _e1520;
                                                                                } else {
                                                                                    if (_e1437 < _e99) {
                                                                                    } else {
                                                                                        phi_4123_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1517 = even.member[_e1437];
                                                                                    phi_2621_ = _e1517;
                                                                                }
                                                                                let _e1522 = phi_2621_;
                                                                                phi_2742_ = _e1522;
                                                                            } else {
                                                                                let _e1442 = (_e1437 * 6u);
                                                                                let _e1445 = (_e1442 + select(0u, 1u, (_e344 < 0f)));
                                                                                let _e1447 = ((_e517 & 1u) == 1u);
                                                                                if _e1447 {
                                                                                    if (_e1445 < _e96) {
                                                                                    } else {
                                                                                        phi_4123_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1453 = odd.member[_e1445];
                                                                                    phi_2649_ = _e1453;
                                                                                } else {
                                                                                    if (_e1445 < _e99) {
                                                                                    } else {
                                                                                        phi_4123_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1450 = even.member[_e1445];
                                                                                    phi_2649_ = _e1450;
                                                                                }
                                                                                let _e1455 = phi_2649_;
                                                                                let _e1467 = ((_e1442 + 2u) + select(0u, 1u, (_e345 < 0f)));
                                                                                if _e1447 {
                                                                                    if (_e1467 < _e96) {
                                                                                    } else {
                                                                                        phi_4123_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1473 = odd.member[_e1467];
                                                                                    phi_2686_ = _e1473;
                                                                                } else {
                                                                                    if (_e1467 < _e99) {
                                                                                    } else {
                                                                                        phi_4123_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1470 = even.member[_e1467];
                                                                                    phi_2686_ = _e1470;
                                                                                }
                                                                                let _e1475 = phi_2686_;
                                                                                let _e1491 = ((_e1442 + 4u) + select(0u, 1u, (_e346 < 0f)));
                                                                                if _e1447 {
                                                                                    if (_e1491 < _e96) {
                                                                                    } else {
                                                                                        phi_4123_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1497 = odd.member[_e1491];
                                                                                    phi_2727_ = _e1497;
                                                                                } else {
                                                                                    if (_e1491 < _e99) {
                                                                                    } else {
                                                                                        phi_4123_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1494 = even.member[_e1491];
                                                                                    phi_2727_ = _e1494;
                                                                                }
                                                                                let _e1499 = phi_2727_;
                                                                                phi_2742_ = vec4<f32>((((_e1455.x * _e367) + (_e1475.x * _e377)) + (_e1499.x * _e387)), (((_e1455.y * _e367) + (_e1475.y * _e377)) + (_e1499.y * _e387)), (((_e1455.z * _e367) + (_e1475.z * _e377)) + (_e1499.z * _e387)), (((_e1455.w * _e367) + (_e1475.w * _e377)) + (_e1499.w * _e387)));
                                                                            }
                                                                            let _e1524 = phi_2742_;
                                                                            phi_4127_ = _e1370;
                                                                            phi_2743_ = _e1524;
                                                                        }
                                                                        let _e1832 = phi_4127_;
                                                                        let _e1834 = phi_2743_;
                                                                        phi_4126_ = _e1832;
                                                                        phi_2764_ = vec4<f32>((_e1374.x + (_e1834.x * _e1404)), (_e1374.y + (_e1834.y * _e1404)), (_e1374.z + (_e1834.z * _e1404)), (_e1374.w + (_e1834.w * _e1404)));
                                                                    } else {
                                                                        phi_4126_ = _e1370;
                                                                        phi_2764_ = _e1374;
                                                                    }
                                                                    let _e1853 = phi_4126_;
                                                                    let _e1855 = phi_2764_;
                                                                    phi_4125_ = _e1853;
                                                                    phi_2765_ = _e1855;
                                                                } else {
                                                                    phi_4125_ = _e1370;
                                                                    phi_2765_ = _e1374;
                                                                }
                                                                let _e1857 = phi_4125_;
                                                                let _e1859 = phi_2765_;
                                                                phi_4124_ = _e1857;
                                                                phi_2042_ = _e1859;
                                                            } else {
                                                                phi_4124_ = _e1370;
                                                                phi_2042_ = vec4<f32>();
                                                            }
                                                            let _e1861 = phi_4124_;
                                                            let _e1863 = phi_2042_;
                                                            continue;
                                                            continuing {
                                                                phi_4085_ = _e1861;
                                                                phi_2038_ = _e1387;
                                                                phi_2041_ = _e1863;
                                                                phi_4123_ = _e1861;
                                                                break if !(_e1393);
                                                            }
                                                        }
                                                        let _e1866 = phi_4123_;
                                                        phi_4202_ = _e1866;
                                                        if _e1866 {
                                                            break;
                                                        }
                                                        let _e1868 = ((2f - _e523) * _e522);
                                                        let _e1870 = local_21;
                                                        let _e1874 = local_22;
                                                        let _e1878 = local_23;
                                                        let _e1882 = local_24;
                                                        let _e1886 = ((_e524 * 0.5f) * _e522);
                                                        let _e1888 = local_25;
                                                        let _e1892 = local_26;
                                                        let _e1896 = local_27;
                                                        phi_4176_ = _e1866;
                                                        phi_2791_ = vec4<f32>(((_e1870.x * _e1868) + (_e1888.x * _e1886)), ((_e1874.y * _e1868) + (_e1892.y * _e1886)), ((_e1878.z * _e1868) + (_e1896.z * _e1886)), ((_e1882.w * _e1868) + (_e1199.w * _e1886)));
                                                    }
                                                    let _e1906 = phi_4176_;
                                                    let _e1908 = phi_2791_;
                                                    phi_4175_ = _e1906;
                                                    phi_2792_ = _e1908;
                                                    phi_2793_ = _e1201;
                                                }
                                                let _e1910 = phi_4175_;
                                                let _e1912 = phi_2792_;
                                                let _e1914 = phi_2793_;
                                                phi_4174_ = _e1910;
                                                phi_2794_ = _e1912;
                                                phi_2795_ = _e526;
                                                phi_2796_ = _e1914;
                                            }
                                            let _e1916 = phi_4174_;
                                            let _e1918 = phi_2794_;
                                            let _e1920 = phi_2795_;
                                            let _e1922 = phi_2796_;
                                            if _e1920 {
                                                if (_e517 < 10u) {
                                                } else {
                                                    phi_4202_ = true;
                                                    break;
                                                }
                                                let _e1927 = params.member.member_2[_e517];
                                                let _e1928 = (_e520 - 1u);
                                                let _e1939 = ((_e495 * _e522) - 0.5f);
                                                let _e1940 = floor(_e1939);
                                                let _e1941 = (_e1939 - _e1940);
                                                let _e1948 = select(0i, select(select(i32(_e1940), i32(-2147483648), (_e1940 < -2147483600f)), 2147483647i, (_e1940 > 2147483500f)), (_e1940 == _e1940));
                                                let _e1950 = (bitcast<i32>(((_e360.x + _e1928) >> bitcast<u32>(_e518))) - 1i);
                                                if (_e1948 >= 0i) {
                                                    phi_2849_ = (_e1948 <= _e1950);
                                                } else {
                                                    phi_2849_ = false;
                                                }
                                                let _e1954 = phi_2849_;
                                                if (_e1948 >= -1i) {
                                                    phi_2855_ = (_e1948 < _e1950);
                                                } else {
                                                    phi_2855_ = false;
                                                }
                                                let _e1958 = phi_2855_;
                                                if _e1954 {
                                                    phi_2860_ = bitcast<u32>(_e1948);
                                                } else {
                                                    phi_2860_ = 0u;
                                                }
                                                let _e1961 = phi_2860_;
                                                if _e1958 {
                                                    phi_2866_ = bitcast<u32>((_e1948 + 1i));
                                                } else {
                                                    phi_2866_ = 0u;
                                                }
                                                let _e1965 = phi_2866_;
                                                if _e1954 {
                                                    phi_2905_ = (1f - _e1941);
                                                } else {
                                                    phi_2905_ = 0f;
                                                }
                                                let _e1986 = phi_2905_;
                                                let _e1989 = ((_e496 * _e522) - 0.5f);
                                                let _e1991 = floor(_e1989);
                                                let _e1992 = (_e1989 - _e1991);
                                                let _e1999 = select(0i, select(select(i32(_e1991), i32(-2147483648), (_e1991 < -2147483600f)), 2147483647i, (_e1991 > 2147483500f)), (_e1991 == _e1991));
                                                let _e2001 = (bitcast<i32>(((_e360.y + _e1928) >> bitcast<u32>(_e518))) - 1i);
                                                if (_e1999 >= 0i) {
                                                    phi_2931_ = (_e1999 <= _e2001);
                                                } else {
                                                    phi_2931_ = false;
                                                }
                                                let _e2005 = phi_2931_;
                                                if (_e1999 >= -1i) {
                                                    phi_2937_ = (_e1999 < _e2001);
                                                } else {
                                                    phi_2937_ = false;
                                                }
                                                let _e2009 = phi_2937_;
                                                if _e2005 {
                                                    phi_2942_ = bitcast<u32>(_e1999);
                                                } else {
                                                    phi_2942_ = 0u;
                                                }
                                                let _e2012 = phi_2942_;
                                                if _e2009 {
                                                    phi_2948_ = bitcast<u32>((_e1999 + 1i));
                                                } else {
                                                    phi_2948_ = 0u;
                                                }
                                                let _e2016 = phi_2948_;
                                                if _e2005 {
                                                    phi_2987_ = (1f - _e1992);
                                                } else {
                                                    phi_2987_ = 0f;
                                                }
                                                let _e2043 = phi_2987_;
                                                let _e2046 = ((_e497 * _e522) - 0.5f);
                                                let _e2048 = floor(_e2046);
                                                let _e2049 = (_e2046 - _e2048);
                                                let _e2056 = select(0i, select(select(i32(_e2048), i32(-2147483648), (_e2048 < -2147483600f)), 2147483647i, (_e2048 > 2147483500f)), (_e2048 == _e2048));
                                                let _e2058 = (bitcast<i32>(((_e360.z + _e1928) >> bitcast<u32>(_e518))) - 1i);
                                                if (_e2056 >= 0i) {
                                                    phi_3013_ = (_e2056 <= _e2058);
                                                } else {
                                                    phi_3013_ = false;
                                                }
                                                let _e2062 = phi_3013_;
                                                if (_e2056 >= -1i) {
                                                    phi_3019_ = (_e2056 < _e2058);
                                                } else {
                                                    phi_3019_ = false;
                                                }
                                                let _e2066 = phi_3019_;
                                                if _e2062 {
                                                    phi_3024_ = bitcast<u32>(_e2056);
                                                } else {
                                                    phi_3024_ = 0u;
                                                }
                                                let _e2069 = phi_3024_;
                                                if _e2066 {
                                                    phi_3030_ = bitcast<u32>((_e2056 + 1i));
                                                } else {
                                                    phi_3030_ = 0u;
                                                }
                                                let _e2073 = phi_3030_;
                                                if _e2062 {
                                                    phi_3069_ = (1f - _e2049);
                                                } else {
                                                    phi_3069_ = 0f;
                                                }
                                                let _e2088 = phi_3069_;
                                                phi_4149_ = _e1916;
                                                phi_3076_ = type_8(0u, 8u);
                                                phi_3079_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                loop {
                                                    let _e2091 = phi_4149_;
                                                    let _e2093 = phi_3076_;
                                                    let _e2095 = phi_3079_;
                                                    local_38 = _e2095;
                                                    if (_e2093.member < _e2093.member_1) {
                                                        phi_3077_ = type_8((_e2093.member + 1u), _e2093.member_1);
                                                        phi_3102_ = type_8(1u, _e2093.member);
                                                    } else {
                                                        phi_3077_ = _e2093;
                                                        phi_3102_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e2108 = phi_3077_;
                                                    let _e2110 = phi_3102_;
                                                    let _e2114 = (bitcast<i32>(_e2110.member) != 0i);
                                                    if _e2114 {
                                                        let _e2116 = ((_e2110.member_1 & 1u) == 1u);
                                                        let _e2118 = ((_e2110.member_1 & 2u) == 2u);
                                                        let _e2120 = ((_e2110.member_1 & 4u) == 4u);
                                                        let _e2125 = ((select(_e1986, select(0f, _e1941, _e1958), _e2116) * select(_e2043, select(0f, _e1992, _e2009), _e2118)) * select(_e2088, select(0f, _e2049, _e2066), _e2120));
                                                        let _e2132 = (((_e1927.z + select((_e1961 >> bitcast<u32>(2u)), (_e1965 >> bitcast<u32>(2u)), _e2116)) + select(((_e2012 >> bitcast<u32>(2u)) * _e1927.x), ((_e2016 >> bitcast<u32>(2u)) * _e1927.x), _e2118)) + select(((_e2069 >> bitcast<u32>(1u)) * _e1927.y), ((_e2073 >> bitcast<u32>(1u)) * _e1927.y), _e2120));
                                                        let _e2138 = (2u * _e2132);
                                                        if (_e2138 < _e84) {
                                                        } else {
                                                            phi_4190_ = true;
                                                            break;
                                                        }
                                                        let _e2141 = cells.member[_e2138];
                                                        if (_e2125 > 0f) {
                                                            let _e2143 = (((select(((_e1961 & 1u) | (((_e1961 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), ((_e1965 & 1u) | (((_e1965 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), _e2116) | select((((_e2012 & 1u) << bitcast<u32>(1u)) | (((_e2012 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), (((_e2016 & 1u) << bitcast<u32>(1u)) | (((_e2016 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), _e2118)) | select(((_e2069 & 1u) << bitcast<u32>(2u)), ((_e2073 & 1u) << bitcast<u32>(2u)), _e2120)) & 31u);
                                                            if (((_e2141 >> bitcast<u32>(_e2143)) & 1u) == 1u) {
                                                                if (_e517 == 0u) {
                                                                    let _e2246 = (_e2132 * 6u);
                                                                    let _e2247 = (_e2138 + 1u);
                                                                    if (_e2247 < _e84) {
                                                                    } else {
                                                                        phi_4190_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2250 = cells.member[_e2247];
                                                                    phi_3201_ = type_8(0u, 6u);
                                                                    phi_3204_ = _e2250;
                                                                    loop {
                                                                        let _e2252 = phi_3201_;
                                                                        let _e2254 = phi_3204_;
                                                                        local_28 = _e2254;
                                                                        local_29 = _e2254;
                                                                        local_36 = _e2254;
                                                                        local_37 = _e2254;
                                                                        if (_e2252.member < _e2252.member_1) {
                                                                            phi_3202_ = type_8((_e2252.member + 1u), _e2252.member_1);
                                                                            phi_3227_ = type_8(1u, _e2252.member);
                                                                        } else {
                                                                            phi_3202_ = _e2252;
                                                                            phi_3227_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e2267 = phi_3202_;
                                                                        let _e2269 = phi_3227_;
                                                                        let _e2273 = (bitcast<i32>(_e2269.member) != 0i);
                                                                        if _e2273 {
                                                                            let _e2274 = (_e2246 + _e2269.member_1);
                                                                            if (_e2274 < _e87) {
                                                                            } else {
                                                                                phi_4135_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2277 = facet_bits.member[_e2274];
                                                                            phi_3205_ = (_e2254 + countOneBits((_e2277 & ((1u << bitcast<u32>(_e2143)) - 1u))));
                                                                        } else {
                                                                            phi_3205_ = u32();
                                                                        }
                                                                        let _e2285 = phi_3205_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_3201_ = _e2267;
                                                                            phi_3204_ = _e2285;
                                                                            phi_4135_ = _e2091;
                                                                            break if !(_e2273);
                                                                        }
                                                                    }
                                                                    let _e2288 = phi_4135_;
                                                                    phi_4190_ = _e2288;
                                                                    if _e2288 {
                                                                        break;
                                                                    }
                                                                    if (_e2246 < _e87) {
                                                                    } else {
                                                                        phi_4190_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2291 = facet_bits.member[_e2246];
                                                                    let _e2295 = (_e2246 + 1u);
                                                                    if (_e2295 < _e87) {
                                                                    } else {
                                                                        phi_4190_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2298 = facet_bits.member[_e2295];
                                                                    let _e2303 = (_e2246 + 2u);
                                                                    if (_e2303 < _e87) {
                                                                    } else {
                                                                        phi_4190_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2306 = facet_bits.member[_e2303];
                                                                    let _e2311 = (_e2246 + 3u);
                                                                    if (_e2311 < _e87) {
                                                                    } else {
                                                                        phi_4190_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2314 = facet_bits.member[_e2311];
                                                                    let _e2319 = (_e2246 + 4u);
                                                                    if (_e2319 < _e87) {
                                                                    } else {
                                                                        phi_4190_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2322 = facet_bits.member[_e2319];
                                                                    let _e2327 = (_e2246 + 5u);
                                                                    if (_e2327 < _e87) {
                                                                    } else {
                                                                        phi_4190_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2330 = facet_bits.member[_e2327];
                                                                    let _e2334 = (((((((_e2291 >> bitcast<u32>(_e2143)) & 1u) + ((_e2298 >> bitcast<u32>(_e2143)) & 1u)) + ((_e2306 >> bitcast<u32>(_e2143)) & 1u)) + ((_e2314 >> bitcast<u32>(_e2143)) & 1u)) + ((_e2322 >> bitcast<u32>(_e2143)) & 1u)) + ((_e2330 >> bitcast<u32>(_e2143)) & 1u));
                                                                    let _e2337 = params.member.member_7;
                                                                    if (_e2337 == 1u) {
                                                                        let _e2462 = local_36;
                                                                        let _e2465 = local_37;
                                                                        phi_3344_ = type_8(_e2465, (_e2462 + _e2334));
                                                                        phi_3347_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e2468 = phi_3344_;
                                                                            let _e2470 = phi_3347_;
                                                                            local_52 = _e2470;
                                                                            if (_e2468.member < _e2468.member_1) {
                                                                                phi_3345_ = type_8((_e2468.member + 1u), _e2468.member_1);
                                                                                phi_3370_ = type_8(1u, _e2468.member);
                                                                            } else {
                                                                                phi_3345_ = _e2468;
                                                                                phi_3370_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e2483 = phi_3345_;
                                                                            let _e2485 = phi_3370_;
                                                                            let _e2489 = (bitcast<i32>(_e2485.member) != 0i);
                                                                            if _e2489 {
                                                                                let _e2490 = (2u * _e2485.member_1);
                                                                                if (_e2490 < _e93) {
                                                                                } else {
                                                                                    phi_4183_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e2494 = radiance.member[_e2490][0u];
                                                                                let _e2497 = radiance.member[_e2490][1u];
                                                                                let _e2500 = radiance.member[_e2490][2u];
                                                                                let _e2501 = (_e2490 + 1u);
                                                                                if (_e2501 < _e93) {
                                                                                } else {
                                                                                    phi_4183_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e2505 = radiance.member[_e2501][0u];
                                                                                let _e2508 = radiance.member[_e2501][1u];
                                                                                let _e2511 = radiance.member[_e2501][2u];
                                                                                if (_e2485.member_1 < _e90) {
                                                                                } else {
                                                                                    phi_4183_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e2521 = facets.member[_e2485.member_1].member_2;
                                                                                let _e2530 = sqrt((((_e2521[0] * _e2521[0]) + (_e2521[1] * _e2521[1])) + (_e2521[2] * _e2521[2])));
                                                                                phi_3348_ = vec4<f32>((_e2470.x + (select(_e2505, _e2494, (_e2494 > _e2505)) * _e2530)), (_e2470.y + (select(_e2508, _e2497, (_e2497 > _e2508)) * _e2530)), (_e2470.z + (select(_e2511, _e2500, (_e2500 > _e2511)) * _e2530)), (_e2470.w + _e2530));
                                                                            } else {
                                                                                phi_3348_ = vec4<f32>();
                                                                            }
                                                                            let _e2544 = phi_3348_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_3344_ = _e2483;
                                                                                phi_3347_ = _e2544;
                                                                                phi_4183_ = _e2288;
                                                                                break if !(_e2489);
                                                                            }
                                                                        }
                                                                        let _e2547 = phi_4183_;
                                                                        phi_4190_ = _e2547;
                                                                        if _e2547 {
                                                                            break;
                                                                        }
                                                                        phi_4200_ = _e2547;
                                                                        let _e2981 = local_52;
                                                                        phi_3612_ = _e2981;
                                                                    } else {
                                                                        let _e2340 = local_28;
                                                                        let _e2343 = local_29;
                                                                        phi_3476_ = type_8(_e2343, (_e2340 + _e2334));
                                                                        phi_3479_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        phi_3481_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e2346 = phi_3476_;
                                                                            let _e2348 = phi_3479_;
                                                                            let _e2350 = phi_3481_;
                                                                            local_30 = _e2348;
                                                                            local_31 = _e2350;
                                                                            local_32 = _e2348;
                                                                            local_33 = _e2348;
                                                                            local_34 = _e2348;
                                                                            local_35 = _e2350;
                                                                            local_51 = _e2350;
                                                                            if (_e2346.member < _e2346.member_1) {
                                                                                phi_3477_ = type_8((_e2346.member + 1u), _e2346.member_1);
                                                                                phi_3504_ = type_8(1u, _e2346.member);
                                                                            } else {
                                                                                phi_3477_ = _e2346;
                                                                                phi_3504_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e2363 = phi_3477_;
                                                                            let _e2365 = phi_3504_;
                                                                            let _e2369 = (bitcast<i32>(_e2365.member) != 0i);
                                                                            if _e2369 {
                                                                                if (_e2365.member_1 < _e90) {
                                                                                } else {
                                                                                    phi_4178_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e2373 = facets.member[_e2365.member_1].member_2;
                                                                                let _e2382 = -((((_e344 * _e2373[0]) + (_e345 * _e2373[1])) + (_e346 * _e2373[2])));
                                                                                if (_e2382 > 0f) {
                                                                                    let _e2404 = (2u * _e2365.member_1);
                                                                                    if (_e2404 < _e93) {
                                                                                    } else {
                                                                                        phi_4178_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e2407 = radiance.member[_e2404];
                                                                                    phi_3588_ = _e2348;
                                                                                    phi_3589_ = vec4<f32>((_e2350.x + (_e2407.x * _e2382)), (_e2350.y + (_e2407.y * _e2382)), (_e2350.z + (_e2407.z * _e2382)), (_e2350.w + _e2382));
                                                                                } else {
                                                                                    let _e2385 = ((2u * _e2365.member_1) + 1u);
                                                                                    if (_e2385 < _e93) {
                                                                                    } else {
                                                                                        phi_4178_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e2388 = radiance.member[_e2385];
                                                                                    phi_3588_ = vec4<f32>((_e2348.x - (_e2388.x * _e2382)), (_e2348.y - (_e2388.y * _e2382)), (_e2348.z - (_e2388.z * _e2382)), (_e2348.w - _e2382));
                                                                                    phi_3589_ = _e2350;
                                                                                }
                                                                                let _e2424 = phi_3588_;
                                                                                let _e2426 = phi_3589_;
                                                                                phi_3480_ = _e2424;
                                                                                phi_3482_ = _e2426;
                                                                            } else {
                                                                                phi_3480_ = vec4<f32>();
                                                                                phi_3482_ = vec4<f32>();
                                                                            }
                                                                            let _e2428 = phi_3480_;
                                                                            let _e2430 = phi_3482_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_3476_ = _e2363;
                                                                                phi_3479_ = _e2428;
                                                                                phi_3481_ = _e2430;
                                                                                phi_4178_ = _e2288;
                                                                                break if !(_e2369);
                                                                            }
                                                                        }
                                                                        let _e2433 = phi_4178_;
                                                                        phi_4190_ = _e2433;
                                                                        if _e2433 {
                                                                            break;
                                                                        }
                                                                        let _e2435 = local_30;
                                                                        let _e2438 = local_31;
                                                                        if (_e2435.w > _e2438.w) {
                                                                            let _e2441 = (_e2435.w - _e2438.w);
                                                                            let _e2442 = (_e2441 / _e2435.w);
                                                                            let _e2444 = local_32;
                                                                            let _e2448 = local_33;
                                                                            let _e2452 = local_34;
                                                                            let _e2457 = local_35;
                                                                            phi_3611_ = (_e2457 + vec4<f32>((_e2444.x * _e2442), (_e2448.y * _e2442), (_e2452.z * _e2442), _e2441));
                                                                        } else {
                                                                            let _e2969 = local_51;
                                                                            phi_3611_ = _e2969;
                                                                        }
                                                                        let _e2460 = phi_3611_;
                                                                        phi_4200_ = _e2433;
                                                                        phi_3612_ = _e2460;
                                                                    }
                                                                    let _e2549 = phi_4200_;
                                                                    let _e2551 = phi_3612_;
                                                                    phi_4194_ = _e2549;
                                                                    phi_3781_ = _e2551;
                                                                } else {
                                                                    let _e2149 = (_e2138 + 1u);
                                                                    if (_e2149 < _e84) {
                                                                    } else {
                                                                        phi_4190_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2152 = cells.member[_e2149];
                                                                    let _e2158 = (_e2152 + countOneBits((_e2141 & ((1u << bitcast<u32>(_e2143)) - 1u))));
                                                                    let _e2161 = params.member.member_7;
                                                                    if (_e2161 == 1u) {
                                                                        if ((_e517 & 1u) == 1u) {
                                                                            if (_e2158 < _e96) {
                                                                            } else {
                                                                                phi_4190_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2241 = odd.member[_e2158];
                                                                            phi_3659_ = _e2241;
                                                                        } else {
                                                                            if (_e2158 < _e99) {
                                                                            } else {
                                                                                phi_4190_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2238 = even.member[_e2158];
                                                                            phi_3659_ = _e2238;
                                                                        }
                                                                        let _e2243 = phi_3659_;
                                                                        phi_3780_ = _e2243;
                                                                    } else {
                                                                        let _e2163 = (_e2158 * 6u);
                                                                        let _e2166 = (_e2163 + select(0u, 1u, (_e344 < 0f)));
                                                                        let _e2168 = ((_e517 & 1u) == 1u);
                                                                        if _e2168 {
                                                                            if (_e2166 < _e96) {
                                                                            } else {
                                                                                phi_4190_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2174 = odd.member[_e2166];
                                                                            phi_3687_ = _e2174;
                                                                        } else {
                                                                            if (_e2166 < _e99) {
                                                                            } else {
                                                                                phi_4190_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2171 = even.member[_e2166];
                                                                            phi_3687_ = _e2171;
                                                                        }
                                                                        let _e2176 = phi_3687_;
                                                                        let _e2188 = ((_e2163 + 2u) + select(0u, 1u, (_e345 < 0f)));
                                                                        if _e2168 {
                                                                            if (_e2188 < _e96) {
                                                                            } else {
                                                                                phi_4190_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2194 = odd.member[_e2188];
                                                                            phi_3724_ = _e2194;
                                                                        } else {
                                                                            if (_e2188 < _e99) {
                                                                            } else {
                                                                                phi_4190_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2191 = even.member[_e2188];
                                                                            phi_3724_ = _e2191;
                                                                        }
                                                                        let _e2196 = phi_3724_;
                                                                        let _e2212 = ((_e2163 + 4u) + select(0u, 1u, (_e346 < 0f)));
                                                                        if _e2168 {
                                                                            if (_e2212 < _e96) {
                                                                            } else {
                                                                                phi_4190_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2218 = odd.member[_e2212];
                                                                            phi_3765_ = _e2218;
                                                                        } else {
                                                                            if (_e2212 < _e99) {
                                                                            } else {
                                                                                phi_4190_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2215 = even.member[_e2212];
                                                                            phi_3765_ = _e2215;
                                                                        }
                                                                        let _e2220 = phi_3765_;
                                                                        phi_3780_ = vec4<f32>((((_e2176.x * _e367) + (_e2196.x * _e377)) + (_e2220.x * _e387)), (((_e2176.y * _e367) + (_e2196.y * _e377)) + (_e2220.y * _e387)), (((_e2176.z * _e367) + (_e2196.z * _e377)) + (_e2220.z * _e387)), (((_e2176.w * _e367) + (_e2196.w * _e377)) + (_e2220.w * _e387)));
                                                                    }
                                                                    let _e2245 = phi_3780_;
                                                                    phi_4194_ = _e2091;
                                                                    phi_3781_ = _e2245;
                                                                }
                                                                let _e2553 = phi_4194_;
                                                                let _e2555 = phi_3781_;
                                                                phi_4193_ = _e2553;
                                                                phi_3802_ = vec4<f32>((_e2095.x + (_e2555.x * _e2125)), (_e2095.y + (_e2555.y * _e2125)), (_e2095.z + (_e2555.z * _e2125)), (_e2095.w + (_e2555.w * _e2125)));
                                                            } else {
                                                                phi_4193_ = _e2091;
                                                                phi_3802_ = _e2095;
                                                            }
                                                            let _e2574 = phi_4193_;
                                                            let _e2576 = phi_3802_;
                                                            phi_4192_ = _e2574;
                                                            phi_3803_ = _e2576;
                                                        } else {
                                                            phi_4192_ = _e2091;
                                                            phi_3803_ = _e2095;
                                                        }
                                                        let _e2578 = phi_4192_;
                                                        let _e2580 = phi_3803_;
                                                        phi_4191_ = _e2578;
                                                        phi_3080_ = _e2580;
                                                    } else {
                                                        phi_4191_ = _e2091;
                                                        phi_3080_ = vec4<f32>();
                                                    }
                                                    let _e2582 = phi_4191_;
                                                    let _e2584 = phi_3080_;
                                                    continue;
                                                    continuing {
                                                        phi_4149_ = _e2582;
                                                        phi_3076_ = _e2108;
                                                        phi_3079_ = _e2584;
                                                        phi_4190_ = _e2582;
                                                        break if !(_e2114);
                                                    }
                                                }
                                                let _e2587 = phi_4190_;
                                                phi_4202_ = _e2587;
                                                if _e2587 {
                                                    break;
                                                }
                                                let _e2589 = local_38;
                                                phi_4208_ = _e2587;
                                                phi_3805_ = (_e2589 * _e522);
                                            } else {
                                                phi_4208_ = _e1916;
                                                phi_3805_ = vec4<f32>(0f, 0f, 0f, 0f);
                                            }
                                            let _e2592 = phi_4208_;
                                            let _e2594 = phi_3805_;
                                            let _e2597 = select(_e1918, _e2594, vec4(select(_e1922, true, _e1920)));
                                            let _e2599 = (_e2597.w * _e489);
                                            let _e2600 = (_e2599 > 0f);
                                            if _e2600 {
                                                let _e2602 = select(_e479, _e2599, (_e2599 < _e479));
                                                let _e2608 = (((_e489 * _e459) * _e2602) / _e2599);
                                                phi_3844_ = vec3<f32>((_e453.x + (_e2597.x * _e2608)), (_e453.y + (_e2597.y * _e2608)), (_e453.z + (_e2597.z * _e2608)));
                                                phi_3845_ = (_e457 + _e2602);
                                            } else {
                                                phi_3844_ = _e453;
                                                phi_3845_ = 0f;
                                            }
                                            let _e2621 = phi_3844_;
                                            let _e2623 = phi_3845_;
                                            phi_4205_ = _e2592;
                                            phi_3848_ = _e2621;
                                            phi_3849_ = (_e455 + _e489);
                                            phi_3850_ = _e2623;
                                            phi_3851_ = select(_e480, _e459, _e2600);
                                        }
                                        let _e2627 = phi_4205_;
                                        let _e2629 = phi_3848_;
                                        let _e2631 = phi_3849_;
                                        let _e2633 = phi_3850_;
                                        let _e2635 = phi_3851_;
                                        phi_4204_ = _e2627;
                                        phi_3853_ = _e2629;
                                        phi_3854_ = _e2631;
                                        phi_3855_ = _e2633;
                                        phi_3856_ = _e2635;
                                        phi_3857_ = select(true, false, _e481);
                                    }
                                    let _e2638 = phi_4204_;
                                    let _e2640 = phi_3853_;
                                    let _e2642 = phi_3854_;
                                    let _e2644 = phi_3855_;
                                    let _e2646 = phi_3856_;
                                    let _e2648 = phi_3857_;
                                    phi_4203_ = _e2638;
                                    phi_639_ = _e2640;
                                    phi_641_ = _e2642;
                                    phi_643_ = _e2644;
                                    phi_645_ = _e2646;
                                    phi_3859_ = _e2648;
                                } else {
                                    phi_4203_ = _e449;
                                    phi_639_ = vec3<f32>();
                                    phi_641_ = f32();
                                    phi_643_ = f32();
                                    phi_645_ = f32();
                                    phi_3859_ = false;
                                }
                                let _e2650 = phi_4203_;
                                let _e2652 = phi_639_;
                                let _e2654 = phi_641_;
                                let _e2656 = phi_643_;
                                let _e2658 = phi_645_;
                                let _e2660 = phi_3859_;
                                continue;
                                continuing {
                                    phi_4018_ = _e2650;
                                    phi_635_ = _e472;
                                    phi_638_ = _e2652;
                                    phi_640_ = _e2654;
                                    phi_642_ = _e2656;
                                    phi_644_ = _e2658;
                                    phi_4202_ = _e2650;
                                    break if !(_e2660);
                                }
                            }
                            let _e2663 = phi_4202_;
                            phi_4210_ = _e2663;
                            if _e2663 {
                                break;
                            }
                            let _e2665 = local_39;
                            let _e2668 = local_40;
                            let _e2669 = (_e2668 * (1f - _e2665));
                            let _e2671 = local_41;
                            let _e2674 = local_42;
                            let _e2677 = local_43;
                            let _e2681 = params.member.member_4;
                            phi_4211_ = _e2663;
                            phi_407_ = vec3<f32>((_e291.x + ((_e2671.x + (_e2681.x * _e2669)) * _e331)), (_e291.y + ((_e2674.y + (_e2681.y * _e2669)) * _e331)), (_e291.z + ((_e2677.z + (_e2681.z * _e2669)) * _e331)));
                        } else {
                            phi_4211_ = _e287;
                            phi_407_ = vec3<f32>();
                        }
                        let _e2702 = phi_4211_;
                        let _e2704 = phi_407_;
                        continue;
                        continuing {
                            phi_4040_ = _e2702;
                            phi_403_ = _e304;
                            phi_406_ = _e2704;
                            phi_4210_ = _e2702;
                            break if !(_e310);
                        }
                    }
                    let _e2707 = phi_4210_;
                    if _e2707 {
                        break;
                    }
                    let _e2709 = local_44;
                    let _e2713 = local_45;
                    let _e2717 = local_46;
                    phi_3904_ = vec4<f32>((_e2709.x * 3.1415927f), (_e2713.y * 3.1415927f), (_e2717.z * 3.1415927f), 0f);
                }
                let _e2722 = phi_3904_;
                if (_e110 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e110] = _e2722;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn cone_gather(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
