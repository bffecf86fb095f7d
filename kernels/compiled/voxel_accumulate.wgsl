struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
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

struct type_34 {
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

struct type_35 {
    member: type_34,
}

struct type_37 {
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

struct type_38 {
    member: type_37,
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

struct type_40 {
    member: f32,
    member_1: f32,
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
var<uniform> params: type_35;
@group(0) @binding(1) 
var<storage> triangles: type_19;
@group(0) @binding(2) 
var<storage> attributes: type_25;
@group(0) @binding(3) 
var<storage> surfaces: type_11;
@group(0) @binding(4) 
var<storage> tile_first: type_11;
@group(0) @binding(5) 
var<storage> cells: type_11;
@group(0) @binding(6) 
var<storage> facet_bits: type_11;
@group(0) @binding(7) 
var<storage, read_write> sums: type_48;

fn function_() {
    var local: array<vec3<f32>, 10>;
    var local_1: array<vec3<f32>, 10>;
    var local_2: array<vec3<f32>, 10>;
    var local_3: array<vec3<f32>, 10>;
    var local_4: array<vec3<f32>, 10>;
    var local_5: array<vec3<f32>, 10>;
    var local_6: type_43;
    var phi_712_: u32;
    var phi_715_: u32;
    var phi_713_: u32;
    var phi_716_: u32;
    var phi_5367_: bool;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_829_: bool;
    var phi_838_: u32;
    var phi_858_: vec3<f32>;
    var phi_859_: vec3<f32>;
    var phi_870_: vec3<f32>;
    var phi_871_: vec3<f32>;
    var phi_882_: vec3<f32>;
    var phi_883_: vec3<f32>;
    var phi_894_: vec3<f32>;
    var phi_895_: vec3<f32>;
    var phi_1031_: bool;
    var phi_1040_: u32;
    var phi_1050_: f32;
    var phi_1070_: vec3<f32>;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var phi_1194_: u32;
    var phi_4732_: bool;
    var phi_4771_: bool;
    var phi_4810_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1392_: bool;
    var phi_1401_: type_38;
    var phi_5763_: bool;
    var phi_5381_: i32;
    var phi_5378_: i32;
    var phi_5375_: i32;
    var phi_5372_: i32;
    var phi_5380_: i32;
    var phi_5377_: i32;
    var phi_5374_: i32;
    var phi_5371_: i32;
    var phi_5373_: i32;
    var phi_1621_: bool;
    var phi_1651_: bool;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_1718_: bool;
    var phi_1748_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1815_: bool;
    var phi_1845_: bool;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1877_: bool;
    var phi_1878_: bool;
    var phi_1910_: bool;
    var phi_1920_: vec3<f32>;
    var phi_1921_: vec3<f32>;
    var phi_1973_: bool;
    var phi_1982_: vec3<f32>;
    var phi_2023_: bool;
    var phi_2024_: bool;
    var phi_2025_: bool;
    var phi_2026_: bool;
    var phi_2027_: bool;
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
    var phi_2045_: bool;
    var phi_2046_: bool;
    var phi_2047_: bool;
    var phi_5671_: i32;
    var phi_2060_: bool;
    var local_14: bool;
    var phi_5530_: i32;
    var phi_2113_: vec3<f32>;
    var phi_2114_: vec3<f32>;
    var phi_4860_: type_40;
    var phi_4863_: type_40;
    var phi_4864_: bool;
    var phi_4869_: type_40;
    var phi_4871_: type_40;
    var phi_4907_: type_40;
    var phi_4910_: type_40;
    var phi_4911_: bool;
    var phi_4916_: type_40;
    var phi_4918_: type_40;
    var phi_4966_: type_40;
    var phi_5015_: type_40;
    var phi_5018_: type_40;
    var phi_5019_: bool;
    var phi_5024_: type_40;
    var phi_5026_: type_40;
    var phi_5062_: type_40;
    var phi_5065_: type_40;
    var phi_5066_: bool;
    var phi_5071_: type_40;
    var phi_5073_: type_40;
    var phi_5121_: type_40;
    var phi_5170_: type_40;
    var phi_5173_: type_40;
    var phi_5174_: bool;
    var phi_5179_: type_40;
    var phi_5181_: type_40;
    var phi_5217_: type_40;
    var phi_5220_: type_40;
    var phi_5221_: bool;
    var phi_5226_: type_40;
    var phi_5228_: type_40;
    var phi_5276_: type_40;
    var phi_2156_: type_40;
    var phi_6382_: i32;
    var phi_5670_: i32;
    var phi_5646_: i32;
    var phi_5616_: i32;
    var phi_6381_: i32;
    var phi_5669_: i32;
    var phi_5645_: i32;
    var phi_5615_: i32;
    var phi_2196_: bool;
    var local_15: bool;
    var local_16: i32;
    var local_17: i32;
    var local_18: i32;
    var phi_2226_: u32;
    var phi_2237_: vec3<f32>;
    var phi_2238_: vec3<f32>;
    var phi_2296_: type_8;
    var phi_2299_: f32;
    var phi_2297_: type_8;
    var phi_2322_: type_8;
    var phi_2300_: f32;
    var phi_5752_: bool;
    var local_19: f32;
    var phi_2400_: type_8;
    var phi_2403_: f32;
    var phi_2405_: vec3<f32>;
    var phi_2407_: u32;
    var phi_2401_: type_8;
    var phi_2430_: type_8;
    var phi_2490_: u32;
    var phi_2491_: u32;
    var phi_2507_: u32;
    var phi_2508_: u32;
    var phi_2404_: f32;
    var phi_2406_: vec3<f32>;
    var phi_2408_: u32;
    var phi_5962_: bool;
    var local_20: u32;
    var phi_5975_: bool;
    var phi_5974_: bool;
    var phi_2521_: type_8;
    var phi_2524_: f32;
    var phi_2522_: type_8;
    var phi_2547_: type_8;
    var phi_2525_: f32;
    var phi_5970_: bool;
    var local_21: f32;
    var phi_2619_: type_8;
    var phi_2622_: f32;
    var phi_2624_: vec3<f32>;
    var phi_2626_: u32;
    var phi_2620_: type_8;
    var phi_2649_: type_8;
    var phi_2706_: u32;
    var phi_2707_: u32;
    var phi_2723_: u32;
    var phi_2724_: u32;
    var phi_2623_: f32;
    var phi_2625_: vec3<f32>;
    var phi_2627_: u32;
    var phi_5977_: bool;
    var local_22: u32;
    var phi_5990_: bool;
    var phi_5989_: bool;
    var phi_2731_: type_8;
    var phi_2734_: f32;
    var phi_2732_: type_8;
    var phi_2757_: type_8;
    var phi_2735_: f32;
    var phi_5985_: bool;
    var local_23: f32;
    var phi_2835_: type_8;
    var phi_2838_: f32;
    var phi_2840_: vec3<f32>;
    var phi_2842_: u32;
    var phi_2836_: type_8;
    var phi_2865_: type_8;
    var phi_2925_: u32;
    var phi_2926_: u32;
    var phi_2942_: u32;
    var phi_2943_: u32;
    var phi_2839_: f32;
    var phi_2841_: vec3<f32>;
    var phi_2843_: u32;
    var phi_5992_: bool;
    var local_24: u32;
    var phi_6005_: bool;
    var phi_6004_: bool;
    var phi_2956_: type_8;
    var phi_2959_: f32;
    var phi_2957_: type_8;
    var phi_2982_: type_8;
    var phi_2960_: f32;
    var phi_6000_: bool;
    var local_25: f32;
    var phi_3054_: type_8;
    var phi_3057_: f32;
    var phi_3059_: vec3<f32>;
    var phi_3061_: u32;
    var phi_3055_: type_8;
    var phi_3084_: type_8;
    var phi_3141_: u32;
    var phi_3142_: u32;
    var phi_3158_: u32;
    var phi_3159_: u32;
    var phi_3058_: f32;
    var phi_3060_: vec3<f32>;
    var phi_3062_: u32;
    var phi_6007_: bool;
    var local_26: u32;
    var phi_6020_: bool;
    var phi_6019_: bool;
    var phi_3166_: type_8;
    var phi_3169_: f32;
    var phi_3167_: type_8;
    var phi_3192_: type_8;
    var phi_3170_: f32;
    var phi_6015_: bool;
    var local_27: f32;
    var phi_3270_: type_8;
    var phi_3273_: f32;
    var phi_3275_: vec3<f32>;
    var phi_3277_: u32;
    var phi_3271_: type_8;
    var phi_3300_: type_8;
    var phi_3360_: u32;
    var phi_3361_: u32;
    var phi_3377_: u32;
    var phi_3378_: u32;
    var phi_3274_: f32;
    var phi_3276_: vec3<f32>;
    var phi_3278_: u32;
    var phi_6022_: bool;
    var local_28: u32;
    var phi_6035_: bool;
    var phi_6034_: bool;
    var phi_3391_: type_8;
    var phi_3394_: f32;
    var phi_3392_: type_8;
    var phi_3417_: type_8;
    var phi_3395_: f32;
    var phi_6030_: bool;
    var local_29: f32;
    var phi_3489_: type_8;
    var phi_3492_: f32;
    var phi_3494_: vec3<f32>;
    var phi_3496_: u32;
    var phi_3490_: type_8;
    var phi_3519_: type_8;
    var phi_3576_: u32;
    var phi_3577_: u32;
    var phi_3593_: u32;
    var phi_3594_: u32;
    var phi_3493_: f32;
    var phi_3495_: vec3<f32>;
    var phi_3497_: u32;
    var phi_6037_: bool;
    var local_30: u32;
    var phi_6050_: bool;
    var phi_6049_: bool;
    var phi_3606_: type_8;
    var phi_3609_: vec3<f32>;
    var phi_3611_: f32;
    var phi_3613_: f32;
    var phi_3615_: f32;
    var phi_3617_: f32;
    var phi_3607_: type_8;
    var phi_3640_: type_8;
    var phi_3754_: vec3<f32>;
    var phi_3755_: f32;
    var phi_3610_: vec3<f32>;
    var phi_3612_: f32;
    var phi_3614_: f32;
    var phi_3616_: f32;
    var phi_3618_: f32;
    var phi_6045_: bool;
    var local_31: f32;
    var local_32: f32;
    var local_33: f32;
    var phi_3771_: bool;
    var phi_3772_: bool;
    var phi_3773_: bool;
    var phi_3774_: bool;
    var phi_3775_: bool;
    var local_34: f32;
    var local_35: vec3<f32>;
    var local_36: f32;
    var local_37: vec3<f32>;
    var local_38: f32;
    var local_39: vec3<f32>;
    var local_40: f32;
    var phi_3792_: vec3<f32>;
    var local_41: f32;
    var local_42: u32;
    var phi_3864_: f32;
    var local_43: u32;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: u32;
    var local_48: u32;
    var phi_3954_: u32;
    var phi_3960_: u32;
    var phi_3990_: u32;
    var phi_3996_: u32;
    var phi_4213_: type_30;
    var phi_4243_: u32;
    var phi_4254_: vec3<f32>;
    var phi_4255_: vec3<f32>;
    var phi_4295_: type_8;
    var phi_4298_: u32;
    var phi_4296_: type_8;
    var phi_4321_: type_8;
    var phi_4351_: u32;
    var phi_4299_: u32;
    var phi_6055_: bool;
    var local_49: u32;
    var phi_6094_: bool;
    var phi_6093_: bool;
    var local_50: i32;
    var local_51: i32;
    var local_52: i32;
    var local_53: i32;
    var local_54: i32;
    var local_55: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = gid_1;
            let _e98 = arrayLength((&surfaces.member));
            let _e100 = arrayLength((&tile_first.member));
            let _e106 = arrayLength((&sums.member));
            let _e110 = (_e92.x + (_e92.y * 2097152u));
            let _e113 = params.member.member_4;
            if (_e110 < _e113) {
                let _e117 = params.member.member_3;
                phi_712_ = _e117;
                phi_715_ = 0u;
                loop {
                    let _e119 = phi_712_;
                    let _e121 = phi_715_;
                    local_7 = _e121;
                    local_8 = _e121;
                    local_9 = _e121;
                    local_10 = _e121;
                    local_11 = _e121;
                    local_12 = _e121;
                    local_13 = _e121;
                    local_42 = _e121;
                    local_43 = _e121;
                    local_44 = _e121;
                    local_45 = _e121;
                    local_46 = _e121;
                    local_47 = _e121;
                    local_48 = _e121;
                    let _e123 = ((_e119 - _e121) > 1u);
                    if _e123 {
                        let _e125 = ((_e121 + _e119) / 2u);
                        if (_e125 < _e100) {
                        } else {
                            phi_5367_ = true;
                            break;
                        }
                        let _e129 = tile_first.member[_e125];
                        let _e130 = (_e129 <= _e110);
                        phi_713_ = select(_e125, _e119, _e130);
                        phi_716_ = select(_e121, _e125, _e130);
                    } else {
                        phi_713_ = u32();
                        phi_716_ = u32();
                    }
                    let _e134 = phi_713_;
                    let _e136 = phi_716_;
                    continue;
                    continuing {
                        phi_712_ = _e134;
                        phi_715_ = _e136;
                        phi_5367_ = false;
                        break if !(_e123);
                    }
                }
                let _e139 = phi_5367_;
                if _e139 {
                    break;
                }
                let _e141 = local_7;
                if (_e141 < arrayLength((&triangles.member))) {
                } else {
                    break;
                }
                let _e145 = local_8;
                let _e148 = triangles.member[_e145].member;
                let _e154 = params.member.member;
                let _e162 = ((_e148[0] - _e154.x) / _e154.w);
                let _e163 = ((_e148[1] - _e154.y) / _e154.w);
                let _e164 = ((_e148[2] - _e154.z) / _e154.w);
                let _e168 = local_9;
                let _e171 = triangles.member[_e168].member_2;
                let _e178 = ((_e171[0] - _e154.x) / _e154.w);
                let _e179 = ((_e171[1] - _e154.y) / _e154.w);
                let _e180 = ((_e171[2] - _e154.z) / _e154.w);
                let _e184 = local_10;
                let _e187 = triangles.member[_e184].member_4;
                let _e194 = ((_e187[0] - _e154.x) / _e154.w);
                let _e195 = ((_e187[1] - _e154.y) / _e154.w);
                let _e196 = ((_e187[2] - _e154.z) / _e154.w);
                let _e198 = (_e178 - _e162);
                let _e199 = (_e179 - _e163);
                let _e200 = (_e180 - _e164);
                let _e201 = (_e194 - _e162);
                let _e202 = (_e195 - _e163);
                let _e203 = (_e196 - _e164);
                let _e206 = ((_e199 * _e203) - (_e202 * _e200));
                let _e209 = ((_e200 * _e201) - (_e203 * _e198));
                let _e212 = ((_e198 * _e202) - (_e201 * _e199));
                let _e214 = abs(_e206);
                let _e215 = abs(_e209);
                let _e216 = abs(_e212);
                let _e217 = (_e214 >= _e215);
                if _e217 {
                    phi_829_ = select(true, false, (_e214 >= _e216));
                } else {
                    phi_829_ = true;
                }
                let _e221 = phi_829_;
                if _e221 {
                    phi_838_ = select(2u, 1u, (_e215 >= _e216));
                } else {
                    phi_838_ = 0u;
                }
                let _e225 = phi_838_;
                let _e228 = params.member.member_1;
                let _e230 = f32(_e228.x);
                let _e232 = f32(_e228.y);
                let _e234 = f32(_e228.z);
                let _e236 = (_e225 == 0u);
                if _e236 {
                    phi_859_ = vec3<f32>(_e232, _e234, _e230);
                } else {
                    if (_e225 == 1u) {
                        phi_858_ = vec3<f32>(_e234, _e230, _e232);
                    } else {
                        phi_858_ = vec3<f32>(_e230, _e232, _e234);
                    }
                    let _e240 = phi_858_;
                    phi_859_ = _e240;
                }
                let _e243 = phi_859_;
                if _e236 {
                    phi_871_ = vec3<f32>(_e163, _e164, _e162);
                } else {
                    if (_e225 == 1u) {
                        phi_870_ = vec3<f32>(_e164, _e162, _e163);
                    } else {
                        phi_870_ = vec3<f32>(_e162, _e163, _e164);
                    }
                    let _e247 = phi_870_;
                    phi_871_ = _e247;
                }
                let _e250 = phi_871_;
                if _e236 {
                    phi_883_ = vec3<f32>(_e179, _e180, _e178);
                } else {
                    if (_e225 == 1u) {
                        phi_882_ = vec3<f32>(_e180, _e178, _e179);
                    } else {
                        phi_882_ = vec3<f32>(_e178, _e179, _e180);
                    }
                    let _e254 = phi_882_;
                    phi_883_ = _e254;
                }
                let _e257 = phi_883_;
                if _e236 {
                    phi_895_ = vec3<f32>(_e195, _e196, _e194);
                } else {
                    if (_e225 == 1u) {
                        phi_894_ = vec3<f32>(_e196, _e194, _e195);
                    } else {
                        phi_894_ = vec3<f32>(_e194, _e195, _e196);
                    }
                    let _e261 = phi_894_;
                    phi_895_ = _e261;
                }
                let _e264 = phi_895_;
                let _e268 = select(_e257.x, _e250.x, (_e250.x < _e257.x));
                let _e273 = select(_e257.x, _e250.x, (_e250.x > _e257.x));
                let _e279 = (-1f - floor(-(select(_e264.x, _e268, (_e268 < _e264.x)))));
                let _e280 = floor(select(_e264.x, _e273, (_e273 > _e264.x)));
                let _e281 = (_e243.x - 1f);
                let _e283 = select(0f, _e279, (_e279 > 0f));
                let _e285 = select(_e281, _e280, (_e280 < _e281));
                let _e292 = select(0i, select(select(i32(_e283), i32(-2147483648), (_e283 < -2147483600f)), 2147483647i, (_e283 > 2147483500f)), (_e283 == _e283));
                let _e299 = select(0i, select(select(i32(_e285), i32(-2147483648), (_e285 < -2147483600f)), 2147483647i, (_e285 > 2147483500f)), (_e285 == _e285));
                let _e303 = select(_e257.y, _e250.y, (_e250.y < _e257.y));
                let _e308 = select(_e257.y, _e250.y, (_e250.y > _e257.y));
                let _e314 = (-1f - floor(-(select(_e264.y, _e303, (_e303 < _e264.y)))));
                let _e315 = floor(select(_e264.y, _e308, (_e308 > _e264.y)));
                let _e316 = (_e243.y - 1f);
                let _e318 = select(0f, _e314, (_e314 > 0f));
                let _e320 = select(_e316, _e315, (_e315 < _e316));
                let _e327 = select(0i, select(select(i32(_e318), i32(-2147483648), (_e318 < -2147483600f)), 2147483647i, (_e318 > 2147483500f)), (_e318 == _e318));
                let _e334 = select(0i, select(select(i32(_e320), i32(-2147483648), (_e320 < -2147483600f)), 2147483647i, (_e320 > 2147483500f)), (_e320 == _e320));
                let _e335 = type_37(_e250, _e257, _e264, vec3<f32>(_e206, _e209, _e212), _e225, _e243, _e292, _e299, _e327, _e334);
                if _e217 {
                    phi_1031_ = select(true, false, (_e214 >= _e216));
                } else {
                    phi_1031_ = true;
                }
                let _e339 = phi_1031_;
                if _e339 {
                    phi_1040_ = select(2u, 1u, (_e215 >= _e216));
                } else {
                    phi_1040_ = 0u;
                }
                let _e343 = phi_1040_;
                if (_e343 == 0u) {
                    phi_1050_ = _e206;
                } else {
                    phi_1050_ = select(_e212, _e209, (_e343 == 1u));
                }
                let _e348 = phi_1050_;
                let _e357 = (((_e206 * _e206) + (_e209 * _e209)) + (_e212 * _e212));
                if (_e357 >= 0.000000000000000000000000000000000000011754944f) {
                    let _e360 = (1f / sqrt(_e357));
                    phi_1070_ = vec3<f32>((_e206 * _e360), (_e209 * _e360), (_e212 * _e360));
                } else {
                    phi_1070_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e366 = phi_1070_;
                let _e369 = local_11;
                let _e372 = triangles.member[_e369].member_1;
                let _e373 = (_e372 * 12u);
                let _e374 = (256u + _e373);
                if (_e374 < _e98) {
                } else {
                    break;
                }
                let _e378 = surfaces.member[_e374];
                let _e379 = bitcast<f32>(_e378);
                let _e380 = (_e373 + 257u);
                if (_e380 < _e98) {
                } else {
                    break;
                }
                let _e384 = surfaces.member[_e380];
                let _e385 = bitcast<f32>(_e384);
                let _e386 = (_e373 + 258u);
                if (_e386 < _e98) {
                } else {
                    break;
                }
                let _e390 = surfaces.member[_e386];
                let _e391 = bitcast<f32>(_e390);
                let _e392 = (_e373 + 259u);
                if (_e392 < _e98) {
                } else {
                    break;
                }
                let _e396 = surfaces.member[_e392];
                let _e397 = (_e373 + 260u);
                if (_e397 < _e98) {
                } else {
                    break;
                }
                let _e401 = surfaces.member[_e397];
                let _e403 = (_e373 + 261u);
                if (_e403 < _e98) {
                } else {
                    break;
                }
                let _e407 = surfaces.member[_e403];
                let _e409 = (_e373 + 262u);
                if (_e409 < _e98) {
                } else {
                    break;
                }
                let _e413 = surfaces.member[_e409];
                let _e415 = (_e373 + 263u);
                if (_e415 < _e98) {
                } else {
                    break;
                }
                let _e419 = surfaces.member[_e415];
                let _e420 = (_e373 + 264u);
                if (_e420 < _e98) {
                } else {
                    break;
                }
                let _e424 = surfaces.member[_e420];
                let _e425 = bitcast<f32>(_e424);
                let _e426 = (_e373 + 265u);
                if (_e426 < _e98) {
                } else {
                    break;
                }
                let _e430 = surfaces.member[_e426];
                if ((_e373 + 266u) < _e98) {
                } else {
                    break;
                }
                if ((_e373 + 267u) < _e98) {
                } else {
                    break;
                }
                let _e437 = local_12;
                if (_e437 < _e100) {
                } else {
                    break;
                }
                let _e441 = local_13;
                let _e443 = tile_first.member[_e441];
                let _e444 = (_e110 - _e443);
                if (_e299 < _e292) {
                    phi_1194_ = 0u;
                } else {
                    phi_1194_ = ((bitcast<u32>((_e299 - _e292)) / 4u) + 1u);
                }
                let _e451 = phi_1194_;
                let _e453 = select(1u, _e451, (1u < _e451));
                if (_e453 == 0u) {
                    break;
                }
                let _e455 = (_e444 / _e453);
                let _e460 = (_e292 + bitcast<i32>(((_e444 - (_e455 * _e453)) * 4u)));
                let _e463 = (_e327 + bitcast<i32>((_e455 * 4u)));
                let _e467 = select(_e257.z, _e250.z, (_e250.z < _e257.z));
                let _e472 = select(_e257.z, _e250.z, (_e250.z > _e257.z));
                let _e478 = (-1f - floor(-(select(_e264.z, _e467, (_e467 < _e264.z)))));
                let _e479 = floor(select(_e264.z, _e472, (_e472 > _e264.z)));
                let _e480 = (_e243.z - 1f);
                let _e482 = select(0f, _e478, (_e478 > 0f));
                let _e484 = select(_e480, _e479, (_e479 < _e480));
                let _e491 = select(0i, select(select(i32(_e482), i32(-2147483648), (_e482 < -2147483600f)), 2147483647i, (_e482 > 2147483500f)), (_e482 == _e482));
                let _e498 = select(0i, select(select(i32(_e484), i32(-2147483648), (_e484 < -2147483600f)), 2147483647i, (_e484 > 2147483500f)), (_e484 == _e484));
                let _e499 = (_e257.x - _e250.x);
                let _e500 = (_e257.y - _e250.y);
                let _e506 = ((abs(_e499) + abs(_e500)) + abs((_e257.z - _e250.z)));
                let _e507 = (_e264.x - _e250.x);
                let _e508 = (_e264.y - _e250.y);
                let _e514 = ((abs(_e507) + abs(_e508)) + abs((_e264.z - _e250.z)));
                let _e516 = select(_e215, _e214, (_e214 > _e215));
                let _e524 = (select(_e216, _e516, (_e516 > _e216)) <= (((0.000004f * _e506) * _e514) * select(_e514, _e506, (_e506 > _e514))));
                let _e525 = (_e460 + 4i);
                let _e526 = (_e299 + 1i);
                let _e528 = select(_e525, _e526, (_e526 < _e525));
                let _e529 = (_e463 + 4i);
                let _e530 = (_e334 + 1i);
                let _e533 = (_e460 - 1i);
                let _e536 = (f32(_e460) + 2f);
                let _e538 = (f32(_e463) + 2f);
                let _e541 = ((_e250.x - _e536) * 0.24937655f);
                let _e542 = ((_e250.y - _e538) * 0.24937655f);
                let _e545 = ((_e257.x - _e536) * 0.24937655f);
                let _e546 = ((_e257.y - _e538) * 0.24937655f);
                let _e549 = ((_e264.x - _e536) * 0.24937655f);
                let _e550 = ((_e264.y - _e538) * 0.24937655f);
                let _e551 = (_e545 - _e541);
                let _e552 = (_e546 - _e542);
                let _e555 = ((_e551 * _e542) - (_e552 * _e541));
                let _e558 = ((_e551 * _e550) - (_e552 * _e549));
                let _e561 = (abs(_e551) + abs(_e552));
                if (select(_e558, _e555, (_e555 < _e558)) > (0.5f * _e561)) {
                    phi_4732_ = true;
                } else {
                    phi_4732_ = (select(_e558, _e555, (_e555 > _e558)) < (_e561 * -0.5f));
                }
                let _e571 = phi_4732_;
                if _e571 {
                    phi_1391_ = bool();
                    phi_1392_ = true;
                } else {
                    let _e572 = (_e549 - _e545);
                    let _e573 = (_e550 - _e546);
                    let _e576 = ((_e572 * _e546) - (_e573 * _e545));
                    let _e579 = ((_e572 * _e542) - (_e573 * _e541));
                    let _e582 = (abs(_e572) + abs(_e573));
                    if (select(_e579, _e576, (_e576 < _e579)) > (0.5f * _e582)) {
                        phi_4771_ = true;
                    } else {
                        phi_4771_ = (select(_e579, _e576, (_e576 > _e579)) < (_e582 * -0.5f));
                    }
                    let _e592 = phi_4771_;
                    if _e592 {
                        phi_1390_ = bool();
                    } else {
                        let _e593 = (_e541 - _e549);
                        let _e594 = (_e542 - _e550);
                        let _e597 = ((_e593 * _e550) - (_e594 * _e549));
                        let _e600 = ((_e593 * _e546) - (_e594 * _e545));
                        let _e603 = (abs(_e593) + abs(_e594));
                        if (select(_e600, _e597, (_e597 < _e600)) > (0.5f * _e603)) {
                            phi_4810_ = true;
                        } else {
                            phi_4810_ = (select(_e600, _e597, (_e597 > _e600)) < (_e603 * -0.5f));
                        }
                        let _e613 = phi_4810_;
                        phi_1390_ = _e613;
                    }
                    let _e615 = phi_1390_;
                    phi_1391_ = _e615;
                    phi_1392_ = _e592;
                }
                let _e617 = phi_1391_;
                let _e619 = phi_1392_;
                if select(_e617, true, _e619) {
                    phi_1401_ = type_38(_e335, _e460, _e528, _e463, _e491, _e498, _e533, _e463, 0i, -1i, _e524);
                } else {
                    phi_1401_ = type_38(_e335, _e460, _e528, select(_e529, _e530, (_e530 < _e529)), _e491, _e498, _e533, _e463, 0i, -1i, _e524);
                }
                let _e623 = phi_1401_;
                phi_5763_ = _e139;
                phi_5381_ = _e623.member_6;
                phi_5378_ = _e623.member_9;
                phi_5375_ = _e623.member_8;
                phi_5372_ = _e623.member_7;
                loop {
                    let _e642 = phi_5763_;
                    let _e644 = phi_5381_;
                    let _e646 = phi_5378_;
                    let _e648 = phi_5375_;
                    let _e650 = phi_5372_;
                    phi_5380_ = _e644;
                    phi_5377_ = _e646;
                    phi_5374_ = _e648;
                    phi_5371_ = _e650;
                    loop {
                        let _e652 = phi_5380_;
                        let _e654 = phi_5377_;
                        let _e656 = phi_5374_;
                        let _e658 = phi_5371_;
                        let _e659 = (_e658 < _e623.member_3);
                        if _e659 {
                            phi_5373_ = _e656;
                            loop {
                                let _e661 = phi_5373_;
                                let _e662 = (_e661 < _e654);
                                if _e662 {
                                    let _e663 = (_e661 + 1i);
                                    let _e667 = (f32(_e652) + 0.5f);
                                    let _e668 = (f32(_e658) + 0.5f);
                                    let _e669 = (f32(_e663) + 0.5f);
                                    let _e671 = (_e623.member.member.x - _e667);
                                    let _e673 = (_e623.member.member.y - _e668);
                                    let _e675 = (_e623.member.member.z - _e669);
                                    let _e676 = vec3<f32>(_e667, _e668, _e669);
                                    let _e679 = (_e623.member.member_1.x - _e667);
                                    let _e681 = (_e623.member.member_1.y - _e668);
                                    let _e683 = (_e623.member.member_1.z - _e669);
                                    let _e686 = (_e623.member.member_2.x - _e667);
                                    let _e688 = (_e623.member.member_2.y - _e668);
                                    let _e690 = (_e623.member.member_2.z - _e669);
                                    let _e693 = select(_e679, _e671, (_e671 < _e679));
                                    let _e697 = select(_e681, _e673, (_e673 < _e681));
                                    let _e701 = select(_e683, _e675, (_e675 < _e683));
                                    let _e705 = select(_e679, _e671, (_e671 > _e679));
                                    let _e709 = select(_e681, _e673, (_e673 > _e681));
                                    let _e713 = select(_e683, _e675, (_e675 > _e683));
                                    if (select(_e686, _e693, (_e693 < _e686)) > 0.5f) {
                                        phi_2045_ = bool();
                                        phi_2046_ = true;
                                        phi_2047_ = false;
                                    } else {
                                        if (select(_e688, _e697, (_e697 < _e688)) > 0.5f) {
                                            phi_2042_ = bool();
                                            phi_2043_ = true;
                                            phi_2044_ = false;
                                        } else {
                                            if (select(_e690, _e701, (_e701 < _e690)) > 0.5f) {
                                                phi_2039_ = bool();
                                                phi_2040_ = true;
                                                phi_2041_ = false;
                                            } else {
                                                if (select(_e686, _e705, (_e705 > _e686)) < -0.5f) {
                                                    phi_2036_ = bool();
                                                    phi_2037_ = true;
                                                    phi_2038_ = false;
                                                } else {
                                                    if (select(_e688, _e709, (_e709 > _e688)) < -0.5f) {
                                                        phi_2033_ = bool();
                                                        phi_2034_ = true;
                                                        phi_2035_ = false;
                                                    } else {
                                                        let _e721 = (select(_e690, _e713, (_e713 > _e690)) < -0.5f);
                                                        if _e721 {
                                                            phi_2031_ = bool();
                                                            phi_2032_ = false;
                                                        } else {
                                                            let _e722 = (_e679 - _e671);
                                                            let _e723 = (_e681 - _e673);
                                                            let _e724 = (_e683 - _e675);
                                                            let _e725 = vec3<f32>(_e722, _e723, _e724);
                                                            let _e726 = (_e686 - _e679);
                                                            let _e727 = (_e688 - _e681);
                                                            let _e728 = (_e690 - _e683);
                                                            let _e729 = vec3<f32>(_e726, _e727, _e728);
                                                            let _e730 = (_e671 - _e686);
                                                            let _e731 = (_e673 - _e688);
                                                            let _e732 = (_e675 - _e690);
                                                            let _e733 = vec3<f32>(_e730, _e731, _e732);
                                                            let _e736 = ((_e723 * _e675) - (_e724 * _e673));
                                                            let _e739 = ((_e723 * _e690) - (_e724 * _e688));
                                                            let _e740 = abs(_e723);
                                                            let _e741 = abs(_e724);
                                                            let _e742 = (_e740 + _e741);
                                                            if (select(_e739, _e736, (_e736 < _e739)) > (0.5f * _e742)) {
                                                                phi_1621_ = true;
                                                            } else {
                                                                phi_1621_ = (select(_e739, _e736, (_e736 > _e739)) < (_e742 * -0.5f));
                                                            }
                                                            let _e752 = phi_1621_;
                                                            if _e752 {
                                                                phi_1683_ = bool();
                                                                phi_1684_ = true;
                                                            } else {
                                                                let _e755 = ((_e724 * _e671) - (_e722 * _e675));
                                                                let _e758 = ((_e724 * _e686) - (_e722 * _e690));
                                                                let _e759 = abs(_e722);
                                                                let _e760 = (_e741 + _e759);
                                                                if (select(_e758, _e755, (_e755 < _e758)) > (0.5f * _e760)) {
                                                                    phi_1651_ = true;
                                                                } else {
                                                                    phi_1651_ = (select(_e758, _e755, (_e755 > _e758)) < (_e760 * -0.5f));
                                                                }
                                                                let _e770 = phi_1651_;
                                                                if _e770 {
                                                                    phi_1682_ = bool();
                                                                } else {
                                                                    let _e773 = ((_e722 * _e673) - (_e723 * _e671));
                                                                    let _e776 = ((_e722 * _e688) - (_e723 * _e686));
                                                                    let _e777 = (_e759 + _e740);
                                                                    if (select(_e776, _e773, (_e773 < _e776)) > (0.5f * _e777)) {
                                                                        phi_1681_ = true;
                                                                    } else {
                                                                        phi_1681_ = (select(_e776, _e773, (_e773 > _e776)) < (_e777 * -0.5f));
                                                                    }
                                                                    let _e787 = phi_1681_;
                                                                    phi_1682_ = _e787;
                                                                }
                                                                let _e789 = phi_1682_;
                                                                phi_1683_ = _e789;
                                                                phi_1684_ = _e770;
                                                            }
                                                            let _e791 = phi_1683_;
                                                            let _e793 = phi_1684_;
                                                            if select(_e791, true, _e793) {
                                                                phi_2026_ = bool();
                                                                phi_2027_ = true;
                                                            } else {
                                                                let _e797 = ((_e727 * _e683) - (_e728 * _e681));
                                                                let _e800 = ((_e727 * _e675) - (_e728 * _e673));
                                                                let _e801 = abs(_e727);
                                                                let _e802 = abs(_e728);
                                                                let _e803 = (_e801 + _e802);
                                                                if (select(_e800, _e797, (_e797 < _e800)) > (0.5f * _e803)) {
                                                                    phi_1718_ = true;
                                                                } else {
                                                                    phi_1718_ = (select(_e800, _e797, (_e797 > _e800)) < (_e803 * -0.5f));
                                                                }
                                                                let _e813 = phi_1718_;
                                                                if _e813 {
                                                                    phi_1780_ = bool();
                                                                    phi_1781_ = true;
                                                                } else {
                                                                    let _e816 = ((_e728 * _e679) - (_e726 * _e683));
                                                                    let _e819 = ((_e728 * _e671) - (_e726 * _e675));
                                                                    let _e820 = abs(_e726);
                                                                    let _e821 = (_e802 + _e820);
                                                                    if (select(_e819, _e816, (_e816 < _e819)) > (0.5f * _e821)) {
                                                                        phi_1748_ = true;
                                                                    } else {
                                                                        phi_1748_ = (select(_e819, _e816, (_e816 > _e819)) < (_e821 * -0.5f));
                                                                    }
                                                                    let _e831 = phi_1748_;
                                                                    if _e831 {
                                                                        phi_1779_ = bool();
                                                                    } else {
                                                                        let _e834 = ((_e726 * _e681) - (_e727 * _e679));
                                                                        let _e837 = ((_e726 * _e673) - (_e727 * _e671));
                                                                        let _e838 = (_e820 + _e801);
                                                                        if (select(_e837, _e834, (_e834 < _e837)) > (0.5f * _e838)) {
                                                                            phi_1778_ = true;
                                                                        } else {
                                                                            phi_1778_ = (select(_e837, _e834, (_e834 > _e837)) < (_e838 * -0.5f));
                                                                        }
                                                                        let _e848 = phi_1778_;
                                                                        phi_1779_ = _e848;
                                                                    }
                                                                    let _e850 = phi_1779_;
                                                                    phi_1780_ = _e850;
                                                                    phi_1781_ = _e831;
                                                                }
                                                                let _e852 = phi_1780_;
                                                                let _e854 = phi_1781_;
                                                                if select(_e852, true, _e854) {
                                                                    phi_2024_ = bool();
                                                                    phi_2025_ = true;
                                                                } else {
                                                                    let _e858 = ((_e731 * _e690) - (_e732 * _e688));
                                                                    let _e861 = ((_e731 * _e683) - (_e732 * _e681));
                                                                    let _e862 = abs(_e731);
                                                                    let _e863 = abs(_e732);
                                                                    let _e864 = (_e862 + _e863);
                                                                    if (select(_e861, _e858, (_e858 < _e861)) > (0.5f * _e864)) {
                                                                        phi_1815_ = true;
                                                                    } else {
                                                                        phi_1815_ = (select(_e861, _e858, (_e858 > _e861)) < (_e864 * -0.5f));
                                                                    }
                                                                    let _e874 = phi_1815_;
                                                                    if _e874 {
                                                                        phi_1877_ = bool();
                                                                        phi_1878_ = true;
                                                                    } else {
                                                                        let _e877 = ((_e732 * _e686) - (_e730 * _e690));
                                                                        let _e880 = ((_e732 * _e679) - (_e730 * _e683));
                                                                        let _e881 = abs(_e730);
                                                                        let _e882 = (_e863 + _e881);
                                                                        if (select(_e880, _e877, (_e877 < _e880)) > (0.5f * _e882)) {
                                                                            phi_1845_ = true;
                                                                        } else {
                                                                            phi_1845_ = (select(_e880, _e877, (_e877 > _e880)) < (_e882 * -0.5f));
                                                                        }
                                                                        let _e892 = phi_1845_;
                                                                        if _e892 {
                                                                            phi_1876_ = bool();
                                                                        } else {
                                                                            let _e895 = ((_e730 * _e688) - (_e731 * _e686));
                                                                            let _e898 = ((_e730 * _e681) - (_e731 * _e679));
                                                                            let _e899 = (_e881 + _e862);
                                                                            if (select(_e898, _e895, (_e895 < _e898)) > (0.5f * _e899)) {
                                                                                phi_1875_ = true;
                                                                            } else {
                                                                                phi_1875_ = (select(_e898, _e895, (_e895 > _e898)) < (_e899 * -0.5f));
                                                                            }
                                                                            let _e909 = phi_1875_;
                                                                            phi_1876_ = _e909;
                                                                        }
                                                                        let _e911 = phi_1876_;
                                                                        phi_1877_ = _e911;
                                                                        phi_1878_ = _e892;
                                                                    }
                                                                    let _e913 = phi_1877_;
                                                                    let _e915 = phi_1878_;
                                                                    let _e916 = select(_e913, true, _e915);
                                                                    if _e916 {
                                                                        phi_2023_ = bool();
                                                                    } else {
                                                                        let _e919 = ((abs(_e722) + _e740) + _e741);
                                                                        let _e922 = ((abs(_e726) + _e801) + _e802);
                                                                        let _e925 = ((abs(_e730) + _e862) + _e863);
                                                                        if (_e919 >= _e922) {
                                                                            phi_1910_ = select(true, false, (_e919 >= _e925));
                                                                        } else {
                                                                            phi_1910_ = true;
                                                                        }
                                                                        let _e930 = phi_1910_;
                                                                        if _e930 {
                                                                            let _e932 = vec3((_e922 >= _e925));
                                                                            phi_1920_ = select(_e725, _e733, _e932);
                                                                            phi_1921_ = select(_e729, _e725, _e932);
                                                                        } else {
                                                                            phi_1920_ = _e729;
                                                                            phi_1921_ = _e733;
                                                                        }
                                                                        let _e936 = phi_1920_;
                                                                        let _e938 = phi_1921_;
                                                                        let _e945 = ((_e936.y * _e938.z) - (_e938.y * _e936.z));
                                                                        let _e950 = ((_e936.z * _e938.x) - (_e938.z * _e936.x));
                                                                        let _e953 = ((_e936.x * _e938.y) - (_e938.x * _e936.y));
                                                                        let _e964 = ((abs(_e671) + abs(_e673)) + abs(_e675));
                                                                        let _e969 = ((abs(_e679) + abs(_e681)) + abs(_e683));
                                                                        let _e974 = ((abs(_e686) + abs(_e688)) + abs(_e690));
                                                                        if (_e964 <= _e969) {
                                                                            phi_1973_ = select(true, false, (_e964 <= _e974));
                                                                        } else {
                                                                            phi_1973_ = true;
                                                                        }
                                                                        let _e979 = phi_1973_;
                                                                        if _e979 {
                                                                            phi_1982_ = select((_e623.member.member_2 - _e676), (_e623.member.member_1 - _e676), vec3((_e969 <= _e974)));
                                                                        } else {
                                                                            phi_1982_ = (_e623.member.member - _e676);
                                                                        }
                                                                        let _e984 = phi_1982_;
                                                                        let _e986 = select(_e969, _e964, (_e964 < _e969));
                                                                        phi_2023_ = (abs((((_e945 * _e984.x) + (_e950 * _e984.y)) + (_e953 * _e984.z))) <= ((0.5f * ((abs(_e945) + abs(_e950)) + abs(_e953))) + (((0.00000036f * select(_e974, _e986, (_e986 < _e974))) * ((abs(_e936.x) + abs(_e936.y)) + abs(_e936.z))) * ((abs(_e938.x) + abs(_e938.y)) + abs(_e938.z)))));
                                                                    }
                                                                    let _e1014 = phi_2023_;
                                                                    phi_2024_ = _e1014;
                                                                    phi_2025_ = _e916;
                                                                }
                                                                let _e1016 = phi_2024_;
                                                                let _e1018 = phi_2025_;
                                                                phi_2026_ = _e1016;
                                                                phi_2027_ = _e1018;
                                                            }
                                                            let _e1020 = phi_2026_;
                                                            let _e1022 = phi_2027_;
                                                            phi_2031_ = _e1020;
                                                            phi_2032_ = _e1022;
                                                        }
                                                        let _e1024 = phi_2031_;
                                                        let _e1026 = phi_2032_;
                                                        phi_2033_ = _e1024;
                                                        phi_2034_ = _e721;
                                                        phi_2035_ = _e1026;
                                                    }
                                                    let _e1028 = phi_2033_;
                                                    let _e1030 = phi_2034_;
                                                    let _e1032 = phi_2035_;
                                                    phi_2036_ = _e1028;
                                                    phi_2037_ = _e1030;
                                                    phi_2038_ = _e1032;
                                                }
                                                let _e1034 = phi_2036_;
                                                let _e1036 = phi_2037_;
                                                let _e1038 = phi_2038_;
                                                phi_2039_ = _e1034;
                                                phi_2040_ = _e1036;
                                                phi_2041_ = _e1038;
                                            }
                                            let _e1040 = phi_2039_;
                                            let _e1042 = phi_2040_;
                                            let _e1044 = phi_2041_;
                                            phi_2042_ = _e1040;
                                            phi_2043_ = _e1042;
                                            phi_2044_ = _e1044;
                                        }
                                        let _e1046 = phi_2042_;
                                        let _e1048 = phi_2043_;
                                        let _e1050 = phi_2044_;
                                        phi_2045_ = _e1046;
                                        phi_2046_ = _e1048;
                                        phi_2047_ = _e1050;
                                    }
                                    let _e1052 = phi_2045_;
                                    let _e1054 = phi_2046_;
                                    let _e1056 = phi_2047_;
                                    phi_5671_ = _e663;
                                    phi_2060_ = select(true, false, select(_e1052, false, select(_e1056, true, _e1054)));
                                } else {
                                    phi_5671_ = _e661;
                                    phi_2060_ = false;
                                }
                                let _e1061 = phi_5671_;
                                let _e1063 = phi_2060_;
                                let _e1064 = select(true, false, _e662);
                                local_14 = _e1064;
                                local_54 = _e1061;
                                local_55 = _e1064;
                                continue;
                                continuing {
                                    phi_5373_ = _e1061;
                                    break if !(_e1063);
                                }
                            }
                            let _e1067 = local_14;
                            if _e1067 {
                                let _e1068 = (_e652 + 1i);
                                let _e1069 = (_e1068 >= _e623.member_2);
                                if _e1069 {
                                    phi_5530_ = (_e658 + 1i);
                                } else {
                                    phi_5530_ = _e658;
                                }
                                let _e1072 = phi_5530_;
                                let _e1073 = select(_e1068, _e623.member_1, _e1069);
                                if _e623.member_10 {
                                    let _e1120 = (_e623.member.member_1.x - _e623.member.member.x);
                                    let _e1123 = (_e623.member.member_1.y - _e623.member.member.y);
                                    let _e1126 = (_e623.member.member_1.z - _e623.member.member.z);
                                    let _e1127 = f32(_e1073);
                                    let _e1128 = (_e1127 - 0.01f);
                                    let _e1129 = (_e1128 - _e623.member.member.x);
                                    let _e1130 = (_e1127 + 1.01f);
                                    let _e1131 = (_e1130 - _e623.member.member.x);
                                    if (abs(_e1120) < 0.000001f) {
                                        if (_e1129 <= 0f) {
                                            let _e1142 = (_e1131 >= 0f);
                                            if _e1142 {
                                                phi_4860_ = type_40(0f, 1f);
                                            } else {
                                                phi_4860_ = type_40();
                                            }
                                            let _e1144 = phi_4860_;
                                            phi_4863_ = _e1144;
                                            phi_4864_ = select(true, false, _e1142);
                                        } else {
                                            phi_4863_ = type_40();
                                            phi_4864_ = true;
                                        }
                                        let _e1147 = phi_4863_;
                                        let _e1149 = phi_4864_;
                                        if _e1149 {
                                            phi_4869_ = type_40(1f, 0f);
                                        } else {
                                            phi_4869_ = _e1147;
                                        }
                                        let _e1151 = phi_4869_;
                                        phi_4871_ = _e1151;
                                    } else {
                                        let _e1134 = (_e1129 / _e1120);
                                        let _e1135 = (_e1131 / _e1120);
                                        phi_4871_ = type_40(select(_e1135, _e1134, (_e1134 < _e1135)), select(_e1135, _e1134, (_e1134 > _e1135)));
                                    }
                                    let _e1153 = phi_4871_;
                                    let _e1156 = f32(_e1072);
                                    let _e1157 = (_e1156 - 0.01f);
                                    let _e1158 = (_e1157 - _e623.member.member.y);
                                    let _e1159 = (_e1156 + 1.01f);
                                    let _e1160 = (_e1159 - _e623.member.member.y);
                                    if (abs(_e1123) < 0.000001f) {
                                        if (_e1158 <= 0f) {
                                            let _e1171 = (_e1160 >= 0f);
                                            if _e1171 {
                                                phi_4907_ = type_40(0f, 1f);
                                            } else {
                                                phi_4907_ = type_40();
                                            }
                                            let _e1173 = phi_4907_;
                                            phi_4910_ = _e1173;
                                            phi_4911_ = select(true, false, _e1171);
                                        } else {
                                            phi_4910_ = type_40();
                                            phi_4911_ = true;
                                        }
                                        let _e1176 = phi_4910_;
                                        let _e1178 = phi_4911_;
                                        if _e1178 {
                                            phi_4916_ = type_40(1f, 0f);
                                        } else {
                                            phi_4916_ = _e1176;
                                        }
                                        let _e1180 = phi_4916_;
                                        phi_4918_ = _e1180;
                                    } else {
                                        let _e1163 = (_e1158 / _e1123);
                                        let _e1164 = (_e1160 / _e1123);
                                        phi_4918_ = type_40(select(_e1164, _e1163, (_e1163 < _e1164)), select(_e1164, _e1163, (_e1163 > _e1164)));
                                    }
                                    let _e1182 = phi_4918_;
                                    let _e1186 = select(_e1182.member, _e1153.member, (_e1153.member > _e1182.member));
                                    let _e1188 = select(0f, _e1186, (_e1186 > 0f));
                                    let _e1190 = select(_e1182.member_1, _e1153.member_1, (_e1153.member_1 < _e1182.member_1));
                                    let _e1192 = select(1f, _e1190, (_e1190 < 1f));
                                    if (_e1188 > _e1192) {
                                        phi_4966_ = type_40(_e623.member.member_5.z, -2f);
                                    } else {
                                        let _e1195 = (_e623.member.member.z + (_e1126 * _e1188));
                                        let _e1197 = (_e623.member.member.z + (_e1126 * _e1192));
                                        phi_4966_ = type_40(select(_e1197, _e1195, (_e1195 < _e1197)), select(_e1197, _e1195, (_e1195 > _e1197)));
                                    }
                                    let _e1206 = phi_4966_;
                                    let _e1210 = (_e623.member.member_2.x - _e623.member.member_1.x);
                                    let _e1212 = (_e623.member.member_2.y - _e623.member.member_1.y);
                                    let _e1214 = (_e623.member.member_2.z - _e623.member.member_1.z);
                                    let _e1215 = (_e1128 - _e623.member.member_1.x);
                                    let _e1216 = (_e1130 - _e623.member.member_1.x);
                                    if (abs(_e1210) < 0.000001f) {
                                        if (_e1215 <= 0f) {
                                            let _e1227 = (_e1216 >= 0f);
                                            if _e1227 {
                                                phi_5015_ = type_40(0f, 1f);
                                            } else {
                                                phi_5015_ = type_40();
                                            }
                                            let _e1229 = phi_5015_;
                                            phi_5018_ = _e1229;
                                            phi_5019_ = select(true, false, _e1227);
                                        } else {
                                            phi_5018_ = type_40();
                                            phi_5019_ = true;
                                        }
                                        let _e1232 = phi_5018_;
                                        let _e1234 = phi_5019_;
                                        if _e1234 {
                                            phi_5024_ = type_40(1f, 0f);
                                        } else {
                                            phi_5024_ = _e1232;
                                        }
                                        let _e1236 = phi_5024_;
                                        phi_5026_ = _e1236;
                                    } else {
                                        let _e1219 = (_e1215 / _e1210);
                                        let _e1220 = (_e1216 / _e1210);
                                        phi_5026_ = type_40(select(_e1220, _e1219, (_e1219 < _e1220)), select(_e1220, _e1219, (_e1219 > _e1220)));
                                    }
                                    let _e1238 = phi_5026_;
                                    let _e1241 = (_e1157 - _e623.member.member_1.y);
                                    let _e1242 = (_e1159 - _e623.member.member_1.y);
                                    if (abs(_e1212) < 0.000001f) {
                                        if (_e1241 <= 0f) {
                                            let _e1253 = (_e1242 >= 0f);
                                            if _e1253 {
                                                phi_5062_ = type_40(0f, 1f);
                                            } else {
                                                phi_5062_ = type_40();
                                            }
                                            let _e1255 = phi_5062_;
                                            phi_5065_ = _e1255;
                                            phi_5066_ = select(true, false, _e1253);
                                        } else {
                                            phi_5065_ = type_40();
                                            phi_5066_ = true;
                                        }
                                        let _e1258 = phi_5065_;
                                        let _e1260 = phi_5066_;
                                        if _e1260 {
                                            phi_5071_ = type_40(1f, 0f);
                                        } else {
                                            phi_5071_ = _e1258;
                                        }
                                        let _e1262 = phi_5071_;
                                        phi_5073_ = _e1262;
                                    } else {
                                        let _e1245 = (_e1241 / _e1212);
                                        let _e1246 = (_e1242 / _e1212);
                                        phi_5073_ = type_40(select(_e1246, _e1245, (_e1245 < _e1246)), select(_e1246, _e1245, (_e1245 > _e1246)));
                                    }
                                    let _e1264 = phi_5073_;
                                    let _e1268 = select(_e1264.member, _e1238.member, (_e1238.member > _e1264.member));
                                    let _e1270 = select(0f, _e1268, (_e1268 > 0f));
                                    let _e1272 = select(_e1264.member_1, _e1238.member_1, (_e1238.member_1 < _e1264.member_1));
                                    let _e1274 = select(1f, _e1272, (_e1272 < 1f));
                                    if (_e1270 > _e1274) {
                                        phi_5121_ = type_40(_e623.member.member_5.z, -2f);
                                    } else {
                                        let _e1277 = (_e623.member.member_1.z + (_e1214 * _e1270));
                                        let _e1279 = (_e623.member.member_1.z + (_e1214 * _e1274));
                                        phi_5121_ = type_40(select(_e1279, _e1277, (_e1277 < _e1279)), select(_e1279, _e1277, (_e1277 > _e1279)));
                                    }
                                    let _e1288 = phi_5121_;
                                    let _e1291 = (_e623.member.member.x - _e623.member.member_2.x);
                                    let _e1292 = (_e623.member.member.y - _e623.member.member_2.y);
                                    let _e1293 = (_e623.member.member.z - _e623.member.member_2.z);
                                    let _e1294 = (_e1128 - _e623.member.member_2.x);
                                    let _e1295 = (_e1130 - _e623.member.member_2.x);
                                    if (abs(_e1291) < 0.000001f) {
                                        if (_e1294 <= 0f) {
                                            let _e1306 = (_e1295 >= 0f);
                                            if _e1306 {
                                                phi_5170_ = type_40(0f, 1f);
                                            } else {
                                                phi_5170_ = type_40();
                                            }
                                            let _e1308 = phi_5170_;
                                            phi_5173_ = _e1308;
                                            phi_5174_ = select(true, false, _e1306);
                                        } else {
                                            phi_5173_ = type_40();
                                            phi_5174_ = true;
                                        }
                                        let _e1311 = phi_5173_;
                                        let _e1313 = phi_5174_;
                                        if _e1313 {
                                            phi_5179_ = type_40(1f, 0f);
                                        } else {
                                            phi_5179_ = _e1311;
                                        }
                                        let _e1315 = phi_5179_;
                                        phi_5181_ = _e1315;
                                    } else {
                                        let _e1298 = (_e1294 / _e1291);
                                        let _e1299 = (_e1295 / _e1291);
                                        phi_5181_ = type_40(select(_e1299, _e1298, (_e1298 < _e1299)), select(_e1299, _e1298, (_e1298 > _e1299)));
                                    }
                                    let _e1317 = phi_5181_;
                                    let _e1320 = (_e1157 - _e623.member.member_2.y);
                                    let _e1321 = (_e1159 - _e623.member.member_2.y);
                                    if (abs(_e1292) < 0.000001f) {
                                        if (_e1320 <= 0f) {
                                            let _e1332 = (_e1321 >= 0f);
                                            if _e1332 {
                                                phi_5217_ = type_40(0f, 1f);
                                            } else {
                                                phi_5217_ = type_40();
                                            }
                                            let _e1334 = phi_5217_;
                                            phi_5220_ = _e1334;
                                            phi_5221_ = select(true, false, _e1332);
                                        } else {
                                            phi_5220_ = type_40();
                                            phi_5221_ = true;
                                        }
                                        let _e1337 = phi_5220_;
                                        let _e1339 = phi_5221_;
                                        if _e1339 {
                                            phi_5226_ = type_40(1f, 0f);
                                        } else {
                                            phi_5226_ = _e1337;
                                        }
                                        let _e1341 = phi_5226_;
                                        phi_5228_ = _e1341;
                                    } else {
                                        let _e1324 = (_e1320 / _e1292);
                                        let _e1325 = (_e1321 / _e1292);
                                        phi_5228_ = type_40(select(_e1325, _e1324, (_e1324 < _e1325)), select(_e1325, _e1324, (_e1324 > _e1325)));
                                    }
                                    let _e1343 = phi_5228_;
                                    let _e1347 = select(_e1343.member, _e1317.member, (_e1317.member > _e1343.member));
                                    let _e1349 = select(0f, _e1347, (_e1347 > 0f));
                                    let _e1351 = select(_e1343.member_1, _e1317.member_1, (_e1317.member_1 < _e1343.member_1));
                                    let _e1353 = select(1f, _e1351, (_e1351 < 1f));
                                    if (_e1349 > _e1353) {
                                        phi_5276_ = type_40(_e623.member.member_5.z, -2f);
                                    } else {
                                        let _e1356 = (_e623.member.member_2.z + (_e1293 * _e1349));
                                        let _e1358 = (_e623.member.member_2.z + (_e1293 * _e1353));
                                        phi_5276_ = type_40(select(_e1358, _e1356, (_e1356 < _e1358)), select(_e1358, _e1356, (_e1356 > _e1358)));
                                    }
                                    let _e1367 = phi_5276_;
                                    let _e1371 = select(_e1288.member, _e1206.member, (_e1206.member < _e1288.member));
                                    let _e1377 = select(_e1288.member_1, _e1206.member_1, (_e1206.member_1 > _e1288.member_1));
                                    phi_2156_ = type_40((floor(select(_e1367.member, _e1371, (_e1371 < _e1367.member))) - 1f), (floor(select(_e1367.member_1, _e1377, (_e1377 > _e1367.member_1))) + 1f));
                                } else {
                                    if (_e623.member.member_4 == 0u) {
                                        phi_2114_ = vec3<f32>(_e623.member.member_3.y, _e623.member.member_3.z, _e623.member.member_3.x);
                                    } else {
                                        if (_e623.member.member_4 == 1u) {
                                            phi_2113_ = vec3<f32>(_e623.member.member_3.z, _e623.member.member_3.x, _e623.member.member_3.y);
                                        } else {
                                            phi_2113_ = _e623.member.member_3;
                                        }
                                        let _e1081 = phi_2113_;
                                        phi_2114_ = _e1081;
                                    }
                                    let _e1087 = phi_2114_;
                                    let _e1104 = (_e623.member.member.z - (((_e1087.x * ((f32(_e1073) + 0.5f) - _e623.member.member.x)) + (_e1087.y * ((f32(_e1072) + 0.5f) - _e623.member.member.y))) / _e1087.z));
                                    let _e1111 = (((0.5f * (abs(_e1087.x) + abs(_e1087.y))) / abs(_e1087.z)) + 0.3f);
                                    phi_2156_ = type_40((-1f - floor((_e1111 - _e1104))), floor((_e1104 + _e1111)));
                                }
                                let _e1384 = phi_2156_;
                                let _e1387 = f32(_e623.member_4);
                                let _e1389 = select(_e1387, _e1384.member, (_e1384.member > _e1387));
                                let _e1398 = f32(_e623.member_5);
                                let _e1400 = select(_e1398, _e1384.member_1, (_e1384.member_1 < _e1398));
                                phi_6382_ = select(0i, select(select(i32(_e1400), i32(-2147483648), (_e1400 < -2147483600f)), 2147483647i, (_e1400 > 2147483500f)), (_e1400 == _e1400));
                                phi_5670_ = (select(0i, select(select(i32(_e1389), i32(-2147483648), (_e1389 < -2147483600f)), 2147483647i, (_e1389 > 2147483500f)), (_e1389 == _e1389)) - 1i);
                                phi_5646_ = _e1072;
                                phi_5616_ = _e1073;
                            } else {
                                phi_6382_ = _e654;
                                let _e3345 = local_54;
                                phi_5670_ = _e3345;
                                phi_5646_ = _e658;
                                phi_5616_ = _e652;
                            }
                            let _e1409 = phi_6382_;
                            let _e1411 = phi_5670_;
                            let _e1413 = phi_5646_;
                            let _e1415 = phi_5616_;
                            phi_6381_ = _e1409;
                            phi_5669_ = _e1411;
                            phi_5645_ = _e1413;
                            phi_5615_ = _e1415;
                            let _e3354 = local_55;
                            phi_2196_ = _e3354;
                        } else {
                            phi_6381_ = _e654;
                            phi_5669_ = _e656;
                            phi_5645_ = _e658;
                            phi_5615_ = _e652;
                            phi_2196_ = false;
                        }
                        let _e1417 = phi_6381_;
                        let _e1419 = phi_5669_;
                        let _e1421 = phi_5645_;
                        let _e1423 = phi_5615_;
                        let _e1425 = phi_2196_;
                        local_50 = _e1423;
                        local_51 = _e1417;
                        local_52 = _e1419;
                        local_53 = _e1421;
                        local_15 = select(true, false, _e659);
                        local_16 = _e1423;
                        local_17 = _e1421;
                        local_18 = _e1419;
                        continue;
                        continuing {
                            phi_5380_ = _e1423;
                            phi_5377_ = _e1417;
                            phi_5374_ = _e1419;
                            phi_5371_ = _e1421;
                            break if !(_e1425);
                        }
                    }
                    let _e1429 = local_15;
                    let _e1431 = select(false, true, select(true, false, _e1429));
                    if _e1431 {
                        let _e1433 = local_16;
                        let _e1434 = f32(_e1433);
                        let _e1436 = local_17;
                        let _e1437 = f32(_e1436);
                        let _e1439 = local_18;
                        let _e1440 = f32(_e1439);
                        let _e1441 = vec3<f32>(_e1434, _e1437, _e1440);
                        if (_e623.member.member_4 == 2u) {
                            phi_2226_ = 2u;
                        } else {
                            phi_2226_ = (1u - _e623.member.member_4);
                        }
                        let _e1445 = phi_2226_;
                        if (_e1445 == 0u) {
                            phi_2238_ = vec3<f32>(_e1437, _e1440, _e1434);
                        } else {
                            if (_e1445 == 1u) {
                                phi_2237_ = vec3<f32>(_e1440, _e1434, _e1437);
                            } else {
                                phi_2237_ = _e1441;
                            }
                            let _e1450 = phi_2237_;
                            phi_2238_ = _e1450;
                        }
                        let _e1453 = phi_2238_;
                        let _e1459 = select(select(u32(_e1453.x), 0u, (_e1453.x < 0f)), 4294967295u, (_e1453.x > 4294967000f));
                        let _e1465 = select(select(u32(_e1453.y), 0u, (_e1453.y < 0f)), 4294967295u, (_e1453.y > 4294967000f));
                        let _e1471 = select(select(u32(_e1453.z), 0u, (_e1453.z < 0f)), 4294967295u, (_e1453.z > 4294967000f));
                        local_6.member = array<vec3<f32>, 10>((_e250 - _e1441), (_e257 - _e1441), (_e264 - _e1441), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        local_6.member_1 = 3u;
                        let _e1478 = local_6.member_1;
                        phi_2296_ = type_8(0u, _e1478);
                        phi_2299_ = 0f;
                        loop {
                            let _e1481 = phi_2296_;
                            let _e1483 = phi_2299_;
                            local_19 = _e1483;
                            if (_e1481.member < _e1481.member_1) {
                                phi_2297_ = type_8((_e1481.member + 1u), _e1481.member_1);
                                phi_2322_ = type_8(1u, _e1481.member);
                            } else {
                                phi_2297_ = _e1481;
                                phi_2322_ = type_8(0u, type_8().member_1);
                            }
                            let _e1496 = phi_2297_;
                            let _e1498 = phi_2322_;
                            let _e1502 = (bitcast<i32>(_e1498.member) != 0i);
                            if _e1502 {
                                if (_e1498.member_1 < 10u) {
                                } else {
                                    phi_5752_ = true;
                                    break;
                                }
                                let _e1506 = local_6.member[_e1498.member_1];
                                phi_2300_ = select(_e1506.x, _e1483, (_e1483 < _e1506.x));
                            } else {
                                phi_2300_ = f32();
                            }
                            let _e1511 = phi_2300_;
                            continue;
                            continuing {
                                phi_2296_ = _e1496;
                                phi_2299_ = _e1511;
                                phi_5752_ = _e642;
                                break if !(_e1502);
                            }
                        }
                        let _e1514 = phi_5752_;
                        phi_6093_ = _e1514;
                        if _e1514 {
                            break;
                        }
                        let _e1516 = local_19;
                        if (_e1516 >= 0f) {
                            phi_5974_ = _e1514;
                        } else {
                            let _e1518 = local_6.member_1;
                            if (_e1518 == 0u) {
                                phi_5975_ = _e1514;
                            } else {
                                local_5[0u] = vec3<f32>(0f, 0f, 0f);
                                local_5[1u] = vec3<f32>(0f, 0f, 0f);
                                local_5[2u] = vec3<f32>(0f, 0f, 0f);
                                local_5[3u] = vec3<f32>(0f, 0f, 0f);
                                local_5[4u] = vec3<f32>(0f, 0f, 0f);
                                local_5[5u] = vec3<f32>(0f, 0f, 0f);
                                local_5[6u] = vec3<f32>(0f, 0f, 0f);
                                local_5[7u] = vec3<f32>(0f, 0f, 0f);
                                local_5[8u] = vec3<f32>(0f, 0f, 0f);
                                local_5[9u] = vec3<f32>(0f, 0f, 0f);
                                let _e1530 = local_6.member_1;
                                let _e1531 = (_e1530 - 1u);
                                if (_e1531 < 10u) {
                                } else {
                                    phi_6093_ = true;
                                    break;
                                }
                                let _e1535 = local_6.member[_e1531];
                                let _e1537 = local_6.member_1;
                                phi_2400_ = type_8(0u, _e1537);
                                phi_2403_ = _e1535.x;
                                phi_2405_ = _e1535;
                                phi_2407_ = 0u;
                                loop {
                                    let _e1540 = phi_2400_;
                                    let _e1542 = phi_2403_;
                                    let _e1544 = phi_2405_;
                                    let _e1546 = phi_2407_;
                                    local_20 = _e1546;
                                    if (_e1540.member < _e1540.member_1) {
                                        phi_2401_ = type_8((_e1540.member + 1u), _e1540.member_1);
                                        phi_2430_ = type_8(1u, _e1540.member);
                                    } else {
                                        phi_2401_ = _e1540;
                                        phi_2430_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e1559 = phi_2401_;
                                    let _e1561 = phi_2430_;
                                    let _e1565 = (bitcast<i32>(_e1561.member) != 0i);
                                    if _e1565 {
                                        if (_e1561.member_1 < 10u) {
                                        } else {
                                            phi_5962_ = true;
                                            break;
                                        }
                                        let _e1569 = local_6.member[_e1561.member_1];
                                        if ((_e1569.x < 0f) != (_e1542 < 0f)) {
                                            let _e1576 = (_e1546 < 10u);
                                            if _e1576 {
                                                let _e1584 = (_e1542 / (_e1542 - _e1569.x));
                                                if _e1576 {
                                                } else {
                                                    phi_5962_ = true;
                                                    break;
                                                }
                                                local_5[_e1546] = (_e1544 + vec3<f32>(((_e1569.x - _e1544.x) * _e1584), ((_e1569.y - _e1544.y) * _e1584), ((_e1569.z - _e1544.z) * _e1584)));
                                                phi_2490_ = (_e1546 + 1u);
                                            } else {
                                                phi_2490_ = _e1546;
                                            }
                                            let _e1593 = phi_2490_;
                                            phi_2491_ = _e1593;
                                        } else {
                                            phi_2491_ = _e1546;
                                        }
                                        let _e1595 = phi_2491_;
                                        if (_e1569.x >= 0f) {
                                            let _e1597 = (_e1595 < 10u);
                                            if _e1597 {
                                                if _e1597 {
                                                } else {
                                                    phi_5962_ = true;
                                                    break;
                                                }
                                                local_5[_e1595] = _e1569;
                                                phi_2507_ = (_e1595 + 1u);
                                            } else {
                                                phi_2507_ = _e1595;
                                            }
                                            let _e1601 = phi_2507_;
                                            phi_2508_ = _e1601;
                                        } else {
                                            phi_2508_ = _e1595;
                                        }
                                        let _e1603 = phi_2508_;
                                        phi_2404_ = _e1569.x;
                                        phi_2406_ = _e1569;
                                        phi_2408_ = _e1603;
                                    } else {
                                        phi_2404_ = f32();
                                        phi_2406_ = vec3<f32>();
                                        phi_2408_ = u32();
                                    }
                                    let _e1605 = phi_2404_;
                                    let _e1607 = phi_2406_;
                                    let _e1609 = phi_2408_;
                                    continue;
                                    continuing {
                                        phi_2400_ = _e1559;
                                        phi_2403_ = _e1605;
                                        phi_2405_ = _e1607;
                                        phi_2407_ = _e1609;
                                        phi_5962_ = _e1514;
                                        break if !(_e1565);
                                    }
                                }
                                let _e1612 = phi_5962_;
                                phi_6093_ = _e1612;
                                if _e1612 {
                                    break;
                                }
                                let _e1613 = local_5;
                                local_6.member = _e1613;
                                let _e1615 = local_20;
                                local_6.member_1 = _e1615;
                                phi_5975_ = _e1612;
                            }
                            let _e1617 = phi_5975_;
                            phi_5974_ = _e1617;
                        }
                        let _e1619 = phi_5974_;
                        let _e1620 = local_6.member_1;
                        phi_2521_ = type_8(0u, _e1620);
                        phi_2524_ = 0f;
                        loop {
                            let _e1623 = phi_2521_;
                            let _e1625 = phi_2524_;
                            local_21 = _e1625;
                            if (_e1623.member < _e1623.member_1) {
                                phi_2522_ = type_8((_e1623.member + 1u), _e1623.member_1);
                                phi_2547_ = type_8(1u, _e1623.member);
                            } else {
                                phi_2522_ = _e1623;
                                phi_2547_ = type_8(0u, type_8().member_1);
                            }
                            let _e1638 = phi_2522_;
                            let _e1640 = phi_2547_;
                            let _e1644 = (bitcast<i32>(_e1640.member) != 0i);
                            if _e1644 {
                                if (_e1640.member_1 < 10u) {
                                } else {
                                    phi_5970_ = true;
                                    break;
                                }
                                let _e1648 = local_6.member[_e1640.member_1];
                                let _e1651 = ((-1f * _e1648.x) + 1f);
                                phi_2525_ = select(_e1651, _e1625, (_e1625 < _e1651));
                            } else {
                                phi_2525_ = f32();
                            }
                            let _e1655 = phi_2525_;
                            continue;
                            continuing {
                                phi_2521_ = _e1638;
                                phi_2524_ = _e1655;
                                phi_5970_ = _e1619;
                                break if !(_e1644);
                            }
                        }
                        let _e1658 = phi_5970_;
                        phi_6093_ = _e1658;
                        if _e1658 {
                            break;
                        }
                        let _e1660 = local_21;
                        if (_e1660 >= 0f) {
                            phi_5989_ = _e1658;
                        } else {
                            let _e1662 = local_6.member_1;
                            if (_e1662 == 0u) {
                                phi_5990_ = _e1658;
                            } else {
                                local_4[0u] = vec3<f32>(0f, 0f, 0f);
                                local_4[1u] = vec3<f32>(0f, 0f, 0f);
                                local_4[2u] = vec3<f32>(0f, 0f, 0f);
                                local_4[3u] = vec3<f32>(0f, 0f, 0f);
                                local_4[4u] = vec3<f32>(0f, 0f, 0f);
                                local_4[5u] = vec3<f32>(0f, 0f, 0f);
                                local_4[6u] = vec3<f32>(0f, 0f, 0f);
                                local_4[7u] = vec3<f32>(0f, 0f, 0f);
                                local_4[8u] = vec3<f32>(0f, 0f, 0f);
                                local_4[9u] = vec3<f32>(0f, 0f, 0f);
                                let _e1674 = local_6.member_1;
                                let _e1675 = (_e1674 - 1u);
                                if (_e1675 < 10u) {
                                } else {
                                    phi_6093_ = true;
                                    break;
                                }
                                let _e1679 = local_6.member[_e1675];
                                let _e1683 = local_6.member_1;
                                phi_2619_ = type_8(0u, _e1683);
                                phi_2622_ = ((-1f * _e1679.x) + 1f);
                                phi_2624_ = _e1679;
                                phi_2626_ = 0u;
                                loop {
                                    let _e1686 = phi_2619_;
                                    let _e1688 = phi_2622_;
                                    let _e1690 = phi_2624_;
                                    let _e1692 = phi_2626_;
                                    local_22 = _e1692;
                                    if (_e1686.member < _e1686.member_1) {
                                        phi_2620_ = type_8((_e1686.member + 1u), _e1686.member_1);
                                        phi_2649_ = type_8(1u, _e1686.member);
                                    } else {
                                        phi_2620_ = _e1686;
                                        phi_2649_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e1705 = phi_2620_;
                                    let _e1707 = phi_2649_;
                                    let _e1711 = (bitcast<i32>(_e1707.member) != 0i);
                                    if _e1711 {
                                        if (_e1707.member_1 < 10u) {
                                        } else {
                                            phi_5977_ = true;
                                            break;
                                        }
                                        let _e1715 = local_6.member[_e1707.member_1];
                                        let _e1720 = ((-1f * _e1715.x) + 1f);
                                        if ((_e1720 < 0f) != (_e1688 < 0f)) {
                                            let _e1724 = (_e1692 < 10u);
                                            if _e1724 {
                                                let _e1732 = (_e1688 / (_e1688 - _e1720));
                                                if _e1724 {
                                                } else {
                                                    phi_5977_ = true;
                                                    break;
                                                }
                                                local_4[_e1692] = (_e1690 + vec3<f32>(((_e1715.x - _e1690.x) * _e1732), ((_e1715.y - _e1690.y) * _e1732), ((_e1715.z - _e1690.z) * _e1732)));
                                                phi_2706_ = (_e1692 + 1u);
                                            } else {
                                                phi_2706_ = _e1692;
                                            }
                                            let _e1741 = phi_2706_;
                                            phi_2707_ = _e1741;
                                        } else {
                                            phi_2707_ = _e1692;
                                        }
                                        let _e1743 = phi_2707_;
                                        if (_e1720 >= 0f) {
                                            let _e1745 = (_e1743 < 10u);
                                            if _e1745 {
                                                if _e1745 {
                                                } else {
                                                    phi_5977_ = true;
                                                    break;
                                                }
                                                local_4[_e1743] = _e1715;
                                                phi_2723_ = (_e1743 + 1u);
                                            } else {
                                                phi_2723_ = _e1743;
                                            }
                                            let _e1749 = phi_2723_;
                                            phi_2724_ = _e1749;
                                        } else {
                                            phi_2724_ = _e1743;
                                        }
                                        let _e1751 = phi_2724_;
                                        phi_2623_ = _e1720;
                                        phi_2625_ = _e1715;
                                        phi_2627_ = _e1751;
                                    } else {
                                        phi_2623_ = f32();
                                        phi_2625_ = vec3<f32>();
                                        phi_2627_ = u32();
                                    }
                                    let _e1753 = phi_2623_;
                                    let _e1755 = phi_2625_;
                                    let _e1757 = phi_2627_;
                                    continue;
                                    continuing {
                                        phi_2619_ = _e1705;
                                        phi_2622_ = _e1753;
                                        phi_2624_ = _e1755;
                                        phi_2626_ = _e1757;
                                        phi_5977_ = _e1658;
                                        break if !(_e1711);
                                    }
                                }
                                let _e1760 = phi_5977_;
                                phi_6093_ = _e1760;
                                if _e1760 {
                                    break;
                                }
                                let _e1761 = local_4;
                                local_6.member = _e1761;
                                let _e1763 = local_22;
                                local_6.member_1 = _e1763;
                                phi_5990_ = _e1760;
                            }
                            let _e1765 = phi_5990_;
                            phi_5989_ = _e1765;
                        }
                        let _e1767 = phi_5989_;
                        let _e1768 = local_6.member_1;
                        phi_2731_ = type_8(0u, _e1768);
                        phi_2734_ = 0f;
                        loop {
                            let _e1771 = phi_2731_;
                            let _e1773 = phi_2734_;
                            local_23 = _e1773;
                            if (_e1771.member < _e1771.member_1) {
                                phi_2732_ = type_8((_e1771.member + 1u), _e1771.member_1);
                                phi_2757_ = type_8(1u, _e1771.member);
                            } else {
                                phi_2732_ = _e1771;
                                phi_2757_ = type_8(0u, type_8().member_1);
                            }
                            let _e1786 = phi_2732_;
                            let _e1788 = phi_2757_;
                            let _e1792 = (bitcast<i32>(_e1788.member) != 0i);
                            if _e1792 {
                                if (_e1788.member_1 < 10u) {
                                } else {
                                    phi_5985_ = true;
                                    break;
                                }
                                let _e1796 = local_6.member[_e1788.member_1];
                                phi_2735_ = select(_e1796.y, _e1773, (_e1773 < _e1796.y));
                            } else {
                                phi_2735_ = f32();
                            }
                            let _e1801 = phi_2735_;
                            continue;
                            continuing {
                                phi_2731_ = _e1786;
                                phi_2734_ = _e1801;
                                phi_5985_ = _e1767;
                                break if !(_e1792);
                            }
                        }
                        let _e1804 = phi_5985_;
                        phi_6093_ = _e1804;
                        if _e1804 {
                            break;
                        }
                        let _e1806 = local_23;
                        if (_e1806 >= 0f) {
                            phi_6004_ = _e1804;
                        } else {
                            let _e1808 = local_6.member_1;
                            if (_e1808 == 0u) {
                                phi_6005_ = _e1804;
                            } else {
                                local_3[0u] = vec3<f32>(0f, 0f, 0f);
                                local_3[1u] = vec3<f32>(0f, 0f, 0f);
                                local_3[2u] = vec3<f32>(0f, 0f, 0f);
                                local_3[3u] = vec3<f32>(0f, 0f, 0f);
                                local_3[4u] = vec3<f32>(0f, 0f, 0f);
                                local_3[5u] = vec3<f32>(0f, 0f, 0f);
                                local_3[6u] = vec3<f32>(0f, 0f, 0f);
                                local_3[7u] = vec3<f32>(0f, 0f, 0f);
                                local_3[8u] = vec3<f32>(0f, 0f, 0f);
                                local_3[9u] = vec3<f32>(0f, 0f, 0f);
                                let _e1820 = local_6.member_1;
                                let _e1821 = (_e1820 - 1u);
                                if (_e1821 < 10u) {
                                } else {
                                    phi_6093_ = true;
                                    break;
                                }
                                let _e1825 = local_6.member[_e1821];
                                let _e1827 = local_6.member_1;
                                phi_2835_ = type_8(0u, _e1827);
                                phi_2838_ = _e1825.y;
                                phi_2840_ = _e1825;
                                phi_2842_ = 0u;
                                loop {
                                    let _e1830 = phi_2835_;
                                    let _e1832 = phi_2838_;
                                    let _e1834 = phi_2840_;
                                    let _e1836 = phi_2842_;
                                    local_24 = _e1836;
                                    if (_e1830.member < _e1830.member_1) {
                                        phi_2836_ = type_8((_e1830.member + 1u), _e1830.member_1);
                                        phi_2865_ = type_8(1u, _e1830.member);
                                    } else {
                                        phi_2836_ = _e1830;
                                        phi_2865_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e1849 = phi_2836_;
                                    let _e1851 = phi_2865_;
                                    let _e1855 = (bitcast<i32>(_e1851.member) != 0i);
                                    if _e1855 {
                                        if (_e1851.member_1 < 10u) {
                                        } else {
                                            phi_5992_ = true;
                                            break;
                                        }
                                        let _e1859 = local_6.member[_e1851.member_1];
                                        if ((_e1859.y < 0f) != (_e1832 < 0f)) {
                                            let _e1866 = (_e1836 < 10u);
                                            if _e1866 {
                                                let _e1874 = (_e1832 / (_e1832 - _e1859.y));
                                                if _e1866 {
                                                } else {
                                                    phi_5992_ = true;
                                                    break;
                                                }
                                                local_3[_e1836] = (_e1834 + vec3<f32>(((_e1859.x - _e1834.x) * _e1874), ((_e1859.y - _e1834.y) * _e1874), ((_e1859.z - _e1834.z) * _e1874)));
                                                phi_2925_ = (_e1836 + 1u);
                                            } else {
                                                phi_2925_ = _e1836;
                                            }
                                            let _e1883 = phi_2925_;
                                            phi_2926_ = _e1883;
                                        } else {
                                            phi_2926_ = _e1836;
                                        }
                                        let _e1885 = phi_2926_;
                                        if (_e1859.y >= 0f) {
                                            let _e1887 = (_e1885 < 10u);
                                            if _e1887 {
                                                if _e1887 {
                                                } else {
                                                    phi_5992_ = true;
                                                    break;
                                                }
                                                local_3[_e1885] = _e1859;
                                                phi_2942_ = (_e1885 + 1u);
                                            } else {
                                                phi_2942_ = _e1885;
                                            }
                                            let _e1891 = phi_2942_;
                                            phi_2943_ = _e1891;
                                        } else {
                                            phi_2943_ = _e1885;
                                        }
                                        let _e1893 = phi_2943_;
                                        phi_2839_ = _e1859.y;
                                        phi_2841_ = _e1859;
                                        phi_2843_ = _e1893;
                                    } else {
                                        phi_2839_ = f32();
                                        phi_2841_ = vec3<f32>();
                                        phi_2843_ = u32();
                                    }
                                    let _e1895 = phi_2839_;
                                    let _e1897 = phi_2841_;
                                    let _e1899 = phi_2843_;
                                    continue;
                                    continuing {
                                        phi_2835_ = _e1849;
                                        phi_2838_ = _e1895;
                                        phi_2840_ = _e1897;
                                        phi_2842_ = _e1899;
                                        phi_5992_ = _e1804;
                                        break if !(_e1855);
                                    }
                                }
                                let _e1902 = phi_5992_;
                                phi_6093_ = _e1902;
                                if _e1902 {
                                    break;
                                }
                                let _e1903 = local_3;
                                local_6.member = _e1903;
                                let _e1905 = local_24;
                                local_6.member_1 = _e1905;
                                phi_6005_ = _e1902;
                            }
                            let _e1907 = phi_6005_;
                            phi_6004_ = _e1907;
                        }
                        let _e1909 = phi_6004_;
                        let _e1910 = local_6.member_1;
                        phi_2956_ = type_8(0u, _e1910);
                        phi_2959_ = 0f;
                        loop {
                            let _e1913 = phi_2956_;
                            let _e1915 = phi_2959_;
                            local_25 = _e1915;
                            if (_e1913.member < _e1913.member_1) {
                                phi_2957_ = type_8((_e1913.member + 1u), _e1913.member_1);
                                phi_2982_ = type_8(1u, _e1913.member);
                            } else {
                                phi_2957_ = _e1913;
                                phi_2982_ = type_8(0u, type_8().member_1);
                            }
                            let _e1928 = phi_2957_;
                            let _e1930 = phi_2982_;
                            let _e1934 = (bitcast<i32>(_e1930.member) != 0i);
                            if _e1934 {
                                if (_e1930.member_1 < 10u) {
                                } else {
                                    phi_6000_ = true;
                                    break;
                                }
                                let _e1938 = local_6.member[_e1930.member_1];
                                let _e1941 = ((-1f * _e1938.y) + 1f);
                                phi_2960_ = select(_e1941, _e1915, (_e1915 < _e1941));
                            } else {
                                phi_2960_ = f32();
                            }
                            let _e1945 = phi_2960_;
                            continue;
                            continuing {
                                phi_2956_ = _e1928;
                                phi_2959_ = _e1945;
                                phi_6000_ = _e1909;
                                break if !(_e1934);
                            }
                        }
                        let _e1948 = phi_6000_;
                        phi_6093_ = _e1948;
                        if _e1948 {
                            break;
                        }
                        let _e1950 = local_25;
                        if (_e1950 >= 0f) {
                            phi_6019_ = _e1948;
                        } else {
                            let _e1952 = local_6.member_1;
                            if (_e1952 == 0u) {
                                phi_6020_ = _e1948;
                            } else {
                                local_2[0u] = vec3<f32>(0f, 0f, 0f);
                                local_2[1u] = vec3<f32>(0f, 0f, 0f);
                                local_2[2u] = vec3<f32>(0f, 0f, 0f);
                                local_2[3u] = vec3<f32>(0f, 0f, 0f);
                                local_2[4u] = vec3<f32>(0f, 0f, 0f);
                                local_2[5u] = vec3<f32>(0f, 0f, 0f);
                                local_2[6u] = vec3<f32>(0f, 0f, 0f);
                                local_2[7u] = vec3<f32>(0f, 0f, 0f);
                                local_2[8u] = vec3<f32>(0f, 0f, 0f);
                                local_2[9u] = vec3<f32>(0f, 0f, 0f);
                                let _e1964 = local_6.member_1;
                                let _e1965 = (_e1964 - 1u);
                                if (_e1965 < 10u) {
                                } else {
                                    phi_6093_ = true;
                                    break;
                                }
                                let _e1969 = local_6.member[_e1965];
                                let _e1973 = local_6.member_1;
                                phi_3054_ = type_8(0u, _e1973);
                                phi_3057_ = ((-1f * _e1969.y) + 1f);
                                phi_3059_ = _e1969;
                                phi_3061_ = 0u;
                                loop {
                                    let _e1976 = phi_3054_;
                                    let _e1978 = phi_3057_;
                                    let _e1980 = phi_3059_;
                                    let _e1982 = phi_3061_;
                                    local_26 = _e1982;
                                    if (_e1976.member < _e1976.member_1) {
                                        phi_3055_ = type_8((_e1976.member + 1u), _e1976.member_1);
                                        phi_3084_ = type_8(1u, _e1976.member);
                                    } else {
                                        phi_3055_ = _e1976;
                                        phi_3084_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e1995 = phi_3055_;
                                    let _e1997 = phi_3084_;
                                    let _e2001 = (bitcast<i32>(_e1997.member) != 0i);
                                    if _e2001 {
                                        if (_e1997.member_1 < 10u) {
                                        } else {
                                            phi_6007_ = true;
                                            break;
                                        }
                                        let _e2005 = local_6.member[_e1997.member_1];
                                        let _e2010 = ((-1f * _e2005.y) + 1f);
                                        if ((_e2010 < 0f) != (_e1978 < 0f)) {
                                            let _e2014 = (_e1982 < 10u);
                                            if _e2014 {
                                                let _e2022 = (_e1978 / (_e1978 - _e2010));
                                                if _e2014 {
                                                } else {
                                                    phi_6007_ = true;
                                                    break;
                                                }
                                                local_2[_e1982] = (_e1980 + vec3<f32>(((_e2005.x - _e1980.x) * _e2022), ((_e2005.y - _e1980.y) * _e2022), ((_e2005.z - _e1980.z) * _e2022)));
                                                phi_3141_ = (_e1982 + 1u);
                                            } else {
                                                phi_3141_ = _e1982;
                                            }
                                            let _e2031 = phi_3141_;
                                            phi_3142_ = _e2031;
                                        } else {
                                            phi_3142_ = _e1982;
                                        }
                                        let _e2033 = phi_3142_;
                                        if (_e2010 >= 0f) {
                                            let _e2035 = (_e2033 < 10u);
                                            if _e2035 {
                                                if _e2035 {
                                                } else {
                                                    phi_6007_ = true;
                                                    break;
                                                }
                                                local_2[_e2033] = _e2005;
                                                phi_3158_ = (_e2033 + 1u);
                                            } else {
                                                phi_3158_ = _e2033;
                                            }
                                            let _e2039 = phi_3158_;
                                            phi_3159_ = _e2039;
                                        } else {
                                            phi_3159_ = _e2033;
                                        }
                                        let _e2041 = phi_3159_;
                                        phi_3058_ = _e2010;
                                        phi_3060_ = _e2005;
                                        phi_3062_ = _e2041;
                                    } else {
                                        phi_3058_ = f32();
                                        phi_3060_ = vec3<f32>();
                                        phi_3062_ = u32();
                                    }
                                    let _e2043 = phi_3058_;
                                    let _e2045 = phi_3060_;
                                    let _e2047 = phi_3062_;
                                    continue;
                                    continuing {
                                        phi_3054_ = _e1995;
                                        phi_3057_ = _e2043;
                                        phi_3059_ = _e2045;
                                        phi_3061_ = _e2047;
                                        phi_6007_ = _e1948;
                                        break if !(_e2001);
                                    }
                                }
                                let _e2050 = phi_6007_;
                                phi_6093_ = _e2050;
                                if _e2050 {
                                    break;
                                }
                                let _e2051 = local_2;
                                local_6.member = _e2051;
                                let _e2053 = local_26;
                                local_6.member_1 = _e2053;
                                phi_6020_ = _e2050;
                            }
                            let _e2055 = phi_6020_;
                            phi_6019_ = _e2055;
                        }
                        let _e2057 = phi_6019_;
                        let _e2058 = local_6.member_1;
                        phi_3166_ = type_8(0u, _e2058);
                        phi_3169_ = 0f;
                        loop {
                            let _e2061 = phi_3166_;
                            let _e2063 = phi_3169_;
                            local_27 = _e2063;
                            if (_e2061.member < _e2061.member_1) {
                                phi_3167_ = type_8((_e2061.member + 1u), _e2061.member_1);
                                phi_3192_ = type_8(1u, _e2061.member);
                            } else {
                                phi_3167_ = _e2061;
                                phi_3192_ = type_8(0u, type_8().member_1);
                            }
                            let _e2076 = phi_3167_;
                            let _e2078 = phi_3192_;
                            let _e2082 = (bitcast<i32>(_e2078.member) != 0i);
                            if _e2082 {
                                if (_e2078.member_1 < 10u) {
                                } else {
                                    phi_6015_ = true;
                                    break;
                                }
                                let _e2086 = local_6.member[_e2078.member_1];
                                phi_3170_ = select(_e2086.z, _e2063, (_e2063 < _e2086.z));
                            } else {
                                phi_3170_ = f32();
                            }
                            let _e2091 = phi_3170_;
                            continue;
                            continuing {
                                phi_3166_ = _e2076;
                                phi_3169_ = _e2091;
                                phi_6015_ = _e2057;
                                break if !(_e2082);
                            }
                        }
                        let _e2094 = phi_6015_;
                        phi_6093_ = _e2094;
                        if _e2094 {
                            break;
                        }
                        let _e2096 = local_27;
                        if (_e2096 >= 0f) {
                            phi_6034_ = _e2094;
                        } else {
                            let _e2098 = local_6.member_1;
                            if (_e2098 == 0u) {
                                phi_6035_ = _e2094;
                            } else {
                                local_1[0u] = vec3<f32>(0f, 0f, 0f);
                                local_1[1u] = vec3<f32>(0f, 0f, 0f);
                                local_1[2u] = vec3<f32>(0f, 0f, 0f);
                                local_1[3u] = vec3<f32>(0f, 0f, 0f);
                                local_1[4u] = vec3<f32>(0f, 0f, 0f);
                                local_1[5u] = vec3<f32>(0f, 0f, 0f);
                                local_1[6u] = vec3<f32>(0f, 0f, 0f);
                                local_1[7u] = vec3<f32>(0f, 0f, 0f);
                                local_1[8u] = vec3<f32>(0f, 0f, 0f);
                                local_1[9u] = vec3<f32>(0f, 0f, 0f);
                                let _e2110 = local_6.member_1;
                                let _e2111 = (_e2110 - 1u);
                                if (_e2111 < 10u) {
                                } else {
                                    phi_6093_ = true;
                                    break;
                                }
                                let _e2115 = local_6.member[_e2111];
                                let _e2117 = local_6.member_1;
                                phi_3270_ = type_8(0u, _e2117);
                                phi_3273_ = _e2115.z;
                                phi_3275_ = _e2115;
                                phi_3277_ = 0u;
                                loop {
                                    let _e2120 = phi_3270_;
                                    let _e2122 = phi_3273_;
                                    let _e2124 = phi_3275_;
                                    let _e2126 = phi_3277_;
                                    local_28 = _e2126;
                                    if (_e2120.member < _e2120.member_1) {
                                        phi_3271_ = type_8((_e2120.member + 1u), _e2120.member_1);
                                        phi_3300_ = type_8(1u, _e2120.member);
                                    } else {
                                        phi_3271_ = _e2120;
                                        phi_3300_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2139 = phi_3271_;
                                    let _e2141 = phi_3300_;
                                    let _e2145 = (bitcast<i32>(_e2141.member) != 0i);
                                    if _e2145 {
                                        if (_e2141.member_1 < 10u) {
                                        } else {
                                            phi_6022_ = true;
                                            break;
                                        }
                                        let _e2149 = local_6.member[_e2141.member_1];
                                        if ((_e2149.z < 0f) != (_e2122 < 0f)) {
                                            let _e2156 = (_e2126 < 10u);
                                            if _e2156 {
                                                let _e2164 = (_e2122 / (_e2122 - _e2149.z));
                                                if _e2156 {
                                                } else {
                                                    phi_6022_ = true;
                                                    break;
                                                }
                                                local_1[_e2126] = (_e2124 + vec3<f32>(((_e2149.x - _e2124.x) * _e2164), ((_e2149.y - _e2124.y) * _e2164), ((_e2149.z - _e2124.z) * _e2164)));
                                                phi_3360_ = (_e2126 + 1u);
                                            } else {
                                                phi_3360_ = _e2126;
                                            }
                                            let _e2173 = phi_3360_;
                                            phi_3361_ = _e2173;
                                        } else {
                                            phi_3361_ = _e2126;
                                        }
                                        let _e2175 = phi_3361_;
                                        if (_e2149.z >= 0f) {
                                            let _e2177 = (_e2175 < 10u);
                                            if _e2177 {
                                                if _e2177 {
                                                } else {
                                                    phi_6022_ = true;
                                                    break;
                                                }
                                                local_1[_e2175] = _e2149;
                                                phi_3377_ = (_e2175 + 1u);
                                            } else {
                                                phi_3377_ = _e2175;
                                            }
                                            let _e2181 = phi_3377_;
                                            phi_3378_ = _e2181;
                                        } else {
                                            phi_3378_ = _e2175;
                                        }
                                        let _e2183 = phi_3378_;
                                        phi_3274_ = _e2149.z;
                                        phi_3276_ = _e2149;
                                        phi_3278_ = _e2183;
                                    } else {
                                        phi_3274_ = f32();
                                        phi_3276_ = vec3<f32>();
                                        phi_3278_ = u32();
                                    }
                                    let _e2185 = phi_3274_;
                                    let _e2187 = phi_3276_;
                                    let _e2189 = phi_3278_;
                                    continue;
                                    continuing {
                                        phi_3270_ = _e2139;
                                        phi_3273_ = _e2185;
                                        phi_3275_ = _e2187;
                                        phi_3277_ = _e2189;
                                        phi_6022_ = _e2094;
                                        break if !(_e2145);
                                    }
                                }
                                let _e2192 = phi_6022_;
                                phi_6093_ = _e2192;
                                if _e2192 {
                                    break;
                                }
                                let _e2193 = local_1;
                                local_6.member = _e2193;
                                let _e2195 = local_28;
                                local_6.member_1 = _e2195;
                                phi_6035_ = _e2192;
                            }
                            let _e2197 = phi_6035_;
                            phi_6034_ = _e2197;
                        }
                        let _e2199 = phi_6034_;
                        let _e2200 = local_6.member_1;
                        phi_3391_ = type_8(0u, _e2200);
                        phi_3394_ = 0f;
                        loop {
                            let _e2203 = phi_3391_;
                            let _e2205 = phi_3394_;
                            local_29 = _e2205;
                            if (_e2203.member < _e2203.member_1) {
                                phi_3392_ = type_8((_e2203.member + 1u), _e2203.member_1);
                                phi_3417_ = type_8(1u, _e2203.member);
                            } else {
                                phi_3392_ = _e2203;
                                phi_3417_ = type_8(0u, type_8().member_1);
                            }
                            let _e2218 = phi_3392_;
                            let _e2220 = phi_3417_;
                            let _e2224 = (bitcast<i32>(_e2220.member) != 0i);
                            if _e2224 {
                                if (_e2220.member_1 < 10u) {
                                } else {
                                    phi_6030_ = true;
                                    break;
                                }
                                let _e2228 = local_6.member[_e2220.member_1];
                                let _e2231 = ((-1f * _e2228.z) + 1f);
                                phi_3395_ = select(_e2231, _e2205, (_e2205 < _e2231));
                            } else {
                                phi_3395_ = f32();
                            }
                            let _e2235 = phi_3395_;
                            continue;
                            continuing {
                                phi_3391_ = _e2218;
                                phi_3394_ = _e2235;
                                phi_6030_ = _e2199;
                                break if !(_e2224);
                            }
                        }
                        let _e2238 = phi_6030_;
                        phi_6093_ = _e2238;
                        if _e2238 {
                            break;
                        }
                        let _e2240 = local_29;
                        if (_e2240 >= 0f) {
                            phi_6049_ = _e2238;
                        } else {
                            let _e2242 = local_6.member_1;
                            if (_e2242 == 0u) {
                                phi_6050_ = _e2238;
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
                                let _e2254 = local_6.member_1;
                                let _e2255 = (_e2254 - 1u);
                                if (_e2255 < 10u) {
                                } else {
                                    phi_6093_ = true;
                                    break;
                                }
                                let _e2259 = local_6.member[_e2255];
                                let _e2263 = local_6.member_1;
                                phi_3489_ = type_8(0u, _e2263);
                                phi_3492_ = ((-1f * _e2259.z) + 1f);
                                phi_3494_ = _e2259;
                                phi_3496_ = 0u;
                                loop {
                                    let _e2266 = phi_3489_;
                                    let _e2268 = phi_3492_;
                                    let _e2270 = phi_3494_;
                                    let _e2272 = phi_3496_;
                                    local_30 = _e2272;
                                    if (_e2266.member < _e2266.member_1) {
                                        phi_3490_ = type_8((_e2266.member + 1u), _e2266.member_1);
                                        phi_3519_ = type_8(1u, _e2266.member);
                                    } else {
                                        phi_3490_ = _e2266;
                                        phi_3519_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2285 = phi_3490_;
                                    let _e2287 = phi_3519_;
                                    let _e2291 = (bitcast<i32>(_e2287.member) != 0i);
                                    if _e2291 {
                                        if (_e2287.member_1 < 10u) {
                                        } else {
                                            phi_6037_ = true;
                                            break;
                                        }
                                        let _e2295 = local_6.member[_e2287.member_1];
                                        let _e2300 = ((-1f * _e2295.z) + 1f);
                                        if ((_e2300 < 0f) != (_e2268 < 0f)) {
                                            let _e2304 = (_e2272 < 10u);
                                            if _e2304 {
                                                let _e2312 = (_e2268 / (_e2268 - _e2300));
                                                if _e2304 {
                                                } else {
                                                    phi_6037_ = true;
                                                    break;
                                                }
                                                local[_e2272] = (_e2270 + vec3<f32>(((_e2295.x - _e2270.x) * _e2312), ((_e2295.y - _e2270.y) * _e2312), ((_e2295.z - _e2270.z) * _e2312)));
                                                phi_3576_ = (_e2272 + 1u);
                                            } else {
                                                phi_3576_ = _e2272;
                                            }
                                            let _e2321 = phi_3576_;
                                            phi_3577_ = _e2321;
                                        } else {
                                            phi_3577_ = _e2272;
                                        }
                                        let _e2323 = phi_3577_;
                                        if (_e2300 >= 0f) {
                                            let _e2325 = (_e2323 < 10u);
                                            if _e2325 {
                                                if _e2325 {
                                                } else {
                                                    phi_6037_ = true;
                                                    break;
                                                }
                                                local[_e2323] = _e2295;
                                                phi_3593_ = (_e2323 + 1u);
                                            } else {
                                                phi_3593_ = _e2323;
                                            }
                                            let _e2329 = phi_3593_;
                                            phi_3594_ = _e2329;
                                        } else {
                                            phi_3594_ = _e2323;
                                        }
                                        let _e2331 = phi_3594_;
                                        phi_3493_ = _e2300;
                                        phi_3495_ = _e2295;
                                        phi_3497_ = _e2331;
                                    } else {
                                        phi_3493_ = f32();
                                        phi_3495_ = vec3<f32>();
                                        phi_3497_ = u32();
                                    }
                                    let _e2333 = phi_3493_;
                                    let _e2335 = phi_3495_;
                                    let _e2337 = phi_3497_;
                                    continue;
                                    continuing {
                                        phi_3489_ = _e2285;
                                        phi_3492_ = _e2333;
                                        phi_3494_ = _e2335;
                                        phi_3496_ = _e2337;
                                        phi_6037_ = _e2238;
                                        break if !(_e2291);
                                    }
                                }
                                let _e2340 = phi_6037_;
                                phi_6093_ = _e2340;
                                if _e2340 {
                                    break;
                                }
                                let _e2341 = local;
                                local_6.member = _e2341;
                                let _e2343 = local_30;
                                local_6.member_1 = _e2343;
                                phi_6050_ = _e2340;
                            }
                            let _e2345 = phi_6050_;
                            phi_6049_ = _e2345;
                        }
                        let _e2347 = phi_6049_;
                        let _e2350 = local_6.member[0u];
                        let _e2354 = local_6.member_1;
                        phi_3606_ = type_8(1u, _e2354);
                        phi_3609_ = vec3<f32>(0f, 0f, 0f);
                        phi_3611_ = _e2350.z;
                        phi_3613_ = _e2350.y;
                        phi_3615_ = _e2350.x;
                        phi_3617_ = 0f;
                        loop {
                            let _e2357 = phi_3606_;
                            let _e2359 = phi_3609_;
                            let _e2361 = phi_3611_;
                            let _e2363 = phi_3613_;
                            let _e2365 = phi_3615_;
                            let _e2367 = phi_3617_;
                            local_31 = _e2365;
                            local_32 = _e2363;
                            local_33 = _e2361;
                            local_34 = _e2367;
                            local_35 = _e2359;
                            local_36 = _e2367;
                            local_37 = _e2359;
                            local_38 = _e2367;
                            local_39 = _e2359;
                            local_40 = _e2367;
                            local_41 = _e2367;
                            if (_e2357.member < _e2357.member_1) {
                                phi_3607_ = type_8((_e2357.member + 1u), _e2357.member_1);
                                phi_3640_ = type_8(1u, _e2357.member);
                            } else {
                                phi_3607_ = _e2357;
                                phi_3640_ = type_8(0u, type_8().member_1);
                            }
                            let _e2380 = phi_3607_;
                            let _e2382 = phi_3640_;
                            let _e2386 = (bitcast<i32>(_e2382.member) != 0i);
                            if _e2386 {
                                if (_e2382.member_1 < 10u) {
                                } else {
                                    phi_6045_ = true;
                                    break;
                                }
                                let _e2390 = local_6.member[_e2382.member_1];
                                let _e2400 = (_e2382.member_1 + 1u);
                                let _e2401 = local_6.member_1;
                                if (_e2400 < _e2401) {
                                    if (_e2400 < 10u) {
                                    } else {
                                        phi_6045_ = true;
                                        break;
                                    }
                                    let _e2406 = local_6.member[_e2400];
                                    let _e2407 = (_e2390.x - _e2350.x);
                                    let _e2408 = (_e2390.y - _e2350.y);
                                    let _e2409 = (_e2390.z - _e2350.z);
                                    let _e2411 = (_e2406.x - _e2350.x);
                                    let _e2413 = (_e2406.y - _e2350.y);
                                    let _e2415 = (_e2406.z - _e2350.z);
                                    let _e2418 = ((_e2408 * _e2415) - (_e2413 * _e2409));
                                    let _e2421 = ((_e2409 * _e2411) - (_e2415 * _e2407));
                                    let _e2424 = ((_e2407 * _e2413) - (_e2411 * _e2408));
                                    let _e2430 = sqrt((((_e2418 * _e2418) + (_e2421 * _e2421)) + (_e2424 * _e2424)));
                                    let _e2442 = (_e2430 * 0.16666667f);
                                    phi_3754_ = vec3<f32>((_e2359.x + (((_e2390.x + _e2406.x) - (_e2350.x * 2f)) * _e2442)), (_e2359.y + (((_e2390.y + _e2406.y) - (_e2350.y * 2f)) * _e2442)), (_e2359.z + (((_e2390.z + _e2406.z) - (_e2350.z * 2f)) * _e2442)));
                                    phi_3755_ = (_e2367 + (0.5f * _e2430));
                                } else {
                                    phi_3754_ = _e2359;
                                    phi_3755_ = _e2367;
                                }
                                let _e2454 = phi_3754_;
                                let _e2456 = phi_3755_;
                                phi_3610_ = _e2454;
                                phi_3612_ = select(_e2390.z, _e2361, (_e2361 < _e2390.z));
                                phi_3614_ = select(_e2390.y, _e2363, (_e2363 < _e2390.y));
                                phi_3616_ = select(_e2390.x, _e2365, (_e2365 < _e2390.x));
                                phi_3618_ = _e2456;
                            } else {
                                phi_3610_ = vec3<f32>();
                                phi_3612_ = f32();
                                phi_3614_ = f32();
                                phi_3616_ = f32();
                                phi_3618_ = f32();
                            }
                            let _e2458 = phi_3610_;
                            let _e2460 = phi_3612_;
                            let _e2462 = phi_3614_;
                            let _e2464 = phi_3616_;
                            let _e2466 = phi_3618_;
                            continue;
                            continuing {
                                phi_3606_ = _e2380;
                                phi_3609_ = _e2458;
                                phi_3611_ = _e2460;
                                phi_3613_ = _e2462;
                                phi_3615_ = _e2464;
                                phi_3617_ = _e2466;
                                phi_6045_ = _e2347;
                                break if !(_e2386);
                            }
                        }
                        let _e2469 = phi_6045_;
                        phi_6093_ = _e2469;
                        if _e2469 {
                            break;
                        }
                        let _e2470 = local_6.member_1;
                        if (_e2470 == 0u) {
                            phi_3774_ = bool();
                            phi_3775_ = true;
                        } else {
                            let _e2473 = local_31;
                            if (_e2473 >= 1f) {
                                phi_3772_ = bool();
                                phi_3773_ = true;
                            } else {
                                let _e2476 = local_32;
                                let _e2477 = (_e2476 >= 1f);
                                if _e2477 {
                                    phi_3771_ = bool();
                                } else {
                                    let _e2479 = local_33;
                                    phi_3771_ = (_e2479 >= 1f);
                                }
                                let _e2482 = phi_3771_;
                                phi_3772_ = _e2482;
                                phi_3773_ = _e2477;
                            }
                            let _e2484 = phi_3772_;
                            let _e2486 = phi_3773_;
                            phi_3774_ = _e2484;
                            phi_3775_ = _e2486;
                        }
                        let _e2488 = phi_3774_;
                        let _e2490 = phi_3775_;
                        let _e2493 = local_34;
                        if (_e2493 > 0f) {
                            let _e2496 = local_35;
                            let _e2499 = local_36;
                            let _e2502 = local_37;
                            let _e2505 = local_38;
                            let _e2508 = local_39;
                            let _e2511 = local_40;
                            phi_3792_ = (_e2350 + vec3<f32>((_e2496.x / _e2499), (_e2502.y / _e2505), (_e2508.z / _e2511)));
                        } else {
                            phi_3792_ = _e2350;
                        }
                        let _e2516 = phi_3792_;
                        let _e2518 = local_41;
                        let _e2522 = select(0f, _e2516.x, (_e2516.x > 0f));
                        let _e2524 = select(1f, _e2522, (_e2522 < 1f));
                        let _e2527 = select(0f, _e2516.y, (_e2516.y > 0f));
                        let _e2529 = select(1f, _e2527, (_e2527 < 1f));
                        let _e2532 = select(0f, _e2516.z, (_e2516.z > 0f));
                        let _e2534 = select(1f, _e2532, (_e2532 < 1f));
                        let _e2539 = local_42;
                        if (_e2539 < arrayLength((&attributes.member))) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e2541 = ((_e2524 + _e1434) - _e250.x);
                        let _e2542 = ((_e2529 + _e1437) - _e250.y);
                        let _e2545 = ((_e499 * _e508) - (_e500 * _e507));
                        if (abs(_e2545) > 0f) {
                            phi_3864_ = (1f / _e2545);
                        } else {
                            phi_3864_ = 0f;
                        }
                        let _e2550 = phi_3864_;
                        let _e2554 = (((_e2541 * _e508) - (_e2542 * _e507)) * _e2550);
                        let _e2556 = select(0f, _e2554, (_e2554 > 0f));
                        let _e2558 = select(1f, _e2556, (_e2556 < 1f));
                        let _e2562 = (((_e499 * _e2542) - (_e500 * _e2541)) * _e2550);
                        let _e2564 = select(0f, _e2562, (_e2562 > 0f));
                        let _e2566 = select(1f, _e2564, (_e2564 < 1f));
                        let _e2568 = ((1f - _e2558) - _e2566);
                        let _e2571 = local_43;
                        let _e2575 = attributes.member[_e2571].member[0u];
                        let _e2579 = local_44;
                        let _e2583 = attributes.member[_e2579].member[2u];
                        let _e2588 = local_45;
                        let _e2592 = attributes.member[_e2588].member[4u];
                        let _e2594 = (((_e2575 * _e2568) + (_e2583 * _e2558)) + (_e2592 * _e2566));
                        let _e2597 = local_46;
                        let _e2601 = attributes.member[_e2597].member[1u];
                        let _e2605 = local_47;
                        let _e2609 = attributes.member[_e2605].member[3u];
                        let _e2614 = local_48;
                        let _e2618 = attributes.member[_e2614].member[5u];
                        let _e2620 = (((_e2601 * _e2568) + (_e2609 * _e2558)) + (_e2618 * _e2566));
                        if (_e396 == 4294967295u) {
                            phi_4213_ = type_30(vec3<f32>(_e379, _e385, _e391), _e425);
                        } else {
                            let _e2623 = (_e419 & 65535u);
                            let _e2625 = (_e419 >> bitcast<u32>(16i));
                            let _e2627 = (_e2594 - floor(_e2594));
                            let _e2632 = ((select(0f, _e2627, (_e2627 <= 1f)) * f32(_e2623)) - 0.5f);
                            let _e2633 = floor(_e2632);
                            let _e2634 = (_e2632 - _e2633);
                            let _e2635 = (_e2623 - 1u);
                            if (_e2633 < 0f) {
                                phi_3954_ = _e2635;
                            } else {
                                let _e2641 = select(select(u32(_e2633), 0u, (_e2633 < 0f)), 4294967295u, (_e2633 > 4294967000f));
                                phi_3954_ = select(_e2641, _e2635, (_e2635 < _e2641));
                            }
                            let _e2645 = phi_3954_;
                            if (_e2645 == _e2635) {
                                phi_3960_ = 0u;
                            } else {
                                phi_3960_ = (_e2645 + 1u);
                            }
                            let _e2649 = phi_3960_;
                            let _e2651 = (_e2620 - floor(_e2620));
                            let _e2656 = ((select(0f, _e2651, (_e2651 <= 1f)) * f32(_e2625)) - 0.5f);
                            let _e2657 = floor(_e2656);
                            let _e2658 = (_e2656 - _e2657);
                            let _e2659 = (_e2625 - 1u);
                            if (_e2657 < 0f) {
                                phi_3990_ = _e2659;
                            } else {
                                let _e2665 = select(select(u32(_e2657), 0u, (_e2657 < 0f)), 4294967295u, (_e2657 > 4294967000f));
                                phi_3990_ = select(_e2665, _e2659, (_e2659 < _e2665));
                            }
                            let _e2669 = phi_3990_;
                            if (_e2669 == _e2659) {
                                phi_3996_ = 0u;
                            } else {
                                phi_3996_ = (_e2669 + 1u);
                            }
                            let _e2673 = phi_3996_;
                            let _e2675 = (_e396 + (_e2669 * _e2623));
                            let _e2677 = (_e396 + (_e2673 * _e2623));
                            let _e2678 = (_e2675 + _e2645);
                            let _e2679 = (_e2675 + _e2649);
                            let _e2680 = (_e2677 + _e2645);
                            let _e2681 = (_e2677 + _e2649);
                            if (_e2678 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2685 = surfaces.member[_e2678];
                            if (_e2679 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2689 = surfaces.member[_e2679];
                            if (_e2680 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2693 = surfaces.member[_e2680];
                            if (_e2681 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2697 = surfaces.member[_e2681];
                            let _e2698 = (_e2685 & 255u);
                            if (_e2698 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2702 = surfaces.member[_e2698];
                            let _e2706 = ((_e2685 >> bitcast<u32>(8i)) & 255u);
                            if (_e2706 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2710 = surfaces.member[_e2706];
                            let _e2714 = ((_e2685 >> bitcast<u32>(16i)) & 255u);
                            if (_e2714 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2718 = surfaces.member[_e2714];
                            let _e2720 = (1f - _e2634);
                            let _e2724 = (_e2689 & 255u);
                            if (_e2724 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2728 = surfaces.member[_e2724];
                            let _e2732 = ((_e2689 >> bitcast<u32>(8i)) & 255u);
                            if (_e2732 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2736 = surfaces.member[_e2732];
                            let _e2740 = ((_e2689 >> bitcast<u32>(16i)) & 255u);
                            if (_e2740 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2744 = surfaces.member[_e2740];
                            let _e2752 = (_e2693 & 255u);
                            if (_e2752 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2756 = surfaces.member[_e2752];
                            let _e2760 = ((_e2693 >> bitcast<u32>(8i)) & 255u);
                            if (_e2760 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2764 = surfaces.member[_e2760];
                            let _e2768 = ((_e2693 >> bitcast<u32>(16i)) & 255u);
                            if (_e2768 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2772 = surfaces.member[_e2768];
                            let _e2777 = (_e2697 & 255u);
                            if (_e2777 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2781 = surfaces.member[_e2777];
                            let _e2785 = ((_e2697 >> bitcast<u32>(8i)) & 255u);
                            if (_e2785 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2789 = surfaces.member[_e2785];
                            let _e2793 = ((_e2697 >> bitcast<u32>(16i)) & 255u);
                            if (_e2793 < _e98) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2797 = surfaces.member[_e2793];
                            let _e2805 = (1f - _e2658);
                            phi_4213_ = type_30(vec3<f32>((_e379 * ((((bitcast<f32>(_e2702) * _e2720) + (bitcast<f32>(_e2728) * _e2634)) * _e2805) + (((bitcast<f32>(_e2756) * _e2720) + (bitcast<f32>(_e2781) * _e2634)) * _e2658))), (_e385 * ((((bitcast<f32>(_e2710) * _e2720) + (bitcast<f32>(_e2736) * _e2634)) * _e2805) + (((bitcast<f32>(_e2764) * _e2720) + (bitcast<f32>(_e2789) * _e2634)) * _e2658))), (_e391 * ((((bitcast<f32>(_e2718) * _e2720) + (bitcast<f32>(_e2744) * _e2634)) * _e2805) + (((bitcast<f32>(_e2772) * _e2720) + (bitcast<f32>(_e2797) * _e2634)) * _e2658)))), (_e425 * (((((f32((_e2685 >> bitcast<u32>(24i))) * 0.003921569f) * _e2720) + ((f32((_e2689 >> bitcast<u32>(24i))) * 0.003921569f) * _e2634)) * _e2805) + ((((f32((_e2693 >> bitcast<u32>(24i))) * 0.003921569f) * _e2720) + ((f32((_e2697 >> bitcast<u32>(24i))) * 0.003921569f) * _e2634)) * _e2658))));
                        }
                        let _e2848 = phi_4213_;
                        if (_e225 == 2u) {
                            phi_4243_ = 2u;
                        } else {
                            phi_4243_ = (1u - _e225);
                        }
                        let _e2867 = phi_4243_;
                        if (_e2867 == 0u) {
                            phi_4255_ = vec3<f32>(_e2529, _e2534, _e2524);
                        } else {
                            if (_e2867 == 1u) {
                                phi_4254_ = vec3<f32>(_e2534, _e2524, _e2529);
                            } else {
                                phi_4254_ = vec3<f32>(_e2524, _e2529, _e2534);
                            }
                            let _e2872 = phi_4254_;
                            phi_4255_ = _e2872;
                        }
                        let _e2875 = phi_4255_;
                        let _e2879 = params.member.member_2[0u];
                        let _e2893 = (((_e2879.z + (_e1459 >> bitcast<u32>(2i))) + (_e2879.x * (_e1465 >> bitcast<u32>(2i)))) + (_e2879.y * (_e1471 >> bitcast<u32>(1i))));
                        let _e2913 = ((2u * _e2893) + 1u);
                        if (_e2913 < arrayLength((&cells.member))) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e2917 = cells.member[_e2913];
                        phi_4295_ = type_8(0u, 6u);
                        phi_4298_ = _e2917;
                        loop {
                            let _e2919 = phi_4295_;
                            let _e2921 = phi_4298_;
                            local_49 = _e2921;
                            if (_e2919.member < _e2919.member_1) {
                                phi_4296_ = type_8((_e2919.member + 1u), _e2919.member_1);
                                phi_4321_ = type_8(1u, _e2919.member);
                            } else {
                                phi_4296_ = _e2919;
                                phi_4321_ = type_8(0u, type_8().member_1);
                            }
                            let _e2934 = phi_4296_;
                            let _e2936 = phi_4321_;
                            let _e2940 = (bitcast<i32>(_e2936.member) != 0i);
                            if _e2940 {
                                let _e2941 = ((_e2893 * 6u) + _e2936.member_1);
                                if (_e2941 < arrayLength((&facet_bits.member))) {
                                } else {
                                    phi_6055_ = true;
                                    break;
                                }
                                let _e2945 = facet_bits.member[_e2941];
                                let _e2946 = ((((((_e1459 & 1u) | ((_e1465 & 1u) << bitcast<u32>(1i))) | ((_e1471 & 1u) << bitcast<u32>(2i))) | ((_e1459 & 2u) << bitcast<u32>(2i))) | ((_e1465 & 2u) << bitcast<u32>(3i))) & 31u);
                                let _e2952 = (_e2921 + countOneBits((_e2945 & ((1u << bitcast<u32>(_e2946)) - 1u))));
                                if (_e2936.member_1 < ((2u * _e343) + select(0u, 1u, (_e348 < 0f)))) {
                                    phi_4351_ = (_e2952 + ((_e2945 >> bitcast<u32>(_e2946)) & 1u));
                                } else {
                                    phi_4351_ = _e2952;
                                }
                                let _e2959 = phi_4351_;
                                phi_4299_ = _e2959;
                            } else {
                                phi_4299_ = u32();
                            }
                            let _e2961 = phi_4299_;
                            continue;
                            continuing {
                                phi_4295_ = _e2934;
                                phi_4298_ = _e2961;
                                phi_6055_ = _e2469;
                                break if !(_e2940);
                            }
                        }
                        let _e2964 = phi_6055_;
                        phi_6093_ = _e2964;
                        if _e2964 {
                            break;
                        }
                        let _e2967 = local_49;
                        let _e2968 = (_e2967 * 13u);
                        let _e2971 = params.member.member_7;
                        let _e2974 = floor((((select(_e2518, 0f, select(_e2488, true, _e2490)) * select(1f, 0f, (_e2848.member_1 < bitcast<f32>(_e430)))) * _e2971) + 0.5f));
                        let _e2976 = select(_e2974, 1f, (_e2974 < 1f));
                        let _e2981 = select(select(u32(_e2976), 0u, (_e2976 < 0f)), 4294967295u, (_e2976 > 4294967000f));
                        if (_e2968 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e2985 = atomicAdd((&sums.member[_e2968]), _e2981);
                        if (_e2985 >= (2147483648u - select(_e2981, 2147483648u, (2147483648u < _e2981)))) {
                            let _e2992 = params.member.member_5;
                            let _e2993 = (_e2992 * 13u);
                            if (_e2993 < _e106) {
                            } else {
                                phi_6093_ = true;
                                break;
                            }
                            let _e2997 = atomicOr((&sums.member[_e2993]), 1u);
                        }
                        let _e2998 = (_e2968 + 1u);
                        let _e3006 = floor(((_e366.x * _e2976) + 0.5f));
                        if (_e2998 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3018 = atomicAdd((&sums.member[_e2998]), bitcast<u32>(select(0i, select(select(i32(_e3006), i32(-2147483648), (_e3006 < -2147483600f)), 2147483647i, (_e3006 > 2147483500f)), (_e3006 == _e3006))));
                        let _e3019 = (_e2968 + 2u);
                        let _e3021 = floor(((_e366.y * _e2976) + 0.5f));
                        if (_e3019 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3033 = atomicAdd((&sums.member[_e3019]), bitcast<u32>(select(0i, select(select(i32(_e3021), i32(-2147483648), (_e3021 < -2147483600f)), 2147483647i, (_e3021 > 2147483500f)), (_e3021 == _e3021))));
                        let _e3034 = (_e2968 + 3u);
                        let _e3036 = floor(((_e366.z * _e2976) + 0.5f));
                        if (_e3034 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3048 = atomicAdd((&sums.member[_e3034]), bitcast<u32>(select(0i, select(select(i32(_e3036), i32(-2147483648), (_e3036 < -2147483600f)), 2147483647i, (_e3036 > 2147483500f)), (_e3036 == _e3036))));
                        let _e3049 = (_e2968 + 4u);
                        let _e3057 = floor(((_e2875.x * _e2976) + 0.5f));
                        if (_e3049 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3069 = atomicAdd((&sums.member[_e3049]), bitcast<u32>(select(0i, select(select(i32(_e3057), i32(-2147483648), (_e3057 < -2147483600f)), 2147483647i, (_e3057 > 2147483500f)), (_e3057 == _e3057))));
                        let _e3070 = (_e2968 + 5u);
                        let _e3072 = floor(((_e2875.y * _e2976) + 0.5f));
                        if (_e3070 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3084 = atomicAdd((&sums.member[_e3070]), bitcast<u32>(select(0i, select(select(i32(_e3072), i32(-2147483648), (_e3072 < -2147483600f)), 2147483647i, (_e3072 > 2147483500f)), (_e3072 == _e3072))));
                        let _e3085 = (_e2968 + 6u);
                        let _e3087 = floor(((_e2875.z * _e2976) + 0.5f));
                        if (_e3085 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3099 = atomicAdd((&sums.member[_e3085]), bitcast<u32>(select(0i, select(select(i32(_e3087), i32(-2147483648), (_e3087 < -2147483600f)), 2147483647i, (_e3087 > 2147483500f)), (_e3087 == _e3087))));
                        let _e3100 = (_e2968 + 7u);
                        let _e3105 = floor(((select(1f, _e2848.member.x, (_e2848.member.x < 1f)) * _e2976) + 0.5f));
                        if (_e3100 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3117 = atomicAdd((&sums.member[_e3100]), bitcast<u32>(select(0i, select(select(i32(_e3105), i32(-2147483648), (_e3105 < -2147483600f)), 2147483647i, (_e3105 > 2147483500f)), (_e3105 == _e3105))));
                        let _e3118 = (_e2968 + 8u);
                        let _e3120 = floor(((select(1f, _e2848.member.y, (_e2848.member.y < 1f)) * _e2976) + 0.5f));
                        if (_e3118 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3132 = atomicAdd((&sums.member[_e3118]), bitcast<u32>(select(0i, select(select(i32(_e3120), i32(-2147483648), (_e3120 < -2147483600f)), 2147483647i, (_e3120 > 2147483500f)), (_e3120 == _e3120))));
                        let _e3133 = (_e2968 + 9u);
                        let _e3135 = floor(((select(1f, _e2848.member.z, (_e2848.member.z < 1f)) * _e2976) + 0.5f));
                        if (_e3133 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3147 = atomicAdd((&sums.member[_e3133]), bitcast<u32>(select(0i, select(select(i32(_e3135), i32(-2147483648), (_e3135 < -2147483600f)), 2147483647i, (_e3135 > 2147483500f)), (_e3135 == _e3135))));
                        let _e3148 = (_e2968 + 10u);
                        let _e3151 = params.member.member_8;
                        let _e3152 = (_e2976 / _e3151);
                        let _e3157 = floor(((bitcast<f32>(_e401) * _e3152) + 0.5f));
                        if (_e3148 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3169 = atomicAdd((&sums.member[_e3148]), bitcast<u32>(select(0i, select(select(i32(_e3157), i32(-2147483648), (_e3157 < -2147483600f)), 2147483647i, (_e3157 > 2147483500f)), (_e3157 == _e3157))));
                        let _e3170 = (_e2968 + 11u);
                        let _e3172 = floor(((bitcast<f32>(_e407) * _e3152) + 0.5f));
                        if (_e3170 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3184 = atomicAdd((&sums.member[_e3170]), bitcast<u32>(select(0i, select(select(i32(_e3172), i32(-2147483648), (_e3172 < -2147483600f)), 2147483647i, (_e3172 > 2147483500f)), (_e3172 == _e3172))));
                        let _e3185 = (_e2968 + 12u);
                        let _e3187 = floor(((bitcast<f32>(_e413) * _e3152) + 0.5f));
                        if (_e3185 < _e106) {
                        } else {
                            phi_6093_ = true;
                            break;
                        }
                        let _e3199 = atomicAdd((&sums.member[_e3185]), bitcast<u32>(select(0i, select(select(i32(_e3187), i32(-2147483648), (_e3187 < -2147483600f)), 2147483647i, (_e3187 > 2147483500f)), (_e3187 == _e3187))));
                        phi_6094_ = _e2964;
                    } else {
                        phi_6094_ = _e642;
                    }
                    let _e3201 = phi_6094_;
                    continue;
                    continuing {
                        phi_5763_ = _e3201;
                        let _e3242 = local_50;
                        phi_5381_ = _e3242;
                        let _e3245 = local_51;
                        phi_5378_ = _e3245;
                        let _e3248 = local_52;
                        phi_5375_ = _e3248;
                        let _e3251 = local_53;
                        phi_5372_ = _e3251;
                        phi_6093_ = _e3201;
                        break if !(_e1431);
                    }
                }
                let _e3204 = phi_6093_;
                if _e3204 {
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
