struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_16 {
    member: type_15,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_16;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(3) 
var<storage, read_write> coefs: type_5;
@group(0) @binding(1) 
var<storage> table: type_5;

fn function_() {
    var local: array<f32, 12>;
    var phi_80_: u32;
    var phi_99_: u32;
    var phi_163_: u32;
    var phi_188_: type_12;
    var phi_191_: array<f32, 12>;
    var phi_189_: type_12;
    var phi_214_: type_12;
    var phi_192_: array<f32, 12>;
    var phi_445_: bool;
    var local_1: array<f32, 12>;
    var local_2: array<f32, 12>;
    var local_3: array<f32, 12>;
    var local_4: array<f32, 12>;
    var local_5: array<f32, 12>;
    var local_6: array<f32, 12>;
    var local_7: array<f32, 12>;
    var local_8: array<f32, 12>;
    var local_9: array<f32, 12>;
    var local_10: array<f32, 12>;
    var local_11: array<f32, 12>;
    var local_12: array<f32, 12>;
    var phi_389_: type_12;
    var phi_390_: type_12;
    var phi_413_: type_12;
    var phi_454_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = gid_1;
            let _e28 = arrayLength((&table.member));
            let _e30 = arrayLength((&radiance.member));
            let _e35 = params.member.member;
            let _e38 = params.member.member_2;
            let _e41 = (_e35 / 64u);
            if ((_e35 % 64u) > 0u) {
                phi_80_ = (_e41 + 1u);
            } else {
                phi_80_ = _e41;
            }
            let _e46 = phi_80_;
            let _e47 = (select(_e38, 9u, (_e38 > 9u)) + 1u);
            let _e48 = (_e47 * _e47);
            let _e49 = (_e48 / 4u);
            let _e51 = ((_e48 % 4u) > 0u);
            if _e51 {
                phi_99_ = (_e49 + 1u);
            } else {
                phi_99_ = _e49;
            }
            let _e54 = phi_99_;
            let _e56 = ((_e46 * _e54) * 64u);
            let _e60 = (_e26.x + (_e26.y * 2097152u));
            if (_e60 < _e56) {
                let _e62 = (_e60 / 64u);
                if _e51 {
                    phi_163_ = (_e49 + 1u);
                } else {
                    phi_163_ = _e49;
                }
                let _e67 = phi_163_;
                if (_e67 == 0u) {
                    break;
                }
                let _e69 = (_e62 / _e67);
                let _e74 = params.member.member_1;
                let _e75 = (_e69 * 64u);
                let _e82 = ((_e62 - (_e69 * _e67)) * _e74);
                let _e83 = (_e67 * _e74);
                phi_188_ = type_12(0u, _e74);
                phi_191_ = array<f32, 12>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                loop {
                    let _e86 = phi_188_;
                    let _e88 = phi_191_;
                    local_1 = _e88;
                    local_2 = _e88;
                    local_3 = _e88;
                    local_4 = _e88;
                    local_5 = _e88;
                    local_6 = _e88;
                    local_7 = _e88;
                    local_8 = _e88;
                    local_9 = _e88;
                    local_10 = _e88;
                    local_11 = _e88;
                    local_12 = _e88;
                    if (_e86.member < _e86.member_1) {
                        phi_189_ = type_12((_e86.member + 1u), _e86.member_1);
                        phi_214_ = type_12(1u, _e86.member);
                    } else {
                        phi_189_ = _e86;
                        phi_214_ = type_12(0u, type_12().member_1);
                    }
                    let _e101 = phi_189_;
                    let _e103 = phi_214_;
                    let _e107 = (bitcast<i32>(_e103.member) != 0i);
                    if _e107 {
                        let _e109 = ((((((_e75 / 64u) * _e74) * 192u) + (_e75 % 64u)) + (_e60 - (_e62 * 64u))) + (_e103.member_1 * 192u));
                        if (_e109 < _e30) {
                        } else {
                            phi_445_ = true;
                            break;
                        }
                        let _e113 = radiance.member[_e109];
                        let _e114 = (_e109 + 64u);
                        if (_e114 < _e30) {
                        } else {
                            phi_445_ = true;
                            break;
                        }
                        let _e118 = radiance.member[_e114];
                        let _e119 = (_e109 + 128u);
                        if (_e119 < _e30) {
                        } else {
                            phi_445_ = true;
                            break;
                        }
                        let _e123 = radiance.member[_e119];
                        let _e124 = (_e82 + _e103.member_1);
                        if (_e124 < _e28) {
                        } else {
                            phi_445_ = true;
                            break;
                        }
                        let _e128 = table.member[_e124];
                        let _e139 = ((_e83 + _e82) + _e103.member_1);
                        if (_e139 < _e28) {
                        } else {
                            phi_445_ = true;
                            break;
                        }
                        let _e143 = table.member[_e139];
                        let _e155 = (((2u * _e83) + _e82) + _e103.member_1);
                        if (_e155 < _e28) {
                        } else {
                            phi_445_ = true;
                            break;
                        }
                        let _e159 = table.member[_e155];
                        let _e171 = (((3u * _e83) + _e82) + _e103.member_1);
                        if (_e171 < _e28) {
                        } else {
                            phi_445_ = true;
                            break;
                        }
                        let _e175 = table.member[_e171];
                        phi_192_ = array<f32, 12>((_e88[0] + (_e113 * _e128)), (_e88[1] + (_e113 * _e143)), (_e88[2] + (_e113 * _e159)), (_e88[3] + (_e113 * _e175)), (_e88[4] + (_e118 * _e128)), (_e88[5] + (_e118 * _e143)), (_e88[6] + (_e118 * _e159)), (_e88[7] + (_e118 * _e175)), (_e88[8] + (_e123 * _e128)), (_e88[9] + (_e123 * _e143)), (_e88[10] + (_e123 * _e159)), (_e88[11] + (_e123 * _e175)));
                    } else {
                        phi_192_ = array<f32, 12>();
                    }
                    let _e187 = phi_192_;
                    continue;
                    continuing {
                        phi_188_ = _e101;
                        phi_191_ = _e187;
                        phi_445_ = false;
                        break if !(_e107);
                    }
                }
                let _e190 = phi_445_;
                if _e190 {
                    break;
                }
                let _e193 = params.member.member_3;
                let _e195 = local_1;
                let _e199 = local_2;
                let _e203 = local_3;
                let _e207 = local_4;
                let _e211 = local_5;
                let _e215 = local_6;
                let _e219 = local_7;
                let _e223 = local_8;
                let _e227 = local_9;
                let _e231 = local_10;
                let _e235 = local_11;
                let _e239 = local_12;
                local = array<f32, 12>((_e195[0] * _e193), (_e199[1] * _e193), (_e203[2] * _e193), (_e207[3] * _e193), (_e211[4] * _e193), (_e215[5] * _e193), (_e219[6] * _e193), (_e223[7] * _e193), (_e227[8] * _e193), (_e231[9] * _e193), (_e235[10] * _e193), (_e239[11] * _e193));
                phi_389_ = type_12(0u, 12u);
                loop {
                    let _e244 = phi_389_;
                    if (_e244.member < _e244.member_1) {
                        phi_390_ = type_12((_e244.member + 1u), _e244.member_1);
                        phi_413_ = type_12(1u, _e244.member);
                    } else {
                        phi_390_ = _e244;
                        phi_413_ = type_12(0u, type_12().member_1);
                    }
                    let _e257 = phi_390_;
                    let _e259 = phi_413_;
                    let _e263 = (bitcast<i32>(_e259.member) != 0i);
                    if _e263 {
                        if (_e259.member_1 < 12u) {
                        } else {
                            phi_454_ = true;
                            break;
                        }
                        let _e266 = local[_e259.member_1];
                        let _e268 = ((_e259.member_1 * _e56) + _e60);
                        if (_e268 < arrayLength((&coefs.member))) {
                        } else {
                            phi_454_ = true;
                            break;
                        }
                        coefs.member[_e268] = _e266;
                    }
                    continue;
                    continuing {
                        phi_389_ = _e257;
                        phi_454_ = _e190;
                        break if !(_e263);
                    }
                }
                let _e274 = phi_454_;
                if _e274 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_project(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
