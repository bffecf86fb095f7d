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
    var phi_709_: u32;
    var phi_712_: u32;
    var phi_710_: u32;
    var phi_713_: u32;
    var phi_5351_: bool;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_825_: bool;
    var phi_834_: u32;
    var phi_854_: vec3<f32>;
    var phi_855_: vec3<f32>;
    var phi_866_: vec3<f32>;
    var phi_867_: vec3<f32>;
    var phi_878_: vec3<f32>;
    var phi_879_: vec3<f32>;
    var phi_890_: vec3<f32>;
    var phi_891_: vec3<f32>;
    var phi_1027_: bool;
    var phi_1036_: u32;
    var phi_1046_: f32;
    var phi_1066_: vec3<f32>;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var phi_1190_: u32;
    var phi_4716_: bool;
    var phi_4755_: bool;
    var phi_4794_: bool;
    var phi_1386_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1397_: type_39;
    var phi_5747_: bool;
    var phi_5365_: i32;
    var phi_5362_: i32;
    var phi_5359_: i32;
    var phi_5356_: i32;
    var phi_5364_: i32;
    var phi_5361_: i32;
    var phi_5358_: i32;
    var phi_5355_: i32;
    var phi_5357_: i32;
    var phi_1617_: bool;
    var phi_1647_: bool;
    var phi_1677_: bool;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1714_: bool;
    var phi_1744_: bool;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1811_: bool;
    var phi_1841_: bool;
    var phi_1871_: bool;
    var phi_1872_: bool;
    var phi_1873_: bool;
    var phi_1874_: bool;
    var phi_1906_: bool;
    var phi_1916_: vec3<f32>;
    var phi_1917_: vec3<f32>;
    var phi_1969_: bool;
    var phi_1978_: vec3<f32>;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2023_: bool;
    var phi_2027_: bool;
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
    var phi_5655_: i32;
    var phi_2056_: bool;
    var local_14: bool;
    var phi_5514_: i32;
    var phi_2109_: vec3<f32>;
    var phi_2110_: vec3<f32>;
    var phi_4844_: type_33;
    var phi_4847_: type_33;
    var phi_4848_: bool;
    var phi_4853_: type_33;
    var phi_4855_: type_33;
    var phi_4891_: type_33;
    var phi_4894_: type_33;
    var phi_4895_: bool;
    var phi_4900_: type_33;
    var phi_4902_: type_33;
    var phi_4950_: type_33;
    var phi_4999_: type_33;
    var phi_5002_: type_33;
    var phi_5003_: bool;
    var phi_5008_: type_33;
    var phi_5010_: type_33;
    var phi_5046_: type_33;
    var phi_5049_: type_33;
    var phi_5050_: bool;
    var phi_5055_: type_33;
    var phi_5057_: type_33;
    var phi_5105_: type_33;
    var phi_5154_: type_33;
    var phi_5157_: type_33;
    var phi_5158_: bool;
    var phi_5163_: type_33;
    var phi_5165_: type_33;
    var phi_5201_: type_33;
    var phi_5204_: type_33;
    var phi_5205_: bool;
    var phi_5210_: type_33;
    var phi_5212_: type_33;
    var phi_5260_: type_33;
    var phi_2152_: type_33;
    var phi_6363_: i32;
    var phi_5654_: i32;
    var phi_5630_: i32;
    var phi_5600_: i32;
    var phi_6362_: i32;
    var phi_5653_: i32;
    var phi_5629_: i32;
    var phi_5599_: i32;
    var phi_2192_: bool;
    var local_15: bool;
    var local_16: i32;
    var local_17: i32;
    var local_18: i32;
    var phi_2222_: u32;
    var phi_2233_: vec3<f32>;
    var phi_2234_: vec3<f32>;
    var phi_2292_: type_12;
    var phi_2295_: f32;
    var phi_2293_: type_12;
    var phi_2318_: type_12;
    var phi_2296_: f32;
    var phi_5736_: bool;
    var local_19: f32;
    var phi_2396_: type_12;
    var phi_2399_: f32;
    var phi_2401_: vec3<f32>;
    var phi_2403_: u32;
    var phi_2397_: type_12;
    var phi_2426_: type_12;
    var phi_2486_: u32;
    var phi_2487_: u32;
    var phi_2503_: u32;
    var phi_2504_: u32;
    var phi_2400_: f32;
    var phi_2402_: vec3<f32>;
    var phi_2404_: u32;
    var phi_5946_: bool;
    var local_20: u32;
    var phi_5959_: bool;
    var phi_5958_: bool;
    var phi_2517_: type_12;
    var phi_2520_: f32;
    var phi_2518_: type_12;
    var phi_2543_: type_12;
    var phi_2521_: f32;
    var phi_5954_: bool;
    var local_21: f32;
    var phi_2615_: type_12;
    var phi_2618_: f32;
    var phi_2620_: vec3<f32>;
    var phi_2622_: u32;
    var phi_2616_: type_12;
    var phi_2645_: type_12;
    var phi_2702_: u32;
    var phi_2703_: u32;
    var phi_2719_: u32;
    var phi_2720_: u32;
    var phi_2619_: f32;
    var phi_2621_: vec3<f32>;
    var phi_2623_: u32;
    var phi_5961_: bool;
    var local_22: u32;
    var phi_5974_: bool;
    var phi_5973_: bool;
    var phi_2727_: type_12;
    var phi_2730_: f32;
    var phi_2728_: type_12;
    var phi_2753_: type_12;
    var phi_2731_: f32;
    var phi_5969_: bool;
    var local_23: f32;
    var phi_2831_: type_12;
    var phi_2834_: f32;
    var phi_2836_: vec3<f32>;
    var phi_2838_: u32;
    var phi_2832_: type_12;
    var phi_2861_: type_12;
    var phi_2921_: u32;
    var phi_2922_: u32;
    var phi_2938_: u32;
    var phi_2939_: u32;
    var phi_2835_: f32;
    var phi_2837_: vec3<f32>;
    var phi_2839_: u32;
    var phi_5976_: bool;
    var local_24: u32;
    var phi_5989_: bool;
    var phi_5988_: bool;
    var phi_2952_: type_12;
    var phi_2955_: f32;
    var phi_2953_: type_12;
    var phi_2978_: type_12;
    var phi_2956_: f32;
    var phi_5984_: bool;
    var local_25: f32;
    var phi_3050_: type_12;
    var phi_3053_: f32;
    var phi_3055_: vec3<f32>;
    var phi_3057_: u32;
    var phi_3051_: type_12;
    var phi_3080_: type_12;
    var phi_3137_: u32;
    var phi_3138_: u32;
    var phi_3154_: u32;
    var phi_3155_: u32;
    var phi_3054_: f32;
    var phi_3056_: vec3<f32>;
    var phi_3058_: u32;
    var phi_5991_: bool;
    var local_26: u32;
    var phi_6004_: bool;
    var phi_6003_: bool;
    var phi_3162_: type_12;
    var phi_3165_: f32;
    var phi_3163_: type_12;
    var phi_3188_: type_12;
    var phi_3166_: f32;
    var phi_5999_: bool;
    var local_27: f32;
    var phi_3266_: type_12;
    var phi_3269_: f32;
    var phi_3271_: vec3<f32>;
    var phi_3273_: u32;
    var phi_3267_: type_12;
    var phi_3296_: type_12;
    var phi_3356_: u32;
    var phi_3357_: u32;
    var phi_3373_: u32;
    var phi_3374_: u32;
    var phi_3270_: f32;
    var phi_3272_: vec3<f32>;
    var phi_3274_: u32;
    var phi_6006_: bool;
    var local_28: u32;
    var phi_6019_: bool;
    var phi_6018_: bool;
    var phi_3387_: type_12;
    var phi_3390_: f32;
    var phi_3388_: type_12;
    var phi_3413_: type_12;
    var phi_3391_: f32;
    var phi_6014_: bool;
    var local_29: f32;
    var phi_3485_: type_12;
    var phi_3488_: f32;
    var phi_3490_: vec3<f32>;
    var phi_3492_: u32;
    var phi_3486_: type_12;
    var phi_3515_: type_12;
    var phi_3572_: u32;
    var phi_3573_: u32;
    var phi_3589_: u32;
    var phi_3590_: u32;
    var phi_3489_: f32;
    var phi_3491_: vec3<f32>;
    var phi_3493_: u32;
    var phi_6021_: bool;
    var local_30: u32;
    var phi_6034_: bool;
    var phi_6033_: bool;
    var phi_3602_: type_12;
    var phi_3605_: vec3<f32>;
    var phi_3607_: f32;
    var phi_3609_: f32;
    var phi_3611_: f32;
    var phi_3613_: f32;
    var phi_3603_: type_12;
    var phi_3636_: type_12;
    var phi_3750_: vec3<f32>;
    var phi_3751_: f32;
    var phi_3606_: vec3<f32>;
    var phi_3608_: f32;
    var phi_3610_: f32;
    var phi_3612_: f32;
    var phi_3614_: f32;
    var phi_6029_: bool;
    var local_31: f32;
    var local_32: f32;
    var local_33: f32;
    var phi_3767_: bool;
    var phi_3768_: bool;
    var phi_3769_: bool;
    var phi_3770_: bool;
    var phi_3771_: bool;
    var local_34: f32;
    var local_35: vec3<f32>;
    var local_36: f32;
    var local_37: vec3<f32>;
    var local_38: f32;
    var local_39: vec3<f32>;
    var local_40: f32;
    var phi_3788_: vec3<f32>;
    var local_41: f32;
    var local_42: u32;
    var phi_3860_: f32;
    var local_43: u32;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: u32;
    var local_48: u32;
    var phi_3950_: u32;
    var phi_3956_: u32;
    var phi_3986_: u32;
    var phi_3992_: u32;
    var phi_4209_: type_30;
    var phi_4239_: u32;
    var phi_4250_: vec3<f32>;
    var phi_4251_: vec3<f32>;
    var phi_4286_: type_12;
    var phi_4289_: u32;
    var phi_4287_: type_12;
    var phi_4312_: type_12;
    var phi_4337_: u32;
    var phi_4290_: u32;
    var local_49: u32;
    var phi_6040_: bool;
    var phi_6039_: bool;
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
                phi_709_ = _e113;
                phi_712_ = 0u;
                loop {
                    let _e115 = phi_709_;
                    let _e117 = phi_712_;
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
                    let _e118 = (_e115 > 1u);
                    if _e118 {
                        let _e119 = (_e115 / 2u);
                        let _e120 = (_e117 + _e119);
                        if (_e120 < _e100) {
                        } else {
                            phi_5351_ = true;
                            break;
                        }
                        let _e124 = tile_first.member[_e120];
                        phi_710_ = (_e115 - _e119);
                        phi_713_ = select(_e117, _e120, (_e124 <= _e106));
                    } else {
                        phi_710_ = u32();
                        phi_713_ = u32();
                    }
                    let _e129 = phi_710_;
                    let _e131 = phi_713_;
                    continue;
                    continuing {
                        phi_709_ = _e129;
                        phi_712_ = _e131;
                        phi_5351_ = false;
                        break if !(_e118);
                    }
                }
                let _e134 = phi_5351_;
                if _e134 {
                    break;
                }
                let _e136 = local_7;
                if (_e136 < arrayLength((&triangles.member))) {
                } else {
                    break;
                }
                let _e140 = local_8;
                let _e143 = triangles.member[_e140].member;
                let _e149 = params.member.member;
                let _e157 = ((_e143[0] - _e149.x) / _e149.w);
                let _e158 = ((_e143[1] - _e149.y) / _e149.w);
                let _e159 = ((_e143[2] - _e149.z) / _e149.w);
                let _e163 = local_9;
                let _e166 = triangles.member[_e163].member_2;
                let _e173 = ((_e166[0] - _e149.x) / _e149.w);
                let _e174 = ((_e166[1] - _e149.y) / _e149.w);
                let _e175 = ((_e166[2] - _e149.z) / _e149.w);
                let _e179 = local_10;
                let _e182 = triangles.member[_e179].member_4;
                let _e189 = ((_e182[0] - _e149.x) / _e149.w);
                let _e190 = ((_e182[1] - _e149.y) / _e149.w);
                let _e191 = ((_e182[2] - _e149.z) / _e149.w);
                let _e193 = (_e173 - _e157);
                let _e194 = (_e174 - _e158);
                let _e195 = (_e175 - _e159);
                let _e196 = (_e189 - _e157);
                let _e197 = (_e190 - _e158);
                let _e198 = (_e191 - _e159);
                let _e201 = ((_e194 * _e198) - (_e197 * _e195));
                let _e204 = ((_e195 * _e196) - (_e198 * _e193));
                let _e207 = ((_e193 * _e197) - (_e196 * _e194));
                let _e209 = abs(_e201);
                let _e210 = abs(_e204);
                let _e211 = abs(_e207);
                let _e212 = (_e209 >= _e210);
                if _e212 {
                    phi_825_ = select(true, false, (_e209 >= _e211));
                } else {
                    phi_825_ = true;
                }
                let _e216 = phi_825_;
                if _e216 {
                    phi_834_ = select(2u, 1u, (_e210 >= _e211));
                } else {
                    phi_834_ = 0u;
                }
                let _e220 = phi_834_;
                let _e223 = params.member.member_1;
                let _e225 = f32(_e223.x);
                let _e227 = f32(_e223.y);
                let _e229 = f32(_e223.z);
                let _e231 = (_e220 == 0u);
                if _e231 {
                    phi_855_ = vec3<f32>(_e227, _e229, _e225);
                } else {
                    if (_e220 == 1u) {
                        phi_854_ = vec3<f32>(_e229, _e225, _e227);
                    } else {
                        phi_854_ = vec3<f32>(_e225, _e227, _e229);
                    }
                    let _e235 = phi_854_;
                    phi_855_ = _e235;
                }
                let _e238 = phi_855_;
                if _e231 {
                    phi_867_ = vec3<f32>(_e158, _e159, _e157);
                } else {
                    if (_e220 == 1u) {
                        phi_866_ = vec3<f32>(_e159, _e157, _e158);
                    } else {
                        phi_866_ = vec3<f32>(_e157, _e158, _e159);
                    }
                    let _e242 = phi_866_;
                    phi_867_ = _e242;
                }
                let _e245 = phi_867_;
                if _e231 {
                    phi_879_ = vec3<f32>(_e174, _e175, _e173);
                } else {
                    if (_e220 == 1u) {
                        phi_878_ = vec3<f32>(_e175, _e173, _e174);
                    } else {
                        phi_878_ = vec3<f32>(_e173, _e174, _e175);
                    }
                    let _e249 = phi_878_;
                    phi_879_ = _e249;
                }
                let _e252 = phi_879_;
                if _e231 {
                    phi_891_ = vec3<f32>(_e190, _e191, _e189);
                } else {
                    if (_e220 == 1u) {
                        phi_890_ = vec3<f32>(_e191, _e189, _e190);
                    } else {
                        phi_890_ = vec3<f32>(_e189, _e190, _e191);
                    }
                    let _e256 = phi_890_;
                    phi_891_ = _e256;
                }
                let _e259 = phi_891_;
                let _e263 = select(_e252.x, _e245.x, (_e245.x < _e252.x));
                let _e268 = select(_e252.x, _e245.x, (_e245.x > _e252.x));
                let _e274 = (-1f - floor(-(select(_e259.x, _e263, (_e263 < _e259.x)))));
                let _e275 = floor(select(_e259.x, _e268, (_e268 > _e259.x)));
                let _e276 = (_e238.x - 1f);
                let _e278 = select(0f, _e274, (_e274 > 0f));
                let _e280 = select(_e276, _e275, (_e275 < _e276));
                let _e287 = select(0i, select(select(i32(_e278), i32(-2147483648), (_e278 < -2147483600f)), 2147483647i, (_e278 > 2147483500f)), (_e278 == _e278));
                let _e294 = select(0i, select(select(i32(_e280), i32(-2147483648), (_e280 < -2147483600f)), 2147483647i, (_e280 > 2147483500f)), (_e280 == _e280));
                let _e298 = select(_e252.y, _e245.y, (_e245.y < _e252.y));
                let _e303 = select(_e252.y, _e245.y, (_e245.y > _e252.y));
                let _e309 = (-1f - floor(-(select(_e259.y, _e298, (_e298 < _e259.y)))));
                let _e310 = floor(select(_e259.y, _e303, (_e303 > _e259.y)));
                let _e311 = (_e238.y - 1f);
                let _e313 = select(0f, _e309, (_e309 > 0f));
                let _e315 = select(_e311, _e310, (_e310 < _e311));
                let _e322 = select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < -2147483600f)), 2147483647i, (_e313 > 2147483500f)), (_e313 == _e313));
                let _e329 = select(0i, select(select(i32(_e315), i32(-2147483648), (_e315 < -2147483600f)), 2147483647i, (_e315 > 2147483500f)), (_e315 == _e315));
                let _e330 = type_38(_e245, _e252, _e259, vec3<f32>(_e201, _e204, _e207), _e220, _e238, _e287, _e294, _e322, _e329);
                if _e212 {
                    phi_1027_ = select(true, false, (_e209 >= _e211));
                } else {
                    phi_1027_ = true;
                }
                let _e334 = phi_1027_;
                if _e334 {
                    phi_1036_ = select(2u, 1u, (_e210 >= _e211));
                } else {
                    phi_1036_ = 0u;
                }
                let _e338 = phi_1036_;
                if (_e338 == 0u) {
                    phi_1046_ = _e201;
                } else {
                    phi_1046_ = select(_e207, _e204, (_e338 == 1u));
                }
                let _e343 = phi_1046_;
                let _e352 = (((_e201 * _e201) + (_e204 * _e204)) + (_e207 * _e207));
                if (_e352 >= 0.000000000000000000000000000000000000011754944f) {
                    let _e355 = (1f / sqrt(_e352));
                    phi_1066_ = vec3<f32>((_e201 * _e355), (_e204 * _e355), (_e207 * _e355));
                } else {
                    phi_1066_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e361 = phi_1066_;
                let _e364 = local_11;
                let _e367 = triangles.member[_e364].member_1;
                let _e368 = (_e367 * 12u);
                let _e369 = (256u + _e368);
                if (_e369 < _e98) {
                } else {
                    break;
                }
                let _e373 = surfaces.member[_e369];
                let _e374 = bitcast<f32>(_e373);
                let _e375 = (_e368 + 257u);
                if (_e375 < _e98) {
                } else {
                    break;
                }
                let _e379 = surfaces.member[_e375];
                let _e380 = bitcast<f32>(_e379);
                let _e381 = (_e368 + 258u);
                if (_e381 < _e98) {
                } else {
                    break;
                }
                let _e385 = surfaces.member[_e381];
                let _e386 = bitcast<f32>(_e385);
                let _e387 = (_e368 + 259u);
                if (_e387 < _e98) {
                } else {
                    break;
                }
                let _e391 = surfaces.member[_e387];
                let _e392 = (_e368 + 260u);
                if (_e392 < _e98) {
                } else {
                    break;
                }
                let _e396 = surfaces.member[_e392];
                let _e398 = (_e368 + 261u);
                if (_e398 < _e98) {
                } else {
                    break;
                }
                let _e402 = surfaces.member[_e398];
                let _e404 = (_e368 + 262u);
                if (_e404 < _e98) {
                } else {
                    break;
                }
                let _e408 = surfaces.member[_e404];
                let _e410 = (_e368 + 263u);
                if (_e410 < _e98) {
                } else {
                    break;
                }
                let _e414 = surfaces.member[_e410];
                let _e415 = (_e368 + 264u);
                if (_e415 < _e98) {
                } else {
                    break;
                }
                let _e419 = surfaces.member[_e415];
                let _e420 = bitcast<f32>(_e419);
                let _e421 = (_e368 + 265u);
                if (_e421 < _e98) {
                } else {
                    break;
                }
                let _e425 = surfaces.member[_e421];
                if ((_e368 + 266u) < _e98) {
                } else {
                    break;
                }
                if ((_e368 + 267u) < _e98) {
                } else {
                    break;
                }
                let _e432 = local_12;
                if (_e432 < _e100) {
                } else {
                    break;
                }
                let _e436 = local_13;
                let _e438 = tile_first.member[_e436];
                let _e439 = (_e106 - _e438);
                if (_e294 < _e287) {
                    phi_1190_ = 0u;
                } else {
                    phi_1190_ = ((bitcast<u32>((_e294 - _e287)) / 4u) + 1u);
                }
                let _e446 = phi_1190_;
                let _e448 = select(1u, _e446, (1u < _e446));
                if (_e448 == 0u) {
                    break;
                }
                let _e450 = (_e439 / _e448);
                let _e455 = (_e287 + bitcast<i32>(((_e439 - (_e450 * _e448)) * 4u)));
                let _e458 = (_e322 + bitcast<i32>((_e450 * 4u)));
                let _e462 = select(_e252.z, _e245.z, (_e245.z < _e252.z));
                let _e467 = select(_e252.z, _e245.z, (_e245.z > _e252.z));
                let _e473 = (-1f - floor(-(select(_e259.z, _e462, (_e462 < _e259.z)))));
                let _e474 = floor(select(_e259.z, _e467, (_e467 > _e259.z)));
                let _e475 = (_e238.z - 1f);
                let _e477 = select(0f, _e473, (_e473 > 0f));
                let _e479 = select(_e475, _e474, (_e474 < _e475));
                let _e486 = select(0i, select(select(i32(_e477), i32(-2147483648), (_e477 < -2147483600f)), 2147483647i, (_e477 > 2147483500f)), (_e477 == _e477));
                let _e493 = select(0i, select(select(i32(_e479), i32(-2147483648), (_e479 < -2147483600f)), 2147483647i, (_e479 > 2147483500f)), (_e479 == _e479));
                let _e494 = (_e252.x - _e245.x);
                let _e495 = (_e252.y - _e245.y);
                let _e501 = ((abs(_e494) + abs(_e495)) + abs((_e252.z - _e245.z)));
                let _e502 = (_e259.x - _e245.x);
                let _e503 = (_e259.y - _e245.y);
                let _e509 = ((abs(_e502) + abs(_e503)) + abs((_e259.z - _e245.z)));
                let _e511 = select(_e210, _e209, (_e209 > _e210));
                let _e519 = (select(_e211, _e511, (_e511 > _e211)) <= (((0.000004f * _e501) * _e509) * select(_e509, _e501, (_e501 > _e509))));
                let _e520 = (_e455 + 4i);
                let _e521 = (_e294 + 1i);
                let _e523 = select(_e520, _e521, (_e521 < _e520));
                let _e524 = (_e458 + 4i);
                let _e525 = (_e329 + 1i);
                let _e528 = (_e455 - 1i);
                let _e531 = (f32(_e455) + 2f);
                let _e533 = (f32(_e458) + 2f);
                let _e536 = ((_e245.x - _e531) * 0.24937655f);
                let _e537 = ((_e245.y - _e533) * 0.24937655f);
                let _e540 = ((_e252.x - _e531) * 0.24937655f);
                let _e541 = ((_e252.y - _e533) * 0.24937655f);
                let _e544 = ((_e259.x - _e531) * 0.24937655f);
                let _e545 = ((_e259.y - _e533) * 0.24937655f);
                let _e546 = (_e540 - _e536);
                let _e547 = (_e541 - _e537);
                let _e550 = ((_e546 * _e537) - (_e547 * _e536));
                let _e553 = ((_e546 * _e545) - (_e547 * _e544));
                let _e556 = (abs(_e546) + abs(_e547));
                if (select(_e553, _e550, (_e550 < _e553)) > (0.5f * _e556)) {
                    phi_4716_ = true;
                } else {
                    phi_4716_ = (select(_e553, _e550, (_e550 > _e553)) < (_e556 * -0.5f));
                }
                let _e566 = phi_4716_;
                if _e566 {
                    phi_1387_ = bool();
                    phi_1388_ = true;
                } else {
                    let _e567 = (_e544 - _e540);
                    let _e568 = (_e545 - _e541);
                    let _e571 = ((_e567 * _e541) - (_e568 * _e540));
                    let _e574 = ((_e567 * _e537) - (_e568 * _e536));
                    let _e577 = (abs(_e567) + abs(_e568));
                    if (select(_e574, _e571, (_e571 < _e574)) > (0.5f * _e577)) {
                        phi_4755_ = true;
                    } else {
                        phi_4755_ = (select(_e574, _e571, (_e571 > _e574)) < (_e577 * -0.5f));
                    }
                    let _e587 = phi_4755_;
                    if _e587 {
                        phi_1386_ = bool();
                    } else {
                        let _e588 = (_e536 - _e544);
                        let _e589 = (_e537 - _e545);
                        let _e592 = ((_e588 * _e545) - (_e589 * _e544));
                        let _e595 = ((_e588 * _e541) - (_e589 * _e540));
                        let _e598 = (abs(_e588) + abs(_e589));
                        if (select(_e595, _e592, (_e592 < _e595)) > (0.5f * _e598)) {
                            phi_4794_ = true;
                        } else {
                            phi_4794_ = (select(_e595, _e592, (_e592 > _e595)) < (_e598 * -0.5f));
                        }
                        let _e608 = phi_4794_;
                        phi_1386_ = _e608;
                    }
                    let _e610 = phi_1386_;
                    phi_1387_ = _e610;
                    phi_1388_ = _e587;
                }
                let _e612 = phi_1387_;
                let _e614 = phi_1388_;
                if select(_e612, true, _e614) {
                    phi_1397_ = type_39(_e330, _e455, _e523, _e458, _e486, _e493, _e528, _e458, 0i, -1i, _e519);
                } else {
                    phi_1397_ = type_39(_e330, _e455, _e523, select(_e524, _e525, (_e525 < _e524)), _e486, _e493, _e528, _e458, 0i, -1i, _e519);
                }
                let _e618 = phi_1397_;
                phi_5747_ = _e134;
                phi_5365_ = _e618.member_6;
                phi_5362_ = _e618.member_9;
                phi_5359_ = _e618.member_8;
                phi_5356_ = _e618.member_7;
                loop {
                    let _e637 = phi_5747_;
                    let _e639 = phi_5365_;
                    let _e641 = phi_5362_;
                    let _e643 = phi_5359_;
                    let _e645 = phi_5356_;
                    phi_5364_ = _e639;
                    phi_5361_ = _e641;
                    phi_5358_ = _e643;
                    phi_5355_ = _e645;
                    loop {
                        let _e647 = phi_5364_;
                        let _e649 = phi_5361_;
                        let _e651 = phi_5358_;
                        let _e653 = phi_5355_;
                        let _e654 = (_e653 < _e618.member_3);
                        if _e654 {
                            phi_5357_ = _e651;
                            loop {
                                let _e656 = phi_5357_;
                                let _e657 = (_e656 < _e649);
                                if _e657 {
                                    let _e658 = (_e656 + 1i);
                                    let _e662 = (f32(_e647) + 0.5f);
                                    let _e663 = (f32(_e653) + 0.5f);
                                    let _e664 = (f32(_e658) + 0.5f);
                                    let _e666 = (_e618.member.member.x - _e662);
                                    let _e668 = (_e618.member.member.y - _e663);
                                    let _e670 = (_e618.member.member.z - _e664);
                                    let _e671 = vec3<f32>(_e662, _e663, _e664);
                                    let _e674 = (_e618.member.member_1.x - _e662);
                                    let _e676 = (_e618.member.member_1.y - _e663);
                                    let _e678 = (_e618.member.member_1.z - _e664);
                                    let _e681 = (_e618.member.member_2.x - _e662);
                                    let _e683 = (_e618.member.member_2.y - _e663);
                                    let _e685 = (_e618.member.member_2.z - _e664);
                                    let _e688 = select(_e674, _e666, (_e666 < _e674));
                                    let _e692 = select(_e676, _e668, (_e668 < _e676));
                                    let _e696 = select(_e678, _e670, (_e670 < _e678));
                                    let _e700 = select(_e674, _e666, (_e666 > _e674));
                                    let _e704 = select(_e676, _e668, (_e668 > _e676));
                                    let _e708 = select(_e678, _e670, (_e670 > _e678));
                                    if (select(_e681, _e688, (_e688 < _e681)) > 0.5f) {
                                        phi_2041_ = bool();
                                        phi_2042_ = true;
                                        phi_2043_ = false;
                                    } else {
                                        if (select(_e683, _e692, (_e692 < _e683)) > 0.5f) {
                                            phi_2038_ = bool();
                                            phi_2039_ = true;
                                            phi_2040_ = false;
                                        } else {
                                            if (select(_e685, _e696, (_e696 < _e685)) > 0.5f) {
                                                phi_2035_ = bool();
                                                phi_2036_ = true;
                                                phi_2037_ = false;
                                            } else {
                                                if (select(_e681, _e700, (_e700 > _e681)) < -0.5f) {
                                                    phi_2032_ = bool();
                                                    phi_2033_ = true;
                                                    phi_2034_ = false;
                                                } else {
                                                    if (select(_e683, _e704, (_e704 > _e683)) < -0.5f) {
                                                        phi_2029_ = bool();
                                                        phi_2030_ = true;
                                                        phi_2031_ = false;
                                                    } else {
                                                        let _e716 = (select(_e685, _e708, (_e708 > _e685)) < -0.5f);
                                                        if _e716 {
                                                            phi_2027_ = bool();
                                                            phi_2028_ = false;
                                                        } else {
                                                            let _e717 = (_e674 - _e666);
                                                            let _e718 = (_e676 - _e668);
                                                            let _e719 = (_e678 - _e670);
                                                            let _e720 = vec3<f32>(_e717, _e718, _e719);
                                                            let _e721 = (_e681 - _e674);
                                                            let _e722 = (_e683 - _e676);
                                                            let _e723 = (_e685 - _e678);
                                                            let _e724 = vec3<f32>(_e721, _e722, _e723);
                                                            let _e725 = (_e666 - _e681);
                                                            let _e726 = (_e668 - _e683);
                                                            let _e727 = (_e670 - _e685);
                                                            let _e728 = vec3<f32>(_e725, _e726, _e727);
                                                            let _e731 = ((_e718 * _e670) - (_e719 * _e668));
                                                            let _e734 = ((_e718 * _e685) - (_e719 * _e683));
                                                            let _e735 = abs(_e718);
                                                            let _e736 = abs(_e719);
                                                            let _e737 = (_e735 + _e736);
                                                            if (select(_e734, _e731, (_e731 < _e734)) > (0.5f * _e737)) {
                                                                phi_1617_ = true;
                                                            } else {
                                                                phi_1617_ = (select(_e734, _e731, (_e731 > _e734)) < (_e737 * -0.5f));
                                                            }
                                                            let _e747 = phi_1617_;
                                                            if _e747 {
                                                                phi_1679_ = bool();
                                                                phi_1680_ = true;
                                                            } else {
                                                                let _e750 = ((_e719 * _e666) - (_e717 * _e670));
                                                                let _e753 = ((_e719 * _e681) - (_e717 * _e685));
                                                                let _e754 = abs(_e717);
                                                                let _e755 = (_e736 + _e754);
                                                                if (select(_e753, _e750, (_e750 < _e753)) > (0.5f * _e755)) {
                                                                    phi_1647_ = true;
                                                                } else {
                                                                    phi_1647_ = (select(_e753, _e750, (_e750 > _e753)) < (_e755 * -0.5f));
                                                                }
                                                                let _e765 = phi_1647_;
                                                                if _e765 {
                                                                    phi_1678_ = bool();
                                                                } else {
                                                                    let _e768 = ((_e717 * _e668) - (_e718 * _e666));
                                                                    let _e771 = ((_e717 * _e683) - (_e718 * _e681));
                                                                    let _e772 = (_e754 + _e735);
                                                                    if (select(_e771, _e768, (_e768 < _e771)) > (0.5f * _e772)) {
                                                                        phi_1677_ = true;
                                                                    } else {
                                                                        phi_1677_ = (select(_e771, _e768, (_e768 > _e771)) < (_e772 * -0.5f));
                                                                    }
                                                                    let _e782 = phi_1677_;
                                                                    phi_1678_ = _e782;
                                                                }
                                                                let _e784 = phi_1678_;
                                                                phi_1679_ = _e784;
                                                                phi_1680_ = _e765;
                                                            }
                                                            let _e786 = phi_1679_;
                                                            let _e788 = phi_1680_;
                                                            if select(_e786, true, _e788) {
                                                                phi_2022_ = bool();
                                                                phi_2023_ = true;
                                                            } else {
                                                                let _e792 = ((_e722 * _e678) - (_e723 * _e676));
                                                                let _e795 = ((_e722 * _e670) - (_e723 * _e668));
                                                                let _e796 = abs(_e722);
                                                                let _e797 = abs(_e723);
                                                                let _e798 = (_e796 + _e797);
                                                                if (select(_e795, _e792, (_e792 < _e795)) > (0.5f * _e798)) {
                                                                    phi_1714_ = true;
                                                                } else {
                                                                    phi_1714_ = (select(_e795, _e792, (_e792 > _e795)) < (_e798 * -0.5f));
                                                                }
                                                                let _e808 = phi_1714_;
                                                                if _e808 {
                                                                    phi_1776_ = bool();
                                                                    phi_1777_ = true;
                                                                } else {
                                                                    let _e811 = ((_e723 * _e674) - (_e721 * _e678));
                                                                    let _e814 = ((_e723 * _e666) - (_e721 * _e670));
                                                                    let _e815 = abs(_e721);
                                                                    let _e816 = (_e797 + _e815);
                                                                    if (select(_e814, _e811, (_e811 < _e814)) > (0.5f * _e816)) {
                                                                        phi_1744_ = true;
                                                                    } else {
                                                                        phi_1744_ = (select(_e814, _e811, (_e811 > _e814)) < (_e816 * -0.5f));
                                                                    }
                                                                    let _e826 = phi_1744_;
                                                                    if _e826 {
                                                                        phi_1775_ = bool();
                                                                    } else {
                                                                        let _e829 = ((_e721 * _e676) - (_e722 * _e674));
                                                                        let _e832 = ((_e721 * _e668) - (_e722 * _e666));
                                                                        let _e833 = (_e815 + _e796);
                                                                        if (select(_e832, _e829, (_e829 < _e832)) > (0.5f * _e833)) {
                                                                            phi_1774_ = true;
                                                                        } else {
                                                                            phi_1774_ = (select(_e832, _e829, (_e829 > _e832)) < (_e833 * -0.5f));
                                                                        }
                                                                        let _e843 = phi_1774_;
                                                                        phi_1775_ = _e843;
                                                                    }
                                                                    let _e845 = phi_1775_;
                                                                    phi_1776_ = _e845;
                                                                    phi_1777_ = _e826;
                                                                }
                                                                let _e847 = phi_1776_;
                                                                let _e849 = phi_1777_;
                                                                if select(_e847, true, _e849) {
                                                                    phi_2020_ = bool();
                                                                    phi_2021_ = true;
                                                                } else {
                                                                    let _e853 = ((_e726 * _e685) - (_e727 * _e683));
                                                                    let _e856 = ((_e726 * _e678) - (_e727 * _e676));
                                                                    let _e857 = abs(_e726);
                                                                    let _e858 = abs(_e727);
                                                                    let _e859 = (_e857 + _e858);
                                                                    if (select(_e856, _e853, (_e853 < _e856)) > (0.5f * _e859)) {
                                                                        phi_1811_ = true;
                                                                    } else {
                                                                        phi_1811_ = (select(_e856, _e853, (_e853 > _e856)) < (_e859 * -0.5f));
                                                                    }
                                                                    let _e869 = phi_1811_;
                                                                    if _e869 {
                                                                        phi_1873_ = bool();
                                                                        phi_1874_ = true;
                                                                    } else {
                                                                        let _e872 = ((_e727 * _e681) - (_e725 * _e685));
                                                                        let _e875 = ((_e727 * _e674) - (_e725 * _e678));
                                                                        let _e876 = abs(_e725);
                                                                        let _e877 = (_e858 + _e876);
                                                                        if (select(_e875, _e872, (_e872 < _e875)) > (0.5f * _e877)) {
                                                                            phi_1841_ = true;
                                                                        } else {
                                                                            phi_1841_ = (select(_e875, _e872, (_e872 > _e875)) < (_e877 * -0.5f));
                                                                        }
                                                                        let _e887 = phi_1841_;
                                                                        if _e887 {
                                                                            phi_1872_ = bool();
                                                                        } else {
                                                                            let _e890 = ((_e725 * _e683) - (_e726 * _e681));
                                                                            let _e893 = ((_e725 * _e676) - (_e726 * _e674));
                                                                            let _e894 = (_e876 + _e857);
                                                                            if (select(_e893, _e890, (_e890 < _e893)) > (0.5f * _e894)) {
                                                                                phi_1871_ = true;
                                                                            } else {
                                                                                phi_1871_ = (select(_e893, _e890, (_e890 > _e893)) < (_e894 * -0.5f));
                                                                            }
                                                                            let _e904 = phi_1871_;
                                                                            phi_1872_ = _e904;
                                                                        }
                                                                        let _e906 = phi_1872_;
                                                                        phi_1873_ = _e906;
                                                                        phi_1874_ = _e887;
                                                                    }
                                                                    let _e908 = phi_1873_;
                                                                    let _e910 = phi_1874_;
                                                                    let _e911 = select(_e908, true, _e910);
                                                                    if _e911 {
                                                                        phi_2019_ = bool();
                                                                    } else {
                                                                        let _e914 = ((abs(_e717) + _e735) + _e736);
                                                                        let _e917 = ((abs(_e721) + _e796) + _e797);
                                                                        let _e920 = ((abs(_e725) + _e857) + _e858);
                                                                        if (_e914 >= _e917) {
                                                                            phi_1906_ = select(true, false, (_e914 >= _e920));
                                                                        } else {
                                                                            phi_1906_ = true;
                                                                        }
                                                                        let _e925 = phi_1906_;
                                                                        if _e925 {
                                                                            let _e927 = vec3((_e917 >= _e920));
                                                                            phi_1916_ = select(_e720, _e728, _e927);
                                                                            phi_1917_ = select(_e724, _e720, _e927);
                                                                        } else {
                                                                            phi_1916_ = _e724;
                                                                            phi_1917_ = _e728;
                                                                        }
                                                                        let _e931 = phi_1916_;
                                                                        let _e933 = phi_1917_;
                                                                        let _e940 = ((_e931.y * _e933.z) - (_e933.y * _e931.z));
                                                                        let _e945 = ((_e931.z * _e933.x) - (_e933.z * _e931.x));
                                                                        let _e948 = ((_e931.x * _e933.y) - (_e933.x * _e931.y));
                                                                        let _e959 = ((abs(_e666) + abs(_e668)) + abs(_e670));
                                                                        let _e964 = ((abs(_e674) + abs(_e676)) + abs(_e678));
                                                                        let _e969 = ((abs(_e681) + abs(_e683)) + abs(_e685));
                                                                        if (_e959 <= _e964) {
                                                                            phi_1969_ = select(true, false, (_e959 <= _e969));
                                                                        } else {
                                                                            phi_1969_ = true;
                                                                        }
                                                                        let _e974 = phi_1969_;
                                                                        if _e974 {
                                                                            phi_1978_ = select((_e618.member.member_2 - _e671), (_e618.member.member_1 - _e671), vec3((_e964 <= _e969)));
                                                                        } else {
                                                                            phi_1978_ = (_e618.member.member - _e671);
                                                                        }
                                                                        let _e979 = phi_1978_;
                                                                        let _e981 = select(_e964, _e959, (_e959 < _e964));
                                                                        phi_2019_ = (abs((((_e940 * _e979.x) + (_e945 * _e979.y)) + (_e948 * _e979.z))) <= ((0.5f * ((abs(_e940) + abs(_e945)) + abs(_e948))) + (((0.00000036f * select(_e969, _e981, (_e981 < _e969))) * ((abs(_e931.x) + abs(_e931.y)) + abs(_e931.z))) * ((abs(_e933.x) + abs(_e933.y)) + abs(_e933.z)))));
                                                                    }
                                                                    let _e1009 = phi_2019_;
                                                                    phi_2020_ = _e1009;
                                                                    phi_2021_ = _e911;
                                                                }
                                                                let _e1011 = phi_2020_;
                                                                let _e1013 = phi_2021_;
                                                                phi_2022_ = _e1011;
                                                                phi_2023_ = _e1013;
                                                            }
                                                            let _e1015 = phi_2022_;
                                                            let _e1017 = phi_2023_;
                                                            phi_2027_ = _e1015;
                                                            phi_2028_ = _e1017;
                                                        }
                                                        let _e1019 = phi_2027_;
                                                        let _e1021 = phi_2028_;
                                                        phi_2029_ = _e1019;
                                                        phi_2030_ = _e716;
                                                        phi_2031_ = _e1021;
                                                    }
                                                    let _e1023 = phi_2029_;
                                                    let _e1025 = phi_2030_;
                                                    let _e1027 = phi_2031_;
                                                    phi_2032_ = _e1023;
                                                    phi_2033_ = _e1025;
                                                    phi_2034_ = _e1027;
                                                }
                                                let _e1029 = phi_2032_;
                                                let _e1031 = phi_2033_;
                                                let _e1033 = phi_2034_;
                                                phi_2035_ = _e1029;
                                                phi_2036_ = _e1031;
                                                phi_2037_ = _e1033;
                                            }
                                            let _e1035 = phi_2035_;
                                            let _e1037 = phi_2036_;
                                            let _e1039 = phi_2037_;
                                            phi_2038_ = _e1035;
                                            phi_2039_ = _e1037;
                                            phi_2040_ = _e1039;
                                        }
                                        let _e1041 = phi_2038_;
                                        let _e1043 = phi_2039_;
                                        let _e1045 = phi_2040_;
                                        phi_2041_ = _e1041;
                                        phi_2042_ = _e1043;
                                        phi_2043_ = _e1045;
                                    }
                                    let _e1047 = phi_2041_;
                                    let _e1049 = phi_2042_;
                                    let _e1051 = phi_2043_;
                                    phi_5655_ = _e658;
                                    phi_2056_ = select(true, false, select(_e1047, false, select(_e1051, true, _e1049)));
                                } else {
                                    phi_5655_ = _e656;
                                    phi_2056_ = false;
                                }
                                let _e1056 = phi_5655_;
                                let _e1058 = phi_2056_;
                                let _e1059 = select(true, false, _e657);
                                local_14 = _e1059;
                                local_54 = _e1056;
                                local_55 = _e1059;
                                continue;
                                continuing {
                                    phi_5357_ = _e1056;
                                    break if !(_e1058);
                                }
                            }
                            let _e1062 = local_14;
                            if _e1062 {
                                let _e1063 = (_e647 + 1i);
                                let _e1064 = (_e1063 >= _e618.member_2);
                                if _e1064 {
                                    phi_5514_ = (_e653 + 1i);
                                } else {
                                    phi_5514_ = _e653;
                                }
                                let _e1067 = phi_5514_;
                                let _e1068 = select(_e1063, _e618.member_1, _e1064);
                                if _e618.member_10 {
                                    let _e1115 = (_e618.member.member_1.x - _e618.member.member.x);
                                    let _e1118 = (_e618.member.member_1.y - _e618.member.member.y);
                                    let _e1121 = (_e618.member.member_1.z - _e618.member.member.z);
                                    let _e1122 = f32(_e1068);
                                    let _e1123 = (_e1122 - 0.01f);
                                    let _e1124 = (_e1123 - _e618.member.member.x);
                                    let _e1125 = (_e1122 + 1.01f);
                                    let _e1126 = (_e1125 - _e618.member.member.x);
                                    if (abs(_e1115) < 0.000001f) {
                                        if (_e1124 <= 0f) {
                                            let _e1137 = (_e1126 >= 0f);
                                            if _e1137 {
                                                phi_4844_ = type_33(0f, 1f);
                                            } else {
                                                phi_4844_ = type_33();
                                            }
                                            let _e1139 = phi_4844_;
                                            phi_4847_ = _e1139;
                                            phi_4848_ = select(true, false, _e1137);
                                        } else {
                                            phi_4847_ = type_33();
                                            phi_4848_ = true;
                                        }
                                        let _e1142 = phi_4847_;
                                        let _e1144 = phi_4848_;
                                        if _e1144 {
                                            phi_4853_ = type_33(1f, 0f);
                                        } else {
                                            phi_4853_ = _e1142;
                                        }
                                        let _e1146 = phi_4853_;
                                        phi_4855_ = _e1146;
                                    } else {
                                        let _e1129 = (_e1124 / _e1115);
                                        let _e1130 = (_e1126 / _e1115);
                                        phi_4855_ = type_33(select(_e1130, _e1129, (_e1129 < _e1130)), select(_e1130, _e1129, (_e1129 > _e1130)));
                                    }
                                    let _e1148 = phi_4855_;
                                    let _e1151 = f32(_e1067);
                                    let _e1152 = (_e1151 - 0.01f);
                                    let _e1153 = (_e1152 - _e618.member.member.y);
                                    let _e1154 = (_e1151 + 1.01f);
                                    let _e1155 = (_e1154 - _e618.member.member.y);
                                    if (abs(_e1118) < 0.000001f) {
                                        if (_e1153 <= 0f) {
                                            let _e1166 = (_e1155 >= 0f);
                                            if _e1166 {
                                                phi_4891_ = type_33(0f, 1f);
                                            } else {
                                                phi_4891_ = type_33();
                                            }
                                            let _e1168 = phi_4891_;
                                            phi_4894_ = _e1168;
                                            phi_4895_ = select(true, false, _e1166);
                                        } else {
                                            phi_4894_ = type_33();
                                            phi_4895_ = true;
                                        }
                                        let _e1171 = phi_4894_;
                                        let _e1173 = phi_4895_;
                                        if _e1173 {
                                            phi_4900_ = type_33(1f, 0f);
                                        } else {
                                            phi_4900_ = _e1171;
                                        }
                                        let _e1175 = phi_4900_;
                                        phi_4902_ = _e1175;
                                    } else {
                                        let _e1158 = (_e1153 / _e1118);
                                        let _e1159 = (_e1155 / _e1118);
                                        phi_4902_ = type_33(select(_e1159, _e1158, (_e1158 < _e1159)), select(_e1159, _e1158, (_e1158 > _e1159)));
                                    }
                                    let _e1177 = phi_4902_;
                                    let _e1181 = select(_e1177.member, _e1148.member, (_e1148.member > _e1177.member));
                                    let _e1183 = select(0f, _e1181, (_e1181 > 0f));
                                    let _e1185 = select(_e1177.member_1, _e1148.member_1, (_e1148.member_1 < _e1177.member_1));
                                    let _e1187 = select(1f, _e1185, (_e1185 < 1f));
                                    if (_e1183 > _e1187) {
                                        phi_4950_ = type_33(_e618.member.member_5.z, -2f);
                                    } else {
                                        let _e1190 = (_e618.member.member.z + (_e1121 * _e1183));
                                        let _e1192 = (_e618.member.member.z + (_e1121 * _e1187));
                                        phi_4950_ = type_33(select(_e1192, _e1190, (_e1190 < _e1192)), select(_e1192, _e1190, (_e1190 > _e1192)));
                                    }
                                    let _e1201 = phi_4950_;
                                    let _e1205 = (_e618.member.member_2.x - _e618.member.member_1.x);
                                    let _e1207 = (_e618.member.member_2.y - _e618.member.member_1.y);
                                    let _e1209 = (_e618.member.member_2.z - _e618.member.member_1.z);
                                    let _e1210 = (_e1123 - _e618.member.member_1.x);
                                    let _e1211 = (_e1125 - _e618.member.member_1.x);
                                    if (abs(_e1205) < 0.000001f) {
                                        if (_e1210 <= 0f) {
                                            let _e1222 = (_e1211 >= 0f);
                                            if _e1222 {
                                                phi_4999_ = type_33(0f, 1f);
                                            } else {
                                                phi_4999_ = type_33();
                                            }
                                            let _e1224 = phi_4999_;
                                            phi_5002_ = _e1224;
                                            phi_5003_ = select(true, false, _e1222);
                                        } else {
                                            phi_5002_ = type_33();
                                            phi_5003_ = true;
                                        }
                                        let _e1227 = phi_5002_;
                                        let _e1229 = phi_5003_;
                                        if _e1229 {
                                            phi_5008_ = type_33(1f, 0f);
                                        } else {
                                            phi_5008_ = _e1227;
                                        }
                                        let _e1231 = phi_5008_;
                                        phi_5010_ = _e1231;
                                    } else {
                                        let _e1214 = (_e1210 / _e1205);
                                        let _e1215 = (_e1211 / _e1205);
                                        phi_5010_ = type_33(select(_e1215, _e1214, (_e1214 < _e1215)), select(_e1215, _e1214, (_e1214 > _e1215)));
                                    }
                                    let _e1233 = phi_5010_;
                                    let _e1236 = (_e1152 - _e618.member.member_1.y);
                                    let _e1237 = (_e1154 - _e618.member.member_1.y);
                                    if (abs(_e1207) < 0.000001f) {
                                        if (_e1236 <= 0f) {
                                            let _e1248 = (_e1237 >= 0f);
                                            if _e1248 {
                                                phi_5046_ = type_33(0f, 1f);
                                            } else {
                                                phi_5046_ = type_33();
                                            }
                                            let _e1250 = phi_5046_;
                                            phi_5049_ = _e1250;
                                            phi_5050_ = select(true, false, _e1248);
                                        } else {
                                            phi_5049_ = type_33();
                                            phi_5050_ = true;
                                        }
                                        let _e1253 = phi_5049_;
                                        let _e1255 = phi_5050_;
                                        if _e1255 {
                                            phi_5055_ = type_33(1f, 0f);
                                        } else {
                                            phi_5055_ = _e1253;
                                        }
                                        let _e1257 = phi_5055_;
                                        phi_5057_ = _e1257;
                                    } else {
                                        let _e1240 = (_e1236 / _e1207);
                                        let _e1241 = (_e1237 / _e1207);
                                        phi_5057_ = type_33(select(_e1241, _e1240, (_e1240 < _e1241)), select(_e1241, _e1240, (_e1240 > _e1241)));
                                    }
                                    let _e1259 = phi_5057_;
                                    let _e1263 = select(_e1259.member, _e1233.member, (_e1233.member > _e1259.member));
                                    let _e1265 = select(0f, _e1263, (_e1263 > 0f));
                                    let _e1267 = select(_e1259.member_1, _e1233.member_1, (_e1233.member_1 < _e1259.member_1));
                                    let _e1269 = select(1f, _e1267, (_e1267 < 1f));
                                    if (_e1265 > _e1269) {
                                        phi_5105_ = type_33(_e618.member.member_5.z, -2f);
                                    } else {
                                        let _e1272 = (_e618.member.member_1.z + (_e1209 * _e1265));
                                        let _e1274 = (_e618.member.member_1.z + (_e1209 * _e1269));
                                        phi_5105_ = type_33(select(_e1274, _e1272, (_e1272 < _e1274)), select(_e1274, _e1272, (_e1272 > _e1274)));
                                    }
                                    let _e1283 = phi_5105_;
                                    let _e1286 = (_e618.member.member.x - _e618.member.member_2.x);
                                    let _e1287 = (_e618.member.member.y - _e618.member.member_2.y);
                                    let _e1288 = (_e618.member.member.z - _e618.member.member_2.z);
                                    let _e1289 = (_e1123 - _e618.member.member_2.x);
                                    let _e1290 = (_e1125 - _e618.member.member_2.x);
                                    if (abs(_e1286) < 0.000001f) {
                                        if (_e1289 <= 0f) {
                                            let _e1301 = (_e1290 >= 0f);
                                            if _e1301 {
                                                phi_5154_ = type_33(0f, 1f);
                                            } else {
                                                phi_5154_ = type_33();
                                            }
                                            let _e1303 = phi_5154_;
                                            phi_5157_ = _e1303;
                                            phi_5158_ = select(true, false, _e1301);
                                        } else {
                                            phi_5157_ = type_33();
                                            phi_5158_ = true;
                                        }
                                        let _e1306 = phi_5157_;
                                        let _e1308 = phi_5158_;
                                        if _e1308 {
                                            phi_5163_ = type_33(1f, 0f);
                                        } else {
                                            phi_5163_ = _e1306;
                                        }
                                        let _e1310 = phi_5163_;
                                        phi_5165_ = _e1310;
                                    } else {
                                        let _e1293 = (_e1289 / _e1286);
                                        let _e1294 = (_e1290 / _e1286);
                                        phi_5165_ = type_33(select(_e1294, _e1293, (_e1293 < _e1294)), select(_e1294, _e1293, (_e1293 > _e1294)));
                                    }
                                    let _e1312 = phi_5165_;
                                    let _e1315 = (_e1152 - _e618.member.member_2.y);
                                    let _e1316 = (_e1154 - _e618.member.member_2.y);
                                    if (abs(_e1287) < 0.000001f) {
                                        if (_e1315 <= 0f) {
                                            let _e1327 = (_e1316 >= 0f);
                                            if _e1327 {
                                                phi_5201_ = type_33(0f, 1f);
                                            } else {
                                                phi_5201_ = type_33();
                                            }
                                            let _e1329 = phi_5201_;
                                            phi_5204_ = _e1329;
                                            phi_5205_ = select(true, false, _e1327);
                                        } else {
                                            phi_5204_ = type_33();
                                            phi_5205_ = true;
                                        }
                                        let _e1332 = phi_5204_;
                                        let _e1334 = phi_5205_;
                                        if _e1334 {
                                            phi_5210_ = type_33(1f, 0f);
                                        } else {
                                            phi_5210_ = _e1332;
                                        }
                                        let _e1336 = phi_5210_;
                                        phi_5212_ = _e1336;
                                    } else {
                                        let _e1319 = (_e1315 / _e1287);
                                        let _e1320 = (_e1316 / _e1287);
                                        phi_5212_ = type_33(select(_e1320, _e1319, (_e1319 < _e1320)), select(_e1320, _e1319, (_e1319 > _e1320)));
                                    }
                                    let _e1338 = phi_5212_;
                                    let _e1342 = select(_e1338.member, _e1312.member, (_e1312.member > _e1338.member));
                                    let _e1344 = select(0f, _e1342, (_e1342 > 0f));
                                    let _e1346 = select(_e1338.member_1, _e1312.member_1, (_e1312.member_1 < _e1338.member_1));
                                    let _e1348 = select(1f, _e1346, (_e1346 < 1f));
                                    if (_e1344 > _e1348) {
                                        phi_5260_ = type_33(_e618.member.member_5.z, -2f);
                                    } else {
                                        let _e1351 = (_e618.member.member_2.z + (_e1288 * _e1344));
                                        let _e1353 = (_e618.member.member_2.z + (_e1288 * _e1348));
                                        phi_5260_ = type_33(select(_e1353, _e1351, (_e1351 < _e1353)), select(_e1353, _e1351, (_e1351 > _e1353)));
                                    }
                                    let _e1362 = phi_5260_;
                                    let _e1366 = select(_e1283.member, _e1201.member, (_e1201.member < _e1283.member));
                                    let _e1372 = select(_e1283.member_1, _e1201.member_1, (_e1201.member_1 > _e1283.member_1));
                                    phi_2152_ = type_33((floor(select(_e1362.member, _e1366, (_e1366 < _e1362.member))) - 1f), (floor(select(_e1362.member_1, _e1372, (_e1372 > _e1362.member_1))) + 1f));
                                } else {
                                    if (_e618.member.member_4 == 0u) {
                                        phi_2110_ = vec3<f32>(_e618.member.member_3.y, _e618.member.member_3.z, _e618.member.member_3.x);
                                    } else {
                                        if (_e618.member.member_4 == 1u) {
                                            phi_2109_ = vec3<f32>(_e618.member.member_3.z, _e618.member.member_3.x, _e618.member.member_3.y);
                                        } else {
                                            phi_2109_ = _e618.member.member_3;
                                        }
                                        let _e1076 = phi_2109_;
                                        phi_2110_ = _e1076;
                                    }
                                    let _e1082 = phi_2110_;
                                    let _e1099 = (_e618.member.member.z - (((_e1082.x * ((f32(_e1068) + 0.5f) - _e618.member.member.x)) + (_e1082.y * ((f32(_e1067) + 0.5f) - _e618.member.member.y))) / _e1082.z));
                                    let _e1106 = (((0.5f * (abs(_e1082.x) + abs(_e1082.y))) / abs(_e1082.z)) + 0.3f);
                                    phi_2152_ = type_33((-1f - floor((_e1106 - _e1099))), floor((_e1099 + _e1106)));
                                }
                                let _e1379 = phi_2152_;
                                let _e1382 = f32(_e618.member_4);
                                let _e1384 = select(_e1382, _e1379.member, (_e1379.member > _e1382));
                                let _e1393 = f32(_e618.member_5);
                                let _e1395 = select(_e1393, _e1379.member_1, (_e1379.member_1 < _e1393));
                                phi_6363_ = select(0i, select(select(i32(_e1395), i32(-2147483648), (_e1395 < -2147483600f)), 2147483647i, (_e1395 > 2147483500f)), (_e1395 == _e1395));
                                phi_5654_ = (select(0i, select(select(i32(_e1384), i32(-2147483648), (_e1384 < -2147483600f)), 2147483647i, (_e1384 > 2147483500f)), (_e1384 == _e1384)) - 1i);
                                phi_5630_ = _e1067;
                                phi_5600_ = _e1068;
                            } else {
                                phi_6363_ = _e649;
                                let _e3336 = local_54;
                                phi_5654_ = _e3336;
                                phi_5630_ = _e653;
                                phi_5600_ = _e647;
                            }
                            let _e1404 = phi_6363_;
                            let _e1406 = phi_5654_;
                            let _e1408 = phi_5630_;
                            let _e1410 = phi_5600_;
                            phi_6362_ = _e1404;
                            phi_5653_ = _e1406;
                            phi_5629_ = _e1408;
                            phi_5599_ = _e1410;
                            let _e3345 = local_55;
                            phi_2192_ = _e3345;
                        } else {
                            phi_6362_ = _e649;
                            phi_5653_ = _e651;
                            phi_5629_ = _e653;
                            phi_5599_ = _e647;
                            phi_2192_ = false;
                        }
                        let _e1412 = phi_6362_;
                        let _e1414 = phi_5653_;
                        let _e1416 = phi_5629_;
                        let _e1418 = phi_5599_;
                        let _e1420 = phi_2192_;
                        local_50 = _e1418;
                        local_51 = _e1412;
                        local_52 = _e1414;
                        local_53 = _e1416;
                        local_15 = select(true, false, _e654);
                        local_16 = _e1418;
                        local_17 = _e1416;
                        local_18 = _e1414;
                        continue;
                        continuing {
                            phi_5364_ = _e1418;
                            phi_5361_ = _e1412;
                            phi_5358_ = _e1414;
                            phi_5355_ = _e1416;
                            break if !(_e1420);
                        }
                    }
                    let _e1424 = local_15;
                    let _e1426 = select(false, true, select(true, false, _e1424));
                    if _e1426 {
                        let _e1428 = local_16;
                        let _e1429 = f32(_e1428);
                        let _e1431 = local_17;
                        let _e1432 = f32(_e1431);
                        let _e1434 = local_18;
                        let _e1435 = f32(_e1434);
                        let _e1436 = vec3<f32>(_e1429, _e1432, _e1435);
                        if (_e618.member.member_4 == 2u) {
                            phi_2222_ = 2u;
                        } else {
                            phi_2222_ = (1u - _e618.member.member_4);
                        }
                        let _e1440 = phi_2222_;
                        if (_e1440 == 0u) {
                            phi_2234_ = vec3<f32>(_e1432, _e1435, _e1429);
                        } else {
                            if (_e1440 == 1u) {
                                phi_2233_ = vec3<f32>(_e1435, _e1429, _e1432);
                            } else {
                                phi_2233_ = _e1436;
                            }
                            let _e1445 = phi_2233_;
                            phi_2234_ = _e1445;
                        }
                        let _e1448 = phi_2234_;
                        let _e1454 = select(select(u32(_e1448.x), 0u, (_e1448.x < 0f)), 4294967295u, (_e1448.x > 4294967000f));
                        let _e1460 = select(select(u32(_e1448.y), 0u, (_e1448.y < 0f)), 4294967295u, (_e1448.y > 4294967000f));
                        let _e1466 = select(select(u32(_e1448.z), 0u, (_e1448.z < 0f)), 4294967295u, (_e1448.z > 4294967000f));
                        local_6.member = array<vec3<f32>, 10>((_e245 - _e1436), (_e252 - _e1436), (_e259 - _e1436), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        local_6.member_1 = 3u;
                        let _e1473 = local_6.member_1;
                        phi_2292_ = type_12(0u, _e1473);
                        phi_2295_ = 0f;
                        loop {
                            let _e1476 = phi_2292_;
                            let _e1478 = phi_2295_;
                            local_19 = _e1478;
                            if (_e1476.member < _e1476.member_1) {
                                phi_2293_ = type_12((_e1476.member + 1u), _e1476.member_1);
                                phi_2318_ = type_12(1u, _e1476.member);
                            } else {
                                phi_2293_ = _e1476;
                                phi_2318_ = type_12(0u, type_12().member_1);
                            }
                            let _e1491 = phi_2293_;
                            let _e1493 = phi_2318_;
                            let _e1497 = (bitcast<i32>(_e1493.member) != 0i);
                            if _e1497 {
                                if (_e1493.member_1 < 10u) {
                                } else {
                                    phi_5736_ = true;
                                    break;
                                }
                                let _e1501 = local_6.member[_e1493.member_1];
                                phi_2296_ = select(_e1501.x, _e1478, (_e1478 < _e1501.x));
                            } else {
                                phi_2296_ = f32();
                            }
                            let _e1506 = phi_2296_;
                            continue;
                            continuing {
                                phi_2292_ = _e1491;
                                phi_2295_ = _e1506;
                                phi_5736_ = _e637;
                                break if !(_e1497);
                            }
                        }
                        let _e1509 = phi_5736_;
                        phi_6039_ = _e1509;
                        if _e1509 {
                            break;
                        }
                        let _e1511 = local_19;
                        if (_e1511 >= 0f) {
                            phi_5958_ = _e1509;
                        } else {
                            let _e1513 = local_6.member_1;
                            if (_e1513 == 0u) {
                                phi_5959_ = _e1509;
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
                                let _e1525 = local_6.member_1;
                                let _e1526 = (_e1525 - 1u);
                                if (_e1526 < 10u) {
                                } else {
                                    phi_6039_ = true;
                                    break;
                                }
                                let _e1530 = local_6.member[_e1526];
                                let _e1532 = local_6.member_1;
                                phi_2396_ = type_12(0u, _e1532);
                                phi_2399_ = _e1530.x;
                                phi_2401_ = _e1530;
                                phi_2403_ = 0u;
                                loop {
                                    let _e1535 = phi_2396_;
                                    let _e1537 = phi_2399_;
                                    let _e1539 = phi_2401_;
                                    let _e1541 = phi_2403_;
                                    local_20 = _e1541;
                                    if (_e1535.member < _e1535.member_1) {
                                        phi_2397_ = type_12((_e1535.member + 1u), _e1535.member_1);
                                        phi_2426_ = type_12(1u, _e1535.member);
                                    } else {
                                        phi_2397_ = _e1535;
                                        phi_2426_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1554 = phi_2397_;
                                    let _e1556 = phi_2426_;
                                    let _e1560 = (bitcast<i32>(_e1556.member) != 0i);
                                    if _e1560 {
                                        if (_e1556.member_1 < 10u) {
                                        } else {
                                            phi_5946_ = true;
                                            break;
                                        }
                                        let _e1564 = local_6.member[_e1556.member_1];
                                        if ((_e1564.x < 0f) != (_e1537 < 0f)) {
                                            let _e1571 = (_e1541 < 10u);
                                            if _e1571 {
                                                let _e1579 = (_e1537 / (_e1537 - _e1564.x));
                                                if _e1571 {
                                                } else {
                                                    phi_5946_ = true;
                                                    break;
                                                }
                                                local_5[_e1541] = (_e1539 + vec3<f32>(((_e1564.x - _e1539.x) * _e1579), ((_e1564.y - _e1539.y) * _e1579), ((_e1564.z - _e1539.z) * _e1579)));
                                                phi_2486_ = (_e1541 + 1u);
                                            } else {
                                                phi_2486_ = _e1541;
                                            }
                                            let _e1588 = phi_2486_;
                                            phi_2487_ = _e1588;
                                        } else {
                                            phi_2487_ = _e1541;
                                        }
                                        let _e1590 = phi_2487_;
                                        if (_e1564.x >= 0f) {
                                            let _e1592 = (_e1590 < 10u);
                                            if _e1592 {
                                                if _e1592 {
                                                } else {
                                                    phi_5946_ = true;
                                                    break;
                                                }
                                                local_5[_e1590] = _e1564;
                                                phi_2503_ = (_e1590 + 1u);
                                            } else {
                                                phi_2503_ = _e1590;
                                            }
                                            let _e1596 = phi_2503_;
                                            phi_2504_ = _e1596;
                                        } else {
                                            phi_2504_ = _e1590;
                                        }
                                        let _e1598 = phi_2504_;
                                        phi_2400_ = _e1564.x;
                                        phi_2402_ = _e1564;
                                        phi_2404_ = _e1598;
                                    } else {
                                        phi_2400_ = f32();
                                        phi_2402_ = vec3<f32>();
                                        phi_2404_ = u32();
                                    }
                                    let _e1600 = phi_2400_;
                                    let _e1602 = phi_2402_;
                                    let _e1604 = phi_2404_;
                                    continue;
                                    continuing {
                                        phi_2396_ = _e1554;
                                        phi_2399_ = _e1600;
                                        phi_2401_ = _e1602;
                                        phi_2403_ = _e1604;
                                        phi_5946_ = _e1509;
                                        break if !(_e1560);
                                    }
                                }
                                let _e1607 = phi_5946_;
                                phi_6039_ = _e1607;
                                if _e1607 {
                                    break;
                                }
                                let _e1608 = local_5;
                                local_6.member = _e1608;
                                let _e1610 = local_20;
                                local_6.member_1 = _e1610;
                                phi_5959_ = _e1607;
                            }
                            let _e1612 = phi_5959_;
                            phi_5958_ = _e1612;
                        }
                        let _e1614 = phi_5958_;
                        let _e1615 = local_6.member_1;
                        phi_2517_ = type_12(0u, _e1615);
                        phi_2520_ = 0f;
                        loop {
                            let _e1618 = phi_2517_;
                            let _e1620 = phi_2520_;
                            local_21 = _e1620;
                            if (_e1618.member < _e1618.member_1) {
                                phi_2518_ = type_12((_e1618.member + 1u), _e1618.member_1);
                                phi_2543_ = type_12(1u, _e1618.member);
                            } else {
                                phi_2518_ = _e1618;
                                phi_2543_ = type_12(0u, type_12().member_1);
                            }
                            let _e1633 = phi_2518_;
                            let _e1635 = phi_2543_;
                            let _e1639 = (bitcast<i32>(_e1635.member) != 0i);
                            if _e1639 {
                                if (_e1635.member_1 < 10u) {
                                } else {
                                    phi_5954_ = true;
                                    break;
                                }
                                let _e1643 = local_6.member[_e1635.member_1];
                                let _e1646 = ((-1f * _e1643.x) + 1f);
                                phi_2521_ = select(_e1646, _e1620, (_e1620 < _e1646));
                            } else {
                                phi_2521_ = f32();
                            }
                            let _e1650 = phi_2521_;
                            continue;
                            continuing {
                                phi_2517_ = _e1633;
                                phi_2520_ = _e1650;
                                phi_5954_ = _e1614;
                                break if !(_e1639);
                            }
                        }
                        let _e1653 = phi_5954_;
                        phi_6039_ = _e1653;
                        if _e1653 {
                            break;
                        }
                        let _e1655 = local_21;
                        if (_e1655 >= 0f) {
                            phi_5973_ = _e1653;
                        } else {
                            let _e1657 = local_6.member_1;
                            if (_e1657 == 0u) {
                                phi_5974_ = _e1653;
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
                                let _e1669 = local_6.member_1;
                                let _e1670 = (_e1669 - 1u);
                                if (_e1670 < 10u) {
                                } else {
                                    phi_6039_ = true;
                                    break;
                                }
                                let _e1674 = local_6.member[_e1670];
                                let _e1678 = local_6.member_1;
                                phi_2615_ = type_12(0u, _e1678);
                                phi_2618_ = ((-1f * _e1674.x) + 1f);
                                phi_2620_ = _e1674;
                                phi_2622_ = 0u;
                                loop {
                                    let _e1681 = phi_2615_;
                                    let _e1683 = phi_2618_;
                                    let _e1685 = phi_2620_;
                                    let _e1687 = phi_2622_;
                                    local_22 = _e1687;
                                    if (_e1681.member < _e1681.member_1) {
                                        phi_2616_ = type_12((_e1681.member + 1u), _e1681.member_1);
                                        phi_2645_ = type_12(1u, _e1681.member);
                                    } else {
                                        phi_2616_ = _e1681;
                                        phi_2645_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1700 = phi_2616_;
                                    let _e1702 = phi_2645_;
                                    let _e1706 = (bitcast<i32>(_e1702.member) != 0i);
                                    if _e1706 {
                                        if (_e1702.member_1 < 10u) {
                                        } else {
                                            phi_5961_ = true;
                                            break;
                                        }
                                        let _e1710 = local_6.member[_e1702.member_1];
                                        let _e1715 = ((-1f * _e1710.x) + 1f);
                                        if ((_e1715 < 0f) != (_e1683 < 0f)) {
                                            let _e1719 = (_e1687 < 10u);
                                            if _e1719 {
                                                let _e1727 = (_e1683 / (_e1683 - _e1715));
                                                if _e1719 {
                                                } else {
                                                    phi_5961_ = true;
                                                    break;
                                                }
                                                local_4[_e1687] = (_e1685 + vec3<f32>(((_e1710.x - _e1685.x) * _e1727), ((_e1710.y - _e1685.y) * _e1727), ((_e1710.z - _e1685.z) * _e1727)));
                                                phi_2702_ = (_e1687 + 1u);
                                            } else {
                                                phi_2702_ = _e1687;
                                            }
                                            let _e1736 = phi_2702_;
                                            phi_2703_ = _e1736;
                                        } else {
                                            phi_2703_ = _e1687;
                                        }
                                        let _e1738 = phi_2703_;
                                        if (_e1715 >= 0f) {
                                            let _e1740 = (_e1738 < 10u);
                                            if _e1740 {
                                                if _e1740 {
                                                } else {
                                                    phi_5961_ = true;
                                                    break;
                                                }
                                                local_4[_e1738] = _e1710;
                                                phi_2719_ = (_e1738 + 1u);
                                            } else {
                                                phi_2719_ = _e1738;
                                            }
                                            let _e1744 = phi_2719_;
                                            phi_2720_ = _e1744;
                                        } else {
                                            phi_2720_ = _e1738;
                                        }
                                        let _e1746 = phi_2720_;
                                        phi_2619_ = _e1715;
                                        phi_2621_ = _e1710;
                                        phi_2623_ = _e1746;
                                    } else {
                                        phi_2619_ = f32();
                                        phi_2621_ = vec3<f32>();
                                        phi_2623_ = u32();
                                    }
                                    let _e1748 = phi_2619_;
                                    let _e1750 = phi_2621_;
                                    let _e1752 = phi_2623_;
                                    continue;
                                    continuing {
                                        phi_2615_ = _e1700;
                                        phi_2618_ = _e1748;
                                        phi_2620_ = _e1750;
                                        phi_2622_ = _e1752;
                                        phi_5961_ = _e1653;
                                        break if !(_e1706);
                                    }
                                }
                                let _e1755 = phi_5961_;
                                phi_6039_ = _e1755;
                                if _e1755 {
                                    break;
                                }
                                let _e1756 = local_4;
                                local_6.member = _e1756;
                                let _e1758 = local_22;
                                local_6.member_1 = _e1758;
                                phi_5974_ = _e1755;
                            }
                            let _e1760 = phi_5974_;
                            phi_5973_ = _e1760;
                        }
                        let _e1762 = phi_5973_;
                        let _e1763 = local_6.member_1;
                        phi_2727_ = type_12(0u, _e1763);
                        phi_2730_ = 0f;
                        loop {
                            let _e1766 = phi_2727_;
                            let _e1768 = phi_2730_;
                            local_23 = _e1768;
                            if (_e1766.member < _e1766.member_1) {
                                phi_2728_ = type_12((_e1766.member + 1u), _e1766.member_1);
                                phi_2753_ = type_12(1u, _e1766.member);
                            } else {
                                phi_2728_ = _e1766;
                                phi_2753_ = type_12(0u, type_12().member_1);
                            }
                            let _e1781 = phi_2728_;
                            let _e1783 = phi_2753_;
                            let _e1787 = (bitcast<i32>(_e1783.member) != 0i);
                            if _e1787 {
                                if (_e1783.member_1 < 10u) {
                                } else {
                                    phi_5969_ = true;
                                    break;
                                }
                                let _e1791 = local_6.member[_e1783.member_1];
                                phi_2731_ = select(_e1791.y, _e1768, (_e1768 < _e1791.y));
                            } else {
                                phi_2731_ = f32();
                            }
                            let _e1796 = phi_2731_;
                            continue;
                            continuing {
                                phi_2727_ = _e1781;
                                phi_2730_ = _e1796;
                                phi_5969_ = _e1762;
                                break if !(_e1787);
                            }
                        }
                        let _e1799 = phi_5969_;
                        phi_6039_ = _e1799;
                        if _e1799 {
                            break;
                        }
                        let _e1801 = local_23;
                        if (_e1801 >= 0f) {
                            phi_5988_ = _e1799;
                        } else {
                            let _e1803 = local_6.member_1;
                            if (_e1803 == 0u) {
                                phi_5989_ = _e1799;
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
                                let _e1815 = local_6.member_1;
                                let _e1816 = (_e1815 - 1u);
                                if (_e1816 < 10u) {
                                } else {
                                    phi_6039_ = true;
                                    break;
                                }
                                let _e1820 = local_6.member[_e1816];
                                let _e1822 = local_6.member_1;
                                phi_2831_ = type_12(0u, _e1822);
                                phi_2834_ = _e1820.y;
                                phi_2836_ = _e1820;
                                phi_2838_ = 0u;
                                loop {
                                    let _e1825 = phi_2831_;
                                    let _e1827 = phi_2834_;
                                    let _e1829 = phi_2836_;
                                    let _e1831 = phi_2838_;
                                    local_24 = _e1831;
                                    if (_e1825.member < _e1825.member_1) {
                                        phi_2832_ = type_12((_e1825.member + 1u), _e1825.member_1);
                                        phi_2861_ = type_12(1u, _e1825.member);
                                    } else {
                                        phi_2832_ = _e1825;
                                        phi_2861_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1844 = phi_2832_;
                                    let _e1846 = phi_2861_;
                                    let _e1850 = (bitcast<i32>(_e1846.member) != 0i);
                                    if _e1850 {
                                        if (_e1846.member_1 < 10u) {
                                        } else {
                                            phi_5976_ = true;
                                            break;
                                        }
                                        let _e1854 = local_6.member[_e1846.member_1];
                                        if ((_e1854.y < 0f) != (_e1827 < 0f)) {
                                            let _e1861 = (_e1831 < 10u);
                                            if _e1861 {
                                                let _e1869 = (_e1827 / (_e1827 - _e1854.y));
                                                if _e1861 {
                                                } else {
                                                    phi_5976_ = true;
                                                    break;
                                                }
                                                local_3[_e1831] = (_e1829 + vec3<f32>(((_e1854.x - _e1829.x) * _e1869), ((_e1854.y - _e1829.y) * _e1869), ((_e1854.z - _e1829.z) * _e1869)));
                                                phi_2921_ = (_e1831 + 1u);
                                            } else {
                                                phi_2921_ = _e1831;
                                            }
                                            let _e1878 = phi_2921_;
                                            phi_2922_ = _e1878;
                                        } else {
                                            phi_2922_ = _e1831;
                                        }
                                        let _e1880 = phi_2922_;
                                        if (_e1854.y >= 0f) {
                                            let _e1882 = (_e1880 < 10u);
                                            if _e1882 {
                                                if _e1882 {
                                                } else {
                                                    phi_5976_ = true;
                                                    break;
                                                }
                                                local_3[_e1880] = _e1854;
                                                phi_2938_ = (_e1880 + 1u);
                                            } else {
                                                phi_2938_ = _e1880;
                                            }
                                            let _e1886 = phi_2938_;
                                            phi_2939_ = _e1886;
                                        } else {
                                            phi_2939_ = _e1880;
                                        }
                                        let _e1888 = phi_2939_;
                                        phi_2835_ = _e1854.y;
                                        phi_2837_ = _e1854;
                                        phi_2839_ = _e1888;
                                    } else {
                                        phi_2835_ = f32();
                                        phi_2837_ = vec3<f32>();
                                        phi_2839_ = u32();
                                    }
                                    let _e1890 = phi_2835_;
                                    let _e1892 = phi_2837_;
                                    let _e1894 = phi_2839_;
                                    continue;
                                    continuing {
                                        phi_2831_ = _e1844;
                                        phi_2834_ = _e1890;
                                        phi_2836_ = _e1892;
                                        phi_2838_ = _e1894;
                                        phi_5976_ = _e1799;
                                        break if !(_e1850);
                                    }
                                }
                                let _e1897 = phi_5976_;
                                phi_6039_ = _e1897;
                                if _e1897 {
                                    break;
                                }
                                let _e1898 = local_3;
                                local_6.member = _e1898;
                                let _e1900 = local_24;
                                local_6.member_1 = _e1900;
                                phi_5989_ = _e1897;
                            }
                            let _e1902 = phi_5989_;
                            phi_5988_ = _e1902;
                        }
                        let _e1904 = phi_5988_;
                        let _e1905 = local_6.member_1;
                        phi_2952_ = type_12(0u, _e1905);
                        phi_2955_ = 0f;
                        loop {
                            let _e1908 = phi_2952_;
                            let _e1910 = phi_2955_;
                            local_25 = _e1910;
                            if (_e1908.member < _e1908.member_1) {
                                phi_2953_ = type_12((_e1908.member + 1u), _e1908.member_1);
                                phi_2978_ = type_12(1u, _e1908.member);
                            } else {
                                phi_2953_ = _e1908;
                                phi_2978_ = type_12(0u, type_12().member_1);
                            }
                            let _e1923 = phi_2953_;
                            let _e1925 = phi_2978_;
                            let _e1929 = (bitcast<i32>(_e1925.member) != 0i);
                            if _e1929 {
                                if (_e1925.member_1 < 10u) {
                                } else {
                                    phi_5984_ = true;
                                    break;
                                }
                                let _e1933 = local_6.member[_e1925.member_1];
                                let _e1936 = ((-1f * _e1933.y) + 1f);
                                phi_2956_ = select(_e1936, _e1910, (_e1910 < _e1936));
                            } else {
                                phi_2956_ = f32();
                            }
                            let _e1940 = phi_2956_;
                            continue;
                            continuing {
                                phi_2952_ = _e1923;
                                phi_2955_ = _e1940;
                                phi_5984_ = _e1904;
                                break if !(_e1929);
                            }
                        }
                        let _e1943 = phi_5984_;
                        phi_6039_ = _e1943;
                        if _e1943 {
                            break;
                        }
                        let _e1945 = local_25;
                        if (_e1945 >= 0f) {
                            phi_6003_ = _e1943;
                        } else {
                            let _e1947 = local_6.member_1;
                            if (_e1947 == 0u) {
                                phi_6004_ = _e1943;
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
                                let _e1959 = local_6.member_1;
                                let _e1960 = (_e1959 - 1u);
                                if (_e1960 < 10u) {
                                } else {
                                    phi_6039_ = true;
                                    break;
                                }
                                let _e1964 = local_6.member[_e1960];
                                let _e1968 = local_6.member_1;
                                phi_3050_ = type_12(0u, _e1968);
                                phi_3053_ = ((-1f * _e1964.y) + 1f);
                                phi_3055_ = _e1964;
                                phi_3057_ = 0u;
                                loop {
                                    let _e1971 = phi_3050_;
                                    let _e1973 = phi_3053_;
                                    let _e1975 = phi_3055_;
                                    let _e1977 = phi_3057_;
                                    local_26 = _e1977;
                                    if (_e1971.member < _e1971.member_1) {
                                        phi_3051_ = type_12((_e1971.member + 1u), _e1971.member_1);
                                        phi_3080_ = type_12(1u, _e1971.member);
                                    } else {
                                        phi_3051_ = _e1971;
                                        phi_3080_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1990 = phi_3051_;
                                    let _e1992 = phi_3080_;
                                    let _e1996 = (bitcast<i32>(_e1992.member) != 0i);
                                    if _e1996 {
                                        if (_e1992.member_1 < 10u) {
                                        } else {
                                            phi_5991_ = true;
                                            break;
                                        }
                                        let _e2000 = local_6.member[_e1992.member_1];
                                        let _e2005 = ((-1f * _e2000.y) + 1f);
                                        if ((_e2005 < 0f) != (_e1973 < 0f)) {
                                            let _e2009 = (_e1977 < 10u);
                                            if _e2009 {
                                                let _e2017 = (_e1973 / (_e1973 - _e2005));
                                                if _e2009 {
                                                } else {
                                                    phi_5991_ = true;
                                                    break;
                                                }
                                                local_2[_e1977] = (_e1975 + vec3<f32>(((_e2000.x - _e1975.x) * _e2017), ((_e2000.y - _e1975.y) * _e2017), ((_e2000.z - _e1975.z) * _e2017)));
                                                phi_3137_ = (_e1977 + 1u);
                                            } else {
                                                phi_3137_ = _e1977;
                                            }
                                            let _e2026 = phi_3137_;
                                            phi_3138_ = _e2026;
                                        } else {
                                            phi_3138_ = _e1977;
                                        }
                                        let _e2028 = phi_3138_;
                                        if (_e2005 >= 0f) {
                                            let _e2030 = (_e2028 < 10u);
                                            if _e2030 {
                                                if _e2030 {
                                                } else {
                                                    phi_5991_ = true;
                                                    break;
                                                }
                                                local_2[_e2028] = _e2000;
                                                phi_3154_ = (_e2028 + 1u);
                                            } else {
                                                phi_3154_ = _e2028;
                                            }
                                            let _e2034 = phi_3154_;
                                            phi_3155_ = _e2034;
                                        } else {
                                            phi_3155_ = _e2028;
                                        }
                                        let _e2036 = phi_3155_;
                                        phi_3054_ = _e2005;
                                        phi_3056_ = _e2000;
                                        phi_3058_ = _e2036;
                                    } else {
                                        phi_3054_ = f32();
                                        phi_3056_ = vec3<f32>();
                                        phi_3058_ = u32();
                                    }
                                    let _e2038 = phi_3054_;
                                    let _e2040 = phi_3056_;
                                    let _e2042 = phi_3058_;
                                    continue;
                                    continuing {
                                        phi_3050_ = _e1990;
                                        phi_3053_ = _e2038;
                                        phi_3055_ = _e2040;
                                        phi_3057_ = _e2042;
                                        phi_5991_ = _e1943;
                                        break if !(_e1996);
                                    }
                                }
                                let _e2045 = phi_5991_;
                                phi_6039_ = _e2045;
                                if _e2045 {
                                    break;
                                }
                                let _e2046 = local_2;
                                local_6.member = _e2046;
                                let _e2048 = local_26;
                                local_6.member_1 = _e2048;
                                phi_6004_ = _e2045;
                            }
                            let _e2050 = phi_6004_;
                            phi_6003_ = _e2050;
                        }
                        let _e2052 = phi_6003_;
                        let _e2053 = local_6.member_1;
                        phi_3162_ = type_12(0u, _e2053);
                        phi_3165_ = 0f;
                        loop {
                            let _e2056 = phi_3162_;
                            let _e2058 = phi_3165_;
                            local_27 = _e2058;
                            if (_e2056.member < _e2056.member_1) {
                                phi_3163_ = type_12((_e2056.member + 1u), _e2056.member_1);
                                phi_3188_ = type_12(1u, _e2056.member);
                            } else {
                                phi_3163_ = _e2056;
                                phi_3188_ = type_12(0u, type_12().member_1);
                            }
                            let _e2071 = phi_3163_;
                            let _e2073 = phi_3188_;
                            let _e2077 = (bitcast<i32>(_e2073.member) != 0i);
                            if _e2077 {
                                if (_e2073.member_1 < 10u) {
                                } else {
                                    phi_5999_ = true;
                                    break;
                                }
                                let _e2081 = local_6.member[_e2073.member_1];
                                phi_3166_ = select(_e2081.z, _e2058, (_e2058 < _e2081.z));
                            } else {
                                phi_3166_ = f32();
                            }
                            let _e2086 = phi_3166_;
                            continue;
                            continuing {
                                phi_3162_ = _e2071;
                                phi_3165_ = _e2086;
                                phi_5999_ = _e2052;
                                break if !(_e2077);
                            }
                        }
                        let _e2089 = phi_5999_;
                        phi_6039_ = _e2089;
                        if _e2089 {
                            break;
                        }
                        let _e2091 = local_27;
                        if (_e2091 >= 0f) {
                            phi_6018_ = _e2089;
                        } else {
                            let _e2093 = local_6.member_1;
                            if (_e2093 == 0u) {
                                phi_6019_ = _e2089;
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
                                let _e2105 = local_6.member_1;
                                let _e2106 = (_e2105 - 1u);
                                if (_e2106 < 10u) {
                                } else {
                                    phi_6039_ = true;
                                    break;
                                }
                                let _e2110 = local_6.member[_e2106];
                                let _e2112 = local_6.member_1;
                                phi_3266_ = type_12(0u, _e2112);
                                phi_3269_ = _e2110.z;
                                phi_3271_ = _e2110;
                                phi_3273_ = 0u;
                                loop {
                                    let _e2115 = phi_3266_;
                                    let _e2117 = phi_3269_;
                                    let _e2119 = phi_3271_;
                                    let _e2121 = phi_3273_;
                                    local_28 = _e2121;
                                    if (_e2115.member < _e2115.member_1) {
                                        phi_3267_ = type_12((_e2115.member + 1u), _e2115.member_1);
                                        phi_3296_ = type_12(1u, _e2115.member);
                                    } else {
                                        phi_3267_ = _e2115;
                                        phi_3296_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2134 = phi_3267_;
                                    let _e2136 = phi_3296_;
                                    let _e2140 = (bitcast<i32>(_e2136.member) != 0i);
                                    if _e2140 {
                                        if (_e2136.member_1 < 10u) {
                                        } else {
                                            phi_6006_ = true;
                                            break;
                                        }
                                        let _e2144 = local_6.member[_e2136.member_1];
                                        if ((_e2144.z < 0f) != (_e2117 < 0f)) {
                                            let _e2151 = (_e2121 < 10u);
                                            if _e2151 {
                                                let _e2159 = (_e2117 / (_e2117 - _e2144.z));
                                                if _e2151 {
                                                } else {
                                                    phi_6006_ = true;
                                                    break;
                                                }
                                                local_1[_e2121] = (_e2119 + vec3<f32>(((_e2144.x - _e2119.x) * _e2159), ((_e2144.y - _e2119.y) * _e2159), ((_e2144.z - _e2119.z) * _e2159)));
                                                phi_3356_ = (_e2121 + 1u);
                                            } else {
                                                phi_3356_ = _e2121;
                                            }
                                            let _e2168 = phi_3356_;
                                            phi_3357_ = _e2168;
                                        } else {
                                            phi_3357_ = _e2121;
                                        }
                                        let _e2170 = phi_3357_;
                                        if (_e2144.z >= 0f) {
                                            let _e2172 = (_e2170 < 10u);
                                            if _e2172 {
                                                if _e2172 {
                                                } else {
                                                    phi_6006_ = true;
                                                    break;
                                                }
                                                local_1[_e2170] = _e2144;
                                                phi_3373_ = (_e2170 + 1u);
                                            } else {
                                                phi_3373_ = _e2170;
                                            }
                                            let _e2176 = phi_3373_;
                                            phi_3374_ = _e2176;
                                        } else {
                                            phi_3374_ = _e2170;
                                        }
                                        let _e2178 = phi_3374_;
                                        phi_3270_ = _e2144.z;
                                        phi_3272_ = _e2144;
                                        phi_3274_ = _e2178;
                                    } else {
                                        phi_3270_ = f32();
                                        phi_3272_ = vec3<f32>();
                                        phi_3274_ = u32();
                                    }
                                    let _e2180 = phi_3270_;
                                    let _e2182 = phi_3272_;
                                    let _e2184 = phi_3274_;
                                    continue;
                                    continuing {
                                        phi_3266_ = _e2134;
                                        phi_3269_ = _e2180;
                                        phi_3271_ = _e2182;
                                        phi_3273_ = _e2184;
                                        phi_6006_ = _e2089;
                                        break if !(_e2140);
                                    }
                                }
                                let _e2187 = phi_6006_;
                                phi_6039_ = _e2187;
                                if _e2187 {
                                    break;
                                }
                                let _e2188 = local_1;
                                local_6.member = _e2188;
                                let _e2190 = local_28;
                                local_6.member_1 = _e2190;
                                phi_6019_ = _e2187;
                            }
                            let _e2192 = phi_6019_;
                            phi_6018_ = _e2192;
                        }
                        let _e2194 = phi_6018_;
                        let _e2195 = local_6.member_1;
                        phi_3387_ = type_12(0u, _e2195);
                        phi_3390_ = 0f;
                        loop {
                            let _e2198 = phi_3387_;
                            let _e2200 = phi_3390_;
                            local_29 = _e2200;
                            if (_e2198.member < _e2198.member_1) {
                                phi_3388_ = type_12((_e2198.member + 1u), _e2198.member_1);
                                phi_3413_ = type_12(1u, _e2198.member);
                            } else {
                                phi_3388_ = _e2198;
                                phi_3413_ = type_12(0u, type_12().member_1);
                            }
                            let _e2213 = phi_3388_;
                            let _e2215 = phi_3413_;
                            let _e2219 = (bitcast<i32>(_e2215.member) != 0i);
                            if _e2219 {
                                if (_e2215.member_1 < 10u) {
                                } else {
                                    phi_6014_ = true;
                                    break;
                                }
                                let _e2223 = local_6.member[_e2215.member_1];
                                let _e2226 = ((-1f * _e2223.z) + 1f);
                                phi_3391_ = select(_e2226, _e2200, (_e2200 < _e2226));
                            } else {
                                phi_3391_ = f32();
                            }
                            let _e2230 = phi_3391_;
                            continue;
                            continuing {
                                phi_3387_ = _e2213;
                                phi_3390_ = _e2230;
                                phi_6014_ = _e2194;
                                break if !(_e2219);
                            }
                        }
                        let _e2233 = phi_6014_;
                        phi_6039_ = _e2233;
                        if _e2233 {
                            break;
                        }
                        let _e2235 = local_29;
                        if (_e2235 >= 0f) {
                            phi_6033_ = _e2233;
                        } else {
                            let _e2237 = local_6.member_1;
                            if (_e2237 == 0u) {
                                phi_6034_ = _e2233;
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
                                let _e2249 = local_6.member_1;
                                let _e2250 = (_e2249 - 1u);
                                if (_e2250 < 10u) {
                                } else {
                                    phi_6039_ = true;
                                    break;
                                }
                                let _e2254 = local_6.member[_e2250];
                                let _e2258 = local_6.member_1;
                                phi_3485_ = type_12(0u, _e2258);
                                phi_3488_ = ((-1f * _e2254.z) + 1f);
                                phi_3490_ = _e2254;
                                phi_3492_ = 0u;
                                loop {
                                    let _e2261 = phi_3485_;
                                    let _e2263 = phi_3488_;
                                    let _e2265 = phi_3490_;
                                    let _e2267 = phi_3492_;
                                    local_30 = _e2267;
                                    if (_e2261.member < _e2261.member_1) {
                                        phi_3486_ = type_12((_e2261.member + 1u), _e2261.member_1);
                                        phi_3515_ = type_12(1u, _e2261.member);
                                    } else {
                                        phi_3486_ = _e2261;
                                        phi_3515_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2280 = phi_3486_;
                                    let _e2282 = phi_3515_;
                                    let _e2286 = (bitcast<i32>(_e2282.member) != 0i);
                                    if _e2286 {
                                        if (_e2282.member_1 < 10u) {
                                        } else {
                                            phi_6021_ = true;
                                            break;
                                        }
                                        let _e2290 = local_6.member[_e2282.member_1];
                                        let _e2295 = ((-1f * _e2290.z) + 1f);
                                        if ((_e2295 < 0f) != (_e2263 < 0f)) {
                                            let _e2299 = (_e2267 < 10u);
                                            if _e2299 {
                                                let _e2307 = (_e2263 / (_e2263 - _e2295));
                                                if _e2299 {
                                                } else {
                                                    phi_6021_ = true;
                                                    break;
                                                }
                                                local[_e2267] = (_e2265 + vec3<f32>(((_e2290.x - _e2265.x) * _e2307), ((_e2290.y - _e2265.y) * _e2307), ((_e2290.z - _e2265.z) * _e2307)));
                                                phi_3572_ = (_e2267 + 1u);
                                            } else {
                                                phi_3572_ = _e2267;
                                            }
                                            let _e2316 = phi_3572_;
                                            phi_3573_ = _e2316;
                                        } else {
                                            phi_3573_ = _e2267;
                                        }
                                        let _e2318 = phi_3573_;
                                        if (_e2295 >= 0f) {
                                            let _e2320 = (_e2318 < 10u);
                                            if _e2320 {
                                                if _e2320 {
                                                } else {
                                                    phi_6021_ = true;
                                                    break;
                                                }
                                                local[_e2318] = _e2290;
                                                phi_3589_ = (_e2318 + 1u);
                                            } else {
                                                phi_3589_ = _e2318;
                                            }
                                            let _e2324 = phi_3589_;
                                            phi_3590_ = _e2324;
                                        } else {
                                            phi_3590_ = _e2318;
                                        }
                                        let _e2326 = phi_3590_;
                                        phi_3489_ = _e2295;
                                        phi_3491_ = _e2290;
                                        phi_3493_ = _e2326;
                                    } else {
                                        phi_3489_ = f32();
                                        phi_3491_ = vec3<f32>();
                                        phi_3493_ = u32();
                                    }
                                    let _e2328 = phi_3489_;
                                    let _e2330 = phi_3491_;
                                    let _e2332 = phi_3493_;
                                    continue;
                                    continuing {
                                        phi_3485_ = _e2280;
                                        phi_3488_ = _e2328;
                                        phi_3490_ = _e2330;
                                        phi_3492_ = _e2332;
                                        phi_6021_ = _e2233;
                                        break if !(_e2286);
                                    }
                                }
                                let _e2335 = phi_6021_;
                                phi_6039_ = _e2335;
                                if _e2335 {
                                    break;
                                }
                                let _e2336 = local;
                                local_6.member = _e2336;
                                let _e2338 = local_30;
                                local_6.member_1 = _e2338;
                                phi_6034_ = _e2335;
                            }
                            let _e2340 = phi_6034_;
                            phi_6033_ = _e2340;
                        }
                        let _e2342 = phi_6033_;
                        let _e2345 = local_6.member[0u];
                        let _e2349 = local_6.member_1;
                        phi_3602_ = type_12(1u, _e2349);
                        phi_3605_ = vec3<f32>(0f, 0f, 0f);
                        phi_3607_ = _e2345.z;
                        phi_3609_ = _e2345.y;
                        phi_3611_ = _e2345.x;
                        phi_3613_ = 0f;
                        loop {
                            let _e2352 = phi_3602_;
                            let _e2354 = phi_3605_;
                            let _e2356 = phi_3607_;
                            let _e2358 = phi_3609_;
                            let _e2360 = phi_3611_;
                            let _e2362 = phi_3613_;
                            local_31 = _e2360;
                            local_32 = _e2358;
                            local_33 = _e2356;
                            local_34 = _e2362;
                            local_35 = _e2354;
                            local_36 = _e2362;
                            local_37 = _e2354;
                            local_38 = _e2362;
                            local_39 = _e2354;
                            local_40 = _e2362;
                            local_41 = _e2362;
                            if (_e2352.member < _e2352.member_1) {
                                phi_3603_ = type_12((_e2352.member + 1u), _e2352.member_1);
                                phi_3636_ = type_12(1u, _e2352.member);
                            } else {
                                phi_3603_ = _e2352;
                                phi_3636_ = type_12(0u, type_12().member_1);
                            }
                            let _e2375 = phi_3603_;
                            let _e2377 = phi_3636_;
                            let _e2381 = (bitcast<i32>(_e2377.member) != 0i);
                            if _e2381 {
                                if (_e2377.member_1 < 10u) {
                                } else {
                                    phi_6029_ = true;
                                    break;
                                }
                                let _e2385 = local_6.member[_e2377.member_1];
                                let _e2395 = (_e2377.member_1 + 1u);
                                let _e2396 = local_6.member_1;
                                if (_e2395 < _e2396) {
                                    if (_e2395 < 10u) {
                                    } else {
                                        phi_6029_ = true;
                                        break;
                                    }
                                    let _e2401 = local_6.member[_e2395];
                                    let _e2402 = (_e2385.x - _e2345.x);
                                    let _e2403 = (_e2385.y - _e2345.y);
                                    let _e2404 = (_e2385.z - _e2345.z);
                                    let _e2406 = (_e2401.x - _e2345.x);
                                    let _e2408 = (_e2401.y - _e2345.y);
                                    let _e2410 = (_e2401.z - _e2345.z);
                                    let _e2413 = ((_e2403 * _e2410) - (_e2408 * _e2404));
                                    let _e2416 = ((_e2404 * _e2406) - (_e2410 * _e2402));
                                    let _e2419 = ((_e2402 * _e2408) - (_e2406 * _e2403));
                                    let _e2425 = sqrt((((_e2413 * _e2413) + (_e2416 * _e2416)) + (_e2419 * _e2419)));
                                    let _e2437 = (_e2425 * 0.16666667f);
                                    phi_3750_ = vec3<f32>((_e2354.x + (((_e2385.x + _e2401.x) - (_e2345.x * 2f)) * _e2437)), (_e2354.y + (((_e2385.y + _e2401.y) - (_e2345.y * 2f)) * _e2437)), (_e2354.z + (((_e2385.z + _e2401.z) - (_e2345.z * 2f)) * _e2437)));
                                    phi_3751_ = (_e2362 + (0.5f * _e2425));
                                } else {
                                    phi_3750_ = _e2354;
                                    phi_3751_ = _e2362;
                                }
                                let _e2449 = phi_3750_;
                                let _e2451 = phi_3751_;
                                phi_3606_ = _e2449;
                                phi_3608_ = select(_e2385.z, _e2356, (_e2356 < _e2385.z));
                                phi_3610_ = select(_e2385.y, _e2358, (_e2358 < _e2385.y));
                                phi_3612_ = select(_e2385.x, _e2360, (_e2360 < _e2385.x));
                                phi_3614_ = _e2451;
                            } else {
                                phi_3606_ = vec3<f32>();
                                phi_3608_ = f32();
                                phi_3610_ = f32();
                                phi_3612_ = f32();
                                phi_3614_ = f32();
                            }
                            let _e2453 = phi_3606_;
                            let _e2455 = phi_3608_;
                            let _e2457 = phi_3610_;
                            let _e2459 = phi_3612_;
                            let _e2461 = phi_3614_;
                            continue;
                            continuing {
                                phi_3602_ = _e2375;
                                phi_3605_ = _e2453;
                                phi_3607_ = _e2455;
                                phi_3609_ = _e2457;
                                phi_3611_ = _e2459;
                                phi_3613_ = _e2461;
                                phi_6029_ = _e2342;
                                break if !(_e2381);
                            }
                        }
                        let _e2464 = phi_6029_;
                        phi_6039_ = _e2464;
                        if _e2464 {
                            break;
                        }
                        let _e2465 = local_6.member_1;
                        if (_e2465 == 0u) {
                            phi_3770_ = bool();
                            phi_3771_ = true;
                        } else {
                            let _e2468 = local_31;
                            if (_e2468 >= 1f) {
                                phi_3768_ = bool();
                                phi_3769_ = true;
                            } else {
                                let _e2471 = local_32;
                                let _e2472 = (_e2471 >= 1f);
                                if _e2472 {
                                    phi_3767_ = bool();
                                } else {
                                    let _e2474 = local_33;
                                    phi_3767_ = (_e2474 >= 1f);
                                }
                                let _e2477 = phi_3767_;
                                phi_3768_ = _e2477;
                                phi_3769_ = _e2472;
                            }
                            let _e2479 = phi_3768_;
                            let _e2481 = phi_3769_;
                            phi_3770_ = _e2479;
                            phi_3771_ = _e2481;
                        }
                        let _e2483 = phi_3770_;
                        let _e2485 = phi_3771_;
                        let _e2488 = local_34;
                        if (_e2488 > 0f) {
                            let _e2491 = local_35;
                            let _e2494 = local_36;
                            let _e2497 = local_37;
                            let _e2500 = local_38;
                            let _e2503 = local_39;
                            let _e2506 = local_40;
                            phi_3788_ = (_e2345 + vec3<f32>((_e2491.x / _e2494), (_e2497.y / _e2500), (_e2503.z / _e2506)));
                        } else {
                            phi_3788_ = _e2345;
                        }
                        let _e2511 = phi_3788_;
                        let _e2513 = local_41;
                        let _e2517 = select(0f, _e2511.x, (_e2511.x > 0f));
                        let _e2519 = select(1f, _e2517, (_e2517 < 1f));
                        let _e2522 = select(0f, _e2511.y, (_e2511.y > 0f));
                        let _e2524 = select(1f, _e2522, (_e2522 < 1f));
                        let _e2527 = select(0f, _e2511.z, (_e2511.z > 0f));
                        let _e2529 = select(1f, _e2527, (_e2527 < 1f));
                        let _e2534 = local_42;
                        if (_e2534 < arrayLength((&attributes.member))) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e2536 = ((_e2519 + _e1429) - _e245.x);
                        let _e2537 = ((_e2524 + _e1432) - _e245.y);
                        let _e2540 = ((_e494 * _e503) - (_e495 * _e502));
                        if (abs(_e2540) > 0f) {
                            phi_3860_ = (1f / _e2540);
                        } else {
                            phi_3860_ = 0f;
                        }
                        let _e2545 = phi_3860_;
                        let _e2549 = (((_e2536 * _e503) - (_e2537 * _e502)) * _e2545);
                        let _e2551 = select(0f, _e2549, (_e2549 > 0f));
                        let _e2553 = select(1f, _e2551, (_e2551 < 1f));
                        let _e2557 = (((_e494 * _e2537) - (_e495 * _e2536)) * _e2545);
                        let _e2559 = select(0f, _e2557, (_e2557 > 0f));
                        let _e2561 = select(1f, _e2559, (_e2559 < 1f));
                        let _e2563 = ((1f - _e2553) - _e2561);
                        let _e2566 = local_43;
                        let _e2570 = attributes.member[_e2566].member[0u];
                        let _e2574 = local_44;
                        let _e2578 = attributes.member[_e2574].member[2u];
                        let _e2583 = local_45;
                        let _e2587 = attributes.member[_e2583].member[4u];
                        let _e2589 = (((_e2570 * _e2563) + (_e2578 * _e2553)) + (_e2587 * _e2561));
                        let _e2592 = local_46;
                        let _e2596 = attributes.member[_e2592].member[1u];
                        let _e2600 = local_47;
                        let _e2604 = attributes.member[_e2600].member[3u];
                        let _e2609 = local_48;
                        let _e2613 = attributes.member[_e2609].member[5u];
                        let _e2615 = (((_e2596 * _e2563) + (_e2604 * _e2553)) + (_e2613 * _e2561));
                        if (_e391 == 4294967295u) {
                            phi_4209_ = type_30(vec3<f32>(_e374, _e380, _e386), _e420);
                        } else {
                            let _e2618 = (_e414 & 65535u);
                            let _e2620 = (_e414 >> bitcast<u32>(16i));
                            let _e2622 = (_e2589 - floor(_e2589));
                            let _e2627 = ((select(0f, _e2622, (_e2622 <= 1f)) * f32(_e2618)) - 0.5f);
                            let _e2628 = floor(_e2627);
                            let _e2629 = (_e2627 - _e2628);
                            let _e2630 = (_e2618 - 1u);
                            if (_e2628 < 0f) {
                                phi_3950_ = _e2630;
                            } else {
                                let _e2636 = select(select(u32(_e2628), 0u, (_e2628 < 0f)), 4294967295u, (_e2628 > 4294967000f));
                                phi_3950_ = select(_e2636, _e2630, (_e2630 < _e2636));
                            }
                            let _e2640 = phi_3950_;
                            if (_e2640 == _e2630) {
                                phi_3956_ = 0u;
                            } else {
                                phi_3956_ = (_e2640 + 1u);
                            }
                            let _e2644 = phi_3956_;
                            let _e2646 = (_e2615 - floor(_e2615));
                            let _e2651 = ((select(0f, _e2646, (_e2646 <= 1f)) * f32(_e2620)) - 0.5f);
                            let _e2652 = floor(_e2651);
                            let _e2653 = (_e2651 - _e2652);
                            let _e2654 = (_e2620 - 1u);
                            if (_e2652 < 0f) {
                                phi_3986_ = _e2654;
                            } else {
                                let _e2660 = select(select(u32(_e2652), 0u, (_e2652 < 0f)), 4294967295u, (_e2652 > 4294967000f));
                                phi_3986_ = select(_e2660, _e2654, (_e2654 < _e2660));
                            }
                            let _e2664 = phi_3986_;
                            if (_e2664 == _e2654) {
                                phi_3992_ = 0u;
                            } else {
                                phi_3992_ = (_e2664 + 1u);
                            }
                            let _e2668 = phi_3992_;
                            let _e2670 = (_e391 + (_e2664 * _e2618));
                            let _e2672 = (_e391 + (_e2668 * _e2618));
                            let _e2673 = (_e2670 + _e2640);
                            let _e2674 = (_e2670 + _e2644);
                            let _e2675 = (_e2672 + _e2640);
                            let _e2676 = (_e2672 + _e2644);
                            if (_e2673 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2680 = surfaces.member[_e2673];
                            if (_e2674 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2684 = surfaces.member[_e2674];
                            if (_e2675 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2688 = surfaces.member[_e2675];
                            if (_e2676 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2692 = surfaces.member[_e2676];
                            let _e2693 = (_e2680 & 255u);
                            if (_e2693 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2697 = surfaces.member[_e2693];
                            let _e2701 = ((_e2680 >> bitcast<u32>(8i)) & 255u);
                            if (_e2701 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2705 = surfaces.member[_e2701];
                            let _e2709 = ((_e2680 >> bitcast<u32>(16i)) & 255u);
                            if (_e2709 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2713 = surfaces.member[_e2709];
                            let _e2715 = (1f - _e2629);
                            let _e2719 = (_e2684 & 255u);
                            if (_e2719 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2723 = surfaces.member[_e2719];
                            let _e2727 = ((_e2684 >> bitcast<u32>(8i)) & 255u);
                            if (_e2727 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2731 = surfaces.member[_e2727];
                            let _e2735 = ((_e2684 >> bitcast<u32>(16i)) & 255u);
                            if (_e2735 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2739 = surfaces.member[_e2735];
                            let _e2747 = (_e2688 & 255u);
                            if (_e2747 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2751 = surfaces.member[_e2747];
                            let _e2755 = ((_e2688 >> bitcast<u32>(8i)) & 255u);
                            if (_e2755 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2759 = surfaces.member[_e2755];
                            let _e2763 = ((_e2688 >> bitcast<u32>(16i)) & 255u);
                            if (_e2763 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2767 = surfaces.member[_e2763];
                            let _e2772 = (_e2692 & 255u);
                            if (_e2772 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2776 = surfaces.member[_e2772];
                            let _e2780 = ((_e2692 >> bitcast<u32>(8i)) & 255u);
                            if (_e2780 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2784 = surfaces.member[_e2780];
                            let _e2788 = ((_e2692 >> bitcast<u32>(16i)) & 255u);
                            if (_e2788 < _e98) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2792 = surfaces.member[_e2788];
                            let _e2800 = (1f - _e2653);
                            phi_4209_ = type_30(vec3<f32>((_e374 * ((((bitcast<f32>(_e2697) * _e2715) + (bitcast<f32>(_e2723) * _e2629)) * _e2800) + (((bitcast<f32>(_e2751) * _e2715) + (bitcast<f32>(_e2776) * _e2629)) * _e2653))), (_e380 * ((((bitcast<f32>(_e2705) * _e2715) + (bitcast<f32>(_e2731) * _e2629)) * _e2800) + (((bitcast<f32>(_e2759) * _e2715) + (bitcast<f32>(_e2784) * _e2629)) * _e2653))), (_e386 * ((((bitcast<f32>(_e2713) * _e2715) + (bitcast<f32>(_e2739) * _e2629)) * _e2800) + (((bitcast<f32>(_e2767) * _e2715) + (bitcast<f32>(_e2792) * _e2629)) * _e2653)))), (_e420 * (((((f32((_e2680 >> bitcast<u32>(24i))) * 0.003921569f) * _e2715) + ((f32((_e2684 >> bitcast<u32>(24i))) * 0.003921569f) * _e2629)) * _e2800) + ((((f32((_e2688 >> bitcast<u32>(24i))) * 0.003921569f) * _e2715) + ((f32((_e2692 >> bitcast<u32>(24i))) * 0.003921569f) * _e2629)) * _e2653))));
                        }
                        let _e2843 = phi_4209_;
                        if (_e220 == 2u) {
                            phi_4239_ = 2u;
                        } else {
                            phi_4239_ = (1u - _e220);
                        }
                        let _e2862 = phi_4239_;
                        if (_e2862 == 0u) {
                            phi_4251_ = vec3<f32>(_e2524, _e2529, _e2519);
                        } else {
                            if (_e2862 == 1u) {
                                phi_4250_ = vec3<f32>(_e2529, _e2519, _e2524);
                            } else {
                                phi_4250_ = vec3<f32>(_e2519, _e2524, _e2529);
                            }
                            let _e2867 = phi_4250_;
                            phi_4251_ = _e2867;
                        }
                        let _e2870 = phi_4251_;
                        let _e2874 = params.member.member_2[0u];
                        let _e2888 = (((_e2874.z + (_e1454 >> bitcast<u32>(2i))) + (_e2874.x * (_e1460 >> bitcast<u32>(2i)))) + (_e2874.y * (_e1466 >> bitcast<u32>(1i))));
                        let _e2911 = cells.member[((2u * _e2888) + 1u)];
                        phi_4286_ = type_12(0u, 6u);
                        phi_4289_ = _e2911;
                        loop {
                            let _e2913 = phi_4286_;
                            let _e2915 = phi_4289_;
                            local_49 = _e2915;
                            if (_e2913.member < _e2913.member_1) {
                                phi_4287_ = type_12((_e2913.member + 1u), _e2913.member_1);
                                phi_4312_ = type_12(1u, _e2913.member);
                            } else {
                                phi_4287_ = _e2913;
                                phi_4312_ = type_12(0u, type_12().member_1);
                            }
                            let _e2928 = phi_4287_;
                            let _e2930 = phi_4312_;
                            let _e2934 = (bitcast<i32>(_e2930.member) != 0i);
                            if _e2934 {
                                let _e2938 = facet_bits.member[((_e2888 * 6u) + _e2930.member_1)];
                                let _e2939 = ((((((_e1454 & 1u) | ((_e1460 & 1u) << bitcast<u32>(1i))) | ((_e1466 & 1u) << bitcast<u32>(2i))) | ((_e1454 & 2u) << bitcast<u32>(2i))) | ((_e1460 & 2u) << bitcast<u32>(3i))) & 31u);
                                let _e2945 = (_e2915 + countOneBits((_e2938 & ((1u << bitcast<u32>(_e2939)) - 1u))));
                                if (_e2930.member_1 < ((2u * _e338) + select(0u, 1u, (_e343 < 0f)))) {
                                    phi_4337_ = (_e2945 + ((_e2938 >> bitcast<u32>(_e2939)) & 1u));
                                } else {
                                    phi_4337_ = _e2945;
                                }
                                let _e2952 = phi_4337_;
                                phi_4290_ = _e2952;
                            } else {
                                phi_4290_ = u32();
                            }
                            let _e2954 = phi_4290_;
                            continue;
                            continuing {
                                phi_4286_ = _e2928;
                                phi_4289_ = _e2954;
                                break if !(_e2934);
                            }
                        }
                        let _e2958 = local_49;
                        let _e2959 = (_e2958 * 13u);
                        let _e2962 = params.member.member_7;
                        let _e2965 = floor((((select(_e2513, 0f, select(_e2483, true, _e2485)) * select(1f, 0f, (_e2843.member_1 < bitcast<f32>(_e425)))) * _e2962) + 0.5f));
                        let _e2967 = select(_e2965, 1f, (_e2965 < 1f));
                        let _e2972 = select(select(u32(_e2967), 0u, (_e2967 < 0f)), 4294967295u, (_e2967 > 4294967000f));
                        if (_e2959 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e2976 = atomicAdd((&sums.member[_e2959]), _e2972);
                        if (_e2976 >= (2147483648u - select(_e2972, 2147483648u, (2147483648u < _e2972)))) {
                            let _e2983 = params.member.member_5;
                            let _e2984 = (_e2983 * 13u);
                            if (_e2984 < _e102) {
                            } else {
                                phi_6039_ = true;
                                break;
                            }
                            let _e2988 = atomicOr((&sums.member[_e2984]), 1u);
                        }
                        let _e2989 = (_e2959 + 1u);
                        let _e2997 = floor(((_e361.x * _e2967) + 0.5f));
                        if (_e2989 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3009 = atomicAdd((&sums.member[_e2989]), bitcast<u32>(select(0i, select(select(i32(_e2997), i32(-2147483648), (_e2997 < -2147483600f)), 2147483647i, (_e2997 > 2147483500f)), (_e2997 == _e2997))));
                        let _e3010 = (_e2959 + 2u);
                        let _e3012 = floor(((_e361.y * _e2967) + 0.5f));
                        if (_e3010 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3024 = atomicAdd((&sums.member[_e3010]), bitcast<u32>(select(0i, select(select(i32(_e3012), i32(-2147483648), (_e3012 < -2147483600f)), 2147483647i, (_e3012 > 2147483500f)), (_e3012 == _e3012))));
                        let _e3025 = (_e2959 + 3u);
                        let _e3027 = floor(((_e361.z * _e2967) + 0.5f));
                        if (_e3025 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3039 = atomicAdd((&sums.member[_e3025]), bitcast<u32>(select(0i, select(select(i32(_e3027), i32(-2147483648), (_e3027 < -2147483600f)), 2147483647i, (_e3027 > 2147483500f)), (_e3027 == _e3027))));
                        let _e3040 = (_e2959 + 4u);
                        let _e3048 = floor(((_e2870.x * _e2967) + 0.5f));
                        if (_e3040 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3060 = atomicAdd((&sums.member[_e3040]), bitcast<u32>(select(0i, select(select(i32(_e3048), i32(-2147483648), (_e3048 < -2147483600f)), 2147483647i, (_e3048 > 2147483500f)), (_e3048 == _e3048))));
                        let _e3061 = (_e2959 + 5u);
                        let _e3063 = floor(((_e2870.y * _e2967) + 0.5f));
                        if (_e3061 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3075 = atomicAdd((&sums.member[_e3061]), bitcast<u32>(select(0i, select(select(i32(_e3063), i32(-2147483648), (_e3063 < -2147483600f)), 2147483647i, (_e3063 > 2147483500f)), (_e3063 == _e3063))));
                        let _e3076 = (_e2959 + 6u);
                        let _e3078 = floor(((_e2870.z * _e2967) + 0.5f));
                        if (_e3076 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3090 = atomicAdd((&sums.member[_e3076]), bitcast<u32>(select(0i, select(select(i32(_e3078), i32(-2147483648), (_e3078 < -2147483600f)), 2147483647i, (_e3078 > 2147483500f)), (_e3078 == _e3078))));
                        let _e3091 = (_e2959 + 7u);
                        let _e3096 = floor(((select(1f, _e2843.member.x, (_e2843.member.x < 1f)) * _e2967) + 0.5f));
                        if (_e3091 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3108 = atomicAdd((&sums.member[_e3091]), bitcast<u32>(select(0i, select(select(i32(_e3096), i32(-2147483648), (_e3096 < -2147483600f)), 2147483647i, (_e3096 > 2147483500f)), (_e3096 == _e3096))));
                        let _e3109 = (_e2959 + 8u);
                        let _e3111 = floor(((select(1f, _e2843.member.y, (_e2843.member.y < 1f)) * _e2967) + 0.5f));
                        if (_e3109 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3123 = atomicAdd((&sums.member[_e3109]), bitcast<u32>(select(0i, select(select(i32(_e3111), i32(-2147483648), (_e3111 < -2147483600f)), 2147483647i, (_e3111 > 2147483500f)), (_e3111 == _e3111))));
                        let _e3124 = (_e2959 + 9u);
                        let _e3126 = floor(((select(1f, _e2843.member.z, (_e2843.member.z < 1f)) * _e2967) + 0.5f));
                        if (_e3124 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3138 = atomicAdd((&sums.member[_e3124]), bitcast<u32>(select(0i, select(select(i32(_e3126), i32(-2147483648), (_e3126 < -2147483600f)), 2147483647i, (_e3126 > 2147483500f)), (_e3126 == _e3126))));
                        let _e3139 = (_e2959 + 10u);
                        let _e3142 = params.member.member_8;
                        let _e3143 = (_e2967 / _e3142);
                        let _e3148 = floor(((bitcast<f32>(_e396) * _e3143) + 0.5f));
                        if (_e3139 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3160 = atomicAdd((&sums.member[_e3139]), bitcast<u32>(select(0i, select(select(i32(_e3148), i32(-2147483648), (_e3148 < -2147483600f)), 2147483647i, (_e3148 > 2147483500f)), (_e3148 == _e3148))));
                        let _e3161 = (_e2959 + 11u);
                        let _e3163 = floor(((bitcast<f32>(_e402) * _e3143) + 0.5f));
                        if (_e3161 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3175 = atomicAdd((&sums.member[_e3161]), bitcast<u32>(select(0i, select(select(i32(_e3163), i32(-2147483648), (_e3163 < -2147483600f)), 2147483647i, (_e3163 > 2147483500f)), (_e3163 == _e3163))));
                        let _e3176 = (_e2959 + 12u);
                        let _e3178 = floor(((bitcast<f32>(_e408) * _e3143) + 0.5f));
                        if (_e3176 < _e102) {
                        } else {
                            phi_6039_ = true;
                            break;
                        }
                        let _e3190 = atomicAdd((&sums.member[_e3176]), bitcast<u32>(select(0i, select(select(i32(_e3178), i32(-2147483648), (_e3178 < -2147483600f)), 2147483647i, (_e3178 > 2147483500f)), (_e3178 == _e3178))));
                        phi_6040_ = _e2464;
                    } else {
                        phi_6040_ = _e637;
                    }
                    let _e3192 = phi_6040_;
                    continue;
                    continuing {
                        phi_5747_ = _e3192;
                        let _e3233 = local_50;
                        phi_5365_ = _e3233;
                        let _e3236 = local_51;
                        phi_5362_ = _e3236;
                        let _e3239 = local_52;
                        phi_5359_ = _e3239;
                        let _e3242 = local_53;
                        phi_5356_ = _e3242;
                        phi_6039_ = _e3192;
                        break if !(_e1426);
                    }
                }
                let _e3195 = phi_6039_;
                if _e3195 {
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
