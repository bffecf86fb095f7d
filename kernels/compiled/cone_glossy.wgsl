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
    var phi_230_: vec3<f32>;
    var phi_314_: bool;
    var phi_323_: u32;
    var phi_355_: i32;
    var phi_369_: bool;
    var phi_386_: f32;
    var phi_387_: f32;
    var phi_388_: bool;
    var phi_425_: i32;
    var phi_439_: bool;
    var phi_456_: f32;
    var phi_457_: f32;
    var phi_458_: bool;
    var phi_495_: i32;
    var phi_509_: bool;
    var phi_526_: f32;
    var phi_527_: f32;
    var phi_528_: bool;
    var phi_2119_: bool;
    var phi_536_: type_8;
    var phi_539_: vec3<f32>;
    var phi_541_: type_41;
    var phi_543_: type_41;
    var phi_545_: type_41;
    var phi_547_: f32;
    var phi_549_: f32;
    var phi_537_: type_8;
    var phi_572_: type_8;
    var phi_592_: bool;
    var phi_603_: u32;
    var phi_624_: f32;
    var phi_625_: i32;
    var phi_626_: u32;
    var phi_627_: f32;
    var phi_628_: f32;
    var phi_629_: i32;
    var phi_630_: u32;
    var phi_631_: f32;
    var phi_687_: u32;
    var phi_704_: f32;
    var phi_725_: bool;
    var phi_737_: u32;
    var phi_748_: u32;
    var phi_756_: f32;
    var phi_795_: f32;
    var phi_806_: f32;
    var phi_828_: bool;
    var phi_840_: u32;
    var phi_851_: u32;
    var phi_859_: f32;
    var phi_898_: f32;
    var phi_909_: f32;
    var phi_931_: bool;
    var phi_943_: u32;
    var phi_954_: u32;
    var phi_962_: f32;
    var phi_1001_: f32;
    var phi_1028_: f32;
    var phi_1029_: f32;
    var phi_1030_: u32;
    var phi_1031_: u32;
    var phi_1032_: u32;
    var phi_1033_: u32;
    var phi_1034_: f32;
    var phi_1035_: f32;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1039_: u32;
    var phi_1040_: u32;
    var phi_1041_: u32;
    var phi_2082_: bool;
    var phi_1044_: type_8;
    var phi_1047_: vec4<f32>;
    var phi_1045_: type_8;
    var phi_1070_: type_8;
    var phi_1624_: u32;
    var phi_1648_: vec4<f32>;
    var phi_1157_: type_8;
    var phi_1160_: u32;
    var phi_1158_: type_8;
    var phi_1183_: type_8;
    var phi_1161_: u32;
    var phi_2071_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1448_: type_8;
    var phi_1451_: vec4<f32>;
    var phi_1453_: vec4<f32>;
    var phi_1449_: type_8;
    var phi_1476_: type_8;
    var phi_1560_: vec4<f32>;
    var phi_1561_: vec4<f32>;
    var phi_1452_: vec4<f32>;
    var phi_1454_: vec4<f32>;
    var phi_2153_: bool;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_1583_: vec4<f32>;
    var local_8: u32;
    var local_9: u32;
    var phi_1297_: type_8;
    var phi_1300_: vec4<f32>;
    var phi_1298_: type_8;
    var phi_1323_: type_8;
    var phi_1301_: vec4<f32>;
    var phi_2162_: bool;
    var phi_2177_: bool;
    var phi_1584_: vec4<f32>;
    var phi_1598_: vec4<f32>;
    var phi_2173_: bool;
    var phi_1649_: vec4<f32>;
    var phi_2172_: bool;
    var phi_1670_: vec4<f32>;
    var phi_2171_: bool;
    var phi_1671_: vec4<f32>;
    var phi_2170_: bool;
    var phi_1048_: vec4<f32>;
    var phi_2169_: bool;
    var phi_2198_: bool;
    var phi_1672_: vec4<f32>;
    var phi_2197_: bool;
    var phi_1673_: vec4<f32>;
    var phi_1674_: bool;
    var phi_1718_: vec3<f32>;
    var phi_1719_: f32;
    var phi_1720_: f32;
    var phi_1925_: i32;
    var phi_1940_: type_41;
    var phi_1941_: type_41;
    var phi_1960_: bool;
    var phi_1982_: f32;
    var phi_1983_: f32;
    var phi_1984_: bool;
    var phi_1846_: i32;
    var phi_1861_: type_41;
    var phi_1862_: type_41;
    var phi_1881_: bool;
    var phi_1903_: f32;
    var phi_1904_: f32;
    var phi_1905_: bool;
    var phi_1990_: type_41;
    var phi_1991_: type_41;
    var phi_1763_: i32;
    var phi_1778_: type_41;
    var phi_1779_: type_41;
    var phi_1798_: bool;
    var phi_1820_: f32;
    var phi_1821_: f32;
    var phi_1822_: bool;
    var phi_1992_: type_41;
    var phi_1993_: type_41;
    var phi_1994_: type_41;
    var phi_2182_: bool;
    var phi_1995_: vec3<f32>;
    var phi_1996_: type_41;
    var phi_1997_: type_41;
    var phi_1998_: type_41;
    var phi_1999_: f32;
    var phi_2000_: f32;
    var phi_2181_: bool;
    var phi_2002_: vec3<f32>;
    var phi_2003_: type_41;
    var phi_2004_: type_41;
    var phi_2005_: type_41;
    var phi_2006_: f32;
    var phi_2007_: f32;
    var phi_2008_: bool;
    var phi_2180_: bool;
    var phi_540_: vec3<f32>;
    var phi_542_: type_41;
    var phi_544_: type_41;
    var phi_546_: type_41;
    var phi_548_: f32;
    var phi_550_: f32;
    var phi_2010_: bool;
    var phi_2179_: bool;
    var local_10: f32;
    var local_11: f32;
    var local_12: vec3<f32>;
    var local_13: vec3<f32>;
    var local_14: vec3<f32>;
    var phi_2037_: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e59 = gid_1;
            let _e62 = arrayLength((&cells.member));
            let _e65 = arrayLength((&facet_bits.member));
            let _e68 = arrayLength((&facets.member));
            let _e71 = arrayLength((&radiance.member));
            let _e85 = (_e59.x + (_e59.y * 2097152u));
            let _e86 = (_e85 < arrayLength((&out.member)));
            if _e86 {
                if (_e85 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e91 = surfels.member[_e85].member;
                let _e95 = surfels.member[_e85].member_1;
                let _e99 = surfels.member[_e85].member_2;
                let _e103 = surfels.member[_e85].member_4;
                if (_e95 == 4294967295u) {
                    phi_2037_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e110 = params.member.member_6;
                    let _e114 = (_e110.x - _e91[0]);
                    let _e115 = (_e110.y - _e91[1]);
                    let _e116 = (_e110.z - _e91[2]);
                    let _e121 = (((_e114 * _e114) + (_e115 * _e115)) + (_e116 * _e116));
                    if (_e121 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e124 = (1f / sqrt(_e121));
                        phi_230_ = vec3<f32>((_e114 * _e124), (_e115 * _e124), (_e116 * _e124));
                    } else {
                        phi_230_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e130 = phi_230_;
                    let _e142 = (2f * (((_e130.x * _e99[0]) + (_e130.y * _e99[1])) + (_e130.z * _e99[2])));
                    let _e146 = ((_e99[0] * _e142) - _e130.x);
                    let _e147 = ((_e99[1] * _e142) - _e130.y);
                    let _e148 = ((_e99[2] * _e142) - _e130.z);
                    let _e151 = params.member.member;
                    let _e167 = params.member.member_12;
                    let _e171 = (((_e91[0] - _e151.x) / _e151.w) + (_e103[0] * _e167));
                    let _e172 = (((_e91[1] - _e151.y) / _e151.w) + (_e103[1] * _e167));
                    let _e173 = (((_e91[2] - _e151.z) / _e151.w) + (_e103[2] * _e167));
                    let _e177 = params.member.member_6[3u];
                    let _e181 = params.member.member_13;
                    let _e187 = (((_e146 * _e103[0]) + (_e147 * _e103[1])) + (_e148 * _e103[2]));
                    let _e193 = params.member.member_1;
                    let _e194 = abs(_e146);
                    let _e195 = abs(_e147);
                    let _e196 = abs(_e148);
                    if (_e194 >= _e195) {
                        phi_314_ = select(true, false, (_e194 >= _e196));
                    } else {
                        phi_314_ = true;
                    }
                    let _e201 = phi_314_;
                    if _e201 {
                        phi_323_ = select(2u, 1u, (_e195 >= _e196));
                    } else {
                        phi_323_ = 0u;
                    }
                    let _e205 = phi_323_;
                    let _e208 = floor((_e171 - 0.5f));
                    let _e218 = -(floor((0.5f - _e171)));
                    let _e226 = (_e146 < 0f);
                    if _e226 {
                        phi_355_ = (select(0i, select(select(i32(_e218), i32(-2147483648), (_e218 < -2147483600f)), 2147483647i, (_e218 > 2147483500f)), (_e218 == _e218)) - 1i);
                    } else {
                        phi_355_ = (select(0i, select(select(i32(_e208), i32(-2147483648), (_e208 < -2147483600f)), 2147483647i, (_e208 > 2147483500f)), (_e208 == _e208)) + 1i);
                    }
                    let _e230 = phi_355_;
                    if _e226 {
                        phi_369_ = (_e230 < 0i);
                    } else {
                        phi_369_ = (_e230 >= bitcast<i32>(_e193.x));
                    }
                    let _e235 = phi_369_;
                    if _e235 {
                        phi_387_ = f32();
                        phi_388_ = true;
                    } else {
                        let _e238 = (_e194 < 0.000001f);
                        if _e238 {
                            phi_386_ = f32();
                        } else {
                            phi_386_ = (((f32(_e230) + 0.5f) - _e171) / _e146);
                        }
                        let _e242 = phi_386_;
                        phi_387_ = _e242;
                        phi_388_ = _e238;
                    }
                    let _e244 = phi_387_;
                    let _e246 = phi_388_;
                    let _e251 = floor((_e172 - 0.5f));
                    let _e261 = -(floor((0.5f - _e172)));
                    let _e269 = (_e147 < 0f);
                    if _e269 {
                        phi_425_ = (select(0i, select(select(i32(_e261), i32(-2147483648), (_e261 < -2147483600f)), 2147483647i, (_e261 > 2147483500f)), (_e261 == _e261)) - 1i);
                    } else {
                        phi_425_ = (select(0i, select(select(i32(_e251), i32(-2147483648), (_e251 < -2147483600f)), 2147483647i, (_e251 > 2147483500f)), (_e251 == _e251)) + 1i);
                    }
                    let _e273 = phi_425_;
                    if _e269 {
                        phi_439_ = (_e273 < 0i);
                    } else {
                        phi_439_ = (_e273 >= bitcast<i32>(_e193.y));
                    }
                    let _e278 = phi_439_;
                    if _e278 {
                        phi_457_ = f32();
                        phi_458_ = true;
                    } else {
                        let _e281 = (_e195 < 0.000001f);
                        if _e281 {
                            phi_456_ = f32();
                        } else {
                            phi_456_ = (((f32(_e273) + 0.5f) - _e172) / _e147);
                        }
                        let _e285 = phi_456_;
                        phi_457_ = _e285;
                        phi_458_ = _e281;
                    }
                    let _e287 = phi_457_;
                    let _e289 = phi_458_;
                    let _e294 = floor((_e173 - 0.5f));
                    let _e304 = -(floor((0.5f - _e173)));
                    let _e312 = (_e148 < 0f);
                    if _e312 {
                        phi_495_ = (select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < -2147483600f)), 2147483647i, (_e304 > 2147483500f)), (_e304 == _e304)) - 1i);
                    } else {
                        phi_495_ = (select(0i, select(select(i32(_e294), i32(-2147483648), (_e294 < -2147483600f)), 2147483647i, (_e294 > 2147483500f)), (_e294 == _e294)) + 1i);
                    }
                    let _e316 = phi_495_;
                    if _e312 {
                        phi_509_ = (_e316 < 0i);
                    } else {
                        phi_509_ = (_e316 >= bitcast<i32>(_e193.z));
                    }
                    let _e321 = phi_509_;
                    if _e321 {
                        phi_527_ = f32();
                        phi_528_ = true;
                    } else {
                        let _e324 = (_e196 < 0.000001f);
                        if _e324 {
                            phi_526_ = f32();
                        } else {
                            phi_526_ = (((f32(_e316) + 0.5f) - _e173) / _e148);
                        }
                        let _e328 = phi_526_;
                        phi_527_ = _e328;
                        phi_528_ = _e324;
                    }
                    let _e330 = phi_527_;
                    let _e332 = phi_528_;
                    phi_2119_ = false;
                    phi_536_ = type_8(0u, 2048u);
                    phi_539_ = vec3<f32>(0f, 0f, 0f);
                    phi_541_ = type_41(_e173, _e148, 0u, _e316, select(_e330, 340282350000000000000000000000000000000f, _e332));
                    phi_543_ = type_41(_e172, _e147, 0u, _e273, select(_e287, 340282350000000000000000000000000000000f, _e289));
                    phi_545_ = type_41(_e171, _e146, 0u, _e230, select(_e244, 340282350000000000000000000000000000000f, _e246));
                    phi_547_ = 0f;
                    phi_549_ = 1f;
                    loop {
                        let _e336 = phi_2119_;
                        let _e338 = phi_536_;
                        let _e340 = phi_539_;
                        let _e342 = phi_541_;
                        let _e344 = phi_543_;
                        let _e346 = phi_545_;
                        let _e348 = phi_547_;
                        let _e350 = phi_549_;
                        local_10 = _e348;
                        local_11 = _e350;
                        local_12 = _e340;
                        local_13 = _e340;
                        local_14 = _e340;
                        if (_e338.member < _e338.member_1) {
                            phi_537_ = type_8((_e338.member + 1u), _e338.member_1);
                            phi_572_ = type_8(1u, _e338.member);
                        } else {
                            phi_537_ = _e338;
                            phi_572_ = type_8(0u, type_8().member_1);
                        }
                        let _e363 = phi_537_;
                        let _e365 = phi_572_;
                        if (bitcast<i32>(_e365.member) != 0i) {
                            if (_e346.member_4 <= _e344.member_4) {
                                phi_592_ = select(true, false, (_e346.member_4 <= _e342.member_4));
                            } else {
                                phi_592_ = true;
                            }
                            let _e376 = phi_592_;
                            if _e376 {
                                phi_603_ = select(2u, 1u, (_e344.member_4 <= _e342.member_4));
                            } else {
                                phi_603_ = 0u;
                            }
                            let _e381 = phi_603_;
                            let _e382 = (_e381 == 0u);
                            if _e382 {
                                phi_628_ = _e346.member_4;
                                phi_629_ = _e346.member_3;
                                phi_630_ = _e346.member_2;
                                phi_631_ = _e346.member_1;
                            } else {
                                if (_e381 == 1u) {
                                    phi_624_ = _e344.member_4;
                                    phi_625_ = _e344.member_3;
                                    phi_626_ = _e344.member_2;
                                    phi_627_ = _e344.member_1;
                                } else {
                                    phi_624_ = _e342.member_4;
                                    phi_625_ = _e342.member_3;
                                    phi_626_ = _e342.member_2;
                                    phi_627_ = _e342.member_1;
                                }
                                let _e392 = phi_624_;
                                let _e394 = phi_625_;
                                let _e396 = phi_626_;
                                let _e398 = phi_627_;
                                phi_628_ = _e392;
                                phi_629_ = _e394;
                                phi_630_ = _e396;
                                phi_631_ = _e398;
                            }
                            let _e403 = phi_628_;
                            let _e405 = phi_629_;
                            let _e407 = phi_630_;
                            let _e409 = phi_631_;
                            if (_e403 >= 340282350000000000000000000000000000000f) {
                                phi_2181_ = _e336;
                                phi_2002_ = vec3<f32>();
                                phi_2003_ = type_41();
                                phi_2004_ = type_41();
                                phi_2005_ = type_41();
                                phi_2006_ = f32();
                                phi_2007_ = f32();
                                phi_2008_ = false;
                            } else {
                                let _e411 = (1f - _e348);
                                let _e412 = (_e350 * _e411);
                                let _e413 = (_e412 < 0.001f);
                                if _e413 {
                                    phi_2182_ = _e336;
                                    phi_1995_ = vec3<f32>();
                                    phi_1996_ = type_41();
                                    phi_1997_ = type_41();
                                    phi_1998_ = type_41();
                                    phi_1999_ = f32();
                                    phi_2000_ = f32();
                                } else {
                                    let _e420 = (_e409 < 0f);
                                    if (_e407 < 10u) {
                                    } else {
                                        phi_2179_ = true;
                                        break;
                                    }
                                    let _e425 = params.member.member_2[_e407];
                                    let _e426 = (_e407 & 31u);
                                    let _e428 = (1u << bitcast<u32>(_e426));
                                    let _e429 = (_e428 - 1u);
                                    let _e432 = ((_e193.x + _e429) >> bitcast<u32>(_e426));
                                    let _e435 = ((_e193.y + _e429) >> bitcast<u32>(_e426));
                                    let _e438 = ((_e193.z + _e429) >> bitcast<u32>(_e426));
                                    let _e440 = (1f / f32(_e428));
                                    if _e382 {
                                        phi_687_ = _e432;
                                    } else {
                                        phi_687_ = select(_e438, _e435, (_e381 == 1u));
                                    }
                                    let _e444 = phi_687_;
                                    if (_e405 < 0i) {
                                        phi_2197_ = _e336;
                                        phi_1673_ = vec4<f32>();
                                        phi_1674_ = true;
                                    } else {
                                        let _e447 = (_e405 >= bitcast<i32>(_e444));
                                        if _e447 {
                                            phi_2198_ = _e336;
                                            phi_1672_ = vec4<f32>();
                                        } else {
                                            let _e448 = f32(_e405);
                                            if _e382 {
                                                phi_704_ = _e448;
                                            } else {
                                                phi_704_ = (((_e171 + (_e146 * _e403)) * _e440) - 0.5f);
                                            }
                                            let _e452 = phi_704_;
                                            let _e453 = floor(_e452);
                                            let _e461 = select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < -2147483600f)), 2147483647i, (_e453 > 2147483500f)), (_e453 == _e453));
                                            let _e463 = (bitcast<i32>(_e432) - 1i);
                                            if (_e452 >= -0.5f) {
                                                phi_725_ = (_e452 <= (f32(_e463) + 0.5f));
                                            } else {
                                                phi_725_ = false;
                                            }
                                            let _e469 = phi_725_;
                                            let _e470 = (_e461 >= 0i);
                                            let _e471 = (_e461 < _e463);
                                            if _e470 {
                                                phi_737_ = bitcast<u32>(select(_e461, _e463, (_e463 < _e461)));
                                            } else {
                                                phi_737_ = 0u;
                                            }
                                            let _e476 = phi_737_;
                                            if _e471 {
                                                let _e477 = (_e461 + 1i);
                                                phi_748_ = bitcast<u32>(select(0i, _e477, (0i < _e477)));
                                            } else {
                                                phi_748_ = 0u;
                                            }
                                            let _e482 = phi_748_;
                                            if _e470 {
                                                phi_756_ = select(0f, (_e452 - _e453), _e471);
                                            } else {
                                                phi_756_ = 1f;
                                            }
                                            let _e485 = phi_756_;
                                            let _e487 = (_e476 >> bitcast<u32>(2u));
                                            let _e489 = (_e482 >> bitcast<u32>(2u));
                                            let _e496 = ((_e476 & 1u) | (((_e476 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                            let _e503 = ((_e482 & 1u) | (((_e482 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(3u)));
                                            if _e469 {
                                                phi_795_ = (1f - _e485);
                                            } else {
                                                phi_795_ = 0f;
                                            }
                                            let _e506 = phi_795_;
                                            let _e507 = select(0f, _e485, _e469);
                                            let _e508 = (_e381 == 1u);
                                            if _e508 {
                                                phi_806_ = _e448;
                                            } else {
                                                phi_806_ = (((_e172 + (_e147 * _e403)) * _e440) - 0.5f);
                                            }
                                            let _e512 = phi_806_;
                                            let _e514 = floor(_e512);
                                            let _e522 = select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < -2147483600f)), 2147483647i, (_e514 > 2147483500f)), (_e514 == _e514));
                                            let _e524 = (bitcast<i32>(_e435) - 1i);
                                            if (_e512 >= -0.5f) {
                                                phi_828_ = (_e512 <= (f32(_e524) + 0.5f));
                                            } else {
                                                phi_828_ = false;
                                            }
                                            let _e530 = phi_828_;
                                            let _e531 = (_e522 >= 0i);
                                            let _e532 = (_e522 < _e524);
                                            if _e531 {
                                                phi_840_ = bitcast<u32>(select(_e522, _e524, (_e524 < _e522)));
                                            } else {
                                                phi_840_ = 0u;
                                            }
                                            let _e537 = phi_840_;
                                            if _e532 {
                                                let _e538 = (_e522 + 1i);
                                                phi_851_ = bitcast<u32>(select(0i, _e538, (0i < _e538)));
                                            } else {
                                                phi_851_ = 0u;
                                            }
                                            let _e543 = phi_851_;
                                            if _e531 {
                                                phi_859_ = select(0f, (_e512 - _e514), _e532);
                                            } else {
                                                phi_859_ = 1f;
                                            }
                                            let _e546 = phi_859_;
                                            let _e549 = ((_e537 >> bitcast<u32>(2u)) * _e425.x);
                                            let _e552 = ((_e543 >> bitcast<u32>(2u)) * _e425.x);
                                            let _e561 = (((_e537 & 1u) << bitcast<u32>(1u)) | (((_e537 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                            let _e570 = (((_e543 & 1u) << bitcast<u32>(1u)) | (((_e543 >> bitcast<u32>(1i)) & 1u) << bitcast<u32>(4u)));
                                            if _e530 {
                                                phi_898_ = (1f - _e546);
                                            } else {
                                                phi_898_ = 0f;
                                            }
                                            let _e573 = phi_898_;
                                            let _e574 = select(0f, _e546, _e530);
                                            let _e575 = (_e381 == 2u);
                                            if _e575 {
                                                phi_909_ = _e448;
                                            } else {
                                                phi_909_ = (((_e173 + (_e148 * _e403)) * _e440) - 0.5f);
                                            }
                                            let _e579 = phi_909_;
                                            let _e581 = floor(_e579);
                                            let _e589 = select(0i, select(select(i32(_e581), i32(-2147483648), (_e581 < -2147483600f)), 2147483647i, (_e581 > 2147483500f)), (_e581 == _e581));
                                            let _e591 = (bitcast<i32>(_e438) - 1i);
                                            if (_e579 >= -0.5f) {
                                                phi_931_ = (_e579 <= (f32(_e591) + 0.5f));
                                            } else {
                                                phi_931_ = false;
                                            }
                                            let _e597 = phi_931_;
                                            let _e598 = (_e589 >= 0i);
                                            let _e599 = (_e589 < _e591);
                                            if _e598 {
                                                phi_943_ = bitcast<u32>(select(_e589, _e591, (_e591 < _e589)));
                                            } else {
                                                phi_943_ = 0u;
                                            }
                                            let _e604 = phi_943_;
                                            if _e599 {
                                                let _e605 = (_e589 + 1i);
                                                phi_954_ = bitcast<u32>(select(0i, _e605, (0i < _e605)));
                                            } else {
                                                phi_954_ = 0u;
                                            }
                                            let _e610 = phi_954_;
                                            if _e598 {
                                                phi_962_ = select(0f, (_e579 - _e581), _e599);
                                            } else {
                                                phi_962_ = 1f;
                                            }
                                            let _e613 = phi_962_;
                                            let _e616 = ((_e604 >> bitcast<u32>(1u)) * _e425.y);
                                            let _e619 = ((_e610 >> bitcast<u32>(1u)) * _e425.y);
                                            let _e622 = ((_e604 & 1u) << bitcast<u32>(2u));
                                            let _e625 = ((_e610 & 1u) << bitcast<u32>(2u));
                                            if _e597 {
                                                phi_1001_ = (1f - _e613);
                                            } else {
                                                phi_1001_ = 0f;
                                            }
                                            let _e628 = phi_1001_;
                                            let _e629 = select(0f, _e613, _e597);
                                            if _e382 {
                                                phi_1028_ = _e629;
                                                phi_1029_ = _e628;
                                                phi_1030_ = _e625;
                                                phi_1031_ = _e622;
                                                phi_1032_ = _e619;
                                                phi_1033_ = _e616;
                                                phi_1034_ = _e574;
                                                phi_1035_ = _e573;
                                                phi_1036_ = _e570;
                                                phi_1037_ = _e561;
                                                phi_1038_ = _e552;
                                                phi_1039_ = _e549;
                                                phi_1040_ = _e496;
                                                phi_1041_ = _e487;
                                            } else {
                                                phi_1028_ = select(_e574, _e507, _e508);
                                                phi_1029_ = select(_e573, _e506, _e508);
                                                phi_1030_ = select(_e570, _e503, _e508);
                                                phi_1031_ = select(_e561, _e496, _e508);
                                                phi_1032_ = select(_e552, _e489, _e508);
                                                phi_1033_ = select(_e549, _e487, _e508);
                                                phi_1034_ = select(_e507, _e629, _e508);
                                                phi_1035_ = select(_e506, _e628, _e508);
                                                phi_1036_ = select(_e503, _e625, _e508);
                                                phi_1037_ = select(_e496, _e622, _e508);
                                                phi_1038_ = select(_e489, _e619, _e508);
                                                phi_1039_ = select(_e487, _e616, _e508);
                                                phi_1040_ = select(_e622, _e561, _e508);
                                                phi_1041_ = select(_e616, _e549, _e508);
                                            }
                                            let _e645 = phi_1028_;
                                            let _e647 = phi_1029_;
                                            let _e649 = phi_1030_;
                                            let _e651 = phi_1031_;
                                            let _e653 = phi_1032_;
                                            let _e655 = phi_1033_;
                                            let _e657 = phi_1034_;
                                            let _e659 = phi_1035_;
                                            let _e661 = phi_1036_;
                                            let _e663 = phi_1037_;
                                            let _e665 = phi_1038_;
                                            let _e667 = phi_1039_;
                                            let _e669 = phi_1040_;
                                            let _e671 = phi_1041_;
                                            phi_2082_ = _e336;
                                            phi_1044_ = type_8(0u, 4u);
                                            phi_1047_ = vec4<f32>(0f, 0f, 0f, 0f);
                                            loop {
                                                let _e673 = phi_2082_;
                                                let _e675 = phi_1044_;
                                                let _e677 = phi_1047_;
                                                local_17 = _e677;
                                                if (_e675.member < _e675.member_1) {
                                                    phi_1045_ = type_8((_e675.member + 1u), _e675.member_1);
                                                    phi_1070_ = type_8(1u, _e675.member);
                                                } else {
                                                    phi_1045_ = _e675;
                                                    phi_1070_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e690 = phi_1045_;
                                                let _e692 = phi_1070_;
                                                let _e696 = (bitcast<i32>(_e692.member) != 0i);
                                                if _e696 {
                                                    let _e698 = ((_e692.member_1 & 1u) == 1u);
                                                    let _e700 = ((_e692.member_1 & 2u) == 2u);
                                                    let _e703 = (select(_e659, _e657, _e698) * select(_e647, _e645, _e700));
                                                    let _e709 = (((_e425.z + _e671) + select(_e667, _e665, _e698)) + select(_e655, _e653, _e700));
                                                    let _e714 = (2u * _e709);
                                                    if (_e714 < _e62) {
                                                    } else {
                                                        phi_2169_ = true;
                                                        break;
                                                    }
                                                    let _e717 = cells.member[_e714];
                                                    if (_e703 > 0f) {
                                                        let _e719 = (((_e669 | select(_e663, _e661, _e698)) | select(_e651, _e649, _e700)) & 31u);
                                                        if (((_e717 >> bitcast<u32>(_e719)) & 1u) == 1u) {
                                                            let _e726 = params.member.member_8;
                                                            let _e727 = (_e726 == 1u);
                                                            if (_e407 == 0u) {
                                                                let _e756 = (_e709 * 6u);
                                                                let _e757 = (_e714 + 1u);
                                                                if (_e757 < _e62) {
                                                                } else {
                                                                    phi_2169_ = true;
                                                                    break;
                                                                }
                                                                let _e760 = cells.member[_e757];
                                                                phi_1157_ = type_8(0u, 6u);
                                                                phi_1160_ = _e760;
                                                                loop {
                                                                    let _e762 = phi_1157_;
                                                                    let _e764 = phi_1160_;
                                                                    local = _e764;
                                                                    local_1 = _e764;
                                                                    local_8 = _e764;
                                                                    local_9 = _e764;
                                                                    if (_e762.member < _e762.member_1) {
                                                                        phi_1158_ = type_8((_e762.member + 1u), _e762.member_1);
                                                                        phi_1183_ = type_8(1u, _e762.member);
                                                                    } else {
                                                                        phi_1158_ = _e762;
                                                                        phi_1183_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e777 = phi_1158_;
                                                                    let _e779 = phi_1183_;
                                                                    let _e783 = (bitcast<i32>(_e779.member) != 0i);
                                                                    if _e783 {
                                                                        let _e784 = (_e756 + _e779.member_1);
                                                                        if (_e784 < _e65) {
                                                                        } else {
                                                                            phi_2071_ = true;
                                                                            break;
                                                                        }
                                                                        let _e787 = facet_bits.member[_e784];
                                                                        phi_1161_ = (_e764 + countOneBits((_e787 & ((1u << bitcast<u32>(_e719)) - 1u))));
                                                                    } else {
                                                                        phi_1161_ = u32();
                                                                    }
                                                                    let _e795 = phi_1161_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1157_ = _e777;
                                                                        phi_1160_ = _e795;
                                                                        phi_2071_ = _e673;
                                                                        break if !(_e783);
                                                                    }
                                                                }
                                                                let _e798 = phi_2071_;
                                                                phi_2169_ = _e798;
                                                                if _e798 {
                                                                    break;
                                                                }
                                                                if (_e756 < _e65) {
                                                                } else {
                                                                    phi_2169_ = true;
                                                                    break;
                                                                }
                                                                let _e801 = facet_bits.member[_e756];
                                                                let _e805 = (_e756 + 1u);
                                                                if (_e805 < _e65) {
                                                                } else {
                                                                    phi_2169_ = true;
                                                                    break;
                                                                }
                                                                let _e808 = facet_bits.member[_e805];
                                                                let _e813 = (_e756 + 2u);
                                                                if (_e813 < _e65) {
                                                                } else {
                                                                    phi_2169_ = true;
                                                                    break;
                                                                }
                                                                let _e816 = facet_bits.member[_e813];
                                                                let _e821 = (_e756 + 3u);
                                                                if (_e821 < _e65) {
                                                                } else {
                                                                    phi_2169_ = true;
                                                                    break;
                                                                }
                                                                let _e824 = facet_bits.member[_e821];
                                                                let _e829 = (_e756 + 4u);
                                                                if (_e829 < _e65) {
                                                                } else {
                                                                    phi_2169_ = true;
                                                                    break;
                                                                }
                                                                let _e832 = facet_bits.member[_e829];
                                                                let _e837 = (_e756 + 5u);
                                                                if (_e837 < _e65) {
                                                                } else {
                                                                    phi_2169_ = true;
                                                                    break;
                                                                }
                                                                let _e840 = facet_bits.member[_e837];
                                                                let _e844 = (((((((_e801 >> bitcast<u32>(_e719)) & 1u) + ((_e808 >> bitcast<u32>(_e719)) & 1u)) + ((_e816 >> bitcast<u32>(_e719)) & 1u)) + ((_e824 >> bitcast<u32>(_e719)) & 1u)) + ((_e832 >> bitcast<u32>(_e719)) & 1u)) + ((_e840 >> bitcast<u32>(_e719)) & 1u));
                                                                if _e727 {
                                                                    let _e972 = local_8;
                                                                    let _e975 = local_9;
                                                                    phi_1297_ = type_8(_e975, (_e972 + _e844));
                                                                    phi_1300_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    loop {
                                                                        let _e978 = phi_1297_;
                                                                        let _e980 = phi_1300_;
                                                                        local_16 = _e980;
                                                                        if (_e978.member < _e978.member_1) {
                                                                            phi_1298_ = type_8((_e978.member + 1u), _e978.member_1);
                                                                            phi_1323_ = type_8(1u, _e978.member);
                                                                        } else {
                                                                            phi_1298_ = _e978;
                                                                            phi_1323_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e993 = phi_1298_;
                                                                        let _e995 = phi_1323_;
                                                                        let _e999 = (bitcast<i32>(_e995.member) != 0i);
                                                                        if _e999 {
                                                                            let _e1000 = (2u * _e995.member_1);
                                                                            if (_e1000 < _e71) {
                                                                            } else {
                                                                                phi_2162_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1004 = radiance.member[_e1000][0u];
                                                                            let _e1007 = radiance.member[_e1000][1u];
                                                                            let _e1010 = radiance.member[_e1000][2u];
                                                                            let _e1011 = (_e1000 + 1u);
                                                                            if (_e1011 < _e71) {
                                                                            } else {
                                                                                phi_2162_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1015 = radiance.member[_e1011][0u];
                                                                            let _e1018 = radiance.member[_e1011][1u];
                                                                            let _e1021 = radiance.member[_e1011][2u];
                                                                            if (_e995.member_1 < _e68) {
                                                                            } else {
                                                                                phi_2162_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1031 = facets.member[_e995.member_1].member_2;
                                                                            let _e1040 = sqrt((((_e1031[0] * _e1031[0]) + (_e1031[1] * _e1031[1])) + (_e1031[2] * _e1031[2])));
                                                                            phi_1301_ = vec4<f32>((_e980.x + (select(_e1015, _e1004, (_e1004 > _e1015)) * _e1040)), (_e980.y + (select(_e1018, _e1007, (_e1007 > _e1018)) * _e1040)), (_e980.z + (select(_e1021, _e1010, (_e1010 > _e1021)) * _e1040)), (_e980.w + _e1040));
                                                                        } else {
                                                                            phi_1301_ = vec4<f32>();
                                                                        }
                                                                        let _e1054 = phi_1301_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_1297_ = _e993;
                                                                            phi_1300_ = _e1054;
                                                                            phi_2162_ = _e798;
                                                                            break if !(_e999);
                                                                        }
                                                                    }
                                                                    let _e1057 = phi_2162_;
                                                                    phi_2169_ = _e1057;
                                                                    if _e1057 {
                                                                        break;
                                                                    }
                                                                    phi_2177_ = _e1057;
                                                                    let _e1606 = local_16;
                                                                    phi_1584_ = _e1606;
                                                                } else {
                                                                    let _e845 = select(1f, -1f, _e420);
                                                                    let _e850 = local;
                                                                    let _e853 = local_1;
                                                                    phi_1448_ = type_8(_e853, (_e850 + _e844));
                                                                    phi_1451_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    phi_1453_ = vec4<f32>(0f, 0f, 0f, 0f);
                                                                    loop {
                                                                        let _e856 = phi_1448_;
                                                                        let _e858 = phi_1451_;
                                                                        let _e860 = phi_1453_;
                                                                        local_2 = _e858;
                                                                        local_3 = _e860;
                                                                        local_4 = _e858;
                                                                        local_5 = _e858;
                                                                        local_6 = _e858;
                                                                        local_7 = _e860;
                                                                        local_15 = _e860;
                                                                        if (_e856.member < _e856.member_1) {
                                                                            phi_1449_ = type_8((_e856.member + 1u), _e856.member_1);
                                                                            phi_1476_ = type_8(1u, _e856.member);
                                                                        } else {
                                                                            phi_1449_ = _e856;
                                                                            phi_1476_ = type_8(0u, type_8().member_1);
                                                                        }
                                                                        let _e873 = phi_1449_;
                                                                        let _e875 = phi_1476_;
                                                                        let _e879 = (bitcast<i32>(_e875.member) != 0i);
                                                                        if _e879 {
                                                                            if (_e875.member_1 < _e68) {
                                                                            } else {
                                                                                phi_2153_ = true;
                                                                                break;
                                                                            }
                                                                            let _e883 = facets.member[_e875.member_1].member_2;
                                                                            let _e892 = -((((select(0f, _e845, _e382) * _e883[0]) + (select(0f, _e845, _e508) * _e883[1])) + (select(0f, _e845, _e575) * _e883[2])));
                                                                            if (_e892 > 0f) {
                                                                                let _e914 = (2u * _e875.member_1);
                                                                                if (_e914 < _e71) {
                                                                                } else {
                                                                                    phi_2153_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e917 = radiance.member[_e914];
                                                                                phi_1560_ = _e858;
                                                                                phi_1561_ = vec4<f32>((_e860.x + (_e917.x * _e892)), (_e860.y + (_e917.y * _e892)), (_e860.z + (_e917.z * _e892)), (_e860.w + _e892));
                                                                            } else {
                                                                                let _e895 = ((2u * _e875.member_1) + 1u);
                                                                                if (_e895 < _e71) {
                                                                                } else {
                                                                                    phi_2153_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e898 = radiance.member[_e895];
                                                                                phi_1560_ = vec4<f32>((_e858.x - (_e898.x * _e892)), (_e858.y - (_e898.y * _e892)), (_e858.z - (_e898.z * _e892)), (_e858.w - _e892));
                                                                                phi_1561_ = _e860;
                                                                            }
                                                                            let _e934 = phi_1560_;
                                                                            let _e936 = phi_1561_;
                                                                            phi_1452_ = _e934;
                                                                            phi_1454_ = _e936;
                                                                        } else {
                                                                            phi_1452_ = vec4<f32>();
                                                                            phi_1454_ = vec4<f32>();
                                                                        }
                                                                        let _e938 = phi_1452_;
                                                                        let _e940 = phi_1454_;
                                                                        continue;
                                                                        continuing {
                                                                            phi_1448_ = _e873;
                                                                            phi_1451_ = _e938;
                                                                            phi_1453_ = _e940;
                                                                            phi_2153_ = _e798;
                                                                            break if !(_e879);
                                                                        }
                                                                    }
                                                                    let _e943 = phi_2153_;
                                                                    phi_2169_ = _e943;
                                                                    if _e943 {
                                                                        break;
                                                                    }
                                                                    let _e945 = local_2;
                                                                    let _e948 = local_3;
                                                                    if (_e945.w > _e948.w) {
                                                                        let _e951 = (_e945.w - _e948.w);
                                                                        let _e952 = (_e951 / _e945.w);
                                                                        let _e954 = local_4;
                                                                        let _e958 = local_5;
                                                                        let _e962 = local_6;
                                                                        let _e967 = local_7;
                                                                        phi_1583_ = (_e967 + vec4<f32>((_e954.x * _e952), (_e958.y * _e952), (_e962.z * _e952), _e951));
                                                                    } else {
                                                                        let _e1594 = local_15;
                                                                        phi_1583_ = _e1594;
                                                                    }
                                                                    let _e970 = phi_1583_;
                                                                    phi_2177_ = _e943;
                                                                    phi_1584_ = _e970;
                                                                }
                                                                let _e1059 = phi_2177_;
                                                                let _e1061 = phi_1584_;
                                                                if (_e1061.w > 1f) {
                                                                    phi_1598_ = vec4<f32>((_e1061.x / _e1061.w), (_e1061.y / _e1061.w), (_e1061.z / _e1061.w), 1f);
                                                                } else {
                                                                    phi_1598_ = _e1061;
                                                                }
                                                                let _e1072 = phi_1598_;
                                                                phi_2173_ = _e1059;
                                                                phi_1649_ = _e1072;
                                                            } else {
                                                                let _e729 = (_e714 + 1u);
                                                                if (_e729 < _e62) {
                                                                } else {
                                                                    phi_2169_ = true;
                                                                    break;
                                                                }
                                                                let _e732 = cells.member[_e729];
                                                                let _e738 = (_e732 + countOneBits((_e717 & ((1u << bitcast<u32>(_e719)) - 1u))));
                                                                if _e727 {
                                                                    phi_1624_ = _e738;
                                                                } else {
                                                                    phi_1624_ = (((6u * _e738) + (2u * _e381)) + select(0u, 1u, _e420));
                                                                }
                                                                let _e745 = phi_1624_;
                                                                if ((_e407 & 1u) == 1u) {
                                                                    if (_e745 < arrayLength((&odd.member))) {
                                                                    } else {
                                                                        phi_2169_ = true;
                                                                        break;
                                                                    }
                                                                    let _e753 = odd.member[_e745];
                                                                    phi_1648_ = _e753;
                                                                } else {
                                                                    if (_e745 < arrayLength((&even.member))) {
                                                                    } else {
                                                                        phi_2169_ = true;
                                                                        break;
                                                                    }
                                                                    let _e750 = even.member[_e745];
                                                                    phi_1648_ = _e750;
                                                                }
                                                                let _e755 = phi_1648_;
                                                                phi_2173_ = _e673;
                                                                phi_1649_ = _e755;
                                                            }
                                                            let _e1074 = phi_2173_;
                                                            let _e1076 = phi_1649_;
                                                            phi_2172_ = _e1074;
                                                            phi_1670_ = vec4<f32>((_e677.x + (_e1076.x * _e703)), (_e677.y + (_e1076.y * _e703)), (_e677.z + (_e1076.z * _e703)), (_e677.w + (_e1076.w * _e703)));
                                                        } else {
                                                            phi_2172_ = _e673;
                                                            phi_1670_ = _e677;
                                                        }
                                                        let _e1095 = phi_2172_;
                                                        let _e1097 = phi_1670_;
                                                        phi_2171_ = _e1095;
                                                        phi_1671_ = _e1097;
                                                    } else {
                                                        phi_2171_ = _e673;
                                                        phi_1671_ = _e677;
                                                    }
                                                    let _e1099 = phi_2171_;
                                                    let _e1101 = phi_1671_;
                                                    phi_2170_ = _e1099;
                                                    phi_1048_ = _e1101;
                                                } else {
                                                    phi_2170_ = _e673;
                                                    phi_1048_ = vec4<f32>();
                                                }
                                                let _e1103 = phi_2170_;
                                                let _e1105 = phi_1048_;
                                                continue;
                                                continuing {
                                                    phi_2082_ = _e1103;
                                                    phi_1044_ = _e690;
                                                    phi_1047_ = _e1105;
                                                    phi_2169_ = _e1103;
                                                    break if !(_e696);
                                                }
                                            }
                                            let _e1108 = phi_2169_;
                                            phi_2179_ = _e1108;
                                            if _e1108 {
                                                break;
                                            }
                                            phi_2198_ = _e1108;
                                            let _e1620 = local_17;
                                            phi_1672_ = _e1620;
                                        }
                                        let _e1110 = phi_2198_;
                                        let _e1112 = phi_1672_;
                                        phi_2197_ = _e1110;
                                        phi_1673_ = _e1112;
                                        phi_1674_ = _e447;
                                    }
                                    let _e1114 = phi_2197_;
                                    let _e1116 = phi_1673_;
                                    let _e1118 = phi_1674_;
                                    let _e1120 = select(_e1116, vec4<f32>(0f, 0f, 0f, 0f), vec4(_e1118));
                                    if (_e1120.w > 0f) {
                                        let _e1127 = select(_e411, _e1120.w, (_e1120.w < _e411));
                                        let _e1132 = ((_e350 * _e1127) / _e1120.w);
                                        phi_1718_ = vec3<f32>((_e340.x + (_e1120.x * _e1132)), (_e340.y + (_e1120.y * _e1132)), (_e340.z + (_e1120.z * _e1132)));
                                        phi_1719_ = (_e348 + _e1127);
                                        phi_1720_ = _e350;
                                    } else {
                                        let _e1123 = (_e381 == _e205);
                                        phi_1718_ = _e340;
                                        phi_1719_ = select(_e348, 0f, _e1123);
                                        phi_1720_ = select(_e350, _e412, _e1123);
                                    }
                                    let _e1145 = phi_1718_;
                                    let _e1147 = phi_1719_;
                                    let _e1149 = phi_1720_;
                                    let _e1150 = ((2f * _e177) * _e403);
                                    let _e1152 = ((_e181 * _e167) + ((_e181 * select(0f, _e187, (_e187 > 0f))) * _e403));
                                    let _e1154 = select(_e1152, _e1150, (_e1150 < _e1152));
                                    let _e1161 = ((bitcast<u32>((select(1f, _e1154, (_e1154 > 1f)) * 1.4142135f)) >> bitcast<u32>(23i)) - 127u);
                                    let _e1163 = (_e193.w - 1u);
                                    let _e1165 = select(_e1161, _e1163, (_e1163 < _e1161));
                                    if _e382 {
                                        let _e1326 = (_e346.member_1 < 0f);
                                        if _e1326 {
                                            phi_1763_ = (_e346.member_3 - 1i);
                                        } else {
                                            phi_1763_ = (_e346.member_3 + 1i);
                                        }
                                        let _e1334 = phi_1763_;
                                        let _e1340 = type_41(_e346.member, _e346.member_1, _e346.member_2, _e1334, _e346.member_4);
                                        if (((_e346.member_3 & 1i) == 0i) == _e1326) {
                                            if (_e1165 > _e346.member_2) {
                                                let _e1349 = type_41(_e1340.member, _e1340.member_1, (_e346.member_2 + 1u), _e1340.member_3, _e1340.member_4);
                                                phi_1778_ = type_41(_e1349.member, _e1349.member_1, _e1349.member_2, (_e1334 >> bitcast<u32>(1i)), _e1349.member_4);
                                            } else {
                                                phi_1778_ = _e1340;
                                            }
                                            let _e1359 = phi_1778_;
                                            phi_1779_ = _e1359;
                                        } else {
                                            phi_1779_ = _e1340;
                                        }
                                        let _e1361 = phi_1779_;
                                        let _e1363 = (_e1361.member_2 & 31u);
                                        let _e1365 = (1u << bitcast<u32>(_e1363));
                                        if (_e1361.member_1 < 0f) {
                                            phi_1798_ = (_e1361.member_3 < 0i);
                                        } else {
                                            phi_1798_ = (_e1361.member_3 >= bitcast<i32>((((_e193.x + _e1365) - 1u) >> bitcast<u32>(_e1363))));
                                        }
                                        let _e1378 = phi_1798_;
                                        if _e1378 {
                                            phi_1821_ = f32();
                                            phi_1822_ = true;
                                        } else {
                                            let _e1385 = (abs(_e1361.member_1) < 0.000001f);
                                            if _e1385 {
                                                phi_1820_ = f32();
                                            } else {
                                                phi_1820_ = ((((f32(_e1361.member_3) + 0.5f) * f32(_e1365)) - _e1361.member) / _e1361.member_1);
                                            }
                                            let _e1390 = phi_1820_;
                                            phi_1821_ = _e1390;
                                            phi_1822_ = _e1385;
                                        }
                                        let _e1392 = phi_1821_;
                                        let _e1394 = phi_1822_;
                                        phi_1992_ = _e342;
                                        phi_1993_ = _e344;
                                        phi_1994_ = type_41(_e1361.member, _e1361.member_1, _e1361.member_2, _e1361.member_3, select(_e1392, 340282350000000000000000000000000000000f, _e1394));
                                    } else {
                                        if (_e381 == 1u) {
                                            let _e1245 = (_e344.member_1 < 0f);
                                            if _e1245 {
                                                phi_1846_ = (_e344.member_3 - 1i);
                                            } else {
                                                phi_1846_ = (_e344.member_3 + 1i);
                                            }
                                            let _e1253 = phi_1846_;
                                            let _e1259 = type_41(_e344.member, _e344.member_1, _e344.member_2, _e1253, _e344.member_4);
                                            if (((_e344.member_3 & 1i) == 0i) == _e1245) {
                                                if (_e1165 > _e344.member_2) {
                                                    let _e1268 = type_41(_e1259.member, _e1259.member_1, (_e344.member_2 + 1u), _e1259.member_3, _e1259.member_4);
                                                    phi_1861_ = type_41(_e1268.member, _e1268.member_1, _e1268.member_2, (_e1253 >> bitcast<u32>(1i)), _e1268.member_4);
                                                } else {
                                                    phi_1861_ = _e1259;
                                                }
                                                let _e1278 = phi_1861_;
                                                phi_1862_ = _e1278;
                                            } else {
                                                phi_1862_ = _e1259;
                                            }
                                            let _e1280 = phi_1862_;
                                            let _e1282 = (_e1280.member_2 & 31u);
                                            let _e1284 = (1u << bitcast<u32>(_e1282));
                                            if (_e1280.member_1 < 0f) {
                                                phi_1881_ = (_e1280.member_3 < 0i);
                                            } else {
                                                phi_1881_ = (_e1280.member_3 >= bitcast<i32>((((_e193.y + _e1284) - 1u) >> bitcast<u32>(_e1282))));
                                            }
                                            let _e1297 = phi_1881_;
                                            if _e1297 {
                                                phi_1904_ = f32();
                                                phi_1905_ = true;
                                            } else {
                                                let _e1304 = (abs(_e1280.member_1) < 0.000001f);
                                                if _e1304 {
                                                    phi_1903_ = f32();
                                                } else {
                                                    phi_1903_ = ((((f32(_e1280.member_3) + 0.5f) * f32(_e1284)) - _e1280.member) / _e1280.member_1);
                                                }
                                                let _e1309 = phi_1903_;
                                                phi_1904_ = _e1309;
                                                phi_1905_ = _e1304;
                                            }
                                            let _e1311 = phi_1904_;
                                            let _e1313 = phi_1905_;
                                            phi_1990_ = _e342;
                                            phi_1991_ = type_41(_e1280.member, _e1280.member_1, _e1280.member_2, _e1280.member_3, select(_e1311, 340282350000000000000000000000000000000f, _e1313));
                                        } else {
                                            let _e1168 = (_e342.member_1 < 0f);
                                            if _e1168 {
                                                phi_1925_ = (_e342.member_3 - 1i);
                                            } else {
                                                phi_1925_ = (_e342.member_3 + 1i);
                                            }
                                            let _e1176 = phi_1925_;
                                            let _e1182 = type_41(_e342.member, _e342.member_1, _e342.member_2, _e1176, _e342.member_4);
                                            if (((_e342.member_3 & 1i) == 0i) == _e1168) {
                                                if (_e1165 > _e342.member_2) {
                                                    let _e1191 = type_41(_e1182.member, _e1182.member_1, (_e342.member_2 + 1u), _e1182.member_3, _e1182.member_4);
                                                    phi_1940_ = type_41(_e1191.member, _e1191.member_1, _e1191.member_2, (_e1176 >> bitcast<u32>(1i)), _e1191.member_4);
                                                } else {
                                                    phi_1940_ = _e1182;
                                                }
                                                let _e1201 = phi_1940_;
                                                phi_1941_ = _e1201;
                                            } else {
                                                phi_1941_ = _e1182;
                                            }
                                            let _e1203 = phi_1941_;
                                            let _e1205 = (_e1203.member_2 & 31u);
                                            let _e1207 = (1u << bitcast<u32>(_e1205));
                                            if (_e1203.member_1 < 0f) {
                                                phi_1960_ = (_e1203.member_3 < 0i);
                                            } else {
                                                phi_1960_ = (_e1203.member_3 >= bitcast<i32>((((_e193.z + _e1207) - 1u) >> bitcast<u32>(_e1205))));
                                            }
                                            let _e1220 = phi_1960_;
                                            if _e1220 {
                                                phi_1983_ = f32();
                                                phi_1984_ = true;
                                            } else {
                                                let _e1227 = (abs(_e1203.member_1) < 0.000001f);
                                                if _e1227 {
                                                    phi_1982_ = f32();
                                                } else {
                                                    phi_1982_ = ((((f32(_e1203.member_3) + 0.5f) * f32(_e1207)) - _e1203.member) / _e1203.member_1);
                                                }
                                                let _e1232 = phi_1982_;
                                                phi_1983_ = _e1232;
                                                phi_1984_ = _e1227;
                                            }
                                            let _e1234 = phi_1983_;
                                            let _e1236 = phi_1984_;
                                            phi_1990_ = type_41(_e1203.member, _e1203.member_1, _e1203.member_2, _e1203.member_3, select(_e1234, 340282350000000000000000000000000000000f, _e1236));
                                            phi_1991_ = _e344;
                                        }
                                        let _e1322 = phi_1990_;
                                        let _e1324 = phi_1991_;
                                        phi_1992_ = _e1322;
                                        phi_1993_ = _e1324;
                                        phi_1994_ = _e346;
                                    }
                                    let _e1403 = phi_1992_;
                                    let _e1405 = phi_1993_;
                                    let _e1407 = phi_1994_;
                                    phi_2182_ = _e1114;
                                    phi_1995_ = _e1145;
                                    phi_1996_ = _e1403;
                                    phi_1997_ = _e1405;
                                    phi_1998_ = _e1407;
                                    phi_1999_ = _e1147;
                                    phi_2000_ = _e1149;
                                }
                                let _e1409 = phi_2182_;
                                let _e1411 = phi_1995_;
                                let _e1413 = phi_1996_;
                                let _e1415 = phi_1997_;
                                let _e1417 = phi_1998_;
                                let _e1419 = phi_1999_;
                                let _e1421 = phi_2000_;
                                phi_2181_ = _e1409;
                                phi_2002_ = _e1411;
                                phi_2003_ = _e1413;
                                phi_2004_ = _e1415;
                                phi_2005_ = _e1417;
                                phi_2006_ = _e1419;
                                phi_2007_ = _e1421;
                                phi_2008_ = select(true, false, _e413);
                            }
                            let _e1424 = phi_2181_;
                            let _e1426 = phi_2002_;
                            let _e1428 = phi_2003_;
                            let _e1430 = phi_2004_;
                            let _e1432 = phi_2005_;
                            let _e1434 = phi_2006_;
                            let _e1436 = phi_2007_;
                            let _e1438 = phi_2008_;
                            phi_2180_ = _e1424;
                            phi_540_ = _e1426;
                            phi_542_ = _e1428;
                            phi_544_ = _e1430;
                            phi_546_ = _e1432;
                            phi_548_ = _e1434;
                            phi_550_ = _e1436;
                            phi_2010_ = _e1438;
                        } else {
                            phi_2180_ = _e336;
                            phi_540_ = vec3<f32>();
                            phi_542_ = type_41();
                            phi_544_ = type_41();
                            phi_546_ = type_41();
                            phi_548_ = f32();
                            phi_550_ = f32();
                            phi_2010_ = false;
                        }
                        let _e1440 = phi_2180_;
                        let _e1442 = phi_540_;
                        let _e1444 = phi_542_;
                        let _e1446 = phi_544_;
                        let _e1448 = phi_546_;
                        let _e1450 = phi_548_;
                        let _e1452 = phi_550_;
                        let _e1454 = phi_2010_;
                        continue;
                        continuing {
                            phi_2119_ = _e1440;
                            phi_536_ = _e363;
                            phi_539_ = _e1442;
                            phi_541_ = _e1444;
                            phi_543_ = _e1446;
                            phi_545_ = _e1448;
                            phi_547_ = _e1450;
                            phi_549_ = _e1452;
                            phi_2179_ = _e1440;
                            break if !(_e1454);
                        }
                    }
                    let _e1457 = phi_2179_;
                    if _e1457 {
                        break;
                    }
                    let _e1459 = local_10;
                    let _e1462 = local_11;
                    let _e1463 = (_e1462 * (1f - _e1459));
                    let _e1465 = local_12;
                    let _e1468 = local_13;
                    let _e1471 = local_14;
                    let _e1475 = params.member.member_5;
                    phi_2037_ = vec4<f32>((_e1465.x + (_e1475.x * _e1463)), (_e1468.y + (_e1475.y * _e1463)), (_e1471.z + (_e1475.z * _e1463)), _e1463);
                }
                let _e1487 = phi_2037_;
                if _e86 {
                } else {
                    break;
                }
                out.member[_e85] = _e1487;
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
