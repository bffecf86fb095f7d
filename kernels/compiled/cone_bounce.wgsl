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

struct type_30 {
    member: array<vec4<f32>>,
}

struct type_35 {
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

struct type_36 {
    member: type_35,
}

struct type_38 {
    member: f32,
    member_1: f32,
    member_2: u32,
    member_3: i32,
    member_4: f32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_36;
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
var<storage, read_write> out: type_30;

fn function_() {
    var phi_191_: vec3<f32>;
    var phi_198_: vec3<f32>;
    var phi_301_: f32;
    var phi_2421_: bool;
    var phi_306_: type_8;
    var phi_309_: vec3<f32>;
    var phi_307_: type_8;
    var phi_332_: type_8;
    var phi_470_: f32;
    var phi_478_: f32;
    var phi_491_: f32;
    var phi_492_: vec3<f32>;
    var phi_539_: bool;
    var phi_548_: u32;
    var phi_580_: i32;
    var phi_594_: bool;
    var phi_611_: f32;
    var phi_612_: f32;
    var phi_613_: bool;
    var phi_650_: i32;
    var phi_664_: bool;
    var phi_681_: f32;
    var phi_682_: f32;
    var phi_683_: bool;
    var phi_720_: i32;
    var phi_734_: bool;
    var phi_751_: f32;
    var phi_752_: f32;
    var phi_753_: bool;
    var phi_2397_: bool;
    var phi_761_: type_8;
    var phi_764_: vec3<f32>;
    var phi_766_: type_38;
    var phi_768_: type_38;
    var phi_770_: type_38;
    var phi_772_: f32;
    var phi_774_: f32;
    var phi_762_: type_8;
    var phi_797_: type_8;
    var phi_817_: bool;
    var phi_828_: u32;
    var phi_849_: f32;
    var phi_850_: i32;
    var phi_851_: u32;
    var phi_852_: f32;
    var phi_853_: f32;
    var phi_854_: i32;
    var phi_855_: u32;
    var phi_856_: f32;
    var phi_912_: u32;
    var phi_929_: f32;
    var phi_950_: bool;
    var phi_962_: u32;
    var phi_973_: u32;
    var phi_981_: f32;
    var phi_1020_: f32;
    var phi_1031_: f32;
    var phi_1053_: bool;
    var phi_1065_: u32;
    var phi_1076_: u32;
    var phi_1084_: f32;
    var phi_1123_: f32;
    var phi_1134_: f32;
    var phi_1156_: bool;
    var phi_1168_: u32;
    var phi_1179_: u32;
    var phi_1187_: f32;
    var phi_1226_: f32;
    var phi_1253_: f32;
    var phi_1254_: f32;
    var phi_1255_: u32;
    var phi_1256_: u32;
    var phi_1257_: u32;
    var phi_1258_: u32;
    var phi_1259_: f32;
    var phi_1260_: f32;
    var phi_1261_: u32;
    var phi_1262_: u32;
    var phi_1263_: u32;
    var phi_1264_: u32;
    var phi_1265_: u32;
    var phi_1266_: u32;
    var phi_2360_: bool;
    var phi_1269_: type_8;
    var phi_1272_: vec4<f32>;
    var phi_1270_: type_8;
    var phi_1295_: type_8;
    var phi_1849_: u32;
    var phi_1873_: vec4<f32>;
    var phi_1382_: type_8;
    var phi_1385_: u32;
    var phi_1383_: type_8;
    var phi_1408_: type_8;
    var phi_1386_: u32;
    var phi_2349_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1673_: type_8;
    var phi_1676_: vec4<f32>;
    var phi_1678_: vec4<f32>;
    var phi_1674_: type_8;
    var phi_1701_: type_8;
    var phi_1785_: vec4<f32>;
    var phi_1786_: vec4<f32>;
    var phi_1677_: vec4<f32>;
    var phi_1679_: vec4<f32>;
    var phi_2439_: bool;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_1808_: vec4<f32>;
    var local_8: u32;
    var local_9: u32;
    var phi_1522_: type_8;
    var phi_1525_: vec4<f32>;
    var phi_1523_: type_8;
    var phi_1548_: type_8;
    var phi_1526_: vec4<f32>;
    var phi_2448_: bool;
    var phi_2463_: bool;
    var phi_1809_: vec4<f32>;
    var phi_1823_: vec4<f32>;
    var phi_2459_: bool;
    var phi_1874_: vec4<f32>;
    var phi_2458_: bool;
    var phi_1895_: vec4<f32>;
    var phi_2457_: bool;
    var phi_1896_: vec4<f32>;
    var phi_2456_: bool;
    var phi_1273_: vec4<f32>;
    var phi_2455_: bool;
    var phi_2484_: bool;
    var phi_1897_: vec4<f32>;
    var phi_2483_: bool;
    var phi_1898_: vec4<f32>;
    var phi_1899_: bool;
    var phi_1943_: vec3<f32>;
    var phi_1944_: f32;
    var phi_1945_: f32;
    var phi_2150_: i32;
    var phi_2165_: type_38;
    var phi_2166_: type_38;
    var phi_2185_: bool;
    var phi_2207_: f32;
    var phi_2208_: f32;
    var phi_2209_: bool;
    var phi_2071_: i32;
    var phi_2086_: type_38;
    var phi_2087_: type_38;
    var phi_2106_: bool;
    var phi_2128_: f32;
    var phi_2129_: f32;
    var phi_2130_: bool;
    var phi_2215_: type_38;
    var phi_2216_: type_38;
    var phi_1988_: i32;
    var phi_2003_: type_38;
    var phi_2004_: type_38;
    var phi_2023_: bool;
    var phi_2045_: f32;
    var phi_2046_: f32;
    var phi_2047_: bool;
    var phi_2217_: type_38;
    var phi_2218_: type_38;
    var phi_2219_: type_38;
    var phi_2468_: bool;
    var phi_2220_: vec3<f32>;
    var phi_2221_: type_38;
    var phi_2222_: type_38;
    var phi_2223_: type_38;
    var phi_2224_: f32;
    var phi_2225_: f32;
    var phi_2467_: bool;
    var phi_2227_: vec3<f32>;
    var phi_2228_: type_38;
    var phi_2229_: type_38;
    var phi_2230_: type_38;
    var phi_2231_: f32;
    var phi_2232_: f32;
    var phi_2233_: bool;
    var phi_2466_: bool;
    var phi_765_: vec3<f32>;
    var phi_767_: type_38;
    var phi_769_: type_38;
    var phi_771_: type_38;
    var phi_773_: f32;
    var phi_775_: f32;
    var phi_2235_: bool;
    var phi_2465_: bool;
    var local_10: f32;
    var local_11: f32;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: vec3<f32>;
    var phi_2502_: bool;
    var phi_310_: vec3<f32>;
    var phi_2501_: bool;
    var local_15: vec3<f32>;
    var local_16: vec3<f32>;
    var local_17: vec3<f32>;
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
            let _e103 = params.member.member_9;
            let _e107 = (_e80.x + (_e80.y * 2097152u));
            if (_e107 < _e103) {
                let _e109 = (_e107 / 2u);
                if (_e109 < _e89) {
                } else {
                    break;
                }
                let _e113 = facets.member[_e109];
                let _e123 = sqrt((((_e113.member_2[0] * _e113.member_2[0]) + (_e113.member_2[1] * _e113.member_2[1])) + (_e113.member_2[2] * _e113.member_2[2])));
                if (_e123 > 0.000000000001f) {
                    phi_191_ = vec3<f32>((_e113.member_2[0] / _e123), (_e113.member_2[1] / _e123), (_e113.member_2[2] / _e123));
                } else {
                    phi_191_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e130 = phi_191_;
                if ((_e107 & 1u) == 0u) {
                    phi_198_ = _e130;
                } else {
                    phi_198_ = -(_e130);
                }
                let _e135 = phi_198_;
                let _e142 = params.member.member;
                let _e155 = params.member.member_12;
                let _e162 = (((_e113.member[0] - _e142.x) / _e142.w) + (_e135.x * _e155));
                let _e163 = (((_e113.member[1] - _e142.y) / _e142.w) + (_e135.y * _e155));
                let _e164 = (((_e113.member[2] - _e142.z) / _e142.w) + (_e135.z * _e155));
                let _e168 = bitcast<f32>((1065353216u | (bitcast<u32>(_e135.z) & 2147483648u)));
                let _e170 = (-1f / (_e168 + _e135.z));
                let _e172 = ((_e135.x * _e135.y) * _e170);
                let _e186 = params.member.member_10;
                let _e187 = (_e186 == 0u);
                if _e187 {
                    phi_301_ = 0f;
                } else {
                    let _e191 = ((_e107 * 1664525u) + 1013904223u);
                    let _e193 = (((_e186 * 1664525u) + 1013904223u) + (_e191 * 1013904223u));
                    let _e195 = (_e191 + (1013904223u * _e193));
                    let _e199 = (1013904223u + (_e195 * (1013904223u + (_e193 * _e195))));
                    phi_301_ = (f32((((_e193 ^ (_e193 >> bitcast<u32>(16i))) + ((_e195 ^ (_e195 >> bitcast<u32>(16i))) * (_e199 ^ (_e199 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                }
                let _e216 = phi_301_;
                let _e219 = params.member.member_7;
                phi_2421_ = false;
                phi_306_ = type_8(0u, _e219);
                phi_309_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e222 = phi_2421_;
                    let _e224 = phi_306_;
                    let _e226 = phi_309_;
                    local_15 = _e226;
                    local_16 = _e226;
                    local_17 = _e226;
                    if (_e224.member < _e224.member_1) {
                        phi_307_ = type_8((_e224.member + 1u), _e224.member_1);
                        phi_332_ = type_8(1u, _e224.member);
                    } else {
                        phi_307_ = _e224;
                        phi_332_ = type_8(0u, type_8().member_1);
                    }
                    let _e239 = phi_307_;
                    let _e241 = phi_332_;
                    let _e245 = (bitcast<i32>(_e241.member) != 0i);
                    if _e245 {
                        let _e246 = (_e241.member_1 < 16u);
                        if _e246 {
                        } else {
                            phi_2501_ = true;
                            break;
                        }
                        let _e250 = params.member.member_3[_e241.member_1];
                        if _e187 {
                            phi_491_ = 1.4142135f;
                            phi_492_ = vec3<f32>(_e250.x, _e250.y, _e250.z);
                        } else {
                            let _e255 = ((_e107 * 1664525u) + 1013904223u);
                            let _e257 = (((1u + _e241.member_1) * 1664525u) + 1013904223u);
                            let _e259 = (((_e186 * 1664525u) + 1013904223u) + (_e255 * 1013904223u));
                            let _e261 = (_e255 + (_e257 * _e259));
                            let _e263 = (_e257 + (_e259 * _e261));
                            let _e265 = (1013904223u + (_e261 * _e263));
                            let _e271 = (_e261 ^ (_e261 >> bitcast<u32>(16i)));
                            let _e274 = (_e263 ^ (_e263 >> bitcast<u32>(16i)));
                            let _e279 = ((_e259 ^ (_e259 >> bitcast<u32>(16i))) + (_e271 * (_e265 ^ (_e265 >> bitcast<u32>(16i)))));
                            let _e281 = (_e271 + (_e274 * _e279));
                            if _e246 {
                            } else {
                                phi_2501_ = true;
                                break;
                            }
                            let _e299 = params.member.member_4[_e241.member_1];
                            let _e304 = (_e299.y + ((_e299.x - _e299.y) * (f32((_e279 >> bitcast<u32>(8i))) * 0.000000059604645f)));
                            let _e309 = ((_e299.z + (_e299.w * (f32((_e281 >> bitcast<u32>(8i))) * 0.000000059604645f))) + _e216);
                            let _e313 = floor(((_e309 * 4f) + 0.5f));
                            let _e319 = ((((6.2831855f * _e309) - (_e313 * 1.5703125f)) - (_e313 * 0.0004837513f)) - (_e313 * 0.0000000754979f));
                            let _e320 = (_e319 * _e319);
                            let _e327 = (_e319 + ((_e319 * _e320) * (-0.16666655f + (_e320 * (0.008332161f + (_e320 * -0.00019515296f))))));
                            let _e336 = ((1f - (0.5f * _e320)) + ((_e320 * _e320) * (0.041666646f + (_e320 * (-0.0013887316f + (_e320 * 0.000024433157f))))));
                            let _e343 = select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < -2147483600f)), 2147483647i, (_e313 > 2147483500f)), (_e313 == _e313));
                            let _e345 = ((_e343 & 1i) == 0i);
                            let _e346 = select(_e336, _e327, _e345);
                            let _e347 = select(_e327, _e336, _e345);
                            if ((_e343 & 2i) == 0i) {
                                phi_470_ = _e346;
                            } else {
                                phi_470_ = -(_e346);
                            }
                            let _e352 = phi_470_;
                            if (((_e343 + 1i) & 2i) == 0i) {
                                phi_478_ = _e347;
                            } else {
                                phi_478_ = -(_e347);
                            }
                            let _e358 = phi_478_;
                            let _e359 = (1f - _e304);
                            let _e362 = sqrt(select(0f, _e359, (_e359 > 0f)));
                            phi_491_ = (1f + (f32(((_e274 + (_e279 * _e281)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                            phi_492_ = vec3<f32>((_e362 * _e358), (_e362 * _e352), sqrt(_e304));
                        }
                        let _e373 = phi_491_;
                        let _e375 = phi_492_;
                        let _e378 = params.member.member_11;
                        let _e381 = params.member.member_13;
                        let _e399 = ((((1f + (((_e168 * _e135.x) * _e135.x) * _e170)) * _e375.x) + (_e172 * _e375.y)) + (_e135.x * _e375.z));
                        let _e400 = ((((_e168 * _e172) * _e375.x) + ((_e168 + ((_e135.y * _e135.y) * _e170)) * _e375.y)) + (_e135.y * _e375.z));
                        let _e401 = ((((-(_e168) * _e135.x) * _e375.x) + (-(_e135.y) * _e375.y)) + (_e135.z * _e375.z));
                        let _e404 = params.member.member_1;
                        let _e405 = abs(_e399);
                        let _e406 = abs(_e400);
                        let _e407 = abs(_e401);
                        if (_e405 >= _e406) {
                            phi_539_ = select(true, false, (_e405 >= _e407));
                        } else {
                            phi_539_ = true;
                        }
                        let _e412 = phi_539_;
                        if _e412 {
                            phi_548_ = select(2u, 1u, (_e406 >= _e407));
                        } else {
                            phi_548_ = 0u;
                        }
                        let _e416 = phi_548_;
                        let _e419 = floor((_e162 - 0.5f));
                        let _e429 = -(floor((0.5f - _e162)));
                        let _e437 = (_e399 < 0f);
                        if _e437 {
                            phi_580_ = (select(0i, select(select(i32(_e429), i32(-2147483648), (_e429 < -2147483600f)), 2147483647i, (_e429 > 2147483500f)), (_e429 == _e429)) - 1i);
                        } else {
                            phi_580_ = (select(0i, select(select(i32(_e419), i32(-2147483648), (_e419 < -2147483600f)), 2147483647i, (_e419 > 2147483500f)), (_e419 == _e419)) + 1i);
                        }
                        let _e441 = phi_580_;
                        if _e437 {
                            phi_594_ = (_e441 < 0i);
                        } else {
                            phi_594_ = (_e441 >= bitcast<i32>(_e404.x));
                        }
                        let _e446 = phi_594_;
                        if _e446 {
                            phi_612_ = f32();
                            phi_613_ = true;
                        } else {
                            let _e449 = (_e405 < 0.000001f);
                            if _e449 {
                                phi_611_ = f32();
                            } else {
                                phi_611_ = (((f32(_e441) + 0.5f) - _e162) / _e399);
                            }
                            let _e453 = phi_611_;
                            phi_612_ = _e453;
                            phi_613_ = _e449;
                        }
                        let _e455 = phi_612_;
                        let _e457 = phi_613_;
                        let _e462 = floor((_e163 - 0.5f));
                        let _e472 = -(floor((0.5f - _e163)));
                        let _e480 = (_e400 < 0f);
                        if _e480 {
                            phi_650_ = (select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < -2147483600f)), 2147483647i, (_e472 > 2147483500f)), (_e472 == _e472)) - 1i);
                        } else {
                            phi_650_ = (select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < -2147483600f)), 2147483647i, (_e462 > 2147483500f)), (_e462 == _e462)) + 1i);
                        }
                        let _e484 = phi_650_;
                        if _e480 {
                            phi_664_ = (_e484 < 0i);
                        } else {
                            phi_664_ = (_e484 >= bitcast<i32>(_e404.y));
                        }
                        let _e489 = phi_664_;
                        if _e489 {
                            phi_682_ = f32();
                            phi_683_ = true;
                        } else {
                            let _e492 = (_e406 < 0.000001f);
                            if _e492 {
                                phi_681_ = f32();
                            } else {
                                phi_681_ = (((f32(_e484) + 0.5f) - _e163) / _e400);
                            }
                            let _e496 = phi_681_;
                            phi_682_ = _e496;
                            phi_683_ = _e492;
                        }
                        let _e498 = phi_682_;
                        let _e500 = phi_683_;
                        let _e505 = floor((_e164 - 0.5f));
                        let _e515 = -(floor((0.5f - _e164)));
                        let _e523 = (_e401 < 0f);
                        if _e523 {
                            phi_720_ = (select(0i, select(select(i32(_e515), i32(-2147483648), (_e515 < -2147483600f)), 2147483647i, (_e515 > 2147483500f)), (_e515 == _e515)) - 1i);
                        } else {
                            phi_720_ = (select(0i, select(select(i32(_e505), i32(-2147483648), (_e505 < -2147483600f)), 2147483647i, (_e505 > 2147483500f)), (_e505 == _e505)) + 1i);
                        }
                        let _e527 = phi_720_;
                        if _e523 {
                            phi_734_ = (_e527 < 0i);
                        } else {
                            phi_734_ = (_e527 >= bitcast<i32>(_e404.z));
                        }
                        let _e532 = phi_734_;
                        if _e532 {
                            phi_752_ = f32();
                            phi_753_ = true;
                        } else {
                            let _e535 = (_e407 < 0.000001f);
                            if _e535 {
                                phi_751_ = f32();
                            } else {
                                phi_751_ = (((f32(_e527) + 0.5f) - _e164) / _e401);
                            }
                            let _e539 = phi_751_;
                            phi_752_ = _e539;
                            phi_753_ = _e535;
                        }
                        let _e541 = phi_752_;
                        let _e543 = phi_753_;
                        phi_2397_ = _e222;
                        phi_761_ = type_8(0u, 2048u);
                        phi_764_ = vec3<f32>(0f, 0f, 0f);
                        phi_766_ = type_38(_e164, _e401, 0u, _e527, select(_e541, 340282350000000000000000000000000000000f, _e543));
                        phi_768_ = type_38(_e163, _e400, 0u, _e484, select(_e498, 340282350000000000000000000000000000000f, _e500));
                        phi_770_ = type_38(_e162, _e399, 0u, _e441, select(_e455, 340282350000000000000000000000000000000f, _e457));
                        phi_772_ = 0f;
                        phi_774_ = 1f;
                        loop {
                            let _e547 = phi_2397_;
                            let _e549 = phi_761_;
                            let _e551 = phi_764_;
                            let _e553 = phi_766_;
                            let _e555 = phi_768_;
                            let _e557 = phi_770_;
                            let _e559 = phi_772_;
                            let _e561 = phi_774_;
                            local_10 = _e559;
                            local_11 = _e561;
                            local_12 = _e551;
                            local_13 = _e551;
                            local_14 = _e551;
                            if (_e549.member < _e549.member_1) {
                                phi_762_ = type_8((_e549.member + 1u), _e549.member_1);
                                phi_797_ = type_8(1u, _e549.member);
                            } else {
                                phi_762_ = _e549;
                                phi_797_ = type_8(0u, type_8().member_1);
                            }
                            let _e574 = phi_762_;
                            let _e576 = phi_797_;
                            if (bitcast<i32>(_e576.member) != 0i) {
                                if (_e557.member_4 <= _e555.member_4) {
                                    phi_817_ = select(true, false, (_e557.member_4 <= _e553.member_4));
                                } else {
                                    phi_817_ = true;
                                }
                                let _e587 = phi_817_;
                                if _e587 {
                                    phi_828_ = select(2u, 1u, (_e555.member_4 <= _e553.member_4));
                                } else {
                                    phi_828_ = 0u;
                                }
                                let _e592 = phi_828_;
                                let _e593 = (_e592 == 0u);
                                if _e593 {
                                    phi_853_ = _e557.member_4;
                                    phi_854_ = _e557.member_3;
                                    phi_855_ = _e557.member_2;
                                    phi_856_ = _e557.member_1;
                                } else {
                                    if (_e592 == 1u) {
                                        phi_849_ = _e555.member_4;
                                        phi_850_ = _e555.member_3;
                                        phi_851_ = _e555.member_2;
                                        phi_852_ = _e555.member_1;
                                    } else {
                                        phi_849_ = _e553.member_4;
                                        phi_850_ = _e553.member_3;
                                        phi_851_ = _e553.member_2;
                                        phi_852_ = _e553.member_1;
                                    }
                                    let _e603 = phi_849_;
                                    let _e605 = phi_850_;
                                    let _e607 = phi_851_;
                                    let _e609 = phi_852_;
                                    phi_853_ = _e603;
                                    phi_854_ = _e605;
                                    phi_855_ = _e607;
                                    phi_856_ = _e609;
                                }
                                let _e614 = phi_853_;
                                let _e616 = phi_854_;
                                let _e618 = phi_855_;
                                let _e620 = phi_856_;
                                if (_e614 >= 340282350000000000000000000000000000000f) {
                                    phi_2467_ = _e547;
                                    phi_2227_ = vec3<f32>();
                                    phi_2228_ = type_38();
                                    phi_2229_ = type_38();
                                    phi_2230_ = type_38();
                                    phi_2231_ = f32();
                                    phi_2232_ = f32();
                                    phi_2233_ = false;
                                } else {
                                    let _e622 = (1f - _e559);
                                    let _e623 = (_e561 * _e622);
                                    let _e624 = (_e623 < 0.001f);
                                    if _e624 {
                                        phi_2468_ = _e547;
                                        phi_2220_ = vec3<f32>();
                                        phi_2221_ = type_38();
                                        phi_2222_ = type_38();
                                        phi_2223_ = type_38();
                                        phi_2224_ = f32();
                                        phi_2225_ = f32();
                                    } else {
                                        let _e631 = (_e620 < 0f);
                                        if (_e618 < 10u) {
                                        } else {
                                            phi_2465_ = true;
                                            break;
                                        }
                                        let _e636 = params.member.member_2[_e618];
                                        let _e637 = (_e618 & 31u);
                                        let _e639 = (1u << bitcast<u32>(_e637));
                                        let _e640 = (_e639 - 1u);
                                        let _e643 = ((_e404.x + _e640) >> bitcast<u32>(_e637));
                                        let _e646 = ((_e404.y + _e640) >> bitcast<u32>(_e637));
                                        let _e649 = ((_e404.z + _e640) >> bitcast<u32>(_e637));
                                        let _e651 = (1f / f32(_e639));
                                        if _e593 {
                                            phi_912_ = _e643;
                                        } else {
                                            phi_912_ = select(_e649, _e646, (_e592 == 1u));
                                        }
                                        let _e655 = phi_912_;
                                        if (_e616 < 0i) {
                                            phi_2483_ = _e547;
                                            phi_1898_ = vec4<f32>();
                                            phi_1899_ = true;
                                        } else {
                                            let _e658 = (_e616 >= bitcast<i32>(_e655));
                                            if _e658 {
                                                phi_2484_ = _e547;
                                                phi_1897_ = vec4<f32>();
                                            } else {
                                                let _e659 = f32(_e616);
                                                if _e593 {
                                                    phi_929_ = _e659;
                                                } else {
                                                    phi_929_ = (((_e162 + (_e399 * _e614)) * _e651) - 0.5f);
                                                }
                                                let _e663 = phi_929_;
                                                let _e664 = floor(_e663);
                                                let _e672 = select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < -2147483600f)), 2147483647i, (_e664 > 2147483500f)), (_e664 == _e664));
                                                let _e674 = (bitcast<i32>(_e643) - 1i);
                                                if (_e663 >= -0.5f) {
                                                    phi_950_ = (_e663 <= (f32(_e674) + 0.5f));
                                                } else {
                                                    phi_950_ = false;
                                                }
                                                let _e680 = phi_950_;
                                                let _e681 = (_e672 >= 0i);
                                                let _e682 = (_e672 < _e674);
                                                if _e681 {
                                                    phi_962_ = bitcast<u32>(select(_e672, _e674, (_e674 < _e672)));
                                                } else {
                                                    phi_962_ = 0u;
                                                }
                                                let _e687 = phi_962_;
                                                if _e682 {
                                                    let _e688 = (_e672 + 1i);
                                                    phi_973_ = bitcast<u32>(select(0i, _e688, (0i < _e688)));
                                                } else {
                                                    phi_973_ = 0u;
                                                }
                                                let _e693 = phi_973_;
                                                if _e681 {
                                                    phi_981_ = select(0f, (_e663 - _e664), _e682);
                                                } else {
                                                    phi_981_ = 1f;
                                                }
                                                let _e696 = phi_981_;
                                                let _e698 = (_e687 >> bitcast<u32>(2u));
                                                let _e700 = (_e693 >> bitcast<u32>(2u));
                                                let _e707 = ((_e687 & 1u) | (((_e687 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                                let _e714 = ((_e693 & 1u) | (((_e693 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                                if _e680 {
                                                    phi_1020_ = (1f - _e696);
                                                } else {
                                                    phi_1020_ = 0f;
                                                }
                                                let _e717 = phi_1020_;
                                                let _e718 = select(0f, _e696, _e680);
                                                let _e719 = (_e592 == 1u);
                                                if _e719 {
                                                    phi_1031_ = _e659;
                                                } else {
                                                    phi_1031_ = (((_e163 + (_e400 * _e614)) * _e651) - 0.5f);
                                                }
                                                let _e723 = phi_1031_;
                                                let _e725 = floor(_e723);
                                                let _e733 = select(0i, select(select(i32(_e725), i32(-2147483648), (_e725 < -2147483600f)), 2147483647i, (_e725 > 2147483500f)), (_e725 == _e725));
                                                let _e735 = (bitcast<i32>(_e646) - 1i);
                                                if (_e723 >= -0.5f) {
                                                    phi_1053_ = (_e723 <= (f32(_e735) + 0.5f));
                                                } else {
                                                    phi_1053_ = false;
                                                }
                                                let _e741 = phi_1053_;
                                                let _e742 = (_e733 >= 0i);
                                                let _e743 = (_e733 < _e735);
                                                if _e742 {
                                                    phi_1065_ = bitcast<u32>(select(_e733, _e735, (_e735 < _e733)));
                                                } else {
                                                    phi_1065_ = 0u;
                                                }
                                                let _e748 = phi_1065_;
                                                if _e743 {
                                                    let _e749 = (_e733 + 1i);
                                                    phi_1076_ = bitcast<u32>(select(0i, _e749, (0i < _e749)));
                                                } else {
                                                    phi_1076_ = 0u;
                                                }
                                                let _e754 = phi_1076_;
                                                if _e742 {
                                                    phi_1084_ = select(0f, (_e723 - _e725), _e743);
                                                } else {
                                                    phi_1084_ = 1f;
                                                }
                                                let _e757 = phi_1084_;
                                                let _e760 = ((_e748 >> bitcast<u32>(2u)) * _e636.x);
                                                let _e763 = ((_e754 >> bitcast<u32>(2u)) * _e636.x);
                                                let _e772 = (((_e748 & 1u) << bitcast<u32>(1u)) | (((_e748 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                                let _e781 = (((_e754 & 1u) << bitcast<u32>(1u)) | (((_e754 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                                if _e741 {
                                                    phi_1123_ = (1f - _e757);
                                                } else {
                                                    phi_1123_ = 0f;
                                                }
                                                let _e784 = phi_1123_;
                                                let _e785 = select(0f, _e757, _e741);
                                                let _e786 = (_e592 == 2u);
                                                if _e786 {
                                                    phi_1134_ = _e659;
                                                } else {
                                                    phi_1134_ = (((_e164 + (_e401 * _e614)) * _e651) - 0.5f);
                                                }
                                                let _e790 = phi_1134_;
                                                let _e792 = floor(_e790);
                                                let _e800 = select(0i, select(select(i32(_e792), i32(-2147483648), (_e792 < -2147483600f)), 2147483647i, (_e792 > 2147483500f)), (_e792 == _e792));
                                                let _e802 = (bitcast<i32>(_e649) - 1i);
                                                if (_e790 >= -0.5f) {
                                                    phi_1156_ = (_e790 <= (f32(_e802) + 0.5f));
                                                } else {
                                                    phi_1156_ = false;
                                                }
                                                let _e808 = phi_1156_;
                                                let _e809 = (_e800 >= 0i);
                                                let _e810 = (_e800 < _e802);
                                                if _e809 {
                                                    phi_1168_ = bitcast<u32>(select(_e800, _e802, (_e802 < _e800)));
                                                } else {
                                                    phi_1168_ = 0u;
                                                }
                                                let _e815 = phi_1168_;
                                                if _e810 {
                                                    let _e816 = (_e800 + 1i);
                                                    phi_1179_ = bitcast<u32>(select(0i, _e816, (0i < _e816)));
                                                } else {
                                                    phi_1179_ = 0u;
                                                }
                                                let _e821 = phi_1179_;
                                                if _e809 {
                                                    phi_1187_ = select(0f, (_e790 - _e792), _e810);
                                                } else {
                                                    phi_1187_ = 1f;
                                                }
                                                let _e824 = phi_1187_;
                                                let _e827 = ((_e815 >> bitcast<u32>(1u)) * _e636.y);
                                                let _e830 = ((_e821 >> bitcast<u32>(1u)) * _e636.y);
                                                let _e833 = ((_e815 & 1u) << bitcast<u32>(2u));
                                                let _e836 = ((_e821 & 1u) << bitcast<u32>(2u));
                                                if _e808 {
                                                    phi_1226_ = (1f - _e824);
                                                } else {
                                                    phi_1226_ = 0f;
                                                }
                                                let _e839 = phi_1226_;
                                                let _e840 = select(0f, _e824, _e808);
                                                if _e593 {
                                                    phi_1253_ = _e840;
                                                    phi_1254_ = _e839;
                                                    phi_1255_ = _e836;
                                                    phi_1256_ = _e833;
                                                    phi_1257_ = _e830;
                                                    phi_1258_ = _e827;
                                                    phi_1259_ = _e785;
                                                    phi_1260_ = _e784;
                                                    phi_1261_ = _e781;
                                                    phi_1262_ = _e772;
                                                    phi_1263_ = _e763;
                                                    phi_1264_ = _e760;
                                                    phi_1265_ = _e707;
                                                    phi_1266_ = _e698;
                                                } else {
                                                    phi_1253_ = select(_e785, _e718, _e719);
                                                    phi_1254_ = select(_e784, _e717, _e719);
                                                    phi_1255_ = select(_e781, _e714, _e719);
                                                    phi_1256_ = select(_e772, _e707, _e719);
                                                    phi_1257_ = select(_e763, _e700, _e719);
                                                    phi_1258_ = select(_e760, _e698, _e719);
                                                    phi_1259_ = select(_e718, _e840, _e719);
                                                    phi_1260_ = select(_e717, _e839, _e719);
                                                    phi_1261_ = select(_e714, _e836, _e719);
                                                    phi_1262_ = select(_e707, _e833, _e719);
                                                    phi_1263_ = select(_e700, _e830, _e719);
                                                    phi_1264_ = select(_e698, _e827, _e719);
                                                    phi_1265_ = select(_e833, _e772, _e719);
                                                    phi_1266_ = select(_e827, _e760, _e719);
                                                }
                                                let _e856 = phi_1253_;
                                                let _e858 = phi_1254_;
                                                let _e860 = phi_1255_;
                                                let _e862 = phi_1256_;
                                                let _e864 = phi_1257_;
                                                let _e866 = phi_1258_;
                                                let _e868 = phi_1259_;
                                                let _e870 = phi_1260_;
                                                let _e872 = phi_1261_;
                                                let _e874 = phi_1262_;
                                                let _e876 = phi_1263_;
                                                let _e878 = phi_1264_;
                                                let _e880 = phi_1265_;
                                                let _e882 = phi_1266_;
                                                phi_2360_ = _e547;
                                                phi_1269_ = type_8(0u, 4u);
                                                phi_1272_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                loop {
                                                    let _e884 = phi_2360_;
                                                    let _e886 = phi_1269_;
                                                    let _e888 = phi_1272_;
                                                    local_20 = _e888;
                                                    if (_e886.member < _e886.member_1) {
                                                        phi_1270_ = type_8((_e886.member + 1u), _e886.member_1);
                                                        phi_1295_ = type_8(1u, _e886.member);
                                                    } else {
                                                        phi_1270_ = _e886;
                                                        phi_1295_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e901 = phi_1270_;
                                                    let _e903 = phi_1295_;
                                                    let _e907 = (bitcast<i32>(_e903.member) != 0i);
                                                    if _e907 {
                                                        let _e909 = ((_e903.member_1 & 1u) == 1u);
                                                        let _e911 = ((_e903.member_1 & 2u) == 2u);
                                                        let _e914 = (select(_e870, _e868, _e909) * select(_e858, _e856, _e911));
                                                        let _e920 = (((_e636.z + _e882) + select(_e878, _e876, _e909)) + select(_e866, _e864, _e911));
                                                        let _e925 = (2u * _e920);
                                                        if (_e925 < _e83) {
                                                        } else {
                                                            phi_2455_ = true;
                                                            break;
                                                        }
                                                        let _e928 = cells.member[_e925];
                                                        if (_e914 > 0f) {
                                                            let _e930 = (((_e880 | select(_e874, _e872, _e909)) | select(_e862, _e860, _e911)) & 31u);
                                                            if (((_e928 >> bitcast<u32>(_e930)) & 1u) == 1u) {
                                                                let _e937 = params.member.member_8;
                                                                let _e938 = (_e937 == 1u);
                                                                if (_e618 == 0u) {
                                                                    let _e967 = (_e920 * 6u);
                                                                    let _e968 = (_e925 + 1u);
                                                                    if (_e968 < _e83) {
                                                                    } else {
                                                                        phi_2455_ = true;
                                                                        break;
                                                                    }
                                                                    let _e971 = cells.member[_e968];
                                                                    phi_1382_ = type_8(0u, 6u);
                                                                    phi_1385_ = _e971;
                                                                    loop {
                                                                        let _e973 = phi_1382_;
                                                                        let _e975 = phi_1385_;
                                                                        local = _e975;
                                                                        local_1 = _e975;
                                                                        local_8 = _e975;
                                                                        local_9 = _e975;
                                                                        if (_e973.member < _e973.member_1) {
                                                                            phi_1383_ = type_8((_e973.member + 1u), _e973.member_1);
                                                                            phi_1408_ = type_8(1u, _e973.member);
                                                                        } else {
                                                                            phi_1383_ = _e973;
                                                                            phi_1408_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e988 = phi_1383_;
                                                                        let _e990 = phi_1408_;
                                                                        let _e994 = (bitcast<i32>(_e990.member) != 0i);
                                                                        if _e994 {
                                                                            let _e995 = (_e967 + _e990.member_1);
                                                                            if (_e995 < _e86) {
                                                                            } else {
                                                                                phi_2349_ = true;
                                                                                break;
                                                                            }
                                                                            let _e998 = facet_bits.member[_e995];
                                                                            phi_1386_ = (_e975 + countOneBits((_e998 & ((1u << bitcast<u32>(_e930)) - 1u))));
                                                                        } else {
                                                                            phi_1386_ = u32();
                                                                        }
                                                                        let _e1006 = phi_1386_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_1382_ = _e988;
                                                                            phi_1385_ = _e1006;
                                                                            phi_2349_ = _e884;
                                                                            break if !(_e994);
                                                                        }
                                                                    }
                                                                    let _e1009 = phi_2349_;
                                                                    phi_2455_ = _e1009;
                                                                    if _e1009 {
                                                                        break;
                                                                    }
                                                                    if (_e967 < _e86) {
                                                                    } else {
                                                                        phi_2455_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1012 = facet_bits.member[_e967];
                                                                    let _e1016 = (_e967 + 1u);
                                                                    if (_e1016 < _e86) {
                                                                    } else {
                                                                        phi_2455_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1019 = facet_bits.member[_e1016];
                                                                    let _e1024 = (_e967 + 2u);
                                                                    if (_e1024 < _e86) {
                                                                    } else {
                                                                        phi_2455_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1027 = facet_bits.member[_e1024];
                                                                    let _e1032 = (_e967 + 3u);
                                                                    if (_e1032 < _e86) {
                                                                    } else {
                                                                        phi_2455_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1035 = facet_bits.member[_e1032];
                                                                    let _e1040 = (_e967 + 4u);
                                                                    if (_e1040 < _e86) {
                                                                    } else {
                                                                        phi_2455_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1043 = facet_bits.member[_e1040];
                                                                    let _e1048 = (_e967 + 5u);
                                                                    if (_e1048 < _e86) {
                                                                    } else {
                                                                        phi_2455_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1051 = facet_bits.member[_e1048];
                                                                    let _e1055 = (((((((_e1012 >> bitcast<u32>(_e930)) & 1u) + ((_e1019 >> bitcast<u32>(_e930)) & 1u)) + ((_e1027 >> bitcast<u32>(_e930)) & 1u)) + ((_e1035 >> bitcast<u32>(_e930)) & 1u)) + ((_e1043 >> bitcast<u32>(_e930)) & 1u)) + ((_e1051 >> bitcast<u32>(_e930)) & 1u));
                                                                    if _e938 {
                                                                        let _e1183 = local_8;
                                                                        let _e1186 = local_9;
                                                                        phi_1522_ = type_8(_e1186, (_e1183 + _e1055));
                                                                        phi_1525_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e1189 = phi_1522_;
                                                                            let _e1191 = phi_1525_;
                                                                            local_19 = _e1191;
                                                                            if (_e1189.member < _e1189.member_1) {
                                                                                phi_1523_ = type_8((_e1189.member + 1u), _e1189.member_1);
                                                                                phi_1548_ = type_8(1u, _e1189.member);
                                                                            } else {
                                                                                phi_1523_ = _e1189;
                                                                                phi_1548_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e1204 = phi_1523_;
                                                                            let _e1206 = phi_1548_;
                                                                            let _e1210 = (bitcast<i32>(_e1206.member) != 0i);
                                                                            if _e1210 {
                                                                                let _e1211 = (2u * _e1206.member_1);
                                                                                if (_e1211 < _e92) {
                                                                                } else {
                                                                                    phi_2448_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1215 = radiance.member[_e1211][0u];
                                                                                let _e1218 = radiance.member[_e1211][1u];
                                                                                let _e1221 = radiance.member[_e1211][2u];
                                                                                let _e1222 = (_e1211 + 1u);
                                                                                if (_e1222 < _e92) {
                                                                                } else {
                                                                                    phi_2448_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1226 = radiance.member[_e1222][0u];
                                                                                let _e1229 = radiance.member[_e1222][1u];
                                                                                let _e1232 = radiance.member[_e1222][2u];
                                                                                if (_e1206.member_1 < _e89) {
                                                                                } else {
                                                                                    phi_2448_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1242 = facets.member[_e1206.member_1].member_2;
                                                                                let _e1251 = sqrt((((_e1242[0] * _e1242[0]) + (_e1242[1] * _e1242[1])) + (_e1242[2] * _e1242[2])));
                                                                                phi_1526_ = vec4<f32>((_e1191.x + (select(_e1226, _e1215, (_e1215 > _e1226)) * _e1251)), (_e1191.y + (select(_e1229, _e1218, (_e1218 > _e1229)) * _e1251)), (_e1191.z + (select(_e1232, _e1221, (_e1221 > _e1232)) * _e1251)), (_e1191.w + _e1251));
                                                                            } else {
                                                                                phi_1526_ = vec4<f32>();
                                                                            }
                                                                            let _e1265 = phi_1526_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_1522_ = _e1204;
                                                                                phi_1525_ = _e1265;
                                                                                phi_2448_ = _e1009;
                                                                                break if !(_e1210);
                                                                            }
                                                                        }
                                                                        let _e1268 = phi_2448_;
                                                                        phi_2455_ = _e1268;
                                                                        if _e1268 {
                                                                            break;
                                                                        }
                                                                        phi_2463_ = _e1268;
                                                                        let _e1857 = local_19;
                                                                        phi_1809_ = _e1857;
                                                                    } else {
                                                                        let _e1056 = select(1f, -1f, _e631);
                                                                        let _e1061 = local;
                                                                        let _e1064 = local_1;
                                                                        phi_1673_ = type_8(_e1064, (_e1061 + _e1055));
                                                                        phi_1676_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        phi_1678_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e1067 = phi_1673_;
                                                                            let _e1069 = phi_1676_;
                                                                            let _e1071 = phi_1678_;
                                                                            local_2 = _e1069;
                                                                            local_3 = _e1071;
                                                                            local_4 = _e1069;
                                                                            local_5 = _e1069;
                                                                            local_6 = _e1069;
                                                                            local_7 = _e1071;
                                                                            local_18 = _e1071;
                                                                            if (_e1067.member < _e1067.member_1) {
                                                                                phi_1674_ = type_8((_e1067.member + 1u), _e1067.member_1);
                                                                                phi_1701_ = type_8(1u, _e1067.member);
                                                                            } else {
                                                                                phi_1674_ = _e1067;
                                                                                phi_1701_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e1084 = phi_1674_;
                                                                            let _e1086 = phi_1701_;
                                                                            let _e1090 = (bitcast<i32>(_e1086.member) != 0i);
                                                                            if _e1090 {
                                                                                if (_e1086.member_1 < _e89) {
                                                                                } else {
                                                                                    phi_2439_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1094 = facets.member[_e1086.member_1].member_2;
                                                                                let _e1103 = -((((select(0f, _e1056, _e593) * _e1094[0]) + (select(0f, _e1056, _e719) * _e1094[1])) + (select(0f, _e1056, _e786) * _e1094[2])));
                                                                                if (_e1103 > 0f) {
                                                                                    let _e1125 = (2u * _e1086.member_1);
                                                                                    if (_e1125 < _e92) {
                                                                                    } else {
                                                                                        phi_2439_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1128 = radiance.member[_e1125];
                                                                                    phi_1785_ = _e1069;
                                                                                    phi_1786_ = vec4<f32>((_e1071.x + (_e1128.x * _e1103)), (_e1071.y + (_e1128.y * _e1103)), (_e1071.z + (_e1128.z * _e1103)), (_e1071.w + _e1103));
                                                                                } else {
                                                                                    let _e1106 = ((2u * _e1086.member_1) + 1u);
                                                                                    if (_e1106 < _e92) {
                                                                                    } else {
                                                                                        phi_2439_ = true;
                                                                                        break;
                                                                                    }
                                                                                    let _e1109 = radiance.member[_e1106];
                                                                                    phi_1785_ = vec4<f32>((_e1069.x - (_e1109.x * _e1103)), (_e1069.y - (_e1109.y * _e1103)), (_e1069.z - (_e1109.z * _e1103)), (_e1069.w - _e1103));
                                                                                    phi_1786_ = _e1071;
                                                                                }
                                                                                let _e1145 = phi_1785_;
                                                                                let _e1147 = phi_1786_;
                                                                                phi_1677_ = _e1145;
                                                                                phi_1679_ = _e1147;
                                                                            } else {
                                                                                phi_1677_ = vec4<f32>();
                                                                                phi_1679_ = vec4<f32>();
                                                                            }
                                                                            let _e1149 = phi_1677_;
                                                                            let _e1151 = phi_1679_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_1673_ = _e1084;
                                                                                phi_1676_ = _e1149;
                                                                                phi_1678_ = _e1151;
                                                                                phi_2439_ = _e1009;
                                                                                break if !(_e1090);
                                                                            }
                                                                        }
                                                                        let _e1154 = phi_2439_;
                                                                        phi_2455_ = _e1154;
                                                                        if _e1154 {
                                                                            break;
                                                                        }
                                                                        let _e1156 = local_2;
                                                                        let _e1159 = local_3;
                                                                        if (_e1156.w > _e1159.w) {
                                                                            let _e1162 = (_e1156.w - _e1159.w);
                                                                            let _e1163 = (_e1162 / _e1156.w);
                                                                            let _e1165 = local_4;
                                                                            let _e1169 = local_5;
                                                                            let _e1173 = local_6;
                                                                            let _e1178 = local_7;
                                                                            phi_1808_ = (_e1178 + vec4<f32>((_e1165.x * _e1163), (_e1169.y * _e1163), (_e1173.z * _e1163), _e1162));
                                                                        } else {
                                                                            let _e1845 = local_18;
                                                                            phi_1808_ = _e1845;
                                                                        }
                                                                        let _e1181 = phi_1808_;
                                                                        phi_2463_ = _e1154;
                                                                        phi_1809_ = _e1181;
                                                                    }
                                                                    let _e1270 = phi_2463_;
                                                                    let _e1272 = phi_1809_;
                                                                    if (_e1272.w > 1f) {
                                                                        phi_1823_ = vec4<f32>((_e1272.x / _e1272.w), (_e1272.y / _e1272.w), (_e1272.z / _e1272.w), 1f);
                                                                    } else {
                                                                        phi_1823_ = _e1272;
                                                                    }
                                                                    let _e1283 = phi_1823_;
                                                                    phi_2459_ = _e1270;
                                                                    phi_1874_ = _e1283;
                                                                } else {
                                                                    let _e940 = (_e925 + 1u);
                                                                    if (_e940 < _e83) {
                                                                    } else {
                                                                        phi_2455_ = true;
                                                                        break;
                                                                    }
                                                                    let _e943 = cells.member[_e940];
                                                                    let _e949 = (_e943 + countOneBits((_e928 & ((1u << bitcast<u32>(_e930)) - 1u))));
                                                                    if _e938 {
                                                                        phi_1849_ = _e949;
                                                                    } else {
                                                                        phi_1849_ = (((6u * _e949) + (2u * _e592)) + select(0u, 1u, _e631));
                                                                    }
                                                                    let _e956 = phi_1849_;
                                                                    if ((_e618 & 1u) == 1u) {
                                                                        if (_e956 < arrayLength((&odd.member))) {
                                                                        } else {
                                                                            phi_2455_ = true;
                                                                            break;
                                                                        }
                                                                        let _e964 = odd.member[_e956];
                                                                        phi_1873_ = _e964;
                                                                    } else {
                                                                        if (_e956 < arrayLength((&even.member))) {
                                                                        } else {
                                                                            phi_2455_ = true;
                                                                            break;
                                                                        }
                                                                        let _e961 = even.member[_e956];
                                                                        phi_1873_ = _e961;
                                                                    }
                                                                    let _e966 = phi_1873_;
                                                                    phi_2459_ = _e884;
                                                                    phi_1874_ = _e966;
                                                                }
                                                                let _e1285 = phi_2459_;
                                                                let _e1287 = phi_1874_;
                                                                phi_2458_ = _e1285;
                                                                phi_1895_ = vec4<f32>((_e888.x + (_e1287.x * _e914)), (_e888.y + (_e1287.y * _e914)), (_e888.z + (_e1287.z * _e914)), (_e888.w + (_e1287.w * _e914)));
                                                            } else {
                                                                phi_2458_ = _e884;
                                                                phi_1895_ = _e888;
                                                            }
                                                            let _e1306 = phi_2458_;
                                                            let _e1308 = phi_1895_;
                                                            phi_2457_ = _e1306;
                                                            phi_1896_ = _e1308;
                                                        } else {
                                                            phi_2457_ = _e884;
                                                            phi_1896_ = _e888;
                                                        }
                                                        let _e1310 = phi_2457_;
                                                        let _e1312 = phi_1896_;
                                                        phi_2456_ = _e1310;
                                                        phi_1273_ = _e1312;
                                                    } else {
                                                        phi_2456_ = _e884;
                                                        phi_1273_ = vec4<f32>();
                                                    }
                                                    let _e1314 = phi_2456_;
                                                    let _e1316 = phi_1273_;
                                                    continue;
                                                    continuing {
                                                        phi_2360_ = _e1314;
                                                        phi_1269_ = _e901;
                                                        phi_1272_ = _e1316;
                                                        phi_2455_ = _e1314;
                                                        break if !(_e907);
                                                    }
                                                }
                                                let _e1319 = phi_2455_;
                                                phi_2465_ = _e1319;
                                                if _e1319 {
                                                    break;
                                                }
                                                phi_2484_ = _e1319;
                                                let _e1871 = local_20;
                                                phi_1897_ = _e1871;
                                            }
                                            let _e1321 = phi_2484_;
                                            let _e1323 = phi_1897_;
                                            phi_2483_ = _e1321;
                                            phi_1898_ = _e1323;
                                            phi_1899_ = _e658;
                                        }
                                        let _e1325 = phi_2483_;
                                        let _e1327 = phi_1898_;
                                        let _e1329 = phi_1899_;
                                        let _e1331 = select(_e1327, vec4<f32>(0f, 0f, 0f, 0f), vec4(_e1329));
                                        if (_e1331.w > 0f) {
                                            let _e1338 = select(_e622, _e1331.w, (_e1331.w < _e622));
                                            let _e1343 = ((_e561 * _e1338) / _e1331.w);
                                            phi_1943_ = vec3<f32>((_e551.x + (_e1331.x * _e1343)), (_e551.y + (_e1331.y * _e1343)), (_e551.z + (_e1331.z * _e1343)));
                                            phi_1944_ = (_e559 + _e1338);
                                            phi_1945_ = _e561;
                                        } else {
                                            let _e1334 = (_e592 == _e416);
                                            phi_1943_ = _e551;
                                            phi_1944_ = select(_e559, 0f, _e1334);
                                            phi_1945_ = select(_e561, _e623, _e1334);
                                        }
                                        let _e1356 = phi_1943_;
                                        let _e1358 = phi_1944_;
                                        let _e1360 = phi_1945_;
                                        let _e1361 = (_e378 * _e614);
                                        let _e1363 = ((_e381 * _e155) + ((_e381 * _e375.z) * _e614));
                                        let _e1365 = select(_e1363, _e1361, (_e1361 < _e1363));
                                        let _e1372 = ((bitcast<u32>((select(1f, _e1365, (_e1365 > 1f)) * _e373)) >> bitcast<u32>(23i)) - 127u);
                                        let _e1374 = (_e404.w - 1u);
                                        let _e1376 = select(_e1372, _e1374, (_e1374 < _e1372));
                                        if _e593 {
                                            let _e1537 = (_e557.member_1 < 0f);
                                            if _e1537 {
                                                phi_1988_ = (_e557.member_3 - 1i);
                                            } else {
                                                phi_1988_ = (_e557.member_3 + 1i);
                                            }
                                            let _e1545 = phi_1988_;
                                            let _e1551 = type_38(_e557.member, _e557.member_1, _e557.member_2, _e1545, _e557.member_4);
                                            if (((_e557.member_3 & 1i) == 0i) == _e1537) {
                                                if (_e1376 > _e557.member_2) {
                                                    let _e1560 = type_38(_e1551.member, _e1551.member_1, (_e557.member_2 + 1u), _e1551.member_3, _e1551.member_4);
                                                    phi_2003_ = type_38(_e1560.member, _e1560.member_1, _e1560.member_2, (_e1545 >> bitcast<u32>(1i)), _e1560.member_4);
                                                } else {
                                                    phi_2003_ = _e1551;
                                                }
                                                let _e1570 = phi_2003_;
                                                phi_2004_ = _e1570;
                                            } else {
                                                phi_2004_ = _e1551;
                                            }
                                            let _e1572 = phi_2004_;
                                            let _e1574 = (_e1572.member_2 & 31u);
                                            let _e1576 = (1u << bitcast<u32>(_e1574));
                                            if (_e1572.member_1 < 0f) {
                                                phi_2023_ = (_e1572.member_3 < 0i);
                                            } else {
                                                phi_2023_ = (_e1572.member_3 >= bitcast<i32>((((_e404.x + _e1576) - 1u) >> bitcast<u32>(_e1574))));
                                            }
                                            let _e1589 = phi_2023_;
                                            if _e1589 {
                                                phi_2046_ = f32();
                                                phi_2047_ = true;
                                            } else {
                                                let _e1596 = (abs(_e1572.member_1) < 0.000001f);
                                                if _e1596 {
                                                    phi_2045_ = f32();
                                                } else {
                                                    phi_2045_ = ((((f32(_e1572.member_3) + 0.5f) * f32(_e1576)) - _e1572.member) / _e1572.member_1);
                                                }
                                                let _e1601 = phi_2045_;
                                                phi_2046_ = _e1601;
                                                phi_2047_ = _e1596;
                                            }
                                            let _e1603 = phi_2046_;
                                            let _e1605 = phi_2047_;
                                            phi_2217_ = _e553;
                                            phi_2218_ = _e555;
                                            phi_2219_ = type_38(_e1572.member, _e1572.member_1, _e1572.member_2, _e1572.member_3, select(_e1603, 340282350000000000000000000000000000000f, _e1605));
                                        } else {
                                            if (_e592 == 1u) {
                                                let _e1456 = (_e555.member_1 < 0f);
                                                if _e1456 {
                                                    phi_2071_ = (_e555.member_3 - 1i);
                                                } else {
                                                    phi_2071_ = (_e555.member_3 + 1i);
                                                }
                                                let _e1464 = phi_2071_;
                                                let _e1470 = type_38(_e555.member, _e555.member_1, _e555.member_2, _e1464, _e555.member_4);
                                                if (((_e555.member_3 & 1i) == 0i) == _e1456) {
                                                    if (_e1376 > _e555.member_2) {
                                                        let _e1479 = type_38(_e1470.member, _e1470.member_1, (_e555.member_2 + 1u), _e1470.member_3, _e1470.member_4);
                                                        phi_2086_ = type_38(_e1479.member, _e1479.member_1, _e1479.member_2, (_e1464 >> bitcast<u32>(1i)), _e1479.member_4);
                                                    } else {
                                                        phi_2086_ = _e1470;
                                                    }
                                                    let _e1489 = phi_2086_;
                                                    phi_2087_ = _e1489;
                                                } else {
                                                    phi_2087_ = _e1470;
                                                }
                                                let _e1491 = phi_2087_;
                                                let _e1493 = (_e1491.member_2 & 31u);
                                                let _e1495 = (1u << bitcast<u32>(_e1493));
                                                if (_e1491.member_1 < 0f) {
                                                    phi_2106_ = (_e1491.member_3 < 0i);
                                                } else {
                                                    phi_2106_ = (_e1491.member_3 >= bitcast<i32>((((_e404.y + _e1495) - 1u) >> bitcast<u32>(_e1493))));
                                                }
                                                let _e1508 = phi_2106_;
                                                if _e1508 {
                                                    phi_2129_ = f32();
                                                    phi_2130_ = true;
                                                } else {
                                                    let _e1515 = (abs(_e1491.member_1) < 0.000001f);
                                                    if _e1515 {
                                                        phi_2128_ = f32();
                                                    } else {
                                                        phi_2128_ = ((((f32(_e1491.member_3) + 0.5f) * f32(_e1495)) - _e1491.member) / _e1491.member_1);
                                                    }
                                                    let _e1520 = phi_2128_;
                                                    phi_2129_ = _e1520;
                                                    phi_2130_ = _e1515;
                                                }
                                                let _e1522 = phi_2129_;
                                                let _e1524 = phi_2130_;
                                                phi_2215_ = _e553;
                                                phi_2216_ = type_38(_e1491.member, _e1491.member_1, _e1491.member_2, _e1491.member_3, select(_e1522, 340282350000000000000000000000000000000f, _e1524));
                                            } else {
                                                let _e1379 = (_e553.member_1 < 0f);
                                                if _e1379 {
                                                    phi_2150_ = (_e553.member_3 - 1i);
                                                } else {
                                                    phi_2150_ = (_e553.member_3 + 1i);
                                                }
                                                let _e1387 = phi_2150_;
                                                let _e1393 = type_38(_e553.member, _e553.member_1, _e553.member_2, _e1387, _e553.member_4);
                                                if (((_e553.member_3 & 1i) == 0i) == _e1379) {
                                                    if (_e1376 > _e553.member_2) {
                                                        let _e1402 = type_38(_e1393.member, _e1393.member_1, (_e553.member_2 + 1u), _e1393.member_3, _e1393.member_4);
                                                        phi_2165_ = type_38(_e1402.member, _e1402.member_1, _e1402.member_2, (_e1387 >> bitcast<u32>(1i)), _e1402.member_4);
                                                    } else {
                                                        phi_2165_ = _e1393;
                                                    }
                                                    let _e1412 = phi_2165_;
                                                    phi_2166_ = _e1412;
                                                } else {
                                                    phi_2166_ = _e1393;
                                                }
                                                let _e1414 = phi_2166_;
                                                let _e1416 = (_e1414.member_2 & 31u);
                                                let _e1418 = (1u << bitcast<u32>(_e1416));
                                                if (_e1414.member_1 < 0f) {
                                                    phi_2185_ = (_e1414.member_3 < 0i);
                                                } else {
                                                    phi_2185_ = (_e1414.member_3 >= bitcast<i32>((((_e404.z + _e1418) - 1u) >> bitcast<u32>(_e1416))));
                                                }
                                                let _e1431 = phi_2185_;
                                                if _e1431 {
                                                    phi_2208_ = f32();
                                                    phi_2209_ = true;
                                                } else {
                                                    let _e1438 = (abs(_e1414.member_1) < 0.000001f);
                                                    if _e1438 {
                                                        phi_2207_ = f32();
                                                    } else {
                                                        phi_2207_ = ((((f32(_e1414.member_3) + 0.5f) * f32(_e1418)) - _e1414.member) / _e1414.member_1);
                                                    }
                                                    let _e1443 = phi_2207_;
                                                    phi_2208_ = _e1443;
                                                    phi_2209_ = _e1438;
                                                }
                                                let _e1445 = phi_2208_;
                                                let _e1447 = phi_2209_;
                                                phi_2215_ = type_38(_e1414.member, _e1414.member_1, _e1414.member_2, _e1414.member_3, select(_e1445, 340282350000000000000000000000000000000f, _e1447));
                                                phi_2216_ = _e555;
                                            }
                                            let _e1533 = phi_2215_;
                                            let _e1535 = phi_2216_;
                                            phi_2217_ = _e1533;
                                            phi_2218_ = _e1535;
                                            phi_2219_ = _e557;
                                        }
                                        let _e1614 = phi_2217_;
                                        let _e1616 = phi_2218_;
                                        let _e1618 = phi_2219_;
                                        phi_2468_ = _e1325;
                                        phi_2220_ = _e1356;
                                        phi_2221_ = _e1614;
                                        phi_2222_ = _e1616;
                                        phi_2223_ = _e1618;
                                        phi_2224_ = _e1358;
                                        phi_2225_ = _e1360;
                                    }
                                    let _e1620 = phi_2468_;
                                    let _e1622 = phi_2220_;
                                    let _e1624 = phi_2221_;
                                    let _e1626 = phi_2222_;
                                    let _e1628 = phi_2223_;
                                    let _e1630 = phi_2224_;
                                    let _e1632 = phi_2225_;
                                    phi_2467_ = _e1620;
                                    phi_2227_ = _e1622;
                                    phi_2228_ = _e1624;
                                    phi_2229_ = _e1626;
                                    phi_2230_ = _e1628;
                                    phi_2231_ = _e1630;
                                    phi_2232_ = _e1632;
                                    phi_2233_ = select(true, false, _e624);
                                }
                                let _e1635 = phi_2467_;
                                let _e1637 = phi_2227_;
                                let _e1639 = phi_2228_;
                                let _e1641 = phi_2229_;
                                let _e1643 = phi_2230_;
                                let _e1645 = phi_2231_;
                                let _e1647 = phi_2232_;
                                let _e1649 = phi_2233_;
                                phi_2466_ = _e1635;
                                phi_765_ = _e1637;
                                phi_767_ = _e1639;
                                phi_769_ = _e1641;
                                phi_771_ = _e1643;
                                phi_773_ = _e1645;
                                phi_775_ = _e1647;
                                phi_2235_ = _e1649;
                            } else {
                                phi_2466_ = _e547;
                                phi_765_ = vec3<f32>();
                                phi_767_ = type_38();
                                phi_769_ = type_38();
                                phi_771_ = type_38();
                                phi_773_ = f32();
                                phi_775_ = f32();
                                phi_2235_ = false;
                            }
                            let _e1651 = phi_2466_;
                            let _e1653 = phi_765_;
                            let _e1655 = phi_767_;
                            let _e1657 = phi_769_;
                            let _e1659 = phi_771_;
                            let _e1661 = phi_773_;
                            let _e1663 = phi_775_;
                            let _e1665 = phi_2235_;
                            continue;
                            continuing {
                                phi_2397_ = _e1651;
                                phi_761_ = _e574;
                                phi_764_ = _e1653;
                                phi_766_ = _e1655;
                                phi_768_ = _e1657;
                                phi_770_ = _e1659;
                                phi_772_ = _e1661;
                                phi_774_ = _e1663;
                                phi_2465_ = _e1651;
                                break if !(_e1665);
                            }
                        }
                        let _e1668 = phi_2465_;
                        phi_2501_ = _e1668;
                        if _e1668 {
                            break;
                        }
                        let _e1670 = local_10;
                        let _e1673 = local_11;
                        let _e1674 = (_e1673 * (1f - _e1670));
                        let _e1676 = local_12;
                        let _e1679 = local_13;
                        let _e1682 = local_14;
                        let _e1686 = params.member.member_5;
                        phi_2502_ = _e1668;
                        phi_310_ = vec3<f32>((_e226.x + ((_e1676.x + (_e1686.x * _e1674)) * _e250.w)), (_e226.y + ((_e1679.y + (_e1686.y * _e1674)) * _e250.w)), (_e226.z + ((_e1682.z + (_e1686.z * _e1674)) * _e250.w)));
                    } else {
                        phi_2502_ = _e222;
                        phi_310_ = vec3<f32>();
                    }
                    let _e1708 = phi_2502_;
                    let _e1710 = phi_310_;
                    continue;
                    continuing {
                        phi_2421_ = _e1708;
                        phi_306_ = _e239;
                        phi_309_ = _e1710;
                        phi_2501_ = _e1708;
                        break if !(_e245);
                    }
                }
                let _e1713 = phi_2501_;
                if _e1713 {
                    break;
                }
                let _e1715 = local_15;
                let _e1719 = local_16;
                let _e1723 = local_17;
                if (_e107 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e107] = vec4<f32>((_e1715.x * 3.1415927f), (_e1719.y * 3.1415927f), (_e1723.z * 3.1415927f), 0f);
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
