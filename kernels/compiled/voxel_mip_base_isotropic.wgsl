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
    var phi_230_: vec4<f32>;
    var phi_233_: u32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: f32;
    var local_6: f32;
    var phi_325_: vec4<f32>;
    var phi_326_: u32;
    var phi_343_: vec4<f32>;
    var phi_346_: u32;
    var local_7: f32;
    var local_8: f32;
    var local_9: f32;
    var local_10: f32;
    var local_11: f32;
    var local_12: f32;
    var local_13: f32;
    var phi_438_: vec4<f32>;
    var phi_439_: u32;
    var phi_456_: vec4<f32>;
    var phi_459_: u32;
    var local_14: f32;
    var local_15: f32;
    var local_16: f32;
    var local_17: f32;
    var local_18: f32;
    var local_19: f32;
    var local_20: f32;
    var phi_551_: vec4<f32>;
    var phi_552_: u32;
    var phi_569_: vec4<f32>;
    var phi_572_: u32;
    var local_21: f32;
    var local_22: f32;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var local_26: f32;
    var local_27: f32;
    var phi_664_: vec4<f32>;
    var phi_665_: u32;
    var phi_682_: vec4<f32>;
    var phi_685_: u32;
    var local_28: f32;
    var local_29: f32;
    var local_30: f32;
    var local_31: f32;
    var local_32: f32;
    var local_33: f32;
    var local_34: f32;
    var phi_777_: vec4<f32>;
    var phi_778_: u32;
    var phi_795_: vec4<f32>;
    var phi_798_: u32;
    var local_35: f32;
    var local_36: f32;
    var local_37: f32;
    var local_38: f32;
    var local_39: f32;
    var local_40: f32;
    var local_41: f32;
    var phi_890_: vec4<f32>;
    var phi_891_: u32;
    var phi_908_: vec4<f32>;
    var phi_911_: u32;
    var local_42: f32;
    var local_43: f32;
    var local_44: f32;
    var local_45: f32;
    var local_46: f32;
    var local_47: f32;
    var local_48: f32;
    var phi_1003_: vec4<f32>;
    var phi_1004_: u32;
    var phi_1021_: vec4<f32>;
    var phi_1024_: u32;
    var local_49: f32;
    var local_50: f32;
    var local_51: f32;
    var local_52: f32;
    var local_53: f32;
    var local_54: f32;
    var local_55: f32;
    var phi_1115_: vec4<f32>;
    var local_56: u32;
    var local_57: u32;
    var local_58: u32;
    var local_59: u32;
    var local_60: u32;
    var local_61: u32;
    var local_62: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e35 = gid_1;
            let _e40 = params.member.member_12;
            let _e43 = params.member.member_13;
            let _e47 = (_e35.x + (_e35.y * 2097152u));
            if (_e47 < _e43) {
                let _e51 = children.member[_e47];
                let _e53 = (_e51 >> bitcast<u32>(2i));
                let _e56 = (_e53 * 6u);
                let _e57 = (2u * _e53);
                let _e61 = cells.member[(_e57 + 1u)];
                let _e64 = facet_bits.member[_e56];
                let _e65 = ((8u * (_e51 & 3u)) & 31u);
                let _e68 = ((1u << bitcast<u32>(_e65)) - 1u);
                let _e78 = facet_bits.member[(_e56 + 1u)];
                let _e91 = facet_bits.member[(_e56 + 2u)];
                let _e104 = facet_bits.member[(_e56 + 3u)];
                let _e113 = (((((_e64 >> bitcast<u32>(_e65)) & 255u) | (((_e78 >> bitcast<u32>(_e65)) & 255u) << bitcast<u32>(8u))) | (((_e91 >> bitcast<u32>(_e65)) & 255u) << bitcast<u32>(16u))) | (((_e104 >> bitcast<u32>(_e65)) & 255u) << bitcast<u32>(24u)));
                let _e117 = facet_bits.member[(_e56 + 4u)];
                let _e127 = facet_bits.member[(_e56 + 5u)];
                let _e130 = ((((((_e61 + countOneBits((_e64 & _e68))) + countOneBits((_e78 & _e68))) + countOneBits((_e91 & _e68))) + countOneBits((_e104 & _e68))) + countOneBits((_e117 & _e68))) + countOneBits((_e127 & _e68)));
                let _e136 = (((_e117 >> bitcast<u32>(_e65)) & 255u) | (((_e127 >> bitcast<u32>(_e65)) & 255u) << bitcast<u32>(8u)));
                let _e139 = cells.member[_e57];
                let _e141 = (_e139 >> bitcast<u32>(_e65));
                if ((_e141 & 1u) == 1u) {
                    phi_230_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_233_ = _e130;
                    loop {
                        let _e150 = phi_230_;
                        let _e152 = phi_233_;
                        let _e156 = facets.member[_e152].member_2;
                        let _e160 = (2u * _e152);
                        let _e163 = radiance.member[_e160];
                        let _e167 = radiance.member[(_e160 + 1u)];
                        let _e185 = sqrt((((_e156[0] * _e156[0]) + (_e156[1] * _e156[1])) + (_e156[2] * _e156[2])));
                        let _e190 = (_e150.x + (select(_e167.x, _e163.x, (_e163.x > _e167.x)) * _e185));
                        let _e192 = (_e150.y + (select(_e167.y, _e163.y, (_e163.y > _e167.y)) * _e185));
                        let _e194 = (_e150.z + (select(_e167.z, _e163.z, (_e163.z > _e167.z)) * _e185));
                        let _e196 = (_e150.w + _e185);
                        let _e198 = (_e152 + 1u);
                        let _e199 = (_e130 + (countOneBits((_e113 & 16843009u)) + countOneBits((_e136 & 257u))));
                        phi_230_ = vec4<f32>(_e190, _e192, _e194, _e196);
                        phi_233_ = _e198;
                        local = _e196;
                        local_1 = _e196;
                        local_2 = _e190;
                        local_3 = _e192;
                        local_4 = _e194;
                        local_5 = _e196;
                        local_6 = _e196;
                        local_56 = _e199;
                        if select(true, false, (_e198 >= _e199)) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e203 = local;
                    let _e206 = local_1;
                    let _e208 = (1f / select(1f, _e206, (_e203 > 1f)));
                    let _e210 = local_2;
                    let _e213 = local_3;
                    let _e216 = local_4;
                    let _e219 = local_5;
                    let _e222 = local_6;
                    phi_325_ = vec4<f32>((_e210 * _e208), (_e213 * _e208), (_e216 * _e208), select(1f, _e222, (_e219 < 1f)));
                    let _e969 = local_56;
                    phi_326_ = _e969;
                } else {
                    phi_325_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_326_ = _e130;
                }
                let _e226 = phi_325_;
                let _e228 = phi_326_;
                if (((_e141 >> bitcast<u32>(1u)) & 1u) == 1u) {
                    phi_343_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_346_ = _e228;
                    loop {
                        let _e243 = phi_343_;
                        let _e245 = phi_346_;
                        let _e249 = facets.member[_e245].member_2;
                        let _e253 = (2u * _e245);
                        let _e256 = radiance.member[_e253];
                        let _e260 = radiance.member[(_e253 + 1u)];
                        let _e278 = sqrt((((_e249[0] * _e249[0]) + (_e249[1] * _e249[1])) + (_e249[2] * _e249[2])));
                        let _e283 = (_e243.x + (select(_e260.x, _e256.x, (_e256.x > _e260.x)) * _e278));
                        let _e285 = (_e243.y + (select(_e260.y, _e256.y, (_e256.y > _e260.y)) * _e278));
                        let _e287 = (_e243.z + (select(_e260.z, _e256.z, (_e256.z > _e260.z)) * _e278));
                        let _e289 = (_e243.w + _e278);
                        let _e291 = (_e245 + 1u);
                        let _e292 = (_e228 + (countOneBits(((_e113 >> bitcast<u32>(1u)) & 16843009u)) + countOneBits(((_e136 >> bitcast<u32>(1u)) & 257u))));
                        phi_343_ = vec4<f32>(_e283, _e285, _e287, _e289);
                        phi_346_ = _e291;
                        local_7 = _e289;
                        local_8 = _e289;
                        local_9 = _e283;
                        local_10 = _e285;
                        local_11 = _e287;
                        local_12 = _e289;
                        local_13 = _e289;
                        local_57 = _e292;
                        if select(true, false, (_e291 >= _e292)) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e296 = local_7;
                    let _e299 = local_8;
                    let _e301 = (1f / select(1f, _e299, (_e296 > 1f)));
                    let _e303 = local_9;
                    let _e306 = local_10;
                    let _e309 = local_11;
                    let _e312 = local_12;
                    let _e315 = local_13;
                    phi_438_ = vec4<f32>((_e226.x + (_e303 * _e301)), (_e226.y + (_e306 * _e301)), (_e226.z + (_e309 * _e301)), (_e226.w + select(1f, _e315, (_e312 < 1f))));
                    let _e982 = local_57;
                    phi_439_ = _e982;
                } else {
                    phi_438_ = _e226;
                    phi_439_ = _e228;
                }
                let _e327 = phi_438_;
                let _e329 = phi_439_;
                if (((_e141 >> bitcast<u32>(2u)) & 1u) == 1u) {
                    phi_456_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_459_ = _e329;
                    loop {
                        let _e344 = phi_456_;
                        let _e346 = phi_459_;
                        let _e350 = facets.member[_e346].member_2;
                        let _e354 = (2u * _e346);
                        let _e357 = radiance.member[_e354];
                        let _e361 = radiance.member[(_e354 + 1u)];
                        let _e379 = sqrt((((_e350[0] * _e350[0]) + (_e350[1] * _e350[1])) + (_e350[2] * _e350[2])));
                        let _e384 = (_e344.x + (select(_e361.x, _e357.x, (_e357.x > _e361.x)) * _e379));
                        let _e386 = (_e344.y + (select(_e361.y, _e357.y, (_e357.y > _e361.y)) * _e379));
                        let _e388 = (_e344.z + (select(_e361.z, _e357.z, (_e357.z > _e361.z)) * _e379));
                        let _e390 = (_e344.w + _e379);
                        let _e392 = (_e346 + 1u);
                        let _e393 = (_e329 + (countOneBits(((_e113 >> bitcast<u32>(2u)) & 16843009u)) + countOneBits(((_e136 >> bitcast<u32>(2u)) & 257u))));
                        phi_456_ = vec4<f32>(_e384, _e386, _e388, _e390);
                        phi_459_ = _e392;
                        local_14 = _e390;
                        local_15 = _e390;
                        local_16 = _e384;
                        local_17 = _e386;
                        local_18 = _e388;
                        local_19 = _e390;
                        local_20 = _e390;
                        local_58 = _e393;
                        if select(true, false, (_e392 >= _e393)) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e397 = local_14;
                    let _e400 = local_15;
                    let _e402 = (1f / select(1f, _e400, (_e397 > 1f)));
                    let _e404 = local_16;
                    let _e407 = local_17;
                    let _e410 = local_18;
                    let _e413 = local_19;
                    let _e416 = local_20;
                    phi_551_ = vec4<f32>((_e327.x + (_e404 * _e402)), (_e327.y + (_e407 * _e402)), (_e327.z + (_e410 * _e402)), (_e327.w + select(1f, _e416, (_e413 < 1f))));
                    let _e995 = local_58;
                    phi_552_ = _e995;
                } else {
                    phi_551_ = _e327;
                    phi_552_ = _e329;
                }
                let _e428 = phi_551_;
                let _e430 = phi_552_;
                if (((_e141 >> bitcast<u32>(3u)) & 1u) == 1u) {
                    phi_569_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_572_ = _e430;
                    loop {
                        let _e445 = phi_569_;
                        let _e447 = phi_572_;
                        let _e451 = facets.member[_e447].member_2;
                        let _e455 = (2u * _e447);
                        let _e458 = radiance.member[_e455];
                        let _e462 = radiance.member[(_e455 + 1u)];
                        let _e480 = sqrt((((_e451[0] * _e451[0]) + (_e451[1] * _e451[1])) + (_e451[2] * _e451[2])));
                        let _e485 = (_e445.x + (select(_e462.x, _e458.x, (_e458.x > _e462.x)) * _e480));
                        let _e487 = (_e445.y + (select(_e462.y, _e458.y, (_e458.y > _e462.y)) * _e480));
                        let _e489 = (_e445.z + (select(_e462.z, _e458.z, (_e458.z > _e462.z)) * _e480));
                        let _e491 = (_e445.w + _e480);
                        let _e493 = (_e447 + 1u);
                        let _e494 = (_e430 + (countOneBits(((_e113 >> bitcast<u32>(3u)) & 16843009u)) + countOneBits(((_e136 >> bitcast<u32>(3u)) & 257u))));
                        phi_569_ = vec4<f32>(_e485, _e487, _e489, _e491);
                        phi_572_ = _e493;
                        local_21 = _e491;
                        local_22 = _e491;
                        local_23 = _e485;
                        local_24 = _e487;
                        local_25 = _e489;
                        local_26 = _e491;
                        local_27 = _e491;
                        local_59 = _e494;
                        if select(true, false, (_e493 >= _e494)) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e498 = local_21;
                    let _e501 = local_22;
                    let _e503 = (1f / select(1f, _e501, (_e498 > 1f)));
                    let _e505 = local_23;
                    let _e508 = local_24;
                    let _e511 = local_25;
                    let _e514 = local_26;
                    let _e517 = local_27;
                    phi_664_ = vec4<f32>((_e428.x + (_e505 * _e503)), (_e428.y + (_e508 * _e503)), (_e428.z + (_e511 * _e503)), (_e428.w + select(1f, _e517, (_e514 < 1f))));
                    let _e1008 = local_59;
                    phi_665_ = _e1008;
                } else {
                    phi_664_ = _e428;
                    phi_665_ = _e430;
                }
                let _e529 = phi_664_;
                let _e531 = phi_665_;
                if (((_e141 >> bitcast<u32>(4u)) & 1u) == 1u) {
                    phi_682_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_685_ = _e531;
                    loop {
                        let _e546 = phi_682_;
                        let _e548 = phi_685_;
                        let _e552 = facets.member[_e548].member_2;
                        let _e556 = (2u * _e548);
                        let _e559 = radiance.member[_e556];
                        let _e563 = radiance.member[(_e556 + 1u)];
                        let _e581 = sqrt((((_e552[0] * _e552[0]) + (_e552[1] * _e552[1])) + (_e552[2] * _e552[2])));
                        let _e586 = (_e546.x + (select(_e563.x, _e559.x, (_e559.x > _e563.x)) * _e581));
                        let _e588 = (_e546.y + (select(_e563.y, _e559.y, (_e559.y > _e563.y)) * _e581));
                        let _e590 = (_e546.z + (select(_e563.z, _e559.z, (_e559.z > _e563.z)) * _e581));
                        let _e592 = (_e546.w + _e581);
                        let _e594 = (_e548 + 1u);
                        let _e595 = (_e531 + (countOneBits(((_e113 >> bitcast<u32>(4u)) & 16843009u)) + countOneBits(((_e136 >> bitcast<u32>(4u)) & 257u))));
                        phi_682_ = vec4<f32>(_e586, _e588, _e590, _e592);
                        phi_685_ = _e594;
                        local_28 = _e592;
                        local_29 = _e592;
                        local_30 = _e586;
                        local_31 = _e588;
                        local_32 = _e590;
                        local_33 = _e592;
                        local_34 = _e592;
                        local_60 = _e595;
                        if select(true, false, (_e594 >= _e595)) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e599 = local_28;
                    let _e602 = local_29;
                    let _e604 = (1f / select(1f, _e602, (_e599 > 1f)));
                    let _e606 = local_30;
                    let _e609 = local_31;
                    let _e612 = local_32;
                    let _e615 = local_33;
                    let _e618 = local_34;
                    phi_777_ = vec4<f32>((_e529.x + (_e606 * _e604)), (_e529.y + (_e609 * _e604)), (_e529.z + (_e612 * _e604)), (_e529.w + select(1f, _e618, (_e615 < 1f))));
                    let _e1021 = local_60;
                    phi_778_ = _e1021;
                } else {
                    phi_777_ = _e529;
                    phi_778_ = _e531;
                }
                let _e630 = phi_777_;
                let _e632 = phi_778_;
                if (((_e141 >> bitcast<u32>(5u)) & 1u) == 1u) {
                    phi_795_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_798_ = _e632;
                    loop {
                        let _e647 = phi_795_;
                        let _e649 = phi_798_;
                        let _e653 = facets.member[_e649].member_2;
                        let _e657 = (2u * _e649);
                        let _e660 = radiance.member[_e657];
                        let _e664 = radiance.member[(_e657 + 1u)];
                        let _e682 = sqrt((((_e653[0] * _e653[0]) + (_e653[1] * _e653[1])) + (_e653[2] * _e653[2])));
                        let _e687 = (_e647.x + (select(_e664.x, _e660.x, (_e660.x > _e664.x)) * _e682));
                        let _e689 = (_e647.y + (select(_e664.y, _e660.y, (_e660.y > _e664.y)) * _e682));
                        let _e691 = (_e647.z + (select(_e664.z, _e660.z, (_e660.z > _e664.z)) * _e682));
                        let _e693 = (_e647.w + _e682);
                        let _e695 = (_e649 + 1u);
                        let _e696 = (_e632 + (countOneBits(((_e113 >> bitcast<u32>(5u)) & 16843009u)) + countOneBits(((_e136 >> bitcast<u32>(5u)) & 257u))));
                        phi_795_ = vec4<f32>(_e687, _e689, _e691, _e693);
                        phi_798_ = _e695;
                        local_35 = _e693;
                        local_36 = _e693;
                        local_37 = _e687;
                        local_38 = _e689;
                        local_39 = _e691;
                        local_40 = _e693;
                        local_41 = _e693;
                        local_61 = _e696;
                        if select(true, false, (_e695 >= _e696)) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e700 = local_35;
                    let _e703 = local_36;
                    let _e705 = (1f / select(1f, _e703, (_e700 > 1f)));
                    let _e707 = local_37;
                    let _e710 = local_38;
                    let _e713 = local_39;
                    let _e716 = local_40;
                    let _e719 = local_41;
                    phi_890_ = vec4<f32>((_e630.x + (_e707 * _e705)), (_e630.y + (_e710 * _e705)), (_e630.z + (_e713 * _e705)), (_e630.w + select(1f, _e719, (_e716 < 1f))));
                    let _e1034 = local_61;
                    phi_891_ = _e1034;
                } else {
                    phi_890_ = _e630;
                    phi_891_ = _e632;
                }
                let _e731 = phi_890_;
                let _e733 = phi_891_;
                if (((_e141 >> bitcast<u32>(6u)) & 1u) == 1u) {
                    phi_908_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_911_ = _e733;
                    loop {
                        let _e748 = phi_908_;
                        let _e750 = phi_911_;
                        let _e754 = facets.member[_e750].member_2;
                        let _e758 = (2u * _e750);
                        let _e761 = radiance.member[_e758];
                        let _e765 = radiance.member[(_e758 + 1u)];
                        let _e783 = sqrt((((_e754[0] * _e754[0]) + (_e754[1] * _e754[1])) + (_e754[2] * _e754[2])));
                        let _e788 = (_e748.x + (select(_e765.x, _e761.x, (_e761.x > _e765.x)) * _e783));
                        let _e790 = (_e748.y + (select(_e765.y, _e761.y, (_e761.y > _e765.y)) * _e783));
                        let _e792 = (_e748.z + (select(_e765.z, _e761.z, (_e761.z > _e765.z)) * _e783));
                        let _e794 = (_e748.w + _e783);
                        let _e796 = (_e750 + 1u);
                        let _e797 = (_e733 + (countOneBits(((_e113 >> bitcast<u32>(6u)) & 16843009u)) + countOneBits(((_e136 >> bitcast<u32>(6u)) & 257u))));
                        phi_908_ = vec4<f32>(_e788, _e790, _e792, _e794);
                        phi_911_ = _e796;
                        local_42 = _e794;
                        local_43 = _e794;
                        local_44 = _e788;
                        local_45 = _e790;
                        local_46 = _e792;
                        local_47 = _e794;
                        local_48 = _e794;
                        local_62 = _e797;
                        if select(true, false, (_e796 >= _e797)) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e801 = local_42;
                    let _e804 = local_43;
                    let _e806 = (1f / select(1f, _e804, (_e801 > 1f)));
                    let _e808 = local_44;
                    let _e811 = local_45;
                    let _e814 = local_46;
                    let _e817 = local_47;
                    let _e820 = local_48;
                    phi_1003_ = vec4<f32>((_e731.x + (_e808 * _e806)), (_e731.y + (_e811 * _e806)), (_e731.z + (_e814 * _e806)), (_e731.w + select(1f, _e820, (_e817 < 1f))));
                    let _e1047 = local_62;
                    phi_1004_ = _e1047;
                } else {
                    phi_1003_ = _e731;
                    phi_1004_ = _e733;
                }
                let _e832 = phi_1003_;
                let _e834 = phi_1004_;
                if (((_e141 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    phi_1021_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_1024_ = _e834;
                    loop {
                        let _e849 = phi_1021_;
                        let _e851 = phi_1024_;
                        let _e855 = facets.member[_e851].member_2;
                        let _e859 = (2u * _e851);
                        let _e862 = radiance.member[_e859];
                        let _e866 = radiance.member[(_e859 + 1u)];
                        let _e884 = sqrt((((_e855[0] * _e855[0]) + (_e855[1] * _e855[1])) + (_e855[2] * _e855[2])));
                        let _e889 = (_e849.x + (select(_e866.x, _e862.x, (_e862.x > _e866.x)) * _e884));
                        let _e891 = (_e849.y + (select(_e866.y, _e862.y, (_e862.y > _e866.y)) * _e884));
                        let _e893 = (_e849.z + (select(_e866.z, _e862.z, (_e862.z > _e866.z)) * _e884));
                        let _e895 = (_e849.w + _e884);
                        let _e897 = (_e851 + 1u);
                        phi_1021_ = vec4<f32>(_e889, _e891, _e893, _e895);
                        phi_1024_ = _e897;
                        local_49 = _e895;
                        local_50 = _e895;
                        local_51 = _e889;
                        local_52 = _e891;
                        local_53 = _e893;
                        local_54 = _e895;
                        local_55 = _e895;
                        if select(true, false, (_e897 >= (_e834 + (countOneBits(((_e113 >> bitcast<u32>(7u)) & 16843009u)) + countOneBits(((_e136 >> bitcast<u32>(7u)) & 257u)))))) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e902 = local_49;
                    let _e905 = local_50;
                    let _e907 = (1f / select(1f, _e905, (_e902 > 1f)));
                    let _e909 = local_51;
                    let _e912 = local_52;
                    let _e915 = local_53;
                    let _e918 = local_54;
                    let _e921 = local_55;
                    phi_1115_ = vec4<f32>((_e832.x + (_e909 * _e907)), (_e832.y + (_e912 * _e907)), (_e832.z + (_e915 * _e907)), (_e832.w + select(1f, _e921, (_e918 < 1f))));
                } else {
                    phi_1115_ = _e832;
                }
                let _e933 = phi_1115_;
                let _e941 = (_e933.w * 0.25f);
                let _e944 = (1f / select(1f, _e941, (_e941 > 1f)));
                let _e953 = ((_e40 + _e47) + (_e47 - _e47));
                if (_e953 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e953] = vec4<f32>(((_e933.x * 0.25f) * _e944), ((_e933.y * 0.25f) * _e944), ((_e933.z * 0.25f) * _e944), select(1f, _e941, (_e941 < 1f)));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_mip_base_isotropic(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
