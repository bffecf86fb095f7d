struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<vec4<f32>, 3>,
}

struct type_19 {
    member: type_18,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> out: type_5;
@group(0) @binding(1) 
var<storage> coefs: type_5;
@group(0) @binding(0) 
var<uniform> params: type_19;

fn function_() {
    var local: array<f32, 12>;
    var phi_88_: u32;
    var phi_107_: u32;
    var phi_155_: u32;
    var phi_174_: u32;
    var phi_205_: f32;
    var phi_222_: f32;
    var phi_239_: f32;
    var phi_260_: f32;
    var phi_281_: f32;
    var phi_302_: f32;
    var phi_323_: f32;
    var phi_344_: f32;
    var phi_365_: f32;
    var phi_402_: f32;
    var phi_419_: f32;
    var phi_436_: f32;
    var phi_457_: f32;
    var phi_478_: f32;
    var phi_499_: f32;
    var phi_520_: f32;
    var phi_541_: f32;
    var phi_562_: f32;
    var phi_599_: f32;
    var phi_616_: f32;
    var phi_633_: f32;
    var phi_654_: f32;
    var phi_675_: f32;
    var phi_696_: f32;
    var phi_717_: f32;
    var phi_738_: f32;
    var phi_759_: f32;
    var phi_796_: f32;
    var phi_813_: f32;
    var phi_830_: f32;
    var phi_851_: f32;
    var phi_872_: f32;
    var phi_893_: f32;
    var phi_914_: f32;
    var phi_935_: f32;
    var phi_956_: f32;
    var phi_988_: type_12;
    var phi_989_: type_12;
    var phi_1012_: type_12;
    var phi_1042_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e35 = gid_1;
            let _e40 = params.member.member;
            let _e43 = params.member.member_1;
            let _e46 = (_e40 / 64u);
            let _e48 = ((_e40 % 64u) > 0u);
            if _e48 {
                phi_88_ = (_e46 + 1u);
            } else {
                phi_88_ = _e46;
            }
            let _e51 = phi_88_;
            let _e52 = (select(_e43, 9u, (_e43 > 9u)) + 1u);
            let _e53 = (_e52 * _e52);
            let _e54 = (_e53 / 4u);
            let _e56 = ((_e53 % 4u) > 0u);
            if _e56 {
                phi_107_ = (_e54 + 1u);
            } else {
                phi_107_ = _e54;
            }
            let _e59 = phi_107_;
            let _e61 = ((_e51 * _e59) * 64u);
            let _e65 = (_e35.x + (_e35.y * 2097152u));
            if (_e65 < _e61) {
                let _e67 = (_e65 / 64u);
                if _e48 {
                    phi_155_ = (_e46 + 1u);
                } else {
                    phi_155_ = _e46;
                }
                let _e70 = phi_155_;
                if _e56 {
                    phi_174_ = (_e54 + 1u);
                } else {
                    phi_174_ = _e54;
                }
                let _e73 = phi_174_;
                if (_e73 == 0u) {
                    break;
                }
                let _e78 = (_e70 * _e73);
                let _e80 = ((_e67 - ((_e67 / _e73) * _e73)) * 4u);
                let _e85 = params.member.member_4[0u][0u];
                if (_e80 >= 1u) {
                    let _e91 = params.member.member_4[0u][1u];
                    phi_205_ = _e91;
                } else {
                    phi_205_ = _e85;
                }
                let _e93 = phi_205_;
                if (_e80 >= 4u) {
                    let _e99 = params.member.member_4[0u][2u];
                    phi_222_ = _e99;
                } else {
                    phi_222_ = _e93;
                }
                let _e101 = phi_222_;
                if (_e80 >= 9u) {
                    let _e107 = params.member.member_4[0u][3u];
                    phi_239_ = _e107;
                } else {
                    phi_239_ = _e101;
                }
                let _e109 = phi_239_;
                if (_e80 >= 16u) {
                    let _e115 = params.member.member_4[1u][0u];
                    phi_260_ = _e115;
                } else {
                    phi_260_ = _e109;
                }
                let _e117 = phi_260_;
                if (_e80 >= 25u) {
                    let _e123 = params.member.member_4[1u][1u];
                    phi_281_ = _e123;
                } else {
                    phi_281_ = _e117;
                }
                let _e125 = phi_281_;
                if (_e80 >= 36u) {
                    let _e131 = params.member.member_4[1u][2u];
                    phi_302_ = _e131;
                } else {
                    phi_302_ = _e125;
                }
                let _e133 = phi_302_;
                if (_e80 >= 49u) {
                    let _e139 = params.member.member_4[1u][3u];
                    phi_323_ = _e139;
                } else {
                    phi_323_ = _e133;
                }
                let _e141 = phi_323_;
                if (_e80 >= 64u) {
                    let _e147 = params.member.member_4[2u][0u];
                    phi_344_ = _e147;
                } else {
                    phi_344_ = _e141;
                }
                let _e149 = phi_344_;
                if (_e80 >= 81u) {
                    let _e155 = params.member.member_4[2u][1u];
                    phi_365_ = _e155;
                } else {
                    phi_365_ = _e149;
                }
                let _e157 = phi_365_;
                let _e160 = coefs.member[_e65];
                let _e166 = coefs.member[((_e78 * 256u) + _e65)];
                let _e172 = coefs.member[((_e78 * 512u) + _e65)];
                let _e174 = (_e80 + 1u);
                if (_e174 >= 1u) {
                    let _e180 = params.member.member_4[0u][1u];
                    phi_402_ = _e180;
                } else {
                    phi_402_ = _e85;
                }
                let _e182 = phi_402_;
                if (_e174 >= 4u) {
                    let _e188 = params.member.member_4[0u][2u];
                    phi_419_ = _e188;
                } else {
                    phi_419_ = _e182;
                }
                let _e190 = phi_419_;
                if (_e174 >= 9u) {
                    let _e196 = params.member.member_4[0u][3u];
                    phi_436_ = _e196;
                } else {
                    phi_436_ = _e190;
                }
                let _e198 = phi_436_;
                if (_e174 >= 16u) {
                    let _e204 = params.member.member_4[1u][0u];
                    phi_457_ = _e204;
                } else {
                    phi_457_ = _e198;
                }
                let _e206 = phi_457_;
                if (_e174 >= 25u) {
                    let _e212 = params.member.member_4[1u][1u];
                    phi_478_ = _e212;
                } else {
                    phi_478_ = _e206;
                }
                let _e214 = phi_478_;
                if (_e174 >= 36u) {
                    let _e220 = params.member.member_4[1u][2u];
                    phi_499_ = _e220;
                } else {
                    phi_499_ = _e214;
                }
                let _e222 = phi_499_;
                if (_e174 >= 49u) {
                    let _e228 = params.member.member_4[1u][3u];
                    phi_520_ = _e228;
                } else {
                    phi_520_ = _e222;
                }
                let _e230 = phi_520_;
                if (_e174 >= 64u) {
                    let _e236 = params.member.member_4[2u][0u];
                    phi_541_ = _e236;
                } else {
                    phi_541_ = _e230;
                }
                let _e238 = phi_541_;
                if (_e174 >= 81u) {
                    let _e244 = params.member.member_4[2u][1u];
                    phi_562_ = _e244;
                } else {
                    phi_562_ = _e238;
                }
                let _e246 = phi_562_;
                let _e250 = coefs.member[((_e78 * 64u) + _e65)];
                let _e256 = coefs.member[((_e78 * 320u) + _e65)];
                let _e262 = coefs.member[((_e78 * 576u) + _e65)];
                let _e264 = (_e80 + 2u);
                if (_e264 >= 1u) {
                    let _e270 = params.member.member_4[0u][1u];
                    phi_599_ = _e270;
                } else {
                    phi_599_ = _e85;
                }
                let _e272 = phi_599_;
                if (_e264 >= 4u) {
                    let _e278 = params.member.member_4[0u][2u];
                    phi_616_ = _e278;
                } else {
                    phi_616_ = _e272;
                }
                let _e280 = phi_616_;
                if (_e264 >= 9u) {
                    let _e286 = params.member.member_4[0u][3u];
                    phi_633_ = _e286;
                } else {
                    phi_633_ = _e280;
                }
                let _e288 = phi_633_;
                if (_e264 >= 16u) {
                    let _e294 = params.member.member_4[1u][0u];
                    phi_654_ = _e294;
                } else {
                    phi_654_ = _e288;
                }
                let _e296 = phi_654_;
                if (_e264 >= 25u) {
                    let _e302 = params.member.member_4[1u][1u];
                    phi_675_ = _e302;
                } else {
                    phi_675_ = _e296;
                }
                let _e304 = phi_675_;
                if (_e264 >= 36u) {
                    let _e310 = params.member.member_4[1u][2u];
                    phi_696_ = _e310;
                } else {
                    phi_696_ = _e304;
                }
                let _e312 = phi_696_;
                if (_e264 >= 49u) {
                    let _e318 = params.member.member_4[1u][3u];
                    phi_717_ = _e318;
                } else {
                    phi_717_ = _e312;
                }
                let _e320 = phi_717_;
                if (_e264 >= 64u) {
                    let _e326 = params.member.member_4[2u][0u];
                    phi_738_ = _e326;
                } else {
                    phi_738_ = _e320;
                }
                let _e328 = phi_738_;
                if (_e264 >= 81u) {
                    let _e334 = params.member.member_4[2u][1u];
                    phi_759_ = _e334;
                } else {
                    phi_759_ = _e328;
                }
                let _e336 = phi_759_;
                let _e341 = coefs.member[((_e78 * 128u) + _e65)];
                let _e347 = coefs.member[((_e78 * 384u) + _e65)];
                let _e353 = coefs.member[((_e78 * 640u) + _e65)];
                let _e355 = (_e80 + 3u);
                if (_e355 >= 1u) {
                    let _e361 = params.member.member_4[0u][1u];
                    phi_796_ = _e361;
                } else {
                    phi_796_ = _e85;
                }
                let _e363 = phi_796_;
                if (_e355 >= 4u) {
                    let _e369 = params.member.member_4[0u][2u];
                    phi_813_ = _e369;
                } else {
                    phi_813_ = _e363;
                }
                let _e371 = phi_813_;
                if (_e355 >= 9u) {
                    let _e377 = params.member.member_4[0u][3u];
                    phi_830_ = _e377;
                } else {
                    phi_830_ = _e371;
                }
                let _e379 = phi_830_;
                if (_e355 >= 16u) {
                    let _e385 = params.member.member_4[1u][0u];
                    phi_851_ = _e385;
                } else {
                    phi_851_ = _e379;
                }
                let _e387 = phi_851_;
                if (_e355 >= 25u) {
                    let _e393 = params.member.member_4[1u][1u];
                    phi_872_ = _e393;
                } else {
                    phi_872_ = _e387;
                }
                let _e395 = phi_872_;
                if (_e355 >= 36u) {
                    let _e401 = params.member.member_4[1u][2u];
                    phi_893_ = _e401;
                } else {
                    phi_893_ = _e395;
                }
                let _e403 = phi_893_;
                if (_e355 >= 49u) {
                    let _e409 = params.member.member_4[1u][3u];
                    phi_914_ = _e409;
                } else {
                    phi_914_ = _e403;
                }
                let _e411 = phi_914_;
                if (_e355 >= 64u) {
                    let _e417 = params.member.member_4[2u][0u];
                    phi_935_ = _e417;
                } else {
                    phi_935_ = _e411;
                }
                let _e419 = phi_935_;
                if (_e355 >= 81u) {
                    let _e425 = params.member.member_4[2u][1u];
                    phi_956_ = _e425;
                } else {
                    phi_956_ = _e419;
                }
                let _e427 = phi_956_;
                let _e432 = coefs.member[((_e78 * 192u) + _e65)];
                let _e438 = coefs.member[((_e78 * 448u) + _e65)];
                let _e444 = coefs.member[((_e78 * 704u) + _e65)];
                local = array<f32, 12>((_e160 * _e157), (_e250 * _e246), (_e341 * _e336), (_e432 * _e427), (_e166 * _e157), (_e256 * _e246), (_e347 * _e336), (_e438 * _e427), (_e172 * _e157), (_e262 * _e246), (_e353 * _e336), (_e444 * _e427));
                phi_988_ = type_12(0u, 12u);
                loop {
                    let _e448 = phi_988_;
                    if (_e448.member < _e448.member_1) {
                        phi_989_ = type_12((_e448.member + 1u), _e448.member_1);
                        phi_1012_ = type_12(1u, _e448.member);
                    } else {
                        phi_989_ = _e448;
                        phi_1012_ = type_12(0u, type_12().member_1);
                    }
                    let _e461 = phi_989_;
                    let _e463 = phi_1012_;
                    let _e467 = (bitcast<i32>(_e463.member) != 0i);
                    if _e467 {
                        if (_e463.member_1 < 12u) {
                        } else {
                            phi_1042_ = true;
                            break;
                        }
                        let _e470 = local[_e463.member_1];
                        let _e472 = ((_e463.member_1 * _e61) + _e65);
                        if (_e472 < arrayLength((&out.member))) {
                        } else {
                            phi_1042_ = true;
                            break;
                        }
                        out.member[_e472] = _e470;
                    }
                    continue;
                    continuing {
                        phi_988_ = _e461;
                        phi_1042_ = false;
                        break if !(_e467);
                    }
                }
                let _e478 = phi_1042_;
                if _e478 {
                    break;
                }
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
