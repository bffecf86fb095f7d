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

struct type_35 {
    member: f32,
    member_1: f32,
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
var<storage, read_write> out: type_29;

fn function_() {
    var phi_187_: vec3<f32>;
    var phi_194_: vec3<f32>;
    var phi_350_: f32;
    var phi_358_: f32;
    var phi_360_: type_35;
    var phi_4028_: bool;
    var phi_385_: type_8;
    var phi_388_: vec3<f32>;
    var phi_386_: type_8;
    var phi_411_: type_8;
    var phi_492_: f32;
    var phi_494_: f32;
    var phi_506_: f32;
    var phi_508_: f32;
    var phi_520_: f32;
    var phi_522_: f32;
    var phi_572_: f32;
    var phi_574_: f32;
    var phi_586_: f32;
    var phi_588_: f32;
    var phi_600_: f32;
    var phi_602_: f32;
    var phi_4006_: bool;
    var phi_620_: type_8;
    var phi_623_: vec3<f32>;
    var phi_625_: f32;
    var phi_627_: f32;
    var phi_629_: f32;
    var phi_621_: type_8;
    var phi_652_: type_8;
    var phi_722_: u32;
    var phi_787_: bool;
    var phi_793_: bool;
    var phi_798_: u32;
    var phi_804_: u32;
    var phi_843_: f32;
    var phi_869_: bool;
    var phi_875_: bool;
    var phi_880_: u32;
    var phi_886_: u32;
    var phi_925_: f32;
    var phi_951_: bool;
    var phi_957_: bool;
    var phi_962_: u32;
    var phi_968_: u32;
    var phi_1007_: f32;
    var phi_3975_: bool;
    var phi_1014_: type_8;
    var phi_1017_: vec4<f32>;
    var phi_1015_: type_8;
    var phi_1040_: type_8;
    var phi_1625_: vec4<f32>;
    var phi_1662_: vec4<f32>;
    var phi_1703_: vec4<f32>;
    var phi_1597_: vec4<f32>;
    var phi_1718_: vec4<f32>;
    var phi_1139_: type_8;
    var phi_1142_: u32;
    var phi_1140_: type_8;
    var phi_1165_: type_8;
    var phi_1143_: u32;
    var phi_3961_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1414_: type_8;
    var phi_1417_: vec4<f32>;
    var phi_1419_: vec4<f32>;
    var phi_1415_: type_8;
    var phi_1442_: type_8;
    var phi_1526_: vec4<f32>;
    var phi_1527_: vec4<f32>;
    var phi_1418_: vec4<f32>;
    var phi_1420_: vec4<f32>;
    var phi_4037_: bool;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_1549_: vec4<f32>;
    var local_8: u32;
    var local_9: u32;
    var phi_1282_: type_8;
    var phi_1285_: vec4<f32>;
    var phi_1283_: type_8;
    var phi_1308_: type_8;
    var phi_1286_: vec4<f32>;
    var phi_4042_: bool;
    var phi_4059_: bool;
    var phi_1550_: vec4<f32>;
    var phi_4053_: bool;
    var phi_1719_: vec4<f32>;
    var phi_4052_: bool;
    var phi_1740_: vec4<f32>;
    var phi_4051_: bool;
    var phi_1741_: vec4<f32>;
    var phi_4050_: bool;
    var phi_1018_: vec4<f32>;
    var phi_4049_: bool;
    var local_10: vec4<f32>;
    var phi_1796_: bool;
    var phi_1802_: bool;
    var phi_1807_: u32;
    var phi_1813_: u32;
    var phi_1852_: f32;
    var phi_1878_: bool;
    var phi_1884_: bool;
    var phi_1889_: u32;
    var phi_1895_: u32;
    var phi_1934_: f32;
    var phi_1960_: bool;
    var phi_1966_: bool;
    var phi_1971_: u32;
    var phi_1977_: u32;
    var phi_2016_: f32;
    var phi_4075_: bool;
    var phi_2023_: type_8;
    var phi_2026_: vec4<f32>;
    var phi_2024_: type_8;
    var phi_2049_: type_8;
    var phi_2634_: vec4<f32>;
    var phi_2671_: vec4<f32>;
    var phi_2712_: vec4<f32>;
    var phi_2606_: vec4<f32>;
    var phi_2727_: vec4<f32>;
    var phi_2148_: type_8;
    var phi_2151_: u32;
    var phi_2149_: type_8;
    var phi_2174_: type_8;
    var phi_2152_: u32;
    var phi_4061_: bool;
    var local_11: u32;
    var local_12: u32;
    var phi_2423_: type_8;
    var phi_2426_: vec4<f32>;
    var phi_2428_: vec4<f32>;
    var phi_2424_: type_8;
    var phi_2451_: type_8;
    var phi_2535_: vec4<f32>;
    var phi_2536_: vec4<f32>;
    var phi_2427_: vec4<f32>;
    var phi_2429_: vec4<f32>;
    var phi_4101_: bool;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var phi_2558_: vec4<f32>;
    var local_19: u32;
    var local_20: u32;
    var phi_2291_: type_8;
    var phi_2294_: vec4<f32>;
    var phi_2292_: type_8;
    var phi_2317_: type_8;
    var phi_2295_: vec4<f32>;
    var phi_4106_: bool;
    var phi_4123_: bool;
    var phi_2559_: vec4<f32>;
    var phi_4117_: bool;
    var phi_2728_: vec4<f32>;
    var phi_4116_: bool;
    var phi_2749_: vec4<f32>;
    var phi_4115_: bool;
    var phi_2750_: vec4<f32>;
    var phi_4114_: bool;
    var phi_2027_: vec4<f32>;
    var phi_4113_: bool;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var phi_4166_: bool;
    var phi_2776_: vec4<f32>;
    var phi_4165_: bool;
    var phi_2777_: vec4<f32>;
    var phi_2778_: bool;
    var phi_4164_: bool;
    var phi_2779_: vec4<f32>;
    var phi_2780_: bool;
    var phi_2781_: bool;
    var phi_2834_: bool;
    var phi_2840_: bool;
    var phi_2845_: u32;
    var phi_2851_: u32;
    var phi_2890_: f32;
    var phi_2916_: bool;
    var phi_2922_: bool;
    var phi_2927_: u32;
    var phi_2933_: u32;
    var phi_2972_: f32;
    var phi_2998_: bool;
    var phi_3004_: bool;
    var phi_3009_: u32;
    var phi_3015_: u32;
    var phi_3054_: f32;
    var phi_4139_: bool;
    var phi_3061_: type_8;
    var phi_3064_: vec4<f32>;
    var phi_3062_: type_8;
    var phi_3087_: type_8;
    var phi_3672_: vec4<f32>;
    var phi_3709_: vec4<f32>;
    var phi_3750_: vec4<f32>;
    var phi_3644_: vec4<f32>;
    var phi_3765_: vec4<f32>;
    var phi_3186_: type_8;
    var phi_3189_: u32;
    var phi_3187_: type_8;
    var phi_3212_: type_8;
    var phi_3190_: u32;
    var phi_4125_: bool;
    var local_28: u32;
    var local_29: u32;
    var phi_3461_: type_8;
    var phi_3464_: vec4<f32>;
    var phi_3466_: vec4<f32>;
    var phi_3462_: type_8;
    var phi_3489_: type_8;
    var phi_3573_: vec4<f32>;
    var phi_3574_: vec4<f32>;
    var phi_3465_: vec4<f32>;
    var phi_3467_: vec4<f32>;
    var phi_4168_: bool;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var phi_3596_: vec4<f32>;
    var local_36: u32;
    var local_37: u32;
    var phi_3329_: type_8;
    var phi_3332_: vec4<f32>;
    var phi_3330_: type_8;
    var phi_3355_: type_8;
    var phi_3333_: vec4<f32>;
    var phi_4173_: bool;
    var phi_4190_: bool;
    var phi_3597_: vec4<f32>;
    var phi_4184_: bool;
    var phi_3766_: vec4<f32>;
    var phi_4183_: bool;
    var phi_3787_: vec4<f32>;
    var phi_4182_: bool;
    var phi_3788_: vec4<f32>;
    var phi_4181_: bool;
    var phi_3065_: vec4<f32>;
    var phi_4180_: bool;
    var local_38: vec4<f32>;
    var phi_4198_: bool;
    var phi_3790_: vec4<f32>;
    var phi_3829_: vec3<f32>;
    var phi_3830_: f32;
    var phi_4195_: bool;
    var phi_3833_: vec3<f32>;
    var phi_3834_: f32;
    var phi_3835_: f32;
    var phi_3836_: f32;
    var phi_4194_: bool;
    var phi_3838_: vec3<f32>;
    var phi_3839_: f32;
    var phi_3840_: f32;
    var phi_3841_: f32;
    var phi_3842_: bool;
    var phi_4193_: bool;
    var phi_624_: vec3<f32>;
    var phi_626_: f32;
    var phi_628_: f32;
    var phi_630_: f32;
    var phi_3844_: bool;
    var phi_4192_: bool;
    var local_39: f32;
    var local_40: f32;
    var local_41: vec3<f32>;
    var local_42: vec3<f32>;
    var local_43: vec3<f32>;
    var phi_4201_: bool;
    var phi_389_: vec3<f32>;
    var phi_4200_: bool;
    var local_44: vec3<f32>;
    var local_45: vec3<f32>;
    var local_46: vec3<f32>;
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
            let _e104 = params.member.member_8;
            let _e108 = (_e81.x + (_e81.y * 2097152u));
            if (_e108 < _e104) {
                let _e110 = (_e108 / 2u);
                if (_e110 < _e90) {
                } else {
                    break;
                }
                let _e114 = facets.member[_e110];
                let _e124 = sqrt((((_e114.member_2[0] * _e114.member_2[0]) + (_e114.member_2[1] * _e114.member_2[1])) + (_e114.member_2[2] * _e114.member_2[2])));
                if (_e124 > 0.000000000001f) {
                    phi_187_ = vec3<f32>((_e114.member_2[0] / _e124), (_e114.member_2[1] / _e124), (_e114.member_2[2] / _e124));
                } else {
                    phi_187_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e131 = phi_187_;
                if ((_e108 & 1u) == 0u) {
                    phi_194_ = _e131;
                } else {
                    phi_194_ = -(_e131);
                }
                let _e136 = phi_194_;
                let _e143 = params.member.member;
                let _e156 = params.member.member_12;
                let _e163 = (((_e114.member[0] - _e143.x) / _e143.w) + (_e136.x * _e156));
                let _e164 = (((_e114.member[1] - _e143.y) / _e143.w) + (_e136.y * _e156));
                let _e165 = (((_e114.member[2] - _e143.z) / _e143.w) + (_e136.z * _e156));
                let _e169 = bitcast<f32>((1065353216u | (bitcast<u32>(_e136.z) & 2147483648u)));
                let _e171 = (-1f / (_e169 + _e136.z));
                let _e173 = ((_e136.x * _e136.y) * _e171);
                let _e177 = (1f + (((_e169 * _e136.x) * _e136.x) * _e171));
                let _e178 = (_e169 * _e173);
                let _e180 = (-(_e169) * _e136.x);
                let _e183 = (_e169 + ((_e136.y * _e136.y) * _e171));
                let _e184 = -(_e136.y);
                let _e187 = params.member.member_9;
                if (_e187 == 0u) {
                    phi_360_ = type_35(0f, 1f);
                } else {
                    let _e192 = ((_e108 * 1664525u) + 1013904223u);
                    let _e194 = (((_e187 * 1664525u) + 1013904223u) + (_e192 * 1013904223u));
                    let _e196 = (_e192 + (1013904223u * _e194));
                    let _e200 = (1013904223u + (_e196 * (1013904223u + (_e194 * _e196))));
                    let _e214 = f32((((_e194 ^ (_e194 >> bitcast<u32>(16i))) + ((_e196 ^ (_e196 >> bitcast<u32>(16i))) * (_e200 ^ (_e200 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i)));
                    let _e218 = floor(((_e214 * 0.00000023841858f) + 0.5f));
                    let _e224 = ((((_e214 * 0.00000037450704f) - (_e218 * 1.5703125f)) - (_e218 * 0.0004837513f)) - (_e218 * 0.0000000754979f));
                    let _e225 = (_e224 * _e224);
                    let _e232 = (_e224 + ((_e224 * _e225) * (-0.16666655f + (_e225 * (0.008332161f + (_e225 * -0.00019515296f))))));
                    let _e241 = ((1f - (0.5f * _e225)) + ((_e225 * _e225) * (0.041666646f + (_e225 * (-0.0013887316f + (_e225 * 0.000024433157f))))));
                    let _e248 = select(0i, select(select(i32(_e218), i32(-2147483648), (_e218 < -2147483600f)), 2147483647i, (_e218 > 2147483500f)), (_e218 == _e218));
                    let _e250 = ((_e248 & 1i) == 0i);
                    let _e251 = select(_e241, _e232, _e250);
                    let _e252 = select(_e232, _e241, _e250);
                    if ((_e248 & 2i) == 0i) {
                        phi_350_ = _e251;
                    } else {
                        phi_350_ = -(_e251);
                    }
                    let _e257 = phi_350_;
                    if (((_e248 + 1i) & 2i) == 0i) {
                        phi_358_ = _e252;
                    } else {
                        phi_358_ = -(_e252);
                    }
                    let _e263 = phi_358_;
                    phi_360_ = type_35(_e257, _e263);
                }
                let _e266 = phi_360_;
                let _e289 = params.member.member_6;
                phi_4028_ = false;
                phi_385_ = type_8(0u, _e289);
                phi_388_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e292 = phi_4028_;
                    let _e294 = phi_385_;
                    let _e296 = phi_388_;
                    local_44 = _e296;
                    local_45 = _e296;
                    local_46 = _e296;
                    if (_e294.member < _e294.member_1) {
                        phi_386_ = type_8((_e294.member + 1u), _e294.member_1);
                        phi_411_ = type_8(1u, _e294.member);
                    } else {
                        phi_386_ = _e294;
                        phi_411_ = type_8(0u, type_8().member_1);
                    }
                    let _e309 = phi_386_;
                    let _e311 = phi_411_;
                    let _e315 = (bitcast<i32>(_e311.member) != 0i);
                    if _e315 {
                        if (_e311.member_1 < 16u) {
                        } else {
                            phi_4200_ = true;
                            break;
                        }
                        let _e321 = params.member.member_3[_e311.member_1][0u];
                        let _e326 = params.member.member_3[_e311.member_1][1u];
                        let _e331 = params.member.member_3[_e311.member_1][2u];
                        let _e336 = params.member.member_3[_e311.member_1][3u];
                        let _e349 = (((((_e177 * _e266.member_1) + (_e173 * _e266.member)) * _e321) + (((_e173 * _e266.member_1) - (_e177 * _e266.member)) * _e326)) + (_e136.x * _e331));
                        let _e350 = (((((_e178 * _e266.member_1) + (_e183 * _e266.member)) * _e321) + (((_e183 * _e266.member_1) - (_e178 * _e266.member)) * _e326)) + (_e136.y * _e331));
                        let _e351 = (((((_e180 * _e266.member_1) + (_e184 * _e266.member)) * _e321) + (((_e184 * _e266.member_1) - (_e180 * _e266.member)) * _e326)) + (_e136.z * _e331));
                        let _e354 = params.member.member_10;
                        let _e357 = params.member.member_13;
                        let _e358 = (_e357 * _e156);
                        let _e359 = (_e357 * _e331);
                        let _e362 = params.member.member_11;
                        let _e365 = params.member.member_1;
                        let _e367 = f32(_e365.x);
                        let _e369 = f32(_e365.y);
                        let _e371 = f32(_e365.z);
                        let _e372 = abs(_e349);
                        let _e373 = (_e372 < 0.000000001f);
                        if _e373 {
                            phi_494_ = 340282350000000000000000000000000000000f;
                        } else {
                            if (_e349 > 0f) {
                                phi_492_ = (_e367 - _e163);
                            } else {
                                phi_492_ = -(_e163);
                            }
                            let _e378 = phi_492_;
                            phi_494_ = (_e378 / _e349);
                        }
                        let _e381 = phi_494_;
                        let _e382 = abs(_e350);
                        let _e383 = (_e382 < 0.000000001f);
                        if _e383 {
                            phi_508_ = 340282350000000000000000000000000000000f;
                        } else {
                            if (_e350 > 0f) {
                                phi_506_ = (_e369 - _e164);
                            } else {
                                phi_506_ = -(_e164);
                            }
                            let _e388 = phi_506_;
                            phi_508_ = (_e388 / _e350);
                        }
                        let _e391 = phi_508_;
                        let _e392 = abs(_e351);
                        let _e393 = (_e392 < 0.000000001f);
                        if _e393 {
                            phi_522_ = 340282350000000000000000000000000000000f;
                        } else {
                            if (_e351 > 0f) {
                                phi_520_ = (_e371 - _e165);
                            } else {
                                phi_520_ = -(_e165);
                            }
                            let _e398 = phi_520_;
                            phi_522_ = (_e398 / _e351);
                        }
                        let _e401 = phi_522_;
                        let _e403 = select(_e391, _e381, (_e381 < _e391));
                        let _e405 = select(_e401, _e403, (_e403 < _e401));
                        let _e407 = select(0f, _e405, (_e405 > 0f));
                        let _e408 = (_e354 * _e407);
                        let _e410 = (_e358 + (_e359 * _e407));
                        let _e412 = select(_e410, _e408, (_e408 < _e410));
                        let _e414 = select(1f, _e412, (_e412 > 1f));
                        let _e415 = (1.5f * _e414);
                        let _e416 = (_e163 + _e415);
                        let _e417 = (_e164 + _e415);
                        let _e418 = (_e165 + _e415);
                        let _e419 = (_e414 * 3f);
                        if _e373 {
                            phi_574_ = 340282350000000000000000000000000000000f;
                        } else {
                            if (_e349 > 0f) {
                                phi_572_ = ((_e367 + _e419) - _e416);
                            } else {
                                phi_572_ = -(_e416);
                            }
                            let _e427 = phi_572_;
                            phi_574_ = (_e427 / _e349);
                        }
                        let _e430 = phi_574_;
                        if _e383 {
                            phi_588_ = 340282350000000000000000000000000000000f;
                        } else {
                            if (_e350 > 0f) {
                                phi_586_ = ((_e369 + _e419) - _e417);
                            } else {
                                phi_586_ = -(_e417);
                            }
                            let _e435 = phi_586_;
                            phi_588_ = (_e435 / _e350);
                        }
                        let _e438 = phi_588_;
                        if _e393 {
                            phi_602_ = 340282350000000000000000000000000000000f;
                        } else {
                            if (_e351 > 0f) {
                                phi_600_ = ((_e371 + _e419) - _e418);
                            } else {
                                phi_600_ = -(_e418);
                            }
                            let _e443 = phi_600_;
                            phi_602_ = (_e443 / _e351);
                        }
                        let _e446 = phi_602_;
                        let _e448 = select(_e438, _e430, (_e430 < _e438));
                        let _e450 = select(_e446, _e448, (_e448 < _e446));
                        phi_4006_ = _e292;
                        phi_620_ = type_8(0u, 2048u);
                        phi_623_ = vec3<f32>(0f, 0f, 0f);
                        phi_625_ = 0f;
                        phi_627_ = 0f;
                        phi_629_ = 1f;
                        loop {
                            let _e454 = phi_4006_;
                            let _e456 = phi_620_;
                            let _e458 = phi_623_;
                            let _e460 = phi_625_;
                            let _e462 = phi_627_;
                            let _e464 = phi_629_;
                            local_39 = _e462;
                            local_40 = _e464;
                            local_41 = _e458;
                            local_42 = _e458;
                            local_43 = _e458;
                            if (_e456.member < _e456.member_1) {
                                phi_621_ = type_8((_e456.member + 1u), _e456.member_1);
                                phi_652_ = type_8(1u, _e456.member);
                            } else {
                                phi_621_ = _e456;
                                phi_652_ = type_8(0u, type_8().member_1);
                            }
                            let _e477 = phi_621_;
                            let _e479 = phi_652_;
                            if (bitcast<i32>(_e479.member) != 0i) {
                                if (_e460 >= select(0f, _e450, (_e450 > 0f))) {
                                    phi_4194_ = _e454;
                                    phi_3838_ = vec3<f32>();
                                    phi_3839_ = f32();
                                    phi_3840_ = f32();
                                    phi_3841_ = f32();
                                    phi_3842_ = false;
                                } else {
                                    let _e484 = (1f - _e462);
                                    let _e485 = (_e464 * _e484);
                                    let _e486 = (_e485 < 0.001f);
                                    if _e486 {
                                        phi_4195_ = _e454;
                                        phi_3833_ = vec3<f32>();
                                        phi_3834_ = f32();
                                        phi_3835_ = f32();
                                        phi_3836_ = f32();
                                    } else {
                                        let _e487 = (_e354 * _e460);
                                        let _e489 = (_e358 + (_e359 * _e460));
                                        let _e491 = select(_e489, _e487, (_e487 < _e489));
                                        let _e494 = (_e362 * select(1f, _e491, (_e491 > 1f)));
                                        let _e496 = (_e460 + (0.5f * _e494));
                                        let _e500 = (_e163 + (_e349 * _e496));
                                        let _e501 = (_e164 + (_e350 * _e496));
                                        let _e502 = (_e165 + (_e351 * _e496));
                                        let _e503 = (_e354 * _e496);
                                        let _e505 = (_e358 + (_e359 * _e496));
                                        let _e507 = select(_e505, _e503, (_e503 < _e505));
                                        let _e509 = select(1f, _e507, (_e507 > 1f));
                                        let _e514 = (bitcast<i32>((bitcast<u32>(_e509) >> bitcast<u32>(23i))) - 127i);
                                        let _e516 = (_e365.w - 1u);
                                        if (_e514 > 0i) {
                                            let _e518 = bitcast<u32>(_e514);
                                            phi_722_ = select(_e518, _e516, (_e516 < _e518));
                                        } else {
                                            phi_722_ = 0u;
                                        }
                                        let _e522 = phi_722_;
                                        let _e523 = (_e522 & 31u);
                                        let _e525 = (1u << bitcast<u32>(_e523));
                                        let _e527 = (1f / f32(_e525));
                                        let _e528 = (_e509 * _e527);
                                        let _e529 = (_e528 - 1f);
                                        if (_e522 == _e516) {
                                            phi_4164_ = _e454;
                                            phi_2779_ = vec4<f32>();
                                            phi_2780_ = true;
                                            phi_2781_ = false;
                                        } else {
                                            let _e531 = (_e529 <= 0f);
                                            if _e531 {
                                                phi_4165_ = _e454;
                                                phi_2777_ = vec4<f32>();
                                                phi_2778_ = false;
                                            } else {
                                                let _e532 = (_e522 + 1u);
                                                if (_e532 < 10u) {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                let _e537 = params.member.member_2[_e532];
                                                let _e538 = (_e532 & 31u);
                                                let _e540 = (1u << bitcast<u32>(_e538));
                                                let _e541 = (_e540 - 1u);
                                                let _e552 = (1f / f32(_e540));
                                                let _e554 = ((_e500 * _e552) - 0.5f);
                                                let _e555 = floor(_e554);
                                                let _e556 = (_e554 - _e555);
                                                let _e563 = select(0i, select(select(i32(_e555), i32(-2147483648), (_e555 < -2147483600f)), 2147483647i, (_e555 > 2147483500f)), (_e555 == _e555));
                                                let _e565 = (bitcast<i32>(((_e365.x + _e541) >> bitcast<u32>(_e538))) - 1i);
                                                if (_e563 >= 0i) {
                                                    phi_787_ = (_e563 <= _e565);
                                                } else {
                                                    phi_787_ = false;
                                                }
                                                let _e569 = phi_787_;
                                                if (_e563 >= -1i) {
                                                    phi_793_ = (_e563 < _e565);
                                                } else {
                                                    phi_793_ = false;
                                                }
                                                let _e573 = phi_793_;
                                                if _e569 {
                                                    phi_798_ = bitcast<u32>(_e563);
                                                } else {
                                                    phi_798_ = 0u;
                                                }
                                                let _e576 = phi_798_;
                                                if _e573 {
                                                    phi_804_ = bitcast<u32>((_e563 + 1i));
                                                } else {
                                                    phi_804_ = 0u;
                                                }
                                                let _e580 = phi_804_;
                                                if _e569 {
                                                    phi_843_ = (1f - _e556);
                                                } else {
                                                    phi_843_ = 0f;
                                                }
                                                let _e601 = phi_843_;
                                                let _e604 = ((_e501 * _e552) - 0.5f);
                                                let _e606 = floor(_e604);
                                                let _e607 = (_e604 - _e606);
                                                let _e614 = select(0i, select(select(i32(_e606), i32(-2147483648), (_e606 < -2147483600f)), 2147483647i, (_e606 > 2147483500f)), (_e606 == _e606));
                                                let _e616 = (bitcast<i32>(((_e365.y + _e541) >> bitcast<u32>(_e538))) - 1i);
                                                if (_e614 >= 0i) {
                                                    phi_869_ = (_e614 <= _e616);
                                                } else {
                                                    phi_869_ = false;
                                                }
                                                let _e620 = phi_869_;
                                                if (_e614 >= -1i) {
                                                    phi_875_ = (_e614 < _e616);
                                                } else {
                                                    phi_875_ = false;
                                                }
                                                let _e624 = phi_875_;
                                                if _e620 {
                                                    phi_880_ = bitcast<u32>(_e614);
                                                } else {
                                                    phi_880_ = 0u;
                                                }
                                                let _e627 = phi_880_;
                                                if _e624 {
                                                    phi_886_ = bitcast<u32>((_e614 + 1i));
                                                } else {
                                                    phi_886_ = 0u;
                                                }
                                                let _e631 = phi_886_;
                                                if _e620 {
                                                    phi_925_ = (1f - _e607);
                                                } else {
                                                    phi_925_ = 0f;
                                                }
                                                let _e658 = phi_925_;
                                                let _e661 = ((_e502 * _e552) - 0.5f);
                                                let _e663 = floor(_e661);
                                                let _e664 = (_e661 - _e663);
                                                let _e671 = select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < -2147483600f)), 2147483647i, (_e663 > 2147483500f)), (_e663 == _e663));
                                                let _e673 = (bitcast<i32>(((_e365.z + _e541) >> bitcast<u32>(_e538))) - 1i);
                                                if (_e671 >= 0i) {
                                                    phi_951_ = (_e671 <= _e673);
                                                } else {
                                                    phi_951_ = false;
                                                }
                                                let _e677 = phi_951_;
                                                if (_e671 >= -1i) {
                                                    phi_957_ = (_e671 < _e673);
                                                } else {
                                                    phi_957_ = false;
                                                }
                                                let _e681 = phi_957_;
                                                if _e677 {
                                                    phi_962_ = bitcast<u32>(_e671);
                                                } else {
                                                    phi_962_ = 0u;
                                                }
                                                let _e684 = phi_962_;
                                                if _e681 {
                                                    phi_968_ = bitcast<u32>((_e671 + 1i));
                                                } else {
                                                    phi_968_ = 0u;
                                                }
                                                let _e688 = phi_968_;
                                                if _e677 {
                                                    phi_1007_ = (1f - _e664);
                                                } else {
                                                    phi_1007_ = 0f;
                                                }
                                                let _e703 = phi_1007_;
                                                phi_3975_ = _e454;
                                                phi_1014_ = type_8(0u, 8u);
                                                phi_1017_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                loop {
                                                    let _e706 = phi_3975_;
                                                    let _e708 = phi_1014_;
                                                    let _e710 = phi_1017_;
                                                    local_10 = _e710;
                                                    local_25 = _e710;
                                                    local_26 = _e710;
                                                    local_27 = _e710;
                                                    if (_e708.member < _e708.member_1) {
                                                        phi_1015_ = type_8((_e708.member + 1u), _e708.member_1);
                                                        phi_1040_ = type_8(1u, _e708.member);
                                                    } else {
                                                        phi_1015_ = _e708;
                                                        phi_1040_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e723 = phi_1015_;
                                                    let _e725 = phi_1040_;
                                                    let _e729 = (bitcast<i32>(_e725.member) != 0i);
                                                    if _e729 {
                                                        let _e731 = ((_e725.member_1 & 1u) == 1u);
                                                        let _e733 = ((_e725.member_1 & 2u) == 2u);
                                                        let _e735 = ((_e725.member_1 & 4u) == 4u);
                                                        let _e740 = ((select(_e601, select(0f, _e556, _e573), _e731) * select(_e658, select(0f, _e607, _e624), _e733)) * select(_e703, select(0f, _e664, _e681), _e735));
                                                        let _e747 = (((_e537.z + select((_e576 >> bitcast<u32>(2u)), (_e580 >> bitcast<u32>(2u)), _e731)) + select(((_e627 >> bitcast<u32>(2u)) * _e537.x), ((_e631 >> bitcast<u32>(2u)) * _e537.x), _e733)) + select(((_e684 >> bitcast<u32>(1u)) * _e537.y), ((_e688 >> bitcast<u32>(1u)) * _e537.y), _e735));
                                                        let _e753 = (2u * _e747);
                                                        if (_e753 < _e84) {
                                                        } else {
                                                            phi_4049_ = true;
                                                            break;
                                                        }
                                                        let _e756 = cells.member[_e753];
                                                        if (_e740 > 0f) {
                                                            let _e758 = (((select(((_e576 & 1u) | (((_e576 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), ((_e580 & 1u) | (((_e580 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), _e731) | select((((_e627 & 1u) << bitcast<u32>(1u)) | (((_e627 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), (((_e631 & 1u) << bitcast<u32>(1u)) | (((_e631 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), _e733)) | select(((_e684 & 1u) << bitcast<u32>(2u)), ((_e688 & 1u) << bitcast<u32>(2u)), _e735)) & 31u);
                                                            if (((_e756 >> bitcast<u32>(_e758)) & 1u) == 1u) {
                                                                if (_e532 == 0u) {
                                                                    let _e861 = (_e747 * 6u);
                                                                    let _e862 = (_e753 + 1u);
                                                                    if (_e862 < _e84) {
                                                                    } else {
                                                                        phi_4049_ = true;
                                                                        break;
                                                                    }
                                                                    let _e865 = cells.member[_e862];
                                                                    phi_1139_ = type_8(0u, 6u);
                                                                    phi_1142_ = _e865;
                                                                    loop {
                                                                        let _e867 = phi_1139_;
                                                                        let _e869 = phi_1142_;
                                                                        local = _e869;
                                                                        local_1 = _e869;
                                                                        local_8 = _e869;
                                                                        local_9 = _e869;
                                                                        if (_e867.member < _e867.member_1) {
                                                                            phi_1140_ = type_8((_e867.member + 1u), _e867.member_1);
                                                                            phi_1165_ = type_8(1u, _e867.member);
                                                                        } else {
                                                                            phi_1140_ = _e867;
                                                                            phi_1165_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e882 = phi_1140_;
                                                                        let _e884 = phi_1165_;
                                                                        let _e888 = (bitcast<i32>(_e884.member) != 0i);
                                                                        if _e888 {
                                                                            let _e889 = (_e861 + _e884.member_1);
                                                                            if (_e889 < _e87) {
                                                                            } else {
                                                                                phi_3961_ = true;
                                                                                break;
                                                                            }
                                                                            let _e892 = facet_bits.member[_e889];
                                                                            phi_1143_ = (_e869 + countOneBits((_e892 & ((1u << bitcast<u32>(_e758)) - 1u))));
                                                                        } else {
                                                                            phi_1143_ = u32();
                                                                        }
                                                                        let _e900 = phi_1143_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_1139_ = _e882;
                                                                            phi_1142_ = _e900;
                                                                            phi_3961_ = _e706;
                                                                            break if !(_e888);
                                                                        }
                                                                    }
                                                                    let _e903 = phi_3961_;
                                                                    phi_4049_ = _e903;
                                                                    if _e903 {
                                                                        break;
                                                                    }
                                                                    if (_e861 < _e87) {
                                                                    } else {
                                                                        phi_4049_ = true;
                                                                        break;
                                                                    }
                                                                    let _e906 = facet_bits.member[_e861];
                                                                    let _e910 = (_e861 + 1u);
                                                                    if (_e910 < _e87) {
                                                                    } else {
                                                                        phi_4049_ = true;
                                                                        break;
                                                                    }
                                                                    let _e913 = facet_bits.member[_e910];
                                                                    let _e918 = (_e861 + 2u);
                                                                    if (_e918 < _e87) {
                                                                    } else {
                                                                        phi_4049_ = true;
                                                                        break;
                                                                    }
                                                                    let _e921 = facet_bits.member[_e918];
                                                                    let _e926 = (_e861 + 3u);
                                                                    if (_e926 < _e87) {
                                                                    } else {
                                                                        phi_4049_ = true;
                                                                        break;
                                                                    }
                                                                    let _e929 = facet_bits.member[_e926];
                                                                    let _e934 = (_e861 + 4u);
                                                                    if (_e934 < _e87) {
                                                                    } else {
                                                                        phi_4049_ = true;
                                                                        break;
                                                                    }
                                                                    let _e937 = facet_bits.member[_e934];
                                                                    let _e942 = (_e861 + 5u);
                                                                    if (_e942 < _e87) {
                                                                    } else {
                                                                        phi_4049_ = true;
                                                                        break;
                                                                    }
                                                                    let _e945 = facet_bits.member[_e942];
                                                                    let _e949 = (((((((_e906 >> bitcast<u32>(_e758)) & 1u) + ((_e913 >> bitcast<u32>(_e758)) & 1u)) + ((_e921 >> bitcast<u32>(_e758)) & 1u)) + ((_e929 >> bitcast<u32>(_e758)) & 1u)) + ((_e937 >> bitcast<u32>(_e758)) & 1u)) + ((_e945 >> bitcast<u32>(_e758)) & 1u));
                                                                    let _e952 = params.member.member_7;
                                                                    if (_e952 == 1u) {
                                                                        let _e1077 = local_8;
                                                                        let _e1080 = local_9;
                                                                        phi_1282_ = type_8(_e1080, (_e1077 + _e949));
                                                                        phi_1285_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e1083 = phi_1282_;
                                                                            let _e1085 = phi_1285_;
                                                                            local_48 = _e1085;
                                                                            if (_e1083.member < _e1083.member_1) {
                                                                                phi_1283_ = type_8((_e1083.member + 1u), _e1083.member_1);
                                                                                phi_1308_ = type_8(1u, _e1083.member);
                                                                            } else {
                                                                                phi_1283_ = _e1083;
                                                                                phi_1308_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e1098 = phi_1283_;
                                                                            let _e1100 = phi_1308_;
                                                                            let _e1104 = (bitcast<i32>(_e1100.member) != 0i);
                                                                            if _e1104 {
                                                                                let _e1105 = (2u * _e1100.member_1);
                                                                                if (_e1105 < _e93) {
                                                                                } else {
                                                                                    phi_4042_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1109 = radiance.member[_e1105][0u];
                                                                                let _e1112 = radiance.member[_e1105][1u];
                                                                                let _e1115 = radiance.member[_e1105][2u];
                                                                                let _e1116 = (_e1105 + 1u);
                                                                                if (_e1116 < _e93) {
                                                                                } else {
                                                                                    phi_4042_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1120 = radiance.member[_e1116][0u];
                                                                                let _e1123 = radiance.member[_e1116][1u];
                                                                                let _e1126 = radiance.member[_e1116][2u];
                                                                                if (_e1100.member_1 < _e90) {
                                                                                } else {
                                                                                    phi_4042_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1136 = facets.member[_e1100.member_1].member_2;
                                                                                let _e1145 = sqrt((((_e1136[0] * _e1136[0]) + (_e1136[1] * _e1136[1])) + (_e1136[2] * _e1136[2])));
                                                                                phi_1286_ = vec4<f32>((_e1085.x + (select(_e1120, _e1109, (_e1109 > _e1120)) * _e1145)), (_e1085.y + (select(_e1123, _e1112, (_e1112 > _e1123)) * _e1145)), (_e1085.z + (select(_e1126, _e1115, (_e1115 > _e1126)) * _e1145)), (_e1085.w + _e1145));
                                                                            } else {
                                                                                phi_1286_ = vec4<f32>();
                                                                            }
                                                                            let _e1159 = phi_1286_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_1282_ = _e1098;
                                                                                phi_1285_ = _e1159;
                                                                                phi_4042_ = _e903;
                                                                                break if !(_e1104);
                                                                            }
                                                                        }
                                                                        let _e1162 = phi_4042_;
                                                                        phi_4049_ = _e1162;
                                                                        if _e1162 {
                                                                            break;
                                                                        }
                                                                        phi_4059_ = _e1162;
                                                                        let _e2823 = local_48;
                                                                        phi_1550_ = _e2823;
                                                                    } else {
                                                                        let _e955 = local;
                                                                        let _e958 = local_1;
                                                                        phi_1414_ = type_8(_e958, (_e955 + _e949));
                                                                        phi_1417_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        phi_1419_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e961 = phi_1414_;
                                                                            let _e963 = phi_1417_;
                                                                            let _e965 = phi_1419_;
                                                                            local_2 = _e963;
                                                                            local_3 = _e965;
                                                                            local_4 = _e963;
                                                                            local_5 = _e963;
                                                                            local_6 = _e963;
                                                                            local_7 = _e965;
                                                                            local_47 = _e965;
                                                                            if (_e961.member < _e961.member_1) {
                                                                                phi_1415_ = type_8((_e961.member + 1u), _e961.member_1);
                                                                                phi_1442_ = type_8(1u, _e961.member);
                                                                            } else {
                                                                                phi_1415_ = _e961;
                                                                                phi_1442_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e978 = phi_1415_;
                                                                            let _e980 = phi_1442_;
                                                                            let _e984 = (bitcast<i32>(_e980.member) != 0i);
                                                                            if _e984 {
                                                                                if (_e980.member_1 < _e90) {
                                                                                } else {
                                                                                    phi_4037_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e988 = facets.member[_e980.member_1].member_2;
                                                                                let _e997 = -((((_e349 * _e988[0]) + (_e350 * _e988[1])) + (_e351 * _e988[2])));
                                                                                if (_e997 > 0f) {
                                                                                    let _e1019 = (2u * _e980.member_1);
                                                                                    if (_e1019 < _e93) {
                                                                                    } else {
                                                                                        phi_4037_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1022 = radiance.member[_e1019];
                                                                                    phi_1526_ = _e963;
                                                                                    phi_1527_ = vec4<f32>((_e965.x + (_e1022.x * _e997)), (_e965.y + (_e1022.y * _e997)), (_e965.z + (_e1022.z * _e997)), (_e965.w + _e997));
                                                                                } else {
                                                                                    let _e1000 = ((2u * _e980.member_1) + 1u);
                                                                                    if (_e1000 < _e93) {
                                                                                    } else {
                                                                                        phi_4037_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1003 = radiance.member[_e1000];
                                                                                    phi_1526_ = vec4<f32>((_e963.x - (_e1003.x * _e997)), (_e963.y - (_e1003.y * _e997)), (_e963.z - (_e1003.z * _e997)), (_e963.w - _e997));
                                                                                    phi_1527_ = _e965;
                                                                                }
                                                                                let _e1039 = phi_1526_;
                                                                                let _e1041 = phi_1527_;
                                                                                phi_1418_ = _e1039;
                                                                                phi_1420_ = _e1041;
                                                                            } else {
                                                                                phi_1418_ = vec4<f32>();
                                                                                phi_1420_ = vec4<f32>();
                                                                            }
                                                                            let _e1043 = phi_1418_;
                                                                            let _e1045 = phi_1420_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_1414_ = _e978;
                                                                                phi_1417_ = _e1043;
                                                                                phi_1419_ = _e1045;
                                                                                phi_4037_ = _e903;
                                                                                break if !(_e984);
                                                                            }
                                                                        }
                                                                        let _e1048 = phi_4037_;
                                                                        phi_4049_ = _e1048;
                                                                        if _e1048 {
                                                                            break;
                                                                        }
                                                                        let _e1050 = local_2;
                                                                        let _e1053 = local_3;
                                                                        if (_e1050.w > _e1053.w) {
                                                                            let _e1056 = (_e1050.w - _e1053.w);
                                                                            let _e1057 = (_e1056 / _e1050.w);
                                                                            let _e1059 = local_4;
                                                                            let _e1063 = local_5;
                                                                            let _e1067 = local_6;
                                                                            let _e1072 = local_7;
                                                                            phi_1549_ = (_e1072 + vec4<f32>((_e1059.x * _e1057), (_e1063.y * _e1057), (_e1067.z * _e1057), _e1056));
                                                                        } else {
                                                                            let _e2811 = local_47;
                                                                            phi_1549_ = _e2811;
                                                                        }
                                                                        let _e1075 = phi_1549_;
                                                                        phi_4059_ = _e1048;
                                                                        phi_1550_ = _e1075;
                                                                    }
                                                                    let _e1164 = phi_4059_;
                                                                    let _e1166 = phi_1550_;
                                                                    phi_4053_ = _e1164;
                                                                    phi_1719_ = _e1166;
                                                                } else {
                                                                    let _e764 = (_e753 + 1u);
                                                                    if (_e764 < _e84) {
                                                                    } else {
                                                                        phi_4049_ = true;
                                                                        break;
                                                                    }
                                                                    let _e767 = cells.member[_e764];
                                                                    let _e773 = (_e767 + countOneBits((_e756 & ((1u << bitcast<u32>(_e758)) - 1u))));
                                                                    let _e776 = params.member.member_7;
                                                                    if (_e776 == 1u) {
                                                                        if ((_e532 & 1u) == 1u) {
                                                                            if (_e773 < _e96) {
                                                                            } else {
                                                                                phi_4049_ = true;
                                                                                break;
                                                                            }
                                                                            let _e856 = odd.member[_e773];
                                                                            phi_1597_ = _e856;
                                                                        } else {
                                                                            if (_e773 < _e99) {
                                                                            } else {
                                                                                phi_4049_ = true;
                                                                                break;
                                                                            }
                                                                            let _e853 = even.member[_e773];
                                                                            phi_1597_ = _e853;
                                                                        }
                                                                        let _e858 = phi_1597_;
                                                                        phi_1718_ = _e858;
                                                                    } else {
                                                                        let _e778 = (_e773 * 6u);
                                                                        let _e781 = (_e778 + select(0u, 1u, (_e349 < 0f)));
                                                                        let _e783 = ((_e532 & 1u) == 1u);
                                                                        if _e783 {
                                                                            if (_e781 < _e96) {
                                                                            } else {
                                                                                phi_4049_ = true;
                                                                                break;
                                                                            }
                                                                            let _e789 = odd.member[_e781];
                                                                            phi_1625_ = _e789;
                                                                        } else {
                                                                            if (_e781 < _e99) {
                                                                            } else {
                                                                                phi_4049_ = true;
                                                                                break;
                                                                            }
                                                                            let _e786 = even.member[_e781];
                                                                            phi_1625_ = _e786;
                                                                        }
                                                                        let _e791 = phi_1625_;
                                                                        let _e803 = ((_e778 + 2u) + select(0u, 1u, (_e350 < 0f)));
                                                                        if _e783 {
                                                                            if (_e803 < _e96) {
                                                                            } else {
                                                                                phi_4049_ = true;
                                                                                break;
                                                                            }
                                                                            let _e809 = odd.member[_e803];
                                                                            phi_1662_ = _e809;
                                                                        } else {
                                                                            if (_e803 < _e99) {
                                                                            } else {
                                                                                phi_4049_ = true;
                                                                                break;
                                                                            }
                                                                            let _e806 = even.member[_e803];
                                                                            phi_1662_ = _e806;
                                                                        }
                                                                        let _e811 = phi_1662_;
                                                                        let _e827 = ((_e778 + 4u) + select(0u, 1u, (_e351 < 0f)));
                                                                        if _e783 {
                                                                            if (_e827 < _e96) {
                                                                            } else {
                                                                                phi_4049_ = true;
                                                                                break;
                                                                            }
                                                                            let _e833 = odd.member[_e827];
                                                                            phi_1703_ = _e833;
                                                                        } else {
                                                                            if (_e827 < _e99) {
                                                                            } else {
                                                                                phi_4049_ = true;
                                                                                break;
                                                                            }
                                                                            let _e830 = even.member[_e827];
                                                                            phi_1703_ = _e830;
                                                                        }
                                                                        let _e835 = phi_1703_;
                                                                        phi_1718_ = vec4<f32>((((_e791.x * _e372) + (_e811.x * _e382)) + (_e835.x * _e392)), (((_e791.y * _e372) + (_e811.y * _e382)) + (_e835.y * _e392)), (((_e791.z * _e372) + (_e811.z * _e382)) + (_e835.z * _e392)), (((_e791.w * _e372) + (_e811.w * _e382)) + (_e835.w * _e392)));
                                                                    }
                                                                    let _e860 = phi_1718_;
                                                                    phi_4053_ = _e706;
                                                                    phi_1719_ = _e860;
                                                                }
                                                                let _e1168 = phi_4053_;
                                                                let _e1170 = phi_1719_;
                                                                phi_4052_ = _e1168;
                                                                phi_1740_ = vec4<f32>((_e710.x + (_e1170.x * _e740)), (_e710.y + (_e1170.y * _e740)), (_e710.z + (_e1170.z * _e740)), (_e710.w + (_e1170.w * _e740)));
                                                            } else {
                                                                phi_4052_ = _e706;
                                                                phi_1740_ = _e710;
                                                            }
                                                            let _e1189 = phi_4052_;
                                                            let _e1191 = phi_1740_;
                                                            phi_4051_ = _e1189;
                                                            phi_1741_ = _e1191;
                                                        } else {
                                                            phi_4051_ = _e706;
                                                            phi_1741_ = _e710;
                                                        }
                                                        let _e1193 = phi_4051_;
                                                        let _e1195 = phi_1741_;
                                                        phi_4050_ = _e1193;
                                                        phi_1018_ = _e1195;
                                                    } else {
                                                        phi_4050_ = _e706;
                                                        phi_1018_ = vec4<f32>();
                                                    }
                                                    let _e1197 = phi_4050_;
                                                    let _e1199 = phi_1018_;
                                                    continue;
                                                    continuing {
                                                        phi_3975_ = _e1197;
                                                        phi_1014_ = _e723;
                                                        phi_1017_ = _e1199;
                                                        phi_4049_ = _e1197;
                                                        break if !(_e729);
                                                    }
                                                }
                                                let _e1202 = phi_4049_;
                                                phi_4192_ = _e1202;
                                                if _e1202 {
                                                    break;
                                                }
                                                let _e1204 = local_10;
                                                let _e1206 = (_e1204.w <= 0f);
                                                if _e1206 {
                                                    phi_4166_ = _e1202;
                                                    phi_2776_ = vec4<f32>();
                                                } else {
                                                    if (_e522 < 10u) {
                                                    } else {
                                                        phi_4192_ = true;
                                                        break;
                                                    }
                                                    let _e1211 = params.member.member_2[_e522];
                                                    let _e1212 = (_e525 - 1u);
                                                    let _e1223 = ((_e500 * _e527) - 0.5f);
                                                    let _e1224 = floor(_e1223);
                                                    let _e1225 = (_e1223 - _e1224);
                                                    let _e1232 = select(0i, select(select(i32(_e1224), i32(-2147483648), (_e1224 < -2147483600f)), 2147483647i, (_e1224 > 2147483500f)), (_e1224 == _e1224));
                                                    let _e1234 = (bitcast<i32>(((_e365.x + _e1212) >> bitcast<u32>(_e523))) - 1i);
                                                    if (_e1232 >= 0i) {
                                                        phi_1796_ = (_e1232 <= _e1234);
                                                    } else {
                                                        phi_1796_ = false;
                                                    }
                                                    let _e1238 = phi_1796_;
                                                    if (_e1232 >= -1i) {
                                                        phi_1802_ = (_e1232 < _e1234);
                                                    } else {
                                                        phi_1802_ = false;
                                                    }
                                                    let _e1242 = phi_1802_;
                                                    if _e1238 {
                                                        phi_1807_ = bitcast<u32>(_e1232);
                                                    } else {
                                                        phi_1807_ = 0u;
                                                    }
                                                    let _e1245 = phi_1807_;
                                                    if _e1242 {
                                                        phi_1813_ = bitcast<u32>((_e1232 + 1i));
                                                    } else {
                                                        phi_1813_ = 0u;
                                                    }
                                                    let _e1249 = phi_1813_;
                                                    if _e1238 {
                                                        phi_1852_ = (1f - _e1225);
                                                    } else {
                                                        phi_1852_ = 0f;
                                                    }
                                                    let _e1270 = phi_1852_;
                                                    let _e1273 = ((_e501 * _e527) - 0.5f);
                                                    let _e1275 = floor(_e1273);
                                                    let _e1276 = (_e1273 - _e1275);
                                                    let _e1283 = select(0i, select(select(i32(_e1275), i32(-2147483648), (_e1275 < -2147483600f)), 2147483647i, (_e1275 > 2147483500f)), (_e1275 == _e1275));
                                                    let _e1285 = (bitcast<i32>(((_e365.y + _e1212) >> bitcast<u32>(_e523))) - 1i);
                                                    if (_e1283 >= 0i) {
                                                        phi_1878_ = (_e1283 <= _e1285);
                                                    } else {
                                                        phi_1878_ = false;
                                                    }
                                                    let _e1289 = phi_1878_;
                                                    if (_e1283 >= -1i) {
                                                        phi_1884_ = (_e1283 < _e1285);
                                                    } else {
                                                        phi_1884_ = false;
                                                    }
                                                    let _e1293 = phi_1884_;
                                                    if _e1289 {
                                                        phi_1889_ = bitcast<u32>(_e1283);
                                                    } else {
                                                        phi_1889_ = 0u;
                                                    }
                                                    let _e1296 = phi_1889_;
                                                    if _e1293 {
                                                        phi_1895_ = bitcast<u32>((_e1283 + 1i));
                                                    } else {
                                                        phi_1895_ = 0u;
                                                    }
                                                    let _e1300 = phi_1895_;
                                                    if _e1289 {
                                                        phi_1934_ = (1f - _e1276);
                                                    } else {
                                                        phi_1934_ = 0f;
                                                    }
                                                    let _e1327 = phi_1934_;
                                                    let _e1330 = ((_e502 * _e527) - 0.5f);
                                                    let _e1332 = floor(_e1330);
                                                    let _e1333 = (_e1330 - _e1332);
                                                    let _e1340 = select(0i, select(select(i32(_e1332), i32(-2147483648), (_e1332 < -2147483600f)), 2147483647i, (_e1332 > 2147483500f)), (_e1332 == _e1332));
                                                    let _e1342 = (bitcast<i32>(((_e365.z + _e1212) >> bitcast<u32>(_e523))) - 1i);
                                                    if (_e1340 >= 0i) {
                                                        phi_1960_ = (_e1340 <= _e1342);
                                                    } else {
                                                        phi_1960_ = false;
                                                    }
                                                    let _e1346 = phi_1960_;
                                                    if (_e1340 >= -1i) {
                                                        phi_1966_ = (_e1340 < _e1342);
                                                    } else {
                                                        phi_1966_ = false;
                                                    }
                                                    let _e1350 = phi_1966_;
                                                    if _e1346 {
                                                        phi_1971_ = bitcast<u32>(_e1340);
                                                    } else {
                                                        phi_1971_ = 0u;
                                                    }
                                                    let _e1353 = phi_1971_;
                                                    if _e1350 {
                                                        phi_1977_ = bitcast<u32>((_e1340 + 1i));
                                                    } else {
                                                        phi_1977_ = 0u;
                                                    }
                                                    let _e1357 = phi_1977_;
                                                    if _e1346 {
                                                        phi_2016_ = (1f - _e1333);
                                                    } else {
                                                        phi_2016_ = 0f;
                                                    }
                                                    let _e1372 = phi_2016_;
                                                    phi_4075_ = _e1202;
                                                    phi_2023_ = type_8(0u, 8u);
                                                    phi_2026_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                    loop {
                                                        let _e1375 = phi_4075_;
                                                        let _e1377 = phi_2023_;
                                                        let _e1379 = phi_2026_;
                                                        local_21 = _e1379;
                                                        local_22 = _e1379;
                                                        local_23 = _e1379;
                                                        local_24 = _e1379;
                                                        if (_e1377.member < _e1377.member_1) {
                                                            phi_2024_ = type_8((_e1377.member + 1u), _e1377.member_1);
                                                            phi_2049_ = type_8(1u, _e1377.member);
                                                        } else {
                                                            phi_2024_ = _e1377;
                                                            phi_2049_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1392 = phi_2024_;
                                                        let _e1394 = phi_2049_;
                                                        let _e1398 = (bitcast<i32>(_e1394.member) != 0i);
                                                        if _e1398 {
                                                            let _e1400 = ((_e1394.member_1 & 1u) == 1u);
                                                            let _e1402 = ((_e1394.member_1 & 2u) == 2u);
                                                            let _e1404 = ((_e1394.member_1 & 4u) == 4u);
                                                            let _e1409 = ((select(_e1270, select(0f, _e1225, _e1242), _e1400) * select(_e1327, select(0f, _e1276, _e1293), _e1402)) * select(_e1372, select(0f, _e1333, _e1350), _e1404));
                                                            let _e1416 = (((_e1211.z + select((_e1245 >> bitcast<u32>(2u)), (_e1249 >> bitcast<u32>(2u)), _e1400)) + select(((_e1296 >> bitcast<u32>(2u)) * _e1211.x), ((_e1300 >> bitcast<u32>(2u)) * _e1211.x), _e1402)) + select(((_e1353 >> bitcast<u32>(1u)) * _e1211.y), ((_e1357 >> bitcast<u32>(1u)) * _e1211.y), _e1404));
                                                            let _e1422 = (2u * _e1416);
                                                            if (_e1422 < _e84) {
                                                            } else {
                                                                phi_4113_ = true;
                                                                break;
                                                            }
                                                            let _e1425 = cells.member[_e1422];
                                                            if (_e1409 > 0f) {
                                                                let _e1427 = (((select(((_e1245 & 1u) | (((_e1245 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), ((_e1249 & 1u) | (((_e1249 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), _e1400) | select((((_e1296 & 1u) << bitcast<u32>(1u)) | (((_e1296 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), (((_e1300 & 1u) << bitcast<u32>(1u)) | (((_e1300 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), _e1402)) | select(((_e1353 & 1u) << bitcast<u32>(2u)), ((_e1357 & 1u) << bitcast<u32>(2u)), _e1404)) & 31u);
                                                                if (((_e1425 >> bitcast<u32>(_e1427)) & 1u) == 1u) {
                                                                    if (_e522 == 0u) {
                                                                        let _e1530 = (_e1416 * 6u);
                                                                        let _e1531 = (_e1422 + 1u);
                                                                        if (_e1531 < _e84) {
                                                                        } else {
                                                                            phi_4113_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1534 = cells.member[_e1531];
                                                                        phi_2148_ = type_8(0u, 6u);
                                                                        phi_2151_ = _e1534;
                                                                        loop {
                                                                            let _e1536 = phi_2148_;
                                                                            let _e1538 = phi_2151_;
                                                                            local_11 = _e1538;
                                                                            local_12 = _e1538;
                                                                            local_19 = _e1538;
                                                                            local_20 = _e1538;
                                                                            if (_e1536.member < _e1536.member_1) {
                                                                                phi_2149_ = type_8((_e1536.member + 1u), _e1536.member_1);
                                                                                phi_2174_ = type_8(1u, _e1536.member);
                                                                            } else {
                                                                                phi_2149_ = _e1536;
                                                                                phi_2174_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e1551 = phi_2149_;
                                                                            let _e1553 = phi_2174_;
                                                                            let _e1557 = (bitcast<i32>(_e1553.member) != 0i);
                                                                            if _e1557 {
                                                                                let _e1558 = (_e1530 + _e1553.member_1);
                                                                                if (_e1558 < _e87) {
                                                                                } else {
                                                                                    phi_4061_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1561 = facet_bits.member[_e1558];
                                                                                phi_2152_ = (_e1538 + countOneBits((_e1561 & ((1u << bitcast<u32>(_e1427)) - 1u))));
                                                                            } else {
                                                                                phi_2152_ = u32();
                                                                            }
                                                                            let _e1569 = phi_2152_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_2148_ = _e1551;
                                                                                phi_2151_ = _e1569;
                                                                                phi_4061_ = _e1375;
                                                                                break if !(_e1557);
                                                                            }
                                                                        }
                                                                        let _e1572 = phi_4061_;
                                                                        phi_4113_ = _e1572;
                                                                        if _e1572 {
                                                                            break;
                                                                        }
                                                                        if (_e1530 < _e87) {
                                                                        } else {
                                                                            phi_4113_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1575 = facet_bits.member[_e1530];
                                                                        let _e1579 = (_e1530 + 1u);
                                                                        if (_e1579 < _e87) {
                                                                        } else {
                                                                            phi_4113_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1582 = facet_bits.member[_e1579];
                                                                        let _e1587 = (_e1530 + 2u);
                                                                        if (_e1587 < _e87) {
                                                                        } else {
                                                                            phi_4113_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1590 = facet_bits.member[_e1587];
                                                                        let _e1595 = (_e1530 + 3u);
                                                                        if (_e1595 < _e87) {
                                                                        } else {
                                                                            phi_4113_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1598 = facet_bits.member[_e1595];
                                                                        let _e1603 = (_e1530 + 4u);
                                                                        if (_e1603 < _e87) {
                                                                        } else {
                                                                            phi_4113_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1606 = facet_bits.member[_e1603];
                                                                        let _e1611 = (_e1530 + 5u);
                                                                        if (_e1611 < _e87) {
                                                                        } else {
                                                                            phi_4113_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1614 = facet_bits.member[_e1611];
                                                                        let _e1618 = (((((((_e1575 >> bitcast<u32>(_e1427)) & 1u) + ((_e1582 >> bitcast<u32>(_e1427)) & 1u)) + ((_e1590 >> bitcast<u32>(_e1427)) & 1u)) + ((_e1598 >> bitcast<u32>(_e1427)) & 1u)) + ((_e1606 >> bitcast<u32>(_e1427)) & 1u)) + ((_e1614 >> bitcast<u32>(_e1427)) & 1u));
                                                                        let _e1621 = params.member.member_7;
                                                                        if (_e1621 == 1u) {
                                                                            let _e1746 = local_19;
                                                                            let _e1749 = local_20;
                                                                            phi_2291_ = type_8(_e1749, (_e1746 + _e1618));
                                                                            phi_2294_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            loop {
                                                                                let _e1752 = phi_2291_;
                                                                                let _e1754 = phi_2294_;
                                                                                local_50 = _e1754;
                                                                                if (_e1752.member < _e1752.member_1) {
                                                                                    phi_2292_ = type_8((_e1752.member + 1u), _e1752.member_1);
                                                                                    phi_2317_ = type_8(1u, _e1752.member);
                                                                                } else {
                                                                                    phi_2292_ = _e1752;
                                                                                    phi_2317_ = type_8(0u, type_8().member_1);
                                                                                }
                                                                                let _e1767 = phi_2292_;
                                                                                let _e1769 = phi_2317_;
                                                                                let _e1773 = (bitcast<i32>(_e1769.member) != 0i);
                                                                                if _e1773 {
                                                                                    let _e1774 = (2u * _e1769.member_1);
                                                                                    if (_e1774 < _e93) {
                                                                                    } else {
                                                                                        phi_4106_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1778 = radiance.member[_e1774][0u];
                                                                                    let _e1781 = radiance.member[_e1774][1u];
                                                                                    let _e1784 = radiance.member[_e1774][2u];
                                                                                    let _e1785 = (_e1774 + 1u);
                                                                                    if (_e1785 < _e93) {
                                                                                    } else {
                                                                                        phi_4106_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1789 = radiance.member[_e1785][0u];
                                                                                    let _e1792 = radiance.member[_e1785][1u];
                                                                                    let _e1795 = radiance.member[_e1785][2u];
                                                                                    if (_e1769.member_1 < _e90) {
                                                                                    } else {
                                                                                        phi_4106_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1805 = facets.member[_e1769.member_1].member_2;
                                                                                    let _e1814 = sqrt((((_e1805[0] * _e1805[0]) + (_e1805[1] * _e1805[1])) + (_e1805[2] * _e1805[2])));
                                                                                    phi_2295_ = vec4<f32>((_e1754.x + (select(_e1789, _e1778, (_e1778 > _e1789)) * _e1814)), (_e1754.y + (select(_e1792, _e1781, (_e1781 > _e1792)) * _e1814)), (_e1754.z + (select(_e1795, _e1784, (_e1784 > _e1795)) * _e1814)), (_e1754.w + _e1814));
                                                                                } else {
                                                                                    phi_2295_ = vec4<f32>();
                                                                                }
                                                                                let _e1828 = phi_2295_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_2291_ = _e1767;
                                                                                    phi_2294_ = _e1828;
                                                                                    phi_4106_ = _e1572;
                                                                                    break if !(_e1773);
                                                                                }
                                                                            }
                                                                            let _e1831 = phi_4106_;
                                                                            phi_4113_ = _e1831;
                                                                            if _e1831 {
                                                                                break;
                                                                            }
                                                                            phi_4123_ = _e1831;
                                                                            let _e2897 = local_50;
                                                                            phi_2559_ = _e2897;
                                                                        } else {
                                                                            let _e1624 = local_11;
                                                                            let _e1627 = local_12;
                                                                            phi_2423_ = type_8(_e1627, (_e1624 + _e1618));
                                                                            phi_2426_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            phi_2428_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            loop {
                                                                                let _e1630 = phi_2423_;
                                                                                let _e1632 = phi_2426_;
                                                                                let _e1634 = phi_2428_;
                                                                                local_13 = _e1632;
                                                                                local_14 = _e1634;
                                                                                local_15 = _e1632;
                                                                                local_16 = _e1632;
                                                                                local_17 = _e1632;
                                                                                local_18 = _e1634;
                                                                                local_49 = _e1634;
                                                                                if (_e1630.member < _e1630.member_1) {
                                                                                    phi_2424_ = type_8((_e1630.member + 1u), _e1630.member_1);
                                                                                    phi_2451_ = type_8(1u, _e1630.member);
                                                                                } else {
                                                                                    phi_2424_ = _e1630;
                                                                                    phi_2451_ = type_8(0u, type_8().member_1);
                                                                                }
                                                                                let _e1647 = phi_2424_;
                                                                                let _e1649 = phi_2451_;
                                                                                let _e1653 = (bitcast<i32>(_e1649.member) != 0i);
                                                                                if _e1653 {
                                                                                    if (_e1649.member_1 < _e90) {
                                                                                    } else {
                                                                                        phi_4101_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1657 = facets.member[_e1649.member_1].member_2;
                                                                                    let _e1666 = -((((_e349 * _e1657[0]) + (_e350 * _e1657[1])) + (_e351 * _e1657[2])));
                                                                                    if (_e1666 > 0f) {
                                                                                        let _e1688 = (2u * _e1649.member_1);
                                                                                        if (_e1688 < _e93) {
                                                                                        } else {
                                                                                            phi_4101_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e1691 = radiance.member[_e1688];
                                                                                        phi_2535_ = _e1632;
                                                                                        phi_2536_ = vec4<f32>((_e1634.x + (_e1691.x * _e1666)), (_e1634.y + (_e1691.y * _e1666)), (_e1634.z + (_e1691.z * _e1666)), (_e1634.w + _e1666));
                                                                                    } else {
                                                                                        let _e1669 = ((2u * _e1649.member_1) + 1u);
                                                                                        if (_e1669 < _e93) {
                                                                                        } else {
                                                                                            phi_4101_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e1672 = radiance.member[_e1669];
                                                                                        phi_2535_ = vec4<f32>((_e1632.x - (_e1672.x * _e1666)), (_e1632.y - (_e1672.y * _e1666)), (_e1632.z - (_e1672.z * _e1666)), (_e1632.w - _e1666));
                                                                                        phi_2536_ = _e1634;
                                                                                    }
                                                                                    let _e1708 = phi_2535_;
                                                                                    let _e1710 = phi_2536_;
                                                                                    phi_2427_ = _e1708;
                                                                                    phi_2429_ = _e1710;
                                                                                } else {
                                                                                    phi_2427_ = vec4<f32>();
                                                                                    phi_2429_ = vec4<f32>();
                                                                                }
                                                                                let _e1712 = phi_2427_;
                                                                                let _e1714 = phi_2429_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_2423_ = _e1647;
                                                                                    phi_2426_ = _e1712;
                                                                                    phi_2428_ = _e1714;
                                                                                    phi_4101_ = _e1572;
                                                                                    break if !(_e1653);
                                                                                }
                                                                            }
                                                                            let _e1717 = phi_4101_;
                                                                            phi_4113_ = _e1717;
                                                                            if _e1717 {
                                                                                break;
                                                                            }
                                                                            let _e1719 = local_13;
                                                                            let _e1722 = local_14;
                                                                            if (_e1719.w > _e1722.w) {
                                                                                let _e1725 = (_e1719.w - _e1722.w);
                                                                                let _e1726 = (_e1725 / _e1719.w);
                                                                                let _e1728 = local_15;
                                                                                let _e1732 = local_16;
                                                                                let _e1736 = local_17;
                                                                                let _e1741 = local_18;
                                                                                phi_2558_ = (_e1741 + vec4<f32>((_e1728.x * _e1726), (_e1732.y * _e1726), (_e1736.z * _e1726), _e1725));
                                                                            } else {
                                                                                let _e2885 = local_49;
                                                                                phi_2558_ = _e2885;
                                                                            }
                                                                            let _e1744 = phi_2558_;
                                                                            phi_4123_ = _e1717;
                                                                            phi_2559_ = _e1744;
                                                                        }
                                                                        let _e1833 = phi_4123_;
                                                                        let _e1835 = phi_2559_;
                                                                        phi_4117_ = _e1833;
                                                                        phi_2728_ = _e1835;
                                                                    } else {
                                                                        let _e1433 = (_e1422 + 1u);
                                                                        if (_e1433 < _e84) {
                                                                        } else {
                                                                            phi_4113_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1436 = cells.member[_e1433];
                                                                        let _e1442 = (_e1436 + countOneBits((_e1425 & ((1u << bitcast<u32>(_e1427)) - 1u))));
                                                                        let _e1445 = params.member.member_7;
                                                                        if (_e1445 == 1u) {
                                                                            if ((_e522 & 1u) == 1u) {
                                                                                if (_e1442 < _e96) {
                                                                                } else {
                                                                                    phi_4113_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1525 = odd.member[_e1442];
                                                                                phi_2606_ = _e1525;
                                                                            } else {
                                                                                if (_e1442 < _e99) {
                                                                                } else {
                                                                                    phi_4113_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1522 = even.member[_e1442];
                                                                                phi_2606_ = _e1522;
                                                                            }
                                                                            let _e1527 = phi_2606_;
                                                                            phi_2727_ = _e1527;
                                                                        } else {
                                                                            let _e1447 = (_e1442 * 6u);
                                                                            let _e1450 = (_e1447 + select(0u, 1u, (_e349 < 0f)));
                                                                            let _e1452 = ((_e522 & 1u) == 1u);
                                                                            if _e1452 {
                                                                                if (_e1450 < _e96) {
                                                                                } else {
                                                                                    phi_4113_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1458 = odd.member[_e1450];
                                                                                phi_2634_ = _e1458;
                                                                            } else {
                                                                                if (_e1450 < _e99) {
                                                                                } else {
                                                                                    phi_4113_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1455 = even.member[_e1450];
                                                                                phi_2634_ = _e1455;
                                                                            }
                                                                            let _e1460 = phi_2634_;
                                                                            let _e1472 = ((_e1447 + 2u) + select(0u, 1u, (_e350 < 0f)));
                                                                            if _e1452 {
                                                                                if (_e1472 < _e96) {
                                                                                } else {
                                                                                    phi_4113_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1478 = odd.member[_e1472];
                                                                                phi_2671_ = _e1478;
                                                                            } else {
                                                                                if (_e1472 < _e99) {
                                                                                } else {
                                                                                    phi_4113_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1475 = even.member[_e1472];
                                                                                phi_2671_ = _e1475;
                                                                            }
                                                                            let _e1480 = phi_2671_;
                                                                            let _e1496 = ((_e1447 + 4u) + select(0u, 1u, (_e351 < 0f)));
                                                                            if _e1452 {
                                                                                if (_e1496 < _e96) {
                                                                                } else {
                                                                                    phi_4113_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1502 = odd.member[_e1496];
                                                                                phi_2712_ = _e1502;
                                                                            } else {
                                                                                if (_e1496 < _e99) {
                                                                                } else {
                                                                                    phi_4113_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1499 = even.member[_e1496];
                                                                                phi_2712_ = _e1499;
                                                                            }
                                                                            let _e1504 = phi_2712_;
                                                                            phi_2727_ = vec4<f32>((((_e1460.x * _e372) + (_e1480.x * _e382)) + (_e1504.x * _e392)), (((_e1460.y * _e372) + (_e1480.y * _e382)) + (_e1504.y * _e392)), (((_e1460.z * _e372) + (_e1480.z * _e382)) + (_e1504.z * _e392)), (((_e1460.w * _e372) + (_e1480.w * _e382)) + (_e1504.w * _e392)));
                                                                        }
                                                                        let _e1529 = phi_2727_;
                                                                        phi_4117_ = _e1375;
                                                                        phi_2728_ = _e1529;
                                                                    }
                                                                    let _e1837 = phi_4117_;
                                                                    let _e1839 = phi_2728_;
                                                                    phi_4116_ = _e1837;
                                                                    phi_2749_ = vec4<f32>((_e1379.x + (_e1839.x * _e1409)), (_e1379.y + (_e1839.y * _e1409)), (_e1379.z + (_e1839.z * _e1409)), (_e1379.w + (_e1839.w * _e1409)));
                                                                } else {
                                                                    phi_4116_ = _e1375;
                                                                    phi_2749_ = _e1379;
                                                                }
                                                                let _e1858 = phi_4116_;
                                                                let _e1860 = phi_2749_;
                                                                phi_4115_ = _e1858;
                                                                phi_2750_ = _e1860;
                                                            } else {
                                                                phi_4115_ = _e1375;
                                                                phi_2750_ = _e1379;
                                                            }
                                                            let _e1862 = phi_4115_;
                                                            let _e1864 = phi_2750_;
                                                            phi_4114_ = _e1862;
                                                            phi_2027_ = _e1864;
                                                        } else {
                                                            phi_4114_ = _e1375;
                                                            phi_2027_ = vec4<f32>();
                                                        }
                                                        let _e1866 = phi_4114_;
                                                        let _e1868 = phi_2027_;
                                                        continue;
                                                        continuing {
                                                            phi_4075_ = _e1866;
                                                            phi_2023_ = _e1392;
                                                            phi_2026_ = _e1868;
                                                            phi_4113_ = _e1866;
                                                            break if !(_e1398);
                                                        }
                                                    }
                                                    let _e1871 = phi_4113_;
                                                    phi_4192_ = _e1871;
                                                    if _e1871 {
                                                        break;
                                                    }
                                                    let _e1873 = ((2f - _e528) * _e527);
                                                    let _e1875 = local_21;
                                                    let _e1879 = local_22;
                                                    let _e1883 = local_23;
                                                    let _e1887 = local_24;
                                                    let _e1891 = ((_e529 * 0.5f) * _e527);
                                                    let _e1893 = local_25;
                                                    let _e1897 = local_26;
                                                    let _e1901 = local_27;
                                                    phi_4166_ = _e1871;
                                                    phi_2776_ = vec4<f32>(((_e1875.x * _e1873) + (_e1893.x * _e1891)), ((_e1879.y * _e1873) + (_e1897.y * _e1891)), ((_e1883.z * _e1873) + (_e1901.z * _e1891)), ((_e1887.w * _e1873) + (_e1204.w * _e1891)));
                                                }
                                                let _e1911 = phi_4166_;
                                                let _e1913 = phi_2776_;
                                                phi_4165_ = _e1911;
                                                phi_2777_ = _e1913;
                                                phi_2778_ = _e1206;
                                            }
                                            let _e1915 = phi_4165_;
                                            let _e1917 = phi_2777_;
                                            let _e1919 = phi_2778_;
                                            phi_4164_ = _e1915;
                                            phi_2779_ = _e1917;
                                            phi_2780_ = _e531;
                                            phi_2781_ = _e1919;
                                        }
                                        let _e1921 = phi_4164_;
                                        let _e1923 = phi_2779_;
                                        let _e1925 = phi_2780_;
                                        let _e1927 = phi_2781_;
                                        if _e1925 {
                                            if (_e522 < 10u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e1932 = params.member.member_2[_e522];
                                            let _e1933 = (_e525 - 1u);
                                            let _e1944 = ((_e500 * _e527) - 0.5f);
                                            let _e1945 = floor(_e1944);
                                            let _e1946 = (_e1944 - _e1945);
                                            let _e1953 = select(0i, select(select(i32(_e1945), i32(-2147483648), (_e1945 < -2147483600f)), 2147483647i, (_e1945 > 2147483500f)), (_e1945 == _e1945));
                                            let _e1955 = (bitcast<i32>(((_e365.x + _e1933) >> bitcast<u32>(_e523))) - 1i);
                                            if (_e1953 >= 0i) {
                                                phi_2834_ = (_e1953 <= _e1955);
                                            } else {
                                                phi_2834_ = false;
                                            }
                                            let _e1959 = phi_2834_;
                                            if (_e1953 >= -1i) {
                                                phi_2840_ = (_e1953 < _e1955);
                                            } else {
                                                phi_2840_ = false;
                                            }
                                            let _e1963 = phi_2840_;
                                            if _e1959 {
                                                phi_2845_ = bitcast<u32>(_e1953);
                                            } else {
                                                phi_2845_ = 0u;
                                            }
                                            let _e1966 = phi_2845_;
                                            if _e1963 {
                                                phi_2851_ = bitcast<u32>((_e1953 + 1i));
                                            } else {
                                                phi_2851_ = 0u;
                                            }
                                            let _e1970 = phi_2851_;
                                            if _e1959 {
                                                phi_2890_ = (1f - _e1946);
                                            } else {
                                                phi_2890_ = 0f;
                                            }
                                            let _e1991 = phi_2890_;
                                            let _e1994 = ((_e501 * _e527) - 0.5f);
                                            let _e1996 = floor(_e1994);
                                            let _e1997 = (_e1994 - _e1996);
                                            let _e2004 = select(0i, select(select(i32(_e1996), i32(-2147483648), (_e1996 < -2147483600f)), 2147483647i, (_e1996 > 2147483500f)), (_e1996 == _e1996));
                                            let _e2006 = (bitcast<i32>(((_e365.y + _e1933) >> bitcast<u32>(_e523))) - 1i);
                                            if (_e2004 >= 0i) {
                                                phi_2916_ = (_e2004 <= _e2006);
                                            } else {
                                                phi_2916_ = false;
                                            }
                                            let _e2010 = phi_2916_;
                                            if (_e2004 >= -1i) {
                                                phi_2922_ = (_e2004 < _e2006);
                                            } else {
                                                phi_2922_ = false;
                                            }
                                            let _e2014 = phi_2922_;
                                            if _e2010 {
                                                phi_2927_ = bitcast<u32>(_e2004);
                                            } else {
                                                phi_2927_ = 0u;
                                            }
                                            let _e2017 = phi_2927_;
                                            if _e2014 {
                                                phi_2933_ = bitcast<u32>((_e2004 + 1i));
                                            } else {
                                                phi_2933_ = 0u;
                                            }
                                            let _e2021 = phi_2933_;
                                            if _e2010 {
                                                phi_2972_ = (1f - _e1997);
                                            } else {
                                                phi_2972_ = 0f;
                                            }
                                            let _e2048 = phi_2972_;
                                            let _e2051 = ((_e502 * _e527) - 0.5f);
                                            let _e2053 = floor(_e2051);
                                            let _e2054 = (_e2051 - _e2053);
                                            let _e2061 = select(0i, select(select(i32(_e2053), i32(-2147483648), (_e2053 < -2147483600f)), 2147483647i, (_e2053 > 2147483500f)), (_e2053 == _e2053));
                                            let _e2063 = (bitcast<i32>(((_e365.z + _e1933) >> bitcast<u32>(_e523))) - 1i);
                                            if (_e2061 >= 0i) {
                                                phi_2998_ = (_e2061 <= _e2063);
                                            } else {
                                                phi_2998_ = false;
                                            }
                                            let _e2067 = phi_2998_;
                                            if (_e2061 >= -1i) {
                                                phi_3004_ = (_e2061 < _e2063);
                                            } else {
                                                phi_3004_ = false;
                                            }
                                            let _e2071 = phi_3004_;
                                            if _e2067 {
                                                phi_3009_ = bitcast<u32>(_e2061);
                                            } else {
                                                phi_3009_ = 0u;
                                            }
                                            let _e2074 = phi_3009_;
                                            if _e2071 {
                                                phi_3015_ = bitcast<u32>((_e2061 + 1i));
                                            } else {
                                                phi_3015_ = 0u;
                                            }
                                            let _e2078 = phi_3015_;
                                            if _e2067 {
                                                phi_3054_ = (1f - _e2054);
                                            } else {
                                                phi_3054_ = 0f;
                                            }
                                            let _e2093 = phi_3054_;
                                            phi_4139_ = _e1921;
                                            phi_3061_ = type_8(0u, 8u);
                                            phi_3064_ = vec4<f32>(0f, 0f, 0f, 0f);
                                            loop {
                                                let _e2096 = phi_4139_;
                                                let _e2098 = phi_3061_;
                                                let _e2100 = phi_3064_;
                                                local_38 = _e2100;
                                                if (_e2098.member < _e2098.member_1) {
                                                    phi_3062_ = type_8((_e2098.member + 1u), _e2098.member_1);
                                                    phi_3087_ = type_8(1u, _e2098.member);
                                                } else {
                                                    phi_3062_ = _e2098;
                                                    phi_3087_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e2113 = phi_3062_;
                                                let _e2115 = phi_3087_;
                                                let _e2119 = (bitcast<i32>(_e2115.member) != 0i);
                                                if _e2119 {
                                                    let _e2121 = ((_e2115.member_1 & 1u) == 1u);
                                                    let _e2123 = ((_e2115.member_1 & 2u) == 2u);
                                                    let _e2125 = ((_e2115.member_1 & 4u) == 4u);
                                                    let _e2130 = ((select(_e1991, select(0f, _e1946, _e1963), _e2121) * select(_e2048, select(0f, _e1997, _e2014), _e2123)) * select(_e2093, select(0f, _e2054, _e2071), _e2125));
                                                    let _e2137 = (((_e1932.z + select((_e1966 >> bitcast<u32>(2u)), (_e1970 >> bitcast<u32>(2u)), _e2121)) + select(((_e2017 >> bitcast<u32>(2u)) * _e1932.x), ((_e2021 >> bitcast<u32>(2u)) * _e1932.x), _e2123)) + select(((_e2074 >> bitcast<u32>(1u)) * _e1932.y), ((_e2078 >> bitcast<u32>(1u)) * _e1932.y), _e2125));
                                                    let _e2143 = (2u * _e2137);
                                                    if (_e2143 < _e84) {
                                                    } else {
                                                        phi_4180_ = true;
                                                        break;
                                                    }
                                                    let _e2146 = cells.member[_e2143];
                                                    if (_e2130 > 0f) {
                                                        let _e2148 = (((select(((_e1966 & 1u) | (((_e1966 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), ((_e1970 & 1u) | (((_e1970 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u))), _e2121) | select((((_e2017 & 1u) << bitcast<u32>(1u)) | (((_e2017 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), (((_e2021 & 1u) << bitcast<u32>(1u)) | (((_e2021 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u))), _e2123)) | select(((_e2074 & 1u) << bitcast<u32>(2u)), ((_e2078 & 1u) << bitcast<u32>(2u)), _e2125)) & 31u);
                                                        if (((_e2146 >> bitcast<u32>(_e2148)) & 1u) == 1u) {
                                                            if (_e522 == 0u) {
                                                                let _e2251 = (_e2137 * 6u);
                                                                let _e2252 = (_e2143 + 1u);
                                                                if (_e2252 < _e84) {
                                                                } else {
                                                                    phi_4180_ = true;
                                                                    break;
                                                                }
                                                                let _e2255 = cells.member[_e2252];
                                                                phi_3186_ = type_8(0u, 6u);
                                                                phi_3189_ = _e2255;
                                                                loop {
                                                                    let _e2257 = phi_3186_;
                                                                    let _e2259 = phi_3189_;
                                                                    local_28 = _e2259;
                                                                    local_29 = _e2259;
                                                                    local_36 = _e2259;
                                                                    local_37 = _e2259;
                                                                    if (_e2257.member < _e2257.member_1) {
                                                                        phi_3187_ = type_8((_e2257.member + 1u), _e2257.member_1);
                                                                        phi_3212_ = type_8(1u, _e2257.member);
                                                                    } else {
                                                                        phi_3187_ = _e2257;
                                                                        phi_3212_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e2272 = phi_3187_;
                                                                    let _e2274 = phi_3212_;
                                                                    let _e2278 = (bitcast<i32>(_e2274.member) != 0i);
                                                                    if _e2278 {
                                                                        let _e2279 = (_e2251 + _e2274.member_1);
                                                                        if (_e2279 < _e87) {
                                                                        } else {
                                                                            phi_4125_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2282 = facet_bits.member[_e2279];
                                                                        phi_3190_ = (_e2259 + countOneBits((_e2282 & ((1u << bitcast<u32>(_e2148)) - 1u))));
                                                                    } else {
                                                                        phi_3190_ = u32();
                                                                    }
                                                                    let _e2290 = phi_3190_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_3186_ = _e2272;
                                                                        phi_3189_ = _e2290;
                                                                        phi_4125_ = _e2096;
                                                                        break if !(_e2278);
                                                                    }
                                                                }
                                                                let _e2293 = phi_4125_;
                                                                phi_4180_ = _e2293;
                                                                if _e2293 {
                                                                    break;
                                                                }
                                                                if (_e2251 < _e87) {
                                                                } else {
                                                                    phi_4180_ = true;
                                                                    break;
                                                                }
                                                                let _e2296 = facet_bits.member[_e2251];
                                                                let _e2300 = (_e2251 + 1u);
                                                                if (_e2300 < _e87) {
                                                                } else {
                                                                    phi_4180_ = true;
                                                                    break;
                                                                }
                                                                let _e2303 = facet_bits.member[_e2300];
                                                                let _e2308 = (_e2251 + 2u);
                                                                if (_e2308 < _e87) {
                                                                } else {
                                                                    phi_4180_ = true;
                                                                    break;
                                                                }
                                                                let _e2311 = facet_bits.member[_e2308];
                                                                let _e2316 = (_e2251 + 3u);
                                                                if (_e2316 < _e87) {
                                                                } else {
                                                                    phi_4180_ = true;
                                                                    break;
                                                                }
                                                                let _e2319 = facet_bits.member[_e2316];
                                                                let _e2324 = (_e2251 + 4u);
                                                                if (_e2324 < _e87) {
                                                                } else {
                                                                    phi_4180_ = true;
                                                                    break;
                                                                }
                                                                let _e2327 = facet_bits.member[_e2324];
                                                                let _e2332 = (_e2251 + 5u);
                                                                if (_e2332 < _e87) {
                                                                } else {
                                                                    phi_4180_ = true;
                                                                    break;
                                                                }
                                                                let _e2335 = facet_bits.member[_e2332];
                                                                let _e2339 = (((((((_e2296 >> bitcast<u32>(_e2148)) & 1u) + ((_e2303 >> bitcast<u32>(_e2148)) & 1u)) + ((_e2311 >> bitcast<u32>(_e2148)) & 1u)) + ((_e2319 >> bitcast<u32>(_e2148)) & 1u)) + ((_e2327 >> bitcast<u32>(_e2148)) & 1u)) + ((_e2335 >> bitcast<u32>(_e2148)) & 1u));
                                                                let _e2342 = params.member.member_7;
                                                                if (_e2342 == 1u) {
                                                                    let _e2467 = local_36;
                                                                    let _e2470 = local_37;
                                                                    phi_3329_ = type_8(_e2470, (_e2467 + _e2339));
                                                                    phi_3332_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    loop {
                                                                        let _e2473 = phi_3329_;
                                                                        let _e2475 = phi_3332_;
                                                                        local_52 = _e2475;
                                                                        if (_e2473.member < _e2473.member_1) {
                                                                            phi_3330_ = type_8((_e2473.member + 1u), _e2473.member_1);
                                                                            phi_3355_ = type_8(1u, _e2473.member);
                                                                        } else {
                                                                            phi_3330_ = _e2473;
                                                                            phi_3355_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e2488 = phi_3330_;
                                                                        let _e2490 = phi_3355_;
                                                                        let _e2494 = (bitcast<i32>(_e2490.member) != 0i);
                                                                        if _e2494 {
                                                                            let _e2495 = (2u * _e2490.member_1);
                                                                            if (_e2495 < _e93) {
                                                                            } else {
                                                                                phi_4173_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2499 = radiance.member[_e2495][0u];
                                                                            let _e2502 = radiance.member[_e2495][1u];
                                                                            let _e2505 = radiance.member[_e2495][2u];
                                                                            let _e2506 = (_e2495 + 1u);
                                                                            if (_e2506 < _e93) {
                                                                            } else {
                                                                                phi_4173_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2510 = radiance.member[_e2506][0u];
                                                                            let _e2513 = radiance.member[_e2506][1u];
                                                                            let _e2516 = radiance.member[_e2506][2u];
                                                                            if (_e2490.member_1 < _e90) {
                                                                            } else {
                                                                                phi_4173_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2526 = facets.member[_e2490.member_1].member_2;
                                                                            let _e2535 = sqrt((((_e2526[0] * _e2526[0]) + (_e2526[1] * _e2526[1])) + (_e2526[2] * _e2526[2])));
                                                                            phi_3333_ = vec4<f32>((_e2475.x + (select(_e2510, _e2499, (_e2499 > _e2510)) * _e2535)), (_e2475.y + (select(_e2513, _e2502, (_e2502 > _e2513)) * _e2535)), (_e2475.z + (select(_e2516, _e2505, (_e2505 > _e2516)) * _e2535)), (_e2475.w + _e2535));
                                                                        } else {
                                                                            phi_3333_ = vec4<f32>();
                                                                        }
                                                                        let _e2549 = phi_3333_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_3329_ = _e2488;
                                                                            phi_3332_ = _e2549;
                                                                            phi_4173_ = _e2293;
                                                                            break if !(_e2494);
                                                                        }
                                                                    }
                                                                    let _e2552 = phi_4173_;
                                                                    phi_4180_ = _e2552;
                                                                    if _e2552 {
                                                                        break;
                                                                    }
                                                                    phi_4190_ = _e2552;
                                                                    let _e2986 = local_52;
                                                                    phi_3597_ = _e2986;
                                                                } else {
                                                                    let _e2345 = local_28;
                                                                    let _e2348 = local_29;
                                                                    phi_3461_ = type_8(_e2348, (_e2345 + _e2339));
                                                                    phi_3464_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    phi_3466_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    loop {
                                                                        let _e2351 = phi_3461_;
                                                                        let _e2353 = phi_3464_;
                                                                        let _e2355 = phi_3466_;
                                                                        local_30 = _e2353;
                                                                        local_31 = _e2355;
                                                                        local_32 = _e2353;
                                                                        local_33 = _e2353;
                                                                        local_34 = _e2353;
                                                                        local_35 = _e2355;
                                                                        local_51 = _e2355;
                                                                        if (_e2351.member < _e2351.member_1) {
                                                                            phi_3462_ = type_8((_e2351.member + 1u), _e2351.member_1);
                                                                            phi_3489_ = type_8(1u, _e2351.member);
                                                                        } else {
                                                                            phi_3462_ = _e2351;
                                                                            phi_3489_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e2368 = phi_3462_;
                                                                        let _e2370 = phi_3489_;
                                                                        let _e2374 = (bitcast<i32>(_e2370.member) != 0i);
                                                                        if _e2374 {
                                                                            if (_e2370.member_1 < _e90) {
                                                                            } else {
                                                                                phi_4168_ = true;
                                                                                break;
                                                                            }
                                                                            let _e2378 = facets.member[_e2370.member_1].member_2;
                                                                            let _e2387 = -((((_e349 * _e2378[0]) + (_e350 * _e2378[1])) + (_e351 * _e2378[2])));
                                                                            if (_e2387 > 0f) {
                                                                                let _e2409 = (2u * _e2370.member_1);
                                                                                if (_e2409 < _e93) {
                                                                                } else {
                                                                                    phi_4168_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e2412 = radiance.member[_e2409];
                                                                                phi_3573_ = _e2353;
                                                                                phi_3574_ = vec4<f32>((_e2355.x + (_e2412.x * _e2387)), (_e2355.y + (_e2412.y * _e2387)), (_e2355.z + (_e2412.z * _e2387)), (_e2355.w + _e2387));
                                                                            } else {
                                                                                let _e2390 = ((2u * _e2370.member_1) + 1u);
                                                                                if (_e2390 < _e93) {
                                                                                } else {
                                                                                    phi_4168_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e2393 = radiance.member[_e2390];
                                                                                phi_3573_ = vec4<f32>((_e2353.x - (_e2393.x * _e2387)), (_e2353.y - (_e2393.y * _e2387)), (_e2353.z - (_e2393.z * _e2387)), (_e2353.w - _e2387));
                                                                                phi_3574_ = _e2355;
                                                                            }
                                                                            let _e2429 = phi_3573_;
                                                                            let _e2431 = phi_3574_;
                                                                            phi_3465_ = _e2429;
                                                                            phi_3467_ = _e2431;
                                                                        } else {
                                                                            phi_3465_ = vec4<f32>();
                                                                            phi_3467_ = vec4<f32>();
                                                                        }
                                                                        let _e2433 = phi_3465_;
                                                                        let _e2435 = phi_3467_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_3461_ = _e2368;
                                                                            phi_3464_ = _e2433;
                                                                            phi_3466_ = _e2435;
                                                                            phi_4168_ = _e2293;
                                                                            break if !(_e2374);
                                                                        }
                                                                    }
                                                                    let _e2438 = phi_4168_;
                                                                    phi_4180_ = _e2438;
                                                                    if _e2438 {
                                                                        break;
                                                                    }
                                                                    let _e2440 = local_30;
                                                                    let _e2443 = local_31;
                                                                    if (_e2440.w > _e2443.w) {
                                                                        let _e2446 = (_e2440.w - _e2443.w);
                                                                        let _e2447 = (_e2446 / _e2440.w);
                                                                        let _e2449 = local_32;
                                                                        let _e2453 = local_33;
                                                                        let _e2457 = local_34;
                                                                        let _e2462 = local_35;
                                                                        phi_3596_ = (_e2462 + vec4<f32>((_e2449.x * _e2447), (_e2453.y * _e2447), (_e2457.z * _e2447), _e2446));
                                                                    } else {
                                                                        let _e2974 = local_51;
                                                                        phi_3596_ = _e2974;
                                                                    }
                                                                    let _e2465 = phi_3596_;
                                                                    phi_4190_ = _e2438;
                                                                    phi_3597_ = _e2465;
                                                                }
                                                                let _e2554 = phi_4190_;
                                                                let _e2556 = phi_3597_;
                                                                phi_4184_ = _e2554;
                                                                phi_3766_ = _e2556;
                                                            } else {
                                                                let _e2154 = (_e2143 + 1u);
                                                                if (_e2154 < _e84) {
                                                                } else {
                                                                    phi_4180_ = true;
                                                                    break;
                                                                }
                                                                let _e2157 = cells.member[_e2154];
                                                                let _e2163 = (_e2157 + countOneBits((_e2146 & ((1u << bitcast<u32>(_e2148)) - 1u))));
                                                                let _e2166 = params.member.member_7;
                                                                if (_e2166 == 1u) {
                                                                    if ((_e522 & 1u) == 1u) {
                                                                        if (_e2163 < _e96) {
                                                                        } else {
                                                                            phi_4180_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2246 = odd.member[_e2163];
                                                                        phi_3644_ = _e2246;
                                                                    } else {
                                                                        if (_e2163 < _e99) {
                                                                        } else {
                                                                            phi_4180_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2243 = even.member[_e2163];
                                                                        phi_3644_ = _e2243;
                                                                    }
                                                                    let _e2248 = phi_3644_;
                                                                    phi_3765_ = _e2248;
                                                                } else {
                                                                    let _e2168 = (_e2163 * 6u);
                                                                    let _e2171 = (_e2168 + select(0u, 1u, (_e349 < 0f)));
                                                                    let _e2173 = ((_e522 & 1u) == 1u);
                                                                    if _e2173 {
                                                                        if (_e2171 < _e96) {
                                                                        } else {
                                                                            phi_4180_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2179 = odd.member[_e2171];
                                                                        phi_3672_ = _e2179;
                                                                    } else {
                                                                        if (_e2171 < _e99) {
                                                                        } else {
                                                                            phi_4180_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2176 = even.member[_e2171];
                                                                        phi_3672_ = _e2176;
                                                                    }
                                                                    let _e2181 = phi_3672_;
                                                                    let _e2193 = ((_e2168 + 2u) + select(0u, 1u, (_e350 < 0f)));
                                                                    if _e2173 {
                                                                        if (_e2193 < _e96) {
                                                                        } else {
                                                                            phi_4180_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2199 = odd.member[_e2193];
                                                                        phi_3709_ = _e2199;
                                                                    } else {
                                                                        if (_e2193 < _e99) {
                                                                        } else {
                                                                            phi_4180_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2196 = even.member[_e2193];
                                                                        phi_3709_ = _e2196;
                                                                    }
                                                                    let _e2201 = phi_3709_;
                                                                    let _e2217 = ((_e2168 + 4u) + select(0u, 1u, (_e351 < 0f)));
                                                                    if _e2173 {
                                                                        if (_e2217 < _e96) {
                                                                        } else {
                                                                            phi_4180_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2223 = odd.member[_e2217];
                                                                        phi_3750_ = _e2223;
                                                                    } else {
                                                                        if (_e2217 < _e99) {
                                                                        } else {
                                                                            phi_4180_ = true;
                                                                            break;
                                                                        }
                                                                        let _e2220 = even.member[_e2217];
                                                                        phi_3750_ = _e2220;
                                                                    }
                                                                    let _e2225 = phi_3750_;
                                                                    phi_3765_ = vec4<f32>((((_e2181.x * _e372) + (_e2201.x * _e382)) + (_e2225.x * _e392)), (((_e2181.y * _e372) + (_e2201.y * _e382)) + (_e2225.y * _e392)), (((_e2181.z * _e372) + (_e2201.z * _e382)) + (_e2225.z * _e392)), (((_e2181.w * _e372) + (_e2201.w * _e382)) + (_e2225.w * _e392)));
                                                                }
                                                                let _e2250 = phi_3765_;
                                                                phi_4184_ = _e2096;
                                                                phi_3766_ = _e2250;
                                                            }
                                                            let _e2558 = phi_4184_;
                                                            let _e2560 = phi_3766_;
                                                            phi_4183_ = _e2558;
                                                            phi_3787_ = vec4<f32>((_e2100.x + (_e2560.x * _e2130)), (_e2100.y + (_e2560.y * _e2130)), (_e2100.z + (_e2560.z * _e2130)), (_e2100.w + (_e2560.w * _e2130)));
                                                        } else {
                                                            phi_4183_ = _e2096;
                                                            phi_3787_ = _e2100;
                                                        }
                                                        let _e2579 = phi_4183_;
                                                        let _e2581 = phi_3787_;
                                                        phi_4182_ = _e2579;
                                                        phi_3788_ = _e2581;
                                                    } else {
                                                        phi_4182_ = _e2096;
                                                        phi_3788_ = _e2100;
                                                    }
                                                    let _e2583 = phi_4182_;
                                                    let _e2585 = phi_3788_;
                                                    phi_4181_ = _e2583;
                                                    phi_3065_ = _e2585;
                                                } else {
                                                    phi_4181_ = _e2096;
                                                    phi_3065_ = vec4<f32>();
                                                }
                                                let _e2587 = phi_4181_;
                                                let _e2589 = phi_3065_;
                                                continue;
                                                continuing {
                                                    phi_4139_ = _e2587;
                                                    phi_3061_ = _e2113;
                                                    phi_3064_ = _e2589;
                                                    phi_4180_ = _e2587;
                                                    break if !(_e2119);
                                                }
                                            }
                                            let _e2592 = phi_4180_;
                                            phi_4192_ = _e2592;
                                            if _e2592 {
                                                break;
                                            }
                                            let _e2594 = local_38;
                                            phi_4198_ = _e2592;
                                            phi_3790_ = (_e2594 * _e527);
                                        } else {
                                            phi_4198_ = _e1921;
                                            phi_3790_ = vec4<f32>(0f, 0f, 0f, 0f);
                                        }
                                        let _e2597 = phi_4198_;
                                        let _e2599 = phi_3790_;
                                        let _e2602 = select(_e1923, _e2599, vec4(select(_e1927, true, _e1925)));
                                        let _e2604 = (_e2602.w * _e494);
                                        let _e2605 = (_e2604 > 0f);
                                        if _e2605 {
                                            let _e2607 = select(_e484, _e2604, (_e2604 < _e484));
                                            let _e2613 = (((_e494 * _e464) * _e2607) / _e2604);
                                            phi_3829_ = vec3<f32>((_e458.x + (_e2602.x * _e2613)), (_e458.y + (_e2602.y * _e2613)), (_e458.z + (_e2602.z * _e2613)));
                                            phi_3830_ = (_e462 + _e2607);
                                        } else {
                                            phi_3829_ = _e458;
                                            phi_3830_ = 0f;
                                        }
                                        let _e2626 = phi_3829_;
                                        let _e2628 = phi_3830_;
                                        phi_4195_ = _e2597;
                                        phi_3833_ = _e2626;
                                        phi_3834_ = (_e460 + _e494);
                                        phi_3835_ = _e2628;
                                        phi_3836_ = select(_e485, _e464, _e2605);
                                    }
                                    let _e2632 = phi_4195_;
                                    let _e2634 = phi_3833_;
                                    let _e2636 = phi_3834_;
                                    let _e2638 = phi_3835_;
                                    let _e2640 = phi_3836_;
                                    phi_4194_ = _e2632;
                                    phi_3838_ = _e2634;
                                    phi_3839_ = _e2636;
                                    phi_3840_ = _e2638;
                                    phi_3841_ = _e2640;
                                    phi_3842_ = select(true, false, _e486);
                                }
                                let _e2643 = phi_4194_;
                                let _e2645 = phi_3838_;
                                let _e2647 = phi_3839_;
                                let _e2649 = phi_3840_;
                                let _e2651 = phi_3841_;
                                let _e2653 = phi_3842_;
                                phi_4193_ = _e2643;
                                phi_624_ = _e2645;
                                phi_626_ = _e2647;
                                phi_628_ = _e2649;
                                phi_630_ = _e2651;
                                phi_3844_ = _e2653;
                            } else {
                                phi_4193_ = _e454;
                                phi_624_ = vec3<f32>();
                                phi_626_ = f32();
                                phi_628_ = f32();
                                phi_630_ = f32();
                                phi_3844_ = false;
                            }
                            let _e2655 = phi_4193_;
                            let _e2657 = phi_624_;
                            let _e2659 = phi_626_;
                            let _e2661 = phi_628_;
                            let _e2663 = phi_630_;
                            let _e2665 = phi_3844_;
                            continue;
                            continuing {
                                phi_4006_ = _e2655;
                                phi_620_ = _e477;
                                phi_623_ = _e2657;
                                phi_625_ = _e2659;
                                phi_627_ = _e2661;
                                phi_629_ = _e2663;
                                phi_4192_ = _e2655;
                                break if !(_e2665);
                            }
                        }
                        let _e2668 = phi_4192_;
                        phi_4200_ = _e2668;
                        if _e2668 {
                            break;
                        }
                        let _e2670 = local_39;
                        let _e2673 = local_40;
                        let _e2674 = (_e2673 * (1f - _e2670));
                        let _e2676 = local_41;
                        let _e2679 = local_42;
                        let _e2682 = local_43;
                        let _e2686 = params.member.member_4;
                        phi_4201_ = _e2668;
                        phi_389_ = vec3<f32>((_e296.x + ((_e2676.x + (_e2686.x * _e2674)) * _e336)), (_e296.y + ((_e2679.y + (_e2686.y * _e2674)) * _e336)), (_e296.z + ((_e2682.z + (_e2686.z * _e2674)) * _e336)));
                    } else {
                        phi_4201_ = _e292;
                        phi_389_ = vec3<f32>();
                    }
                    let _e2707 = phi_4201_;
                    let _e2709 = phi_389_;
                    continue;
                    continuing {
                        phi_4028_ = _e2707;
                        phi_385_ = _e309;
                        phi_388_ = _e2709;
                        phi_4200_ = _e2707;
                        break if !(_e315);
                    }
                }
                let _e2712 = phi_4200_;
                if _e2712 {
                    break;
                }
                let _e2714 = local_44;
                let _e2718 = local_45;
                let _e2722 = local_46;
                if (_e108 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e108] = vec4<f32>((_e2714.x * 3.1415927f), (_e2718.y * 3.1415927f), (_e2722.z * 3.1415927f), 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn cone_bounce(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
