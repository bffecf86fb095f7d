struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
}

struct type_18 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
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

struct type_30 {
    member: array<vec4<f32>>,
}

struct type_34 {
    member: array<type_26>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<u32>,
    member_2: array<vec4<u32>, 10>,
    member_3: array<vec4<f32>, 16>,
    member_4: array<vec4<f32>, 16>,
    member_5: vec4<f32>,
    member_6: vec4<f32>,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: f32,
}

struct type_39 {
    member: type_38,
}

struct type_41 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: i32,
    member_4: f32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_39;
@group(0) @binding(1) 
var<storage> cells: type_11;
@group(0) @binding(2) 
var<storage> facet_bits: type_11;
@group(0) @binding(3) 
var<storage> facets: type_20;
@group(0) @binding(4) 
var<storage> radiance: type_30;
@group(0) @binding(5) 
var<storage> odd: type_30;
@group(0) @binding(6) 
var<storage> even: type_30;
@group(0) @binding(7) 
var<storage> surfels: type_34;
@group(0) @binding(8) 
var<storage, read_write> out: type_30;

fn function_() {
    var phi_315_: f32;
    var phi_2433_: bool;
    var phi_320_: type_8;
    var phi_323_: vec3<f32>;
    var phi_321_: type_8;
    var phi_346_: type_8;
    var phi_484_: f32;
    var phi_492_: f32;
    var phi_505_: f32;
    var phi_506_: vec3<f32>;
    var phi_550_: bool;
    var phi_559_: u32;
    var phi_591_: i32;
    var phi_605_: bool;
    var phi_622_: f32;
    var phi_623_: f32;
    var phi_624_: bool;
    var phi_661_: i32;
    var phi_675_: bool;
    var phi_692_: f32;
    var phi_693_: f32;
    var phi_694_: bool;
    var phi_731_: i32;
    var phi_745_: bool;
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_764_: bool;
    var phi_2409_: bool;
    var phi_772_: type_8;
    var phi_775_: vec3<f32>;
    var phi_777_: type_41;
    var phi_779_: type_41;
    var phi_781_: type_41;
    var phi_783_: f32;
    var phi_785_: f32;
    var phi_773_: type_8;
    var phi_808_: type_8;
    var phi_828_: bool;
    var phi_839_: u32;
    var phi_860_: f32;
    var phi_861_: i32;
    var phi_862_: u32;
    var phi_863_: f32;
    var phi_864_: f32;
    var phi_865_: i32;
    var phi_866_: u32;
    var phi_867_: f32;
    var phi_923_: u32;
    var phi_940_: f32;
    var phi_961_: bool;
    var phi_973_: u32;
    var phi_984_: u32;
    var phi_992_: f32;
    var phi_1031_: f32;
    var phi_1042_: f32;
    var phi_1064_: bool;
    var phi_1076_: u32;
    var phi_1087_: u32;
    var phi_1095_: f32;
    var phi_1134_: f32;
    var phi_1145_: f32;
    var phi_1167_: bool;
    var phi_1179_: u32;
    var phi_1190_: u32;
    var phi_1198_: f32;
    var phi_1237_: f32;
    var phi_1264_: f32;
    var phi_1265_: f32;
    var phi_1266_: u32;
    var phi_1267_: u32;
    var phi_1268_: u32;
    var phi_1269_: u32;
    var phi_1270_: f32;
    var phi_1271_: f32;
    var phi_1272_: u32;
    var phi_1273_: u32;
    var phi_1274_: u32;
    var phi_1275_: u32;
    var phi_1276_: u32;
    var phi_1277_: u32;
    var phi_2372_: bool;
    var phi_1280_: type_8;
    var phi_1283_: vec4<f32>;
    var phi_1281_: type_8;
    var phi_1306_: type_8;
    var phi_1860_: u32;
    var phi_1884_: vec4<f32>;
    var phi_1393_: type_8;
    var phi_1396_: u32;
    var phi_1394_: type_8;
    var phi_1419_: type_8;
    var phi_1397_: u32;
    var phi_2361_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1684_: type_8;
    var phi_1687_: vec4<f32>;
    var phi_1689_: vec4<f32>;
    var phi_1685_: type_8;
    var phi_1712_: type_8;
    var phi_1796_: vec4<f32>;
    var phi_1797_: vec4<f32>;
    var phi_1688_: vec4<f32>;
    var phi_1690_: vec4<f32>;
    var phi_2449_: bool;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_1819_: vec4<f32>;
    var local_8: u32;
    var local_9: u32;
    var phi_1533_: type_8;
    var phi_1536_: vec4<f32>;
    var phi_1534_: type_8;
    var phi_1559_: type_8;
    var phi_1537_: vec4<f32>;
    var phi_2458_: bool;
    var phi_2473_: bool;
    var phi_1820_: vec4<f32>;
    var phi_1834_: vec4<f32>;
    var phi_2469_: bool;
    var phi_1885_: vec4<f32>;
    var phi_2468_: bool;
    var phi_1906_: vec4<f32>;
    var phi_2467_: bool;
    var phi_1907_: vec4<f32>;
    var phi_2466_: bool;
    var phi_1284_: vec4<f32>;
    var phi_2465_: bool;
    var phi_2494_: bool;
    var phi_1908_: vec4<f32>;
    var phi_2493_: bool;
    var phi_1909_: vec4<f32>;
    var phi_1910_: bool;
    var phi_1954_: vec3<f32>;
    var phi_1955_: f32;
    var phi_1956_: f32;
    var phi_2161_: i32;
    var phi_2176_: type_41;
    var phi_2177_: type_41;
    var phi_2196_: bool;
    var phi_2218_: f32;
    var phi_2219_: f32;
    var phi_2220_: bool;
    var phi_2082_: i32;
    var phi_2097_: type_41;
    var phi_2098_: type_41;
    var phi_2117_: bool;
    var phi_2139_: f32;
    var phi_2140_: f32;
    var phi_2141_: bool;
    var phi_2226_: type_41;
    var phi_2227_: type_41;
    var phi_1999_: i32;
    var phi_2014_: type_41;
    var phi_2015_: type_41;
    var phi_2034_: bool;
    var phi_2056_: f32;
    var phi_2057_: f32;
    var phi_2058_: bool;
    var phi_2228_: type_41;
    var phi_2229_: type_41;
    var phi_2230_: type_41;
    var phi_2478_: bool;
    var phi_2231_: vec3<f32>;
    var phi_2232_: type_41;
    var phi_2233_: type_41;
    var phi_2234_: type_41;
    var phi_2235_: f32;
    var phi_2236_: f32;
    var phi_2477_: bool;
    var phi_2238_: vec3<f32>;
    var phi_2239_: type_41;
    var phi_2240_: type_41;
    var phi_2241_: type_41;
    var phi_2242_: f32;
    var phi_2243_: f32;
    var phi_2244_: bool;
    var phi_2476_: bool;
    var phi_776_: vec3<f32>;
    var phi_778_: type_41;
    var phi_780_: type_41;
    var phi_782_: type_41;
    var phi_784_: f32;
    var phi_786_: f32;
    var phi_2246_: bool;
    var phi_2475_: bool;
    var local_10: f32;
    var local_11: f32;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: vec3<f32>;
    var phi_2512_: bool;
    var phi_324_: vec3<f32>;
    var phi_2511_: bool;
    var local_15: vec3<f32>;
    var local_16: vec3<f32>;
    var local_17: vec3<f32>;
    var phi_2292_: vec4<f32>;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = gid_1;
            let _e83 = arrayLength((&cells.member));
            let _e86 = arrayLength((&facet_bits.member));
            let _e89 = arrayLength((&facets.member));
            let _e92 = arrayLength((&radiance.member));
            let _e105 = params.member.member_9;
            let _e109 = (_e80.x + (_e80.y * 2097152u));
            if (_e109 < _e105) {
                if (_e109 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e115 = surfels.member[_e109].member;
                let _e119 = surfels.member[_e109].member_1;
                let _e123 = surfels.member[_e109].member_2;
                let _e127 = surfels.member[_e109].member_4;
                if (_e119 == 4294967295u) {
                    phi_2292_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e140 = params.member.member;
                    let _e153 = params.member.member_12;
                    let _e157 = (((_e115[0] - _e140.x) / _e140.w) + (_e127[0] * _e153));
                    let _e158 = (((_e115[1] - _e140.y) / _e140.w) + (_e127[1] * _e153));
                    let _e159 = (((_e115[2] - _e140.z) / _e140.w) + (_e127[2] * _e153));
                    let _e163 = bitcast<f32>((1065353216u | (bitcast<u32>(_e123[2]) & 2147483648u)));
                    let _e165 = (-1f / (_e163 + _e123[2]));
                    let _e167 = ((_e123[0] * _e123[1]) * _e165);
                    let _e181 = params.member.member_10;
                    let _e182 = (_e181 == 0u);
                    if _e182 {
                        phi_315_ = 0f;
                    } else {
                        let _e186 = ((_e109 * 1664525u) + 1013904223u);
                        let _e188 = (((_e181 * 1664525u) + 1013904223u) + (_e186 * 1013904223u));
                        let _e190 = (_e186 + (1013904223u * _e188));
                        let _e194 = (1013904223u + (_e190 * (1013904223u + (_e188 * _e190))));
                        phi_315_ = (f32((((_e188 ^ (_e188 >> bitcast<u32>(16i))) + ((_e190 ^ (_e190 >> bitcast<u32>(16i))) * (_e194 ^ (_e194 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                    }
                    let _e211 = phi_315_;
                    let _e214 = params.member.member_7;
                    phi_2433_ = false;
                    phi_320_ = type_8(0u, _e214);
                    phi_323_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e217 = phi_2433_;
                        let _e219 = phi_320_;
                        let _e221 = phi_323_;
                        local_15 = _e221;
                        local_16 = _e221;
                        local_17 = _e221;
                        if (_e219.member < _e219.member_1) {
                            phi_321_ = type_8((_e219.member + 1u), _e219.member_1);
                            phi_346_ = type_8(1u, _e219.member);
                        } else {
                            phi_321_ = _e219;
                            phi_346_ = type_8(0u, type_8().member_1);
                        }
                        let _e234 = phi_321_;
                        let _e236 = phi_346_;
                        let _e240 = (bitcast<i32>(_e236.member) != 0i);
                        if _e240 {
                            let _e241 = (_e236.member_1 < 16u);
                            if _e241 {
                            } else {
                                phi_2511_ = true;
                                break;
                            }
                            let _e245 = params.member.member_3[_e236.member_1];
                            if _e182 {
                                phi_505_ = 1.4142135f;
                                phi_506_ = vec3<f32>(_e245.x, _e245.y, _e245.z);
                            } else {
                                let _e250 = ((_e109 * 1664525u) + 1013904223u);
                                let _e252 = (((1u + _e236.member_1) * 1664525u) + 1013904223u);
                                let _e254 = (((_e181 * 1664525u) + 1013904223u) + (_e250 * 1013904223u));
                                let _e256 = (_e250 + (_e252 * _e254));
                                let _e258 = (_e252 + (_e254 * _e256));
                                let _e260 = (1013904223u + (_e256 * _e258));
                                let _e266 = (_e256 ^ (_e256 >> bitcast<u32>(16i)));
                                let _e269 = (_e258 ^ (_e258 >> bitcast<u32>(16i)));
                                let _e274 = ((_e254 ^ (_e254 >> bitcast<u32>(16i))) + (_e266 * (_e260 ^ (_e260 >> bitcast<u32>(16i)))));
                                let _e276 = (_e266 + (_e269 * _e274));
                                if _e241 {
                                } else {
                                    phi_2511_ = true;
                                    break;
                                }
                                let _e294 = params.member.member_4[_e236.member_1];
                                let _e299 = (_e294.y + ((_e294.x - _e294.y) * (f32((_e274 >> bitcast<u32>(8i))) * 0.000000059604645f)));
                                let _e304 = ((_e294.z + (_e294.w * (f32((_e276 >> bitcast<u32>(8i))) * 0.000000059604645f))) + _e211);
                                let _e308 = floor(((_e304 * 4f) + 0.5f));
                                let _e314 = ((((6.2831855f * _e304) - (_e308 * 1.5703125f)) - (_e308 * 0.0004837513f)) - (_e308 * 0.0000000754979f));
                                let _e315 = (_e314 * _e314);
                                let _e322 = (_e314 + ((_e314 * _e315) * (-0.16666655f + (_e315 * (0.008332161f + (_e315 * -0.00019515296f))))));
                                let _e331 = ((1f - (0.5f * _e315)) + ((_e315 * _e315) * (0.041666646f + (_e315 * (-0.0013887316f + (_e315 * 0.000024433157f))))));
                                let _e338 = select(0i, select(select(i32(_e308), i32(-2147483648), (_e308 < -2147483600f)), 2147483647i, (_e308 > 2147483500f)), (_e308 == _e308));
                                let _e340 = ((_e338 & 1i) == 0i);
                                let _e341 = select(_e331, _e322, _e340);
                                let _e342 = select(_e322, _e331, _e340);
                                if ((_e338 & 2i) == 0i) {
                                    phi_484_ = _e341;
                                } else {
                                    phi_484_ = -(_e341);
                                }
                                let _e347 = phi_484_;
                                if (((_e338 + 1i) & 2i) == 0i) {
                                    phi_492_ = _e342;
                                } else {
                                    phi_492_ = -(_e342);
                                }
                                let _e353 = phi_492_;
                                let _e354 = (1f - _e299);
                                let _e357 = sqrt(select(0f, _e354, (_e354 > 0f)));
                                phi_505_ = (1f + (f32(((_e269 + (_e274 * _e276)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                                phi_506_ = vec3<f32>((_e357 * _e353), (_e357 * _e347), sqrt(_e299));
                            }
                            let _e368 = phi_505_;
                            let _e370 = phi_506_;
                            let _e373 = params.member.member_11;
                            let _e376 = params.member.member_13;
                            let _e394 = ((((1f + (((_e163 * _e123[0]) * _e123[0]) * _e165)) * _e370.x) + (_e167 * _e370.y)) + (_e123[0] * _e370.z));
                            let _e395 = ((((_e163 * _e167) * _e370.x) + ((_e163 + ((_e123[1] * _e123[1]) * _e165)) * _e370.y)) + (_e123[1] * _e370.z));
                            let _e396 = ((((-(_e163) * _e123[0]) * _e370.x) + (-(_e123[1]) * _e370.y)) + (_e123[2] * _e370.z));
                            let _e399 = params.member.member_1;
                            let _e400 = abs(_e394);
                            let _e401 = abs(_e395);
                            let _e402 = abs(_e396);
                            if (_e400 >= _e401) {
                                phi_550_ = select(true, false, (_e400 >= _e402));
                            } else {
                                phi_550_ = true;
                            }
                            let _e407 = phi_550_;
                            if _e407 {
                                phi_559_ = select(2u, 1u, (_e401 >= _e402));
                            } else {
                                phi_559_ = 0u;
                            }
                            let _e411 = phi_559_;
                            let _e414 = floor((_e157 - 0.5f));
                            let _e424 = -(floor((0.5f - _e157)));
                            let _e432 = (_e394 < 0f);
                            if _e432 {
                                phi_591_ = (select(0i, select(select(i32(_e424), i32(-2147483648), (_e424 < -2147483600f)), 2147483647i, (_e424 > 2147483500f)), (_e424 == _e424)) - 1i);
                            } else {
                                phi_591_ = (select(0i, select(select(i32(_e414), i32(-2147483648), (_e414 < -2147483600f)), 2147483647i, (_e414 > 2147483500f)), (_e414 == _e414)) + 1i);
                            }
                            let _e436 = phi_591_;
                            if _e432 {
                                phi_605_ = (_e436 < 0i);
                            } else {
                                phi_605_ = (_e436 >= bitcast<i32>(_e399.x));
                            }
                            let _e441 = phi_605_;
                            if _e441 {
                                phi_623_ = f32();
                                phi_624_ = true;
                            } else {
                                let _e444 = (_e400 < 0.000001f);
                                if _e444 {
                                    phi_622_ = f32();
                                } else {
                                    phi_622_ = (((f32(_e436) + 0.5f) - _e157) / _e394);
                                }
                                let _e448 = phi_622_;
                                phi_623_ = _e448;
                                phi_624_ = _e444;
                            }
                            let _e450 = phi_623_;
                            let _e452 = phi_624_;
                            let _e457 = floor((_e158 - 0.5f));
                            let _e467 = -(floor((0.5f - _e158)));
                            let _e475 = (_e395 < 0f);
                            if _e475 {
                                phi_661_ = (select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < -2147483600f)), 2147483647i, (_e467 > 2147483500f)), (_e467 == _e467)) - 1i);
                            } else {
                                phi_661_ = (select(0i, select(select(i32(_e457), i32(-2147483648), (_e457 < -2147483600f)), 2147483647i, (_e457 > 2147483500f)), (_e457 == _e457)) + 1i);
                            }
                            let _e479 = phi_661_;
                            if _e475 {
                                phi_675_ = (_e479 < 0i);
                            } else {
                                phi_675_ = (_e479 >= bitcast<i32>(_e399.y));
                            }
                            let _e484 = phi_675_;
                            if _e484 {
                                phi_693_ = f32();
                                phi_694_ = true;
                            } else {
                                let _e487 = (_e401 < 0.000001f);
                                if _e487 {
                                    phi_692_ = f32();
                                } else {
                                    phi_692_ = (((f32(_e479) + 0.5f) - _e158) / _e395);
                                }
                                let _e491 = phi_692_;
                                phi_693_ = _e491;
                                phi_694_ = _e487;
                            }
                            let _e493 = phi_693_;
                            let _e495 = phi_694_;
                            let _e500 = floor((_e159 - 0.5f));
                            let _e510 = -(floor((0.5f - _e159)));
                            let _e518 = (_e396 < 0f);
                            if _e518 {
                                phi_731_ = (select(0i, select(select(i32(_e510), i32(-2147483648), (_e510 < -2147483600f)), 2147483647i, (_e510 > 2147483500f)), (_e510 == _e510)) - 1i);
                            } else {
                                phi_731_ = (select(0i, select(select(i32(_e500), i32(-2147483648), (_e500 < -2147483600f)), 2147483647i, (_e500 > 2147483500f)), (_e500 == _e500)) + 1i);
                            }
                            let _e522 = phi_731_;
                            if _e518 {
                                phi_745_ = (_e522 < 0i);
                            } else {
                                phi_745_ = (_e522 >= bitcast<i32>(_e399.z));
                            }
                            let _e527 = phi_745_;
                            if _e527 {
                                phi_763_ = f32();
                                phi_764_ = true;
                            } else {
                                let _e530 = (_e402 < 0.000001f);
                                if _e530 {
                                    phi_762_ = f32();
                                } else {
                                    phi_762_ = (((f32(_e522) + 0.5f) - _e159) / _e396);
                                }
                                let _e534 = phi_762_;
                                phi_763_ = _e534;
                                phi_764_ = _e530;
                            }
                            let _e536 = phi_763_;
                            let _e538 = phi_764_;
                            phi_2409_ = _e217;
                            phi_772_ = type_8(0u, 2048u);
                            phi_775_ = vec3<f32>(0f, 0f, 0f);
                            phi_777_ = type_41(_e159, _e396, 0u, _e522, select(_e536, 340282350000000000000000000000000000000f, _e538));
                            phi_779_ = type_41(_e158, _e395, 0u, _e479, select(_e493, 340282350000000000000000000000000000000f, _e495));
                            phi_781_ = type_41(_e157, _e394, 0u, _e436, select(_e450, 340282350000000000000000000000000000000f, _e452));
                            phi_783_ = 0f;
                            phi_785_ = 1f;
                            loop {
                                let _e542 = phi_2409_;
                                let _e544 = phi_772_;
                                let _e546 = phi_775_;
                                let _e548 = phi_777_;
                                let _e550 = phi_779_;
                                let _e552 = phi_781_;
                                let _e554 = phi_783_;
                                let _e556 = phi_785_;
                                local_10 = _e554;
                                local_11 = _e556;
                                local_12 = _e546;
                                local_13 = _e546;
                                local_14 = _e546;
                                if (_e544.member < _e544.member_1) {
                                    phi_773_ = type_8((_e544.member + 1u), _e544.member_1);
                                    phi_808_ = type_8(1u, _e544.member);
                                } else {
                                    phi_773_ = _e544;
                                    phi_808_ = type_8(0u, type_8().member_1);
                                }
                                let _e569 = phi_773_;
                                let _e571 = phi_808_;
                                if (bitcast<i32>(_e571.member) != 0i) {
                                    if (_e552.member_4 <= _e550.member_4) {
                                        phi_828_ = select(true, false, (_e552.member_4 <= _e548.member_4));
                                    } else {
                                        phi_828_ = true;
                                    }
                                    let _e582 = phi_828_;
                                    if _e582 {
                                        phi_839_ = select(2u, 1u, (_e550.member_4 <= _e548.member_4));
                                    } else {
                                        phi_839_ = 0u;
                                    }
                                    let _e587 = phi_839_;
                                    let _e588 = (_e587 == 0u);
                                    if _e588 {
                                        phi_864_ = _e552.member_4;
                                        phi_865_ = _e552.member_3;
                                        phi_866_ = _e552.member_2;
                                        phi_867_ = _e552.member_1;
                                    } else {
                                        if (_e587 == 1u) {
                                            phi_860_ = _e550.member_4;
                                            phi_861_ = _e550.member_3;
                                            phi_862_ = _e550.member_2;
                                            phi_863_ = _e550.member_1;
                                        } else {
                                            phi_860_ = _e548.member_4;
                                            phi_861_ = _e548.member_3;
                                            phi_862_ = _e548.member_2;
                                            phi_863_ = _e548.member_1;
                                        }
                                        let _e598 = phi_860_;
                                        let _e600 = phi_861_;
                                        let _e602 = phi_862_;
                                        let _e604 = phi_863_;
                                        phi_864_ = _e598;
                                        phi_865_ = _e600;
                                        phi_866_ = _e602;
                                        phi_867_ = _e604;
                                    }
                                    let _e609 = phi_864_;
                                    let _e611 = phi_865_;
                                    let _e613 = phi_866_;
                                    let _e615 = phi_867_;
                                    if (_e609 >= 340282350000000000000000000000000000000f) {
                                        phi_2477_ = _e542;
                                        phi_2238_ = vec3<f32>();
                                        phi_2239_ = type_41();
                                        phi_2240_ = type_41();
                                        phi_2241_ = type_41();
                                        phi_2242_ = f32();
                                        phi_2243_ = f32();
                                        phi_2244_ = false;
                                    } else {
                                        let _e617 = (1f - _e554);
                                        let _e618 = (_e556 * _e617);
                                        let _e619 = (_e618 < 0.001f);
                                        if _e619 {
                                            phi_2478_ = _e542;
                                            phi_2231_ = vec3<f32>();
                                            phi_2232_ = type_41();
                                            phi_2233_ = type_41();
                                            phi_2234_ = type_41();
                                            phi_2235_ = f32();
                                            phi_2236_ = f32();
                                        } else {
                                            let _e626 = (_e615 < 0f);
                                            if (_e613 < 10u) {
                                            } else {
                                                phi_2475_ = true;
                                                break;
                                            }
                                            let _e631 = params.member.member_2[_e613];
                                            let _e632 = (_e613 & 31u);
                                            let _e634 = (1u << bitcast<u32>(_e632));
                                            let _e635 = (_e634 - 1u);
                                            let _e638 = ((_e399.x + _e635) >> bitcast<u32>(_e632));
                                            let _e641 = ((_e399.y + _e635) >> bitcast<u32>(_e632));
                                            let _e644 = ((_e399.z + _e635) >> bitcast<u32>(_e632));
                                            let _e646 = (1f / f32(_e634));
                                            if _e588 {
                                                phi_923_ = _e638;
                                            } else {
                                                phi_923_ = select(_e644, _e641, (_e587 == 1u));
                                            }
                                            let _e650 = phi_923_;
                                            if (_e611 < 0i) {
                                                phi_2493_ = _e542;
                                                phi_1909_ = vec4<f32>();
                                                phi_1910_ = true;
                                            } else {
                                                let _e653 = (_e611 >= bitcast<i32>(_e650));
                                                if _e653 {
                                                    phi_2494_ = _e542;
                                                    phi_1908_ = vec4<f32>();
                                                } else {
                                                    let _e654 = f32(_e611);
                                                    if _e588 {
                                                        phi_940_ = _e654;
                                                    } else {
                                                        phi_940_ = (((_e157 + (_e394 * _e609)) * _e646) - 0.5f);
                                                    }
                                                    let _e658 = phi_940_;
                                                    let _e659 = floor(_e658);
                                                    let _e667 = select(0i, select(select(i32(_e659), i32(-2147483648), (_e659 < -2147483600f)), 2147483647i, (_e659 > 2147483500f)), (_e659 == _e659));
                                                    let _e669 = (bitcast<i32>(_e638) - 1i);
                                                    if (_e658 >= -0.5f) {
                                                        phi_961_ = (_e658 <= (f32(_e669) + 0.5f));
                                                    } else {
                                                        phi_961_ = false;
                                                    }
                                                    let _e675 = phi_961_;
                                                    let _e676 = (_e667 >= 0i);
                                                    let _e677 = (_e667 < _e669);
                                                    if _e676 {
                                                        phi_973_ = bitcast<u32>(select(_e667, _e669, (_e669 < _e667)));
                                                    } else {
                                                        phi_973_ = 0u;
                                                    }
                                                    let _e682 = phi_973_;
                                                    if _e677 {
                                                        let _e683 = (_e667 + 1i);
                                                        phi_984_ = bitcast<u32>(select(0i, _e683, (0i < _e683)));
                                                    } else {
                                                        phi_984_ = 0u;
                                                    }
                                                    let _e688 = phi_984_;
                                                    if _e676 {
                                                        phi_992_ = select(0f, (_e658 - _e659), _e677);
                                                    } else {
                                                        phi_992_ = 1f;
                                                    }
                                                    let _e691 = phi_992_;
                                                    let _e693 = (_e682 >> bitcast<u32>(2u));
                                                    let _e695 = (_e688 >> bitcast<u32>(2u));
                                                    let _e702 = ((_e682 & 1u) | (((_e682 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                                    let _e709 = ((_e688 & 1u) | (((_e688 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                                    if _e675 {
                                                        phi_1031_ = (1f - _e691);
                                                    } else {
                                                        phi_1031_ = 0f;
                                                    }
                                                    let _e712 = phi_1031_;
                                                    let _e713 = select(0f, _e691, _e675);
                                                    let _e714 = (_e587 == 1u);
                                                    if _e714 {
                                                        phi_1042_ = _e654;
                                                    } else {
                                                        phi_1042_ = (((_e158 + (_e395 * _e609)) * _e646) - 0.5f);
                                                    }
                                                    let _e718 = phi_1042_;
                                                    let _e720 = floor(_e718);
                                                    let _e728 = select(0i, select(select(i32(_e720), i32(-2147483648), (_e720 < -2147483600f)), 2147483647i, (_e720 > 2147483500f)), (_e720 == _e720));
                                                    let _e730 = (bitcast<i32>(_e641) - 1i);
                                                    if (_e718 >= -0.5f) {
                                                        phi_1064_ = (_e718 <= (f32(_e730) + 0.5f));
                                                    } else {
                                                        phi_1064_ = false;
                                                    }
                                                    let _e736 = phi_1064_;
                                                    let _e737 = (_e728 >= 0i);
                                                    let _e738 = (_e728 < _e730);
                                                    if _e737 {
                                                        phi_1076_ = bitcast<u32>(select(_e728, _e730, (_e730 < _e728)));
                                                    } else {
                                                        phi_1076_ = 0u;
                                                    }
                                                    let _e743 = phi_1076_;
                                                    if _e738 {
                                                        let _e744 = (_e728 + 1i);
                                                        phi_1087_ = bitcast<u32>(select(0i, _e744, (0i < _e744)));
                                                    } else {
                                                        phi_1087_ = 0u;
                                                    }
                                                    let _e749 = phi_1087_;
                                                    if _e737 {
                                                        phi_1095_ = select(0f, (_e718 - _e720), _e738);
                                                    } else {
                                                        phi_1095_ = 1f;
                                                    }
                                                    let _e752 = phi_1095_;
                                                    let _e755 = ((_e743 >> bitcast<u32>(2u)) * _e631.x);
                                                    let _e758 = ((_e749 >> bitcast<u32>(2u)) * _e631.x);
                                                    let _e767 = (((_e743 & 1u) << bitcast<u32>(1u)) | (((_e743 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                                    let _e776 = (((_e749 & 1u) << bitcast<u32>(1u)) | (((_e749 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                                    if _e736 {
                                                        phi_1134_ = (1f - _e752);
                                                    } else {
                                                        phi_1134_ = 0f;
                                                    }
                                                    let _e779 = phi_1134_;
                                                    let _e780 = select(0f, _e752, _e736);
                                                    let _e781 = (_e587 == 2u);
                                                    if _e781 {
                                                        phi_1145_ = _e654;
                                                    } else {
                                                        phi_1145_ = (((_e159 + (_e396 * _e609)) * _e646) - 0.5f);
                                                    }
                                                    let _e785 = phi_1145_;
                                                    let _e787 = floor(_e785);
                                                    let _e795 = select(0i, select(select(i32(_e787), i32(-2147483648), (_e787 < -2147483600f)), 2147483647i, (_e787 > 2147483500f)), (_e787 == _e787));
                                                    let _e797 = (bitcast<i32>(_e644) - 1i);
                                                    if (_e785 >= -0.5f) {
                                                        phi_1167_ = (_e785 <= (f32(_e797) + 0.5f));
                                                    } else {
                                                        phi_1167_ = false;
                                                    }
                                                    let _e803 = phi_1167_;
                                                    let _e804 = (_e795 >= 0i);
                                                    let _e805 = (_e795 < _e797);
                                                    if _e804 {
                                                        phi_1179_ = bitcast<u32>(select(_e795, _e797, (_e797 < _e795)));
                                                    } else {
                                                        phi_1179_ = 0u;
                                                    }
                                                    let _e810 = phi_1179_;
                                                    if _e805 {
                                                        let _e811 = (_e795 + 1i);
                                                        phi_1190_ = bitcast<u32>(select(0i, _e811, (0i < _e811)));
                                                    } else {
                                                        phi_1190_ = 0u;
                                                    }
                                                    let _e816 = phi_1190_;
                                                    if _e804 {
                                                        phi_1198_ = select(0f, (_e785 - _e787), _e805);
                                                    } else {
                                                        phi_1198_ = 1f;
                                                    }
                                                    let _e819 = phi_1198_;
                                                    let _e822 = ((_e810 >> bitcast<u32>(1u)) * _e631.y);
                                                    let _e825 = ((_e816 >> bitcast<u32>(1u)) * _e631.y);
                                                    let _e828 = ((_e810 & 1u) << bitcast<u32>(2u));
                                                    let _e831 = ((_e816 & 1u) << bitcast<u32>(2u));
                                                    if _e803 {
                                                        phi_1237_ = (1f - _e819);
                                                    } else {
                                                        phi_1237_ = 0f;
                                                    }
                                                    let _e834 = phi_1237_;
                                                    let _e835 = select(0f, _e819, _e803);
                                                    if _e588 {
                                                        phi_1264_ = _e835;
                                                        phi_1265_ = _e834;
                                                        phi_1266_ = _e831;
                                                        phi_1267_ = _e828;
                                                        phi_1268_ = _e825;
                                                        phi_1269_ = _e822;
                                                        phi_1270_ = _e780;
                                                        phi_1271_ = _e779;
                                                        phi_1272_ = _e776;
                                                        phi_1273_ = _e767;
                                                        phi_1274_ = _e758;
                                                        phi_1275_ = _e755;
                                                        phi_1276_ = _e702;
                                                        phi_1277_ = _e693;
                                                    } else {
                                                        phi_1264_ = select(_e780, _e713, _e714);
                                                        phi_1265_ = select(_e779, _e712, _e714);
                                                        phi_1266_ = select(_e776, _e709, _e714);
                                                        phi_1267_ = select(_e767, _e702, _e714);
                                                        phi_1268_ = select(_e758, _e695, _e714);
                                                        phi_1269_ = select(_e755, _e693, _e714);
                                                        phi_1270_ = select(_e713, _e835, _e714);
                                                        phi_1271_ = select(_e712, _e834, _e714);
                                                        phi_1272_ = select(_e709, _e831, _e714);
                                                        phi_1273_ = select(_e702, _e828, _e714);
                                                        phi_1274_ = select(_e695, _e825, _e714);
                                                        phi_1275_ = select(_e693, _e822, _e714);
                                                        phi_1276_ = select(_e828, _e767, _e714);
                                                        phi_1277_ = select(_e822, _e755, _e714);
                                                    }
                                                    let _e851 = phi_1264_;
                                                    let _e853 = phi_1265_;
                                                    let _e855 = phi_1266_;
                                                    let _e857 = phi_1267_;
                                                    let _e859 = phi_1268_;
                                                    let _e861 = phi_1269_;
                                                    let _e863 = phi_1270_;
                                                    let _e865 = phi_1271_;
                                                    let _e867 = phi_1272_;
                                                    let _e869 = phi_1273_;
                                                    let _e871 = phi_1274_;
                                                    let _e873 = phi_1275_;
                                                    let _e875 = phi_1276_;
                                                    let _e877 = phi_1277_;
                                                    phi_2372_ = _e542;
                                                    phi_1280_ = type_8(0u, 4u);
                                                    phi_1283_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                    loop {
                                                        let _e879 = phi_2372_;
                                                        let _e881 = phi_1280_;
                                                        let _e883 = phi_1283_;
                                                        local_20 = _e883;
                                                        if (_e881.member < _e881.member_1) {
                                                            phi_1281_ = type_8((_e881.member + 1u), _e881.member_1);
                                                            phi_1306_ = type_8(1u, _e881.member);
                                                        } else {
                                                            phi_1281_ = _e881;
                                                            phi_1306_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e896 = phi_1281_;
                                                        let _e898 = phi_1306_;
                                                        let _e902 = (bitcast<i32>(_e898.member) != 0i);
                                                        if _e902 {
                                                            let _e904 = ((_e898.member_1 & 1u) == 1u);
                                                            let _e906 = ((_e898.member_1 & 2u) == 2u);
                                                            let _e909 = (select(_e865, _e863, _e904) * select(_e853, _e851, _e906));
                                                            let _e915 = (((_e631.z + _e877) + select(_e873, _e871, _e904)) + select(_e861, _e859, _e906));
                                                            let _e920 = (2u * _e915);
                                                            if (_e920 < _e83) {
                                                            } else {
                                                                phi_2465_ = true;
                                                                break;
                                                            }
                                                            let _e923 = cells.member[_e920];
                                                            if (_e909 > 0f) {
                                                                let _e925 = (((_e875 | select(_e869, _e867, _e904)) | select(_e857, _e855, _e906)) & 31u);
                                                                if (((_e923 >> bitcast<u32>(_e925)) & 1u) == 1u) {
                                                                    let _e932 = params.member.member_8;
                                                                    let _e933 = (_e932 == 1u);
                                                                    if (_e613 == 0u) {
                                                                        let _e962 = (_e915 * 6u);
                                                                        let _e963 = (_e920 + 1u);
                                                                        if (_e963 < _e83) {
                                                                        } else {
                                                                            phi_2465_ = true;
                                                                            break;
                                                                        }
                                                                        let _e966 = cells.member[_e963];
                                                                        phi_1393_ = type_8(0u, 6u);
                                                                        phi_1396_ = _e966;
                                                                        loop {
                                                                            let _e968 = phi_1393_;
                                                                            let _e970 = phi_1396_;
                                                                            local = _e970;
                                                                            local_1 = _e970;
                                                                            local_8 = _e970;
                                                                            local_9 = _e970;
                                                                            if (_e968.member < _e968.member_1) {
                                                                                phi_1394_ = type_8((_e968.member + 1u), _e968.member_1);
                                                                                phi_1419_ = type_8(1u, _e968.member);
                                                                            } else {
                                                                                phi_1394_ = _e968;
                                                                                phi_1419_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e983 = phi_1394_;
                                                                            let _e985 = phi_1419_;
                                                                            let _e989 = (bitcast<i32>(_e985.member) != 0i);
                                                                            if _e989 {
                                                                                let _e990 = (_e962 + _e985.member_1);
                                                                                if (_e990 < _e86) {
                                                                                } else {
                                                                                    phi_2361_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e993 = facet_bits.member[_e990];
                                                                                phi_1397_ = (_e970 + countOneBits((_e993 & ((1u << bitcast<u32>(_e925)) - 1u))));
                                                                            } else {
                                                                                phi_1397_ = u32();
                                                                            }
                                                                            let _e1001 = phi_1397_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_1393_ = _e983;
                                                                                phi_1396_ = _e1001;
                                                                                phi_2361_ = _e879;
                                                                                break if !(_e989);
                                                                            }
                                                                        }
                                                                        let _e1004 = phi_2361_;
                                                                        phi_2465_ = _e1004;
                                                                        if _e1004 {
                                                                            break;
                                                                        }
                                                                        if (_e962 < _e86) {
                                                                        } else {
                                                                            phi_2465_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1007 = facet_bits.member[_e962];
                                                                        let _e1011 = (_e962 + 1u);
                                                                        if (_e1011 < _e86) {
                                                                        } else {
                                                                            phi_2465_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1014 = facet_bits.member[_e1011];
                                                                        let _e1019 = (_e962 + 2u);
                                                                        if (_e1019 < _e86) {
                                                                        } else {
                                                                            phi_2465_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1022 = facet_bits.member[_e1019];
                                                                        let _e1027 = (_e962 + 3u);
                                                                        if (_e1027 < _e86) {
                                                                        } else {
                                                                            phi_2465_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1030 = facet_bits.member[_e1027];
                                                                        let _e1035 = (_e962 + 4u);
                                                                        if (_e1035 < _e86) {
                                                                        } else {
                                                                            phi_2465_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1038 = facet_bits.member[_e1035];
                                                                        let _e1043 = (_e962 + 5u);
                                                                        if (_e1043 < _e86) {
                                                                        } else {
                                                                            phi_2465_ = true;
                                                                            break;
                                                                        }
                                                                        let _e1046 = facet_bits.member[_e1043];
                                                                        let _e1050 = (((((((_e1007 >> bitcast<u32>(_e925)) & 1u) + ((_e1014 >> bitcast<u32>(_e925)) & 1u)) + ((_e1022 >> bitcast<u32>(_e925)) & 1u)) + ((_e1030 >> bitcast<u32>(_e925)) & 1u)) + ((_e1038 >> bitcast<u32>(_e925)) & 1u)) + ((_e1046 >> bitcast<u32>(_e925)) & 1u));
                                                                        if _e933 {
                                                                            let _e1178 = local_8;
                                                                            let _e1181 = local_9;
                                                                            phi_1533_ = type_8(_e1181, (_e1178 + _e1050));
                                                                            phi_1536_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            loop {
                                                                                let _e1184 = phi_1533_;
                                                                                let _e1186 = phi_1536_;
                                                                                local_19 = _e1186;
                                                                                if (_e1184.member < _e1184.member_1) {
                                                                                    phi_1534_ = type_8((_e1184.member + 1u), _e1184.member_1);
                                                                                    phi_1559_ = type_8(1u, _e1184.member);
                                                                                } else {
                                                                                    phi_1534_ = _e1184;
                                                                                    phi_1559_ = type_8(0u, type_8().member_1);
                                                                                }
                                                                                let _e1199 = phi_1534_;
                                                                                let _e1201 = phi_1559_;
                                                                                let _e1205 = (bitcast<i32>(_e1201.member) != 0i);
                                                                                if _e1205 {
                                                                                    let _e1206 = (2u * _e1201.member_1);
                                                                                    if (_e1206 < _e92) {
                                                                                    } else {
                                                                                        phi_2458_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1210 = radiance.member[_e1206][0u];
                                                                                    let _e1213 = radiance.member[_e1206][1u];
                                                                                    let _e1216 = radiance.member[_e1206][2u];
                                                                                    let _e1217 = (_e1206 + 1u);
                                                                                    if (_e1217 < _e92) {
                                                                                    } else {
                                                                                        phi_2458_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1221 = radiance.member[_e1217][0u];
                                                                                    let _e1224 = radiance.member[_e1217][1u];
                                                                                    let _e1227 = radiance.member[_e1217][2u];
                                                                                    if (_e1201.member_1 < _e89) {
                                                                                    } else {
                                                                                        phi_2458_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1237 = facets.member[_e1201.member_1].member_2;
                                                                                    let _e1246 = sqrt((((_e1237[0] * _e1237[0]) + (_e1237[1] * _e1237[1])) + (_e1237[2] * _e1237[2])));
                                                                                    phi_1537_ = vec4<f32>((_e1186.x + (select(_e1221, _e1210, (_e1210 > _e1221)) * _e1246)), (_e1186.y + (select(_e1224, _e1213, (_e1213 > _e1224)) * _e1246)), (_e1186.z + (select(_e1227, _e1216, (_e1216 > _e1227)) * _e1246)), (_e1186.w + _e1246));
                                                                                } else {
                                                                                    phi_1537_ = vec4<f32>();
                                                                                }
                                                                                let _e1260 = phi_1537_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_1533_ = _e1199;
                                                                                    phi_1536_ = _e1260;
                                                                                    phi_2458_ = _e1004;
                                                                                    break if !(_e1205);
                                                                                }
                                                                            }
                                                                            let _e1263 = phi_2458_;
                                                                            phi_2465_ = _e1263;
                                                                            if _e1263 {
                                                                                break;
                                                                            }
                                                                            phi_2473_ = _e1263;
                                                                            let _e1852 = local_19;
                                                                            phi_1820_ = _e1852;
                                                                        } else {
                                                                            let _e1051 = select(1f, -1f, _e626);
                                                                            let _e1056 = local;
                                                                            let _e1059 = local_1;
                                                                            phi_1684_ = type_8(_e1059, (_e1056 + _e1050));
                                                                            phi_1687_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            phi_1689_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                            loop {
                                                                                let _e1062 = phi_1684_;
                                                                                let _e1064 = phi_1687_;
                                                                                let _e1066 = phi_1689_;
                                                                                local_2 = _e1064;
                                                                                local_3 = _e1066;
                                                                                local_4 = _e1064;
                                                                                local_5 = _e1064;
                                                                                local_6 = _e1064;
                                                                                local_7 = _e1066;
                                                                                local_18 = _e1066;
                                                                                if (_e1062.member < _e1062.member_1) {
                                                                                    phi_1685_ = type_8((_e1062.member + 1u), _e1062.member_1);
                                                                                    phi_1712_ = type_8(1u, _e1062.member);
                                                                                } else {
                                                                                    phi_1685_ = _e1062;
                                                                                    phi_1712_ = type_8(0u, type_8().member_1);
                                                                                }
                                                                                let _e1079 = phi_1685_;
                                                                                let _e1081 = phi_1712_;
                                                                                let _e1085 = (bitcast<i32>(_e1081.member) != 0i);
                                                                                if _e1085 {
                                                                                    if (_e1081.member_1 < _e89) {
                                                                                    } else {
                                                                                        phi_2449_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1089 = facets.member[_e1081.member_1].member_2;
                                                                                    let _e1098 = -((((select(0f, _e1051, _e588) * _e1089[0]) + (select(0f, _e1051, _e714) * _e1089[1])) + (select(0f, _e1051, _e781) * _e1089[2])));
                                                                                    if (_e1098 > 0f) {
                                                                                        let _e1120 = (2u * _e1081.member_1);
                                                                                        if (_e1120 < _e92) {
                                                                                        } else {
                                                                                            phi_2449_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e1123 = radiance.member[_e1120];
                                                                                        phi_1796_ = _e1064;
                                                                                        phi_1797_ = vec4<f32>((_e1066.x + (_e1123.x * _e1098)), (_e1066.y + (_e1123.y * _e1098)), (_e1066.z + (_e1123.z * _e1098)), (_e1066.w + _e1098));
                                                                                    } else {
                                                                                        let _e1101 = ((2u * _e1081.member_1) + 1u);
                                                                                        if (_e1101 < _e92) {
                                                                                        } else {
                                                                                            phi_2449_ = true;
                                                                                            break;
                                                                                        }
                                                                                        let _e1104 = radiance.member[_e1101];
                                                                                        phi_1796_ = vec4<f32>((_e1064.x - (_e1104.x * _e1098)), (_e1064.y - (_e1104.y * _e1098)), (_e1064.z - (_e1104.z * _e1098)), (_e1064.w - _e1098));
                                                                                        phi_1797_ = _e1066;
                                                                                    }
                                                                                    let _e1140 = phi_1796_;
                                                                                    let _e1142 = phi_1797_;
                                                                                    phi_1688_ = _e1140;
                                                                                    phi_1690_ = _e1142;
                                                                                } else {
                                                                                    phi_1688_ = vec4<f32>();
                                                                                    phi_1690_ = vec4<f32>();
                                                                                }
                                                                                let _e1144 = phi_1688_;
                                                                                let _e1146 = phi_1690_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_1684_ = _e1079;
                                                                                    phi_1687_ = _e1144;
                                                                                    phi_1689_ = _e1146;
                                                                                    phi_2449_ = _e1004;
                                                                                    break if !(_e1085);
                                                                                }
                                                                            }
                                                                            let _e1149 = phi_2449_;
                                                                            phi_2465_ = _e1149;
                                                                            if _e1149 {
                                                                                break;
                                                                            }
                                                                            let _e1151 = local_2;
                                                                            let _e1154 = local_3;
                                                                            if (_e1151.w > _e1154.w) {
                                                                                let _e1157 = (_e1151.w - _e1154.w);
                                                                                let _e1158 = (_e1157 / _e1151.w);
                                                                                let _e1160 = local_4;
                                                                                let _e1164 = local_5;
                                                                                let _e1168 = local_6;
                                                                                let _e1173 = local_7;
                                                                                phi_1819_ = (_e1173 + vec4<f32>((_e1160.x * _e1158), (_e1164.y * _e1158), (_e1168.z * _e1158), _e1157));
                                                                            } else {
                                                                                let _e1840 = local_18;
                                                                                phi_1819_ = _e1840;
                                                                            }
                                                                            let _e1176 = phi_1819_;
                                                                            phi_2473_ = _e1149;
                                                                            phi_1820_ = _e1176;
                                                                        }
                                                                        let _e1265 = phi_2473_;
                                                                        let _e1267 = phi_1820_;
                                                                        if (_e1267.w > 1f) {
                                                                            phi_1834_ = vec4<f32>((_e1267.x / _e1267.w), (_e1267.y / _e1267.w), (_e1267.z / _e1267.w), 1f);
                                                                        } else {
                                                                            phi_1834_ = _e1267;
                                                                        }
                                                                        let _e1278 = phi_1834_;
                                                                        phi_2469_ = _e1265;
                                                                        phi_1885_ = _e1278;
                                                                    } else {
                                                                        let _e935 = (_e920 + 1u);
                                                                        if (_e935 < _e83) {
                                                                        } else {
                                                                            phi_2465_ = true;
                                                                            break;
                                                                        }
                                                                        let _e938 = cells.member[_e935];
                                                                        let _e944 = (_e938 + countOneBits((_e923 & ((1u << bitcast<u32>(_e925)) - 1u))));
                                                                        if _e933 {
                                                                            phi_1860_ = _e944;
                                                                        } else {
                                                                            phi_1860_ = (((6u * _e944) + (2u * _e587)) + select(0u, 1u, _e626));
                                                                        }
                                                                        let _e951 = phi_1860_;
                                                                        if ((_e613 & 1u) == 1u) {
                                                                            if (_e951 < arrayLength((&odd.member))) {
                                                                            } else {
                                                                                phi_2465_ = true;
                                                                                break;
                                                                            }
                                                                            let _e959 = odd.member[_e951];
                                                                            phi_1884_ = _e959;
                                                                        } else {
                                                                            if (_e951 < arrayLength((&even.member))) {
                                                                            } else {
                                                                                phi_2465_ = true;
                                                                                break;
                                                                            }
                                                                            let _e956 = even.member[_e951];
                                                                            phi_1884_ = _e956;
                                                                        }
                                                                        let _e961 = phi_1884_;
                                                                        phi_2469_ = _e879;
                                                                        phi_1885_ = _e961;
                                                                    }
                                                                    let _e1280 = phi_2469_;
                                                                    let _e1282 = phi_1885_;
                                                                    phi_2468_ = _e1280;
                                                                    phi_1906_ = vec4<f32>((_e883.x + (_e1282.x * _e909)), (_e883.y + (_e1282.y * _e909)), (_e883.z + (_e1282.z * _e909)), (_e883.w + (_e1282.w * _e909)));
                                                                } else {
                                                                    phi_2468_ = _e879;
                                                                    phi_1906_ = _e883;
                                                                }
                                                                let _e1301 = phi_2468_;
                                                                let _e1303 = phi_1906_;
                                                                phi_2467_ = _e1301;
                                                                phi_1907_ = _e1303;
                                                            } else {
                                                                phi_2467_ = _e879;
                                                                phi_1907_ = _e883;
                                                            }
                                                            let _e1305 = phi_2467_;
                                                            let _e1307 = phi_1907_;
                                                            phi_2466_ = _e1305;
                                                            phi_1284_ = _e1307;
                                                        } else {
                                                            phi_2466_ = _e879;
                                                            phi_1284_ = vec4<f32>();
                                                        }
                                                        let _e1309 = phi_2466_;
                                                        let _e1311 = phi_1284_;
                                                        continue;
                                                        continuing {
                                                            phi_2372_ = _e1309;
                                                            phi_1280_ = _e896;
                                                            phi_1283_ = _e1311;
                                                            phi_2465_ = _e1309;
                                                            break if !(_e902);
                                                        }
                                                    }
                                                    let _e1314 = phi_2465_;
                                                    phi_2475_ = _e1314;
                                                    if _e1314 {
                                                        break;
                                                    }
                                                    phi_2494_ = _e1314;
                                                    let _e1866 = local_20;
                                                    phi_1908_ = _e1866;
                                                }
                                                let _e1316 = phi_2494_;
                                                let _e1318 = phi_1908_;
                                                phi_2493_ = _e1316;
                                                phi_1909_ = _e1318;
                                                phi_1910_ = _e653;
                                            }
                                            let _e1320 = phi_2493_;
                                            let _e1322 = phi_1909_;
                                            let _e1324 = phi_1910_;
                                            let _e1326 = select(_e1322, vec4<f32>(0f, 0f, 0f, 0f), vec4(_e1324));
                                            if (_e1326.w > 0f) {
                                                let _e1333 = select(_e617, _e1326.w, (_e1326.w < _e617));
                                                let _e1338 = ((_e556 * _e1333) / _e1326.w);
                                                phi_1954_ = vec3<f32>((_e546.x + (_e1326.x * _e1338)), (_e546.y + (_e1326.y * _e1338)), (_e546.z + (_e1326.z * _e1338)));
                                                phi_1955_ = (_e554 + _e1333);
                                                phi_1956_ = _e556;
                                            } else {
                                                let _e1329 = (_e587 == _e411);
                                                phi_1954_ = _e546;
                                                phi_1955_ = select(_e554, 0f, _e1329);
                                                phi_1956_ = select(_e556, _e618, _e1329);
                                            }
                                            let _e1351 = phi_1954_;
                                            let _e1353 = phi_1955_;
                                            let _e1355 = phi_1956_;
                                            let _e1356 = (_e373 * _e609);
                                            let _e1358 = ((_e376 * _e153) + ((_e376 * _e370.z) * _e609));
                                            let _e1360 = select(_e1358, _e1356, (_e1356 < _e1358));
                                            let _e1367 = ((bitcast<u32>((select(1f, _e1360, (_e1360 > 1f)) * _e368)) >> bitcast<u32>(23i)) - 127u);
                                            let _e1369 = (_e399.w - 1u);
                                            let _e1371 = select(_e1367, _e1369, (_e1369 < _e1367));
                                            if _e588 {
                                                let _e1532 = (_e552.member_1 < 0f);
                                                if _e1532 {
                                                    phi_1999_ = (_e552.member_3 - 1i);
                                                } else {
                                                    phi_1999_ = (_e552.member_3 + 1i);
                                                }
                                                let _e1540 = phi_1999_;
                                                let _e1546 = type_41(_e552.member, _e552.member_1, _e552.member_2, _e1540, _e552.member_4);
                                                if (((_e552.member_3 & 1i) == 0i) == _e1532) {
                                                    if (_e1371 > _e552.member_2) {
                                                        let _e1555 = type_41(_e1546.member, _e1546.member_1, (_e552.member_2 + 1u), _e1546.member_3, _e1546.member_4);
                                                        phi_2014_ = type_41(_e1555.member, _e1555.member_1, _e1555.member_2, (_e1540 >> bitcast<u32>(1i)), _e1555.member_4);
                                                    } else {
                                                        phi_2014_ = _e1546;
                                                    }
                                                    let _e1565 = phi_2014_;
                                                    phi_2015_ = _e1565;
                                                } else {
                                                    phi_2015_ = _e1546;
                                                }
                                                let _e1567 = phi_2015_;
                                                let _e1569 = (_e1567.member_2 & 31u);
                                                let _e1571 = (1u << bitcast<u32>(_e1569));
                                                if (_e1567.member_1 < 0f) {
                                                    phi_2034_ = (_e1567.member_3 < 0i);
                                                } else {
                                                    phi_2034_ = (_e1567.member_3 >= bitcast<i32>((((_e399.x + _e1571) - 1u) >> bitcast<u32>(_e1569))));
                                                }
                                                let _e1584 = phi_2034_;
                                                if _e1584 {
                                                    phi_2057_ = f32();
                                                    phi_2058_ = true;
                                                } else {
                                                    let _e1591 = (abs(_e1567.member_1) < 0.000001f);
                                                    if _e1591 {
                                                        phi_2056_ = f32();
                                                    } else {
                                                        phi_2056_ = ((((f32(_e1567.member_3) + 0.5f) * f32(_e1571)) - _e1567.member) / _e1567.member_1);
                                                    }
                                                    let _e1596 = phi_2056_;
                                                    phi_2057_ = _e1596;
                                                    phi_2058_ = _e1591;
                                                }
                                                let _e1598 = phi_2057_;
                                                let _e1600 = phi_2058_;
                                                phi_2228_ = _e548;
                                                phi_2229_ = _e550;
                                                phi_2230_ = type_41(_e1567.member, _e1567.member_1, _e1567.member_2, _e1567.member_3, select(_e1598, 340282350000000000000000000000000000000f, _e1600));
                                            } else {
                                                if (_e587 == 1u) {
                                                    let _e1451 = (_e550.member_1 < 0f);
                                                    if _e1451 {
                                                        phi_2082_ = (_e550.member_3 - 1i);
                                                    } else {
                                                        phi_2082_ = (_e550.member_3 + 1i);
                                                    }
                                                    let _e1459 = phi_2082_;
                                                    let _e1465 = type_41(_e550.member, _e550.member_1, _e550.member_2, _e1459, _e550.member_4);
                                                    if (((_e550.member_3 & 1i) == 0i) == _e1451) {
                                                        if (_e1371 > _e550.member_2) {
                                                            let _e1474 = type_41(_e1465.member, _e1465.member_1, (_e550.member_2 + 1u), _e1465.member_3, _e1465.member_4);
                                                            phi_2097_ = type_41(_e1474.member, _e1474.member_1, _e1474.member_2, (_e1459 >> bitcast<u32>(1i)), _e1474.member_4);
                                                        } else {
                                                            phi_2097_ = _e1465;
                                                        }
                                                        let _e1484 = phi_2097_;
                                                        phi_2098_ = _e1484;
                                                    } else {
                                                        phi_2098_ = _e1465;
                                                    }
                                                    let _e1486 = phi_2098_;
                                                    let _e1488 = (_e1486.member_2 & 31u);
                                                    let _e1490 = (1u << bitcast<u32>(_e1488));
                                                    if (_e1486.member_1 < 0f) {
                                                        phi_2117_ = (_e1486.member_3 < 0i);
                                                    } else {
                                                        phi_2117_ = (_e1486.member_3 >= bitcast<i32>((((_e399.y + _e1490) - 1u) >> bitcast<u32>(_e1488))));
                                                    }
                                                    let _e1503 = phi_2117_;
                                                    if _e1503 {
                                                        phi_2140_ = f32();
                                                        phi_2141_ = true;
                                                    } else {
                                                        let _e1510 = (abs(_e1486.member_1) < 0.000001f);
                                                        if _e1510 {
                                                            phi_2139_ = f32();
                                                        } else {
                                                            phi_2139_ = ((((f32(_e1486.member_3) + 0.5f) * f32(_e1490)) - _e1486.member) / _e1486.member_1);
                                                        }
                                                        let _e1515 = phi_2139_;
                                                        phi_2140_ = _e1515;
                                                        phi_2141_ = _e1510;
                                                    }
                                                    let _e1517 = phi_2140_;
                                                    let _e1519 = phi_2141_;
                                                    phi_2226_ = _e548;
                                                    phi_2227_ = type_41(_e1486.member, _e1486.member_1, _e1486.member_2, _e1486.member_3, select(_e1517, 340282350000000000000000000000000000000f, _e1519));
                                                } else {
                                                    let _e1374 = (_e548.member_1 < 0f);
                                                    if _e1374 {
                                                        phi_2161_ = (_e548.member_3 - 1i);
                                                    } else {
                                                        phi_2161_ = (_e548.member_3 + 1i);
                                                    }
                                                    let _e1382 = phi_2161_;
                                                    let _e1388 = type_41(_e548.member, _e548.member_1, _e548.member_2, _e1382, _e548.member_4);
                                                    if (((_e548.member_3 & 1i) == 0i) == _e1374) {
                                                        if (_e1371 > _e548.member_2) {
                                                            let _e1397 = type_41(_e1388.member, _e1388.member_1, (_e548.member_2 + 1u), _e1388.member_3, _e1388.member_4);
                                                            phi_2176_ = type_41(_e1397.member, _e1397.member_1, _e1397.member_2, (_e1382 >> bitcast<u32>(1i)), _e1397.member_4);
                                                        } else {
                                                            phi_2176_ = _e1388;
                                                        }
                                                        let _e1407 = phi_2176_;
                                                        phi_2177_ = _e1407;
                                                    } else {
                                                        phi_2177_ = _e1388;
                                                    }
                                                    let _e1409 = phi_2177_;
                                                    let _e1411 = (_e1409.member_2 & 31u);
                                                    let _e1413 = (1u << bitcast<u32>(_e1411));
                                                    if (_e1409.member_1 < 0f) {
                                                        phi_2196_ = (_e1409.member_3 < 0i);
                                                    } else {
                                                        phi_2196_ = (_e1409.member_3 >= bitcast<i32>((((_e399.z + _e1413) - 1u) >> bitcast<u32>(_e1411))));
                                                    }
                                                    let _e1426 = phi_2196_;
                                                    if _e1426 {
                                                        phi_2219_ = f32();
                                                        phi_2220_ = true;
                                                    } else {
                                                        let _e1433 = (abs(_e1409.member_1) < 0.000001f);
                                                        if _e1433 {
                                                            phi_2218_ = f32();
                                                        } else {
                                                            phi_2218_ = ((((f32(_e1409.member_3) + 0.5f) * f32(_e1413)) - _e1409.member) / _e1409.member_1);
                                                        }
                                                        let _e1438 = phi_2218_;
                                                        phi_2219_ = _e1438;
                                                        phi_2220_ = _e1433;
                                                    }
                                                    let _e1440 = phi_2219_;
                                                    let _e1442 = phi_2220_;
                                                    phi_2226_ = type_41(_e1409.member, _e1409.member_1, _e1409.member_2, _e1409.member_3, select(_e1440, 340282350000000000000000000000000000000f, _e1442));
                                                    phi_2227_ = _e550;
                                                }
                                                let _e1528 = phi_2226_;
                                                let _e1530 = phi_2227_;
                                                phi_2228_ = _e1528;
                                                phi_2229_ = _e1530;
                                                phi_2230_ = _e552;
                                            }
                                            let _e1609 = phi_2228_;
                                            let _e1611 = phi_2229_;
                                            let _e1613 = phi_2230_;
                                            phi_2478_ = _e1320;
                                            phi_2231_ = _e1351;
                                            phi_2232_ = _e1609;
                                            phi_2233_ = _e1611;
                                            phi_2234_ = _e1613;
                                            phi_2235_ = _e1353;
                                            phi_2236_ = _e1355;
                                        }
                                        let _e1615 = phi_2478_;
                                        let _e1617 = phi_2231_;
                                        let _e1619 = phi_2232_;
                                        let _e1621 = phi_2233_;
                                        let _e1623 = phi_2234_;
                                        let _e1625 = phi_2235_;
                                        let _e1627 = phi_2236_;
                                        phi_2477_ = _e1615;
                                        phi_2238_ = _e1617;
                                        phi_2239_ = _e1619;
                                        phi_2240_ = _e1621;
                                        phi_2241_ = _e1623;
                                        phi_2242_ = _e1625;
                                        phi_2243_ = _e1627;
                                        phi_2244_ = select(true, false, _e619);
                                    }
                                    let _e1630 = phi_2477_;
                                    let _e1632 = phi_2238_;
                                    let _e1634 = phi_2239_;
                                    let _e1636 = phi_2240_;
                                    let _e1638 = phi_2241_;
                                    let _e1640 = phi_2242_;
                                    let _e1642 = phi_2243_;
                                    let _e1644 = phi_2244_;
                                    phi_2476_ = _e1630;
                                    phi_776_ = _e1632;
                                    phi_778_ = _e1634;
                                    phi_780_ = _e1636;
                                    phi_782_ = _e1638;
                                    phi_784_ = _e1640;
                                    phi_786_ = _e1642;
                                    phi_2246_ = _e1644;
                                } else {
                                    phi_2476_ = _e542;
                                    phi_776_ = vec3<f32>();
                                    phi_778_ = type_41();
                                    phi_780_ = type_41();
                                    phi_782_ = type_41();
                                    phi_784_ = f32();
                                    phi_786_ = f32();
                                    phi_2246_ = false;
                                }
                                let _e1646 = phi_2476_;
                                let _e1648 = phi_776_;
                                let _e1650 = phi_778_;
                                let _e1652 = phi_780_;
                                let _e1654 = phi_782_;
                                let _e1656 = phi_784_;
                                let _e1658 = phi_786_;
                                let _e1660 = phi_2246_;
                                continue;
                                continuing {
                                    phi_2409_ = _e1646;
                                    phi_772_ = _e569;
                                    phi_775_ = _e1648;
                                    phi_777_ = _e1650;
                                    phi_779_ = _e1652;
                                    phi_781_ = _e1654;
                                    phi_783_ = _e1656;
                                    phi_785_ = _e1658;
                                    phi_2475_ = _e1646;
                                    break if !(_e1660);
                                }
                            }
                            let _e1663 = phi_2475_;
                            phi_2511_ = _e1663;
                            if _e1663 {
                                break;
                            }
                            let _e1665 = local_10;
                            let _e1668 = local_11;
                            let _e1669 = (_e1668 * (1f - _e1665));
                            let _e1671 = local_12;
                            let _e1674 = local_13;
                            let _e1677 = local_14;
                            let _e1681 = params.member.member_5;
                            phi_2512_ = _e1663;
                            phi_324_ = vec3<f32>((_e221.x + ((_e1671.x + (_e1681.x * _e1669)) * _e245.w)), (_e221.y + ((_e1674.y + (_e1681.y * _e1669)) * _e245.w)), (_e221.z + ((_e1677.z + (_e1681.z * _e1669)) * _e245.w)));
                        } else {
                            phi_2512_ = _e217;
                            phi_324_ = vec3<f32>();
                        }
                        let _e1703 = phi_2512_;
                        let _e1705 = phi_324_;
                        continue;
                        continuing {
                            phi_2433_ = _e1703;
                            phi_320_ = _e234;
                            phi_323_ = _e1705;
                            phi_2511_ = _e1703;
                            break if !(_e240);
                        }
                    }
                    let _e1708 = phi_2511_;
                    if _e1708 {
                        break;
                    }
                    let _e1710 = local_15;
                    let _e1714 = local_16;
                    let _e1718 = local_17;
                    phi_2292_ = vec4<f32>((_e1710.x * 3.1415927f), (_e1714.y * 3.1415927f), (_e1718.z * 3.1415927f), 0f);
                }
                let _e1723 = phi_2292_;
                if (_e109 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e109] = _e1723;
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
