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
    var phi_229_: vec3<f32>;
    var phi_313_: bool;
    var phi_322_: u32;
    var phi_354_: i32;
    var phi_368_: bool;
    var phi_385_: f32;
    var phi_386_: f32;
    var phi_387_: bool;
    var phi_424_: i32;
    var phi_438_: bool;
    var phi_455_: f32;
    var phi_456_: f32;
    var phi_457_: bool;
    var phi_494_: i32;
    var phi_508_: bool;
    var phi_525_: f32;
    var phi_526_: f32;
    var phi_527_: bool;
    var phi_535_: type_8;
    var phi_538_: vec3<f32>;
    var phi_540_: type_41;
    var phi_542_: type_41;
    var phi_544_: type_41;
    var phi_546_: f32;
    var phi_548_: f32;
    var phi_536_: type_8;
    var phi_571_: type_8;
    var phi_591_: bool;
    var phi_602_: u32;
    var phi_623_: f32;
    var phi_624_: i32;
    var phi_625_: u32;
    var phi_626_: f32;
    var phi_627_: f32;
    var phi_628_: i32;
    var phi_629_: u32;
    var phi_630_: f32;
    var phi_686_: u32;
    var phi_703_: f32;
    var phi_724_: bool;
    var phi_736_: u32;
    var phi_747_: u32;
    var phi_755_: f32;
    var phi_794_: f32;
    var phi_805_: f32;
    var phi_827_: bool;
    var phi_839_: u32;
    var phi_850_: u32;
    var phi_858_: f32;
    var phi_897_: f32;
    var phi_908_: f32;
    var phi_930_: bool;
    var phi_942_: u32;
    var phi_953_: u32;
    var phi_961_: f32;
    var phi_1000_: f32;
    var phi_1027_: f32;
    var phi_1028_: f32;
    var phi_1029_: u32;
    var phi_1030_: u32;
    var phi_1031_: u32;
    var phi_1032_: u32;
    var phi_1033_: f32;
    var phi_1034_: f32;
    var phi_1035_: u32;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1039_: u32;
    var phi_1040_: u32;
    var phi_1043_: type_8;
    var phi_1046_: vec4<f32>;
    var phi_1044_: type_8;
    var phi_1069_: type_8;
    var phi_1504_: u32;
    var phi_1516_: vec4<f32>;
    var phi_1349_: type_8;
    var phi_1352_: vec4<f32>;
    var phi_1354_: vec4<f32>;
    var phi_1350_: type_8;
    var phi_1377_: type_8;
    var phi_1446_: vec4<f32>;
    var phi_1447_: vec4<f32>;
    var phi_1353_: vec4<f32>;
    var phi_1355_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_1469_: vec4<f32>;
    var phi_1227_: type_8;
    var phi_1230_: vec4<f32>;
    var phi_1228_: type_8;
    var phi_1253_: type_8;
    var phi_1231_: vec4<f32>;
    var phi_1470_: vec4<f32>;
    var phi_1484_: vec4<f32>;
    var phi_1517_: vec4<f32>;
    var phi_1538_: vec4<f32>;
    var phi_1539_: vec4<f32>;
    var phi_1047_: vec4<f32>;
    var phi_1540_: vec4<f32>;
    var phi_1541_: vec4<f32>;
    var phi_1542_: bool;
    var phi_1586_: vec3<f32>;
    var phi_1587_: f32;
    var phi_1588_: f32;
    var phi_1793_: i32;
    var phi_1808_: type_41;
    var phi_1809_: type_41;
    var phi_1828_: bool;
    var phi_1850_: f32;
    var phi_1851_: f32;
    var phi_1852_: bool;
    var phi_1714_: i32;
    var phi_1729_: type_41;
    var phi_1730_: type_41;
    var phi_1749_: bool;
    var phi_1771_: f32;
    var phi_1772_: f32;
    var phi_1773_: bool;
    var phi_1858_: type_41;
    var phi_1859_: type_41;
    var phi_1631_: i32;
    var phi_1646_: type_41;
    var phi_1647_: type_41;
    var phi_1666_: bool;
    var phi_1688_: f32;
    var phi_1689_: f32;
    var phi_1690_: bool;
    var phi_1860_: type_41;
    var phi_1861_: type_41;
    var phi_1862_: type_41;
    var phi_1863_: vec3<f32>;
    var phi_1864_: type_41;
    var phi_1865_: type_41;
    var phi_1866_: type_41;
    var phi_1867_: f32;
    var phi_1868_: f32;
    var phi_1870_: vec3<f32>;
    var phi_1871_: type_41;
    var phi_1872_: type_41;
    var phi_1873_: type_41;
    var phi_1874_: f32;
    var phi_1875_: f32;
    var phi_1876_: bool;
    var phi_539_: vec3<f32>;
    var phi_541_: type_41;
    var phi_543_: type_41;
    var phi_545_: type_41;
    var phi_547_: f32;
    var phi_549_: f32;
    var phi_1878_: bool;
    var phi_1931_: bool;
    var local_6: f32;
    var local_7: f32;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var phi_1905_: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e57 = gid_1;
            let _e71 = (_e57.x + (_e57.y * 2097152u));
            let _e72 = (_e71 < arrayLength((&out.member)));
            if _e72 {
                if (_e71 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e77 = surfels.member[_e71].member;
                let _e81 = surfels.member[_e71].member_1;
                let _e85 = surfels.member[_e71].member_2;
                let _e89 = surfels.member[_e71].member_4;
                if (_e81 == 4294967295u) {
                    phi_1905_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e96 = params.member.member_6;
                    let _e100 = (_e96.x - _e77[0]);
                    let _e101 = (_e96.y - _e77[1]);
                    let _e102 = (_e96.z - _e77[2]);
                    let _e107 = (((_e100 * _e100) + (_e101 * _e101)) + (_e102 * _e102));
                    if (_e107 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e110 = (1f / sqrt(_e107));
                        phi_229_ = vec3<f32>((_e100 * _e110), (_e101 * _e110), (_e102 * _e110));
                    } else {
                        phi_229_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e116 = phi_229_;
                    let _e128 = (2f * (((_e116.x * _e85[0]) + (_e116.y * _e85[1])) + (_e116.z * _e85[2])));
                    let _e132 = ((_e85[0] * _e128) - _e116.x);
                    let _e133 = ((_e85[1] * _e128) - _e116.y);
                    let _e134 = ((_e85[2] * _e128) - _e116.z);
                    let _e137 = params.member.member;
                    let _e153 = params.member.member_12;
                    let _e157 = (((_e77[0] - _e137.x) / _e137.w) + (_e89[0] * _e153));
                    let _e158 = (((_e77[1] - _e137.y) / _e137.w) + (_e89[1] * _e153));
                    let _e159 = (((_e77[2] - _e137.z) / _e137.w) + (_e89[2] * _e153));
                    let _e163 = params.member.member_6[3u];
                    let _e167 = params.member.member_13;
                    let _e173 = (((_e132 * _e89[0]) + (_e133 * _e89[1])) + (_e134 * _e89[2]));
                    let _e179 = params.member.member_1;
                    let _e180 = abs(_e132);
                    let _e181 = abs(_e133);
                    let _e182 = abs(_e134);
                    if (_e180 >= _e181) {
                        phi_313_ = select(true, false, (_e180 >= _e182));
                    } else {
                        phi_313_ = true;
                    }
                    let _e187 = phi_313_;
                    if _e187 {
                        phi_322_ = select(2u, 1u, (_e181 >= _e182));
                    } else {
                        phi_322_ = 0u;
                    }
                    let _e191 = phi_322_;
                    let _e194 = floor((_e157 - 0.5f));
                    let _e204 = -(floor((0.5f - _e157)));
                    let _e212 = (_e132 < 0f);
                    if _e212 {
                        phi_354_ = (select(0i, select(select(i32(_e204), i32(-2147483648), (_e204 < -2147483600f)), 2147483647i, (_e204 > 2147483500f)), (_e204 == _e204)) - 1i);
                    } else {
                        phi_354_ = (select(0i, select(select(i32(_e194), i32(-2147483648), (_e194 < -2147483600f)), 2147483647i, (_e194 > 2147483500f)), (_e194 == _e194)) + 1i);
                    }
                    let _e216 = phi_354_;
                    if _e212 {
                        phi_368_ = (_e216 < 0i);
                    } else {
                        phi_368_ = (_e216 >= bitcast<i32>(_e179.x));
                    }
                    let _e221 = phi_368_;
                    if _e221 {
                        phi_386_ = f32();
                        phi_387_ = true;
                    } else {
                        let _e224 = (_e180 < 0.000001f);
                        if _e224 {
                            phi_385_ = f32();
                        } else {
                            phi_385_ = (((f32(_e216) + 0.5f) - _e157) / _e132);
                        }
                        let _e228 = phi_385_;
                        phi_386_ = _e228;
                        phi_387_ = _e224;
                    }
                    let _e230 = phi_386_;
                    let _e232 = phi_387_;
                    let _e237 = floor((_e158 - 0.5f));
                    let _e247 = -(floor((0.5f - _e158)));
                    let _e255 = (_e133 < 0f);
                    if _e255 {
                        phi_424_ = (select(0i, select(select(i32(_e247), i32(-2147483648), (_e247 < -2147483600f)), 2147483647i, (_e247 > 2147483500f)), (_e247 == _e247)) - 1i);
                    } else {
                        phi_424_ = (select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < -2147483600f)), 2147483647i, (_e237 > 2147483500f)), (_e237 == _e237)) + 1i);
                    }
                    let _e259 = phi_424_;
                    if _e255 {
                        phi_438_ = (_e259 < 0i);
                    } else {
                        phi_438_ = (_e259 >= bitcast<i32>(_e179.y));
                    }
                    let _e264 = phi_438_;
                    if _e264 {
                        phi_456_ = f32();
                        phi_457_ = true;
                    } else {
                        let _e267 = (_e181 < 0.000001f);
                        if _e267 {
                            phi_455_ = f32();
                        } else {
                            phi_455_ = (((f32(_e259) + 0.5f) - _e158) / _e133);
                        }
                        let _e271 = phi_455_;
                        phi_456_ = _e271;
                        phi_457_ = _e267;
                    }
                    let _e273 = phi_456_;
                    let _e275 = phi_457_;
                    let _e280 = floor((_e159 - 0.5f));
                    let _e290 = -(floor((0.5f - _e159)));
                    let _e298 = (_e134 < 0f);
                    if _e298 {
                        phi_494_ = (select(0i, select(select(i32(_e290), i32(-2147483648), (_e290 < -2147483600f)), 2147483647i, (_e290 > 2147483500f)), (_e290 == _e290)) - 1i);
                    } else {
                        phi_494_ = (select(0i, select(select(i32(_e280), i32(-2147483648), (_e280 < -2147483600f)), 2147483647i, (_e280 > 2147483500f)), (_e280 == _e280)) + 1i);
                    }
                    let _e302 = phi_494_;
                    if _e298 {
                        phi_508_ = (_e302 < 0i);
                    } else {
                        phi_508_ = (_e302 >= bitcast<i32>(_e179.z));
                    }
                    let _e307 = phi_508_;
                    if _e307 {
                        phi_526_ = f32();
                        phi_527_ = true;
                    } else {
                        let _e310 = (_e182 < 0.000001f);
                        if _e310 {
                            phi_525_ = f32();
                        } else {
                            phi_525_ = (((f32(_e302) + 0.5f) - _e159) / _e134);
                        }
                        let _e314 = phi_525_;
                        phi_526_ = _e314;
                        phi_527_ = _e310;
                    }
                    let _e316 = phi_526_;
                    let _e318 = phi_527_;
                    phi_535_ = type_8(0u, 2048u);
                    phi_538_ = vec3<f32>(0f, 0f, 0f);
                    phi_540_ = type_41(_e159, _e134, 0u, _e302, select(_e316, 340282350000000000000000000000000000000f, _e318));
                    phi_542_ = type_41(_e158, _e133, 0u, _e259, select(_e273, 340282350000000000000000000000000000000f, _e275));
                    phi_544_ = type_41(_e157, _e132, 0u, _e216, select(_e230, 340282350000000000000000000000000000000f, _e232));
                    phi_546_ = 0f;
                    phi_548_ = 1f;
                    loop {
                        let _e322 = phi_535_;
                        let _e324 = phi_538_;
                        let _e326 = phi_540_;
                        let _e328 = phi_542_;
                        let _e330 = phi_544_;
                        let _e332 = phi_546_;
                        let _e334 = phi_548_;
                        local_6 = _e332;
                        local_7 = _e334;
                        local_8 = _e324;
                        local_9 = _e324;
                        local_10 = _e324;
                        if (_e322.member < _e322.member_1) {
                            phi_536_ = type_8((_e322.member + 1u), _e322.member_1);
                            phi_571_ = type_8(1u, _e322.member);
                        } else {
                            phi_536_ = _e322;
                            phi_571_ = type_8(0u, type_8().member_1);
                        }
                        let _e347 = phi_536_;
                        let _e349 = phi_571_;
                        if (bitcast<i32>(_e349.member) != 0i) {
                            if (_e330.member_4 <= _e328.member_4) {
                                phi_591_ = select(true, false, (_e330.member_4 <= _e326.member_4));
                            } else {
                                phi_591_ = true;
                            }
                            let _e360 = phi_591_;
                            if _e360 {
                                phi_602_ = select(2u, 1u, (_e328.member_4 <= _e326.member_4));
                            } else {
                                phi_602_ = 0u;
                            }
                            let _e365 = phi_602_;
                            let _e366 = (_e365 == 0u);
                            if _e366 {
                                phi_627_ = _e330.member_4;
                                phi_628_ = _e330.member_3;
                                phi_629_ = _e330.member_2;
                                phi_630_ = _e330.member_1;
                            } else {
                                if (_e365 == 1u) {
                                    phi_623_ = _e328.member_4;
                                    phi_624_ = _e328.member_3;
                                    phi_625_ = _e328.member_2;
                                    phi_626_ = _e328.member_1;
                                } else {
                                    phi_623_ = _e326.member_4;
                                    phi_624_ = _e326.member_3;
                                    phi_625_ = _e326.member_2;
                                    phi_626_ = _e326.member_1;
                                }
                                let _e376 = phi_623_;
                                let _e378 = phi_624_;
                                let _e380 = phi_625_;
                                let _e382 = phi_626_;
                                phi_627_ = _e376;
                                phi_628_ = _e378;
                                phi_629_ = _e380;
                                phi_630_ = _e382;
                            }
                            let _e387 = phi_627_;
                            let _e389 = phi_628_;
                            let _e391 = phi_629_;
                            let _e393 = phi_630_;
                            if (_e387 >= 340282350000000000000000000000000000000f) {
                                phi_1870_ = vec3<f32>();
                                phi_1871_ = type_41();
                                phi_1872_ = type_41();
                                phi_1873_ = type_41();
                                phi_1874_ = f32();
                                phi_1875_ = f32();
                                phi_1876_ = false;
                            } else {
                                let _e395 = (1f - _e332);
                                let _e396 = (_e334 * _e395);
                                let _e397 = (_e396 < 0.001f);
                                if _e397 {
                                    phi_1863_ = vec3<f32>();
                                    phi_1864_ = type_41();
                                    phi_1865_ = type_41();
                                    phi_1866_ = type_41();
                                    phi_1867_ = f32();
                                    phi_1868_ = f32();
                                } else {
                                    let _e404 = (_e393 < 0f);
                                    if (_e391 < 10u) {
                                    } else {
                                        phi_1931_ = true;
                                        break;
                                    }
                                    let _e409 = params.member.member_2[_e391];
                                    let _e410 = (_e391 & 31u);
                                    let _e412 = (1u << bitcast<u32>(_e410));
                                    let _e413 = (_e412 - 1u);
                                    let _e416 = ((_e179.x + _e413) >> bitcast<u32>(_e410));
                                    let _e419 = ((_e179.y + _e413) >> bitcast<u32>(_e410));
                                    let _e422 = ((_e179.z + _e413) >> bitcast<u32>(_e410));
                                    let _e424 = (1f / f32(_e412));
                                    if _e366 {
                                        phi_686_ = _e416;
                                    } else {
                                        phi_686_ = select(_e422, _e419, (_e365 == 1u));
                                    }
                                    let _e428 = phi_686_;
                                    if (_e389 < 0i) {
                                        phi_1541_ = vec4<f32>();
                                        phi_1542_ = true;
                                    } else {
                                        let _e431 = (_e389 >= bitcast<i32>(_e428));
                                        if _e431 {
                                            phi_1540_ = vec4<f32>();
                                        } else {
                                            let _e432 = f32(_e389);
                                            if _e366 {
                                                phi_703_ = _e432;
                                            } else {
                                                phi_703_ = (((_e157 + (_e132 * _e387)) * _e424) - 0.5f);
                                            }
                                            let _e436 = phi_703_;
                                            let _e437 = floor(_e436);
                                            let _e445 = select(0i, select(select(i32(_e437), i32(-2147483648), (_e437 < -2147483600f)), 2147483647i, (_e437 > 2147483500f)), (_e437 == _e437));
                                            let _e447 = (bitcast<i32>(_e416) - 1i);
                                            if (_e436 >= -0.5f) {
                                                phi_724_ = (_e436 <= (f32(_e447) + 0.5f));
                                            } else {
                                                phi_724_ = false;
                                            }
                                            let _e453 = phi_724_;
                                            let _e454 = (_e445 >= 0i);
                                            let _e455 = (_e445 < _e447);
                                            if _e454 {
                                                phi_736_ = bitcast<u32>(select(_e445, _e447, (_e447 < _e445)));
                                            } else {
                                                phi_736_ = 0u;
                                            }
                                            let _e460 = phi_736_;
                                            if _e455 {
                                                let _e461 = (_e445 + 1i);
                                                phi_747_ = bitcast<u32>(select(0i, _e461, (0i < _e461)));
                                            } else {
                                                phi_747_ = 0u;
                                            }
                                            let _e466 = phi_747_;
                                            if _e454 {
                                                phi_755_ = select(0f, (_e436 - _e437), _e455);
                                            } else {
                                                phi_755_ = 1f;
                                            }
                                            let _e469 = phi_755_;
                                            let _e471 = (_e460 >> bitcast<u32>(2u));
                                            let _e473 = (_e466 >> bitcast<u32>(2u));
                                            let _e480 = ((_e460 & 1u) | (((_e460 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                            let _e487 = ((_e466 & 1u) | (((_e466 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                            if _e453 {
                                                phi_794_ = (1f - _e469);
                                            } else {
                                                phi_794_ = 0f;
                                            }
                                            let _e490 = phi_794_;
                                            let _e491 = select(0f, _e469, _e453);
                                            let _e492 = (_e365 == 1u);
                                            if _e492 {
                                                phi_805_ = _e432;
                                            } else {
                                                phi_805_ = (((_e158 + (_e133 * _e387)) * _e424) - 0.5f);
                                            }
                                            let _e496 = phi_805_;
                                            let _e498 = floor(_e496);
                                            let _e506 = select(0i, select(select(i32(_e498), i32(-2147483648), (_e498 < -2147483600f)), 2147483647i, (_e498 > 2147483500f)), (_e498 == _e498));
                                            let _e508 = (bitcast<i32>(_e419) - 1i);
                                            if (_e496 >= -0.5f) {
                                                phi_827_ = (_e496 <= (f32(_e508) + 0.5f));
                                            } else {
                                                phi_827_ = false;
                                            }
                                            let _e514 = phi_827_;
                                            let _e515 = (_e506 >= 0i);
                                            let _e516 = (_e506 < _e508);
                                            if _e515 {
                                                phi_839_ = bitcast<u32>(select(_e506, _e508, (_e508 < _e506)));
                                            } else {
                                                phi_839_ = 0u;
                                            }
                                            let _e521 = phi_839_;
                                            if _e516 {
                                                let _e522 = (_e506 + 1i);
                                                phi_850_ = bitcast<u32>(select(0i, _e522, (0i < _e522)));
                                            } else {
                                                phi_850_ = 0u;
                                            }
                                            let _e527 = phi_850_;
                                            if _e515 {
                                                phi_858_ = select(0f, (_e496 - _e498), _e516);
                                            } else {
                                                phi_858_ = 1f;
                                            }
                                            let _e530 = phi_858_;
                                            let _e533 = ((_e521 >> bitcast<u32>(2u)) * _e409.x);
                                            let _e536 = ((_e527 >> bitcast<u32>(2u)) * _e409.x);
                                            let _e545 = (((_e521 & 1u) << bitcast<u32>(1u)) | (((_e521 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                            let _e554 = (((_e527 & 1u) << bitcast<u32>(1u)) | (((_e527 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                            if _e514 {
                                                phi_897_ = (1f - _e530);
                                            } else {
                                                phi_897_ = 0f;
                                            }
                                            let _e557 = phi_897_;
                                            let _e558 = select(0f, _e530, _e514);
                                            let _e559 = (_e365 == 2u);
                                            if _e559 {
                                                phi_908_ = _e432;
                                            } else {
                                                phi_908_ = (((_e159 + (_e134 * _e387)) * _e424) - 0.5f);
                                            }
                                            let _e563 = phi_908_;
                                            let _e565 = floor(_e563);
                                            let _e573 = select(0i, select(select(i32(_e565), i32(-2147483648), (_e565 < -2147483600f)), 2147483647i, (_e565 > 2147483500f)), (_e565 == _e565));
                                            let _e575 = (bitcast<i32>(_e422) - 1i);
                                            if (_e563 >= -0.5f) {
                                                phi_930_ = (_e563 <= (f32(_e575) + 0.5f));
                                            } else {
                                                phi_930_ = false;
                                            }
                                            let _e581 = phi_930_;
                                            let _e582 = (_e573 >= 0i);
                                            let _e583 = (_e573 < _e575);
                                            if _e582 {
                                                phi_942_ = bitcast<u32>(select(_e573, _e575, (_e575 < _e573)));
                                            } else {
                                                phi_942_ = 0u;
                                            }
                                            let _e588 = phi_942_;
                                            if _e583 {
                                                let _e589 = (_e573 + 1i);
                                                phi_953_ = bitcast<u32>(select(0i, _e589, (0i < _e589)));
                                            } else {
                                                phi_953_ = 0u;
                                            }
                                            let _e594 = phi_953_;
                                            if _e582 {
                                                phi_961_ = select(0f, (_e563 - _e565), _e583);
                                            } else {
                                                phi_961_ = 1f;
                                            }
                                            let _e597 = phi_961_;
                                            let _e600 = ((_e588 >> bitcast<u32>(1u)) * _e409.y);
                                            let _e603 = ((_e594 >> bitcast<u32>(1u)) * _e409.y);
                                            let _e606 = ((_e588 & 1u) << bitcast<u32>(2u));
                                            let _e609 = ((_e594 & 1u) << bitcast<u32>(2u));
                                            if _e581 {
                                                phi_1000_ = (1f - _e597);
                                            } else {
                                                phi_1000_ = 0f;
                                            }
                                            let _e612 = phi_1000_;
                                            let _e613 = select(0f, _e597, _e581);
                                            if _e366 {
                                                phi_1027_ = _e613;
                                                phi_1028_ = _e612;
                                                phi_1029_ = _e609;
                                                phi_1030_ = _e606;
                                                phi_1031_ = _e603;
                                                phi_1032_ = _e600;
                                                phi_1033_ = _e558;
                                                phi_1034_ = _e557;
                                                phi_1035_ = _e554;
                                                phi_1036_ = _e545;
                                                phi_1037_ = _e536;
                                                phi_1038_ = _e533;
                                                phi_1039_ = _e480;
                                                phi_1040_ = _e471;
                                            } else {
                                                phi_1027_ = select(_e558, _e491, _e492);
                                                phi_1028_ = select(_e557, _e490, _e492);
                                                phi_1029_ = select(_e554, _e487, _e492);
                                                phi_1030_ = select(_e545, _e480, _e492);
                                                phi_1031_ = select(_e536, _e473, _e492);
                                                phi_1032_ = select(_e533, _e471, _e492);
                                                phi_1033_ = select(_e491, _e613, _e492);
                                                phi_1034_ = select(_e490, _e612, _e492);
                                                phi_1035_ = select(_e487, _e609, _e492);
                                                phi_1036_ = select(_e480, _e606, _e492);
                                                phi_1037_ = select(_e473, _e603, _e492);
                                                phi_1038_ = select(_e471, _e600, _e492);
                                                phi_1039_ = select(_e606, _e545, _e492);
                                                phi_1040_ = select(_e600, _e533, _e492);
                                            }
                                            let _e629 = phi_1027_;
                                            let _e631 = phi_1028_;
                                            let _e633 = phi_1029_;
                                            let _e635 = phi_1030_;
                                            let _e637 = phi_1031_;
                                            let _e639 = phi_1032_;
                                            let _e641 = phi_1033_;
                                            let _e643 = phi_1034_;
                                            let _e645 = phi_1035_;
                                            let _e647 = phi_1036_;
                                            let _e649 = phi_1037_;
                                            let _e651 = phi_1038_;
                                            let _e653 = phi_1039_;
                                            let _e655 = phi_1040_;
                                            phi_1043_ = type_8(0u, 4u);
                                            phi_1046_ = vec4<f32>(0f, 0f, 0f, 0f);
                                            loop {
                                                let _e657 = phi_1043_;
                                                let _e659 = phi_1046_;
                                                local_13 = _e659;
                                                if (_e657.member < _e657.member_1) {
                                                    phi_1044_ = type_8((_e657.member + 1u), _e657.member_1);
                                                    phi_1069_ = type_8(1u, _e657.member);
                                                } else {
                                                    phi_1044_ = _e657;
                                                    phi_1069_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e672 = phi_1044_;
                                                let _e674 = phi_1069_;
                                                let _e678 = (bitcast<i32>(_e674.member) != 0i);
                                                if _e678 {
                                                    let _e680 = ((_e674.member_1 & 1u) == 1u);
                                                    let _e682 = ((_e674.member_1 & 2u) == 2u);
                                                    let _e685 = (select(_e643, _e641, _e680) * select(_e631, _e629, _e682));
                                                    let _e691 = (((_e409.z + _e655) + select(_e651, _e649, _e680)) + select(_e639, _e637, _e682));
                                                    let _e696 = (2u * _e691);
                                                    let _e698 = cells.member[_e696];
                                                    if (_e685 > 0f) {
                                                        let _e700 = (((_e653 | select(_e647, _e645, _e680)) | select(_e635, _e633, _e682)) & 31u);
                                                        if (((_e698 >> bitcast<u32>(_e700)) & 1u) == 1u) {
                                                            let _e707 = params.member.member_8;
                                                            let _e708 = (_e707 == 1u);
                                                            if (_e391 == 0u) {
                                                                let _e734 = (_e691 * 6u);
                                                                let _e737 = cells.member[(_e696 + 1u)];
                                                                let _e739 = facet_bits.member[_e734];
                                                                let _e742 = ((1u << bitcast<u32>(_e700)) - 1u);
                                                                let _e751 = facet_bits.member[(_e734 + 1u)];
                                                                let _e761 = facet_bits.member[(_e734 + 2u)];
                                                                let _e771 = facet_bits.member[(_e734 + 3u)];
                                                                let _e781 = facet_bits.member[(_e734 + 4u)];
                                                                let _e791 = facet_bits.member[(_e734 + 5u)];
                                                                let _e794 = ((((((_e737 + countOneBits((_e739 & _e742))) + countOneBits((_e751 & _e742))) + countOneBits((_e761 & _e742))) + countOneBits((_e771 & _e742))) + countOneBits((_e781 & _e742))) + countOneBits((_e791 & _e742)));
                                                                let _e798 = (((((((_e739 >> bitcast<u32>(_e700)) & 1u) + ((_e751 >> bitcast<u32>(_e700)) & 1u)) + ((_e761 >> bitcast<u32>(_e700)) & 1u)) + ((_e771 >> bitcast<u32>(_e700)) & 1u)) + ((_e781 >> bitcast<u32>(_e700)) & 1u)) + ((_e791 >> bitcast<u32>(_e700)) & 1u));
                                                                if _e708 {
                                                                    phi_1227_ = type_8(_e794, (_e794 + _e798));
                                                                    phi_1230_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    loop {
                                                                        let _e919 = phi_1227_;
                                                                        let _e921 = phi_1230_;
                                                                        local_12 = _e921;
                                                                        if (_e919.member < _e919.member_1) {
                                                                            phi_1228_ = type_8((_e919.member + 1u), _e919.member_1);
                                                                            phi_1253_ = type_8(1u, _e919.member);
                                                                        } else {
                                                                            phi_1228_ = _e919;
                                                                            phi_1253_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e934 = phi_1228_;
                                                                        let _e936 = phi_1253_;
                                                                        let _e940 = (bitcast<i32>(_e936.member) != 0i);
                                                                        if _e940 {
                                                                            let _e941 = (2u * _e936.member_1);
                                                                            let _e944 = radiance.member[_e941][0u];
                                                                            let _e947 = radiance.member[_e941][1u];
                                                                            let _e950 = radiance.member[_e941][2u];
                                                                            let _e951 = (_e941 + 1u);
                                                                            let _e954 = radiance.member[_e951][0u];
                                                                            let _e957 = radiance.member[_e951][1u];
                                                                            let _e960 = radiance.member[_e951][2u];
                                                                            let _e969 = facets.member[_e936.member_1].member_2;
                                                                            let _e978 = sqrt((((_e969[0] * _e969[0]) + (_e969[1] * _e969[1])) + (_e969[2] * _e969[2])));
                                                                            phi_1231_ = vec4<f32>((_e921.x + (select(_e954, _e944, (_e944 > _e954)) * _e978)), (_e921.y + (select(_e957, _e947, (_e947 > _e957)) * _e978)), (_e921.z + (select(_e960, _e950, (_e950 > _e960)) * _e978)), (_e921.w + _e978));
                                                                        } else {
                                                                            phi_1231_ = vec4<f32>();
                                                                        }
                                                                        let _e992 = phi_1231_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_1227_ = _e934;
                                                                            phi_1230_ = _e992;
                                                                            break if !(_e940);
                                                                        }
                                                                    }
                                                                    let _e1505 = local_12;
                                                                    phi_1470_ = _e1505;
                                                                } else {
                                                                    let _e799 = select(1f, -1f, _e404);
                                                                    phi_1349_ = type_8(_e794, (_e794 + _e798));
                                                                    phi_1352_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    phi_1354_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    loop {
                                                                        let _e806 = phi_1349_;
                                                                        let _e808 = phi_1352_;
                                                                        let _e810 = phi_1354_;
                                                                        local = _e808;
                                                                        local_1 = _e810;
                                                                        local_2 = _e808;
                                                                        local_3 = _e808;
                                                                        local_4 = _e808;
                                                                        local_5 = _e810;
                                                                        local_11 = _e810;
                                                                        if (_e806.member < _e806.member_1) {
                                                                            phi_1350_ = type_8((_e806.member + 1u), _e806.member_1);
                                                                            phi_1377_ = type_8(1u, _e806.member);
                                                                        } else {
                                                                            phi_1350_ = _e806;
                                                                            phi_1377_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e823 = phi_1350_;
                                                                        let _e825 = phi_1377_;
                                                                        let _e829 = (bitcast<i32>(_e825.member) != 0i);
                                                                        if _e829 {
                                                                            let _e832 = facets.member[_e825.member_1].member_2;
                                                                            let _e841 = -((((select(0f, _e799, _e366) * _e832[0]) + (select(0f, _e799, _e492) * _e832[1])) + (select(0f, _e799, _e559) * _e832[2])));
                                                                            if (_e841 > 0f) {
                                                                                let _e864 = radiance.member[(2u * _e825.member_1)];
                                                                                phi_1446_ = _e808;
                                                                                phi_1447_ = vec4<f32>((_e810.x + (_e864.x * _e841)), (_e810.y + (_e864.y * _e841)), (_e810.z + (_e864.z * _e841)), (_e810.w + _e841));
                                                                            } else {
                                                                                let _e846 = radiance.member[((2u * _e825.member_1) + 1u)];
                                                                                phi_1446_ = vec4<f32>((_e808.x - (_e846.x * _e841)), (_e808.y - (_e846.y * _e841)), (_e808.z - (_e846.z * _e841)), (_e808.w - _e841));
                                                                                phi_1447_ = _e810;
                                                                            }
                                                                            let _e881 = phi_1446_;
                                                                            let _e883 = phi_1447_;
                                                                            phi_1353_ = _e881;
                                                                            phi_1355_ = _e883;
                                                                        } else {
                                                                            phi_1353_ = vec4<f32>();
                                                                            phi_1355_ = vec4<f32>();
                                                                        }
                                                                        let _e885 = phi_1353_;
                                                                        let _e887 = phi_1355_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_1349_ = _e823;
                                                                            phi_1352_ = _e885;
                                                                            phi_1354_ = _e887;
                                                                            break if !(_e829);
                                                                        }
                                                                    }
                                                                    let _e890 = local;
                                                                    let _e893 = local_1;
                                                                    if (_e890.w > _e893.w) {
                                                                        let _e896 = (_e890.w - _e893.w);
                                                                        let _e897 = (_e896 / _e890.w);
                                                                        let _e899 = local_2;
                                                                        let _e903 = local_3;
                                                                        let _e907 = local_4;
                                                                        let _e912 = local_5;
                                                                        phi_1469_ = (_e912 + vec4<f32>((_e899.x * _e897), (_e903.y * _e897), (_e907.z * _e897), _e896));
                                                                    } else {
                                                                        let _e1497 = local_11;
                                                                        phi_1469_ = _e1497;
                                                                    }
                                                                    let _e915 = phi_1469_;
                                                                    phi_1470_ = _e915;
                                                                }
                                                                let _e995 = phi_1470_;
                                                                if (_e995.w > 1f) {
                                                                    phi_1484_ = vec4<f32>((_e995.x / _e995.w), (_e995.y / _e995.w), (_e995.z / _e995.w), 1f);
                                                                } else {
                                                                    phi_1484_ = _e995;
                                                                }
                                                                let _e1006 = phi_1484_;
                                                                phi_1517_ = _e1006;
                                                            } else {
                                                                let _e712 = cells.member[(_e696 + 1u)];
                                                                let _e718 = (_e712 + countOneBits((_e698 & ((1u << bitcast<u32>(_e700)) - 1u))));
                                                                if _e708 {
                                                                    phi_1504_ = _e718;
                                                                } else {
                                                                    phi_1504_ = (((6u * _e718) + (2u * _e365)) + select(0u, 1u, _e404));
                                                                }
                                                                let _e725 = phi_1504_;
                                                                if ((_e391 & 1u) == 1u) {
                                                                    let _e731 = odd.member[_e725];
                                                                    phi_1516_ = _e731;
                                                                } else {
                                                                    let _e729 = even.member[_e725];
                                                                    phi_1516_ = _e729;
                                                                }
                                                                let _e733 = phi_1516_;
                                                                phi_1517_ = _e733;
                                                            }
                                                            let _e1008 = phi_1517_;
                                                            phi_1538_ = vec4<f32>((_e659.x + (_e1008.x * _e685)), (_e659.y + (_e1008.y * _e685)), (_e659.z + (_e1008.z * _e685)), (_e659.w + (_e1008.w * _e685)));
                                                        } else {
                                                            phi_1538_ = _e659;
                                                        }
                                                        let _e1027 = phi_1538_;
                                                        phi_1539_ = _e1027;
                                                    } else {
                                                        phi_1539_ = _e659;
                                                    }
                                                    let _e1029 = phi_1539_;
                                                    phi_1047_ = _e1029;
                                                } else {
                                                    phi_1047_ = vec4<f32>();
                                                }
                                                let _e1031 = phi_1047_;
                                                continue;
                                                continuing {
                                                    phi_1043_ = _e672;
                                                    phi_1046_ = _e1031;
                                                    break if !(_e678);
                                                }
                                            }
                                            let _e1513 = local_13;
                                            phi_1540_ = _e1513;
                                        }
                                        let _e1034 = phi_1540_;
                                        phi_1541_ = _e1034;
                                        phi_1542_ = _e431;
                                    }
                                    let _e1036 = phi_1541_;
                                    let _e1038 = phi_1542_;
                                    let _e1040 = select(_e1036, vec4<f32>(0f, 0f, 0f, 0f), vec4(_e1038));
                                    if (_e1040.w > 0f) {
                                        let _e1047 = select(_e395, _e1040.w, (_e1040.w < _e395));
                                        let _e1052 = ((_e334 * _e1047) / _e1040.w);
                                        phi_1586_ = vec3<f32>((_e324.x + (_e1040.x * _e1052)), (_e324.y + (_e1040.y * _e1052)), (_e324.z + (_e1040.z * _e1052)));
                                        phi_1587_ = (_e332 + _e1047);
                                        phi_1588_ = _e334;
                                    } else {
                                        let _e1043 = (_e365 == _e191);
                                        phi_1586_ = _e324;
                                        phi_1587_ = select(_e332, 0f, _e1043);
                                        phi_1588_ = select(_e334, _e396, _e1043);
                                    }
                                    let _e1065 = phi_1586_;
                                    let _e1067 = phi_1587_;
                                    let _e1069 = phi_1588_;
                                    let _e1070 = ((2f * _e163) * _e387);
                                    let _e1072 = ((_e167 * _e153) + ((_e167 * select(0f, _e173, (_e173 > 0f))) * _e387));
                                    let _e1074 = select(_e1072, _e1070, (_e1070 < _e1072));
                                    let _e1081 = ((bitcast<u32>((select(1f, _e1074, (_e1074 > 1f)) * 1.4142135f)) >> bitcast<u32>(23i)) - 127u);
                                    let _e1083 = (_e179.w - 1u);
                                    let _e1085 = select(_e1081, _e1083, (_e1083 < _e1081));
                                    if _e366 {
                                        let _e1246 = (_e330.member_1 < 0f);
                                        if _e1246 {
                                            phi_1631_ = (_e330.member_3 - 1i);
                                        } else {
                                            phi_1631_ = (_e330.member_3 + 1i);
                                        }
                                        let _e1254 = phi_1631_;
                                        let _e1260 = type_41(_e330.member, _e330.member_1, _e330.member_2, _e1254, _e330.member_4);
                                        if (((_e330.member_3 & 1i) == 0i) == _e1246) {
                                            if (_e1085 > _e330.member_2) {
                                                let _e1269 = type_41(_e1260.member, _e1260.member_1, (_e330.member_2 + 1u), _e1260.member_3, _e1260.member_4);
                                                phi_1646_ = type_41(_e1269.member, _e1269.member_1, _e1269.member_2, (_e1254 >> bitcast<u32>(1i)), _e1269.member_4);
                                            } else {
                                                phi_1646_ = _e1260;
                                            }
                                            let _e1279 = phi_1646_;
                                            phi_1647_ = _e1279;
                                        } else {
                                            phi_1647_ = _e1260;
                                        }
                                        let _e1281 = phi_1647_;
                                        let _e1283 = (_e1281.member_2 & 31u);
                                        let _e1285 = (1u << bitcast<u32>(_e1283));
                                        if (_e1281.member_1 < 0f) {
                                            phi_1666_ = (_e1281.member_3 < 0i);
                                        } else {
                                            phi_1666_ = (_e1281.member_3 >= bitcast<i32>((((_e179.x + _e1285) - 1u) >> bitcast<u32>(_e1283))));
                                        }
                                        let _e1298 = phi_1666_;
                                        if _e1298 {
                                            phi_1689_ = f32();
                                            phi_1690_ = true;
                                        } else {
                                            let _e1305 = (abs(_e1281.member_1) < 0.000001f);
                                            if _e1305 {
                                                phi_1688_ = f32();
                                            } else {
                                                phi_1688_ = ((((f32(_e1281.member_3) + 0.5f) * f32(_e1285)) - _e1281.member) / _e1281.member_1);
                                            }
                                            let _e1310 = phi_1688_;
                                            phi_1689_ = _e1310;
                                            phi_1690_ = _e1305;
                                        }
                                        let _e1312 = phi_1689_;
                                        let _e1314 = phi_1690_;
                                        phi_1860_ = _e326;
                                        phi_1861_ = _e328;
                                        phi_1862_ = type_41(_e1281.member, _e1281.member_1, _e1281.member_2, _e1281.member_3, select(_e1312, 340282350000000000000000000000000000000f, _e1314));
                                    } else {
                                        if (_e365 == 1u) {
                                            let _e1165 = (_e328.member_1 < 0f);
                                            if _e1165 {
                                                phi_1714_ = (_e328.member_3 - 1i);
                                            } else {
                                                phi_1714_ = (_e328.member_3 + 1i);
                                            }
                                            let _e1173 = phi_1714_;
                                            let _e1179 = type_41(_e328.member, _e328.member_1, _e328.member_2, _e1173, _e328.member_4);
                                            if (((_e328.member_3 & 1i) == 0i) == _e1165) {
                                                if (_e1085 > _e328.member_2) {
                                                    let _e1188 = type_41(_e1179.member, _e1179.member_1, (_e328.member_2 + 1u), _e1179.member_3, _e1179.member_4);
                                                    phi_1729_ = type_41(_e1188.member, _e1188.member_1, _e1188.member_2, (_e1173 >> bitcast<u32>(1i)), _e1188.member_4);
                                                } else {
                                                    phi_1729_ = _e1179;
                                                }
                                                let _e1198 = phi_1729_;
                                                phi_1730_ = _e1198;
                                            } else {
                                                phi_1730_ = _e1179;
                                            }
                                            let _e1200 = phi_1730_;
                                            let _e1202 = (_e1200.member_2 & 31u);
                                            let _e1204 = (1u << bitcast<u32>(_e1202));
                                            if (_e1200.member_1 < 0f) {
                                                phi_1749_ = (_e1200.member_3 < 0i);
                                            } else {
                                                phi_1749_ = (_e1200.member_3 >= bitcast<i32>((((_e179.y + _e1204) - 1u) >> bitcast<u32>(_e1202))));
                                            }
                                            let _e1217 = phi_1749_;
                                            if _e1217 {
                                                phi_1772_ = f32();
                                                phi_1773_ = true;
                                            } else {
                                                let _e1224 = (abs(_e1200.member_1) < 0.000001f);
                                                if _e1224 {
                                                    phi_1771_ = f32();
                                                } else {
                                                    phi_1771_ = ((((f32(_e1200.member_3) + 0.5f) * f32(_e1204)) - _e1200.member) / _e1200.member_1);
                                                }
                                                let _e1229 = phi_1771_;
                                                phi_1772_ = _e1229;
                                                phi_1773_ = _e1224;
                                            }
                                            let _e1231 = phi_1772_;
                                            let _e1233 = phi_1773_;
                                            phi_1858_ = _e326;
                                            phi_1859_ = type_41(_e1200.member, _e1200.member_1, _e1200.member_2, _e1200.member_3, select(_e1231, 340282350000000000000000000000000000000f, _e1233));
                                        } else {
                                            let _e1088 = (_e326.member_1 < 0f);
                                            if _e1088 {
                                                phi_1793_ = (_e326.member_3 - 1i);
                                            } else {
                                                phi_1793_ = (_e326.member_3 + 1i);
                                            }
                                            let _e1096 = phi_1793_;
                                            let _e1102 = type_41(_e326.member, _e326.member_1, _e326.member_2, _e1096, _e326.member_4);
                                            if (((_e326.member_3 & 1i) == 0i) == _e1088) {
                                                if (_e1085 > _e326.member_2) {
                                                    let _e1111 = type_41(_e1102.member, _e1102.member_1, (_e326.member_2 + 1u), _e1102.member_3, _e1102.member_4);
                                                    phi_1808_ = type_41(_e1111.member, _e1111.member_1, _e1111.member_2, (_e1096 >> bitcast<u32>(1i)), _e1111.member_4);
                                                } else {
                                                    phi_1808_ = _e1102;
                                                }
                                                let _e1121 = phi_1808_;
                                                phi_1809_ = _e1121;
                                            } else {
                                                phi_1809_ = _e1102;
                                            }
                                            let _e1123 = phi_1809_;
                                            let _e1125 = (_e1123.member_2 & 31u);
                                            let _e1127 = (1u << bitcast<u32>(_e1125));
                                            if (_e1123.member_1 < 0f) {
                                                phi_1828_ = (_e1123.member_3 < 0i);
                                            } else {
                                                phi_1828_ = (_e1123.member_3 >= bitcast<i32>((((_e179.z + _e1127) - 1u) >> bitcast<u32>(_e1125))));
                                            }
                                            let _e1140 = phi_1828_;
                                            if _e1140 {
                                                phi_1851_ = f32();
                                                phi_1852_ = true;
                                            } else {
                                                let _e1147 = (abs(_e1123.member_1) < 0.000001f);
                                                if _e1147 {
                                                    phi_1850_ = f32();
                                                } else {
                                                    phi_1850_ = ((((f32(_e1123.member_3) + 0.5f) * f32(_e1127)) - _e1123.member) / _e1123.member_1);
                                                }
                                                let _e1152 = phi_1850_;
                                                phi_1851_ = _e1152;
                                                phi_1852_ = _e1147;
                                            }
                                            let _e1154 = phi_1851_;
                                            let _e1156 = phi_1852_;
                                            phi_1858_ = type_41(_e1123.member, _e1123.member_1, _e1123.member_2, _e1123.member_3, select(_e1154, 340282350000000000000000000000000000000f, _e1156));
                                            phi_1859_ = _e328;
                                        }
                                        let _e1242 = phi_1858_;
                                        let _e1244 = phi_1859_;
                                        phi_1860_ = _e1242;
                                        phi_1861_ = _e1244;
                                        phi_1862_ = _e330;
                                    }
                                    let _e1323 = phi_1860_;
                                    let _e1325 = phi_1861_;
                                    let _e1327 = phi_1862_;
                                    phi_1863_ = _e1065;
                                    phi_1864_ = _e1323;
                                    phi_1865_ = _e1325;
                                    phi_1866_ = _e1327;
                                    phi_1867_ = _e1067;
                                    phi_1868_ = _e1069;
                                }
                                let _e1329 = phi_1863_;
                                let _e1331 = phi_1864_;
                                let _e1333 = phi_1865_;
                                let _e1335 = phi_1866_;
                                let _e1337 = phi_1867_;
                                let _e1339 = phi_1868_;
                                phi_1870_ = _e1329;
                                phi_1871_ = _e1331;
                                phi_1872_ = _e1333;
                                phi_1873_ = _e1335;
                                phi_1874_ = _e1337;
                                phi_1875_ = _e1339;
                                phi_1876_ = select(true, false, _e397);
                            }
                            let _e1342 = phi_1870_;
                            let _e1344 = phi_1871_;
                            let _e1346 = phi_1872_;
                            let _e1348 = phi_1873_;
                            let _e1350 = phi_1874_;
                            let _e1352 = phi_1875_;
                            let _e1354 = phi_1876_;
                            phi_539_ = _e1342;
                            phi_541_ = _e1344;
                            phi_543_ = _e1346;
                            phi_545_ = _e1348;
                            phi_547_ = _e1350;
                            phi_549_ = _e1352;
                            phi_1878_ = _e1354;
                        } else {
                            phi_539_ = vec3<f32>();
                            phi_541_ = type_41();
                            phi_543_ = type_41();
                            phi_545_ = type_41();
                            phi_547_ = f32();
                            phi_549_ = f32();
                            phi_1878_ = false;
                        }
                        let _e1356 = phi_539_;
                        let _e1358 = phi_541_;
                        let _e1360 = phi_543_;
                        let _e1362 = phi_545_;
                        let _e1364 = phi_547_;
                        let _e1366 = phi_549_;
                        let _e1368 = phi_1878_;
                        continue;
                        continuing {
                            phi_535_ = _e347;
                            phi_538_ = _e1356;
                            phi_540_ = _e1358;
                            phi_542_ = _e1360;
                            phi_544_ = _e1362;
                            phi_546_ = _e1364;
                            phi_548_ = _e1366;
                            phi_1931_ = false;
                            break if !(_e1368);
                        }
                    }
                    let _e1371 = phi_1931_;
                    if _e1371 {
                        break;
                    }
                    let _e1373 = local_6;
                    let _e1376 = local_7;
                    let _e1377 = (_e1376 * (1f - _e1373));
                    let _e1379 = local_8;
                    let _e1382 = local_9;
                    let _e1385 = local_10;
                    let _e1389 = params.member.member_5;
                    phi_1905_ = vec4<f32>((_e1379.x + (_e1389.x * _e1377)), (_e1382.y + (_e1389.y * _e1377)), (_e1385.z + (_e1389.z * _e1377)), _e1377);
                }
                let _e1401 = phi_1905_;
                if _e72 {
                } else {
                    break;
                }
                out.member[_e71] = _e1401;
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
