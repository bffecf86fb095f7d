struct type_6 {
    member: array<u32>,
}

struct type_13 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_22 {
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

struct type_23 {
    member: type_22,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_6;
@group(0) @binding(0) 
var<uniform> params: type_23;
@group(0) @binding(1) 
var<storage> triangles: type_15;

fn function_() {
    var phi_159_: bool;
    var phi_168_: u32;
    var phi_188_: vec3<f32>;
    var phi_189_: vec3<f32>;
    var phi_200_: vec3<f32>;
    var phi_201_: vec3<f32>;
    var phi_212_: vec3<f32>;
    var phi_213_: vec3<f32>;
    var phi_224_: vec3<f32>;
    var phi_225_: vec3<f32>;
    var phi_356_: u32;
    var phi_365_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = gid_1;
            let _e30 = (_e22.x + (_e22.y * 2097152u));
            let _e31 = (_e30 < arrayLength((&out.member)));
            if _e31 {
                if (_e30 < arrayLength((&triangles.member))) {
                } else {
                    break;
                }
                let _e36 = triangles.member[_e30].member;
                let _e42 = params.member.member;
                let _e50 = ((_e36[0] - _e42.x) / _e42.w);
                let _e51 = ((_e36[1] - _e42.y) / _e42.w);
                let _e52 = ((_e36[2] - _e42.z) / _e42.w);
                let _e57 = triangles.member[_e30].member_2;
                let _e64 = ((_e57[0] - _e42.x) / _e42.w);
                let _e65 = ((_e57[1] - _e42.y) / _e42.w);
                let _e66 = ((_e57[2] - _e42.z) / _e42.w);
                let _e71 = triangles.member[_e30].member_4;
                let _e78 = ((_e71[0] - _e42.x) / _e42.w);
                let _e79 = ((_e71[1] - _e42.y) / _e42.w);
                let _e80 = ((_e71[2] - _e42.z) / _e42.w);
                let _e82 = (_e64 - _e50);
                let _e83 = (_e65 - _e51);
                let _e84 = (_e66 - _e52);
                let _e85 = (_e78 - _e50);
                let _e86 = (_e79 - _e51);
                let _e87 = (_e80 - _e52);
                let _e97 = abs(((_e83 * _e87) - (_e86 * _e84)));
                let _e98 = abs(((_e84 * _e85) - (_e87 * _e82)));
                let _e99 = abs(((_e82 * _e86) - (_e85 * _e83)));
                if (_e97 >= _e98) {
                    phi_159_ = select(true, false, (_e97 >= _e99));
                } else {
                    phi_159_ = true;
                }
                let _e104 = phi_159_;
                if _e104 {
                    phi_168_ = select(2u, 1u, (_e98 >= _e99));
                } else {
                    phi_168_ = 0u;
                }
                let _e108 = phi_168_;
                let _e111 = params.member.member_1;
                let _e113 = f32(_e111.x);
                let _e115 = f32(_e111.y);
                let _e117 = f32(_e111.z);
                let _e119 = (_e108 == 0u);
                if _e119 {
                    phi_189_ = vec3<f32>(_e115, _e117, _e113);
                } else {
                    if (_e108 == 1u) {
                        phi_188_ = vec3<f32>(_e117, _e113, _e115);
                    } else {
                        phi_188_ = vec3<f32>(_e113, _e115, _e117);
                    }
                    let _e123 = phi_188_;
                    phi_189_ = _e123;
                }
                let _e126 = phi_189_;
                if _e119 {
                    phi_201_ = vec3<f32>(_e51, _e52, _e50);
                } else {
                    if (_e108 == 1u) {
                        phi_200_ = vec3<f32>(_e52, _e50, _e51);
                    } else {
                        phi_200_ = vec3<f32>(_e50, _e51, _e52);
                    }
                    let _e130 = phi_200_;
                    phi_201_ = _e130;
                }
                let _e133 = phi_201_;
                if _e119 {
                    phi_213_ = vec3<f32>(_e65, _e66, _e64);
                } else {
                    if (_e108 == 1u) {
                        phi_212_ = vec3<f32>(_e66, _e64, _e65);
                    } else {
                        phi_212_ = vec3<f32>(_e64, _e65, _e66);
                    }
                    let _e137 = phi_212_;
                    phi_213_ = _e137;
                }
                let _e140 = phi_213_;
                if _e119 {
                    phi_225_ = vec3<f32>(_e79, _e80, _e78);
                } else {
                    if (_e108 == 1u) {
                        phi_224_ = vec3<f32>(_e80, _e78, _e79);
                    } else {
                        phi_224_ = vec3<f32>(_e78, _e79, _e80);
                    }
                    let _e144 = phi_224_;
                    phi_225_ = _e144;
                }
                let _e147 = phi_225_;
                let _e151 = select(_e140.x, _e133.x, (_e133.x < _e140.x));
                let _e156 = select(_e140.x, _e133.x, (_e133.x > _e140.x));
                let _e162 = (-1f - floor(-(select(_e147.x, _e151, (_e151 < _e147.x)))));
                let _e163 = floor(select(_e147.x, _e156, (_e156 > _e147.x)));
                let _e164 = (_e126.x - 1f);
                let _e166 = select(0f, _e162, (_e162 > 0f));
                let _e168 = select(_e164, _e163, (_e163 < _e164));
                let _e175 = select(0i, select(select(i32(_e166), i32(-2147483648), (_e166 < -2147483600f)), 2147483647i, (_e166 > 2147483500f)), (_e166 == _e166));
                let _e182 = select(0i, select(select(i32(_e168), i32(-2147483648), (_e168 < -2147483600f)), 2147483647i, (_e168 > 2147483500f)), (_e168 == _e168));
                let _e186 = select(_e140.y, _e133.y, (_e133.y < _e140.y));
                let _e191 = select(_e140.y, _e133.y, (_e133.y > _e140.y));
                let _e197 = (-1f - floor(-(select(_e147.y, _e186, (_e186 < _e147.y)))));
                let _e198 = floor(select(_e147.y, _e191, (_e191 > _e147.y)));
                let _e199 = (_e126.y - 1f);
                let _e201 = select(0f, _e197, (_e197 > 0f));
                let _e203 = select(_e199, _e198, (_e198 < _e199));
                let _e210 = select(0i, select(select(i32(_e201), i32(-2147483648), (_e201 < -2147483600f)), 2147483647i, (_e201 > 2147483500f)), (_e201 == _e201));
                let _e217 = select(0i, select(select(i32(_e203), i32(-2147483648), (_e203 < -2147483600f)), 2147483647i, (_e203 > 2147483500f)), (_e203 == _e203));
                if (_e217 < _e210) {
                    phi_356_ = 0u;
                } else {
                    phi_356_ = ((bitcast<u32>((_e217 - _e210)) / 4u) + 1u);
                }
                let _e224 = phi_356_;
                if (_e182 < _e175) {
                    phi_365_ = 0u;
                } else {
                    phi_365_ = ((bitcast<u32>((_e182 - _e175)) / 4u) + 1u);
                }
                let _e231 = phi_365_;
                if _e31 {
                } else {
                    break;
                }
                out.member[_e30] = (_e231 * _e224);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_tiles(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
