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
    var phi_89_: u32;
    var phi_108_: u32;
    var phi_156_: u32;
    var phi_175_: u32;
    var phi_206_: f32;
    var phi_223_: f32;
    var phi_240_: f32;
    var phi_261_: f32;
    var phi_282_: f32;
    var phi_303_: f32;
    var phi_324_: f32;
    var phi_345_: f32;
    var phi_366_: f32;
    var phi_418_: f32;
    var phi_435_: f32;
    var phi_452_: f32;
    var phi_473_: f32;
    var phi_494_: f32;
    var phi_515_: f32;
    var phi_536_: f32;
    var phi_557_: f32;
    var phi_578_: f32;
    var phi_630_: f32;
    var phi_647_: f32;
    var phi_664_: f32;
    var phi_685_: f32;
    var phi_706_: f32;
    var phi_727_: f32;
    var phi_748_: f32;
    var phi_769_: f32;
    var phi_790_: f32;
    var phi_842_: f32;
    var phi_859_: f32;
    var phi_876_: f32;
    var phi_897_: f32;
    var phi_918_: f32;
    var phi_939_: f32;
    var phi_960_: f32;
    var phi_981_: f32;
    var phi_1002_: f32;
    var phi_1049_: type_12;
    var phi_1050_: type_12;
    var phi_1073_: type_12;
    var phi_1103_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e35 = gid_1;
            let _e37 = arrayLength((&coefs.member));
            let _e42 = params.member.member;
            let _e45 = params.member.member_1;
            let _e48 = (_e42 / 64u);
            let _e50 = ((_e42 % 64u) > 0u);
            if _e50 {
                phi_89_ = (_e48 + 1u);
            } else {
                phi_89_ = _e48;
            }
            let _e53 = phi_89_;
            let _e54 = (select(_e45, 9u, (_e45 > 9u)) + 1u);
            let _e55 = (_e54 * _e54);
            let _e56 = (_e55 / 4u);
            let _e58 = ((_e55 % 4u) > 0u);
            if _e58 {
                phi_108_ = (_e56 + 1u);
            } else {
                phi_108_ = _e56;
            }
            let _e61 = phi_108_;
            let _e63 = ((_e53 * _e61) * 64u);
            let _e67 = (_e35.x + (_e35.y * 2097152u));
            if (_e67 < _e63) {
                let _e69 = (_e67 / 64u);
                if _e50 {
                    phi_156_ = (_e48 + 1u);
                } else {
                    phi_156_ = _e48;
                }
                let _e72 = phi_156_;
                if _e58 {
                    phi_175_ = (_e56 + 1u);
                } else {
                    phi_175_ = _e56;
                }
                let _e75 = phi_175_;
                if (_e75 == 0u) {
                    break;
                }
                let _e80 = (_e72 * _e75);
                let _e82 = ((_e69 - ((_e69 / _e75) * _e75)) * 4u);
                let _e87 = params.member.member_4[0u][0u];
                if (_e82 >= 1u) {
                    let _e93 = params.member.member_4[0u][1u];
                    phi_206_ = _e93;
                } else {
                    phi_206_ = _e87;
                }
                let _e95 = phi_206_;
                if (_e82 >= 4u) {
                    let _e101 = params.member.member_4[0u][2u];
                    phi_223_ = _e101;
                } else {
                    phi_223_ = _e95;
                }
                let _e103 = phi_223_;
                if (_e82 >= 9u) {
                    let _e109 = params.member.member_4[0u][3u];
                    phi_240_ = _e109;
                } else {
                    phi_240_ = _e103;
                }
                let _e111 = phi_240_;
                if (_e82 >= 16u) {
                    let _e117 = params.member.member_4[1u][0u];
                    phi_261_ = _e117;
                } else {
                    phi_261_ = _e111;
                }
                let _e119 = phi_261_;
                if (_e82 >= 25u) {
                    let _e125 = params.member.member_4[1u][1u];
                    phi_282_ = _e125;
                } else {
                    phi_282_ = _e119;
                }
                let _e127 = phi_282_;
                if (_e82 >= 36u) {
                    let _e133 = params.member.member_4[1u][2u];
                    phi_303_ = _e133;
                } else {
                    phi_303_ = _e127;
                }
                let _e135 = phi_303_;
                if (_e82 >= 49u) {
                    let _e141 = params.member.member_4[1u][3u];
                    phi_324_ = _e141;
                } else {
                    phi_324_ = _e135;
                }
                let _e143 = phi_324_;
                if (_e82 >= 64u) {
                    let _e149 = params.member.member_4[2u][0u];
                    phi_345_ = _e149;
                } else {
                    phi_345_ = _e143;
                }
                let _e151 = phi_345_;
                if (_e82 >= 81u) {
                    let _e157 = params.member.member_4[2u][1u];
                    phi_366_ = _e157;
                } else {
                    phi_366_ = _e151;
                }
                let _e159 = phi_366_;
                if (_e67 < _e37) {
                } else {
                    break;
                }
                let _e163 = coefs.member[_e67];
                let _e166 = ((_e80 * 256u) + _e67);
                if (_e166 < _e37) {
                } else {
                    break;
                }
                let _e170 = coefs.member[_e166];
                let _e173 = ((_e80 * 512u) + _e67);
                if (_e173 < _e37) {
                } else {
                    break;
                }
                let _e177 = coefs.member[_e173];
                let _e179 = (_e82 + 1u);
                if (_e179 >= 1u) {
                    let _e185 = params.member.member_4[0u][1u];
                    phi_418_ = _e185;
                } else {
                    phi_418_ = _e87;
                }
                let _e187 = phi_418_;
                if (_e179 >= 4u) {
                    let _e193 = params.member.member_4[0u][2u];
                    phi_435_ = _e193;
                } else {
                    phi_435_ = _e187;
                }
                let _e195 = phi_435_;
                if (_e179 >= 9u) {
                    let _e201 = params.member.member_4[0u][3u];
                    phi_452_ = _e201;
                } else {
                    phi_452_ = _e195;
                }
                let _e203 = phi_452_;
                if (_e179 >= 16u) {
                    let _e209 = params.member.member_4[1u][0u];
                    phi_473_ = _e209;
                } else {
                    phi_473_ = _e203;
                }
                let _e211 = phi_473_;
                if (_e179 >= 25u) {
                    let _e217 = params.member.member_4[1u][1u];
                    phi_494_ = _e217;
                } else {
                    phi_494_ = _e211;
                }
                let _e219 = phi_494_;
                if (_e179 >= 36u) {
                    let _e225 = params.member.member_4[1u][2u];
                    phi_515_ = _e225;
                } else {
                    phi_515_ = _e219;
                }
                let _e227 = phi_515_;
                if (_e179 >= 49u) {
                    let _e233 = params.member.member_4[1u][3u];
                    phi_536_ = _e233;
                } else {
                    phi_536_ = _e227;
                }
                let _e235 = phi_536_;
                if (_e179 >= 64u) {
                    let _e241 = params.member.member_4[2u][0u];
                    phi_557_ = _e241;
                } else {
                    phi_557_ = _e235;
                }
                let _e243 = phi_557_;
                if (_e179 >= 81u) {
                    let _e249 = params.member.member_4[2u][1u];
                    phi_578_ = _e249;
                } else {
                    phi_578_ = _e243;
                }
                let _e251 = phi_578_;
                let _e252 = ((_e80 * 64u) + _e67);
                if (_e252 < _e37) {
                } else {
                    break;
                }
                let _e256 = coefs.member[_e252];
                let _e259 = ((_e80 * 320u) + _e67);
                if (_e259 < _e37) {
                } else {
                    break;
                }
                let _e263 = coefs.member[_e259];
                let _e266 = ((_e80 * 576u) + _e67);
                if (_e266 < _e37) {
                } else {
                    break;
                }
                let _e270 = coefs.member[_e266];
                let _e272 = (_e82 + 2u);
                if (_e272 >= 1u) {
                    let _e278 = params.member.member_4[0u][1u];
                    phi_630_ = _e278;
                } else {
                    phi_630_ = _e87;
                }
                let _e280 = phi_630_;
                if (_e272 >= 4u) {
                    let _e286 = params.member.member_4[0u][2u];
                    phi_647_ = _e286;
                } else {
                    phi_647_ = _e280;
                }
                let _e288 = phi_647_;
                if (_e272 >= 9u) {
                    let _e294 = params.member.member_4[0u][3u];
                    phi_664_ = _e294;
                } else {
                    phi_664_ = _e288;
                }
                let _e296 = phi_664_;
                if (_e272 >= 16u) {
                    let _e302 = params.member.member_4[1u][0u];
                    phi_685_ = _e302;
                } else {
                    phi_685_ = _e296;
                }
                let _e304 = phi_685_;
                if (_e272 >= 25u) {
                    let _e310 = params.member.member_4[1u][1u];
                    phi_706_ = _e310;
                } else {
                    phi_706_ = _e304;
                }
                let _e312 = phi_706_;
                if (_e272 >= 36u) {
                    let _e318 = params.member.member_4[1u][2u];
                    phi_727_ = _e318;
                } else {
                    phi_727_ = _e312;
                }
                let _e320 = phi_727_;
                if (_e272 >= 49u) {
                    let _e326 = params.member.member_4[1u][3u];
                    phi_748_ = _e326;
                } else {
                    phi_748_ = _e320;
                }
                let _e328 = phi_748_;
                if (_e272 >= 64u) {
                    let _e334 = params.member.member_4[2u][0u];
                    phi_769_ = _e334;
                } else {
                    phi_769_ = _e328;
                }
                let _e336 = phi_769_;
                if (_e272 >= 81u) {
                    let _e342 = params.member.member_4[2u][1u];
                    phi_790_ = _e342;
                } else {
                    phi_790_ = _e336;
                }
                let _e344 = phi_790_;
                let _e346 = ((_e80 * 128u) + _e67);
                if (_e346 < _e37) {
                } else {
                    break;
                }
                let _e350 = coefs.member[_e346];
                let _e353 = ((_e80 * 384u) + _e67);
                if (_e353 < _e37) {
                } else {
                    break;
                }
                let _e357 = coefs.member[_e353];
                let _e360 = ((_e80 * 640u) + _e67);
                if (_e360 < _e37) {
                } else {
                    break;
                }
                let _e364 = coefs.member[_e360];
                let _e366 = (_e82 + 3u);
                if (_e366 >= 1u) {
                    let _e372 = params.member.member_4[0u][1u];
                    phi_842_ = _e372;
                } else {
                    phi_842_ = _e87;
                }
                let _e374 = phi_842_;
                if (_e366 >= 4u) {
                    let _e380 = params.member.member_4[0u][2u];
                    phi_859_ = _e380;
                } else {
                    phi_859_ = _e374;
                }
                let _e382 = phi_859_;
                if (_e366 >= 9u) {
                    let _e388 = params.member.member_4[0u][3u];
                    phi_876_ = _e388;
                } else {
                    phi_876_ = _e382;
                }
                let _e390 = phi_876_;
                if (_e366 >= 16u) {
                    let _e396 = params.member.member_4[1u][0u];
                    phi_897_ = _e396;
                } else {
                    phi_897_ = _e390;
                }
                let _e398 = phi_897_;
                if (_e366 >= 25u) {
                    let _e404 = params.member.member_4[1u][1u];
                    phi_918_ = _e404;
                } else {
                    phi_918_ = _e398;
                }
                let _e406 = phi_918_;
                if (_e366 >= 36u) {
                    let _e412 = params.member.member_4[1u][2u];
                    phi_939_ = _e412;
                } else {
                    phi_939_ = _e406;
                }
                let _e414 = phi_939_;
                if (_e366 >= 49u) {
                    let _e420 = params.member.member_4[1u][3u];
                    phi_960_ = _e420;
                } else {
                    phi_960_ = _e414;
                }
                let _e422 = phi_960_;
                if (_e366 >= 64u) {
                    let _e428 = params.member.member_4[2u][0u];
                    phi_981_ = _e428;
                } else {
                    phi_981_ = _e422;
                }
                let _e430 = phi_981_;
                if (_e366 >= 81u) {
                    let _e436 = params.member.member_4[2u][1u];
                    phi_1002_ = _e436;
                } else {
                    phi_1002_ = _e430;
                }
                let _e438 = phi_1002_;
                let _e440 = ((_e80 * 192u) + _e67);
                if (_e440 < _e37) {
                } else {
                    break;
                }
                let _e444 = coefs.member[_e440];
                let _e447 = ((_e80 * 448u) + _e67);
                if (_e447 < _e37) {
                } else {
                    break;
                }
                let _e451 = coefs.member[_e447];
                let _e454 = ((_e80 * 704u) + _e67);
                if (_e454 < _e37) {
                } else {
                    break;
                }
                let _e458 = coefs.member[_e454];
                local = array<f32, 12>((_e163 * _e159), (_e256 * _e251), (_e350 * _e344), (_e444 * _e438), (_e170 * _e159), (_e263 * _e251), (_e357 * _e344), (_e451 * _e438), (_e177 * _e159), (_e270 * _e251), (_e364 * _e344), (_e458 * _e438));
                phi_1049_ = type_12(0u, 12u);
                loop {
                    let _e462 = phi_1049_;
                    if (_e462.member < _e462.member_1) {
                        phi_1050_ = type_12((_e462.member + 1u), _e462.member_1);
                        phi_1073_ = type_12(1u, _e462.member);
                    } else {
                        phi_1050_ = _e462;
                        phi_1073_ = type_12(0u, type_12().member_1);
                    }
                    let _e475 = phi_1050_;
                    let _e477 = phi_1073_;
                    let _e481 = (bitcast<i32>(_e477.member) != 0i);
                    if _e481 {
                        if (_e477.member_1 < 12u) {
                        } else {
                            phi_1103_ = true;
                            break;
                        }
                        let _e484 = local[_e477.member_1];
                        let _e486 = ((_e477.member_1 * _e63) + _e67);
                        if (_e486 < arrayLength((&out.member))) {
                        } else {
                            phi_1103_ = true;
                            break;
                        }
                        out.member[_e486] = _e484;
                    }
                    continue;
                    continuing {
                        phi_1049_ = _e475;
                        phi_1103_ = false;
                        break if !(_e481);
                    }
                }
                let _e492 = phi_1103_;
                if _e492 {
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
