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
    var local_1: array<vec3<f32>, 10>;
    var local_2: array<vec3<f32>, 10>;
    var local_3: array<vec3<f32>, 10>;
    var local_4: array<vec3<f32>, 10>;
    var local_5: array<vec3<f32>, 10>;
    var local_6: type_43;
    var phi_710_: u32;
    var phi_713_: u32;
    var phi_711_: u32;
    var phi_714_: u32;
    var phi_5353_: bool;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_827_: bool;
    var phi_836_: u32;
    var phi_856_: vec3<f32>;
    var phi_857_: vec3<f32>;
    var phi_868_: vec3<f32>;
    var phi_869_: vec3<f32>;
    var phi_880_: vec3<f32>;
    var phi_881_: vec3<f32>;
    var phi_892_: vec3<f32>;
    var phi_893_: vec3<f32>;
    var phi_1029_: bool;
    var phi_1038_: u32;
    var phi_1048_: f32;
    var phi_1068_: vec3<f32>;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var phi_1192_: u32;
    var phi_4718_: bool;
    var phi_4757_: bool;
    var phi_4796_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1399_: type_39;
    var phi_5749_: bool;
    var phi_5367_: i32;
    var phi_5364_: i32;
    var phi_5361_: i32;
    var phi_5358_: i32;
    var phi_5366_: i32;
    var phi_5363_: i32;
    var phi_5360_: i32;
    var phi_5357_: i32;
    var phi_5359_: i32;
    var phi_1619_: bool;
    var phi_1649_: bool;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1716_: bool;
    var phi_1746_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1813_: bool;
    var phi_1843_: bool;
    var phi_1873_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1908_: bool;
    var phi_1918_: vec3<f32>;
    var phi_1919_: vec3<f32>;
    var phi_1971_: bool;
    var phi_1980_: vec3<f32>;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2023_: bool;
    var phi_2024_: bool;
    var phi_2025_: bool;
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
    var phi_2045_: bool;
    var phi_5657_: i32;
    var phi_2058_: bool;
    var local_14: bool;
    var phi_5516_: i32;
    var phi_2111_: vec3<f32>;
    var phi_2112_: vec3<f32>;
    var phi_4846_: type_33;
    var phi_4849_: type_33;
    var phi_4850_: bool;
    var phi_4855_: type_33;
    var phi_4857_: type_33;
    var phi_4893_: type_33;
    var phi_4896_: type_33;
    var phi_4897_: bool;
    var phi_4902_: type_33;
    var phi_4904_: type_33;
    var phi_4952_: type_33;
    var phi_5001_: type_33;
    var phi_5004_: type_33;
    var phi_5005_: bool;
    var phi_5010_: type_33;
    var phi_5012_: type_33;
    var phi_5048_: type_33;
    var phi_5051_: type_33;
    var phi_5052_: bool;
    var phi_5057_: type_33;
    var phi_5059_: type_33;
    var phi_5107_: type_33;
    var phi_5156_: type_33;
    var phi_5159_: type_33;
    var phi_5160_: bool;
    var phi_5165_: type_33;
    var phi_5167_: type_33;
    var phi_5203_: type_33;
    var phi_5206_: type_33;
    var phi_5207_: bool;
    var phi_5212_: type_33;
    var phi_5214_: type_33;
    var phi_5262_: type_33;
    var phi_2154_: type_33;
    var phi_6365_: i32;
    var phi_5656_: i32;
    var phi_5632_: i32;
    var phi_5602_: i32;
    var phi_6364_: i32;
    var phi_5655_: i32;
    var phi_5631_: i32;
    var phi_5601_: i32;
    var phi_2194_: bool;
    var local_15: bool;
    var local_16: i32;
    var local_17: i32;
    var local_18: i32;
    var phi_2224_: u32;
    var phi_2235_: vec3<f32>;
    var phi_2236_: vec3<f32>;
    var phi_2294_: type_12;
    var phi_2297_: f32;
    var phi_2295_: type_12;
    var phi_2320_: type_12;
    var phi_2298_: f32;
    var phi_5738_: bool;
    var local_19: f32;
    var phi_2398_: type_12;
    var phi_2401_: f32;
    var phi_2403_: vec3<f32>;
    var phi_2405_: u32;
    var phi_2399_: type_12;
    var phi_2428_: type_12;
    var phi_2488_: u32;
    var phi_2489_: u32;
    var phi_2505_: u32;
    var phi_2506_: u32;
    var phi_2402_: f32;
    var phi_2404_: vec3<f32>;
    var phi_2406_: u32;
    var phi_5948_: bool;
    var local_20: u32;
    var phi_5961_: bool;
    var phi_5960_: bool;
    var phi_2519_: type_12;
    var phi_2522_: f32;
    var phi_2520_: type_12;
    var phi_2545_: type_12;
    var phi_2523_: f32;
    var phi_5956_: bool;
    var local_21: f32;
    var phi_2617_: type_12;
    var phi_2620_: f32;
    var phi_2622_: vec3<f32>;
    var phi_2624_: u32;
    var phi_2618_: type_12;
    var phi_2647_: type_12;
    var phi_2704_: u32;
    var phi_2705_: u32;
    var phi_2721_: u32;
    var phi_2722_: u32;
    var phi_2621_: f32;
    var phi_2623_: vec3<f32>;
    var phi_2625_: u32;
    var phi_5963_: bool;
    var local_22: u32;
    var phi_5976_: bool;
    var phi_5975_: bool;
    var phi_2729_: type_12;
    var phi_2732_: f32;
    var phi_2730_: type_12;
    var phi_2755_: type_12;
    var phi_2733_: f32;
    var phi_5971_: bool;
    var local_23: f32;
    var phi_2833_: type_12;
    var phi_2836_: f32;
    var phi_2838_: vec3<f32>;
    var phi_2840_: u32;
    var phi_2834_: type_12;
    var phi_2863_: type_12;
    var phi_2923_: u32;
    var phi_2924_: u32;
    var phi_2940_: u32;
    var phi_2941_: u32;
    var phi_2837_: f32;
    var phi_2839_: vec3<f32>;
    var phi_2841_: u32;
    var phi_5978_: bool;
    var local_24: u32;
    var phi_5991_: bool;
    var phi_5990_: bool;
    var phi_2954_: type_12;
    var phi_2957_: f32;
    var phi_2955_: type_12;
    var phi_2980_: type_12;
    var phi_2958_: f32;
    var phi_5986_: bool;
    var local_25: f32;
    var phi_3052_: type_12;
    var phi_3055_: f32;
    var phi_3057_: vec3<f32>;
    var phi_3059_: u32;
    var phi_3053_: type_12;
    var phi_3082_: type_12;
    var phi_3139_: u32;
    var phi_3140_: u32;
    var phi_3156_: u32;
    var phi_3157_: u32;
    var phi_3056_: f32;
    var phi_3058_: vec3<f32>;
    var phi_3060_: u32;
    var phi_5993_: bool;
    var local_26: u32;
    var phi_6006_: bool;
    var phi_6005_: bool;
    var phi_3164_: type_12;
    var phi_3167_: f32;
    var phi_3165_: type_12;
    var phi_3190_: type_12;
    var phi_3168_: f32;
    var phi_6001_: bool;
    var local_27: f32;
    var phi_3268_: type_12;
    var phi_3271_: f32;
    var phi_3273_: vec3<f32>;
    var phi_3275_: u32;
    var phi_3269_: type_12;
    var phi_3298_: type_12;
    var phi_3358_: u32;
    var phi_3359_: u32;
    var phi_3375_: u32;
    var phi_3376_: u32;
    var phi_3272_: f32;
    var phi_3274_: vec3<f32>;
    var phi_3276_: u32;
    var phi_6008_: bool;
    var local_28: u32;
    var phi_6021_: bool;
    var phi_6020_: bool;
    var phi_3389_: type_12;
    var phi_3392_: f32;
    var phi_3390_: type_12;
    var phi_3415_: type_12;
    var phi_3393_: f32;
    var phi_6016_: bool;
    var local_29: f32;
    var phi_3487_: type_12;
    var phi_3490_: f32;
    var phi_3492_: vec3<f32>;
    var phi_3494_: u32;
    var phi_3488_: type_12;
    var phi_3517_: type_12;
    var phi_3574_: u32;
    var phi_3575_: u32;
    var phi_3591_: u32;
    var phi_3592_: u32;
    var phi_3491_: f32;
    var phi_3493_: vec3<f32>;
    var phi_3495_: u32;
    var phi_6023_: bool;
    var local_30: u32;
    var phi_6036_: bool;
    var phi_6035_: bool;
    var phi_3604_: type_12;
    var phi_3607_: vec3<f32>;
    var phi_3609_: f32;
    var phi_3611_: f32;
    var phi_3613_: f32;
    var phi_3615_: f32;
    var phi_3605_: type_12;
    var phi_3638_: type_12;
    var phi_3752_: vec3<f32>;
    var phi_3753_: f32;
    var phi_3608_: vec3<f32>;
    var phi_3610_: f32;
    var phi_3612_: f32;
    var phi_3614_: f32;
    var phi_3616_: f32;
    var phi_6031_: bool;
    var local_31: f32;
    var local_32: f32;
    var local_33: f32;
    var phi_3769_: bool;
    var phi_3770_: bool;
    var phi_3771_: bool;
    var phi_3772_: bool;
    var phi_3773_: bool;
    var local_34: f32;
    var local_35: vec3<f32>;
    var local_36: f32;
    var local_37: vec3<f32>;
    var local_38: f32;
    var local_39: vec3<f32>;
    var local_40: f32;
    var phi_3790_: vec3<f32>;
    var local_41: f32;
    var local_42: u32;
    var phi_3862_: f32;
    var local_43: u32;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: u32;
    var local_48: u32;
    var phi_3952_: u32;
    var phi_3958_: u32;
    var phi_3988_: u32;
    var phi_3994_: u32;
    var phi_4211_: type_30;
    var phi_4241_: u32;
    var phi_4252_: vec3<f32>;
    var phi_4253_: vec3<f32>;
    var phi_4288_: type_12;
    var phi_4291_: u32;
    var phi_4289_: type_12;
    var phi_4314_: type_12;
    var phi_4339_: u32;
    var phi_4292_: u32;
    var local_49: u32;
    var phi_6042_: bool;
    var phi_6041_: bool;
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
            let _e102 = arrayLength((&sums.member));
            let _e106 = (_e92.x + (_e92.y * 2097152u));
            let _e109 = params.member.member_4;
            if (_e106 < _e109) {
                let _e113 = params.member.member_3;
                phi_710_ = _e113;
                phi_713_ = 0u;
                loop {
                    let _e115 = phi_710_;
                    let _e117 = phi_713_;
                    local_7 = _e117;
                    local_8 = _e117;
                    local_9 = _e117;
                    local_10 = _e117;
                    local_11 = _e117;
                    local_12 = _e117;
                    local_13 = _e117;
                    local_42 = _e117;
                    local_43 = _e117;
                    local_44 = _e117;
                    local_45 = _e117;
                    local_46 = _e117;
                    local_47 = _e117;
                    local_48 = _e117;
                    let _e119 = ((_e115 - _e117) > 1u);
                    if _e119 {
                        let _e121 = ((_e117 + _e115) / 2u);
                        if (_e121 < _e100) {
                        } else {
                            phi_5353_ = true;
                            break;
                        }
                        let _e125 = tile_first.member[_e121];
                        let _e126 = (_e125 <= _e106);
                        phi_711_ = select(_e121, _e115, _e126);
                        phi_714_ = select(_e117, _e121, _e126);
                    } else {
                        phi_711_ = u32();
                        phi_714_ = u32();
                    }
                    let _e130 = phi_711_;
                    let _e132 = phi_714_;
                    continue;
                    continuing {
                        phi_710_ = _e130;
                        phi_713_ = _e132;
                        phi_5353_ = false;
                        break if !(_e119);
                    }
                }
                let _e135 = phi_5353_;
                if _e135 {
                    break;
                }
                let _e137 = local_7;
                if (_e137 < arrayLength((&triangles.member))) {
                } else {
                    break;
                }
                let _e141 = local_8;
                let _e144 = triangles.member[_e141].member;
                let _e150 = params.member.member;
                let _e158 = ((_e144[0] - _e150.x) / _e150.w);
                let _e159 = ((_e144[1] - _e150.y) / _e150.w);
                let _e160 = ((_e144[2] - _e150.z) / _e150.w);
                let _e164 = local_9;
                let _e167 = triangles.member[_e164].member_2;
                let _e174 = ((_e167[0] - _e150.x) / _e150.w);
                let _e175 = ((_e167[1] - _e150.y) / _e150.w);
                let _e176 = ((_e167[2] - _e150.z) / _e150.w);
                let _e180 = local_10;
                let _e183 = triangles.member[_e180].member_4;
                let _e190 = ((_e183[0] - _e150.x) / _e150.w);
                let _e191 = ((_e183[1] - _e150.y) / _e150.w);
                let _e192 = ((_e183[2] - _e150.z) / _e150.w);
                let _e194 = (_e174 - _e158);
                let _e195 = (_e175 - _e159);
                let _e196 = (_e176 - _e160);
                let _e197 = (_e190 - _e158);
                let _e198 = (_e191 - _e159);
                let _e199 = (_e192 - _e160);
                let _e202 = ((_e195 * _e199) - (_e198 * _e196));
                let _e205 = ((_e196 * _e197) - (_e199 * _e194));
                let _e208 = ((_e194 * _e198) - (_e197 * _e195));
                let _e210 = abs(_e202);
                let _e211 = abs(_e205);
                let _e212 = abs(_e208);
                let _e213 = (_e210 >= _e211);
                if _e213 {
                    phi_827_ = select(true, false, (_e210 >= _e212));
                } else {
                    phi_827_ = true;
                }
                let _e217 = phi_827_;
                if _e217 {
                    phi_836_ = select(2u, 1u, (_e211 >= _e212));
                } else {
                    phi_836_ = 0u;
                }
                let _e221 = phi_836_;
                let _e224 = params.member.member_1;
                let _e226 = f32(_e224.x);
                let _e228 = f32(_e224.y);
                let _e230 = f32(_e224.z);
                let _e232 = (_e221 == 0u);
                if _e232 {
                    phi_857_ = vec3<f32>(_e228, _e230, _e226);
                } else {
                    if (_e221 == 1u) {
                        phi_856_ = vec3<f32>(_e230, _e226, _e228);
                    } else {
                        phi_856_ = vec3<f32>(_e226, _e228, _e230);
                    }
                    let _e236 = phi_856_;
                    phi_857_ = _e236;
                }
                let _e239 = phi_857_;
                if _e232 {
                    phi_869_ = vec3<f32>(_e159, _e160, _e158);
                } else {
                    if (_e221 == 1u) {
                        phi_868_ = vec3<f32>(_e160, _e158, _e159);
                    } else {
                        phi_868_ = vec3<f32>(_e158, _e159, _e160);
                    }
                    let _e243 = phi_868_;
                    phi_869_ = _e243;
                }
                let _e246 = phi_869_;
                if _e232 {
                    phi_881_ = vec3<f32>(_e175, _e176, _e174);
                } else {
                    if (_e221 == 1u) {
                        phi_880_ = vec3<f32>(_e176, _e174, _e175);
                    } else {
                        phi_880_ = vec3<f32>(_e174, _e175, _e176);
                    }
                    let _e250 = phi_880_;
                    phi_881_ = _e250;
                }
                let _e253 = phi_881_;
                if _e232 {
                    phi_893_ = vec3<f32>(_e191, _e192, _e190);
                } else {
                    if (_e221 == 1u) {
                        phi_892_ = vec3<f32>(_e192, _e190, _e191);
                    } else {
                        phi_892_ = vec3<f32>(_e190, _e191, _e192);
                    }
                    let _e257 = phi_892_;
                    phi_893_ = _e257;
                }
                let _e260 = phi_893_;
                let _e264 = select(_e253.x, _e246.x, (_e246.x < _e253.x));
                let _e269 = select(_e253.x, _e246.x, (_e246.x > _e253.x));
                let _e275 = (-1f - floor(-(select(_e260.x, _e264, (_e264 < _e260.x)))));
                let _e276 = floor(select(_e260.x, _e269, (_e269 > _e260.x)));
                let _e277 = (_e239.x - 1f);
                let _e279 = select(0f, _e275, (_e275 > 0f));
                let _e281 = select(_e277, _e276, (_e276 < _e277));
                let _e288 = select(0i, select(select(i32(_e279), i32(-2147483648), (_e279 < -2147483600f)), 2147483647i, (_e279 > 2147483500f)), (_e279 == _e279));
                let _e295 = select(0i, select(select(i32(_e281), i32(-2147483648), (_e281 < -2147483600f)), 2147483647i, (_e281 > 2147483500f)), (_e281 == _e281));
                let _e299 = select(_e253.y, _e246.y, (_e246.y < _e253.y));
                let _e304 = select(_e253.y, _e246.y, (_e246.y > _e253.y));
                let _e310 = (-1f - floor(-(select(_e260.y, _e299, (_e299 < _e260.y)))));
                let _e311 = floor(select(_e260.y, _e304, (_e304 > _e260.y)));
                let _e312 = (_e239.y - 1f);
                let _e314 = select(0f, _e310, (_e310 > 0f));
                let _e316 = select(_e312, _e311, (_e311 < _e312));
                let _e323 = select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < -2147483600f)), 2147483647i, (_e314 > 2147483500f)), (_e314 == _e314));
                let _e330 = select(0i, select(select(i32(_e316), i32(-2147483648), (_e316 < -2147483600f)), 2147483647i, (_e316 > 2147483500f)), (_e316 == _e316));
                let _e331 = type_38(_e246, _e253, _e260, vec3<f32>(_e202, _e205, _e208), _e221, _e239, _e288, _e295, _e323, _e330);
                if _e213 {
                    phi_1029_ = select(true, false, (_e210 >= _e212));
                } else {
                    phi_1029_ = true;
                }
                let _e335 = phi_1029_;
                if _e335 {
                    phi_1038_ = select(2u, 1u, (_e211 >= _e212));
                } else {
                    phi_1038_ = 0u;
                }
                let _e339 = phi_1038_;
                if (_e339 == 0u) {
                    phi_1048_ = _e202;
                } else {
                    phi_1048_ = select(_e208, _e205, (_e339 == 1u));
                }
                let _e344 = phi_1048_;
                let _e353 = (((_e202 * _e202) + (_e205 * _e205)) + (_e208 * _e208));
                if (_e353 >= 0.000000000000000000000000000000000000011754944f) {
                    let _e356 = (1f / sqrt(_e353));
                    phi_1068_ = vec3<f32>((_e202 * _e356), (_e205 * _e356), (_e208 * _e356));
                } else {
                    phi_1068_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e362 = phi_1068_;
                let _e365 = local_11;
                let _e368 = triangles.member[_e365].member_1;
                let _e369 = (_e368 * 12u);
                let _e370 = (256u + _e369);
                if (_e370 < _e98) {
                } else {
                    break;
                }
                let _e374 = surfaces.member[_e370];
                let _e375 = bitcast<f32>(_e374);
                let _e376 = (_e369 + 257u);
                if (_e376 < _e98) {
                } else {
                    break;
                }
                let _e380 = surfaces.member[_e376];
                let _e381 = bitcast<f32>(_e380);
                let _e382 = (_e369 + 258u);
                if (_e382 < _e98) {
                } else {
                    break;
                }
                let _e386 = surfaces.member[_e382];
                let _e387 = bitcast<f32>(_e386);
                let _e388 = (_e369 + 259u);
                if (_e388 < _e98) {
                } else {
                    break;
                }
                let _e392 = surfaces.member[_e388];
                let _e393 = (_e369 + 260u);
                if (_e393 < _e98) {
                } else {
                    break;
                }
                let _e397 = surfaces.member[_e393];
                let _e399 = (_e369 + 261u);
                if (_e399 < _e98) {
                } else {
                    break;
                }
                let _e403 = surfaces.member[_e399];
                let _e405 = (_e369 + 262u);
                if (_e405 < _e98) {
                } else {
                    break;
                }
                let _e409 = surfaces.member[_e405];
                let _e411 = (_e369 + 263u);
                if (_e411 < _e98) {
                } else {
                    break;
                }
                let _e415 = surfaces.member[_e411];
                let _e416 = (_e369 + 264u);
                if (_e416 < _e98) {
                } else {
                    break;
                }
                let _e420 = surfaces.member[_e416];
                let _e421 = bitcast<f32>(_e420);
                let _e422 = (_e369 + 265u);
                if (_e422 < _e98) {
                } else {
                    break;
                }
                let _e426 = surfaces.member[_e422];
                if ((_e369 + 266u) < _e98) {
                } else {
                    break;
                }
                if ((_e369 + 267u) < _e98) {
                } else {
                    break;
                }
                let _e433 = local_12;
                if (_e433 < _e100) {
                } else {
                    break;
                }
                let _e437 = local_13;
                let _e439 = tile_first.member[_e437];
                let _e440 = (_e106 - _e439);
                if (_e295 < _e288) {
                    phi_1192_ = 0u;
                } else {
                    phi_1192_ = ((bitcast<u32>((_e295 - _e288)) / 4u) + 1u);
                }
                let _e447 = phi_1192_;
                let _e449 = select(1u, _e447, (1u < _e447));
                if (_e449 == 0u) {
                    break;
                }
                let _e451 = (_e440 / _e449);
                let _e456 = (_e288 + bitcast<i32>(((_e440 - (_e451 * _e449)) * 4u)));
                let _e459 = (_e323 + bitcast<i32>((_e451 * 4u)));
                let _e463 = select(_e253.z, _e246.z, (_e246.z < _e253.z));
                let _e468 = select(_e253.z, _e246.z, (_e246.z > _e253.z));
                let _e474 = (-1f - floor(-(select(_e260.z, _e463, (_e463 < _e260.z)))));
                let _e475 = floor(select(_e260.z, _e468, (_e468 > _e260.z)));
                let _e476 = (_e239.z - 1f);
                let _e478 = select(0f, _e474, (_e474 > 0f));
                let _e480 = select(_e476, _e475, (_e475 < _e476));
                let _e487 = select(0i, select(select(i32(_e478), i32(-2147483648), (_e478 < -2147483600f)), 2147483647i, (_e478 > 2147483500f)), (_e478 == _e478));
                let _e494 = select(0i, select(select(i32(_e480), i32(-2147483648), (_e480 < -2147483600f)), 2147483647i, (_e480 > 2147483500f)), (_e480 == _e480));
                let _e495 = (_e253.x - _e246.x);
                let _e496 = (_e253.y - _e246.y);
                let _e502 = ((abs(_e495) + abs(_e496)) + abs((_e253.z - _e246.z)));
                let _e503 = (_e260.x - _e246.x);
                let _e504 = (_e260.y - _e246.y);
                let _e510 = ((abs(_e503) + abs(_e504)) + abs((_e260.z - _e246.z)));
                let _e512 = select(_e211, _e210, (_e210 > _e211));
                let _e520 = (select(_e212, _e512, (_e512 > _e212)) <= (((0.000004f * _e502) * _e510) * select(_e510, _e502, (_e502 > _e510))));
                let _e521 = (_e456 + 4i);
                let _e522 = (_e295 + 1i);
                let _e524 = select(_e521, _e522, (_e522 < _e521));
                let _e525 = (_e459 + 4i);
                let _e526 = (_e330 + 1i);
                let _e529 = (_e456 - 1i);
                let _e532 = (f32(_e456) + 2f);
                let _e534 = (f32(_e459) + 2f);
                let _e537 = ((_e246.x - _e532) * 0.24937655f);
                let _e538 = ((_e246.y - _e534) * 0.24937655f);
                let _e541 = ((_e253.x - _e532) * 0.24937655f);
                let _e542 = ((_e253.y - _e534) * 0.24937655f);
                let _e545 = ((_e260.x - _e532) * 0.24937655f);
                let _e546 = ((_e260.y - _e534) * 0.24937655f);
                let _e547 = (_e541 - _e537);
                let _e548 = (_e542 - _e538);
                let _e551 = ((_e547 * _e538) - (_e548 * _e537));
                let _e554 = ((_e547 * _e546) - (_e548 * _e545));
                let _e557 = (abs(_e547) + abs(_e548));
                if (select(_e554, _e551, (_e551 < _e554)) > (0.5f * _e557)) {
                    phi_4718_ = true;
                } else {
                    phi_4718_ = (select(_e554, _e551, (_e551 > _e554)) < (_e557 * -0.5f));
                }
                let _e567 = phi_4718_;
                if _e567 {
                    phi_1389_ = bool();
                    phi_1390_ = true;
                } else {
                    let _e568 = (_e545 - _e541);
                    let _e569 = (_e546 - _e542);
                    let _e572 = ((_e568 * _e542) - (_e569 * _e541));
                    let _e575 = ((_e568 * _e538) - (_e569 * _e537));
                    let _e578 = (abs(_e568) + abs(_e569));
                    if (select(_e575, _e572, (_e572 < _e575)) > (0.5f * _e578)) {
                        phi_4757_ = true;
                    } else {
                        phi_4757_ = (select(_e575, _e572, (_e572 > _e575)) < (_e578 * -0.5f));
                    }
                    let _e588 = phi_4757_;
                    if _e588 {
                        phi_1388_ = bool();
                    } else {
                        let _e589 = (_e537 - _e545);
                        let _e590 = (_e538 - _e546);
                        let _e593 = ((_e589 * _e546) - (_e590 * _e545));
                        let _e596 = ((_e589 * _e542) - (_e590 * _e541));
                        let _e599 = (abs(_e589) + abs(_e590));
                        if (select(_e596, _e593, (_e593 < _e596)) > (0.5f * _e599)) {
                            phi_4796_ = true;
                        } else {
                            phi_4796_ = (select(_e596, _e593, (_e593 > _e596)) < (_e599 * -0.5f));
                        }
                        let _e609 = phi_4796_;
                        phi_1388_ = _e609;
                    }
                    let _e611 = phi_1388_;
                    phi_1389_ = _e611;
                    phi_1390_ = _e588;
                }
                let _e613 = phi_1389_;
                let _e615 = phi_1390_;
                if select(_e613, true, _e615) {
                    phi_1399_ = type_39(_e331, _e456, _e524, _e459, _e487, _e494, _e529, _e459, 0i, -1i, _e520);
                } else {
                    phi_1399_ = type_39(_e331, _e456, _e524, select(_e525, _e526, (_e526 < _e525)), _e487, _e494, _e529, _e459, 0i, -1i, _e520);
                }
                let _e619 = phi_1399_;
                phi_5749_ = _e135;
                phi_5367_ = _e619.member_6;
                phi_5364_ = _e619.member_9;
                phi_5361_ = _e619.member_8;
                phi_5358_ = _e619.member_7;
                loop {
                    let _e638 = phi_5749_;
                    let _e640 = phi_5367_;
                    let _e642 = phi_5364_;
                    let _e644 = phi_5361_;
                    let _e646 = phi_5358_;
                    phi_5366_ = _e640;
                    phi_5363_ = _e642;
                    phi_5360_ = _e644;
                    phi_5357_ = _e646;
                    loop {
                        let _e648 = phi_5366_;
                        let _e650 = phi_5363_;
                        let _e652 = phi_5360_;
                        let _e654 = phi_5357_;
                        let _e655 = (_e654 < _e619.member_3);
                        if _e655 {
                            phi_5359_ = _e652;
                            loop {
                                let _e657 = phi_5359_;
                                let _e658 = (_e657 < _e650);
                                if _e658 {
                                    let _e659 = (_e657 + 1i);
                                    let _e663 = (f32(_e648) + 0.5f);
                                    let _e664 = (f32(_e654) + 0.5f);
                                    let _e665 = (f32(_e659) + 0.5f);
                                    let _e667 = (_e619.member.member.x - _e663);
                                    let _e669 = (_e619.member.member.y - _e664);
                                    let _e671 = (_e619.member.member.z - _e665);
                                    let _e672 = vec3<f32>(_e663, _e664, _e665);
                                    let _e675 = (_e619.member.member_1.x - _e663);
                                    let _e677 = (_e619.member.member_1.y - _e664);
                                    let _e679 = (_e619.member.member_1.z - _e665);
                                    let _e682 = (_e619.member.member_2.x - _e663);
                                    let _e684 = (_e619.member.member_2.y - _e664);
                                    let _e686 = (_e619.member.member_2.z - _e665);
                                    let _e689 = select(_e675, _e667, (_e667 < _e675));
                                    let _e693 = select(_e677, _e669, (_e669 < _e677));
                                    let _e697 = select(_e679, _e671, (_e671 < _e679));
                                    let _e701 = select(_e675, _e667, (_e667 > _e675));
                                    let _e705 = select(_e677, _e669, (_e669 > _e677));
                                    let _e709 = select(_e679, _e671, (_e671 > _e679));
                                    if (select(_e682, _e689, (_e689 < _e682)) > 0.5f) {
                                        phi_2043_ = bool();
                                        phi_2044_ = true;
                                        phi_2045_ = false;
                                    } else {
                                        if (select(_e684, _e693, (_e693 < _e684)) > 0.5f) {
                                            phi_2040_ = bool();
                                            phi_2041_ = true;
                                            phi_2042_ = false;
                                        } else {
                                            if (select(_e686, _e697, (_e697 < _e686)) > 0.5f) {
                                                phi_2037_ = bool();
                                                phi_2038_ = true;
                                                phi_2039_ = false;
                                            } else {
                                                if (select(_e682, _e701, (_e701 > _e682)) < -0.5f) {
                                                    phi_2034_ = bool();
                                                    phi_2035_ = true;
                                                    phi_2036_ = false;
                                                } else {
                                                    if (select(_e684, _e705, (_e705 > _e684)) < -0.5f) {
                                                        phi_2031_ = bool();
                                                        phi_2032_ = true;
                                                        phi_2033_ = false;
                                                    } else {
                                                        let _e717 = (select(_e686, _e709, (_e709 > _e686)) < -0.5f);
                                                        if _e717 {
                                                            phi_2029_ = bool();
                                                            phi_2030_ = false;
                                                        } else {
                                                            let _e718 = (_e675 - _e667);
                                                            let _e719 = (_e677 - _e669);
                                                            let _e720 = (_e679 - _e671);
                                                            let _e721 = vec3<f32>(_e718, _e719, _e720);
                                                            let _e722 = (_e682 - _e675);
                                                            let _e723 = (_e684 - _e677);
                                                            let _e724 = (_e686 - _e679);
                                                            let _e725 = vec3<f32>(_e722, _e723, _e724);
                                                            let _e726 = (_e667 - _e682);
                                                            let _e727 = (_e669 - _e684);
                                                            let _e728 = (_e671 - _e686);
                                                            let _e729 = vec3<f32>(_e726, _e727, _e728);
                                                            let _e732 = ((_e719 * _e671) - (_e720 * _e669));
                                                            let _e735 = ((_e719 * _e686) - (_e720 * _e684));
                                                            let _e736 = abs(_e719);
                                                            let _e737 = abs(_e720);
                                                            let _e738 = (_e736 + _e737);
                                                            if (select(_e735, _e732, (_e732 < _e735)) > (0.5f * _e738)) {
                                                                phi_1619_ = true;
                                                            } else {
                                                                phi_1619_ = (select(_e735, _e732, (_e732 > _e735)) < (_e738 * -0.5f));
                                                            }
                                                            let _e748 = phi_1619_;
                                                            if _e748 {
                                                                phi_1681_ = bool();
                                                                phi_1682_ = true;
                                                            } else {
                                                                let _e751 = ((_e720 * _e667) - (_e718 * _e671));
                                                                let _e754 = ((_e720 * _e682) - (_e718 * _e686));
                                                                let _e755 = abs(_e718);
                                                                let _e756 = (_e737 + _e755);
                                                                if (select(_e754, _e751, (_e751 < _e754)) > (0.5f * _e756)) {
                                                                    phi_1649_ = true;
                                                                } else {
                                                                    phi_1649_ = (select(_e754, _e751, (_e751 > _e754)) < (_e756 * -0.5f));
                                                                }
                                                                let _e766 = phi_1649_;
                                                                if _e766 {
                                                                    phi_1680_ = bool();
                                                                } else {
                                                                    let _e769 = ((_e718 * _e669) - (_e719 * _e667));
                                                                    let _e772 = ((_e718 * _e684) - (_e719 * _e682));
                                                                    let _e773 = (_e755 + _e736);
                                                                    if (select(_e772, _e769, (_e769 < _e772)) > (0.5f * _e773)) {
                                                                        phi_1679_ = true;
                                                                    } else {
                                                                        phi_1679_ = (select(_e772, _e769, (_e769 > _e772)) < (_e773 * -0.5f));
                                                                    }
                                                                    let _e783 = phi_1679_;
                                                                    phi_1680_ = _e783;
                                                                }
                                                                let _e785 = phi_1680_;
                                                                phi_1681_ = _e785;
                                                                phi_1682_ = _e766;
                                                            }
                                                            let _e787 = phi_1681_;
                                                            let _e789 = phi_1682_;
                                                            if select(_e787, true, _e789) {
                                                                phi_2024_ = bool();
                                                                phi_2025_ = true;
                                                            } else {
                                                                let _e793 = ((_e723 * _e679) - (_e724 * _e677));
                                                                let _e796 = ((_e723 * _e671) - (_e724 * _e669));
                                                                let _e797 = abs(_e723);
                                                                let _e798 = abs(_e724);
                                                                let _e799 = (_e797 + _e798);
                                                                if (select(_e796, _e793, (_e793 < _e796)) > (0.5f * _e799)) {
                                                                    phi_1716_ = true;
                                                                } else {
                                                                    phi_1716_ = (select(_e796, _e793, (_e793 > _e796)) < (_e799 * -0.5f));
                                                                }
                                                                let _e809 = phi_1716_;
                                                                if _e809 {
                                                                    phi_1778_ = bool();
                                                                    phi_1779_ = true;
                                                                } else {
                                                                    let _e812 = ((_e724 * _e675) - (_e722 * _e679));
                                                                    let _e815 = ((_e724 * _e667) - (_e722 * _e671));
                                                                    let _e816 = abs(_e722);
                                                                    let _e817 = (_e798 + _e816);
                                                                    if (select(_e815, _e812, (_e812 < _e815)) > (0.5f * _e817)) {
                                                                        phi_1746_ = true;
                                                                    } else {
                                                                        phi_1746_ = (select(_e815, _e812, (_e812 > _e815)) < (_e817 * -0.5f));
                                                                    }
                                                                    let _e827 = phi_1746_;
                                                                    if _e827 {
                                                                        phi_1777_ = bool();
                                                                    } else {
                                                                        let _e830 = ((_e722 * _e677) - (_e723 * _e675));
                                                                        let _e833 = ((_e722 * _e669) - (_e723 * _e667));
                                                                        let _e834 = (_e816 + _e797);
                                                                        if (select(_e833, _e830, (_e830 < _e833)) > (0.5f * _e834)) {
                                                                            phi_1776_ = true;
                                                                        } else {
                                                                            phi_1776_ = (select(_e833, _e830, (_e830 > _e833)) < (_e834 * -0.5f));
                                                                        }
                                                                        let _e844 = phi_1776_;
                                                                        phi_1777_ = _e844;
                                                                    }
                                                                    let _e846 = phi_1777_;
                                                                    phi_1778_ = _e846;
                                                                    phi_1779_ = _e827;
                                                                }
                                                                let _e848 = phi_1778_;
                                                                let _e850 = phi_1779_;
                                                                if select(_e848, true, _e850) {
                                                                    phi_2022_ = bool();
                                                                    phi_2023_ = true;
                                                                } else {
                                                                    let _e854 = ((_e727 * _e686) - (_e728 * _e684));
                                                                    let _e857 = ((_e727 * _e679) - (_e728 * _e677));
                                                                    let _e858 = abs(_e727);
                                                                    let _e859 = abs(_e728);
                                                                    let _e860 = (_e858 + _e859);
                                                                    if (select(_e857, _e854, (_e854 < _e857)) > (0.5f * _e860)) {
                                                                        phi_1813_ = true;
                                                                    } else {
                                                                        phi_1813_ = (select(_e857, _e854, (_e854 > _e857)) < (_e860 * -0.5f));
                                                                    }
                                                                    let _e870 = phi_1813_;
                                                                    if _e870 {
                                                                        phi_1875_ = bool();
                                                                        phi_1876_ = true;
                                                                    } else {
                                                                        let _e873 = ((_e728 * _e682) - (_e726 * _e686));
                                                                        let _e876 = ((_e728 * _e675) - (_e726 * _e679));
                                                                        let _e877 = abs(_e726);
                                                                        let _e878 = (_e859 + _e877);
                                                                        if (select(_e876, _e873, (_e873 < _e876)) > (0.5f * _e878)) {
                                                                            phi_1843_ = true;
                                                                        } else {
                                                                            phi_1843_ = (select(_e876, _e873, (_e873 > _e876)) < (_e878 * -0.5f));
                                                                        }
                                                                        let _e888 = phi_1843_;
                                                                        if _e888 {
                                                                            phi_1874_ = bool();
                                                                        } else {
                                                                            let _e891 = ((_e726 * _e684) - (_e727 * _e682));
                                                                            let _e894 = ((_e726 * _e677) - (_e727 * _e675));
                                                                            let _e895 = (_e877 + _e858);
                                                                            if (select(_e894, _e891, (_e891 < _e894)) > (0.5f * _e895)) {
                                                                                phi_1873_ = true;
                                                                            } else {
                                                                                phi_1873_ = (select(_e894, _e891, (_e891 > _e894)) < (_e895 * -0.5f));
                                                                            }
                                                                            let _e905 = phi_1873_;
                                                                            phi_1874_ = _e905;
                                                                        }
                                                                        let _e907 = phi_1874_;
                                                                        phi_1875_ = _e907;
                                                                        phi_1876_ = _e888;
                                                                    }
                                                                    let _e909 = phi_1875_;
                                                                    let _e911 = phi_1876_;
                                                                    let _e912 = select(_e909, true, _e911);
                                                                    if _e912 {
                                                                        phi_2021_ = bool();
                                                                    } else {
                                                                        let _e915 = ((abs(_e718) + _e736) + _e737);
                                                                        let _e918 = ((abs(_e722) + _e797) + _e798);
                                                                        let _e921 = ((abs(_e726) + _e858) + _e859);
                                                                        if (_e915 >= _e918) {
                                                                            phi_1908_ = select(true, false, (_e915 >= _e921));
                                                                        } else {
                                                                            phi_1908_ = true;
                                                                        }
                                                                        let _e926 = phi_1908_;
                                                                        if _e926 {
                                                                            let _e928 = vec3((_e918 >= _e921));
                                                                            phi_1918_ = select(_e721, _e729, _e928);
                                                                            phi_1919_ = select(_e725, _e721, _e928);
                                                                        } else {
                                                                            phi_1918_ = _e725;
                                                                            phi_1919_ = _e729;
                                                                        }
                                                                        let _e932 = phi_1918_;
                                                                        let _e934 = phi_1919_;
                                                                        let _e941 = ((_e932.y * _e934.z) - (_e934.y * _e932.z));
                                                                        let _e946 = ((_e932.z * _e934.x) - (_e934.z * _e932.x));
                                                                        let _e949 = ((_e932.x * _e934.y) - (_e934.x * _e932.y));
                                                                        let _e960 = ((abs(_e667) + abs(_e669)) + abs(_e671));
                                                                        let _e965 = ((abs(_e675) + abs(_e677)) + abs(_e679));
                                                                        let _e970 = ((abs(_e682) + abs(_e684)) + abs(_e686));
                                                                        if (_e960 <= _e965) {
                                                                            phi_1971_ = select(true, false, (_e960 <= _e970));
                                                                        } else {
                                                                            phi_1971_ = true;
                                                                        }
                                                                        let _e975 = phi_1971_;
                                                                        if _e975 {
                                                                            phi_1980_ = select((_e619.member.member_2 - _e672), (_e619.member.member_1 - _e672), vec3((_e965 <= _e970)));
                                                                        } else {
                                                                            phi_1980_ = (_e619.member.member - _e672);
                                                                        }
                                                                        let _e980 = phi_1980_;
                                                                        let _e982 = select(_e965, _e960, (_e960 < _e965));
                                                                        phi_2021_ = (abs((((_e941 * _e980.x) + (_e946 * _e980.y)) + (_e949 * _e980.z))) <= ((0.5f * ((abs(_e941) + abs(_e946)) + abs(_e949))) + (((0.00000036f * select(_e970, _e982, (_e982 < _e970))) * ((abs(_e932.x) + abs(_e932.y)) + abs(_e932.z))) * ((abs(_e934.x) + abs(_e934.y)) + abs(_e934.z)))));
                                                                    }
                                                                    let _e1010 = phi_2021_;
                                                                    phi_2022_ = _e1010;
                                                                    phi_2023_ = _e912;
                                                                }
                                                                let _e1012 = phi_2022_;
                                                                let _e1014 = phi_2023_;
                                                                phi_2024_ = _e1012;
                                                                phi_2025_ = _e1014;
                                                            }
                                                            let _e1016 = phi_2024_;
                                                            let _e1018 = phi_2025_;
                                                            phi_2029_ = _e1016;
                                                            phi_2030_ = _e1018;
                                                        }
                                                        let _e1020 = phi_2029_;
                                                        let _e1022 = phi_2030_;
                                                        phi_2031_ = _e1020;
                                                        phi_2032_ = _e717;
                                                        phi_2033_ = _e1022;
                                                    }
                                                    let _e1024 = phi_2031_;
                                                    let _e1026 = phi_2032_;
                                                    let _e1028 = phi_2033_;
                                                    phi_2034_ = _e1024;
                                                    phi_2035_ = _e1026;
                                                    phi_2036_ = _e1028;
                                                }
                                                let _e1030 = phi_2034_;
                                                let _e1032 = phi_2035_;
                                                let _e1034 = phi_2036_;
                                                phi_2037_ = _e1030;
                                                phi_2038_ = _e1032;
                                                phi_2039_ = _e1034;
                                            }
                                            let _e1036 = phi_2037_;
                                            let _e1038 = phi_2038_;
                                            let _e1040 = phi_2039_;
                                            phi_2040_ = _e1036;
                                            phi_2041_ = _e1038;
                                            phi_2042_ = _e1040;
                                        }
                                        let _e1042 = phi_2040_;
                                        let _e1044 = phi_2041_;
                                        let _e1046 = phi_2042_;
                                        phi_2043_ = _e1042;
                                        phi_2044_ = _e1044;
                                        phi_2045_ = _e1046;
                                    }
                                    let _e1048 = phi_2043_;
                                    let _e1050 = phi_2044_;
                                    let _e1052 = phi_2045_;
                                    phi_5657_ = _e659;
                                    phi_2058_ = select(true, false, select(_e1048, false, select(_e1052, true, _e1050)));
                                } else {
                                    phi_5657_ = _e657;
                                    phi_2058_ = false;
                                }
                                let _e1057 = phi_5657_;
                                let _e1059 = phi_2058_;
                                let _e1060 = select(true, false, _e658);
                                local_14 = _e1060;
                                local_54 = _e1057;
                                local_55 = _e1060;
                                continue;
                                continuing {
                                    phi_5359_ = _e1057;
                                    break if !(_e1059);
                                }
                            }
                            let _e1063 = local_14;
                            if _e1063 {
                                let _e1064 = (_e648 + 1i);
                                let _e1065 = (_e1064 >= _e619.member_2);
                                if _e1065 {
                                    phi_5516_ = (_e654 + 1i);
                                } else {
                                    phi_5516_ = _e654;
                                }
                                let _e1068 = phi_5516_;
                                let _e1069 = select(_e1064, _e619.member_1, _e1065);
                                if _e619.member_10 {
                                    let _e1116 = (_e619.member.member_1.x - _e619.member.member.x);
                                    let _e1119 = (_e619.member.member_1.y - _e619.member.member.y);
                                    let _e1122 = (_e619.member.member_1.z - _e619.member.member.z);
                                    let _e1123 = f32(_e1069);
                                    let _e1124 = (_e1123 - 0.01f);
                                    let _e1125 = (_e1124 - _e619.member.member.x);
                                    let _e1126 = (_e1123 + 1.01f);
                                    let _e1127 = (_e1126 - _e619.member.member.x);
                                    if (abs(_e1116) < 0.000001f) {
                                        if (_e1125 <= 0f) {
                                            let _e1138 = (_e1127 >= 0f);
                                            if _e1138 {
                                                phi_4846_ = type_33(0f, 1f);
                                            } else {
                                                phi_4846_ = type_33();
                                            }
                                            let _e1140 = phi_4846_;
                                            phi_4849_ = _e1140;
                                            phi_4850_ = select(true, false, _e1138);
                                        } else {
                                            phi_4849_ = type_33();
                                            phi_4850_ = true;
                                        }
                                        let _e1143 = phi_4849_;
                                        let _e1145 = phi_4850_;
                                        if _e1145 {
                                            phi_4855_ = type_33(1f, 0f);
                                        } else {
                                            phi_4855_ = _e1143;
                                        }
                                        let _e1147 = phi_4855_;
                                        phi_4857_ = _e1147;
                                    } else {
                                        let _e1130 = (_e1125 / _e1116);
                                        let _e1131 = (_e1127 / _e1116);
                                        phi_4857_ = type_33(select(_e1131, _e1130, (_e1130 < _e1131)), select(_e1131, _e1130, (_e1130 > _e1131)));
                                    }
                                    let _e1149 = phi_4857_;
                                    let _e1152 = f32(_e1068);
                                    let _e1153 = (_e1152 - 0.01f);
                                    let _e1154 = (_e1153 - _e619.member.member.y);
                                    let _e1155 = (_e1152 + 1.01f);
                                    let _e1156 = (_e1155 - _e619.member.member.y);
                                    if (abs(_e1119) < 0.000001f) {
                                        if (_e1154 <= 0f) {
                                            let _e1167 = (_e1156 >= 0f);
                                            if _e1167 {
                                                phi_4893_ = type_33(0f, 1f);
                                            } else {
                                                phi_4893_ = type_33();
                                            }
                                            let _e1169 = phi_4893_;
                                            phi_4896_ = _e1169;
                                            phi_4897_ = select(true, false, _e1167);
                                        } else {
                                            phi_4896_ = type_33();
                                            phi_4897_ = true;
                                        }
                                        let _e1172 = phi_4896_;
                                        let _e1174 = phi_4897_;
                                        if _e1174 {
                                            phi_4902_ = type_33(1f, 0f);
                                        } else {
                                            phi_4902_ = _e1172;
                                        }
                                        let _e1176 = phi_4902_;
                                        phi_4904_ = _e1176;
                                    } else {
                                        let _e1159 = (_e1154 / _e1119);
                                        let _e1160 = (_e1156 / _e1119);
                                        phi_4904_ = type_33(select(_e1160, _e1159, (_e1159 < _e1160)), select(_e1160, _e1159, (_e1159 > _e1160)));
                                    }
                                    let _e1178 = phi_4904_;
                                    let _e1182 = select(_e1178.member, _e1149.member, (_e1149.member > _e1178.member));
                                    let _e1184 = select(0f, _e1182, (_e1182 > 0f));
                                    let _e1186 = select(_e1178.member_1, _e1149.member_1, (_e1149.member_1 < _e1178.member_1));
                                    let _e1188 = select(1f, _e1186, (_e1186 < 1f));
                                    if (_e1184 > _e1188) {
                                        phi_4952_ = type_33(_e619.member.member_5.z, -2f);
                                    } else {
                                        let _e1191 = (_e619.member.member.z + (_e1122 * _e1184));
                                        let _e1193 = (_e619.member.member.z + (_e1122 * _e1188));
                                        phi_4952_ = type_33(select(_e1193, _e1191, (_e1191 < _e1193)), select(_e1193, _e1191, (_e1191 > _e1193)));
                                    }
                                    let _e1202 = phi_4952_;
                                    let _e1206 = (_e619.member.member_2.x - _e619.member.member_1.x);
                                    let _e1208 = (_e619.member.member_2.y - _e619.member.member_1.y);
                                    let _e1210 = (_e619.member.member_2.z - _e619.member.member_1.z);
                                    let _e1211 = (_e1124 - _e619.member.member_1.x);
                                    let _e1212 = (_e1126 - _e619.member.member_1.x);
                                    if (abs(_e1206) < 0.000001f) {
                                        if (_e1211 <= 0f) {
                                            let _e1223 = (_e1212 >= 0f);
                                            if _e1223 {
                                                phi_5001_ = type_33(0f, 1f);
                                            } else {
                                                phi_5001_ = type_33();
                                            }
                                            let _e1225 = phi_5001_;
                                            phi_5004_ = _e1225;
                                            phi_5005_ = select(true, false, _e1223);
                                        } else {
                                            phi_5004_ = type_33();
                                            phi_5005_ = true;
                                        }
                                        let _e1228 = phi_5004_;
                                        let _e1230 = phi_5005_;
                                        if _e1230 {
                                            phi_5010_ = type_33(1f, 0f);
                                        } else {
                                            phi_5010_ = _e1228;
                                        }
                                        let _e1232 = phi_5010_;
                                        phi_5012_ = _e1232;
                                    } else {
                                        let _e1215 = (_e1211 / _e1206);
                                        let _e1216 = (_e1212 / _e1206);
                                        phi_5012_ = type_33(select(_e1216, _e1215, (_e1215 < _e1216)), select(_e1216, _e1215, (_e1215 > _e1216)));
                                    }
                                    let _e1234 = phi_5012_;
                                    let _e1237 = (_e1153 - _e619.member.member_1.y);
                                    let _e1238 = (_e1155 - _e619.member.member_1.y);
                                    if (abs(_e1208) < 0.000001f) {
                                        if (_e1237 <= 0f) {
                                            let _e1249 = (_e1238 >= 0f);
                                            if _e1249 {
                                                phi_5048_ = type_33(0f, 1f);
                                            } else {
                                                phi_5048_ = type_33();
                                            }
                                            let _e1251 = phi_5048_;
                                            phi_5051_ = _e1251;
                                            phi_5052_ = select(true, false, _e1249);
                                        } else {
                                            phi_5051_ = type_33();
                                            phi_5052_ = true;
                                        }
                                        let _e1254 = phi_5051_;
                                        let _e1256 = phi_5052_;
                                        if _e1256 {
                                            phi_5057_ = type_33(1f, 0f);
                                        } else {
                                            phi_5057_ = _e1254;
                                        }
                                        let _e1258 = phi_5057_;
                                        phi_5059_ = _e1258;
                                    } else {
                                        let _e1241 = (_e1237 / _e1208);
                                        let _e1242 = (_e1238 / _e1208);
                                        phi_5059_ = type_33(select(_e1242, _e1241, (_e1241 < _e1242)), select(_e1242, _e1241, (_e1241 > _e1242)));
                                    }
                                    let _e1260 = phi_5059_;
                                    let _e1264 = select(_e1260.member, _e1234.member, (_e1234.member > _e1260.member));
                                    let _e1266 = select(0f, _e1264, (_e1264 > 0f));
                                    let _e1268 = select(_e1260.member_1, _e1234.member_1, (_e1234.member_1 < _e1260.member_1));
                                    let _e1270 = select(1f, _e1268, (_e1268 < 1f));
                                    if (_e1266 > _e1270) {
                                        phi_5107_ = type_33(_e619.member.member_5.z, -2f);
                                    } else {
                                        let _e1273 = (_e619.member.member_1.z + (_e1210 * _e1266));
                                        let _e1275 = (_e619.member.member_1.z + (_e1210 * _e1270));
                                        phi_5107_ = type_33(select(_e1275, _e1273, (_e1273 < _e1275)), select(_e1275, _e1273, (_e1273 > _e1275)));
                                    }
                                    let _e1284 = phi_5107_;
                                    let _e1287 = (_e619.member.member.x - _e619.member.member_2.x);
                                    let _e1288 = (_e619.member.member.y - _e619.member.member_2.y);
                                    let _e1289 = (_e619.member.member.z - _e619.member.member_2.z);
                                    let _e1290 = (_e1124 - _e619.member.member_2.x);
                                    let _e1291 = (_e1126 - _e619.member.member_2.x);
                                    if (abs(_e1287) < 0.000001f) {
                                        if (_e1290 <= 0f) {
                                            let _e1302 = (_e1291 >= 0f);
                                            if _e1302 {
                                                phi_5156_ = type_33(0f, 1f);
                                            } else {
                                                phi_5156_ = type_33();
                                            }
                                            let _e1304 = phi_5156_;
                                            phi_5159_ = _e1304;
                                            phi_5160_ = select(true, false, _e1302);
                                        } else {
                                            phi_5159_ = type_33();
                                            phi_5160_ = true;
                                        }
                                        let _e1307 = phi_5159_;
                                        let _e1309 = phi_5160_;
                                        if _e1309 {
                                            phi_5165_ = type_33(1f, 0f);
                                        } else {
                                            phi_5165_ = _e1307;
                                        }
                                        let _e1311 = phi_5165_;
                                        phi_5167_ = _e1311;
                                    } else {
                                        let _e1294 = (_e1290 / _e1287);
                                        let _e1295 = (_e1291 / _e1287);
                                        phi_5167_ = type_33(select(_e1295, _e1294, (_e1294 < _e1295)), select(_e1295, _e1294, (_e1294 > _e1295)));
                                    }
                                    let _e1313 = phi_5167_;
                                    let _e1316 = (_e1153 - _e619.member.member_2.y);
                                    let _e1317 = (_e1155 - _e619.member.member_2.y);
                                    if (abs(_e1288) < 0.000001f) {
                                        if (_e1316 <= 0f) {
                                            let _e1328 = (_e1317 >= 0f);
                                            if _e1328 {
                                                phi_5203_ = type_33(0f, 1f);
                                            } else {
                                                phi_5203_ = type_33();
                                            }
                                            let _e1330 = phi_5203_;
                                            phi_5206_ = _e1330;
                                            phi_5207_ = select(true, false, _e1328);
                                        } else {
                                            phi_5206_ = type_33();
                                            phi_5207_ = true;
                                        }
                                        let _e1333 = phi_5206_;
                                        let _e1335 = phi_5207_;
                                        if _e1335 {
                                            phi_5212_ = type_33(1f, 0f);
                                        } else {
                                            phi_5212_ = _e1333;
                                        }
                                        let _e1337 = phi_5212_;
                                        phi_5214_ = _e1337;
                                    } else {
                                        let _e1320 = (_e1316 / _e1288);
                                        let _e1321 = (_e1317 / _e1288);
                                        phi_5214_ = type_33(select(_e1321, _e1320, (_e1320 < _e1321)), select(_e1321, _e1320, (_e1320 > _e1321)));
                                    }
                                    let _e1339 = phi_5214_;
                                    let _e1343 = select(_e1339.member, _e1313.member, (_e1313.member > _e1339.member));
                                    let _e1345 = select(0f, _e1343, (_e1343 > 0f));
                                    let _e1347 = select(_e1339.member_1, _e1313.member_1, (_e1313.member_1 < _e1339.member_1));
                                    let _e1349 = select(1f, _e1347, (_e1347 < 1f));
                                    if (_e1345 > _e1349) {
                                        phi_5262_ = type_33(_e619.member.member_5.z, -2f);
                                    } else {
                                        let _e1352 = (_e619.member.member_2.z + (_e1289 * _e1345));
                                        let _e1354 = (_e619.member.member_2.z + (_e1289 * _e1349));
                                        phi_5262_ = type_33(select(_e1354, _e1352, (_e1352 < _e1354)), select(_e1354, _e1352, (_e1352 > _e1354)));
                                    }
                                    let _e1363 = phi_5262_;
                                    let _e1367 = select(_e1284.member, _e1202.member, (_e1202.member < _e1284.member));
                                    let _e1373 = select(_e1284.member_1, _e1202.member_1, (_e1202.member_1 > _e1284.member_1));
                                    phi_2154_ = type_33((floor(select(_e1363.member, _e1367, (_e1367 < _e1363.member))) - 1f), (floor(select(_e1363.member_1, _e1373, (_e1373 > _e1363.member_1))) + 1f));
                                } else {
                                    if (_e619.member.member_4 == 0u) {
                                        phi_2112_ = vec3<f32>(_e619.member.member_3.y, _e619.member.member_3.z, _e619.member.member_3.x);
                                    } else {
                                        if (_e619.member.member_4 == 1u) {
                                            phi_2111_ = vec3<f32>(_e619.member.member_3.z, _e619.member.member_3.x, _e619.member.member_3.y);
                                        } else {
                                            phi_2111_ = _e619.member.member_3;
                                        }
                                        let _e1077 = phi_2111_;
                                        phi_2112_ = _e1077;
                                    }
                                    let _e1083 = phi_2112_;
                                    let _e1100 = (_e619.member.member.z - (((_e1083.x * ((f32(_e1069) + 0.5f) - _e619.member.member.x)) + (_e1083.y * ((f32(_e1068) + 0.5f) - _e619.member.member.y))) / _e1083.z));
                                    let _e1107 = (((0.5f * (abs(_e1083.x) + abs(_e1083.y))) / abs(_e1083.z)) + 0.3f);
                                    phi_2154_ = type_33((-1f - floor((_e1107 - _e1100))), floor((_e1100 + _e1107)));
                                }
                                let _e1380 = phi_2154_;
                                let _e1383 = f32(_e619.member_4);
                                let _e1385 = select(_e1383, _e1380.member, (_e1380.member > _e1383));
                                let _e1394 = f32(_e619.member_5);
                                let _e1396 = select(_e1394, _e1380.member_1, (_e1380.member_1 < _e1394));
                                phi_6365_ = select(0i, select(select(i32(_e1396), i32(-2147483648), (_e1396 < -2147483600f)), 2147483647i, (_e1396 > 2147483500f)), (_e1396 == _e1396));
                                phi_5656_ = (select(0i, select(select(i32(_e1385), i32(-2147483648), (_e1385 < -2147483600f)), 2147483647i, (_e1385 > 2147483500f)), (_e1385 == _e1385)) - 1i);
                                phi_5632_ = _e1068;
                                phi_5602_ = _e1069;
                            } else {
                                phi_6365_ = _e650;
                                let _e3337 = local_54;
                                phi_5656_ = _e3337;
                                phi_5632_ = _e654;
                                phi_5602_ = _e648;
                            }
                            let _e1405 = phi_6365_;
                            let _e1407 = phi_5656_;
                            let _e1409 = phi_5632_;
                            let _e1411 = phi_5602_;
                            phi_6364_ = _e1405;
                            phi_5655_ = _e1407;
                            phi_5631_ = _e1409;
                            phi_5601_ = _e1411;
                            let _e3346 = local_55;
                            phi_2194_ = _e3346;
                        } else {
                            phi_6364_ = _e650;
                            phi_5655_ = _e652;
                            phi_5631_ = _e654;
                            phi_5601_ = _e648;
                            phi_2194_ = false;
                        }
                        let _e1413 = phi_6364_;
                        let _e1415 = phi_5655_;
                        let _e1417 = phi_5631_;
                        let _e1419 = phi_5601_;
                        let _e1421 = phi_2194_;
                        local_50 = _e1419;
                        local_51 = _e1413;
                        local_52 = _e1415;
                        local_53 = _e1417;
                        local_15 = select(true, false, _e655);
                        local_16 = _e1419;
                        local_17 = _e1417;
                        local_18 = _e1415;
                        continue;
                        continuing {
                            phi_5366_ = _e1419;
                            phi_5363_ = _e1413;
                            phi_5360_ = _e1415;
                            phi_5357_ = _e1417;
                            break if !(_e1421);
                        }
                    }
                    let _e1425 = local_15;
                    let _e1427 = select(false, true, select(true, false, _e1425));
                    if _e1427 {
                        let _e1429 = local_16;
                        let _e1430 = f32(_e1429);
                        let _e1432 = local_17;
                        let _e1433 = f32(_e1432);
                        let _e1435 = local_18;
                        let _e1436 = f32(_e1435);
                        let _e1437 = vec3<f32>(_e1430, _e1433, _e1436);
                        if (_e619.member.member_4 == 2u) {
                            phi_2224_ = 2u;
                        } else {
                            phi_2224_ = (1u - _e619.member.member_4);
                        }
                        let _e1441 = phi_2224_;
                        if (_e1441 == 0u) {
                            phi_2236_ = vec3<f32>(_e1433, _e1436, _e1430);
                        } else {
                            if (_e1441 == 1u) {
                                phi_2235_ = vec3<f32>(_e1436, _e1430, _e1433);
                            } else {
                                phi_2235_ = _e1437;
                            }
                            let _e1446 = phi_2235_;
                            phi_2236_ = _e1446;
                        }
                        let _e1449 = phi_2236_;
                        let _e1455 = select(select(u32(_e1449.x), 0u, (_e1449.x < 0f)), 4294967295u, (_e1449.x > 4294967000f));
                        let _e1461 = select(select(u32(_e1449.y), 0u, (_e1449.y < 0f)), 4294967295u, (_e1449.y > 4294967000f));
                        let _e1467 = select(select(u32(_e1449.z), 0u, (_e1449.z < 0f)), 4294967295u, (_e1449.z > 4294967000f));
                        local_6.member = array<vec3<f32>, 10>((_e246 - _e1437), (_e253 - _e1437), (_e260 - _e1437), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        local_6.member_1 = 3u;
                        let _e1474 = local_6.member_1;
                        phi_2294_ = type_12(0u, _e1474);
                        phi_2297_ = 0f;
                        loop {
                            let _e1477 = phi_2294_;
                            let _e1479 = phi_2297_;
                            local_19 = _e1479;
                            if (_e1477.member < _e1477.member_1) {
                                phi_2295_ = type_12((_e1477.member + 1u), _e1477.member_1);
                                phi_2320_ = type_12(1u, _e1477.member);
                            } else {
                                phi_2295_ = _e1477;
                                phi_2320_ = type_12(0u, type_12().member_1);
                            }
                            let _e1492 = phi_2295_;
                            let _e1494 = phi_2320_;
                            let _e1498 = (bitcast<i32>(_e1494.member) != 0i);
                            if _e1498 {
                                if (_e1494.member_1 < 10u) {
                                } else {
                                    phi_5738_ = true;
                                    break;
                                }
                                let _e1502 = local_6.member[_e1494.member_1];
                                phi_2298_ = select(_e1502.x, _e1479, (_e1479 < _e1502.x));
                            } else {
                                phi_2298_ = f32();
                            }
                            let _e1507 = phi_2298_;
                            continue;
                            continuing {
                                phi_2294_ = _e1492;
                                phi_2297_ = _e1507;
                                phi_5738_ = _e638;
                                break if !(_e1498);
                            }
                        }
                        let _e1510 = phi_5738_;
                        phi_6041_ = _e1510;
                        if _e1510 {
                            break;
                        }
                        let _e1512 = local_19;
                        if (_e1512 >= 0f) {
                            phi_5960_ = _e1510;
                        } else {
                            let _e1514 = local_6.member_1;
                            if (_e1514 == 0u) {
                                phi_5961_ = _e1510;
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
                                let _e1526 = local_6.member_1;
                                let _e1527 = (_e1526 - 1u);
                                if (_e1527 < 10u) {
                                } else {
                                    phi_6041_ = true;
                                    break;
                                }
                                let _e1531 = local_6.member[_e1527];
                                let _e1533 = local_6.member_1;
                                phi_2398_ = type_12(0u, _e1533);
                                phi_2401_ = _e1531.x;
                                phi_2403_ = _e1531;
                                phi_2405_ = 0u;
                                loop {
                                    let _e1536 = phi_2398_;
                                    let _e1538 = phi_2401_;
                                    let _e1540 = phi_2403_;
                                    let _e1542 = phi_2405_;
                                    local_20 = _e1542;
                                    if (_e1536.member < _e1536.member_1) {
                                        phi_2399_ = type_12((_e1536.member + 1u), _e1536.member_1);
                                        phi_2428_ = type_12(1u, _e1536.member);
                                    } else {
                                        phi_2399_ = _e1536;
                                        phi_2428_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1555 = phi_2399_;
                                    let _e1557 = phi_2428_;
                                    let _e1561 = (bitcast<i32>(_e1557.member) != 0i);
                                    if _e1561 {
                                        if (_e1557.member_1 < 10u) {
                                        } else {
                                            phi_5948_ = true;
                                            break;
                                        }
                                        let _e1565 = local_6.member[_e1557.member_1];
                                        if ((_e1565.x < 0f) != (_e1538 < 0f)) {
                                            let _e1572 = (_e1542 < 10u);
                                            if _e1572 {
                                                let _e1580 = (_e1538 / (_e1538 - _e1565.x));
                                                if _e1572 {
                                                } else {
                                                    phi_5948_ = true;
                                                    break;
                                                }
                                                local_5[_e1542] = (_e1540 + vec3<f32>(((_e1565.x - _e1540.x) * _e1580), ((_e1565.y - _e1540.y) * _e1580), ((_e1565.z - _e1540.z) * _e1580)));
                                                phi_2488_ = (_e1542 + 1u);
                                            } else {
                                                phi_2488_ = _e1542;
                                            }
                                            let _e1589 = phi_2488_;
                                            phi_2489_ = _e1589;
                                        } else {
                                            phi_2489_ = _e1542;
                                        }
                                        let _e1591 = phi_2489_;
                                        if (_e1565.x >= 0f) {
                                            let _e1593 = (_e1591 < 10u);
                                            if _e1593 {
                                                if _e1593 {
                                                } else {
                                                    phi_5948_ = true;
                                                    break;
                                                }
                                                local_5[_e1591] = _e1565;
                                                phi_2505_ = (_e1591 + 1u);
                                            } else {
                                                phi_2505_ = _e1591;
                                            }
                                            let _e1597 = phi_2505_;
                                            phi_2506_ = _e1597;
                                        } else {
                                            phi_2506_ = _e1591;
                                        }
                                        let _e1599 = phi_2506_;
                                        phi_2402_ = _e1565.x;
                                        phi_2404_ = _e1565;
                                        phi_2406_ = _e1599;
                                    } else {
                                        phi_2402_ = f32();
                                        phi_2404_ = vec3<f32>();
                                        phi_2406_ = u32();
                                    }
                                    let _e1601 = phi_2402_;
                                    let _e1603 = phi_2404_;
                                    let _e1605 = phi_2406_;
                                    continue;
                                    continuing {
                                        phi_2398_ = _e1555;
                                        phi_2401_ = _e1601;
                                        phi_2403_ = _e1603;
                                        phi_2405_ = _e1605;
                                        phi_5948_ = _e1510;
                                        break if !(_e1561);
                                    }
                                }
                                let _e1608 = phi_5948_;
                                phi_6041_ = _e1608;
                                if _e1608 {
                                    break;
                                }
                                let _e1609 = local_5;
                                local_6.member = _e1609;
                                let _e1611 = local_20;
                                local_6.member_1 = _e1611;
                                phi_5961_ = _e1608;
                            }
                            let _e1613 = phi_5961_;
                            phi_5960_ = _e1613;
                        }
                        let _e1615 = phi_5960_;
                        let _e1616 = local_6.member_1;
                        phi_2519_ = type_12(0u, _e1616);
                        phi_2522_ = 0f;
                        loop {
                            let _e1619 = phi_2519_;
                            let _e1621 = phi_2522_;
                            local_21 = _e1621;
                            if (_e1619.member < _e1619.member_1) {
                                phi_2520_ = type_12((_e1619.member + 1u), _e1619.member_1);
                                phi_2545_ = type_12(1u, _e1619.member);
                            } else {
                                phi_2520_ = _e1619;
                                phi_2545_ = type_12(0u, type_12().member_1);
                            }
                            let _e1634 = phi_2520_;
                            let _e1636 = phi_2545_;
                            let _e1640 = (bitcast<i32>(_e1636.member) != 0i);
                            if _e1640 {
                                if (_e1636.member_1 < 10u) {
                                } else {
                                    phi_5956_ = true;
                                    break;
                                }
                                let _e1644 = local_6.member[_e1636.member_1];
                                let _e1647 = ((-1f * _e1644.x) + 1f);
                                phi_2523_ = select(_e1647, _e1621, (_e1621 < _e1647));
                            } else {
                                phi_2523_ = f32();
                            }
                            let _e1651 = phi_2523_;
                            continue;
                            continuing {
                                phi_2519_ = _e1634;
                                phi_2522_ = _e1651;
                                phi_5956_ = _e1615;
                                break if !(_e1640);
                            }
                        }
                        let _e1654 = phi_5956_;
                        phi_6041_ = _e1654;
                        if _e1654 {
                            break;
                        }
                        let _e1656 = local_21;
                        if (_e1656 >= 0f) {
                            phi_5975_ = _e1654;
                        } else {
                            let _e1658 = local_6.member_1;
                            if (_e1658 == 0u) {
                                phi_5976_ = _e1654;
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
                                let _e1670 = local_6.member_1;
                                let _e1671 = (_e1670 - 1u);
                                if (_e1671 < 10u) {
                                } else {
                                    phi_6041_ = true;
                                    break;
                                }
                                let _e1675 = local_6.member[_e1671];
                                let _e1679 = local_6.member_1;
                                phi_2617_ = type_12(0u, _e1679);
                                phi_2620_ = ((-1f * _e1675.x) + 1f);
                                phi_2622_ = _e1675;
                                phi_2624_ = 0u;
                                loop {
                                    let _e1682 = phi_2617_;
                                    let _e1684 = phi_2620_;
                                    let _e1686 = phi_2622_;
                                    let _e1688 = phi_2624_;
                                    local_22 = _e1688;
                                    if (_e1682.member < _e1682.member_1) {
                                        phi_2618_ = type_12((_e1682.member + 1u), _e1682.member_1);
                                        phi_2647_ = type_12(1u, _e1682.member);
                                    } else {
                                        phi_2618_ = _e1682;
                                        phi_2647_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1701 = phi_2618_;
                                    let _e1703 = phi_2647_;
                                    let _e1707 = (bitcast<i32>(_e1703.member) != 0i);
                                    if _e1707 {
                                        if (_e1703.member_1 < 10u) {
                                        } else {
                                            phi_5963_ = true;
                                            break;
                                        }
                                        let _e1711 = local_6.member[_e1703.member_1];
                                        let _e1716 = ((-1f * _e1711.x) + 1f);
                                        if ((_e1716 < 0f) != (_e1684 < 0f)) {
                                            let _e1720 = (_e1688 < 10u);
                                            if _e1720 {
                                                let _e1728 = (_e1684 / (_e1684 - _e1716));
                                                if _e1720 {
                                                } else {
                                                    phi_5963_ = true;
                                                    break;
                                                }
                                                local_4[_e1688] = (_e1686 + vec3<f32>(((_e1711.x - _e1686.x) * _e1728), ((_e1711.y - _e1686.y) * _e1728), ((_e1711.z - _e1686.z) * _e1728)));
                                                phi_2704_ = (_e1688 + 1u);
                                            } else {
                                                phi_2704_ = _e1688;
                                            }
                                            let _e1737 = phi_2704_;
                                            phi_2705_ = _e1737;
                                        } else {
                                            phi_2705_ = _e1688;
                                        }
                                        let _e1739 = phi_2705_;
                                        if (_e1716 >= 0f) {
                                            let _e1741 = (_e1739 < 10u);
                                            if _e1741 {
                                                if _e1741 {
                                                } else {
                                                    phi_5963_ = true;
                                                    break;
                                                }
                                                local_4[_e1739] = _e1711;
                                                phi_2721_ = (_e1739 + 1u);
                                            } else {
                                                phi_2721_ = _e1739;
                                            }
                                            let _e1745 = phi_2721_;
                                            phi_2722_ = _e1745;
                                        } else {
                                            phi_2722_ = _e1739;
                                        }
                                        let _e1747 = phi_2722_;
                                        phi_2621_ = _e1716;
                                        phi_2623_ = _e1711;
                                        phi_2625_ = _e1747;
                                    } else {
                                        phi_2621_ = f32();
                                        phi_2623_ = vec3<f32>();
                                        phi_2625_ = u32();
                                    }
                                    let _e1749 = phi_2621_;
                                    let _e1751 = phi_2623_;
                                    let _e1753 = phi_2625_;
                                    continue;
                                    continuing {
                                        phi_2617_ = _e1701;
                                        phi_2620_ = _e1749;
                                        phi_2622_ = _e1751;
                                        phi_2624_ = _e1753;
                                        phi_5963_ = _e1654;
                                        break if !(_e1707);
                                    }
                                }
                                let _e1756 = phi_5963_;
                                phi_6041_ = _e1756;
                                if _e1756 {
                                    break;
                                }
                                let _e1757 = local_4;
                                local_6.member = _e1757;
                                let _e1759 = local_22;
                                local_6.member_1 = _e1759;
                                phi_5976_ = _e1756;
                            }
                            let _e1761 = phi_5976_;
                            phi_5975_ = _e1761;
                        }
                        let _e1763 = phi_5975_;
                        let _e1764 = local_6.member_1;
                        phi_2729_ = type_12(0u, _e1764);
                        phi_2732_ = 0f;
                        loop {
                            let _e1767 = phi_2729_;
                            let _e1769 = phi_2732_;
                            local_23 = _e1769;
                            if (_e1767.member < _e1767.member_1) {
                                phi_2730_ = type_12((_e1767.member + 1u), _e1767.member_1);
                                phi_2755_ = type_12(1u, _e1767.member);
                            } else {
                                phi_2730_ = _e1767;
                                phi_2755_ = type_12(0u, type_12().member_1);
                            }
                            let _e1782 = phi_2730_;
                            let _e1784 = phi_2755_;
                            let _e1788 = (bitcast<i32>(_e1784.member) != 0i);
                            if _e1788 {
                                if (_e1784.member_1 < 10u) {
                                } else {
                                    phi_5971_ = true;
                                    break;
                                }
                                let _e1792 = local_6.member[_e1784.member_1];
                                phi_2733_ = select(_e1792.y, _e1769, (_e1769 < _e1792.y));
                            } else {
                                phi_2733_ = f32();
                            }
                            let _e1797 = phi_2733_;
                            continue;
                            continuing {
                                phi_2729_ = _e1782;
                                phi_2732_ = _e1797;
                                phi_5971_ = _e1763;
                                break if !(_e1788);
                            }
                        }
                        let _e1800 = phi_5971_;
                        phi_6041_ = _e1800;
                        if _e1800 {
                            break;
                        }
                        let _e1802 = local_23;
                        if (_e1802 >= 0f) {
                            phi_5990_ = _e1800;
                        } else {
                            let _e1804 = local_6.member_1;
                            if (_e1804 == 0u) {
                                phi_5991_ = _e1800;
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
                                let _e1816 = local_6.member_1;
                                let _e1817 = (_e1816 - 1u);
                                if (_e1817 < 10u) {
                                } else {
                                    phi_6041_ = true;
                                    break;
                                }
                                let _e1821 = local_6.member[_e1817];
                                let _e1823 = local_6.member_1;
                                phi_2833_ = type_12(0u, _e1823);
                                phi_2836_ = _e1821.y;
                                phi_2838_ = _e1821;
                                phi_2840_ = 0u;
                                loop {
                                    let _e1826 = phi_2833_;
                                    let _e1828 = phi_2836_;
                                    let _e1830 = phi_2838_;
                                    let _e1832 = phi_2840_;
                                    local_24 = _e1832;
                                    if (_e1826.member < _e1826.member_1) {
                                        phi_2834_ = type_12((_e1826.member + 1u), _e1826.member_1);
                                        phi_2863_ = type_12(1u, _e1826.member);
                                    } else {
                                        phi_2834_ = _e1826;
                                        phi_2863_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1845 = phi_2834_;
                                    let _e1847 = phi_2863_;
                                    let _e1851 = (bitcast<i32>(_e1847.member) != 0i);
                                    if _e1851 {
                                        if (_e1847.member_1 < 10u) {
                                        } else {
                                            phi_5978_ = true;
                                            break;
                                        }
                                        let _e1855 = local_6.member[_e1847.member_1];
                                        if ((_e1855.y < 0f) != (_e1828 < 0f)) {
                                            let _e1862 = (_e1832 < 10u);
                                            if _e1862 {
                                                let _e1870 = (_e1828 / (_e1828 - _e1855.y));
                                                if _e1862 {
                                                } else {
                                                    phi_5978_ = true;
                                                    break;
                                                }
                                                local_3[_e1832] = (_e1830 + vec3<f32>(((_e1855.x - _e1830.x) * _e1870), ((_e1855.y - _e1830.y) * _e1870), ((_e1855.z - _e1830.z) * _e1870)));
                                                phi_2923_ = (_e1832 + 1u);
                                            } else {
                                                phi_2923_ = _e1832;
                                            }
                                            let _e1879 = phi_2923_;
                                            phi_2924_ = _e1879;
                                        } else {
                                            phi_2924_ = _e1832;
                                        }
                                        let _e1881 = phi_2924_;
                                        if (_e1855.y >= 0f) {
                                            let _e1883 = (_e1881 < 10u);
                                            if _e1883 {
                                                if _e1883 {
                                                } else {
                                                    phi_5978_ = true;
                                                    break;
                                                }
                                                local_3[_e1881] = _e1855;
                                                phi_2940_ = (_e1881 + 1u);
                                            } else {
                                                phi_2940_ = _e1881;
                                            }
                                            let _e1887 = phi_2940_;
                                            phi_2941_ = _e1887;
                                        } else {
                                            phi_2941_ = _e1881;
                                        }
                                        let _e1889 = phi_2941_;
                                        phi_2837_ = _e1855.y;
                                        phi_2839_ = _e1855;
                                        phi_2841_ = _e1889;
                                    } else {
                                        phi_2837_ = f32();
                                        phi_2839_ = vec3<f32>();
                                        phi_2841_ = u32();
                                    }
                                    let _e1891 = phi_2837_;
                                    let _e1893 = phi_2839_;
                                    let _e1895 = phi_2841_;
                                    continue;
                                    continuing {
                                        phi_2833_ = _e1845;
                                        phi_2836_ = _e1891;
                                        phi_2838_ = _e1893;
                                        phi_2840_ = _e1895;
                                        phi_5978_ = _e1800;
                                        break if !(_e1851);
                                    }
                                }
                                let _e1898 = phi_5978_;
                                phi_6041_ = _e1898;
                                if _e1898 {
                                    break;
                                }
                                let _e1899 = local_3;
                                local_6.member = _e1899;
                                let _e1901 = local_24;
                                local_6.member_1 = _e1901;
                                phi_5991_ = _e1898;
                            }
                            let _e1903 = phi_5991_;
                            phi_5990_ = _e1903;
                        }
                        let _e1905 = phi_5990_;
                        let _e1906 = local_6.member_1;
                        phi_2954_ = type_12(0u, _e1906);
                        phi_2957_ = 0f;
                        loop {
                            let _e1909 = phi_2954_;
                            let _e1911 = phi_2957_;
                            local_25 = _e1911;
                            if (_e1909.member < _e1909.member_1) {
                                phi_2955_ = type_12((_e1909.member + 1u), _e1909.member_1);
                                phi_2980_ = type_12(1u, _e1909.member);
                            } else {
                                phi_2955_ = _e1909;
                                phi_2980_ = type_12(0u, type_12().member_1);
                            }
                            let _e1924 = phi_2955_;
                            let _e1926 = phi_2980_;
                            let _e1930 = (bitcast<i32>(_e1926.member) != 0i);
                            if _e1930 {
                                if (_e1926.member_1 < 10u) {
                                } else {
                                    phi_5986_ = true;
                                    break;
                                }
                                let _e1934 = local_6.member[_e1926.member_1];
                                let _e1937 = ((-1f * _e1934.y) + 1f);
                                phi_2958_ = select(_e1937, _e1911, (_e1911 < _e1937));
                            } else {
                                phi_2958_ = f32();
                            }
                            let _e1941 = phi_2958_;
                            continue;
                            continuing {
                                phi_2954_ = _e1924;
                                phi_2957_ = _e1941;
                                phi_5986_ = _e1905;
                                break if !(_e1930);
                            }
                        }
                        let _e1944 = phi_5986_;
                        phi_6041_ = _e1944;
                        if _e1944 {
                            break;
                        }
                        let _e1946 = local_25;
                        if (_e1946 >= 0f) {
                            phi_6005_ = _e1944;
                        } else {
                            let _e1948 = local_6.member_1;
                            if (_e1948 == 0u) {
                                phi_6006_ = _e1944;
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
                                let _e1960 = local_6.member_1;
                                let _e1961 = (_e1960 - 1u);
                                if (_e1961 < 10u) {
                                } else {
                                    phi_6041_ = true;
                                    break;
                                }
                                let _e1965 = local_6.member[_e1961];
                                let _e1969 = local_6.member_1;
                                phi_3052_ = type_12(0u, _e1969);
                                phi_3055_ = ((-1f * _e1965.y) + 1f);
                                phi_3057_ = _e1965;
                                phi_3059_ = 0u;
                                loop {
                                    let _e1972 = phi_3052_;
                                    let _e1974 = phi_3055_;
                                    let _e1976 = phi_3057_;
                                    let _e1978 = phi_3059_;
                                    local_26 = _e1978;
                                    if (_e1972.member < _e1972.member_1) {
                                        phi_3053_ = type_12((_e1972.member + 1u), _e1972.member_1);
                                        phi_3082_ = type_12(1u, _e1972.member);
                                    } else {
                                        phi_3053_ = _e1972;
                                        phi_3082_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1991 = phi_3053_;
                                    let _e1993 = phi_3082_;
                                    let _e1997 = (bitcast<i32>(_e1993.member) != 0i);
                                    if _e1997 {
                                        if (_e1993.member_1 < 10u) {
                                        } else {
                                            phi_5993_ = true;
                                            break;
                                        }
                                        let _e2001 = local_6.member[_e1993.member_1];
                                        let _e2006 = ((-1f * _e2001.y) + 1f);
                                        if ((_e2006 < 0f) != (_e1974 < 0f)) {
                                            let _e2010 = (_e1978 < 10u);
                                            if _e2010 {
                                                let _e2018 = (_e1974 / (_e1974 - _e2006));
                                                if _e2010 {
                                                } else {
                                                    phi_5993_ = true;
                                                    break;
                                                }
                                                local_2[_e1978] = (_e1976 + vec3<f32>(((_e2001.x - _e1976.x) * _e2018), ((_e2001.y - _e1976.y) * _e2018), ((_e2001.z - _e1976.z) * _e2018)));
                                                phi_3139_ = (_e1978 + 1u);
                                            } else {
                                                phi_3139_ = _e1978;
                                            }
                                            let _e2027 = phi_3139_;
                                            phi_3140_ = _e2027;
                                        } else {
                                            phi_3140_ = _e1978;
                                        }
                                        let _e2029 = phi_3140_;
                                        if (_e2006 >= 0f) {
                                            let _e2031 = (_e2029 < 10u);
                                            if _e2031 {
                                                if _e2031 {
                                                } else {
                                                    phi_5993_ = true;
                                                    break;
                                                }
                                                local_2[_e2029] = _e2001;
                                                phi_3156_ = (_e2029 + 1u);
                                            } else {
                                                phi_3156_ = _e2029;
                                            }
                                            let _e2035 = phi_3156_;
                                            phi_3157_ = _e2035;
                                        } else {
                                            phi_3157_ = _e2029;
                                        }
                                        let _e2037 = phi_3157_;
                                        phi_3056_ = _e2006;
                                        phi_3058_ = _e2001;
                                        phi_3060_ = _e2037;
                                    } else {
                                        phi_3056_ = f32();
                                        phi_3058_ = vec3<f32>();
                                        phi_3060_ = u32();
                                    }
                                    let _e2039 = phi_3056_;
                                    let _e2041 = phi_3058_;
                                    let _e2043 = phi_3060_;
                                    continue;
                                    continuing {
                                        phi_3052_ = _e1991;
                                        phi_3055_ = _e2039;
                                        phi_3057_ = _e2041;
                                        phi_3059_ = _e2043;
                                        phi_5993_ = _e1944;
                                        break if !(_e1997);
                                    }
                                }
                                let _e2046 = phi_5993_;
                                phi_6041_ = _e2046;
                                if _e2046 {
                                    break;
                                }
                                let _e2047 = local_2;
                                local_6.member = _e2047;
                                let _e2049 = local_26;
                                local_6.member_1 = _e2049;
                                phi_6006_ = _e2046;
                            }
                            let _e2051 = phi_6006_;
                            phi_6005_ = _e2051;
                        }
                        let _e2053 = phi_6005_;
                        let _e2054 = local_6.member_1;
                        phi_3164_ = type_12(0u, _e2054);
                        phi_3167_ = 0f;
                        loop {
                            let _e2057 = phi_3164_;
                            let _e2059 = phi_3167_;
                            local_27 = _e2059;
                            if (_e2057.member < _e2057.member_1) {
                                phi_3165_ = type_12((_e2057.member + 1u), _e2057.member_1);
                                phi_3190_ = type_12(1u, _e2057.member);
                            } else {
                                phi_3165_ = _e2057;
                                phi_3190_ = type_12(0u, type_12().member_1);
                            }
                            let _e2072 = phi_3165_;
                            let _e2074 = phi_3190_;
                            let _e2078 = (bitcast<i32>(_e2074.member) != 0i);
                            if _e2078 {
                                if (_e2074.member_1 < 10u) {
                                } else {
                                    phi_6001_ = true;
                                    break;
                                }
                                let _e2082 = local_6.member[_e2074.member_1];
                                phi_3168_ = select(_e2082.z, _e2059, (_e2059 < _e2082.z));
                            } else {
                                phi_3168_ = f32();
                            }
                            let _e2087 = phi_3168_;
                            continue;
                            continuing {
                                phi_3164_ = _e2072;
                                phi_3167_ = _e2087;
                                phi_6001_ = _e2053;
                                break if !(_e2078);
                            }
                        }
                        let _e2090 = phi_6001_;
                        phi_6041_ = _e2090;
                        if _e2090 {
                            break;
                        }
                        let _e2092 = local_27;
                        if (_e2092 >= 0f) {
                            phi_6020_ = _e2090;
                        } else {
                            let _e2094 = local_6.member_1;
                            if (_e2094 == 0u) {
                                phi_6021_ = _e2090;
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
                                let _e2106 = local_6.member_1;
                                let _e2107 = (_e2106 - 1u);
                                if (_e2107 < 10u) {
                                } else {
                                    phi_6041_ = true;
                                    break;
                                }
                                let _e2111 = local_6.member[_e2107];
                                let _e2113 = local_6.member_1;
                                phi_3268_ = type_12(0u, _e2113);
                                phi_3271_ = _e2111.z;
                                phi_3273_ = _e2111;
                                phi_3275_ = 0u;
                                loop {
                                    let _e2116 = phi_3268_;
                                    let _e2118 = phi_3271_;
                                    let _e2120 = phi_3273_;
                                    let _e2122 = phi_3275_;
                                    local_28 = _e2122;
                                    if (_e2116.member < _e2116.member_1) {
                                        phi_3269_ = type_12((_e2116.member + 1u), _e2116.member_1);
                                        phi_3298_ = type_12(1u, _e2116.member);
                                    } else {
                                        phi_3269_ = _e2116;
                                        phi_3298_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2135 = phi_3269_;
                                    let _e2137 = phi_3298_;
                                    let _e2141 = (bitcast<i32>(_e2137.member) != 0i);
                                    if _e2141 {
                                        if (_e2137.member_1 < 10u) {
                                        } else {
                                            phi_6008_ = true;
                                            break;
                                        }
                                        let _e2145 = local_6.member[_e2137.member_1];
                                        if ((_e2145.z < 0f) != (_e2118 < 0f)) {
                                            let _e2152 = (_e2122 < 10u);
                                            if _e2152 {
                                                let _e2160 = (_e2118 / (_e2118 - _e2145.z));
                                                if _e2152 {
                                                } else {
                                                    phi_6008_ = true;
                                                    break;
                                                }
                                                local_1[_e2122] = (_e2120 + vec3<f32>(((_e2145.x - _e2120.x) * _e2160), ((_e2145.y - _e2120.y) * _e2160), ((_e2145.z - _e2120.z) * _e2160)));
                                                phi_3358_ = (_e2122 + 1u);
                                            } else {
                                                phi_3358_ = _e2122;
                                            }
                                            let _e2169 = phi_3358_;
                                            phi_3359_ = _e2169;
                                        } else {
                                            phi_3359_ = _e2122;
                                        }
                                        let _e2171 = phi_3359_;
                                        if (_e2145.z >= 0f) {
                                            let _e2173 = (_e2171 < 10u);
                                            if _e2173 {
                                                if _e2173 {
                                                } else {
                                                    phi_6008_ = true;
                                                    break;
                                                }
                                                local_1[_e2171] = _e2145;
                                                phi_3375_ = (_e2171 + 1u);
                                            } else {
                                                phi_3375_ = _e2171;
                                            }
                                            let _e2177 = phi_3375_;
                                            phi_3376_ = _e2177;
                                        } else {
                                            phi_3376_ = _e2171;
                                        }
                                        let _e2179 = phi_3376_;
                                        phi_3272_ = _e2145.z;
                                        phi_3274_ = _e2145;
                                        phi_3276_ = _e2179;
                                    } else {
                                        phi_3272_ = f32();
                                        phi_3274_ = vec3<f32>();
                                        phi_3276_ = u32();
                                    }
                                    let _e2181 = phi_3272_;
                                    let _e2183 = phi_3274_;
                                    let _e2185 = phi_3276_;
                                    continue;
                                    continuing {
                                        phi_3268_ = _e2135;
                                        phi_3271_ = _e2181;
                                        phi_3273_ = _e2183;
                                        phi_3275_ = _e2185;
                                        phi_6008_ = _e2090;
                                        break if !(_e2141);
                                    }
                                }
                                let _e2188 = phi_6008_;
                                phi_6041_ = _e2188;
                                if _e2188 {
                                    break;
                                }
                                let _e2189 = local_1;
                                local_6.member = _e2189;
                                let _e2191 = local_28;
                                local_6.member_1 = _e2191;
                                phi_6021_ = _e2188;
                            }
                            let _e2193 = phi_6021_;
                            phi_6020_ = _e2193;
                        }
                        let _e2195 = phi_6020_;
                        let _e2196 = local_6.member_1;
                        phi_3389_ = type_12(0u, _e2196);
                        phi_3392_ = 0f;
                        loop {
                            let _e2199 = phi_3389_;
                            let _e2201 = phi_3392_;
                            local_29 = _e2201;
                            if (_e2199.member < _e2199.member_1) {
                                phi_3390_ = type_12((_e2199.member + 1u), _e2199.member_1);
                                phi_3415_ = type_12(1u, _e2199.member);
                            } else {
                                phi_3390_ = _e2199;
                                phi_3415_ = type_12(0u, type_12().member_1);
                            }
                            let _e2214 = phi_3390_;
                            let _e2216 = phi_3415_;
                            let _e2220 = (bitcast<i32>(_e2216.member) != 0i);
                            if _e2220 {
                                if (_e2216.member_1 < 10u) {
                                } else {
                                    phi_6016_ = true;
                                    break;
                                }
                                let _e2224 = local_6.member[_e2216.member_1];
                                let _e2227 = ((-1f * _e2224.z) + 1f);
                                phi_3393_ = select(_e2227, _e2201, (_e2201 < _e2227));
                            } else {
                                phi_3393_ = f32();
                            }
                            let _e2231 = phi_3393_;
                            continue;
                            continuing {
                                phi_3389_ = _e2214;
                                phi_3392_ = _e2231;
                                phi_6016_ = _e2195;
                                break if !(_e2220);
                            }
                        }
                        let _e2234 = phi_6016_;
                        phi_6041_ = _e2234;
                        if _e2234 {
                            break;
                        }
                        let _e2236 = local_29;
                        if (_e2236 >= 0f) {
                            phi_6035_ = _e2234;
                        } else {
                            let _e2238 = local_6.member_1;
                            if (_e2238 == 0u) {
                                phi_6036_ = _e2234;
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
                                let _e2250 = local_6.member_1;
                                let _e2251 = (_e2250 - 1u);
                                if (_e2251 < 10u) {
                                } else {
                                    phi_6041_ = true;
                                    break;
                                }
                                let _e2255 = local_6.member[_e2251];
                                let _e2259 = local_6.member_1;
                                phi_3487_ = type_12(0u, _e2259);
                                phi_3490_ = ((-1f * _e2255.z) + 1f);
                                phi_3492_ = _e2255;
                                phi_3494_ = 0u;
                                loop {
                                    let _e2262 = phi_3487_;
                                    let _e2264 = phi_3490_;
                                    let _e2266 = phi_3492_;
                                    let _e2268 = phi_3494_;
                                    local_30 = _e2268;
                                    if (_e2262.member < _e2262.member_1) {
                                        phi_3488_ = type_12((_e2262.member + 1u), _e2262.member_1);
                                        phi_3517_ = type_12(1u, _e2262.member);
                                    } else {
                                        phi_3488_ = _e2262;
                                        phi_3517_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2281 = phi_3488_;
                                    let _e2283 = phi_3517_;
                                    let _e2287 = (bitcast<i32>(_e2283.member) != 0i);
                                    if _e2287 {
                                        if (_e2283.member_1 < 10u) {
                                        } else {
                                            phi_6023_ = true;
                                            break;
                                        }
                                        let _e2291 = local_6.member[_e2283.member_1];
                                        let _e2296 = ((-1f * _e2291.z) + 1f);
                                        if ((_e2296 < 0f) != (_e2264 < 0f)) {
                                            let _e2300 = (_e2268 < 10u);
                                            if _e2300 {
                                                let _e2308 = (_e2264 / (_e2264 - _e2296));
                                                if _e2300 {
                                                } else {
                                                    phi_6023_ = true;
                                                    break;
                                                }
                                                local[_e2268] = (_e2266 + vec3<f32>(((_e2291.x - _e2266.x) * _e2308), ((_e2291.y - _e2266.y) * _e2308), ((_e2291.z - _e2266.z) * _e2308)));
                                                phi_3574_ = (_e2268 + 1u);
                                            } else {
                                                phi_3574_ = _e2268;
                                            }
                                            let _e2317 = phi_3574_;
                                            phi_3575_ = _e2317;
                                        } else {
                                            phi_3575_ = _e2268;
                                        }
                                        let _e2319 = phi_3575_;
                                        if (_e2296 >= 0f) {
                                            let _e2321 = (_e2319 < 10u);
                                            if _e2321 {
                                                if _e2321 {
                                                } else {
                                                    phi_6023_ = true;
                                                    break;
                                                }
                                                local[_e2319] = _e2291;
                                                phi_3591_ = (_e2319 + 1u);
                                            } else {
                                                phi_3591_ = _e2319;
                                            }
                                            let _e2325 = phi_3591_;
                                            phi_3592_ = _e2325;
                                        } else {
                                            phi_3592_ = _e2319;
                                        }
                                        let _e2327 = phi_3592_;
                                        phi_3491_ = _e2296;
                                        phi_3493_ = _e2291;
                                        phi_3495_ = _e2327;
                                    } else {
                                        phi_3491_ = f32();
                                        phi_3493_ = vec3<f32>();
                                        phi_3495_ = u32();
                                    }
                                    let _e2329 = phi_3491_;
                                    let _e2331 = phi_3493_;
                                    let _e2333 = phi_3495_;
                                    continue;
                                    continuing {
                                        phi_3487_ = _e2281;
                                        phi_3490_ = _e2329;
                                        phi_3492_ = _e2331;
                                        phi_3494_ = _e2333;
                                        phi_6023_ = _e2234;
                                        break if !(_e2287);
                                    }
                                }
                                let _e2336 = phi_6023_;
                                phi_6041_ = _e2336;
                                if _e2336 {
                                    break;
                                }
                                let _e2337 = local;
                                local_6.member = _e2337;
                                let _e2339 = local_30;
                                local_6.member_1 = _e2339;
                                phi_6036_ = _e2336;
                            }
                            let _e2341 = phi_6036_;
                            phi_6035_ = _e2341;
                        }
                        let _e2343 = phi_6035_;
                        let _e2346 = local_6.member[0u];
                        let _e2350 = local_6.member_1;
                        phi_3604_ = type_12(1u, _e2350);
                        phi_3607_ = vec3<f32>(0f, 0f, 0f);
                        phi_3609_ = _e2346.z;
                        phi_3611_ = _e2346.y;
                        phi_3613_ = _e2346.x;
                        phi_3615_ = 0f;
                        loop {
                            let _e2353 = phi_3604_;
                            let _e2355 = phi_3607_;
                            let _e2357 = phi_3609_;
                            let _e2359 = phi_3611_;
                            let _e2361 = phi_3613_;
                            let _e2363 = phi_3615_;
                            local_31 = _e2361;
                            local_32 = _e2359;
                            local_33 = _e2357;
                            local_34 = _e2363;
                            local_35 = _e2355;
                            local_36 = _e2363;
                            local_37 = _e2355;
                            local_38 = _e2363;
                            local_39 = _e2355;
                            local_40 = _e2363;
                            local_41 = _e2363;
                            if (_e2353.member < _e2353.member_1) {
                                phi_3605_ = type_12((_e2353.member + 1u), _e2353.member_1);
                                phi_3638_ = type_12(1u, _e2353.member);
                            } else {
                                phi_3605_ = _e2353;
                                phi_3638_ = type_12(0u, type_12().member_1);
                            }
                            let _e2376 = phi_3605_;
                            let _e2378 = phi_3638_;
                            let _e2382 = (bitcast<i32>(_e2378.member) != 0i);
                            if _e2382 {
                                if (_e2378.member_1 < 10u) {
                                } else {
                                    phi_6031_ = true;
                                    break;
                                }
                                let _e2386 = local_6.member[_e2378.member_1];
                                let _e2396 = (_e2378.member_1 + 1u);
                                let _e2397 = local_6.member_1;
                                if (_e2396 < _e2397) {
                                    if (_e2396 < 10u) {
                                    } else {
                                        phi_6031_ = true;
                                        break;
                                    }
                                    let _e2402 = local_6.member[_e2396];
                                    let _e2403 = (_e2386.x - _e2346.x);
                                    let _e2404 = (_e2386.y - _e2346.y);
                                    let _e2405 = (_e2386.z - _e2346.z);
                                    let _e2407 = (_e2402.x - _e2346.x);
                                    let _e2409 = (_e2402.y - _e2346.y);
                                    let _e2411 = (_e2402.z - _e2346.z);
                                    let _e2414 = ((_e2404 * _e2411) - (_e2409 * _e2405));
                                    let _e2417 = ((_e2405 * _e2407) - (_e2411 * _e2403));
                                    let _e2420 = ((_e2403 * _e2409) - (_e2407 * _e2404));
                                    let _e2426 = sqrt((((_e2414 * _e2414) + (_e2417 * _e2417)) + (_e2420 * _e2420)));
                                    let _e2438 = (_e2426 * 0.16666667f);
                                    phi_3752_ = vec3<f32>((_e2355.x + (((_e2386.x + _e2402.x) - (_e2346.x * 2f)) * _e2438)), (_e2355.y + (((_e2386.y + _e2402.y) - (_e2346.y * 2f)) * _e2438)), (_e2355.z + (((_e2386.z + _e2402.z) - (_e2346.z * 2f)) * _e2438)));
                                    phi_3753_ = (_e2363 + (0.5f * _e2426));
                                } else {
                                    phi_3752_ = _e2355;
                                    phi_3753_ = _e2363;
                                }
                                let _e2450 = phi_3752_;
                                let _e2452 = phi_3753_;
                                phi_3608_ = _e2450;
                                phi_3610_ = select(_e2386.z, _e2357, (_e2357 < _e2386.z));
                                phi_3612_ = select(_e2386.y, _e2359, (_e2359 < _e2386.y));
                                phi_3614_ = select(_e2386.x, _e2361, (_e2361 < _e2386.x));
                                phi_3616_ = _e2452;
                            } else {
                                phi_3608_ = vec3<f32>();
                                phi_3610_ = f32();
                                phi_3612_ = f32();
                                phi_3614_ = f32();
                                phi_3616_ = f32();
                            }
                            let _e2454 = phi_3608_;
                            let _e2456 = phi_3610_;
                            let _e2458 = phi_3612_;
                            let _e2460 = phi_3614_;
                            let _e2462 = phi_3616_;
                            continue;
                            continuing {
                                phi_3604_ = _e2376;
                                phi_3607_ = _e2454;
                                phi_3609_ = _e2456;
                                phi_3611_ = _e2458;
                                phi_3613_ = _e2460;
                                phi_3615_ = _e2462;
                                phi_6031_ = _e2343;
                                break if !(_e2382);
                            }
                        }
                        let _e2465 = phi_6031_;
                        phi_6041_ = _e2465;
                        if _e2465 {
                            break;
                        }
                        let _e2466 = local_6.member_1;
                        if (_e2466 == 0u) {
                            phi_3772_ = bool();
                            phi_3773_ = true;
                        } else {
                            let _e2469 = local_31;
                            if (_e2469 >= 1f) {
                                phi_3770_ = bool();
                                phi_3771_ = true;
                            } else {
                                let _e2472 = local_32;
                                let _e2473 = (_e2472 >= 1f);
                                if _e2473 {
                                    phi_3769_ = bool();
                                } else {
                                    let _e2475 = local_33;
                                    phi_3769_ = (_e2475 >= 1f);
                                }
                                let _e2478 = phi_3769_;
                                phi_3770_ = _e2478;
                                phi_3771_ = _e2473;
                            }
                            let _e2480 = phi_3770_;
                            let _e2482 = phi_3771_;
                            phi_3772_ = _e2480;
                            phi_3773_ = _e2482;
                        }
                        let _e2484 = phi_3772_;
                        let _e2486 = phi_3773_;
                        let _e2489 = local_34;
                        if (_e2489 > 0f) {
                            let _e2492 = local_35;
                            let _e2495 = local_36;
                            let _e2498 = local_37;
                            let _e2501 = local_38;
                            let _e2504 = local_39;
                            let _e2507 = local_40;
                            phi_3790_ = (_e2346 + vec3<f32>((_e2492.x / _e2495), (_e2498.y / _e2501), (_e2504.z / _e2507)));
                        } else {
                            phi_3790_ = _e2346;
                        }
                        let _e2512 = phi_3790_;
                        let _e2514 = local_41;
                        let _e2518 = select(0f, _e2512.x, (_e2512.x > 0f));
                        let _e2520 = select(1f, _e2518, (_e2518 < 1f));
                        let _e2523 = select(0f, _e2512.y, (_e2512.y > 0f));
                        let _e2525 = select(1f, _e2523, (_e2523 < 1f));
                        let _e2528 = select(0f, _e2512.z, (_e2512.z > 0f));
                        let _e2530 = select(1f, _e2528, (_e2528 < 1f));
                        let _e2535 = local_42;
                        if (_e2535 < arrayLength((&attributes.member))) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e2537 = ((_e2520 + _e1430) - _e246.x);
                        let _e2538 = ((_e2525 + _e1433) - _e246.y);
                        let _e2541 = ((_e495 * _e504) - (_e496 * _e503));
                        if (abs(_e2541) > 0f) {
                            phi_3862_ = (1f / _e2541);
                        } else {
                            phi_3862_ = 0f;
                        }
                        let _e2546 = phi_3862_;
                        let _e2550 = (((_e2537 * _e504) - (_e2538 * _e503)) * _e2546);
                        let _e2552 = select(0f, _e2550, (_e2550 > 0f));
                        let _e2554 = select(1f, _e2552, (_e2552 < 1f));
                        let _e2558 = (((_e495 * _e2538) - (_e496 * _e2537)) * _e2546);
                        let _e2560 = select(0f, _e2558, (_e2558 > 0f));
                        let _e2562 = select(1f, _e2560, (_e2560 < 1f));
                        let _e2564 = ((1f - _e2554) - _e2562);
                        let _e2567 = local_43;
                        let _e2571 = attributes.member[_e2567].member[0u];
                        let _e2575 = local_44;
                        let _e2579 = attributes.member[_e2575].member[2u];
                        let _e2584 = local_45;
                        let _e2588 = attributes.member[_e2584].member[4u];
                        let _e2590 = (((_e2571 * _e2564) + (_e2579 * _e2554)) + (_e2588 * _e2562));
                        let _e2593 = local_46;
                        let _e2597 = attributes.member[_e2593].member[1u];
                        let _e2601 = local_47;
                        let _e2605 = attributes.member[_e2601].member[3u];
                        let _e2610 = local_48;
                        let _e2614 = attributes.member[_e2610].member[5u];
                        let _e2616 = (((_e2597 * _e2564) + (_e2605 * _e2554)) + (_e2614 * _e2562));
                        if (_e392 == 4294967295u) {
                            phi_4211_ = type_30(vec3<f32>(_e375, _e381, _e387), _e421);
                        } else {
                            let _e2619 = (_e415 & 65535u);
                            let _e2621 = (_e415 >> bitcast<u32>(16i));
                            let _e2623 = (_e2590 - floor(_e2590));
                            let _e2628 = ((select(0f, _e2623, (_e2623 <= 1f)) * f32(_e2619)) - 0.5f);
                            let _e2629 = floor(_e2628);
                            let _e2630 = (_e2628 - _e2629);
                            let _e2631 = (_e2619 - 1u);
                            if (_e2629 < 0f) {
                                phi_3952_ = _e2631;
                            } else {
                                let _e2637 = select(select(u32(_e2629), 0u, (_e2629 < 0f)), 4294967295u, (_e2629 > 4294967000f));
                                phi_3952_ = select(_e2637, _e2631, (_e2631 < _e2637));
                            }
                            let _e2641 = phi_3952_;
                            if (_e2641 == _e2631) {
                                phi_3958_ = 0u;
                            } else {
                                phi_3958_ = (_e2641 + 1u);
                            }
                            let _e2645 = phi_3958_;
                            let _e2647 = (_e2616 - floor(_e2616));
                            let _e2652 = ((select(0f, _e2647, (_e2647 <= 1f)) * f32(_e2621)) - 0.5f);
                            let _e2653 = floor(_e2652);
                            let _e2654 = (_e2652 - _e2653);
                            let _e2655 = (_e2621 - 1u);
                            if (_e2653 < 0f) {
                                phi_3988_ = _e2655;
                            } else {
                                let _e2661 = select(select(u32(_e2653), 0u, (_e2653 < 0f)), 4294967295u, (_e2653 > 4294967000f));
                                phi_3988_ = select(_e2661, _e2655, (_e2655 < _e2661));
                            }
                            let _e2665 = phi_3988_;
                            if (_e2665 == _e2655) {
                                phi_3994_ = 0u;
                            } else {
                                phi_3994_ = (_e2665 + 1u);
                            }
                            let _e2669 = phi_3994_;
                            let _e2671 = (_e392 + (_e2665 * _e2619));
                            let _e2673 = (_e392 + (_e2669 * _e2619));
                            let _e2674 = (_e2671 + _e2641);
                            let _e2675 = (_e2671 + _e2645);
                            let _e2676 = (_e2673 + _e2641);
                            let _e2677 = (_e2673 + _e2645);
                            if (_e2674 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2681 = surfaces.member[_e2674];
                            if (_e2675 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2685 = surfaces.member[_e2675];
                            if (_e2676 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2689 = surfaces.member[_e2676];
                            if (_e2677 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2693 = surfaces.member[_e2677];
                            let _e2694 = (_e2681 & 255u);
                            if (_e2694 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2698 = surfaces.member[_e2694];
                            let _e2702 = ((_e2681 >> bitcast<u32>(8i)) & 255u);
                            if (_e2702 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2706 = surfaces.member[_e2702];
                            let _e2710 = ((_e2681 >> bitcast<u32>(16i)) & 255u);
                            if (_e2710 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2714 = surfaces.member[_e2710];
                            let _e2716 = (1f - _e2630);
                            let _e2720 = (_e2685 & 255u);
                            if (_e2720 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2724 = surfaces.member[_e2720];
                            let _e2728 = ((_e2685 >> bitcast<u32>(8i)) & 255u);
                            if (_e2728 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2732 = surfaces.member[_e2728];
                            let _e2736 = ((_e2685 >> bitcast<u32>(16i)) & 255u);
                            if (_e2736 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2740 = surfaces.member[_e2736];
                            let _e2748 = (_e2689 & 255u);
                            if (_e2748 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2752 = surfaces.member[_e2748];
                            let _e2756 = ((_e2689 >> bitcast<u32>(8i)) & 255u);
                            if (_e2756 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2760 = surfaces.member[_e2756];
                            let _e2764 = ((_e2689 >> bitcast<u32>(16i)) & 255u);
                            if (_e2764 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2768 = surfaces.member[_e2764];
                            let _e2773 = (_e2693 & 255u);
                            if (_e2773 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2777 = surfaces.member[_e2773];
                            let _e2781 = ((_e2693 >> bitcast<u32>(8i)) & 255u);
                            if (_e2781 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2785 = surfaces.member[_e2781];
                            let _e2789 = ((_e2693 >> bitcast<u32>(16i)) & 255u);
                            if (_e2789 < _e98) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2793 = surfaces.member[_e2789];
                            let _e2801 = (1f - _e2654);
                            phi_4211_ = type_30(vec3<f32>((_e375 * ((((bitcast<f32>(_e2698) * _e2716) + (bitcast<f32>(_e2724) * _e2630)) * _e2801) + (((bitcast<f32>(_e2752) * _e2716) + (bitcast<f32>(_e2777) * _e2630)) * _e2654))), (_e381 * ((((bitcast<f32>(_e2706) * _e2716) + (bitcast<f32>(_e2732) * _e2630)) * _e2801) + (((bitcast<f32>(_e2760) * _e2716) + (bitcast<f32>(_e2785) * _e2630)) * _e2654))), (_e387 * ((((bitcast<f32>(_e2714) * _e2716) + (bitcast<f32>(_e2740) * _e2630)) * _e2801) + (((bitcast<f32>(_e2768) * _e2716) + (bitcast<f32>(_e2793) * _e2630)) * _e2654)))), (_e421 * (((((f32((_e2681 >> bitcast<u32>(24i))) * 0.003921569f) * _e2716) + ((f32((_e2685 >> bitcast<u32>(24i))) * 0.003921569f) * _e2630)) * _e2801) + ((((f32((_e2689 >> bitcast<u32>(24i))) * 0.003921569f) * _e2716) + ((f32((_e2693 >> bitcast<u32>(24i))) * 0.003921569f) * _e2630)) * _e2654))));
                        }
                        let _e2844 = phi_4211_;
                        if (_e221 == 2u) {
                            phi_4241_ = 2u;
                        } else {
                            phi_4241_ = (1u - _e221);
                        }
                        let _e2863 = phi_4241_;
                        if (_e2863 == 0u) {
                            phi_4253_ = vec3<f32>(_e2525, _e2530, _e2520);
                        } else {
                            if (_e2863 == 1u) {
                                phi_4252_ = vec3<f32>(_e2530, _e2520, _e2525);
                            } else {
                                phi_4252_ = vec3<f32>(_e2520, _e2525, _e2530);
                            }
                            let _e2868 = phi_4252_;
                            phi_4253_ = _e2868;
                        }
                        let _e2871 = phi_4253_;
                        let _e2875 = params.member.member_2[0u];
                        let _e2889 = (((_e2875.z + (_e1455 >> bitcast<u32>(2i))) + (_e2875.x * (_e1461 >> bitcast<u32>(2i)))) + (_e2875.y * (_e1467 >> bitcast<u32>(1i))));
                        let _e2912 = cells.member[((2u * _e2889) + 1u)];
                        phi_4288_ = type_12(0u, 6u);
                        phi_4291_ = _e2912;
                        loop {
                            let _e2914 = phi_4288_;
                            let _e2916 = phi_4291_;
                            local_49 = _e2916;
                            if (_e2914.member < _e2914.member_1) {
                                phi_4289_ = type_12((_e2914.member + 1u), _e2914.member_1);
                                phi_4314_ = type_12(1u, _e2914.member);
                            } else {
                                phi_4289_ = _e2914;
                                phi_4314_ = type_12(0u, type_12().member_1);
                            }
                            let _e2929 = phi_4289_;
                            let _e2931 = phi_4314_;
                            let _e2935 = (bitcast<i32>(_e2931.member) != 0i);
                            if _e2935 {
                                let _e2939 = facet_bits.member[((_e2889 * 6u) + _e2931.member_1)];
                                let _e2940 = ((((((_e1455 & 1u) | ((_e1461 & 1u) << bitcast<u32>(1i))) | ((_e1467 & 1u) << bitcast<u32>(2i))) | ((_e1455 & 2u) << bitcast<u32>(2i))) | ((_e1461 & 2u) << bitcast<u32>(3i))) & 31u);
                                let _e2946 = (_e2916 + countOneBits((_e2939 & ((1u << bitcast<u32>(_e2940)) - 1u))));
                                if (_e2931.member_1 < ((2u * _e339) + select(0u, 1u, (_e344 < 0f)))) {
                                    phi_4339_ = (_e2946 + ((_e2939 >> bitcast<u32>(_e2940)) & 1u));
                                } else {
                                    phi_4339_ = _e2946;
                                }
                                let _e2953 = phi_4339_;
                                phi_4292_ = _e2953;
                            } else {
                                phi_4292_ = u32();
                            }
                            let _e2955 = phi_4292_;
                            continue;
                            continuing {
                                phi_4288_ = _e2929;
                                phi_4291_ = _e2955;
                                break if !(_e2935);
                            }
                        }
                        let _e2959 = local_49;
                        let _e2960 = (_e2959 * 13u);
                        let _e2963 = params.member.member_7;
                        let _e2966 = floor((((select(_e2514, 0f, select(_e2484, true, _e2486)) * select(1f, 0f, (_e2844.member_1 < bitcast<f32>(_e426)))) * _e2963) + 0.5f));
                        let _e2968 = select(_e2966, 1f, (_e2966 < 1f));
                        let _e2973 = select(select(u32(_e2968), 0u, (_e2968 < 0f)), 4294967295u, (_e2968 > 4294967000f));
                        if (_e2960 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e2977 = atomicAdd((&sums.member[_e2960]), _e2973);
                        if (_e2977 >= (2147483648u - select(_e2973, 2147483648u, (2147483648u < _e2973)))) {
                            let _e2984 = params.member.member_5;
                            let _e2985 = (_e2984 * 13u);
                            if (_e2985 < _e102) {
                            } else {
                                phi_6041_ = true;
                                break;
                            }
                            let _e2989 = atomicOr((&sums.member[_e2985]), 1u);
                        }
                        let _e2990 = (_e2960 + 1u);
                        let _e2998 = floor(((_e362.x * _e2968) + 0.5f));
                        if (_e2990 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3010 = atomicAdd((&sums.member[_e2990]), bitcast<u32>(select(0i, select(select(i32(_e2998), i32(-2147483648), (_e2998 < -2147483600f)), 2147483647i, (_e2998 > 2147483500f)), (_e2998 == _e2998))));
                        let _e3011 = (_e2960 + 2u);
                        let _e3013 = floor(((_e362.y * _e2968) + 0.5f));
                        if (_e3011 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3025 = atomicAdd((&sums.member[_e3011]), bitcast<u32>(select(0i, select(select(i32(_e3013), i32(-2147483648), (_e3013 < -2147483600f)), 2147483647i, (_e3013 > 2147483500f)), (_e3013 == _e3013))));
                        let _e3026 = (_e2960 + 3u);
                        let _e3028 = floor(((_e362.z * _e2968) + 0.5f));
                        if (_e3026 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3040 = atomicAdd((&sums.member[_e3026]), bitcast<u32>(select(0i, select(select(i32(_e3028), i32(-2147483648), (_e3028 < -2147483600f)), 2147483647i, (_e3028 > 2147483500f)), (_e3028 == _e3028))));
                        let _e3041 = (_e2960 + 4u);
                        let _e3049 = floor(((_e2871.x * _e2968) + 0.5f));
                        if (_e3041 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3061 = atomicAdd((&sums.member[_e3041]), bitcast<u32>(select(0i, select(select(i32(_e3049), i32(-2147483648), (_e3049 < -2147483600f)), 2147483647i, (_e3049 > 2147483500f)), (_e3049 == _e3049))));
                        let _e3062 = (_e2960 + 5u);
                        let _e3064 = floor(((_e2871.y * _e2968) + 0.5f));
                        if (_e3062 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3076 = atomicAdd((&sums.member[_e3062]), bitcast<u32>(select(0i, select(select(i32(_e3064), i32(-2147483648), (_e3064 < -2147483600f)), 2147483647i, (_e3064 > 2147483500f)), (_e3064 == _e3064))));
                        let _e3077 = (_e2960 + 6u);
                        let _e3079 = floor(((_e2871.z * _e2968) + 0.5f));
                        if (_e3077 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3091 = atomicAdd((&sums.member[_e3077]), bitcast<u32>(select(0i, select(select(i32(_e3079), i32(-2147483648), (_e3079 < -2147483600f)), 2147483647i, (_e3079 > 2147483500f)), (_e3079 == _e3079))));
                        let _e3092 = (_e2960 + 7u);
                        let _e3097 = floor(((select(1f, _e2844.member.x, (_e2844.member.x < 1f)) * _e2968) + 0.5f));
                        if (_e3092 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3109 = atomicAdd((&sums.member[_e3092]), bitcast<u32>(select(0i, select(select(i32(_e3097), i32(-2147483648), (_e3097 < -2147483600f)), 2147483647i, (_e3097 > 2147483500f)), (_e3097 == _e3097))));
                        let _e3110 = (_e2960 + 8u);
                        let _e3112 = floor(((select(1f, _e2844.member.y, (_e2844.member.y < 1f)) * _e2968) + 0.5f));
                        if (_e3110 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3124 = atomicAdd((&sums.member[_e3110]), bitcast<u32>(select(0i, select(select(i32(_e3112), i32(-2147483648), (_e3112 < -2147483600f)), 2147483647i, (_e3112 > 2147483500f)), (_e3112 == _e3112))));
                        let _e3125 = (_e2960 + 9u);
                        let _e3127 = floor(((select(1f, _e2844.member.z, (_e2844.member.z < 1f)) * _e2968) + 0.5f));
                        if (_e3125 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3139 = atomicAdd((&sums.member[_e3125]), bitcast<u32>(select(0i, select(select(i32(_e3127), i32(-2147483648), (_e3127 < -2147483600f)), 2147483647i, (_e3127 > 2147483500f)), (_e3127 == _e3127))));
                        let _e3140 = (_e2960 + 10u);
                        let _e3143 = params.member.member_8;
                        let _e3144 = (_e2968 / _e3143);
                        let _e3149 = floor(((bitcast<f32>(_e397) * _e3144) + 0.5f));
                        if (_e3140 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3161 = atomicAdd((&sums.member[_e3140]), bitcast<u32>(select(0i, select(select(i32(_e3149), i32(-2147483648), (_e3149 < -2147483600f)), 2147483647i, (_e3149 > 2147483500f)), (_e3149 == _e3149))));
                        let _e3162 = (_e2960 + 11u);
                        let _e3164 = floor(((bitcast<f32>(_e403) * _e3144) + 0.5f));
                        if (_e3162 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3176 = atomicAdd((&sums.member[_e3162]), bitcast<u32>(select(0i, select(select(i32(_e3164), i32(-2147483648), (_e3164 < -2147483600f)), 2147483647i, (_e3164 > 2147483500f)), (_e3164 == _e3164))));
                        let _e3177 = (_e2960 + 12u);
                        let _e3179 = floor(((bitcast<f32>(_e409) * _e3144) + 0.5f));
                        if (_e3177 < _e102) {
                        } else {
                            phi_6041_ = true;
                            break;
                        }
                        let _e3191 = atomicAdd((&sums.member[_e3177]), bitcast<u32>(select(0i, select(select(i32(_e3179), i32(-2147483648), (_e3179 < -2147483600f)), 2147483647i, (_e3179 > 2147483500f)), (_e3179 == _e3179))));
                        phi_6042_ = _e2465;
                    } else {
                        phi_6042_ = _e638;
                    }
                    let _e3193 = phi_6042_;
                    continue;
                    continuing {
                        phi_5749_ = _e3193;
                        let _e3234 = local_50;
                        phi_5367_ = _e3234;
                        let _e3237 = local_51;
                        phi_5364_ = _e3237;
                        let _e3240 = local_52;
                        phi_5361_ = _e3240;
                        let _e3243 = local_53;
                        phi_5358_ = _e3243;
                        phi_6041_ = _e3193;
                        break if !(_e1427);
                    }
                }
                let _e3196 = phi_6041_;
                if _e3196 {
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
