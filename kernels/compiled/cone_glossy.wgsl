struct type_8 {
    member: array<u32>,
}

struct type_16 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_24 {
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

struct type_28 {
    member: array<vec4<f32>>,
}

struct type_32 {
    member: array<type_24>,
}

struct type_36 {
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

struct type_37 {
    member: type_36,
}

struct type_39 {
    member: u32,
    member_1: i32,
    member_2: f32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_37;
@group(0) @binding(1) 
var<storage> cells: type_8;
@group(0) @binding(2) 
var<storage> facet_bits: type_8;
@group(0) @binding(3) 
var<storage> facets: type_18;
@group(0) @binding(4) 
var<storage> radiance: type_28;
@group(0) @binding(5) 
var<storage> odd: type_28;
@group(0) @binding(6) 
var<storage> even: type_28;
@group(0) @binding(7) 
var<storage> surfels: type_32;
@group(0) @binding(8) 
var<storage, read_write> out: type_28;

fn function_() {
    var phi_182_: vec3<f32>;
    var phi_272_: bool;
    var phi_281_: u32;
    var phi_299_: i32;
    var phi_313_: bool;
    var phi_344_: i32;
    var phi_358_: bool;
    var phi_389_: i32;
    var phi_403_: bool;
    var phi_454_: vec3<f32>;
    var phi_457_: type_39;
    var phi_459_: u32;
    var phi_461_: u32;
    var phi_463_: f32;
    var phi_465_: f32;
    var phi_467_: type_39;
    var phi_469_: type_39;
    var phi_471_: type_39;
    var phi_739_: f32;
    var phi_869_: f32;
    var phi_875_: vec4<f32>;
    var phi_878_: u32;
    var phi_1238_: u32;
    var phi_1250_: vec4<f32>;
    var phi_1044_: vec4<f32>;
    var phi_1047_: vec4<f32>;
    var phi_1049_: u32;
    var phi_1045_: vec4<f32>;
    var phi_1048_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var phi_1251_: vec4<f32>;
    var phi_876_: vec4<f32>;
    var phi_1277_: vec4<f32>;
    var phi_1317_: vec3<f32>;
    var phi_1318_: f32;
    var phi_1319_: f32;
    var phi_1361_: i32;
    var phi_1379_: bool;
    var phi_1400_: u32;
    var phi_1405_: i32;
    var phi_1410_: f32;
    var phi_1417_: u32;
    var phi_1422_: i32;
    var phi_1427_: f32;
    var phi_1434_: u32;
    var phi_1439_: i32;
    var phi_1444_: f32;
    var phi_455_: vec3<f32>;
    var phi_458_: type_39;
    var phi_460_: u32;
    var phi_462_: u32;
    var phi_464_: f32;
    var phi_466_: f32;
    var phi_468_: type_39;
    var phi_470_: type_39;
    var phi_472_: type_39;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: vec3<f32>;
    var local_11: f32;
    var local_12: f32;
    var local_13: f32;
    var local_14: f32;
    var phi_1500_: vec4<f32>;
    var local_15: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e52 = gid_1;
            let _e64 = (_e52.x + (_e52.y * 2097152u));
            let _e65 = (_e64 < arrayLength((&out.member)));
            if _e65 {
                let _e69 = surfels.member[_e64].member_1;
                if (_e69 == 4294967295u) {
                    phi_1500_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e74 = surfels.member[_e64].member;
                    let _e80 = params.member.member_6;
                    let _e84 = (_e80.x - _e74[0]);
                    let _e85 = (_e80.y - _e74[1]);
                    let _e86 = (_e80.z - _e74[2]);
                    let _e91 = (((_e84 * _e84) + (_e85 * _e85)) + (_e86 * _e86));
                    if (_e91 >= 0.000000000000000000000000000000000000011754944f) {
                        let _e94 = (1f / sqrt(_e91));
                        phi_182_ = vec3<f32>((_e84 * _e94), (_e85 * _e94), (_e86 * _e94));
                    } else {
                        phi_182_ = vec3<f32>(0f, 0f, 0f);
                    }
                    let _e100 = phi_182_;
                    let _e104 = surfels.member[_e64].member_2;
                    let _e116 = (2f * (((_e100.x * _e104[0]) + (_e100.y * _e104[1])) + (_e100.z * _e104[2])));
                    let _e120 = ((_e104[0] * _e116) - _e100.x);
                    let _e121 = ((_e104[1] * _e116) - _e100.y);
                    let _e122 = ((_e104[2] * _e116) - _e100.z);
                    let _e125 = params.member.member;
                    let _e139 = surfels.member[_e64].member_4;
                    let _e145 = params.member.member_12;
                    let _e149 = (((_e74[0] - _e125.x) / _e125.w) + (_e139[0] * _e145));
                    let _e150 = (((_e74[1] - _e125.y) / _e125.w) + (_e139[1] * _e145));
                    let _e151 = (((_e74[2] - _e125.z) / _e125.w) + (_e139[2] * _e145));
                    let _e155 = params.member.member_6[3u];
                    let _e159 = params.member.member_13;
                    let _e165 = (((_e120 * _e139[0]) + (_e121 * _e139[1])) + (_e122 * _e139[2]));
                    let _e171 = params.member.member_1;
                    let _e172 = abs(_e120);
                    let _e173 = abs(_e121);
                    let _e174 = abs(_e122);
                    if (_e172 >= _e173) {
                        phi_272_ = select(true, false, (_e172 >= _e174));
                    } else {
                        phi_272_ = true;
                    }
                    let _e179 = phi_272_;
                    if _e179 {
                        phi_281_ = select(2u, 1u, (_e173 >= _e174));
                    } else {
                        phi_281_ = 0u;
                    }
                    let _e183 = phi_281_;
                    let _e194 = (_e120 < 0f);
                    if _e194 {
                        phi_299_ = (i32(-(floor((0.5f - _e149)))) - 1i);
                    } else {
                        phi_299_ = (i32(floor((_e149 - 0.5f))) + 1i);
                    }
                    let _e198 = phi_299_;
                    if _e194 {
                        phi_313_ = (_e198 < 0i);
                    } else {
                        phi_313_ = (_e198 >= bitcast<i32>(_e171.x));
                    }
                    let _e203 = phi_313_;
                    let _e210 = select((((f32(_e198) + 0.5f) - _e149) / _e120), 340282350000000000000000000000000000000f, (_e203 || (_e172 < 0.000001f)));
                    let _e219 = (_e121 < 0f);
                    if _e219 {
                        phi_344_ = (i32(-(floor((0.5f - _e150)))) - 1i);
                    } else {
                        phi_344_ = (i32(floor((_e150 - 0.5f))) + 1i);
                    }
                    let _e223 = phi_344_;
                    if _e219 {
                        phi_358_ = (_e223 < 0i);
                    } else {
                        phi_358_ = (_e223 >= bitcast<i32>(_e171.y));
                    }
                    let _e228 = phi_358_;
                    let _e235 = select((((f32(_e223) + 0.5f) - _e150) / _e121), 340282350000000000000000000000000000000f, (_e228 || (_e173 < 0.000001f)));
                    let _e244 = (_e122 < 0f);
                    if _e244 {
                        phi_389_ = (i32(-(floor((0.5f - _e151)))) - 1i);
                    } else {
                        phi_389_ = (i32(floor((_e151 - 0.5f))) + 1i);
                    }
                    let _e248 = phi_389_;
                    if _e244 {
                        phi_403_ = (_e248 < 0i);
                    } else {
                        phi_403_ = (_e248 >= bitcast<i32>(_e171.z));
                    }
                    let _e253 = phi_403_;
                    let _e260 = select((((f32(_e248) + 0.5f) - _e151) / _e122), 340282350000000000000000000000000000000f, (_e253 || (_e174 < 0.000001f)));
                    let _e264 = ((_e210 <= _e235) && (_e210 <= _e260));
                    let _e265 = (_e235 <= _e260);
                    phi_454_ = vec3<f32>(0f, 0f, 0f);
                    phi_457_ = type_39(0u, select(select(_e248, _e223, _e265), _e198, _e264), select(select(_e260, _e235, _e265), _e210, _e264));
                    phi_459_ = select(select(2u, 1u, _e265), 0u, _e264);
                    phi_461_ = 0u;
                    phi_463_ = 0f;
                    phi_465_ = 1f;
                    phi_467_ = type_39(0u, _e248, _e260);
                    phi_469_ = type_39(0u, _e223, _e235);
                    phi_471_ = type_39(0u, _e198, _e210);
                    loop {
                        let _e274 = phi_454_;
                        let _e276 = phi_457_;
                        let _e278 = phi_459_;
                        let _e280 = phi_461_;
                        let _e282 = phi_463_;
                        let _e284 = phi_465_;
                        let _e286 = phi_467_;
                        let _e288 = phi_469_;
                        let _e290 = phi_471_;
                        local_8 = _e274;
                        local_9 = _e274;
                        local_10 = _e274;
                        let _e295 = (1f - _e282);
                        let _e296 = (_e284 * _e295);
                        let _e298 = (((_e280 < 2048u) && (_e276.member_2 < 340282350000000000000000000000000000000f)) && (_e296 >= 0.001f));
                        local_11 = _e296;
                        local_12 = _e296;
                        local_13 = _e296;
                        local_14 = _e296;
                        if _e298 {
                            let _e300 = (_e278 == 0u);
                            let _e302 = (_e278 == 2u);
                            let _e305 = select(select(_e121, _e120, _e300), _e122, _e302);
                            let _e316 = (_e305 < 0f);
                            let _e320 = params.member.member_2[_e276.member];
                            let _e321 = (_e276.member & 31u);
                            let _e323 = (1u << bitcast<u32>(_e321));
                            let _e324 = (_e323 - 1u);
                            let _e327 = ((_e171.x + _e324) >> bitcast<u32>(_e321));
                            let _e330 = ((_e171.y + _e324) >> bitcast<u32>(_e321));
                            let _e333 = ((_e171.z + _e324) >> bitcast<u32>(_e321));
                            if ((_e276.member_1 < 0i) || (_e276.member_1 >= bitcast<i32>(select(select(_e330, _e327, _e300), _e333, _e302)))) {
                                phi_1277_ = vec4<f32>(0f, 0f, 0f, 0f);
                            } else {
                                let _e341 = (1f / f32(_e323));
                                let _e343 = (((_e149 + (_e120 * _e276.member_2)) * _e341) - 0.5f);
                                let _e345 = (((_e150 + (_e121 * _e276.member_2)) * _e341) - 0.5f);
                                let _e347 = (((_e151 + (_e122 * _e276.member_2)) * _e341) - 0.5f);
                                let _e348 = bitcast<u32>(_e276.member_1);
                                let _e373 = select(select(_e347, _e345, _e300), _e343, _e302);
                                let _e377 = select(select(1u, 2u, _e300), 2u, _e302);
                                let _e379 = select(select(_e320.y, _e320.x, _e300), 1u, _e302);
                                let _e380 = select(2u, 1u, _e300);
                                let _e381 = select(_e380, 0u, _e302);
                                let _e382 = floor(_e373);
                                let _e384 = i32(_e382);
                                let _e386 = (bitcast<i32>(select(select(_e333, _e330, _e300), _e327, _e302)) - 1i);
                                let _e391 = ((_e373 >= -0.5f) && (_e373 <= (f32(_e386) + 0.5f)));
                                let _e393 = select(0i, _e384, (0i < _e384));
                                let _e396 = bitcast<u32>(select(_e393, _e386, (_e386 < _e393)));
                                let _e397 = (_e384 + 1i);
                                let _e399 = select(0i, _e397, (0i < _e397));
                                let _e402 = bitcast<u32>(select(_e399, _e386, (_e386 < _e399)));
                                let _e406 = select(select(0f, (_e373 - _e382), (_e384 < _e386)), 1f, (_e384 < 0i));
                                let _e407 = (_e377 & 31u);
                                let _e415 = (_e381 & 31u);
                                let _e420 = (_e377 - 1u);
                                let _e423 = ((_e381 + 3u) & 31u);
                                if _e391 {
                                    phi_739_ = (1f - _e406);
                                } else {
                                    phi_739_ = 0f;
                                }
                                let _e438 = phi_739_;
                                let _e441 = select(select(_e343, _e347, _e300), _e345, _e302);
                                let _e444 = select(_e380, 2u, _e302);
                                let _e446 = select(select(1u, _e320.y, _e300), _e320.x, _e302);
                                let _e448 = select(select(0u, 2u, _e300), 1u, _e302);
                                let _e449 = floor(_e441);
                                let _e451 = i32(_e449);
                                let _e453 = (bitcast<i32>(select(select(_e327, _e333, _e300), _e330, _e302)) - 1i);
                                let _e458 = ((_e441 >= -0.5f) && (_e441 <= (f32(_e453) + 0.5f)));
                                let _e460 = select(0i, _e451, (0i < _e451));
                                let _e463 = bitcast<u32>(select(_e460, _e453, (_e453 < _e460)));
                                let _e464 = (_e451 + 1i);
                                let _e466 = select(0i, _e464, (0i < _e464));
                                let _e469 = bitcast<u32>(select(_e466, _e453, (_e453 < _e466)));
                                let _e473 = select(select(0f, (_e441 - _e449), (_e451 < _e453)), 1f, (_e451 < 0i));
                                let _e474 = (_e444 & 31u);
                                let _e482 = (_e448 & 31u);
                                let _e487 = (_e444 - 1u);
                                let _e490 = ((_e448 + 3u) & 31u);
                                if _e458 {
                                    phi_869_ = (1f - _e473);
                                } else {
                                    phi_869_ = 0f;
                                }
                                let _e505 = phi_869_;
                                phi_875_ = vec4<f32>(0f, 0f, 0f, 0f);
                                phi_878_ = 0u;
                                loop {
                                    let _e508 = phi_875_;
                                    let _e510 = phi_878_;
                                    let _e512 = ((_e510 & 1u) == 1u);
                                    let _e514 = ((_e510 & 2u) == 2u);
                                    let _e517 = (select(_e438, select(0f, _e406, _e391), _e512) * select(_e505, select(0f, _e473, _e458), _e514));
                                    let _e523 = (((_e320.z + ((_e348 >> bitcast<u32>((select(2i, 1i, _e302) & 31i))) * select(select(_e320.x, 1u, _e300), _e320.y, _e302))) + select(((_e396 >> bitcast<u32>(_e407)) * _e379), ((_e402 >> bitcast<u32>(_e407)) * _e379), _e512)) + select(((_e463 >> bitcast<u32>(_e474)) * _e446), ((_e469 >> bitcast<u32>(_e474)) * _e446), _e514));
                                    let _e528 = (2u * _e523);
                                    let _e530 = cells.member[_e528];
                                    let _e532 = ((((((_e348 & 1u) << bitcast<u32>((_e278 & 31u))) | (((_e348 >> bitcast<u32>(1i)) & (select(2u, 1u, _e302) - 1u)) << bitcast<u32>(((_e278 + 3u) & 31u)))) | select((((_e396 & 1u) << bitcast<u32>(_e415)) | (((_e396 >> bitcast<u32>(1i)) & _e420) << bitcast<u32>(_e423))), (((_e402 & 1u) << bitcast<u32>(_e415)) | (((_e402 >> bitcast<u32>(1i)) & _e420) << bitcast<u32>(_e423))), _e512)) | select((((_e463 & 1u) << bitcast<u32>(_e482)) | (((_e463 >> bitcast<u32>(1i)) & _e487) << bitcast<u32>(_e490))), (((_e469 & 1u) << bitcast<u32>(_e482)) | (((_e469 >> bitcast<u32>(1i)) & _e487) << bitcast<u32>(_e490))), _e514)) & 31u);
                                    if ((_e517 > 0f) && (((_e530 >> bitcast<u32>(_e532)) & 1u) == 1u)) {
                                        let _e540 = params.member.member_8;
                                        let _e541 = (_e540 == 1u);
                                        if (_e276.member == 0u) {
                                            let _e567 = (_e523 * 6u);
                                            let _e570 = cells.member[(_e528 + 1u)];
                                            let _e572 = facet_bits.member[_e567];
                                            let _e575 = ((1u << bitcast<u32>(_e532)) - 1u);
                                            let _e584 = facet_bits.member[(_e567 + 1u)];
                                            let _e594 = facet_bits.member[(_e567 + 2u)];
                                            let _e604 = facet_bits.member[(_e567 + 3u)];
                                            let _e614 = facet_bits.member[(_e567 + 4u)];
                                            let _e624 = facet_bits.member[(_e567 + 5u)];
                                            let _e627 = ((((((_e570 + countOneBits((_e572 & _e575))) + countOneBits((_e584 & _e575))) + countOneBits((_e594 & _e575))) + countOneBits((_e604 & _e575))) + countOneBits((_e614 & _e575))) + countOneBits((_e624 & _e575)));
                                            let _e632 = select(1f, -1f, _e316);
                                            phi_1044_ = vec4<f32>(0f, 0f, 0f, 0f);
                                            phi_1047_ = vec4<f32>(0f, 0f, 0f, 0f);
                                            phi_1049_ = _e627;
                                            loop {
                                                let _e638 = phi_1044_;
                                                let _e640 = phi_1047_;
                                                let _e642 = phi_1049_;
                                                let _e645 = facets.member[_e642].member_2;
                                                let _e649 = (2u * _e642);
                                                let _e651 = radiance.member[_e649];
                                                let _e654 = radiance.member[(_e649 + 1u)];
                                                let _e659 = (((select(0f, _e632, _e300) * _e645[0]) + (select(0f, _e632, (_e278 == 1u)) * _e645[1])) + (select(0f, _e632, _e302) * _e645[2]));
                                                let _e660 = -(_e659);
                                                if _e541 {
                                                    let _e712 = sqrt((((_e645[0] * _e645[0]) + (_e645[1] * _e645[1])) + (_e645[2] * _e645[2])));
                                                    phi_1045_ = _e638;
                                                    phi_1048_ = vec4<f32>((_e640.x + (select(_e654.x, _e651.x, (_e651.x > _e654.x)) * _e712)), (_e640.y + (select(_e654.y, _e651.y, (_e651.y > _e654.y)) * _e712)), (_e640.z + (select(_e654.z, _e651.z, (_e651.z > _e654.z)) * _e712)), (_e640.w + _e712));
                                                } else {
                                                    let _e665 = select(0f, _e660, (_e660 > 0f));
                                                    let _e682 = select(0f, _e659, (_e659 > 0f));
                                                    phi_1045_ = vec4<f32>((_e638.x + (_e654.x * _e682)), (_e638.y + (_e654.y * _e682)), (_e638.z + (_e654.z * _e682)), (_e638.w + _e682));
                                                    phi_1048_ = vec4<f32>((_e640.x + (_e651.x * _e665)), (_e640.y + (_e651.y * _e665)), (_e640.z + (_e651.z * _e665)), (_e640.w + _e665));
                                                }
                                                let _e726 = phi_1045_;
                                                let _e728 = phi_1048_;
                                                let _e729 = (_e642 + 1u);
                                                local = _e726;
                                                local_1 = _e728;
                                                local_2 = _e726;
                                                local_3 = _e726;
                                                local_4 = _e726;
                                                local_5 = _e728;
                                                local_6 = _e728;
                                                local_7 = _e728;
                                                continue;
                                                continuing {
                                                    phi_1044_ = _e726;
                                                    phi_1047_ = _e728;
                                                    phi_1049_ = _e729;
                                                    break if !(select(true, false, (_e729 >= (_e627 + (((((((_e572 >> bitcast<u32>(_e532)) & 1u) + ((_e584 >> bitcast<u32>(_e532)) & 1u)) + ((_e594 >> bitcast<u32>(_e532)) & 1u)) + ((_e604 >> bitcast<u32>(_e532)) & 1u)) + ((_e614 >> bitcast<u32>(_e532)) & 1u)) + ((_e624 >> bitcast<u32>(_e532)) & 1u))))));
                                                }
                                            }
                                            let _e735 = local;
                                            let _e738 = local_1;
                                            let _e740 = (_e735.w - _e738.w);
                                            let _e745 = (select(0f, _e740, (_e740 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e735.w, (_e735.w > 0.000000000000000000000000000000000000011754944f)));
                                            let _e747 = local_2;
                                            let _e751 = local_3;
                                            let _e755 = local_4;
                                            let _e760 = local_5;
                                            let _e764 = local_6;
                                            let _e768 = local_7;
                                            let _e771 = (_e738.w + (_e735.w * _e745));
                                            let _e774 = (1f / select(1f, _e771, (_e771 > 1f)));
                                            phi_1251_ = vec4<f32>(((_e760.x + (_e747.x * _e745)) * _e774), ((_e764.y + (_e751.y * _e745)) * _e774), ((_e768.z + (_e755.z * _e745)) * _e774), select(1f, _e771, (_e771 < 1f)));
                                        } else {
                                            let _e545 = cells.member[(_e528 + 1u)];
                                            let _e551 = (_e545 + countOneBits((_e530 & ((1u << bitcast<u32>(_e532)) - 1u))));
                                            if _e541 {
                                                phi_1238_ = _e551;
                                            } else {
                                                phi_1238_ = (((6u * _e551) + (2u * _e278)) + select(0u, 1u, _e316));
                                            }
                                            let _e558 = phi_1238_;
                                            if ((_e276.member & 1u) == 1u) {
                                                let _e564 = odd.member[_e558];
                                                phi_1250_ = _e564;
                                            } else {
                                                let _e562 = even.member[_e558];
                                                phi_1250_ = _e562;
                                            }
                                            let _e566 = phi_1250_;
                                            phi_1251_ = _e566;
                                        }
                                        let _e782 = phi_1251_;
                                        phi_876_ = vec4<f32>((_e508.x + (_e782.x * _e517)), (_e508.y + (_e782.y * _e517)), (_e508.z + (_e782.z * _e517)), (_e508.w + (_e782.w * _e517)));
                                    } else {
                                        phi_876_ = _e508;
                                    }
                                    let _e801 = phi_876_;
                                    let _e802 = (_e510 + 1u);
                                    local_15 = _e801;
                                    continue;
                                    continuing {
                                        phi_875_ = _e801;
                                        phi_878_ = _e802;
                                        break if !(select(true, false, (_e802 == 4u)));
                                    }
                                }
                                let _e1027 = local_15;
                                phi_1277_ = _e1027;
                            }
                            let _e807 = phi_1277_;
                            if (_e807.w > 0f) {
                                let _e814 = select(_e295, _e807.w, (_e807.w < _e295));
                                let _e819 = ((_e284 * _e814) / _e807.w);
                                phi_1317_ = vec3<f32>((_e274.x + (_e807.x * _e819)), (_e274.y + (_e807.y * _e819)), (_e274.z + (_e807.z * _e819)));
                                phi_1318_ = (_e282 + _e814);
                                phi_1319_ = _e284;
                            } else {
                                let _e810 = (_e278 == _e183);
                                phi_1317_ = _e274;
                                phi_1318_ = select(_e282, 0f, _e810);
                                phi_1319_ = select(_e284, _e296, _e810);
                            }
                            let _e832 = phi_1317_;
                            let _e834 = phi_1318_;
                            let _e836 = phi_1319_;
                            let _e837 = ((2f * _e155) * _e276.member_2);
                            let _e839 = ((_e159 * _e145) + ((_e159 * select(0f, _e165, (_e165 > 0f))) * _e276.member_2));
                            let _e841 = select(_e839, _e837, (_e837 < _e839));
                            let _e848 = ((bitcast<u32>((select(1f, _e841, (_e841 > 1f)) * 1.4142135f)) >> bitcast<u32>(23i)) - 127u);
                            let _e850 = (_e171.w - 1u);
                            let _e858 = select(0u, 1u, ((((_e276.member_1 & 1i) == 0i) == _e316) && (select(_e848, _e850, (_e850 < _e848)) > _e276.member)));
                            if _e316 {
                                phi_1361_ = (_e276.member_1 - 1i);
                            } else {
                                phi_1361_ = (_e276.member_1 + 1i);
                            }
                            let _e862 = phi_1361_;
                            let _e863 = (_e276.member + _e858);
                            let _e866 = (_e862 >> bitcast<u32>((_e858 & 31u)));
                            let _e867 = (_e863 & 31u);
                            let _e869 = (1u << bitcast<u32>(_e867));
                            if _e316 {
                                phi_1379_ = (_e866 < 0i);
                            } else {
                                phi_1379_ = (_e866 >= bitcast<i32>((((select(select(_e171.y, _e171.x, _e300), _e171.z, _e302) + _e869) - 1u) >> bitcast<u32>(_e867))));
                            }
                            let _e878 = phi_1379_;
                            let _e888 = select(((((f32(_e866) + 0.5f) * f32(_e869)) - select(select(_e150, _e149, _e300), _e151, _e302)) / _e305), 340282350000000000000000000000000000000f, (_e878 || (abs(_e305) < 0.000001f)));
                            if _e300 {
                                phi_1400_ = _e863;
                            } else {
                                phi_1400_ = _e290.member;
                            }
                            let _e891 = phi_1400_;
                            if _e300 {
                                phi_1405_ = _e866;
                            } else {
                                phi_1405_ = _e290.member_1;
                            }
                            let _e894 = phi_1405_;
                            if _e300 {
                                phi_1410_ = _e888;
                            } else {
                                phi_1410_ = _e290.member_2;
                            }
                            let _e897 = phi_1410_;
                            let _e899 = (_e278 == 1u);
                            if _e899 {
                                phi_1417_ = _e863;
                            } else {
                                phi_1417_ = _e288.member;
                            }
                            let _e902 = phi_1417_;
                            if _e899 {
                                phi_1422_ = _e866;
                            } else {
                                phi_1422_ = _e288.member_1;
                            }
                            let _e905 = phi_1422_;
                            if _e899 {
                                phi_1427_ = _e888;
                            } else {
                                phi_1427_ = _e288.member_2;
                            }
                            let _e908 = phi_1427_;
                            if _e302 {
                                phi_1434_ = _e863;
                            } else {
                                phi_1434_ = _e286.member;
                            }
                            let _e912 = phi_1434_;
                            if _e302 {
                                phi_1439_ = _e866;
                            } else {
                                phi_1439_ = _e286.member_1;
                            }
                            let _e915 = phi_1439_;
                            if _e302 {
                                phi_1444_ = _e888;
                            } else {
                                phi_1444_ = _e286.member_2;
                            }
                            let _e918 = phi_1444_;
                            let _e922 = ((_e897 <= _e908) && (_e897 <= _e918));
                            let _e923 = (_e908 <= _e918);
                            phi_455_ = _e832;
                            phi_458_ = type_39(select(select(_e912, _e902, _e923), _e891, _e922), select(select(_e915, _e905, _e923), _e894, _e922), select(select(_e918, _e908, _e923), _e897, _e922));
                            phi_460_ = select(select(2u, 1u, _e923), 0u, _e922);
                            phi_462_ = (_e280 + 1u);
                            phi_464_ = _e834;
                            phi_466_ = _e836;
                            phi_468_ = type_39(_e912, _e915, _e918);
                            phi_470_ = type_39(_e902, _e905, _e908);
                            phi_472_ = type_39(_e891, _e894, _e897);
                        } else {
                            phi_455_ = vec3<f32>();
                            phi_458_ = type_39();
                            phi_460_ = u32();
                            phi_462_ = u32();
                            phi_464_ = f32();
                            phi_466_ = f32();
                            phi_468_ = type_39();
                            phi_470_ = type_39();
                            phi_472_ = type_39();
                        }
                        let _e934 = phi_455_;
                        let _e936 = phi_458_;
                        let _e938 = phi_460_;
                        let _e940 = phi_462_;
                        let _e942 = phi_464_;
                        let _e944 = phi_466_;
                        let _e946 = phi_468_;
                        let _e948 = phi_470_;
                        let _e950 = phi_472_;
                        continue;
                        continuing {
                            phi_454_ = _e934;
                            phi_457_ = _e936;
                            phi_459_ = _e938;
                            phi_461_ = _e940;
                            phi_463_ = _e942;
                            phi_465_ = _e944;
                            phi_467_ = _e946;
                            phi_469_ = _e948;
                            phi_471_ = _e950;
                            break if !(_e298);
                        }
                    }
                    let _e953 = local_8;
                    let _e956 = local_9;
                    let _e959 = local_10;
                    let _e963 = params.member.member_5;
                    let _e968 = local_11;
                    let _e971 = local_12;
                    let _e974 = local_13;
                    let _e980 = local_14;
                    phi_1500_ = vec4<f32>((_e953.x + (_e963.x * _e968)), (_e956.y + (_e963.y * _e971)), (_e959.z + (_e963.z * _e974)), _e980);
                }
                let _e983 = phi_1500_;
                if _e65 {
                } else {
                    break;
                }
                out.member[_e64] = _e983;
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
