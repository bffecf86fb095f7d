struct type_5 {
    member: array<f32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: f32,
}

struct type_13 {
    member: type_12,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_13;
@group(0) @binding(1) 
var<storage> coefs: type_5;
@group(0) @binding(2) 
var<storage> normals: type_5;
@group(0) @binding(3) 
var<storage, read_write> irradiance: type_5;

fn function_() {
    var phi_194_: u32;
    var phi_256_: u32;
    var phi_275_: u32;
    var phi_389_: array<f32, 3>;
    var phi_391_: f32;
    var phi_434_: array<f32, 3>;
    var phi_436_: f32;
    var phi_481_: f32;
    var phi_524_: array<f32, 3>;
    var phi_526_: f32;
    var phi_571_: f32;
    var phi_614_: array<f32, 3>;
    var phi_616_: f32;
    var phi_661_: f32;
    var phi_704_: array<f32, 3>;
    var phi_829_: array<f32, 3>;
    var phi_906_: array<f32, 3>;
    var phi_908_: f32;
    var phi_989_: f32;
    var phi_1068_: array<f32, 3>;
    var phi_1070_: f32;
    var phi_1151_: f32;
    var phi_1230_: array<f32, 3>;
    var phi_1232_: f32;
    var phi_1313_: f32;
    var phi_1392_: array<f32, 3>;
    var phi_1474_: array<f32, 3>;
    var phi_1559_: array<f32, 3>;
    var phi_1638_: f32;
    var phi_1717_: array<f32, 3>;
    var phi_1719_: f32;
    var phi_1800_: f32;
    var phi_1879_: array<f32, 3>;
    var phi_1881_: f32;
    var phi_1962_: f32;
    var phi_2041_: array<f32, 3>;
    var phi_2123_: array<f32, 3>;
    var phi_2124_: f32;
    var phi_2125_: f32;
    var phi_2287_: array<f32, 3>;
    var phi_2289_: f32;
    var phi_2370_: f32;
    var phi_2449_: array<f32, 3>;
    var phi_2451_: f32;
    var phi_2532_: f32;
    var phi_2611_: array<f32, 3>;
    var phi_2693_: array<f32, 3>;
    var phi_2694_: f32;
    var phi_2695_: f32;
    var phi_2780_: array<f32, 3>;
    var phi_2859_: f32;
    var phi_2938_: array<f32, 3>;
    var phi_2940_: f32;
    var phi_3021_: f32;
    var phi_3100_: array<f32, 3>;
    var phi_3182_: array<f32, 3>;
    var phi_3183_: f32;
    var phi_3184_: f32;
    var phi_3346_: array<f32, 3>;
    var phi_3348_: f32;
    var phi_3429_: f32;
    var phi_3508_: array<f32, 3>;
    var phi_3590_: array<f32, 3>;
    var phi_3591_: f32;
    var phi_3592_: f32;
    var phi_3677_: array<f32, 3>;
    var phi_3756_: f32;
    var phi_3835_: array<f32, 3>;
    var phi_3917_: array<f32, 3>;
    var phi_3918_: f32;
    var phi_3919_: f32;
    var phi_4081_: array<f32, 3>;
    var phi_4163_: array<f32, 3>;
    var phi_4164_: f32;
    var phi_4165_: f32;
    var phi_4250_: array<f32, 3>;
    var phi_4328_: array<f32, 3>;

    let _e113 = gid_1;
    let _e117 = params.member.member;
    let _e118 = (_e117 / 64u);
    let _e120 = ((_e117 % 64u) > 0u);
    if _e120 {
        phi_194_ = (_e118 + 1u);
    } else {
        phi_194_ = _e118;
    }
    let _e123 = phi_194_;
    let _e124 = (_e123 * 64u);
    let _e128 = (_e113.x + (_e113.y * 2097152u));
    if (_e128 < _e124) {
        let _e131 = ((_e128 / 64u) * 64u);
        let _e135 = params.member.member_2;
        if _e120 {
            phi_256_ = (_e118 + 1u);
        } else {
            phi_256_ = _e118;
        }
        let _e140 = phi_256_;
        let _e141 = (select(_e135, 9u, (_e135 > 9u)) + 1u);
        let _e142 = (_e141 * _e141);
        let _e143 = (_e142 / 4u);
        if ((_e142 % 4u) > 0u) {
            phi_275_ = (_e143 + 1u);
        } else {
            phi_275_ = _e143;
        }
        let _e148 = phi_275_;
        let _e152 = normals.member[_e128];
        let _e156 = normals.member[((_e140 * 64u) + _e128)];
        let _e161 = normals.member[((_e140 * 128u) + _e128)];
        let _e167 = (((((_e131 / 64u) * _e148) * 64u) + (_e131 % 64u)) + (_e128 - _e131));
        let _e168 = (_e140 * _e148);
        let _e169 = (_e168 * 64u);
        let _e171 = coefs.member[_e167];
        let _e172 = (_e171 * 0.886227f);
        let _e173 = (_e168 * 256u);
        let _e176 = coefs.member[(_e167 + _e173)];
        let _e177 = (_e176 * 0.886227f);
        let _e178 = (_e168 * 512u);
        let _e181 = coefs.member[(_e167 + _e178)];
        let _e182 = (_e181 * 0.886227f);
        let _e184 = (1u <= _e135);
        if _e184 {
            let _e186 = (_e161 * 1.0233268f);
            let _e188 = (_e167 + (_e168 * 128u));
            let _e190 = coefs.member[_e188];
            let _e195 = coefs.member[(_e188 + _e173)];
            let _e200 = coefs.member[(_e188 + _e178)];
            phi_389_ = array<f32, 3>((_e172 + (_e190 * _e186)), (_e177 + (_e195 * _e186)), (_e182 + (_e200 * _e186)));
            phi_391_ = (_e161 * 0.48860252f);
        } else {
            phi_389_ = array<f32, 3>(_e172, _e177, _e182);
            phi_391_ = 0.2820948f;
        }
        let _e205 = phi_389_;
        let _e207 = phi_391_;
        let _e208 = select(0f, 0.2820948f, _e184);
        let _e209 = (2u <= _e135);
        if _e209 {
            let _e213 = (((_e161 * 1.9364917f) * _e207) - (1.118034f * _e208));
            let _e214 = (_e213 * 0.7853982f);
            let _e217 = ((_e167 + (_e168 * 128u)) + 64u);
            let _e220 = coefs.member[_e217];
            let _e226 = coefs.member[(_e217 + _e173)];
            let _e232 = coefs.member[(_e217 + _e178)];
            phi_434_ = array<f32, 3>((_e205[0] + (_e220 * _e214)), (_e205[1] + (_e226 * _e214)), (_e205[2] + (_e232 * _e214)));
            phi_436_ = _e213;
        } else {
            phi_434_ = _e205;
            phi_436_ = _e207;
        }
        let _e237 = phi_434_;
        let _e239 = phi_436_;
        let _e240 = select(_e208, _e207, _e209);
        let _e241 = (3u <= _e135);
        if _e241 {
            phi_481_ = (((_e161 * 1.9720266f) * _e239) - (1.0183501f * _e240));
        } else {
            phi_481_ = _e239;
        }
        let _e247 = phi_481_;
        let _e248 = select(_e240, _e239, _e241);
        let _e249 = (4u <= _e135);
        if _e249 {
            let _e253 = (((_e161 * 1.9843135f) * _e247) - (1.0062306f * _e248));
            let _e254 = (_e253 * -0.1308997f);
            let _e255 = (_e167 + 320u);
            let _e258 = coefs.member[_e255];
            let _e264 = coefs.member[(_e255 + _e173)];
            let _e270 = coefs.member[(_e255 + _e178)];
            phi_524_ = array<f32, 3>((_e237[0] + (_e258 * _e254)), (_e237[1] + (_e264 * _e254)), (_e237[2] + (_e270 * _e254)));
            phi_526_ = _e253;
        } else {
            phi_524_ = _e237;
            phi_526_ = _e247;
        }
        let _e275 = phi_524_;
        let _e277 = phi_526_;
        let _e278 = select(_e248, _e247, _e249);
        let _e279 = (5u <= _e135);
        if _e279 {
            phi_571_ = (((_e161 * 1.9899749f) * _e277) - (1.002853f * _e278));
        } else {
            phi_571_ = _e277;
        }
        let _e285 = phi_571_;
        let _e286 = select(_e278, _e277, _e279);
        let _e287 = (6u <= _e135);
        if _e287 {
            let _e291 = (((_e161 * 1.9930434f) * _e285) - (1.001542f * _e286));
            let _e292 = (_e291 * 0.049087387f);
            let _e295 = ((_e167 + (_e168 * 128u)) + 640u);
            let _e298 = coefs.member[_e295];
            let _e304 = coefs.member[(_e295 + _e173)];
            let _e310 = coefs.member[(_e295 + _e178)];
            phi_614_ = array<f32, 3>((_e275[0] + (_e298 * _e292)), (_e275[1] + (_e304 * _e292)), (_e275[2] + (_e310 * _e292)));
            phi_616_ = _e291;
        } else {
            phi_614_ = _e275;
            phi_616_ = _e285;
        }
        let _e315 = phi_614_;
        let _e317 = phi_616_;
        let _e318 = select(_e286, _e285, _e287);
        let _e319 = (7u <= _e135);
        if _e319 {
            phi_661_ = (((_e161 * 1.9948914f) * _e317) - (1.0009272f * _e318));
        } else {
            phi_661_ = _e317;
        }
        let _e325 = phi_661_;
        let _e327 = (8u <= _e135);
        if _e327 {
            let _e332 = ((((_e161 * 1.9960899f) * _e325) - (1.0006008f * select(_e318, _e317, _e319))) * -0.024543693f);
            let _e333 = (_e167 + 1152u);
            let _e336 = coefs.member[_e333];
            let _e342 = coefs.member[(_e333 + _e173)];
            let _e348 = coefs.member[(_e333 + _e178)];
            phi_704_ = array<f32, 3>((_e315[0] + (_e336 * _e332)), (_e315[1] + (_e342 * _e332)), (_e315[2] + (_e348 * _e332)));
        } else {
            phi_704_ = _e315;
        }
        let _e353 = phi_704_;
        if _e184 {
            if _e184 {
                let _e354 = (_e152 * 1.0233268f);
                let _e356 = (_e167 + (_e168 * 192u));
                let _e359 = coefs.member[_e356];
                let _e365 = coefs.member[(_e356 + _e173)];
                let _e371 = coefs.member[(_e356 + _e178)];
                let _e374 = (_e156 * 1.0233268f);
                let _e375 = (_e167 + _e169);
                let _e377 = coefs.member[_e375];
                let _e382 = coefs.member[(_e375 + _e173)];
                let _e387 = coefs.member[(_e375 + _e178)];
                phi_829_ = array<f32, 3>(((_e353[0] + (_e359 * _e354)) + (_e377 * _e374)), ((_e353[1] + (_e365 * _e354)) + (_e382 * _e374)), ((_e353[2] + (_e371 * _e354)) + (_e387 * _e374)));
            } else {
                phi_829_ = _e353;
            }
            let _e392 = phi_829_;
            if _e209 {
                let _e393 = (_e161 * 1.0925485f);
                let _e395 = ((_e393 * _e152) * 0.7853982f);
                let _e398 = ((_e167 + (_e168 * 192u)) + 64u);
                let _e401 = coefs.member[_e398];
                let _e407 = coefs.member[(_e398 + _e173)];
                let _e413 = coefs.member[(_e398 + _e178)];
                let _e417 = ((_e393 * _e156) * 0.7853982f);
                let _e419 = ((_e167 + _e169) + 64u);
                let _e421 = coefs.member[_e419];
                let _e426 = coefs.member[(_e419 + _e173)];
                let _e431 = coefs.member[(_e419 + _e178)];
                phi_906_ = array<f32, 3>(((_e392[0] + (_e401 * _e395)) + (_e421 * _e417)), ((_e392[1] + (_e407 * _e395)) + (_e426 * _e417)), ((_e392[2] + (_e413 * _e395)) + (_e431 * _e417)));
                phi_908_ = _e393;
            } else {
                phi_906_ = _e392;
                phi_908_ = 0.48860252f;
            }
            let _e436 = phi_906_;
            let _e438 = phi_908_;
            let _e439 = select(0f, 0.48860252f, _e209);
            if _e241 {
                phi_989_ = (((_e161 * 2.09165f) * _e438) - (0.9354144f * _e439));
            } else {
                phi_989_ = _e438;
            }
            let _e445 = phi_989_;
            let _e446 = select(_e439, _e438, _e241);
            if _e249 {
                let _e450 = (((_e161 * 2.04939f) * _e445) - (0.9797959f * _e446));
                let _e452 = ((_e450 * _e152) * -0.1308997f);
                let _e454 = ((_e167 + _e169) + 320u);
                let _e457 = coefs.member[_e454];
                let _e463 = coefs.member[(_e454 + _e173)];
                let _e469 = coefs.member[(_e454 + _e178)];
                let _e473 = ((_e450 * _e156) * -0.1308997f);
                let _e476 = ((_e167 + (_e168 * 192u)) + 256u);
                let _e478 = coefs.member[_e476];
                let _e483 = coefs.member[(_e476 + _e173)];
                let _e488 = coefs.member[(_e476 + _e178)];
                phi_1068_ = array<f32, 3>(((_e436[0] + (_e457 * _e452)) + (_e478 * _e473)), ((_e436[1] + (_e463 * _e452)) + (_e483 * _e473)), ((_e436[2] + (_e469 * _e452)) + (_e488 * _e473)));
                phi_1070_ = _e450;
            } else {
                phi_1068_ = _e436;
                phi_1070_ = _e445;
            }
            let _e493 = phi_1068_;
            let _e495 = phi_1070_;
            let _e496 = select(_e446, _e445, _e249);
            if _e279 {
                phi_1151_ = (((_e161 * 2.0310097f) * _e495) - (0.9910312f * _e496));
            } else {
                phi_1151_ = _e495;
            }
            let _e502 = phi_1151_;
            let _e503 = select(_e496, _e495, _e279);
            if _e287 {
                let _e507 = (((_e161 * 2.021315f) * _e502) - (0.9952267f * _e503));
                let _e509 = ((_e507 * _e152) * 0.049087387f);
                let _e512 = ((_e167 + (_e168 * 192u)) + 640u);
                let _e515 = coefs.member[_e512];
                let _e521 = coefs.member[(_e512 + _e173)];
                let _e527 = coefs.member[(_e512 + _e178)];
                let _e531 = ((_e507 * _e156) * 0.049087387f);
                let _e533 = ((_e167 + _e169) + 640u);
                let _e535 = coefs.member[_e533];
                let _e540 = coefs.member[(_e533 + _e173)];
                let _e545 = coefs.member[(_e533 + _e178)];
                phi_1230_ = array<f32, 3>(((_e493[0] + (_e515 * _e509)) + (_e535 * _e531)), ((_e493[1] + (_e521 * _e509)) + (_e540 * _e531)), ((_e493[2] + (_e527 * _e509)) + (_e545 * _e531)));
                phi_1232_ = _e507;
            } else {
                phi_1230_ = _e493;
                phi_1232_ = _e502;
            }
            let _e550 = phi_1230_;
            let _e552 = phi_1232_;
            let _e553 = select(_e503, _e502, _e287);
            if _e319 {
                phi_1313_ = (((_e161 * 2.0155644f) * _e552) - (0.9971551f * _e553));
            } else {
                phi_1313_ = _e552;
            }
            let _e559 = phi_1313_;
            if _e327 {
                let _e564 = (((_e161 * 2.0118694f) * _e559) - (0.9981668f * select(_e553, _e552, _e319)));
                let _e566 = ((_e564 * _e152) * -0.024543693f);
                let _e568 = ((_e167 + _e169) + 1152u);
                let _e571 = coefs.member[_e568];
                let _e577 = coefs.member[(_e568 + _e173)];
                let _e583 = coefs.member[(_e568 + _e178)];
                let _e587 = ((_e564 * _e156) * -0.024543693f);
                let _e590 = ((_e167 + (_e168 * 192u)) + 1088u);
                let _e592 = coefs.member[_e590];
                let _e597 = coefs.member[(_e590 + _e173)];
                let _e602 = coefs.member[(_e590 + _e178)];
                phi_1392_ = array<f32, 3>(((_e550[0] + (_e571 * _e566)) + (_e592 * _e587)), ((_e550[1] + (_e577 * _e566)) + (_e597 * _e587)), ((_e550[2] + (_e583 * _e566)) + (_e602 * _e587)));
            } else {
                phi_1392_ = _e550;
            }
            let _e607 = phi_1392_;
            phi_1474_ = _e607;
        } else {
            phi_1474_ = _e353;
        }
        let _e609 = phi_1474_;
        if _e209 {
            let _e612 = ((_e152 * _e152) - (_e156 * _e156));
            let _e614 = (_e152 * (_e156 + _e156));
            if _e209 {
                let _e615 = (_e612 * 0.4290428f);
                let _e616 = (_e167 + 128u);
                let _e619 = coefs.member[_e616];
                let _e625 = coefs.member[(_e616 + _e173)];
                let _e631 = coefs.member[(_e616 + _e178)];
                let _e634 = (_e614 * 0.4290428f);
                let _e635 = (_e167 + 64u);
                let _e637 = coefs.member[_e635];
                let _e642 = coefs.member[(_e635 + _e173)];
                let _e647 = coefs.member[(_e635 + _e178)];
                phi_1559_ = array<f32, 3>(((_e609[0] + (_e619 * _e615)) + (_e637 * _e634)), ((_e609[1] + (_e625 * _e615)) + (_e642 * _e634)), ((_e609[2] + (_e631 * _e615)) + (_e647 * _e634)));
            } else {
                phi_1559_ = _e609;
            }
            let _e652 = phi_1559_;
            if _e241 {
                phi_1638_ = (_e161 * 1.4453057f);
            } else {
                phi_1638_ = 0.54627424f;
            }
            let _e655 = phi_1638_;
            let _e656 = select(0f, 0.54627424f, _e241);
            if _e249 {
                let _e660 = (((_e161 * 2.291288f) * _e655) - (0.8660254f * _e656));
                let _e662 = ((_e660 * _e612) * -0.1308997f);
                let _e664 = (_e167 + (_e168 * 128u));
                let _e665 = (_e664 + 320u);
                let _e668 = coefs.member[_e665];
                let _e674 = coefs.member[(_e665 + _e173)];
                let _e680 = coefs.member[(_e665 + _e178)];
                let _e684 = ((_e660 * _e614) * -0.1308997f);
                let _e685 = (_e664 + 256u);
                let _e687 = coefs.member[_e685];
                let _e692 = coefs.member[(_e685 + _e173)];
                let _e697 = coefs.member[(_e685 + _e178)];
                phi_1717_ = array<f32, 3>(((_e652[0] + (_e668 * _e662)) + (_e687 * _e684)), ((_e652[1] + (_e674 * _e662)) + (_e692 * _e684)), ((_e652[2] + (_e680 * _e662)) + (_e697 * _e684)));
                phi_1719_ = _e660;
            } else {
                phi_1717_ = _e652;
                phi_1719_ = _e655;
            }
            let _e702 = phi_1717_;
            let _e704 = phi_1719_;
            let _e705 = select(_e656, _e655, _e249);
            if _e279 {
                phi_1800_ = (((_e161 * 2.1712406f) * _e704) - (0.9476071f * _e705));
            } else {
                phi_1800_ = _e704;
            }
            let _e711 = phi_1800_;
            let _e712 = select(_e705, _e704, _e279);
            if _e287 {
                let _e716 = (((_e161 * 2.113942f) * _e711) - (0.9736101f * _e712));
                let _e718 = ((_e716 * _e612) * 0.049087387f);
                let _e719 = (_e167 + 704u);
                let _e722 = coefs.member[_e719];
                let _e728 = coefs.member[(_e719 + _e173)];
                let _e734 = coefs.member[(_e719 + _e178)];
                let _e738 = ((_e716 * _e614) * 0.049087387f);
                let _e739 = (_e167 + 640u);
                let _e741 = coefs.member[_e739];
                let _e746 = coefs.member[(_e739 + _e173)];
                let _e751 = coefs.member[(_e739 + _e178)];
                phi_1879_ = array<f32, 3>(((_e702[0] + (_e722 * _e718)) + (_e741 * _e738)), ((_e702[1] + (_e728 * _e718)) + (_e746 * _e738)), ((_e702[2] + (_e734 * _e718)) + (_e751 * _e738)));
                phi_1881_ = _e716;
            } else {
                phi_1879_ = _e702;
                phi_1881_ = _e711;
            }
            let _e756 = phi_1879_;
            let _e758 = phi_1881_;
            let _e759 = select(_e712, _e711, _e287);
            if _e319 {
                phi_1962_ = (((_e161 * 2.081666f) * _e758) - (0.9847319f * _e759));
            } else {
                phi_1962_ = _e758;
            }
            let _e765 = phi_1962_;
            if _e327 {
                let _e770 = (((_e161 * 2.0615528f) * _e765) - (0.9903379f * select(_e759, _e758, _e319)));
                let _e772 = ((_e770 * _e612) * -0.024543693f);
                let _e774 = (_e167 + (_e168 * 128u));
                let _e775 = (_e774 + 1152u);
                let _e778 = coefs.member[_e775];
                let _e784 = coefs.member[(_e775 + _e173)];
                let _e790 = coefs.member[(_e775 + _e178)];
                let _e794 = ((_e770 * _e614) * -0.024543693f);
                let _e795 = (_e774 + 1088u);
                let _e797 = coefs.member[_e795];
                let _e802 = coefs.member[(_e795 + _e173)];
                let _e807 = coefs.member[(_e795 + _e178)];
                phi_2041_ = array<f32, 3>(((_e756[0] + (_e778 * _e772)) + (_e797 * _e794)), ((_e756[1] + (_e784 * _e772)) + (_e802 * _e794)), ((_e756[2] + (_e790 * _e772)) + (_e807 * _e794)));
            } else {
                phi_2041_ = _e756;
            }
            let _e812 = phi_2041_;
            phi_2123_ = _e812;
            phi_2124_ = _e614;
            phi_2125_ = _e612;
        } else {
            phi_2123_ = _e609;
            phi_2124_ = _e156;
            phi_2125_ = _e152;
        }
        let _e814 = phi_2123_;
        let _e816 = phi_2124_;
        let _e818 = phi_2125_;
        if _e241 {
            let _e821 = ((_e152 * _e818) - (_e156 * _e816));
            let _e824 = ((_e152 * _e816) + (_e156 * _e818));
            if _e249 {
                let _e825 = (_e161 * 1.7701309f);
                let _e827 = ((_e825 * _e821) * -0.1308997f);
                let _e830 = ((_e167 + (_e168 * 192u)) + 320u);
                let _e833 = coefs.member[_e830];
                let _e839 = coefs.member[(_e830 + _e173)];
                let _e845 = coefs.member[(_e830 + _e178)];
                let _e849 = ((_e825 * _e824) * -0.1308997f);
                let _e851 = ((_e167 + _e169) + 256u);
                let _e853 = coefs.member[_e851];
                let _e858 = coefs.member[(_e851 + _e173)];
                let _e863 = coefs.member[(_e851 + _e178)];
                phi_2287_ = array<f32, 3>(((_e814[0] + (_e833 * _e827)) + (_e853 * _e849)), ((_e814[1] + (_e839 * _e827)) + (_e858 * _e849)), ((_e814[2] + (_e845 * _e827)) + (_e863 * _e849)));
                phi_2289_ = _e825;
            } else {
                phi_2287_ = _e814;
                phi_2289_ = 0.5900436f;
            }
            let _e868 = phi_2287_;
            let _e870 = phi_2289_;
            let _e871 = select(0f, 0.5900436f, _e249);
            if _e279 {
                phi_2370_ = (((_e161 * 2.4874685f) * _e870) - (0.8291562f * _e871));
            } else {
                phi_2370_ = _e870;
            }
            let _e877 = phi_2370_;
            let _e878 = select(_e871, _e870, _e279);
            if _e287 {
                let _e882 = (((_e161 * 2.3013682f) * _e877) - (0.9251849f * _e878));
                let _e884 = ((_e882 * _e821) * 0.049087387f);
                let _e886 = ((_e167 + _e169) + 704u);
                let _e889 = coefs.member[_e886];
                let _e895 = coefs.member[(_e886 + _e173)];
                let _e901 = coefs.member[(_e886 + _e178)];
                let _e905 = ((_e882 * _e824) * 0.049087387f);
                let _e908 = ((_e167 + (_e168 * 192u)) + 576u);
                let _e910 = coefs.member[_e908];
                let _e915 = coefs.member[(_e908 + _e173)];
                let _e920 = coefs.member[(_e908 + _e178)];
                phi_2449_ = array<f32, 3>(((_e868[0] + (_e889 * _e884)) + (_e910 * _e905)), ((_e868[1] + (_e895 * _e884)) + (_e915 * _e905)), ((_e868[2] + (_e901 * _e884)) + (_e920 * _e905)));
                phi_2451_ = _e882;
            } else {
                phi_2449_ = _e868;
                phi_2451_ = _e877;
            }
            let _e925 = phi_2449_;
            let _e927 = phi_2451_;
            let _e928 = select(_e878, _e877, _e287);
            if _e319 {
                phi_2532_ = (((_e161 * 2.20794f) * _e927) - (0.9594032f * _e928));
            } else {
                phi_2532_ = _e927;
            }
            let _e934 = phi_2532_;
            if _e327 {
                let _e939 = (((_e161 * 2.1532216f) * _e934) - (0.9752174f * select(_e928, _e927, _e319)));
                let _e941 = ((_e939 * _e821) * -0.024543693f);
                let _e944 = ((_e167 + (_e168 * 192u)) + 1152u);
                let _e947 = coefs.member[_e944];
                let _e953 = coefs.member[(_e944 + _e173)];
                let _e959 = coefs.member[(_e944 + _e178)];
                let _e963 = ((_e939 * _e824) * -0.024543693f);
                let _e965 = ((_e167 + _e169) + 1088u);
                let _e967 = coefs.member[_e965];
                let _e972 = coefs.member[(_e965 + _e173)];
                let _e977 = coefs.member[(_e965 + _e178)];
                phi_2611_ = array<f32, 3>(((_e925[0] + (_e947 * _e941)) + (_e967 * _e963)), ((_e925[1] + (_e953 * _e941)) + (_e972 * _e963)), ((_e925[2] + (_e959 * _e941)) + (_e977 * _e963)));
            } else {
                phi_2611_ = _e925;
            }
            let _e982 = phi_2611_;
            phi_2693_ = _e982;
            phi_2694_ = _e824;
            phi_2695_ = _e821;
        } else {
            phi_2693_ = _e814;
            phi_2694_ = _e816;
            phi_2695_ = _e818;
        }
        let _e984 = phi_2693_;
        let _e986 = phi_2694_;
        let _e988 = phi_2695_;
        if _e249 {
            let _e991 = ((_e152 * _e988) - (_e156 * _e986));
            let _e994 = ((_e152 * _e986) + (_e156 * _e988));
            if _e249 {
                let _e995 = (_e991 * -0.081921704f);
                let _e996 = (_e167 + 384u);
                let _e999 = coefs.member[_e996];
                let _e1005 = coefs.member[(_e996 + _e173)];
                let _e1011 = coefs.member[(_e996 + _e178)];
                let _e1014 = (_e994 * -0.081921704f);
                let _e1015 = (_e167 + 256u);
                let _e1017 = coefs.member[_e1015];
                let _e1022 = coefs.member[(_e1015 + _e173)];
                let _e1027 = coefs.member[(_e1015 + _e178)];
                phi_2780_ = array<f32, 3>(((_e984[0] + (_e999 * _e995)) + (_e1017 * _e1014)), ((_e984[1] + (_e1005 * _e995)) + (_e1022 * _e1014)), ((_e984[2] + (_e1011 * _e995)) + (_e1027 * _e1014)));
            } else {
                phi_2780_ = _e984;
            }
            let _e1032 = phi_2780_;
            if _e279 {
                phi_2859_ = (_e161 * 2.0756624f);
            } else {
                phi_2859_ = 0.6258357f;
            }
            let _e1035 = phi_2859_;
            let _e1036 = select(0f, 0.6258357f, _e279);
            if _e287 {
                let _e1040 = (((_e161 * 2.6739483f) * _e1035) - (0.8062258f * _e1036));
                let _e1042 = ((_e1040 * _e991) * 0.049087387f);
                let _e1044 = (_e167 + (_e168 * 128u));
                let _e1045 = (_e1044 + 704u);
                let _e1048 = coefs.member[_e1045];
                let _e1054 = coefs.member[(_e1045 + _e173)];
                let _e1060 = coefs.member[(_e1045 + _e178)];
                let _e1064 = ((_e1040 * _e994) * 0.049087387f);
                let _e1065 = (_e1044 + 576u);
                let _e1067 = coefs.member[_e1065];
                let _e1072 = coefs.member[(_e1065 + _e173)];
                let _e1077 = coefs.member[(_e1065 + _e178)];
                phi_2938_ = array<f32, 3>(((_e1032[0] + (_e1048 * _e1042)) + (_e1067 * _e1064)), ((_e1032[1] + (_e1054 * _e1042)) + (_e1072 * _e1064)), ((_e1032[2] + (_e1060 * _e1042)) + (_e1077 * _e1064)));
                phi_2940_ = _e1040;
            } else {
                phi_2938_ = _e1032;
                phi_2940_ = _e1035;
            }
            let _e1082 = phi_2938_;
            let _e1084 = phi_2940_;
            let _e1085 = select(_e1036, _e1035, _e287);
            if _e319 {
                phi_3021_ = (((_e161 * 2.4308622f) * _e1084) - (0.90909094f * _e1085));
            } else {
                phi_3021_ = _e1084;
            }
            let _e1091 = phi_3021_;
            if _e327 {
                let _e1096 = (((_e161 * 2.304886f) * _e1091) - (0.9481764f * select(_e1085, _e1084, _e319)));
                let _e1098 = ((_e1096 * _e991) * -0.024543693f);
                let _e1099 = (_e167 + 1216u);
                let _e1102 = coefs.member[_e1099];
                let _e1108 = coefs.member[(_e1099 + _e173)];
                let _e1114 = coefs.member[(_e1099 + _e178)];
                let _e1118 = ((_e1096 * _e994) * -0.024543693f);
                let _e1119 = (_e167 + 1088u);
                let _e1121 = coefs.member[_e1119];
                let _e1126 = coefs.member[(_e1119 + _e173)];
                let _e1131 = coefs.member[(_e1119 + _e178)];
                phi_3100_ = array<f32, 3>(((_e1082[0] + (_e1102 * _e1098)) + (_e1121 * _e1118)), ((_e1082[1] + (_e1108 * _e1098)) + (_e1126 * _e1118)), ((_e1082[2] + (_e1114 * _e1098)) + (_e1131 * _e1118)));
            } else {
                phi_3100_ = _e1082;
            }
            let _e1136 = phi_3100_;
            phi_3182_ = _e1136;
            phi_3183_ = _e994;
            phi_3184_ = _e991;
        } else {
            phi_3182_ = _e984;
            phi_3183_ = _e986;
            phi_3184_ = _e988;
        }
        let _e1138 = phi_3182_;
        let _e1140 = phi_3183_;
        let _e1142 = phi_3184_;
        if _e279 {
            let _e1145 = ((_e152 * _e1142) - (_e156 * _e1140));
            let _e1148 = ((_e152 * _e1140) + (_e156 * _e1142));
            if _e287 {
                let _e1149 = (_e161 * 2.3666193f);
                let _e1151 = ((_e1149 * _e1145) * 0.049087387f);
                let _e1154 = ((_e167 + (_e168 * 192u)) + 704u);
                let _e1157 = coefs.member[_e1154];
                let _e1163 = coefs.member[(_e1154 + _e173)];
                let _e1169 = coefs.member[(_e1154 + _e178)];
                let _e1173 = ((_e1149 * _e1148) * 0.049087387f);
                let _e1175 = ((_e167 + _e169) + 576u);
                let _e1177 = coefs.member[_e1175];
                let _e1182 = coefs.member[(_e1175 + _e173)];
                let _e1187 = coefs.member[(_e1175 + _e178)];
                phi_3346_ = array<f32, 3>(((_e1138[0] + (_e1157 * _e1151)) + (_e1177 * _e1173)), ((_e1138[1] + (_e1163 * _e1151)) + (_e1182 * _e1173)), ((_e1138[2] + (_e1169 * _e1151)) + (_e1187 * _e1173)));
                phi_3348_ = _e1149;
            } else {
                phi_3346_ = _e1138;
                phi_3348_ = 0.6563821f;
            }
            let _e1192 = phi_3346_;
            let _e1194 = phi_3348_;
            let _e1195 = select(0f, 0.6563821f, _e287);
            if _e319 {
                phi_3429_ = (((_e161 * 2.8504386f) * _e1194) - (0.7905694f * _e1195));
            } else {
                phi_3429_ = _e1194;
            }
            let _e1201 = phi_3429_;
            if _e327 {
                let _e1206 = (((_e161 * 2.5570416f) * _e1201) - (0.8970695f * select(_e1195, _e1194, _e319)));
                let _e1208 = ((_e1206 * _e1145) * -0.024543693f);
                let _e1210 = ((_e167 + _e169) + 1216u);
                let _e1213 = coefs.member[_e1210];
                let _e1219 = coefs.member[(_e1210 + _e173)];
                let _e1225 = coefs.member[(_e1210 + _e178)];
                let _e1229 = ((_e1206 * _e1148) * -0.024543693f);
                let _e1232 = ((_e167 + (_e168 * 192u)) + 1024u);
                let _e1234 = coefs.member[_e1232];
                let _e1239 = coefs.member[(_e1232 + _e173)];
                let _e1244 = coefs.member[(_e1232 + _e178)];
                phi_3508_ = array<f32, 3>(((_e1192[0] + (_e1213 * _e1208)) + (_e1234 * _e1229)), ((_e1192[1] + (_e1219 * _e1208)) + (_e1239 * _e1229)), ((_e1192[2] + (_e1225 * _e1208)) + (_e1244 * _e1229)));
            } else {
                phi_3508_ = _e1192;
            }
            let _e1249 = phi_3508_;
            phi_3590_ = _e1249;
            phi_3591_ = _e1148;
            phi_3592_ = _e1145;
        } else {
            phi_3590_ = _e1138;
            phi_3591_ = _e1140;
            phi_3592_ = _e1142;
        }
        let _e1251 = phi_3590_;
        let _e1253 = phi_3591_;
        let _e1255 = phi_3592_;
        if _e287 {
            let _e1258 = ((_e152 * _e1255) - (_e156 * _e1253));
            let _e1261 = ((_e152 * _e1253) + (_e156 * _e1255));
            if _e287 {
                let _e1262 = (_e1258 * 0.033535723f);
                let _e1263 = (_e167 + 768u);
                let _e1266 = coefs.member[_e1263];
                let _e1272 = coefs.member[(_e1263 + _e173)];
                let _e1278 = coefs.member[(_e1263 + _e178)];
                let _e1281 = (_e1261 * 0.033535723f);
                let _e1282 = (_e167 + 576u);
                let _e1284 = coefs.member[_e1282];
                let _e1289 = coefs.member[(_e1282 + _e173)];
                let _e1294 = coefs.member[(_e1282 + _e178)];
                phi_3677_ = array<f32, 3>(((_e1251[0] + (_e1266 * _e1262)) + (_e1284 * _e1281)), ((_e1251[1] + (_e1272 * _e1262)) + (_e1289 * _e1281)), ((_e1251[2] + (_e1278 * _e1262)) + (_e1294 * _e1281)));
            } else {
                phi_3677_ = _e1251;
            }
            let _e1299 = phi_3677_;
            if _e319 {
                phi_3756_ = (_e161 * 2.6459606f);
            } else {
                phi_3756_ = 0.6831841f;
            }
            let _e1302 = phi_3756_;
            if _e327 {
                let _e1307 = (((_e161 * 3.0178044f) * _e1302) - (0.7791937f * select(0f, 0.6831841f, _e319)));
                let _e1309 = ((_e1307 * _e1258) * -0.024543693f);
                let _e1311 = (_e167 + (_e168 * 128u));
                let _e1312 = (_e1311 + 1216u);
                let _e1315 = coefs.member[_e1312];
                let _e1321 = coefs.member[(_e1312 + _e173)];
                let _e1327 = coefs.member[(_e1312 + _e178)];
                let _e1331 = ((_e1307 * _e1261) * -0.024543693f);
                let _e1332 = (_e1311 + 1024u);
                let _e1334 = coefs.member[_e1332];
                let _e1339 = coefs.member[(_e1332 + _e173)];
                let _e1344 = coefs.member[(_e1332 + _e178)];
                phi_3835_ = array<f32, 3>(((_e1299[0] + (_e1315 * _e1309)) + (_e1334 * _e1331)), ((_e1299[1] + (_e1321 * _e1309)) + (_e1339 * _e1331)), ((_e1299[2] + (_e1327 * _e1309)) + (_e1344 * _e1331)));
            } else {
                phi_3835_ = _e1299;
            }
            let _e1349 = phi_3835_;
            phi_3917_ = _e1349;
            phi_3918_ = _e1261;
            phi_3919_ = _e1258;
        } else {
            phi_3917_ = _e1251;
            phi_3918_ = _e1253;
            phi_3919_ = _e1255;
        }
        let _e1351 = phi_3917_;
        let _e1353 = phi_3918_;
        let _e1355 = phi_3919_;
        if _e319 {
            let _e1358 = ((_e152 * _e1355) - (_e156 * _e1353));
            let _e1361 = ((_e152 * _e1353) + (_e156 * _e1355));
            if _e327 {
                let _e1362 = (_e161 * 2.9157066f);
                let _e1364 = ((_e1362 * _e1358) * -0.024543693f);
                let _e1367 = ((_e167 + (_e168 * 192u)) + 1216u);
                let _e1370 = coefs.member[_e1367];
                let _e1376 = coefs.member[(_e1367 + _e173)];
                let _e1382 = coefs.member[(_e1367 + _e178)];
                let _e1386 = ((_e1362 * _e1361) * -0.024543693f);
                let _e1388 = ((_e167 + _e169) + 1024u);
                let _e1390 = coefs.member[_e1388];
                let _e1395 = coefs.member[(_e1388 + _e173)];
                let _e1400 = coefs.member[(_e1388 + _e178)];
                phi_4081_ = array<f32, 3>(((_e1351[0] + (_e1370 * _e1364)) + (_e1390 * _e1386)), ((_e1351[1] + (_e1376 * _e1364)) + (_e1395 * _e1386)), ((_e1351[2] + (_e1382 * _e1364)) + (_e1400 * _e1386)));
            } else {
                phi_4081_ = _e1351;
            }
            let _e1405 = phi_4081_;
            phi_4163_ = _e1405;
            phi_4164_ = _e1361;
            phi_4165_ = _e1358;
        } else {
            phi_4163_ = _e1351;
            phi_4164_ = _e1353;
            phi_4165_ = _e1355;
        }
        let _e1407 = phi_4163_;
        let _e1409 = phi_4164_;
        let _e1411 = phi_4165_;
        if _e327 {
            if _e327 {
                let _e1418 = (((_e152 * _e1411) - (_e156 * _e1409)) * -0.017890552f);
                let _e1419 = (_e167 + 1280u);
                let _e1422 = coefs.member[_e1419];
                let _e1428 = coefs.member[(_e1419 + _e173)];
                let _e1434 = coefs.member[(_e1419 + _e178)];
                let _e1437 = (((_e152 * _e1409) + (_e156 * _e1411)) * -0.017890552f);
                let _e1438 = (_e167 + 1024u);
                let _e1440 = coefs.member[_e1438];
                let _e1445 = coefs.member[(_e1438 + _e173)];
                let _e1450 = coefs.member[(_e1438 + _e178)];
                phi_4250_ = array<f32, 3>(((_e1407[0] + (_e1422 * _e1418)) + (_e1440 * _e1437)), ((_e1407[1] + (_e1428 * _e1418)) + (_e1445 * _e1437)), ((_e1407[2] + (_e1434 * _e1418)) + (_e1450 * _e1437)));
            } else {
                phi_4250_ = _e1407;
            }
            let _e1455 = phi_4250_;
            phi_4328_ = _e1455;
        } else {
            phi_4328_ = _e1407;
        }
        let _e1457 = phi_4328_;
        let _e1460 = params.member.member_3;
        irradiance.member[_e128] = (_e1457[0] * _e1460);
        irradiance.member[(_e124 + _e128)] = (_e1457[1] * _e1460);
        irradiance.member[((_e123 * 128u) + _e128)] = (_e1457[2] * _e1460);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn sh_irradiance(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
