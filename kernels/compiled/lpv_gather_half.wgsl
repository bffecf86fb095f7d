struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<u32>,
}

struct type_19 {
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

struct type_26 {
    member: array<vec4<f32>>,
}

struct type_31 {
    member: array<vec4<f32>, 4>,
    member_1: array<vec4<i32>, 4>,
    member_2: array<vec4<u32>, 4>,
    member_3: u32,
    member_4: u32,
    member_5: f32,
    member_6: f32,
    member_7: f32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
}

struct type_32 {
    member: type_31,
}

struct type_35 {
    member: array<type_19>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> params: type_32;
@group(0) @binding(5) 
var<storage> surfels: type_35;
@group(0) @binding(6) 
var<storage, read_write> irradiance: type_26;
@group(0) @binding(1) 
var<storage> a: type_10;
@group(0) @binding(2) 
var<storage> b: type_10;
@group(0) @binding(3) 
var<storage> c: type_10;
@group(0) @binding(4) 
var<storage> d: type_10;

fn function_() {
    var phi_212_: f32;
    var phi_493_: type_7;
    var phi_496_: f32;
    var phi_498_: array<array<f32, 4>, 3>;
    var phi_494_: type_7;
    var phi_521_: type_7;
    var phi_551_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_653_: u32;
    var phi_654_: u32;
    var phi_655_: bool;
    var phi_664_: bool;
    var phi_676_: f32;
    var phi_729_: u32;
    var phi_730_: u32;
    var phi_731_: bool;
    var phi_740_: bool;
    var phi_752_: f32;
    var phi_805_: u32;
    var phi_806_: u32;
    var phi_807_: bool;
    var phi_816_: bool;
    var phi_828_: f32;
    var phi_881_: u32;
    var phi_882_: u32;
    var phi_883_: bool;
    var phi_892_: bool;
    var phi_904_: f32;
    var phi_957_: u32;
    var phi_958_: u32;
    var phi_959_: bool;
    var phi_968_: bool;
    var phi_980_: f32;
    var phi_1033_: u32;
    var phi_1034_: u32;
    var phi_1035_: bool;
    var phi_1044_: bool;
    var phi_1056_: f32;
    var phi_1109_: u32;
    var phi_1110_: u32;
    var phi_1111_: bool;
    var phi_1120_: bool;
    var phi_1132_: f32;
    var phi_1185_: u32;
    var phi_1186_: u32;
    var phi_1187_: bool;
    var phi_1196_: bool;
    var phi_1208_: f32;
    var phi_1261_: u32;
    var phi_1262_: u32;
    var phi_1263_: bool;
    var phi_1272_: bool;
    var phi_1284_: f32;
    var phi_1337_: u32;
    var phi_1338_: u32;
    var phi_1339_: bool;
    var phi_1348_: bool;
    var phi_1360_: f32;
    var phi_1413_: u32;
    var phi_1414_: u32;
    var phi_1415_: bool;
    var phi_1424_: bool;
    var phi_1436_: f32;
    var phi_1489_: u32;
    var phi_1490_: u32;
    var phi_1491_: bool;
    var phi_1500_: bool;
    var phi_1512_: f32;
    var phi_1518_: f32;
    var phi_1519_: array<array<f32, 4>, 3>;
    var phi_497_: f32;
    var phi_499_: array<array<f32, 4>, 3>;
    var phi_14246_: bool;
    var local: f32;
    var local_1: f32;
    var phi_1525_: f32;
    var local_2: array<array<f32, 4>, 3>;
    var local_3: array<array<f32, 4>, 3>;
    var local_4: array<array<f32, 4>, 3>;
    var local_5: array<array<f32, 4>, 3>;
    var local_6: array<array<f32, 4>, 3>;
    var local_7: array<array<f32, 4>, 3>;
    var local_8: array<array<f32, 4>, 3>;
    var local_9: array<array<f32, 4>, 3>;
    var local_10: array<array<f32, 4>, 3>;
    var local_11: array<array<f32, 4>, 3>;
    var local_12: array<array<f32, 4>, 3>;
    var local_13: array<array<f32, 4>, 3>;
    var phi_14359_: bool;
    var phi_3663_: vec4<f32>;
    var phi_14357_: bool;
    var phi_3665_: vec4<f32>;
    var phi_3726_: f32;
    var phi_4007_: type_7;
    var phi_4010_: f32;
    var phi_4012_: array<array<f32, 4>, 3>;
    var phi_4008_: type_7;
    var phi_4035_: type_7;
    var phi_4065_: f32;
    var phi_4070_: f32;
    var phi_4076_: f32;
    var phi_4167_: u32;
    var phi_4168_: u32;
    var phi_4169_: bool;
    var phi_4178_: bool;
    var phi_4190_: f32;
    var phi_4243_: u32;
    var phi_4244_: u32;
    var phi_4245_: bool;
    var phi_4254_: bool;
    var phi_4266_: f32;
    var phi_4319_: u32;
    var phi_4320_: u32;
    var phi_4321_: bool;
    var phi_4330_: bool;
    var phi_4342_: f32;
    var phi_4395_: u32;
    var phi_4396_: u32;
    var phi_4397_: bool;
    var phi_4406_: bool;
    var phi_4418_: f32;
    var phi_4471_: u32;
    var phi_4472_: u32;
    var phi_4473_: bool;
    var phi_4482_: bool;
    var phi_4494_: f32;
    var phi_4547_: u32;
    var phi_4548_: u32;
    var phi_4549_: bool;
    var phi_4558_: bool;
    var phi_4570_: f32;
    var phi_4623_: u32;
    var phi_4624_: u32;
    var phi_4625_: bool;
    var phi_4634_: bool;
    var phi_4646_: f32;
    var phi_4699_: u32;
    var phi_4700_: u32;
    var phi_4701_: bool;
    var phi_4710_: bool;
    var phi_4722_: f32;
    var phi_4775_: u32;
    var phi_4776_: u32;
    var phi_4777_: bool;
    var phi_4786_: bool;
    var phi_4798_: f32;
    var phi_4851_: u32;
    var phi_4852_: u32;
    var phi_4853_: bool;
    var phi_4862_: bool;
    var phi_4874_: f32;
    var phi_4927_: u32;
    var phi_4928_: u32;
    var phi_4929_: bool;
    var phi_4938_: bool;
    var phi_4950_: f32;
    var phi_5003_: u32;
    var phi_5004_: u32;
    var phi_5005_: bool;
    var phi_5014_: bool;
    var phi_5026_: f32;
    var phi_5032_: f32;
    var phi_5033_: array<array<f32, 4>, 3>;
    var phi_4011_: f32;
    var phi_4013_: array<array<f32, 4>, 3>;
    var phi_14331_: bool;
    var local_14: f32;
    var local_15: f32;
    var phi_5039_: f32;
    var local_16: array<array<f32, 4>, 3>;
    var local_17: array<array<f32, 4>, 3>;
    var local_18: array<array<f32, 4>, 3>;
    var local_19: array<array<f32, 4>, 3>;
    var local_20: array<array<f32, 4>, 3>;
    var local_21: array<array<f32, 4>, 3>;
    var local_22: array<array<f32, 4>, 3>;
    var local_23: array<array<f32, 4>, 3>;
    var local_24: array<array<f32, 4>, 3>;
    var local_25: array<array<f32, 4>, 3>;
    var local_26: array<array<f32, 4>, 3>;
    var local_27: array<array<f32, 4>, 3>;
    var phi_14659_: bool;
    var phi_7177_: vec4<f32>;
    var phi_14658_: bool;
    var phi_7178_: vec4<f32>;
    var phi_14657_: bool;
    var phi_7179_: vec4<f32>;
    var phi_7180_: bool;
    var phi_7240_: f32;
    var phi_7521_: type_7;
    var phi_7524_: f32;
    var phi_7526_: array<array<f32, 4>, 3>;
    var phi_7522_: type_7;
    var phi_7549_: type_7;
    var phi_7579_: f32;
    var phi_7584_: f32;
    var phi_7590_: f32;
    var phi_7681_: u32;
    var phi_7682_: u32;
    var phi_7683_: bool;
    var phi_7692_: bool;
    var phi_7704_: f32;
    var phi_7757_: u32;
    var phi_7758_: u32;
    var phi_7759_: bool;
    var phi_7768_: bool;
    var phi_7780_: f32;
    var phi_7833_: u32;
    var phi_7834_: u32;
    var phi_7835_: bool;
    var phi_7844_: bool;
    var phi_7856_: f32;
    var phi_7909_: u32;
    var phi_7910_: u32;
    var phi_7911_: bool;
    var phi_7920_: bool;
    var phi_7932_: f32;
    var phi_7985_: u32;
    var phi_7986_: u32;
    var phi_7987_: bool;
    var phi_7996_: bool;
    var phi_8008_: f32;
    var phi_8061_: u32;
    var phi_8062_: u32;
    var phi_8063_: bool;
    var phi_8072_: bool;
    var phi_8084_: f32;
    var phi_8137_: u32;
    var phi_8138_: u32;
    var phi_8139_: bool;
    var phi_8148_: bool;
    var phi_8160_: f32;
    var phi_8213_: u32;
    var phi_8214_: u32;
    var phi_8215_: bool;
    var phi_8224_: bool;
    var phi_8236_: f32;
    var phi_8289_: u32;
    var phi_8290_: u32;
    var phi_8291_: bool;
    var phi_8300_: bool;
    var phi_8312_: f32;
    var phi_8365_: u32;
    var phi_8366_: u32;
    var phi_8367_: bool;
    var phi_8376_: bool;
    var phi_8388_: f32;
    var phi_8441_: u32;
    var phi_8442_: u32;
    var phi_8443_: bool;
    var phi_8452_: bool;
    var phi_8464_: f32;
    var phi_8517_: u32;
    var phi_8518_: u32;
    var phi_8519_: bool;
    var phi_8528_: bool;
    var phi_8540_: f32;
    var phi_8546_: f32;
    var phi_8547_: array<array<f32, 4>, 3>;
    var phi_7525_: f32;
    var phi_7527_: array<array<f32, 4>, 3>;
    var phi_14631_: bool;
    var local_28: f32;
    var local_29: f32;
    var phi_8553_: f32;
    var local_30: array<array<f32, 4>, 3>;
    var local_31: array<array<f32, 4>, 3>;
    var local_32: array<array<f32, 4>, 3>;
    var local_33: array<array<f32, 4>, 3>;
    var local_34: array<array<f32, 4>, 3>;
    var local_35: array<array<f32, 4>, 3>;
    var local_36: array<array<f32, 4>, 3>;
    var local_37: array<array<f32, 4>, 3>;
    var local_38: array<array<f32, 4>, 3>;
    var local_39: array<array<f32, 4>, 3>;
    var local_40: array<array<f32, 4>, 3>;
    var local_41: array<array<f32, 4>, 3>;
    var phi_14959_: bool;
    var phi_10691_: vec4<f32>;
    var phi_14958_: bool;
    var phi_10692_: vec4<f32>;
    var phi_14957_: bool;
    var phi_10693_: vec4<f32>;
    var phi_10694_: bool;
    var phi_10754_: f32;
    var phi_11035_: type_7;
    var phi_11038_: f32;
    var phi_11040_: array<array<f32, 4>, 3>;
    var phi_11036_: type_7;
    var phi_11063_: type_7;
    var phi_11093_: f32;
    var phi_11098_: f32;
    var phi_11104_: f32;
    var phi_11195_: u32;
    var phi_11196_: u32;
    var phi_11197_: bool;
    var phi_11206_: bool;
    var phi_11218_: f32;
    var phi_11271_: u32;
    var phi_11272_: u32;
    var phi_11273_: bool;
    var phi_11282_: bool;
    var phi_11294_: f32;
    var phi_11347_: u32;
    var phi_11348_: u32;
    var phi_11349_: bool;
    var phi_11358_: bool;
    var phi_11370_: f32;
    var phi_11423_: u32;
    var phi_11424_: u32;
    var phi_11425_: bool;
    var phi_11434_: bool;
    var phi_11446_: f32;
    var phi_11499_: u32;
    var phi_11500_: u32;
    var phi_11501_: bool;
    var phi_11510_: bool;
    var phi_11522_: f32;
    var phi_11575_: u32;
    var phi_11576_: u32;
    var phi_11577_: bool;
    var phi_11586_: bool;
    var phi_11598_: f32;
    var phi_11651_: u32;
    var phi_11652_: u32;
    var phi_11653_: bool;
    var phi_11662_: bool;
    var phi_11674_: f32;
    var phi_11727_: u32;
    var phi_11728_: u32;
    var phi_11729_: bool;
    var phi_11738_: bool;
    var phi_11750_: f32;
    var phi_11803_: u32;
    var phi_11804_: u32;
    var phi_11805_: bool;
    var phi_11814_: bool;
    var phi_11826_: f32;
    var phi_11879_: u32;
    var phi_11880_: u32;
    var phi_11881_: bool;
    var phi_11890_: bool;
    var phi_11902_: f32;
    var phi_11955_: u32;
    var phi_11956_: u32;
    var phi_11957_: bool;
    var phi_11966_: bool;
    var phi_11978_: f32;
    var phi_12031_: u32;
    var phi_12032_: u32;
    var phi_12033_: bool;
    var phi_12042_: bool;
    var phi_12054_: f32;
    var phi_12060_: f32;
    var phi_12061_: array<array<f32, 4>, 3>;
    var phi_11039_: f32;
    var phi_11041_: array<array<f32, 4>, 3>;
    var phi_14931_: bool;
    var local_42: f32;
    var local_43: f32;
    var phi_12067_: f32;
    var local_44: array<array<f32, 4>, 3>;
    var local_45: array<array<f32, 4>, 3>;
    var local_46: array<array<f32, 4>, 3>;
    var local_47: array<array<f32, 4>, 3>;
    var local_48: array<array<f32, 4>, 3>;
    var local_49: array<array<f32, 4>, 3>;
    var local_50: array<array<f32, 4>, 3>;
    var local_51: array<array<f32, 4>, 3>;
    var local_52: array<array<f32, 4>, 3>;
    var local_53: array<array<f32, 4>, 3>;
    var local_54: array<array<f32, 4>, 3>;
    var local_55: array<array<f32, 4>, 3>;
    var phi_14205_: vec4<f32>;
    var phi_14206_: vec4<f32>;
    var phi_14207_: vec4<f32>;
    var phi_14208_: bool;
    var phi_14217_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e60 = gid_1;
            let _e63 = arrayLength((&a.member));
            let _e66 = arrayLength((&b.member));
            let _e69 = arrayLength((&c.member));
            let _e72 = arrayLength((&d.member));
            let _e80 = (_e60.x + (_e60.y * 2097152u));
            let _e81 = (_e80 < arrayLength((&irradiance.member)));
            if _e81 {
                if (_e80 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e85 = surfels.member[_e80];
                if (_e85.member_1 == 4294967295u) {
                    phi_14217_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e90 = params.member.member_7;
                    let _e91 = (1f / _e90);
                    let _e94 = params.member.member_3;
                    let _e95 = (0u >= _e94);
                    if _e95 {
                        phi_14357_ = false;
                        phi_3665_ = vec4<f32>();
                    } else {
                        let _e99 = params.member.member[0u];
                        let _e103 = params.member.member_1[0u];
                        let _e107 = params.member.member_2[0u];
                        if (1u == _e94) {
                            phi_212_ = 0f;
                        } else {
                            let _e119 = params.member.member_5;
                            phi_212_ = _e119;
                        }
                        let _e121 = phi_212_;
                        let _e129 = ((_e85.member[0] - _e99.x) / _e99.w);
                        let _e130 = ((_e85.member[1] - _e99.y) / _e99.w);
                        let _e131 = ((_e85.member[2] - _e99.z) / _e99.w);
                        let _e138 = (_e129 - f32(_e103.x));
                        let _e139 = (_e130 - f32(_e103.y));
                        let _e140 = (_e131 - f32(_e103.z));
                        let _e148 = select(_e140, _e139, (_e139 < _e140));
                        let _e150 = select(_e148, _e138, (_e138 < _e148));
                        let _e151 = (f32(_e107.x) - _e138);
                        let _e152 = (f32(_e107.y) - _e139);
                        let _e153 = (f32(_e107.z) - _e140);
                        let _e155 = select(_e153, _e152, (_e152 < _e153));
                        let _e157 = select(_e155, _e151, (_e151 < _e155));
                        let _e162 = (select(_e157, _e150, (_e150 < _e157)) / select(0.001f, _e121, (_e121 > 0.001f)));
                        let _e164 = select(0f, _e162, (_e162 > 0f));
                        let _e166 = select(1f, _e164, (_e164 < 1f));
                        if (_e166 <= 0f) {
                            phi_14359_ = false;
                            phi_3663_ = vec4<f32>(0f, 0f, 0f, 1f);
                        } else {
                            let _e170 = params.member.member_6;
                            let _e171 = (_e107.x + 1u);
                            let _e173 = ((_e107.y + 1u) * _e171);
                            let _e174 = (_e173 + _e171);
                            let _e177 = (_e174 + ((_e107.z + 1u) * _e173));
                            let _e184 = ((_e129 + (_e85.member_2[0] * _e170)) - 0.5f);
                            let _e185 = floor(_e184);
                            let _e187 = (bitcast<i32>(_e107.x) - 1i);
                            let _e195 = (select(0i, select(select(i32(_e185), i32(-2147483648), (_e185 < -2147483600f)), 2147483647i, (_e185 > 2147483500f)), (_e185 == _e185)) - _e103.x);
                            let _e197 = select(0i, _e195, (0i < _e195));
                            let _e199 = select(_e197, _e187, (_e187 < _e197));
                            let _e200 = (_e195 + 1i);
                            let _e202 = select(0i, _e200, (0i < _e200));
                            let _e204 = select(_e202, _e187, (_e187 < _e202));
                            let _e207 = (_e184 - _e185);
                            let _e214 = ((_e130 + (_e85.member_2[1] * _e170)) - 0.5f);
                            let _e215 = floor(_e214);
                            let _e217 = (bitcast<i32>(_e107.y) - 1i);
                            let _e225 = (select(0i, select(select(i32(_e215), i32(-2147483648), (_e215 < -2147483600f)), 2147483647i, (_e215 > 2147483500f)), (_e215 == _e215)) - _e103.y);
                            let _e227 = select(0i, _e225, (0i < _e225));
                            let _e229 = select(_e227, _e217, (_e217 < _e227));
                            let _e230 = (_e225 + 1i);
                            let _e232 = select(0i, _e230, (0i < _e230));
                            let _e234 = select(_e232, _e217, (_e217 < _e232));
                            let _e237 = (_e214 - _e215);
                            let _e244 = ((_e131 + (_e85.member_2[2] * _e170)) - 0.5f);
                            let _e245 = floor(_e244);
                            let _e247 = (bitcast<i32>(_e107.z) - 1i);
                            let _e255 = (select(0i, select(select(i32(_e245), i32(-2147483648), (_e245 < -2147483600f)), 2147483647i, (_e245 > 2147483500f)), (_e245 == _e245)) - _e103.z);
                            let _e257 = select(0i, _e255, (0i < _e255));
                            let _e259 = select(_e257, _e247, (_e247 < _e257));
                            let _e260 = (_e255 + 1i);
                            let _e262 = select(0i, _e260, (0i < _e260));
                            let _e264 = select(_e262, _e247, (_e247 < _e262));
                            let _e267 = (_e244 - _e245);
                            phi_493_ = type_7(0u, 8u);
                            phi_496_ = 0f;
                            phi_498_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                            loop {
                                let _e275 = phi_493_;
                                let _e277 = phi_496_;
                                let _e279 = phi_498_;
                                local = _e277;
                                local_1 = _e277;
                                local_2 = _e279;
                                local_3 = _e279;
                                local_4 = _e279;
                                local_5 = _e279;
                                local_6 = _e279;
                                local_7 = _e279;
                                local_8 = _e279;
                                local_9 = _e279;
                                local_10 = _e279;
                                local_11 = _e279;
                                local_12 = _e279;
                                local_13 = _e279;
                                if (_e275.member < _e275.member_1) {
                                    phi_494_ = type_7((_e275.member + 1u), _e275.member_1);
                                    phi_521_ = type_7(1u, _e275.member);
                                } else {
                                    phi_494_ = _e275;
                                    phi_521_ = type_7(0u, type_7().member_1);
                                }
                                let _e292 = phi_494_;
                                let _e294 = phi_521_;
                                let _e298 = (bitcast<i32>(_e294.member) != 0i);
                                if _e298 {
                                    let _e300 = ((_e294.member_1 & 1u) == 1u);
                                    let _e302 = ((_e294.member_1 & 2u) == 2u);
                                    let _e304 = ((_e294.member_1 & 4u) == 4u);
                                    if _e300 {
                                        phi_551_ = _e207;
                                    } else {
                                        phi_551_ = (1f - _e207);
                                    }
                                    let _e310 = phi_551_;
                                    if _e302 {
                                        phi_556_ = _e237;
                                    } else {
                                        phi_556_ = (1f - _e237);
                                    }
                                    let _e313 = phi_556_;
                                    if _e304 {
                                        phi_562_ = _e267;
                                    } else {
                                        phi_562_ = (1f - _e267);
                                    }
                                    let _e317 = phi_562_;
                                    let _e327 = (((((select((f32((_e199 + _e103.x)) + 0.5f), (f32((_e204 + _e103.x)) + 0.5f), _e300) - _e129) * _e85.member_2[0]) + ((select((f32((_e229 + _e103.y)) + 0.5f), (f32((_e234 + _e103.y)) + 0.5f), _e302) - _e130) * _e85.member_2[1])) + ((select((f32((_e259 + _e103.z)) + 0.5f), (f32((_e264 + _e103.z)) + 0.5f), _e304) - _e131) * _e85.member_2[2])) * 2f);
                                    let _e329 = select(0f, _e327, (_e327 > 0f));
                                    let _e332 = (((_e310 * _e313) * _e317) * select(1f, _e329, (_e329 < 1f)));
                                    if (_e332 > 0f) {
                                        let _e341 = (((_e174 + select(bitcast<u32>(_e199), bitcast<u32>(_e204), _e300)) + (select(bitcast<u32>(_e229), bitcast<u32>(_e234), _e302) * _e171)) + (select(bitcast<u32>(_e259), bitcast<u32>(_e264), _e304) * _e173));
                                        let _e343 = (_e341 < _e63);
                                        if _e343 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e345 = a.member[_e341];
                                        let _e346 = (_e345 & 65535u);
                                        let _e349 = ((_e346 & 32768u) << bitcast<u32>(16i));
                                        let _e352 = ((_e346 >> bitcast<u32>(10i)) & 31u);
                                        let _e353 = (_e346 & 1023u);
                                        if (_e352 == 0u) {
                                            phi_676_ = bitcast<f32>((_e349 | bitcast<u32>((f32(_e353) * 0.000000059604645f))));
                                        } else {
                                            if (_e352 == 31u) {
                                                phi_653_ = 255u;
                                                phi_654_ = u32();
                                                phi_655_ = true;
                                            } else {
                                                let _e356 = (_e352 + 112u);
                                                phi_653_ = _e356;
                                                phi_654_ = _e356;
                                                phi_655_ = (_e356 == 255u);
                                            }
                                            let _e359 = phi_653_;
                                            let _e361 = phi_654_;
                                            let _e363 = phi_655_;
                                            if _e363 {
                                                phi_664_ = (_e353 == 0u);
                                            } else {
                                                phi_664_ = true;
                                            }
                                            let _e366 = phi_664_;
                                            phi_676_ = bitcast<f32>((((_e349 | (select(_e359, select(_e361, _e359, _e363), _e366) << bitcast<u32>(23i))) | (_e353 << bitcast<u32>(13i))) | select(4194304u, 0u, _e366)));
                                        }
                                        let _e384 = phi_676_;
                                        if _e343 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e392 = ((_e345 >> bitcast<u32>(16u)) & 65535u);
                                        let _e395 = ((_e392 & 32768u) << bitcast<u32>(16i));
                                        let _e398 = ((_e392 >> bitcast<u32>(10i)) & 31u);
                                        let _e399 = (_e392 & 1023u);
                                        if (_e398 == 0u) {
                                            phi_752_ = bitcast<f32>((_e395 | bitcast<u32>((f32(_e399) * 0.000000059604645f))));
                                        } else {
                                            if (_e398 == 31u) {
                                                phi_729_ = 255u;
                                                phi_730_ = u32();
                                                phi_731_ = true;
                                            } else {
                                                let _e402 = (_e398 + 112u);
                                                phi_729_ = _e402;
                                                phi_730_ = _e402;
                                                phi_731_ = (_e402 == 255u);
                                            }
                                            let _e405 = phi_729_;
                                            let _e407 = phi_730_;
                                            let _e409 = phi_731_;
                                            if _e409 {
                                                phi_740_ = (_e399 == 0u);
                                            } else {
                                                phi_740_ = true;
                                            }
                                            let _e412 = phi_740_;
                                            phi_752_ = bitcast<f32>((((_e395 | (select(_e405, select(_e407, _e405, _e409), _e412) << bitcast<u32>(23i))) | (_e399 << bitcast<u32>(13i))) | select(4194304u, 0u, _e412)));
                                        }
                                        let _e430 = phi_752_;
                                        let _e436 = (3u * _e177);
                                        let _e437 = (_e436 + _e341);
                                        let _e438 = (_e437 < _e63);
                                        if _e438 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e440 = a.member[_e437];
                                        let _e441 = (_e440 & 65535u);
                                        let _e444 = ((_e441 & 32768u) << bitcast<u32>(16i));
                                        let _e447 = ((_e441 >> bitcast<u32>(10i)) & 31u);
                                        let _e448 = (_e441 & 1023u);
                                        if (_e447 == 0u) {
                                            phi_828_ = bitcast<f32>((_e444 | bitcast<u32>((f32(_e448) * 0.000000059604645f))));
                                        } else {
                                            if (_e447 == 31u) {
                                                phi_805_ = 255u;
                                                phi_806_ = u32();
                                                phi_807_ = true;
                                            } else {
                                                let _e451 = (_e447 + 112u);
                                                phi_805_ = _e451;
                                                phi_806_ = _e451;
                                                phi_807_ = (_e451 == 255u);
                                            }
                                            let _e454 = phi_805_;
                                            let _e456 = phi_806_;
                                            let _e458 = phi_807_;
                                            if _e458 {
                                                phi_816_ = (_e448 == 0u);
                                            } else {
                                                phi_816_ = true;
                                            }
                                            let _e461 = phi_816_;
                                            phi_828_ = bitcast<f32>((((_e444 | (select(_e454, select(_e456, _e454, _e458), _e461) << bitcast<u32>(23i))) | (_e448 << bitcast<u32>(13i))) | select(4194304u, 0u, _e461)));
                                        }
                                        let _e479 = phi_828_;
                                        if _e438 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e487 = ((_e440 >> bitcast<u32>(16u)) & 65535u);
                                        let _e490 = ((_e487 & 32768u) << bitcast<u32>(16i));
                                        let _e493 = ((_e487 >> bitcast<u32>(10i)) & 31u);
                                        let _e494 = (_e487 & 1023u);
                                        if (_e493 == 0u) {
                                            phi_904_ = bitcast<f32>((_e490 | bitcast<u32>((f32(_e494) * 0.000000059604645f))));
                                        } else {
                                            if (_e493 == 31u) {
                                                phi_881_ = 255u;
                                                phi_882_ = u32();
                                                phi_883_ = true;
                                            } else {
                                                let _e497 = (_e493 + 112u);
                                                phi_881_ = _e497;
                                                phi_882_ = _e497;
                                                phi_883_ = (_e497 == 255u);
                                            }
                                            let _e500 = phi_881_;
                                            let _e502 = phi_882_;
                                            let _e504 = phi_883_;
                                            if _e504 {
                                                phi_892_ = (_e494 == 0u);
                                            } else {
                                                phi_892_ = true;
                                            }
                                            let _e507 = phi_892_;
                                            phi_904_ = bitcast<f32>((((_e490 | (select(_e500, select(_e502, _e500, _e504), _e507) << bitcast<u32>(23i))) | (_e494 << bitcast<u32>(13i))) | select(4194304u, 0u, _e507)));
                                        }
                                        let _e525 = phi_904_;
                                        let _e532 = (_e177 + _e341);
                                        let _e533 = (_e532 < _e63);
                                        if _e533 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e535 = a.member[_e532];
                                        let _e536 = (_e535 & 65535u);
                                        let _e539 = ((_e536 & 32768u) << bitcast<u32>(16i));
                                        let _e542 = ((_e536 >> bitcast<u32>(10i)) & 31u);
                                        let _e543 = (_e536 & 1023u);
                                        if (_e542 == 0u) {
                                            phi_980_ = bitcast<f32>((_e539 | bitcast<u32>((f32(_e543) * 0.000000059604645f))));
                                        } else {
                                            if (_e542 == 31u) {
                                                phi_957_ = 255u;
                                                phi_958_ = u32();
                                                phi_959_ = true;
                                            } else {
                                                let _e546 = (_e542 + 112u);
                                                phi_957_ = _e546;
                                                phi_958_ = _e546;
                                                phi_959_ = (_e546 == 255u);
                                            }
                                            let _e549 = phi_957_;
                                            let _e551 = phi_958_;
                                            let _e553 = phi_959_;
                                            if _e553 {
                                                phi_968_ = (_e543 == 0u);
                                            } else {
                                                phi_968_ = true;
                                            }
                                            let _e556 = phi_968_;
                                            phi_980_ = bitcast<f32>((((_e539 | (select(_e549, select(_e551, _e549, _e553), _e556) << bitcast<u32>(23i))) | (_e543 << bitcast<u32>(13i))) | select(4194304u, 0u, _e556)));
                                        }
                                        let _e574 = phi_980_;
                                        if _e533 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e582 = ((_e535 >> bitcast<u32>(16u)) & 65535u);
                                        let _e585 = ((_e582 & 32768u) << bitcast<u32>(16i));
                                        let _e588 = ((_e582 >> bitcast<u32>(10i)) & 31u);
                                        let _e589 = (_e582 & 1023u);
                                        if (_e588 == 0u) {
                                            phi_1056_ = bitcast<f32>((_e585 | bitcast<u32>((f32(_e589) * 0.000000059604645f))));
                                        } else {
                                            if (_e588 == 31u) {
                                                phi_1033_ = 255u;
                                                phi_1034_ = u32();
                                                phi_1035_ = true;
                                            } else {
                                                let _e592 = (_e588 + 112u);
                                                phi_1033_ = _e592;
                                                phi_1034_ = _e592;
                                                phi_1035_ = (_e592 == 255u);
                                            }
                                            let _e595 = phi_1033_;
                                            let _e597 = phi_1034_;
                                            let _e599 = phi_1035_;
                                            if _e599 {
                                                phi_1044_ = (_e589 == 0u);
                                            } else {
                                                phi_1044_ = true;
                                            }
                                            let _e602 = phi_1044_;
                                            phi_1056_ = bitcast<f32>((((_e585 | (select(_e595, select(_e597, _e595, _e599), _e602) << bitcast<u32>(23i))) | (_e589 << bitcast<u32>(13i))) | select(4194304u, 0u, _e602)));
                                        }
                                        let _e620 = phi_1056_;
                                        let _e626 = (_e436 + _e532);
                                        let _e627 = (_e626 < _e63);
                                        if _e627 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e629 = a.member[_e626];
                                        let _e630 = (_e629 & 65535u);
                                        let _e633 = ((_e630 & 32768u) << bitcast<u32>(16i));
                                        let _e636 = ((_e630 >> bitcast<u32>(10i)) & 31u);
                                        let _e637 = (_e630 & 1023u);
                                        if (_e636 == 0u) {
                                            phi_1132_ = bitcast<f32>((_e633 | bitcast<u32>((f32(_e637) * 0.000000059604645f))));
                                        } else {
                                            if (_e636 == 31u) {
                                                phi_1109_ = 255u;
                                                phi_1110_ = u32();
                                                phi_1111_ = true;
                                            } else {
                                                let _e640 = (_e636 + 112u);
                                                phi_1109_ = _e640;
                                                phi_1110_ = _e640;
                                                phi_1111_ = (_e640 == 255u);
                                            }
                                            let _e643 = phi_1109_;
                                            let _e645 = phi_1110_;
                                            let _e647 = phi_1111_;
                                            if _e647 {
                                                phi_1120_ = (_e637 == 0u);
                                            } else {
                                                phi_1120_ = true;
                                            }
                                            let _e650 = phi_1120_;
                                            phi_1132_ = bitcast<f32>((((_e633 | (select(_e643, select(_e645, _e643, _e647), _e650) << bitcast<u32>(23i))) | (_e637 << bitcast<u32>(13i))) | select(4194304u, 0u, _e650)));
                                        }
                                        let _e668 = phi_1132_;
                                        if _e627 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e676 = ((_e629 >> bitcast<u32>(16u)) & 65535u);
                                        let _e679 = ((_e676 & 32768u) << bitcast<u32>(16i));
                                        let _e682 = ((_e676 >> bitcast<u32>(10i)) & 31u);
                                        let _e683 = (_e676 & 1023u);
                                        if (_e682 == 0u) {
                                            phi_1208_ = bitcast<f32>((_e679 | bitcast<u32>((f32(_e683) * 0.000000059604645f))));
                                        } else {
                                            if (_e682 == 31u) {
                                                phi_1185_ = 255u;
                                                phi_1186_ = u32();
                                                phi_1187_ = true;
                                            } else {
                                                let _e686 = (_e682 + 112u);
                                                phi_1185_ = _e686;
                                                phi_1186_ = _e686;
                                                phi_1187_ = (_e686 == 255u);
                                            }
                                            let _e689 = phi_1185_;
                                            let _e691 = phi_1186_;
                                            let _e693 = phi_1187_;
                                            if _e693 {
                                                phi_1196_ = (_e683 == 0u);
                                            } else {
                                                phi_1196_ = true;
                                            }
                                            let _e696 = phi_1196_;
                                            phi_1208_ = bitcast<f32>((((_e679 | (select(_e689, select(_e691, _e689, _e693), _e696) << bitcast<u32>(23i))) | (_e683 << bitcast<u32>(13i))) | select(4194304u, 0u, _e696)));
                                        }
                                        let _e714 = phi_1208_;
                                        let _e722 = ((2u * _e177) + _e341);
                                        let _e723 = (_e722 < _e63);
                                        if _e723 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e725 = a.member[_e722];
                                        let _e726 = (_e725 & 65535u);
                                        let _e729 = ((_e726 & 32768u) << bitcast<u32>(16i));
                                        let _e732 = ((_e726 >> bitcast<u32>(10i)) & 31u);
                                        let _e733 = (_e726 & 1023u);
                                        if (_e732 == 0u) {
                                            phi_1284_ = bitcast<f32>((_e729 | bitcast<u32>((f32(_e733) * 0.000000059604645f))));
                                        } else {
                                            if (_e732 == 31u) {
                                                phi_1261_ = 255u;
                                                phi_1262_ = u32();
                                                phi_1263_ = true;
                                            } else {
                                                let _e736 = (_e732 + 112u);
                                                phi_1261_ = _e736;
                                                phi_1262_ = _e736;
                                                phi_1263_ = (_e736 == 255u);
                                            }
                                            let _e739 = phi_1261_;
                                            let _e741 = phi_1262_;
                                            let _e743 = phi_1263_;
                                            if _e743 {
                                                phi_1272_ = (_e733 == 0u);
                                            } else {
                                                phi_1272_ = true;
                                            }
                                            let _e746 = phi_1272_;
                                            phi_1284_ = bitcast<f32>((((_e729 | (select(_e739, select(_e741, _e739, _e743), _e746) << bitcast<u32>(23i))) | (_e733 << bitcast<u32>(13i))) | select(4194304u, 0u, _e746)));
                                        }
                                        let _e764 = phi_1284_;
                                        if _e723 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e772 = ((_e725 >> bitcast<u32>(16u)) & 65535u);
                                        let _e775 = ((_e772 & 32768u) << bitcast<u32>(16i));
                                        let _e778 = ((_e772 >> bitcast<u32>(10i)) & 31u);
                                        let _e779 = (_e772 & 1023u);
                                        if (_e778 == 0u) {
                                            phi_1360_ = bitcast<f32>((_e775 | bitcast<u32>((f32(_e779) * 0.000000059604645f))));
                                        } else {
                                            if (_e778 == 31u) {
                                                phi_1337_ = 255u;
                                                phi_1338_ = u32();
                                                phi_1339_ = true;
                                            } else {
                                                let _e782 = (_e778 + 112u);
                                                phi_1337_ = _e782;
                                                phi_1338_ = _e782;
                                                phi_1339_ = (_e782 == 255u);
                                            }
                                            let _e785 = phi_1337_;
                                            let _e787 = phi_1338_;
                                            let _e789 = phi_1339_;
                                            if _e789 {
                                                phi_1348_ = (_e779 == 0u);
                                            } else {
                                                phi_1348_ = true;
                                            }
                                            let _e792 = phi_1348_;
                                            phi_1360_ = bitcast<f32>((((_e775 | (select(_e785, select(_e787, _e785, _e789), _e792) << bitcast<u32>(23i))) | (_e779 << bitcast<u32>(13i))) | select(4194304u, 0u, _e792)));
                                        }
                                        let _e810 = phi_1360_;
                                        let _e816 = (_e436 + _e722);
                                        let _e817 = (_e816 < _e63);
                                        if _e817 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e819 = a.member[_e816];
                                        let _e820 = (_e819 & 65535u);
                                        let _e823 = ((_e820 & 32768u) << bitcast<u32>(16i));
                                        let _e826 = ((_e820 >> bitcast<u32>(10i)) & 31u);
                                        let _e827 = (_e820 & 1023u);
                                        if (_e826 == 0u) {
                                            phi_1436_ = bitcast<f32>((_e823 | bitcast<u32>((f32(_e827) * 0.000000059604645f))));
                                        } else {
                                            if (_e826 == 31u) {
                                                phi_1413_ = 255u;
                                                phi_1414_ = u32();
                                                phi_1415_ = true;
                                            } else {
                                                let _e830 = (_e826 + 112u);
                                                phi_1413_ = _e830;
                                                phi_1414_ = _e830;
                                                phi_1415_ = (_e830 == 255u);
                                            }
                                            let _e833 = phi_1413_;
                                            let _e835 = phi_1414_;
                                            let _e837 = phi_1415_;
                                            if _e837 {
                                                phi_1424_ = (_e827 == 0u);
                                            } else {
                                                phi_1424_ = true;
                                            }
                                            let _e840 = phi_1424_;
                                            phi_1436_ = bitcast<f32>((((_e823 | (select(_e833, select(_e835, _e833, _e837), _e840) << bitcast<u32>(23i))) | (_e827 << bitcast<u32>(13i))) | select(4194304u, 0u, _e840)));
                                        }
                                        let _e858 = phi_1436_;
                                        if _e817 {
                                        } else {
                                            phi_14246_ = true;
                                            break;
                                        }
                                        let _e866 = ((_e819 >> bitcast<u32>(16u)) & 65535u);
                                        let _e869 = ((_e866 & 32768u) << bitcast<u32>(16i));
                                        let _e872 = ((_e866 >> bitcast<u32>(10i)) & 31u);
                                        let _e873 = (_e866 & 1023u);
                                        if (_e872 == 0u) {
                                            phi_1512_ = bitcast<f32>((_e869 | bitcast<u32>((f32(_e873) * 0.000000059604645f))));
                                        } else {
                                            if (_e872 == 31u) {
                                                phi_1489_ = 255u;
                                                phi_1490_ = u32();
                                                phi_1491_ = true;
                                            } else {
                                                let _e876 = (_e872 + 112u);
                                                phi_1489_ = _e876;
                                                phi_1490_ = _e876;
                                                phi_1491_ = (_e876 == 255u);
                                            }
                                            let _e879 = phi_1489_;
                                            let _e881 = phi_1490_;
                                            let _e883 = phi_1491_;
                                            if _e883 {
                                                phi_1500_ = (_e873 == 0u);
                                            } else {
                                                phi_1500_ = true;
                                            }
                                            let _e886 = phi_1500_;
                                            phi_1512_ = bitcast<f32>((((_e869 | (select(_e879, select(_e881, _e879, _e883), _e886) << bitcast<u32>(23i))) | (_e873 << bitcast<u32>(13i))) | select(4194304u, 0u, _e886)));
                                        }
                                        let _e904 = phi_1512_;
                                        phi_1518_ = (_e277 + _e332);
                                        phi_1519_ = array<array<f32, 4>, 3>(array<f32, 4>((_e279[0][0] + ((_e384 * _e91) * _e332)), (_e279[0][1] + ((_e430 * _e91) * _e332)), (_e279[0][2] + ((_e479 * _e91) * _e332)), (_e279[0][3] + ((_e525 * _e91) * _e332))), array<f32, 4>((_e279[1][0] + ((_e574 * _e91) * _e332)), (_e279[1][1] + ((_e620 * _e91) * _e332)), (_e279[1][2] + ((_e668 * _e91) * _e332)), (_e279[1][3] + ((_e714 * _e91) * _e332))), array<f32, 4>((_e279[2][0] + ((_e764 * _e91) * _e332)), (_e279[2][1] + ((_e810 * _e91) * _e332)), (_e279[2][2] + ((_e858 * _e91) * _e332)), (_e279[2][3] + ((_e904 * _e91) * _e332))));
                                    } else {
                                        phi_1518_ = _e277;
                                        phi_1519_ = _e279;
                                    }
                                    let _e913 = phi_1518_;
                                    let _e915 = phi_1519_;
                                    phi_497_ = _e913;
                                    phi_499_ = _e915;
                                } else {
                                    phi_497_ = f32();
                                    phi_499_ = array<array<f32, 4>, 3>();
                                }
                                let _e917 = phi_497_;
                                let _e919 = phi_499_;
                                continue;
                                continuing {
                                    phi_493_ = _e292;
                                    phi_496_ = _e917;
                                    phi_498_ = _e919;
                                    phi_14246_ = false;
                                    break if !(_e298);
                                }
                            }
                            let _e922 = phi_14246_;
                            if _e922 {
                                break;
                            }
                            let _e924 = local;
                            if (_e924 > 0f) {
                                let _e927 = local_1;
                                phi_1525_ = (1f / _e927);
                            } else {
                                phi_1525_ = 0f;
                            }
                            let _e930 = phi_1525_;
                            let _e932 = local_2;
                            let _e937 = local_3;
                            let _e942 = local_4;
                            let _e947 = local_5;
                            let _e952 = local_6;
                            let _e957 = local_7;
                            let _e962 = local_8;
                            let _e967 = local_9;
                            let _e972 = local_10;
                            let _e977 = local_11;
                            let _e982 = local_12;
                            let _e987 = local_13;
                            let _e992 = ((0.6666667f / _e99.w) / _e99.w);
                            let _e994 = (_e85.member_2[2] * -1.0233268f);
                            let _e997 = (_e85.member_2[0] * -1.0233268f);
                            let _e1000 = (_e85.member_2[1] * -1.0233268f);
                            let _e1002 = (((((_e932[0][0] * _e930) * 0.886227f) + ((_e942[0][2] * _e930) * _e994)) + ((_e947[0][3] * _e930) * _e997)) + ((_e937[0][1] * _e930) * _e1000));
                            let _e1011 = (((((_e952[1][0] * _e930) * 0.886227f) + ((_e962[1][2] * _e930) * _e994)) + ((_e967[1][3] * _e930) * _e997)) + ((_e957[1][1] * _e930) * _e1000));
                            let _e1020 = (((((_e972[2][0] * _e930) * 0.886227f) + ((_e982[2][2] * _e930) * _e994)) + ((_e987[2][3] * _e930) * _e997)) + ((_e977[2][1] * _e930) * _e1000));
                            phi_14359_ = _e922;
                            phi_3663_ = vec4<f32>(((select(0f, _e1002, (_e1002 > 0f)) * _e992) * _e166), ((select(0f, _e1011, (_e1011 > 0f)) * _e992) * _e166), ((select(0f, _e1020, (_e1020 > 0f)) * _e992) * _e166), (1f - _e166));
                        }
                        let _e1032 = phi_14359_;
                        let _e1034 = phi_3663_;
                        phi_14357_ = _e1032;
                        phi_3665_ = _e1034;
                    }
                    let _e1036 = phi_14357_;
                    let _e1038 = phi_3665_;
                    let _e1041 = select(_e1038, vec4<f32>(0f, 0f, 0f, 1f), vec4(select(false, true, _e95)));
                    if (1u >= _e94) {
                        phi_14657_ = _e1036;
                        phi_7179_ = vec4<f32>();
                        phi_7180_ = true;
                    } else {
                        let _e1044 = (_e1041.w <= 0f);
                        if _e1044 {
                            phi_14658_ = _e1036;
                            phi_7178_ = vec4<f32>();
                        } else {
                            let _e1048 = params.member.member[1u];
                            let _e1052 = params.member.member_1[1u];
                            let _e1056 = params.member.member_2[1u];
                            if (2u == _e94) {
                                phi_3726_ = 0f;
                            } else {
                                let _e1068 = params.member.member_5;
                                phi_3726_ = _e1068;
                            }
                            let _e1070 = phi_3726_;
                            let _e1078 = ((_e85.member[0] - _e1048.x) / _e1048.w);
                            let _e1079 = ((_e85.member[1] - _e1048.y) / _e1048.w);
                            let _e1080 = ((_e85.member[2] - _e1048.z) / _e1048.w);
                            let _e1087 = (_e1078 - f32(_e1052.x));
                            let _e1088 = (_e1079 - f32(_e1052.y));
                            let _e1089 = (_e1080 - f32(_e1052.z));
                            let _e1097 = select(_e1089, _e1088, (_e1088 < _e1089));
                            let _e1099 = select(_e1097, _e1087, (_e1087 < _e1097));
                            let _e1100 = (f32(_e1056.x) - _e1087);
                            let _e1101 = (f32(_e1056.y) - _e1088);
                            let _e1102 = (f32(_e1056.z) - _e1089);
                            let _e1104 = select(_e1102, _e1101, (_e1101 < _e1102));
                            let _e1106 = select(_e1104, _e1100, (_e1100 < _e1104));
                            let _e1111 = (select(_e1106, _e1099, (_e1099 < _e1106)) / select(0.001f, _e1070, (_e1070 > 0.001f)));
                            let _e1113 = select(0f, _e1111, (_e1111 > 0f));
                            let _e1116 = (_e1041.w * select(1f, _e1113, (_e1113 < 1f)));
                            if (_e1116 <= 0f) {
                                phi_14659_ = _e1036;
                                phi_7177_ = _e1041;
                            } else {
                                let _e1123 = params.member.member_6;
                                let _e1124 = (_e1056.x + 1u);
                                let _e1126 = ((_e1056.y + 1u) * _e1124);
                                let _e1127 = (_e1126 + _e1124);
                                let _e1130 = (_e1127 + ((_e1056.z + 1u) * _e1126));
                                let _e1137 = ((_e1078 + (_e85.member_2[0] * _e1123)) - 0.5f);
                                let _e1138 = floor(_e1137);
                                let _e1140 = (bitcast<i32>(_e1056.x) - 1i);
                                let _e1148 = (select(0i, select(select(i32(_e1138), i32(-2147483648), (_e1138 < -2147483600f)), 2147483647i, (_e1138 > 2147483500f)), (_e1138 == _e1138)) - _e1052.x);
                                let _e1150 = select(0i, _e1148, (0i < _e1148));
                                let _e1152 = select(_e1150, _e1140, (_e1140 < _e1150));
                                let _e1153 = (_e1148 + 1i);
                                let _e1155 = select(0i, _e1153, (0i < _e1153));
                                let _e1157 = select(_e1155, _e1140, (_e1140 < _e1155));
                                let _e1160 = (_e1137 - _e1138);
                                let _e1167 = ((_e1079 + (_e85.member_2[1] * _e1123)) - 0.5f);
                                let _e1168 = floor(_e1167);
                                let _e1170 = (bitcast<i32>(_e1056.y) - 1i);
                                let _e1178 = (select(0i, select(select(i32(_e1168), i32(-2147483648), (_e1168 < -2147483600f)), 2147483647i, (_e1168 > 2147483500f)), (_e1168 == _e1168)) - _e1052.y);
                                let _e1180 = select(0i, _e1178, (0i < _e1178));
                                let _e1182 = select(_e1180, _e1170, (_e1170 < _e1180));
                                let _e1183 = (_e1178 + 1i);
                                let _e1185 = select(0i, _e1183, (0i < _e1183));
                                let _e1187 = select(_e1185, _e1170, (_e1170 < _e1185));
                                let _e1190 = (_e1167 - _e1168);
                                let _e1197 = ((_e1080 + (_e85.member_2[2] * _e1123)) - 0.5f);
                                let _e1198 = floor(_e1197);
                                let _e1200 = (bitcast<i32>(_e1056.z) - 1i);
                                let _e1208 = (select(0i, select(select(i32(_e1198), i32(-2147483648), (_e1198 < -2147483600f)), 2147483647i, (_e1198 > 2147483500f)), (_e1198 == _e1198)) - _e1052.z);
                                let _e1210 = select(0i, _e1208, (0i < _e1208));
                                let _e1212 = select(_e1210, _e1200, (_e1200 < _e1210));
                                let _e1213 = (_e1208 + 1i);
                                let _e1215 = select(0i, _e1213, (0i < _e1213));
                                let _e1217 = select(_e1215, _e1200, (_e1200 < _e1215));
                                let _e1220 = (_e1197 - _e1198);
                                phi_4007_ = type_7(0u, 8u);
                                phi_4010_ = 0f;
                                phi_4012_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                                loop {
                                    let _e1228 = phi_4007_;
                                    let _e1230 = phi_4010_;
                                    let _e1232 = phi_4012_;
                                    local_14 = _e1230;
                                    local_15 = _e1230;
                                    local_16 = _e1232;
                                    local_17 = _e1232;
                                    local_18 = _e1232;
                                    local_19 = _e1232;
                                    local_20 = _e1232;
                                    local_21 = _e1232;
                                    local_22 = _e1232;
                                    local_23 = _e1232;
                                    local_24 = _e1232;
                                    local_25 = _e1232;
                                    local_26 = _e1232;
                                    local_27 = _e1232;
                                    if (_e1228.member < _e1228.member_1) {
                                        phi_4008_ = type_7((_e1228.member + 1u), _e1228.member_1);
                                        phi_4035_ = type_7(1u, _e1228.member);
                                    } else {
                                        phi_4008_ = _e1228;
                                        phi_4035_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e1245 = phi_4008_;
                                    let _e1247 = phi_4035_;
                                    let _e1251 = (bitcast<i32>(_e1247.member) != 0i);
                                    if _e1251 {
                                        let _e1253 = ((_e1247.member_1 & 1u) == 1u);
                                        let _e1255 = ((_e1247.member_1 & 2u) == 2u);
                                        let _e1257 = ((_e1247.member_1 & 4u) == 4u);
                                        if _e1253 {
                                            phi_4065_ = _e1160;
                                        } else {
                                            phi_4065_ = (1f - _e1160);
                                        }
                                        let _e1263 = phi_4065_;
                                        if _e1255 {
                                            phi_4070_ = _e1190;
                                        } else {
                                            phi_4070_ = (1f - _e1190);
                                        }
                                        let _e1266 = phi_4070_;
                                        if _e1257 {
                                            phi_4076_ = _e1220;
                                        } else {
                                            phi_4076_ = (1f - _e1220);
                                        }
                                        let _e1270 = phi_4076_;
                                        let _e1280 = (((((select((f32((_e1152 + _e1052.x)) + 0.5f), (f32((_e1157 + _e1052.x)) + 0.5f), _e1253) - _e1078) * _e85.member_2[0]) + ((select((f32((_e1182 + _e1052.y)) + 0.5f), (f32((_e1187 + _e1052.y)) + 0.5f), _e1255) - _e1079) * _e85.member_2[1])) + ((select((f32((_e1212 + _e1052.z)) + 0.5f), (f32((_e1217 + _e1052.z)) + 0.5f), _e1257) - _e1080) * _e85.member_2[2])) * 2f);
                                        let _e1282 = select(0f, _e1280, (_e1280 > 0f));
                                        let _e1285 = (((_e1263 * _e1266) * _e1270) * select(1f, _e1282, (_e1282 < 1f)));
                                        if (_e1285 > 0f) {
                                            let _e1294 = (((_e1127 + select(bitcast<u32>(_e1152), bitcast<u32>(_e1157), _e1253)) + (select(bitcast<u32>(_e1182), bitcast<u32>(_e1187), _e1255) * _e1124)) + (select(bitcast<u32>(_e1212), bitcast<u32>(_e1217), _e1257) * _e1126));
                                            let _e1296 = (_e1294 < _e66);
                                            if _e1296 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1298 = b.member[_e1294];
                                            let _e1299 = (_e1298 & 65535u);
                                            let _e1302 = ((_e1299 & 32768u) << bitcast<u32>(16i));
                                            let _e1305 = ((_e1299 >> bitcast<u32>(10i)) & 31u);
                                            let _e1306 = (_e1299 & 1023u);
                                            if (_e1305 == 0u) {
                                                phi_4190_ = bitcast<f32>((_e1302 | bitcast<u32>((f32(_e1306) * 0.000000059604645f))));
                                            } else {
                                                if (_e1305 == 31u) {
                                                    phi_4167_ = 255u;
                                                    phi_4168_ = u32();
                                                    phi_4169_ = true;
                                                } else {
                                                    let _e1309 = (_e1305 + 112u);
                                                    phi_4167_ = _e1309;
                                                    phi_4168_ = _e1309;
                                                    phi_4169_ = (_e1309 == 255u);
                                                }
                                                let _e1312 = phi_4167_;
                                                let _e1314 = phi_4168_;
                                                let _e1316 = phi_4169_;
                                                if _e1316 {
                                                    phi_4178_ = (_e1306 == 0u);
                                                } else {
                                                    phi_4178_ = true;
                                                }
                                                let _e1319 = phi_4178_;
                                                phi_4190_ = bitcast<f32>((((_e1302 | (select(_e1312, select(_e1314, _e1312, _e1316), _e1319) << bitcast<u32>(23i))) | (_e1306 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1319)));
                                            }
                                            let _e1337 = phi_4190_;
                                            if _e1296 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1345 = ((_e1298 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1348 = ((_e1345 & 32768u) << bitcast<u32>(16i));
                                            let _e1351 = ((_e1345 >> bitcast<u32>(10i)) & 31u);
                                            let _e1352 = (_e1345 & 1023u);
                                            if (_e1351 == 0u) {
                                                phi_4266_ = bitcast<f32>((_e1348 | bitcast<u32>((f32(_e1352) * 0.000000059604645f))));
                                            } else {
                                                if (_e1351 == 31u) {
                                                    phi_4243_ = 255u;
                                                    phi_4244_ = u32();
                                                    phi_4245_ = true;
                                                } else {
                                                    let _e1355 = (_e1351 + 112u);
                                                    phi_4243_ = _e1355;
                                                    phi_4244_ = _e1355;
                                                    phi_4245_ = (_e1355 == 255u);
                                                }
                                                let _e1358 = phi_4243_;
                                                let _e1360 = phi_4244_;
                                                let _e1362 = phi_4245_;
                                                if _e1362 {
                                                    phi_4254_ = (_e1352 == 0u);
                                                } else {
                                                    phi_4254_ = true;
                                                }
                                                let _e1365 = phi_4254_;
                                                phi_4266_ = bitcast<f32>((((_e1348 | (select(_e1358, select(_e1360, _e1358, _e1362), _e1365) << bitcast<u32>(23i))) | (_e1352 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1365)));
                                            }
                                            let _e1383 = phi_4266_;
                                            let _e1389 = (3u * _e1130);
                                            let _e1390 = (_e1389 + _e1294);
                                            let _e1391 = (_e1390 < _e66);
                                            if _e1391 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1393 = b.member[_e1390];
                                            let _e1394 = (_e1393 & 65535u);
                                            let _e1397 = ((_e1394 & 32768u) << bitcast<u32>(16i));
                                            let _e1400 = ((_e1394 >> bitcast<u32>(10i)) & 31u);
                                            let _e1401 = (_e1394 & 1023u);
                                            if (_e1400 == 0u) {
                                                phi_4342_ = bitcast<f32>((_e1397 | bitcast<u32>((f32(_e1401) * 0.000000059604645f))));
                                            } else {
                                                if (_e1400 == 31u) {
                                                    phi_4319_ = 255u;
                                                    phi_4320_ = u32();
                                                    phi_4321_ = true;
                                                } else {
                                                    let _e1404 = (_e1400 + 112u);
                                                    phi_4319_ = _e1404;
                                                    phi_4320_ = _e1404;
                                                    phi_4321_ = (_e1404 == 255u);
                                                }
                                                let _e1407 = phi_4319_;
                                                let _e1409 = phi_4320_;
                                                let _e1411 = phi_4321_;
                                                if _e1411 {
                                                    phi_4330_ = (_e1401 == 0u);
                                                } else {
                                                    phi_4330_ = true;
                                                }
                                                let _e1414 = phi_4330_;
                                                phi_4342_ = bitcast<f32>((((_e1397 | (select(_e1407, select(_e1409, _e1407, _e1411), _e1414) << bitcast<u32>(23i))) | (_e1401 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1414)));
                                            }
                                            let _e1432 = phi_4342_;
                                            if _e1391 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1440 = ((_e1393 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1443 = ((_e1440 & 32768u) << bitcast<u32>(16i));
                                            let _e1446 = ((_e1440 >> bitcast<u32>(10i)) & 31u);
                                            let _e1447 = (_e1440 & 1023u);
                                            if (_e1446 == 0u) {
                                                phi_4418_ = bitcast<f32>((_e1443 | bitcast<u32>((f32(_e1447) * 0.000000059604645f))));
                                            } else {
                                                if (_e1446 == 31u) {
                                                    phi_4395_ = 255u;
                                                    phi_4396_ = u32();
                                                    phi_4397_ = true;
                                                } else {
                                                    let _e1450 = (_e1446 + 112u);
                                                    phi_4395_ = _e1450;
                                                    phi_4396_ = _e1450;
                                                    phi_4397_ = (_e1450 == 255u);
                                                }
                                                let _e1453 = phi_4395_;
                                                let _e1455 = phi_4396_;
                                                let _e1457 = phi_4397_;
                                                if _e1457 {
                                                    phi_4406_ = (_e1447 == 0u);
                                                } else {
                                                    phi_4406_ = true;
                                                }
                                                let _e1460 = phi_4406_;
                                                phi_4418_ = bitcast<f32>((((_e1443 | (select(_e1453, select(_e1455, _e1453, _e1457), _e1460) << bitcast<u32>(23i))) | (_e1447 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1460)));
                                            }
                                            let _e1478 = phi_4418_;
                                            let _e1485 = (_e1130 + _e1294);
                                            let _e1486 = (_e1485 < _e66);
                                            if _e1486 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1488 = b.member[_e1485];
                                            let _e1489 = (_e1488 & 65535u);
                                            let _e1492 = ((_e1489 & 32768u) << bitcast<u32>(16i));
                                            let _e1495 = ((_e1489 >> bitcast<u32>(10i)) & 31u);
                                            let _e1496 = (_e1489 & 1023u);
                                            if (_e1495 == 0u) {
                                                phi_4494_ = bitcast<f32>((_e1492 | bitcast<u32>((f32(_e1496) * 0.000000059604645f))));
                                            } else {
                                                if (_e1495 == 31u) {
                                                    phi_4471_ = 255u;
                                                    phi_4472_ = u32();
                                                    phi_4473_ = true;
                                                } else {
                                                    let _e1499 = (_e1495 + 112u);
                                                    phi_4471_ = _e1499;
                                                    phi_4472_ = _e1499;
                                                    phi_4473_ = (_e1499 == 255u);
                                                }
                                                let _e1502 = phi_4471_;
                                                let _e1504 = phi_4472_;
                                                let _e1506 = phi_4473_;
                                                if _e1506 {
                                                    phi_4482_ = (_e1496 == 0u);
                                                } else {
                                                    phi_4482_ = true;
                                                }
                                                let _e1509 = phi_4482_;
                                                phi_4494_ = bitcast<f32>((((_e1492 | (select(_e1502, select(_e1504, _e1502, _e1506), _e1509) << bitcast<u32>(23i))) | (_e1496 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1509)));
                                            }
                                            let _e1527 = phi_4494_;
                                            if _e1486 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1535 = ((_e1488 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1538 = ((_e1535 & 32768u) << bitcast<u32>(16i));
                                            let _e1541 = ((_e1535 >> bitcast<u32>(10i)) & 31u);
                                            let _e1542 = (_e1535 & 1023u);
                                            if (_e1541 == 0u) {
                                                phi_4570_ = bitcast<f32>((_e1538 | bitcast<u32>((f32(_e1542) * 0.000000059604645f))));
                                            } else {
                                                if (_e1541 == 31u) {
                                                    phi_4547_ = 255u;
                                                    phi_4548_ = u32();
                                                    phi_4549_ = true;
                                                } else {
                                                    let _e1545 = (_e1541 + 112u);
                                                    phi_4547_ = _e1545;
                                                    phi_4548_ = _e1545;
                                                    phi_4549_ = (_e1545 == 255u);
                                                }
                                                let _e1548 = phi_4547_;
                                                let _e1550 = phi_4548_;
                                                let _e1552 = phi_4549_;
                                                if _e1552 {
                                                    phi_4558_ = (_e1542 == 0u);
                                                } else {
                                                    phi_4558_ = true;
                                                }
                                                let _e1555 = phi_4558_;
                                                phi_4570_ = bitcast<f32>((((_e1538 | (select(_e1548, select(_e1550, _e1548, _e1552), _e1555) << bitcast<u32>(23i))) | (_e1542 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1555)));
                                            }
                                            let _e1573 = phi_4570_;
                                            let _e1579 = (_e1389 + _e1485);
                                            let _e1580 = (_e1579 < _e66);
                                            if _e1580 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1582 = b.member[_e1579];
                                            let _e1583 = (_e1582 & 65535u);
                                            let _e1586 = ((_e1583 & 32768u) << bitcast<u32>(16i));
                                            let _e1589 = ((_e1583 >> bitcast<u32>(10i)) & 31u);
                                            let _e1590 = (_e1583 & 1023u);
                                            if (_e1589 == 0u) {
                                                phi_4646_ = bitcast<f32>((_e1586 | bitcast<u32>((f32(_e1590) * 0.000000059604645f))));
                                            } else {
                                                if (_e1589 == 31u) {
                                                    phi_4623_ = 255u;
                                                    phi_4624_ = u32();
                                                    phi_4625_ = true;
                                                } else {
                                                    let _e1593 = (_e1589 + 112u);
                                                    phi_4623_ = _e1593;
                                                    phi_4624_ = _e1593;
                                                    phi_4625_ = (_e1593 == 255u);
                                                }
                                                let _e1596 = phi_4623_;
                                                let _e1598 = phi_4624_;
                                                let _e1600 = phi_4625_;
                                                if _e1600 {
                                                    phi_4634_ = (_e1590 == 0u);
                                                } else {
                                                    phi_4634_ = true;
                                                }
                                                let _e1603 = phi_4634_;
                                                phi_4646_ = bitcast<f32>((((_e1586 | (select(_e1596, select(_e1598, _e1596, _e1600), _e1603) << bitcast<u32>(23i))) | (_e1590 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1603)));
                                            }
                                            let _e1621 = phi_4646_;
                                            if _e1580 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1629 = ((_e1582 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1632 = ((_e1629 & 32768u) << bitcast<u32>(16i));
                                            let _e1635 = ((_e1629 >> bitcast<u32>(10i)) & 31u);
                                            let _e1636 = (_e1629 & 1023u);
                                            if (_e1635 == 0u) {
                                                phi_4722_ = bitcast<f32>((_e1632 | bitcast<u32>((f32(_e1636) * 0.000000059604645f))));
                                            } else {
                                                if (_e1635 == 31u) {
                                                    phi_4699_ = 255u;
                                                    phi_4700_ = u32();
                                                    phi_4701_ = true;
                                                } else {
                                                    let _e1639 = (_e1635 + 112u);
                                                    phi_4699_ = _e1639;
                                                    phi_4700_ = _e1639;
                                                    phi_4701_ = (_e1639 == 255u);
                                                }
                                                let _e1642 = phi_4699_;
                                                let _e1644 = phi_4700_;
                                                let _e1646 = phi_4701_;
                                                if _e1646 {
                                                    phi_4710_ = (_e1636 == 0u);
                                                } else {
                                                    phi_4710_ = true;
                                                }
                                                let _e1649 = phi_4710_;
                                                phi_4722_ = bitcast<f32>((((_e1632 | (select(_e1642, select(_e1644, _e1642, _e1646), _e1649) << bitcast<u32>(23i))) | (_e1636 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1649)));
                                            }
                                            let _e1667 = phi_4722_;
                                            let _e1675 = ((2u * _e1130) + _e1294);
                                            let _e1676 = (_e1675 < _e66);
                                            if _e1676 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1678 = b.member[_e1675];
                                            let _e1679 = (_e1678 & 65535u);
                                            let _e1682 = ((_e1679 & 32768u) << bitcast<u32>(16i));
                                            let _e1685 = ((_e1679 >> bitcast<u32>(10i)) & 31u);
                                            let _e1686 = (_e1679 & 1023u);
                                            if (_e1685 == 0u) {
                                                phi_4798_ = bitcast<f32>((_e1682 | bitcast<u32>((f32(_e1686) * 0.000000059604645f))));
                                            } else {
                                                if (_e1685 == 31u) {
                                                    phi_4775_ = 255u;
                                                    phi_4776_ = u32();
                                                    phi_4777_ = true;
                                                } else {
                                                    let _e1689 = (_e1685 + 112u);
                                                    phi_4775_ = _e1689;
                                                    phi_4776_ = _e1689;
                                                    phi_4777_ = (_e1689 == 255u);
                                                }
                                                let _e1692 = phi_4775_;
                                                let _e1694 = phi_4776_;
                                                let _e1696 = phi_4777_;
                                                if _e1696 {
                                                    phi_4786_ = (_e1686 == 0u);
                                                } else {
                                                    phi_4786_ = true;
                                                }
                                                let _e1699 = phi_4786_;
                                                phi_4798_ = bitcast<f32>((((_e1682 | (select(_e1692, select(_e1694, _e1692, _e1696), _e1699) << bitcast<u32>(23i))) | (_e1686 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1699)));
                                            }
                                            let _e1717 = phi_4798_;
                                            if _e1676 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1725 = ((_e1678 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1728 = ((_e1725 & 32768u) << bitcast<u32>(16i));
                                            let _e1731 = ((_e1725 >> bitcast<u32>(10i)) & 31u);
                                            let _e1732 = (_e1725 & 1023u);
                                            if (_e1731 == 0u) {
                                                phi_4874_ = bitcast<f32>((_e1728 | bitcast<u32>((f32(_e1732) * 0.000000059604645f))));
                                            } else {
                                                if (_e1731 == 31u) {
                                                    phi_4851_ = 255u;
                                                    phi_4852_ = u32();
                                                    phi_4853_ = true;
                                                } else {
                                                    let _e1735 = (_e1731 + 112u);
                                                    phi_4851_ = _e1735;
                                                    phi_4852_ = _e1735;
                                                    phi_4853_ = (_e1735 == 255u);
                                                }
                                                let _e1738 = phi_4851_;
                                                let _e1740 = phi_4852_;
                                                let _e1742 = phi_4853_;
                                                if _e1742 {
                                                    phi_4862_ = (_e1732 == 0u);
                                                } else {
                                                    phi_4862_ = true;
                                                }
                                                let _e1745 = phi_4862_;
                                                phi_4874_ = bitcast<f32>((((_e1728 | (select(_e1738, select(_e1740, _e1738, _e1742), _e1745) << bitcast<u32>(23i))) | (_e1732 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1745)));
                                            }
                                            let _e1763 = phi_4874_;
                                            let _e1769 = (_e1389 + _e1675);
                                            let _e1770 = (_e1769 < _e66);
                                            if _e1770 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1772 = b.member[_e1769];
                                            let _e1773 = (_e1772 & 65535u);
                                            let _e1776 = ((_e1773 & 32768u) << bitcast<u32>(16i));
                                            let _e1779 = ((_e1773 >> bitcast<u32>(10i)) & 31u);
                                            let _e1780 = (_e1773 & 1023u);
                                            if (_e1779 == 0u) {
                                                phi_4950_ = bitcast<f32>((_e1776 | bitcast<u32>((f32(_e1780) * 0.000000059604645f))));
                                            } else {
                                                if (_e1779 == 31u) {
                                                    phi_4927_ = 255u;
                                                    phi_4928_ = u32();
                                                    phi_4929_ = true;
                                                } else {
                                                    let _e1783 = (_e1779 + 112u);
                                                    phi_4927_ = _e1783;
                                                    phi_4928_ = _e1783;
                                                    phi_4929_ = (_e1783 == 255u);
                                                }
                                                let _e1786 = phi_4927_;
                                                let _e1788 = phi_4928_;
                                                let _e1790 = phi_4929_;
                                                if _e1790 {
                                                    phi_4938_ = (_e1780 == 0u);
                                                } else {
                                                    phi_4938_ = true;
                                                }
                                                let _e1793 = phi_4938_;
                                                phi_4950_ = bitcast<f32>((((_e1776 | (select(_e1786, select(_e1788, _e1786, _e1790), _e1793) << bitcast<u32>(23i))) | (_e1780 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1793)));
                                            }
                                            let _e1811 = phi_4950_;
                                            if _e1770 {
                                            } else {
                                                phi_14331_ = true;
                                                break;
                                            }
                                            let _e1819 = ((_e1772 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1822 = ((_e1819 & 32768u) << bitcast<u32>(16i));
                                            let _e1825 = ((_e1819 >> bitcast<u32>(10i)) & 31u);
                                            let _e1826 = (_e1819 & 1023u);
                                            if (_e1825 == 0u) {
                                                phi_5026_ = bitcast<f32>((_e1822 | bitcast<u32>((f32(_e1826) * 0.000000059604645f))));
                                            } else {
                                                if (_e1825 == 31u) {
                                                    phi_5003_ = 255u;
                                                    phi_5004_ = u32();
                                                    phi_5005_ = true;
                                                } else {
                                                    let _e1829 = (_e1825 + 112u);
                                                    phi_5003_ = _e1829;
                                                    phi_5004_ = _e1829;
                                                    phi_5005_ = (_e1829 == 255u);
                                                }
                                                let _e1832 = phi_5003_;
                                                let _e1834 = phi_5004_;
                                                let _e1836 = phi_5005_;
                                                if _e1836 {
                                                    phi_5014_ = (_e1826 == 0u);
                                                } else {
                                                    phi_5014_ = true;
                                                }
                                                let _e1839 = phi_5014_;
                                                phi_5026_ = bitcast<f32>((((_e1822 | (select(_e1832, select(_e1834, _e1832, _e1836), _e1839) << bitcast<u32>(23i))) | (_e1826 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1839)));
                                            }
                                            let _e1857 = phi_5026_;
                                            phi_5032_ = (_e1230 + _e1285);
                                            phi_5033_ = array<array<f32, 4>, 3>(array<f32, 4>((_e1232[0][0] + ((_e1337 * _e91) * _e1285)), (_e1232[0][1] + ((_e1383 * _e91) * _e1285)), (_e1232[0][2] + ((_e1432 * _e91) * _e1285)), (_e1232[0][3] + ((_e1478 * _e91) * _e1285))), array<f32, 4>((_e1232[1][0] + ((_e1527 * _e91) * _e1285)), (_e1232[1][1] + ((_e1573 * _e91) * _e1285)), (_e1232[1][2] + ((_e1621 * _e91) * _e1285)), (_e1232[1][3] + ((_e1667 * _e91) * _e1285))), array<f32, 4>((_e1232[2][0] + ((_e1717 * _e91) * _e1285)), (_e1232[2][1] + ((_e1763 * _e91) * _e1285)), (_e1232[2][2] + ((_e1811 * _e91) * _e1285)), (_e1232[2][3] + ((_e1857 * _e91) * _e1285))));
                                        } else {
                                            phi_5032_ = _e1230;
                                            phi_5033_ = _e1232;
                                        }
                                        let _e1866 = phi_5032_;
                                        let _e1868 = phi_5033_;
                                        phi_4011_ = _e1866;
                                        phi_4013_ = _e1868;
                                    } else {
                                        phi_4011_ = f32();
                                        phi_4013_ = array<array<f32, 4>, 3>();
                                    }
                                    let _e1870 = phi_4011_;
                                    let _e1872 = phi_4013_;
                                    continue;
                                    continuing {
                                        phi_4007_ = _e1245;
                                        phi_4010_ = _e1870;
                                        phi_4012_ = _e1872;
                                        phi_14331_ = _e1036;
                                        break if !(_e1251);
                                    }
                                }
                                let _e1875 = phi_14331_;
                                if _e1875 {
                                    break;
                                }
                                let _e1877 = local_14;
                                if (_e1877 > 0f) {
                                    let _e1880 = local_15;
                                    phi_5039_ = (1f / _e1880);
                                } else {
                                    phi_5039_ = 0f;
                                }
                                let _e1883 = phi_5039_;
                                let _e1885 = local_16;
                                let _e1890 = local_17;
                                let _e1895 = local_18;
                                let _e1900 = local_19;
                                let _e1905 = local_20;
                                let _e1910 = local_21;
                                let _e1915 = local_22;
                                let _e1920 = local_23;
                                let _e1925 = local_24;
                                let _e1930 = local_25;
                                let _e1935 = local_26;
                                let _e1940 = local_27;
                                let _e1945 = ((0.6666667f / _e1048.w) / _e1048.w);
                                let _e1947 = (_e85.member_2[2] * -1.0233268f);
                                let _e1950 = (_e85.member_2[0] * -1.0233268f);
                                let _e1953 = (_e85.member_2[1] * -1.0233268f);
                                let _e1955 = (((((_e1885[0][0] * _e1883) * 0.886227f) + ((_e1895[0][2] * _e1883) * _e1947)) + ((_e1900[0][3] * _e1883) * _e1950)) + ((_e1890[0][1] * _e1883) * _e1953));
                                let _e1964 = (((((_e1905[1][0] * _e1883) * 0.886227f) + ((_e1915[1][2] * _e1883) * _e1947)) + ((_e1920[1][3] * _e1883) * _e1950)) + ((_e1910[1][1] * _e1883) * _e1953));
                                let _e1973 = (((((_e1925[2][0] * _e1883) * 0.886227f) + ((_e1935[2][2] * _e1883) * _e1947)) + ((_e1940[2][3] * _e1883) * _e1950)) + ((_e1930[2][1] * _e1883) * _e1953));
                                phi_14659_ = _e1875;
                                phi_7177_ = vec4<f32>((_e1041.x + ((select(0f, _e1955, (_e1955 > 0f)) * _e1945) * _e1116)), (_e1041.y + ((select(0f, _e1964, (_e1964 > 0f)) * _e1945) * _e1116)), (_e1041.z + ((select(0f, _e1973, (_e1973 > 0f)) * _e1945) * _e1116)), (_e1041.w - _e1116));
                            }
                            let _e1988 = phi_14659_;
                            let _e1990 = phi_7177_;
                            phi_14658_ = _e1988;
                            phi_7178_ = _e1990;
                        }
                        let _e1992 = phi_14658_;
                        let _e1994 = phi_7178_;
                        phi_14657_ = _e1992;
                        phi_7179_ = _e1994;
                        phi_7180_ = _e1044;
                    }
                    let _e1996 = phi_14657_;
                    let _e1998 = phi_7179_;
                    let _e2000 = phi_7180_;
                    let _e2002 = select(_e1998, _e1041, vec4(_e2000));
                    if (2u >= _e94) {
                        phi_14957_ = _e1996;
                        phi_10693_ = vec4<f32>();
                        phi_10694_ = true;
                    } else {
                        let _e2005 = (_e2002.w <= 0f);
                        if _e2005 {
                            phi_14958_ = _e1996;
                            phi_10692_ = vec4<f32>();
                        } else {
                            let _e2009 = params.member.member[2u];
                            let _e2013 = params.member.member_1[2u];
                            let _e2017 = params.member.member_2[2u];
                            if (3u == _e94) {
                                phi_7240_ = 0f;
                            } else {
                                let _e2029 = params.member.member_5;
                                phi_7240_ = _e2029;
                            }
                            let _e2031 = phi_7240_;
                            let _e2039 = ((_e85.member[0] - _e2009.x) / _e2009.w);
                            let _e2040 = ((_e85.member[1] - _e2009.y) / _e2009.w);
                            let _e2041 = ((_e85.member[2] - _e2009.z) / _e2009.w);
                            let _e2048 = (_e2039 - f32(_e2013.x));
                            let _e2049 = (_e2040 - f32(_e2013.y));
                            let _e2050 = (_e2041 - f32(_e2013.z));
                            let _e2058 = select(_e2050, _e2049, (_e2049 < _e2050));
                            let _e2060 = select(_e2058, _e2048, (_e2048 < _e2058));
                            let _e2061 = (f32(_e2017.x) - _e2048);
                            let _e2062 = (f32(_e2017.y) - _e2049);
                            let _e2063 = (f32(_e2017.z) - _e2050);
                            let _e2065 = select(_e2063, _e2062, (_e2062 < _e2063));
                            let _e2067 = select(_e2065, _e2061, (_e2061 < _e2065));
                            let _e2072 = (select(_e2067, _e2060, (_e2060 < _e2067)) / select(0.001f, _e2031, (_e2031 > 0.001f)));
                            let _e2074 = select(0f, _e2072, (_e2072 > 0f));
                            let _e2077 = (_e2002.w * select(1f, _e2074, (_e2074 < 1f)));
                            if (_e2077 <= 0f) {
                                phi_14959_ = _e1996;
                                phi_10691_ = _e2002;
                            } else {
                                let _e2084 = params.member.member_6;
                                let _e2085 = (_e2017.x + 1u);
                                let _e2087 = ((_e2017.y + 1u) * _e2085);
                                let _e2088 = (_e2087 + _e2085);
                                let _e2091 = (_e2088 + ((_e2017.z + 1u) * _e2087));
                                let _e2098 = ((_e2039 + (_e85.member_2[0] * _e2084)) - 0.5f);
                                let _e2099 = floor(_e2098);
                                let _e2101 = (bitcast<i32>(_e2017.x) - 1i);
                                let _e2109 = (select(0i, select(select(i32(_e2099), i32(-2147483648), (_e2099 < -2147483600f)), 2147483647i, (_e2099 > 2147483500f)), (_e2099 == _e2099)) - _e2013.x);
                                let _e2111 = select(0i, _e2109, (0i < _e2109));
                                let _e2113 = select(_e2111, _e2101, (_e2101 < _e2111));
                                let _e2114 = (_e2109 + 1i);
                                let _e2116 = select(0i, _e2114, (0i < _e2114));
                                let _e2118 = select(_e2116, _e2101, (_e2101 < _e2116));
                                let _e2121 = (_e2098 - _e2099);
                                let _e2128 = ((_e2040 + (_e85.member_2[1] * _e2084)) - 0.5f);
                                let _e2129 = floor(_e2128);
                                let _e2131 = (bitcast<i32>(_e2017.y) - 1i);
                                let _e2139 = (select(0i, select(select(i32(_e2129), i32(-2147483648), (_e2129 < -2147483600f)), 2147483647i, (_e2129 > 2147483500f)), (_e2129 == _e2129)) - _e2013.y);
                                let _e2141 = select(0i, _e2139, (0i < _e2139));
                                let _e2143 = select(_e2141, _e2131, (_e2131 < _e2141));
                                let _e2144 = (_e2139 + 1i);
                                let _e2146 = select(0i, _e2144, (0i < _e2144));
                                let _e2148 = select(_e2146, _e2131, (_e2131 < _e2146));
                                let _e2151 = (_e2128 - _e2129);
                                let _e2158 = ((_e2041 + (_e85.member_2[2] * _e2084)) - 0.5f);
                                let _e2159 = floor(_e2158);
                                let _e2161 = (bitcast<i32>(_e2017.z) - 1i);
                                let _e2169 = (select(0i, select(select(i32(_e2159), i32(-2147483648), (_e2159 < -2147483600f)), 2147483647i, (_e2159 > 2147483500f)), (_e2159 == _e2159)) - _e2013.z);
                                let _e2171 = select(0i, _e2169, (0i < _e2169));
                                let _e2173 = select(_e2171, _e2161, (_e2161 < _e2171));
                                let _e2174 = (_e2169 + 1i);
                                let _e2176 = select(0i, _e2174, (0i < _e2174));
                                let _e2178 = select(_e2176, _e2161, (_e2161 < _e2176));
                                let _e2181 = (_e2158 - _e2159);
                                phi_7521_ = type_7(0u, 8u);
                                phi_7524_ = 0f;
                                phi_7526_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                                loop {
                                    let _e2189 = phi_7521_;
                                    let _e2191 = phi_7524_;
                                    let _e2193 = phi_7526_;
                                    local_28 = _e2191;
                                    local_29 = _e2191;
                                    local_30 = _e2193;
                                    local_31 = _e2193;
                                    local_32 = _e2193;
                                    local_33 = _e2193;
                                    local_34 = _e2193;
                                    local_35 = _e2193;
                                    local_36 = _e2193;
                                    local_37 = _e2193;
                                    local_38 = _e2193;
                                    local_39 = _e2193;
                                    local_40 = _e2193;
                                    local_41 = _e2193;
                                    if (_e2189.member < _e2189.member_1) {
                                        phi_7522_ = type_7((_e2189.member + 1u), _e2189.member_1);
                                        phi_7549_ = type_7(1u, _e2189.member);
                                    } else {
                                        phi_7522_ = _e2189;
                                        phi_7549_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e2206 = phi_7522_;
                                    let _e2208 = phi_7549_;
                                    let _e2212 = (bitcast<i32>(_e2208.member) != 0i);
                                    if _e2212 {
                                        let _e2214 = ((_e2208.member_1 & 1u) == 1u);
                                        let _e2216 = ((_e2208.member_1 & 2u) == 2u);
                                        let _e2218 = ((_e2208.member_1 & 4u) == 4u);
                                        if _e2214 {
                                            phi_7579_ = _e2121;
                                        } else {
                                            phi_7579_ = (1f - _e2121);
                                        }
                                        let _e2224 = phi_7579_;
                                        if _e2216 {
                                            phi_7584_ = _e2151;
                                        } else {
                                            phi_7584_ = (1f - _e2151);
                                        }
                                        let _e2227 = phi_7584_;
                                        if _e2218 {
                                            phi_7590_ = _e2181;
                                        } else {
                                            phi_7590_ = (1f - _e2181);
                                        }
                                        let _e2231 = phi_7590_;
                                        let _e2241 = (((((select((f32((_e2113 + _e2013.x)) + 0.5f), (f32((_e2118 + _e2013.x)) + 0.5f), _e2214) - _e2039) * _e85.member_2[0]) + ((select((f32((_e2143 + _e2013.y)) + 0.5f), (f32((_e2148 + _e2013.y)) + 0.5f), _e2216) - _e2040) * _e85.member_2[1])) + ((select((f32((_e2173 + _e2013.z)) + 0.5f), (f32((_e2178 + _e2013.z)) + 0.5f), _e2218) - _e2041) * _e85.member_2[2])) * 2f);
                                        let _e2243 = select(0f, _e2241, (_e2241 > 0f));
                                        let _e2246 = (((_e2224 * _e2227) * _e2231) * select(1f, _e2243, (_e2243 < 1f)));
                                        if (_e2246 > 0f) {
                                            let _e2255 = (((_e2088 + select(bitcast<u32>(_e2113), bitcast<u32>(_e2118), _e2214)) + (select(bitcast<u32>(_e2143), bitcast<u32>(_e2148), _e2216) * _e2085)) + (select(bitcast<u32>(_e2173), bitcast<u32>(_e2178), _e2218) * _e2087));
                                            let _e2257 = (_e2255 < _e69);
                                            if _e2257 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2259 = c.member[_e2255];
                                            let _e2260 = (_e2259 & 65535u);
                                            let _e2263 = ((_e2260 & 32768u) << bitcast<u32>(16i));
                                            let _e2266 = ((_e2260 >> bitcast<u32>(10i)) & 31u);
                                            let _e2267 = (_e2260 & 1023u);
                                            if (_e2266 == 0u) {
                                                phi_7704_ = bitcast<f32>((_e2263 | bitcast<u32>((f32(_e2267) * 0.000000059604645f))));
                                            } else {
                                                if (_e2266 == 31u) {
                                                    phi_7681_ = 255u;
                                                    phi_7682_ = u32();
                                                    phi_7683_ = true;
                                                } else {
                                                    let _e2270 = (_e2266 + 112u);
                                                    phi_7681_ = _e2270;
                                                    phi_7682_ = _e2270;
                                                    phi_7683_ = (_e2270 == 255u);
                                                }
                                                let _e2273 = phi_7681_;
                                                let _e2275 = phi_7682_;
                                                let _e2277 = phi_7683_;
                                                if _e2277 {
                                                    phi_7692_ = (_e2267 == 0u);
                                                } else {
                                                    phi_7692_ = true;
                                                }
                                                let _e2280 = phi_7692_;
                                                phi_7704_ = bitcast<f32>((((_e2263 | (select(_e2273, select(_e2275, _e2273, _e2277), _e2280) << bitcast<u32>(23i))) | (_e2267 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2280)));
                                            }
                                            let _e2298 = phi_7704_;
                                            if _e2257 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2306 = ((_e2259 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2309 = ((_e2306 & 32768u) << bitcast<u32>(16i));
                                            let _e2312 = ((_e2306 >> bitcast<u32>(10i)) & 31u);
                                            let _e2313 = (_e2306 & 1023u);
                                            if (_e2312 == 0u) {
                                                phi_7780_ = bitcast<f32>((_e2309 | bitcast<u32>((f32(_e2313) * 0.000000059604645f))));
                                            } else {
                                                if (_e2312 == 31u) {
                                                    phi_7757_ = 255u;
                                                    phi_7758_ = u32();
                                                    phi_7759_ = true;
                                                } else {
                                                    let _e2316 = (_e2312 + 112u);
                                                    phi_7757_ = _e2316;
                                                    phi_7758_ = _e2316;
                                                    phi_7759_ = (_e2316 == 255u);
                                                }
                                                let _e2319 = phi_7757_;
                                                let _e2321 = phi_7758_;
                                                let _e2323 = phi_7759_;
                                                if _e2323 {
                                                    phi_7768_ = (_e2313 == 0u);
                                                } else {
                                                    phi_7768_ = true;
                                                }
                                                let _e2326 = phi_7768_;
                                                phi_7780_ = bitcast<f32>((((_e2309 | (select(_e2319, select(_e2321, _e2319, _e2323), _e2326) << bitcast<u32>(23i))) | (_e2313 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2326)));
                                            }
                                            let _e2344 = phi_7780_;
                                            let _e2350 = (3u * _e2091);
                                            let _e2351 = (_e2350 + _e2255);
                                            let _e2352 = (_e2351 < _e69);
                                            if _e2352 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2354 = c.member[_e2351];
                                            let _e2355 = (_e2354 & 65535u);
                                            let _e2358 = ((_e2355 & 32768u) << bitcast<u32>(16i));
                                            let _e2361 = ((_e2355 >> bitcast<u32>(10i)) & 31u);
                                            let _e2362 = (_e2355 & 1023u);
                                            if (_e2361 == 0u) {
                                                phi_7856_ = bitcast<f32>((_e2358 | bitcast<u32>((f32(_e2362) * 0.000000059604645f))));
                                            } else {
                                                if (_e2361 == 31u) {
                                                    phi_7833_ = 255u;
                                                    phi_7834_ = u32();
                                                    phi_7835_ = true;
                                                } else {
                                                    let _e2365 = (_e2361 + 112u);
                                                    phi_7833_ = _e2365;
                                                    phi_7834_ = _e2365;
                                                    phi_7835_ = (_e2365 == 255u);
                                                }
                                                let _e2368 = phi_7833_;
                                                let _e2370 = phi_7834_;
                                                let _e2372 = phi_7835_;
                                                if _e2372 {
                                                    phi_7844_ = (_e2362 == 0u);
                                                } else {
                                                    phi_7844_ = true;
                                                }
                                                let _e2375 = phi_7844_;
                                                phi_7856_ = bitcast<f32>((((_e2358 | (select(_e2368, select(_e2370, _e2368, _e2372), _e2375) << bitcast<u32>(23i))) | (_e2362 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2375)));
                                            }
                                            let _e2393 = phi_7856_;
                                            if _e2352 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2401 = ((_e2354 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2404 = ((_e2401 & 32768u) << bitcast<u32>(16i));
                                            let _e2407 = ((_e2401 >> bitcast<u32>(10i)) & 31u);
                                            let _e2408 = (_e2401 & 1023u);
                                            if (_e2407 == 0u) {
                                                phi_7932_ = bitcast<f32>((_e2404 | bitcast<u32>((f32(_e2408) * 0.000000059604645f))));
                                            } else {
                                                if (_e2407 == 31u) {
                                                    phi_7909_ = 255u;
                                                    phi_7910_ = u32();
                                                    phi_7911_ = true;
                                                } else {
                                                    let _e2411 = (_e2407 + 112u);
                                                    phi_7909_ = _e2411;
                                                    phi_7910_ = _e2411;
                                                    phi_7911_ = (_e2411 == 255u);
                                                }
                                                let _e2414 = phi_7909_;
                                                let _e2416 = phi_7910_;
                                                let _e2418 = phi_7911_;
                                                if _e2418 {
                                                    phi_7920_ = (_e2408 == 0u);
                                                } else {
                                                    phi_7920_ = true;
                                                }
                                                let _e2421 = phi_7920_;
                                                phi_7932_ = bitcast<f32>((((_e2404 | (select(_e2414, select(_e2416, _e2414, _e2418), _e2421) << bitcast<u32>(23i))) | (_e2408 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2421)));
                                            }
                                            let _e2439 = phi_7932_;
                                            let _e2446 = (_e2091 + _e2255);
                                            let _e2447 = (_e2446 < _e69);
                                            if _e2447 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2449 = c.member[_e2446];
                                            let _e2450 = (_e2449 & 65535u);
                                            let _e2453 = ((_e2450 & 32768u) << bitcast<u32>(16i));
                                            let _e2456 = ((_e2450 >> bitcast<u32>(10i)) & 31u);
                                            let _e2457 = (_e2450 & 1023u);
                                            if (_e2456 == 0u) {
                                                phi_8008_ = bitcast<f32>((_e2453 | bitcast<u32>((f32(_e2457) * 0.000000059604645f))));
                                            } else {
                                                if (_e2456 == 31u) {
                                                    phi_7985_ = 255u;
                                                    phi_7986_ = u32();
                                                    phi_7987_ = true;
                                                } else {
                                                    let _e2460 = (_e2456 + 112u);
                                                    phi_7985_ = _e2460;
                                                    phi_7986_ = _e2460;
                                                    phi_7987_ = (_e2460 == 255u);
                                                }
                                                let _e2463 = phi_7985_;
                                                let _e2465 = phi_7986_;
                                                let _e2467 = phi_7987_;
                                                if _e2467 {
                                                    phi_7996_ = (_e2457 == 0u);
                                                } else {
                                                    phi_7996_ = true;
                                                }
                                                let _e2470 = phi_7996_;
                                                phi_8008_ = bitcast<f32>((((_e2453 | (select(_e2463, select(_e2465, _e2463, _e2467), _e2470) << bitcast<u32>(23i))) | (_e2457 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2470)));
                                            }
                                            let _e2488 = phi_8008_;
                                            if _e2447 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2496 = ((_e2449 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2499 = ((_e2496 & 32768u) << bitcast<u32>(16i));
                                            let _e2502 = ((_e2496 >> bitcast<u32>(10i)) & 31u);
                                            let _e2503 = (_e2496 & 1023u);
                                            if (_e2502 == 0u) {
                                                phi_8084_ = bitcast<f32>((_e2499 | bitcast<u32>((f32(_e2503) * 0.000000059604645f))));
                                            } else {
                                                if (_e2502 == 31u) {
                                                    phi_8061_ = 255u;
                                                    phi_8062_ = u32();
                                                    phi_8063_ = true;
                                                } else {
                                                    let _e2506 = (_e2502 + 112u);
                                                    phi_8061_ = _e2506;
                                                    phi_8062_ = _e2506;
                                                    phi_8063_ = (_e2506 == 255u);
                                                }
                                                let _e2509 = phi_8061_;
                                                let _e2511 = phi_8062_;
                                                let _e2513 = phi_8063_;
                                                if _e2513 {
                                                    phi_8072_ = (_e2503 == 0u);
                                                } else {
                                                    phi_8072_ = true;
                                                }
                                                let _e2516 = phi_8072_;
                                                phi_8084_ = bitcast<f32>((((_e2499 | (select(_e2509, select(_e2511, _e2509, _e2513), _e2516) << bitcast<u32>(23i))) | (_e2503 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2516)));
                                            }
                                            let _e2534 = phi_8084_;
                                            let _e2540 = (_e2350 + _e2446);
                                            let _e2541 = (_e2540 < _e69);
                                            if _e2541 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2543 = c.member[_e2540];
                                            let _e2544 = (_e2543 & 65535u);
                                            let _e2547 = ((_e2544 & 32768u) << bitcast<u32>(16i));
                                            let _e2550 = ((_e2544 >> bitcast<u32>(10i)) & 31u);
                                            let _e2551 = (_e2544 & 1023u);
                                            if (_e2550 == 0u) {
                                                phi_8160_ = bitcast<f32>((_e2547 | bitcast<u32>((f32(_e2551) * 0.000000059604645f))));
                                            } else {
                                                if (_e2550 == 31u) {
                                                    phi_8137_ = 255u;
                                                    phi_8138_ = u32();
                                                    phi_8139_ = true;
                                                } else {
                                                    let _e2554 = (_e2550 + 112u);
                                                    phi_8137_ = _e2554;
                                                    phi_8138_ = _e2554;
                                                    phi_8139_ = (_e2554 == 255u);
                                                }
                                                let _e2557 = phi_8137_;
                                                let _e2559 = phi_8138_;
                                                let _e2561 = phi_8139_;
                                                if _e2561 {
                                                    phi_8148_ = (_e2551 == 0u);
                                                } else {
                                                    phi_8148_ = true;
                                                }
                                                let _e2564 = phi_8148_;
                                                phi_8160_ = bitcast<f32>((((_e2547 | (select(_e2557, select(_e2559, _e2557, _e2561), _e2564) << bitcast<u32>(23i))) | (_e2551 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2564)));
                                            }
                                            let _e2582 = phi_8160_;
                                            if _e2541 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2590 = ((_e2543 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2593 = ((_e2590 & 32768u) << bitcast<u32>(16i));
                                            let _e2596 = ((_e2590 >> bitcast<u32>(10i)) & 31u);
                                            let _e2597 = (_e2590 & 1023u);
                                            if (_e2596 == 0u) {
                                                phi_8236_ = bitcast<f32>((_e2593 | bitcast<u32>((f32(_e2597) * 0.000000059604645f))));
                                            } else {
                                                if (_e2596 == 31u) {
                                                    phi_8213_ = 255u;
                                                    phi_8214_ = u32();
                                                    phi_8215_ = true;
                                                } else {
                                                    let _e2600 = (_e2596 + 112u);
                                                    phi_8213_ = _e2600;
                                                    phi_8214_ = _e2600;
                                                    phi_8215_ = (_e2600 == 255u);
                                                }
                                                let _e2603 = phi_8213_;
                                                let _e2605 = phi_8214_;
                                                let _e2607 = phi_8215_;
                                                if _e2607 {
                                                    phi_8224_ = (_e2597 == 0u);
                                                } else {
                                                    phi_8224_ = true;
                                                }
                                                let _e2610 = phi_8224_;
                                                phi_8236_ = bitcast<f32>((((_e2593 | (select(_e2603, select(_e2605, _e2603, _e2607), _e2610) << bitcast<u32>(23i))) | (_e2597 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2610)));
                                            }
                                            let _e2628 = phi_8236_;
                                            let _e2636 = ((2u * _e2091) + _e2255);
                                            let _e2637 = (_e2636 < _e69);
                                            if _e2637 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2639 = c.member[_e2636];
                                            let _e2640 = (_e2639 & 65535u);
                                            let _e2643 = ((_e2640 & 32768u) << bitcast<u32>(16i));
                                            let _e2646 = ((_e2640 >> bitcast<u32>(10i)) & 31u);
                                            let _e2647 = (_e2640 & 1023u);
                                            if (_e2646 == 0u) {
                                                phi_8312_ = bitcast<f32>((_e2643 | bitcast<u32>((f32(_e2647) * 0.000000059604645f))));
                                            } else {
                                                if (_e2646 == 31u) {
                                                    phi_8289_ = 255u;
                                                    phi_8290_ = u32();
                                                    phi_8291_ = true;
                                                } else {
                                                    let _e2650 = (_e2646 + 112u);
                                                    phi_8289_ = _e2650;
                                                    phi_8290_ = _e2650;
                                                    phi_8291_ = (_e2650 == 255u);
                                                }
                                                let _e2653 = phi_8289_;
                                                let _e2655 = phi_8290_;
                                                let _e2657 = phi_8291_;
                                                if _e2657 {
                                                    phi_8300_ = (_e2647 == 0u);
                                                } else {
                                                    phi_8300_ = true;
                                                }
                                                let _e2660 = phi_8300_;
                                                phi_8312_ = bitcast<f32>((((_e2643 | (select(_e2653, select(_e2655, _e2653, _e2657), _e2660) << bitcast<u32>(23i))) | (_e2647 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2660)));
                                            }
                                            let _e2678 = phi_8312_;
                                            if _e2637 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2686 = ((_e2639 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2689 = ((_e2686 & 32768u) << bitcast<u32>(16i));
                                            let _e2692 = ((_e2686 >> bitcast<u32>(10i)) & 31u);
                                            let _e2693 = (_e2686 & 1023u);
                                            if (_e2692 == 0u) {
                                                phi_8388_ = bitcast<f32>((_e2689 | bitcast<u32>((f32(_e2693) * 0.000000059604645f))));
                                            } else {
                                                if (_e2692 == 31u) {
                                                    phi_8365_ = 255u;
                                                    phi_8366_ = u32();
                                                    phi_8367_ = true;
                                                } else {
                                                    let _e2696 = (_e2692 + 112u);
                                                    phi_8365_ = _e2696;
                                                    phi_8366_ = _e2696;
                                                    phi_8367_ = (_e2696 == 255u);
                                                }
                                                let _e2699 = phi_8365_;
                                                let _e2701 = phi_8366_;
                                                let _e2703 = phi_8367_;
                                                if _e2703 {
                                                    phi_8376_ = (_e2693 == 0u);
                                                } else {
                                                    phi_8376_ = true;
                                                }
                                                let _e2706 = phi_8376_;
                                                phi_8388_ = bitcast<f32>((((_e2689 | (select(_e2699, select(_e2701, _e2699, _e2703), _e2706) << bitcast<u32>(23i))) | (_e2693 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2706)));
                                            }
                                            let _e2724 = phi_8388_;
                                            let _e2730 = (_e2350 + _e2636);
                                            let _e2731 = (_e2730 < _e69);
                                            if _e2731 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2733 = c.member[_e2730];
                                            let _e2734 = (_e2733 & 65535u);
                                            let _e2737 = ((_e2734 & 32768u) << bitcast<u32>(16i));
                                            let _e2740 = ((_e2734 >> bitcast<u32>(10i)) & 31u);
                                            let _e2741 = (_e2734 & 1023u);
                                            if (_e2740 == 0u) {
                                                phi_8464_ = bitcast<f32>((_e2737 | bitcast<u32>((f32(_e2741) * 0.000000059604645f))));
                                            } else {
                                                if (_e2740 == 31u) {
                                                    phi_8441_ = 255u;
                                                    phi_8442_ = u32();
                                                    phi_8443_ = true;
                                                } else {
                                                    let _e2744 = (_e2740 + 112u);
                                                    phi_8441_ = _e2744;
                                                    phi_8442_ = _e2744;
                                                    phi_8443_ = (_e2744 == 255u);
                                                }
                                                let _e2747 = phi_8441_;
                                                let _e2749 = phi_8442_;
                                                let _e2751 = phi_8443_;
                                                if _e2751 {
                                                    phi_8452_ = (_e2741 == 0u);
                                                } else {
                                                    phi_8452_ = true;
                                                }
                                                let _e2754 = phi_8452_;
                                                phi_8464_ = bitcast<f32>((((_e2737 | (select(_e2747, select(_e2749, _e2747, _e2751), _e2754) << bitcast<u32>(23i))) | (_e2741 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2754)));
                                            }
                                            let _e2772 = phi_8464_;
                                            if _e2731 {
                                            } else {
                                                phi_14631_ = true;
                                                break;
                                            }
                                            let _e2780 = ((_e2733 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2783 = ((_e2780 & 32768u) << bitcast<u32>(16i));
                                            let _e2786 = ((_e2780 >> bitcast<u32>(10i)) & 31u);
                                            let _e2787 = (_e2780 & 1023u);
                                            if (_e2786 == 0u) {
                                                phi_8540_ = bitcast<f32>((_e2783 | bitcast<u32>((f32(_e2787) * 0.000000059604645f))));
                                            } else {
                                                if (_e2786 == 31u) {
                                                    phi_8517_ = 255u;
                                                    phi_8518_ = u32();
                                                    phi_8519_ = true;
                                                } else {
                                                    let _e2790 = (_e2786 + 112u);
                                                    phi_8517_ = _e2790;
                                                    phi_8518_ = _e2790;
                                                    phi_8519_ = (_e2790 == 255u);
                                                }
                                                let _e2793 = phi_8517_;
                                                let _e2795 = phi_8518_;
                                                let _e2797 = phi_8519_;
                                                if _e2797 {
                                                    phi_8528_ = (_e2787 == 0u);
                                                } else {
                                                    phi_8528_ = true;
                                                }
                                                let _e2800 = phi_8528_;
                                                phi_8540_ = bitcast<f32>((((_e2783 | (select(_e2793, select(_e2795, _e2793, _e2797), _e2800) << bitcast<u32>(23i))) | (_e2787 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2800)));
                                            }
                                            let _e2818 = phi_8540_;
                                            phi_8546_ = (_e2191 + _e2246);
                                            phi_8547_ = array<array<f32, 4>, 3>(array<f32, 4>((_e2193[0][0] + ((_e2298 * _e91) * _e2246)), (_e2193[0][1] + ((_e2344 * _e91) * _e2246)), (_e2193[0][2] + ((_e2393 * _e91) * _e2246)), (_e2193[0][3] + ((_e2439 * _e91) * _e2246))), array<f32, 4>((_e2193[1][0] + ((_e2488 * _e91) * _e2246)), (_e2193[1][1] + ((_e2534 * _e91) * _e2246)), (_e2193[1][2] + ((_e2582 * _e91) * _e2246)), (_e2193[1][3] + ((_e2628 * _e91) * _e2246))), array<f32, 4>((_e2193[2][0] + ((_e2678 * _e91) * _e2246)), (_e2193[2][1] + ((_e2724 * _e91) * _e2246)), (_e2193[2][2] + ((_e2772 * _e91) * _e2246)), (_e2193[2][3] + ((_e2818 * _e91) * _e2246))));
                                        } else {
                                            phi_8546_ = _e2191;
                                            phi_8547_ = _e2193;
                                        }
                                        let _e2827 = phi_8546_;
                                        let _e2829 = phi_8547_;
                                        phi_7525_ = _e2827;
                                        phi_7527_ = _e2829;
                                    } else {
                                        phi_7525_ = f32();
                                        phi_7527_ = array<array<f32, 4>, 3>();
                                    }
                                    let _e2831 = phi_7525_;
                                    let _e2833 = phi_7527_;
                                    continue;
                                    continuing {
                                        phi_7521_ = _e2206;
                                        phi_7524_ = _e2831;
                                        phi_7526_ = _e2833;
                                        phi_14631_ = _e1996;
                                        break if !(_e2212);
                                    }
                                }
                                let _e2836 = phi_14631_;
                                if _e2836 {
                                    break;
                                }
                                let _e2838 = local_28;
                                if (_e2838 > 0f) {
                                    let _e2841 = local_29;
                                    phi_8553_ = (1f / _e2841);
                                } else {
                                    phi_8553_ = 0f;
                                }
                                let _e2844 = phi_8553_;
                                let _e2846 = local_30;
                                let _e2851 = local_31;
                                let _e2856 = local_32;
                                let _e2861 = local_33;
                                let _e2866 = local_34;
                                let _e2871 = local_35;
                                let _e2876 = local_36;
                                let _e2881 = local_37;
                                let _e2886 = local_38;
                                let _e2891 = local_39;
                                let _e2896 = local_40;
                                let _e2901 = local_41;
                                let _e2906 = ((0.6666667f / _e2009.w) / _e2009.w);
                                let _e2908 = (_e85.member_2[2] * -1.0233268f);
                                let _e2911 = (_e85.member_2[0] * -1.0233268f);
                                let _e2914 = (_e85.member_2[1] * -1.0233268f);
                                let _e2916 = (((((_e2846[0][0] * _e2844) * 0.886227f) + ((_e2856[0][2] * _e2844) * _e2908)) + ((_e2861[0][3] * _e2844) * _e2911)) + ((_e2851[0][1] * _e2844) * _e2914));
                                let _e2925 = (((((_e2866[1][0] * _e2844) * 0.886227f) + ((_e2876[1][2] * _e2844) * _e2908)) + ((_e2881[1][3] * _e2844) * _e2911)) + ((_e2871[1][1] * _e2844) * _e2914));
                                let _e2934 = (((((_e2886[2][0] * _e2844) * 0.886227f) + ((_e2896[2][2] * _e2844) * _e2908)) + ((_e2901[2][3] * _e2844) * _e2911)) + ((_e2891[2][1] * _e2844) * _e2914));
                                phi_14959_ = _e2836;
                                phi_10691_ = vec4<f32>((_e2002.x + ((select(0f, _e2916, (_e2916 > 0f)) * _e2906) * _e2077)), (_e2002.y + ((select(0f, _e2925, (_e2925 > 0f)) * _e2906) * _e2077)), (_e2002.z + ((select(0f, _e2934, (_e2934 > 0f)) * _e2906) * _e2077)), (_e2002.w - _e2077));
                            }
                            let _e2949 = phi_14959_;
                            let _e2951 = phi_10691_;
                            phi_14958_ = _e2949;
                            phi_10692_ = _e2951;
                        }
                        let _e2953 = phi_14958_;
                        let _e2955 = phi_10692_;
                        phi_14957_ = _e2953;
                        phi_10693_ = _e2955;
                        phi_10694_ = _e2005;
                    }
                    let _e2957 = phi_14957_;
                    let _e2959 = phi_10693_;
                    let _e2961 = phi_10694_;
                    let _e2963 = select(_e2959, _e2002, vec4(_e2961));
                    if (3u >= _e94) {
                        phi_14207_ = vec4<f32>();
                        phi_14208_ = true;
                    } else {
                        let _e2966 = (_e2963.w <= 0f);
                        if _e2966 {
                            phi_14206_ = vec4<f32>();
                        } else {
                            let _e2970 = params.member.member[3u];
                            let _e2974 = params.member.member_1[3u];
                            let _e2978 = params.member.member_2[3u];
                            if (4u == _e94) {
                                phi_10754_ = 0f;
                            } else {
                                let _e2990 = params.member.member_5;
                                phi_10754_ = _e2990;
                            }
                            let _e2992 = phi_10754_;
                            let _e3000 = ((_e85.member[0] - _e2970.x) / _e2970.w);
                            let _e3001 = ((_e85.member[1] - _e2970.y) / _e2970.w);
                            let _e3002 = ((_e85.member[2] - _e2970.z) / _e2970.w);
                            let _e3009 = (_e3000 - f32(_e2974.x));
                            let _e3010 = (_e3001 - f32(_e2974.y));
                            let _e3011 = (_e3002 - f32(_e2974.z));
                            let _e3019 = select(_e3011, _e3010, (_e3010 < _e3011));
                            let _e3021 = select(_e3019, _e3009, (_e3009 < _e3019));
                            let _e3022 = (f32(_e2978.x) - _e3009);
                            let _e3023 = (f32(_e2978.y) - _e3010);
                            let _e3024 = (f32(_e2978.z) - _e3011);
                            let _e3026 = select(_e3024, _e3023, (_e3023 < _e3024));
                            let _e3028 = select(_e3026, _e3022, (_e3022 < _e3026));
                            let _e3033 = (select(_e3028, _e3021, (_e3021 < _e3028)) / select(0.001f, _e2992, (_e2992 > 0.001f)));
                            let _e3035 = select(0f, _e3033, (_e3033 > 0f));
                            let _e3038 = (_e2963.w * select(1f, _e3035, (_e3035 < 1f)));
                            if (_e3038 <= 0f) {
                                phi_14205_ = _e2963;
                            } else {
                                let _e3045 = params.member.member_6;
                                let _e3046 = (_e2978.x + 1u);
                                let _e3048 = ((_e2978.y + 1u) * _e3046);
                                let _e3049 = (_e3048 + _e3046);
                                let _e3052 = (_e3049 + ((_e2978.z + 1u) * _e3048));
                                let _e3059 = ((_e3000 + (_e85.member_2[0] * _e3045)) - 0.5f);
                                let _e3060 = floor(_e3059);
                                let _e3062 = (bitcast<i32>(_e2978.x) - 1i);
                                let _e3070 = (select(0i, select(select(i32(_e3060), i32(-2147483648), (_e3060 < -2147483600f)), 2147483647i, (_e3060 > 2147483500f)), (_e3060 == _e3060)) - _e2974.x);
                                let _e3072 = select(0i, _e3070, (0i < _e3070));
                                let _e3074 = select(_e3072, _e3062, (_e3062 < _e3072));
                                let _e3075 = (_e3070 + 1i);
                                let _e3077 = select(0i, _e3075, (0i < _e3075));
                                let _e3079 = select(_e3077, _e3062, (_e3062 < _e3077));
                                let _e3082 = (_e3059 - _e3060);
                                let _e3089 = ((_e3001 + (_e85.member_2[1] * _e3045)) - 0.5f);
                                let _e3090 = floor(_e3089);
                                let _e3092 = (bitcast<i32>(_e2978.y) - 1i);
                                let _e3100 = (select(0i, select(select(i32(_e3090), i32(-2147483648), (_e3090 < -2147483600f)), 2147483647i, (_e3090 > 2147483500f)), (_e3090 == _e3090)) - _e2974.y);
                                let _e3102 = select(0i, _e3100, (0i < _e3100));
                                let _e3104 = select(_e3102, _e3092, (_e3092 < _e3102));
                                let _e3105 = (_e3100 + 1i);
                                let _e3107 = select(0i, _e3105, (0i < _e3105));
                                let _e3109 = select(_e3107, _e3092, (_e3092 < _e3107));
                                let _e3112 = (_e3089 - _e3090);
                                let _e3119 = ((_e3002 + (_e85.member_2[2] * _e3045)) - 0.5f);
                                let _e3120 = floor(_e3119);
                                let _e3122 = (bitcast<i32>(_e2978.z) - 1i);
                                let _e3130 = (select(0i, select(select(i32(_e3120), i32(-2147483648), (_e3120 < -2147483600f)), 2147483647i, (_e3120 > 2147483500f)), (_e3120 == _e3120)) - _e2974.z);
                                let _e3132 = select(0i, _e3130, (0i < _e3130));
                                let _e3134 = select(_e3132, _e3122, (_e3122 < _e3132));
                                let _e3135 = (_e3130 + 1i);
                                let _e3137 = select(0i, _e3135, (0i < _e3135));
                                let _e3139 = select(_e3137, _e3122, (_e3122 < _e3137));
                                let _e3142 = (_e3119 - _e3120);
                                phi_11035_ = type_7(0u, 8u);
                                phi_11038_ = 0f;
                                phi_11040_ = array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                                loop {
                                    let _e3150 = phi_11035_;
                                    let _e3152 = phi_11038_;
                                    let _e3154 = phi_11040_;
                                    local_42 = _e3152;
                                    local_43 = _e3152;
                                    local_44 = _e3154;
                                    local_45 = _e3154;
                                    local_46 = _e3154;
                                    local_47 = _e3154;
                                    local_48 = _e3154;
                                    local_49 = _e3154;
                                    local_50 = _e3154;
                                    local_51 = _e3154;
                                    local_52 = _e3154;
                                    local_53 = _e3154;
                                    local_54 = _e3154;
                                    local_55 = _e3154;
                                    if (_e3150.member < _e3150.member_1) {
                                        phi_11036_ = type_7((_e3150.member + 1u), _e3150.member_1);
                                        phi_11063_ = type_7(1u, _e3150.member);
                                    } else {
                                        phi_11036_ = _e3150;
                                        phi_11063_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e3167 = phi_11036_;
                                    let _e3169 = phi_11063_;
                                    let _e3173 = (bitcast<i32>(_e3169.member) != 0i);
                                    if _e3173 {
                                        let _e3175 = ((_e3169.member_1 & 1u) == 1u);
                                        let _e3177 = ((_e3169.member_1 & 2u) == 2u);
                                        let _e3179 = ((_e3169.member_1 & 4u) == 4u);
                                        if _e3175 {
                                            phi_11093_ = _e3082;
                                        } else {
                                            phi_11093_ = (1f - _e3082);
                                        }
                                        let _e3185 = phi_11093_;
                                        if _e3177 {
                                            phi_11098_ = _e3112;
                                        } else {
                                            phi_11098_ = (1f - _e3112);
                                        }
                                        let _e3188 = phi_11098_;
                                        if _e3179 {
                                            phi_11104_ = _e3142;
                                        } else {
                                            phi_11104_ = (1f - _e3142);
                                        }
                                        let _e3192 = phi_11104_;
                                        let _e3202 = (((((select((f32((_e3074 + _e2974.x)) + 0.5f), (f32((_e3079 + _e2974.x)) + 0.5f), _e3175) - _e3000) * _e85.member_2[0]) + ((select((f32((_e3104 + _e2974.y)) + 0.5f), (f32((_e3109 + _e2974.y)) + 0.5f), _e3177) - _e3001) * _e85.member_2[1])) + ((select((f32((_e3134 + _e2974.z)) + 0.5f), (f32((_e3139 + _e2974.z)) + 0.5f), _e3179) - _e3002) * _e85.member_2[2])) * 2f);
                                        let _e3204 = select(0f, _e3202, (_e3202 > 0f));
                                        let _e3207 = (((_e3185 * _e3188) * _e3192) * select(1f, _e3204, (_e3204 < 1f)));
                                        if (_e3207 > 0f) {
                                            let _e3216 = (((_e3049 + select(bitcast<u32>(_e3074), bitcast<u32>(_e3079), _e3175)) + (select(bitcast<u32>(_e3104), bitcast<u32>(_e3109), _e3177) * _e3046)) + (select(bitcast<u32>(_e3134), bitcast<u32>(_e3139), _e3179) * _e3048));
                                            let _e3218 = (_e3216 < _e72);
                                            if _e3218 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3220 = d.member[_e3216];
                                            let _e3221 = (_e3220 & 65535u);
                                            let _e3224 = ((_e3221 & 32768u) << bitcast<u32>(16i));
                                            let _e3227 = ((_e3221 >> bitcast<u32>(10i)) & 31u);
                                            let _e3228 = (_e3221 & 1023u);
                                            if (_e3227 == 0u) {
                                                phi_11218_ = bitcast<f32>((_e3224 | bitcast<u32>((f32(_e3228) * 0.000000059604645f))));
                                            } else {
                                                if (_e3227 == 31u) {
                                                    phi_11195_ = 255u;
                                                    phi_11196_ = u32();
                                                    phi_11197_ = true;
                                                } else {
                                                    let _e3231 = (_e3227 + 112u);
                                                    phi_11195_ = _e3231;
                                                    phi_11196_ = _e3231;
                                                    phi_11197_ = (_e3231 == 255u);
                                                }
                                                let _e3234 = phi_11195_;
                                                let _e3236 = phi_11196_;
                                                let _e3238 = phi_11197_;
                                                if _e3238 {
                                                    phi_11206_ = (_e3228 == 0u);
                                                } else {
                                                    phi_11206_ = true;
                                                }
                                                let _e3241 = phi_11206_;
                                                phi_11218_ = bitcast<f32>((((_e3224 | (select(_e3234, select(_e3236, _e3234, _e3238), _e3241) << bitcast<u32>(23i))) | (_e3228 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3241)));
                                            }
                                            let _e3259 = phi_11218_;
                                            if _e3218 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3267 = ((_e3220 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3270 = ((_e3267 & 32768u) << bitcast<u32>(16i));
                                            let _e3273 = ((_e3267 >> bitcast<u32>(10i)) & 31u);
                                            let _e3274 = (_e3267 & 1023u);
                                            if (_e3273 == 0u) {
                                                phi_11294_ = bitcast<f32>((_e3270 | bitcast<u32>((f32(_e3274) * 0.000000059604645f))));
                                            } else {
                                                if (_e3273 == 31u) {
                                                    phi_11271_ = 255u;
                                                    phi_11272_ = u32();
                                                    phi_11273_ = true;
                                                } else {
                                                    let _e3277 = (_e3273 + 112u);
                                                    phi_11271_ = _e3277;
                                                    phi_11272_ = _e3277;
                                                    phi_11273_ = (_e3277 == 255u);
                                                }
                                                let _e3280 = phi_11271_;
                                                let _e3282 = phi_11272_;
                                                let _e3284 = phi_11273_;
                                                if _e3284 {
                                                    phi_11282_ = (_e3274 == 0u);
                                                } else {
                                                    phi_11282_ = true;
                                                }
                                                let _e3287 = phi_11282_;
                                                phi_11294_ = bitcast<f32>((((_e3270 | (select(_e3280, select(_e3282, _e3280, _e3284), _e3287) << bitcast<u32>(23i))) | (_e3274 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3287)));
                                            }
                                            let _e3305 = phi_11294_;
                                            let _e3311 = (3u * _e3052);
                                            let _e3312 = (_e3311 + _e3216);
                                            let _e3313 = (_e3312 < _e72);
                                            if _e3313 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3315 = d.member[_e3312];
                                            let _e3316 = (_e3315 & 65535u);
                                            let _e3319 = ((_e3316 & 32768u) << bitcast<u32>(16i));
                                            let _e3322 = ((_e3316 >> bitcast<u32>(10i)) & 31u);
                                            let _e3323 = (_e3316 & 1023u);
                                            if (_e3322 == 0u) {
                                                phi_11370_ = bitcast<f32>((_e3319 | bitcast<u32>((f32(_e3323) * 0.000000059604645f))));
                                            } else {
                                                if (_e3322 == 31u) {
                                                    phi_11347_ = 255u;
                                                    phi_11348_ = u32();
                                                    phi_11349_ = true;
                                                } else {
                                                    let _e3326 = (_e3322 + 112u);
                                                    phi_11347_ = _e3326;
                                                    phi_11348_ = _e3326;
                                                    phi_11349_ = (_e3326 == 255u);
                                                }
                                                let _e3329 = phi_11347_;
                                                let _e3331 = phi_11348_;
                                                let _e3333 = phi_11349_;
                                                if _e3333 {
                                                    phi_11358_ = (_e3323 == 0u);
                                                } else {
                                                    phi_11358_ = true;
                                                }
                                                let _e3336 = phi_11358_;
                                                phi_11370_ = bitcast<f32>((((_e3319 | (select(_e3329, select(_e3331, _e3329, _e3333), _e3336) << bitcast<u32>(23i))) | (_e3323 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3336)));
                                            }
                                            let _e3354 = phi_11370_;
                                            if _e3313 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3362 = ((_e3315 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3365 = ((_e3362 & 32768u) << bitcast<u32>(16i));
                                            let _e3368 = ((_e3362 >> bitcast<u32>(10i)) & 31u);
                                            let _e3369 = (_e3362 & 1023u);
                                            if (_e3368 == 0u) {
                                                phi_11446_ = bitcast<f32>((_e3365 | bitcast<u32>((f32(_e3369) * 0.000000059604645f))));
                                            } else {
                                                if (_e3368 == 31u) {
                                                    phi_11423_ = 255u;
                                                    phi_11424_ = u32();
                                                    phi_11425_ = true;
                                                } else {
                                                    let _e3372 = (_e3368 + 112u);
                                                    phi_11423_ = _e3372;
                                                    phi_11424_ = _e3372;
                                                    phi_11425_ = (_e3372 == 255u);
                                                }
                                                let _e3375 = phi_11423_;
                                                let _e3377 = phi_11424_;
                                                let _e3379 = phi_11425_;
                                                if _e3379 {
                                                    phi_11434_ = (_e3369 == 0u);
                                                } else {
                                                    phi_11434_ = true;
                                                }
                                                let _e3382 = phi_11434_;
                                                phi_11446_ = bitcast<f32>((((_e3365 | (select(_e3375, select(_e3377, _e3375, _e3379), _e3382) << bitcast<u32>(23i))) | (_e3369 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3382)));
                                            }
                                            let _e3400 = phi_11446_;
                                            let _e3407 = (_e3052 + _e3216);
                                            let _e3408 = (_e3407 < _e72);
                                            if _e3408 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3410 = d.member[_e3407];
                                            let _e3411 = (_e3410 & 65535u);
                                            let _e3414 = ((_e3411 & 32768u) << bitcast<u32>(16i));
                                            let _e3417 = ((_e3411 >> bitcast<u32>(10i)) & 31u);
                                            let _e3418 = (_e3411 & 1023u);
                                            if (_e3417 == 0u) {
                                                phi_11522_ = bitcast<f32>((_e3414 | bitcast<u32>((f32(_e3418) * 0.000000059604645f))));
                                            } else {
                                                if (_e3417 == 31u) {
                                                    phi_11499_ = 255u;
                                                    phi_11500_ = u32();
                                                    phi_11501_ = true;
                                                } else {
                                                    let _e3421 = (_e3417 + 112u);
                                                    phi_11499_ = _e3421;
                                                    phi_11500_ = _e3421;
                                                    phi_11501_ = (_e3421 == 255u);
                                                }
                                                let _e3424 = phi_11499_;
                                                let _e3426 = phi_11500_;
                                                let _e3428 = phi_11501_;
                                                if _e3428 {
                                                    phi_11510_ = (_e3418 == 0u);
                                                } else {
                                                    phi_11510_ = true;
                                                }
                                                let _e3431 = phi_11510_;
                                                phi_11522_ = bitcast<f32>((((_e3414 | (select(_e3424, select(_e3426, _e3424, _e3428), _e3431) << bitcast<u32>(23i))) | (_e3418 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3431)));
                                            }
                                            let _e3449 = phi_11522_;
                                            if _e3408 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3457 = ((_e3410 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3460 = ((_e3457 & 32768u) << bitcast<u32>(16i));
                                            let _e3463 = ((_e3457 >> bitcast<u32>(10i)) & 31u);
                                            let _e3464 = (_e3457 & 1023u);
                                            if (_e3463 == 0u) {
                                                phi_11598_ = bitcast<f32>((_e3460 | bitcast<u32>((f32(_e3464) * 0.000000059604645f))));
                                            } else {
                                                if (_e3463 == 31u) {
                                                    phi_11575_ = 255u;
                                                    phi_11576_ = u32();
                                                    phi_11577_ = true;
                                                } else {
                                                    let _e3467 = (_e3463 + 112u);
                                                    phi_11575_ = _e3467;
                                                    phi_11576_ = _e3467;
                                                    phi_11577_ = (_e3467 == 255u);
                                                }
                                                let _e3470 = phi_11575_;
                                                let _e3472 = phi_11576_;
                                                let _e3474 = phi_11577_;
                                                if _e3474 {
                                                    phi_11586_ = (_e3464 == 0u);
                                                } else {
                                                    phi_11586_ = true;
                                                }
                                                let _e3477 = phi_11586_;
                                                phi_11598_ = bitcast<f32>((((_e3460 | (select(_e3470, select(_e3472, _e3470, _e3474), _e3477) << bitcast<u32>(23i))) | (_e3464 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3477)));
                                            }
                                            let _e3495 = phi_11598_;
                                            let _e3501 = (_e3311 + _e3407);
                                            let _e3502 = (_e3501 < _e72);
                                            if _e3502 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3504 = d.member[_e3501];
                                            let _e3505 = (_e3504 & 65535u);
                                            let _e3508 = ((_e3505 & 32768u) << bitcast<u32>(16i));
                                            let _e3511 = ((_e3505 >> bitcast<u32>(10i)) & 31u);
                                            let _e3512 = (_e3505 & 1023u);
                                            if (_e3511 == 0u) {
                                                phi_11674_ = bitcast<f32>((_e3508 | bitcast<u32>((f32(_e3512) * 0.000000059604645f))));
                                            } else {
                                                if (_e3511 == 31u) {
                                                    phi_11651_ = 255u;
                                                    phi_11652_ = u32();
                                                    phi_11653_ = true;
                                                } else {
                                                    let _e3515 = (_e3511 + 112u);
                                                    phi_11651_ = _e3515;
                                                    phi_11652_ = _e3515;
                                                    phi_11653_ = (_e3515 == 255u);
                                                }
                                                let _e3518 = phi_11651_;
                                                let _e3520 = phi_11652_;
                                                let _e3522 = phi_11653_;
                                                if _e3522 {
                                                    phi_11662_ = (_e3512 == 0u);
                                                } else {
                                                    phi_11662_ = true;
                                                }
                                                let _e3525 = phi_11662_;
                                                phi_11674_ = bitcast<f32>((((_e3508 | (select(_e3518, select(_e3520, _e3518, _e3522), _e3525) << bitcast<u32>(23i))) | (_e3512 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3525)));
                                            }
                                            let _e3543 = phi_11674_;
                                            if _e3502 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3551 = ((_e3504 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3554 = ((_e3551 & 32768u) << bitcast<u32>(16i));
                                            let _e3557 = ((_e3551 >> bitcast<u32>(10i)) & 31u);
                                            let _e3558 = (_e3551 & 1023u);
                                            if (_e3557 == 0u) {
                                                phi_11750_ = bitcast<f32>((_e3554 | bitcast<u32>((f32(_e3558) * 0.000000059604645f))));
                                            } else {
                                                if (_e3557 == 31u) {
                                                    phi_11727_ = 255u;
                                                    phi_11728_ = u32();
                                                    phi_11729_ = true;
                                                } else {
                                                    let _e3561 = (_e3557 + 112u);
                                                    phi_11727_ = _e3561;
                                                    phi_11728_ = _e3561;
                                                    phi_11729_ = (_e3561 == 255u);
                                                }
                                                let _e3564 = phi_11727_;
                                                let _e3566 = phi_11728_;
                                                let _e3568 = phi_11729_;
                                                if _e3568 {
                                                    phi_11738_ = (_e3558 == 0u);
                                                } else {
                                                    phi_11738_ = true;
                                                }
                                                let _e3571 = phi_11738_;
                                                phi_11750_ = bitcast<f32>((((_e3554 | (select(_e3564, select(_e3566, _e3564, _e3568), _e3571) << bitcast<u32>(23i))) | (_e3558 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3571)));
                                            }
                                            let _e3589 = phi_11750_;
                                            let _e3597 = ((2u * _e3052) + _e3216);
                                            let _e3598 = (_e3597 < _e72);
                                            if _e3598 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3600 = d.member[_e3597];
                                            let _e3601 = (_e3600 & 65535u);
                                            let _e3604 = ((_e3601 & 32768u) << bitcast<u32>(16i));
                                            let _e3607 = ((_e3601 >> bitcast<u32>(10i)) & 31u);
                                            let _e3608 = (_e3601 & 1023u);
                                            if (_e3607 == 0u) {
                                                phi_11826_ = bitcast<f32>((_e3604 | bitcast<u32>((f32(_e3608) * 0.000000059604645f))));
                                            } else {
                                                if (_e3607 == 31u) {
                                                    phi_11803_ = 255u;
                                                    phi_11804_ = u32();
                                                    phi_11805_ = true;
                                                } else {
                                                    let _e3611 = (_e3607 + 112u);
                                                    phi_11803_ = _e3611;
                                                    phi_11804_ = _e3611;
                                                    phi_11805_ = (_e3611 == 255u);
                                                }
                                                let _e3614 = phi_11803_;
                                                let _e3616 = phi_11804_;
                                                let _e3618 = phi_11805_;
                                                if _e3618 {
                                                    phi_11814_ = (_e3608 == 0u);
                                                } else {
                                                    phi_11814_ = true;
                                                }
                                                let _e3621 = phi_11814_;
                                                phi_11826_ = bitcast<f32>((((_e3604 | (select(_e3614, select(_e3616, _e3614, _e3618), _e3621) << bitcast<u32>(23i))) | (_e3608 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3621)));
                                            }
                                            let _e3639 = phi_11826_;
                                            if _e3598 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3647 = ((_e3600 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3650 = ((_e3647 & 32768u) << bitcast<u32>(16i));
                                            let _e3653 = ((_e3647 >> bitcast<u32>(10i)) & 31u);
                                            let _e3654 = (_e3647 & 1023u);
                                            if (_e3653 == 0u) {
                                                phi_11902_ = bitcast<f32>((_e3650 | bitcast<u32>((f32(_e3654) * 0.000000059604645f))));
                                            } else {
                                                if (_e3653 == 31u) {
                                                    phi_11879_ = 255u;
                                                    phi_11880_ = u32();
                                                    phi_11881_ = true;
                                                } else {
                                                    let _e3657 = (_e3653 + 112u);
                                                    phi_11879_ = _e3657;
                                                    phi_11880_ = _e3657;
                                                    phi_11881_ = (_e3657 == 255u);
                                                }
                                                let _e3660 = phi_11879_;
                                                let _e3662 = phi_11880_;
                                                let _e3664 = phi_11881_;
                                                if _e3664 {
                                                    phi_11890_ = (_e3654 == 0u);
                                                } else {
                                                    phi_11890_ = true;
                                                }
                                                let _e3667 = phi_11890_;
                                                phi_11902_ = bitcast<f32>((((_e3650 | (select(_e3660, select(_e3662, _e3660, _e3664), _e3667) << bitcast<u32>(23i))) | (_e3654 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3667)));
                                            }
                                            let _e3685 = phi_11902_;
                                            let _e3691 = (_e3311 + _e3597);
                                            let _e3692 = (_e3691 < _e72);
                                            if _e3692 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3694 = d.member[_e3691];
                                            let _e3695 = (_e3694 & 65535u);
                                            let _e3698 = ((_e3695 & 32768u) << bitcast<u32>(16i));
                                            let _e3701 = ((_e3695 >> bitcast<u32>(10i)) & 31u);
                                            let _e3702 = (_e3695 & 1023u);
                                            if (_e3701 == 0u) {
                                                phi_11978_ = bitcast<f32>((_e3698 | bitcast<u32>((f32(_e3702) * 0.000000059604645f))));
                                            } else {
                                                if (_e3701 == 31u) {
                                                    phi_11955_ = 255u;
                                                    phi_11956_ = u32();
                                                    phi_11957_ = true;
                                                } else {
                                                    let _e3705 = (_e3701 + 112u);
                                                    phi_11955_ = _e3705;
                                                    phi_11956_ = _e3705;
                                                    phi_11957_ = (_e3705 == 255u);
                                                }
                                                let _e3708 = phi_11955_;
                                                let _e3710 = phi_11956_;
                                                let _e3712 = phi_11957_;
                                                if _e3712 {
                                                    phi_11966_ = (_e3702 == 0u);
                                                } else {
                                                    phi_11966_ = true;
                                                }
                                                let _e3715 = phi_11966_;
                                                phi_11978_ = bitcast<f32>((((_e3698 | (select(_e3708, select(_e3710, _e3708, _e3712), _e3715) << bitcast<u32>(23i))) | (_e3702 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3715)));
                                            }
                                            let _e3733 = phi_11978_;
                                            if _e3692 {
                                            } else {
                                                phi_14931_ = true;
                                                break;
                                            }
                                            let _e3741 = ((_e3694 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3744 = ((_e3741 & 32768u) << bitcast<u32>(16i));
                                            let _e3747 = ((_e3741 >> bitcast<u32>(10i)) & 31u);
                                            let _e3748 = (_e3741 & 1023u);
                                            if (_e3747 == 0u) {
                                                phi_12054_ = bitcast<f32>((_e3744 | bitcast<u32>((f32(_e3748) * 0.000000059604645f))));
                                            } else {
                                                if (_e3747 == 31u) {
                                                    phi_12031_ = 255u;
                                                    phi_12032_ = u32();
                                                    phi_12033_ = true;
                                                } else {
                                                    let _e3751 = (_e3747 + 112u);
                                                    phi_12031_ = _e3751;
                                                    phi_12032_ = _e3751;
                                                    phi_12033_ = (_e3751 == 255u);
                                                }
                                                let _e3754 = phi_12031_;
                                                let _e3756 = phi_12032_;
                                                let _e3758 = phi_12033_;
                                                if _e3758 {
                                                    phi_12042_ = (_e3748 == 0u);
                                                } else {
                                                    phi_12042_ = true;
                                                }
                                                let _e3761 = phi_12042_;
                                                phi_12054_ = bitcast<f32>((((_e3744 | (select(_e3754, select(_e3756, _e3754, _e3758), _e3761) << bitcast<u32>(23i))) | (_e3748 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3761)));
                                            }
                                            let _e3779 = phi_12054_;
                                            phi_12060_ = (_e3152 + _e3207);
                                            phi_12061_ = array<array<f32, 4>, 3>(array<f32, 4>((_e3154[0][0] + ((_e3259 * _e91) * _e3207)), (_e3154[0][1] + ((_e3305 * _e91) * _e3207)), (_e3154[0][2] + ((_e3354 * _e91) * _e3207)), (_e3154[0][3] + ((_e3400 * _e91) * _e3207))), array<f32, 4>((_e3154[1][0] + ((_e3449 * _e91) * _e3207)), (_e3154[1][1] + ((_e3495 * _e91) * _e3207)), (_e3154[1][2] + ((_e3543 * _e91) * _e3207)), (_e3154[1][3] + ((_e3589 * _e91) * _e3207))), array<f32, 4>((_e3154[2][0] + ((_e3639 * _e91) * _e3207)), (_e3154[2][1] + ((_e3685 * _e91) * _e3207)), (_e3154[2][2] + ((_e3733 * _e91) * _e3207)), (_e3154[2][3] + ((_e3779 * _e91) * _e3207))));
                                        } else {
                                            phi_12060_ = _e3152;
                                            phi_12061_ = _e3154;
                                        }
                                        let _e3788 = phi_12060_;
                                        let _e3790 = phi_12061_;
                                        phi_11039_ = _e3788;
                                        phi_11041_ = _e3790;
                                    } else {
                                        phi_11039_ = f32();
                                        phi_11041_ = array<array<f32, 4>, 3>();
                                    }
                                    let _e3792 = phi_11039_;
                                    let _e3794 = phi_11041_;
                                    continue;
                                    continuing {
                                        phi_11035_ = _e3167;
                                        phi_11038_ = _e3792;
                                        phi_11040_ = _e3794;
                                        phi_14931_ = _e2957;
                                        break if !(_e3173);
                                    }
                                }
                                let _e3797 = phi_14931_;
                                if _e3797 {
                                    break;
                                }
                                let _e3799 = local_42;
                                if (_e3799 > 0f) {
                                    let _e3802 = local_43;
                                    phi_12067_ = (1f / _e3802);
                                } else {
                                    phi_12067_ = 0f;
                                }
                                let _e3805 = phi_12067_;
                                let _e3807 = local_44;
                                let _e3812 = local_45;
                                let _e3817 = local_46;
                                let _e3822 = local_47;
                                let _e3827 = local_48;
                                let _e3832 = local_49;
                                let _e3837 = local_50;
                                let _e3842 = local_51;
                                let _e3847 = local_52;
                                let _e3852 = local_53;
                                let _e3857 = local_54;
                                let _e3862 = local_55;
                                let _e3867 = ((0.6666667f / _e2970.w) / _e2970.w);
                                let _e3869 = (_e85.member_2[2] * -1.0233268f);
                                let _e3872 = (_e85.member_2[0] * -1.0233268f);
                                let _e3875 = (_e85.member_2[1] * -1.0233268f);
                                let _e3877 = (((((_e3807[0][0] * _e3805) * 0.886227f) + ((_e3817[0][2] * _e3805) * _e3869)) + ((_e3822[0][3] * _e3805) * _e3872)) + ((_e3812[0][1] * _e3805) * _e3875));
                                let _e3886 = (((((_e3827[1][0] * _e3805) * 0.886227f) + ((_e3837[1][2] * _e3805) * _e3869)) + ((_e3842[1][3] * _e3805) * _e3872)) + ((_e3832[1][1] * _e3805) * _e3875));
                                let _e3895 = (((((_e3847[2][0] * _e3805) * 0.886227f) + ((_e3857[2][2] * _e3805) * _e3869)) + ((_e3862[2][3] * _e3805) * _e3872)) + ((_e3852[2][1] * _e3805) * _e3875));
                                phi_14205_ = vec4<f32>((_e2963.x + ((select(0f, _e3877, (_e3877 > 0f)) * _e3867) * _e3038)), (_e2963.y + ((select(0f, _e3886, (_e3886 > 0f)) * _e3867) * _e3038)), (_e2963.z + ((select(0f, _e3895, (_e3895 > 0f)) * _e3867) * _e3038)), f32());
                            }
                            let _e3909 = phi_14205_;
                            phi_14206_ = _e3909;
                        }
                        let _e3911 = phi_14206_;
                        phi_14207_ = _e3911;
                        phi_14208_ = _e2966;
                    }
                    let _e3913 = phi_14207_;
                    let _e3915 = phi_14208_;
                    let _e3917 = select(_e3913, _e2963, vec4(_e3915));
                    phi_14217_ = vec4<f32>(_e3917.x, _e3917.y, _e3917.z, 0f);
                }
                let _e3923 = phi_14217_;
                if _e81 {
                } else {
                    break;
                }
                irradiance.member[_e80] = _e3923;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn lpv_gather_half(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
