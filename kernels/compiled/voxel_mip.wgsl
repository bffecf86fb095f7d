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

struct type_22 {
    member: array<vec4<f32>, 6>,
}

struct type_24 {
    member: array<type_22>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> cells: type_7;
@group(0) @binding(0) 
var<uniform> params: type_19;
@group(0) @binding(2) 
var<storage> children: type_7;
@group(0) @binding(3) 
var<storage> finer: type_15;
@group(0) @binding(4) 
var<storage, read_write> out: type_24;

fn function_() {
    var phi_123_: vec4<f32>;
    var phi_132_: vec4<f32>;
    var phi_141_: vec4<f32>;
    var phi_150_: vec4<f32>;
    var phi_159_: vec4<f32>;
    var phi_168_: vec4<f32>;
    var phi_182_: vec4<f32>;
    var phi_191_: vec4<f32>;
    var phi_200_: vec4<f32>;
    var phi_209_: vec4<f32>;
    var phi_218_: vec4<f32>;
    var phi_227_: vec4<f32>;
    var phi_327_: vec4<f32>;
    var phi_336_: vec4<f32>;
    var phi_345_: vec4<f32>;
    var phi_354_: vec4<f32>;
    var phi_363_: vec4<f32>;
    var phi_372_: vec4<f32>;
    var phi_472_: vec4<f32>;
    var phi_481_: vec4<f32>;
    var phi_490_: vec4<f32>;
    var phi_499_: vec4<f32>;
    var phi_508_: vec4<f32>;
    var phi_517_: vec4<f32>;
    var phi_703_: vec4<f32>;
    var phi_712_: vec4<f32>;
    var phi_721_: vec4<f32>;
    var phi_730_: vec4<f32>;
    var phi_739_: vec4<f32>;
    var phi_748_: vec4<f32>;
    var phi_848_: vec4<f32>;
    var phi_857_: vec4<f32>;
    var phi_866_: vec4<f32>;
    var phi_875_: vec4<f32>;
    var phi_884_: vec4<f32>;
    var phi_893_: vec4<f32>;
    var phi_1079_: vec4<f32>;
    var phi_1088_: vec4<f32>;
    var phi_1097_: vec4<f32>;
    var phi_1106_: vec4<f32>;
    var phi_1115_: vec4<f32>;
    var phi_1124_: vec4<f32>;
    var phi_1310_: vec4<f32>;
    var phi_1319_: vec4<f32>;
    var phi_1328_: vec4<f32>;
    var phi_1337_: vec4<f32>;
    var phi_1346_: vec4<f32>;
    var phi_1355_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e27 = gid_1;
            let _e32 = params.member.member_12;
            let _e35 = params.member.member_13;
            let _e39 = (_e27.x + (_e27.y * 2097152u));
            if (_e39 < _e35) {
                let _e41 = (_e32 + _e39);
                let _e44 = children.member[_e41];
                let _e47 = (2u * (_e44 >> bitcast<u32>(2i)));
                let _e52 = cells.member[_e47];
                let _e53 = ((8u * (_e44 & 3u)) & 31u);
                let _e55 = (_e52 >> bitcast<u32>(_e53));
                let _e59 = cells.member[(_e47 + 1u)];
                let _e65 = (_e59 + countOneBits((_e52 & ((1u << bitcast<u32>(_e53)) - 1u))));
                let _e66 = (_e55 & 1u);
                let _e67 = (_e66 == 1u);
                let _e68 = (_e65 * 6u);
                if _e67 {
                    let _e71 = finer.member[_e68];
                    phi_123_ = _e71;
                } else {
                    phi_123_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e73 = phi_123_;
                if _e67 {
                    let _e77 = finer.member[(_e68 + 1u)];
                    phi_132_ = _e77;
                } else {
                    phi_132_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e79 = phi_132_;
                if _e67 {
                    let _e83 = finer.member[(_e68 + 2u)];
                    phi_141_ = _e83;
                } else {
                    phi_141_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e85 = phi_141_;
                if _e67 {
                    let _e89 = finer.member[(_e68 + 3u)];
                    phi_150_ = _e89;
                } else {
                    phi_150_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e91 = phi_150_;
                if _e67 {
                    let _e95 = finer.member[(_e68 + 4u)];
                    phi_159_ = _e95;
                } else {
                    phi_159_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e97 = phi_159_;
                if _e67 {
                    let _e101 = finer.member[(_e68 + 5u)];
                    phi_168_ = _e101;
                } else {
                    phi_168_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e103 = phi_168_;
                let _e104 = (_e65 + _e66);
                let _e107 = ((_e55 >> bitcast<u32>(1u)) & 1u);
                let _e108 = (_e107 == 1u);
                let _e109 = (_e104 * 6u);
                if _e108 {
                    let _e112 = finer.member[_e109];
                    phi_182_ = _e112;
                } else {
                    phi_182_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e114 = phi_182_;
                if _e108 {
                    let _e118 = finer.member[(_e109 + 1u)];
                    phi_191_ = _e118;
                } else {
                    phi_191_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e120 = phi_191_;
                if _e108 {
                    let _e124 = finer.member[(_e109 + 2u)];
                    phi_200_ = _e124;
                } else {
                    phi_200_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e126 = phi_200_;
                if _e108 {
                    let _e130 = finer.member[(_e109 + 3u)];
                    phi_209_ = _e130;
                } else {
                    phi_209_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e132 = phi_209_;
                if _e108 {
                    let _e136 = finer.member[(_e109 + 4u)];
                    phi_218_ = _e136;
                } else {
                    phi_218_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e138 = phi_218_;
                if _e108 {
                    let _e142 = finer.member[(_e109 + 5u)];
                    phi_227_ = _e142;
                } else {
                    phi_227_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e144 = phi_227_;
                let _e150 = ((1f - _e73.w) / select(0.000000000000000000000000000000000000011754944f, _e114.w, (_e114.w > 0.000000000000000000000000000000000000011754944f)));
                let _e152 = select(1f, _e150, (_e150 < 1f));
                let _e172 = ((1f - _e120.w) / select(0.000000000000000000000000000000000000011754944f, _e79.w, (_e79.w > 0.000000000000000000000000000000000000011754944f)));
                let _e174 = select(1f, _e172, (_e172 < 1f));
                let _e189 = (_e104 + _e107);
                let _e192 = ((_e55 >> bitcast<u32>(2u)) & 1u);
                let _e193 = (_e192 == 1u);
                let _e194 = (_e189 * 6u);
                if _e193 {
                    let _e197 = finer.member[_e194];
                    phi_327_ = _e197;
                } else {
                    phi_327_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e199 = phi_327_;
                if _e193 {
                    let _e203 = finer.member[(_e194 + 1u)];
                    phi_336_ = _e203;
                } else {
                    phi_336_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e205 = phi_336_;
                if _e193 {
                    let _e209 = finer.member[(_e194 + 2u)];
                    phi_345_ = _e209;
                } else {
                    phi_345_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e211 = phi_345_;
                if _e193 {
                    let _e215 = finer.member[(_e194 + 3u)];
                    phi_354_ = _e215;
                } else {
                    phi_354_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e217 = phi_354_;
                if _e193 {
                    let _e221 = finer.member[(_e194 + 4u)];
                    phi_363_ = _e221;
                } else {
                    phi_363_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e223 = phi_363_;
                if _e193 {
                    let _e227 = finer.member[(_e194 + 5u)];
                    phi_372_ = _e227;
                } else {
                    phi_372_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e229 = phi_372_;
                let _e235 = ((1f - _e85.w) / select(0.000000000000000000000000000000000000011754944f, _e211.w, (_e211.w > 0.000000000000000000000000000000000000011754944f)));
                let _e237 = select(1f, _e235, (_e235 < 1f));
                let _e257 = ((1f - _e217.w) / select(0.000000000000000000000000000000000000011754944f, _e91.w, (_e91.w > 0.000000000000000000000000000000000000011754944f)));
                let _e259 = select(1f, _e257, (_e257 < 1f));
                let _e274 = (_e189 + _e192);
                let _e277 = ((_e55 >> bitcast<u32>(3u)) & 1u);
                let _e278 = (_e277 == 1u);
                let _e279 = (_e274 * 6u);
                if _e278 {
                    let _e282 = finer.member[_e279];
                    phi_472_ = _e282;
                } else {
                    phi_472_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e284 = phi_472_;
                if _e278 {
                    let _e288 = finer.member[(_e279 + 1u)];
                    phi_481_ = _e288;
                } else {
                    phi_481_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e290 = phi_481_;
                if _e278 {
                    let _e294 = finer.member[(_e279 + 2u)];
                    phi_490_ = _e294;
                } else {
                    phi_490_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e296 = phi_490_;
                if _e278 {
                    let _e300 = finer.member[(_e279 + 3u)];
                    phi_499_ = _e300;
                } else {
                    phi_499_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e302 = phi_499_;
                if _e278 {
                    let _e306 = finer.member[(_e279 + 4u)];
                    phi_508_ = _e306;
                } else {
                    phi_508_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e308 = phi_508_;
                if _e278 {
                    let _e312 = finer.member[(_e279 + 5u)];
                    phi_517_ = _e312;
                } else {
                    phi_517_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e314 = phi_517_;
                let _e320 = ((1f - _e199.w) / select(0.000000000000000000000000000000000000011754944f, _e284.w, (_e284.w > 0.000000000000000000000000000000000000011754944f)));
                let _e322 = select(1f, _e320, (_e320 < 1f));
                let _e346 = ((1f - _e290.w) / select(0.000000000000000000000000000000000000011754944f, _e205.w, (_e205.w > 0.000000000000000000000000000000000000011754944f)));
                let _e348 = select(1f, _e346, (_e346 < 1f));
                let _e372 = ((1f - _e126.w) / select(0.000000000000000000000000000000000000011754944f, _e296.w, (_e296.w > 0.000000000000000000000000000000000000011754944f)));
                let _e374 = select(1f, _e372, (_e372 < 1f));
                let _e398 = ((1f - _e302.w) / select(0.000000000000000000000000000000000000011754944f, _e132.w, (_e132.w > 0.000000000000000000000000000000000000011754944f)));
                let _e400 = select(1f, _e398, (_e398 < 1f));
                let _e419 = (_e274 + _e277);
                let _e422 = ((_e55 >> bitcast<u32>(4u)) & 1u);
                let _e423 = (_e422 == 1u);
                let _e424 = (_e419 * 6u);
                if _e423 {
                    let _e427 = finer.member[_e424];
                    phi_703_ = _e427;
                } else {
                    phi_703_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e429 = phi_703_;
                if _e423 {
                    let _e433 = finer.member[(_e424 + 1u)];
                    phi_712_ = _e433;
                } else {
                    phi_712_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e435 = phi_712_;
                if _e423 {
                    let _e439 = finer.member[(_e424 + 2u)];
                    phi_721_ = _e439;
                } else {
                    phi_721_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e441 = phi_721_;
                if _e423 {
                    let _e445 = finer.member[(_e424 + 3u)];
                    phi_730_ = _e445;
                } else {
                    phi_730_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e447 = phi_730_;
                if _e423 {
                    let _e451 = finer.member[(_e424 + 4u)];
                    phi_739_ = _e451;
                } else {
                    phi_739_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e453 = phi_739_;
                if _e423 {
                    let _e457 = finer.member[(_e424 + 5u)];
                    phi_748_ = _e457;
                } else {
                    phi_748_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e459 = phi_748_;
                let _e465 = ((1f - _e97.w) / select(0.000000000000000000000000000000000000011754944f, _e453.w, (_e453.w > 0.000000000000000000000000000000000000011754944f)));
                let _e467 = select(1f, _e465, (_e465 < 1f));
                let _e487 = ((1f - _e459.w) / select(0.000000000000000000000000000000000000011754944f, _e103.w, (_e103.w > 0.000000000000000000000000000000000000011754944f)));
                let _e489 = select(1f, _e487, (_e487 < 1f));
                let _e504 = (_e419 + _e422);
                let _e507 = ((_e55 >> bitcast<u32>(5u)) & 1u);
                let _e508 = (_e507 == 1u);
                let _e509 = (_e504 * 6u);
                if _e508 {
                    let _e512 = finer.member[_e509];
                    phi_848_ = _e512;
                } else {
                    phi_848_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e514 = phi_848_;
                if _e508 {
                    let _e518 = finer.member[(_e509 + 1u)];
                    phi_857_ = _e518;
                } else {
                    phi_857_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e520 = phi_857_;
                if _e508 {
                    let _e524 = finer.member[(_e509 + 2u)];
                    phi_866_ = _e524;
                } else {
                    phi_866_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e526 = phi_866_;
                if _e508 {
                    let _e530 = finer.member[(_e509 + 3u)];
                    phi_875_ = _e530;
                } else {
                    phi_875_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e532 = phi_875_;
                if _e508 {
                    let _e536 = finer.member[(_e509 + 4u)];
                    phi_884_ = _e536;
                } else {
                    phi_884_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e538 = phi_884_;
                if _e508 {
                    let _e542 = finer.member[(_e509 + 5u)];
                    phi_893_ = _e542;
                } else {
                    phi_893_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e544 = phi_893_;
                let _e550 = ((1f - _e429.w) / select(0.000000000000000000000000000000000000011754944f, _e514.w, (_e514.w > 0.000000000000000000000000000000000000011754944f)));
                let _e552 = select(1f, _e550, (_e550 < 1f));
                let _e576 = ((1f - _e520.w) / select(0.000000000000000000000000000000000000011754944f, _e435.w, (_e435.w > 0.000000000000000000000000000000000000011754944f)));
                let _e578 = select(1f, _e576, (_e576 < 1f));
                let _e602 = ((1f - _e138.w) / select(0.000000000000000000000000000000000000011754944f, _e538.w, (_e538.w > 0.000000000000000000000000000000000000011754944f)));
                let _e604 = select(1f, _e602, (_e602 < 1f));
                let _e628 = ((1f - _e544.w) / select(0.000000000000000000000000000000000000011754944f, _e144.w, (_e144.w > 0.000000000000000000000000000000000000011754944f)));
                let _e630 = select(1f, _e628, (_e628 < 1f));
                let _e649 = (_e504 + _e507);
                let _e652 = ((_e55 >> bitcast<u32>(6u)) & 1u);
                let _e653 = (_e652 == 1u);
                let _e654 = (_e649 * 6u);
                if _e653 {
                    let _e657 = finer.member[_e654];
                    phi_1079_ = _e657;
                } else {
                    phi_1079_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e659 = phi_1079_;
                if _e653 {
                    let _e663 = finer.member[(_e654 + 1u)];
                    phi_1088_ = _e663;
                } else {
                    phi_1088_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e665 = phi_1088_;
                if _e653 {
                    let _e669 = finer.member[(_e654 + 2u)];
                    phi_1097_ = _e669;
                } else {
                    phi_1097_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e671 = phi_1097_;
                if _e653 {
                    let _e675 = finer.member[(_e654 + 3u)];
                    phi_1106_ = _e675;
                } else {
                    phi_1106_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e677 = phi_1106_;
                if _e653 {
                    let _e681 = finer.member[(_e654 + 4u)];
                    phi_1115_ = _e681;
                } else {
                    phi_1115_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e683 = phi_1115_;
                if _e653 {
                    let _e687 = finer.member[(_e654 + 5u)];
                    phi_1124_ = _e687;
                } else {
                    phi_1124_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e689 = phi_1124_;
                let _e695 = ((1f - _e441.w) / select(0.000000000000000000000000000000000000011754944f, _e671.w, (_e671.w > 0.000000000000000000000000000000000000011754944f)));
                let _e697 = select(1f, _e695, (_e695 < 1f));
                let _e721 = ((1f - _e677.w) / select(0.000000000000000000000000000000000000011754944f, _e447.w, (_e447.w > 0.000000000000000000000000000000000000011754944f)));
                let _e723 = select(1f, _e721, (_e721 < 1f));
                let _e747 = ((1f - _e223.w) / select(0.000000000000000000000000000000000000011754944f, _e683.w, (_e683.w > 0.000000000000000000000000000000000000011754944f)));
                let _e749 = select(1f, _e747, (_e747 < 1f));
                let _e773 = ((1f - _e689.w) / select(0.000000000000000000000000000000000000011754944f, _e229.w, (_e229.w > 0.000000000000000000000000000000000000011754944f)));
                let _e775 = select(1f, _e773, (_e773 < 1f));
                let _e798 = (((_e55 >> bitcast<u32>(7u)) & 1u) == 1u);
                let _e799 = ((_e649 + _e652) * 6u);
                if _e798 {
                    let _e802 = finer.member[_e799];
                    phi_1310_ = _e802;
                } else {
                    phi_1310_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e804 = phi_1310_;
                if _e798 {
                    let _e808 = finer.member[(_e799 + 1u)];
                    phi_1319_ = _e808;
                } else {
                    phi_1319_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e810 = phi_1319_;
                if _e798 {
                    let _e814 = finer.member[(_e799 + 2u)];
                    phi_1328_ = _e814;
                } else {
                    phi_1328_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e816 = phi_1328_;
                if _e798 {
                    let _e820 = finer.member[(_e799 + 3u)];
                    phi_1337_ = _e820;
                } else {
                    phi_1337_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e822 = phi_1337_;
                if _e798 {
                    let _e826 = finer.member[(_e799 + 4u)];
                    phi_1346_ = _e826;
                } else {
                    phi_1346_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e828 = phi_1346_;
                if _e798 {
                    let _e832 = finer.member[(_e799 + 5u)];
                    phi_1355_ = _e832;
                } else {
                    phi_1355_ = vec4<f32>(0f, 0f, 0f, 0f);
                }
                let _e834 = phi_1355_;
                let _e840 = ((1f - _e659.w) / select(0.000000000000000000000000000000000000011754944f, _e804.w, (_e804.w > 0.000000000000000000000000000000000000011754944f)));
                let _e842 = select(1f, _e840, (_e840 < 1f));
                let _e867 = ((1f - _e810.w) / select(0.000000000000000000000000000000000000011754944f, _e665.w, (_e665.w > 0.000000000000000000000000000000000000011754944f)));
                let _e869 = select(1f, _e867, (_e867 < 1f));
                let _e894 = ((1f - _e526.w) / select(0.000000000000000000000000000000000000011754944f, _e816.w, (_e816.w > 0.000000000000000000000000000000000000011754944f)));
                let _e896 = select(1f, _e894, (_e894 < 1f));
                let _e921 = ((1f - _e822.w) / select(0.000000000000000000000000000000000000011754944f, _e532.w, (_e532.w > 0.000000000000000000000000000000000000011754944f)));
                let _e923 = select(1f, _e921, (_e921 < 1f));
                let _e948 = ((1f - _e308.w) / select(0.000000000000000000000000000000000000011754944f, _e828.w, (_e828.w > 0.000000000000000000000000000000000000011754944f)));
                let _e950 = select(1f, _e948, (_e948 < 1f));
                let _e975 = ((1f - _e834.w) / select(0.000000000000000000000000000000000000011754944f, _e314.w, (_e314.w > 0.000000000000000000000000000000000000011754944f)));
                let _e977 = select(1f, _e975, (_e975 < 1f));
                let _e1005 = (_e41 + (_e39 - _e39));
                if (_e1005 < arrayLength((&out.member))) {
                } else {
                    break;
                }
                out.member[_e1005].member = array<vec4<f32>, 6>((vec4<f32>(((((_e73.x + (_e114.x * _e152)) + (_e199.x + (_e284.x * _e322))) + (_e429.x + (_e514.x * _e552))) + (_e659.x + (_e804.x * _e842))), ((((_e73.y + (_e114.y * _e152)) + (_e199.y + (_e284.y * _e322))) + (_e429.y + (_e514.y * _e552))) + (_e659.y + (_e804.y * _e842))), ((((_e73.z + (_e114.z * _e152)) + (_e199.z + (_e284.z * _e322))) + (_e429.z + (_e514.z * _e552))) + (_e659.z + (_e804.z * _e842))), ((((_e73.w + (_e114.w * _e152)) + (_e199.w + (_e284.w * _e322))) + (_e429.w + (_e514.w * _e552))) + (_e659.w + (_e804.w * _e842)))) * 0.25f), (vec4<f32>(((((_e120.x + (_e79.x * _e174)) + (_e290.x + (_e205.x * _e348))) + (_e520.x + (_e435.x * _e578))) + (_e810.x + (_e665.x * _e869))), ((((_e120.y + (_e79.y * _e174)) + (_e290.y + (_e205.y * _e348))) + (_e520.y + (_e435.y * _e578))) + (_e810.y + (_e665.y * _e869))), ((((_e120.z + (_e79.z * _e174)) + (_e290.z + (_e205.z * _e348))) + (_e520.z + (_e435.z * _e578))) + (_e810.z + (_e665.z * _e869))), ((((_e120.w + (_e79.w * _e174)) + (_e290.w + (_e205.w * _e348))) + (_e520.w + (_e435.w * _e578))) + (_e810.w + (_e665.w * _e869)))) * 0.25f), (vec4<f32>(((((_e85.x + (_e211.x * _e237)) + (_e126.x + (_e296.x * _e374))) + (_e441.x + (_e671.x * _e697))) + (_e526.x + (_e816.x * _e896))), ((((_e85.y + (_e211.y * _e237)) + (_e126.y + (_e296.y * _e374))) + (_e441.y + (_e671.y * _e697))) + (_e526.y + (_e816.y * _e896))), ((((_e85.z + (_e211.z * _e237)) + (_e126.z + (_e296.z * _e374))) + (_e441.z + (_e671.z * _e697))) + (_e526.z + (_e816.z * _e896))), ((((_e85.w + (_e211.w * _e237)) + (_e126.w + (_e296.w * _e374))) + (_e441.w + (_e671.w * _e697))) + (_e526.w + (_e816.w * _e896)))) * 0.25f), (vec4<f32>(((((_e217.x + (_e91.x * _e259)) + (_e302.x + (_e132.x * _e400))) + (_e677.x + (_e447.x * _e723))) + (_e822.x + (_e532.x * _e923))), ((((_e217.y + (_e91.y * _e259)) + (_e302.y + (_e132.y * _e400))) + (_e677.y + (_e447.y * _e723))) + (_e822.y + (_e532.y * _e923))), ((((_e217.z + (_e91.z * _e259)) + (_e302.z + (_e132.z * _e400))) + (_e677.z + (_e447.z * _e723))) + (_e822.z + (_e532.z * _e923))), ((((_e217.w + (_e91.w * _e259)) + (_e302.w + (_e132.w * _e400))) + (_e677.w + (_e447.w * _e723))) + (_e822.w + (_e532.w * _e923)))) * 0.25f), (vec4<f32>(((((_e97.x + (_e453.x * _e467)) + (_e138.x + (_e538.x * _e604))) + (_e223.x + (_e683.x * _e749))) + (_e308.x + (_e828.x * _e950))), ((((_e97.y + (_e453.y * _e467)) + (_e138.y + (_e538.y * _e604))) + (_e223.y + (_e683.y * _e749))) + (_e308.y + (_e828.y * _e950))), ((((_e97.z + (_e453.z * _e467)) + (_e138.z + (_e538.z * _e604))) + (_e223.z + (_e683.z * _e749))) + (_e308.z + (_e828.z * _e950))), ((((_e97.w + (_e453.w * _e467)) + (_e138.w + (_e538.w * _e604))) + (_e223.w + (_e683.w * _e749))) + (_e308.w + (_e828.w * _e950)))) * 0.25f), (vec4<f32>(((((_e459.x + (_e103.x * _e489)) + (_e544.x + (_e144.x * _e630))) + (_e689.x + (_e229.x * _e775))) + (_e834.x + (_e314.x * _e977))), ((((_e459.y + (_e103.y * _e489)) + (_e544.y + (_e144.y * _e630))) + (_e689.y + (_e229.y * _e775))) + (_e834.y + (_e314.y * _e977))), ((((_e459.z + (_e103.z * _e489)) + (_e544.z + (_e144.z * _e630))) + (_e689.z + (_e229.z * _e775))) + (_e834.z + (_e314.z * _e977))), ((((_e459.w + (_e103.w * _e489)) + (_e544.w + (_e144.w * _e630))) + (_e689.w + (_e229.w * _e775))) + (_e834.w + (_e314.w * _e977)))) * 0.25f));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_mip(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
