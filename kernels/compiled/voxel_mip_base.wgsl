struct type_7 {
    member: array<u32>,
}

struct type_13 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: array<vec4<f32>>,
}

struct type_24 {
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

struct type_25 {
    member: type_24,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> cells: type_7;
@group(0) @binding(2) 
var<storage> facet_bits: type_7;
@group(0) @binding(3) 
var<storage> facets: type_15;
@group(0) @binding(4) 
var<storage> radiance: type_21;
@group(0) @binding(0) 
var<uniform> params: type_25;
@group(0) @binding(5) 
var<storage> children: type_7;
@group(0) @binding(6) 
var<storage, read_write> out: type_21;

fn function_() {
    var phi_261_: vec4<f32>;
    var phi_264_: vec4<f32>;
    var phi_266_: u32;
    var phi_262_: vec4<f32>;
    var phi_265_: vec4<f32>;
    var local: vec4<f32>;
    var local_1: vec4<f32>;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var phi_411_: vec4<f32>;
    var phi_425_: vec4<f32>;
    var phi_428_: array<vec4<f32>, 8>;
    var phi_429_: u32;
    var phi_449_: vec4<f32>;
    var phi_452_: vec4<f32>;
    var phi_454_: u32;
    var phi_450_: vec4<f32>;
    var phi_453_: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var local_11: vec4<f32>;
    var phi_599_: vec4<f32>;
    var phi_613_: vec4<f32>;
    var phi_616_: array<vec4<f32>, 8>;
    var phi_617_: u32;
    var phi_637_: vec4<f32>;
    var phi_640_: vec4<f32>;
    var phi_642_: u32;
    var phi_638_: vec4<f32>;
    var phi_641_: vec4<f32>;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var phi_787_: vec4<f32>;
    var phi_801_: vec4<f32>;
    var phi_804_: array<vec4<f32>, 8>;
    var phi_805_: u32;
    var phi_825_: vec4<f32>;
    var phi_828_: vec4<f32>;
    var phi_830_: u32;
    var phi_826_: vec4<f32>;
    var phi_829_: vec4<f32>;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: vec4<f32>;
    var local_21: vec4<f32>;
    var local_22: vec4<f32>;
    var local_23: vec4<f32>;
    var phi_975_: vec4<f32>;
    var phi_989_: vec4<f32>;
    var phi_992_: array<vec4<f32>, 8>;
    var phi_993_: u32;
    var phi_1013_: vec4<f32>;
    var phi_1016_: vec4<f32>;
    var phi_1018_: u32;
    var phi_1014_: vec4<f32>;
    var phi_1017_: vec4<f32>;
    var local_24: vec4<f32>;
    var local_25: vec4<f32>;
    var local_26: vec4<f32>;
    var local_27: vec4<f32>;
    var local_28: vec4<f32>;
    var local_29: vec4<f32>;
    var phi_1163_: vec4<f32>;
    var phi_1177_: vec4<f32>;
    var phi_1180_: array<vec4<f32>, 8>;
    var phi_1181_: u32;
    var phi_1201_: vec4<f32>;
    var phi_1204_: vec4<f32>;
    var phi_1206_: u32;
    var phi_1202_: vec4<f32>;
    var phi_1205_: vec4<f32>;
    var local_30: vec4<f32>;
    var local_31: vec4<f32>;
    var local_32: vec4<f32>;
    var local_33: vec4<f32>;
    var local_34: vec4<f32>;
    var local_35: vec4<f32>;
    var phi_1351_: vec4<f32>;
    var phi_1365_: vec4<f32>;
    var phi_1368_: array<vec4<f32>, 8>;
    var phi_1369_: u32;
    var phi_1389_: vec4<f32>;
    var phi_1392_: vec4<f32>;
    var phi_1394_: u32;
    var phi_1390_: vec4<f32>;
    var phi_1393_: vec4<f32>;
    var local_36: vec4<f32>;
    var local_37: vec4<f32>;
    var local_38: vec4<f32>;
    var local_39: vec4<f32>;
    var local_40: vec4<f32>;
    var local_41: vec4<f32>;
    var phi_1539_: vec4<f32>;
    var phi_1553_: vec4<f32>;
    var phi_1556_: array<vec4<f32>, 8>;
    var phi_1557_: u32;
    var phi_1577_: vec4<f32>;
    var phi_1580_: vec4<f32>;
    var phi_1582_: u32;
    var phi_1578_: vec4<f32>;
    var phi_1581_: vec4<f32>;
    var local_42: vec4<f32>;
    var local_43: vec4<f32>;
    var local_44: vec4<f32>;
    var local_45: vec4<f32>;
    var local_46: vec4<f32>;
    var local_47: vec4<f32>;
    var phi_1727_: vec4<f32>;
    var phi_1741_: vec4<f32>;
    var phi_1743_: array<vec4<f32>, 8>;
    var phi_1849_: vec4<f32>;
    var phi_1901_: vec4<f32>;
    var phi_1927_: vec4<f32>;
    var phi_1979_: vec4<f32>;
    var phi_2004_: vec4<f32>;
    var phi_2069_: vec4<f32>;
    var phi_2090_: vec4<f32>;
    var phi_2143_: vec4<f32>;
    var phi_1832_: vec4<f32>;
    var phi_2157_: vec4<f32>;
    var local_48: vec4<f32>;
    var local_49: u32;
    var local_50: vec4<f32>;
    var local_51: u32;
    var local_52: vec4<f32>;
    var local_53: u32;
    var local_54: vec4<f32>;
    var local_55: u32;
    var local_56: vec4<f32>;
    var local_57: u32;
    var local_58: vec4<f32>;
    var local_59: u32;
    var local_60: vec4<f32>;
    var local_61: u32;
    var local_62: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e39 = gid_1;
            let _e44 = params.member.member_12;
            let _e47 = params.member.member_13;
            let _e51 = (_e39.x + (_e39.y * 2097152u));
            if (_e51 < _e47) {
                let _e55 = params.member.member_6;
                if (_e55 == 0u) {
                    break;
                }
                let _e57 = (_e51 / _e55);
                let _e59 = (_e51 - (_e57 * _e55));
                let _e62 = children.member[_e57];
                let _e64 = (_e62 >> bitcast<u32>(2i));
                let _e67 = (2u * _e64);
                let _e70 = cells.member[_e67];
                let _e71 = ((8u * (_e62 & 3u)) & 31u);
                let _e73 = (_e70 >> bitcast<u32>(_e71));
                let _e74 = (_e64 * 6u);
                let _e78 = cells.member[(_e67 + 1u)];
                let _e81 = facet_bits.member[_e74];
                let _e84 = ((1u << bitcast<u32>(_e71)) - 1u);
                let _e94 = facet_bits.member[(_e74 + 1u)];
                let _e107 = facet_bits.member[(_e74 + 2u)];
                let _e120 = facet_bits.member[(_e74 + 3u)];
                let _e129 = (((((_e81 >> bitcast<u32>(_e71)) & 255u) | (((_e94 >> bitcast<u32>(_e71)) & 255u) << bitcast<u32>(8u))) | (((_e107 >> bitcast<u32>(_e71)) & 255u) << bitcast<u32>(16u))) | (((_e120 >> bitcast<u32>(_e71)) & 255u) << bitcast<u32>(24u)));
                let _e133 = facet_bits.member[(_e74 + 4u)];
                let _e143 = facet_bits.member[(_e74 + 5u)];
                let _e146 = ((((((_e78 + countOneBits((_e81 & _e84))) + countOneBits((_e94 & _e84))) + countOneBits((_e107 & _e84))) + countOneBits((_e120 & _e84))) + countOneBits((_e133 & _e84))) + countOneBits((_e143 & _e84)));
                let _e152 = (((_e133 >> bitcast<u32>(_e71)) & 255u) | (((_e143 >> bitcast<u32>(_e71)) & 255u) << bitcast<u32>(8u)));
                let _e154 = (_e59 >> bitcast<u32>(1i));
                let _e156 = ((_e59 & 1u) == 1u);
                let _e157 = select(1f, -1f, _e156);
                let _e158 = (_e154 == 0u);
                let _e159 = select(0f, _e157, _e158);
                let _e160 = (_e154 == 1u);
                let _e161 = select(0f, _e157, _e160);
                let _e163 = select(0f, _e157, (_e154 == 2u));
                if ((_e73 & 1u) == 1u) {
                    phi_261_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_264_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_266_ = _e146;
                    loop {
                        let _e173 = phi_261_;
                        let _e175 = phi_264_;
                        let _e177 = phi_266_;
                        let _e181 = facets.member[_e177].member_2;
                        let _e185 = (2u * _e177);
                        let _e188 = radiance.member[_e185];
                        let _e192 = radiance.member[(_e185 + 1u)];
                        let _e197 = (((_e159 * _e181[0]) + (_e161 * _e181[1])) + (_e163 * _e181[2]));
                        let _e198 = -(_e197);
                        if (_e55 == 1u) {
                            let _e250 = sqrt((((_e181[0] * _e181[0]) + (_e181[1] * _e181[1])) + (_e181[2] * _e181[2])));
                            phi_262_ = _e173;
                            phi_265_ = vec4<f32>((_e175.x + (select(_e192.x, _e188.x, (_e188.x > _e192.x)) * _e250)), (_e175.y + (select(_e192.y, _e188.y, (_e188.y > _e192.y)) * _e250)), (_e175.z + (select(_e192.z, _e188.z, (_e188.z > _e192.z)) * _e250)), (_e175.w + _e250));
                        } else {
                            let _e203 = select(0f, _e198, (_e198 > 0f));
                            let _e220 = select(0f, _e197, (_e197 > 0f));
                            phi_262_ = vec4<f32>((_e173.x + (_e192.x * _e220)), (_e173.y + (_e192.y * _e220)), (_e173.z + (_e192.z * _e220)), (_e173.w + _e220));
                            phi_265_ = vec4<f32>((_e175.x + (_e188.x * _e203)), (_e175.y + (_e188.y * _e203)), (_e175.z + (_e188.z * _e203)), (_e175.w + _e203));
                        }
                        let _e264 = phi_262_;
                        let _e266 = phi_265_;
                        let _e267 = (_e177 + 1u);
                        let _e268 = (_e146 + (countOneBits((_e129 & 16843009u)) + countOneBits((_e152 & 257u))));
                        local = _e264;
                        local_1 = _e266;
                        local_2 = _e264;
                        local_3 = _e264;
                        local_4 = _e264;
                        local_5 = _e266;
                        local_48 = _e266;
                        local_49 = _e268;
                        continue;
                        continuing {
                            phi_261_ = _e264;
                            phi_264_ = _e266;
                            phi_266_ = _e267;
                            break if !(select(true, false, (_e267 >= _e268)));
                        }
                    }
                    let _e273 = local;
                    let _e276 = local_1;
                    if (_e273.w > _e276.w) {
                        let _e279 = (_e273.w - _e276.w);
                        let _e280 = (_e279 / _e273.w);
                        let _e282 = local_2;
                        let _e286 = local_3;
                        let _e290 = local_4;
                        let _e295 = local_5;
                        phi_411_ = (_e295 + vec4<f32>((_e282.x * _e280), (_e286.y * _e280), (_e290.z * _e280), _e279));
                    } else {
                        let _e1775 = local_48;
                        phi_411_ = _e1775;
                    }
                    let _e298 = phi_411_;
                    if (_e298.w > 1f) {
                        phi_425_ = vec4<f32>((_e298.x / _e298.w), (_e298.y / _e298.w), (_e298.z / _e298.w), 1f);
                    } else {
                        phi_425_ = _e298;
                    }
                    let _e309 = phi_425_;
                    phi_428_ = array<vec4<f32>, 8>(_e309, vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                    let _e1780 = local_49;
                    phi_429_ = _e1780;
                } else {
                    phi_428_ = array<vec4<f32>, 8>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                    phi_429_ = _e146;
                }
                let _e312 = phi_428_;
                let _e314 = phi_429_;
                if (((_e73 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    phi_449_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_452_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_454_ = _e314;
                    loop {
                        let _e330 = phi_449_;
                        let _e332 = phi_452_;
                        let _e334 = phi_454_;
                        let _e338 = facets.member[_e334].member_2;
                        let _e342 = (2u * _e334);
                        let _e345 = radiance.member[_e342];
                        let _e349 = radiance.member[(_e342 + 1u)];
                        let _e354 = (((_e159 * _e338[0]) + (_e161 * _e338[1])) + (_e163 * _e338[2]));
                        let _e355 = -(_e354);
                        if (_e55 == 1u) {
                            let _e407 = sqrt((((_e338[0] * _e338[0]) + (_e338[1] * _e338[1])) + (_e338[2] * _e338[2])));
                            phi_450_ = _e330;
                            phi_453_ = vec4<f32>((_e332.x + (select(_e349.x, _e345.x, (_e345.x > _e349.x)) * _e407)), (_e332.y + (select(_e349.y, _e345.y, (_e345.y > _e349.y)) * _e407)), (_e332.z + (select(_e349.z, _e345.z, (_e345.z > _e349.z)) * _e407)), (_e332.w + _e407));
                        } else {
                            let _e360 = select(0f, _e355, (_e355 > 0f));
                            let _e377 = select(0f, _e354, (_e354 > 0f));
                            phi_450_ = vec4<f32>((_e330.x + (_e349.x * _e377)), (_e330.y + (_e349.y * _e377)), (_e330.z + (_e349.z * _e377)), (_e330.w + _e377));
                            phi_453_ = vec4<f32>((_e332.x + (_e345.x * _e360)), (_e332.y + (_e345.y * _e360)), (_e332.z + (_e345.z * _e360)), (_e332.w + _e360));
                        }
                        let _e421 = phi_450_;
                        let _e423 = phi_453_;
                        let _e424 = (_e334 + 1u);
                        let _e425 = (_e314 + (countOneBits(((_e129 >> bitcast<u32>(1u)) & 16843009u)) + countOneBits(((_e152 >> bitcast<u32>(1u)) & 257u))));
                        local_6 = _e421;
                        local_7 = _e423;
                        local_8 = _e421;
                        local_9 = _e421;
                        local_10 = _e421;
                        local_11 = _e423;
                        local_50 = _e423;
                        local_51 = _e425;
                        continue;
                        continuing {
                            phi_449_ = _e421;
                            phi_452_ = _e423;
                            phi_454_ = _e424;
                            break if !(select(true, false, (_e424 >= _e425)));
                        }
                    }
                    let _e430 = local_6;
                    let _e433 = local_7;
                    if (_e430.w > _e433.w) {
                        let _e436 = (_e430.w - _e433.w);
                        let _e437 = (_e436 / _e430.w);
                        let _e439 = local_8;
                        let _e443 = local_9;
                        let _e447 = local_10;
                        let _e452 = local_11;
                        phi_599_ = (_e452 + vec4<f32>((_e439.x * _e437), (_e443.y * _e437), (_e447.z * _e437), _e436));
                    } else {
                        let _e1794 = local_50;
                        phi_599_ = _e1794;
                    }
                    let _e455 = phi_599_;
                    if (_e455.w > 1f) {
                        phi_613_ = vec4<f32>((_e455.x / _e455.w), (_e455.y / _e455.w), (_e455.z / _e455.w), 1f);
                    } else {
                        phi_613_ = _e455;
                    }
                    let _e466 = phi_613_;
                    phi_616_ = array<vec4<f32>, 8>(_e312[0], _e466, _e312[2], _e312[3], _e312[4], _e312[5], _e312[6], _e312[7]);
                    let _e1799 = local_51;
                    phi_617_ = _e1799;
                } else {
                    phi_616_ = _e312;
                    phi_617_ = _e314;
                }
                let _e477 = phi_616_;
                let _e479 = phi_617_;
                if (((_e73 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    phi_637_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_640_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_642_ = _e479;
                    loop {
                        let _e495 = phi_637_;
                        let _e497 = phi_640_;
                        let _e499 = phi_642_;
                        let _e503 = facets.member[_e499].member_2;
                        let _e507 = (2u * _e499);
                        let _e510 = radiance.member[_e507];
                        let _e514 = radiance.member[(_e507 + 1u)];
                        let _e519 = (((_e159 * _e503[0]) + (_e161 * _e503[1])) + (_e163 * _e503[2]));
                        let _e520 = -(_e519);
                        if (_e55 == 1u) {
                            let _e572 = sqrt((((_e503[0] * _e503[0]) + (_e503[1] * _e503[1])) + (_e503[2] * _e503[2])));
                            phi_638_ = _e495;
                            phi_641_ = vec4<f32>((_e497.x + (select(_e514.x, _e510.x, (_e510.x > _e514.x)) * _e572)), (_e497.y + (select(_e514.y, _e510.y, (_e510.y > _e514.y)) * _e572)), (_e497.z + (select(_e514.z, _e510.z, (_e510.z > _e514.z)) * _e572)), (_e497.w + _e572));
                        } else {
                            let _e525 = select(0f, _e520, (_e520 > 0f));
                            let _e542 = select(0f, _e519, (_e519 > 0f));
                            phi_638_ = vec4<f32>((_e495.x + (_e514.x * _e542)), (_e495.y + (_e514.y * _e542)), (_e495.z + (_e514.z * _e542)), (_e495.w + _e542));
                            phi_641_ = vec4<f32>((_e497.x + (_e510.x * _e525)), (_e497.y + (_e510.y * _e525)), (_e497.z + (_e510.z * _e525)), (_e497.w + _e525));
                        }
                        let _e586 = phi_638_;
                        let _e588 = phi_641_;
                        let _e589 = (_e499 + 1u);
                        let _e590 = (_e479 + (countOneBits(((_e129 >> bitcast<u32>(2u)) & 16843009u)) + countOneBits(((_e152 >> bitcast<u32>(2u)) & 257u))));
                        local_12 = _e586;
                        local_13 = _e588;
                        local_14 = _e586;
                        local_15 = _e586;
                        local_16 = _e586;
                        local_17 = _e588;
                        local_52 = _e588;
                        local_53 = _e590;
                        continue;
                        continuing {
                            phi_637_ = _e586;
                            phi_640_ = _e588;
                            phi_642_ = _e589;
                            break if !(select(true, false, (_e589 >= _e590)));
                        }
                    }
                    let _e595 = local_12;
                    let _e598 = local_13;
                    if (_e595.w > _e598.w) {
                        let _e601 = (_e595.w - _e598.w);
                        let _e602 = (_e601 / _e595.w);
                        let _e604 = local_14;
                        let _e608 = local_15;
                        let _e612 = local_16;
                        let _e617 = local_17;
                        phi_787_ = (_e617 + vec4<f32>((_e604.x * _e602), (_e608.y * _e602), (_e612.z * _e602), _e601));
                    } else {
                        let _e1813 = local_52;
                        phi_787_ = _e1813;
                    }
                    let _e620 = phi_787_;
                    if (_e620.w > 1f) {
                        phi_801_ = vec4<f32>((_e620.x / _e620.w), (_e620.y / _e620.w), (_e620.z / _e620.w), 1f);
                    } else {
                        phi_801_ = _e620;
                    }
                    let _e631 = phi_801_;
                    phi_804_ = array<vec4<f32>, 8>(_e477[0], _e477[1], _e631, _e477[3], _e477[4], _e477[5], _e477[6], _e477[7]);
                    let _e1818 = local_53;
                    phi_805_ = _e1818;
                } else {
                    phi_804_ = _e477;
                    phi_805_ = _e479;
                }
                let _e642 = phi_804_;
                let _e644 = phi_805_;
                if (((_e73 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    phi_825_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_828_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_830_ = _e644;
                    loop {
                        let _e660 = phi_825_;
                        let _e662 = phi_828_;
                        let _e664 = phi_830_;
                        let _e668 = facets.member[_e664].member_2;
                        let _e672 = (2u * _e664);
                        let _e675 = radiance.member[_e672];
                        let _e679 = radiance.member[(_e672 + 1u)];
                        let _e684 = (((_e159 * _e668[0]) + (_e161 * _e668[1])) + (_e163 * _e668[2]));
                        let _e685 = -(_e684);
                        if (_e55 == 1u) {
                            let _e737 = sqrt((((_e668[0] * _e668[0]) + (_e668[1] * _e668[1])) + (_e668[2] * _e668[2])));
                            phi_826_ = _e660;
                            phi_829_ = vec4<f32>((_e662.x + (select(_e679.x, _e675.x, (_e675.x > _e679.x)) * _e737)), (_e662.y + (select(_e679.y, _e675.y, (_e675.y > _e679.y)) * _e737)), (_e662.z + (select(_e679.z, _e675.z, (_e675.z > _e679.z)) * _e737)), (_e662.w + _e737));
                        } else {
                            let _e690 = select(0f, _e685, (_e685 > 0f));
                            let _e707 = select(0f, _e684, (_e684 > 0f));
                            phi_826_ = vec4<f32>((_e660.x + (_e679.x * _e707)), (_e660.y + (_e679.y * _e707)), (_e660.z + (_e679.z * _e707)), (_e660.w + _e707));
                            phi_829_ = vec4<f32>((_e662.x + (_e675.x * _e690)), (_e662.y + (_e675.y * _e690)), (_e662.z + (_e675.z * _e690)), (_e662.w + _e690));
                        }
                        let _e751 = phi_826_;
                        let _e753 = phi_829_;
                        let _e754 = (_e664 + 1u);
                        let _e755 = (_e644 + (countOneBits(((_e129 >> bitcast<u32>(3u)) & 16843009u)) + countOneBits(((_e152 >> bitcast<u32>(3u)) & 257u))));
                        local_18 = _e751;
                        local_19 = _e753;
                        local_20 = _e751;
                        local_21 = _e751;
                        local_22 = _e751;
                        local_23 = _e753;
                        local_54 = _e753;
                        local_55 = _e755;
                        continue;
                        continuing {
                            phi_825_ = _e751;
                            phi_828_ = _e753;
                            phi_830_ = _e754;
                            break if !(select(true, false, (_e754 >= _e755)));
                        }
                    }
                    let _e760 = local_18;
                    let _e763 = local_19;
                    if (_e760.w > _e763.w) {
                        let _e766 = (_e760.w - _e763.w);
                        let _e767 = (_e766 / _e760.w);
                        let _e769 = local_20;
                        let _e773 = local_21;
                        let _e777 = local_22;
                        let _e782 = local_23;
                        phi_975_ = (_e782 + vec4<f32>((_e769.x * _e767), (_e773.y * _e767), (_e777.z * _e767), _e766));
                    } else {
                        let _e1832 = local_54;
                        phi_975_ = _e1832;
                    }
                    let _e785 = phi_975_;
                    if (_e785.w > 1f) {
                        phi_989_ = vec4<f32>((_e785.x / _e785.w), (_e785.y / _e785.w), (_e785.z / _e785.w), 1f);
                    } else {
                        phi_989_ = _e785;
                    }
                    let _e796 = phi_989_;
                    phi_992_ = array<vec4<f32>, 8>(_e642[0], _e642[1], _e642[2], _e796, _e642[4], _e642[5], _e642[6], _e642[7]);
                    let _e1837 = local_55;
                    phi_993_ = _e1837;
                } else {
                    phi_992_ = _e642;
                    phi_993_ = _e644;
                }
                let _e807 = phi_992_;
                let _e809 = phi_993_;
                if (((_e73 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    phi_1013_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1016_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1018_ = _e809;
                    loop {
                        let _e825 = phi_1013_;
                        let _e827 = phi_1016_;
                        let _e829 = phi_1018_;
                        let _e833 = facets.member[_e829].member_2;
                        let _e837 = (2u * _e829);
                        let _e840 = radiance.member[_e837];
                        let _e844 = radiance.member[(_e837 + 1u)];
                        let _e849 = (((_e159 * _e833[0]) + (_e161 * _e833[1])) + (_e163 * _e833[2]));
                        let _e850 = -(_e849);
                        if (_e55 == 1u) {
                            let _e902 = sqrt((((_e833[0] * _e833[0]) + (_e833[1] * _e833[1])) + (_e833[2] * _e833[2])));
                            phi_1014_ = _e825;
                            phi_1017_ = vec4<f32>((_e827.x + (select(_e844.x, _e840.x, (_e840.x > _e844.x)) * _e902)), (_e827.y + (select(_e844.y, _e840.y, (_e840.y > _e844.y)) * _e902)), (_e827.z + (select(_e844.z, _e840.z, (_e840.z > _e844.z)) * _e902)), (_e827.w + _e902));
                        } else {
                            let _e855 = select(0f, _e850, (_e850 > 0f));
                            let _e872 = select(0f, _e849, (_e849 > 0f));
                            phi_1014_ = vec4<f32>((_e825.x + (_e844.x * _e872)), (_e825.y + (_e844.y * _e872)), (_e825.z + (_e844.z * _e872)), (_e825.w + _e872));
                            phi_1017_ = vec4<f32>((_e827.x + (_e840.x * _e855)), (_e827.y + (_e840.y * _e855)), (_e827.z + (_e840.z * _e855)), (_e827.w + _e855));
                        }
                        let _e916 = phi_1014_;
                        let _e918 = phi_1017_;
                        let _e919 = (_e829 + 1u);
                        let _e920 = (_e809 + (countOneBits(((_e129 >> bitcast<u32>(4u)) & 16843009u)) + countOneBits(((_e152 >> bitcast<u32>(4u)) & 257u))));
                        local_24 = _e916;
                        local_25 = _e918;
                        local_26 = _e916;
                        local_27 = _e916;
                        local_28 = _e916;
                        local_29 = _e918;
                        local_56 = _e918;
                        local_57 = _e920;
                        continue;
                        continuing {
                            phi_1013_ = _e916;
                            phi_1016_ = _e918;
                            phi_1018_ = _e919;
                            break if !(select(true, false, (_e919 >= _e920)));
                        }
                    }
                    let _e925 = local_24;
                    let _e928 = local_25;
                    if (_e925.w > _e928.w) {
                        let _e931 = (_e925.w - _e928.w);
                        let _e932 = (_e931 / _e925.w);
                        let _e934 = local_26;
                        let _e938 = local_27;
                        let _e942 = local_28;
                        let _e947 = local_29;
                        phi_1163_ = (_e947 + vec4<f32>((_e934.x * _e932), (_e938.y * _e932), (_e942.z * _e932), _e931));
                    } else {
                        let _e1851 = local_56;
                        phi_1163_ = _e1851;
                    }
                    let _e950 = phi_1163_;
                    if (_e950.w > 1f) {
                        phi_1177_ = vec4<f32>((_e950.x / _e950.w), (_e950.y / _e950.w), (_e950.z / _e950.w), 1f);
                    } else {
                        phi_1177_ = _e950;
                    }
                    let _e961 = phi_1177_;
                    phi_1180_ = array<vec4<f32>, 8>(_e807[0], _e807[1], _e807[2], _e807[3], _e961, _e807[5], _e807[6], _e807[7]);
                    let _e1856 = local_57;
                    phi_1181_ = _e1856;
                } else {
                    phi_1180_ = _e807;
                    phi_1181_ = _e809;
                }
                let _e972 = phi_1180_;
                let _e974 = phi_1181_;
                if (((_e73 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    phi_1201_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1204_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1206_ = _e974;
                    loop {
                        let _e990 = phi_1201_;
                        let _e992 = phi_1204_;
                        let _e994 = phi_1206_;
                        let _e998 = facets.member[_e994].member_2;
                        let _e1002 = (2u * _e994);
                        let _e1005 = radiance.member[_e1002];
                        let _e1009 = radiance.member[(_e1002 + 1u)];
                        let _e1014 = (((_e159 * _e998[0]) + (_e161 * _e998[1])) + (_e163 * _e998[2]));
                        let _e1015 = -(_e1014);
                        if (_e55 == 1u) {
                            let _e1067 = sqrt((((_e998[0] * _e998[0]) + (_e998[1] * _e998[1])) + (_e998[2] * _e998[2])));
                            phi_1202_ = _e990;
                            phi_1205_ = vec4<f32>((_e992.x + (select(_e1009.x, _e1005.x, (_e1005.x > _e1009.x)) * _e1067)), (_e992.y + (select(_e1009.y, _e1005.y, (_e1005.y > _e1009.y)) * _e1067)), (_e992.z + (select(_e1009.z, _e1005.z, (_e1005.z > _e1009.z)) * _e1067)), (_e992.w + _e1067));
                        } else {
                            let _e1020 = select(0f, _e1015, (_e1015 > 0f));
                            let _e1037 = select(0f, _e1014, (_e1014 > 0f));
                            phi_1202_ = vec4<f32>((_e990.x + (_e1009.x * _e1037)), (_e990.y + (_e1009.y * _e1037)), (_e990.z + (_e1009.z * _e1037)), (_e990.w + _e1037));
                            phi_1205_ = vec4<f32>((_e992.x + (_e1005.x * _e1020)), (_e992.y + (_e1005.y * _e1020)), (_e992.z + (_e1005.z * _e1020)), (_e992.w + _e1020));
                        }
                        let _e1081 = phi_1202_;
                        let _e1083 = phi_1205_;
                        let _e1084 = (_e994 + 1u);
                        let _e1085 = (_e974 + (countOneBits(((_e129 >> bitcast<u32>(5u)) & 16843009u)) + countOneBits(((_e152 >> bitcast<u32>(5u)) & 257u))));
                        local_30 = _e1081;
                        local_31 = _e1083;
                        local_32 = _e1081;
                        local_33 = _e1081;
                        local_34 = _e1081;
                        local_35 = _e1083;
                        local_58 = _e1083;
                        local_59 = _e1085;
                        continue;
                        continuing {
                            phi_1201_ = _e1081;
                            phi_1204_ = _e1083;
                            phi_1206_ = _e1084;
                            break if !(select(true, false, (_e1084 >= _e1085)));
                        }
                    }
                    let _e1090 = local_30;
                    let _e1093 = local_31;
                    if (_e1090.w > _e1093.w) {
                        let _e1096 = (_e1090.w - _e1093.w);
                        let _e1097 = (_e1096 / _e1090.w);
                        let _e1099 = local_32;
                        let _e1103 = local_33;
                        let _e1107 = local_34;
                        let _e1112 = local_35;
                        phi_1351_ = (_e1112 + vec4<f32>((_e1099.x * _e1097), (_e1103.y * _e1097), (_e1107.z * _e1097), _e1096));
                    } else {
                        let _e1870 = local_58;
                        phi_1351_ = _e1870;
                    }
                    let _e1115 = phi_1351_;
                    if (_e1115.w > 1f) {
                        phi_1365_ = vec4<f32>((_e1115.x / _e1115.w), (_e1115.y / _e1115.w), (_e1115.z / _e1115.w), 1f);
                    } else {
                        phi_1365_ = _e1115;
                    }
                    let _e1126 = phi_1365_;
                    phi_1368_ = array<vec4<f32>, 8>(_e972[0], _e972[1], _e972[2], _e972[3], _e972[4], _e1126, _e972[6], _e972[7]);
                    let _e1875 = local_59;
                    phi_1369_ = _e1875;
                } else {
                    phi_1368_ = _e972;
                    phi_1369_ = _e974;
                }
                let _e1137 = phi_1368_;
                let _e1139 = phi_1369_;
                if (((_e73 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    phi_1389_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1392_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1394_ = _e1139;
                    loop {
                        let _e1155 = phi_1389_;
                        let _e1157 = phi_1392_;
                        let _e1159 = phi_1394_;
                        let _e1163 = facets.member[_e1159].member_2;
                        let _e1167 = (2u * _e1159);
                        let _e1170 = radiance.member[_e1167];
                        let _e1174 = radiance.member[(_e1167 + 1u)];
                        let _e1179 = (((_e159 * _e1163[0]) + (_e161 * _e1163[1])) + (_e163 * _e1163[2]));
                        let _e1180 = -(_e1179);
                        if (_e55 == 1u) {
                            let _e1232 = sqrt((((_e1163[0] * _e1163[0]) + (_e1163[1] * _e1163[1])) + (_e1163[2] * _e1163[2])));
                            phi_1390_ = _e1155;
                            phi_1393_ = vec4<f32>((_e1157.x + (select(_e1174.x, _e1170.x, (_e1170.x > _e1174.x)) * _e1232)), (_e1157.y + (select(_e1174.y, _e1170.y, (_e1170.y > _e1174.y)) * _e1232)), (_e1157.z + (select(_e1174.z, _e1170.z, (_e1170.z > _e1174.z)) * _e1232)), (_e1157.w + _e1232));
                        } else {
                            let _e1185 = select(0f, _e1180, (_e1180 > 0f));
                            let _e1202 = select(0f, _e1179, (_e1179 > 0f));
                            phi_1390_ = vec4<f32>((_e1155.x + (_e1174.x * _e1202)), (_e1155.y + (_e1174.y * _e1202)), (_e1155.z + (_e1174.z * _e1202)), (_e1155.w + _e1202));
                            phi_1393_ = vec4<f32>((_e1157.x + (_e1170.x * _e1185)), (_e1157.y + (_e1170.y * _e1185)), (_e1157.z + (_e1170.z * _e1185)), (_e1157.w + _e1185));
                        }
                        let _e1246 = phi_1390_;
                        let _e1248 = phi_1393_;
                        let _e1249 = (_e1159 + 1u);
                        let _e1250 = (_e1139 + (countOneBits(((_e129 >> bitcast<u32>(6u)) & 16843009u)) + countOneBits(((_e152 >> bitcast<u32>(6u)) & 257u))));
                        local_36 = _e1246;
                        local_37 = _e1248;
                        local_38 = _e1246;
                        local_39 = _e1246;
                        local_40 = _e1246;
                        local_41 = _e1248;
                        local_60 = _e1248;
                        local_61 = _e1250;
                        continue;
                        continuing {
                            phi_1389_ = _e1246;
                            phi_1392_ = _e1248;
                            phi_1394_ = _e1249;
                            break if !(select(true, false, (_e1249 >= _e1250)));
                        }
                    }
                    let _e1255 = local_36;
                    let _e1258 = local_37;
                    if (_e1255.w > _e1258.w) {
                        let _e1261 = (_e1255.w - _e1258.w);
                        let _e1262 = (_e1261 / _e1255.w);
                        let _e1264 = local_38;
                        let _e1268 = local_39;
                        let _e1272 = local_40;
                        let _e1277 = local_41;
                        phi_1539_ = (_e1277 + vec4<f32>((_e1264.x * _e1262), (_e1268.y * _e1262), (_e1272.z * _e1262), _e1261));
                    } else {
                        let _e1889 = local_60;
                        phi_1539_ = _e1889;
                    }
                    let _e1280 = phi_1539_;
                    if (_e1280.w > 1f) {
                        phi_1553_ = vec4<f32>((_e1280.x / _e1280.w), (_e1280.y / _e1280.w), (_e1280.z / _e1280.w), 1f);
                    } else {
                        phi_1553_ = _e1280;
                    }
                    let _e1291 = phi_1553_;
                    phi_1556_ = array<vec4<f32>, 8>(_e1137[0], _e1137[1], _e1137[2], _e1137[3], _e1137[4], _e1137[5], _e1291, _e1137[7]);
                    let _e1894 = local_61;
                    phi_1557_ = _e1894;
                } else {
                    phi_1556_ = _e1137;
                    phi_1557_ = _e1139;
                }
                let _e1302 = phi_1556_;
                let _e1304 = phi_1557_;
                if (((_e73 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    phi_1577_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1580_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1582_ = _e1304;
                    loop {
                        let _e1320 = phi_1577_;
                        let _e1322 = phi_1580_;
                        let _e1324 = phi_1582_;
                        let _e1328 = facets.member[_e1324].member_2;
                        let _e1332 = (2u * _e1324);
                        let _e1335 = radiance.member[_e1332];
                        let _e1339 = radiance.member[(_e1332 + 1u)];
                        let _e1344 = (((_e159 * _e1328[0]) + (_e161 * _e1328[1])) + (_e163 * _e1328[2]));
                        let _e1345 = -(_e1344);
                        if (_e55 == 1u) {
                            let _e1397 = sqrt((((_e1328[0] * _e1328[0]) + (_e1328[1] * _e1328[1])) + (_e1328[2] * _e1328[2])));
                            phi_1578_ = _e1320;
                            phi_1581_ = vec4<f32>((_e1322.x + (select(_e1339.x, _e1335.x, (_e1335.x > _e1339.x)) * _e1397)), (_e1322.y + (select(_e1339.y, _e1335.y, (_e1335.y > _e1339.y)) * _e1397)), (_e1322.z + (select(_e1339.z, _e1335.z, (_e1335.z > _e1339.z)) * _e1397)), (_e1322.w + _e1397));
                        } else {
                            let _e1350 = select(0f, _e1345, (_e1345 > 0f));
                            let _e1367 = select(0f, _e1344, (_e1344 > 0f));
                            phi_1578_ = vec4<f32>((_e1320.x + (_e1339.x * _e1367)), (_e1320.y + (_e1339.y * _e1367)), (_e1320.z + (_e1339.z * _e1367)), (_e1320.w + _e1367));
                            phi_1581_ = vec4<f32>((_e1322.x + (_e1335.x * _e1350)), (_e1322.y + (_e1335.y * _e1350)), (_e1322.z + (_e1335.z * _e1350)), (_e1322.w + _e1350));
                        }
                        let _e1411 = phi_1578_;
                        let _e1413 = phi_1581_;
                        let _e1414 = (_e1324 + 1u);
                        local_42 = _e1411;
                        local_43 = _e1413;
                        local_44 = _e1411;
                        local_45 = _e1411;
                        local_46 = _e1411;
                        local_47 = _e1413;
                        local_62 = _e1413;
                        continue;
                        continuing {
                            phi_1577_ = _e1411;
                            phi_1580_ = _e1413;
                            phi_1582_ = _e1414;
                            break if !(select(true, false, (_e1414 >= (_e1304 + (countOneBits(((_e129 >> bitcast<u32>(7u)) & 16843009u)) + countOneBits(((_e152 >> bitcast<u32>(7u)) & 257u)))))));
                        }
                    }
                    let _e1420 = local_42;
                    let _e1423 = local_43;
                    if (_e1420.w > _e1423.w) {
                        let _e1426 = (_e1420.w - _e1423.w);
                        let _e1427 = (_e1426 / _e1420.w);
                        let _e1429 = local_44;
                        let _e1433 = local_45;
                        let _e1437 = local_46;
                        let _e1442 = local_47;
                        phi_1727_ = (_e1442 + vec4<f32>((_e1429.x * _e1427), (_e1433.y * _e1427), (_e1437.z * _e1427), _e1426));
                    } else {
                        let _e1908 = local_62;
                        phi_1727_ = _e1908;
                    }
                    let _e1445 = phi_1727_;
                    if (_e1445.w > 1f) {
                        phi_1741_ = vec4<f32>((_e1445.x / _e1445.w), (_e1445.y / _e1445.w), (_e1445.z / _e1445.w), 1f);
                    } else {
                        phi_1741_ = _e1445;
                    }
                    let _e1456 = phi_1741_;
                    phi_1743_ = array<vec4<f32>, 8>(_e1302[0], _e1302[1], _e1302[2], _e1302[3], _e1302[4], _e1302[5], _e1302[6], _e1456);
                } else {
                    phi_1743_ = _e1302;
                }
                let _e1467 = phi_1743_;
                if (_e55 == 1u) {
                    let _e1741 = ((((_e1467[0].x + _e1467[1].x) + (_e1467[2].x + _e1467[3].x)) + ((_e1467[4].x + _e1467[5].x) + (_e1467[6].x + _e1467[7].x))) * 0.25f);
                    let _e1742 = ((((_e1467[0].y + _e1467[1].y) + (_e1467[2].y + _e1467[3].y)) + ((_e1467[4].y + _e1467[5].y) + (_e1467[6].y + _e1467[7].y))) * 0.25f);
                    let _e1743 = ((((_e1467[0].z + _e1467[1].z) + (_e1467[2].z + _e1467[3].z)) + ((_e1467[4].z + _e1467[5].z) + (_e1467[6].z + _e1467[7].z))) * 0.25f);
                    let _e1744 = ((((_e1467[0].w + _e1467[1].w) + (_e1467[2].w + _e1467[3].w)) + ((_e1467[4].w + _e1467[5].w) + (_e1467[6].w + _e1467[7].w))) * 0.25f);
                    if (_e1744 > 1f) {
                        phi_1832_ = vec4<f32>((_e1741 / _e1744), (_e1742 / _e1744), (_e1743 / _e1744), (_e1744 / _e1744));
                    } else {
                        phi_1832_ = vec4<f32>(_e1741, _e1742, _e1743, _e1744);
                    }
                    let _e1753 = phi_1832_;
                    phi_2157_ = _e1753;
                } else {
                    if _e158 {
                        phi_1849_ = _e1467[1];
                    } else {
                        phi_1849_ = select(_e1467[4], _e1467[2], vec4(_e160));
                    }
                    let _e1476 = phi_1849_;
                    if _e156 {
                        let _e1499 = ((1f - _e1476.w) / select(0.000000000000000000000000000000000000011754944f, _e1467[0].w, (_e1467[0].w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1501 = select(1f, _e1499, (_e1499 < 1f));
                        phi_1901_ = (_e1476 + vec4<f32>((_e1467[0].x * _e1501), (_e1467[0].y * _e1501), (_e1467[0].z * _e1501), (_e1467[0].w * _e1501)));
                    } else {
                        let _e1482 = ((1f - _e1467[0].w) / select(0.000000000000000000000000000000000000011754944f, _e1476.w, (_e1476.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1484 = select(1f, _e1482, (_e1482 < 1f));
                        phi_1901_ = (_e1467[0] + vec4<f32>((_e1476.x * _e1484), (_e1476.y * _e1484), (_e1476.z * _e1484), (_e1476.w * _e1484)));
                    }
                    let _e1512 = phi_1901_;
                    let _e1513 = vec4(_e158);
                    let _e1514 = select(_e1467[1], _e1467[2], _e1513);
                    if _e158 {
                        phi_1927_ = _e1467[3];
                    } else {
                        phi_1927_ = select(_e1467[5], _e1467[3], vec4(_e160));
                    }
                    let _e1520 = phi_1927_;
                    if _e156 {
                        let _e1543 = ((1f - _e1520.w) / select(0.000000000000000000000000000000000000011754944f, _e1514.w, (_e1514.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1545 = select(1f, _e1543, (_e1543 < 1f));
                        phi_1979_ = (_e1520 + vec4<f32>((_e1514.x * _e1545), (_e1514.y * _e1545), (_e1514.z * _e1545), (_e1514.w * _e1545)));
                    } else {
                        let _e1526 = ((1f - _e1514.w) / select(0.000000000000000000000000000000000000011754944f, _e1520.w, (_e1520.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1528 = select(1f, _e1526, (_e1526 < 1f));
                        phi_1979_ = (_e1514 + vec4<f32>((_e1520.x * _e1528), (_e1520.y * _e1528), (_e1520.z * _e1528), (_e1520.w * _e1528)));
                    }
                    let _e1556 = phi_1979_;
                    if _e158 {
                        phi_2004_ = _e1467[4];
                    } else {
                        phi_2004_ = select(_e1467[2], _e1467[4], vec4(_e160));
                    }
                    let _e1572 = phi_2004_;
                    let _e1574 = select(_e1467[6], _e1467[5], _e1513);
                    if _e156 {
                        let _e1597 = ((1f - _e1574.w) / select(0.000000000000000000000000000000000000011754944f, _e1572.w, (_e1572.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1599 = select(1f, _e1597, (_e1597 < 1f));
                        phi_2069_ = (_e1574 + vec4<f32>((_e1572.x * _e1599), (_e1572.y * _e1599), (_e1572.z * _e1599), (_e1572.w * _e1599)));
                    } else {
                        let _e1580 = ((1f - _e1572.w) / select(0.000000000000000000000000000000000000011754944f, _e1574.w, (_e1574.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1582 = select(1f, _e1580, (_e1580 < 1f));
                        phi_2069_ = (_e1572 + vec4<f32>((_e1574.x * _e1582), (_e1574.y * _e1582), (_e1574.z * _e1582), (_e1574.w * _e1582)));
                    }
                    let _e1610 = phi_2069_;
                    if _e158 {
                        phi_2090_ = _e1467[6];
                    } else {
                        phi_2090_ = select(_e1467[3], _e1467[5], vec4(_e160));
                    }
                    let _e1622 = phi_2090_;
                    if _e156 {
                        let _e1646 = ((1f - _e1467[7].w) / select(0.000000000000000000000000000000000000011754944f, _e1622.w, (_e1622.w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1648 = select(1f, _e1646, (_e1646 < 1f));
                        phi_2143_ = (_e1467[7] + vec4<f32>((_e1622.x * _e1648), (_e1622.y * _e1648), (_e1622.z * _e1648), (_e1622.w * _e1648)));
                    } else {
                        let _e1629 = ((1f - _e1622.w) / select(0.000000000000000000000000000000000000011754944f, _e1467[7].w, (_e1467[7].w > 0.000000000000000000000000000000000000011754944f)));
                        let _e1631 = select(1f, _e1629, (_e1629 < 1f));
                        phi_2143_ = (_e1622 + vec4<f32>((_e1467[7].x * _e1631), (_e1467[7].y * _e1631), (_e1467[7].z * _e1631), (_e1467[7].w * _e1631)));
                    }
                    let _e1659 = phi_2143_;
                    phi_2157_ = vec4<f32>(((((_e1512.x + _e1556.x) + _e1610.x) + _e1659.x) * 0.25f), ((((_e1512.y + _e1556.y) + _e1610.y) + _e1659.y) * 0.25f), ((((_e1512.z + _e1556.z) + _e1610.z) + _e1659.z) * 0.25f), ((((_e1512.w + _e1556.w) + _e1610.w) + _e1659.w) * 0.25f));
                }
                let _e1755 = phi_2157_;
                let _e1758 = ((_e44 + _e51) + (_e51 - _e51));
                if (_e1758 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e1758] = _e1755;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_mip_base(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
