struct type_5 {
    member: array<f32>,
}

struct type_14 {
    member: array<vec4<f32>>,
}

struct type_16 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_17 {
    member: type_16,
}

struct type_19 {
    member: u32,
    member_1: f32,
}

struct type_21 {
    member: array<type_19>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_17;
@group(0) @binding(1) 
var<storage> sources: type_21;
@group(0) @binding(2) 
var<storage> partial: type_5;
@group(0) @binding(3) 
var<storage> coefs: type_5;
@group(0) @binding(4) 
var<storage, read_write> basis: type_14;

fn function_() {
    var phi_626_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = gid_1;
            let _e33 = arrayLength((&partial.member));
            let _e35 = arrayLength((&coefs.member));
            let _e40 = params.member.member;
            let _e44 = (_e29.x + (_e29.y * 2097152u));
            if (_e44 < _e40) {
                if (_e44 < arrayLength((&sources.member))) {
                } else {
                    break;
                }
                let _e50 = sources.member[_e44].member;
                let _e54 = sources.member[_e44].member_1;
                if ((_e50 & 2147483648u) == 0u) {
                    let _e84 = params.member.member_1;
                    let _e85 = (_e84 * 16u);
                    let _e89 = ((((_e50 % 2u) * 3u) * _e85) + ((_e50 / 2u) * 16u));
                    if (_e89 < _e33) {
                    } else {
                        break;
                    }
                    let _e93 = partial.member[_e89];
                    let _e94 = (_e89 + _e85);
                    if (_e94 < _e33) {
                    } else {
                        break;
                    }
                    let _e98 = partial.member[_e94];
                    let _e100 = (_e89 + (_e84 * 32u));
                    if (_e100 < _e33) {
                    } else {
                        break;
                    }
                    let _e104 = partial.member[_e100];
                    let _e105 = (_e89 + 1u);
                    if (_e105 < _e33) {
                    } else {
                        break;
                    }
                    let _e109 = partial.member[_e105];
                    let _e111 = (_e94 + 1u);
                    if (_e111 < _e33) {
                    } else {
                        break;
                    }
                    let _e115 = partial.member[_e111];
                    let _e117 = (_e100 + 1u);
                    if (_e117 < _e33) {
                    } else {
                        break;
                    }
                    let _e121 = partial.member[_e117];
                    let _e123 = (_e89 + 2u);
                    if (_e123 < _e33) {
                    } else {
                        break;
                    }
                    let _e127 = partial.member[_e123];
                    let _e129 = (_e94 + 2u);
                    if (_e129 < _e33) {
                    } else {
                        break;
                    }
                    let _e133 = partial.member[_e129];
                    let _e135 = (_e100 + 2u);
                    if (_e135 < _e33) {
                    } else {
                        break;
                    }
                    let _e139 = partial.member[_e135];
                    let _e141 = (_e89 + 3u);
                    if (_e141 < _e33) {
                    } else {
                        break;
                    }
                    let _e145 = partial.member[_e141];
                    let _e147 = (_e94 + 3u);
                    if (_e147 < _e33) {
                    } else {
                        break;
                    }
                    let _e151 = partial.member[_e147];
                    let _e153 = (_e100 + 3u);
                    if (_e153 < _e33) {
                    } else {
                        break;
                    }
                    let _e157 = partial.member[_e153];
                    let _e159 = (_e89 + 4u);
                    if (_e159 < _e33) {
                    } else {
                        break;
                    }
                    let _e163 = partial.member[_e159];
                    let _e165 = (_e94 + 4u);
                    if (_e165 < _e33) {
                    } else {
                        break;
                    }
                    let _e169 = partial.member[_e165];
                    let _e171 = (_e100 + 4u);
                    if (_e171 < _e33) {
                    } else {
                        break;
                    }
                    let _e175 = partial.member[_e171];
                    let _e177 = (_e89 + 5u);
                    if (_e177 < _e33) {
                    } else {
                        break;
                    }
                    let _e181 = partial.member[_e177];
                    let _e183 = (_e94 + 5u);
                    if (_e183 < _e33) {
                    } else {
                        break;
                    }
                    let _e187 = partial.member[_e183];
                    let _e189 = (_e100 + 5u);
                    if (_e189 < _e33) {
                    } else {
                        break;
                    }
                    let _e193 = partial.member[_e189];
                    let _e195 = (_e89 + 6u);
                    if (_e195 < _e33) {
                    } else {
                        break;
                    }
                    let _e199 = partial.member[_e195];
                    let _e201 = (_e94 + 6u);
                    if (_e201 < _e33) {
                    } else {
                        break;
                    }
                    let _e205 = partial.member[_e201];
                    let _e207 = (_e100 + 6u);
                    if (_e207 < _e33) {
                    } else {
                        break;
                    }
                    let _e211 = partial.member[_e207];
                    let _e213 = (_e89 + 7u);
                    if (_e213 < _e33) {
                    } else {
                        break;
                    }
                    let _e217 = partial.member[_e213];
                    let _e219 = (_e94 + 7u);
                    if (_e219 < _e33) {
                    } else {
                        break;
                    }
                    let _e223 = partial.member[_e219];
                    let _e225 = (_e100 + 7u);
                    if (_e225 < _e33) {
                    } else {
                        break;
                    }
                    let _e229 = partial.member[_e225];
                    let _e231 = (_e89 + 8u);
                    if (_e231 < _e33) {
                    } else {
                        break;
                    }
                    let _e235 = partial.member[_e231];
                    let _e237 = (_e94 + 8u);
                    if (_e237 < _e33) {
                    } else {
                        break;
                    }
                    let _e241 = partial.member[_e237];
                    let _e243 = (_e100 + 8u);
                    if (_e243 < _e33) {
                    } else {
                        break;
                    }
                    let _e247 = partial.member[_e243];
                    let _e249 = (_e89 + 9u);
                    if (_e249 < _e33) {
                    } else {
                        break;
                    }
                    let _e253 = partial.member[_e249];
                    let _e255 = (_e94 + 9u);
                    if (_e255 < _e33) {
                    } else {
                        break;
                    }
                    let _e259 = partial.member[_e255];
                    let _e261 = (_e100 + 9u);
                    if (_e261 < _e33) {
                    } else {
                        break;
                    }
                    let _e265 = partial.member[_e261];
                    let _e267 = (_e89 + 10u);
                    if (_e267 < _e33) {
                    } else {
                        break;
                    }
                    let _e271 = partial.member[_e267];
                    let _e273 = (_e94 + 10u);
                    if (_e273 < _e33) {
                    } else {
                        break;
                    }
                    let _e277 = partial.member[_e273];
                    let _e279 = (_e100 + 10u);
                    if (_e279 < _e33) {
                    } else {
                        break;
                    }
                    let _e283 = partial.member[_e279];
                    let _e285 = (_e89 + 11u);
                    if (_e285 < _e33) {
                    } else {
                        break;
                    }
                    let _e289 = partial.member[_e285];
                    let _e291 = (_e94 + 11u);
                    if (_e291 < _e33) {
                    } else {
                        break;
                    }
                    let _e295 = partial.member[_e291];
                    let _e297 = (_e100 + 11u);
                    if (_e297 < _e33) {
                    } else {
                        break;
                    }
                    let _e301 = partial.member[_e297];
                    let _e303 = (_e89 + 12u);
                    if (_e303 < _e33) {
                    } else {
                        break;
                    }
                    let _e307 = partial.member[_e303];
                    let _e309 = (_e94 + 12u);
                    if (_e309 < _e33) {
                    } else {
                        break;
                    }
                    let _e313 = partial.member[_e309];
                    let _e315 = (_e100 + 12u);
                    if (_e315 < _e33) {
                    } else {
                        break;
                    }
                    let _e319 = partial.member[_e315];
                    let _e321 = (_e89 + 13u);
                    if (_e321 < _e33) {
                    } else {
                        break;
                    }
                    let _e325 = partial.member[_e321];
                    let _e327 = (_e94 + 13u);
                    if (_e327 < _e33) {
                    } else {
                        break;
                    }
                    let _e331 = partial.member[_e327];
                    let _e333 = (_e100 + 13u);
                    if (_e333 < _e33) {
                    } else {
                        break;
                    }
                    let _e337 = partial.member[_e333];
                    let _e339 = (_e89 + 14u);
                    if (_e339 < _e33) {
                    } else {
                        break;
                    }
                    let _e343 = partial.member[_e339];
                    let _e345 = (_e94 + 14u);
                    if (_e345 < _e33) {
                    } else {
                        break;
                    }
                    let _e349 = partial.member[_e345];
                    let _e351 = (_e100 + 14u);
                    if (_e351 < _e33) {
                    } else {
                        break;
                    }
                    let _e355 = partial.member[_e351];
                    let _e357 = (_e89 + 15u);
                    if (_e357 < _e33) {
                    } else {
                        break;
                    }
                    let _e361 = partial.member[_e357];
                    let _e363 = (_e94 + 15u);
                    if (_e363 < _e33) {
                    } else {
                        break;
                    }
                    let _e367 = partial.member[_e363];
                    let _e369 = (_e100 + 15u);
                    if (_e369 < _e33) {
                    } else {
                        break;
                    }
                    let _e373 = partial.member[_e369];
                    phi_626_ = vec4<f32>(((((((((((((((((_e93 + _e109) + _e127) + _e145) + _e163) + _e181) + _e199) + _e217) + _e235) + _e253) + _e271) + _e289) + _e307) + _e325) + _e343) + _e361) * _e54), ((((((((((((((((_e98 + _e115) + _e133) + _e151) + _e169) + _e187) + _e205) + _e223) + _e241) + _e259) + _e277) + _e295) + _e313) + _e331) + _e349) + _e367) * _e54), ((((((((((((((((_e104 + _e121) + _e139) + _e157) + _e175) + _e193) + _e211) + _e229) + _e247) + _e265) + _e283) + _e301) + _e319) + _e337) + _e355) + _e373) * _e54), 0f);
                } else {
                    let _e57 = (_e50 & 2147483647u);
                    let _e60 = params.member.member_2;
                    if (_e57 < _e35) {
                    } else {
                        break;
                    }
                    let _e64 = coefs.member[_e57];
                    let _e65 = (_e60 + _e57);
                    if (_e65 < _e35) {
                    } else {
                        break;
                    }
                    let _e69 = coefs.member[_e65];
                    let _e71 = ((2u * _e60) + _e57);
                    if (_e71 < _e35) {
                    } else {
                        break;
                    }
                    let _e75 = coefs.member[_e71];
                    phi_626_ = vec4<f32>((_e64 * _e54), (_e69 * _e54), (_e75 * _e54), 0f);
                }
                let _e380 = phi_626_;
                if (_e44 < arrayLength((&basis.member))) {
                } else {
                    break;
                }
                basis.member[_e44] = _e380;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn srp_light_basis(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
