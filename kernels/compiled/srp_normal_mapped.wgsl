struct type_5 {
    member: array<f32>,
}

struct type_15 {
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

struct type_17 {
    member: array<vec4<f32>>,
}

struct type_20 {
    member: array<type_15>,
}

struct type_23 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_24 {
    member: type_23,
}

struct type_26 {
    member: array<u32, 4>,
    member_1: array<f32, 4>,
}

struct type_28 {
    member: array<type_26>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(2) 
var<storage> radiance: type_5;
@group(0) @binding(0) 
var<uniform> params: type_24;
@group(0) @binding(3) 
var<storage> surfels: type_20;
@group(0) @binding(4) 
var<storage, read_write> irradiance: type_17;
@group(0) @binding(1) 
var<storage> blends: type_28;

fn function_() {
    switch bitcast<i32>(0u) {
        default: {
            let _e23 = gid_1;
            let _e27 = arrayLength((&radiance.member));
            let _e34 = params.member.member;
            let _e38 = (_e23.x + (_e23.y * 2097152u));
            if (_e38 < _e34) {
                if (_e38 < arrayLength((&blends.member))) {
                } else {
                    break;
                }
                let _e43 = blends.member[_e38];
                if (_e38 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e48 = surfels.member[_e38].member_2;
                let _e51 = params.member.member_1;
                if (_e43.member[0] < _e27) {
                } else {
                    break;
                }
                let _e59 = radiance.member[_e43.member[0]];
                let _e61 = (3u * _e51);
                let _e62 = (_e61 + _e43.member[0]);
                if (_e62 < _e27) {
                } else {
                    break;
                }
                let _e66 = radiance.member[_e62];
                let _e68 = (6u * _e51);
                let _e69 = (_e68 + _e43.member[0]);
                if (_e69 < _e27) {
                } else {
                    break;
                }
                let _e73 = radiance.member[_e69];
                let _e75 = (9u * _e51);
                let _e76 = (_e75 + _e43.member[0]);
                if (_e76 < _e27) {
                } else {
                    break;
                }
                let _e80 = radiance.member[_e76];
                if (_e43.member[1] < _e27) {
                } else {
                    break;
                }
                let _e89 = radiance.member[_e43.member[1]];
                let _e92 = (_e61 + _e43.member[1]);
                if (_e92 < _e27) {
                } else {
                    break;
                }
                let _e96 = radiance.member[_e92];
                let _e99 = (_e68 + _e43.member[1]);
                if (_e99 < _e27) {
                } else {
                    break;
                }
                let _e103 = radiance.member[_e99];
                let _e106 = (_e75 + _e43.member[1]);
                if (_e106 < _e27) {
                } else {
                    break;
                }
                let _e110 = radiance.member[_e106];
                if (_e43.member[2] < _e27) {
                } else {
                    break;
                }
                let _e120 = radiance.member[_e43.member[2]];
                let _e123 = (_e61 + _e43.member[2]);
                if (_e123 < _e27) {
                } else {
                    break;
                }
                let _e127 = radiance.member[_e123];
                let _e130 = (_e68 + _e43.member[2]);
                if (_e130 < _e27) {
                } else {
                    break;
                }
                let _e134 = radiance.member[_e130];
                let _e137 = (_e75 + _e43.member[2]);
                if (_e137 < _e27) {
                } else {
                    break;
                }
                let _e141 = radiance.member[_e137];
                if (_e43.member[3] < _e27) {
                } else {
                    break;
                }
                let _e151 = radiance.member[_e43.member[3]];
                let _e154 = (_e61 + _e43.member[3]);
                if (_e154 < _e27) {
                } else {
                    break;
                }
                let _e158 = radiance.member[_e154];
                let _e161 = (_e68 + _e43.member[3]);
                if (_e161 < _e27) {
                } else {
                    break;
                }
                let _e165 = radiance.member[_e161];
                let _e168 = (_e75 + _e43.member[3]);
                if (_e168 < _e27) {
                } else {
                    break;
                }
                let _e172 = radiance.member[_e168];
                let _e179 = (_e48[2] * 1.0233268f);
                let _e182 = (_e48[0] * 1.0233268f);
                let _e185 = (_e48[1] * 1.0233268f);
                let _e187 = ((((((((_e43.member_1[0] * _e59) + (_e43.member_1[1] * _e89)) + (_e43.member_1[2] * _e120)) + (_e43.member_1[3] * _e151)) * 0.886227f) + (((((_e43.member_1[0] * _e73) + (_e43.member_1[1] * _e103)) + (_e43.member_1[2] * _e134)) + (_e43.member_1[3] * _e165)) * _e179)) + (((((_e43.member_1[0] * _e80) + (_e43.member_1[1] * _e110)) + (_e43.member_1[2] * _e141)) + (_e43.member_1[3] * _e172)) * _e182)) + (((((_e43.member_1[0] * _e66) + (_e43.member_1[1] * _e96)) + (_e43.member_1[2] * _e127)) + (_e43.member_1[3] * _e158)) * _e185));
                let _e188 = (_e51 + _e43.member[0]);
                if (_e188 < _e27) {
                } else {
                    break;
                }
                let _e192 = radiance.member[_e188];
                let _e194 = (4u * _e51);
                let _e195 = (_e194 + _e43.member[0]);
                if (_e195 < _e27) {
                } else {
                    break;
                }
                let _e199 = radiance.member[_e195];
                let _e201 = (7u * _e51);
                let _e202 = (_e201 + _e43.member[0]);
                if (_e202 < _e27) {
                } else {
                    break;
                }
                let _e206 = radiance.member[_e202];
                let _e208 = (10u * _e51);
                let _e209 = (_e208 + _e43.member[0]);
                if (_e209 < _e27) {
                } else {
                    break;
                }
                let _e213 = radiance.member[_e209];
                let _e215 = (_e51 + _e43.member[1]);
                if (_e215 < _e27) {
                } else {
                    break;
                }
                let _e219 = radiance.member[_e215];
                let _e222 = (_e194 + _e43.member[1]);
                if (_e222 < _e27) {
                } else {
                    break;
                }
                let _e226 = radiance.member[_e222];
                let _e229 = (_e201 + _e43.member[1]);
                if (_e229 < _e27) {
                } else {
                    break;
                }
                let _e233 = radiance.member[_e229];
                let _e236 = (_e208 + _e43.member[1]);
                if (_e236 < _e27) {
                } else {
                    break;
                }
                let _e240 = radiance.member[_e236];
                let _e243 = (_e51 + _e43.member[2]);
                if (_e243 < _e27) {
                } else {
                    break;
                }
                let _e247 = radiance.member[_e243];
                let _e250 = (_e194 + _e43.member[2]);
                if (_e250 < _e27) {
                } else {
                    break;
                }
                let _e254 = radiance.member[_e250];
                let _e257 = (_e201 + _e43.member[2]);
                if (_e257 < _e27) {
                } else {
                    break;
                }
                let _e261 = radiance.member[_e257];
                let _e264 = (_e208 + _e43.member[2]);
                if (_e264 < _e27) {
                } else {
                    break;
                }
                let _e268 = radiance.member[_e264];
                let _e271 = (_e51 + _e43.member[3]);
                if (_e271 < _e27) {
                } else {
                    break;
                }
                let _e275 = radiance.member[_e271];
                let _e278 = (_e194 + _e43.member[3]);
                if (_e278 < _e27) {
                } else {
                    break;
                }
                let _e282 = radiance.member[_e278];
                let _e285 = (_e201 + _e43.member[3]);
                if (_e285 < _e27) {
                } else {
                    break;
                }
                let _e289 = radiance.member[_e285];
                let _e292 = (_e208 + _e43.member[3]);
                if (_e292 < _e27) {
                } else {
                    break;
                }
                let _e296 = radiance.member[_e292];
                let _e305 = ((((((((_e43.member_1[0] * _e192) + (_e43.member_1[1] * _e219)) + (_e43.member_1[2] * _e247)) + (_e43.member_1[3] * _e275)) * 0.886227f) + (((((_e43.member_1[0] * _e206) + (_e43.member_1[1] * _e233)) + (_e43.member_1[2] * _e261)) + (_e43.member_1[3] * _e289)) * _e179)) + (((((_e43.member_1[0] * _e213) + (_e43.member_1[1] * _e240)) + (_e43.member_1[2] * _e268)) + (_e43.member_1[3] * _e296)) * _e182)) + (((((_e43.member_1[0] * _e199) + (_e43.member_1[1] * _e226)) + (_e43.member_1[2] * _e254)) + (_e43.member_1[3] * _e282)) * _e185));
                let _e306 = (2u * _e51);
                let _e307 = (_e306 + _e43.member[0]);
                if (_e307 < _e27) {
                } else {
                    break;
                }
                let _e311 = radiance.member[_e307];
                let _e313 = (5u * _e51);
                let _e314 = (_e313 + _e43.member[0]);
                if (_e314 < _e27) {
                } else {
                    break;
                }
                let _e318 = radiance.member[_e314];
                let _e320 = (8u * _e51);
                let _e321 = (_e320 + _e43.member[0]);
                if (_e321 < _e27) {
                } else {
                    break;
                }
                let _e325 = radiance.member[_e321];
                let _e327 = (11u * _e51);
                let _e328 = (_e327 + _e43.member[0]);
                if (_e328 < _e27) {
                } else {
                    break;
                }
                let _e332 = radiance.member[_e328];
                let _e334 = (_e306 + _e43.member[1]);
                if (_e334 < _e27) {
                } else {
                    break;
                }
                let _e338 = radiance.member[_e334];
                let _e341 = (_e313 + _e43.member[1]);
                if (_e341 < _e27) {
                } else {
                    break;
                }
                let _e345 = radiance.member[_e341];
                let _e348 = (_e320 + _e43.member[1]);
                if (_e348 < _e27) {
                } else {
                    break;
                }
                let _e352 = radiance.member[_e348];
                let _e355 = (_e327 + _e43.member[1]);
                if (_e355 < _e27) {
                } else {
                    break;
                }
                let _e359 = radiance.member[_e355];
                let _e362 = (_e306 + _e43.member[2]);
                if (_e362 < _e27) {
                } else {
                    break;
                }
                let _e366 = radiance.member[_e362];
                let _e369 = (_e313 + _e43.member[2]);
                if (_e369 < _e27) {
                } else {
                    break;
                }
                let _e373 = radiance.member[_e369];
                let _e376 = (_e320 + _e43.member[2]);
                if (_e376 < _e27) {
                } else {
                    break;
                }
                let _e380 = radiance.member[_e376];
                let _e383 = (_e327 + _e43.member[2]);
                if (_e383 < _e27) {
                } else {
                    break;
                }
                let _e387 = radiance.member[_e383];
                let _e390 = (_e306 + _e43.member[3]);
                if (_e390 < _e27) {
                } else {
                    break;
                }
                let _e394 = radiance.member[_e390];
                let _e397 = (_e313 + _e43.member[3]);
                if (_e397 < _e27) {
                } else {
                    break;
                }
                let _e401 = radiance.member[_e397];
                let _e404 = (_e320 + _e43.member[3]);
                if (_e404 < _e27) {
                } else {
                    break;
                }
                let _e408 = radiance.member[_e404];
                let _e411 = (_e327 + _e43.member[3]);
                if (_e411 < _e27) {
                } else {
                    break;
                }
                let _e415 = radiance.member[_e411];
                let _e424 = ((((((((_e43.member_1[0] * _e311) + (_e43.member_1[1] * _e338)) + (_e43.member_1[2] * _e366)) + (_e43.member_1[3] * _e394)) * 0.886227f) + (((((_e43.member_1[0] * _e325) + (_e43.member_1[1] * _e352)) + (_e43.member_1[2] * _e380)) + (_e43.member_1[3] * _e408)) * _e179)) + (((((_e43.member_1[0] * _e332) + (_e43.member_1[1] * _e359)) + (_e43.member_1[2] * _e387)) + (_e43.member_1[3] * _e415)) * _e182)) + (((((_e43.member_1[0] * _e318) + (_e43.member_1[1] * _e345)) + (_e43.member_1[2] * _e373)) + (_e43.member_1[3] * _e401)) * _e185));
                if (_e38 < arrayLength((&irradiance.member))) {
                } else {
                    break;
                }
                irradiance.member[_e38] = vec4<f32>(select(0f, _e187, (_e187 > 0f)), select(0f, _e305, (_e305 > 0f)), select(0f, _e424, (_e424 > 0f)), 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_normal_mapped(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
