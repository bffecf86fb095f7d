struct type_5 {
    member: array<f32>,
}

struct type_16 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
    member_8: array<f32, 3>,
    member_9: f32,
}

struct type_18 {
    member: array<vec4<f32>>,
}

struct type_21 {
    member: array<type_16>,
}

struct type_24 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_25 {
    member: type_24,
}

struct type_27 {
    member: array<u32, 4>,
    member_1: array<f32, 4>,
}

struct type_29 {
    member: array<type_27>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_33 {
    member: array<type_31>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(0) 
var<uniform> params: type_25;
@group(0) @binding(3) 
var<storage> surfels: type_21;
@group(0) @binding(1) 
var<storage> blends: type_29;
@group(0) @binding(4) 
var<storage> gloss: type_33;
@group(0) @binding(5) 
var<storage, read_write> reflected: type_18;

fn function_() {
    var phi_789_: vec3<f32>;
    var phi_872_: vec3<f32>;
    var phi_994_: f32;
    var phi_995_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e35 = gid_1;
            let _e39 = arrayLength((&radiance.member));
            let _e48 = params.member.member;
            let _e52 = (_e35.x + (_e35.y * 2097152u));
            if (_e52 < _e48) {
                if (_e52 < arrayLength((&blends.member))) {
                } else {
                    break;
                }
                let _e57 = blends.member[_e52];
                if (_e52 < arrayLength((&gloss.member))) {
                } else {
                    break;
                }
                let _e62 = gloss.member[_e52].member;
                let _e66 = gloss.member[_e52].member_1;
                let _e70 = gloss.member[_e52].member_2;
                if (_e52 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e75 = surfels.member[_e52].member_2;
                let _e82 = params.member.member_1;
                if (_e57.member[0] < _e39) {
                } else {
                    break;
                }
                let _e88 = (3u * _e82);
                let _e89 = (_e88 + _e57.member[0]);
                if (_e89 < _e39) {
                } else {
                    break;
                }
                let _e93 = radiance.member[_e89];
                let _e95 = (6u * _e82);
                let _e96 = (_e95 + _e57.member[0]);
                if (_e96 < _e39) {
                } else {
                    break;
                }
                let _e100 = radiance.member[_e96];
                let _e102 = (9u * _e82);
                let _e103 = (_e102 + _e57.member[0]);
                if (_e103 < _e39) {
                } else {
                    break;
                }
                let _e107 = radiance.member[_e103];
                if (_e57.member[1] < _e39) {
                } else {
                    break;
                }
                let _e114 = (_e88 + _e57.member[1]);
                if (_e114 < _e39) {
                } else {
                    break;
                }
                let _e118 = radiance.member[_e114];
                let _e121 = (_e95 + _e57.member[1]);
                if (_e121 < _e39) {
                } else {
                    break;
                }
                let _e125 = radiance.member[_e121];
                let _e128 = (_e102 + _e57.member[1]);
                if (_e128 < _e39) {
                } else {
                    break;
                }
                let _e132 = radiance.member[_e128];
                if (_e57.member[2] < _e39) {
                } else {
                    break;
                }
                let _e140 = (_e88 + _e57.member[2]);
                if (_e140 < _e39) {
                } else {
                    break;
                }
                let _e144 = radiance.member[_e140];
                let _e147 = (_e95 + _e57.member[2]);
                if (_e147 < _e39) {
                } else {
                    break;
                }
                let _e151 = radiance.member[_e147];
                let _e154 = (_e102 + _e57.member[2]);
                if (_e154 < _e39) {
                } else {
                    break;
                }
                let _e158 = radiance.member[_e154];
                if (_e57.member[3] < _e39) {
                } else {
                    break;
                }
                let _e166 = (_e88 + _e57.member[3]);
                if (_e166 < _e39) {
                } else {
                    break;
                }
                let _e170 = radiance.member[_e166];
                let _e172 = ((((_e57.member_1[0] * _e93) + (_e57.member_1[1] * _e118)) + (_e57.member_1[2] * _e144)) + (_e57.member_1[3] * _e170));
                let _e173 = (_e95 + _e57.member[3]);
                if (_e173 < _e39) {
                } else {
                    break;
                }
                let _e177 = radiance.member[_e173];
                let _e179 = ((((_e57.member_1[0] * _e100) + (_e57.member_1[1] * _e125)) + (_e57.member_1[2] * _e151)) + (_e57.member_1[3] * _e177));
                let _e180 = (_e102 + _e57.member[3]);
                if (_e180 < _e39) {
                } else {
                    break;
                }
                let _e184 = radiance.member[_e180];
                let _e186 = ((((_e57.member_1[0] * _e107) + (_e57.member_1[1] * _e132)) + (_e57.member_1[2] * _e158)) + (_e57.member_1[3] * _e184));
                if ((_e82 + _e57.member[0]) < _e39) {
                } else {
                    break;
                }
                let _e189 = (4u * _e82);
                let _e190 = (_e189 + _e57.member[0]);
                if (_e190 < _e39) {
                } else {
                    break;
                }
                let _e194 = radiance.member[_e190];
                let _e196 = (7u * _e82);
                let _e197 = (_e196 + _e57.member[0]);
                if (_e197 < _e39) {
                } else {
                    break;
                }
                let _e201 = radiance.member[_e197];
                let _e203 = (10u * _e82);
                let _e204 = (_e203 + _e57.member[0]);
                if (_e204 < _e39) {
                } else {
                    break;
                }
                let _e208 = radiance.member[_e204];
                if ((_e82 + _e57.member[1]) < _e39) {
                } else {
                    break;
                }
                let _e212 = (_e189 + _e57.member[1]);
                if (_e212 < _e39) {
                } else {
                    break;
                }
                let _e216 = radiance.member[_e212];
                let _e219 = (_e196 + _e57.member[1]);
                if (_e219 < _e39) {
                } else {
                    break;
                }
                let _e223 = radiance.member[_e219];
                let _e226 = (_e203 + _e57.member[1]);
                if (_e226 < _e39) {
                } else {
                    break;
                }
                let _e230 = radiance.member[_e226];
                if ((_e82 + _e57.member[2]) < _e39) {
                } else {
                    break;
                }
                let _e235 = (_e189 + _e57.member[2]);
                if (_e235 < _e39) {
                } else {
                    break;
                }
                let _e239 = radiance.member[_e235];
                let _e242 = (_e196 + _e57.member[2]);
                if (_e242 < _e39) {
                } else {
                    break;
                }
                let _e246 = radiance.member[_e242];
                let _e249 = (_e203 + _e57.member[2]);
                if (_e249 < _e39) {
                } else {
                    break;
                }
                let _e253 = radiance.member[_e249];
                if ((_e82 + _e57.member[3]) < _e39) {
                } else {
                    break;
                }
                let _e258 = (_e189 + _e57.member[3]);
                if (_e258 < _e39) {
                } else {
                    break;
                }
                let _e262 = radiance.member[_e258];
                let _e264 = ((((_e57.member_1[0] * _e194) + (_e57.member_1[1] * _e216)) + (_e57.member_1[2] * _e239)) + (_e57.member_1[3] * _e262));
                let _e265 = (_e196 + _e57.member[3]);
                if (_e265 < _e39) {
                } else {
                    break;
                }
                let _e269 = radiance.member[_e265];
                let _e271 = ((((_e57.member_1[0] * _e201) + (_e57.member_1[1] * _e223)) + (_e57.member_1[2] * _e246)) + (_e57.member_1[3] * _e269));
                let _e272 = (_e203 + _e57.member[3]);
                if (_e272 < _e39) {
                } else {
                    break;
                }
                let _e276 = radiance.member[_e272];
                let _e278 = ((((_e57.member_1[0] * _e208) + (_e57.member_1[1] * _e230)) + (_e57.member_1[2] * _e253)) + (_e57.member_1[3] * _e276));
                let _e279 = (2u * _e82);
                if ((_e279 + _e57.member[0]) < _e39) {
                } else {
                    break;
                }
                let _e282 = (5u * _e82);
                let _e283 = (_e282 + _e57.member[0]);
                if (_e283 < _e39) {
                } else {
                    break;
                }
                let _e287 = radiance.member[_e283];
                let _e289 = (8u * _e82);
                let _e290 = (_e289 + _e57.member[0]);
                if (_e290 < _e39) {
                } else {
                    break;
                }
                let _e294 = radiance.member[_e290];
                let _e296 = (11u * _e82);
                let _e297 = (_e296 + _e57.member[0]);
                if (_e297 < _e39) {
                } else {
                    break;
                }
                let _e301 = radiance.member[_e297];
                if ((_e279 + _e57.member[1]) < _e39) {
                } else {
                    break;
                }
                let _e305 = (_e282 + _e57.member[1]);
                if (_e305 < _e39) {
                } else {
                    break;
                }
                let _e309 = radiance.member[_e305];
                let _e312 = (_e289 + _e57.member[1]);
                if (_e312 < _e39) {
                } else {
                    break;
                }
                let _e316 = radiance.member[_e312];
                let _e319 = (_e296 + _e57.member[1]);
                if (_e319 < _e39) {
                } else {
                    break;
                }
                let _e323 = radiance.member[_e319];
                if ((_e279 + _e57.member[2]) < _e39) {
                } else {
                    break;
                }
                let _e328 = (_e282 + _e57.member[2]);
                if (_e328 < _e39) {
                } else {
                    break;
                }
                let _e332 = radiance.member[_e328];
                let _e335 = (_e289 + _e57.member[2]);
                if (_e335 < _e39) {
                } else {
                    break;
                }
                let _e339 = radiance.member[_e335];
                let _e342 = (_e296 + _e57.member[2]);
                if (_e342 < _e39) {
                } else {
                    break;
                }
                let _e346 = radiance.member[_e342];
                if ((_e279 + _e57.member[3]) < _e39) {
                } else {
                    break;
                }
                let _e351 = (_e282 + _e57.member[3]);
                if (_e351 < _e39) {
                } else {
                    break;
                }
                let _e355 = radiance.member[_e351];
                let _e357 = ((((_e57.member_1[0] * _e287) + (_e57.member_1[1] * _e309)) + (_e57.member_1[2] * _e332)) + (_e57.member_1[3] * _e355));
                let _e358 = (_e289 + _e57.member[3]);
                if (_e358 < _e39) {
                } else {
                    break;
                }
                let _e362 = radiance.member[_e358];
                let _e364 = ((((_e57.member_1[0] * _e294) + (_e57.member_1[1] * _e316)) + (_e57.member_1[2] * _e339)) + (_e57.member_1[3] * _e362));
                let _e365 = (_e296 + _e57.member[3]);
                if (_e365 < _e39) {
                } else {
                    break;
                }
                let _e369 = radiance.member[_e365];
                let _e371 = ((((_e57.member_1[0] * _e301) + (_e57.member_1[1] * _e323)) + (_e57.member_1[2] * _e346)) + (_e57.member_1[3] * _e369));
                let _e384 = (((_e186 * 0.2126f) + (_e278 * 0.7152f)) + (_e371 * 0.0722f));
                let _e385 = (((_e172 * 0.2126f) + (_e264 * 0.7152f)) + (_e357 * 0.0722f));
                let _e386 = (((_e179 * 0.2126f) + (_e271 * 0.7152f)) + (_e364 * 0.0722f));
                let _e391 = (((_e384 * _e384) + (_e385 * _e385)) + (_e386 * _e386));
                if (_e391 >= 0.000000000000000000000000000000000000011754944f) {
                    let _e394 = (1f / sqrt(_e391));
                    phi_789_ = vec3<f32>((_e384 * _e394), (_e385 * _e394), (_e386 * _e394));
                } else {
                    phi_789_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e400 = phi_789_;
                let _e408 = (((_e186 * _e400.x) + (_e172 * _e400.y)) + (_e179 * _e400.z));
                let _e416 = (((_e278 * _e400.x) + (_e264 * _e400.y)) + (_e271 * _e400.z));
                let _e424 = (((_e371 * _e400.x) + (_e357 * _e400.y)) + (_e364 * _e400.z));
                let _e435 = (((_e75[0] * _e400.x) + (_e75[1] * _e400.y)) + (_e75[2] * _e400.z));
                let _e440 = (((_e75[0] * _e62[0]) + (_e75[1] * _e62[1])) + (_e75[2] * _e62[2]));
                let _e441 = (_e400.x + _e62[0]);
                let _e442 = (_e400.y + _e62[1]);
                let _e443 = (_e400.z + _e62[2]);
                let _e448 = (((_e441 * _e441) + (_e442 * _e442)) + (_e443 * _e443));
                if (_e448 >= 0.000000000000000000000000000000000000011754944f) {
                    let _e451 = (1f / sqrt(_e448));
                    phi_872_ = vec3<f32>((_e441 * _e451), (_e442 * _e451), (_e443 * _e451));
                } else {
                    phi_872_ = vec3<f32>(_e75[0], _e75[1], _e75[2]);
                }
                let _e457 = phi_872_;
                let _e465 = (((_e75[0] * _e457.x) + (_e75[1] * _e457.y)) + (_e75[2] * _e457.z));
                let _e467 = select(0f, _e465, (_e465 > 0f));
                let _e469 = select(1f, _e467, (_e467 < 1f));
                let _e474 = (((_e400.x * _e457.x) + (_e400.y * _e457.y)) + (_e400.z * _e457.z));
                let _e476 = select(0f, _e474, (_e474 > 0f));
                let _e480 = select(0.01f, _e66, (_e66 > 0.01f));
                let _e481 = (_e480 * _e480);
                let _e484 = ((_e75[1] * _e457.z) - (_e457.y * _e75[2]));
                let _e487 = ((_e75[2] * _e457.x) - (_e457.z * _e75[0]));
                let _e490 = ((_e75[0] * _e457.y) - (_e457.x * _e75[1]));
                let _e498 = ((((_e484 * _e484) + (_e487 * _e487)) + (_e490 * _e490)) + ((_e481 * _e469) * _e469));
                let _e499 = (_e498 * _e498);
                let _e505 = (1f - _e481);
                let _e507 = (((_e435 * _e435) * _e505) + _e481);
                let _e514 = (((_e440 * _e440) * _e505) + _e481);
                if (_e435 > 0f) {
                    let _e522 = ((_e440 * sqrt(select(0f, _e507, (_e507 > 0f)))) + (_e435 * sqrt(select(0f, _e514, (_e514 > 0f)))));
                    phi_994_ = ((((_e481 / (3.1415927f * select(0.000000000000000000000000000000000000011754944f, _e499, (_e499 > 0.000000000000000000000000000000000000011754944f)))) * 0.5f) / select(0.000000000000000000000000000000000000011754944f, _e522, (_e522 > 0.000000000000000000000000000000000000011754944f))) * _e435);
                    phi_995_ = select(true, false, (_e440 > 0f));
                } else {
                    phi_994_ = f32();
                    phi_995_ = true;
                }
                let _e529 = phi_994_;
                let _e531 = phi_995_;
                let _e532 = select(_e529, 0f, _e531);
                let _e536 = (1f - select(1f, _e476, (_e476 < 1f)));
                let _e543 = ((((_e536 * _e536) * _e536) * _e536) * _e536);
                if (_e52 < arrayLength((&reflected.member))) {
                } else {
                    break;
                }
                reflected.member[_e52] = vec4<f32>((((select(0f, _e408, (_e408 > 0f)) * 2.0466535f) * (_e70[0] + ((1f - _e70[0]) * _e543))) * _e532), (((select(0f, _e416, (_e416 > 0f)) * 2.0466535f) * (_e70[1] + ((1f - _e70[1]) * _e543))) * _e532), (((select(0f, _e424, (_e424 > 0f)) * 2.0466535f) * (_e70[2] + ((1f - _e70[2]) * _e543))) * _e532), 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_glossy(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
