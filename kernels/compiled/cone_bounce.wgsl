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
    var phi_190_: vec3<f32>;
    var phi_197_: vec3<f32>;
    var phi_300_: f32;
    var phi_2236_: bool;
    var phi_305_: type_8;
    var phi_308_: vec3<f32>;
    var phi_306_: type_8;
    var phi_331_: type_8;
    var phi_469_: f32;
    var phi_477_: f32;
    var phi_490_: f32;
    var phi_491_: vec3<f32>;
    var phi_538_: bool;
    var phi_547_: u32;
    var phi_579_: i32;
    var phi_593_: bool;
    var phi_610_: f32;
    var phi_611_: f32;
    var phi_612_: bool;
    var phi_649_: i32;
    var phi_663_: bool;
    var phi_680_: f32;
    var phi_681_: f32;
    var phi_682_: bool;
    var phi_719_: i32;
    var phi_733_: bool;
    var phi_750_: f32;
    var phi_751_: f32;
    var phi_752_: bool;
    var phi_760_: type_8;
    var phi_763_: vec3<f32>;
    var phi_765_: type_38;
    var phi_767_: type_38;
    var phi_769_: type_38;
    var phi_771_: f32;
    var phi_773_: f32;
    var phi_761_: type_8;
    var phi_796_: type_8;
    var phi_816_: bool;
    var phi_827_: u32;
    var phi_848_: f32;
    var phi_849_: i32;
    var phi_850_: u32;
    var phi_851_: f32;
    var phi_852_: f32;
    var phi_853_: i32;
    var phi_854_: u32;
    var phi_855_: f32;
    var phi_911_: u32;
    var phi_928_: f32;
    var phi_949_: bool;
    var phi_961_: u32;
    var phi_972_: u32;
    var phi_980_: f32;
    var phi_1019_: f32;
    var phi_1030_: f32;
    var phi_1052_: bool;
    var phi_1064_: u32;
    var phi_1075_: u32;
    var phi_1083_: f32;
    var phi_1122_: f32;
    var phi_1133_: f32;
    var phi_1155_: bool;
    var phi_1167_: u32;
    var phi_1178_: u32;
    var phi_1186_: f32;
    var phi_1225_: f32;
    var phi_1252_: f32;
    var phi_1253_: f32;
    var phi_1254_: u32;
    var phi_1255_: u32;
    var phi_1256_: u32;
    var phi_1257_: u32;
    var phi_1258_: f32;
    var phi_1259_: f32;
    var phi_1260_: u32;
    var phi_1261_: u32;
    var phi_1262_: u32;
    var phi_1263_: u32;
    var phi_1264_: u32;
    var phi_1265_: u32;
    var phi_1268_: type_8;
    var phi_1271_: vec4<f32>;
    var phi_1269_: type_8;
    var phi_1294_: type_8;
    var phi_1729_: u32;
    var phi_1741_: vec4<f32>;
    var phi_1574_: type_8;
    var phi_1577_: vec4<f32>;
    var phi_1579_: vec4<f32>;
    var phi_1575_: type_8;
    var phi_1602_: type_8;
    var phi_1671_: vec4<f32>;
    var phi_1672_: vec4<f32>;
    var phi_1578_: vec4<f32>;
    var phi_1580_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1694_: vec4<f32>;
    var phi_1452_: type_8;
    var phi_1455_: vec4<f32>;
    var phi_1453_: type_8;
    var phi_1478_: type_8;
    var phi_1456_: vec4<f32>;
    var phi_1695_: vec4<f32>;
    var phi_1709_: vec4<f32>;
    var phi_1742_: vec4<f32>;
    var phi_1763_: vec4<f32>;
    var phi_1764_: vec4<f32>;
    var phi_1272_: vec4<f32>;
    var phi_1765_: vec4<f32>;
    var phi_1766_: vec4<f32>;
    var phi_1767_: bool;
    var phi_1811_: vec3<f32>;
    var phi_1812_: f32;
    var phi_1813_: f32;
    var phi_2018_: i32;
    var phi_2033_: type_38;
    var phi_2034_: type_38;
    var phi_2053_: bool;
    var phi_2075_: f32;
    var phi_2076_: f32;
    var phi_2077_: bool;
    var phi_1939_: i32;
    var phi_1954_: type_38;
    var phi_1955_: type_38;
    var phi_1974_: bool;
    var phi_1996_: f32;
    var phi_1997_: f32;
    var phi_1998_: bool;
    var phi_2083_: type_38;
    var phi_2084_: type_38;
    var phi_1856_: i32;
    var phi_1871_: type_38;
    var phi_1872_: type_38;
    var phi_1891_: bool;
    var phi_1913_: f32;
    var phi_1914_: f32;
    var phi_1915_: bool;
    var phi_2085_: type_38;
    var phi_2086_: type_38;
    var phi_2087_: type_38;
    var phi_2088_: vec3<f32>;
    var phi_2089_: type_38;
    var phi_2090_: type_38;
    var phi_2091_: type_38;
    var phi_2092_: f32;
    var phi_2093_: f32;
    var phi_2095_: vec3<f32>;
    var phi_2096_: type_38;
    var phi_2097_: type_38;
    var phi_2098_: type_38;
    var phi_2099_: f32;
    var phi_2100_: f32;
    var phi_2101_: bool;
    var phi_764_: vec3<f32>;
    var phi_766_: type_38;
    var phi_768_: type_38;
    var phi_770_: type_38;
    var phi_772_: f32;
    var phi_774_: f32;
    var phi_2103_: bool;
    var phi_2209_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var phi_2354_: bool;
    var phi_309_: vec3<f32>;
    var phi_2353_: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = gid_1;
            let _e91 = params.member.member_9;
            let _e95 = (_e78.x + (_e78.y * 2097152u));
            if (_e95 < _e91) {
                let _e97 = (_e95 / 2u);
                if (_e97 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e101 = facets.member[_e97];
                let _e111 = sqrt((((_e101.member_2[0] * _e101.member_2[0]) + (_e101.member_2[1] * _e101.member_2[1])) + (_e101.member_2[2] * _e101.member_2[2])));
                if (_e111 > 0.000000000001f) {
                    phi_190_ = vec3<f32>((_e101.member_2[0] / _e111), (_e101.member_2[1] / _e111), (_e101.member_2[2] / _e111));
                } else {
                    phi_190_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e118 = phi_190_;
                if ((_e95 & 1u) == 0u) {
                    phi_197_ = _e118;
                } else {
                    phi_197_ = -(_e118);
                }
                let _e123 = phi_197_;
                let _e130 = params.member.member;
                let _e143 = params.member.member_12;
                let _e150 = (((_e101.member[0] - _e130.x) / _e130.w) + (_e123.x * _e143));
                let _e151 = (((_e101.member[1] - _e130.y) / _e130.w) + (_e123.y * _e143));
                let _e152 = (((_e101.member[2] - _e130.z) / _e130.w) + (_e123.z * _e143));
                let _e156 = bitcast<f32>((1065353216u | (bitcast<u32>(_e123.z) & 2147483648u)));
                let _e158 = (-1f / (_e156 + _e123.z));
                let _e160 = ((_e123.x * _e123.y) * _e158);
                let _e174 = params.member.member_10;
                let _e175 = (_e174 == 0u);
                if _e175 {
                    phi_300_ = 0f;
                } else {
                    let _e179 = ((_e95 * 1664525u) + 1013904223u);
                    let _e181 = (((_e174 * 1664525u) + 1013904223u) + (_e179 * 1013904223u));
                    let _e183 = (_e179 + (1013904223u * _e181));
                    let _e187 = (1013904223u + (_e183 * (1013904223u + (_e181 * _e183))));
                    phi_300_ = (f32((((_e181 ^ (_e181 >> bitcast<u32>(16i))) + ((_e183 ^ (_e183 >> bitcast<u32>(16i))) * (_e187 ^ (_e187 >> bitcast<u32>(16i))))) >> bitcast<u32>(8i))) * 0.000000059604645f);
                }
                let _e204 = phi_300_;
                let _e207 = params.member.member_7;
                phi_2236_ = false;
                phi_305_ = type_8(0u, _e207);
                phi_308_ = vec3<f32>(0f, 0f, 0f);
                loop {
                    let _e210 = phi_2236_;
                    let _e212 = phi_305_;
                    let _e214 = phi_308_;
                    local_11 = _e214;
                    local_12 = _e214;
                    local_13 = _e214;
                    if (_e212.member < _e212.member_1) {
                        phi_306_ = type_8((_e212.member + 1u), _e212.member_1);
                        phi_331_ = type_8(1u, _e212.member);
                    } else {
                        phi_306_ = _e212;
                        phi_331_ = type_8(0u, type_8().member_1);
                    }
                    let _e227 = phi_306_;
                    let _e229 = phi_331_;
                    let _e233 = (bitcast<i32>(_e229.member) != 0i);
                    if _e233 {
                        let _e234 = (_e229.member_1 < 16u);
                        if _e234 {
                        } else {
                            phi_2353_ = true;
                            break;
                        }
                        let _e238 = params.member.member_3[_e229.member_1];
                        if _e175 {
                            phi_490_ = 1.4142135f;
                            phi_491_ = vec3<f32>(_e238.x, _e238.y, _e238.z);
                        } else {
                            let _e243 = ((_e95 * 1664525u) + 1013904223u);
                            let _e245 = (((1u + _e229.member_1) * 1664525u) + 1013904223u);
                            let _e247 = (((_e174 * 1664525u) + 1013904223u) + (_e243 * 1013904223u));
                            let _e249 = (_e243 + (_e245 * _e247));
                            let _e251 = (_e245 + (_e247 * _e249));
                            let _e253 = (1013904223u + (_e249 * _e251));
                            let _e259 = (_e249 ^ (_e249 >> bitcast<u32>(16i)));
                            let _e262 = (_e251 ^ (_e251 >> bitcast<u32>(16i)));
                            let _e267 = ((_e247 ^ (_e247 >> bitcast<u32>(16i))) + (_e259 * (_e253 ^ (_e253 >> bitcast<u32>(16i)))));
                            let _e269 = (_e259 + (_e262 * _e267));
                            if _e234 {
                            } else {
                                phi_2353_ = true;
                                break;
                            }
                            let _e287 = params.member.member_4[_e229.member_1];
                            let _e292 = (_e287.y + ((_e287.x - _e287.y) * (f32((_e267 >> bitcast<u32>(8i))) * 0.000000059604645f)));
                            let _e297 = ((_e287.z + (_e287.w * (f32((_e269 >> bitcast<u32>(8i))) * 0.000000059604645f))) + _e204);
                            let _e301 = floor(((_e297 * 4f) + 0.5f));
                            let _e307 = ((((6.2831855f * _e297) - (_e301 * 1.5703125f)) - (_e301 * 0.0004837513f)) - (_e301 * 0.0000000754979f));
                            let _e308 = (_e307 * _e307);
                            let _e315 = (_e307 + ((_e307 * _e308) * (-0.16666655f + (_e308 * (0.008332161f + (_e308 * -0.00019515296f))))));
                            let _e324 = ((1f - (0.5f * _e308)) + ((_e308 * _e308) * (0.041666646f + (_e308 * (-0.0013887316f + (_e308 * 0.000024433157f))))));
                            let _e331 = select(0i, select(select(i32(_e301), i32(-2147483648), (_e301 < -2147483600f)), 2147483647i, (_e301 > 2147483500f)), (_e301 == _e301));
                            let _e333 = ((_e331 & 1i) == 0i);
                            let _e334 = select(_e324, _e315, _e333);
                            let _e335 = select(_e315, _e324, _e333);
                            if ((_e331 & 2i) == 0i) {
                                phi_469_ = _e334;
                            } else {
                                phi_469_ = -(_e334);
                            }
                            let _e340 = phi_469_;
                            if (((_e331 + 1i) & 2i) == 0i) {
                                phi_477_ = _e335;
                            } else {
                                phi_477_ = -(_e335);
                            }
                            let _e346 = phi_477_;
                            let _e347 = (1f - _e292);
                            let _e350 = sqrt(select(0f, _e347, (_e347 > 0f)));
                            phi_490_ = (1f + (f32(((_e262 + (_e267 * _e269)) >> bitcast<u32>(8i))) * 0.000000059604645f));
                            phi_491_ = vec3<f32>((_e350 * _e346), (_e350 * _e340), sqrt(_e292));
                        }
                        let _e361 = phi_490_;
                        let _e363 = phi_491_;
                        let _e366 = params.member.member_11;
                        let _e369 = params.member.member_13;
                        let _e387 = ((((1f + (((_e156 * _e123.x) * _e123.x) * _e158)) * _e363.x) + (_e160 * _e363.y)) + (_e123.x * _e363.z));
                        let _e388 = ((((_e156 * _e160) * _e363.x) + ((_e156 + ((_e123.y * _e123.y) * _e158)) * _e363.y)) + (_e123.y * _e363.z));
                        let _e389 = ((((-(_e156) * _e123.x) * _e363.x) + (-(_e123.y) * _e363.y)) + (_e123.z * _e363.z));
                        let _e392 = params.member.member_1;
                        let _e393 = abs(_e387);
                        let _e394 = abs(_e388);
                        let _e395 = abs(_e389);
                        if (_e393 >= _e394) {
                            phi_538_ = select(true, false, (_e393 >= _e395));
                        } else {
                            phi_538_ = true;
                        }
                        let _e400 = phi_538_;
                        if _e400 {
                            phi_547_ = select(2u, 1u, (_e394 >= _e395));
                        } else {
                            phi_547_ = 0u;
                        }
                        let _e404 = phi_547_;
                        let _e407 = floor((_e150 - 0.5f));
                        let _e417 = -(floor((0.5f - _e150)));
                        let _e425 = (_e387 < 0f);
                        if _e425 {
                            phi_579_ = (select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < -2147483600f)), 2147483647i, (_e417 > 2147483500f)), (_e417 == _e417)) - 1i);
                        } else {
                            phi_579_ = (select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < -2147483600f)), 2147483647i, (_e407 > 2147483500f)), (_e407 == _e407)) + 1i);
                        }
                        let _e429 = phi_579_;
                        if _e425 {
                            phi_593_ = (_e429 < 0i);
                        } else {
                            phi_593_ = (_e429 >= bitcast<i32>(_e392.x));
                        }
                        let _e434 = phi_593_;
                        if _e434 {
                            phi_611_ = f32();
                            phi_612_ = true;
                        } else {
                            let _e437 = (_e393 < 0.000001f);
                            if _e437 {
                                phi_610_ = f32();
                            } else {
                                phi_610_ = (((f32(_e429) + 0.5f) - _e150) / _e387);
                            }
                            let _e441 = phi_610_;
                            phi_611_ = _e441;
                            phi_612_ = _e437;
                        }
                        let _e443 = phi_611_;
                        let _e445 = phi_612_;
                        let _e450 = floor((_e151 - 0.5f));
                        let _e460 = -(floor((0.5f - _e151)));
                        let _e468 = (_e388 < 0f);
                        if _e468 {
                            phi_649_ = (select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < -2147483600f)), 2147483647i, (_e460 > 2147483500f)), (_e460 == _e460)) - 1i);
                        } else {
                            phi_649_ = (select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < -2147483600f)), 2147483647i, (_e450 > 2147483500f)), (_e450 == _e450)) + 1i);
                        }
                        let _e472 = phi_649_;
                        if _e468 {
                            phi_663_ = (_e472 < 0i);
                        } else {
                            phi_663_ = (_e472 >= bitcast<i32>(_e392.y));
                        }
                        let _e477 = phi_663_;
                        if _e477 {
                            phi_681_ = f32();
                            phi_682_ = true;
                        } else {
                            let _e480 = (_e394 < 0.000001f);
                            if _e480 {
                                phi_680_ = f32();
                            } else {
                                phi_680_ = (((f32(_e472) + 0.5f) - _e151) / _e388);
                            }
                            let _e484 = phi_680_;
                            phi_681_ = _e484;
                            phi_682_ = _e480;
                        }
                        let _e486 = phi_681_;
                        let _e488 = phi_682_;
                        let _e493 = floor((_e152 - 0.5f));
                        let _e503 = -(floor((0.5f - _e152)));
                        let _e511 = (_e389 < 0f);
                        if _e511 {
                            phi_719_ = (select(0i, select(select(i32(_e503), i32(-2147483648), (_e503 < -2147483600f)), 2147483647i, (_e503 > 2147483500f)), (_e503 == _e503)) - 1i);
                        } else {
                            phi_719_ = (select(0i, select(select(i32(_e493), i32(-2147483648), (_e493 < -2147483600f)), 2147483647i, (_e493 > 2147483500f)), (_e493 == _e493)) + 1i);
                        }
                        let _e515 = phi_719_;
                        if _e511 {
                            phi_733_ = (_e515 < 0i);
                        } else {
                            phi_733_ = (_e515 >= bitcast<i32>(_e392.z));
                        }
                        let _e520 = phi_733_;
                        if _e520 {
                            phi_751_ = f32();
                            phi_752_ = true;
                        } else {
                            let _e523 = (_e395 < 0.000001f);
                            if _e523 {
                                phi_750_ = f32();
                            } else {
                                phi_750_ = (((f32(_e515) + 0.5f) - _e152) / _e389);
                            }
                            let _e527 = phi_750_;
                            phi_751_ = _e527;
                            phi_752_ = _e523;
                        }
                        let _e529 = phi_751_;
                        let _e531 = phi_752_;
                        phi_760_ = type_8(0u, 2048u);
                        phi_763_ = vec3<f32>(0f, 0f, 0f);
                        phi_765_ = type_38(_e152, _e389, 0u, _e515, select(_e529, 340282350000000000000000000000000000000f, _e531));
                        phi_767_ = type_38(_e151, _e388, 0u, _e472, select(_e486, 340282350000000000000000000000000000000f, _e488));
                        phi_769_ = type_38(_e150, _e387, 0u, _e429, select(_e443, 340282350000000000000000000000000000000f, _e445));
                        phi_771_ = 0f;
                        phi_773_ = 1f;
                        loop {
                            let _e535 = phi_760_;
                            let _e537 = phi_763_;
                            let _e539 = phi_765_;
                            let _e541 = phi_767_;
                            let _e543 = phi_769_;
                            let _e545 = phi_771_;
                            let _e547 = phi_773_;
                            local_6 = _e545;
                            local_7 = _e547;
                            local_8 = _e537;
                            local_9 = _e537;
                            local_10 = _e537;
                            if (_e535.member < _e535.member_1) {
                                phi_761_ = type_8((_e535.member + 1u), _e535.member_1);
                                phi_796_ = type_8(1u, _e535.member);
                            } else {
                                phi_761_ = _e535;
                                phi_796_ = type_8(0u, type_8().member_1);
                            }
                            let _e560 = phi_761_;
                            let _e562 = phi_796_;
                            if (bitcast<i32>(_e562.member) != 0i) {
                                if (_e543.member_4 <= _e541.member_4) {
                                    phi_816_ = select(true, false, (_e543.member_4 <= _e539.member_4));
                                } else {
                                    phi_816_ = true;
                                }
                                let _e573 = phi_816_;
                                if _e573 {
                                    phi_827_ = select(2u, 1u, (_e541.member_4 <= _e539.member_4));
                                } else {
                                    phi_827_ = 0u;
                                }
                                let _e578 = phi_827_;
                                let _e579 = (_e578 == 0u);
                                if _e579 {
                                    phi_852_ = _e543.member_4;
                                    phi_853_ = _e543.member_3;
                                    phi_854_ = _e543.member_2;
                                    phi_855_ = _e543.member_1;
                                } else {
                                    if (_e578 == 1u) {
                                        phi_848_ = _e541.member_4;
                                        phi_849_ = _e541.member_3;
                                        phi_850_ = _e541.member_2;
                                        phi_851_ = _e541.member_1;
                                    } else {
                                        phi_848_ = _e539.member_4;
                                        phi_849_ = _e539.member_3;
                                        phi_850_ = _e539.member_2;
                                        phi_851_ = _e539.member_1;
                                    }
                                    let _e589 = phi_848_;
                                    let _e591 = phi_849_;
                                    let _e593 = phi_850_;
                                    let _e595 = phi_851_;
                                    phi_852_ = _e589;
                                    phi_853_ = _e591;
                                    phi_854_ = _e593;
                                    phi_855_ = _e595;
                                }
                                let _e600 = phi_852_;
                                let _e602 = phi_853_;
                                let _e604 = phi_854_;
                                let _e606 = phi_855_;
                                if (_e600 >= 340282350000000000000000000000000000000f) {
                                    phi_2095_ = vec3<f32>();
                                    phi_2096_ = type_38();
                                    phi_2097_ = type_38();
                                    phi_2098_ = type_38();
                                    phi_2099_ = f32();
                                    phi_2100_ = f32();
                                    phi_2101_ = false;
                                } else {
                                    let _e608 = (1f - _e545);
                                    let _e609 = (_e547 * _e608);
                                    let _e610 = (_e609 < 0.001f);
                                    if _e610 {
                                        phi_2088_ = vec3<f32>();
                                        phi_2089_ = type_38();
                                        phi_2090_ = type_38();
                                        phi_2091_ = type_38();
                                        phi_2092_ = f32();
                                        phi_2093_ = f32();
                                    } else {
                                        let _e617 = (_e606 < 0f);
                                        if (_e604 < 10u) {
                                        } else {
                                            phi_2209_ = true;
                                            break;
                                        }
                                        let _e622 = params.member.member_2[_e604];
                                        let _e623 = (_e604 & 31u);
                                        let _e625 = (1u << bitcast<u32>(_e623));
                                        let _e626 = (_e625 - 1u);
                                        let _e629 = ((_e392.x + _e626) >> bitcast<u32>(_e623));
                                        let _e632 = ((_e392.y + _e626) >> bitcast<u32>(_e623));
                                        let _e635 = ((_e392.z + _e626) >> bitcast<u32>(_e623));
                                        let _e637 = (1f / f32(_e625));
                                        if _e579 {
                                            phi_911_ = _e629;
                                        } else {
                                            phi_911_ = select(_e635, _e632, (_e578 == 1u));
                                        }
                                        let _e641 = phi_911_;
                                        if (_e602 < 0i) {
                                            phi_1766_ = vec4<f32>();
                                            phi_1767_ = true;
                                        } else {
                                            let _e644 = (_e602 >= bitcast<i32>(_e641));
                                            if _e644 {
                                                phi_1765_ = vec4<f32>();
                                            } else {
                                                let _e645 = f32(_e602);
                                                if _e579 {
                                                    phi_928_ = _e645;
                                                } else {
                                                    phi_928_ = (((_e150 + (_e387 * _e600)) * _e637) - 0.5f);
                                                }
                                                let _e649 = phi_928_;
                                                let _e650 = floor(_e649);
                                                let _e658 = select(0i, select(select(i32(_e650), i32(-2147483648), (_e650 < -2147483600f)), 2147483647i, (_e650 > 2147483500f)), (_e650 == _e650));
                                                let _e660 = (bitcast<i32>(_e629) - 1i);
                                                if (_e649 >= -0.5f) {
                                                    phi_949_ = (_e649 <= (f32(_e660) + 0.5f));
                                                } else {
                                                    phi_949_ = false;
                                                }
                                                let _e666 = phi_949_;
                                                let _e667 = (_e658 >= 0i);
                                                let _e668 = (_e658 < _e660);
                                                if _e667 {
                                                    phi_961_ = bitcast<u32>(select(_e658, _e660, (_e660 < _e658)));
                                                } else {
                                                    phi_961_ = 0u;
                                                }
                                                let _e673 = phi_961_;
                                                if _e668 {
                                                    let _e674 = (_e658 + 1i);
                                                    phi_972_ = bitcast<u32>(select(0i, _e674, (0i < _e674)));
                                                } else {
                                                    phi_972_ = 0u;
                                                }
                                                let _e679 = phi_972_;
                                                if _e667 {
                                                    phi_980_ = select(0f, (_e649 - _e650), _e668);
                                                } else {
                                                    phi_980_ = 1f;
                                                }
                                                let _e682 = phi_980_;
                                                let _e684 = (_e673 >> bitcast<u32>(2u));
                                                let _e686 = (_e679 >> bitcast<u32>(2u));
                                                let _e693 = ((_e673 & 1u) | (((_e673 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                                let _e700 = ((_e679 & 1u) | (((_e679 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                                if _e666 {
                                                    phi_1019_ = (1f - _e682);
                                                } else {
                                                    phi_1019_ = 0f;
                                                }
                                                let _e703 = phi_1019_;
                                                let _e704 = select(0f, _e682, _e666);
                                                let _e705 = (_e578 == 1u);
                                                if _e705 {
                                                    phi_1030_ = _e645;
                                                } else {
                                                    phi_1030_ = (((_e151 + (_e388 * _e600)) * _e637) - 0.5f);
                                                }
                                                let _e709 = phi_1030_;
                                                let _e711 = floor(_e709);
                                                let _e719 = select(0i, select(select(i32(_e711), i32(-2147483648), (_e711 < -2147483600f)), 2147483647i, (_e711 > 2147483500f)), (_e711 == _e711));
                                                let _e721 = (bitcast<i32>(_e632) - 1i);
                                                if (_e709 >= -0.5f) {
                                                    phi_1052_ = (_e709 <= (f32(_e721) + 0.5f));
                                                } else {
                                                    phi_1052_ = false;
                                                }
                                                let _e727 = phi_1052_;
                                                let _e728 = (_e719 >= 0i);
                                                let _e729 = (_e719 < _e721);
                                                if _e728 {
                                                    phi_1064_ = bitcast<u32>(select(_e719, _e721, (_e721 < _e719)));
                                                } else {
                                                    phi_1064_ = 0u;
                                                }
                                                let _e734 = phi_1064_;
                                                if _e729 {
                                                    let _e735 = (_e719 + 1i);
                                                    phi_1075_ = bitcast<u32>(select(0i, _e735, (0i < _e735)));
                                                } else {
                                                    phi_1075_ = 0u;
                                                }
                                                let _e740 = phi_1075_;
                                                if _e728 {
                                                    phi_1083_ = select(0f, (_e709 - _e711), _e729);
                                                } else {
                                                    phi_1083_ = 1f;
                                                }
                                                let _e743 = phi_1083_;
                                                let _e746 = ((_e734 >> bitcast<u32>(2u)) * _e622.x);
                                                let _e749 = ((_e740 >> bitcast<u32>(2u)) * _e622.x);
                                                let _e758 = (((_e734 & 1u) << bitcast<u32>(1u)) | (((_e734 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                                let _e767 = (((_e740 & 1u) << bitcast<u32>(1u)) | (((_e740 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                                if _e727 {
                                                    phi_1122_ = (1f - _e743);
                                                } else {
                                                    phi_1122_ = 0f;
                                                }
                                                let _e770 = phi_1122_;
                                                let _e771 = select(0f, _e743, _e727);
                                                let _e772 = (_e578 == 2u);
                                                if _e772 {
                                                    phi_1133_ = _e645;
                                                } else {
                                                    phi_1133_ = (((_e152 + (_e389 * _e600)) * _e637) - 0.5f);
                                                }
                                                let _e776 = phi_1133_;
                                                let _e778 = floor(_e776);
                                                let _e786 = select(0i, select(select(i32(_e778), i32(-2147483648), (_e778 < -2147483600f)), 2147483647i, (_e778 > 2147483500f)), (_e778 == _e778));
                                                let _e788 = (bitcast<i32>(_e635) - 1i);
                                                if (_e776 >= -0.5f) {
                                                    phi_1155_ = (_e776 <= (f32(_e788) + 0.5f));
                                                } else {
                                                    phi_1155_ = false;
                                                }
                                                let _e794 = phi_1155_;
                                                let _e795 = (_e786 >= 0i);
                                                let _e796 = (_e786 < _e788);
                                                if _e795 {
                                                    phi_1167_ = bitcast<u32>(select(_e786, _e788, (_e788 < _e786)));
                                                } else {
                                                    phi_1167_ = 0u;
                                                }
                                                let _e801 = phi_1167_;
                                                if _e796 {
                                                    let _e802 = (_e786 + 1i);
                                                    phi_1178_ = bitcast<u32>(select(0i, _e802, (0i < _e802)));
                                                } else {
                                                    phi_1178_ = 0u;
                                                }
                                                let _e807 = phi_1178_;
                                                if _e795 {
                                                    phi_1186_ = select(0f, (_e776 - _e778), _e796);
                                                } else {
                                                    phi_1186_ = 1f;
                                                }
                                                let _e810 = phi_1186_;
                                                let _e813 = ((_e801 >> bitcast<u32>(1u)) * _e622.y);
                                                let _e816 = ((_e807 >> bitcast<u32>(1u)) * _e622.y);
                                                let _e819 = ((_e801 & 1u) << bitcast<u32>(2u));
                                                let _e822 = ((_e807 & 1u) << bitcast<u32>(2u));
                                                if _e794 {
                                                    phi_1225_ = (1f - _e810);
                                                } else {
                                                    phi_1225_ = 0f;
                                                }
                                                let _e825 = phi_1225_;
                                                let _e826 = select(0f, _e810, _e794);
                                                if _e579 {
                                                    phi_1252_ = _e826;
                                                    phi_1253_ = _e825;
                                                    phi_1254_ = _e822;
                                                    phi_1255_ = _e819;
                                                    phi_1256_ = _e816;
                                                    phi_1257_ = _e813;
                                                    phi_1258_ = _e771;
                                                    phi_1259_ = _e770;
                                                    phi_1260_ = _e767;
                                                    phi_1261_ = _e758;
                                                    phi_1262_ = _e749;
                                                    phi_1263_ = _e746;
                                                    phi_1264_ = _e693;
                                                    phi_1265_ = _e684;
                                                } else {
                                                    phi_1252_ = select(_e771, _e704, _e705);
                                                    phi_1253_ = select(_e770, _e703, _e705);
                                                    phi_1254_ = select(_e767, _e700, _e705);
                                                    phi_1255_ = select(_e758, _e693, _e705);
                                                    phi_1256_ = select(_e749, _e686, _e705);
                                                    phi_1257_ = select(_e746, _e684, _e705);
                                                    phi_1258_ = select(_e704, _e826, _e705);
                                                    phi_1259_ = select(_e703, _e825, _e705);
                                                    phi_1260_ = select(_e700, _e822, _e705);
                                                    phi_1261_ = select(_e693, _e819, _e705);
                                                    phi_1262_ = select(_e686, _e816, _e705);
                                                    phi_1263_ = select(_e684, _e813, _e705);
                                                    phi_1264_ = select(_e819, _e758, _e705);
                                                    phi_1265_ = select(_e813, _e746, _e705);
                                                }
                                                let _e842 = phi_1252_;
                                                let _e844 = phi_1253_;
                                                let _e846 = phi_1254_;
                                                let _e848 = phi_1255_;
                                                let _e850 = phi_1256_;
                                                let _e852 = phi_1257_;
                                                let _e854 = phi_1258_;
                                                let _e856 = phi_1259_;
                                                let _e858 = phi_1260_;
                                                let _e860 = phi_1261_;
                                                let _e862 = phi_1262_;
                                                let _e864 = phi_1263_;
                                                let _e866 = phi_1264_;
                                                let _e868 = phi_1265_;
                                                phi_1268_ = type_8(0u, 4u);
                                                phi_1271_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                loop {
                                                    let _e870 = phi_1268_;
                                                    let _e872 = phi_1271_;
                                                    local_16 = _e872;
                                                    if (_e870.member < _e870.member_1) {
                                                        phi_1269_ = type_8((_e870.member + 1u), _e870.member_1);
                                                        phi_1294_ = type_8(1u, _e870.member);
                                                    } else {
                                                        phi_1269_ = _e870;
                                                        phi_1294_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e885 = phi_1269_;
                                                    let _e887 = phi_1294_;
                                                    let _e891 = (bitcast<i32>(_e887.member) != 0i);
                                                    if _e891 {
                                                        let _e893 = ((_e887.member_1 & 1u) == 1u);
                                                        let _e895 = ((_e887.member_1 & 2u) == 2u);
                                                        let _e898 = (select(_e856, _e854, _e893) * select(_e844, _e842, _e895));
                                                        let _e904 = (((_e622.z + _e868) + select(_e864, _e862, _e893)) + select(_e852, _e850, _e895));
                                                        let _e909 = (2u * _e904);
                                                        let _e911 = cells.member[_e909];
                                                        if (_e898 > 0f) {
                                                            let _e913 = (((_e866 | select(_e860, _e858, _e893)) | select(_e848, _e846, _e895)) & 31u);
                                                            if (((_e911 >> bitcast<u32>(_e913)) & 1u) == 1u) {
                                                                let _e920 = params.member.member_8;
                                                                let _e921 = (_e920 == 1u);
                                                                if (_e604 == 0u) {
                                                                    let _e947 = (_e904 * 6u);
                                                                    let _e950 = cells.member[(_e909 + 1u)];
                                                                    let _e952 = facet_bits.member[_e947];
                                                                    let _e955 = ((1u << bitcast<u32>(_e913)) - 1u);
                                                                    let _e964 = facet_bits.member[(_e947 + 1u)];
                                                                    let _e974 = facet_bits.member[(_e947 + 2u)];
                                                                    let _e984 = facet_bits.member[(_e947 + 3u)];
                                                                    let _e994 = facet_bits.member[(_e947 + 4u)];
                                                                    let _e1004 = facet_bits.member[(_e947 + 5u)];
                                                                    let _e1007 = ((((((_e950 + countOneBits((_e952 & _e955))) + countOneBits((_e964 & _e955))) + countOneBits((_e974 & _e955))) + countOneBits((_e984 & _e955))) + countOneBits((_e994 & _e955))) + countOneBits((_e1004 & _e955)));
                                                                    let _e1011 = (((((((_e952 >> bitcast<u32>(_e913)) & 1u) + ((_e964 >> bitcast<u32>(_e913)) & 1u)) + ((_e974 >> bitcast<u32>(_e913)) & 1u)) + ((_e984 >> bitcast<u32>(_e913)) & 1u)) + ((_e994 >> bitcast<u32>(_e913)) & 1u)) + ((_e1004 >> bitcast<u32>(_e913)) & 1u));
                                                                    if _e921 {
                                                                        phi_1452_ = type_8(_e1007, (_e1007 + _e1011));
                                                                        phi_1455_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e1132 = phi_1452_;
                                                                            let _e1134 = phi_1455_;
                                                                            local_15 = _e1134;
                                                                            if (_e1132.member < _e1132.member_1) {
                                                                                phi_1453_ = type_8((_e1132.member + 1u), _e1132.member_1);
                                                                                phi_1478_ = type_8(1u, _e1132.member);
                                                                            } else {
                                                                                phi_1453_ = _e1132;
                                                                                phi_1478_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e1147 = phi_1453_;
                                                                            let _e1149 = phi_1478_;
                                                                            let _e1153 = (bitcast<i32>(_e1149.member) != 0i);
                                                                            if _e1153 {
                                                                                let _e1154 = (2u * _e1149.member_1);
                                                                                let _e1157 = radiance.member[_e1154][0u];
                                                                                let _e1160 = radiance.member[_e1154][1u];
                                                                                let _e1163 = radiance.member[_e1154][2u];
                                                                                let _e1164 = (_e1154 + 1u);
                                                                                let _e1167 = radiance.member[_e1164][0u];
                                                                                let _e1170 = radiance.member[_e1164][1u];
                                                                                let _e1173 = radiance.member[_e1164][2u];
                                                                                let _e1182 = facets.member[_e1149.member_1].member_2;
                                                                                let _e1191 = sqrt((((_e1182[0] * _e1182[0]) + (_e1182[1] * _e1182[1])) + (_e1182[2] * _e1182[2])));
                                                                                phi_1456_ = vec4<f32>((_e1134.x + (select(_e1167, _e1157, (_e1157 > _e1167)) * _e1191)), (_e1134.y + (select(_e1170, _e1160, (_e1160 > _e1170)) * _e1191)), (_e1134.z + (select(_e1173, _e1163, (_e1163 > _e1173)) * _e1191)), (_e1134.w + _e1191));
                                                                            } else {
                                                                                phi_1456_ = vec4<f32>();
                                                                            }
                                                                            let _e1205 = phi_1456_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_1452_ = _e1147;
                                                                                phi_1455_ = _e1205;
                                                                                break if !(_e1153);
                                                                            }
                                                                        }
                                                                        let _e1758 = local_15;
                                                                        phi_1695_ = _e1758;
                                                                    } else {
                                                                        let _e1012 = select(1f, -1f, _e617);
                                                                        phi_1574_ = type_8(_e1007, (_e1007 + _e1011));
                                                                        phi_1577_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        phi_1579_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                        loop {
                                                                            let _e1019 = phi_1574_;
                                                                            let _e1021 = phi_1577_;
                                                                            let _e1023 = phi_1579_;
                                                                            local = _e1021;
                                                                            local_1 = _e1023;
                                                                            local_2 = _e1021;
                                                                            local_3 = _e1021;
                                                                            local_4 = _e1021;
                                                                            local_5 = _e1023;
                                                                            local_14 = _e1023;
                                                                            if (_e1019.member < _e1019.member_1) {
                                                                                phi_1575_ = type_8((_e1019.member + 1u), _e1019.member_1);
                                                                                phi_1602_ = type_8(1u, _e1019.member);
                                                                            } else {
                                                                                phi_1575_ = _e1019;
                                                                                phi_1602_ = type_8(0u, type_8().member_1);
                                                                            }
                                                                            let _e1036 = phi_1575_;
                                                                            let _e1038 = phi_1602_;
                                                                            let _e1042 = (bitcast<i32>(_e1038.member) != 0i);
                                                                            if _e1042 {
                                                                                let _e1045 = facets.member[_e1038.member_1].member_2;
                                                                                let _e1054 = -((((select(0f, _e1012, _e579) * _e1045[0]) + (select(0f, _e1012, _e705) * _e1045[1])) + (select(0f, _e1012, _e772) * _e1045[2])));
                                                                                if (_e1054 > 0f) {
                                                                                    let _e1077 = radiance.member[(2u * _e1038.member_1)];
                                                                                    phi_1671_ = _e1021;
                                                                                    phi_1672_ = vec4<f32>((_e1023.x + (_e1077.x * _e1054)), (_e1023.y + (_e1077.y * _e1054)), (_e1023.z + (_e1077.z * _e1054)), (_e1023.w + _e1054));
                                                                                } else {
                                                                                    let _e1059 = radiance.member[((2u * _e1038.member_1) + 1u)];
                                                                                    phi_1671_ = vec4<f32>((_e1021.x - (_e1059.x * _e1054)), (_e1021.y - (_e1059.y * _e1054)), (_e1021.z - (_e1059.z * _e1054)), (_e1021.w - _e1054));
                                                                                    phi_1672_ = _e1023;
                                                                                }
                                                                                let _e1094 = phi_1671_;
                                                                                let _e1096 = phi_1672_;
                                                                                phi_1578_ = _e1094;
                                                                                phi_1580_ = _e1096;
                                                                            } else {
                                                                                phi_1578_ = vec4<f32>();
                                                                                phi_1580_ = vec4<f32>();
                                                                            }
                                                                            let _e1098 = phi_1578_;
                                                                            let _e1100 = phi_1580_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_1574_ = _e1036;
                                                                                phi_1577_ = _e1098;
                                                                                phi_1579_ = _e1100;
                                                                                break if !(_e1042);
                                                                            }
                                                                        }
                                                                        let _e1103 = local;
                                                                        let _e1106 = local_1;
                                                                        if (_e1103.w > _e1106.w) {
                                                                            let _e1109 = (_e1103.w - _e1106.w);
                                                                            let _e1110 = (_e1109 / _e1103.w);
                                                                            let _e1112 = local_2;
                                                                            let _e1116 = local_3;
                                                                            let _e1120 = local_4;
                                                                            let _e1125 = local_5;
                                                                            phi_1694_ = (_e1125 + vec4<f32>((_e1112.x * _e1110), (_e1116.y * _e1110), (_e1120.z * _e1110), _e1109));
                                                                        } else {
                                                                            let _e1750 = local_14;
                                                                            phi_1694_ = _e1750;
                                                                        }
                                                                        let _e1128 = phi_1694_;
                                                                        phi_1695_ = _e1128;
                                                                    }
                                                                    let _e1208 = phi_1695_;
                                                                    if (_e1208.w > 1f) {
                                                                        phi_1709_ = vec4<f32>((_e1208.x / _e1208.w), (_e1208.y / _e1208.w), (_e1208.z / _e1208.w), 1f);
                                                                    } else {
                                                                        phi_1709_ = _e1208;
                                                                    }
                                                                    let _e1219 = phi_1709_;
                                                                    phi_1742_ = _e1219;
                                                                } else {
                                                                    let _e925 = cells.member[(_e909 + 1u)];
                                                                    let _e931 = (_e925 + countOneBits((_e911 & ((1u << bitcast<u32>(_e913)) - 1u))));
                                                                    if _e921 {
                                                                        phi_1729_ = _e931;
                                                                    } else {
                                                                        phi_1729_ = (((6u * _e931) + (2u * _e578)) + select(0u, 1u, _e617));
                                                                    }
                                                                    let _e938 = phi_1729_;
                                                                    if ((_e604 & 1u) == 1u) {
                                                                        let _e944 = odd.member[_e938];
                                                                        phi_1741_ = _e944;
                                                                    } else {
                                                                        let _e942 = even.member[_e938];
                                                                        phi_1741_ = _e942;
                                                                    }
                                                                    let _e946 = phi_1741_;
                                                                    phi_1742_ = _e946;
                                                                }
                                                                let _e1221 = phi_1742_;
                                                                phi_1763_ = vec4<f32>((_e872.x + (_e1221.x * _e898)), (_e872.y + (_e1221.y * _e898)), (_e872.z + (_e1221.z * _e898)), (_e872.w + (_e1221.w * _e898)));
                                                            } else {
                                                                phi_1763_ = _e872;
                                                            }
                                                            let _e1240 = phi_1763_;
                                                            phi_1764_ = _e1240;
                                                        } else {
                                                            phi_1764_ = _e872;
                                                        }
                                                        let _e1242 = phi_1764_;
                                                        phi_1272_ = _e1242;
                                                    } else {
                                                        phi_1272_ = vec4<f32>();
                                                    }
                                                    let _e1244 = phi_1272_;
                                                    continue;
                                                    continuing {
                                                        phi_1268_ = _e885;
                                                        phi_1271_ = _e1244;
                                                        break if !(_e891);
                                                    }
                                                }
                                                let _e1766 = local_16;
                                                phi_1765_ = _e1766;
                                            }
                                            let _e1247 = phi_1765_;
                                            phi_1766_ = _e1247;
                                            phi_1767_ = _e644;
                                        }
                                        let _e1249 = phi_1766_;
                                        let _e1251 = phi_1767_;
                                        let _e1253 = select(_e1249, vec4<f32>(0f, 0f, 0f, 0f), vec4(_e1251));
                                        if (_e1253.w > 0f) {
                                            let _e1260 = select(_e608, _e1253.w, (_e1253.w < _e608));
                                            let _e1265 = ((_e547 * _e1260) / _e1253.w);
                                            phi_1811_ = vec3<f32>((_e537.x + (_e1253.x * _e1265)), (_e537.y + (_e1253.y * _e1265)), (_e537.z + (_e1253.z * _e1265)));
                                            phi_1812_ = (_e545 + _e1260);
                                            phi_1813_ = _e547;
                                        } else {
                                            let _e1256 = (_e578 == _e404);
                                            phi_1811_ = _e537;
                                            phi_1812_ = select(_e545, 0f, _e1256);
                                            phi_1813_ = select(_e547, _e609, _e1256);
                                        }
                                        let _e1278 = phi_1811_;
                                        let _e1280 = phi_1812_;
                                        let _e1282 = phi_1813_;
                                        let _e1283 = (_e366 * _e600);
                                        let _e1285 = ((_e369 * _e143) + ((_e369 * _e363.z) * _e600));
                                        let _e1287 = select(_e1285, _e1283, (_e1283 < _e1285));
                                        let _e1294 = ((bitcast<u32>((select(1f, _e1287, (_e1287 > 1f)) * _e361)) >> bitcast<u32>(23i)) - 127u);
                                        let _e1296 = (_e392.w - 1u);
                                        let _e1298 = select(_e1294, _e1296, (_e1296 < _e1294));
                                        if _e579 {
                                            let _e1459 = (_e543.member_1 < 0f);
                                            if _e1459 {
                                                phi_1856_ = (_e543.member_3 - 1i);
                                            } else {
                                                phi_1856_ = (_e543.member_3 + 1i);
                                            }
                                            let _e1467 = phi_1856_;
                                            let _e1473 = type_38(_e543.member, _e543.member_1, _e543.member_2, _e1467, _e543.member_4);
                                            if (((_e543.member_3 & 1i) == 0i) == _e1459) {
                                                if (_e1298 > _e543.member_2) {
                                                    let _e1482 = type_38(_e1473.member, _e1473.member_1, (_e543.member_2 + 1u), _e1473.member_3, _e1473.member_4);
                                                    phi_1871_ = type_38(_e1482.member, _e1482.member_1, _e1482.member_2, (_e1467 >> bitcast<u32>(1i)), _e1482.member_4);
                                                } else {
                                                    phi_1871_ = _e1473;
                                                }
                                                let _e1492 = phi_1871_;
                                                phi_1872_ = _e1492;
                                            } else {
                                                phi_1872_ = _e1473;
                                            }
                                            let _e1494 = phi_1872_;
                                            let _e1496 = (_e1494.member_2 & 31u);
                                            let _e1498 = (1u << bitcast<u32>(_e1496));
                                            if (_e1494.member_1 < 0f) {
                                                phi_1891_ = (_e1494.member_3 < 0i);
                                            } else {
                                                phi_1891_ = (_e1494.member_3 >= bitcast<i32>((((_e392.x + _e1498) - 1u) >> bitcast<u32>(_e1496))));
                                            }
                                            let _e1511 = phi_1891_;
                                            if _e1511 {
                                                phi_1914_ = f32();
                                                phi_1915_ = true;
                                            } else {
                                                let _e1518 = (abs(_e1494.member_1) < 0.000001f);
                                                if _e1518 {
                                                    phi_1913_ = f32();
                                                } else {
                                                    phi_1913_ = ((((f32(_e1494.member_3) + 0.5f) * f32(_e1498)) - _e1494.member) / _e1494.member_1);
                                                }
                                                let _e1523 = phi_1913_;
                                                phi_1914_ = _e1523;
                                                phi_1915_ = _e1518;
                                            }
                                            let _e1525 = phi_1914_;
                                            let _e1527 = phi_1915_;
                                            phi_2085_ = _e539;
                                            phi_2086_ = _e541;
                                            phi_2087_ = type_38(_e1494.member, _e1494.member_1, _e1494.member_2, _e1494.member_3, select(_e1525, 340282350000000000000000000000000000000f, _e1527));
                                        } else {
                                            if (_e578 == 1u) {
                                                let _e1378 = (_e541.member_1 < 0f);
                                                if _e1378 {
                                                    phi_1939_ = (_e541.member_3 - 1i);
                                                } else {
                                                    phi_1939_ = (_e541.member_3 + 1i);
                                                }
                                                let _e1386 = phi_1939_;
                                                let _e1392 = type_38(_e541.member, _e541.member_1, _e541.member_2, _e1386, _e541.member_4);
                                                if (((_e541.member_3 & 1i) == 0i) == _e1378) {
                                                    if (_e1298 > _e541.member_2) {
                                                        let _e1401 = type_38(_e1392.member, _e1392.member_1, (_e541.member_2 + 1u), _e1392.member_3, _e1392.member_4);
                                                        phi_1954_ = type_38(_e1401.member, _e1401.member_1, _e1401.member_2, (_e1386 >> bitcast<u32>(1i)), _e1401.member_4);
                                                    } else {
                                                        phi_1954_ = _e1392;
                                                    }
                                                    let _e1411 = phi_1954_;
                                                    phi_1955_ = _e1411;
                                                } else {
                                                    phi_1955_ = _e1392;
                                                }
                                                let _e1413 = phi_1955_;
                                                let _e1415 = (_e1413.member_2 & 31u);
                                                let _e1417 = (1u << bitcast<u32>(_e1415));
                                                if (_e1413.member_1 < 0f) {
                                                    phi_1974_ = (_e1413.member_3 < 0i);
                                                } else {
                                                    phi_1974_ = (_e1413.member_3 >= bitcast<i32>((((_e392.y + _e1417) - 1u) >> bitcast<u32>(_e1415))));
                                                }
                                                let _e1430 = phi_1974_;
                                                if _e1430 {
                                                    phi_1997_ = f32();
                                                    phi_1998_ = true;
                                                } else {
                                                    let _e1437 = (abs(_e1413.member_1) < 0.000001f);
                                                    if _e1437 {
                                                        phi_1996_ = f32();
                                                    } else {
                                                        phi_1996_ = ((((f32(_e1413.member_3) + 0.5f) * f32(_e1417)) - _e1413.member) / _e1413.member_1);
                                                    }
                                                    let _e1442 = phi_1996_;
                                                    phi_1997_ = _e1442;
                                                    phi_1998_ = _e1437;
                                                }
                                                let _e1444 = phi_1997_;
                                                let _e1446 = phi_1998_;
                                                phi_2083_ = _e539;
                                                phi_2084_ = type_38(_e1413.member, _e1413.member_1, _e1413.member_2, _e1413.member_3, select(_e1444, 340282350000000000000000000000000000000f, _e1446));
                                            } else {
                                                let _e1301 = (_e539.member_1 < 0f);
                                                if _e1301 {
                                                    phi_2018_ = (_e539.member_3 - 1i);
                                                } else {
                                                    phi_2018_ = (_e539.member_3 + 1i);
                                                }
                                                let _e1309 = phi_2018_;
                                                let _e1315 = type_38(_e539.member, _e539.member_1, _e539.member_2, _e1309, _e539.member_4);
                                                if (((_e539.member_3 & 1i) == 0i) == _e1301) {
                                                    if (_e1298 > _e539.member_2) {
                                                        let _e1324 = type_38(_e1315.member, _e1315.member_1, (_e539.member_2 + 1u), _e1315.member_3, _e1315.member_4);
                                                        phi_2033_ = type_38(_e1324.member, _e1324.member_1, _e1324.member_2, (_e1309 >> bitcast<u32>(1i)), _e1324.member_4);
                                                    } else {
                                                        phi_2033_ = _e1315;
                                                    }
                                                    let _e1334 = phi_2033_;
                                                    phi_2034_ = _e1334;
                                                } else {
                                                    phi_2034_ = _e1315;
                                                }
                                                let _e1336 = phi_2034_;
                                                let _e1338 = (_e1336.member_2 & 31u);
                                                let _e1340 = (1u << bitcast<u32>(_e1338));
                                                if (_e1336.member_1 < 0f) {
                                                    phi_2053_ = (_e1336.member_3 < 0i);
                                                } else {
                                                    phi_2053_ = (_e1336.member_3 >= bitcast<i32>((((_e392.z + _e1340) - 1u) >> bitcast<u32>(_e1338))));
                                                }
                                                let _e1353 = phi_2053_;
                                                if _e1353 {
                                                    phi_2076_ = f32();
                                                    phi_2077_ = true;
                                                } else {
                                                    let _e1360 = (abs(_e1336.member_1) < 0.000001f);
                                                    if _e1360 {
                                                        phi_2075_ = f32();
                                                    } else {
                                                        phi_2075_ = ((((f32(_e1336.member_3) + 0.5f) * f32(_e1340)) - _e1336.member) / _e1336.member_1);
                                                    }
                                                    let _e1365 = phi_2075_;
                                                    phi_2076_ = _e1365;
                                                    phi_2077_ = _e1360;
                                                }
                                                let _e1367 = phi_2076_;
                                                let _e1369 = phi_2077_;
                                                phi_2083_ = type_38(_e1336.member, _e1336.member_1, _e1336.member_2, _e1336.member_3, select(_e1367, 340282350000000000000000000000000000000f, _e1369));
                                                phi_2084_ = _e541;
                                            }
                                            let _e1455 = phi_2083_;
                                            let _e1457 = phi_2084_;
                                            phi_2085_ = _e1455;
                                            phi_2086_ = _e1457;
                                            phi_2087_ = _e543;
                                        }
                                        let _e1536 = phi_2085_;
                                        let _e1538 = phi_2086_;
                                        let _e1540 = phi_2087_;
                                        phi_2088_ = _e1278;
                                        phi_2089_ = _e1536;
                                        phi_2090_ = _e1538;
                                        phi_2091_ = _e1540;
                                        phi_2092_ = _e1280;
                                        phi_2093_ = _e1282;
                                    }
                                    let _e1542 = phi_2088_;
                                    let _e1544 = phi_2089_;
                                    let _e1546 = phi_2090_;
                                    let _e1548 = phi_2091_;
                                    let _e1550 = phi_2092_;
                                    let _e1552 = phi_2093_;
                                    phi_2095_ = _e1542;
                                    phi_2096_ = _e1544;
                                    phi_2097_ = _e1546;
                                    phi_2098_ = _e1548;
                                    phi_2099_ = _e1550;
                                    phi_2100_ = _e1552;
                                    phi_2101_ = select(true, false, _e610);
                                }
                                let _e1555 = phi_2095_;
                                let _e1557 = phi_2096_;
                                let _e1559 = phi_2097_;
                                let _e1561 = phi_2098_;
                                let _e1563 = phi_2099_;
                                let _e1565 = phi_2100_;
                                let _e1567 = phi_2101_;
                                phi_764_ = _e1555;
                                phi_766_ = _e1557;
                                phi_768_ = _e1559;
                                phi_770_ = _e1561;
                                phi_772_ = _e1563;
                                phi_774_ = _e1565;
                                phi_2103_ = _e1567;
                            } else {
                                phi_764_ = vec3<f32>();
                                phi_766_ = type_38();
                                phi_768_ = type_38();
                                phi_770_ = type_38();
                                phi_772_ = f32();
                                phi_774_ = f32();
                                phi_2103_ = false;
                            }
                            let _e1569 = phi_764_;
                            let _e1571 = phi_766_;
                            let _e1573 = phi_768_;
                            let _e1575 = phi_770_;
                            let _e1577 = phi_772_;
                            let _e1579 = phi_774_;
                            let _e1581 = phi_2103_;
                            continue;
                            continuing {
                                phi_760_ = _e560;
                                phi_763_ = _e1569;
                                phi_765_ = _e1571;
                                phi_767_ = _e1573;
                                phi_769_ = _e1575;
                                phi_771_ = _e1577;
                                phi_773_ = _e1579;
                                phi_2209_ = _e210;
                                break if !(_e1581);
                            }
                        }
                        let _e1584 = phi_2209_;
                        phi_2353_ = _e1584;
                        if _e1584 {
                            break;
                        }
                        let _e1586 = local_6;
                        let _e1589 = local_7;
                        let _e1590 = (_e1589 * (1f - _e1586));
                        let _e1592 = local_8;
                        let _e1595 = local_9;
                        let _e1598 = local_10;
                        let _e1602 = params.member.member_5;
                        phi_2354_ = _e1584;
                        phi_309_ = vec3<f32>((_e214.x + ((_e1592.x + (_e1602.x * _e1590)) * _e238.w)), (_e214.y + ((_e1595.y + (_e1602.y * _e1590)) * _e238.w)), (_e214.z + ((_e1598.z + (_e1602.z * _e1590)) * _e238.w)));
                    } else {
                        phi_2354_ = _e210;
                        phi_309_ = vec3<f32>();
                    }
                    let _e1624 = phi_2354_;
                    let _e1626 = phi_309_;
                    continue;
                    continuing {
                        phi_2236_ = _e1624;
                        phi_305_ = _e227;
                        phi_308_ = _e1626;
                        phi_2353_ = _e1624;
                        break if !(_e233);
                    }
                }
                let _e1629 = phi_2353_;
                if _e1629 {
                    break;
                }
                let _e1631 = local_11;
                let _e1635 = local_12;
                let _e1639 = local_13;
                if (_e95 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e95] = vec4<f32>((_e1631.x * 3.1415927f), (_e1635.y * 3.1415927f), (_e1639.z * 3.1415927f), 0f);
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
