struct type_7 {
    member: array<u32>,
}

struct type_15 {
    member: array<vec4<f32>>,
}

struct type_18 {
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

struct type_19 {
    member: type_18,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> out: type_15;
@group(0) @binding(1) 
var<storage> cells: type_7;
@group(0) @binding(0) 
var<uniform> params: type_19;
@group(0) @binding(2) 
var<storage> children: type_7;
@group(0) @binding(3) 
var<storage> finer: type_15;

fn function_() {
    var phi_106_: vec4<f32>;
    var phi_131_: vec4<f32>;
    var phi_149_: vec4<f32>;
    var phi_167_: vec4<f32>;
    var phi_185_: vec4<f32>;
    var phi_203_: vec4<f32>;
    var phi_221_: vec4<f32>;
    var phi_239_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = gid_1;
            let _e31 = params.member.member_12;
            let _e34 = params.member.member_13;
            let _e38 = (_e26.x + (_e26.y * 2097152u));
            if (_e38 < _e34) {
                let _e40 = (_e31 + _e38);
                let _e43 = children.member[_e40];
                let _e46 = (2u * (_e43 >> bitcast<u32>(2i)));
                let _e51 = cells.member[_e46];
                let _e52 = ((8u * (_e43 & 3u)) & 31u);
                let _e54 = (_e51 >> bitcast<u32>(_e52));
                let _e58 = cells.member[(_e46 + 1u)];
                let _e64 = (_e58 + countOneBits((_e51 & ((1u << bitcast<u32>(_e52)) - 1u))));
                let _e65 = (_e54 & 1u);
                if (_e65 == 1u) {
                    let _e69 = finer.member[_e64];
                    phi_106_ = _e69;
                } else {
                    phi_106_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e71 = phi_106_;
                let _e76 = (_e64 + _e65);
                let _e79 = ((_e54 >> bitcast<u32>(1u)) & 1u);
                if (_e79 == 1u) {
                    let _e83 = finer.member[_e76];
                    phi_131_ = _e83;
                } else {
                    phi_131_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e85 = phi_131_;
                let _e94 = (_e76 + _e79);
                let _e97 = ((_e54 >> bitcast<u32>(2u)) & 1u);
                if (_e97 == 1u) {
                    let _e101 = finer.member[_e94];
                    phi_149_ = _e101;
                } else {
                    phi_149_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e103 = phi_149_;
                let _e112 = (_e94 + _e97);
                let _e115 = ((_e54 >> bitcast<u32>(3u)) & 1u);
                if (_e115 == 1u) {
                    let _e119 = finer.member[_e112];
                    phi_167_ = _e119;
                } else {
                    phi_167_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e121 = phi_167_;
                let _e130 = (_e112 + _e115);
                let _e133 = ((_e54 >> bitcast<u32>(4u)) & 1u);
                if (_e133 == 1u) {
                    let _e137 = finer.member[_e130];
                    phi_185_ = _e137;
                } else {
                    phi_185_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e139 = phi_185_;
                let _e148 = (_e130 + _e133);
                let _e151 = ((_e54 >> bitcast<u32>(5u)) & 1u);
                if (_e151 == 1u) {
                    let _e155 = finer.member[_e148];
                    phi_203_ = _e155;
                } else {
                    phi_203_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e157 = phi_203_;
                let _e166 = (_e148 + _e151);
                let _e169 = ((_e54 >> bitcast<u32>(6u)) & 1u);
                if (_e169 == 1u) {
                    let _e173 = finer.member[_e166];
                    phi_221_ = _e173;
                } else {
                    phi_221_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e175 = phi_221_;
                if (((_e54 >> bitcast<u32>(7u)) & 1u) == 1u) {
                    let _e191 = finer.member[(_e166 + _e169)];
                    phi_239_ = _e191;
                } else {
                    phi_239_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e193 = phi_239_;
                let _e205 = ((((((((_e71.w + _e85.w) + _e103.w) + _e121.w) + _e139.w) + _e157.w) + _e175.w) + _e193.w) * 0.25f);
                let _e208 = (1f / select(1f, _e205, (_e205 > 1f)));
                let _e216 = (_e40 + (_e38 - _e38));
                if (_e216 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e216] = vec4<f32>((((((((((_e71.x + _e85.x) + _e103.x) + _e121.x) + _e139.x) + _e157.x) + _e175.x) + _e193.x) * 0.25f) * _e208), (((((((((_e71.y + _e85.y) + _e103.y) + _e121.y) + _e139.y) + _e157.y) + _e175.y) + _e193.y) * 0.25f) * _e208), (((((((((_e71.z + _e85.z) + _e103.z) + _e121.z) + _e139.z) + _e157.z) + _e175.z) + _e193.z) * 0.25f) * _e208), select(1f, _e205, (_e205 < 1f)));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_mip_isotropic(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
