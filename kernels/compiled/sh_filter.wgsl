struct type_5 {
    member: array<f32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<vec4<f32>, 3>,
}

struct type_14 {
    member: type_13,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_5;
@group(0) @binding(1) 
var<storage> coefs: type_5;
@group(0) @binding(0) 
var<uniform> params: type_14;

fn function_() {
    var phi_76_: u32;
    var phi_95_: u32;
    var phi_143_: u32;
    var phi_162_: u32;
    var phi_193_: f32;
    var phi_210_: f32;
    var phi_227_: f32;
    var phi_248_: f32;
    var phi_269_: f32;
    var phi_290_: f32;
    var phi_311_: f32;
    var phi_332_: f32;
    var phi_353_: f32;
    var phi_390_: f32;
    var phi_407_: f32;
    var phi_424_: f32;
    var phi_445_: f32;
    var phi_466_: f32;
    var phi_487_: f32;
    var phi_508_: f32;
    var phi_529_: f32;
    var phi_550_: f32;
    var phi_587_: f32;
    var phi_604_: f32;
    var phi_621_: f32;
    var phi_642_: f32;
    var phi_663_: f32;
    var phi_684_: f32;
    var phi_705_: f32;
    var phi_726_: f32;
    var phi_747_: f32;
    var phi_784_: f32;
    var phi_801_: f32;
    var phi_818_: f32;
    var phi_839_: f32;
    var phi_860_: f32;
    var phi_881_: f32;
    var phi_902_: f32;
    var phi_923_: f32;
    var phi_944_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = gid_1;
            let _e31 = params.member.member;
            let _e34 = params.member.member_1;
            let _e37 = (_e31 / 64u);
            let _e39 = ((_e31 % 64u) > 0u);
            if _e39 {
                phi_76_ = (_e37 + 1u);
            } else {
                phi_76_ = _e37;
            }
            let _e42 = phi_76_;
            let _e43 = (select(_e34, 9u, (_e34 > 9u)) + 1u);
            let _e44 = (_e43 * _e43);
            let _e45 = (_e44 / 4u);
            let _e47 = ((_e44 % 4u) > 0u);
            if _e47 {
                phi_95_ = (_e45 + 1u);
            } else {
                phi_95_ = _e45;
            }
            let _e50 = phi_95_;
            let _e51 = (_e42 * _e50);
            let _e52 = (_e51 * 64u);
            let _e56 = (_e28.x + (_e28.y * 2097152u));
            if (_e56 < _e52) {
                let _e58 = (_e56 / 64u);
                if _e39 {
                    phi_143_ = (_e37 + 1u);
                } else {
                    phi_143_ = _e37;
                }
                let _e61 = phi_143_;
                if _e47 {
                    phi_162_ = (_e45 + 1u);
                } else {
                    phi_162_ = _e45;
                }
                let _e64 = phi_162_;
                if (_e64 == 0u) {
                    break;
                }
                let _e69 = (_e61 * _e64);
                let _e71 = ((_e58 - ((_e58 / _e64) * _e64)) * 4u);
                let _e76 = params.member.member_4[0u][0u];
                if (_e71 >= 1u) {
                    let _e82 = params.member.member_4[0u][1u];
                    phi_193_ = _e82;
                } else {
                    phi_193_ = _e76;
                }
                let _e84 = phi_193_;
                if (_e71 >= 4u) {
                    let _e90 = params.member.member_4[0u][2u];
                    phi_210_ = _e90;
                } else {
                    phi_210_ = _e84;
                }
                let _e92 = phi_210_;
                if (_e71 >= 9u) {
                    let _e98 = params.member.member_4[0u][3u];
                    phi_227_ = _e98;
                } else {
                    phi_227_ = _e92;
                }
                let _e100 = phi_227_;
                if (_e71 >= 16u) {
                    let _e106 = params.member.member_4[1u][0u];
                    phi_248_ = _e106;
                } else {
                    phi_248_ = _e100;
                }
                let _e108 = phi_248_;
                if (_e71 >= 25u) {
                    let _e114 = params.member.member_4[1u][1u];
                    phi_269_ = _e114;
                } else {
                    phi_269_ = _e108;
                }
                let _e116 = phi_269_;
                if (_e71 >= 36u) {
                    let _e122 = params.member.member_4[1u][2u];
                    phi_290_ = _e122;
                } else {
                    phi_290_ = _e116;
                }
                let _e124 = phi_290_;
                if (_e71 >= 49u) {
                    let _e130 = params.member.member_4[1u][3u];
                    phi_311_ = _e130;
                } else {
                    phi_311_ = _e124;
                }
                let _e132 = phi_311_;
                if (_e71 >= 64u) {
                    let _e138 = params.member.member_4[2u][0u];
                    phi_332_ = _e138;
                } else {
                    phi_332_ = _e132;
                }
                let _e140 = phi_332_;
                if (_e71 >= 81u) {
                    let _e146 = params.member.member_4[2u][1u];
                    phi_353_ = _e146;
                } else {
                    phi_353_ = _e140;
                }
                let _e148 = phi_353_;
                let _e151 = coefs.member[_e56];
                let _e157 = coefs.member[((_e69 * 256u) + _e56)];
                let _e163 = coefs.member[((_e69 * 512u) + _e56)];
                let _e165 = (_e71 + 1u);
                if (_e165 >= 1u) {
                    let _e171 = params.member.member_4[0u][1u];
                    phi_390_ = _e171;
                } else {
                    phi_390_ = _e76;
                }
                let _e173 = phi_390_;
                if (_e165 >= 4u) {
                    let _e179 = params.member.member_4[0u][2u];
                    phi_407_ = _e179;
                } else {
                    phi_407_ = _e173;
                }
                let _e181 = phi_407_;
                if (_e165 >= 9u) {
                    let _e187 = params.member.member_4[0u][3u];
                    phi_424_ = _e187;
                } else {
                    phi_424_ = _e181;
                }
                let _e189 = phi_424_;
                if (_e165 >= 16u) {
                    let _e195 = params.member.member_4[1u][0u];
                    phi_445_ = _e195;
                } else {
                    phi_445_ = _e189;
                }
                let _e197 = phi_445_;
                if (_e165 >= 25u) {
                    let _e203 = params.member.member_4[1u][1u];
                    phi_466_ = _e203;
                } else {
                    phi_466_ = _e197;
                }
                let _e205 = phi_466_;
                if (_e165 >= 36u) {
                    let _e211 = params.member.member_4[1u][2u];
                    phi_487_ = _e211;
                } else {
                    phi_487_ = _e205;
                }
                let _e213 = phi_487_;
                if (_e165 >= 49u) {
                    let _e219 = params.member.member_4[1u][3u];
                    phi_508_ = _e219;
                } else {
                    phi_508_ = _e213;
                }
                let _e221 = phi_508_;
                if (_e165 >= 64u) {
                    let _e227 = params.member.member_4[2u][0u];
                    phi_529_ = _e227;
                } else {
                    phi_529_ = _e221;
                }
                let _e229 = phi_529_;
                if (_e165 >= 81u) {
                    let _e235 = params.member.member_4[2u][1u];
                    phi_550_ = _e235;
                } else {
                    phi_550_ = _e229;
                }
                let _e237 = phi_550_;
                let _e241 = coefs.member[((_e69 * 64u) + _e56)];
                let _e247 = coefs.member[((_e69 * 320u) + _e56)];
                let _e253 = coefs.member[((_e69 * 576u) + _e56)];
                let _e255 = (_e71 + 2u);
                if (_e255 >= 1u) {
                    let _e261 = params.member.member_4[0u][1u];
                    phi_587_ = _e261;
                } else {
                    phi_587_ = _e76;
                }
                let _e263 = phi_587_;
                if (_e255 >= 4u) {
                    let _e269 = params.member.member_4[0u][2u];
                    phi_604_ = _e269;
                } else {
                    phi_604_ = _e263;
                }
                let _e271 = phi_604_;
                if (_e255 >= 9u) {
                    let _e277 = params.member.member_4[0u][3u];
                    phi_621_ = _e277;
                } else {
                    phi_621_ = _e271;
                }
                let _e279 = phi_621_;
                if (_e255 >= 16u) {
                    let _e285 = params.member.member_4[1u][0u];
                    phi_642_ = _e285;
                } else {
                    phi_642_ = _e279;
                }
                let _e287 = phi_642_;
                if (_e255 >= 25u) {
                    let _e293 = params.member.member_4[1u][1u];
                    phi_663_ = _e293;
                } else {
                    phi_663_ = _e287;
                }
                let _e295 = phi_663_;
                if (_e255 >= 36u) {
                    let _e301 = params.member.member_4[1u][2u];
                    phi_684_ = _e301;
                } else {
                    phi_684_ = _e295;
                }
                let _e303 = phi_684_;
                if (_e255 >= 49u) {
                    let _e309 = params.member.member_4[1u][3u];
                    phi_705_ = _e309;
                } else {
                    phi_705_ = _e303;
                }
                let _e311 = phi_705_;
                if (_e255 >= 64u) {
                    let _e317 = params.member.member_4[2u][0u];
                    phi_726_ = _e317;
                } else {
                    phi_726_ = _e311;
                }
                let _e319 = phi_726_;
                if (_e255 >= 81u) {
                    let _e325 = params.member.member_4[2u][1u];
                    phi_747_ = _e325;
                } else {
                    phi_747_ = _e319;
                }
                let _e327 = phi_747_;
                let _e332 = coefs.member[((_e69 * 128u) + _e56)];
                let _e338 = coefs.member[((_e69 * 384u) + _e56)];
                let _e344 = coefs.member[((_e69 * 640u) + _e56)];
                let _e346 = (_e71 + 3u);
                if (_e346 >= 1u) {
                    let _e352 = params.member.member_4[0u][1u];
                    phi_784_ = _e352;
                } else {
                    phi_784_ = _e76;
                }
                let _e354 = phi_784_;
                if (_e346 >= 4u) {
                    let _e360 = params.member.member_4[0u][2u];
                    phi_801_ = _e360;
                } else {
                    phi_801_ = _e354;
                }
                let _e362 = phi_801_;
                if (_e346 >= 9u) {
                    let _e368 = params.member.member_4[0u][3u];
                    phi_818_ = _e368;
                } else {
                    phi_818_ = _e362;
                }
                let _e370 = phi_818_;
                if (_e346 >= 16u) {
                    let _e376 = params.member.member_4[1u][0u];
                    phi_839_ = _e376;
                } else {
                    phi_839_ = _e370;
                }
                let _e378 = phi_839_;
                if (_e346 >= 25u) {
                    let _e384 = params.member.member_4[1u][1u];
                    phi_860_ = _e384;
                } else {
                    phi_860_ = _e378;
                }
                let _e386 = phi_860_;
                if (_e346 >= 36u) {
                    let _e392 = params.member.member_4[1u][2u];
                    phi_881_ = _e392;
                } else {
                    phi_881_ = _e386;
                }
                let _e394 = phi_881_;
                if (_e346 >= 49u) {
                    let _e400 = params.member.member_4[1u][3u];
                    phi_902_ = _e400;
                } else {
                    phi_902_ = _e394;
                }
                let _e402 = phi_902_;
                if (_e346 >= 64u) {
                    let _e408 = params.member.member_4[2u][0u];
                    phi_923_ = _e408;
                } else {
                    phi_923_ = _e402;
                }
                let _e410 = phi_923_;
                if (_e346 >= 81u) {
                    let _e416 = params.member.member_4[2u][1u];
                    phi_944_ = _e416;
                } else {
                    phi_944_ = _e410;
                }
                let _e418 = phi_944_;
                let _e423 = coefs.member[((_e69 * 192u) + _e56)];
                let _e429 = coefs.member[((_e69 * 448u) + _e56)];
                let _e435 = coefs.member[((_e69 * 704u) + _e56)];
                out.member[_e56] = (_e151 * _e148);
                out.member[(_e52 + _e56)] = (_e241 * _e237);
                out.member[((_e51 * 128u) + _e56)] = (_e332 * _e327);
                out.member[((_e51 * 192u) + _e56)] = (_e423 * _e418);
                out.member[((_e51 * 256u) + _e56)] = (_e157 * _e148);
                out.member[((_e51 * 320u) + _e56)] = (_e247 * _e237);
                out.member[((_e51 * 384u) + _e56)] = (_e338 * _e327);
                out.member[((_e51 * 448u) + _e56)] = (_e429 * _e418);
                out.member[((_e51 * 512u) + _e56)] = (_e163 * _e148);
                out.member[((_e51 * 576u) + _e56)] = (_e253 * _e237);
                out.member[((_e51 * 640u) + _e56)] = (_e344 * _e327);
                out.member[((_e51 * 704u) + _e56)] = (_e435 * _e418);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_filter(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
