struct type_4 {
    member: u32,
    member_1: u32,
    member_2: f32,
    member_3: u32,
}

struct type_5 {
    member: type_4,
}

struct type_8 {
    member: array<f32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_5;
@group(0) @binding(1) 
var<storage> x: type_8;
@group(0) @binding(2) 
var<storage, read_write> out: type_8;

fn function_() {
    var phi_70_: u32;
    var phi_141_: type_15;
    var phi_144_: array<f32, 12>;
    var phi_142_: type_15;
    var phi_167_: type_15;
    var phi_145_: array<f32, 12>;
    var local: array<f32, 12>;
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

    let _e26 = gid_1;
    let _e29 = params.member.member;
    let _e30 = (_e29 / 256u);
    if ((_e29 % 256u) > 0u) {
        phi_70_ = (_e30 + 1u);
    } else {
        phi_70_ = _e30;
    }
    let _e35 = phi_70_;
    let _e39 = (_e26.x + (_e26.y * 2097152u));
    if (_e39 < (_e35 * 256u)) {
        let _e44 = x.member[_e39];
        let _e47 = params.member.member_2;
        phi_141_ = type_15(0u, 64u);
        phi_144_ = array<f32, 12>(0f, _e44, (_e44 * 2f), (_e44 * 3f), (_e44 * 4f), (_e44 * 5f), (_e44 * 6f), (_e44 * 7f), (_e44 * 8f), (_e44 * 9f), (_e44 * 10f), (_e44 * 11f));
        loop {
            let _e60 = phi_141_;
            let _e62 = phi_144_;
            local = _e62;
            local_1 = _e62;
            local_2 = _e62;
            local_3 = _e62;
            local_4 = _e62;
            local_5 = _e62;
            local_6 = _e62;
            local_7 = _e62;
            local_8 = _e62;
            local_9 = _e62;
            local_10 = _e62;
            local_11 = _e62;
            if (_e60.member < _e60.member_1) {
                phi_142_ = type_15((_e60.member + 1u), _e60.member_1);
                phi_167_ = type_15(1u, _e60.member);
            } else {
                phi_142_ = _e60;
                phi_167_ = type_15(0u, type_15().member_1);
            }
            let _e75 = phi_142_;
            let _e77 = phi_167_;
            let _e80 = (bitcast<i32>(_e77.member) != 0i);
            if _e80 {
                phi_145_ = array<f32, 12>(((_e62[0] * _e47) + _e44), ((_e62[1] * _e47) + _e44), ((_e62[2] * _e47) + _e44), ((_e62[3] * _e47) + _e44), ((_e62[4] * _e47) + _e44), ((_e62[5] * _e47) + _e44), ((_e62[6] * _e47) + _e44), ((_e62[7] * _e47) + _e44), ((_e62[8] * _e47) + _e44), ((_e62[9] * _e47) + _e44), ((_e62[10] * _e47) + _e44), ((_e62[11] * _e47) + _e44));
            } else {
                phi_145_ = array<f32, 12>();
            }
            let _e119 = phi_145_;
            continue;
            continuing {
                phi_141_ = _e75;
                phi_144_ = _e119;
                break if !(_e80);
            }
        }
        let _e122 = local;
        let _e125 = local_1;
        let _e129 = local_2;
        let _e133 = local_3;
        let _e137 = local_4;
        let _e141 = local_5;
        let _e145 = local_6;
        let _e149 = local_7;
        let _e153 = local_8;
        let _e157 = local_9;
        let _e161 = local_10;
        let _e165 = local_11;
        out.member[_e39] = (((((((((((_e122[0] + _e125[1]) + _e129[2]) + _e133[3]) + _e137[4]) + _e141[5]) + _e145[6]) + _e149[7]) + _e153[8]) + _e157[9]) + _e161[10]) + _e165[11]);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn smoke_madd(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
