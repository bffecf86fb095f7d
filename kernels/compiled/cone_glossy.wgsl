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

struct type_37 {
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

struct type_39 {
    member: array<type_37>,
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
var<storage> surfels: type_39;
@group(0) @binding(8) 
var<storage, read_write> out: type_29;

fn function_() {
    var phi_228_: vec3<f32>;
    var phi_319_: f32;
    var phi_321_: f32;
    var phi_333_: f32;
    var phi_335_: f32;
    var phi_347_: f32;
    var phi_349_: f32;
    var phi_399_: f32;
    var phi_401_: f32;
    var phi_413_: f32;
    var phi_415_: f32;
    var phi_427_: f32;
    var phi_429_: f32;
    var phi_3793_: bool;
    var phi_447_: type_8;
    var phi_450_: vec3<f32>;
    var phi_452_: f32;
    var phi_454_: f32;
    var phi_456_: f32;
    var phi_448_: type_8;
    var phi_479_: type_8;
    var phi_549_: u32;
    var phi_614_: bool;
    var phi_620_: bool;
    var phi_625_: u32;
    var phi_631_: u32;
    var phi_670_: f32;
    var phi_696_: bool;
    var phi_702_: bool;
    var phi_707_: u32;
    var phi_713_: u32;
    var phi_752_: f32;
    var phi_778_: bool;
    var phi_784_: bool;
    var phi_789_: u32;
    var phi_795_: u32;
    var phi_834_: f32;
    var phi_3762_: bool;
    var phi_841_: type_8;
    var phi_844_: vec4<f32>;
    var phi_842_: type_8;
    var phi_867_: type_8;
    var phi_1452_: vec4<f32>;
    var phi_1489_: vec4<f32>;
    var phi_1530_: vec4<f32>;
    var phi_1424_: vec4<f32>;
    var phi_1545_: vec4<f32>;
    var phi_966_: type_8;
    var phi_969_: u32;
    var phi_967_: type_8;
    var phi_992_: type_8;
    var phi_970_: u32;
    var phi_3748_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1241_: type_8;
    var phi_1244_: vec4<f32>;
    var phi_1246_: vec4<f32>;
    var phi_1242_: type_8;
    var phi_1269_: type_8;
    var phi_1353_: vec4<f32>;
    var phi_1354_: vec4<f32>;
    var phi_1245_: vec4<f32>;
    var phi_1247_: vec4<f32>;
    var phi_3818_: bool;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_1376_: vec4<f32>;
    var local_8: u32;
    var local_9: u32;
    var phi_1109_: type_8;
    var phi_1112_: vec4<f32>;
    var phi_1110_: type_8;
    var phi_1135_: type_8;
    var phi_1113_: vec4<f32>;
    var phi_3823_: bool;
    var phi_3840_: bool;
    var phi_1377_: vec4<f32>;
    var phi_3834_: bool;
    var phi_1546_: vec4<f32>;
    var phi_3833_: bool;
    var phi_1567_: vec4<f32>;
    var phi_3832_: bool;
    var phi_1568_: vec4<f32>;
    var phi_3831_: bool;
    var phi_845_: vec4<f32>;
    var phi_3830_: bool;
    var local_10: vec4<f32>;
    var phi_1623_: bool;
    var phi_1629_: bool;
    var phi_1634_: u32;
    var phi_1640_: u32;
    var phi_1679_: f32;
    var phi_1705_: bool;
    var phi_1711_: bool;
    var phi_1716_: u32;
    var phi_1722_: u32;
    var phi_1761_: f32;
    var phi_1787_: bool;
    var phi_1793_: bool;
    var phi_1798_: u32;
    var phi_1804_: u32;
    var phi_1843_: f32;
    var phi_3856_: bool;
    var phi_1850_: type_8;
    var phi_1853_: vec4<f32>;
    var phi_1851_: type_8;
    var phi_1876_: type_8;
    var phi_2461_: vec4<f32>;
    var phi_2498_: vec4<f32>;
    var phi_2539_: vec4<f32>;
    var phi_2433_: vec4<f32>;
    var phi_2554_: vec4<f32>;
    var phi_1975_: type_8;
    var phi_1978_: u32;
    var phi_1976_: type_8;
    var phi_2001_: type_8;
    var phi_1979_: u32;
    var phi_3842_: bool;
    var local_11: u32;
    var local_12: u32;
    var phi_2250_: type_8;
    var phi_2253_: vec4<f32>;
    var phi_2255_: vec4<f32>;
    var phi_2251_: type_8;
    var phi_2278_: type_8;
    var phi_2362_: vec4<f32>;
    var phi_2363_: vec4<f32>;
    var phi_2254_: vec4<f32>;
    var phi_2256_: vec4<f32>;
    var phi_3882_: bool;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var phi_2385_: vec4<f32>;
    var local_19: u32;
    var local_20: u32;
    var phi_2118_: type_8;
    var phi_2121_: vec4<f32>;
    var phi_2119_: type_8;
    var phi_2144_: type_8;
    var phi_2122_: vec4<f32>;
    var phi_3887_: bool;
    var phi_3904_: bool;
    var phi_2386_: vec4<f32>;
    var phi_3898_: bool;
    var phi_2555_: vec4<f32>;
    var phi_3897_: bool;
    var phi_2576_: vec4<f32>;
    var phi_3896_: bool;
    var phi_2577_: vec4<f32>;
    var phi_3895_: bool;
    var phi_1854_: vec4<f32>;
    var phi_3894_: bool;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var phi_3947_: bool;
    var phi_2603_: vec4<f32>;
    var phi_3946_: bool;
    var phi_2604_: vec4<f32>;
    var phi_2605_: bool;
    var phi_3945_: bool;
    var phi_2606_: vec4<f32>;
    var phi_2607_: bool;
    var phi_2608_: bool;
    var phi_2661_: bool;
    var phi_2667_: bool;
    var phi_2672_: u32;
    var phi_2678_: u32;
    var phi_2717_: f32;
    var phi_2743_: bool;
    var phi_2749_: bool;
    var phi_2754_: u32;
    var phi_2760_: u32;
    var phi_2799_: f32;
    var phi_2825_: bool;
    var phi_2831_: bool;
    var phi_2836_: u32;
    var phi_2842_: u32;
    var phi_2881_: f32;
    var phi_3920_: bool;
    var phi_2888_: type_8;
    var phi_2891_: vec4<f32>;
    var phi_2889_: type_8;
    var phi_2914_: type_8;
    var phi_3499_: vec4<f32>;
    var phi_3536_: vec4<f32>;
    var phi_3577_: vec4<f32>;
    var phi_3471_: vec4<f32>;
    var phi_3592_: vec4<f32>;
    var phi_3013_: type_8;
    var phi_3016_: u32;
    var phi_3014_: type_8;
    var phi_3039_: type_8;
    var phi_3017_: u32;
    var phi_3906_: bool;
    var local_28: u32;
    var local_29: u32;
    var phi_3288_: type_8;
    var phi_3291_: vec4<f32>;
    var phi_3293_: vec4<f32>;
    var phi_3289_: type_8;
    var phi_3316_: type_8;
    var phi_3400_: vec4<f32>;
    var phi_3401_: vec4<f32>;
    var phi_3292_: vec4<f32>;
    var phi_3294_: vec4<f32>;
    var phi_3949_: bool;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var phi_3423_: vec4<f32>;
    var local_36: u32;
    var local_37: u32;
    var phi_3156_: type_8;
    var phi_3159_: vec4<f32>;
    var phi_3157_: type_8;
    var phi_3182_: type_8;
    var phi_3160_: vec4<f32>;
    var phi_3954_: bool;
    var phi_3971_: bool;
    var phi_3424_: vec4<f32>;
    var phi_3965_: bool;
    var phi_3593_: vec4<f32>;
    var phi_3964_: bool;
    var phi_3614_: vec4<f32>;
    var phi_3963_: bool;
    var phi_3615_: vec4<f32>;
    var phi_3962_: bool;
    var phi_2892_: vec4<f32>;
    var phi_3961_: bool;
    var local_38: vec4<f32>;
    var phi_3979_: bool;
    var phi_3617_: vec4<f32>;
    var phi_3656_: vec3<f32>;
    var phi_3657_: f32;
    var phi_3976_: bool;
    var phi_3660_: vec3<f32>;
    var phi_3661_: f32;
    var phi_3662_: f32;
    var phi_3663_: f32;
    var phi_3975_: bool;
    var phi_3665_: vec3<f32>;
    var phi_3666_: f32;
    var phi_3667_: f32;
    var phi_3668_: f32;
    var phi_3669_: bool;
    var phi_3974_: bool;
    var phi_451_: vec3<f32>;
    var phi_453_: f32;
    var phi_455_: f32;
    var phi_457_: f32;
    var phi_3671_: bool;
    var phi_3973_: bool;
    var local_39: f32;
    var local_40: f32;
    var local_41: vec3<f32>;
    var local_42: vec3<f32>;
    var local_43: vec3<f32>;
    var phi_3698_: vec4<f32>;
    var local_44: vec4<f32>;
    var local_45: vec4<f32>;
    var local_46: vec4<f32>;
    var local_47: vec4<f32>;
    var local_48: vec4<f32>;
    var local_49: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e60 = gid_1;
            let _e63 = arrayLength((&cells.member));
            let _e66 = arrayLength((&facet_bits.member));
            let _e69 = arrayLength((&facets.member));
            let _e72 = arrayLength((&radiance.member));
            let _e75 = arrayLength((&odd.member));
            let _e78 = arrayLength((&even.member));
            let _e86 = (_e60.x + (_e60.y * 2097152u));
            let _e87 = (_e86 < arrayLength((&out.member)));
            if _e87 {
                if (_e86 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e92 = surfels.member[_e86].member;
                let _e96 = surfels.member[_e86].member_1;
                let _e100 = surfels.member[_e86].member_2;
                let _e104 = surfels.member[_e86].member_4;
                if (_e96 == 4294967295u) {
                    phi_3698_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e111 = params.member.member_5;
                    let _e115 = (_e111.x - _e92[0]);
                    let _e116 = (_e111.y - _e92[1]);
                    let _e117 = (_e111.z - _e92[2]);
                    let _e122 = (((_e115 * _e115) + (_e116 * _e116)) + (_e117 * _e117));
                    if (_e122 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e125 = (1f / sqrt(_e122));
                        phi_228_ = vec3<f32>((_e115 * _e125), (_e116 * _e125), (_e117 * _e125));
                    } else {
                        phi_228_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e131 = phi_228_;
                    let _e143 = (2f * (((_e131.x * _e100[0]) + (_e131.y * _e100[1])) + (_e131.z * _e100[2])));
                    let _e147 = ((_e100[0] * _e143) - _e131.x);
                    let _e148 = ((_e100[1] * _e143) - _e131.y);
                    let _e149 = ((_e100[2] * _e143) - _e131.z);
                    let _e152 = params.member.member;
                    let _e168 = params.member.member_12;
                    let _e172 = (((_e92[0] - _e152.x) / _e152.w) + (_e104[0] * _e168));
                    let _e173 = (((_e92[1] - _e152.y) / _e152.w) + (_e104[1] * _e168));
                    let _e174 = (((_e92[2] - _e152.z) / _e152.w) + (_e104[2] * _e168));
                    let _e178 = params.member.member_5[3u];
                    let _e179 = (2f * _e178);
                    let _e182 = params.member.member_13;
                    let _e183 = (_e182 * _e168);
                    let _e188 = (((_e147 * _e104[0]) + (_e148 * _e104[1])) + (_e149 * _e104[2]));
                    let _e191 = (_e182 * select(0f, _e188, (_e188 > 0f)));
                    let _e194 = params.member.member_11;
                    let _e197 = params.member.member_1;
                    let _e199 = f32(_e197.x);
                    let _e201 = f32(_e197.y);
                    let _e203 = f32(_e197.z);
                    let _e204 = abs(_e147);
                    let _e205 = (_e204 < 0.000000001f);
                    if _e205 {
                        phi_321_ = 340282350000000000000000000000000000000f;
                    } else {
                        if (_e147 > 0f) {
                            phi_319_ = (_e199 - _e172);
                        } else {
                            phi_319_ = -(_e172);
                        }
                        let _e210 = phi_319_;
                        phi_321_ = (_e210 / _e147);
                    }
                    let _e213 = phi_321_;
                    let _e214 = abs(_e148);
                    let _e215 = (_e214 < 0.000000001f);
                    if _e215 {
                        phi_335_ = 340282350000000000000000000000000000000f;
                    } else {
                        if (_e148 > 0f) {
                            phi_333_ = (_e201 - _e173);
                        } else {
                            phi_333_ = -(_e173);
                        }
                        let _e220 = phi_333_;
                        phi_335_ = (_e220 / _e148);
                    }
                    let _e223 = phi_335_;
                    let _e224 = abs(_e149);
                    let _e225 = (_e224 < 0.000000001f);
                    if _e225 {
                        phi_349_ = 340282350000000000000000000000000000000f;
                    } else {
                        if (_e149 > 0f) {
                            phi_347_ = (_e203 - _e174);
                        } else {
                            phi_347_ = -(_e174);
                        }
                        let _e230 = phi_347_;
                        phi_349_ = (_e230 / _e149);
                    }
                    let _e233 = phi_349_;
                    let _e235 = select(_e223, _e213, (_e213 < _e223));
                    let _e237 = select(_e233, _e235, (_e235 < _e233));
                    let _e239 = select(0f, _e237, (_e237 > 0f));
                    let _e240 = (_e179 * _e239);
                    let _e242 = (_e183 + (_e191 * _e239));
                    let _e244 = select(_e242, _e240, (_e240 < _e242));
                    let _e246 = select(1f, _e244, (_e244 > 1f));
                    let _e247 = (1.5f * _e246);
                    let _e248 = (_e172 + _e247);
                    let _e249 = (_e173 + _e247);
                    let _e250 = (_e174 + _e247);
                    let _e251 = (_e246 * 3f);
                    if _e205 {
                        phi_401_ = 340282350000000000000000000000000000000f;
                    } else {
                        if (_e147 > 0f) {
                            phi_399_ = ((_e199 + _e251) - _e248);
                        } else {
                            phi_399_ = -(_e248);
                        }
                        let _e259 = phi_399_;
                        phi_401_ = (_e259 / _e147);
                    }
                    let _e262 = phi_401_;
                    if _e215 {
                        phi_415_ = 340282350000000000000000000000000000000f;
                    } else {
                        if (_e148 > 0f) {
                            phi_413_ = ((_e201 + _e251) - _e249);
                        } else {
                            phi_413_ = -(_e249);
                        }
                        let _e267 = phi_413_;
                        phi_415_ = (_e267 / _e148);
                    }
                    let _e270 = phi_415_;
                    if _e225 {
                        phi_429_ = 340282350000000000000000000000000000000f;
                    } else {
                        if (_e149 > 0f) {
                            phi_427_ = ((_e203 + _e251) - _e250);
                        } else {
                            phi_427_ = -(_e250);
                        }
                        let _e275 = phi_427_;
                        phi_429_ = (_e275 / _e149);
                    }
                    let _e278 = phi_429_;
                    let _e280 = select(_e270, _e262, (_e262 < _e270));
                    let _e282 = select(_e278, _e280, (_e280 < _e278));
                    phi_3793_ = false;
                    phi_447_ = type_8(0u, 2048u);
                    phi_450_ = vec3<f32>(0f, 0f, 0f);
                    phi_452_ = 0f;
                    phi_454_ = 0f;
                    phi_456_ = 1f;
                    loop {
                        let _e286 = phi_3793_;
                        let _e288 = phi_447_;
                        let _e290 = phi_450_;
                        let _e292 = phi_452_;
                        let _e294 = phi_454_;
                        let _e296 = phi_456_;
                        local_39 = _e294;
                        local_40 = _e296;
                        local_41 = _e290;
                        local_42 = _e290;
                        local_43 = _e290;
                        if (_e288.member < _e288.member_1) {
                            phi_448_ = type_8((_e288.member + 1u), _e288.member_1);
                            phi_479_ = type_8(1u, _e288.member);
                        } else {
                            phi_448_ = _e288;
                            phi_479_ = type_8(0u, type_8().member_1);
                        }
                        let _e309 = phi_448_;
                        let _e311 = phi_479_;
                        if (bitcast<i32>(_e311.member) != 0i) {
                            if (_e292 >= select(0f, _e282, (_e282 > 0f))) {
                                phi_3975_ = _e286;
                                phi_3665_ = vec3<f32>();
                                phi_3666_ = f32();
                                phi_3667_ = f32();
                                phi_3668_ = f32();
                                phi_3669_ = false;
                            } else {
                                let _e316 = (1f - _e294);
                                let _e317 = (_e296 * _e316);
                                let _e318 = (_e317 < 0.001f);
                                if _e318 {
                                    phi_3976_ = _e286;
                                    phi_3660_ = vec3<f32>();
                                    phi_3661_ = f32();
                                    phi_3662_ = f32();
                                    phi_3663_ = f32();
                                } else {
                                    let _e319 = (_e179 * _e292);
                                    let _e321 = (_e183 + (_e191 * _e292));
                                    let _e323 = select(_e321, _e319, (_e319 < _e321));
                                    let _e326 = (_e194 * select(1f, _e323, (_e323 > 1f)));
                                    let _e328 = (_e292 + (0.5f * _e326));
                                    let _e332 = (_e172 + (_e147 * _e328));
                                    let _e333 = (_e173 + (_e148 * _e328));
                                    let _e334 = (_e174 + (_e149 * _e328));
                                    let _e335 = (_e179 * _e328);
                                    let _e337 = (_e183 + (_e191 * _e328));
                                    let _e339 = select(_e337, _e335, (_e335 < _e337));
                                    let _e341 = select(1f, _e339, (_e339 > 1f));
                                    let _e346 = (bitcast<i32>((bitcast<u32>(_e341) >> bitcast<u32>(23i))) - 127i);
                                    let _e348 = (_e197.w - 1u);
                                    if (_e346 > 0i) {
                                        let _e350 = bitcast<u32>(_e346);
                                        phi_549_ = select(_e350, _e348, (_e348 < _e350));
                                    } else {
                                        phi_549_ = 0u;
                                    }
                                    let _e354 = phi_549_;
                                    let _e355 = (_e354 & 31u);
                                    let _e357 = (1u << bitcast<u32>(_e355));
                                    let _e359 = (1f / f32(_e357));
                                    let _e360 = (_e341 * _e359);
                                    let _e361 = (_e360 - 1f);
                                    if (_e354 == _e348) {
                                        phi_3945_ = _e286;
                                        phi_2606_ = vec4<f32>();
                                        phi_2607_ = true;
                                        phi_2608_ = false;
                                    } else {
                                        let _e363 = (_e361 <= 0f);
                                        if _e363 {
                                            phi_3946_ = _e286;
                                            phi_2604_ = vec4<f32>();
                                            phi_2605_ = false;
                                        } else {
                                            let _e364 = (_e354 + 1u);
                                            if (_e364 < 10u) {
                                            } else {
                                                phi_3973_ = true;
                                                break;
                                            }
                                            let _e369 = params.member.member_2[_e364];
                                            let _e370 = (_e364 & 31u);
                                            let _e372 = (1u << bitcast<u32>(_e370));
                                            let _e373 = (_e372 - 1u);
                                            let _e384 = (1f / f32(_e372));
                                            let _e386 = ((_e332 * _e384) - 0.5f);
                                            let _e387 = floor(_e386);
                                            let _e388 = (_e386 - _e387);
                                            let _e395 = select(0i, select(select(i32(_e387), i32(-2147483648), (_e387 < -2147483600f)), 2147483647i, (_e387 > 2147483500f)), (_e387 == _e387));
                                            let _e397 = (bitcast<i32>(((_e197.x + _e373) >> bitcast<u32>(_e370))) - 1i);
                                            if (_e395 >= 0i) {
                                                phi_614_ = (_e395 <= _e397);
                                            } else {
                                                phi_614_ = false;
                                            }
                                            let _e401 = phi_614_;
                                            if (_e395 >= -1i) {
                                                phi_620_ = (_e395 < _e397);
                                            } else {
                                                phi_620_ = false;
                                            }
                                            let _e405 = phi_620_;
                                            if _e401 {
                                                phi_625_ = bitcast<u32>(_e395);
                                            } else {
                                                phi_625_ = 0u;
                                            }
                                            let _e408 = phi_625_;
                                            if _e405 {
                                                phi_631_ = bitcast<u32>((_e395 + 1i));
                                            } else {
                                                phi_631_ = 0u;
                                            }
                                            let _e412 = phi_631_;
                                            if _e401 {
                                                phi_670_ = (1f - _e388);
                                            } else {
                                                phi_670_ = 0f;
                                            }
                                            let _e433 = phi_670_;
                                            let _e436 = ((_e333 * _e384) - 0.5f);
                                            let _e438 = floor(_e436);
                                            let _e439 = (_e436 - _e438);
                                            let _e446 = select(0i, select(select(i32(_e438), i32(-2147483648), (_e438 < -2147483600f)), 2147483647i, (_e438 > 2147483500f)), (_e438 == _e438));
                                            let _e448 = (bitcast<i32>(((_e197.y + _e373) >> bitcast<u32>(_e370))) - 1i);
                                            if (_e446 >= 0i) {
                                                phi_696_ = (_e446 <= _e448);
                                            } else {
                                                phi_696_ = false;
                                            }
                                            let _e452 = phi_696_;
                                            if (_e446 >= -1i) {
                                                phi_702_ = (_e446 < _e448);
                                            } else {
                                                phi_702_ = false;
                                            }
                                            let _e456 = phi_702_;
                                            if _e452 {
                                                phi_707_ = bitcast<u32>(_e446);
                                            } else {
                                                phi_707_ = 0u;
                                            }
                                            let _e459 = phi_707_;
                                            if _e456 {
                                                phi_713_ = bitcast<u32>((_e446 + 1i));
                                            } else {
                                                phi_713_ = 0u;
                                            }
                                            let _e463 = phi_713_;
                                            if _e452 {
                                                phi_752_ = (1f - _e439);
                                            } else {
                                                phi_752_ = 0f;
                                            }
                                            let _e490 = phi_752_;
                                            let _e493 = ((_e334 * _e384) - 0.5f);
                                            let _e495 = floor(_e493);
                                            let _e496 = (_e493 - _e495);
                                            let _e503 = select(0i, select(select(i32(_e495), i32(-2147483648), (_e495 < -2147483600f)), 2147483647i, (_e495 > 2147483500f)), (_e495 == _e495));
                                            let _e505 = (bitcast<i32>(((_e197.z + _e373) >> bitcast<u32>(_e370))) - 1i);
                                            if (_e503 >= 0i) {
                                                phi_778_ = (_e503 <= _e505);
                                            } else {
                                                phi_778_ = false;
                                            }
                                            let _e509 = phi_778_;
                                            if (_e503 >= -1i) {
                                                phi_784_ = (_e503 < _e505);
                                            } else {
                                                phi_784_ = false;
                                            }
                                            let _e513 = phi_784_;
                                            if _e509 {
                                                phi_789_ = bitcast<u32>(_e503);
                                            } else {
                                                phi_789_ = 0u;
                                            }
                                            let _e516 = phi_789_;
                                            if _e513 {
                                                phi_795_ = bitcast<u32>((_e503 + 1i));
                                            } else {
                                                phi_795_ = 0u;
                                            }
                                            let _e520 = phi_795_;
                                            if _e509 {
                                                phi_834_ = (1f - _e496);
                                            } else {
                                                phi_834_ = 0f;
                                            }
                                            let _e535 = phi_834_;
                                            phi_3762_ = _e286;
                                            phi_841_ = type_8(0u, 8u);
                                            phi_844_ = vec4<f32>(0f, 0f, 0f, 0f);
                                            loop {
                                                let _e538 = phi_3762_;
                                                let _e540 = phi_841_;
                                                let _e542 = phi_844_;
                                                local_10 = _e542;
                                                local_25 = _e542;
                                                local_26 = _e542;
                                                local_27 = _e542;
                                                if (_e540.member < _e540.member_1) {
                                                    phi_842_ = type_8((_e540.member + 1u), _e540.member_1);
                                                    phi_867_ = type_8(1u, _e540.member);
                                                } else {
                                                    phi_842_ = _e540;
                                                    phi_867_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e555 = phi_842_;
                                                let _e557 = phi_867_;
                                                let _e561 = (bitcast<i32>(_e557.member) != 0i);
                                                if _e561 {
                                                    let _e563 = ((_e557.member_1 & 1u) == 1u);
                                                    let _e565 = ((_e557.member_1 & 2u) == 2u);
                                                    let _e567 = ((_e557.member_1 & 4u) == 4u);
                                                    let _e572 = ((select(_e433, select(0f, _e388, _e405), _e563) * select(_e490, select(0f, _e439, _e456), _e565)) * select(_e535, select(0f, _e496, _e513), _e567));
                                                    let _e579 = (((_e369.z + select((_e408 >> bitcast<u32>(2u)), (_e412 >> bitcast<u32>(2u)), _e563)) + select(((_e459 >> bitcast<u32>(2u)) * _e369.x), ((_e463 >> bitcast<u32>(2u)) * _e369.x), _e565)) + select(((_e516 >> bitcast<u32>(1u)) * _e369.y), ((_e520 >> bitcast<u32>(1u)) * _e369.y), _e567));
                                                    let _e585 = (2u * _e579);
                                                    if (_e585 < _e63) {
                                                    } else {
                                                        phi_3830_ = true;
                                                        break;
                                                    }
                                                    let _e588 = cells.member[_e585];
                                                    if (_e572 > 0f) {
                                                        let _e590 = (((select(((_e408 & 1u) | (((_e408 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), ((_e412 & 1u) | (((_e412 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), _e563) | select((((_e459 & 1u) << bitcast<u32>(1u)) | (((_e459 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), (((_e463 & 1u) << bitcast<u32>(1u)) | (((_e463 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), _e565)) | select(((_e516 & 1u) << bitcast<u32>(2u)), ((_e520 & 1u) << bitcast<u32>(2u)), _e567)) & 31u);
                                                        if (((_e588 >> bitcast<u32>(_e590)) & 1u) == 1u) {
                                                            if (_e364 == 0u) {
                                                                let _e693 = (_e579 * 6u);
                                                                let _e694 = (_e585 + 1u);
                                                                if (_e694 < _e63) {
                                                                } else {
                                                                    phi_3830_ = true;
                                                                    break;
                                                                }
                                                                let _e697 = cells.member[_e694];
                                                                phi_966_ = type_8(0u, 6u);
                                                                phi_969_ = _e697;
                                                                loop {
                                                                    let _e699 = phi_966_;
                                                                    let _e701 = phi_969_;
                                                                    local = _e701;
                                                                    local_1 = _e701;
                                                                    local_8 = _e701;
                                                                    local_9 = _e701;
                                                                    if (_e699.member < _e699.member_1) {
                                                                        phi_967_ = type_8((_e699.member + 1u), _e699.member_1);
                                                                        phi_992_ = type_8(1u, _e699.member);
                                                                    } else {
                                                                        phi_967_ = _e699;
                                                                        phi_992_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e714 = phi_967_;
                                                                    let _e716 = phi_992_;
                                                                    let _e720 = (bitcast<i32>(_e716.member) != 0i);
                                                                    if _e720 {
                                                                        let _e721 = (_e693 + _e716.member_1);
                                                                        if (_e721 < _e66) {
                                                                        } else {
                                                                            phi_3748_ = true;
                                                                            break;
                                                                        }
                                                                        let _e724 = facet_bits.member[_e721];
                                                                        phi_970_ = (_e701 + countOneBits((_e724 & ((1u << bitcast<u32>(_e590)) - 1u))));
                                                                    } else {
                                                                        phi_970_ = u32();
                                                                    }
                                                                    let _e732 = phi_970_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_966_ = _e714;
                                                                        phi_969_ = _e732;
                                                                        phi_3748_ = _e538;
                                                                        break if !(_e720);
                                                                    }
                                                                }
                                                                let _e735 = phi_3748_;
                                                                phi_3830_ = _e735;
                                                                if _e735 {
                                                                    break;
                                                                }
                                                                if (_e693 < _e66) {
                                                                } else {
                                                                    phi_3830_ = true;
                                                                    break;
                                                                }
                                                                let _e738 = facet_bits.member[_e693];
                                                                let _e742 = (_e693 + 1u);
                                                                if (_e742 < _e66) {
                                                                } else {
                                                                    phi_3830_ = true;
                                                                    break;
                                                                }
                                                                let _e745 = facet_bits.member[_e742];
                                                                let _e750 = (_e693 + 2u);
                                                                if (_e750 < _e66) {
                                                                } else {
                                                                    phi_3830_ = true;
                                                                    break;
                                                                }
                                                                let _e753 = facet_bits.member[_e750];
                                                                let _e758 = (_e693 + 3u);
                                                                if (_e758 < _e66) {
                                                                } else {
                                                                    phi_3830_ = true;
                                                                    break;
                                                                }
                                                                let _e761 = facet_bits.member[_e758];
                                                                let _e766 = (_e693 + 4u);
                                                                if (_e766 < _e66) {
                                                                } else {
                                                                    phi_3830_ = true;
                                                                    break;
                                                                }
                                                                let _e769 = facet_bits.member[_e766];
                                                                let _e774 = (_e693 + 5u);
                                                                if (_e774 < _e66) {
                                                                } else {
                                                                    phi_3830_ = true;
                                                                    break;
                                                                }
                                                                let _e777 = facet_bits.member[_e774];
                                                                let _e781 = (((((((_e738 >> bitcast<u32>(_e590)) & 1u) + ((_e745 >> bitcast<u32>(_e590)) & 1u)) + ((_e753 >> bitcast<u32>(_e590)) & 1u)) + ((_e761 >> bitcast<u32>(_e590)) & 1u)) + ((_e769 >> bitcast<u32>(_e590)) & 1u)) + ((_e777 >> bitcast<u32>(_e590)) & 1u));
                                                                let _e784 = params.member.member_7;
                                                                if (_e784 == 1u) {
                                                                    let _e909 = local_8;
                                                                    let _e912 = local_9;
                                                                    phi_1109_ = type_8(_e912, (_e909 + _e781));
                                                                    phi_1112_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    loop {
                                                                        let _e915 = phi_1109_;
                                                                        let _e917 = phi_1112_;
                                                                        local_45 = _e917;
                                                                        if (_e915.member < _e915.member_1) {
                                                                            phi_1110_ = type_8((_e915.member + 1u), _e915.member_1);
                                                                            phi_1135_ = type_8(1u, _e915.member);
                                                                        } else {
                                                                            phi_1110_ = _e915;
                                                                            phi_1135_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e930 = phi_1110_;
                                                                        let _e932 = phi_1135_;
                                                                        let _e936 = (bitcast<i32>(_e932.member) != 0i);
                                                                        if _e936 {
                                                                            let _e937 = (2u * _e932.member_1);
                                                                            if (_e937 < _e72) {
                                                                            } else {
                                                                                phi_3823_ = true;
                                                                                break;
                                                                            }
                                                                            let _e941 = radiance.member[_e937][0u];
                                                                            let _e944 = radiance.member[_e937][1u];
                                                                            let _e947 = radiance.member[_e937][2u];
                                                                            let _e948 = (_e937 + 1u);
                                                                            if (_e948 < _e72) {
                                                                            } else {
                                                                                phi_3823_ = true;
                                                                                break;
                                                                            }
                                                                            let _e952 = radiance.member[_e948][0u];
                                                                            let _e955 = radiance.member[_e948][1u];
                                                                            let _e958 = radiance.member[_e948][2u];
                                                                            if (_e932.member_1 < _e69) {
                                                                            } else {
                                                                                phi_3823_ = true;
                                                                                break;
                                                                            }
                                                                            let _e968 = facets.member[_e932.member_1].member_2;
                                                                            let _e977 = sqrt((((_e968[0] * _e968[0]) + (_e968[1] * _e968[1])) + (_e968[2] * _e968[2])));
                                                                            phi_1113_ = vec4<f32>((_e917.x + (select(_e952, _e941, (_e941 > _e952)) * _e977)), (_e917.y + (select(_e955, _e944, (_e944 > _e955)) * _e977)), (_e917.z + (select(_e958, _e947, (_e947 > _e958)) * _e977)), (_e917.w + _e977));
                                                                        } else {
                                                                            phi_1113_ = vec4<f32>();
                                                                        }
                                                                        let _e991 = phi_1113_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_1109_ = _e930;
                                                                            phi_1112_ = _e991;
                                                                            phi_3823_ = _e735;
                                                                            break if !(_e936);
                                                                        }
                                                                    }
                                                                    let _e994 = phi_3823_;
                                                                    phi_3830_ = _e994;
                                                                    if _e994 {
                                                                        break;
                                                                    }
                                                                    phi_3840_ = _e994;
                                                                    let _e2618 = local_45;
                                                                    phi_1377_ = _e2618;
                                                                } else {
                                                                    let _e787 = local;
                                                                    let _e790 = local_1;
                                                                    phi_1241_ = type_8(_e790, (_e787 + _e781));
                                                                    phi_1244_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    phi_1246_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    loop {
                                                                        let _e793 = phi_1241_;
                                                                        let _e795 = phi_1244_;
                                                                        let _e797 = phi_1246_;
                                                                        local_2 = _e795;
                                                                        local_3 = _e797;
                                                                        local_4 = _e795;
                                                                        local_5 = _e795;
                                                                        local_6 = _e795;
                                                                        local_7 = _e797;
                                                                        local_44 = _e797;
                                                                        if (_e793.member < _e793.member_1) {
                                                                            phi_1242_ = type_8((_e793.member + 1u), _e793.member_1);
                                                                            phi_1269_ = type_8(1u, _e793.member);
                                                                        } else {
                                                                            phi_1242_ = _e793;
                                                                            phi_1269_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e810 = phi_1242_;
                                                                        let _e812 = phi_1269_;
                                                                        let _e816 = (bitcast<i32>(_e812.member) != 0i);
                                                                        if _e816 {
                                                                            if (_e812.member_1 < _e69) {
                                                                            } else {
                                                                                phi_3818_ = true;
                                                                                break;
                                                                            }
                                                                            let _e820 = facets.member[_e812.member_1].member_2;
                                                                            let _e829 = -((((_e147 * _e820[0]) + (_e148 * _e820[1])) + (_e149 * _e820[2])));
                                                                            if (_e829 > 0f) {
                                                                                let _e851 = (2u * _e812.member_1);
                                                                                if (_e851 < _e72) {
                                                                                } else {
                                                                                    phi_3818_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e854 = radiance.member[_e851];
                                                                                phi_1353_ = _e795;
                                                                                phi_1354_ = vec4<f32>((_e797.x + (_e854.x * _e829)), (_e797.y + (_e854.y * _e829)), (_e797.z + (_e854.z * _e829)), (_e797.w + _e829));
                                                                            } else {
                                                                                let _e832 = ((2u * _e812.member_1) + 1u);
                                                                                if (_e832 < _e72) {
                                                                                } else {
                                                                                    phi_3818_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e835 = radiance.member[_e832];
                                                                                phi_1353_ = vec4<f32>((_e795.x - (_e835.x * _e829)), (_e795.y - (_e835.y * _e829)), (_e795.z - (_e835.z * _e829)), (_e795.w - _e829));
                                                                                phi_1354_ = _e797;
                                                                            }
                                                                            let _e871 = phi_1353_;
                                                                            let _e873 = phi_1354_;
                                                                            phi_1245_ = _e871;
                                                                            phi_1247_ = _e873;
                                                                        } else {
                                                                            phi_1245_ = vec4<f32>();
                                                                            phi_1247_ = vec4<f32>();
                                                                        }
                                                                        let _e875 = phi_1245_;
                                                                        let _e877 = phi_1247_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_1241_ = _e810;
                                                                            phi_1244_ = _e875;
                                                                            phi_1246_ = _e877;
                                                                            phi_3818_ = _e735;
                                                                            break if !(_e816);
                                                                        }
                                                                    }
                                                                    let _e880 = phi_3818_;
                                                                    phi_3830_ = _e880;
                                                                    if _e880 {
                                                                        break;
                                                                    }
                                                                    let _e882 = local_2;
                                                                    let _e885 = local_3;
                                                                    if (_e882.w > _e885.w) {
                                                                        let _e888 = (_e882.w - _e885.w);
                                                                        let _e889 = (_e888 / _e882.w);
                                                                        let _e891 = local_4;
                                                                        let _e895 = local_5;
                                                                        let _e899 = local_6;
                                                                        let _e904 = local_7;
                                                                        phi_1376_ = (_e904 + vec4<f32>((_e891.x * _e889), (_e895.y * _e889), (_e899.z * _e889), _e888));
                                                                    } else {
                                                                        let _e2606 = local_44;
                                                                        phi_1376_ = _e2606;
                                                                    }
                                                                    let _e907 = phi_1376_;
                                                                    phi_3840_ = _e880;
                                                                    phi_1377_ = _e907;
                                                                }
                                                                let _e996 = phi_3840_;
                                                                let _e998 = phi_1377_;
                                                                phi_3834_ = _e996;
                                                                phi_1546_ = _e998;
                                                            } else {
                                                                let _e596 = (_e585 + 1u);
                                                                if (_e596 < _e63) {
                                                                } else {
                                                                    phi_3830_ = true;
                                                                    break;
                                                                }
                                                                let _e599 = cells.member[_e596];
                                                                let _e605 = (_e599 + countOneBits((_e588 & ((1u << bitcast<u32>(_e590)) - 1u))));
                                                                let _e608 = params.member.member_7;
                                                                if (_e608 == 1u) {
                                                                    if ((_e364 & 1u) == 1u) {
                                                                        if (_e605 < _e75) {
                                                                        } else {
                                                                            phi_3830_ = true;
                                                                            break;
                                                                        }
                                                                        let _e688 = odd.member[_e605];
                                                                        phi_1424_ = _e688;
                                                                    } else {
                                                                        if (_e605 < _e78) {
                                                                        } else {
                                                                            phi_3830_ = true;
                                                                            break;
                                                                        }
                                                                        let _e685 = even.member[_e605];
                                                                        phi_1424_ = _e685;
                                                                    }
                                                                    let _e690 = phi_1424_;
                                                                    phi_1545_ = _e690;
                                                                } else {
                                                                    let _e610 = (_e605 * 6u);
                                                                    let _e613 = (_e610 + select(0u, 1u, (_e147 < 0f)));
                                                                    let _e615 = ((_e364 & 1u) == 1u);
                                                                    if _e615 {
                                                                        if (_e613 < _e75) {
                                                                        } else {
                                                                            phi_3830_ = true;
                                                                            break;
                                                                        }
                                                                        let _e621 = odd.member[_e613];
                                                                        phi_1452_ = _e621;
                                                                    } else {
                                                                        if (_e613 < _e78) {
                                                                        } else {
                                                                            phi_3830_ = true;
                                                                            break;
                                                                        }
                                                                        let _e618 = even.member[_e613];
                                                                        phi_1452_ = _e618;
                                                                    }
                                                                    let _e623 = phi_1452_;
                                                                    let _e635 = ((_e610 + 2u) + select(0u, 1u, (_e148 < 0f)));
                                                                    if _e615 {
                                                                        if (_e635 < _e75) {
                                                                        } else {
                                                                            phi_3830_ = true;
                                                                            break;
                                                                        }
                                                                        let _e641 = odd.member[_e635];
                                                                        phi_1489_ = _e641;
                                                                    } else {
                                                                        if (_e635 < _e78) {
                                                                        } else {
                                                                            phi_3830_ = true;
                                                                            break;
                                                                        }
                                                                        let _e638 = even.member[_e635];
                                                                        phi_1489_ = _e638;
                                                                    }
                                                                    let _e643 = phi_1489_;
                                                                    let _e659 = ((_e610 + 4u) + select(0u, 1u, (_e149 < 0f)));
                                                                    if _e615 {
                                                                        if (_e659 < _e75) {
                                                                        } else {
                                                                            phi_3830_ = true;
                                                                            break;
                                                                        }
                                                                        let _e665 = odd.member[_e659];
                                                                        phi_1530_ = _e665;
                                                                    } else {
                                                                        if (_e659 < _e78) {
                                                                        } else {
                                                                            phi_3830_ = true;
                                                                            break;
                                                                        }
                                                                        let _e662 = even.member[_e659];
                                                                        phi_1530_ = _e662;
                                                                    }
                                                                    let _e667 = phi_1530_;
                                                                    phi_1545_ = vec4<f32>((((_e623.x * _e204) + (_e643.x * _e214)) + (_e667.x * _e224)), (((_e623.y * _e204) + (_e643.y * _e214)) + (_e667.y * _e224)), (((_e623.z * _e204) + (_e643.z * _e214)) + (_e667.z * _e224)), (((_e623.w * _e204) + (_e643.w * _e214)) + (_e667.w * _e224)));
                                                                }
                                                                let _e692 = phi_1545_;
                                                                phi_3834_ = _e538;
                                                                phi_1546_ = _e692;
                                                            }
                                                            let _e1000 = phi_3834_;
                                                            let _e1002 = phi_1546_;
                                                            phi_3833_ = _e1000;
                                                            phi_1567_ = vec4<f32>((_e542.x + (_e1002.x * _e572)), (_e542.y + (_e1002.y * _e572)), (_e542.z + (_e1002.z * _e572)), (_e542.w + (_e1002.w * _e572)));
                                                        } else {
                                                            phi_3833_ = _e538;
                                                            phi_1567_ = _e542;
                                                        }
                                                        let _e1021 = phi_3833_;
                                                        let _e1023 = phi_1567_;
                                                        phi_3832_ = _e1021;
                                                        phi_1568_ = _e1023;
                                                    } else {
                                                        phi_3832_ = _e538;
                                                        phi_1568_ = _e542;
                                                    }
                                                    let _e1025 = phi_3832_;
                                                    let _e1027 = phi_1568_;
                                                    phi_3831_ = _e1025;
                                                    phi_845_ = _e1027;
                                                } else {
                                                    phi_3831_ = _e538;
                                                    phi_845_ = vec4<f32>();
                                                }
                                                let _e1029 = phi_3831_;
                                                let _e1031 = phi_845_;
                                                continue;
                                                continuing {
                                                    phi_3762_ = _e1029;
                                                    phi_841_ = _e555;
                                                    phi_844_ = _e1031;
                                                    phi_3830_ = _e1029;
                                                    break if !(_e561);
                                                }
                                            }
                                            let _e1034 = phi_3830_;
                                            phi_3973_ = _e1034;
                                            if _e1034 {
                                                break;
                                            }
                                            let _e1036 = local_10;
                                            let _e1038 = (_e1036.w <= 0f);
                                            if _e1038 {
                                                phi_3947_ = _e1034;
                                                phi_2603_ = vec4<f32>();
                                            } else {
                                                if (_e354 < 10u) {
                                                } else {
                                                    phi_3973_ = true;
                                                    break;
                                                }
                                                let _e1043 = params.member.member_2[_e354];
                                                let _e1044 = (_e357 - 1u);
                                                let _e1055 = ((_e332 * _e359) - 0.5f);
                                                let _e1056 = floor(_e1055);
                                                let _e1057 = (_e1055 - _e1056);
                                                let _e1064 = select(0i, select(select(i32(_e1056), i32(-2147483648), (_e1056 < -2147483600f)), 2147483647i, (_e1056 > 2147483500f)), (_e1056 == _e1056));
                                                let _e1066 = (bitcast<i32>(((_e197.x + _e1044) >> bitcast<u32>(_e355))) - 1i);
                                                if (_e1064 >= 0i) {
                                                    phi_1623_ = (_e1064 <= _e1066);
                                                } else {
                                                    phi_1623_ = false;
                                                }
                                                let _e1070 = phi_1623_;
                                                if (_e1064 >= -1i) {
                                                    phi_1629_ = (_e1064 < _e1066);
                                                } else {
                                                    phi_1629_ = false;
                                                }
                                                let _e1074 = phi_1629_;
                                                if _e1070 {
                                                    phi_1634_ = bitcast<u32>(_e1064);
                                                } else {
                                                    phi_1634_ = 0u;
                                                }
                                                let _e1077 = phi_1634_;
                                                if _e1074 {
                                                    phi_1640_ = bitcast<u32>((_e1064 + 1i));
                                                } else {
                                                    phi_1640_ = 0u;
                                                }
                                                let _e1081 = phi_1640_;
                                                if _e1070 {
                                                    phi_1679_ = (1f - _e1057);
                                                } else {
                                                    phi_1679_ = 0f;
                                                }
                                                let _e1102 = phi_1679_;
                                                let _e1105 = ((_e333 * _e359) - 0.5f);
                                                let _e1107 = floor(_e1105);
                                                let _e1108 = (_e1105 - _e1107);
                                                let _e1115 = select(0i, select(select(i32(_e1107), i32(-2147483648), (_e1107 < -2147483600f)), 2147483647i, (_e1107 > 2147483500f)), (_e1107 == _e1107));
                                                let _e1117 = (bitcast<i32>(((_e197.y + _e1044) >> bitcast<u32>(_e355))) - 1i);
                                                if (_e1115 >= 0i) {
                                                    phi_1705_ = (_e1115 <= _e1117);
                                                } else {
                                                    phi_1705_ = false;
                                                }
                                                let _e1121 = phi_1705_;
                                                if (_e1115 >= -1i) {
                                                    phi_1711_ = (_e1115 < _e1117);
                                                } else {
                                                    phi_1711_ = false;
                                                }
                                                let _e1125 = phi_1711_;
                                                if _e1121 {
                                                    phi_1716_ = bitcast<u32>(_e1115);
                                                } else {
                                                    phi_1716_ = 0u;
                                                }
                                                let _e1128 = phi_1716_;
                                                if _e1125 {
                                                    phi_1722_ = bitcast<u32>((_e1115 + 1i));
                                                } else {
                                                    phi_1722_ = 0u;
                                                }
                                                let _e1132 = phi_1722_;
                                                if _e1121 {
                                                    phi_1761_ = (1f - _e1108);
                                                } else {
                                                    phi_1761_ = 0f;
                                                }
                                                let _e1159 = phi_1761_;
                                                let _e1162 = ((_e334 * _e359) - 0.5f);
                                                let _e1164 = floor(_e1162);
                                                let _e1165 = (_e1162 - _e1164);
                                                let _e1172 = select(0i, select(select(i32(_e1164), i32(-2147483648), (_e1164 < -2147483600f)), 2147483647i, (_e1164 > 2147483500f)), (_e1164 == _e1164));
                                                let _e1174 = (bitcast<i32>(((_e197.z + _e1044) >> bitcast<u32>(_e355))) - 1i);
                                                if (_e1172 >= 0i) {
                                                    phi_1787_ = (_e1172 <= _e1174);
                                                } else {
                                                    phi_1787_ = false;
                                                }
                                                let _e1178 = phi_1787_;
                                                if (_e1172 >= -1i) {
                                                    phi_1793_ = (_e1172 < _e1174);
                                                } else {
                                                    phi_1793_ = false;
                                                }
                                                let _e1182 = phi_1793_;
                                                if _e1178 {
                                                    phi_1798_ = bitcast<u32>(_e1172);
                                                } else {
                                                    phi_1798_ = 0u;
                                                }
                                                let _e1185 = phi_1798_;
                                                if _e1182 {
                                                    phi_1804_ = bitcast<u32>((_e1172 + 1i));
                                                } else {
                                                    phi_1804_ = 0u;
                                                }
                                                let _e1189 = phi_1804_;
                                                if _e1178 {
                                                    phi_1843_ = (1f - _e1165);
                                                } else {
                                                    phi_1843_ = 0f;
                                                }
                                                let _e1204 = phi_1843_;
                                                phi_3856_ = _e1034;
                                                phi_1850_ = type_8(0u, 8u);
                                                phi_1853_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                loop {
                                                    let _e1207 = phi_3856_;
                                                    let _e1209 = phi_1850_;
                                                    let _e1211 = phi_1853_;
                                                    local_21 = _e1211;
                                                    local_22 = _e1211;
                                                    local_23 = _e1211;
                                                    local_24 = _e1211;
                                                    if (_e1209.member < _e1209.member_1) {
                                                        phi_1851_ = type_8((_e1209.member + 1u), _e1209.member_1);
                                                        phi_1876_ = type_8(1u, _e1209.member);
                                                    } else {
                                                        phi_1851_ = _e1209;
                                                        phi_1876_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1224 = phi_1851_;
                                                    let _e1226 = phi_1876_;
                                                    let _e1230 = (bitcast<i32>(_e1226.member) != 0i);
                                                    if _e1230 {
                                                        let _e1232 = ((_e1226.member_1 & 1u) == 1u);
                                                        let _e1234 = ((_e1226.member_1 & 2u) == 2u);
                                                        let _e1236 = ((_e1226.member_1 & 4u) == 4u);
                                                        let _e1241 = ((select(_e1102, select(0f, _e1057, _e1074), _e1232) * select(_e1159, select(0f, _e1108, _e1125), _e1234)) * select(_e1204, select(0f, _e1165, _e1182), _e1236));
                                                        let _e1248 = (((_e1043.z + select((_e1077 >> bitcast<u32>(2u)), (_e1081 >> bitcast<u32>(2u)), _e1232)) + select(((_e1128 >> bitcast<u32>(2u)) * _e1043.x), ((_e1132 >> bitcast<u32>(2u)) * _e1043.x), _e1234)) + select(((_e1185 >> bitcast<u32>(1u)) * _e1043.y), ((_e1189 >> bitcast<u32>(1u)) * _e1043.y), _e1236));
                                                        let _e1254 = (2u * _e1248);
                                                        if (_e1254 < _e63) {
                                                        } else {
                                                            phi_3894_ = true;
                                                            break;
                                                        }
                                                        let _e1257 = cells.member[_e1254];
                                                        if (_e1241 > 0f) {
                                                            let _e1259 = (((select(((_e1077 & 1u) | (((_e1077 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), ((_e1081 & 1u) | (((_e1081 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), _e1232) | select((((_e1128 & 1u) << bitcast<u32>(1u)) | (((_e1128 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), (((_e1132 & 1u) << bitcast<u32>(1u)) | (((_e1132 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), _e1234)) | select(((_e1185 & 1u) << bitcast<u32>(2u)), ((_e1189 & 1u) << bitcast<u32>(2u)), _e1236)) & 31u);
                                                            if (((_e1257 >> bitcast<u32>(_e1259)) & 1u) == 1u) {
                                                                if (_e354 == 0u) {
                                                                    let _e1362 = (_e1248 * 6u);
                                                                    let _e1363 = (_e1254 + 1u);
                                                                    if (_e1363 < _e63) {
                                                                    } else {
                                                                        phi_3894_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1366 = cells.member[_e1363];
                                                                    phi_1975_ = type_8(0u, 6u);
                                                                    phi_1978_ = _e1366;
                                                                    loop {
                                                                        let _e1368 = phi_1975_;
                                                                        let _e1370 = phi_1978_;
                                                                        local_11 = _e1370;
                                                                        local_12 = _e1370;
                                                                        local_19 = _e1370;
                                                                        local_20 = _e1370;
                                                                        if (_e1368.member < _e1368.member_1) {
                                                                            phi_1976_ = type_8((_e1368.member + 1u), _e1368.member_1);
                                                                            phi_2001_ = type_8(1u, _e1368.member);
                                                                        } else {
                                                                            phi_1976_ = _e1368;
                                                                            phi_2001_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e1383 = phi_1976_;
                                                                        let _e1385 = phi_2001_;
                                                                        let _e1389 = (bitcast<i32>(_e1385.member) != 0i);
                                                                        if _e1389 {
                                                                            let _e1390 = (_e1362 + _e1385.member_1);
                                                                            if (_e1390 < _e66) {
                                                                            } else {
                                                                                phi_3842_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1393 = facet_bits.member[_e1390];
                                                                            phi_1979_ = (_e1370 + countOneBits((_e1393 & ((1u << bitcast<u32>(_e1259)) - 1u))));
                                                                        } else {
                                                                            phi_1979_ = u32();
                                                                        }
                                                                        let _e1401 = phi_1979_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_1975_ = _e1383;
                                                                            phi_1978_ = _e1401;
                                                                            phi_3842_ = _e1207;
                                                                            break if !(_e1389);
                                                                        }
                                                                    }
                                                                    let _e1404 = phi_3842_;
                                                                    phi_3894_ = _e1404;
                                                                    if _e1404 {
                                                                        break;
                                                                    }
                                                                    if (_e1362 < _e66) {
                                                                    } else {
                                                                        phi_3894_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1407 = facet_bits.member[_e1362];
                                                                    let _e1411 = (_e1362 + 1u);
                                                                    if (_e1411 < _e66) {
                                                                    } else {
                                                                        phi_3894_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1414 = facet_bits.member[_e1411];
                                                                    let _e1419 = (_e1362 + 2u);
                                                                    if (_e1419 < _e66) {
                                                                    } else {
                                                                        phi_3894_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1422 = facet_bits.member[_e1419];
                                                                    let _e1427 = (_e1362 + 3u);
                                                                    if (_e1427 < _e66) {
                                                                    } else {
                                                                        phi_3894_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1430 = facet_bits.member[_e1427];
                                                                    let _e1435 = (_e1362 + 4u);
                                                                    if (_e1435 < _e66) {
                                                                    } else {
                                                                        phi_3894_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1438 = facet_bits.member[_e1435];
                                                                    let _e1443 = (_e1362 + 5u);
                                                                    if (_e1443 < _e66) {
                                                                    } else {
                                                                        phi_3894_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1446 = facet_bits.member[_e1443];
                                                                    let _e1450 = (((((((_e1407 >> bitcast<u32>(_e1259)) & 1u) + ((_e1414 >> bitcast<u32>(_e1259)) & 1u)) + ((_e1422 >> bitcast<u32>(_e1259)) & 1u)) + ((_e1430 >> bitcast<u32>(_e1259)) & 1u)) + ((_e1438 >> bitcast<u32>(_e1259)) & 1u)) + ((_e1446 >> bitcast<u32>(_e1259)) & 1u));
                                                                    let _e1453 = params.member.member_7;
                                                                    if (_e1453 == 1u) {
                                                                        let _e1578 = local_19;
                                                                        let _e1581 = local_20;
                                                                        phi_2118_ = type_8(_e1581, (_e1578 + _e1450));
                                                                        phi_2121_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e1584 = phi_2118_;
                                                                            let _e1586 = phi_2121_;
                                                                            local_47 = _e1586;
                                                                            if (_e1584.member < _e1584.member_1) {
                                                                                phi_2119_ = type_8((_e1584.member + 1u), _e1584.member_1);
                                                                                phi_2144_ = type_8(1u, _e1584.member);
                                                                            } else {
                                                                                phi_2119_ = _e1584;
                                                                                phi_2144_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e1599 = phi_2119_;
                                                                            let _e1601 = phi_2144_;
                                                                            let _e1605 = (bitcast<i32>(_e1601.member) != 0i);
                                                                            if _e1605 {
                                                                                let _e1606 = (2u * _e1601.member_1);
                                                                                if (_e1606 < _e72) {
                                                                                } else {
                                                                                    phi_3887_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1610 = radiance.member[_e1606][0u];
                                                                                let _e1613 = radiance.member[_e1606][1u];
                                                                                let _e1616 = radiance.member[_e1606][2u];
                                                                                let _e1617 = (_e1606 + 1u);
                                                                                if (_e1617 < _e72) {
                                                                                } else {
                                                                                    phi_3887_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1621 = radiance.member[_e1617][0u];
                                                                                let _e1624 = radiance.member[_e1617][1u];
                                                                                let _e1627 = radiance.member[_e1617][2u];
                                                                                if (_e1601.member_1 < _e69) {
                                                                                } else {
                                                                                    phi_3887_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1637 = facets.member[_e1601.member_1].member_2;
                                                                                let _e1646 = sqrt((((_e1637[0] * _e1637[0]) + (_e1637[1] * _e1637[1])) + (_e1637[2] * _e1637[2])));
                                                                                phi_2122_ = vec4<f32>((_e1586.x + (select(_e1621, _e1610, (_e1610 > _e1621)) * _e1646)), (_e1586.y + (select(_e1624, _e1613, (_e1613 > _e1624)) * _e1646)), (_e1586.z + (select(_e1627, _e1616, (_e1616 > _e1627)) * _e1646)), (_e1586.w + _e1646));
                                                                            } else {
                                                                                phi_2122_ = vec4<f32>();
                                                                            }
                                                                            let _e1660 = phi_2122_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_2118_ = _e1599;
                                                                                phi_2121_ = _e1660;
                                                                                phi_3887_ = _e1404;
                                                                                break if !(_e1605);
                                                                            }
                                                                        }
                                                                        let _e1663 = phi_3887_;
                                                                        phi_3894_ = _e1663;
                                                                        if _e1663 {
                                                                            break;
                                                                        }
                                                                        phi_3904_ = _e1663;
                                                                        let _e2692 = local_47;
                                                                        phi_2386_ = _e2692;
                                                                    } else {
                                                                        let _e1456 = local_11;
                                                                        let _e1459 = local_12;
                                                                        phi_2250_ = type_8(_e1459, (_e1456 + _e1450));
                                                                        phi_2253_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        phi_2255_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e1462 = phi_2250_;
                                                                            let _e1464 = phi_2253_;
                                                                            let _e1466 = phi_2255_;
                                                                            local_13 = _e1464;
                                                                            local_14 = _e1466;
                                                                            local_15 = _e1464;
                                                                            local_16 = _e1464;
                                                                            local_17 = _e1464;
                                                                            local_18 = _e1466;
                                                                            local_46 = _e1466;
                                                                            if (_e1462.member < _e1462.member_1) {
                                                                                phi_2251_ = type_8((_e1462.member + 1u), _e1462.member_1);
                                                                                phi_2278_ = type_8(1u, _e1462.member);
                                                                            } else {
                                                                                phi_2251_ = _e1462;
                                                                                phi_2278_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e1479 = phi_2251_;
                                                                            let _e1481 = phi_2278_;
                                                                            let _e1485 = (bitcast<i32>(_e1481.member) != 0i);
                                                                            if _e1485 {
                                                                                if (_e1481.member_1 < _e69) {
                                                                                } else {
                                                                                    phi_3882_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1489 = facets.member[_e1481.member_1].member_2;
                                                                                let _e1498 = -((((_e147 * _e1489[0]) + (_e148 * _e1489[1])) + (_e149 * _e1489[2])));
                                                                                if (_e1498 > 0f) {
                                                                                    let _e1520 = (2u * _e1481.member_1);
                                                                                    if (_e1520 < _e72) {
                                                                                    } else {
                                                                                        phi_3882_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1523 = radiance.member[_e1520];
                                                                                    phi_2362_ = _e1464;
                                                                                    phi_2363_ = vec4<f32>((_e1466.x + (_e1523.x * _e1498)), (_e1466.y + (_e1523.y * _e1498)), (_e1466.z + (_e1523.z * _e1498)), (_e1466.w + _e1498));
                                                                                } else {
                                                                                    let _e1501 = ((2u * _e1481.member_1) + 1u);
                                                                                    if (_e1501 < _e72) {
                                                                                    } else {
                                                                                        phi_3882_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1504 = radiance.member[_e1501];
                                                                                    phi_2362_ = vec4<f32>((_e1464.x - (_e1504.x * _e1498)), (_e1464.y - (_e1504.y * _e1498)), (_e1464.z - (_e1504.z * _e1498)), (_e1464.w - _e1498));
                                                                                    phi_2363_ = _e1466;
                                                                                }
                                                                                let _e1540 = phi_2362_;
                                                                                let _e1542 = phi_2363_;
                                                                                phi_2254_ = _e1540;
                                                                                phi_2256_ = _e1542;
                                                                            } else {
                                                                                phi_2254_ = vec4<f32>();
                                                                                phi_2256_ = vec4<f32>();
                                                                            }
                                                                            let _e1544 = phi_2254_;
                                                                            let _e1546 = phi_2256_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_2250_ = _e1479;
                                                                                phi_2253_ = _e1544;
                                                                                phi_2255_ = _e1546;
                                                                                phi_3882_ = _e1404;
                                                                                break if !(_e1485);
                                                                            }
                                                                        }
                                                                        let _e1549 = phi_3882_;
                                                                        phi_3894_ = _e1549;
                                                                        if _e1549 {
                                                                            break;
                                                                        }
                                                                        let _e1551 = local_13;
                                                                        let _e1554 = local_14;
                                                                        if (_e1551.w > _e1554.w) {
                                                                            let _e1557 = (_e1551.w - _e1554.w);
                                                                            let _e1558 = (_e1557 / _e1551.w);
                                                                            let _e1560 = local_15;
                                                                            let _e1564 = local_16;
                                                                            let _e1568 = local_17;
                                                                            let _e1573 = local_18;
                                                                            phi_2385_ = (_e1573 + vec4<f32>((_e1560.x * _e1558), (_e1564.y * _e1558), (_e1568.z * _e1558), _e1557));
                                                                        } else {
                                                                            let _e2680 = local_46;
                                                                            phi_2385_ = _e2680;
                                                                        }
                                                                        let _e1576 = phi_2385_;
                                                                        phi_3904_ = _e1549;
                                                                        phi_2386_ = _e1576;
                                                                    }
                                                                    let _e1665 = phi_3904_;
                                                                    let _e1667 = phi_2386_;
                                                                    phi_3898_ = _e1665;
                                                                    phi_2555_ = _e1667;
                                                                } else {
                                                                    let _e1265 = (_e1254 + 1u);
                                                                    if (_e1265 < _e63) {
                                                                    } else {
                                                                        phi_3894_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1268 = cells.member[_e1265];
                                                                    let _e1274 = (_e1268 + countOneBits((_e1257 & ((1u << bitcast<u32>(_e1259)) - 1u))));
                                                                    let _e1277 = params.member.member_7;
                                                                    if (_e1277 == 1u) {
                                                                        if ((_e354 & 1u) == 1u) {
                                                                            if (_e1274 < _e75) {
                                                                            } else {
                                                                                phi_3894_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1357 = odd.member[_e1274];
                                                                            phi_2433_ = _e1357;
                                                                        } else {
                                                                            if (_e1274 < _e78) {
                                                                            } else {
                                                                                phi_3894_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1354 = even.member[_e1274];
                                                                            phi_2433_ = _e1354;
                                                                        }
                                                                        let _e1359 = phi_2433_;
                                                                        phi_2554_ = _e1359;
                                                                    } else {
                                                                        let _e1279 = (_e1274 * 6u);
                                                                        let _e1282 = (_e1279 + select(0u, 1u, (_e147 < 0f)));
                                                                        let _e1284 = ((_e354 & 1u) == 1u);
                                                                        if _e1284 {
                                                                            if (_e1282 < _e75) {
                                                                            } else {
                                                                                phi_3894_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1290 = odd.member[_e1282];
                                                                            phi_2461_ = _e1290;
                                                                        } else {
                                                                            if (_e1282 < _e78) {
                                                                            } else {
                                                                                phi_3894_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1287 = even.member[_e1282];
                                                                            phi_2461_ = _e1287;
                                                                        }
                                                                        let _e1292 = phi_2461_;
                                                                        let _e1304 = ((_e1279 + 2u) + select(0u, 1u, (_e148 < 0f)));
                                                                        if _e1284 {
                                                                            if (_e1304 < _e75) {
                                                                            } else {
                                                                                phi_3894_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1310 = odd.member[_e1304];
                                                                            phi_2498_ = _e1310;
                                                                        } else {
                                                                            if (_e1304 < _e78) {
                                                                            } else {
                                                                                phi_3894_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1307 = even.member[_e1304];
                                                                            phi_2498_ = _e1307;
                                                                        }
                                                                        let _e1312 = phi_2498_;
                                                                        let _e1328 = ((_e1279 + 4u) + select(0u, 1u, (_e149 < 0f)));
                                                                        if _e1284 {
                                                                            if (_e1328 < _e75) {
                                                                            } else {
                                                                                phi_3894_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1334 = odd.member[_e1328];
                                                                            phi_2539_ = _e1334;
                                                                        } else {
                                                                            if (_e1328 < _e78) {
                                                                            } else {
                                                                                phi_3894_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1331 = even.member[_e1328];
                                                                            phi_2539_ = _e1331;
                                                                        }
                                                                        let _e1336 = phi_2539_;
                                                                        phi_2554_ = vec4<f32>((((_e1292.x * _e204) + (_e1312.x * _e214)) + (_e1336.x * _e224)), (((_e1292.y * _e204) + (_e1312.y * _e214)) + (_e1336.y * _e224)), (((_e1292.z * _e204) + (_e1312.z * _e214)) + (_e1336.z * _e224)), (((_e1292.w * _e204) + (_e1312.w * _e214)) + (_e1336.w * _e224)));
                                                                    }
                                                                    let _e1361 = phi_2554_;
                                                                    phi_3898_ = _e1207;
                                                                    phi_2555_ = _e1361;
                                                                }
                                                                let _e1669 = phi_3898_;
                                                                let _e1671 = phi_2555_;
                                                                phi_3897_ = _e1669;
                                                                phi_2576_ = vec4<f32>((_e1211.x + (_e1671.x * _e1241)), (_e1211.y + (_e1671.y * _e1241)), (_e1211.z + (_e1671.z * _e1241)), (_e1211.w + (_e1671.w * _e1241)));
                                                            } else {
                                                                phi_3897_ = _e1207;
                                                                phi_2576_ = _e1211;
                                                            }
                                                            let _e1690 = phi_3897_;
                                                            let _e1692 = phi_2576_;
                                                            phi_3896_ = _e1690;
                                                            phi_2577_ = _e1692;
                                                        } else {
                                                            phi_3896_ = _e1207;
                                                            phi_2577_ = _e1211;
                                                        }
                                                        let _e1694 = phi_3896_;
                                                        let _e1696 = phi_2577_;
                                                        phi_3895_ = _e1694;
                                                        phi_1854_ = _e1696;
                                                    } else {
                                                        phi_3895_ = _e1207;
                                                        phi_1854_ = vec4<f32>();
                                                    }
                                                    let _e1698 = phi_3895_;
                                                    let _e1700 = phi_1854_;
                                                    continue;
                                                    continuing {
                                                        phi_3856_ = _e1698;
                                                        phi_1850_ = _e1224;
                                                        phi_1853_ = _e1700;
                                                        phi_3894_ = _e1698;
                                                        break if !(_e1230);
                                                    }
                                                }
                                                let _e1703 = phi_3894_;
                                                phi_3973_ = _e1703;
                                                if _e1703 {
                                                    break;
                                                }
                                                let _e1705 = ((2f - _e360) * _e359);
                                                let _e1707 = local_21;
                                                let _e1711 = local_22;
                                                let _e1715 = local_23;
                                                let _e1719 = local_24;
                                                let _e1723 = ((_e361 * 0.5f) * _e359);
                                                let _e1725 = local_25;
                                                let _e1729 = local_26;
                                                let _e1733 = local_27;
                                                phi_3947_ = _e1703;
                                                phi_2603_ = vec4<f32>(((_e1707.x * _e1705) + (_e1725.x * _e1723)), ((_e1711.y * _e1705) + (_e1729.y * _e1723)), ((_e1715.z * _e1705) + (_e1733.z * _e1723)), ((_e1719.w * _e1705) + (_e1036.w * _e1723)));
                                            }
                                            let _e1743 = phi_3947_;
                                            let _e1745 = phi_2603_;
                                            phi_3946_ = _e1743;
                                            phi_2604_ = _e1745;
                                            phi_2605_ = _e1038;
                                        }
                                        let _e1747 = phi_3946_;
                                        let _e1749 = phi_2604_;
                                        let _e1751 = phi_2605_;
                                        phi_3945_ = _e1747;
                                        phi_2606_ = _e1749;
                                        phi_2607_ = _e363;
                                        phi_2608_ = _e1751;
                                    }
                                    let _e1753 = phi_3945_;
                                    let _e1755 = phi_2606_;
                                    let _e1757 = phi_2607_;
                                    let _e1759 = phi_2608_;
                                    if _e1757 {
                                        if (_e354 < 10u) {
                                        } else {
                                            phi_3973_ = true;
                                            break;
                                        }
                                        let _e1764 = params.member.member_2[_e354];
                                        let _e1765 = (_e357 - 1u);
                                        let _e1776 = ((_e332 * _e359) - 0.5f);
                                        let _e1777 = floor(_e1776);
                                        let _e1778 = (_e1776 - _e1777);
                                        let _e1785 = select(0i, select(select(i32(_e1777), i32(-2147483648), (_e1777 < -2147483600f)), 2147483647i, (_e1777 > 2147483500f)), (_e1777 == _e1777));
                                        let _e1787 = (bitcast<i32>(((_e197.x + _e1765) >> bitcast<u32>(_e355))) - 1i);
                                        if (_e1785 >= 0i) {
                                            phi_2661_ = (_e1785 <= _e1787);
                                        } else {
                                            phi_2661_ = false;
                                        }
                                        let _e1791 = phi_2661_;
                                        if (_e1785 >= -1i) {
                                            phi_2667_ = (_e1785 < _e1787);
                                        } else {
                                            phi_2667_ = false;
                                        }
                                        let _e1795 = phi_2667_;
                                        if _e1791 {
                                            phi_2672_ = bitcast<u32>(_e1785);
                                        } else {
                                            phi_2672_ = 0u;
                                        }
                                        let _e1798 = phi_2672_;
                                        if _e1795 {
                                            phi_2678_ = bitcast<u32>((_e1785 + 1i));
                                        } else {
                                            phi_2678_ = 0u;
                                        }
                                        let _e1802 = phi_2678_;
                                        if _e1791 {
                                            phi_2717_ = (1f - _e1778);
                                        } else {
                                            phi_2717_ = 0f;
                                        }
                                        let _e1823 = phi_2717_;
                                        let _e1826 = ((_e333 * _e359) - 0.5f);
                                        let _e1828 = floor(_e1826);
                                        let _e1829 = (_e1826 - _e1828);
                                        let _e1836 = select(0i, select(select(i32(_e1828), i32(-2147483648), (_e1828 < -2147483600f)), 2147483647i, (_e1828 > 2147483500f)), (_e1828 == _e1828));
                                        let _e1838 = (bitcast<i32>(((_e197.y + _e1765) >> bitcast<u32>(_e355))) - 1i);
                                        if (_e1836 >= 0i) {
                                            phi_2743_ = (_e1836 <= _e1838);
                                        } else {
                                            phi_2743_ = false;
                                        }
                                        let _e1842 = phi_2743_;
                                        if (_e1836 >= -1i) {
                                            phi_2749_ = (_e1836 < _e1838);
                                        } else {
                                            phi_2749_ = false;
                                        }
                                        let _e1846 = phi_2749_;
                                        if _e1842 {
                                            phi_2754_ = bitcast<u32>(_e1836);
                                        } else {
                                            phi_2754_ = 0u;
                                        }
                                        let _e1849 = phi_2754_;
                                        if _e1846 {
                                            phi_2760_ = bitcast<u32>((_e1836 + 1i));
                                        } else {
                                            phi_2760_ = 0u;
                                        }
                                        let _e1853 = phi_2760_;
                                        if _e1842 {
                                            phi_2799_ = (1f - _e1829);
                                        } else {
                                            phi_2799_ = 0f;
                                        }
                                        let _e1880 = phi_2799_;
                                        let _e1883 = ((_e334 * _e359) - 0.5f);
                                        let _e1885 = floor(_e1883);
                                        let _e1886 = (_e1883 - _e1885);
                                        let _e1893 = select(0i, select(select(i32(_e1885), i32(-2147483648), (_e1885 < -2147483600f)), 2147483647i, (_e1885 > 2147483500f)), (_e1885 == _e1885));
                                        let _e1895 = (bitcast<i32>(((_e197.z + _e1765) >> bitcast<u32>(_e355))) - 1i);
                                        if (_e1893 >= 0i) {
                                            phi_2825_ = (_e1893 <= _e1895);
                                        } else {
                                            phi_2825_ = false;
                                        }
                                        let _e1899 = phi_2825_;
                                        if (_e1893 >= -1i) {
                                            phi_2831_ = (_e1893 < _e1895);
                                        } else {
                                            phi_2831_ = false;
                                        }
                                        let _e1903 = phi_2831_;
                                        if _e1899 {
                                            phi_2836_ = bitcast<u32>(_e1893);
                                        } else {
                                            phi_2836_ = 0u;
                                        }
                                        let _e1906 = phi_2836_;
                                        if _e1903 {
                                            phi_2842_ = bitcast<u32>((_e1893 + 1i));
                                        } else {
                                            phi_2842_ = 0u;
                                        }
                                        let _e1910 = phi_2842_;
                                        if _e1899 {
                                            phi_2881_ = (1f - _e1886);
                                        } else {
                                            phi_2881_ = 0f;
                                        }
                                        let _e1925 = phi_2881_;
                                        phi_3920_ = _e1753;
                                        phi_2888_ = type_8(0u, 8u);
                                        phi_2891_ = vec4<f32>(0f, 0f, 0f, 0f);
                                        loop {
                                            let _e1928 = phi_3920_;
                                            let _e1930 = phi_2888_;
                                            let _e1932 = phi_2891_;
                                            local_38 = _e1932;
                                            if (_e1930.member < _e1930.member_1) {
                                                phi_2889_ = type_8((_e1930.member + 1u), _e1930.member_1);
                                                phi_2914_ = type_8(1u, _e1930.member);
                                            } else {
                                                phi_2889_ = _e1930;
                                                phi_2914_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1945 = phi_2889_;
                                            let _e1947 = phi_2914_;
                                            let _e1951 = (bitcast<i32>(_e1947.member) != 0i);
                                            if _e1951 {
                                                let _e1953 = ((_e1947.member_1 & 1u) == 1u);
                                                let _e1955 = ((_e1947.member_1 & 2u) == 2u);
                                                let _e1957 = ((_e1947.member_1 & 4u) == 4u);
                                                let _e1962 = ((select(_e1823, select(0f, _e1778, _e1795), _e1953) * select(_e1880, select(0f, _e1829, _e1846), _e1955)) * select(_e1925, select(0f, _e1886, _e1903), _e1957));
                                                let _e1969 = (((_e1764.z + select((_e1798 >> bitcast<u32>(2u)), (_e1802 >> bitcast<u32>(2u)), _e1953)) + select(((_e1849 >> bitcast<u32>(2u)) * _e1764.x), ((_e1853 >> bitcast<u32>(2u)) * _e1764.x), _e1955)) + select(((_e1906 >> bitcast<u32>(1u)) * _e1764.y), ((_e1910 >> bitcast<u32>(1u)) * _e1764.y), _e1957));
                                                let _e1975 = (2u * _e1969);
                                                if (_e1975 < _e63) {
                                                } else {
                                                    phi_3961_ = true;
                                                    break;
                                                }
                                                let _e1978 = cells.member[_e1975];
                                                if (_e1962 > 0f) {
                                                    let _e1980 = (((select(((_e1798 & 1u) | (((_e1798 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), ((_e1802 & 1u) | (((_e1802 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), _e1953) | select((((_e1849 & 1u) << bitcast<u32>(1u)) | (((_e1849 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), (((_e1853 & 1u) << bitcast<u32>(1u)) | (((_e1853 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), _e1955)) | select(((_e1906 & 1u) << bitcast<u32>(2u)), ((_e1910 & 1u) << bitcast<u32>(2u)), _e1957)) & 31u);
                                                    if (((_e1978 >> bitcast<u32>(_e1980)) & 1u) == 1u) {
                                                        if (_e354 == 0u) {
                                                            let _e2083 = (_e1969 * 6u);
                                                            let _e2084 = (_e1975 + 1u);
                                                            if (_e2084 < _e63) {
                                                            } else {
                                                                phi_3961_ = true;
                                                                break;
                                                            }
                                                            let _e2087 = cells.member[_e2084];
                                                            phi_3013_ = type_8(0u, 6u);
                                                            phi_3016_ = _e2087;
                                                            loop {
                                                                let _e2089 = phi_3013_;
                                                                let _e2091 = phi_3016_;
                                                                local_28 = _e2091;
                                                                local_29 = _e2091;
                                                                local_36 = _e2091;
                                                                local_37 = _e2091;
                                                                if (_e2089.member < _e2089.member_1) {
                                                                    phi_3014_ = type_8((_e2089.member + 1u), _e2089.member_1);
                                                                    phi_3039_ = type_8(1u, _e2089.member);
                                                                } else {
                                                                    phi_3014_ = _e2089;
                                                                    phi_3039_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e2104 = phi_3014_;
                                                                let _e2106 = phi_3039_;
                                                                let _e2110 = (bitcast<i32>(_e2106.member) != 0i);
                                                                if _e2110 {
                                                                    let _e2111 = (_e2083 + _e2106.member_1);
                                                                    if (_e2111 < _e66) {
                                                                    } else {
                                                                        phi_3906_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2114 = facet_bits.member[_e2111];
                                                                    phi_3017_ = (_e2091 + countOneBits((_e2114 & ((1u << bitcast<u32>(_e1980)) - 1u))));
                                                                } else {
                                                                    phi_3017_ = u32();
                                                                }
                                                                let _e2122 = phi_3017_;
                                                                continue;
                                                                continuing {
                                                                    phi_3013_ = _e2104;
                                                                    phi_3016_ = _e2122;
                                                                    phi_3906_ = _e1928;
                                                                    break if !(_e2110);
                                                                }
                                                            }
                                                            let _e2125 = phi_3906_;
                                                            phi_3961_ = _e2125;
                                                            if _e2125 {
                                                                break;
                                                            }
                                                            if (_e2083 < _e66) {
                                                            } else {
                                                                phi_3961_ = true;
                                                                break;
                                                            }
                                                            let _e2128 = facet_bits.member[_e2083];
                                                            let _e2132 = (_e2083 + 1u);
                                                            if (_e2132 < _e66) {
                                                            } else {
                                                                phi_3961_ = true;
                                                                break;
                                                            }
                                                            let _e2135 = facet_bits.member[_e2132];
                                                            let _e2140 = (_e2083 + 2u);
                                                            if (_e2140 < _e66) {
                                                            } else {
                                                                phi_3961_ = true;
                                                                break;
                                                            }
                                                            let _e2143 = facet_bits.member[_e2140];
                                                            let _e2148 = (_e2083 + 3u);
                                                            if (_e2148 < _e66) {
                                                            } else {
                                                                phi_3961_ = true;
                                                                break;
                                                            }
                                                            let _e2151 = facet_bits.member[_e2148];
                                                            let _e2156 = (_e2083 + 4u);
                                                            if (_e2156 < _e66) {
                                                            } else {
                                                                phi_3961_ = true;
                                                                break;
                                                            }
                                                            let _e2159 = facet_bits.member[_e2156];
                                                            let _e2164 = (_e2083 + 5u);
                                                            if (_e2164 < _e66) {
                                                            } else {
                                                                phi_3961_ = true;
                                                                break;
                                                            }
                                                            let _e2167 = facet_bits.member[_e2164];
                                                            let _e2171 = (((((((_e2128 >> bitcast<u32>(_e1980)) & 1u) + ((_e2135 >> bitcast<u32>(_e1980)) & 1u)) + ((_e2143 >> bitcast<u32>(_e1980)) & 1u)) + ((_e2151 >> bitcast<u32>(_e1980)) & 1u)) + ((_e2159 >> bitcast<u32>(_e1980)) & 1u)) + ((_e2167 >> bitcast<u32>(_e1980)) & 1u));
                                                            let _e2174 = params.member.member_7;
                                                            if (_e2174 == 1u) {
                                                                let _e2299 = local_36;
                                                                let _e2302 = local_37;
                                                                phi_3156_ = type_8(_e2302, (_e2299 + _e2171));
                                                                phi_3159_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                loop {
                                                                    let _e2305 = phi_3156_;
                                                                    let _e2307 = phi_3159_;
                                                                    local_49 = _e2307;
                                                                    if (_e2305.member < _e2305.member_1) {
                                                                        phi_3157_ = type_8((_e2305.member + 1u), _e2305.member_1);
                                                                        phi_3182_ = type_8(1u, _e2305.member);
                                                                    } else {
                                                                        phi_3157_ = _e2305;
                                                                        phi_3182_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e2320 = phi_3157_;
                                                                    let _e2322 = phi_3182_;
                                                                    let _e2326 = (bitcast<i32>(_e2322.member) != 0i);
                                                                    if _e2326 {
                                                                        let _e2327 = (2u * _e2322.member_1);
                                                                        if (_e2327 < _e72) {
                                                                        } else {
                                                                            phi_3954_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2331 = radiance.member[_e2327][0u];
                                                                        let _e2334 = radiance.member[_e2327][1u];
                                                                        let _e2337 = radiance.member[_e2327][2u];
                                                                        let _e2338 = (_e2327 + 1u);
                                                                        if (_e2338 < _e72) {
                                                                        } else {
                                                                            phi_3954_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2342 = radiance.member[_e2338][0u];
                                                                        let _e2345 = radiance.member[_e2338][1u];
                                                                        let _e2348 = radiance.member[_e2338][2u];
                                                                        if (_e2322.member_1 < _e69) {
                                                                        } else {
                                                                            phi_3954_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2358 = facets.member[_e2322.member_1].member_2;
                                                                        let _e2367 = sqrt((((_e2358[0] * _e2358[0]) + (_e2358[1] * _e2358[1])) + (_e2358[2] * _e2358[2])));
                                                                        phi_3160_ = vec4<f32>((_e2307.x + (select(_e2342, _e2331, (_e2331 > _e2342)) * _e2367)), (_e2307.y + (select(_e2345, _e2334, (_e2334 > _e2345)) * _e2367)), (_e2307.z + (select(_e2348, _e2337, (_e2337 > _e2348)) * _e2367)), (_e2307.w + _e2367));
                                                                    } else {
                                                                        phi_3160_ = vec4<f32>();
                                                                    }
                                                                    let _e2381 = phi_3160_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_3156_ = _e2320;
                                                                        phi_3159_ = _e2381;
                                                                        phi_3954_ = _e2125;
                                                                        break if !(_e2326);
                                                                    }
                                                                }
                                                                let _e2384 = phi_3954_;
                                                                phi_3961_ = _e2384;
                                                                if _e2384 {
                                                                    break;
                                                                }
                                                                phi_3971_ = _e2384;
                                                                let _e2781 = local_49;
                                                                phi_3424_ = _e2781;
                                                            } else {
                                                                let _e2177 = local_28;
                                                                let _e2180 = local_29;
                                                                phi_3288_ = type_8(_e2180, (_e2177 + _e2171));
                                                                phi_3291_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                phi_3293_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                loop {
                                                                    let _e2183 = phi_3288_;
                                                                    let _e2185 = phi_3291_;
                                                                    let _e2187 = phi_3293_;
                                                                    local_30 = _e2185;
                                                                    local_31 = _e2187;
                                                                    local_32 = _e2185;
                                                                    local_33 = _e2185;
                                                                    local_34 = _e2185;
                                                                    local_35 = _e2187;
                                                                    local_48 = _e2187;
                                                                    if (_e2183.member < _e2183.member_1) {
                                                                        phi_3289_ = type_8((_e2183.member + 1u), _e2183.member_1);
                                                                        phi_3316_ = type_8(1u, _e2183.member);
                                                                    } else {
                                                                        phi_3289_ = _e2183;
                                                                        phi_3316_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e2200 = phi_3289_;
                                                                    let _e2202 = phi_3316_;
                                                                    let _e2206 = (bitcast<i32>(_e2202.member) != 0i);
                                                                    if _e2206 {
                                                                        if (_e2202.member_1 < _e69) {
                                                                        } else {
                                                                            phi_3949_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2210 = facets.member[_e2202.member_1].member_2;
                                                                        let _e2219 = -((((_e147 * _e2210[0]) + (_e148 * _e2210[1])) + (_e149 * _e2210[2])));
                                                                        if (_e2219 > 0f) {
                                                                            let _e2241 = (2u * _e2202.member_1);
                                                                            if (_e2241 < _e72) {
                                                                            } else {
                                                                                phi_3949_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2244 = radiance.member[_e2241];
                                                                            phi_3400_ = _e2185;
                                                                            phi_3401_ = vec4<f32>((_e2187.x + (_e2244.x * _e2219)), (_e2187.y + (_e2244.y * _e2219)), (_e2187.z + (_e2244.z * _e2219)), (_e2187.w + _e2219));
                                                                        } else {
                                                                            let _e2222 = ((2u * _e2202.member_1) + 1u);
                                                                            if (_e2222 < _e72) {
                                                                            } else {
                                                                                phi_3949_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2225 = radiance.member[_e2222];
                                                                            phi_3400_ = vec4<f32>((_e2185.x - (_e2225.x * _e2219)), (_e2185.y - (_e2225.y * _e2219)), (_e2185.z - (_e2225.z * _e2219)), (_e2185.w - _e2219));
                                                                            phi_3401_ = _e2187;
                                                                        }
                                                                        let _e2261 = phi_3400_;
                                                                        let _e2263 = phi_3401_;
                                                                        phi_3292_ = _e2261;
                                                                        phi_3294_ = _e2263;
                                                                    } else {
                                                                        phi_3292_ = vec4<f32>();
                                                                        phi_3294_ = vec4<f32>();
                                                                    }
                                                                    let _e2265 = phi_3292_;
                                                                    let _e2267 = phi_3294_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_3288_ = _e2200;
                                                                        phi_3291_ = _e2265;
                                                                        phi_3293_ = _e2267;
                                                                        phi_3949_ = _e2125;
                                                                        break if !(_e2206);
                                                                    }
                                                                }
                                                                let _e2270 = phi_3949_;
                                                                phi_3961_ = _e2270;
                                                                if _e2270 {
                                                                    break;
                                                                }
                                                                let _e2272 = local_30;
                                                                let _e2275 = local_31;
                                                                if (_e2272.w > _e2275.w) {
                                                                    let _e2278 = (_e2272.w - _e2275.w);
                                                                    let _e2279 = (_e2278 / _e2272.w);
                                                                    let _e2281 = local_32;
                                                                    let _e2285 = local_33;
                                                                    let _e2289 = local_34;
                                                                    let _e2294 = local_35;
                                                                    phi_3423_ = (_e2294 + vec4<f32>((_e2281.x * _e2279), (_e2285.y * _e2279), (_e2289.z * _e2279), _e2278));
                                                                } else {
                                                                    let _e2769 = local_48;
                                                                    phi_3423_ = _e2769;
                                                                }
                                                                let _e2297 = phi_3423_;
                                                                phi_3971_ = _e2270;
                                                                phi_3424_ = _e2297;
                                                            }
                                                            let _e2386 = phi_3971_;
                                                            let _e2388 = phi_3424_;
                                                            phi_3965_ = _e2386;
                                                            phi_3593_ = _e2388;
                                                        } else {
                                                            let _e1986 = (_e1975 + 1u);
                                                            if (_e1986 < _e63) {
                                                            } else {
                                                                phi_3961_ = true;
                                                                break;
                                                            }
                                                            let _e1989 = cells.member[_e1986];
                                                            let _e1995 = (_e1989 + countOneBits((_e1978 & ((1u << bitcast<u32>(_e1980)) - 1u))));
                                                            let _e1998 = params.member.member_7;
                                                            if (_e1998 == 1u) {
                                                                if ((_e354 & 1u) == 1u) {
                                                                    if (_e1995 < _e75) {
                                                                    } else {
                                                                        phi_3961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2078 = odd.member[_e1995];
                                                                    phi_3471_ = _e2078;
                                                                } else {
                                                                    if (_e1995 < _e78) {
                                                                    } else {
                                                                        phi_3961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2075 = even.member[_e1995];
                                                                    phi_3471_ = _e2075;
                                                                }
                                                                let _e2080 = phi_3471_;
                                                                phi_3592_ = _e2080;
                                                            } else {
                                                                let _e2000 = (_e1995 * 6u);
                                                                let _e2003 = (_e2000 + select(0u, 1u, (_e147 < 0f)));
                                                                let _e2005 = ((_e354 & 1u) == 1u);
                                                                if _e2005 {
                                                                    if (_e2003 < _e75) {
                                                                    } else {
                                                                        phi_3961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2011 = odd.member[_e2003];
                                                                    phi_3499_ = _e2011;
                                                                } else {
                                                                    if (_e2003 < _e78) {
                                                                    } else {
                                                                        phi_3961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2008 = even.member[_e2003];
                                                                    phi_3499_ = _e2008;
                                                                }
                                                                let _e2013 = phi_3499_;
                                                                let _e2025 = ((_e2000 + 2u) + select(0u, 1u, (_e148 < 0f)));
                                                                if _e2005 {
                                                                    if (_e2025 < _e75) {
                                                                    } else {
                                                                        phi_3961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2031 = odd.member[_e2025];
                                                                    phi_3536_ = _e2031;
                                                                } else {
                                                                    if (_e2025 < _e78) {
                                                                    } else {
                                                                        phi_3961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2028 = even.member[_e2025];
                                                                    phi_3536_ = _e2028;
                                                                }
                                                                let _e2033 = phi_3536_;
                                                                let _e2049 = ((_e2000 + 4u) + select(0u, 1u, (_e149 < 0f)));
                                                                if _e2005 {
                                                                    if (_e2049 < _e75) {
                                                                    } else {
                                                                        phi_3961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2055 = odd.member[_e2049];
                                                                    phi_3577_ = _e2055;
                                                                } else {
                                                                    if (_e2049 < _e78) {
                                                                    } else {
                                                                        phi_3961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e2052 = even.member[_e2049];
                                                                    phi_3577_ = _e2052;
                                                                }
                                                                let _e2057 = phi_3577_;
                                                                phi_3592_ = vec4<f32>((((_e2013.x * _e204) + (_e2033.x * _e214)) + (_e2057.x * _e224)), (((_e2013.y * _e204) + (_e2033.y * _e214)) + (_e2057.y * _e224)), (((_e2013.z * _e204) + (_e2033.z * _e214)) + (_e2057.z * _e224)), (((_e2013.w * _e204) + (_e2033.w * _e214)) + (_e2057.w * _e224)));
                                                            }
                                                            let _e2082 = phi_3592_;
                                                            phi_3965_ = _e1928;
                                                            phi_3593_ = _e2082;
                                                        }
                                                        let _e2390 = phi_3965_;
                                                        let _e2392 = phi_3593_;
                                                        phi_3964_ = _e2390;
                                                        phi_3614_ = vec4<f32>((_e1932.x + (_e2392.x * _e1962)), (_e1932.y + (_e2392.y * _e1962)), (_e1932.z + (_e2392.z * _e1962)), (_e1932.w + (_e2392.w * _e1962)));
                                                    } else {
                                                        phi_3964_ = _e1928;
                                                        phi_3614_ = _e1932;
                                                    }
                                                    let _e2411 = phi_3964_;
                                                    let _e2413 = phi_3614_;
                                                    phi_3963_ = _e2411;
                                                    phi_3615_ = _e2413;
                                                } else {
                                                    phi_3963_ = _e1928;
                                                    phi_3615_ = _e1932;
                                                }
                                                let _e2415 = phi_3963_;
                                                let _e2417 = phi_3615_;
                                                phi_3962_ = _e2415;
                                                phi_2892_ = _e2417;
                                            } else {
                                                phi_3962_ = _e1928;
                                                phi_2892_ = vec4<f32>();
                                            }
                                            let _e2419 = phi_3962_;
                                            let _e2421 = phi_2892_;
                                            continue;
                                            continuing {
                                                phi_3920_ = _e2419;
                                                phi_2888_ = _e1945;
                                                phi_2891_ = _e2421;
                                                phi_3961_ = _e2419;
                                                break if !(_e1951);
                                            }
                                        }
                                        let _e2424 = phi_3961_;
                                        phi_3973_ = _e2424;
                                        if _e2424 {
                                            break;
                                        }
                                        let _e2426 = local_38;
                                        phi_3979_ = _e2424;
                                        phi_3617_ = (_e2426 * _e359);
                                    } else {
                                        phi_3979_ = _e1753;
                                        phi_3617_ = vec4<f32>(0f, 0f, 0f, 0f);
                                    }
                                    let _e2429 = phi_3979_;
                                    let _e2431 = phi_3617_;
                                    let _e2434 = select(_e1755, _e2431, vec4(select(_e1759, true, _e1757)));
                                    let _e2436 = (_e2434.w * _e326);
                                    let _e2437 = (_e2436 > 0f);
                                    if _e2437 {
                                        let _e2439 = select(_e316, _e2436, (_e2436 < _e316));
                                        let _e2445 = (((_e326 * _e296) * _e2439) / _e2436);
                                        phi_3656_ = vec3<f32>((_e290.x + (_e2434.x * _e2445)), (_e290.y + (_e2434.y * _e2445)), (_e290.z + (_e2434.z * _e2445)));
                                        phi_3657_ = (_e294 + _e2439);
                                    } else {
                                        phi_3656_ = _e290;
                                        phi_3657_ = 0f;
                                    }
                                    let _e2458 = phi_3656_;
                                    let _e2460 = phi_3657_;
                                    phi_3976_ = _e2429;
                                    phi_3660_ = _e2458;
                                    phi_3661_ = (_e292 + _e326);
                                    phi_3662_ = _e2460;
                                    phi_3663_ = select(_e317, _e296, _e2437);
                                }
                                let _e2464 = phi_3976_;
                                let _e2466 = phi_3660_;
                                let _e2468 = phi_3661_;
                                let _e2470 = phi_3662_;
                                let _e2472 = phi_3663_;
                                phi_3975_ = _e2464;
                                phi_3665_ = _e2466;
                                phi_3666_ = _e2468;
                                phi_3667_ = _e2470;
                                phi_3668_ = _e2472;
                                phi_3669_ = select(true, false, _e318);
                            }
                            let _e2475 = phi_3975_;
                            let _e2477 = phi_3665_;
                            let _e2479 = phi_3666_;
                            let _e2481 = phi_3667_;
                            let _e2483 = phi_3668_;
                            let _e2485 = phi_3669_;
                            phi_3974_ = _e2475;
                            phi_451_ = _e2477;
                            phi_453_ = _e2479;
                            phi_455_ = _e2481;
                            phi_457_ = _e2483;
                            phi_3671_ = _e2485;
                        } else {
                            phi_3974_ = _e286;
                            phi_451_ = vec3<f32>();
                            phi_453_ = f32();
                            phi_455_ = f32();
                            phi_457_ = f32();
                            phi_3671_ = false;
                        }
                        let _e2487 = phi_3974_;
                        let _e2489 = phi_451_;
                        let _e2491 = phi_453_;
                        let _e2493 = phi_455_;
                        let _e2495 = phi_457_;
                        let _e2497 = phi_3671_;
                        continue;
                        continuing {
                            phi_3793_ = _e2487;
                            phi_447_ = _e309;
                            phi_450_ = _e2489;
                            phi_452_ = _e2491;
                            phi_454_ = _e2493;
                            phi_456_ = _e2495;
                            phi_3973_ = _e2487;
                            break if !(_e2497);
                        }
                    }
                    let _e2500 = phi_3973_;
                    if _e2500 {
                        break;
                    }
                    let _e2502 = local_39;
                    let _e2505 = local_40;
                    let _e2506 = (_e2505 * (1f - _e2502));
                    let _e2508 = local_41;
                    let _e2511 = local_42;
                    let _e2514 = local_43;
                    let _e2518 = params.member.member_4;
                    phi_3698_ = vec4<f32>((_e2508.x + (_e2518.x * _e2506)), (_e2511.y + (_e2518.y * _e2506)), (_e2514.z + (_e2518.z * _e2506)), _e2506);
                }
                let _e2530 = phi_3698_;
                if _e87 {
                } else {
                    break;
                }
                out.member[_e86] = _e2530;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn cone_glossy(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
