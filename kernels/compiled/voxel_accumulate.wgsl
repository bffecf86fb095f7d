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
    var phi_701_: u32;
    var phi_704_: u32;
    var phi_702_: u32;
    var phi_705_: u32;
    var phi_4300_: bool;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_817_: bool;
    var phi_826_: u32;
    var phi_846_: vec3<f32>;
    var phi_847_: vec3<f32>;
    var phi_858_: vec3<f32>;
    var phi_859_: vec3<f32>;
    var phi_870_: vec3<f32>;
    var phi_871_: vec3<f32>;
    var phi_882_: vec3<f32>;
    var phi_883_: vec3<f32>;
    var phi_1019_: bool;
    var phi_1028_: u32;
    var phi_1038_: f32;
    var phi_1058_: vec3<f32>;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_1182_: u32;
    var phi_3665_: bool;
    var phi_3704_: bool;
    var phi_3743_: bool;
    var phi_1378_: bool;
    var phi_1379_: bool;
    var phi_1380_: bool;
    var phi_1389_: type_39;
    var phi_4698_: bool;
    var phi_4314_: i32;
    var phi_4311_: i32;
    var phi_4308_: i32;
    var phi_4305_: i32;
    var phi_4313_: i32;
    var phi_4310_: i32;
    var phi_4307_: i32;
    var phi_4304_: i32;
    var phi_4306_: i32;
    var phi_1609_: bool;
    var phi_1639_: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1706_: bool;
    var phi_1736_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1803_: bool;
    var phi_1833_: bool;
    var phi_1863_: bool;
    var phi_1864_: bool;
    var phi_1865_: bool;
    var phi_1866_: bool;
    var phi_1898_: bool;
    var phi_1908_: vec3<f32>;
    var phi_1909_: vec3<f32>;
    var phi_1961_: bool;
    var phi_1970_: vec3<f32>;
    var phi_2011_: bool;
    var phi_2012_: bool;
    var phi_2013_: bool;
    var phi_2014_: bool;
    var phi_2015_: bool;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2023_: bool;
    var phi_2024_: bool;
    var phi_2025_: bool;
    var phi_2026_: bool;
    var phi_2027_: bool;
    var phi_2028_: bool;
    var phi_2029_: bool;
    var phi_2030_: bool;
    var phi_2031_: bool;
    var phi_2032_: bool;
    var phi_2033_: bool;
    var phi_2034_: bool;
    var phi_2035_: bool;
    var phi_4604_: i32;
    var phi_2048_: bool;
    var local_9: bool;
    var phi_4463_: i32;
    var phi_2101_: vec3<f32>;
    var phi_2102_: vec3<f32>;
    var phi_3793_: type_33;
    var phi_3796_: type_33;
    var phi_3797_: bool;
    var phi_3802_: type_33;
    var phi_3804_: type_33;
    var phi_3840_: type_33;
    var phi_3843_: type_33;
    var phi_3844_: bool;
    var phi_3849_: type_33;
    var phi_3851_: type_33;
    var phi_3899_: type_33;
    var phi_3948_: type_33;
    var phi_3951_: type_33;
    var phi_3952_: bool;
    var phi_3957_: type_33;
    var phi_3959_: type_33;
    var phi_3995_: type_33;
    var phi_3998_: type_33;
    var phi_3999_: bool;
    var phi_4004_: type_33;
    var phi_4006_: type_33;
    var phi_4054_: type_33;
    var phi_4103_: type_33;
    var phi_4106_: type_33;
    var phi_4107_: bool;
    var phi_4112_: type_33;
    var phi_4114_: type_33;
    var phi_4150_: type_33;
    var phi_4153_: type_33;
    var phi_4154_: bool;
    var phi_4159_: type_33;
    var phi_4161_: type_33;
    var phi_4209_: type_33;
    var phi_2144_: type_33;
    var phi_5126_: i32;
    var phi_4603_: i32;
    var phi_4579_: i32;
    var phi_4549_: i32;
    var phi_5125_: i32;
    var phi_4602_: i32;
    var phi_4578_: i32;
    var phi_4548_: i32;
    var phi_2184_: bool;
    var local_10: bool;
    var local_11: i32;
    var local_12: i32;
    var local_13: i32;
    var phi_2214_: u32;
    var phi_2225_: vec3<f32>;
    var phi_2226_: vec3<f32>;
    var phi_4690_: bool;
    var phi_2282_: type_12;
    var phi_2283_: type_12;
    var phi_2306_: type_12;
    var phi_2318_: type_12;
    var phi_2321_: f32;
    var phi_2319_: type_12;
    var phi_2344_: type_12;
    var phi_2379_: f32;
    var phi_2322_: f32;
    var phi_4685_: bool;
    var local_14: f32;
    var phi_2435_: f32;
    var phi_2440_: type_12;
    var phi_2443_: f32;
    var phi_2445_: vec3<f32>;
    var phi_2447_: u32;
    var phi_2441_: type_12;
    var phi_2470_: type_12;
    var phi_2505_: f32;
    var phi_2539_: u32;
    var phi_2540_: u32;
    var phi_2556_: u32;
    var phi_2557_: u32;
    var phi_2444_: f32;
    var phi_2446_: vec3<f32>;
    var phi_2448_: u32;
    var phi_4900_: bool;
    var local_15: u32;
    var phi_4917_: bool;
    var phi_4916_: bool;
    var phi_4915_: bool;
    var phi_4914_: bool;
    var phi_2569_: type_12;
    var phi_2572_: vec3<f32>;
    var phi_2574_: f32;
    var phi_2576_: f32;
    var phi_2578_: f32;
    var phi_2580_: f32;
    var phi_2570_: type_12;
    var phi_2603_: type_12;
    var phi_2717_: vec3<f32>;
    var phi_2718_: f32;
    var phi_2573_: vec3<f32>;
    var phi_2575_: f32;
    var phi_2577_: f32;
    var phi_2579_: f32;
    var phi_2581_: f32;
    var phi_4918_: bool;
    var local_16: f32;
    var local_17: f32;
    var local_18: f32;
    var phi_2734_: bool;
    var phi_2735_: bool;
    var phi_2736_: bool;
    var phi_2737_: bool;
    var phi_2738_: bool;
    var local_19: f32;
    var local_20: vec3<f32>;
    var local_21: f32;
    var local_22: vec3<f32>;
    var local_23: f32;
    var local_24: vec3<f32>;
    var local_25: f32;
    var phi_2755_: vec3<f32>;
    var local_26: f32;
    var local_27: u32;
    var phi_2827_: f32;
    var local_28: u32;
    var local_29: u32;
    var local_30: u32;
    var local_31: u32;
    var local_32: u32;
    var local_33: u32;
    var phi_2917_: u32;
    var phi_2923_: u32;
    var phi_2953_: u32;
    var phi_2959_: u32;
    var phi_3176_: type_30;
    var phi_3206_: u32;
    var phi_3217_: vec3<f32>;
    var phi_3218_: vec3<f32>;
    var phi_3253_: type_12;
    var phi_3256_: u32;
    var phi_3254_: type_12;
    var phi_3279_: type_12;
    var phi_3304_: u32;
    var phi_3257_: u32;
    var local_34: u32;
    var phi_4927_: bool;
    var phi_4926_: bool;
    var local_35: i32;
    var local_36: i32;
    var local_37: i32;
    var local_38: i32;
    var local_39: i32;
    var local_40: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = gid_1;
            let _e93 = arrayLength((&surfaces.member));
            let _e95 = arrayLength((&tile_first.member));
            let _e97 = arrayLength((&sums.member));
            let _e101 = (_e87.x + (_e87.y * 2097152u));
            let _e104 = params.member.member_4;
            if (_e101 < _e104) {
                let _e108 = params.member.member_3;
                phi_701_ = _e108;
                phi_704_ = 0u;
                loop {
                    let _e110 = phi_701_;
                    let _e112 = phi_704_;
                    local_2 = _e112;
                    local_3 = _e112;
                    local_4 = _e112;
                    local_5 = _e112;
                    local_6 = _e112;
                    local_7 = _e112;
                    local_8 = _e112;
                    local_27 = _e112;
                    local_28 = _e112;
                    local_29 = _e112;
                    local_30 = _e112;
                    local_31 = _e112;
                    local_32 = _e112;
                    local_33 = _e112;
                    let _e113 = (_e110 > 1u);
                    if _e113 {
                        let _e114 = (_e110 / 2u);
                        let _e115 = (_e112 + _e114);
                        if (_e115 < _e95) {
                        } else {
                            phi_4300_ = true;
                            break;
                        }
                        let _e119 = tile_first.member[_e115];
                        phi_702_ = (_e110 - _e114);
                        phi_705_ = select(_e112, _e115, (_e119 <= _e101));
                    } else {
                        phi_702_ = u32();
                        phi_705_ = u32();
                    }
                    let _e124 = phi_702_;
                    let _e126 = phi_705_;
                    continue;
                    continuing {
                        phi_701_ = _e124;
                        phi_704_ = _e126;
                        phi_4300_ = false;
                        break if !(_e113);
                    }
                }
                let _e129 = phi_4300_;
                if _e129 {
                    break;
                }
                let _e131 = local_2;
                if (_e131 < arrayLength((&triangles.member))) {
                } else {
                    break;
                }
                let _e135 = local_3;
                let _e138 = triangles.member[_e135].member;
                let _e144 = params.member.member;
                let _e152 = ((_e138[0] - _e144.x) / _e144.w);
                let _e153 = ((_e138[1] - _e144.y) / _e144.w);
                let _e154 = ((_e138[2] - _e144.z) / _e144.w);
                let _e158 = local_4;
                let _e161 = triangles.member[_e158].member_2;
                let _e168 = ((_e161[0] - _e144.x) / _e144.w);
                let _e169 = ((_e161[1] - _e144.y) / _e144.w);
                let _e170 = ((_e161[2] - _e144.z) / _e144.w);
                let _e174 = local_5;
                let _e177 = triangles.member[_e174].member_4;
                let _e184 = ((_e177[0] - _e144.x) / _e144.w);
                let _e185 = ((_e177[1] - _e144.y) / _e144.w);
                let _e186 = ((_e177[2] - _e144.z) / _e144.w);
                let _e188 = (_e168 - _e152);
                let _e189 = (_e169 - _e153);
                let _e190 = (_e170 - _e154);
                let _e191 = (_e184 - _e152);
                let _e192 = (_e185 - _e153);
                let _e193 = (_e186 - _e154);
                let _e196 = ((_e189 * _e193) - (_e192 * _e190));
                let _e199 = ((_e190 * _e191) - (_e193 * _e188));
                let _e202 = ((_e188 * _e192) - (_e191 * _e189));
                let _e204 = abs(_e196);
                let _e205 = abs(_e199);
                let _e206 = abs(_e202);
                let _e207 = (_e204 >= _e205);
                if _e207 {
                    phi_817_ = select(true, false, (_e204 >= _e206));
                } else {
                    phi_817_ = true;
                }
                let _e211 = phi_817_;
                if _e211 {
                    phi_826_ = select(2u, 1u, (_e205 >= _e206));
                } else {
                    phi_826_ = 0u;
                }
                let _e215 = phi_826_;
                let _e218 = params.member.member_1;
                let _e220 = f32(_e218.x);
                let _e222 = f32(_e218.y);
                let _e224 = f32(_e218.z);
                let _e226 = (_e215 == 0u);
                if _e226 {
                    phi_847_ = vec3<f32>(_e222, _e224, _e220);
                } else {
                    if (_e215 == 1u) {
                        phi_846_ = vec3<f32>(_e224, _e220, _e222);
                    } else {
                        phi_846_ = vec3<f32>(_e220, _e222, _e224);
                    }
                    let _e230 = phi_846_;
                    phi_847_ = _e230;
                }
                let _e233 = phi_847_;
                if _e226 {
                    phi_859_ = vec3<f32>(_e153, _e154, _e152);
                } else {
                    if (_e215 == 1u) {
                        phi_858_ = vec3<f32>(_e154, _e152, _e153);
                    } else {
                        phi_858_ = vec3<f32>(_e152, _e153, _e154);
                    }
                    let _e237 = phi_858_;
                    phi_859_ = _e237;
                }
                let _e240 = phi_859_;
                if _e226 {
                    phi_871_ = vec3<f32>(_e169, _e170, _e168);
                } else {
                    if (_e215 == 1u) {
                        phi_870_ = vec3<f32>(_e170, _e168, _e169);
                    } else {
                        phi_870_ = vec3<f32>(_e168, _e169, _e170);
                    }
                    let _e244 = phi_870_;
                    phi_871_ = _e244;
                }
                let _e247 = phi_871_;
                if _e226 {
                    phi_883_ = vec3<f32>(_e185, _e186, _e184);
                } else {
                    if (_e215 == 1u) {
                        phi_882_ = vec3<f32>(_e186, _e184, _e185);
                    } else {
                        phi_882_ = vec3<f32>(_e184, _e185, _e186);
                    }
                    let _e251 = phi_882_;
                    phi_883_ = _e251;
                }
                let _e254 = phi_883_;
                let _e258 = select(_e247.x, _e240.x, (_e240.x < _e247.x));
                let _e263 = select(_e247.x, _e240.x, (_e240.x > _e247.x));
                let _e269 = (-1f - floor(-(select(_e254.x, _e258, (_e258 < _e254.x)))));
                let _e270 = floor(select(_e254.x, _e263, (_e263 > _e254.x)));
                let _e271 = (_e233.x - 1f);
                let _e273 = select(0f, _e269, (_e269 > 0f));
                let _e275 = select(_e271, _e270, (_e270 < _e271));
                let _e282 = select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < -2147483600f)), 2147483647i, (_e273 > 2147483500f)), (_e273 == _e273));
                let _e289 = select(0i, select(select(i32(_e275), i32(-2147483648), (_e275 < -2147483600f)), 2147483647i, (_e275 > 2147483500f)), (_e275 == _e275));
                let _e293 = select(_e247.y, _e240.y, (_e240.y < _e247.y));
                let _e298 = select(_e247.y, _e240.y, (_e240.y > _e247.y));
                let _e304 = (-1f - floor(-(select(_e254.y, _e293, (_e293 < _e254.y)))));
                let _e305 = floor(select(_e254.y, _e298, (_e298 > _e254.y)));
                let _e306 = (_e233.y - 1f);
                let _e308 = select(0f, _e304, (_e304 > 0f));
                let _e310 = select(_e306, _e305, (_e305 < _e306));
                let _e317 = select(0i, select(select(i32(_e308), i32(-2147483648), (_e308 < -2147483600f)), 2147483647i, (_e308 > 2147483500f)), (_e308 == _e308));
                let _e324 = select(0i, select(select(i32(_e310), i32(-2147483648), (_e310 < -2147483600f)), 2147483647i, (_e310 > 2147483500f)), (_e310 == _e310));
                let _e325 = type_38(_e240, _e247, _e254, vec3<f32>(_e196, _e199, _e202), _e215, _e233, _e282, _e289, _e317, _e324);
                if _e207 {
                    phi_1019_ = select(true, false, (_e204 >= _e206));
                } else {
                    phi_1019_ = true;
                }
                let _e329 = phi_1019_;
                if _e329 {
                    phi_1028_ = select(2u, 1u, (_e205 >= _e206));
                } else {
                    phi_1028_ = 0u;
                }
                let _e333 = phi_1028_;
                if (_e333 == 0u) {
                    phi_1038_ = _e196;
                } else {
                    phi_1038_ = select(_e202, _e199, (_e333 == 1u));
                }
                let _e338 = phi_1038_;
                let _e347 = (((_e196 * _e196) + (_e199 * _e199)) + (_e202 * _e202));
                if (_e347 >= 0.000000000000000000000000000000000000011754944f) {
                    let _e350 = (1f / sqrt(_e347));
                    phi_1058_ = vec3<f32>((_e196 * _e350), (_e199 * _e350), (_e202 * _e350));
                } else {
                    phi_1058_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e356 = phi_1058_;
                let _e359 = local_6;
                let _e362 = triangles.member[_e359].member_1;
                let _e363 = (_e362 * 12u);
                let _e364 = (256u + _e363);
                if (_e364 < _e93) {
                } else {
                    break;
                }
                let _e368 = surfaces.member[_e364];
                let _e369 = bitcast<f32>(_e368);
                let _e370 = (_e363 + 257u);
                if (_e370 < _e93) {
                } else {
                    break;
                }
                let _e374 = surfaces.member[_e370];
                let _e375 = bitcast<f32>(_e374);
                let _e376 = (_e363 + 258u);
                if (_e376 < _e93) {
                } else {
                    break;
                }
                let _e380 = surfaces.member[_e376];
                let _e381 = bitcast<f32>(_e380);
                let _e382 = (_e363 + 259u);
                if (_e382 < _e93) {
                } else {
                    break;
                }
                let _e386 = surfaces.member[_e382];
                let _e387 = (_e363 + 260u);
                if (_e387 < _e93) {
                } else {
                    break;
                }
                let _e391 = surfaces.member[_e387];
                let _e393 = (_e363 + 261u);
                if (_e393 < _e93) {
                } else {
                    break;
                }
                let _e397 = surfaces.member[_e393];
                let _e399 = (_e363 + 262u);
                if (_e399 < _e93) {
                } else {
                    break;
                }
                let _e403 = surfaces.member[_e399];
                let _e405 = (_e363 + 263u);
                if (_e405 < _e93) {
                } else {
                    break;
                }
                let _e409 = surfaces.member[_e405];
                let _e410 = (_e363 + 264u);
                if (_e410 < _e93) {
                } else {
                    break;
                }
                let _e414 = surfaces.member[_e410];
                let _e415 = bitcast<f32>(_e414);
                let _e416 = (_e363 + 265u);
                if (_e416 < _e93) {
                } else {
                    break;
                }
                let _e420 = surfaces.member[_e416];
                if ((_e363 + 266u) < _e93) {
                } else {
                    break;
                }
                if ((_e363 + 267u) < _e93) {
                } else {
                    break;
                }
                let _e427 = local_7;
                if (_e427 < _e95) {
                } else {
                    break;
                }
                let _e431 = local_8;
                let _e433 = tile_first.member[_e431];
                let _e434 = (_e101 - _e433);
                if (_e289 < _e282) {
                    phi_1182_ = 0u;
                } else {
                    phi_1182_ = ((bitcast<u32>((_e289 - _e282)) / 4u) + 1u);
                }
                let _e441 = phi_1182_;
                let _e443 = select(1u, _e441, (1u < _e441));
                if (_e443 == 0u) {
                    break;
                }
                let _e445 = (_e434 / _e443);
                let _e450 = (_e282 + bitcast<i32>(((_e434 - (_e445 * _e443)) * 4u)));
                let _e453 = (_e317 + bitcast<i32>((_e445 * 4u)));
                let _e457 = select(_e247.z, _e240.z, (_e240.z < _e247.z));
                let _e462 = select(_e247.z, _e240.z, (_e240.z > _e247.z));
                let _e468 = (-1f - floor(-(select(_e254.z, _e457, (_e457 < _e254.z)))));
                let _e469 = floor(select(_e254.z, _e462, (_e462 > _e254.z)));
                let _e470 = (_e233.z - 1f);
                let _e472 = select(0f, _e468, (_e468 > 0f));
                let _e474 = select(_e470, _e469, (_e469 < _e470));
                let _e481 = select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < -2147483600f)), 2147483647i, (_e472 > 2147483500f)), (_e472 == _e472));
                let _e488 = select(0i, select(select(i32(_e474), i32(-2147483648), (_e474 < -2147483600f)), 2147483647i, (_e474 > 2147483500f)), (_e474 == _e474));
                let _e489 = (_e247.x - _e240.x);
                let _e490 = (_e247.y - _e240.y);
                let _e496 = ((abs(_e489) + abs(_e490)) + abs((_e247.z - _e240.z)));
                let _e497 = (_e254.x - _e240.x);
                let _e498 = (_e254.y - _e240.y);
                let _e504 = ((abs(_e497) + abs(_e498)) + abs((_e254.z - _e240.z)));
                let _e506 = select(_e205, _e204, (_e204 > _e205));
                let _e514 = (select(_e206, _e506, (_e506 > _e206)) <= (((0.000004f * _e496) * _e504) * select(_e504, _e496, (_e496 > _e504))));
                let _e515 = (_e450 + 4i);
                let _e516 = (_e289 + 1i);
                let _e518 = select(_e515, _e516, (_e516 < _e515));
                let _e519 = (_e453 + 4i);
                let _e520 = (_e324 + 1i);
                let _e523 = (_e450 - 1i);
                let _e526 = (f32(_e450) + 2f);
                let _e528 = (f32(_e453) + 2f);
                let _e531 = ((_e240.x - _e526) * 0.24937655f);
                let _e532 = ((_e240.y - _e528) * 0.24937655f);
                let _e535 = ((_e247.x - _e526) * 0.24937655f);
                let _e536 = ((_e247.y - _e528) * 0.24937655f);
                let _e539 = ((_e254.x - _e526) * 0.24937655f);
                let _e540 = ((_e254.y - _e528) * 0.24937655f);
                let _e541 = (_e535 - _e531);
                let _e542 = (_e536 - _e532);
                let _e545 = ((_e541 * _e532) - (_e542 * _e531));
                let _e548 = ((_e541 * _e540) - (_e542 * _e539));
                let _e551 = (abs(_e541) + abs(_e542));
                if (select(_e548, _e545, (_e545 < _e548)) > (0.5f * _e551)) {
                    phi_3665_ = true;
                } else {
                    phi_3665_ = (select(_e548, _e545, (_e545 > _e548)) < (_e551 * -0.5f));
                }
                let _e561 = phi_3665_;
                if _e561 {
                    phi_1379_ = bool();
                    phi_1380_ = true;
                } else {
                    let _e562 = (_e539 - _e535);
                    let _e563 = (_e540 - _e536);
                    let _e566 = ((_e562 * _e536) - (_e563 * _e535));
                    let _e569 = ((_e562 * _e532) - (_e563 * _e531));
                    let _e572 = (abs(_e562) + abs(_e563));
                    if (select(_e569, _e566, (_e566 < _e569)) > (0.5f * _e572)) {
                        phi_3704_ = true;
                    } else {
                        phi_3704_ = (select(_e569, _e566, (_e566 > _e569)) < (_e572 * -0.5f));
                    }
                    let _e582 = phi_3704_;
                    if _e582 {
                        phi_1378_ = bool();
                    } else {
                        let _e583 = (_e531 - _e539);
                        let _e584 = (_e532 - _e540);
                        let _e587 = ((_e583 * _e540) - (_e584 * _e539));
                        let _e590 = ((_e583 * _e536) - (_e584 * _e535));
                        let _e593 = (abs(_e583) + abs(_e584));
                        if (select(_e590, _e587, (_e587 < _e590)) > (0.5f * _e593)) {
                            phi_3743_ = true;
                        } else {
                            phi_3743_ = (select(_e590, _e587, (_e587 > _e590)) < (_e593 * -0.5f));
                        }
                        let _e603 = phi_3743_;
                        phi_1378_ = _e603;
                    }
                    let _e605 = phi_1378_;
                    phi_1379_ = _e605;
                    phi_1380_ = _e582;
                }
                let _e607 = phi_1379_;
                let _e609 = phi_1380_;
                if select(_e607, true, _e609) {
                    phi_1389_ = type_39(_e325, _e450, _e518, _e453, _e481, _e488, _e523, _e453, 0i, -1i, _e514);
                } else {
                    phi_1389_ = type_39(_e325, _e450, _e518, select(_e519, _e520, (_e520 < _e519)), _e481, _e488, _e523, _e453, 0i, -1i, _e514);
                }
                let _e613 = phi_1389_;
                phi_4698_ = _e129;
                phi_4314_ = _e613.member_6;
                phi_4311_ = _e613.member_9;
                phi_4308_ = _e613.member_8;
                phi_4305_ = _e613.member_7;
                loop {
                    let _e632 = phi_4698_;
                    let _e634 = phi_4314_;
                    let _e636 = phi_4311_;
                    let _e638 = phi_4308_;
                    let _e640 = phi_4305_;
                    phi_4313_ = _e634;
                    phi_4310_ = _e636;
                    phi_4307_ = _e638;
                    phi_4304_ = _e640;
                    loop {
                        let _e642 = phi_4313_;
                        let _e644 = phi_4310_;
                        let _e646 = phi_4307_;
                        let _e648 = phi_4304_;
                        let _e649 = (_e648 < _e613.member_3);
                        if _e649 {
                            phi_4306_ = _e646;
                            loop {
                                let _e651 = phi_4306_;
                                let _e652 = (_e651 < _e644);
                                if _e652 {
                                    let _e653 = (_e651 + 1i);
                                    let _e657 = (f32(_e642) + 0.5f);
                                    let _e658 = (f32(_e648) + 0.5f);
                                    let _e659 = (f32(_e653) + 0.5f);
                                    let _e661 = (_e613.member.member.x - _e657);
                                    let _e663 = (_e613.member.member.y - _e658);
                                    let _e665 = (_e613.member.member.z - _e659);
                                    let _e666 = vec3<f32>(_e657, _e658, _e659);
                                    let _e669 = (_e613.member.member_1.x - _e657);
                                    let _e671 = (_e613.member.member_1.y - _e658);
                                    let _e673 = (_e613.member.member_1.z - _e659);
                                    let _e676 = (_e613.member.member_2.x - _e657);
                                    let _e678 = (_e613.member.member_2.y - _e658);
                                    let _e680 = (_e613.member.member_2.z - _e659);
                                    let _e683 = select(_e669, _e661, (_e661 < _e669));
                                    let _e687 = select(_e671, _e663, (_e663 < _e671));
                                    let _e691 = select(_e673, _e665, (_e665 < _e673));
                                    let _e695 = select(_e669, _e661, (_e661 > _e669));
                                    let _e699 = select(_e671, _e663, (_e663 > _e671));
                                    let _e703 = select(_e673, _e665, (_e665 > _e673));
                                    if (select(_e676, _e683, (_e683 < _e676)) > 0.5f) {
                                        phi_2033_ = bool();
                                        phi_2034_ = true;
                                        phi_2035_ = false;
                                    } else {
                                        if (select(_e678, _e687, (_e687 < _e678)) > 0.5f) {
                                            phi_2030_ = bool();
                                            phi_2031_ = true;
                                            phi_2032_ = false;
                                        } else {
                                            if (select(_e680, _e691, (_e691 < _e680)) > 0.5f) {
                                                phi_2027_ = bool();
                                                phi_2028_ = true;
                                                phi_2029_ = false;
                                            } else {
                                                if (select(_e676, _e695, (_e695 > _e676)) < -0.5f) {
                                                    phi_2024_ = bool();
                                                    phi_2025_ = true;
                                                    phi_2026_ = false;
                                                } else {
                                                    if (select(_e678, _e699, (_e699 > _e678)) < -0.5f) {
                                                        phi_2021_ = bool();
                                                        phi_2022_ = true;
                                                        phi_2023_ = false;
                                                    } else {
                                                        let _e711 = (select(_e680, _e703, (_e703 > _e680)) < -0.5f);
                                                        if _e711 {
                                                            phi_2019_ = bool();
                                                            phi_2020_ = false;
                                                        } else {
                                                            let _e712 = (_e669 - _e661);
                                                            let _e713 = (_e671 - _e663);
                                                            let _e714 = (_e673 - _e665);
                                                            let _e715 = vec3<f32>(_e712, _e713, _e714);
                                                            let _e716 = (_e676 - _e669);
                                                            let _e717 = (_e678 - _e671);
                                                            let _e718 = (_e680 - _e673);
                                                            let _e719 = vec3<f32>(_e716, _e717, _e718);
                                                            let _e720 = (_e661 - _e676);
                                                            let _e721 = (_e663 - _e678);
                                                            let _e722 = (_e665 - _e680);
                                                            let _e723 = vec3<f32>(_e720, _e721, _e722);
                                                            let _e726 = ((_e713 * _e665) - (_e714 * _e663));
                                                            let _e729 = ((_e713 * _e680) - (_e714 * _e678));
                                                            let _e730 = abs(_e713);
                                                            let _e731 = abs(_e714);
                                                            let _e732 = (_e730 + _e731);
                                                            if (select(_e729, _e726, (_e726 < _e729)) > (0.5f * _e732)) {
                                                                phi_1609_ = true;
                                                            } else {
                                                                phi_1609_ = (select(_e729, _e726, (_e726 > _e729)) < (_e732 * -0.5f));
                                                            }
                                                            let _e742 = phi_1609_;
                                                            if _e742 {
                                                                phi_1671_ = bool();
                                                                phi_1672_ = true;
                                                            } else {
                                                                let _e745 = ((_e714 * _e661) - (_e712 * _e665));
                                                                let _e748 = ((_e714 * _e676) - (_e712 * _e680));
                                                                let _e749 = abs(_e712);
                                                                let _e750 = (_e731 + _e749);
                                                                if (select(_e748, _e745, (_e745 < _e748)) > (0.5f * _e750)) {
                                                                    phi_1639_ = true;
                                                                } else {
                                                                    phi_1639_ = (select(_e748, _e745, (_e745 > _e748)) < (_e750 * -0.5f));
                                                                }
                                                                let _e760 = phi_1639_;
                                                                if _e760 {
                                                                    phi_1670_ = bool();
                                                                } else {
                                                                    let _e763 = ((_e712 * _e663) - (_e713 * _e661));
                                                                    let _e766 = ((_e712 * _e678) - (_e713 * _e676));
                                                                    let _e767 = (_e749 + _e730);
                                                                    if (select(_e766, _e763, (_e763 < _e766)) > (0.5f * _e767)) {
                                                                        phi_1669_ = true;
                                                                    } else {
                                                                        phi_1669_ = (select(_e766, _e763, (_e763 > _e766)) < (_e767 * -0.5f));
                                                                    }
                                                                    let _e777 = phi_1669_;
                                                                    phi_1670_ = _e777;
                                                                }
                                                                let _e779 = phi_1670_;
                                                                phi_1671_ = _e779;
                                                                phi_1672_ = _e760;
                                                            }
                                                            let _e781 = phi_1671_;
                                                            let _e783 = phi_1672_;
                                                            if select(_e781, true, _e783) {
                                                                phi_2014_ = bool();
                                                                phi_2015_ = true;
                                                            } else {
                                                                let _e787 = ((_e717 * _e673) - (_e718 * _e671));
                                                                let _e790 = ((_e717 * _e665) - (_e718 * _e663));
                                                                let _e791 = abs(_e717);
                                                                let _e792 = abs(_e718);
                                                                let _e793 = (_e791 + _e792);
                                                                if (select(_e790, _e787, (_e787 < _e790)) > (0.5f * _e793)) {
                                                                    phi_1706_ = true;
                                                                } else {
                                                                    phi_1706_ = (select(_e790, _e787, (_e787 > _e790)) < (_e793 * -0.5f));
                                                                }
                                                                let _e803 = phi_1706_;
                                                                if _e803 {
                                                                    phi_1768_ = bool();
                                                                    phi_1769_ = true;
                                                                } else {
                                                                    let _e806 = ((_e718 * _e669) - (_e716 * _e673));
                                                                    let _e809 = ((_e718 * _e661) - (_e716 * _e665));
                                                                    let _e810 = abs(_e716);
                                                                    let _e811 = (_e792 + _e810);
                                                                    if (select(_e809, _e806, (_e806 < _e809)) > (0.5f * _e811)) {
                                                                        phi_1736_ = true;
                                                                    } else {
                                                                        phi_1736_ = (select(_e809, _e806, (_e806 > _e809)) < (_e811 * -0.5f));
                                                                    }
                                                                    let _e821 = phi_1736_;
                                                                    if _e821 {
                                                                        phi_1767_ = bool();
                                                                    } else {
                                                                        let _e824 = ((_e716 * _e671) - (_e717 * _e669));
                                                                        let _e827 = ((_e716 * _e663) - (_e717 * _e661));
                                                                        let _e828 = (_e810 + _e791);
                                                                        if (select(_e827, _e824, (_e824 < _e827)) > (0.5f * _e828)) {
                                                                            phi_1766_ = true;
                                                                        } else {
                                                                            phi_1766_ = (select(_e827, _e824, (_e824 > _e827)) < (_e828 * -0.5f));
                                                                        }
                                                                        let _e838 = phi_1766_;
                                                                        phi_1767_ = _e838;
                                                                    }
                                                                    let _e840 = phi_1767_;
                                                                    phi_1768_ = _e840;
                                                                    phi_1769_ = _e821;
                                                                }
                                                                let _e842 = phi_1768_;
                                                                let _e844 = phi_1769_;
                                                                if select(_e842, true, _e844) {
                                                                    phi_2012_ = bool();
                                                                    phi_2013_ = true;
                                                                } else {
                                                                    let _e848 = ((_e721 * _e680) - (_e722 * _e678));
                                                                    let _e851 = ((_e721 * _e673) - (_e722 * _e671));
                                                                    let _e852 = abs(_e721);
                                                                    let _e853 = abs(_e722);
                                                                    let _e854 = (_e852 + _e853);
                                                                    if (select(_e851, _e848, (_e848 < _e851)) > (0.5f * _e854)) {
                                                                        phi_1803_ = true;
                                                                    } else {
                                                                        phi_1803_ = (select(_e851, _e848, (_e848 > _e851)) < (_e854 * -0.5f));
                                                                    }
                                                                    let _e864 = phi_1803_;
                                                                    if _e864 {
                                                                        phi_1865_ = bool();
                                                                        phi_1866_ = true;
                                                                    } else {
                                                                        let _e867 = ((_e722 * _e676) - (_e720 * _e680));
                                                                        let _e870 = ((_e722 * _e669) - (_e720 * _e673));
                                                                        let _e871 = abs(_e720);
                                                                        let _e872 = (_e853 + _e871);
                                                                        if (select(_e870, _e867, (_e867 < _e870)) > (0.5f * _e872)) {
                                                                            phi_1833_ = true;
                                                                        } else {
                                                                            phi_1833_ = (select(_e870, _e867, (_e867 > _e870)) < (_e872 * -0.5f));
                                                                        }
                                                                        let _e882 = phi_1833_;
                                                                        if _e882 {
                                                                            phi_1864_ = bool();
                                                                        } else {
                                                                            let _e885 = ((_e720 * _e678) - (_e721 * _e676));
                                                                            let _e888 = ((_e720 * _e671) - (_e721 * _e669));
                                                                            let _e889 = (_e871 + _e852);
                                                                            if (select(_e888, _e885, (_e885 < _e888)) > (0.5f * _e889)) {
                                                                                phi_1863_ = true;
                                                                            } else {
                                                                                phi_1863_ = (select(_e888, _e885, (_e885 > _e888)) < (_e889 * -0.5f));
                                                                            }
                                                                            let _e899 = phi_1863_;
                                                                            phi_1864_ = _e899;
                                                                        }
                                                                        let _e901 = phi_1864_;
                                                                        phi_1865_ = _e901;
                                                                        phi_1866_ = _e882;
                                                                    }
                                                                    let _e903 = phi_1865_;
                                                                    let _e905 = phi_1866_;
                                                                    let _e906 = select(_e903, true, _e905);
                                                                    if _e906 {
                                                                        phi_2011_ = bool();
                                                                    } else {
                                                                        let _e909 = ((abs(_e712) + _e730) + _e731);
                                                                        let _e912 = ((abs(_e716) + _e791) + _e792);
                                                                        let _e915 = ((abs(_e720) + _e852) + _e853);
                                                                        if (_e909 >= _e912) {
                                                                            phi_1898_ = select(true, false, (_e909 >= _e915));
                                                                        } else {
                                                                            phi_1898_ = true;
                                                                        }
                                                                        let _e920 = phi_1898_;
                                                                        if _e920 {
                                                                            let _e922 = vec3((_e912 >= _e915));
                                                                            phi_1908_ = select(_e715, _e723, _e922);
                                                                            phi_1909_ = select(_e719, _e715, _e922);
                                                                        } else {
                                                                            phi_1908_ = _e719;
                                                                            phi_1909_ = _e723;
                                                                        }
                                                                        let _e926 = phi_1908_;
                                                                        let _e928 = phi_1909_;
                                                                        let _e935 = ((_e926.y * _e928.z) - (_e928.y * _e926.z));
                                                                        let _e940 = ((_e926.z * _e928.x) - (_e928.z * _e926.x));
                                                                        let _e943 = ((_e926.x * _e928.y) - (_e928.x * _e926.y));
                                                                        let _e954 = ((abs(_e661) + abs(_e663)) + abs(_e665));
                                                                        let _e959 = ((abs(_e669) + abs(_e671)) + abs(_e673));
                                                                        let _e964 = ((abs(_e676) + abs(_e678)) + abs(_e680));
                                                                        if (_e954 <= _e959) {
                                                                            phi_1961_ = select(true, false, (_e954 <= _e964));
                                                                        } else {
                                                                            phi_1961_ = true;
                                                                        }
                                                                        let _e969 = phi_1961_;
                                                                        if _e969 {
                                                                            phi_1970_ = select((_e613.member.member_2 - _e666), (_e613.member.member_1 - _e666), vec3((_e959 <= _e964)));
                                                                        } else {
                                                                            phi_1970_ = (_e613.member.member - _e666);
                                                                        }
                                                                        let _e974 = phi_1970_;
                                                                        let _e976 = select(_e959, _e954, (_e954 < _e959));
                                                                        phi_2011_ = (abs((((_e935 * _e974.x) + (_e940 * _e974.y)) + (_e943 * _e974.z))) <= ((0.5f * ((abs(_e935) + abs(_e940)) + abs(_e943))) + (((0.00000036f * select(_e964, _e976, (_e976 < _e964))) * ((abs(_e926.x) + abs(_e926.y)) + abs(_e926.z))) * ((abs(_e928.x) + abs(_e928.y)) + abs(_e928.z)))));
                                                                    }
                                                                    let _e1004 = phi_2011_;
                                                                    phi_2012_ = _e1004;
                                                                    phi_2013_ = _e906;
                                                                }
                                                                let _e1006 = phi_2012_;
                                                                let _e1008 = phi_2013_;
                                                                phi_2014_ = _e1006;
                                                                phi_2015_ = _e1008;
                                                            }
                                                            let _e1010 = phi_2014_;
                                                            let _e1012 = phi_2015_;
                                                            phi_2019_ = _e1010;
                                                            phi_2020_ = _e1012;
                                                        }
                                                        let _e1014 = phi_2019_;
                                                        let _e1016 = phi_2020_;
                                                        phi_2021_ = _e1014;
                                                        phi_2022_ = _e711;
                                                        phi_2023_ = _e1016;
                                                    }
                                                    let _e1018 = phi_2021_;
                                                    let _e1020 = phi_2022_;
                                                    let _e1022 = phi_2023_;
                                                    phi_2024_ = _e1018;
                                                    phi_2025_ = _e1020;
                                                    phi_2026_ = _e1022;
                                                }
                                                let _e1024 = phi_2024_;
                                                let _e1026 = phi_2025_;
                                                let _e1028 = phi_2026_;
                                                phi_2027_ = _e1024;
                                                phi_2028_ = _e1026;
                                                phi_2029_ = _e1028;
                                            }
                                            let _e1030 = phi_2027_;
                                            let _e1032 = phi_2028_;
                                            let _e1034 = phi_2029_;
                                            phi_2030_ = _e1030;
                                            phi_2031_ = _e1032;
                                            phi_2032_ = _e1034;
                                        }
                                        let _e1036 = phi_2030_;
                                        let _e1038 = phi_2031_;
                                        let _e1040 = phi_2032_;
                                        phi_2033_ = _e1036;
                                        phi_2034_ = _e1038;
                                        phi_2035_ = _e1040;
                                    }
                                    let _e1042 = phi_2033_;
                                    let _e1044 = phi_2034_;
                                    let _e1046 = phi_2035_;
                                    phi_4604_ = _e653;
                                    phi_2048_ = select(true, false, select(_e1042, false, select(_e1046, true, _e1044)));
                                } else {
                                    phi_4604_ = _e651;
                                    phi_2048_ = false;
                                }
                                let _e1051 = phi_4604_;
                                let _e1053 = phi_2048_;
                                let _e1054 = select(true, false, _e652);
                                local_9 = _e1054;
                                local_39 = _e1051;
                                local_40 = _e1054;
                                continue;
                                continuing {
                                    phi_4306_ = _e1051;
                                    break if !(_e1053);
                                }
                            }
                            let _e1057 = local_9;
                            if _e1057 {
                                let _e1058 = (_e642 + 1i);
                                let _e1059 = (_e1058 >= _e613.member_2);
                                if _e1059 {
                                    phi_4463_ = (_e648 + 1i);
                                } else {
                                    phi_4463_ = _e648;
                                }
                                let _e1062 = phi_4463_;
                                let _e1063 = select(_e1058, _e613.member_1, _e1059);
                                if _e613.member_10 {
                                    let _e1110 = (_e613.member.member_1.x - _e613.member.member.x);
                                    let _e1113 = (_e613.member.member_1.y - _e613.member.member.y);
                                    let _e1116 = (_e613.member.member_1.z - _e613.member.member.z);
                                    let _e1117 = f32(_e1063);
                                    let _e1118 = (_e1117 - 0.01f);
                                    let _e1119 = (_e1118 - _e613.member.member.x);
                                    let _e1120 = (_e1117 + 1.01f);
                                    let _e1121 = (_e1120 - _e613.member.member.x);
                                    if (abs(_e1110) < 0.000001f) {
                                        if (_e1119 <= 0f) {
                                            let _e1132 = (_e1121 >= 0f);
                                            if _e1132 {
                                                phi_3793_ = type_33(0f, 1f);
                                            } else {
                                                phi_3793_ = type_33();
                                            }
                                            let _e1134 = phi_3793_;
                                            phi_3796_ = _e1134;
                                            phi_3797_ = select(true, false, _e1132);
                                        } else {
                                            phi_3796_ = type_33();
                                            phi_3797_ = true;
                                        }
                                        let _e1137 = phi_3796_;
                                        let _e1139 = phi_3797_;
                                        if _e1139 {
                                            phi_3802_ = type_33(1f, 0f);
                                        } else {
                                            phi_3802_ = _e1137;
                                        }
                                        let _e1141 = phi_3802_;
                                        phi_3804_ = _e1141;
                                    } else {
                                        let _e1124 = (_e1119 / _e1110);
                                        let _e1125 = (_e1121 / _e1110);
                                        phi_3804_ = type_33(select(_e1125, _e1124, (_e1124 < _e1125)), select(_e1125, _e1124, (_e1124 > _e1125)));
                                    }
                                    let _e1143 = phi_3804_;
                                    let _e1146 = f32(_e1062);
                                    let _e1147 = (_e1146 - 0.01f);
                                    let _e1148 = (_e1147 - _e613.member.member.y);
                                    let _e1149 = (_e1146 + 1.01f);
                                    let _e1150 = (_e1149 - _e613.member.member.y);
                                    if (abs(_e1113) < 0.000001f) {
                                        if (_e1148 <= 0f) {
                                            let _e1161 = (_e1150 >= 0f);
                                            if _e1161 {
                                                phi_3840_ = type_33(0f, 1f);
                                            } else {
                                                phi_3840_ = type_33();
                                            }
                                            let _e1163 = phi_3840_;
                                            phi_3843_ = _e1163;
                                            phi_3844_ = select(true, false, _e1161);
                                        } else {
                                            phi_3843_ = type_33();
                                            phi_3844_ = true;
                                        }
                                        let _e1166 = phi_3843_;
                                        let _e1168 = phi_3844_;
                                        if _e1168 {
                                            phi_3849_ = type_33(1f, 0f);
                                        } else {
                                            phi_3849_ = _e1166;
                                        }
                                        let _e1170 = phi_3849_;
                                        phi_3851_ = _e1170;
                                    } else {
                                        let _e1153 = (_e1148 / _e1113);
                                        let _e1154 = (_e1150 / _e1113);
                                        phi_3851_ = type_33(select(_e1154, _e1153, (_e1153 < _e1154)), select(_e1154, _e1153, (_e1153 > _e1154)));
                                    }
                                    let _e1172 = phi_3851_;
                                    let _e1176 = select(_e1172.member, _e1143.member, (_e1143.member > _e1172.member));
                                    let _e1178 = select(0f, _e1176, (_e1176 > 0f));
                                    let _e1180 = select(_e1172.member_1, _e1143.member_1, (_e1143.member_1 < _e1172.member_1));
                                    let _e1182 = select(1f, _e1180, (_e1180 < 1f));
                                    if (_e1178 > _e1182) {
                                        phi_3899_ = type_33(_e613.member.member_5.z, -2f);
                                    } else {
                                        let _e1185 = (_e613.member.member.z + (_e1116 * _e1178));
                                        let _e1187 = (_e613.member.member.z + (_e1116 * _e1182));
                                        phi_3899_ = type_33(select(_e1187, _e1185, (_e1185 < _e1187)), select(_e1187, _e1185, (_e1185 > _e1187)));
                                    }
                                    let _e1196 = phi_3899_;
                                    let _e1200 = (_e613.member.member_2.x - _e613.member.member_1.x);
                                    let _e1202 = (_e613.member.member_2.y - _e613.member.member_1.y);
                                    let _e1204 = (_e613.member.member_2.z - _e613.member.member_1.z);
                                    let _e1205 = (_e1118 - _e613.member.member_1.x);
                                    let _e1206 = (_e1120 - _e613.member.member_1.x);
                                    if (abs(_e1200) < 0.000001f) {
                                        if (_e1205 <= 0f) {
                                            let _e1217 = (_e1206 >= 0f);
                                            if _e1217 {
                                                phi_3948_ = type_33(0f, 1f);
                                            } else {
                                                phi_3948_ = type_33();
                                            }
                                            let _e1219 = phi_3948_;
                                            phi_3951_ = _e1219;
                                            phi_3952_ = select(true, false, _e1217);
                                        } else {
                                            phi_3951_ = type_33();
                                            phi_3952_ = true;
                                        }
                                        let _e1222 = phi_3951_;
                                        let _e1224 = phi_3952_;
                                        if _e1224 {
                                            phi_3957_ = type_33(1f, 0f);
                                        } else {
                                            phi_3957_ = _e1222;
                                        }
                                        let _e1226 = phi_3957_;
                                        phi_3959_ = _e1226;
                                    } else {
                                        let _e1209 = (_e1205 / _e1200);
                                        let _e1210 = (_e1206 / _e1200);
                                        phi_3959_ = type_33(select(_e1210, _e1209, (_e1209 < _e1210)), select(_e1210, _e1209, (_e1209 > _e1210)));
                                    }
                                    let _e1228 = phi_3959_;
                                    let _e1231 = (_e1147 - _e613.member.member_1.y);
                                    let _e1232 = (_e1149 - _e613.member.member_1.y);
                                    if (abs(_e1202) < 0.000001f) {
                                        if (_e1231 <= 0f) {
                                            let _e1243 = (_e1232 >= 0f);
                                            if _e1243 {
                                                phi_3995_ = type_33(0f, 1f);
                                            } else {
                                                phi_3995_ = type_33();
                                            }
                                            let _e1245 = phi_3995_;
                                            phi_3998_ = _e1245;
                                            phi_3999_ = select(true, false, _e1243);
                                        } else {
                                            phi_3998_ = type_33();
                                            phi_3999_ = true;
                                        }
                                        let _e1248 = phi_3998_;
                                        let _e1250 = phi_3999_;
                                        if _e1250 {
                                            phi_4004_ = type_33(1f, 0f);
                                        } else {
                                            phi_4004_ = _e1248;
                                        }
                                        let _e1252 = phi_4004_;
                                        phi_4006_ = _e1252;
                                    } else {
                                        let _e1235 = (_e1231 / _e1202);
                                        let _e1236 = (_e1232 / _e1202);
                                        phi_4006_ = type_33(select(_e1236, _e1235, (_e1235 < _e1236)), select(_e1236, _e1235, (_e1235 > _e1236)));
                                    }
                                    let _e1254 = phi_4006_;
                                    let _e1258 = select(_e1254.member, _e1228.member, (_e1228.member > _e1254.member));
                                    let _e1260 = select(0f, _e1258, (_e1258 > 0f));
                                    let _e1262 = select(_e1254.member_1, _e1228.member_1, (_e1228.member_1 < _e1254.member_1));
                                    let _e1264 = select(1f, _e1262, (_e1262 < 1f));
                                    if (_e1260 > _e1264) {
                                        phi_4054_ = type_33(_e613.member.member_5.z, -2f);
                                    } else {
                                        let _e1267 = (_e613.member.member_1.z + (_e1204 * _e1260));
                                        let _e1269 = (_e613.member.member_1.z + (_e1204 * _e1264));
                                        phi_4054_ = type_33(select(_e1269, _e1267, (_e1267 < _e1269)), select(_e1269, _e1267, (_e1267 > _e1269)));
                                    }
                                    let _e1278 = phi_4054_;
                                    let _e1281 = (_e613.member.member.x - _e613.member.member_2.x);
                                    let _e1282 = (_e613.member.member.y - _e613.member.member_2.y);
                                    let _e1283 = (_e613.member.member.z - _e613.member.member_2.z);
                                    let _e1284 = (_e1118 - _e613.member.member_2.x);
                                    let _e1285 = (_e1120 - _e613.member.member_2.x);
                                    if (abs(_e1281) < 0.000001f) {
                                        if (_e1284 <= 0f) {
                                            let _e1296 = (_e1285 >= 0f);
                                            if _e1296 {
                                                phi_4103_ = type_33(0f, 1f);
                                            } else {
                                                phi_4103_ = type_33();
                                            }
                                            let _e1298 = phi_4103_;
                                            phi_4106_ = _e1298;
                                            phi_4107_ = select(true, false, _e1296);
                                        } else {
                                            phi_4106_ = type_33();
                                            phi_4107_ = true;
                                        }
                                        let _e1301 = phi_4106_;
                                        let _e1303 = phi_4107_;
                                        if _e1303 {
                                            phi_4112_ = type_33(1f, 0f);
                                        } else {
                                            phi_4112_ = _e1301;
                                        }
                                        let _e1305 = phi_4112_;
                                        phi_4114_ = _e1305;
                                    } else {
                                        let _e1288 = (_e1284 / _e1281);
                                        let _e1289 = (_e1285 / _e1281);
                                        phi_4114_ = type_33(select(_e1289, _e1288, (_e1288 < _e1289)), select(_e1289, _e1288, (_e1288 > _e1289)));
                                    }
                                    let _e1307 = phi_4114_;
                                    let _e1310 = (_e1147 - _e613.member.member_2.y);
                                    let _e1311 = (_e1149 - _e613.member.member_2.y);
                                    if (abs(_e1282) < 0.000001f) {
                                        if (_e1310 <= 0f) {
                                            let _e1322 = (_e1311 >= 0f);
                                            if _e1322 {
                                                phi_4150_ = type_33(0f, 1f);
                                            } else {
                                                phi_4150_ = type_33();
                                            }
                                            let _e1324 = phi_4150_;
                                            phi_4153_ = _e1324;
                                            phi_4154_ = select(true, false, _e1322);
                                        } else {
                                            phi_4153_ = type_33();
                                            phi_4154_ = true;
                                        }
                                        let _e1327 = phi_4153_;
                                        let _e1329 = phi_4154_;
                                        if _e1329 {
                                            phi_4159_ = type_33(1f, 0f);
                                        } else {
                                            phi_4159_ = _e1327;
                                        }
                                        let _e1331 = phi_4159_;
                                        phi_4161_ = _e1331;
                                    } else {
                                        let _e1314 = (_e1310 / _e1282);
                                        let _e1315 = (_e1311 / _e1282);
                                        phi_4161_ = type_33(select(_e1315, _e1314, (_e1314 < _e1315)), select(_e1315, _e1314, (_e1314 > _e1315)));
                                    }
                                    let _e1333 = phi_4161_;
                                    let _e1337 = select(_e1333.member, _e1307.member, (_e1307.member > _e1333.member));
                                    let _e1339 = select(0f, _e1337, (_e1337 > 0f));
                                    let _e1341 = select(_e1333.member_1, _e1307.member_1, (_e1307.member_1 < _e1333.member_1));
                                    let _e1343 = select(1f, _e1341, (_e1341 < 1f));
                                    if (_e1339 > _e1343) {
                                        phi_4209_ = type_33(_e613.member.member_5.z, -2f);
                                    } else {
                                        let _e1346 = (_e613.member.member_2.z + (_e1283 * _e1339));
                                        let _e1348 = (_e613.member.member_2.z + (_e1283 * _e1343));
                                        phi_4209_ = type_33(select(_e1348, _e1346, (_e1346 < _e1348)), select(_e1348, _e1346, (_e1346 > _e1348)));
                                    }
                                    let _e1357 = phi_4209_;
                                    let _e1361 = select(_e1278.member, _e1196.member, (_e1196.member < _e1278.member));
                                    let _e1367 = select(_e1278.member_1, _e1196.member_1, (_e1196.member_1 > _e1278.member_1));
                                    phi_2144_ = type_33((floor(select(_e1357.member, _e1361, (_e1361 < _e1357.member))) - 1f), (floor(select(_e1357.member_1, _e1367, (_e1367 > _e1357.member_1))) + 1f));
                                } else {
                                    if (_e613.member.member_4 == 0u) {
                                        phi_2102_ = vec3<f32>(_e613.member.member_3.y, _e613.member.member_3.z, _e613.member.member_3.x);
                                    } else {
                                        if (_e613.member.member_4 == 1u) {
                                            phi_2101_ = vec3<f32>(_e613.member.member_3.z, _e613.member.member_3.x, _e613.member.member_3.y);
                                        } else {
                                            phi_2101_ = _e613.member.member_3;
                                        }
                                        let _e1071 = phi_2101_;
                                        phi_2102_ = _e1071;
                                    }
                                    let _e1077 = phi_2102_;
                                    let _e1094 = (_e613.member.member.z - (((_e1077.x * ((f32(_e1063) + 0.5f) - _e613.member.member.x)) + (_e1077.y * ((f32(_e1062) + 0.5f) - _e613.member.member.y))) / _e1077.z));
                                    let _e1101 = (((0.5f * (abs(_e1077.x) + abs(_e1077.y))) / abs(_e1077.z)) + 0.3f);
                                    phi_2144_ = type_33((-1f - floor((_e1101 - _e1094))), floor((_e1094 + _e1101)));
                                }
                                let _e1374 = phi_2144_;
                                let _e1377 = f32(_e613.member_4);
                                let _e1379 = select(_e1377, _e1374.member, (_e1374.member > _e1377));
                                let _e1388 = f32(_e613.member_5);
                                let _e1390 = select(_e1388, _e1374.member_1, (_e1374.member_1 < _e1388));
                                phi_5126_ = select(0i, select(select(i32(_e1390), i32(-2147483648), (_e1390 < -2147483600f)), 2147483647i, (_e1390 > 2147483500f)), (_e1390 == _e1390));
                                phi_4603_ = (select(0i, select(select(i32(_e1379), i32(-2147483648), (_e1379 < -2147483600f)), 2147483647i, (_e1379 > 2147483500f)), (_e1379 == _e1379)) - 1i);
                                phi_4579_ = _e1062;
                                phi_4549_ = _e1063;
                            } else {
                                phi_5126_ = _e644;
                                let _e2662 = local_39;
                                phi_4603_ = _e2662;
                                phi_4579_ = _e648;
                                phi_4549_ = _e642;
                            }
                            let _e1399 = phi_5126_;
                            let _e1401 = phi_4603_;
                            let _e1403 = phi_4579_;
                            let _e1405 = phi_4549_;
                            phi_5125_ = _e1399;
                            phi_4602_ = _e1401;
                            phi_4578_ = _e1403;
                            phi_4548_ = _e1405;
                            let _e2671 = local_40;
                            phi_2184_ = _e2671;
                        } else {
                            phi_5125_ = _e644;
                            phi_4602_ = _e646;
                            phi_4578_ = _e648;
                            phi_4548_ = _e642;
                            phi_2184_ = false;
                        }
                        let _e1407 = phi_5125_;
                        let _e1409 = phi_4602_;
                        let _e1411 = phi_4578_;
                        let _e1413 = phi_4548_;
                        let _e1415 = phi_2184_;
                        local_35 = _e1413;
                        local_36 = _e1407;
                        local_37 = _e1409;
                        local_38 = _e1411;
                        local_10 = select(true, false, _e649);
                        local_11 = _e1413;
                        local_12 = _e1411;
                        local_13 = _e1409;
                        continue;
                        continuing {
                            phi_4313_ = _e1413;
                            phi_4310_ = _e1407;
                            phi_4307_ = _e1409;
                            phi_4304_ = _e1411;
                            break if !(_e1415);
                        }
                    }
                    let _e1419 = local_10;
                    let _e1421 = select(false, true, select(true, false, _e1419));
                    if _e1421 {
                        let _e1423 = local_11;
                        let _e1424 = f32(_e1423);
                        let _e1426 = local_12;
                        let _e1427 = f32(_e1426);
                        let _e1429 = local_13;
                        let _e1430 = f32(_e1429);
                        let _e1431 = vec3<f32>(_e1424, _e1427, _e1430);
                        if (_e613.member.member_4 == 2u) {
                            phi_2214_ = 2u;
                        } else {
                            phi_2214_ = (1u - _e613.member.member_4);
                        }
                        let _e1435 = phi_2214_;
                        if (_e1435 == 0u) {
                            phi_2226_ = vec3<f32>(_e1427, _e1430, _e1424);
                        } else {
                            if (_e1435 == 1u) {
                                phi_2225_ = vec3<f32>(_e1430, _e1424, _e1427);
                            } else {
                                phi_2225_ = _e1431;
                            }
                            let _e1440 = phi_2225_;
                            phi_2226_ = _e1440;
                        }
                        let _e1443 = phi_2226_;
                        let _e1449 = select(select(u32(_e1443.x), 0u, (_e1443.x < 0f)), 4294967295u, (_e1443.x > 4294967000f));
                        let _e1455 = select(select(u32(_e1443.y), 0u, (_e1443.y < 0f)), 4294967295u, (_e1443.y > 4294967000f));
                        let _e1461 = select(select(u32(_e1443.z), 0u, (_e1443.z < 0f)), 4294967295u, (_e1443.z > 4294967000f));
                        local_1.member = array<vec3<f32>, 10>((_e240 - _e1431), (_e247 - _e1431), (_e254 - _e1431), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        local_1.member_1 = 3u;
                        phi_4690_ = _e632;
                        phi_2282_ = type_12(0u, 6u);
                        loop {
                            let _e1469 = phi_4690_;
                            let _e1471 = phi_2282_;
                            if (_e1471.member < _e1471.member_1) {
                                phi_2283_ = type_12((_e1471.member + 1u), _e1471.member_1);
                                phi_2306_ = type_12(1u, _e1471.member);
                            } else {
                                phi_2283_ = _e1471;
                                phi_2306_ = type_12(0u, type_12().member_1);
                            }
                            let _e1484 = phi_2283_;
                            let _e1486 = phi_2306_;
                            let _e1490 = (bitcast<i32>(_e1486.member) != 0i);
                            if _e1490 {
                                let _e1491 = local_1.member_1;
                                phi_2318_ = type_12(0u, _e1491);
                                phi_2321_ = 0f;
                                loop {
                                    let _e1494 = phi_2318_;
                                    let _e1496 = phi_2321_;
                                    local_14 = _e1496;
                                    if (_e1494.member < _e1494.member_1) {
                                        phi_2319_ = type_12((_e1494.member + 1u), _e1494.member_1);
                                        phi_2344_ = type_12(1u, _e1494.member);
                                    } else {
                                        phi_2319_ = _e1494;
                                        phi_2344_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1509 = phi_2319_;
                                    let _e1511 = phi_2344_;
                                    let _e1515 = (bitcast<i32>(_e1511.member) != 0i);
                                    if _e1515 {
                                        if (_e1511.member_1 < 10u) {
                                        } else {
                                            phi_4685_ = true;
                                            break;
                                        }
                                        let _e1519 = local_1.member[_e1511.member_1];
                                        let _e1521 = (_e1486.member_1 >> bitcast<u32>(1i));
                                        let _e1528 = select(select(_e1519.y, _e1519.x, (_e1521 == 0u)), _e1519.z, (_e1521 == 2u));
                                        if ((_e1486.member_1 & 1u) == 1u) {
                                            phi_2379_ = (1f - _e1528);
                                        } else {
                                            phi_2379_ = _e1528;
                                        }
                                        let _e1533 = phi_2379_;
                                        phi_2322_ = select(_e1533, _e1496, (_e1496 < _e1533));
                                    } else {
                                        phi_2322_ = f32();
                                    }
                                    let _e1537 = phi_2322_;
                                    continue;
                                    continuing {
                                        phi_2318_ = _e1509;
                                        phi_2321_ = _e1537;
                                        phi_4685_ = _e1469;
                                        break if !(_e1515);
                                    }
                                }
                                let _e1540 = phi_4685_;
                                phi_4914_ = _e1540;
                                if _e1540 {
                                    break;
                                }
                                let _e1542 = local_14;
                                if (_e1542 >= 0f) {
                                    phi_4916_ = _e1540;
                                } else {
                                    let _e1544 = local_1.member_1;
                                    if (_e1544 == 0u) {
                                        phi_4917_ = _e1540;
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
                                        let _e1556 = local_1.member_1;
                                        let _e1557 = (_e1556 - 1u);
                                        if (_e1557 < 10u) {
                                        } else {
                                            phi_4914_ = true;
                                            break;
                                        }
                                        let _e1561 = local_1.member[_e1557];
                                        let _e1563 = (_e1486.member_1 >> bitcast<u32>(1i));
                                        let _e1567 = (_e1563 == 0u);
                                        let _e1569 = (_e1563 == 2u);
                                        let _e1570 = select(select(_e1561.y, _e1561.x, _e1567), _e1561.z, _e1569);
                                        let _e1572 = ((_e1486.member_1 & 1u) == 1u);
                                        if _e1572 {
                                            phi_2435_ = (1f - _e1570);
                                        } else {
                                            phi_2435_ = _e1570;
                                        }
                                        let _e1575 = phi_2435_;
                                        let _e1576 = local_1.member_1;
                                        phi_2440_ = type_12(0u, _e1576);
                                        phi_2443_ = _e1575;
                                        phi_2445_ = _e1561;
                                        phi_2447_ = 0u;
                                        loop {
                                            let _e1579 = phi_2440_;
                                            let _e1581 = phi_2443_;
                                            let _e1583 = phi_2445_;
                                            let _e1585 = phi_2447_;
                                            local_15 = _e1585;
                                            if (_e1579.member < _e1579.member_1) {
                                                phi_2441_ = type_12((_e1579.member + 1u), _e1579.member_1);
                                                phi_2470_ = type_12(1u, _e1579.member);
                                            } else {
                                                phi_2441_ = _e1579;
                                                phi_2470_ = type_12(0u, type_12().member_1);
                                            }
                                            let _e1598 = phi_2441_;
                                            let _e1600 = phi_2470_;
                                            let _e1604 = (bitcast<i32>(_e1600.member) != 0i);
                                            if _e1604 {
                                                if (_e1600.member_1 < 10u) {
                                                } else {
                                                    phi_4900_ = true;
                                                    break;
                                                }
                                                let _e1608 = local_1.member[_e1600.member_1];
                                                let _e1613 = select(select(_e1608.y, _e1608.x, _e1567), _e1608.z, _e1569);
                                                if _e1572 {
                                                    phi_2505_ = (1f - _e1613);
                                                } else {
                                                    phi_2505_ = _e1613;
                                                }
                                                let _e1616 = phi_2505_;
                                                if ((_e1616 < 0f) != (_e1581 < 0f)) {
                                                    let _e1620 = (_e1585 < 10u);
                                                    if _e1620 {
                                                        let _e1628 = (_e1581 / (_e1581 - _e1616));
                                                        if _e1620 {
                                                        } else {
                                                            phi_4900_ = true;
                                                            break;
                                                        }
                                                        local[_e1585] = (_e1583 + vec3<f32>(((_e1608.x - _e1583.x) * _e1628), ((_e1608.y - _e1583.y) * _e1628), ((_e1608.z - _e1583.z) * _e1628)));
                                                        phi_2539_ = (_e1585 + 1u);
                                                    } else {
                                                        phi_2539_ = _e1585;
                                                    }
                                                    let _e1637 = phi_2539_;
                                                    phi_2540_ = _e1637;
                                                } else {
                                                    phi_2540_ = _e1585;
                                                }
                                                let _e1639 = phi_2540_;
                                                if (_e1616 >= 0f) {
                                                    let _e1641 = (_e1639 < 10u);
                                                    if _e1641 {
                                                        if _e1641 {
                                                        } else {
                                                            phi_4900_ = true;
                                                            break;
                                                        }
                                                        local[_e1639] = _e1608;
                                                        phi_2556_ = (_e1639 + 1u);
                                                    } else {
                                                        phi_2556_ = _e1639;
                                                    }
                                                    let _e1645 = phi_2556_;
                                                    phi_2557_ = _e1645;
                                                } else {
                                                    phi_2557_ = _e1639;
                                                }
                                                let _e1647 = phi_2557_;
                                                phi_2444_ = _e1616;
                                                phi_2446_ = _e1608;
                                                phi_2448_ = _e1647;
                                            } else {
                                                phi_2444_ = f32();
                                                phi_2446_ = vec3<f32>();
                                                phi_2448_ = u32();
                                            }
                                            let _e1649 = phi_2444_;
                                            let _e1651 = phi_2446_;
                                            let _e1653 = phi_2448_;
                                            continue;
                                            continuing {
                                                phi_2440_ = _e1598;
                                                phi_2443_ = _e1649;
                                                phi_2445_ = _e1651;
                                                phi_2447_ = _e1653;
                                                phi_4900_ = _e1540;
                                                break if !(_e1604);
                                            }
                                        }
                                        let _e1656 = phi_4900_;
                                        phi_4914_ = _e1656;
                                        if _e1656 {
                                            break;
                                        }
                                        let _e1657 = local;
                                        local_1.member = _e1657;
                                        let _e1659 = local_15;
                                        local_1.member_1 = _e1659;
                                        phi_4917_ = _e1656;
                                    }
                                    let _e1661 = phi_4917_;
                                    phi_4916_ = _e1661;
                                }
                                let _e1663 = phi_4916_;
                                phi_4915_ = _e1663;
                            } else {
                                phi_4915_ = _e1469;
                            }
                            let _e1665 = phi_4915_;
                            continue;
                            continuing {
                                phi_4690_ = _e1665;
                                phi_2282_ = _e1484;
                                phi_4914_ = _e1665;
                                break if !(_e1490);
                            }
                        }
                        let _e1668 = phi_4914_;
                        phi_4926_ = _e1668;
                        if _e1668 {
                            break;
                        }
                        let _e1671 = local_1.member[0u];
                        let _e1675 = local_1.member_1;
                        phi_2569_ = type_12(1u, _e1675);
                        phi_2572_ = vec3<f32>(0f, 0f, 0f);
                        phi_2574_ = _e1671.z;
                        phi_2576_ = _e1671.y;
                        phi_2578_ = _e1671.x;
                        phi_2580_ = 0f;
                        loop {
                            let _e1678 = phi_2569_;
                            let _e1680 = phi_2572_;
                            let _e1682 = phi_2574_;
                            let _e1684 = phi_2576_;
                            let _e1686 = phi_2578_;
                            let _e1688 = phi_2580_;
                            local_16 = _e1686;
                            local_17 = _e1684;
                            local_18 = _e1682;
                            local_19 = _e1688;
                            local_20 = _e1680;
                            local_21 = _e1688;
                            local_22 = _e1680;
                            local_23 = _e1688;
                            local_24 = _e1680;
                            local_25 = _e1688;
                            local_26 = _e1688;
                            if (_e1678.member < _e1678.member_1) {
                                phi_2570_ = type_12((_e1678.member + 1u), _e1678.member_1);
                                phi_2603_ = type_12(1u, _e1678.member);
                            } else {
                                phi_2570_ = _e1678;
                                phi_2603_ = type_12(0u, type_12().member_1);
                            }
                            let _e1701 = phi_2570_;
                            let _e1703 = phi_2603_;
                            let _e1707 = (bitcast<i32>(_e1703.member) != 0i);
                            if _e1707 {
                                if (_e1703.member_1 < 10u) {
                                } else {
                                    phi_4918_ = true;
                                    break;
                                }
                                let _e1711 = local_1.member[_e1703.member_1];
                                let _e1721 = (_e1703.member_1 + 1u);
                                let _e1722 = local_1.member_1;
                                if (_e1721 < _e1722) {
                                    if (_e1721 < 10u) {
                                    } else {
                                        phi_4918_ = true;
                                        break;
                                    }
                                    let _e1727 = local_1.member[_e1721];
                                    let _e1728 = (_e1711.x - _e1671.x);
                                    let _e1729 = (_e1711.y - _e1671.y);
                                    let _e1730 = (_e1711.z - _e1671.z);
                                    let _e1732 = (_e1727.x - _e1671.x);
                                    let _e1734 = (_e1727.y - _e1671.y);
                                    let _e1736 = (_e1727.z - _e1671.z);
                                    let _e1739 = ((_e1729 * _e1736) - (_e1734 * _e1730));
                                    let _e1742 = ((_e1730 * _e1732) - (_e1736 * _e1728));
                                    let _e1745 = ((_e1728 * _e1734) - (_e1732 * _e1729));
                                    let _e1751 = sqrt((((_e1739 * _e1739) + (_e1742 * _e1742)) + (_e1745 * _e1745)));
                                    let _e1763 = (_e1751 * 0.16666667f);
                                    phi_2717_ = vec3<f32>((_e1680.x + (((_e1711.x + _e1727.x) - (_e1671.x * 2f)) * _e1763)), (_e1680.y + (((_e1711.y + _e1727.y) - (_e1671.y * 2f)) * _e1763)), (_e1680.z + (((_e1711.z + _e1727.z) - (_e1671.z * 2f)) * _e1763)));
                                    phi_2718_ = (_e1688 + (0.5f * _e1751));
                                } else {
                                    phi_2717_ = _e1680;
                                    phi_2718_ = _e1688;
                                }
                                let _e1775 = phi_2717_;
                                let _e1777 = phi_2718_;
                                phi_2573_ = _e1775;
                                phi_2575_ = select(_e1711.z, _e1682, (_e1682 < _e1711.z));
                                phi_2577_ = select(_e1711.y, _e1684, (_e1684 < _e1711.y));
                                phi_2579_ = select(_e1711.x, _e1686, (_e1686 < _e1711.x));
                                phi_2581_ = _e1777;
                            } else {
                                phi_2573_ = vec3<f32>();
                                phi_2575_ = f32();
                                phi_2577_ = f32();
                                phi_2579_ = f32();
                                phi_2581_ = f32();
                            }
                            let _e1779 = phi_2573_;
                            let _e1781 = phi_2575_;
                            let _e1783 = phi_2577_;
                            let _e1785 = phi_2579_;
                            let _e1787 = phi_2581_;
                            continue;
                            continuing {
                                phi_2569_ = _e1701;
                                phi_2572_ = _e1779;
                                phi_2574_ = _e1781;
                                phi_2576_ = _e1783;
                                phi_2578_ = _e1785;
                                phi_2580_ = _e1787;
                                phi_4918_ = _e1668;
                                break if !(_e1707);
                            }
                        }
                        let _e1790 = phi_4918_;
                        phi_4926_ = _e1790;
                        if _e1790 {
                            break;
                        }
                        let _e1791 = local_1.member_1;
                        if (_e1791 == 0u) {
                            phi_2737_ = bool();
                            phi_2738_ = true;
                        } else {
                            let _e1794 = local_16;
                            if (_e1794 >= 1f) {
                                phi_2735_ = bool();
                                phi_2736_ = true;
                            } else {
                                let _e1797 = local_17;
                                let _e1798 = (_e1797 >= 1f);
                                if _e1798 {
                                    phi_2734_ = bool();
                                } else {
                                    let _e1800 = local_18;
                                    phi_2734_ = (_e1800 >= 1f);
                                }
                                let _e1803 = phi_2734_;
                                phi_2735_ = _e1803;
                                phi_2736_ = _e1798;
                            }
                            let _e1805 = phi_2735_;
                            let _e1807 = phi_2736_;
                            phi_2737_ = _e1805;
                            phi_2738_ = _e1807;
                        }
                        let _e1809 = phi_2737_;
                        let _e1811 = phi_2738_;
                        let _e1814 = local_19;
                        if (_e1814 > 0f) {
                            let _e1817 = local_20;
                            let _e1820 = local_21;
                            let _e1823 = local_22;
                            let _e1826 = local_23;
                            let _e1829 = local_24;
                            let _e1832 = local_25;
                            phi_2755_ = (_e1671 + vec3<f32>((_e1817.x / _e1820), (_e1823.y / _e1826), (_e1829.z / _e1832)));
                        } else {
                            phi_2755_ = _e1671;
                        }
                        let _e1837 = phi_2755_;
                        let _e1839 = local_26;
                        let _e1843 = select(0f, _e1837.x, (_e1837.x > 0f));
                        let _e1845 = select(1f, _e1843, (_e1843 < 1f));
                        let _e1848 = select(0f, _e1837.y, (_e1837.y > 0f));
                        let _e1850 = select(1f, _e1848, (_e1848 < 1f));
                        let _e1853 = select(0f, _e1837.z, (_e1837.z > 0f));
                        let _e1855 = select(1f, _e1853, (_e1853 < 1f));
                        let _e1860 = local_27;
                        if (_e1860 < arrayLength((&attributes.member))) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e1862 = ((_e1845 + _e1424) - _e240.x);
                        let _e1863 = ((_e1850 + _e1427) - _e240.y);
                        let _e1866 = ((_e489 * _e498) - (_e490 * _e497));
                        if (abs(_e1866) > 0f) {
                            phi_2827_ = (1f / _e1866);
                        } else {
                            phi_2827_ = 0f;
                        }
                        let _e1871 = phi_2827_;
                        let _e1875 = (((_e1862 * _e498) - (_e1863 * _e497)) * _e1871);
                        let _e1877 = select(0f, _e1875, (_e1875 > 0f));
                        let _e1879 = select(1f, _e1877, (_e1877 < 1f));
                        let _e1883 = (((_e489 * _e1863) - (_e490 * _e1862)) * _e1871);
                        let _e1885 = select(0f, _e1883, (_e1883 > 0f));
                        let _e1887 = select(1f, _e1885, (_e1885 < 1f));
                        let _e1889 = ((1f - _e1879) - _e1887);
                        let _e1892 = local_28;
                        let _e1896 = attributes.member[_e1892].member[0u];
                        let _e1900 = local_29;
                        let _e1904 = attributes.member[_e1900].member[2u];
                        let _e1909 = local_30;
                        let _e1913 = attributes.member[_e1909].member[4u];
                        let _e1915 = (((_e1896 * _e1889) + (_e1904 * _e1879)) + (_e1913 * _e1887));
                        let _e1918 = local_31;
                        let _e1922 = attributes.member[_e1918].member[1u];
                        let _e1926 = local_32;
                        let _e1930 = attributes.member[_e1926].member[3u];
                        let _e1935 = local_33;
                        let _e1939 = attributes.member[_e1935].member[5u];
                        let _e1941 = (((_e1922 * _e1889) + (_e1930 * _e1879)) + (_e1939 * _e1887));
                        if (_e386 == 4294967295u) {
                            phi_3176_ = type_30(vec3<f32>(_e369, _e375, _e381), _e415);
                        } else {
                            let _e1944 = (_e409 & 65535u);
                            let _e1946 = (_e409 >> bitcast<u32>(16i));
                            let _e1948 = (_e1915 - floor(_e1915));
                            let _e1953 = ((select(0f, _e1948, (_e1948 <= 1f)) * f32(_e1944)) - 0.5f);
                            let _e1954 = floor(_e1953);
                            let _e1955 = (_e1953 - _e1954);
                            let _e1956 = (_e1944 - 1u);
                            if (_e1954 < 0f) {
                                phi_2917_ = _e1956;
                            } else {
                                let _e1962 = select(select(u32(_e1954), 0u, (_e1954 < 0f)), 4294967295u, (_e1954 > 4294967000f));
                                phi_2917_ = select(_e1962, _e1956, (_e1956 < _e1962));
                            }
                            let _e1966 = phi_2917_;
                            if (_e1966 == _e1956) {
                                phi_2923_ = 0u;
                            } else {
                                phi_2923_ = (_e1966 + 1u);
                            }
                            let _e1970 = phi_2923_;
                            let _e1972 = (_e1941 - floor(_e1941));
                            let _e1977 = ((select(0f, _e1972, (_e1972 <= 1f)) * f32(_e1946)) - 0.5f);
                            let _e1978 = floor(_e1977);
                            let _e1979 = (_e1977 - _e1978);
                            let _e1980 = (_e1946 - 1u);
                            if (_e1978 < 0f) {
                                phi_2953_ = _e1980;
                            } else {
                                let _e1986 = select(select(u32(_e1978), 0u, (_e1978 < 0f)), 4294967295u, (_e1978 > 4294967000f));
                                phi_2953_ = select(_e1986, _e1980, (_e1980 < _e1986));
                            }
                            let _e1990 = phi_2953_;
                            if (_e1990 == _e1980) {
                                phi_2959_ = 0u;
                            } else {
                                phi_2959_ = (_e1990 + 1u);
                            }
                            let _e1994 = phi_2959_;
                            let _e1996 = (_e386 + (_e1990 * _e1944));
                            let _e1998 = (_e386 + (_e1994 * _e1944));
                            let _e1999 = (_e1996 + _e1966);
                            let _e2000 = (_e1996 + _e1970);
                            let _e2001 = (_e1998 + _e1966);
                            let _e2002 = (_e1998 + _e1970);
                            if (_e1999 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2006 = surfaces.member[_e1999];
                            if (_e2000 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2010 = surfaces.member[_e2000];
                            if (_e2001 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2014 = surfaces.member[_e2001];
                            if (_e2002 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2018 = surfaces.member[_e2002];
                            let _e2019 = (_e2006 & 255u);
                            if (_e2019 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2023 = surfaces.member[_e2019];
                            let _e2027 = ((_e2006 >> bitcast<u32>(8i)) & 255u);
                            if (_e2027 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2031 = surfaces.member[_e2027];
                            let _e2035 = ((_e2006 >> bitcast<u32>(16i)) & 255u);
                            if (_e2035 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2039 = surfaces.member[_e2035];
                            let _e2041 = (1f - _e1955);
                            let _e2045 = (_e2010 & 255u);
                            if (_e2045 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2049 = surfaces.member[_e2045];
                            let _e2053 = ((_e2010 >> bitcast<u32>(8i)) & 255u);
                            if (_e2053 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2057 = surfaces.member[_e2053];
                            let _e2061 = ((_e2010 >> bitcast<u32>(16i)) & 255u);
                            if (_e2061 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2065 = surfaces.member[_e2061];
                            let _e2073 = (_e2014 & 255u);
                            if (_e2073 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2077 = surfaces.member[_e2073];
                            let _e2081 = ((_e2014 >> bitcast<u32>(8i)) & 255u);
                            if (_e2081 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2085 = surfaces.member[_e2081];
                            let _e2089 = ((_e2014 >> bitcast<u32>(16i)) & 255u);
                            if (_e2089 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2093 = surfaces.member[_e2089];
                            let _e2098 = (_e2018 & 255u);
                            if (_e2098 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2102 = surfaces.member[_e2098];
                            let _e2106 = ((_e2018 >> bitcast<u32>(8i)) & 255u);
                            if (_e2106 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2110 = surfaces.member[_e2106];
                            let _e2114 = ((_e2018 >> bitcast<u32>(16i)) & 255u);
                            if (_e2114 < _e93) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2118 = surfaces.member[_e2114];
                            let _e2126 = (1f - _e1979);
                            phi_3176_ = type_30(vec3<f32>((_e369 * ((((bitcast<f32>(_e2023) * _e2041) + (bitcast<f32>(_e2049) * _e1955)) * _e2126) + (((bitcast<f32>(_e2077) * _e2041) + (bitcast<f32>(_e2102) * _e1955)) * _e1979))), (_e375 * ((((bitcast<f32>(_e2031) * _e2041) + (bitcast<f32>(_e2057) * _e1955)) * _e2126) + (((bitcast<f32>(_e2085) * _e2041) + (bitcast<f32>(_e2110) * _e1955)) * _e1979))), (_e381 * ((((bitcast<f32>(_e2039) * _e2041) + (bitcast<f32>(_e2065) * _e1955)) * _e2126) + (((bitcast<f32>(_e2093) * _e2041) + (bitcast<f32>(_e2118) * _e1955)) * _e1979)))), (_e415 * (((((f32((_e2006 >> bitcast<u32>(24i))) * 0.003921569f) * _e2041) + ((f32((_e2010 >> bitcast<u32>(24i))) * 0.003921569f) * _e1955)) * _e2126) + ((((f32((_e2014 >> bitcast<u32>(24i))) * 0.003921569f) * _e2041) + ((f32((_e2018 >> bitcast<u32>(24i))) * 0.003921569f) * _e1955)) * _e1979))));
                        }
                        let _e2169 = phi_3176_;
                        if (_e215 == 2u) {
                            phi_3206_ = 2u;
                        } else {
                            phi_3206_ = (1u - _e215);
                        }
                        let _e2188 = phi_3206_;
                        if (_e2188 == 0u) {
                            phi_3218_ = vec3<f32>(_e1850, _e1855, _e1845);
                        } else {
                            if (_e2188 == 1u) {
                                phi_3217_ = vec3<f32>(_e1855, _e1845, _e1850);
                            } else {
                                phi_3217_ = vec3<f32>(_e1845, _e1850, _e1855);
                            }
                            let _e2193 = phi_3217_;
                            phi_3218_ = _e2193;
                        }
                        let _e2196 = phi_3218_;
                        let _e2200 = params.member.member_2[0u];
                        let _e2214 = (((_e2200.z + (_e1449 >> bitcast<u32>(2i))) + (_e2200.x * (_e1455 >> bitcast<u32>(2i)))) + (_e2200.y * (_e1461 >> bitcast<u32>(1i))));
                        let _e2237 = cells.member[((2u * _e2214) + 1u)];
                        phi_3253_ = type_12(0u, 6u);
                        phi_3256_ = _e2237;
                        loop {
                            let _e2239 = phi_3253_;
                            let _e2241 = phi_3256_;
                            local_34 = _e2241;
                            if (_e2239.member < _e2239.member_1) {
                                phi_3254_ = type_12((_e2239.member + 1u), _e2239.member_1);
                                phi_3279_ = type_12(1u, _e2239.member);
                            } else {
                                phi_3254_ = _e2239;
                                phi_3279_ = type_12(0u, type_12().member_1);
                            }
                            let _e2254 = phi_3254_;
                            let _e2256 = phi_3279_;
                            let _e2260 = (bitcast<i32>(_e2256.member) != 0i);
                            if _e2260 {
                                let _e2264 = facet_bits.member[((_e2214 * 6u) + _e2256.member_1)];
                                let _e2265 = ((((((_e1449 & 1u) | ((_e1455 & 1u) << bitcast<u32>(1i))) | ((_e1461 & 1u) << bitcast<u32>(2i))) | ((_e1449 & 2u) << bitcast<u32>(2i))) | ((_e1455 & 2u) << bitcast<u32>(3i))) & 31u);
                                let _e2271 = (_e2241 + countOneBits((_e2264 & ((1u << bitcast<u32>(_e2265)) - 1u))));
                                if (_e2256.member_1 < ((2u * _e333) + select(0u, 1u, (_e338 < 0f)))) {
                                    phi_3304_ = (_e2271 + ((_e2264 >> bitcast<u32>(_e2265)) & 1u));
                                } else {
                                    phi_3304_ = _e2271;
                                }
                                let _e2278 = phi_3304_;
                                phi_3257_ = _e2278;
                            } else {
                                phi_3257_ = u32();
                            }
                            let _e2280 = phi_3257_;
                            continue;
                            continuing {
                                phi_3253_ = _e2254;
                                phi_3256_ = _e2280;
                                break if !(_e2260);
                            }
                        }
                        let _e2284 = local_34;
                        let _e2285 = (_e2284 * 13u);
                        let _e2288 = params.member.member_7;
                        let _e2291 = floor((((select(_e1839, 0f, select(_e1809, true, _e1811)) * select(1f, 0f, (_e2169.member_1 < bitcast<f32>(_e420)))) * _e2288) + 0.5f));
                        let _e2293 = select(_e2291, 1f, (_e2291 < 1f));
                        let _e2298 = select(select(u32(_e2293), 0u, (_e2293 < 0f)), 4294967295u, (_e2293 > 4294967000f));
                        if (_e2285 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2302 = atomicAdd((&sums.member[_e2285]), _e2298);
                        if (_e2302 >= (2147483648u - select(_e2298, 2147483648u, (2147483648u < _e2298)))) {
                            let _e2309 = params.member.member_5;
                            let _e2310 = (_e2309 * 13u);
                            if (_e2310 < _e97) {
                            } else {
                                phi_4926_ = true;
                                break;
                            }
                            let _e2314 = atomicOr((&sums.member[_e2310]), 1u);
                        }
                        let _e2315 = (_e2285 + 1u);
                        let _e2323 = floor(((_e356.x * _e2293) + 0.5f));
                        if (_e2315 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2335 = atomicAdd((&sums.member[_e2315]), bitcast<u32>(select(0i, select(select(i32(_e2323), i32(-2147483648), (_e2323 < -2147483600f)), 2147483647i, (_e2323 > 2147483500f)), (_e2323 == _e2323))));
                        let _e2336 = (_e2285 + 2u);
                        let _e2338 = floor(((_e356.y * _e2293) + 0.5f));
                        if (_e2336 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2350 = atomicAdd((&sums.member[_e2336]), bitcast<u32>(select(0i, select(select(i32(_e2338), i32(-2147483648), (_e2338 < -2147483600f)), 2147483647i, (_e2338 > 2147483500f)), (_e2338 == _e2338))));
                        let _e2351 = (_e2285 + 3u);
                        let _e2353 = floor(((_e356.z * _e2293) + 0.5f));
                        if (_e2351 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2365 = atomicAdd((&sums.member[_e2351]), bitcast<u32>(select(0i, select(select(i32(_e2353), i32(-2147483648), (_e2353 < -2147483600f)), 2147483647i, (_e2353 > 2147483500f)), (_e2353 == _e2353))));
                        let _e2366 = (_e2285 + 4u);
                        let _e2374 = floor(((_e2196.x * _e2293) + 0.5f));
                        if (_e2366 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2386 = atomicAdd((&sums.member[_e2366]), bitcast<u32>(select(0i, select(select(i32(_e2374), i32(-2147483648), (_e2374 < -2147483600f)), 2147483647i, (_e2374 > 2147483500f)), (_e2374 == _e2374))));
                        let _e2387 = (_e2285 + 5u);
                        let _e2389 = floor(((_e2196.y * _e2293) + 0.5f));
                        if (_e2387 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2401 = atomicAdd((&sums.member[_e2387]), bitcast<u32>(select(0i, select(select(i32(_e2389), i32(-2147483648), (_e2389 < -2147483600f)), 2147483647i, (_e2389 > 2147483500f)), (_e2389 == _e2389))));
                        let _e2402 = (_e2285 + 6u);
                        let _e2404 = floor(((_e2196.z * _e2293) + 0.5f));
                        if (_e2402 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2416 = atomicAdd((&sums.member[_e2402]), bitcast<u32>(select(0i, select(select(i32(_e2404), i32(-2147483648), (_e2404 < -2147483600f)), 2147483647i, (_e2404 > 2147483500f)), (_e2404 == _e2404))));
                        let _e2417 = (_e2285 + 7u);
                        let _e2422 = floor(((select(1f, _e2169.member.x, (_e2169.member.x < 1f)) * _e2293) + 0.5f));
                        if (_e2417 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2434 = atomicAdd((&sums.member[_e2417]), bitcast<u32>(select(0i, select(select(i32(_e2422), i32(-2147483648), (_e2422 < -2147483600f)), 2147483647i, (_e2422 > 2147483500f)), (_e2422 == _e2422))));
                        let _e2435 = (_e2285 + 8u);
                        let _e2437 = floor(((select(1f, _e2169.member.y, (_e2169.member.y < 1f)) * _e2293) + 0.5f));
                        if (_e2435 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2449 = atomicAdd((&sums.member[_e2435]), bitcast<u32>(select(0i, select(select(i32(_e2437), i32(-2147483648), (_e2437 < -2147483600f)), 2147483647i, (_e2437 > 2147483500f)), (_e2437 == _e2437))));
                        let _e2450 = (_e2285 + 9u);
                        let _e2452 = floor(((select(1f, _e2169.member.z, (_e2169.member.z < 1f)) * _e2293) + 0.5f));
                        if (_e2450 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2464 = atomicAdd((&sums.member[_e2450]), bitcast<u32>(select(0i, select(select(i32(_e2452), i32(-2147483648), (_e2452 < -2147483600f)), 2147483647i, (_e2452 > 2147483500f)), (_e2452 == _e2452))));
                        let _e2465 = (_e2285 + 10u);
                        let _e2468 = params.member.member_8;
                        let _e2469 = (_e2293 / _e2468);
                        let _e2474 = floor(((bitcast<f32>(_e391) * _e2469) + 0.5f));
                        if (_e2465 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2486 = atomicAdd((&sums.member[_e2465]), bitcast<u32>(select(0i, select(select(i32(_e2474), i32(-2147483648), (_e2474 < -2147483600f)), 2147483647i, (_e2474 > 2147483500f)), (_e2474 == _e2474))));
                        let _e2487 = (_e2285 + 11u);
                        let _e2489 = floor(((bitcast<f32>(_e397) * _e2469) + 0.5f));
                        if (_e2487 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2501 = atomicAdd((&sums.member[_e2487]), bitcast<u32>(select(0i, select(select(i32(_e2489), i32(-2147483648), (_e2489 < -2147483600f)), 2147483647i, (_e2489 > 2147483500f)), (_e2489 == _e2489))));
                        let _e2502 = (_e2285 + 12u);
                        let _e2504 = floor(((bitcast<f32>(_e403) * _e2469) + 0.5f));
                        if (_e2502 < _e97) {
                        } else {
                            phi_4926_ = true;
                            break;
                        }
                        let _e2516 = atomicAdd((&sums.member[_e2502]), bitcast<u32>(select(0i, select(select(i32(_e2504), i32(-2147483648), (_e2504 < -2147483600f)), 2147483647i, (_e2504 > 2147483500f)), (_e2504 == _e2504))));
                        phi_4927_ = _e1790;
                    } else {
                        phi_4927_ = _e632;
                    }
                    let _e2518 = phi_4927_;
                    continue;
                    continuing {
                        phi_4698_ = _e2518;
                        let _e2559 = local_35;
                        phi_4314_ = _e2559;
                        let _e2562 = local_36;
                        phi_4311_ = _e2562;
                        let _e2565 = local_37;
                        phi_4308_ = _e2565;
                        let _e2568 = local_38;
                        phi_4305_ = _e2568;
                        phi_4926_ = _e2518;
                        break if !(_e1421);
                    }
                }
                let _e2521 = phi_4926_;
                if _e2521 {
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
