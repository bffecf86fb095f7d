struct type_5 {
    member: array<f32>,
}

struct type_13 {
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
@group(0) @binding(1) 
var<storage> coefs: type_5;
@group(0) @binding(2) 
var<storage> normals: type_5;
@group(0) @binding(3) 
var<storage, read_write> irradiance: type_5;

fn function_() {
    var local: array<f32, 3>;
    var phi_204_: u32;
    var phi_266_: u32;
    var phi_285_: u32;
    var phi_399_: array<f32, 3>;
    var phi_401_: f32;
    var phi_444_: array<f32, 3>;
    var phi_446_: f32;
    var phi_491_: f32;
    var phi_534_: array<f32, 3>;
    var phi_536_: f32;
    var phi_581_: f32;
    var phi_624_: array<f32, 3>;
    var phi_626_: f32;
    var phi_671_: f32;
    var phi_714_: array<f32, 3>;
    var phi_839_: array<f32, 3>;
    var phi_916_: array<f32, 3>;
    var phi_918_: f32;
    var phi_999_: f32;
    var phi_1078_: array<f32, 3>;
    var phi_1080_: f32;
    var phi_1161_: f32;
    var phi_1240_: array<f32, 3>;
    var phi_1242_: f32;
    var phi_1323_: f32;
    var phi_1402_: array<f32, 3>;
    var phi_1484_: array<f32, 3>;
    var phi_1569_: array<f32, 3>;
    var phi_1648_: f32;
    var phi_1727_: array<f32, 3>;
    var phi_1729_: f32;
    var phi_1810_: f32;
    var phi_1889_: array<f32, 3>;
    var phi_1891_: f32;
    var phi_1972_: f32;
    var phi_2051_: array<f32, 3>;
    var phi_2133_: array<f32, 3>;
    var phi_2134_: f32;
    var phi_2135_: f32;
    var phi_2297_: array<f32, 3>;
    var phi_2299_: f32;
    var phi_2380_: f32;
    var phi_2459_: array<f32, 3>;
    var phi_2461_: f32;
    var phi_2542_: f32;
    var phi_2621_: array<f32, 3>;
    var phi_2703_: array<f32, 3>;
    var phi_2704_: f32;
    var phi_2705_: f32;
    var phi_2790_: array<f32, 3>;
    var phi_2869_: f32;
    var phi_2948_: array<f32, 3>;
    var phi_2950_: f32;
    var phi_3031_: f32;
    var phi_3110_: array<f32, 3>;
    var phi_3192_: array<f32, 3>;
    var phi_3193_: f32;
    var phi_3194_: f32;
    var phi_3356_: array<f32, 3>;
    var phi_3358_: f32;
    var phi_3439_: f32;
    var phi_3518_: array<f32, 3>;
    var phi_3600_: array<f32, 3>;
    var phi_3601_: f32;
    var phi_3602_: f32;
    var phi_3687_: array<f32, 3>;
    var phi_3766_: f32;
    var phi_3845_: array<f32, 3>;
    var phi_3927_: array<f32, 3>;
    var phi_3928_: f32;
    var phi_3929_: f32;
    var phi_4091_: array<f32, 3>;
    var phi_4173_: array<f32, 3>;
    var phi_4174_: f32;
    var phi_4175_: f32;
    var phi_4260_: array<f32, 3>;
    var phi_4338_: array<f32, 3>;
    var phi_4442_: type_13;
    var phi_4443_: type_13;
    var phi_4466_: type_13;
    var phi_4496_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e120 = gid_1;
            let _e126 = params.member.member;
            let _e127 = (_e126 / 64u);
            let _e129 = ((_e126 % 64u) > 0u);
            if _e129 {
                phi_204_ = (_e127 + 1u);
            } else {
                phi_204_ = _e127;
            }
            let _e132 = phi_204_;
            let _e133 = (_e132 * 64u);
            let _e137 = (_e120.x + (_e120.y * 2097152u));
            if (_e137 < _e133) {
                let _e140 = ((_e137 / 64u) * 64u);
                let _e144 = params.member.member_2;
                if _e129 {
                    phi_266_ = (_e127 + 1u);
                } else {
                    phi_266_ = _e127;
                }
                let _e149 = phi_266_;
                let _e150 = (select(_e144, 9u, (_e144 > 9u)) + 1u);
                let _e151 = (_e150 * _e150);
                let _e152 = (_e151 / 4u);
                if ((_e151 % 4u) > 0u) {
                    phi_285_ = (_e152 + 1u);
                } else {
                    phi_285_ = _e152;
                }
                let _e157 = phi_285_;
                let _e161 = normals.member[_e137];
                let _e165 = normals.member[((_e149 * 64u) + _e137)];
                let _e170 = normals.member[((_e149 * 128u) + _e137)];
                let _e176 = (((((_e140 / 64u) * _e157) * 64u) + (_e140 % 64u)) + (_e137 - _e140));
                let _e177 = (_e149 * _e157);
                let _e178 = (_e177 * 64u);
                let _e180 = coefs.member[_e176];
                let _e181 = (_e180 * 0.886227f);
                let _e182 = (_e177 * 256u);
                let _e185 = coefs.member[(_e176 + _e182)];
                let _e186 = (_e185 * 0.886227f);
                let _e187 = (_e177 * 512u);
                let _e190 = coefs.member[(_e176 + _e187)];
                let _e191 = (_e190 * 0.886227f);
                let _e193 = (1u <= _e144);
                if _e193 {
                    let _e195 = (_e170 * 1.0233268f);
                    let _e197 = (_e176 + (_e177 * 128u));
                    let _e199 = coefs.member[_e197];
                    let _e204 = coefs.member[(_e197 + _e182)];
                    let _e209 = coefs.member[(_e197 + _e187)];
                    phi_399_ = array<f32, 3>((_e181 + (_e199 * _e195)), (_e186 + (_e204 * _e195)), (_e191 + (_e209 * _e195)));
                    phi_401_ = (_e170 * 0.48860252f);
                } else {
                    phi_399_ = array<f32, 3>(_e181, _e186, _e191);
                    phi_401_ = 0.2820948f;
                }
                let _e214 = phi_399_;
                let _e216 = phi_401_;
                let _e217 = select(0f, 0.2820948f, _e193);
                let _e218 = (2u <= _e144);
                if _e218 {
                    let _e222 = (((_e170 * 1.9364917f) * _e216) - (1.118034f * _e217));
                    let _e223 = (_e222 * 0.7853982f);
                    let _e226 = ((_e176 + (_e177 * 128u)) + 64u);
                    let _e229 = coefs.member[_e226];
                    let _e235 = coefs.member[(_e226 + _e182)];
                    let _e241 = coefs.member[(_e226 + _e187)];
                    phi_444_ = array<f32, 3>((_e214[0] + (_e229 * _e223)), (_e214[1] + (_e235 * _e223)), (_e214[2] + (_e241 * _e223)));
                    phi_446_ = _e222;
                } else {
                    phi_444_ = _e214;
                    phi_446_ = _e216;
                }
                let _e246 = phi_444_;
                let _e248 = phi_446_;
                let _e249 = select(_e217, _e216, _e218);
                let _e250 = (3u <= _e144);
                if _e250 {
                    phi_491_ = (((_e170 * 1.9720266f) * _e248) - (1.0183501f * _e249));
                } else {
                    phi_491_ = _e248;
                }
                let _e256 = phi_491_;
                let _e257 = select(_e249, _e248, _e250);
                let _e258 = (4u <= _e144);
                if _e258 {
                    let _e262 = (((_e170 * 1.9843135f) * _e256) - (1.0062306f * _e257));
                    let _e263 = (_e262 * -0.1308997f);
                    let _e264 = (_e176 + 320u);
                    let _e267 = coefs.member[_e264];
                    let _e273 = coefs.member[(_e264 + _e182)];
                    let _e279 = coefs.member[(_e264 + _e187)];
                    phi_534_ = array<f32, 3>((_e246[0] + (_e267 * _e263)), (_e246[1] + (_e273 * _e263)), (_e246[2] + (_e279 * _e263)));
                    phi_536_ = _e262;
                } else {
                    phi_534_ = _e246;
                    phi_536_ = _e256;
                }
                let _e284 = phi_534_;
                let _e286 = phi_536_;
                let _e287 = select(_e257, _e256, _e258);
                let _e288 = (5u <= _e144);
                if _e288 {
                    phi_581_ = (((_e170 * 1.9899749f) * _e286) - (1.002853f * _e287));
                } else {
                    phi_581_ = _e286;
                }
                let _e294 = phi_581_;
                let _e295 = select(_e287, _e286, _e288);
                let _e296 = (6u <= _e144);
                if _e296 {
                    let _e300 = (((_e170 * 1.9930434f) * _e294) - (1.001542f * _e295));
                    let _e301 = (_e300 * 0.049087387f);
                    let _e304 = ((_e176 + (_e177 * 128u)) + 640u);
                    let _e307 = coefs.member[_e304];
                    let _e313 = coefs.member[(_e304 + _e182)];
                    let _e319 = coefs.member[(_e304 + _e187)];
                    phi_624_ = array<f32, 3>((_e284[0] + (_e307 * _e301)), (_e284[1] + (_e313 * _e301)), (_e284[2] + (_e319 * _e301)));
                    phi_626_ = _e300;
                } else {
                    phi_624_ = _e284;
                    phi_626_ = _e294;
                }
                let _e324 = phi_624_;
                let _e326 = phi_626_;
                let _e327 = select(_e295, _e294, _e296);
                let _e328 = (7u <= _e144);
                if _e328 {
                    phi_671_ = (((_e170 * 1.9948914f) * _e326) - (1.0009272f * _e327));
                } else {
                    phi_671_ = _e326;
                }
                let _e334 = phi_671_;
                let _e336 = (8u <= _e144);
                if _e336 {
                    let _e341 = ((((_e170 * 1.9960899f) * _e334) - (1.0006008f * select(_e327, _e326, _e328))) * -0.024543693f);
                    let _e342 = (_e176 + 1152u);
                    let _e345 = coefs.member[_e342];
                    let _e351 = coefs.member[(_e342 + _e182)];
                    let _e357 = coefs.member[(_e342 + _e187)];
                    phi_714_ = array<f32, 3>((_e324[0] + (_e345 * _e341)), (_e324[1] + (_e351 * _e341)), (_e324[2] + (_e357 * _e341)));
                } else {
                    phi_714_ = _e324;
                }
                let _e362 = phi_714_;
                if _e193 {
                    if _e193 {
                        let _e363 = (_e161 * 1.0233268f);
                        let _e365 = (_e176 + (_e177 * 192u));
                        let _e368 = coefs.member[_e365];
                        let _e374 = coefs.member[(_e365 + _e182)];
                        let _e380 = coefs.member[(_e365 + _e187)];
                        let _e383 = (_e165 * 1.0233268f);
                        let _e384 = (_e176 + _e178);
                        let _e386 = coefs.member[_e384];
                        let _e391 = coefs.member[(_e384 + _e182)];
                        let _e396 = coefs.member[(_e384 + _e187)];
                        phi_839_ = array<f32, 3>(((_e362[0] + (_e368 * _e363)) + (_e386 * _e383)), ((_e362[1] + (_e374 * _e363)) + (_e391 * _e383)), ((_e362[2] + (_e380 * _e363)) + (_e396 * _e383)));
                    } else {
                        phi_839_ = _e362;
                    }
                    let _e401 = phi_839_;
                    if _e218 {
                        let _e402 = (_e170 * 1.0925485f);
                        let _e404 = ((_e402 * _e161) * 0.7853982f);
                        let _e407 = ((_e176 + (_e177 * 192u)) + 64u);
                        let _e410 = coefs.member[_e407];
                        let _e416 = coefs.member[(_e407 + _e182)];
                        let _e422 = coefs.member[(_e407 + _e187)];
                        let _e426 = ((_e402 * _e165) * 0.7853982f);
                        let _e428 = ((_e176 + _e178) + 64u);
                        let _e430 = coefs.member[_e428];
                        let _e435 = coefs.member[(_e428 + _e182)];
                        let _e440 = coefs.member[(_e428 + _e187)];
                        phi_916_ = array<f32, 3>(((_e401[0] + (_e410 * _e404)) + (_e430 * _e426)), ((_e401[1] + (_e416 * _e404)) + (_e435 * _e426)), ((_e401[2] + (_e422 * _e404)) + (_e440 * _e426)));
                        phi_918_ = _e402;
                    } else {
                        phi_916_ = _e401;
                        phi_918_ = 0.48860252f;
                    }
                    let _e445 = phi_916_;
                    let _e447 = phi_918_;
                    let _e448 = select(0f, 0.48860252f, _e218);
                    if _e250 {
                        phi_999_ = (((_e170 * 2.09165f) * _e447) - (0.9354144f * _e448));
                    } else {
                        phi_999_ = _e447;
                    }
                    let _e454 = phi_999_;
                    let _e455 = select(_e448, _e447, _e250);
                    if _e258 {
                        let _e459 = (((_e170 * 2.04939f) * _e454) - (0.9797959f * _e455));
                        let _e461 = ((_e459 * _e161) * -0.1308997f);
                        let _e463 = ((_e176 + _e178) + 320u);
                        let _e466 = coefs.member[_e463];
                        let _e472 = coefs.member[(_e463 + _e182)];
                        let _e478 = coefs.member[(_e463 + _e187)];
                        let _e482 = ((_e459 * _e165) * -0.1308997f);
                        let _e485 = ((_e176 + (_e177 * 192u)) + 256u);
                        let _e487 = coefs.member[_e485];
                        let _e492 = coefs.member[(_e485 + _e182)];
                        let _e497 = coefs.member[(_e485 + _e187)];
                        phi_1078_ = array<f32, 3>(((_e445[0] + (_e466 * _e461)) + (_e487 * _e482)), ((_e445[1] + (_e472 * _e461)) + (_e492 * _e482)), ((_e445[2] + (_e478 * _e461)) + (_e497 * _e482)));
                        phi_1080_ = _e459;
                    } else {
                        phi_1078_ = _e445;
                        phi_1080_ = _e454;
                    }
                    let _e502 = phi_1078_;
                    let _e504 = phi_1080_;
                    let _e505 = select(_e455, _e454, _e258);
                    if _e288 {
                        phi_1161_ = (((_e170 * 2.0310097f) * _e504) - (0.9910312f * _e505));
                    } else {
                        phi_1161_ = _e504;
                    }
                    let _e511 = phi_1161_;
                    let _e512 = select(_e505, _e504, _e288);
                    if _e296 {
                        let _e516 = (((_e170 * 2.021315f) * _e511) - (0.9952267f * _e512));
                        let _e518 = ((_e516 * _e161) * 0.049087387f);
                        let _e521 = ((_e176 + (_e177 * 192u)) + 640u);
                        let _e524 = coefs.member[_e521];
                        let _e530 = coefs.member[(_e521 + _e182)];
                        let _e536 = coefs.member[(_e521 + _e187)];
                        let _e540 = ((_e516 * _e165) * 0.049087387f);
                        let _e542 = ((_e176 + _e178) + 640u);
                        let _e544 = coefs.member[_e542];
                        let _e549 = coefs.member[(_e542 + _e182)];
                        let _e554 = coefs.member[(_e542 + _e187)];
                        phi_1240_ = array<f32, 3>(((_e502[0] + (_e524 * _e518)) + (_e544 * _e540)), ((_e502[1] + (_e530 * _e518)) + (_e549 * _e540)), ((_e502[2] + (_e536 * _e518)) + (_e554 * _e540)));
                        phi_1242_ = _e516;
                    } else {
                        phi_1240_ = _e502;
                        phi_1242_ = _e511;
                    }
                    let _e559 = phi_1240_;
                    let _e561 = phi_1242_;
                    let _e562 = select(_e512, _e511, _e296);
                    if _e328 {
                        phi_1323_ = (((_e170 * 2.0155644f) * _e561) - (0.9971551f * _e562));
                    } else {
                        phi_1323_ = _e561;
                    }
                    let _e568 = phi_1323_;
                    if _e336 {
                        let _e573 = (((_e170 * 2.0118694f) * _e568) - (0.9981668f * select(_e562, _e561, _e328)));
                        let _e575 = ((_e573 * _e161) * -0.024543693f);
                        let _e577 = ((_e176 + _e178) + 1152u);
                        let _e580 = coefs.member[_e577];
                        let _e586 = coefs.member[(_e577 + _e182)];
                        let _e592 = coefs.member[(_e577 + _e187)];
                        let _e596 = ((_e573 * _e165) * -0.024543693f);
                        let _e599 = ((_e176 + (_e177 * 192u)) + 1088u);
                        let _e601 = coefs.member[_e599];
                        let _e606 = coefs.member[(_e599 + _e182)];
                        let _e611 = coefs.member[(_e599 + _e187)];
                        phi_1402_ = array<f32, 3>(((_e559[0] + (_e580 * _e575)) + (_e601 * _e596)), ((_e559[1] + (_e586 * _e575)) + (_e606 * _e596)), ((_e559[2] + (_e592 * _e575)) + (_e611 * _e596)));
                    } else {
                        phi_1402_ = _e559;
                    }
                    let _e616 = phi_1402_;
                    phi_1484_ = _e616;
                } else {
                    phi_1484_ = _e362;
                }
                let _e618 = phi_1484_;
                if _e218 {
                    let _e621 = ((_e161 * _e161) - (_e165 * _e165));
                    let _e623 = (_e161 * (_e165 + _e165));
                    if _e218 {
                        let _e624 = (_e621 * 0.4290428f);
                        let _e625 = (_e176 + 128u);
                        let _e628 = coefs.member[_e625];
                        let _e634 = coefs.member[(_e625 + _e182)];
                        let _e640 = coefs.member[(_e625 + _e187)];
                        let _e643 = (_e623 * 0.4290428f);
                        let _e644 = (_e176 + 64u);
                        let _e646 = coefs.member[_e644];
                        let _e651 = coefs.member[(_e644 + _e182)];
                        let _e656 = coefs.member[(_e644 + _e187)];
                        phi_1569_ = array<f32, 3>(((_e618[0] + (_e628 * _e624)) + (_e646 * _e643)), ((_e618[1] + (_e634 * _e624)) + (_e651 * _e643)), ((_e618[2] + (_e640 * _e624)) + (_e656 * _e643)));
                    } else {
                        phi_1569_ = _e618;
                    }
                    let _e661 = phi_1569_;
                    if _e250 {
                        phi_1648_ = (_e170 * 1.4453057f);
                    } else {
                        phi_1648_ = 0.54627424f;
                    }
                    let _e664 = phi_1648_;
                    let _e665 = select(0f, 0.54627424f, _e250);
                    if _e258 {
                        let _e669 = (((_e170 * 2.291288f) * _e664) - (0.8660254f * _e665));
                        let _e671 = ((_e669 * _e621) * -0.1308997f);
                        let _e673 = (_e176 + (_e177 * 128u));
                        let _e674 = (_e673 + 320u);
                        let _e677 = coefs.member[_e674];
                        let _e683 = coefs.member[(_e674 + _e182)];
                        let _e689 = coefs.member[(_e674 + _e187)];
                        let _e693 = ((_e669 * _e623) * -0.1308997f);
                        let _e694 = (_e673 + 256u);
                        let _e696 = coefs.member[_e694];
                        let _e701 = coefs.member[(_e694 + _e182)];
                        let _e706 = coefs.member[(_e694 + _e187)];
                        phi_1727_ = array<f32, 3>(((_e661[0] + (_e677 * _e671)) + (_e696 * _e693)), ((_e661[1] + (_e683 * _e671)) + (_e701 * _e693)), ((_e661[2] + (_e689 * _e671)) + (_e706 * _e693)));
                        phi_1729_ = _e669;
                    } else {
                        phi_1727_ = _e661;
                        phi_1729_ = _e664;
                    }
                    let _e711 = phi_1727_;
                    let _e713 = phi_1729_;
                    let _e714 = select(_e665, _e664, _e258);
                    if _e288 {
                        phi_1810_ = (((_e170 * 2.1712406f) * _e713) - (0.9476071f * _e714));
                    } else {
                        phi_1810_ = _e713;
                    }
                    let _e720 = phi_1810_;
                    let _e721 = select(_e714, _e713, _e288);
                    if _e296 {
                        let _e725 = (((_e170 * 2.113942f) * _e720) - (0.9736101f * _e721));
                        let _e727 = ((_e725 * _e621) * 0.049087387f);
                        let _e728 = (_e176 + 704u);
                        let _e731 = coefs.member[_e728];
                        let _e737 = coefs.member[(_e728 + _e182)];
                        let _e743 = coefs.member[(_e728 + _e187)];
                        let _e747 = ((_e725 * _e623) * 0.049087387f);
                        let _e748 = (_e176 + 640u);
                        let _e750 = coefs.member[_e748];
                        let _e755 = coefs.member[(_e748 + _e182)];
                        let _e760 = coefs.member[(_e748 + _e187)];
                        phi_1889_ = array<f32, 3>(((_e711[0] + (_e731 * _e727)) + (_e750 * _e747)), ((_e711[1] + (_e737 * _e727)) + (_e755 * _e747)), ((_e711[2] + (_e743 * _e727)) + (_e760 * _e747)));
                        phi_1891_ = _e725;
                    } else {
                        phi_1889_ = _e711;
                        phi_1891_ = _e720;
                    }
                    let _e765 = phi_1889_;
                    let _e767 = phi_1891_;
                    let _e768 = select(_e721, _e720, _e296);
                    if _e328 {
                        phi_1972_ = (((_e170 * 2.081666f) * _e767) - (0.9847319f * _e768));
                    } else {
                        phi_1972_ = _e767;
                    }
                    let _e774 = phi_1972_;
                    if _e336 {
                        let _e779 = (((_e170 * 2.0615528f) * _e774) - (0.9903379f * select(_e768, _e767, _e328)));
                        let _e781 = ((_e779 * _e621) * -0.024543693f);
                        let _e783 = (_e176 + (_e177 * 128u));
                        let _e784 = (_e783 + 1152u);
                        let _e787 = coefs.member[_e784];
                        let _e793 = coefs.member[(_e784 + _e182)];
                        let _e799 = coefs.member[(_e784 + _e187)];
                        let _e803 = ((_e779 * _e623) * -0.024543693f);
                        let _e804 = (_e783 + 1088u);
                        let _e806 = coefs.member[_e804];
                        let _e811 = coefs.member[(_e804 + _e182)];
                        let _e816 = coefs.member[(_e804 + _e187)];
                        phi_2051_ = array<f32, 3>(((_e765[0] + (_e787 * _e781)) + (_e806 * _e803)), ((_e765[1] + (_e793 * _e781)) + (_e811 * _e803)), ((_e765[2] + (_e799 * _e781)) + (_e816 * _e803)));
                    } else {
                        phi_2051_ = _e765;
                    }
                    let _e821 = phi_2051_;
                    phi_2133_ = _e821;
                    phi_2134_ = _e623;
                    phi_2135_ = _e621;
                } else {
                    phi_2133_ = _e618;
                    phi_2134_ = _e165;
                    phi_2135_ = _e161;
                }
                let _e823 = phi_2133_;
                let _e825 = phi_2134_;
                let _e827 = phi_2135_;
                if _e250 {
                    let _e830 = ((_e161 * _e827) - (_e165 * _e825));
                    let _e833 = ((_e161 * _e825) + (_e165 * _e827));
                    if _e258 {
                        let _e834 = (_e170 * 1.7701309f);
                        let _e836 = ((_e834 * _e830) * -0.1308997f);
                        let _e839 = ((_e176 + (_e177 * 192u)) + 320u);
                        let _e842 = coefs.member[_e839];
                        let _e848 = coefs.member[(_e839 + _e182)];
                        let _e854 = coefs.member[(_e839 + _e187)];
                        let _e858 = ((_e834 * _e833) * -0.1308997f);
                        let _e860 = ((_e176 + _e178) + 256u);
                        let _e862 = coefs.member[_e860];
                        let _e867 = coefs.member[(_e860 + _e182)];
                        let _e872 = coefs.member[(_e860 + _e187)];
                        phi_2297_ = array<f32, 3>(((_e823[0] + (_e842 * _e836)) + (_e862 * _e858)), ((_e823[1] + (_e848 * _e836)) + (_e867 * _e858)), ((_e823[2] + (_e854 * _e836)) + (_e872 * _e858)));
                        phi_2299_ = _e834;
                    } else {
                        phi_2297_ = _e823;
                        phi_2299_ = 0.5900436f;
                    }
                    let _e877 = phi_2297_;
                    let _e879 = phi_2299_;
                    let _e880 = select(0f, 0.5900436f, _e258);
                    if _e288 {
                        phi_2380_ = (((_e170 * 2.4874685f) * _e879) - (0.8291562f * _e880));
                    } else {
                        phi_2380_ = _e879;
                    }
                    let _e886 = phi_2380_;
                    let _e887 = select(_e880, _e879, _e288);
                    if _e296 {
                        let _e891 = (((_e170 * 2.3013682f) * _e886) - (0.9251849f * _e887));
                        let _e893 = ((_e891 * _e830) * 0.049087387f);
                        let _e895 = ((_e176 + _e178) + 704u);
                        let _e898 = coefs.member[_e895];
                        let _e904 = coefs.member[(_e895 + _e182)];
                        let _e910 = coefs.member[(_e895 + _e187)];
                        let _e914 = ((_e891 * _e833) * 0.049087387f);
                        let _e917 = ((_e176 + (_e177 * 192u)) + 576u);
                        let _e919 = coefs.member[_e917];
                        let _e924 = coefs.member[(_e917 + _e182)];
                        let _e929 = coefs.member[(_e917 + _e187)];
                        phi_2459_ = array<f32, 3>(((_e877[0] + (_e898 * _e893)) + (_e919 * _e914)), ((_e877[1] + (_e904 * _e893)) + (_e924 * _e914)), ((_e877[2] + (_e910 * _e893)) + (_e929 * _e914)));
                        phi_2461_ = _e891;
                    } else {
                        phi_2459_ = _e877;
                        phi_2461_ = _e886;
                    }
                    let _e934 = phi_2459_;
                    let _e936 = phi_2461_;
                    let _e937 = select(_e887, _e886, _e296);
                    if _e328 {
                        phi_2542_ = (((_e170 * 2.20794f) * _e936) - (0.9594032f * _e937));
                    } else {
                        phi_2542_ = _e936;
                    }
                    let _e943 = phi_2542_;
                    if _e336 {
                        let _e948 = (((_e170 * 2.1532216f) * _e943) - (0.9752174f * select(_e937, _e936, _e328)));
                        let _e950 = ((_e948 * _e830) * -0.024543693f);
                        let _e953 = ((_e176 + (_e177 * 192u)) + 1152u);
                        let _e956 = coefs.member[_e953];
                        let _e962 = coefs.member[(_e953 + _e182)];
                        let _e968 = coefs.member[(_e953 + _e187)];
                        let _e972 = ((_e948 * _e833) * -0.024543693f);
                        let _e974 = ((_e176 + _e178) + 1088u);
                        let _e976 = coefs.member[_e974];
                        let _e981 = coefs.member[(_e974 + _e182)];
                        let _e986 = coefs.member[(_e974 + _e187)];
                        phi_2621_ = array<f32, 3>(((_e934[0] + (_e956 * _e950)) + (_e976 * _e972)), ((_e934[1] + (_e962 * _e950)) + (_e981 * _e972)), ((_e934[2] + (_e968 * _e950)) + (_e986 * _e972)));
                    } else {
                        phi_2621_ = _e934;
                    }
                    let _e991 = phi_2621_;
                    phi_2703_ = _e991;
                    phi_2704_ = _e833;
                    phi_2705_ = _e830;
                } else {
                    phi_2703_ = _e823;
                    phi_2704_ = _e825;
                    phi_2705_ = _e827;
                }
                let _e993 = phi_2703_;
                let _e995 = phi_2704_;
                let _e997 = phi_2705_;
                if _e258 {
                    let _e1000 = ((_e161 * _e997) - (_e165 * _e995));
                    let _e1003 = ((_e161 * _e995) + (_e165 * _e997));
                    if _e258 {
                        let _e1004 = (_e1000 * -0.081921704f);
                        let _e1005 = (_e176 + 384u);
                        let _e1008 = coefs.member[_e1005];
                        let _e1014 = coefs.member[(_e1005 + _e182)];
                        let _e1020 = coefs.member[(_e1005 + _e187)];
                        let _e1023 = (_e1003 * -0.081921704f);
                        let _e1024 = (_e176 + 256u);
                        let _e1026 = coefs.member[_e1024];
                        let _e1031 = coefs.member[(_e1024 + _e182)];
                        let _e1036 = coefs.member[(_e1024 + _e187)];
                        phi_2790_ = array<f32, 3>(((_e993[0] + (_e1008 * _e1004)) + (_e1026 * _e1023)), ((_e993[1] + (_e1014 * _e1004)) + (_e1031 * _e1023)), ((_e993[2] + (_e1020 * _e1004)) + (_e1036 * _e1023)));
                    } else {
                        phi_2790_ = _e993;
                    }
                    let _e1041 = phi_2790_;
                    if _e288 {
                        phi_2869_ = (_e170 * 2.0756624f);
                    } else {
                        phi_2869_ = 0.6258357f;
                    }
                    let _e1044 = phi_2869_;
                    let _e1045 = select(0f, 0.6258357f, _e288);
                    if _e296 {
                        let _e1049 = (((_e170 * 2.6739483f) * _e1044) - (0.8062258f * _e1045));
                        let _e1051 = ((_e1049 * _e1000) * 0.049087387f);
                        let _e1053 = (_e176 + (_e177 * 128u));
                        let _e1054 = (_e1053 + 704u);
                        let _e1057 = coefs.member[_e1054];
                        let _e1063 = coefs.member[(_e1054 + _e182)];
                        let _e1069 = coefs.member[(_e1054 + _e187)];
                        let _e1073 = ((_e1049 * _e1003) * 0.049087387f);
                        let _e1074 = (_e1053 + 576u);
                        let _e1076 = coefs.member[_e1074];
                        let _e1081 = coefs.member[(_e1074 + _e182)];
                        let _e1086 = coefs.member[(_e1074 + _e187)];
                        phi_2948_ = array<f32, 3>(((_e1041[0] + (_e1057 * _e1051)) + (_e1076 * _e1073)), ((_e1041[1] + (_e1063 * _e1051)) + (_e1081 * _e1073)), ((_e1041[2] + (_e1069 * _e1051)) + (_e1086 * _e1073)));
                        phi_2950_ = _e1049;
                    } else {
                        phi_2948_ = _e1041;
                        phi_2950_ = _e1044;
                    }
                    let _e1091 = phi_2948_;
                    let _e1093 = phi_2950_;
                    let _e1094 = select(_e1045, _e1044, _e296);
                    if _e328 {
                        phi_3031_ = (((_e170 * 2.4308622f) * _e1093) - (0.90909094f * _e1094));
                    } else {
                        phi_3031_ = _e1093;
                    }
                    let _e1100 = phi_3031_;
                    if _e336 {
                        let _e1105 = (((_e170 * 2.304886f) * _e1100) - (0.9481764f * select(_e1094, _e1093, _e328)));
                        let _e1107 = ((_e1105 * _e1000) * -0.024543693f);
                        let _e1108 = (_e176 + 1216u);
                        let _e1111 = coefs.member[_e1108];
                        let _e1117 = coefs.member[(_e1108 + _e182)];
                        let _e1123 = coefs.member[(_e1108 + _e187)];
                        let _e1127 = ((_e1105 * _e1003) * -0.024543693f);
                        let _e1128 = (_e176 + 1088u);
                        let _e1130 = coefs.member[_e1128];
                        let _e1135 = coefs.member[(_e1128 + _e182)];
                        let _e1140 = coefs.member[(_e1128 + _e187)];
                        phi_3110_ = array<f32, 3>(((_e1091[0] + (_e1111 * _e1107)) + (_e1130 * _e1127)), ((_e1091[1] + (_e1117 * _e1107)) + (_e1135 * _e1127)), ((_e1091[2] + (_e1123 * _e1107)) + (_e1140 * _e1127)));
                    } else {
                        phi_3110_ = _e1091;
                    }
                    let _e1145 = phi_3110_;
                    phi_3192_ = _e1145;
                    phi_3193_ = _e1003;
                    phi_3194_ = _e1000;
                } else {
                    phi_3192_ = _e993;
                    phi_3193_ = _e995;
                    phi_3194_ = _e997;
                }
                let _e1147 = phi_3192_;
                let _e1149 = phi_3193_;
                let _e1151 = phi_3194_;
                if _e288 {
                    let _e1154 = ((_e161 * _e1151) - (_e165 * _e1149));
                    let _e1157 = ((_e161 * _e1149) + (_e165 * _e1151));
                    if _e296 {
                        let _e1158 = (_e170 * 2.3666193f);
                        let _e1160 = ((_e1158 * _e1154) * 0.049087387f);
                        let _e1163 = ((_e176 + (_e177 * 192u)) + 704u);
                        let _e1166 = coefs.member[_e1163];
                        let _e1172 = coefs.member[(_e1163 + _e182)];
                        let _e1178 = coefs.member[(_e1163 + _e187)];
                        let _e1182 = ((_e1158 * _e1157) * 0.049087387f);
                        let _e1184 = ((_e176 + _e178) + 576u);
                        let _e1186 = coefs.member[_e1184];
                        let _e1191 = coefs.member[(_e1184 + _e182)];
                        let _e1196 = coefs.member[(_e1184 + _e187)];
                        phi_3356_ = array<f32, 3>(((_e1147[0] + (_e1166 * _e1160)) + (_e1186 * _e1182)), ((_e1147[1] + (_e1172 * _e1160)) + (_e1191 * _e1182)), ((_e1147[2] + (_e1178 * _e1160)) + (_e1196 * _e1182)));
                        phi_3358_ = _e1158;
                    } else {
                        phi_3356_ = _e1147;
                        phi_3358_ = 0.6563821f;
                    }
                    let _e1201 = phi_3356_;
                    let _e1203 = phi_3358_;
                    let _e1204 = select(0f, 0.6563821f, _e296);
                    if _e328 {
                        phi_3439_ = (((_e170 * 2.8504386f) * _e1203) - (0.7905694f * _e1204));
                    } else {
                        phi_3439_ = _e1203;
                    }
                    let _e1210 = phi_3439_;
                    if _e336 {
                        let _e1215 = (((_e170 * 2.5570416f) * _e1210) - (0.8970695f * select(_e1204, _e1203, _e328)));
                        let _e1217 = ((_e1215 * _e1154) * -0.024543693f);
                        let _e1219 = ((_e176 + _e178) + 1216u);
                        let _e1222 = coefs.member[_e1219];
                        let _e1228 = coefs.member[(_e1219 + _e182)];
                        let _e1234 = coefs.member[(_e1219 + _e187)];
                        let _e1238 = ((_e1215 * _e1157) * -0.024543693f);
                        let _e1241 = ((_e176 + (_e177 * 192u)) + 1024u);
                        let _e1243 = coefs.member[_e1241];
                        let _e1248 = coefs.member[(_e1241 + _e182)];
                        let _e1253 = coefs.member[(_e1241 + _e187)];
                        phi_3518_ = array<f32, 3>(((_e1201[0] + (_e1222 * _e1217)) + (_e1243 * _e1238)), ((_e1201[1] + (_e1228 * _e1217)) + (_e1248 * _e1238)), ((_e1201[2] + (_e1234 * _e1217)) + (_e1253 * _e1238)));
                    } else {
                        phi_3518_ = _e1201;
                    }
                    let _e1258 = phi_3518_;
                    phi_3600_ = _e1258;
                    phi_3601_ = _e1157;
                    phi_3602_ = _e1154;
                } else {
                    phi_3600_ = _e1147;
                    phi_3601_ = _e1149;
                    phi_3602_ = _e1151;
                }
                let _e1260 = phi_3600_;
                let _e1262 = phi_3601_;
                let _e1264 = phi_3602_;
                if _e296 {
                    let _e1267 = ((_e161 * _e1264) - (_e165 * _e1262));
                    let _e1270 = ((_e161 * _e1262) + (_e165 * _e1264));
                    if _e296 {
                        let _e1271 = (_e1267 * 0.033535723f);
                        let _e1272 = (_e176 + 768u);
                        let _e1275 = coefs.member[_e1272];
                        let _e1281 = coefs.member[(_e1272 + _e182)];
                        let _e1287 = coefs.member[(_e1272 + _e187)];
                        let _e1290 = (_e1270 * 0.033535723f);
                        let _e1291 = (_e176 + 576u);
                        let _e1293 = coefs.member[_e1291];
                        let _e1298 = coefs.member[(_e1291 + _e182)];
                        let _e1303 = coefs.member[(_e1291 + _e187)];
                        phi_3687_ = array<f32, 3>(((_e1260[0] + (_e1275 * _e1271)) + (_e1293 * _e1290)), ((_e1260[1] + (_e1281 * _e1271)) + (_e1298 * _e1290)), ((_e1260[2] + (_e1287 * _e1271)) + (_e1303 * _e1290)));
                    } else {
                        phi_3687_ = _e1260;
                    }
                    let _e1308 = phi_3687_;
                    if _e328 {
                        phi_3766_ = (_e170 * 2.6459606f);
                    } else {
                        phi_3766_ = 0.6831841f;
                    }
                    let _e1311 = phi_3766_;
                    if _e336 {
                        let _e1316 = (((_e170 * 3.0178044f) * _e1311) - (0.7791937f * select(0f, 0.6831841f, _e328)));
                        let _e1318 = ((_e1316 * _e1267) * -0.024543693f);
                        let _e1320 = (_e176 + (_e177 * 128u));
                        let _e1321 = (_e1320 + 1216u);
                        let _e1324 = coefs.member[_e1321];
                        let _e1330 = coefs.member[(_e1321 + _e182)];
                        let _e1336 = coefs.member[(_e1321 + _e187)];
                        let _e1340 = ((_e1316 * _e1270) * -0.024543693f);
                        let _e1341 = (_e1320 + 1024u);
                        let _e1343 = coefs.member[_e1341];
                        let _e1348 = coefs.member[(_e1341 + _e182)];
                        let _e1353 = coefs.member[(_e1341 + _e187)];
                        phi_3845_ = array<f32, 3>(((_e1308[0] + (_e1324 * _e1318)) + (_e1343 * _e1340)), ((_e1308[1] + (_e1330 * _e1318)) + (_e1348 * _e1340)), ((_e1308[2] + (_e1336 * _e1318)) + (_e1353 * _e1340)));
                    } else {
                        phi_3845_ = _e1308;
                    }
                    let _e1358 = phi_3845_;
                    phi_3927_ = _e1358;
                    phi_3928_ = _e1270;
                    phi_3929_ = _e1267;
                } else {
                    phi_3927_ = _e1260;
                    phi_3928_ = _e1262;
                    phi_3929_ = _e1264;
                }
                let _e1360 = phi_3927_;
                let _e1362 = phi_3928_;
                let _e1364 = phi_3929_;
                if _e328 {
                    let _e1367 = ((_e161 * _e1364) - (_e165 * _e1362));
                    let _e1370 = ((_e161 * _e1362) + (_e165 * _e1364));
                    if _e336 {
                        let _e1371 = (_e170 * 2.9157066f);
                        let _e1373 = ((_e1371 * _e1367) * -0.024543693f);
                        let _e1376 = ((_e176 + (_e177 * 192u)) + 1216u);
                        let _e1379 = coefs.member[_e1376];
                        let _e1385 = coefs.member[(_e1376 + _e182)];
                        let _e1391 = coefs.member[(_e1376 + _e187)];
                        let _e1395 = ((_e1371 * _e1370) * -0.024543693f);
                        let _e1397 = ((_e176 + _e178) + 1024u);
                        let _e1399 = coefs.member[_e1397];
                        let _e1404 = coefs.member[(_e1397 + _e182)];
                        let _e1409 = coefs.member[(_e1397 + _e187)];
                        phi_4091_ = array<f32, 3>(((_e1360[0] + (_e1379 * _e1373)) + (_e1399 * _e1395)), ((_e1360[1] + (_e1385 * _e1373)) + (_e1404 * _e1395)), ((_e1360[2] + (_e1391 * _e1373)) + (_e1409 * _e1395)));
                    } else {
                        phi_4091_ = _e1360;
                    }
                    let _e1414 = phi_4091_;
                    phi_4173_ = _e1414;
                    phi_4174_ = _e1370;
                    phi_4175_ = _e1367;
                } else {
                    phi_4173_ = _e1360;
                    phi_4174_ = _e1362;
                    phi_4175_ = _e1364;
                }
                let _e1416 = phi_4173_;
                let _e1418 = phi_4174_;
                let _e1420 = phi_4175_;
                if _e336 {
                    if _e336 {
                        let _e1427 = (((_e161 * _e1420) - (_e165 * _e1418)) * -0.017890552f);
                        let _e1428 = (_e176 + 1280u);
                        let _e1431 = coefs.member[_e1428];
                        let _e1437 = coefs.member[(_e1428 + _e182)];
                        let _e1443 = coefs.member[(_e1428 + _e187)];
                        let _e1446 = (((_e161 * _e1418) + (_e165 * _e1420)) * -0.017890552f);
                        let _e1447 = (_e176 + 1024u);
                        let _e1449 = coefs.member[_e1447];
                        let _e1454 = coefs.member[(_e1447 + _e182)];
                        let _e1459 = coefs.member[(_e1447 + _e187)];
                        phi_4260_ = array<f32, 3>(((_e1416[0] + (_e1431 * _e1427)) + (_e1449 * _e1446)), ((_e1416[1] + (_e1437 * _e1427)) + (_e1454 * _e1446)), ((_e1416[2] + (_e1443 * _e1427)) + (_e1459 * _e1446)));
                    } else {
                        phi_4260_ = _e1416;
                    }
                    let _e1464 = phi_4260_;
                    phi_4338_ = _e1464;
                } else {
                    phi_4338_ = _e1416;
                }
                let _e1466 = phi_4338_;
                let _e1469 = params.member.member_3;
                local = array<f32, 3>((_e1466[0] * _e1469), (_e1466[1] * _e1469), (_e1466[2] * _e1469));
                phi_4442_ = type_13(0u, 3u);
                loop {
                    let _e1478 = phi_4442_;
                    if (_e1478.member < _e1478.member_1) {
                        phi_4443_ = type_13((_e1478.member + 1u), _e1478.member_1);
                        phi_4466_ = type_13(1u, _e1478.member);
                    } else {
                        phi_4443_ = _e1478;
                        phi_4466_ = type_13(0u, type_13().member_1);
                    }
                    let _e1491 = phi_4443_;
                    let _e1493 = phi_4466_;
                    let _e1497 = (bitcast<i32>(_e1493.member) != 0i);
                    if _e1497 {
                        if (_e1493.member_1 < 3u) {
                        } else {
                            phi_4496_ = true;
                            break;
                        }
                        let _e1500 = local[_e1493.member_1];
                        let _e1502 = ((_e1493.member_1 * _e133) + _e137);
                        if (_e1502 < arrayLength((&irradiance.member))) {
                        } else {
                            phi_4496_ = true;
                            break;
                        }
                        irradiance.member[_e1502] = _e1500;
                    }
                    continue;
                    continuing {
                        phi_4442_ = _e1491;
                        phi_4496_ = false;
                        break if !(_e1497);
                    }
                }
                let _e1508 = phi_4496_;
                if _e1508 {
                    break;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_irradiance(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
