struct type_5 {
    member: array<f32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_18 {
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

struct type_25 {
    member: array<vec4<f32>>,
}

struct type_30 {
    member: array<vec4<f32>, 4>,
    member_1: array<vec4<i32>, 4>,
    member_2: array<vec4<u32>, 4>,
    member_3: u32,
    member_4: u32,
    member_5: f32,
    member_6: f32,
    member_7: f32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
}

struct type_31 {
    member: type_30,
}

struct type_34 {
    member: array<type_18>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_31;
@group(0) @binding(1) 
var<storage> a: type_5;
@group(0) @binding(2) 
var<storage> b: type_5;
@group(0) @binding(3) 
var<storage> c: type_5;
@group(0) @binding(4) 
var<storage> d: type_5;
@group(0) @binding(5) 
var<storage> surfels: type_34;
@group(0) @binding(6) 
var<storage, read_write> irradiance: type_25;

fn function_() {
    var phi_193_: f32;
    var phi_474_: type_11;
    var phi_477_: f32;
    var phi_479_: array<array<f32, 6>, 3>;
    var phi_475_: type_11;
    var phi_502_: type_11;
    var phi_532_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_875_: f32;
    var phi_876_: array<array<f32, 6>, 3>;
    var phi_478_: f32;
    var phi_480_: array<array<f32, 6>, 3>;
    var phi_12322_: bool;
    var local: f32;
    var local_1: f32;
    var phi_882_: f32;
    var local_2: array<array<f32, 6>, 3>;
    var local_3: array<array<f32, 6>, 3>;
    var local_4: array<array<f32, 6>, 3>;
    var local_5: array<array<f32, 6>, 3>;
    var local_6: array<array<f32, 6>, 3>;
    var local_7: array<array<f32, 6>, 3>;
    var local_8: array<array<f32, 6>, 3>;
    var local_9: array<array<f32, 6>, 3>;
    var local_10: array<array<f32, 6>, 3>;
    var local_11: array<array<f32, 6>, 3>;
    var local_12: array<array<f32, 6>, 3>;
    var local_13: array<array<f32, 6>, 3>;
    var local_14: array<array<f32, 6>, 3>;
    var local_15: array<array<f32, 6>, 3>;
    var local_16: array<array<f32, 6>, 3>;
    var local_17: array<array<f32, 6>, 3>;
    var local_18: array<array<f32, 6>, 3>;
    var local_19: array<array<f32, 6>, 3>;
    var phi_12387_: bool;
    var phi_3170_: vec4<f32>;
    var phi_12385_: bool;
    var phi_3172_: vec4<f32>;
    var phi_3230_: f32;
    var phi_3511_: type_11;
    var phi_3514_: f32;
    var phi_3516_: array<array<f32, 6>, 3>;
    var phi_3512_: type_11;
    var phi_3539_: type_11;
    var phi_3569_: f32;
    var phi_3574_: f32;
    var phi_3580_: f32;
    var phi_3912_: f32;
    var phi_3913_: array<array<f32, 6>, 3>;
    var phi_3515_: f32;
    var phi_3517_: array<array<f32, 6>, 3>;
    var phi_12359_: bool;
    var local_20: f32;
    var local_21: f32;
    var phi_3919_: f32;
    var local_22: array<array<f32, 6>, 3>;
    var local_23: array<array<f32, 6>, 3>;
    var local_24: array<array<f32, 6>, 3>;
    var local_25: array<array<f32, 6>, 3>;
    var local_26: array<array<f32, 6>, 3>;
    var local_27: array<array<f32, 6>, 3>;
    var local_28: array<array<f32, 6>, 3>;
    var local_29: array<array<f32, 6>, 3>;
    var local_30: array<array<f32, 6>, 3>;
    var local_31: array<array<f32, 6>, 3>;
    var local_32: array<array<f32, 6>, 3>;
    var local_33: array<array<f32, 6>, 3>;
    var local_34: array<array<f32, 6>, 3>;
    var local_35: array<array<f32, 6>, 3>;
    var local_36: array<array<f32, 6>, 3>;
    var local_37: array<array<f32, 6>, 3>;
    var local_38: array<array<f32, 6>, 3>;
    var local_39: array<array<f32, 6>, 3>;
    var phi_12654_: bool;
    var phi_6207_: vec4<f32>;
    var phi_12653_: bool;
    var phi_6208_: vec4<f32>;
    var phi_12652_: bool;
    var phi_6209_: vec4<f32>;
    var phi_6210_: bool;
    var phi_6267_: f32;
    var phi_6548_: type_11;
    var phi_6551_: f32;
    var phi_6553_: array<array<f32, 6>, 3>;
    var phi_6549_: type_11;
    var phi_6576_: type_11;
    var phi_6606_: f32;
    var phi_6611_: f32;
    var phi_6617_: f32;
    var phi_6949_: f32;
    var phi_6950_: array<array<f32, 6>, 3>;
    var phi_6552_: f32;
    var phi_6554_: array<array<f32, 6>, 3>;
    var phi_12626_: bool;
    var local_40: f32;
    var local_41: f32;
    var phi_6956_: f32;
    var local_42: array<array<f32, 6>, 3>;
    var local_43: array<array<f32, 6>, 3>;
    var local_44: array<array<f32, 6>, 3>;
    var local_45: array<array<f32, 6>, 3>;
    var local_46: array<array<f32, 6>, 3>;
    var local_47: array<array<f32, 6>, 3>;
    var local_48: array<array<f32, 6>, 3>;
    var local_49: array<array<f32, 6>, 3>;
    var local_50: array<array<f32, 6>, 3>;
    var local_51: array<array<f32, 6>, 3>;
    var local_52: array<array<f32, 6>, 3>;
    var local_53: array<array<f32, 6>, 3>;
    var local_54: array<array<f32, 6>, 3>;
    var local_55: array<array<f32, 6>, 3>;
    var local_56: array<array<f32, 6>, 3>;
    var local_57: array<array<f32, 6>, 3>;
    var local_58: array<array<f32, 6>, 3>;
    var local_59: array<array<f32, 6>, 3>;
    var phi_12921_: bool;
    var phi_9244_: vec4<f32>;
    var phi_12920_: bool;
    var phi_9245_: vec4<f32>;
    var phi_12919_: bool;
    var phi_9246_: vec4<f32>;
    var phi_9247_: bool;
    var phi_9304_: f32;
    var phi_9585_: type_11;
    var phi_9588_: f32;
    var phi_9590_: array<array<f32, 6>, 3>;
    var phi_9586_: type_11;
    var phi_9613_: type_11;
    var phi_9643_: f32;
    var phi_9648_: f32;
    var phi_9654_: f32;
    var phi_9986_: f32;
    var phi_9987_: array<array<f32, 6>, 3>;
    var phi_9589_: f32;
    var phi_9591_: array<array<f32, 6>, 3>;
    var phi_12893_: bool;
    var local_60: f32;
    var local_61: f32;
    var phi_9993_: f32;
    var local_62: array<array<f32, 6>, 3>;
    var local_63: array<array<f32, 6>, 3>;
    var local_64: array<array<f32, 6>, 3>;
    var local_65: array<array<f32, 6>, 3>;
    var local_66: array<array<f32, 6>, 3>;
    var local_67: array<array<f32, 6>, 3>;
    var local_68: array<array<f32, 6>, 3>;
    var local_69: array<array<f32, 6>, 3>;
    var local_70: array<array<f32, 6>, 3>;
    var local_71: array<array<f32, 6>, 3>;
    var local_72: array<array<f32, 6>, 3>;
    var local_73: array<array<f32, 6>, 3>;
    var local_74: array<array<f32, 6>, 3>;
    var local_75: array<array<f32, 6>, 3>;
    var local_76: array<array<f32, 6>, 3>;
    var local_77: array<array<f32, 6>, 3>;
    var local_78: array<array<f32, 6>, 3>;
    var local_79: array<array<f32, 6>, 3>;
    var phi_12281_: vec4<f32>;
    var phi_12282_: vec4<f32>;
    var phi_12283_: vec4<f32>;
    var phi_12284_: bool;
    var phi_12293_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e53 = gid_1;
            let _e55 = arrayLength((&a.member));
            let _e57 = arrayLength((&b.member));
            let _e59 = arrayLength((&c.member));
            let _e61 = arrayLength((&d.member));
            let _e69 = (_e53.x + (_e53.y * 2097152u));
            let _e70 = (_e69 < arrayLength((&irradiance.member)));
            if _e70 {
                if (_e69 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e74 = surfels.member[_e69];
                if (_e74.member_1 == 4294967295u) {
                    phi_12293_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e79 = params.member.member_3;
                    let _e80 = (0u >= _e79);
                    if _e80 {
                        phi_12385_ = false;
                        phi_3172_ = vec4<f32>();
                    } else {
                        let _e84 = params.member.member[0u];
                        let _e88 = params.member.member_1[0u];
                        let _e92 = params.member.member_2[0u];
                        if (1u == _e79) {
                            phi_193_ = 0f;
                        } else {
                            let _e104 = params.member.member_5;
                            phi_193_ = _e104;
                        }
                        let _e106 = phi_193_;
                        let _e114 = ((_e74.member[0] - _e84.x) / _e84.w);
                        let _e115 = ((_e74.member[1] - _e84.y) / _e84.w);
                        let _e116 = ((_e74.member[2] - _e84.z) / _e84.w);
                        let _e123 = (_e114 - f32(_e88.x));
                        let _e124 = (_e115 - f32(_e88.y));
                        let _e125 = (_e116 - f32(_e88.z));
                        let _e133 = select(_e125, _e124, (_e124 < _e125));
                        let _e135 = select(_e133, _e123, (_e123 < _e133));
                        let _e136 = (f32(_e92.x) - _e123);
                        let _e137 = (f32(_e92.y) - _e124);
                        let _e138 = (f32(_e92.z) - _e125);
                        let _e140 = select(_e138, _e137, (_e137 < _e138));
                        let _e142 = select(_e140, _e136, (_e136 < _e140));
                        let _e147 = (select(_e142, _e135, (_e135 < _e142)) / select(0.001f, _e106, (_e106 > 0.001f)));
                        let _e149 = select(0f, _e147, (_e147 > 0f));
                        let _e151 = select(1f, _e149, (_e149 < 1f));
                        if (_e151 <= 0f) {
                            phi_12387_ = false;
                            phi_3170_ = vec4<f32>(0f, 0f, 0f, 1f);
                        } else {
                            let _e155 = params.member.member_6;
                            let _e156 = (_e92.x + 1u);
                            let _e158 = ((_e92.y + 1u) * _e156);
                            let _e159 = (_e158 + _e156);
                            let _e162 = (_e159 + ((_e92.z + 1u) * _e158));
                            let _e169 = ((_e114 + (_e74.member_2[0] * _e155)) - 0.5f);
                            let _e170 = floor(_e169);
                            let _e172 = (bitcast<i32>(_e92.x) - 1i);
                            let _e180 = (select(0i, select(select(i32(_e170), i32(-2147483648), (_e170 < -2147483600f)), 2147483647i, (_e170 > 2147483500f)), (_e170 == _e170)) - _e88.x);
                            let _e182 = select(0i, _e180, (0i < _e180));
                            let _e184 = select(_e182, _e172, (_e172 < _e182));
                            let _e185 = (_e180 + 1i);
                            let _e187 = select(0i, _e185, (0i < _e185));
                            let _e189 = select(_e187, _e172, (_e172 < _e187));
                            let _e192 = (_e169 - _e170);
                            let _e199 = ((_e115 + (_e74.member_2[1] * _e155)) - 0.5f);
                            let _e200 = floor(_e199);
                            let _e202 = (bitcast<i32>(_e92.y) - 1i);
                            let _e210 = (select(0i, select(select(i32(_e200), i32(-2147483648), (_e200 < -2147483600f)), 2147483647i, (_e200 > 2147483500f)), (_e200 == _e200)) - _e88.y);
                            let _e212 = select(0i, _e210, (0i < _e210));
                            let _e214 = select(_e212, _e202, (_e202 < _e212));
                            let _e215 = (_e210 + 1i);
                            let _e217 = select(0i, _e215, (0i < _e215));
                            let _e219 = select(_e217, _e202, (_e202 < _e217));
                            let _e222 = (_e199 - _e200);
                            let _e229 = ((_e116 + (_e74.member_2[2] * _e155)) - 0.5f);
                            let _e230 = floor(_e229);
                            let _e232 = (bitcast<i32>(_e92.z) - 1i);
                            let _e240 = (select(0i, select(select(i32(_e230), i32(-2147483648), (_e230 < -2147483600f)), 2147483647i, (_e230 > 2147483500f)), (_e230 == _e230)) - _e88.z);
                            let _e242 = select(0i, _e240, (0i < _e240));
                            let _e244 = select(_e242, _e232, (_e232 < _e242));
                            let _e245 = (_e240 + 1i);
                            let _e247 = select(0i, _e245, (0i < _e245));
                            let _e249 = select(_e247, _e232, (_e232 < _e247));
                            let _e252 = (_e229 - _e230);
                            phi_474_ = type_11(0u, 8u);
                            phi_477_ = 0f;
                            phi_479_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                            loop {
                                let _e260 = phi_474_;
                                let _e262 = phi_477_;
                                let _e264 = phi_479_;
                                local = _e262;
                                local_1 = _e262;
                                local_2 = _e264;
                                local_3 = _e264;
                                local_4 = _e264;
                                local_5 = _e264;
                                local_6 = _e264;
                                local_7 = _e264;
                                local_8 = _e264;
                                local_9 = _e264;
                                local_10 = _e264;
                                local_11 = _e264;
                                local_12 = _e264;
                                local_13 = _e264;
                                local_14 = _e264;
                                local_15 = _e264;
                                local_16 = _e264;
                                local_17 = _e264;
                                local_18 = _e264;
                                local_19 = _e264;
                                if (_e260.member < _e260.member_1) {
                                    phi_475_ = type_11((_e260.member + 1u), _e260.member_1);
                                    phi_502_ = type_11(1u, _e260.member);
                                } else {
                                    phi_475_ = _e260;
                                    phi_502_ = type_11(0u, type_11().member_1);
                                }
                                let _e277 = phi_475_;
                                let _e279 = phi_502_;
                                let _e283 = (bitcast<i32>(_e279.member) != 0i);
                                if _e283 {
                                    let _e285 = ((_e279.member_1 & 1u) == 1u);
                                    let _e287 = ((_e279.member_1 & 2u) == 2u);
                                    let _e289 = ((_e279.member_1 & 4u) == 4u);
                                    if _e285 {
                                        phi_532_ = _e192;
                                    } else {
                                        phi_532_ = (1f - _e192);
                                    }
                                    let _e295 = phi_532_;
                                    if _e287 {
                                        phi_537_ = _e222;
                                    } else {
                                        phi_537_ = (1f - _e222);
                                    }
                                    let _e298 = phi_537_;
                                    if _e289 {
                                        phi_543_ = _e252;
                                    } else {
                                        phi_543_ = (1f - _e252);
                                    }
                                    let _e302 = phi_543_;
                                    let _e312 = (((((select((f32((_e184 + _e88.x)) + 0.5f), (f32((_e189 + _e88.x)) + 0.5f), _e285) - _e114) * _e74.member_2[0]) + ((select((f32((_e214 + _e88.y)) + 0.5f), (f32((_e219 + _e88.y)) + 0.5f), _e287) - _e115) * _e74.member_2[1])) + ((select((f32((_e244 + _e88.z)) + 0.5f), (f32((_e249 + _e88.z)) + 0.5f), _e289) - _e116) * _e74.member_2[2])) * 2f);
                                    let _e314 = select(0f, _e312, (_e312 > 0f));
                                    let _e317 = (((_e295 * _e298) * _e302) * select(1f, _e314, (_e314 < 1f)));
                                    if (_e317 > 0f) {
                                        let _e326 = (((_e159 + select(bitcast<u32>(_e184), bitcast<u32>(_e189), _e285)) + (select(bitcast<u32>(_e214), bitcast<u32>(_e219), _e287) * _e156)) + (select(bitcast<u32>(_e244), bitcast<u32>(_e249), _e289) * _e158));
                                        if (_e326 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e331 = a.member[_e326];
                                        let _e336 = (3u * _e162);
                                        let _e337 = (_e336 + _e326);
                                        if (_e337 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e341 = a.member[_e337];
                                        let _e346 = (_e162 * 6u);
                                        let _e347 = (_e346 + _e326);
                                        if (_e347 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e351 = a.member[_e347];
                                        let _e356 = (_e162 * 9u);
                                        let _e357 = (_e356 + _e326);
                                        if (_e357 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e361 = a.member[_e357];
                                        let _e366 = (_e162 * 12u);
                                        let _e367 = (_e366 + _e326);
                                        if (_e367 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e371 = a.member[_e367];
                                        let _e376 = (_e162 * 15u);
                                        let _e377 = (_e376 + _e326);
                                        if (_e377 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e381 = a.member[_e377];
                                        let _e387 = (_e162 + _e326);
                                        if (_e387 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e391 = a.member[_e387];
                                        let _e396 = (_e336 + _e387);
                                        if (_e396 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e400 = a.member[_e396];
                                        let _e405 = (_e346 + _e387);
                                        if (_e405 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e409 = a.member[_e405];
                                        let _e414 = (_e356 + _e387);
                                        if (_e414 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e418 = a.member[_e414];
                                        let _e423 = (_e366 + _e387);
                                        if (_e423 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e427 = a.member[_e423];
                                        let _e432 = (_e376 + _e387);
                                        if (_e432 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e436 = a.member[_e432];
                                        let _e443 = ((2u * _e162) + _e326);
                                        if (_e443 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e447 = a.member[_e443];
                                        let _e452 = (_e336 + _e443);
                                        if (_e452 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e456 = a.member[_e452];
                                        let _e461 = (_e346 + _e443);
                                        if (_e461 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e465 = a.member[_e461];
                                        let _e470 = (_e356 + _e443);
                                        if (_e470 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e474 = a.member[_e470];
                                        let _e479 = (_e366 + _e443);
                                        if (_e479 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e483 = a.member[_e479];
                                        let _e488 = (_e376 + _e443);
                                        if (_e488 < _e55) {
                                        } else {
                                            phi_12322_ = true;
                                            break;
                                        }
                                        let _e492 = a.member[_e488];
                                        phi_875_ = (_e262 + _e317);
                                        phi_876_ = array<array<f32, 6>, 3>(array<f32, 6>((_e264[0][0] + (_e331 * _e317)), (_e264[0][1] + (_e341 * _e317)), (_e264[0][2] + (_e351 * _e317)), (_e264[0][3] + (_e361 * _e317)), (_e264[0][4] + (_e371 * _e317)), (_e264[0][5] + (_e381 * _e317))), array<f32, 6>((_e264[1][0] + (_e391 * _e317)), (_e264[1][1] + (_e400 * _e317)), (_e264[1][2] + (_e409 * _e317)), (_e264[1][3] + (_e418 * _e317)), (_e264[1][4] + (_e427 * _e317)), (_e264[1][5] + (_e436 * _e317))), array<f32, 6>((_e264[2][0] + (_e447 * _e317)), (_e264[2][1] + (_e456 * _e317)), (_e264[2][2] + (_e465 * _e317)), (_e264[2][3] + (_e474 * _e317)), (_e264[2][4] + (_e483 * _e317)), (_e264[2][5] + (_e492 * _e317))));
                                    } else {
                                        phi_875_ = _e262;
                                        phi_876_ = _e264;
                                    }
                                    let _e500 = phi_875_;
                                    let _e502 = phi_876_;
                                    phi_478_ = _e500;
                                    phi_480_ = _e502;
                                } else {
                                    phi_478_ = f32();
                                    phi_480_ = array<array<f32, 6>, 3>();
                                }
                                let _e504 = phi_478_;
                                let _e506 = phi_480_;
                                continue;
                                continuing {
                                    phi_474_ = _e277;
                                    phi_477_ = _e504;
                                    phi_479_ = _e506;
                                    phi_12322_ = false;
                                    break if !(_e283);
                                }
                            }
                            let _e509 = phi_12322_;
                            if _e509 {
                                break;
                            }
                            let _e511 = local;
                            if (_e511 > 0f) {
                                let _e514 = local_1;
                                phi_882_ = (1f / _e514);
                            } else {
                                phi_882_ = 0f;
                            }
                            let _e517 = phi_882_;
                            let _e519 = local_2;
                            let _e524 = local_3;
                            let _e529 = local_4;
                            let _e534 = local_5;
                            let _e539 = local_6;
                            let _e544 = local_7;
                            let _e549 = local_8;
                            let _e554 = local_9;
                            let _e559 = local_10;
                            let _e564 = local_11;
                            let _e569 = local_12;
                            let _e574 = local_13;
                            let _e579 = local_14;
                            let _e584 = local_15;
                            let _e589 = local_16;
                            let _e594 = local_17;
                            let _e599 = local_18;
                            let _e604 = local_19;
                            let _e609 = ((0.6666667f / _e84.w) / _e84.w);
                            let _e610 = -(_e74.member_2[0]);
                            let _e611 = -(_e74.member_2[1]);
                            let _e614 = (_e74.member_2[2] * -1.0233268f);
                            let _e620 = ((((_e74.member_2[2] * -1.9364917f) * (_e74.member_2[2] * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                            let _e623 = (_e74.member_2[0] * -1.0233268f);
                            let _e626 = (_e74.member_2[1] * -1.0233268f);
                            let _e632 = (((_e610 * _e610) - (_e611 * _e611)) * 0.4290428f);
                            let _e634 = (((((((_e519[0][0] * _e517) * 0.886227f) + ((_e529[0][2] * _e517) * _e614)) + ((_e539[0][4] * _e517) * _e620)) + ((_e534[0][3] * _e517) * _e623)) + ((_e524[0][1] * _e517) * _e626)) + ((_e544[0][5] * _e517) * _e632));
                            let _e647 = (((((((_e549[1][0] * _e517) * 0.886227f) + ((_e559[1][2] * _e517) * _e614)) + ((_e569[1][4] * _e517) * _e620)) + ((_e564[1][3] * _e517) * _e623)) + ((_e554[1][1] * _e517) * _e626)) + ((_e574[1][5] * _e517) * _e632));
                            let _e660 = (((((((_e579[2][0] * _e517) * 0.886227f) + ((_e589[2][2] * _e517) * _e614)) + ((_e599[2][4] * _e517) * _e620)) + ((_e594[2][3] * _e517) * _e623)) + ((_e584[2][1] * _e517) * _e626)) + ((_e604[2][5] * _e517) * _e632));
                            phi_12387_ = _e509;
                            phi_3170_ = vec4<f32>(((select(0f, _e634, (_e634 > 0f)) * _e609) * _e151), ((select(0f, _e647, (_e647 > 0f)) * _e609) * _e151), ((select(0f, _e660, (_e660 > 0f)) * _e609) * _e151), (1f - _e151));
                        }
                        let _e672 = phi_12387_;
                        let _e674 = phi_3170_;
                        phi_12385_ = _e672;
                        phi_3172_ = _e674;
                    }
                    let _e676 = phi_12385_;
                    let _e678 = phi_3172_;
                    let _e681 = select(_e678, vec4<f32>(0f, 0f, 0f, 1f), vec4(select(false, true, _e80)));
                    if (1u >= _e79) {
                        phi_12652_ = _e676;
                        phi_6209_ = vec4<f32>();
                        phi_6210_ = true;
                    } else {
                        let _e684 = (_e681.w <= 0f);
                        if _e684 {
                            phi_12653_ = _e676;
                            phi_6208_ = vec4<f32>();
                        } else {
                            let _e688 = params.member.member[1u];
                            let _e692 = params.member.member_1[1u];
                            let _e696 = params.member.member_2[1u];
                            if (2u == _e79) {
                                phi_3230_ = 0f;
                            } else {
                                let _e708 = params.member.member_5;
                                phi_3230_ = _e708;
                            }
                            let _e710 = phi_3230_;
                            let _e718 = ((_e74.member[0] - _e688.x) / _e688.w);
                            let _e719 = ((_e74.member[1] - _e688.y) / _e688.w);
                            let _e720 = ((_e74.member[2] - _e688.z) / _e688.w);
                            let _e727 = (_e718 - f32(_e692.x));
                            let _e728 = (_e719 - f32(_e692.y));
                            let _e729 = (_e720 - f32(_e692.z));
                            let _e737 = select(_e729, _e728, (_e728 < _e729));
                            let _e739 = select(_e737, _e727, (_e727 < _e737));
                            let _e740 = (f32(_e696.x) - _e727);
                            let _e741 = (f32(_e696.y) - _e728);
                            let _e742 = (f32(_e696.z) - _e729);
                            let _e744 = select(_e742, _e741, (_e741 < _e742));
                            let _e746 = select(_e744, _e740, (_e740 < _e744));
                            let _e751 = (select(_e746, _e739, (_e739 < _e746)) / select(0.001f, _e710, (_e710 > 0.001f)));
                            let _e753 = select(0f, _e751, (_e751 > 0f));
                            let _e756 = (_e681.w * select(1f, _e753, (_e753 < 1f)));
                            if (_e756 <= 0f) {
                                phi_12654_ = _e676;
                                phi_6207_ = _e681;
                            } else {
                                let _e763 = params.member.member_6;
                                let _e764 = (_e696.x + 1u);
                                let _e766 = ((_e696.y + 1u) * _e764);
                                let _e767 = (_e766 + _e764);
                                let _e770 = (_e767 + ((_e696.z + 1u) * _e766));
                                let _e777 = ((_e718 + (_e74.member_2[0] * _e763)) - 0.5f);
                                let _e778 = floor(_e777);
                                let _e780 = (bitcast<i32>(_e696.x) - 1i);
                                let _e788 = (select(0i, select(select(i32(_e778), i32(-2147483648), (_e778 < -2147483600f)), 2147483647i, (_e778 > 2147483500f)), (_e778 == _e778)) - _e692.x);
                                let _e790 = select(0i, _e788, (0i < _e788));
                                let _e792 = select(_e790, _e780, (_e780 < _e790));
                                let _e793 = (_e788 + 1i);
                                let _e795 = select(0i, _e793, (0i < _e793));
                                let _e797 = select(_e795, _e780, (_e780 < _e795));
                                let _e800 = (_e777 - _e778);
                                let _e807 = ((_e719 + (_e74.member_2[1] * _e763)) - 0.5f);
                                let _e808 = floor(_e807);
                                let _e810 = (bitcast<i32>(_e696.y) - 1i);
                                let _e818 = (select(0i, select(select(i32(_e808), i32(-2147483648), (_e808 < -2147483600f)), 2147483647i, (_e808 > 2147483500f)), (_e808 == _e808)) - _e692.y);
                                let _e820 = select(0i, _e818, (0i < _e818));
                                let _e822 = select(_e820, _e810, (_e810 < _e820));
                                let _e823 = (_e818 + 1i);
                                let _e825 = select(0i, _e823, (0i < _e823));
                                let _e827 = select(_e825, _e810, (_e810 < _e825));
                                let _e830 = (_e807 - _e808);
                                let _e837 = ((_e720 + (_e74.member_2[2] * _e763)) - 0.5f);
                                let _e838 = floor(_e837);
                                let _e840 = (bitcast<i32>(_e696.z) - 1i);
                                let _e848 = (select(0i, select(select(i32(_e838), i32(-2147483648), (_e838 < -2147483600f)), 2147483647i, (_e838 > 2147483500f)), (_e838 == _e838)) - _e692.z);
                                let _e850 = select(0i, _e848, (0i < _e848));
                                let _e852 = select(_e850, _e840, (_e840 < _e850));
                                let _e853 = (_e848 + 1i);
                                let _e855 = select(0i, _e853, (0i < _e853));
                                let _e857 = select(_e855, _e840, (_e840 < _e855));
                                let _e860 = (_e837 - _e838);
                                phi_3511_ = type_11(0u, 8u);
                                phi_3514_ = 0f;
                                phi_3516_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                                loop {
                                    let _e868 = phi_3511_;
                                    let _e870 = phi_3514_;
                                    let _e872 = phi_3516_;
                                    local_20 = _e870;
                                    local_21 = _e870;
                                    local_22 = _e872;
                                    local_23 = _e872;
                                    local_24 = _e872;
                                    local_25 = _e872;
                                    local_26 = _e872;
                                    local_27 = _e872;
                                    local_28 = _e872;
                                    local_29 = _e872;
                                    local_30 = _e872;
                                    local_31 = _e872;
                                    local_32 = _e872;
                                    local_33 = _e872;
                                    local_34 = _e872;
                                    local_35 = _e872;
                                    local_36 = _e872;
                                    local_37 = _e872;
                                    local_38 = _e872;
                                    local_39 = _e872;
                                    if (_e868.member < _e868.member_1) {
                                        phi_3512_ = type_11((_e868.member + 1u), _e868.member_1);
                                        phi_3539_ = type_11(1u, _e868.member);
                                    } else {
                                        phi_3512_ = _e868;
                                        phi_3539_ = type_11(0u, type_11().member_1);
                                    }
                                    let _e885 = phi_3512_;
                                    let _e887 = phi_3539_;
                                    let _e891 = (bitcast<i32>(_e887.member) != 0i);
                                    if _e891 {
                                        let _e893 = ((_e887.member_1 & 1u) == 1u);
                                        let _e895 = ((_e887.member_1 & 2u) == 2u);
                                        let _e897 = ((_e887.member_1 & 4u) == 4u);
                                        if _e893 {
                                            phi_3569_ = _e800;
                                        } else {
                                            phi_3569_ = (1f - _e800);
                                        }
                                        let _e903 = phi_3569_;
                                        if _e895 {
                                            phi_3574_ = _e830;
                                        } else {
                                            phi_3574_ = (1f - _e830);
                                        }
                                        let _e906 = phi_3574_;
                                        if _e897 {
                                            phi_3580_ = _e860;
                                        } else {
                                            phi_3580_ = (1f - _e860);
                                        }
                                        let _e910 = phi_3580_;
                                        let _e920 = (((((select((f32((_e792 + _e692.x)) + 0.5f), (f32((_e797 + _e692.x)) + 0.5f), _e893) - _e718) * _e74.member_2[0]) + ((select((f32((_e822 + _e692.y)) + 0.5f), (f32((_e827 + _e692.y)) + 0.5f), _e895) - _e719) * _e74.member_2[1])) + ((select((f32((_e852 + _e692.z)) + 0.5f), (f32((_e857 + _e692.z)) + 0.5f), _e897) - _e720) * _e74.member_2[2])) * 2f);
                                        let _e922 = select(0f, _e920, (_e920 > 0f));
                                        let _e925 = (((_e903 * _e906) * _e910) * select(1f, _e922, (_e922 < 1f)));
                                        if (_e925 > 0f) {
                                            let _e934 = (((_e767 + select(bitcast<u32>(_e792), bitcast<u32>(_e797), _e893)) + (select(bitcast<u32>(_e822), bitcast<u32>(_e827), _e895) * _e764)) + (select(bitcast<u32>(_e852), bitcast<u32>(_e857), _e897) * _e766));
                                            if (_e934 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e939 = b.member[_e934];
                                            let _e944 = (3u * _e770);
                                            let _e945 = (_e944 + _e934);
                                            if (_e945 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e949 = b.member[_e945];
                                            let _e954 = (_e770 * 6u);
                                            let _e955 = (_e954 + _e934);
                                            if (_e955 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e959 = b.member[_e955];
                                            let _e964 = (_e770 * 9u);
                                            let _e965 = (_e964 + _e934);
                                            if (_e965 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e969 = b.member[_e965];
                                            let _e974 = (_e770 * 12u);
                                            let _e975 = (_e974 + _e934);
                                            if (_e975 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e979 = b.member[_e975];
                                            let _e984 = (_e770 * 15u);
                                            let _e985 = (_e984 + _e934);
                                            if (_e985 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e989 = b.member[_e985];
                                            let _e995 = (_e770 + _e934);
                                            if (_e995 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e999 = b.member[_e995];
                                            let _e1004 = (_e944 + _e995);
                                            if (_e1004 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1008 = b.member[_e1004];
                                            let _e1013 = (_e954 + _e995);
                                            if (_e1013 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1017 = b.member[_e1013];
                                            let _e1022 = (_e964 + _e995);
                                            if (_e1022 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1026 = b.member[_e1022];
                                            let _e1031 = (_e974 + _e995);
                                            if (_e1031 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1035 = b.member[_e1031];
                                            let _e1040 = (_e984 + _e995);
                                            if (_e1040 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1044 = b.member[_e1040];
                                            let _e1051 = ((2u * _e770) + _e934);
                                            if (_e1051 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1055 = b.member[_e1051];
                                            let _e1060 = (_e944 + _e1051);
                                            if (_e1060 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1064 = b.member[_e1060];
                                            let _e1069 = (_e954 + _e1051);
                                            if (_e1069 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1073 = b.member[_e1069];
                                            let _e1078 = (_e964 + _e1051);
                                            if (_e1078 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1082 = b.member[_e1078];
                                            let _e1087 = (_e974 + _e1051);
                                            if (_e1087 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1091 = b.member[_e1087];
                                            let _e1096 = (_e984 + _e1051);
                                            if (_e1096 < _e57) {
                                            } else {
                                                phi_12359_ = true;
                                                break;
                                            }
                                            let _e1100 = b.member[_e1096];
                                            phi_3912_ = (_e870 + _e925);
                                            phi_3913_ = array<array<f32, 6>, 3>(array<f32, 6>((_e872[0][0] + (_e939 * _e925)), (_e872[0][1] + (_e949 * _e925)), (_e872[0][2] + (_e959 * _e925)), (_e872[0][3] + (_e969 * _e925)), (_e872[0][4] + (_e979 * _e925)), (_e872[0][5] + (_e989 * _e925))), array<f32, 6>((_e872[1][0] + (_e999 * _e925)), (_e872[1][1] + (_e1008 * _e925)), (_e872[1][2] + (_e1017 * _e925)), (_e872[1][3] + (_e1026 * _e925)), (_e872[1][4] + (_e1035 * _e925)), (_e872[1][5] + (_e1044 * _e925))), array<f32, 6>((_e872[2][0] + (_e1055 * _e925)), (_e872[2][1] + (_e1064 * _e925)), (_e872[2][2] + (_e1073 * _e925)), (_e872[2][3] + (_e1082 * _e925)), (_e872[2][4] + (_e1091 * _e925)), (_e872[2][5] + (_e1100 * _e925))));
                                        } else {
                                            phi_3912_ = _e870;
                                            phi_3913_ = _e872;
                                        }
                                        let _e1108 = phi_3912_;
                                        let _e1110 = phi_3913_;
                                        phi_3515_ = _e1108;
                                        phi_3517_ = _e1110;
                                    } else {
                                        phi_3515_ = f32();
                                        phi_3517_ = array<array<f32, 6>, 3>();
                                    }
                                    let _e1112 = phi_3515_;
                                    let _e1114 = phi_3517_;
                                    continue;
                                    continuing {
                                        phi_3511_ = _e885;
                                        phi_3514_ = _e1112;
                                        phi_3516_ = _e1114;
                                        phi_12359_ = _e676;
                                        break if !(_e891);
                                    }
                                }
                                let _e1117 = phi_12359_;
                                if _e1117 {
                                    break;
                                }
                                let _e1119 = local_20;
                                if (_e1119 > 0f) {
                                    let _e1122 = local_21;
                                    phi_3919_ = (1f / _e1122);
                                } else {
                                    phi_3919_ = 0f;
                                }
                                let _e1125 = phi_3919_;
                                let _e1127 = local_22;
                                let _e1132 = local_23;
                                let _e1137 = local_24;
                                let _e1142 = local_25;
                                let _e1147 = local_26;
                                let _e1152 = local_27;
                                let _e1157 = local_28;
                                let _e1162 = local_29;
                                let _e1167 = local_30;
                                let _e1172 = local_31;
                                let _e1177 = local_32;
                                let _e1182 = local_33;
                                let _e1187 = local_34;
                                let _e1192 = local_35;
                                let _e1197 = local_36;
                                let _e1202 = local_37;
                                let _e1207 = local_38;
                                let _e1212 = local_39;
                                let _e1217 = ((0.6666667f / _e688.w) / _e688.w);
                                let _e1218 = -(_e74.member_2[0]);
                                let _e1219 = -(_e74.member_2[1]);
                                let _e1222 = (_e74.member_2[2] * -1.0233268f);
                                let _e1228 = ((((_e74.member_2[2] * -1.9364917f) * (_e74.member_2[2] * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                                let _e1231 = (_e74.member_2[0] * -1.0233268f);
                                let _e1234 = (_e74.member_2[1] * -1.0233268f);
                                let _e1240 = (((_e1218 * _e1218) - (_e1219 * _e1219)) * 0.4290428f);
                                let _e1242 = (((((((_e1127[0][0] * _e1125) * 0.886227f) + ((_e1137[0][2] * _e1125) * _e1222)) + ((_e1147[0][4] * _e1125) * _e1228)) + ((_e1142[0][3] * _e1125) * _e1231)) + ((_e1132[0][1] * _e1125) * _e1234)) + ((_e1152[0][5] * _e1125) * _e1240));
                                let _e1255 = (((((((_e1157[1][0] * _e1125) * 0.886227f) + ((_e1167[1][2] * _e1125) * _e1222)) + ((_e1177[1][4] * _e1125) * _e1228)) + ((_e1172[1][3] * _e1125) * _e1231)) + ((_e1162[1][1] * _e1125) * _e1234)) + ((_e1182[1][5] * _e1125) * _e1240));
                                let _e1268 = (((((((_e1187[2][0] * _e1125) * 0.886227f) + ((_e1197[2][2] * _e1125) * _e1222)) + ((_e1207[2][4] * _e1125) * _e1228)) + ((_e1202[2][3] * _e1125) * _e1231)) + ((_e1192[2][1] * _e1125) * _e1234)) + ((_e1212[2][5] * _e1125) * _e1240));
                                phi_12654_ = _e1117;
                                phi_6207_ = vec4<f32>((_e681.x + ((select(0f, _e1242, (_e1242 > 0f)) * _e1217) * _e756)), (_e681.y + ((select(0f, _e1255, (_e1255 > 0f)) * _e1217) * _e756)), (_e681.z + ((select(0f, _e1268, (_e1268 > 0f)) * _e1217) * _e756)), (_e681.w - _e756));
                            }
                            let _e1283 = phi_12654_;
                            let _e1285 = phi_6207_;
                            phi_12653_ = _e1283;
                            phi_6208_ = _e1285;
                        }
                        let _e1287 = phi_12653_;
                        let _e1289 = phi_6208_;
                        phi_12652_ = _e1287;
                        phi_6209_ = _e1289;
                        phi_6210_ = _e684;
                    }
                    let _e1291 = phi_12652_;
                    let _e1293 = phi_6209_;
                    let _e1295 = phi_6210_;
                    let _e1297 = select(_e1293, _e681, vec4(_e1295));
                    if (2u >= _e79) {
                        phi_12919_ = _e1291;
                        phi_9246_ = vec4<f32>();
                        phi_9247_ = true;
                    } else {
                        let _e1300 = (_e1297.w <= 0f);
                        if _e1300 {
                            phi_12920_ = _e1291;
                            phi_9245_ = vec4<f32>();
                        } else {
                            let _e1304 = params.member.member[2u];
                            let _e1308 = params.member.member_1[2u];
                            let _e1312 = params.member.member_2[2u];
                            if (3u == _e79) {
                                phi_6267_ = 0f;
                            } else {
                                let _e1324 = params.member.member_5;
                                phi_6267_ = _e1324;
                            }
                            let _e1326 = phi_6267_;
                            let _e1334 = ((_e74.member[0] - _e1304.x) / _e1304.w);
                            let _e1335 = ((_e74.member[1] - _e1304.y) / _e1304.w);
                            let _e1336 = ((_e74.member[2] - _e1304.z) / _e1304.w);
                            let _e1343 = (_e1334 - f32(_e1308.x));
                            let _e1344 = (_e1335 - f32(_e1308.y));
                            let _e1345 = (_e1336 - f32(_e1308.z));
                            let _e1353 = select(_e1345, _e1344, (_e1344 < _e1345));
                            let _e1355 = select(_e1353, _e1343, (_e1343 < _e1353));
                            let _e1356 = (f32(_e1312.x) - _e1343);
                            let _e1357 = (f32(_e1312.y) - _e1344);
                            let _e1358 = (f32(_e1312.z) - _e1345);
                            let _e1360 = select(_e1358, _e1357, (_e1357 < _e1358));
                            let _e1362 = select(_e1360, _e1356, (_e1356 < _e1360));
                            let _e1367 = (select(_e1362, _e1355, (_e1355 < _e1362)) / select(0.001f, _e1326, (_e1326 > 0.001f)));
                            let _e1369 = select(0f, _e1367, (_e1367 > 0f));
                            let _e1372 = (_e1297.w * select(1f, _e1369, (_e1369 < 1f)));
                            if (_e1372 <= 0f) {
                                phi_12921_ = _e1291;
                                phi_9244_ = _e1297;
                            } else {
                                let _e1379 = params.member.member_6;
                                let _e1380 = (_e1312.x + 1u);
                                let _e1382 = ((_e1312.y + 1u) * _e1380);
                                let _e1383 = (_e1382 + _e1380);
                                let _e1386 = (_e1383 + ((_e1312.z + 1u) * _e1382));
                                let _e1393 = ((_e1334 + (_e74.member_2[0] * _e1379)) - 0.5f);
                                let _e1394 = floor(_e1393);
                                let _e1396 = (bitcast<i32>(_e1312.x) - 1i);
                                let _e1404 = (select(0i, select(select(i32(_e1394), i32(-2147483648), (_e1394 < -2147483600f)), 2147483647i, (_e1394 > 2147483500f)), (_e1394 == _e1394)) - _e1308.x);
                                let _e1406 = select(0i, _e1404, (0i < _e1404));
                                let _e1408 = select(_e1406, _e1396, (_e1396 < _e1406));
                                let _e1409 = (_e1404 + 1i);
                                let _e1411 = select(0i, _e1409, (0i < _e1409));
                                let _e1413 = select(_e1411, _e1396, (_e1396 < _e1411));
                                let _e1416 = (_e1393 - _e1394);
                                let _e1423 = ((_e1335 + (_e74.member_2[1] * _e1379)) - 0.5f);
                                let _e1424 = floor(_e1423);
                                let _e1426 = (bitcast<i32>(_e1312.y) - 1i);
                                let _e1434 = (select(0i, select(select(i32(_e1424), i32(-2147483648), (_e1424 < -2147483600f)), 2147483647i, (_e1424 > 2147483500f)), (_e1424 == _e1424)) - _e1308.y);
                                let _e1436 = select(0i, _e1434, (0i < _e1434));
                                let _e1438 = select(_e1436, _e1426, (_e1426 < _e1436));
                                let _e1439 = (_e1434 + 1i);
                                let _e1441 = select(0i, _e1439, (0i < _e1439));
                                let _e1443 = select(_e1441, _e1426, (_e1426 < _e1441));
                                let _e1446 = (_e1423 - _e1424);
                                let _e1453 = ((_e1336 + (_e74.member_2[2] * _e1379)) - 0.5f);
                                let _e1454 = floor(_e1453);
                                let _e1456 = (bitcast<i32>(_e1312.z) - 1i);
                                let _e1464 = (select(0i, select(select(i32(_e1454), i32(-2147483648), (_e1454 < -2147483600f)), 2147483647i, (_e1454 > 2147483500f)), (_e1454 == _e1454)) - _e1308.z);
                                let _e1466 = select(0i, _e1464, (0i < _e1464));
                                let _e1468 = select(_e1466, _e1456, (_e1456 < _e1466));
                                let _e1469 = (_e1464 + 1i);
                                let _e1471 = select(0i, _e1469, (0i < _e1469));
                                let _e1473 = select(_e1471, _e1456, (_e1456 < _e1471));
                                let _e1476 = (_e1453 - _e1454);
                                phi_6548_ = type_11(0u, 8u);
                                phi_6551_ = 0f;
                                phi_6553_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                                loop {
                                    let _e1484 = phi_6548_;
                                    let _e1486 = phi_6551_;
                                    let _e1488 = phi_6553_;
                                    local_40 = _e1486;
                                    local_41 = _e1486;
                                    local_42 = _e1488;
                                    local_43 = _e1488;
                                    local_44 = _e1488;
                                    local_45 = _e1488;
                                    local_46 = _e1488;
                                    local_47 = _e1488;
                                    local_48 = _e1488;
                                    local_49 = _e1488;
                                    local_50 = _e1488;
                                    local_51 = _e1488;
                                    local_52 = _e1488;
                                    local_53 = _e1488;
                                    local_54 = _e1488;
                                    local_55 = _e1488;
                                    local_56 = _e1488;
                                    local_57 = _e1488;
                                    local_58 = _e1488;
                                    local_59 = _e1488;
                                    if (_e1484.member < _e1484.member_1) {
                                        phi_6549_ = type_11((_e1484.member + 1u), _e1484.member_1);
                                        phi_6576_ = type_11(1u, _e1484.member);
                                    } else {
                                        phi_6549_ = _e1484;
                                        phi_6576_ = type_11(0u, type_11().member_1);
                                    }
                                    let _e1501 = phi_6549_;
                                    let _e1503 = phi_6576_;
                                    let _e1507 = (bitcast<i32>(_e1503.member) != 0i);
                                    if _e1507 {
                                        let _e1509 = ((_e1503.member_1 & 1u) == 1u);
                                        let _e1511 = ((_e1503.member_1 & 2u) == 2u);
                                        let _e1513 = ((_e1503.member_1 & 4u) == 4u);
                                        if _e1509 {
                                            phi_6606_ = _e1416;
                                        } else {
                                            phi_6606_ = (1f - _e1416);
                                        }
                                        let _e1519 = phi_6606_;
                                        if _e1511 {
                                            phi_6611_ = _e1446;
                                        } else {
                                            phi_6611_ = (1f - _e1446);
                                        }
                                        let _e1522 = phi_6611_;
                                        if _e1513 {
                                            phi_6617_ = _e1476;
                                        } else {
                                            phi_6617_ = (1f - _e1476);
                                        }
                                        let _e1526 = phi_6617_;
                                        let _e1536 = (((((select((f32((_e1408 + _e1308.x)) + 0.5f), (f32((_e1413 + _e1308.x)) + 0.5f), _e1509) - _e1334) * _e74.member_2[0]) + ((select((f32((_e1438 + _e1308.y)) + 0.5f), (f32((_e1443 + _e1308.y)) + 0.5f), _e1511) - _e1335) * _e74.member_2[1])) + ((select((f32((_e1468 + _e1308.z)) + 0.5f), (f32((_e1473 + _e1308.z)) + 0.5f), _e1513) - _e1336) * _e74.member_2[2])) * 2f);
                                        let _e1538 = select(0f, _e1536, (_e1536 > 0f));
                                        let _e1541 = (((_e1519 * _e1522) * _e1526) * select(1f, _e1538, (_e1538 < 1f)));
                                        if (_e1541 > 0f) {
                                            let _e1550 = (((_e1383 + select(bitcast<u32>(_e1408), bitcast<u32>(_e1413), _e1509)) + (select(bitcast<u32>(_e1438), bitcast<u32>(_e1443), _e1511) * _e1380)) + (select(bitcast<u32>(_e1468), bitcast<u32>(_e1473), _e1513) * _e1382));
                                            if (_e1550 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1555 = c.member[_e1550];
                                            let _e1560 = (3u * _e1386);
                                            let _e1561 = (_e1560 + _e1550);
                                            if (_e1561 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1565 = c.member[_e1561];
                                            let _e1570 = (_e1386 * 6u);
                                            let _e1571 = (_e1570 + _e1550);
                                            if (_e1571 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1575 = c.member[_e1571];
                                            let _e1580 = (_e1386 * 9u);
                                            let _e1581 = (_e1580 + _e1550);
                                            if (_e1581 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1585 = c.member[_e1581];
                                            let _e1590 = (_e1386 * 12u);
                                            let _e1591 = (_e1590 + _e1550);
                                            if (_e1591 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1595 = c.member[_e1591];
                                            let _e1600 = (_e1386 * 15u);
                                            let _e1601 = (_e1600 + _e1550);
                                            if (_e1601 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1605 = c.member[_e1601];
                                            let _e1611 = (_e1386 + _e1550);
                                            if (_e1611 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1615 = c.member[_e1611];
                                            let _e1620 = (_e1560 + _e1611);
                                            if (_e1620 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1624 = c.member[_e1620];
                                            let _e1629 = (_e1570 + _e1611);
                                            if (_e1629 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1633 = c.member[_e1629];
                                            let _e1638 = (_e1580 + _e1611);
                                            if (_e1638 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1642 = c.member[_e1638];
                                            let _e1647 = (_e1590 + _e1611);
                                            if (_e1647 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1651 = c.member[_e1647];
                                            let _e1656 = (_e1600 + _e1611);
                                            if (_e1656 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1660 = c.member[_e1656];
                                            let _e1667 = ((2u * _e1386) + _e1550);
                                            if (_e1667 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1671 = c.member[_e1667];
                                            let _e1676 = (_e1560 + _e1667);
                                            if (_e1676 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1680 = c.member[_e1676];
                                            let _e1685 = (_e1570 + _e1667);
                                            if (_e1685 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1689 = c.member[_e1685];
                                            let _e1694 = (_e1580 + _e1667);
                                            if (_e1694 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1698 = c.member[_e1694];
                                            let _e1703 = (_e1590 + _e1667);
                                            if (_e1703 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1707 = c.member[_e1703];
                                            let _e1712 = (_e1600 + _e1667);
                                            if (_e1712 < _e59) {
                                            } else {
                                                phi_12626_ = true;
                                                break;
                                            }
                                            let _e1716 = c.member[_e1712];
                                            phi_6949_ = (_e1486 + _e1541);
                                            phi_6950_ = array<array<f32, 6>, 3>(array<f32, 6>((_e1488[0][0] + (_e1555 * _e1541)), (_e1488[0][1] + (_e1565 * _e1541)), (_e1488[0][2] + (_e1575 * _e1541)), (_e1488[0][3] + (_e1585 * _e1541)), (_e1488[0][4] + (_e1595 * _e1541)), (_e1488[0][5] + (_e1605 * _e1541))), array<f32, 6>((_e1488[1][0] + (_e1615 * _e1541)), (_e1488[1][1] + (_e1624 * _e1541)), (_e1488[1][2] + (_e1633 * _e1541)), (_e1488[1][3] + (_e1642 * _e1541)), (_e1488[1][4] + (_e1651 * _e1541)), (_e1488[1][5] + (_e1660 * _e1541))), array<f32, 6>((_e1488[2][0] + (_e1671 * _e1541)), (_e1488[2][1] + (_e1680 * _e1541)), (_e1488[2][2] + (_e1689 * _e1541)), (_e1488[2][3] + (_e1698 * _e1541)), (_e1488[2][4] + (_e1707 * _e1541)), (_e1488[2][5] + (_e1716 * _e1541))));
                                        } else {
                                            phi_6949_ = _e1486;
                                            phi_6950_ = _e1488;
                                        }
                                        let _e1724 = phi_6949_;
                                        let _e1726 = phi_6950_;
                                        phi_6552_ = _e1724;
                                        phi_6554_ = _e1726;
                                    } else {
                                        phi_6552_ = f32();
                                        phi_6554_ = array<array<f32, 6>, 3>();
                                    }
                                    let _e1728 = phi_6552_;
                                    let _e1730 = phi_6554_;
                                    continue;
                                    continuing {
                                        phi_6548_ = _e1501;
                                        phi_6551_ = _e1728;
                                        phi_6553_ = _e1730;
                                        phi_12626_ = _e1291;
                                        break if !(_e1507);
                                    }
                                }
                                let _e1733 = phi_12626_;
                                if _e1733 {
                                    break;
                                }
                                let _e1735 = local_40;
                                if (_e1735 > 0f) {
                                    let _e1738 = local_41;
                                    phi_6956_ = (1f / _e1738);
                                } else {
                                    phi_6956_ = 0f;
                                }
                                let _e1741 = phi_6956_;
                                let _e1743 = local_42;
                                let _e1748 = local_43;
                                let _e1753 = local_44;
                                let _e1758 = local_45;
                                let _e1763 = local_46;
                                let _e1768 = local_47;
                                let _e1773 = local_48;
                                let _e1778 = local_49;
                                let _e1783 = local_50;
                                let _e1788 = local_51;
                                let _e1793 = local_52;
                                let _e1798 = local_53;
                                let _e1803 = local_54;
                                let _e1808 = local_55;
                                let _e1813 = local_56;
                                let _e1818 = local_57;
                                let _e1823 = local_58;
                                let _e1828 = local_59;
                                let _e1833 = ((0.6666667f / _e1304.w) / _e1304.w);
                                let _e1834 = -(_e74.member_2[0]);
                                let _e1835 = -(_e74.member_2[1]);
                                let _e1838 = (_e74.member_2[2] * -1.0233268f);
                                let _e1844 = ((((_e74.member_2[2] * -1.9364917f) * (_e74.member_2[2] * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                                let _e1847 = (_e74.member_2[0] * -1.0233268f);
                                let _e1850 = (_e74.member_2[1] * -1.0233268f);
                                let _e1856 = (((_e1834 * _e1834) - (_e1835 * _e1835)) * 0.4290428f);
                                let _e1858 = (((((((_e1743[0][0] * _e1741) * 0.886227f) + ((_e1753[0][2] * _e1741) * _e1838)) + ((_e1763[0][4] * _e1741) * _e1844)) + ((_e1758[0][3] * _e1741) * _e1847)) + ((_e1748[0][1] * _e1741) * _e1850)) + ((_e1768[0][5] * _e1741) * _e1856));
                                let _e1871 = (((((((_e1773[1][0] * _e1741) * 0.886227f) + ((_e1783[1][2] * _e1741) * _e1838)) + ((_e1793[1][4] * _e1741) * _e1844)) + ((_e1788[1][3] * _e1741) * _e1847)) + ((_e1778[1][1] * _e1741) * _e1850)) + ((_e1798[1][5] * _e1741) * _e1856));
                                let _e1884 = (((((((_e1803[2][0] * _e1741) * 0.886227f) + ((_e1813[2][2] * _e1741) * _e1838)) + ((_e1823[2][4] * _e1741) * _e1844)) + ((_e1818[2][3] * _e1741) * _e1847)) + ((_e1808[2][1] * _e1741) * _e1850)) + ((_e1828[2][5] * _e1741) * _e1856));
                                phi_12921_ = _e1733;
                                phi_9244_ = vec4<f32>((_e1297.x + ((select(0f, _e1858, (_e1858 > 0f)) * _e1833) * _e1372)), (_e1297.y + ((select(0f, _e1871, (_e1871 > 0f)) * _e1833) * _e1372)), (_e1297.z + ((select(0f, _e1884, (_e1884 > 0f)) * _e1833) * _e1372)), (_e1297.w - _e1372));
                            }
                            let _e1899 = phi_12921_;
                            let _e1901 = phi_9244_;
                            phi_12920_ = _e1899;
                            phi_9245_ = _e1901;
                        }
                        let _e1903 = phi_12920_;
                        let _e1905 = phi_9245_;
                        phi_12919_ = _e1903;
                        phi_9246_ = _e1905;
                        phi_9247_ = _e1300;
                    }
                    let _e1907 = phi_12919_;
                    let _e1909 = phi_9246_;
                    let _e1911 = phi_9247_;
                    let _e1913 = select(_e1909, _e1297, vec4(_e1911));
                    if (3u >= _e79) {
                        phi_12283_ = vec4<f32>();
                        phi_12284_ = true;
                    } else {
                        let _e1916 = (_e1913.w <= 0f);
                        if _e1916 {
                            phi_12282_ = vec4<f32>();
                        } else {
                            let _e1920 = params.member.member[3u];
                            let _e1924 = params.member.member_1[3u];
                            let _e1928 = params.member.member_2[3u];
                            if (4u == _e79) {
                                phi_9304_ = 0f;
                            } else {
                                let _e1940 = params.member.member_5;
                                phi_9304_ = _e1940;
                            }
                            let _e1942 = phi_9304_;
                            let _e1950 = ((_e74.member[0] - _e1920.x) / _e1920.w);
                            let _e1951 = ((_e74.member[1] - _e1920.y) / _e1920.w);
                            let _e1952 = ((_e74.member[2] - _e1920.z) / _e1920.w);
                            let _e1959 = (_e1950 - f32(_e1924.x));
                            let _e1960 = (_e1951 - f32(_e1924.y));
                            let _e1961 = (_e1952 - f32(_e1924.z));
                            let _e1969 = select(_e1961, _e1960, (_e1960 < _e1961));
                            let _e1971 = select(_e1969, _e1959, (_e1959 < _e1969));
                            let _e1972 = (f32(_e1928.x) - _e1959);
                            let _e1973 = (f32(_e1928.y) - _e1960);
                            let _e1974 = (f32(_e1928.z) - _e1961);
                            let _e1976 = select(_e1974, _e1973, (_e1973 < _e1974));
                            let _e1978 = select(_e1976, _e1972, (_e1972 < _e1976));
                            let _e1983 = (select(_e1978, _e1971, (_e1971 < _e1978)) / select(0.001f, _e1942, (_e1942 > 0.001f)));
                            let _e1985 = select(0f, _e1983, (_e1983 > 0f));
                            let _e1988 = (_e1913.w * select(1f, _e1985, (_e1985 < 1f)));
                            if (_e1988 <= 0f) {
                                phi_12281_ = _e1913;
                            } else {
                                let _e1995 = params.member.member_6;
                                let _e1996 = (_e1928.x + 1u);
                                let _e1998 = ((_e1928.y + 1u) * _e1996);
                                let _e1999 = (_e1998 + _e1996);
                                let _e2002 = (_e1999 + ((_e1928.z + 1u) * _e1998));
                                let _e2009 = ((_e1950 + (_e74.member_2[0] * _e1995)) - 0.5f);
                                let _e2010 = floor(_e2009);
                                let _e2012 = (bitcast<i32>(_e1928.x) - 1i);
                                let _e2020 = (select(0i, select(select(i32(_e2010), i32(-2147483648), (_e2010 < -2147483600f)), 2147483647i, (_e2010 > 2147483500f)), (_e2010 == _e2010)) - _e1924.x);
                                let _e2022 = select(0i, _e2020, (0i < _e2020));
                                let _e2024 = select(_e2022, _e2012, (_e2012 < _e2022));
                                let _e2025 = (_e2020 + 1i);
                                let _e2027 = select(0i, _e2025, (0i < _e2025));
                                let _e2029 = select(_e2027, _e2012, (_e2012 < _e2027));
                                let _e2032 = (_e2009 - _e2010);
                                let _e2039 = ((_e1951 + (_e74.member_2[1] * _e1995)) - 0.5f);
                                let _e2040 = floor(_e2039);
                                let _e2042 = (bitcast<i32>(_e1928.y) - 1i);
                                let _e2050 = (select(0i, select(select(i32(_e2040), i32(-2147483648), (_e2040 < -2147483600f)), 2147483647i, (_e2040 > 2147483500f)), (_e2040 == _e2040)) - _e1924.y);
                                let _e2052 = select(0i, _e2050, (0i < _e2050));
                                let _e2054 = select(_e2052, _e2042, (_e2042 < _e2052));
                                let _e2055 = (_e2050 + 1i);
                                let _e2057 = select(0i, _e2055, (0i < _e2055));
                                let _e2059 = select(_e2057, _e2042, (_e2042 < _e2057));
                                let _e2062 = (_e2039 - _e2040);
                                let _e2069 = ((_e1952 + (_e74.member_2[2] * _e1995)) - 0.5f);
                                let _e2070 = floor(_e2069);
                                let _e2072 = (bitcast<i32>(_e1928.z) - 1i);
                                let _e2080 = (select(0i, select(select(i32(_e2070), i32(-2147483648), (_e2070 < -2147483600f)), 2147483647i, (_e2070 > 2147483500f)), (_e2070 == _e2070)) - _e1924.z);
                                let _e2082 = select(0i, _e2080, (0i < _e2080));
                                let _e2084 = select(_e2082, _e2072, (_e2072 < _e2082));
                                let _e2085 = (_e2080 + 1i);
                                let _e2087 = select(0i, _e2085, (0i < _e2085));
                                let _e2089 = select(_e2087, _e2072, (_e2072 < _e2087));
                                let _e2092 = (_e2069 - _e2070);
                                phi_9585_ = type_11(0u, 8u);
                                phi_9588_ = 0f;
                                phi_9590_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                                loop {
                                    let _e2100 = phi_9585_;
                                    let _e2102 = phi_9588_;
                                    let _e2104 = phi_9590_;
                                    local_60 = _e2102;
                                    local_61 = _e2102;
                                    local_62 = _e2104;
                                    local_63 = _e2104;
                                    local_64 = _e2104;
                                    local_65 = _e2104;
                                    local_66 = _e2104;
                                    local_67 = _e2104;
                                    local_68 = _e2104;
                                    local_69 = _e2104;
                                    local_70 = _e2104;
                                    local_71 = _e2104;
                                    local_72 = _e2104;
                                    local_73 = _e2104;
                                    local_74 = _e2104;
                                    local_75 = _e2104;
                                    local_76 = _e2104;
                                    local_77 = _e2104;
                                    local_78 = _e2104;
                                    local_79 = _e2104;
                                    if (_e2100.member < _e2100.member_1) {
                                        phi_9586_ = type_11((_e2100.member + 1u), _e2100.member_1);
                                        phi_9613_ = type_11(1u, _e2100.member);
                                    } else {
                                        phi_9586_ = _e2100;
                                        phi_9613_ = type_11(0u, type_11().member_1);
                                    }
                                    let _e2117 = phi_9586_;
                                    let _e2119 = phi_9613_;
                                    let _e2123 = (bitcast<i32>(_e2119.member) != 0i);
                                    if _e2123 {
                                        let _e2125 = ((_e2119.member_1 & 1u) == 1u);
                                        let _e2127 = ((_e2119.member_1 & 2u) == 2u);
                                        let _e2129 = ((_e2119.member_1 & 4u) == 4u);
                                        if _e2125 {
                                            phi_9643_ = _e2032;
                                        } else {
                                            phi_9643_ = (1f - _e2032);
                                        }
                                        let _e2135 = phi_9643_;
                                        if _e2127 {
                                            phi_9648_ = _e2062;
                                        } else {
                                            phi_9648_ = (1f - _e2062);
                                        }
                                        let _e2138 = phi_9648_;
                                        if _e2129 {
                                            phi_9654_ = _e2092;
                                        } else {
                                            phi_9654_ = (1f - _e2092);
                                        }
                                        let _e2142 = phi_9654_;
                                        let _e2152 = (((((select((f32((_e2024 + _e1924.x)) + 0.5f), (f32((_e2029 + _e1924.x)) + 0.5f), _e2125) - _e1950) * _e74.member_2[0]) + ((select((f32((_e2054 + _e1924.y)) + 0.5f), (f32((_e2059 + _e1924.y)) + 0.5f), _e2127) - _e1951) * _e74.member_2[1])) + ((select((f32((_e2084 + _e1924.z)) + 0.5f), (f32((_e2089 + _e1924.z)) + 0.5f), _e2129) - _e1952) * _e74.member_2[2])) * 2f);
                                        let _e2154 = select(0f, _e2152, (_e2152 > 0f));
                                        let _e2157 = (((_e2135 * _e2138) * _e2142) * select(1f, _e2154, (_e2154 < 1f)));
                                        if (_e2157 > 0f) {
                                            let _e2166 = (((_e1999 + select(bitcast<u32>(_e2024), bitcast<u32>(_e2029), _e2125)) + (select(bitcast<u32>(_e2054), bitcast<u32>(_e2059), _e2127) * _e1996)) + (select(bitcast<u32>(_e2084), bitcast<u32>(_e2089), _e2129) * _e1998));
                                            if (_e2166 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2171 = d.member[_e2166];
                                            let _e2176 = (3u * _e2002);
                                            let _e2177 = (_e2176 + _e2166);
                                            if (_e2177 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2181 = d.member[_e2177];
                                            let _e2186 = (_e2002 * 6u);
                                            let _e2187 = (_e2186 + _e2166);
                                            if (_e2187 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2191 = d.member[_e2187];
                                            let _e2196 = (_e2002 * 9u);
                                            let _e2197 = (_e2196 + _e2166);
                                            if (_e2197 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2201 = d.member[_e2197];
                                            let _e2206 = (_e2002 * 12u);
                                            let _e2207 = (_e2206 + _e2166);
                                            if (_e2207 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2211 = d.member[_e2207];
                                            let _e2216 = (_e2002 * 15u);
                                            let _e2217 = (_e2216 + _e2166);
                                            if (_e2217 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2221 = d.member[_e2217];
                                            let _e2227 = (_e2002 + _e2166);
                                            if (_e2227 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2231 = d.member[_e2227];
                                            let _e2236 = (_e2176 + _e2227);
                                            if (_e2236 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2240 = d.member[_e2236];
                                            let _e2245 = (_e2186 + _e2227);
                                            if (_e2245 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2249 = d.member[_e2245];
                                            let _e2254 = (_e2196 + _e2227);
                                            if (_e2254 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2258 = d.member[_e2254];
                                            let _e2263 = (_e2206 + _e2227);
                                            if (_e2263 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2267 = d.member[_e2263];
                                            let _e2272 = (_e2216 + _e2227);
                                            if (_e2272 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2276 = d.member[_e2272];
                                            let _e2283 = ((2u * _e2002) + _e2166);
                                            if (_e2283 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2287 = d.member[_e2283];
                                            let _e2292 = (_e2176 + _e2283);
                                            if (_e2292 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2296 = d.member[_e2292];
                                            let _e2301 = (_e2186 + _e2283);
                                            if (_e2301 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2305 = d.member[_e2301];
                                            let _e2310 = (_e2196 + _e2283);
                                            if (_e2310 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2314 = d.member[_e2310];
                                            let _e2319 = (_e2206 + _e2283);
                                            if (_e2319 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2323 = d.member[_e2319];
                                            let _e2328 = (_e2216 + _e2283);
                                            if (_e2328 < _e61) {
                                            } else {
                                                phi_12893_ = true;
                                                break;
                                            }
                                            let _e2332 = d.member[_e2328];
                                            phi_9986_ = (_e2102 + _e2157);
                                            phi_9987_ = array<array<f32, 6>, 3>(array<f32, 6>((_e2104[0][0] + (_e2171 * _e2157)), (_e2104[0][1] + (_e2181 * _e2157)), (_e2104[0][2] + (_e2191 * _e2157)), (_e2104[0][3] + (_e2201 * _e2157)), (_e2104[0][4] + (_e2211 * _e2157)), (_e2104[0][5] + (_e2221 * _e2157))), array<f32, 6>((_e2104[1][0] + (_e2231 * _e2157)), (_e2104[1][1] + (_e2240 * _e2157)), (_e2104[1][2] + (_e2249 * _e2157)), (_e2104[1][3] + (_e2258 * _e2157)), (_e2104[1][4] + (_e2267 * _e2157)), (_e2104[1][5] + (_e2276 * _e2157))), array<f32, 6>((_e2104[2][0] + (_e2287 * _e2157)), (_e2104[2][1] + (_e2296 * _e2157)), (_e2104[2][2] + (_e2305 * _e2157)), (_e2104[2][3] + (_e2314 * _e2157)), (_e2104[2][4] + (_e2323 * _e2157)), (_e2104[2][5] + (_e2332 * _e2157))));
                                        } else {
                                            phi_9986_ = _e2102;
                                            phi_9987_ = _e2104;
                                        }
                                        let _e2340 = phi_9986_;
                                        let _e2342 = phi_9987_;
                                        phi_9589_ = _e2340;
                                        phi_9591_ = _e2342;
                                    } else {
                                        phi_9589_ = f32();
                                        phi_9591_ = array<array<f32, 6>, 3>();
                                    }
                                    let _e2344 = phi_9589_;
                                    let _e2346 = phi_9591_;
                                    continue;
                                    continuing {
                                        phi_9585_ = _e2117;
                                        phi_9588_ = _e2344;
                                        phi_9590_ = _e2346;
                                        phi_12893_ = _e1907;
                                        break if !(_e2123);
                                    }
                                }
                                let _e2349 = phi_12893_;
                                if _e2349 {
                                    break;
                                }
                                let _e2351 = local_60;
                                if (_e2351 > 0f) {
                                    let _e2354 = local_61;
                                    phi_9993_ = (1f / _e2354);
                                } else {
                                    phi_9993_ = 0f;
                                }
                                let _e2357 = phi_9993_;
                                let _e2359 = local_62;
                                let _e2364 = local_63;
                                let _e2369 = local_64;
                                let _e2374 = local_65;
                                let _e2379 = local_66;
                                let _e2384 = local_67;
                                let _e2389 = local_68;
                                let _e2394 = local_69;
                                let _e2399 = local_70;
                                let _e2404 = local_71;
                                let _e2409 = local_72;
                                let _e2414 = local_73;
                                let _e2419 = local_74;
                                let _e2424 = local_75;
                                let _e2429 = local_76;
                                let _e2434 = local_77;
                                let _e2439 = local_78;
                                let _e2444 = local_79;
                                let _e2449 = ((0.6666667f / _e1920.w) / _e1920.w);
                                let _e2450 = -(_e74.member_2[0]);
                                let _e2451 = -(_e74.member_2[1]);
                                let _e2454 = (_e74.member_2[2] * -1.0233268f);
                                let _e2460 = ((((_e74.member_2[2] * -1.9364917f) * (_e74.member_2[2] * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                                let _e2463 = (_e74.member_2[0] * -1.0233268f);
                                let _e2466 = (_e74.member_2[1] * -1.0233268f);
                                let _e2472 = (((_e2450 * _e2450) - (_e2451 * _e2451)) * 0.4290428f);
                                let _e2474 = (((((((_e2359[0][0] * _e2357) * 0.886227f) + ((_e2369[0][2] * _e2357) * _e2454)) + ((_e2379[0][4] * _e2357) * _e2460)) + ((_e2374[0][3] * _e2357) * _e2463)) + ((_e2364[0][1] * _e2357) * _e2466)) + ((_e2384[0][5] * _e2357) * _e2472));
                                let _e2487 = (((((((_e2389[1][0] * _e2357) * 0.886227f) + ((_e2399[1][2] * _e2357) * _e2454)) + ((_e2409[1][4] * _e2357) * _e2460)) + ((_e2404[1][3] * _e2357) * _e2463)) + ((_e2394[1][1] * _e2357) * _e2466)) + ((_e2414[1][5] * _e2357) * _e2472));
                                let _e2500 = (((((((_e2419[2][0] * _e2357) * 0.886227f) + ((_e2429[2][2] * _e2357) * _e2454)) + ((_e2439[2][4] * _e2357) * _e2460)) + ((_e2434[2][3] * _e2357) * _e2463)) + ((_e2424[2][1] * _e2357) * _e2466)) + ((_e2444[2][5] * _e2357) * _e2472));
                                phi_12281_ = vec4<f32>((_e1913.x + ((select(0f, _e2474, (_e2474 > 0f)) * _e2449) * _e1988)), (_e1913.y + ((select(0f, _e2487, (_e2487 > 0f)) * _e2449) * _e1988)), (_e1913.z + ((select(0f, _e2500, (_e2500 > 0f)) * _e2449) * _e1988)), f32());
                            }
                            let _e2514 = phi_12281_;
                            phi_12282_ = _e2514;
                        }
                        let _e2516 = phi_12282_;
                        phi_12283_ = _e2516;
                        phi_12284_ = _e1916;
                    }
                    let _e2518 = phi_12283_;
                    let _e2520 = phi_12284_;
                    let _e2522 = select(_e2518, _e1913, vec4(_e2520));
                    phi_12293_ = vec4<f32>(_e2522.x, _e2522.y, _e2522.z, 0f);
                }
                let _e2528 = phi_12293_;
                if _e70 {
                } else {
                    break;
                }
                irradiance.member[_e69] = _e2528;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_gather(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
